// The kernel of bounds_kernels.h. Its scalar form is conservative_bounds (conservative_shape.h).
#include "scene/bounds_kernels.h"

#include "foundation/simd.h"
#include "scene/conservative_shape.h"
#include "scene/scene_kernels.h"

namespace gphys::GPHYS_ISA {
namespace {

uint32_t rotated_aabbs(const float* const models[8], Box8& out) {
    const auto quads = [&](uint32_t from) { return load_quads([&](int i) { return models[i] + from; }); };
    const Quads8 a = quads(0), b = quads(4), c = quads(shape_at), d = quads(shape_at + 2);
    const Vec<Float8> position{a.x, a.y, a.z}, low{c.x, c.y, c.z}, high{d.y, d.z, d.w}, u{a.w, b.x, b.y};
    const Float8 minus = splat(-0.0f);  // -0 - x negates zeros, too
    const Mask8 centered =
        equal_bits(minus - low.x, high.x) & equal_bits(minus - low.y, high.y) & equal_bits(minus - low.z, high.z);
    const Mask8 unrotated = sum(abs(u)) <= splat(0);

    const Vec<Float8> half = (high - low) * splat(0.5f) * b.w;
    const Vec<Float8> extents = outer_extents(ScaledRotation<Vec<Float8>>(u, b.z), half);
    const Vec<Float8> low_corner = position - extents, high_corner = position + extents;
    const Vec<Float8> min = low_corner - corner_margin(low_corner);
    const Vec<Float8> max = high_corner + corner_margin(high_corner);
    store(out.row[0], min.x), store(out.row[1], min.y), store(out.row[2], min.z);
    store(out.row[3], max.x), store(out.row[4], max.y), store(out.row[5], max.z);
    return bits(centered) & ~bits(unrotated);
}

}  // namespace

extern const BoundsKernels bounds_kernels{rotated_aabbs};

}  // namespace gphys::GPHYS_ISA

#include "scene/bounds_kernels.h"

#include "foundation/simd.h"
#include "scene/quick_shape.h"
#include "scene/scene_kernels.h"

namespace gphys::GPHYS_ISA {

namespace {

uint32_t turned_aabbs(const float* const models[8], Box8& out) {
    const auto quads = [&](uint32_t from) { return load_quads([&](int i) { return models[i] + from; }); };
    const Quads8 a = quads(0), b = quads(4), c = quads(shape_at), d = quads(shape_at + 2);
    const Float8 zero = splat(0), two = splat(2);
    const Float8 position[3] = {a.x, a.y, a.z}, u[3] = {a.w, b.x, b.y}, w = b.z, scale = b.w;
    const Float8 low[3] = {c.x, c.y, c.z}, high[3] = {d.y, d.z, d.w};
    const Float8 minus = splat(-0.0f);  // which turns the sign of zeros, too
    const Mask8 centered =
        equal_bits(minus - low[0], high[0]) & equal_bits(minus - low[1], high[1]) & equal_bits(minus - low[2], high[2]);
    const Mask8 unturned = abs(u[0]) + abs(u[1]) + abs(u[2]) <= zero;

    // As ScaledTurn.
    const Float8 ww = w * w, uu = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    const Float8 unit = ww + uu, rest = ww - uu;
    Float8 half[3], products[3], turns[3];
    for (int k = 0; k < 3; ++k) {
        half[k] = (high[k] - low[k]) * splat(0.5f) * scale;
        products[k] = u[k] * u[(k + 1) % 3];
        turns[k] = w * u[(k + 2) % 3];
    }
    const Float8 rounding = splat(reach_slack) * (half[0] + half[1] + half[2]);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, previous = (k + 2) % 3;
        const Float8 turned = abs(rest + two * u[k] * u[k]) * half[k] +
                              two * (abs(products[k] - turns[k]) * half[next] +
                                     abs(products[previous] + turns[previous]) * half[previous]);
        const Float8 reach = turned / unit + rounding;
        const Float8 min = position[k] - reach, max = position[k] + reach;
        const Float8 ulp = splat(0x1p-23f), least = splat(0x1p-126f);
        store(out.row[k], min - (abs(min) * ulp + least));
        store(out.row[3 + k], max + (abs(max) * ulp + least));
    }
    return bits(centered) & ~bits(unturned);
}

}  // namespace

extern const BoundsKernels bounds_kernels{turned_aabbs};

}  // namespace gphys::GPHYS_ISA

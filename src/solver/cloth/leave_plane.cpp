// Finds flat sheets, and displaces their particles (leave_plane.h).
#include "solver/cloth/leave_plane.h"

#include "solver/cloth/cloth.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// A shortening that relaxation and the next substeps would not remove.
constexpr double least_shortening = 0.05;
// Of the average length of a link. The displacement changes lengths by at most its square, a thousandth; half of it was
// seen to be too little where the sheet is compressed within few frames.
constexpr double displacement = 0.03, flat = 1e-4;
// Most cloth is not flat, and this many particles show that.
constexpr uint32_t sample_size = 16;

Vec3 place(const ClothState& state, uint32_t particle) { return get(&state.at[4 * size_t{particle}]); }

/// The unit normal of the plane of all particles, or 0 if there is none or they are on a line.
Vec3 normal_of(const ClothState& state, double most) {
    const uint32_t count = state.particles, step = std::max(1u, count / sample_size);
    const Vec3 first = place(state, 0);
    Vec3 along, across;
    for (uint32_t p = 0; p < count; p += step) {
        const Vec3 other = place(state, p) - first;
        if (length_squared(other) > length_squared(along)) along = other;
    }
    for (uint32_t p = 0; p < count; p += step) {
        const Vec3 other = cross(along, place(state, p) - first);
        if (length_squared(other) > length_squared(across)) across = other;
    }
    if (across == Vec3{}) return {};
    const Vec3 normal = normalized(across);
    for (const uint32_t stride : {step, 1u}) {
        for (uint32_t p = 0; p < count; p += stride) {
            if (std::fabs(dot(normal, place(state, p) - first)) > most) return {};
        }
    }
    return normal;
}

/// Between -1 and 1, the same for a particle on every machine.
double scattered(uint32_t particle) {
    const uint32_t word = (particle + 1) * 0x9e3779b9u;
    return static_cast<double>(word ^ word >> 16) * 0x1p-31 - 1;
}

}  // namespace

void leave_plane(Cloth& cloth, double compressed) {
    if (compressed < least_shortening) return;
    ClothState& state = cloth.state;
    const double link = cloth.batches.link_length;
    const Vec3 normal = normal_of(state, flat * link);
    if (normal == Vec3{}) return;
    for (uint32_t p = 0; p < state.particles; ++p) {
        float* const at = &state.at[4 * size_t{p}];
        if (at[3] == 0) continue;
        put(at, get(at) + normal * (displacement * link * scattered(p)));
    }
}

}  // namespace gphys

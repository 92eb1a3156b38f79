// Drag and lift of the triangles of cloth (wind_kernels.h; the formula: gphys_solver_set_wind).
#include "solver/wind_kernels.h"

#include "foundation/compiler.h"
#include "foundation/simd.h"
#include "solver/triangle_drag.h"

namespace gphys::GPHYS_ISA {
namespace {

// m/s and metres: three times the speed of light, as in cloth_kernels.cpp, and a hundred thousand kilometres. Products
// of an area and two speeds are below 1e36 then.
constexpr float fastest = 1e9f, longest = 1e8f;
// A smaller square underflows. Such a triangle or speed has no direction, and no force.
constexpr float least_length = 1e-18f;

GPHYS_INLINE Float8 bounded(Float8 value, float limit) { return max(min(value, splat(limit)), splat(-limit)); }
GPHYS_INLINE Vec<Float8> edge(const Quads8& from, const Quads8& to) {
    return {bounded(to.x - from.x, longest), bounded(to.y - from.y, longest), bounded(to.z - from.z, longest)};
}

void find_relative(const AirOnCloth& air) {
    const Float8 before = splat(air.before), wind = load(air.wind), zero = splat(0);
    for (uint32_t i = 0; i < air.floats; i += 8) {
        const Float8 now = load(air.velocity + i), inverse_mass = last_of_quads(load(air.at + i));
        const Float8 free = now + (now - load(air.velocity_before + i)) * before;
        const Float8 velocity = choose(inverse_mass <= zero, now, free);
        const Float8 of_air = air.by_particle ? load(air.relative + i) : wind;
        store(air.relative + i, without_last_of_quads(bounded(velocity - of_air, fastest)));
    }
}

/// The force on each corner of eight triangles, and how much it grows.
GPHYS_INLINE Quads8 force_on_corner(const AirOnCloth& air, const uint32_t* const (&corners)[8]) {
    const auto quads = [&](const float* from, int corner) GPHYS_INLINE_LAMBDA {
        return load_quads([&](int i) GPHYS_INLINE_LAMBDA { return from + 4 * size_t{corners[i][corner]}; });
    };
    const Quads8 a = quads(air.at, 0), b = quads(air.at, 1), c = quads(air.at, 2);
    const Vec<Float8> twice = cross(edge(a, b), edge(a, c));  // twice the area, along the normal
    const Quads8 ua = quads(air.relative, 0), ub = quads(air.relative, 1), uc = quads(air.relative, 2);
    const Float8 third = splat(1.0f / 3);
    const Vec<Float8> u{(ua.x + ub.x + uc.x) * third, (ua.y + ub.y + uc.y) * third, (ua.z + ub.z + uc.z) * third};
    const TriangleDrag<Float8> all = triangle_drag(twice, u, splat(air.drag), splat(air.lift), splat(least_length));
    return {all.force.x, all.force.y, all.force.z, all.growth};
}

GPHYS_FLATTEN void add_forces(const AirOnCloth& air) {
    for (uint32_t i = 0; i < air.floats; i += 8) store(air.forces + i, splat(0));
    for (size_t first = 0; first < air.triangle_count; first += 8) {
        const size_t count = first + 8 <= air.triangle_count ? 8 : air.triangle_count - first;
        const uint32_t* corners[8];
        for (size_t i = 0; i < 8; ++i) corners[i] = air.triangles + 3 * (first + (i < count ? i : 0));
        float forces[32];
        store_quads([&](int i) GPHYS_INLINE_LAMBDA { return forces + 4 * i; }, force_on_corner(air, corners));
        for (size_t i = 0; i < count; ++i) {
            for (int corner = 0; corner < 3; ++corner) {
                float* const sum = air.forces + 4 * size_t{corners[i][corner]};
                for (size_t k = 0; k < 4; ++k) sum[k] += forces[4 * i + k];
            }
        }
    }
}

void accelerate(const AirOnCloth& air) {
    const Float8 unit = splat(air.unit), most_rate = splat(air.most_rate), zero = splat(0);
    for (uint32_t i = 0; i < air.floats; i += 8) {
        const Float8 force = load(air.forces + i), steady = load(air.steady + i);
        const Float8 inverse_mass = last_of_quads(load(air.at + i)), growth = last_of_quads(force);
        const Float8 by_unit = min(unit * inverse_mass, most_rate / max(growth, splat(least_length)));
        const Float8 blown = steady + without_last_of_quads(force) * without_last_of_quads(by_unit);
        store(air.acceleration + i, choose(inverse_mass <= zero, steady, blown));
    }
}

}  // namespace

const WindKernels wind_kernels = {find_relative, add_forces, accelerate};

}  // namespace gphys::GPHYS_ISA

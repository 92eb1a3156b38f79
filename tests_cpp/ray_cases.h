// Random and adversarial numbers for rays, and the watch over the floating-point exceptions that
// hosts may trap.
#pragma once

#include <cfenv>

#include "geometry/intersect.h"
#include "quad.h"
#include "test.h"

namespace test {

/// A number that fits the exact range of quad.h: a multiple of 2^-20.
inline double on_lattice(double v) { return std::nearbyint(v * 0x1p20) * 0x1p-20; }
inline gphys::Vec3 on_lattice(gphys::Vec3 v) { return {on_lattice(v.x), on_lattice(v.y), on_lattice(v.z)}; }

inline gphys::Vec3 random_point(Random& random, double extent) {
    return {random.uniform(-extent, extent), random.uniform(-extent, extent), random.uniform(-extent, extent)};
}
/// Whole numbers -extent..extent: corners, edges, planes and tangents are hit exactly and often.
inline gphys::Vec3 grid_point(Random& random, int extent) {
    const auto coordinate = [&] { return static_cast<double>(random.index(2 * extent + 1)) - extent; };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
}
inline gphys::Vec3 grid_direction(Random& random, int extent) {
    for (;;) {
        const gphys::Vec3 d = grid_point(random, extent);
        if (d != gphys::Vec3{}) return d;
    }
}
inline gphys::Vec3 as_floats(gphys::Vec3 v) { return gphys::widen(gphys::narrow(v)); }

/// Fails the test if anything in its lifetime divided by zero, overflowed or was invalid.
class NoTraps {
public:
    NoTraps() { std::feclearexcept(FE_ALL_EXCEPT); }
    ~NoTraps() { CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0); }
    NoTraps(const NoTraps&) = delete;
};

/// What must hold of every hit.
inline bool is_sound(const gphys::Hit& hit, const gphys::Ray& ray) {
    return hit.t >= 0 && hit.t <= ray.t_max && std::fabs(length(hit.normal) - 1) < 1e-12 &&
           dot(hit.normal, ray.direction) <= 1e-12 * length(ray.direction);
}

}  // namespace test

// The state that all bodies have: particles, one array per quantity (structure of arrays).
//
// All state is in double precision. The rounding of a position 1e5 m from the origin is then 1e-11 m, so more substeps
// never hurt and a body needs no origin of its own. Velocity is stored, not derived from old positions.
#pragma once

#include <optional>

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"
#include "shapes/shapes.h"

namespace gphys {

/// Crossing all coordinates in the shortest substep, 2e15 m in 1e-9 s, takes 2e24 m/s. Beyond this limit, squares of
/// speeds would soon overflow.
constexpr double fastest_particle = 1e30;

inline bool is_within(double limit, Vec3 value) {
    return std::fabs(value.x) <= limit && std::fabs(value.y) <= limit && std::fabs(value.z) <= limit;
}

/// A particle that leaves the range of coordinates stops at its border. So does one with NaN, which forces too large
/// for doubles cause.
inline void keep_in_range(Vec3& position, Vec3& velocity) {
    constexpr double limit = GPHYS_MAX_COORDINATE;
    if (!is_within(fastest_particle, velocity)) velocity = {};
    if (is_within(limit, position)) return;
    const auto kept = [](double x) { return x > -limit ? (x < limit ? x : limit) : -limit; };
    position = {kept(position.x), kept(position.y), kept(position.z)};
    velocity = {};
}
/// The same for a solved position. If it is NaN, the particle stays where it was before.
inline void keep_in_range(Vec3& position, Vec3& velocity, Vec3 before) {
    if (!is_within(std::numeric_limits<double>::max(), position)) position = before, velocity = {};
    keep_in_range(position, velocity);
}

/// The bounding box of some particles, and the largest of their speeds by axis.
struct Extent {
    Aabb box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    Vec3 fastest;

    void add(const Extent& other) {
        box = {min(box.min, other.box.min), max(box.max, other.box.max)};
        fastest = max(fastest, other.fastest);
    }
};

struct Particles {
    explicit Particles(std::pmr::memory_resource* memory)
        : position(memory), velocity(memory), force(memory), mass(memory), inverse_mass(memory), radius(memory) {}

    uint32_t size() const { return static_cast<uint32_t>(position.size()); }
    bool pinned(uint32_t particle) const { return inverse_mass[particle] == 0; }

    Vector<Vec3> position, velocity, force;
    Vector<double> mass;
    Vector<double> inverse_mass;  // 0: pinned or attached
    Vector<double> radius;
    double smallest_radius = 0, largest_radius = -1;  // < 0: unknown
    bool forced = false;                              // whether any force may be nonzero
    std::optional<Extent> extent;                     // if a step has computed it and nothing has changed since
};

}  // namespace gphys

// What all bodies have: particles, one array per quantity.
//
// All state is double precision: the rounding of a position 1e5 m from the origin is then 1e-11 m,
// so more substeps never hurt and a body needs no origin of its own. Velocity is stored, not
// derived from old positions.
#pragma once

#include <optional>

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

/// Crossing all coordinates in the shortest substep, 2e15 m in 1e-9 s, takes 2e24 m/s; beyond this, squares of speeds
/// would soon leave the doubles.
constexpr double fastest_particle = 1e30;

inline bool is_within(double limit, Vec3 value) {
    return std::fabs(value.x) <= limit && std::fabs(value.y) <= limit && std::fabs(value.z) <= limit;
}

/// A particle that leaves the range of coordinates stops at its border, and so does one that is no number any more:
/// then forces were too large for doubles.
inline void keep_in_range(Vec3& position, Vec3& velocity) {
    constexpr double limit = GPHYS_MAX_COORDINATE;
    if (!is_within(fastest_particle, velocity)) velocity = {};
    if (is_within(limit, position)) return;
    const auto kept = [](double x) { return x > -limit ? (x < limit ? x : limit) : -limit; };
    position = {kept(position.x), kept(position.y), kept(position.z)};
    velocity = {};
}
/// The same of what has been solved, which is known to have been somewhere else before: there it stays if it is no
/// number any more.
inline void keep_in_range(Vec3& position, Vec3& velocity, Vec3 before) {
    if (!is_within(std::numeric_limits<double>::max(), position)) position = before, velocity = {};
    keep_in_range(position, velocity);
}

/// What some particles are in, and the largest of their speeds by axis.
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
    double smallest_radius = 0, largest_radius = -1;  // < 0: not known
    bool forced = false;                              // whether a force may be other than 0
    std::optional<Extent> extent;                     // if a step has found it and nothing has changed since
};

}  // namespace gphys

// What moves as one and presses on lighter bodies: a particle, or a rigid cluster.
#pragma once

#include <cstdint>

#include "foundation/math.h"

namespace gphys {

/// The spin is the angular momentum: unit of mass * square metres a second.
struct LoadMotion {
    Vec3 velocity, spin;
};

/// For cloth, the unit of mass is the average of its particles, and positions are relative to its origin. For ropes it
/// is the kilogram, and the origin that of the scene.
struct LoadUnits {
    Vec3 origin;
    double mass;
};

struct HeavyBody {
    uint32_t of;  // the first particle of what moves as one, among the island's contacts
    double mass;
    Mat3 inverse_inertia;    // 0 for a particle
    Vec3 place;              // of its centre, when the contacts are solved
    LoadMotion motion;       // the same
    Vec3 acceleration;       // by gravity and forces
    uint32_t shares = 0;     // on all cloth
    uint32_t end = 0;        // its shares are those before this one and after those of the load before it
    bool carried = false;    // whether a model is under one of the particles that it presses on
    Vec3 moved{}, turned{};  // by the links: metres, and a rotation vector
    LoadMotion before{};     // the motion without them
    Vec3 pushed{};           // by contacts in this substep, in mass * metres
    double lost = 0;         // kinetic energy, to contacts in this substep; joules
    bool first = false;      // of all entries of a load that presses on several ropes
};

}  // namespace gphys

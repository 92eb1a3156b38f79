// The parts of a body. Each part has its own header, in the folder of its owner.
#pragma once

#include "solver/animation_targets.h"
#include "solver/cloth/cloth.h"
#include "solver/constraints.h"
#include "solver/contact/contacts.h"
#include "solver/history.h"
#include "solver/particles/flight_balls.h"
#include "solver/particles/particles.h"
#include "solver/plan.h"
#include "solver/rope/rope.h"
#include "solver/settings.h"
#include "solver/sleep.h"
#include "solver/steady.h"
#include "solver/substeps.h"
#include "solver/tearing/breaking.h"
#include "solver/time_scheme.h"
#include "solver/wind.h"

namespace gphys {

struct Body {
    explicit Body(std::pmr::memory_resource* source) : memory(source) {}

    std::pmr::memory_resource* memory;
    gphys_body_kind kind = GPHYS_BODY_PARTICLES;
    BodySettings settings;
    Particles particles{memory};
    FlightBalls flight{memory};  // of free particles
    Constraints constraints{memory};
    Plan plan{memory};
    History history{memory};
    Substeps substeps;
    Contacts contacts{memory};
    Rope rope{memory};
    Cloth cloth{memory};
    Air air{memory};
    AnimationTargets targets{memory};
    Breaking breaking{memory};
    Sleep sleep;
    Steady steady;
};

inline bool is_graph(const Body& body) { return body.plan.method == GPHYS_SOLVE_GRAPH; }

/// Unit direction. Coincident particles separate along a fixed axis; any direction will do.
inline Vec3 direction(Vec3 from, Vec3 to) {
    const Vec3 along = to - from;
    const double length = gphys::length(along);
    return length > 0 ? along / length : Vec3{1, 0, 0};
}
inline Vec3 link_direction(const Particles& particles, uint32_t a, uint32_t b) {
    return direction(particles.position[a], particles.position[b]);
}
/// The impulse of a rope's link, from a to b, on its particle a in a substep, newton seconds.
inline Vec3 link_impulse(const Body& body, uint32_t a, uint32_t b, uint32_t link, const TimeScheme& scheme) {
    return link_direction(body.particles, a, b) *
           (body.rope.tension[link] * scheme.h + body.rope.earlier_tension[link] * scheme.explicit_h);
}

/// Metres by which a constraint is too long or, below 0, too short. A maximum distance is never too short.
inline double excess(const Particles& particles, const DistanceConstraint& c) {
    const double stretch = distance(particles.position[c.a], particles.position[c.b]) - c.rest;
    return c.limit ? std::max(0.0, stretch) : stretch;
}

}  // namespace gphys

// The equations of the links of a chain in one of Newton's iterations (rope_direct.cpp).
#pragma once

#include "solver/body.h"
#include "solver/rope/rope_kernels.h"

namespace gphys {

/// The equation of a link in one iteration.
struct Link {
    Vec3 direction;        // unit
    double error = 0;      // metres, > 0: too long
    double stiffness = 0;  // k
    double softness = 1;   // r, 1/kg
    bool active = false;   // false between two pins, and if it only pulls and is slack

    /// K v
    Vec3 geometric(Vec3 v) const { return (v - direction * dot(direction, v)) * stiffness; }
};

/// The links of a chain in their present state.
struct ChainView {
    const Body& body;
    const Chain& chain;
    double inverse_step_squared;  // 1/s^2

    uint32_t particle(uint32_t i) const { return body.plan.particles[chain.first_particle + i]; }

    Link link(uint32_t i) const {
        const Plan& plan = body.plan;
        const uint32_t a = particle(i), b = particle(i + 1), index = chain.first_link + i;
        const double inverse_masses = body.particles.inverse_mass[a] + body.particles.inverse_mass[b];
        Link out;
        out.active = inverse_masses > 0;
        if (!out.active) return out;
        const Vec3 along = body.particles.position[b] - body.particles.position[a];
        const double length = gphys::length(along);
        // Coincident particles separate along a fixed axis. Any direction serves.
        out.direction = length > 0 ? along / length : Vec3{1, 0, 0};
        out.error = length - body.rope.target[index];
        if (plan.limit[index] && body.rope.tension[index] * inverse_masses + out.error <= 0) return Link{};
        out.softness = body.rope.damped_compliance[index] * inverse_step_squared + rope_regularisation * inverse_masses;
        // A link that is short at the moment must not become infinitely stiff sideways.
        const double scale = std::max({length, body.rope.target[index], rope_shortest});
        if (body.rope.tension[index] > 0) out.stiffness = body.rope.tension[index] / scale;
        return out;
    }
};

}  // namespace gphys

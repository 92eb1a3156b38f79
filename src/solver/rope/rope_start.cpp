// Finds ropes with wrong lengths, and keeps their velocities (rope_start.h).
#include "solver/rope/rope_start.h"

#include <algorithm>

#include "solver/body.h"
#include "solver/cloth/cloth_state.h"
#include "solver/rope/rope.h"

namespace gphys {
bool starts_misplaced(const Body& body) {
    const Plan& plan = body.plan;
    if (!restarts(body.history, body.contacts) || plan.damped || plan.limited || body.rope.bending.resists() ||
        !body.targets.empty() || !body.constraints.length_changes.empty() || are_carried(body.constraints))
        return false;
    bool wrong = false;
    each_link(plan, [&](uint32_t link, uint32_t a, uint32_t b) {
        const double error = distance(body.particles.position[a], body.particles.position[b]) - plan.rest[link];
        wrong = wrong || (std::fabs(error) > least_misplacement * plan.rest[link]);
    });
    return wrong && std::all_of(plan.compliance.begin(), plan.compliance.end(), [](double c) { return c == 0; });
}

void keep_velocities(Body& body, Vec3 gravity, double h) {
    Particles& particles = body.particles;
    for (uint32_t p = 0; p < particles.size(); ++p) {
        if (particles.pinned(p)) continue;
        const Vec3 falling = gravity + particles.force[p] * particles.inverse_mass[p];
        particles.velocity[p] = body.history.start_velocity[p] + falling * h;
    }
    body.history.earlier_step = 0;
}

}  // namespace gphys

// Finds ropes with wrong lengths, and bounds their energy (rope_start.h).
#include "solver/rope/rope_start.h"

#include <algorithm>

#include "solver/body.h"
#include "solver/cloth/cloth_state.h"
#include "solver/rope/rope.h"

namespace gphys {
namespace {

// Of a link's length. Rounded to float32, links of a centimetre have as much a hundred metres from the origin.
constexpr double least_strain = 1e-3;

}  // namespace

bool starts_misplaced(const Body& body) {
    const Plan& plan = body.plan;
    if (!restarts(body.history, body.contacts) || plan.damped || plan.limited || body.rope.bending.resists() ||
        !body.targets.empty() || !body.constraints.length_changes.empty() || are_carried(body.constraints))
        return false;
    bool wrong = false;
    each_link(plan, [&](uint32_t link, uint32_t a, uint32_t b) {
        const double error = distance(body.particles.position[a], body.particles.position[b]) - plan.rest[link];
        wrong = wrong || (std::fabs(error) > least_strain * plan.rest[link]);
    });
    return wrong && std::all_of(plan.compliance.begin(), plan.compliance.end(), [](double c) { return c == 0; });
}

void bound_starting_energy(Body& body, Vec3 gravity) {
    Particles& particles = body.particles;
    const History& history = body.history;
    const auto each_free = [&](auto&& visit) {
        for (uint32_t p = 0; p < particles.size(); ++p) {
            if (!particles.pinned(p)) visit(p, particles.mass[p]);
        }
    };
    Motion whole;
    double gain = 0;
    uint32_t free = 0;
    each_free([&](uint32_t p, double mass) {
        const Vec3 now = particles.velocity[p], before = history.start_velocity[p];
        const Vec3 falling = gravity + particles.force[p] * particles.inverse_mass[p];
        gain += mass * (dot(now - before, now + before) / 2 - dot(falling, particles.position[p] - history.start[p]));
        whole.add(mass, now);
        ++free;
    });
    if (!(gain > 0)) return;
    const Vec3 drift = free < particles.size() ? Vec3{} : whole.momentum / whole.mass;
    double kinetic = 0;
    each_free([&](uint32_t p, double mass) { kinetic += mass * length_squared(particles.velocity[p] - drift) / 2; });
    const double kept = gain < kinetic ? std::sqrt(1 - gain / kinetic) : 0;
    each_free([&](uint32_t p, double) { particles.velocity[p] = drift + (particles.velocity[p] - drift) * kept; });
    body.history.earlier_step = 0;
}

}  // namespace gphys

// Energy balance of joined bodies with cloth. The error that sweeps over cloth leave unsolved does work on all bodies
// joined to it in long substeps. Energy that the bodies have lost earlier may come back, as it does in every swing. If
// they gain more than that, their motion is slowed; if nothing holds them, only their motion relative to their common
// drift. So their energy never exceeds what it was.
#include "solver/joints/joined_motion.h"
#include "solver/motion.h"

namespace gphys {
namespace {

/// Whether nothing outside can have done work, and contacts have not changed the quantities that gain_of reads.
bool is_closed(const Body& body) {
    return is_graph(body) ? body.cloth.balance.closed
                          : body.constraints.attachments.empty() && body.constraints.length_changes.empty() &&
                                !body.contacts.has_contact && !body.contacts.near && !body.plan.damped;
}

/// Joules gained beyond the work of forces.
double gain_of(const Body& body, Vec3 gravity) {
    if (is_graph(body)) return body.cloth.balance.gain;
    double gain = 0;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        const Vec3 now = body.particles.velocity[p], before = body.history.start_velocity[p];
        const Vec3 falling = gravity + body.particles.force[p] * body.particles.inverse_mass[p];
        gain += body.particles.mass[p] * (dot(now - before, now + before) / 2 -
                                          dot(falling, body.particles.position[p] - body.history.start[p]));
    }
    return gain;
}

bool is_held(const Body& body) {
    return std::find(body.particles.inverse_mass.begin(), body.particles.inverse_mass.end(), 0.0) !=
           body.particles.inverse_mass.end();
}

Motion motion_of(const Body& body) {
    if (is_graph(body)) return motion_of_cloth(body.cloth.state);
    Motion sum;
    for (uint32_t p = 0; p < body.particles.size(); ++p) sum.add(body.particles.mass[p], body.particles.velocity[p]);
    return sum;
}

double inner_energy(Body& body, Vec3 drift) {
    if (is_graph(body)) return inner_energy_of_cloth(body.cloth.state, body.cloth.shares, drift);
    double energy = 0;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (!body.particles.pinned(p))
            energy += body.particles.mass[p] * length_squared(body.particles.velocity[p] - drift) / 2;
    }
    return energy;
}

void slow(Body& body, Vec3 drift, double kept) {
    if (is_graph(body)) return slow_cloth(body.cloth.state, body.cloth.shares.team, drift, kept);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (!body.particles.pinned(p)) body.particles.velocity[p] = drift + (body.particles.velocity[p] - drift) * kept;
    }
}

}  // namespace

void keep_joined_energy(const Joined& joined, Vec3 gravity) {
    bool cloth = false, closed = true, held = false;
    double gain = 0;
    each_body(joined, [&](const Body& body, uint32_t) {
        cloth = cloth || is_graph(body);
        closed = closed && is_closed(body);
        held = held || is_held(body);
    });
    if (!cloth || !closed) return;
    each_body(joined, [&](const Body& body, uint32_t) { gain += gain_of(body, gravity); });
    for (const uint32_t* i = joined.systems_begin; i != joined.systems_end; ++i) {
        gain += joined.all_systems[*i].stored() - joined.all_systems[*i].stored_before();
    }
    double lost = -gain;
    Body* first = nullptr;
    each_body(joined, [&](Body& body, uint32_t) {
        if (!is_graph(body)) return;
        if (!first) first = &body;
        lost += std::exchange(body.cloth.balance.lost, 0.0);
    });
    first->cloth.balance.lost = std::max(lost, 0.0);
    if (lost >= 0) return;
    Motion whole;
    if (!held) each_body(joined, [&](const Body& body, uint32_t) { whole.add(motion_of(body)); });
    const Vec3 drift = held ? Vec3{} : whole.momentum / whole.mass;
    double inner = 0;
    each_body(joined, [&](Body& body, uint32_t) { inner += inner_energy(body, drift); });
    const double kept = -lost < inner ? std::sqrt(1 + lost / inner) : 0;
    each_body(joined, [&](Body& body, uint32_t) { slow(body, drift, kept); });
}

}  // namespace gphys

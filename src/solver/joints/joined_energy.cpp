// The energy balance of joined bodies with cloth. In long substeps, the error that sweeps over cloth leave does work on
// all bodies that are joined to it. Energy that the bodies have lost earlier may come back, as it does in every swing.
// If they gain more than that, all their velocities are scaled; if no particle is pinned, only the velocities relative
// to their common drift. So their energy never exceeds what it was.
#include "solver/joints/joined_motion.h"
#include "solver/motion.h"
#include "solver/rope/rope_start.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

/// Whether nothing outside can have done work, and contacts have not changed the quantities that energy_gain reads.
bool is_closed(const Body& body) {
    return is_graph(body) ? body.cloth.balance.closed
                          : body.constraints.attachments.empty() && body.constraints.length_changes.empty() &&
                                !body.contacts.has_contact && !body.contacts.near && !body.plan.damped;
}

/// Joules gained beyond the work of forces.
double energy_gain(const Body& body, Vec3 gravity) {
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

Motion motion_of(const Body& body) {
    if (is_graph(body)) return motion_of_cloth(body.cloth.state);
    Motion sum;
    for (uint32_t p = 0; p < body.particles.size(); ++p) sum.add(body.particles.mass[p], body.particles.velocity[p]);
    return sum;
}

/// Joules, of the motion relative to the drift.
double kinetic_energy(Body& body, Vec3 drift) {
    if (is_graph(body)) return inner_energy_of_cloth(body.cloth.state, body.cloth.shares, drift);
    double energy = 0;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (!body.particles.pinned(p))
            energy += body.particles.mass[p] * length_squared(body.particles.velocity[p] - drift) / 2;
    }
    return energy;
}

void scale_velocities(Body& body, Vec3 drift, double factor) {
    if (is_graph(body)) return slow_cloth(body.cloth.state, body.cloth.shares.team, drift, factor);
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (!body.particles.pinned(p))
            body.particles.velocity[p] = drift + (body.particles.velocity[p] - drift) * factor;
    }
}

}  // namespace

bool has_pin(const Particles& particles) {
    return std::find(particles.inverse_mass.begin(), particles.inverse_mass.end(), 0.0) != particles.inverse_mass.end();
}

void bound_starting_energy(const Joined& joined, Vec3 gravity, double h) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    bool pinned = false;
    double gain = 0, kinetic = 0;
    Motion whole;
    each_body(joined, [&](Body& body, uint32_t) {
        pinned = pinned || has_pin(body.particles);
        whole.add(motion_of(body));
        if (!is_graph(body)) {
            gain += energy_gain(body, gravity);
            return;
        }
        ClothState& state = body.cloth.state;
        gain += state.average_mass *
                sum_of_blocks(state, body.cloth.shares, [&](const ClothMotion& block) { return kernels.gain(block); });
    });
    if (!(gain > 0)) return;
    const Vec3 drift = pinned ? Vec3{} : whole.momentum / whole.mass;
    each_body(joined, [&](Body& body, uint32_t) { kinetic += kinetic_energy(body, drift); });
    // If the bodies have got most of it by their displacement, what they had before is hidden in it.
    const bool displaced = gain > kinetic / 2;
    each_body(joined, [&](Body& body, uint32_t) {
        if (!displaced) {
            scale_velocities(body, drift, std::sqrt(1 - gain / kinetic));
        } else if (is_graph(body)) {
            keep_velocities(body.cloth.state, h);
        } else {
            keep_velocities(body, gravity, h);
        }
        body.history.earlier_step = 0;
    });
}

void limit_joined_energy(const Joined& joined, Vec3 gravity) {
    bool cloth = false, closed = true, pinned = false;
    double gain = 0;
    each_body(joined, [&](const Body& body, uint32_t) {
        cloth = cloth || is_graph(body);
        closed = closed && is_closed(body);
        pinned = pinned || has_pin(body.particles);
    });
    if (!cloth || !closed) return;
    each_body(joined, [&](const Body& body, uint32_t) { gain += energy_gain(body, gravity); });
    for (const uint32_t* i = joined.systems_begin; i != joined.systems_end; ++i) {
        gain += joined.all_systems[*i].elastic_energy() - joined.all_systems[*i].elastic_energy_before();
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
    if (!pinned) each_body(joined, [&](const Body& body, uint32_t) { whole.add(motion_of(body)); });
    const Vec3 drift = pinned ? Vec3{} : whole.momentum / whole.mass;
    double kinetic = 0;
    each_body(joined, [&](Body& body, uint32_t) { kinetic += kinetic_energy(body, drift); });
    const double factor = -lost < kinetic ? std::sqrt(1 + lost / kinetic) : 0;
    each_body(joined, [&](Body& body, uint32_t) { scale_velocities(body, drift, factor); });
}

namespace {

/// Joules, of chains and particles.
template <class Velocity>
double energy_of_particles(const Body& body, Vec3 gravity, const Vector<Vec3>& places, Velocity&& velocity) {
    double energy = 0;
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p)) continue;
        const Vec3 falling = gravity + body.particles.force[p] * body.particles.inverse_mass[p];
        energy += body.particles.mass[p] * (length_squared(velocity(p)) / 2 - dot(falling, places[p]));
    }
    return energy;
}

}  // namespace

void note_joined_energy(const Joined& joined, Vec3 gravity, double h) {
    each_body(joined, [&](Body& body, uint32_t) {
        if (is_graph(body)) {
            if (!body.cloth.loads.any()) note_energy(body.cloth, h);
            return;
        }
        const TimeScheme scheme(h, body.history.earlier_step);
        body.rope.loads.energy = energy_of_particles(body, gravity, body.history.predicted, [&](uint32_t p) {
            const Vec3 before =
                scheme.from_history(body.history.start[p], body.history.earlier[p], body.history.start_velocity[p]);
            return (body.history.predicted[p] * scheme.next - before) / scheme.h;
        });
    });
}

double slow_joined(const Joined& joined, Vec3 gravity) {
    bool loaded = false, known = true, held = false;
    each_body(joined, [&](const Body& body, uint32_t) {
        loaded = loaded || body.cloth.loads.any();
        held = held || has_pin(body.particles) || !body.contacts.impulses.empty();
        known = known && (is_graph(body) ? is_energy_known(body)
                                         : body.constraints.attachments.empty() &&
                                               body.constraints.length_changes.empty() && !body.plan.damped);
    });
    // Pins or models must take the momentum.
    if (!loaded || !known || !held) return 1;
    double gain = 0, kinetic = 0;
    each_body(joined, [&](Body& body, uint32_t) {
        kinetic += kinetic_energy(body, {});
        if (!is_graph(body)) {
            gain += energy_of_particles(body, gravity, body.particles.position,
                                        [&](uint32_t p) { return body.particles.velocity[p]; }) -
                    body.rope.loads.energy;
            return;
        }
        const ContactLoads& loads = body.cloth.loads;
        gain += (energy_after_links(body.cloth) - loads.energy) * body.cloth.state.average_mass;
        for (const HeavyBody& heavy : loads.heavy)
            kinetic += heavy.mass * body.cloth.state.average_mass * length_squared(heavy.motion.velocity) / 2;
    });
    for (const uint32_t* i = joined.systems_begin; i != joined.systems_end; ++i) {
        gain += joined.all_systems[*i].elastic_energy() - joined.all_systems[*i].elastic_energy_before();
    }
    if (!(gain > 0)) return 1;
    const double kept = gain < kinetic ? std::sqrt(1 - gain / kinetic) : 0;
    each_body(joined, [&](Body& body, uint32_t) { scale_velocities(body, {}, kept); });
    return kept;
}

}  // namespace gphys

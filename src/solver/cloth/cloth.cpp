// Cloth and other graphs: chains of constraints, each solved directly, one colour after the other (block Gauss-Seidel
// with graph colouring). Within a chain the corrections of all links are found together by elimination of their
// tridiagonal system (Thomas's algorithm). So tension crosses the cloth in one sweep, where single constraints would
// need as many sweeps as there are links. There is one pass per substep, always in the same order, because alternating
// between forward and backward was seen to add energy. Around particles with many links one pass adds energy, too, so
// there each substep goes there and back (hubs.cpp).
//
// A substep reads: predict, contact planes, chains and limits, velocities, contacts, relaxation, energy.
#include "solver/cloth/cloth_attachments.h"
#include "solver/cloth/cloth_chains.h"
#include "solver/cloth/cloth_targets.h"
#include "solver/cloth/hinged_clusters.h"
#include "solver/cloth/leave_plane.h"
#include "solver/cloth/whole_motion.h"
#include "solver/contact/collision.h"
#include "solver/contact/leave_solids.h"

namespace gphys {
namespace {

ClothStep cloth_step(double h, double earlier_step, double damping) {
    const TimeScheme scheme(h, earlier_step);
    const auto narrowed = [](double value) { return static_cast<float>(value); };
    const double h_before = scheme.earlier > 0 ? earlier_step : 0;
    return {narrowed(h),
            narrowed(h_before),
            narrowed(h_before / h),
            narrowed(scheme.next),
            narrowed(scheme.earlier),
            narrowed(damping),
            narrowed(scheme.drag(damping))};
}

/// Whether only models and pins can have got what its momentum lacks at the end of a substep. Sweeps of particles that
/// move fast give impulses of their own, so without attachments only of cloth that settles.
bool gives_all_momentum_to_models(const Body& body, const CollisionContext& around) {
    const Cloth& cloth = body.cloth;
    const bool lies = cloth.settling.acts() && cloth.state.held.empty() && cloth.contacts.any_active();
    return around.scene && (lies || !body.constraints.attachments.empty()) && !body.plan.joined &&
           !body.contacts.near && body.targets.empty() && !cloth.loads.any() &&
           !(cloth.contacts.penetrating && collides(body, around));
}

}  // namespace

void reserve_cloth(Body& body, bool collides) {
    Cloth& cloth = body.cloth;
    const uint32_t particles = body.particles.size();
    const size_t floats = cloth_floats(particles, cloth.batches.spare);
    reserve_state(cloth.state, floats);
    cloth.shares.reserve(particles, floats, cloth.batches.chains.size());
    if (cloth.relaxation.most_strain > 0) cloth.relaxation.reserve(cloth.batches.rest.size());
    if (!body.constraints.attachments.empty()) cloth.in_chains.pulls.resize(floats);
    const bool may_be_loaded = body.settings.body_layers != 0;
    if (!body.targets.empty() || body.plan.joined || may_be_loaded || collides) cloth.in_chains.reserve(floats);
    if (body.plan.joined || may_be_loaded) cloth.tethers.reserve(floats);
    if (may_be_loaded) reserve_loads(cloth.loads, particles, floats);
    if (cloth.volume.held) cloth.volume.gradient.resize(particles);
    if (!cloth.clusters.empty()) reserve_clusters(cloth.clusters, particles);
    if (!collides) return;
    cloth.contacts.reserve(particles, floats);
    cloth.cache.search_balls.reserve(4 * size_t{particles});
}

void begin_cloth(Body& body, const CollisionContext& around, Vec3 gravity) {
    Cloth& cloth = body.cloth;
    const ClothExtent extent = extent_of(body.particles, cloth.shares);
    if (!keeps_origin(cloth.cache, cloth.state.origin, extent.box)) {
        cloth.state.origin = (extent.box.min + extent.box.max) / 2;
        cloth.cache.search_balls.clear();
    }
    cloth.state.average_mass = extent.mass / body.particles.size();
    cloth.relaxation.begin_step();
    cloth.balance.current = cloth.yielding.current = false;
    load_state(cloth.state, body.particles, cloth.batches.spare, gravity, cloth.shares.team);
    cloth.misplaced = body.history.placed && start_cloth(body);
    cloth.contacts.active.clear();
    if (collides(body, around)) {
        search_cloth_contacts(body, around, gravity);
    } else {
        cloth.cache.search_balls.clear();
        std::fill(cloth.in_chains.normals.begin(), cloth.in_chains.normals.end(), 0.0f);
    }
    if (body.plan.joined) cloth.tethers.clear();
    begin_settling(body, around, gravity);
}

void predict_cloth(Body& body, const CollisionContext& around, double h) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    Cloth& cloth = body.cloth;
    const TimeScheme scheme(h, body.history.earlier_step);
    if (!body.constraints.length_changes.empty()) change_lengths(body, around.end);
    soften_links(cloth.batches, cloth.state.average_mass, scheme.step(body.settings.damping));
    find_yielding_chords(cloth, body.plan.joined, collides(body, around) && !cloth.contacts.candidates.empty(),
                         around.step_time);
    // Moving models, other bodies and links that change their lengths do work.
    const bool no_changes = body.constraints.length_changes.empty() && !body.targets.moves;
    const bool carried = are_carried(body.constraints), closed = no_changes && !carried;
    cloth.loads.pins_move = carried && !body.plan.joined;
    cloth.loads.closed = closed || (no_changes && cloth.loads.pins_move);
    if (closed && !cloth.balance.current) cloth.balance.stored = stored_energy(cloth);
    cloth.balance.closed = closed;
    if (body.air.blows()) blow_cloth(body, around, h);
    const ClothStep step = cloth_step(h, body.history.earlier_step, body.settings.damping);
    share_motion(cloth.state, cloth.shares.team,
                 [&](const ClothMotion& motion, uint32_t) { kernels.predict(motion, step); });
    damp_links(cloth.batches, cloth.state, scheme);
    follow_models(body.constraints, around, cloth.state, cloth.in_chains);
    aim_targets(body, around);
    carry_by_targets(body.targets, cloth.state);
    stretch_taut_spans(cloth);
}

int least_sweeps_of(const Body& body) { return body.plan.crowded ? 2 : 1; }

void sweep_links(Body& body, int first, int end) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    Cloth& cloth = body.cloth;
    ChainContacts& in_chains = cloth.in_chains;
    const bool loaded = cloth.loads.any();
    const bool has_contact = cloth.contacts.any_active() || !body.targets.pressing.empty();
    const int least_sweeps = least_sweeps_of(body);
    for (int sweep = first; sweep < end; ++sweep) {
        // The sides of cells come last, and have no error left.
        const bool backward = least_sweeps == 2 && sweep == 0;
        const auto solve = [&](const ChainBatch& batch, ClothChains chains, float* rows) {
            // The force of an elastic link acts once.
            if (sweep >= least_sweeps && batch.elastic) return;
            if (sweep == 1 && batch.elastic) chains.rest = cloth.batches.continued.data();
            float* const at = cloth.state.at.data();
            const ClothSurfaces surfaces{in_chains.normals.data(), in_chains.pulls.data()};
            if (body.plan.joined || loaded) {
                const ClothTethers tethers{cloth.tethers.diagonal.data(), cloth.tethers.off.data(), surfaces,
                                           has_contact};
                kernels.solve_joined(at, tethers, chains, batch, rows);
            } else if (has_contact) {
                kernels.solve_with_contacts(at, surfaces, chains, batch, rows);
            } else if (batch.attached) {
                kernels.solve_pulling(at, in_chains.pulls.data(), chains, batch, rows);
            } else {
                kernels.solve(at, chains, batch, rows);
            }
            const bool continued = backward && batch.elastic, breaks = body.breaking.possible();
            if (continued || breaks) kernels.find_tensions(rows, batch.link_count);
            if (continued) continue_links(cloth.batches, batch, chains, rows);
            if (breaks) note_pulls(body.breaking, batch, rows, sweep > 0);
        };
        solve_colours(cloth.batches, cloth.shares.team, backward, solve, [&] {
            if (loaded) move_loads(cloth.loads, cloth.state);
        });
    }
}

namespace {

bool pulls_count(const Body& body) { return body.cloth.contacts.any_active() || !body.constraints.attachments.empty(); }

void correct_volume(Body& body) {
    Cloth& cloth = body.cloth;
    if (!cloth.volume.held) return;
    solve_volume(cloth.volume, cloth.sheet, cloth.state, cloth.in_chains, cloth.batches.scale,
                 cloth.contacts.any_active(), pulls_count(body));
}

}  // namespace

void begin_links(Body& body) {
    Cloth& cloth = body.cloth;
    find_target_contacts(body.targets, cloth.state, cloth.in_chains, cloth.contacts.any_active());
    // Before the chains, which need the volume for their shape, and after them, because they leave an error in it.
    cloth.volume.multiplier = 0;
    correct_volume(body);
    if (!cloth.loads.any()) return;
    note_motion(cloth);
    if (!body.plan.joined) add_inertia_of_tension(cloth);
}

void end_links(Body& body) {
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = cloth.contacts;
    const bool loaded = cloth.loads.any();
    if (loaded) {
        if (!body.plan.joined) limit_friction_of_loads(cloth);
        take_pulls_of_loads(cloth.loads, cloth.in_chains);
    }
    correct_volume(body);
    if (!cloth.clusters.empty()) solve_clusters(body, pulls_count(body) || body.plan.joined);
    if (contacts.any_active()) save_positions(contacts, cloth.state);
    // The limits do not know the loads: where these strain the links, limits would move all but the loaded particles.
    if (loaded) return;
    if (body.constraints.attachments.empty()) {
        apply_reach_limits(cloth.reach, cloth.state, cloth.shares.team);
    } else {
        apply_reach_limits(cloth.reach, cloth.state, cloth.in_chains.pulls.data());
    }
}

void solve_cloth(Body& body) {
    Cloth& cloth = body.cloth;
    begin_links(body);
    sweep_links(body, 0, cloth.loads.any() ? ContactLoads::sweeps : least_sweeps_of(body));
    if (cloth.loads.any() && links_threw_loads(cloth)) {
        undo_loads(cloth);
        sweep_links(body, 0, least_sweeps_of(body));
    }
    end_links(body);
}

void finish_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    Cloth& cloth = body.cloth;
    ClothState& state = cloth.state;
    ClothContacts& contacts = cloth.contacts;
    ClothBalance& balance = cloth.balance;
    const double damping = body.settings.damping;
    const TimeScheme scheme(h, body.history.earlier_step);
    const bool collides = gphys::collides(body, around);
    if (!body.constraints.attachments.empty())
        add_pull_impulses(body.constraints, around, state, cloth.in_chains, contacts, body.contacts.impulses,
                          scheme.step(damping), h);
    keep_cloth_to_targets(body.targets, state, cloth.in_chains);
    if (collides) resolve_contacts(body);
    const ClothStep step = cloth_step(h, body.history.earlier_step, damping);
    const auto sum_of_gains = [&] {
        return sum_of_blocks(state, cloth.shares, [&](const ClothMotion& block) { return kernels.gain(block); });
    };
    double gain =
        sum_of_blocks(state, cloth.shares, [&](const ClothMotion& block) { return kernels.finish(block, step); });
    state.velocity.swap(state.velocity_before);
    const bool misplaced = std::exchange(cloth.misplaced, false) && balance.closed;
    if (misplaced) {
        keep_velocities(state, h);
        gain = sum_of_gains();
    }
    if (collides) add_contact_impulses(body, around, scheme.next / h);
    TautLimits taut(body.constraints, around, cloth.in_chains, contacts, body.contacts.impulses, scheme, damping);
    const bool has_limit_impact = taut.apply_impacts(cloth.batches.limits, state, body.breaking.impulse);
    if (contacts.penetrating && collides && state.held.empty())
        limit_energy_in_solid(state, cloth.shares, gain * state.average_mass);
    const bool bounded = body.targets.act();
    balance.closed = balance.closed && !(collides && contacts.has_moving_model) && !bounded;
    const bool accounted = is_accounted_for(body, collides);
    // Of elastic links that rigid ones hold, too, it is released by no motion.
    const double before = misplaced ? std::min(balance.stored, stored_energy(cloth)) : balance.stored;
    const auto remove = [&](double energy) {
        if (cloth.yielding.any) {
            remove_own_gains(state, energy);
        } else {
            remove_energy(state, cloth.shares, energy);
        }
    };
    if (balance.closed && !accounted) {
        balance.stored = stored_energy(cloth);
        balance.gain = (gain + balance.stored - before) * state.average_mass;
        if (balance.gain > 0 && !body.plan.joined) remove(balance.gain);
    }
    keep_hinged_energy(body, collides, h);
    stop_cloth_at_targets(body.targets, state);
    body.contacts.has_contact = has_limit_impact || bounded || cloth.yielding.any;
    if (collides) {
        body.contacts.has_contact = body.contacts.has_contact || contacts.any_active();
        solve_contact_velocities(body, around, h);
        if (contacts.has_moving_model) relax_links_in_contact(body);
    }
    if (cloth.relaxation.most_strain > 0 && !(body.plan.joined && cloth.relaxation.left_out)) {
        if (collides) save_positions(contacts, state);
        const std::optional<double> lost = relax_links(body, collides, h);
        if (lost && collides) stop_undone_motion(body, around, h);
        if (lost > 0 && balance.closed && !accounted) remove(*lost * state.average_mass);
    }
    if (accounted) {
        if (balance.closed) balance.stored = stored_energy(cloth);
        keep_momentum(state, contacts, balance.closed, damping, h, balance.stored - before);
    }
    settle(body, h);
    if (collides) {
        sweep_escaped(body, around, gravity, h);
        push_out_clusters(body);
        bounce_clusters(body, around, h);
        if (contacts.penetrating) leave_solids(body, h);
    }
    if (balance.closed && !accounted && !body.plan.joined && !contacts.penetrating) {
        // Contact planes and friction only take energy, but pushing particles out of planes raises them.
        const double stored = stored_energy(cloth);
        const double all = sum_of_gains() + stored - before;
        if (all > 0) remove(all * state.average_mass);
        balance.stored = stored;
    }
    if (gives_all_momentum_to_models(body, around))
        add_missing_impulses(body, around, missing_momentum(state, contacts, damping, h), body.contacts.impulses);
    balance.current = balance.closed && !collides && (accounted || cloth.relaxation.most_strain == 0);
    // What lies still has no earlier motion, which would make each step differ from the one before.
    const bool interrupted = body.contacts.has_contact || misplaced || cloth.settling.kept == 0;
    body.history.earlier_step = interrupted ? 0 : h;
    if (body.breaking.possible()) add_cloth_loads(body, scheme);
}

void end_cloth_substep(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    const bool collides = gphys::collides(body, around);
    body.cloth.contacts.impulse = body.cloth.contacts.moment = {};
    if (collides) find_active_planes(body, around, gravity, TimeScheme(h, body.history.earlier_step));
    solve_cloth(body);
    finish_cloth(body, around, gravity, h);
}

void move_cloth(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    if (body.cloth.relaxation.most_strain > 0 && collides(body, around)) search_ahead(body, around, gravity, h);
    predict_cloth(body, around, h);
    end_cloth_substep(body, around, gravity, h);
}

void end_cloth(Body& body, const CollisionContext& around) {
    if (collides(body, around)) record_contact_points(body, around);
    note_travel(body);
    publish_state(body.cloth.state, body.particles, body.cloth.shares);
    place_attached(body.constraints, body.cloth.state, body.particles.position);
    if (collides(body, around)) update_cache(body, around);
}

}  // namespace gphys

// One substep of joined bodies. Chains and particles are predicted as if alone, and then solved together
// (joint_system.cpp). Cloth bodies follow one after the other (block Gauss-Seidel): the chains of each are solved with
// the inertia of what is joined to it, and their forces on the joined particles are applied to the systems before the
// next cloth is solved.
#include "solver/joints/joined_motion.h"
#include "solver/contact/collision.h"
#include "solver/contact/leave_solids.h"
#include "solver/motion.h"
#include "solver/quads.h"
#include "solver/rope/rope_limits.h"
#include "solver/rope/rope_start.h"

namespace gphys {
namespace {

template <class Visit>
void each_system(const Joined& joined, Visit&& visit) {
    for (const uint32_t* i = joined.systems_begin; i != joined.systems_end; ++i) visit(joined.all_systems[*i]);
}

void gather_systems(const Joined& joined, double h) {
    each_system(joined, [&](JointSystem& system) { system.gather(joined.bodies, joined.joints, h); });
}

/// Call after gather_systems, or again to continue the iterations. Returns whether Newton's method has converged in
/// all.
bool solve_systems(const Joined& joined) {
    bool solved = true;
    each_system(joined, [&](JointSystem& system) {
        solved = system.solve() && solved;
        system.scatter(joined.bodies);
    });
    return solved;
}

/// Sets the inverse mass matrix of a joined particle for the chains of the cloth: the response of its system.
void set_inverse_mass(TetherInertia& inertia, const Tether& tether, JointSystem& system) {
    Vec3 columns[3];
    system.response(tether.node, columns);
    const JointSystem::Node& node = system.node(tether.node);
    const double weight = node.weight / node.share;
    float* const diagonal = &inertia.diagonal[4 * size_t{tether.particle}];
    float* const off = &inertia.off[4 * size_t{tether.particle}];
    for (int k = 0; k < 3; ++k) {
        diagonal[k] = static_cast<float>(columns[k][k] * weight);
        off[k] = static_cast<float>(columns[(k + 1) % 3][(k + 2) % 3] * weight);
    }
}

/// visit(tether) for all of one cloth
template <class Visit>
void each_tether(const Joined& joined, uint32_t slot, Visit&& visit) {
    const auto end = joined.all_tethers.end();
    for (auto tether = std::lower_bound(joined.all_tethers.begin(), end, Tether{slot, 0, 0, 0});
         tether != end && tether->body == slot; ++tether)
        visit(*tether, joined.all_systems[tether->system]);
}

bool moves(const Body& cloth, const Tether& tether) {
    return cloth.cloth.state.at[4 * size_t{tether.particle} + 3] > 0;
}

/// After forces were applied to them.
void solve_outdated(const Joined& joined) {
    each_system(joined, [&](JointSystem& system) {
        if (!system.is_outdated()) return;
        system.solve();
        system.scatter(joined.bodies);
    });
}

/// Sweeps over the links of one cloth, with the inertia of what is joined to it. Forces of cloth that was swept before
/// move that by what they do to first order.
template <class Sweep>
void sweep_with_joints(const Joined& joined, Body& body, uint32_t slot, double h, Sweep&& sweep) {
    Vector<float>& pulls = body.cloth.in_chains.pulls;
    each_tether(joined, slot, [&](const Tether&, JointSystem& system) {
        if (system.respond()) system.scatter(joined.bodies);
    });
    each_tether(joined, slot, [&](const Tether& tether, JointSystem& system) {
        set_inverse_mass(body.cloth.tethers, tether, system);
        // A joint does not pull off a particle that friction holds.
        if (moves(body, tether)) std::fill_n(&pulls[4 * size_t{tether.particle}], 3, 0.0f);
    });
    sweep();
    const double step = TimeScheme(h, body.history.earlier_step).step(body.settings.damping);
    each_tether(joined, slot, [&](const Tether& tether, JointSystem& system) {
        if (!moves(body, tether)) return;
        float* const pull = &pulls[4 * size_t{tether.particle}];
        system.apply_force(tether.node, get(pull) * (body.cloth.state.average_mass / (step * step)));
        if (system.node(tether.node).share < 1) put(pull, {});  // its cluster has it
    });
    if (!body.plan.rest.empty()) each_system(joined, [&](JointSystem& system) { system.apply_link_pulls(body, slot); });
}

void find_active_planes(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    if (collides(body, around)) find_active_planes(body, around, gravity, TimeScheme(h, body.history.earlier_step));
}

bool has_clusters(const Joined& joined, uint32_t slot) {
    bool has = false;
    each_system(joined, [&](const JointSystem& system) { has = has || system.has_clusters_of(slot); });
    return has;
}

/// The joints move the particles from where cloth has pulled them. What then lacks to their places is the part of their
/// contacts.
void save_places_of_tethers(const Joined& joined, Body& body, uint32_t slot) {
    if (!body.cloth.contacts.any_active()) return;
    each_system(joined, [&](const JointSystem& system) { system.save_cluster_places(body, slot); });
    each_tether(joined, slot, [&](const Tether& tether, const JointSystem& system) {
        if (moves(body, tether) && system.node(tether.node).share == 1)
            put(&body.cloth.contacts.saved[4 * size_t{tether.particle}],
                system.node(tether.node).predicted - body.cloth.state.origin);
    });
}

/// The responses of the clusters of a body that touch models, to the systems as they were solved last.
void list_responses(const Joined& joined, const Body& body, uint32_t slot) {
    each_cluster(body.cloth.clusters, [&](ClusterRange members) {
        const auto touches = [&](const ClusterMember& m) { return body.cloth.contacts.is_active(m.particle); };
        if (std::any_of(members.begin(), members.end(), touches))
            add_cluster_response(joined, slot, members.first->cluster);
    });
}

/// The impulses that contacts have added to responses.
void apply_contact_impulses(const Joined& joined, const Body& body, uint32_t slot) {
    const Vector<ClusterResponse>& responses = body.cloth.clusters.responses;
    if (responses.empty()) return;
    each_system(joined, [&](JointSystem& system) { system.apply_contact_impulses(slot, responses); });
}

/// Contacts act on the clusters with the inertia of what is joined to them, and then on that.
void end_joined_links(const Joined& joined, Body& body, uint32_t slot) {
    if (body.cloth.contacts.any_active()) list_responses(joined, body, slot);
    end_links(body);
    apply_contact_impulses(joined, body, slot);
    body.cloth.clusters.responses.clear();
}

void sweep_joined_cloth(const Joined& joined, Body& body, uint32_t slot, const CollisionContext& around, Vec3 gravity,
                        double h) {
    find_active_planes(body, around, gravity, h);
    if (has_clusters(joined, slot)) {
        begin_links(body);
        if (!body.plan.rest.empty()) {
            sweep_with_joints(joined, body, slot, h, [&] { sweep_links(body, 0, least_sweeps_of(body)); });
        }
        each_system(joined, [&](JointSystem& system) {
            if (system.respond()) system.scatter(joined.bodies);
        });
        end_joined_links(joined, body, slot);
    } else {
        sweep_with_joints(joined, body, slot, h, [&] { solve_cloth(body); });
    }
    save_places_of_tethers(joined, body, slot);
}

bool is_loaded(const Joined& joined) {
    bool any = false;
    each_body(joined, [&](const Body& body, uint32_t) { any = any || body.cloth.loads.any(); });
    return any;
}

/// Sweeps over all cloth in turn, as often as loads need it. A joined particle has the inertia of what it is joined to,
/// without that of its load, which follows when joints have moved the particle.
void sweep_loaded(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h) {
    const auto each_cloth = [&](auto&& visit) {
        each_body(joined, [&](Body& body, uint32_t slot) {
            if (is_graph(body)) visit(body, slot);
        });
    };
    each_cloth([&](Body& body, uint32_t) {
        find_active_planes(body, around, gravity, h);
        begin_links(body);
    });
    note_joined_energy(joined, gravity, h);
    for (int sweep = 0; sweep < ContactLoads::sweeps; ++sweep) {
        each_cloth([&](Body& body, uint32_t slot) {
            sweep_with_joints(joined, body, slot, h, [&] { sweep_links(body, sweep, sweep + 1); });
        });
        solve_outdated(joined);
        each_cloth([&](Body& body, uint32_t) { move_loads(body.cloth.loads, body.cloth.state); });
    }
    bool threw = false;
    each_cloth(
        [&](Body& body, uint32_t) { threw = threw || (body.cloth.loads.any() && links_threw_loads(body.cloth)); });
    if (threw) {
        each_cloth([&](Body& body, uint32_t) {
            if (body.cloth.loads.any()) undo_loads(body.cloth);
        });
        gather_systems(joined, h);
        solve_systems(joined);
        each_cloth([&](Body& body, uint32_t slot) {
            sweep_with_joints(joined, body, slot, h, [&] { sweep_links(body, 0, least_sweeps_of(body)); });
        });
    }
    each_cloth([&](Body& body, uint32_t slot) {
        end_joined_links(joined, body, slot);
        save_places_of_tethers(joined, body, slot);
    });
}

/// Call when joints have moved clusters since their contacts were solved, one cluster after the other.
void solve_cluster_contacts(const Joined& joined, const CollisionContext& around, double h) {
    for (const uint32_t* i = joined.systems_begin; i != joined.systems_end; ++i)
        joined.all_systems[*i].solve_cluster_contacts(joined.bodies, around, h, *i);
}

/// As `collide` of a single body, but with the held particles of all bodies pinned at once.
void collide_joined(const Joined& joined, const CollisionContext& around, double bounce_threshold, double h) {
    bool has_contact = false;
    each_body(joined, [&](Body& body, uint32_t) {
        if (is_graph(body)) return;
        collide(body, around, bounce_threshold);
        has_contact = has_contact || body.contacts.has_contact;
    });
    if (!has_contact) return;
    each_body(joined, [&](Body& body, uint32_t) {
        if (is_graph(body)) return;
        if (body.contacts.has_contact) {
            relax_contacts(body, around);
            pin_contacts(body.particles, body.contacts);
        } else {
            body.history.start = body.particles.position;
        }
    });
    each_system(joined, [&](JointSystem& system) { system.gather_again(joined.bodies, h); });
    solve_systems(joined);
    solve_cluster_contacts(joined, around, h);
    each_system(joined, [&](const JointSystem& system) { system.scatter_tensions(joined.bodies, joined.joints); });
    each_body(joined, [&](Body& body, uint32_t) {
        if (is_graph(body)) return;
        const TimeScheme scheme(h, body.history.earlier_step);
        const SolvedAgain again{scheme.step(body.settings.damping), scheme.next / h};
        if (body.contacts.has_contact) unpin_contacts(body.particles, body.contacts);
        for (uint32_t p = 0; p < body.particles.size(); ++p)
            keep_in_range(body.particles.position[p], body.particles.velocity[p], body.history.start[p]);
        if (collides(body, around)) {
            if (!body.contacts.has_contact) std::fill(body.contacts.held.begin(), body.contacts.held.end(), uint8_t{0});
            collide_again(body, around, bounce_threshold, again);
        } else {
            for (uint32_t p = 0; p < body.particles.size(); ++p)
                body.particles.velocity[p] += (body.particles.position[p] - body.history.start[p]) * again.rate;
        }
    });
}

}  // namespace

void begin_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h) {
    // The time schemes of all bodies must restart together, or momentum between them would not be conserved.
    bool interrupted = false;
    each_body(joined, [&](const Body& body, uint32_t) { interrupted = interrupted || body.history.earlier_step == 0; });
    if (interrupted) each_body(joined, [&](Body& body, uint32_t) { body.history.earlier_step = 0; });
    each_body(joined, [&](Body& body, uint32_t) {
        body.contacts.pushed = false;
        if (is_graph(body)) {
            predict_cloth(body, around, h);
        } else {
            begin_friction(body, gravity);
            begin_chains(body, around, gravity, TimeScheme(h, body.history.earlier_step));
        }
    });
}

namespace {

/// Moves the bodies out of models that they are in, and keeps their joints.
void leave_solids_joined(const Joined& joined, const CollisionContext& around, double h) {
    bool leaving = false;
    each_body(joined, [&](Body& body, uint32_t) {
        if (is_graph(body)) return;
        body.contacts.penetrating = body.contacts.penetrating && begin_leaving(body, around);
        leaving = leaving || body.contacts.penetrating;
    });
    if (!leaving) return;
    each_body(joined, [&](Body& body, uint32_t) {
        if (is_graph(body)) return;
        if (!body.contacts.penetrating) body.history.start = body.particles.position;
        body.history.predicted = body.particles.position;
        body.rope.bending.keeps_shape = true;
    });
    gather_systems(joined, h);
    const bool solved = solve_systems(joined);
    each_body(joined, [&](Body& body, uint32_t) {
        body.rope.bending.keeps_shape = false;
        if (!is_graph(body)) end_leaving(body, around, solved);
    });
}

/// Moves clusters as wholes of which models have pushed out particles, and keeps their joints.
void push_out_joined(const Joined& joined, const CollisionContext& around, double h) {
    bool pushed = false;
    each_body(joined, [&](Body& body, uint32_t) {
        pushed = std::exchange(body.cloth.contacts.clusters_pushed, false) || pushed;
    });
    if (!pushed) return;
    // So that masses count alike.
    each_body(joined, [&](Body& body, uint32_t) { body.history.earlier_step = 0; });
    for (const uint32_t* i = joined.systems_begin; i != joined.systems_end; ++i)
        joined.all_systems[*i].push_out_clusters(joined.bodies, joined.joints, around, h, *i);
}

/// Call after the systems are solved.
void finish_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h) {
    bool interrupted = false;  // then the previous tensions, and so the elastic energies, are unknown
    bool has_contact = false, moved = false, rigid = true;  // moved: by what is outside
    each_body(joined, [&](const Body& body, uint32_t) {
        interrupted = interrupted || body.history.earlier_step == 0;
        has_contact = has_contact || body.contacts.has_contact;
        moved =
            moved || body.contacts.pushed || are_carried(body.constraints) || !body.constraints.length_changes.empty();
    });
    each_system(joined, [&](const JointSystem& system) { rigid = rigid && system.is_rigid(); });
    if (is_loaded(joined)) {
        sweep_loaded(joined, around, gravity, h);
    } else {
        each_body(joined, [&](Body& body, uint32_t slot) {
            if (is_graph(body)) sweep_joined_cloth(joined, body, slot, around, gravity, h);
        });
    }
    solve_outdated(joined);
    solve_cluster_contacts(joined, around, h);
    bool has_limit_impact = false;
    each_system(joined, [&](const JointSystem& system) { system.scatter_tensions(joined.bodies, joined.joints); });
    each_body(joined, [&](Body& body, uint32_t) {
        if (is_graph(body)) return;
        const TimeScheme scheme(h, body.history.earlier_step);
        finish_chains(body, scheme);
        if (body.plan.limited) has_limit_impact = apply_limit_impacts(body, around, scheme) || has_limit_impact;
    });
    collide_joined(joined, around, find_bounce_threshold(gravity, h), h);
    bool held = false;
    each_body(joined,
              [&](const Body& body, uint32_t) { held = held || body.contacts.has_contact || has_pin(body.particles); });
    each_body(joined, [&](Body& body, uint32_t) { body.cloth.relaxation.left_out = !held; });
    each_system(joined, [&](const JointSystem& system) { system.add_anchor_impulses(joined.bodies, around, h); });
    each_body(joined, [&](Body& body, uint32_t) {
        if (is_graph(body)) {
            finish_cloth(body, around, gravity, h);
        } else {
            const TimeScheme scheme(h, body.history.earlier_step);
            if (!body.constraints.attachments.empty()) add_tension_impulses(body, around, scheme);
            end_friction(body);
            end_substep(body, has_limit_impact, scheme);
        }
    });
    if (!interrupted) {
        limit_joined_energy(joined, gravity);
    } else if (rigid && !has_contact && !moved) {
        bound_starting_energy(joined, gravity, h);
    }
    leave_solids_joined(joined, around, h);
    push_out_joined(joined, around, h);
}

struct JoinedMotion {
    const Joined& joined;
    const Vec3 gravity;

    void begin(const CollisionContext& around, double part) {
        begin_joined(joined, around, gravity, part);
        gather_systems(joined, part);
    }
    bool solve() { return solve_systems(joined); }
    /// Cloth cannot be rolled back, so with cloth the substep is never divided.
    int unused_halvings() const { return 0; }
    bool began_feasible() const {
        bool all = true;
        each_body(joined, [&](const Body& body, uint32_t) { all = all && !is_graph(body); });
        each_system(joined, [&](const JointSystem& system) { all = all && system.began_feasible(); });
        return all;
    }
    void finish(const CollisionContext& around, double part) { finish_joined(joined, around, gravity, part); }
    void roll_back() {
        each_body(joined, [](Body& body, uint32_t) { roll_back_chains(body.particles, body.history, body.rope); });
    }
};

}  // namespace

bool starts_misplaced(const Joined& joined) {
    bool restarting = false, misplaced = false;
    each_body(joined,
              [&](const Body& body, uint32_t) { restarting = restarting || restarts(body.history, body.contacts); });
    if (!restarting) return false;
    each_system(joined, [&](const JointSystem& system) {
        misplaced = misplaced || system.is_misplaced(joined.bodies, joined.joints);
    });
    return misplaced;
}

void close_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h) {
    JoinedMotion motion{joined, gravity};
    move_in_halves(motion, around, h);
    each_body(joined, [&](Body& body, uint32_t) {
        body.contacts.closed = true;
        if (is_graph(body)) {
            keep_velocities(body.cloth.state, h);
            body.history.earlier_step = 0;
        } else {
            keep_velocities(body, gravity, h);
        }
    });
}

void solve_without_contacts(const Joined& joined, double h) {
    gather_systems(joined, h);
    each_system(joined, [](JointSystem& system) { system.solve(); });
}

void add_cluster_response(const Joined& joined, uint32_t slot, uint32_t cluster) {
    Body& body = joined.bodies[slot];
    for (const uint32_t* i = joined.systems_begin; i != joined.systems_end; ++i)
        joined.all_systems[*i].add_cluster_response(body, slot, cluster, *i, body.cloth.clusters.responses);
}

void change_joined_velocities(const Joined& joined) {
    each_body(joined, [&](Body& body, uint32_t slot) {
        apply_contact_impulses(joined, body, slot);
        body.cloth.clusters.responses.clear();
    });
    each_system(joined, [&](JointSystem& system) { system.change_velocities(joined.bodies); });
}

void end_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h) {
    const auto apply_impulses = [&] {
        each_body(joined, [&](const Body& body, uint32_t slot) { apply_contact_impulses(joined, body, slot); });
    };
    apply_impulses();
    each_system(joined, [&](JointSystem& system) { system.displace_histories(joined.bodies, h); });
    gather_systems(joined, h);
    apply_impulses();
    each_body(joined, [&](Body& body, uint32_t) {
        for (const ClusterResponse& response : body.cloth.clusters.responses)
            body.contacts.pushed = body.contacts.pushed || response.impulse != Vec3{};
        body.cloth.clusters.responses.clear();
    });
    solve_systems(joined);
    finish_joined(joined, around, gravity, h);
}

void move_joined(const Joined& joined, const CollisionContext& around, Vec3 gravity, double h) {
    const auto move_once = [&](const CollisionContext& within, double part) {
        JoinedMotion motion{joined, gravity};
        move_in_halves(motion, within, part);
    };
    bool interrupted = false, has_contact = false;
    each_body(joined, [&](const Body& body, uint32_t) {
        interrupted = interrupted || body.history.earlier_step == 0;
        has_contact = has_contact || body.contacts.has_contact;
    });
    if (interrupted && !has_contact) {
        start_slowly(around, h, move_once);
    } else {
        move_once(around, h);
    }
}

}  // namespace gphys

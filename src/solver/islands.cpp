// Islands: which bodies may influence each other (union-find), and how they are moved together, substep by substep.
#include "solver/islands.h"

#include <chrono>

#include "solver/contact/collision.h"
#include "solver/contact/impulses.h"
#include "solver/joints/joined_motion.h"
#include "solver/motion.h"
#include "solver/solver.h"
#include "solver/state_range.h"

namespace gphys {

/// Unites bodies that collide with each other and may come into contact in this step: sort and sweep of their swept
/// boxes along x (Baraff 1992).
void Solver::unite_near_bodies(DisjointSets& sets, double dt) {
    swept_bounds_.clear();
    for (const uint32_t slot : state_.ids) {
        if (state_.bodies[slot].settings.body_layers == 0) continue;
        const Body& body = state_.bodies[slot];
        Aabb box{body.particles.position[0], body.particles.position[0]};
        double fastest = 0, radius = 0;
        for (uint32_t p = 0; p < body.particles.size(); ++p) {
            box = {min(box.min, body.particles.position[p]), max(box.max, body.particles.position[p])};
            fastest = std::max(fastest, length_squared(body.particles.velocity[p]));
            radius = std::max(radius, body.particles.radius[p]);
        }
        // Twice as far as it flies, because constraints may make parts of it faster.
        const double margin =
            radius + 2 * dt * (std::sqrt(fastest) + dt * length(state_.settings.gravity)) + way_to_targets(body);
        const Vec3 around{margin, margin, margin};
        swept_bounds_.push_back({slot, {box.min - around, box.max + around}});
    }
    std::sort(swept_bounds_.begin(), swept_bounds_.end(), [](const SweptBounds& a, const SweptBounds& b) {
        return a.box.min.x != b.box.min.x ? a.box.min.x < b.box.min.x : a.slot < b.slot;
    });
    for (size_t i = 0; i < swept_bounds_.size(); ++i) {
        const SweptBounds& a = swept_bounds_[i];
        for (size_t j = i + 1; j < swept_bounds_.size() && swept_bounds_[j].box.min.x <= a.box.max.x; ++j) {
            const SweptBounds& b = swept_bounds_[j];
            const bool apart = a.box.min.y > b.box.max.y || b.box.min.y > a.box.max.y || a.box.min.z > b.box.max.z ||
                               b.box.min.z > a.box.max.z;
            const bool collide =
                (state_.bodies[a.slot].settings.body_layers & state_.bodies[b.slot].settings.body_layers) != 0;
            if (collide && !apart) sets.unite(a.slot, b.slot);
        }
    }
}

/// Sets of bodies that joints connect or that may come into contact. A set is awake if any of its bodies is, and a
/// steady body is not.
void Solver::unite_bodies(const Scene* scene, double dt) {
    const uint32_t slots = state_.ids.slots();
    DisjointSets sets(set_of_, slots);
    for (Body& body : state_.bodies) body.plan.joined = false;
    for (const uint32_t slot : state_.joint_ids) {
        const Joint& joint = state_.joints[slot];
        sets.unite(joint.body_a, joint.body_b);
        state_.bodies[joint.body_a].plan.joined = state_.bodies[joint.body_b].plan.joined = true;
    }
    unite_near_bodies(sets, dt);
    for (uint32_t slot = 0; slot < slots; ++slot) set_of_[slot] = sets.root(slot);
    awake_.assign(slots, 0);
    for (const uint32_t slot : state_.ids) {
        const Body& body = state_.bodies[slot];
        if (!stays_steady(body, scene, dt) && !stays_asleep(body, scene)) awake_[set_of_[slot]] = 1;
    }
}

/// Makes islands of the sets that are awake.
void Solver::list_islands() {
    islands_.clear();
    island_bodies_.clear();
    joined_bodies_.clear();
    island_systems_.clear();
    for (const ActiveBody& active : active_) island_bodies_.push_back(active.slot);
    const auto by_set = [&](uint32_t a, uint32_t b) {
        return set_of_[a] != set_of_[b] ? set_of_[a] < set_of_[b] : a < b;
    };
    std::sort(island_bodies_.begin(), island_bodies_.end(), by_set);
    for (uint32_t i = 0; i < island_bodies_.size(); ++i) {
        const uint32_t slot = island_bodies_[i];
        if (islands_.empty() || set_of_[slot] != set_of_[island_bodies_[islands_.back().first_body]]) {
            islands_.emplace_back();
            islands_.back().first_body = i;
            islands_.back().first_joined = static_cast<uint32_t>(joined_bodies_.size());
        }
        Island& island = islands_.back();
        const Body& body = state_.bodies[slot];
        island.size += body.particles.size();
        ++island.body_count;
        if (!body.plan.joined) continue;
        joined_bodies_.push_back(slot);
        ++island.joined_count;
    }
    const auto set_of_system = [&](uint32_t system) { return set_of_[systems_[system].node(0).body]; };
    for (uint32_t i = 0; i < systems_.size(); ++i) island_systems_.push_back(i);
    std::stable_sort(island_systems_.begin(), island_systems_.end(),
                     [&](uint32_t a, uint32_t b) { return set_of_system(a) < set_of_system(b); });
    uint32_t next = 0;
    for (Island& island : islands_) {
        const uint32_t set = set_of_[island_bodies_[island.first_body]];
        while (next < systems_.size() && set_of_system(island_systems_[next]) < set) ++next;  // asleep
        island.first_system = next;
        while (next < systems_.size() && set_of_system(island_systems_[next]) == set) ++next;
        island.system_count = next - island.first_system;
    }
    // A single body is no island, unless it collides with itself or its chains are joined.
    const auto alone = [&](const Island& island) {
        const Body& first = state_.bodies[island_bodies_[island.first_body]];
        return island.body_count == 1 && !first.settings.self_collision && !first.plan.joined;
    };
    islands_.erase(std::remove_if(islands_.begin(), islands_.end(), alone), islands_.end());
    std::sort(islands_.begin(), islands_.end());
    in_island_.assign(state_.ids.slots(), 0);
    for (const Island& island : islands_) {
        for (uint32_t i = 0; i < island.body_count; ++i) in_island_[island_bodies_[island.first_body + i]] = 1;
    }
    for (ActiveBody& active : active_) {
        active.in_island = in_island_[active.slot] != 0;
        if (!active.in_island) continue;
        active.undisturbed = false;
        state_.bodies[active.slot].history.in_stages = false;
    }
}

/// One substep of bodies that collide with others. Contacts are solved between the prediction and the constraints, so
/// that corrections undone by constraints do not count as motion. The velocities are turned at the end.
void Solver::move_colliding(const Island& island, const Joined& joined, const CollisionContext& around, double h,
                            FlightPlanes* planes) {
    const uint32_t* const slots = &island_bodies_[island.first_body];
    const Vec3 gravity = state_.settings.gravity;
    bool interrupted = false, has_contact = false;
    for (uint32_t i = 0; i < island.body_count; ++i) {
        const Body& body = state_.bodies[slots[i]];
        if (body.plan.method == GPHYS_SOLVE_FREE && !body.plan.joined) continue;
        interrupted = interrupted || body.history.earlier_step == 0;
        has_contact = has_contact || body.contacts.has_contact;
    }
    const auto move_once = [&](const CollisionContext& within, double part) {
        for (uint32_t i = 0; i < island.body_count; ++i) {
            Body& body = state_.bodies[slots[i]];
            if (!body.plan.joined) begin_move(body, within, gravity, part, planes, island.team);
        }
        begin_joined(joined, within, gravity, part);
        particle_contacts_.solve_positions(island, state_.bodies, slots, joined, within, gravity, part, planes);
        for (uint32_t i = 0; i < island.body_count; ++i) {
            Body& body = state_.bodies[slots[i]];
            if (!body.plan.joined) end_move(body, within, gravity, part);
        }
        end_joined(joined, within, gravity, part);
        particle_contacts_.move_loads(island, state_.bodies, slots, joined, within, gravity, part, planes);
        particle_contacts_.move_loads_of_ropes(island, state_.bodies, slots, within, gravity, part, planes);
        particle_contacts_.solve_velocities(island, state_.bodies, slots, joined, within, gravity, part);
    };
    // Bodies feel each other from the second part on.
    const auto close_first = [&](const CollisionContext& within, double part) {
        if (within.begin > around.begin) return move_once(within, part);
        for (uint32_t i = 0; i < island.body_count; ++i) {
            Body& body = state_.bodies[slots[i]];
            if (body.plan.joined) continue;
            begin_move(body, within, gravity, part, planes, island.team);
            end_move(body, within, gravity, part);
        }
        close_joined(joined, within, gravity, part);
    };
    if (starts_misplaced(joined)) {
        start_slowly(around, h, close_first);
    } else if (interrupted && !has_contact) {
        start_slowly(around, h, move_once);
    } else {
        move_once(around, h);
    }
}

/// All substeps of the bodies of an island. Accesses no other bodies, and allocates nothing.
void Solver::move_island(const Island& island, uint32_t worker, const Scene* scene, double dt) {
    const uint32_t* const slots = &island_bodies_[island.first_body];
    const uint32_t* const joined_slots = joined_bodies_.data() + island.first_joined;
    const uint32_t* const systems = island_systems_.data() + island.first_system;
    const Joined joined{state_.bodies,
                        state_.joints,
                        joined_slots,
                        joined_slots + island.joined_count,
                        systems_,
                        systems,
                        systems + island.system_count,
                        tethers_};
    const auto each_body = [&](auto&& visit) {
        for (uint32_t i = 0; i < island.body_count; ++i) visit(state_.bodies[slots[i]]);
    };
    const Vec3 gravity = state_.settings.gravity;
    const CollisionContext whole = context_of(scene, worker, dt, 0, 1), beginning = context_of(scene, worker, dt, 0, 0);
    uint32_t substeps = 1;
    std::chrono::steady_clock::time_point start;
    if (island.on_trial) start = std::chrono::steady_clock::now();
    each_body([&](Body& body) {
        clear_contact_points(body);
        body.contacts.impulses.clear();
        add_attached_impulses(body, beginning, 1, {}, 0);
        begin_air(body, gravity, dt);
        // No error is measured of contacts between particles, so with error targets, too, they get the set number.
        const uint32_t least = island.colliding_count > 0 ? state_.settings.substeps : 1;
        const uint32_t wanted = std::max(substeps_of(body, state_.settings, dt), least);
        substeps = std::max(substeps, std::min(wanted, body.substeps.allowed));
        if (body.plan.method == GPHYS_SOLVE_GRAPH) begin_cloth(body, beginning, gravity);
    });
    if (island.colliding_count > 0) particle_contacts_.begin(island, state_.ids, state_.bodies, slots);
    for (uint32_t i = 1; i <= substeps; ++i) {
        const double begin = static_cast<double>(i - 1) / substeps, end = static_cast<double>(i) / substeps;
        const CollisionContext around = context_of(scene, worker, dt, begin, end);
        const double h = dt / substeps;
        if (island.colliding_count > 0) {
            move_colliding(island, joined, around, h, flight_planes(worker, scene));
            continue;
        }
        each_body([&](Body& body) {
            if (!body.plan.joined) move(body, around, gravity, h);
        });
        if (island.joined_count > 0) move_joined(joined, around, gravity, h);
    }
    if (island.colliding_count > 0) {
        const CollisionContext last = context_of(scene, worker, dt, 1 - 1.0 / substeps, 1);
        particle_contacts_.solve_final_positions(island, state_.bodies, slots, last, gravity, dt / substeps);
    }
    if (island.on_trial) {
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        sharing_trial(island).add(island.team != nullptr, taken.count() / substeps);
    }
    bool at_rest = state_.settings.sleep_speed > 0;
    each_body([&](Body& body) {
        if (body.plan.method == GPHYS_SOLVE_GRAPH) end_cloth(body, whole);
        add_parts(body);
        body.contacts.closed = false;
        body.constraints.length_changes.clear();
        end_targets(body, share_);
        body.flight.last_surroundings = body.flight.surroundings;
        stay_in_range(body);
        adapt_substep(body, state_.settings, dt, substeps);
        add_attached_impulses(body, whole, -1, gravity, dt);
        end_air(body);
        note_settling(body, scene, gravity, dt, island.body_count == 1);
        at_rest = is_at_rest(body, state_.settings, dt) && at_rest;
    });
    if (at_rest) each_body([&](Body& body) { fall_asleep(body, scene, dt); });
}

}  // namespace gphys

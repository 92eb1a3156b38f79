// The step: forces -> integrate -> constraints -> collide -> publish.
//
//   phase          writes                                                   files
//   prepare        plans, memory of all arrays, near models, tasks; the     prepare.cpp, islands.cpp
//                  only phase that allocates or fails
//   begin_step     paths of attachments; sizes of what a snapshot holds     prepare.cpp
//   move, by task: all of the bodies of the task, nothing of others
//     forces       Air, Particles::force; of cloth its accelerations        wind.cpp, cloth.cpp
//     integrate    History and Particles; of cloth Cloth::state             rope_substep.cpp, cloth.cpp
//     constraints  Particles::position, Rope::tension; of cloth Cloth::state  rope_direct.cpp, cloth_chains.cpp
//     collide      Contacts, Particles; of cloth Cloth::contacts            contact/, cloth_contacts.cpp
//     (these four in each substep)
//     measure      Substeps, Sleep                                          error_targets.cpp, sleep.cpp
//   publish        the sums of all Contacts::impulses by model; of cloth    add_impulses,
//                  Particles, at the end of its last substep                cloth_state.cpp
//   break          the constraints and triangles of overloaded links,       tearing/breaks.cpp
//                  and copies of particles
//
// All but `move` runs on the caller's thread. Workers share the scene, the models that have moved and the settings,
// which they only read. Each worker has a RopeScratch, FlightPlanes and a CollisionMemory of its own. Several workers
// write to one body in these cases only:
//
//   A large body of free particles is divided (move_part). The parts are disjoint ranges of its particles, with
//   impulses of their own, which end_body_step adds in order. All workers move a large cloth as one team (move_shared),
//   with a barrier between colours (foundation/team.h), if that is faster (SharingTrial). So they do with a large
//   island of particles that collide: its contacts, and the parts of its bodies.
//
// Bodies that may influence each other are an island, and one task moves all of them, substep by substep (islands.cpp,
// joints/joined_motion.cpp). Most bodies are alone. A body alone moves like this:
//
//   free         exact flight and impacts                                    free_flight.cpp
//   direct       predict, solve chains as a whole, new velocities, collide,
//                solve again with contacts                                   rope_substep.cpp
//                the same of chains that branch                              joined_motion.cpp
//   graph        predict, chain colours, reach limits, velocities, collide  cloth.cpp
#include <chrono>

#include "solver/attached_places.h"
#include "solver/contact/collision.h"
#include "solver/motion.h"
#include "solver/particles/free_flight.h"
#include "solver/rope/rope.h"
#include "solver/rope/rope_contact_lanes.h"
#include "solver/solver.h"
#include "solver/state.h"
#include "solver/state_range.h"

namespace gphys {

void follow_models(Body& body, const CollisionContext& around, double h, uint32_t first, uint32_t end) {
    const Vector<Attachment>& attachments = body.constraints.attachments;
    const double way = around.way(around.end);
    AttachedPlaces places(around, body.settings.layers);
    for (auto attachment = attachments_from(attachments, first);
         attachment != attachments.end() && attachment->particle < end; ++attachment) {
        Vec3& position = body.particles.position[attachment->particle];
        const Vec3 next = places.at_end(*attachment);
        body.particles.velocity[attachment->particle] = (next - position) / h;
        position = next;
    }
    for (uint32_t p = first; p < end && !body.targets.empty(); ++p) {
        if (body.targets.all[p].carries == 0) continue;
        const Vec3 next = place_of(body.targets.all[p], way);
        body.particles.velocity[p] = (next - body.particles.position[p]) / h;
        body.particles.position[p] = next;
    }
}

void move(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    switch (body.plan.method) {
        case GPHYS_SOLVE_FREE:
            fly(body, around, gravity, h, nullptr, nullptr);
            break;
        case GPHYS_SOLVE_DIRECT:
            move_rope(body, around, gravity, h);
            break;
        default:
            move_cloth(body, around, gravity, h);
    }
}

void begin_move(Body& body, const CollisionContext& around, Vec3 gravity, double h, FlightPlanes* planes, Team* team) {
    switch (body.plan.method) {
        case GPHYS_SOLVE_FREE:
            fly(body, around, gravity, h, planes, team);
            break;
        case GPHYS_SOLVE_DIRECT:
            begin_friction(body, gravity);
            begin_chains(body, around, gravity, TimeScheme(h, body.history.earlier_step));
            break;
        default:
            predict_cloth(body, around, h);
    }
}

void end_move(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    switch (body.plan.method) {
        case GPHYS_SOLVE_FREE:
            break;
        case GPHYS_SOLVE_DIRECT:
            end_rope(body, around, gravity, TimeScheme(h, body.history.earlier_step));
            end_friction(body);
            break;
        default:
            end_cloth_substep(body, around, gravity, h);
    }
}

/// Call before all substeps of a body that is moved alone, and end_body_step after them.
void Solver::begin_body_step(const ActiveBody& active, const Scene* scene, double dt) {
    Body& body = state_.bodies[active.slot];
    body.contacts.impulses.clear();
    add_attached_impulses(body, context_of(scene, dt, 0, 0), 1, {}, 0);
    begin_air(body, state_.settings.gravity, dt);
}

void Solver::end_body_step(Body& body, const Scene* scene, double dt, uint32_t substeps) {
    add_parts(body);
    for (const FlightPart& part : body.contacts.parts) {
        if (!body.particles.extent) body.particles.extent.emplace();
        body.particles.extent->add(part.extent);
    }
    body.flight.last_surroundings = body.flight.surroundings;
    body.constraints.length_changes.clear();
    end_targets(body, share_);
    stay_in_range(body);
    adapt_substep(body, state_.settings, dt, substeps);
    add_attached_impulses(body, context_of(scene, dt, 0, 1), -1, state_.settings.gravity, dt);
    end_air(body);
    rest(body, scene, state_.settings, dt);
}

/// Moves in `count` substeps, or in more if the first ones show that these are too long. Returns their number.
uint32_t Solver::move_in_substeps(Body& body, uint32_t count, const CollisionContext& step) {
    CollisionContext rest = step;
    uint32_t made = 0;
    for (uint32_t i = 0; i < count;) {
        const CollisionContext part = part_of_step(rest, i++, count);
        move(body, part, state_.settings.gravity, step.step_time * (rest.end - rest.begin) / count);
        ++made;
        const uint32_t wanted = substeps_of_rest(body, state_.settings, step.step_time, part.end, made);
        const uint32_t left = std::min(wanted, body.substeps.allowed - std::min(body.substeps.allowed, made));
        if (left <= count - i) continue;
        rest.begin = part.end;
        count = left;
        i = 0;
    }
    return made;
}

/// Call before all substeps of a body of ropes, and end_rope_step after them.
RopeStepper Solver::begin_rope_step(const ActiveBody& active, RopeContacts& contacts, uint32_t worker,
                                    const Scene* scene, double dt) {
    RopeScratch& scratch = rope_scratch_[worker];
    Body& body = state_.bodies[active.slot];
    const Vec3 gravity = state_.settings.gravity;
    begin_body_step(active, scene, dt);
    begin_contact_points(body);
    const CollisionContext whole = context_of(scene, worker, dt, 0, 1);
    choose_stages(body, scratch, {gravity, whole, active.substeps, false});
    const bool has_contacts = active.near_models() || !body.targets.empty();
    if (has_contacts) contacts.begin_step(body, whole, active.near_models(), active.models_move, scratch.parts);
    return {body, has_contacts ? &contacts : nullptr, whole, gravity, active.substeps, dt / active.substeps};
}

void Solver::end_rope_step(const RopeStepper& rope, const Scene* scene, double dt) {
    end_contact_points(rope.body());
    end_body_step(rope.body(), scene, dt, rope.substeps());
}

/// All substeps of ropes, of which the first is the longest. Accesses no other bodies, and allocates nothing.
template <int lanes>
void Solver::move_contact_lanes(const ActiveBody* ropes, uint32_t count, uint32_t worker, const Scene* scene,
                                double dt) {
    RopeContactLanes<lanes> group(rope_scratch_[worker], ropes[0].size);
    for (uint32_t begun = 0; begun < count || !group.empty();) {
        if (begun < count && !group.full()) {
            group.add(begin_rope_step(ropes[begun++], group.next_contacts(), worker, scene, dt));
        } else {
            end_rope_step(group.move_until_one_ends(), scene, dt);
        }
    }
}

/// All substeps of one body. Accesses no other bodies, and allocates nothing.
void Solver::move_body(const ActiveBody& active, uint32_t worker, const Scene* scene, double dt) {
    Body& body = state_.bodies[active.slot];
    const Vec3 gravity = state_.settings.gravity;
    const CollisionContext whole = context_of(scene, worker, dt, 0, 1), beginning = context_of(scene, worker, dt, 0, 0);
    uint32_t substeps = active.substeps;
    if (body.plan.method == GPHYS_SOLVE_DIRECT) {
        if (active.has_contact_lane()) return move_contact_lanes<1>(&active, 1, worker, scene, dt);
        RopeStepper rope = begin_rope_step(active, rope_scratch_[worker].contacts[0], worker, scene, dt);
        while (rope.begin_part()) rope.end_part(rope.solve());
        return end_rope_step(rope, scene, dt);
    }
    begin_body_step(active, scene, dt);
    if (body.plan.method == GPHYS_SOLVE_FREE) {
        // Gravity and drag do not take particles out of `search_box`; forces and targets may.
        const bool alone = !active.near_models() && !body.particles.forced && body.targets.empty();
        const Scene* const around = alone ? nullptr : scene;
        body.particles.extent =
            fly_through(body, 0, body.particles.size(), {body.contacts.impulses, body.contacts.has_contact},
                        context_of(around, worker, dt, 0, 1), gravity, substeps, flight_planes(worker, around));
    } else {
        ClothShares& shares = body.cloth.shares;
        std::chrono::steady_clock::time_point begin;
        if (shares.on_trial) begin = std::chrono::steady_clock::now();
        begin_contact_points(body);
        begin_cloth(body, beginning, gravity);
        substeps = move_in_substeps(body, substeps, whole);
        end_cloth(body, whole);
        end_contact_points(body);
        if (shares.on_trial) {
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
            shares.trial.add(shares.team != nullptr, taken.count() / substeps);
        }
    }
    end_body_step(body, scene, dt, substeps);
}

/// The same for a part of a body, between begin_body_step and end_body_step.
void Solver::move_part(const Task& task, uint32_t worker, const Scene* scene, double dt) {
    const ActiveBody& active = active_[task.first];
    Body& body = state_.bodies[active.slot];
    FlightPart& part = body.contacts.parts[task.part];
    const uint32_t first = task.part * part_size, end = std::min(first + part_size, body.particles.size());
    part.extent = fly_through(body, first, end, {part.impulses, part.has_contact}, context_of(scene, worker, dt, 0, 1),
                              state_.settings.gravity, active.substeps, flight_planes(worker, scene));
}

void Solver::move_undisturbed(const Task& task, uint32_t worker, const Scene* scene, double dt) {
    RopeScratch& scratch = rope_scratch_[worker];
    UndisturbedRope ropes[rope_lanes];
    const ActiveBody* const first = &active_[task.first];
    for (uint32_t i = 0; i < task.count; ++i) {
        Body& body = state_.bodies[first[i].slot];
        ropes[i] = {&body, scene && body.settings.layers != 0 ? &first[i].reachable : nullptr, false};
        begin_body_step(first[i], scene, dt);
    }
    const CollisionContext whole = context_of(scene, worker, dt, 0, 1);
    move_ropes(ropes, task.count, scratch,
               {state_.settings.gravity, whole, first->substeps, state_.settings.tolerance > 0});
    for (uint32_t i = 0; i < task.count; ++i) {
        Body& body = *ropes[i].body;
        if (!ropes[i].stayed) {
            end_air(body);
            begin_loads(body);
            move_body(first[i], worker, scene, dt);
            continue;
        }
        add_attached_impulses(body, whole, -1, state_.settings.gravity, dt);
        end_air(body);
        clear_contact_points(body);
        std::fill(body.contacts.stuck.begin(), body.contacts.stuck.end(), 0u);
        stay_in_range(body);
        adapt_substep(body, state_.settings, dt, first->substeps);
        rest(body, scene, state_.settings, dt);
    }
}

void Solver::move_shared(const ActiveBody& active, const Scene* scene, double dt) {
    Team team;
    Cloth& cloth = state_.bodies[active.slot].cloth;
    cloth.shares.team = &team;
    workers_.run(workers_.count(), [&](uint32_t) { team.join([&] { move_body(active, 0, scene, dt); }); });
    cloth.shares.team = nullptr;
}

void Solver::move_shared(Island& island, const Scene* scene, double dt) {
    Team team;
    island.team = &team;
    workers_.run(workers_.count(), [&](uint32_t) { team.join([&] { move_island(island, 0, scene, dt); }); });
    island.team = nullptr;
}

void Solver::update_meshes(Vec3 shift) noexcept {
    meshes_.follow_all([&](gphys_body_id id) { return state_.ids.has(id) ? &body(id) : nullptr; }, shift);
}

void Solver::step(const Scene* scene, double dt) {
    model_time_ = dt;
    share_ = 1;
    simulate(scene, dt, true);
    update_meshes();
}

void Solver::simulate(const Scene* scene, double dt, bool first) {
    prepare(scene, dt);
    if (first) breaks_.clear();
    begin_step(scene);
    const auto each_divided = [&](auto&& visit) {
        for (const ActiveBody& active : active_) {
            if (!active.in_island && active.parts > 0) visit(active);
        }
    };
    each_divided([&](const ActiveBody& active) { begin_body_step(active, scene, dt); });
    for (const Task& task : tasks_) {
        if (task.shared) move_shared(active_[task.first], scene, dt);
    }
    for (Island& island : islands_) {
        if (island.shared) move_shared(island, scene, dt);
    }
    // Each worker keeps its work space from task to task.
    std::atomic<size_t> next{0};
    workers_.run(workers_.count(), [&](uint32_t worker) {
        for (size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < islands_.size() + tasks_.size();) {
            if (i < islands_.size()) {
                if (!islands_[i].shared) move_island(islands_[i], worker, scene, dt);
                continue;
            }
            const Task& task = tasks_[i - islands_.size()];
            if (task.shared) continue;
            if (active_[task.first].parts > 0) {
                move_part(task, worker, scene, dt);
            } else if (active_[task.first].undisturbed) {
                move_undisturbed(task, worker, scene, dt);
            } else if (task.count > 1) {
                move_contact_lanes<rope_lanes>(&active_[task.first], task.count, worker, scene, dt);
            } else {
                move_body(active_[task.first], worker, scene, dt);
            }
        }
    });
    each_divided(
        [&](const ActiveBody& active) { end_body_step(state_.bodies[active.slot], scene, dt, active.substeps); });
    for (const ActiveBody& active : active_) end_moved_pins(state_.bodies[active.slot], share_);
    state_.near_models.swap(next_near_models_);
    particle_contacts_.end_step(islands_);
    add_impulses();
    break_overloaded(dt);
}

/// Uses reserved memory.
void Solver::add_impulses() {
    impulse_sums_.clear();
    for (const uint32_t slot : state_.ids) impulse_sums_.add(slot, state_.bodies[slot].contacts.impulses);
    impulse_sums_.sum();
}

void Solver::advance(const Scene* scene, double frame_time, uint32_t& steps) {
    // Frame times and steps were float32, so six steps of 1/60 s may be slightly longer than 0.1 s. A missing millionth
    // of a step is ignored.
    const double time = state_.accumulator + frame_time, length = state_.settings.fixed_step;
    const double due = std::floor(time / length + 1e-6);
    const uint32_t wanted = static_cast<uint32_t>(std::min<double>(due, state_.settings.max_steps));
    for (steps = 0; steps < wanted; ++steps) {
        // The caller has moved the models once, to their places at the end of the frame. Since the last step they have
        // moved for `time`, and evenly as far as known. In a frame that is longer than max_steps, faster.
        model_time_ = time * (wanted / due) - steps * length;
        share_ = model_time_ > length * (1 + 1e-6) ? length / model_time_ : 1;
        try {
            simulate(scene, length, steps == 0);
        } catch (const std::bad_alloc&) {
            if (steps == 0) throw;
            break;  // the steps made so far cannot be undone, and are reported
        }
    }
    if (steps > 0) update_meshes();
    // For frame times of years, the difference is rounding.
    state_.accumulator = std::clamp(time - due * length, 0.0, length);
}

}  // namespace gphys

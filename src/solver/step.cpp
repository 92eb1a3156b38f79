// The step: forces -> integrate -> constraints -> collide -> publish.
//
//   phase          writes                                                   files
//   prepare        plans, room in all arrays, tasks; the only phase that    prepare.cpp, islands.cpp
//                  allocates or fails
//   begin_step     where attachments go; sizes of what a snapshot holds     prepare.cpp
//   move, by task: all of the bodies of the task, nothing of others
//     forces       Air, Particles::force; of cloth its accelerations        wind.cpp, cloth.cpp
//     integrate    History and Particles; of cloth Cloth::state             rope_substep.cpp, cloth.cpp
//     constraints  Particles::position, Rope::tension; of cloth Cloth::state  rope_direct.cpp, cloth_chains.cpp
//     collide      Contacts, Particles; of cloth Cloth::contacts            contact/, cloth_contacts.cpp
//     (these once per substep)
//     measure      Substeps, Sleep                                          error_targets.cpp, sleep.cpp
//   publish        the sums of all Contacts::impulses by model; of cloth    add_impulses,
//                  Particles, at the end of its last substep                cloth_state.cpp
//
// All but `move` run on the caller's thread. Workers share the scene, the models that have moved and the settings,
// which they only read. Each has a RopeRoom and FlightPlanes of its own. Two are on one body at once in two cases
// only: parts of a body of free particles (move_part) are disjoint ranges of its particles, with impulses of their
// own, which end_moving adds in order; a large cloth (move_shared) is moved by all workers as one team, which waits
// between colours (foundation/team.h).
//
// Bodies that may influence each other are an island: a task takes all of them through each substep (islands.cpp,
// joints/joined_motion.cpp). Most bodies are alone. A body alone moves like this:
//
//   free         exact flight and impacts                                    free_flight.cpp
//   direct       predict, solve chains as a whole, new velocities, collide,
//                solve again beside contacts                                 rope_substep.cpp
//                the same of chains that branch                              joined_motion.cpp
//   graph        predict, chain colours, reach limits, velocities, collide  cloth.cpp
#include "solver/contact/collision.h"
#include "solver/motion.h"
#include "solver/particles/free_flight.h"
#include "solver/rope/rope.h"
#include "solver/rope/ropes_beside_models.h"
#include "solver/solver.h"
#include "solver/state_range.h"

namespace gphys {

void follow_models(Body& body, double fraction, double h, uint32_t first, uint32_t end) {
    const auto before = [](const Attachment& attachment, uint32_t p) { return attachment.particle < p; };
    auto attachment =
        std::lower_bound(body.constraints.attachments.begin(), body.constraints.attachments.end(), first, before);
    for (; attachment != body.constraints.attachments.end() && attachment->particle < end; ++attachment) {
        Vec3& position = body.particles.position[attachment->particle];
        const Vec3 next = attachment->begin + (attachment->end - attachment->begin) * fraction;
        body.particles.velocity[attachment->particle] = (next - position) / h;
        position = next;
    }
    for (uint32_t p = first; p < end && !body.targets.empty(); ++p) {
        if (body.targets.all[p].carries == 0) continue;
        const Vec3 next = place_of(body.targets.all[p], fraction);
        body.particles.velocity[p] = (next - body.particles.position[p]) / h;
        body.particles.position[p] = next;
    }
}

void move(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    switch (body.plan.method) {
        case GPHYS_SOLVE_FREE:
            fly(body, around, gravity, h);
            break;
        case GPHYS_SOLVE_DIRECT:
            move_rope(body, around, gravity, h);
            break;
        default:
            move_cloth(body, around, gravity, h);
    }
}

void begin_move(Body& body, const CollisionContext& around, Vec3 gravity, double h) {
    switch (body.plan.method) {
        case GPHYS_SOLVE_FREE:
            fly(body, around, gravity, h);
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

/// Call before and after all substeps of a body that is moved alone.
void Solver::begin_moving(const ActiveBody& moving, const Scene* scene, double dt) {
    Body& body = state_.bodies[moving.slot];
    body.contacts.impulses.clear();
    add_attached_impulses(body, {scene, &moved_, dt, 0, 0}, 1, {}, 0);
    begin_air(body, state_.settings.gravity, dt);
}

void Solver::end_moving(Body& body, const Scene* scene, double dt, uint32_t substeps) {
    add_parts(body);
    for (const FlightPart& part : body.contacts.parts) {
        if (!body.particles.extent) body.particles.extent.emplace();
        body.particles.extent->add(part.extent);
    }
    body.constraints.length_changes.clear();
    end_targets(body);
    stay_in_range(body);
    adapt_substep(body, state_.settings, dt, substeps);
    add_attached_impulses(body, {scene, &moved_, dt, 0, 1}, -1, state_.settings.gravity, dt);
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

/// Call before all substeps of a body of ropes, and end_in_step after them.
RopeInStep Solver::begin_in_step(const ActiveBody& moving, RopeContacts& contacts, RopeRoom& room, const Scene* scene,
                                 double dt) {
    Body& body = state_.bodies[moving.slot];
    const Vec3 gravity = state_.settings.gravity;
    begin_moving(moving, scene, dt);
    begin_contact_points(body);
    choose_stages(body, room, {gravity, dt, moving.substeps, false});
    const bool beside_models = moving.models_near > 0 && !moving.models_move;
    const bool has_contacts = beside_models || !body.targets.empty();
    if (has_contacts) contacts.begin_step(body, beside_models, room.parts);
    return {body,
            has_contacts ? &contacts : nullptr,
            {scene, &moved_, dt, 0, 1},
            gravity,
            moving.substeps,
            dt / moving.substeps};
}

void Solver::end_in_step(const RopeInStep& rope, const Scene* scene, double dt) {
    end_contact_points(rope.body());
    end_moving(rope.body(), scene, dt, rope.substeps());
}

/// Ropes of which the first is the longest. Accesses no other bodies, and allocates nothing.
template <int lanes>
void Solver::move_beside_models(const ActiveBody* ropes, uint32_t count, RopeRoom& room, const Scene* scene,
                                double dt) {
    RopesBesideModels<lanes> together(room, ropes[0].size);
    for (uint32_t begun = 0; begun < count || !together.empty();) {
        if (begun < count && !together.full()) {
            together.add(begin_in_step(ropes[begun++], together.next_contacts(), room, scene, dt));
        } else {
            end_in_step(together.move_until_one_ends(), scene, dt);
        }
    }
}

/// All substeps of one body. Accesses no other bodies, and allocates nothing.
void Solver::move_through(const ActiveBody& moving, uint32_t worker, const Scene* scene, double dt) {
    Body& body = state_.bodies[moving.slot];
    const Vec3 gravity = state_.settings.gravity;
    const CollisionContext whole{scene, &moved_, dt, 0, 1}, beginning{scene, &moved_, dt, 0, 0};
    uint32_t substeps = moving.substeps;
    if (body.plan.method == GPHYS_SOLVE_DIRECT) {
        RopeRoom& room = rooms_[worker];
        if (moving.beside_models()) return move_beside_models<1>(&moving, 1, room, scene, dt);
        RopeInStep rope = begin_in_step(moving, room.contacts[0], room, scene, dt);
        while (rope.begin_part()) rope.end_part(rope.solve());
        return end_in_step(rope, scene, dt);
    }
    begin_moving(moving, scene, dt);
    if (body.plan.method == GPHYS_SOLVE_FREE) {
        body.particles.extent =
            fly_through(body, 0, body.particles.size(), {body.contacts.impulses, body.contacts.has_contact}, whole,
                        gravity, substeps, flight_planes(worker, scene));
    } else {
        begin_contact_points(body);
        begin_cloth(body, beginning, gravity);
        substeps = move_in_substeps(body, substeps, whole);
        end_cloth(body, whole);
        end_contact_points(body);
    }
    end_moving(body, scene, dt, substeps);
}

/// The same for a part of a body, between begin_moving and end_moving.
void Solver::move_part(const Task& task, uint32_t worker, const Scene* scene, double dt) {
    const ActiveBody& moving = moving_[task.first];
    Body& body = state_.bodies[moving.slot];
    FlightPart& part = body.contacts.parts[task.part];
    const uint32_t first = task.part * part_size, end = std::min(first + part_size, body.particles.size());
    part.extent = fly_through(body, first, end, {part.impulses, part.has_contact}, {scene, &moved_, dt, 0, 1},
                              state_.settings.gravity, moving.substeps, flight_planes(worker, scene));
}

void Solver::move_undisturbed(const Task& task, uint32_t worker, const Scene* scene, double dt) {
    RopeRoom& room = rooms_[worker];
    UndisturbedRope ropes[ropes_together];
    const ActiveBody* const first = &moving_[task.first];
    for (uint32_t i = 0; i < task.count; ++i) {
        Body& body = state_.bodies[first[i].slot];
        ropes[i] = {&body, scene && body.settings.layers != 0 ? &first[i].close : nullptr, false};
        begin_air(body, state_.settings.gravity, dt);
    }
    move_ropes(ropes, task.count, room, {state_.settings.gravity, dt, first->substeps, state_.settings.tolerance > 0});
    for (uint32_t i = 0; i < task.count; ++i) {
        Body& body = *ropes[i].body;
        end_air(body);
        if (!ropes[i].stayed) {
            move_through(first[i], worker, scene, dt);
            continue;
        }
        clear_contact_points(body);
        std::fill(body.contacts.stuck.begin(), body.contacts.stuck.end(), 0u);
        body.contacts.impulses.clear();
        stay_in_range(body);
        adapt_substep(body, state_.settings, dt, first->substeps);
        rest(body, scene, state_.settings, dt);
    }
}

void Solver::move_shared(const ActiveBody& moving, const Scene* scene, double dt) {
    Team team;
    Cloth& cloth = state_.bodies[moving.slot].cloth;
    cloth.shares.team = &team;
    workers_.run(workers_.count(), [&](uint32_t) { team.join([&] { move_through(moving, 0, scene, dt); }); });
    cloth.shares.team = nullptr;
}

void Solver::show_all(Vec3 shift) noexcept {
    meshes_.follow_all([&](gphys_body_id id) { return state_.ids.has(id) ? &body(id) : nullptr; }, shift);
}

void Solver::step(const Scene* scene, double dt) {
    simulate(scene, dt);
    show_all();
}

void Solver::simulate(const Scene* scene, double dt) {
    prepare(scene, dt);
    begin_step(scene);
    const auto each_divided = [&](auto&& visit) {
        for (const ActiveBody& moving : moving_) {
            if (!moving.together && !state_.bodies[moving.slot].contacts.parts.empty()) visit(moving);
        }
    };
    each_divided([&](const ActiveBody& moving) { begin_moving(moving, scene, dt); });
    for (const Task& task : tasks_) {
        if (task.shared) move_shared(moving_[task.first], scene, dt);
    }
    // Each worker keeps its memory from task to task.
    std::atomic<size_t> next{0};
    workers_.run(workers_.count(), [&](uint32_t worker) {
        for (size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < islands_.size() + tasks_.size();) {
            if (i < islands_.size()) {
                move_island(islands_[i], scene, dt);
                continue;
            }
            const Task& task = tasks_[i - islands_.size()];
            if (task.shared) continue;
            if (!state_.bodies[moving_[task.first].slot].contacts.parts.empty()) {
                move_part(task, worker, scene, dt);
            } else if (moving_[task.first].undisturbed) {
                move_undisturbed(task, worker, scene, dt);
            } else if (task.count > 1) {
                move_beside_models<ropes_together>(&moving_[task.first], task.count, rooms_[worker], scene, dt);
            } else {
                move_through(moving_[task.first], worker, scene, dt);
            }
        }
    });
    each_divided([&](const ActiveBody& moving) { end_moving(state_.bodies[moving.slot], scene, dt, moving.substeps); });
    state_.seen.swap(next_seen_);
    add_impulses();
}

/// Sums the impulses of all bodies by model, in the order of the bodies. Uses reserved memory.
void Solver::add_impulses() {
    body_impulses_.clear();
    impulses_.clear();
    for (uint32_t slot = 0; slot < state_.ids.slots(); ++slot) {
        if (!state_.ids.live(slot)) continue;
        for (const ModelImpulse& given : state_.bodies[slot].contacts.impulses)
            body_impulses_.push_back({given.model, slot, &given});
    }
    std::sort(body_impulses_.begin(), body_impulses_.end());
    for (const BodyImpulse& given : body_impulses_) {
        if (impulses_.empty() || impulses_.back().model != given.model) {
            impulses_.push_back(*given.impulse);
        } else {
            impulses_.back().linear += given.impulse->linear;
            impulses_.back().angular += given.impulse->angular;
        }
    }
}

void Solver::advance(const Scene* scene, double frame_time, uint32_t& steps) {
    // Frame times and steps were float32, so six steps of 1/60 s may be slightly longer than 0.1 s. A missing millionth
    // of a step is ignored.
    const double owed = state_.owed + frame_time, length = state_.settings.fixed_step;
    const double due = std::floor(owed / length + 1e-6);
    const uint32_t wanted = static_cast<uint32_t>(std::min<double>(due, state_.settings.max_steps));
    for (steps = 0; steps < wanted; ++steps) {
        try {
            simulate(scene, length);
        } catch (const std::bad_alloc&) {
            if (steps == 0) throw;
            break;  // steps that were made cannot be undone, and are reported
        }
    }
    if (steps > 0) show_all();
    // For frame times of years, the difference is rounding.
    state_.owed = std::clamp(owed - due * length, 0.0, length);
}

}  // namespace gphys

// The step. Bodies that may influence each other are taken through all substeps together, by one of the
// workers (islands.cpp); most bodies are alone. A body alone moves like this:
//
//   free         exact flight and impacts                                    free_flight.cpp
//   direct       predict, solve chains as a whole, new velocities, collide,
//                solve again beside contacts                                 rope_substep.cpp
//                the same of chains that branch                              joined_motion.cpp
//   graph        predict, chain families, reach limits, velocities, collide  cloth.cpp
#include <cstring>

#include "solver/motion.h"
#include "solver/rope/rope.h"
#include "solver/solver.h"

namespace gphys {

void follow_models(Body& body, double fraction, double h, uint32_t first, uint32_t end) {
    const auto before = [](const Attachment& attachment, uint32_t p) { return attachment.particle < p; };
    auto attachment = std::lower_bound(body.attachments.begin(), body.attachments.end(), first, before);
    for (; attachment != body.attachments.end() && attachment->particle < end; ++attachment) {
        Vec3& position = body.position[attachment->particle];
        const Vec3 next = attachment->begin + (attachment->end - attachment->begin) * fraction;
        body.velocity[attachment->particle] = (next - position) / h;
        position = next;
    }
}

void move(Body& body, const Surroundings& around, Vec3 gravity, double h) {
    switch (body.plan.method) {
        case GPHYS_SOLVE_FREE:
            fly(body, around, gravity, h);
            break;
        case GPHYS_SOLVE_DIRECT:
            begin_friction(body, gravity);
            move_rope(body, around, gravity, h);
            end_friction(body);
            break;
        default:
            move_cloth(body, around, gravity, h);
    }
}

void begin_move(Body& body, const Surroundings& around, Vec3 gravity, double h) {
    switch (body.plan.method) {
        case GPHYS_SOLVE_FREE:
            fly(body, around, gravity, h);
            break;
        case GPHYS_SOLVE_DIRECT:
            begin_friction(body, gravity);
            begin_chains(body, around, gravity, TimeScheme(h, body.earlier_step));
            break;
        default:
            predict_cloth(body, around, h);
    }
}

void end_move(Body& body, const Surroundings& around, Vec3 gravity, double h) {
    switch (body.plan.method) {
        case GPHYS_SOLVE_FREE:
            break;
        case GPHYS_SOLVE_DIRECT:
            end_rope(body, around, gravity, TimeScheme(h, body.earlier_step));
            end_friction(body);
            break;
        default:
            end_cloth_substep(body, around, gravity, h);
    }
}

namespace {

/// Where attached particles go in this step; those whose model is gone are released.
void aim_attachments(Body& body, const Scene* scene) {
    for (Attachment& attachment : body.attachments) {
        attachment.begin = attachment.end = body.position[attachment.particle];
        if (scene && scene->has(attachment.model)) {
            attachment.end = scene->world_transform(attachment.model).apply(attachment.local);
        }
    }
    if (!scene) return;
    const auto lost = [&](const Attachment& attachment) {
        if (scene->has(attachment.model)) return false;
        body.inverse_mass[attachment.particle] = 1 / body.mass[attachment.particle];
        body.plan.reach_current = false;
        body.earlier_step = 0;
        return true;
    };
    body.attachments.erase(std::remove_if(body.attachments.begin(), body.attachments.end(), lost),
                           body.attachments.end());
}

void reserve_history(Body& body) {
    if (body.plan.method == GPHYS_SOLVE_FREE && !body.joined) return;
    body.start.resize(body.size());
    if (body.plan.method == GPHYS_SOLVE_GRAPH) {
        reserve_cloth(body);
        if (body.joined) reserve_joined_cloth(body);
        return;
    }
    body.predicted.resize(body.size());
    body.solved.resize(body.size());
    body.start_velocity.resize(body.size());
    if (body.plan.limited) body.flying.resize(body.size());
    body.earlier.resize(body.size());
    body.earlier_velocity.resize(body.size());
}

/// Whether its particles are shared by workers, whatever their number.
bool is_divided(const Body& body) {
    return body.plan.method == GPHYS_SOLVE_FREE && !body.joined && body.size() > part_size;
}

}  // namespace

/// Everything that may fail for want of memory, before anything moves.
void Solver::prepare(const Scene* scene, double dt) {
    moving_.clear();
    next_seen_.clear();
    moved_.clear();
    unite_bodies(scene, dt);
    for (uint32_t slot = 0; slot < state_.ids.slots(); ++slot) {
        if (!state_.ids.live(slot) || state_.bodies[slot].sleep.asleep) continue;
        Body& body = state_.bodies[slot];
        aim_attachments(body, scene);
        const bool changed = !body.plan.chains_current;
        if (changed) joints_current_ = false;
        update_plan(body);
        body.joined = body.joined || body.plan.branched;
        // What systems of joints have placed stays there.
        const bool relaxed = body.plan.method == GPHYS_SOLVE_GRAPH && !body.joined;
        body.cloth.most_strain = relaxed ? state_.settings.max_strain : 0;
        if (body.settings.self_collision && (changed || body.linked_begin.empty())) list_linked(body);
        reserve_history(body);
        if (body.largest_radius < 0) {
            const auto [smallest, largest] = std::minmax_element(body.radius.begin(), body.radius.end());
            body.smallest_radius = *smallest;
            body.largest_radius = *largest;
        }
        if (is_divided(body)) {
            const uint32_t parts = (body.size() + part_size - 1) / part_size;
            while (body.parts.size() < parts) body.parts.emplace_back(&memory);
        } else {
            body.parts.clear();
        }
        moving_.push_back({body.size(), slot, substeps_of(body, state_.settings, dt),
                           static_cast<uint32_t>(body.plan.chains.size()), is_plain_rope(body), starts_again(body)});
        if (scene && body.settings.layers != 0) {
            body.touches.resize(size_t{body.size()} * touches_per_particle);
            body.touch_count.resize(body.size());
            body.held.resize(body.size());
            if (body.settings.sticks()) body.stuck.resize(body.size());
            if (body.plan.method == GPHYS_SOLVE_GRAPH) reserve_cloth_contacts(body);
        }
    }
    if (!joints_current_) plan_joints();
    list_islands();
    particle_contacts_.reserve(state_.bodies, islands_, island_bodies_);
    if (scene) look_around(*scene, dt);
    std::sort(moving_.begin(), moving_.end());
    divide_work();
    state_.seen.reserve(next_seen_.capacity());  // they change places
    size_t given = 0;
    for (uint32_t slot = 0; slot < state_.ids.slots(); ++slot) given += state_.bodies[slot].impulses.capacity();
    givers_.reserve(given);
    impulses_.reserve(given);
}

/// Note where the models near the bodies stand, and which of them have moved since the last step.
void Solver::look_around(const Scene& scene, double dt) {
    stretches_.clear();
    for (uint32_t i = 0; i < moving_.size(); ++i) {
        Body& body = state_.bodies[moving_[i].slot];
        if (body.extent) continue;
        body.extent.emplace();
        for (uint32_t first = 0; first < body.size(); first += part_size) stretches_.push_back({i, first, {}});
    }
    workers_.run(static_cast<uint32_t>(stretches_.size()), [&](uint32_t i) {
        Stretch& stretch = stretches_[i];
        Body& body = state_.bodies[moving_[stretch.moving].slot];
        stretch.extent = extent_of(body, stretch.first, std::min(stretch.first + part_size, body.size()));
    });
    for (const Stretch& stretch : stretches_) {
        state_.bodies[moving_[stretch.moving].slot].extent->add(stretch.extent);
    }
    for (Moving& moving : moving_) {
        Body& body = state_.bodies[moving.slot];
        const double fastest = moving.fastest = length(body.extent->fastest);
        const Aabb box = body.extent->box;
        body.extent.reset();
        // Twice as far as a particle may come in this step, and a model in the next: what it can meet then.
        const double margin = 2 * dt * (fastest + dt * length(state_.settings.gravity)) + dt * fastest_model;
        const double room = 2 * body.largest_radius + margin;
        moving.nearby = bounds(Aabb{box.min - Vec3{room, room, room}, box.max + Vec3{room, room, room}});
    }
    for (Moving& moving : moving_) {
        const size_t before = next_seen_.size();
        scene.for_each_in_box(moving.nearby, state_.bodies[moving.slot].settings.layers, [&](gphys_model_id model) {
            // The box around a terrain or a turned slab holds bodies that are far from its surface.
            if (!scene.touches_box(model, moving.nearby)) return;
            next_seen_.push_back({model, scene.world(model)});
        });
        moving.models_near = static_cast<uint32_t>(next_seen_.size() - before);
        if (moving.models_near == 0) continue;
        moving.undisturbed = false;
        const uint32_t least = substeps_near_models(state_.bodies[moving.slot], state_.settings, moving.fastest, dt);
        moving.substeps = std::max(moving.substeps, least);
    }
    std::sort(next_seen_.begin(), next_seen_.end());
    const auto same = [](const PlacedModel& a, const PlacedModel& b) { return a.model == b.model; };
    next_seen_.erase(std::unique(next_seen_.begin(), next_seen_.end(), same), next_seen_.end());
    for (const PlacedModel& seen : state_.seen) {
        if (!scene.has(seen.model)) continue;
        const gphys_transform& now = scene.world(seen.model);
        if (std::memcmp(&now, &seen.world, sizeof now) != 0) moved_.push_back(seen);
    }
    for (const Moving& moving : moving_) {
        Body& body = state_.bodies[moving.slot];
        reserve_impulses(body, moving.models_near + moved_.size());
        if (body.plan.method == GPHYS_SOLVE_GRAPH) body.cloth_contacts.movers.reserve(moved_.size());
    }
    find_disturbed(scene);
}

/// A model that has moved disturbs what it came by, wherever it is now.
void Solver::find_disturbed(const Scene& scene) {
    for (const PlacedModel& before : moved_) {
        Box way;
        const bool bounded = way_of(scene, before, way);
        for (Moving& moving : moving_) {
            const uint32_t layers = scene.layers(before.model) & state_.bodies[moving.slot].settings.layers;
            if (layers != 0 && (!bounded || touch(way, moving.nearby))) moving.undisturbed = false;
        }
    }
}

/// Cloth that would keep the others waiting: more than a worker's part of all particles. With fewer links, what
/// two workers' caches have to tell each other between families takes most of the gain: two were seen to take
/// 0.64 times as long as one with 59 000 links, 0.75 times with 21 000. Where their cores are far apart, 200 ns
/// instead of 50, it was 1.2 times with 59 000.
bool Solver::is_worth_sharing(const Moving& moving, size_t particles) const {
    constexpr size_t least_links = 40000;
    const Plan& plan = state_.bodies[moving.slot].plan;
    return plan.method == GPHYS_SOLVE_GRAPH && plan.rest.size() >= least_links &&
           size_t{moving.size} * workers_.count() > particles;
}

/// Undisturbed ropes by eight, everything else body by body, but for what islands move.
void Solver::divide_work() {
    tasks_.clear();
    while (rooms_.size() < workers_.count()) rooms_.emplace_back(&room_memory_);
    size_t alone = 0, together = 0;  // nodes of the longest ropes
    size_t particles = 0;
    for (const Moving& moving : moving_) particles += moving.size;
    for (uint32_t i = 0, next; i < moving_.size(); i = next) {
        const Moving& first = moving_[i];
        next = i + 1;
        if (first.together) continue;
        if (first.undisturbed && first.size <= longest_rope_together) {
            while (next < moving_.size() && next - i < ropes_together && first.alike(moving_[next])) ++next;
        }
        const bool shared = workers_.count() > 1 && is_worth_sharing(first, particles);
        if (shared) {
            ClothBatches& batches = state_.bodies[first.slot].plan.batches;
            batches.rows.resize(size_t{cloth_row_floats} * batches.longest * workers_.count());
        }
        const uint32_t parts = static_cast<uint32_t>(state_.bodies[first.slot].parts.size());
        for (uint32_t part = 0; part < parts; ++part) tasks_.push_back({i, 1, false, part});
        if (parts == 0) tasks_.push_back({i, next - i, shared, 0});
        if (state_.bodies[first.slot].plan.method != GPHYS_SOLVE_DIRECT) continue;
        alone = std::max<size_t>(alone, first.size);
        if (next - i > 1) together = std::max<size_t>(together, first.size);
    }
    for (RopeRoom& room : rooms_) {
        if (room.one.size() < alone) room.one.resize(alone);
        if (room.eight.size() < together) room.eight.resize(together);
    }
}

/// Before and after all substeps of one body that is moved alone.
void Solver::begin_moving(const Moving& moving, const Scene* scene, double dt) {
    Body& body = state_.bodies[moving.slot];
    body.impulses.clear();
    give_attached(body, {scene, &moved_, dt, 0, 0}, 1, {}, 0);
}

void Solver::end_moving(const Moving& moving, const Scene* scene, double dt, uint32_t substeps) {
    Body& body = state_.bodies[moving.slot];
    add_parts(body);
    for (const FlightPart& part : body.parts) {
        if (!body.extent) body.extent.emplace();
        body.extent->add(part.extent);
    }
    meet_targets(body, state_.settings, dt, substeps);
    give_attached(body, {scene, &moved_, dt, 0, 1}, -1, state_.settings.gravity, dt);
    rest(body, scene, state_.settings, dt);
}

/// In so many, or more if the first show that these are too long. Returns how many it were.
uint32_t Solver::move_in_substeps(Body& body, uint32_t count, const Surroundings& step) {
    Surroundings rest = step;
    uint32_t made = 0;
    for (uint32_t i = 0; i < count;) {
        const Surroundings part = part_of_step(rest, i++, count);
        move(body, part, state_.settings.gravity, step.step_time * (rest.end - rest.begin) / count);
        ++made;
        const uint32_t wanted = substeps_of_rest(body, state_.settings, step.step_time, part.end, made);
        if (wanted <= count - i) continue;
        rest.begin = part.end;
        count = wanted;
        i = 0;
    }
    return made;
}

/// All substeps of one body. Touches nothing of other bodies, allocates nothing.
void Solver::move_through(const Moving& moving, RopeRoom& room, const Scene* scene, double dt) {
    Body& body = state_.bodies[moving.slot];
    const Vec3 gravity = state_.settings.gravity;
    const Surroundings whole{scene, &moved_, dt, 0, 1}, beginning{scene, &moved_, dt, 0, 0};
    uint32_t substeps = moving.substeps;
    begin_moving(moving, scene, dt);
    body.in_stages = false;
    if (body.plan.method == GPHYS_SOLVE_FREE) {
        body.extent = fly_through(body, 0, body.size(), {body.impulses, body.touched}, whole, gravity, substeps);
    } else {
        begin_touches(body);
        if (body.plan.method == GPHYS_SOLVE_GRAPH) begin_cloth(body, beginning, gravity);
        if (body.plan.method == GPHYS_SOLVE_DIRECT) choose_stages(body, room, {gravity, dt, substeps, false});
        substeps = move_in_substeps(body, substeps, whole);
        if (body.plan.method == GPHYS_SOLVE_GRAPH) end_cloth(body, whole);
        end_touches(body);
    }
    end_moving(moving, scene, dt, substeps);
}

/// The same of a part of a body, between its beginning and its end.
void Solver::move_part(const Task& task, const Scene* scene, double dt) {
    const Moving& moving = moving_[task.first];
    Body& body = state_.bodies[moving.slot];
    FlightPart& part = body.parts[task.part];
    const uint32_t first = task.part * part_size, end = std::min(first + part_size, body.size());
    part.extent = fly_through(body, first, end, {part.impulses, part.touched}, {scene, &moved_, dt, 0, 1},
                              state_.settings.gravity, moving.substeps);
}

void Solver::move_undisturbed(const Task& task, RopeRoom& room, const Scene* scene, double dt) {
    UndisturbedRope ropes[ropes_together];
    const Moving* const first = &moving_[task.first];
    for (uint32_t i = 0; i < task.count; ++i) {
        Body& body = state_.bodies[first[i].slot];
        ropes[i] = {&body, scene && body.settings.layers != 0 ? &first[i].nearby : nullptr, false};
    }
    move_ropes(ropes, task.count, room, {state_.settings.gravity, dt, first->substeps, state_.settings.tolerance > 0});
    for (uint32_t i = 0; i < task.count; ++i) {
        if (!ropes[i].stayed) {
            move_through(first[i], room, scene, dt);
            continue;
        }
        Body& body = *ropes[i].body;
        clear_touches(body);
        std::fill(body.stuck.begin(), body.stuck.end(), 0u);
        body.impulses.clear();
        meet_targets(body, state_.settings, dt, first->substeps);
        rest(body, scene, state_.settings, dt);
    }
}

void Solver::move_shared(const Moving& moving, const Scene* scene, double dt) {
    Team team;
    ClothState& cloth = state_.bodies[moving.slot].cloth;
    cloth.team = &team;
    workers_.run(workers_.count(), [&](uint32_t) { team.join([&] { move_through(moving, rooms_[0], scene, dt); }); });
    cloth.team = nullptr;
}

void Solver::step(const Scene* scene, double dt) {
    prepare(scene, dt);
    const auto each_divided = [&](auto&& visit) {
        for (const Moving& moving : moving_) {
            if (!moving.together && !state_.bodies[moving.slot].parts.empty()) visit(moving);
        }
    };
    each_divided([&](const Moving& moving) { begin_moving(moving, scene, dt); });
    for (const Task& task : tasks_) {
        if (task.shared) move_shared(moving_[task.first], scene, dt);
    }
    // A worker keeps its room while it takes one task after the other.
    std::atomic<size_t> next{0};
    workers_.run(workers_.count(), [&](uint32_t worker) {
        for (size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < islands_.size() + tasks_.size();) {
            if (i < islands_.size()) {
                move_island(islands_[i], scene, dt);
                continue;
            }
            const Task& task = tasks_[i - islands_.size()];
            if (task.shared) continue;
            if (!state_.bodies[moving_[task.first].slot].parts.empty()) {
                move_part(task, scene, dt);
            } else if (moving_[task.first].undisturbed) {
                move_undisturbed(task, rooms_[worker], scene, dt);
            } else {
                move_through(moving_[task.first], rooms_[worker], scene, dt);
            }
        }
    });
    each_divided([&](const Moving& moving) { end_moving(moving, scene, dt, moving.substeps); });
    state_.seen.swap(next_seen_);
    add_impulses();
}

/// The sums of all bodies by model, in the order of the bodies. Within the room that is reserved.
void Solver::add_impulses() {
    givers_.clear();
    impulses_.clear();
    for (uint32_t slot = 0; slot < state_.ids.slots(); ++slot) {
        if (!state_.ids.live(slot)) continue;
        for (const ModelImpulse& given : state_.bodies[slot].impulses) givers_.push_back({given.model, slot, &given});
    }
    std::sort(givers_.begin(), givers_.end());
    for (const Giver& giver : givers_) {
        if (impulses_.empty() || impulses_.back().model != giver.model) {
            impulses_.push_back(*giver.impulse);
        } else {
            impulses_.back().linear += giver.impulse->linear;
            impulses_.back().angular += giver.impulse->angular;
        }
    }
}

void Solver::advance(const Scene* scene, double frame_time, uint32_t& steps, double& leftover) {
    state_.owed += frame_time;
    // Frames and steps came as float32, so six steps of a 60th may be a hair longer than a tenth: a
    // millionth of a step is not waited for.
    const double due = std::floor(state_.owed / state_.settings.fixed_step + 1e-6);
    steps = static_cast<uint32_t>(std::min<double>(due, state_.settings.max_steps));
    for (uint32_t i = 0; i < steps; ++i) step(scene, state_.settings.fixed_step);
    state_.owed = std::max(0.0, state_.owed - due * state_.settings.fixed_step);
    leftover = state_.owed / state_.settings.fixed_step;
}

}  // namespace gphys

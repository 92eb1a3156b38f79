// The first phase of a step: plans, memory, nearby models and tasks are prepared before anything moves.
//
// All memory is allocated here, so that a step without memory fails before it changes anything that a snapshot holds.
// What must change earlier is saved in Before and restored if an allocation fails. Sizes and states that a snapshot
// holds change last, in begin_step, which cannot fail.
//
// Tasks are sorted by size, the largest first (longest processing time first; Graham 1969). Workers take them from one
// counter, so that none begins a large body when the others are done.
#include <cstring>

#include "solver/contact/collision.h"
#include "solver/joints/joined_motion.h"
#include "solver/motion.h"
#include "solver/particles/free_flight.h"
#include "solver/rope/rope.h"
#include "solver/solver.h"

namespace gphys {

namespace {

bool is_lost(const Attachment& attachment, const Scene* scene) { return scene && !scene->has(attachment.model); }

bool has_lost(const Constraints& constraints, const Scene* scene) {
    return std::any_of(constraints.attachments.begin(), constraints.attachments.end(),
                       [&](const Attachment& attachment) { return is_lost(attachment, scene); });
}

/// Releases attached particles whose model no longer exists.
void release_lost(Body& body, const Scene* scene) {
    const auto lost = [&](const Attachment& attachment) {
        if (!is_lost(attachment, scene)) return false;
        body.particles.inverse_mass[attachment.particle] = 1 / body.particles.mass[attachment.particle];
        return true;
    };
    body.constraints.attachments.erase(
        std::remove_if(body.constraints.attachments.begin(), body.constraints.attachments.end(), lost),
        body.constraints.attachments.end());
    body.plan.reach_current = false;
    body.history.earlier_step = 0;
}

/// Sets the beginning and the end of the motion of attached particles in this step.
void aim_attachments(Body& body, const Scene* scene) {
    for (Attachment& attachment : body.constraints.attachments) {
        attachment.begin = attachment.end = body.particles.position[attachment.particle];
        if (!scene) continue;
        Vec3 ignored;
        attachment.end = scene->world_transform(attachment.model).apply(attachment.local);
        keep_in_range(attachment.end, ignored);
    }
}

/// Calls visit(array, size) for the arrays that steps keep and snapshots hold.
template <class Visit>
void each_kept_array(Body& body, bool collides, Visit&& visit) {
    if (body.plan.method != GPHYS_SOLVE_FREE || body.plan.joined) {
        visit(body.history.start, body.particles.size());
        if (is_graph(body)) {
            const size_t floats = cloth_floats(body.particles.size(), body.cloth.batches.spare);
            visit(body.cloth.state.moved, floats);
            visit(body.cloth.state.velocity_before, floats);
        } else {
            visit(body.history.start_velocity, body.particles.size());
        }
    }
    if (!collides) return;
    visit(body.contacts.points, size_t{body.particles.size()} * contact_points_per_particle);
    if (body.settings.sticks()) visit(body.contacts.stuck, body.particles.size());
}

/// Allocates the arrays of a body that the step uses.
void make_room(Body& body, bool collides) {
    each_kept_array(body, collides, [](auto& values, size_t size) { values.reserve(size); });
    if (collides) body.contacts.point_count.resize(body.particles.size());
    // Steps without a scene read which particles stick, too.
    if (collides || !body.contacts.stuck.empty()) body.contacts.held.resize(body.particles.size());
    if (is_graph(body)) {
        reserve_cloth(body, collides);
    } else if (body.plan.method != GPHYS_SOLVE_FREE || body.plan.joined) {
        body.history.predicted.resize(body.particles.size());
        body.rope.solved.resize(body.particles.size());
        if (body.plan.limited) body.rope.flying.resize(body.particles.size());
        body.history.earlier.resize(body.particles.size());
        body.history.earlier_velocity.resize(body.particles.size());
    }
}

/// Whether the particles are divided into parts, one task each. Does not depend on the number of workers.
bool is_divided(const Body& body) {
    return body.plan.method == GPHYS_SOLVE_FREE && !body.plan.joined && body.particles.size() > part_size;
}

}  // namespace

/// Allocates everything that the step needs. Throws std::bad_alloc; then nothing in snapshots has changed.
void Solver::prepare(const Scene* scene, double dt) {
    before_.clear();
    try {
        moving_.clear();
        next_seen_.clear();
        moved_.clear();
        unite_bodies(scene, dt);
        for (uint32_t slot = 0; slot < state_.ids.slots(); ++slot) {
            if (state_.ids.live(slot) && awake_[set_of_[slot]]) prepare_body(slot, scene, dt);
        }
        if (!joints_current_) plan_joints();
        list_islands();
        particle_contacts_.reserve(state_.bodies, islands_, island_bodies_);
        if (scene) list_near_models(*scene, dt);
        bound_work(dt);
        std::sort(moving_.begin(), moving_.end());
        divide_work();
        if (scene) make_room_for_flight();
        state_.seen.reserve(next_seen_.capacity());  // the two are swapped
        size_t given = 0;
        for (uint32_t slot = 0; slot < state_.ids.slots(); ++slot)
            given += state_.bodies[slot].contacts.impulses.capacity();
        body_impulses_.reserve(given);
        impulses_.reserve(given);
    } catch (...) {
        for (Before& before : before_) before.put_back(state_.bodies[before.slot]);
        throw;
    }
}

void Solver::prepare_body(uint32_t slot, const Scene* scene, double dt) {
    Body& body = state_.bodies[slot];
    Plan& plan = body.plan;
    const bool lost = has_lost(body.constraints, scene), changed = !plan.chains_current;
    if (lost || changed || !plan.reach_current) {
        // Made complete before it is added to the list, because copying its parts may throw.
        Before before(slot, body, &memory);
        if (lost) before.attachments = body.constraints.attachments;
        before_.push_back(std::move(before));
    }
    if (lost) {
        before_.back().reach_limits.swap(body.cloth.reach.limits);
        release_lost(body, scene);
    }
    if (changed) joints_current_ = false;
    update_plan(body);
    if (!body.constraints.length_changes.empty()) find_changed_links(body);
    body.plan.joined = body.plan.joined || plan.branched;
    // Relaxation would move particles away from where a system of joints has placed them.
    const bool relaxed = is_graph(body) && !body.plan.joined;
    const double most_strain = state_.settings.max_strain > 0 ? state_.settings.max_strain : usual_cloth_strain;
    body.cloth.relaxation.most_strain = relaxed ? most_strain : 0;
    body.cloth.relaxation.braces_yield = state_.settings.max_strain == 0;
    if (body.settings.self_collision && (changed || body.contacts.self.linked_begin.empty())) list_linked(body);
    make_room(body, scene && body.settings.layers != 0);
    reserve_air(body);
    reserve_targets(body);
    // Falling asleep has set the speeds to 0, so the stored bounds are out of date.
    if (body.sleep.asleep) body.particles.extent.reset();
    if (body.particles.largest_radius < 0) {
        const auto [smallest, largest] =
            std::minmax_element(body.particles.radius.begin(), body.particles.radius.end());
        body.particles.smallest_radius = *smallest;
        body.particles.largest_radius = *largest;
    }
    if (is_divided(body)) {
        const uint32_t parts = (body.particles.size() + part_size - 1) / part_size;
        while (body.contacts.parts.size() < parts) body.contacts.parts.emplace_back(&memory);
    } else {
        body.contacts.parts.clear();
    }
    moving_.push_back({body.particles.size(), slot, substeps_of(body, state_.settings, dt),
                       static_cast<uint32_t>(plan.chains.size()), is_plain_rope(body), is_plain_rope(body),
                       starts_again(body)});
}

void Solver::Before::put_back(Body& body) {
    body.plan.chains_current = chains_current;
    body.plan.reach_current = reach_current;
    if (attachments.empty()) return;
    body.plan.pins_packed = false;
    body.cloth.reach.limits.swap(reach_limits);
    body.constraints.attachments.swap(attachments);
    for (const Attachment& attachment : body.constraints.attachments)
        body.particles.inverse_mass[attachment.particle] = 0;
    body.history.earlier_step = earlier_step;
}

/// Uses reserved memory only.
void Solver::begin_step(const Scene* scene) noexcept {
    for (const ActiveBody& moving : moving_) {
        Body& body = state_.bodies[moving.slot];
        if (body.sleep.asleep) wake(body);
        body.plan.edits = 0;
        aim_attachments(body, scene);
        begin_targets(body);
        each_kept_array(body, scene && body.settings.layers != 0,
                        [](auto& values, size_t size) { values.resize(size); });
    }
}

/// Broad phase: lists the models near the bodies with their transforms, and those that have moved since the last step.
void Solver::list_near_models(const Scene& scene, double dt) {
    ranges_.clear();
    for (uint32_t i = 0; i < moving_.size(); ++i) {
        Body& body = state_.bodies[moving_[i].slot];
        if (body.particles.extent) continue;
        for (uint32_t first = 0; first < body.particles.size(); first += part_size) ranges_.push_back({i, first, {}});
    }
    workers_.run(static_cast<uint32_t>(ranges_.size()), [&](uint32_t i) {
        ParticleRange& range = ranges_[i];
        Body& body = state_.bodies[moving_[range.moving].slot];
        range.extent = extent_of(body, range.first, std::min(range.first + part_size, body.particles.size()));
    });
    for (const ParticleRange& range : ranges_) {
        std::optional<Extent>& extent = state_.bodies[moving_[range.moving].slot].particles.extent;
        if (!extent) extent.emplace();
        extent->add(range.extent);
    }
    for (ActiveBody& moving : moving_) {
        Body& body = state_.bodies[moving.slot];
        const double fastest = moving.fastest = length(body.particles.extent->fastest);
        const Aabb box = body.particles.extent->box;
        body.particles.extent.reset();
        // Twice the distance that a particle can move in this step. `nearby` adds the distance that a model can move.
        const double way = 2 * body.particles.largest_radius +
                           2 * dt * (fastest + dt * length(state_.settings.gravity)) + way_to_targets(body);
        const auto within = [&](double room) {
            return bounds(Aabb{box.min - Vec3{room, room, room}, box.max + Vec3{room, room, room}});
        };
        moving.close = within(way);
        moving.nearby = within(way + dt * fastest_model);
    }
    for (ActiveBody& moving : moving_) {
        const size_t before = next_seen_.size();
        scene.for_each_in_box(moving.nearby, state_.bodies[moving.slot].settings.layers, [&](gphys_model_id model) {
            // The box of a terrain or of a rotated slab contains bodies that are far from its surface.
            if (!scene.overlaps_box(model, moving.nearby)) return;
            next_seen_.push_back({model, scene.world(model)});
            // find_disturbed handles models that have moved.
            if (moving.undisturbed && scene.overlaps_box(model, moving.close)) moving.undisturbed = false;
        });
        moving.models_near = static_cast<uint32_t>(next_seen_.size() - before);
        if (moving.models_near == 0) continue;
        const uint32_t least =
            substeps_near_models(state_.bodies[moving.slot].cloth, state_.settings, moving.fastest, dt);
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
    for (const ActiveBody& moving : moving_) {
        Body& body = state_.bodies[moving.slot];
        reserve_impulses(body, moving.models_near + moved_.size());
        if (body.plan.method == GPHYS_SOLVE_GRAPH) body.cloth.moving_colliders.reserve(moved_.size());
    }
    find_disturbed(scene);
}

/// Keeps the sum of substeps times particles below max_work: if it is larger, all bodies get fewer substeps in
/// proportion. Bodies of an island take as many substeps as the one that needs the most.
void Solver::bound_work(double dt) {
    const uint32_t most = state_.settings.max_work;
    for (const ActiveBody& moving : moving_) {
        state_.bodies[moving.slot].substeps.allowed = most > 0 ? moving.substeps : std::numeric_limits<uint32_t>::max();
    }
    if (most == 0) return;
    for (const Island& island : islands_) {
        const uint32_t* const slots = &island_bodies_[island.first_body];
        uint32_t needed = 1;
        for (uint32_t i = 0; i < island.body_count; ++i) {
            needed = std::max(needed, state_.bodies[slots[i]].substeps.allowed);
        }
        for (uint32_t i = 0; i < island.body_count; ++i) state_.bodies[slots[i]].substeps.allowed = needed;
    }
    double work = 0;
    for (const ActiveBody& moving : moving_) {
        work += static_cast<double>(state_.bodies[moving.slot].substeps.allowed) * moving.size;
    }
    const double kept = work > most ? most / work : 1;
    for (ActiveBody& moving : moving_) {
        Body& body = state_.bodies[moving.slot];
        const uint32_t least = least_substeps(body, dt);
        body.substeps.allowed = std::max(least, static_cast<uint32_t>(body.substeps.allowed * kept));
        moving.substeps = std::min(moving.substeps, body.substeps.allowed);
    }
}

/// Marks bodies near the path of a model that has moved.
void Solver::find_disturbed(const Scene& scene) {
    for (const PlacedModel& before : moved_) {
        Box way;
        const bool bounded = way_of(scene, before, way);
        for (ActiveBody& moving : moving_) {
            const uint32_t layers = scene.layers(before.model) & state_.bodies[moving.slot].settings.layers;
            if (layers != 0 && (!bounded || overlaps(way, moving.nearby))) {
                moving.undisturbed = false;
                moving.models_move = true;
            }
        }
    }
}

/// Whether all workers should move a cloth together: if it has more than a worker's share of all particles. For cloth
/// with fewer links, synchronisation between colours takes most of the gain. Two workers took 0.64 of the time of one
/// with 59 000 links and 0.75 with 21 000; on cores with a latency of 200 ns instead of 50, 1.2 with 59 000.
bool Solver::is_worth_sharing(const ActiveBody& moving, size_t particles) const {
    constexpr size_t least_links = 40000;
    const Plan& plan = state_.bodies[moving.slot].plan;
    return plan.method == GPHYS_SOLVE_GRAPH && plan.rest.size() >= least_links &&
           size_t{moving.size} * workers_.count() > particles;
}

void Solver::make_room_for_flight() {
    const auto flies = [&](const ActiveBody& moving) {
        return state_.bodies[moving.slot].plan.method == GPHYS_SOLVE_FREE;
    };
    if (flight_planes_.size() >= workers_.count() || std::none_of(moving_.begin(), moving_.end(), flies)) return;
    Vector<FlightPlanes> made(workers_.count(), flight_planes_.get_allocator());
    flight_planes_.swap(made);
}

/// Makes the tasks: eight undisturbed ropes each, larger groups of ropes that may touch models, or one body, or a part
/// of a body. Islands are tasks of their own.
void Solver::divide_work() {
    tasks_.clear();
    while (rooms_.size() < workers_.count()) rooms_.emplace_back(&room_memory_);
    size_t alone = 0, together = 0, beside = 0;  // nodes of the longest ropes
    const auto touching = std::count_if(moving_.begin(), moving_.end(),
                                        [](const ActiveBody& moving) { return moving.touches() && !moving.together; });
    // Lanes are idle at the end of a group, workers at the end of a step.
    const uint32_t in_group =
        std::clamp(static_cast<uint32_t>(touching) / (4 * workers_.count()), ropes_together, 8 * ropes_together);
    size_t particles = 0;
    for (const ActiveBody& moving : moving_) particles += moving.size;
    for (uint32_t i = 0, next; i < moving_.size(); i = next) {
        const ActiveBody& first = moving_[i];
        next = i + 1;
        if (first.together) continue;
        if (first.undisturbed && first.size <= longest_rope_together) {
            while (next < moving_.size() && next - i < ropes_together && first.alike(moving_[next])) ++next;
        } else if (first.touches()) {
            const auto joins = [&](const ActiveBody& rope) { return rope.touches() && !rope.together; };
            while (next < moving_.size() && next - i < in_group && joins(moving_[next])) ++next;
            if (next - i > 1) beside = std::max<size_t>(beside, first.size);
        }
        const bool shared = workers_.count() > 1 && is_worth_sharing(first, particles);
        if (shared) {
            ClothBatches& batches = state_.bodies[first.slot].cloth.batches;
            batches.rows.resize(size_t{cloth_row_floats} * batches.longest * workers_.count());
        }
        const uint32_t parts = static_cast<uint32_t>(state_.bodies[first.slot].contacts.parts.size());
        for (uint32_t part = 0; part < parts; ++part) tasks_.push_back({i, 1, false, part});
        if (parts == 0) tasks_.push_back({i, next - i, shared, 0});
        if (state_.bodies[first.slot].plan.method != GPHYS_SOLVE_DIRECT) continue;
        alone = std::max<size_t>(alone, first.size);
        if (next - i > 1) together = std::max<size_t>(together, first.size);
    }
    for (RopeRoom& room : rooms_) room.reserve(alone, together, beside);
}

}  // namespace gphys

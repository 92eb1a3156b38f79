// The first phase of a step: it plans, reserves memory, finds nearby models (broad phase) and makes the tasks.
//
// All memory is allocated here, so a step that lacks memory fails before it changes anything that a snapshot holds.
// What must change earlier is saved in Undo and restored if an allocation fails. Sizes and states that a snapshot
// holds change last, in begin_step, which cannot fail.
//
// Tasks are sorted by size, the largest first (longest processing time first; Graham 1969). Workers take them from one
// counter, so that none begins a large body when the others are done.
#include <cstring>

#include "solver/contact/collision.h"
#include "solver/contact/neighbourhood.h"
#include "solver/joints/joined_motion.h"
#include "solver/motion.h"
#include "solver/particles/free_flight.h"
#include "solver/rope/rope.h"
#include "solver/rope/rope_start.h"
#include "solver/solver.h"

namespace gphys {
namespace {

bool is_dangling(const Attachment& attachment, const Scene* scene) {
    return scene && attachment.model != 0 && !scene->has(attachment.model);
}

bool has_dangling(const Constraints& constraints, const Scene* scene) {
    return std::any_of(constraints.attachments.begin(), constraints.attachments.end(),
                       [&](const Attachment& attachment) { return is_dangling(attachment, scene); });
}

/// Releases attached particles whose model no longer exists.
void release_dangling(Body& body, const Scene* scene) {
    const auto dangling = [&](const Attachment& attachment) {
        if (!is_dangling(attachment, scene)) return false;
        body.particles.inverse_mass[attachment.particle] = 1 / body.particles.mass[attachment.particle];
        return true;
    };
    body.constraints.attachments.erase(
        std::remove_if(body.constraints.attachments.begin(), body.constraints.attachments.end(), dangling),
        body.constraints.attachments.end());
    body.plan.reach_current = false;
    body.history.earlier_step = 0;
}

/// Sets the beginning and the end of the motion of attached particles in this step.
void aim_attachments(Constraints& constraints, Particles& particles, const Scene* scene) {
    for (Attachment& attachment : constraints.attachments) {
        if (attachment.model == 0) {
            particles.position[attachment.particle] = attachment.begin;
            continue;
        }
        attachment.begin = attachment.end = particles.position[attachment.particle];
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

/// Allocates the arrays that the step uses of a body.
void reserve_arrays(Body& body, bool collides) {
    each_kept_array(body, collides, [](auto& values, size_t size) { values.reserve(size); });
    if (collides) body.contacts.point_count.resize(body.particles.size());
    // Steps without a scene read which particles stick, too.
    if (collides || !body.contacts.stuck.empty()) body.contacts.held.resize(body.particles.size());
    if (is_graph(body)) {
        reserve_cloth(body, collides);
    } else if (body.plan.method != GPHYS_SOLVE_FREE || body.plan.joined) {
        body.history.predicted.resize(body.particles.size());
        body.rope.solved.resize(body.particles.size());
        if (body.plan.limited) body.rope.slack.resize(body.particles.size());
        body.history.earlier.resize(body.particles.size());
        body.history.earlier_velocity.resize(body.particles.size());
        if (body.settings.body_layers != 0) {
            body.rope.loads.all.reserve(8 + body.particles.size());
            body.rope.loads.heavy.reserve(4 + body.particles.size() / 8);
        }
    }
}

/// Divides free particles into parts of that size, if these are several. Does not depend on the number of workers.
uint32_t divide(Body& body, uint32_t size, std::pmr::memory_resource* memory) {
    const bool divided = body.plan.method == GPHYS_SOLVE_FREE && !body.plan.joined && body.particles.size() > size;
    const uint32_t count = divided ? (body.particles.size() + size - 1) / size : 0;
    Vector<FlightPart>& parts = body.contacts.parts;
    while (parts.size() > count) parts.pop_back();
    while (parts.size() < count) parts.emplace_back(memory);
    return count;
}

}  // namespace

/// Allocates everything that the step needs. Throws std::bad_alloc; then nothing in snapshots has changed.
void Solver::prepare(const Scene* scene, double dt) {
    undo_.clear();
    try {
        active_.clear();
        next_near_models_.clear();
        moved_models_.clear();
        unite_bodies(scene, dt);
        for (const uint32_t slot : state_.ids) {
            if (awake_[set_of_[slot]]) prepare_body(slot, scene, dt);
        }
        if (!joints_current_) plan_joints();
        list_islands();
        for (Island& island : islands_) island.beside_joints = &beside_joints_;
        particle_contacts_.reserve(state_.bodies, islands_, island_bodies_);
        divide_bodies();
        if (scene) list_near_models(*scene, dt);
        limit_work(dt);
        std::sort(active_.begin(), active_.end());
        make_tasks();
        if (scene) reserve_flight_planes();
        if (scene) reserve_collision_memory();
        state_.near_models.reserve(next_near_models_.capacity());  // the two are swapped
        size_t impulse_count = 0;
        for (const Body& body : state_.bodies) impulse_count += body.contacts.impulses.capacity();
        impulse_sums_.reserve(impulse_count);
        reserve_breaks();
    } catch (...) {
        for (Undo& undo : undo_) undo.apply(state_.bodies[undo.slot]);
        throw;
    }
}

void Solver::prepare_body(uint32_t slot, const Scene* scene, double dt) {
    Body& body = state_.bodies[slot];
    Plan& plan = body.plan;
    body.steady.found = false;
    const bool dangling = has_dangling(body.constraints, scene), changed = !plan.chains_current;
    if (dangling || changed || !plan.reach_current) {
        // Complete before it is added to the list, because copying its parts may throw.
        Undo undo(slot, body, &memory);
        if (dangling) undo.attachments = body.constraints.attachments;
        undo_.push_back(std::move(undo));
    }
    if (dangling) {
        undo_.back().reach_limits.swap(body.cloth.reach.limits);
        release_dangling(body, scene);
    }
    if (changed || std::exchange(body.cloth.clusters.changed, false)) joints_current_ = false;
    update_plan(body);
    if (!body.constraints.length_changes.empty()) find_changed_links(body);
    body.plan.joined = body.plan.joined || plan.branched;
    const double most_strain = state_.settings.max_strain > 0 ? state_.settings.max_strain : usual_cloth_strain;
    body.cloth.relaxation.most_strain = is_graph(body) ? most_strain : 0;
    body.cloth.relaxation.braces_yield = state_.settings.max_strain == 0;
    if (body.settings.self_collision && (changed || body.contacts.self.linked_begin.empty())) list_linked(body);
    reserve_arrays(body, scene && body.settings.layers != 0);
    reserve_breaking(body);
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
    active_.push_back({body.particles.size(), slot, substeps_of(body, state_.settings, dt),
                       static_cast<uint32_t>(plan.chains.size()), 0, is_plain_rope(body),
                       is_plain_rope(body) && !starts_misplaced(body), restarts(body.history, body.contacts)});
}

void Solver::Undo::apply(Body& body) {
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

/// Makes the parts of bodies: tasks of their own, or in large islands of particles that collide.
void Solver::divide_bodies() {
    for (ActiveBody& active : active_) {
        if (!active.in_island) active.parts = divide(state_.bodies[active.slot], part_size, &memory);
    }
    for (const Island& island : islands_) {
        const bool divided = ParticleContacts::has_groups(island.colliding_count);
        const uint32_t size = divided ? part_size_in_island : std::numeric_limits<uint32_t>::max();
        for (uint32_t i = 0; i < island.body_count; ++i)
            divide(state_.bodies[island_bodies_[island.first_body + i]], size, &memory);
    }
}

/// Uses reserved memory only.
void Solver::begin_step(const Scene* scene) noexcept {
    for (const ActiveBody& active : active_) {
        Body& body = state_.bodies[active.slot];
        if (body.sleep.asleep) {
            // What has woken it need not reach it (begin_settling).
            const double settling = body.sleep.settling;
            wake(body);
            body.sleep.settling = settling;
        }
        if (active.in_island) body.steady.place = body.steady.state = 0;  // not compared after this step
        body.plan.edits = 0;
        if (active.jumps) move_rigidly(body, *motion_of_jump(body, *scene, state_.near_models, model_time_));
        aim_attachments(body.constraints, body.particles, scene);
        begin_targets(body);
        begin_loads(body);
        each_kept_array(body, scene && body.settings.layers != 0,
                        [](auto& values, size_t size) { values.resize(size); });
    }
    particle_contacts_.begin_step(state_.ids, state_.bodies, islands_);
}

/// Memory for what free particles find near models, and the hash of the models near them that do not move.
static void reserve_balls(Body& body, const Scene& scene, const Vector<MovedModel>& moved, const Box& search_box,
                          bool keep) {
    if (body.plan.method != GPHYS_SOLVE_FREE || !keep) {
        body.flight.all.clear();
        return;
    }
    if (body.flight.all.size() != body.particles.size()) body.flight.forget();
    body.flight.all.resize(body.particles.size());
    uint64_t sum = 0;
    scene.for_each_in_box(search_box, body.settings.layers, [&](gphys_model_id model) {
        if (!find_moved(moved, model)) sum += hash_of(scene, model);
    });
    body.flight.surroundings = sum | 1;  // 0: not known
}

/// How far pinned particles go in the step.
static double way_to_models(const Body& body, const Scene& scene) {
    double longest = 0;
    for (const Attachment& attachment : body.constraints.attachments) {
        if (attachment.model == 0) {
            longest = std::max(longest, distance(attachment.begin, attachment.end));
            continue;
        }
        const Vec3 there = scene.world_transform(attachment.model).apply(attachment.local);
        longest = std::max(longest, distance(body.particles.position[attachment.particle], there));
    }
    return longest;
}

/// Adds a model to those whose places are known in the next step.
void Solver::see(const Scene& scene, gphys_model_id model) {
    next_near_models_.push_back({model, scene.world(model), {}});
}

/// Those that are not yet among next_near_models_ from `first` on.
void Solver::see_attached_models(const Scene* scene, const Constraints& constraints, size_t first) {
    if (!scene) return;
    gphys_model_id last = 0;
    for (const Attachment& attachment : constraints.attachments) {
        if (attachment.model == last || !scene->has(attachment.model)) continue;
        last = attachment.model;
        const auto is_same = [&](const PlacedModel& near) { return near.model == last; };
        if (std::any_of(next_near_models_.begin() + static_cast<std::ptrdiff_t>(first), next_near_models_.end(),
                        is_same))
            continue;
        see(*scene, last);
    }
}

/// Those near bodies that have moved since the last step. One that has jumped is as if it had always been there.
void Solver::list_moved_models(const Scene& scene) {
    for (const PlacedModel& before : state_.near_models) {
        if (!scene.has(before.model)) continue;
        const gphys_transform& now = scene.world(before.model);
        if (std::memcmp(&now, &before.world, sizeof now) == 0 || has_jumped(scene, before, model_time_)) continue;
        moved_models_.emplace_back(scene, before);
    }
}

/// The broad phase: lists the models near the bodies with their transforms, and those that have moved since the last
/// step.
void Solver::list_near_models(const Scene& scene, double dt) {
    ranges_.clear();
    for (uint32_t i = 0; i < active_.size(); ++i) {
        Body& body = state_.bodies[active_[i].slot];
        if (body.particles.extent) continue;
        for (uint32_t first = 0; first < body.particles.size(); first += part_size) ranges_.push_back({i, first, {}});
    }
    workers_.run(static_cast<uint32_t>(ranges_.size()), [&](uint32_t i) {
        ParticleRange& range = ranges_[i];
        Body& body = state_.bodies[active_[range.active].slot];
        range.extent = extent_of(body, range.first, std::min(range.first + part_size, body.particles.size()));
    });
    for (const ParticleRange& range : ranges_) {
        std::optional<Extent>& extent = state_.bodies[active_[range.active].slot].particles.extent;
        if (!extent) extent.emplace();
        extent->add(range.extent);
    }
    for (ActiveBody& active : active_) {
        Body& body = state_.bodies[active.slot];
        const double fastest = active.fastest = length(body.particles.extent->fastest);
        Aabb box = body.particles.extent->box;
        body.particles.extent.reset();
        double way = 0;
        if (const auto motion = motion_of_jump(body, scene, state_.near_models, model_time_)) {
            active.jumps = active.restarts = true;
            const Vec3 middle = motion->apply((box.min + box.max) / 2);
            const Vec3 half = abs(motion->rotation) * ((box.max - box.min) / 2);
            box = {middle - half, middle + half};
            way = model_time_ * fastest_model;
        } else {
            way = way_to_models(body, scene);
        }
        // Metres: twice what a particle can move in this step. `search_box` adds what a model can move.
        const double margin = 2 * body.particles.largest_radius +
                              2 * dt * (fastest + dt * length(state_.settings.gravity)) + way_to_targets(body) + way;
        const auto enlarged = [&](double by) {
            return bounds(Aabb{box.min - Vec3{by, by, by}, box.max + Vec3{by, by, by}});
        };
        active.reachable = enlarged(margin);
        active.search_box = body.steady.search_box = enlarged(margin + dt * fastest_model);
    }
    list_moved_models(scene);
    for (ActiveBody& active : active_) {
        Body& body = state_.bodies[active.slot];
        const size_t before = next_near_models_.size();
        bool meshes = false;
        each_near_model(scene, active.search_box, body.settings.layers, [&](gphys_model_id model) {
            see(scene, model);
            meshes = meshes || scene.mesh(model);
            // find_disturbed handles models that have moved.
            if (active.undisturbed && scene.overlaps_box(model, active.reachable)) active.undisturbed = false;
        });
        active.near_model_count = static_cast<uint32_t>(next_near_models_.size() - before);
        // Particles that others push are swept in each substep, against any shape.
        const bool keeps_balls = meshes || (active.in_island && active.near_model_count > 0);
        reserve_balls(body, scene, moved_models_, active.search_box, keeps_balls);
        see_attached_models(&scene, body.constraints, before);
        if (active.near_model_count == 0) continue;
        const uint32_t least = substeps_near_models(body.cloth, state_.settings, active.fastest, dt);
        active.substeps = std::max(active.substeps, least);
    }
    std::sort(next_near_models_.begin(), next_near_models_.end());
    const auto same = [](const PlacedModel& a, const PlacedModel& b) { return a.model == b.model; };
    next_near_models_.erase(std::unique(next_near_models_.begin(), next_near_models_.end(), same),
                            next_near_models_.end());
    for (PlacedModel& now : next_near_models_) {
        const PlacedModel* const before = find_placed(state_.near_models, now.model);
        if (!before) continue;
        const Vec3 way = widen(now.world.position) - widen(before->world.position);
        now.velocity = narrow(way / model_time_);
        if (share_ < 1 && find_moved(moved_models_, now.model))
            now.world = narrow_interpolate(before->world, now.world, share_);
    }
    find_disturbed(scene);
    for (const ActiveBody& active : active_) {
        Body& body = state_.bodies[active.slot];
        reserve_impulses(body, active.near_model_count + active.moved_model_count);
        if (body.plan.method == GPHYS_SOLVE_GRAPH) body.cloth.moving_colliders.reserve(active.moved_model_count);
    }
}

/// Keeps the sum of substeps times particles below max_work: if it is larger, all bodies get fewer substeps in
/// proportion. Bodies of an island take as many substeps as the one that needs the most.
void Solver::limit_work(double dt) {
    const uint32_t most = state_.settings.max_work;
    for (const ActiveBody& active : active_) {
        state_.bodies[active.slot].substeps.allowed = most > 0 ? active.substeps : std::numeric_limits<uint32_t>::max();
    }
    if (most == 0) return;
    for (const Island& island : islands_) {
        const uint32_t* const slots = &island_bodies_[island.first_body];
        uint32_t needed = island.colliding_count > 0 ? state_.settings.substeps : 1;  // as in move_island
        for (uint32_t i = 0; i < island.body_count; ++i) {
            needed = std::max(needed, state_.bodies[slots[i]].substeps.allowed);
        }
        for (uint32_t i = 0; i < island.body_count; ++i) state_.bodies[slots[i]].substeps.allowed = needed;
    }
    double work = 0;
    for (const ActiveBody& active : active_) {
        work += static_cast<double>(state_.bodies[active.slot].substeps.allowed) * active.size;
    }
    const double factor = work > most ? most / work : 1;
    for (ActiveBody& active : active_) {
        Body& body = state_.bodies[active.slot];
        const uint32_t least = least_substeps(body, dt);
        body.substeps.allowed = std::max(least, static_cast<uint32_t>(body.substeps.allowed * factor));
        active.substeps = std::min(active.substeps, body.substeps.allowed);
    }
}

/// Marks the bodies near the path of a model that has moved.
void Solver::find_disturbed(const Scene& scene) {
    for (const MovedModel& before : moved_models_) {
        for (ActiveBody& active : active_) {
            const uint32_t layers = scene.layers(before.model) & state_.bodies[active.slot].settings.layers;
            if (layers == 0 || (before.bounded && !overlaps(before.swept, active.search_box))) continue;
            ++active.moved_model_count;
            if (before.bounded && !overlaps(before.swept, active.reachable)) continue;
            active.undisturbed = false;
            active.models_move = true;
        }
    }
}

/// Whether all workers could move a cloth together in less time than one: if it has more than a worker's share of all
/// particles, and so many links that synchronisation between colours does not take most of the gain.
bool Solver::is_worth_sharing(const ActiveBody& active, size_t particles) const {
    constexpr size_t least_links = 20000;
    const Plan& plan = state_.bodies[active.slot].plan;
    return plan.rest.size() >= least_links && size_t{active.size} * workers_.count() > particles;
}

void Solver::reserve_flight_planes() {
    const auto flies = [&](const ActiveBody& active) {
        return state_.bodies[active.slot].plan.method == GPHYS_SOLVE_FREE;
    };
    if (flight_planes_.size() >= workers_.count() || std::none_of(active_.begin(), active_.end(), flies)) return;
    Vector<FlightPlanes> made(workers_.count(), flight_planes_.get_allocator());
    flight_planes_.swap(made);
}

void Solver::reserve_collision_memory() {
    if (collision_memory_.size() >= workers_.count()) return;
    Vector<CollisionMemory> made(workers_.count(), collision_memory_.get_allocator());
    collision_memory_.swap(made);
}

/// Makes the tasks: eight undisturbed ropes, a larger group of ropes that share contact lanes, one body, or a part of a
/// body. Islands are tasks of their own.
void Solver::make_tasks() {
    tasks_.clear();
    while (rope_scratch_.size() < workers_.count()) rope_scratch_.emplace_back(&scratch_memory_);
    size_t alone = 0, in_lanes = 0, in_contact_lanes = 0;  // particles of the longest ropes
    const auto sharing = std::count_if(active_.begin(), active_.end(), [](const ActiveBody& active) {
        return active.shares_contact_lanes() && !active.in_island;
    });
    // Large groups, because lanes are idle at the end of one; but several per worker, because workers are idle at the
    // end of the step.
    const uint32_t in_group =
        std::clamp(static_cast<uint32_t>(sharing) / (4 * workers_.count()), rope_lanes, 8 * rope_lanes);
    size_t particles = 0, moved_models = 0;
    for (const ActiveBody& active : active_) {
        particles += active.size;
        moved_models = std::max<size_t>(moved_models, active.moved_model_count);
    }
    for (Island& island : islands_) {
        island.on_trial = workers_.count() > 1 && ParticleContacts::has_groups(island.colliding_count) &&
                          size_t{island.size} * workers_.count() > particles;
        island.shared = island.on_trial && sharing_trial(island).is_shared();
    }
    for (uint32_t i = 0, next; i < active_.size(); i = next) {
        const ActiveBody& first = active_[i];
        next = i + 1;
        if (first.in_island) continue;
        if (first.undisturbed && first.size <= longest_rope_in_lanes) {
            while (next < active_.size() && next - i < rope_lanes && first.can_share_lanes(active_[next])) ++next;
        } else if (first.shares_contact_lanes()) {
            const auto joins = [&](const ActiveBody& rope) { return rope.shares_contact_lanes() && !rope.in_island; };
            while (next < active_.size() && next - i < in_group && joins(active_[next])) ++next;
            if (next - i > 1) in_contact_lanes = std::max<size_t>(in_contact_lanes, first.size);
        }
        const gphys_solve_method method = state_.bodies[first.slot].plan.method;
        bool shared = false;
        if (method == GPHYS_SOLVE_GRAPH) {
            Cloth& cloth = state_.bodies[first.slot].cloth;
            cloth.shares.on_trial = workers_.count() > 1 && is_worth_sharing(first, particles);
            shared = cloth.shares.on_trial && cloth.shares.trial.is_shared();
            if (shared) cloth.batches.rows.resize(size_t{cloth_row_floats} * cloth.batches.longest * workers_.count());
        }
        for (uint32_t part = 0; part < first.parts; ++part) tasks_.push_back({i, 1, false, part});
        if (first.parts == 0) tasks_.push_back({i, next - i, shared, 0});
        if (method != GPHYS_SOLVE_DIRECT) continue;
        alone = std::max<size_t>(alone, first.size);
        if (next - i > 1) in_lanes = std::max<size_t>(in_lanes, first.size);
    }
    for (RopeScratch& scratch : rope_scratch_) scratch.reserve(alone, in_lanes, in_contact_lanes, moved_models);
}

}  // namespace gphys

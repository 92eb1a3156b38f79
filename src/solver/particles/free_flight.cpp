// Bodies without constraints. Each particle flies independently, by the exact solution of its flight (flight.h), so the
// accuracy depends neither on the length nor on the number of the steps.
//
// Particles are processed in blocks, which query the scene together. The particles of a block whose paths do not
// overlap the boxes of nearby models are moved eight at a time (flight_kernels.cpp). The others are moved one by one,
// from one impact to the next. Neighbours in a body, such as particles that an emitter has made together, are mostly
// neighbours in space.
#include "solver/particles/free_flight.h"
#include "foundation/team.h"
#include "solver/contact/collision_memory.h"
#include "solver/contact/friction.h"
#include "solver/motion.h"
#include "solver/particles/flight.h"
#include "solver/particles/flight_kernels.h"
#include "solver/particles/flight_planes.h"

namespace gphys {
namespace {

// Bounces of one particle in one substep. Later ones are so small that the particle lies still.
constexpr int most_bounces = 8;
// Particles that query the scene together: enough to share the cost of the query, and few enough to stay in the L1
// cache.
constexpr uint32_t block_size = FlightPlanes::most_particles, block_groups = block_size / flight_group;
constexpr uint32_t most_obstacles = CollisionMemory::most_obstacles;

// Those of no particles. Bodies of a few, such as projectiles, would spend most of their time on calls of the kernels.
constexpr FlightBounds no_bounds{
    {infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, {0, 0, 0}, {0, 0, 0}};

void put(double* to, Vec3 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }
Vec3 get(const double (&from)[3]) { return {from[0], from[1], from[2]}; }

void repeat(const Aabb& box, FlightBox& out) {
    for (int i = 0; i < int{FlightBox::size}; ++i) {
        out.low[i] = box.min[i % 3];
        out.high[i] = box.max[i % 3];
    }
}

class FreeFlight {
public:
    /// `planes` are those of the worker, or null to sweep every path; so is `memory`, or null without a scene.
    FreeFlight(Body& body, const ImpulseAccumulator& accumulator, Vec3 gravity, double h, FlightPlanes* planes,
               CollisionMemory* memory)
        : body_(body),
          accumulator_(accumulator),
          gravity_(gravity),
          h_(h),
          whole_(body.settings.damping, h),
          planes_(planes),
          memory_(memory),
          in_air_(flies_in_air(body)) {
        for (uint32_t i = 0; i < flight_group; ++i) put(acceleration_ + size_t{3} * i, gravity);
    }

    /// Call before the substeps of a block.
    void begin_block(const CollisionContext& step, uint32_t first, uint32_t count) {
        if (planes_) planes_->begin(body_, step, gravity_, first, count);
        begin_air_and_forces(first, count);
    }
    /// The same before one substep of a body whose particles others may push.
    void begin_pushed_block(const CollisionContext& substep, uint32_t first, uint32_t count) {
        if (planes_) planes_->begin_pushed(body_, substep, first, count);
        begin_air_and_forces(first, count);
    }
    void begin_air_and_forces(uint32_t first, uint32_t count) {
        same_air_left_ = 0;
        if (!in_air_) find_accelerations(first, count);
    }
    /// Runs one substep; `left` is the number of those that the block has still to run, with this one.
    void fly_block(const CollisionContext& around, uint32_t first, uint32_t count, uint32_t left);

private:
    Flight flight_of(uint32_t p) const {
        if (!body_.particles.forced) return {gravity_, body_.settings.damping};
        return {gravity_ + body_.particles.force[p] * body_.particles.inverse_mass[p], body_.settings.damping};
    }
    void find_accelerations(uint32_t first, uint32_t count) {
        for (uint32_t i = 0; i < count && body_.particles.forced; ++i)
            put(acceleration_ + size_t{3} * i, flight_of(first + i).acceleration);
    }
    /// Renews the forces of the air after as many substeps as they may last.
    void blow(uint32_t first, uint32_t count);
    /// Lists the regions in which particles may hit something, and those in which friction holds all of them.
    void list_obstacles(const Collider& collider, const Aabb& region, uint32_t first, uint32_t count);
    /// Moves the particles of the block, without regard to targets.
    void move_block(uint32_t first, uint32_t count);
    void fly_one(const Collider* collider, uint32_t p, uint32_t obstacle);
    void keep_to_targets(uint32_t first, uint32_t count);
    void fly_freely(uint32_t p);
    void fly_among(const Collider& collider, uint32_t p);
    /// The first hit on the whole path of the substep.
    bool hits(const Collider& collider, uint32_t p, Vec3 displacement, Impact& impact);
    bool stays_at_rest(const Collider& collider, uint32_t p, uint32_t obstacle);
    bool any_rests(uint32_t first, uint32_t end) const {
        while (first < end && !(planes_ && planes_->rests(first))) ++first;
        return first < end;
    }
    /// Whether particles that a static model holds in this substep are held in all that follow. Otherwise others may
    /// act on them, or friction depends on what they have done.
    bool holds_till_end(uint32_t first, uint32_t end) const {
        if (!planes_ || planes_->pushed()) return false;
        if (body_.particles.forced || body_.settings.sticks() || !body_.targets.empty()) return false;
        while (first < end && planes_->still(first)) ++first;
        return first == end;
    }
    /// In the rest of the step.
    FlightWay way_of(uint32_t p) const;
    /// Bounds of the whole block; those of complete groups come from the kernel.
    FlightBounds bound(const FlightGroups& groups, uint32_t first, uint32_t count) const;

    Body& body_;
    const ImpulseAccumulator accumulator_;
    CollisionContext around_;  // of the substep under way
    uint32_t substeps_left_ = 1;
    Vec3 gravity_;
    double h_;
    FlightTime whole_;  // the whole substep
    FlightPlanes* const planes_;
    CollisionMemory* const memory_;
    const bool in_air_;
    const FlightKernels& kernels_ = flight_kernels(chosen_isa());
    // For the block under way:
    double acceleration_[flight_numbers * block_groups];  // of each group, or of one group for all
    uint32_t same_air_left_ = 0;                          // substeps in which the forces of the air stay the same
    bool known_ = false;                                  // whether the list of obstacles is complete
    uint32_t obstacle_count_ = 0;
    uint8_t overlapping_[block_groups], resting_on_[block_groups], obstacle_of_[block_size];
};

void FreeFlight::fly_freely(uint32_t p) {
    const Flight flight = flight_of(p);
    body_.particles.position[p] += flight.displacement(body_.particles.velocity[p], whole_);
    body_.particles.velocity[p] = flight.velocity(body_.particles.velocity[p], whole_);
    keep_in_range(body_.particles.position[p], body_.particles.velocity[p]);
}

/// The impulse of a particle that is held till the end of the step is that of all its substeps.
bool FreeFlight::stays_at_rest(const Collider& collider, uint32_t p, uint32_t obstacle) {
    const bool till_end = holds_till_end(p, p + 1);
    const Vec3 acceleration = flight_of(p).acceleration, displacement = acceleration * whole_.fall;
    const Vec3 gained = acceleration * (till_end ? whole_.reach * substeps_left_ : whole_.reach);
    bool held = collider.try_hold(body_, p, obstacle, displacement, gained);
    if (!held && planes_) {
        Impact impact, of_moving;
        const Vec3 at = body_.particles.position[p];
        held = planes_->sweep(body_, p, at, displacement, length(displacement), impact) && impact.model != 0;
        if (held && !planes_->still(p)) collider.sweep_moving(p, at, displacement, around_.begin, 0, of_moving);
        held = held && of_moving.model == 0 && collider.try_hold(body_, p, impact, displacement, gained);
    }
    if (held && till_end) planes_->set_rests(p);
    return held;
}

FlightWay FreeFlight::way_of(uint32_t p) const {
    const Flight flight = flight_of(p);
    const double rest = around_.step_time * (1 - around_.begin);
    const Vec3 from = body_.particles.position[p], velocity = body_.particles.velocity[p];
    // With drag it goes less far on both accounts, at every time.
    const Vec3 ahead = velocity * rest, fall = flight.acceleration * (rest * rest / 2);
    const double acceleration = length(flight.acceleration), speed = length(velocity) + acceleration * rest;
    return {around_.begin,
            rest,
            from,
            from + flight.displacement(velocity, FlightTime(flight.damping, rest)),
            {from + min(Vec3{}, ahead) + min(Vec3{}, fall), from + max(Vec3{}, ahead) + max(Vec3{}, fall)},
            speed,
            acceleration + flight.damping * speed};
}

bool FreeFlight::hits(const Collider& collider, uint32_t p, Vec3 displacement, Impact& impact) {
    // The distance that it can go in the rest of the step, and half as much again.
    const double rest = around_.step_time * (1 - around_.begin);
    const double reach = 1.5 * rest * (length(body_.particles.velocity[p]) + rest * length(flight_of(p).acceleration));
    const Vec3 at = body_.particles.position[p];
    if (planes_) {
        if (planes_->sweep(body_, p, at, displacement, reach, impact)) {
            if (!planes_->still(p)) collider.sweep_moving(p, at, displacement, around_.begin, 0, impact);
            return impact.model != 0;
        }
        if (!body_.particles.forced && body_.targets.empty() && planes_->flies(body_, p, way_of(p))) return false;
    }
    return collider.sweep(p, at, displacement, around_.begin, impact);
}

void FreeFlight::fly_among(const Collider& collider, uint32_t p) {
    const Flight flight = flight_of(p);
    const double damping = body_.settings.damping, restitution = body_.settings.restitution;
    Vec3& at = body_.particles.position[p];
    Vec3& velocity = body_.particles.velocity[p];
    const double bounce_threshold = length(flight.acceleration) * 2 * h_;
    double left = h_;
    FlightTime ahead = whole_;
    // For moving models, a path is straight and passed at a constant speed, without gaps between successive paths. This
    // is their common clock.
    double time = around_.begin;
    for (int bounce = 0;; ++bounce) {
        const Vec3 displacement = flight.displacement(velocity, ahead);
        Impact impact;
        const bool hit =
            bounce == 0 ? hits(collider, p, displacement, impact) : collider.sweep(p, at, displacement, time, impact);
        if (!hit) {
            at += displacement;
            velocity = flight.velocity(velocity, ahead);
            return;
        }
        collider.record(body_, p, impact);
        if (impact.inside || bounce == most_bounces) {
            velocity = flight.velocity(velocity, ahead);
            collider.slide(body_, p, at, displacement, time, bounce_threshold, impact);
            return;
        }
        const Vec3 towards = -impact.normal;
        const double t = impact.moves ? impact.t : collider.stop_short(body_, p, at, displacement, impact);
        if (t > 0) {  // otherwise it is within the skin already
            const double s = impact.moves
                                 ? left * t
                                 : flight.time_to(velocity, towards, dot(displacement, towards) * impact.t, left);
            at += displacement * t;
            velocity = flight.velocity(velocity, FlightTime(damping, s));
            left -= s;
            ahead = FlightTime(damping, left);
            time += (around_.end - time) * t;
        }
        if (impact.moves) at = collider.place_off_model(body_, p, at, impact);
        // A bounce that would last less than two substeps does not happen: the particle comes to rest.
        const double approach = dot(velocity - impact.surface_velocity, towards);
        const double pressing = dot(flight.acceleration, towards) * h_;
        const bool bounces = restitution * approach > std::max(0.0, pressing);
        const Vec3 arrival = velocity;
        collider.bounce(body_, p, impact, bounces ? restitution : 0);
        if (bounces) continue;
        const bool unchanged = t <= 0 && !impact.moves && velocity == arrival;
        const Vec3 rest = flight.displacement(velocity, ahead);
        velocity = flight.velocity(velocity, ahead);
        if (unchanged) {
            collider.slide(body_, p, at, rest, time, bounce_threshold, impact);
        } else {
            collider.slide(body_, p, at, rest, time, bounce_threshold);
        }
        return;
    }
}

FlightBounds FreeFlight::bound(const FlightGroups& groups, uint32_t first, uint32_t count) const {
    FlightBounds bounds = no_bounds;
    if (groups.count > 0) kernels_.bound(groups, bounds);
    for (uint32_t p = first + groups.count * flight_group; p < first + count; ++p) {
        const Vec3 way = flight_of(p).displacement(body_.particles.velocity[p], whole_);
        for (int k = 0; k < 3; ++k) {
            const double from = body_.particles.position[p][k], to = from + way[k];
            bounds.low[k] = std::min({bounds.low[k], from, to});
            bounds.high[k] = std::max({bounds.high[k], from, to});
            bounds.fastest[k] = std::max(bounds.fastest[k], std::fabs(body_.particles.velocity[p][k]));
            bounds.furthest[k] = std::max(bounds.furthest[k], std::fabs(way[k]));
        }
    }
    return bounds;
}

void FreeFlight::list_obstacles(const Collider& collider, const Aabb& region, uint32_t first, uint32_t count) {
    constexpr Aabb nowhere{{1, 1, 1}, {-1, -1, -1}};
    const bool alike = !body_.particles.forced && body_.particles.smallest_radius == body_.particles.largest_radius;
    const double radius = body_.particles.largest_radius;
    // The smallest skin of a particle in the region.
    Vec3 nearest;
    for (int k = 0; k < 3; ++k) nearest[k] = std::max({0.0, region.min[k], -region.max[k]});
    const double gap = largest_gap(skin(radius, nearest));
    const double friction = body_.settings.friction * least_friction_factor(body_, first, count);
    known_ = collider.for_each_obstacle(radius, region, [&](const Aabb& box, const FlatModel* flat) {
        if (obstacle_count_ < most_obstacles) {
            FlightObstacle& obstacle = memory_->obstacles[obstacle_count_];
            repeat(box, obstacle.all);
            repeat(alike && flat ? flat->resting_region(radius, gap, gravity_ * whole_.fall, friction) : nowhere,
                   obstacle.rest);
        }
        ++obstacle_count_;
    });
    known_ = known_ && obstacle_count_ <= most_obstacles;
}

void FreeFlight::fly_one(const Collider* collider, uint32_t p, uint32_t obstacle) {
    if (body_.particles.pinned(p) || (planes_ && planes_->rests(p))) return;
    if (!collider) return fly_freely(p);
    if (planes_ && planes_->flies(p)) return fly_freely(p);
    if (body_.particles.velocity[p] == Vec3{} && stays_at_rest(*collider, p, obstacle)) return;
    const Flight flight = flight_of(p);
    const Vec3 velocity = body_.particles.velocity[p];
    if (!planes_ || planes_->still(p) ||
        !collider->try_slide_on_moving(body_, p, flight.displacement(velocity, whole_),
                                       flight.velocity(velocity, whole_))) {
        fly_among(*collider, p);
    }
    keep_in_range(body_.particles.position[p], body_.particles.velocity[p]);
}

/// Moves particles that are outside the bounds of their targets back into them; models on the way stop them.
void FreeFlight::keep_to_targets(uint32_t first, uint32_t count) {
    const auto each_outside = [&](auto&& visit) {
        for (uint32_t p = first; p < first + count; ++p) {
            const AnimationTarget& target = body_.targets.all[p];
            if (!target.bounds() || body_.particles.pinned(p)) continue;
            TargetBounds out_of;
            const Vec3 at = body_.particles.position[p];
            const Vec3 place = allowed_place(target, around_.way(around_.end), around_.way_time(), at, out_of);
            if (out_of.count > 0) visit(p, at, place, out_of);
        }
    };
    Extent ways;
    double longest = 0;
    each_outside([&](uint32_t, Vec3 at, Vec3 place, const TargetBounds&) {
        ways.add({{min(at, place), max(at, place)}, {}});
        longest = std::max(longest, distance(at, place));
    });
    if (longest == 0) return;
    const double room = 2 * body_.particles.largest_radius + longest;
    const Vec3 reach{room, room, room};
    const Collider* collider = nullptr;
    if (collides(body_, around_)) {
        const Box box = gphys::bounds(Aabb{ways.box.min - reach, ways.box.max + reach});
        collider = &memory_->collider.emplace(around_, body_, box, accumulator_);
    }
    each_outside([&](uint32_t p, Vec3 at, Vec3 place, const TargetBounds& out_of) {
        body_.particles.velocity[p] = out_of.turned(body_.particles.velocity[p]);
        if (collider && !collider->idle()) {
            collider->slide(body_, p, at, place - at, around_.end, find_bounce_threshold(gravity_, h_));
        } else {
            body_.particles.position[p] = place;
            keep_in_range(body_.particles.position[p], body_.particles.velocity[p]);
        }
    });
}

void FreeFlight::blow(uint32_t first, uint32_t count) {
    if (same_air_left_ == 0) {
        const double lasting = body_.air.lasting / h_;
        while (same_air_left_ < substeps_left_ && (same_air_left_ == 0 || same_air_left_ + 1 <= lasting))
            ++same_air_left_;
        blow_flying(body_, gravity_, h_ * same_air_left_, first, first + count);
        find_accelerations(first, count);
    }
    --same_air_left_;
}

void FreeFlight::fly_block(const CollisionContext& around, uint32_t first, uint32_t count, uint32_t left) {
    if (planes_ && planes_->all_rest()) return;
    around_ = around;
    substeps_left_ = left;
    follow_models(body_, around, h_, first, first + count);
    if (in_air_) blow(first, count);
    begin_friction(body_, gravity_, first, first + count);
    move_block(first, count);
    if (!body_.targets.empty()) keep_to_targets(first, count);
    end_friction(body_, first, first + count);
}

void FreeFlight::move_block(uint32_t first, uint32_t count) {
    const FlightGroups groups{count / flight_group,
                              &body_.particles.position[first].x,
                              &body_.particles.velocity[first].x,
                              acceleration_,
                              body_.particles.forced ? flight_numbers : 0,
                              whole_.kept,
                              whole_.reach,
                              whole_.fall};
    // Of less than a group nothing is moved by the kernel, so without models nothing depends on the bounds.
    const bool may_collide = collides(body_, around_);
    const FlightBounds bounds = may_collide || groups.count > 0 ? bound(groups, first, count) : no_bounds;
    const Aabb region{get(bounds.low), get(bounds.high)};
    known_ = max_component(max(abs(region.min), abs(region.max))) <= GPHYS_MAX_COORDINATE;
    obstacle_count_ = 0;
    const Collider* collider = nullptr;
    if (may_collide) {
        // Twice the length of a path, because a bounce may turn it back.
        const double room =
            2 * body_.particles.largest_radius + length(get(bounds.furthest)) + length(get(bounds.fastest)) * h_;
        const Vec3 reach{room, room, room};
        collider = &memory_->collider.emplace(
            around_, body_, gphys::bounds(Aabb{region.min - reach, region.max + reach}), accumulator_, planes_);
        if (collider->idle()) {
            collider = nullptr;
        } else if (known_) {
            list_obstacles(*collider, region, first, count);
        }
    }
    // Particles that must not be moved by the kernel, or whose paths are not known to be clear, are moved one by one.
    if (collider) std::fill_n(obstacle_of_, count, several_obstacles);
    if (groups.count > 0) {
        std::fill_n(overlapping_, groups.count, known_ ? uint8_t{0} : uint8_t{0xff});
        for (uint32_t i = 0; i < groups.count * flight_group; ++i) {
            if (body_.particles.pinned(first + i))
                overlapping_[i / flight_group] |= static_cast<uint8_t>(1 << i % flight_group);
        }
        kernels_.fly(groups, memory_ ? memory_->obstacles : nullptr, known_ ? obstacle_count_ : 0,
                     {overlapping_, obstacle_of_, resting_on_});
    }
    const Vec3 way = gravity_ * whole_.fall;
    for (uint32_t group = 0; group <= groups.count; ++group) {
        const uint32_t begin = group * flight_group, end = std::min(count, begin + flight_group);
        const uint32_t overlapping = group < groups.count ? overlapping_[group] : 0xff;
        if (overlapping == 0) continue;
        if (group < groups.count && resting_on_[group] != no_obstacle && !any_rests(first + begin, first + end)) {
            const bool till_end = holds_till_end(first + begin, first + end);
            const Vec3 gained = gravity_ * (till_end ? whole_.reach * substeps_left_ : whole_.reach);
            collider->hold(body_, first + begin, end - begin, resting_on_[group], way, gained);
            for (uint32_t i = begin; i < end && till_end; ++i) planes_->set_rests(first + i);
            continue;
        }
        for (uint32_t i = begin; i < end; ++i) {
            const bool hits = collider && (overlapping >> (i - begin) & 1);
            if (hits) {
                fly_one(collider, first + i, obstacle_of_[i]);
            } else {
                fly_one(nullptr, first + i, several_obstacles);
            }
        }
    }
}

}  // namespace

void fly(Body& body, const CollisionContext& around, Vec3 gravity, double h, FlightPlanes* planes, Team* team) {
    static_assert(block_size == part_size_in_island);
    if (body.flight.all.empty()) planes = nullptr;
    const uint32_t size = body.particles.size();
    share(body.contacts.parts.empty() ? nullptr : team, (size + block_size - 1) / block_size,
          [&](uint32_t block, uint32_t member) {
              const uint32_t first = block * block_size, count = std::min(block_size, size - first);
              FreeFlight flight(body, body.contacts.accumulator(block), gravity, h, planes ? planes + member : nullptr,
                                around.memory ? around.memory + member : nullptr);
              flight.begin_pushed_block(around, first, count);
              flight.fly_block(around, first, count, 1);
          });
}

Extent extent_of(Body& body, uint32_t first, uint32_t end) {
    constexpr double nothing[flight_numbers] = {};
    const FlightGroups groups{(end - first) / flight_group,
                              &body.particles.position[first].x,
                              &body.particles.velocity[first].x,
                              nothing,
                              0,
                              1,
                              0,
                              0};
    FlightBounds bounds = no_bounds;
    if (groups.count > 0) flight_kernels(chosen_isa()).bound(groups, bounds);
    Extent extent{{get(bounds.low), get(bounds.high)}, get(bounds.fastest)};
    for (uint32_t p = first + groups.count * flight_group; p < end; ++p) {
        extent.add({{body.particles.position[p], body.particles.position[p]}, abs(body.particles.velocity[p])});
    }
    return extent;
}

/// Takes a block through the whole step at once, so that it stays in the L1 cache.
Extent fly_through(Body& body, uint32_t first, uint32_t end, const ImpulseAccumulator& accumulator,
                   const CollisionContext& step, Vec3 gravity, uint32_t substeps, FlightPlanes* planes) {
    FreeFlight flight(body, accumulator, gravity, step.step_time / substeps, planes, step.memory);
    Extent extent;
    for (; first < end; first += block_size) {
        const uint32_t count = std::min(block_size, end - first);
        begin_contact_points(body, first, first + count);
        flight.begin_block(step, first, count);
        for (uint32_t i = 0; i < substeps; ++i)
            flight.fly_block(part_of_step(step, i, substeps), first, count, substeps - i);
        end_contact_points(body, first, first + count);
        extent.add(extent_of(body, first, first + count));
    }
    return extent;
}

}  // namespace gphys

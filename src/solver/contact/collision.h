// Particles, which are small spheres, against the models of a scene.
//
// A particle only ever moves along a path that was swept clear, and stops short of what it meets by
// a skin. It therefore never starts out touching, each sweep sees what is really ahead, and nothing
// is passed through at any speed. A particle that is inside a model all the same (put there, or
// caught by a model that jumped) is pushed out by the shortest way: at once if nothing holds it, otherwise as
// leave_solids.cpp says.
#pragma once

#include "scene/scene.h"
#include "solver/body.h"
#include "solver/contact/flat_model.h"
#include "solver/time_scheme.h"

namespace gphys {

struct PlacedModel {
    gphys_model_id model;
    gphys_transform world;

    bool operator<(const PlacedModel& other) const { return model < other.model; }
};

/// What there is to collide with during one substep: the scene as it is, the models that have moved
/// since the last step with their former places, and the part of the step that the substep covers.
struct CollisionContext {
    const Scene* scene = nullptr;
    const Vector<PlacedModel>* moved = nullptr;  // by model
    double step_time = 0;                        // seconds that the models took to move
    double begin = 0, end = 1;                   // fractions of the step
};

/// Where the model was before the last step, if it has moved since; else null.
const PlacedModel* find_moved(const CollisionContext& around, gphys_model_id model);
inline bool has_moved(const CollisionContext& around, gphys_model_id model) {
    return find_moved(around, model) != nullptr;
}

/// A placement between two others: positions and scales linearly, rotations along the shorter arc.
Transform interpolate(const gphys_transform& from, const gphys_transform& to, double fraction);

/// How far a particle stays off what it touches: 1e-4 of its radius, which nobody sees, and at least
/// 2^-40 of the coordinates, which is 2^12 times their rounding; for points at the origin, a nanometre.
inline double skin(double radius, Vec3 at) { return 1e-4 * radius + 0x1p-40 * max_component(abs(at)) + 1e-9; }
/// Up to this far off a particle is as near as it comes. What has stopped there is off by some rounding of its
/// coordinates, of which a hundredth of a skin is 2^6 at least.
inline double largest_gap(double skin) { return 1.01 * skin; }

/// How fast particles with constraints leave what they are in, m/s.
constexpr double leaving_speed = 1;

/// What a particle meets, as it is at that moment.
struct Impact {
    double t = infinity;  // fraction of the path
    gphys_model_id model = 0;
    bool inside = false;    // touching or within at the start
    bool moves = false;     // the model does
    double time = 0;        // fraction of the step, if it does
    Vec3 center;            // of the particle
    Vec3 point;             // on the model
    Vec3 normal;            // unit, from the model to the particle
    Vec3 surface_velocity;  // m/s
};

/// The first of two; the lowest id of those at once.
inline void keep_first(Impact& first, const Impact& other) {
    if (other.t < first.t || (other.t == first.t && other.model < first.model)) first = other;
}

/// Around a sphere on its way.
inline Box path_box(const Sphere& moving, Vec3 displacement) {
    const Vec3 r{moving.radius, moving.radius, moving.radius}, end = moving.center + displacement;
    return bounds(Aabb{min(moving.center, end) - r, max(moving.center, end) + r});
}

/// The models near one body during one substep.
class Collider {
public:
    /// The box holds every path that will be asked for, but for those of what models strike that move.
    Collider(const CollisionContext& around, Body& body, const Box& paths)
        : Collider(around, body, paths, {body.contacts.impulses, body.contacts.has_contact}) {}
    /// The tally gets what would otherwise be the body's.
    Collider(const CollisionContext& around, const Body& body, const Box& paths, const ImpulseAccumulator& accumulator);

    /// Whether there is nothing at all.
    bool idle() const { return listed_ && count_ == 0 && moving_count_ == 0; }
    /// visit(box, flat) for boxes around all that a particle with its centre in the region may touch, and the model
    /// if it is flat and stands still, or null; false if they are not known, and any particle may touch something.
    template <class Visit>
    bool for_each_obstacle(double radius, const Aabb& region, Visit&& visit) const;

    /// The first model that the particle would meet; the lowest id of those met at once. The particle sets out at a
    /// time, a fraction of the step, and arrives at the end of the substep; models that move do so meanwhile.
    bool sweep(uint32_t particle, Vec3 from, Vec3 displacement, double time, Impact& impact) const;
    /// Whether a particle at rest stays, held by friction on the obstacle that it lies on and the only one that it
    /// can reach: when that lets it go, it would go that way and have that velocity. If so that is recorded, and
    /// the model gets what it is pressed with.
    bool holds(Body& body, uint32_t particle, uint32_t obstacle, Vec3 displacement, Vec3 velocity) const;
    /// The same of some particles, one after the other, that are in its FlatModel::rest.
    void press(Body& body, uint32_t first, uint32_t count, uint32_t obstacle, Vec3 displacement, Vec3 velocity) const;
    /// Take the particle from one place as far along as it can go, sliding along what it meets with
    /// friction, and change the velocity that it would arrive with accordingly. Speeds of approach
    /// below `quiet` do not bounce. Records what was touched. The time is that of the sweep.
    void slide(Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double time, double quiet) const;
    /// The same of a particle whose first impact on that path is known, and recorded.
    void slide(Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double time, double quiet,
               Impact impact) const;
    /// Beside a model that moves, where the particle has met it: a skin away, unless something that does not move
    /// is in the way from where it is.
    Vec3 beside(const Body& body, uint32_t particle, Vec3 at, const Impact& impact) const;
    /// How far and where to, for a particle that is in a model.
    Vec3 way_out(const Body& body, uint32_t particle, Vec3 at, const Impact& impact) const;
    /// Of a model that the particle touches, at the end of the substep.
    Vec3 way_out(const Body& body, uint32_t particle, gphys_model_id model) const;
    /// How far one with constraints comes out in this substep.
    double most_push() const { return most_push_; }
    /// As far along the path as leaves the skin to what it ends at.
    double stop_short(const Body& body, uint32_t particle, Vec3 from, Vec3 displacement, const Impact& impact) const;
    void record(Body& body, uint32_t particle, const Impact& impact) const;
    /// The velocity after an impact; the model gets what it takes from the particle.
    void bounce(Body& body, uint32_t particle, const Impact& impact, double restitution) const;
    /// As far along the surfaces that it touches as it can go, whatever its velocity.
    void shift(Body& body, uint32_t particle, Vec3 way) const;

private:
    static constexpr uint32_t most_listed = 32;

    struct Near {
        gphys_model_id model;
        bool bounded, is_flat;
        Box box;
        FlatModel flat;
    };

    void note(Body& body, uint32_t particle, gphys_model_id model, Vec3 point, Vec3 normal) const;
    void list_moving(const Box& box);
    /// visit(model's former place), of those near, or if they are too many of all.
    template <class Visit>
    void for_each_moving(Visit&& visit) const;
    Box way_of_struck(const Box& paths) const;
    void sweep_model(gphys_model_id model, const Sphere& moving, Vec3 displacement, Impact& first) const;
    void sweep_listed(const Near& near, const Sphere& moving, Vec3 displacement, Impact& first) const;
    void sweep_moving(const Sphere& moving, Vec3 displacement, double time, gphys_model_id ignored,
                      Impact& first) const;
    void sweep_moved(const PlacedModel& before, const Sphere& moving, Vec3 displacement, double time,
                     Impact& first) const;
    /// Of models that have not moved.
    void sweep_unmoved(uint32_t particle, Vec3 from, Vec3 displacement, gphys_model_id ignored, Impact& first) const;
    /// Of all but one that the particle is in.
    bool sweep_others(uint32_t particle, Vec3 from, Vec3 displacement, double time, gphys_model_id ignored,
                      Impact& first) const;
    Transform place_of(gphys_model_id moved, double time) const;
    /// As it is at the end of the substep if the particle stays with the model.
    Impact carried(const Impact& impact) const;

    const CollisionContext& around_;
    const Body& body_;
    const ImpulseAccumulator accumulator_;
    const double most_push_;
    bool listed_ = true;  // otherwise there are too many, and the scene is asked for each particle
    uint32_t count_ = 0;
    Near near_[most_listed];
    uint32_t moving_count_ = 0;  // of those that have moved and come near, the first of which are listed
    uint32_t moving_[most_listed];
};

/// A box around a model on its way to where it is; false if it is unbounded.
bool way_of(const Scene& scene, const PlacedModel& before, Box& out);

inline Aabb widen(const Box& box) {
    return {{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}};
}

template <class Visit>
bool Collider::for_each_obstacle(double radius, const Aabb& region, Visit&& visit) const {
    if (!listed_ || moving_count_ > most_listed) return false;
    const Vec3 room{radius, radius, radius};
    const auto offer = [&](const Aabb& part, const FlatModel* flat) {
        visit(Aabb{part.min - room, part.max + room}, flat);
    };
    for (uint32_t i = 0; i < count_; ++i) {
        const Near& near = near_[i];
        if (!near.bounded && !near.is_flat) return false;
        offer(near.bounded ? widen(near.box) : near.flat.part_of_plane({region.min - room, region.max + room}),
              near.is_flat ? &near.flat : nullptr);
    }
    for (uint32_t i = 0; i < moving_count_; ++i) {
        Box way;
        if (!way_of(*around_.scene, (*around_.moved)[moving_[i]], way)) return false;
        offer(widen(way), nullptr);
    }
    return true;
}

/// Velocity after an impact: `restitution` of the approach is given back, and friction takes at most
/// friction times what the impact gave (Coulomb).
Vec3 after_impact(Vec3 velocity, const Impact& impact, double restitution, double friction);

/// The box around all particles on their ways from start to position, and as far again.
Box swept_box(const Body& body, const Vector<Vec3>& from, const Vector<Vec3>& to, double margin);

/// Of a body whose particles have just been moved from start to position.
void collide(Body& body, const CollisionContext& around, double quiet);

/// Whether a particle is no faster than a fall through four times its skin makes it, 9 mm/s for a radius of
/// 1 cm: it may have been put down so far above what it lies on.
bool rests(const Body& body, uint32_t particle, Vec3 velocity, Vec3 gravity);

/// Around the substep of a body that is not cloth, or some of its particles: which of them static friction may hold.
void begin_friction(Body& body, Vec3 gravity, uint32_t first, uint32_t end);
void end_friction(Body& body, uint32_t first, uint32_t end);
inline void begin_friction(Body& body, Vec3 gravity) { begin_friction(body, gravity, 0, body.particles.size()); }
inline void end_friction(Body& body) { end_friction(body, 0, body.particles.size()); }

/// After collide, if something was touched: before the links follow what the contacts have done, while the
/// particles that touch something stay where they are, ...
void ease_contacts(Body& body, const CollisionContext& around);

struct SolvedAgain {
    double step;  // a force f has moved a particle by f / m * step^2
    double rate;  // by which a correction of the position changes the velocity, 1/s
};
/// ... and after it, to sweep what they have moved.
void collide_again(Body& body, const CollisionContext& around, double quiet, const SolvedAgain& again);

/// What gravity adds in two substeps is no speed to bounce with.
inline double quiet_speed(Vec3 gravity, double h) { return 2 * h * length(gravity); }

/// At the beginning and at the end of a step, of some of the particles or of all; both at once.
void begin_contact_points(Body& body, uint32_t first, uint32_t end);
void end_contact_points(Body& body, uint32_t first, uint32_t end);
inline void begin_contact_points(Body& body) { begin_contact_points(body, 0, body.particles.size()); }
inline void end_contact_points(Body& body) { end_contact_points(body, 0, body.particles.size()); }
void clear_contact_points(Body& body);
/// Returns its place in the touches of the particle; the last if others fill them all.
uint32_t record_contact_point(Body& body, uint32_t particle, const Scene& scene, gphys_model_id model, Vec3 point,
                              Vec3 normal);

inline bool collides(const Body& body, const CollisionContext& around) {
    return around.scene && body.settings.layers != 0;
}

}  // namespace gphys

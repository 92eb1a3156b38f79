// Continuous collision of particles, which are small spheres, with the models of a scene.
//
// A particle only moves along a path that was swept clear, and stops a skin short of what it hits. So it never starts
// in contact, each sweep reports the first obstacle ahead, and nothing is passed through at any speed. A particle that
// is inside a model nevertheless (placed there, or caught by a model that jumped) is pushed out along the minimum
// translation: at once if nothing holds it, otherwise as in leave_solids.cpp.
#pragma once

#include "scene/scene.h"
#include "solver/body.h"
#include "solver/contact/flat_model.h"
#include "solver/time_scheme.h"

namespace gphys {

class FlightPlanes;
struct CollisionMemory;

struct PlacedModel {
    gphys_model_id model;
    gphys_transform world;
    gphys_vec3 velocity;  // m/s, from the step before

    bool operator<(const PlacedModel& other) const { return model < other.model; }
};

/// A model that has moved since the last step, and where it was then.
struct MovedModel : PlacedModel {
    bool bounded;
    Box swept;  // bounds of the model during its motion to its present place

    MovedModel(const Scene& scene, const PlacedModel& before);
};

/// What a body collides with in a substep: the scene, the models that have moved since the last step, and the part of
/// the step that the substep covers.
struct CollisionContext {
    const Scene* scene = nullptr;
    const Vector<MovedModel>* moved = nullptr;  // sorted by model
    double step_time = 0;                       // seconds of the step
    double begin = 0, end = 1;                  // fractions of the step
    /// The part of their way to the present places that models, attached particles and animation targets cover in the
    /// step. Less than 1 in `advance`, where a frame is not exactly one step.
    double share = 1;
    CollisionMemory* memory = nullptr;  // of the worker, or of the members of its team; null without a scene

    /// The fraction of that way at a fraction of the step.
    double way(double fraction) const { return share * fraction; }
    /// Seconds that the whole way takes.
    double way_time() const { return step_time / share; }
};

/// Null if the model has not moved.
const MovedModel* find_moved(const Vector<MovedModel>& moved, gphys_model_id model);
inline const MovedModel* find_moved(const CollisionContext& around, gphys_model_id model) {
    return find_moved(*around.moved, model);
}
inline bool has_moved(const CollisionContext& around, gphys_model_id model) {
    return find_moved(around, model) != nullptr;
}

/// A transform between two others: positions and scales linearly, rotations along the shorter arc.
Transform interpolate(const gphys_transform& from, const gphys_transform& to, double fraction);

/// The same as a transform of the scene, rounded to float32.
gphys_transform narrow_interpolate(const gphys_transform& from, const gphys_transform& to, double fraction);

/// tan(angle / 4) of the angle between two rotations.
double quarter_tangent(const Mat3& a, const Mat3& b);

/// The contact margin: a particle stays this far off a surface. It is 1e-4 of the radius, which is invisible, and at
/// least 2^-40 of the coordinates, which is 2^12 times their rounding; for points at the origin, a nanometre.
inline double skin(double radius, Vec3 at) { return 1e-4 * radius + 0x1p-40 * max_component(abs(at)) + 1e-9; }
/// A particle within this distance counts as in contact. One that has stopped there is off by some rounding of its
/// coordinates, and a hundredth of a skin is at least 2^6 times that.
inline double largest_gap(double skin) { return 1.01 * skin; }

/// Speed at which particles with constraints leave models that they are in, m/s.
constexpr double leaving_speed = 1;

/// The first hit of a particle on a path, at the time of impact.
struct Impact {
    double t = infinity;  // fraction of the path
    gphys_model_id model = 0;
    bool inside = false;    // overlapping at the start
    bool moves = false;     // whether the model moves
    double time = 0;        // fraction of the step, if it does,
    Transform place;        // and where the model is then
    Vec3 center;            // of the particle
    Vec3 point;             // on the model
    Vec3 normal;            // unit, from the model to the particle
    Vec3 surface_velocity;  // m/s
};

/// The earlier of two; of simultaneous ones, the lower id.
inline void keep_first(Impact& first, const Impact& other) {
    if (other.t < first.t || (other.t == first.t && other.model < first.model)) first = other;
}

inline Box path_box(const Sphere& moving, Vec3 displacement) {
    const Vec3 r{moving.radius, moving.radius, moving.radius}, end = moving.center + displacement;
    return bounds(Aabb{min(moving.center, end) - r, max(moving.center, end) + r});
}

/// The models near one body during one substep.
class Collider {
public:
    /// `paths` must contain every path that will be swept, except those of particles that moving models push.
    Collider(const CollisionContext& around, Body& body, const Box& paths)
        : Collider(around, body, paths, {body.contacts.impulses, body.contacts.has_contact}) {}
    /// The accumulator replaces that of the body. `planes`: what particles know of models, or null.
    Collider(const CollisionContext& around, const Body& body, const Box& paths, const ImpulseAccumulator& accumulator,
             FlightPlanes* planes = nullptr);

    /// Whether there are no models at all.
    bool idle() const { return listed_ && count_ == 0 && moving_count_ == 0; }
    /// Calls visit(box, flat) for boxes that cover all centres in the region at which a particle may overlap a model.
    /// `flat` is the model if it is flat and static, else null. Returns false if the models are not listed; then a
    /// particle may overlap something anywhere.
    template <class Visit>
    bool for_each_obstacle(double radius, const Aabb& region, Visit&& visit) const;

    /// The first model that the particle hits; of simultaneous ones, the lower id. The particle starts at `time`, a
    /// fraction of the step, and arrives at the end of the substep. Models that move do so meanwhile.
    bool sweep(uint32_t particle, Vec3 from, Vec3 displacement, double time, Impact& impact) const;
    /// Those that move, except for one: keeps the first of them and of the impact that is known.
    void sweep_moving(uint32_t particle, Vec3 from, Vec3 displacement, double time, gphys_model_id ignored,
                      Impact& first) const;
    /// Returns whether static friction holds a particle on the only obstacle that it can reach; then records the
    /// contact and gives the model the impulse. Without friction the particle would move by `displacement` and get
    /// `velocity`.
    bool try_hold(Body& body, uint32_t particle, uint32_t obstacle, Vec3 displacement, Vec3 velocity) const;
    /// The same if the first impact on that path is known.
    bool try_hold(Body& body, uint32_t particle, const Impact& impact, Vec3 displacement, Vec3 velocity) const;
    /// Moves a particle that touches one model that moves, and stays in contact with it: friction keeps it at its place
    /// on the model, or it slides. `displacement`, `velocity`: of the substep, and at its end, without contacts.
    /// Returns false, without effect, if the particle is not known to do so.
    bool try_slide_on_moving(Body& body, uint32_t particle, Vec3 displacement, Vec3 velocity) const;
    /// The same as try_hold for consecutive particles, all of which are in FlatModel::resting_region of the obstacle.
    void hold(Body& body, uint32_t first, uint32_t count, uint32_t obstacle, Vec3 displacement, Vec3 velocity) const;
    /// Moves the particle along the displacement as far as possible, sliding along surfaces with friction, and changes
    /// its velocity accordingly. Approach speeds below `bounce_threshold` do not bounce. Records contacts. `time`: as
    /// in sweep.
    void slide(Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double time, double bounce_threshold) const;
    /// The same if the first impact on that path is known and recorded.
    void slide(Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double time, double bounce_threshold,
               Impact impact) const;
    /// The place a skin away from a moving model that the particle has hit, or as near to it as static models allow.
    Vec3 place_off_model(const Body& body, uint32_t particle, Vec3 at, const Impact& impact) const;
    /// The shortest displacement that moves a particle out of a model.
    Vec3 minimum_translation(const Body& body, uint32_t particle, Vec3 at, const Impact& impact) const;
    /// The same for a model in contact, at the end of the substep.
    Vec3 minimum_translation(const Body& body, uint32_t particle, gphys_model_id model) const;
    /// How far a particle with constraints may move out in this substep.
    double most_push() const { return most_push_; }
    /// The fraction of the path at which the skin to the surface is left.
    double stop_short(const Body& body, uint32_t particle, Vec3 from, Vec3 displacement, const Impact& impact) const;
    void record(Body& body, uint32_t particle, const Impact& impact) const;
    /// Changes the velocity by an impact; the model gets the opposite impulse.
    void bounce(Body& body, uint32_t particle, const Impact& impact, double restitution) const;
    /// Moves the particle along its contact planes as far as possible. Does not change its velocity.
    void slide_along_contacts(Body& body, uint32_t particle, Vec3 displacement) const;

private:
    static constexpr uint32_t most_listed = 32, most_placed = 8;

    struct Near {
        gphys_model_id model;
        bool bounded, is_flat;
        Box box;
        FlatModel flat;
    };

    void record(Body& body, uint32_t particle, gphys_model_id model, Vec3 point, Vec3 normal) const;
    /// From the place of a model at one time to that at another, if its size is the same. Both places are kept, so that
    /// nothing cancels far from the origin, as it would in one shift.
    struct Motion {
        Mat3 rotation;
        Vec3 from, to;  // places of the model

        Motion() = default;
        Motion(const Transform& first, const Transform& second)
            : rotation(second.rotation * transposed(first.rotation)), from(first.position), to(second.position) {}
        Vec3 apply(Vec3 p) const { return to + rotation * (p - from); }
        Vec3 inverse_apply(Vec3 p) const { return from + transpose_times(rotation, p - to); }
        Vec3 inverse_turn(Vec3 v) const { return transpose_times(rotation, v); }
    };
    /// A model that moves, in this substep.
    struct Moving {
        gphys_model_id model;
        Transform begin, end, now;    // at the ends of the substep, and in the scene: at the end of the step
        Motion from_begin, from_end;  // to the place in the scene
        gphys_transform before;       // at the beginning of the step
        Vec3 spin;       // angular velocity, rad/s, up to a sixth of the square of the angle of the substep
        double tangent;  // of a quarter of the angle by which it turns in the substep
        bool bounded;
        Box box;  // in the scene

        Transform at(double time, const CollisionContext& around) const;
    };
    Moving moving(const PlacedModel& before) const;
    void list_moving(const Box& box);
    /// Calls visit(moving) for the nearby moving models, or for all if too many are near, that come into the box.
    template <class Visit>
    void for_each_moving(const Box& box, Visit&& visit) const;
    Box bounds_of_pushed(const Box& paths) const;
    void sweep_model(gphys_model_id model, const Sphere& moving, Vec3 displacement, Impact& first) const;
    void sweep_listed(const Near& near, const Sphere& moving, Vec3 displacement, const Box& path, Impact& first) const;
    void sweep_moved(const Moving& model, uint32_t particle, const Sphere& moving, Vec3 displacement, double time,
                     Impact& first) const;
    /// Sweeps against models that have not moved.
    void sweep_unmoved(uint32_t particle, Vec3 from, Vec3 displacement, gphys_model_id ignored, Impact& first) const;
    /// Sweeps against all but one that the particle is in.
    bool sweep_others(uint32_t particle, Vec3 from, Vec3 displacement, double time, gphys_model_id ignored,
                      Impact& first) const;
    /// Moves a particle that is in the model `of`, as far as other models that do not move allow. Returns false if
    /// `wall` is one of those.
    bool push(const Body& body, uint32_t particle, Vec3& at, Vec3 out, gphys_model_id of, Impact& wall) const;
    bool try_slide_on(const Moving& model, Body& body, uint32_t particle, Vec3 displacement, Vec3 velocity) const;
    Transform place_at_end(gphys_model_id moved) const;
    /// The impact at the end of the substep, if the particle moves with the model.
    Impact at_substep_end(const Impact& impact) const;

    const CollisionContext& around_;
    const Body& body_;
    const ImpulseAccumulator accumulator_;
    const double most_push_;
    bool listed_ = true;  // false if there are too many; then the scene is queried for each particle
    uint32_t count_ = 0;
    bool any_boxed_ = false;  // whether the box of a path decides about any of them
    Near near_[most_listed];
    uint32_t moving_count_ = 0;  // models that have moved and are near; the first of them are listed
    uint32_t moving_[most_listed];
    Moving placed_[most_placed];  // the first of them
    FlightPlanes* const planes_;
};

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
        const MovedModel& moved = (*around_.moved)[moving_[i]];
        if (!moved.bounded) return false;
        offer(widen(moved.swept), nullptr);
    }
    return true;
}

/// The velocity after an impact (Coulomb): `restitution` times the approach speed is restored, and friction takes at
/// most `friction` times the change along the normal.
Vec3 after_impact(Vec3 velocity, const Impact& impact, double restitution, double friction);

/// The bounding box of all particles' paths, enlarged for reflected paths and by `margin`.
Box swept_box(const Body& body, const Vector<Vec3>& from, const Vector<Vec3>& to, double margin);

/// For a body whose particles have just been moved from start to position.
void collide(Body& body, const CollisionContext& around, double bounce_threshold);

/// Whether a particle is slow enough to count as at rest: not faster than after a fall through four times its skin,
/// 9 mm/s for a radius of 1 cm. It may have been placed that far above a surface.
bool rests(const Body& body, uint32_t particle, Vec3 velocity, Vec3 gravity);

/// Call before and after the substep of a body that is not cloth, or some of its particles: which of them static
/// friction may hold.
void begin_friction(Body& body, Vec3 gravity, uint32_t first, uint32_t end);
void end_friction(Body& body, uint32_t first, uint32_t end);
inline void begin_friction(Body& body, Vec3 gravity) { begin_friction(body, gravity, 0, body.particles.size()); }
inline void end_friction(Body& body) { end_friction(body, 0, body.particles.size()); }

/// Call after collide, if there was contact: before the links are solved again while the particles in contact stay
/// where they are, ...
void relax_contacts(Body& body, const CollisionContext& around);

struct SolvedAgain {
    double step;  // seconds: a force f moves a particle of mass m by f / m * step^2
    double rate;  // 1/s: a correction of the position times this is that of the velocity

    /// Of a force that acts in the second solution.
    double to_impulse() const { return step * step * rate; }
};
/// ... and after it, to sweep what they have moved.
void collide_again(Body& body, const CollisionContext& around, double bounce_threshold, const SolvedAgain& again);
/// An impulse on a particle that friction holds goes to the model that it is held on.
void add_holder_impulse(Body& body, const CollisionContext& around, uint32_t particle, Vec3 impulse);

/// A speed that gravity adds in two substeps is too small to bounce.
inline double find_bounce_threshold(Vec3 gravity, double h) { return 2 * h * length(gravity); }

/// Call at the beginning and at the end of a step, for some particles or all; clear_contact_points is both at once.
void begin_contact_points(Body& body, uint32_t first, uint32_t end);
void end_contact_points(Body& body, uint32_t first, uint32_t end);
inline void begin_contact_points(Body& body) { begin_contact_points(body, 0, body.particles.size()); }
inline void end_contact_points(Body& body) { end_contact_points(body, 0, body.particles.size()); }
void clear_contact_points(Body& body);
/// Returns the index among the contact points of the particle; the last one if all are in use.
uint32_t record_contact_point(Body& body, uint32_t particle, const Scene& scene, gphys_model_id model, Vec3 point,
                              Vec3 normal);

inline bool collides(const Body& body, const CollisionContext& around) {
    return around.scene && body.settings.layers != 0;
}

}  // namespace gphys

// Contacts of ropes with models, solved together with the links.
//
// Search. When a step begins, and when a particle is about to leave its ball, particles search. Each gets a ball, and
// the convex features of models that it can reach in it: primitives and triangles. Each feature becomes a contact plane
// with the feature behind it (speculative contacts; Catto 2013). The plane of a primitive goes through the point
// closest to the particle. While it is active it follows the particle, from substep to substep and from iteration to
// iteration. Before that it stays, and separates particle and primitive as long as the particle is in front of it. The
// plane of a triangle is fixed. A particle that is in its ball and in front of all its planes overlaps nothing, so its
// path need not be swept.
//
// The planes of a model that moves move with it, from substep to substep. A particle searches as far as the model can
// approach in the rest of the step. Slip and speed of approach are relative to the model.
//
// Normal force. In each of Newton's iterations, a plane is active if its normal force is positive or the particle is
// behind it. Then it is a stiff spring along its normal; the others are absent (primal-dual active set; Hintermueller,
// Ito, Kunisch 2002).
//
// First guess. Contacts that a search finds on particles at rest start with the normal forces that the tensions of the
// last substep imply. Without them the first iteration is without friction, and a rope wound around a drum slides.
//
// Friction. It is another spring, which holds the particle at its place (stick), until it would exceed Coulomb's bound.
// Then it is the Coulomb force, against the direction of slip. So tensions, normal forces and friction belong to the
// same time, and tension passes around a post. If particles in contact were pinned while links are solved, none would.
//
// The iterations are those of rope_contact_lanes.cpp, or of rope_direct.cpp for what the kernels do not support.
#pragma once

#include "scene/closest_features.h"
#include "solver/body.h"
#include "solver/contact/collision.h"
#include "solver/contact/moving_colliders.h"
#include "solver/time_scheme.h"

namespace gphys {

struct RopeContact {
    enum State : uint8_t { open, slip, stick };

    gphys_model_id model = 0;  // 0: a bound of its animation target
    State state = open;
    bool is_fixed = false;    // whether the plane does not follow the particle
    bool is_updated = false;  // whether the plane is that for the place of the particle in this substep
    uint8_t iterations = 0;   // of this substep in which it was active
    uint32_t moving_collider = MovingCollider::unmoved;
    Vec3 normal;
    Vec3 carried;         // metres: by which the model carries the particle in the substep
    Vec3 placed_at;       // the place of the particle for which the plane was computed
    double outside;       // dot(normal, position) at a skin's distance
    double offset;        // that at which the contact holds the particle; smaller, if it was within the skin already
    double depth = 0;     // metres behind the offset at the beginning of the substep
    double approach = 0;  // m/s towards the model, of a particle without links
    // Forces are times the square of the step, kg m:
    double normal_force = 0;        // in the previous iteration
    Vec3 force;                     // all that has acted on the particle
    double stiffness = 0;           // kg, of the normal spring
    double friction_stiffness = 0;  // kg, of friction as a spring
    Vec3 slip_direction;            // unit
    // Of friction in the rest of the step, what the particle may get in this substep if it sticks:
    double ahead = 0;
    double jump = 0;  // m/s, in the model's velocity at the beginning of the substep
};

/// The contribution of contacts, and of loads, to the equation of a particle.
struct ContactTerm {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // kg
    Vec3 force;                                             // kg m

    /// Adds all + along n n^T.
    void add_stiffness(Vec3 n, double along, double all) {
        const Vec3 v = n * along;
        xx += all + n.x * v.x, xy += n.x * v.y, xz += n.x * v.z;
        yy += all + n.y * v.y, yz += n.y * v.z, zz += all + n.z * v.z;
    }
    /// Adds the inertia of the loads of a particle.
    void add_loads(const Body& body, uint32_t p) {
        for (const RopeLoad& load : body.rope.loads.all) {
            if (load.particle != p) continue;
            add_stiffness(load.normal, load.along - load.across, load.across);
            force += load.momentum(body.history.predicted[p] - body.particles.position[p]);
        }
    }
};

/// Between the centre of a particle and a surface that it touches, metres.
inline double clearance(double radius, Vec3 at) { return radius + skin(radius, at); }

class RopeContacts {
public:
    explicit RopeContacts(std::pmr::memory_resource* memory)
        : moving_colliders_(memory), contacts_(memory), first_(memory), balls_(memory) {}

    /// Allocates memory for a rope. Throws std::bad_alloc.
    void reserve(uint32_t particles, size_t moving_models);
    /// Call before the substeps of a step. Without models near the body, only targets count. `moving_models`: whether
    /// some models near it move. `features`: memory for searches.
    void begin_step(const Body& body, const CollisionContext& around, bool near_models, bool moving_models,
                    ClosestFeatures& features);
    /// The positions have changed, so the next substep searches.
    void search_again() { searched_ = !near_models_; }
    bool near_models() const { return near_models_; }
    /// Call after the prediction. Returns false if a particle is deeper in a solid than it can leave at once, or near a
    /// model that changes its size or turns too fast to be followed.
    bool begin(Body& body, const CollisionContext& around, Vec3 gravity, const TimeScheme& scheme);

    bool has_contacts(uint32_t particle) const { return first_[particle] < first_[particle + 1]; }
    /// Whether any contact of the particle is active.
    bool has_active(uint32_t particle) const {
        for (uint32_t i = first_[particle]; i < first_[particle + 1]; ++i) {
            if (contacts_[i].state != RopeContact::open) return true;
        }
        return false;
    }
    /// The contribution of the particle's contacts. `mass`: kg, of the particle and of the lateral stiffness of its
    /// links.
    ContactTerm term(const Body& body, uint32_t particle, double mass);
    /// Call after an iteration. Returns whether all contacts have converged.
    bool update(const Body& body, int iteration);
    /// Call after the last iteration: moves particles out of contacts that they are still in (position projection).
    void push_out(Particles& particles) const;
    /// Call after the velocities have been computed: restitution, contact points, and impulses on models.
    void finish(Body& body, const CollisionContext& around, double bounce_threshold, const TimeScheme& scheme);

private:
    static constexpr uint32_t most_planes = 4;          // of models, per particle
    static constexpr uint32_t bounds_per_particle = 2;  // with targets: ball and backstop, which come first

    /// Where the particle can move without a search.
    struct Ball {
        Vec3 center;
        double radius;
    };
    template <class Visit>
    void each(uint32_t particle, Visit&& visit) {
        for (uint32_t i = first_[particle]; i < first_[particle + 1]; ++i) visit(contacts_[i]);
    }
    template <class Visit>
    void each_of_models(uint32_t particle, Visit&& visit) {
        const uint32_t first = first_[particle] + (has_targets_ ? bounds_per_particle : 0);
        for (uint32_t i = first; i < first_[particle + 1]; ++i) visit(contacts_[i]);
    }
    bool in_ball(uint32_t particle, Vec3 at) const {
        const Ball& ball = balls_[particle];
        return length_squared(at - ball.center) < ball.radius * ball.radius;
    }
    bool search(const Body& body, const CollisionContext& around, Vec3 gravity, double h);
    bool choose_balls(const Body& body, uint32_t first, uint32_t count, double rest, double fall);
    bool find_features(const Body& body, uint32_t first, uint32_t count);
    void place_probes(double particle_radius, Vec3 at, double ball_radius, uint32_t point);
    void make_contacts(uint32_t particle, Vec3 at, double particle_radius, uint32_t point);
    void move_planes(const CollisionContext& around, double to);
    bool is_followed(gphys_model_id model) const;
    void guess_forces(Body& body, double step);
    bool is_slow(const RopeContact& contact, const Body& body, uint32_t particle) const;
    void begin_particle(uint32_t particle);
    void begin_contact(RopeContact& contact, const Body& body, uint32_t particle) const;
    Vec3 surface_velocity(const RopeContact& contact) const { return contact.carried / seconds_; }
    void place_plane(RopeContact& contact, double radius, Vec3 at) const;
    void place_bounds(const AnimationTargets& targets, const Vector<Vec3>& positions);
    bool update(RopeContact& contact, const Body& body, uint32_t particle, int iteration) const;
    void sweep_escaped(Body& body, const CollisionContext& around, double bounce_threshold);

    const Scene* scene_ = nullptr;
    bool near_models_ = false;
    bool searched_ = false;  // whether balls and contacts are valid
    bool active_ = false;    // whether there are contacts
    bool has_targets_ = false;
    Vector<MovingCollider> moving_colliders_;
    Vec3 origin_;                   // of these
    double planes_at_ = 0;          // fraction of the step for which the planes are placed
    double seconds_ = 0;            // of the substep
    Vector<RopeContact> contacts_;  // by particle, including the bounds of targets
    Vector<uint32_t> first_;        // index of each particle's first contact, and the end
    Vector<Ball> balls_;
    ClosestFeatures* features_ = nullptr;
    NearColliders near_;  // moving models near the particles that search
    // By point; for moving models at the end of the step:
    Sphere probes_[ClosestFeatures::most_points], moving_probes_[NearColliders::most][ClosestFeatures::most_points];
};

}  // namespace gphys

// Contacts of ropes with static models, solved together with the links.
//
// When a step begins, and when a particle is about to leave its ball, particles search. Each gets a ball, and the
// convex parts of models that it can reach in it: primitives and triangles. Each part becomes a contact plane with the
// part behind it (speculative contacts; Catto 2013). The plane of a primitive goes through the point closest to the
// particle. While it is active it follows the particle, from substep to substep and from iteration to iteration; before
// that it separates particle and part as long as the particle is in front of it. The plane of a triangle stays.
// A particle that is in its ball and in front of all its planes overlaps nothing, so its path need not be swept.
//
// In each of Newton's iterations, a plane is active if it presses or if the particle is behind it. Then it is a stiff
// spring along its normal; the others are absent (primal-dual active set; Hintermueller, Ito, Kunisch 2002). Friction
// is another spring that holds the particle at its place, until that would exceed Coulomb's law. Then it is the Coulomb
// force, against the sliding direction. So tensions, normal forces and friction belong to the same time. Pinning
// particles in contact while links are solved would let no tension pass a post.
//
// The iterations are those of ropes_beside_models.cpp, or of rope_direct.cpp for what the kernels do not have.
#pragma once

#include "scene/closest_features.h"
#include "solver/body.h"
#include "solver/contact/collision.h"
#include "solver/time_scheme.h"

namespace gphys {

struct RopeContact {
    enum State : uint8_t { apart, slides, sticks };

    gphys_model_id model = 0;  // 0: a bound of its animation target
    State state = apart;
    bool is_fixed = false;   // whether the plane does not follow the particle
    bool is_placed = false;  // whether it follows the particle in this substep
    uint8_t iterations = 0;  // of this substep in which it was active
    Vec3 normal;
    Vec3 placed;          // the place of the particle that the plane is for
    double outside;       // at dot(normal, position) >= this, the particle is a skin away
    double offset;        // at >= this it stays there; smaller, if it was within the skin already
    double depth = 0;     // metres behind that at the beginning of the substep
    double approach = 0;  // m/s, of a particle without links
    // Forces are times the square of the step, kg m:
    double pressed = 0;    // along the normal, in the previous iteration
    Vec3 force;            // all that has acted on the particle
    double stiffness = 0;  // kg
    double drag = 0;       // kg, of friction as a spring
    Vec3 way;              // unit, sliding direction
};

/// The contribution of contacts to the equation of a particle.
struct ContactTerm {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // kg
    Vec3 force;                                             // kg m

    /// all + along n n^T
    void add_stiffness(Vec3 n, double along, double all) {
        const Vec3 v = n * along;
        xx += all + n.x * v.x, xy += n.x * v.y, xz += n.x * v.z;
        yy += all + n.y * v.y, yz += n.y * v.z, zz += all + n.z * v.z;
    }
};

class RopeContacts {
public:
    explicit RopeContacts(std::pmr::memory_resource* memory) : contacts_(memory), first_(memory), balls_(memory) {}

    /// Allocates memory for a rope. Throws std::bad_alloc.
    void reserve(uint32_t particles);
    /// Call before the substeps of a step. If not beside models, only targets count. `parts`: memory for searches.
    void begin_step(const Body& body, bool beside_models, ClosestFeatures& parts);
    void search_again() { searched_ = !beside_models_; }
    bool beside_models() const { return beside_models_; }
    /// Call after the prediction. Returns false if a particle is deeper in a solid than it can leave at once.
    bool begin(Body& body, const CollisionContext& around, Vec3 gravity, double h);

    bool any(uint32_t particle) const { return first_[particle] < first_[particle + 1]; }
    /// Whether any is active.
    bool acts(uint32_t particle) const {
        for (uint32_t i = first_[particle]; i < first_[particle + 1]; ++i) {
            if (contacts_[i].state != RopeContact::apart) return true;
        }
        return false;
    }
    /// `mass`: of the particle, plus the lateral stiffness of its links.
    ContactTerm term(const Body& body, uint32_t particle, double mass);
    /// Call after an iteration. Returns whether the states of all contacts were right.
    bool update(const Body& body, int iteration);
    /// Call after the last iteration: moves particles out of contacts that they are still in.
    void keep_out(Body& body) const;
    /// Call after the velocities have been computed: contact points, bounces, and impulses of models.
    void finish(Body& body, const CollisionContext& around, double quiet, const TimeScheme& scheme);

private:
    static constexpr uint32_t most_parts = 4;           // per particle
    static constexpr uint32_t bounds_per_particle = 2;  // with targets: ball and backstop, which come first

    struct Ball {
        Vec3 center;
        double reach;
    };
    template <class Visit>
    void each(uint32_t particle, Visit&& visit) {
        for (uint32_t i = first_[particle]; i < first_[particle + 1]; ++i) visit(contacts_[i]);
    }
    template <class Visit>
    void each_of_models(uint32_t particle, Visit&& visit) {
        const uint32_t first = first_[particle] + (bounded_ ? bounds_per_particle : 0);
        for (uint32_t i = first; i < first_[particle + 1]; ++i) visit(contacts_[i]);
    }
    bool in_ball(const Body& body, uint32_t p) const {
        return length_squared(body.particles.position[p] - balls_[p].center) < balls_[p].reach * balls_[p].reach;
    }
    void search(const Body& body, const CollisionContext& around, Vec3 gravity, double h);
    bool collect(const Body& body, uint32_t first, uint32_t count);
    void settle(const Body& body, uint32_t particle, uint32_t point);
    void begin_particle(uint32_t particle);
    void begin_contact(RopeContact& contact, const Body& body, uint32_t particle) const;
    void place_plane(RopeContact& contact, const Body& body, uint32_t particle, Vec3 at) const;
    void allow_within_skin(RopeContact& contact, const Body& body, uint32_t particle) const;
    void place_ball(RopeContact& contact, const Body& body, uint32_t particle, Vec3 at) const;
    void place_bounds(const Body& body);
    bool update(RopeContact& contact, const Body& body, uint32_t particle, int iteration) const;
    void sweep_escaped(Body& body, const CollisionContext& around, double quiet);

    const Scene* scene_ = nullptr;
    bool beside_models_ = false, searched_ = false, active_ = false;
    bool bounded_ = false;          // whether the rope has targets
    Vector<RopeContact> contacts_;  // by particle, including the bounds of targets
    Vector<uint32_t> first_;        // index of each particle's first contact, and the end
    Vector<Ball> balls_;
    ClosestFeatures* parts_ = nullptr;
    Sphere probes_[ClosestFeatures::most_points];
};

}  // namespace gphys

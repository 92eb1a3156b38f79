// Ropes on models that stand still: what particles touch is solved for together with the links.
//
// When a step begins, and when one is about to leave its ball, particles look around: each gets a ball to move in and
// the convex parts of models that it can touch there, a primitive or a triangle. A part is met as a plane that has it
// behind. That of a primitive goes through the point which is nearest to the particle and follows it, from substep to
// substep and from iteration to iteration; that of a triangle stays. A particle in front of all its planes, and in its
// ball, is outside of everything, so that what it passes need not be swept.
//
// In each of Newton's iterations a plane that presses, or that a particle is behind, is a stiff spring along the
// normal, the others are absent (a primal-dual active set). Friction holds a particle at its place as another spring,
// until that takes more than Coulomb's law allows; then it is this force, against the way that the particle goes.
// Tensions, pressures and friction are therefore those of one moment: to hold in place what touches while links are
// solved would let no tension pass a post.
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
    bool is_fixed = false;   // the plane, which then does not follow the particle
    uint8_t iterations = 0;  // of this substep in which it has acted
    Vec3 normal;
    double outside;       // where dot(normal, position) is at least this, the particle is a skin away
    double offset;        // it stays where that is at least this: what lies within a skin already stays there
    double depth = 0;     // metres by which it begins the substep behind that
    double approach = 0;  // m/s, of a particle without links
    // Forces times the square of the step, kg m:
    double pressed = 0;    // along the normal, of the iteration before
    Vec3 force;            // all that has acted on the particle
    double stiffness = 0;  // kg
    double drag = 0;       // kg, of friction that is a spring
    Vec3 way;              // unit, in which it slides
};

/// What contacts add to the equation of a particle.
struct ContactTerm {
    Vec3 x, y, z;  // columns of the matrix
    Vec3 force;
};

class RopeContacts {
public:
    explicit RopeContacts(std::pmr::memory_resource* memory) : contacts_(memory), first_(memory), balls_(memory) {}

    /// Room for a rope. Throws std::bad_alloc.
    void reserve(uint32_t particles);
    /// Before the substeps of a step. Not beside models: only targets count.
    void begin_step(const Body& body, bool beside_models);
    void search_again() { searched_ = !beside_models_; }
    bool beside_models() const { return beside_models_; }
    /// Once the particles are predicted. False if one of them is in a solid deeper than it comes out at once.
    bool begin(Body& body, const CollisionContext& around, Vec3 gravity, double h);

    bool any(uint32_t particle) const { return first_[particle] < first_[particle + 1]; }
    /// `mass`: of the particle, and what its links resist sideways.
    ContactTerm term(const Body& body, uint32_t particle, double mass);
    /// After an iteration. Whether all contacts are what they were taken for.
    bool update(const Body& body, int iteration);
    /// After the last: out of what the iterations have left a particle in.
    void keep_out(Body& body) const;
    /// Once velocities have followed from the positions: the touches, the bounces, and what models get.
    void finish(Body& body, const CollisionContext& around, double quiet, const TimeScheme& scheme);

private:
    static constexpr uint32_t most_parts = 4;           // of a particle
    static constexpr uint32_t bounds_per_particle = 2;  // of a rope with targets, its first: the ball and the backstop

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
    void place_plane(RopeContact& contact, const Body& body, uint32_t particle, Vec3 at) const;
    void allow_within_skin(RopeContact& contact, const Body& body, uint32_t particle) const;
    void place_ball(RopeContact& contact, const Body& body, uint32_t particle, Vec3 at) const;
    void place_bounds(const Body& body);
    bool update(RopeContact& contact, const Body& body, uint32_t particle, int iteration) const;
    void sweep_escaped(Body& body, const CollisionContext& around, double quiet);

    const Scene* scene_ = nullptr;
    bool beside_models_ = false, searched_ = false, active_ = false;
    bool bounded_ = false;          // whether the rope has targets
    Vector<RopeContact> contacts_;  // by particle, bounds of targets included
    Vector<uint32_t> first_;        // in contacts_, of each particle and of none behind the last
    Vector<Ball> balls_;
    ClosestFeatures parts_;
    Sphere probes_[ClosestFeatures::most_points];
};

}  // namespace gphys

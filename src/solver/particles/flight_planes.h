// What particles know of the models around them, for the rest of a step: a particle searches once and does not sweep
// against meshes in each substep.
//
// A slow particle, such as one that lies on a mesh, gets a ball, and the planes of the convex parts of models that it
// could reach in it (speculative contacts; Catto 2013). The first hit of a path within the ball then takes one division
// per plane. The ball has the radius of the particle, and only slow particles use it, because the planes are those of
// the place of the search, and edges are round. Beside a model that moves the particle has a second ball, in the space
// of that model.
//
// A fast particle searches the box around its way to the end of the step. If no model overlaps it, nothing is tested
// before the step ends. For a model that moves, that is the way relative to the model.
//
// A particle that friction holds on a static model in one substep is held in the others too, unless a model that moves
// may reach it.
//
// The result of a particle does not depend on others: it searches from its own positions, and has its own memory.
#pragma once

#include "scene/closest_features.h"
#include "solver/contact/collision.h"
#include "solver/particles/flight_balls.h"

namespace gphys {

/// The flight of a particle from some time of the step to its end, if it hits nothing.
struct FlightWay {
    double begin;      // fraction of the step
    double seconds;    // of the rest
    Vec3 from, to;     // centres
    Aabb box;          // contains all centres
    double speed;      // the largest, m/s
    double curvature;  // the largest acceleration, m/s^2
};

/// For a block of particles, in a step. About 280 KB: each worker has one, which `prepare` allocates.
class FlightPlanes {
public:
    static constexpr uint32_t most_particles = 512;

    /// Resets all particles to "not searched", except those whose ball has been kept.
    void begin(Body& body, const CollisionContext& step, Vec3 gravity, uint32_t first, uint32_t count);
    /// For a block of a body whose particles others push in each substep: selects it, with what its particles have
    /// found of models that do not move. That is in the balls of the body, so these must be kept. Nothing is known of
    /// moving models, of ways to the end of the step, and of particles at rest.
    void select_pushed(Body& body, const CollisionContext& substep, uint32_t first, uint32_t count);
    /// The same before a substep, the first of which resets the balls.
    void begin_pushed(Body& body, const CollisionContext& substep, uint32_t first, uint32_t count);
    /// The first hit of a slow particle on a path; `reach` is the distance that it can go in the rest of the step.
    /// Returns false if it is not known.
    bool sweep(const Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double reach, Impact& impact);
    /// The same for a particle that has been slow in this step, whatever it may do later.
    bool sweep_known(const Body& body, uint32_t particle, Vec3 from, Vec3 displacement, Impact& impact) const;
    /// The same relative to a model that moves, at its place in the scene.
    TriState sweep_moving(const Body& body, uint32_t particle, gphys_model_id model, Vec3 from, Vec3 displacement,
                          Hit& hit);
    /// What the particle knows of that model, if the path is in the ball; searches if it pays. Else null.
    const FlightBall* moving_ball(const Body& body, uint32_t particle, gphys_model_id model, Vec3 from,
                                  Vec3 displacement);
    /// Whether the particle knows that model.
    bool has_searched(uint32_t particle, gphys_model_id model) const {
        return !pushed_ && moving_of_[particle - first_] == model;
    }
    /// Whether the particle hits nothing in the rest of the step; searches once.
    bool flies(const Body& body, uint32_t particle, const FlightWay& way) {
        if (pushed_) return false;
        const uint32_t i = particle - first_;
        if (ways_[i] == Sight::not_searched) ways_[i] = search_way(body.particles.radius[particle], way);
        return ways_[i] == Sight::clear;
    }
    /// Whether that has been found.
    bool flies(uint32_t particle) const { return !pushed_ && ways_[particle - first_] == Sight::clear; }
    bool pushed() const { return pushed_; }
    /// Particles that rest on a plane until the step ends.
    void set_rests(uint32_t particle) {
        rests_[particle - first_] = true;
        ++resting_;
    }
    bool rests(uint32_t particle) const { return !pushed_ && rests_[particle - first_]; }
    bool all_rest() const { return !pushed_ && resting_ == count_; }
    /// Whether no model that moves comes near the ball of the particle.
    bool still(uint32_t particle) const { return still_[particle - first_]; }

private:
    void select(const Body& body, const CollisionContext& step, uint32_t first, uint32_t count);
    void reset_balls(const Body& body, bool keep);
    void find_still(const Body& body, double way);
    bool is_moved(gphys_model_id model) const;
    Sight search_way(double radius, const FlightWay& way) const;
    bool crosses(const MovedModel& before, double radius, const FlightWay& way) const;
    void search(const Body& body, uint32_t particle);
    bool search_together(const Body& body, uint32_t particle, uint32_t count);
    void settle(double radius, uint32_t point, FlightBall& ball);
    FlightBall& ball(uint32_t particle) { return balls_[particle - first_]; }
    const FlightBall& ball(uint32_t particle) const { return balls_[particle - first_]; }

    static constexpr uint32_t most_moving = 16, most_near = 1024;

    const Scene* scene_ = nullptr;
    uint32_t first_ = 0, count_ = 0;
    bool pushed_ = false;
    uint32_t layers_ = 0;
    double share_ = 1;  // of the step (CollisionContext)
    const Vector<MovedModel>* moved_ = nullptr;
    uint32_t moving_count_ = 0, moving_[most_moving];  // those of `moved` that may come near
    uint32_t near_[most_near];                         // and those that may come near the balls
    FlightBall* balls_ = nullptr;                      // those of the body, or own_balls_
    FlightBall own_balls_[most_particles];
    FlightBall moving_balls_[most_particles];   // relative to one model that moves,
    gphys_model_id moving_of_[most_particles];  // this one, or 0
    bool still_[most_particles];
    bool rests_[most_particles];
    uint32_t resting_ = 0;
    Sight ways_[most_particles];
    ClosestFeatures parts_;
    Sphere probes_[ClosestFeatures::most_points];
};

}  // namespace gphys

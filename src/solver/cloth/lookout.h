// What is near a particle of cloth: the ball in which it may move, and the walls that it must stay in front of.
#pragma once

#include "scene/near_parts.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {

/// Looks around for the particles of a body, at the end of a substep or the beginning of the step. Particles that
/// follow each other and lie together do it together.
class Lookout {
public:
    /// `time`: seconds until the particles look around again.
    Lookout(const Surroundings& around, Body& body, Vec3 gravity, double time)
        : around_(around), body_(body), gravity_(gravity), time_(time), most_push_(leaving_speed * seconds(around)) {}

    /// Find the balls and the walls of particles, which are pushed out of what they are in. What they have touched
    /// before is recorded.
    void look(const uint32_t* particles, uint32_t count);
    /// The same from where they have looked before, with nothing moving around, for walls and balls alone.
    void look_again(const uint32_t* particles, uint32_t count);

private:
    static constexpr uint32_t most_points = NearParts::most_points;
    // Models that move near particles; one with more around it has no ball.
    static constexpr uint32_t most_movers = 8;
    // Among more parts a particle sees less far: walls are planes, and that of a part far off keeps it from much
    // that is free.
    static constexpr uint32_t most_parts = 64;

    /// Of the substep; at the beginning of a step, of one that is short.
    static double seconds(const Surroundings& around) {
        constexpr double short_substep = 0.002;
        return around.end > around.begin ? around.step_time * (around.end - around.begin)
                                         : std::min(around.step_time, short_substep);
    }
    void look_from_looked(const uint32_t* particles, uint32_t count);
    Vec3 place_of(uint32_t p) const { return get(&body_.cloth.looked[4 * size_t{p}]); }
    double farthest(uint32_t p) const;
    uint32_t count_together(const uint32_t* particles, uint32_t count) const;
    bool look_together(const uint32_t* particles, uint32_t count);
    void look_alone(uint32_t p);
    bool find_movers_near(const Aabb& places, double range);
    double wanted_reach(uint32_t p) const;
    double reach(uint32_t p);
    bool collect(const uint32_t* particles, uint32_t count);
    void place_balls(uint32_t p, uint32_t point);
    void settle(uint32_t p, uint32_t point);
    double push_out(float* ball, Neighbour& found) const;
    void choose_walls(uint32_t p, Vec3 at, double& reach, Neighbour& found);
    double nearest_in_step(uint32_t mover, double distance, Vec3 at) const;

    const Surroundings& around_;
    Body& body_;
    const Vec3 gravity_;
    const double time_;
    const double most_push_;  // out of what a particle is in
    bool again_ = false;
    uint32_t near_movers_[most_movers];  // numbers in the body's list
    uint32_t mover_count_ = 0;
    double reach_[most_points];  // metres beyond the particle's radius
    // By point, and for models that move as the scene has them, at the end of the step:
    Sphere balls_[most_points], moving_balls_[most_movers][most_points];
    NearParts parts_;
};

}  // namespace gphys

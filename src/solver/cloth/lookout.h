// What is near a particle of cloth: the ball in which it may move, and the walls that it must stay in front of.
#pragma once

#include "solver/contact/collision.h"

namespace gphys {

/// Looks around for the particles of a body, at the end of a substep or the beginning of the step.
class Lookout {
public:
    /// `time`: seconds until the particles look around again.
    Lookout(const Surroundings& around, Body& body, double time) : around_(around), body_(body), time_(time) {}

    /// Find the ball and the walls of a particle, which is pushed out of what it is in. What it has touched
    /// before is recorded.
    void look(uint32_t p, Vec3 gravity);

private:
    // Parts of models that a particle looks at; where a ball holds more it is made smaller.
    static constexpr uint32_t most_parts = 64;
    // Models that move near a particle; among more it has no ball.
    static constexpr uint32_t most_movers = 8;

    void find_movers_near(Vec3 at, double reach);
    uint32_t collect(Vec3 at, double reach);
    void choose_walls(uint32_t p, Vec3 at, uint32_t count, double& reach, Neighbour& found);
    double nearest_in_step(uint32_t part, Vec3 at) const;
    bool is_behind(uint32_t part, double off, const Neighbour& found) const;

    const Surroundings& around_;
    Body& body_;
    const double time_;
    uint32_t near_movers_[most_movers];  // numbers in the body's list
    uint32_t mover_count_ = 0;
    bool follows_all_ = true;  // otherwise there are too many, or some turn too fast to follow
    NearPart parts_[most_parts];
    gphys_model_id models_[most_parts];
    uint32_t movers_[most_parts];  // by part: the number of its mover
    uint32_t order_[most_parts];
};

}  // namespace gphys

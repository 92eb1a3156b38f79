// What slow particles know of models that stand still, such as those that lie on a mesh.
//
// To sweep a sphere against a mesh takes a microsecond. A particle that hardly moves looks around once a step instead
// and gets a ball, and the planes of the convex parts of models that it could touch there: what it meets on a path
// within the ball is found by a division for each plane. Only slow ones do so, whose ball is no wider than their
// radius: the planes belong to where they looked, and edges are round.
#pragma once

#include "scene/near_parts.h"
#include "solver/contact/collision.h"

namespace gphys {

/// Of a block of particles, in a step.
class FlightWalls {
public:
    static constexpr uint32_t most_particles = 512;

    /// Nobody has looked yet, with so many seconds of the step left.
    void begin(const Body& body, const Surroundings& step, uint32_t first, uint32_t count);
    /// What the particle meets first on a path. False if that is not known.
    bool sweep(const Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double reach, Impact& impact);

private:
    static constexpr uint32_t most_walls = 640, most_of_a_particle = 3;

    struct Wall {
        Vec3 normal;
        double height;  // the particle touches where dot(normal, its position) is this
        gphys_model_id model;
    };
    struct Ball {
        Vec3 center;
        float reach = -1;  // metres; < 0: has not looked
        uint16_t first = 0, count = 0;
    };
    void look(const Body& body, uint32_t particle, double reach);
    void settle(const Body& body, uint32_t particle, uint32_t point);
    Ball& ball(uint32_t particle) { return balls_[particle - first_]; }

    const Scene* scene_ = nullptr;
    uint32_t first_ = 0, count_ = 0, wall_count_ = 0;
    bool usable_ = false;  // no model that moves is near
    Ball balls_[most_particles];
    Wall walls_[most_walls];
    NearParts parts_;
    Sphere probes_[NearParts::most_points];
};

}  // namespace gphys

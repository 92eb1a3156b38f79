// What slow particles know of models that stand still, such as those that lie on a mesh.
//
// To sweep a sphere against a mesh takes a microsecond. A particle that hardly moves looks around once a step instead
// and gets a ball, and the planes of the convex parts of models that it could touch there: what it meets on a path
// within the ball is found by a division for each plane. The ball is as wide as the particle and only slow ones use it:
// the planes belong to where they looked, and edges are round. What a particle finds does not depend on others: it
// looks from where it was when the step began, and has room of its own.
#pragma once

#include "scene/closest_features.h"
#include "solver/contact/collision.h"

namespace gphys {

/// Of a block of particles, in a step. Some 100 KB: each worker has one, which `prepare` makes room for.
class FlightPlanes {
public:
    static constexpr uint32_t most_particles = 512;

    /// Nobody has looked yet, with so many seconds of the step left.
    void begin(const Body& body, const CollisionContext& step, uint32_t first, uint32_t count);
    /// What the particle meets first on a path. False if that is not known.
    bool sweep(const Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double reach, Impact& impact);

private:
    static constexpr uint32_t most_planes = 2;  // of a particle

    struct Plane {
        Vec3 normal;
        double height;  // the particle touches where dot(normal, its position) is this
        gphys_model_id model;
    };
    enum Sight : uint32_t { not_searched, clear, blocked };
    struct Ball {
        Vec3 center;
        Sight sight;
        uint32_t count;  // of planes
    };
    void search(const Body& body, uint32_t particle);
    bool search_together(const Body& body, uint32_t particle, uint32_t count);
    void settle(const Body& body, uint32_t particle, uint32_t point);
    Ball& ball(uint32_t particle) { return balls_[particle - first_]; }

    const Scene* scene_ = nullptr;
    uint32_t first_ = 0, count_ = 0;
    bool usable_ = false;  // no model that moves is near
    Ball balls_[most_particles];
    Plane planes_[most_particles][most_planes];
    ClosestFeatures parts_;
    Sphere probes_[ClosestFeatures::most_points];
};

}  // namespace gphys

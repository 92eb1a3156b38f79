// Contact planes of slow particles near static models, such as particles that lie on a mesh.
//
// Sweeping a sphere against a mesh takes a microsecond. A slow particle instead searches once per step. It gets a ball,
// and the planes of the convex parts of models that it could reach in it (speculative contacts; Catto 2013). The first
// hit of a path within the ball then takes one division per plane. The ball has the radius of the particle, and only
// slow particles use it, because the planes are those of the place of the search, and edges are round. The result of a
// particle does not depend on others: it searches from its position at the beginning of the step, and has its own
// memory.
#pragma once

#include "scene/closest_features.h"
#include "solver/contact/collision.h"

namespace gphys {

/// For a block of particles, in a step. About 100 KB: each worker has one, which `prepare` allocates.
class FlightPlanes {
public:
    static constexpr uint32_t most_particles = 512;

    /// Resets all particles to "not searched", with the rest of the step ahead.
    void begin(const Body& body, const CollisionContext& step, uint32_t first, uint32_t count);
    /// The first hit of a particle on a path. Returns false if it is not known.
    bool sweep(const Body& body, uint32_t particle, Vec3 from, Vec3 displacement, double reach, Impact& impact);

private:
    static constexpr uint32_t most_planes = 2;  // per particle

    struct Plane {
        Vec3 normal;
        double height;  // contact if dot(normal, position of the particle) equals it
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
    bool usable_ = false;  // whether no moving model is near
    Ball balls_[most_particles];
    Plane planes_[most_particles][most_planes];
    ClosestFeatures parts_;
    Sphere probes_[ClosestFeatures::most_points];
};

}  // namespace gphys

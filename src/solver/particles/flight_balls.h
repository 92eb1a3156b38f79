// What free particles have found around them (flight_planes.h). A particle at rest finds the same in the next step, so
// its ball is kept until a model near the body begins or ceases to move, or changes otherwise.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "gamephys_c.h"

namespace gphys {

enum class Sight : uint8_t { not_searched, clear, blocked };

/// Where a slow particle may move, and the planes that it may touch there.
struct FlightBall {
    static constexpr uint32_t most_planes = 4;
    struct Plane {
        Vec3 normal;
        double height;  // contact if dot(normal, position of the particle) equals it
        gphys_model_id model;
    };

    bool contains(Vec3 at, double radius) const { return length_squared(at - center) < radius * radius; }
    /// The first plane that a path meets, at `t` of it, and null if it meets none; of simultaneous ones that of the
    /// lower id. Returns false if it is not known: the path leaves the ball, or begins behind a plane.
    bool sweep(Vec3 from, Vec3 displacement, double radius, const Plane*& first, double& t) const;
    /// The plane that a path meets first, or if none that a particle touches at its beginning, with a gap of at most
    /// `gap`. Null if there is none, or it is not known.
    const Plane* find_contact(Vec3 from, Vec3 displacement, double radius, double gap) const;
    /// Whether a particle there is in the ball, and behind none of its planes but that one.
    bool clear_of_others(const Plane& plane, Vec3 at, double radius) const;

    Vec3 center;
    Plane planes[most_planes];
    uint32_t count = 0;
    Sight sight = Sight::not_searched;
    bool in_use = false;  // the particle has been slow in this step
};

/// By particle, of a body near meshes, or near any model if others may push its particles; else empty. Not in
/// snapshots: a search at the same place finds the same.
struct FlightBalls {
    explicit FlightBalls(std::pmr::memory_resource* memory) : all(memory) {}

    bool current() const { return surroundings == last_surroundings; }
    void forget() { last_surroundings = 0; }

    Vector<FlightBall> all;
    // Hash of the models near that do not move, in this step and the last one.
    uint64_t surroundings = 0, last_surroundings = 0;
};

}  // namespace gphys

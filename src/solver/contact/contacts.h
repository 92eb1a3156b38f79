// What the contacts of a body leave: which models its particles touch, which of them friction holds, and what models
// have got from it.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/contact/impulses.h"
#include "solver/particles/particles.h"

namespace gphys {

/// A model that a particle touched in the last step; model 0 is none.
struct ContactPoint {
    gphys_model_id model = 0;
    uint32_t tag = 0;
    gphys_vec3 point{}, normal{};
};
constexpr uint32_t contact_points_per_particle = 4;  // a corner is three models; one more for good measure

/// Of a body of free particles that workers may share: what it gives to models in a step.
struct FlightPart {
    explicit FlightPart(std::pmr::memory_resource* memory) : impulses(memory) {}

    Vector<ModelImpulse> impulses;
    bool has_contact = false;
    Extent extent;
};
/// Particles in a part, some 0.3 ms of work: many times what it takes to hand it out.
constexpr uint32_t part_size = 16384;

/// Of a body that collides with itself: where its particles were placed, and to which each is linked:
/// linked[linked_begin[p] .. linked_begin[p + 1]], ascending.
struct SelfCollision {
    explicit SelfCollision(std::pmr::memory_resource* memory) : placed(memory), linked_begin(memory), linked(memory) {}

    Vector<Vec3> placed;
    Vector<uint32_t> linked_begin, linked;
};

struct Contacts {
    explicit Contacts(std::pmr::memory_resource* memory)
        : points(memory),
          point_count(memory),
          impulses(memory),
          parts(memory),
          held(memory),
          stuck(memory),
          self(memory) {}

    Vector<ContactPoint> points;    // contact_points_per_particle each; empty until the body meets a scene
    Vector<uint8_t> point_count;    // by particle: how many of its touches there are
    Vector<ModelImpulse> impulses;  // by model, of the last step
    Vector<FlightPart> parts;       // of free particles, if there are several; empty between steps
    /// By particle: 0, or if it touched something in the substep under way one more than the place of the
    /// last such in its touches.
    Vector<uint8_t> held;
    Vector<uint32_t> stuck;    // by particle, if it sticks: whether friction has held it to a model, or it rests
    bool has_contact = false;  // whether any did, unless the caller has interrupted the motion since
    bool near = false;         // particles of it may touch others in this substep
    bool sunk = false;         // some are in models, deeper than they come out at once, in this substep
    SelfCollision self;
};

}  // namespace gphys

// The results of a body's contacts: the contact points of its particles, the particles that friction holds, and the
// impulses on models.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/contact/impulses.h"
#include "solver/particles/particles.h"

namespace gphys {

/// A contact of a particle in the last step. Model 0: none.
struct ContactPoint {
    gphys_model_id model = 0;
    uint32_t tag = 0;
    gphys_vec3 point{}, normal{};
};
constexpr uint32_t contact_points_per_particle = 4;  // a corner has three models; one in reserve

/// Part of a body of free particles, for one of several workers: its impulses on models in a step.
struct FlightPart {
    explicit FlightPart(std::pmr::memory_resource* memory) : impulses(memory) {}

    Vector<ModelImpulse> impulses;
    bool has_contact = false;
    Extent extent;
};
/// Particles in a part of a body on its own: some 0.3 ms of work, many times the cost of handing it out.
constexpr uint32_t part_size = 16384;
/// The same of a body in an island that a team may move, substep by substep: those that query the scene together.
constexpr uint32_t part_size_in_island = 512;

/// For a body that collides with itself: where its particles were placed, and the particles that each is linked to,
/// ascending: linked[linked_begin[p] .. linked_begin[p + 1]].
struct SelfCollision {
    explicit SelfCollision(std::pmr::memory_resource* memory) : placed(memory), linked_begin(memory), linked(memory) {}

    Vector<Vec3> placed;
    Vector<uint32_t> linked_begin, linked;
};

struct Contacts {
    explicit Contacts(std::pmr::memory_resource* source) : memory(source) {}

    std::pmr::memory_resource* memory;
    Vector<ContactPoint> points{memory};    // contact_points_per_particle each; empty until it has been in a scene
    Vector<uint8_t> point_count{memory};    // by particle: number of its contact points
    Vector<ModelImpulse> impulses{memory};  // by model, of the last step
    Vector<FlightPart> parts{memory};       // of free particles, if there are several; empty between steps
    /// By particle: 0, or 1 + the index of its last contact point in the substep under way.
    Vector<uint8_t> held{memory};
    Vector<uint32_t> stuck{memory};          // by particle, if it sticks: whether friction holds it or it rests
    Vector<double> friction_factor{memory};  // by particle, of the body's friction; empty: 1
    bool has_contact = false;  // whether there was any, and the caller has not interrupted the motion since
    bool near = false;         // whether its particles may be in contact with others in this substep
    bool closed = false;       // whether joints that were placed with wrong lengths have closed in this step
    bool pushed = false;       // of joined bodies: whether others have displaced its particles in this substep
    /// Whether some particles are deeper in models than they can leave in this substep.
    bool penetrating = false;
    SelfCollision self{memory};

    /// That of a part, or of the whole body if it has no parts.
    ImpulseAccumulator accumulator(uint32_t part) {
        if (parts.empty()) return {impulses, has_contact};
        return {parts[part].impulses, parts[part].has_contact};
    }
};

}  // namespace gphys

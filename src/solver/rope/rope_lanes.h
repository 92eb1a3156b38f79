// Undisturbed ropes: no model and no other body is near during a step. They are moved through all its substeps in the
// layout of the kernels (rope_kernels.h), up to eight side by side, one in each lane of a vector register. The result
// for a rope does not depend on the others.
#pragma once

#include "solver/body.h"
#include "solver/contact/collision.h"
#include "solver/rope/rope_contacts.h"
#include "solver/rope/rope_kernels.h"

namespace gphys {

/// Work space of one worker for ropes; nothing in it outlives a task.
struct RopeScratch {
    explicit RopeScratch(std::pmr::memory_resource* memory)
        : one(memory), eight(memory), one_terms(memory), eight_terms(memory), contacts(memory) {}

    /// By particles of the longest rope that is moved alone, in lanes, and in lanes with contacts, and by the number of
    /// models that move. Throws std::bad_alloc.
    void reserve(size_t alone, size_t in_lanes, size_t in_contact_lanes, size_t moving_models);

    Vector<RopeNode<1>> one;
    Vector<RopeNode<8>> eight;
    // For ropes that may touch models:
    Vector<RopeContactTerm<1>> one_terms;
    Vector<RopeContactTerm<8>> eight_terms;
    ClosestFeatures parts;
    Vector<RopeContacts> contacts;  // by lane
};

/// What ropes in lanes have in common.
struct RopeStepSettings {
    Vec3 gravity;
    CollisionContext whole;  // of the step
    uint32_t substeps;
    bool estimated;  // whether error targets need the earlier velocities
};

/// A rope in the step under way.
struct UndisturbedRope {
    Body* body;
    const Box* region;  // no model is in it; null: there are no models
    bool stayed;        // result: whether it has stayed there; if not, the body is unchanged
};

/// A vector in one lane.
template <int lanes>
void set3(double (&to)[3][lanes], uint32_t lane, Vec3 v) {
    to[0][lane] = v.x, to[1][lane] = v.y, to[2][lane] = v.z;
}
template <int lanes>
Vec3 get3(const double (&from)[3][lanes], uint32_t lane) {
    return {from[0][lane], from[1][lane], from[2][lane]};
}

constexpr uint32_t rope_lanes = 8;
/// Particles. Longer ropes are moved alone: eight of them would not fit into the caches.
constexpr uint32_t longest_rope_in_lanes = 320;

/// Whether the kernels support the body: its links are neither limits nor damped, and it has no animation targets.
bool is_plain_rope(const Body& body);
/// Moves at most rope_lanes ropes. Several ropes must have one chain each, and either all or none restart after an
/// interruption. `scratch` must have memory for the longest.
void move_ropes(UndisturbedRope* ropes, uint32_t count, RopeScratch& scratch, const RopeStepSettings& step);

/// Call before a step of any rope: sets History::in_stages, whether its substeps have two stages.
void choose_stages(Body& body, RopeScratch& scratch, const RopeStepSettings& step);

}  // namespace gphys

// Undisturbed ropes: no model and no other body is near during a step. They are moved through all its substeps in the
// layout of the kernels (rope_kernels.h), up to eight side by side. The result for a rope does not depend on the others
// beside it.
#pragma once

#include "solver/body.h"
#include "solver/rope/rope_contacts.h"
#include "solver/rope/rope_kernels.h"

namespace gphys {

/// Memory of one worker for ropes.
struct RopeRoom {
    explicit RopeRoom(std::pmr::memory_resource* memory)
        : one(memory), eight(memory), one_pushes(memory), eight_pushes(memory), contacts(memory) {}

    /// For ropes of so many particles, moved alone, together, and together beside models. Throws std::bad_alloc.
    void reserve(size_t alone, size_t together, size_t beside);

    Vector<RopeNode<1>> one;
    Vector<RopeNode<8>> eight;
    // Of ropes that are moved beside models:
    Vector<RopePush<1>> one_pushes;
    Vector<RopePush<8>> eight_pushes;
    ClosestFeatures parts;
    Vector<RopeContacts> contacts;  // by lane
};

struct StepOfRopes {
    Vec3 gravity;
    double dt;
    uint32_t substeps;
    bool estimated;  // whether its error estimate is needed
};

/// A rope in the step under way.
struct UndisturbedRope {
    Body* body;
    const Box* confines;  // the rope must stay in it to be undisturbed; null: anywhere
    bool stayed;          // result: it did; otherwise it has not been moved
};

constexpr uint32_t ropes_together = 8;
/// Longer ropes are moved alone: eight of them would not stay in the caches.
constexpr uint32_t longest_rope_together = 320;

/// Whether the kernels support the body: its links are neither limits nor damped, and attached to no model.
bool is_plain_rope(const Body& body);
/// Moves at most ropes_together ropes. Several ropes must have one chain each, and either all or none start again after
/// an interruption. The memory must suffice for the longest.
void move_ropes(UndisturbedRope* ropes, uint32_t count, RopeRoom& room, const StepOfRopes& step);

/// Sets Body::in_stages of any rope, before a step: whether it continues without an interruption and moves calmly.
void choose_stages(Body& body, RopeRoom& room, const StepOfRopes& step);

}  // namespace gphys

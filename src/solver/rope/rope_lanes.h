// Ropes that nothing disturbs during a step - no model is near, no other body - are moved through all its
// substeps in the kernels' own form (rope_kernels.h), up to eight side by side. What becomes of a rope
// does not depend on which others are beside it.
#pragma once

#include "solver/body.h"
#include "solver/rope/rope_contacts.h"
#include "solver/rope/rope_kernels.h"

namespace gphys {

/// Room for the ropes of one worker.
struct RopeRoom {
    explicit RopeRoom(std::pmr::memory_resource* memory) : one(memory), eight(memory), contacts(memory) {}

    Vector<RopeNode<1>> one;
    Vector<RopeNode<8>> eight;
    RopeContacts contacts;  // of one that is moved alone
};

struct StepOfRopes {
    Vec3 gravity;
    double dt;
    uint32_t substeps;
    bool estimated;  // its error will be asked for
};

/// A rope of the step under way.
struct UndisturbedRope {
    Body* body;
    const Box* confines;  // that it has to stay in, or it might meet something; null: nothing to meet
    bool stayed;          // and was found; otherwise it has not been moved
};

constexpr uint32_t ropes_together = 8;
/// Longer ones are moved alone: eight of them would not stay in a processor's caches.
constexpr uint32_t longest_rope_together = 320;

/// Whether the kernels take it: chains of links that neither only pull nor are damped, attached to no model.
bool is_plain_rope(const Body& body);
/// At most ropes_together, of one chain each if there are several, which start again all or none; the room holds the
/// longest.
void move_ropes(UndisturbedRope* ropes, uint32_t count, RopeRoom& room, const StepOfRopes& step);

/// Body::in_stages of any rope, before a step: whether it goes on without an interruption and moves calmly.
void choose_stages(Body& body, RopeRoom& room, const StepOfRopes& step);

}  // namespace gphys

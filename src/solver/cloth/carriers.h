// The models that cloth lies on, if they move: the motion in which it settles (settling.h).
//
// A particle in contact settles in the motion of its model, all others in that of the model that most contact planes
// are of. So models may move past one another slowly, as the chest of somebody who breathes in bed.
#pragma once

#include "solver/contact/moving_colliders.h"

namespace gphys {

struct Body;
struct ClothContact;
struct CollisionContext;

/// How far a rigid motion moves points, relative to the cloth's origin. Nowhere, if nothing is set.
struct RigidDisplacement {
    Mat3 turn{{}, {}, {}};  // R - 1, where R is the rotation
    Vec3 shift;

    RigidDisplacement() = default;
    explicit RigidDisplacement(const RigidMotion& motion);
    Vec3 of(Vec3 p) const { return turn * p + shift; }
};

/// Of the step under way.
struct Carriers {
    bool move = false;                         // whether any contact plane moves
    bool rigid = true;                         // whether all keep their shape and rotate little
    uint32_t first = MovingCollider::unmoved;  // the model that most of them are of, in Cloth::moving_colliders
    RigidDisplacement of_first;                // in the step
    double apart = 0;                          // metres in the step: by how much others move in another way
};

/// Call at the beginning of a step, after the search for contacts.
Carriers find_carriers(const Body& body, const CollisionContext& around);
/// Call after its search for active contact planes: the same of a model in this substep.
RigidDisplacement displacement_in_substep(const Body& body, uint32_t moving_collider);

}  // namespace gphys

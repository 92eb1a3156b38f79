// Models that move during a step, as cloth sees them.
//
// The scene has such a model where it stands at the end of the step; points fixed to it come from elsewhere. All
// places here but boxes are relative to the cloth's origin.
#pragma once

#include "foundation/memory.h"
#include "shapes/shapes.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// How points fixed to a model move from one of its placements to another of the same scale.
struct RigidMotion {
    Mat3 rotation;
    Vec3 shift;

    Vec3 apply(Vec3 p) const { return rotation * p + shift; }
    Vec3 inverse_apply(Vec3 p) const { return transpose_times(rotation, p - shift); }
};

struct MovingCollider {
    gphys_model_id model;
    gphys_transform before;
    Box way;               // all that it passes during the step, in the world
    bool bounded;          // otherwise it is everywhere
    bool is_rigid;         // it keeps its size and turns little; otherwise particles near it are swept
    double turn;           // a bound of |R x - x| / |x|, R being its rotation in the step
    double bulge;          // how far an arc of radius 1 with its angle is from the straight way, at most
    RigidMotion carry;     // during this substep
    RigidMotion from_end;  // from the end of the step back to that of this substep
    Vec3 middle;           // the model's position then

    /// How far the place would move with the model in the rest of the step, at most.
    double travel(Vec3 at) const { return distance(at, from_end.inverse_apply(at)) + bulge * distance(at, middle); }
    /// What is further than this from the place does not come within `reach` of it in the rest of the step:
    /// d <= reach + travel(at) + (turn + bulge) d for a point d away that does.
    double range(double reach, Vec3 at) const { return (reach + travel(at)) / (1 - turn - bulge); }
};

/// What there is of them at the beginning of a step, and their rides in the next substep.
void find_moving_colliders(Body& body, const CollisionContext& around);
void advance_moving_colliders(Body& body, const CollisionContext& around);

}  // namespace gphys

// Models that move during a step, for bodies whose contact planes move with them: ropes and cloth.
//
// In the scene such a model is at its place at the end of the step; during the step it moves to that place. All
// positions here except boxes are relative to an origin near the body.
#pragma once

#include <cmath>

#include "foundation/memory.h"
#include "shapes/shapes.h"

namespace gphys {

struct CollisionContext;

/// The motion of a model between two transforms of the same scale.
struct RigidMotion {
    Mat3 rotation;
    Vec3 shift;

    Vec3 apply(Vec3 p) const { return rotation * p + shift; }
    Vec3 inverse_apply(Vec3 p) const { return transpose_times(rotation, p - shift); }
};

struct MovingCollider {
    static constexpr uint32_t unmoved = 0xffffffff;  // in place of an index: a model that does not move

    gphys_model_id model;
    gphys_transform before;
    Box swept_bounds;            // bounds during the step, in the world
    bool bounded;                // false: it is unbounded
    bool is_rigid;               // it keeps its size and rotates little; otherwise particles near it are swept
    double turn;                 // a bound of |R x - x| / |x|, where R is its rotation in the step
    double bulge;                // bound for the distance of an arc of radius 1 with its angle from the chord
    RigidMotion substep_motion;  // during this substep
    RigidMotion from_end;        // from the end of the step back to that of this substep
    Vec3 jump;                   // m/s, by which its velocity differs from that in the step before
    Vec3 lag;                    // metres: lag_in_substep of that
    Vec3 middle;                 // the model's position at the end of the substep

    /// A bound for the distance that the point would move with the model in the rest of the step.
    double travel(Vec3 at) const { return distance(at, from_end.inverse_apply(at)) + bulge * distance(at, middle); }
    /// A point farther than this away does not come within `reach` in the rest of the step: a point at distance d that
    /// does satisfies d <= reach + travel(at) + (turn + bulge) d.
    double range(double reach, Vec3 at) const { return (reach + travel(at)) / (1 - turn - bulge); }
    /// A lower bound for the distance between the point and a part of the model, now at `distance`, until the end of
    /// the step.
    double nearest_in_step(double distance, Vec3 at) const {
        return distance - travel(at) - (turn + bulge) * std::fabs(distance);
    }
};

/// Some of a list of moving models.
struct NearColliders {
    static constexpr uint32_t most = 8;

    uint32_t count = 0;
    uint32_t indices[most];

    /// Finds those that come into the box. Returns false if there are too many, or if some rotate too fast to follow.
    bool find(const Vector<MovingCollider>& moving_colliders, const Box& box);
};

/// Finds the moving models on these layers that come into the box, at the beginning of a step; advance: their motion in
/// the next substep.
void find_moving_colliders(Vector<MovingCollider>& moving_colliders, Vec3 origin, const Box& box, uint32_t layers,
                           const CollisionContext& around);
void advance_moving_colliders(Vector<MovingCollider>& moving_colliders, Vec3 origin, const CollisionContext& around);
/// Metres: by how much more a model would move in this substep if its velocity changed by the jump evenly in the step,
/// in place of at once at its beginning. These sum up to 0 in a step.
Vec3 lag_in_substep(Vec3 jump, const CollisionContext& around);
/// That in the whole step.
RigidMotion motion_in_step(const MovingCollider& moving_collider, Vec3 origin, const CollisionContext& around);

}  // namespace gphys

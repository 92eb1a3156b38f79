// Settling: cloth that lies on models or hangs, and nearly rests, is brought to rest.
//
// Links of a sheet on round or sharp models, or between pins that are too close together, cannot all have their
// lengths, and sweeps over them move particles back and forth without end (docs/solver/rest.md). Flaps swing, too,
// since nothing damps them. So while friction holds a slow body on models that stand still, or while pins hold a body
// whose velocities are not those of its motion, it is first damped, and then its displacements fade away. From then on
// a step leaves it as it is.
#pragma once

#include "foundation/math.h"

namespace gphys {

class Scene;
struct Body;
struct CollisionContext;

/// Of the step under way.
struct Settling {
    double damping = 0;  // 1/s
    double kept = 1;     // part of the displacements

    bool acts() const { return damping > 0; }
};

/// Call at the beginning of a step, after the search for contacts.
void begin_settling(Body& body, const CollisionContext& around);
/// Call at the end of a substep of h seconds.
void settle(Body& body, double h);
/// Call at the end of a step. `alone`: whether no other body was near.
void note_settling(Body& body, const Scene* scene, Vec3 gravity, double dt, bool alone);

}  // namespace gphys

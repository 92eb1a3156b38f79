// Settling: cloth that lies on models or hangs, and nearly rests, is brought to rest.
//
// Links of a sheet on round or sharp models, or between pins that are too close together, cannot all have their
// lengths, and sweeps over them move particles back and forth without end (docs/solver/rest.md). Flaps swing, too,
// since nothing damps them. So while friction holds a slow body on models, or while pins hold a body whose velocities
// are not those of its motion, it is first damped, and then its displacements fade away. On models that stand still,
// and between pins, a step leaves it as it is from then on. On models that move, all this is relative to their motion,
// and a tenth of the displacements stays, so that it follows what changes: where down is in a boat that rolls, or how
// fast a lift is.
#pragma once

#include "solver/cloth/carriers.h"
#include "solver/cloth/cloth_shares.h"

namespace gphys {

class Scene;
struct Body;
struct CollisionContext;

/// Of the step under way.
struct Settling {
    double damping = 0;     // 1/s
    double kept = 1;        // part of the displacements
    Carriers carriers;      // the models that it lies on
    bool carried = false;   // whether they move, or have just stopped, so that it may settle in their motion;
    double most_jump = 0;   // m/s: then by how much this motion may change at once,
    ClothTravel travelled;  // and how far particles have moved in the step relative to it

    bool acts() const { return damping > 0; }
};

/// Call at the beginning of a step, after the search for contacts.
void begin_settling(Body& body, const CollisionContext& around, Vec3 gravity);
/// Call at the end of a substep of h seconds.
void settle(Body& body, double h);
/// Call at the end of a step, before the positions are published.
void note_travel(Body& body);
/// Call after that. `alone`: whether no other body was near.
void note_settling(Body& body, const Scene* scene, Vec3 gravity, double dt, bool alone);

}  // namespace gphys

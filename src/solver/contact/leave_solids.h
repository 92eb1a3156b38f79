// How bodies with constraints leave the models that they are in.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// Around what gives links their lengths back, for a body that is not cloth, if it is sunk. False,
/// and nothing is to be done, if none of its particles is in anything.
bool begin_leaving(Body& body, const CollisionContext& around);
void end_leaving(Body& body, const CollisionContext& around, bool lengths_found);
/// All of it for cloth, at the end of a substep of h seconds.
void leave_solids(Body& body, double h);

}  // namespace gphys

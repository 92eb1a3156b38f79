// How bodies with constraints leave models that they are in.
#pragma once

#include "foundation/math.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// Call before and after the links are solved, for a sunk body that is not cloth. begin_leaving returns false, and
/// nothing remains to be done, if none of its particles is in a model.
bool begin_leaving(Body& body, const CollisionContext& around);
void end_leaving(Body& body, const CollisionContext& around, bool lengths_found);
/// The whole of it for cloth, at the end of a substep of h seconds.
void leave_solids(Body& body, double h);

}  // namespace gphys

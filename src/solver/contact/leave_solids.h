// Moves bodies with constraints out of models that they are in (leave_solids.cpp).
#pragma once

namespace gphys {

struct Body;
struct CollisionContext;

/// Call before and after the links are solved, for a penetrating body that is not cloth. If none of its particles is in
/// a model, begin_leaving returns false and end_leaving is not needed.
bool begin_leaving(Body& body, const CollisionContext& around);
void end_leaving(Body& body, const CollisionContext& around, bool lengths_found);
/// For cloth, at the end of a substep of h seconds: both at once.
void leave_solids(Body& body, double h);

}  // namespace gphys

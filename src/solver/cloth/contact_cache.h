// What holds of the contacts of the step before (contact_cache.cpp).
#pragma once

#include "shapes/shapes.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// What holds of the step before. Nothing, and then nobody has looked; or from where particles have
/// looked; or what they saw as well.
enum class Reuse { nothing, balls, planes };
/// Whether the origin, which all that is relative to, is still near the middle of the box.
bool keeps_origin(const Body& body, const Aabb& box);
Reuse reuse_contacts(Body& body, const CollisionContext& around);
/// At the end of a step.
void keep_planes(Body& body, const CollisionContext& around);

}  // namespace gphys

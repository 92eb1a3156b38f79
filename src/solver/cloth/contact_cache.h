// Which contacts of the previous step can be reused (contact_cache.cpp).
#pragma once

#include "shapes/shapes.h"

namespace gphys {

struct Body;
struct CollisionContext;

/// What can be reused: nothing, so that all particles search; the positions and radii of the last search; or also its
/// contact planes.
enum class Reuse { nothing, balls, planes };
/// Whether the origin of the relative coordinates is still near the middle of the box.
bool keeps_origin(const Body& body, const Aabb& box);
Reuse reuse_contacts(Body& body, const CollisionContext& around);
/// Call at the end of a step.
void keep_planes(Body& body, const CollisionContext& around);

}  // namespace gphys

// Capsules against capsules and against what has edges.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

bool capsules_meet(const Capsule& a, const Capsule& b);
bool capsule_meets(const Capsule& capsule, const Aabb& box);
bool capsule_meets(const Capsule& capsule, const Obb& box);
bool capsule_meets(const Capsule& capsule, const Triangle& triangle);
bool capsule_meets(const Capsule& capsule, const Frustum& frustum);

}  // namespace gphys

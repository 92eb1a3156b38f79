// Overlaps of capsules with capsules, boxes, triangles and frusta.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

bool capsules_overlap(const Capsule& a, const Capsule& b);
bool capsule_overlaps(const Capsule& capsule, const Aabb& box);
bool capsule_overlaps(const Capsule& capsule, const Obb& box);
bool capsule_overlaps(const Capsule& capsule, const Triangle& triangle);
bool capsule_overlaps(const Capsule& capsule, const Frustum& frustum);

}  // namespace gphys

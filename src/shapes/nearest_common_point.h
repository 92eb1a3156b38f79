// The point of an intersection of half-spaces that is nearest to the origin, computed in double. Callers verify it
// exactly.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

struct CommonPoint {
    enum class Outcome { found, none, unsure };

    Outcome outcome = Outcome::found;
    Vec3 point;
    // Found: the planes that the point lies on. None: planes without a common point.
    int plane_count = 0;
    int planes[4];
};

/// Of the half-spaces dot(normal, x) >= distance; no normal is 0, and at most 12 of them.
CommonPoint nearest_common_point(const Plane* halfspaces, int count);

/// The point of a plane, or of the line of two, that is nearest to the origin. False for parallel ones.
Vec3 foot_on(const Plane& plane);
bool foot_on(const Plane& a, const Plane& b, Vec3& foot);

}  // namespace gphys

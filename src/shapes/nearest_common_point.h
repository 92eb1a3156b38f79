// The point of an intersection of half-spaces that is nearest to the origin, computed in double. Callers verify it
// exactly.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

struct CommonPoint {
    enum class Outcome { found, none, unsure };

    Outcome outcome = Outcome::found;
    Vec3 point;
    // found: the planes that the point lies on; none: planes without a common point
    int plane_count = 0;
    int planes[4];
};

/// Of the half-spaces dot(normal, x) >= distance; no normal is 0, and at most 12 of them.
CommonPoint nearest_common_point(const Plane* halfspaces, int count);

/// The point of a plane, or of the line of two planes, that is nearest to the origin. The latter returns false for
/// parallel planes.
Vec3 foot_on(const Plane& plane);
bool foot_on(const Plane& a, const Plane& b, Vec3& foot);

}  // namespace gphys

// Triangles with a corner that is certainly inside a solid: they overlap it, without an exact test. Most triangles that
// overlap a large solid have one.
//
// Errors: 2^-43 of the coordinates covers a thousand roundings, as in scene/conservative_shape.h.
#pragma once

#include "geometry/intersect.h"

namespace gphys {

inline double corner_error(Vec3 corner, Vec3 center) { return 0x1p-43 * (sum(abs(corner)) + sum(abs(center))); }

/// Exact.
inline bool is_certainly_inside(const Aabb& box, Vec3 corner) {
    return corner.x >= box.min.x && corner.x <= box.max.x && corner.y >= box.min.y && corner.y <= box.max.y &&
           corner.z >= box.min.z && corner.z <= box.max.z;
}
inline bool is_certainly_inside(const Sphere& sphere, Vec3 corner) {
    const double inner = sphere.radius - corner_error(corner, sphere.center) - 0x1p-43 * sphere.radius;
    return inner > 0 && length_squared(corner - sphere.center) < inner * inner;
}
inline bool is_certainly_inside(const Obb& box, Vec3 corner) {
    const Vec3 local = abs(transpose_times(box.axes, corner - box.center));
    const double error = corner_error(corner, box.center);
    return local.x + error < box.half.x && local.y + error < box.half.y && local.z + error < box.half.z;
}
inline bool is_certainly_inside(const Capsule& capsule, Vec3 corner) {
    return is_certainly_inside(Sphere{capsule.a, capsule.radius}, corner) ||
           is_certainly_inside(Sphere{capsule.b, capsule.radius}, corner);
}
/// A normal of 0 is that of an infinite far plane.
inline bool is_certainly_inside(const Frustum& frustum, Vec3 corner) {
    const Vec3 from = corner - frustum.origin;
    const double error = corner_error(corner, frustum.origin);
    for (const Plane& plane : frustum.planes) {
        const double height = dot(plane.normal, from) - plane.distance;
        const bool inside = height > sum(abs(plane.normal)) * error + 0x1p-43 * std::fabs(plane.distance);
        if (!inside && plane.normal != Vec3{}) return false;
    }
    return true;
}
template <class Other>
bool is_certainly_inside(const Other&, Vec3) {
    return false;
}

template <class Solid>
bool has_corner_inside(const Solid& solid, const Triangle& triangle) {
    return is_certainly_inside(solid, triangle.a) || is_certainly_inside(solid, triangle.b) ||
           is_certainly_inside(solid, triangle.c);
}
template <class Solid, class Item>
bool has_corner_inside(const Solid&, const Item&) {
    return false;
}

}  // namespace gphys

// The interval of signed heights of a shape above a plane, for classify and for overlaps with planes and frusta.
#pragma once

#include "foundation/exact.h"
#include "shapes/shapes.h"

namespace gphys {

/// The lowest and highest dot(normal, x - origin) - distance of the points x of a shape. Signs are exact, relative
/// errors below 2^-43.
struct Heights {
    double low, high;
};

/// A plane whose distance is relative to an origin, as those of a frustum.
struct PlaneAt {
    Vec3 normal, origin;
    double distance;
};
inline PlaneAt plane_at(const Plane& plane) { return {plane.normal, {}, plane.distance}; }
inline PlaneAt plane_at(const Frustum& frustum, int i) {
    return {frustum.planes[i].normal, frustum.origin, frustum.planes[i].distance};
}

template <class N>
N height_above(const PlaneAt& plane, Vec3 point) {
    return height_of<N>(plane.normal, point, plane.origin) - N(plane.distance);
}

Heights heights(const Sphere& sphere, const PlaneAt& plane);
Heights heights(const Capsule& capsule, const PlaneAt& plane);
Heights heights(const Aabb& box, const PlaneAt& plane);
Heights heights(const Obb& box, const PlaneAt& plane);
Heights heights(const Triangle& triangle, const PlaneAt& plane);

}  // namespace gphys

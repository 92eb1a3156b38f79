// Pairs of a sphere, capsule or box and any other shape, for sweep and penetration: which types they have, and a convex
// shape above a plane. Other pairs are a Minkowski difference (convex.h).
#pragma once

#include "geometry/convex.h"

namespace gphys {

/// On which side of a plane the centre of a solid is, and the distance of the solid from the plane.
struct OverPlane {
    template <class Moving>
    OverPlane(const Plane& plane, const Moving& moving, Vec3 from)
        : OverPlane(relative_to(from, plane), core_of(relative_to(from, moving))) {}
    /// A centre on the plane counts as in front.
    OverPlane(const Plane& plane, const Core& solid) {
        const double size = length(plane.normal);
        const double height = (dot(plane.normal, solid.center) - plane.distance) / size;
        behind = height < 0;
        normal = normalized(plane.normal) * (behind ? -1 : 1);
        gap = std::fabs(height) - solid.radius;
        foot = solid.center - normal * std::fabs(height);
        for (int k = 0; k < solid.axis_count; ++k) {
            const double slope = dot(normal, solid.axes[k]);
            gap -= solid.half[k] * std::fabs(slope);
            // The centre of a face or edge that is parallel to the plane.
            const double way = slope > 0 ? -solid.half[k] : slope < 0 ? solid.half[k] : 0;
            foot += (solid.axes[k] - normal * slope) * way;
        }
    }

    double gap;   // below 0 if they overlap
    Vec3 normal;  // from the plane to the solid
    Vec3 foot;    // the point of the plane nearest to the solid
    bool behind;  // the plane's normal points the other way
};

/// Calls visit with the alternative of `moving`: sphere, capsule, Aabb or Obb.
template <class Visit>
auto with_solid(const Shape& moving, Visit&& visit) {
    if (const auto* sphere = std::get_if<Sphere>(&moving)) return visit(*sphere);
    if (const auto* capsule = std::get_if<Capsule>(&moving)) return visit(*capsule);
    if (const auto* box = std::get_if<Aabb>(&moving)) return visit(*box);
    return visit(std::get<Obb>(moving));
}
/// The same with the alternatives of both shapes.
template <class Visit>
auto with_pair(const Shape& other, const Shape& moving, Visit&& visit) {
    return with_solid(moving, [&](const auto& solid) {
        return std::visit([&](const auto& each) { return visit(each, solid); }, other);
    });
}

}  // namespace gphys

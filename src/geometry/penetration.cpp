// penetration: the minimum translation that separates a solid from a shape. Both are convex, or the shape is a plane
// with two sides, so the minimum is along a face normal of the Minkowski difference (Cameron, Culley 1986). Those
// normals are few (convex_separation.cpp), so all are tested, and no expanding polytope (EPA) is needed.
#include <algorithm>

#include "geometry/convex_pairs.h"
#include "geometry/intersect.h"

namespace gphys {
namespace {

template <class Other, class Moving>
Penetration pair(const Other& other, const Moving& moving) {
    const Vec3 from = reference_point(moving);
    const auto core = core_of(relative_to(from, other));
    const ConvexDifference set(core, core_of(relative_to(from, moving)));
    const Separation apart = separation(set);
    const Vec3 point = contact_on_other(set, apart) + apart.normal * set.other_radius();
    return {std::max(0.0, set.radius() - apart.distance), apart.normal, from + point};
}

template <class Moving>
Penetration pair(const Plane& plane, const Moving& moving) {
    const Vec3 from = reference_point(moving);
    const OverPlane over(plane, moving, from);
    return {std::max(0.0, -over.gap), over.normal, from + over.foot};
}

}  // namespace

Penetration penetration(const Shape& shape, const Shape& moving) {
    return with_pair(shape, moving, [](const auto& other, const auto& solid) { return pair(other, solid); });
}
Penetration penetration(const Triangle& triangle, const Shape& moving) {
    return with_solid(moving, [&](const auto& solid) { return pair(triangle, solid); });
}

}  // namespace gphys

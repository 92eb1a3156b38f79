// overlaps for every pair of shapes, in the order of the alternatives of Shape. Signs that decide are exact (exact.h).
// Triangles with triangles and boxes are in overlap_triangle.cpp, capsules with shapes that have edges in
// overlap_capsule.cpp.
#include "foundation/exact.h"
#include "geometry/heights.h"
#include "geometry/intersect.h"
#include "geometry/overlap_boxes.h"
#include "geometry/overlap_capsule.h"
#include "shapes/halfspaces.h"

namespace gphys {
namespace {

// Sphere: the closest point is within the radius.

template <class Other>
bool pair_overlaps(const Sphere& sphere, const Other& other) {
    return contains(other, sphere.center, sphere.radius);
}

// Plane: it overlaps if the shape has points on both sides.

template <class Other>
bool overlaps_plane(const Other& other, const Plane& plane) {
    const Heights range = heights(other, plane_at(plane));
    return range.low <= 0 && range.high >= 0;
}

bool pair_overlaps(const Plane& a, const Plane& b) {
    const auto sign_of_minor = [](double a0, double a1, double b0, double b1) {
        return sign_of([=](auto number) {
            using N = decltype(number);
            return N(a0) * N(b1) - N(a1) * N(b0);
        });
    };
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        if (sign_of_minor(a.normal[i], a.normal[k], b.normal[i], b.normal[k]) != 0) return true;
    }
    // Parallel: the same plane if the distances are in the ratio of the normals.
    const int k = a.normal.x != 0 ? 0 : a.normal.y != 0 ? 1 : 2;
    return sign_of_minor(a.normal[k], a.distance, b.normal[k], b.distance) == 0;
}

// Boxes.

bool pair_overlaps(const Aabb& a, const Aabb& b) { return boxes_overlap(a.min, a.max, b.min, b.max); }

/// A face of a box perpendicular to a world axis: the low one for way = -1, the high one for 1.
template <class N>
N face(const Aabb& box, int k, double way) {
    return N(way < 0 ? box.min[k] : box.max[k]);
}
template <class N>
N face(const Obb& box, int k, double way) {
    const Vec3 size = abs(Vec3{box.axes.x[k], box.axes.y[k], box.axes.z[k]});
    return N(box.center[k]) + N(way) * dot(Vec<N>::of(size), Vec<N>::of(box.half));
}

/// Boxes whose axes are all parallel to world axes: exact, as for two Aabbs.
template <class BoxA, class BoxB>
bool parallel_boxes_overlap(const BoxA& a, const BoxB& b) {
    for (int k = 0; k < 3; ++k) {
        const auto gap = [k](const auto& low, const auto& high) {
            return sign_of([&](auto number) {
                using N = decltype(number);
                return face<N>(high, k, -1) - face<N>(low, k, 1);
            });
        };
        if (gap(a, b) > 0 || gap(b, a) > 0) return false;
    }
    return true;
}

/// The separating axis test of two boxes (Gottschalk, Lin, Manocha 1996): six face normals and nine cross products of
/// edges. Both boxes are projected on the axis as computed. The nearly zero cross product of nearly parallel edges is a
/// poor axis but a valid one, so no epsilon is needed.
bool obbs_overlap(const Obb& a, const Obb& b) {
    const Vec3 offset = b.center - a.center;
    const auto reach = [](const Obb& box, Vec3 axis) {
        const Vec3 along = abs(transpose_times(box.axes, axis));
        return dot(along, box.half);
    };
    const auto separates = [&](Vec3 axis) { return std::fabs(dot(offset, axis)) > reach(a, axis) + reach(b, axis); };
    const Vec3 axes_a[3] = {a.axes.x, a.axes.y, a.axes.z}, axes_b[3] = {b.axes.x, b.axes.y, b.axes.z};
    for (int i = 0; i < 3; ++i) {
        if (separates(axes_a[i]) || separates(axes_b[i])) return false;
    }
    for (const Vec3& u : axes_a) {
        for (const Vec3& v : axes_b) {
            if (separates(cross(u, v))) return false;
        }
    }
    return true;
}

bool pair_overlaps(const Aabb& a, const Obb& b) {
    return axis_parallel(b.axes) ? parallel_boxes_overlap(a, b) : obbs_overlap(as_obb(a), b);
}
bool pair_overlaps(const Obb& a, const Obb& b) {
    return axis_parallel(a.axes) && axis_parallel(b.axes) ? parallel_boxes_overlap(a, b) : obbs_overlap(a, b);
}
bool pair_overlaps(const Aabb& box, const Plane& plane) { return overlaps_plane(box, plane); }
bool pair_overlaps(const Obb& box, const Plane& plane) { return overlaps_plane(box, plane); }
bool pair_overlaps(const Aabb& box, const Triangle& triangle) { return overlaps(box, triangle); }
bool pair_overlaps(const Obb& box, const Triangle& triangle) {
    const auto local = [&](Vec3 p) { return transpose_times(box.axes, p - box.center); };
    return overlaps(Aabb{-box.half, box.half}, Triangle{local(triangle.a), local(triangle.b), local(triangle.c)});
}

// Capsule.

bool pair_overlaps(const Capsule& a, const Capsule& b) { return capsules_overlap(a, b); }
bool pair_overlaps(const Capsule& capsule, const Aabb& box) { return capsule_overlaps(capsule, box); }
bool pair_overlaps(const Capsule& capsule, const Obb& box) { return capsule_overlaps(capsule, box); }
bool pair_overlaps(const Capsule& capsule, const Plane& plane) { return overlaps_plane(capsule, plane); }
bool pair_overlaps(const Capsule& capsule, const Triangle& triangle) { return capsule_overlaps(capsule, triangle); }
bool pair_overlaps(const Capsule& capsule, const Frustum& frustum) { return capsule_overlaps(capsule, frustum); }

// Triangle.

bool pair_overlaps(const Plane& plane, const Triangle& triangle) { return overlaps_plane(triangle, plane); }
bool pair_overlaps(const Triangle& a, const Triangle& b) { return overlaps(a, b); }

// Frustum: half-spaces (halfspaces.h), after inexpensive tests that nearly always decide.

enum class TriState { disjoint, overlapping, undecided };

/// Decides if the shape is outside one plane, or if one of its points is inside all.
template <class Other>
TriState test_planes(const Other& other, Vec3 point_of_other, const Frustum& frustum) {
    for (int i = 0; i < 6; ++i) {
        if (heights(other, plane_at(frustum, i)).high < 0) return TriState::disjoint;
    }
    return contains(frustum, point_of_other, 0) ? TriState::overlapping : TriState::undecided;
}

template <class BoxType>
bool box_overlaps_frustum(const BoxType& box, Vec3 center, const Frustum& frustum) {
    const TriState verdict = test_planes(box, center, frustum);
    if (verdict != TriState::undecided) return verdict == TriState::overlapping;
    Halfspaces set;
    set.add(frustum);
    set.add(box);
    return set.have_common_point();
}

// Rounding may put the centre of a box that is flatter than 1 ulp outside it, but not a corner.
bool pair_overlaps(const Aabb& box, const Frustum& frustum) { return box_overlaps_frustum(box, box.min, frustum); }
bool pair_overlaps(const Obb& box, const Frustum& frustum) { return box_overlaps_frustum(box, box.center, frustum); }

bool pair_overlaps(const Plane& plane, const Frustum& frustum) {
    // A convex set overlaps a plane if it has points on both sides.
    Halfspaces front, back;
    front.add(frustum);
    front.add(plane);
    back.add(frustum);
    back.add(Plane{-plane.normal, -plane.distance});
    return front.have_common_point() && back.have_common_point();
}

bool pair_overlaps(const Triangle& triangle, const Frustum& frustum) {
    const TriState verdict = test_planes(triangle, triangle.a, frustum);
    if (verdict != TriState::undecided) return verdict == TriState::overlapping;
    Halfspaces set;
    set.add(frustum);
    return set.intersect(triangle);
}

bool pair_overlaps(const Frustum& a, const Frustum& b) {
    Halfspaces set;
    set.add(a);
    set.add(b);
    return set.have_common_point();
}

/// The index among the alternatives of Shape.
template <class T, size_t Index = 0>
constexpr size_t place() {
    if constexpr (std::is_same_v<T, std::variant_alternative_t<Index, Shape>>) {
        return Index;
    } else {
        return place<T, Index + 1>();
    }
}

}  // namespace

bool overlaps(const Sphere& sphere, const Triangle& triangle) { return pair_overlaps(sphere, triangle); }

bool overlaps(const Shape& a, const Shape& b) {
    return std::visit(
        [](const auto& first, const auto& second) {
            if constexpr (place<std::decay_t<decltype(first)>>() <= place<std::decay_t<decltype(second)>>()) {
                return pair_overlaps(first, second);
            } else {
                return pair_overlaps(second, first);
            }
        },
        a, b);
}

}  // namespace gphys

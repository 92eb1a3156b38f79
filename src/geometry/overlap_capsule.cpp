// A capsule overlaps a shape if its segment intersects the shape or is within the radius. If the segment is outside,
// the closest pair is an end of the segment and the shape, or the segment and an edge (Ericson 2005, chapter 5).
#include "geometry/overlap_capsule.h"

#include "geometry/heights.h"
#include "geometry/intersect.h"
#include "geometry/path_apart.h"
#include "shapes/halfspaces.h"

namespace gphys {
namespace {

/// Relative to one end, so that no digits are lost far from the origin.
bool segments_within(const Segment& a, const Segment& b, double distance) {
    Vec3 on_a, on_b;
    closest_points(Segment{{}, a.b - a.a}, Segment{b.a - a.a, b.b - a.a}, on_a, on_b);
    return length_squared(on_a - on_b) <= distance * distance;
}

template <class Solid>
bool an_end_overlaps(const Capsule& capsule, const Solid& solid) {
    return contains(solid, capsule.a, capsule.radius) || contains(solid, capsule.b, capsule.radius);
}

bool are_certainly_apart(const Capsule& capsule, const Triangle& triangle) {
    const Triangle around{triangle.a - capsule.a, triangle.b - capsule.a, triangle.c - capsule.a};
    const double size = max_component(max(abs(around.a), max(abs(around.b), abs(around.c))));
    const Vec3 way = capsule.b - capsule.a;
    const PathAndTriangle pair(way, capsule.radius, around, size, apart_margin);
    return pair.are_apart_by_face() || pair.are_apart_beside({}) || pair.are_apart_beside(way) ||
           pair.are_apart_along_path();
}

Segment core(const Capsule& capsule) { return {capsule.a, capsule.b}; }
/// The segment as a degenerate triangle, for the exact predicates.
Triangle flat(const Capsule& capsule) { return {capsule.a, capsule.b, capsule.b}; }

}  // namespace

bool capsules_overlap(const Capsule& a, const Capsule& b) {
    return segments_within(core(a), core(b), a.radius + b.radius);
}

bool capsule_overlaps(const Capsule& capsule, const Aabb& box) {
    const Vec3 low = min(capsule.a, capsule.b), high = max(capsule.a, capsule.b);
    for (int k = 0; k < 3; ++k) {
        if (low[k] - box.max[k] > capsule.radius || box.min[k] - high[k] > capsule.radius) return false;
    }
    if (an_end_overlaps(capsule, box) || overlaps(box, flat(capsule))) return true;
    for (int axis = 0; axis < 3; ++axis) {
        const int i = (axis + 1) % 3, k = (axis + 2) % 3;
        for (int corner = 0; corner < 4; ++corner) {
            Segment edge{box.min, box.max};
            edge.a[i] = edge.b[i] = corner & 1 ? box.max[i] : box.min[i];
            edge.a[k] = edge.b[k] = corner & 2 ? box.max[k] : box.min[k];
            if (segments_within(core(capsule), edge, capsule.radius)) return true;
        }
    }
    return false;
}

bool capsule_overlaps(const Capsule& capsule, const Obb& box) {
    const auto local = [&](Vec3 p) { return transpose_times(box.axes, p - box.center); };
    return capsule_overlaps(Capsule{local(capsule.a), local(capsule.b), capsule.radius}, Aabb{-box.half, box.half});
}

bool capsule_overlaps(const Capsule& capsule, const Triangle& triangle) {
    if (are_certainly_apart(capsule, triangle)) return false;
    if (an_end_overlaps(capsule, triangle) || overlaps(flat(capsule), triangle)) return true;
    const auto& [a, b, c] = triangle;
    for (const Segment& edge : {Segment{a, b}, Segment{b, c}, Segment{c, a}}) {
        if (segments_within(core(capsule), edge, capsule.radius)) return true;
    }
    return false;
}

namespace {

/// The part of the line of two planes that is an edge of the frustum and can be closest to the segment. Returns false
/// if there is none. The ends are common points of three planes, which are accurate at any angle: the ratio of height
/// and slope of a plane that the line meets at a small angle is not.
bool edge_beside(const Frustum& frustum, int i, int j, const Segment& segment, Segment& edge) {
    const Plane &a = frustum.planes[i], &b = frustum.planes[j];
    const Vec3 line = accurate_cross({}, a.normal, {}, b.normal);
    Vec3 base;
    if (line == Vec3{} || !common_point(a, b, {line, 0}, base)) return false;
    const Vec3 direction = normalized(line);
    const double start = dot(segment.a - frustum.origin, direction), end = dot(segment.b - frustum.origin, direction);
    double low = -infinity, high = infinity;
    for (int k = 0; k < 6; ++k) {
        if (k == i || k == j) continue;
        const Plane& plane = frustum.planes[k];
        const int slope =
            sign_of([&](auto number) { return determinant_of<decltype(number)>(a.normal, b.normal, plane.normal); });
        if (slope == 0) {
            // Rounding must not let a plane that contains the line exclude it. An edge too many does no harm.
            const double slack = 0x1p-40 * length(plane.normal) * length(base);
            if (dot(plane.normal, base) - plane.distance < -slack) return false;
            continue;
        }
        Vec3 corner;
        common_point(a, b, plane, corner);
        // Coordinates of a corner have an error of 2^-42 of themselves.
        const double t = dot(corner, direction), error = 0x1p-41 * length(corner);
        if (slope > 0) {
            low = std::max(low, t - error);
        } else {
            high = std::min(high, t + error);
        }
    }
    if (low > high) return false;
    const auto place = [&](double t) { return frustum.origin + base + direction * std::clamp(t, low, high); };
    edge = {place(start), place(end)};
    return true;
}

}  // namespace

bool capsule_overlaps(const Capsule& capsule, const Frustum& frustum) {
    for (int i = 0; i < 6; ++i) {
        if (heights(capsule, plane_at(frustum, i)).high < 0) return false;
    }
    if (an_end_overlaps(capsule, frustum)) return true;
    Halfspaces set;
    set.add(frustum);
    if (set.intersect(flat(capsule))) return true;
    // Relative to one end; normals scaled to a length of about one.
    Frustum local{frustum.origin - capsule.a, {}};
    for (int i = 0; i < 6; ++i) local.planes[i] = scaled_to_one(frustum.planes[i]);
    const Segment segment{{}, capsule.b - capsule.a};
    const double square = capsule.radius * capsule.radius;
    for (int i = 0; i < 6; ++i) {
        for (int j = i + 1; j < 6; ++j) {
            Segment edge;
            if (!edge_beside(local, i, j, segment, edge)) continue;
            Vec3 on_segment, on_edge;
            closest_points(segment, edge, on_segment, on_edge);
            // The edge may be none of an empty frustum, or one of those too many.
            if (length_squared(on_segment - on_edge) > square) continue;
            if (contains(local, on_segment, capsule.radius)) return true;
        }
    }
    return false;
}

}  // namespace gphys

// sweep of a sphere: a raycast of its centre against the shape offset by the radius (the Minkowski sum with a ball).
//
// An offset sphere or capsule is one again; an offset plane is two planes; an offset triangle is a prism and a capsule
// around each edge. For a box, the path is split where the nearest feature changes. A frustum, which may be infinite,
// is approached by Newton's method. So a sweep has the accuracy of a raycast.
#include "foundation/exact.h"
#include "geometry/capsule_axis.h"
#include "geometry/convex.h"
#include "geometry/intersect.h"
#include "geometry/path_apart.h"

namespace gphys {
namespace {

Ray path(const Sphere& moving, Vec3 displacement) { return {moving.center, displacement, 1}; }

bool contact(double t, Vec3 point, Vec3 normal, uint32_t flags, Hit& hit) {
    hit = Hit{t, point, normal};
    hit.flags = flags;
    return true;
}

/// Contact at t = 0. The normal points from the nearest point of the shape to the centre. If the centre is inside a
/// solid, it opposes the motion.
bool contact_at_start(const Sphere& moving, Vec3 displacement, Vec3 nearest, Hit& hit) {
    const Vec3 out = moving.center != nearest ? moving.center - nearest : -displacement;
    return contact(0, nearest, out == Vec3{} ? Vec3{} : normalized(out), GPHYS_HIT_INSIDE, hit);
}

template <class Shape>
bool overlaps_at_start(const Shape& shape, const Sphere& moving, Vec3 displacement, Hit& hit) {
    return contains(shape, moving.center, moving.radius) &&
           contact_at_start(moving, displacement, closest_point(shape, moving.center), hit);
}

/// The normal of a contact at the start, for a capsule so long that its nearest point is not accurate enough.
void correct_normal(const Capsule& capsule, const Sphere& moving, Hit& hit) {
    const double size = max_component(abs(capsule.a) + abs(moving.center - capsule.a) + abs(capsule.b - capsule.a));
    if (!is_coarse(size, capsule.radius + moving.radius) || contains(capsule, moving.center, 0)) return;
    const auto is_beside = [&](Vec3 end, Vec3 other) {
        return sign_of([&](auto number) {
                   using V = Vec<decltype(number)>;
                   return dot(V::difference(other, end), V::difference(moving.center, end));
               }) > 0;
    };
    if (!is_beside(capsule.a, capsule.b) || !is_beside(capsule.b, capsule.a)) return;
    const Vec3 out = away_from_line(capsule, moving.center);
    if (out != Vec3{}) hit.normal = normalized(out);
}

/// Convert a hit on the offset shape to a contact of the sphere and the shape.
template <class Shape>
bool contact_on(const Shape& shape, const Sphere& moving, Vec3 displacement, Hit& hit) {
    // The sphere starts just outside: the two tests round differently.
    if (hit.t == 0) return contact_at_start(moving, displacement, closest_point(shape, moving.center), hit);
    const Vec3 center = moving.center + displacement * hit.t;
    return contact(hit.t, closest_point(shape, center), hit.normal, 0, hit);
}

}  // namespace

bool sweep(const Sphere& sphere, const Sphere& moving, Vec3 displacement, Hit& hit) {
    if (moving.radius == 0) return raycast(sphere, path(moving, displacement), hit);
    if (overlaps_at_start(sphere, moving, displacement, hit)) return true;
    return raycast(Sphere{sphere.center, sphere.radius + moving.radius}, path(moving, displacement), hit) &&
           contact_on(sphere, moving, displacement, hit);
}

bool sweep(const Capsule& capsule, const Sphere& moving, Vec3 displacement, Hit& hit) {
    if (moving.radius == 0) return raycast(capsule, path(moving, displacement), hit);
    const Capsule grown{capsule.a, capsule.b, capsule.radius + moving.radius};
    const bool is_hit =
        overlaps_at_start(capsule, moving, displacement, hit) ||
        (raycast(grown, path(moving, displacement), hit) && contact_on(capsule, moving, displacement, hit));
    if (is_hit && hit.t == 0) correct_normal(capsule, moving, hit);
    return is_hit;
}

/// The squared distance of the centre from the box is the sum of squares over the axes on which it is outside. Between
/// two crossings of face planes that set of axes is constant, and in these axes alone the box is a point.
bool sweep(const Aabb& box, const Sphere& moving, Vec3 displacement, Hit& hit) {
    if (moving.radius == 0) return raycast(box, path(moving, displacement), hit);
    if (overlaps_at_start(box, moving, displacement, hit)) return true;
    double face_times[6];
    int face_count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double face : {box.min[axis], box.max[axis]}) {
            const double offset = face - moving.center[axis], way = displacement[axis];
            if (offset * way > 0 && std::fabs(offset) < std::fabs(way)) face_times[face_count++] = offset / way;
        }
    }
    double end = 0;
    Vec3 inwards;  // the motion along the axes of the last interval
    for (double start = 0; start < 1; start = end) {
        end = 1;
        for (int i = 0; i < face_count; ++i) {
            if (face_times[i] > start) end = std::min(end, face_times[i]);
        }
        const double middle = start + (end - start) / 2;
        Ray outside{{}, {}, end - start};  // the path, relative to the box, in the axes that matter
        for (int axis = 0; axis < 3; ++axis) {
            const double at = moving.center[axis] + displacement[axis] * middle;
            if (at >= box.min[axis] && at <= box.max[axis]) continue;
            const double face = at < box.min[axis] ? box.min[axis] : box.max[axis];
            outside.origin[axis] = (moving.center[axis] - face) + displacement[axis] * start;
            outside.direction[axis] = displacement[axis];
        }
        if (outside.direction != Vec3{}) inwards = outside.direction;
        if (!raycast(Sphere{{}, moving.radius}, outside, hit)) continue;
        // Contact at the start of an interval: rounding missed it at the end of the previous one.
        if (hit.flags & GPHYS_HIT_INSIDE) {
            hit.normal = outside.origin != Vec3{} ? normalized(outside.origin) : -normalized(inwards);
        }
        hit.t = std::min(start + hit.t, 1.0);
        return contact_on(box, moving, displacement, hit);
    }
    return false;
}

bool sweep(const Obb& box, const Sphere& moving, Vec3 displacement, Hit& hit) {
    const Sphere local{transpose_times(box.axes, moving.center - box.center), moving.radius};
    if (!sweep(Aabb{-box.half, box.half}, local, transpose_times(box.axes, displacement), hit)) return false;
    hit.point = box.center + box.axes * hit.point;
    hit.normal = box.axes * hit.normal;
    return true;
}

bool sweep(const Plane& plane, const Sphere& moving, Vec3 displacement, Hit& hit) {
    if (moving.radius == 0) return raycast(plane, path(moving, displacement), hit);
    const Vec3 front = normalized(plane.normal);
    const double height = value_of([&](auto number) {
        using V = Vec<decltype(number)>;
        return dot(V::of(plane.normal), V::of(moving.center)) - decltype(number)(plane.distance);
    });
    const double climb = dot(front, displacement);
    const bool behind = height < 0 || (height == 0 && climb > 0);
    const Vec3 normal = behind ? -front : front;
    const double gap = std::fabs(height) / length(plane.normal) - moving.radius;
    const double approach = -dot(normal, displacement);
    if (gap > 0 && (approach <= 0 || gap > approach)) return false;
    const double t = gap > 0 ? gap / approach : 0;
    const Vec3 center = moving.center + displacement * t;
    const uint32_t flags = (behind ? GPHYS_HIT_BACK : 0) | (gap > 0 ? 0 : GPHYS_HIT_INSIDE);
    return contact(t, closest_point(plane, center), normal, flags, hit);
}

namespace {

/// A tiny ball hits all edges of a corner at the same time, within rounding. If part of the triangle is beyond the
/// plane of the contact, another normal replaces it. Coordinates are relative to the centre at the start.
void correct_normal(const Triangle& triangle, const Sphere& moving, Vec3 displacement, double size, Hit& hit) {
    const Vec3 center = displacement * hit.t;
    const double high =
        std::max({dot(hit.normal, triangle.a), dot(hit.normal, triangle.b), dot(hit.normal, triangle.c)});
    const double gap = dot(hit.normal, center) - high;
    if (hit.t == 0 || gap >= moving.radius - normal_rounding * (size + max_component(abs(displacement)))) return;
    const ConvexDifference at_contact(relative_to(center, triangle), core_of(Sphere{{}, moving.radius}));
    hit.normal = contact_normal(at_contact, displacement, hit.normal);
}

/// A conservative test: whether a sphere certainly passes a triangle, or has no contact until t_max.
bool passes(const Triangle& around, double radius, Vec3 displacement, double size, double t_max) {
    const bool is_whole = t_max >= 1;
    // Contacts within rounding (is_in_contact, in sweep) are closer than 2^-47.
    const double margin = is_whole ? 0x1p-47 : apart_margin;
    const Vec3 way = is_whole ? displacement : displacement * t_max;
    const PathAndTriangle pair(way, radius, around, size, margin);
    return pair.are_apart_by_face() || pair.are_apart_beside(is_whole ? Vec3{} : way) || pair.are_apart_along_path();
}

}  // namespace

/// A contact with the face is the first: no point of the capsules around the edges is further from the plane.
bool sweep(const Triangle& triangle, const Sphere& moving, Vec3 displacement, Hit& hit, double t_max) {
    const Ray center_path = path(moving, displacement);
    if (moving.radius == 0) return raycast(triangle, center_path, hit);
    // Relative to the centre: far from the origin the rounding of the foot would exceed the tolerance.
    const Triangle around = relative_to(moving.center, triangle);
    const double size = max_component(max(abs(around.a), max(abs(around.b), abs(around.c))));
    if (passes(around, moving.radius, displacement, size, t_max)) return false;
    const auto& [a, b, c] = triangle;
    const Vec3 cross_product = accurate_cross(a, b, a, c);
    const Vec3 front = cross_product == Vec3{} ? Vec3{} : normalized(cross_product);
    const double height = dot(front, moving.center - a);
    const bool behind = height < 0 || (height == 0 && dot(front, displacement) > 0);
    const Vec3 up = behind ? -front : front;

    // Just outside of the face, where a raycast of the offset face would miss by rounding.
    const double resolution = 0x1p-50 * size;
    const auto is_in_contact = [&] {
        if (std::fabs(std::fabs(height) - moving.radius) > resolution || dot(up, displacement) >= 0) return false;
        return distance(closest_point(triangle, moving.center), moving.center) <= moving.radius + resolution;
    };
    if (contains(triangle, moving.center, moving.radius) || is_in_contact()) {
        const Vec3 nearest = closest_point(triangle, moving.center);
        const bool on_face = nearest == moving.center && front != Vec3{};
        contact_at_start(moving, on_face ? -up : displacement, nearest, hit);
    } else {
        Hit first;
        if (std::fabs(height) > moving.radius && raycast(around, {up * -moving.radius, displacement, 1}, first)) {
            // At a distance of rounding errors the side is not certain.
            first.normal = dot(up, displacement) <= 0 ? up : -up;
        } else {
            for (const Capsule& edge :
                 {Capsule{a, b, moving.radius}, Capsule{b, c, moving.radius}, Capsule{c, a, moving.radius}}) {
                Hit on_edge;
                if (raycast(edge, center_path, on_edge) && on_edge.t < first.t) first = on_edge;
            }
            if (first.t < infinity) correct_normal(around, moving, displacement, size, first);
        }
        if (first.t == infinity) return false;
        contact_on(triangle, moving, displacement, first);
        hit = first;
    }
    barycentric(triangle, hit.point, hit.u, hit.v);
    if (dot(hit.normal, front) < 0) hit.flags |= GPHYS_HIT_BACK;
    return true;
}

namespace {

bool passes_outside(const Frustum& frustum, const Sphere& moving, Vec3 displacement) {
    const Vec3 from = moving.center - frustum.origin, reach = abs(from) + abs(displacement);
    for (const Plane& plane : frustum.planes) {
        const double start = dot(plane.normal, from) - plane.distance;
        const double end = start + dot(plane.normal, displacement);
        const double radius = moving.radius * length(plane.normal);
        // Both have less than eight roundings of 2^-53 of their summands.
        const double margin = radius + 0x1p-48 * (dot(abs(plane.normal), reach) + std::fabs(plane.distance) + radius);
        if (std::max(start, end) < -margin) return true;
    }
    return false;
}

/// The distance to a convex set is a convex function of time whose slope is the speed along the
/// normal, so Newton's method from the start never overshoots the first contact (compare van den
/// Bergen 2004, who bounds the distance in the same way).
bool approach_frustum(const Frustum& frustum, const Sphere& moving, Vec3 displacement, Hit& hit) {
    if (passes_outside(frustum, moving, displacement)) return false;
    Vec3 nearest;
    if (!closest_point(frustum, moving.center, nearest)) return false;
    if (distance(nearest, moving.center) <= moving.radius) return contact_at_start(moving, displacement, nearest, hit);
    double t = 0;
    Vec3 normal;
    // Quadratic convergence; linear, halving the error, where the sphere grazes the frustum: 60 steps exhaust a
    // double.
    for (int step = 0; step < 60; ++step) {
        const Vec3 center = moving.center + displacement * t;
        closest_point(frustum, center, nearest);
        const Vec3 offset = center - nearest;
        normal = offset != Vec3{} ? normalized(offset) : -normalized(displacement);
        const double gap = length(offset) - moving.radius;
        // Both points have a few roundings of their coordinates.
        const double resolution = 0x1p-50 * (max_component(abs(center)) + max_component(abs(frustum.origin)));
        const double approach = -dot(normal, displacement);
        if (gap <= resolution) {
            // In contact within rounding, and moving away.
            if (t == 0 && approach <= 0) return contact_at_start(moving, displacement, nearest, hit);
            break;
        }
        if (approach <= 0 || gap > approach * (1 - t)) return false;
        t += gap / approach;
    }
    return contact(t, nearest, normal, 0, hit);
}

}  // namespace

/// Relative to the sphere, so that no digits are lost far from the origin.
bool sweep(const Frustum& frustum, const Sphere& moving, Vec3 displacement, Hit& hit) {
    if (moving.radius == 0) return raycast(frustum, path(moving, displacement), hit);
    Frustum around = frustum;
    around.origin = frustum.origin - moving.center;
    if (!approach_frustum(around, {{}, moving.radius}, displacement, hit)) return false;
    hit.point = hit.point + moving.center;
    return true;
}

bool sweep(const Shape& shape, const Sphere& moving, Vec3 displacement, Hit& hit) {
    return std::visit([&](const auto& each) { return sweep(each, moving, displacement, hit); }, shape);
}

namespace {

/// The unit vector nearest to a unit normal that does not point along the motion. The exact normal does not, so this
/// one is at least as near to it as the rounded one.
Vec3 against(Vec3 motion, Vec3 normal) {
    const double speed = length(motion);
    // A margin of sixteen roundings of 2^-53 for those that follow.
    const double along = dot(normal, motion) / speed + 0x1p-49;
    return along <= 0 ? normal : normalized(normal - motion * (along / speed));
}

}  // namespace

gphys_hit to_contact(const Hit& hit, Vec3 displacement, uint32_t model, uint32_t tag) {
    gphys_hit contact = to_hit(hit, model, tag);
    if ((hit.flags & GPHYS_HIT_INSIDE) || dot(widen(contact.normal), displacement) <= 0) return contact;
    // Round each component to the float that points less along the motion.
    const Vec3 normal = against(displacement, hit.normal);
    const auto rounded = [&](int axis) {
        const double way = displacement[axis];
        return way > 0 ? round_down(normal[axis]) : way < 0 ? round_up(normal[axis]) : static_cast<float>(normal[axis]);
    };
    contact.normal = {rounded(0), rounded(1), rounded(2)};
    return contact;
}

}  // namespace gphys

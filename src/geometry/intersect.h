// The queries on primitives, each with one name and one argument order:
//   contains       is a point in or on a shape?                  closest.cpp
//   closest_point  which point of a shape is nearest?            closest.cpp
//   overlaps       do two shapes share a point?                  overlap.cpp
//   classify       on which side of a plane or frustum?          classify.cpp
//   raycast        where does a ray first hit a shape?          raycast*.cpp
//   sweep          where does a moving solid first hit?         sweep.cpp, sweep_convex.cpp
//   penetration    how does a solid get out of a shape?          penetration.cpp
// Shapes are closed sets; solids are solid. Inputs are valid (shapes.h: defect).
#pragma once

#include <limits>

#include "foundation/reported.h"
#include "shapes/shapes.h"

namespace gphys {

struct Hit {
    double t = infinity;
    Vec3 point;
    Vec3 normal;  // unit, against the motion
    uint32_t triangle = GPHYS_NO_TRIANGLE;
    double u = 0, v = 0;  // barycentric weights of b and c
    uint32_t flags = 0;   // GPHYS_HIT_...
};

/// Clamped to the finite floats. A point on a plane almost parallel to the ray, or in a corner of almost parallel
/// planes, may be beyond them, and converting it would raise a floating-point exception.
inline gphys_vec3 rounded_point(Vec3 point) {
    constexpr double largest = std::numeric_limits<float>::max();
    constexpr Vec3 corner{largest, largest, largest};
    return narrow(min(max(point, -corner), corner));
}

/// The public struct, rounded. `model` is 0 if the query was not of a scene.
inline gphys_hit to_hit(const Hit& hit, uint32_t model = 0, uint32_t tag = 0) {
    const float u = static_cast<float>(hit.u), v = static_cast<float>(hit.v);
    return {model, tag, reported(hit.t), rounded_point(hit.point), narrow(hit.normal), hit.triangle, u, v, hit.flags};
}
/// The result of a ray that hits nothing.
inline constexpr gphys_distance no_distance{std::numeric_limits<float>::infinity(), 0, GPHYS_NO_TRIANGLE};
inline gphys_nearest to_nearest(Vec3 point, double distance, uint32_t triangle = GPHYS_NO_TRIANGLE, uint32_t model = 0,
                                uint32_t tag = 0) {
    return {model, tag, rounded_point(point), reported(distance), triangle};
}

enum class Side { outside = GPHYS_SIDE_OUTSIDE, crossing = GPHYS_SIDE_CROSSING, inside = GPHYS_SIDE_INSIDE };

bool contains(const Segment& segment, Vec3 point, double tolerance);
bool contains(const Ray& ray, Vec3 point, double tolerance);
bool contains(const Sphere& sphere, Vec3 point, double tolerance);
bool contains(const Capsule& capsule, Vec3 point, double tolerance);
bool contains(const Aabb& box, Vec3 point, double tolerance);
bool contains(const Obb& box, Vec3 point, double tolerance);
bool contains(const Plane& plane, Vec3 point, double tolerance);
bool contains(const Triangle& triangle, Vec3 point, double tolerance);
bool contains(const Frustum& frustum, Vec3 point, double tolerance);

Vec3 closest_point(const Segment& segment, Vec3 point);
Vec3 closest_point(const Ray& ray, Vec3 point);
Vec3 closest_point(const Sphere& sphere, Vec3 point);
Vec3 closest_point(const Capsule& capsule, Vec3 point);
Vec3 closest_point(const Aabb& box, Vec3 point);
Vec3 closest_point(const Obb& box, Vec3 point);
Vec3 closest_point(const Plane& plane, Vec3 point);
Vec3 closest_point(const Triangle& triangle, Vec3 point);
/// Returns false if the frustum is empty.
bool closest_point(const Frustum& frustum, Vec3 point, Vec3& out);
/// Closest points of two segments (Ericson 2005, 5.1.9).
void closest_points(const Segment& a, const Segment& b, Vec3& out_a, Vec3& out_b);

/// Accepts every pair of alternatives of Shape. Symmetric.
bool overlaps(const Shape& a, const Shape& b);
/// For the leaves of trees, without the dispatch of a Shape.
bool overlaps(const Sphere& sphere, const Triangle& triangle);
bool overlaps(const Aabb& box, const Triangle& triangle);
bool overlaps(const Triangle& a, const Triangle& b);

/// signed_distance: that of the point nearest to the plane; 0 if the shape crosses it. Not for Plane and Frustum.
Side classify(const Shape& shape, const Plane& plane, double& signed_distance);
Side classify(const Shape& shape, const Frustum& frustum);

/// A ray of zero length (a segment whose ends coincide) hits if the shape contains its origin.
bool raycast(const Sphere& sphere, const Ray& ray, Hit& hit);
bool raycast(const Capsule& capsule, const Ray& ray, Hit& hit);
bool raycast(const Aabb& box, const Ray& ray, Hit& hit);
bool raycast(const Obb& box, const Ray& ray, Hit& hit);
bool raycast(const Plane& plane, const Ray& ray, Hit& hit);
bool raycast(const Triangle& triangle, const Ray& ray, Hit& hit);
bool raycast(const Frustum& frustum, const Ray& ray, Hit& hit);
bool raycast(const Shape& shape, const Ray& ray, Hit& hit);
/// Makes the hit of a ray that starts in a solid: t = 0, GPHYS_HIT_INSIDE. Returns true.
bool started_inside(const Ray& ray, Hit& hit);
/// The segment as a ray that ends at t = 1. Exact: Ray::rest holds the rounding error of b - a.
Ray ray_along(const Segment& segment);

/// A ray with the constants of Woop's shear, which maps its direction to an axis (Woop, Benthin, Wald 2013), for tests
/// against many triangles.
struct ShearedRay : Ray {
    ShearedRay() = default;
    explicit ShearedRay(const Ray& ray);

    // In groups of four, so that eight rays are loaded and stored by transposing (triangle_lanes.h).
    int kx, ky, kz, no_axis;  // kz: the axis of the direction's largest component
    // Components along these axes.
    double from[3], speed;
    double sx, sy, end, unused;
};
/// The crossing of a ray and a triangle, from either side.
struct TriangleCrossing {
    double t;
    double u, v;  // weights of b and c; rounding may leave them barely outside of 0..1
    int facing;   // sign of dot(normal, direction)
};
bool crosses(const Triangle& triangle, const ShearedRay& ray, TriangleCrossing& crossing);
/// The hit at a crossing, but for its triangle. More expensive than crosses(), so computed for the nearest crossing
/// only.
void make_hit(const Triangle& triangle, const Ray& ray, const TriangleCrossing& crossing, Hit& hit);

/// The barycentric weights of b and c of a point on the triangle; both 0 if it is degenerate.
void barycentric(const Triangle& triangle, Vec3 point, double& u, double& v);

bool sweep(const Sphere& sphere, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Capsule& capsule, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Aabb& box, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Obb& box, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Plane& plane, const Sphere& moving, Vec3 displacement, Hit& hit);
/// Of a triangle, a contact after t_max may be left out.
bool sweep(const Triangle& triangle, const Sphere& moving, Vec3 displacement, Hit& hit, double t_max = 1);
bool sweep(const Frustum& frustum, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Shape& shape, const Sphere& moving, Vec3 displacement, Hit& hit);
/// The same for a moving sphere, capsule or box. A frustum must be a hexahedron (shapes.h), unless a sphere moves.
bool sweep(const Shape& shape, const Shape& moving, Vec3 displacement, Hit& hit);
bool sweep(const Triangle& triangle, const Shape& moving, Vec3 displacement, Hit& hit, double t_max = 1);
/// Relative to the size: twice the error that the distance of shapes in contact may have (gamephys_c.h). Shapes that
/// are farther apart until t_max have no contact before, whatever the rounding.
constexpr double apart_margin = 0x1p-39;
/// The AABB of a moving sphere, capsule or box, as centre and half extents.
struct BoxInMotion {
    explicit BoxInMotion(const Shape& moving);
    /// `half`, enlarged by the distance that a sweep against shapes in a box may count as contact because of rounding.
    Vec3 half_with_rounding(const Box& shapes, Vec3 displacement) const;
    Box box;
    Vec3 middle, half;
};

/// The minimum translation that moves a solid out of a shape that it overlaps.
struct Penetration {
    double depth;  // its length
    Vec3 normal;   // its direction, of length 1
    Vec3 point;    // the contact point after the translation
};
/// The public struct. `triangle` is GPHYS_NO_TRIANGLE if the shape has none.
inline gphys_penetration to_penetration(const Penetration& way, uint32_t triangle = GPHYS_NO_TRIANGLE,
                                        uint32_t model = 0, uint32_t tag = 0) {
    return {model, tag, rounded_point(way.point), narrow(way.normal), reported(way.depth), triangle};
}
/// The order of lists: deepest first, then by model and triangle.
struct DeepestFirst {
    bool operator()(const gphys_penetration& a, const gphys_penetration& b) const {
        if (a.depth != b.depth) return a.depth > b.depth;
        return a.model != b.model ? a.model < b.model : a.triangle < b.triangle;
    }
};
/// `moving` is a sphere, capsule or box; a frustum must be a hexahedron (shapes.h). They must overlap, up to rounding.
Penetration penetration(const Shape& shape, const Shape& moving);
Penetration penetration(const Triangle& triangle, const Shape& moving);

/// The public struct of a sweep's hit. Its normal opposes the motion even after rounding to floats, unless the solid
/// overlapped at the start.
gphys_hit to_contact(const Hit& hit, Vec3 displacement, uint32_t model = 0, uint32_t tag = 0);

}  // namespace gphys

// The questions, with one name and one argument order each:
//   contains       is a point in or on a shape?                  closest.cpp
//   closest_point  which point of a shape is nearest?            closest.cpp
//   overlaps       do two shapes share a point?                  overlap.cpp
//   classify       on which side of a plane or frustum?          classify.cpp
//   raycast        where does a ray first meet a shape?          raycast*.cpp
//   sweep          where does a moving solid first touch?        sweep.cpp, sweep_convex.cpp
//   penetration    how does a solid get out of a shape?          penetration.cpp
// Shapes are closed sets; solids are solid. Inputs are valid (shapes.h: defect).
#pragma once

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

/// A point that lies beyond all floats (on a plane almost parallel to the ray, in a corner of planes that are almost
/// parallel) stays at the largest: the cast would trap.
inline gphys_vec3 rounded_point(Vec3 point) {
    constexpr double largest = std::numeric_limits<float>::max();
    constexpr Vec3 corner{largest, largest, largest};
    return narrow(min(max(point, -corner), corner));
}

/// The public form, rounded; model 0 when the question was not of a scene.
inline gphys_hit to_hit(const Hit& hit, uint32_t model = 0, uint32_t tag = 0) {
    const float u = static_cast<float>(hit.u), v = static_cast<float>(hit.v);
    return {model, tag, reported(hit.t), rounded_point(hit.point), narrow(hit.normal), hit.triangle, u, v, hit.flags};
}
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
/// False if the frustum is empty.
bool closest_point(const Frustum& frustum, Vec3 point, Vec3& out);
/// Closest points of two segments (Ericson 2005, 5.1.9).
void closest_points(const Segment& a, const Segment& b, Vec3& out_a, Vec3& out_b);

/// Every pair of the alternatives of Shape; symmetric.
bool overlaps(const Shape& a, const Shape& b);
/// The pairs that tree leaves ask, without the detour through Shape.
bool overlaps(const Sphere& sphere, const Triangle& triangle);
bool overlaps(const Aabb& box, const Triangle& triangle);
bool overlaps(const Triangle& a, const Triangle& b);

/// signed_distance: of the nearest point to the plane, 0 when crossing. Not for Plane, Frustum.
Side classify(const Shape& shape, const Plane& plane, double& signed_distance);
Side classify(const Shape& shape, const Frustum& frustum);

/// A ray of zero length (segment whose ends coincide) asks whether its origin is contained.
bool raycast(const Sphere& sphere, const Ray& ray, Hit& hit);
bool raycast(const Capsule& capsule, const Ray& ray, Hit& hit);
bool raycast(const Aabb& box, const Ray& ray, Hit& hit);
bool raycast(const Obb& box, const Ray& ray, Hit& hit);
bool raycast(const Plane& plane, const Ray& ray, Hit& hit);
bool raycast(const Triangle& triangle, const Ray& ray, Hit& hit);
bool raycast(const Frustum& frustum, const Ray& ray, Hit& hit);
bool raycast(const Shape& shape, const Ray& ray, Hit& hit);
/// The hit of a ray whose origin is in a solid: at once. Always true.
bool started_inside(const Ray& ray, Hit& hit);
/// The segment as a ray that ends at t = 1: exactly, whatever b - a rounds away.
Ray ray_along(const Segment& segment);

/// A ray prepared for many triangles by Woop's shear (Woop, Benthin, Wald 2013), which takes its
/// direction to an axis.
struct ShearedRay : Ray {
    ShearedRay() = default;
    explicit ShearedRay(const Ray& ray);

    // In fours, so that those of eight rays are read and written at once (triangle_lanes.h).
    int kx, ky, kz, no_axis;  // kz: the axis along which the direction is longest
    // On these axes.
    double from[3], speed;
    double sx, sy, end, unused;
};
/// Where a ray first meets a triangle, of either side.
struct TriangleCrossing {
    double t;
    double u, v;  // weights of b and c; rounding may leave them barely outside of 0..1
    int facing;   // sign of dot(normal, direction)
};
bool crosses(const Triangle& triangle, const ShearedRay& ray, TriangleCrossing& crossing);
/// The whole answer, which costs more than the question: to be made of the nearest crossing.
Hit hit_at(const Triangle& triangle, const ShearedRay& ray, const TriangleCrossing& crossing);

/// Weights of b and c of a point on the triangle; both 0 if it is degenerate.
void barycentric(const Triangle& triangle, Vec3 point, double& u, double& v);

bool sweep(const Sphere& sphere, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Capsule& capsule, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Aabb& box, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Obb& box, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Plane& plane, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Triangle& triangle, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Frustum& frustum, const Sphere& moving, Vec3 displacement, Hit& hit);
bool sweep(const Shape& shape, const Sphere& moving, Vec3 displacement, Hit& hit);
/// The same for a moving sphere, capsule or box. The shape is no frustum, unless a sphere moves.
bool sweep(const Shape& shape, const Shape& moving, Vec3 displacement, Hit& hit);
bool sweep(const Triangle& triangle, const Shape& moving, Vec3 displacement, Hit& hit);
/// The box around a sphere, capsule or box, its middle, and how far it reaches along each axis.
struct BoxInMotion {
    explicit BoxInMotion(const Shape& moving);
    /// `half`, and how far a sweep may count as contact what rounding does not tell from it, of shapes in a box.
    Vec3 half_with_rounding(const Box& shapes, Vec3 displacement) const;
    Box box;
    Vec3 middle, half;
};

/// The shortest way for a solid out of a shape that it overlaps.
struct Penetration {
    double depth;  // its length
    Vec3 normal;   // its direction, of length 1
    Vec3 point;    // where the two then touch
};
/// The public form; model 0 when the question was not of a scene.
inline gphys_penetration to_penetration(const Penetration& way, uint32_t triangle = GPHYS_NO_TRIANGLE,
                                        uint32_t model = 0, uint32_t tag = 0) {
    return {model, tag, rounded_point(way.point), narrow(way.normal), reported(way.depth), triangle};
}
/// Deepest first, then by model and triangle: the order of lists of them.
struct DeepestFirst {
    bool operator()(const gphys_penetration& a, const gphys_penetration& b) const {
        if (a.depth != b.depth) return a.depth > b.depth;
        return a.model != b.model ? a.model < b.model : a.triangle < b.triangle;
    }
};
/// For a sphere, capsule or box, and shapes that are no frusta; they overlap (overlaps), but for rounding.
Penetration penetration(const Shape& shape, const Shape& moving);
Penetration penetration(const Triangle& triangle, const Shape& moving);

/// The public form of a sweep's hit. Its normal is against the motion as floats too, unless the sphere started
/// touching.
gphys_hit to_contact(const Hit& hit, Vec3 displacement, uint32_t model = 0, uint32_t tag = 0);

}  // namespace gphys

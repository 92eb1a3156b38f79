// The primitives in double precision: data, widening from the public float structs, validity, bounds and transforms.
// Queries are in geometry/intersect.h.
#pragma once

#include <variant>

#include "foundation/math.h"
#include "foundation/status.h"

namespace gphys {

/// Which sides of surfaces can be hit: of planes, triangles and surface meshes.
struct Faces {
    bool front = true, back = true;

    bool are_all() const { return front && back; }
    bool include(bool from_behind) const { return from_behind ? back : front; }
};

struct Ray {
    Vec3 origin, direction;
    double t_max = infinity;
    /// The exact direction is direction + rest: of a segment, b - a may not be a double.
    Vec3 rest = {};
    /// A segment as a ray: its end, at t = 1, has double coordinates.
    bool is_segment = false;
    /// The sides that the scene and meshes reject; the formulas of single shapes hit both.
    Faces faces = {};
};
Vec3 end_of(const Ray& segment);

struct Segment {
    Vec3 a, b;
};

struct Sphere {
    Vec3 center;
    double radius;
};

struct Capsule {
    Vec3 a, b;
    double radius;
};

struct Aabb {
    Vec3 min, max;
};

struct Obb {
    Vec3 center, half;
    Mat3 axes;
};

/// dot(normal, x) = distance; the normal need not be unit.
struct Plane {
    Vec3 normal;
    double distance;
};

struct Triangle {
    Vec3 a, b, c;
};

/// dot(planes[i].normal, x - origin) >= planes[i].distance for all i; order of gphys_frustum.
struct Frustum {
    Vec3 origin;
    Plane planes[6];
};

/// Any primitive that a model can have or that can be tested for overlap.
using Shape = std::variant<Sphere, Capsule, Aabb, Obb, Plane, Triangle, Frustum>;

/// The float AABB of trees; empty if min > max.
struct Box {
    float min[3] = {std::numeric_limits<float>::max(), std::numeric_limits<float>::max(),
                    std::numeric_limits<float>::max()};
    float max[3] = {std::numeric_limits<float>::lowest(), std::numeric_limits<float>::lowest(),
                    std::numeric_limits<float>::lowest()};

    void include(const Box& other) {
        for (int k = 0; k < 3; ++k) {
            min[k] = std::min(min[k], other.min[k]);
            max[k] = std::max(max[k], other.max[k]);
        }
    }
};

inline Ray widen(const gphys_ray& r) { return {widen(r.origin), widen(r.direction), r.t_max}; }
inline Segment widen(const gphys_segment& s) { return {widen(s.a), widen(s.b)}; }
inline Sphere widen(const gphys_sphere& s) { return {widen(s.center), s.radius}; }
inline Capsule widen(const gphys_capsule& c) { return {widen(c.a), widen(c.b), c.radius}; }
inline Aabb widen(const gphys_aabb& b) { return {widen(b.min), widen(b.max)}; }
inline Obb widen(const gphys_obb& b) {
    return {widen(b.center), widen(b.half_extents), rotation_matrix(widen(b.rotation))};
}
inline Plane widen(const gphys_plane& p) { return {widen(p.normal), p.distance}; }
inline Triangle widen(const gphys_triangle& t) { return {widen(t.a), widen(t.b), widen(t.c)}; }
inline Frustum widen(const gphys_frustum& f) {
    return {widen(f.origin),
            {widen(f.planes[0]), widen(f.planes[1]), widen(f.planes[2]), widen(f.planes[3]), widen(f.planes[4]),
             widen(f.planes[5])}};
}

inline gphys_aabb narrow(const Box& b) { return {{b.min[0], b.min[1], b.min[2]}, {b.max[0], b.max[1], b.max[2]}}; }
inline gphys_plane narrow(const Plane& p) { return {narrow(p.normal), static_cast<float>(p.distance)}; }
inline gphys_frustum narrow(const Frustum& f) {
    gphys_frustum out{narrow(f.origin), {}};
    for (int i = 0; i < 6; ++i) out.planes[i] = narrow(f.planes[i]);
    return out;
}

/// The first number of a caller's value that is out of range.
Defect defect(const gphys_vec3& point);
Defect defect(const gphys_quat& rotation);
Defect defect(const gphys_transform& transform);
Defect defect(const gphys_ray& ray);
Defect defect(const gphys_segment& segment);
Defect defect(const gphys_sphere& sphere);
Defect defect(const gphys_capsule& capsule);
Defect defect(const gphys_aabb& box);
Defect defect(const gphys_obb& box);
Defect defect(const gphys_plane& plane);
Defect defect(const gphys_triangle& triangle);
Defect defect(const gphys_frustum& frustum);

/// The smallest float AABB of a shape, rounded outward.
Box bounds(const Segment& segment);
Box bounds(const Sphere& sphere);
Box bounds(const Capsule& capsule);
Box bounds(const Aabb& box);
Box bounds(const Obb& box);
Box bounds(const Triangle& triangle);
/// Returns false if the ray ends at infinity or beyond the largest float.
bool bounds(const Ray& ray, Box& out);

/// The transformed shape. An Aabb becomes an Obb.
Ray transformed(const Ray& ray, const Transform& t);
Segment transformed(const Segment& segment, const Transform& t);
Sphere transformed(const Sphere& sphere, const Transform& t);
Capsule transformed(const Capsule& capsule, const Transform& t);
Obb transformed(const Aabb& box, const Transform& t);
Obb transformed(const Obb& box, const Transform& t);
Plane transformed(const Plane& plane, const Transform& t);
Triangle transformed(const Triangle& triangle, const Transform& t);
Frustum transformed(const Frustum& frustum, const Transform& t);
/// The inverse: a shape in world space to the local space of a model.
Shape inverse_transformed(const Shape& shape, const Transform& t);

/// The shape relative to a point: small numbers if they are near each other, even far from the origin.
Sphere relative_to(Vec3 point, const Sphere& sphere);
Capsule relative_to(Vec3 point, const Capsule& capsule);
Aabb relative_to(Vec3 point, const Aabb& box);
Obb relative_to(Vec3 point, const Obb& box);
Plane relative_to(Vec3 point, const Plane& plane);
Triangle relative_to(Vec3 point, const Triangle& triangle);
Frustum relative_to(Vec3 point, const Frustum& frustum);
Segment relative_to(Vec3 point, const Segment& segment);
Ray relative_to(Vec3 point, const Ray& ray);

Obb as_obb(const Aabb& box);
/// Whether each axis is exactly parallel to a world axis.
bool axis_parallel(const Mat3& axes);

/// The same plane with a normal of length 1 to 4, so that products of several normals neither overflow nor underflow.
/// Scaled by a power of two, which is exact. A zero normal stays.
Plane scaled_to_one(const Plane& plane);
/// The common point of three planes, each coordinate with a relative error below 2^-42. Returns false if their normals
/// are coplanar.
bool common_point(const Plane& a, const Plane& b, const Plane& c, Vec3& out);

/// The eight corners in the order of gphys_frustum_corners. Returns false if three planes have no common point.
bool corners(const Frustum& frustum, Vec3 out[8]);
/// Whether the frustum is the convex hull of those corners, with six faces of four corners each: every corner lies, by
/// more than rounding, in front of the three planes that do not meet in it.
bool is_hexahedron(const Frustum& frustum);

}  // namespace gphys

// Shapes for quick tests: made from what a model stores without a division or a normalised rotation.
//
// A quick test is asked before an exact one. Its "no" and "yes" are certain, and what it leaves open
// is for intersect.h to decide: the one shape that a ray meets first, and those within rounding of a
// touch.
//
// Errors. A quick test and the exact one reach each of their numbers by some dozens of roundings of
// 2^-53 of the coordinates that went into it. `slack`, 2^-43 of the sum of these, is a thousand
// roundings and several times what the two can be apart; within it neither yes nor no is said.
#pragma once

#include "mesh/mesh.h"
#include "scene/placed.h"

namespace gphys {

enum class Verdict { no, yes, open };
/// For a question of which only a "no" is of use.
constexpr Verdict unless_no(Verdict verdict) { return verdict == Verdict::no ? Verdict::no : Verdict::open; }

constexpr double slack = 0x1p-43;

constexpr double sum(Vec3 v) { return v.x + v.y + v.z; }

/// q turns by |q|^2 times its rotation.
constexpr Mat3 scaled_rotation(Quat q) {
    const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, ww = q.w * q.w;
    const double xy = 2 * q.x * q.y, xz = 2 * q.x * q.z, yz = 2 * q.y * q.z;
    const double wx = 2 * q.w * q.x, wy = 2 * q.w * q.y, wz = 2 * q.w * q.z;
    return {{ww + xx - yy - zz, xy + wz, xz - wy},
            {xy - wz, ww - xx + yy - zz, yz + wx},
            {xz + wy, yz - wx, ww - xx - yy + zz}};
}
constexpr double norm_squared(Quat q) { return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w; }

struct QuickSphere {
    Vec3 center;
    double radius;
    double magnitude;  // sum of the coordinates that went into it, without signs
};

struct QuickBox {
    Mat3 axes;
    double unit;  // the length of each axis
    Vec3 center, half;
    double magnitude;

    /// Along the axes from the centre, times `unit`.
    Vec3 local(Vec3 point) const { return transpose_times(axes, point - center); }
};

inline Vec3 quick_point(Vec3 point, const gphys_transform& world) {
    const Vec3 position = widen(world.position), scaled = point * world.scale;
    if (!is_turned(world.rotation) || point == Vec3{}) return position + scaled;
    const Quat q = widen(world.rotation);
    return position + scaled_rotation(q) * scaled * (1 / norm_squared(q));
}

inline QuickSphere quick_sphere(Vec3 center, double radius, const gphys_transform& world) {
    const double scale = world.scale, scaled_radius = radius * scale;
    return {quick_point(center, world), scaled_radius,
            sum(abs(widen(world.position))) + sum(abs(center)) * scale + scaled_radius};
}
inline QuickSphere quick_shape(const gphys_sphere& sphere, const gphys_transform& world) {
    return quick_sphere(widen(sphere.center), sphere.radius, world);
}

inline QuickBox quick_box(Vec3 center, Vec3 half, const gphys_transform& world) {
    const Quat q = widen(world.rotation);
    const double scale = world.scale;
    return {scaled_rotation(q), norm_squared(q), quick_point(center, world), half * scale,
            sum(abs(widen(world.position))) + (sum(abs(center)) + sum(half)) * scale};
}
/// A float box that holds it.
inline Box quick_bounds(const QuickBox& box) {
    const Vec3 reach = abs(box.axes.x) * box.half.x + abs(box.axes.y) * box.half.y + abs(box.axes.z) * box.half.z;
    const double error = slack * box.magnitude, shorten = 1 / box.unit;
    Box result;
    for (int k = 0; k < 3; ++k) {
        const double half = reach[k] * shorten + error;
        result.min[k] = round_down(box.center[k] - half);
        result.max[k] = round_up(box.center[k] + half);
    }
    return result;
}

inline QuickBox quick_shape(const gphys_aabb& box, const gphys_transform& world) {
    const Vec3 low = widen(box.min), high = widen(box.max);
    return quick_box((low + high) * 0.5, (high - low) * 0.5, world);
}
inline QuickBox quick_shape(const gphys_obb& box, const gphys_transform& world) {
    QuickBox result = quick_box(widen(box.center), widen(box.half_extents), world);
    if (!is_turned(box.rotation)) return result;
    const Quat q = widen(box.rotation);
    const Mat3 outer = result.axes, inner = scaled_rotation(q);
    result.axes = {outer * inner.x, outer * inner.y, outer * inner.z};
    result.unit *= norm_squared(q);
    return result;
}
/// The box that holds the mesh: a "no" to it is one to the mesh.
inline QuickBox quick_shape(const Mesh* mesh, const gphys_transform& world) {
    const Box box = mesh->octree().bounds();
    const Vec3 low{box.min[0], box.min[1], box.min[2]}, high{box.max[0], box.max[1], box.max[2]};
    return quick_box((low + high) * 0.5, (high - low) * 0.5, world);
}

/// The same when asked for: rays are quicker with the sphere that holds the mesh.
struct QuickMesh {
    const Mesh* mesh;
    const gphys_transform& world;

    operator QuickBox() const { return quick_shape(mesh, world); }
    QuickSphere sphere() const { return quick_sphere(mesh->center(), mesh->radius(), world); }
};

template <class Stored>
constexpr bool has_quick_shape = !std::is_same_v<Stored, gphys_capsule> && !std::is_same_v<Stored, gphys_plane> &&
                                 !std::is_same_v<Stored, gphys_triangle>;

/// Ask a quick test about a stored shape: test(quick shape) gives the Verdict.
template <class Stored, class Test>
Verdict quick_verdict(const Stored& shape, const gphys_transform& world, Test&& test) {
    if constexpr (!has_quick_shape<Stored>) {
        return Verdict::open;
    } else if constexpr (std::is_pointer_v<Stored>) {
        return unless_no(test(QuickMesh{shape, world}));
    } else {
        return test(quick_shape(shape, world));
    }
}

}  // namespace gphys

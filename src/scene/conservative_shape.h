// Shapes for the conservative tests (conservative_tests.h): made from a model's stored shape and transform without a
// division and without a normalised rotation, so cheaper than the exact shape.
//
// A conservative test runs before the exact one. Its "no" and "yes" are certain. "Undecided" goes to the exact test
// (intersect.h): the first hit of a ray, and shapes within rounding of contact. This is a floating-point filter in the
// sense of exact geometric computation (Fortune and Van Wyk 1993).
//
// Errors. Each number of the conservative or the exact test has some dozens of roundings of 2^-53 of its input
// coordinates. `slack`, 2^-43 of their sum, covers a thousand roundings, several times the largest difference of the
// two tests. Within it the answer is undecided.
#pragma once

#include "foundation/compiler.h"
#include "foundation/scaled_rotation.h"
#include "foundation/tri_state.h"
#include "geometry/box_bounds.h"
#include "mesh/mesh.h"
#include "scene/placed.h"

namespace gphys {

constexpr double slack = 0x1p-43;

/// The same for float32: 128 roundings of 2^-24. A rotation of a vector takes at most 23; no test has more than two
/// rotations and a dozen others.
constexpr float float_slack = 0x1p-17f;
/// For a number that is rounded once or twice.
constexpr float few_roundings = 0x1p-21f;

/// Bound of what numbers lose below the smallest normal float: some hundred times 2^-149, with reserve for products
/// with other margins.
constexpr double smallest_slack = 0x1p-120;

/// For squared distances of a point from a box in float32, besides the margins of the coordinates: 64 roundings of
/// 2^-24. The sum of squares takes eighteen.
constexpr float square_slack = 0x1p-18f;
/// Hosts may flush squares below 2^-126 to zero.
constexpr float smallest_square = 0x1p-120f;
/// Beyond all boxes; its square fits a float.
constexpr double most_reach = 0x1p60;
/// Lower bound of the largest component of a direction, so that its inverse is finite. Upper bound of t_max in floats.
constexpr double least_speed = 0x1p-200, most_end = 0x1p100;

inline ScaledRotation<Float4> scaled_rotation(Float4 q) {
    return {as_floats(as_mask(q) & mask4(-1, -1, -1, 0)), simd4::shuffle<3, 3, 3, 3>(q, q)};
}

struct ConservativeSphere {
    Vec3 center;
    double radius;
    double magnitude;  // sum of the absolute values of its input coordinates
};

struct ConservativeBox {
    Mat3 axes;
    double unit;  // the length of each axis, since the rotation is not normalised
    Vec3 center, half;
    double magnitude;

    /// Relative to the centre, on the box's axes; times `unit`.
    Vec3 local(Vec3 point) const { return transpose_times(axes, point - center); }
};

/// Rare, so not inlined.
GPHYS_NOINLINE inline Vec3 rotated_point(Vec3 point, const gphys_quat& rotation) {
    const Quat q = widen(rotation);
    return scaled_rotation_matrix(q) * point * (1 / norm_squared(q));
}
inline Vec3 conservative_point(Vec3 point, const gphys_transform& world) {
    const Vec3 position = widen(world.position), scaled = point * world.scale;
    if (!is_rotated(world.rotation) || point == Vec3{}) return position + scaled;
    return position + rotated_point(scaled, world.rotation);
}

GPHYS_INLINE ConservativeSphere conservative_sphere(Vec3 center, double radius, const gphys_transform& world) {
    const double scale = world.scale, scaled_radius = radius * scale;
    return {conservative_point(center, world), scaled_radius,
            sum(abs(widen(world.position))) + sum(abs(center)) * scale + scaled_radius};
}
inline ConservativeSphere conservative_shape(const gphys_sphere& sphere, const gphys_transform& world) {
    return conservative_sphere(widen(sphere.center), sphere.radius, world);
}

struct CenterAndHalf {
    Vec3 center, half;

    /// ConservativeBox::magnitude of the box in the world.
    double magnitude(const gphys_transform& world) const {
        return sum(abs(widen(world.position))) + (sum(abs(center)) + sum(half)) * world.scale;
    }
};
inline CenterAndHalf center_and_half(const Vec3& low, const Vec3& high) {
    return {(low + high) * 0.5, (high - low) * 0.5};
}
inline CenterAndHalf center_and_half(const gphys_aabb& box) { return center_and_half(widen(box.min), widen(box.max)); }
inline CenterAndHalf center_and_half(const gphys_obb& box) { return {widen(box.center), widen(box.half_extents)}; }

inline ConservativeBox conservative_box(const CenterAndHalf& box, const gphys_transform& world) {
    const Quat q = widen(world.rotation);
    return {scaled_rotation_matrix(q), norm_squared(q), conservative_point(box.center, world), box.half * world.scale,
            box.magnitude(world)};
}
inline ConservativeBox conservative_shape(const gphys_aabb& box, const gphys_transform& world) {
    return conservative_box(center_and_half(box), world);
}
inline ConservativeBox conservative_shape(const gphys_obb& box, const gphys_transform& world) {
    ConservativeBox result = conservative_box(center_and_half(box), world);
    if (!is_rotated(box.rotation)) return result;
    const Quat q = widen(box.rotation);
    result.axes = result.axes * scaled_rotation_matrix(q);
    result.unit *= norm_squared(q);
    return result;
}
/// The bounding box of a mesh: a miss of the box is a miss of the mesh.
inline ConservativeBox conservative_shape(const ModelMesh& stored, const gphys_transform& world) {
    const Aabb box = stored.axes()(stored.mesh->bvh().bounds());
    return conservative_box(center_and_half(box.min, box.max), world);
}

/// A plane, relative to the position of its model. Its normal need not be unit; `normal` is that in the world times the
/// squared length of the quaternion, since the rotation is not normalised.
struct ConservativePlane {
    Vec3 position, normal;
    double offset;  // dot(normal, point - position) of its points
    double size;    // no component of any normal of this length is larger

    /// Above the plane, in units of the normal's length.
    double height(Vec3 point) const { return dot(normal, point - position) - offset; }
    /// Bound of the errors of height(), of the exact test, and of a reach that is part of `magnitude`: the sum of the
    /// absolute coordinates of the query.
    double height_error(double magnitude) const {
        return slack * (size * (magnitude + sum(abs(position))) + std::fabs(offset));
    }
};
inline ConservativePlane conservative_shape(const gphys_plane& plane, const gphys_transform& world) {
    Vec3 normal = widen(plane.normal);
    double unit = 1;
    const double size = sum(abs(normal));
    if (is_rotated(world.rotation)) {
        const Quat q = widen(world.rotation);
        normal = scaled_rotation_matrix(q) * normal;
        unit = norm_squared(q);
    }
    return {widen(world.position), normal, plane.distance * double{world.scale} * unit, size * unit};
}

/// Whether a ray may hit a plane: it approaches, and does not end before.
inline bool may_hit(const ConservativePlane& plane, const Ray& ray) {
    const double start = plane.height(ray.origin), climb = dot(plane.normal, ray.direction);
    const double gap = std::fabs(start) - plane.height_error(sum(abs(ray.origin)));
    if (!(gap > 0)) return true;
    const double approach = (start > 0 ? -climb : climb) + slack * plane.size * sum(abs(ray.direction));
    return approach > 0 && approach * ray.t_max >= gap;
}

struct FloatBox {
    Float4 center, half;
};
inline FloatBox float_box(const gphys_aabb& box) {
    const Float4 low = load4(box.min), high = load4(box.max);
    return {(low + high) * 0.5f, (high - low) * 0.5f};
}
inline FloatBox float_box(const gphys_obb& box) { return {load4(box.center), load4(box.half_extents)}; }

/// Whether a box is centred on the origin of its model: then its centre is the model's position, without rounding.
/// Compares bits, since hosts may treat subnormal numbers as zero.
inline bool is_centered(const gphys_aabb& box) {
    const Mask4 signs = mask4(INT32_MIN, INT32_MIN, INT32_MIN, 0);
    return !any(as_mask(load4(box.min)) ^ as_mask(load4(box.max)) ^ signs);
}
inline bool is_centered(const gphys_obb& box) { return !any(as_mask(load4(box.center))); }

/// A float box that contains a stored box in the world.
template <class Stored>
Box conservative_bounds(const Stored& stored, const gphys_transform& world) {
    Float4 rotation = load4(world.rotation);
    if constexpr (std::is_same_v<Stored, gphys_obb>) {
        if (is_rotated(stored.rotation)) rotation = narrow4(widen(world.rotation) * widen(stored.rotation));
    }
    const ScaledRotation<Float4> scaled = scaled_rotation(rotation);
    const Float4 half = float_box(stored).half * world.scale;
    const Float4 extents = outer_extents(scaled, half);
    Float4 low, high;
    if (is_centered(stored)) {
        const Float4 position = load4(world.position);
        low = position - extents;
        high = position + extents;
    } else {
        const CenterAndHalf box = center_and_half(stored);
        const double error = slack * box.magnitude(world);
        const Vec3 center = conservative_point(box.center, world);
        const Vec3 reach{extents[0] + error, extents[1] + error, extents[2] + error};
        low = narrow4(center - reach);
        high = narrow4(center + reach);
    }
    low -= corner_margin(low);
    high += corner_margin(high);
    Box result;
    for (int k = 0; k < 3; ++k) {
        result.min[k] = low[k];
        result.max[k] = high[k];
    }
    return result;
}

/// A stored box and its transform. Rays and points have float32 tests for it.
template <class Stored>
struct ConservativePlacedBox {
    const Stored& box;
    const gphys_transform& world;

    operator ConservativeBox() const { return conservative_shape(box, world); }
};

/// A point as a sum of two floats per coordinate, within 2^-48 of it.
struct SplitPoint {
    explicit SplitPoint(Vec3 point)
        : exact(point), head(narrow4(point)), rest(narrow4(point - Vec3{head[0], head[1], head[2]})) {}

    Vec3 exact;
    Float4 head, rest;
};

/// A stored box relative to a point, in float32, on the box's own axes, times `unit`. If the point has float
/// coordinates, as most do, its difference from the box's position is rounded once; so distance from the origin costs
/// no precision.
template <class Stored>
class RelativeBox {
public:
    /// `magnitude`: sum of the point's absolute coordinates.
    RelativeBox(const ConservativePlacedBox<Stored>& placed, const SplitPoint& point, double magnitude)
        : placed_(placed) {
        const FloatBox box = float_box(placed.box);
        const gphys_transform& world = placed.world;
        const Float4 position = load4(world.position);
        half = box.half * world.scale;
        Float4 sums = abs(position) + half;
        if (any(box.center != Float4{})) {
            const CenterAndHalf exact = center_and_half(placed.box);
            from = narrow4(point.exact - conservative_point(exact.center, world));
            sums += abs(box.center) * world.scale;
        } else {
            from = point.head - position + point.rest;
        }
        // Scaled, as are the box's numbers that hosts flush to zero.
        const float rounding = static_cast<float>(slack * magnitude + smallest_slack * (1 + double{world.scale}));
        margin = sum(float_slack * (abs(from) + half) + static_cast<float>(slack) * sums) + rounding;
        from = to_box_axes(from);
        unit = scaled_rotation(load4(world.rotation)).norm_squared();
        if constexpr (std::is_same_v<Stored, gphys_obb>) {
            unit *= scaled_rotation(load4(placed.box.rotation)).norm_squared();
        }
        half *= unit;
        margin *= unit;
    }

    /// A world vector on the box's axes, times `unit`.
    Float4 to_box_axes(Float4 v) const {
        v = scaled_rotation(load4(placed_.world.rotation)).inverse(v);
        if constexpr (std::is_same_v<Stored, gphys_obb>) {
            v = scaled_rotation(load4(placed_.box.rotation)).inverse(v);
        }
        return v;
    }

    Float4 from, half, unit;  // from: the point relative to the box's centre
    Float4 margin;            // error bound of each coordinate

private:
    const ConservativePlacedBox<Stored>& placed_;
};

/// A mesh: points and boxes test its AABB, rays its bounding sphere, which is cheaper.
struct ConservativeMesh {
    const ModelMesh& stored;
    const gphys_transform& world;

    operator ConservativeBox() const { return conservative_shape(stored, world); }
    ConservativeSphere sphere() const {
        if (!stored.is_scaled) return conservative_sphere(stored.mesh->center(), stored.mesh->radius(), world);
        const AxisScale axes = stored.axes();
        return conservative_sphere(axes(stored.mesh->center()), stored.mesh->radius(axes), world);
    }
};

template <class Stored>
constexpr bool has_conservative_shape =
    !std::is_same_v<Stored, gphys_capsule> && !std::is_same_v<Stored, gphys_triangle>;

template <class Stored>
constexpr bool is_box = std::is_same_v<Stored, gphys_aabb> || std::is_same_v<Stored, gphys_obb>;

/// Runs a conservative test on a stored shape: test(conservative shape) returns the TriState.
template <class Stored, class Test>
TriState conservative_verdict(const Stored& shape, const gphys_transform& world, Test&& test) {
    if constexpr (!has_conservative_shape<Stored>) {
        return TriState::undecided;
    } else if constexpr (std::is_same_v<Stored, ModelMesh>) {
        return only_no(test(ConservativeMesh{shape, world}));
    } else if constexpr (is_box<Stored>) {
        return test(ConservativePlacedBox<Stored>{shape, world});
    } else {
        return test(conservative_shape(shape, world));
    }
}

}  // namespace gphys

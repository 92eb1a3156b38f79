// Scaled shapes (model_scale.h): products in double, rounded once; checks of what a shape may be scaled by.
#include "scene/model_scale.h"

#include "foundation/floating_point.h"
#include "scene/placed.h"

namespace gphys {
namespace {

constexpr double most = GPHYS_MAX_COORDINATE;
constexpr const char* too_large = "scale: the scaled shape would be beyond GPHYS_MAX_COORDINATE";
constexpr const char* unequal =
    "scale: three different numbers are for meshes, hulls, triangles and boxes without a rotation of their own";

/// Clamped to twice the range of coordinates, which a float can hold; defect() rejects it afterwards.
gphys_vec3 product(const gphys_vec3& v, const gphys_vec3& scale) {
    const Vec3 exact = by_component(widen(v), widen(scale));
    constexpr Vec3 limit{2 * most, 2 * most, 2 * most};
    return narrow(min(max(exact, -limit), limit));
}
float product(float size, const gphys_vec3& scale) {
    return static_cast<float>(std::min(double{size} * double{scale.x}, 2 * most));
}
bool is_equal(const gphys_vec3& scale) { return scale.x == scale.y && scale.y == scale.z; }

template <class Shape>
ScaleError scale_error(const void* shape, const gphys_vec3& scale) {
    Shape stored;
    std::memcpy(&stored, shape, sizeof stored);
    bool any_scale = std::is_same_v<Shape, gphys_aabb> || std::is_same_v<Shape, gphys_triangle>;
    if constexpr (std::is_same_v<Shape, gphys_obb>) any_scale = !is_rotated(stored.rotation);
    if (!any_scale && !is_equal(scale)) return {GPHYS_ERROR_UNSUPPORTED, unequal};
    if (defect(scaled(stored, scale))) return {GPHYS_ERROR_INVALID_ARGUMENT, too_large};
    return {};
}

}  // namespace

Defect defect_of_scale(const gphys_vec3& scale) {
    const auto is_good = [](float s) {
        return std::isgreaterequal(s, 1 / GPHYS_MAX_COORDINATE) && std::islessequal(s, GPHYS_MAX_COORDINATE);
    };
    constexpr const char* range = "from 1e-15 to 1e15";
    if (!is_good(scale.x)) return {"", 'x', scale.x, range};
    if (!is_good(scale.y)) return {"", 'y', scale.y, range};
    if (!is_good(scale.z)) return {"", 'z', scale.z, range};
    return {};
}

gphys_sphere scaled(const gphys_sphere& sphere, const gphys_vec3& scale) {
    return {product(sphere.center, scale), product(sphere.radius, scale)};
}
gphys_capsule scaled(const gphys_capsule& capsule, const gphys_vec3& scale) {
    return {product(capsule.a, scale), product(capsule.b, scale), product(capsule.radius, scale)};
}
gphys_aabb scaled(const gphys_aabb& box, const gphys_vec3& scale) {
    return {product(box.min, scale), product(box.max, scale)};
}
gphys_obb scaled(const gphys_obb& box, const gphys_vec3& scale) {
    return {product(box.center, scale), product(box.half_extents, scale), box.rotation};
}
gphys_plane scaled(const gphys_plane& plane, const gphys_vec3& scale) {
    return {plane.normal, product(plane.distance, scale)};
}
gphys_triangle scaled(const gphys_triangle& triangle, const gphys_vec3& scale) {
    return {product(triangle.a, scale), product(triangle.b, scale), product(triangle.c, scale)};
}

ScaleError check_scale(const Mesh& mesh, const gphys_vec3& scale) {
    if (is_one(scale)) return {};
    if (mesh.kind() == MeshKind::body_links) {
        return {GPHYS_ERROR_UNSUPPORTED, "scale: must be 1 1 1 for a mesh of a rope or of particles"};
    }
    if (mesh.triangle_count() == 0) return {};
    const Aabb box = AxisScale(widen(scale))(mesh.bounds());
    if (max_component(max(abs(box.min), abs(box.max))) > most) return {GPHYS_ERROR_INVALID_ARGUMENT, too_large};
    return {};
}

ScaleError check_scale(gphys_shape_type type, const void* shape, const gphys_vec3& scale) {
    if (is_one(scale)) return {};
    switch (type) {
        case GPHYS_SHAPE_SPHERE:
            return scale_error<gphys_sphere>(shape, scale);
        case GPHYS_SHAPE_CAPSULE:
            return scale_error<gphys_capsule>(shape, scale);
        case GPHYS_SHAPE_AABB:
            return scale_error<gphys_aabb>(shape, scale);
        case GPHYS_SHAPE_OBB:
            return scale_error<gphys_obb>(shape, scale);
        case GPHYS_SHAPE_PLANE:
            return scale_error<gphys_plane>(shape, scale);
        case GPHYS_SHAPE_TRIANGLE:
            return scale_error<gphys_triangle>(shape, scale);
        default:
            return check_scale(*static_cast<const Mesh*>(shape), scale);
    }
}

gphys_sphere ball_around(const Mesh& mesh, const AxisScale& axes) {
    const Vec3 exact = axes(mesh.center());
    const gphys_vec3 center = narrow(exact);
    return {center, round_up((mesh.radius(axes) + distance(exact, widen(center))) * (1 + 0x1p-50))};
}

}  // namespace gphys

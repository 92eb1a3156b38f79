// Closest point and sphere sweep of a single model, for the collision response of the solver. Other than the scene's
// query, the closest point is on the surface also for a point inside, with a normal and a signed distance (Ericson,
// "Real-Time Collision Detection", 2005, chapter 5).
#include "scene/scene.h"

namespace gphys {
namespace {

struct Contact {
    Vec3 point, normal;
    double signed_distance;
};

/// The normal where the surface has none: arbitrary, but fixed.
constexpr Vec3 some_direction{1, 0, 0};

/// A sphere, or the cross-section of a capsule, around `center`.
Contact contact_of_ball(Vec3 center, double radius, Vec3 normal_at_center, Vec3 point) {
    const Vec3 outward = point - center;
    const double distance = length(outward);
    const Vec3 normal = distance > 0 ? normalized(outward) : normal_at_center;
    return {center + normal * radius, normal, distance - radius};
}

Contact contact_of(const Sphere& sphere, Vec3 point) {
    return contact_of_ball(sphere.center, sphere.radius, some_direction, point);
}

Contact contact_of(const Capsule& capsule, Vec3 point) {
    const Vec3 axis = capsule.b - capsule.a;
    const Vec3 sideways = axis == Vec3{} ? some_direction : perpendicular(normalized(axis));
    return contact_of_ball(closest_point(Segment{capsule.a, capsule.b}, point), capsule.radius, sideways, point);
}

Contact contact_of(const Obb& box, Vec3 point) {
    const Vec3 local = transpose_times(box.axes, point - box.center);
    const Vec3 clamped = min(max(local, -box.half), box.half);
    const double outside = distance(local, clamped);
    if (outside > 0) return {box.center + box.axes * clamped, box.axes * normalized(local - clamped), outside};
    int axis = 0;
    const Vec3 depth = box.half - abs(local);
    for (int k = 1; k < 3; ++k) {
        if (depth[k] < depth[axis]) axis = k;
    }
    Vec3 normal, face = local;
    normal[axis] = local[axis] < 0 ? -1 : 1;
    face[axis] = normal[axis] * box.half[axis];
    return {box.center + box.axes * face, box.axes * normal, -depth[axis]};
}

Contact contact_of(const Aabb& box, Vec3 point) { return contact_of(as_obb(box), point); }

Contact contact_of(const Plane& plane, Vec3 point) {
    const double norm = length(plane.normal);
    const Vec3 unit = normalized(plane.normal);
    const double side = (dot(plane.normal, point) - plane.distance) / norm;
    return {point - unit * side, side < 0 ? -unit : unit, std::fabs(side)};
}

/// At the closest point of a surface. If the point is on the surface, the difference is rounding noise, and the normal
/// is the face's. only_front: of a hull with the point outside, whose face normals point outward.
Contact contact_of_surface(const Triangle& triangle, Vec3 closest, Vec3 point, bool only_front = false) {
    const Vec3 away = point - closest;
    const double distance = length(away);
    // 2^-40 of the coordinates is far above the rounding of the closest point (2^-50) and far below
    // what float32 input can express.
    const double noise = 0x1p-40 * (max_component(abs(point)) + max_component(abs(closest)));
    if (distance > noise) return {closest, normalized(away), distance};
    const Vec3 face = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    if (face == Vec3{}) return {closest, distance > 0 ? normalized(away) : some_direction, distance};
    const Vec3 normal = normalized(face);
    return {closest, !only_front && dot(normal, away) < 0 ? -normal : normal, distance};
}

Contact contact_of(const Triangle& triangle, Vec3 point) {
    return contact_of_surface(triangle, closest_point(triangle, point), point);
}

template <class Primitive>
bool find_contact(const Primitive& shape, Vec3 point, Contact& out) {
    out = contact_of(shape, point);
    return true;
}

/// A hull that contains the point: its nearest face.
Contact contact_within(const MeshInstance& hull, Vec3 point, Vec3 local) {
    Vec3 normal;
    const double depth = hull.mesh.hull().depth(local, normal, hull.axes) * hull.world.scale;
    normal = hull.world.rotation * normal;
    return {point + normal * depth, normal, -depth};
}

bool find_contact(const MeshInstance& instance, Vec3 point, Contact& out) {
    const Vec3 local = instance.world.inverse_apply(point);
    if (instance.mesh.contains(local, instance.axes)) {
        out = contact_within(instance, point, local);
        return true;
    }
    Vec3 closest;
    uint32_t triangle;
    if (!closest_point(instance, point, infinity, closest, triangle, Ties::as_computed)) return false;
    const Triangle nearest = transformed(instance.axes(instance.mesh.triangle(triangle)), instance.world);
    out = contact_of_surface(nearest, closest, point, instance.mesh.is_hull());
    return true;
}

}  // namespace

bool Scene::closest_point_model(gphys_model_id model, Vec3 point, Vec3& out, Vec3& normal,
                                double& signed_distance) const {
    Contact contact;
    if (!with_shape(IdTable::slot_of(model), [&](const auto& shape) { return find_contact(shape, point, contact); }))
        return false;
    out = contact.point;
    normal = contact.normal;
    signed_distance = contact.signed_distance;
    return true;
}

void closest_point_triangle(const Triangle& triangle, Vec3 point, Vec3& out, Vec3& normal, double& distance) {
    const Contact contact = contact_of(triangle, point);
    out = contact.point;
    normal = contact.normal;
    distance = contact.signed_distance;
}

bool Scene::sweep_model(gphys_model_id model, const Sphere& moving, Vec3 displacement, Hit& hit) const {
    return with_shape(IdTable::slot_of(model), [&](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, MeshInstance>) {
            return gphys::sweep(shape, moving, displacement, hit, Ties::as_computed);
        } else {
            return gphys::sweep(shape, moving, displacement, hit);
        }
    });
}

}  // namespace gphys

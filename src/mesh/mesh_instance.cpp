#include "mesh/mesh_instance.h"

namespace gphys {

namespace {

Ray into_mesh(const Ray& ray, const Transform& world) {
    return {world.inverse_apply(ray.origin), world.inverse_apply_to_vector(ray.direction), ray.t_max};
}

void out_of_mesh(Hit& hit, const Transform& world) {
    hit.point = world.apply(hit.point);
    hit.normal = world.rotation * hit.normal;
}

/// Sum of the magnitudes that a coordinate passes through on its way from `local` to the world.
double magnitude(Vec3 local, const Transform& world) {
    return max_component(abs(world.position)) + 3 * world.scale * max_component(abs(local));
}

}  // namespace

Box bounds(const MeshInstance& instance) {
    const Transform& world = instance.world;
    if (instance.mesh.triangle_count() == 0) return bounds(Aabb{world.position, world.position});
    const Box local = instance.mesh.bounds();
    const Obb box = transformed(
        Aabb{{local.min[0], local.min[1], local.min[2]}, {local.max[0], local.max[1], local.max[2]}}, world);
    // bounds(Obb) answers for the rounding of half extents and axes. The centre, and a triangle that
    // is carried over by itself, go through at most 8 roundings of 2^-53 of what they are summed from.
    const double slack =
        0x1p-50 * (magnitude(box.half / world.scale, world) + magnitude(world.inverse_apply(box.center), world));
    return bounds(Obb{box.center, box.half + Vec3{slack, slack, slack}, box.axes});
}

bool raycast(const MeshInstance& instance, const Ray& ray, Hit& hit) {
    if (!instance.mesh.raycast(into_mesh(ray, instance.world), hit)) return false;
    out_of_mesh(hit, instance.world);
    return true;
}

bool raycast_any(const MeshInstance& instance, const Ray& ray) {
    return instance.mesh.raycast_any(into_mesh(ray, instance.world));
}

bool sweep(const MeshInstance& instance, const Sphere& moving, Vec3 displacement, Hit& hit) {
    const Transform& world = instance.world;
    const Sphere local{world.inverse_apply(moving.center), moving.radius / world.scale};
    if (!instance.mesh.sweep(local, world.inverse_apply_to_vector(displacement), hit)) return false;
    out_of_mesh(hit, world);
    return true;
}

bool overlaps(const MeshInstance& instance, const Shape& shape) {
    return instance.mesh.overlaps(inverse_transformed(shape, instance.world));
}

bool closest_point(const MeshInstance& instance, Vec3 point, double max_distance, Vec3& out, uint32_t& triangle) {
    const Transform& world = instance.world;
    const Vec3 local = world.inverse_apply(point);
    // The limit must not lose to rounding a point that lies exactly at it: the way there and back is
    // at most 16 roundings of 2^-53 of the coordinates and of the distance itself.
    const double slack = 0x1p-48 * (magnitude(local, world) + max_distance);
    Vec3 found;
    if (!instance.mesh.closest_point(local, (max_distance + slack) / world.scale, found, triangle)) return false;
    out = world.apply(found);
    return true;
}

}  // namespace gphys

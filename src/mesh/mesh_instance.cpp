// Queries of a placed mesh: transforms to its local space and back, with bounds for the rounding (mesh_instance.h).
#include "mesh/mesh_instance.h"

#include "mesh/closest_search.h"

namespace gphys {
namespace {

/// The ray in local space. A segment stays a segment: its ends are transformed, not its direction.
Ray into_mesh(const Ray& ray, const MeshPlace& place) {
    const Vec3 origin = place.inverse_apply(ray.origin);
    Ray local{origin, {}, ray.t_max};
    if (ray.is_segment) {
        local = ray_along({origin, place.inverse_apply(end_of(ray))});
        local.t_max = ray.t_max;
    } else {
        local.direction = place.inverse_apply_to_vector(ray.direction);
    }
    local.faces = ray.faces;
    return local;
}

void out_of_mesh(Hit& hit, const Transform& world) {
    hit.point = world.apply(hit.point);
    hit.normal = world.rotation * hit.normal;
}

/// A bound for the magnitudes of the intermediate results when `local` is transformed to the world.
double magnitude(Vec3 local, const Transform& world) {
    return max_component(abs(world.position)) + 3 * world.scale * max_component(abs(local));
}

}  // namespace

Box bounds(const MeshInstance& instance) {
    const Transform& world = instance.world;
    if (instance.mesh.triangle_count() == 0) return bounds(Aabb{world.position, world.position});
    const Obb box = transformed(instance.axes(instance.mesh.bounds()), world);
    // bounds(Obb) covers the rounding of half extents and axes. The centre, and a triangle that is transformed by
    // itself, go through at most 8 roundings of 2^-53 of their terms.
    const double slack =
        0x1p-50 * (magnitude(box.half / world.scale, world) + magnitude(world.inverse_apply(box.center), world));
    Box result = bounds(Obb{box.center, box.half + Vec3{slack, slack, slack}, box.axes});
    // The corners of a rotated box can stick out of the mesh's bounding sphere, so the two bounds are intersected.
    const Box sphere = bounds(Sphere{box.center, instance.mesh.radius(instance.axes) * world.scale + slack});
    for (int k = 0; k < 3; ++k) {
        result.min[k] = std::max(result.min[k], sphere.min[k]);
        result.max[k] = std::min(result.max[k], sphere.max[k]);
    }
    return result;
}

bool raycast(const MeshInstance& instance, const Ray& ray, Hit& hit) {
    const MeshPlace place = instance.place();
    const Ray local = into_mesh(ray, place);
    if (!instance.mesh.raycast(local, hit)) return false;
    instance.mesh.carry_out(hit, ray, place);
    return true;
}

namespace {

/// Not inlined: kernels write most hits.
GPHYS_NOINLINE void write_hit(const PlacedMesh& placed, const Ray& ray, const NearestCrossing& nearest,
                              gphys_hit& out) {
    const Transform world = widen(placed.world);
    const AxisScale axes(placed.axes);
    const MeshPlace place{world, axes};
    Hit hit;
    hit_at(nearest, into_mesh(ray, place), hit);
    placed.mesh.carry_out(hit, ray, place);
    out = to_hit(hit);
}

}  // namespace

bool raycast(const PlacedMesh& placed, const Ray& ray, gphys_hit& out) {
    NearestCrossing nearest;
    if (placed.mesh.cross_placed(false, ray, placed.world, placed.axes, nearest, &out)) return true;
    if (nearest.triangle == GPHYS_NO_TRIANGLE) return false;
    write_hit(placed, ray, nearest, out);
    return true;
}

bool raycast_any(const PlacedMesh& placed, const Ray& ray) {
    NearestCrossing nearest;
    placed.mesh.cross_placed(true, ray, placed.world, placed.axes, nearest, nullptr);
    return nearest.triangle != GPHYS_NO_TRIANGLE;
}

bool raycast_distance(const PlacedMesh& placed, const Ray& ray, gphys_distance& out) {
    NearestCrossing nearest;
    placed.mesh.cross_placed(false, ray, placed.world, placed.axes, nearest, nullptr);
    out = {nearest.t, 0, nearest.triangle};
    return nearest.triangle != GPHYS_NO_TRIANGLE;
}

bool may_hit(const MeshInstance& instance, const Ray& ray) {
    const Vec3 to_center = instance.place().apply(instance.mesh.center()) - ray.origin;
    const double radius = instance.mesh.radius(instance.axes) * instance.world.scale, radius_squared = radius * radius;
    if (length_squared(to_center) <= radius_squared) return true;
    const double along = dot(to_center, ray.direction), speed_squared = length_squared(ray.direction);
    // The closest approach lies before the origin, or the ray ends before it could reach the ball.
    if (along <= 0 || along - std::min(ray.t_max, 0x1p600) * speed_squared > radius * std::sqrt(speed_squared))
        return false;
    return length_squared(to_center) * speed_squared - along * along <= radius_squared * speed_squared;
}

bool raycast_any(const MeshInstance& instance, const Ray& ray) {
    const Ray local = into_mesh(ray, instance.place());
    return instance.mesh.raycast_any(local);
}

bool raycast_distance(const MeshInstance& instance, const Ray& ray, gphys_distance& out) {
    const Ray local = into_mesh(ray, instance.place());
    return instance.mesh.raycast_distance(local, out);
}

bool sweep(const MeshInstance& instance, const Sphere& moving, Vec3 displacement, Hit& hit, Ties ties, Faces faces) {
    const Transform& world = instance.world;
    const Sphere local{world.inverse_apply(moving.center), moving.radius / world.scale};
    if (!instance.mesh.sweep(local, world.inverse_apply_to_vector(displacement), hit, ties, instance.axes, faces))
        return false;
    out_of_mesh(hit, world);
    return true;
}

bool sweep(const MeshInstance& instance, const Shape& moving, Vec3 displacement, Hit& hit, Faces faces) {
    const Transform& world = instance.world;
    const Vec3 local = world.inverse_apply_to_vector(displacement);
    if (!instance.mesh.sweep(inverse_transformed(moving, world), local, hit, instance.axes, faces)) return false;
    out_of_mesh(hit, world);
    return true;
}

bool overlaps(const MeshInstance& instance, const Shape& shape) {
    return instance.mesh.overlaps(inverse_transformed(shape, instance.world), instance.axes);
}

bool closest_point(const MeshInstance& instance, Vec3 point, double max_distance, Vec3& out, uint32_t& triangle,
                   Ties ties) {
    const Transform& world = instance.world;
    const Vec3 local = world.inverse_apply(point);
    if (instance.mesh.contains(local, instance.axes)) {
        out = point;
        triangle = GPHYS_NO_TRIANGLE;
        return true;
    }
    // A point exactly at the limit must not be lost to rounding: the transform to local space and back has at most 16
    // roundings of 2^-53 of the coordinates and of the distance.
    const double coordinates = magnitude(local, world);
    const auto within = [&](double distance) { return (distance + 0x1p-48 * (coordinates + distance)) / world.scale; };
    // The distance in the world is what is reported.
    const auto as_reported = [&](Vec3 candidate, double) {
        const double squared = length_squared(world.apply(candidate) - point);
        const bool near = squared <= max_distance * max_distance;
        return near ? reported(std::sqrt(squared)) : std::numeric_limits<float>::infinity();
    };
    const auto limit_of_world = [&](double distance) { return within(limit_of_ties(distance)); };
    const auto as_computed = [](Vec3, double squared) { return squared; };
    const auto limit_of_computed = [](double squared) { return std::sqrt(squared) * (1 + 0x1p-50); };
    const auto find = [&](const auto& distance_of, const auto& limit_of) {
        return instance.mesh.closest_point(local, within(max_distance), distance_of, limit_of, out, triangle,
                                           instance.axes);
    };
    const bool found =
        ties == Ties::as_reported ? find(as_reported, limit_of_world) : find(as_computed, limit_of_computed);
    if (found) out = world.apply(out);
    return found;
}

}  // namespace gphys

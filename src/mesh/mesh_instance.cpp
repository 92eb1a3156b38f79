#include "mesh/mesh_instance.h"

namespace gphys {

namespace {

/// A segment stays one whose ends are where the mesh has its own points.
Ray into_mesh(const Ray& ray, const Transform& world) {
    const Vec3 origin = world.inverse_apply(ray.origin);
    if (!ray.is_segment) return {origin, world.inverse_apply_to_vector(ray.direction), ray.t_max};
    Ray local = ray_along({origin, world.inverse_apply(end_of(ray))});
    local.t_max = ray.t_max;
    return local;
}

/// Whether a ray certainly misses a box: seen along an axis of the box, or across both an axis and the
/// ray, the two are apart (Gottschalk, Lin, Manocha 1996). Takes no division, and no branch that could
/// not be foreseen.
bool misses(const Ray& ray, const Box& box) {
    const Vec3 low{box.min[0], box.min[1], box.min[2]}, high{box.max[0], box.max[1], box.max[2]};
    const Vec3 center = (low + high) * 0.5, half = (high - low) * 0.5;
    const Vec3 from = ray.origin - center, along = ray.direction, speed = abs(along);
    // A distance is off by at most 4 * 2^-53 of this sum, a product of one with the direction by
    // twice that.
    const Vec3 magnitude = abs(ray.origin) + abs(center) + half;
    const double margin = 0x1p-48 * (magnitude.x + magnitude.y + magnitude.z);
    const Vec3 reach = half + Vec3{margin, margin, margin};
    // Infinite times zero would be invalid; later than this nothing is met.
    const double end = std::min(ray.t_max, 0x1p600);
    bool apart = false;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double to_center = along[k] < 0 ? from[k] : -from[k];
        const double near = to_center - reach[k], far = to_center + reach[k], way = end * speed[k];
        const double across = std::fabs(from[i] * along[j] - from[j] * along[i]);
        const double width = reach[i] * speed[j] + reach[j] * speed[i];
        apart |= (far < 0) | (near > way) | (across > width);
    }
    return apart;
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
    Box result = bounds(Obb{box.center, box.half + Vec3{slack, slack, slack}, box.axes});
    // Turned, the corners of a box stick out; what is round stays within its sphere.
    const Box sphere = bounds(Sphere{box.center, instance.mesh.radius() * world.scale + slack});
    for (int k = 0; k < 3; ++k) {
        result.min[k] = std::max(result.min[k], sphere.min[k]);
        result.max[k] = std::min(result.max[k], sphere.max[k]);
    }
    return result;
}

bool raycast(const MeshInstance& instance, const Ray& ray, Hit& hit) {
    const Ray local = into_mesh(ray, instance.world);
    if (misses(local, instance.mesh.bounds()) || !instance.mesh.raycast(local, hit)) return false;
    out_of_mesh(hit, instance.world);
    return true;
}

bool raycast_any(const MeshInstance& instance, const Ray& ray) {
    const Ray local = into_mesh(ray, instance.world);
    return !misses(local, instance.mesh.bounds()) && instance.mesh.raycast_any(local);
}

bool sweep(const MeshInstance& instance, const Sphere& moving, Vec3 displacement, Hit& hit, Ties ties) {
    const Transform& world = instance.world;
    const Sphere local{world.inverse_apply(moving.center), moving.radius / world.scale};
    if (!instance.mesh.sweep(local, world.inverse_apply_to_vector(displacement), hit, ties)) return false;
    out_of_mesh(hit, world);
    return true;
}

bool overlaps(const MeshInstance& instance, const Shape& shape) {
    return instance.mesh.overlaps(inverse_transformed(shape, instance.world));
}

bool closest_point(const MeshInstance& instance, Vec3 point, double max_distance, Vec3& out, uint32_t& triangle,
                   Ties ties) {
    const Transform& world = instance.world;
    const Vec3 local = world.inverse_apply(point);
    // The limit must not lose to rounding a point that lies exactly at it: the way there and back is
    // at most 16 roundings of 2^-53 of the coordinates and of the distance itself.
    const double coordinates = magnitude(local, world);
    const auto within = [&](double distance) { return (distance + 0x1p-48 * (coordinates + distance)) / world.scale; };
    // What is reported is the distance in the world.
    const auto as_reported = [&](Vec3 candidate, double) {
        const double squared = length_squared(world.apply(candidate) - point);
        const bool near = squared <= max_distance * max_distance;
        return near ? reported(std::sqrt(squared)) : std::numeric_limits<float>::infinity();
    };
    const auto limit_of_reported = [&](double distance) { return within(limit_of_ties(distance)); };
    const auto as_computed = [](Vec3, double squared) { return squared; };
    const auto limit_of_computed = [](double squared) { return std::sqrt(squared) * (1 + 0x1p-50); };
    const auto find = [&](const auto& distance_of, const auto& limit_of) {
        return instance.mesh.closest_point(local, within(max_distance), distance_of, limit_of, out, triangle);
    };
    const bool found =
        ties == Ties::as_reported ? find(as_reported, limit_of_reported) : find(as_computed, limit_of_computed);
    if (found) out = world.apply(out);
    return found;
}

}  // namespace gphys

// A mesh with a world transform and a scale for each axis. Queries are transformed to the local space of the mesh,
// unscaled or scaled (mesh_place.h), in double precision, and their results back. t does not change, because the
// direction is transformed with the origin.
#pragma once

#include "mesh/mesh.h"

namespace gphys {

struct MeshInstance {
    const Mesh& mesh;
    const Transform& world;
    AxisScale axes = {};

    MeshPlace place() const { return {world, axes}; }
};

/// A mesh as a model stores it, for rays that kernels transform (Mesh::crosses_placed). `axes` is the scale per axis.
struct PlacedMesh {
    const Mesh& mesh;
    const gphys_transform& world;
    Vec3 axes{1, 1, 1};
};
/// As of a MeshInstance, rounded.
bool raycast(const PlacedMesh& placed, const Ray& ray, gphys_hit& hit);
bool raycast_any(const PlacedMesh& placed, const Ray& ray);
bool raycast_distance(const PlacedMesh& placed, const Ray& ray, gphys_distance& out);

/// The bounds of an empty mesh are its position.
Box bounds(const MeshInstance& instance);
bool raycast(const MeshInstance& instance, const Ray& ray, Hit& hit);
/// For up to Mesh::rays_at_once rays that are no segments, rounded: bit i of the result is set if rays[i] hits, and
/// then *out[i] has the hit.
inline uint64_t raycast_many(const MeshInstance& instance, const Ray* rays, uint32_t count, gphys_hit* const* out) {
    return instance.mesh.raycast_many(rays, count, instance.place(), out);
}
/// Whether a ray comes within the bounding ball of the mesh, up to rounding.
bool may_hit(const MeshInstance& instance, const Ray& ray);
bool raycast_any(const MeshInstance& instance, const Ray& ray);
/// The t and triangle that raycast reports.
bool raycast_distance(const MeshInstance& instance, const Ray& ray, gphys_distance& out);
bool sweep(const MeshInstance& instance, const Sphere& moving, Vec3 displacement, Hit& hit,
           Ties ties = Ties::as_reported, Faces faces = {});
/// For a moving sphere, capsule or box.
bool sweep(const MeshInstance& instance, const Shape& moving, Vec3 displacement, Hit& hit, Faces faces = {});
bool overlaps(const MeshInstance& instance, const Shape& shape);
/// As Mesh::closest_point. False if no point is within max_distance as computed, which may be barely beyond it by
/// rounding.
bool closest_point(const MeshInstance& instance, Vec3 point, double max_distance, Vec3& out, uint32_t& triangle,
                   Ties ties = Ties::as_reported);

/// As Mesh::for_each_penetration.
template <class Visit>
void for_each_penetration(const MeshInstance& instance, const Shape& moving, Visit&& visit) {
    const Transform& world = instance.world;
    const auto carry_out = [&](const Penetration& way, uint32_t triangle) {
        visit(Penetration{way.depth * world.scale, world.rotation * way.normal, world.apply(way.point)}, triangle);
    };
    instance.mesh.for_each_penetration(inverse_transformed(moving, world), carry_out, instance.axes);
}

}  // namespace gphys

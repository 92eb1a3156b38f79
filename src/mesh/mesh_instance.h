// A shared mesh where it stands in the world. Questions are carried into the mesh's own space in
// double precision and their answers back; t needs no conversion, since the direction is carried
// along with the origin.
#pragma once

#include "mesh/mesh.h"

namespace gphys {

struct MeshInstance {
    const Mesh& mesh;
    const Transform& world;
};

/// Of an empty mesh: the point where it stands.
Box bounds(const MeshInstance& instance);
bool raycast(const MeshInstance& instance, const Ray& ray, Hit& hit);
/// Up to Mesh::rays_at_once rays that are no segments: bit i of the result is set if rays[i] hits, as hits[i] tells.
uint64_t raycast_many(const MeshInstance& instance, const Ray* rays, uint32_t count, Hit* hits);
/// Whether a ray comes near a mesh: within the ball around it, but for rounding.
bool comes_near(const MeshInstance& instance, const Ray& ray);
bool raycast_any(const MeshInstance& instance, const Ray& ray);
bool sweep(const MeshInstance& instance, const Sphere& moving, Vec3 displacement, Hit& hit,
           Ties ties = Ties::as_reported);
bool overlaps(const MeshInstance& instance, const Shape& shape);
/// False if no triangle is within max_distance (as computed: or, by rounding, barely beyond it).
bool closest_point(const MeshInstance& instance, Vec3 point, double max_distance, Vec3& out, uint32_t& triangle,
                   Ties ties = Ties::as_reported);

}  // namespace gphys

// Validation of triangle arrays before a mesh is made of them.
#pragma once

#include <cstring>

#include "foundation/memory.h"

namespace gphys {

/// What the triangles of a mesh stand for. Solvers do not collide with meshes that show a body. Snapshots store these
/// numbers.
enum class MeshKind : uint32_t {
    surface = GPHYS_MESH_SURFACE,
    body_surface = GPHYS_MESH_BODY_SURFACE,
    /// For a body: a triangle a, b, b represents the capsule from a to b.
    body_links = GPHYS_MESH_BODY_LINKS,
    /// The surface of a convex solid, made by make_hull (convex_hull.h).
    hull = GPHYS_MESH_HULL
};

/// The caller's arrays: vertex_count vertices `vertex_stride` bytes apart, three indices a triangle.
struct MeshArrays {
    const float* vertices;
    uint32_t vertex_stride;
    uint32_t vertex_count;
    const uint32_t* indices;
    uint32_t index_count;
    MeshKind kind = MeshKind::surface;
    /// One radius for each link. The sign bit marks a link that does not exist.
    const float* radii = nullptr;

    gphys_vec3 vertex(uint32_t i) const {
        gphys_vec3 v;
        std::memcpy(&v, reinterpret_cast<const char*>(vertices) + size_t{i} * vertex_stride, sizeof v);
        return v;
    }
};

/// Counts the triangles of zero area again, for arrays without bad vertices and indices.
void count_degenerate(const MeshArrays& arrays, gphys_mesh_report& report);

/// Throws std::bad_alloc.
gphys_mesh_report examine(const MeshArrays& arrays, std::pmr::memory_resource* memory);

}  // namespace gphys

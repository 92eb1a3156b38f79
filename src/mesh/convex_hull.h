// The convex hull of points, as the vertices and triangles of its surface.
//
// Incremental construction with exact orientation tests, the points that are furthest first (quickhull: Barber, Dobkin,
// Huhdanpaa 1996). Which point is furthest is decided exactly too, so that each point that is taken is a vertex of the
// result, and a hull of its own vertices is the same hull: the form of a snapshot is checked by making it again.
#pragma once

#include "foundation/memory.h"
#include "mesh/mesh_report.h"

namespace gphys {

struct HullSurface {
    explicit HullSurface(std::pmr::memory_resource* memory) : vertices(memory), indices(memory) {}

    Vector<gphys_vec3> vertices;  // in the order of the points
    Vector<uint32_t> indices;     // seen from outside counterclockwise in a right-handed system; face by face
};

constexpr uint32_t most_hull_faces = 256;

enum class HullDefect {
    none,
    flat,  // all points lie in a plane
    too_many_faces
};

/// The points are those of vertices, which are finite; nothing else of the arrays is read. Throws std::bad_alloc.
HullDefect make_hull(const MeshArrays& points, HullSurface& out);

}  // namespace gphys

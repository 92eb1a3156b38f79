// The convex hull of points, as the vertices and triangles of its surface.
//
// Algorithm: quickhull (Barber, Dobkin, Huhdanpaa 1996), that is, incremental construction that adds the farthest point
// first, with exact orientation tests (foundation/exact.h). The farthest point is found exactly, too. So each added
// point is a vertex of the result, and the hull of a hull's own vertices is the same hull. That is how a snapshot is
// validated: the hull is made again and compared.
#pragma once

#include "foundation/memory.h"
#include "mesh/mesh_report.h"

namespace gphys {

struct HullSurface {
    explicit HullSurface(std::pmr::memory_resource* memory) : vertices(memory), indices(memory) {}

    Vector<gphys_vec3> vertices;  // in the order of the points
    Vector<uint32_t> indices;     // counterclockwise seen from outside in a right-handed system; face by face
};

constexpr uint32_t most_hull_faces = 256;

enum class HullDefect {
    none,
    flat,  // all points lie in a plane
    too_many_faces
};

/// Reads the vertices of `points`, which must be finite, and nothing else of the arrays. Throws std::bad_alloc.
HullDefect make_hull(const MeshArrays& points, HullSurface& out);

}  // namespace gphys

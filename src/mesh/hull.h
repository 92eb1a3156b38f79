// Faces and edges of a convex hull, which its triangles do not have by themselves.
#pragma once

#include "foundation/memory.h"
#include "mesh/mesh_place.h"

namespace gphys {

class Hull {
public:
    struct Face {
        Triangle triangle;  // the first of the face, in whose plane all its vertices lie
        Vec3 normal;        // unit, outward
    };
    /// Where two faces meet.
    struct Edge {
        Vec3 a, b;
        uint32_t face[2];
    };

    explicit Hull(std::pmr::memory_resource* memory) : faces_(memory), edges_(memory), face_of_(memory) {}
    /// Of the surface that make_hull writes (convex_hull.h). Throws std::bad_alloc.
    void make(const Vector<gphys_vec3>& vertices, const Vector<uint32_t>& indices);

    const Vector<Face>& faces() const { return faces_; }
    const Vector<Edge>& edges() const { return edges_; }
    /// For each triangle, the number of its face.
    const Vector<uint32_t>& face_of() const { return face_of_; }

    // Of the scaled hull.

    /// Exact. A hull without faces holds nothing.
    bool contains(Vec3 point, const AxisScale& axes) const;
    /// How deep a point is in the hull, and the normal of the face that is nearest.
    double depth(Vec3 point, Vec3& normal, const AxisScale& axes) const;

private:
    Vector<Face> faces_;
    Vector<Edge> edges_;
    Vector<uint32_t> face_of_;
};

}  // namespace gphys

// Faces and edges of a convex hull. Its triangles alone do not have them: coplanar triangles are one face.
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
    /// Shared by two faces.
    struct Edge {
        Vec3 a, b;
        uint32_t face[2];
    };

    explicit Hull(std::pmr::memory_resource* memory) : faces_(memory), edges_(memory), face_of_(memory) {}
    /// From the surface that make_hull writes (convex_hull.h). Throws std::bad_alloc.
    void make(const Vector<gphys_vec3>& vertices, const Vector<uint32_t>& indices);

    const Vector<Face>& faces() const { return faces_; }
    const Vector<Edge>& edges() const { return edges_; }
    /// The number of the face of each triangle.
    const Vector<uint32_t>& face_of() const { return face_of_; }

    // Of the scaled hull:

    /// Decided exactly. A hull without faces contains no point.
    bool contains(Vec3 point, const AxisScale& axes) const;
    /// The depth of a point in the hull, and the normal of the nearest face.
    double depth(Vec3 point, Vec3& normal, const AxisScale& axes) const;

private:
    Vector<Face> faces_;
    Vector<Edge> edges_;
    Vector<uint32_t> face_of_;
};

}  // namespace gphys

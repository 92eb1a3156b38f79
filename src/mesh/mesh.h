// A triangle surface with its own tree. Immutable once made, so that models, scenes and threads can
// share one; the last to let go destroys it.
//
// All queries are in the mesh's own coordinates and agree with asking each triangle in turn: the
// tree only leaves out triangles that cannot matter (box8.h). Equal results go to the lower index.
#pragma once

#include <atomic>

#include "intersect/intersect.h"
#include "mesh/mesh_report.h"
#include "octree/octree.h"

namespace gphys {

class Mesh {
public:
    /// `report` is that of the arrays and finds no bad vertex and no index out of range.
    Mesh(const gphys_allocator* hooks, const MeshArrays& arrays, const gphys_mesh_report& report);

    void retain() const noexcept { holds_.fetch_add(1, std::memory_order_relaxed); }
    static void release(const Mesh* mesh) noexcept;

    uint32_t triangle_count() const { return report_.triangle_count; }
    Triangle triangle(uint32_t index) const {
        const uint32_t* corner = indices_.data() + size_t{3} * index;
        return {widen(vertices_[corner[0]]), widen(vertices_[corner[1]]), widen(vertices_[corner[2]])};
    }
    const Vector<gphys_vec3>& vertices() const { return vertices_; }
    const Vector<uint32_t>& indices() const { return indices_; }
    const gphys_mesh_report& report() const { return report_; }
    /// Empty without triangles.
    Box bounds() const { return octree_.bounds(); }
    const Octree& octree() const { return octree_; }

    bool raycast(const Ray& ray, Hit& hit) const;
    bool raycast_any(const Ray& ray) const;
    /// Every triangle that the ray hits, in no particular order: visit(const Hit&).
    template <class Visit>
    void raycast_all(const Ray& ray, Visit&& visit) const;
    /// False if no triangle is within max_distance.
    bool closest_point(Vec3 point, double max_distance, Vec3& out, uint32_t& triangle) const;
    bool sweep(const Sphere& moving, Vec3 displacement, Hit& hit) const;
    bool overlaps(const Shape& shape) const;
    bool overlaps(const Mesh& other) const;
    /// Every triangle that shares a point with the shape: visit(triangle) returns whether to go on.
    template <class Visit>
    void for_each_overlap(const Shape& shape, Visit&& visit) const;

    Memory memory;

private:
    template <class Visit>
    void for_each_overlap_of(const Plane& plane, Visit&& visit) const;
    template <class Visit>
    void for_each_overlap_of(const Frustum& frustum, Visit&& visit) const;
    template <class Bounded, class Visit>
    void for_each_overlap_of(const Bounded& shape, Visit&& visit) const;

    mutable std::atomic<uint32_t> holds_{1};
    gphys_mesh_report report_;
    Vector<gphys_vec3> vertices_{&memory};
    Vector<uint32_t> indices_{&memory};
    Octree octree_{&memory};
};

/// A ray against one triangle after the other. What it is asked for is always the ray as given:
/// comparing hits, not cutting the ray short, is what makes the answer independent of their order.
class MeshRay {
public:
    explicit MeshRay(const Ray& ray) : ray_(ray), sheared_(ray), still_(ray.direction == Vec3{}) {}

    bool hits(const Mesh& mesh, uint32_t triangle, Hit& hit) const {
        const Triangle corners = mesh.triangle(triangle);
        if (!(still_ ? gphys::raycast(corners, ray_, hit) : gphys::raycast(corners, sheared_, hit))) return false;
        hit.triangle = triangle;
        return true;
    }

private:
    Ray ray_;
    ShearedRay sheared_;
    bool still_;
};

template <class Visit>
void Mesh::raycast_all(const Ray& ray, Visit&& visit) const {
    const MeshRay mesh_ray(ray);
    octree_.raycast(ray, [&](uint32_t triangle, double&) {
        Hit hit;
        if (mesh_ray.hits(*this, triangle, hit)) visit(hit);
    });
}

template <class Visit>
void Mesh::for_each_overlap(const Shape& shape, Visit&& visit) const {
    std::visit([&](const auto& s) { for_each_overlap_of(s, visit); }, shape);
}

template <class Bounded, class Visit>
void Mesh::for_each_overlap_of(const Bounded& shape, Visit&& visit) const {
    octree_.overlap_box(gphys::bounds(shape),
                        [&](uint32_t index) { return !gphys::overlaps(shape, triangle(index)) || visit(index); });
}

template <class Visit>
void Mesh::for_each_overlap_of(const Plane& plane, Visit&& visit) const {
    const auto touches = [&](const Box& box) {
        const Aabb exact{{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}};
        return gphys::overlaps(exact, plane);
    };
    octree_.overlap(touches, [&](uint32_t index) { return !gphys::overlaps(plane, triangle(index)) || visit(index); });
}

template <class Visit>
void Mesh::for_each_overlap_of(const Frustum& frustum, Visit&& visit) const {
    octree_.frustum(frustum, [&](uint32_t index, bool wholly_inside) {
        return !(wholly_inside || gphys::overlaps(frustum, triangle(index))) || visit(index);
    });
}

}  // namespace gphys

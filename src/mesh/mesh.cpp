#include "mesh/mesh.h"

namespace gphys {

namespace {

bool earlier(const Hit& a, const Hit& b) { return a.t < b.t || (a.t == b.t && a.triangle < b.triangle); }

}  // namespace

Mesh::Mesh(const gphys_allocator* hooks, const MeshArrays& arrays, const gphys_mesh_report& report)
    : memory(hooks), report_(report) {
    vertices_.reserve(arrays.vertex_count);
    for (uint32_t i = 0; i < arrays.vertex_count; ++i) vertices_.push_back(arrays.vertex(i));
    if (arrays.index_count > 0) indices_.assign(arrays.indices, arrays.indices + arrays.index_count);

    Vector<Box> boxes(&memory);
    Vector<uint32_t> triangles(&memory);
    boxes.reserve(report.triangle_count);
    triangles.reserve(report.triangle_count);
    for (uint32_t i = 0; i < report.triangle_count; ++i) {
        boxes.push_back(gphys::bounds(triangle(i)));
        triangles.push_back(i);
    }
    octree_.build(boxes.data(), triangles.data(), report.triangle_count);
}

void Mesh::release(const Mesh* mesh) noexcept {
    // Acquire: the destroyer sees all that others did before they let go.
    if (mesh->holds_.fetch_sub(1, std::memory_order_acq_rel) == 1) destroy(const_cast<Mesh*>(mesh));
}

bool Mesh::raycast(const Ray& ray, Hit& hit) const {
    const MeshRay mesh_ray(ray);
    Hit first;
    octree_.raycast(ray, [&](uint32_t triangle, double& t_max) {
        Hit candidate;
        if (mesh_ray.hits(*this, triangle, candidate) && earlier(candidate, first)) {
            first = candidate;
            t_max = first.t;
        }
    });
    if (first.triangle == GPHYS_NO_TRIANGLE) return false;
    hit = first;
    return true;
}

bool Mesh::raycast_any(const Ray& ray) const {
    const MeshRay mesh_ray(ray);
    bool found = false;
    octree_.raycast(ray, [&](uint32_t triangle, double& t_max) {
        Hit hit;
        if (!mesh_ray.hits(*this, triangle, hit)) return;
        found = true;
        t_max = -1;
    });
    return found;
}

bool Mesh::closest_point(Vec3 point, double max_distance, Vec3& out, uint32_t& triangle) const {
    double least = max_distance * max_distance;
    uint32_t nearest = GPHYS_NO_TRIANGLE;
    Vec3 nearest_point;
    octree_.nearest(point, max_distance, [&](uint32_t index, double& bound) {
        const Vec3 candidate = gphys::closest_point(this->triangle(index), point);
        const double squared = length_squared(candidate - point);
        if (squared < least || (squared == least && index < nearest)) {
            least = squared;
            nearest = index;
            nearest_point = candidate;
            bound = std::sqrt(least);
        }
    });
    if (nearest == GPHYS_NO_TRIANGLE) return false;
    out = nearest_point;
    triangle = nearest;
    return true;
}

bool Mesh::sweep(const Sphere& moving, Vec3 displacement, Hit& hit) const {
    Hit first;
    octree_.sweep(moving.center, displacement, moving.radius, [&](uint32_t index, double& t_max) {
        Hit candidate;
        if (!gphys::sweep(triangle(index), moving, displacement, candidate)) return;
        candidate.triangle = index;
        if (earlier(candidate, first)) {
            first = candidate;
            t_max = first.t;
        }
    });
    if (first.triangle == GPHYS_NO_TRIANGLE) return false;
    hit = first;
    return true;
}

bool Mesh::overlaps(const Shape& shape) const {
    bool found = false;
    for_each_overlap(shape, [&](uint32_t) {
        found = true;
        return false;
    });
    return found;
}

bool Mesh::overlaps(const Mesh& other) const {
    return !octree_.overlap_pairs(other.octree_, [&](uint32_t mine, uint32_t theirs) {
        return !gphys::overlaps(triangle(mine), other.triangle(theirs));
    });
}

}  // namespace gphys

// What a mesh is made of, to ask its triangles one by one.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "check.h"
#include "program.h"

namespace fuzz {

struct DestroyMesh {
    void operator()(gphys_mesh* mesh) const { gphys_mesh_destroy(mesh); }
};
using MeshHandle = std::unique_ptr<gphys_mesh, DestroyMesh>;

class MeshSource {
public:
    MeshSource(std::vector<gphys_vec3> vertices, std::vector<uint32_t> indices)
        : vertices_(std::move(vertices)), indices_(std::move(indices)) {}

    const std::vector<gphys_vec3>& vertices() const { return vertices_; }
    const std::vector<uint32_t>& indices() const { return indices_; }
    uint32_t triangles() const { return static_cast<uint32_t>(indices_.size() / 3); }
    gphys_triangle triangle(uint32_t i) const {
        return {vertices_[indices_[3 * i]], vertices_[indices_[3 * i + 1]], vertices_[indices_[3 * i + 2]]};
    }

    MeshHandle create() const {
        gphys_mesh* mesh = nullptr;
        call(gphys_mesh_create, nullptr, vertices_.empty() ? nullptr : &vertices_[0].x,
             static_cast<uint32_t>(sizeof(gphys_vec3)), static_cast<uint32_t>(vertices_.size()), indices_.data(),
             static_cast<uint32_t>(indices_.size()), &mesh);
        return MeshHandle(mesh);
    }

    /// All hits of a ray, by t, then triangle.
    std::vector<gphys_hit> hits(const gphys_ray& ray) const {
        std::vector<gphys_hit> found;
        for (uint32_t i = 0; i < triangles(); ++i) {
            const gphys_triangle t = triangle(i);
            gphys_hit hit;
            if (call(gphys_shape_raycast, gphys_shape_type{GPHYS_SHAPE_TRIANGLE}, &t, &ray, &hit) != GPHYS_OK) continue;
            hit.triangle = i;
            found.push_back(hit);
        }
        std::stable_sort(found.begin(), found.end(), [](const gphys_hit& a, const gphys_hit& b) { return a.t < b.t; });
        return found;
    }

private:
    std::vector<gphys_vec3> vertices_;
    std::vector<uint32_t> indices_;
};

}  // namespace fuzz

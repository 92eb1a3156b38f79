// Closed surfaces as cloth.
#pragma once

#include <map>

#include "solver_world.h"

namespace test {

struct Surface {
    std::vector<gphys_vec3> vertices;
    std::vector<uint32_t> indices;
};

/// A regular icosahedron of radius 1, each triangle split into four `splits` times.
inline Surface icosphere(int splits) {
    const double phi = (1 + std::sqrt(5.0)) / 2;
    std::vector<gphys::Vec3> at;
    for (const double s : {-1.0, 1.0}) {
        for (const double t : {-phi, phi}) {
            at.push_back(normalized(gphys::Vec3{0, s, t}));
            at.push_back(normalized(gphys::Vec3{s, t, 0}));
            at.push_back(normalized(gphys::Vec3{t, 0, s}));
        }
    }
    std::vector<uint32_t> triangles;
    // Its faces are the triples of nearest neighbours, turned outward.
    const double side = 2 / std::sqrt(1 + phi * phi) * 1.001;
    for (uint32_t a = 0; a < 12; ++a) {
        for (uint32_t b = a + 1; b < 12; ++b) {
            for (uint32_t c = b + 1; c < 12; ++c) {
                if (distance(at[a], at[b]) > side || distance(at[b], at[c]) > side || distance(at[c], at[a]) > side) {
                    continue;
                }
                const bool outward = dot(at[a], cross(at[b], at[c])) > 0;
                triangles.insert(triangles.end(), {a, outward ? b : c, outward ? c : b});
            }
        }
    }
    for (int split = 0; split < splits; ++split) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [entry, added] = middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(at.size()));
            if (added) at.push_back(normalized(at[a] + at[b]));
            return entry->second;
        };
        std::vector<uint32_t> finer;
        for (size_t i = 0; i < triangles.size(); i += 3) {
            const uint32_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
            const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        triangles = finer;
    }
    Surface out;
    for (const gphys::Vec3& v : at) out.vertices.push_back(gphys::narrow(v));
    out.indices = triangles;
    return out;
}

inline gphys_body_id add(World& world, const Surface& surface, const gphys_body_desc& desc, float height) {
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, &surface.vertices[0].x, 12, static_cast<uint32_t>(surface.vertices.size()),
                              surface.indices.data(), static_cast<uint32_t>(surface.indices.size()),
                              &mesh) == GPHYS_OK);
    gphys_transform transform{};
    transform.position = {0, height, 0};
    transform.rotation.w = 1;
    transform.scale = 1;
    gphys_body_id body = 0;
    REQUIRE(gphys_solver_add_cloth_mesh(world.solver, &desc, mesh, &transform, &body) == GPHYS_OK);
    gphys_mesh_destroy(mesh);
    return body;
}

}  // namespace test

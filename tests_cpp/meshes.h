// Triangle meshes for tests: closed and open ones, made of formulas or of chance.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "test.h"

namespace test {

struct Arrays {
    std::vector<gphys_vec3> vertices;
    std::vector<uint32_t> indices;

    void add(uint32_t a, uint32_t b, uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
    gphys::MeshArrays view() const {
        return {reinterpret_cast<const float*>(vertices.data()), sizeof(gphys_vec3),
                static_cast<uint32_t>(vertices.size()), indices.data(), static_cast<uint32_t>(indices.size())};
    }
    gphys::Mesh* make(const gphys_allocator* hooks = nullptr, gphys::Isa isa = gphys::chosen_isa()) const {
        gphys::Memory memory(hooks);
        return gphys::create<gphys::Mesh>(hooks, view(), gphys::examine(view(), &memory), isa);
    }
    /// x -> offset + scale * x for each axis.
    Arrays placed(gphys::Vec3 offset, gphys::Vec3 scale) const {
        Arrays result = *this;
        for (gphys_vec3& v : result.vertices) {
            v = gphys::narrow(
                gphys::Vec3{offset.x + scale.x * v.x, offset.y + scale.y * v.y, offset.z + scale.z * v.z});
        }
        return result;
    }
};

/// The instruction sets that this processor has.
inline std::vector<gphys::Isa> isas() {
    std::vector<gphys::Isa> all;
#define GPHYS_TEST_ISA(set, ...) \
    if (gphys::has(gphys::Isa::set)) all.push_back(gphys::Isa::set);
    GPHYS_FOR_EACH_ISA(GPHYS_TEST_ISA, )
#undef GPHYS_TEST_ISA
    return all;
}

/// The unit sphere: an octahedron whose faces are cut in four `levels` times.
inline Arrays sphere(int levels) {
    Arrays mesh;
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (uint32_t x : {0u, 1u}) {
        for (uint32_t y : {2u, 3u}) {
            for (uint32_t z : {4u, 5u}) {
                (x + y + z) % 2 == 0 ? mesh.add(x, y, z) : mesh.add(y, x, z);
            }
        }
    }
    for (; levels > 0; --levels) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto found = middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(mesh.vertices.size()));
            if (found.second) {
                const gphys::Vec3 sum = gphys::widen(mesh.vertices[a]) + gphys::widen(mesh.vertices[b]);
                mesh.vertices.push_back(gphys::narrow(gphys::normalized(sum)));
            }
            return found.first->second;
        };
        const std::vector<uint32_t> old = std::move(mesh.indices);
        mesh.indices.clear();
        for (size_t i = 0; i < old.size(); i += 3) {
            const uint32_t a = old[i], b = old[i + 1], c = old[i + 2];
            const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            mesh.add(a, ab, ca);
            mesh.add(b, bc, ab);
            mesh.add(c, ca, bc);
            mesh.add(ab, bc, ca);
        }
    }
    return mesh;
}

/// About the z axis, `major` times `minor` quads.
inline Arrays torus(uint32_t major, uint32_t minor) {
    Arrays mesh;
    for (uint32_t i = 0; i < major; ++i) {
        for (uint32_t j = 0; j < minor; ++j) {
            const double u = 2 * gphys::pi * i / major, v = 2 * gphys::pi * j / minor;
            const double r = 1 + 0.4 * std::cos(v);
            mesh.vertices.push_back(gphys::narrow(gphys::Vec3{r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)}));
            const uint32_t i2 = (i + 1) % major, j2 = (j + 1) % minor;
            mesh.add(i * minor + j, i2 * minor + j, i2 * minor + j2);
            mesh.add(i * minor + j, i2 * minor + j2, i * minor + j2);
        }
    }
    return mesh;
}

/// A flat grid in the plane z = 0 with whole-numbered corners: many triangles share each edge's plane.
inline Arrays grid(uint32_t cells) {
    Arrays mesh;
    for (uint32_t y = 0; y <= cells; ++y) {
        for (uint32_t x = 0; x <= cells; ++x)
            mesh.vertices.push_back({static_cast<float>(x), static_cast<float>(y), 0});
    }
    for (uint32_t y = 0; y < cells; ++y) {
        for (uint32_t x = 0; x < cells; ++x) {
            const uint32_t corner = y * (cells + 1) + x;
            mesh.add(corner, corner + 1, corner + cells + 2);
            mesh.add(corner, corner + cells + 2, corner + cells + 1);
        }
    }
    return mesh;
}

/// Unrelated triangles, every fifth of them degenerate, some of them twice.
inline Arrays soup(uint32_t count, uint64_t seed) {
    Random random(seed);
    Arrays mesh;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t first = static_cast<uint32_t>(mesh.vertices.size());
        const gphys_vec3 a = random.point(1);
        mesh.vertices.push_back(a);
        for (int k = 0; k < 2; ++k) {
            const gphys_vec3 offset = random.point(0.2f);
            mesh.vertices.push_back({a.x + offset.x, a.y + offset.y, a.z + offset.z});
        }
        mesh.add(first, first + 1, i % 5 == 0 ? first + i % 2 : first + 2);
        if (i % 7 == 0) mesh.add(first + 1, first + 2, first);
    }
    return mesh;
}

}  // namespace test

// What is far from a body changes nothing of its motion, however large the box around it: a plane, a slab that is
// turned, a terrain with a valley in which the body hangs.
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "solver_world.h"

namespace {

enum class Far { nothing, plane, slab, valley, count };

struct FarModel {
    FarModel(test::World& world, Far far) {
        if (far == Far::plane) {
            const gphys_plane ground{{0, 1, 0}, -100};
            world.model(GPHYS_SHAPE_PLANE, &ground);
        } else if (far == Far::slab) {
            // The world box holds the bodies; the surface is 110 m away.
            const gphys_obb slab{{80, -80, 0}, {1000, 1, 1000}, {0, 0, std::sin(0.3926991f), std::cos(0.3926991f)}};
            world.model(GPHYS_SHAPE_OBB, &slab);
        } else if (far == Far::valley) {
            make_valley();
            world.model(GPHYS_SHAPE_MESH, mesh);
        }
        if (far != Far::slab && far != Far::valley) return;
        gphys_aabb around;
        REQUIRE(gphys_scene_get_scene_bounds(world.scene, &around) == GPHYS_OK);
        REQUIRE((around.min.y < -10 && around.max.y > 10));
    }
    FarModel(const FarModel&) = delete;
    ~FarModel() { gphys_mesh_destroy(mesh); }

    /// A bowl 100 m deep.
    void make_valley() {
        constexpr uint32_t n = 32;
        std::vector<gphys_vec3> vertices;
        std::vector<uint32_t> indices;
        for (uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
            const float x = (static_cast<float>(i % (n + 1)) - n / 2) * 16;
            const float z = (static_cast<float>(i / (n + 1)) - n / 2) * 16;
            const float r = std::sqrt(x * x + z * z);
            vertices.push_back({x, r < 60 ? -100 : 2 * (r - 60) - 100, z});
        }
        for (uint32_t i = 0; i < n * (n + 1); ++i) {
            if (i % (n + 1) == n) continue;
            indices.insert(indices.end(), {i, i + n + 1, i + 1, i + 1, i + n + 1, i + n + 2});
        }
        REQUIRE(gphys_mesh_create(nullptr, &vertices[0].x, sizeof vertices[0], static_cast<uint32_t>(vertices.size()),
                                  indices.data(), static_cast<uint32_t>(indices.size()), &mesh) == GPHYS_OK);
    }

    gphys_mesh* mesh = nullptr;
};

/// Positions after half a second of a rope, a cloth and free particles that meet nothing.
std::vector<gphys_vec3> motion(Far far) {
    test::World world;
    FarModel model(world, far);
    std::vector<gphys_vec3> row(30), all;
    for (int i = 0; i < 30; ++i) row[static_cast<size_t>(i)] = {0.05f * static_cast<float>(i), 0, 0};
    const gphys_body_id rope = world.rope(row, 0), cloth = world.cloth({0, 0, 2}, {1, 0, 0}, {0, 0, 1}, 8, 8);
    world.pin(rope, 0);
    world.pin(cloth, 0);
    for (gphys_vec3& point : row) point.z = -2;
    const gphys_body_id particles = world.particles(row);
    for (int frame = 0; frame < 30; ++frame) world.step(1 / 60.f);
    for (const auto& [body, count] : {std::pair(rope, 30u), {cloth, 64u}, {particles, 30u}}) {
        std::vector<gphys_vec3> positions(count);
        REQUIRE(gphys_solver_get_positions(world.solver, body, 0, count, positions.data(), 12) == GPHYS_OK);
        all.insert(all.end(), positions.begin(), positions.end());
    }
    return all;
}

}  // namespace

TEST_CASE("models that are far away leave the motion of bodies as it is in empty space, bit for bit") {
    const std::vector<gphys_vec3> alone = motion(Far::nothing);
    for (int far = 1; far < static_cast<int>(Far::count); ++far) {
        INFO("far model of kind " << far);
        const std::vector<gphys_vec3> found = motion(static_cast<Far>(far));
        REQUIRE(found.size() == alone.size());
        CHECK(std::memcmp(found.data(), alone.data(), alone.size() * sizeof alone[0]) == 0);
    }
}

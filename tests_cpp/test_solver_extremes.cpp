// Input that is valid but extreme: a status, or a motion of finite numbers.
#include "solver_world.h"

using gphys::Vec3;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;

/// The largest coordinate of any particle.
double farthest(const World& world, gphys_body_id body) {
    const std::vector<gphys_vec3> at = world.positions(body);
    REQUIRE(test::all_finite(at));
    REQUIRE(test::all_finite(world.velocities(body)));
    double most = 0;
    for (const gphys_vec3& p : at) most = std::max(most, max_component(abs(gphys::widen(p))));
    return most;
}

constexpr float tiny[] = {1e-45f, 1e-41f, 1e-38f, 1e-30f, 1e-24f, 1e-20f, 1e-18f, 1e-15f, 1e-12f, 1e-9f, 1e-6f};

}  // namespace

TEST_CASE("ropes of very short links stay where they are held, or fall") {
    // Beside others or alone, at rest or with links far longer than they shall be: how short is no matter.
    for (const float link : tiny) {
        for (const float spacing : {0.0f, 1e-24f, 1e-6f, 0.1f}) {
            for (const uint32_t count : {2u, 3u, 9u}) {
                for (const uint32_t pins : {0u, 1u, 2u}) {
                    for (const uint32_t ropes : {1u, 8u}) {
                        World world;
                        gphys_body_id rope = 0;
                        for (uint32_t i = 0; i < ropes; ++i) {
                            rope = world.rope(test::line({0, 0, 0}, {0, -spacing, 0}, count), link);
                            if (pins > 0) world.pin(rope, 0);
                            if (pins > 1) world.pin(rope, count - 1);
                        }
                        double most = 0;
                        for (int step = 0; step < 10; ++step) {
                            world.step(dt);
                            most = std::max(most, farthest(world, rope));
                        }
                        // A fall of a sixth of a second is 0.14 m, and no particle leaves the rope. What pulls itself
                        // together swings by no more than its length.
                        INFO("link " << link << ", spacing " << spacing << ", " << count << " particles, " << pins
                                     << " pins, " << ropes << " ropes");
                        const double length = static_cast<double>(spacing) * (count - 1);
                        CHECK(most <= length * 1.001 + (pins > 0 ? 1e-2 * (count - 1) * 0.01 : 0.15));
                    }
                }
            }
        }
    }
}

TEST_CASE("joints at hardly any distance are joints at none") {
    for (const float rest : tiny) {
        World world;
        const gphys_body_id a = world.rope(test::line({0, 0, 0}, {0.1f, 0, 0}, 5), 0);
        const gphys_body_id b = world.rope(test::line({0.4f, 0, 0}, {0.1f, 0, 0}, 5), 0);
        world.pin(a, 0);
        gphys_joint_id joint;
        REQUIRE(gphys_solver_join(world.solver, a, 4, b, 0, rest, 0, &joint) == GPHYS_OK);
        for (int step = 0; step < 60; ++step) world.step(dt);
        INFO("rest " << rest);
        CHECK(farthest(world, b) < 0.81);
        CHECK(distance(world.position(a, 4), world.position(b, 0)) < 2e-6);
    }
}

TEST_CASE("a sheet without area is refused") {
    World world;
    const gphys_vec3 corner{1, 2, 3};
    const std::pair<gphys_vec3, gphys_vec3> edges[] = {{{1, 0, 0}, {2, 0, 0}},
                                                       {{1, 0, 0}, {-1, 0, 0}},
                                                       {{1, 0, 0}, {0, 0, 0}},
                                                       {{0, 0, 0}, {0, 0, 0}},
                                                       {{0.3f, 0.1f, -0.7f}, {0.6f, 0.2f, -1.4f}},
                                                       {{1e-40f, 0, 0}, {3, 0, 0}}};
    for (const auto& [u, v] : edges) {
        for (const uint32_t n : {2u, 7u}) {
            gphys_body_id body = 77;
            CHECK(gphys_solver_add_cloth(world.solver, nullptr, &corner, &u, &v, n, n, &body) ==
                  GPHYS_ERROR_INVALID_ARGUMENT);
            CHECK(body == 77);
        }
    }
    uint32_t total = 1;
    REQUIRE(gphys_solver_get_bodies(world.solver, nullptr, 0, &total) >= GPHYS_OK);
    CHECK(total == 0);
}

TEST_CASE("sheets of hardly any area or size stay where they are held") {
    for (const float size : {1e-45f, 1e-40f, 1e-36f, 1e-25f, 1e-19f, 1e-18f, 1e-15f, 1e-9f, 1e-4f, 1.0f}) {
        for (const float slant : {1.0f, 1e-3f, 1e-7f}) {
            for (const uint32_t n : {2u, 3u, 11u}) {
                const gphys_vec3 corner{0, 0, 0}, u{size, 0, 0};
                for (const gphys_vec3 v :
                     {gphys_vec3{size, slant * size, 0}, gphys_vec3{-size, 0, slant * size}, gphys_vec3{0, slant, 0}}) {
                    World world;
                    gphys_body_id body;
                    const gphys_status status =
                        gphys_solver_add_cloth(world.solver, nullptr, &corner, &u, &v, n, n, &body);
                    if (status == GPHYS_ERROR_INVALID_ARGUMENT) continue;  // slant * size is 0
                    world.pin(body, 0);
                    double most = 0;
                    for (int step = 0; step < 60; ++step) {
                        world.step(dt);
                        most = std::max(most, farthest(world, body));
                    }
                    INFO("size " << size << ", slant " << slant << ", " << n << " particles a side");
                    const double reach = static_cast<double>(size) + length(gphys::widen(v));
                    CHECK(most <= 2 * reach + 1e-15);
                }
            }
        }
    }
}

TEST_CASE("meshes with triangles of no area make calm cloth") {
    // Needles, points, corners at one place that stay separate, and an edge that is used five times.
    const std::vector<std::pair<std::vector<float>, std::vector<uint32_t>>> meshes = {
        {{0, 0, 0, 1, 0, 0, 2, 0, 0}, {0, 1, 2}},
        {{0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 2}},
        {{0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0}, {0, 1, 2, 2, 1, 3}},
        {{0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {0, 1, 2, 2, 3, 4, 4, 5, 0}},
        {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 1, 1, 1}, {0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5, 1, 0, 5}},
        {{0, 0, 0, 1, 0, 0, 1, 0, 0}, {0, 1, 2, 1, 2, 0, 1, 1, 2}},
        {{0, 0, 0, 1e-30f, 0, 0, 0, 1e-30f, 0, 1e-30f, 1e-30f, 0}, {0, 1, 2, 2, 1, 3}},
    };
    for (size_t i = 0; i < meshes.size(); ++i) {
        for (const bool pinned : {false, true}) {
            World world;
            const test::MeshHandle mesh(meshes[i].first, meshes[i].second);
            gphys_body_id body;
            REQUIRE(gphys_solver_add_cloth_mesh(world.solver, nullptr, mesh.mesh, nullptr, &body) == GPHYS_OK);
            if (pinned) world.pin(body, 0);
            const double before = world.energy(body);
            double most = 0;
            for (int step = 0; step < 60; ++step) {
                world.step(dt);
                most = std::max(most, farthest(world, body));
            }
            INFO("mesh " << i << (pinned ? ", pinned" : ""));
            // A second of falling, or the edges that lead to the pin.
            CHECK(most <= (pinned ? 3 : 6.0));
            CHECK(world.energy(body) <= before + 1e-3);
        }
    }
}

// Crates and planks on what is much lighter and lies on a floor.
#include <algorithm>
#include <cmath>

#include "solver_world.h"

using namespace test;

namespace {

constexpr float frame = 1.0f / 60;

struct OnPebbles {
    double above_start = 0, rise = 0;  // J per kg of the cluster, and metres
};

/// A rigid box of spheres slides over pebbles on a floor for a second.
OnPebbles slide(uint32_t substeps, uint32_t nx, uint32_t ny, uint32_t nz, Random& random) {
    const auto any_of = [&](std::initializer_list<float> of) {
        return of.begin()[random.index(static_cast<uint32_t>(of.size()))];
    };
    constexpr float radius = 0.05f;
    const float mass = any_of({1, 4, 16, 50}), pebble = any_of({1e-4f, 1e-3f, 1e-2f}),
                small = any_of({0.005f, 0.01f, 0.02f}), speed = any_of({0, 0.3f, 1, 3});
    World world(substeps);
    const gphys_plane floor = {{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    std::vector<gphys_vec3> pebbles, box;
    for (int i = 0; i < 42; ++i) {
        const auto at = [&](int k) {
            return 0.08f * (static_cast<float>(k) - 3) + small * random.uniform_float(-1, 1);
        };
        const float x = at(i % 7), z = at(i / 7);  // in this order
        pebbles.push_back({x, small, z});
    }
    world.particles(pebbles, colliding(42 * pebble, small));
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i < nx * ny * nz; ++i) {
        const auto at = [](uint32_t k, uint32_t n) {
            return 2 * radius * (static_cast<float>(k) - static_cast<float>(n - 1) / 2);
        };
        const float up = radius + 2 * small + 0.001f;
        box.push_back({at(i % nx, nx), up + 2 * radius * static_cast<float>(i / nx % ny), at(i / nx / ny, nz)});
        all.push_back(i);
    }
    const gphys_body_id body = world.particles(box, colliding(mass, radius));
    gphys_cluster_id cluster = 0;
    REQUIRE(gphys_solver_add_cluster(world.solver, body, all.data(), static_cast<uint32_t>(all.size()), &cluster) ==
            GPHYS_OK);
    for (const uint32_t i : all) world.set_velocity(body, i, {speed, 0, 0});
    const auto mean_height = [&] {
        double sum = 0;
        for (const gphys_vec3& at : world.positions(body)) sum += static_cast<double>(at.y);
        return sum / static_cast<double>(all.size());
    };
    OnPebbles out;
    const double height = mean_height(), energy = world.energy();
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        out.above_start = std::max(out.above_start, (world.energy() - energy) / static_cast<double>(mass));
        out.rise = std::max(out.rise, mean_height() - height);
    }
    return out;
}

}  // namespace

TEST_CASE("Crates and planks that slide over pebbles on a floor gain no energy") {
    const uint32_t substeps = GENERATE(8u, 2u, 1u);
    Random random(substeps);
    OnPebbles worst;
    for (int i = 0; i < tries(24); ++i) {
        const OnPebbles plank = slide(substeps, 8, 1, 3, random), crate = slide(substeps, 3, 3, 3, random);
        for (const OnPebbles& one : {plank, crate}) {
            worst.above_start = std::max(worst.above_start, one.above_start);
            worst.rise = std::max(worst.rise, one.rise);
        }
    }
    figure("energy above that at the start", worst.above_start, "J/kg");
    figure("rise", worst.rise, "m");
    CHECK(worst.above_start < 0.05);
    CHECK(worst.rise < 0.05);
}

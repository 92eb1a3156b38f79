// Ropes that are placed with links of wrong lengths get these in their first step, and no speed by it.
#include <algorithm>
#include <cmath>

#include "solver_world.h"

using test::figure;
using test::World;

namespace {

constexpr float frame = 1.0f / 60;
constexpr uint32_t points = 61;

/// Along x, 0.1 m from point to point, with links longer than that by a part of it.
gphys_body_id placed(World& world, double longer, int pins, const gphys_body_desc& desc = World::body_desc()) {
    const gphys_body_id rope =
        world.rope(test::line({0, 0, 0}, {0.1f, 0, 0}, points), static_cast<float>(0.1 * (1 + longer)), desc);
    if (pins > 0) world.pin(rope, 0);
    if (pins > 1) world.pin(rope, points - 1);
    return rope;
}

double fastest(const World& world, gphys_body_id body) {
    double most = 0;
    for (const gphys_vec3& v : world.velocities(body)) most = std::max(most, double{std::hypot(v.x, v.y, v.z)});
    return most;
}

/// The energy above a value, joules, at most, now and in some steps.
double gained(World& world, double before, int steps) {
    double most = world.energy() - before;
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        most = std::max(most, world.energy() - before);
    }
    return most;
}

}  // namespace

TEST_CASE("a rope whose links are placed too short or too long falls as any other") {
    for (const uint32_t substeps : {1u, 4u, 8u}) {
        for (const int pins : {0, 1, 2}) {
            for (const double longer : {-0.3, -0.05, 0.005, 0.02, 0.1, 0.5}) {
                if (pins == 2 && longer < 0) continue;  // too short for its pins
                INFO(substeps << " substeps, " << pins << " pins, " << longer);
                World world(substeps);
                const gphys_body_id rope = placed(world, longer, pins);
                const double before = world.energy();
                world.step(frame);
                // Before: up to 800. It falls at 0.16; what hangs from bent links may be faster than in free fall.
                CHECK(fastest(world, rope) < 2);
                CHECK(static_cast<double>(world.stats().strain_max) < 1e-3);
                // 1 kg that may come to lie half a millimetre higher where its links bend.
                const double first = world.energy();
                CHECK(first - before < 5e-3);
                CHECK(gained(world, first, 60) < 1e-3);
            }
        }
    }
}

TEST_CASE("a rope with wrong lengths that may collide with another body falls as any other") {
    for (const int pins : {0, 1, 2}) {
        INFO(pins << " pins");
        World world;
        const gphys_body_desc desc = test::colliding(1, 0.01f);
        const gphys_body_id rope = placed(world, 0.1, pins, desc);
        world.particles({{3, 0.2f, 0}}, desc);  // above its middle, so that they are moved together
        const double before = world.energy();
        world.step(frame);
        CHECK(fastest(world, rope) < 2);
        // Before: 26 kJ.
        CHECK(gained(world, before, 10) < 1e-2);
    }
}

TEST_CASE("a free rope that is placed with wrong lengths keeps its momentum") {
    World world(8, {0, 0, 0});
    const gphys_body_id rope = placed(world, 0.2, 0);
    std::vector<gphys_vec3> velocities(points, {1, 2, 0});
    REQUIRE(gphys_solver_set_velocities(world.solver, rope, 0, points, velocities.data(), sizeof(gphys_vec3)) ==
            GPHYS_OK);
    for (int i = 0; i < 60; ++i) world.step(frame);
    for (const gphys_vec3& v : world.velocities(rope)) {
        CHECK(std::fabs(v.x - 1) < 1e-4f);
        CHECK(std::fabs(v.y - 2) < 1e-4f);
    }
    // The links lie evenly about the middle, which has moved on.
    CHECK(std::fabs(world.position(rope, points / 2).x - (3 + 1)) < 1e-3f);
}

TEST_CASE("elastic links that are placed stretched have the energy of springs") {
    World world(32, {0, 0, 0});
    gphys_body_desc desc = World::body_desc();
    desc.compliance = 0.01f;
    const gphys_body_id spring = world.rope({{0, 0, 0}, {1, 0, 0}}, 0.5f, desc);
    world.pin(spring, 0);
    // Half a period later it is as much too short: m = 0.5 kg, c = 0.01 m/N.
    const double half = 3.14159265358979 * std::sqrt(0.5 * 0.01);
    const int steps = 20;
    for (int i = 0; i < steps; ++i) world.step(static_cast<float>(half / steps));
    CHECK(std::fabs(world.position(spring, 1).x) < 0.02f);
}

TEST_CASE("what is joined to a rope that is placed with wrong lengths is not thrown") {
    for (const double longer : {0.005, 0.02, 0.1}) {
        for (const bool has_cloth : {false, true}) {
            INFO(longer << ' ' << has_cloth);
            World world;
            const gphys_body_id rope = placed(world, longer, 2);
            gphys_joint_id joint = 0;
            gphys_body_id load = 0;
            if (has_cloth) {
                gphys_body_desc desc = World::body_desc();
                desc.cloth_flags = GPHYS_CLOTH_SHEAR;  // its elastic links against bending store energy
                load = world.cloth({2.5f, -0.05f, 0}, {1, 0, 0}, {0, -1.2f, 0.05f}, 21, 25, desc);
                for (const uint32_t k : {0u, 10u, 20u})
                    REQUIRE(gphys_solver_join(world.solver, rope, 25 + k / 2, load, k, -1, 0, &joint) == GPHYS_OK);
            } else {
                load = world.particles({{3, -0.1f, 0}});
                REQUIRE(gphys_solver_join(world.solver, rope, 30, load, 0, -1, 0, &joint) == GPHYS_OK);
            }
            const double gain = gained(world, world.energy(), 60);
            figure("gain", gain, "J");
            // Before, the weight and the rope gained 1.4 to 30 J, the cloth and the rope 10 to 136.
            CHECK(gain < 0.1);
            CHECK(fastest(world, load) < 7);
        }
    }
}

// Links that only pull, and damped ones, against what is known in closed form.
#include "solver_world.h"

using namespace test;
using gphys::Vec3;

namespace {

constexpr double g = static_cast<double>(9.81f);

gphys_constraint_id max_distance(World& world, gphys_body_id body, uint32_t a, uint32_t b, float length,
                                 float compliance = 0) {
    gphys_constraint_id id = 0;
    REQUIRE(gphys_solver_add_max_distance(world.solver, body, a, b, length, compliance, &id) == GPHYS_OK);
    return id;
}

gphys_constraint_id equality(World& world, gphys_body_id body, uint32_t a, uint32_t b, float length,
                             float compliance = 0) {
    gphys_constraint_id id = 0;
    REQUIRE(gphys_solver_add_distance(world.solver, body, a, b, length, compliance, &id) == GPHYS_OK);
    return id;
}

gphys_solve_method method(const World& world, gphys_body_id body) {
    gphys_body_info info{};
    REQUIRE(gphys_solver_get_body_info(world.solver, body, &info) == GPHYS_OK);
    return info.method;
}

Vec3 velocity(const World& world, gphys_body_id body, uint32_t particle) {
    return gphys::widen(world.velocities(body)[particle]);
}

/// A pinned particle at the origin and `spokes` others at the same place, each on its own link: with one it
/// is a chain, with three a tree, with more than 64 a graph.
gphys_body_id star(World& world, gphys_vec3 place, uint32_t spokes) {
    std::vector<gphys_vec3> places{{0, 0, 0}};
    for (uint32_t i = 0; i < spokes; ++i) places.push_back(place);
    gphys_body_desc desc = World::body_desc();
    desc.mass = static_cast<float>(spokes + 1);
    const gphys_body_id body = world.particles(places, desc);
    world.pin(body, 0);
    return body;
}

}  // namespace

TEST_CASE("A pendulum on a string swings as one on a rod while it is taut") {
    for (const uint32_t spokes : {1u, 3u, 65u}) {
        World world(8);
        const gphys_vec3 start{0.8f, -0.6f, 0};
        const gphys_body_id rod = star(world, start, spokes), string = star(world, start, spokes);
        for (uint32_t i = 1; i <= spokes; ++i) {
            equality(world, rod, 0, i, -1);
            max_distance(world, string, 0, i, -1);
        }
        CHECK(method(world, rod) == (spokes <= 64 ? GPHYS_SOLVE_DIRECT : GPHYS_SOLVE_GRAPH));
        CHECK(method(world, string) == method(world, rod));
        double apart = 0;
        for (int i = 0; i < 600; ++i) {
            world.step(1 / 60.0f);
            apart = std::max(apart, distance(world.position(rod, 1), world.position(string, 1)));
        }
        figure(spokes <= 64 ? "string and rod apart after 10 s, direct" : "the same as a graph", apart, "m");
        // Direct: the same equation, but ropes of rods may be moved side by side, with other roundings of
        // positions that are then given as float32. In a graph a rod is as long as it is to float32, and
        // the velocities of 4800 substeps gather that rounding.
        CHECK(apart <= (spokes <= 64 ? 1e-6 : 1e-4));
        CHECK(world.stats(string).strain_max < 1e-6);
    }
}

TEST_CASE("A slack string does nothing") {
    World world(8);
    gphys_body_desc desc = World::body_desc();
    desc.damping = 0.5f;
    const gphys_body_id body = world.particles({{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}}, desc);
    world.pin(body, 0);
    max_distance(world, body, 0, 1, 5);
    max_distance(world, body, 1, 2, 5);
    CHECK(method(world, body) == GPHYS_SOLVE_DIRECT);
    world.set_velocity(body, 1, {-1, 2, 0.25f});
    for (const float dt : {0.003f, 0.05f, 0.0125f, 0.1f, 0.0345f, 0.05f}) world.step(dt);
    const double t = 0.25, c = 0.5, e = std::exp(-c * t);
    const Vec3 v0{-1, 2, 0.25}, terminal{0, -g / c, 0};
    const Vec3 expected = Vec3{0.5, 0, 0} + terminal * t + (v0 - terminal) * ((1 - e) / c);
    figure("from the closed form of flight", distance(world.position(body, 1), expected), "m");
    // Positions are given as float32: half an ulp of coordinates below 1. The steps sum to t within 1e-9 s.
    CHECK(distance(world.position(body, 1), expected) < 1e-7);
}

TEST_CASE("Particles within a string's length pass each other") {
    World world(4, {0, 0, 0});
    const gphys_body_id body = world.particles({{-1, 0, 0}, {1, 0.01f, 0}});
    max_distance(world, body, 0, 1, 2.5f);
    world.set_velocity(body, 0, {1, 0, 0});
    world.set_velocity(body, 1, {-1, 0, 0});
    for (int i = 0; i < 100; ++i) world.step(0.01f);
    CHECK(distance(world.position(body, 0), Vec3{0, 0, 0}) < 1e-6);
    CHECK(distance(world.position(body, 1), Vec3{0, 0.01f, 0}) < 1e-6);
}

TEST_CASE("A string that becomes taut takes the radial speed and nothing else") {
    // Dropped 0.6 m beside the pin on a string of 1 m, a particle has fallen 0.8 m when it is taut, with
    // v^2 = 2 g 0.8; of v, 0.6 is across the string. From there it is a pendulum of known energy.
    const double kept = 0.5 * 0.36 * 2 * g * 0.8, energy = kept - g * 0.8;
    for (const uint32_t spokes : {1u, 3u, 65u}) {
        double worst[2] = {};
        int row = 0;
        for (const uint32_t substeps : {8u, 32u}) {
            World world(substeps);
            const gphys_body_id body = star(world, {0.6f, 0, 0}, spokes);
            for (uint32_t i = 1; i <= spokes; ++i) max_distance(world, body, 0, i, 1);
            for (int i = 0; i < 27; ++i) world.step(1 / 60.0f);
            double& error = worst[row++];
            for (uint32_t p = 1; p <= spokes; ++p) {
                const Vec3 at = world.position(body, p), v = velocity(world, body, p);
                CHECK(std::fabs(length(at) - 1) < 1e-5);
                CHECK(std::fabs(dot(at, v)) < 1e-3);
                error = std::max(error, std::fabs(0.5 * length_squared(v) + g * at.y - energy) / kept);
            }
            figure(spokes == 1 ? "energy after capture, direct, in parts of what is kept"
                               : "energy after capture, graph, in parts of what is kept",
                   error, "");
        }
        // Capture is placed within a substep: an error of first order, v h = 8e-3 m of a way of a metre.
        CHECK(worst[0] < 0.02);
        CHECK(worst[1] < 0.005);
    }
}

TEST_CASE("Two free particles on a string part with the speed of their centre of mass") {
    World world(8, {0, 0, 0});
    const gphys_body_id body = world.particles({{-0.4f, 0, 0}, {0.4f, 0, 0}});
    const float masses[] = {1, 3};
    REQUIRE(gphys_solver_set_masses(world.solver, body, 0, 2, masses, 4) == GPHYS_OK);
    max_distance(world, body, 0, 1, 1);
    world.set_velocity(body, 0, {-2, 0, 0});
    world.set_velocity(body, 1, {1, 0, 0});
    for (int i = 0; i < 30; ++i) world.step(1 / 60.0f);
    // Inelastic: both go on with (1 (-2) + 3 * 1) / 4.
    CHECK(std::fabs(velocity(world, body, 0).x - 0.25) < 1e-6);
    CHECK(std::fabs(velocity(world, body, 1).x - 0.25) < 1e-6);
    CHECK(std::fabs(world.position(body, 1).x - world.position(body, 0).x - 1) < 1e-6);
}

TEST_CASE("A chain of three strings hangs straight") {
    World world(8);
    gphys_body_desc desc = World::body_desc();
    desc.damping = 1;
    const gphys_body_id body = world.particles({{0, 0, 0}, {0.1f, 0, 0}, {0.2f, 0.1f, 0}, {0.1f, 0.2f, 0}}, desc);
    world.pin(body, 0);
    for (uint32_t i = 0; i < 3; ++i) max_distance(world, body, i, i + 1, 0.5f);
    CHECK(method(world, body) == GPHYS_SOLVE_DIRECT);
    double strain = 0;
    for (int i = 0; i < 1800; ++i) {
        world.step(1 / 60.0f);
        strain = std::max<double>(strain, world.stats(body).strain_max);
    }
    figure("strain on the way", strain, "");
    CHECK(strain < 1e-6);
    for (uint32_t i = 1; i <= 3; ++i) CHECK(distance(world.position(body, i), Vec3{0, -0.5 * i, 0}) < 1e-4);
}

TEST_CASE("A falling sheet is caught by a string") {
    World world(16);
    gphys_body_desc desc = World::body_desc();
    desc.damping = 2;
    const gphys_body_id body = world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 9, 9, desc);
    // One corner is cut off and becomes the nail that the opposite one hangs from.
    gphys_constraint_info links[1000];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_constraints(world.solver, body, links, 1000, &total) == GPHYS_OK);
    for (uint32_t i = 0; i < total; ++i) {
        if (links[i].particle_a != 80 && links[i].particle_b != 80) continue;
        REQUIRE(gphys_solver_remove_constraint(world.solver, body, links[i].id) == GPHYS_OK);
    }
    const gphys_vec3 nail{0, 1, 0};
    REQUIRE(gphys_solver_set_positions(world.solver, body, 80, 1, &nail, 12) == GPHYS_OK);
    world.pin(body, 80);
    max_distance(world, body, 80, 0, 1.5f);
    CHECK(method(world, body) == GPHYS_SOLVE_GRAPH);
    double strain = 0, longest = 0;
    for (int i = 0; i < 900; ++i) {
        world.step(1 / 60.0f);
        strain = std::max<double>(strain, world.stats(body).strain_max);
        longest = std::max(longest, distance(world.position(body, 0), gphys::widen(nail)));
        // Free fall, damped a little, is 0.5 m after 0.33 s.
        if (i == 17) CHECK(world.position(body, 0).y < -0.3);
    }
    figure("strain on the way, the string's included", strain, "");
    figure("longest string of 1.5 m", longest, "m");
    CHECK(longest < 1.5 * (1 + 1e-5));
    CHECK(strain < 0.05);
    CHECK(distance(world.position(body, 0), Vec3{0, -0.5, 0}) < 1e-2);
}

TEST_CASE("A damped oscillator follows its closed form at every step") {
    // m x'' = -k x - c x', from rest at a.
    const double m = 1, k = 40, c = 1.5, a = 0.25, rest = 1, t = 2;
    const double rate = c / (2 * m), omega = std::sqrt(k / m - rate * rate);
    const double expected = a * std::exp(-rate * t) * (std::cos(omega * t) + rate / omega * std::sin(omega * t));
    for (const uint32_t spokes : {1u, 3u, 65u}) {
        for (const int steps : {60, 120, 240}) {
            World world(8, {0, 0, 0});
            const gphys_body_id body = star(world, {static_cast<float>(rest + a), 0, 0}, spokes);
            for (uint32_t i = 1; i <= spokes; ++i) {
                const gphys_constraint_id id =
                    equality(world, body, 0, i, static_cast<float>(rest), static_cast<float>(1 / k));
                REQUIRE(gphys_solver_set_constraint_damping(world.solver, body, id, static_cast<float>(c)) == GPHYS_OK);
            }
            for (int i = 0; i < steps; ++i) world.step(static_cast<float>(t / steps));
            const double error = std::fabs(world.position(body, 1).x - rest - expected), h = t / steps / 8;
            std::printf("    %s, h = %.2g ms: off by %.3g of %.3g m\n", spokes == 1 ? "direct" : "graph", 1e3 * h,
                        error, std::fabs(expected));
            // The phase of BDF2 goes wrong by (omega h)^2 / 3 a radian, of which there are omega t: of a the
            // error is below that and its damping together; to it comes the rounding of float32 in a graph.
            const double bound = a * omega * t * (omega * h) * (omega * h);
            CHECK(error < bound + (spokes == 1 ? 1e-6 : 1e-4));
        }
    }
}

TEST_CASE("Damping takes energy from stretching only") {
    World world(8, {0, 0, 0});
    const gphys_body_id body = star(world, {1, 0, 0}, 1);
    // Turning at 1 rad/s, m r w^2 = k (r - rest) holds the length: nothing to damp.
    const gphys_constraint_id id = equality(world, body, 0, 1, 0.99f, 0.01f);
    REQUIRE(gphys_solver_set_constraint_damping(world.solver, body, id, 50) == GPHYS_OK);
    world.set_velocity(body, 1, {0, 1, 0});
    for (int i = 0; i < 600; ++i) world.step(1 / 60.0f);
    figure("speed after 10 s of turning", length(velocity(world, body, 1)), "m/s");
    CHECK(std::fabs(length(velocity(world, body, 1)) - 1) < 1e-3);
}

TEST_CASE("Damping of any strength is stable") {
    for (const uint32_t spokes : {1u, 3u, 65u}) {
        for (const float damping : {1e3f, 1e9f, 1e15f}) {
            World world(8);
            const gphys_body_id body = star(world, {0, -1, 0}, spokes);
            for (uint32_t i = 1; i <= spokes; ++i) {
                const gphys_constraint_id id = max_distance(world, body, 0, i, 0.9f, 0.01f);
                REQUIRE(gphys_solver_set_constraint_damping(world.solver, body, id, damping) == GPHYS_OK);
            }
            for (int i = 0; i < 300; ++i) world.step(1 / 60.0f);
            REQUIRE(all_finite(world.positions(body)));
            // It creeps towards g / k below the rest length, 0.998 m, where c x' = m g - k x is not yet 0.
            CHECK(length(world.position(body, 1)) < 1.01);
            CHECK(length(world.position(body, 1)) > 0.89);
        }
    }
}

TEST_CASE("Restored strings and dampers go on with the same bits") {
    World world(8), copy(8);
    const gphys_body_id rope = world.rope({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0), graph = star(world, {0.5f, 0, 0}, 3);
    world.pin(rope, 0);
    for (uint32_t i = 1; i <= 3; ++i) {
        const gphys_constraint_id id = max_distance(world, graph, 0, i, 0.8f, 0.001f);
        REQUIRE(gphys_solver_set_constraint_damping(world.solver, graph, id, 2) == GPHYS_OK);
    }
    gphys_constraint_info links[2];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_constraints(world.solver, rope, links, 2, &total) == GPHYS_OK);
    REQUIRE(gphys_solver_remove_constraint(world.solver, rope, links[1].id) == GPHYS_OK);
    max_distance(world, rope, 1, 2, 1.2f);
    for (int i = 0; i < 20; ++i) world.step(1 / 60.0f);
    REQUIRE(gphys_solver_get_snapshot(world.solver, nullptr, 0, &total) == GPHYS_INCOMPLETE);
    std::vector<uint32_t> words(total);
    REQUIRE(gphys_solver_get_snapshot(world.solver, words.data(), total, &total) == GPHYS_OK);
    REQUIRE(gphys_solver_restore(copy.solver, words.data(), total) == GPHYS_OK);
    for (int i = 0; i < 60; ++i) world.step(1 / 60.0f), copy.step(1 / 60.0f);
    uint32_t a[2], b[2];
    REQUIRE(gphys_solver_get_hash(world.solver, a) == GPHYS_OK);
    REQUIRE(gphys_solver_get_hash(copy.solver, b) == GPHYS_OK);
    CHECK((a[0] == b[0] && a[1] == b[1]));
}

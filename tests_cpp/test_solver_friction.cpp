// Static friction apart from kinetic, on a slope between the two.
#include "solver_world.h"

using namespace test;
using gphys::Vec3;

namespace {

constexpr double g = static_cast<double>(9.81f);
const Vec3 normal{0.6, 0.8, 0}, down{0.8, -0.6, 0};  // tan = 0.75

gphys_vec3 on_slope(double along, double across) {
    return gphys::narrow(normal * 0.010002 + down * along + Vec3{0, 0, across});
}

gphys_body_id lay(World& world, gphys_body_kind kind, float kinetic, float at_rest) {
    gphys_body_desc desc = World::body_desc();
    desc.friction = kinetic;
    desc.static_friction = at_rest;
    if (kind == GPHYS_BODY_PARTICLES) return world.particles({on_slope(0, 0), on_slope(0.3, 0.5)}, desc);
    if (kind == GPHYS_BODY_ROPE) return world.rope({on_slope(0, 0), on_slope(0.3, 0), on_slope(0.6, 0)}, 0, desc);
    return world.cloth(on_slope(0, 0), gphys::narrow(down), {0, 0, 1}, 7, 7, desc);
}

Vec3 mean_velocity(const World& world, gphys_body_id body) {
    Vec3 sum;
    const std::vector<gphys_vec3> velocities = world.velocities(body);
    for (const gphys_vec3& v : velocities) sum += gphys::widen(v);
    return sum / static_cast<double>(velocities.size());
}

}  // namespace

TEST_CASE("Between the two coefficients what rests sticks and what moves goes on") {
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        for (const uint32_t substeps : {4u, 8u, 32u}) {
            World world(substeps);
            const gphys_plane plane{gphys::narrow(normal), 0};
            world.model(GPHYS_SHAPE_PLANE, &plane);
            const gphys_body_id rests = lay(world, kind, 0.5f, 0.9f), moves = lay(world, kind, 0.5f, 0.9f);
            for (uint32_t p = 0; p < world.positions(moves).size(); ++p) {
                world.set_velocity(moves, p, gphys::narrow(down * 0.05));
            }
            const Vec3 from = world.position(rests), from_moving = world.position(moves);
            for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
            const double drift = distance(world.position(rests), from), a = g * (0.6 - 0.5 * 0.8);
            const double speed = dot(mean_velocity(world, moves), down),
                         way = dot(world.position(moves) - from_moving, down);
            std::printf(
                "    kind %d, %u substeps: at rest drifts by %.3g m; slides at %.6g of %.6g m/s, %.6g of %.6g m\n",
                kind, substeps, drift, speed, 0.05 + a, way, 0.05 + a / 2);
            // The skin of 1e-6 m that it falls through, and float32.
            CHECK(drift < 1e-5);
            CHECK(std::fabs(speed / (0.05 + a) - 1) < (kind == GPHYS_BODY_CLOTH ? 1e-2 : 1e-4));
            CHECK(std::fabs(way - 0.05 - a / 2) < 0.02);
        }
    }
}

TEST_CASE("Beyond static friction what rests begins to slide, with kinetic friction") {
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        World world(8);
        const gphys_plane plane{gphys::narrow(normal), 0};
        world.model(GPHYS_SHAPE_PLANE, &plane);
        const gphys_body_id body = lay(world, kind, 0.25f, 0.6f);
        for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
        const double expected = g * (0.6 - 0.25 * 0.8), speed = dot(mean_velocity(world, body), down);
        std::printf("    kind %d: %.6g of %.6g m/s\n", kind, speed, expected);
        CHECK(std::fabs(speed / expected - 1) < 0.02);
    }
}

TEST_CASE("What kinetic friction stops is held by static friction") {
    // On the flat at 0.5 m/s and 0.25 g it stops after 0.2 s; tipped to tan = 0.75 it then stays with 0.9.
    for (const gphys_body_kind kind : {GPHYS_BODY_PARTICLES, GPHYS_BODY_ROPE, GPHYS_BODY_CLOTH}) {
        World world(8);
        const gphys_plane plane{gphys::narrow(normal), 0};
        world.model(GPHYS_SHAPE_PLANE, &plane);
        const gphys_body_id body = lay(world, kind, 0.25f, 0.9f);
        const gphys_vec3 onto_it = gphys::narrow(normal * -g), tipped{0, -9.81f, 0};
        REQUIRE(gphys_solver_set_gravity(world.solver, &onto_it) == GPHYS_OK);
        for (uint32_t p = 0; p < world.positions(body).size(); ++p) {
            world.set_velocity(body, p, gphys::narrow(down * 0.5));
        }
        const Vec3 from = world.position(body);
        for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
        const Vec3 stopped = world.position(body);
        const double way = 0.25 / (2 * 0.25 * g);
        std::printf("    kind %d: stops after %.5g of %.5g m", kind, dot(stopped - from, down), way);
        CHECK(std::fabs(dot(stopped - from, down) / way - 1) < 0.03);
        REQUIRE(gphys_solver_set_gravity(world.solver, &tipped) == GPHYS_OK);
        for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
        std::printf(", then drifts by %.3g m\n", distance(world.position(body), stopped));
        CHECK(distance(world.position(body), stopped) < 1e-5);
    }
}

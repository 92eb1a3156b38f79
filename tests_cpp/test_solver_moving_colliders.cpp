// Walls that move: what they meet stays in front of them.
#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::point_mass;
using test::World;

namespace {

constexpr float frame = 1 / 60.0f;

gphys_transform turned(double angle, gphys_vec3 position = {0, 0, 0}) {
    return {position, {0, static_cast<float>(std::sin(angle / 2)), 0, static_cast<float>(std::cos(angle / 2))}, 1};
}

Vec3 seen_from(const gphys_transform& at, gphys_vec3 point) { return widen(at).inverse_apply(widen(point)); }

}  // namespace

TEST_CASE("what a thin wall pushes along a floor stays in front of it", "[simulation]") {
    int behind = 0;
    double furthest = 0;
    for (const uint32_t substeps : {1u, 2u, 8u}) {
        for (const float friction : {0.0f, 0.4f}) {
            World world(substeps);
            const gphys_aabb floor{{-50, -1, -50}, {50, 0, 50}}, plate{{-0.0005f, -1, -50}, {0.0005f, 1, 50}};
            world.model(GPHYS_SHAPE_AABB, &floor);
            const gphys_model_id wall = world.model(GPHYS_SHAPE_AABB, &plate);
            std::vector<gphys_vec3> points;
            for (uint32_t i = 0; i < 100; ++i) {
                points.push_back({0.05f + 0.0137f * static_cast<float>(i), 0.0101f, 0.8f * static_cast<float>(i) - 40});
            }
            const gphys_body_id body = world.particles(points, point_mass(0.01f, friction, 0));
            for (int i = 0; i < 180; ++i) {
                // In the wall's plane it slides, and it turns a little to and fro.
                const double t = i / 60.0;
                const gphys_transform at =
                    turned(0.002 * std::sin(20 * t), {static_cast<float>(1.8 * t), 0.3f * std::sin(5 * frame * i), 0});
                REQUIRE(gphys_scene_set_transform(world.scene, wall, &at) == GPHYS_OK);
                world.step(frame);
                for (const gphys_vec3& p : world.positions(body)) {
                    const double ahead = seen_from(at, p).x - 0.0005;
                    behind += ahead < 0.01 - 1e-6;
                    furthest = std::max(furthest, ahead);
                }
            }
        }
    }
    figure("pushed along a floor, behind the wall", behind, "");
    CHECK(behind == 0);
    CHECK(furthest > 0.3);  // some were ahead
}

TEST_CASE("a paddle on a long arm meets what is in its way, at any step") {
    // Thin, and 8 cm broad on an arm of a metre. From one place of a step to the next, the straight way would cut
    // the corner by 1 - cos(0.33), 5 cm.
    for (const uint32_t substeps : {1u, 4u}) {
        for (const int kind : {0, 1}) {
            World world(substeps, {0, 0, 0});
            const gphys_aabb plate{{0.96f, -0.5f, -0.0005f}, {1.04f, 0.5f, 0.0005f}};
            const test::MeshHandle mesh({0.96f, -0.5f, 0, 1.04f, -0.5f, 0, 1.04f, 0.5f, 0, 0.96f, 0.5f, 0},
                                        {0, 1, 2, 0, 2, 3});
            const gphys_model_id paddle =
                kind == 0 ? world.model(GPHYS_SHAPE_AABB, &plate) : world.model(GPHYS_SHAPE_MESH, mesh.mesh);
            std::vector<gphys_vec3> points;
            for (int i = 0; i < 200; ++i) {
                const double angle = -0.1 - 0.5 * i / 200, arm = 1 + 0.03 * std::sin(i);
                points.push_back(
                    {static_cast<float>(arm * std::cos(angle)), 0, static_cast<float>(-arm * std::sin(angle))});
            }
            const gphys_body_id body = world.particles(points, point_mass(0.005f, 0, 0));
            world.step(frame);
            const gphys_transform at = turned(-0.66);
            REQUIRE(gphys_scene_set_transform(world.scene, paddle, &at) == GPHYS_OK);
            world.step(frame);
            int missed = 0;
            for (const gphys_vec3& v : world.velocities(body)) missed += length(widen(v)) < 10;
            int passed = 0;
            for (const gphys_vec3& p : world.positions(body)) {
                const Vec3 seen = seen_from(at, p);
                passed += seen.x < 1.04 && seen.z < 0;  // further out it may have slid off the end
            }
            CAPTURE(substeps, kind);
            CHECK(missed == 0);
            CHECK(passed == 0);
        }
    }
}

TEST_CASE("ropes and cloth thrown at a wall that turns away do not pass", "[simulation]") {
    for (const int kind : {0, 1}) {
        for (const double speed : {-5.0, 5.0}) {
            World world(4, {0, 0, 0});
            const gphys_aabb plate{{-0.0005f, -50, -50}, {0.0005f, 50, 50}};
            const gphys_model_id wall = world.model(GPHYS_SHAPE_AABB, &plate);
            test::Random random(7);
            std::vector<gphys_body_id> bodies;
            const gphys_body_desc desc = point_mass(0.01f, 0.3f, 0);
            for (int i = 0; i < 100; ++i) {
                const gphys_vec3 at{random.uniform_float(0.3f, 2), random.uniform_float(-9, 9),
                                    random.uniform_float(-9, 9)};
                if (kind == 0) {
                    bodies.push_back(world.rope(test::line(at, {0, 0.02f, 0.01f}, 6), 0, desc));
                } else {
                    bodies.push_back(world.cloth(at, {0, 0.1f, 0.02f}, {0.02f, 0, 0.1f}, 5, 5, desc));
                }
            }
            world.step(frame);
            for (const gphys_body_id body : bodies) {
                const gphys_vec3 velocity{-100, random.uniform_float(-30, 30), random.uniform_float(-30, 30)};
                const std::vector<gphys_vec3> all(world.positions(body).size(), velocity);
                REQUIRE(gphys_solver_set_velocities(world.solver, body, 0, static_cast<uint32_t>(all.size()),
                                                    all.data(), 12) == GPHYS_OK);
            }
            int passed = 0;
            for (int i = 1; i <= 20; ++i) {
                const double t = i / 60.0;
                const gphys_transform at = turned(2 * t, {static_cast<float>(speed * t), 0, 0});
                REQUIRE(gphys_scene_set_transform(world.scene, wall, &at) == GPHYS_OK);
                world.step(frame);
                for (const gphys_body_id body : bodies) {
                    for (const gphys_vec3& p : world.positions(body)) passed += seen_from(at, p).x < 0;
                }
            }
            CAPTURE(kind, speed);
            CHECK(passed == 0);
        }
    }
}

TEST_CASE("what a bat strikes does not pass the wall behind it") {
    for (const bool in_rope : {false, true}) {
        for (const float restitution : {0.0f, 1.0f}) {
            World world(1, {0, 0, 0});
            const gphys_aabb wall{{0.3f, -5, -5}, {0.301f, 5, 5}}, bat{{-0.1f, -0.2f, -0.2f}, {0, 0.2f, 0.2f}};
            world.model(GPHYS_SHAPE_AABB, &wall);
            const gphys_model_id moving = world.model(GPHYS_SHAPE_AABB, &bat);
            const std::vector<gphys_vec3> points = test::line({0.02f, -0.1f, 0}, {0, 0.02f, 0}, 10);
            const gphys_body_desc desc = point_mass(0.01f, 0, restitution);
            const gphys_body_id body = in_rope ? world.rope(points, 0, desc) : world.particles(points, desc);
            world.step(frame);
            // At 12 m/s to 0.1 m from the wall, and away again.
            for (const float place : {0.2f, 0.2f, 0.0f}) {
                const gphys_transform at{{place, 0, 0}, {0, 0, 0, 1}, 1};
                REQUIRE(gphys_scene_set_transform(world.scene, moving, &at) == GPHYS_OK);
                world.step(frame);
                for (const gphys_vec3& p : world.positions(body)) {
                    CAPTURE(in_rope, restitution, place);
                    CHECK(p.x < 0.3f - 0.0099f);
                }
            }
        }
    }
}

TEST_CASE("what the caller has put elsewhere meets what moves there") {
    World world(2, {0, 0, 0});
    const gphys_aabb plate{{-0.0005f, -1, -1}, {0.0005f, 1, 1}};
    const gphys_transform there{{100, 0, 0}, {0, 0, 0, 1}, 1}, moved{{100.1f, 0, 0}, {0, 0, 0, 1}, 1};
    const gphys_model_id wall = world.model(GPHYS_SHAPE_AABB, &plate, &there);
    const gphys_body_id body = world.particles(test::line({0, 0, 0}, {0.1f, 0, 0}, 9), point_mass(0.01f, 0, 0));
    world.step(frame);
    const gphys_vec3 beside{100.05f, 0, 0};
    REQUIRE(gphys_solver_set_positions(world.solver, body, 3, 1, &beside, 12) == GPHYS_OK);
    world.step(frame);
    REQUIRE(gphys_scene_set_transform(world.scene, wall, &moved) == GPHYS_OK);
    world.step(frame);
    CHECK(world.position(body, 3).x > 100.1 + 0.01);
}

TEST_CASE("cloth is pushed by a ball that is far before it and behind it at the ends of a step") {
    World world(8, {0, 0, 0});
    const gphys_sphere ball{{0, 0, 0}, 0.15f};
    gphys_transform place{{0, 0, -0.55f}, {0, 0, 0, 1}, 1};
    const gphys_model_id model = world.model(GPHYS_SHAPE_SPHERE, &ball, &place);
    const gphys_body_id sheet = world.cloth({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}, 20, 20, World::body_desc());
    world.step(1.0f / 60);
    place.position.z = 0.25f;
    REQUIRE(gphys_scene_set_transform(world.scene, model, &place) == GPHYS_OK);
    world.step(1.0f / 60);
    CHECK(world.stats(sheet).contact_count > 0);
    for (const gphys_vec3& at : world.positions(sheet)) {
        if (std::hypot(at.x, at.y) < 0.05f) CHECK(at.z > 0.25f);
    }
}

// Particles against a scene: bounces, friction, thin walls, moving models.
#include <cstring>

#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::MeshHandle;
using test::point_mass;
using test::World;

namespace {

constexpr double g = 9.81f;
constexpr gphys_quat no_turn{0, 0, 0, 1};

}  // namespace

TEST_CASE("a ball bounces as high as its restitution says") {
    World world;
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id body = world.particles({{0, 1.1f, 0}}, point_mass(0.1f, 0, 0.8f));
    // h_n = e^(2n), one metre above the floor at first; 60 steps a second miss the top by 3e-4 m at
    // most, so the energy at each top is measured: m g h + m v^2 / 2.
    double top = 0, last_height = 2, worst = 0;
    int bounce = 0;
    for (int i = 0; i < 60 * 6 && bounce < 8; ++i) {
        world.step(1.0f / 60);
        const double height = world.position(body).y - 0.1;
        const double speed = static_cast<double>(world.velocities(body)[0].y);
        const double energy_height = height + speed * speed / (2 * g);
        if (bounce == 0 || energy_height < top * 0.9) {
            if (bounce > 0 || last_height < 2) ++bounce;
            top = energy_height;
            const double expected = std::pow(0.64, std::round(std::log(energy_height) / std::log(0.64)));
            worst = std::max(worst, std::fabs(energy_height / expected - 1));
        }
        last_height = height;
    }
    CHECK(bounce >= 7);
    figure("bounce, worst relative error of the height", worst, "");
    CHECK(worst <= 1e-3);
    for (int i = 0; i < 600; ++i) world.step(1.0f / 60);
    const double rest = world.position(body).y;
    for (int i = 0; i < 60; ++i) {
        world.step(1.0f / 60);
        CHECK(world.position(body).y == rest);  // lies still
    }
    CHECK(std::fabs(rest - 0.1) < 1e-4);
    CHECK(world.stats().contact_count == 1);
}

TEST_CASE("a particle on a slope sticks below the angle of friction and slides as Coulomb says above") {
    for (const double degrees : {5.0, 20.0, 26.0, 26.56, 27.0, 35.0, 60.0}) {
        const double a = degrees * pi / 180;
        World world;
        const gphys_plane slope{{static_cast<float>(std::sin(a)), static_cast<float>(std::cos(a)), 0}, 0};
        world.model(GPHYS_SHAPE_PLANE, &slope);
        const Vec3 n = normalized(widen(slope.normal));
        const gphys_body_id body = world.particles({narrow(n * (0.1 + 2e-5))}, point_mass(0.1f, 0.5f, 0));
        world.step(1.0f / 60);
        const Vec3 start = world.position(body), speed = widen(world.velocities(body)[0]);
        const int steps = 60;
        for (int i = 0; i < steps; ++i) world.step(1.0f / 60);
        const double moved = distance(world.position(body), start);
        CAPTURE(degrees, moved);
        if (std::tan(a) <= 0.5) {
            CHECK(moved == 0);
        } else {
            const double t = steps * static_cast<double>(1.0f / 60), along = g * (n.x - 0.5 * n.y);
            const double exact = length(speed) * t + along * t * t / 2;
            CHECK(std::fabs(moved / exact - 1) <= 1e-4);
        }
    }
}

TEST_CASE("a moving wall takes particles along") {
    World world(4, {0, 0, 0});
    const gphys_aabb box{{-0.0005f, -5, -5}, {0.0005f, 5, 5}};
    gphys_transform at{{-0.2f, 0, 0}, no_turn, 1};
    const gphys_model_id wall = world.model(GPHYS_SHAPE_AABB, &box, &at);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 100; ++i)
        points.push_back({0.1f + 0.01f * static_cast<float>(i), 0.04f * static_cast<float>(i), 0});
    gphys_body_desc desc = point_mass(0.01f, 0, 0);
    const gphys_body_id body = world.particles(points, desc);
    world.step(1.0f / 60);
    for (int i = 0; i < 60; ++i) {
        at.position.x += 0.05f;  // 3 m/s
        REQUIRE(gphys_scene_set_transform(world.scene, wall, &at) == GPHYS_OK);
        world.step(1.0f / 60);
        for (const gphys_vec3& p : world.positions(body)) CHECK(p.x >= at.position.x);
    }
}

TEST_CASE("an attached particle follows its model and is released with it") {
    World world;
    const gphys_sphere ball{{0, 0, 0}, 0.1f};
    gphys_transform at{{1, 2, 3}, no_turn, 1};
    const gphys_model_id model = world.model(GPHYS_SHAPE_SPHERE, &ball, &at);
    gphys_body_desc desc = World::body_desc();
    desc.layers = 0;
    const gphys_body_id body = world.rope({{1, 2.5f, 3}, {2, 2.5f, 3}}, 0, desc);
    REQUIRE(gphys_solver_attach(world.solver, world.scene, body, 0, model, nullptr) == GPHYS_OK);
    for (int i = 1; i <= 60; ++i) {
        at.position.y = 2 + 0.01f * static_cast<float>(i);
        REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
        world.step(1.0f / 60);
        CHECK(std::fabs(world.position(body).y - static_cast<double>(at.position.y) - 0.5) < 1e-6);
    }
    CHECK(world.stats().pinned_count == 1);
    REQUIRE(gphys_scene_remove(world.scene, model) == GPHYS_OK);
    world.step(1.0f / 60);
    CHECK(world.stats().pinned_count == 0);
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
    CHECK(world.position(body).y < 0);
}

TEST_CASE("rope and cloth come to rest on what they fall on", "[simulation]") {
    World world;
    const gphys_plane floor{{0, 1, 0}, 0};
    const gphys_sphere ball{{0, 0.5f, 0}, 0.5f};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    world.model(GPHYS_SHAPE_SPHERE, &ball);
    gphys_body_desc desc = point_mass(0.02f, 0.5f, 0);
    desc.damping = 1;
    world.cloth({-0.9f, 1.3f, -0.9f}, {1.8f, 0, 0}, {0, 0, 1.8f}, 31, 31, desc);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 60; ++i) points.push_back({-1.5f + 0.05f * static_cast<float>(i), 1.5f, 0.3f});
    world.rope(points, 0, desc);
    for (int i = 0; i < 180; ++i) {
        world.step(1.0f / 60);
        gphys_body_id bodies[2];
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_bodies(world.solver, bodies, 2, &total) == GPHYS_OK);
        for (const gphys_body_id body : bodies) {
            for (const gphys_vec3& p : world.positions(body)) {
                REQUIRE(p.y >= 0.02f);
                // Outside of the ball grown by the radius, less the rounding of float32 output.
                REQUIRE(distance(widen(p), {0, 0.5, 0}) >= 0.52 - 1e-6);
            }
        }
    }
    CHECK(world.stats().contact_count > 0);
    CHECK(world.stats().strain_max < 0.2f);
}

namespace {

/// How far the threads of a square sheet are longer than at rest: the most, and all but one in a thousand.
struct Stretch {
    double most = 0, thousandth = 0;

    Stretch(const std::vector<gphys_vec3>& p, uint32_t n, double spacing) {
        std::vector<double> all;
        for (uint32_t i = 0; i < n * n; ++i) {
            if (i % n + 1 < n) all.push_back(distance(widen(p[i]), widen(p[i + 1])) / spacing - 1);
            if (i + n < n * n) all.push_back(distance(widen(p[i]), widen(p[i + n])) / spacing - 1);
        }
        std::sort(all.begin(), all.end());
        most = all.back();
        thousandth = all[all.size() - 1 - all.size() / 1000];
    }
};

/// A ball with bumps, of 4 n^2 triangles, around the origin: between 0.44 m and 0.56 m from it.
MeshHandle bumpy_ball(uint32_t n) {
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    for (uint32_t r = 0; r <= n; ++r) {
        for (uint32_t k = 0; k < 2 * n; ++k) {
            const double polar = pi * r / n, turn = pi * k / n;
            const double radius = 0.5 * (1 + 0.12 * std::sin(3 * polar) * std::sin(4 * turn));
            vertices.push_back(static_cast<float>(radius * std::sin(polar) * std::cos(turn)));
            vertices.push_back(static_cast<float>(radius * std::cos(polar)));
            vertices.push_back(static_cast<float>(radius * std::sin(polar) * std::sin(turn)));
        }
    }
    for (uint32_t r = 0; r < n; ++r) {
        for (uint32_t k = 0; k < 2 * n; ++k) {
            const uint32_t a = r * 2 * n + k, b = r * 2 * n + (k + 1) % (2 * n);
            indices.insert(indices.end(), {a, b, a + 2 * n, b, b + 2 * n, a + 2 * n});
        }
    }
    return MeshHandle(vertices, indices);
}

/// A sheet of n x n particles falls on what the world holds below 0.6 m, and lies there.
void drape(World& world, uint32_t n, double size, float radius, int frames, double most_peak, double most_at_rest) {
    gphys_body_desc desc = point_mass(radius, 0.5f, 0);
    desc.damping = 1;
    const float half = static_cast<float>(size / 2), side = static_cast<float>(size);
    const gphys_body_id cloth = world.cloth({-half, 0.8f, -half}, {side, 0, 0}, {0, 0, side}, n, n, desc);
    double peak = 0, usual = 0;
    uint32_t within = 0;
    for (int i = 0; i < frames; ++i) {
        world.step(1.0f / 60);
        const std::vector<gphys_vec3> positions = world.positions(cloth);
        const Stretch stretch(positions, n, size / (n - 1));
        peak = std::max(peak, stretch.most);
        usual = std::max(usual, stretch.thousandth);
        for (const gphys_vec3& p : positions) {
            // Grown by nearly the radius of a particle: by less than it keeps off.
            const gphys_sphere particle{p, radius * 0.9999f};
            uint32_t models = 0;
            REQUIRE(gphys_scene_overlap(world.scene, GPHYS_SHAPE_SPHERE, &particle, ~0u, nullptr, 0, &models) ==
                    GPHYS_OK);
            within += models > 0;
        }
    }
    const Stretch rest(world.positions(cloth), n, size / (n - 1));
    figure("  peak stretch of a thread", peak * 100, "%");
    figure("  peak stretch of all but one in 1000", usual * 100, "%");
    figure("  stretch at the end", rest.most * 100, "%");
    figure("  stretch at the end of all but one in 1000", rest.thousandth * 100, "%");
    CHECK(within == 0);
    CHECK(peak <= most_peak);
    CHECK(rest.most <= most_at_rest);
    CHECK(world.stats(cloth).contact_count > n / 2);
}

}  // namespace

TEST_CASE("cloth that falls on a ball keeps its threads' lengths", "[simulation]") {
    World world(16);
    const gphys_plane floor{{0, 1, 0}, -0.5f};
    const gphys_sphere ball{{0, 0, 0}, 0.5f};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    world.model(GPHYS_SHAPE_SPHERE, &ball);
    drape(world, 61, 1.8, 0.02f, 180, 0.05, 0.015);
}

TEST_CASE("cloth that falls on a mesh keeps its threads' lengths and lets nothing through", "[simulation]") {
    World world(16);
    const gphys_plane floor{{0, 1, 0}, -0.6f};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const MeshHandle mesh = bumpy_ball(40);
    world.model(GPHYS_SHAPE_MESH, mesh.mesh);
    drape(world, 41, 1.6, 0.01f, 120, 0.08, 0.02);
}

TEST_CASE("a sheet of 100 x 100 falls on 70 000 triangles", "[.long]") {
    World world(16);
    const gphys_plane floor{{0, 1, 0}, -0.6f};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const MeshHandle mesh = bumpy_ball(133);
    world.model(GPHYS_SHAPE_MESH, mesh.mesh);
    drape(world, 100, 2, 0.01f, 600, 0.15, 0.06);
}

TEST_CASE("cloth of points, without any radius, lies on a mesh, a box and a plane") {
    World world(8);
    const gphys_plane floor{{0, 1, 0}, -0.6f};
    const gphys_aabb box{{0.3f, -0.6f, 0.3f}, {0.9f, 0.3f, 0.9f}};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    world.model(GPHYS_SHAPE_AABB, &box);
    const MeshHandle mesh = bumpy_ball(12);
    world.model(GPHYS_SHAPE_MESH, mesh.mesh);
    const gphys_body_id cloth = world.cloth({-1, 0.7f, -1}, {2, 0, 0}, {0, 0, 2}, 31, 31, point_mass(0, 0.5f, 0));
    for (int i = 0; i < 180; ++i) {
        world.step(1.0f / 60);
        for (const gphys_vec3& p : world.positions(cloth)) {
            REQUIRE(p.y >= -0.6f);
            REQUIRE(length(widen(p)) > 0.4);
            REQUIRE(!(p.x > 0.301f && p.x < 0.899f && p.z > 0.301f && p.z < 0.899f && p.y < 0.299f));
        }
    }
}

TEST_CASE("thick particles of cloth that are put into a fine mesh come out of it") {
    // Around each some hundred triangles are nearer than its radius.
    World world(4);
    const MeshHandle mesh = bumpy_ball(133);
    world.model(GPHYS_SHAPE_MESH, mesh.mesh);
    const gphys_body_id cloth =
        world.cloth({-0.2f, 0.52f, -0.2f}, {0.4f, 0, 0}, {0, 0, 0.4f}, 5, 5, point_mass(0.1f, 0.5f, 0));
    for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
    for (const gphys_vec3& v : world.velocities(cloth)) CHECK(length(widen(v)) < 10);
    for (const gphys_vec3& p : world.positions(cloth)) {
        const gphys_sphere particle{p, 0.1f * 0.9999f};
        uint32_t models = 0;
        REQUIRE(gphys_scene_overlap(world.scene, GPHYS_SHAPE_SPHERE, &particle, ~0u, nullptr, 0, &models) == GPHYS_OK);
        CHECK(models == 0);
    }
}

TEST_CASE("a ball that flies into a hanging sheet takes it along and does not pass") {
    World world(8);
    const gphys_sphere ball{{0, 0, 0}, 0.2f};
    gphys_transform at{{0.5f, -0.5f, -1}, no_turn, 1};
    const gphys_model_id model = world.model(GPHYS_SHAPE_SPHERE, &ball, &at);
    const gphys_body_id cloth = world.cloth({0, 0, 0}, {1, 0, 0}, {0, -1, 0}, 41, 41, point_mass(0.01f, 0.5f, 0));
    REQUIRE(gphys_solver_set_pinned(world.solver, cloth, 0, 41, 1) == GPHYS_OK);
    double peak = 0;
    for (int i = 0; i < 40; ++i) {
        at.position.z += 2.0f / 60;  // 2 m/s
        REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
        world.step(1.0f / 60);
        const std::vector<gphys_vec3> positions = world.positions(cloth);
        peak = std::max(peak, Stretch(positions, 41, 0.025).most);
        for (const gphys_vec3& p : positions) {
            REQUIRE(distance(widen(p), widen(at.position)) >= 0.21 - 1e-6);
            // In front of the ball, not behind it.
            if (std::hypot(p.x - 0.5, p.y + 0.5) < 0.15) REQUIRE(p.z > at.position.z);
        }
    }
    figure("ball into a sheet, peak stretch", peak * 100, "%");
    CHECK(peak <= 0.15);
}

TEST_CASE("a rope that falls over a post and is held by friction does not stay stretched") {
    World world;
    const gphys_capsule post{{-1, 1, 0}, {1, 1, 0}, 0.1f};
    world.model(GPHYS_SHAPE_CAPSULE, &post);
    gphys_body_desc desc = point_mass(0.02f, 0.5f, 0);
    desc.damping = 1;
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 60; ++i) points.push_back({0, 1.5f, -0.7f + 0.025f * static_cast<float>(i)});
    const gphys_body_id rope = world.rope(points, 0, desc);
    float peak = 0;
    for (int i = 0; i < 300; ++i) {
        world.step(1.0f / 60);
        peak = std::max(peak, world.stats().strain_max);
        for (const gphys_vec3& p : world.positions(rope)) {
            // Outside of the post grown by the radius, less the rounding of float32 output.
            REQUIRE(std::hypot(p.y - 1.0, static_cast<double>(p.z)) >= 0.12 - 1e-6);
        }
    }
    const float stays = world.stats().strain_max;
    figure("rope over a post, peak strain", static_cast<double>(peak) * 100, "%");
    figure("rope over a post, strain at the end", static_cast<double>(stays) * 100, "%");
    CHECK(world.stats().contact_count > 5);
    CHECK(peak <= 0.01f);
    CHECK(stays <= 0.002f);
}

TEST_CASE("the same calls give the same bits, with contacts in order") {
    std::vector<gphys_vec3> results[2];
    for (auto& result : results) {
        World world;
        const gphys_plane floor{{0, 1, 0}, 0}, tilted{{1, 1, 0}, -0.2f};
        world.model(GPHYS_SHAPE_PLANE, &floor);
        world.model(GPHYS_SHAPE_PLANE, &tilted);
        const gphys_body_id cloth = world.cloth({-0.2f, 0.5f, 0}, {1, 0, 0}, {0, 0, 1}, 12, 12);
        for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
        result = world.positions(cloth);
        std::vector<gphys_contact> contacts(1000);
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_contacts(world.solver, contacts.data(), 1000, &total) == GPHYS_OK);
        CHECK(total == world.stats().contact_count);
        CHECK(total > 0);
        for (uint32_t i = 1; i < total; ++i) {
            const gphys_contact &a = contacts[i - 1], &b = contacts[i];
            CHECK((a.particle < b.particle || (a.particle == b.particle && a.model < b.model)));
        }
    }
    CHECK(std::memcmp(results[0].data(), results[1].data(), results[0].size() * sizeof(gphys_vec3)) == 0);
}

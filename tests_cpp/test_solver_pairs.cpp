// Pairs of particles that touch, against the laws of impact and friction: which of them collide, how far apart
// they stay, and what they do to each other beside models.
#include "solver_world.h"

using gphys::Vec3;
using test::figure;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f);

gphys_body_desc sphere(float radius, float mass, uint32_t body_layers = 1) {
    gphys_body_desc desc = World::body_desc();
    desc.radius = radius;
    desc.mass = mass;
    desc.body_layers = body_layers;
    desc.friction = 0;
    return desc;
}

Vec3 velocity(const World& world, gphys_body_id body, uint32_t particle = 0) {
    return gphys::widen(world.velocities(body)[particle]);
}

/// A sphere of 100 m whose top is at the origin: a floor that is a particle.
gphys_body_id hill(World& world, gphys_body_desc desc) {
    desc.radius = 100;
    const gphys_body_id body = world.particles({{0, -100, 0}}, desc);
    world.pin(body, 0);
    return body;
}

void add_floor(World& world) {
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
}

}  // namespace

TEST_CASE("spheres of unequal size meet where they touch, and bounce by the mean of their restitutions") {
    const bool large_first = GENERATE(true, false);
    World world(64, {0, 0, 0});
    const float radii[2] = {large_first ? 0.3f : 0.05f, large_first ? 0.05f : 0.3f};
    gphys_body_desc desc = sphere(radii[0], 2);
    desc.restitution = 0.9f;
    const gphys_body_id a = world.particles({{-1, 0, 0}}, desc);
    desc = sphere(radii[1], 1);
    desc.restitution = 0.4f;
    const gphys_body_id b = world.particles({{1, 0, 0}}, desc);
    world.set_velocity(a, 0, {3, 0, 0});
    for (int i = 0; i < 60; ++i) world.step(dt);
    const double e = std::sqrt(0.36), met = (2 - 0.35) / 3, impulse = (1 + e) * 3 / (1 / 2.0 + 1);
    CHECK(velocity(world, a).x == Approx(3 - impulse / 2).epsilon(1e-6));
    CHECK(velocity(world, b).x == Approx(impulse).epsilon(1e-6));
    // Within the substep they touch until its end: 0.3 ms at 3 m/s.
    CHECK(std::fabs(world.position(b).x - (1 + impulse * (1 - met))) < 2e-3);
    CHECK(std::fabs(world.position(a).x - (-1 + 3 * met + (3 - impulse / 2) * (1 - met))) < 2e-3);
}

TEST_CASE("a particle that slides on another is slowed by the mean of their frictions") {
    World world(8);
    gphys_body_desc desc = sphere(100, 1);
    desc.friction = 0.1f;
    const bool slider_first = GENERATE(true, false);
    gphys_body_desc slider = sphere(0.02f, 1);
    slider.friction = 0.9f;
    gphys_body_id body = 0;
    if (slider_first) body = world.particles({{0, 0.02f, 0}}, slider);
    hill(world, desc);
    if (!slider_first) body = world.particles({{0, 0.02f, 0}}, slider);
    world.set_velocity(body, 0, {2, 0, 0});
    for (int i = 0; i < 18; ++i) world.step(dt);
    const double t = 0.3, mu = 0.3, expected = 2 - mu * g * t;
    // It presses with its weight, less v^2 / 100 m of at most 4 m^2/s^2: 0.4 %.
    CHECK(velocity(world, body).x == Approx(expected).epsilon(0.01));
}

TEST_CASE("what bounces on another comes to rest on it") {
    World world(8);
    gphys_body_desc desc = sphere(100, 1);
    desc.restitution = 0.8f;
    hill(world, desc);
    desc.radius = 0.02f;
    const gphys_body_id body = world.particles({{0, 0.03f, 0}}, desc);
    double fastest = 0;
    for (int i = 0; i < 180; ++i) {
        world.step(dt);
        // Bounces from 1 cm take 0.8 s in all.
        if (i > 90) fastest = std::max(fastest, length(velocity(world, body)));
    }
    figure("speed of what should rest on a particle", fastest, "m/s");
    CHECK(fastest < 1e-3);
    CHECK(std::fabs(world.position(body).y - 0.02) < 2e-4);
}

TEST_CASE("what falls onto another within a single long step is held by it") {
    World world(8);
    hill(world, sphere(100, 1));
    const gphys_body_id body = world.particles({{0, 1, 0}}, sphere(0.02f, 1));
    world.step(0.5f);  // in which it would fall by 1.2 m
    CHECK(world.position(body).y == Approx(0.02).epsilon(1e-3));
}

TEST_CASE("small spheres thrown at a large one do not enter it") {
    const bool large_first = GENERATE(true, false);
    World world(8, {0, 0, 0});
    test::Random random(5);
    std::vector<gphys_vec3> around, inward;
    for (int i = 0; i < 60; ++i) {
        const Vec3 direction = random.direction();
        around.push_back(gphys::narrow(direction));
        inward.push_back(gphys::narrow(direction * -3.0));
    }
    const auto add_large = [&] { world.pin(world.particles({{0, 0, 0}}, sphere(0.5f, 1)), 0); };
    if (large_first) add_large();
    const gphys_body_id small = world.particles(around, sphere(0.01f, 1));
    if (!large_first) add_large();
    REQUIRE(gphys_solver_set_velocities(world.solver, small, 0, 60, inward.data(), 12) == GPHYS_OK);
    double nearest = 1;
    for (int i = 0; i < 40; ++i) {
        world.step(dt);
        for (const gphys_vec3& p : world.positions(small)) nearest = std::min(nearest, length(gphys::widen(p)));
    }
    CHECK(nearest > 0.51 * (1 - 1e-5));
    for (const gphys_vec3& v : world.velocities(small)) CHECK(length(gphys::widen(v)) < 1e-3);
}

TEST_CASE("masks decide pair by pair, also among bodies that others bring together") {
    World world(8, {0, 0, 0});
    const gphys_body_id a = world.particles({{-1, 0, 0}}, sphere(0.1f, 1, 1));
    const gphys_body_id c = world.particles({{1, 0, 0}}, sphere(0.1f, 1, 2));
    const gphys_body_id both = world.particles({{0, 0.25f, 0}}, sphere(0.1f, 1, 3));
    world.set_velocity(a, 0, {4, 0, 0});
    world.set_velocity(c, 0, {-4, 0, 0});
    for (int i = 0; i < 30; ++i) world.step(dt);
    CHECK(world.velocities(a)[0].x == 4);
    CHECK(world.velocities(c)[0].x == -4);
    CHECK(length(velocity(world, both)) == 0);
}

TEST_CASE("spheres that overlap from the beginning are parted by a tenth in each substep") {
    World world(1, {0, 0, 0});
    const gphys_body_id a = world.particles({{0, 0, 0}}, sphere(0.1f, 1));
    const gphys_body_id b = world.particles({{0.05f, 0, 0}}, sphere(0.1f, 3));
    world.step(dt);
    CHECK(world.position(b).x - world.position(a).x == Approx(0.05 + 0.1 * 0.2).epsilon(1e-5));
    // By their inverse masses.
    CHECK(world.position(a).x == Approx(-0.02 * 3 / 4).epsilon(1e-5));
    for (int i = 0; i < 10; ++i) world.step(dt);
    CHECK(world.position(b).x - world.position(a).x > 0.2 * (1 - 1e-5));
}

TEST_CASE("of one body those do not collide that a link holds within touch, or that were placed so") {
    gphys_body_desc desc = sphere(0.04f, 1, 0);
    desc.self_collision = 1;
    desc.layers = 0;
    {
        World world(8, {0, 0, 0});  // placed 0.1 m apart, drawn to 0.05 m by their link
        const gphys_body_id pair = world.particles({{0, 0, 0}, {0.1f, 0, 0}}, desc);
        gphys_constraint_id id = 0;
        REQUIRE(gphys_solver_add_distance(world.solver, pair, 0, 1, 0.05f, 0, &id) == GPHYS_OK);
        desc.damping = 5;
        for (int i = 0; i < 60; ++i) world.step(dt);
        CHECK(distance(world.position(pair, 0), world.position(pair, 1)) == Approx(0.05).epsilon(1e-5));
    }
    World world(8);  // neighbours but one are within touch
    desc.radius = 0.06f;
    Vec3 end[2];
    for (int k = 0; k < 2; ++k) {
        desc.self_collision = k == 0;
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 11; ++i) points.push_back({static_cast<float>(5 * k), -0.05f * static_cast<float>(i), 0});
        const gphys_body_id rope = world.rope(points, 0, desc);
        world.pin(rope, 0);
        for (int i = 0; i < 60; ++i) world.step(dt);
        end[k] = world.position(rope, 10) - Vec3{5.0 * k, 0, 0};
        CHECK(world.stats(rope).strain_max < 1e-6f);
    }
    CHECK(distance(end[0], end[1]) < 1e-6);
}

TEST_CASE("a heavy sphere rests on a light one that a floor carries") {
    const bool heavy_first = GENERATE(true, false);
    World world(8);
    add_floor(world);
    gphys_body_id light = 0, heavy = 0;
    if (heavy_first) heavy = world.particles({{0, 0.16f, 0}}, sphere(0.05f, 100));
    light = world.particles({{0, 0.05f, 0}}, sphere(0.05f, 1));
    if (!heavy_first) heavy = world.particles({{0, 0.16f, 0}}, sphere(0.05f, 100));
    double lowest = 1, nearest = 1;
    for (int i = 0; i < 60; ++i) {
        world.step(dt);
        lowest = std::min(lowest, world.position(light).y);
        nearest = std::min(nearest, world.position(heavy).y - world.position(light).y);
    }
    figure("nearest, heavy on light", nearest / 0.1, "diameters");
    CHECK(lowest > 0.05 * (1 - 1e-4));
    CHECK(nearest > 0.1 * 0.999);
    CHECK(length(velocity(world, heavy)) < 1e-2);
    CHECK(length(velocity(world, light)) < 1e-2);
}

TEST_CASE("no sphere is pushed through a wall by another, nor cloth through a floor") {
    World world(4, {0, 0, 0});
    const gphys_aabb wall{{0, -2, -2}, {0.01f, 2, 2}};
    world.model(GPHYS_SHAPE_AABB, &wall);
    const gphys_body_id light = world.particles({{-0.06f, 0, 0}}, sphere(0.05f, 0.01f));
    const gphys_body_id heavy = world.particles({{-3, 0, 0}}, sphere(0.05f, 100));
    world.set_velocity(heavy, 0, {100, 0, 0});
    for (int i = 0; i < 10; ++i) {
        world.step(dt);
        CHECK(world.position(light).x < -0.05 * (1 - 1e-4));
    }
    World sheet_world(8);
    add_floor(sheet_world);
    const gphys_body_id sheet =
        sheet_world.cloth({-0.2f, 0.021f, -0.2f}, {0.4f, 0, 0}, {0, 0, 0.4f}, 11, 11, sphere(0.018f, 0.1f));
    const gphys_body_id stone = sheet_world.particles({{0.01f, 0.6f, 0.01f}}, sphere(0.1f, 20));
    double lowest = 1;
    for (int i = 0; i < 60; ++i) {
        sheet_world.step(dt);
        for (const gphys_vec3& p : sheet_world.positions(sheet)) lowest = std::min(lowest, static_cast<double>(p.y));
    }
    figure("lowest of a sheet between a stone and a floor", lowest / static_cast<double>(0.018f), "radii");
    CHECK(lowest > static_cast<double>(0.018f) * 0.999);
    CHECK(sheet_world.position(stone).y > 0.1);
}

TEST_CASE("what flies on a slack string is hit as what flies free") {
    World world(8, {0, 0, 0});
    gphys_body_desc desc = sphere(0.05f, 4);
    desc.restitution = 1;
    const gphys_body_id pair = world.particles({{0, 0, 0}, {0, 1, 0}}, desc);
    gphys_constraint_id id = 0;
    REQUIRE(gphys_solver_add_max_distance(world.solver, pair, 0, 1, 5, 0, &id) == GPHYS_OK);
    desc.mass = 1;
    const gphys_body_id ball = world.particles({{-0.5f, 0, 0}}, desc);
    world.set_velocity(ball, 0, {3, 0, 0});
    for (int i = 0; i < 30; ++i) world.step(dt);
    CHECK(velocity(world, pair, 0).x == Approx(2).epsilon(1e-5));  // 2 m v / (m + M), with M = 2
    CHECK(velocity(world, ball).x == Approx(-1).epsilon(1e-5));    // (m - M) v / (m + M)
    CHECK(length(velocity(world, pair, 1)) < 1e-6);
}

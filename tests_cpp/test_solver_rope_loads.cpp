// Balls and rigid clusters that are much heavier than the ropes they press on.
#include <algorithm>
#include <cmath>

#include "solver_world.h"

namespace {

using test::colliding;
using test::figure;
using test::World;

constexpr float frame = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f);

/// Two parallel ropes of 2 m at a height of 1 m, pinned at their ends.
void span(World& world, float mass, float apart, float friction = 0.5f) {
    gphys_body_desc desc = colliding(mass, 0.02f);
    desc.friction = friction;
    for (const float z : {-apart / 2, apart / 2}) {
        const gphys_body_id rope = world.rope(test::line({-1, 1, z}, {0.05f, 0, 0}, 41), 0, desc);
        for (const uint32_t end : {0u, 40u}) world.pin(rope, end);
    }
}

gphys_body_id crate(World& world, float height, float mass) {
    std::vector<gphys_vec3> places;
    std::vector<uint32_t> all;
    for (int i = 0; i < 27; ++i) {
        const auto at = [](int k) { return 0.1f * static_cast<float>(k - 1); };
        places.push_back({at(i % 3), height + at(i / 3 % 3), at(i / 9)});
        all.push_back(static_cast<uint32_t>(i));
    }
    const gphys_body_id body = world.particles(places, colliding(mass, 0.045f));
    gphys_cluster_id id = 0;
    REQUIRE(gphys_solver_add_cluster(world.solver, body, all.data(), 27, &id) == GPHYS_OK);
    return body;
}

struct Fall {
    double gained = 0, strain = 0;  // joules, of the energy at the beginning; of the ropes
};

Fall run(World& world, int steps) {
    Fall fall;
    const double energy = world.energy();
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        fall.gained = std::max(fall.gained, world.energy() - energy);
        fall.strain = std::max(fall.strain, static_cast<double>(world.stats().strain_max));
    }
    return fall;
}

/// N s, downwards: of body b on others in the last step.
double weight(const World& world, gphys_body_id body) {
    std::vector<gphys_body_contact> contacts(1000);
    uint32_t count = 0;
    REQUIRE(gphys_solver_get_body_contacts(world.solver, contacts.data(), 1000, &count) == GPHYS_OK);
    double sum = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const gphys_body_contact& contact = contacts[i];
        const double impulse = static_cast<double>(contact.impulse) * static_cast<double>(contact.normal.y);
        sum += contact.body_b == body ? impulse : contact.body_a == body ? -impulse : 0;
    }
    return sum;
}

}  // namespace

TEST_CASE("Two taut ropes carry a ball of 50 times their mass", "[simulation]") {
    const auto check = [](uint32_t substeps, double most_strain) {
        World world(substeps);
        span(world, 0.1f, 0.14f);
        const gphys_body_id ball = world.particles({{0, 1.3f, 0}}, colliding(10, 0.1f));
        const double energy = world.energy();
        const Fall fall = run(world, 240);
        INFO(substeps << " substeps");
        figure("strain", 100 * fall.strain, "%");
        // With contacts and links one after the other, the ball falls through: a strain of 30 to 50 %.
        CHECK(fall.strain < most_strain);
        CHECK(fall.gained < 1e-4 * energy);
        CHECK(world.position(ball).y > 1.05);
    };
    check(2, 0.05);
    check(4, 0.02);
    check(8, 0.002);
    check(16, 0.002);
}

TEST_CASE("Ropes carry the weight of what lies on them") {
    World world;
    // Friction is not in the impulses of contacts.
    span(world, 0.1f, 0.14f, 0);
    const gphys_body_id ball = world.particles({{0, 1.11f, 0}}, colliding(10, 0.1f));
    run(world, 240);
    double impulse = 0;
    constexpr int steps = 60;
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        impulse += weight(world, ball);
    }
    const double expected = 10 * g * static_cast<double>(frame) * steps;
    figure("error of the weight", 100 * (impulse / expected - 1), "%");
    // The ball still trembles by less than a thousandth of its weight.
    CHECK(std::fabs(impulse / expected - 1) < 1e-3);
}

TEST_CASE("Two taut ropes carry a crate of ten times their mass", "[simulation]") {
    const auto check = [](uint32_t substeps, double most_strain) {
        World world(substeps);
        span(world, 0.1f, 0.24f);
        const gphys_body_id body = crate(world, 1.4f, 2);
        const double energy = world.energy();
        const Fall fall = run(world, 240);
        INFO(substeps << " substeps");
        figure("strain", 100 * fall.strain, "%");
        // Otherwise 42 % at 8 substeps, 106 % at 4, and at 2 it is thrown.
        CHECK(fall.strain < most_strain);
        CHECK(fall.gained < 1e-4 * energy);
        CHECK(world.position(body, 13).y > 1);
    };
    check(2, 0.05);
    check(4, 0.02);
    check(8, 0.002);
}

TEST_CASE("A free rope and a heavy ball that hits it keep their momentum, and gain no energy") {
    World world(8, {0, 0, 0});
    const gphys_body_id rope = world.rope(test::line({-1, 0, 0}, {0.05f, 0, 0}, 41), 0, colliding(0.2f, 0.02f));
    const gphys_body_id ball = world.particles({{0.3f, 0.3f, 0}}, colliding(2, 0.1f));
    world.set_velocity(ball, 0, {0, -3, 0});
    const double energy = world.energy();
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        gphys::Vec3 momentum = gphys::widen(world.velocities(ball)[0]) * 2;
        for (const gphys_vec3& v : world.velocities(rope)) momentum += gphys::widen(v) * (0.2 / 41);
        CHECK(std::fabs(momentum.x) < 1e-5);
        CHECK(std::fabs(momentum.y + 6) < 1e-5);
        CHECK(world.energy() < energy * (1 + 1e-6));
    }
    CHECK(world.velocities(ball)[0].y > -2.9f);
}

TEST_CASE("A heavy ball slides along ropes without friction, and is held with it", "[simulation]") {
    const auto way = [](float friction) {
        World world;
        gphys_body_desc desc = colliding(1, 0.01f);
        desc.friction = friction;
        for (const float z : {-0.05f, 0.05f}) {
            const gphys_body_id rope = world.rope(test::line({-3, 3, z}, {0.02f, -0.02f / 3, 0}, 301), 0, desc);
            for (const uint32_t end : {0u, 300u}) world.pin(rope, end);
        }
        gphys_body_desc of_ball = colliding(20, 0.1f);
        of_ball.friction = friction;
        const gphys_body_id ball = world.particles({{-2, 2.8f, 0}}, of_ball);
        run(world, 60);
        CHECK(world.position(ball).y > 2.3);
        return world.position(ball).x + 2;
    };
    const double slope = std::atan2(1.0, 3.0), free = g * std::sin(slope) * std::cos(slope) / 2;
    const double slid = way(0), held = way(0.5f);
    figure("way without friction", slid / free, "of that on a slope");
    figure("way with friction", held, "m");
    // The ball lies in the sag that its weight makes, and rolls over the particles of the ropes.
    CHECK(slid > 0.4 * free);
    CHECK(held < 0.05);
}

TEST_CASE("A hook lifts a crate in two slings", "[simulation]") {
    for (const uint32_t substeps : {2u, 4u, 8u}) {
        World world(substeps);
        const gphys_plane floor = {{0, 1, 0}, 0};
        world.model(GPHYS_SHAPE_PLANE, &floor);
        const gphys_sphere hook = {{0, 0, 0}, 0.05f};
        gphys_transform place = {{0, 2, 0}, {0, 0, 0, 1}, 1};
        const gphys_model_id model = world.model(GPHYS_SHAPE_SPHERE, &hook, &place);
        const gphys_body_id body = crate(world, 0.3f, 10);
        for (const float z : {-0.05f, 0.05f}) {
            // From the hook down one side of the crate, below it, and up the other side.
            std::vector<gphys_vec3> places;
            for (int i = 0; i <= 80; ++i) {
                const float way = 0.045f * static_cast<float>(i) - 1.8f, beyond = std::fabs(way) - 0.25f;
                const float x = beyond < 0 ? way : std::copysign(0.25f * (1 - beyond / 1.55f), way);
                places.push_back({x, 0.1f + 1.9f * std::max(beyond, 0.0f) / 1.55f, z});
            }
            gphys_body_desc desc = colliding(0.5f, 0.02f);
            desc.layers = 0;
            const gphys_body_id sling = world.rope(places, 0, desc);
            const gphys_vec3 middle = {0, 0, 0};
            for (const uint32_t end : {0u, 80u})
                REQUIRE(gphys_solver_attach(world.solver, world.scene, sling, end, model, &middle) == GPHYS_OK);
        }
        for (int i = 0; i < 240; ++i) {
            place.position.y = 2 + 0.5f * static_cast<float>(std::min(i, 180)) / 60;
            REQUIRE(gphys_scene_set_transform(world.scene, model, &place) == GPHYS_OK);
            world.step(frame);
        }
        INFO(substeps << " substeps");
        figure("height of the crate", world.position(body, 13).y, "m");
        CHECK(world.position(body, 13).y > 1.2);
        CHECK(std::fabs(world.position(body, 13).x) < 0.2);
    }
}

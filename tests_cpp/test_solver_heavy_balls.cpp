// Heavy balls on light cloth: nets, trampolines, and cloth in free flight.
#include <algorithm>
#include <cmath>

#include "solver_world.h"

namespace {

using gphys::Vec3;
using test::colliding;
using test::World;

constexpr float frame = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f);

/// A square sheet in the plane y = 0 around the origin, and how far its sides are stretched.
struct Sheet {
    World& world;
    uint32_t side;
    double width;
    gphys_body_id body;

    Sheet(World& world_, uint32_t side_, float width_, const gphys_body_desc& desc)
        : world(world_),
          side(side_),
          width(static_cast<double>(width_)),
          body(world_.cloth({-width_ / 2, 0, -width_ / 2}, {width_, 0, 0}, {0, 0, width_}, side_, side_, desc)) {}
    void pin_edges() const {
        for (uint32_t i = 0; i < side; ++i) {
            for (const uint32_t p : {i, side * (side - 1) + i, side * i, side * i + side - 1}) world.pin(body, p);
        }
    }
    double stretch() const {
        const std::vector<gphys_vec3> at = world.positions(body);
        const double rest = width / (side - 1);
        double most = 0;
        for (uint32_t row = 0; row < side; ++row) {
            for (uint32_t i = 0; i + 1 < side; ++i) {
                for (const auto& [a, b] :
                     {std::pair(row * side + i, row * side + i + 1), std::pair(i * side + row, (i + 1) * side + row)})
                    most = std::max(most, distance(gphys::widen(at[a]), gphys::widen(at[b])) / rest - 1);
            }
        }
        return most;
    }
};

/// What a ball that falls onto a sheet does until the end of `frames`.
struct Fall {
    double stretch = 0, aside = 0, highest = -10, deepest = 10, gained = 0;

    Fall(const Sheet& sheet, gphys_body_id ball, double touching, int frames) {
        World& world = sheet.world;
        const double energy = world.energy();
        bool touched = false;
        for (int i = 0; i < frames; ++i) {
            world.step(frame);
            const Vec3 at = world.position(ball);
            stretch = std::max(stretch, sheet.stretch());
            aside = std::max(aside, std::hypot(at.x, at.z));
            gained = std::max(gained, world.energy() - energy);
            deepest = std::min(deepest, at.y - touching);
            touched = touched || at.y < touching;
            if (touched) highest = std::max(highest, at.y - touching);
        }
        test::figure("peak stretch", 100 * stretch, "%");
        test::figure("farthest aside", aside, "m");
        test::figure("rebound", highest, "m");
        test::figure("deepest", deepest, "m");
    }
};

}  // namespace

TEST_CASE("A net of 1 kg catches a ball of 1 kg", "[simulation]") {
    World world;
    const Sheet net(world, 40, 4, colliding(1, 0.01f));
    net.pin_edges();
    const gphys_body_id ball = world.particles({{0, 0.71f, 0}}, colliding(1, 0.2f));
    const Fall fall(net, ball, 0.21, 240);
    // Links are relaxed to 2 % in each substep.
    CHECK(fall.stretch < 0.021);
    // A tenth of the distance between two particles. The net is symmetric but for the order of its chains.
    CHECK(fall.aside < 0.01);
    // Nothing is elastic: it does not leave the net, except for the gap that contacts keep, 2 % of the radii.
    CHECK(fall.highest < 0.02 * 0.21);
    // It sinks by 0.06 m; by 0.16 m if the links are swept once.
    CHECK(fall.deepest > -0.1);
    // A float32 of the sum of energies.
    CHECK(fall.gained < 1e-5 * 7);
    CHECK(net.stretch() < 0.005);
}

TEST_CASE("A trampoline of 5 kg stops a ball of 60 kg", "[simulation]") {
    World world;
    const Sheet sheet(world, 20, 3, colliding(5, 0.02f));
    sheet.pin_edges();
    const gphys_body_id ball = world.particles({{0, 1.32f, 0}}, colliding(60, 0.3f));
    const Fall fall(sheet, ball, 0.32, 240);
    CHECK(fall.stretch < 0.021);
    CHECK(fall.aside < 0.016);
    CHECK(fall.highest < 0.02 * 0.32);
    CHECK(fall.deepest > -0.4);
}

TEST_CASE("Heaps of twenty balls of 1 kg stay in a net of 1 kg", "[simulation]") {
    World world;
    const Sheet net(world, 40, 4, colliding(1, 0.01f));
    net.pin_edges();
    gphys_body_desc desc = colliding(20, 0.2f);
    desc.self_collision = 1;
    // Four towers of five, slightly askew.
    std::vector<gphys_vec3> places;
    for (int i = 0; i < 20; ++i) {
        const float askew = 0.004f * static_cast<float>(i * 7 % 10);
        places.push_back({-0.6f + 0.45f * static_cast<float>(i % 2) + askew, 0.71f + 0.45f * static_cast<float>(i / 4),
                          -0.3f + 0.45f * static_cast<float>(i / 2 % 2) - askew});
    }
    const gphys_body_id balls = world.particles(places, desc);
    double most = 0, lowest = 1;
    for (int i = 0; i < 240; ++i) {
        world.step(frame);
        most = std::max(most, net.stretch());
        for (const gphys_vec3& p : world.positions(balls)) lowest = std::min(lowest, static_cast<double>(p.y));
    }
    test::figure("peak stretch", 100 * most, "%");
    // Of five heaps the worst stretched a link by 4.7 %; if relaxation moves loaded particles, the best by 7.7 %.
    CHECK(most < 0.06);
    CHECK(net.stretch() < 0.02);
    // The net sinks by less than the radius of a ball. If the balls fell through, they would be below its plane.
    CHECK(lowest > 0);
}

TEST_CASE("A heavy ball that flies into a free sheet keeps the momentum of both, and adds no energy") {
    World world(8, {0, 0, 0});
    const Sheet sheet(world, 20, 2, colliding(0.5f, 0.01f));
    const gphys_body_id ball = world.particles({{0.02f, 0.3f, 0.03f}}, colliding(2, 0.2f));
    world.set_velocity(ball, 0, {0, -3, 0});
    const double energy = world.energy();
    double worst = 0, gained = 0, stretch = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        Vec3 momentum = gphys::widen(world.velocities(ball)[0]) * 2;
        for (const gphys_vec3& v : world.velocities(sheet.body)) momentum += gphys::widen(v) * (0.5 / 400);
        worst = std::max(worst, length(momentum - Vec3{0, -6, 0}) / 6);
        gained = std::max(gained, world.energy() - energy);
        stretch = std::max(stretch, sheet.stretch());
    }
    test::figure("largest error of the momentum", worst, "of it");
    test::figure("peak stretch", 100 * stretch, "%");
    // Float32 velocities of 400 particles in 480 substeps: 2^-24 each, and some relative to larger speeds.
    CHECK(worst < 1e-3);
    CHECK(gained < 1e-5 * 9);
    CHECK(stretch < 0.02);
    CHECK(world.energy() < 0.95 * energy);  // the ball has pushed the sheet along
}

TEST_CASE("A ball at rest in a net presses on it with its weight", "[simulation]") {
    World world;
    const Sheet net(world, 40, 4, colliding(1, 0.01f));
    net.pin_edges();
    gphys_body_desc desc = colliding(1, 0.2f);
    desc.damping = 1;
    const gphys_body_id ball = world.particles({{0, 0.22f, 0}}, desc);
    for (int i = 0; i < 240; ++i) world.step(frame);
    double impulse = 0;
    constexpr int frames = 60;
    for (int i = 0; i < frames; ++i) {
        world.step(frame);
        uint32_t total = 0;
        gphys_solver_get_body_contacts(world.solver, nullptr, 0, &total);
        std::vector<gphys_body_contact> list(total);
        REQUIRE(gphys_solver_get_body_contacts(world.solver, list.data(), total, &total) == GPHYS_OK);
        for (const gphys_body_contact& contact : list) {
            const double up =
                contact.body_b == ball ? static_cast<double>(contact.normal.y) : -static_cast<double>(contact.normal.y);
            impulse += static_cast<double>(contact.impulse) * up;
        }
    }
    const double part = impulse / (g * frames * static_cast<double>(frame));
    test::figure("impulse", part, "of its weight");
    CHECK(part == Approx(1).margin(0.1));
}

TEST_CASE("Heavy balls on a rug on the floor stay slow and near", "[simulation]") {
    const auto check = [](double mass, float radius, float gap, int side, double fastest_allowed) {
        World world;
        const gphys_plane floor = {{0, 1, 0}, 0};
        world.model(GPHYS_SHAPE_PLANE, &floor);
        constexpr float thickness = 0.018f;
        const gphys_body_id rug =
            world.cloth({-0.5f, thickness, -0.5f}, {1, 0, 0}, {0, 0, 1}, 26, 26, colliding(1, thickness));
        std::vector<gphys_vec3> places;
        for (int i = 0; i < side * side; ++i) {
            const auto at = [&](int k) { return gap * (static_cast<float>(k) - static_cast<float>(side - 1) / 2); };
            places.push_back({at(i % side), 2 * thickness + radius + 0.004f, at(i / side)});
        }
        const gphys_body_id balls = world.particles(places, colliding(static_cast<float>(mass * side * side), radius));
        double fastest = 0, farthest = 0;
        for (int i = 0; i < 400; ++i) {
            world.step(frame);
            for (const gphys_body_id body : {rug, balls}) {
                for (const gphys_vec3& v : world.velocities(body)) fastest = std::max(fastest, length(gphys::widen(v)));
                for (const gphys_vec3& p : world.positions(body))
                    farthest = std::max(farthest, length(gphys::widen(p)));
            }
        }
        test::figure("fastest", fastest, "m/s");
        test::figure("farthest", farthest, "m");
        CHECK(fastest < fastest_allowed);
        CHECK(farthest < 2);
    };
    // Corners of the rug are 0.71 m from its middle. Balls fall by 4 mm.
    SECTION("one of 5 kg") { check(5, 0.03f, 0, 1, 2); }
    SECTION("four of 5 kg") { check(5, 0.02f, 0.08f, 2, 2); }
    SECTION("25 of 0.8 kg") { check(0.8, 0.05f, 0.12f, 5, 5); }
}

TEST_CASE("Balls in a net fall asleep", "[simulation]") {
    gphys_solver_desc desc = World::desc();
    desc.sleep_speed = 0.05f;
    World world(desc);
    const Sheet net(world, 40, 4, colliding(1, 0.01f));
    net.pin_edges();
    world.particles({{-0.7f, 0.25f, -0.7f}, {0.7f, 0.25f, 0.6f}}, colliding(2, 0.2f));
    uint32_t asleep = 0;
    for (int i = 0; i < 600 && asleep < 2; ++i) {
        world.step(frame);
        gphys_solver_get_sleeping(world.solver, nullptr, 0, &asleep);
    }
    CHECK(asleep == 2);
}

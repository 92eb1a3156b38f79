// What lies on cloth that lies on a model, and rigid clusters in nets: weights, rest and energy.
#include <algorithm>
#include <cmath>

#include "solver_world.h"

namespace {

using test::colliding;
using test::figure;
using test::World;

constexpr float frame = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f);

/// A square cloth around the origin that lies on the plane y = 0.
gphys_body_id rug(World& world, uint32_t side, float width, float mass) {
    const gphys_plane floor = {{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const float radius = 0.45f * width / static_cast<float>(side - 1);
    return world.cloth({-width / 2, radius, -width / 2}, {width, 0, 0}, {0, 0, width}, side, side,
                       colliding(mass, radius));
}

/// side * side balls in a square, at one height.
gphys_body_id balls(World& world, int side, float gap, float radius, float mass, float height) {
    std::vector<gphys_vec3> places;
    for (int i = 0; i < side * side; ++i) {
        const auto at = [&](int k) { return gap * (static_cast<float>(k) - static_cast<float>(side - 1) / 2); };
        places.push_back({at(i % side) + 0.003f, height, at(i / side) + 0.002f});
    }
    gphys_body_desc desc = colliding(mass * static_cast<float>(side * side), radius);
    desc.self_collision = 1;
    return world.particles(places, desc);
}

double distance(gphys_vec3 a, gphys_vec3 b) { return gphys::distance(gphys::widen(a), gphys::widen(b)); }

/// The largest of the sides of the cells of a square cloth.
double strain_of_sides(const std::vector<gphys_vec3>& places, uint32_t side, double rest) {
    double strain = 0;
    for (uint32_t i = 0; i < side * side; ++i) {
        for (const uint32_t next : {i + 1, i + side}) {
            if (next < side * side && (next != i + 1 || next % side != 0))
                strain = std::max(strain, std::fabs(distance(places[i], places[next]) / rest - 1));
        }
    }
    return strain;
}

/// The part of the diagonals of a square cloth's cells that are stretched by more than a tenth.
double part_of_stretched_diagonals(const std::vector<gphys_vec3>& places, uint32_t side, double rest) {
    uint32_t stretched = 0;
    const double most = 1.1 * std::sqrt(2.0) * rest;
    for (uint32_t i = 0; i + side < side * side; ++i) {
        if (i % side == side - 1) continue;
        stretched += distance(places[i], places[i + side + 1]) > most;
        stretched += distance(places[i + 1], places[i + side]) > most;
    }
    return stretched / (2.0 * (side - 1) * (side - 1));
}

/// A net in the plane y = 0, pinned at its edges, and a rigid cluster of five that falls into it.
struct Net {
    World world;
    gphys_body_id net, cluster;

    Net(float mass, float speed, float max_strain) : world(desc(max_strain)) {
        constexpr uint32_t side = 41;
        gphys_body_desc of_net = colliding(1, 0.045f);
        of_net.cloth_flags = 0;
        net = world.cloth({-2, 0, -2}, {4, 0, 0}, {0, 0, 4}, side, side, of_net);
        for (uint32_t i = 0; i < side; ++i) {
            for (const uint32_t p : {i, side * (side - 1) + i, side * i, side * i + side - 1}) world.pin(net, p);
        }
        cluster =
            world.particles({{-0.15f, 0.2f, 0}, {0.15f, 0.2f, 0}, {0, 0.2f, -0.15f}, {0, 0.2f, 0.15f}, {0, 0.25f, 0}},
                            colliding(mass, 0.06f));
        const uint32_t all[] = {0, 1, 2, 3, 4};
        gphys_cluster_id id = 0;
        REQUIRE(gphys_solver_add_cluster(world.solver, cluster, all, 5, &id) == GPHYS_OK);
        for (const uint32_t p : all) world.set_velocity(cluster, p, {0, -speed, 0});
    }
    static gphys_solver_desc desc(float max_strain) {
        gphys_solver_desc out = World::desc();
        out.max_strain = max_strain;
        return out;
    }
};

float lowest(const std::vector<gphys_vec3>& places) {
    float out = places[0].y;
    for (const gphys_vec3& at : places) out = std::min(out, at.y);
    return out;
}

double farthest_apart(const std::vector<gphys_vec3>& a, const std::vector<gphys_vec3>& b) {
    double most = 0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(gphys::widen(a[i]), gphys::widen(b[i])));
    return most;
}

}  // namespace

TEST_CASE("A floor carries a cloth and what lies on it, and all come to rest", "[simulation]") {
    const auto check = [](float cloth_mass, int side, float gap, float radius, float mass, int frames) {
        World world;
        const gphys_body_id cloth = rug(world, 26, 1, cloth_mass);
        const gphys_body_id loads = balls(world, side, gap, radius, mass, 0.04f + radius);
        double gained = 0;
        const double energy = world.energy();
        for (int i = 0; i < frames; ++i) {
            world.step(frame);
            gained = std::max(gained, world.energy() - energy);
        }
        const std::vector<gphys_vec3> places = world.positions(loads), of_cloth = world.positions(cloth);
        // What sleeps gives no impulses.
        gphys_solver_settings settings{};
        REQUIRE(gphys_solver_get_settings(world.solver, &settings) == GPHYS_OK);
        settings.sleep_time = 0;
        REQUIRE(gphys_solver_set_settings(world.solver, &settings) == GPHYS_OK);
        double impulse = 0;
        for (int i = 0; i < 60; ++i) {
            world.step(frame);
            for (const gphys_impulse& given : test::impulses(world)) impulse -= static_cast<double>(given.linear.y);
        }
        const double weight = g * static_cast<double>(cloth_mass + mass * static_cast<float>(side * side));
        figure("floor carries", impulse / weight, "of the weight");
        figure("in a second, loads move by", 1000 * farthest_apart(places, world.positions(loads)), "mm");
        figure("in a second, cloth moves by", 1000 * farthest_apart(of_cloth, world.positions(cloth)), "mm");
        figure("stretch", 100 * static_cast<double>(world.stats(cloth).strain_max), "%");
        CHECK(impulse == Approx(weight).epsilon(0.005));
        CHECK(farthest_apart(places, world.positions(loads)) < 1e-3);
        CHECK(farthest_apart(of_cloth, world.positions(cloth)) < 1e-3);
        CHECK(world.stats(cloth).strain_max < 0.03f);
        CHECK(lowest(world.positions(loads)) > radius + 0.01f);  // on the cloth, not between its particles
        CHECK(gained < 1e-5 * weight);
    };
    SECTION("marbles") { check(0.4f, 5, 0.06f, 0.02f, 0.04f, 600); }
    SECTION("a ball of five times its mass") { check(1, 1, 0, 0.1f, 5, 600); }
    SECTION("the same between four particles") { check(1, 1, 0, 0.03f, 5, 600); }
}

TEST_CASE("A lift carries a cloth and a ball of fifty times its mass, and adds no energy in its frame",
          "[simulation]") {
    constexpr uint32_t side = 26;
    constexpr float mass = 0.4f, ball_mass = 20, radius = 0.1f, thickness = 0.018f, speed = 1;
    World world;
    const gphys_model_id lift = world.box({2, 0.5f, 2}, {0, -0.5f, 0});
    const gphys_body_id cloth =
        world.cloth({-0.5f, thickness, -0.5f}, {1, 0, 0}, {0, 0, 1}, side, side, colliding(mass, thickness));
    const gphys_body_id ball = world.particles({{0.003f, 0.04f + radius, 0.002f}}, colliding(ball_mass, radius));
    for (uint32_t p = 0; p < side * side; ++p) world.set_velocity(cloth, p, {0, speed, 0});
    world.set_velocity(ball, 0, {0, speed, 0});
    double first = 0, gained = 0;
    for (int i = 1; i <= 240; ++i) {
        const float height = speed * frame * static_cast<float>(i);
        const gphys_transform there{{0, height - 0.5f, 0}, {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transform(world.scene, lift, &there) == GPHYS_OK);
        world.step(frame);
        double energy = 0;
        const auto add = [&](gphys_body_id body, double mass_of_each) {
            const std::vector<gphys_vec3> at = world.positions(body), velocity = world.velocities(body);
            for (size_t p = 0; p < at.size(); ++p) {
                const gphys::Vec3 own = gphys::widen(velocity[p]) - gphys::Vec3{0, speed, 0};
                const double rise = static_cast<double>(at[p].y) - static_cast<double>(height);
                energy += mass_of_each * (length_squared(own) / 2 + g * rise);
            }
        };
        add(cloth, static_cast<double>(mass) / (side * side));
        add(ball, static_cast<double>(ball_mass));
        if (i == 1) first = energy;
        gained = std::max(gained, energy - first);
    }
    figure("gain", gained, "J");
    // The rounding of 4 m to floats: 20 kg * g * 2^-22 m. With the energy of a frame at rest, 2e-3 J.
    CHECK(gained < 1e-4);
    const double height = static_cast<double>(world.positions(ball)[0].y) - 240 * static_cast<double>(speed * frame);
    CHECK(height > static_cast<double>(radius) + 0.01);  // on the cloth, not between its particles
}

TEST_CASE("Cloth under a ball keeps its shape on a box that rises, sinks or slides", "[simulation]") {
    constexpr uint32_t side = 21;
    constexpr float radius = 0.1f, link = 1.0f / (side - 1);
    for (const gphys_vec3 speed : {gphys_vec3{0, 1, 0}, {0, -1, 0}, {1, 0, 0}}) {
        for (const float mass : {0.1f, 1.0f}) {
            World world;
            const gphys_model_id box = world.box({0.6f, 0.5f, 0.6f}, {0, -0.5f, 0});
            gphys_body_desc of_cloth = colliding(1, 0.01f), of_ball = colliding(mass, radius);
            of_cloth.friction = of_ball.friction = 0.5f;
            const gphys_body_id cloth = world.cloth({-0.5f, 0.01f, -0.5f}, {1, 0, 0}, {0, 0, 1}, side, side, of_cloth);
            const gphys_body_id ball = world.particles({{0, 0.02f + radius, 0}}, of_ball);
            for (uint32_t p = 0; p < side * side; ++p) world.set_velocity(cloth, p, speed);
            world.set_velocity(ball, 0, speed);
            double strain = 0;
            for (int i = 1; i <= 60; ++i) {
                const float t = frame * static_cast<float>(i);
                const gphys_transform there{{speed.x * t, speed.y * t - 0.5f, speed.z * t}, {0, 0, 0, 1}, 1};
                REQUIRE(gphys_scene_set_transform(world.scene, box, &there) == GPHYS_OK);
                world.step(frame);
                const std::vector<gphys_vec3> at = world.positions(cloth);
                for (uint32_t p = 0; p + 1 < side * side; ++p) {
                    for (const uint32_t q : {p % side + 1 < side ? p + 1 : p, p + side < side * side ? p + side : p}) {
                        if (q == p) continue;
                        const double length = distance(gphys::widen(at[p]), gphys::widen(at[q]));
                        strain = std::max(strain, std::fabs(length / static_cast<double>(link) - 1));
                    }
                }
            }
            figure("strain", 100 * strain, "%");
            // The largest strain of default cloth. If what contacts correct at the end of a step took the way of the
            // box in the whole step for one in the last substep: 70 % where it rises, 33 % where it slides.
            CHECK(strain < 0.02);
        }
    }
}

TEST_CASE("A net catches a rigid cluster, and adds no energy", "[simulation]") {
    const auto check = [](float mass, float speed, float max_strain) {
        Net scene(mass, speed, max_strain);
        World& world = scene.world;
        const double energy = world.energy();
        double gained = 0, stretch = 0;
        float deepest = 1, highest = -1;
        for (int i = 0; i < 240; ++i) {
            world.step(frame);
            gained = std::max(gained, world.energy() - energy);
            stretch = std::max(stretch, static_cast<double>(world.stats(scene.net).strain_max));
            deepest = std::min(deepest, lowest(world.positions(scene.cluster)));
            if (i > 30) highest = std::max(highest, lowest(world.positions(scene.cluster)));
        }
        figure("stretch", 100 * stretch, "%");
        figure("deepest", static_cast<double>(deepest), "m");
        // Without loads by clusters: 2.2, and it falls through; with max_strain it is thrown up to 19 m.
        CHECK(stretch < 0.06);
        CHECK(deepest > -0.2f);
        CHECK(highest < 0.2f);
        CHECK(gained < 1e-3 * energy);
    };
    SECTION("1.5 kg at 5 m/s") { check(1.5f, 5, 0); }
    SECTION("0.3 kg at 5 m/s") { check(0.3f, 5, 0); }
    SECTION("1.5 kg, with a bound of strain") { check(1.5f, 5, 0.02f); }
}

TEST_CASE("A light net catches a crate of eight times its mass in long substeps") {
    World world(2);
    constexpr uint32_t side = 31;
    const gphys_body_id net = world.cloth({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, side, side, colliding(1, 0.02f));
    for (uint32_t i = 0; i < side; ++i) {
        for (const uint32_t p : {i, side * (side - 1) + i, side * i, side * i + side - 1}) world.pin(net, p);
    }
    std::vector<gphys_vec3> places;
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i < 27; ++i) {
        const auto at = [](uint32_t k) { return 0.15f * (static_cast<float>(k) - 1); };
        places.push_back({at(i % 3) + 0.1f, at(i / 9) + 1.5f, at(i / 3 % 3)});
        all.push_back(i);
    }
    const gphys_body_id crate = world.particles(places, colliding(8, 0.075f));
    gphys_cluster_id id = 0;
    REQUIRE(gphys_solver_add_cluster(world.solver, crate, all.data(), 27, &id) == GPHYS_OK);
    const double energy = world.energy();
    double strain = 0, gained = 0;
    for (int i = 0; i < 180; ++i) {
        world.step(frame);
        strain = std::max(strain, static_cast<double>(world.stats(net).strain_max));
        gained = std::max(gained, world.energy() - energy);
    }
    float fastest = 0;
    for (const gphys_vec3& v : world.velocities(crate)) fastest = std::max(fastest, std::fabs(v.y));
    figure("strain", 100 * strain, "%");
    figure("at the end", 100 * static_cast<double>(world.stats(net).strain_max), "%");
    figure("the crate", static_cast<double>(fastest), "m/s");
    // Measured: 12 % in the impact, 0.7 % at the end. Without the inertia of tension: 91 and 20 %.
    CHECK(strain < 0.2);
    CHECK(world.stats(net).strain_max < 0.04f);
    CHECK(fastest < 0.1f);
    CHECK(gained < 1e-3 * energy);
}

TEST_CASE("A sheet across two boxes carries a ball between them") {
    for (const uint32_t substeps : {2u, 8u}) {
        World world(substeps);
        for (const float x : {-1.0f, 1.0f}) world.box({0.5f, 0.5f, 1}, {x, 0.5f, 0});
        gphys_body_desc desc = colliding(1, 0.02f);
        desc.friction = 1;
        const gphys_body_id sheet = world.cloth({-1.4f, 1.021f, -0.8f}, {2.8f, 0, 0}, {0, 0, 1.6f}, 36, 21, desc);
        const gphys_body_id ball = world.particles({{0, 1.3f, 0}}, colliding(4, 0.15f));
        double strain = 0;
        for (int i = 0; i < 60; ++i) {
            world.step(frame);
            strain = std::max(strain, static_cast<double>(world.stats(sheet).strain_max));
        }
        figure("strain", 100 * strain, "%");
        figure("height", world.position(ball).y, "m");
        // Measured: 4 % at 2 substeps and 2 at 8. Without the inertia of tension 57 and 15 %, and the ball falls.
        CHECK(strain < 0.08);
        CHECK(world.position(ball).y > 0.8);
    }
}

TEST_CASE("A cloth that is lifted by its corners takes along what lies on it", "[simulation]") {
    World world;
    constexpr uint32_t side = 26;
    const gphys_body_id cloth = rug(world, side, 1, 0.4f);
    const gphys_body_id loads = balls(world, 2, 0.06f, 0.025f, 0.5f, 0.08f);
    for (int i = 0; i < 120; ++i) world.step(frame);
    const std::vector<gphys_vec3> before = world.positions(cloth);
    const uint32_t corners[] = {0, side - 1, side * (side - 1), side * side - 1};
    for (const uint32_t p : corners) world.pin(cloth, p);
    double stretch = 0;
    for (int i = 0; i < 300; ++i) {
        for (const uint32_t p : corners) {
            const gphys_vec3 at{before[p].x, before[p].y + std::min(0.2f, 0.004f * static_cast<float>(i)), before[p].z};
            REQUIRE(gphys_solver_set_positions(world.solver, cloth, p, 1, &at, sizeof at) == GPHYS_OK);
        }
        world.step(frame);
        stretch = std::max(stretch, static_cast<double>(world.stats(cloth).strain_max));
    }
    figure("stretch", 100 * stretch, "%");
    CHECK(stretch < 0.3);
    CHECK(lowest(world.positions(loads)) > 0.15f);
}

TEST_CASE("A sack that is gathered, lifted and swung keeps its load and its shape", "[simulation]") {
    constexpr uint32_t side = 26;
    const auto check = [](uint32_t substeps, bool is_crate, double most) {
        World world(substeps);
        const gphys_body_id cloth = rug(world, side, 1, 0.4f);
        const double rest = distance(world.positions(cloth)[0], world.positions(cloth)[1]);
        std::vector<gphys_vec3> places;
        std::vector<uint32_t> all;
        for (uint32_t i = 0; i < (is_crate ? 125u : 1u); ++i) {
            const auto at = [&](uint32_t k) { return is_crate ? 0.055f * (static_cast<float>(k) - 2) : 0; };
            places.push_back({at(i % 5) + 0.01f, at(i / 25) + 0.19f, at(i / 5 % 5) + 0.02f});
            all.push_back(i);
        }
        const gphys_body_id load = world.particles(places, colliding(8, is_crate ? 0.04f : 0.12f));
        gphys_cluster_id id = 0;
        if (is_crate) REQUIRE(gphys_solver_add_cluster(world.solver, load, all.data(), 125, &id) == GPHYS_OK);
        for (int i = 0; i < 60; ++i) world.step(frame);
        const std::vector<gphys_vec3> before = world.positions(cloth);
        const uint32_t corners[] = {0, side - 1, side * (side - 1), side * side - 1};
        for (const uint32_t p : corners) world.pin(cloth, p);
        double strain = 0;
        for (int i = 1; i <= 300; ++i) {
            const float lift = std::min(1.0f, static_cast<float>(i) / 120), part = 1 - 0.65f * std::min(1.0f, 2 * lift);
            const float aside = 0.2f * std::sin(0.08f * static_cast<float>(std::max(0, i - 120)));
            for (const uint32_t p : corners) {
                const gphys_vec3 at{part * before[p].x + aside, before[p].y + lift, part * before[p].z};
                REQUIRE(gphys_solver_set_positions(world.solver, cloth, p, 1, &at, sizeof at) == GPHYS_OK);
            }
            world.step(frame);
            strain = std::max(strain, strain_of_sides(world.positions(cloth), side, rest));
        }
        const double height = static_cast<double>(lowest(world.positions(load)));
        const double diagonals = part_of_stretched_diagonals(world.positions(cloth), side, rest);
        figure("strain", 100 * strain, "%");
        figure("height", height, "m");
        figure("stretched diagonals", 100 * diagonals, "%");
        CHECK(strain < most);
        CHECK(height > 0.4);
        CHECK(height < 1);
        CHECK(diagonals < 0.05);
    };
    SECTION("a ball") { check(8, false, 0.1); }
    SECTION("a ball, in long substeps") { check(2, false, 0.4); }
    SECTION("a crate") { check(8, true, 0.25); }
    SECTION("a crate, in long substeps") { check(4, true, 0.4); }
}

TEST_CASE("A ball that falls into a gathered sheet stops in it, and its diagonals carry a part of the ball",
          "[simulation]") {
    // Corners that have come together for 2 s: the sheet has collapsed, and its diagonals yield.
    const auto check = [](uint32_t substeps, double most_strain) {
        constexpr uint32_t side = 26;
        World world(substeps);
        const gphys_body_id cloth =
            world.cloth({-0.5f, 0.8f, -0.5f}, {1, 0, 0}, {0, 0, 1}, side, side, colliding(0.4f, 0.018f));
        const std::vector<gphys_vec3> flat = world.positions(cloth);
        const double rest = distance(flat[0], flat[1]);
        const uint32_t corners[] = {0, side - 1, side * (side - 1), side * side - 1};
        for (const uint32_t p : corners) world.pin(cloth, p);
        for (int i = 0; i < 240; ++i) {
            const float part = 1 - 0.4f * std::min(1.0f, static_cast<float>(i) / 119);
            for (const uint32_t p : corners) {
                const gphys_vec3 at{part * flat[p].x, flat[p].y, part * flat[p].z};
                REQUIRE(gphys_solver_set_positions(world.solver, cloth, p, 1, &at, sizeof at) == GPHYS_OK);
            }
            world.step(frame);
        }
        const gphys_body_id ball = world.particles({{0.01f, 1, 0.02f}}, colliding(8, 0.12f));
        double strain = 0;
        float rise = 0;
        for (int i = 0; i < 300; ++i) {
            world.step(frame);
            strain = std::max(strain, strain_of_sides(world.positions(cloth), side, rest));
            rise = std::max(rise, world.velocities(ball)[0].y);
        }
        const double diagonals = part_of_stretched_diagonals(world.positions(cloth), side, rest);
        const float height = world.positions(ball)[0].y;
        figure("strain", 100 * strain, "%");
        figure("stretched diagonals", 100 * diagonals, "%");
        figure("height", static_cast<double>(height), "m");
        figure("upward", static_cast<double>(rise), "m/s");
        CHECK(strain < most_strain);
        CHECK(diagonals < 0.05);
        CHECK(height > 0.3f);
        CHECK(rise < 0.5f);
        CHECK(std::fabs(world.velocities(ball)[0].y) < 0.2f);
    };
    SECTION("at default settings") { check(8, 0.06); }
    SECTION("in long substeps") { check(2, 0.4); }
}

TEST_CASE("Friction of a towed or jerked rug on what lies on it is at most Coulomb's", "[simulation]") {
    struct Pulled {
        double speed = 0, fastest_gain = 0, slip = 0, rise = 0;  // of the load, m/s, m/s in a frame, metres
    };
    // Pulled by an edge from rest.
    const auto pull = [](bool is_crate, float mass, float rug_mass, float speed, int frames, float aside = 0.01f) {
        constexpr uint32_t side = 26;
        World world;
        const gphys_body_id cloth = rug(world, side, 1, rug_mass);
        std::vector<gphys_vec3> places;
        std::vector<uint32_t> all;
        for (uint32_t i = 0; i < (is_crate ? 125u : 1u); ++i) {
            const auto at = [&](uint32_t k) { return is_crate ? 0.055f * (static_cast<float>(k) - 2) : 0; };
            places.push_back({at(i % 5) + aside, at(i / 25) + 0.18f, at(i / 5 % 5) + 0.02f});
            all.push_back(i);
        }
        const gphys_body_id load = world.particles(places, colliding(mass, is_crate ? 0.04f : 0.12f));
        gphys_cluster_id id = 0;
        if (is_crate) REQUIRE(gphys_solver_add_cluster(world.solver, load, all.data(), 125, &id) == GPHYS_OK);
        for (int i = 0; i < 60; ++i) world.step(frame);
        const std::vector<gphys_vec3> before = world.positions(cloth);
        const gphys_vec3 start = world.positions(load)[0];
        for (uint32_t row = 0; row < side; ++row) world.pin(cloth, row * side);
        Pulled out;
        for (int i = 1; i <= frames; ++i) {
            for (uint32_t row = 0; row < side; ++row) {
                gphys_vec3 at = before[row * side];
                at.x -= speed * frame * static_cast<float>(i);
                REQUIRE(gphys_solver_set_positions(world.solver, cloth, row * side, 1, &at, sizeof at) == GPHYS_OK);
            }
            world.step(frame);
            double now = 0;
            for (const gphys_vec3& v : world.velocities(load)) now -= static_cast<double>(v.x) / places.size();
            out.fastest_gain = std::max(out.fastest_gain, now - out.speed);
            out.speed = now;
            out.rise = std::max(out.rise, static_cast<double>(world.positions(load)[0].y - start.y));
        }
        out.slip =
            static_cast<double>(world.positions(load)[0].x - start.x) + static_cast<double>(speed * frame) * frames;
        figure("speed", out.speed, "m/s");
        figure("gained in a frame", out.fastest_gain, "m/s");
        figure("slip", out.slip, "m");
        figure("rise", out.rise, "m");
        return out;
    };
    constexpr double in_a_frame = 0.5 * g / 60;
    SECTION("a crate is carried away") {
        // Coulomb's slip is 1 / (2 * 0.5 g) = 0.1 m.
        const Pulled crate = pull(true, 8, 0.4f, 1, 120);
        CHECK(crate.speed == Approx(1).epsilon(0.15));
        CHECK(crate.slip > 0);
        CHECK(crate.slip < 0.4);
        CHECK(crate.rise < 0.04);
    }
    SECTION("a heavier one, slowly") {
        double rise = 0;
        for (const float aside : {0.01f, 0.02f, 0.03f, 0.04f})
            rise = std::max(rise, pull(true, 16, 0.4f, 0.3f, 120, aside).rise);
        CHECK(rise < 0.02);
    }
    SECTION("so is a ball") {
        const Pulled ball = pull(false, 1, 40, 1, 60);
        CHECK(ball.speed == Approx(1).epsilon(0.15));
        CHECK(std::fabs(ball.slip) < 0.3);
    }
    SECTION("a table cloth is jerked away under a crate") {
        // The spheres of the crate and the waves of the cloth catch on each other: single runs differ much.
        double gain = 0;
        for (const float aside : {0.01f, 0.015f, 0.02f, 0.025f})
            gain += pull(true, 1, 0.4f, 5, 5, aside).fastest_gain / 4;
        CHECK(gain < 8 * in_a_frame);
    }
    SECTION("and under a ball") { CHECK(pull(false, 8, 0.4f, 5, 5).speed < 5 * in_a_frame); }
}

TEST_CASE("Balls that begin in a cloth leave it slowly", "[simulation]") {
    World world;
    rug(world, 26, 1, 1);
    // They overlap particles of the cloth by up to a third.
    const gphys_body_id loads = balls(world, 2, 0.12f, 0.05f, 5, 0.06f);
    float fastest = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        for (const gphys_vec3& v : world.velocities(loads)) fastest = std::max(fastest, std::fabs(v.y));
    }
    figure("fastest", static_cast<double>(fastest), "m/s");
    CHECK(fastest < 0.5f);
}

TEST_CASE("A stick on a cloth that slides off a box with it gains no energy", "[simulation]") {
    // Its particles are in a line, about which it has no inertia.
    const auto check = [](uint32_t substeps, float step, uint32_t self_collision) {
        World world(substeps);
        const gphys_plane floor = {{0, 1, 0}, 0};
        world.model(GPHYS_SHAPE_PLANE, &floor);
        const gphys_obb box{{-0.115f, 0.46f, 0.56f}, {0.16f, 0.46f, 0.42f}, {0, std::sin(0.2f), 0, std::cos(0.2f)}};
        world.model(GPHYS_SHAPE_OBB, &box);
        constexpr gphys_vec3 u{-0.856f * 0.767f, 0, -0.517f * 0.767f}, v{0.517f * 0.5625f, 0, -0.856f * 0.5625f};
        gphys_body_desc of_cloth = colliding(3.4f, 0.023f);
        of_cloth.self_collision = self_collision;
        world.cloth({0.026f - (u.x + v.x) / 2, 1.2f, 0.055f - (u.z + v.z) / 2}, u, v, 16, 12, of_cloth);
        std::vector<gphys_vec3> places;
        for (int i = 0; i < 4; ++i) {
            const float along = 0.141f * (static_cast<float>(i) - 1.5f);
            places.push_back({-0.475f + along * 0.89f, 1.45f, 0.026f + along * 0.456f});
        }
        const gphys_body_id stick = world.particles(places, colliding(0.222f, 0.0616f));
        const uint32_t all[] = {0, 1, 2, 3};
        gphys_cluster_id id = 0;
        REQUIRE(gphys_solver_add_cluster(world.solver, stick, all, 4, &id) == GPHYS_OK);
        const double energy = world.energy();
        double gained = 0;
        for (float t = 0; t < 3; t += step) {
            world.step(step);
            gained = std::max(gained, world.energy() - energy);
        }
        INFO(substeps << " substeps in " << step << " s, self collision " << self_collision);
        // With what rounding leaves of that inertia: up to 10^9 J.
        CHECK(gained < 1e-3 * energy);
    };
    check(2, 1.0f / 144, 0);
    check(2, 1.0f / 144, 1);
    check(16, frame, 0);
    check(16, frame, 1);
    check(16, 1.0f / 144, 0);
}

TEST_CASE("A hammock carries a heavy rope, and adds no energy", "[simulation]") {
    const auto check = [](uint32_t substeps, double most_stretch) {
        World world(substeps);
        constexpr uint32_t side = 20;
        const gphys_body_id hammock =
            world.cloth({-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1}, side, side, colliding(0.5f, 0.45f / (side - 1)));
        for (const uint32_t p : {0u, side - 1, side * (side - 1), side * side - 1}) world.pin(hammock, p);
        const gphys_body_id rope =
            world.rope(test::line({-0.3f, 1.3f, 0}, {0.04f, 0, 0.0033f}, 16), 0, colliding(2, 0.02f));
        const double energy = world.energy();
        double gained = 0, stretch = 0;
        for (int i = 0; i < 240; ++i) {
            world.step(frame);
            gained = std::max(gained, world.energy() - energy);
            stretch = std::max(stretch, static_cast<double>(world.stats(hammock).strain_max));
        }
        INFO(substeps << " substeps");
        figure("stretch", 100 * stretch, "%");
        // With contacts and links one after the other: 77 % at 8 substeps, and it falls through.
        CHECK(gained < 1e-3 * energy);
        CHECK(stretch < most_stretch);
        CHECK(lowest(world.positions(rope)) > 0.7f);
    };
    check(16, 0.1);
    check(8, 0.15);
}

// Ropes that resist bending, compared with the theory of elastic rods.
#include <cmath>

#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::World;

namespace {

constexpr float frame = 1.0f / 60;

gphys_body_desc stiff(double stiffness, double mass = 1, double damping = 0) {
    gphys_body_desc desc = World::body_desc();
    desc.bending_stiffness = static_cast<float>(stiffness);
    desc.mass = static_cast<float>(mass);
    desc.damping = static_cast<float>(damping);
    return desc;
}

/// Along x from the origin, with one more link in front.
std::vector<gphys_vec3> bar(double length, int links) {
    std::vector<gphys_vec3> points;
    for (int i = -1; i <= links; ++i) points.push_back({static_cast<float>(length * i / links), 0, 0});
    return points;
}

/// A bar that is clamped at the origin: its first link is pinned.
struct Cantilever : World {
    gphys_body_id body;
    uint32_t tip;

    Cantilever(double length, int links, const gphys_body_desc& desc, uint32_t substeps = 8, gphys_vec3 gravity = {})
        : World(substeps, gravity), body(rope(bar(length, links), 0, desc)), tip(static_cast<uint32_t>(links) + 1) {
        pin(body, 0);
        pin(body, 1);
    }
    void load(gphys_vec3 force) { REQUIRE(gphys_solver_set_forces(solver, body, tip, 1, &force, 12) == GPHYS_OK); }
    Vec3 tip_at_rest() {
        for (int i = 0; i < 1200; ++i) step(frame);
        return position(body, tip);
    }
};

/// A bent rod without gravity that spins and drifts.
struct SpinningRod : World {
    gphys_body_id body;

    SpinningRod(double stiffness, uint32_t substeps) : World(substeps, {}) {
        std::vector<gphys_vec3> points;
        for (int i = 0; i <= 20; ++i) {
            const double angle = 2.0 * i / 20;
            points.push_back(
                {static_cast<float>(std::sin(angle) / 2), static_cast<float>((1 - std::cos(angle)) / 2), 0});
        }
        body = rope(points, 0, stiff(stiffness));
        for (uint32_t i = 0; i < points.size(); ++i)
            set_velocity(body, i, {0.3f - 5 * points[i].y, 5 * points[i].x, 0.2f});
    }
    Vec3 angular_momentum() const {
        const std::vector<gphys_vec3> at = positions(body), moving = velocities(body);
        Vec3 sum;
        for (size_t i = 0; i < at.size(); ++i)
            sum += cross(widen(at[i]), widen(moving[i])) / static_cast<double>(at.size());
        return sum;
    }
};

void hash_of(const World& world, uint32_t (&out)[2]) { REQUIRE(gphys_solver_get_hash(world.solver, out) == GPHYS_OK); }

}  // namespace

TEST_CASE("A cantilever bends under a small load by F L^3 / 3 E I, with an error of second order in its links") {
    constexpr double force = 0.01;
    for (const int links : {5, 10, 20}) {
        CAPTURE(links);
        Cantilever bar(1, links, stiff(1, 1, 2));
        bar.load({0, static_cast<float>(-force), 0});
        // The sum over the hinges of moment times lever, half at the clamp: h^3 / E I (n^2 / 2 + (n - 1)^2 + .. + 1).
        const double exact = force / 3 * (1 + 0.5 / (links * links)), deflection = -bar.tip_at_rest().y;
        figure("deflection, of the exact one", deflection / exact, "");
        CHECK(std::fabs(deflection / exact - 1) < 1e-4);  // what the load of 0.01 E I / L^2 adds, and float32
    }
}

TEST_CASE("A cantilever bends under its weight as its moments say") {
    constexpr double g = 9.81, stiffness = 100;
    constexpr int links = 20;
    Cantilever bar(1, links, stiff(stiffness, 1, 2), 8, {0, static_cast<float>(-g), 0});
    constexpr double weight = g / (links + 2), h = 1.0 / links;
    double sum = 0;
    for (int hinge = 0; hinge < links; ++hinge) {
        double moment = 0;
        for (int i = hinge + 1; i <= links; ++i) moment += weight * h * (i - hinge);
        sum += moment * h / stiffness * (hinge == 0 ? 0.5 : 1) * h * (links - hinge);
    }
    const double deflection = -bar.tip_at_rest().y;
    figure("deflection, of the sum", deflection / sum, "");
    CHECK(std::fabs(deflection / sum - 1) < 2e-4);
    // The continuous bar, q L^4 / 8 E I. The particle at the tip has the mass of a whole link.
    CHECK(std::fabs(deflection / (g / 8 / stiffness) - 1) < 0.05);
}

TEST_CASE("A cantilever under a large load has the shape of the elastica", "[simulation]") {
    // Bisshopp and Drucker 1945, "Large deflection of cantilever beams": F L^2 / E I, then the deflection of the tip
    // and the way by which it is nearer to the wall.
    constexpr double table[][3] = {{1, 0.30172, 0.05643}, {2, 0.49346, 0.16064}, {10, 0.81061, 0.55500}};
    for (const auto& [force, down, back] : table) {
        CAPTURE(force);
        Cantilever bar(1, 40, stiff(1, 1, 2));
        bar.load({0, static_cast<float>(-force), 0});
        const Vec3 tip = bar.tip_at_rest();
        figure("deflection, of the exact one", -tip.y / down, "");
        CHECK(std::fabs(-tip.y / down - 1) < 1e-3);
        CHECK(std::fabs((1 - tip.x) / back - 1) < 1e-3);
    }
}

TEST_CASE("Links of different lengths bend alike, and the plane of bending does not matter", "[simulation]") {
    std::vector<gphys_vec3> points = bar(1, 40);
    for (size_t i = 2; i + 1 < points.size(); i += 2) points[i].x += 0.008f;  // 0.033 and 0.017 m
    World world(8, {});
    const gphys_body_id body = world.rope(points, 0, stiff(1, 1, 2));
    world.pin(body, 0);
    world.pin(body, 1);
    const gphys_vec3 force{0, -0.6f, 0.8f};
    REQUIRE(gphys_solver_set_forces(world.solver, body, 41, 1, &force, 12) == GPHYS_OK);
    for (int i = 0; i < 1200; ++i) world.step(frame);
    const Vec3 tip = world.position(body, 41);
    CHECK(std::fabs(-tip.y / 0.30172 - 0.6) < 1e-3);
    CHECK(std::fabs(tip.z / 0.30172 - 0.8) < 1e-3);
}

TEST_CASE("A column stands below Euler's load and buckles above it") {
    // The half of a hinged column of 1 m: E I (pi / L)^2.
    constexpr int links = 10;
    for (const double ratio : {0.97, 1.03}) {
        CAPTURE(ratio);
        std::vector<gphys_vec3> points{{0, -0.05f, 0}};
        for (int i = 0; i <= links; ++i) {
            const double bow = 1e-3 * (1 - std::cos(pi / 2 * i / links));
            points.push_back({static_cast<float>(bow), 0.05f * static_cast<float>(i), 0});
        }
        World world(8, {});
        const gphys_body_id body = world.rope(points, 0, stiff(1, 1, 0.5));
        world.pin(body, 0);
        world.pin(body, 1);
        const gphys_vec3 load{0, static_cast<float>(-ratio * pi * pi), 0};
        REQUIRE(gphys_solver_set_forces(world.solver, body, links + 1, 1, &load, 12) == GPHYS_OK);
        for (int i = 0; i < 600; ++i) world.step(frame);
        const double aside = std::fabs(world.position(body, links + 1).x);
        figure("aside", aside, "m");
        CHECK((ratio < 1 ? aside < 1e-3 : aside > 0.05));
    }
}

TEST_CASE("A clamped bar swings with its lowest frequency and keeps its amplitude", "[simulation]") {
    constexpr int links = 20;
    constexpr double root = 1.8751;  // cos x cosh x = -1, and x^2 = 3.516
    for (const uint32_t substeps : {1u, 8u}) {
        for (const double hertz : {0.5, 2.0}) {
            CAPTURE(substeps, hertz);
            const double omega = 2 * pi * hertz, stiffness = std::pow(omega / (root * root), 2);
            Cantilever bar(1, links, stiff(stiffness, (links + 2.0) / links), substeps);
            const float half = 0.5f / links;
            REQUIRE(gphys_solver_set_masses(bar.solver, bar.body, bar.tip, 1, &half, 4) == GPHYS_OK);
            const double share = (std::cosh(root) + std::cos(root)) / (std::sinh(root) + std::sin(root));
            for (uint32_t i = 2; i <= bar.tip; ++i) {
                const double x = root * (i - 1) / links;
                const double y = (std::cosh(x) - std::cos(x) - share * (std::sinh(x) - std::sin(x))) / 2;
                bar.set_velocity(bar.body, i, {0, static_cast<float>(0.01 * omega * y), 0});
            }
            double last = 0, first_crossing = 0, crossing = 0, amplitude = 0;
            int crossings = 0;
            for (int i = 1; crossings < 21; ++i) {
                REQUIRE(i < 3000);
                bar.step(frame);
                const double y = bar.position(bar.body, bar.tip).y;
                if (last * y < 0) {
                    crossing = (i - 1 + last / (last - y)) / 60;
                    if (crossings++ == 0) first_crossing = crossing;
                }
                if (crossings > 18) amplitude = std::max(amplitude, std::fabs(y));
                last = y;
            }
            const double measured = (crossings - 1) / 2.0 / (crossing - first_crossing);
            figure("frequency, of the exact one", measured / hertz, "");
            figure("amplitude after ten periods, of that at first", amplitude / 0.01, "");
            // 20 links make it lower by 0.21 %, and a substep of an eighth of a radian by as much again.
            CHECK(std::fabs(measured / hertz - 1) < 5e-3);
            CHECK(std::fabs(amplitude / 0.01 - 1) < 0.02);
        }
    }
}

TEST_CASE("A bent rod that is let go never has more energy than at first, and keeps its momentum") {
    for (const double stiffness : {1e-3, 0.1, 10.0, 1e3}) {
        for (const uint32_t substeps : {1u, 8u}) {
            CAPTURE(stiffness, substeps);
            SpinningRod rod(stiffness, substeps);
            const double first = rod.energy(), around = rod.angular_momentum().z;
            const double length = 2 * 0.5 * std::sin(0.05), bent = 19 * stiffness / length * (1 - std::cos(0.1));
            CHECK(std::fabs(double{rod.stats().potential_energy} / bent - 1) < 1e-3);
            for (int i = 0; i < 300; ++i) {
                rod.step(frame);
                CHECK(rod.energy() < first * (1 + 1e-4));
            }
            Vec3 drift;
            for (const gphys_vec3& v : rod.velocities(rod.body)) drift += widen(v) / 21.0;
            Vec3 at_first;
            for (const gphys_vec3& v : SpinningRod(stiffness, substeps).velocities(rod.body))
                at_first += widen(v) / 21.0;
            CHECK(distance(drift, at_first) < 1e-5);
            const double kept = rod.angular_momentum().z / around;
            figure("angular momentum, of that at first", kept, "");
            // The time scheme keeps it as well as it resolves the motion.
            if (stiffness <= 0.1 && substeps == 8) CHECK(std::fabs(kept - 1) < 1e-3);
            CHECK(std::fabs(kept - 1) < 0.1);
        }
    }
}

TEST_CASE("A stiff cable lies on two supports and on the ground, and balances on a post") {
    const auto points = test::line({-1, 0.3f, 0}, {0.05f, 0, 0}, 41);
    const auto on = [&](double stiffness, auto&& build, double& middle, double& end) {
        World world;
        build(world);
        const gphys_body_id body = world.rope(points, 0, stiff(stiffness, 0.5, 0.2));
        for (int i = 0; i < 300; ++i) world.step(frame);
        middle = world.position(body, 20).y, end = world.position(body, 0).y;
        CHECK(world.stats().strain_max < 1e-6f);
        double fastest = 0;
        for (const gphys_vec3& v : world.velocities(body)) fastest = std::max(fastest, length(widen(v)));
        return fastest;
    };
    double middle = 0, end = 0;
    const auto supports = [](World& world) {
        world.box({0.1f, 0.1f, 0.5f}, {-0.7f, 0.15f, 0});
        world.box({0.1f, 0.1f, 0.5f}, {0.7f, 0.15f, 0});
    };
    CHECK(on(10, supports, middle, end) < 1e-4);
    // Between its supports of 1.2 m it sags by 5 w s^4 / 384 E I - w a^2 s^2 / 16 E I = 3.1 mm, a = 0.4 m.
    figure("sag of the cable", 0.26 - middle, "m");
    CHECK(std::fabs(0.26 - middle - 3.1e-3) < 1e-3);
    on(0.1, supports, middle, end);
    CHECK(middle < 0.2);
    const auto ground = [](World& world) { world.box({5, 0.5f, 5}, {0, -0.5f, 0}); };
    CHECK(on(10, ground, middle, end) < 1e-6);
    CHECK(std::fabs(middle - 0.01) < 1e-5);
    const auto post = [](World& world) {
        const gphys_capsule shape{{0, 0, -0.5f}, {0, 0, 0.5f}, 0.1f};
        world.model(GPHYS_SHAPE_CAPSULE, &shape);
    };
    on(10, post, middle, end);
    CHECK(std::fabs(middle - 0.11) < 1e-3);
    CHECK(end > 0);
    on(0, post, middle, end);
    CHECK(end < -0.5);
}

TEST_CASE("Supports carry the weight of a stiff cable, alone or joined", "[simulation]") {
    for (const bool joined : {false, true}) {
        CAPTURE(joined);
        World world;
        for (const float x : {-0.7f, 0.7f}) world.box({0.1f, 0.1f, 0.5f}, {x, 0.15f, 0});
        const gphys_body_id body = world.rope(test::line({-1, 0.27f, 0}, {0.05f, 0, 0}, 41), 0, stiff(10, 0.5, 0.2));
        double weight = 0.5 * 9.81;
        if (joined) {
            gphys_joint_id joint = 0;
            const gphys_body_id load = world.particles({{0, 0.27f, 0}}, stiff(0, 0.2));
            REQUIRE(gphys_solver_join(world.solver, body, 20, load, 0, 0, 0, &joint) == GPHYS_OK);
            weight += 0.2 * 9.81;
        }
        for (int i = 0; i < 600; ++i) world.step(frame);
        double carried = 0;
        for (int i = 0; i < 60; ++i) {
            world.step(frame);
            for (const gphys_impulse& impulse : test::impulses(world)) carried -= double{impulse.linear.y};
        }
        figure("impulses on the supports in a second, of the weight", carried / weight, "");
        CHECK(std::fabs(carried / weight - 1) < 0.01);
    }
}

TEST_CASE("A stiff rod slides by Coulomb's law") {
    World world;
    world.box({5, 0.5f, 5}, {0, -0.5f, 0});
    const gphys_body_id rod = world.rope(test::line({0, 0.01f, 0}, {0.05f, 0, 0.02f}, 21), 0, stiff(5, 0.5));
    for (uint32_t i = 0; i < 21; ++i) world.set_velocity(rod, i, {0, 0, 2});
    for (int i = 0; i < 120; ++i) world.step(frame);
    const double way = world.position(rod, 0).z, exact = 4 / (2 * 0.5 * 9.81);
    figure("way, of the exact one", way / exact, "");
    CHECK(std::fabs(way / exact - 1) < 0.01);
}

TEST_CASE("A model that holds two particles carries the weight of the rod and its moment, and turns it") {
    World world;
    const gphys_aabb shape{{-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f}};
    const gphys_model_id grip = world.model(GPHYS_SHAPE_AABB, &shape);
    gphys_body_desc desc = stiff(20, 1, 2);
    desc.layers = 0;
    const gphys_body_id rod = world.rope(bar(1, 20), 0, desc);
    for (uint32_t i = 0; i < 2; ++i)
        REQUIRE(gphys_solver_attach(world.solver, world.scene, rod, i, grip, nullptr) == GPHYS_OK);
    for (int i = 0; i < 600; ++i) world.step(frame);
    const std::vector<gphys_impulse> given = test::impulses(world);
    REQUIRE(given.size() == 1);
    double weight = 0, moment = 0;
    for (const gphys_vec3& at : world.positions(rod)) {
        weight += 9.81 / 22;
        moment += 9.81 / 22 * double{at.x};
    }
    figure("force on the grip, of the weight", double{-given[0].linear.y} * 60 / weight, "");
    figure("moment on the grip, of that of the weight", double{-given[0].angular.z} * 60 / moment, "");
    CHECK(std::fabs(double{-given[0].linear.y} * 60 / weight - 1) < 1e-3);
    CHECK(std::fabs(double{-given[0].angular.z} * 60 / moment - 1) < 1e-3);
    // A quarter turn about the axis of x leaves the rod alone; one about z lets it stand, since its own weight is below
    // that under which it would buckle, 7.84 E I / L^2.
    for (int i = 1; i <= 60; ++i) {
        const double half = pi / 4 * i / 60;
        const gphys_transform now{
            {0, 0, 0}, {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))}, 1};
        REQUIRE(gphys_scene_set_transform(world.scene, grip, &now) == GPHYS_OK);
        world.step(frame);
    }
    for (int i = 0; i < 600; ++i) world.step(frame);
    const Vec3 tip = world.position(rod, 21);
    CHECK(std::fabs(tip.x) < 1e-3);
    CHECK(std::fabs(tip.y - 1) < 1e-4);
}

TEST_CASE("A joined or branched rod bends like a single one, and is a hinge where it branches", "[simulation]") {
    const gphys_body_desc desc = stiff(1, 1, 2);
    Cantilever alone(1, 20, desc), joined(1, 20, desc);
    gphys_joint_id joint = 0;
    const gphys_body_id weight = joined.particles({{1, 0, 0}}, stiff(0, 1e-3));
    REQUIRE(gphys_solver_join(joined.solver, joined.body, joined.tip, weight, 0, 0, 0, &joint) == GPHYS_OK);
    World branched(8, {});
    std::vector<gphys_vec3> points = bar(1, 20);
    points.push_back({1, 0.05f, 0});
    points.push_back({1.05f, 0, 0});
    const gphys_body_id tree = branched.particles(points, desc);
    for (uint32_t i = 0; i < 22; ++i) {
        gphys_constraint_id link = 0;
        REQUIRE(gphys_solver_add_distance(branched.solver, tree, i, i + 1, -1, 0, &link) == GPHYS_OK);
        if (i < 21) continue;
        REQUIRE(gphys_solver_add_distance(branched.solver, tree, 21, 23, -1, 0, &link) == GPHYS_OK);
    }
    branched.pin(tree, 0);
    branched.pin(tree, 1);
    const gphys_vec3 force{0, -2, 0};
    REQUIRE(gphys_solver_set_forces(branched.solver, tree, 21, 1, &force, 12) == GPHYS_OK);
    joined.load(force);
    alone.load(force);
    const Vec3 tip = alone.tip_at_rest();
    CHECK(distance(joined.tip_at_rest(), tip) < 1e-5);
    for (int i = 0; i < 1200; ++i) branched.step(frame);
    CHECK(distance(branched.position(tree, 21), tip) < 1e-5);
}

TEST_CASE("Rods that may meet, hang by links that only pull, or change their lengths keep to their equations",
          "[simulation]") {
    // With others around, substeps are made in two parts (motion.h); with limits, in more iterations.
    constexpr double down = 0.30172;
    gphys_body_desc desc = stiff(1, 1, 2);
    desc.body_layers = 1;
    desc.layers = 0;
    Cantilever near(1, 20, desc);
    near.rope(test::line({0, -1, 0}, {0.05f, 0, 0}, 10), 0, desc);
    near.load({0, -1, 0});
    CHECK(std::fabs(-near.tip_at_rest().y / down - 1) < 2e-3);

    World pulls(8, {});
    const gphys_body_id string = pulls.particles(bar(1, 20), stiff(1, 1, 2));
    for (uint32_t i = 0; i < 21; ++i) {
        gphys_constraint_id link = 0;
        REQUIRE(gphys_solver_add_max_distance(pulls.solver, string, i, i + 1, 0.05f, 0, &link) == GPHYS_OK);
    }
    pulls.pin(string, 0);
    pulls.pin(string, 1);
    // Away from the wall too, so that all links are taut: the deflection is F L / T (1 - tanh(k) / k), k^2 = T L^2 / E
    // I.
    const gphys_vec3 force{16, -0.1f, 0};
    REQUIRE(gphys_solver_set_forces(pulls.solver, string, 21, 1, &force, 12) == GPHYS_OK);
    for (int i = 0; i < 1200; ++i) pulls.step(frame);
    const double exact = 0.1 / 16 * (1 - std::tanh(4) / 4);
    figure("deflection under tension, of the exact one", -pulls.position(string, 21).y / exact, "");
    CHECK(std::fabs(-pulls.position(string, 21).y / exact - 1) < 5e-3);

    Cantilever grows(1, 20, stiff(1, 1, 2));
    grows.load({0, -1, 0});
    gphys_constraint_info links[21];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_constraints(grows.solver, grows.body, links, 21, &total) == GPHYS_OK);
    std::vector<gphys_constraint_id> ids;
    for (uint32_t i = 1; i < total; ++i) ids.push_back(links[i].id);
    gphys_constraint_settings settings;
    REQUIRE(gphys_solver_get_constraint_settings(grows.solver, grows.body, ids.data(), 1, &settings, sizeof settings) ==
            GPHYS_OK);
    settings.rest_length = 0.05f * static_cast<float>(std::sqrt(2.0));  // F L^2 / E I = 2
    REQUIRE(gphys_solver_set_constraint_settings(grows.solver, grows.body, ids.data(), &settings, 0, 20) == GPHYS_OK);
    CHECK(std::fabs(-grows.tip_at_rest().y / std::sqrt(2.0) / 0.49346 - 1) < 5e-3);
}

TEST_CASE("Two rods in one body bend by themselves", "[simulation]") {
    World world(8, {});
    std::vector<gphys_vec3> points = bar(1, 20);
    for (const gphys_vec3& at : bar(0.5, 5)) points.push_back({at.x, 0, 1});
    const gphys_body_id body = world.particles(points, stiff(1, 1, 2));
    for (uint32_t i = 0; i + 1 < points.size(); ++i) {
        gphys_constraint_id link = 0;
        if (i != 21) REQUIRE(gphys_solver_add_distance(world.solver, body, i, i + 1, -1, 0, &link) == GPHYS_OK);
    }
    for (const uint32_t pinned : {0u, 1u, 22u, 23u}) world.pin(body, pinned);
    const gphys_vec3 force{0, -0.01f, 0};
    for (const uint32_t tip : {21u, 28u})
        REQUIRE(gphys_solver_set_forces(world.solver, body, tip, 1, &force, 12) == GPHYS_OK);
    for (int i = 0; i < 1200; ++i) world.step(frame);
    CHECK(std::fabs(-world.position(body, 21).y / (0.01 / 3 * (1 + 0.5 / 400)) - 1) < 1e-4);
    CHECK(std::fabs(-world.position(body, 28).y / (0.00125 / 3 * (1 + 0.5 / 25)) - 1) < 2e-4);
}

TEST_CASE("A rod whose links are slack swings on") {
    World world(8, {});
    const gphys_body_id rod = world.particles(test::line({-0.5f, 0, 0}, {0.05f, 0, 0}, 21), stiff(1));
    for (uint32_t i = 0; i < 20; ++i) {
        gphys_constraint_id link = 0;
        REQUIRE(gphys_solver_add_max_distance(world.solver, rod, i, i + 1, 0.052f, 0, &link) == GPHYS_OK);
    }
    for (uint32_t i = 0; i < 21; ++i) {
        const float x = -0.5f + 0.05f * static_cast<float>(i);
        world.set_velocity(rod, i, {0, 0.3f * (x * x - 0.0917f), 0});
    }
    const double first = world.energy();
    for (int i = 0; i < 60; ++i) world.step(frame);
    figure("energy after four periods, of that at first", world.energy() / first, "");
    CHECK(world.energy() < first);
    CHECK(world.energy() > 0.9 * first);
}

TEST_CASE("A bent rod leaves a model that it is in, and stays in equilibrium meanwhile") {
    // If the correction straightened it, it would stay inside, at a speed that takes it nowhere.
    for (const double side : {-1.0, 1.0}) {
        CAPTURE(side);
        Cantilever bar(1, 20, stiff(100, 1, 2));
        bar.load({0, -100, 0});
        bar.tip_at_rest();
        const Vec3 before = bar.position(bar.body, 8);
        bar.box({0.03f, 0.03f, 0.03f}, narrow(before + Vec3{0, 0.025 * side, 0}));
        for (int i = 0; i < 60; ++i) bar.step(frame);
        CHECK((before.y - bar.position(bar.body, 8).y) * side > 0.0149);
        for (const gphys_vec3& v : bar.velocities(bar.body)) CHECK(length(widen(v)) < 0.3);
    }
}

TEST_CASE("The bound of an animation target stops a rod, which then bends like a propped one") {
    Cantilever bar(1, 20, stiff(1, 1, 2));
    bar.load({0, -1, 0});
    const gphys_animation_target bound{{1, 0, 0}, {0, 1, 0}, 0.1f, INFINITY};
    REQUIRE(gphys_solver_set_animation_targets(bar.solver, bar.body, bar.tip, 1, &bound, 0) == GPHYS_OK);
    const Vec3 tip = bar.tip_at_rest();
    CHECK(std::fabs(distance(tip, {1, 0, 0}) - 0.1) < 1e-4);
    // A load at the tip bends a bar by (3 x^2 - x^3) / 2 of the tip's deflection.
    CHECK(std::fabs(bar.position(bar.body, 11).y / tip.y - 0.3125) < 0.01);
    for (const gphys_vec3& v : bar.velocities(bar.body)) CHECK(length(widen(v)) < 1e-4);
}

TEST_CASE("Stiff ropes go on alike after a snapshot, and with any number of threads") {
    const auto build = [](World& world) {
        world.box({5, 0.5f, 5}, {0, -0.5f, 0});
        for (int i = 0; i < 12; ++i) {
            const float z = 0.2f * static_cast<float>(i);
            const gphys_body_id body =
                world.rope(test::line({0, 0.3f, z}, {0.05f, 0.01f, 0.01f}, 8 + 2 * static_cast<uint32_t>(i)), 0,
                           stiff(0.02 * (i + 1), 0.1));
            if (i % 3 == 0) world.pin(body, 0);
            if (i % 6 == 0) world.pin(body, 1);
        }
    };
    World one, four;
    REQUIRE(gphys_solver_set_worker_count(one.solver, 1) == GPHYS_OK);
    REQUIRE(gphys_solver_set_worker_count(four.solver, 4) == GPHYS_OK);
    build(one);
    build(four);
    for (int i = 0; i < 30; ++i) {
        one.step(frame);
        four.step(frame);
    }
    uint32_t hash[2], other[2];
    hash_of(one, hash);
    hash_of(four, other);
    CHECK((hash[0] == other[0] && hash[1] == other[1]));
    uint32_t words = 0;
    gphys_solver_get_snapshot(one.solver, nullptr, 0, &words);
    std::vector<uint32_t> snapshot(words);
    REQUIRE(gphys_solver_get_snapshot(one.solver, snapshot.data(), words, &words) == GPHYS_OK);
    World restored;
    restored.box({5, 0.5f, 5}, {0, -0.5f, 0});
    REQUIRE(gphys_solver_restore(restored.solver, snapshot.data(), words) == GPHYS_OK);
    for (int i = 0; i < 30; ++i) {
        one.step(frame);
        restored.step(frame);
    }
    hash_of(one, hash);
    hash_of(restored, other);
    CHECK((hash[0] == other[0] && hash[1] == other[1]));
}

TEST_CASE("A rope in a ring is no chain and bends freely, until it is cut") {
    World world(8, {});
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2 * pi * i / 12;
        points.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0});
    }
    const gphys_body_id body = world.rope(points, 0, stiff(1));
    gphys_constraint_id closing = 0;
    const double open = double{world.stats().potential_energy};
    CHECK(open > 0);
    REQUIRE(gphys_solver_add_distance(world.solver, body, 0, 11, -1, 0, &closing) == GPHYS_OK);
    CHECK(world.stats().potential_energy == 0);
    for (int i = 0; i < 10; ++i) world.step(frame);
    CHECK(distance(world.position(body, 0), widen(points[0])) < 1e-6);
    REQUIRE(gphys_solver_remove_constraint(world.solver, body, closing) == GPHYS_OK);
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        CHECK(world.energy() < open * (1 + 1e-4));
    }
    CHECK(distance(world.position(body, 0), world.position(body, 11)) > 1);
}

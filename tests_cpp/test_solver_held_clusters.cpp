// Rigid clusters with pinned or attached particles that touch other bodies or are joined to them: doors, trays, booms.
#include "rigid_cluster.h"
#include "snapshots.h"

namespace {

using gphys::Vec3;
using test::figure;
using test::join;
using test::joint_force;
using test::of_mass;
using test::Rigid;
using test::World;

constexpr float dt = 1.0f / 60;
constexpr double gravity = 9.81;
// Positions of cloth are float32: bodies of 1 m have an error of 6e-8 m in each coordinate.
constexpr double rounding = 1e-6;

void pin(World& world, const Rigid& rigid, std::initializer_list<gphys_vec3> places) {
    for (const gphys_vec3 place : places) world.pin(rigid.body, rigid.at(place));
}

/// Sum of mass * x^2 and of mass * x.
struct Moments {
    double square = 0, first = 0;

    Moments(const Rigid& rigid, double mass) {
        for (const gphys_vec3 p : rigid.placed) {
            square += p.x * p.x * mass / rigid.count();
            first += p.x * mass / rigid.count();
        }
    }
};

/// Two balls fall on it; its end hits the floor.
Rigid seesaw(World& world, float height = 2.5f) {
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
    const Rigid plank(world, {0, 1, 0}, {4, 0, 0.4f}, {17, 1, 3}, 10, 1);
    pin(world, plank, {{0, 1, -0.2f}, {0, 1, 0.2f}});
    world.particles({{-1.5f, 1.35f, 0}}, test::colliding(20, 0.2f));
    world.particles({{1.5f, height, 0}}, test::colliding(60, 0.25f));
    return plank;
}

}  // namespace

TEST_CASE("A ball that hits a door exchanges momentum with the whole door") {
    for (const float restitution : {0.0f, 1.0f}) {
        for (const uint32_t substeps : {8u, 1u}) {
            World world(substeps, {0, 0, 0});
            const Rigid door(world, {0.5f, 1.5f, 0}, {1, 2, 0}, {6, 9, 1}, 20, 1);
            pin(world, door, {{0, 0.75f, 0}, {0, 2.25f, 0}});
            const gphys_body_id ball = world.particles({{0.8f, 1.5f, 0.2f}}, test::colliding(5, 0.1f));
            for (const gphys_body_id body : {door.body, ball}) {
                gphys_body_settings settings;
                REQUIRE(gphys_solver_get_body_settings(world.solver, body, &settings) == GPHYS_OK);
                settings.restitution = restitution;
                settings.friction = 0;
                REQUIRE(gphys_solver_set_body_settings(world.solver, body, &settings) == GPHYS_OK);
            }
            const gphys_vec3 speed{0, 0, -6};
            REQUIRE(gphys_solver_set_velocities(world.solver, ball, 0, 1, &speed, 12) == GPHYS_OK);
            for (int step = 0; step < 12; ++step) world.step(dt);
            const double moment = Moments(door, 20).square, arm = 0.8;
            const double spin = (1 + restitution) * 5 * 6 * arm / (moment + 5 * arm * arm);
            const double exact = -6 + spin * moment / (5 * arm);
            const double now = world.velocities(ball)[0].z;
            figure("speed of the ball", now, "m/s");
            // The door turns a little during the impact. If contacts acted on single particles: 0.68 and 1.18 m/s at 8
            // substeps, -1.26 and 0.66 at 1.
            CHECK(now == Approx(exact).margin(0.01));
            CHECK(door.distortion(world) < 8 * rounding);
        }
    }
}

TEST_CASE("A tray that three pins hold carries heavy balls") {
    for (const uint32_t substeps : {8u, 1u}) {
        World world(substeps);
        const Rigid tray(world, {0, 1, 0}, {1, 0, 0.4f}, {11, 1, 5}, 3, 1);
        pin(world, tray, {{-0.5f, 1, -0.2f}, {0.5f, 1, -0.2f}, {-0.5f, 1, 0.2f}});
        std::vector<gphys_body_id> balls;
        for (const float x : {-0.3f, 0.3f})
            balls.push_back(world.particles({{x, 1.35f, 0.1f}}, test::colliding(50, 0.12f)));
        double distortion = 0;
        for (int step = 0; step < 180; ++step) {
            world.step(dt);
            distortion = std::max(distortion, tray.distortion(world));
        }
        figure("distortion", 1000 * distortion, "mm");
        CHECK(distortion < 4 * rounding);  // with contacts on single particles 49 mm at 8 substeps, 5 m at 1
        // Each lies in the hollow between particles.
        for (const gphys_body_id ball : balls) CHECK(world.position(ball).y == Approx(1.12).margin(0.021));
    }
}

TEST_CASE("A seesaw keeps its shape under weights that fall on it") {
    for (const uint32_t substeps : {8u, 4u}) {
        World world(substeps);
        const Rigid plank = seesaw(world);
        const double energy = world.energy();
        double distortion = 0, gained = 0;
        for (int step = 0; step < 120; ++step) {
            world.step(dt);
            distortion = std::max(distortion, plank.distortion(world));
            gained = std::max(gained, world.energy() - energy);
        }
        figure("distortion", 1000 * distortion, "mm");
        // It hits the floor, too. With contacts on single particles 41 mm at 8 substeps and 99 mm at 4.
        CHECK(distortion < 2e-5);
        CHECK(gained < 1e-3);
    }
}

TEST_CASE("A seesaw that is restored before every step has the same bits as one that is not") {
    // What presses a particle onto a model in one step must not in the next.
    int same = 0;
    for (int i = 0; i < 8; ++i) {
        const float height = 1.8f + 0.1f * static_cast<float>(i);
        World world(1), restored(1);
        seesaw(world, height);
        seesaw(restored, height);
        for (int step = 0; step < 120; ++step) {
            REQUIRE(test::restore(restored.solver, test::snapshot(restored.solver)) == GPHYS_OK);
            world.step(dt);
            restored.step(dt);
        }
        same += test::hash(world.solver) == test::hash(restored.solver);
    }
    CHECK(same == 8);
}

TEST_CASE("What lies on an attached shelf presses on the model") {
    World world(8);
    const gphys_aabb wall{{-0.6f, 0.5f, -0.3f}, {-0.55f, 1.5f, 0.3f}};
    const gphys_model_id model = world.model(GPHYS_SHAPE_AABB, &wall);
    const Rigid shelf(world, {0, 1, 0}, {1, 0, 0.4f}, {11, 1, 5}, 3, 1);
    for (const gphys_vec3 place : {gphys_vec3{-0.5f, 1, -0.2f}, {-0.5f, 1, 0.2f}, {-0.4f, 1, 0.2f}}) {
        REQUIRE(gphys_solver_attach(world.solver, world.scene, shelf.body, shelf.at(place), model, nullptr) ==
                GPHYS_OK);
    }
    world.particles({{0.3f, 1.2f, 0.1f}}, test::colliding(10, 0.12f));
    Vec3 force, moment;
    constexpr int measured = 60;
    for (int step = 0; step < 180; ++step) {
        world.step(dt);
        if (step < 180 - measured) continue;
        for (const gphys_impulse& impulse : test::impulses(world)) {
            force += gphys::widen(impulse.linear) / (measured * dt);
            moment += gphys::widen(impulse.angular) / (measured * dt);
        }
    }
    const double load = 10 * gravity;
    // With contacts on single particles 129.05 N, and 9.96 and -29.88 N m.
    CHECK(-force.y == Approx(load + 3 * gravity).epsilon(1e-4));
    CHECK(moment.x == Approx(0.1 * load).epsilon(1e-3));
    CHECK(moment.z == Approx(-0.3 * load).epsilon(1e-3));
}

TEST_CASE("A boom on two pins hangs on its cable with a load") {
    for (const uint32_t substeps : {8u, 1u}) {
        World world(substeps);
        const Rigid boom(world, {1, 2, 0}, {2, 0, 0.2f}, {11, 1, 3}, 40);
        pin(world, boom, {{0, 2, -0.1f}, {0, 2, 0.1f}});
        const uint32_t tip = boom.at({2, 2, 0});
        const gphys_vec3 mast{0, 3.5f, 0};
        const gphys_body_id cable = world.rope({mast, {2, 2, 0}}, 0, of_mass(0.001f));
        world.pin(cable, 0);
        join(world, cable, 1, boom.body, tip);
        const gphys_body_id load = world.particles({{2, 1, 0}}, of_mass(200));
        join(world, load, 0, boom.body, tip, -1);
        double distortion = 0;
        for (int step = 0; step < 120; ++step) {
            world.step(dt);
            distortion = std::max(distortion, boom.distortion(world));
        }
        const double exact = (200 * 2 + 40 * 1) * gravity / (2 * 0.6);  // the cable pulls at 3 : 4
        figure("cable", joint_force(world, cable), "N");
        // 405 N at 8 substeps if the joints acted on single particles.
        CHECK(joint_force(world, cable) == Approx(exact).epsilon(1e-3));
        CHECK(distortion < 8 * rounding);
        CHECK(distance(world.position(boom.body, tip), Vec3{2, 2, 0}) < 1e-5);
    }
}

TEST_CASE("An arm with a weight at its end is a compound pendulum") {
    for (const bool flat : {false, true}) {
        World world(8);
        // On one pin, or on two.
        const Rigid arm(world, {0.5f, 0, 0}, {1, 0, flat ? 0.4f : 0}, {6, 1, flat ? 3u : 1u}, 4);
        pin(world, arm, {{0, 0, flat ? -0.2f : 0}, {0, 0, flat ? 0.2f : 0}});
        const gphys_body_id weight = world.particles({{1, 0, 0}}, of_mass(6));
        join(world, weight, 0, arm.body, arm.at({1, 0, 0}));
        const double energy = world.energy();
        double least = energy, most = energy, fall = 0;
        for (int step = 0; step < 300; ++step) {
            const double before = world.position(weight).x;
            world.step(dt);
            const double now = world.position(weight).x;
            if (fall == 0 && now < 0) fall = (step + before / (before - now)) * dt;
            least = std::min(least, world.energy()), most = std::max(most, world.energy());
            CHECK(arm.distortion(world) < 4 * rounding);  // 1.5 mm if the joint acted on a single particle
        }
        // From level to upright: K(1 / sqrt 2) sqrt(I / (m g d)).
        const Moments moments(arm, 4);
        const double exact = 1.8540746773 * std::sqrt((moments.square + 6) / (gravity * (moments.first + 6)));
        figure("energy", most - least, "J");
        figure("time of the fall", 100 * (fall / exact - 1), "%");
        CHECK(fall == Approx(exact).epsilon(1e-3));
        CHECK(most - least < 0.02);  // of 78 J
    }
}

TEST_CASE("Chains lift a drawbridge without bending it") {
    for (const uint32_t substeps : {8u, 2u, 1u}) {
        World world(substeps);
        const Rigid bridge(world, {1.5f, 0, 0}, {3, 0, 2}, {13, 1, 9}, 100);
        pin(world, bridge, {{0, 0, -1}, {0, 0, 0}, {0, 0, 1}});
        std::vector<gphys_body_id> chains;
        for (const float z : {-1.0f, 1.0f}) {
            std::vector<gphys_vec3> points;
            for (uint32_t i = 0; i <= 15; ++i) {
                const float part = static_cast<float>(i) / 15;
                points.push_back({3 * part, 2.5f - 2.5f * part, z});
            }
            chains.push_back(world.rope(points, 0, of_mass(4)));
            world.pin(chains.back(), 0);
            join(world, chains.back(), 15, bridge.body, bridge.at({3, 0, z}));
        }
        double distortion = 0;
        for (int step = 0; step < 150; ++step) {
            const float way = std::min(1.0f, static_cast<float>(step) / 120);
            for (size_t side = 0; side < 2; ++side) {
                const gphys_animation_target winch{
                    {-2 * way, 2.5f + 0.5f * way, side == 0 ? -1.0f : 1.0f}, {0, 1, 0}, 0, INFINITY};
                REQUIRE(gphys_solver_set_animation_targets(world.solver, chains[side], 0, 1, &winch, sizeof winch) ==
                        GPHYS_OK);
            }
            world.step(dt);
            distortion = std::max(distortion, bridge.distortion(world));
        }
        figure("distortion", 1000 * distortion, "mm");
        CHECK(distortion < 12 * rounding);  // 51, 192 and 367 mm if the joints acted on single particles
        // A circle about the hinge and one about the winch, of the chains' length. These sag a little.
        const Vec3 tip = world.position(bridge.body, bridge.at({3, 0, 0})), winch{-2, 3, 0};
        const double chain = std::sqrt(9 + 2.5 * 2.5);
        CHECK(length(tip) == Approx(3).epsilon(1e-5));
        CHECK(distance(tip, winch) < chain + rounding);
        CHECK(distance(tip, winch) > chain - 0.01);
    }
}

// Ropes that models carry along by friction: on drums that turn, and on trucks that speed up.
#include <cmath>

#include "solver_world.h"

using namespace gphys;
using test::figure;
using test::World;

namespace {

constexpr double g = 9.81f, pi = 3.14159265358979323846;
constexpr float drum = 0.3f, thick = 0.005f, load = 5;
constexpr double arm = double{drum} + double{thick};

gphys_transform turned(double angle) {
    return {{0, 0, 0}, {0, 0, static_cast<float>(std::sin(angle / 2)), static_cast<float>(std::cos(angle / 2))}, 1};
}

/// A capsule along z with a rope wound onto it, from which a weight hangs. The first particle is attached.
struct Winch : World {
    gphys_model_id capsule = 0;
    gphys_body_id rope_id = 0;
    uint32_t last = 0;
    double angle = 0;

    /// `pitch`: metres along the axis for each radian.
    Winch(uint32_t substeps, double turns, double friction, double pitch, float breaking) : World(substeps) {
        const gphys_capsule shape{{0, 0, -0.5f}, {0, 0, 0.5f}, drum};
        capsule = model(GPHYS_SHAPE_CAPSULE, &shape);
        const double wound = turns * 2 * pi * arm, length = wound + 1.5;
        last = static_cast<uint32_t>(length / 0.03);
        std::vector<gphys_vec3> points;
        for (uint32_t i = 0; i <= last; ++i) {
            const double way = length * i / last, at = std::max(0.0, wound - way) / arm;
            points.push_back({static_cast<float>(arm * std::cos(at)),
                              static_cast<float>(arm * std::sin(at) - std::max(0.0, way - wound)),
                              static_cast<float>(pitch * at)});
        }
        gphys_body_desc desc = body_desc();
        desc.mass = 0.05f;
        desc.radius = thick;
        desc.friction = static_cast<float>(friction);
        desc.breaking_force = breaking;
        rope_id = rope(points, 0, desc);
        REQUIRE(gphys_solver_attach(solver, scene, rope_id, 0, capsule, nullptr) == GPHYS_OK);
        REQUIRE(gphys_solver_set_masses(solver, rope_id, last, 1, &load, 4) == GPHYS_OK);
    }
    void turn(double by, float dt) {
        angle += by;
        const gphys_transform now = turned(angle);
        REQUIRE(gphys_scene_set_transform(scene, capsule, &now) == GPHYS_OK);
        step(dt);
    }
    double moment(float dt) const {
        for (const gphys_impulse& impulse : test::impulses(*this)) {
            if (impulse.model == capsule) return double{impulse.angular.z} / double{dt};
        }
        return 0;
    }
    /// Of gravity on the whole rope, about the axis.
    double moment_of_weight() const {
        double sum = 0;
        const std::vector<gphys_vec3> at = positions(rope_id);
        for (uint32_t i = 0; i <= last; ++i) {
            const double mass = i == last ? double{load} : 0.05 / (last + 1);
            sum -= mass * g * double{at[i].x};
        }
        return sum;
    }
    uint32_t broken() const {
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_breaks(solver, nullptr, 0, &total) >= GPHYS_OK);
        return total;
    }
};

}  // namespace

TEST_CASE("A rope that winds onto a drum, or off it, carries its load and no more, and the drum gets its moment",
          "[simulation]") {
    constexpr float dt = 1.0f / 60;
    struct Case {
        uint32_t substeps;
        double turns, friction, pitch, speed;
    };
    for (const Case& c : {Case{8, 0.75, 0.3, 0, 1}, Case{8, 0.75, 0.5, 0, 1}, Case{32, 0.75, 0.5, 0, 0.3},
                          Case{8, 1.75, 0.5, 0.03, 1}, Case{8, 1.75, 0.5, 0.03, -0.3}}) {
        CAPTURE(c.substeps, c.turns, c.friction, c.pitch, c.speed);
        // 49 N hang from it. They swing a little, because the rope is a polygon.
        Winch winch(c.substeps, c.turns, c.friction, c.pitch, 100);
        double moment = 0, expected = 0;
        for (int i = 0; i < 180; ++i) {
            winch.turn(c.speed / 60 * std::min(1.0, i / 60.0), dt);
            CHECK(winch.broken() == 0);
            if (i < 80) continue;
            moment += winch.moment(dt);
            expected += winch.moment_of_weight();
        }
        figure("moment on the drum, of that of the weight", moment / expected, "");
        CHECK(std::fabs(moment / expected - 1) < 0.01);
    }
}

TEST_CASE("A weight that falls on its rope turns the wheel from which that unwinds, without a gain of energy",
          "[simulation]") {
    constexpr float dt = 1.0f / 240;
    constexpr double inertia = 2;
    Winch winch(8, 1.75, 0.5, 0.03, 0);
    const double top = winch.position(winch.rope_id, winch.last).y;
    double speed = 0, fall = 0, seconds = 0;
    for (int i = 0; i < 192; ++i) {
        winch.turn(speed * double{dt}, dt);
        speed += winch.moment(dt) / inertia * double{dt};
        seconds += double{dt};
    }
    fall = top - winch.position(winch.rope_id, winch.last).y;
    const double exact = g * double{load} / (double{load} + inertia / (arm * arm)) * seconds * seconds / 2;
    figure("fall, of the exact one", fall / exact, "");
    // The wheel is a step behind, and the rope has a hundredth of the mass.
    CHECK(std::fabs(fall / exact - 1) < 0.02);
}

TEST_CASE("A rope on a truck that speeds up stays where friction holds it, and slides by Coulomb's law beyond that") {
    constexpr double dt = 1 / 60.0;
    for (const uint32_t substeps : {1, 8, 32}) {
        for (const double acceleration : {4.5, 8.0}) {
            CAPTURE(substeps, acceleration);
            World world(substeps);
            const gphys_aabb bed{{-5, -0.1f, -50}, {5, 0.1f, 50}};
            const gphys_model_id truck = world.model(GPHYS_SHAPE_AABB, &bed);
            const gphys_body_desc desc = test::point_mass(0.01f, 0.5f, 0);
            const gphys_body_id rope = world.rope(test::line({0, 0.11f, 0}, {0.05f, 0, 0}, 21), 0, desc);
            for (int i = 0; i < 30; ++i) world.step(static_cast<float>(dt));
            double way = 0;
            for (int i = 1; i <= 60; ++i) {
                way = acceleration * (i * dt) * (i * dt) / 2;
                const gphys_transform now{{0, 0, static_cast<float>(way)}, {0, 0, 0, 1}, 1};
                REQUIRE(gphys_scene_set_transform(world.scene, truck, &now) == GPHYS_OK);
                world.step(static_cast<float>(dt));
            }
            const double slip = way - world.position(rope, 10).z, exact = std::max(0.0, (acceleration - g / 2) / 2);
            figure("slip", slip, "m");
            // A truck that has one speed in each step is ahead by half a step of its own acceleration.
            CHECK(std::fabs(slip - exact) < (exact == 0 ? 1e-5 : 0.03));
        }
    }
}

// Frames that are not one step long: what the caller moves once a frame moves evenly over the steps.
#include "snapshots.h"
#include "solver_world.h"

using namespace gphys;
using test::World;

namespace {

constexpr double step = 1.0f / 60;

/// Frames of one length, or of lengths that vary around it.
struct Frames {
    double length, jitter = 0;
    test::Random random{11};

    float next() { return static_cast<float>(length + random.uniform(-jitter, jitter)); }
};
const Frames all_frames[] = {{1 / 30.0}, {1 / 20.0}, {1 / 50.0}, {1 / 144.0}, {1 / 60.0, 0.003}, {0.1}};

/// A model that is at rest for 0.2 s, and then moves at a constant velocity from the origin.
struct Moving {
    World world;
    gphys_model_id model;
    const gphys_vec3 velocity;
    double time = 0, owed = 0;

    Moving(gphys_shape_type type, const void* shape, gphys_vec3 v) : velocity(v) { model = world.model(type, shape); }

    Vec3 way(double t) const { return widen(velocity) * std::max(0.0, t - 0.2); }
    /// Where the model is at the time that the solver has reached.
    Vec3 place() const { return way(time - owed); }
    virtual void move(double) {}
    /// Returns the number of steps.
    uint32_t frame(float length) {
        time += length;
        const gphys_transform at{narrow(way(time)), {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
        move(time);
        uint32_t steps = 0;
        float leftover = 0;
        REQUIRE(gphys_solver_advance(world.solver, world.scene, length, &steps, &leftover) == GPHYS_OK);
        owed = leftover * step;
        return steps;
    }
    virtual ~Moving() = default;
};

}  // namespace

TEST_CASE("what lies on a lift and on a truck stays there, whatever the length of the frames") {
    for (Frames frames : all_frames) {
        CAPTURE(frames.length, frames.jitter);
        const gphys_aabb box{{-5, -1, -5}, {5, 0, 5}};
        Moving moving(GPHYS_SHAPE_AABB, &box, {1, 1, 0});
        const gphys_body_id ball = moving.world.particles({{0, 0.011f, 1}});
        const gphys_body_id rope = moving.world.rope(test::line({-0.5f, 0.011f, 0}, {0.05f, 0, 0}, 20), 0);
        const gphys_body_id cloth = moving.world.cloth({-1, 0.011f, -3}, {1, 0, 0}, {0, 0, 1}, 6, 6);
        double farthest = 0, fastest = 0;
        while (moving.time < 2) {
            const bool has_started = moving.time > 0.7;  // within some frames the model is where it should be
            moving.frame(frames.next());
            for (const gphys_body_id body : {ball, rope, cloth}) {
                const Vec3 at = widen(moving.world.positions(body)[0]) - moving.place();
                const Vec3 v = widen(moving.world.velocities(body)[0]) - widen(moving.velocity);
                if (!has_started) continue;
                farthest = std::max(farthest, std::fabs(at.y - 0.01));
                fastest = std::max(fastest, length(v));
            }
        }
        CHECK(farthest < 1e-4);
        CHECK(fastest < 1e-3);
    }
}

TEST_CASE("attached particles, pins and targets are at the places of the time that the solver has reached",
          "[simulation]") {
    struct Carried : Moving {
        gphys_body_id attached, pinned, aimed;
        static gphys_sphere ball() { return {{0, 0, 0}, 0.01f}; }

        explicit Carried(const gphys_sphere& shape) : Moving(GPHYS_SHAPE_SPHERE, &shape, {3, 0, 1}) {
            const auto line = [](float z) { return test::line({0, 0, z}, {0, -0.05f, 0}, 8); };
            attached = world.rope(line(0), 0);
            pinned = world.rope(line(1), 0);
            aimed = world.rope(line(2), 0);
            REQUIRE(gphys_solver_attach(world.solver, world.scene, attached, 0, model, nullptr) == GPHYS_OK);
            world.pin(pinned, 0);
        }
        void move(double t) override {
            const gphys_vec3 pin = narrow(way(t) + Vec3{0, 0, 1});
            REQUIRE(gphys_solver_set_positions(world.solver, pinned, 0, 1, &pin, 12) == GPHYS_OK);
            const gphys_animation_target target{narrow(way(t) + Vec3{0, 0, 2}), {0, 1, 0}, 0, INFINITY};
            REQUIRE(gphys_solver_set_animation_targets(world.solver, aimed, 0, 1, &target, sizeof target) == GPHYS_OK);
        }
    };
    for (Frames frames : all_frames) {
        CAPTURE(frames.length, frames.jitter);
        const gphys_sphere shape = Carried::ball();
        Carried carried(shape);
        for (int i = 0; i < 200; ++i) {
            // Pins are where they were set until the next step begins.
            if (carried.frame(frames.next()) == 0 || carried.time < 0.7) continue;
            float z = 0;
            for (const gphys_body_id body : {carried.attached, carried.pinned, carried.aimed}) {
                CAPTURE(i, z);
                REQUIRE(distance(widen(carried.world.positions(body)[0]), carried.place() + Vec3{0, 0, z}) < 2e-5);
                z += 1;
            }
        }
        CHECK(carried.world.stats(0).strain_max < 1e-5f);
    }
}

TEST_CASE("frames of several steps move a cape as frames of one step do") {
    const auto run = [](uint32_t steps) {
        const gphys_sphere ball{{0, 1, 0}, 0.05f};
        Moving moving(GPHYS_SHAPE_SPHERE, &ball, {2, 0, 0});
        const gphys_body_id cape = moving.world.cloth({0, 0, 0}, {0, 0, 0.5f}, {0, -0.7f, 0}, 6, 8);
        for (uint32_t p = 0; p < 6; ++p)
            REQUIRE(gphys_solver_attach(moving.world.solver, moving.world.scene, cape, p, moving.model, nullptr) ==
                    GPHYS_OK);
        // Later, differences of a rounding have grown to millimetres.
        for (uint32_t i = 0; i < 30 / steps; ++i) moving.frame(static_cast<float>(steps) / 60);
        return moving.world.positions(cape);
    };
    const std::vector<gphys_vec3> one = run(1);
    for (const uint32_t steps : {2u, 3u, 6u}) {
        const std::vector<gphys_vec3> several = run(steps);
        double farthest = 0;
        for (size_t p = 0; p < one.size(); ++p)
            farthest = std::max(farthest, distance(widen(one[p]), widen(several[p])));
        CAPTURE(steps);
        CHECK(farthest < 2e-4);
    }
}

TEST_CASE("a model that stops within a frame is reached, and a snapshot between frames goes on with the same bits") {
    const gphys_aabb box{{-2, -1, -2}, {2, 0, 2}};
    const auto make = [&](Moving& moving) {
        moving.world.cloth({-0.5f, 0.02f, -0.5f}, {1, 0, 0}, {0, 0, 1}, 6, 6);
        for (int i = 0; i < 50; ++i) moving.frame(1 / 144.0f);
    };
    Moving moving(GPHYS_SHAPE_AABB, &box, {1, 0, 0}), again(GPHYS_SHAPE_AABB, &box, {1, 0, 0});
    make(moving);
    make(again);
    const test::Words saved = test::snapshot(moving.world.solver);
    const auto rest = [](Moving& of) {
        for (int i = 0; i < 300; ++i)
            REQUIRE(gphys_solver_advance(of.world.solver, of.world.scene, 1 / 144.0f, nullptr, nullptr) == GPHYS_OK);
        return test::snapshot(of.world.solver);
    };
    const test::Words ended = rest(moving);
    CHECK(moving.world.stats(0).kinetic_energy < 1e-6f);
    REQUIRE(test::restore(again.world.solver, saved) == GPHYS_OK);
    CHECK(rest(again) == ended);
}

// Cloth on models that move: carried by friction, lifted, pushed.
#include "c_api/handles.h"
#include "solver/contact/collision.h"
#include "solver_world.h"

using namespace gphys;
using test::all_finite;
using test::figure;
using test::World;

namespace {

constexpr double g = 9.81f;
constexpr float frame = 1 / 60.0f;

/// A sheet of a metre that lies on the top of a box, at y = 0.
struct Tray {
    World world{8};
    gphys_transform at{{0, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_id box = 0;
    gphys_body_id sheet = 0;
    std::vector<gphys_vec3> laid;

    explicit Tray(float friction, float static_friction = 0) {
        const gphys_aabb slab{{-2, -0.5f, -2}, {2, 0, 2}};
        box = world.model(GPHYS_SHAPE_AABB, &slab, &at);
        gphys_body_desc desc = World::body_desc();
        desc.friction = friction;
        desc.static_friction = static_friction;
        desc.radius = 0.01f;
        sheet = world.cloth({-0.5f, 0.0101f, -0.5f}, {1, 0, 0}, {0, 0, 1}, 15, 15, desc);
        for (int i = 0; i < 30; ++i) world.step(frame);
        laid = world.positions(sheet);
    }
    void step() {
        REQUIRE(gphys_scene_set_transform(world.scene, box, &at) == GPHYS_OK);
        world.step(frame);
    }
    Vec3 middle() const {
        Vec3 sum;
        for (const gphys_vec3& p : world.positions(sheet)) sum += widen(p);
        return sum / static_cast<double>(laid.size());
    }
    /// What the sheet has given to the box in the last step, N s.
    Vec3 impulse() const {
        gphys_impulse impulses[4];
        uint32_t count = 0;
        REQUIRE(gphys_solver_get_impulses(world.solver, impulses, 4, &count) == GPHYS_OK);
        REQUIRE(count == 1);
        return widen(impulses[0].linear);
    }
};

/// A sheet of 41 x 41 that hangs over a ball of half a metre.
struct Draped {
    World world{8};
    gphys_transform at{{0, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_id ball = 0;
    gphys_body_id sheet = 0;

    Draped() {
        const gphys_sphere sphere{{0, 0, 0}, 0.5f};
        ball = world.model(GPHYS_SHAPE_SPHERE, &sphere, &at);
        gphys_body_desc desc = World::body_desc();
        desc.friction = 0.5f;
        desc.damping = 1;
        desc.cloth_flags = 0;
        desc.radius = 0.01f;
        sheet = world.cloth({-0.9f, 0.55f, -0.9f}, {1.8f, 0, 0}, {0, 0, 1.8f}, 41, 41, desc);
        for (int i = 0; i < 180; ++i) world.step(frame);
    }
    /// Returns the largest strain.
    double step() {
        REQUIRE(gphys_scene_set_transform(world.scene, ball, &at) == GPHYS_OK);
        world.step(frame);
        for (const gphys_vec3& p : world.positions(sheet)) {
            // Up to the rounding of float32.
            REQUIRE(distance(widen(p), widen(at.position)) >= 0.5 * at.scale + 0.01 - 1e-6);
        }
        return world.stats(sheet).strain_max;
    }
};

}  // namespace

TEST_CASE("A sheet goes with the box below it as far as friction carries it") {
    for (const double part : {0.5, 2.0}) {  // of what friction can give
        Tray tray(0.4f);
        const double friction = 0.4f, a = part * friction * g;
        const Vec3 from = tray.middle();
        const int steps = 60;
        for (int i = 1; i <= steps; ++i) {
            const double t = i / 60.0;
            tray.at.position.x = static_cast<float>(a / 2 * t * t);
            tray.step();
        }
        const double gone = tray.middle().x - from.x;
        const double expected = std::min(1.0, 1 / part) * a / 2;
        // The speed of a model is the same during a step. When it rises by a dt at once, friction needs a while to
        // follow, in which the box gets ahead by (a dt)^2 / (2 friction g); or it never does, and is a step late.
        const double late = part < 1 ? steps * a * frame * a * frame / (2 * friction * g) : expected * frame;
        std::printf("    at %g of what friction gives: %.5g of %.5g m\n", part, gone, expected);
        CHECK(gone < expected + 1e-4);
        CHECK(gone > expected - late);
    }
}

TEST_CASE("A turntable carries a sheet around") {
    Tray tray(0.5f);
    const int steps = 120;
    for (int i = 1; i <= steps; ++i) {
        const double t = i / 60.0, half = t * t / 8;  // to 1 rad/s in 2 s
        tray.at.rotation = {0, static_cast<float>(std::sin(half)), 0, static_cast<float>(std::cos(half))};
        tray.step();
    }
    const Transform now = widen(tray.at);
    const std::vector<gphys_vec3> places = tray.world.positions(tray.sheet);
    double slip = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        slip = std::max(slip, distance(now.inverse_apply(widen(places[i])), widen(tray.laid[i])));
    }
    figure("slip on a turntable in 2 s", slip, "m");
    // As on the box, with the acceleration of a corner: outward and along.
    const double acceleration = std::hypot(1.0, 0.5) * std::sqrt(0.5), jerk = acceleration * frame;
    CHECK(slip < steps * jerk * jerk / (2 * 0.5 * g));
}

TEST_CASE("A lift is pressed by what it carries with m (g + a)") {
    Tray tray(0.5f);
    tray.step();
    const double weight = -tray.impulse().y / (g * frame), a = 3;
    double y = 0, worst = 0;
    for (int i = 1; i <= 60; ++i) {
        const double t = i / 60.0;
        y = a / 2 * t * t;
        tray.at.position.y = static_cast<float>(y);
        tray.step();
        // The speed of a step is constant, so that the first substep of each has all of the acceleration.
        if (i > 2) worst = std::max(worst, std::fabs(-tray.impulse().y / (weight * (g + a) * frame) - 1));
    }
    figure("lift, worst impulse", worst * 100, "%");
    CHECK(worst < 0.02);
    CHECK(std::fabs(tray.middle().y - (y + 0.01)) < 1e-4);
}

TEST_CASE("Cloth on a ball that moves keeps its threads' lengths", "[simulation]") {
    for (const int way : {0, 1, 2}) {
        Draped draped;
        double peak = 0;
        for (int i = 1; i <= 240; ++i) {
            const double t = i / 60.0;
            if (way == 0) draped.at.position.x = static_cast<float>(0.3 * std::sin(2 * t));
            if (way == 1) draped.at.position.y = static_cast<float>(0.1 * (1 - std::cos(4 * t)));
            if (way == 2) {
                draped.at.rotation = {0, static_cast<float>(std::sin(t / 2)), 0, static_cast<float>(std::cos(t / 2))};
            }
            peak = std::max(peak, draped.step());
        }
        figure(way == 0   ? "to and fro, peak strain"
               : way == 1 ? "up and down, peak strain"
                          : "turning, peak strain",
               peak * 100, "%");
        CHECK(peak < 0.03);
    }
}

TEST_CASE("Cloth stays outside a ball that jumps, turns or grows", "[simulation]") {
    for (const int way : {0, 1, 2}) {
        Draped draped;
        for (int i = 1; i <= 60; ++i) {
            const float t = static_cast<float>(i) / 60;
            if (way == 0) draped.at.position.x = (i % 2) != 0 ? 0.2f : 0.0f;
            if (way == 1) draped.at.rotation = {0, std::sin(0.7f * t * 60), 0, std::cos(0.7f * t * 60)};
            if (way == 2) draped.at.scale = 1 + 0.3f * t;
            draped.step();
        }
        CHECK(all_finite(draped.world.positions(draped.sheet)));
    }
}

TEST_CASE("the bounds of a motion contain the model at each time of it, and hardly more") {
    test::Random random(11);
    const auto unit = [](gphys_quat q) {
        const float factor = 1 / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
        return gphys_quat{q.x * factor, q.y * factor, q.z * factor, q.w * factor};
    };
    const auto some_quaternion = [&] {
        return unit({random.uniform_float(-1, 1), random.uniform_float(-1, 1), random.uniform_float(-1, 1),
                     random.uniform_float(-1, 1)});
    };
    World world;
    double largest = 0;
    for (int i = 0; i < 2000; ++i) {
        const float away = i % 3 == 0 ? 20.0f : 1.0f;
        const gphys_vec3 low{random.uniform_float(-away, away), random.uniform_float(-away, away),
                             random.uniform_float(-away, away)};
        const gphys_aabb box{low,
                             {low.x + random.uniform_float(0, 2), low.y + random.uniform_float(0, 2),
                              low.z + random.uniform_float(0, 2)}};
        const auto some_position = [&] {
            return gphys_vec3{random.uniform_float(-5, 5), random.uniform_float(-5, 5), random.uniform_float(-5, 5)};
        };
        gphys_transform first{some_position(), some_quaternion(), 1}, second{some_position(), some_quaternion(), 1};
        const bool turns = i % 4 != 0, grows = i % 4 == 3;
        if (!turns) second.rotation = first.rotation = {0, 0, 0, 1};
        if (i % 4 == 2) {  // by a small angle
            second.rotation = first.rotation;
            second.rotation.x += 0.01f;
            second.rotation = unit(second.rotation);
        }
        if (grows) second.scale = random.uniform_float(0.5f, 2);
        const gphys_model_id model = world.model(GPHYS_SHAPE_AABB, &box, &second);
        const Scene& scene = *unwrap(world.scene);
        const MovedModel moved(scene, {model, first, {}});
        REQUIRE(moved.bounded);
        Aabb all = widen(moved.swept), seen{all.max, all.min};
        for (int k = 0; k <= 40; ++k) {
            const Transform then = interpolate(first, second, k / 40.0);
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3 p = then.apply({corner & 1 ? box.min.x : box.max.x, corner & 2 ? box.min.y : box.max.y,
                                           corner & 4 ? box.min.z : box.max.z});
                seen = {min(seen.min, p), max(seen.max, p)};
                for (int axis = 0; axis < 3; ++axis) {
                    REQUIRE(p[axis] >= all.min[axis]);
                    REQUIRE(p[axis] <= all.max[axis]);
                }
            }
        }
        if (!turns) largest = std::max(largest, length((all.max - all.min) - (seen.max - seen.min)));
        REQUIRE(gphys_scene_remove(world.scene, model) == GPHYS_OK);
    }
    // Without rotation, up to the rounding of float32.
    CHECK(largest < 1e-4);
}

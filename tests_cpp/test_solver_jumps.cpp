// Models that jump: characters that respawn, crates that an editor moves, platforms that are reset.
#include "snapshots.h"
#include "solver_world.h"

using namespace gphys;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;
const gphys_quat turned{0, 0.8f, 0, 0.6f};

/// A cape or a rope that swings from a small model.
struct Carried {
    World world;
    gphys_model_id model;
    gphys_body_id body;
    gphys_transform at{{0, 0, 0}, {0, 0, 0, 1}, 1};

    explicit Carried(bool is_cloth) {
        const gphys_sphere ball{{0, 0, 0}, 0.01f};
        model = world.model(GPHYS_SHAPE_SPHERE, &ball);
        if (is_cloth) {
            body = world.cloth({0, 0, 0}, {1, 0, 0}, {0, -0.7f, 0.7f}, 9, 9);
            for (uint32_t p = 0; p < 9; ++p) attach(p);
        } else {
            body = world.rope(test::line({0, 0, 0}, {0.03f, -0.04f, 0}, 20), 0);
            attach(0);
        }
    }
    void attach(uint32_t particle) {
        REQUIRE(gphys_solver_attach(world.solver, world.scene, body, particle, model, nullptr) == GPHYS_OK);
    }
    void step() {
        REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
        world.step(dt);
    }
    double fastest() const {
        double most = 0;
        for (const gphys_vec3& v : world.velocities(body)) most = std::max(most, length(widen(v)));
        return most;
    }
    /// As a jump does: the next step begins with a scheme that needs no step before it.
    void interrupt() {
        const std::vector<gphys_vec3> all = world.velocities(body);
        REQUIRE(gphys_solver_set_velocities(world.solver, body, 0, static_cast<uint32_t>(all.size()), all.data(), 12) ==
                GPHYS_OK);
    }
    /// Of particles that are not attached.
    Vec3 mean_velocity() const {
        Vec3 sum;
        const std::vector<gphys_vec3> all = world.velocities(body);
        for (size_t p = 10; p < all.size(); ++p) sum += widen(all[p]);
        return sum / static_cast<double>(all.size() - 10);
    }
};

}  // namespace

TEST_CASE("a body that is attached to a model that jumps goes with it as a rigid body") {
    for (const bool is_cloth : {false, true}) {
        for (const float far : {0.0f, 2.0f, 30.0f, 1000.0f}) {
            for (const bool turns : {false, true}) {
                if (far == 0 && !turns) continue;
                CAPTURE(is_cloth, far, turns);
                Carried still(is_cloth), jumping(is_cloth);
                // A sheet that swings is chaotic: in a second and a half rounding errors grow to centimetres.
                for (int frame = 0; frame < (is_cloth ? 40 : 120); ++frame) {
                    if (frame == 20) {
                        jumping.at.position = {far, 0.5f * far, -0.1f * far};
                        if (turns) jumping.at.rotation = turned;
                        still.interrupt();
                    }
                    still.step();
                    jumping.step();
                    REQUIRE(jumping.world.stats(jumping.body).strain_max < 0.05);
                }
                const Transform there = widen(jumping.at);
                const std::vector<gphys_vec3> expected = still.world.positions(still.body),
                                              found = jumping.world.positions(jumping.body);
                double worst = 0;
                for (size_t p = 0; p < found.size(); ++p)
                    worst = std::max(worst, distance(widen(found[p]), there.apply(widen(expected[p]))));
                test::figure("off after a jump", worst * 1e3, "mm");
                // Positions are reported in float32, in which cloth is also relaxed.
                CHECK(worst < (is_cloth ? 1e-3 : 1e-5) + 1e-7 * far);
            }
        }
    }
}

TEST_CASE("what lies on a model that jumps away stays and gets no speed") {
    for (const int kind : {0, 1, 2}) {
        for (const float far : {3.0f, 100.0f}) {
            for (const gphys_vec3 way : {gphys_vec3{1, 0, 0}, gphys_vec3{0, -1, 0}, gphys_vec3{0.6f, 0.8f, 0}}) {
                CAPTURE(kind, far, way.x, way.y);
                World world;
                const gphys_aabb crate{{-2, -1, -2}, {2, 0, 2}};
                const gphys_model_id model = world.model(GPHYS_SHAPE_AABB, &crate);
                const std::vector<gphys_vec3> line = test::line({-0.5f, 0.0101f, 0}, {0.1f, 0, 0}, 10);
                const gphys_body_id body = kind == 0   ? world.particles(line)
                                           : kind == 1 ? world.rope(line, 0)
                                                       : world.cloth({-1, 0.0101f, -1}, {2, 0, 0}, {0, 0, 2}, 10, 10);
                for (int i = 0; i < 30; ++i) world.step(dt);
                const std::vector<gphys_vec3> before = world.positions(body);
                const gphys_transform to{{far * way.x, far * way.y, far * way.z}, {0, 0, 0, 1}, 1};
                REQUIRE(gphys_scene_set_transform(world.scene, model, &to) == GPHYS_OK);
                world.step(dt);
                const std::vector<gphys_vec3> after = world.positions(body);
                for (size_t p = 0; p < after.size(); ++p) REQUIRE(distance(widen(before[p]), widen(after[p])) < 0.02);
                for (const gphys_vec3& v : world.velocities(body)) REQUIRE(length(widen(v)) < 1.2);
            }
        }
    }
}

TEST_CASE("a crate that jumps past a curtain does not sweep it along") {
    World world;
    const gphys_aabb crate{{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}};
    gphys_transform at{{0, -0.5f, -0.8f}, {0, 0, 0, 1}, 1};
    const gphys_model_id model = world.model(GPHYS_SHAPE_AABB, &crate, &at);
    const gphys_body_id curtain = world.cloth({-0.5f, 0, 0}, {1, 0, 0}, {0, -1, 0}, 10, 10);
    REQUIRE(gphys_solver_set_pinned(world.solver, curtain, 0, 10, 1) == GPHYS_OK);
    for (int i = 0; i < 60; ++i) {
        if (i == 10) at.position.z = 5;
        REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
        world.step(dt);
        for (const gphys_vec3& p : world.positions(curtain)) REQUIRE(std::fabs(p.z) < 0.05f);
    }
}

TEST_CASE("a model that is fast for long does not jump: it tows what is attached to it") {
    for (const bool is_cloth : {false, true}) {
        CAPTURE(is_cloth);
        Carried towed(is_cloth);
        double speed = 0, x = 0;
        for (int frame = 0; frame < 240; ++frame) {
            speed = std::min(100.0, speed + 0.5);
            x += speed * double{dt};
            towed.at.position.x = static_cast<float>(x);
            towed.step();
        }
        CHECK(length(towed.mean_velocity() - Vec3{100, 0, 0}) < 20);
    }
}

TEST_CASE("the motion of a whole frame is not a jump of its first step") {
    Carried towed(false);
    double speed = 0, x = 0;
    for (int frame = 0; frame < 100; ++frame) {  // of six steps
        speed = std::min(30.0, speed + 3.0);
        x += speed * 0.1;
        towed.at.position.x = static_cast<float>(x);
        REQUIRE(gphys_scene_set_transform(towed.world.scene, towed.model, &towed.at) == GPHYS_OK);
        REQUIRE(gphys_solver_advance(towed.world.solver, towed.world.scene, 0.1f, nullptr, nullptr) == GPHYS_OK);
    }
    const std::vector<gphys_vec3> places = towed.world.positions(towed.body);
    CHECK(std::fabs(places.back().x - x) < 2);
    CHECK(towed.fastest() > 10);
}

TEST_CASE("a body that is pinned elsewhere, too, does not jump with a model") {
    Carried held(false);
    held.world.pin(held.body, 19);
    for (int frame = 0; frame < 20; ++frame) held.step();
    const Vec3 pin = held.world.position(held.body, 19);
    held.at.position = {0, 3, 0};
    held.step();
    CHECK(held.world.position(held.body, 19) == pin);
    CHECK(distance(held.world.position(held.body, 0), Vec3{0, 3, 0}) < 1e-6);
}

TEST_CASE("a model grows as it would with another scale: a large change of the transform's scale gives no speed") {
    World world;
    const gphys_aabb crate{{-1, -1, -1}, {1, 1, 1}};
    const gphys_model_id model = world.model(GPHYS_SHAPE_AABB, &crate);
    const gphys_body_id body = world.particles({{0, 1.0101f, 0}, {0.5f, 1.0101f, 0.5f}});
    for (int i = 0; i < 30; ++i) world.step(dt);
    const gphys_transform grown{{0, 0, 0}, {0, 0, 0, 1}, 3};
    REQUIRE(gphys_scene_set_transform(world.scene, model, &grown) == GPHYS_OK);
    for (int i = 0; i < 30; ++i) {
        world.step(dt);
        for (const gphys_vec3& v : world.velocities(body)) REQUIRE(length(widen(v)) < 1.2);
    }
}

TEST_CASE("a restored solver knows how fast models were") {
    Carried towed(false);
    double speed = 0;
    const auto move = [&] {
        speed = std::min(100.0, speed + 1.0);
        towed.at.position.x += static_cast<float>(speed) * dt;
    };
    for (int frame = 0; frame < 120; ++frame) {
        move();
        towed.step();
    }
    const std::vector<uint32_t> words = test::snapshot(towed.world.solver);
    move();
    towed.step();
    const std::vector<gphys_vec3> expected = towed.world.positions(towed.body);
    REQUIRE(gphys_solver_restore(towed.world.solver, words.data(), static_cast<uint32_t>(words.size())) == GPHYS_OK);
    towed.world.step(dt);
    const std::vector<gphys_vec3> found = towed.world.positions(towed.body);
    for (size_t p = 0; p < found.size(); ++p) REQUIRE(widen(found[p]) == widen(expected[p]));
}

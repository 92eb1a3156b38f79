// Pins that the caller moves, and attached particles whose model stops.
#include "snapshots.h"
#include "solver_world.h"

using namespace gphys;
using test::World;

namespace {

constexpr float dt = 1.0f / 60;

void move_pin(const World& world, gphys_body_id body, uint32_t particle, gphys_vec3 to) {
    REQUIRE(gphys_solver_set_positions(world.solver, body, particle, 1, &to, 12) == GPHYS_OK);
}

gphys_body_id hanging_rope(World& world, uint32_t count, float length) {
    const float link = length / static_cast<float>(count - 1);
    return world.rope(test::line({0, 0, 0}, {0, -link, 0}, count), 0);
}

/// A hand that is moved each frame: by the pin itself, or by a model that the particle is attached to.
struct Hand {
    World world;
    gphys_body_id body = 0;
    gphys_model_id model = 0;

    template <class Make>
    Hand(bool is_model, const Make& make) : body(make(world)) {
        if (!is_model) {
            world.pin(body, 0);
            return;
        }
        const gphys_sphere ball{{0, 0, 0}, 0.01f};
        model = world.model(GPHYS_SHAPE_SPHERE, &ball);
        const gphys_vec3 middle{0, 0, 0};
        REQUIRE(gphys_solver_attach(world.solver, world.scene, body, 0, model, &middle) == GPHYS_OK);
    }
    void move(gphys_vec3 to) {
        if (model == 0) return move_pin(world, body, 0, to);
        const gphys_transform at{to, {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transform(world.scene, model, &at) == GPHYS_OK);
    }
};

gphys_body_desc without_contacts() {
    gphys_body_desc desc = World::body_desc();
    desc.layers = 0;
    return desc;
}

}  // namespace

TEST_CASE("a rope follows a pin that is moved each frame, however fast") {
    for (const uint32_t count : {10u, 60u, 200u}) {
        for (const float speed : {1.5f, 4.0f, 12.0f}) {
            World world;
            const gphys_body_id rope = hanging_rope(world, count, 2);
            world.pin(rope, 0);
            for (int frame = 0; frame < 120; ++frame) {
                const gphys_vec3 to{speed * dt * static_cast<float>(frame), 0, 0};
                move_pin(world, rope, 0, to);
                world.step(dt);
                REQUIRE(world.position(rope) == widen(to));
                INFO(count << " particles, " << speed << " m/s, frame " << frame);
                REQUIRE(world.stats(rope).strain_max < 1e-4);
            }
        }
    }
}

TEST_CASE("a moved pin pulls a body as a model does that it is attached to") {
    const auto rope = [](World& world) { return hanging_rope(world, 30, 1); };
    const auto cloth = [](World& world) {
        return world.cloth({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 12, 12, without_contacts());
    };
    const auto compare = [](const auto& make) {
        Hand pin(false, make), model(true, make);
        pin.world.step(dt), model.world.step(dt);
        for (int frame = 1; frame <= 40; ++frame) {
            const float way = 0.04f * static_cast<float>(frame);
            pin.move({way, 0, 0.5f * way}), model.move({way, 0, 0.5f * way});
            pin.world.step(dt), model.world.step(dt);
            const auto a = pin.world.positions(pin.body), b = model.world.positions(model.body);
            INFO("frame " << frame);
            // The rounding of float32, 6e-8 m, grown within forty frames.
            for (size_t i = 0; i < a.size(); ++i) REQUIRE(distance(widen(a[i]), widen(b[i])) < 1e-5);
        }
    };
    compare(rope);
    compare(cloth);
}

TEST_CASE("a pin that has been moved stays where it is, and so does an attached particle whose model stops") {
    for (const bool is_model : {false, true}) {
        Hand hand(is_model, [](World& world) {
            return world.cloth({0, 0, 0}, {1, 0, 0}, {0, -1, 0}, 12, 12, without_contacts());
        });
        for (int frame = 1; frame <= 40; ++frame) {
            const float way = 0.05f * static_cast<float>(std::min(frame, 20));
            if (frame <= 20) hand.move({way, 0, 0});
            hand.world.step(dt);
            REQUIRE(hand.world.position(hand.body).x == Approx(way).margin(1e-6));
        }
    }
}

TEST_CASE("a rope whose pin jumps farther than it is long gets its length back at once") {
    for (const float jump : {0.2f, 1.9f, 50.0f}) {
        World world;
        const gphys_body_id rope = hanging_rope(world, 60, 2);
        world.pin(rope, 0);
        for (int frame = 0; frame < 90; ++frame) {
            if (frame == 30) move_pin(world, rope, 0, {jump, 0, 0});
            world.step(dt);
            REQUIRE(world.stats(rope).strain_max < 1e-3);
        }
    }
}

TEST_CASE("a body that is placed with its pins is there at once") {
    for (const bool pins_first : {false, true}) {
        World world(8, {0, 0, 0});
        const gphys_body_id rope = hanging_rope(world, 20, 1);
        world.pin(rope, 0);
        world.step(dt);
        std::vector<gphys_vec3> places = world.positions(rope);
        for (gphys_vec3& place : places) place.x += 5;
        const auto place = [&](uint32_t first, uint32_t count) {
            REQUIRE(gphys_solver_set_positions(world.solver, rope, first, count, &places[first], 12) == GPHYS_OK);
        };
        if (pins_first) place(0, 1);
        place(1, 19);
        if (!pins_first) place(0, 1);
        for (int frame = 0; frame < 10; ++frame) world.step(dt);
        for (uint32_t i = 0; i < 20; ++i) REQUIRE(distance(world.position(rope, i), widen(places[i])) < 1e-6);
        REQUIRE(world.stats(rope).kinetic_energy < 1e-9);
    }
}

TEST_CASE("a moved pin is no attachment, and is in a snapshot") {
    World world, other;
    const gphys_body_id rope = hanging_rope(world, 20, 1);
    world.pin(rope, 0);
    world.step(dt);
    move_pin(world, rope, 0, {0.3f, 0, 0});
    REQUIRE(world.position(rope).x == Approx(0.3));
    uint32_t total = 7;
    REQUIRE(gphys_solver_get_attachments(world.solver, rope, nullptr, 0, &total) == GPHYS_OK);
    REQUIRE(total == 0);
    REQUIRE(gphys_solver_detach(world.solver, rope, 0) == GPHYS_ERROR_INVALID_ARGUMENT);
    const std::vector<uint32_t> words = test::snapshot(world.solver);
    REQUIRE(test::restore(other.solver, words) == GPHYS_OK);
    for (int frame = 0; frame < 30; ++frame) world.step(dt), other.step(dt);
    REQUIRE(test::hash(world.solver) == test::hash(other.solver));
}

TEST_CASE("a pin that is released after it was moved falls from where it is") {
    World world;
    const gphys_body_id rope = hanging_rope(world, 20, 1);
    world.pin(rope, 0);
    world.step(dt);
    move_pin(world, rope, 0, {0.3f, 0, 0});
    REQUIRE(gphys_solver_set_pinned(world.solver, rope, 0, 1, 0) == GPHYS_OK);
    world.step(dt);
    REQUIRE(world.position(rope).y < 0);
    REQUIRE(test::all_finite(world.positions(rope)));
}

// Bodies at rest: when they fall asleep, what wakes them, and what they cost.
#include <chrono>

#include "resources.h"
#include "snapshots.h"

using test::figure;
using test::MeshHandle;
using test::World;

namespace {

/// A world whose bodies may sleep.
struct Quiet : World {
    gphys_model_id floor = 0;

    explicit Quiet(float speed = 0.01f, float strain = 0.01f) {
        gphys_solver_destroy(solver);
        gphys_solver_desc desc;
        gphys_solver_desc_init(&desc, sizeof desc);
        desc.sleep_speed = speed;
        desc.sleep_strain = strain;
        desc.sleep_time = 0.25f;
        REQUIRE(gphys_solver_create(&desc, &solver) == GPHYS_OK);
        const gphys_plane plane{{0, 1, 0}, 0};
        floor = model(GPHYS_SHAPE_PLANE, &plane);
    }
    gphys_model_id box(gphys_vec3 at) {
        const gphys_aabb cube{{-0.05f, -0.05f, -0.05f}, {0.05f, 0.05f, 0.05f}};
        const gphys_transform place{at, {0, 0, 0, 1}, 1};
        return model(GPHYS_SHAPE_AABB, &cube, &place);
    }
    void place(gphys_model_id model, gphys_vec3 at) {
        const gphys_transform place{at, {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transforms(scene, &model, &place, sizeof place, 1) == GPHYS_OK);
    }
    gphys_body_id lying_rope(float z = 0) {
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 10; ++i) points.push_back({0.05f * static_cast<float>(i), 0.02f, z});
        return rope(points, 0);
    }
    void run(int frames) {
        for (int i = 0; i < frames; ++i) step(1.0f / 60);
    }
    std::vector<gphys_body_id> sleeping() const {
        uint32_t total = 0;
        gphys_solver_get_sleeping(solver, nullptr, 0, &total);
        std::vector<gphys_body_id> bodies(total);
        REQUIRE(gphys_solver_get_sleeping(solver, bodies.data(), total, &total) == GPHYS_OK);
        return bodies;
    }
    bool asleep(gphys_body_id body) const {
        const std::vector<gphys_body_id> all = sleeping();
        return std::find(all.begin(), all.end(), body) != all.end();
    }
};

}  // namespace

TEST_CASE("a body that lies still sleeps, one that moves or is strained does not") {
    Quiet world;
    const gphys_body_id rope = world.lying_rope();
    const gphys_body_id swinging = world.rope({{0, 3, 0}, {1, 3, 0}, {2, 3, 0}}, 0);
    world.pin(swinging, 0);
    const gphys_body_id strained = world.rope({{0, 5, 0}, {1, 5, 0}, {2, 5, 0}}, 0.9f);
    world.pin(strained, 0);
    world.pin(strained, 2);
    world.run(10);
    CHECK(world.sleeping().empty());
    world.run(80);
    CHECK(world.sleeping() == std::vector<gphys_body_id>{rope});
    CHECK(world.stats(rope).kinetic_energy == 0);
    CHECK(world.stats(rope).contact_count == 10);
    const std::vector<gphys_vec3> before = world.positions(rope);
    world.run(60);
    CHECK(std::memcmp(before.data(), world.positions(rope).data(), before.size() * sizeof before[0]) == 0);
    CHECK(world.stats(rope).contact_count == 10);
    CHECK(world.asleep(rope));

    Quiet awake(0);
    const gphys_body_id never = awake.lying_rope();
    awake.run(90);
    CHECK(!awake.asleep(never));
}

TEST_CASE("what happens to a sleeping body wakes it, and what happens far away does not") {
    Quiet world;
    const gphys_model_id near = world.box({0.2f, 0.06f, 0.0701f}), far = world.box({50, 1, 0});
    const gphys_body_id rope = world.lying_rope();
    const auto falls_asleep = [&] {
        world.run(60);
        return world.asleep(rope);
    };
    const auto woken = [&] {
        const bool at_once = !world.asleep(rope);
        world.run(1);
        const bool is = at_once || !world.asleep(rope);
        return is && falls_asleep();
    };
    REQUIRE(falls_asleep());
    world.place(far, {50, 2, 0});
    world.run(1);
    CHECK(world.asleep(rope));
    const gphys_model_id another_far = world.box({-50, 2, 0});
    world.run(1);
    REQUIRE(gphys_scene_remove(world.scene, another_far) == GPHYS_OK);
    world.run(1);
    CHECK(world.asleep(rope));

    world.place(near, {0.2f, 0.06f, 0.0702f});
    CHECK(woken());
    world.place(near, {0.2f, 5, 0});
    CHECK(woken());
    world.place(near, {0.2f, 0.06f, -0.0701f});
    CHECK(woken());
    REQUIRE(gphys_scene_remove(world.scene, near) == GPHYS_OK);
    CHECK(woken());
    REQUIRE(gphys_solver_wake(world.solver, rope) == GPHYS_OK);
    CHECK(woken());
    REQUIRE(gphys_solver_wake(world.solver, 0) == GPHYS_OK);
    CHECK(woken());
    const gphys_vec3 gravity{0, -9, 0}, push{0, 0, 0.0001f};
    const float amount = 0.011f;
    REQUIRE(gphys_solver_set_gravity(world.solver, &gravity) == GPHYS_OK);
    CHECK(woken());
    REQUIRE(gphys_solver_set_gravity(world.solver, &gravity) == GPHYS_OK);
    CHECK(world.asleep(rope));
    REQUIRE(gphys_solver_set_forces(world.solver, rope, 0, 1, &push, 0) == GPHYS_OK);
    CHECK(woken());
    REQUIRE(gphys_solver_set_radii(world.solver, rope, 0, 1, &amount, 0) == GPHYS_OK);
    CHECK(woken());
    REQUIRE(gphys_solver_set_masses(world.solver, rope, 0, 1, &amount, 0) == GPHYS_OK);
    CHECK(woken());
    world.pin(rope, 9);
    CHECK(woken());
    const double origin[3] = {0, 0, 1};
    REQUIRE(gphys_scene_set_origin(world.scene, origin) == GPHYS_OK);
    REQUIRE(gphys_solver_set_origin(world.solver, origin) == GPHYS_OK);
    CHECK(woken());

    REQUIRE(gphys_solver_set_pinned(world.solver, rope, 9, 1, 0) == GPHYS_OK);
    REQUIRE(falls_asleep());
    REQUIRE(gphys_scene_remove(world.scene, world.floor) == GPHYS_OK);
    world.run(30);
    CHECK(!world.asleep(rope));
    CHECK(world.position(rope).y < -0.5);
}

TEST_CASE("a sleeping rope without its scene falls, and one that hangs on a model follows it") {
    Quiet world;
    const gphys_body_id rope = world.lying_rope();
    const gphys_model_id hook = world.box({0, 5, 0});
    const gphys_body_id hanging = world.rope({{0, 4.9f, 0}, {0, 4.4f, 0}}, 0);
    REQUIRE(gphys_solver_attach(world.solver, world.scene, hanging, 0, hook, nullptr) == GPHYS_OK);
    world.run(60);
    REQUIRE(world.sleeping().size() == 2);
    world.place(hook, {1, 5, 0});
    world.run(1);
    CHECK(world.sleeping() == std::vector<gphys_body_id>{rope});
    CHECK(std::fabs(world.position(hanging).x - 1) < 1e-6);
    REQUIRE(gphys_solver_step(world.solver, nullptr, 0.1f) == GPHYS_OK);
    CHECK(world.position(rope).y < -0.01);
}

TEST_CASE("a thin wall takes sleeping particles along") {
    Quiet world;
    const gphys_vec3 none{0, 0, 0};
    REQUIRE(gphys_solver_set_gravity(world.solver, &none) == GPHYS_OK);
    const gphys_body_id body = world.particles({{0, 0.5f, 0}, {0, 0.5f, 0.1f}});
    const gphys_aabb plate{{-0.0005f, 0, -1}, {0.0005f, 1, 1}};
    gphys_transform place{{-1.1f, 0, 0}, {0, 0, 0, 1}, 1};
    const gphys_model_id wall = world.model(GPHYS_SHAPE_AABB, &plate, &place);
    world.run(60);
    REQUIRE(world.asleep(body));
    // 12 m/s: a step takes it from well before the particles to well behind them.
    for (int i = 0; i < 60; ++i) {
        place.position.x = -1.1f + 0.2f * static_cast<float>(i);
        world.place(wall, place.position);
        world.run(1);
    }
    for (uint32_t p = 0; p < 2; ++p) CHECK(world.position(body, p).x > static_cast<double>(place.position.x));
}

TEST_CASE("a step of 1000 sleeping ropes costs next to nothing", "[simulation]") {
    Quiet world;
    std::vector<gphys_body_id> ropes;
    for (int i = 0; i < 1000; ++i) ropes.push_back(world.lying_rope(static_cast<float>(i)));
    const auto step_time = [&](int steps) {
        double best = 1e9;
        for (int i = 0; i < steps; ++i) {
            const auto start = std::chrono::steady_clock::now();
            world.run(1);
            best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
        return best;
    };
    const double awake = step_time(10);
    CHECK(world.sleeping().empty());
    world.run(30);
    REQUIRE(world.sleeping().size() == 1000);
    const double asleep = step_time(20);
    figure("1000 ropes awake", awake * 1e3, "ms a step");
    figure("1000 ropes asleep", asleep * 1e3, "ms a step");
    CHECK(asleep < awake / 20);
}

namespace {

/// A square of two triangles, one of which has a corner further down than the plane y = 0; whatever that is, the box
/// around it, which has more corners, is the same.
MeshHandle square(float corner) {
    return MeshHandle({-2, 0, -2, 2, 0, -2, -2, 0, 2, 2, corner, 2, 3, -1, 3, 3, -1, 4, 4, -1, 3},
                      {0, 2, 1, 1, 2, 3, 4, 5, 6});
}

gphys_model_id ground(World& world, float height) {
    const gphys_aabb box{{-5, -1, -5}, {5, height, 5}};
    return world.model(GPHYS_SHAPE_AABB, &box);
}

}  // namespace

TEST_CASE("a sleeper wakes in another scene whose models have the same ids and other shapes") {
    Quiet world;
    REQUIRE(gphys_scene_remove(world.scene, world.floor) == GPHYS_OK);
    World other, same;
    const gphys_model_id here = ground(world, 0);
    REQUIRE(gphys_scene_remove(other.scene, ground(other, 0)) == GPHYS_OK);
    REQUIRE(gphys_scene_remove(same.scene, ground(same, 0)) == GPHYS_OK);
    REQUIRE(ground(other, -0.5f) == here);
    REQUIRE(ground(same, 0) == here);
    const gphys_body_id rope = world.lying_rope();
    world.run(90);
    REQUIRE(world.asleep(rope));
    for (int i = 0; i < 10; ++i) REQUIRE(gphys_solver_step(world.solver, same.scene, 1.0f / 60) == GPHYS_OK);
    CHECK(world.asleep(rope));
    REQUIRE(gphys_solver_step(world.solver, other.scene, 1.0f / 60) == GPHYS_OK);
    CHECK(!world.asleep(rope));
    for (int i = 0; i < 90; ++i) REQUIRE(gphys_solver_step(world.solver, other.scene, 1.0f / 60) == GPHYS_OK);
    for (const gphys_vec3& p : world.positions(rope)) CHECK(std::fabs(p.y + 0.49f) < 1e-3f);
}

TEST_CASE("a sleeper on a mesh sleeps on in another scene with an equal mesh, and wakes on another mesh") {
    const MeshHandle flat = square(0), copy = square(0), bent = square(-0.5f);
    Quiet world;
    REQUIRE(gphys_scene_remove(world.scene, world.floor) == GPHYS_OK);
    World equal, other;
    const gphys_plane nothing{{0, 1, 0}, -100};
    for (World* each : {&equal, &other}) {
        REQUIRE(gphys_scene_remove(each->scene, each->model(GPHYS_SHAPE_PLANE, &nothing)) == GPHYS_OK);
    }
    const gphys_model_id here = world.model(GPHYS_SHAPE_MESH, flat.mesh);
    REQUIRE(equal.model(GPHYS_SHAPE_MESH, copy.mesh) == here);
    REQUIRE(other.model(GPHYS_SHAPE_MESH, bent.mesh) == here);
    const gphys_body_id rope = world.lying_rope(0.5f);
    world.run(90);
    REQUIRE(world.asleep(rope));
    const uint64_t calm = test::hash(world.solver);
    // The hash of a state must not hold an address.
    for (int i = 0; i < 10; ++i) REQUIRE(gphys_solver_step(world.solver, equal.scene, 1.0f / 60) == GPHYS_OK);
    CHECK(world.asleep(rope));
    CHECK(test::hash(world.solver) == calm);
    REQUIRE(gphys_solver_step(world.solver, other.scene, 1.0f / 60) == GPHYS_OK);
    CHECK(!world.asleep(rope));
}

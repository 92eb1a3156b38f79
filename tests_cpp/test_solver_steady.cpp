// Bodies that a step leaves exactly as they were are not moved again. Nothing may show that but the time: every case
// runs beside a solver that moves all bodies in every step, because it is restored from its own snapshot before each.
#include <chrono>
#include <functional>

#include "c_api/handles.h"
#include "snapshots.h"
#include "solver/solver.h"

using test::figure;
using test::World;

namespace {

constexpr float frame = 1.0f / 60;

/// Bodies of each kind that come to lie still on a floor, with models around them.
struct Room : World {
    gphys_model_id floor = 0, box = 0, far_box = 0, anchor = 0;
    gphys_body_id cloth_body = 0, rope_body = 0, particle_body = 0;

    Room() {
        const gphys_plane plane{{0, 1, 0}, 0};
        floor = model(GPHYS_SHAPE_PLANE, &plane);
        const gphys_aabb cube{{-0.2f, -0.2f, -0.2f}, {0.2f, 0.2f, 0.2f}};
        const gphys_transform near{{0.5f, 0.2f, -0.3f}, {0, 0, 0, 1}, 1}, far{{0.5f, 3, 0.5f}, {0, 0, 0, 1}, 1};
        box = model(GPHYS_SHAPE_AABB, &cube, &near);
        far_box = model(GPHYS_SHAPE_AABB, &cube, &far);
        gphys_body_desc desc = body_desc();
        desc.body_layers = 1;
        cloth_body = cloth({0, 0.2f, 0}, {1, 0.2f, 0}, {0, 0, 1}, 12, 12, desc);
        rope_body = rope(test::line({3, 0.5f, 0}, {0.1f, 0.01f, 0}, 31), 0, desc);
        particle_body = particles(test::line({-3, 0.1f, 0}, {0.3f, 0.05f, 0}, 5), test::point_mass(0.05f, 0.5f, 0.3f));
        // To a model that is far from the body.
        const gphys_transform away{{50, 50, 50}, {0, 0, 0, 1}, 1};
        anchor = model(GPHYS_SHAPE_AABB, &cube, &away);
        const gphys_vec3 local{-53, -49.9f, -50};
        REQUIRE(gphys_solver_attach(solver, scene, particle_body, 0, anchor, &local) == GPHYS_OK);
    }
    void place(gphys_model_id model, gphys_vec3 at) {
        const gphys_transform place{at, {0, 0, 0, 1}, 1};
        REQUIRE(gphys_scene_set_transforms(scene, &model, &place, sizeof place, 1) == GPHYS_OK);
    }
    void run(int frames, float dt = frame) {
        for (int i = 0; i < frames; ++i) step(dt);
    }
    void run_moving_all(int frames, float dt = frame) {
        for (int i = 0; i < frames; ++i) {
            REQUIRE(test::restore(solver, test::snapshot(solver)) == GPHYS_OK);
            step(dt);
        }
    }
    /// Those that come to lie quite still; the tensions of a rope may change by rounding for ever.
    std::vector<gphys_body_id> bodies() const { return {cloth_body, rope_body, particle_body}; }
    bool is_steady(gphys_body_id body) const {
        const gphys::Solver& internals = *gphys::unwrap(solver);
        return internals.body(body).steady.found;
    }
    std::vector<gphys_impulse> impulses() const {
        uint32_t total = 0;
        gphys_solver_get_impulses(solver, nullptr, 0, &total);
        std::vector<gphys_impulse> all(total);
        REQUIRE(gphys_solver_get_impulses(solver, all.data(), total, &total) == GPHYS_OK);
        return all;
    }
};

bool same_impulses(const Room& a, const Room& b) {
    const std::vector<gphys_impulse> of_a = a.impulses(), of_b = b.impulses();
    return of_a.size() == of_b.size() && std::memcmp(of_a.data(), of_b.data(), of_a.size() * sizeof of_a[0]) == 0;
}

struct Event {
    const char* name;
    std::function<void(Room&)> happens;
    float dt = frame;
};

const std::vector<Event>& events() {
    static const std::vector<Event> all{
        {"nothing", [](Room&) {}},
        {"a step of another length", [](Room&) {}, 1.0f / 90},
        {"a model comes near",
         [](Room& r) {
             r.place(r.far_box, {0.5f, 0.1f, 0.5f});
         }},
        {"the floor sinks",
         [](Room& r) {
             r.place(r.floor, {0, -0.5f, 0});
         }},
        {"the floor goes", [](Room& r) { REQUIRE(gphys_scene_remove(r.scene, r.floor) == GPHYS_OK); }},
        {"the floor is in other layers",
         [](Room& r) { REQUIRE(gphys_scene_set_layers(r.scene, r.floor, 0x80000000u) == GPHYS_OK); }},
        {"the floor has another tag", [](Room& r) { REQUIRE(gphys_scene_set_tag(r.scene, r.floor, 77) == GPHYS_OK); }},
        {"a model with an attached particle moves",
         [](Room& r) {
             r.place(r.anchor, {50, 50.01f, 50});
         }},
        {"a model with an attached particle goes",
         [](Room& r) { REQUIRE(gphys_scene_remove(r.scene, r.anchor) == GPHYS_OK); }},
        {"a shape changes in place",
         [](Room& r) {
             const gphys_aabb larger{{-0.5f, -0.3f, -0.5f}, {0.5f, 0.3f, 0.5f}};
             REQUIRE(gphys_scene_set_shape(r.scene, r.box, GPHYS_SHAPE_AABB, &larger) == GPHYS_OK);
         }},
        {"a model is added",
         [](Room& r) {
             const gphys_sphere ball{{0.5f, 0.05f, 0.5f}, 0.1f};
             r.model(GPHYS_SHAPE_SPHERE, &ball);
         }},
        {"gravity turns",
         [](Room& r) {
             const gphys_vec3 aside{4, -9, 0};
             REQUIRE(gphys_solver_set_gravity(r.solver, &aside) == GPHYS_OK);
         }},
        {"other substeps", [](Room& r) { REQUIRE(gphys_solver_set_substeps(r.solver, 3) == GPHYS_OK); }},
        {"bodies may sleep",
         [](Room& r) {
             gphys_solver_settings settings{};
             REQUIRE(gphys_solver_get_settings(r.solver, &settings) == GPHYS_OK);
             settings.sleep_speed = 0.01f;
             REQUIRE(gphys_solver_set_settings(r.solver, &settings) == GPHYS_OK);
         }},
        {"work is bounded",
         [](Room& r) {
             gphys_solver_settings settings{};
             REQUIRE(gphys_solver_get_settings(r.solver, &settings) == GPHYS_OK);
             settings.max_work = 500;
             REQUIRE(gphys_solver_set_settings(r.solver, &settings) == GPHYS_OK);
         }},
        {"velocities",
         [](Room& r) {
             r.set_velocity(r.cloth_body, 70, {0, 2, 0});
             r.set_velocity(r.rope_body, 5, {0, 2, 0});
             r.set_velocity(r.particle_body, 2, {0, 2, 0});
         }},
        {"forces",
         [](Room& r) {
             const gphys_vec3 up{0, 30, 0};
             for (const gphys_body_id body : {r.cloth_body, r.rope_body, r.particle_body})
                 REQUIRE(gphys_solver_set_forces(r.solver, body, 0, 3, &up, 0) == GPHYS_OK);
         }},
        {"wind",
         [](Room& r) {
             const gphys_wind wind{{0, 12, 3}, 1.2f, 1.2f, 1.2f};
             REQUIRE(gphys_solver_set_wind(r.solver, 0, &wind) == GPHYS_OK);
         }},
        {"pins and a lost constraint",
         [](Room& r) {
             r.pin(r.cloth_body, 3);
             gphys_constraint_info info{};
             uint32_t total = 0;
             gphys_solver_get_constraints(r.solver, r.cloth_body, &info, 1, &total);
             REQUIRE(gphys_solver_remove_constraint(r.solver, r.cloth_body, info.id) == GPHYS_OK);
         }},
        {"animation targets",
         [](Room& r) {
             gphys_animation_target target{};
             target.position = {0.5f, 1, 0.5f};
             target.max_distance = 0.5f;
             target.backstop = std::numeric_limits<float>::infinity();
             REQUIRE(gphys_solver_set_animation_targets(r.solver, r.cloth_body, 60, 1, &target, sizeof target) ==
                     GPHYS_OK);
         }},
        {"another body falls on them",
         [](Room& r) {
             gphys_body_desc desc = World::body_desc();
             desc.body_layers = 1;
             desc.radius = 0.05f;
             r.rope(test::line({0.3f, 0.3f, 0.5f}, {0.05f, 0, 0}, 8), 0, desc);
         }},
        {"another body passes over them",
         [](Room& r) {
             gphys_body_desc desc = World::body_desc();
             desc.body_layers = 1;
             desc.radius = 0.05f;
             desc.friction = 0.2f;
             const gphys_body_id visitor = r.rope(test::line({0.1f, 0.1f, 0.6f}, {0.05f, 0, 0}, 8), 0, desc);
             const gphys_vec3 fast{8, 0, 3};
             REQUIRE(gphys_solver_set_velocities(r.solver, visitor, 0, 8, &fast, 0) == GPHYS_OK);
         }},
        {"another origin",
         [](Room& r) {
             const double origin[3] = {0.25, 0, 0};
             REQUIRE(gphys_solver_set_origin(r.solver, origin) == GPHYS_OK);
             REQUIRE(gphys_scene_set_origin(r.scene, origin) == GPHYS_OK);
         }},
        {"a joint",
         [](Room& r) {
             gphys_joint_id joint = 0;
             REQUIRE(gphys_solver_join(r.solver, r.cloth_body, 0, r.rope_body, 0, 2.0f, 0, &joint) == GPHYS_OK);
         }},
    };
    return all;
}

}  // namespace

TEST_CASE("bodies that lie still go on with the same bits as those moved in every step, whatever happens",
          "[simulation]") {
    Room first;
    first.run(600);
    const test::Words calm = test::snapshot(first.solver);
    for (const Event& event : events()) {
        INFO(event.name);
        Room room, moved;
        for (const Room* each : {&room, &moved}) REQUIRE(test::restore(each->solver, calm) == GPHYS_OK);
        room.run(10);
        for (const gphys_body_id body : room.bodies()) REQUIRE(room.is_steady(body));
        moved.run_moving_all(10);
        for (const gphys_body_id body : moved.bodies()) REQUIRE_FALSE(moved.is_steady(body));
        REQUIRE(test::hash(room.solver) == test::hash(moved.solver));
        event.happens(room);
        event.happens(moved);
        for (int i = 0; i < 40; ++i) {
            room.run(1, event.dt);
            moved.run_moving_all(1, event.dt);
            REQUIRE(test::hash(room.solver) == test::hash(moved.solver));
            REQUIRE(same_impulses(room, moved));
        }
    }
}

TEST_CASE("a step of bodies that lie still costs next to nothing, and nothing says that they sleep") {
    World room;
    const gphys_plane floor{{0, 1, 0}, 0};
    room.model(GPHYS_SHAPE_PLANE, &floor);
    const gphys_body_id sheet = room.cloth({10, 2, 0}, {1, 0, 0}, {0, 0, 1}, 60, 60);
    const auto seconds_of_step = [&] {
        double best = 1e9;
        for (int i = 0; i < 20; ++i) {
            const auto start = std::chrono::steady_clock::now();
            room.step(frame);
            best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
        return best;
    };
    const double falling = seconds_of_step();
    for (int i = 0; i < 200; ++i) room.step(frame);
    const double lying = seconds_of_step();
    figure("falling", falling * 1e3, "ms a step");
    figure("lying still", lying * 1e3, "ms a step");
    CHECK(lying < falling / 20);
    CHECK(room.stats(sheet).contact_count == 3600);
    uint32_t sleeping = 0;
    REQUIRE(gphys_solver_get_sleeping(room.solver, nullptr, 0, &sleeping) == GPHYS_OK);
    CHECK(sleeping == 0);
}

TEST_CASE("a body whose steps differ in length is not compared, and is steady soon after they are equal") {
    Room room;
    const float longer = std::nextafter(frame, 1.0f);
    for (int i = 0; i < 600; ++i) {
        room.step(i % 2 == 0 ? frame : longer);
        REQUIRE(gphys::unwrap(room.solver)->body(room.particle_body).steady.place == 0);
    }
    REQUIRE_FALSE(room.is_steady(room.particle_body));
    room.run(5);
    for (const gphys_body_id body : room.bodies()) CHECK(room.is_steady(body));
}

TEST_CASE("comparisons of a body that creeps become rare") {
    // 1e-7 m/s is counted as still, and its position changes in every step.
    World world;
    const gphys_body_id dust = world.particles({{0, 0, 0}});
    const gphys_vec3 none{0, 0, 0};
    REQUIRE(gphys_solver_set_gravity(world.solver, &none) == GPHYS_OK);
    world.set_velocity(dust, 0, {1e-7f, 0, 0});
    uint32_t compared = 0;
    for (int i = 0; i < 640; ++i) {
        world.step(frame);
        compared += gphys::unwrap(world.solver)->body(dust).steady.place != 0;
    }
    CHECK(compared > 10);
    CHECK(compared < 60);
}

// Worlds too large for floats: scenes, cameras and solvers count from an origin in double precision.
#include <vector>

#include "test.h"

namespace {

struct World {
    gphys_scene* scene = nullptr;
    gphys_camera* camera = nullptr;
    gphys_solver* solver = nullptr;

    World() {
        REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
        REQUIRE(gphys_camera_create(nullptr, &camera) == GPHYS_OK);
        REQUIRE(gphys_solver_create(nullptr, &solver) == GPHYS_OK);
    }
    ~World() {
        gphys_solver_destroy(solver);
        gphys_camera_destroy(camera);
        gphys_scene_destroy(scene);
    }
    void set_origin(double x, double y, double z) {
        const double origin[3] = {x, y, z};
        REQUIRE(gphys_scene_set_origin(scene, origin) == GPHYS_OK);
        REQUIRE(gphys_camera_set_origin(camera, origin) == GPHYS_OK);
        REQUIRE(gphys_solver_set_origin(solver, origin) == GPHYS_OK);
        REQUIRE(gphys_scene_validate(scene) == GPHYS_OK);
    }
};

const gphys_aabb crate{{-.5f, -.5f, -.5f}, {.5f, .5f, .5f}};

}  // namespace

TEST_CASE("a billion metres out, rays, picks and nearest points are right to a millimetre") {
    World world;
    world.set_origin(1e9, -2e9, 3e9);
    const gphys_transform at{{3.001f, 0, 10}, {0, 0, 0, 1}, 1};
    gphys_model_id model;
    REQUIRE(gphys_scene_add(world.scene, GPHYS_SHAPE_AABB, &crate, &at, nullptr, &model) == GPHYS_OK);
    const gphys_vec3 eye{3, 0, 0}, target{3, 0, 1}, up{0, 1, 0};
    REQUIRE(gphys_camera_look_at(world.camera, &eye, &target, &up) == GPHYS_OK);

    // The traveller goes 50 km in steps of all sizes, and the origin with it.
    double x = 1e9;
    for (int i = 0; i < 200; ++i) {
        x += 250 + .123456789 * i;
        world.set_origin(x, -2e9 + i * .1, 3e9);
    }
    world.set_origin(1e9 + 1.25, -2e9, 3e9 - 2.5);

    gphys_transform now;
    REQUIRE(gphys_scene_get_transforms(world.scene, &model, 1, &now, sizeof now) == GPHYS_OK);
    CHECK(now.position.x == 3.001f - 1.25f);
    CHECK(now.position.y == 0);
    CHECK(now.position.z == 12.5f);
    const gphys_ray ray{{1.75f, 0, 2.5f}, {0, 0, 1}, 100};
    gphys_hit hit;
    REQUIRE(gphys_scene_raycast(world.scene, &ray, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK);
    CHECK(hit.t == 9.5f);
    REQUIRE(gphys_camera_pick(world.camera, world.scene, 400, 300, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK);
    CHECK(hit.model == model);
    CHECK(hit.point.z == 12);
    CHECK(std::fabs(hit.point.x - 1.75f) < 1e-6f);
    const gphys_vec3 beside{1.751f + .501f, 0, 12.5f};
    gphys_nearest nearest;
    REQUIRE(gphys_scene_nearest(world.scene, &beside, 1, GPHYS_ALL_LAYERS, &nearest) == GPHYS_OK);
    CHECK(std::fabs(nearest.distance - .001f) < 1e-6f);
    double origin[3];
    REQUIRE(gphys_scene_get_origin(world.scene, origin) == GPHYS_OK);
    CHECK((origin[0] == 1e9 + 1.25 && origin[1] == -2e9 && origin[2] == 3e9 - 2.5));
}

TEST_CASE("models go along with a moving origin: children, moved models, new ones") {
    World world;
    const gphys_transform at{{100, 0, 0}, {0, 0, 0, 1}, 1}, beside{{0, 5, 0}, {0, 0, 0, 1}, 1};
    gphys_model_id models[3];
    REQUIRE(gphys_scene_add(world.scene, GPHYS_SHAPE_AABB, &crate, &at, nullptr, &models[0]) == GPHYS_OK);
    gphys_model_desc desc;
    gphys_model_desc_init(&desc, sizeof desc);
    desc.parent = models[0];
    REQUIRE(gphys_scene_add(world.scene, GPHYS_SHAPE_AABB, &crate, &beside, &desc, &models[1]) == GPHYS_OK);
    world.set_origin(1e6, 0, 0);
    REQUIRE(gphys_scene_add(world.scene, GPHYS_SHAPE_AABB, &crate, &at, nullptr, &models[2]) == GPHYS_OK);
    // Placed anew, a model is where it was put and not where it came from.
    const gphys_transform moved{{-999000, 0, .25f}, {0, 0, 0, 1}, 1};
    REQUIRE(gphys_scene_set_transform(world.scene, models[0], &moved) == GPHYS_OK);
    world.set_origin(0, 1, 0);
    gphys_transform now[3];
    REQUIRE(gphys_scene_get_world_transforms(world.scene, models, 3, now, sizeof now[0]) == GPHYS_OK);
    CHECK((now[0].position.x == 1000 && now[0].position.y == -1 && now[0].position.z == .25f));
    CHECK((now[1].position.x == 1000 && now[1].position.y == 4 && now[1].position.z == .25f));
    CHECK((now[2].position.x == 1000100 && now[2].position.y == -1 && now[2].position.z == 0));
    gphys_transform local;
    REQUIRE(gphys_scene_get_transforms(world.scene, &models[1], 1, &local, sizeof local) == GPHYS_OK);
    CHECK(local.position.y == 5);
}

TEST_CASE("a rope falls as it does at home, though the origin moves under it a billion metres out") {
    std::vector<gphys_vec3> end[2];
    for (const bool far : {false, true}) {
        World world;
        if (far) world.set_origin(1e9, 0, -1e9);
        const gphys_plane ground{{0, 1, 0}, 0};
        gphys_model_id model;
        REQUIRE(gphys_scene_add(world.scene, GPHYS_SHAPE_PLANE, &ground, nullptr, nullptr, &model) == GPHYS_OK);
        std::vector<gphys_vec3> points;
        for (int i = 0; i < 10; ++i) points.push_back({.1f * static_cast<float>(i), 1, 0});
        gphys_body_id rope;
        REQUIRE(gphys_solver_add_rope(world.solver, nullptr, points.data(), sizeof points[0], 10, 0, &rope) ==
                GPHYS_OK);
        for (int step = 0; step < 90; ++step) {
            if (far) world.set_origin(1e9 + 64 * step, 0, -1e9);
            REQUIRE(gphys_solver_step(world.solver, world.scene, 1.0f / 60) == GPHYS_OK);
        }
        if (far) world.set_origin(1e9, 0, -1e9);
        end[far].resize(10);
        REQUIRE(gphys_solver_get_positions(world.solver, rope, 0, 10, end[far].data(), sizeof points[0]) == GPHYS_OK);
    }
    for (int i = 0; i < 10; ++i) {
        CHECK(std::fabs(end[0][i].x - end[1][i].x) < 1e-3f);
        CHECK(std::fabs(end[0][i].y - end[1][i].y) < 1e-3f);
        CHECK(end[1][i].y < .1f);
    }
}

TEST_CASE("origins that differ, or lead out of range, are refused and change nothing") {
    World world;
    const double here[3] = {1, 2, 3}, nowhere[3] = {0, NAN, 0}, beyond[3] = {0, 1e16, 0}, edge[3] = {-1e15, 0, 0};
    CHECK(gphys_scene_set_origin(world.scene, nowhere) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(gphys_camera_set_origin(world.camera, beyond) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(gphys_solver_set_origin(world.solver, nullptr) == GPHYS_ERROR_INVALID_ARGUMENT);
    const gphys_transform far{{1e15f, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_id model;
    REQUIRE(gphys_scene_add(world.scene, GPHYS_SHAPE_AABB, &crate, &far, nullptr, &model) == GPHYS_OK);
    CHECK(gphys_scene_set_origin(world.scene, edge) == GPHYS_ERROR_INVALID_ARGUMENT);
    double origin[3] = {7, 7, 7};
    REQUIRE(gphys_scene_get_origin(world.scene, origin) == GPHYS_OK);
    CHECK((origin[0] == 0 && origin[1] == 0 && origin[2] == 0));
    gphys_transform now;
    REQUIRE(gphys_scene_get_transforms(world.scene, &model, 1, &now, sizeof now) == GPHYS_OK);
    CHECK(now.position.x == 1e15f);

    REQUIRE(gphys_scene_set_origin(world.scene, here) == GPHYS_OK);
    gphys_hit hit;
    uint32_t total;
    CHECK(gphys_camera_pick(world.camera, world.scene, 1, 1, GPHYS_ALL_LAYERS, &hit) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(gphys_camera_cull(world.camera, world.scene, GPHYS_ALL_LAYERS, nullptr, 0, &total) ==
          GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(gphys_solver_step(world.solver, world.scene, .01f) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(gphys_solver_advance(world.solver, world.scene, .01f, nullptr, nullptr) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(gphys_solver_step(world.solver, nullptr, .01f) == GPHYS_OK);
}

// A model gets another shape under the same id. What queries answer then is compared with a linear scan in
// test_scene_queries.cpp, whose random scenes change shapes too; here is what stays, what is let go and what fails.
#include "meshes.h"
#include "scene_fixture.h"
#include "scene_reference.h"

using test::at;
using test::SceneFixture;

namespace {

constexpr gphys_sphere ball{{0, 0, 0}, 1};
constexpr gphys_capsule capsule{{0, 0, 0}, {0, 5, 0}, 1};
constexpr gphys_plane floor_plane{{0, 1, 0}, -3};
constexpr gphys_obb turned_box{{0, 0, 0}, {1, 2, 3}, {0, 0, 0, 1}};

/// Everything about a model that a change of shape leaves alone.
void check_same(const SceneFixture& fixture, gphys_model_id model, const gphys_model_info& before,
                const gphys_transform& local, const gphys_transform& world) {
    gphys_model_info info;
    REQUIRE(gphys_scene_get_info(fixture.scene, model, &info) == GPHYS_OK);
    CHECK(info.parent == before.parent);
    CHECK(info.layers == before.layers);
    CHECK(info.tag == before.tag);
    CHECK(info.child_count == before.child_count);
    const gphys_transform now_local = fixture.local(model), now_world = fixture.world(model);
    CHECK(std::memcmp(&now_local, &local, sizeof local) == 0);
    CHECK(std::memcmp(&now_world, &world, sizeof world) == 0);
    CHECK(fixture.sound());
}

}  // namespace

TEST_CASE("a model of another shape is the same model", "[scene][shape]") {
    SceneFixture fixture;
    const gphys_model_id below = fixture.add_box(at(1, 2, 3, 2));
    const gphys_model_id model = fixture.add_box(at(10, 0, 0), below);
    const gphys_model_id child = fixture.add_sphere(1, at(0, 4, 0), model);
    REQUIRE(gphys_scene_set_tag(fixture.scene, model, 77) == GPHYS_OK);
    REQUIRE(gphys_scene_set_layers(fixture.scene, model, 6) == GPHYS_OK);
    gphys_model_info info;
    REQUIRE(gphys_scene_get_info(fixture.scene, model, &info) == GPHYS_OK);
    const gphys_transform local = fixture.local(model), world = fixture.world(model), of_child = fixture.world(child);
    gphys_mesh* mesh = test::cube_mesh().create();
    const std::pair<gphys_shape_type, const void*> shapes[] = {
        {GPHYS_SHAPE_SPHERE, &ball},       {GPHYS_SHAPE_CAPSULE, &capsule},   {GPHYS_SHAPE_PLANE, &floor_plane},
        {GPHYS_SHAPE_PLANE, &floor_plane}, {GPHYS_SHAPE_OBB, &turned_box},    {GPHYS_SHAPE_MESH, mesh},
        {GPHYS_SHAPE_MESH, mesh},          {GPHYS_SHAPE_PLANE, &floor_plane}, {GPHYS_SHAPE_MESH, mesh},
        {GPHYS_SHAPE_CAPSULE, &capsule}};
    for (const auto& [type, shape] : shapes) {
        REQUIRE(gphys_scene_set_shape(fixture.scene, model, type, shape) == GPHYS_OK);
        gphys_model_info now;
        REQUIRE(gphys_scene_get_info(fixture.scene, model, &now) == GPHYS_OK);
        CHECK(now.type == type);
        check_same(fixture, model, info, local, world);
        const gphys_transform still = fixture.world(child);
        CHECK(std::memcmp(&still, &of_child, sizeof still) == 0);
        gphys_aabb box;
        CHECK(gphys_scene_get_bounds(fixture.scene, model, &box) ==
              (type == GPHYS_SHAPE_PLANE ? GPHYS_UNBOUNDED : GPHYS_OK));
    }
    // The parent's scale is 2, and it stands at (1, 2, 3): the capsule's upper end is at y = 2 + 2 * 5 + 2 * 1.
    gphys_aabb box;
    REQUIRE(gphys_scene_get_bounds(fixture.scene, model, &box) == GPHYS_OK);
    CHECK(box.max.y == 14);
    gphys_capsule read{};
    REQUIRE(gphys_scene_get_shape(fixture.scene, model, &read, sizeof read) == GPHYS_OK);
    CHECK(std::memcmp(&read, &capsule, sizeof read) == 0);
    gphys_mesh_destroy(mesh);
}

TEST_CASE("planes stay listed while others become planes and cease to be", "[scene][shape]") {
    SceneFixture fixture;
    std::vector<gphys_model_id> models;
    for (int i = 0; i < 12; ++i) models.push_back(fixture.add_sphere(1, at(static_cast<float>(4 * i), 50, 0)));
    test::Random random(5);
    std::vector<bool> is_plane(models.size());
    for (int round = 0; round < 400; ++round) {
        const uint32_t which = random.index(12);
        is_plane[which] = random.index(2) != 0;
        REQUIRE((is_plane[which]
                     ? gphys_scene_set_shape(fixture.scene, models[which], GPHYS_SHAPE_PLANE, &floor_plane)
                     : gphys_scene_set_shape(fixture.scene, models[which], GPHYS_SHAPE_SPHERE, &ball)) == GPHYS_OK);
        REQUIRE(fixture.sound());
        for (uint32_t i = 0; i < 12; ++i) {
            // From far above: a plane of the model is 3 below its origin, a ball 1 above.
            const float x = static_cast<float>(4 * i);
            const gphys_ray down{{x, 100, 0}, {0, -1, 0}, INFINITY};
            gphys_hit hits[12];
            uint32_t total = 0;
            REQUIRE(gphys_scene_raycast_all(fixture.scene, &down, GPHYS_ALL_LAYERS, hits, 12, &total) == GPHYS_OK);
            const auto planes = static_cast<uint32_t>(std::count(is_plane.begin(), is_plane.end(), true));
            CHECK(total == planes + !is_plane[i]);
            CHECK(hits[0].t == (is_plane[i] ? 53 : 49));
        }
    }
}

TEST_CASE("a scene holds the mesh that a model has now, and no other", "[scene][shape]") {
    SceneFixture fixture;
    test::CountedMemory memory;
    const gphys_allocator hooks = memory.hooks();
    gphys_mesh_desc desc;
    REQUIRE(gphys_mesh_desc_init(&desc, sizeof desc) == GPHYS_OK);
    desc.allocator = &hooks;
    const test::MeshSource cube = test::cube_mesh();
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(&desc, &cube.vertices[0].x, sizeof(gphys_vec3), 8, cube.indices.data(), 36, &mesh) ==
            GPHYS_OK);
    const gphys_model_id model = fixture.add_box(at(0, 0, 0));
    REQUIRE(gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_MESH, mesh) == GPHYS_OK);
    gphys_mesh_destroy(mesh);
    CHECK(memory.live_bytes != 0);
    CHECK(fixture.first_on_ray({0, 0, -10}, {0, 0, 1}) == model);
    REQUIRE(gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_SPHERE, &ball) == GPHYS_OK);
    CHECK(memory.live_bytes == 0);
}

TEST_CASE("what a scene knows of all its shapes follows a change of one", "[scene][shape]") {
    SceneFixture fixture;
    const gphys_model_id model = fixture.add_box(at(3, 0, 0)), other = fixture.add_box(at(-3, 0, 0));
    // What is wholly inside a query is listed without being asked, but for models without any point.
    gphys_mesh* empty = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, nullptr, sizeof(gphys_vec3), 0, nullptr, 0, &empty) == GPHYS_OK);
    REQUIRE(gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_MESH, empty) == GPHYS_OK);
    gphys_mesh_destroy(empty);
    CHECK(fixture.in_sphere({0, 0, 0}, 100) == std::vector<gphys_model_id>{other});
    // Moves are checked against the farthest point of all shapes first: 1e16 is beyond what a scene can hold.
    const gphys_sphere far_reaching{{0, 0, 0}, 1e15f};
    REQUIRE(gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_SPHERE, &far_reaching) == GPHYS_OK);
    CHECK(fixture.move(model, at(3, 0, 0, 10)) == GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK(fixture.move(model, at(3, 0, 0, 2)) == GPHYS_OK);
    CHECK(fixture.sound());
}

TEST_CASE("a change of shape that fails changes nothing", "[scene][shape]") {
    SceneFixture fixture;
    gphys_mesh* mesh = test::cube_mesh().create();
    const gphys_plane plane{{0, 1, 0}, 0};
    const gphys_model_id models[] = {
        fixture.add(GPHYS_SHAPE_MESH, mesh, at(0, 0, 0)), fixture.add(GPHYS_SHAPE_CAPSULE, &capsule, at(9, 0, 0)),
        fixture.add(GPHYS_SHAPE_PLANE, &plane, at(0, 0, 0)), fixture.add_sphere(1, at(0, 0, 9, 1e14f))};
    gphys_mesh_destroy(mesh);
    // At its scale of 1e14 it would reach to 1e29, which a scene cannot hold.
    const gphys_sphere huge{{0, 0, 0}, 1e15f};
    const gphys_aabb backwards{{1, 1, 1}, {0, 0, 0}};
    const gphys_ray ray{{0, 0, 0}, {1, 0, 0}, 1};
    CHECK(gphys_scene_set_shape(fixture.scene, models[3], GPHYS_SHAPE_SPHERE, &huge) == GPHYS_ERROR_INVALID_ARGUMENT);
    for (const gphys_model_id model : models) {
        CHECK(gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_AABB, &backwards) ==
              GPHYS_ERROR_INVALID_ARGUMENT);
        CHECK(gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_RAY, &ray) == GPHYS_ERROR_UNSUPPORTED);
        CHECK(gphys_scene_set_shape(fixture.scene, model, 99, &ray) == GPHYS_ERROR_INVALID_ARGUMENT);
        CHECK(gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_MESH, nullptr) == GPHYS_ERROR_INVALID_ARGUMENT);
    }
    CHECK(gphys_scene_set_shape(fixture.scene, 0, GPHYS_SHAPE_SPHERE, &ball) == GPHYS_ERROR_INVALID_ID);
    CHECK(gphys_scene_set_shape(nullptr, models[0], GPHYS_SHAPE_SPHERE, &ball) == GPHYS_ERROR_INVALID_ARGUMENT);
    const auto types = [&] {
        std::vector<gphys_shape_type> of;
        for (const gphys_model_id model : models) {
            gphys_model_info info;
            REQUIRE(gphys_scene_get_info(fixture.scene, model, &info) == GPHYS_OK);
            of.push_back(info.type);
        }
        return of;
    };
    const auto before = types();
    CHECK(fixture.sound());
    // Each allocation of a call fails once. A scene of one ball has no room for tails or planes yet.
    for (const bool to_plane : {false, true}) {
        SceneFixture small;
        const gphys_model_id only = small.add_sphere(1, at(5, 0, 0));
        for (size_t failing = 0;; ++failing) {
            small.memory.allocations = 0;
            small.memory.failing = failing;
            const gphys_status status = to_plane
                                            ? gphys_scene_set_shape(small.scene, only, GPHYS_SHAPE_PLANE, &plane)
                                            : gphys_scene_set_shape(small.scene, only, GPHYS_SHAPE_CAPSULE, &capsule);
            small.memory.failing = SIZE_MAX;
            REQUIRE(small.sound());
            if (status == GPHYS_OK) {
                CHECK(failing > 0);
                break;
            }
            REQUIRE(status == GPHYS_ERROR_OUT_OF_MEMORY);
            CHECK(small.first_on_ray({0, 0, 0}, {1, 0, 0}) == only);
        }
    }
    CHECK(types() == before);
    gphys_aabb box;
    REQUIRE(gphys_scene_get_bounds(fixture.scene, models[1], &box) == GPHYS_OK);
    CHECK(box.max.y == 6);
}

// A plane that becomes a box goes into the octree, which may have to grow.
TEST_CASE("a plane without memory to be anything else stays a plane", "[scene][shape]") {
    SceneFixture fixture;
    const gphys_plane plane{{1, 0, 0}, 3};
    std::vector<gphys_model_id> models;
    for (int i = 0; i < 70; ++i) models.push_back(fixture.add(GPHYS_SHAPE_PLANE, &plane, at(0, 0, 0)));
    uint32_t failures = 0;
    for (const gphys_model_id model : models) {
        fixture.memory.allocations = 0;
        fixture.memory.failing = 0;
        const gphys_status status = gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_SPHERE, &ball);
        fixture.memory.failing = SIZE_MAX;
        REQUIRE(fixture.sound());
        if (status == GPHYS_OK) continue;
        ++failures;
        REQUIRE(status == GPHYS_ERROR_OUT_OF_MEMORY);
        gphys_model_info info;
        REQUIRE(gphys_scene_get_info(fixture.scene, model, &info) == GPHYS_OK);
        CHECK(info.type == GPHYS_SHAPE_PLANE);
        REQUIRE(gphys_scene_set_shape(fixture.scene, model, GPHYS_SHAPE_SPHERE, &ball) == GPHYS_OK);
    }
    CHECK(failures > 2);
}

TEST_CASE("what sleeps beside a model wakes when its shape changes", "[scene][shape]") {
    SceneFixture fixture;
    const gphys_aabb slab{{-5, -1, -5}, {5, 0, 5}}, lower{{-5, -2, -5}, {5, -1, 5}};
    const gphys_model_id floor = fixture.add(GPHYS_SHAPE_AABB, &slab, at(0, 0, 0));
    gphys_solver_desc desc;
    REQUIRE(gphys_solver_desc_init(&desc, sizeof desc) == GPHYS_OK);
    desc.sleep_speed = 0.05f;
    gphys_solver* solver = nullptr;
    REQUIRE(gphys_solver_create(&desc, &solver) == GPHYS_OK);
    const gphys_vec3 start{0, 0.02f, 0};
    gphys_body_id body = 0;
    REQUIRE(gphys_solver_add_particles(solver, nullptr, &start, 0, 1, &body) == GPHYS_OK);
    const auto sleeping = [&] {
        uint32_t total = 0;
        REQUIRE(gphys_solver_get_sleeping(solver, nullptr, 0, &total) >= 0);
        return total;
    };
    for (int i = 0; i < 300 && sleeping() == 0; ++i)
        REQUIRE(gphys_solver_step(solver, fixture.scene, 1 / 60.f) == GPHYS_OK);
    REQUIRE(sleeping() == 1);
    REQUIRE(gphys_scene_set_shape(fixture.scene, floor, GPHYS_SHAPE_AABB, &slab) == GPHYS_OK);
    REQUIRE(gphys_solver_step(solver, fixture.scene, 1 / 60.f) == GPHYS_OK);
    CHECK(sleeping() == 1);  // the same shape again is no change
    REQUIRE(gphys_scene_set_shape(fixture.scene, floor, GPHYS_SHAPE_AABB, &lower) == GPHYS_OK);
    REQUIRE(gphys_solver_step(solver, fixture.scene, 1 / 60.f) == GPHYS_OK);
    CHECK(sleeping() == 0);
    for (int i = 0; i < 120; ++i) REQUIRE(gphys_solver_step(solver, fixture.scene, 1 / 60.f) == GPHYS_OK);
    gphys_vec3 now;
    REQUIRE(gphys_solver_get_positions(solver, body, 0, 1, &now, sizeof now) == GPHYS_OK);
    CHECK(now.y == Approx(-0.99f).margin(0.002));  // a radius of 0.01 above the new floor
    gphys_solver_destroy(solver);
}

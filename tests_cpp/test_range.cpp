// Corners of the range of coordinates: what is accepted there is answered, what is not is refused at once.
#include <chrono>
#include <vector>

#include "scene_fixture.h"

using gphys::widen;

namespace {

struct CameraFixture {
    gphys_camera* camera = nullptr;

    CameraFixture() { REQUIRE(gphys_camera_create(nullptr, &camera) == GPHYS_OK); }
    ~CameraFixture() { gphys_camera_destroy(camera); }

    /// Whether the shape functions take what the camera says that it sees, or there is a status.
    void check_frustum() const {
        gphys_frustum frustum;
        REQUIRE(gphys_camera_get_frustum(camera, &frustum) == GPHYS_OK);
        CAPTURE(gphys_last_error());
        REQUIRE(gphys_shape_validate(GPHYS_SHAPE_FRUSTUM, &frustum) == GPHYS_OK);
        gphys_vec3 corners[8];
        if (gphys_camera_get_corners(camera, corners) != GPHYS_OK) return;
        for (const gphys_vec3& corner : corners) REQUIRE(std::isfinite(corner.x + corner.y + corner.z));
    }
    void turn(test::Random& random) {
        const gphys_vec3 position = random.point(1e15f);
        const gphys_quat rotation = random.rotation();
        REQUIRE(gphys_camera_set_transform(camera, &position, &rotation) == GPHYS_OK);
    }
};

float any_size(test::Random& random) { return static_cast<float>(std::pow(10.0, random.uniform(-6, 15))); }

}  // namespace

TEST_CASE("shape functions take the frustum of every camera that can be set") {
    test::Random random(1);
    CameraFixture fixture;
    gphys_camera* const camera = fixture.camera;
    int set = 0;
    for (int i = 0; i < 20000; ++i) {
        fixture.turn(random);
        const float near = random.index(4) ? any_size(random) : 1e14f;
        const float far = random.index(2) ? GPHYS_MAX_COORDINATE : any_size(random);
        if (random.index(2)) {
            set += gphys_camera_set_perspective(camera, random.uniform_float(1e-6f, 3.1f), near, far) == GPHYS_OK;
        } else {
            const float height = random.index(2) ? GPHYS_MAX_COORDINATE : any_size(random);
            set += gphys_camera_set_orthographic(camera, height, -near, far) == GPHYS_OK;
        }
        const float width = random.index(4) ? random.uniform_float(1, 4000) : 1e6f;
        set += gphys_camera_set_viewport(camera, width, random.index(4) ? 1000 : 1e-3f) == GPHYS_OK;
        fixture.check_frustum();
        gphys_mat4 projection;
        REQUIRE(gphys_camera_get_projection_matrix(camera, &projection) == GPHYS_OK);
        for (float& element : projection.m) {
            if (random.index(16) == 0) element = (random.index(2) ? 1.0f : -1.0f) * any_size(random);
        }
        if (gphys_camera_set_projection(camera, &projection) == GPHYS_OK) fixture.check_frustum();
    }
    CHECK(set > 20000);
}

TEST_CASE("what a camera is refused for its width leaves it as it was") {
    CameraFixture fixture;
    gphys_camera* const camera = fixture.camera;
    REQUIRE(gphys_camera_set_viewport(camera, 4000, 1000) == GPHYS_OK);
    REQUIRE(gphys_camera_set_orthographic(camera, 10, 0, 100) == GPHYS_OK);
    gphys_mat4 before, after;
    REQUIRE(gphys_camera_get_projection_matrix(camera, &before) == GPHYS_OK);
    CHECK(gphys_camera_set_orthographic(camera, 9e14f, 0, 100) == GPHYS_ERROR_INVALID_ARGUMENT);
    REQUIRE(gphys_camera_get_projection_matrix(camera, &after) == GPHYS_OK);
    CHECK(std::equal(before.m, before.m + 16, after.m));
    REQUIRE(gphys_camera_set_orthographic(camera, 4e14f, 0, 100) == GPHYS_OK);
    REQUIRE(gphys_camera_get_projection_matrix(camera, &before) == GPHYS_OK);
    CHECK(gphys_camera_set_viewport(camera, 9000, 1000) == GPHYS_ERROR_INVALID_ARGUMENT);
    REQUIRE(gphys_camera_get_projection_matrix(camera, &after) == GPHYS_OK);
    CHECK(std::equal(before.m, before.m + 16, after.m));
}

TEST_CASE("a frustum of any matrix has finite corners or a status") {
    test::Random random(2);
    int accepted = 0, bounded = 0;
    for (int i = 0; i < 100000; ++i) {
        gphys_mat4 matrix;
        const bool small = random.index(2) != 0;
        for (float& element : matrix.m) {
            element = (random.index(2) ? 1.0f : -1.0f) * (small                  ? static_cast<float>(random.index(3))
                                                          : random.index(3) == 0 ? 0
                                                                                 : any_size(random));
        }
        gphys_frustum frustum;
        const gphys_status status = gphys_frustum_from_matrix(&matrix, static_cast<gphys_depth_range>(random.index(2)),
                                                              static_cast<int32_t>(random.index(2)), &frustum);
        if (status != GPHYS_OK) {
            REQUIRE(status == GPHYS_ERROR_SINGULAR);
            continue;
        }
        ++accepted;
        REQUIRE(gphys_shape_validate(GPHYS_SHAPE_FRUSTUM, &frustum) == GPHYS_OK);
        gphys_vec3 corners[8];
        if (gphys_frustum_corners(&frustum, corners) != GPHYS_OK) continue;
        ++bounded;
        for (const gphys_vec3& corner : corners) {
            REQUIRE(std::isfinite(corner.x));
            REQUIRE(std::isfinite(corner.y));
            REQUIRE(std::isfinite(corner.z));
        }
    }
    CHECK(accepted > 100);
    CHECK(bounded > 100);
    // Sides that are almost parallel meet beyond all floats.
    const gphys_mat4 nearly_flat[] = {
        {{0x1p-148f, 0x1p-149f, 0, 0, -0x1.fffffep-1f, -1, 0x1.000002p+0f, 0, -1, -1, 0x1p-149f, -1, -0x1.fffffcp-1f,
          -0x1.fffffep-1f, 0, 0}},
        {{0, 0, -0x1.d05746p+3f, 0x1.3d278cp-7f, 0, 0, 0x1.94ca96p-35f, 0, 0, 0x1.c1c7d6p-91f, 0x1.9ef6d4p+13f, 0,
          0x1.f095a2p+33f, 0x1.845bfcp-41f, 0x1.feb61cp+47f, -0x1.76d094p+26f}}};
    for (const gphys_mat4& matrix : nearly_flat) {
        for (const gphys_depth_range range : {GPHYS_DEPTH_ZERO_TO_ONE, GPHYS_DEPTH_MINUS_ONE_TO_ONE}) {
            for (const int32_t reverse_z : {0, 1}) {
                gphys_frustum frustum;
                if (gphys_frustum_from_matrix(&matrix, range, reverse_z, &frustum) != GPHYS_OK) continue;
                gphys_vec3 corners[8];
                if (gphys_frustum_corners(&frustum, corners) != GPHYS_OK) continue;
                for (const gphys_vec3& corner : corners) CHECK(std::isfinite(corner.x + corner.y + corner.z));
            }
        }
    }
    // Each side is a plane, but no point is before the camera and on the near one.
    const gphys_mat4 backward{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -1, 0, 0, 1, -1}};
    gphys_frustum frustum;
    CHECK(gphys_frustum_from_matrix(&backward, GPHYS_DEPTH_ZERO_TO_ONE, 0, &frustum) == GPHYS_ERROR_SINGULAR);
}

TEST_CASE("the normal of a capsule is right where its axis is as long as coordinates go") {
    // The axis passes the origin; its direction, exactly: the slope is a whole number.
    for (const float slope : {0.0f, 3.0f, 7.0f}) {
        const float reach = 0x1p46f;
        const gphys_capsule capsule{{-reach, -slope * reach, 0}, {reach, slope * reach, 0}, 1};
        const gphys::Vec3 axis = normalized(gphys::Vec3{1, slope, 0});
        for (const float x : {.1f, .3f, -.7f, 1234.567f}) {
            const gphys::Vec3 foot = axis * x, out = normalized(gphys::Vec3{-axis.y * .6, axis.x * .6, .8});
            const gphys_vec3 origin = narrow(foot + out * 5), direction = narrow(-out);
            const gphys_ray ray{origin, direction, INFINITY};
            gphys_hit hit;
            CAPTURE(slope, x);
            REQUIRE(gphys_shape_raycast(GPHYS_SHAPE_CAPSULE, &capsule, &ray, &hit) == GPHYS_OK);
            const double rounding = 1e-6 * (1 + std::fabs(x));
            CHECK(distance(widen(hit.normal), out) < rounding);
            CHECK(distance(widen(hit.point), foot + out) < rounding);

            const gphys_vec3 way{4 * direction.x, 4 * direction.y, 4 * direction.z};
            const gphys_sphere moving{origin, .5f}, touching{narrow(foot + out * 1.25), .5f};
            REQUIRE(gphys_shape_sweep_sphere(GPHYS_SHAPE_CAPSULE, &capsule, &moving, &way, &hit) == GPHYS_OK);
            CHECK(distance(widen(hit.normal), out) < rounding);
            REQUIRE(gphys_shape_sweep_sphere(GPHYS_SHAPE_CAPSULE, &capsule, &touching, &way, &hit) == GPHYS_OK);
            CHECK(hit.t == 0);
            CHECK(distance(widen(hit.normal), out) < rounding);
        }
    }
}

TEST_CASE("of thin boxes that are turned, culling lists at most half as many again as are seen") {
    test::Random random(3);
    test::SceneFixture world;
    const gphys_aabb thin{{-5, -.05f, -.05f}, {5, .05f, .05f}};
    for (int i = 0; i < 4000; ++i) {
        const gphys_transform at{random.point(60), random.rotation(), 1};
        world.add(GPHYS_SHAPE_AABB, &thin, at);
    }
    CameraFixture fixture;
    uint32_t culled = 0, seen = 0;
    std::vector<gphys_model_id> all(4000), exact(4000);
    for (int i = 0; i < 40; ++i) {
        const gphys_vec3 position = random.point(30);
        const gphys_quat rotation = random.rotation();
        REQUIRE(gphys_camera_set_transform(fixture.camera, &position, &rotation) == GPHYS_OK);
        gphys_frustum frustum;
        REQUIRE(gphys_camera_get_frustum(fixture.camera, &frustum) == GPHYS_OK);
        uint32_t listed = 0, overlapping = 0;
        REQUIRE(gphys_scene_cull(world.scene, &frustum, GPHYS_ALL_LAYERS, all.data(), 4000, &listed) == GPHYS_OK);
        REQUIRE(gphys_scene_overlap(world.scene, GPHYS_SHAPE_FRUSTUM, &frustum, GPHYS_ALL_LAYERS, exact.data(), 4000,
                                    &overlapping) == GPHYS_OK);
        REQUIRE(std::includes(all.begin(), all.begin() + listed, exact.begin(), exact.begin() + overlapping));
        culled += listed;
        seen += overlapping;
    }
    CAPTURE(culled, seen);
    CHECK(culled > seen);
    CHECK(culled < seen * 1.5);
}

TEST_CASE("a cloth of too many particles or links is refused at once") {
    gphys_solver* solver = nullptr;
    REQUIRE(gphys_solver_create(nullptr, &solver) == GPHYS_OK);
    const gphys_vec3 corner{0, 0, 0}, u{1, 0, 0}, v{0, 0, 1};
    gphys_body_desc desc;
    gphys_body_desc_init(&desc, sizeof desc);
    gphys_body_id body = 7;
    const auto start = std::chrono::steady_clock::now();
    for (const uint32_t flags : {0u, uint32_t{GPHYS_CLOTH_SHEAR}, uint32_t{GPHYS_CLOTH_SHEAR | GPHYS_CLOTH_BEND}}) {
        desc.cloth_flags = flags;
        CHECK(gphys_solver_add_cloth(solver, &desc, &corner, &u, &v, 4095, 4097, &body) == GPHYS_ERROR_CAPACITY);
        CHECK(gphys_solver_add_cloth(solver, &desc, &corner, &u, &v, 2, 8000000, &body) == GPHYS_ERROR_CAPACITY);
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    CHECK(taken.count() < 0.5);
    CHECK(body == 7);
    // The rows and columns of a small one are counted as they are made.
    for (const uint32_t flags : {0u, uint32_t{GPHYS_CLOTH_SHEAR}, uint32_t{GPHYS_CLOTH_BEND}}) {
        desc.cloth_flags = flags;
        CHECK(gphys_solver_add_cloth(solver, &desc, &corner, &u, &v, 2, 3, &body) == GPHYS_OK);
    }
    gphys_solver_destroy(solver);
}

namespace {

/// Bodies as large as the range of coordinates, moved beside and inside of a sphere that is.
struct FarWorld {
    gphys_scene* scene = nullptr;
    gphys_solver *solver = nullptr, *other = nullptr;
    gphys_body_id body = 0;

    explicit FarWorld(test::Random& random) {
        REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
        REQUIRE(gphys_solver_create(nullptr, &solver) == GPHYS_OK);
        REQUIRE(gphys_solver_create(nullptr, &other) == GPHYS_OK);
        const gphys_sphere ball{random.point(1e15f), random.index(2) ? 1e15f : 1e14f};
        gphys_model_id model;
        REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, nullptr, nullptr, &model) == GPHYS_OK);
        gphys_body_desc desc;
        gphys_body_desc_init(&desc, sizeof desc);
        desc.cloth_flags = random.index(4);
        desc.radius = random.index(2) ? .01f : 1e14f;
        desc.compliance = random.index(4) ? 0 : 1e15f;
        switch (random.index(4)) {
            case 0:
            case 1: {
                gphys_vec3 places[8];
                for (gphys_vec3& place : places) {
                    place = random.point(1e15f);
                    if (random.index(2)) place.x = random.index(2) ? 1e15f : -1e15f;
                }
                const bool rope = random.index(2) != 0;
                const gphys_status status =
                    rope ? gphys_solver_add_rope(solver, &desc, places, sizeof places[0], 8, 0, &body)
                         : gphys_solver_add_particles(solver, &desc, places, sizeof places[0], 8, &body);
                REQUIRE(status == GPHYS_OK);
                break;
            }
            case 2: {
                const gphys_vec3 corner{-1e15f, -1e15f, random.uniform_float(-1e15f, 9e14f)}, u{1e15f, 1e14f, 0},
                    v{0, 1e15f, 1e13f};
                REQUIRE(gphys_solver_add_cloth(solver, &desc, &corner, &u, &v, 5, 5, &body) == GPHYS_OK);
                break;
            }
            default: {
                const float vertices[] = {-1e15f, -1e15f, -1e15f, 1e15f, -1e15f, -1e15f, 0, 1e15f, -1e15f, 0, 0, 1e15f};
                const uint32_t indices[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
                gphys_mesh* mesh = nullptr;
                REQUIRE(gphys_mesh_create(nullptr, vertices, 12, 4, indices, 12, &mesh) == GPHYS_OK);
                REQUIRE(gphys_solver_add_cloth_mesh(solver, &desc, mesh, nullptr, &body) == GPHYS_OK);
                gphys_mesh_destroy(mesh);
                REQUIRE(gphys_solver_set_volume(solver, body, -1, 0) == GPHYS_OK);
            }
        }
    }
    ~FarWorld() {
        gphys_solver_destroy(solver);
        gphys_solver_destroy(other);
        gphys_scene_destroy(scene);
    }
};

}  // namespace

TEST_CASE("bodies as large as the range stay in it, and their snapshots come back") {
    std::vector<uint32_t> words(100000);
    for (uint64_t seed = 0; seed < 300; ++seed) {
        test::Random random(seed);
        FarWorld world(random);
        for (int step = 0; step < 4; ++step) {
            const gphys_vec3 push = random.point(1e15f);
            if (random.index(3) == 0) gphys_solver_set_velocities(world.solver, world.body, 0, 1, &push, sizeof push);
            REQUIRE(gphys_solver_step(world.solver, world.scene, random.index(2) ? 1 / 60.f : .5f) == GPHYS_OK);
            gphys_vec3 place;
            REQUIRE(gphys_solver_get_positions(world.solver, world.body, 0, 1, &place, sizeof place) == GPHYS_OK);
            CAPTURE(seed, step, place.x, place.y, place.z);
            REQUIRE(max_component(abs(widen(place))) <= GPHYS_MAX_COORDINATE);
            uint32_t count = 0;
            REQUIRE(gphys_solver_get_snapshot(world.solver, words.data(), 100000, &count) == GPHYS_OK);
            const gphys_status status = gphys_solver_restore(world.other, words.data(), count);
            CAPTURE(gphys_last_error());
            REQUIRE(status == GPHYS_OK);
        }
    }
}

/* Version, status names and the error text. */
#include "test.h"

static void version_matches_header(void** state) {
    (void)state;
    assert_int_equal(gphys_version(), GPHYS_VERSION_MAJOR << 16 | GPHYS_VERSION_MINOR << 8 | GPHYS_VERSION_PATCH);
}

static void every_status_has_a_name(void** state) {
    const gphys_status others[] = {4, -9, -99, -101, 12345, INT32_MAX, INT32_MIN};
    size_t i;
    (void)state;
#define CHECK_NAME(status) assert_string_equal(gphys_status_name(status), #status)
    CHECK_NAME(GPHYS_OK);
    CHECK_NAME(GPHYS_NO_HIT);
    CHECK_NAME(GPHYS_INCOMPLETE);
    CHECK_NAME(GPHYS_UNBOUNDED);
    CHECK_NAME(GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK_NAME(GPHYS_ERROR_INVALID_ID);
    CHECK_NAME(GPHYS_ERROR_STRUCT_SIZE);
    CHECK_NAME(GPHYS_ERROR_OUT_OF_MEMORY);
    CHECK_NAME(GPHYS_ERROR_CAPACITY);
    CHECK_NAME(GPHYS_ERROR_CYCLE);
    CHECK_NAME(GPHYS_ERROR_UNSUPPORTED);
    CHECK_NAME(GPHYS_ERROR_SINGULAR);
    CHECK_NAME(GPHYS_ERROR_INTERNAL);
    for (i = 0; i < sizeof others / sizeof *others; ++i) assert_string_equal(gphys_status_name(others[i]), "unknown");
}

static void check_error(gphys_status status, const char* message) {
    assert_true(status < 0);
    assert_string_equal(gphys_last_error(), message);
}

static void errors_name_function_parameter_value_and_range(void** state) {
    const gphys_ray rays[2] = {{{0, 0, 0}, {1, 0, 0}, 1}, {{0, 0, 0}, {1, 0, 0}, -2.5f}};
    gphys_hit hits[2];
    gphys_scene* scene;
    gphys_camera* camera;
    gphys_orbit orbit;
    gphys_model_id model = 0;
    const gphys_sphere ball = {{0, 0, 0}, 1};
    const gphys_plane plane = {{0, 1, 0}, 0};
    int32_t overlaps = 0;
    double origin[3] = {0, NAN, 0};
    float positions[3];
    (void)state;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_camera_create(NULL, &camera), GPHYS_OK);
    check_error(gphys_scene_raycast_batch(scene, rays, 30, 2, GPHYS_ALL_LAYERS, hits, sizeof *hits),
                "gphys_scene_raycast_batch: ray_stride 30 is not a multiple of 4");
    check_error(gphys_scene_raycast_batch(scene, rays, sizeof *rays, 1, GPHYS_ALL_LAYERS, hits, 4),
                "gphys_scene_raycast_batch: out_stride 4 is not at least 52, the size of an element");
    check_error(gphys_scene_raycast_batch(scene, rays, sizeof *rays, 2, GPHYS_ALL_LAYERS, hits, sizeof *hits),
                "gphys_scene_raycast_batch: rays[1].t_max -2.5 is not 0 or more");
    check_error(gphys_scene_raycast_batch(scene, NULL, sizeof *rays, 2, GPHYS_ALL_LAYERS, hits, sizeof *hits),
                "gphys_scene_raycast_batch: rays is null");
    check_error(gphys_scene_raycast(NULL, rays, GPHYS_ALL_LAYERS, hits), "gphys_scene_raycast: scene is null");
    check_error(gphys_camera_get_origin(camera, NULL), "gphys_camera_get_origin: out_origin is null");
    check_error(gphys_camera_set_origin(camera, origin),
                "gphys_camera_set_origin: origin[1] nan is not from -1e15 to 1e15");
    check_error(gphys_camera_set_viewport(camera, 0, 1), "gphys_camera_set_viewport: width 0 is not from 0.001 to 1e6");
    check_error(gphys_camera_set_pick_start(camera, 7),
                "gphys_camera_set_pick_start: start 7 is not a gphys_pick_start");
    assert_int_equal(gphys_orbit_init(&orbit), GPHYS_OK);
    orbit.up.x = orbit.up.y = orbit.up.z = 0;
    check_error(gphys_camera_set_orbit(camera, &orbit), "gphys_camera_set_orbit: orbit.up: length 0 is not above 0");
    check_error(gphys_scene_remove(scene, model), "gphys_scene_remove: model 0 is not the id of a model of the scene");
    check_error(gphys_shape_validate((gphys_shape_type)99, positions),
                "gphys_shape_validate: type 99 is not a gphys_shape_type");
    check_error(gphys_shape_overlaps(99, &ball, GPHYS_SHAPE_SPHERE, &ball, &overlaps),
                "gphys_shape_overlaps: a_type 99 is not a gphys_shape_type");
    check_error(gphys_shape_overlaps(GPHYS_SHAPE_SPHERE, &ball, 99, &ball, &overlaps),
                "gphys_shape_overlaps: b_type 99 is not a gphys_shape_type");
    check_error(gphys_shape_overlaps_batch(GPHYS_SHAPE_SPHERE, &ball, 0, GPHYS_SHAPE_SPHERE, NULL, 0, 1, &overlaps, 4),
                "gphys_shape_overlaps_batch: b is null");
    check_error(gphys_shape_overlaps(GPHYS_SHAPE_MESH, NULL, GPHYS_SHAPE_SPHERE, &ball, &overlaps),
                "gphys_shape_overlaps: a is null");
    check_error(gphys_shape_sweep(GPHYS_SHAPE_SPHERE, &ball, GPHYS_SHAPE_PLANE, &plane, &ball.center, hits),
                "gphys_shape_sweep: moving_type 5 is not a sphere, capsule, AABB or OBB");
    check_error(gphys_shape_sweep(GPHYS_SHAPE_SPHERE, &ball, GPHYS_SHAPE_SPHERE, NULL, &ball.center, hits),
                "gphys_shape_sweep: moving is null");
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
}

static void a_successful_call_keeps_the_message(void** state) {
    char before[256];
    gphys_scene* scene;
    (void)state;
    assert_true(gphys_scene_create(NULL, NULL) < 0);
    strcpy(before, gphys_last_error());
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    gphys_scene_destroy(scene);
    assert_string_equal(gphys_last_error(), before);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(version_matches_header),
        cmocka_unit_test(every_status_has_a_name),
        cmocka_unit_test(errors_name_function_parameter_value_and_range),
        cmocka_unit_test(a_successful_call_keeps_the_message),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Picking and culling as a C program sees them. */
#include "test.h"

static gphys_camera* camera;
static gphys_scene* scene;
static gphys_model_id near_sphere, far_sphere, beside;

/* Two spheres behind each other in the middle of the picture, one to the left. */
static int set_up(void** state) {
    const gphys_sphere near_ball = {{0, 0, 5}, 1}, far_ball = {{0, 0, 10}, 1}, left_ball = {{-3, 0, 8}, 0.5f};
    gphys_model_desc desc;
    (void)state;
    if (gphys_camera_create(NULL, &camera) || gphys_scene_create(NULL, &scene)) return -1;
    if (gphys_model_desc_init(&desc, sizeof desc)) return -1;
    desc.layers = 1;
    if (gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &near_ball, NULL, &desc, &near_sphere)) return -1;
    desc.layers = 2;
    if (gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &far_ball, NULL, &desc, &far_sphere)) return -1;
    return gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &left_ball, NULL, &desc, &beside);
}

static int tear_down(void** state) {
    (void)state;
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
    return 0;
}

#define REFUSED(call) assert_int_equal((call), GPHYS_ERROR_INVALID_ARGUMENT)

static int untouched(const void* memory, size_t size) {
    const unsigned char* bytes = memory;
    size_t i;
    for (i = 0; i < size; ++i) {
        if (bytes[i] != 0x5a) return 0;
    }
    return 1;
}

static void pick_is_the_first_hit_of_the_pick_ray(void** state) {
    int x, y, hits = 0;
    (void)state;
    for (y = 0; y < 600; y += 20) {
        for (x = 0; x < 800; x += 20) {
            gphys_hit picked, cast;
            gphys_ray ray;
            gphys_status status, cast_status;
            memset(&picked, 0x5a, sizeof picked);
            status = gphys_camera_pick(camera, scene, (float)x, (float)y, GPHYS_ALL_LAYERS, &picked);
            assert_int_equal(gphys_camera_pick_ray(camera, (float)x, (float)y, &ray), GPHYS_OK);
            cast_status = gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &cast);
            assert_int_equal(status, cast_status);
            if (status == GPHYS_NO_HIT) {
                assert_true(untouched(&picked, sizeof picked));
                continue;
            }
            ++hits;
            assert_int_equal(picked.model, cast.model);
            /* The cast ray was rounded by 2^-25; near a sphere's edge t moves by the square root. */
            assert_true(fabsf(picked.t - cast.t) < 2e-3f);
        }
    }
    assert_true(hits > 20);
}

static void pick_respects_layers(void** state) {
    gphys_hit hit;
    (void)state;
    assert_int_equal(gphys_camera_pick(camera, scene, 400, 300, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_int_equal(hit.model, near_sphere);
    assert_true(hit.t == 3.9f); /* from the near plane on */
    assert_int_equal(gphys_camera_pick(camera, scene, 400, 300, 2, &hit), GPHYS_OK);
    assert_int_equal(hit.model, far_sphere);
    assert_int_equal(gphys_camera_pick(camera, scene, 400, 300, 4, &hit), GPHYS_NO_HIT);
}

static void pick_batch_is_pick_for_each_pixel(void** state) {
    float pixels[64 * 3];
    gphys_hit hits[64];
    uint32_t i;
    (void)state;
    for (i = 0; i < 64; ++i) {
        pixels[3 * i] = 12.5f * (float)i;
        pixels[3 * i + 1] = 300;
        pixels[3 * i + 2] = NAN; /* between the elements: never read */
    }
    assert_int_equal(gphys_camera_pick_batch(camera, scene, pixels, 12, 64, GPHYS_ALL_LAYERS, hits, sizeof *hits),
                     GPHYS_OK);
    for (i = 0; i < 64; ++i) {
        gphys_hit one;
        if (gphys_camera_pick(camera, scene, pixels[3 * i], 300, GPHYS_ALL_LAYERS, &one) == GPHYS_OK) {
            assert_memory_equal(&hits[i], &one, sizeof one);
        } else {
            assert_true(hits[i].t == INFINITY && hits[i].model == 0 && hits[i].triangle == GPHYS_NO_TRIANGLE);
        }
    }
}

static void a_rectangle_picks_what_is_hidden_too(void** state) {
    gphys_model_id models[4];
    uint32_t total = 0;
    (void)state;
    assert_int_equal(
        gphys_camera_pick_rectangle(camera, scene, 410, 310, 390, 290, GPHYS_ALL_LAYERS, models, 4, &total), GPHYS_OK);
    assert_int_equal(total, 2);
    assert_true(models[0] < models[1]);
    assert_true((models[0] == near_sphere && models[1] == far_sphere) ||
                (models[0] == far_sphere && models[1] == near_sphere));
    assert_int_equal(gphys_camera_pick_rectangle(camera, scene, 0, 0, 800, 600, 2, models, 1, &total),
                     GPHYS_INCOMPLETE);
    assert_int_equal(total, 2);
    assert_int_equal(models[0], far_sphere < beside ? far_sphere : beside);
    assert_int_equal(gphys_camera_pick_rectangle(camera, scene, 0, 0, 5, 5, GPHYS_ALL_LAYERS, NULL, 0, &total),
                     GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_camera_cull(camera, scene, GPHYS_ALL_LAYERS, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 3);
    assert_int_equal(gphys_camera_cull(camera, scene, 2, models, 4, &total), GPHYS_OK);
    assert_int_equal(total, 2);
    assert_true(models[0] < models[1]);
}

static void picking_checks_its_arguments(void** state) {
    const float bad[] = {NAN, INFINITY, -INFINITY, 2e15f};
    const float pixels[4] = {400, 300, 10, 10};
    gphys_hit hits[2];
    gphys_model_id models[4];
    uint32_t total;
    int i;
    (void)state;
    memset(hits, 0x5a, sizeof hits);
    memset(models, 0x5a, sizeof models);
    memset(&total, 0x5a, sizeof total);
    REFUSED(gphys_camera_pick(NULL, scene, 1, 1, 1, hits));
    REFUSED(gphys_camera_pick(camera, NULL, 1, 1, 1, hits));
    REFUSED(gphys_camera_pick(camera, scene, 1, 1, 1, NULL));
    REFUSED(gphys_camera_pick_batch(NULL, scene, pixels, 8, 2, 1, hits, sizeof *hits));
    REFUSED(gphys_camera_pick_batch(camera, NULL, pixels, 8, 2, 1, hits, sizeof *hits));
    REFUSED(gphys_camera_pick_batch(camera, scene, NULL, 8, 2, 1, hits, sizeof *hits));
    REFUSED(gphys_camera_pick_batch(camera, scene, pixels, 8, 2, 1, NULL, sizeof *hits));
    REFUSED(gphys_camera_pick_batch(camera, scene, pixels, 4, 2, 1, hits, sizeof *hits));
    REFUSED(gphys_camera_pick_batch(camera, scene, pixels, 10, 1, 1, hits, sizeof *hits));
    REFUSED(gphys_camera_pick_batch(camera, scene, pixels, 8, 2, 1, hits, 0));
    REFUSED(gphys_camera_pick_rectangle(NULL, scene, 0, 0, 9, 9, 1, models, 4, &total));
    REFUSED(gphys_camera_pick_rectangle(camera, NULL, 0, 0, 9, 9, 1, models, 4, &total));
    REFUSED(gphys_camera_pick_rectangle(camera, scene, 0, 0, 9, 9, 1, NULL, 4, &total));
    REFUSED(gphys_camera_pick_rectangle(camera, scene, 0, 0, 9, 9, 1, models, 4, NULL));
    REFUSED(gphys_camera_pick_rectangle(camera, scene, 5, 0, 5, 9, 1, models, 4, &total));
    REFUSED(gphys_camera_pick_rectangle(camera, scene, 0, 5, 9, 5, 1, models, 4, &total));
    REFUSED(gphys_camera_cull(NULL, scene, 1, models, 4, &total));
    REFUSED(gphys_camera_cull(camera, NULL, 1, models, 4, &total));
    REFUSED(gphys_camera_cull(camera, scene, 1, NULL, 4, &total));
    REFUSED(gphys_camera_cull(camera, scene, 1, models, 4, NULL));
    for (i = 0; i < 4; ++i) {
        float mixed[4] = {400, 300, 10, 10};
        mixed[3] = bad[i];
        REFUSED(gphys_camera_pick(camera, scene, bad[i], 1, 1, hits));
        REFUSED(gphys_camera_pick(camera, scene, 1, bad[i], 1, hits));
        REFUSED(gphys_camera_pick_batch(camera, scene, mixed, 8, 2, 1, hits, sizeof *hits));
        REFUSED(gphys_camera_pick_rectangle(camera, scene, bad[i], 0, 9, 9, 1, models, 4, &total));
        REFUSED(gphys_camera_pick_rectangle(camera, scene, 0, 0, 9, bad[i], 1, models, 4, &total));
    }
    assert_true(untouched(hits, sizeof hits) && untouched(models, sizeof models) && untouched(&total, sizeof total));
    assert_int_equal(gphys_camera_pick_batch(camera, scene, NULL, 0, 0, 1, NULL, 0), GPHYS_OK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(pick_is_the_first_hit_of_the_pick_ray, set_up, tear_down),
        cmocka_unit_test_setup_teardown(pick_respects_layers, set_up, tear_down),
        cmocka_unit_test_setup_teardown(pick_batch_is_pick_for_each_pixel, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_rectangle_picks_what_is_hidden_too, set_up, tear_down),
        cmocka_unit_test_setup_teardown(picking_checks_its_arguments, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

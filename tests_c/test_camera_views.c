/* What a camera sees besides the defaults, as a C program sees it: its aspect and width, a place in the window, where
 * sight begins, a view matrix, rectangles of pixels, speeds of its orbit. Planes and matrices by themselves too. */
#include "test.h"

static gphys_camera* camera;

static int set_up(void** state) {
    (void)state;
    return gphys_camera_create(NULL, &camera) == GPHYS_OK ? 0 : -1;
}

static int tear_down(void** state) {
    (void)state;
    gphys_camera_destroy(camera);
    return 0;
}

static const float bad_numbers[] = {NAN, INFINITY, -INFINITY, 2e15f, -2e15f};
enum { BAD_COUNT = 5 };

#define REFUSED(call)                                           \
    do {                                                        \
        assert_int_equal((call), GPHYS_ERROR_INVALID_ARGUMENT); \
        assert_true(strlen(gphys_last_error()) > 0);            \
    } while (0)

static gphys_mat4 projection_matrix(void) {
    gphys_mat4 matrix;
    assert_int_equal(gphys_camera_get_projection_matrix(camera, &matrix), GPHYS_OK);
    return matrix;
}

static void a_projection_has_an_aspect_of_its_own(void** state) {
    float aspect = 7, width = 7, height = 7;
    int32_t fixed = 7;
    gphys_mat4 before, after;
    int i;
    (void)state;
    assert_int_equal(gphys_camera_get_aspect(camera, &aspect, &fixed), GPHYS_OK);
    assert_true(aspect == 800.0f / 600.0f && fixed == 0);
    assert_int_equal(gphys_camera_get_image_size(camera, &width, &height), GPHYS_OK);
    assert_true(fabsf(height - 1.15470054f) < 2e-7f && fabsf(width - 1.53960072f) < 2e-7f); /* 2 tan 30 degrees */

    assert_int_equal(gphys_camera_set_perspective_aspect(camera, 1, 2.5f, 0.5f, 50), GPHYS_OK);
    before = projection_matrix();
    assert_true(fabs((double)before.m[5] / before.m[0] - 2.5) < 1e-6);
    assert_int_equal(gphys_camera_set_viewport(camera, 100, 900), GPHYS_OK);
    after = projection_matrix();
    assert_memory_equal(&before, &after, sizeof before);
    assert_int_equal(gphys_camera_get_aspect(camera, &aspect, &fixed), GPHYS_OK);
    assert_true(aspect == 2.5f && fixed == 1);
    /* The same aspect as that of a viewport gives the same matrix. */
    assert_int_equal(gphys_camera_set_viewport(camera, 250, 100), GPHYS_OK);
    assert_int_equal(gphys_camera_set_perspective(camera, 1, 0.5f, 50), GPHYS_OK);
    after = projection_matrix();
    assert_memory_equal(&before, &after, sizeof before);
    assert_int_equal(gphys_camera_get_aspect(camera, &aspect, &fixed), GPHYS_OK);
    assert_true(aspect == 2.5f && fixed == 0);

    assert_int_equal(gphys_camera_set_orthographic_size(camera, 0.3f, 7.1f, -4, 5), GPHYS_OK);
    before = projection_matrix();
    assert_int_equal(gphys_camera_set_viewport(camera, 1e6f, 1e-3f), GPHYS_OK); /* any: what is seen stays */
    after = projection_matrix();
    assert_memory_equal(&before, &after, sizeof before);
    assert_int_equal(gphys_camera_get_image_size(camera, &width, &height), GPHYS_OK);
    assert_true(width == 0.3f && height == 7.1f);
    assert_int_equal(gphys_camera_get_aspect(camera, &aspect, &fixed), GPHYS_OK);
    assert_true(fabsf(aspect - 0.3f / 7.1f) < 1e-8f && fixed == 1);
    assert_int_equal(gphys_camera_set_projection(camera, &before), GPHYS_OK);
    assert_int_equal(gphys_camera_get_image_size(camera, &width, &height), GPHYS_OK);
    assert_true(width == 0 && height == 0);
    assert_int_equal(gphys_camera_get_aspect(camera, &aspect, &fixed), GPHYS_OK);
    assert_true(fabsf(aspect / 1e9f - 1) < 1e-6f && fixed == 0);

    before = projection_matrix();
    for (i = 0; i < BAD_COUNT; ++i) {
        const float bad = bad_numbers[i];
        REFUSED(gphys_camera_set_perspective_aspect(camera, bad, 1, 0.1f, 100));
        REFUSED(gphys_camera_set_perspective_aspect(camera, 1, bad, 0.1f, 100));
        REFUSED(gphys_camera_set_perspective_aspect(camera, 1, 1, bad, 100));
        if (bad != INFINITY) REFUSED(gphys_camera_set_perspective_aspect(camera, 1, 1, 0.1f, bad));
        REFUSED(gphys_camera_set_orthographic_size(camera, bad, 1, 0, 1));
        REFUSED(gphys_camera_set_orthographic_size(camera, 1, bad, 0, 1));
        REFUSED(gphys_camera_set_orthographic_size(camera, 1, 1, bad, 1));
        REFUSED(gphys_camera_set_orthographic_size(camera, 1, 1, 0, bad));
    }
    REFUSED(gphys_camera_set_perspective_aspect(camera, 1, 0, 0.1f, 100));
    REFUSED(gphys_camera_set_perspective_aspect(camera, 1, 2e6f, 0.1f, 100));
    REFUSED(gphys_camera_set_perspective_aspect(camera, 1, 1, 100, 100));
    REFUSED(gphys_camera_set_perspective_aspect(NULL, 1, 1, 0.1f, 100));
    REFUSED(gphys_camera_set_orthographic_size(camera, 0, 1, 0, 1));
    REFUSED(gphys_camera_set_orthographic_size(camera, 1, -1, 0, 1));
    REFUSED(gphys_camera_set_orthographic_size(camera, 1, 1, 1, 1));
    REFUSED(gphys_camera_set_orthographic_size(NULL, 1, 1, 0, 1));
    REFUSED(gphys_camera_get_aspect(NULL, &aspect, &fixed));
    REFUSED(gphys_camera_get_aspect(camera, NULL, &fixed));
    REFUSED(gphys_camera_get_aspect(camera, &aspect, NULL));
    REFUSED(gphys_camera_get_image_size(NULL, &width, &height));
    REFUSED(gphys_camera_get_image_size(camera, NULL, &height));
    REFUSED(gphys_camera_get_image_size(camera, &width, NULL));
    after = projection_matrix();
    assert_memory_equal(&before, &after, sizeof before);
}

/* The right half of a window of 1600 x 600 is as the whole of one of 800 x 600, 800 pixels to the right. */
static void pixels_count_from_the_windows_corner(void** state) {
    const gphys_vec3 point = {0.7f, -0.4f, 6};
    gphys_vec3 plain, pixel, back, seen[8], expected[8];
    gphys_ray ray, plain_ray, rays[1];
    float x = 7, y = 7;
    int i;
    (void)state;
    assert_int_equal(gphys_camera_get_viewport_origin(camera, &x, &y), GPHYS_OK);
    assert_true(x == 0 && y == 0);
    assert_int_equal(gphys_camera_project(camera, &point, &plain), GPHYS_OK);
    assert_int_equal(gphys_camera_pick_ray(camera, 300.5f, 200.5f, &plain_ray), GPHYS_OK);
    assert_int_equal(gphys_camera_get_rectangle_corners(camera, 100, 50, 250, 75, expected), GPHYS_OK);
    assert_int_equal(gphys_camera_set_viewport_origin(camera, 800, -64), GPHYS_OK);
    assert_int_equal(gphys_camera_get_viewport_origin(camera, &x, &y), GPHYS_OK);
    assert_true(x == 800 && y == -64);
    assert_int_equal(gphys_camera_project(camera, &point, &pixel), GPHYS_OK);
    assert_true(fabsf(pixel.x - plain.x - 800) < 1e-4f && fabsf(pixel.y - plain.y + 64) < 1e-4f && pixel.z == plain.z);
    assert_int_equal(gphys_camera_unproject(camera, &pixel, &back), GPHYS_OK);
    assert_true(fabsf(back.x - point.x) + fabsf(back.y - point.y) + fabsf(back.z - point.z) < 1e-4f);
    assert_int_equal(gphys_camera_pick_ray(camera, 1100.5f, 136.5f, &ray), GPHYS_OK);
    assert_memory_equal(&ray, &plain_ray, sizeof ray);
    assert_int_equal(gphys_camera_set_viewport_origin(camera, 800, 64), GPHYS_OK);
    assert_int_equal(gphys_camera_pick_rays(camera, 1100, 264, 1, 1, rays, sizeof *rays), GPHYS_OK);
    assert_memory_equal(&rays[0], &plain_ray, sizeof ray);
    assert_int_equal(gphys_camera_get_rectangle_corners(camera, 900, 114, 1050, 139, seen), GPHYS_OK);
    assert_memory_equal(seen, expected, sizeof seen);
    for (i = 0; i < BAD_COUNT; ++i) {
        REFUSED(gphys_camera_set_viewport_origin(camera, bad_numbers[i], 0));
        REFUSED(gphys_camera_set_viewport_origin(camera, 0, bad_numbers[i]));
    }
    REFUSED(gphys_camera_set_viewport_origin(NULL, 0, 0));
    REFUSED(gphys_camera_get_viewport_origin(NULL, &x, &y));
    REFUSED(gphys_camera_get_viewport_origin(camera, NULL, &y));
    REFUSED(gphys_camera_get_viewport_origin(camera, &x, NULL));
    assert_int_equal(gphys_camera_get_viewport_origin(camera, &x, &y), GPHYS_OK);
    assert_true(x == 800 && y == 64);
}

static void a_camera_tells_what_it_was_created_with(void** state) {
    gphys_camera_desc desc;
    int32_t i, reverse_z = 7;
    gphys_handedness handedness = 7;
    gphys_depth_range range = 7;
    gphys_camera* other = NULL;
    (void)state;
    REFUSED(gphys_camera_get_conventions(NULL, &handedness, &range, &reverse_z));
    REFUSED(gphys_camera_get_conventions(camera, NULL, &range, &reverse_z));
    REFUSED(gphys_camera_get_conventions(camera, &handedness, NULL, &reverse_z));
    REFUSED(gphys_camera_get_conventions(camera, &handedness, &range, NULL));
    assert_true(handedness == 7 && range == 7 && reverse_z == 7);
    assert_int_equal(gphys_camera_desc_init(&desc, sizeof desc), GPHYS_OK);
    for (i = 0; i < 8; ++i) {
        desc.handedness = i & 1 ? GPHYS_RIGHT_HANDED : GPHYS_LEFT_HANDED;
        desc.depth_range = i & 2 ? GPHYS_DEPTH_MINUS_ONE_TO_ONE : GPHYS_DEPTH_ZERO_TO_ONE;
        desc.reverse_z = i >> 2;
        assert_int_equal(gphys_camera_create(&desc, &other), GPHYS_OK);
        assert_int_equal(gphys_camera_get_conventions(other, &handedness, &range, &reverse_z), GPHYS_OK);
        assert_int_equal(handedness, desc.handedness);
        assert_int_equal(range, desc.depth_range);
        assert_int_equal(reverse_z, desc.reverse_z);
        gphys_camera_destroy(other);
    }
}

/* A ball between the camera and its near plane, one behind: what is drawn is picked. */
static void sight_begins_at_the_near_plane_or_at_the_camera(void** state) {
    const gphys_sphere before = {{0, 0, 0.5f}, 0.25f}, behind = {{0, 0, 5}, 1};
    const float middle[2] = {400, 300};
    gphys_query_filter_desc filter;
    gphys_pick_start start = 7;
    gphys_model_id near_ball, far_ball;
    gphys_scene* scene;
    gphys_ray ray;
    gphys_hit hit;
    (void)state;
    assert_int_equal(gphys_query_filter_desc_init(&filter, sizeof filter), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &before, NULL, NULL, &near_ball), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &behind, NULL, NULL, &far_ball), GPHYS_OK);
    assert_int_equal(gphys_camera_set_perspective(camera, 1, 1, 100), GPHYS_OK);
    assert_int_equal(gphys_camera_get_pick_start(camera, &start), GPHYS_OK);
    assert_int_equal(start, GPHYS_PICK_FROM_NEAR_PLANE);
    assert_int_equal(gphys_camera_pick_ray(camera, 400, 300, &ray), GPHYS_OK);
    assert_true(ray.origin.z == 1 && ray.direction.z == 1 && ray.t_max == 99);
    assert_int_equal(gphys_camera_pick(camera, scene, 400, 300, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_true(hit.model == far_ball && hit.t == 3 && hit.point.z == 4);
    assert_int_equal(gphys_camera_pick_batch(camera, scene, middle, 8, 1, GPHYS_ALL_LAYERS, &hit, sizeof hit),
                     GPHYS_OK);
    assert_true(hit.model == far_ball && hit.t == 3);
    assert_int_equal(gphys_camera_pick_filtered(camera, scene, 400, 300, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == far_ball && hit.t == 3);

    assert_int_equal(gphys_camera_set_pick_start(camera, GPHYS_PICK_FROM_CENTRE), GPHYS_OK);
    assert_int_equal(gphys_camera_get_pick_start(camera, &start), GPHYS_OK);
    assert_int_equal(start, GPHYS_PICK_FROM_CENTRE);
    assert_int_equal(gphys_camera_pick_ray(camera, 400, 300, &ray), GPHYS_OK);
    assert_true(ray.origin.z == 0 && ray.direction.z == 1 && ray.t_max == 100);
    assert_int_equal(gphys_camera_pick(camera, scene, 400, 300, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_true(hit.model == near_ball && hit.t == 0.25f);
    assert_int_equal(gphys_camera_pick_batch(camera, scene, middle, 8, 1, GPHYS_ALL_LAYERS, &hit, sizeof hit),
                     GPHYS_OK);
    assert_true(hit.model == near_ball && hit.t == 0.25f);
    /* An orthographic camera starts on its near plane in any case. */
    assert_int_equal(gphys_camera_set_orthographic(camera, 10, 1, 100), GPHYS_OK);
    assert_int_equal(gphys_camera_pick(camera, scene, 400, 300, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_true(hit.model == far_ball && hit.t == 3);

    REFUSED(gphys_camera_set_pick_start(NULL, GPHYS_PICK_FROM_CENTRE));
    REFUSED(gphys_camera_set_pick_start(camera, 2));
    REFUSED(gphys_camera_set_pick_start(camera, -1));
    REFUSED(gphys_camera_get_pick_start(NULL, &start));
    REFUSED(gphys_camera_get_pick_start(camera, NULL));
    assert_int_equal(start, GPHYS_PICK_FROM_CENTRE);
    gphys_scene_destroy(scene);
}

static void a_view_matrix_puts_the_camera_back(void** state) {
    const gphys_vec3 eye = {3, -20, 500}, target = {1, 2, 3}, up = {0.5f, 1, 0};
    gphys_mat4 view, bad, world, again;
    gphys_vec3 position;
    gphys_quat rotation;
    float error = 7;
    int handedness, i;
    (void)state;
    for (handedness = 0; handedness < 2; ++handedness) {
        gphys_camera_desc desc;
        gphys_camera *from, *to;
        assert_int_equal(gphys_camera_desc_init(&desc, sizeof desc), GPHYS_OK);
        desc.handedness = handedness;
        assert_int_equal(gphys_camera_create(&desc, &from), GPHYS_OK);
        assert_int_equal(gphys_camera_create(&desc, &to), GPHYS_OK);
        assert_int_equal(gphys_camera_look_at(from, &eye, &target, &up), GPHYS_OK);
        assert_int_equal(gphys_camera_get_view_matrix(from, &view), GPHYS_OK);
        assert_int_equal(gphys_camera_set_view_matrix(to, &view), GPHYS_OK);
        assert_int_equal(gphys_camera_get_transform(to, &position, &rotation), GPHYS_OK);
        /* 2^-22 of 500 metres. */
        assert_true(fabsf(position.x - 3) < 1.2e-4f && fabsf(position.y + 20) < 1.2e-4f);
        assert_true(fabsf(position.z - 500) < 1.2e-4f);
        assert_int_equal(gphys_camera_get_world_matrix(from, &world), GPHYS_OK);
        assert_int_equal(gphys_camera_get_world_matrix(to, &again), GPHYS_OK);
        for (i = 0; i < 12; ++i) assert_true(fabsf(world.m[i] - again.m[i]) < 2.4e-7f);
        assert_int_equal(gphys_mat4_orthonormality(&again, &error), GPHYS_OK);
        assert_true(error < 2.4e-7f);
        gphys_camera_destroy(from);
        gphys_camera_destroy(to);
    }
    assert_int_equal(gphys_camera_get_world_matrix(camera, &world), GPHYS_OK);
    REFUSED(gphys_camera_set_view_matrix(NULL, &view));
    REFUSED(gphys_camera_set_view_matrix(camera, NULL));
    for (i = 0; i < 16; ++i) {
        bad = view;
        bad.m[i] = bad_numbers[i % BAD_COUNT];
        REFUSED(gphys_camera_set_view_matrix(camera, &bad));
    }
    bad = view;
    bad.m[7] = 1e-3f;
    REFUSED(gphys_camera_set_view_matrix(camera, &bad));
    bad = world;
    bad.m[0] = -1;
    REFUSED(gphys_camera_set_view_matrix(camera, &bad));
    bad.m[0] = 1e-9f;
    bad.m[12] = 1e12f;
    REFUSED(gphys_camera_set_view_matrix(camera, &bad)); /* 1e21 m away */
    bad.m[0] = 0;
    assert_int_equal(gphys_camera_set_view_matrix(camera, &bad), GPHYS_ERROR_SINGULAR);
    assert_int_equal(gphys_camera_get_world_matrix(camera, &again), GPHYS_OK);
    assert_memory_equal(&again, &world, sizeof world);
}

static void a_rectangle_has_a_frustum_and_corners(void** state) {
    gphys_frustum frustum, whole;
    gphys_vec3 corners[8], expected[8];
    int flat, i;
    (void)state;
    for (flat = 0; flat < 2; ++flat) {
        if (flat)
            assert_int_equal(gphys_camera_set_orthographic(camera, 12, 1, 9), GPHYS_OK);
        else
            assert_int_equal(gphys_camera_set_perspective(camera, 1, 1, 9), GPHYS_OK);
        assert_int_equal(gphys_camera_get_rectangle_frustum(camera, 800, 0, 0, 600, &frustum), GPHYS_OK);
        assert_int_equal(gphys_camera_get_frustum(camera, &whole), GPHYS_OK);
        assert_memory_equal(&frustum, &whole, sizeof whole);
        assert_int_equal(gphys_camera_get_rectangle_corners(camera, 0, 600, 800, 0, corners), GPHYS_OK);
        assert_int_equal(gphys_camera_get_corners(camera, expected), GPHYS_OK);
        assert_memory_equal(corners, expected, sizeof corners);
        /* The corners are where the planes meet and where the pixels are: left-bottom first, near then far. */
        assert_int_equal(gphys_camera_get_rectangle_frustum(camera, 100, 80, 350, 200, &frustum), GPHYS_OK);
        assert_int_equal(gphys_camera_get_rectangle_corners(camera, 350, 80, 100, 200, corners), GPHYS_OK);
        assert_int_equal(gphys_frustum_corners(&frustum, expected), GPHYS_OK);
        for (i = 0; i < 8; ++i) {
            const float x = i % 4 == 0 || i % 4 == 3 ? 100.0f : 350.0f, y = i % 4 < 2 ? 200.0f : 80.0f;
            gphys_vec3 pixel;
            assert_int_equal(gphys_camera_project(camera, &corners[i], &pixel), GPHYS_OK);
            assert_true(fabsf(pixel.x - x) < 1e-3f && fabsf(pixel.y - y) < 1e-3f);
            assert_true(fabsf(pixel.z - (i < 4 ? 0.0f : 1.0f)) < 1e-6f);
            assert_true(fabsf(corners[i].x - expected[i].x) + fabsf(corners[i].y - expected[i].y) +
                            fabsf(corners[i].z - expected[i].z) <
                        1e-5f);
        }
    }
    for (i = 0; i < BAD_COUNT; ++i) {
        const float bad = bad_numbers[i];
        REFUSED(gphys_camera_get_rectangle_frustum(camera, bad, 0, 1, 1, &frustum));
        REFUSED(gphys_camera_get_rectangle_frustum(camera, 0, 0, 1, bad, &frustum));
        REFUSED(gphys_camera_get_rectangle_corners(camera, 0, bad, 1, 1, corners));
        REFUSED(gphys_camera_get_rectangle_corners(camera, 0, 0, bad, 1, corners));
    }
    REFUSED(gphys_camera_get_rectangle_frustum(camera, 5, 0, 5, 1, &frustum));
    REFUSED(gphys_camera_get_rectangle_corners(camera, 0, 1, 5, 1, corners));
    REFUSED(gphys_camera_get_rectangle_frustum(NULL, 0, 0, 1, 1, &frustum));
    REFUSED(gphys_camera_get_rectangle_frustum(camera, 0, 0, 1, 1, NULL));
    REFUSED(gphys_camera_get_rectangle_corners(NULL, 0, 0, 1, 1, corners));
    REFUSED(gphys_camera_get_rectangle_corners(camera, 0, 0, 1, 1, NULL));
    assert_int_equal(gphys_camera_set_perspective(camera, 1, 1, INFINITY), GPHYS_OK);
    assert_int_equal(gphys_camera_get_rectangle_corners(camera, 0, 0, 1, 1, corners), GPHYS_UNBOUNDED);
}

static void each_input_of_an_orbit_has_its_speed(void** state) {
    const gphys_orbit_speeds speeds = {0.25f, -0.5f, 2, 3, -4};
    gphys_orbit_speeds now, bad = speeds;
    gphys_orbit orbit, present;
    int i;
    (void)state;
    memset(&now, 0x5a, sizeof now);
    assert_int_equal(gphys_camera_set_orbit_speeds(camera, &speeds), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_camera_get_orbit_speeds(camera, &now), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_orbit_init(&orbit), GPHYS_OK);
    orbit.radians_per_unit = 0.125f;
    orbit.metres_per_unit = 0.75f;
    assert_int_equal(gphys_camera_set_orbit(camera, &orbit), GPHYS_OK);
    assert_int_equal(gphys_camera_get_orbit_speeds(camera, &now), GPHYS_OK);
    assert_true(now.rotate_x == 0.125f && now.rotate_y == 0.125f);
    assert_true(now.zoom == 0.75f && now.pan_x == 0.75f && now.pan_y == 0.75f);
    assert_int_equal(gphys_camera_set_orbit_speeds(camera, &speeds), GPHYS_OK);
    assert_int_equal(gphys_camera_get_orbit_speeds(camera, &now), GPHYS_OK);
    assert_memory_equal(&now, &speeds, sizeof now);
    assert_int_equal(gphys_camera_orbit_pan(camera, 1, 1), GPHYS_OK);
    assert_int_equal(gphys_camera_orbit_update(camera), GPHYS_OK);
    assert_int_equal(gphys_camera_orbit_rotate(camera, 2, 1), GPHYS_OK);
    assert_int_equal(gphys_camera_orbit_zoom(camera, 1.5f), GPHYS_OK);
    assert_int_equal(gphys_camera_orbit_update(camera), GPHYS_OK);
    assert_int_equal(gphys_camera_get_orbit(camera, &present), GPHYS_OK);
    assert_true(present.target.x == 3 && present.target.y == -4);
    assert_true(present.yaw == 0.5f && present.pitch == -0.5f && present.distance == 7);
    for (i = 0; i < BAD_COUNT * 5; ++i) {
        bad = speeds;
        ((float*)&bad)[i % 5] = bad_numbers[i / 5];
        REFUSED(gphys_camera_set_orbit_speeds(camera, &bad));
    }
    REFUSED(gphys_camera_set_orbit_speeds(NULL, &speeds));
    REFUSED(gphys_camera_set_orbit_speeds(camera, NULL));
    REFUSED(gphys_camera_get_orbit_speeds(NULL, &now));
    REFUSED(gphys_camera_get_orbit_speeds(camera, NULL));
    assert_int_equal(gphys_camera_get_orbit_speeds(camera, &now), GPHYS_OK);
    assert_memory_equal(&now, &speeds, sizeof now);
}

static void three_planes_meet_in_a_point(void** state) {
    const gphys_plane x = {{2, 0, 0}, 3}, y = {{0, -1, 0}, 4}, z = {{0, 0, 0.5f}, 5}, level = {{0, 3, 0}, 1};
    const gphys_plane leaning[2] = {{{0, 0, 0.5f}, 5}, {{0, 1e-3f, 0}, 1}};
    gphys_plane bad = x;
    gphys_vec3 point = {7, 7, 7}, points[2];
    (void)state;
    assert_int_equal(gphys_planes_intersection(&x, &y, &z, &point), GPHYS_OK);
    assert_true(point.x == 1.5f && point.y == -4 && point.z == 10);
    assert_int_equal(gphys_planes_intersection(&x, &y, &level, &point), GPHYS_NO_HIT);
    assert_int_equal(gphys_planes_intersection(&x, &x, &z, &point), GPHYS_NO_HIT);
    assert_true(point.x == 1.5f && point.y == -4 && point.z == 10);
    assert_int_equal(gphys_planes_intersection_batch(&x, 0, &y, 0, leaning, sizeof *leaning, 2, points, sizeof *points),
                     GPHYS_OK);
    assert_memory_equal(&points[0], &point, sizeof point);
    assert_true(points[1].x == INFINITY && points[1].y == INFINITY && points[1].z == INFINITY);
    REFUSED(gphys_planes_intersection(NULL, &y, &z, &point));
    REFUSED(gphys_planes_intersection(&x, NULL, &z, &point));
    REFUSED(gphys_planes_intersection(&x, &y, NULL, &point));
    REFUSED(gphys_planes_intersection(&x, &y, &z, NULL));
    bad.normal.x = NAN;
    REFUSED(gphys_planes_intersection(&bad, &y, &z, &point));
    REFUSED(gphys_planes_intersection(&x, &bad, &z, &point));
    REFUSED(gphys_planes_intersection(&x, &y, &bad, &point));
    REFUSED(gphys_planes_intersection_batch(NULL, 0, &y, 0, &z, 0, 1, points, 12));
    REFUSED(gphys_planes_intersection_batch(&x, 0, NULL, 0, &z, 0, 1, points, 12));
    REFUSED(gphys_planes_intersection_batch(&x, 0, &y, 0, NULL, 0, 1, points, 12));
    REFUSED(gphys_planes_intersection_batch(&x, 0, &y, 0, &z, 0, 1, NULL, 12));
    REFUSED(gphys_planes_intersection_batch(&x, 2, &y, 0, &z, 0, 1, points, 12));
    REFUSED(gphys_planes_intersection_batch(&x, 0, &y, 15, &z, 0, 1, points, 12));
    REFUSED(gphys_planes_intersection_batch(&x, 0, &y, 0, &z, 8, 1, points, 12));
    REFUSED(gphys_planes_intersection_batch(&x, 0, &y, 0, &z, 0, 1, points, 0));
    REFUSED(gphys_planes_intersection_batch(&x, 0, &y, 0, &bad, 0, 1, points, 12));
    assert_memory_equal(&points[0], &point, sizeof point);
    assert_int_equal(gphys_planes_intersection_batch(NULL, 0, NULL, 0, NULL, 0, 0, NULL, 0), GPHYS_OK);
}

static void a_matrix_tells_how_far_its_axes_are_from_orthonormal(void** state) {
    gphys_mat4 matrix = {{0, 1, 0, 9, 0, 0, 1, 9, 1, 0, 0, 9, 5, 5, 5, 1}};
    float error = 7;
    int i;
    (void)state;
    assert_int_equal(gphys_mat4_orthonormality(&matrix, &error), GPHYS_OK);
    assert_true(error == 0);
    matrix.m[0] = -0.25f; /* 1 + 1/16, and a product of -1/4 with the third axis */
    assert_int_equal(gphys_mat4_orthonormality(&matrix, &error), GPHYS_OK);
    assert_true(error == 0.25f);
    matrix.m[0] = 0;
    matrix.m[6] = 2;
    assert_int_equal(gphys_mat4_orthonormality(&matrix, &error), GPHYS_OK);
    assert_true(error == 3);
    for (i = 0; i < BAD_COUNT; ++i) {
        matrix.m[i] = bad_numbers[i];
        REFUSED(gphys_mat4_orthonormality(&matrix, &error));
        matrix.m[i] = 1;
    }
    REFUSED(gphys_mat4_orthonormality(NULL, &error));
    REFUSED(gphys_mat4_orthonormality(&matrix, NULL));
    assert_true(error == 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_projection_has_an_aspect_of_its_own, set_up, tear_down),
        cmocka_unit_test_setup_teardown(pixels_count_from_the_windows_corner, set_up, tear_down),
        cmocka_unit_test_setup_teardown(sight_begins_at_the_near_plane_or_at_the_camera, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_camera_tells_what_it_was_created_with, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_view_matrix_puts_the_camera_back, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_rectangle_has_a_frustum_and_corners, set_up, tear_down),
        cmocka_unit_test_setup_teardown(each_input_of_an_orbit_has_its_speed, set_up, tear_down),
        cmocka_unit_test(three_planes_meet_in_a_point),
        cmocka_unit_test(a_matrix_tells_how_far_its_axes_are_from_orthonormal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The camera as a C program sees it: every argument checked, outputs untouched on errors, and the
 * functions in agreement with one another. Their numbers are tested in tests_cpp. */
#include "test.h"

#include <stdlib.h>

static const float bad_numbers[] = {NAN, INFINITY, -INFINITY, 2e15f, -2e15f};
enum { BAD_COUNT = 5 };

static gphys_camera* camera;

static int set_up(void** state) {
    (void)state;
    return gphys_camera_create(NULL, &camera) == GPHYS_OK ? 0 : -1;
}

static int tear_down(void** state) {
    (void)state;
    gphys_camera_destroy(camera);
    camera = NULL;
    return 0;
}

/* Everything that a failing setter must leave alone. */
struct snapshot {
    gphys_mat4 world, view_projection;
    gphys_vec3 pixel;
};

static struct snapshot take_snapshot(void) {
    const gphys_vec3 probe = {0.5f, 0.25f, 7};
    struct snapshot s;
    assert_int_equal(gphys_camera_get_world_matrix(camera, &s.world), GPHYS_OK);
    assert_int_equal(gphys_camera_get_view_projection_matrix(camera, &s.view_projection), GPHYS_OK);
    assert_int_equal(gphys_camera_project(camera, &probe, &s.pixel), GPHYS_OK);
    return s;
}

static void assert_unchanged(const struct snapshot* before) {
    const struct snapshot now = take_snapshot();
    assert_memory_equal(&now, before, sizeof now);
}

#define REFUSED(call)                                           \
    do {                                                        \
        assert_int_equal((call), GPHYS_ERROR_INVALID_ARGUMENT); \
        assert_true(strlen(gphys_last_error()) > 0);            \
    } while (0)

/* Whether the bytes still are what memset(.., 0x5a, ..) made them. */
static int untouched(const void* memory, size_t size) {
    const unsigned char* bytes = memory;
    size_t i;
    for (i = 0; i < size; ++i) {
        if (bytes[i] != 0x5a) return 0;
    }
    return 1;
}

static void desc_has_the_documented_defaults(void** state) {
    gphys_camera_desc desc;
    unsigned char larger[sizeof(gphys_camera_desc) + 16];
    (void)state;
    REFUSED(gphys_camera_desc_init(NULL, sizeof desc));
    assert_int_equal(gphys_camera_desc_init(&desc, 4), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(gphys_camera_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_int_equal(desc.struct_size, sizeof desc);
    assert_null(desc.allocator);
    assert_int_equal(desc.handedness, GPHYS_LEFT_HANDED);
    assert_int_equal(desc.depth_range, GPHYS_DEPTH_ZERO_TO_ONE);
    assert_int_equal(desc.reverse_z, 0);
    assert_true(desc.viewport_width == 800 && desc.viewport_height == 600);
    /* A newer client's desc is larger. */
    memset(larger, 0x5a, sizeof larger);
    assert_int_equal(gphys_camera_desc_init((gphys_camera_desc*)(void*)larger, sizeof larger), GPHYS_OK);
    assert_int_equal(larger[sizeof larger - 1], 0);
}

static void create_checks_its_desc(void** state) {
    /* A union, so that the larger desc is aligned. */
    union {
        gphys_camera_desc desc;
        unsigned char bytes[sizeof(gphys_camera_desc) + 8];
    } newer;
    gphys_camera_desc desc, good;
    gphys_camera* made = NULL;
    gphys_allocator half = {0};
    int i;
    (void)state;
    assert_int_equal(gphys_camera_desc_init(&good, sizeof good), GPHYS_OK);
    REFUSED(gphys_camera_create(&good, NULL));
    memset(&desc, 0, sizeof desc);
    assert_int_equal(gphys_camera_create(&desc, &made), GPHYS_ERROR_STRUCT_SIZE);
    for (i = 0; i < BAD_COUNT + 3; ++i) {
        const float bad = i < BAD_COUNT ? bad_numbers[i] : i == BAD_COUNT ? 0 : i == BAD_COUNT + 1 ? -1 : 1e-4f;
        desc = good;
        desc.viewport_width = bad;
        REFUSED(gphys_camera_create(&desc, &made));
        desc = good;
        desc.viewport_height = bad;
        REFUSED(gphys_camera_create(&desc, &made));
    }
    desc = good;
    desc.handedness = 2;
    REFUSED(gphys_camera_create(&desc, &made));
    desc = good;
    desc.depth_range = -1;
    REFUSED(gphys_camera_create(&desc, &made));
    desc = good;
    desc.reverse_z = 2;
    REFUSED(gphys_camera_create(&desc, &made));
    desc = good;
    desc.allocator = &half;
    REFUSED(gphys_camera_create(&desc, &made));
    assert_null(made);

    memset(&newer, 0, sizeof newer);
    assert_int_equal(gphys_camera_desc_init(&newer.desc, sizeof newer), GPHYS_OK);
    assert_int_equal(gphys_camera_create(&newer.desc, &made), GPHYS_OK);
    gphys_camera_destroy(made);
    made = NULL;
    newer.bytes[sizeof newer - 1] = 1;
    assert_int_equal(gphys_camera_create(&newer.desc, &made), GPHYS_ERROR_STRUCT_SIZE);
    assert_null(made);

    /* A client of release 1.0 has padding there. */
    good.reserved = 0xffffffffu;
    assert_int_equal(gphys_camera_create(&good, &made), GPHYS_OK);
    gphys_camera_destroy(made);
    made = NULL;
    gphys_camera_destroy(NULL);
}

struct ledger {
    int live, calls, fail;
};

static void* ledger_allocate(void* user, size_t size, size_t alignment) {
    struct ledger* ledger = user;
    (void)alignment;
    ++ledger->calls;
    if (ledger->fail) return NULL;
    ++ledger->live;
    return malloc(size);
}

static void ledger_release(void* user, void* memory, size_t size, size_t alignment) {
    struct ledger* ledger = user;
    (void)size;
    (void)alignment;
    --ledger->live;
    free(memory);
}

static void the_callers_allocator_is_used_and_may_fail(void** state) {
    struct ledger ledger = {0, 0, 1};
    gphys_allocator allocator;
    gphys_camera_desc desc;
    gphys_camera* made = NULL;
    (void)state;
    allocator.allocate = ledger_allocate;
    allocator.release = ledger_release;
    allocator.user = &ledger;
    assert_int_equal(gphys_camera_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.allocator = &allocator;
    assert_int_equal(gphys_camera_create(&desc, &made), GPHYS_ERROR_OUT_OF_MEMORY);
    assert_null(made);
    ledger.fail = 0;
    assert_int_equal(gphys_camera_create(&desc, &made), GPHYS_OK);
    assert_true(ledger.live > 0);
    gphys_camera_destroy(made);
    assert_int_equal(ledger.live, 0);
}

static void projection_setters_check(void** state) {
    const struct snapshot before = take_snapshot();
    gphys_mat4 matrix;
    int i, k;
    (void)state;
    REFUSED(gphys_camera_set_perspective(NULL, 1, 0.1f, 100));
    REFUSED(gphys_camera_set_orthographic(NULL, 1, 0.1f, 100));
    REFUSED(gphys_camera_set_viewport(NULL, 1, 1));
    for (i = 0; i < BAD_COUNT; ++i) {
        const float bad = bad_numbers[i];
        REFUSED(gphys_camera_set_perspective(camera, bad, 0.1f, 100));
        REFUSED(gphys_camera_set_perspective(camera, 1, bad, 100));
        if (bad != INFINITY) REFUSED(gphys_camera_set_perspective(camera, 1, 0.1f, bad));
        REFUSED(gphys_camera_set_orthographic(camera, bad, 0.1f, 100));
        REFUSED(gphys_camera_set_orthographic(camera, 1, bad, 100));
        REFUSED(gphys_camera_set_orthographic(camera, 1, 0.1f, bad));
        REFUSED(gphys_camera_set_viewport(camera, bad, 100));
        REFUSED(gphys_camera_set_viewport(camera, 100, bad));
        for (k = 0; k < 16; ++k) {
            memset(&matrix, 0, sizeof matrix);
            matrix.m[0] = matrix.m[5] = matrix.m[10] = matrix.m[15] = 1;
            matrix.m[k] = bad;
            REFUSED(gphys_camera_set_projection(camera, &matrix));
            REFUSED(gphys_camera_set_world_matrix(camera, &matrix));
        }
    }
    REFUSED(gphys_camera_set_perspective(camera, 0, 0.1f, 100));
    REFUSED(gphys_camera_set_perspective(camera, -1, 0.1f, 100));
    REFUSED(gphys_camera_set_perspective(camera, 3.1415928f, 0.1f, 100));
    REFUSED(gphys_camera_set_perspective(camera, 1, 0, 100));
    REFUSED(gphys_camera_set_perspective(camera, 1, -1, 100));
    REFUSED(gphys_camera_set_perspective(camera, 1, 100, 100));
    REFUSED(gphys_camera_set_perspective(camera, 1, 100, 10));
    REFUSED(gphys_camera_set_orthographic(camera, 0, 0, 1));
    REFUSED(gphys_camera_set_orthographic(camera, -1, 0, 1));
    REFUSED(gphys_camera_set_orthographic(camera, 1, 5, 5));
    REFUSED(gphys_camera_set_orthographic(camera, 1, 5, -5));
    REFUSED(gphys_camera_set_viewport(camera, 0, 100));
    REFUSED(gphys_camera_set_viewport(camera, 100, -1));
    REFUSED(gphys_camera_set_projection(camera, NULL));
    REFUSED(gphys_camera_set_projection(NULL, &matrix));
    memset(&matrix, 0, sizeof matrix);
    assert_int_equal(gphys_camera_set_projection(camera, &matrix), GPHYS_ERROR_SINGULAR);
    assert_unchanged(&before);

    assert_int_equal(gphys_camera_set_perspective(camera, 3.1415925f, 1e-38f, INFINITY), GPHYS_OK);
    assert_int_equal(gphys_camera_set_perspective(camera, 1e-6f, 1, 1e15f), GPHYS_OK);
    assert_int_equal(gphys_camera_set_viewport(camera, 1e6f, 1e-3f), GPHYS_OK);
    assert_int_equal(gphys_camera_set_orthographic(camera, 1e-6f, -1, 1), GPHYS_OK);
    assert_int_equal(gphys_camera_get_projection_matrix(camera, &matrix), GPHYS_OK);
    for (k = 0; k < 16; ++k) assert_true(isfinite(matrix.m[k]));
}

static void placement_checks(void** state) {
    const struct snapshot before = take_snapshot();
    const gphys_vec3 zero = {0, 0, 0}, one = {1, 0, 0};
    const gphys_quat still = {0, 0, 0, 1}, none = {0, 0, 0, 0}, half = {0, 0, 0, 0.5f};
    gphys_mat4 world = before.world;
    int i, k;
    (void)state;
    REFUSED(gphys_camera_set_transform(NULL, &zero, &still));
    REFUSED(gphys_camera_set_transform(camera, NULL, &still));
    REFUSED(gphys_camera_set_transform(camera, &zero, NULL));
    REFUSED(gphys_camera_set_transform(camera, &zero, &none));
    REFUSED(gphys_camera_set_transform(camera, &zero, &half));
    REFUSED(gphys_camera_set_world_matrix(NULL, &world));
    REFUSED(gphys_camera_set_world_matrix(camera, NULL));
    for (k = 3; k < 16; k += 4) {
        world = before.world;
        world.m[k] += 0.5f;
        REFUSED(gphys_camera_set_world_matrix(camera, &world));
    }
    world = before.world;
    world.m[0] = -world.m[0];
    REFUSED(gphys_camera_set_world_matrix(camera, &world));
    world.m[0] = 0;
    assert_int_equal(gphys_camera_set_world_matrix(camera, &world), GPHYS_ERROR_SINGULAR);
    REFUSED(gphys_camera_look_at(NULL, &zero, &one, &one));
    REFUSED(gphys_camera_look_at(camera, NULL, &one, &one));
    REFUSED(gphys_camera_look_at(camera, &zero, NULL, &one));
    REFUSED(gphys_camera_look_at(camera, &zero, &one, NULL));
    REFUSED(gphys_camera_look_at(camera, &one, &one, &one));
    REFUSED(gphys_camera_look_at(camera, &zero, &one, &zero));
    for (i = 0; i < BAD_COUNT; ++i) {
        const gphys_vec3 bad = {0, bad_numbers[i], 0};
        gphys_quat bad_rotation = still;
        bad_rotation.x = bad_numbers[i];
        REFUSED(gphys_camera_set_transform(camera, &bad, &still));
        REFUSED(gphys_camera_set_transform(camera, &zero, &bad_rotation));
        REFUSED(gphys_camera_look_at(camera, &bad, &one, &one));
        REFUSED(gphys_camera_look_at(camera, &zero, &bad, &one));
        REFUSED(gphys_camera_look_at(camera, &zero, &one, &bad));
    }
    assert_unchanged(&before);
}

static void getters_check_and_leave_outputs_alone(void** state) {
    gphys_vec3 v[8];
    gphys_quat q;
    gphys_mat4 m;
    gphys_frustum frustum;
    gphys_ray ray;
    (void)state;
    memset(v, 0x5a, sizeof v);
    memset(&q, 0x5a, sizeof q);
    memset(&m, 0x5a, sizeof m);
    memset(&frustum, 0x5a, sizeof frustum);
    memset(&ray, 0x5a, sizeof ray);
    REFUSED(gphys_camera_get_transform(NULL, v, &q));
    REFUSED(gphys_camera_get_transform(camera, NULL, &q));
    REFUSED(gphys_camera_get_transform(camera, v, NULL));
    REFUSED(gphys_camera_get_world_matrix(NULL, &m));
    REFUSED(gphys_camera_get_world_matrix(camera, NULL));
    REFUSED(gphys_camera_get_view_matrix(NULL, &m));
    REFUSED(gphys_camera_get_view_matrix(camera, NULL));
    REFUSED(gphys_camera_get_projection_matrix(NULL, &m));
    REFUSED(gphys_camera_get_projection_matrix(camera, NULL));
    REFUSED(gphys_camera_get_view_projection_matrix(NULL, &m));
    REFUSED(gphys_camera_get_view_projection_matrix(camera, NULL));
    REFUSED(gphys_camera_get_frustum(NULL, &frustum));
    REFUSED(gphys_camera_get_frustum(camera, NULL));
    REFUSED(gphys_camera_get_corners(NULL, v));
    REFUSED(gphys_camera_get_corners(camera, NULL));
    REFUSED(gphys_camera_pick_ray(NULL, 1, 1, &ray));
    REFUSED(gphys_camera_pick_ray(camera, 1, 1, NULL));
    assert_int_equal(gphys_camera_set_perspective(camera, 1, 0.1f, INFINITY), GPHYS_OK);
    assert_int_equal(gphys_camera_get_corners(camera, v), GPHYS_UNBOUNDED);
    assert_true(untouched(v, sizeof v) && untouched(&q, sizeof q) && untouched(&m, sizeof m));
    assert_true(untouched(&frustum, sizeof frustum) && untouched(&ray, sizeof ray));
}

static void the_frustum_is_a_valid_shape_and_has_the_cameras_corners(void** state) {
    const gphys_vec3 eye = {3, -2, 5}, target = {10, 1, -4}, up = {0, 1, 0};
    gphys_frustum frustum;
    gphys_vec3 corners[8];
    int i, k;
    (void)state;
    assert_int_equal(gphys_camera_look_at(camera, &eye, &target, &up), GPHYS_OK);
    assert_int_equal(gphys_camera_get_frustum(camera, &frustum), GPHYS_OK);
    assert_memory_equal(&frustum.origin, &eye, sizeof eye);
    assert_int_equal(gphys_camera_get_corners(camera, corners), GPHYS_OK);
    for (k = 0; k < 8; ++k) {
        const int on[3] = {k < 4 ? GPHYS_FRUSTUM_NEAR : GPHYS_FRUSTUM_FAR,
                           k % 4 == 0 || k % 4 == 3 ? GPHYS_FRUSTUM_LEFT : GPHYS_FRUSTUM_RIGHT,
                           k % 4 < 2 ? GPHYS_FRUSTUM_BOTTOM : GPHYS_FRUSTUM_TOP};
        for (i = 0; i < 3; ++i) {
            const gphys_plane* plane = &frustum.planes[on[i]];
            const double side = (double)plane->normal.x * ((double)corners[k].x - eye.x) +
                                (double)plane->normal.y * ((double)corners[k].y - eye.y) +
                                (double)plane->normal.z * ((double)corners[k].z - eye.z);
            /* Corner and normal are rounded to 2^-24 of the far distance of 1000 each. */
            assert_true(fabs(side - plane->distance) < 4 * 1500 / 16777216.0);
        }
    }
}

static void projecting_and_unprojecting_check(void** state) {
    const gphys_vec3 point = {0.1f, 0.2f, 5}, behind = {0, 0, -5};
    gphys_vec3 out, many[3];
    int i;
    (void)state;
    memset(&out, 0x5a, sizeof out);
    memset(many, 0x5a, sizeof many);
    REFUSED(gphys_camera_project(NULL, &point, &out));
    REFUSED(gphys_camera_project(camera, NULL, &out));
    REFUSED(gphys_camera_project(camera, &point, NULL));
    REFUSED(gphys_camera_unproject(NULL, &point, &out));
    REFUSED(gphys_camera_unproject(camera, NULL, &out));
    REFUSED(gphys_camera_unproject(camera, &point, NULL));
    for (i = 0; i < BAD_COUNT; ++i) {
        const gphys_vec3 bad = {1, bad_numbers[i], 1};
        const gphys_vec3 mixed[3] = {{0, 0, 5}, {0, 0, bad_numbers[i]}, {0, 0, 5}};
        gphys_ray ray;
        memset(&ray, 0x5a, sizeof ray);
        REFUSED(gphys_camera_project(camera, &bad, &out));
        REFUSED(gphys_camera_unproject(camera, &bad, &out));
        REFUSED(gphys_camera_project_batch(camera, mixed, sizeof *mixed, 3, many, sizeof *many));
        REFUSED(gphys_camera_unproject_batch(camera, mixed, sizeof *mixed, 3, many, sizeof *many));
        REFUSED(gphys_camera_pick_ray(camera, bad_numbers[i], 0, &ray));
        REFUSED(gphys_camera_pick_ray(camera, 0, bad_numbers[i], &ray));
        assert_true(untouched(&ray, sizeof ray));
    }
    assert_int_equal(gphys_camera_project(camera, &behind, &out), GPHYS_NO_HIT);
    REFUSED(gphys_camera_project_batch(NULL, &point, 0, 3, many, sizeof *many));
    REFUSED(gphys_camera_project_batch(camera, NULL, 0, 3, many, sizeof *many));
    REFUSED(gphys_camera_project_batch(camera, &point, 0, 3, NULL, sizeof *many));
    REFUSED(gphys_camera_project_batch(camera, &point, 8, 3, many, sizeof *many));
    REFUSED(gphys_camera_project_batch(camera, &point, 14, 1, many, sizeof *many));
    REFUSED(gphys_camera_project_batch(camera, &point, 0, 3, many, 0));
    REFUSED(gphys_camera_unproject_batch(NULL, &point, 0, 3, many, sizeof *many));
    REFUSED(gphys_camera_unproject_batch(camera, NULL, 0, 3, many, sizeof *many));
    REFUSED(gphys_camera_unproject_batch(camera, &point, 0, 3, NULL, sizeof *many));
    REFUSED(gphys_camera_unproject_batch(camera, &point, 8, 3, many, sizeof *many));
    REFUSED(gphys_camera_unproject_batch(camera, &point, 0, 3, many, 4));
    assert_true(untouched(&out, sizeof out) && untouched(many, sizeof many));
    assert_int_equal(gphys_camera_project_batch(camera, NULL, 0, 0, NULL, 0), GPHYS_OK);
    assert_int_equal(gphys_camera_unproject_batch(camera, NULL, 0, 0, NULL, 0), GPHYS_OK);
}

static void unprojecting_undoes_projecting_in_every_convention(void** state) {
    const gphys_vec3 eye = {100, 200, -300}, target = {90, 190, -280}, up = {0, 0, 1};
    int convention, kind, i;
    (void)state;
    for (convention = 0; convention < 8; ++convention) {
        gphys_camera_desc desc;
        gphys_camera* c = NULL;
        gphys_mat4 matrix;
        assert_int_equal(gphys_camera_desc_init(&desc, sizeof desc), GPHYS_OK);
        desc.handedness = convention & 1;
        desc.depth_range = convention >> 1 & 1;
        desc.reverse_z = convention >> 2;
        assert_int_equal(gphys_camera_create(&desc, &c), GPHYS_OK);
        assert_int_equal(gphys_camera_look_at(c, &eye, &target, &up), GPHYS_OK);
        for (kind = 0; kind < 4; ++kind) {
            if (kind == 0) assert_int_equal(gphys_camera_set_perspective(c, 1, 1, 50), GPHYS_OK);
            if (kind == 1) assert_int_equal(gphys_camera_set_perspective(c, 1, 1, INFINITY), GPHYS_OK);
            if (kind == 2) assert_int_equal(gphys_camera_set_orthographic(c, 30, -10, 50), GPHYS_OK);
            if (kind == 3) {
                assert_int_equal(gphys_camera_set_perspective(c, 1, 1, 50), GPHYS_OK);
                assert_int_equal(gphys_camera_get_projection_matrix(c, &matrix), GPHYS_OK);
                assert_int_equal(gphys_camera_set_projection(c, &matrix), GPHYS_OK);
            }
            for (i = 0; i < 27; ++i) {
                const gphys_vec3 point = {target.x + (float)(i % 3 - 1) * 2, target.y + (float)(i / 3 % 3 - 1) * 3,
                                          target.z + (float)(i / 9 - 1) * 4};
                gphys_vec3 pixel, back, batch[2];
                assert_int_equal(gphys_camera_project(c, &point, &pixel), GPHYS_OK);
                assert_int_equal(gphys_camera_unproject(c, &pixel, &back), GPHYS_OK);
                /* The float depth near 1 is off by 2^-25, which is 30 * 30 / 1 * 2^-25 metres at 30
                 * metres from a near plane at 1, twice that in -1..1; the pixel's rounding is less. */
                assert_true(fabs((double)back.x - point.x) + fabs((double)back.y - point.y) +
                                fabs((double)back.z - point.z) <
                            4e-4);
                assert_int_equal(gphys_camera_project_batch(c, &point, 0, 2, batch, sizeof *batch), GPHYS_OK);
                assert_memory_equal(&batch[1], &pixel, sizeof pixel);
                assert_int_equal(gphys_camera_unproject_batch(c, &pixel, 0, 2, batch, sizeof *batch), GPHYS_OK);
                assert_memory_equal(&batch[1], &back, sizeof back);
            }
        }
        gphys_camera_destroy(c);
    }
}

static void batches_mark_what_has_no_image_and_no_place(void** state) {
    const gphys_vec3 points[3] = {{0, 0, 5}, {0, 0, -5}, {1, 1, 5}};
    const gphys_vec3 pixels[3] = {{400, 300, 0.5f}, {400, 300, 1}, {10, 10, 0}};
    gphys_vec3 out[3];
    (void)state;
    assert_int_equal(gphys_camera_project_batch(camera, points, sizeof *points, 3, out, sizeof *out), GPHYS_OK);
    assert_true(isfinite(out[0].x) && isfinite(out[2].x));
    assert_true(out[1].x == INFINITY && out[1].y == INFINITY && out[1].z == INFINITY);
    assert_int_equal(gphys_camera_set_perspective(camera, 1, 0.1f, INFINITY), GPHYS_OK);
    assert_int_equal(gphys_camera_unproject_batch(camera, pixels, sizeof *pixels, 3, out, sizeof *out), GPHYS_OK);
    assert_true(isfinite(out[0].x) && isfinite(out[2].x));
    assert_true(out[1].x == INFINITY && out[1].y == INFINITY && out[1].z == INFINITY);
    memset(out, 0x5a, sizeof out);
    assert_int_equal(gphys_camera_unproject(camera, &pixels[1], out), GPHYS_UNBOUNDED);
    assert_true(untouched(out, sizeof out));
}

static void pick_rays_are_pick_ray_at_pixel_centres(void** state) {
    gphys_ray rays[4 * 3], one;
    uint32_t row, column;
    int flat;
    (void)state;
    for (flat = 0; flat < 2; ++flat) {
        if (flat) assert_int_equal(gphys_camera_set_orthographic(camera, 10, 0.5f, 70), GPHYS_OK);
        assert_int_equal(gphys_camera_pick_rays(camera, 100, 200, 4, 3, rays, sizeof *rays), GPHYS_OK);
        for (row = 0; row < 3; ++row) {
            for (column = 0; column < 4; ++column) {
                const float x = 100.5f + (float)column, y = 200.5f + (float)row;
                const gphys_ray* ray = &rays[row * 4 + column];
                const double length = (double)ray->direction.x * ray->direction.x +
                                      (double)ray->direction.y * ray->direction.y +
                                      (double)ray->direction.z * ray->direction.z;
                assert_int_equal(gphys_camera_pick_ray(camera, x, y, &one), GPHYS_OK);
                assert_memory_equal(ray, &one, sizeof one);
                assert_true(fabs(length - 1) < 4.0 / 16777216);
                assert_true(flat ? one.origin.z == 0.5f && one.t_max == 69.5f
                                 : one.origin.z == 0.1f && one.t_max >= 999.9f);
            }
        }
    }
    memset(rays, 0x5a, sizeof rays);
    REFUSED(gphys_camera_pick_rays(NULL, 0, 0, 4, 3, rays, sizeof *rays));
    REFUSED(gphys_camera_pick_rays(camera, 0, 0, 4, 3, NULL, sizeof *rays));
    REFUSED(gphys_camera_pick_rays(camera, 0, 0, 4, 3, rays, 0));
    REFUSED(gphys_camera_pick_rays(camera, 0, 0, 4, 3, rays, sizeof *rays + 2));
    REFUSED(gphys_camera_pick_rays(camera, 0, 0, 65536, 65536, rays, sizeof *rays));
    REFUSED(gphys_camera_pick_rays(camera, UINT32_MAX, 0, 2, 1, rays, sizeof *rays));
    assert_int_equal(gphys_camera_pick_rays(camera, 0, 0, 0, 3, NULL, 0), GPHYS_OK);
    assert_true(untouched(rays, sizeof rays));
}

static void a_ray_beyond_the_range_of_float_is_infinite(void** state) {
    gphys_ray ray;
    (void)state;
    assert_int_equal(gphys_camera_set_perspective(camera, 3.1415925f, 1, 1e15f), GPHYS_OK);
    assert_int_equal(gphys_camera_set_viewport(camera, 1e6f, 1e-3f), GPHYS_OK);
    /* On the near plane, such a pixel is beyond all coordinates. */
    assert_int_equal(gphys_camera_pick_ray(camera, 1e15f, 1e15f, &ray), GPHYS_UNBOUNDED);
    assert_int_equal(gphys_camera_set_pick_start(camera, GPHYS_PICK_FROM_CENTRE), GPHYS_OK);
    assert_int_equal(gphys_camera_pick_ray(camera, 1e15f, 1e15f, &ray), GPHYS_OK);
    assert_true(ray.t_max == INFINITY);
    assert_true(isfinite(ray.direction.x) && isfinite(ray.direction.y) && isfinite(ray.direction.z));
}

static void a_line_of_sight_without_a_near_plane_is_unbounded(void** state) {
    gphys_mat4 oblique = {{0}};
    gphys_ray rays[2];
    (void)state;
    /* Depth 0 on the plane x = 1: lines of sight to the left of the middle never reach it. */
    oblique.m[0] = oblique.m[5] = 1;
    oblique.m[2] = 0.5f;
    oblique.m[14] = -0.5f;
    oblique.m[11] = 1;
    assert_int_equal(gphys_camera_set_projection(camera, &oblique), GPHYS_OK);
    memset(rays, 0x5a, sizeof rays);
    assert_int_equal(gphys_camera_pick_ray(camera, 200, 300, rays), GPHYS_UNBOUNDED);
    assert_int_equal(gphys_camera_pick_rays(camera, 399, 300, 2, 1, rays, sizeof *rays), GPHYS_UNBOUNDED);
    assert_true(untouched(rays, sizeof rays));
    assert_int_equal(gphys_camera_pick_ray(camera, 600, 300, rays), GPHYS_OK);
    assert_true(fabsf(rays[0].origin.x - 1) < 1e-6f);
}

static void orbit_checks(void** state) {
    struct snapshot before;
    gphys_orbit orbit, good, out;
    int i, k;
    (void)state;
    REFUSED(gphys_orbit_init(NULL));
    assert_int_equal(gphys_orbit_init(&good), GPHYS_OK);
    assert_true(good.up.y == 1 && good.distance == 10 && good.yaw == 0 && good.pitch == 0);
    assert_true(good.radians_per_unit == 1 && good.metres_per_unit == 1 && good.max_distance == INFINITY);
    assert_true(good.min_distance == 0.01f && fabs(good.max_pitch - 1.5533430) < 1e-6);

    memset(&out, 0x5a, sizeof out);
    assert_int_equal(gphys_camera_get_orbit(camera, &out), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_camera_orbit_rotate(camera, 1, 1), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_camera_orbit_zoom(camera, 1), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_camera_orbit_pan(camera, 1, 1), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_camera_orbit_update(camera), GPHYS_ERROR_UNSUPPORTED);
    REFUSED(gphys_camera_set_orbit(NULL, &good));
    REFUSED(gphys_camera_set_orbit(camera, NULL));
    assert_int_equal(gphys_camera_set_orbit(camera, &good), GPHYS_OK);
    before = take_snapshot();
    REFUSED(gphys_camera_get_orbit(NULL, &out));
    REFUSED(gphys_camera_get_orbit(camera, NULL));
    REFUSED(gphys_camera_orbit_rotate(NULL, 1, 1));
    REFUSED(gphys_camera_orbit_zoom(NULL, 1));
    REFUSED(gphys_camera_orbit_pan(NULL, 1, 1));
    REFUSED(gphys_camera_orbit_update(NULL));
    assert_true(untouched(&out, sizeof out));

    for (i = 0; i < BAD_COUNT; ++i) {
        const float bad = bad_numbers[i];
        for (k = 0; k < (int)(sizeof orbit / sizeof(float)); ++k) {
            orbit = good;
            memcpy((char*)&orbit + sizeof(float) * (size_t)k, &bad, sizeof bad);
            if (orbit.max_distance > 2e14f && good.max_distance != orbit.max_distance && bad == 2e15f) continue;
            if (orbit.max_distance == INFINITY && memcmp(&orbit, &good, sizeof orbit) == 0) continue;
            REFUSED(gphys_camera_set_orbit(camera, &orbit));
        }
        if (isinf(bad) || isnan(bad)) {
            REFUSED(gphys_camera_orbit_rotate(camera, bad, 0));
            REFUSED(gphys_camera_orbit_rotate(camera, 0, bad));
            REFUSED(gphys_camera_orbit_zoom(camera, bad));
            REFUSED(gphys_camera_orbit_pan(camera, bad, 0));
            REFUSED(gphys_camera_orbit_pan(camera, 0, bad));
        }
    }
    orbit = good;
    orbit.up.y = 0;
    REFUSED(gphys_camera_set_orbit(camera, &orbit));
    orbit = good;
    orbit.distance = 0;
    REFUSED(gphys_camera_set_orbit(camera, &orbit));
    orbit = good;
    orbit.min_distance = 0;
    REFUSED(gphys_camera_set_orbit(camera, &orbit));
    orbit = good;
    orbit.max_distance = 0.001f;
    REFUSED(gphys_camera_set_orbit(camera, &orbit));
    orbit = good;
    orbit.max_pitch = 1.6f;
    REFUSED(gphys_camera_set_orbit(camera, &orbit));
    orbit = good;
    orbit.min_pitch = 1;
    orbit.max_pitch = 0.5f;
    REFUSED(gphys_camera_set_orbit(camera, &orbit));
    /* Nothing of what was refused is pending. */
    assert_int_equal(gphys_camera_orbit_update(camera), GPHYS_OK);
    assert_unchanged(&before);
    assert_int_equal(gphys_camera_get_orbit(camera, &out), GPHYS_OK);
    assert_memory_equal(&out, &good, sizeof out);
}

static void orbiting_takes_effect_at_the_update(void** state) {
    struct snapshot before;
    gphys_orbit orbit;
    gphys_vec3 position;
    gphys_quat rotation;
    (void)state;
    assert_int_equal(gphys_orbit_init(&orbit), GPHYS_OK);
    orbit.radians_per_unit = 0.1f;
    orbit.metres_per_unit = 0.5f;
    assert_int_equal(gphys_camera_set_orbit(camera, &orbit), GPHYS_OK);
    before = take_snapshot();
    assert_int_equal(gphys_camera_orbit_rotate(camera, 2, 3), GPHYS_OK);
    assert_int_equal(gphys_camera_orbit_zoom(camera, 4), GPHYS_OK);
    assert_int_equal(gphys_camera_orbit_pan(camera, 1, 2), GPHYS_OK);
    assert_unchanged(&before);
    assert_int_equal(gphys_camera_orbit_update(camera), GPHYS_OK);
    assert_int_equal(gphys_camera_get_orbit(camera, &orbit), GPHYS_OK);
    assert_true(fabs(orbit.yaw - 0.2) < 1e-6 && fabs(orbit.pitch - 0.3) < 1e-6);
    assert_true(orbit.distance == 8 && orbit.target.x == 0.5f && orbit.target.y == 1 && orbit.target.z == 0);
    assert_int_equal(gphys_camera_get_transform(camera, &position, &rotation), GPHYS_OK);
    assert_true(fabs(position.y - (1 + 8 * sin(0.3))) < 1e-5);
    /* The wheel spun ten thousand million times: the book's loop never came back. */
    assert_int_equal(gphys_camera_orbit_rotate(camera, 1e11f, 0), GPHYS_OK);
    assert_int_equal(gphys_camera_orbit_update(camera), GPHYS_OK);
    assert_int_equal(gphys_camera_get_orbit(camera, &orbit), GPHYS_OK);
    assert_true(fabs(orbit.yaw) <= 3.1415928);
    /* Straight down. */
    orbit.max_pitch = 1.5707964f;
    orbit.pitch = orbit.max_pitch;
    assert_int_equal(gphys_camera_set_orbit(camera, &orbit), GPHYS_OK);
    assert_int_equal(gphys_camera_get_transform(camera, &position, &rotation), GPHYS_OK);
    assert_true(isfinite(rotation.x) && isfinite(rotation.y) && isfinite(rotation.z) && isfinite(rotation.w));
    assert_true(fabs(position.y - 9) < 1e-6);
}

static void transform_and_world_matrix_describe_the_same_place(void** state) {
    const gphys_vec3 eye = {1e7f, -2e6f, 5}, target = {1e7f, -2e6f, -7}, up = {1, 2, 0};
    struct snapshot before;
    gphys_vec3 position;
    gphys_quat rotation;
    gphys_mat4 world;
    int handedness, k;
    (void)state;
    for (handedness = 0; handedness < 2; ++handedness) {
        gphys_camera_desc desc;
        assert_int_equal(gphys_camera_desc_init(&desc, sizeof desc), GPHYS_OK);
        desc.handedness = handedness;
        gphys_camera_destroy(camera);
        assert_int_equal(gphys_camera_create(&desc, &camera), GPHYS_OK);
        assert_int_equal(gphys_camera_look_at(camera, &eye, &target, &up), GPHYS_OK);
        assert_int_equal(gphys_camera_get_world_matrix(camera, &world), GPHYS_OK);
        assert_int_equal(gphys_camera_get_transform(camera, &position, &rotation), GPHYS_OK);
        assert_memory_equal(&position, &eye, sizeof eye);
        assert_true(world.m[10] == (handedness == GPHYS_LEFT_HANDED ? -1 : 1));
        assert_int_equal(gphys_camera_set_transform(camera, &position, &rotation), GPHYS_OK);
        assert_int_equal(gphys_camera_get_world_matrix(camera, &before.world), GPHYS_OK);
        /* The quaternion was rounded to float. */
        for (k = 0; k < 12; ++k) assert_true(fabs((double)world.m[k] - before.world.m[k]) < 4e-7);
        assert_int_equal(gphys_camera_set_world_matrix(camera, &world), GPHYS_OK);
        assert_int_equal(gphys_camera_get_world_matrix(camera, &before.world), GPHYS_OK);
        for (k = 0; k < 12; ++k) assert_true(fabs((double)world.m[k] - before.world.m[k]) < 2e-7);
    }
}

static void the_projection_can_be_read_back(void** state) {
    gphys_projection kind = 7;
    gphys_mat4 matrix;
    float size = 7, near_distance = 7, far_distance = 7, width = 7, height = 7;
    (void)state;
    assert_int_equal(gphys_camera_get_projection(camera, &kind, &size, &near_distance, &far_distance), GPHYS_OK);
    assert_true(kind == GPHYS_PROJECTION_PERSPECTIVE && near_distance == 0.1f && far_distance == 1000);
    assert_true(size == 1.04719755f); /* 60 degrees */
    assert_int_equal(gphys_camera_set_perspective(camera, 0.7f, 0.3f, INFINITY), GPHYS_OK);
    assert_int_equal(gphys_camera_set_viewport(camera, 123.5f, 77), GPHYS_OK);
    assert_int_equal(gphys_camera_get_projection(camera, &kind, &size, &near_distance, &far_distance), GPHYS_OK);
    assert_true(kind == GPHYS_PROJECTION_PERSPECTIVE && size == 0.7f && near_distance == 0.3f && isinf(far_distance));
    assert_int_equal(gphys_camera_get_viewport(camera, &width, &height), GPHYS_OK);
    assert_true(width == 123.5f && height == 77);
    assert_int_equal(gphys_camera_set_orthographic(camera, 0.1f, -2.5f, 8), GPHYS_OK);
    assert_int_equal(gphys_camera_get_projection(camera, &kind, &size, &near_distance, &far_distance), GPHYS_OK);
    assert_true(kind == GPHYS_PROJECTION_ORTHOGRAPHIC && size == 0.1f && near_distance == -2.5f && far_distance == 8);
    assert_int_equal(gphys_camera_get_projection_matrix(camera, &matrix), GPHYS_OK);
    assert_int_equal(gphys_camera_set_projection(camera, &matrix), GPHYS_OK);
    assert_int_equal(gphys_camera_get_projection(camera, &kind, &size, &near_distance, &far_distance), GPHYS_OK);
    assert_true(kind == GPHYS_PROJECTION_USER && size == 0 && near_distance == 0 && far_distance == 0);
    REFUSED(gphys_camera_get_projection(NULL, &kind, &size, &near_distance, &far_distance));
    REFUSED(gphys_camera_get_projection(camera, NULL, &size, &near_distance, &far_distance));
    REFUSED(gphys_camera_get_projection(camera, &kind, NULL, &near_distance, &far_distance));
    REFUSED(gphys_camera_get_projection(camera, &kind, &size, NULL, &far_distance));
    REFUSED(gphys_camera_get_projection(camera, &kind, &size, &near_distance, NULL));
    REFUSED(gphys_camera_get_viewport(NULL, &width, &height));
    REFUSED(gphys_camera_get_viewport(camera, NULL, &height));
    REFUSED(gphys_camera_get_viewport(camera, &width, NULL));
}

static void an_origin_is_checked_kept_and_returned(void** state) {
    const double origin[3] = {1e9, -2e9, 0.125}, bad[3] = {0, 0, 2e15};
    double now[3] = {7, 7, 7};
    gphys_camera* camera = NULL;
    (void)state;
    assert_int_equal(gphys_camera_create(NULL, &camera), GPHYS_OK);
    assert_int_equal(gphys_camera_set_origin(NULL, origin), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_camera_set_origin(camera, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_camera_set_origin(camera, bad), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_camera_get_origin(NULL, now), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_camera_get_origin(camera, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_camera_get_origin(camera, now), GPHYS_OK);
    assert_true(now[0] == 0 && now[1] == 0 && now[2] == 0);
    assert_int_equal(gphys_camera_set_origin(camera, origin), GPHYS_OK);
    assert_int_equal(gphys_camera_get_origin(camera, now), GPHYS_OK);
    assert_memory_equal(now, origin, sizeof now);
    gphys_camera_destroy(camera);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_origin_is_checked_kept_and_returned),
        cmocka_unit_test(desc_has_the_documented_defaults),
        cmocka_unit_test(create_checks_its_desc),
        cmocka_unit_test(the_callers_allocator_is_used_and_may_fail),
        cmocka_unit_test_setup_teardown(projection_setters_check, set_up, tear_down),
        cmocka_unit_test_setup_teardown(the_projection_can_be_read_back, set_up, tear_down),
        cmocka_unit_test_setup_teardown(placement_checks, set_up, tear_down),
        cmocka_unit_test_setup_teardown(getters_check_and_leave_outputs_alone, set_up, tear_down),
        cmocka_unit_test_setup_teardown(the_frustum_is_a_valid_shape_and_has_the_cameras_corners, set_up, tear_down),
        cmocka_unit_test_setup_teardown(projecting_and_unprojecting_check, set_up, tear_down),
        cmocka_unit_test(unprojecting_undoes_projecting_in_every_convention),
        cmocka_unit_test_setup_teardown(batches_mark_what_has_no_image_and_no_place, set_up, tear_down),
        cmocka_unit_test_setup_teardown(pick_rays_are_pick_ray_at_pixel_centres, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_ray_beyond_the_range_of_float_is_infinite, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_line_of_sight_without_a_near_plane_is_unbounded, set_up, tear_down),
        cmocka_unit_test_setup_teardown(orbit_checks, set_up, tear_down),
        cmocka_unit_test_setup_teardown(orbiting_takes_effect_at_the_update, set_up, tear_down),
        cmocka_unit_test_setup_teardown(transform_and_world_matrix_describe_the_same_place, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

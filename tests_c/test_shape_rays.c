/* gphys_shape_raycast, _raycast_batch, _segment_test and _sweep_sphere: what they answer for every
 * kind of shape, bad input of every kind, outputs untouched by errors, batches equal to singles. */
#include "test.h"

typedef struct target {
    gphys_shape_type type;
    const void* shape;
} target;

#define TARGETS 8

/* All begin at z = 2 when met along +z from the origin. */
static const gphys_sphere sphere = {{0, 0, 3}, 1};
static const gphys_capsule capsule = {{-1, 0, 2.5f}, {1, 0, 2.5f}, 0.5f};
static const gphys_aabb aabb = {{-1, -1, 2}, {1, 1, 4}};
static const gphys_obb obb = {{0, 0, 3}, {2, 2, 1}, {0, 0, 0.6f, 0.8f}};
static const gphys_plane plane = {{0, 0, -2}, -4};
static const gphys_triangle triangle = {{-1, -1, 2}, {-1, 3, 2}, {3, -1, 2}};
static const gphys_frustum frustum = {
    {0, 0, 1}, {{{0, 0, 1}, 1}, {{0, 0, -1}, -3}, {{1, 0, 1}, 0}, {{-1, 0, 1}, 0}, {{0, 1, 1}, 0}, {{0, -1, 1}, 0}}};
static gphys_mesh* mesh;

static target targets[TARGETS] = {{GPHYS_SHAPE_SPHERE, &sphere},   {GPHYS_SHAPE_CAPSULE, &capsule},
                                  {GPHYS_SHAPE_AABB, &aabb},       {GPHYS_SHAPE_OBB, &obb},
                                  {GPHYS_SHAPE_PLANE, &plane},     {GPHYS_SHAPE_TRIANGLE, &triangle},
                                  {GPHYS_SHAPE_FRUSTUM, &frustum}, {GPHYS_SHAPE_MESH, NULL}};

static int make_mesh(void** state) {
    const float vertices[] = {-1, -1, 2, -1, 3, 2, 3, -1, 2, -1, -1, 9, -1, 3, 9, 3, -1, 9};
    const uint32_t indices[] = {3, 4, 5, 0, 1, 2};
    (void)state;
    if (gphys_mesh_create(NULL, vertices, 12, 6, indices, 6, &mesh) != GPHYS_OK) return -1;
    targets[TARGETS - 1].shape = mesh;
    return 0;
}

static int destroy_mesh(void** state) {
    (void)state;
    gphys_mesh_destroy(mesh);
    return 0;
}

static const gphys_ray ray = {{0, 0, 0}, {0, 0, 0.5f}, INFINITY};
static const gphys_segment segment = {{0, 0, 0}, {0, 0, 4}};
static const gphys_sphere moving = {{0, 0, 0}, 1};
static const gphys_vec3 displacement = {0, 0, 4};

static int is_surface(gphys_shape_type type) {
    return type == GPHYS_SHAPE_PLANE || type == GPHYS_SHAPE_TRIANGLE || type == GPHYS_SHAPE_MESH;
}

static void assert_point(gphys_vec3 p, float x, float y, float z) { assert_true(p.x == x && p.y == y && p.z == z); }

static void a_ray_hits_every_shape(void** state) {
    (void)state;
    for (int i = 0; i < TARGETS; ++i) {
        const int is_mesh = targets[i].type == GPHYS_SHAPE_MESH;
        gphys_hit hit;
        assert_int_equal(gphys_shape_raycast(targets[i].type, targets[i].shape, &ray, &hit), GPHYS_OK);
        assert_true(hit.t == 4);
        assert_point(hit.point, 0, 0, 2);
        assert_point(hit.normal, 0, 0, -1);
        assert_int_equal(hit.flags, 0);
        assert_int_equal(hit.model, 0);
        assert_int_equal(hit.tag, 0);
        assert_true(hit.triangle == (is_mesh ? 1 : GPHYS_NO_TRIANGLE));
        assert_true(hit.u == (is_mesh || targets[i].type == GPHYS_SHAPE_TRIANGLE ? 0.25f : 0));

        gphys_ray shorter = ray;
        shorter.t_max = 4; /* reaches */
        assert_int_equal(gphys_shape_raycast(targets[i].type, targets[i].shape, &shorter, &hit), GPHYS_OK);
        shorter.t_max = 3.9999998f;
        assert_int_equal(gphys_shape_raycast(targets[i].type, targets[i].shape, &shorter, &hit), GPHYS_NO_HIT);
    }
}

static void a_ray_from_behind_or_inside_says_so(void** state) {
    (void)state;
    for (int i = 0; i < TARGETS; ++i) {
        const gphys_ray back = {{0, 0, 2.5f}, {0, 0, -1}, INFINITY};
        gphys_hit hit;
        assert_int_equal(gphys_shape_raycast(targets[i].type, targets[i].shape, &back, &hit), GPHYS_OK);
        assert_point(hit.normal, 0, 0, 1);
        assert_int_equal(hit.flags, is_surface(targets[i].type) ? GPHYS_HIT_BACK : GPHYS_HIT_INSIDE);
        assert_true(hit.t == (is_surface(targets[i].type) ? 0.5f : 0));
    }
}

static void a_segment_contains_both_its_ends(void** state) {
    (void)state;
    for (int i = 0; i < TARGETS; ++i) {
        const gphys_segment to = {{0, 0, 0}, {0, 0, 2}}, from = {{0, 0, 2}, {0, 0, 0}}, point = {{0, 0, 2}, {0, 0, 2}};
        const gphys_segment before = {{0, 0, 0}, {0, 0, 1.9999999f}}, nothing = {{0, 0, 1}, {0, 0, 1}};
        gphys_hit hit;
        assert_int_equal(gphys_shape_segment_test(targets[i].type, targets[i].shape, &segment, &hit), GPHYS_OK);
        assert_true(hit.t == 0.5f);
        assert_int_equal(gphys_shape_segment_test(targets[i].type, targets[i].shape, &to, &hit), GPHYS_OK);
        assert_true(hit.t == 1);
        assert_int_equal(gphys_shape_segment_test(targets[i].type, targets[i].shape, &from, &hit), GPHYS_OK);
        assert_true(hit.t == 0);
        assert_int_equal(gphys_shape_segment_test(targets[i].type, targets[i].shape, &point, &hit), GPHYS_OK);
        assert_true(hit.t == 0);
        assert_int_equal(gphys_shape_segment_test(targets[i].type, targets[i].shape, &before, &hit), GPHYS_NO_HIT);
        assert_int_equal(gphys_shape_segment_test(targets[i].type, targets[i].shape, &nothing, &hit), GPHYS_NO_HIT);
    }
}

static void a_sphere_touches_every_shape(void** state) {
    (void)state;
    for (int i = 0; i < TARGETS; ++i) {
        const gphys_vec3 reaching = {0, 0, 1}, still = {0, 0, 0};
        const gphys_sphere touching = {{0, 0, 1}, 1};
        gphys_hit hit;
        assert_int_equal(gphys_shape_sweep_sphere(targets[i].type, targets[i].shape, &moving, &displacement, &hit),
                         GPHYS_OK);
        assert_true(hit.t == 0.25f);
        assert_point(hit.point, 0, 0, 2);
        assert_point(hit.normal, 0, 0, -1);
        assert_int_equal(hit.flags, 0);
        assert_int_equal(gphys_shape_sweep_sphere(targets[i].type, targets[i].shape, &moving, &reaching, &hit),
                         GPHYS_OK);
        assert_true(hit.t == 1);
        assert_int_equal(gphys_shape_sweep_sphere(targets[i].type, targets[i].shape, &moving, &still, &hit),
                         GPHYS_NO_HIT);
        assert_int_equal(gphys_shape_sweep_sphere(targets[i].type, targets[i].shape, &touching, &still, &hit),
                         GPHYS_OK);
        assert_true(hit.t == 0);
        assert_int_equal(hit.flags, GPHYS_HIT_INSIDE);
        assert_point(hit.normal, 0, 0, -1);
    }
}

static void a_batch_equals_single_calls(void** state) {
    enum { count = 64 };
    struct {
        gphys_ray ray;
        float other;
    } rays[count];
    struct {
        gphys_hit hit;
        uint32_t other;
    } hits[count];
    (void)state;
    for (int i = 0; i < TARGETS; ++i) {
        for (int k = 0; k < count; ++k) {
            const gphys_ray each = {
                {0.3f * (k % 8) - 1, 0.3f * (k / 8) - 1, -1}, {0.1f * k - 3, 0.2f, 3}, 0.5f + 0.03f * k};
            rays[k].ray = each;
            rays[k].other = NAN;
            hits[k].other = 7;
        }
        assert_int_equal(gphys_shape_raycast_batch(targets[i].type, targets[i].shape, &rays[0].ray, sizeof rays[0],
                                                   count, &hits[0].hit, sizeof hits[0]),
                         GPHYS_OK);
        int found = 0;
        for (int k = 0; k < count; ++k) {
            gphys_hit single;
            memset(&single, 0, sizeof single);
            single.t = INFINITY;
            single.triangle = GPHYS_NO_TRIANGLE;
            found += gphys_shape_raycast(targets[i].type, targets[i].shape, &rays[k].ray, &single) == GPHYS_OK;
            assert_memory_equal(&single, &hits[k].hit, sizeof single);
            assert_int_equal(hits[k].other, 7);
        }
        assert_true(found > 0 && found < count);

        /* One ray for all. */
        assert_int_equal(
            gphys_shape_raycast_batch(targets[i].type, targets[i].shape, &ray, 0, 2, &hits[0].hit, sizeof hits[0]),
            GPHYS_OK);
        assert_memory_equal(&hits[0].hit, &hits[1].hit, sizeof(gphys_hit));
        assert_int_equal(gphys_shape_raycast_batch(targets[i].type, targets[i].shape, NULL, sizeof(gphys_ray), 0, NULL,
                                                   sizeof(gphys_hit)),
                         GPHYS_OK);
    }
}

/* All four functions must give this status for the shape and leave their output alone. */
static void assert_all(gphys_status expected, gphys_shape_type type, const void* shape) {
    gphys_hit hits[2], before[2];
    memset(hits, 0x5a, sizeof hits);
    memcpy(before, hits, sizeof hits);
    assert_int_equal(gphys_shape_raycast(type, shape, &ray, hits), expected);
    assert_int_equal(gphys_shape_raycast_batch(type, shape, &ray, 0, 2, hits, sizeof(gphys_hit)), expected);
    assert_int_equal(gphys_shape_segment_test(type, shape, &segment, hits), expected);
    assert_int_equal(gphys_shape_sweep_sphere(type, shape, &moving, &displacement, hits), expected);
    assert_memory_equal(hits, before, sizeof hits);
    assert_true(strlen(gphys_last_error()) > 0);
}

static void bad_shapes_are_refused(void** state) {
    gphys_sphere broken = sphere;
    (void)state;
    for (int i = 0; i < TARGETS; ++i) assert_all(GPHYS_ERROR_INVALID_ARGUMENT, targets[i].type, NULL);
    assert_all(GPHYS_ERROR_INVALID_ARGUMENT, 0, &sphere);
    assert_all(GPHYS_ERROR_INVALID_ARGUMENT, 99, &sphere);
    assert_all(GPHYS_ERROR_UNSUPPORTED, GPHYS_SHAPE_RAY, &ray);
    assert_all(GPHYS_ERROR_UNSUPPORTED, GPHYS_SHAPE_SEGMENT, &segment);
    broken.radius = -1;
    assert_all(GPHYS_ERROR_INVALID_ARGUMENT, GPHYS_SHAPE_SPHERE, &broken);
}

static void every_float_of_the_question_is_checked(void** state) {
    const float bad[] = {NAN, -INFINITY, INFINITY, 1.1e15f};
    gphys_hit hits[2], before[2];
    (void)state;
    memset(hits, 0x5a, sizeof hits);
    memcpy(before, hits, sizeof hits);
    for (int b = 0; b < 4; ++b) {
        for (int k = 0; k < 7; ++k) {
            gphys_ray rays[2];
            rays[0] = rays[1] = ray;
            if (k == 6 && b >= 2) continue; /* t_max may be large or infinite */
            ((float*)&rays[1])[k] = bad[b];
            assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_AABB, &aabb, &rays[1], hits),
                             GPHYS_ERROR_INVALID_ARGUMENT);
            assert_int_equal(
                gphys_shape_raycast_batch(GPHYS_SHAPE_AABB, &aabb, rays, sizeof(gphys_ray), 2, hits, sizeof(gphys_hit)),
                GPHYS_ERROR_INVALID_ARGUMENT);
        }
        for (int k = 0; k < 6; ++k) {
            gphys_segment s = segment;
            ((float*)&s)[k] = bad[b];
            assert_int_equal(gphys_shape_segment_test(GPHYS_SHAPE_AABB, &aabb, &s, hits), GPHYS_ERROR_INVALID_ARGUMENT);
        }
        for (int k = 0; k < 4; ++k) {
            gphys_sphere s = moving;
            gphys_vec3 d = displacement;
            ((float*)&s)[k] = bad[b];
            assert_int_equal(gphys_shape_sweep_sphere(GPHYS_SHAPE_AABB, &aabb, &s, &d, hits),
                             GPHYS_ERROR_INVALID_ARGUMENT);
            if (k == 3) continue;
            ((float*)&d)[k] = bad[b];
            assert_int_equal(gphys_shape_sweep_sphere(GPHYS_SHAPE_AABB, &aabb, &moving, &d, hits),
                             GPHYS_ERROR_INVALID_ARGUMENT);
        }
    }
    const gphys_ray still = {{0, 0, 0}, {0, 0, 0}, 1}, backwards = {{0, 0, 0}, {0, 0, 1}, -1};
    const gphys_sphere negative = {{0, 0, 0}, -1};
    assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_AABB, &aabb, &still, hits), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_AABB, &aabb, &backwards, hits), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_sweep_sphere(GPHYS_SHAPE_AABB, &aabb, &negative, &displacement, hits),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_memory_equal(hits, before, sizeof hits);
}

static void nulls_and_strides_are_refused(void** state) {
    gphys_hit hits[2];
    const uint32_t element = sizeof(gphys_hit);
    (void)state;
    for (int i = 0; i < TARGETS; ++i) {
        const gphys_shape_type type = targets[i].type;
        const void* shape = targets[i].shape;
        assert_int_equal(gphys_shape_raycast(type, shape, NULL, hits), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_raycast(type, shape, &ray, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_segment_test(type, shape, NULL, hits), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_segment_test(type, shape, &segment, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_sweep_sphere(type, shape, NULL, &displacement, hits),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_sweep_sphere(type, shape, &moving, NULL, hits), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_sweep_sphere(type, shape, &moving, &displacement, NULL),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_raycast_batch(type, shape, NULL, 0, 2, hits, element),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_raycast_batch(type, shape, &ray, 0, 2, NULL, element),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_raycast_batch(type, shape, &ray, 24, 1, hits, element),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_raycast_batch(type, shape, &ray, 30, 1, hits, element),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_raycast_batch(type, shape, &ray, 0, 1, hits, 0), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_raycast_batch(type, shape, &ray, 0, 1, hits, element - 4),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_raycast_batch(type, shape, &ray, 0, 1, hits, element + 2),
                         GPHYS_ERROR_INVALID_ARGUMENT);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ray_hits_every_shape),
        cmocka_unit_test(a_ray_from_behind_or_inside_says_so),
        cmocka_unit_test(a_segment_contains_both_its_ends),
        cmocka_unit_test(a_sphere_touches_every_shape),
        cmocka_unit_test(a_batch_equals_single_calls),
        cmocka_unit_test(bad_shapes_are_refused),
        cmocka_unit_test(every_float_of_the_question_is_checked),
        cmocka_unit_test(nulls_and_strides_are_refused),
    };
    return cmocka_run_group_tests(tests, make_mesh, destroy_mesh);
}

/* Every gphys_shape_* function but the rays: bad input of every kind, outputs untouched by errors,
 * batches equal to single calls, and simple cases of each answer. */
#include "test.h"

#define TYPES 9 /* all but the mesh */

static const gphys_shape_type types[TYPES] = {GPHYS_SHAPE_SPHERE,  GPHYS_SHAPE_CAPSULE, GPHYS_SHAPE_AABB,
                                              GPHYS_SHAPE_OBB,     GPHYS_SHAPE_PLANE,   GPHYS_SHAPE_TRIANGLE,
                                              GPHYS_SHAPE_FRUSTUM, GPHYS_SHAPE_RAY,     GPHYS_SHAPE_SEGMENT};
static const uint32_t sizes[TYPES] = {sizeof(gphys_sphere),  sizeof(gphys_capsule), sizeof(gphys_aabb),
                                      sizeof(gphys_obb),     sizeof(gphys_plane),   sizeof(gphys_triangle),
                                      sizeof(gphys_frustum), sizeof(gphys_ray),     sizeof(gphys_segment)};

typedef union any_shape {
    gphys_sphere sphere;
    gphys_capsule capsule;
    gphys_aabb aabb;
    gphys_obb obb;
    gphys_plane plane;
    gphys_triangle triangle;
    gphys_frustum frustum;
    gphys_ray ray;
    gphys_segment segment;
    float floats[sizeof(gphys_frustum) / sizeof(float)];
} any_shape;

/* A good shape of each type, all of them around (1, 1, 1). */
static any_shape good(gphys_shape_type type) {
    any_shape s;
    memset(&s, 0, sizeof s);
    switch (type) {
        case GPHYS_SHAPE_SPHERE:
            s.sphere = (gphys_sphere){{1, 1, 1}, 1};
            break;
        case GPHYS_SHAPE_CAPSULE:
            s.capsule = (gphys_capsule){{1, 1, 0}, {1, 1, 2}, 0.5f};
            break;
        case GPHYS_SHAPE_AABB:
            s.aabb = (gphys_aabb){{0, 0, 0}, {2, 2, 2}};
            break;
        case GPHYS_SHAPE_OBB:
            s.obb = (gphys_obb){{1, 1, 1}, {1, 1, 1}, {0.6f, 0, 0, 0.8f}};
            break;
        case GPHYS_SHAPE_PLANE:
            s.plane = (gphys_plane){{0, 2, 0}, 2};
            break;
        case GPHYS_SHAPE_TRIANGLE:
            s.triangle = (gphys_triangle){{0, 0, 1}, {3, 0, 1}, {0, 3, 1}};
            break;
        case GPHYS_SHAPE_FRUSTUM:
            s.frustum = (gphys_frustum){{1, 1, 0},
                                        {{{0, 0, 1}, 0.5f},
                                         {{0, 0, -1}, -4},
                                         {{1, 0, 1}, 0},
                                         {{-1, 0, 1}, 0},
                                         {{0, 1, 1}, 0},
                                         {{0, -1, 1}, 0}}};
            break;
        case GPHYS_SHAPE_RAY:
            s.ray = (gphys_ray){{1, 1, 0}, {0, 0, 2}, 5};
            break;
        default:
            s.segment = (gphys_segment){{1, 1, 0}, {1, 1, 2}};
            break;
    }
    return s;
}

static const gphys_vec3 middle = {1, 1, 1};
static const gphys_vec3 nan_point = {1, NAN, 1};

static int is_primitive(gphys_shape_type type) { return type < GPHYS_SHAPE_RAY; }

static void every_float_of_every_shape_is_checked(void** state) {
    (void)state;
    const float bad[] = {NAN, INFINITY, -INFINITY, 1.1e15f, -1.1e15f};
    for (int t = 0; t < TYPES; ++t) {
        any_shape s = good(types[t]);
        assert_int_equal(gphys_shape_validate(types[t], &s), GPHYS_OK);
        for (uint32_t k = 0; k < sizes[t] / 4; ++k) {
            for (int b = 0; b < 5; ++b) {
                /* A ray may be as long as it likes. */
                if (types[t] == GPHYS_SHAPE_RAY && k == 6 && bad[b] > 0) continue;
                s = good(types[t]);
                s.floats[k] = bad[b];
                assert_int_equal(gphys_shape_validate(types[t], &s), GPHYS_ERROR_INVALID_ARGUMENT);
                int32_t answer = 77;
                assert_int_equal(gphys_shape_contains(types[t], &s, &middle, 0, &answer), GPHYS_ERROR_INVALID_ARGUMENT);
                assert_int_equal(answer, 77);
            }
        }
    }
}

static void defects_are_named(void** state) {
    (void)state;
    struct {
        gphys_shape_type type;
        uint32_t field; /* number of the float */
        float value;
        const char* word;
    } cases[] = {
        {GPHYS_SHAPE_SPHERE, 1, NAN, "sphere.center"},
        {GPHYS_SHAPE_SPHERE, 3, -1, "sphere.radius"},
        {GPHYS_SHAPE_CAPSULE, 4, NAN, "capsule.b"},
        {GPHYS_SHAPE_CAPSULE, 6, -1e-30f, "capsule.radius"},
        {GPHYS_SHAPE_AABB, 0, 3, "aabb.min"},
        {GPHYS_SHAPE_OBB, 4, -1, "obb.half_extents"},
        {GPHYS_SHAPE_OBB, 9, 0.81f, "obb.rotation"},
        {GPHYS_SHAPE_PLANE, 1, 0, "plane.normal"},
        {GPHYS_SHAPE_PLANE, 1, 1e-20f, "plane.distance"},
        {GPHYS_SHAPE_TRIANGLE, 8, INFINITY, "triangle.c"},
        {GPHYS_SHAPE_FRUSTUM, 5, 0, "frustum.planes"},
        {GPHYS_SHAPE_RAY, 5, 0, "ray.direction"},
        {GPHYS_SHAPE_RAY, 6, -1, "ray.t_max"},
        {GPHYS_SHAPE_SEGMENT, 5, NAN, "segment.b"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        any_shape s = good(cases[i].type);
        s.floats[cases[i].field] = cases[i].value;
        assert_int_equal(gphys_shape_validate(cases[i].type, &s), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_non_null(strstr(gphys_last_error(), cases[i].word));
    }
    /* The other case of a zero normal: only the far plane, and only with distance -1. */
    any_shape s = good(GPHYS_SHAPE_FRUSTUM);
    s.frustum.planes[GPHYS_FRUSTUM_FAR] = (gphys_plane){{0, 0, 0}, -1};
    assert_int_equal(gphys_shape_validate(GPHYS_SHAPE_FRUSTUM, &s), GPHYS_OK);
    s.frustum.planes[GPHYS_FRUSTUM_FAR].distance = 1;
    assert_int_equal(gphys_shape_validate(GPHYS_SHAPE_FRUSTUM, &s), GPHYS_ERROR_INVALID_ARGUMENT);
}

static void degenerate_but_allowed(void** state) {
    (void)state;
    const gphys_sphere point = {{1, 1, 1}, 0};
    const gphys_capsule sphere = {{1, 1, 1}, {1, 1, 1}, 1};
    const gphys_aabb flat = {{0, 0, 1}, {2, 2, 1}};
    const gphys_triangle dot = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    int32_t answer = 0;
    assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_SPHERE, &point, &middle, 0, &answer), GPHYS_OK);
    assert_int_equal(answer, 1);
    assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_CAPSULE, &sphere, &middle, 0, &answer), GPHYS_OK);
    assert_int_equal(answer, 1);
    assert_int_equal(gphys_shape_overlaps(GPHYS_SHAPE_AABB, &flat, GPHYS_SHAPE_TRIANGLE, &dot, &answer), GPHYS_OK);
    assert_int_equal(answer, 1);
}

static void unknown_types_and_null_are_refused(void** state) {
    (void)state;
    const gphys_shape_type bad_types[] = {0, -1, 9, 15, 18, 1000};
    const any_shape s = good(GPHYS_SHAPE_SPHERE);
    const gphys_plane plane = good(GPHYS_SHAPE_PLANE).plane;
    const gphys_frustum frustum = good(GPHYS_SHAPE_FRUSTUM).frustum;
    const gphys_transform identity = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_aabb box;
    gphys_nearest nearest;
    gphys_side side;
    any_shape out;
    int32_t answer;
    for (size_t i = 0; i < 2 + sizeof bad_types / sizeof *bad_types; ++i) {
        /* the first rounds: null for the shape, of a known type */
        const int null = i < 2;
        const gphys_shape_type type = i == 0 ? GPHYS_SHAPE_SPHERE : i == 1 ? GPHYS_SHAPE_MESH : bad_types[i - 2];
        const void* shape = null ? NULL : &s;
        assert_int_equal(gphys_shape_validate(type, shape), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_bounds(type, shape, &box), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_transform(type, shape, &identity, &out), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_contains(type, shape, &middle, 0, &answer), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_closest_point(type, shape, &middle, &nearest), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_overlaps(type, shape, GPHYS_SHAPE_SPHERE, &s, &answer),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_overlaps(GPHYS_SHAPE_SPHERE, &s, type, shape, &answer),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        if (type == GPHYS_SHAPE_MESH) continue;
        assert_int_equal(gphys_shape_classify_plane(type, shape, &plane, &side, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_classify_frustum(type, shape, &frustum, &side), GPHYS_ERROR_INVALID_ARGUMENT);
    }
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_SPHERE, &s, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_SPHERE, &s, NULL, &out), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_SPHERE, &s, &identity, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_SPHERE, &s, NULL, 0, &answer), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_SPHERE, &s, &middle, 0, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_closest_point(GPHYS_SHAPE_SPHERE, &s, NULL, &nearest), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_closest_point(GPHYS_SHAPE_SPHERE, &s, &middle, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_overlaps(GPHYS_SHAPE_SPHERE, &s, GPHYS_SHAPE_SPHERE, &s, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_classify_plane(GPHYS_SHAPE_SPHERE, &s, NULL, &side, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_classify_plane(GPHYS_SHAPE_SPHERE, &s, &plane, NULL, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_classify_frustum(GPHYS_SHAPE_SPHERE, &s, NULL, &side), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_classify_frustum(GPHYS_SHAPE_SPHERE, &s, &frustum, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
}

static void lines_planes_and_meshes_are_unsupported_where_they_mean_nothing(void** state) {
    (void)state;
    const any_shape sphere = good(GPHYS_SHAPE_SPHERE), ray = good(GPHYS_SHAPE_RAY);
    const gphys_plane plane = good(GPHYS_SHAPE_PLANE).plane;
    const gphys_frustum frustum = good(GPHYS_SHAPE_FRUSTUM).frustum;
    gphys_side side = 9;
    int32_t answer = 9;
    assert_int_equal(gphys_shape_overlaps(GPHYS_SHAPE_RAY, &ray, GPHYS_SHAPE_SPHERE, &sphere, &answer),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_overlaps(GPHYS_SHAPE_SPHERE, &sphere, GPHYS_SHAPE_SEGMENT, &ray, &answer),
                     GPHYS_ERROR_UNSUPPORTED);
    const gphys_shape_type sideless[] = {GPHYS_SHAPE_PLANE, GPHYS_SHAPE_FRUSTUM, GPHYS_SHAPE_MESH, GPHYS_SHAPE_RAY};
    for (int i = 0; i < 4; ++i) {
        assert_int_equal(gphys_shape_classify_plane(sideless[i], &frustum, &plane, &side, NULL),
                         GPHYS_ERROR_UNSUPPORTED);
        assert_int_equal(gphys_shape_classify_frustum(sideless[i], &frustum, &frustum, &side), GPHYS_ERROR_UNSUPPORTED);
    }
    assert_int_equal(side, 9);
    assert_int_equal(answer, 9);
}

static void errors_leave_outputs_alone(void** state) {
    (void)state;
    const any_shape s = good(GPHYS_SHAPE_SPHERE);
    gphys_vec3 points[3] = {{1, 1, 1}, {5, 5, 5}, {1, 1, 1}};
    points[2] = nan_point;
    int32_t answers[3] = {7, 7, 7};
    gphys_nearest nearest[3];
    memset(nearest, 0x55, sizeof nearest);
    gphys_nearest before[3];
    memcpy(before, nearest, sizeof nearest);
    assert_int_equal(gphys_shape_contains_batch(GPHYS_SHAPE_SPHERE, &s, points, 12, 3, 0, answers, 4),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_closest_point_batch(GPHYS_SHAPE_SPHERE, &s, points, 12, 3, nearest, sizeof *nearest),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    gphys_sphere spheres[3] = {{{0, 0, 0}, 1}, {{0, 0, 0}, 1}, {{0, 0, 0}, -1}};
    assert_int_equal(gphys_shape_overlaps_batch(GPHYS_SHAPE_SPHERE, &s, 0, GPHYS_SHAPE_SPHERE, spheres, sizeof *spheres,
                                                3, answers, 4),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    for (int i = 0; i < 3; ++i) assert_int_equal(answers[i], 7);
    assert_memory_equal(nearest, before, sizeof nearest);

    const float bad_tolerances[] = {-1, NAN, INFINITY};
    for (int i = 0; i < 3; ++i) {
        assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_SPHERE, &s, &middle, bad_tolerances[i], answers),
                         GPHYS_ERROR_INVALID_ARGUMENT);
    }
    assert_int_equal(answers[0], 7);
}

static void strides_are_checked(void** state) {
    (void)state;
    const any_shape s = good(GPHYS_SHAPE_SPHERE);
    const gphys_vec3 points[4] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    gphys_sphere spheres[4];
    int32_t answers[8];
    gphys_nearest nearest[4];
    for (int i = 0; i < 4; ++i) spheres[i] = s.sphere;
    const uint32_t bad_point_strides[] = {1, 4, 8, 13, 14};
    for (int i = 0; i < 5; ++i) {
        assert_int_equal(
            gphys_shape_contains_batch(GPHYS_SHAPE_SPHERE, &s, points, bad_point_strides[i], 2, 0, answers, 4),
            GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_closest_point_batch(GPHYS_SHAPE_SPHERE, &s, points, bad_point_strides[i], 2,
                                                         nearest, sizeof *nearest),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_overlaps_batch(GPHYS_SHAPE_SPHERE, spheres, bad_point_strides[i],
                                                    GPHYS_SHAPE_SPHERE, spheres, 0, 2, answers, 4),
                         GPHYS_ERROR_INVALID_ARGUMENT);
    }
    const uint32_t bad_out_strides[] = {0, 2, 6};
    for (int i = 0; i < 3; ++i) {
        assert_int_equal(
            gphys_shape_contains_batch(GPHYS_SHAPE_SPHERE, &s, points, 12, 2, 0, answers, bad_out_strides[i]),
            GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(
            gphys_shape_closest_point_batch(GPHYS_SHAPE_SPHERE, &s, points, 12, 2, nearest, bad_out_strides[i]),
            GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_overlaps_batch(GPHYS_SHAPE_SPHERE, spheres, 16, GPHYS_SHAPE_SPHERE, spheres, 0, 2,
                                                    answers, bad_out_strides[i]),
                         GPHYS_ERROR_INVALID_ARGUMENT);
    }
    /* No elements: no arrays needed. */
    assert_int_equal(gphys_shape_contains_batch(GPHYS_SHAPE_SPHERE, &s, NULL, 12, 0, 0, NULL, 4), GPHYS_OK);
    assert_int_equal(gphys_shape_closest_point_batch(GPHYS_SHAPE_SPHERE, &s, NULL, 12, 0, NULL, sizeof *nearest),
                     GPHYS_OK);
    assert_int_equal(gphys_shape_overlaps_batch(GPHYS_SHAPE_SPHERE, NULL, 16, GPHYS_SHAPE_SPHERE, &s, 0, 0, NULL, 4),
                     GPHYS_OK);
}

static void batches_equal_single_calls(void** state) {
    (void)state;
    enum { N = 64 };
    struct {
        gphys_vec3 point;
        float other;
    } points[N];
    for (int i = 0; i < N; ++i) {
        points[i].point = (gphys_vec3){(float)(i % 4), (float)(i / 4 % 4), (float)(i / 16) * 0.75f};
        points[i].other = NAN;
    }
    for (int t = 0; t < TYPES; ++t) {
        const any_shape s = good(types[t]);
        int32_t answers[2 * N];
        gphys_nearest nearest[N];
        memset(answers, 0x55, sizeof answers);
        assert_int_equal(
            gphys_shape_contains_batch(types[t], &s, &points[0].point, sizeof *points, N, 0.25f, answers, 8), GPHYS_OK);
        assert_int_equal(gphys_shape_closest_point_batch(types[t], &s, &points[0].point, sizeof *points, N, nearest,
                                                         sizeof *nearest),
                         GPHYS_OK);
        int inside = 0;
        for (int i = 0; i < N; ++i) {
            int32_t answer;
            gphys_nearest one;
            assert_int_equal(gphys_shape_contains(types[t], &s, &points[i].point, 0.25f, &answer), GPHYS_OK);
            assert_int_equal(answers[2 * i], answer);
            assert_int_equal(answers[2 * i + 1], 0x55555555);
            inside += answer;
            assert_int_equal(gphys_shape_closest_point(types[t], &s, &points[i].point, &one), GPHYS_OK);
            assert_memory_equal(&one, &nearest[i], sizeof one);
            assert_int_equal(one.triangle, GPHYS_NO_TRIANGLE);
            /* The point that is nearest is in the shape, and nearer than the tolerance if that held. */
            assert_int_equal(one.distance <= 0.25f, answer);
        }
        assert_in_range(inside, 1, N - 1);

        for (int u = 0; u < TYPES; ++u) {
            if (!is_primitive(types[t]) || !is_primitive(types[u])) continue;
            any_shape others[N];
            for (int i = 0; i < N; ++i) {
                others[i] = good(types[u]);
                const gphys_transform move = {{points[i].point.x * 2, points[i].point.y, 0}, {0, 0, 0, 1}, 1};
                if (types[u] == GPHYS_SHAPE_AABB) continue;
                assert_int_equal(gphys_shape_transform(types[u], &others[i], &move, &others[i]), GPHYS_OK);
            }
            assert_int_equal(
                gphys_shape_overlaps_batch(types[t], &s, 0, types[u], others, sizeof *others, N, answers, 4), GPHYS_OK);
            for (int i = 0; i < N; ++i) {
                int32_t answer, swapped;
                assert_int_equal(gphys_shape_overlaps(types[t], &s, types[u], &others[i], &answer), GPHYS_OK);
                assert_int_equal(gphys_shape_overlaps(types[u], &others[i], types[t], &s, &swapped), GPHYS_OK);
                assert_int_equal(answers[i], answer);
                assert_int_equal(swapped, answer);
            }
            assert_int_equal(answers[0], 1); /* unmoved, all meet around (1, 1, 1) */
        }
    }
}

static void bounds_hold_the_shape_and_infinite_ones_have_none(void** state) {
    (void)state;
    gphys_aabb box;
    any_shape s = good(GPHYS_SHAPE_SPHERE);
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_SPHERE, &s, &box), GPHYS_OK);
    assert_true(box.min.x == 0 && box.max.z == 2);
    s.sphere.radius = 1e-30f; /* far below an ulp of the centre, and still inside the box */
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_SPHERE, &s, &box), GPHYS_OK);
    assert_true(box.min.x < 1 && box.max.x > 1);
    assert_true(box.min.x == nextafterf(1, 0) && box.max.x == nextafterf(1, 2));

    s = good(GPHYS_SHAPE_RAY);
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_RAY, &s, &box), GPHYS_OK);
    assert_true(box.min.z == 0 && box.max.z == 10 && box.min.x == 1 && box.max.x == 1);
    s.ray.t_max = INFINITY;
    memset(&box, 0x55, sizeof box);
    const gphys_aabb before = box;
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_RAY, &s, &box), GPHYS_UNBOUNDED);
    s.ray = (gphys_ray){{0, 0, 0}, {1e15f, 0, 0}, 1e30f};
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_RAY, &s, &box), GPHYS_UNBOUNDED);
    s = good(GPHYS_SHAPE_PLANE);
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_PLANE, &s, &box), GPHYS_UNBOUNDED);
    s = good(GPHYS_SHAPE_FRUSTUM);
    s.frustum.planes[GPHYS_FRUSTUM_FAR] = (gphys_plane){{0, 0, 0}, -1};
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_FRUSTUM, &s, &box), GPHYS_UNBOUNDED);
    s = good(GPHYS_SHAPE_FRUSTUM);
    s.frustum.planes[GPHYS_FRUSTUM_NEAR].distance = 5; /* behind the far plane */
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_FRUSTUM, &s, &box), GPHYS_NO_HIT);
    assert_memory_equal(&box, &before, sizeof box);
    gphys_nearest nearest;
    assert_int_equal(gphys_shape_closest_point(GPHYS_SHAPE_FRUSTUM, &s, &middle, &nearest), GPHYS_NO_HIT);
    assert_int_equal(gphys_shape_closest_point_batch(GPHYS_SHAPE_FRUSTUM, &s, &middle, 0, 1, &nearest, sizeof nearest),
                     GPHYS_OK);
    assert_true(isinf(nearest.distance) && nearest.point.x == 0);

    s = good(GPHYS_SHAPE_FRUSTUM);
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_FRUSTUM, &s, &box), GPHYS_OK);
    assert_float_equal(box.min.x, -3, 1e-6);
    assert_float_equal(box.max.y, 5, 1e-6);
    assert_float_equal(box.min.z, 0.5, 1e-6);
    assert_float_equal(box.max.z, 4, 1e-6);
    assert_true(box.min.x <= -3 && box.max.y >= 5 && box.min.z <= 0.5f && box.max.z >= 4);
}

static void transforms_move_shapes(void** state) {
    (void)state;
    /* A quarter turn about z, doubled, moved. */
    const float h = 0.70710678f;
    const gphys_transform t = {{10, 0, 0}, {0, 0, h, h}, 2};
    const gphys_aabb box = {{1, 0, 0}, {3, 2, 4}};
    gphys_obb turned;
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_AABB, &box, &t, &turned), GPHYS_OK);
    assert_float_equal(turned.center.x, 8, 1e-6);
    assert_float_equal(turned.center.y, 4, 1e-6);
    assert_float_equal(turned.half_extents.z, 4, 1e-6);
    assert_float_equal(turned.rotation.z, h, 1e-6);
    gphys_ray ray = {{1, 0, 0}, {1, 0, 0}, 3};
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_RAY, &ray, &t, &ray), GPHYS_OK);
    assert_float_equal(ray.origin.y, 2, 1e-6);
    assert_float_equal(ray.direction.y, 2, 1e-6);
    assert_true(ray.t_max == 3);
    gphys_plane plane = {{1, 0, 0}, 1};
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_PLANE, &plane, &t, &plane), GPHYS_OK);
    assert_float_equal(plane.normal.y, 1, 1e-6);
    assert_float_equal(plane.distance, 2, 1e-5);
    gphys_frustum infinite = good(GPHYS_SHAPE_FRUSTUM).frustum;
    infinite.planes[GPHYS_FRUSTUM_FAR] = (gphys_plane){{0, 0, 0}, -1};
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_FRUSTUM, &infinite, &t, &infinite), GPHYS_OK);
    assert_int_equal(gphys_shape_validate(GPHYS_SHAPE_FRUSTUM, &infinite), GPHYS_OK);

    gphys_sphere far_out = {{1e15f, 0, 0}, 1}, untouched = far_out;
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_SPHERE, &far_out, &t, &far_out), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_memory_equal(&far_out, &untouched, sizeof far_out);
    gphys_transform bad = t;
    bad.scale = 0;
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_SPHERE, &far_out, &bad, &far_out), GPHYS_ERROR_INVALID_ARGUMENT);
    bad = t;
    bad.rotation.w = 0.9f;
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_SPHERE, &far_out, &bad, &far_out), GPHYS_ERROR_INVALID_ARGUMENT);
    bad = t;
    bad.position.y = NAN;
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_SPHERE, &far_out, &bad, &far_out), GPHYS_ERROR_INVALID_ARGUMENT);
    const float mesh_stand_in = 0;
    assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_MESH, &mesh_stand_in, &t, &far_out), GPHYS_ERROR_UNSUPPORTED);
}

static void classification_tells_sides(void** state) {
    (void)state;
    const gphys_plane floor_plane = {{0, 2, 0}, 0};
    gphys_side side = 9;
    float distance = 9;
    const gphys_sphere above = {{0, 3, 0}, 1}, touching = {{0, 1, 0}, 1}, below = {{0, -3, 0}, 1};
    assert_int_equal(gphys_shape_classify_plane(GPHYS_SHAPE_SPHERE, &above, &floor_plane, &side, &distance), GPHYS_OK);
    assert_int_equal(side, GPHYS_SIDE_INSIDE);
    assert_true(distance == 2);
    assert_int_equal(gphys_shape_classify_plane(GPHYS_SHAPE_SPHERE, &touching, &floor_plane, &side, &distance),
                     GPHYS_OK);
    assert_int_equal(side, GPHYS_SIDE_CROSSING);
    assert_true(distance == 0);
    assert_int_equal(gphys_shape_classify_plane(GPHYS_SHAPE_SPHERE, &below, &floor_plane, &side, &distance), GPHYS_OK);
    assert_int_equal(side, GPHYS_SIDE_OUTSIDE);
    assert_true(distance == -2);

    const gphys_frustum frustum = good(GPHYS_SHAPE_FRUSTUM).frustum;
    const gphys_sphere inside = {{1, 1, 2}, 0.25f}, crossing = {{1, 1, 0.5f}, 0.25f}, outside = {{1, 1, -2}, 1};
    const gphys_sphere* spheres[] = {&outside, &crossing, &inside};
    for (int i = 0; i < 3; ++i) {
        assert_int_equal(gphys_shape_classify_frustum(GPHYS_SHAPE_SPHERE, spheres[i], &frustum, &side), GPHYS_OK);
        assert_int_equal(side, i - 1);
    }
    gphys_plane bad = floor_plane;
    bad.normal.y = 0;
    assert_int_equal(gphys_shape_classify_plane(GPHYS_SHAPE_SPHERE, &above, &bad, &side, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
}

static void segments_have_closest_points(void** state) {
    (void)state;
    const gphys_segment a = {{0, 0, 0}, {4, 0, 0}}, b = {{1, 1, -1}, {1, 1, 1}}, beside = {{3, 2, 0}, {1, 2, 0}};
    gphys_vec3 on_a, on_b;
    float distance;
    assert_int_equal(gphys_segment_closest_points(&a, &b, &on_a, &on_b, &distance), GPHYS_OK);
    assert_true(on_a.x == 1 && on_a.y == 0 && on_b.y == 1 && on_b.z == 0 && distance == 1);
    /* parallel: the first point along a that is beside b */
    assert_int_equal(gphys_segment_closest_points(&a, &beside, &on_a, &on_b, &distance), GPHYS_OK);
    assert_true(on_a.x == 1 && on_b.x == 1 && distance == 2);
    assert_int_equal(gphys_segment_closest_points(&a, &b, NULL, NULL, NULL), GPHYS_OK);
    assert_int_equal(gphys_segment_closest_points(NULL, &b, &on_a, NULL, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_segment_closest_points(&a, NULL, &on_a, NULL, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    gphys_segment bad = a;
    bad.b.z = NAN;
    on_a.x = 77;
    assert_int_equal(gphys_segment_closest_points(&a, &bad, &on_a, NULL, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_segment_closest_points(&bad, &a, &on_a, NULL, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_true(on_a.x == 77);
}

static void frusta_have_corners_and_come_from_matrices(void** state) {
    (void)state;
    gphys_frustum frustum = good(GPHYS_SHAPE_FRUSTUM).frustum;
    gphys_vec3 corners[8];
    assert_int_equal(gphys_frustum_corners(&frustum, corners), GPHYS_OK);
    const gphys_vec3 left_bottom_near = {0.5f, 0.5f, 0.5f}, right_top_far = {5, 5, 4};
    assert_memory_equal(&corners[0], &left_bottom_near, sizeof(gphys_vec3));
    assert_memory_equal(&corners[6], &right_top_far, sizeof(gphys_vec3));
    assert_int_equal(gphys_frustum_corners(NULL, corners), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_frustum_corners(&frustum, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    frustum.planes[GPHYS_FRUSTUM_FAR] = (gphys_plane){{0, 0, 0}, -1};
    assert_int_equal(gphys_frustum_corners(&frustum, corners), GPHYS_UNBOUNDED);
    frustum.planes[0].distance = NAN;
    assert_int_equal(gphys_frustum_corners(&frustum, corners), GPHYS_ERROR_INVALID_ARGUMENT);

    /* The identity shows the cube -1..1 in x and y, and 0..1 or -1..1 in z. */
    gphys_mat4 matrix = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    for (int range = 0; range < 2; ++range) {
        for (int reverse = 0; reverse < 2; ++reverse) {
            assert_int_equal(gphys_frustum_from_matrix(&matrix, range, reverse, &frustum), GPHYS_OK);
            assert_int_equal(gphys_frustum_corners(&frustum, corners), GPHYS_OK);
            const float low = range == GPHYS_DEPTH_ZERO_TO_ONE ? 0.0f : -1.0f;
            assert_true(corners[0].x == -1 && corners[0].y == -1 && corners[0].z == (reverse ? 1 : low));
            assert_true(corners[6].x == 1 && corners[6].y == 1 && corners[6].z == (reverse ? low : 1));
        }
    }
    /* Infinite: depth 1 - 1/z between near = 1 and infinity; at exactly 1 is nothing. */
    const gphys_mat4 infinite = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0}};
    assert_int_equal(gphys_frustum_from_matrix(&infinite, GPHYS_DEPTH_ZERO_TO_ONE, 0, &frustum), GPHYS_OK);
    assert_true(frustum.planes[GPHYS_FRUSTUM_FAR].normal.z == 0);
    assert_int_equal(gphys_frustum_corners(&frustum, corners), GPHYS_UNBOUNDED);

    const gphys_frustum before = frustum;
    gphys_mat4 bad = matrix;
    bad.m[5] = 0;
    assert_int_equal(gphys_frustum_from_matrix(&bad, 0, 0, &frustum), GPHYS_ERROR_SINGULAR);
    bad.m[5] = NAN;
    assert_int_equal(gphys_frustum_from_matrix(&bad, 0, 0, &frustum), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_frustum_from_matrix(NULL, 0, 0, &frustum), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_frustum_from_matrix(&matrix, 0, 0, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_frustum_from_matrix(&matrix, 2, 0, &frustum), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_frustum_from_matrix(&matrix, 0, 2, &frustum), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_memory_equal(&frustum, &before, sizeof frustum);
}

static void a_mesh_is_a_shape_too(void** state) {
    (void)state;
    const float vertices[] = {0, 0, 1, 3, 0, 1, 0, 3, 1};
    const uint32_t indices[] = {0, 1, 2};
    gphys_mesh* mesh = NULL;
    assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 3, indices, 3, &mesh), GPHYS_OK);
    const any_shape triangle = good(GPHYS_SHAPE_TRIANGLE);
    assert_int_equal(gphys_shape_validate(GPHYS_SHAPE_MESH, mesh), GPHYS_OK);
    gphys_aabb box;
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_MESH, mesh, &box), GPHYS_OK);
    assert_true(box.max.x == 3 && box.min.z == 1);
    for (int i = 0; i < 27; ++i) {
        const gphys_vec3 p = {(float)(i % 3), (float)(i / 3 % 3), 0.5f + 0.5f * (float)(i / 9)};
        int32_t in_mesh, in_triangle;
        assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_MESH, mesh, &p, 0, &in_mesh), GPHYS_OK);
        assert_int_equal(gphys_shape_contains(GPHYS_SHAPE_TRIANGLE, &triangle, &p, 0, &in_triangle), GPHYS_OK);
        assert_int_equal(in_mesh, in_triangle);
        gphys_nearest near_mesh, near_triangle;
        assert_int_equal(gphys_shape_closest_point(GPHYS_SHAPE_MESH, mesh, &p, &near_mesh), GPHYS_OK);
        assert_int_equal(gphys_shape_closest_point(GPHYS_SHAPE_TRIANGLE, &triangle, &p, &near_triangle), GPHYS_OK);
        assert_int_equal(near_mesh.triangle, 0);
        assert_true(near_mesh.distance == near_triangle.distance && near_mesh.point.x == near_triangle.point.x);
    }
    int32_t answer;
    for (int t = 0; t < TYPES && is_primitive(types[t]); ++t) {
        const any_shape s = good(types[t]);
        assert_int_equal(gphys_shape_overlaps(types[t], &s, GPHYS_SHAPE_MESH, mesh, &answer), GPHYS_OK);
        assert_int_equal(answer, 1);
        assert_int_equal(gphys_shape_overlaps(GPHYS_SHAPE_MESH, mesh, types[t], &s, &answer), GPHYS_OK);
        assert_int_equal(answer, 1);
    }
    assert_int_equal(gphys_shape_overlaps(GPHYS_SHAPE_MESH, mesh, GPHYS_SHAPE_MESH, mesh, &answer), GPHYS_OK);
    assert_int_equal(answer, 1);
    assert_int_equal(gphys_shape_overlaps_batch(GPHYS_SHAPE_MESH, mesh, 4, GPHYS_SHAPE_MESH, mesh, 0, 1, &answer, 4),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    gphys_mesh_destroy(mesh);

    assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 3, indices, 0, &mesh), GPHYS_OK);
    gphys_nearest nearest;
    assert_int_equal(gphys_shape_closest_point(GPHYS_SHAPE_MESH, mesh, &middle, &nearest), GPHYS_NO_HIT);
    assert_int_equal(gphys_shape_bounds(GPHYS_SHAPE_MESH, mesh, &box), GPHYS_NO_HIT);
    gphys_mesh_destroy(mesh);
}

/* The points of a batch are searched for in one walk of the mesh's tree. */
static void require_batch_as_single(const gphys_mesh* mesh, float size) {
    enum { MANY = 300 };
    gphys_vec3 points[MANY];
    gphys_nearest near[MANY + 1];
    for (int i = 0; i < MANY; ++i) {
        points[i] =
            (gphys_vec3){size * (float)(i % 7 - 3), size * (float)(i / 7 % 7 - 3), size * (float)(i % 11 - 5) * 0.25f};
    }
    /* Also counts that fill no round of 64. */
    for (uint32_t count = 1; count <= MANY; count += 37) {
        memset(near, 0x55, sizeof near);
        assert_int_equal(gphys_shape_closest_point_batch(GPHYS_SHAPE_MESH, mesh, points, 12, count, near, sizeof *near),
                         GPHYS_OK);
        for (uint32_t i = 0; i < count; ++i) {
            gphys_nearest one = {0, 0, {0, 0, 0}, INFINITY, GPHYS_NO_TRIANGLE};
            (void)gphys_shape_closest_point(GPHYS_SHAPE_MESH, mesh, &points[i], &one);
            assert_memory_equal(&one, &near[i], sizeof one);
        }
        assert_int_equal(near[count].triangle, 0x55555555);
    }
}

static void closest_points_of_meshes_in_a_batch_are_those_one_by_one(void** state) {
    enum { SIDE = 9 };
    const float sizes[] = {1, 1e-38f};
    uint32_t indices[6 * SIDE * SIDE], count = 0;
    (void)state;
    for (uint32_t i = 0; i < SIDE * SIDE; ++i) {
        const uint32_t corner = i / SIDE * (SIDE + 1) + i % SIDE;
        const uint32_t of[] = {0, 1, SIDE + 1, 1, SIDE + 2, SIDE + 1};
        for (int k = 0; k < 6; ++k) indices[count++] = corner + of[k];
    }
    for (int s = 0; s < 2; ++s) {
        gphys_vec3 vertices[(SIDE + 1) * (SIDE + 1)];
        gphys_mesh *sheet = NULL, *hull = NULL, *empty = NULL;
        const uint32_t all = sizeof vertices / sizeof *vertices;
        for (uint32_t i = 0; i < all; ++i) {
            const float x = (float)(i % (SIDE + 1)) * 0.5f - 2, y = (float)(i / (SIDE + 1)) * 0.5f - 2;
            vertices[i] = (gphys_vec3){sizes[s] * x, sizes[s] * y, sizes[s] * (x * x - y * y) * 0.25f};
        }
        assert_int_equal(gphys_mesh_create(NULL, &vertices[0].x, 12, all, indices, count, &sheet), GPHYS_OK);
        require_batch_as_single(sheet, sizes[s]);
        assert_int_equal(gphys_mesh_create(NULL, &vertices[0].x, 12, all, indices, 0, &empty), GPHYS_OK);
        require_batch_as_single(empty, sizes[s]);
        if (s == 0) {
            assert_int_equal(gphys_mesh_create_hull(NULL, &vertices[0].x, 12, all, &hull), GPHYS_OK);
            require_batch_as_single(hull, sizes[s]);
            gphys_mesh_destroy(hull);
        }
        gphys_mesh_destroy(empty);
        gphys_mesh_destroy(sheet);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_float_of_every_shape_is_checked),
        cmocka_unit_test(defects_are_named),
        cmocka_unit_test(degenerate_but_allowed),
        cmocka_unit_test(unknown_types_and_null_are_refused),
        cmocka_unit_test(lines_planes_and_meshes_are_unsupported_where_they_mean_nothing),
        cmocka_unit_test(errors_leave_outputs_alone),
        cmocka_unit_test(strides_are_checked),
        cmocka_unit_test(batches_equal_single_calls),
        cmocka_unit_test(bounds_hold_the_shape_and_infinite_ones_have_none),
        cmocka_unit_test(transforms_move_shapes),
        cmocka_unit_test(classification_tells_sides),
        cmocka_unit_test(segments_have_closest_points),
        cmocka_unit_test(frusta_have_corners_and_come_from_matrices),
        cmocka_unit_test(a_mesh_is_a_shape_too),
        cmocka_unit_test(closest_points_of_meshes_in_a_batch_are_those_one_by_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

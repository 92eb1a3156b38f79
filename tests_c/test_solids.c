/* gphys_shape_sweep, _penetration, gphys_scene_sweep, _sweep_batch and _penetration: known answers for every kind of
 * shape, lists in order and cut short, batches equal to singles, bad input refused with outputs untouched. */
#include "test.h"

typedef struct target {
    gphys_shape_type type;
    const void* shape;
} target;

#define TARGETS 7
#define MOVERS 4

/* All begin at z = 2 when met along +z from the origin. */
static const gphys_sphere sphere = {{0, 0, 3}, 1};
static const gphys_capsule capsule = {{-1, 0, 2.5f}, {1, 0, 2.5f}, 0.5f};
static const gphys_aabb aabb = {{-2, -2, 2}, {2, 2, 4}};
static const gphys_obb obb = {{0, 0, 3}, {2, 2, 1}, {0, 0, 0.6f, 0.8f}};
static const gphys_plane plane = {{0, 0, -2}, -4};
static const gphys_triangle triangle = {{-4, -4, 2}, {-4, 8, 2}, {8, -4, 2}};
static const gphys_frustum frustum = {
    {0, 0, 1}, {{{0, 0, 1}, 1}, {{0, 0, -1}, -3}, {{1, 0, 1}, 0}, {{-1, 0, 1}, 0}, {{0, 1, 1}, 0}, {{0, -1, 1}, 0}}};
static gphys_mesh* mesh;
static gphys_scene* scene;
static gphys_model_id models[4];

static target targets[TARGETS] = {{GPHYS_SHAPE_SPHERE, &sphere}, {GPHYS_SHAPE_CAPSULE, &capsule},
                                  {GPHYS_SHAPE_AABB, &aabb},     {GPHYS_SHAPE_OBB, &obb},
                                  {GPHYS_SHAPE_PLANE, &plane},   {GPHYS_SHAPE_TRIANGLE, &triangle},
                                  {GPHYS_SHAPE_MESH, NULL}};

/* Half a metre to the front and around the origin. */
static const gphys_sphere ball = {{0, 0, 0}, 0.5f};
static const gphys_capsule pill = {{0, -0.25f, 0}, {0, 0.25f, 0}, 0.5f};
static const gphys_aabb block = {{-0.25f, -0.25f, -0.5f}, {0.25f, 0.25f, 0.5f}};
static const gphys_obb brick = {{0, 0, 0}, {0.25f, 0.25f, 0.5f}, {0, 0, 0.6f, 0.8f}};
static const target movers[MOVERS] = {
    {GPHYS_SHAPE_SPHERE, &ball}, {GPHYS_SHAPE_CAPSULE, &pill}, {GPHYS_SHAPE_AABB, &block}, {GPHYS_SHAPE_OBB, &brick}};

static int make_models(void** state) {
    const float vertices[] = {-4, -4, 2, -4, 8, 2, 8, -4, 2, -4, -4, 9, -4, 8, 9, 8, -4, 9};
    const uint32_t indices[] = {3, 4, 5, 0, 1, 2};
    const gphys_transform behind = {{0, 0, 20}, {0, 0, 0, 1}, 1};
    gphys_model_desc desc;
    (void)state;
    if (gphys_mesh_create(NULL, vertices, 12, 6, indices, 6, &mesh) != GPHYS_OK) return 1;
    targets[TARGETS - 1].shape = mesh;
    if (gphys_model_desc_init(&desc, sizeof desc) != GPHYS_OK) return 1;
    if (gphys_scene_create(NULL, &scene) != GPHYS_OK) return 1;
    desc.tag = 7;
    gphys_scene_add(scene, GPHYS_SHAPE_AABB, &aabb, NULL, &desc, &models[0]);
    gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &sphere, NULL, &desc, &models[1]);
    desc.layers = 2;
    gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, &behind, &desc, &models[2]);
    return gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &plane, NULL, &desc, &models[3]) != GPHYS_OK;
}
static int free_models(void** state) {
    (void)state;
    gphys_scene_destroy(scene);
    gphys_mesh_destroy(mesh);
    return 0;
}

static void every_solid_meets_every_shape(void** state) {
    const gphys_vec3 way = {0, 0, 6}, reaching = {0, 0, 1.5f}, still = {0, 0, 0}, away = {0, 0, -9};
    (void)state;
    for (int m = 0; m < MOVERS; ++m) {
        for (int i = 0; i < TARGETS; ++i) {
            gphys_hit hit;
            assert_int_equal(
                gphys_shape_sweep(targets[i].type, targets[i].shape, movers[m].type, movers[m].shape, &way, &hit),
                GPHYS_OK);
            assert_true(hit.t == 0.25f);
            assert_true(fabsf(hit.point.z - 2) < 1e-6f);
            assert_true(hit.normal.z < -0.999999f);
            assert_int_equal(hit.flags & GPHYS_HIT_INSIDE, 0);
            assert_int_equal(hit.triangle, targets[i].type == GPHYS_SHAPE_MESH ? 1 : GPHYS_NO_TRIANGLE);
            assert_int_equal(hit.model, 0);
            assert_int_equal(
                gphys_shape_sweep(targets[i].type, targets[i].shape, movers[m].type, movers[m].shape, &reaching, &hit),
                GPHYS_OK);
            assert_true(hit.t == 1);
            for (int k = 0; k < 2; ++k) {
                assert_int_equal(gphys_shape_sweep(targets[i].type, targets[i].shape, movers[m].type, movers[m].shape,
                                                   k ? &still : &away, &hit),
                                 GPHYS_NO_HIT);
            }
        }
    }
}

static void every_solid_gets_out_of_every_shape(void** state) {
    (void)state;
    for (int m = 0; m < MOVERS; ++m) {
        gphys_obb moved_box;
        gphys_capsule moved_pill = pill;
        gphys_sphere moved_ball = ball;
        gphys_aabb moved_block = block;
        const void* moved[MOVERS];
        const gphys_transform near = {{0, 0, 1.75f}, {0, 0, 0, 1}, 1};
        assert_int_equal(gphys_shape_transform(GPHYS_SHAPE_OBB, &brick, &near, &moved_box), GPHYS_OK);
        moved_pill.a.z = moved_pill.b.z = moved_ball.center.z = 1.75f;
        moved_block.min.z = 1.25f;
        moved_block.max.z = 2.25f;
        moved[0] = &moved_ball;
        moved[1] = &moved_pill;
        moved[2] = &moved_block;
        moved[3] = &moved_box;
        for (int i = 0; i < TARGETS; ++i) {
            gphys_penetration out;
            assert_int_equal(gphys_shape_penetration(targets[i].type, targets[i].shape, movers[m].type, moved[m], &out),
                             GPHYS_OK);
            assert_true(fabsf(out.depth - 0.25f) < 1e-6f);
            assert_true(out.normal.z < -0.999999f);
            assert_true(fabsf(out.point.z - 2) < 1e-6f);
            assert_int_equal(out.triangle, targets[i].type == GPHYS_SHAPE_MESH ? 1 : GPHYS_NO_TRIANGLE);
            assert_int_equal(out.model, 0);
            assert_int_equal(out.tag, 0);
            /* Where it was before, it touches nothing. */
            assert_int_equal(
                gphys_shape_penetration(targets[i].type, targets[i].shape, movers[m].type, movers[m].shape, &out),
                GPHYS_NO_HIT);
        }
    }
}

static void a_scene_is_swept(void** state) {
    const gphys_vec3 ways[3] = {{0, 0, 6}, {0, 0, -6}, {0, 0, 40}};
    (void)state;
    for (int m = 0; m < MOVERS; ++m) {
        gphys_hit hit, hits[3];
        assert_int_equal(gphys_scene_sweep(scene, movers[m].type, movers[m].shape, &ways[0], 1, &hit), GPHYS_OK);
        assert_int_equal(hit.model, models[0]); /* the box and the sphere at once: the lower id */
        assert_int_equal(hit.tag, 7);
        assert_true(hit.t == 0.25f);
        assert_int_equal(gphys_scene_sweep(scene, movers[m].type, movers[m].shape, &ways[1], 1, &hit), GPHYS_NO_HIT);
        assert_int_equal(gphys_scene_sweep_batch(scene, movers[m].type, movers[m].shape, 0, ways, sizeof *ways, 3, 3,
                                                 hits, sizeof *hits),
                         GPHYS_OK);
        for (int i = 0; i < 3; ++i) {
            const gphys_status status = gphys_scene_sweep(scene, movers[m].type, movers[m].shape, &ways[i], 3, &hit);
            assert_int_equal(status, i == 1 ? GPHYS_NO_HIT : GPHYS_OK);
            if (status == GPHYS_OK) {
                assert_memory_equal(&hit, &hits[i], sizeof hit);
            } else {
                assert_int_equal(hits[i].model, 0);
                assert_true(hits[i].t == INFINITY);
            }
        }
        /* Only the mesh, whose nearer triangle is the second. */
        assert_int_equal(gphys_scene_remove(scene, models[3]), GPHYS_OK);
        assert_int_equal(gphys_scene_sweep(scene, movers[m].type, movers[m].shape, &ways[2], 2, &hit), GPHYS_OK);
        assert_int_equal(hit.model, models[2]);
        assert_int_equal(hit.triangle, 1);
        gphys_model_desc desc;
        assert_int_equal(gphys_model_desc_init(&desc, sizeof desc), GPHYS_OK);
        desc.layers = 2;
        desc.tag = 7;
        assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &plane, NULL, &desc, &models[3]), GPHYS_OK);
    }
}

static void a_list_has_the_deepest_first(void** state) {
    const gphys_capsule deep = {{0, 0, 2}, {0, 0.5f, 2}, 0.5f};
    gphys_penetration all[8], some[2];
    uint32_t total = 0;
    (void)state;
    assert_int_equal(gphys_scene_penetration(scene, GPHYS_SHAPE_CAPSULE, &deep, 3, all, 8, &total), GPHYS_OK);
    assert_int_equal(total, 3); /* box, sphere and plane, by the same half a metre */
    for (uint32_t i = 0; i < total; ++i) {
        assert_int_equal(all[i].tag, 7);
        assert_true(all[i].depth > 0.499f && all[i].depth < 0.501f);
        assert_true(i == 0 || all[i - 1].depth > all[i].depth ||
                    (all[i - 1].depth == all[i].depth && all[i - 1].model < all[i].model));
    }
    assert_int_equal(gphys_scene_penetration(scene, GPHYS_SHAPE_CAPSULE, &deep, 3, some, 2, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 3);
    assert_memory_equal(some, all, sizeof some);
    assert_int_equal(gphys_scene_penetration(scene, GPHYS_SHAPE_CAPSULE, &deep, 3, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(gphys_scene_penetration(scene, GPHYS_SHAPE_SPHERE, &ball, 3, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    /* Both triangles of the mesh, 20 m further on: the nearer is left sooner. */
    const gphys_aabb across = {{-1, -1, 21.75f}, {0, 0, 29.5f}};
    assert_int_equal(gphys_scene_penetration(scene, GPHYS_SHAPE_AABB, &across, 2, all, 8, &total), GPHYS_OK);
    assert_int_equal(total, 2);
    assert_int_equal(all[0].model, models[2]);
    assert_int_equal(all[0].triangle, 0);
    assert_true(all[0].depth == 0.5f);
    assert_int_equal(all[1].triangle, 1);
    assert_true(all[1].depth == 0.25f);
}

static void bad_input_is_refused(void** state) {
    const float bad[] = {NAN, INFINITY, 1.1e15f};
    const gphys_vec3 way = {0, 0, 1};
    const gphys_ray ray = {{0, 0, 0}, {0, 0, 1}, 1};
    gphys_hit hit, no_hit;
    gphys_penetration out, none;
    uint32_t total = 77;
    (void)state;
    memset(&hit, 0x5a, sizeof hit);
    memset(&out, 0x5a, sizeof out);
    no_hit = hit;
    none = out;
    const gphys_shape_type box = GPHYS_SHAPE_AABB, moves = GPHYS_SHAPE_CAPSULE;
    const uint32_t stride = sizeof(gphys_hit);
    for (int b = 0; b < 3; ++b) {
        gphys_vec3 wrong_way = way;
        gphys_capsule wrong = pill;
        wrong_way.y = bad[b];
        wrong.b.x = bad[b];
        assert_int_equal(gphys_shape_sweep(box, &aabb, moves, &pill, &wrong_way, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_sweep(box, &aabb, moves, &wrong, &way, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_sweep(moves, &wrong, box, &aabb, &way, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_penetration(box, &aabb, moves, &wrong, &out), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_shape_penetration(moves, &wrong, box, &aabb, &out), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_scene_sweep(scene, moves, &wrong, &way, 1, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_scene_sweep(scene, moves, &pill, &wrong_way, 1, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_scene_sweep_batch(scene, moves, &wrong, 0, &way, 0, 1, 1, &hit, stride),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_scene_sweep_batch(scene, moves, &pill, 0, &wrong_way, 0, 1, 1, &hit, stride),
                         GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_scene_penetration(scene, moves, &wrong, 1, &out, 1, &total),
                         GPHYS_ERROR_INVALID_ARGUMENT);
    }
    assert_int_equal(gphys_shape_sweep(box, NULL, moves, &pill, &way, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_sweep(box, &aabb, moves, NULL, &way, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_sweep(box, &aabb, moves, &pill, NULL, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_sweep(box, &aabb, moves, &pill, &way, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_sweep(box, &aabb, 99, &pill, &way, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_penetration(box, NULL, moves, &pill, &out), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_penetration(box, &aabb, moves, NULL, &out), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_shape_penetration(box, &aabb, moves, &pill, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep(NULL, moves, &pill, &way, 1, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep(scene, moves, NULL, &way, 1, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep(scene, moves, &pill, NULL, 1, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep(scene, moves, &pill, &way, 1, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep_batch(NULL, moves, &pill, 0, &way, 0, 1, 1, &hit, stride),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep_batch(scene, moves, NULL, 0, &way, 0, 1, 1, &hit, stride),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep_batch(scene, moves, &pill, 0, NULL, 0, 1, 1, &hit, stride),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep_batch(scene, moves, &pill, 0, &way, 0, 1, 1, NULL, stride),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep_batch(scene, moves, &pill, 24, &way, 0, 1, 1, &hit, stride),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep_batch(scene, moves, &pill, 0, &way, 8, 1, 1, &hit, stride),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_sweep_batch(scene, moves, &pill, 0, &way, 0, 1, 1, &hit, 48),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration(NULL, moves, &pill, 1, &out, 1, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration(scene, moves, NULL, 1, &out, 1, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration(scene, moves, &pill, 1, NULL, 1, &total), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration(scene, moves, &pill, 1, &out, 1, NULL), GPHYS_ERROR_INVALID_ARGUMENT);

    assert_int_equal(gphys_shape_sweep(GPHYS_SHAPE_FRUSTUM, &frustum, moves, &pill, &way, &hit),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_sweep(GPHYS_SHAPE_RAY, &ray, moves, &pill, &way, &hit), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_sweep(box, &aabb, GPHYS_SHAPE_PLANE, &plane, &way, &hit), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_sweep(box, &aabb, GPHYS_SHAPE_TRIANGLE, &triangle, &way, &hit),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_sweep(box, &aabb, GPHYS_SHAPE_MESH, mesh, &way, &hit), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_penetration(GPHYS_SHAPE_FRUSTUM, &frustum, moves, &pill, &out),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_penetration(GPHYS_SHAPE_RAY, &ray, moves, &pill, &out), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_penetration(box, &aabb, GPHYS_SHAPE_MESH, mesh, &out), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_sweep(scene, GPHYS_SHAPE_MESH, mesh, &way, 1, &hit), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_sweep_batch(scene, GPHYS_SHAPE_PLANE, &plane, 0, &way, 0, 1, 1, &hit, stride),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_penetration(scene, GPHYS_SHAPE_FRUSTUM, &frustum, 1, &out, 1, &total),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_memory_equal(&hit, &no_hit, sizeof hit);
    assert_memory_equal(&out, &none, sizeof out);
    assert_int_equal(total, 77);
    /* A sphere may be swept against a frustum. */
    assert_int_equal(gphys_shape_sweep(GPHYS_SHAPE_FRUSTUM, &frustum, GPHYS_SHAPE_SPHERE, &ball, &way, &hit),
                     GPHYS_NO_HIT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_solid_meets_every_shape),
        cmocka_unit_test(every_solid_gets_out_of_every_shape),
        cmocka_unit_test(a_scene_is_swept),
        cmocka_unit_test(a_list_has_the_deepest_first),
        cmocka_unit_test(bad_input_is_refused),
    };
    return cmocka_run_group_tests(tests, make_models, free_models);
}

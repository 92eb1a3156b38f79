/* gphys_shape_sweep, _penetration, gphys_scene_sweep, _penetration and their batches: known answers for every kind of
 * shape, lists in order and cut short, batches equal to singles, bad input refused with outputs untouched. */
#include "test.h"

typedef struct target {
    gphys_shape_type type;
    const void* shape;
} target;

#define TARGETS 8
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
static const gphys_plane no_far_plane = {{0, 0, 0}, -1};
static gphys_mesh* mesh;
static gphys_scene* scene;
static gphys_model_id models[4];

static target targets[TARGETS] = {{GPHYS_SHAPE_SPHERE, &sphere},   {GPHYS_SHAPE_CAPSULE, &capsule},
                                  {GPHYS_SHAPE_AABB, &aabb},       {GPHYS_SHAPE_OBB, &obb},
                                  {GPHYS_SHAPE_PLANE, &plane},     {GPHYS_SHAPE_TRIANGLE, &triangle},
                                  {GPHYS_SHAPE_FRUSTUM, &frustum}, {GPHYS_SHAPE_MESH, NULL}};

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

/* One shape against many, many against one, and pairs. */
static void batches_of_shapes_equal_single_calls(void** state) {
    enum { COUNT = 5 };
    struct {
        gphys_capsule pill;
        uint32_t beyond;
    } pills[COUNT];
    gphys_sphere balls[COUNT];
    gphys_vec3 ways[COUNT];
    struct {
        gphys_hit hit;
        uint32_t beyond;
    } hits[COUNT];
    gphys_penetration outs[COUNT];
    const uint32_t pill_step = sizeof *pills, hit_step = sizeof *hits, out_step = sizeof *outs;
    (void)state;
    memset(hits, 0x5a, sizeof hits);
    for (int i = 0; i < COUNT; ++i) {
        pills[i].pill = pill;
        pills[i].pill.a.z = pills[i].pill.b.z = 0.5f * (float)i;
        balls[i].center.x = balls[i].center.y = 0;
        balls[i].center.z = 3 - 0.25f * (float)i;
        balls[i].radius = 0.5f + 0.25f * (float)i;
        ways[i].x = 0.125f * (float)i;
        ways[i].y = 0;
        ways[i].z = i == 1 ? -4.0f : 4.0f;
    }
    for (int t = 0; t < TARGETS; ++t) {
        const gphys_shape_type type = targets[t].type;
        const void* shape = targets[t].shape;
        uint32_t met = 0, overlapped = 0;
        assert_int_equal(gphys_shape_sweep_batch(type, shape, 0, GPHYS_SHAPE_CAPSULE, pills, pill_step, ways,
                                                 sizeof *ways, COUNT, &hits[0].hit, hit_step),
                         GPHYS_OK);
        assert_int_equal(
            gphys_shape_penetration_batch(type, shape, 0, GPHYS_SHAPE_CAPSULE, pills, pill_step, COUNT, outs, out_step),
            GPHYS_OK);
        for (int i = 0; i < COUNT; ++i) {
            gphys_hit hit = {0, 0, INFINITY, {0, 0, 0}, {0, 0, 0}, GPHYS_NO_TRIANGLE, 0, 0, 0};
            gphys_penetration out = {0, 0, {0, 0, 0}, {0, 0, 0}, -INFINITY, GPHYS_NO_TRIANGLE};
            met += gphys_shape_sweep(type, shape, GPHYS_SHAPE_CAPSULE, &pills[i], &ways[i], &hit) == GPHYS_OK;
            overlapped += gphys_shape_penetration(type, shape, GPHYS_SHAPE_CAPSULE, &pills[i], &out) == GPHYS_OK;
            assert_memory_equal(&hits[i].hit, &hit, sizeof hit);
            assert_int_equal(hits[i].beyond, 0x5a5a5a5a);
            assert_memory_equal(&outs[i], &out, sizeof out);
        }
        assert_true(met > 0 && met < COUNT && overlapped > 0 && overlapped < COUNT);
    }
    /* Pairs, and the same way for all. */
    assert_int_equal(gphys_shape_sweep_batch(GPHYS_SHAPE_SPHERE, balls, sizeof *balls, GPHYS_SHAPE_CAPSULE, pills,
                                             pill_step, ways, 0, COUNT, &hits[0].hit, hit_step),
                     GPHYS_OK);
    assert_int_equal(gphys_shape_penetration_batch(GPHYS_SHAPE_SPHERE, balls, sizeof *balls, GPHYS_SHAPE_AABB, &block,
                                                   0, COUNT, outs, out_step),
                     GPHYS_OK);
    for (int i = 0; i < COUNT; ++i) {
        gphys_hit hit;
        gphys_penetration out = {0, 0, {0, 0, 0}, {0, 0, 0}, -INFINITY, GPHYS_NO_TRIANGLE};
        assert_int_equal(
            gphys_shape_sweep(GPHYS_SHAPE_SPHERE, &balls[i], GPHYS_SHAPE_CAPSULE, &pills[i], &ways[0], &hit), GPHYS_OK);
        assert_memory_equal(&hits[i].hit, &hit, sizeof hit);
        assert_int_equal(
            gphys_shape_penetration(GPHYS_SHAPE_SPHERE, &balls[i], GPHYS_SHAPE_AABB, &block, &out) == GPHYS_OK, i == 4);
        assert_memory_equal(&outs[i], &out, sizeof out);
    }
    assert_int_equal(
        gphys_shape_sweep_batch(GPHYS_SHAPE_MESH, mesh, 0, GPHYS_SHAPE_CAPSULE, pills, pill_step, NULL, 0, 0, NULL, 56),
        GPHYS_OK);
    assert_int_equal(
        gphys_shape_penetration_batch(GPHYS_SHAPE_MESH, mesh, 0, GPHYS_SHAPE_CAPSULE, pills, pill_step, 0, NULL, 40),
        GPHYS_OK);
}

static void bad_batches_of_shapes_are_refused(void** state) {
    const gphys_shape_type box = GPHYS_SHAPE_AABB, moves = GPHYS_SHAPE_CAPSULE, surface = GPHYS_SHAPE_MESH;
    const gphys_vec3 way = {0, 0, 1};
    gphys_vec3 ways[2] = {{0, 0, 1}, {0, NAN, 0}};
    gphys_capsule pills[2];
    gphys_frustum frusta[2];
    gphys_hit hits[2], no_hits[2];
    gphys_penetration outs[2], none[2];
    const uint32_t pill_step = sizeof *pills, hit_step = sizeof *hits, out_step = sizeof *outs;
    const uint32_t frustum_step = sizeof *frusta;
    (void)state;
    pills[0] = pills[1] = pill;
    pills[1].radius = -1;
    frusta[0] = frusta[1] = frustum;
    frusta[1].planes[GPHYS_FRUSTUM_FAR] = no_far_plane;
    memset(hits, 0x5a, sizeof hits);
    memset(outs, 0x5a, sizeof outs);
    memcpy(no_hits, hits, sizeof hits);
    memcpy(none, outs, sizeof outs);
#define SWEPT(...) assert_int_equal(gphys_shape_sweep_batch(__VA_ARGS__), GPHYS_ERROR_INVALID_ARGUMENT)
#define PUSHED(...) assert_int_equal(gphys_shape_penetration_batch(__VA_ARGS__), GPHYS_ERROR_INVALID_ARGUMENT)
    SWEPT(box, NULL, 0, moves, &pill, 0, &way, 0, 2, hits, hit_step);
    SWEPT(box, &aabb, 0, moves, NULL, 0, &way, 0, 2, hits, hit_step);
    SWEPT(box, &aabb, 0, moves, &pill, 0, NULL, 0, 2, hits, hit_step);
    SWEPT(box, &aabb, 0, moves, &pill, 0, &way, 0, 2, NULL, hit_step);
    SWEPT(box, &aabb, 8, moves, &pill, 0, &way, 0, 2, hits, hit_step);
    SWEPT(box, &aabb, 0, moves, pills, 24, &way, 0, 2, hits, hit_step);
    SWEPT(box, &aabb, 0, moves, pills, pill_step, &way, 0, 2, hits, hit_step);
    SWEPT(moves, pills, pill_step, box, &aabb, 0, &way, 0, 2, hits, hit_step);
    SWEPT(box, &aabb, 0, moves, &pill, 0, ways, sizeof *ways, 2, hits, hit_step);
    SWEPT(box, &aabb, 0, moves, &pill, 0, &way, 8, 2, hits, hit_step);
    SWEPT(box, &aabb, 0, moves, &pill, 0, &way, 0, 2, hits, 48);
    SWEPT(surface, mesh, 64, moves, &pill, 0, &way, 0, 2, hits, hit_step);
    SWEPT(99, &aabb, 0, moves, &pill, 0, &way, 0, 2, hits, hit_step);
    PUSHED(box, NULL, 0, moves, &pill, 0, 2, outs, out_step);
    PUSHED(box, &aabb, 0, moves, NULL, 0, 2, outs, out_step);
    PUSHED(box, &aabb, 0, moves, &pill, 0, 2, NULL, out_step);
    PUSHED(box, &aabb, 8, moves, &pill, 0, 2, outs, out_step);
    PUSHED(box, &aabb, 0, moves, pills, 24, 2, outs, out_step);
    PUSHED(box, &aabb, 0, moves, pills, pill_step, 2, outs, out_step);
    PUSHED(moves, pills, pill_step, box, &aabb, 0, 2, outs, out_step);
    PUSHED(box, &aabb, 0, moves, &pill, 0, 2, outs, 36);
    PUSHED(surface, mesh, 64, moves, &pill, 0, 2, outs, out_step);
#undef SWEPT
#undef PUSHED
    assert_int_equal(
        gphys_shape_sweep_batch(GPHYS_SHAPE_FRUSTUM, frusta, frustum_step, moves, &pill, 0, &way, 0, 2, hits, hit_step),
        GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_sweep_batch(box, &aabb, 0, GPHYS_SHAPE_PLANE, &plane, 0, &way, 0, 2, hits, 56),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(
        gphys_shape_penetration_batch(GPHYS_SHAPE_FRUSTUM, frusta, frustum_step, moves, &pill, 0, 2, outs, out_step),
        GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_penetration_batch(box, &aabb, 0, surface, mesh, 0, 2, outs, 40),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_memory_equal(hits, no_hits, sizeof hits);
    assert_memory_equal(outs, none, sizeof outs);
}

/* A crowd, in more than one chunk, from before the box to behind the mesh; some at the ends of chunks overlap. */
static void a_crowd_gets_out_in_one_call(void** state) {
    enum { COUNT = 1000, ROOM = 4096, CUT = 301 };
    static gphys_capsule crowd[COUNT];
    static gphys_penetration single[ROOM], batch[ROOM];
    static uint32_t offsets[COUNT + 1];
    uint32_t total = 0, busy = 0;
    (void)state;
    for (int i = 0; i < COUNT; ++i) {
        crowd[i] = pill;
        crowd[i].a.z = 0.03f * (float)(39 * i % COUNT);
        crowd[i].b.z = crowd[i].a.z + 0.75f;
    }
    assert_int_equal(
        gphys_scene_penetration_batch(scene, GPHYS_SHAPE_CAPSULE, crowd, sizeof *crowd, COUNT, 3, batch, ROOM, offsets),
        GPHYS_OK);
    for (int i = 0; i < COUNT; ++i) {
        uint32_t some = 0;
        assert_int_equal(offsets[i], total);
        assert_int_equal(
            gphys_scene_penetration(scene, GPHYS_SHAPE_CAPSULE, &crowd[i], 3, single + total, ROOM - total, &some),
            GPHYS_OK);
        total += some;
        busy += some > 1;
    }
    assert_int_equal(offsets[COUNT], total);
    assert_true(busy > 20 && total > CUT && total < ROOM);
    assert_memory_equal(batch, single, total * sizeof *batch);
    /* All offsets, and the first ways out, of an array that is too small; none. */
    memset(batch, 0x5a, sizeof batch);
    memset(offsets, 0, sizeof offsets);
    assert_int_equal(
        gphys_scene_penetration_batch(scene, GPHYS_SHAPE_CAPSULE, crowd, sizeof *crowd, COUNT, 3, batch, CUT, offsets),
        GPHYS_INCOMPLETE);
    assert_int_equal(offsets[COUNT], total);
    assert_memory_equal(batch, single, CUT * sizeof *batch);
    assert_int_equal(((const unsigned char*)&batch[CUT])[0], 0x5a);
    assert_int_equal(
        gphys_scene_penetration_batch(scene, GPHYS_SHAPE_CAPSULE, crowd, sizeof *crowd, COUNT, 3, NULL, 0, offsets),
        GPHYS_INCOMPLETE);
    assert_int_equal(offsets[COUNT], total);
    /* One shape count times, and none. */
    assert_int_equal(
        gphys_scene_penetration_batch(scene, GPHYS_SHAPE_CAPSULE, &crowd[1], 0, 3, 3, batch, ROOM, offsets), GPHYS_OK);
    assert_true(offsets[1] > 0 && offsets[2] == 2 * offsets[1] && offsets[3] == 3 * offsets[1]);
    assert_memory_equal(batch, batch + offsets[1], offsets[1] * sizeof *batch);
    assert_int_equal(gphys_scene_penetration_batch(scene, GPHYS_SHAPE_CAPSULE, NULL, 0, 0, 3, NULL, 0, offsets),
                     GPHYS_OK);
    assert_int_equal(offsets[0], 0);
}

static void bad_input_is_refused(void** state) {
    const float bad[] = {NAN, INFINITY, 1.1e15f};
    const gphys_vec3 way = {0, 0, 1};
    const gphys_ray ray = {{0, 0, 0}, {0, 0, 1}, 1};
    gphys_hit hit, no_hit;
    gphys_penetration out, none;
    uint32_t total = 77, offsets[2] = {77, 77};
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
        assert_int_equal(gphys_scene_penetration_batch(scene, moves, &wrong, 0, 1, 1, &out, 1, offsets),
                         GPHYS_ERROR_INVALID_ARGUMENT);
    }
    assert_int_equal(gphys_scene_penetration_batch(NULL, moves, &pill, 0, 1, 1, &out, 1, offsets),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration_batch(scene, moves, NULL, 0, 1, 1, &out, 1, offsets),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration_batch(scene, moves, &pill, 24, 1, 1, &out, 1, offsets),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration_batch(scene, moves, &pill, 0, 1, 1, NULL, 1, offsets),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration_batch(scene, moves, &pill, 0, 1, 1, &out, 1, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_penetration_batch(scene, GPHYS_SHAPE_PLANE, &plane, 0, 1, 1, &out, 1, offsets),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(offsets[0], 77);
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

    assert_int_equal(gphys_shape_sweep(GPHYS_SHAPE_RAY, &ray, moves, &pill, &way, &hit), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_sweep(box, &aabb, GPHYS_SHAPE_PLANE, &plane, &way, &hit), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_sweep(box, &aabb, GPHYS_SHAPE_TRIANGLE, &triangle, &way, &hit),
                     GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_shape_sweep(box, &aabb, GPHYS_SHAPE_MESH, mesh, &way, &hit), GPHYS_ERROR_UNSUPPORTED);
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
}

/* Of a frustum without eight corners the status says so; a sphere may be swept against any. */
static void frusta_without_corners_are_refused(void** state) {
    enum { FRUSTA = 6 };
    const gphys_vec3 way = {0, 0, 6};
    gphys_frustum frusta[FRUSTA];
    (void)state;
    for (int i = 0; i < FRUSTA; ++i) frusta[i] = frustum;
    frusta[0].planes[GPHYS_FRUSTUM_FAR] = no_far_plane;
    frusta[1].planes[GPHYS_FRUSTUM_FAR].distance = -0.5f;   /* nearer than the near plane: empty */
    frusta[2].planes[GPHYS_FRUSTUM_FAR].distance = -1;      /* where the near plane is: flat */
    frusta[3].planes[GPHYS_FRUSTUM_NEAR].distance = 0;      /* at the apex: a pyramid */
    frusta[4].planes[GPHYS_FRUSTUM_NEAR].distance = -1;     /* behind the apex, which cuts its corners off */
    frusta[5].planes[GPHYS_FRUSTUM_LEFT].normal.x = 1e-18f; /* corners beyond GPHYS_MAX_COORDINATE */
    for (int i = 0; i < FRUSTA; ++i) {
        for (int m = 0; m < MOVERS; ++m) {
            gphys_hit hit, before;
            gphys_penetration out, none;
            const gphys_status of_a_sphere = i == 1 ? GPHYS_NO_HIT : GPHYS_OK;
            const gphys_status swept = movers[m].type == GPHYS_SHAPE_SPHERE ? of_a_sphere : GPHYS_ERROR_UNSUPPORTED;
            memset(&hit, 0x5a, sizeof hit);
            memset(&out, 0x5a, sizeof out);
            before = hit;
            none = out;
            assert_int_equal(
                gphys_shape_sweep(GPHYS_SHAPE_FRUSTUM, &frusta[i], movers[m].type, movers[m].shape, &way, &hit), swept);
            if (swept != GPHYS_OK) assert_memory_equal(&hit, &before, sizeof hit);
            assert_int_equal(
                gphys_shape_penetration(GPHYS_SHAPE_FRUSTUM, &frusta[i], movers[m].type, movers[m].shape, &out),
                GPHYS_ERROR_UNSUPPORTED);
            assert_memory_equal(&out, &none, sizeof out);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_solid_meets_every_shape),
        cmocka_unit_test(every_solid_gets_out_of_every_shape),
        cmocka_unit_test(a_scene_is_swept),
        cmocka_unit_test(a_list_has_the_deepest_first),
        cmocka_unit_test(batches_of_shapes_equal_single_calls),
        cmocka_unit_test(bad_batches_of_shapes_are_refused),
        cmocka_unit_test(a_crowd_gets_out_in_one_call),
        cmocka_unit_test(bad_input_is_refused),
        cmocka_unit_test(frusta_without_corners_are_refused),
    };
    return cmocka_run_group_tests(tests, make_models, free_models);
}

/* How much stack calls take: on a thread whose stack is painted first, each kind of call, with what makes it
 * take most: many models one within the other, rays that all go different ways or all the same, corners and
 * edges met exactly, bodies of many particles against many models.
 *
 * GPHYS_PRINT_STACK=1 c_test_stack prints what each group took, however much. */
#define _POSIX_C_SOURCE 200112L
#include "test.h"

#include <stdio.h>
#include <stdlib.h>

/* The address sanitizer keeps variables elsewhere than on the stack. */
#if defined(__unix__) && !defined(__EMSCRIPTEN__) && !defined(__SANITIZE_ADDRESS__)
#include <pthread.h>

/* What the header states under "Threads", in KiB. GCC takes up to 7 % more for ARM than for x86-64, and
 * clang up to 40 % more than GCC: for the batches that are not of rays. The thread
 * sanitizer puts room between the variables of a function, and code that is not optimised gives each its own place. */
enum { CALL = 36, BATCH = 68, STEP = 48 };
#if defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
enum { ROOM_PER_CENT = 2000 };
#elif defined(__x86_64__) && !defined(__clang__)
enum { ROOM_PER_CENT = 93 };
#else
enum { ROOM_PER_CENT = 100 };
#endif
/* Room that the system needs at the top of a thread's stack, for its own variables among them. */
enum { SYSTEM = 16 << 10, ROOM = 4 << 20, PAINT = 0xa5 };

enum { MODELS = 600, RAYS = 256, SIDE = 16 };

typedef struct world {
    gphys_scene* scene;
    gphys_mesh* mesh;
    gphys_camera* camera;
    gphys_solver* solver;
    gphys_model_id models[MODELS];
    gphys_ray rays[RAYS];
    gphys_hit hits[RAYS];
    gphys_model_id found[MODELS];
} world;

static uint32_t state = 7;
static float uniform(float low, float high) {
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(state >> 8) / 16777216.0f;
}

static void ok(gphys_status status) {
    if (status < 0) fail_msg("%s: %s", gphys_status_name(status), gphys_last_error());
}

static gphys_transform at(float x, float y, float z) {
    gphys_transform t = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    t.position.x = x;
    t.position.y = y;
    t.position.z = z;
    return t;
}

/* A sheet of hills. */
static void make_mesh(world* w) {
    static float vertices[(SIDE + 1) * (SIDE + 1)][3];
    static uint32_t indices[6 * SIDE * SIDE];
    uint32_t i, j, count = 0;
    for (i = 0; i <= SIDE; ++i) {
        for (j = 0; j <= SIDE; ++j) {
            float* v = vertices[i * (SIDE + 1) + j];
            v[0] = (float)i - SIDE / 2;
            v[1] = uniform(-1, 1) - 3;
            v[2] = (float)j - SIDE / 2;
        }
    }
    for (i = 0; i < SIDE; ++i) {
        for (j = 0; j < SIDE; ++j) {
            const uint32_t a = i * (SIDE + 1) + j;
            const uint32_t quad[6] = {a, a + 1, a + SIDE + 1, a + 1, a + SIDE + 2, a + SIDE + 1};
            memcpy(indices + count, quad, sizeof quad);
            count += 6;
        }
    }
    ok(gphys_mesh_create(NULL, vertices[0], sizeof vertices[0], (SIDE + 1) * (SIDE + 1), indices, count, &w->mesh));
}

static void make_scene(world* w) {
    const gphys_plane ground = {{0, 1, 0}, -4};
    uint32_t i;
    ok(gphys_scene_create(NULL, &w->scene));
    for (i = 0; i < MODELS; ++i) {
        /* One in three is on a grid, so that edges and corners are met exactly; each of these is within the
         * next larger one of a geometric series. */
        const float size = ldexpf(1, -(int)(i % 60) / 3);
        gphys_transform t = at(uniform(-20, 20), uniform(-3, 9), uniform(-20, 20));
        const gphys_sphere sphere = {{0, 0, 0}, size};
        const gphys_capsule capsule = {{-size, 0, 0}, {size, 0, 0}, size / 2};
        const gphys_aabb box = {{-size, -size, -size}, {size, size, size}};
        const gphys_obb turned = {{0, 0, 0}, {size, size / 2, size}, {0.6f, 0, 0, 0.8f}};
        const gphys_triangle triangle = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
        if (i % 3 == 0) t = at(16 * size, 16 * size, 16 * size);
        if (i % 7 == 0) {
            t.rotation.y = 0.6f;
            t.rotation.w = 0.8f;
        }
        switch (i < 30 ? i % 6 : i % 5) {
            case 0:
                ok(gphys_scene_add(w->scene, GPHYS_SHAPE_SPHERE, &sphere, &t, NULL, &w->models[i]));
                break;
            case 1:
                ok(gphys_scene_add(w->scene, GPHYS_SHAPE_CAPSULE, &capsule, &t, NULL, &w->models[i]));
                break;
            case 2:
                ok(gphys_scene_add(w->scene, GPHYS_SHAPE_AABB, &box, &t, NULL, &w->models[i]));
                break;
            case 3:
                ok(gphys_scene_add(w->scene, GPHYS_SHAPE_OBB, &turned, &t, NULL, &w->models[i]));
                break;
            case 4:
                ok(gphys_scene_add(w->scene, GPHYS_SHAPE_TRIANGLE, &triangle, &t, NULL, &w->models[i]));
                break;
            case 5:
                if (i == 5) {
                    ok(gphys_scene_add(w->scene, GPHYS_SHAPE_PLANE, &ground, NULL, NULL, &w->models[i]));
                } else {
                    ok(gphys_scene_add(w->scene, GPHYS_SHAPE_MESH, w->mesh, &t, NULL, &w->models[i]));
                }
                break;
        }
    }
}

static void single_queries(world* w) {
    uint32_t i, total;
    for (i = 0; i < RAYS; ++i) {
        const gphys_sphere ball = {{uniform(-16, 16), uniform(-3, 9), uniform(-16, 16)}, uniform(0, 4)};
        const gphys_vec3 away = {uniform(-9, 9), uniform(-9, 9), uniform(-9, 9)};
        const gphys_obb box = {{0, 0, 0}, {1, 2, 3}, {0, 0.6f, 0, 0.8f}};
        gphys_nearest nearest;
        int32_t any;
        ok(gphys_scene_raycast(w->scene, &w->rays[i], ~0u, w->hits));
        ok(gphys_scene_raycast_any(w->scene, &w->rays[i], ~0u, &any));
        ok(gphys_scene_raycast_all(w->scene, &w->rays[i], ~0u, w->hits, RAYS, &total));
        ok(gphys_scene_overlap(w->scene, GPHYS_SHAPE_SPHERE, &ball, ~0u, w->found, MODELS, &total));
        ok(gphys_scene_overlap(w->scene, GPHYS_SHAPE_OBB, &box, ~0u, w->found, MODELS, &total));
        ok(gphys_scene_nearest(w->scene, &ball.center, 5, ~0u, &nearest));
        ok(gphys_scene_sweep_sphere(w->scene, &ball, &away, ~0u, w->hits));
        ok(gphys_scene_sweep(w->scene, GPHYS_SHAPE_OBB, &box, &away, ~0u, w->hits));
        ok(gphys_scene_penetration(w->scene, GPHYS_SHAPE_OBB, &box, ~0u, NULL, 0, &total));
    }
}

static void ray_batches(world* w) {
    static int32_t any[RAYS];
    static uint32_t offsets[RAYS + 1];
    static gphys_query_filter_desc filters[RAYS];
    uint32_t i;
    ok(gphys_scene_raycast_batch(w->scene, w->rays, sizeof w->rays[0], RAYS, ~0u, w->hits, sizeof w->hits[0]));
    ok(gphys_scene_raycast_any_batch(w->scene, w->rays, sizeof w->rays[0], RAYS, ~0u, any, sizeof any[0]));
    ok(gphys_scene_raycast_all_batch(w->scene, w->rays, sizeof w->rays[0], RAYS, ~0u, w->hits, RAYS, offsets));
    /* All the same way. */
    ok(gphys_scene_raycast_batch(w->scene, w->rays, 0, RAYS, ~0u, w->hits, sizeof w->hits[0]));
    for (i = 0; i < RAYS; ++i) ok(gphys_query_filter_desc_init(&filters[i], sizeof filters[i]));
    ok(gphys_scene_raycast_filtered_batch(w->scene, w->rays, sizeof w->rays[0], RAYS, filters, sizeof filters[0],
                                          w->hits, sizeof w->hits[0]));
    ok(gphys_scene_raycast_any_filtered_batch(w->scene, w->rays, sizeof w->rays[0], RAYS, filters, sizeof filters[0],
                                              any, sizeof any[0]));
}

static void other_batches(world* w) {
    static gphys_sphere balls[RAYS];
    static uint32_t offsets[RAYS + 1];
    uint32_t i;
    for (i = 0; i < RAYS; ++i) {
        const gphys_sphere ball = {{uniform(-16, 16), uniform(-3, 9), uniform(-16, 16)}, 2};
        balls[i] = ball;
    }
    ok(gphys_scene_overlap_batch(w->scene, GPHYS_SHAPE_SPHERE, balls, sizeof balls[0], RAYS, ~0u, w->found, MODELS,
                                 offsets));
}

static void nearest_batches(world* w) {
    static gphys_sphere balls[RAYS];
    static gphys_nearest nearest[RAYS];
    uint32_t i;
    for (i = 0; i < RAYS; ++i) {
        const gphys_sphere ball = {{uniform(-16, 16), uniform(-3, 9), uniform(-16, 16)}, 2};
        balls[i] = ball;
    }
    ok(gphys_scene_nearest_batch(w->scene, &balls->center, sizeof balls[0], RAYS, 5, ~0u, nearest, sizeof nearest[0]));
}

static void camera_queries(world* w) {
    const gphys_vec3 eye = {-15, 5, -15}, target = {0, 0, 0}, up = {0, 1, 0};
    gphys_frustum frustum;
    uint32_t total, offsets[2];
    ok(gphys_camera_look_at(w->camera, &eye, &target, &up));
    ok(gphys_camera_cull(w->camera, w->scene, ~0u, w->found, MODELS, &total));
    ok(gphys_camera_get_frustum(w->camera, &frustum));
    ok(gphys_scene_cull_batch(w->scene, &frustum, 0, 1, ~0u, w->found, MODELS, offsets));
    ok(gphys_camera_pick(w->camera, w->scene, 400, 300, ~0u, w->hits));
    ok(gphys_camera_pick_rectangle(w->camera, w->scene, 100, 100, 500, 400, ~0u, w->found, MODELS, &total));
}

static void shape_queries(world* w) {
    const gphys_vec3 zero = {0, 0, 0};
    gphys_frustum frustum;
    gphys_shape_type type, other;
    const void* shapes[8];
    const gphys_sphere sphere = {{0, 0, 0}, 1};
    const gphys_capsule capsule = {{-1, 0, 0}, {1, 0, 0}, 1};
    const gphys_aabb box = {{-1, -1, -1}, {1, 1, 1}};
    const gphys_obb turned = {{1, 1, 1}, {1, 1, 1}, {0.6f, 0, 0, 0.8f}};
    const gphys_plane plane = {{0, 1, 0}, 1};
    const gphys_triangle triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const gphys_shape_type types[8] = {GPHYS_SHAPE_SPHERE, GPHYS_SHAPE_CAPSULE,  GPHYS_SHAPE_AABB, GPHYS_SHAPE_OBB,
                                       GPHYS_SHAPE_PLANE,  GPHYS_SHAPE_TRIANGLE, GPHYS_SHAPE_MESH, GPHYS_SHAPE_FRUSTUM};
    uint32_t i, j, k;
    ok(gphys_camera_get_frustum(w->camera, &frustum));
    shapes[0] = &sphere, shapes[1] = &capsule, shapes[2] = &box, shapes[3] = &turned;
    shapes[4] = &plane, shapes[5] = &triangle, shapes[6] = w->mesh, shapes[7] = &frustum;
    /* What a pair does not support is refused, and takes little. */
    for (i = 0; i < 8; ++i) {
        gphys_aabb bounds;
        int32_t yes;
        gphys_nearest closest;
        type = types[i];
        (void)gphys_shape_validate(type, shapes[i]);
        (void)gphys_shape_bounds(type, shapes[i], &bounds);
        (void)gphys_shape_contains(type, shapes[i], &zero, 0, &yes);
        (void)gphys_shape_closest_point(type, shapes[i], &zero, &closest);
        for (j = 0; j < 8; ++j) {
            other = types[j];
            (void)gphys_shape_overlaps(type, shapes[i], other, shapes[j], &yes);
        }
        for (k = 0; k < RAYS; ++k) (void)gphys_shape_raycast(type, shapes[i], &w->rays[k], w->hits);
        (void)gphys_shape_sweep_sphere(type, shapes[i], &sphere, &zero, w->hits);
        for (j = 0; j < 4; ++j) {
            gphys_penetration out;
            (void)gphys_shape_sweep(type, shapes[i], types[j], shapes[j], &zero, w->hits);
            (void)gphys_shape_penetration(type, shapes[i], types[j], shapes[j], &out);
        }
    }
}

static void changes(world* w) {
    static gphys_transform transforms[MODELS];
    uint32_t frame, i, total;
    ok(gphys_scene_get_transforms(w->scene, w->models, MODELS, transforms, sizeof transforms[0]));
    for (frame = 0; frame < 5; ++frame) {
        for (i = 6; i < MODELS; ++i) transforms[i].position.x += uniform(-2, 2);
        ok(gphys_scene_set_transforms(w->scene, w->models + 6, transforms + 6, sizeof transforms[0], MODELS - 6));
        ok(gphys_scene_raycast(w->scene, w->rays, ~0u, w->hits));
    }
    ok(gphys_scene_validate(w->scene));
    ok(gphys_scene_get_models(w->scene, w->found, MODELS, &total));
}

static void creation(world* w) {
    make_mesh(w);
    make_scene(w);
    ok(gphys_camera_create(NULL, &w->camera));
    ok(gphys_solver_create(NULL, &w->solver));
}

/* Particles that targets pull through models, a rope and cloth that fall on all of it, joined. */
static void steps(world* w) {
    static gphys_vec3 points[512];
    static gphys_animation_target targets[512];
    gphys_body_desc desc;
    gphys_body_id particles, rope, cloth;
    gphys_joint_id joint;
    const gphys_transform lifted = at(0, 8, 0);
    uint32_t i;
    ok(gphys_body_desc_init(&desc, sizeof desc));
    desc.radius = 0.05f;
    for (i = 0; i < 512; ++i) {
        const gphys_vec3 p = {uniform(-15, 15), uniform(0, 9), uniform(-15, 15)};
        const gphys_animation_target target = {
            {uniform(-15, 15), uniform(0, 9), uniform(-15, 15)}, {0, 1, 0}, 1, INFINITY};
        points[i] = p;
        targets[i] = target;
    }
    ok(gphys_solver_add_particles(w->solver, &desc, points, sizeof points[0], 512, &particles));
    ok(gphys_solver_set_animation_targets(w->solver, particles, 0, 512, targets, sizeof targets[0]));
    for (i = 0; i < 64; ++i) {
        const gphys_vec3 p = {(float)i / 8, 8, 0};
        points[i] = p;
    }
    ok(gphys_solver_add_rope(w->solver, &desc, points, sizeof points[0], 64, 0.125f, &rope));
    ok(gphys_solver_add_cloth_mesh(w->solver, &desc, w->mesh, &lifted, &cloth));
    ok(gphys_solver_join(w->solver, rope, 0, cloth, 0, 0, 0, &joint));
    ok(gphys_solver_set_pinned(w->solver, rope, 63, 1, 1));
    for (i = 0; i < 20; ++i) ok(gphys_solver_step(w->solver, w->scene, 1.0f / 60));
}

static void snapshots(world* w) {
    uint32_t* words;
    uint32_t total = 0;
    gphys_solver_get_snapshot(w->solver, NULL, 0, &total);
    words = (uint32_t*)malloc(total * sizeof *words);
    assert_non_null(words);
    ok(gphys_solver_get_snapshot(w->solver, words, total, &total));
    ok(gphys_solver_restore(w->solver, words, total));
    free(words);
}

static void destruction(world* w) {
    gphys_solver_destroy(w->solver);
    gphys_camera_destroy(w->camera);
    gphys_scene_destroy(w->scene);
    gphys_mesh_destroy(w->mesh);
}

static const struct group {
    const char* name;
    void (*calls)(world*);
    size_t most; /* KiB */
} groups[] = {{"create", creation, CALL},
              {"queries", single_queries, CALL},
              {"ray batches", ray_batches, BATCH},
              {"nearest batches", nearest_batches, BATCH},
              {"other batches", other_batches, CALL},
              {"camera", camera_queries, CALL},
              {"shapes", shape_queries, CALL},
              {"changes", changes, CALL},
              {"steps", steps, STEP},
              {"snapshots", snapshots, CALL},
              {"destroy", destruction, CALL}};

typedef struct task {
    const struct group* group;
    world* w;
} task;

static void* run(void* context) {
    const task* t = (const task*)context;
    if (t->group) t->group->calls(t->w);
    return NULL;
}

/* How deep the stack of a thread that runs a group gets. */
static size_t depth(const struct group* group, world* w) {
    unsigned char* stack;
    size_t untouched = 0;
    pthread_attr_t attributes;
    pthread_t thread;
    task t;
    t.group = group;
    t.w = w;
    assert_int_equal(posix_memalign((void**)&stack, 1 << 16, ROOM), 0);
    memset(stack, PAINT, ROOM);
    pthread_attr_init(&attributes);
    assert_int_equal(pthread_attr_setstack(&attributes, stack, ROOM), 0);
    assert_int_equal(pthread_create(&thread, &attributes, run, &t), 0);
    pthread_join(thread, NULL);
    pthread_attr_destroy(&attributes);
    while (untouched < ROOM && stack[untouched] == PAINT) ++untouched;
    free(stack);
    return ROOM - untouched;
}

static void no_call_takes_more_stack_than_is_stated(void** unused) {
    static world w;
    size_t i, empty;
    (void)unused;
    for (i = 0; i < RAYS; ++i) {
        /* Every other one starts on the grid and goes through its corners. */
        const gphys_ray grid = {{-32, -32, -32}, {1, 1, 1}, INFINITY};
        const gphys_ray any = {{uniform(-20, 20), uniform(0, 9), uniform(-20, 20)},
                               {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)},
                               INFINITY};
        w.rays[i] = i % 2 == 0 ? grid : any;
    }
    empty = depth(NULL, &w);
    assert_true(empty < SYSTEM);
    for (i = 0; i < sizeof groups / sizeof groups[0]; ++i) {
        const size_t taken = depth(&groups[i], &w) - empty;
        if (getenv("GPHYS_PRINT_STACK")) {
            printf("%-16s %6lu\n", groups[i].name, (unsigned long)taken);
        } else if (taken > (groups[i].most << 10) * ROOM_PER_CENT / 100) {
            fail_msg("%s: %lu bytes of stack", groups[i].name, (unsigned long)taken);
        }
    }
}

#else
static void no_call_takes_more_stack_than_is_stated(void** unused) { (void)unused; }
#endif

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_call_takes_more_stack_than_is_stated)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Scenes with workers: what a desc may ask for, the same bits from any number of threads, and
 * errors that leave everything as it was. */
#include "test.h"

#include <stdlib.h>

enum { QUERIES = 3000, MODELS = 300, LIST = 16 * QUERIES, CUT = 500, VIEWS = 50 };

static void assert_invalid(gphys_status status) {
    assert_int_equal(status, GPHYS_ERROR_INVALID_ARGUMENT);
    assert_true(gphys_last_error()[0] != 0);
}

/* Numbers from 0 to 1, the same in every run. */
static uint32_t random_state;
static float random_number(void) {
    random_state = random_state * 1664525u + 1013904223u;
    return (float)(random_state >> 8) / 16777216.0f;
}
static gphys_vec3 random_point(float extent) {
    gphys_vec3 point;
    point.x = extent * (2 * random_number() - 1);
    point.y = extent * (2 * random_number() - 1);
    point.z = extent * (2 * random_number() - 1);
    return point;
}

/* What is asked: more than fits into a few chunks, and not a whole number of them. */
static struct {
    gphys_ray rays[QUERIES];
    gphys_segment segments[QUERIES];
    gphys_sphere spheres[QUERIES];
    gphys_vec3 points[QUERIES];
    float pixels[QUERIES][2];
    gphys_transform transforms[MODELS];
} input;

static int make_input(void** state) {
    int i;
    (void)state;
    random_state = 1;
    for (i = 0; i < QUERIES; ++i) {
        input.points[i] = random_point(12);
        input.rays[i].origin = random_point(20);
        input.rays[i].direction = random_point(1);
        input.rays[i].t_max = INFINITY;
        input.segments[i].a = random_point(15);
        input.segments[i].b = random_point(15);
        input.spheres[i].center = random_point(12);
        input.spheres[i].radius = 2 * random_number();
        input.pixels[i][0] = 800 * random_number();
        input.pixels[i][1] = 600 * random_number();
    }
    for (i = 0; i < MODELS; ++i) {
        const gphys_quat turned = {0.5f, 0.5f, 0.5f, 0.5f};
        input.transforms[i].position = random_point(10);
        input.transforms[i].rotation = turned;
        input.transforms[i].scale = 0.5f + random_number();
    }
    return 0;
}

static gphys_scene* make_scene(uint32_t worker_count, const gphys_task_runner* runner, gphys_model_id* models) {
    const gphys_aabb box = {{-1, -0.5f, -0.25f}, {1, 0.5f, 0.25f}};
    gphys_scene_desc desc;
    gphys_scene* scene = NULL;
    gphys_scene_desc_init(&desc, sizeof desc);
    desc.worker_count = worker_count;
    desc.task_runner = runner;
    assert_int_equal(gphys_scene_create(&desc, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, &box, 0, input.transforms, sizeof *input.transforms,
                                           MODELS, NULL, models),
                     GPHYS_OK);
    return scene;
}

/* Every answer of every batch. Room that lists leave is cleared: nothing is said about it. */
typedef struct answers {
    gphys_model_id models[MODELS];
    gphys_transform transforms[MODELS], world_transforms[MODELS];
    gphys_hit raycast[QUERIES], segment_test[QUERIES], sweep[QUERIES], pick[QUERIES], raycast_all[LIST];
    gphys_hit solid_sweep[QUERIES];
    gphys_hit raycast_all_cut[CUT], raycast_all_exact[LIST];
    int32_t raycast_any[QUERIES];
    gphys_nearest nearest[QUERIES];
    gphys_model_id overlap[LIST], overlap_cut[CUT], overlap_exact[LIST];
    uint32_t raycast_all_offsets[QUERIES + 1], raycast_all_cut_offsets[QUERIES + 1];
    uint32_t overlap_offsets[QUERIES + 1], overlap_cut_offsets[QUERIES + 1];
    gphys_penetration penetration[LIST];
    uint32_t penetration_offsets[QUERIES + 1];
    gphys_model_id cull[VIEWS * MODELS], cull_cut[CUT];
    uint32_t cull_offsets[VIEWS + 1], cull_cut_offsets[VIEWS + 1];
} answers;

/* Ask for lists with more room than they need, with just enough, with too little, and with none. */
static void ask_for_lists(const gphys_scene* scene, answers* all) {
    const uint32_t ray = sizeof *input.rays, sphere = sizeof *input.spheres, layers = GPHYS_ALL_LAYERS;
    uint32_t total, offsets[QUERIES + 1];
    assert_int_equal(gphys_scene_raycast_all_batch(scene, input.rays, ray, QUERIES, layers, all->raycast_all, LIST,
                                                   all->raycast_all_offsets),
                     GPHYS_OK);
    total = all->raycast_all_offsets[QUERIES];
    memset(all->raycast_all + total, 0, (LIST - total) * sizeof *all->raycast_all);
    assert_int_equal(
        gphys_scene_raycast_all_batch(scene, input.rays, ray, QUERIES, layers, all->raycast_all_exact, total, offsets),
        GPHYS_OK);
    assert_memory_equal(offsets, all->raycast_all_offsets, sizeof offsets);
    assert_memory_equal(all->raycast_all_exact, all->raycast_all, total * sizeof *all->raycast_all);
    assert_int_equal(gphys_scene_raycast_all_batch(scene, input.rays, ray, QUERIES, layers, all->raycast_all_cut, CUT,
                                                   all->raycast_all_cut_offsets),
                     GPHYS_INCOMPLETE);

    assert_int_equal(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, input.spheres, sphere, QUERIES, layers,
                                               all->overlap, LIST, all->overlap_offsets),
                     GPHYS_OK);
    total = all->overlap_offsets[QUERIES];
    memset(all->overlap + total, 0, (LIST - total) * sizeof *all->overlap);
    assert_int_equal(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, input.spheres, sphere, QUERIES, layers,
                                               all->overlap_exact, total, offsets),
                     GPHYS_OK);
    assert_memory_equal(offsets, all->overlap_offsets, sizeof offsets);
    assert_memory_equal(all->overlap_exact, all->overlap, total * sizeof *all->overlap);
    assert_int_equal(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, input.spheres, sphere, QUERIES, layers,
                                               all->overlap_cut, CUT, all->overlap_cut_offsets),
                     GPHYS_INCOMPLETE);
    assert_int_equal(
        gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, input.spheres, sphere, QUERIES, layers, NULL, 0, offsets),
        GPHYS_INCOMPLETE);
    assert_memory_equal(offsets, all->overlap_offsets, sizeof offsets);
}

static void ask_for_views(const gphys_scene* scene, gphys_camera* camera, answers* all) {
    static gphys_frustum frusta[VIEWS];
    const gphys_vec3 up = {0, 1, 0};
    uint32_t i;
    for (i = 0; i < VIEWS; ++i) {
        assert_int_equal(gphys_camera_look_at(camera, &input.rays[i].origin, &input.points[i], &up), GPHYS_OK);
        assert_int_equal(gphys_camera_get_frustum(camera, &frusta[i]), GPHYS_OK);
    }
    assert_int_equal(gphys_scene_cull_batch(scene, frusta, sizeof *frusta, VIEWS, GPHYS_ALL_LAYERS, all->cull,
                                            VIEWS * MODELS, all->cull_offsets),
                     GPHYS_OK);
    memset(all->cull + all->cull_offsets[VIEWS], 0, (VIEWS * MODELS - all->cull_offsets[VIEWS]) * sizeof *all->cull);
    assert_int_equal(gphys_scene_cull_batch(scene, frusta, sizeof *frusta, VIEWS, GPHYS_ALL_LAYERS, all->cull_cut, CUT,
                                            all->cull_cut_offsets),
                     GPHYS_INCOMPLETE);
    assert_memory_equal(all->cull_cut_offsets, all->cull_offsets, sizeof all->cull_offsets);
    assert_memory_equal(all->cull_cut, all->cull, sizeof all->cull_cut);
}

/* With so many threads from the beginning, or from `changed` on. */
static answers* ask_everything_after(uint32_t worker_count, uint32_t changed, const gphys_task_runner* runner) {
    answers* all = (answers*)calloc(1, sizeof *all);
    gphys_scene* scene = make_scene(worker_count, runner, all->models);
    const gphys_vec3 eye = {0, 0, -30}, origin = {0, 0, 0}, up = {0, 1, 0};
    gphys_camera* camera = NULL;
    const uint32_t layers = GPHYS_ALL_LAYERS;
    assert_int_equal(gphys_scene_set_worker_count(scene, changed), GPHYS_OK);
    assert_int_equal(gphys_camera_create(NULL, &camera), GPHYS_OK);
    assert_int_equal(gphys_camera_look_at(camera, &eye, &origin, &up), GPHYS_OK);

    input.transforms[0].position.x += 1;
    assert_int_equal(gphys_scene_set_transforms(scene, all->models, input.transforms, sizeof *input.transforms, MODELS),
                     GPHYS_OK);
    input.transforms[0].position.x -= 1;
    assert_int_equal(gphys_scene_get_transforms(scene, all->models, MODELS, all->transforms, sizeof *all->transforms),
                     GPHYS_OK);
    assert_int_equal(gphys_scene_get_world_transforms(scene, all->models, MODELS, all->world_transforms,
                                                      sizeof *all->world_transforms),
                     GPHYS_OK);
    assert_int_equal(gphys_scene_raycast_batch(scene, input.rays, sizeof *input.rays, QUERIES, layers, all->raycast,
                                               sizeof *all->raycast),
                     GPHYS_OK);
    assert_int_equal(gphys_scene_raycast_any_batch(scene, input.rays, sizeof *input.rays, QUERIES, layers,
                                                   all->raycast_any, sizeof *all->raycast_any),
                     GPHYS_OK);
    ask_for_lists(scene, all);
    assert_int_equal(gphys_scene_segment_test_batch(scene, input.segments, sizeof *input.segments, QUERIES, layers,
                                                    all->segment_test, sizeof *all->segment_test),
                     GPHYS_OK);
    assert_int_equal(gphys_scene_nearest_batch(scene, input.points, sizeof *input.points, QUERIES, 3, layers,
                                               all->nearest, sizeof *all->nearest),
                     GPHYS_OK);
    assert_int_equal(
        gphys_scene_sweep_sphere_batch(scene, input.spheres, sizeof *input.spheres, input.points, sizeof *input.points,
                                       QUERIES, layers, all->sweep, sizeof *all->sweep),
        GPHYS_OK);
    const gphys_obb brick = {{1, 2, 3}, {0.5f, 1, 2}, {0, 0.6f, 0, 0.8f}};
    assert_int_equal(gphys_scene_sweep_batch(scene, GPHYS_SHAPE_OBB, &brick, 0, input.points, sizeof *input.points,
                                             QUERIES, layers, all->solid_sweep, sizeof *all->solid_sweep),
                     GPHYS_OK);
    assert_int_equal(gphys_scene_penetration_batch(scene, GPHYS_SHAPE_SPHERE, input.spheres, sizeof *input.spheres,
                                                   QUERIES, layers, all->penetration, LIST, all->penetration_offsets),
                     GPHYS_OK);
    memset(all->penetration + all->penetration_offsets[QUERIES], 0,
           (LIST - all->penetration_offsets[QUERIES]) * sizeof *all->penetration);
    assert_int_equal(gphys_camera_pick_batch(camera, scene, input.pixels[0], sizeof *input.pixels, QUERIES, layers,
                                             all->pick, sizeof *all->pick),
                     GPHYS_OK);
    ask_for_views(scene, camera, all);
    assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
    return all;
}
static answers* ask_everything(uint32_t worker_count, const gphys_task_runner* runner) {
    return ask_everything_after(worker_count, worker_count, runner);
}

/* Lists that fit into CUT are not cut. */
static void assert_worth_comparing(const answers* all) {
    assert_in_range(all->overlap_offsets[QUERIES], CUT + 1, LIST);
    assert_in_range(all->penetration_offsets[QUERIES], CUT + 1, LIST);
    assert_in_range(all->raycast_all_offsets[QUERIES], CUT + 1, LIST);
    assert_in_range(all->cull_offsets[VIEWS], CUT + 1, VIEWS * MODELS);
}

typedef struct calls {
    uint32_t count, most_tasks;
} calls;

static void run_in_order(void* user, gphys_task task, void* context, uint32_t count) {
    calls* seen = (calls*)user;
    uint32_t i;
    for (i = 0; i < count; ++i) task(context, i);
    seen->count += 1;
    if (count > seen->most_tasks) seen->most_tasks = count;
}

static void run_backwards(void* user, gphys_task task, void* context, uint32_t count) {
    (void)user;
    while (count > 0) task(context, --count);
}

static void any_number_of_threads_gives_the_same_bits(void** state) {
    static const uint32_t counts[] = {0, 2, 3, 7};
    answers* expected = ask_everything(1, NULL);
    size_t i;
    (void)state;
    assert_worth_comparing(expected);
    for (i = 0; i < sizeof counts / sizeof *counts; ++i) {
        answers* all = ask_everything(counts[i], NULL);
        assert_memory_equal(all, expected, sizeof *all);
        free(all);
    }
    free(expected);
}

static void a_callers_runner_gives_the_same_bits(void** state) {
    answers *expected = ask_everything(1, NULL), *all;
    calls seen = {0, 0};
    gphys_task_runner in_order, backwards;
    (void)state;
    in_order.run = run_in_order;
    in_order.user = &seen;
    all = ask_everything(3, &in_order);
    assert_memory_equal(all, expected, sizeof *all);
    free(all);
    assert_true(seen.count > 10);
    assert_int_equal(seen.most_tasks, 3);

    backwards.run = run_backwards;
    backwards.user = NULL;
    all = ask_everything(7, &backwards);
    assert_memory_equal(all, expected, sizeof *all);
    free(all);

    seen.count = 0;
    all = ask_everything(1, &in_order); /* one thread: the caller's */
    assert_memory_equal(all, expected, sizeof *all);
    assert_int_equal(seen.count, 0);
    free(all);
    free(expected);
}

static void the_number_of_threads_may_change(void** state) {
    static const uint32_t changes[][2] = {{0, 2}, {2, 3}, {3, 1}, {2, 2}};
    answers *expected = ask_everything(1, NULL), *all;
    calls seen = {0, 0};
    gphys_task_runner in_order;
    size_t i;
    (void)state;
    for (i = 0; i < sizeof changes / sizeof *changes; ++i) {
        all = ask_everything_after(changes[i][0], changes[i][1], NULL);
        assert_memory_equal(all, expected, sizeof *all);
        free(all);
    }
    in_order.run = run_in_order;
    in_order.user = &seen;
    all = ask_everything_after(0, 5, &in_order);
    assert_memory_equal(all, expected, sizeof *all);
    assert_int_equal(seen.most_tasks, 5);
    free(all);
    free(expected);
}

static void the_number_of_threads_is_read_back(void** state) {
    gphys_model_id models[MODELS];
    calls seen = {0, 0};
    gphys_task_runner in_order;
    gphys_scene* scene;
    uint32_t workers = 7, i;
    (void)state;
    in_order.run = run_in_order;
    in_order.user = &seen;
    scene = make_scene(0, &in_order, models); /* a runner's threads there are on every platform */
    assert_int_equal(gphys_scene_get_worker_count(scene, &workers), GPHYS_OK);
    assert_int_equal(workers, 1);
    assert_invalid(gphys_scene_set_worker_count(scene, 1025));
    assert_invalid(gphys_scene_set_worker_count(NULL, 2));
    assert_invalid(gphys_scene_get_worker_count(NULL, &workers));
    assert_invalid(gphys_scene_get_worker_count(scene, NULL));
    for (i = 1024; i > 0; i /= 4) {
        assert_int_equal(gphys_scene_set_worker_count(scene, i), GPHYS_OK);
        assert_int_equal(gphys_scene_get_worker_count(scene, &workers), GPHYS_OK);
        assert_int_equal(workers, i);
    }
    assert_int_equal(gphys_scene_set_worker_count(scene, 0), GPHYS_OK);
    assert_int_equal(gphys_scene_get_worker_count(scene, &workers), GPHYS_OK);
    assert_int_equal(workers, 1);
    gphys_scene_destroy(scene);
}

/* A bad element near the end, in a chunk that another thread may check, and one before it. */
static void a_bad_element_anywhere_leaves_outputs_alone(void** state) {
    static gphys_hit hits[QUERIES], untouched[QUERIES];
    static uint32_t offsets[QUERIES + 1];
    gphys_model_id models[MODELS];
    gphys_scene* scene = make_scene(2, NULL, models);
    const gphys_ray good = input.rays[QUERIES - 1], early = input.rays[700];
    const gphys_sphere sphere = input.spheres[QUERIES - 1];
    gphys_model_id stale[MODELS];
    gphys_transform transforms[MODELS];
    char first_message[256];
    (void)state;
    memset(hits, 9, sizeof hits);
    memset(untouched, 9, sizeof untouched);
    input.rays[QUERIES - 1].t_max = -1;
    assert_invalid(gphys_scene_raycast_batch(scene, input.rays, sizeof *input.rays, QUERIES, 1, hits, sizeof *hits));
    strcpy(first_message, gphys_last_error());
    assert_non_null(strstr(first_message, "t_max"));
    assert_invalid(gphys_scene_raycast_any_batch(scene, input.rays, sizeof *input.rays, QUERIES, 1, (int32_t*)hits,
                                                 sizeof(int32_t)));
    assert_invalid(
        gphys_scene_raycast_all_batch(scene, input.rays, sizeof *input.rays, QUERIES, 1, hits, QUERIES, offsets));
    input.rays[700].origin.y = NAN; /* the first of two is the one that is told */
    assert_invalid(gphys_scene_raycast_batch(scene, input.rays, sizeof *input.rays, QUERIES, 1, hits, sizeof *hits));
    assert_string_not_equal(gphys_last_error(), first_message);
    input.rays[700] = early;
    input.rays[QUERIES - 1] = good;

    input.spheres[QUERIES - 1].radius = NAN;
    assert_invalid(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, input.spheres, sizeof *input.spheres, QUERIES,
                                             1, (gphys_model_id*)hits, QUERIES, offsets));
    input.spheres[QUERIES - 1] = sphere;
    assert_int_equal(offsets[0], 0);
    assert_memory_equal(hits, untouched, sizeof hits);

    memcpy(stale, models, sizeof models);
    stale[MODELS - 1] = 0;
    memset(transforms, 9, sizeof transforms);
    assert_int_equal(gphys_scene_get_transforms(scene, stale, MODELS, transforms, sizeof *transforms),
                     GPHYS_ERROR_INVALID_ID);
    assert_memory_equal(transforms, untouched, sizeof transforms);
    memcpy(transforms, input.transforms, sizeof transforms);
    transforms[MODELS - 1].scale = 0;
    assert_invalid(gphys_scene_set_transforms(scene, models, transforms, sizeof *transforms, MODELS));
    gphys_scene_destroy(scene);
}

/* gphys_scene_desc of release 1.0. */
typedef struct first_scene_desc {
    uint32_t struct_size;
    const gphys_allocator* allocator;
    uint32_t reserve_models;
} first_scene_desc;

static void clients_of_release_1_0_still_work(void** state) {
    struct {
        first_scene_desc known;
        unsigned char beyond[64];
    } old;
    gphys_scene* scene = NULL;
    (void)state;
    memset(&old, 0xff, sizeof old);
    assert_int_equal(gphys_scene_desc_init((gphys_scene_desc*)(void*)&old, sizeof old.known), GPHYS_OK);
    assert_int_equal(old.known.struct_size, sizeof old.known);
    assert_int_equal(old.beyond[0], 0xff);
    assert_int_equal(gphys_scene_create((gphys_scene_desc*)(void*)&old, &scene), GPHYS_OK);
    gphys_scene_destroy(scene);
    /* What such a client leaves in its padding is not taken for a field. */
    memset(&old, 0xff, sizeof old);
    old.known.struct_size = sizeof old.known;
    old.known.allocator = NULL;
    old.known.reserve_models = 0;
    assert_int_equal(gphys_scene_create((gphys_scene_desc*)(void*)&old, &scene), GPHYS_OK);
    gphys_scene_destroy(scene);
    assert_int_equal(gphys_scene_desc_init((gphys_scene_desc*)(void*)&old, sizeof old.known - 4),
                     GPHYS_ERROR_STRUCT_SIZE);
}

static void what_a_desc_asks_for_is_checked(void** state) {
    const gphys_task_runner empty = {NULL, NULL};
    gphys_scene_desc desc;
    gphys_scene* scene = NULL;
    (void)state;
    assert_int_equal(gphys_scene_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_int_equal(desc.worker_count, 0);
    assert_null(desc.task_runner);
    desc.worker_count = 1025;
    assert_invalid(gphys_scene_create(&desc, &scene));
    desc.worker_count = (uint32_t)-1;
    assert_invalid(gphys_scene_create(&desc, &scene));
    desc.worker_count = 2;
    desc.task_runner = &empty;
    assert_invalid(gphys_scene_create(&desc, &scene));
    /* A later release may give the reserved field a meaning, which this one does not know. */
    assert_int_equal(gphys_scene_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_int_equal(desc.reserved, 0);
    desc.reserved = 1;
    assert_int_equal(gphys_scene_create(&desc, &scene), GPHYS_ERROR_STRUCT_SIZE);
    assert_null(scene);
}

static void scenes_with_workers_come_and_go(void** state) {
    gphys_model_id models[MODELS];
    gphys_hit hits[600];
    int i;
    (void)state;
    for (i = 0; i < 1000; ++i) {
        gphys_scene* scene = make_scene(2 + (uint32_t)i % 3, NULL, models);
        if (i % 10 == 0) {
            assert_int_equal(
                gphys_scene_raycast_batch(scene, input.rays, sizeof *input.rays, 600, 1, hits, sizeof *hits), GPHYS_OK);
        }
        gphys_scene_destroy(scene);
    }
}

typedef struct heap {
    int left, in_use;
} heap;

static void* take(void* user, size_t size, size_t alignment) {
    heap* counted = (heap*)user;
    (void)alignment; /* malloc's suffices for what a scene holds before its first model */
    if (counted->left == 0) return NULL;
    counted->left -= 1;
    counted->in_use += 1;
    return malloc(size);
}
static void give_back(void* user, void* memory, size_t size, size_t alignment) {
    (void)size;
    (void)alignment;
    ((heap*)user)->in_use -= 1;
    free(memory);
}

static void creation_without_memory_leaks_nothing(void** state) {
    heap counted = {0, 0};
    gphys_allocator allocator;
    gphys_scene_desc desc;
    gphys_status status = GPHYS_ERROR_OUT_OF_MEMORY;
    int allowed;
    (void)state;
    allocator.allocate = take;
    allocator.release = give_back;
    allocator.user = &counted;
    gphys_scene_desc_init(&desc, sizeof desc);
    desc.allocator = &allocator;
    desc.reserve_models = 100;
    desc.worker_count = 3;
    for (allowed = 0; status != GPHYS_OK; ++allowed) {
        gphys_scene* scene = NULL;
        counted.left = allowed;
        status = gphys_scene_create(&desc, &scene);
        assert_true(status == GPHYS_OK || status == GPHYS_ERROR_OUT_OF_MEMORY);
        assert_true((scene != NULL) == (status == GPHYS_OK));
        gphys_scene_destroy(scene);
        assert_int_equal(counted.in_use, 0);
    }
    assert_in_range(allowed, 5, 20);
}

/* Without memory for other threads those that there were go on. */
static void threads_stay_if_there_is_no_memory_for_others(void** state) {
    heap counted = {1000, 0};
    gphys_allocator allocator;
    gphys_scene_desc desc;
    gphys_scene* scene = NULL;
    uint32_t workers, before;
    int allowed, in_use;
    gphys_status status = GPHYS_ERROR_OUT_OF_MEMORY;
    (void)state;
    allocator.allocate = take;
    allocator.release = give_back;
    allocator.user = &counted;
    gphys_scene_desc_init(&desc, sizeof desc);
    desc.allocator = &allocator;
    desc.worker_count = 2;
    assert_int_equal(gphys_scene_create(&desc, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_get_worker_count(scene, &before), GPHYS_OK);
    in_use = counted.in_use;
    for (allowed = 0; status != GPHYS_OK; ++allowed) {
        counted.left = allowed;
        status = gphys_scene_set_worker_count(scene, 4);
        if (status == GPHYS_OK) break;
        assert_int_equal(status, GPHYS_ERROR_OUT_OF_MEMORY);
        assert_int_equal(counted.in_use, in_use);
        assert_int_equal(gphys_scene_get_worker_count(scene, &workers), GPHYS_OK);
        assert_int_equal(workers, before);
    }
    /* Where there are no threads, there is nothing to be had. */
    assert_int_equal(allowed, before == 2 ? 2 : 0);
    gphys_scene_destroy(scene);
    assert_int_equal(counted.in_use, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(a_callers_runner_gives_the_same_bits),
        cmocka_unit_test(the_number_of_threads_may_change),
        cmocka_unit_test(the_number_of_threads_is_read_back),
        cmocka_unit_test(a_bad_element_anywhere_leaves_outputs_alone),
        cmocka_unit_test(clients_of_release_1_0_still_work),
        cmocka_unit_test(what_a_desc_asks_for_is_checked),
        cmocka_unit_test(scenes_with_workers_come_and_go),
        cmocka_unit_test(creation_without_memory_leaks_nothing),
        cmocka_unit_test(threads_stay_if_there_is_no_memory_for_others),
    };
    return cmocka_run_group_tests(tests, make_input, NULL);
}

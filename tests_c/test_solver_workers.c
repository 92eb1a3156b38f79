/* Solvers with workers: what a desc may ask for, and the same bits from any number of threads. */
#include "test.h"

#include <stdlib.h>

enum { ROPES = 40, LINKS = 12, SHEETS = 3, STEPS = 40 };

typedef struct world {
    gphys_scene* scene;
    gphys_solver* solver;
    gphys_model_id hammer;
} world;

/* Ropes of different lengths, sheets and sparks above a floor with a ball on it. */
static world make_world(uint32_t worker_count, const gphys_task_runner* runner) {
    const gphys_plane floor = {{0, 1, 0}, 0};
    const gphys_sphere ball = {{0.5f, 0.2f, 0.5f}, 0.3f};
    const gphys_aabb box = {{-0.2f, -0.2f, -0.2f}, {0.2f, 0.2f, 0.2f}};
    const gphys_vec3 u = {0.7f, 0, 0}, v = {0, 0, 0.7f};
    gphys_solver_desc desc;
    gphys_body_desc bouncing;
    gphys_vec3 points[LINKS + 1];
    gphys_model_id model;
    gphys_body_id body, previous = 0;
    gphys_joint_id joint;
    world w;
    int i, k;
    memset(&w, 0, sizeof w);
    assert_int_equal(gphys_scene_create(NULL, &w.scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add(w.scene, GPHYS_SHAPE_PLANE, &floor, NULL, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_scene_add(w.scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_scene_add(w.scene, GPHYS_SHAPE_AABB, &box, NULL, NULL, &w.hammer), GPHYS_OK);
    gphys_solver_desc_init(&desc, sizeof desc);
    desc.worker_count = worker_count;
    desc.task_runner = runner;
    desc.substeps = 3;
    desc.sleep_speed = 0.2f; /* so that some bodies come to sleep, and the hammer wakes them */
    desc.sleep_strain = 1;
    desc.sleep_time = 0.05f;
    assert_int_equal(gphys_solver_create(&desc, &w.solver), GPHYS_OK);
    for (i = 0; i < ROPES; ++i) {
        for (k = 0; k <= LINKS; ++k) {
            points[k].x = 0.03f * (float)i;
            points[k].y = 0.5f + 0.01f * (float)i;
            points[k].z = 0.05f * (float)k;
        }
        assert_int_equal(gphys_solver_add_rope(w.solver, NULL, points, 12, 2 + (uint32_t)i % LINKS, 0, &body),
                         GPHYS_OK);
        /* Some of them in pairs. */
        if (i % 8 == 7) assert_int_equal(gphys_solver_join(w.solver, body, 0, previous, 1, -1, 0, &joint), GPHYS_OK);
        previous = body;
    }
    gphys_body_desc_init(&bouncing, sizeof bouncing);
    bouncing.body_layers = 1; /* with each other, and with the sparks */
    for (i = 0; i < SHEETS; ++i) {
        const gphys_vec3 corner = {0.1f, 0.6f + 0.1f * (float)i, 0.1f};
        assert_int_equal(gphys_solver_add_cloth(w.solver, &bouncing, &corner, &u, &v, 8, 6, &body), GPHYS_OK);
        if (i == 1) assert_int_equal(gphys_solver_join(w.solver, body, 3, previous, 0, -1, 0, &joint), GPHYS_OK);
    }
    bouncing.restitution = 0.8f;
    bouncing.self_collision = 1;
    assert_int_equal(gphys_solver_add_particles(w.solver, &bouncing, points, 12, LINKS, &body), GPHYS_OK);
    return w;
}

static void step(const world* w, int frame) {
    const gphys_transform place = {{-1 + 0.05f * (float)frame, 0.2f, 0.3f}, {0, 0, 0, 1}, 1};
    assert_int_equal(gphys_scene_set_transforms(w->scene, &w->hammer, &place, sizeof place, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_step(w->solver, w->scene, 1.0f / 60), GPHYS_OK);
}

static void end_world(const world* w) {
    gphys_solver_destroy(w->solver);
    gphys_scene_destroy(w->scene);
}

typedef struct outcome {
    uint32_t hash[STEPS][2];
    uint32_t contacts, most_asleep;
} outcome;

static void run(uint32_t worker_count, const gphys_task_runner* runner, outcome* out) {
    const world w = make_world(worker_count, runner);
    gphys_solver_stats stats;
    uint32_t asleep;
    int i;
    out->most_asleep = 0;
    for (i = 0; i < STEPS; ++i) {
        step(&w, i);
        assert_int_equal(gphys_solver_get_hash(w.solver, out->hash[i]), GPHYS_OK);
        gphys_solver_get_sleeping(w.solver, NULL, 0, &asleep);
        if (asleep > out->most_asleep) out->most_asleep = asleep;
    }
    assert_int_equal(gphys_solver_get_stats(w.solver, 0, &stats), GPHYS_OK);
    out->contacts = stats.contact_count;
    end_world(&w);
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

static void any_number_of_threads_gives_the_same_bits(void** state) {
    static const uint32_t counts[] = {0, 2, 3, 7};
    outcome expected, other;
    size_t i;
    (void)state;
    run(1, NULL, &expected);
    assert_true(expected.contacts > 50);
    assert_true(expected.most_asleep > 0);
    for (i = 0; i < sizeof counts / sizeof *counts; ++i) {
        run(counts[i], NULL, &other);
        assert_memory_equal(&other, &expected, sizeof other);
    }
}

static void a_callers_runner_gives_the_same_bits(void** state) {
    outcome expected, other;
    calls seen = {0, 0};
    gphys_task_runner in_order;
    (void)state;
    run(1, NULL, &expected);
    in_order.run = run_in_order;
    in_order.user = &seen;
    run(1, &in_order, &other); /* one thread: the caller's */
    assert_memory_equal(&other, &expected, sizeof other);
    assert_int_equal(seen.count, 0);
    run(3, &in_order, &other);
    assert_memory_equal(&other, &expected, sizeof other);
    assert_true(seen.count >= STEPS);
    assert_int_equal(seen.most_tasks, 3);
}

/* From step to step as many as the pattern says, more than before or fewer. */
static void the_number_of_threads_may_change_from_step_to_step(void** state) {
    static const uint32_t counts[] = {2, 7, 1, 3, 3};
    outcome expected;
    calls seen = {0, 0};
    gphys_task_runner in_order;
    uint32_t with_runner, workers = 9, hash[2];
    int i;
    (void)state;
    run(1, NULL, &expected);
    in_order.run = run_in_order;
    in_order.user = &seen;
    for (with_runner = 0; with_runner < 2; ++with_runner) {
        const world w = make_world(1, with_runner ? &in_order : NULL);
        for (i = 0; i < STEPS; ++i) {
            assert_int_equal(gphys_solver_set_worker_count(w.solver, counts[i % 5]), GPHYS_OK);
            step(&w, i);
            assert_int_equal(gphys_solver_get_hash(w.solver, hash), GPHYS_OK);
            assert_memory_equal(hash, expected.hash[i], sizeof hash);
        }
        assert_int_equal(gphys_solver_get_worker_count(w.solver, &workers), GPHYS_OK);
        if (with_runner) assert_int_equal(workers, 3);
        assert_int_equal(gphys_solver_set_worker_count(w.solver, 1025), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_solver_set_worker_count(NULL, 1), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_solver_get_worker_count(NULL, &workers), GPHYS_ERROR_INVALID_ARGUMENT);
        assert_int_equal(gphys_solver_get_worker_count(w.solver, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
        end_world(&w);
    }
    assert_int_equal(seen.most_tasks, 7);
}

static void a_snapshot_of_one_thread_goes_on_with_two(void** state) {
    const world one = make_world(1, NULL), two = make_world(2, NULL);
    uint32_t* words;
    uint32_t total = 0, hash[2], other[2];
    int i;
    (void)state;
    for (i = 0; i < STEPS / 2; ++i) step(&one, i);
    assert_int_equal(gphys_solver_get_snapshot(one.solver, NULL, 0, &total), GPHYS_INCOMPLETE);
    words = (uint32_t*)malloc(4 * (size_t)total);
    assert_int_equal(gphys_solver_get_snapshot(one.solver, words, total, &total), GPHYS_OK);
    assert_int_equal(gphys_solver_restore(two.solver, words, total), GPHYS_OK);
    free(words);
    step(&two, STEPS / 2 - 1); /* brings its scene's hammer there */
    assert_int_equal(gphys_solver_get_hash(two.solver, other), GPHYS_OK);
    step(&one, STEPS / 2 - 1);
    assert_int_equal(gphys_solver_get_hash(one.solver, hash), GPHYS_OK);
    assert_memory_equal(hash, other, sizeof hash);
    end_world(&one);
    end_world(&two);
}

/* As it was in release 1.0. */
typedef struct first_solver_desc {
    uint32_t struct_size;
    const gphys_allocator* allocator;
    gphys_vec3 gravity;
    uint32_t substeps;
    float fixed_step;
    uint32_t max_steps;
} first_solver_desc;

static void clients_of_release_1_0_still_work(void** state) {
    struct {
        first_solver_desc known;
        unsigned char beyond[64];
    } old;
    gphys_solver* solver = NULL;
    (void)state;
    memset(&old, 0xff, sizeof old);
    assert_int_equal(gphys_solver_desc_init((gphys_solver_desc*)(void*)&old, sizeof old.known), GPHYS_OK);
    assert_int_equal(old.known.struct_size, sizeof old.known);
    assert_int_equal(old.beyond[0], 0xff);
    assert_int_equal(gphys_solver_create((gphys_solver_desc*)(void*)&old, &solver), GPHYS_OK);
    gphys_solver_destroy(solver);
    assert_int_equal(gphys_solver_desc_init((gphys_solver_desc*)(void*)&old, sizeof old.known - 4),
                     GPHYS_ERROR_STRUCT_SIZE);
}

static void what_a_desc_asks_for_is_checked(void** state) {
    const gphys_task_runner empty = {NULL, NULL};
    struct {
        gphys_solver_desc desc;
        uint32_t field, more;
    } later;
    gphys_solver_desc desc;
    gphys_solver* solver = NULL;
    (void)state;
    assert_int_equal(gphys_solver_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_int_equal(desc.worker_count, 0);
    assert_null(desc.task_runner);
    desc.worker_count = 1025;
    assert_int_equal(gphys_solver_create(&desc, &solver), GPHYS_ERROR_INVALID_ARGUMENT);
    desc.worker_count = 2;
    desc.task_runner = &empty;
    assert_int_equal(gphys_solver_create(&desc, &solver), GPHYS_ERROR_INVALID_ARGUMENT);
    /* A later release may give what follows a meaning, which this one does not know. */
    assert_int_equal(gphys_solver_desc_init(&later.desc, sizeof later), GPHYS_OK);
    assert_int_equal(later.desc.max_work, 0);
    later.field = 1;
    assert_int_equal(gphys_solver_create(&later.desc, &solver), GPHYS_ERROR_STRUCT_SIZE);
    assert_null(solver);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(a_callers_runner_gives_the_same_bits),
        cmocka_unit_test(the_number_of_threads_may_change_from_step_to_step),
        cmocka_unit_test(a_snapshot_of_one_thread_goes_on_with_two),
        cmocka_unit_test(clients_of_release_1_0_still_work),
        cmocka_unit_test(what_a_desc_asks_for_is_checked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Calls in the floating-point modes that a host may have set: the same bits as in the standard ones, and the thread
 * keeps its modes. Only calls run in a mode; what goes in is made, and what comes out is compared, in the standard
 * ones. */
#include "test.h"

#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

enum { MODELS = 60, RAYS = 400, STEPS = 24 };

typedef struct mode {
    const char* name;
    int rounding, flush;
} mode;

static const mode modes[] = {
    {"to nearest", FE_TONEAREST, 0},
#ifndef __EMSCRIPTEN__ /* names the modes of x86, and has only this one */
#ifdef FE_UPWARD
    {"up", FE_UPWARD, 0},
#endif
#ifdef FE_DOWNWARD
    {"down", FE_DOWNWARD, 0},
#endif
#ifdef FE_TOWARDZERO
    {"to zero", FE_TOWARDZERO, 0},
    {"to zero, denormals flushed", FE_TOWARDZERO, 1},
#endif
#endif
    {"denormals flushed", FE_TONEAREST, 1},
};
enum { MODE_COUNT = sizeof modes / sizeof *modes };

static void set_flush(int flush) {
#if defined(__SSE__)
    const unsigned both = 0x8040; /* flush to zero, denormals are zero */
    _mm_setcsr(flush ? _mm_getcsr() | both : _mm_getcsr() & ~both);
#elif defined(__aarch64__)
    unsigned long long fpcr;
    __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
    fpcr = flush ? fpcr | 1u << 24 : fpcr & ~(1ull << 24);
    __asm__ volatile("msr fpcr, %0" : : "r"(fpcr));
#else
    (void)flush;
#endif
}
static int get_rounding(void) {
#if defined(__SSE__)
    return (int)(_mm_getcsr() >> 3 & 0xc00); /* fegetround looks at the x87 */
#else
    return fegetround();
#endif
}
static int is_flushed(void) {
#if defined(__SSE__)
    return (_mm_getcsr() & 0x8040) == 0x8040;
#elif defined(__aarch64__)
    unsigned long long fpcr;
    __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
    return (fpcr >> 24 & 1) != 0;
#else
    return 0;
#endif
}
static void set_mode(const mode* m) {
    assert_int_equal(fesetround(m->rounding), 0);
    set_flush(m->flush);
}

static const mode* present = modes;
static int rounding_after, flushed_after;
static void enter(void) { set_mode(present); }
static void leave(void) {
    rounding_after = get_rounding();
    flushed_after = is_flushed();
    set_mode(&modes[0]);
}
/* A call in the present mode. */
#define IN_MODE(call)                                                   \
    do {                                                                \
        gphys_status status_;                                           \
        enter();                                                        \
        status_ = (call);                                               \
        leave();                                                        \
        assert_int_equal(status_, GPHYS_OK);                            \
        assert_int_equal(rounding_after, present->rounding);            \
        if (present->flush) assert_int_equal(flushed_after, can_flush); \
    } while (0)
static int can_flush;

/* Numbers from -1 to 1, the same in every run. */
static uint32_t random_state;
static float random_number(void) {
    random_state = random_state * 1664525u + 1013904223u;
    return (float)(random_state >> 8) / 8388608.0f - 1;
}
static gphys_vec3 random_point(float extent) {
    gphys_vec3 p;
    p.x = extent * random_number();
    p.y = extent * random_number();
    p.z = extent * random_number();
    return p;
}

static struct {
    gphys_transform transforms[MODELS];
    gphys_ray rays[RAYS];
} input;

static int make_input(void** state) {
    int i;
    (void)state;
    set_flush(1);
    can_flush = is_flushed();
    set_flush(0);
    random_state = 1;
    for (i = 0; i < MODELS; ++i) {
        const gphys_quat turned = {0.5f, 0.5f, 0.5f, 0.5f};
        input.transforms[i].position = random_point(10);
        input.transforms[i].rotation = turned;
        input.transforms[i].scale = 1.5f + random_number();
    }
    for (i = 0; i < RAYS; ++i) {
        input.rays[i].origin = random_point(20);
        input.rays[i].direction = random_point(1);
        input.rays[i].t_max = INFINITY;
    }
    /* One that is lost where denormal numbers are taken for zero. */
    input.rays[0].origin = input.transforms[0].position;
    input.rays[0].direction.x = 1e-40f;
    input.rays[0].direction.y = input.rays[0].direction.z = 0;
    return 0;
}

typedef struct answers {
    gphys_hit hits[RAYS], batch[RAYS];
    uint32_t hashes[STEPS][2];
} answers;

static void cast_rays(const gphys_scene* scene, answers* all) {
    int i;
    for (i = 0; i < RAYS; ++i) {
        gphys_status status;
        enter();
        status = gphys_scene_raycast(scene, &input.rays[i], GPHYS_ALL_LAYERS, &all->hits[i]);
        leave();
        assert_true(status == GPHYS_OK || status == GPHYS_NO_HIT);
        assert_int_equal(rounding_after, present->rounding);
    }
    IN_MODE(gphys_scene_raycast_batch(scene, input.rays, sizeof *input.rays, RAYS, GPHYS_ALL_LAYERS, all->batch,
                                      sizeof *all->batch));
}

/* A rope and a cloth fall on the models. */
static void move_bodies(const gphys_scene* scene, const gphys_task_runner* runner, answers* all) {
    const gphys_vec3 corner = {-2, 12, -2}, u = {4, 0, 0.25f}, v = {0, 0.5f, 4},
                     rope[] = {{3, 12, 1}, {3.5f, 12, 1}, {4, 12, 1}};
    gphys_solver_desc desc;
    gphys_body_desc body;
    gphys_body_id id;
    gphys_solver* solver = NULL;
    int i;
    assert_int_equal(gphys_solver_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.worker_count = 3;
    desc.task_runner = runner;
    assert_int_equal(gphys_body_desc_init(&body, sizeof body), GPHYS_OK);
    body.radius = 0.125f;
    IN_MODE(gphys_solver_create(&desc, &solver));
    IN_MODE(gphys_solver_add_cloth(solver, &body, &corner, &u, &v, 12, 12, &id));
    IN_MODE(gphys_solver_add_rope(solver, &body, rope, sizeof *rope, 3, 0.375f, &id));
    for (i = 0; i < STEPS; ++i) {
        IN_MODE(gphys_solver_step(solver, scene, 1.0f / 64));
        IN_MODE(gphys_solver_get_hash(solver, all->hashes[i]));
    }
    gphys_solver_destroy(solver);
}

static answers* ask(const mode* m, const gphys_task_runner* runner) {
    const gphys_aabb box = {{-1, -0.5f, -0.25f}, {1, 0.5f, 0.25f}};
    answers* all = (answers*)calloc(1, sizeof *all);
    gphys_scene_desc desc;
    gphys_scene* scene = NULL;
    gphys_model_id ids[MODELS];
    assert_non_null(all);
    assert_int_equal(gphys_scene_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.worker_count = 3;
    desc.task_runner = runner;
    present = m;
    IN_MODE(gphys_scene_create(&desc, &scene));
    IN_MODE(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, &box, 0, input.transforms, sizeof *input.transforms, MODELS,
                                  NULL, ids));
    cast_rays(scene, all);
    move_bodies(scene, runner, all);
    gphys_scene_destroy(scene);
    return all;
}

static void calls_give_the_same_bits_in_every_mode(void** state) {
    answers* expected = ask(&modes[0], NULL);
    int i;
    (void)state;
    assert_true(expected->hits[0].model != 0);
    for (i = 1; i < MODE_COUNT; ++i) {
        answers* all = ask(&modes[i], NULL);
        if (memcmp(all, expected, sizeof *all) != 0) fprintf(stderr, "rounding %s:\n", modes[i].name);
        assert_memory_equal(all, expected, sizeof *all);
        free(all);
    }
    free(expected);
}

/* Its threads have other modes than the one that calls. */
static void run_in_mode(void* user, gphys_task task, void* context, uint32_t count) {
    const mode before = *present;
    uint32_t i;
    set_mode((const mode*)user);
    for (i = 0; i < count; ++i) task(context, i);
    set_mode(&before);
}

static void tasks_give_the_same_bits_in_every_mode(void** state) {
    answers* expected = ask(&modes[0], NULL);
    int i;
    (void)state;
    for (i = 1; i < MODE_COUNT; ++i) {
        mode others = modes[i];
        gphys_task_runner runner;
        answers* all;
        runner.run = run_in_mode;
        runner.user = &others;
        all = ask(&modes[0], &runner);
        assert_memory_equal(all, expected, sizeof *all);
        free(all);
    }
    free(expected);
}

/* Hosts that look for exceptions find those of a call in any mode. */
static void exceptions_stay_raised(void** state) {
#if defined(FE_INEXACT) && defined(FE_UPWARD)
    const gphys_sphere ball = {{0.1f, 0.2f, 0.3f}, 0.7f};
    const gphys_ray ray = {{-5, 0.3f, 0.2f}, {1, 0.01f, 0.02f}, INFINITY};
    gphys_hit hit;
    int before, after;
    present = &modes[1];
    enter();
    feclearexcept(FE_ALL_EXCEPT);
    before = fetestexcept(FE_INEXACT);
    gphys_shape_raycast(GPHYS_SHAPE_SPHERE, &ball, &ray, &hit);
    after = fetestexcept(FE_INEXACT);
    leave();
    assert_int_equal(before, 0);
    assert_true(after != 0);
#endif
    (void)state;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calls_give_the_same_bits_in_every_mode),
        cmocka_unit_test(tasks_give_the_same_bits_in_every_mode),
        cmocka_unit_test(exceptions_stay_raised),
    };
    return cmocka_run_group_tests(tests, make_input, NULL);
}

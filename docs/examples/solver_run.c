/* Running a solver: steps, settings, threads, sleep, and what the motion is like. The
 * ball of these examples is a particle of 1 kg with a radius of 0.1 m, which lies on
 * the ground at y = 0. */
#include <math.h>

#include "check.h"

/* One step of a sixtieth of a second, with the models of a scene. The ball that lay on
 * the ground still lies there. */
static void step(gphys_solver* solver, const gphys_scene* scene, gphys_body_id ball) {
    gphys_vec3 place;
    MUST(gphys_solver_step(solver, scene, 1.0f / 60));
    MUST(gphys_solver_get_positions(solver, ball, 0, 1, &place, sizeof place));
    EXPECT(fabsf(place.y - 0.1f) < 1e-3f); /* its radius is 0.1 m */
}

/* A frame of 40 ms: two steps of a sixtieth, and what is left of it, 0.4 of a step, is
 * kept for the next frame. */
static void advance(gphys_solver* solver, const gphys_scene* scene) {
    uint32_t steps;
    float leftover, owed;
    MUST(gphys_solver_advance(solver, scene, 0.040f, &steps, &leftover));
    /* The same number later on, such as for a second view. */
    MUST(gphys_solver_get_leftover(solver, &owed));
    EXPECT(steps == 2 && fabsf(leftover - 0.4f) < 1e-5f && owed == leftover);
}

/* A slider for gravity: that of Mars. */
static void set_gravity(gphys_solver* solver) {
    const gphys_vec3 mars = {0, -3.71f, 0};
    gphys_solver_settings settings;
    MUST(gphys_solver_set_gravity(solver, &mars));
    MUST(gphys_solver_get_settings(solver, &settings));
    EXPECT(settings.gravity.y == -3.71f);
}

/* More substeps for a scene with a heavy load on a rope, and how many a body took in
 * the last step. */
static void substeps(gphys_solver* solver, gphys_body_id rope) {
    uint32_t taken;
    MUST(gphys_solver_set_substeps(solver, 20));
    MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
    MUST(gphys_solver_get_substeps(solver, rope, &taken));
    EXPECT(taken == 20);
}

/* All settings at once: read, changed, given back. Here steps of 1/120 s, and rest
 * below 2 cm/s. */
static void settings(gphys_solver* solver) {
    gphys_solver_settings settings;
    MUST(gphys_solver_get_settings(solver, &settings));
    settings.fixed_step = 1.0f / 120;
    settings.sleep_speed = 0.02f;
    MUST(gphys_solver_set_settings(solver, &settings));
    MUST(gphys_solver_get_settings(solver, &settings));
    EXPECT(settings.fixed_step == 1.0f / 120 && settings.sleep_speed == 0.02f);
}

/* The user's setting for threads. The motion has the same bits for every number of
 * them. */
static void workers(gphys_solver* solver) {
    uint32_t count;
    MUST(gphys_solver_set_worker_count(solver, 2));
    MUST(gphys_solver_get_worker_count(solver, &count));
    EXPECT(count == 2);
}

/* The ball lies on the ground and sleeps after a second. A door that slams nearby is to
 * shake it: it is woken. */
static void sleep(gphys_solver* solver, const gphys_scene* scene, gphys_body_id ball) {
    gphys_body_id bodies[8];
    uint32_t total;
    for (int i = 0; i < 60; ++i) MUST(gphys_solver_step(solver, scene, 1.0f / 60));
    MUST(gphys_solver_get_sleeping(solver, bodies, 8, &total));
    EXPECT(total == 1 && bodies[0] == ball);
    MUST(gphys_solver_wake(solver, ball));
    MUST(gphys_solver_get_sleeping(solver, bodies, 8, &total));
    EXPECT(total == 0);
}

/* Counts and energies: a ball of 1 kg that moves at 2 m/s has half of 1 kg times (2
 * m/s)^2, so 2 J. */
static void stats(gphys_solver* solver, gphys_body_id ball) {
    const gphys_vec3 velocity = {2, 0, 0};
    gphys_solver_stats stats;
    MUST(gphys_solver_set_velocities(solver, ball, 0, 1, &velocity, 0));
    MUST(gphys_solver_get_stats(solver, ball, &stats));
    EXPECT(stats.particle_count == 1 && stats.pinned_count == 0 &&
           stats.constraint_count == 0);
    EXPECT(stats.kinetic_energy == 2);
}

/* The player has gone 5 km along x: the origin follows. The ball stays where it is in
 * the world, 5 km behind. */
static void origin(gphys_solver* solver, gphys_body_id ball) {
    const double player[3] = {5000, 0, 0};
    double now[3];
    gphys_vec3 place;
    MUST(gphys_solver_set_origin(solver, player));
    MUST(gphys_solver_get_origin(solver, now));
    MUST(gphys_solver_get_positions(solver, ball, 0, 1, &place, sizeof place));
    EXPECT(now[0] == 5000 && place.x == -5000);
}

static gphys_solver* create(void) {
    gphys_solver_desc desc;
    gphys_solver* solver = NULL;
    MUST(gphys_solver_desc_init(&desc, sizeof desc));
    desc.sleep_speed = 0.01f;
    MUST(gphys_solver_create(&desc, &solver));
    return solver;
}

static gphys_body_id add_ball(gphys_solver* solver) {
    const gphys_vec3 place = {0, 0.1f, 0};
    gphys_body_desc desc;
    gphys_body_id ball;
    MUST(gphys_body_desc_init(&desc, sizeof desc));
    desc.radius = 0.1f;
    MUST(gphys_solver_add_particles(solver, &desc, &place, sizeof place, 1, &ball));
    return ball;
}

int main(void) {
    const gphys_plane ground = {{0, 1, 0}, 0};
    const gphys_vec3 points[3] = {{0, 5, 0}, {1, 5, 0}, {2, 5, 0}};
    gphys_scene* scene = NULL;
    gphys_model_id model;
    gphys_body_id rope;
    MUST(gphys_scene_create(NULL, &scene));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &ground, NULL, NULL, &model));

    gphys_solver* solver = create();
    gphys_body_id ball = add_ball(solver);
    step(solver, scene, ball);
    advance(solver, scene);
    sleep(solver, scene, ball);
    stats(solver, ball);
    gphys_solver_destroy(solver);

    solver = create();
    ball = add_ball(solver);
    MUST(gphys_solver_add_rope(solver, NULL, points, sizeof points[0], 3, 0, &rope));
    set_gravity(solver);
    settings(solver);
    workers(solver);
    substeps(solver, rope);
    gphys_solver_destroy(solver);

    solver = create();
    origin(solver, add_ball(solver));
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return 0;
}

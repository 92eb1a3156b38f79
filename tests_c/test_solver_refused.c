/* Calls that are refused leave the solver as it was: its hash, and who sleeps. */
#include "test.h"

#define BAD GPHYS_ERROR_INVALID_ARGUMENT
#define STALE GPHYS_ERROR_INVALID_ID
#define NONE 0xdeadbeef

typedef struct {
    gphys_solver* solver;
    gphys_scene *scene, *elsewhere; /* of another origin */
    gphys_model_id floor;
    gphys_body_id rope, sheet, removed;
    gphys_constraint_id cut;
    gphys_joint_id joint;
    uint32_t hash[2], asleep;
} fixture;

static uint32_t sleeping(const gphys_solver* solver) {
    uint32_t total = 0;
    gphys_solver_get_sleeping(solver, NULL, 0, &total);
    return total;
}

/* A rope, a sheet and a rope joined to it that lie on a floor and sleep. */
static int set_up(void** state) {
    static fixture f;
    static const gphys_plane floor = {{0, 1, 0}, 0};
    static const gphys_vec3 points[4] = {{0, 0.011f, 0}, {0.1f, 0.011f, 0}, {0.2f, 0.011f, 0}, {0.3f, 0.011f, 0}};
    static const gphys_vec3 corner = {0, 0.011f, 1}, u = {0.3f, 0, 0}, v = {0, 0, 0.3f};
    static const gphys_vec3 far_points[2] = {{0.5f, 0.011f, 1}, {0.6f, 0.011f, 1}};
    const double origin[3] = {1, 0, 0};
    gphys_solver_desc desc;
    gphys_body_desc body;
    gphys_body_id other;
    gphys_constraint_info link;
    uint32_t total;
    int i;
    memset(&f, 0, sizeof f);
    gphys_solver_desc_init(&desc, sizeof desc);
    gphys_body_desc_init(&body, sizeof body);
    desc.sleep_speed = 0.05f;
    desc.sleep_strain = 0.1f;
    desc.sleep_time = 0.1f;
    assert_int_equal(gphys_solver_create(&desc, &f.solver), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &f.scene), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &f.elsewhere), GPHYS_OK);
    assert_int_equal(gphys_scene_set_origin(f.elsewhere, origin), GPHYS_OK);
    assert_int_equal(gphys_scene_add(f.scene, GPHYS_SHAPE_PLANE, &floor, NULL, NULL, &f.floor), GPHYS_OK);
    assert_int_equal(gphys_solver_add_rope(f.solver, &body, points, 12, 4, 0, &f.rope), GPHYS_OK);
    assert_int_equal(gphys_solver_add_cloth(f.solver, &body, &corner, &u, &v, 4, 4, &f.sheet), GPHYS_OK);
    assert_int_equal(gphys_solver_add_rope(f.solver, &body, far_points, 12, 2, 0, &other), GPHYS_OK);
    assert_int_equal(gphys_solver_add_particles(f.solver, &body, points, 12, 1, &f.removed), GPHYS_OK);
    assert_int_equal(gphys_solver_remove_body(f.solver, f.removed), GPHYS_OK);
    assert_int_equal(gphys_solver_join(f.solver, f.sheet, 3, other, 0, -1, 0, &f.joint), GPHYS_OK);
    assert_int_equal(gphys_solver_get_constraints(f.solver, f.sheet, &link, 1, &total), GPHYS_INCOMPLETE);
    f.cut = link.id;
    assert_int_equal(gphys_solver_remove_constraint(f.solver, f.sheet, f.cut), GPHYS_OK);
    for (i = 0; i < 120; ++i) assert_int_equal(gphys_solver_step(f.solver, f.scene, 1 / 60.0f), GPHYS_OK);
    f.asleep = sleeping(f.solver);
    assert_int_equal(f.asleep, 3);
    assert_int_equal(gphys_solver_get_hash(f.solver, f.hash), GPHYS_OK);
    *state = &f;
    return 0;
}

static int tear_down(void** state) {
    fixture* f = *state;
    gphys_solver_destroy(f->solver);
    gphys_scene_destroy(f->scene);
    gphys_scene_destroy(f->elsewhere);
    return 0;
}

/* The call fails so, and nothing has changed. */
#define REFUSED(call, wanted)                                                \
    do {                                                                     \
        uint32_t hash_[2];                                                   \
        assert_int_equal(call, wanted);                                      \
        assert_int_equal(gphys_solver_get_hash(f->solver, hash_), GPHYS_OK); \
        assert_memory_equal(hash_, f->hash, sizeof hash_);                   \
        assert_int_equal(sleeping(f->solver), f->asleep);                    \
    } while (0)

static void test_constraints(void** state) {
    fixture* f = *state;
    gphys_solver* s = f->solver;
    static const uint32_t twice[2] = {1, 1}, outside[2] = {0, 4}, two[2] = {0, 1};
    gphys_constraint_id link = 0;
    gphys_constraint_info kept;
    gphys_joint_id joint = 0;
    gphys_cluster_id cluster = 0;
    gphys_break made;
    uint32_t total;
    const float force = 1, negative = -1;
    REFUSED(gphys_solver_remove_constraint(s, f->rope, NONE), STALE);
    REFUSED(gphys_solver_remove_constraint(s, f->sheet, f->cut), STALE);
    REFUSED(gphys_solver_remove_constraint(s, f->removed, f->cut), STALE);
    REFUSED(gphys_solver_set_constraint_damping(s, f->rope, NONE, 1), STALE);
    REFUSED(gphys_solver_set_constraint_damping(s, f->sheet, f->cut, 1), STALE);
    REFUSED(gphys_solver_set_constraint_damping(s, f->sheet, f->cut, -1), BAD);
    REFUSED(gphys_solver_add_distance(s, f->rope, 0, 0, -1, 0, &link), BAD);
    REFUSED(gphys_solver_add_distance(s, f->rope, 0, 4, -1, 0, &link), BAD);
    REFUSED(gphys_solver_add_distance(s, f->rope, 0, 2, NAN, 0, &link), BAD);
    REFUSED(gphys_solver_add_distance(s, f->rope, 0, 2, -1, -1, &link), BAD);
    REFUSED(gphys_solver_add_distance(s, f->rope, 0, 2, -1, 0, NULL), BAD);
    REFUSED(gphys_solver_add_max_distance(s, f->rope, 0, 2, -1, NAN, &link), BAD);
    REFUSED(gphys_solver_set_volume(s, f->rope, 1, 0), GPHYS_ERROR_UNSUPPORTED);
    REFUSED(gphys_solver_set_volume(s, f->sheet, -1, 0), GPHYS_ERROR_UNSUPPORTED);
    REFUSED(gphys_solver_set_volume(s, f->sheet, 0, 0), BAD);
    REFUSED(gphys_solver_set_volume(s, f->removed, 1, 0), STALE);
    REFUSED(gphys_solver_add_cluster(s, f->rope, twice, 2, &cluster), BAD);
    REFUSED(gphys_solver_add_cluster(s, f->rope, outside, 2, &cluster), BAD);
    REFUSED(gphys_solver_add_cluster(s, f->rope, two, 1, &cluster), BAD);
    REFUSED(gphys_solver_add_cluster(s, f->rope, two, 2, NULL), BAD);
    REFUSED(gphys_solver_add_cluster(s, f->removed, two, 2, &cluster), STALE);
    REFUSED(gphys_solver_remove_cluster(s, f->rope, NONE), STALE);
    REFUSED(gphys_solver_remove_cluster(s, f->removed, NONE), STALE);
    REFUSED(gphys_solver_break_constraint(s, f->sheet, f->cut, &made), STALE);
    REFUSED(gphys_solver_break_constraint(s, f->removed, f->cut, &made), STALE);
    REFUSED(gphys_solver_set_breaking_forces(s, f->sheet, &f->cut, &force, 0, 1), STALE);
    REFUSED(gphys_solver_set_breaking_forces(s, f->removed, NULL, NULL, 0, 0), STALE);
    REFUSED(gphys_solver_set_breaking_forces(s, f->sheet, NULL, &force, 0, 1), BAD);
    assert_int_equal(gphys_solver_get_constraints(s, f->sheet, &kept, 1, &total), GPHYS_INCOMPLETE);
    REFUSED(gphys_solver_set_breaking_forces(s, f->sheet, &kept.id, &negative, 3, 1), BAD);
    REFUSED(gphys_solver_join(s, f->rope, 0, f->rope, 1, -1, 0, &joint), BAD);
    REFUSED(gphys_solver_join(s, f->rope, 0, f->sheet, 99, -1, 0, &joint), BAD);
    REFUSED(gphys_solver_join(s, f->rope, 0, f->removed, 0, -1, 0, &joint), STALE);
    REFUSED(gphys_solver_join(s, f->rope, 0, f->sheet, 0, NAN, 0, &joint), BAD);
    REFUSED(gphys_solver_join(s, f->rope, 0, f->sheet, 0, -1, 0, NULL), BAD);
    REFUSED(gphys_solver_unjoin(s, NONE), STALE);
}

static void test_particles(void** state) {
    fixture* f = *state;
    gphys_solver* s = f->solver;
    static const gphys_vec3 bad[2] = {{0, 0, 0}, {NAN, 0, 0}};
    static const float amounts[2] = {1, -1};
    const gphys_vec3 nowhere = {INFINITY, 0, 0};
    REFUSED(gphys_solver_detach(s, f->rope, 0), BAD);
    REFUSED(gphys_solver_detach(s, f->rope, 4), BAD);
    REFUSED(gphys_solver_detach(s, f->removed, 0), STALE);
    REFUSED(gphys_solver_attach(s, f->scene, f->rope, 0, NONE, NULL), STALE);
    REFUSED(gphys_solver_attach(s, f->scene, f->rope, 4, f->floor, NULL), BAD);
    REFUSED(gphys_solver_attach(s, f->scene, f->rope, 0, f->floor, &nowhere), BAD);
    REFUSED(gphys_solver_attach(s, f->elsewhere, f->rope, 0, f->floor, NULL), BAD);
    REFUSED(gphys_solver_attach(s, NULL, f->rope, 0, f->floor, NULL), BAD);
    REFUSED(gphys_solver_set_positions(s, f->rope, 0, 2, bad, 12), BAD);
    REFUSED(gphys_solver_set_velocities(s, f->rope, 0, 2, bad, 12), BAD);
    REFUSED(gphys_solver_set_forces(s, f->rope, 0, 2, bad, 12), BAD);
    REFUSED(gphys_solver_set_masses(s, f->rope, 0, 2, amounts, 4), BAD);
    REFUSED(gphys_solver_set_radii(s, f->rope, 0, 2, amounts, 4), BAD);
    REFUSED(gphys_solver_set_radii(s, f->rope, 3, 2, amounts, 4), BAD);
    REFUSED(gphys_solver_set_pinned(s, f->rope, 0, 1, 2), BAD);
    REFUSED(gphys_solver_set_pinned(s, f->rope, 3, 2, 1), BAD);
}

static void test_bodies_and_settings(void** state) {
    fixture* f = *state;
    gphys_solver* s = f->solver;
    const gphys_vec3 nowhere = {NAN, 0, 0}, edge = {1e15f, 0, 0};
    const double far_away[3] = {-1e15, 0, 0}, no_origin[3] = {NAN, 0, 0};
    uint32_t words[64] = {0};
    gphys_body_id body = 0;
    REFUSED(gphys_solver_set_gravity(s, &nowhere), BAD);
    REFUSED(gphys_solver_set_substeps(s, 0), BAD);
    REFUSED(gphys_solver_set_origin(s, far_away), BAD);
    REFUSED(gphys_solver_set_origin(s, no_origin), BAD);
    REFUSED(gphys_solver_add_particles(s, NULL, &nowhere, 12, 1, &body), BAD);
    REFUSED(gphys_solver_add_rope(s, NULL, &edge, 0, 1, 0, &body), BAD);
    REFUSED(gphys_solver_add_cloth(s, NULL, &edge, &edge, &edge, 2, 2, &body), BAD);
    REFUSED(gphys_solver_remove_body(s, f->removed), STALE);
    REFUSED(gphys_solver_wake(s, f->removed), STALE);
    REFUSED(gphys_solver_step(s, f->scene, 0), BAD);
    REFUSED(gphys_solver_step(s, f->elsewhere, 0.01f), BAD);
    REFUSED(gphys_solver_advance(s, f->scene, NAN, NULL, NULL), BAD);
    REFUSED(gphys_solver_advance(s, f->elsewhere, 0.01f, NULL, NULL), BAD);
    REFUSED(gphys_solver_restore(s, words, 64), BAD);
    REFUSED(gphys_solver_restore(s, NULL, 0), BAD);
}

static void test_changes_of_settings(void** state) {
    fixture* f = *state;
    gphys_solver* s = f->solver;
    gphys_solver_settings solver;
    gphys_body_settings body;
    const gphys_constraint_settings link = {1, 0, -1};
    const gphys_wind wind = {{0, 0, 0}, -1, 0, 0};
    const gphys_vec3 nowhere = {NAN, 0, 0};
    const gphys_animation_target target = {{0, 0, 0}, {0, 0, 0}, 1, 1};
    const gphys_constraint_id none = NONE;
    const float sticky = -0.5f;
    assert_int_equal(gphys_solver_get_settings(s, &solver), GPHYS_OK);
    solver.fixed_step = 1;
    REFUSED(gphys_solver_set_settings(s, &solver), BAD);
    assert_int_equal(gphys_solver_get_body_settings(s, f->rope, &body), GPHYS_OK);
    body.restitution = 2;
    REFUSED(gphys_solver_set_body_settings(s, f->rope, &body), BAD);
    body.restitution = 0;
    REFUSED(gphys_solver_set_body_settings(s, f->removed, &body), STALE);
    REFUSED(gphys_solver_set_constraint_settings(s, f->rope, &none, &link, 0, 1), STALE);
    REFUSED(gphys_solver_set_friction_factors(s, f->rope, 0, 2, &sticky, 0), BAD);
    REFUSED(gphys_solver_set_wind(s, f->rope, &wind), BAD);
    REFUSED(gphys_solver_set_air_velocities(s, f->rope, 0, 1, &nowhere, 12), BAD);
    REFUSED(gphys_solver_set_animation_targets(s, f->rope, 0, 1, &target, 0), BAD);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_constraints, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_particles, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_bodies_and_settings, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_changes_of_settings, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

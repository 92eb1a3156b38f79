/* Batches without elements: every function that takes arrays with strides. */
#include "test.h"

typedef struct {
    gphys_mesh* mesh;
    gphys_scene* scene;
    gphys_camera* camera;
    gphys_solver* solver;
    gphys_body_id body;
} fixture;

static int set_up(void** state) {
    static fixture f;
    const float vertices[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const uint32_t indices[3] = {0, 1, 2};
    const gphys_vec3 points[2] = {{0, 0, 0}, {1, 0, 0}};
    const gphys_sphere ball = {{0, 0, 0}, 1};
    gphys_model_id model;
    assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 3, indices, 3, &f.mesh), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &f.scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add(f.scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_camera_create(NULL, &f.camera), GPHYS_OK);
    assert_int_equal(gphys_solver_create(NULL, &f.solver), GPHYS_OK);
    assert_int_equal(gphys_solver_add_rope(f.solver, NULL, points, 12, 2, 0, &f.body), GPHYS_OK);
    *state = &f;
    return 0;
}

static int tear_down(void** state) {
    fixture* f = *state;
    gphys_solver_destroy(f->solver);
    gphys_camera_destroy(f->camera);
    gphys_scene_destroy(f->scene);
    gphys_mesh_destroy(f->mesh);
    return 0;
}

/* 0, sizes of no element, and no multiple of 4. */
static const uint32_t strides[] = {0, 4, 30};
#define ACCEPTED(call) assert_int_equal(call, GPHYS_OK)

static void no_shapes(void** state) {
    const gphys_shape_type ball = GPHYS_SHAPE_SPHERE, frustum = GPHYS_SHAPE_FRUSTUM, mesh = GPHYS_SHAPE_MESH;
    const gphys_sphere at = {{0, 0, 0}, 1};
    fixture* f = *state;
    for (int i = 0; i < 3; ++i) {
        const uint32_t s = strides[i];
        ACCEPTED(gphys_shape_contains_batch(ball, &at, NULL, s, 0, 0, NULL, s));
        ACCEPTED(gphys_shape_closest_point_batch(ball, &at, NULL, s, 0, NULL, s));
        ACCEPTED(gphys_shape_overlaps_batch(ball, NULL, s, mesh, NULL, s, 0, NULL, s));
        ACCEPTED(gphys_shape_raycast_batch(ball, &at, NULL, s, 0, NULL, s));
        ACCEPTED(gphys_shape_sweep_batch(frustum, NULL, s, GPHYS_SHAPE_AABB, NULL, s, NULL, s, 0, NULL, s));
        ACCEPTED(gphys_shape_penetration_batch(frustum, NULL, s, ball, NULL, s, 0, NULL, s));
        ACCEPTED(gphys_planes_intersection_batch(NULL, s, NULL, s, NULL, s, 0, NULL, s));
        ACCEPTED(gphys_mesh_raycast_any_batch(f->mesh, NULL, s, 0, NULL, s));
        ACCEPTED(gphys_mesh_raycast_distance_batch(f->mesh, NULL, s, 0, NULL, s));
    }
}

static void no_models(void** state) {
    const gphys_shape_type ball = GPHYS_SHAPE_SPHERE, mesh = GPHYS_SHAPE_MESH;
    const gphys_transform place = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    const fixture* f = *state;
    gphys_scene* const scene = f->scene;
    gphys_model_desc desc;
    uint32_t count = 0;
    gphys_model_desc_init(&desc, sizeof desc);
    for (int i = 0; i < 3; ++i) {
        const uint32_t s = strides[i];
        ACCEPTED(gphys_scene_add_batch(scene, ball, NULL, s, &place, s, 0, NULL, NULL));
        ACCEPTED(gphys_scene_add_batch(scene, mesh, NULL, s, NULL, s, 0, NULL, NULL));
        ACCEPTED(gphys_scene_add_described_batch(scene, ball, NULL, s, &place, s, &desc, s, 0, NULL));
        ACCEPTED(gphys_scene_set_transforms(scene, NULL, NULL, s, 0));
        ACCEPTED(gphys_scene_get_transforms(scene, NULL, 0, NULL, s));
        ACCEPTED(gphys_scene_get_world_transforms(scene, NULL, 0, NULL, s));
    }
    ACCEPTED(gphys_scene_remove_batch(scene, NULL, 0));
    assert_int_equal(gphys_scene_get_models(scene, NULL, 0, &count), GPHYS_INCOMPLETE);
    assert_int_equal(count, 1);
}

static void no_queries(void** state) {
    const gphys_shape_type ball = GPHYS_SHAPE_SPHERE;
    const fixture* f = *state;
    const gphys_scene* const scene = f->scene;
    uint32_t ends[1];
    for (int i = 0; i < 3; ++i) {
        const uint32_t s = strides[i];
        ACCEPTED(gphys_scene_raycast_batch(scene, NULL, s, 0, 1, NULL, s));
        ACCEPTED(gphys_scene_raycast_distance_batch(scene, NULL, s, 0, 1, NULL, s));
        ACCEPTED(gphys_scene_raycast_any_batch(scene, NULL, s, 0, 1, NULL, s));
        ACCEPTED(gphys_scene_raycast_all_batch(scene, NULL, s, 0, 1, NULL, 0, ends));
        ACCEPTED(gphys_scene_segment_test_batch(scene, NULL, s, 0, 1, NULL, s));
        ACCEPTED(gphys_scene_overlap_batch(scene, ball, NULL, s, 0, 1, NULL, 0, ends));
        ACCEPTED(gphys_scene_cull_batch(scene, NULL, s, 0, 1, NULL, 0, ends));
        ACCEPTED(gphys_scene_nearest_batch(scene, NULL, s, 0, 1, 1, NULL, s));
        ACCEPTED(gphys_scene_sweep_sphere_batch(scene, NULL, s, NULL, s, 0, 1, NULL, s));
        ACCEPTED(gphys_scene_sweep_batch(scene, ball, NULL, s, NULL, s, 0, 1, NULL, s));
        ends[0] = 7;
        ACCEPTED(gphys_scene_penetration_batch(scene, ball, NULL, s, 0, 1, NULL, 0, ends));
        assert_int_equal(ends[0], 0);
        ACCEPTED(gphys_camera_pick_batch(f->camera, scene, NULL, s, 0, 1, NULL, s));
        ACCEPTED(gphys_camera_project_batch(f->camera, NULL, s, 0, NULL, s));
        ACCEPTED(gphys_camera_unproject_batch(f->camera, NULL, s, 0, NULL, s));
    }
}

static void no_filtered_queries(void** state) {
    const gphys_shape_type ball = GPHYS_SHAPE_SPHERE;
    const fixture* f = *state;
    const gphys_scene* const scene = f->scene;
    gphys_query_filter_desc one;
    uint32_t ends[1];
    gphys_query_filter_desc_init(&one, sizeof one);
    for (int i = 0; i < 3; ++i) {
        const uint32_t s = strides[i];
        ACCEPTED(gphys_scene_raycast_filtered_batch(scene, NULL, s, 0, &one, s, NULL, s));
        ACCEPTED(gphys_scene_raycast_distance_filtered_batch(scene, NULL, s, 0, &one, s, NULL, s));
        ACCEPTED(gphys_scene_raycast_any_filtered_batch(scene, NULL, s, 0, &one, s, NULL, s));
        ACCEPTED(gphys_scene_raycast_all_filtered_batch(scene, NULL, s, 0, &one, s, NULL, 0, ends));
        ACCEPTED(gphys_scene_segment_test_filtered_batch(scene, NULL, s, 0, &one, s, NULL, s));
        ACCEPTED(gphys_scene_overlap_filtered_batch(scene, ball, NULL, s, 0, &one, s, NULL, 0, ends));
        ACCEPTED(gphys_scene_cull_filtered_batch(scene, NULL, s, 0, &one, s, NULL, 0, ends));
        ACCEPTED(gphys_scene_nearest_filtered_batch(scene, NULL, s, 0, 1, &one, s, NULL, s));
        ACCEPTED(gphys_scene_sweep_sphere_filtered_batch(scene, NULL, s, NULL, s, 0, &one, s, NULL, s));
        ACCEPTED(gphys_scene_sweep_filtered_batch(scene, ball, NULL, s, NULL, s, 0, &one, s, NULL, s));
        ACCEPTED(gphys_scene_penetration_filtered_batch(scene, ball, NULL, s, 0, &one, s, NULL, 0, ends));
        ACCEPTED(gphys_camera_pick_filtered_batch(f->camera, scene, NULL, s, 0, &one, s, NULL, s));
    }
}

static void no_particles(void** state) {
    const fixture* f = *state;
    gphys_solver* const solver = f->solver;
    const gphys_body_id body = f->body;
    for (int i = 0; i < 3; ++i) {
        const uint32_t s = strides[i];
        ACCEPTED(gphys_solver_get_positions(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_set_positions(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_velocities(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_set_velocities(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_masses(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_set_masses(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_radii(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_set_radii(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_friction_factors(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_set_friction_factors(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_forces(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_set_forces(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_pinned(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_air_velocities(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_set_air_velocities(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_animation_targets(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_set_animation_targets(solver, body, 1, 0, NULL, s));
        ACCEPTED(gphys_solver_get_constraint_kinds(solver, body, NULL, 0, NULL, s));
        ACCEPTED(gphys_solver_get_constraint_settings(solver, body, NULL, 0, NULL, s));
        ACCEPTED(gphys_solver_set_constraint_settings(solver, body, NULL, NULL, s, 0));
        ACCEPTED(gphys_solver_get_breaking_forces(solver, body, NULL, 0, NULL, s));
        ACCEPTED(gphys_solver_set_breaking_forces(solver, body, NULL, NULL, s, 0));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_shapes),           cmocka_unit_test(no_models),    cmocka_unit_test(no_queries),
        cmocka_unit_test(no_filtered_queries), cmocka_unit_test(no_particles),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}

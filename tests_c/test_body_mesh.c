/* Meshes in the form of bodies: what the functions accept, refuse and leave alone, and that bodies are met, picked and
 * culled where they are. */
#include "test.h"

typedef struct {
    gphys_solver* solver;
    gphys_scene* scene;
    gphys_body_id cloth, rope, dust;
} world;

static world make_world(void) {
    const gphys_vec3 corner = {-1, 2, -1}, u = {2, 0, 0}, v = {0, 0, 2};
    const gphys_vec3 points[3] = {{3, 2, 0}, {4, 2, 0}, {5, 2, 0}};
    gphys_body_desc desc;
    world w;
    assert_int_equal(gphys_solver_create(NULL, &w.solver), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &w.scene), GPHYS_OK);
    assert_int_equal(gphys_body_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.radius = 0.1f;
    assert_int_equal(gphys_solver_add_cloth(w.solver, &desc, &corner, &u, &v, 5, 5, &w.cloth), GPHYS_OK);
    assert_int_equal(gphys_solver_add_rope(w.solver, &desc, points, sizeof points[0], 3, 0, &w.rope), GPHYS_OK);
    assert_int_equal(gphys_solver_add_particles(w.solver, &desc, points, sizeof points[0], 3, &w.dust), GPHYS_OK);
    return w;
}

static void end_world(world* w) {
    gphys_solver_destroy(w->solver);
    gphys_scene_destroy(w->scene);
}

static gphys_mesh* mesh_of(const world* w, gphys_body_id body) {
    gphys_mesh* mesh = NULL;
    assert_int_equal(gphys_mesh_create_from_body(NULL, w->solver, body, &mesh), GPHYS_OK);
    assert_non_null(mesh);
    return mesh;
}

static gphys_model_id show(const world* w, gphys_body_id body, uint32_t tag) {
    gphys_mesh* mesh = mesh_of(w, body);
    gphys_model_id model = 0;
    gphys_model_desc desc;
    assert_int_equal(gphys_model_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.tag = tag;
    desc.layers = 4;
    assert_int_equal(gphys_scene_add(w->scene, GPHYS_SHAPE_MESH, mesh, NULL, &desc, &model), GPHYS_OK);
    gphys_mesh_destroy(mesh);
    return model;
}

static void arguments_of_create_from_body(void** state) {
    world w = make_world();
    gphys_mesh* mesh = (gphys_mesh*)&w;
    gphys_mesh_desc desc;
    (void)state;
    assert_int_equal(gphys_mesh_create_from_body(NULL, NULL, w.cloth, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create_from_body(NULL, w.solver, w.cloth, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_mesh_create_from_body(NULL, w.solver, 0, &mesh), GPHYS_ERROR_INVALID_ID);
    assert_int_equal(gphys_mesh_create_from_body(NULL, w.solver, 0xffffffffu, &mesh), GPHYS_ERROR_INVALID_ID);
    memset(&desc, 0, sizeof desc);
    assert_int_equal(gphys_mesh_create_from_body(&desc, w.solver, w.cloth, &mesh), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(gphys_mesh_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.deformable = 2;
    assert_int_equal(gphys_mesh_create_from_body(&desc, w.solver, w.cloth, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    desc.deformable = 0;
    desc.reserved = 1;
    assert_int_equal(gphys_mesh_create_from_body(&desc, w.solver, w.cloth, &mesh), GPHYS_ERROR_INVALID_ARGUMENT);
    desc.reserved = 0;
    assert_int_equal(gphys_solver_remove_body(w.solver, w.rope), GPHYS_OK);
    assert_int_equal(gphys_mesh_create_from_body(&desc, w.solver, w.rope, &mesh), GPHYS_ERROR_INVALID_ID);
    assert_ptr_equal(mesh, &w);
    assert_int_equal(gphys_mesh_create_from_body(&desc, w.solver, w.cloth, &mesh), GPHYS_OK);
    gphys_mesh_destroy(mesh);
    end_world(&w);
}

/* The handle of a model's mesh goes on following the body when the model is gone. */
static void the_mesh_of_a_body_is_had_back(void** state) {
    world w = make_world();
    const gphys_model_id model = show(&w, w.rope, 3);
    gphys_mesh *rope = NULL, *cloth = mesh_of(&w, w.cloth);
    gphys_mesh_info info;
    gphys_vec3 before[3], after[3];
    uint32_t total;
    (void)state;
    assert_int_equal(gphys_mesh_get_info(cloth, &info), GPHYS_OK);
    assert_true(info.kind == GPHYS_MESH_BODY_SURFACE && info.vertex_count == 25 && info.triangle_count == 32);
    assert_true(info.deformable == 1 && info.follows_body == 1);
    assert_int_equal(gphys_scene_get_mesh(w.scene, model, &rope), GPHYS_OK);
    assert_int_equal(gphys_scene_remove(w.scene, model), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_info(rope, &info), GPHYS_OK);
    assert_true(info.kind == GPHYS_MESH_BODY_LINKS && info.vertex_count == 3 && info.triangle_count == 5);
    assert_int_equal(gphys_mesh_get_vertices(rope, before, 3, &total), GPHYS_OK);
    assert_int_equal(gphys_solver_step(w.solver, w.scene, 0.1f), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_vertices(rope, after, 3, &total), GPHYS_OK);
    assert_true(after[0].y < before[0].y);
    assert_int_equal(gphys_mesh_set_vertices(rope, &before[0].x, sizeof *before, 3), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_solver_remove_body(w.solver, w.rope), GPHYS_OK);
    assert_int_equal(gphys_mesh_get_info(rope, &info), GPHYS_OK);
    assert_true(info.kind == GPHYS_MESH_BODY_LINKS && info.deformable == 1 && info.follows_body == 0);
    assert_int_equal(gphys_mesh_set_vertices(rope, &before[0].x, sizeof *before, 3), GPHYS_OK);
    gphys_mesh_destroy(rope);
    gphys_mesh_destroy(cloth);
    end_world(&w);
}

static void arguments_of_get_nearest_particle(void** state) {
    world w = make_world();
    const gphys_vec3 point = {0, 0, 0}, bad = {NAN, 0, 0};
    uint32_t particle = 77;
    (void)state;
    assert_int_equal(gphys_solver_get_nearest_particle(NULL, w.rope, 0, &point, &particle),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, 0, 0, &point, &particle), GPHYS_ERROR_INVALID_ID);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.rope, 0, NULL, &particle),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.rope, 0, &bad, &particle),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.rope, 0, &point, NULL),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.rope, 5, &point, &particle),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.dust, 3, &point, &particle),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.cloth, 32, &point, &particle),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(particle, 77);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.rope, 1, &point, &particle), GPHYS_OK);
    assert_int_equal(particle, 1);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.dust, 2, &point, &particle), GPHYS_OK);
    assert_int_equal(particle, 2);
    assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.dust, GPHYS_NO_TRIANGLE, &point, &particle),
                     GPHYS_OK);
    assert_int_equal(particle, 0);
    end_world(&w);
}

static void bodies_are_met_where_they_are(void** state) {
    world w = make_world();
    const gphys_model_id cloth = show(&w, w.cloth, 10), rope = show(&w, w.rope, 11);
    const gphys_ray at_cloth = {{0.3f, 9, 0.2f}, {0, -1, 0}, 100}, at_rope = {{4.7f, 9, 0.05f}, {0, -1, 0}, 100};
    gphys_model_info info;
    gphys_camera* camera;
    gphys_model_id seen[4];
    gphys_vec3 positions[25], vertices[25];
    uint32_t total, particle;
    gphys_hit hit;
    int i;
    (void)state;
    assert_int_equal(gphys_scene_get_info(w.scene, rope, &info), GPHYS_OK);
    assert_int_equal(info.type, GPHYS_SHAPE_MESH);
    assert_int_equal(info.tag, 11);
    for (i = 0; i < 30; ++i) {
        assert_int_equal(gphys_solver_step(w.solver, w.scene, 1.0f / 60), GPHYS_OK);
        assert_int_equal(gphys_solver_get_positions(w.solver, w.cloth, 0, 25, positions, 12), GPHYS_OK);
        assert_int_equal(gphys_scene_raycast(w.scene, &at_cloth, 4, &hit), GPHYS_OK);
        assert_int_equal(hit.model, cloth);
        assert_int_equal(hit.tag, 10);
        assert_true(hit.point.y == positions[0].y);
        assert_int_equal(gphys_solver_get_nearest_particle(w.solver, w.cloth, hit.triangle, &hit.point, &particle),
                         GPHYS_OK);
        assert_int_equal(particle, 13);
        assert_int_equal(gphys_scene_raycast(w.scene, &at_cloth, 3, &hit), GPHYS_NO_HIT);
        assert_int_equal(gphys_scene_raycast(w.scene, &at_rope, 4, &hit), GPHYS_OK);
        assert_int_equal(hit.model, rope);
        assert_int_equal(hit.triangle, 1);
    }
    {
        const gphys_vec3 eye = {2, 30, 0}, up = {0, 0, 1};
        gphys_vec3 target = {2, 0, 0}, pixel;
        assert_int_equal(gphys_camera_create(NULL, &camera), GPHYS_OK);
        assert_int_equal(gphys_camera_look_at(camera, &eye, &target, &up), GPHYS_OK);
        assert_int_equal(gphys_camera_cull(camera, w.scene, GPHYS_ALL_LAYERS, seen, 4, &total), GPHYS_OK);
        assert_int_equal(total, 2);
        assert_int_equal(gphys_camera_project(camera, &positions[12], &pixel), GPHYS_OK);
        assert_int_equal(gphys_camera_pick(camera, w.scene, pixel.x, pixel.y, 4, &hit), GPHYS_OK);
        assert_int_equal(hit.model, cloth);
        gphys_camera_destroy(camera);
    }
    /* A body's mesh is asked without a scene as well. */
    {
        gphys_mesh* mesh = mesh_of(&w, w.cloth);
        assert_int_equal(gphys_mesh_get_vertices(mesh, vertices, 25, &total), GPHYS_OK);
        assert_memory_equal(vertices, positions, sizeof vertices);
        assert_int_equal(gphys_mesh_set_vertices(mesh, &vertices[0].x, 12, 25), GPHYS_ERROR_UNSUPPORTED);
        assert_int_equal(gphys_solver_remove_body(w.solver, w.cloth), GPHYS_OK);
        assert_int_equal(gphys_mesh_set_vertices(mesh, &vertices[0].x, 12, 25), GPHYS_OK);
        gphys_mesh_destroy(mesh);
    }
    assert_int_equal(gphys_scene_has(w.scene, cloth), GPHYS_OK);
    assert_int_equal(gphys_solver_advance(w.solver, w.scene, 0.1f, NULL, NULL), GPHYS_OK);
    assert_int_equal(gphys_scene_validate(w.scene), GPHYS_OK);
    end_world(&w);
}

static void a_mesh_of_links_is_no_cloth(void** state) {
    world w = make_world();
    gphys_mesh* mesh = mesh_of(&w, w.rope);
    gphys_body_id body = 5;
    gphys_mesh_report report;
    (void)state;
    assert_int_equal(gphys_solver_add_cloth_mesh(w.solver, NULL, mesh, NULL, &body), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(body, 5);
    assert_int_equal(gphys_mesh_get_report(mesh, &report), GPHYS_OK);
    assert_int_equal(report.triangle_count, 5);
    assert_int_equal(report.degenerate_count, 5);
    gphys_mesh_destroy(mesh);
    end_world(&w);
}

static void a_mesh_of_links_is_saved_and_loaded(void** state) {
    world w = make_world();
    gphys_mesh *mesh = mesh_of(&w, w.rope), *loaded = NULL;
    const gphys_ray down = {{3.2f, 9, 0.07f}, {0, -1, 0}, 100};
    uint32_t words[256], total, i;
    gphys_hit hit, again;
    (void)state;
    assert_int_equal(gphys_mesh_get_snapshot(mesh, words, 256, &total), GPHYS_OK);
    assert_int_equal(gphys_mesh_create_from_snapshot(NULL, words, total, &loaded), GPHYS_OK);
    assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh, &down, &hit), GPHYS_OK);
    assert_int_equal(gphys_shape_raycast(GPHYS_SHAPE_MESH, loaded, &down, &again), GPHYS_OK);
    assert_memory_equal(&hit, &again, sizeof hit);
    gphys_mesh_destroy(loaded);
    loaded = NULL;
    for (i = 0; i < total; ++i) {
        words[i] ^= 1u << i % 32;
        assert_int_equal(gphys_mesh_create_from_snapshot(NULL, words, total, &loaded), GPHYS_ERROR_INVALID_ARGUMENT);
        words[i] ^= 1u << i % 32;
    }
    assert_null(loaded);
    gphys_mesh_destroy(mesh);
    end_world(&w);
}

static void solver_and_scene_go_in_any_order(void** state) {
    int solver_first;
    (void)state;
    for (solver_first = 0; solver_first < 2; ++solver_first) {
        world w = make_world();
        const gphys_ray down = {{0.3f, 9, 0.2f}, {0, -1, 0}, 100};
        gphys_hit hit;
        show(&w, w.cloth, 0);
        show(&w, w.rope, 0);
        show(&w, w.dust, 0);
        assert_int_equal(gphys_solver_step(w.solver, w.scene, 0.01f), GPHYS_OK);
        if (solver_first) {
            gphys_solver_destroy(w.solver);
            assert_int_equal(gphys_scene_raycast(w.scene, &down, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
            gphys_scene_destroy(w.scene);
        } else {
            gphys_scene_destroy(w.scene);
            assert_int_equal(gphys_solver_step(w.solver, NULL, 0.01f), GPHYS_OK);
            gphys_solver_destroy(w.solver);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arguments_of_create_from_body),    cmocka_unit_test(arguments_of_get_nearest_particle),
        cmocka_unit_test(the_mesh_of_a_body_is_had_back),   cmocka_unit_test(bodies_are_met_where_they_are),
        cmocka_unit_test(a_mesh_of_links_is_no_cloth),      cmocka_unit_test(a_mesh_of_links_is_saved_and_loaded),
        cmocka_unit_test(solver_and_scene_go_in_any_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* gphys_solver_*: what each entry point accepts, refuses and leaves alone. */
#include "test.h"

#include <stdlib.h>

#define BAD GPHYS_ERROR_INVALID_ARGUMENT
#define STALE GPHYS_ERROR_INVALID_ID

static const gphys_vec3 points[4] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
static const float bad_values[] = {NAN, INFINITY, -INFINITY, 1.1e15f, -1.1e15f};
#define BAD_COUNT (sizeof bad_values / sizeof *bad_values)

typedef struct {
    gphys_solver* solver;
    gphys_scene* scene;
    gphys_body_id rope, removed;
} fixture;

static int set_up(void** state) {
    static fixture f;
    assert_int_equal(gphys_solver_create(NULL, &f.solver), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &f.scene), GPHYS_OK);
    assert_int_equal(gphys_solver_add_rope(f.solver, NULL, points, 12, 4, 0, &f.rope), GPHYS_OK);
    assert_int_equal(gphys_solver_add_particles(f.solver, NULL, points, 12, 4, &f.removed), GPHYS_OK);
    assert_int_equal(gphys_solver_remove_body(f.solver, f.removed), GPHYS_OK);
    *state = &f;
    return 0;
}

static int tear_down(void** state) {
    fixture* f = *state;
    gphys_solver_destroy(f->solver);
    gphys_scene_destroy(f->scene);
    return 0;
}

static void test_desc(void** state) {
    gphys_solver_desc desc;
    gphys_solver* solver = NULL;
    gphys_allocator half = {NULL, NULL, NULL};
    size_t i;
    (void)state;
    assert_int_equal(gphys_solver_desc_init(NULL, sizeof desc), BAD);
    assert_int_equal(gphys_solver_desc_init(&desc, 3), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(gphys_solver_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_int_equal(desc.substeps, 8);
    assert_true(desc.gravity.y == -9.81f);
    assert_int_equal(gphys_solver_create(&desc, NULL), BAD);
    for (i = 0; i < BAD_COUNT; ++i) {
        desc.gravity.x = bad_values[i];
        assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
        desc.gravity.x = 0;
        desc.fixed_step = bad_values[i];
        assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
        desc.fixed_step = 0.01f;
    }
    desc.substeps = 0;
    assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
    desc.substeps = 1001;
    assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
    desc.substeps = 1;
    desc.max_steps = 0;
    assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
    desc.max_steps = 1;
    desc.allocator = &half;
    assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
    desc.allocator = NULL;
    desc.struct_size = 0;
    assert_int_equal(gphys_solver_create(&desc, &solver), GPHYS_ERROR_STRUCT_SIZE);
    assert_null(solver);
    gphys_solver_destroy(NULL);
}

static void test_body_desc(void** state) {
    fixture* f = *state;
    gphys_body_desc desc;
    gphys_body_id body = 7;
    float* const amounts[] = {&desc.mass,
                              &desc.radius,
                              &desc.damping,
                              &desc.friction,
                              &desc.restitution,
                              &desc.compliance,
                              &desc.bend_compliance,
                              &desc.static_friction,
                              &desc.shear_compliance,
                              &desc.bending_stiffness};
    size_t field, i;
    assert_int_equal(gphys_body_desc_init(NULL, sizeof desc), BAD);
    assert_int_equal(gphys_body_desc_init(&desc, 3), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(gphys_body_desc_init(&desc, sizeof desc), GPHYS_OK);
    for (field = 0; field < sizeof amounts / sizeof *amounts; ++field) {
        const float fine = *amounts[field];
        for (i = 0; i < BAD_COUNT; ++i) {
            *amounts[field] = bad_values[i];
            assert_int_equal(gphys_solver_add_particles(f->solver, &desc, points, 12, 4, &body), BAD);
        }
        *amounts[field] = -1;
        assert_int_equal(gphys_solver_add_particles(f->solver, &desc, points, 12, 4, &body), BAD);
        *amounts[field] = fine;
    }
    desc.mass = 0;
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, points, 12, 4, &body), BAD);
    desc.mass = 1;
    desc.restitution = 1.5f;
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, points, 12, 4, &body), BAD);
    desc.restitution = 1;
    desc.static_friction = 0.4f;
    assert_true(desc.friction == 0.5f);
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, points, 12, 4, &body), BAD);
    desc.static_friction = 0.5f;
    desc.cloth_flags = 4;
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, points, 12, 4, &body), BAD);
    desc.cloth_flags = 0;
    assert_true(desc.self_collision == 0 && desc.body_layers == 0);
    desc.self_collision = 2;
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, points, 12, 4, &body), BAD);
    desc.self_collision = 1;
    desc.body_layers = 0xffffffff;
    assert_int_equal(body, 7);
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, points, 12, 4, &body), GPHYS_OK);
}

static void test_adding_bodies(void** state) {
    fixture* f = *state;
    gphys_vec3 broken[4];
    gphys_vec3 corner = {0, 0, 0}, u = {1, 0, 0}, v = {0, 1, 0};
    gphys_vec3* const vectors[] = {&corner, &u, &v};
    gphys_body_id body = 7;
    gphys_body_info info;
    uint32_t indices[6], total = 0;
    gphys_mesh* mesh = NULL;
    gphys_transform at = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    const float vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const uint32_t triangles[] = {0, 1, 2, 2, 1, 3};
    size_t i, k;

    assert_int_equal(gphys_solver_add_particles(NULL, NULL, points, 12, 4, &body), BAD);
    assert_int_equal(gphys_solver_add_particles(f->solver, NULL, NULL, 12, 4, &body), BAD);
    assert_int_equal(gphys_solver_add_particles(f->solver, NULL, points, 8, 4, &body), BAD);
    assert_int_equal(gphys_solver_add_particles(f->solver, NULL, points, 13, 4, &body), BAD);
    /* Several particles at one place: a forgotten stride. */
    assert_int_equal(gphys_solver_add_particles(f->solver, NULL, points, 0, 2, &body), BAD);
    assert_int_equal(gphys_solver_add_rope(f->solver, NULL, points, 0, 2, 0, &body), BAD);
    assert_int_equal(gphys_solver_set_positions(f->solver, f->rope, 0, 2, points, 0), BAD);
    assert_int_equal(gphys_solver_add_particles(f->solver, NULL, points, 12, 0, &body), BAD);
    assert_int_equal(gphys_solver_add_particles(f->solver, NULL, points, 12, 4, NULL), BAD);
    assert_int_equal(gphys_solver_add_rope(NULL, NULL, points, 12, 4, 0, &body), BAD);
    assert_int_equal(gphys_solver_add_rope(f->solver, NULL, points, 12, 1, 0, &body), BAD);
    assert_int_equal(gphys_solver_add_rope(f->solver, NULL, NULL, 12, 4, 0, &body), BAD);
    assert_int_equal(gphys_solver_add_rope(f->solver, NULL, points, 12, 4, -1, &body), BAD);
    assert_int_equal(gphys_solver_add_rope(f->solver, NULL, points, 12, 4, 0, NULL), BAD);
    memcpy(broken, points, sizeof broken);
    for (i = 0; i < BAD_COUNT; ++i) {
        broken[3].z = bad_values[i];
        assert_int_equal(gphys_solver_add_particles(f->solver, NULL, broken, 12, 4, &body), BAD);
        assert_int_equal(gphys_solver_add_rope(f->solver, NULL, broken, 12, 4, 0, &body), BAD);
        assert_int_equal(gphys_solver_add_rope(f->solver, NULL, points, 12, 4, bad_values[i], &body), BAD);
        for (k = 0; k < 3; ++k) {
            const float fine = vectors[k]->z;
            vectors[k]->z = bad_values[i];
            assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, &corner, &u, &v, 2, 2, &body), BAD);
            vectors[k]->z = fine;
        }
        at.position.x = bad_values[i];
        assert_int_equal(gphys_solver_add_cloth_mesh(f->solver, NULL, mesh, &at, &body), BAD);
        at.position.x = 0;
    }
    assert_int_equal(gphys_solver_add_cloth(NULL, NULL, &corner, &u, &v, 2, 2, &body), BAD);
    assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, NULL, &u, &v, 2, 2, &body), BAD);
    assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, &corner, NULL, &v, 2, 2, &body), BAD);
    assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, &corner, &u, NULL, 2, 2, &body), BAD);
    assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, &corner, &u, &v, 1, 2, &body), BAD);
    assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, &corner, &u, &v, 2, 0, &body), BAD);
    assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, &corner, &u, &v, 2, 2, NULL), BAD);
    assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, &corner, &u, &v, 65536, 65536, &body),
                     GPHYS_ERROR_CAPACITY);
    corner.x = u.x = 9e14f;
    assert_int_equal(gphys_solver_add_cloth(f->solver, NULL, &corner, &u, &v, 2, 2, &body), BAD);
    assert_int_equal(gphys_solver_add_cloth_mesh(f->solver, NULL, NULL, NULL, &body), BAD);
    assert_int_equal(body, 7);

    assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 4, triangles, 6, &mesh), GPHYS_OK);
    assert_int_equal(gphys_solver_add_cloth_mesh(NULL, NULL, mesh, NULL, &body), BAD);
    assert_int_equal(gphys_solver_add_cloth_mesh(f->solver, NULL, mesh, NULL, NULL), BAD);
    assert_int_equal(gphys_solver_add_cloth_mesh(f->solver, NULL, mesh, &at, &body), GPHYS_OK);
    gphys_mesh_destroy(mesh);
    assert_int_equal(gphys_solver_get_body_info(f->solver, body, &info), GPHYS_OK);
    assert_int_equal(info.kind, GPHYS_BODY_CLOTH);
    assert_int_equal(info.method, GPHYS_SOLVE_GRAPH);
    assert_int_equal(info.particle_count, 4);
    assert_int_equal(info.constraint_count, 6); /* five edges and a bend */
    assert_int_equal(info.triangle_count, 2);
    assert_int_equal(gphys_solver_get_triangles(f->solver, body, indices, 5, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 6);
    assert_int_equal(gphys_solver_get_triangles(f->solver, body, indices, 6, &total), GPHYS_OK);
    assert_memory_equal(indices, triangles, sizeof indices);
}

static void test_ids_and_lists(void** state) {
    fixture* f = *state;
    gphys_body_id bodies[2] = {0, 0}, second = 0;
    gphys_body_info info;
    gphys_solver_stats stats;
    gphys_body_contact touch;
    gphys_contact contact;
    uint32_t total = 0;
    assert_int_equal(gphys_solver_add_particles(f->solver, NULL, points, 12, 3, &second), GPHYS_OK);
    assert_int_not_equal(second, f->removed);
    assert_int_equal(gphys_solver_get_bodies(f->solver, bodies, 1, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 2);
    assert_int_equal(bodies[0], f->rope < second ? f->rope : second);
    assert_int_equal(gphys_solver_get_bodies(NULL, bodies, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_bodies(f->solver, NULL, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_bodies(f->solver, bodies, 1, NULL), BAD);
    assert_int_equal(gphys_solver_remove_body(f->solver, f->removed), STALE);
    assert_int_equal(gphys_solver_remove_body(f->solver, 0), STALE);
    assert_int_equal(gphys_solver_remove_body(NULL, f->rope), BAD);
    assert_int_equal(gphys_solver_get_body_info(f->solver, f->removed, &info), STALE);
    assert_int_equal(gphys_solver_get_body_info(f->solver, f->rope, NULL), BAD);
    assert_int_equal(gphys_solver_get_body_info(NULL, f->rope, &info), BAD);
    assert_int_equal(gphys_solver_get_triangles(f->solver, f->removed, NULL, 0, &total), STALE);
    assert_int_equal(gphys_solver_get_triangles(NULL, f->rope, NULL, 0, &total), BAD);
    assert_int_equal(gphys_solver_get_triangles(f->solver, f->rope, NULL, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_stats(f->solver, f->removed, &stats), STALE);
    assert_int_equal(gphys_solver_get_stats(f->solver, 0, NULL), BAD);
    assert_int_equal(gphys_solver_get_stats(NULL, 0, &stats), BAD);
    assert_int_equal(gphys_solver_get_stats(f->solver, 0, &stats), GPHYS_OK);
    assert_int_equal(stats.particle_count, 7);
    assert_int_equal(stats.constraint_count, 3);
    assert_int_equal(gphys_solver_get_contacts(NULL, &contact, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_contacts(f->solver, NULL, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_contacts(f->solver, &contact, 1, NULL), BAD);
    assert_int_equal(gphys_solver_get_contacts(f->solver, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_solver_get_body_contacts(NULL, &touch, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_body_contacts(f->solver, NULL, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_body_contacts(f->solver, &touch, 1, NULL), BAD);
    assert_int_equal(gphys_solver_get_body_contacts(f->solver, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
}

typedef gphys_status (*get_vectors)(const gphys_solver*, gphys_body_id, uint32_t, uint32_t, gphys_vec3*, uint32_t);
typedef gphys_status (*set_vectors)(gphys_solver*, gphys_body_id, uint32_t, uint32_t, const gphys_vec3*, uint32_t);
typedef gphys_status (*set_floats)(gphys_solver*, gphys_body_id, uint32_t, uint32_t, const float*, uint32_t);

static void test_vectors(void** state) {
    fixture* f = *state;
    const get_vectors getters[] = {gphys_solver_get_positions, gphys_solver_get_velocities};
    const set_vectors setters[] = {gphys_solver_set_positions, gphys_solver_set_velocities, gphys_solver_set_forces};
    gphys_vec3 values[4];
    size_t i, k;
    for (i = 0; i < 2; ++i) {
        assert_int_equal(getters[i](NULL, f->rope, 0, 4, values, 12), BAD);
        assert_int_equal(getters[i](f->solver, f->removed, 0, 4, values, 12), STALE);
        assert_int_equal(getters[i](f->solver, f->rope, 0, 5, values, 12), BAD);
        assert_int_equal(getters[i](f->solver, f->rope, 5, 0, values, 12), BAD);
        assert_int_equal(getters[i](f->solver, f->rope, 2, 0xffffffffu, values, 12), BAD);
        assert_int_equal(getters[i](f->solver, f->rope, 0, 4, NULL, 12), BAD);
        assert_int_equal(getters[i](f->solver, f->rope, 0, 4, values, 0), BAD);
        assert_int_equal(getters[i](f->solver, f->rope, 0, 4, values, 14), BAD);
        assert_int_equal(getters[i](f->solver, f->rope, 4, 0, NULL, 12), GPHYS_OK);
    }
    for (i = 0; i < 3; ++i) {
        memcpy(values, points, sizeof values);
        assert_int_equal(setters[i](NULL, f->rope, 0, 4, values, 12), BAD);
        assert_int_equal(setters[i](f->solver, f->removed, 0, 4, values, 12), STALE);
        assert_int_equal(setters[i](f->solver, f->rope, 1, 4, values, 12), BAD);
        assert_int_equal(setters[i](f->solver, f->rope, 0, 4, NULL, 12), BAD);
        assert_int_equal(setters[i](f->solver, f->rope, 0, 4, values, 8), BAD);
        values[0].x = 9;
        for (k = 0; k < BAD_COUNT; ++k) {
            values[3].y = bad_values[k];
            assert_int_equal(setters[i](f->solver, f->rope, 0, 4, values, 12), BAD);
        }
        assert_int_equal(setters[i](f->solver, f->rope, 0, 0, NULL, 12), GPHYS_OK);
    }
    assert_int_equal(gphys_solver_get_positions(f->solver, f->rope, 0, 4, values, 12), GPHYS_OK);
    assert_memory_equal(values, points, sizeof values);
    values[0].x = 5;
    assert_int_equal(gphys_solver_set_positions(f->solver, f->rope, 2, 1, values, 0), GPHYS_OK);
    assert_int_equal(gphys_solver_get_positions(f->solver, f->rope, 2, 1, values, 12), GPHYS_OK);
    assert_true(values[0].x == 5);
}

static void test_scalars(void** state) {
    fixture* f = *state;
    const set_floats setters[] = {gphys_solver_set_masses, gphys_solver_set_radii};
    float values[4] = {1, 2, 3, 4}, masses[4];
    size_t i, k;
    for (i = 0; i < 2; ++i) {
        assert_int_equal(setters[i](NULL, f->rope, 0, 4, values, 4), BAD);
        assert_int_equal(setters[i](f->solver, f->removed, 0, 4, values, 4), STALE);
        assert_int_equal(setters[i](f->solver, f->rope, 1, 4, values, 4), BAD);
        assert_int_equal(setters[i](f->solver, f->rope, 0, 4, NULL, 4), BAD);
        assert_int_equal(setters[i](f->solver, f->rope, 0, 4, values, 2), BAD);
        for (k = 0; k < BAD_COUNT; ++k) {
            values[3] = bad_values[k];
            assert_int_equal(setters[i](f->solver, f->rope, 0, 4, values, 4), BAD);
        }
        values[3] = -1;
        assert_int_equal(setters[i](f->solver, f->rope, 0, 4, values, 4), BAD);
    }
    values[3] = 0;
    assert_int_equal(gphys_solver_set_masses(f->solver, f->rope, 0, 4, values, 4), BAD);
    assert_int_equal(gphys_solver_set_radii(f->solver, f->rope, 0, 4, values, 4), GPHYS_OK);
    assert_int_equal(gphys_solver_get_masses(NULL, f->rope, 0, 4, masses, 4), BAD);
    assert_int_equal(gphys_solver_get_masses(f->solver, f->removed, 0, 4, masses, 4), STALE);
    assert_int_equal(gphys_solver_get_masses(f->solver, f->rope, 0, 5, masses, 4), BAD);
    assert_int_equal(gphys_solver_get_masses(f->solver, f->rope, 0, 4, NULL, 4), BAD);
    assert_int_equal(gphys_solver_get_masses(f->solver, f->rope, 0, 4, masses, 0), BAD);
    assert_int_equal(gphys_solver_get_masses(f->solver, f->rope, 0, 4, masses, 4), GPHYS_OK);
    assert_true(masses[0] == 0.25f && masses[3] == 0.25f);
    values[3] = 8;
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->rope, 3, 1, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_set_masses(f->solver, f->rope, 0, 4, values, 4), GPHYS_OK);
    assert_int_equal(gphys_solver_get_masses(f->solver, f->rope, 0, 4, masses, 4), GPHYS_OK);
    assert_memory_equal(values, masses, sizeof masses);
}

static void test_pins_and_attachments(void** state) {
    fixture* f = *state;
    const gphys_sphere ball = {{0, 0, 0}, 1};
    gphys_vec3 local = {0, NAN, 0};
    gphys_model_id model = 0, other = 0;
    gphys_solver_stats stats;
    gphys_attachment attachments[3];
    uint32_t total = 7;
    assert_int_equal(gphys_scene_add(f->scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_scene_add(f->scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &other), GPHYS_OK);
    assert_int_equal(gphys_solver_get_attachments(f->solver, f->rope, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_solver_set_pinned(NULL, f->rope, 0, 1, 1), BAD);
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->removed, 0, 1, 1), STALE);
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->rope, 3, 2, 1), BAD);
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->rope, 0, 1, 2), BAD);
    assert_int_equal(gphys_solver_attach(NULL, f->scene, f->rope, 0, model, NULL), BAD);
    assert_int_equal(gphys_solver_attach(f->solver, NULL, f->rope, 0, model, NULL), BAD);
    assert_int_equal(gphys_solver_attach(f->solver, f->scene, f->removed, 0, model, NULL), STALE);
    assert_int_equal(gphys_solver_attach(f->solver, f->scene, f->rope, 4, model, NULL), BAD);
    assert_int_equal(gphys_solver_attach(f->solver, f->scene, f->rope, 0, 0, NULL), STALE);
    assert_int_equal(gphys_solver_attach(f->solver, f->scene, f->rope, 0, model, &local), BAD);
    assert_int_equal(gphys_solver_detach(f->solver, f->rope, 0), BAD);
    assert_int_equal(gphys_solver_attach(f->solver, f->scene, f->rope, 0, model, NULL), GPHYS_OK);
    assert_int_equal(gphys_solver_get_stats(f->solver, f->rope, &stats), GPHYS_OK);
    assert_int_equal(stats.pinned_count, 1);
    /* By particle, whatever the order in which they were attached; pins are no attachments. */
    local.y = 0.25f;
    assert_int_equal(gphys_solver_attach(f->solver, f->scene, f->rope, 3, other, &local), GPHYS_OK);
    assert_int_equal(gphys_solver_attach(f->solver, f->scene, f->rope, 2, other, NULL), GPHYS_OK);
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->rope, 1, 1, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_get_attachments(f->solver, f->rope, attachments, 3, &total), GPHYS_OK);
    assert_int_equal(total, 3);
    assert_true(attachments[0].particle == 0 && attachments[0].model == model && attachments[0].local_point.x == 0);
    assert_true(attachments[1].particle == 2 && attachments[1].model == other && attachments[1].local_point.x == 2);
    assert_true(attachments[2].particle == 3 && attachments[2].model == other && attachments[2].local_point.y == 0.25f);
    attachments[1].particle = 9;
    assert_int_equal(gphys_solver_get_attachments(f->solver, f->rope, attachments, 1, &total), GPHYS_INCOMPLETE);
    assert_true(total == 3 && attachments[0].particle == 0 && attachments[1].particle == 9);
    assert_int_equal(gphys_solver_get_attachments(NULL, f->rope, attachments, 3, &total), BAD);
    assert_int_equal(gphys_solver_get_attachments(f->solver, f->removed, attachments, 3, &total), STALE);
    assert_int_equal(gphys_solver_get_attachments(f->solver, f->rope, NULL, 3, &total), BAD);
    assert_int_equal(gphys_solver_get_attachments(f->solver, f->rope, attachments, 3, NULL), BAD);
    /* One whose model is gone is there until the next step. */
    assert_int_equal(gphys_scene_remove(f->scene, other), GPHYS_OK);
    assert_int_equal(gphys_solver_get_attachments(f->solver, f->rope, attachments, 3, &total), GPHYS_OK);
    assert_int_equal(total, 3);
    assert_int_equal(gphys_solver_step(f->solver, f->scene, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_attachments(f->solver, f->rope, attachments, 3, &total), GPHYS_OK);
    assert_true(total == 1 && attachments[0].particle == 0);
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->rope, 1, 1, 0), GPHYS_OK);
    assert_int_equal(gphys_solver_detach(NULL, f->rope, 0), BAD);
    assert_int_equal(gphys_solver_detach(f->solver, f->removed, 0), STALE);
    assert_int_equal(gphys_solver_detach(f->solver, f->rope, 4), BAD);
    assert_int_equal(gphys_solver_detach(f->solver, f->rope, 0), GPHYS_OK);
    assert_int_equal(gphys_solver_get_stats(f->solver, f->rope, &stats), GPHYS_OK);
    assert_int_equal(stats.pinned_count, 0);
}

static void test_constraints(void** state) {
    fixture* f = *state;
    gphys_constraint_info infos[4];
    gphys_constraint_id id = 7;
    uint32_t total = 0;
    size_t i;
    assert_int_equal(gphys_solver_add_distance(NULL, f->rope, 0, 1, 1, 0, &id), BAD);
    assert_int_equal(gphys_solver_add_distance(f->solver, f->removed, 0, 1, 1, 0, &id), STALE);
    assert_int_equal(gphys_solver_add_distance(f->solver, f->rope, 0, 4, 1, 0, &id), BAD);
    assert_int_equal(gphys_solver_add_distance(f->solver, f->rope, 4, 0, 1, 0, &id), BAD);
    assert_int_equal(gphys_solver_add_distance(f->solver, f->rope, 1, 1, 1, 0, &id), BAD);
    assert_int_equal(gphys_solver_add_distance(f->solver, f->rope, 0, 1, 1, -1, &id), BAD);
    assert_int_equal(gphys_solver_add_distance(f->solver, f->rope, 0, 1, 1, 0, NULL), BAD);
    for (i = 0; i < BAD_COUNT; ++i) {
        assert_int_equal(gphys_solver_add_distance(f->solver, f->rope, 0, 1, bad_values[i], 0, &id), BAD);
        assert_int_equal(gphys_solver_add_distance(f->solver, f->rope, 0, 1, 1, bad_values[i], &id), BAD);
    }
    assert_int_equal(id, 7);
    assert_int_equal(gphys_solver_add_distance(f->solver, f->rope, 0, 3, -1, 0.5f, &id), GPHYS_OK);
    assert_int_equal(gphys_solver_get_constraints(f->solver, f->rope, infos, 4, &total), GPHYS_OK);
    assert_int_equal(total, 4);
    assert_int_equal(infos[3].id, id);
    assert_int_equal(infos[3].particle_b, 3);
    assert_true(infos[3].rest_length == 3 && infos[3].compliance == 0.5f);
    assert_int_equal(gphys_solver_get_constraints(f->solver, f->rope, infos, 2, &total), GPHYS_INCOMPLETE);
    assert_int_equal(gphys_solver_get_constraints(NULL, f->rope, infos, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_constraints(f->solver, f->removed, infos, 2, &total), STALE);
    assert_int_equal(gphys_solver_get_constraints(f->solver, f->rope, NULL, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_constraints(f->solver, f->rope, infos, 2, NULL), BAD);
    assert_int_equal(gphys_solver_remove_constraint(NULL, f->rope, id), BAD);
    assert_int_equal(gphys_solver_remove_constraint(f->solver, f->removed, id), STALE);
    assert_int_equal(gphys_solver_remove_constraint(f->solver, f->rope, 0), STALE);
    assert_int_equal(gphys_solver_remove_constraint(f->solver, f->rope, id), GPHYS_OK);
    assert_int_equal(gphys_solver_remove_constraint(f->solver, f->rope, id), STALE);
}

static void test_max_distances_and_damping(void** state) {
    fixture* f = *state;
    gphys_constraint_info infos[4];
    gphys_constraint_id id = 7, ids[2];
    gphys_constraint_kind kinds[4] = {7, 7, 7, 7};
    uint32_t total = 0;
    size_t i;
    assert_int_equal(gphys_solver_add_max_distance(NULL, f->rope, 0, 1, 1, 0, &id), BAD);
    assert_int_equal(gphys_solver_add_max_distance(f->solver, f->removed, 0, 1, 1, 0, &id), STALE);
    assert_int_equal(gphys_solver_add_max_distance(f->solver, f->rope, 0, 4, 1, 0, &id), BAD);
    assert_int_equal(gphys_solver_add_max_distance(f->solver, f->rope, 1, 1, 1, 0, &id), BAD);
    assert_int_equal(gphys_solver_add_max_distance(f->solver, f->rope, 0, 1, 1, -1, &id), BAD);
    assert_int_equal(gphys_solver_add_max_distance(f->solver, f->rope, 0, 1, 1, 0, NULL), BAD);
    for (i = 0; i < BAD_COUNT; ++i) {
        assert_int_equal(gphys_solver_add_max_distance(f->solver, f->rope, 0, 1, bad_values[i], 0, &id), BAD);
        assert_int_equal(gphys_solver_add_max_distance(f->solver, f->rope, 0, 1, 1, bad_values[i], &id), BAD);
    }
    assert_int_equal(id, 7);
    assert_int_equal(gphys_solver_add_max_distance(f->solver, f->rope, 0, 3, -1, 0.5f, &id), GPHYS_OK);
    assert_int_equal(gphys_solver_get_constraints(f->solver, f->rope, infos, 4, &total), GPHYS_OK);
    assert_int_equal(total, 4);
    assert_true(infos[3].id == id && infos[3].rest_length == 3 && infos[3].compliance == 0.5f);
    ids[0] = id;
    ids[1] = infos[1].id;
    assert_int_equal(gphys_solver_get_constraint_kinds(NULL, f->rope, ids, 2, kinds, 4), BAD);
    assert_int_equal(gphys_solver_get_constraint_kinds(f->solver, f->removed, ids, 2, kinds, 4), STALE);
    assert_int_equal(gphys_solver_get_constraint_kinds(f->solver, f->rope, NULL, 2, kinds, 4), BAD);
    assert_int_equal(gphys_solver_get_constraint_kinds(f->solver, f->rope, ids, 2, NULL, 4), BAD);
    assert_int_equal(gphys_solver_get_constraint_kinds(f->solver, f->rope, ids, 2, kinds, 2), BAD);
    assert_true(kinds[0] == 7 && kinds[1] == 7);
    assert_int_equal(gphys_solver_get_constraint_kinds(f->solver, f->rope, ids, 2, kinds, 8), GPHYS_OK);
    assert_true(kinds[0] == GPHYS_CONSTRAINT_MAX_DISTANCE && kinds[1] == 7);
    assert_true(kinds[2] == GPHYS_CONSTRAINT_DISTANCE && kinds[3] == 7);
    assert_int_equal(gphys_solver_get_constraint_kinds(f->solver, f->rope, NULL, 0, NULL, 4), GPHYS_OK);
    assert_int_equal(gphys_solver_set_constraint_damping(NULL, f->rope, id, 1), BAD);
    assert_int_equal(gphys_solver_set_constraint_damping(f->solver, f->removed, id, 1), STALE);
    assert_int_equal(gphys_solver_set_constraint_damping(f->solver, f->rope, 0, 1), STALE);
    assert_int_equal(gphys_solver_set_constraint_damping(f->solver, f->rope, id, -1), BAD);
    for (i = 0; i < BAD_COUNT; ++i) {
        assert_int_equal(gphys_solver_set_constraint_damping(f->solver, f->rope, id, bad_values[i]), BAD);
    }
    assert_int_equal(gphys_solver_set_constraint_damping(f->solver, f->rope, id, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_remove_constraint(f->solver, f->rope, id), GPHYS_OK);
    assert_int_equal(gphys_solver_set_constraint_damping(f->solver, f->rope, id, 1), STALE);
    assert_int_equal(gphys_solver_get_constraint_kinds(f->solver, f->rope, ids, 2, kinds, 4), STALE);
    assert_true(kinds[0] == GPHYS_CONSTRAINT_MAX_DISTANCE);
}

static void test_volumes(void** state) {
    fixture* f = *state;
    static const gphys_vec3 corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    gphys_mesh* mesh = NULL;
    gphys_body_id body = 0;
    float volume = 7, pressure = 7, rest = 7, compliance = 7;
    size_t i;
    assert_int_equal(gphys_mesh_create(NULL, &corners[0].x, 12, 4, faces, 12, &mesh), GPHYS_OK);
    assert_int_equal(gphys_solver_add_cloth_mesh(f->solver, NULL, mesh, NULL, &body), GPHYS_OK);
    gphys_mesh_destroy(mesh);
    assert_int_equal(gphys_solver_set_volume(NULL, body, -1, 0), BAD);
    assert_int_equal(gphys_solver_set_volume(f->solver, f->removed, -1, 0), STALE);
    assert_int_equal(gphys_solver_set_volume(f->solver, f->rope, -1, 0), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_solver_set_volume(f->solver, body, 0, 0), BAD);
    assert_int_equal(gphys_solver_set_volume(f->solver, body, 1, -1), BAD);
    assert_int_equal(gphys_solver_set_volume(f->solver, body, 1, NAN), BAD);
    for (i = 0; i < BAD_COUNT; ++i) {
        assert_int_equal(gphys_solver_set_volume(f->solver, body, bad_values[i], 0), BAD);
    }
    assert_int_equal(gphys_solver_get_volume(f->solver, body, &volume, &pressure), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_solver_get_volume_settings(f->solver, body, &rest, &compliance), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_solver_set_volume(f->solver, body, 2, 0.25f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_volume_settings(NULL, body, &rest, &compliance), BAD);
    assert_int_equal(gphys_solver_get_volume_settings(f->solver, f->removed, &rest, &compliance), STALE);
    assert_true(rest == 7 && compliance == 7);
    assert_int_equal(gphys_solver_get_volume_settings(f->solver, body, &rest, &compliance), GPHYS_OK);
    assert_true(rest == 2 && compliance == 0.25f);
    assert_int_equal(gphys_solver_set_volume(f->solver, body, -1, 0), GPHYS_OK);
    assert_int_equal(gphys_solver_get_volume_settings(f->solver, body, &rest, NULL), GPHYS_OK);
    assert_int_equal(gphys_solver_get_volume_settings(f->solver, body, NULL, &compliance), GPHYS_OK);
    assert_true(fabsf(rest - 1.0f / 6) < 1e-7f && compliance == 0);
    assert_int_equal(gphys_solver_get_volume(NULL, body, &volume, &pressure), BAD);
    assert_int_equal(gphys_solver_get_volume(f->solver, f->removed, &volume, &pressure), STALE);
    assert_true(volume == 7 && pressure == 7);
    assert_int_equal(gphys_solver_get_volume(f->solver, body, &volume, &pressure), GPHYS_OK);
    assert_true(fabsf(volume - 1.0f / 6) < 1e-7f && pressure == 0);
    assert_int_equal(gphys_solver_get_volume(f->solver, body, NULL, NULL), GPHYS_OK);
    assert_int_equal(gphys_solver_set_volume(f->solver, body, 1, INFINITY), GPHYS_OK);
    assert_int_equal(gphys_solver_get_volume(f->solver, body, &volume, &pressure), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_solver_get_volume_settings(f->solver, body, NULL, NULL), GPHYS_ERROR_UNSUPPORTED);
}

static void test_clusters(void** state) {
    fixture* f = *state;
    static const uint32_t all[4] = {3, 0, 1, 2}, twice[3] = {0, 1, 0}, outside[2] = {0, 4};
    gphys_cluster_id first = 0, second = 0, ids[2] = {7, 7};
    uint32_t particles[4] = {7, 7, 7, 7}, total = 7, before[2], after[2];
    gphys_body_info info;
    assert_int_equal(gphys_solver_get_hash(f->solver, before), GPHYS_OK);
    assert_int_equal(gphys_solver_add_cluster(NULL, f->rope, all, 4, &first), BAD);
    assert_int_equal(gphys_solver_add_cluster(f->solver, f->removed, all, 4, &first), STALE);
    assert_int_equal(gphys_solver_add_cluster(f->solver, f->rope, NULL, 4, &first), BAD);
    assert_int_equal(gphys_solver_add_cluster(f->solver, f->rope, all, 4, NULL), BAD);
    assert_int_equal(gphys_solver_add_cluster(f->solver, f->rope, all, 0, &first), BAD);
    assert_int_equal(gphys_solver_add_cluster(f->solver, f->rope, all, 1, &first), BAD);
    assert_int_equal(gphys_solver_add_cluster(f->solver, f->rope, twice, 3, &first), BAD);
    assert_non_null(strstr(gphys_last_error(), "particles[2]"));
    assert_int_equal(gphys_solver_add_cluster(f->solver, f->rope, outside, 2, &first), BAD);
    assert_non_null(strstr(gphys_last_error(), "particles[1]"));
    assert_int_equal(gphys_solver_get_clusters(f->solver, f->rope, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(gphys_solver_get_hash(f->solver, after), GPHYS_OK);
    assert_memory_equal(before, after, sizeof before);
    assert_true(first == 0 && total == 0);

    assert_int_equal(gphys_solver_add_cluster(f->solver, f->rope, all, 4, &first), GPHYS_OK);
    assert_int_equal(gphys_solver_add_cluster(f->solver, f->rope, all, 2, &second), GPHYS_OK);
    assert_int_equal(gphys_solver_get_body_info(f->solver, f->rope, &info), GPHYS_OK);
    assert_int_equal(info.method, GPHYS_SOLVE_GRAPH);
    assert_int_equal(gphys_solver_get_clusters(NULL, f->rope, ids, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_clusters(f->solver, f->removed, ids, 2, &total), STALE);
    assert_int_equal(gphys_solver_get_clusters(f->solver, f->rope, NULL, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_clusters(f->solver, f->rope, ids, 2, NULL), BAD);
    assert_int_equal(gphys_solver_get_clusters(f->solver, f->rope, ids, 1, &total), GPHYS_INCOMPLETE);
    assert_true(total == 2 && ids[0] == first && ids[1] == 7);
    assert_int_equal(gphys_solver_get_clusters(f->solver, f->rope, ids, 2, &total), GPHYS_OK);
    assert_true(total == 2 && ids[0] == first && ids[1] == second);
    assert_int_equal(gphys_solver_get_cluster_particles(NULL, f->rope, first, particles, 4, &total), BAD);
    assert_int_equal(gphys_solver_get_cluster_particles(f->solver, f->removed, first, particles, 4, &total), STALE);
    assert_int_equal(gphys_solver_get_cluster_particles(f->solver, f->rope, 0, particles, 4, &total), STALE);
    assert_int_equal(gphys_solver_get_cluster_particles(f->solver, f->rope, first, NULL, 4, &total), BAD);
    assert_int_equal(gphys_solver_get_cluster_particles(f->solver, f->rope, first, particles, 4, NULL), BAD);
    assert_int_equal(gphys_solver_get_cluster_particles(f->solver, f->rope, first, particles, 3, &total),
                     GPHYS_INCOMPLETE);
    assert_true(total == 4 && particles[0] == 3 && particles[1] == 0 && particles[2] == 1 && particles[3] == 7);
    assert_int_equal(gphys_solver_get_cluster_particles(f->solver, f->rope, second, particles, 4, &total), GPHYS_OK);
    assert_true(total == 2 && particles[0] == 3 && particles[1] == 0);

    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_remove_cluster(NULL, f->rope, first), BAD);
    assert_int_equal(gphys_solver_remove_cluster(f->solver, f->removed, first), STALE);
    assert_int_equal(gphys_solver_remove_cluster(f->solver, f->rope, first), GPHYS_OK);
    assert_int_equal(gphys_solver_remove_cluster(f->solver, f->rope, first), STALE);
    assert_int_equal(gphys_solver_get_cluster_particles(f->solver, f->rope, first, particles, 4, &total), STALE);
    assert_int_equal(gphys_solver_get_clusters(f->solver, f->rope, ids, 2, &total), GPHYS_OK);
    assert_true(total == 1 && ids[0] == second);
    assert_int_equal(gphys_solver_remove_cluster(f->solver, f->rope, second), GPHYS_OK);
    assert_int_equal(gphys_solver_get_body_info(f->solver, f->rope, &info), GPHYS_OK);
    assert_int_equal(info.method, GPHYS_SOLVE_DIRECT);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
}

static void test_breaks(void** state) {
    fixture* f = *state;
    gphys_constraint_info links[3];
    gphys_constraint_id ids[3];
    gphys_break made, listed[2];
    gphys_body_info info;
    uint32_t total = 0, before[2], after[2], i;
    float forces[3] = {7, 7, 7}, bad[2] = {1, -1};
    const float weak = 0.001f;
    assert_int_equal(gphys_solver_get_constraints(f->solver, f->rope, links, 3, &total), GPHYS_OK);
    for (i = 0; i < 3; ++i) ids[i] = links[i].id;
    assert_int_equal(gphys_solver_get_hash(f->solver, before), GPHYS_OK);
    assert_int_equal(gphys_solver_set_breaking_forces(NULL, f->rope, ids, &weak, 0, 3), BAD);
    assert_int_equal(gphys_solver_set_breaking_forces(f->solver, f->removed, ids, &weak, 0, 3), STALE);
    assert_int_equal(gphys_solver_set_breaking_forces(f->solver, f->rope, NULL, &weak, 0, 3), BAD);
    assert_int_equal(gphys_solver_set_breaking_forces(f->solver, f->rope, ids, NULL, 0, 3), BAD);
    assert_int_equal(gphys_solver_set_breaking_forces(f->solver, f->rope, ids, &weak, 2, 3), BAD);
    assert_int_equal(gphys_solver_set_breaking_forces(f->solver, f->rope, ids, bad, 4, 2), BAD);
    assert_non_null(strstr(gphys_last_error(), "forces[1]"));
    ids[2] = 0;
    assert_int_equal(gphys_solver_set_breaking_forces(f->solver, f->rope, ids, &weak, 0, 3), STALE);
    assert_int_equal(gphys_solver_get_breaking_forces(NULL, f->rope, ids, 1, forces, 4), BAD);
    assert_int_equal(gphys_solver_get_breaking_forces(f->solver, f->removed, ids, 1, forces, 4), STALE);
    assert_int_equal(gphys_solver_get_breaking_forces(f->solver, f->rope, NULL, 1, forces, 4), BAD);
    assert_int_equal(gphys_solver_get_breaking_forces(f->solver, f->rope, ids, 1, NULL, 4), BAD);
    assert_int_equal(gphys_solver_get_breaking_forces(f->solver, f->rope, ids, 1, forces, 3), BAD);
    assert_int_equal(gphys_solver_get_breaking_forces(f->solver, f->rope, ids, 3, forces, 4), STALE);
    assert_int_equal(gphys_solver_break_constraint(NULL, f->rope, ids[0], &made), BAD);
    assert_int_equal(gphys_solver_break_constraint(f->solver, f->removed, ids[0], &made), STALE);
    assert_int_equal(gphys_solver_break_constraint(f->solver, f->rope, 0, &made), STALE);
    assert_int_equal(gphys_solver_get_breaks(NULL, listed, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_breaks(f->solver, NULL, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_breaks(f->solver, listed, 2, NULL), BAD);
    assert_int_equal(gphys_solver_get_hash(f->solver, after), GPHYS_OK);
    assert_memory_equal(before, after, sizeof before);
    assert_true(forces[0] == 7);

    ids[2] = links[2].id;
    assert_int_equal(gphys_solver_get_breaking_forces(f->solver, f->rope, ids, 3, forces, 4), GPHYS_OK);
    assert_true(forces[0] == 0 && forces[1] == 0 && forces[2] == 0);
    assert_int_equal(gphys_solver_set_breaking_forces(f->solver, f->rope, ids + 1, &weak, 0, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_get_breaking_forces(f->solver, f->rope, ids, 3, forces, 4), GPHYS_OK);
    assert_true(forces[0] == 0 && forces[1] == weak && forces[2] == 0);
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->rope, 0, 1, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->rope, 3, 1, 1), GPHYS_OK);
    for (i = 0, total = 0; i < 20 && total == 0; ++i) {
        assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
        assert_int_equal(gphys_solver_get_breaks(f->solver, listed, 2, &total), GPHYS_OK);
    }
    assert_true(total == 1 && listed[0].body == f->rope && listed[0].constraint == ids[1] && listed[0].load > weak);
    assert_true(listed[0].torn_particle == GPHYS_NO_PARTICLE && listed[0].new_particle == GPHYS_NO_PARTICLE);
    assert_int_equal(gphys_solver_get_breaks(f->solver, listed, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(gphys_solver_break_constraint(f->solver, f->rope, ids[1], &made), STALE);
    assert_int_equal(gphys_solver_break_constraint(f->solver, f->rope, ids[0], NULL), GPHYS_OK);
    assert_int_equal(gphys_solver_break_constraint(f->solver, f->rope, ids[2], &made), GPHYS_OK);
    assert_true(made.body == f->rope && made.constraint == ids[2] && made.load == 0);
    assert_int_equal(gphys_solver_get_body_info(f->solver, f->rope, &info), GPHYS_OK);
    assert_true(info.constraint_count == 0 && info.method == GPHYS_SOLVE_FREE);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_breaks(f->solver, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
}

/* The middle of a sheet parts. A single cell does not, but for its diagonal that is no edge of a triangle. */
static void test_tearing(void** state) {
    fixture* f = *state;
    const gphys_vec3 corner = {0, 0, 0}, u = {1, 0, 0}, v = {0, 0, 1};
    gphys_constraint_info links[128];
    gphys_body_desc desc;
    gphys_body_id cell, sheet;
    gphys_body_info info;
    gphys_break made;
    uint32_t corners[24], total = 0, i, removed = 0;
    assert_int_equal(gphys_body_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.breaking_force = -1;
    assert_int_equal(gphys_solver_add_cloth(f->solver, &desc, &corner, &u, &v, 2, 2, &cell), BAD);
    desc.breaking_force = 1e6f;
    assert_int_equal(gphys_solver_add_cloth(f->solver, &desc, &corner, &u, &v, 2, 2, &cell), GPHYS_OK);
    assert_int_equal(gphys_solver_get_constraints(f->solver, cell, links, 128, &total), GPHYS_OK);
    assert_int_equal(total, 6);
    for (i = 0; i < total; ++i) {
        const gphys_status status = gphys_solver_break_constraint(f->solver, cell, links[i].id, &made);
        if (status == GPHYS_ERROR_UNSUPPORTED) continue;
        assert_int_equal(status, GPHYS_OK);
        assert_true(made.particle_a + made.particle_b == 3 && made.particle_a * made.particle_b == 0);
        assert_true(made.torn_particle == GPHYS_NO_PARTICLE && made.new_particle == GPHYS_NO_PARTICLE);
        ++removed;
    }
    assert_int_equal(removed, 1);

    assert_int_equal(gphys_solver_add_cloth(f->solver, &desc, &corner, &u, &v, 3, 3, &sheet), GPHYS_OK);
    assert_int_equal(gphys_solver_get_constraints(f->solver, sheet, links, 128, &total), GPHYS_OK);
    for (i = 0; i < total && links[i].particle_a * links[i].particle_b != 4 * 5; ++i) {
    }
    assert_int_equal(gphys_solver_break_constraint(f->solver, sheet, links[i].id, &made), GPHYS_OK);
    assert_true(made.body == sheet && made.constraint == links[i].id && made.load == 0);
    assert_true((made.torn_particle == 4 || made.torn_particle == 5) && made.new_particle == 9);
    assert_int_equal(gphys_solver_get_body_info(f->solver, sheet, &info), GPHYS_OK);
    assert_true(info.particle_count == 10 && info.triangle_count == 8);
    assert_int_equal(gphys_solver_get_triangles(f->solver, sheet, corners, 24, &total), GPHYS_OK);
    for (i = 0, removed = 0; i < 24; ++i) removed += corners[i] == 9;
    assert_true(removed >= 1 && removed <= 4);
    assert_int_equal(gphys_solver_step(f->solver, f->scene, 0.01f), GPHYS_OK);
}

static void test_impulses(void** state) {
    fixture* f = *state;
    static const gphys_vec3 places[1] = {{0, 0.01f, 0}};
    const gphys_plane ground = {{0, 1, 0}, 0};
    gphys_body_desc desc;
    gphys_impulse impulse;
    gphys_model_id model = 0;
    gphys_body_id body = 0;
    uint32_t total = 7;
    memset(&impulse, 0, sizeof impulse);
    gphys_body_desc_init(&desc, sizeof desc);
    desc.mass = 3;
    assert_int_equal(gphys_scene_add(f->scene, GPHYS_SHAPE_PLANE, &ground, NULL, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_scene_set_tag(f->scene, model, 42), GPHYS_OK);
    assert_int_equal(gphys_solver_remove_body(f->solver, f->rope), GPHYS_OK);
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, places, 12, 1, &body), GPHYS_OK);
    assert_int_equal(gphys_solver_get_impulses(NULL, &impulse, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_impulses(f->solver, NULL, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_impulses(f->solver, &impulse, 1, NULL), BAD);
    assert_int_equal(gphys_solver_get_impulses(f->solver, &impulse, 1, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_solver_step(f->solver, f->scene, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_step(f->solver, f->scene, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_impulses(f->solver, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 1);
    assert_int_equal(gphys_solver_get_impulses(f->solver, &impulse, 1, &total), GPHYS_OK);
    assert_int_equal(impulse.model, model);
    assert_int_equal(impulse.tag, 42);
    assert_true(fabsf(impulse.linear.y + 3 * 9.81f * 0.01f) < 1e-6f);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_impulses(f->solver, &impulse, 1, &total), GPHYS_OK);
    assert_int_equal(total, 0);
}

static void test_joints(void** state) {
    fixture* f = *state;
    gphys_body_id other;
    gphys_joint_id joint = 0, second = 0;
    gphys_joint_info infos[2];
    uint32_t total = 0;
    size_t i;
    assert_int_equal(gphys_solver_add_rope(f->solver, NULL, points, 12, 4, 0, &other), GPHYS_OK);
    assert_int_equal(gphys_solver_join(NULL, f->rope, 3, other, 0, 0, 0, &joint), BAD);
    assert_int_equal(gphys_solver_join(f->solver, f->removed, 0, other, 0, 0, 0, &joint), STALE);
    assert_int_equal(gphys_solver_join(f->solver, f->rope, 3, f->removed, 0, 0, 0, &joint), STALE);
    assert_int_equal(gphys_solver_join(f->solver, f->rope, 4, other, 0, 0, 0, &joint), BAD);
    assert_int_equal(gphys_solver_join(f->solver, f->rope, 3, other, 4, 0, 0, &joint), BAD);
    assert_int_equal(gphys_solver_join(f->solver, f->rope, 3, f->rope, 0, 0, 0, &joint), BAD);
    assert_int_equal(gphys_solver_join(f->solver, f->rope, 3, other, 0, 0, -1, &joint), BAD);
    assert_int_equal(gphys_solver_join(f->solver, f->rope, 3, other, 0, 0, 0, NULL), BAD);
    for (i = 0; i < BAD_COUNT; ++i) {
        assert_int_equal(gphys_solver_join(f->solver, f->rope, 3, other, 0, bad_values[i], 0, &joint), BAD);
        assert_int_equal(gphys_solver_join(f->solver, f->rope, 3, other, 0, 0, bad_values[i], &joint), BAD);
    }
    assert_int_equal(joint, 0);
    assert_int_equal(gphys_solver_get_joints(f->solver, 0, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_solver_join(f->solver, f->rope, 3, other, 1, -1, 0.5f, &joint), GPHYS_OK);
    assert_int_equal(gphys_solver_join(f->solver, other, 3, f->rope, 3, 0, 0, &second), GPHYS_OK);
    assert_int_equal(gphys_solver_get_joints(f->solver, f->rope, infos, 1, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 2);
    assert_int_equal(infos[0].id, joint);
    assert_int_equal(infos[0].body_a, f->rope);
    assert_int_equal(infos[0].particle_a, 3);
    assert_int_equal(infos[0].body_b, other);
    assert_int_equal(infos[0].particle_b, 1);
    assert_true(infos[0].rest_length == 2);
    assert_true(infos[0].compliance == 0.5f);
    assert_true(infos[0].force == 0);
    assert_int_equal(gphys_solver_get_joints(NULL, 0, infos, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_joints(f->solver, f->removed, infos, 2, &total), STALE);
    assert_int_equal(gphys_solver_get_joints(f->solver, 0, NULL, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_joints(f->solver, 0, infos, 2, NULL), BAD);
    assert_int_equal(gphys_solver_unjoin(NULL, joint), BAD);
    assert_int_equal(gphys_solver_unjoin(f->solver, joint), GPHYS_OK);
    assert_int_equal(gphys_solver_unjoin(f->solver, joint), STALE);
    assert_int_equal(gphys_solver_unjoin(f->solver, 0), STALE);
    assert_int_equal(gphys_solver_remove_body(f->solver, other), GPHYS_OK);
    assert_int_equal(gphys_solver_unjoin(f->solver, second), STALE);
    assert_int_equal(gphys_solver_get_joints(f->solver, 0, infos, 2, &total), GPHYS_OK);
    assert_int_equal(total, 0);
}

static void test_step_and_settings(void** state) {
    fixture* f = *state;
    const gphys_vec3 up = {0, 1, 0};
    gphys_vec3 broken = {0, 0, 0}, velocity;
    uint32_t steps = 7;
    float leftover = 7;
    size_t i;
    assert_int_equal(gphys_solver_step(NULL, NULL, 0.01f), BAD);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0), BAD);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.51f), BAD);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 9e-7f), BAD);
    assert_int_equal(gphys_solver_advance(NULL, NULL, 0.1f, NULL, NULL), BAD);
    assert_int_equal(gphys_solver_advance(f->solver, NULL, -0.1f, &steps, &leftover), BAD);
    for (i = 0; i < BAD_COUNT; ++i) {
        assert_int_equal(gphys_solver_step(f->solver, NULL, bad_values[i]), BAD);
        assert_int_equal(gphys_solver_advance(f->solver, NULL, bad_values[i], &steps, &leftover), BAD);
        broken.y = bad_values[i];
        assert_int_equal(gphys_solver_set_gravity(f->solver, &broken), BAD);
    }
    assert_int_equal(steps, 7);
    assert_int_equal(gphys_solver_set_gravity(NULL, &up), BAD);
    assert_int_equal(gphys_solver_set_gravity(f->solver, NULL), BAD);
    assert_int_equal(gphys_solver_set_substeps(NULL, 1), BAD);
    assert_int_equal(gphys_solver_set_substeps(f->solver, 0), BAD);
    assert_int_equal(gphys_solver_set_substeps(f->solver, 1001), BAD);
    assert_int_equal(gphys_solver_set_gravity(f->solver, &up), GPHYS_OK);
    assert_int_equal(gphys_solver_set_substeps(f->solver, 2), GPHYS_OK);
    assert_int_equal(gphys_solver_step(f->solver, f->scene, 0.5f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_velocities(f->solver, f->rope, 0, 1, &velocity, 12), GPHYS_OK);
    assert_true(fabsf(velocity.y - 0.5f) < 1e-6f);
    assert_int_equal(gphys_solver_advance(f->solver, NULL, 0.02f, &steps, &leftover), GPHYS_OK);
    assert_int_equal(steps, 1);
    assert_true(fabsf(leftover - 0.2f) < 1e-3f);
}

static void test_leftover(void** state) {
    fixture* f = *state;
    uint32_t words[4096], total = 0;
    float given = 7, read = 7;
    gphys_solver_settings settings;
    assert_int_equal(gphys_solver_get_leftover(NULL, &read), BAD);
    assert_int_equal(gphys_solver_get_leftover(f->solver, NULL), BAD);
    assert_int_equal(gphys_solver_get_leftover(f->solver, &read), GPHYS_OK);
    assert_true(read == 0);
    assert_int_equal(gphys_solver_advance(f->solver, NULL, 0.021f, NULL, &given), GPHYS_OK);
    assert_int_equal(gphys_solver_get_leftover(f->solver, &read), GPHYS_OK);
    assert_true(read == given && read > 0.2f && read < 0.3f);
    assert_int_equal(gphys_solver_get_snapshot(f->solver, words, 4096, &total), GPHYS_OK);
    /* A step half as long is owed twice the fraction, and a shorter one less than itself. */
    assert_int_equal(gphys_solver_get_settings(f->solver, &settings), GPHYS_OK);
    settings.fixed_step *= 0.5f;
    assert_int_equal(gphys_solver_set_settings(f->solver, &settings), GPHYS_OK);
    assert_int_equal(gphys_solver_get_leftover(f->solver, &read), GPHYS_OK);
    assert_true(fabsf(read - 2 * given) < 1e-6f);
    settings.fixed_step *= 0.01f;
    assert_int_equal(gphys_solver_set_settings(f->solver, &settings), GPHYS_OK);
    assert_int_equal(gphys_solver_get_leftover(f->solver, &read), GPHYS_OK);
    assert_true(read > 0.999f && read < 1);
    assert_int_equal(gphys_solver_restore(f->solver, words, total), GPHYS_OK);
    assert_int_equal(gphys_solver_get_leftover(f->solver, &read), GPHYS_OK);
    assert_true(read == given);
}

/* What is said of the order of a sheet's constraints: a sheet is made stiff against folding, and nothing else is. */
static void test_constraints_of_cloth_by_kind(void** state) {
    enum { COLUMNS = 4, ROWS = 3 };
    const gphys_vec3 corner = {0, 0, 0}, u = {3, 0, 0}, v = {0, 0, 2};
    /* From row to row, from column to column, both diagonals, those that resist folding. */
    static const uint32_t kinds[6] = {COLUMNS * (ROWS - 1),       (COLUMNS - 1) * ROWS, (COLUMNS - 1) * (ROWS - 1),
                                      (COLUMNS - 1) * (ROWS - 1), COLUMNS * (ROWS - 2), (COLUMNS - 2) * ROWS};
    static const uint32_t columns_apart[6] = {0, 1, 1, 1, 0, 2}, rows_apart[6] = {1, 0, 1, 1, 2, 0};
    static const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
    static const uint32_t triangles[6] = {0, 1, 2, 2, 1, 3};
    gphys_constraint_info info[64];
    gphys_solver* solver = NULL;
    gphys_mesh* mesh = NULL;
    gphys_body_id sheet, square;
    uint32_t total = 0, kind, k, i = 0;
    (void)state;
    assert_int_equal(gphys_solver_create(NULL, &solver), GPHYS_OK);
    assert_int_equal(gphys_solver_add_cloth(solver, NULL, &corner, &u, &v, COLUMNS, ROWS, &sheet), GPHYS_OK);
    assert_int_equal(gphys_solver_get_constraints(solver, sheet, info, 64, &total), GPHYS_OK);
    for (kind = 0; kind < 6; ++kind) {
        for (k = 0; k < kinds[kind]; ++k, ++i) {
            const uint32_t a = info[i].particle_a, b = info[i].particle_b;
            const int columns = (int)(b % COLUMNS) - (int)(a % COLUMNS), rows = (int)(b / COLUMNS) - (int)(a / COLUMNS);
            assert_int_equal(abs(columns), columns_apart[kind]);
            assert_int_equal(abs(rows), rows_apart[kind]);
        }
    }
    assert_int_equal(total, i);
    assert_int_equal(gphys_mesh_create(NULL, corners[0], 12, 4, triangles, 6, &mesh), GPHYS_OK);
    assert_int_equal(gphys_solver_add_cloth_mesh(solver, NULL, mesh, NULL, &square), GPHYS_OK);
    assert_int_equal(gphys_solver_get_constraints(solver, square, info, 64, &total), GPHYS_OK);
    assert_int_equal(total, 6); /* five edges, and what resists folding along the one within */
    for (i = 0; i < 6; ++i) assert_int_equal(info[i].particle_a == 0 && info[i].particle_b == 3, i == 5);
    gphys_mesh_destroy(mesh);
    gphys_solver_destroy(solver);
}

static void test_substeps(void** state) {
    fixture* f = *state;
    gphys_solver_desc desc;
    gphys_solver* solver = NULL;
    gphys_body_id body = 0;
    uint32_t substeps = 7;
    gphys_solver_desc_init(&desc, sizeof desc);
    assert_int_equal(desc.max_substeps, 64);
    desc.tolerance = 0.001f;
    desc.max_substeps = 0;
    assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
    desc.max_substeps = 1001;
    assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
    desc.max_substeps = 5;
    assert_int_equal(gphys_solver_create(&desc, &solver), GPHYS_OK);
    assert_int_equal(gphys_solver_add_rope(solver, NULL, points, 12, 4, 0, &body), GPHYS_OK);
    assert_int_equal(gphys_solver_get_substeps(NULL, body, &substeps), BAD);
    assert_int_equal(gphys_solver_get_substeps(solver, body, NULL), BAD);
    assert_int_equal(gphys_solver_get_substeps(f->solver, f->removed, &substeps), STALE);
    assert_int_equal(substeps, 7);
    assert_int_equal(gphys_solver_get_substeps(solver, body, &substeps), GPHYS_OK);
    assert_int_equal(substeps, 0);
    assert_int_equal(gphys_solver_step(solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_substeps(solver, body, &substeps), GPHYS_OK);
    assert_int_equal(substeps, 5);
    gphys_solver_destroy(solver);
}

static void test_snapshots(void** state) {
    fixture* f = *state;
    uint32_t words[4096], again[4096], total = 0, hash[2] = {7, 7}, later[2] = {7, 7};
    memset(words, 0, sizeof words);
    assert_int_equal(gphys_solver_get_hash(NULL, hash), BAD);
    assert_int_equal(gphys_solver_get_hash(f->solver, NULL), BAD);
    assert_int_equal(hash[0], 7);
    assert_int_equal(gphys_solver_get_snapshot(NULL, words, 4096, &total), BAD);
    assert_int_equal(gphys_solver_get_snapshot(f->solver, NULL, 1, &total), BAD);
    assert_int_equal(gphys_solver_get_snapshot(f->solver, words, 4096, NULL), BAD);
    assert_int_equal(gphys_solver_get_snapshot(f->solver, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(gphys_solver_get_snapshot(f->solver, words, total - 1, &total), GPHYS_INCOMPLETE);
    assert_int_equal(words[0], 0);
    assert_int_equal(gphys_solver_get_snapshot(f->solver, words, 4096, &total), GPHYS_OK);
    assert_int_equal(words[total], 0);
    assert_int_equal(gphys_solver_get_hash(f->solver, hash), GPHYS_OK);
    assert_int_equal(gphys_solver_remove_body(f->solver, f->rope), GPHYS_OK);
    assert_int_equal(gphys_solver_restore(NULL, words, total), BAD);
    assert_int_equal(gphys_solver_restore(f->solver, NULL, total), BAD);
    assert_int_equal(gphys_solver_restore(f->solver, words, total - 1), BAD);
    assert_int_equal(gphys_solver_restore(f->solver, words, total + 1), BAD);
    words[total - 1] ^= 1;
    assert_int_equal(gphys_solver_restore(f->solver, words, total), BAD);
    words[total - 1] ^= 1;
    assert_int_equal(gphys_solver_get_hash(f->solver, later), GPHYS_OK);
    assert_true(memcmp(hash, later, sizeof hash) != 0);
    assert_int_equal(gphys_solver_restore(f->solver, words, total), GPHYS_OK);
    assert_int_equal(gphys_solver_get_hash(f->solver, later), GPHYS_OK);
    assert_memory_equal(hash, later, sizeof hash);
    assert_int_equal(gphys_solver_get_snapshot(f->solver, again, 4096, &total), GPHYS_OK);
    assert_memory_equal(words, again, 4 * (size_t)total);
    assert_int_equal(gphys_solver_remove_body(f->solver, f->rope), GPHYS_OK);
}

static void test_sleep(void** state) {
    fixture* f = *state;
    gphys_solver_desc desc;
    gphys_solver* solver = NULL;
    gphys_body_id body = 0, bodies[2] = {7, 7};
    uint32_t total = 7;
    float* const amounts[] = {&desc.sleep_speed, &desc.sleep_strain, &desc.sleep_time, &desc.max_strain,
                              &desc.tolerance};
    size_t field, i;
    gphys_solver_desc_init(&desc, sizeof desc);
    assert_true(desc.sleep_speed == 0 && desc.max_strain == 0 && desc.tolerance == 0);
    for (field = 0; field < sizeof amounts / sizeof *amounts; ++field) {
        const float fine = *amounts[field];
        for (i = 0; i < BAD_COUNT; ++i) {
            *amounts[field] = bad_values[i];
            assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
        }
        *amounts[field] = -1;
        assert_int_equal(gphys_solver_create(&desc, &solver), BAD);
        *amounts[field] = fine;
    }
    desc.sleep_speed = 0.001f;
    desc.sleep_time = 0;
    desc.gravity.y = 0;
    assert_int_equal(gphys_solver_create(&desc, &solver), GPHYS_OK);
    assert_int_equal(gphys_solver_add_particles(solver, NULL, points, 12, 4, &body), GPHYS_OK);
    assert_int_equal(gphys_solver_get_sleeping(solver, bodies, 2, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_solver_step(solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_sleeping(NULL, bodies, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_sleeping(solver, NULL, 2, &total), BAD);
    assert_int_equal(gphys_solver_get_sleeping(solver, bodies, 2, NULL), BAD);
    assert_int_equal(gphys_solver_get_sleeping(solver, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(gphys_solver_get_sleeping(solver, bodies, 2, &total), GPHYS_OK);
    assert_int_equal(total, 1);
    assert_int_equal(bodies[0], body);
    assert_int_equal(bodies[1], 7);
    assert_int_equal(gphys_solver_wake(NULL, body), BAD);
    assert_int_equal(gphys_solver_wake(f->solver, f->removed), STALE);
    assert_int_equal(gphys_solver_wake(solver, body), GPHYS_OK);
    assert_int_equal(gphys_solver_get_sleeping(solver, bodies, 2, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_solver_wake(solver, 0), GPHYS_OK);
    gphys_solver_destroy(solver);
}

static void an_origin_is_checked_kept_and_returned(void** state) {
    const double origin[3] = {1e9, -2e9, 0.125}, bad[3] = {0, 0, 2e15};
    double now[3] = {7, 7, 7};
    gphys_solver* solver = NULL;
    (void)state;
    assert_int_equal(gphys_solver_create(NULL, &solver), GPHYS_OK);
    assert_int_equal(gphys_solver_set_origin(NULL, origin), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_set_origin(solver, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_set_origin(solver, bad), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_origin(NULL, now), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_origin(solver, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_solver_get_origin(solver, now), GPHYS_OK);
    assert_true(now[0] == 0 && now[1] == 0 && now[2] == 0);
    assert_int_equal(gphys_solver_set_origin(solver, origin), GPHYS_OK);
    assert_int_equal(gphys_solver_get_origin(solver, now), GPHYS_OK);
    assert_memory_equal(now, origin, sizeof now);
    gphys_solver_destroy(solver);
}

static void test_solver_settings(void** state) {
    fixture* f = *state;
    gphys_solver_settings settings, other;
    float* const amounts[] = {&settings.sleep_speed, &settings.sleep_strain, &settings.sleep_time,
                              &settings.max_strain,  &settings.tolerance,    &settings.fixed_step};
    size_t field, i;
    assert_int_equal(gphys_solver_get_settings(NULL, &settings), BAD);
    assert_int_equal(gphys_solver_get_settings(f->solver, NULL), BAD);
    assert_int_equal(gphys_solver_get_settings(f->solver, &settings), GPHYS_OK);
    assert_true(settings.substeps == 8 && settings.gravity.y == -9.81f && settings.max_work == 0);
    assert_int_equal(gphys_solver_set_settings(NULL, &settings), BAD);
    assert_int_equal(gphys_solver_set_settings(f->solver, NULL), BAD);
    for (field = 0; field < sizeof amounts / sizeof *amounts; ++field) {
        const float fine = *amounts[field];
        for (i = 0; i < BAD_COUNT; ++i) {
            *amounts[field] = bad_values[i];
            assert_int_equal(gphys_solver_set_settings(f->solver, &settings), BAD);
        }
        *amounts[field] = fine;
    }
    settings.substeps = 0;
    assert_int_equal(gphys_solver_set_settings(f->solver, &settings), BAD);
    settings.substeps = 3;
    settings.gravity.x = NAN;
    assert_int_equal(gphys_solver_set_settings(f->solver, &settings), BAD);
    settings.gravity.x = 2;
    settings.max_steps = 0;
    assert_int_equal(gphys_solver_set_settings(f->solver, &settings), BAD);
    settings.max_steps = 4;
    settings.max_substeps = 1001;
    assert_int_equal(gphys_solver_set_settings(f->solver, &settings), BAD);
    assert_int_equal(gphys_solver_get_settings(f->solver, &other), GPHYS_OK);
    assert_int_equal(other.substeps, 8);
    settings.max_substeps = 12;
    settings.max_work = 100000;
    settings.tolerance = 0.5f;
    assert_int_equal(gphys_solver_set_settings(f->solver, &settings), GPHYS_OK);
    assert_int_equal(gphys_solver_get_settings(f->solver, &other), GPHYS_OK);
    assert_memory_equal(&other, &settings, sizeof other);
}

static void test_body_settings(void** state) {
    fixture* f = *state;
    gphys_body_settings settings, other;
    float* const amounts[] = {&settings.damping, &settings.friction, &settings.static_friction, &settings.restitution};
    size_t field, i;
    assert_int_equal(gphys_solver_get_body_settings(NULL, f->rope, &settings), BAD);
    assert_int_equal(gphys_solver_get_body_settings(f->solver, f->removed, &settings), STALE);
    assert_int_equal(gphys_solver_get_body_settings(f->solver, f->rope, NULL), BAD);
    assert_int_equal(gphys_solver_get_body_settings(f->solver, f->rope, &settings), GPHYS_OK);
    assert_true(settings.friction == 0.5f && settings.static_friction == 0.5f && settings.layers == 0xffffffff);
    assert_int_equal(gphys_solver_set_body_settings(NULL, f->rope, &settings), BAD);
    assert_int_equal(gphys_solver_set_body_settings(f->solver, f->removed, &settings), STALE);
    assert_int_equal(gphys_solver_set_body_settings(f->solver, f->rope, NULL), BAD);
    for (field = 0; field < sizeof amounts / sizeof *amounts; ++field) {
        const float fine = *amounts[field];
        for (i = 0; i < BAD_COUNT; ++i) {
            *amounts[field] = bad_values[i];
            assert_int_equal(gphys_solver_set_body_settings(f->solver, f->rope, &settings), BAD);
        }
        *amounts[field] = fine;
    }
    settings.static_friction = 0.4f;
    assert_int_equal(gphys_solver_set_body_settings(f->solver, f->rope, &settings), BAD);
    settings.static_friction = 0.75f;
    settings.self_collision = 2;
    assert_int_equal(gphys_solver_set_body_settings(f->solver, f->rope, &settings), BAD);
    settings.self_collision = 1;
    settings.body_layers = 3;
    settings.layers = 5;
    settings.damping = 0.25f;
    settings.restitution = 1;
    assert_int_equal(gphys_solver_set_body_settings(f->solver, f->rope, &settings), GPHYS_OK);
    assert_int_equal(gphys_solver_get_body_settings(f->solver, f->rope, &other), GPHYS_OK);
    assert_memory_equal(&other, &settings, sizeof other);
    assert_int_equal(gphys_solver_step(f->solver, f->scene, 0.01f), GPHYS_OK);
}

static void test_constraint_settings(void** state) {
    fixture* f = *state;
    gphys_constraint_info links[3];
    gphys_constraint_id ids[3];
    gphys_constraint_settings settings[3], bad;
    uint32_t total = 0;
    size_t i;
    assert_int_equal(gphys_solver_get_constraints(f->solver, f->rope, links, 3, &total), GPHYS_OK);
    for (i = 0; i < 3; ++i) ids[i] = links[i].id;
    assert_int_equal(gphys_solver_get_constraint_settings(NULL, f->rope, ids, 3, settings, 12), BAD);
    assert_int_equal(gphys_solver_get_constraint_settings(f->solver, f->removed, ids, 3, settings, 12), STALE);
    assert_int_equal(gphys_solver_get_constraint_settings(f->solver, f->rope, NULL, 3, settings, 12), BAD);
    assert_int_equal(gphys_solver_get_constraint_settings(f->solver, f->rope, ids, 3, NULL, 12), BAD);
    assert_int_equal(gphys_solver_get_constraint_settings(f->solver, f->rope, ids, 3, settings, 8), BAD);
    assert_int_equal(gphys_solver_get_constraint_settings(f->solver, f->rope, ids, 3, settings, 12), GPHYS_OK);
    assert_true(settings[1].rest_length == 1 && settings[1].compliance == 0 && settings[1].damping == 0);
    settings[0].rest_length = 2;
    settings[1].compliance = 0.5f;
    settings[2].damping = 3;
    bad = settings[0];
    bad.compliance = -1;
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, ids, &bad, 0, 3), BAD);
    bad.compliance = 0;
    bad.damping = INFINITY;
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, ids, &bad, 0, 3), BAD);
    bad.damping = 0;
    bad.rest_length = NAN;
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, ids, &bad, 0, 3), BAD);
    assert_int_equal(gphys_solver_set_constraint_settings(NULL, f->rope, ids, settings, 12, 3), BAD);
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, NULL, settings, 12, 3), BAD);
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, ids, NULL, 12, 3), BAD);
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, ids, settings, 10, 3), BAD);
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, ids, settings, 12, 3), GPHYS_OK);
    settings[0].rest_length = 0;
    assert_int_equal(gphys_solver_get_constraint_settings(f->solver, f->rope, ids, 3, settings, 12), GPHYS_OK);
    assert_true(settings[0].rest_length == 2 && settings[1].compliance == 0.5f && settings[2].damping == 3);
    /* The present distance. */
    settings[0].rest_length = -1;
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, ids, settings, 0, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_get_constraint_settings(f->solver, f->rope, ids, 1, settings, 12), GPHYS_OK);
    assert_true(settings[0].rest_length == 1);
    assert_int_equal(gphys_solver_remove_constraint(f->solver, f->rope, ids[1]), GPHYS_OK);
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, ids, settings, 12, 3), STALE);
    assert_int_equal(gphys_solver_get_constraint_settings(f->solver, f->rope, ids, 3, settings, 12), STALE);
    assert_int_equal(gphys_solver_set_constraint_settings(f->solver, f->rope, NULL, NULL, 0, 0), GPHYS_OK);
}

static void test_reading_particles(void** state) {
    fixture* f = *state;
    const float radii[2] = {0.25f, 0.5f};
    const gphys_vec3 force = {1, 2, 3};
    float got[4] = {0};
    gphys_vec3 forces[4];
    int32_t pinned[4] = {7, 7, 7, 7};
    assert_int_equal(gphys_solver_set_radii(f->solver, f->rope, 1, 2, radii, 4), GPHYS_OK);
    assert_int_equal(gphys_solver_get_radii(f->solver, f->rope, 0, 4, got, 4), GPHYS_OK);
    assert_true(got[0] == 0.01f && got[1] == 0.25f && got[2] == 0.5f && got[3] == 0.01f);
    assert_int_equal(gphys_solver_get_radii(f->solver, f->rope, 0, 5, got, 4), BAD);
    assert_int_equal(gphys_solver_get_radii(f->solver, f->rope, 0, 4, NULL, 4), BAD);
    assert_int_equal(gphys_solver_get_radii(NULL, f->rope, 0, 4, got, 4), BAD);
    assert_int_equal(gphys_solver_set_forces(f->solver, f->rope, 3, 1, &force, 12), GPHYS_OK);
    assert_int_equal(gphys_solver_get_forces(f->solver, f->rope, 0, 4, forces, 12), GPHYS_OK);
    assert_true(forces[0].x == 0 && forces[3].x == 1 && forces[3].z == 3);
    assert_int_equal(gphys_solver_get_forces(f->solver, f->rope, 0, 4, forces, 0), BAD);
    assert_int_equal(gphys_solver_get_forces(f->solver, f->removed, 0, 4, forces, 12), STALE);
    assert_int_equal(gphys_solver_set_pinned(f->solver, f->rope, 2, 1, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_get_pinned(f->solver, f->rope, 1, 3, pinned, 4), GPHYS_OK);
    assert_true(pinned[0] == 0 && pinned[1] == 1 && pinned[2] == 0 && pinned[3] == 7);
    assert_int_equal(gphys_solver_get_pinned(f->solver, f->rope, 1, 4, pinned, 4), BAD);
    assert_int_equal(gphys_solver_get_pinned(f->solver, f->rope, 1, 3, pinned, 3), BAD);
}

static void test_friction_factors(void** state) {
    fixture* f = *state;
    const float given[3] = {0.5f, 0, 2};
    float bad[3] = {3, 3, -1}, got[4] = {7, 7, 7, 7}, spread[6];
    uint32_t before[2], after[2];
    size_t i;
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->rope, 0, 4, got, 4), GPHYS_OK);
    for (i = 0; i < 4; ++i) assert_true(got[i] == 1);
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 1, 3, given, 4), GPHYS_OK);
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->rope, 0, 4, got, 4), GPHYS_OK);
    assert_true(got[0] == 1 && got[1] == 0.5f && got[2] == 0 && got[3] == 2);
    /* What is refused changes nothing, also where others of the array are fine. */
    assert_int_equal(gphys_solver_get_hash(f->solver, before), GPHYS_OK);
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 0, 3, bad, 4), BAD);
    assert_non_null(strstr(gphys_last_error(), "factors[2] -1 is not from 0 to 1e15"));
    for (i = 0; i < BAD_COUNT; ++i) {
        bad[2] = bad_values[i];
        assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 0, 3, bad, 4), BAD);
    }
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 2, 3, given, 4), BAD);
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 0, 3, given, 3), BAD);
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 0, 3, NULL, 4), BAD);
    assert_int_equal(gphys_solver_set_friction_factors(NULL, f->rope, 0, 3, given, 4), BAD);
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->removed, 0, 1, given, 4), STALE);
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->rope, 3, 2, got, 4), BAD);
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->rope, 0, 4, got, 0), BAD);
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->rope, 0, 4, NULL, 4), BAD);
    assert_int_equal(gphys_solver_get_friction_factors(NULL, f->rope, 0, 4, got, 4), BAD);
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->removed, 0, 1, got, 4), STALE);
    assert_int_equal(gphys_solver_get_hash(f->solver, after), GPHYS_OK);
    assert_memory_equal(before, after, sizeof before);
    /* No particles, a stride, one for all, and back. */
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 4, 0, NULL, 4), GPHYS_OK);
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->rope, 1, 3, spread, 8), GPHYS_OK);
    assert_true(spread[0] == 0.5f && spread[2] == 0 && spread[4] == 2);
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 0, 2, spread, 8), GPHYS_OK);
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->rope, 0, 2, got, 4), GPHYS_OK);
    assert_true(got[0] == 0.5f && got[1] == 0);
    got[0] = 1;
    assert_int_equal(gphys_solver_set_friction_factors(f->solver, f->rope, 0, 4, got, 0), GPHYS_OK);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_friction_factors(f->solver, f->rope, 3, 1, got, 4), GPHYS_OK);
    assert_true(got[0] == 1);
}

static void test_body_contacts(void** state) {
    fixture* f = *state;
    const gphys_vec3 row[3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    gphys_vec3 above[3];
    gphys_body_desc desc;
    gphys_body_contact got[4];
    gphys_body_id lower, upper;
    uint32_t total, i;
    gphys_body_desc_init(&desc, sizeof desc);
    desc.radius = 0.25f;
    desc.body_layers = 1;
    for (i = 0; i < 3; ++i) above[i] = row[i], above[i].y = 0.5f;
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, row, 12, 3, &lower), GPHYS_OK);
    assert_int_equal(gphys_solver_add_particles(f->solver, &desc, above, 12, 3, &upper), GPHYS_OK);
    assert_int_equal(gphys_solver_set_pinned(f->solver, lower, 0, 3, 1), GPHYS_OK);
    assert_int_equal(gphys_solver_get_body_contacts(f->solver, got, 4, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    for (i = 0; i < 30; ++i) assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
    got[3].body_a = 77;
    assert_int_equal(gphys_solver_get_body_contacts(f->solver, got, 4, &total), GPHYS_OK);
    assert_int_equal(total, 3);
    assert_int_equal(got[3].body_a, 77);
    for (i = 0; i < 3; ++i) {
        assert_int_equal(got[i].body_a, lower);
        assert_int_equal(got[i].body_b, upper);
        assert_int_equal(got[i].particle_a, i);
        assert_int_equal(got[i].particle_b, i);
        assert_true(got[i].normal.y == 1);
        assert_true(fabsf(got[i].distance) < 1e-4f);
        assert_true(fabsf(got[i].impulse - 9.81f * 0.01f / 3) < 1e-5f);
    }
    /* The first are kept. */
    got[2].particle_a = 77;
    assert_int_equal(gphys_solver_get_body_contacts(f->solver, got, 2, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 3);
    assert_int_equal(got[1].particle_a, 1);
    assert_int_equal(got[2].particle_a, 77);
    assert_int_equal(gphys_solver_remove_body(f->solver, lower), GPHYS_OK);
    assert_int_equal(gphys_solver_get_body_contacts(f->solver, got, 4, &total), GPHYS_OK);
    assert_int_equal(total, 0);
}

static void test_wind(void** state) {
    fixture* f = *state;
    gphys_wind wind = {{1, 2, 3}, 1.2f, 0.5f, 0.25f}, got;
    const gphys_vec3 gusts[2] = {{4, 5, 6}, {7, 8, 9}}, broken = {0, NAN, 0};
    float* const fields[] = {&wind.velocity.x, &wind.density, &wind.drag, &wind.lift};
    gphys_vec3 air[4];
    size_t field, i;
    assert_int_equal(gphys_solver_get_wind(f->solver, f->rope, &got), GPHYS_OK);
    assert_true(got.density == 0 && got.velocity.x == 0);
    for (field = 0; field < sizeof fields / sizeof *fields; ++field) {
        const float fine = *fields[field];
        for (i = 0; i < BAD_COUNT; ++i) {
            *fields[field] = bad_values[i];
            assert_int_equal(gphys_solver_set_wind(f->solver, f->rope, &wind), BAD);
        }
        *fields[field] = fine;
    }
    assert_int_equal(gphys_solver_set_wind(NULL, f->rope, &wind), BAD);
    assert_int_equal(gphys_solver_set_wind(f->solver, f->rope, NULL), BAD);
    assert_int_equal(gphys_solver_set_wind(f->solver, f->removed, &wind), STALE);
    assert_int_equal(gphys_solver_set_wind(f->solver, 0, &wind), GPHYS_OK);
    assert_int_equal(gphys_solver_get_wind(f->solver, f->rope, NULL), BAD);
    assert_int_equal(gphys_solver_get_wind(f->solver, f->removed, &got), STALE);
    assert_int_equal(gphys_solver_get_wind(f->solver, f->rope, &got), GPHYS_OK);
    assert_memory_equal(&got, &wind, sizeof got);
    assert_int_equal(gphys_solver_get_air_velocities(f->solver, f->rope, 0, 4, air, 12), GPHYS_OK);
    assert_true(air[3].x == 0);
    assert_int_equal(gphys_solver_set_air_velocities(f->solver, f->rope, 1, 2, gusts, 12), GPHYS_OK);
    assert_int_equal(gphys_solver_set_air_velocities(f->solver, f->rope, 0, 2, &broken, 0), BAD);
    assert_int_equal(gphys_solver_set_air_velocities(f->solver, f->rope, 3, 2, gusts, 12), BAD);
    assert_int_equal(gphys_solver_set_air_velocities(f->solver, f->removed, 0, 1, gusts, 12), STALE);
    assert_int_equal(gphys_solver_get_air_velocities(f->solver, f->rope, 0, 4, air, 12), GPHYS_OK);
    assert_true(air[0].x == 0 && air[1].y == 5 && air[2].z == 9);
    assert_int_equal(gphys_solver_get_air_velocities(f->solver, f->rope, 0, 4, NULL, 12), BAD);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_velocities(f->solver, f->rope, 0, 4, air, 12), GPHYS_OK);
    assert_true(air[1].z > 0);
}

static void test_animation_targets(void** state) {
    fixture* f = *state;
    gphys_animation_target given = {{0.1f, 0.2f, 0.3f}, {0, 2, 0}, 0.5f, 0.25f}, got[4];
    const gphys_animation_target none = {{0, 0, 0}, {0, 0, 0}, INFINITY, INFINITY};
    float* const fields[] = {&given.position.y, &given.normal.x, &given.max_distance, &given.backstop};
    gphys_vec3 at[4];
    size_t field, i;
    assert_int_equal(gphys_solver_get_animation_targets(f->solver, f->rope, 0, 4, got, sizeof *got), GPHYS_OK);
    assert_memory_equal(&got[3], &none, sizeof none);
    for (field = 0; field < sizeof fields / sizeof *fields; ++field) {
        const float fine = *fields[field];
        for (i = 0; i < BAD_COUNT; ++i) {
            if (field >= 2 && bad_values[i] == INFINITY) continue;
            *fields[field] = bad_values[i];
            assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 0, 4, &given, 0), BAD);
        }
        *fields[field] = fine;
    }
    given.max_distance = -1;
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 0, 4, &given, 0), BAD);
    given.max_distance = 0.5f;
    given.normal.y = 0;
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 0, 4, &given, 0), BAD);
    assert_non_null(strstr(gphys_last_error(), "targets[0].normal: length 0 is not above 0"));
    given.normal.y = 2;
    assert_int_equal(gphys_solver_set_animation_targets(NULL, f->rope, 0, 4, &given, 0), BAD);
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 0, 4, NULL, 0), BAD);
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 0, 4, &given, 28), BAD);
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 3, 2, &given, 0), BAD);
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->removed, 0, 1, &given, 0), STALE);
    assert_int_equal(gphys_solver_get_animation_targets(f->solver, f->rope, 0, 4, NULL, sizeof *got), BAD);
    assert_int_equal(gphys_solver_get_animation_targets(f->solver, f->rope, 3, 2, got, sizeof *got), BAD);
    assert_int_equal(gphys_solver_get_animation_targets(f->solver, f->removed, 0, 1, got, sizeof *got), STALE);
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 1, 2, &given, 0), GPHYS_OK);
    assert_int_equal(gphys_solver_get_animation_targets(f->solver, f->rope, 0, 4, got, sizeof *got), GPHYS_OK);
    assert_memory_equal(&got[0], &none, sizeof none);
    assert_memory_equal(&got[1], &given, sizeof given);
    assert_memory_equal(&got[2], &given, sizeof given);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_positions(f->solver, f->rope, 0, 4, at, 12), GPHYS_OK);
    assert_true(at[1].y > -0.051f && at[1].x < 0.601f);
    /* Carried. */
    given.max_distance = 0;
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 1, 1, &given, 0), GPHYS_OK);
    assert_int_equal(gphys_solver_step(f->solver, NULL, 0.01f), GPHYS_OK);
    assert_int_equal(gphys_solver_get_positions(f->solver, f->rope, 0, 4, at, 12), GPHYS_OK);
    assert_memory_equal(&at[1], &given.position, sizeof at[1]);
    assert_int_equal(gphys_solver_set_animation_targets(f->solver, f->rope, 0, 4, &none, 0), GPHYS_OK);
    assert_int_equal(gphys_solver_get_animation_targets(f->solver, f->rope, 0, 4, got, sizeof *got), GPHYS_OK);
    assert_memory_equal(&got[1], &none, sizeof none);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_origin_is_checked_kept_and_returned),
        cmocka_unit_test_setup_teardown(test_desc, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_body_desc, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_adding_bodies, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_ids_and_lists, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_vectors, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_scalars, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_pins_and_attachments, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_constraints, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_max_distances_and_damping, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_volumes, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_clusters, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_breaks, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_tearing, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_impulses, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_joints, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_step_and_settings, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_leftover, set_up, tear_down),
        cmocka_unit_test(test_constraints_of_cloth_by_kind),
        cmocka_unit_test_setup_teardown(test_substeps, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_snapshots, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_sleep, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_solver_settings, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_body_settings, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_constraint_settings, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_reading_particles, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_friction_factors, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_body_contacts, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_wind, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_animation_targets, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* A solver and its bodies: particles, ropes and cloth. */
#include <math.h>

#include "check.h"

/* A solver for the Moon with two threads, whose bodies fall asleep below 1 cm/s. */
static void create(void) {
    gphys_solver_desc desc;
    gphys_solver* solver = NULL;
    MUST(gphys_solver_desc_init(&desc, sizeof desc));
    desc.gravity = (gphys_vec3){0, -1.62f, 0};
    desc.worker_count = 2;
    desc.sleep_speed = 0.01f;
    MUST(gphys_solver_create(&desc, &solver));
    gphys_solver_destroy(solver);
}

/* Two sparks of a gram each, 5 m above the ground, and where they are a second
 * later: 4.9 m further down. */
static void add_particles(gphys_solver* solver) {
    const gphys_vec3 sparks[2] = {{0, 5, 0}, {1, 5, 0}};
    gphys_body_desc desc;
    gphys_body_id body;
    gphys_vec3 now[2];
    MUST(gphys_body_desc_init(&desc, sizeof desc));
    desc.mass = 0.002f; /* of both */
    MUST(gphys_solver_add_particles(solver, &desc, sparks, sizeof sparks[0], 2, &body));
    for (int i = 0; i < 60; ++i) MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
    MUST(gphys_solver_get_positions(solver, body, 0, 2, now, sizeof now[0]));
    EXPECT(fabsf(now[0].y - (5 - 9.81f / 2)) < 1e-3f);
}

/* A rope of 2 m and 1 kg that hangs from its first particle. At rest its end is 2 m
 * below that. */
static void add_rope(gphys_solver* solver) {
    gphys_vec3 points[21];
    gphys_body_desc desc;
    gphys_body_id rope;
    for (int i = 0; i < 21; ++i) points[i] = (gphys_vec3){0, 5 - 0.1f * (float)i, 0};
    MUST(gphys_body_desc_init(&desc, sizeof desc));
    desc.mass = 1;
    MUST(gphys_solver_add_rope(solver, &desc, points, sizeof points[0], 21, 0, &rope));
    MUST(gphys_solver_set_pinned(solver, rope, 0, 1, 1));
    for (int i = 0; i < 60; ++i) MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
    MUST(gphys_solver_get_positions(solver, rope, 20, 1, points, sizeof points[0]));
    EXPECT(fabsf(points[0].y - 3) < 1e-3f);
}

/* A towel, 1 m by 2 m, with a particle every 10 cm, that hangs from its upper row. */
static void add_cloth(gphys_solver* solver) {
    const gphys_vec3 corner = {0, 2, 0}, along = {1, 0, 0}, down = {0, -2, 0};
    gphys_body_desc desc;
    gphys_body_id towel;
    gphys_body_info info;
    MUST(gphys_body_desc_init(&desc, sizeof desc));
    desc.mass = 0.5f;
    desc.cloth_flags = GPHYS_CLOTH_BEND;
    MUST(gphys_solver_add_cloth(solver, &desc, &corner, &along, &down, 11, 21, &towel));
    MUST(gphys_solver_set_pinned(solver, towel, 0, 11, 1));
    MUST(gphys_solver_get_body_info(solver, towel, &info));
    EXPECT(info.particle_count == 11 * 21 && info.triangle_count == 2 * 10 * 20);
}

/* A tent in the form of a mesh, a pyramid without a floor. A particle is at each of its
 * five vertices. */
static void add_cloth_mesh(gphys_solver* solver, const gphys_mesh* pyramid) {
    const gphys_transform place = {{10, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_body_id tent;
    gphys_body_info info;
    MUST(gphys_solver_add_cloth_mesh(solver, NULL, pyramid, &place, &tent));
    MUST(gphys_solver_get_body_info(solver, tent, &info));
    EXPECT(info.kind == GPHYS_BODY_CLOTH && info.particle_count == 5 &&
           info.triangle_count == 4);
}

/* All bodies of a solver with two ropes, then one less. */
static void list_and_remove(gphys_solver* solver, gphys_body_id rope) {
    gphys_body_id bodies[8];
    uint32_t total;
    MUST(gphys_solver_get_bodies(solver, bodies, 8, &total));
    EXPECT(total == 2 && bodies[0] == rope);
    MUST(gphys_solver_remove_body(solver, rope));
    MUST(gphys_solver_get_bodies(solver, bodies, 8, &total));
    EXPECT(total == 1 && bodies[0] != rope);
}

/* What a rope of 21 particles is made of: 20 links, solved as one system. */
static void info(gphys_solver* solver, gphys_body_id rope) {
    gphys_body_info info;
    MUST(gphys_solver_get_body_info(solver, rope, &info));
    EXPECT(info.kind == GPHYS_BODY_ROPE && info.method == GPHYS_SOLVE_DIRECT);
    EXPECT(info.particle_count == 21 && info.constraint_count == 20);
}

/* The triangles of a piece of cloth of 2 by 2 particles, to draw it: three particles
 * each. */
static void triangles(const gphys_solver* solver, gphys_body_id cloth) {
    uint32_t indices[6], total;
    MUST(gphys_solver_get_triangles(solver, cloth, indices, 6, &total));
    EXPECT(total == 6);
    for (uint32_t i = 0; i < total; ++i) EXPECT(indices[i] < 4);
}

/* Friction for a slippery floor and the masks of what a body collides with, changed
 * while it moves. */
static void body_settings(gphys_solver* solver, gphys_body_id rope) {
    gphys_body_settings settings;
    MUST(gphys_solver_get_body_settings(solver, rope, &settings));
    settings.friction = settings.static_friction = 0.05f;
    settings.layers = 1;
    MUST(gphys_solver_set_body_settings(solver, rope, &settings));
    MUST(gphys_solver_get_body_settings(solver, rope, &settings));
    EXPECT(settings.friction == 0.05f && settings.layers == 1);
}

/* A rope from x = 0 to 2 m at y = 5, with a particle every 10 cm, as a model of a
 * scene: rays meet it, and the particle at the place that was hit is found, to grab it.
 */
static void pick_rope(gphys_solver* solver, gphys_scene* scene, gphys_body_id rope) {
    const gphys_ray ray = {{1.02f, 5, -10}, {0, 0, 1}, 100};
    gphys_mesh* mesh = NULL;
    gphys_model_id model;
    gphys_hit hit;
    uint32_t particle;
    MUST(gphys_mesh_create_from_body(NULL, solver, rope, &mesh));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &model));
    gphys_mesh_destroy(mesh); /* the model keeps it */
    MUST(gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit));
    MUST(gphys_solver_get_nearest_particle(solver, rope, hit.triangle, &hit.point,
                                           &particle));
    EXPECT(hit.model == model && particle == 10);
}

static gphys_solver* empty(void) {
    gphys_solver* solver = NULL;
    MUST(gphys_solver_create(NULL, &solver));
    return solver;
}

static gphys_body_id level_rope(gphys_solver* solver) {
    gphys_vec3 points[21];
    gphys_body_id rope;
    for (int i = 0; i < 21; ++i) points[i] = (gphys_vec3){0.1f * (float)i, 5, 0};
    MUST(gphys_solver_add_rope(solver, NULL, points, sizeof points[0], 21, 0, &rope));
    return rope;
}

int main(void) {
    static const float vertices[5][3] = {
        {-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 2, 0}};
    static const uint32_t sides[12] = {1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4};
    const gphys_vec3 corner = {0, 2, 0}, along = {1, 0, 0}, across = {0, 0, 1};
    gphys_solver* solver = empty();
    gphys_scene* scene = NULL;
    gphys_mesh* pyramid = NULL;
    gphys_body_id cloth;
    MUST(gphys_mesh_create(NULL, vertices[0], sizeof vertices[0], 5, sides, 12,
                           &pyramid));
    MUST(gphys_scene_create(NULL, &scene));
    create();
    add_particles(solver);
    add_rope(solver);
    add_cloth(solver);
    add_cloth_mesh(solver, pyramid);
    MUST(gphys_solver_add_cloth(solver, NULL, &corner, &along, &across, 2, 2, &cloth));
    triangles(solver, cloth);
    gphys_solver_destroy(solver);

    solver = empty();
    const gphys_body_id rope = level_rope(solver);
    level_rope(solver);
    info(solver, rope);
    body_settings(solver, rope);
    pick_rope(solver, scene, rope);
    list_and_remove(solver, rope);
    gphys_mesh_destroy(pyramid);
    gphys_scene_destroy(scene);
    gphys_solver_destroy(solver);
    return 0;
}

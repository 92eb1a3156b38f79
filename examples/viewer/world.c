/* The world: a statue made of the mesh on a stone, copies of it in a spiral around, posts with
 * ropes between them and weights on ropes, and a cloth that falls over the statue. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "viewer.h"

enum { POST_COUNT = 8 };

static const float post_ring = 3.6f, post_height = 2.2f, rope_radius = 0.025f, cloth_radius = 0.02f;

/* The same numbers in each run. */
static float uniform(uint32_t* state, float low, float high) {
    *state = *state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(*state >> 8) / 16777216.0f;
}

static gphys_quat turned_about_y(float angle) { return (gphys_quat){0, sinf(angle / 2), 0, cosf(angle / 2)}; }

static gphys_model_id add(world* w, gphys_shape_type type, const void* shape, const gphys_transform* where,
                          uint32_t tag) {
    gphys_model_desc desc;
    gphys_model_id id;
    check(gphys_model_desc_init(&desc, sizeof desc), "model desc");
    desc.tag = tag;
    check(gphys_scene_add(w->scene, type, shape, where, &desc, &id), "add model");
    ++w->model_count;
    return id;
}

/* Show a body: its model is where the body is, from now on. */
static gphys_model_id show(world* w, gphys_body_id body, uint32_t tag) {
    gphys_mesh* mesh;
    check(gphys_mesh_create_from_body(NULL, w->solver, body, &mesh), "mesh of a body");
    const gphys_model_id model = add(w, GPHYS_SHAPE_MESH, mesh, NULL, tag);
    gphys_mesh_destroy(mesh); /* the model keeps it */
    return model;
}

static gphys_vec3 post_top(int i, float height) {
    const float angle = 6.2831853f * ((float)i + 0.5f) / POST_COUNT;
    return (gphys_vec3){post_ring * cosf(angle), height, post_ring * sinf(angle)};
}

static void add_models(world* w, uint32_t copies) {
    const gphys_plane ground = {{0, 1, 0}, 0};
    add(w, GPHYS_SHAPE_PLANE, &ground, NULL, TAG(KIND_GROUND, 0));
    const gphys_aabb stone = {{-1.3f, 0, -1.3f}, {1.3f, 0.4f, 1.3f}};
    add(w, GPHYS_SHAPE_AABB, &stone, NULL, TAG(KIND_STONE, 0));
    const gphys_transform statue = {{0, 0.4f, 0}, turned_about_y(0.35f), 2.3f};
    add(w, GPHYS_SHAPE_MESH, w->mesh, &statue, TAG(KIND_STATUE, 0));
    for (int i = 0; i < POST_COUNT; ++i) {
        const gphys_capsule post = {post_top(i, 0), post_top(i, post_height), 0.09f};
        add(w, GPHYS_SHAPE_CAPSULE, &post, NULL, TAG(KIND_POST, i));
    }
    /* A sunflower's spiral spreads the copies evenly (Vogel 1979). */
    uint32_t random = 7;
    for (uint32_t i = 0; i < copies; ++i) {
        const float angle = 2.39996323f * (float)i, radius = sqrtf(26 + 0.9f * (float)i);
        const gphys_transform where = {{radius * cosf(angle), 0, radius * sinf(angle)},
                                       turned_about_y(uniform(&random, 0, 6.2831853f)),
                                       uniform(&random, 0.55f, 0.95f)};
        add(w, GPHYS_SHAPE_MESH, w->mesh, &where, TAG(KIND_COPY, i));
    }
}

/* Ropes with slack between the posts, and ropes with a weight at their end, laid outward. */
static void add_ropes(world* w) {
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc), "body desc");
    desc.mass = 0.5f;
    desc.radius = rope_radius;
    desc.damping = 0.3f;
    gphys_vec3 points[ROPE_LINKS + 1];
    for (int i = 0; i < ROPE_COUNT; ++i) {
        const int between = i < POST_COUNT, post = i % POST_COUNT;
        const gphys_vec3 a = post_top(post, post_height + 0.15f);
        gphys_vec3 b = post_top(post + 1, post_height + 0.15f);
        if (!between) b = (gphys_vec3){a.x * 1.4f, a.y, a.z * 1.4f};
        for (int k = 0; k <= ROPE_LINKS; ++k) {
            const float s = (float)k / ROPE_LINKS;
            points[k] = (gphys_vec3){a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
        }
        const float span = sqrtf((b.x - a.x) * (b.x - a.x) + (b.z - a.z) * (b.z - a.z));
        const float link = between ? 1.18f * span / ROPE_LINKS : 0;
        check(gphys_solver_add_rope(w->solver, &desc, points, sizeof points[0], ROPE_LINKS + 1, link, &w->ropes[i]),
              "add rope");
        check(gphys_solver_set_pinned(w->solver, w->ropes[i], 0, 1, 1), "pin rope");
        if (between) {
            check(gphys_solver_set_pinned(w->solver, w->ropes[i], ROPE_LINKS, 1, 1), "pin rope");
        } else {
            const float mass = 20, radius = 0.12f;
            check(gphys_solver_set_masses(w->solver, w->ropes[i], ROPE_LINKS, 1, &mass, sizeof mass), "weight");
            check(gphys_solver_set_radii(w->solver, w->ropes[i], ROPE_LINKS, 1, &radius, sizeof radius), "weight");
        }
        show(w, w->ropes[i], TAG(KIND_ROPE, i));
    }
}

static void add_cloth(world* w) {
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc), "body desc");
    desc.mass = 2;
    desc.radius = cloth_radius;
    desc.damping = 0.4f;
    desc.friction = 0.6f;
    const gphys_vec3 corner = {-2, 2.95f, -2}, u = {4, 0, 0}, v = {0, 0, 4};
    /* Woven: cells yield in their plane, and so lie on what is round both ways. Springs of 30 rad/s a particle. */
    desc.shear_compliance = CLOTH_SIDE * CLOTH_SIDE / (desc.mass * 30 * 30);
    check(gphys_solver_add_cloth(w->solver, &desc, &corner, &u, &v, CLOTH_SIDE, CLOTH_SIDE, &w->cloth_body), "cloth");
    w->cloth_model = show(w, w->cloth_body, TAG(KIND_CLOTH, 0));
}

void world_create(world* w, const char* path, uint32_t copies) {
    *w = (world){0};
    if (load_mesh(path, &w->source) != 0) exit(1);
    check(gphys_mesh_create(NULL, &w->source.vertices[0].x, sizeof w->source.vertices[0], w->source.vertex_count,
                            w->source.indices, w->source.index_count, &w->mesh),
          "create mesh");
    gphys_scene_desc scene;
    check(gphys_scene_desc_init(&scene, sizeof scene), "scene desc");
    scene.worker_count = worker_count();
    check(gphys_scene_create(&scene, &w->scene), "create scene");
    gphys_solver_desc desc;
    check(gphys_solver_desc_init(&desc, sizeof desc), "solver desc");
    desc.worker_count = worker_count();
    desc.max_strain = 0.02f; /* as many substeps as that takes */
    check(gphys_solver_create(&desc, &w->solver), "create solver");
    add_models(w, copies);
    add_ropes(w);
    add_cloth(w);
}

void world_step(world* w, float frame_time) {
    check(gphys_solver_advance(w->solver, w->scene, frame_time, NULL, NULL), "advance");
}

/* Whether two particles of the cloth are on one of its four sides. */
static int on_one_side(uint32_t a, uint32_t b) {
    const uint32_t row = a / CLOTH_SIDE, column = a % CLOTH_SIDE;
    return (row == b / CLOTH_SIDE && row % (CLOTH_SIDE - 1) == 0) ||
           (column == b % CLOTH_SIDE && column % (CLOTH_SIDE - 1) == 0);
}

static void put_triangle(world* w, uint32_t a, uint32_t b, uint32_t c, uint32_t triangle) {
    triangle_mesh* cloth = &w->cloth;
    w->cloth_triangles[cloth->index_count / 3] = triangle;
    cloth->indices[cloth->index_count++] = a;
    cloth->indices[cloth->index_count++] = b;
    cloth->indices[cloth->index_count++] = c;
}

void world_thicken(world* w) {
    enum { COUNT = CLOTH_SIDE * CLOTH_SIDE, TRIANGLES = 2 * CLOTH_TRIANGLES + 8 * (CLOTH_SIDE - 1) };
    triangle_mesh* cloth = &w->cloth;
    cloth->vertices = calloc(2 * COUNT, sizeof *cloth->vertices);
    cloth->normals = calloc(2 * COUNT, sizeof *cloth->normals);
    cloth->indices = calloc(3 * TRIANGLES, sizeof *cloth->indices);
    w->cloth_triangles = calloc(TRIANGLES, sizeof *w->cloth_triangles);
    if (!cloth->vertices || !cloth->normals || !cloth->indices || !w->cloth_triangles) exit(1);
    uint32_t middle[3 * CLOTH_TRIANGLES], total;
    check(gphys_solver_get_triangles(w->solver, w->cloth_body, middle, 3 * CLOTH_TRIANGLES, &total), "triangles");
    check(gphys_solver_get_positions(w->solver, w->cloth_body, 0, COUNT, cloth->vertices, sizeof cloth->vertices[0]),
          "cloth positions");
    compute_normals(&(triangle_mesh){cloth->vertices, cloth->normals, middle, COUNT, 3 * CLOTH_TRIANGLES});

    cloth->vertex_count = 2 * COUNT; /* particle p is vertex p of one face and COUNT + p of the other */
    for (uint32_t i = 0; i < COUNT; ++i) {
        const gphys_vec3 p = cloth->vertices[i], n = cloth->normals[i];
        const float half = cloth_radius / 2;
        cloth->vertices[i] = (gphys_vec3){p.x + half * n.x, p.y + half * n.y, p.z + half * n.z};
        cloth->vertices[COUNT + i] = (gphys_vec3){p.x - half * n.x, p.y - half * n.y, p.z - half * n.z};
        cloth->normals[COUNT + i] = (gphys_vec3){-n.x, -n.y, -n.z};
    }
    for (uint32_t t = 0; t < CLOTH_TRIANGLES; ++t)
        put_triangle(w, middle[3 * t], middle[3 * t + 1], middle[3 * t + 2], t);
    for (uint32_t t = 0; t < CLOTH_TRIANGLES; ++t)
        put_triangle(w, COUNT + middle[3 * t], COUNT + middle[3 * t + 2], COUNT + middle[3 * t + 1], t);
    for (uint32_t i = 0; i < 3 * CLOTH_TRIANGLES; ++i) {
        const uint32_t t = i / 3, from = middle[i], to = middle[3 * t + (i + 1) % 3];
        if (!on_one_side(from, to)) continue;
        put_triangle(w, from, COUNT + from, to, t);
        put_triangle(w, to, COUNT + from, COUNT + to, t);
    }
    gphys_mesh* shell;
    check(gphys_mesh_create(NULL, &cloth->vertices[0].x, sizeof cloth->vertices[0], cloth->vertex_count, cloth->indices,
                            cloth->index_count, &shell),
          "create shell");
    gphys_mesh_report report;
    check(gphys_mesh_get_report(shell, &report), "report");
    if (report.open_edge_count > 0) {
        fprintf(stderr, "the cloth's faces and rim leave %u edges open\n", report.open_edge_count);
        exit(1);
    }
    check(gphys_scene_set_shape(w->scene, w->cloth_model, GPHYS_SHAPE_MESH, shell), "shape of the cloth");
    gphys_mesh_destroy(shell); /* the model keeps it */
}

void world_destroy(world* w) {
    gphys_solver_destroy(w->solver);
    gphys_scene_destroy(w->scene);
    gphys_mesh_destroy(w->mesh);
    free_mesh(&w->source);
    free_mesh(&w->cloth);
    free(w->cloth_triangles);
}

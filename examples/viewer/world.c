/* The world: a statue made of the mesh on a stone, copies of it in a spiral around, posts with
 * ropes between them and weights on ropes, and a cloth that falls over the statue. */
#include <math.h>
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
static void show(world* w, gphys_body_id body, uint32_t tag) {
    gphys_mesh* mesh;
    check(gphys_mesh_create_from_body(NULL, w->solver, body, &mesh), "mesh of a body");
    add(w, GPHYS_SHAPE_MESH, mesh, NULL, tag);
    gphys_mesh_destroy(mesh); /* the model keeps it */
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
    show(w, w->cloth_body, TAG(KIND_CLOTH, 0));

    triangle_mesh* cloth = &w->cloth;
    cloth->vertex_count = CLOTH_SIDE * CLOTH_SIDE;
    cloth->index_count = CLOTH_INDICES;
    cloth->vertices = calloc(cloth->vertex_count, sizeof *cloth->vertices);
    cloth->normals = calloc(cloth->vertex_count, sizeof *cloth->normals);
    cloth->indices = calloc(cloth->index_count, sizeof *cloth->indices);
    if (!cloth->vertices || !cloth->normals || !cloth->indices) exit(1);
    uint32_t total;
    check(gphys_solver_get_triangles(w->solver, w->cloth_body, cloth->indices, CLOTH_INDICES, &total), "triangles");
}

void world_create(world* w, const char* path, uint32_t copies) {
    *w = (world){0};
    if (load_mesh(path, &w->source) != 0) exit(1);
    check(gphys_mesh_create(NULL, &w->source.vertices[0].x, sizeof w->source.vertices[0], w->source.vertex_count,
                            w->source.indices, w->source.index_count, &w->mesh),
          "create mesh");
    check(gphys_scene_create(NULL, &w->scene), "create scene");
    gphys_solver_desc desc;
    check(gphys_solver_desc_init(&desc, sizeof desc), "solver desc");
    desc.max_strain = 0.02f; /* as many substeps as that takes */
    check(gphys_solver_create(&desc, &w->solver), "create solver");
    add_models(w, copies);
    add_ropes(w);
    add_cloth(w);
}

void world_step(world* w, float frame_time) {
    check(gphys_solver_advance(w->solver, w->scene, frame_time, NULL, NULL), "advance");
}

void world_smooth(world* w) {
    triangle_mesh* cloth = &w->cloth;
    check(gphys_solver_get_positions(w->solver, w->cloth_body, 0, cloth->vertex_count, cloth->vertices,
                                     sizeof cloth->vertices[0]),
          "cloth positions");
    compute_normals(cloth);
}

void world_destroy(world* w) {
    gphys_solver_destroy(w->solver);
    gphys_scene_destroy(w->scene);
    gphys_mesh_destroy(w->mesh);
    free_mesh(&w->source);
    free_mesh(&w->cloth);
}

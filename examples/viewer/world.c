/* The world: a statue made of the mesh on a stone, copies of it in a spiral around, posts with
 * ropes between them and weights on ropes, and a cloth that falls over the statue. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "viewer.h"

enum { POST_COUNT = 8, ROPE_LINKS = 48 };

static const float post_ring = 3.6f, post_height = 2.2f, rope_radius = 0.025f, cloth_radius = 0.02f;
static const gphys_transform identity = {{0, 0, 0}, {0, 0, 0, 1}, 1};

/* The same numbers in each run. */
static float uniform(uint32_t* state, float low, float high) {
    *state = *state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(*state >> 8) / 16777216.0f;
}

static gphys_quat turned_about_y(float angle) { return (gphys_quat){0, sinf(angle / 2), 0, cosf(angle / 2)}; }

static gphys_model_id add(world* w, gphys_shape_type type, const void* shape, const gphys_transform* where,
                          uint32_t layers, uint32_t tag) {
    gphys_model_desc desc;
    gphys_model_id id;
    check(gphys_model_desc_init(&desc, sizeof desc), "model desc");
    desc.layers = layers;
    desc.tag = tag;
    check(gphys_scene_add(w->scene, type, shape, where, &desc, &id), "add model");
    ++w->model_count;
    return id;
}

static gphys_vec3 post_top(int i, float height) {
    const float angle = 6.2831853f * ((float)i + 0.5f) / POST_COUNT;
    return (gphys_vec3){post_ring * cosf(angle), height, post_ring * sinf(angle)};
}

static void add_models(world* w, uint32_t copies) {
    const gphys_plane ground = {{0, 1, 0}, 0};
    add(w, GPHYS_SHAPE_PLANE, &ground, NULL, LAYER_SOLID | LAYER_SHOWN, TAG(KIND_GROUND, 0));
    const gphys_aabb stone = {{-1.3f, 0, -1.3f}, {1.3f, 0.4f, 1.3f}};
    add(w, GPHYS_SHAPE_AABB, &stone, NULL, LAYER_SOLID | LAYER_SHOWN, TAG(KIND_STONE, 0));
    const gphys_transform statue = {{0, 0.4f, 0}, turned_about_y(0.35f), 2.3f};
    add(w, GPHYS_SHAPE_MESH, w->mesh, &statue, LAYER_SOLID | LAYER_SHOWN, TAG(KIND_STATUE, 0));
    for (int i = 0; i < POST_COUNT; ++i) {
        const gphys_capsule post = {post_top(i, 0), post_top(i, post_height), 0.09f};
        add(w, GPHYS_SHAPE_CAPSULE, &post, NULL, LAYER_SOLID | LAYER_SHOWN, TAG(KIND_POST, i));
    }
    /* A sunflower's spiral spreads the copies evenly (Vogel 1979). */
    uint32_t random = 7;
    for (uint32_t i = 0; i < copies; ++i) {
        const float angle = 2.39996323f * (float)i, radius = sqrtf(26 + 0.9f * (float)i);
        const gphys_transform where = {{radius * cosf(angle), 0, radius * sinf(angle)},
                                       turned_about_y(uniform(&random, 0, 6.2831853f)),
                                       uniform(&random, 0.55f, 0.95f)};
        add(w, GPHYS_SHAPE_MESH, w->mesh, &where, LAYER_SOLID | LAYER_SHOWN, TAG(KIND_COPY, i));
    }
}

/* Ropes with slack between the posts, and ropes with a weight at their end, laid outward. */
static void add_ropes(world* w) {
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc), "body desc");
    desc.mass = 0.5f;
    desc.radius = rope_radius;
    desc.damping = 0.3f;
    desc.layers = LAYER_SOLID;
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
    }
}

/* Particle number i of the sheet's border, of 4 * (CLOTH_SIDE - 1), in a circle. */
static uint32_t on_border(uint32_t i) {
    const uint32_t last = CLOTH_SIDE - 1, along = i % last;
    switch (i / last % 4) {
        case 0:
            return along;
        case 1:
            return along * CLOTH_SIDE + last;
        case 2:
            return last * CLOTH_SIDE + last - along;
        default:
            return (last - along) * CLOTH_SIDE;
    }
}

/* The triangles that show the cloth: its two faces, and a hem between them, so that it has a thickness. */
static void add_faces(world* w) {
    enum { POINTS = CLOTH_SIDE * CLOTH_SIDE, BORDER = 4 * (CLOTH_SIDE - 1), TURNED = POINTS };
    triangle_mesh* cloth = &w->cloth;
    cloth->vertex_count = 2 * POINTS;
    cloth->index_count = 3 * (2 * CLOTH_FACE + 2 * BORDER);
    cloth->vertices = calloc(cloth->vertex_count, sizeof *cloth->vertices);
    cloth->normals = calloc(cloth->vertex_count, sizeof *cloth->normals);
    cloth->indices = calloc(cloth->index_count, sizeof *cloth->indices);
    uint32_t total, *out = cloth->indices + 3 * CLOTH_FACE;
    check(gphys_solver_get_triangles(w->solver, w->cloth_body, cloth->indices, 3 * CLOTH_FACE, &total),
          "cloth triangles");
    for (uint32_t i = 0; i < 3 * CLOTH_FACE; i += 3) {
        *out++ = cloth->indices[i] + TURNED;
        *out++ = cloth->indices[i + 2] + TURNED;
        *out++ = cloth->indices[i + 1] + TURNED;
    }
    for (uint32_t i = 0; i < BORDER; ++i) {
        const uint32_t a = on_border(i), b = on_border(i + 1);
        const uint32_t hem[6] = {a, a + TURNED, b, b, a + TURNED, b + TURNED};
        for (int k = 0; k < 6; ++k) *out++ = hem[k];
    }
}

static void add_cloth(world* w) {
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc), "body desc");
    desc.mass = 2;
    desc.radius = cloth_radius;
    desc.damping = 0.4f;
    desc.friction = 0.6f;
    desc.layers = LAYER_SOLID;
    const gphys_vec3 corner = {-2, 2.95f, -2}, u = {4, 0, 0}, v = {0, 0, 4};
    desc.cloth_flags = GPHYS_CLOTH_BEND; /* woven: it shears, and so lies on what is round both ways */
    check(gphys_solver_add_cloth(w->solver, &desc, &corner, &u, &v, CLOTH_SIDE, CLOTH_SIDE, &w->cloth_body), "cloth");

    add_faces(w);
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

/* Remove the models that show bodies; they are the ones that are not solid. */
static void forget_shown(world* w) {
    uint32_t total = 0;
    check(gphys_scene_get_models(w->scene, NULL, 0, &total), "models");
    gphys_model_id* ids = malloc((total + 1) * sizeof *ids);
    check(gphys_scene_get_models(w->scene, ids, total, &total), "models");
    for (uint32_t i = 0; i < total; ++i) {
        gphys_model_info info;
        check(gphys_scene_get_info(w->scene, ids[i], &info), "model info");
        if (info.layers == LAYER_SHOWN) {
            check(gphys_scene_remove(w->scene, ids[i]), "remove");
            --w->model_count;
        }
    }
    free(ids);
    gphys_mesh_destroy(w->cloth_mesh);
    w->cloth_mesh = NULL;
}

void world_show_bodies(world* w) {
    forget_shown(w);
    enum { POINTS = CLOTH_SIDE * CLOTH_SIDE };
    triangle_mesh* cloth = &w->cloth;
    gphys_vec3* vertices = cloth->vertices;
    check(gphys_solver_get_positions(w->solver, w->cloth_body, 0, POINTS, vertices, sizeof vertices[0]),
          "cloth positions");
    /* The faces lie to both sides of the particles, by half of their radius. */
    memcpy(vertices + POINTS, vertices, POINTS * sizeof *vertices);
    compute_normals(&(triangle_mesh){vertices, cloth->normals, cloth->indices, POINTS, 3 * CLOTH_FACE});
    for (uint32_t i = 0; i < POINTS; ++i) {
        const gphys_vec3 n = cloth->normals[i], p = vertices[i];
        const float half = 0.5f * cloth_radius;
        vertices[i] = (gphys_vec3){p.x + half * n.x, p.y + half * n.y, p.z + half * n.z};
        vertices[i + POINTS] = (gphys_vec3){p.x - half * n.x, p.y - half * n.y, p.z - half * n.z};
        cloth->normals[i + POINTS] = (gphys_vec3){-n.x, -n.y, -n.z};
    }
    check(gphys_mesh_create(NULL, &cloth->vertices[0].x, sizeof cloth->vertices[0], cloth->vertex_count, cloth->indices,
                            cloth->index_count, &w->cloth_mesh),
          "cloth mesh");
    add(w, GPHYS_SHAPE_MESH, w->cloth_mesh, &identity, LAYER_SHOWN, TAG(KIND_CLOTH, 0));
    gphys_vec3 points[ROPE_LINKS + 1];
    for (int i = 0; i < ROPE_COUNT; ++i) {
        check(gphys_solver_get_positions(w->solver, w->ropes[i], 0, ROPE_LINKS + 1, points, sizeof points[0]), "rope");
        for (int k = 0; k < ROPE_LINKS; ++k) {
            const gphys_capsule link = {points[k], points[k + 1], rope_radius};
            add(w, GPHYS_SHAPE_CAPSULE, &link, NULL, LAYER_SHOWN, TAG(KIND_ROPE, i));
        }
        if (i >= POST_COUNT) {
            const gphys_sphere weight = {points[ROPE_LINKS], 0.12f};
            add(w, GPHYS_SHAPE_SPHERE, &weight, NULL, LAYER_SHOWN, TAG(KIND_WEIGHT, i));
        }
    }
}

void world_destroy(world* w) {
    gphys_solver_destroy(w->solver);
    gphys_scene_destroy(w->scene);
    gphys_mesh_destroy(w->cloth_mesh);
    gphys_mesh_destroy(w->mesh);
    free_mesh(&w->source);
    free_mesh(&w->cloth);
}

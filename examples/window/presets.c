/* The presets: eight stages that show what the library is for. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "window.h"

const char* const preset_names[PRESET_COUNT] = {
    "statues",  "cloth on anything", "rope bridge",   "curtain and walker",
    "ball pit", "lidar sweep",       "100 000 boxes", "far from the origin"};

static const colour stone = {0.55f, 0.56f, 0.60f}, wood = {0.46f, 0.31f, 0.19f}, ivory = {0.85f, 0.80f, 0.68f},
                    grass = {0.46f, 0.53f, 0.42f};

/* The same numbers in each run. */
static float uniform(uint32_t* state, float low, float high) {
    *state = *state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(*state >> 8) / 16777216.0f;
}

/* Colours far apart for successive numbers: steps of the golden angle around the hue circle. */
static colour hue(uint32_t number) {
    const float h = 2.39996323f * (float)number;
    return (colour){0.56f + 0.30f * cosf(h), 0.56f + 0.30f * cosf(h - 2.0943951f),
                    0.56f + 0.30f * cosf(h + 2.0943951f)};
}

static void remember(stage* s, gphys_model_id id, const look* shown) {
    const uint32_t slot = id & SLOT_MASK;
    if (slot >= s->look_count) {
        const uint32_t count = slot + 1 + slot / 2;
        s->looks = realloc(s->looks, count * sizeof *s->looks);
        if (!s->looks) exit(1);
        memset(s->looks + s->look_count, 0, (count - s->look_count) * sizeof *s->looks);
        s->look_count = count;
    }
    s->looks[slot] = *shown;
}

/* Add a model whose shape is in the look already. */
static gphys_model_id add(stage* s, const look* shown, const gphys_transform* where) {
    gphys_model_id id;
    const void* shape = shown->type == GPHYS_SHAPE_MESH ? (const void*)s->mesh : (const void*)&shown->shape;
    check(gphys_scene_add(s->scene, shown->type, shape, where, NULL, &id), "add model");
    check(gphys_scene_set_layers(s->scene, id, SOLID), "layers");
    remember(s, id, shown);
    return id;
}

static gphys_model_id add_box(stage* s, gphys_vec3 low, gphys_vec3 high, colour c) {
    const look shown = {GPHYS_SHAPE_AABB, {.box = {low, high}}, c};
    return add(s, &shown, NULL);
}

static gphys_model_id add_sphere(stage* s, gphys_vec3 center, float radius, colour c) {
    const look shown = {GPHYS_SHAPE_SPHERE, {.sphere = {center, radius}}, c};
    return add(s, &shown, NULL);
}

static gphys_model_id add_capsule(stage* s, gphys_vec3 a, gphys_vec3 b, float radius, colour c) {
    const look shown = {GPHYS_SHAPE_CAPSULE, {.capsule = {a, b, radius}}, c};
    return add(s, &shown, NULL);
}

static gphys_model_id add_statue(stage* s, gphys_vec3 at, float angle, float scale, colour c) {
    const look shown = {GPHYS_SHAPE_MESH, {.plane = {{0, 0, 0}, 0}}, c};
    s->shows_mesh = 1;
    const gphys_transform where = {at, {0, sinf(angle / 2), 0, cosf(angle / 2)}, scale};
    return add(s, &shown, &where);
}

static void add_ground(stage* s) {
    const look shown = {GPHYS_SHAPE_PLANE, {.plane = {{0, 1, 0}, 0}}, grass};
    add(s, &shown, NULL);
}

static gphys_body_desc body(float mass, float radius) {
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc), "body desc");
    desc.mass = mass;
    desc.radius = radius;
    desc.damping = 0.3f;
    desc.layers = SOLID;
    return desc;
}

/* A square sheet whose cells yield in their plane, and so lie on what is round both ways: as woven cloth, by springs of
 * 30 rad/s a particle. */
static gphys_body_desc woven(float mass, float radius, uint32_t side) {
    gphys_body_desc desc = body(mass, radius);
    desc.shear_compliance = (float)(side * side) / (mass * 30 * 30);
    return desc;
}

static void keep(stage* s, gphys_body_id id, float radius, colour c) {
    gphys_mesh* mesh; /* has the form of the body, for the mouse to find */
    gphys_model_id model;
    gphys_model_desc desc;
    check(gphys_mesh_create_from_body(NULL, s->solver, id, &mesh), "mesh of a body");
    check(gphys_model_desc_init(&desc, sizeof desc), "model desc");
    desc.layers = BODY;
    desc.tag = s->body_count;
    check(gphys_scene_add(s->scene, GPHYS_SHAPE_MESH, mesh, NULL, &desc, &model), "model of a body");
    gphys_mesh_destroy(mesh);
    s->bodies[s->body_count] = id;
    s->body_radii[s->body_count] = radius;
    s->body_colours[s->body_count++] = c;
}

static gphys_body_id add_cloth(stage* s, const gphys_body_desc* desc, gphys_vec3 corner, gphys_vec3 u, gphys_vec3 v,
                               uint32_t columns, uint32_t rows, colour c) {
    gphys_body_id id;
    check(gphys_solver_add_cloth(s->solver, desc, &corner, &u, &v, columns, rows, &id), "cloth");
    keep(s, id, desc->radius, c);
    return id;
}

/* A rope of 32 links from a to b, longer than the way by a factor, pinned at both ends. */
static gphys_body_id add_rope(stage* s, gphys_vec3 a, gphys_vec3 b, float slack, colour c) {
    enum { LINKS = 32 };
    gphys_vec3 points[LINKS + 1];
    for (int i = 0; i <= LINKS; ++i) {
        const float t = (float)i / LINKS;
        points[i] = (gphys_vec3){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    }
    const float length = sqrtf((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y) + (b.z - a.z) * (b.z - a.z));
    const gphys_body_desc desc = body(2, 0.03f);
    gphys_body_id id;
    check(gphys_solver_add_rope(s->solver, &desc, points, sizeof points[0], LINKS + 1, slack * length / LINKS, &id),
          "rope");
    check(gphys_solver_set_pinned(s->solver, id, 0, 1, 1), "pin");
    check(gphys_solver_set_pinned(s->solver, id, LINKS, 1, 1), "pin");
    keep(s, id, desc.radius, c);
    return id;
}

static void statues(stage* s) {
    add_ground(s);
    uint32_t random = 7;
    for (uint32_t i = 0; i < 300; ++i) { /* a sunflower's spiral spreads them evenly (Vogel 1979) */
        const float angle = 2.39996323f * (float)i, radius = sqrtf(12 + 1.1f * (float)i);
        add_statue(s, (gphys_vec3){radius * cosf(angle), 0, radius * sinf(angle)}, uniform(&random, 0, 6.28f),
                   uniform(&random, 0.6f, 1.0f), hue(i));
    }
    add_statue(s, (gphys_vec3){0, 0, 0}, 0.4f, 2.4f, ivory);
    const gphys_body_desc desc = woven(2, 0.02f, 48);
    add_cloth(s, &desc, (gphys_vec3){-1.6f, 2.7f, -1.6f}, (gphys_vec3){3.2f, 0, 0}, (gphys_vec3){0, 0, 3.2f}, 48, 48,
              (colour){0.75f, 0.16f, 0.18f});
    s->view.distance = 9;
}

static void cloth_on_anything(stage* s) {
    add_ground(s);
    add_sphere(s, (gphys_vec3){-3.6f, 1, 0}, 1, stone);
    add_box(s, (gphys_vec3){-2.0f, 0, -0.8f}, (gphys_vec3){-0.4f, 1.6f, 0.8f}, stone);
    add_capsule(s, (gphys_vec3){0.9f, 0.6f, -0.7f}, (gphys_vec3){2.1f, 1.4f, 0.7f}, 0.5f, stone);
    add_statue(s, (gphys_vec3){4.0f, 0, 0}, 0.6f, 2.0f, ivory);
    for (int i = 0; i < 4; ++i) {
        const gphys_body_desc desc = woven(1, 0.02f, 32);
        add_cloth(s, &desc, (gphys_vec3){-4.6f + 2.4f * (float)i + 0.05f * (float)(i == 3), 2.4f, -1},
                  (gphys_vec3){2, 0, 0}, (gphys_vec3){0, 0, 2}, 32, 32, hue((uint32_t)i + 1));
    }
    s->view.distance = 10;
}

static void rope_bridge(stage* s) {
    enum { COLUMNS = 72, ROWS = 10 };
    add_ground(s);
    add_box(s, (gphys_vec3){-7, 0, -2}, (gphys_vec3){-4, 2.5f, 2}, stone);
    add_box(s, (gphys_vec3){4, 0, -2}, (gphys_vec3){7, 2.5f, 2}, stone);
    gphys_body_desc desc = body(120, 0.05f); /* heavy and damped, so that the balls do not leap */
    desc.damping = 2;
    desc.cloth_flags = GPHYS_CLOTH_BEND;
    desc.body_layers = 1;
    const gphys_body_id deck = add_cloth(s, &desc, (gphys_vec3){-4.1f, 2.56f, -0.6f}, (gphys_vec3){8.2f, 0, 0},
                                         (gphys_vec3){0, 0, 1.2f}, COLUMNS, ROWS, wood);
    for (uint32_t row = 0; row < ROWS; ++row) {
        check(gphys_solver_set_pinned(s->solver, deck, row * COLUMNS, 1, 1), "pin");
        check(gphys_solver_set_pinned(s->solver, deck, row * COLUMNS + COLUMNS - 1, 1, 1), "pin");
    }
    for (int side = -1; side <= 1; side += 2) {
        const float z = 0.62f * (float)side;
        for (int end = -1; end <= 1; end += 2) {
            const float x = 4.15f * (float)end;
            add_capsule(s, (gphys_vec3){x, 2.5f, z}, (gphys_vec3){x, 3.5f, z}, 0.07f, wood);
        }
        const gphys_body_id rope = add_rope(s, (gphys_vec3){-4.15f, 3.55f, z}, (gphys_vec3){4.15f, 3.55f, z}, 1.01f,
                                            (colour){0.80f, 0.68f, 0.40f});
        /* Strings hold the deck below the rope. */
        for (uint32_t i = 2; i < 31; i += 2) {
            gphys_joint_id joint;
            const uint32_t column = i * (COLUMNS - 1) / 32, row = side < 0 ? 0 : ROWS - 1;
            check(gphys_solver_join(s->solver, rope, i, deck, row * COLUMNS + column, -1, 0.0001f, &joint), "join");
        }
    }
    gphys_body_desc balls = body(24, 0.3f);
    balls.body_layers = 1;
    balls.self_collision = 1;
    gphys_vec3 places[6];
    for (int i = 0; i < 6; ++i)
        places[i] = (gphys_vec3){-1.8f + 0.72f * (float)i, 3.6f + 0.5f * (float)i, 0.05f * (float)(i % 3)};
    gphys_body_id id;
    check(gphys_solver_add_particles(s->solver, &balls, places, sizeof places[0], 6, &id), "balls");
    keep(s, id, balls.radius, (colour){0.20f, 0.42f, 0.70f});
    s->view.distance = 11;
    s->view.target.y = 2;
}

static void curtain(stage* s) {
    enum { COLUMNS = 64, ROWS = 44 };
    add_ground(s);
    add_capsule(s, (gphys_vec3){-2.3f, 3, 0}, (gphys_vec3){2.3f, 3, 0}, 0.06f, wood);
    gphys_body_desc desc = body(3, 0.02f);
    desc.cloth_flags = GPHYS_CLOTH_BEND;
    for (int half = 0; half < 2; ++half) {
        const gphys_body_id cloth =
            add_cloth(s, &desc, (gphys_vec3){half ? 0.03f : -2.2f, 2.9f, 0}, (gphys_vec3){2.17f, 0, 0},
                      (gphys_vec3){0, -2.75f, 0}, COLUMNS / 2, ROWS, (colour){0.78f, 0.20f, 0.18f});
        for (uint32_t i = 0; i < COLUMNS / 2; i += 2) check(gphys_solver_set_pinned(s->solver, cloth, i, 1, 1), "pin");
    }
    s->walker =
        add_capsule(s, (gphys_vec3){0, 0.35f, 0}, (gphys_vec3){0, 1.45f, 0}, 0.35f, (colour){0.90f, 0.55f, 0.15f});
    s->view.distance = 8;
    s->view.yaw = 2.4f; /* with the sun */
    s->view.target.y = 1.5f;
}

static void ball_pit(stage* s) {
    enum { SIDE = 12, LAYERS = 10 };
    add_ground(s);
    const float a = 1.7f, b = 1.9f, high = 1.3f;
    add_box(s, (gphys_vec3){-b, 0, -b}, (gphys_vec3){-a, high, b}, wood);
    add_box(s, (gphys_vec3){a, 0, -b}, (gphys_vec3){b, high, b}, wood);
    add_box(s, (gphys_vec3){-a, 0, -b}, (gphys_vec3){a, high, -a}, wood);
    add_box(s, (gphys_vec3){-a, 0, a}, (gphys_vec3){a, high, b}, wood);
    uint32_t random = 3;
    for (uint32_t c = 0; c < 5; ++c) { /* bodies are coloured, so there are five */
        gphys_vec3 places[SIDE * SIDE * LAYERS / 5];
        uint32_t count = 0;
        for (uint32_t i = c; i < SIDE * SIDE * LAYERS; i += 5) {
            places[count++] =
                (gphys_vec3){0.25f * ((float)(i % SIDE) - 0.5f * (SIDE - 1)) + uniform(&random, -0.02f, 0.02f),
                             1.5f + 0.25f * (float)(i / SIDE / SIDE),
                             0.25f * ((float)(i / SIDE % SIDE) - 0.5f * (SIDE - 1)) + uniform(&random, -0.02f, 0.02f)};
        }
        gphys_body_desc desc = body(0.1f * (float)count, 0.11f);
        desc.self_collision = 1;
        desc.body_layers = 1;
        desc.restitution = 0.3f;
        desc.friction = 0.2f;
        gphys_body_id id;
        check(gphys_solver_add_particles(s->solver, &desc, places, sizeof places[0], count, &id), "balls");
        keep(s, id, desc.radius, hue(c + 3));
    }
    s->view.distance = 8;
}

/* A town of boxes around a sensor. */
static void lidar(stage* s) {
    add_ground(s);
    uint32_t random = 11;
    for (int i = 0; i < 400; ++i) {
        const float x = uniform(&random, -40, 40), z = uniform(&random, -40, 40);
        if (x * x + z * z < 36) continue;
        const float w = uniform(&random, 0.6f, 2), d = uniform(&random, 0.6f, 2), h = uniform(&random, 0.5f, 5);
        add_box(s, (gphys_vec3){x - w, 0, z - d}, (gphys_vec3){x + w, h, z + d}, (colour){0.5f, 0.5f, 0.52f});
    }
    for (uint32_t i = 0; i < 20; ++i) {
        const float angle = 0.314159f * (float)i;
        add_statue(s, (gphys_vec3){9 * cosf(angle), 0, 9 * sinf(angle)}, -angle, 2, hue(i));
    }
    s->walker = add_capsule(s, (gphys_vec3){0, 0.3f, 0}, (gphys_vec3){0, 1.3f, 0}, 0.3f, (colour){0.90f, 0.55f, 0.15f});
    s->lidar = calloc(LIDAR_RINGS * LIDAR_COLUMNS, sizeof *s->lidar);
    if (!s->lidar) exit(1);
    s->view.distance = 30;
    s->view.pitch = 0.6f;
}

static void many_boxes(stage* s) {
    enum { COUNT = 100000 };
    const gphys_aabb unit = {{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}};
    gphys_transform* places = calloc(COUNT, sizeof *places);
    gphys_model_id* ids = calloc(COUNT, sizeof *ids);
    if (!places || !ids) exit(1);
    uint32_t random = 5;
    for (uint32_t i = 0; i < COUNT; ++i) {
        /* A direction of even density, and a distance that fills a ball with a hole. */
        const float y = uniform(&random, -1, 1), angle = uniform(&random, 0, 6.2831853f);
        const float r = sqrtf(1 - y * y), far = 30 + 70 * cbrtf(uniform(&random, 0, 1));
        const float turn = uniform(&random, 0, 3.14f);
        places[i] = (gphys_transform){{far * r * cosf(angle), far * y, far * r * sinf(angle)},
                                      {0.6f * sinf(turn), 0.8f * sinf(turn), 0, cosf(turn)},
                                      uniform(&random, 0.3f, 1.5f)};
    }
    check(gphys_scene_add_batch(s->scene, GPHYS_SHAPE_AABB, &unit, 0, places, sizeof *places, COUNT, NULL, ids),
          "add boxes");
    for (uint32_t i = 0; i < COUNT; ++i) {
        const look shown = {GPHYS_SHAPE_AABB, {.box = unit}, hue(i)};
        remember(s, ids[i], &shown);
    }
    free(places);
    free(ids);
    s->view.distance = 12;
    s->view.target.y = 0;
}

/* Ten thousand kilometres from the origin of the world a float's step is a metre; none of that is seen. */
static void far_away(stage* s) {
    const double origin[3] = {1e7, 0, -1e7};
    memcpy(s->origin, origin, sizeof origin);
    check(gphys_scene_set_origin(s->scene, origin), "origin");
    check(gphys_solver_set_origin(s->solver, origin), "origin");
    cloth_on_anything(s);
}

/* A trefoil knot as a tube, standing on the ground: the mesh where no file is given. */
static void knot(triangle_mesh* mesh) {
    enum { ALONG = 96, AROUND = 14 };
    *mesh = (triangle_mesh){calloc(ALONG * AROUND, sizeof(gphys_vec3)), calloc(ALONG * AROUND, sizeof(gphys_vec3)),
                            calloc(6 * ALONG * AROUND, sizeof(uint32_t)), ALONG * AROUND, 6 * ALONG * AROUND};
    if (!mesh->vertices || !mesh->normals || !mesh->indices) exit(1);
    uint32_t* corner = mesh->indices;
    for (uint32_t i = 0; i < ALONG; ++i) {
        gphys_vec3 p[2]; /* the curve here and a little further on */
        for (int k = 0; k < 2; ++k) {
            const float t = 6.2831853f * ((float)i + 0.01f * (float)k) / ALONG, r = 2 + cosf(3 * t);
            p[k] = (gphys_vec3){r * cosf(2 * t), r * sinf(2 * t), 1.1f * sinf(3 * t)};
        }
        const float tx = p[1].x - p[0].x, ty = p[1].y - p[0].y, tz = p[1].z - p[0].z;
        const float flat = sqrtf(tx * tx + ty * ty), full = sqrtf(tx * tx + ty * ty + tz * tz);
        const gphys_vec3 side = {ty / flat, -tx / flat, 0};
        const gphys_vec3 up = {-side.y * tz / full, side.x * tz / full, (side.y * tx - side.x * ty) / full};
        for (uint32_t j = 0; j < AROUND; ++j) {
            const float angle = 6.2831853f * (float)j / AROUND, a = 0.62f * cosf(angle), b = 0.62f * sinf(angle);
            mesh->vertices[i * AROUND + j] =
                (gphys_vec3){(p[0].x + a * side.x + b * up.x) / 7.2f, (p[0].y + a * side.y + b * up.y) / 7.2f + 0.5f,
                             (p[0].z + b * up.z) / 7.2f};
            const uint32_t next = (i + 1) % ALONG * AROUND, turn = (j + 1) % AROUND;
            const uint32_t quad[6] = {i * AROUND + j,    next + j, i * AROUND + turn,
                                      i * AROUND + turn, next + j, next + turn};
            for (int k = 0; k < 6; ++k) *corner++ = quad[k];
        }
    }
    compute_normals(mesh);
}

int stage_create(stage* s, uint32_t preset, const char* path) {
    static void (*const builders[PRESET_COUNT])(stage*) = {statues, cloth_on_anything, rope_bridge, curtain, ball_pit,
                                                           lidar,   many_boxes,        far_away};
    *s = (stage){0};
    if (path == NULL) {
        knot(&s->source);
    } else if (load_mesh(path, &s->source) != 0) {
        return -1;
    }
    check(gphys_mesh_create(NULL, &s->source.vertices[0].x, sizeof s->source.vertices[0], s->source.vertex_count,
                            s->source.indices, s->source.index_count, &s->mesh),
          "create mesh");
    gphys_scene_desc scene;
    check(gphys_scene_desc_init(&scene, sizeof scene), "scene desc");
    scene.worker_count = worker_count();
    check(gphys_scene_create(&scene, &s->scene), "create scene");
    gphys_solver_desc desc;
    check(gphys_solver_desc_init(&desc, sizeof desc), "solver desc");
    desc.worker_count = worker_count();
    desc.max_strain = 0.02f; /* as many substeps as that takes */
    check(gphys_solver_create(&desc, &s->solver), "create solver");
    check(gphys_orbit_init(&s->view), "orbit");
    s->view.target = (gphys_vec3){0, 0.8f, 0};
    s->view.yaw = 0.6f;
    s->view.pitch = 0.35f;
    s->view.radians_per_unit = 0.006f;
    s->view.metres_per_unit = 0.01f;
    builders[preset](s);
    return 0;
}

static void walk(stage* s) {
    const float t = (float)s->time;
    const gphys_vec3 at = s->lidar ? (gphys_vec3){3 * cosf(0.4f * t), 0, 3 * sinf(0.4f * t)}
                                   : (gphys_vec3){1.1f * sinf(0.45f * t), 0, 2.2f * cosf(0.9f * t)};
    const gphys_transform where = {at, {0, 0, 0, 1}, 1};
    check(gphys_scene_set_transform(s->scene, s->walker, &where), "walk");
}

/* A sensor above the walker's head scans its surroundings in rings, from 25 degrees down to 5 up. It ignores
 * the walker. */
static void sweep(stage* s) {
    static gphys_ray rays[LIDAR_RINGS * LIDAR_COLUMNS];
    gphys_transform where;
    check(gphys_scene_get_world_transforms(s->scene, &s->walker, 1, &where, sizeof where), "walker");
    s->lidar_at = (gphys_vec3){where.position.x, where.position.y + 1.9f, where.position.z};
    for (uint32_t ring = 0; ring < LIDAR_RINGS; ++ring) {
        const float pitch = -0.44f + 0.53f * (float)ring / (LIDAR_RINGS - 1);
        for (uint32_t column = 0; column < LIDAR_COLUMNS; ++column) {
            const float yaw = 6.2831853f * (float)column / LIDAR_COLUMNS;
            rays[ring * LIDAR_COLUMNS + column] =
                (gphys_ray){s->lidar_at, {cosf(pitch) * cosf(yaw), sinf(pitch), cosf(pitch) * sinf(yaw)}, 60};
        }
    }
    gphys_query_filter_desc filter;
    check(gphys_query_filter_desc_init(&filter, sizeof filter), "filter");
    filter.ignored_model = s->walker;
    check(gphys_scene_raycast_filtered_batch(s->scene, rays, sizeof rays[0], LIDAR_RINGS * LIDAR_COLUMNS, &filter, 0,
                                             s->lidar, sizeof *s->lidar),
          "sweep");
}

void stage_step(stage* s, float time) {
    s->time += time;
    if (s->walker) walk(s);
    check(gphys_solver_advance(s->solver, s->scene, time, NULL, NULL), "advance");
    if (s->lidar) sweep(s);
}

void stage_destroy(stage* s) {
    gphys_solver_destroy(s->solver);
    gphys_scene_destroy(s->scene);
    gphys_mesh_destroy(s->mesh);
    free_mesh(&s->source);
    free(s->looks);
    free(s->lidar);
    *s = (stage){0};
}

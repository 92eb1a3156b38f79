/* The same calls give the same bits on every machine: states of solvers, matrices of cameras and answers to
 * queries, each group reduced to one number, which is recorded below. Everything that goes in is made of
 * integers and single correctly rounded divisions, so that this program does not depend on the machine either.
 *
 * Where an answer is meant to change, GPHYS_PRINT_GOLDEN=1 c_test_golden prints the new table. */
#include "test.h"

#include <stdio.h>
#include <stdlib.h>

enum { GROUPS = 12 };

static const struct golden {
    const char* group;
    uint32_t high, low;
} recorded[GROUPS] = {
    /* clang-format off */
    {"particles", 0x5cce72db, 0x995591b2},
    {"ropes", 0x080daaae, 0x15ba0e4f},
    {"cloth", 0x51132709, 0x70ce1807},
    {"joints", 0x437c3738, 0x8f46ecf8},
    {"moving_models", 0xbffa25e3, 0x0a788959},
    {"cameras", 0xf3b8b092, 0x13040e63},
    {"orbits", 0x62b53876, 0x7d2e2ab7},
    {"queries", 0x0825934e, 0x151790c5},
    {"shapes", 0x67a709b4, 0x62fe01be},
    {"targets", 0x08027272, 0x0cce8fe3},
    {"clusters", 0xcb7a1181, 0x12c19de6},
    {"tears", 0xa28a6eaf, 0x18f9da6c},
};

/* FNV-1a of 64 bits over 32-bit words. */
typedef struct hash {
    uint64_t value;
} hash;

static hash begin_hash(void) {
    const hash h = {(uint64_t)0xcbf29ce4u << 32 | 0x84222325u};
    return h;
}

static void add_word(hash* h, uint32_t word) { h->value = (h->value ^ word) * ((uint64_t)0x100 << 32 | 0x1b3u); }

/* Structs of four-byte fields. */
static void add(hash* h, const void* data, size_t size) {
    uint32_t word;
    size_t i;
    for (i = 0; i + sizeof word <= size; i += sizeof word) {
        memcpy(&word, (const char*)data + i, sizeof word);
        add_word(h, word);
    }
}

static void add_state(hash* h, const gphys_solver* solver) {
    uint32_t words[2];
    assert_int_equal(gphys_solver_get_hash(solver, words), GPHYS_OK);
    add(h, words, sizeof words);
}

/* Ids are not part of the answer: tags are. */
static void add_hits(hash* h, gphys_hit* hits, size_t count) {
    size_t i;
    for (i = 0; i < count; ++i) {
        hits[i].model = 0;
        add(h, &hits[i], sizeof hits[i]);
    }
}

static void add_near(hash* h, gphys_nearest* found, size_t count) {
    size_t i;
    for (i = 0; i < count; ++i) {
        found[i].model = 0;
        add(h, &found[i], sizeof found[i]);
    }
}

/* splitmix64 (Steele, Lea, Flood 2014). */
static uint64_t random_state;

static uint32_t random_word(void) {
    uint64_t z = random_state += (uint64_t)0x9e3779b9u << 32 | 0x7f4a7c15u;
    z = (z ^ z >> 30) * ((uint64_t)0xbf58476du << 32 | 0x1ce4e5b9u);
    z = (z ^ z >> 27) * ((uint64_t)0x94d049bbu << 32 | 0x133111ebu);
    return (uint32_t)(z >> 32);
}
/* A multiple of 1/1024, from low to high; both are whole. */
static float random_float(int low, int high) {
    return (float)(low * 1024 + (int)(random_word() % (uint32_t)((high - low) * 1024))) / 1024;
}
static gphys_vec3 random_point(int extent) {
    gphys_vec3 p;
    p.x = random_float(-extent, extent);
    p.y = random_float(-extent, extent);
    p.z = random_float(-extent, extent);
    return p;
}
static gphys_vec3 point(float x, float y, float z) {
    gphys_vec3 p;
    p.x = x;
    p.y = y;
    p.z = z;
    return p;
}

/* About an axis by the angle whose half has the tangent 2 m n / (m m - n n). */
static gphys_transform placed(gphys_vec3 position, int axis, int m, int n) {
    gphys_transform t;
    const float sine = (float)(2 * m * n) / (float)(m * m + n * n);
    t.position = position;
    t.rotation.x = axis == 0 ? sine : 0;
    t.rotation.y = axis == 1 ? sine : 0;
    t.rotation.z = axis == 2 ? sine : 0;
    t.rotation.w = (float)(m * m - n * n) / (float)(m * m + n * n);
    t.scale = 1;
    return t;
}

static gphys_scene* make_scene(uint32_t workers) {
    gphys_scene_desc desc;
    gphys_scene* scene;
    assert_int_equal(gphys_scene_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.worker_count = workers;
    assert_int_equal(gphys_scene_create(&desc, &scene), GPHYS_OK);
    return scene;
}

static gphys_solver* make_solver(uint32_t workers, uint32_t substeps) {
    gphys_solver_desc desc;
    gphys_solver* solver;
    assert_int_equal(gphys_solver_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.worker_count = workers;
    desc.substeps = substeps;
    assert_int_equal(gphys_solver_create(&desc, &solver), GPHYS_OK);
    return solver;
}

static gphys_model_id put(gphys_scene* scene, gphys_shape_type type, const void* shape, const gphys_transform* place,
                          uint32_t tag) {
    gphys_model_desc desc;
    gphys_model_id model;
    assert_int_equal(gphys_model_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.tag = tag;
    assert_int_equal(gphys_scene_add(scene, type, shape, place, &desc, &model), GPHYS_OK);
    return model;
}

static void put_floor(gphys_scene* scene) {
    const gphys_plane floor = {{0, 1, 0}, 0};
    put(scene, GPHYS_SHAPE_PLANE, &floor, NULL, 1);
}

static void run_steps(hash* h, gphys_solver* solver, const gphys_scene* scene, int count) {
    int i;
    for (i = 0; i < count; ++i) assert_int_equal(gphys_solver_step(solver, scene, 1.0f / 60), GPHYS_OK);
    add_state(h, solver);
}

/* 600 worlds of free particles that bounce and are slowed down. */
static uint64_t particles(uint32_t workers) {
    enum { WORLDS = 600, COUNT = 6 };
    hash h = begin_hash();
    int world, i;
    for (world = 0; world < WORLDS; ++world) {
        gphys_scene* scene = make_scene(1);
        gphys_solver* solver = make_solver(workers, 4);
        gphys_body_desc desc;
        gphys_body_id body;
        gphys_vec3 positions[COUNT], velocities[COUNT];
        gphys_sphere ball;
        gphys_aabb box;
        random_state = (uint64_t)world;
        put_floor(scene);
        ball.center = random_point(2);
        ball.radius = random_float(0, 1) + 0.25f;
        put(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, 2);
        box.min = random_point(2);
        box.max = point(box.min.x + 1, box.min.y + 0.5f, box.min.z + 2);
        put(scene, GPHYS_SHAPE_AABB, &box, NULL, 3);
        gphys_body_desc_init(&desc, sizeof desc);
        desc.damping = random_float(0, 2) + 0.125f;
        desc.restitution = 0.5f + random_float(0, 1) / 2;
        desc.friction = random_float(0, 1);
        for (i = 0; i < COUNT; ++i) {
            positions[i] = random_point(2);
            positions[i].y += 3;
            velocities[i] = random_point(8);
        }
        assert_int_equal(gphys_solver_add_particles(solver, &desc, positions, sizeof *positions, COUNT, &body),
                         GPHYS_OK);
        assert_int_equal(gphys_solver_set_velocities(solver, body, 0, COUNT, velocities, sizeof *velocities), GPHYS_OK);
        run_steps(&h, solver, scene, 120);
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
    }
    return h.value;
}

/* Ropes with and without damping, some attached to a model that turns, some that fall onto shapes. */
static uint64_t ropes(uint32_t workers) {
    enum { ROPES = 24, COUNT = 14 };
    hash h = begin_hash();
    gphys_scene* scene = make_scene(1);
    gphys_solver* solver = make_solver(workers, 4);
    const gphys_sphere ball = {{0.5f, 1, 0.5f}, 0.375f};
    const gphys_capsule bar = {{-1, 0.5f, 0}, {2, 0.75f, 1}, 0.125f};
    const gphys_aabb beam = {{-2, -0.125f, -0.125f}, {2, 0.125f, 0.125f}};
    gphys_model_id turning;
    int i, k;
    random_state = 1;
    put_floor(scene);
    put(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, 2);
    put(scene, GPHYS_SHAPE_CAPSULE, &bar, NULL, 3);
    turning = put(scene, GPHYS_SHAPE_AABB, &beam, NULL, 4);
    for (i = 0; i < ROPES; ++i) {
        gphys_body_desc desc;
        gphys_body_id body;
        gphys_vec3 positions[COUNT];
        const int count = 3 + i % (COUNT - 2);
        gphys_body_desc_init(&desc, sizeof desc);
        desc.damping = i % 3 == 0 ? 0.5f : 0;
        desc.compliance = i % 4 == 3 ? 0.001f : 0;
        desc.restitution = i % 5 == 4 ? 0.5f : 0;
        for (k = 0; k < count; ++k) {
            positions[k] = point((float)i / 8 - 1, 2 + (float)(i % 4) / 4, (float)k / 8 - 0.5f);
        }
        assert_int_equal(gphys_solver_add_rope(solver, &desc, positions, sizeof *positions, (uint32_t)count, 0, &body),
                         GPHYS_OK);
        if (i % 3 == 1) gphys_solver_set_pinned(solver, body, 0, 1, 1);
        if (i % 6 == 5) {
            const gphys_vec3 end = {i % 4 < 2 ? -2.0f : 2.0f, 0, 0};
            assert_int_equal(gphys_solver_attach(solver, scene, body, 0, turning, &end), GPHYS_OK);
        }
    }
    for (i = 0; i < 40; ++i) {
        const gphys_transform place = placed(point(0, 2, 0), 1, 64, i);
        assert_int_equal(gphys_scene_set_transform(scene, turning, &place), GPHYS_OK);
        run_steps(&h, solver, scene, 1);
    }
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return h.value;
}

/* Sheets that fall onto a ball and a box that turns under them. */
static uint64_t cloth(uint32_t workers) {
    hash h = begin_hash();
    gphys_scene* scene = make_scene(1);
    gphys_solver* solver = make_solver(workers, 4);
    const gphys_sphere ball = {{0, 0.5f, 0}, 0.375f};
    const gphys_obb box = {{0, 0, 0}, {0.5f, 0.125f, 0.25f}, {0, 0, 0, 1}};
    gphys_model_id turning;
    int i;
    put_floor(scene);
    put(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, 2);
    turning = put(scene, GPHYS_SHAPE_OBB, &box, NULL, 3);
    for (i = 0; i < 3; ++i) {
        const gphys_vec3 corner = {(float)i - 0.5f, 1 + (float)i / 8, -0.5f}, u = {1, 0, 0}, v = {0, 0.125f, 1};
        gphys_body_desc desc;
        gphys_body_id body;
        gphys_body_desc_init(&desc, sizeof desc);
        desc.radius = 0.03125f;
        desc.damping = (float)i / 2;
        desc.restitution = i == 1 ? 0.5f : 0;
        desc.self_collision = i == 2;
        desc.body_layers = 1;
        assert_int_equal(gphys_solver_add_cloth(solver, &desc, &corner, &u, &v, 14, 12, &body), GPHYS_OK);
        if (i == 0) gphys_solver_set_pinned(solver, body, 0, 1, 1);
    }
    for (i = 0; i < 40; ++i) {
        const gphys_transform place = placed(point(1, 0.75f, 0), 2, 48, i);
        assert_int_equal(gphys_scene_set_transform(scene, turning, &place), GPHYS_OK);
        run_steps(&h, solver, scene, 1);
    }
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return h.value;
}

/* Chains of ropes and single particles held together, and a star. */
static uint64_t joints(uint32_t workers) {
    enum { COUNT = 8 };
    hash h = begin_hash();
    gphys_scene* scene = make_scene(1);
    gphys_solver* solver = make_solver(workers, 4);
    gphys_body_desc desc;
    gphys_body_id first = 0, body, weight;
    gphys_joint_id joint;
    gphys_vec3 positions[COUNT];
    int i, k;
    put_floor(scene);
    gphys_body_desc_init(&desc, sizeof desc);
    desc.damping = 0.25f;
    for (i = 0; i < 9; ++i) {
        for (k = 0; k < COUNT; ++k) {
            positions[k] = point((float)(k * (i - 4)) / 32, 2, (float)(k * (i % 3 - 1)) / 16 + (float)k / 64);
        }
        assert_int_equal(gphys_solver_add_rope(solver, &desc, positions, sizeof *positions, COUNT, 0, &body), GPHYS_OK);
        if (i == 0) {
            first = body;
            assert_int_equal(gphys_solver_set_pinned(solver, body, 0, 1, 1), GPHYS_OK);
        } else {
            assert_int_equal(gphys_solver_join(solver, body, 0, first, (uint32_t)i % COUNT, 0, 0, &joint), GPHYS_OK);
        }
        positions[0].y = 1.75f;
        desc.mass = (float)(1 + i);
        assert_int_equal(gphys_solver_add_particles(solver, &desc, positions, sizeof *positions, 1, &weight), GPHYS_OK);
        assert_int_equal(gphys_solver_join(solver, body, COUNT - 1, weight, 0, -1, i % 2 ? 0 : 0.001f, &joint),
                         GPHYS_OK);
    }
    for (i = 0; i < 40; ++i) run_steps(&h, solver, scene, 1);
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return h.value;
}

/* Particles among models that turn and move, with drag. */
static uint64_t moving_models(uint32_t workers) {
    enum { MODELS = 6, COUNT = 64 };
    hash h = begin_hash();
    gphys_scene* scene = make_scene(1);
    gphys_solver* solver = make_solver(workers, 2);
    const gphys_aabb paddle = {{-1, -0.25f, -0.125f}, {1, 0.25f, 0.125f}};
    gphys_model_id models[MODELS];
    gphys_body_desc desc;
    gphys_body_id body;
    gphys_vec3 positions[COUNT];
    int i, k;
    random_state = 2;
    put_floor(scene);
    for (i = 0; i < MODELS; ++i) models[i] = put(scene, GPHYS_SHAPE_AABB, &paddle, NULL, (uint32_t)i + 2);
    gphys_body_desc_init(&desc, sizeof desc);
    desc.damping = 0.375f;
    desc.restitution = 0.75f;
    desc.self_collision = 1;
    desc.radius = 0.0625f;
    for (i = 0; i < COUNT; ++i) {
        positions[i] = random_point(2);
        positions[i].y += 3;
    }
    assert_int_equal(gphys_solver_add_particles(solver, &desc, positions, sizeof *positions, COUNT, &body), GPHYS_OK);
    for (i = 0; i < 60; ++i) {
        for (k = 0; k < MODELS; ++k) {
            gphys_transform place =
                placed(point((float)(k - 3) / 2, 0.5f + (float)(k * i) / 256, 0), k % 3, 40, k * i % 40);
            place.scale = 1 + (float)i / 256;
            assert_int_equal(gphys_scene_set_transform(scene, models[k], &place), GPHYS_OK);
        }
        run_steps(&h, solver, scene, 1);
    }
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return h.value;
}

static void add_camera(hash* h, const gphys_camera* camera) {
    gphys_mat4 matrix;
    gphys_frustum frustum;
    gphys_vec3 corners[8], there, back;
    gphys_ray ray;
    assert_int_equal(gphys_camera_get_view_matrix(camera, &matrix), GPHYS_OK);
    add(h, &matrix, sizeof matrix);
    assert_int_equal(gphys_camera_get_projection_matrix(camera, &matrix), GPHYS_OK);
    add(h, &matrix, sizeof matrix);
    assert_int_equal(gphys_camera_get_view_projection_matrix(camera, &matrix), GPHYS_OK);
    add(h, &matrix, sizeof matrix);
    assert_int_equal(gphys_camera_get_frustum(camera, &frustum), GPHYS_OK);
    add(h, &frustum, sizeof frustum);
    assert_int_equal(gphys_camera_get_corners(camera, corners), GPHYS_OK);
    add(h, corners, sizeof corners);
    assert_int_equal(gphys_camera_pick_ray(camera, 123.5f, 45.25f, &ray), GPHYS_OK);
    add(h, &ray, sizeof ray);
    there = point(ray.origin.x + 8 * ray.direction.x, ray.origin.y + 8 * ray.direction.y,
                  ray.origin.z + 8 * ray.direction.z);
    assert_int_equal(gphys_camera_project(camera, &there, &back), GPHYS_OK);
    add(h, &back, sizeof back);
}

/* Fields of view from narrow to wide. */
static uint64_t cameras(uint32_t workers) {
    hash h = begin_hash();
    int i;
    (void)workers;
    for (i = 1; i < 400; ++i) {
        gphys_camera_desc desc;
        gphys_camera* camera;
        const gphys_vec3 eye = {(float)i / 7, 3, -5}, target = {1, (float)i / 9, 2}, up = {0, 1, (float)i / 64};
        gphys_camera_desc_init(&desc, sizeof desc);
        desc.handedness = i % 2 ? GPHYS_LEFT_HANDED : GPHYS_RIGHT_HANDED;
        desc.depth_range = i % 3 ? GPHYS_DEPTH_ZERO_TO_ONE : GPHYS_DEPTH_MINUS_ONE_TO_ONE;
        assert_int_equal(gphys_camera_create(&desc, &camera), GPHYS_OK);
        assert_int_equal(gphys_camera_set_perspective(camera, (float)i / 128, 0.125f, 100), GPHYS_OK);
        assert_int_equal(gphys_camera_look_at(camera, &eye, &target, &up), GPHYS_OK);
        add_camera(&h, camera);
        gphys_camera_destroy(camera);
    }
    return h.value;
}

static uint64_t orbits(uint32_t workers) {
    hash h = begin_hash();
    gphys_camera* camera;
    gphys_orbit orbit;
    int i;
    (void)workers;
    random_state = 3;
    assert_int_equal(gphys_camera_create(NULL, &camera), GPHYS_OK);
    assert_int_equal(gphys_orbit_init(&orbit), GPHYS_OK);
    orbit.target = point(1, 2, 3);
    orbit.radians_per_unit = 0.0078125f;
    assert_int_equal(gphys_camera_set_orbit(camera, &orbit), GPHYS_OK);
    for (i = 0; i < 600; ++i) {
        const gphys_vec3 turn = random_point(99);
        const gphys_vec3 move = random_point(1);
        assert_int_equal(gphys_camera_orbit_rotate(camera, turn.x, turn.y / 8), GPHYS_OK);
        assert_int_equal(gphys_camera_orbit_pan(camera, move.x, move.y), GPHYS_OK);
        assert_int_equal(gphys_camera_orbit_zoom(camera, move.z), GPHYS_OK);
        assert_int_equal(gphys_camera_orbit_update(camera), GPHYS_OK);
        assert_int_equal(gphys_camera_get_orbit(camera, &orbit), GPHYS_OK);
        add(&h, &orbit, sizeof orbit);
        add_camera(&h, camera);
    }
    gphys_camera_destroy(camera);
    return h.value;
}

/* A height field of triangles, and shapes of every kind above it, turned and scaled. */
static gphys_scene* make_crowd(uint32_t workers, gphys_mesh** mesh) {
    enum { SIDE = 24 };
    gphys_vec3 vertices[SIDE * SIDE];
    uint32_t indices[6 * (SIDE - 1) * (SIDE - 1)], count = 0, i, k;
    gphys_scene* scene = make_scene(workers);
    random_state = 4;
    for (i = 0; i < SIDE; ++i) {
        for (k = 0; k < SIDE; ++k) vertices[SIDE * i + k] = point((float)i - 12, random_float(-2, -1), (float)k - 12);
    }
    for (i = 0; i + 1 < SIDE; ++i) {
        for (k = 0; k + 1 < SIDE; ++k) {
            const uint32_t corner = SIDE * i + k;
            indices[count++] = corner;
            indices[count++] = corner + 1;
            indices[count++] = corner + SIDE;
            indices[count++] = corner + 1;
            indices[count++] = corner + SIDE + 1;
            indices[count++] = corner + SIDE;
        }
    }
    assert_int_equal(gphys_mesh_create(NULL, &vertices[0].x, sizeof *vertices, SIDE * SIDE, indices, count, mesh),
                     GPHYS_OK);
    put(scene, GPHYS_SHAPE_MESH, *mesh, NULL, 1);
    for (i = 0; i < 400; ++i) {
        gphys_transform place = placed(random_point(10), (int)(i % 3), 16, (int)(i % 15));
        gphys_sphere sphere;
        gphys_capsule capsule;
        gphys_aabb box;
        gphys_obb turned;
        gphys_triangle triangle;
        place.scale = 0.25f + random_float(0, 1);
        switch (i % 5) {
            case 0:
                sphere.center = random_point(1);
                sphere.radius = random_float(0, 1);
                put(scene, GPHYS_SHAPE_SPHERE, &sphere, &place, i + 2);
                break;
            case 1:
                capsule.a = random_point(1);
                capsule.b = random_point(1);
                capsule.radius = random_float(0, 1);
                put(scene, GPHYS_SHAPE_CAPSULE, &capsule, &place, i + 2);
                break;
            case 2:
                box.min = random_point(1);
                box.max = point(box.min.x + 1, box.min.y + 0.5f, box.min.z + 0.25f);
                put(scene, GPHYS_SHAPE_AABB, &box, &place, i + 2);
                break;
            case 3:
                turned.center = random_point(1);
                turned.half_extents = point(random_float(0, 1), 0.5f, 0.25f);
                turned.rotation = place.rotation;
                put(scene, GPHYS_SHAPE_OBB, &turned, &place, i + 2);
                break;
            default:
                triangle.a = random_point(1);
                triangle.b = random_point(1);
                triangle.c = random_point(2);
                put(scene, GPHYS_SHAPE_TRIANGLE, &triangle, &place, i + 2);
        }
    }
    return scene;
}

static uint64_t queries(uint32_t workers) {
    enum { COUNT = 2000 };
    static gphys_ray rays[COUNT];
    static gphys_segment segments[COUNT];
    static gphys_sphere spheres[COUNT];
    static gphys_vec3 points[COUNT], ways[COUNT];
    static gphys_hit hits[COUNT];
    static gphys_nearest found[COUNT];
    static gphys_model_id models[64 * COUNT];
    static uint32_t offsets[COUNT + 1];
    hash h = begin_hash();
    gphys_mesh* mesh;
    gphys_scene* scene = make_crowd(workers, &mesh);
    gphys_model_info info;
    uint32_t i;
    for (i = 0; i < COUNT; ++i) {
        rays[i].origin = segments[i].a = points[i] = spheres[i].center = random_point(12);
        rays[i].direction = ways[i] = random_point(4);
        rays[i].t_max = i % 2 ? (float)(i % 8) : INFINITY;
        segments[i].b = random_point(12);
        spheres[i].radius = random_float(0, 1);
    }
    assert_int_equal(gphys_scene_raycast_batch(scene, rays, sizeof *rays, COUNT, GPHYS_ALL_LAYERS, hits, sizeof *hits),
                     GPHYS_OK);
    add_hits(&h, hits, COUNT);
    assert_int_equal(
        gphys_scene_segment_test_batch(scene, segments, sizeof *segments, COUNT, GPHYS_ALL_LAYERS, hits, sizeof *hits),
        GPHYS_OK);
    add_hits(&h, hits, COUNT);
    assert_int_equal(gphys_scene_sweep_sphere_batch(scene, spheres, sizeof *spheres, ways, sizeof *ways, COUNT,
                                                    GPHYS_ALL_LAYERS, hits, sizeof *hits),
                     GPHYS_OK);
    add_hits(&h, hits, COUNT);
    assert_int_equal(
        gphys_scene_nearest_batch(scene, points, sizeof *points, COUNT, 2, GPHYS_ALL_LAYERS, found, sizeof *found),
        GPHYS_OK);
    add_near(&h, found, COUNT);
    assert_int_equal(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, spheres, sizeof *spheres, COUNT,
                                               GPHYS_ALL_LAYERS, models, 64 * COUNT, offsets),
                     GPHYS_OK);
    add(&h, offsets, sizeof offsets);
    for (i = 0; i < offsets[COUNT]; ++i) {
        assert_int_equal(gphys_scene_get_info(scene, models[i], &info), GPHYS_OK);
        add_word(&h, info.tag);
    }
    gphys_scene_destroy(scene);
    gphys_mesh_destroy(mesh);
    return h.value;
}

/* Shapes without a scene. */
static uint64_t shapes(uint32_t workers) {
    hash h = begin_hash();
    int i;
    (void)workers;
    random_state = 5;
    for (i = 0; i < 4000; ++i) {
        /* One draw after the other: the order within an initialiser is the compiler's. */
        const gphys_vec3 p = random_point(3);
        const gphys_vec3 q = random_point(2);
        const gphys_vec3 r = random_point(2);
        const gphys_vec3 v = random_point(2);
        const gphys_vec3 corner = random_point(2);
        const gphys_vec3 way = random_point(2);
        const gphys_obb box = {q, {1, 0.5f, 0.25f}, placed(p, i % 3, 16, i % 16).rotation};
        const gphys_capsule capsule = {r, v, (float)(i % 64) / 64};
        /* Some rays begin on a corner, where weights are zero. */
        const gphys_triangle triangle = {i % 3 == 0 ? p : corner, i % 3 == 0 ? r : way, i % 3 == 0 ? v : r};
        const gphys_ray ray = {p, way, INFINITY};
        const gphys_sphere ball = {p, 0.125f};
        const void* all[3];
        const gphys_shape_type types[3] = {GPHYS_SHAPE_OBB, GPHYS_SHAPE_CAPSULE, GPHYS_SHAPE_TRIANGLE};
        int k;
        all[0] = &box;
        all[1] = &capsule;
        all[2] = &triangle;
        for (k = 0; k < 3; ++k) {
            gphys_hit hit;
            gphys_nearest found;
            int32_t overlaps;
            memset(&hit, 0, sizeof hit);
            if (gphys_shape_raycast(types[k], all[k], &ray, &hit) == GPHYS_OK) add_hits(&h, &hit, 1);
            if (gphys_shape_sweep_sphere(types[k], all[k], &ball, &ray.direction, &hit) == GPHYS_OK)
                add_hits(&h, &hit, 1);
            assert_int_equal(gphys_shape_closest_point(types[k], all[k], &p, &found), GPHYS_OK);
            add_near(&h, &found, 1);
            assert_int_equal(gphys_shape_overlaps(types[k], all[k], types[(k + 1) % 3], all[(k + 1) % 3], &overlaps),
                             GPHYS_OK);
            add_word(&h, (uint32_t)overlaps);
        }
    }
    return h.value;
}

/* Cloth, a rope and particles that follow an animation beside a model that moves. */
static uint64_t targets(uint32_t workers) {
    enum { COUNT = 9, ROWS = 12 };
    hash h = begin_hash();
    gphys_scene* scene = make_scene(1);
    gphys_solver* solver = make_solver(workers, 4);
    const gphys_capsule shape = {{0, 0, 0}, {0, 1.5f, 0}, 0.25f};
    const gphys_vec3 corner = {-0.5f, 1.5f, 0.375f}, u = {1, 0, 0}, v = {0, -1.25f, 0};
    const gphys_model_id runner = put(scene, GPHYS_SHAPE_CAPSULE, &shape, NULL, 2);
    gphys_vec3 placed_at[COUNT * ROWS];
    gphys_body_id bodies[3];
    int i, k, p;
    put_floor(scene);
    for (i = 0; i < COUNT; ++i) placed_at[i] = point((float)(i - 4) / 8, 1.75f, (float)i / 16);
    assert_int_equal(gphys_solver_add_cloth(solver, NULL, &corner, &u, &v, COUNT, ROWS, &bodies[0]), GPHYS_OK);
    assert_int_equal(gphys_solver_add_rope(solver, NULL, placed_at, sizeof *placed_at, COUNT, 0, &bodies[1]), GPHYS_OK);
    assert_int_equal(gphys_solver_add_particles(solver, NULL, placed_at, sizeof *placed_at, COUNT, &bodies[2]),
                     GPHYS_OK);
    assert_int_equal(gphys_solver_set_pinned(solver, bodies[1], 0, 1, 1), GPHYS_OK);
    for (i = 0; i < 40; ++i) {
        const float way = (float)(i % 20) / 16;
        const gphys_transform place = placed(point(0, 0, way), 1, 40, i);
        assert_int_equal(gphys_scene_set_transform(scene, runner, &place), GPHYS_OK);
        for (k = 0; k < 3; ++k) {
            for (p = 0; p < (k == 0 ? COUNT * ROWS : COUNT); ++p) {
                const float x = (float)((k == 0 ? p % COUNT : p) - 4) / 8, down = k == 0 ? (float)(p / COUNT) / 8 : 0;
                const float distance = p % 7 == 6 ? INFINITY : (float)(p % 7) / 16;
                const gphys_animation_target target = {{x, 1.5f - down, 0.375f + way},
                                                       {(float)i / 64, 0, 1},
                                                       distance,
                                                       p % 3 == 0 ? INFINITY : (float)(p % 3) / 64};
                assert_int_equal(
                    gphys_solver_set_animation_targets(solver, bodies[k], (uint32_t)p, 1, &target, sizeof target),
                    GPHYS_OK);
            }
        }
        run_steps(&h, solver, scene, 1);
    }
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return h.value;
}

/* Crates that fall on a floor and a capsule, a plank that swings at the end of a rope, and two that are hinged. */
static uint64_t clusters(uint32_t workers) {
    enum { COUNT = 8 };
    static const uint32_t first[COUNT] = {0, 1, 2, 3, 4, 5, 6, 7}, second[COUNT] = {6, 7, 8, 9, 10, 11, 12, 13};
    hash h = begin_hash();
    gphys_scene* scene = make_scene(1);
    gphys_solver* solver = make_solver(workers, 4);
    const gphys_capsule shape = {{0, 0.25f, -1}, {0, 0.25f, 1}, 0.25f};
    gphys_vec3 points[2 * COUNT];
    gphys_body_id body;
    gphys_cluster_id cluster;
    int i, k;
    put_floor(scene);
    put(scene, GPHYS_SHAPE_CAPSULE, &shape, NULL, 2);
    for (k = 0; k < 6; ++k) {
        for (i = 0; i < COUNT; ++i) {
            points[i] = point((float)(k - 3) / 2 + (float)(i & 1) / 4, 1.5f + (float)(i >> 1 & 1) / 4 + (float)i / 32,
                              (float)(i >> 2) / 4);
        }
        assert_int_equal(gphys_solver_add_particles(solver, NULL, points, sizeof *points, COUNT, &body), GPHYS_OK);
        assert_int_equal(gphys_solver_add_cluster(solver, body, first, COUNT, &cluster), GPHYS_OK);
    }
    for (k = 0; k < 2; ++k) {
        for (i = 0; i < 14; ++i) points[i] = point((float)(i / 2) / 4, 3, (float)(i & 1) / 4 + (float)k + 2);
        assert_int_equal(gphys_solver_add_rope(solver, NULL, points, sizeof *points, 14, 0, &body), GPHYS_OK);
        assert_int_equal(gphys_solver_add_cluster(solver, body, first, COUNT, &cluster), GPHYS_OK);
        if (k == 1) {
            assert_int_equal(gphys_solver_add_cluster(solver, body, second, COUNT, &cluster), GPHYS_OK);
        }
        assert_int_equal(gphys_solver_set_pinned(solver, body, 0, 1 + (uint32_t)k, 1), GPHYS_OK);
    }
    run_steps(&h, solver, scene, 60);
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return h.value;
}

/* A curtain that a ball tears, and a rope that breaks. */
static uint64_t tears(uint32_t workers) {
    hash h = begin_hash();
    gphys_scene* scene = make_scene(1);
    gphys_solver* solver = make_solver(workers, 4);
    const gphys_vec3 corner = point(0, 2, 0), u = point(1, 0, 0), v = point(0, -1, 0);
    const gphys_sphere ball = {{0.5f, 1.25f, -0.5f}, 0.25f};
    gphys_transform place = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_id model;
    gphys_body_desc desc;
    gphys_body_id body;
    gphys_vec3 points[8];
    uint32_t broken = 0, total;
    int i;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_body_desc_init(&desc, sizeof desc), GPHYS_OK);
    desc.breaking_force = 2;
    assert_int_equal(gphys_solver_add_cloth(solver, &desc, &corner, &u, &v, 17, 17, &body), GPHYS_OK);
    assert_int_equal(gphys_solver_set_pinned(solver, body, 0, 17, 1), GPHYS_OK);
    desc.breaking_force = 6;
    for (i = 0; i < 8; ++i) points[i] = point((float)i / 4, 3, 2);
    assert_int_equal(gphys_solver_add_rope(solver, &desc, points, sizeof *points, 8, 0, &body), GPHYS_OK);
    assert_int_equal(gphys_solver_set_pinned(solver, body, 0, 1, 1), GPHYS_OK);
    for (i = 0; i < 40; ++i) {
        place.position.z = (float)i / 32;
        assert_int_equal(gphys_scene_set_transform(scene, model, &place), GPHYS_OK);
        run_steps(&h, solver, scene, 1);
        assert_int_equal(gphys_solver_get_breaks(solver, NULL, 0, &total) < GPHYS_OK, 0);
        broken += total;
    }
    assert_true(broken > 10);
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return h.value;
}

static uint64_t (*const groups[GROUPS])(uint32_t workers) = {
    particles, ropes, cloth, joints, moving_models, cameras, orbits, queries, shapes, targets, clusters, tears};

static int is_as_recorded(int group, uint32_t workers) {
    const uint64_t value = groups[group](workers);
    const uint32_t high = (uint32_t)(value >> 32), low = (uint32_t)value;
    if (getenv("GPHYS_PRINT_GOLDEN")) {
        if (workers == 1) printf("    {\"%s\", 0x%08x, 0x%08x},\n", recorded[group].group, high, low);
        return 1;
    }
    if (high == recorded[group].high && low == recorded[group].low) return 1;
    printf("%s with %u workers: 0x%08x, 0x%08x, recorded: 0x%08x, 0x%08x\n", recorded[group].group, workers, high, low,
           recorded[group].high, recorded[group].low);
    return 0;
}

static void answers_have_the_bits_that_were_recorded(void** state) {
    int group, all = 1;
    (void)state;
    for (group = 0; group < GROUPS; ++group) all &= is_as_recorded(group, 1);
    assert_true(all);
}

static void so_they_have_with_any_number_of_workers(void** state) {
    static const uint32_t workers[] = {2, 4, 16};
    static const int shared[] = {1, 2, 3, 4, 7, 9, 10};
    size_t i, k;
    int all = 1;
    (void)state;
    for (i = 0; i < sizeof workers / sizeof *workers; ++i) {
        for (k = 0; k < sizeof shared / sizeof *shared; ++k) all &= is_as_recorded(shared[k], workers[i]);
    }
    assert_true(all);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_have_the_bits_that_were_recorded),
        cmocka_unit_test(so_they_have_with_any_number_of_workers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

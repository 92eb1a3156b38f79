/* Scales per axis of models, through the public header: what they give, what is refused, and what stays. */
#include <math.h>
#include "test.h"

static const gphys_aabb unit_box = {{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}};
static const gphys_vec3 wall = {20, 3, 0.25f};
static const gphys_vec3 one = {1, 1, 1};

static void assert_invalid(gphys_status status) { assert_int_equal(status, GPHYS_ERROR_INVALID_ARGUMENT); }

static gphys_scene* empty_scene(void) {
    gphys_scene* scene = NULL;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    return scene;
}

/* The octahedron of radius 1, as a surface or a hull. */
static gphys_mesh* octahedron(int hull) {
    static const float corners[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    static const uint32_t faces[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    gphys_mesh* mesh = NULL;
    if (hull) {
        assert_int_equal(gphys_mesh_create_hull(NULL, corners, 12, 6, &mesh), GPHYS_OK);
    } else {
        assert_int_equal(gphys_mesh_create(NULL, corners, 12, 6, faces, 24, &mesh), GPHYS_OK);
    }
    return mesh;
}

static gphys_hit hit_of(const gphys_scene* scene, float x, float y, float z, float dx, float dy, float dz) {
    gphys_ray ray;
    gphys_hit hit;
    ray.origin.x = x, ray.origin.y = y, ray.origin.z = z;
    ray.direction.x = dx, ray.direction.y = dy, ray.direction.z = dz;
    ray.t_max = INFINITY;
    memset(&hit, 0, sizeof hit);
    if (gphys_scene_raycast(scene, &ray, 1, &hit) != GPHYS_OK) assert_int_equal(hit.model, 0);
    return hit;
}

static void a_unit_box_becomes_a_wall(void** state) {
    gphys_scene* scene = empty_scene();
    gphys_model_desc desc;
    gphys_model_id model;
    gphys_aabb bounds, shape;
    gphys_vec3 scale;
    (void)state;
    assert_int_equal(gphys_model_desc_init(&desc, sizeof desc), GPHYS_OK);
    assert_memory_equal(&desc.scale, &one, sizeof one);
    desc.scale = wall;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, NULL, &desc, &model), GPHYS_OK);
    assert_int_equal(gphys_scene_get_scale(scene, model, &scale), GPHYS_OK);
    assert_memory_equal(&scale, &wall, sizeof wall);
    assert_int_equal(gphys_scene_get_shape(scene, model, &shape, sizeof shape), GPHYS_OK);
    assert_memory_equal(&shape, &unit_box, sizeof shape);
    assert_int_equal(gphys_scene_get_bounds(scene, model, &bounds), GPHYS_OK);
    assert_true(bounds.min.x == -10 && bounds.max.y == 1.5f && bounds.max.z == 0.125f);
    assert_true(hit_of(scene, 9.9f, 1.4f, 5, 0, 0, -1).t == 4.875f);
    assert_int_equal(hit_of(scene, 10.1f, 0, 5, 0, 0, -1).model, 0);
    assert_int_equal(gphys_scene_set_scale(scene, model, &one), GPHYS_OK);
    assert_true(hit_of(scene, 0.4f, 0, 5, 0, 0, -1).t == 4.5f);
    assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
    gphys_scene_destroy(scene);
}

/* An ellipsoid of eight faces: x / 4 + y / 2 + z = 1 in the positive octant, with normal (1/4, 1/2, 1). */
static void a_mesh_and_a_hull_are_stretched(void** state) {
    const gphys_vec3 stretch = {4, 2, 1};
    int hull;
    (void)state;
    for (hull = 0; hull < 2; ++hull) {
        gphys_scene* scene = empty_scene();
        gphys_mesh* mesh = octahedron(hull);
        gphys_transform place = {{10, 0, 0}, {0, 0, 0, 1}, 2};
        gphys_model_id model, found[1];
        gphys_vec3 point = {12, 1, 2};
        gphys_nearest nearest;
        gphys_sphere ball = {{12, 1, 5}, 0.5f};
        gphys_vec3 down = {0, 0, -10};
        gphys_hit hit;
        uint32_t total;
        const float length = sqrtf(1 + 0.25f + 0.0625f);
        assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, &place, NULL, &model), GPHYS_OK);
        gphys_mesh_destroy(mesh);
        assert_int_equal(gphys_scene_set_scale(scene, model, &stretch), GPHYS_OK);
        /* At (2, 1) of the mesh in the world: z = 2 (1 - 2 / 8 - 1 / 4). */
        hit = hit_of(scene, 12, 1, 9, 0, 0, -2);
        assert_int_equal(hit.model, model);
        assert_float_equal(hit.t, 4, 1e-6f);
        assert_float_equal(hit.normal.x, 0.25f / length, 1e-6f);
        assert_float_equal(hit.normal.y, 0.5f / length, 1e-6f);
        assert_float_equal(hit.normal.z, 1 / length, 1e-6f);
        assert_int_equal(gphys_scene_nearest(scene, &point, INFINITY, 1, &nearest), GPHYS_OK);
        assert_float_equal(nearest.distance, 1 / length, 1e-5f);
        assert_int_equal(gphys_scene_sweep_sphere(scene, &ball, &down, 1, &hit), GPHYS_OK);
        assert_float_equal(hit.t, (4 - 0.5f * length) / 10, 1e-6f);
        ball.center.z = 0.9f;
        ball.radius = 0.01f;
        assert_int_equal(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &ball, 1, found, 1, &total), GPHYS_OK);
        assert_int_equal(total, hull); /* inside: a hull is solid, a surface is not */
        assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
        gphys_scene_destroy(scene);
    }
}

static void children_and_shapes_follow_the_rules(void** state) {
    gphys_scene* scene = empty_scene();
    gphys_mesh* mesh = octahedron(0);
    gphys_model_desc desc;
    gphys_model_id parent, child;
    gphys_transform beside = {{1, 0, 0}, {0, 0, 0, 1}, 1}, world;
    gphys_sphere ball = {{0, 0, 0}, 1};
    gphys_vec3 scale;
    gphys_aabb bounds;
    uint32_t hash[2], other[2], words[4096], total;
    gphys_scene* copy = empty_scene();
    (void)state;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &parent), GPHYS_OK);
    gphys_model_desc_init(&desc, sizeof desc);
    desc.parent = parent;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &unit_box, &beside, &desc, &child), GPHYS_OK);
    assert_int_equal(gphys_scene_get_hash(scene, hash), GPHYS_OK);
    assert_int_equal(gphys_scene_set_scale(scene, parent, &wall), GPHYS_OK);
    assert_int_equal(gphys_scene_get_hash(scene, other), GPHYS_OK);
    assert_memory_not_equal(hash, other, sizeof hash);
    /* A child stays where it is. */
    assert_int_equal(gphys_scene_get_world_transforms(scene, &child, 1, &world, sizeof world), GPHYS_OK);
    assert_memory_equal(&world, &beside, sizeof world);
    /* A snapshot keeps scales. */
    assert_int_equal(gphys_scene_get_snapshot(scene, 1, words, 4096, &total), GPHYS_OK);
    assert_int_equal(gphys_scene_restore(copy, NULL, words, total), GPHYS_OK);
    assert_int_equal(gphys_scene_get_hash(copy, hash), GPHYS_OK);
    assert_memory_equal(hash, other, sizeof hash);
    assert_int_equal(gphys_scene_get_scale(copy, parent, &scale), GPHYS_OK);
    assert_memory_equal(&scale, &wall, sizeof wall);
    /* Another shape has the same scale, unless it cannot. */
    assert_int_equal(gphys_scene_set_shape(scene, parent, GPHYS_SHAPE_SPHERE, &ball), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_set_shape(scene, parent, GPHYS_SHAPE_AABB, &unit_box), GPHYS_OK);
    assert_int_equal(gphys_scene_get_bounds(scene, parent, &bounds), GPHYS_OK);
    assert_true(bounds.max.x == 10);
    assert_int_equal(gphys_scene_set_scale(scene, parent, &one), GPHYS_OK);
    assert_int_equal(gphys_scene_set_shape(scene, parent, GPHYS_SHAPE_SPHERE, &ball), GPHYS_OK);
    assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
    assert_int_equal(gphys_scene_validate(copy), GPHYS_OK);
    gphys_mesh_destroy(mesh);
    gphys_scene_destroy(copy);
    gphys_scene_destroy(scene);
}

static void bad_scales_are_refused_and_nothing_changes(void** state) {
    gphys_scene* scene = empty_scene();
    gphys_model_desc descs[2];
    gphys_model_id box, ball, turned, hull, out[2] = {7, 7};
    const gphys_sphere sphere = {{0, 0, 0}, 1};
    const gphys_obb obb = {{0, 0, 0}, {1, 1, 1}, {0, 0.6f, 0, 0.8f}};
    const gphys_vec3 even = {2, 2, 2}, huge = {1e15f, 1, 1};
    const float bad[] = {0, -1, NAN, INFINITY, 1e16f, 1e-16f};
    gphys_transform far_scale = {{0, 0, 0}, {0, 0, 0, 1}, 1e15f};
    gphys_mesh* mesh = octahedron(1);
    gphys_vec3 scale = {1, 1, 1};
    gphys_aabb wide = {{-10, -1, -1}, {10, 1, 1}};
    uint32_t hash[2], after[2];
    size_t i;
    (void)state;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &wide, NULL, NULL, &box), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &sphere, NULL, NULL, &ball), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_OBB, &obb, NULL, NULL, &turned), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &hull), GPHYS_OK);
    assert_int_equal(gphys_scene_get_hash(scene, hash), GPHYS_OK);
    assert_invalid(gphys_scene_set_scale(NULL, box, &wall));
    assert_invalid(gphys_scene_set_scale(scene, box, NULL));
    assert_invalid(gphys_scene_get_scale(NULL, box, &scale));
    assert_invalid(gphys_scene_get_scale(scene, box, NULL));
    assert_int_equal(gphys_scene_set_scale(scene, 12345, &wall), GPHYS_ERROR_INVALID_ID);
    assert_int_equal(gphys_scene_get_scale(scene, 12345, &scale), GPHYS_ERROR_INVALID_ID);
    for (i = 0; i < sizeof bad / sizeof *bad; ++i) {
        scale.y = bad[i];
        assert_invalid(gphys_scene_set_scale(scene, box, &scale));
    }
    assert_int_equal(gphys_scene_set_scale(scene, ball, &wall), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_set_scale(scene, turned, &wall), GPHYS_ERROR_UNSUPPORTED);
    assert_invalid(gphys_scene_set_scale(scene, box, &huge));
    assert_int_equal(gphys_scene_get_hash(scene, after), GPHYS_OK);
    assert_memory_equal(hash, after, sizeof hash);
    /* Equal numbers are for all. */
    assert_int_equal(gphys_scene_set_scale(scene, ball, &even), GPHYS_OK);
    assert_true(hit_of(scene, 0, 5, 0, 0, -1, 0).t == 3);
    assert_int_equal(gphys_scene_set_scale(scene, turned, &even), GPHYS_OK);
    /* A scale of a mesh and that of its transform are in range together. */
    assert_int_equal(gphys_scene_set_scale(scene, hull, &wall), GPHYS_OK);
    assert_invalid(gphys_scene_set_transform(scene, hull, &far_scale));
    /* In descs: all zeros are one, as in a desc of 1.0. */
    gphys_model_desc_init(&descs[0], sizeof *descs);
    memset(&descs[0].scale, 0, sizeof descs[0].scale);
    descs[1] = descs[0];
    descs[1].scale.x = 1;
    assert_invalid(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &sphere, NULL, &descs[1], out));
    assert_invalid(
        gphys_scene_add_described_batch(scene, GPHYS_SHAPE_SPHERE, &sphere, 0, NULL, 0, descs, sizeof *descs, 2, out));
    assert_int_equal(out[0], 7);
    descs[1].scale = wall;
    assert_int_equal(
        gphys_scene_add_described_batch(scene, GPHYS_SHAPE_SPHERE, &sphere, 0, NULL, 0, descs, sizeof *descs, 2, out),
        GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(
        gphys_scene_add_described_batch(scene, GPHYS_SHAPE_AABB, &unit_box, 0, NULL, 0, descs, sizeof *descs, 2, out),
        GPHYS_OK);
    assert_int_equal(gphys_scene_get_scale(scene, out[0], &scale), GPHYS_OK);
    assert_memory_equal(&scale, &one, sizeof one);
    assert_int_equal(gphys_scene_validate(scene), GPHYS_OK);
    gphys_mesh_destroy(mesh);
    gphys_scene_destroy(scene);
}

/* Particles fall on a stretched hull and a stretched surface, and rest where these are. */
static void bodies_rest_on_scaled_models(void** state) {
    const gphys_vec3 stretch = {10, 0.5f, 10};
    int hull;
    (void)state;
    for (hull = 0; hull < 2; ++hull) {
        gphys_scene* scene = empty_scene();
        gphys_solver* solver = NULL;
        gphys_mesh* mesh = octahedron(hull);
        gphys_body_desc desc;
        gphys_body_id body;
        gphys_model_id model;
        gphys_vec3 start = {0.5f, 2, 0.5f}, position;
        int i;
        assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &model), GPHYS_OK);
        gphys_mesh_destroy(mesh);
        assert_int_equal(gphys_scene_set_scale(scene, model, &stretch), GPHYS_OK);
        assert_int_equal(gphys_solver_create(NULL, &solver), GPHYS_OK);
        assert_int_equal(gphys_body_desc_init(&desc, sizeof desc), GPHYS_OK);
        desc.friction = 1;
        desc.radius = 0.1f;
        assert_int_equal(gphys_solver_add_particles(solver, &desc, &start, sizeof start, 1, &body), GPHYS_OK);
        for (i = 0; i < 180; ++i) assert_int_equal(gphys_solver_step(solver, scene, 1.0f / 60), GPHYS_OK);
        assert_int_equal(gphys_solver_get_positions(solver, body, 0, 1, &position, sizeof position), GPHYS_OK);
        /* The face y = 0.5 (1 - x / 10 - z / 10), at a distance of 0.1. */
        assert_float_equal(position.y, 0.5f * (1 - position.x / 10 - position.z / 10) + 0.1f, 0.01f);
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_unit_box_becomes_a_wall),
        cmocka_unit_test(a_mesh_and_a_hull_are_stretched),
        cmocka_unit_test(children_and_shapes_follow_the_rules),
        cmocka_unit_test(bad_scales_are_refused_and_nothing_changes),
        cmocka_unit_test(bodies_rest_on_scaled_models),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Memory that runs out while meshes and scenes are made, changed and asked. */
#include "faults.h"

/* The mesh becomes one of its snapshot. */
static gphys_status reload_mesh(session* s) {
    static uint32_t words[8192];
    uint32_t total;
    gphys_mesh_desc desc;
    gphys_mesh* loaded;
    gphys_status status;
    assert_int_equal(gphys_mesh_get_snapshot(s->mesh, words, 8192, &total), GPHYS_OK);
    gphys_mesh_desc_init(&desc, sizeof desc);
    desc.allocator = &s->hooks;
    desc.deformable = 1;
    status = gphys_mesh_create_from_snapshot(&desc, words, total, &loaded);
    if (status != GPHYS_OK) return status;
    gphys_mesh_destroy(s->mesh);
    s->mesh = loaded;
    return status;
}

static gphys_status make_camera(session* s) {
    gphys_camera_desc desc;
    gphys_camera_desc_init(&desc, sizeof desc);
    desc.allocator = &s->hooks;
    return gphys_camera_create(&desc, &s->camera);
}

static uint32_t scene_words[16384], scene_word_count;

static gphys_status copy_out(session* s) {
    return gphys_scene_get_snapshot(s->scene, 1, scene_words, 16384, &scene_word_count);
}

static void shapes_and_scene(session* s) {
    static const gphys_sphere ball = {{0, 0, 0}, 0.4f};
    static const gphys_aabb box = {{-0.3f, -0.2f, -0.1f}, {0.3f, 0.2f, 0.1f}};
    static const gphys_plane floor = {{0, 1, 0}, -3};
    static const gphys_capsule capsule = {{0, -0.3f, 0}, {0, 0.3f, 0}, 0.2f};
    static const gphys_triangle triangle = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    static const gphys_vec3 stretched = {2, 1, 0.5f};
    const double origin[3] = {0.5, 0, -0.25};
    gphys_transform places[64];
    gphys_model_desc child;
    gphys_model_id id = 0;
    uint32_t i;
    gphys_hit hits[64];
    gphys_ray rays[64];
    gphys_nearest nearest[64];
    gphys_vec3 points[64];
    gphys_model_id touched[64];
    gphys_vec3 vertices[81];
    uint32_t offsets[65], total;
    gphys_frustum frustum;
    DO(make_mesh(s));
    DO(reload_mesh(s));
    DO(make_scene(s, 3));
    DO(make_camera(s));
    for (i = 0; i < 64; ++i) {
        places[i] = at((float)(i % 8) - 4, (float)(i / 8 % 4) - 1, (float)(i / 16) - 2);
        points[i] = places[i].position;
        rays[i].origin = points[i];
        rays[i].origin.y = 10;
        rays[i].direction.x = 0, rays[i].direction.y = -1, rays[i].direction.z = 0;
        rays[i].t_max = 100;
    }
    DO(gphys_scene_add_batch(s->scene, GPHYS_SHAPE_SPHERE, &ball, 0, places, sizeof *places, 40, NULL, s->models));
    DO(gphys_scene_add(s->scene, GPHYS_SHAPE_MESH, s->mesh, &places[41], NULL, &s->models[40]));
    DO(gphys_scene_add(s->scene, GPHYS_SHAPE_PLANE, &floor, NULL, NULL, &s->models[41]));
    DO(gphys_scene_add(s->scene, GPHYS_SHAPE_CAPSULE, &capsule, &places[42], NULL, &s->models[42]));
    DO(gphys_scene_add(s->scene, GPHYS_SHAPE_TRIANGLE, &triangle, &places[43], NULL, &s->models[43]));
    gphys_model_desc_init(&child, sizeof child);
    child.parent = s->models[0];
    DO(gphys_scene_add_batch(s->scene, GPHYS_SHAPE_AABB, &box, 0, places, sizeof *places, 12, &child, &s->models[44]));
    DO(gphys_scene_set_parent(s->scene, s->models[44], s->models[45], 1));
    DO(gphys_scene_set_parent(s->scene, s->models[5], s->models[42], 0));
    DO(gphys_scene_set_transforms(s->scene, s->models, places + 8, sizeof *places, 50));
    DO(gphys_scene_set_layers(s->scene, s->models[3], 6));
    DO(gphys_scene_set_tag(s->scene, s->models[3], 7));
    DO(gphys_mesh_get_vertices(s->mesh, vertices, 81, &total));
    for (i = 0; i < 81; ++i) vertices[i].y *= (float)(i % 3);
    DO(gphys_mesh_set_vertices(s->mesh, &vertices[0].x, sizeof *vertices, 81));
    DO(gphys_scene_set_shape(s->scene, s->models[4], GPHYS_SHAPE_PLANE, &floor));
    DO(gphys_scene_set_shape(s->scene, s->models[41], GPHYS_SHAPE_TRIANGLE, &triangle));
    DO(gphys_scene_set_shape(s->scene, s->models[4], GPHYS_SHAPE_MESH, s->mesh));
    DO(gphys_scene_set_scale(s->scene, s->models[4], &stretched));
    DO(gphys_scene_set_scale(s->scene, s->models[41], &stretched));
    DO(gphys_scene_set_scale(s->scene, s->models[44], &stretched));
    DO(gphys_scene_set_shape(s->scene, s->models[40], GPHYS_SHAPE_SPHERE, &ball));
    DO(gphys_scene_remove(s->scene, s->models[10]));
    DO(gphys_scene_remove_subtree(s->scene, s->models[45]));
    DO(gphys_scene_set_parent(s->scene, s->models[46], 0, 1));
    DO(gphys_scene_set_origin(s->scene, origin));
    DO(gphys_camera_set_origin(s->camera, origin));
    DO(gphys_scene_raycast_batch(s->scene, rays, sizeof *rays, 64, GPHYS_ALL_LAYERS, hits, sizeof *hits));
    DO(gphys_scene_nearest_batch(s->scene, points, sizeof *points, 64, 100, GPHYS_ALL_LAYERS, nearest,
                                 sizeof *nearest));
    DO(gphys_scene_overlap_batch(s->scene, GPHYS_SHAPE_SPHERE, &ball, 0, 2, GPHYS_ALL_LAYERS, touched, 64, offsets));
    DO(gphys_camera_get_frustum(s->camera, &frustum));
    DO(gphys_camera_cull(s->camera, s->scene, GPHYS_ALL_LAYERS, touched, 64, &total));
    DO(gphys_scene_cull_batch(s->scene, &frustum, 0, 2, GPHYS_ALL_LAYERS, touched, 64, offsets));
    DO(copy_out(s));
    DO(gphys_scene_add_batch(s->scene, GPHYS_SHAPE_SPHERE, &ball, 0, places, sizeof *places, 30, NULL, s->models));
    DO(gphys_scene_restore(s->scene, NULL, scene_words, scene_word_count));
    DO(gphys_scene_add_batch(s->scene, GPHYS_SHAPE_SPHERE, &ball, 0, places, sizeof *places, 30, NULL, s->models));
    DO(gphys_scene_remove_batch(s->scene, s->models, 20));
    DO(gphys_scene_set_worker_count(s->scene, 2));
    DO(gphys_scene_rebuild_octree(s->scene));
    DO(gphys_scene_clear(s->scene));
    DO(gphys_scene_add(s->scene, GPHYS_SHAPE_SPHERE, &ball, &places[2], NULL, &id));
}

/* A hull, models with descs of their own, and a mesh that follows a body. */
static void hulls_and_bodies(session* s) {
    static const gphys_vec3 corner = {0, 1, 0}, u = {0.5f, 0, 0}, v = {0, 0, 0.5f};
    static const gphys_aabb box = {{-0.3f, -0.2f, -0.1f}, {0.3f, 0.2f, 0.1f}};
    gphys_mesh_desc desc;
    gphys_mesh* sheet = NULL;
    gphys_body_id body;
    gphys_model_desc descs[20];
    gphys_transform places[20];
    float points[40][3];
    uint32_t i;
    for (i = 0; i < 40; ++i) {
        points[i][0] = (float)(i % 7) - 3;
        points[i][1] = (float)(i * 5 % 11) - 5;
        points[i][2] = (float)(i * i % 13) - 6;
    }
    gphys_mesh_desc_init(&desc, sizeof desc);
    desc.allocator = &s->hooks;
    DO(gphys_mesh_create_hull(&desc, points[0], 12, 40, &s->mesh));
    DO(make_scene(s, 0));
    DO(make_solver(s, 0));
    for (i = 0; i < 20; ++i) {
        gphys_model_desc_init(&descs[i], sizeof *descs);
        descs[i].tag = i;
        descs[i].scale.x = 1 + (float)i;
        places[i] = at(0, 0, (float)i);
    }
    DO(gphys_scene_add_described_batch(s->scene, GPHYS_SHAPE_AABB, &box, 0, places, sizeof *places, descs,
                                       sizeof *descs, 20, s->models));
    DO(gphys_scene_add(s->scene, GPHYS_SHAPE_MESH, s->mesh, &places[3], &descs[3], &s->models[20]));
    DO(gphys_solver_add_cloth(s->solver, NULL, &corner, &u, &v, 5, 5, &body));
    DO(gphys_mesh_create_from_body(&desc, s->solver, body, &sheet));
    DO(gphys_scene_add(s->scene, GPHYS_SHAPE_MESH, sheet, NULL, NULL, &s->models[21]));
    gphys_mesh_destroy(sheet);
    for (i = 0; i < 3; ++i) DO(gphys_solver_step(s->solver, NULL, FRAME));
    DO(gphys_scene_remove(s->scene, s->models[21]));
}

/* So many models come one by one that the octree is renewed: first by the way, then by calls for it. */
static void renewals(session* s) {
    enum { FIRST = 200, ALL = 560 };
    static const gphys_sphere ball = {{0, 0, 0}, 0.4f};
    gphys_transform places[ALL];
    gphys_model_id models[ALL];
    int32_t done = 0;
    uint32_t i;
    DO(make_scene(s, 1));
    for (i = 0; i < ALL; ++i) places[i] = at((float)(i % 8) - 4, (float)(i / 8 % 8) - 4, (float)(i / 64) - 4);
    DO(gphys_scene_add_batch(s->scene, GPHYS_SHAPE_SPHERE, &ball, 0, places, sizeof *places, FIRST, NULL, models));
    for (i = FIRST; i < ALL; ++i)
        DO(gphys_scene_add(s->scene, GPHYS_SHAPE_SPHERE, &ball, &places[i], NULL, &models[i]));
    DO(gphys_scene_maintain_octree(s->scene, 50, &done));
    DO(gphys_scene_set_transform(s->scene, models[3], &places[4]));
    DO(gphys_scene_remove(s->scene, models[5]));
    DO(gphys_scene_maintain_octree(s->scene, 10000, &done));
    assert_int_equal(done, 1);
}

/* Questions find what is there, and take memory from nobody. */
static void questions(session* s) {
    static const gphys_sphere ball = {{0, 0, 0}, 0.4f};
    static const gphys_vec3 way = {0, 0, -8};
    static const gphys_segment segment = {{0, 0, 9}, {0, 0, -9}};
    const gphys_ray ray = {{0.1f, 0.2f, 9}, {0, 0, -1}, 100};
    gphys_sphere mover = {{0, 0, 8}, 0.2f};
    gphys_query_filter_desc filter;
    gphys_transform places[60];
    gphys_model_id met[64];
    gphys_hit hits[64];
    gphys_nearest nearest;
    gphys_penetration penetrations[64];
    gphys_vec3 centre = {0, 0, 0};
    uint32_t total, offsets[2], i;
    long before;
    DO(make_scene(s, 0));
    DO(make_camera(s));
    for (i = 0; i < 60; ++i) places[i] = at((float)(i % 4) * 0.3f, (float)(i / 4 % 4) * 0.3f, (float)(i / 16) - 2);
    DO(gphys_scene_add_batch(s->scene, GPHYS_SHAPE_SPHERE, &ball, 0, places, sizeof *places, 60, NULL, s->models));
    gphys_query_filter_desc_init(&filter, sizeof filter);
    filter.ignored_models = s->models;
    filter.ignored_count = 40;
    before = s->heap.calls;
    DO(gphys_scene_raycast(s->scene, &ray, GPHYS_ALL_LAYERS, hits));
    DO(gphys_scene_raycast_all(s->scene, &ray, GPHYS_ALL_LAYERS, hits, 64, &total));
    DO(gphys_scene_raycast_filtered(s->scene, &ray, &filter, hits));
    DO(gphys_scene_raycast_all_filtered_batch(s->scene, &ray, sizeof ray, 1, &filter, 0, hits, 64, offsets));
    DO(gphys_scene_segment_test_filtered_batch(s->scene, &segment, sizeof segment, 1, &filter, 0, hits, sizeof *hits));
    DO(gphys_scene_overlap_filtered_batch(s->scene, GPHYS_SHAPE_SPHERE, &ball, 0, 1, &filter, 0, met, 64, offsets));
    DO(gphys_scene_nearest_filtered_batch(s->scene, &centre, sizeof centre, 1, 9, &filter, 0, &nearest,
                                          sizeof nearest));
    DO(gphys_scene_sweep_filtered_batch(s->scene, GPHYS_SHAPE_SPHERE, &mover, 0, &way, 0, 1, &filter, 0, hits,
                                        sizeof *hits));
    DO(gphys_scene_penetration_filtered(s->scene, GPHYS_SHAPE_SPHERE, &ball, &filter, penetrations, 64, &total));
    DO(gphys_scene_penetration_filtered_batch(s->scene, GPHYS_SHAPE_SPHERE, &ball, 0, 1, &filter, 0, penetrations, 64,
                                              offsets));
    DO(gphys_camera_pick_rectangle_filtered(s->camera, s->scene, 0, 0, 9, 9, &filter, met, 64, &total));
    DO(gphys_camera_cull_filtered(s->camera, s->scene, &filter, met, 64, &total));
    assert_int_equal(s->heap.calls, before);
}

static void test_scenes(void** state) {
    (void)state;
    with_all_failing(shapes_and_scene);
}

static void test_hulls_and_bodies(void** state) {
    (void)state;
    with_all_failing(hulls_and_bodies);
}
static void test_renewals(void** state) {
    (void)state;
    with_all_failing(renewals);
}
static void test_questions(void** state) {
    (void)state;
    with_all_failing(questions);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes),
        cmocka_unit_test(test_hulls_and_bodies),
        cmocka_unit_test(test_renewals),
        cmocka_unit_test(test_questions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

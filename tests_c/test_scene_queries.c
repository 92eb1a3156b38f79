/* Queries of a scene through the public header: layers, lists, batches, bad input. */
#include "test.h"

/* A ball of radius 1 at x = 5 on layer 1, one at x = 10 on layer 2, and a floor at y = -3 on 4. */
static gphys_scene* three_models(gphys_model_id models[3]) {
    const gphys_sphere ball = {{0, 0, 0}, 1};
    const gphys_plane floor = {{0, 1, 0}, -3};
    gphys_transform at = {{5, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_desc desc;
    gphys_scene* scene = NULL;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    gphys_model_desc_init(&desc, sizeof desc);
    desc.tag = 50;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &at, &desc, &models[0]), GPHYS_OK);
    at.position.x = 10;
    desc.layers = 2;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &at, &desc, &models[1]), GPHYS_OK);
    desc.layers = 4;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &floor, NULL, &desc, &models[2]), GPHYS_OK);
    return scene;
}

/* What is seen from the origin along +x, up to x = 7 and 2 to each side. */
static gphys_frustum box_ahead(void) {
    const gphys_frustum box = {
        {0, 0, 0},
        {{{1, 0, 0}, 0}, {{-1, 0, 0}, -7}, {{0, 0, 1}, -2}, {{0, 0, -1}, -2}, {{0, 1, 0}, -2}, {{0, -1, 0}, -2}}};
    return box;
}

static void assert_invalid(gphys_status status) { assert_int_equal(status, GPHYS_ERROR_INVALID_ARGUMENT); }

static void layers_choose_what_is_seen(void** state) {
    const gphys_ray ray = {{0, 0, 0}, {2, 0, 0}, INFINITY};
    const gphys_ray down = {{0, 0, 0}, {0, -1, 0}, INFINITY};
    const gphys_segment segment = {{0, 0, 0}, {8, 0, 0}};
    const gphys_vec3 origin = {0, 0, 0}, step = {20, 0, 0};
    const gphys_sphere sphere = {{0, 0, 0}, 1}, large = {{0, 0, 0}, 20};
    const gphys_frustum ahead = box_ahead();
    gphys_model_id models[3], found[3];
    gphys_scene* scene = three_models(models);
    gphys_hit hit;
    gphys_nearest nearest;
    int32_t any = 7;
    uint32_t total = 0;
    (void)state;
    assert_int_equal(gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit), GPHYS_OK);
    assert_int_equal(hit.model, models[0]);
    assert_int_equal(hit.tag, 50);
    assert_true(hit.t == 2 && hit.point.x == 4 && hit.normal.x == -1);
    assert_int_equal(hit.triangle, GPHYS_NO_TRIANGLE);
    assert_int_equal(gphys_scene_raycast(scene, &ray, 2, &hit), GPHYS_OK);
    assert_int_equal(hit.model, models[1]);
    assert_int_equal(gphys_scene_raycast(scene, &ray, 4, &hit), GPHYS_NO_HIT);
    assert_int_equal(hit.model, models[1]);
    assert_int_equal(gphys_scene_raycast(scene, &down, 0xff, &hit), GPHYS_OK);
    assert_int_equal(hit.model, models[2]);
    assert_int_equal(gphys_scene_raycast(scene, &down, 0, &hit), GPHYS_NO_HIT);
    assert_int_equal(gphys_scene_raycast_any(scene, &ray, 2, &any), GPHYS_OK);
    assert_int_equal(any, 1);
    assert_int_equal(gphys_scene_raycast_any(scene, &ray, 4, &any), GPHYS_OK);
    assert_int_equal(any, 0);
    assert_int_equal(gphys_scene_segment_test(scene, &segment, 3, &hit), GPHYS_OK);
    assert_true(hit.t == 0.5f);
    assert_int_equal(gphys_scene_segment_test(scene, &segment, 2, &hit), GPHYS_NO_HIT);
    assert_int_equal(gphys_scene_nearest(scene, &origin, INFINITY, 3, &nearest), GPHYS_OK);
    assert_true(nearest.model == models[0] && nearest.distance == 4 && nearest.point.x == 4);
    assert_int_equal(gphys_scene_nearest(scene, &origin, INFINITY, 7, &nearest), GPHYS_OK);
    assert_true(nearest.model == models[2] && nearest.distance == 3);
    assert_int_equal(gphys_scene_nearest(scene, &origin, 4, 1, &nearest), GPHYS_OK);
    assert_int_equal(gphys_scene_nearest(scene, &origin, 3.99f, 1, &nearest), GPHYS_NO_HIT);
    assert_int_equal(gphys_scene_sweep_sphere(scene, &sphere, &step, 2, &hit), GPHYS_OK);
    assert_true(hit.model == models[1] && hit.t == 0.4f && hit.point.x == 9);
    assert_int_equal(gphys_scene_cull(scene, &ahead, 3, found, 3, &total), GPHYS_OK);
    assert_true(total == 1 && found[0] == models[0]);
    assert_int_equal(gphys_scene_cull(scene, &ahead, 2, found, 3, &total), GPHYS_OK);
    assert_int_equal(total, 0);
    assert_int_equal(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &large, 6, found, 3, &total), GPHYS_OK);
    assert_int_equal(total, 2);
    assert_true(found[0] == models[1] && found[1] == models[2]);
    gphys_scene_destroy(scene);
}

static void lists_are_cut_where_they_say(void** state) {
    const gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, INFINITY};
    const gphys_ray rays[3] = {
        {{0, 0, 0}, {1, 0, 0}, INFINITY}, {{0, 9, 0}, {1, 0, 0}, INFINITY}, {{5, 50, 0}, {0, -1, 0}, INFINITY}};
    const gphys_sphere spheres[2] = {{{0, 0, 0}, 20}, {{5, 0, 0}, 1}};
    gphys_model_id models[3], found[4] = {9, 9, 9, 9};
    gphys_scene* scene = three_models(models);
    gphys_hit hits[4];
    uint32_t total = 0, offsets[4];
    (void)state;
    memset(hits, 9, sizeof hits);
    assert_int_equal(gphys_scene_raycast_all(scene, &ray, 7, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 2);
    assert_int_equal(gphys_scene_raycast_all(scene, &ray, 7, hits, 1, &total), GPHYS_INCOMPLETE);
    assert_int_equal(hits[0].model, models[0]);
    assert_int_equal(hits[1].model, 0x09090909);
    assert_int_equal(gphys_scene_raycast_all(scene, &ray, 8, NULL, 0, &total), GPHYS_OK);
    assert_int_equal(total, 0);

    assert_int_equal(gphys_scene_raycast_all_batch(scene, rays, sizeof *rays, 3, 7, hits, 3, offsets),
                     GPHYS_INCOMPLETE);
    assert_true(offsets[0] == 0 && offsets[1] == 2 && offsets[2] == 2 && offsets[3] == 4);
    assert_true(hits[1].model == models[1] && hits[2].model == models[0] && hits[3].model == 0x09090909);
    assert_int_equal(gphys_scene_raycast_all_batch(scene, rays, sizeof *rays, 3, 7, hits, 4, offsets), GPHYS_OK);
    assert_int_equal(hits[3].model, models[2]);
    assert_int_equal(gphys_scene_raycast_all_batch(scene, NULL, 0, 0, 7, NULL, 0, offsets), GPHYS_OK);

    assert_int_equal(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &spheres[0], 7, found, 2, &total),
                     GPHYS_INCOMPLETE);
    assert_int_equal(total, 3);
    assert_true(found[0] == models[0] && found[1] == models[1] && found[2] == 9);
    assert_int_equal(
        gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, spheres, sizeof *spheres, 2, 7, found, 4, offsets),
        GPHYS_OK);
    assert_true(offsets[1] == 3 && offsets[2] == 4 && found[3] == models[0]);
    gphys_scene_destroy(scene);
}

static void culls_of_a_batch_are_those_of_single_calls(void** state) {
    enum { VIEWS = 5, MANY = 300, ROOM = VIEWS * (MANY + 64) };
    const gphys_sphere ball = {{0, 0, 0}, 0.5f};
    gphys_transform at = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_frustum views[VIEWS];
    gphys_scene* scene = NULL;
    gphys_model_id model, single[MANY + 64], batch[ROOM];
    uint32_t offsets[VIEWS + 1], cut_offsets[VIEWS + 1], room, total, i, v;
    (void)state;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    for (i = 0; i < MANY; ++i) {
        at.position.x = (float)(i * 7 % 41) - 20;
        at.position.z = (float)(i * 11 % 37) - 18;
        assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &at, NULL, &model), GPHYS_OK);
    }
    for (v = 0; v < VIEWS; ++v) {
        views[v] = box_ahead();
        views[v].origin.x = 8 * (float)v - 24; /* that of the first view holds none */
        views[v].planes[GPHYS_FRUSTUM_TOP].distance = -3;
    }
    assert_int_equal(gphys_scene_cull_batch(scene, views, sizeof *views, VIEWS, GPHYS_ALL_LAYERS, batch, ROOM, offsets),
                     GPHYS_OK);
    assert_int_equal(offsets[0], 0);
    for (v = 0; v < VIEWS; ++v) {
        assert_int_equal(gphys_scene_cull(scene, &views[v], GPHYS_ALL_LAYERS, single, MANY + 64, &total), GPHYS_OK);
        assert_int_equal(offsets[v + 1] - offsets[v], total);
        assert_memory_equal(batch + offsets[v], single, total * sizeof *single);
    }
    assert_true(offsets[2] > 3 && offsets[3] > offsets[2] + 3);
    /* With less room, lists come in the same order, and the last is cut to its lowest ids. */
    for (room = 0; room <= offsets[VIEWS]; ++room) {
        gphys_model_id cut[ROOM];
        uint32_t cut_view = 0;
        assert_int_equal(gphys_scene_cull_batch(scene, views, sizeof *views, VIEWS, GPHYS_ALL_LAYERS, room ? cut : NULL,
                                                room, cut_offsets),
                         room < offsets[VIEWS] ? GPHYS_INCOMPLETE : GPHYS_OK);
        assert_memory_equal(cut_offsets, offsets, sizeof offsets);
        while (cut_view < VIEWS && offsets[cut_view + 1] <= room) ++cut_view;
        assert_memory_equal(cut, batch, room * sizeof *cut);
    }
    assert_int_equal(gphys_scene_cull_batch(scene, views, 0, 2, GPHYS_ALL_LAYERS, batch, ROOM, offsets), GPHYS_OK);
    assert_int_equal(offsets[2], 2 * offsets[1]);
    assert_int_equal(gphys_scene_cull_batch(scene, views, sizeof *views, VIEWS, 2, batch, ROOM, offsets), GPHYS_OK);
    assert_int_equal(offsets[VIEWS], 0);
    assert_int_equal(gphys_scene_cull_batch(scene, NULL, 0, 0, GPHYS_ALL_LAYERS, NULL, 0, offsets), GPHYS_OK);
    gphys_scene_destroy(scene);
}

static void batches_mark_what_was_missed(void** state) {
    const gphys_ray rays[2] = {{{0, 0, 0}, {1, 0, 0}, INFINITY}, {{0, 9, 0}, {1, 0, 0}, INFINITY}};
    const gphys_segment segments[2] = {{{0, 9, 0}, {9, 9, 0}}, {{0, 0, 0}, {8, 0, 0}}};
    const gphys_vec3 points[2] = {{0, 0, 0}, {500, 500, 500}};
    const gphys_sphere sphere = {{0, 0, 0}, 1};
    const gphys_vec3 steps[2] = {{20, 0, 0}, {0, 20, 0}};
    gphys_model_id models[3];
    gphys_scene* scene = three_models(models);
    gphys_hit hits[2];
    gphys_nearest nearest[2];
    gphys_distance distances[2];
    int32_t any[2] = {7, 7};
    (void)state;
    assert_int_equal(gphys_scene_raycast_batch(scene, rays, sizeof *rays, 2, 7, hits, sizeof *hits), GPHYS_OK);
    assert_int_equal(hits[0].model, models[0]);
    memset(distances, 9, sizeof distances);
    assert_int_equal(gphys_scene_raycast_distance_batch(scene, rays, sizeof *rays, 2, 7, distances, sizeof *distances),
                     GPHYS_OK);
    assert_true(distances[0].t == hits[0].t && distances[0].model == models[0]);
    assert_int_equal(distances[0].triangle, GPHYS_NO_TRIANGLE);
    assert_true(isinf(distances[1].t) && distances[1].model == 0 && distances[1].triangle == GPHYS_NO_TRIANGLE);
    assert_int_equal(gphys_scene_raycast_distance_batch(scene, rays, 0, 2, 0, distances, sizeof *distances), GPHYS_OK);
    assert_true(isinf(distances[0].t) && distances[0].model == 0);
    assert_true(hits[1].model == 0 && isinf(hits[1].t) && hits[1].point.y == 0);
    assert_int_equal(gphys_scene_raycast_any_batch(scene, rays, sizeof *rays, 2, 7, any, sizeof *any), GPHYS_OK);
    assert_true(any[0] == 1 && any[1] == 0);
    assert_int_equal(gphys_scene_segment_test_batch(scene, segments, sizeof *segments, 2, 7, hits, sizeof *hits),
                     GPHYS_OK);
    assert_true(hits[0].model == 0 && hits[1].t == 0.5f);
    assert_int_equal(gphys_scene_nearest_batch(scene, points, sizeof *points, 2, 10, 3, nearest, sizeof *nearest),
                     GPHYS_OK);
    assert_true(nearest[0].model == models[0] && nearest[1].model == 0 && isinf(nearest[1].distance));
    assert_int_equal(gphys_scene_sweep_sphere_batch(scene, &sphere, 0, steps, sizeof *steps, 2, 3, hits, sizeof *hits),
                     GPHYS_OK);
    assert_true(hits[0].model == models[0] && hits[1].model == 0 && isinf(hits[1].t));
    gphys_scene_destroy(scene);
}

/* Boxes against a triangle 1e-17 m below them, which sums with their coordinates round away. */
static void a_mesh_without_a_place_overlaps_as_it_does_alone(void** state) {
    static const float below[3][3] = {{-1, -1e-17f, -1}, {1, -1e-17f, -1}, {0, -1e-17f, 2}};
    static const uint32_t corners[3] = {0, 1, 2};
    const gphys_aabb boxes[3] = {{{-0.5f, 0, -0.5f}, {0.5f, 0.5f, 0.5f}},
                                 {{-0.5f, -1e-17f, -0.5f}, {0.5f, 0.5f, 0.5f}},
                                 {{-0.5f, -1, -0.5f}, {0.5f, 0, 0.5f}}};
    const int32_t expected[3] = {0, 1, 1};
    gphys_scene* scene = NULL;
    gphys_mesh* mesh = NULL;
    gphys_model_id model = 0, found[3];
    gphys_penetration way;
    uint32_t offsets[4], total = 7, i;
    int32_t alone[3];
    (void)state;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_mesh_create(NULL, below[0], 12, 3, corners, 3, &mesh), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &model), GPHYS_OK);
    assert_int_equal(gphys_shape_overlaps_batch(GPHYS_SHAPE_MESH, mesh, 0, GPHYS_SHAPE_AABB, boxes, sizeof *boxes, 3,
                                                alone, sizeof *alone),
                     GPHYS_OK);
    assert_int_equal(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_AABB, boxes, sizeof *boxes, 3, GPHYS_ALL_LAYERS,
                                               found, 3, offsets),
                     GPHYS_OK);
    for (i = 0; i < 3; ++i) {
        assert_int_equal(alone[i], expected[i]);
        assert_int_equal(offsets[i + 1] - offsets[i], expected[i]);
        assert_int_equal(gphys_scene_overlap(scene, GPHYS_SHAPE_AABB, &boxes[i], 1, found, 3, &total), GPHYS_OK);
        assert_int_equal(total, expected[i]);
        assert_int_equal(gphys_scene_penetration(scene, GPHYS_SHAPE_AABB, &boxes[i], 1, &way, 1, &total), GPHYS_OK);
        assert_int_equal(total, expected[i]);
    }
    gphys_mesh_destroy(mesh);
    gphys_scene_destroy(scene);
}

static void bad_input_is_refused_and_outputs_stay(void** state) {
    const gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, INFINITY};
    const gphys_ray bad_rays[5] = {{{NAN, 0, 0}, {1, 0, 0}, 1},
                                   {{0, 0, 0}, {0, 0, 0}, 1},
                                   {{0, 0, 0}, {INFINITY, 0, 0}, 1},
                                   {{0, 0, 0}, {1, 0, 0}, -1},
                                   {{0, 0, 0}, {1, 0, 0}, NAN}};
    const gphys_segment segment = {{0, 0, 0}, {8, 0, 0}}, bad_segment = {{0, 0, 0}, {0, NAN, 0}};
    const gphys_vec3 point = {0, 0, 0}, bad_point = {0, 2e15f, 0};
    const gphys_frustum frustum = box_ahead();
    gphys_frustum bad_frustum = frustum;
    const gphys_sphere sphere = {{0, 0, 0}, 1}, bad_sphere = {{0, 0, 0}, -1};
    gphys_ray mixed[2];
    gphys_model_id models[3], list[3] = {9, 9, 9};
    gphys_scene* scene = three_models(models);
    gphys_hit hits[2], untouched[2];
    gphys_nearest nearest, nearest_before;
    gphys_distance distance = {7, 7, 7};
    int32_t any = 7;
    uint32_t total = 7, offsets[3] = {7, 7, 7};
    int i;
    (void)state;
    memset(hits, 9, sizeof hits);
    memset(untouched, 9, sizeof untouched);
    memset(&nearest, 9, sizeof nearest);
    nearest_before = nearest;
    bad_frustum.planes[3].normal.x = NAN;
    mixed[0] = ray;
    for (i = 0; i < 5; ++i) {
        mixed[1] = bad_rays[i];
        assert_invalid(gphys_scene_raycast(scene, &bad_rays[i], 7, hits));
        assert_invalid(gphys_scene_raycast_any(scene, &bad_rays[i], 7, &any));
        assert_invalid(gphys_scene_raycast_all(scene, &bad_rays[i], 7, hits, 2, &total));
        assert_invalid(gphys_scene_raycast_batch(scene, mixed, sizeof *mixed, 2, 7, hits, sizeof *hits));
        assert_invalid(gphys_scene_raycast_any_batch(scene, mixed, sizeof *mixed, 2, 7, &any, 4));
        assert_invalid(gphys_scene_raycast_distance_batch(scene, mixed, sizeof *mixed, 2, 7, &distance, 12));
        assert_invalid(gphys_scene_raycast_all_batch(scene, mixed, sizeof *mixed, 2, 7, hits, 2, offsets));
    }
    assert_invalid(gphys_scene_raycast(NULL, &ray, 7, hits));
    assert_invalid(gphys_scene_raycast(scene, NULL, 7, hits));
    assert_invalid(gphys_scene_raycast(scene, &ray, 7, NULL));
    assert_invalid(gphys_scene_raycast_batch(NULL, &ray, 0, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_raycast_batch(scene, NULL, 0, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_raycast_batch(scene, &ray, 0, 1, 7, NULL, sizeof *hits));
    assert_invalid(gphys_scene_raycast_batch(scene, &ray, 8, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_raycast_batch(scene, &ray, 30, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_raycast_batch(scene, &ray, 0, 1, 7, hits, 0));
    assert_invalid(gphys_scene_raycast_distance_batch(NULL, &ray, 0, 1, 7, &distance, 12));
    assert_invalid(gphys_scene_raycast_distance_batch(scene, NULL, 0, 1, 7, &distance, 12));
    assert_invalid(gphys_scene_raycast_distance_batch(scene, &ray, 0, 1, 7, NULL, 12));
    assert_invalid(gphys_scene_raycast_distance_batch(scene, &ray, 8, 1, 7, &distance, 12));
    assert_invalid(gphys_scene_raycast_distance_batch(scene, &ray, 0, 1, 7, &distance, 8));
    assert_true(distance.t == 7 && distance.model == 7 && distance.triangle == 7);
    assert_invalid(gphys_scene_raycast_any(NULL, &ray, 7, &any));
    assert_invalid(gphys_scene_raycast_any(scene, NULL, 7, &any));
    assert_invalid(gphys_scene_raycast_any(scene, &ray, 7, NULL));
    assert_invalid(gphys_scene_raycast_any_batch(NULL, &ray, 0, 1, 7, &any, 4));
    assert_invalid(gphys_scene_raycast_any_batch(scene, &ray, 0, 1, 7, &any, 2));
    assert_invalid(gphys_scene_raycast_all(NULL, &ray, 7, hits, 2, &total));
    assert_invalid(gphys_scene_raycast_all(scene, NULL, 7, hits, 2, &total));
    assert_invalid(gphys_scene_raycast_all(scene, &ray, 7, NULL, 2, &total));
    assert_invalid(gphys_scene_raycast_all(scene, &ray, 7, hits, 2, NULL));
    assert_invalid(gphys_scene_raycast_all_batch(NULL, &ray, 0, 1, 7, hits, 2, offsets));
    assert_invalid(gphys_scene_raycast_all_batch(scene, &ray, 0, 1, 7, NULL, 2, offsets));
    assert_invalid(gphys_scene_raycast_all_batch(scene, &ray, 0, 1, 7, hits, 2, NULL));
    assert_invalid(gphys_scene_segment_test(NULL, &segment, 7, hits));
    assert_invalid(gphys_scene_segment_test(scene, NULL, 7, hits));
    assert_invalid(gphys_scene_segment_test(scene, &segment, 7, NULL));
    assert_invalid(gphys_scene_segment_test(scene, &bad_segment, 7, hits));
    assert_invalid(gphys_scene_segment_test_batch(scene, &bad_segment, 0, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_segment_test_batch(NULL, &segment, 0, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_segment_test_batch(scene, &segment, 4, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_overlap(NULL, GPHYS_SHAPE_SPHERE, &sphere, 7, list, 3, &total));
    assert_invalid(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, NULL, 7, list, 3, &total));
    assert_invalid(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &bad_sphere, 7, list, 3, &total));
    assert_invalid(gphys_scene_overlap(scene, 99, &sphere, 7, list, 3, &total));
    assert_invalid(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &sphere, 7, NULL, 3, &total));
    assert_invalid(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &sphere, 7, list, 3, NULL));
    assert_int_equal(gphys_scene_overlap(scene, GPHYS_SHAPE_RAY, &ray, 7, list, 3, &total), GPHYS_ERROR_UNSUPPORTED);
    assert_int_equal(gphys_scene_overlap(scene, GPHYS_SHAPE_MESH, &ray, 7, list, 3, &total), GPHYS_ERROR_UNSUPPORTED);
    assert_invalid(gphys_scene_cull(NULL, &frustum, 7, list, 3, &total));
    assert_invalid(gphys_scene_cull(scene, NULL, 7, list, 3, &total));
    assert_invalid(gphys_scene_cull(scene, &frustum, 7, NULL, 3, &total));
    assert_invalid(gphys_scene_cull(scene, &frustum, 7, list, 3, NULL));
    assert_invalid(gphys_scene_cull(scene, &bad_frustum, 7, list, 3, &total));
    assert_invalid(gphys_scene_cull_batch(NULL, &frustum, 0, 1, 7, list, 3, offsets));
    assert_invalid(gphys_scene_cull_batch(scene, NULL, 0, 1, 7, list, 3, offsets));
    assert_invalid(gphys_scene_cull_batch(scene, &bad_frustum, 0, 1, 7, list, 3, offsets));
    assert_invalid(gphys_scene_cull_batch(scene, &frustum, 12, 1, 7, list, 3, offsets));
    assert_invalid(gphys_scene_cull_batch(scene, &frustum, 0, 1, 7, NULL, 3, offsets));
    assert_invalid(gphys_scene_cull_batch(scene, &frustum, 0, 1, 7, list, 3, NULL));
    assert_invalid(gphys_scene_overlap_batch(NULL, GPHYS_SHAPE_SPHERE, &sphere, 0, 1, 7, list, 3, offsets));
    assert_invalid(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, NULL, 0, 1, 7, list, 3, offsets));
    assert_invalid(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, &bad_sphere, 0, 1, 7, list, 3, offsets));
    assert_invalid(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, &sphere, 12, 1, 7, list, 3, offsets));
    assert_invalid(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, &sphere, 0, 1, 7, list, 3, NULL));
    assert_invalid(gphys_scene_nearest(NULL, &point, 1, 7, &nearest));
    assert_invalid(gphys_scene_nearest(scene, NULL, 1, 7, &nearest));
    assert_invalid(gphys_scene_nearest(scene, &bad_point, 1, 7, &nearest));
    assert_invalid(gphys_scene_nearest(scene, &point, -1, 7, &nearest));
    assert_invalid(gphys_scene_nearest(scene, &point, NAN, 7, &nearest));
    assert_invalid(gphys_scene_nearest(scene, &point, 1, 7, NULL));
    assert_invalid(gphys_scene_nearest_batch(NULL, &point, 0, 1, 1, 7, &nearest, sizeof nearest));
    assert_invalid(gphys_scene_nearest_batch(scene, &bad_point, 0, 1, 1, 7, &nearest, sizeof nearest));
    assert_invalid(gphys_scene_nearest_batch(scene, &point, 0, 1, NAN, 7, &nearest, sizeof nearest));
    assert_invalid(gphys_scene_nearest_batch(scene, &point, 0, 1, 1, 7, &nearest, 8));
    assert_invalid(gphys_scene_sweep_sphere(NULL, &sphere, &point, 7, hits));
    assert_invalid(gphys_scene_sweep_sphere(scene, NULL, &point, 7, hits));
    assert_invalid(gphys_scene_sweep_sphere(scene, &bad_sphere, &point, 7, hits));
    assert_invalid(gphys_scene_sweep_sphere(scene, &sphere, NULL, 7, hits));
    assert_invalid(gphys_scene_sweep_sphere(scene, &sphere, &bad_point, 7, hits));
    assert_invalid(gphys_scene_sweep_sphere(scene, &sphere, &point, 7, NULL));
    assert_invalid(gphys_scene_sweep_sphere_batch(NULL, &sphere, 0, &point, 0, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_sweep_sphere_batch(scene, &bad_sphere, 0, &point, 0, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_sweep_sphere_batch(scene, &sphere, 0, &bad_point, 0, 1, 7, hits, sizeof *hits));
    assert_invalid(gphys_scene_sweep_sphere_batch(scene, &sphere, 0, &point, 4, 1, 7, hits, sizeof *hits));
    assert_memory_equal(hits, untouched, sizeof hits);
    assert_memory_equal(&nearest, &nearest_before, sizeof nearest);
    assert_true(any == 7 && total == 7 && offsets[0] == 7 && list[0] == 9);
    gphys_scene_destroy(scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_choose_what_is_seen),
        cmocka_unit_test(lists_are_cut_where_they_say),
        cmocka_unit_test(culls_of_a_batch_are_those_of_single_calls),
        cmocka_unit_test(batches_mark_what_was_missed),
        cmocka_unit_test(a_mesh_without_a_place_overlaps_as_it_does_alone),
        cmocka_unit_test(bad_input_is_refused_and_outputs_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

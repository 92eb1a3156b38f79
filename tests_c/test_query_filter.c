/* Queries that leave out models, through the public header: each function, its filters and bad input. */
#include <math.h>
#include "test.h"

/* Balls of radius 1 along x: a body at 0, a head on it at 3, and a target at 10 that belongs to neither. */
enum { BODY, HEAD, TARGET };

static gphys_scene* three_balls(gphys_model_id models[3]) {
    const gphys_sphere ball = {{0, 0, 0}, 1};
    gphys_transform at = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_desc desc;
    gphys_scene* scene = NULL;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    gphys_model_desc_init(&desc, sizeof desc);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &at, &desc, &models[BODY]), GPHYS_OK);
    at.position.x = 3;
    desc.parent = models[BODY];
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &at, &desc, &models[HEAD]), GPHYS_OK);
    at.position.x = 10;
    desc.parent = 0;
    desc.layers = 2;
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &at, &desc, &models[TARGET]), GPHYS_OK);
    return scene;
}

static gphys_query_filter_desc defaults(void) {
    gphys_query_filter_desc filter;
    assert_int_equal(gphys_query_filter_desc_init(&filter, sizeof filter), GPHYS_OK);
    return filter;
}

static void the_defaults_see_everything(void** state) {
    gphys_query_filter_desc filter;
    char room[sizeof filter + 8];
    (void)state;
    memset(room, 0x5a, sizeof room);
    memset(&filter, 0x5a, sizeof filter);
    assert_int_equal(gphys_query_filter_desc_init(&filter, sizeof filter), GPHYS_OK);
    assert_int_equal(filter.struct_size, sizeof filter);
    assert_true(filter.layers == GPHYS_ALL_LAYERS && filter.ignored_model == 0 && filter.flags == 0);
    assert_true(filter.ignored_models == NULL && filter.ignored_count == 0 && filter.reserved == 0);
    assert_int_equal(gphys_query_filter_desc_init(NULL, sizeof filter), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_query_filter_desc_init(&filter, sizeof filter - 4), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(gphys_query_filter_desc_init(&filter, 65537), GPHYS_ERROR_STRUCT_SIZE);
    /* Of a later release, as large as its desc is. */
    assert_int_equal(gphys_query_filter_desc_init((gphys_query_filter_desc*)(void*)room, sizeof filter + 4), GPHYS_OK);
    assert_true(room[sizeof filter] == 0 && room[sizeof filter + 4] == 0x5a);
}

static void rays_pass_what_is_left_out(void** state) {
    const gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, INFINITY};
    const gphys_segment segment = {{0, 0, 0}, {20, 0, 0}};
    gphys_model_id models[3], both[2];
    gphys_scene* scene = three_balls(models);
    gphys_query_filter_desc filter = defaults();
    gphys_hit hit, hits[3];
    uint32_t total = 0;
    int32_t any = 7;
    (void)state;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, NULL, &hit), GPHYS_OK);
    assert_true(hit.model == models[BODY] && hit.t == 0 && hit.flags == GPHYS_HIT_INSIDE);
    filter.ignored_model = models[BODY];
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == models[HEAD] && hit.t == 2);
    filter.flags = GPHYS_FILTER_SUBTREE;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == models[TARGET] && hit.t == 9 && hit.point.x == 9 && hit.normal.x == -1);
    assert_int_equal(gphys_scene_segment_test_filtered(scene, &segment, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == models[TARGET] && hit.t == 0.45f);
    assert_int_equal(gphys_scene_raycast_any_filtered(scene, &ray, &filter, &any), GPHYS_OK);
    assert_int_equal(any, 1);
    filter.layers = 1;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &filter, &hit), GPHYS_NO_HIT);
    assert_int_equal(gphys_scene_segment_test_filtered(scene, &segment, &filter, &hit), GPHYS_NO_HIT);
    assert_int_equal(gphys_scene_raycast_any_filtered(scene, &ray, &filter, &any), GPHYS_OK);
    assert_int_equal(any, 0);
    filter = defaults();
    both[0] = models[TARGET]; /* in any order */
    both[1] = models[BODY];
    filter.ignored_models = both;
    filter.ignored_count = 2;
    assert_int_equal(gphys_scene_raycast_all_filtered(scene, &ray, &filter, hits, 3, &total), GPHYS_OK);
    assert_true(total == 1 && hits[0].model == models[HEAD]);
    filter.ignored_model = models[HEAD];
    assert_int_equal(gphys_scene_raycast_any_filtered(scene, &ray, &filter, &any), GPHYS_OK);
    assert_int_equal(any, 0);
    assert_int_equal(gphys_scene_raycast_all_filtered(scene, &ray, NULL, NULL, 0, &total), GPHYS_INCOMPLETE);
    assert_int_equal(total, 3);
    gphys_scene_destroy(scene);
}

static void what_is_gone_leaves_out_nothing(void** state) {
    const gphys_ray ray = {{-5, 0, 0}, {1, 0, 0}, INFINITY};
    gphys_model_id models[3], list[3];
    gphys_scene* scene = three_balls(models);
    gphys_query_filter_desc filter = defaults();
    gphys_hit hit;
    (void)state;
    assert_int_equal(gphys_scene_remove(scene, models[BODY]), GPHYS_OK);
    list[0] = models[BODY];
    list[1] = 0;
    list[2] = 0xffffffffu;
    filter.ignored_model = models[BODY];
    filter.flags = GPHYS_FILTER_SUBTREE;
    filter.ignored_models = list;
    filter.ignored_count = 3;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &filter, &hit), GPHYS_OK);
    assert_int_equal(hit.model, models[HEAD]);
    gphys_scene_destroy(scene);
}

/* What is around the origin, as far as the balls. */
static gphys_frustum box_around(void) {
    const gphys_frustum around = {
        {0, 0, 0},
        {{{1, 0, 0}, -9}, {{-1, 0, 0}, -20}, {{0, 0, 1}, -9}, {{0, 0, -1}, -9}, {{0, 1, 0}, -9}, {{0, -1, 0}, -9}}};
    return around;
}

static void other_queries_leave_out_the_same(void** state) {
    const gphys_vec3 origin = {0, 0, 0}, step = {20, 0, 0};
    const gphys_sphere small = {{0, 0, 0}, 0.5f}, large = {{0, 0, 0}, 50};
    const gphys_frustum around = box_around();
    const gphys_aabb cube = {{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}};
    gphys_model_id models[3], found[3];
    gphys_scene* scene = three_balls(models);
    gphys_query_filter_desc filter = defaults();
    gphys_penetration ways[3];
    gphys_hit hit;
    gphys_nearest nearest;
    uint32_t total = 0;
    (void)state;
    filter.ignored_model = models[BODY];
    assert_int_equal(gphys_scene_nearest_filtered(scene, &origin, INFINITY, &filter, &nearest), GPHYS_OK);
    assert_true(nearest.model == models[HEAD] && nearest.distance == 2);
    assert_int_equal(gphys_scene_nearest_filtered(scene, &origin, 1.5f, &filter, &nearest), GPHYS_NO_HIT);
    assert_int_equal(gphys_scene_sweep_sphere_filtered(scene, &small, &step, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == models[HEAD] && hit.t == 0.075f);
    assert_int_equal(gphys_scene_sweep_filtered(scene, GPHYS_SHAPE_AABB, &cube, &step, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == models[HEAD] && hit.t == 0.075f); /* the cube's face is where the sphere's side was */
    assert_int_equal(gphys_scene_penetration_filtered(scene, GPHYS_SHAPE_SPHERE, &large, &filter, ways, 3, &total),
                     GPHYS_OK);
    assert_int_equal(total, 2);
    assert_true(ways[0].model != models[BODY] && ways[1].model != models[BODY]);
    assert_int_equal(gphys_scene_overlap_filtered(scene, GPHYS_SHAPE_SPHERE, &large, &filter, found, 3, &total),
                     GPHYS_OK);
    assert_true(total == 2 && found[0] == models[HEAD] && found[1] == models[TARGET]);
    assert_int_equal(gphys_scene_cull_filtered(scene, &around, &filter, found, 3, &total), GPHYS_OK);
    assert_true(total == 2 && found[0] == models[HEAD] && found[1] == models[TARGET]);
    filter.flags = GPHYS_FILTER_SUBTREE;
    assert_int_equal(gphys_scene_sweep_sphere_filtered(scene, &small, &step, &filter, &hit), GPHYS_OK);
    assert_int_equal(hit.model, models[TARGET]);
    assert_int_equal(gphys_scene_cull_filtered(scene, &around, &filter, found, 3, &total), GPHYS_OK);
    assert_true(total == 1 && found[0] == models[TARGET]);
    filter.layers = 1;
    assert_int_equal(gphys_scene_sweep_sphere_filtered(scene, &small, &step, &filter, &hit), GPHYS_NO_HIT);
    assert_int_equal(gphys_scene_sweep_filtered(scene, GPHYS_SHAPE_AABB, &cube, &step, &filter, &hit), GPHYS_NO_HIT);
    assert_int_equal(gphys_scene_overlap_filtered(scene, GPHYS_SHAPE_RAY, &large, &filter, found, 3, &total),
                     GPHYS_ERROR_UNSUPPORTED);
    gphys_scene_destroy(scene);
}

static void batches_take_one_filter_or_one_each(void** state) {
    const gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, INFINITY};
    const gphys_segment segment = {{0, 0, 0}, {20, 0, 0}};
    const gphys_vec3 origin = {0, 0, 0}, step = {20, 0, 0};
    const gphys_sphere small = {{0, 0, 0}, 0.5f}, large = {{0, 0, 0}, 50};
    const gphys_plane ground = {{0, 1, 0}, 0};
    const gphys_frustum around = box_around();
    /* As of a later release, whose filters are larger, and at places that are multiples of 4 only. */
    struct wide_filter {
        gphys_query_filter_desc filter;
        uint32_t unknown;
    } wide[3];
    unsigned char packed[3 * (sizeof(gphys_query_filter_desc) + 4)];
    const uint32_t stride = sizeof(gphys_query_filter_desc) + 4;
    gphys_model_id models[3], found[9];
    gphys_query_filter_desc filters[3];
    gphys_scene* scene = three_balls(models);
    gphys_hit hits[3];
    gphys_nearest nearest[3];
    gphys_penetration ways[9];
    gphys_distance distances[3];
    int32_t any[3];
    uint32_t offsets[4], i;
    (void)state;
    for (i = 0; i < 3; ++i) filters[i] = defaults();
    filters[1].ignored_model = models[BODY];
    filters[2].ignored_model = models[BODY];
    filters[2].flags = GPHYS_FILTER_SUBTREE;
    assert_int_equal(
        gphys_scene_raycast_filtered_batch(scene, &ray, 0, 3, filters, sizeof *filters, hits, sizeof *hits), GPHYS_OK);
    for (i = 0; i < 3; ++i) assert_int_equal(hits[i].model, models[i]);
    assert_int_equal(gphys_scene_raycast_filtered_batch(scene, &ray, 0, 3, &filters[1], 0, hits, sizeof *hits),
                     GPHYS_OK);
    for (i = 0; i < 3; ++i) assert_int_equal(hits[i].model, models[HEAD]);
    assert_int_equal(gphys_scene_raycast_filtered_batch(scene, &ray, 0, 3, NULL, sizeof *filters, hits, sizeof *hits),
                     GPHYS_OK);
    for (i = 0; i < 3; ++i) assert_int_equal(hits[i].model, models[BODY]);
    assert_int_equal(
        gphys_scene_segment_test_filtered_batch(scene, &segment, 0, 3, filters, sizeof *filters, hits, sizeof *hits),
        GPHYS_OK);
    for (i = 0; i < 3; ++i) assert_int_equal(hits[i].model, models[i]);
    assert_int_equal(gphys_scene_nearest_filtered_batch(scene, &origin, 0, 3, INFINITY, filters, sizeof *filters,
                                                        nearest, sizeof *nearest),
                     GPHYS_OK);
    for (i = 0; i < 3; ++i) assert_int_equal(nearest[i].model, models[i]);
    assert_int_equal(gphys_scene_sweep_sphere_filtered_batch(scene, &small, 0, &step, 0, 3, filters, sizeof *filters,
                                                             hits, sizeof *hits),
                     GPHYS_OK);
    for (i = 0; i < 3; ++i) assert_int_equal(hits[i].model, models[i]);
    assert_int_equal(gphys_scene_overlap_filtered_batch(scene, GPHYS_SHAPE_SPHERE, &small, 0, 3, filters,
                                                        sizeof *filters, found, 9, offsets),
                     GPHYS_OK);
    assert_true(offsets[1] == 1 && offsets[2] == 1 && offsets[3] == 1 && found[0] == models[BODY]);
    assert_int_equal(gphys_scene_penetration_filtered_batch(scene, GPHYS_SHAPE_SPHERE, &small, 0, 3, filters,
                                                            sizeof *filters, ways, 9, offsets),
                     GPHYS_OK);
    assert_true(offsets[1] == 1 && offsets[2] == 1 && offsets[3] == 1 && ways[0].model == models[BODY]);
    assert_int_equal(gphys_scene_penetration_filtered_batch(scene, GPHYS_SHAPE_SPHERE, &large, 0, 3, filters,
                                                            sizeof *filters, ways, 9, offsets),
                     GPHYS_OK);
    assert_true(offsets[0] == 0 && offsets[1] == 3 && offsets[2] == 5 && offsets[3] == 6);
    assert_int_equal(gphys_scene_cull_filtered_batch(scene, &around, 0, 3, filters, sizeof *filters, found, 9, offsets),
                     GPHYS_OK);
    assert_true(offsets[0] == 0 && offsets[1] == 3 && offsets[2] == 5 && offsets[3] == 6);
    assert_true(found[0] == models[BODY] && found[3] == models[HEAD] && found[5] == models[TARGET]);
    assert_int_equal(gphys_scene_cull_filtered_batch(scene, &around, 0, 2, &filters[2], 0, found, 1, offsets),
                     GPHYS_INCOMPLETE);
    assert_true(offsets[1] == 1 && offsets[2] == 2 && found[0] == models[TARGET]);
    for (i = 0; i < 3; ++i) {
        gphys_penetration single[3];
        uint32_t total = 0;
        assert_int_equal(
            gphys_scene_penetration_filtered(scene, GPHYS_SHAPE_SPHERE, &large, &filters[i], single, 3, &total),
            GPHYS_OK);
        assert_int_equal(total, 3 - i);
        assert_memory_equal(single, ways + offsets[i], total * sizeof *ways);
    }
    assert_int_equal(gphys_scene_penetration_filtered_batch(scene, GPHYS_SHAPE_SPHERE, &large, 0, 2, &filters[1], 0,
                                                            ways, 3, offsets),
                     GPHYS_INCOMPLETE);
    assert_true(offsets[1] == 2 && offsets[2] == 4);
    assert_int_equal(gphys_scene_penetration_filtered_batch(scene, GPHYS_SHAPE_PLANE, &ground, 0, 2, &filters[1], 0,
                                                            ways, 3, offsets),
                     GPHYS_ERROR_UNSUPPORTED);
    filters[2].layers = 1;
    assert_int_equal(
        gphys_scene_raycast_any_filtered_batch(scene, &ray, 0, 3, filters, sizeof *filters, any, sizeof *any),
        GPHYS_OK);
    assert_true(any[0] == 1 && any[1] == 1 && any[2] == 0);
    assert_int_equal(gphys_scene_raycast_distance_filtered_batch(scene, &ray, 0, 3, filters, sizeof *filters, distances,
                                                                 sizeof *distances),
                     GPHYS_OK);
    for (i = 0; i < 2; ++i) {
        gphys_hit single;
        assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &filters[i], &single), GPHYS_OK);
        assert_true(distances[i].t == single.t && distances[i].model == single.model && single.model == models[i]);
    }
    assert_true(isinf(distances[2].t) && distances[2].model == 0);
    assert_int_equal(gphys_scene_raycast_distance_filtered_batch(scene, &ray, 0, 3, filters, sizeof *filters, NULL,
                                                                 sizeof *distances),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(
        gphys_scene_raycast_all_filtered_batch(scene, &ray, 0, 3, filters, sizeof *filters, NULL, 0, offsets),
        GPHYS_INCOMPLETE);
    assert_true(offsets[1] == 3 && offsets[2] == 5 && offsets[3] == 5);
    memset(wide, 0, sizeof wide);
    for (i = 0; i < 3; ++i) {
        wide[i].filter = filters[i];
        wide[i].filter.struct_size = stride;
        memcpy(packed + i * stride, &wide[i], stride);
    }
    assert_int_equal(
        gphys_scene_raycast_filtered_batch(scene, &ray, 0, 3, (const gphys_query_filter_desc*)(const void*)packed,
                                           stride, hits, sizeof *hits),
        GPHYS_OK);
    assert_true(hits[0].model == models[BODY] && hits[1].model == models[HEAD] && hits[2].model == 0);
    packed[3 * stride - 1] = 1;
    assert_int_equal(
        gphys_scene_raycast_filtered_batch(scene, &ray, 0, 3, (const gphys_query_filter_desc*)(const void*)packed,
                                           stride, hits, sizeof *hits),
        GPHYS_ERROR_STRUCT_SIZE);
    gphys_scene_destroy(scene);
}

/* Of a program that was compiled with the header of a later release: what it has set is known here, or it is told. */
static void a_larger_filter_means_what_its_known_part_says(void** state) {
    const gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, INFINITY};
    struct {
        gphys_query_filter_desc known;
        uint32_t later[2];
    } wide;
    gphys_model_id models[3];
    gphys_scene* scene = three_balls(models);
    gphys_hit hit;
    (void)state;
    memset(&wide, 0, sizeof wide);
    wide.known = defaults();
    wide.known.struct_size = sizeof wide;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &wide.known, &hit), GPHYS_OK);
    assert_true(hit.model == models[BODY]);
    wide.known.ignored_model = models[BODY];
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &wide.known, &hit), GPHYS_OK);
    assert_true(hit.model == models[HEAD]);
    wide.known.flags = GPHYS_FILTER_SUBTREE;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &wide.known, &hit), GPHYS_OK);
    assert_true(hit.model == models[TARGET]);
    wide.later[1] = 1;
    hit.model = 7;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, &wide.known, &hit), GPHYS_ERROR_STRUCT_SIZE);
    assert_int_equal(hit.model, 7);
    gphys_scene_destroy(scene);
}

static void a_camera_sees_behind_a_selection(void** state) {
    const gphys_vec3 eye = {-10, 0, 0}, target = {0, 0, 0}, up = {0, 1, 0};
    const float pixels[4] = {400, 300, 0, 0};
    gphys_model_id models[3], found[3];
    gphys_scene* scene = three_balls(models);
    gphys_query_filter_desc filter = defaults(), filters[2];
    gphys_camera* camera = NULL;
    gphys_hit hit, hits[2];
    uint32_t total = 0;
    (void)state;
    assert_int_equal(gphys_camera_create(NULL, &camera), GPHYS_OK);
    assert_int_equal(gphys_camera_look_at(camera, &eye, &target, &up), GPHYS_OK);
    filter.ignored_models = models;
    filter.ignored_count = 2;
    assert_int_equal(gphys_camera_pick_filtered(camera, scene, 400, 300, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == models[TARGET] && fabsf(hit.t - 18.9f) < 4e-6f); /* two ulp, from the near plane on */
    assert_int_equal(gphys_camera_pick_filtered(camera, scene, 0, 0, &filter, &hit), GPHYS_NO_HIT);
    assert_int_equal(gphys_camera_pick_filtered(camera, NULL, 400, 300, &filter, &hit), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_camera_pick_filtered_batch(camera, scene, pixels, 8, 2, &filter, 0, hits, sizeof *hits),
                     GPHYS_OK);
    assert_true(hits[0].model == models[TARGET] && hits[1].model == 0 && isinf(hits[1].t));
    filters[0] = defaults();
    filters[1] = filter;
    assert_int_equal(
        gphys_camera_pick_filtered_batch(camera, scene, pixels, 0, 2, filters, sizeof *filters, hits, sizeof *hits),
        GPHYS_OK);
    assert_true(hits[0].model == models[BODY] && hits[1].model == models[TARGET]);
    assert_int_equal(gphys_camera_pick_rectangle_filtered(camera, scene, 390, 290, 410, 310, &filter, found, 3, &total),
                     GPHYS_OK);
    assert_true(total == 1 && found[0] == models[TARGET]);
    assert_int_equal(gphys_camera_cull_filtered(camera, scene, &filter, found, 3, &total), GPHYS_OK);
    assert_true(total == 1 && found[0] == models[TARGET]);
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
}

/* A horizontal square at height y: both triangles face up, or down. */
static gphys_mesh* square(float y, int up) {
    const float v[12] = {-1, y, -1, -1, y, 1, 1, y, 1, 1, y, -1};
    const uint32_t above[6] = {0, 1, 2, 0, 2, 3}, below[6] = {0, 2, 1, 0, 3, 2};
    gphys_mesh* mesh = NULL;
    assert_int_equal(gphys_mesh_create(NULL, v, 12, 4, up ? above : below, 6, &mesh), GPHYS_OK);
    return mesh;
}

static void faces_are_left_out_by_side(void** state) {
    /* From above: a plane that faces up at 3, squares up at 2 and down at 1, a triangle that faces down at 0, a ball.
     */
    const gphys_plane plane = {{0, 1, 0}, 3};
    const gphys_triangle triangle = {{-5, 0, -5}, {5, 0, -5}, {0, 0, 5}};
    const gphys_sphere ball = {{0, -3, 0}, 1};
    const gphys_ray down = {{0.2f, 9, 0.1f}, {0, -1, 0}, INFINITY}, up = {{0.2f, -9, 0.1f}, {0, 1, 0}, INFINITY};
    const gphys_segment through = {{0.2f, 9, 0.1f}, {0.2f, -1, 0.1f}};
    const gphys_capsule body = {{0, 6, 0}, {0, 7, 0}, 0.5f};
    const gphys_vec3 fall = {0, -5, 0};
    gphys_mesh *upper = square(2, 1), *lower = square(1, 0);
    gphys_scene* scene = NULL;
    gphys_model_id of_plane, of_upper, of_lower, of_triangle, of_ball;
    gphys_query_filter_desc filter = defaults();
    gphys_hit hit, hits[5];
    uint32_t total = 0;
    int32_t any = 7;
    (void)state;
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &plane, NULL, NULL, &of_plane), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, upper, NULL, NULL, &of_upper), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, lower, NULL, NULL, &of_lower), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_TRIANGLE, &triangle, NULL, NULL, &of_triangle), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &of_ball), GPHYS_OK);
    filter.flags = GPHYS_FILTER_NO_BACK_FACES;
    assert_int_equal(gphys_scene_raycast_all_filtered(scene, &down, &filter, hits, 5, &total), GPHYS_OK);
    assert_true(total == 3 && hits[0].model == of_plane && hits[1].model == of_upper && hits[2].model == of_ball);
    assert_int_equal(gphys_scene_raycast_all_filtered(scene, &up, &filter, hits, 5, &total), GPHYS_OK);
    assert_true(total == 3 && hits[0].model == of_ball && hits[1].model == of_triangle && hits[2].model == of_lower);
    filter.flags = GPHYS_FILTER_NO_FRONT_FACES;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &down, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == of_lower && hit.t == 8 && (hit.flags & GPHYS_HIT_BACK) != 0 && hit.normal.y == 1);
    assert_int_equal(gphys_scene_segment_test_filtered(scene, &through, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == of_lower && hit.t == 0.8f);
    filter.ignored_model = of_lower;
    assert_int_equal(gphys_scene_raycast_filtered(scene, &down, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == of_triangle && hit.t == 9);
    filter.flags |= GPHYS_FILTER_NO_BACK_FACES; /* no surface at all */
    assert_int_equal(gphys_scene_raycast_filtered(scene, &down, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == of_ball && hit.t > 11);
    assert_int_equal(gphys_scene_segment_test_filtered(scene, &through, &filter, &hit), GPHYS_NO_HIT);
    filter.ignored_model = of_ball;
    assert_int_equal(gphys_scene_raycast_any_filtered(scene, &down, &filter, &any), GPHYS_OK);
    assert_int_equal(any, 0);

    /* A platform that lets a character through from one side. */
    filter = defaults();
    assert_int_equal(gphys_scene_sweep_filtered(scene, GPHYS_SHAPE_CAPSULE, &body, &fall, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == of_plane && hit.t == 0.5f);
    filter.flags = GPHYS_FILTER_NO_FRONT_FACES;
    assert_int_equal(gphys_scene_sweep_filtered(scene, GPHYS_SHAPE_CAPSULE, &body, &fall, &filter, &hit), GPHYS_OK);
    assert_true(hit.model == of_lower && hit.t == 0.9f);
    filter.ignored_model = of_lower;
    assert_int_equal(gphys_scene_sweep_filtered(scene, GPHYS_SHAPE_CAPSULE, &body, &fall, &filter, &hit), GPHYS_NO_HIT);
    {
        const gphys_sphere lowest = {{0, 6, 0}, 0.5f};
        filter.ignored_model = of_plane;
        filter.flags = GPHYS_FILTER_NO_BACK_FACES;
        assert_int_equal(gphys_scene_sweep_sphere_filtered(scene, &lowest, &fall, &filter, &hit), GPHYS_OK);
        assert_true(hit.model == of_upper && hit.t == 0.7f);
        filter.flags = GPHYS_FILTER_NO_FRONT_FACES;
        assert_int_equal(gphys_scene_sweep_sphere_filtered(scene, &lowest, &fall, &filter, &hit), GPHYS_OK);
        assert_true(hit.model == of_lower && hit.t == 0.9f);
    }
    gphys_scene_destroy(scene);
    gphys_mesh_destroy(upper);
    gphys_mesh_destroy(lower);
}

static float next_number(uint32_t* random) {
    *random = *random * 1664525u + 1013904223u;
    return (float)(*random >> 8) / 8388608.0f - 1;
}

static void faces_of_a_mesh_are_those_of_the_list_of_all(void** state) {
    enum { TRIANGLES = 3000, RAYS = 200 };
    static float vertices[9 * TRIANGLES];
    static uint32_t indices[3 * TRIANGLES];
    static gphys_ray rays[RAYS];
    static gphys_hit hits[RAYS], all[TRIANGLES];
    static gphys_distance distances[RAYS];
    static int32_t any[RAYS];
    const uint32_t flags[2] = {GPHYS_FILTER_NO_BACK_FACES, GPHYS_FILTER_NO_FRONT_FACES};
    gphys_mesh* mesh = NULL;
    gphys_scene* scene = NULL;
    gphys_model_id model;
    uint32_t random = 5, i, k, met = 0, passed = 0;
    (void)state;
    for (i = 0; i < 3 * TRIANGLES; ++i) {
        const uint32_t first = i - i % 3;
        indices[i] = i;
        for (k = 0; k < 3; ++k)
            vertices[3 * i + k] =
                next_number(&random) * (i == first ? 1 : 0.1f) + (i == first ? 0 : vertices[3 * first + k]);
    }
    for (i = 0; i < RAYS; ++i) {
        const gphys_ray ray = {{2 * next_number(&random), 2 * next_number(&random), 2 * next_number(&random)},
                               {next_number(&random), next_number(&random), next_number(&random)},
                               INFINITY};
        rays[i] = ray;
        rays[i].direction.x -= ray.origin.x; /* to somewhere among the triangles */
        rays[i].direction.y -= ray.origin.y;
        rays[i].direction.z -= ray.origin.z;
    }
    assert_int_equal(gphys_mesh_create(NULL, vertices, 12, 3 * TRIANGLES, indices, 3 * TRIANGLES, &mesh), GPHYS_OK);
    assert_int_equal(gphys_scene_create(NULL, &scene), GPHYS_OK);
    assert_int_equal(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, &model), GPHYS_OK);
    for (k = 0; k < 2; ++k) {
        gphys_query_filter_desc filter = defaults();
        filter.flags = flags[k];
        assert_int_equal(
            gphys_scene_raycast_filtered_batch(scene, rays, sizeof *rays, RAYS, &filter, 0, hits, sizeof *hits),
            GPHYS_OK);
        assert_int_equal(gphys_scene_raycast_distance_filtered_batch(scene, rays, sizeof *rays, RAYS, &filter, 0,
                                                                     distances, sizeof *distances),
                         GPHYS_OK);
        assert_int_equal(gphys_scene_raycast_any_filtered_batch(scene, rays, sizeof *rays, RAYS, &filter, 0, any, 4),
                         GPHYS_OK);
        for (i = 0; i < RAYS; ++i) {
            uint32_t total = 0, first = 0;
            gphys_hit single;
            gphys_status status;
            assert_int_equal(gphys_mesh_raycast_all(mesh, &rays[i], all, TRIANGLES, &total), GPHYS_OK);
            while (first < total && ((all[first].flags & GPHYS_HIT_BACK) != 0) == (k == 0)) ++first;
            status = gphys_scene_raycast_filtered(scene, &rays[i], &filter, &single);
            assert_int_equal(status, first < total ? GPHYS_OK : GPHYS_NO_HIT);
            assert_int_equal(any[i], first < total);
            assert_int_equal(hits[i].triangle, first < total ? all[first].triangle : GPHYS_NO_TRIANGLE);
            assert_true(distances[i].triangle == hits[i].triangle && distances[i].t == hits[i].t);
            if (first == total) continue;
            assert_memory_equal(&single, &hits[i], sizeof single);
            assert_true(single.t == all[first].t && single.flags == all[first].flags);
            ++met;
            passed += first > 0;
        }
    }
    assert_true(met > RAYS / 4 && passed > RAYS / 20);
    gphys_scene_destroy(scene);
    gphys_mesh_destroy(mesh);
}

static void bad_filters_are_refused_and_outputs_stay(void** state) {
    const gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, INFINITY};
    const gphys_segment segment = {{0, 0, 0}, {20, 0, 0}};
    const gphys_vec3 point = {0, 0, 0};
    const gphys_sphere ball = {{0, 0, 0}, 1};
    const float pixel[2] = {400, 300};
    gphys_model_id models[3], list[3] = {9, 9, 9};
    gphys_scene* scene = three_balls(models);
    gphys_camera* camera = NULL;
    gphys_frustum frustum;
    gphys_query_filter_desc bad[4];
    gphys_status expected[4];
    gphys_hit hits[2], untouched[2];
    gphys_nearest nearest, nearest_before;
    gphys_penetration way;
    int32_t any = 7;
    uint32_t total = 7, offsets[3] = {7, 7, 7}, i;
    (void)state;
    memset(hits, 9, sizeof hits);
    memset(untouched, 9, sizeof untouched);
    memset(&nearest, 9, sizeof nearest);
    nearest_before = nearest;
    assert_int_equal(gphys_camera_create(NULL, &camera), GPHYS_OK);
    assert_int_equal(gphys_camera_get_frustum(camera, &frustum), GPHYS_OK);
    for (i = 0; i < 4; ++i) bad[i] = defaults();
    bad[0].struct_size = 0;
    expected[0] = GPHYS_ERROR_STRUCT_SIZE;
    bad[1].reserved = 1;
    expected[1] = GPHYS_ERROR_STRUCT_SIZE;
    bad[2].flags = 8;
    expected[2] = GPHYS_ERROR_INVALID_ARGUMENT;
    bad[3].ignored_count = 1;
    expected[3] = GPHYS_ERROR_INVALID_ARGUMENT;
    for (i = 0; i < 4; ++i) {
        const gphys_query_filter_desc* f = &bad[i];
        gphys_query_filter_desc mixed[2];
        const uint32_t size = sizeof *f;
        mixed[0] = defaults();
        mixed[1] = bad[i];
        assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, f, hits), expected[i]);
        assert_int_equal(gphys_scene_raycast_any_filtered(scene, &ray, f, &any), expected[i]);
        assert_int_equal(gphys_scene_raycast_all_filtered(scene, &ray, f, hits, 2, &total), expected[i]);
        assert_int_equal(gphys_scene_segment_test_filtered(scene, &segment, f, hits), expected[i]);
        assert_int_equal(gphys_scene_overlap_filtered(scene, GPHYS_SHAPE_SPHERE, &ball, f, list, 3, &total),
                         expected[i]);
        assert_int_equal(gphys_scene_cull_filtered(scene, &frustum, f, list, 3, &total), expected[i]);
        assert_int_equal(gphys_scene_nearest_filtered(scene, &point, 1, f, &nearest), expected[i]);
        assert_int_equal(gphys_scene_sweep_sphere_filtered(scene, &ball, &point, f, hits), expected[i]);
        assert_int_equal(gphys_scene_sweep_filtered(scene, GPHYS_SHAPE_SPHERE, &ball, &point, f, hits), expected[i]);
        assert_int_equal(gphys_scene_penetration_filtered(scene, GPHYS_SHAPE_SPHERE, &ball, f, &way, 1, &total),
                         expected[i]);
        assert_int_equal(gphys_camera_pick_filtered(camera, scene, 1, 1, f, hits), expected[i]);
        assert_int_equal(gphys_camera_pick_rectangle_filtered(camera, scene, 0, 0, 9, 9, f, list, 3, &total),
                         expected[i]);
        assert_int_equal(gphys_camera_cull_filtered(camera, scene, f, list, 3, &total), expected[i]);
        assert_int_equal(gphys_scene_raycast_filtered_batch(scene, &ray, 0, 2, f, 0, hits, sizeof *hits), expected[i]);
        assert_int_equal(gphys_scene_raycast_filtered_batch(scene, &ray, 0, 2, mixed, size, hits, sizeof *hits),
                         expected[i]);
        assert_int_equal(gphys_scene_raycast_any_filtered_batch(scene, &ray, 0, 2, mixed, size, &any, 4), expected[i]);
        assert_int_equal(gphys_scene_raycast_all_filtered_batch(scene, &ray, 0, 2, mixed, size, hits, 2, offsets),
                         expected[i]);
        assert_int_equal(
            gphys_scene_segment_test_filtered_batch(scene, &segment, 0, 2, mixed, size, hits, sizeof *hits),
            expected[i]);
        assert_int_equal(
            gphys_scene_overlap_filtered_batch(scene, GPHYS_SHAPE_SPHERE, &ball, 0, 2, mixed, size, list, 3, offsets),
            expected[i]);
        assert_int_equal(
            gphys_scene_nearest_filtered_batch(scene, &point, 0, 2, 1, mixed, size, &nearest, sizeof nearest),
            expected[i]);
        assert_int_equal(
            gphys_scene_sweep_sphere_filtered_batch(scene, &ball, 0, &point, 0, 2, mixed, size, hits, sizeof *hits),
            expected[i]);
        assert_int_equal(gphys_scene_sweep_filtered_batch(scene, GPHYS_SHAPE_SPHERE, &ball, 0, &point, 0, 2, mixed,
                                                          size, hits, sizeof *hits),
                         expected[i]);
        assert_int_equal(gphys_scene_penetration_filtered_batch(scene, GPHYS_SHAPE_SPHERE, &ball, 0, 2, mixed, size,
                                                                &way, 1, offsets),
                         expected[i]);
        assert_int_equal(gphys_camera_pick_filtered_batch(camera, scene, pixel, 0, 2, mixed, size, hits, sizeof *hits),
                         expected[i]);
        assert_int_equal(gphys_scene_cull_filtered_batch(scene, &frustum, 0, 2, mixed, size, list, 3, offsets),
                         expected[i]);
    }
    bad[0] = defaults();
    bad[1] = defaults();
    assert_int_equal(gphys_scene_raycast_filtered(NULL, &ray, bad, hits), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_raycast_filtered(scene, NULL, bad, hits), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_raycast_filtered(scene, &ray, bad, NULL), GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_raycast_filtered_batch(NULL, &ray, 0, 1, bad, 0, hits, sizeof *hits),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_raycast_filtered_batch(scene, &ray, 0, 1, bad, sizeof *bad - 4, hits, sizeof *hits),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_int_equal(gphys_scene_raycast_filtered_batch(scene, &ray, 0, 1, bad, sizeof *bad + 2, hits, sizeof *hits),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    bad[0].struct_size = sizeof *bad + 4; /* more than there is of each */
    assert_int_equal(gphys_scene_raycast_filtered_batch(scene, &ray, 0, 1, bad, sizeof *bad, hits, sizeof *hits),
                     GPHYS_ERROR_INVALID_ARGUMENT);
    assert_memory_equal(hits, untouched, sizeof hits);
    assert_memory_equal(&nearest, &nearest_before, sizeof nearest);
    assert_true(any == 7 && total == 7 && offsets[0] == 7 && list[0] == 9);
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_defaults_see_everything),
        cmocka_unit_test(rays_pass_what_is_left_out),
        cmocka_unit_test(what_is_gone_leaves_out_nothing),
        cmocka_unit_test(other_queries_leave_out_the_same),
        cmocka_unit_test(batches_take_one_filter_or_one_each),
        cmocka_unit_test(a_larger_filter_means_what_its_known_part_says),
        cmocka_unit_test(a_camera_sees_behind_a_selection),
        cmocka_unit_test(faces_are_left_out_by_side),
        cmocka_unit_test(faces_of_a_mesh_are_those_of_the_list_of_all),
        cmocka_unit_test(bad_filters_are_refused_and_outputs_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

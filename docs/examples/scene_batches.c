/* The same questions for many at once. The scene is a yard: ground at y = 0; a wall
 * from x = 10 to 11, 3 m high and 20 m long; and a barrel with a radius of 0.5 m at x =
 * 5, upright and 1.5 m high with its round ends. */
#include <math.h>

#include "check.h"

static gphys_model_id place(gphys_scene* scene, gphys_shape_type type,
                            const void* shape) {
    gphys_model_id model;
    MUST(gphys_scene_add(scene, type, shape, NULL, NULL, &model));
    return model;
}

/* Three shots along x: at the barrel, beside it at the wall, and over both. What hits
 * nothing has the model 0. */
static void raycast_batch(const gphys_scene* scene, gphys_model_id barrel,
                          gphys_model_id wall) {
    const gphys_ray shots[3] = {{{0, 1, 0}, {1, 0, 0}, 100},
                                {{0, 1, 2}, {1, 0, 0}, 100},
                                {{0, 4, 0}, {1, 0, 0}, 100}};
    gphys_hit hits[3];
    MUST(gphys_scene_raycast_batch(scene, shots, sizeof shots[0], 3, GPHYS_ALL_LAYERS,
                                   hits, sizeof hits[0]));
    EXPECT(hits[0].model == barrel && hits[0].t == 4.5f);
    EXPECT(hits[1].model == wall && hits[1].t == 10);
    EXPECT(hits[2].model == 0 && hits[2].t == INFINITY);
}

/* A small lidar, 2 m before the wall: how far its eight beams come, all round, with a
 * range of 2.75 m. */
static void lidar(const gphys_scene* scene, gphys_model_id wall) {
    gphys_ray beams[8];
    gphys_distance found[8];
    for (int i = 0; i < 8; ++i) {
        const float angle = 0.785398f * (float)i;
        beams[i] = (gphys_ray){{8, 1, 0}, {cosf(angle), 0, sinf(angle)}, 2.75f};
    }
    MUST(gphys_scene_raycast_distance_batch(scene, beams, sizeof beams[0], 8,
                                            GPHYS_ALL_LAYERS, found, sizeof found[0]));
    EXPECT(found[0].model == wall && found[0].t == 2);
    /* The second beam meets nothing in its range, the fifth meets the barrel. */
    EXPECT(found[1].t == INFINITY && fabsf(found[4].t - 2.5f) < 1e-6f);
}

/* Which of two guards see a thief at (8, 1, 0)? The barrel hides him from the second.
 */
static void raycast_any_batch(const gphys_scene* scene) {
    const gphys_ray views[2] = {{{8, 1, 6}, {0, 0, -1}, 6}, {{1, 1, 0}, {1, 0, 0}, 7}};
    int32_t blocked[2];
    MUST(gphys_scene_raycast_any_batch(scene, views, sizeof views[0], 2,
                                       GPHYS_ALL_LAYERS, blocked, sizeof blocked[0]));
    EXPECT(blocked[0] == 0 && blocked[1] == 1);
}

/* Two bullets that go through all. Hits of bullet i are those from offsets[i] up to
 * offsets[i + 1]. */
static void raycast_all_batch(const gphys_scene* scene, gphys_model_id barrel,
                              gphys_model_id wall) {
    const gphys_ray bullets[2] = {{{0, 1, 5}, {1, 0, 0}, 100},
                                  {{0, 1, 0}, {1, 0, 0}, 100}};
    gphys_hit hits[16];
    uint32_t offsets[3];
    MUST(gphys_scene_raycast_all_batch(scene, bullets, sizeof bullets[0], 2,
                                       GPHYS_ALL_LAYERS, hits, 16, offsets));
    EXPECT(offsets[1] - offsets[0] == 1 && hits[0].model == wall);
    EXPECT(offsets[2] - offsets[1] == 2 && hits[1].model == barrel &&
           hits[2].model == wall);
}

/* The ways of two arrows in one frame: the first strikes the wall half way, the second
 * still flies. */
static void segment_test_batch(const gphys_scene* scene, gphys_model_id wall) {
    const gphys_segment ways[2] = {{{9.5f, 2, 0}, {10.5f, 2, 0}},
                                   {{7, 2, 3}, {8, 2, 3}}};
    gphys_hit hits[2];
    MUST(gphys_scene_segment_test_batch(scene, ways, sizeof ways[0], 2,
                                        GPHYS_ALL_LAYERS, hits, sizeof hits[0]));
    EXPECT(hits[0].model == wall && hits[0].t == 0.5f && hits[1].t == INFINITY);
}

/* Two triggers, balls with a radius of 1 m: one about the barrel, one in the air. */
static void overlap_batch(const gphys_scene* scene, gphys_model_id barrel) {
    const gphys_sphere triggers[2] = {{{5, 2, 0}, 1}, {{0, 20, 0}, 1}};
    gphys_model_id models[16];
    uint32_t offsets[3];
    MUST(gphys_scene_overlap_batch(scene, GPHYS_SHAPE_SPHERE, triggers,
                                   sizeof triggers[0], 2, GPHYS_ALL_LAYERS, models, 16,
                                   offsets));
    EXPECT(offsets[1] == 1 && models[0] == barrel);
    EXPECT(offsets[2] == offsets[1]); /* nothing for the second */
}

/* Two views in one call, as of a split screen: boxes of 4 m about the barrel and about
 * the air above it. */
static void cull_batch(const gphys_scene* scene, gphys_model_id barrel) {
    gphys_frustum views[2] = {{{5, 3, 0},
                               {{{0, 0, 1}, -2},
                                {{0, 0, -1}, -2},
                                {{1, 0, 0}, -2},
                                {{-1, 0, 0}, -2},
                                {{0, 1, 0}, -2},
                                {{0, -1, 0}, -2}}}};
    gphys_model_id models[16];
    uint32_t offsets[3];
    views[1] = views[0];
    views[1].origin.y = 10; /* the planes count from the origin */
    MUST(gphys_scene_cull_batch(scene, views, sizeof views[0], 2, GPHYS_ALL_LAYERS,
                                models, 16, offsets));
    EXPECT(offsets[1] == 1 && models[0] == barrel && offsets[2] == 1);
}

/* What is nearest to two birds, within 4 m. The second flies higher than that. */
static void nearest_batch(const gphys_scene* scene, gphys_model_id wall) {
    const gphys_vec3 birds[2] = {{10.5f, 4, 0}, {0, 50, 0}};
    gphys_nearest found[2];
    MUST(gphys_scene_nearest_batch(scene, birds, sizeof birds[0], 2, 4,
                                   GPHYS_ALL_LAYERS, found, sizeof found[0]));
    EXPECT(found[0].model == wall && found[0].distance == 1);
    EXPECT(found[1].model == 0 && found[1].distance == INFINITY);
}

/* Two balls of 0.5 m that fly 4 m along x: one meets the wall after 1.5 m, the other
 * nothing. */
static void sweep_sphere_batch(const gphys_scene* scene, gphys_model_id wall) {
    const gphys_sphere balls[2] = {{{8, 2, 0}, 0.5f}, {{-8, 2, 0}, 0.5f}};
    const gphys_vec3 way = {4, 0, 0};
    gphys_hit hits[2];
    MUST(gphys_scene_sweep_sphere_batch(scene, balls, sizeof balls[0], &way, 0, 2,
                                        GPHYS_ALL_LAYERS, hits, sizeof hits[0]));
    EXPECT(hits[0].model == wall && hits[0].t == 1.5f / 4 && hits[1].t == INFINITY);
}

/* Two characters walk, each its own way of 2 m: the first to the wall, the second along
 * it. */
static void sweep_batch(const gphys_scene* scene, gphys_model_id wall) {
    const gphys_capsule characters[2] = {{{9, 0.75f, 5}, {9, 1.5f, 5}, 0.5f},
                                         {{9, 0.75f, -5}, {9, 1.5f, -5}, 0.5f}};
    const gphys_vec3 ways[2] = {{2, 0, 0}, {0, 0, 2}};
    gphys_hit hits[2];
    MUST(gphys_scene_sweep_batch(scene, GPHYS_SHAPE_CAPSULE, characters,
                                 sizeof characters[0], ways, sizeof ways[0], 2,
                                 GPHYS_ALL_LAYERS, hits, sizeof hits[0]));
    EXPECT(hits[0].model == wall && hits[0].t == 0.25f && hits[1].t == INFINITY);
}

/* Two balls: one is 0.25 m in the wall, the other rests 0.125 m in the ground. */
static void penetration_batch(const gphys_scene* scene, gphys_model_id ground,
                              gphys_model_id wall) {
    const gphys_sphere balls[2] = {{{9.75f, 1, 0}, 0.5f}, {{0, 0.375f, 0}, 0.5f}};
    gphys_penetration ways[8];
    uint32_t offsets[3];
    MUST(gphys_scene_penetration_batch(scene, GPHYS_SHAPE_SPHERE, balls,
                                       sizeof balls[0], 2, GPHYS_ALL_LAYERS, ways, 8,
                                       offsets));
    EXPECT(offsets[1] == 1 && ways[0].model == wall && ways[0].depth == 0.25f);
    EXPECT(offsets[2] == 2 && ways[1].model == ground && ways[1].depth == 0.125f);
}

int main(void) {
    const gphys_plane flat = {{0, 1, 0}, 0};
    const gphys_aabb long_box = {{10, 0, -10}, {11, 3, 10}};
    const gphys_capsule upright = {{5, 0.5f, 0}, {5, 1, 0}, 0.5f};
    gphys_scene* scene = NULL;
    MUST(gphys_scene_create(NULL, &scene));
    const gphys_model_id ground = place(scene, GPHYS_SHAPE_PLANE, &flat);
    const gphys_model_id wall = place(scene, GPHYS_SHAPE_AABB, &long_box);
    const gphys_model_id barrel = place(scene, GPHYS_SHAPE_CAPSULE, &upright);
    raycast_batch(scene, barrel, wall);
    lidar(scene, wall);
    raycast_any_batch(scene);
    raycast_all_batch(scene, barrel, wall);
    segment_test_batch(scene, wall);
    overlap_batch(scene, barrel);
    cull_batch(scene, barrel);
    nearest_batch(scene, wall);
    sweep_sphere_batch(scene, wall);
    sweep_batch(scene, wall);
    penetration_batch(scene, ground, wall);
    gphys_scene_destroy(scene);
    return 0;
}

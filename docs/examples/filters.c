/* Queries with a filter, which leaves out models. A player is in a corridor along
 * x, a capsule with a radius of 0.5 m at the origin, who carries a lamp in front of
 * him. A guard of the same size is 5 m ahead of him, and behind the guard is a wall,
 * from x = 10 on and 3 m high. */
#include <math.h>

#include "check.h"

static gphys_model_id place(gphys_scene* scene, gphys_shape_type type,
                            const void* shape, float x, gphys_model_id parent) {
    const gphys_transform there = {{x, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_model_desc desc;
    gphys_model_id model;
    MUST(gphys_model_desc_init(&desc, sizeof desc));
    desc.parent = parent;
    MUST(gphys_scene_add(scene, type, shape, &there, &desc, &model));
    return model;
}

/* The player shoots from his own middle. He is left out with all that hangs below him,
 * such as his lamp. */
static void raycast(const gphys_scene* scene, gphys_model_id player,
                    gphys_model_id guard) {
    const gphys_ray shot = {{0, 1, 0}, {1, 0, 0}, 100};
    gphys_query_filter_desc filter;
    gphys_hit hit;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = player;
    filter.flags = GPHYS_FILTER_SUBTREE;
    MUST(gphys_scene_raycast_filtered(scene, &shot, &filter, &hit));
    EXPECT(hit.model == guard && hit.t == 4.5f);
}

/* The player and the guard shoot at each other in one call, each with a filter of his
 * own. */
static void raycast_batch(const gphys_scene* scene, gphys_model_id player,
                          gphys_model_id guard) {
    const gphys_ray shots[2] = {{{0, 1, 0}, {1, 0, 0}, 100},
                                {{5, 1, 0}, {-1, 0, 0}, 100}};
    gphys_query_filter_desc filters[2];
    gphys_hit hits[2];
    MUST(gphys_query_filter_desc_init(&filters[0], sizeof filters[0]));
    filters[1] = filters[0];
    filters[0].ignored_model = player;
    filters[0].flags = GPHYS_FILTER_SUBTREE;
    filters[1].ignored_model = guard;
    MUST(gphys_scene_raycast_filtered_batch(scene, shots, sizeof shots[0], 2, filters,
                                            sizeof filters[0], hits, sizeof hits[0]));
    EXPECT(hits[0].model == guard && hits[1].t == 4.5f);
}

/* A lidar that the player carries: the player is left out of its three beams, with one
 * filter for all. */
static void lidar(const gphys_scene* scene, gphys_model_id player,
                  gphys_model_id wall) {
    const gphys_ray beams[3] = {{{0, 1, 0}, {1, 0, 0}, 30},
                                {{0, 1, 1}, {1, 0, 0}, 30},
                                {{0, 1, 0}, {-1, 0, 0}, 30}};
    gphys_query_filter_desc filter;
    gphys_distance found[3];
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = player;
    filter.flags = GPHYS_FILTER_SUBTREE;
    MUST(gphys_scene_raycast_distance_filtered_batch(scene, beams, sizeof beams[0], 3,
                                                     &filter, 0, found,
                                                     sizeof found[0]));
    EXPECT(found[0].t == 4.5f && found[1].model == wall && found[1].t == 10 &&
           found[2].t == INFINITY);
}

/* Does the guard see the player? The line between their middles meets both, and the
 * lamp, so these three are left out. */
static void line_of_sight(const gphys_scene* scene, gphys_model_id player,
                          gphys_model_id lamp, gphys_model_id guard) {
    const gphys_model_id ignored[3] = {player, lamp, guard};
    const gphys_ray line = {
        {0, 1, 0}, {5, 0, 0}, 1}; /* t_max is in lengths of the direction */
    gphys_query_filter_desc filter;
    int32_t blocked;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_models = ignored;
    filter.ignored_count = 3;
    MUST(gphys_scene_raycast_any_filtered(scene, &line, &filter, &blocked));
    EXPECT(blocked == 0);
}

/* Whether something is within 3 m and within 12 m before the guard, himself left out.
 */
static void feelers(const gphys_scene* scene, gphys_model_id guard) {
    const gphys_ray feelers[2] = {{{5, 1, 0}, {1, 0, 0}, 3},
                                  {{5, 1, 0}, {1, 0, 0}, 12}};
    gphys_query_filter_desc filter;
    int32_t met[2];
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_raycast_any_filtered_batch(scene, feelers, sizeof feelers[0], 2,
                                                &filter, 0, met, sizeof met[0]));
    EXPECT(met[0] == 0 && met[1] == 1);
}

/* All that a bullet of the player goes through: the guard and the wall, and not the
 * player himself. */
static void raycast_all(const gphys_scene* scene, gphys_model_id player,
                        gphys_model_id wall) {
    const gphys_ray bullet = {{0, 1, 0}, {1, 0, 0}, 100};
    gphys_query_filter_desc filter;
    gphys_hit hits[8];
    uint32_t total;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = player;
    filter.flags = GPHYS_FILTER_SUBTREE;
    MUST(gphys_scene_raycast_all_filtered(scene, &bullet, &filter, hits, 8, &total));
    EXPECT(total == 2 && hits[0].t == 4.5f && hits[1].model == wall);
}

/* Two bullets of the player. Hits of bullet i are those from offsets[i] up to offsets[i
 * + 1]. */
static void raycast_all_batch(const gphys_scene* scene, gphys_model_id player,
                              gphys_model_id wall) {
    const gphys_ray bullets[2] = {{{0, 1, 0}, {1, 0, 0}, 100},
                                  {{0, 2.5f, 0}, {1, 0, 0}, 100}};
    gphys_query_filter_desc filter;
    gphys_hit hits[16];
    uint32_t offsets[3];
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = player;
    filter.flags = GPHYS_FILTER_SUBTREE;
    MUST(gphys_scene_raycast_all_filtered_batch(scene, bullets, sizeof bullets[0], 2,
                                                &filter, 0, hits, 16, offsets));
    EXPECT(offsets[1] == 2 && offsets[2] == 3 && hits[2].model == wall);
}

/* The way of a sword from the guard's middle, 6 m along x: the guard is left out, the
 * wall is met. */
static void segment_test(const gphys_scene* scene, gphys_model_id guard,
                         gphys_model_id wall) {
    const gphys_segment way = {{5, 1, 0}, {11, 1, 0}};
    gphys_query_filter_desc filter;
    gphys_hit hit;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_segment_test_filtered(scene, &way, &filter, &hit));
    EXPECT(hit.model == wall && fabsf(hit.t * 6 - 5) < 1e-6f);
}

/* Two throws of the guard, one towards the wall and one away from all; one filter for
 * both. */
static void segment_test_batch(const gphys_scene* scene, gphys_model_id guard,
                               gphys_model_id wall) {
    const gphys_segment ways[2] = {{{5, 1, 0}, {15, 1, 0}}, {{5, 1, 0}, {5, 1, 9}}};
    gphys_query_filter_desc filter;
    gphys_hit hits[2];
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_segment_test_filtered_batch(scene, ways, sizeof ways[0], 2,
                                                 &filter, 0, hits, sizeof hits[0]));
    EXPECT(hits[0].model == wall && hits[0].t == 0.5f && hits[1].t == INFINITY);
}

/* Who else is within 4.75 m of the guard? The player and his lamp. */
static void overlap(const gphys_scene* scene, gphys_model_id player,
                    gphys_model_id guard) {
    const gphys_sphere reach = {{5, 1, 0}, 4.75f};
    gphys_query_filter_desc filter;
    gphys_model_id models[8];
    uint32_t total;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_overlap_filtered(scene, GPHYS_SHAPE_SPHERE, &reach, &filter,
                                      models, 8, &total));
    EXPECT(total == 2 && models[0] == player);
}

/* Who else is within 4.75 m of the player and of the guard? Each leaves out himself,
 * the player with his lamp. */
static void overlap_batch(const gphys_scene* scene, gphys_model_id player,
                          gphys_model_id guard) {
    const gphys_sphere reach[2] = {{{0, 1, 0}, 4.75f}, {{5, 1, 0}, 4.75f}};
    gphys_query_filter_desc filters[2];
    gphys_model_id models[16];
    uint32_t offsets[3];
    MUST(gphys_query_filter_desc_init(&filters[0], sizeof filters[0]));
    filters[1] = filters[0];
    filters[0].ignored_model = player;
    filters[0].flags = GPHYS_FILTER_SUBTREE;
    filters[1].ignored_model = guard;
    MUST(gphys_scene_overlap_filtered_batch(scene, GPHYS_SHAPE_SPHERE, reach,
                                            sizeof reach[0], 2, filters,
                                            sizeof filters[0], models, 16, offsets));
    EXPECT(offsets[1] == 1 && models[0] == guard);
    EXPECT(offsets[2] - offsets[1] == 2 && models[1] == player); /* and his lamp */
}

/* What the player sees in a view that begins in his head: he himself is not drawn. */
static void cull(const gphys_scene* scene, const gphys_frustum* view,
                 gphys_model_id player, gphys_model_id guard) {
    gphys_query_filter_desc filter;
    gphys_model_id models[8];
    uint32_t total;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = player;
    filter.flags = GPHYS_FILTER_SUBTREE;
    MUST(gphys_scene_cull_filtered(scene, view, &filter, models, 8, &total));
    EXPECT(total == 2 && models[0] == guard); /* and the wall */
}

/* A split screen: both look along x, and neither sees himself. The views start in their
 * heads. */
static void cull_batch(const gphys_scene* scene, const gphys_frustum views[2],
                       gphys_model_id player, gphys_model_id guard) {
    gphys_query_filter_desc filters[2];
    gphys_model_id models[16];
    uint32_t offsets[3];
    MUST(gphys_query_filter_desc_init(&filters[0], sizeof filters[0]));
    filters[1] = filters[0];
    filters[0].ignored_model = player;
    filters[0].flags = GPHYS_FILTER_SUBTREE;
    filters[1].ignored_model = guard;
    MUST(gphys_scene_cull_filtered_batch(scene, views, sizeof views[0], 2, filters,
                                         sizeof filters[0], models, 16, offsets));
    EXPECT(offsets[1] == 2 && models[0] == guard); /* and the wall */
    EXPECT(offsets[2] - offsets[1] == 1);          /* the wall alone */
}

/* Who is nearest to the guard, besides himself? The player, whose front is 4.5 m from
 * the guard's middle. */
static void nearest(const gphys_scene* scene, gphys_model_id player,
                    gphys_model_id guard) {
    const gphys_vec3 middle = {5, 1, 0};
    gphys_query_filter_desc filter;
    gphys_nearest found;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_nearest_filtered(scene, &middle, 20, &filter, &found));
    EXPECT(found.model == player && found.distance == 4.5f);
}

/* Who is nearest to the player and to the guard, besides each himself, within 4.75 m?
 */
static void nearest_batch(const gphys_scene* scene, gphys_model_id player,
                          gphys_model_id guard) {
    const gphys_vec3 middles[2] = {{0, 1, 0}, {5, 1, 0}};
    gphys_query_filter_desc filters[2];
    gphys_nearest found[2];
    MUST(gphys_query_filter_desc_init(&filters[0], sizeof filters[0]));
    filters[1] = filters[0];
    filters[0].ignored_model = player;
    filters[0].flags = GPHYS_FILTER_SUBTREE;
    filters[1].ignored_model = guard;
    MUST(gphys_scene_nearest_filtered_batch(scene, middles, sizeof middles[0], 2, 4.75f,
                                            filters, sizeof filters[0], found,
                                            sizeof found[0]));
    EXPECT(found[0].model == guard && found[1].model == player);
}

/* The ball around the guard's head, moved by 8 m: without the filter it would meet the
 * guard at once. */
static void sweep_sphere(const gphys_scene* scene, gphys_model_id guard,
                         gphys_model_id wall) {
    const gphys_sphere head = {{5, 1.5f, 0}, 0.5f};
    const gphys_vec3 way = {8, 0, 0};
    gphys_query_filter_desc filter;
    gphys_hit hit;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_sweep_sphere_filtered(scene, &head, &way, &filter, &hit));
    EXPECT(hit.model == wall && hit.t * 8 == 4.5f);
}

/* Two ways of the guard's head, along the corridor and across it. */
static void sweep_sphere_batch(const gphys_scene* scene, gphys_model_id guard,
                               gphys_model_id wall) {
    const gphys_sphere head = {{5, 1.5f, 0}, 0.5f};
    const gphys_vec3 ways[2] = {{8, 0, 0}, {0, 0, 8}};
    gphys_query_filter_desc filter;
    gphys_hit hits[2];
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_sweep_sphere_filtered_batch(scene, &head, 0, ways, sizeof ways[0],
                                                 2, &filter, 0, hits, sizeof hits[0]));
    EXPECT(hits[0].model == wall && hits[1].t == INFINITY);
}

/* The guard walks 8 m along x: his own capsule moves, and he is not in his own
 * way. */
static void sweep(const gphys_scene* scene, gphys_model_id guard, gphys_model_id wall) {
    const gphys_capsule body = {{5, 0.5f, 0}, {5, 1.5f, 0}, 0.5f};
    const gphys_vec3 way = {8, 0, 0};
    gphys_query_filter_desc filter;
    gphys_hit hit;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_sweep_filtered(scene, GPHYS_SHAPE_CAPSULE, &body, &way, &filter,
                                    &hit));
    EXPECT(hit.model == wall && hit.t * 8 == 4.5f);
}

/* Both walk 8 m towards each other, and get 4 m far, to where the other is now. */
static void sweep_batch(const gphys_scene* scene, gphys_model_id player,
                        gphys_model_id guard) {
    const gphys_capsule bodies[2] = {{{0, 0.5f, 0}, {0, 1.5f, 0}, 0.5f},
                                     {{5, 0.5f, 0}, {5, 1.5f, 0}, 0.5f}};
    const gphys_vec3 ways[2] = {{8, 0, 0}, {-8, 0, 0}};
    gphys_query_filter_desc filters[2];
    gphys_hit hits[2];
    MUST(gphys_query_filter_desc_init(&filters[0], sizeof filters[0]));
    filters[1] = filters[0];
    filters[0].ignored_model = player;
    filters[0].flags = GPHYS_FILTER_SUBTREE;
    filters[1].ignored_model = guard;
    MUST(gphys_scene_sweep_filtered_batch(scene, GPHYS_SHAPE_CAPSULE, bodies,
                                          sizeof bodies[0], ways, sizeof ways[0], 2,
                                          filters, sizeof filters[0], hits,
                                          sizeof hits[0]));
    EXPECT(hits[0].model == guard && hits[0].t == 0.5f);
    EXPECT(hits[1].model == player && hits[1].t == 0.5f);
}

/* The guard leans 0.25 m into the wall: only the wall pushes him, not the model that he
 * still is at x = 5. */
static void penetration(const gphys_scene* scene, gphys_model_id guard,
                        gphys_model_id wall) {
    const gphys_capsule body = {{9.75f, 0.5f, 0}, {9.75f, 1.5f, 0}, 0.5f};
    gphys_query_filter_desc filter;
    gphys_penetration ways[4];
    uint32_t total;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = guard;
    MUST(gphys_scene_penetration_filtered(scene, GPHYS_SHAPE_CAPSULE, &body, &filter,
                                          ways, 4, &total));
    EXPECT(total == 1 && ways[0].model == wall && ways[0].depth == 0.25f &&
           ways[0].normal.x == -1);
}

/* Two are pushed out in one call, each of all but his own model, which is where he was
 * before: the player stands free, the guard has come into him from behind. */
static void penetration_batch(const gphys_scene* scene, gphys_model_id player,
                              gphys_model_id guard) {
    const gphys_capsule bodies[2] = {{{0, 0.5f, 0}, {0, 1.5f, 0}, 0.5f},
                                     {{-0.75f, 0.5f, 0}, {-0.75f, 1.5f, 0}, 0.5f}};
    gphys_query_filter_desc filters[2];
    gphys_penetration ways[8];
    uint32_t offsets[3];
    MUST(gphys_query_filter_desc_init(&filters[0], sizeof filters[0]));
    filters[1] = filters[0];
    filters[0].ignored_model = player;
    filters[0].flags = GPHYS_FILTER_SUBTREE;
    filters[1].ignored_model = guard;
    MUST(gphys_scene_penetration_filtered_batch(scene, GPHYS_SHAPE_CAPSULE, bodies,
                                                sizeof bodies[0], 2, filters,
                                                sizeof filters[0], ways, 8, offsets));
    EXPECT(offsets[1] == 0 && offsets[2] == 1); /* nothing, then one */
    EXPECT(ways[0].model == player && ways[0].depth == 0.25f && ways[0].normal.x == -1);
}

int main(void) {
    const gphys_capsule person = {{0, 0.5f, 0}, {0, 1.5f, 0}, 0.5f};
    const gphys_sphere small = {{0, 1, 0}, 0.1f};
    const gphys_aabb box = {{0, 0, -4}, {1, 3, 4}};
    gphys_scene* scene = NULL;
    MUST(gphys_scene_create(NULL, &scene));
    const gphys_model_id player = place(scene, GPHYS_SHAPE_CAPSULE, &person, 0, 0);
    const gphys_model_id lamp = place(scene, GPHYS_SHAPE_SPHERE, &small, 0.4f, player);
    const gphys_model_id guard = place(scene, GPHYS_SHAPE_CAPSULE, &person, 5, 0);
    const gphys_model_id wall = place(scene, GPHYS_SHAPE_AABB, &box, 10, 0);
    const gphys_frustum along_x = {{0, 1.5f, 0},
                                   {{{1, 0, 0}, 0.1f},
                                    {{-1, 0, 0}, -100},
                                    {{1, 0, 1}, 0},
                                    {{1, 0, -1}, 0},
                                    {{1, 1, 0}, 0},
                                    {{1, -1, 0}, 0}}};
    gphys_frustum views[2] = {along_x, along_x};
    views[1].origin.x = 5;
    raycast(scene, player, guard);
    raycast_batch(scene, player, guard);
    lidar(scene, player, wall);
    line_of_sight(scene, player, lamp, guard);
    feelers(scene, guard);
    raycast_all(scene, player, wall);
    raycast_all_batch(scene, player, wall);
    segment_test(scene, guard, wall);
    segment_test_batch(scene, guard, wall);
    overlap(scene, player, guard);
    overlap_batch(scene, player, guard);
    cull(scene, &along_x, player, guard);
    cull_batch(scene, views, player, guard);
    nearest(scene, player, guard);
    nearest_batch(scene, player, guard);
    sweep_sphere(scene, guard, wall);
    sweep_sphere_batch(scene, guard, wall);
    sweep(scene, guard, wall);
    sweep_batch(scene, player, guard);
    penetration(scene, guard, wall);
    penetration_batch(scene, player, guard);
    gphys_scene_destroy(scene);
    return 0;
}

/* Questions to a scene. The scene is a yard: ground at y = 0; a wall from x = 10 to 11,
 * 3 m high and 20 m long; and a barrel with a radius of 0.5 m at x = 5, upright and 1.5
 * m high with its round ends. */
#include <math.h>

#include "check.h"

static gphys_model_id place(gphys_scene* scene, gphys_shape_type type,
                            const void* shape) {
    gphys_model_id model;
    MUST(gphys_scene_add(scene, type, shape, NULL, NULL, &model));
    return model;
}

/* A shot along x at a height of 1 m: the barrel is in its way, a wall behind it. */
static void raycast(const gphys_scene* scene, gphys_model_id barrel) {
    const gphys_ray shot = {{0, 1, 0}, {1, 0, 0}, 100};
    gphys_hit hit;
    MUST(gphys_scene_raycast(scene, &shot, GPHYS_ALL_LAYERS, &hit));
    EXPECT(hit.model == barrel && hit.t == 4.5f && hit.normal.x == -1);
}

/* Is a place in the shade, with the sun straight above? Whether is cheaper to know than
 * what. */
static void raycast_any(const gphys_scene* scene) {
    const gphys_ray beside_wall = {{9, 0.1f, 0}, {0, 1, 0}, INFINITY},
                    under_wall = {{10.5f, 0.1f, 0}, {0, 1, 0}, INFINITY};
    int32_t shaded;
    MUST(gphys_scene_raycast_any(scene, &beside_wall, GPHYS_ALL_LAYERS, &shaded));
    EXPECT(shaded == 0);
    MUST(gphys_scene_raycast_any(scene, &under_wall, GPHYS_ALL_LAYERS, &shaded));
    EXPECT(shaded == 1);
}

/* A bullet that goes through all it meets: the barrel first, then the wall. */
static void raycast_all(const gphys_scene* scene, gphys_model_id barrel,
                        gphys_model_id wall) {
    const gphys_ray bullet = {{0, 1, 0}, {1, 0, 0}, 100};
    gphys_hit hits[8];
    uint32_t total;
    MUST(gphys_scene_raycast_all(scene, &bullet, GPHYS_ALL_LAYERS, hits, 8, &total));
    EXPECT(total == 2 && hits[0].model == barrel && hits[1].model == wall);
    EXPECT(hits[1].t == 10);
}

/* A line of sight between two people, 8 m apart, with a barrel between them. t is the
 * share of the way. */
static void segment_test(const gphys_scene* scene, gphys_model_id barrel) {
    const gphys_segment low = {{1, 1, 0}, {9, 1, 0}},
                        high = {{1, 1.75f, 0}, {9, 1.75f, 0}};
    gphys_hit hit;
    MUST(gphys_scene_segment_test(scene, &low, GPHYS_ALL_LAYERS, &hit));
    EXPECT(hit.model == barrel && hit.t == 3.5f / 8);
    /* From higher up the view goes over it. */
    EXPECT(gphys_scene_segment_test(scene, &high, GPHYS_ALL_LAYERS, &hit) ==
           GPHYS_NO_HIT);
}

/* What a blast with a radius of 2 m at x = 7 reaches: the barrel and the ground. The
 * wall is 3 m away. */
static void overlap(const gphys_scene* scene, gphys_model_id ground,
                    gphys_model_id barrel) {
    const gphys_sphere blast = {{7, 1, 0}, 2};
    gphys_model_id models[8];
    uint32_t total;
    MUST(gphys_scene_overlap(scene, GPHYS_SHAPE_SPHERE, &blast, GPHYS_ALL_LAYERS,
                             models, 8, &total));
    EXPECT(total == 2 && models[0] == ground && models[1] == barrel); /* by id */
}

/* What is nearest to a lamp, within 5 m: the wall, 2 m away. The ground is 4 m below.
 */
static void nearest(const gphys_scene* scene, gphys_model_id wall) {
    const gphys_vec3 lamp = {10.5f, 5, 0};
    gphys_nearest found;
    MUST(gphys_scene_nearest(scene, &lamp, 5, GPHYS_ALL_LAYERS, &found));
    EXPECT(found.model == wall && found.distance == 2 && found.point.y == 3);
}

/* A camera is a ball of 25 cm that goes back from x = 9 by 8 m: it stops at the barrel,
 * after 3.25 m. */
static void sweep_sphere(const gphys_scene* scene, gphys_model_id barrel) {
    const gphys_sphere camera = {{9, 1, 0}, 0.25f};
    const gphys_vec3 back = {-8, 0, 0};
    gphys_hit hit;
    MUST(gphys_scene_sweep_sphere(scene, &camera, &back, GPHYS_ALL_LAYERS, &hit));
    EXPECT(hit.model == barrel && hit.t * 8 == 3.25f);
}

/* A character, 1.5 m tall and 1 m wide, walks 4 m towards the wall: it gets 1.5 m far.
 * It floats a little, as a capsule that touches the ground has met it already. */
static void sweep(const gphys_scene* scene, gphys_model_id wall) {
    const gphys_capsule character = {{8, 0.75f, 5}, {8, 1.25f, 5}, 0.5f};
    const gphys_vec3 way = {4, 0, 0};
    gphys_hit hit;
    MUST(gphys_scene_sweep(scene, GPHYS_SHAPE_CAPSULE, &character, &way,
                           GPHYS_ALL_LAYERS, &hit));
    EXPECT(hit.model == wall && hit.t * 4 == 1.5f && hit.normal.x == -1);
}

/* A ball that is 0.25 m deep in the wall and 0.1 m in the ground: the deepest comes
 * first. */
static void penetration(const gphys_scene* scene, gphys_model_id ground,
                        gphys_model_id wall) {
    const gphys_sphere ball = {{9.75f, 0.4f, 0}, 0.5f};
    gphys_penetration ways[4];
    uint32_t total;
    MUST(gphys_scene_penetration(scene, GPHYS_SHAPE_SPHERE, &ball, GPHYS_ALL_LAYERS,
                                 ways, 4, &total));
    EXPECT(total == 2 && ways[0].model == wall && ways[1].model == ground);
    EXPECT(ways[0].depth == 0.25f && ways[0].normal.x == -1);
    EXPECT(fabsf(ways[1].depth - 0.1f) < 1e-6f && ways[1].normal.y == 1);
}

/* What a view holds, for drawing: here a box of 4 m about the barrel as a frustum. The
 * wall is not in it. */
static void cull(const gphys_scene* scene, gphys_model_id ground,
                 gphys_model_id barrel) {
    const gphys_frustum view = {{5, 1, 0},
                                {{{0, 0, 1}, -2},
                                 {{0, 0, -1}, -2},
                                 {{1, 0, 0}, -2},
                                 {{-1, 0, 0}, -2},
                                 {{0, 1, 0}, -2},
                                 {{0, -1, 0}, -2}}};
    gphys_model_id models[8];
    uint32_t total;
    MUST(gphys_scene_cull(scene, &view, GPHYS_ALL_LAYERS, models, 8, &total));
    EXPECT(total == 2 && models[0] == ground && models[1] == barrel);
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
    raycast(scene, barrel);
    raycast_any(scene);
    raycast_all(scene, barrel, wall);
    segment_test(scene, barrel);
    overlap(scene, ground, barrel);
    nearest(scene, wall);
    sweep_sphere(scene, barrel);
    sweep(scene, wall);
    penetration(scene, ground, wall);
    cull(scene, ground, barrel);
    gphys_scene_destroy(scene);
    return 0;
}

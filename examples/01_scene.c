/* A scene and the questions one can ask it: models from shapes and a shared mesh, a parent that
 * takes its child along, then ray, segment, overlap, nearest and sweep, one by one and in batches.
 * The exit status is 0 only if every answer is right. */
#include <math.h>

#include "check.h"

enum { TAG_GROUND = 1, TAG_ARM, TAG_HAND, TAG_PYRAMID };
enum { LAYER_WORLD = 1, LAYER_ROBOT = 2 };

static gphys_transform at(float x, float y, float z) {
    const gphys_transform t = {{x, y, z}, {0, 0, 0, 1}, 1};
    return t;
}

/* A four-sided pyramid of height 2 on a square of side 2, shared by many models. */
static gphys_mesh* pyramid(void) {
    static const float vertices[][3] = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 2, 0}};
    static const uint32_t indices[] = {0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4};
    gphys_mesh* mesh = NULL;
    gphys_mesh_report report;
    MUST(gphys_mesh_create(NULL, vertices[0], sizeof vertices[0], 5, indices, 18, &mesh));
    MUST(gphys_mesh_get_report(mesh, &report));
    printf("pyramid: %u triangles, %u open edges\n", (unsigned)report.triangle_count, (unsigned)report.open_edge_count);
    EXPECT(report.triangle_count == 6 && report.open_edge_count == 0);
    return mesh;
}

int main(void) {
    gphys_scene* scene = NULL;
    MUST(gphys_scene_create(NULL, &scene));
    gphys_model_desc desc;
    MUST(gphys_model_desc_init(&desc, sizeof desc));

    /* The ground: everything on and below y = 0 is behind its front. */
    const gphys_plane ground = {{0, 1, 0}, 0};
    gphys_model_id ground_id;
    desc.tag = TAG_GROUND;
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &ground, NULL, &desc, &ground_id));

    /* A row of 100 pyramids, five metres apart, that share one mesh. */
    enum { PYRAMIDS = 100 };
    gphys_mesh* mesh = pyramid();
    gphys_transform places[PYRAMIDS];
    gphys_model_id pyramids[PYRAMIDS];
    for (int i = 0; i < PYRAMIDS; ++i) places[i] = at(5.0f * (float)i, 0, 10);
    desc.tag = TAG_PYRAMID;
    MUST(gphys_scene_add_batch(scene, GPHYS_SHAPE_MESH, mesh, 0, places, sizeof places[0], PYRAMIDS, &desc, pyramids));
    gphys_mesh_destroy(mesh); /* the models keep it */

    /* A robot's arm, and a hand two metres above it that follows. */
    const gphys_capsule bone = {{0, 0, 0}, {0, 1, 0}, 0.2f};
    const gphys_sphere ball = {{0, 0, 0}, 0.5f};
    const gphys_transform arm_place = at(0, 1, -5), hand_place = at(0, 2, 0);
    gphys_model_id arm, hand;
    desc.layers = LAYER_ROBOT;
    desc.tag = TAG_ARM;
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_CAPSULE, &bone, &arm_place, &desc, &arm));
    desc.parent = arm;
    desc.tag = TAG_HAND;
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &hand_place, &desc, &hand));

    /* Ray: the closest model, where, and which triangle. */
    const gphys_ray forward = {{25, 1, 0}, {0, 0, 1}, INFINITY};
    gphys_hit hit;
    MUST(gphys_scene_raycast(scene, &forward, GPHYS_ALL_LAYERS, &hit));
    printf("ray: a pyramid, triangle %u, %g m away\n", (unsigned)hit.triangle, hit.t);
    EXPECT(hit.model == pyramids[5] && fabsf(hit.t - 9.5f) < 1e-6f && hit.normal.z < 0);

    /* Segment: a line of sight, first with the robot in the way, then looking past its layer. */
    const gphys_segment sight = {{0, 3, -10}, {0, 3, 0}};
    MUST(gphys_scene_segment_test(scene, &sight, GPHYS_ALL_LAYERS, &hit));
    EXPECT(hit.model == hand && hit.t == 0.45f);
    EXPECT(gphys_scene_segment_test(scene, &sight, LAYER_WORLD, &hit) == GPHYS_NO_HIT);
    printf("line of sight: blocked by the hand, free without the robot's layer\n");

    /* Move the arm: the hand is where it should be at the next question. */
    const gphys_transform moved = at(0, 1, -50);
    MUST(gphys_scene_set_transform(scene, arm, &moved));
    EXPECT(gphys_scene_segment_test(scene, &sight, GPHYS_ALL_LAYERS, &hit) == GPHYS_NO_HIT);
    const gphys_vec3 above = {0, 10, -50};
    gphys_nearest nearest;
    MUST(gphys_scene_nearest(scene, &above, INFINITY, LAYER_ROBOT, &nearest));
    printf("nearest part of the robot: tag %u at %g m\n", (unsigned)nearest.tag, nearest.distance);
    EXPECT(nearest.model == hand && nearest.distance == 6.5f);

    /* Overlap: everything within a box, in ascending order; too small an array is reported. */
    const gphys_aabb box = {{-1, 0.5f, 8}, {21, 1, 12}};
    gphys_model_id found[3];
    uint32_t total = 0;
    EXPECT(gphys_scene_overlap(scene, GPHYS_SHAPE_AABB, &box, LAYER_WORLD, found, 3, &total) == GPHYS_INCOMPLETE);
    printf("box: %u models, and room for three of them\n", (unsigned)total);
    EXPECT(total == 5 && found[0] < found[1] && found[1] < found[2]);

    /* Sweep: a ball of radius 1 that falls from a height of 11 stops on the ground after 10 m. */
    const gphys_sphere falling = {{-20, 11, 0}, 1};
    const gphys_vec3 fall = {0, -20, 0};
    MUST(gphys_scene_sweep_sphere(scene, &falling, &fall, GPHYS_ALL_LAYERS, &hit));
    EXPECT(hit.model == ground_id && hit.t == 0.5f && hit.normal.y == 1);

    /* Batch: one call for 1000 rays that look down; each finds a pyramid or the ground. */
    static gphys_ray rays[1000];
    static gphys_hit hits[1000];
    uint32_t on_pyramid = 0;
    for (int i = 0; i < 1000; ++i) rays[i] = (gphys_ray){{0.5f * (float)i, 5, 10}, {0, -1, 0}, 10};
    MUST(gphys_scene_raycast_batch(scene, rays, sizeof rays[0], 1000, LAYER_WORLD, hits, sizeof hits[0]));
    for (int i = 0; i < 1000; ++i) on_pyramid += hits[i].tag == TAG_PYRAMID && hits[i].t < 5;
    printf("batch: %u of 1000 rays end on a pyramid\n", (unsigned)on_pyramid);
    EXPECT(on_pyramid == 3 * PYRAMIDS - 1); /* at -0.5, 0 and 0.5 m of each centre; -0.5 of the first has no ray */

    gphys_scene_destroy(scene);
    return 0;
}

/* A scene as a whole: its octree, threads, origin, and the check of its structure. */
#include "check.h"

/* A level of 1000 crates was streamed in one by one. A rebuild while it is still hidden
 * makes rays faster. */
static void rebuild(gphys_scene* scene) {
    gphys_octree_stats stats;
    MUST(gphys_scene_rebuild_octree(scene));
    MUST(gphys_scene_get_octree_stats(scene, &stats));
    printf("%u models in %u nodes, depth %u, cost of a ray %.1f\n",
           (unsigned)stats.item_count, (unsigned)stats.node_count,
           (unsigned)stats.depth, stats.cost);
    EXPECT(stats.item_count == 1000);
}

/* A level of 1000 crates was streamed in one by one. While frames go on, each rebuilds
 * a part, of about 200 models' work, until nothing is left to do. */
static void maintain(gphys_scene* scene) {
    int32_t done = 0;
    for (int frame = 0; frame < 1000 && !done; ++frame) {
        MUST(gphys_scene_maintain_octree(scene, 200, &done));
    }
    EXPECT(done == 1);
}

/* The boxes of the octree, to draw those of one level. The first is the root's, which
 * holds all others. */
static void boxes(const gphys_scene* scene) {
    uint32_t total, second = 0;
    gphys_scene_get_octree_boxes(scene, NULL, 0, &total);
    gphys_octree_box* boxes = malloc(total * sizeof *boxes);
    MUST(gphys_scene_get_octree_boxes(scene, boxes, total, &total));
    for (uint32_t i = 0; i < total; ++i) second += boxes[i].depth == 1;
    EXPECT(boxes[0].depth == 0 && second >= 1 && second <= 8);
    free(boxes);
}

/* The user's setting for threads. Answers have the same bits for every number of them.
 */
static void workers(gphys_scene* scene) {
    uint32_t count;
    MUST(gphys_scene_set_worker_count(scene, 2));
    MUST(gphys_scene_get_worker_count(scene, &count));
    EXPECT(count == 2);
}

/* The player has gone 5 km along x: the origin follows him, and a crate at 5010 m is at
 * 10 m from there. */
static void origin(gphys_scene* scene, gphys_model_id crate) {
    const double player[3] = {5000, 0, 0};
    double now[3];
    gphys_transform place;
    MUST(gphys_scene_set_origin(scene, player));
    MUST(gphys_scene_get_origin(scene, now));
    MUST(gphys_scene_get_world_transforms(scene, &crate, 1, &place, sizeof place));
    EXPECT(now[0] == 5000 && place.position.x == 10);
}

/* In a test of your own: is the scene's structure sound after all that was done to it?
 * If not, the library has a defect, and what MUST prints belongs into the report. */
static void validate(const gphys_scene* scene) {
    uint32_t total;
    MUST(gphys_scene_validate(scene));
    EXPECT(gphys_scene_get_models(scene, NULL, 0, &total) == GPHYS_INCOMPLETE &&
           total == 1000);
}

int main(void) {
    const gphys_aabb box = {{0, 0, 0}, {1, 1, 1}};
    gphys_scene* scene = NULL;
    gphys_model_id crate = 0;
    MUST(gphys_scene_create(NULL, &scene));
    for (int i = 0; i < 1000; ++i) {
        const gphys_transform place = {
            {5.01f * (float)(i + 1), 0, (float)(i * 37 % 100)}, {0, 0, 0, 1}, 1};
        MUST(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &box, &place, NULL, &crate));
    }
    maintain(scene);
    rebuild(scene);
    boxes(scene);
    workers(scene);
    origin(scene, crate);
    validate(scene);
    gphys_scene_destroy(scene);
    return 0;
}

/* Models that hang below others. The robot of these examples stands at the origin. Its
 * arm is 2 m above its feet, and its hand a metre to the side of the arm. A cup is 4.5
 * m along x, at a height of 2 m. */
#include <math.h>

#include "check.h"

static gphys_model_id part(gphys_scene* scene, gphys_model_id parent, float x,
                           float y) {
    const gphys_sphere ball = {{0, 0, 0}, 0.25f};
    const gphys_transform place = {{x, y, 0}, {0, 0, 0, 1}, 1};
    gphys_model_desc desc;
    gphys_model_id model;
    MUST(gphys_model_desc_init(&desc, sizeof desc));
    desc.parent = parent;
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &place, &desc, &model));
    return model;
}

/* A robot goes to x = 3. Its hand, whose own transform is a metre to the side of the
 * arm, comes along. */
static void follow(gphys_scene* scene, gphys_model_id robot, gphys_model_id hand) {
    const gphys_transform there = {{3, 0, 0}, {0, 0, 0, 1}, 1};
    gphys_transform local, world;
    MUST(gphys_scene_set_transform(scene, robot, &there));
    MUST(gphys_scene_get_transforms(scene, &hand, 1, &local, sizeof local));
    MUST(gphys_scene_get_world_transforms(scene, &hand, 1, &world, sizeof world));
    EXPECT(local.position.x == 1 && local.position.y == 0);
    /* The arm is 2 m above the robot's feet. */
    EXPECT(world.position.x == 4 && world.position.y == 2);
}

/* The tree of models from its roots on, as an editor shows it: a robot and a cup; the
 * robot has an arm. */
static void tree(const gphys_scene* scene, gphys_model_id robot, gphys_model_id arm) {
    gphys_model_id roots[8], children[8];
    uint32_t root_count, child_count;
    MUST(gphys_scene_get_roots(scene, roots, 8, &root_count));
    EXPECT(root_count == 2 && roots[0] == robot);
    MUST(gphys_scene_get_children(scene, roots[0], children, 8, &child_count));
    EXPECT(child_count == 1 && children[0] == arm);
}

/* The hand takes a cup: 1 keeps the cup where it is in the world. Then it puts it down,
 * below no parent. */
static void grasp(gphys_scene* scene, gphys_model_id hand, gphys_model_id cup) {
    gphys_transform before, held;
    MUST(gphys_scene_get_world_transforms(scene, &cup, 1, &before, sizeof before));
    MUST(gphys_scene_set_parent(scene, cup, hand, 1));
    MUST(gphys_scene_get_world_transforms(scene, &cup, 1, &held, sizeof held));
    EXPECT(held.position.x == before.position.x &&
           held.position.y == before.position.y);
    /* The hand cannot hang below the cup that it holds. */
    EXPECT(gphys_scene_set_parent(scene, hand, cup, 1) == GPHYS_ERROR_CYCLE);
    MUST(gphys_scene_set_parent(scene, cup, 0, 1));
}

/* The robot leaves with all its parts. gphys_scene_remove would leave the arm behind.
 */
static void leave(gphys_scene* scene, gphys_model_id robot, gphys_model_id hand) {
    MUST(gphys_scene_remove_subtree(scene, robot));
    EXPECT(gphys_scene_has(scene, robot) == GPHYS_ERROR_INVALID_ID);
    EXPECT(gphys_scene_has(scene, hand) == GPHYS_ERROR_INVALID_ID);
}

int main(void) {
    gphys_scene* scene = NULL;
    MUST(gphys_scene_create(NULL, &scene));
    const gphys_model_id robot = part(scene, 0, 0, 0), arm = part(scene, robot, 0, 2),
                         hand = part(scene, arm, 1, 0);
    const gphys_model_id cup = part(scene, 0, 4.5f, 2);
    follow(scene, robot, hand);
    tree(scene, robot, arm);
    grasp(scene, hand, cup);
    leave(scene, robot, hand);
    gphys_scene_destroy(scene);
    return 0;
}

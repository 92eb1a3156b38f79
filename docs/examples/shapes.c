/* Questions about single shapes, without a scene. */
#include <math.h>
#include <string.h>

#include "check.h"

/* Numbers of a file or of an editor are checked before they are used. */
static void validate(void) {
    const gphys_aabb box = {{0, 0, 0}, {2, 1, 3}}, inside_out = {{2, 0, 0}, {0, 1, 3}};
    MUST(gphys_shape_validate(GPHYS_SHAPE_AABB, &box));
    EXPECT(gphys_shape_validate(GPHYS_SHAPE_AABB, &inside_out) ==
           GPHYS_ERROR_INVALID_ARGUMENT);
    /* The sentence names the field. */
    EXPECT(strstr(gphys_last_error(), "min") != NULL);
}

/* The box around an upright capsule: a person 1.75 m tall and half a metre wide. A
 * plane has no such box. */
static void bounds(void) {
    const gphys_capsule person = {{5, 0.25f, 0}, {5, 1.5f, 0}, 0.25f};
    const gphys_plane ground = {{0, 1, 0}, 0};
    gphys_aabb box;
    MUST(gphys_shape_bounds(GPHYS_SHAPE_CAPSULE, &person, &box));
    EXPECT(box.min.x == 4.75f && box.min.y == 0 && box.max.x == 5.25f &&
           box.max.y == 1.75f);
    EXPECT(gphys_shape_bounds(GPHYS_SHAPE_PLANE, &ground, &box) == GPHYS_UNBOUNDED);
}

/* A box of a model file, doubled in size and placed 10 m along x. As it may be turned
 * it becomes an OBB. */
static void transform(void) {
    const gphys_aabb box = {{-1, 0, -1}, {1, 1, 1}};
    const gphys_transform place = {{10, 0, 0}, {0, 0, 0, 1}, 2};
    gphys_obb placed;
    MUST(gphys_shape_transform(GPHYS_SHAPE_AABB, &box, &place, &placed));
    EXPECT(placed.center.x == 10 && placed.center.y == 1 && placed.center.z == 0);
    EXPECT(placed.half_extents.x == 2 && placed.half_extents.y == 1 &&
           placed.half_extents.z == 2);
}

/* Has the player reached the checkpoint, a box of 2 m? A tolerance of half a metre is
 * more generous. */
static void contains(void) {
    const gphys_aabb checkpoint = {{-1, 0, -1}, {1, 2, 1}};
    const gphys_vec3 player = {1.25f, 1, 0};
    int32_t reached;
    MUST(gphys_shape_contains(GPHYS_SHAPE_AABB, &checkpoint, &player, 0, &reached));
    EXPECT(reached == 0);
    MUST(gphys_shape_contains(GPHYS_SHAPE_AABB, &checkpoint, &player, 0.5f, &reached));
    EXPECT(reached == 1);
}

/* Which of four lamps are in the fog, a ball with a radius of 10 m? The third is at its
 * edge, which belongs to it. */
static void contains_batch(void) {
    const gphys_sphere fog = {{0, 0, 0}, 10};
    const gphys_vec3 lamps[4] = {{0, 5, 0}, {8, 8, 0}, {10, 0, 0}, {0, 0, -30}};
    int32_t inside[4];
    MUST(gphys_shape_contains_batch(GPHYS_SHAPE_SPHERE, &fog, lamps, sizeof lamps[0], 4,
                                    0, inside, sizeof inside[0]));
    EXPECT(inside[0] == 1 && inside[1] == 0 && inside[2] == 1 && inside[3] == 0);
}

/* The place on a cable from which a lamp at (3, 4, 0) hangs with the shortest cord. */
static void closest_point(void) {
    const gphys_segment cable = {{0, 6, 0}, {10, 6, 0}};
    const gphys_vec3 lamp = {3, 4, 0};
    gphys_nearest nearest;
    MUST(gphys_shape_closest_point(GPHYS_SHAPE_SEGMENT, &cable, &lamp, &nearest));
    EXPECT(nearest.point.x == 3 && nearest.point.y == 6 && nearest.point.z == 0);
    EXPECT(nearest.distance == 2);
}

/* How far three drones are from a building. The last is inside: its distance is 0. */
static void closest_point_batch(void) {
    const gphys_aabb building = {{0, 0, 0}, {20, 30, 20}};
    const gphys_vec3 drones[3] = {{-5, 10, 10}, {10, 34, 10}, {10, 10, 10}};
    gphys_nearest nearest[3];
    MUST(gphys_shape_closest_point_batch(GPHYS_SHAPE_AABB, &building, drones,
                                         sizeof drones[0], 3, nearest,
                                         sizeof nearest[0]));
    EXPECT(nearest[0].distance == 5 && nearest[1].distance == 4 &&
           nearest[2].distance == 0);
    EXPECT(nearest[1].point.y == 30); /* on the roof */
}

/* Two pipes that cross, one 2 m above the other: where a strut between them is
 * shortest. */
static void segments(void) {
    const gphys_segment low = {{-5, 0, 0}, {5, 0, 0}}, high = {{1, 2, -5}, {1, 2, 5}};
    gphys_vec3 on_low, on_high;
    float distance;
    MUST(gphys_segment_closest_points(&low, &high, &on_low, &on_high, &distance));
    EXPECT(on_low.x == 1 && on_low.y == 0 && on_low.z == 0);
    EXPECT(on_high.x == 1 && on_high.y == 2 && on_high.z == 0);
    EXPECT(distance == 2);
}

/* Is somebody in the light of a lamp? A sphere that just touches counts. */
static void overlaps(void) {
    const gphys_sphere light = {{0, 3, 0}, 3};
    const gphys_capsule person = {{3.25f, 0.25f, 0}, {3.25f, 3, 0}, 0.25f};
    int32_t lit;
    MUST(gphys_shape_overlaps(GPHYS_SHAPE_SPHERE, &light, GPHYS_SHAPE_CAPSULE, &person,
                              &lit));
    EXPECT(lit == 1);
}

/* One blast against three crates: a stride of 0 takes the same sphere for all pairs. */
static void overlaps_batch(void) {
    const gphys_sphere blast = {{0, 0, 0}, 4};
    const gphys_aabb crates[3] = {
        {{3, 0, 0}, {4, 1, 1}}, {{5, 0, 0}, {6, 1, 1}}, {{-1, 0, -1}, {0, 1, 0}}};
    int32_t hit[3];
    MUST(gphys_shape_overlaps_batch(GPHYS_SHAPE_SPHERE, &blast, 0, GPHYS_SHAPE_AABB,
                                    crates, sizeof crates[0], 3, hit, sizeof hit[0]));
    EXPECT(hit[0] == 1 && hit[1] == 0 && hit[2] == 1);
}

/* A ball and the surface of a lake at y = 0: above it by 1 m, then floating in it. */
static void classify_plane(void) {
    const gphys_plane lake = {{0, 1, 0}, 0};
    const gphys_sphere flying = {{0, 2, 0}, 1}, floating = {{0, 0.5f, 0}, 1};
    gphys_side side;
    float distance;
    MUST(gphys_shape_classify_plane(GPHYS_SHAPE_SPHERE, &flying, &lake, &side,
                                    &distance));
    EXPECT(side == GPHYS_SIDE_INSIDE && distance == 1);
    MUST(gphys_shape_classify_plane(GPHYS_SHAPE_SPHERE, &floating, &lake, &side,
                                    &distance));
    EXPECT(side == GPHYS_SIDE_CROSSING && distance == 0);
}

/* What lies wholly inside the view needs no clipping. The view here: 90 degrees upward
 * and sideways, 1 m to 100 m. */
static void classify_frustum(void) {
    const gphys_frustum view = {{0, 0, 0},
                                {{{0, 0, 1}, 1},
                                 {{0, 0, -1}, -100},
                                 {{1, 0, 1}, 0},
                                 {{-1, 0, 1}, 0},
                                 {{0, 1, 1}, 0},
                                 {{0, -1, 1}, 0}}};
    const gphys_sphere ahead = {{0, 0, 10}, 1}, behind = {{0, 0, -10}, 1};
    gphys_side side;
    MUST(gphys_shape_classify_frustum(GPHYS_SHAPE_SPHERE, &ahead, &view, &side));
    EXPECT(side == GPHYS_SIDE_INSIDE);
    MUST(gphys_shape_classify_frustum(GPHYS_SHAPE_SPHERE, &behind, &view, &side));
    EXPECT(side == GPHYS_SIDE_OUTSIDE);
}

/* A ray along z at a ball 10 m away. t is in lengths of the direction, which are metres
 * here. */
static void raycast(void) {
    const gphys_sphere ball = {{0, 0, 10}, 1};
    const gphys_ray ray = {{0, 0, 0}, {0, 0, 1}, 100};
    gphys_hit hit;
    MUST(gphys_shape_raycast(GPHYS_SHAPE_SPHERE, &ball, &ray, &hit));
    EXPECT(hit.t == 9 && hit.point.z == 9 && hit.normal.z == -1);
}

/* Three drops of rain over a roof. The last falls beside it: its t is INFINITY. */
static void raycast_batch(void) {
    const gphys_aabb roof = {{0, 4, 0}, {10, 5, 6}};
    const gphys_ray rain[3] = {{{1, 20, 1}, {0, -1, 0}, INFINITY},
                               {{9, 30, 5}, {0, -1, 0}, INFINITY},
                               {{11, 20, 1}, {0, -1, 0}, INFINITY}};
    gphys_hit hits[3];
    MUST(gphys_shape_raycast_batch(GPHYS_SHAPE_AABB, &roof, rain, sizeof rain[0], 3,
                                   hits, sizeof hits[0]));
    EXPECT(hits[0].t == 15 && hits[1].t == 25 && hits[2].t == INFINITY);
}

/* A laser beam from one end of a corridor to the other, and somebody in it. t is the
 * share of the way. */
static void segment_test(void) {
    const gphys_capsule person = {{0, 0.25f, 5}, {0, 1.5f, 5}, 0.25f};
    const gphys_segment beam = {{0, 1, 0}, {0, 1, 19}};
    gphys_hit hit;
    MUST(gphys_shape_segment_test(GPHYS_SHAPE_CAPSULE, &person, &beam, &hit));
    EXPECT(hit.t == 0.25f && hit.point.z == 4.75f);
}

/* A ball with a radius of half a metre falls 10 m onto a table 1 m high. It comes 3.5 m
 * far. */
static void sweep_sphere(void) {
    const gphys_aabb table = {{-1, 0, -1}, {1, 1, 1}};
    const gphys_sphere ball = {{0, 5, 0}, 0.5f};
    const gphys_vec3 fall = {0, -10, 0};
    gphys_hit hit;
    MUST(gphys_shape_sweep_sphere(GPHYS_SHAPE_AABB, &table, &ball, &fall, &hit));
    EXPECT(hit.t == 0.35f && hit.point.y == 1 && hit.normal.y == 1);
}

/* A crate is pushed 8 m along x and meets a post after 4.5 m. */
static void sweep(void) {
    const gphys_capsule post = {{5.25f, 0, 0}, {5.25f, 3, 0}, 0.25f};
    const gphys_aabb crate = {{-0.5f, 0, -0.5f}, {0.5f, 1, 0.5f}};
    const gphys_vec3 push = {8, 0, 0};
    gphys_hit hit;
    MUST(gphys_shape_sweep(GPHYS_SHAPE_CAPSULE, &post, GPHYS_SHAPE_AABB, &crate, &push,
                           &hit));
    EXPECT(hit.t == 4.5f / 8 && hit.point.x == 5 && hit.normal.x == -1);
}

/* Two characters walk 4 m towards one wall: the first gets there, the second is too far
 * from it. */
static void sweep_batch(void) {
    const gphys_aabb wall = {{3, 0, -10}, {4, 3, 10}};
    const gphys_capsule walkers[2] = {{{0, 0.5f, 0}, {0, 1.5f, 0}, 0.5f},
                                      {{-9, 0.5f, 4}, {-9, 1.5f, 4}, 0.5f}};
    const gphys_vec3 way = {4, 0, 0};
    gphys_hit hits[2];
    MUST(gphys_shape_sweep_batch(GPHYS_SHAPE_AABB, &wall, 0, GPHYS_SHAPE_CAPSULE,
                                 walkers, sizeof walkers[0], &way, 0, 2, hits,
                                 sizeof hits[0]));
    EXPECT(hits[0].t == 2.5f / 4 && hits[1].t == INFINITY);
}

/* A ball that has sunk 0.25 m into the floor: the way out is 0.25 m upward. */
static void penetration(void) {
    const gphys_aabb ground = {{-10, -1, -10}, {10, 0, 10}};
    const gphys_sphere ball = {{0, 0.25f, 0}, 0.5f};
    gphys_penetration out;
    MUST(gphys_shape_penetration(GPHYS_SHAPE_AABB, &ground, GPHYS_SHAPE_SPHERE, &ball,
                                 &out));
    EXPECT(out.depth == 0.25f && out.normal.y == 1);
    const gphys_vec3 free = {0, ball.center.y + out.depth * out.normal.y, 0};
    EXPECT(free.y == 0.5f); /* there it rests on the floor */
}

/* Three balls and a box; the last is free of it, which a depth of -INFINITY says. */
static void penetration_batch(void) {
    const gphys_aabb box = {{0, 0, 0}, {4, 4, 4}};
    const gphys_sphere balls[3] = {
        {{-0.5f, 2, 2}, 1}, {{2, 3.75f, 2}, 1}, {{9, 2, 2}, 1}};
    gphys_penetration out[3];
    MUST(gphys_shape_penetration_batch(GPHYS_SHAPE_AABB, &box, 0, GPHYS_SHAPE_SPHERE,
                                       balls, sizeof balls[0], 3, out, sizeof out[0]));
    EXPECT(out[0].depth == 0.5f && out[0].normal.x == -1);
    EXPECT(out[1].depth == 1.25f && out[1].normal.y == 1);
    EXPECT(out[2].depth == -INFINITY);
}

/* The corners of a view, to draw it: the near rectangle first, from left-bottom on,
 * then the far one. */
static void corners(void) {
    const gphys_frustum view = {{0, 0, 0},
                                {{{0, 0, 1}, 1},
                                 {{0, 0, -1}, -9},
                                 {{1, 0, 1}, 0},
                                 {{-1, 0, 1}, 0},
                                 {{0, 1, 1}, 0},
                                 {{0, -1, 1}, 0}}};
    gphys_vec3 corners[8];
    MUST(gphys_frustum_corners(&view, corners));
    /* Near, left, bottom. */
    EXPECT(corners[0].x == -1 && corners[0].y == -1 && corners[0].z == 1);
    /* Far, right, top. */
    EXPECT(corners[6].x == 9 && corners[6].y == 9 && corners[6].z == 9);
}

/* Two walls and the floor meet in a corner of the room. */
static void planes_intersection(void) {
    const gphys_plane floor = {{0, 1, 0}, 0}, left = {{1, 0, 0}, -3},
                      back = {{0, 0, -1}, -5};
    gphys_vec3 corner;
    MUST(gphys_planes_intersection(&floor, &left, &back, &corner));
    EXPECT(corner.x == -3 && corner.y == 0 && corner.z == 5);
    /* The ground, once more the ground and a wall meet in a line, in no single point.
     */
    EXPECT(gphys_planes_intersection(&floor, &floor, &back, &corner) == GPHYS_NO_HIT);
}

/* The corners that three storeys make with two walls: the walls are the same, so their
 * stride is 0. */
static void planes_intersection_batch(void) {
    const gphys_plane storeys[3] = {{{0, 1, 0}, 0}, {{0, 1, 0}, 3}, {{0, 1, 0}, 6}};
    const gphys_plane left = {{1, 0, 0}, -4}, back = {{0, 0, 1}, 5};
    gphys_vec3 corners[3];
    MUST(gphys_planes_intersection_batch(storeys, sizeof storeys[0], &left, 0, &back, 0,
                                         3, corners, sizeof corners[0]));
    EXPECT(corners[0].y == 0 && corners[1].y == 3 && corners[2].y == 6);
    EXPECT(corners[2].x == -4 && corners[2].z == 5);
}

/* A rotation that was multiplied for hours: how far it has drifted, here by a hundredth
 * on one axis. */
static void orthonormality(void) {
    gphys_mat4 rotation = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    float deviation;
    MUST(gphys_mat4_orthonormality(&rotation, &deviation));
    EXPECT(deviation == 0);
    rotation.m[0] = 1.01f;
    MUST(gphys_mat4_orthonormality(&rotation, &deviation));
    EXPECT(fabsf(deviation - 0.0201f) < 1e-6f);
}

/* The frustum of a matrix that another library made: an orthographic view 4 m wide, 2 m
 * high, from z = 0 to 10. */
static void frustum_from_matrix(void) {
    const gphys_mat4 view_projection = {
        {0.5f, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.1f, 0, 0, 0, 0, 1}};
    gphys_frustum view;
    gphys_vec3 corners[8];
    MUST(gphys_frustum_from_matrix(&view_projection, GPHYS_DEPTH_ZERO_TO_ONE, 0,
                                   &view));
    MUST(gphys_frustum_corners(&view, corners));
    EXPECT(corners[0].x == -2 && corners[0].y == -1 && corners[0].z == 0);
    EXPECT(corners[6].x == 2 && corners[6].y == 1 && fabsf(corners[6].z - 10) < 1e-5f);
}

int main(void) {
    validate();
    bounds();
    transform();
    contains();
    contains_batch();
    closest_point();
    closest_point_batch();
    segments();
    overlaps();
    overlaps_batch();
    classify_plane();
    classify_frustum();
    raycast();
    raycast_batch();
    segment_test();
    sweep_sphere();
    sweep();
    sweep_batch();
    penetration();
    penetration_batch();
    corners();
    planes_intersection();
    planes_intersection_batch();
    orthonormality();
    frustum_from_matrix();
    return 0;
}

/* What is under the mouse, and what is to be drawn. The camera is at the origin and
 * looks along z in a window of 800 by 600 pixels. Two balls with a radius of 1 m are in
 * the middle of the image, one at z = 10, the other behind it at z = 20. */
#include <math.h>

#include "check.h"

/* A click in the middle of the window. t counts from where the ray begins, on the near
 * plane, 0.1 m ahead. */
static void pick(const gphys_camera* camera, const gphys_scene* scene,
                 gphys_model_id near_ball) {
    gphys_hit hit;
    MUST(gphys_camera_pick(camera, scene, 400, 300, GPHYS_ALL_LAYERS, &hit));
    EXPECT(hit.model == near_ball && fabsf(hit.t - 8.9f) < 1e-5f);
    EXPECT(gphys_camera_pick(camera, scene, 0, 0, GPHYS_ALL_LAYERS, &hit) ==
           GPHYS_NO_HIT);
}

/* Two fingers on the screen: one on the ball, one beside it. */
static void pick_batch(const gphys_camera* camera, const gphys_scene* scene,
                       gphys_model_id near_ball) {
    const float fingers[2][2] = {{400, 300}, {40, 30}};
    gphys_hit hits[2];
    MUST(gphys_camera_pick_batch(camera, scene, fingers[0], sizeof fingers[0], 2,
                                 GPHYS_ALL_LAYERS, hits, sizeof hits[0]));
    EXPECT(hits[0].model == near_ball && hits[1].model == 0);
}

/* A second click at the same place means what lies behind the ball that is selected. */
static void pick_behind(const gphys_camera* camera, const gphys_scene* scene,
                        gphys_model_id selected, gphys_model_id behind) {
    gphys_query_filter_desc filter;
    gphys_hit hit;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = selected;
    MUST(gphys_camera_pick_filtered(camera, scene, 400, 300, &filter, &hit));
    EXPECT(hit.model == behind);
}

/* What lies behind a ball that is selected, under two pixels of it: its middle, and one
 * near its edge, behind which there is nothing. */
static void pick_behind_batch(const gphys_camera* camera, const gphys_scene* scene,
                              gphys_model_id selected, gphys_model_id behind) {
    const float pixels[2][2] = {{400, 300}, {445, 300}};
    gphys_query_filter_desc filter;
    gphys_hit hits[2];
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = selected;
    MUST(gphys_camera_pick_filtered_batch(camera, scene, pixels[0], sizeof pixels[0], 2,
                                          &filter, 0, hits, sizeof hits[0]));
    EXPECT(hits[0].model == behind && hits[1].model == 0);
}

/* A marquee that is drawn with the mouse around the middle of the window. It holds both
 * balls. */
static void marquee(const gphys_camera* camera, const gphys_scene* scene,
                    gphys_model_id near_ball) {
    gphys_model_id models[8];
    uint32_t total;
    MUST(gphys_camera_pick_rectangle(camera, scene, 300, 200, 500, 400,
                                     GPHYS_ALL_LAYERS, models, 8, &total));
    EXPECT(total == 2 && models[0] == near_ball);
}

/* A marquee that adds to a selection: what is selected already is left out. */
static void marquee_more(const gphys_camera* camera, const gphys_scene* scene,
                         gphys_model_id selected, gphys_model_id behind) {
    gphys_query_filter_desc filter;
    gphys_model_id models[8];
    uint32_t total;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = selected;
    MUST(gphys_camera_pick_rectangle_filtered(camera, scene, 300, 200, 500, 400,
                                              &filter, models, 8, &total));
    EXPECT(total == 1 && models[0] == behind);
}

/* The models to draw in this frame. */
static void cull(const gphys_camera* camera, const gphys_scene* scene) {
    gphys_model_id models[8];
    uint32_t total;
    MUST(gphys_camera_cull(camera, scene, GPHYS_ALL_LAYERS, models, 8, &total));
    EXPECT(total == 2);
}

/* The models to draw besides one that is drawn in a way of its own, such as with an
 * outline. */
static void cull_others(const gphys_camera* camera, const gphys_scene* scene,
                        gphys_model_id selected, gphys_model_id behind) {
    gphys_query_filter_desc filter;
    gphys_model_id models[8];
    uint32_t total;
    MUST(gphys_query_filter_desc_init(&filter, sizeof filter));
    filter.ignored_model = selected;
    MUST(gphys_camera_cull_filtered(camera, scene, &filter, models, 8, &total));
    EXPECT(total == 1 && models[0] == behind);
}

/* The ray under the mouse, for a query of your own: where it meets the ground is where
 * a tower is built. */
static void pick_ray(const gphys_camera* camera) {
    const gphys_plane ground = {{0, 1, 0}, -2}; /* 2 m below the camera */
    gphys_ray ray;
    gphys_hit hit;
    MUST(gphys_camera_pick_ray(camera, 400, 450, &ray));
    MUST(gphys_shape_raycast(GPHYS_SHAPE_PLANE, &ground, &ray, &hit));
    EXPECT(fabsf(hit.point.y + 2) < 1e-5f && fabsf(hit.point.x) < 1e-5f &&
           hit.point.z > 0);
}

/* Rays of a part of an image, 16 by 16 pixels about its middle, for a batch: 256 of
 * them, row by row. */
static void pick_rays(const gphys_camera* camera, const gphys_scene* scene) {
    static gphys_ray rays[256];
    static gphys_hit hits[256];
    uint32_t hit_count = 0;
    MUST(gphys_camera_pick_rays(camera, 392, 292, 16, 16, rays, sizeof rays[0]));
    MUST(gphys_scene_raycast_batch(scene, rays, sizeof rays[0], 256, GPHYS_ALL_LAYERS,
                                   hits, sizeof hits[0]));
    for (int i = 0; i < 256; ++i) hit_count += hits[i].model != 0;
    EXPECT(hit_count == 256); /* the ball fills them */
}

/* A shot from the camera's own position, so that what is nearer than the near plane is
 * hit, too. */
static void pick_start(gphys_camera* camera) {
    gphys_pick_start start;
    gphys_ray ray;
    MUST(gphys_camera_set_pick_start(camera, GPHYS_PICK_FROM_CENTRE));
    MUST(gphys_camera_get_pick_start(camera, &start));
    MUST(gphys_camera_pick_ray(camera, 400, 300, &ray));
    EXPECT(start == GPHYS_PICK_FROM_CENTRE && ray.origin.z == 0);
}

int main(void) {
    const gphys_sphere balls[2] = {{{0, 0, 10}, 1}, {{0, 0, 20}, 1}};
    gphys_scene* scene = NULL;
    gphys_camera* camera = NULL;
    gphys_model_id near_ball, far_ball;
    MUST(gphys_scene_create(NULL, &scene));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &balls[0], NULL, NULL, &near_ball));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &balls[1], NULL, NULL, &far_ball));
    MUST(gphys_camera_create(NULL, &camera));
    pick(camera, scene, near_ball);
    pick_batch(camera, scene, near_ball);
    pick_behind(camera, scene, near_ball, far_ball);
    pick_behind_batch(camera, scene, near_ball, far_ball);
    marquee(camera, scene, near_ball);
    marquee_more(camera, scene, near_ball, far_ball);
    cull(camera, scene);
    cull_others(camera, scene, near_ball, far_ball);
    pick_ray(camera);
    pick_rays(camera, scene);
    pick_start(camera);
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
    return 0;
}

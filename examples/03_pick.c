/* Seeing a scene through a camera: which models are in view, what is under the mouse, what is in a
 * rectangle dragged with it, and the way there and back between the world and the screen. Prints
 * the scene as characters, one ray each. */
#include <math.h>

#include "check.h"

enum { WIDTH = 64, HEIGHT = 16 };

int main(void) {
    /* Three balls in a row, nine metres from the origin, and one behind the camera. */
    gphys_scene* scene = NULL;
    gphys_model_id balls[4];
    const gphys_sphere shapes[4] = {{{-4, 0, 9}, 1.5f}, {{0, 0, 9}, 1.5f}, {{4, 0, 9}, 1.5f}, {{0, 0, -50}, 2}};
    MUST(gphys_scene_create(NULL, &scene));
    MUST(gphys_scene_add_batch(scene, GPHYS_SHAPE_SPHERE, shapes, sizeof shapes[0], NULL, 0, 4, NULL, balls));

    /* A camera that circles the middle ball: left-handed, depth 0..1, like DirectX. */
    gphys_camera* camera = NULL;
    gphys_camera_desc desc;
    MUST(gphys_camera_desc_init(&desc, sizeof desc));
    desc.viewport_width = WIDTH * 10;
    desc.viewport_height = HEIGHT * 20;
    MUST(gphys_camera_create(&desc, &camera));
    MUST(gphys_camera_set_perspective(camera, 0.7f, 0.1f, 100));
    gphys_orbit orbit;
    MUST(gphys_orbit_init(&orbit));
    orbit.target = (gphys_vec3){0, 0, 9};
    orbit.distance = 8;
    orbit.radians_per_unit = 0.01f; /* of mouse movement in pixels */
    MUST(gphys_camera_set_orbit(camera, &orbit));

    /* Cull: only what is in view has to be drawn. */
    gphys_model_id seen[4];
    uint32_t total;
    MUST(gphys_camera_cull(camera, scene, GPHYS_ALL_LAYERS, seen, 4, &total));
    printf("%u of 4 models are in view\n", (unsigned)total);
    EXPECT(total == 3);

    /* A ray for each character cell, all in one batch, then the answers as a picture. */
    static gphys_hit hits[WIDTH * HEIGHT];
    static float pixels[WIDTH * HEIGHT][2];
    int shown[4] = {0};
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        pixels[i][0] = 10 * ((float)(i % WIDTH) + 0.5f);
        pixels[i][1] = 20 * ((float)(i / WIDTH) + 0.5f);
    }
    MUST(gphys_camera_pick_batch(camera, scene, pixels[0], sizeof pixels[0], WIDTH * HEIGHT, GPHYS_ALL_LAYERS, hits,
                                 sizeof hits[0]));
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        char c = ' ';
        for (int ball = 0; ball < 4; ++ball) {
            if (hits[i].model != balls[ball]) continue;
            /* Darker where the surface turns away from a lamp at the upper left. */
            const gphys_vec3 n = hits[i].normal;
            const float light = -0.5f * n.x + 0.6f * n.y - 0.6f * n.z;
            c = "@%#*+=-:."[light <= 0 ? 8 : 8 - (int)(8 * fminf(light, 1))];
            ++shown[ball];
        }
        putchar(c);
        if (i % WIDTH == WIDTH - 1) putchar('\n');
    }
    EXPECT(shown[0] > 50 && shown[0] == shown[2] && shown[1] > 50 && shown[3] == 0);

    /* Project the left ball's centre to the screen and pick what is there. */
    gphys_vec3 pixel, back;
    gphys_hit hit;
    MUST(gphys_camera_project(camera, &shapes[0].center, &pixel));
    MUST(gphys_camera_pick(camera, scene, pixel.x, pixel.y, GPHYS_ALL_LAYERS, &hit));
    printf("pixel (%.1f, %.1f) shows the %s\n", pixel.x, pixel.y, hit.model == balls[0] ? "left ball" : "wrong ball");
    EXPECT(hit.model == balls[0]);
    MUST(gphys_camera_unproject(camera, &pixel, &back));
    EXPECT(fabsf(back.x + 4) < 1e-3f && fabsf(back.y) < 1e-3f && fabsf(back.z - 9) < 1e-3f);

    /* Marquee: a rectangle over the right half. */
    MUST(gphys_camera_pick_rectangle(camera, scene, 340, 0, 640, 320, GPHYS_ALL_LAYERS, seen, 4, &total));
    printf("the right half shows %u models\n", (unsigned)total);
    EXPECT(total == 2 && seen[0] == balls[1] && seen[1] == balls[2]);

    /* Drag the mouse by 157 pixels: a quarter turn. Now the balls stand one behind the other. */
    MUST(gphys_camera_orbit_rotate(camera, 157.0796f, 0));
    MUST(gphys_camera_orbit_update(camera));
    MUST(gphys_camera_pick(camera, scene, 320, 160, GPHYS_ALL_LAYERS, &hit));
    gphys_ray ray;
    gphys_hit behind[4];
    MUST(gphys_camera_pick_ray(camera, 320, 160, &ray));
    MUST(gphys_scene_raycast_all(scene, &ray, GPHYS_ALL_LAYERS, behind, 4, &total));
    printf("after a quarter turn %u balls lie on the ray of the middle pixel\n", (unsigned)total);
    EXPECT(total == 3 && behind[0].model == hit.model && behind[1].model == balls[1]);

    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
    return 0;
}

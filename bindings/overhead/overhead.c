/* C, which every other language is held against: overhead [milliseconds a case] */
#include <gamephys_c.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { RAYS = 1000 };
static gphys_scene* scene;
static gphys_camera* camera;
static gphys_model_id model;
static gphys_ray ray = {{0, 0, 0}, {0, 0, 1}, 100};
static gphys_ray rays[RAYS];
static gphys_hit hit, hits[RAYS];
static double origin[3];

static void scalar(void) { gphys_scene_has(scene, model); }
static void vec3(void) { gphys_camera_get_origin(camera, origin); }
static void raycast(void) { gphys_scene_raycast(scene, &ray, GPHYS_ALL_LAYERS, &hit); }
static void raycast_batch(void) {
    gphys_scene_raycast_batch(scene, rays, sizeof rays[0], RAYS, GPHYS_ALL_LAYERS, hits, sizeof hits[0]);
}

static double seconds(void) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Runs of about a millisecond; the fastest of all that fit into the budget. */
static void measure(const char* name, void (*call)(void), int items, double budget) {
    const double end = seconds() + budget;
    double best = 1e9;
    long calls = 1;
    do {
        const double start = seconds();
        for (long i = 0; i < calls; ++i) call();
        const double elapsed = seconds() - start;
        if (elapsed < 1e-3) {
            calls *= 2;
        } else if (elapsed / (double)calls < best) {
            best = elapsed / (double)calls;
        }
    } while (seconds() < end || best == 1e9);
    printf("c,%s,%.2f\n", name, 1e9 * best / items);
}

int main(int argc, char** argv) {
    const double budget = 1e-3 * (argc > 1 ? atof(argv[1]) : 200);
    const gphys_sphere ball = {{0, 0, 5}, 1};
    if (gphys_scene_create(NULL, &scene) || gphys_camera_create(NULL, &camera) ||
        gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &model)) {
        return 1;
    }
    for (int i = 0; i < RAYS; ++i) rays[i] = ray;
    raycast();
    raycast_batch();
    if (hit.t != 4 || hits[RAYS - 1].t != 4) return 1;
    measure("scalar", scalar, 1, budget);
    measure("vec3", vec3, 1, budget);
    measure("raycast", raycast, 1, budget);
    measure("raycast_batch", raycast_batch, RAYS, budget);
    gphys_camera_destroy(camera);
    gphys_scene_destroy(scene);
    return 0;
}

/* viewer MESH [options]: drops a cloth and ropes over a statue of the mesh among hundreds of
 * copies, culls and picks through a camera, and writes pictures cast ray by ray. */
#define _POSIX_C_SOURCE 200809L
#define _DARWIN_C_SOURCE /* _SC_NPROCESSORS_ONLN */

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "viewer.h"

typedef struct options {
    const char *mesh, *directory;
    uint32_t width, height, copies;
    float simulated;      /* seconds */
    float pick_x, pick_y; /* pixel; negative: the middle of the lower left quarter */
} options;

void check(gphys_status status, const char* what) {
    if (status >= 0) return;
    fprintf(stderr, "%s: %s: %s\n", what, gphys_status_name(status), gphys_last_error());
    exit(1);
}

double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

uint32_t worker_count(void) {
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    return processors < 1 ? 1 : processors > MAX_WORKERS ? MAX_WORKERS : (uint32_t)processors;
}

void progress(const char* what, uint32_t done, uint32_t total) {
    enum { WIDTH = 40 };
    if (!isatty(STDERR_FILENO)) return;
    char bar[WIDTH + 1];
    const int filled = total ? (int)((uint64_t)done * WIDTH / total) : WIDTH;
    memset(bar, '.', WIDTH);
    memset(bar, '#', (size_t)filled);
    bar[WIDTH] = 0;
    fprintf(stderr, "\r%s [%s] %3u %%%s", what, bar, total ? (unsigned)((uint64_t)done * 100 / total) : 100,
            done >= total ? "\n" : "");
}

static options parse(int argc, char** argv) {
    static const struct option known[] = {
        {"out", required_argument, NULL, 'o'},    {"size", required_argument, NULL, 's'},
        {"copies", required_argument, NULL, 'n'}, {"seconds", required_argument, NULL, 't'},
        {"pick", required_argument, NULL, 'p'},   {NULL, 0, NULL, 0}};
    options o = {NULL, ".", 1280, 800, 420, 4, -1, -1};
    int letter, good = 1;
    while ((letter = getopt_long(argc, argv, "o:s:n:t:p:", known, NULL)) != -1) {
        switch (letter) {
            case 'o':
                o.directory = optarg;
                break;
            case 's':
                good &= sscanf(optarg, "%ux%u", &o.width, &o.height) == 2;
                break;
            case 'n':
                good &= sscanf(optarg, "%u", &o.copies) == 1;
                break;
            case 't':
                good &= sscanf(optarg, "%f", &o.simulated) == 1;
                break;
            case 'p':
                good &= sscanf(optarg, "%f,%f", &o.pick_x, &o.pick_y) == 2;
                break;
            default:
                good = 0;
        }
    }
    good &= optind + 1 == argc && o.width >= 16 && o.width <= 8192 && o.height >= 16 && o.height <= 8192;
    if (!good) {
        fprintf(stderr, "usage: viewer MESH [--out DIR] [--size WxH] [--copies N] [--seconds S] [--pick X,Y]\n");
        exit(2);
    }
    struct stat found;
    if (stat(o.directory, &found) != 0 || !S_ISDIR(found.st_mode) || access(o.directory, W_OK) != 0) {
        fprintf(stderr, "viewer: --out %s: no folder that can be written to\n", o.directory);
        exit(2);
    }
    o.mesh = argv[optind];
    if (o.pick_x < 0) o.pick_x = 0.30f * (float)o.width, o.pick_y = 0.80f * (float)o.height;
    return o;
}

static void place_camera(gphys_camera* camera, gphys_vec3 target, float distance, float yaw, float pitch) {
    gphys_orbit orbit;
    check(gphys_orbit_init(&orbit), "orbit");
    orbit.target = target;
    orbit.distance = distance;
    orbit.yaw = yaw;
    orbit.pitch = pitch;
    check(gphys_camera_set_orbit(camera, &orbit), "orbit");
}

static uint32_t count_visible(const gphys_camera* camera, const world* w) {
    uint32_t visible = 0;
    check(gphys_camera_cull(camera, w->scene, GPHYS_ALL_LAYERS, NULL, 0, &visible), "cull");
    return visible;
}

static void simulate(world* w, gphys_camera* camera, float duration) {
    const uint32_t frames = (uint32_t)(duration * 60);
    double stepping = 0, culling = 0;
    uint32_t visible = 0;
    float peak = 0;
    for (uint32_t i = 0; i < frames; ++i) {
        const double start = seconds();
        world_step(w, 1.0f / 60);
        const double stepped = seconds();
        visible = count_visible(camera, w);
        culling += seconds() - stepped;
        stepping += stepped - start;
        gphys_solver_stats stats;
        check(gphys_solver_get_stats(w->solver, 0, &stats), "stats");
        peak = fmaxf(peak, stats.strain_max);
        progress("simulating", i + 1, frames);
    }
    gphys_solver_stats stats, cloth;
    check(gphys_solver_get_stats(w->solver, 0, &stats), "stats");
    check(gphys_solver_get_stats(w->solver, w->cloth_body, &cloth), "stats");
    printf("simulated   %u frames: %.2f ms per step of %u particles, %u constraints, %u contacts; threads: %u\n",
           frames, 1e3 * stepping / frames, stats.particle_count, stats.constraint_count, stats.contact_count,
           worker_count());
    printf("strain      cloth max %.3f %%, rms %.4f %%; with the ropes max %.3f %%, peak over the run %.3f %%\n",
           100 * cloth.strain_max, 100 * cloth.strain_rms, 100 * stats.strain_max, 100 * peak);
    printf("culling     %u of %u models visible, %.1f us\n", visible, w->model_count, 1e6 * culling / frames);
}

/* Take a picture with 2 by 2 samples a pixel: the camera sees a viewport of twice the size. */
static void photograph(const world* w, gphys_camera* camera, const options* o, const highlight* marks,
                       const char* name) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", o->directory, name);
    const float width = (float)o->width, height = (float)o->height;
    check(gphys_camera_set_viewport(camera, 2 * width, 2 * height), "viewport");
    const double start = seconds();
    const uint64_t rays = take_picture(w, camera, o->width, o->height, marks, path);
    const double took = seconds() - start;
    check(gphys_camera_set_viewport(camera, width, height), "viewport");
    printf("%-11s %.1f M rays in %.2f s, shading included: %.0f ns per ray\n", name, 1e-6 * (double)rays, took,
           1e9 * took / (double)rays);
}

/* What is under a pixel: its model, or 0 for nothing and the ground. */
static gphys_model_id pick(const world* w, const gphys_camera* camera, float pixel_x, float pixel_y) {
    static const char* const kinds[] = {"",          "the ground", "the statue", "copy",
                                        "the stone", "post",       "the cloth",  "rope"};
    gphys_hit hit;
    const gphys_status found = gphys_camera_pick(camera, w->scene, pixel_x, pixel_y, GPHYS_ALL_LAYERS, &hit);
    check(found, "pick");
    if (found != GPHYS_OK) {
        printf("picked      nothing at pixel (%.0f, %.0f)\n", pixel_x, pixel_y);
        return 0;
    }
    const uint32_t kind = TAG_KIND(hit.tag);
    printf("picked      %s", kinds[kind]);
    if (kind == KIND_COPY || kind == KIND_POST || kind == KIND_ROPE) printf(" %u", TAG_NUMBER(hit.tag));
    gphys_vec3 eye;
    gphys_quat turn;
    check(gphys_camera_get_transform(camera, &eye, &turn), "camera");
    const double x = (double)hit.point.x - eye.x, y = (double)hit.point.y - eye.y, z = (double)hit.point.z - eye.z;
    printf(" at pixel (%.0f, %.0f), %.3f m away", pixel_x, pixel_y, sqrt(x * x + y * y + z * z));
    if (kind == KIND_CLOTH || kind == KIND_ROPE) {
        const gphys_body_id body = kind == KIND_CLOTH ? w->cloth_body : w->ropes[TAG_NUMBER(hit.tag)];
        uint32_t particle;
        const uint32_t triangle = kind == KIND_CLOTH ? w->cloth_triangles[hit.triangle] : hit.triangle;
        check(gphys_solver_get_nearest_particle(w->solver, body, triangle, &hit.point, &particle), "particle");
        printf(", particle %u", particle);
    } else if (hit.triangle != GPHYS_NO_TRIANGLE) {
        printf(", triangle %u", hit.triangle);
    }
    printf("\n");
    return kind == KIND_GROUND ? 0 : hit.model;
}

/* Which copies are in a rectangle of the picture. */
static void select_rectangle(const world* w, const gphys_camera* camera, const options* o, gphys_model_id* selected,
                             uint32_t capacity, highlight* marks) {
    const float width = (float)o->width, height = (float)o->height;
    const float rectangle[4] = {0.60f * width, 0.60f * height, 0.90f * width, 0.92f * height};
    memcpy(marks->rectangle, rectangle, sizeof rectangle);
    uint32_t total = 0;
    const gphys_status listed = gphys_camera_pick_rectangle(camera, w->scene, rectangle[0], rectangle[1], rectangle[2],
                                                            rectangle[3], GPHYS_ALL_LAYERS, selected, capacity, &total);
    check(listed, "pick rectangle");
    marks->selected = selected;
    marks->selected_count = total < capacity ? total : capacity;
    printf("marquee     %u models in the rectangle\n", total);
}

int main(int argc, char** argv) {
    const options o = parse(argc, argv);
    world w;
    double start = seconds();
    world_create(&w, o.mesh, o.copies);
    printf("loaded      %s: %u vertices, %u triangles; %u models in %.0f ms\n", o.mesh, w.source.vertex_count,
           w.source.index_count / 3, w.model_count, 1e3 * (seconds() - start));

    gphys_camera* camera;
    gphys_camera_desc desc;
    check(gphys_camera_desc_init(&desc, sizeof desc), "camera desc");
    desc.viewport_width = (float)o.width;
    desc.viewport_height = (float)o.height;
    check(gphys_camera_create(&desc, &camera), "create camera");
    check(gphys_camera_set_perspective(camera, 0.7f, 0.05f, 200), "perspective");
    place_camera(camera, (gphys_vec3){0, 1.1f, 0}, 13, 0.5f, 0.42f);

    simulate(&w, camera, o.simulated);
    world_thicken(&w);

    const highlight none = {0};
    photograph(&w, camera, &o, &none, "scene.png");
    gphys_model_id* selected = calloc(w.model_count, sizeof *selected);
    place_camera(camera, (gphys_vec3){2.5f, 0.4f, -5.5f}, 8, 0.5f, 0.45f);
    highlight marks = {0};
    marks.picked = pick(&w, camera, o.pick_x, o.pick_y);
    select_rectangle(&w, camera, &o, selected, w.model_count, &marks);
    photograph(&w, camera, &o, &marks, "pick.png");
    place_camera(camera, (gphys_vec3){0, 1.45f, 0}, 6.2f, 0.5f, 0.3f);
    pick(&w, camera, 0.5f * (float)o.width, 0.5f * (float)o.height);
    photograph(&w, camera, &o, &none, "cloth.png");

    free(selected);
    gphys_camera_destroy(camera);
    world_destroy(&w);
    return 0;
}

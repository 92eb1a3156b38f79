#include "study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void check(gphys_status status) {
    if (status >= 0) return;
    fprintf(stderr, "cluster: %s: %s\n", gphys_status_name(status), gphys_last_error());
    exit(1);
}

/* Whole numbers below n, the same in each process and language. */
static uint32_t below(uint32_t* state, uint32_t n) {
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) % n;
}

void town_build(town* t) {
    uint32_t random = 1;
    const gphys_plane ground = {{0, 1, 0}, 0};
    gphys_scene* scene;
    gphys_model_id id;
    check(gphys_scene_create(NULL, &scene));
    check(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &ground, NULL, NULL, &id));
    for (int i = 0; i < BUILDINGS; ++i) { /* in metres, between -1000 and 1000 */
        const float x = (float)below(&random, 2000) - 1000, z = (float)below(&random, 2000) - 1000;
        const float w = (float)(4 + below(&random, 12)), h = (float)(3 + below(&random, 30)),
                    d = (float)(4 + below(&random, 12));
        const gphys_aabb building = {{x - w, 0, z - d}, {x + w, h, z + d}};
        check(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &building, NULL, NULL, &id));
    }
    const gphys_aabb vehicle = {{-1, 0.25f, -2}, {1, 1.75f, 2}};
    for (int i = 0; i < VEHICLES; ++i)
        check(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &vehicle, NULL, NULL, &t->vehicles[i]));

    check(gphys_scene_get_snapshot(scene, 1, NULL, 0, &t->word_count));
    t->words = malloc(t->word_count * sizeof *t->words);
    if (!t->words) exit(1);
    check(gphys_scene_get_snapshot(scene, 1, t->words, t->word_count, &t->word_count));
    gphys_scene_destroy(scene);
}

/* Vehicles drive straight, along z or x, each at its own speed, and begin again at the other end of the town. */
void traffic_at(uint32_t time, traffic* now) {
    for (uint32_t i = 0; i < VEHICLES; ++i) {
        const float along = (float)((i * 7919 + time * (4 + i % 23)) % 2000) - 1000;
        const float across = (float)(i * 104729 % 2000) - 1000;
        const gphys_quat ahead = {0, 0, 0, 1}, aside = {0, 0.70710678f, 0, 0.70710678f};
        now->places[i] =
            i % 2 ? (gphys_transform){{across, 0, along}, ahead, 1} : (gphys_transform){{along, 0, across}, aside, 1};
    }
}

void study_create(study* s, const town* t) {
    check(gphys_scene_create(NULL, &s->scene));
    check(gphys_scene_restore(s->scene, NULL, t->words, t->word_count));
    memcpy(s->vehicles, t->vehicles, sizeof s->vehicles);
}

/* side * side rays, 256 m long or more, around a sensor. Their directions go along a square, as no function is needed
 * that libraries compute differently. */
static void aim(const study* s, uint32_t pose, gphys_ray* rays) {
    uint32_t random = 77 + pose * 2654435761u;
    const gphys_vec3 at = {(float)below(&random, 1800) - 900, 2 + (float)below(&random, 64) / 8,
                           (float)below(&random, 1800) - 900};
    for (uint32_t i = 0; i < s->side * s->side; ++i) {
        const float turn = 8 * (float)(i % s->side) / (float)s->side; /* 0 .. 8 around the square of side 2 */
        const float down = -0.5f + 0.625f * (float)(i / s->side) / (float)s->side;
        const float x = turn < 2 ? turn - 1 : turn < 4 ? 1 : turn < 6 ? 5 - turn : -1;
        const float z = turn < 2 ? -1 : turn < 4 ? turn - 3 : turn < 6 ? 1 : 7 - turn;
        rays[i] = (gphys_ray){at, {256 * x, 256 * down, 256 * z}, 1};
    }
}

void study_do(study* s, uint32_t unit, const traffic* now, record* out) {
    const uint32_t count = s->side * s->side, time = unit / study_blocks(s), first = unit % study_blocks(s) * BLOCK;
    gphys_ray* rays = malloc(count * sizeof *rays);
    gphys_hit* hits = malloc(count * sizeof *hits);
    if (!rays || !hits) exit(1);
    check(gphys_scene_set_transforms(s->scene, s->vehicles, now->places, sizeof now->places[0], VEHICLES));
    for (uint32_t k = 0; k < unit_size(s, unit); ++k) {
        record* r = &out[k];
        *r = (record){1, time, first + k, 0, 0, 0, {0}};
        aim(s, first + k, rays);
        check(gphys_scene_raycast_batch(s->scene, rays, sizeof *rays, count, GPHYS_ALL_LAYERS, hits, sizeof *hits));
        for (uint32_t i = 0; i < count; ++i) {
            if (hits[i].model == 0) continue;
            uint32_t bits;
            memcpy(&bits, &hits[i].t, sizeof bits);
            const uint32_t bin = (uint32_t)(16 * hits[i].t);
            ++r->hits;
            r->range += (uint64_t)(1024 * hits[i].t);
            r->hash += ((uint64_t)hits[i].model << 32 | bits) * (2 * (uint64_t)i + 1);
            ++r->histogram[bin < 7 ? bin : 7];
        }
    }
    free(rays);
    free(hits);
}

void study_destroy(study* s) { gphys_scene_destroy(s->scene); }

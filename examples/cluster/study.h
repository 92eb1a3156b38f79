/* A lidar study: what sensors at many poses see of a town in which vehicles drive, at many times. It is cut into units,
 * each a time and a block of poses, which may be done in any order, by any process, and more than once. */
#ifndef STUDY_H
#define STUDY_H

#include <gamephys_c.h>
#include <stdint.h>

/* What a sensor sees at a time. All fields are exact sums, so that a record depends on nothing but its place. */
typedef struct record {
    uint32_t done; /* 1; a file that is being made has 0 where nothing is known yet */
    uint32_t time, pose, hits;
    uint64_t range;        /* sum of the hits' t in 1/1024 */
    uint64_t hash;         /* of every hit's model and bits of t */
    uint32_t histogram[8]; /* hits by t, 0.0625 each; the last holds the rest */
} record;

enum { BLOCK = 25, BUILDINGS = 4000, VEHICLES = 1000 };

/* The town as it is sent to other processes, once: a snapshot of the scene, and which of its models are vehicles. */
typedef struct town {
    uint32_t word_count;
    uint32_t* words;
    gphys_model_id vehicles[VEHICLES];
} town;

/* What changes from one time to another. */
typedef struct traffic {
    gphys_transform places[VEHICLES];
} traffic;

typedef struct study {
    uint32_t poses, times, side; /* side * side rays a pose */
    gphys_scene* scene;
    gphys_model_id vehicles[VEHICLES];
} study;

static inline uint32_t study_blocks(const study* s) { return (s->poses + BLOCK - 1) / BLOCK; }
static inline uint32_t study_units(const study* s) { return s->times * study_blocks(s); }
/* The first record of a unit in the file, and how many it has. */
static inline uint32_t unit_first(const study* s, uint32_t unit) {
    return unit / study_blocks(s) * s->poses + unit % study_blocks(s) * BLOCK;
}
static inline uint32_t unit_size(const study* s, uint32_t unit) {
    const uint32_t first = unit % study_blocks(s) * BLOCK;
    return s->poses - first < BLOCK ? s->poses - first : BLOCK;
}

/* These end the program with a message if they fail. */

/* Build the town, in one process. */
void town_build(town* t);
void traffic_at(uint32_t time, traffic* now);

/* The same scene as the one that the snapshot was taken of, with the same ids. */
void study_create(study* s, const town* t);
/* The records of a unit, with the traffic at its time. */
void study_do(study* s, uint32_t unit, const traffic* now, record* out);
void study_destroy(study* s);

#endif

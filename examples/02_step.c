/* Things that move: a rope that hangs from a post with a weight at its end, and a cloth that falls
 * over a ball. The motion is checked against physics: what hangs comes to rest below its nail with
 * the rope's full length, nothing stretches, nothing sinks in. */
#include <math.h>

#include "check.h"

enum { LINKS = 40, GRID = 31 };

static float distance(gphys_vec3 a, gphys_vec3 b) {
    return sqrtf((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

int main(void) {
    /* What can be collided with: the ground and a ball. */
    gphys_scene* scene = NULL;
    const gphys_plane ground = {{0, 1, 0}, 0};
    const gphys_sphere ball = {{0, 1, 0}, 1};
    gphys_model_id ground_id, ball_id;
    MUST(gphys_scene_create(NULL, &scene));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_PLANE, &ground, NULL, NULL, &ground_id));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, NULL, NULL, &ball_id));

    /* Each body takes the substeps that keep its strain below a hundredth. */
    gphys_solver* solver = NULL;
    gphys_solver_desc settings;
    MUST(gphys_solver_desc_init(&settings, sizeof settings));
    settings.max_strain = 0.01f;
    MUST(gphys_solver_create(&settings, &solver));
    gphys_body_desc desc;
    MUST(gphys_body_desc_init(&desc, sizeof desc));

    /* A rope two metres long, laid out sideways from its nail, with 5 kg at its free end. */
    gphys_vec3 rope[LINKS + 1];
    gphys_body_id rope_id;
    for (int i = 0; i <= LINKS; ++i) rope[i] = (gphys_vec3){5 + 0.05f * (float)i, 3, 0};
    desc.damping = 2;
    const float weight = 5;
    MUST(gphys_solver_add_rope(solver, &desc, rope, sizeof rope[0], LINKS + 1, 0, &rope_id));
    MUST(gphys_solver_set_pinned(solver, rope_id, 0, 1, 1));
    MUST(gphys_solver_set_masses(solver, rope_id, LINKS, 1, &weight, sizeof weight));

    /* A square of cloth, three metres wide, a metre above the ball. */
    const gphys_vec3 corner = {-1.5f, 3, -1.5f}, edge_u = {3, 0, 0}, edge_v = {0, 0, 3};
    gphys_body_id cloth_id;
    gphys_body_info info;
    desc.radius = 0.02f;
    desc.cloth_flags = GPHYS_CLOTH_BEND; /* woven: threads keep their length, the weave shears */
    MUST(gphys_solver_add_cloth(solver, &desc, &corner, &edge_u, &edge_v, GRID, GRID, &cloth_id));
    MUST(gphys_solver_get_body_info(solver, cloth_id, &info));
    printf("cloth: %u particles, %u constraints, %u triangles\n", (unsigned)info.particle_count,
           (unsigned)info.constraint_count, (unsigned)info.triangle_count);
    EXPECT(info.particle_count == GRID * GRID && info.triangle_count == 2 * (GRID - 1) * (GRID - 1));

    /* Six seconds in frames of uneven length, as a game has them. */
    gphys_solver_stats stats;
    uint32_t steps = 0, frame = 0;
    float strain = 0;
    for (float time = 0; time < 6; ++frame) {
        const float frame_time = frame % 3 ? 0.013f : 0.021f;
        uint32_t made;
        MUST(gphys_solver_advance(solver, scene, frame_time, &made, NULL));
        MUST(gphys_solver_get_stats(solver, 0, &stats));
        strain = fmaxf(strain, stats.strain_max);
        steps += made;
        time += frame_time;
        if (frame % 75 == 0) {
            printf("%5.2f s: %8.3f J moving, %4u contacts, strain %.4f %%\n", time, stats.kinetic_energy,
                   (unsigned)stats.contact_count, 100 * stats.strain_max);
        }
    }
    printf("%u frames, %u steps of 1/60 s, largest strain %.3f %%\n", (unsigned)frame, (unsigned)steps, 100 * strain);
    EXPECT(steps >= 359 && steps <= 361); /* 6 s; the last frame may end past them */
    EXPECT(strain < 0.05f);               /* when the cloth strikes the ball, before more substeps are taken */
    EXPECT(stats.strain_max < 0.01f);     /* and at rest */

    /* The weight hangs below the nail, by the rope's length. */
    MUST(gphys_solver_get_positions(solver, rope_id, 0, LINKS + 1, rope, sizeof rope[0]));
    printf("weight: %.3f m below the nail, %.3f m beside it\n", 3 - rope[LINKS].y, fabsf(rope[LINKS].x - 5));
    EXPECT(rope[0].x == 5 && rope[0].y == 3);
    EXPECT(distance(rope[0], rope[LINKS]) < 2.01f && rope[LINKS].y < 1.02f);

    /* The cloth lies on the ball and on the ground, and is in neither. */
    static gphys_vec3 cloth[GRID * GRID];
    float closest = INFINITY, lowest = INFINITY;
    const gphys_vec3 centre = {0, 1, 0};
    MUST(gphys_solver_get_positions(solver, cloth_id, 0, GRID * GRID, cloth, sizeof cloth[0]));
    for (int i = 0; i < GRID * GRID; ++i) {
        closest = fminf(closest, distance(cloth[i], centre));
        lowest = fminf(lowest, cloth[i].y);
    }
    printf("cloth: %.4f m above the ball, %.4f m above the ground\n", closest - 1, lowest);
    EXPECT(closest > 1.015f && closest < 1.03f); /* radius 0.02 of its particles, within a quarter */
    EXPECT(lowest > 0.015f);

    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);
    return 0;
}

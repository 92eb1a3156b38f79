/* Reading and writing the state of particles. The rope of these examples has five
 * particles and a mass of 1 kg. It reaches from x = 0 to 2 m in steps of half a metre,
 * at a height of 3 m. */
#include <math.h>

#include "check.h"

/* Where the particles are, into vertices of a program's own: a position at the start of
 * each. */
static void get_positions(const gphys_solver* solver, gphys_body_id rope) {
    struct {
        gphys_vec3 position;
        float colour[4];
    } vertices[5];
    MUST(gphys_solver_get_positions(solver, rope, 0, 5, &vertices[0].position,
                                    sizeof vertices[0]));
    EXPECT(vertices[4].position.x == 2 && vertices[4].position.y == 3);
}

/* The last particle is put to another place, without a motion there. */
static void set_positions(gphys_solver* solver, gphys_body_id rope) {
    const gphys_vec3 place = {1.5f, 3, 0.5f};
    gphys_vec3 now;
    MUST(gphys_solver_set_positions(solver, rope, 4, 1, &place, sizeof place));
    MUST(gphys_solver_get_positions(solver, rope, 4, 1, &now, sizeof now));
    EXPECT(now.x == 1.5f && now.z == 0.5f);
}

/* The whole rope is thrown at 6 m/s: a stride of 0 gives all particles the same. */
static void velocities(gphys_solver* solver, gphys_body_id rope) {
    const gphys_vec3 thrown = {0, 0, 6};
    gphys_vec3 now[5];
    MUST(gphys_solver_set_velocities(solver, rope, 0, 5, &thrown, 0));
    MUST(gphys_solver_get_velocities(solver, rope, 0, 5, now, sizeof now[0]));
    EXPECT(now[0].z == 6 && now[4].z == 6);
}

/* A weight of 20 kg at the end of a rope of 1 kg, whose particles have 0.2 kg each. */
static void masses(gphys_solver* solver, gphys_body_id rope) {
    const float weight = 20;
    float now[5];
    MUST(gphys_solver_set_masses(solver, rope, 4, 1, &weight, sizeof weight));
    MUST(gphys_solver_get_masses(solver, rope, 0, 5, now, sizeof now[0]));
    EXPECT(now[3] == 0.2f && now[4] == 20);
}

/* A knot at the end of the rope, which is thicker there than the centimetre of the
 * others. */
static void radii(gphys_solver* solver, gphys_body_id rope) {
    const float knot = 0.05f;
    float now[5];
    MUST(gphys_solver_set_radii(solver, rope, 4, 1, &knot, sizeof knot));
    MUST(gphys_solver_get_radii(solver, rope, 0, 5, now, sizeof now[0]));
    EXPECT(now[3] == 0.01f && now[4] == 0.05f);
}

/* The last half metre of the rope is wet: it has a fifth of the friction of the body.
 */
static void friction_factors(gphys_solver* solver, gphys_body_id rope) {
    const float wet = 0.2f;
    float now[5];
    MUST(gphys_solver_set_friction_factors(solver, rope, 3, 2, &wet, 0));
    MUST(gphys_solver_get_friction_factors(solver, rope, 0, 5, now, sizeof now[0]));
    EXPECT(now[2] == 1 && now[3] == 0.2f && now[4] == 0.2f);
}

/* Somebody pulls at the end with 50 N, from now on until it is set to 0. */
static void forces(gphys_solver* solver, gphys_body_id rope) {
    const gphys_vec3 pull = {50, 0, 0};
    gphys_vec3 now;
    MUST(gphys_solver_set_forces(solver, rope, 4, 1, &pull, sizeof pull));
    MUST(gphys_solver_get_forces(solver, rope, 4, 1, &now, sizeof now));
    EXPECT(now.x == 50);
}

/* The first particle is nailed to where it is. */
static void pinned(gphys_solver* solver, gphys_body_id rope) {
    int32_t now[5];
    MUST(gphys_solver_set_pinned(solver, rope, 0, 1, 1));
    MUST(gphys_solver_get_pinned(solver, rope, 0, 5, now, sizeof now[0]));
    EXPECT(now[0] == 1 && now[1] == 0);
}

int main(void) {
    const gphys_vec3 points[5] = {
        {0, 3, 0}, {0.5f, 3, 0}, {1, 3, 0}, {1.5f, 3, 0}, {2, 3, 0}};
    gphys_solver* solver = NULL;
    gphys_body_id rope;
    MUST(gphys_solver_create(NULL, &solver));
    MUST(gphys_solver_add_rope(solver, NULL, points, sizeof points[0], 5, 0, &rope));
    get_positions(solver, rope);
    set_positions(solver, rope);
    velocities(solver, rope);
    masses(solver, rope);
    radii(solver, rope);
    friction_factors(solver, rope);
    forces(solver, rope);
    pinned(solver, rope);
    gphys_solver_destroy(solver);
    return 0;
}

/* What holds particles together: distances, volumes, clusters and joints, and what
 * breaks. */
#include <math.h>

#include "check.h"

/* Three particles, 1 m from one to the next, get a rod and a spring: a rigid link, and
 * one that yields 1 mm for a newton. */
static void add_distance(gphys_solver* solver, gphys_body_id particles) {
    gphys_constraint_id rod, spring;
    gphys_constraint_info all[4];
    uint32_t total;
    /* -1: as far apart as they are. */
    MUST(gphys_solver_add_distance(solver, particles, 0, 1, -1, 0, &rod));
    MUST(gphys_solver_add_distance(solver, particles, 1, 2, -1, 0.001f, &spring));
    MUST(gphys_solver_get_constraints(solver, particles, all, 4, &total));
    EXPECT(total == 2 && all[0].id == rod && all[0].rest_length == 1 &&
           all[0].compliance == 0);
    EXPECT(all[1].id == spring && all[1].particle_a == 1 && all[1].particle_b == 2);
}

/* A dog on a lead of 3 m: nothing holds it while it is nearer. The two particles are 1
 * m apart. */
static void add_max_distance(gphys_solver* solver, gphys_body_id body) {
    gphys_constraint_id lead;
    gphys_constraint_kind kind;
    MUST(gphys_solver_add_max_distance(solver, body, 0, 1, 3, 0, &lead));
    MUST(gphys_solver_get_constraint_kinds(solver, body, &lead, 1, &kind, sizeof kind));
    EXPECT(kind == GPHYS_CONSTRAINT_MAX_DISTANCE);
}

/* A shock absorber: a spring of 1 mm for a newton that takes the speed of its ends, 40
 * N for each m/s. */
static void damping(gphys_solver* solver, gphys_body_id body) {
    gphys_constraint_id spring;
    gphys_constraint_settings settings;
    MUST(gphys_solver_add_distance(solver, body, 0, 1, -1, 0.001f, &spring));
    MUST(gphys_solver_set_constraint_damping(solver, body, spring, 40));
    MUST(gphys_solver_get_constraint_settings(solver, body, &spring, 1, &settings,
                                              sizeof settings));
    EXPECT(settings.damping == 40 && settings.compliance == 0.001f &&
           settings.rest_length == 1);
}

/* A winch reels in at 0.6 m/s: before each step of 1/60 s its link becomes 1 cm
 * shorter. It is 1 m long at first. */
static void winch(gphys_solver* solver, gphys_body_id rope, gphys_constraint_id link) {
    gphys_constraint_settings settings;
    for (int i = 0; i < 30; ++i) {
        MUST(gphys_solver_get_constraint_settings(solver, rope, &link, 1, &settings,
                                                  sizeof settings));
        settings.rest_length -= 0.6f / 60;
        MUST(gphys_solver_set_constraint_settings(solver, rope, &link, &settings,
                                                  sizeof settings, 1));
        MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
    }
    EXPECT(fabsf(settings.rest_length - 0.7f) < 1e-5f);
}

/* Somebody cuts a rope of three particles: one link of two is left. */
static void cut(gphys_solver* solver, gphys_body_id rope) {
    gphys_constraint_info links[2];
    uint32_t total;
    MUST(gphys_solver_get_constraints(solver, rope, links, 2, &total));
    MUST(gphys_solver_remove_constraint(solver, rope, links[0].id));
    MUST(gphys_solver_get_constraints(solver, rope, links, 2, &total));
    EXPECT(total == 1);
}

/* A closed cube of cloth with sides of 1 m, filled with air at its volume of 1 m^3. A
 * compliance of 7e-6 m^3/Pa is that of a cubic metre of air: its volume divided by 1.4
 * times its pressure of 101325 Pa. */
static void volume(gphys_solver* solver, gphys_body_id cube) {
    float volume, pressure, rest_volume, compliance;
    MUST(gphys_solver_set_volume(solver, cube, -1, 7e-6f)); /* -1: as it is now */
    MUST(gphys_solver_get_volume(solver, cube, &volume, &pressure));
    MUST(gphys_solver_get_volume_settings(solver, cube, &rest_volume, &compliance));
    EXPECT(fabsf(volume - 1) < 1e-5f && pressure == 0 &&
           fabsf(rest_volume - 1) < 1e-5f);
    /* A fifth more is pumped in. */
    MUST(gphys_solver_set_volume(solver, cube, 1.2f, 7e-6f));
    MUST(gphys_solver_get_volume_settings(solver, cube, &rest_volume, &compliance));
    EXPECT(rest_volume == 1.2f && compliance == 7e-6f);
}

/* Four free particles become a plank that keeps its shape, and are free again in the
 * end. */
static void clusters(gphys_solver* solver, gphys_body_id body) {
    const uint32_t plank[4] = {0, 1, 2, 3};
    gphys_cluster_id cluster, clusters[4];
    uint32_t particles[4], particle_count, cluster_count;
    MUST(gphys_solver_add_cluster(solver, body, plank, 4, &cluster));
    MUST(gphys_solver_get_clusters(solver, body, clusters, 4, &cluster_count));
    EXPECT(cluster_count == 1 && clusters[0] == cluster);
    MUST(gphys_solver_get_cluster_particles(solver, body, cluster, particles, 4,
                                            &particle_count));
    EXPECT(particle_count == 4 && particles[3] == 3);
    MUST(gphys_solver_remove_cluster(solver, body, cluster));
}

/* The ends of two ropes of three particles, 2 m apart, are tied together by a joint as
 * long as that, then untied. */
static void joints(gphys_solver* solver, gphys_body_id rope, gphys_body_id other) {
    gphys_joint_id knot;
    gphys_joint_info all[4];
    uint32_t total;
    /* -1: as far apart as they are. */
    MUST(gphys_solver_join(solver, rope, 2, other, 2, -1, 0, &knot));
    MUST(gphys_solver_get_joints(solver, rope, all, 4, &total));
    EXPECT(total == 1 && all[0].id == knot && all[0].body_b == other &&
           all[0].particle_b == 2);
    EXPECT(all[0].rest_length == 2);
    MUST(gphys_solver_unjoin(solver, knot));
}

/* A rope of 10 kg hangs from its first particle. Its first link, which carries more
 * than 50 N, breaks beyond that. */
static void breaking(gphys_solver* solver, gphys_body_id rope,
                     gphys_constraint_id link) {
    const float most = 50;
    float now;
    gphys_break breaks[4];
    uint32_t total = 0;
    MUST(gphys_solver_set_breaking_forces(solver, rope, &link, &most, sizeof most, 1));
    MUST(gphys_solver_get_breaking_forces(solver, rope, &link, 1, &now, sizeof now));
    EXPECT(now == 50);
    for (int i = 0; i < 60 && total == 0; ++i) {
        MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
        MUST(gphys_solver_get_breaks(solver, breaks, 4, &total));
    }
    EXPECT(total == 1 && breaks[0].constraint == link && breaks[0].load > 50);
}

/* Scissors cut cloth at one of its links. Where it parts, a particle becomes two. */
static void scissors(gphys_solver* solver, gphys_body_id cloth,
                     gphys_constraint_id link) {
    gphys_body_info before, after;
    gphys_break result;
    MUST(gphys_solver_get_body_info(solver, cloth, &before));
    MUST(gphys_solver_break_constraint(solver, cloth, link, &result));
    MUST(gphys_solver_get_body_info(solver, cloth, &after));
    EXPECT(result.constraint == link && result.load == 0); /* no load broke it */
    EXPECT(result.new_particle == before.particle_count &&
           after.particle_count == before.particle_count + 1);
}

static gphys_solver* create(void) {
    gphys_solver* solver = NULL;
    MUST(gphys_solver_create(NULL, &solver));
    return solver;
}

static gphys_body_id four_particles(gphys_solver* solver) {
    const gphys_vec3 places[4] = {{0, 2, 0}, {1, 2, 0}, {2, 2, 0}, {0, 2, 1}};
    gphys_body_id body;
    MUST(gphys_solver_add_particles(solver, NULL, places, sizeof places[0], 4, &body));
    return body;
}

static gphys_body_id hanging_rope(gphys_solver* solver, float x, float mass) {
    const gphys_vec3 points[3] = {{x, 5, 0}, {x, 4, 0}, {x, 3, 0}};
    gphys_body_desc desc;
    gphys_body_id rope;
    MUST(gphys_body_desc_init(&desc, sizeof desc));
    desc.mass = mass;
    MUST(gphys_solver_add_rope(solver, &desc, points, sizeof points[0], 3, 0, &rope));
    MUST(gphys_solver_set_pinned(solver, rope, 0, 1, 1));
    return rope;
}

static gphys_constraint_id first_link(const gphys_solver* solver, gphys_body_id body) {
    gphys_constraint_info link;
    uint32_t total;
    gphys_solver_get_constraints(solver, body, &link, 1, &total);
    return link.id;
}

static gphys_body_id cloth_cube(gphys_solver* solver) {
    static const float corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                        {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    gphys_mesh* hull = NULL; /* its triangles face outward */
    gphys_body_id cube;
    MUST(gphys_mesh_create_hull(NULL, corners[0], sizeof corners[0], 8, &hull));
    MUST(gphys_solver_add_cloth_mesh(solver, NULL, hull, NULL, &cube));
    gphys_mesh_destroy(hull);
    return cube;
}

int main(void) {
    const gphys_vec3 corner = {0, 2, 4}, along = {1, 0, 0}, down = {0, -1, 0};
    gphys_solver* solver = create();
    gphys_body_id cloth;
    add_distance(solver, four_particles(solver));
    add_max_distance(solver, four_particles(solver));
    damping(solver, four_particles(solver));
    clusters(solver, four_particles(solver));
    volume(solver, cloth_cube(solver));
    MUST(gphys_solver_add_cloth(solver, NULL, &corner, &along, &down, 5, 5, &cloth));
    scissors(solver, cloth, first_link(solver, cloth));
    gphys_solver_destroy(solver);

    solver = create();
    const gphys_body_id rope = hanging_rope(solver, 0, 1);
    winch(solver, rope, first_link(solver, rope));
    gphys_solver_destroy(solver);

    solver = create();
    const gphys_body_id left = hanging_rope(solver, 0, 10),
                        right = hanging_rope(solver, 2, 1);
    joints(solver, left, right);
    cut(solver, right);
    breaking(solver, left, first_link(solver, left));
    gphys_solver_destroy(solver);
    return 0;
}

/* What moves bodies from outside: wind, animation, models that carry them, and what
 * they do to models in turn. */
#include <math.h>

#include "check.h"

/* A breeze of 5 m/s along x for a flag of 5 by 5 particles, which hangs down: its free
 * corner is blown to that side within a second. */
static void wind(gphys_solver* solver, gphys_body_id flag) {
    const gphys_wind breeze = {{5, 0, 0}, 1.2f, 1.2f, 1.2f};
    gphys_wind now;
    gphys_vec3 corner;
    MUST(gphys_solver_set_wind(solver, flag, &breeze));
    MUST(gphys_solver_get_wind(solver, flag, &now));
    for (int i = 0; i < 60; ++i) MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
    MUST(gphys_solver_get_positions(solver, flag, 24, 1, &corner, sizeof corner));
    EXPECT(now.velocity.x == 5 && corner.x > 0.1f);
}

/* A gust of 10 m/s beside the wind, at the lowest row alone of a flag of 5 by 5
 * particles. */
static void air_velocities(gphys_solver* solver, gphys_body_id flag) {
    const gphys_vec3 gust = {10, 0, 0};
    gphys_vec3 now[25];
    MUST(gphys_solver_set_air_velocities(solver, flag, 20, 5, &gust, 0));
    MUST(gphys_solver_get_air_velocities(solver, flag, 0, 25, now, sizeof now[0]));
    EXPECT(now[19].x == 0 && now[20].x == 10 && now[24].x == 10);
}

/* A cape that is skinned to its wearer stays within 10 cm of the animated vertices and
 * does not go behind them. Here a vertex is 20 cm higher than the particle is, which so
 * rises by 10 cm at least. */
static void animation_targets(gphys_solver* solver, gphys_body_id cape) {
    const gphys_animation_target target = {{0, 2.2f, 0}, {1, 0, 0}, 0.1f, 0};
    gphys_animation_target now;
    gphys_vec3 place;
    MUST(gphys_solver_set_animation_targets(solver, cape, 0, 1, &target,
                                            sizeof target));
    MUST(gphys_solver_get_animation_targets(solver, cape, 0, 1, &now, sizeof now));
    MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
    MUST(gphys_solver_get_positions(solver, cape, 0, 1, &place, sizeof place));
    EXPECT(now.max_distance == 0.1f && place.y > 2.0999f);
}

/* A rope hangs 10 cm below a crane's hook, which moves 1 m along x in a second: the
 * first particle goes with it. */
static void attach(gphys_solver* solver, gphys_scene* scene, gphys_body_id rope,
                   gphys_model_id hook) {
    gphys_transform place = {{0, 5.1f, 0}, {0, 0, 0, 1}, 1};
    gphys_attachment attachments[4];
    gphys_vec3 top;
    uint32_t total;
    MUST(gphys_solver_attach(solver, scene, rope, 0, hook, NULL));
    MUST(gphys_solver_get_attachments(solver, rope, attachments, 4, &total));
    EXPECT(total == 1 && attachments[0].model == hook && attachments[0].particle == 0);
    for (int i = 1; i <= 60; ++i) {
        place.position.x = (float)i / 60;
        MUST(gphys_scene_set_transform(scene, hook, &place));
        MUST(gphys_solver_step(solver, scene, 1.0f / 60));
    }
    MUST(gphys_solver_get_positions(solver, rope, 0, 1, &top, sizeof top));
    EXPECT(fabsf(top.x - 1) < 1e-5f);
}

/* The crane lets go: the rope falls. */
static void detach(gphys_solver* solver, const gphys_scene* scene, gphys_body_id rope) {
    gphys_vec3 top;
    MUST(gphys_solver_detach(solver, rope, 0));
    for (int i = 0; i < 30; ++i) MUST(gphys_solver_step(solver, scene, 1.0f / 60));
    MUST(gphys_solver_get_positions(solver, rope, 0, 1, &top, sizeof top));
    EXPECT(top.y < 4); /* it hung at a height of 5 m */
}

/* A ball of 2 kg that lies on a table: where it touches, and the force with which it
 * presses, its weight. */
static void contacts(gphys_solver* solver, const gphys_scene* scene, gphys_body_id ball,
                     gphys_model_id table) {
    gphys_contact contacts[4];
    gphys_impulse impulses[4];
    uint32_t contact_count, impulse_count;
    for (int i = 0; i < 60; ++i) MUST(gphys_solver_step(solver, scene, 1.0f / 60));
    MUST(gphys_solver_get_contacts(solver, contacts, 4, &contact_count));
    EXPECT(contact_count == 1 && contacts[0].body == ball &&
           contacts[0].model == table);
    /* The table is 1 m high. */
    EXPECT(contacts[0].normal.y == 1 && fabsf(contacts[0].point.y - 1) < 1e-3f);
    MUST(gphys_solver_get_impulses(solver, impulses, 4, &impulse_count));
    /* The impulse of a step, divided by its 1/60 s, is the weight in newtons. */
    EXPECT(impulse_count == 1 && fabsf(impulses[0].linear.y * 60 + 2 * 9.81f) < 0.01f);
}

/* Two balls of 1 kg fly at each other at 2 m/s each. The strength of the blow tells how
 * loud it is. */
static void body_contacts(gphys_solver* solver, gphys_body_id left,
                          gphys_body_id right) {
    gphys_body_contact contacts[4];
    uint32_t total = 0;
    for (int i = 0; i < 60 && total == 0; ++i) {
        MUST(gphys_solver_step(solver, NULL, 1.0f / 60));
        MUST(gphys_solver_get_body_contacts(solver, contacts, 4, &total));
    }
    EXPECT(total == 1 && contacts[0].body_a == left && contacts[0].body_b == right);
    /* Each loses 1 kg times 2 m/s. */
    EXPECT(contacts[0].normal.x > 0.99f && fabsf(contacts[0].impulse - 2) < 0.01f);
}

static gphys_solver* create(void) {
    gphys_solver* solver = NULL;
    MUST(gphys_solver_create(NULL, &solver));
    return solver;
}

static gphys_body_id hanging_cloth(gphys_solver* solver) {
    const gphys_vec3 corner = {0, 2, 0}, along = {0, 0, 1}, down = {0, -1, 0};
    gphys_body_desc desc;
    gphys_body_id cloth;
    MUST(gphys_body_desc_init(&desc, sizeof desc));
    desc.mass = 0.2f;
    MUST(gphys_solver_add_cloth(solver, &desc, &corner, &along, &down, 5, 5, &cloth));
    return cloth;
}

static gphys_body_id ball(gphys_solver* solver, float x, float y, float mass,
                          float speed) {
    const gphys_vec3 place = {x, y, 0}, velocity = {speed, 0, 0};
    gphys_body_desc desc;
    gphys_body_id body;
    MUST(gphys_body_desc_init(&desc, sizeof desc));
    desc.mass = mass;
    desc.radius = 0.1f;
    desc.body_layers = 1;
    MUST(gphys_solver_add_particles(solver, &desc, &place, sizeof place, 1, &body));
    MUST(gphys_solver_set_velocities(solver, body, 0, 1, &velocity, sizeof velocity));
    return body;
}

int main(void) {
    const gphys_vec3 points[3] = {{0, 5, 0}, {0, 4.5f, 0}, {0, 4, 0}};
    const gphys_sphere round = {{0, 0, 0}, 0.05f};
    const gphys_aabb table = {{-1, 0, -1}, {1, 1, 1}};
    const gphys_transform up = {{0, 5.1f, 0}, {0, 0, 0, 1}, 1};
    gphys_scene* scene = NULL;
    gphys_model_id hook, desk;
    gphys_body_id rope;

    gphys_solver* solver = create();
    gphys_body_id cloth = hanging_cloth(solver);
    MUST(gphys_solver_set_pinned(solver, cloth, 0, 5, 1));
    wind(solver, cloth);
    air_velocities(solver, cloth);
    gphys_solver_destroy(solver);

    solver = create();
    animation_targets(solver, hanging_cloth(solver));
    gphys_solver_destroy(solver);

    solver = create();
    MUST(gphys_scene_create(NULL, &scene));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &round, &up, NULL, &hook));
    MUST(gphys_solver_add_rope(solver, NULL, points, sizeof points[0], 3, 0, &rope));
    attach(solver, scene, rope, hook);
    detach(solver, scene, rope);
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);

    solver = create();
    MUST(gphys_scene_create(NULL, &scene));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &table, NULL, NULL, &desk));
    contacts(solver, scene, ball(solver, 0, 1.1f, 2, 0), desk);
    gphys_solver_destroy(solver);
    gphys_scene_destroy(scene);

    solver = create();
    const gphys_body_id left = ball(solver, -0.5f, 0, 1, 2),
                        right = ball(solver, 0.5f, 0, 1, -2);
    body_contacts(solver, left, right);
    gphys_solver_destroy(solver);
    return 0;
}

/* A character that walks through a level: it slides along walls, climbs steps, is stopped by what is too steep, and
 * crouches under what is too low. It is no model of the scene: a capsule that is swept, pushed out and asked about.
 * With a file name it draws its path there, from the side and from above (SVG). */
#include <math.h>

#include "check.h"

static const float RADIUS = 0.3f, STANDING = 1.8f, CROUCHED = 1, STEP = 0.35f, SKIN = 0.01f, TICK = 1.0f / 60;
static const float WALKABLE = 0.7071f; /* cosine of the steepest slope */

typedef struct character {
    gphys_vec3 feet;
    float height, fall; /* metres a second */
    int grounded;
} character;

static gphys_vec3 plus(gphys_vec3 a, gphys_vec3 b, float times) {
    return (gphys_vec3){a.x + times * b.x, a.y + times * b.y, a.z + times * b.z};
}
static float dot(gphys_vec3 a, gphys_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static gphys_capsule body(const character* c, float height) {
    const gphys_vec3 up = {0, 1, 0};
    return (gphys_capsule){plus(c->feet, up, RADIUS), plus(c->feet, up, height - RADIUS), RADIUS};
}
static gphys_status sweep(const gphys_scene* scene, const character* c, gphys_vec3 way, gphys_hit* hit) {
    const gphys_capsule capsule = body(c, c->height);
    return gphys_scene_sweep(scene, GPHYS_SHAPE_CAPSULE, &capsule, &way, GPHYS_ALL_LAYERS, hit);
}

/* Whether the place can be stood on: it is flat enough, or the edge of a step with something flat behind it. */
static int is_walkable(const gphys_scene* scene, const character* c, const gphys_hit* hit) {
    if (hit->normal.y >= WALKABLE) return 1;
    if (hit->normal.y <= 0 || hit->point.y > c->feet.y + STEP) return 0;
    gphys_ray down = {plus(hit->point, hit->normal, -0.05f), {0, -1, 0}, 0.1f};
    down.origin.y = hit->point.y + 0.05f;
    gphys_hit top;
    return gphys_scene_raycast(scene, &down, GPHYS_ALL_LAYERS, &top) == GPHYS_OK && top.normal.y >= WALKABLE &&
           top.t > 0;
}

/* Go as far as there is room, and on along what is met. */
static void slide(const gphys_scene* scene, character* c, gphys_vec3 way) {
    const gphys_vec3 wish = way;
    for (int i = 0; i < 4 && dot(way, wish) > 1e-8f; ++i) {
        gphys_hit hit;
        if (sweep(scene, c, way, &hit) != GPHYS_OK) {
            c->feet = plus(c->feet, way, 1);
            return;
        }
        gphys_vec3 normal = hit.normal;
        if (normal.y > 0 && !is_walkable(scene, c, &hit)) { /* a slope that is too steep is a wall */
            const float length = sqrtf(normal.x * normal.x + normal.z * normal.z);
            normal = (gphys_vec3){normal.x / length, 0, normal.z / length};
        }
        c->feet = plus(plus(c->feet, way, hit.t), hit.normal, SKIN);
        way = (gphys_vec3){way.x * (1 - hit.t), way.y * (1 - hit.t), way.z * (1 - hit.t)};
        way = plus(way, normal, -fminf(dot(way, normal), 0));
    }
}

/* Stand on what is no further below than that. */
static void settle(const gphys_scene* scene, character* c, float below) {
    gphys_hit hit;
    const gphys_vec3 down = {0, -below, 0};
    c->grounded = sweep(scene, c, down, &hit) == GPHYS_OK && is_walkable(scene, c, &hit);
    if (c->grounded) c->feet.y += down.y * hit.t + SKIN;
}

static void push_out(const gphys_scene* scene, character* c) {
    for (int i = 0; i < 4; ++i) {
        const gphys_capsule capsule = body(c, c->height);
        gphys_penetration deepest;
        uint32_t total;
        const gphys_status status =
            gphys_scene_penetration(scene, GPHYS_SHAPE_CAPSULE, &capsule, GPHYS_ALL_LAYERS, &deepest, 1, &total);
        EXPECT(status >= 0);
        if (total == 0) return;
        c->feet = plus(c->feet, deepest.normal, deepest.depth + SKIN);
    }
}

static void walk(const gphys_scene* scene, character* c, gphys_vec3 way, int crouch) {
    /* Crouch in place; stand up where there is room. */
    uint32_t above;
    const gphys_capsule upright = body(c, STANDING);
    EXPECT(gphys_scene_overlap(scene, GPHYS_SHAPE_CAPSULE, &upright, GPHYS_ALL_LAYERS, NULL, 0, &above) >= 0);
    if (crouch || above == 0) c->height = crouch ? CROUCHED : STANDING;
    push_out(scene, c);

    const character before = *c;
    slide(scene, c, way);
    const float went = dot(plus(c->feet, before.feet, -1), way);
    if (before.grounded && went < 0.9f * dot(way, way)) { /* the same from a step higher */
        character higher = before;
        slide(scene, &higher, (gphys_vec3){0, STEP, 0});
        slide(scene, &higher, way);
        settle(scene, &higher, STEP + 2 * SKIN);
        if (higher.grounded && dot(plus(higher.feet, before.feet, -1), way) > went + 1e-4f) *c = higher;
    }
    settle(scene, c, before.grounded ? STEP : 2 * SKIN);
    c->fall = c->grounded ? 0 : c->fall + 9.81f * TICK;
    if (!c->grounded) slide(scene, c, (gphys_vec3){0, -c->fall * TICK, 0});
}

/* ---- The level: boxes, a turned wall, and a mesh of a gentle and a steep ramp. ---- */

static const gphys_aabb boxes[] = {
    {{-2, -1, -4}, {30, 0, 6}},     {{8, 0, -4}, {8.5f, 0.25f, 1}}, {{8.5f, 0, -4}, {9, 0.5f, 1}},
    {{9, 0, -4}, {9.5f, 0.75f, 1}}, {{9.5f, 0, -4}, {13, 1, 1}},    {{23, 1.3f, 2}, {26, 3, 6}},
};
enum { BOXES = sizeof boxes / sizeof boxes[0] };
static const gphys_obb wall = {{3.5f, 1, 0.3f}, {1.5f, 1, 0.1f}, {0, 0.2588190f, 0, 0.9659258f}};
static const gphys_vec3 ramps[] = {{13, 1, -4}, {16, 0, -4}, {16, 0, 1}, {13, 1, 1},  /* 18 degrees */
                                   {20, 0, -4}, {22, 4, -4}, {22, 4, 1}, {20, 0, 1}}; /* 63 degrees */
static const uint32_t corners[] = {0, 2, 1, 0, 3, 2, 4, 6, 5, 4, 7, 6};

/* Where to, for how long, and what must be true then. */
typedef struct leg {
    float x, z, seconds;
    int crouch;
    gphys_vec3 low, high;
} leg;
static const leg legs[] = {
    {3, 0, 2.2f, 0, {5, -0.05f, -3}, {6.5f, 0.05f, -0.5f}},    /* slides along the wall */
    {0, 3, 0.3f, 0, {5, -0.05f, -0.5f}, {6.5f, 0.05f, 0.9f}},  /* and back */
    {3, 0, 2, 0, {10, 0.95f, -3}, {13, 1.05f, 0.9f}},          /* climbs the steps */
    {3, 0, 2, 0, {16, -0.05f, -3}, {19.4f, 0.05f, 0.9f}},      /* goes down the gentle ramp */
    {3, 0, 2, 0, {19.5f, -0.05f, -3}, {20.3f, 0.35f, 0.9f}},   /* is stopped by the steep one */
    {-1, 3, 1.2f, 0, {18, -0.05f, 2.7f}, {20, 0.05f, 5.9f}},   /* goes around it */
    {3, 0, 2, 0, {21.5f, -0.05f, 2.5f}, {22.8f, 0.05f, 5.9f}}, /* does not fit under the block */
    {3, 0, 0.7f, 1, {23, -0.05f, 2.5f}, {26, 0.05f, 5.9f}},    /* crouches */
    {3, 0, 0.2f, 0, {23, -0.05f, 2.5f}, {26, 0.05f, 5.9f}},    /* cannot stand up there */
    {3, 0, 1, 0, {26.3f, -0.05f, 2.5f}, {29, 0.05f, 5.9f}},    /* and does behind it */
};
enum { LEGS = sizeof legs / sizeof legs[0], MOST_TICKS = 2000 };

static void outline(FILE* file, const gphys_vec3* corner, int count, int from_above) {
    fprintf(file, "<polygon points='");
    for (int i = 0; i < count; ++i) {
        fprintf(file, "%.1f,%.1f ", 100 + 30 * corner[i].x,
                from_above ? 400 - 30 * corner[i].z : 170 - 30 * corner[i].y);
    }
    fprintf(file, "' fill='#cfd8dc' stroke='#546e7a'/>\n");
}

static void draw(const char* name, const character* path, int count) {
    FILE* file = fopen(name, "w");
    EXPECT(file != NULL);
    fprintf(file,
            "<svg xmlns='http://www.w3.org/2000/svg' width='1040' height='540'>"
            "<rect width='1040' height='540' fill='white'/>\n");
    for (int above = 0; above < 2; ++above) {
        for (int i = 0; i < BOXES; ++i) {
            const gphys_vec3 a = boxes[i].min, b = boxes[i].max;
            const gphys_vec3 corner[] = {a, {b.x, a.y, a.z}, b, {a.x, b.y, b.z}};
            outline(file, corner, 4, above);
        }
        for (int i = 0; i < 2; ++i) outline(file, ramps + 4 * i, 4, above);
        const float s = 0.5f, c = 0.8660254f; /* of the wall's 30 degrees */
        gphys_vec3 corner[4];
        for (int i = 0; i < 4; ++i) {
            const float u = i == 0 || i == 3 ? -1.5f : 1.5f, v = i < 2 ? -0.1f : 0.1f;
            corner[i] = (gphys_vec3){3.5f + c * u + s * v, i < 2 ? 0.0f : 2.0f, 0.3f - s * u + c * v};
        }
        outline(file, corner, 4, above);
        for (int i = 0; i < count; i += 6) {
            const float x = 100 + 30 * path[i].feet.x, r = 30 * RADIUS, h = 30 * path[i].height;
            const char* color = path[i].height < STANDING ? "#e65100" : "#1565c0";
            fprintf(file, "<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' rx='%.1f' fill='none' stroke='%s'/>\n",
                    x - r, above ? 400 - 30 * path[i].feet.z - r : 170 - 30 * path[i].feet.y - h, 2 * r,
                    above ? 2 * r : h, r, color);
        }
    }
    fprintf(file, "</svg>\n");
    EXPECT(fclose(file) == 0);
}

int main(int argc, char** argv) {
    static character path[MOST_TICKS];
    gphys_scene* scene = NULL;
    gphys_mesh* mesh = NULL;
    gphys_model_id ids[BOXES];
    MUST(gphys_scene_create(NULL, &scene));
    MUST(gphys_mesh_create(NULL, &ramps[0].x, sizeof ramps[0], 8, corners, 12, &mesh));
    MUST(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, boxes, sizeof boxes[0], NULL, 0, BOXES, NULL, ids));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_OBB, &wall, NULL, NULL, ids));
    MUST(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, NULL, NULL, ids));

    character c = {{0, 0.5f, 0}, 1.8f, 0, 0}; /* falls half a metre first */
    int ticks = 0;
    for (int i = 0; i < LEGS; ++i) {
        const leg* to = &legs[i];
        const gphys_vec3 way = {to->x * TICK, 0, to->z * TICK};
        for (float time = 0; time < to->seconds; time += TICK) {
            walk(scene, &c, way, to->crouch);
            path[ticks++ % MOST_TICKS] = c;
        }
        printf("leg %d: at %.2f %.2f %.2f, %.1f m tall%s\n", i, c.feet.x, c.feet.y, c.feet.z, c.height,
               c.grounded ? "" : ", in the air");
        EXPECT(c.feet.x >= to->low.x && c.feet.y >= to->low.y && c.feet.z >= to->low.z);
        EXPECT(c.feet.x <= to->high.x && c.feet.y <= to->high.y && c.feet.z <= to->high.z);
        EXPECT((c.height < STANDING) == (i == 7 || i == 8)); /* under the block */
    }
    if (argc > 1) draw(argv[1], path, ticks);
    gphys_scene_destroy(scene);
    gphys_mesh_destroy(mesh);
    return 0;
}

/* Drawing a frame: what the camera's cull finds, as instances of four meshes (box, ball, tube, statue), bodies
 * as triangles, lines and points. The sun's shadows are drawn first, into a depth texture. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <stb_easy_font.h>
#include "canvas.h"

/* --- Instances ---------------------------------------------------------------------------------- */

typedef struct axes {
    gphys_vec3 x, y, z, at; /* the columns of a matrix */
} axes;

static gphys_vec3 scaled(gphys_vec3 v, float s) { return (gphys_vec3){v.x * s, v.y * s, v.z * s}; }
static gphys_vec3 sum(gphys_vec3 a, gphys_vec3 b) { return (gphys_vec3){a.x + b.x, a.y + b.y, a.z + b.z}; }

static axes of_transform(const gphys_transform* t) {
    const float x = t->rotation.x, y = t->rotation.y, z = t->rotation.z, w = t->rotation.w;
    const axes turned = {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
                         {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
                         {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)},
                         t->position};
    return (axes){scaled(turned.x, t->scale), scaled(turned.y, t->scale), scaled(turned.z, t->scale), turned.at};
}

static gphys_vec3 placed(const axes* m, gphys_vec3 p) {
    return sum(m->at, sum(scaled(m->x, p.x), sum(scaled(m->y, p.y), scaled(m->z, p.z))));
}

static void put_instance(part* p, const axes* m, colour c, float kind) {
    *new_instance(p) = (instance){
        {{m->x.x, m->y.x, m->z.x, m->at.x}, {m->x.y, m->y.y, m->z.y, m->at.y}, {m->x.z, m->y.z, m->z.z, m->at.z}},
        {c.r, c.g, c.b, kind}};
}

static void put_ball(canvas* c, gphys_vec3 at, float radius, colour paint) {
    const axes m = {{radius, 0, 0}, {0, radius, 0}, {0, 0, radius}, at};
    put_instance(&c->parts[BALL], &m, paint, 0);
}

static void put_tube(canvas* c, gphys_vec3 a, gphys_vec3 b, float radius, colour paint) {
    const gphys_vec3 y = {b.x - a.x, b.y - a.y, b.z - a.z};
    const float length = sqrtf(y.x * y.x + y.y * y.y + y.z * y.z);
    if (length == 0) return;
    /* Any vector across, then one across both. */
    gphys_vec3 x = fabsf(y.y) > 0.9f * length ? (gphys_vec3){y.y, -y.x, 0} : (gphys_vec3){-y.z, 0, y.x};
    x = scaled(x, radius / sqrtf(x.x * x.x + x.y * x.y + x.z * x.z));
    const gphys_vec3 z =
        scaled((gphys_vec3){x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x}, 1 / length);
    const axes m = {x, y, z, a};
    put_instance(&c->parts[TUBE], &m, paint, 0);
}

static void put_model(canvas* c, const look* shown, const gphys_transform* where, colour paint) {
    axes m = of_transform(where);
    switch (shown->type) {
        case GPHYS_SHAPE_PLANE: { /* the ground: a square of a kilometre */
            m = (axes){{500, 0, 0}, {0, 1e-3f, 0}, {0, 0, 500}, {m.at.x, m.at.y - 1e-3f, m.at.z}};
            put_instance(&c->parts[BOX], &m, paint, 1);
            break;
        }
        case GPHYS_SHAPE_AABB: {
            const gphys_vec3 a = shown->shape.box.min, b = shown->shape.box.max;
            const gphys_vec3 middle = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
            m = (axes){scaled(m.x, (b.x - a.x) / 2), scaled(m.y, (b.y - a.y) / 2), scaled(m.z, (b.z - a.z) / 2),
                       placed(&m, middle)};
            put_instance(&c->parts[BOX], &m, paint, 0);
            break;
        }
        case GPHYS_SHAPE_SPHERE:
            put_ball(c, placed(&m, shown->shape.sphere.center), shown->shape.sphere.radius * where->scale, paint);
            break;
        case GPHYS_SHAPE_CAPSULE: {
            const gphys_vec3 a = placed(&m, shown->shape.capsule.a), b = placed(&m, shown->shape.capsule.b);
            const float radius = shown->shape.capsule.radius * where->scale;
            put_ball(c, a, radius, paint);
            put_ball(c, b, radius, paint);
            put_tube(c, a, b, radius, paint);
            break;
        }
        case GPHYS_SHAPE_MESH:
            put_instance(&c->parts[STATUE], &m, paint, 0);
            break;
        default:
            break;
    }
}

static int is_selected(const overlay* marks, gphys_model_id id) { /* ascending */
    uint32_t low = 0, high = marks->selected_count;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (marks->selected[middle] < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < marks->selected_count && marks->selected[low] == id;
}

/* The models in a frustum. Returns their number. */
static uint32_t put_models(canvas* c, const stage* s, const gphys_frustum* seen, const overlay* marks,
                           int with_ground) {
    enum { SOME = 256 };
    gphys_transform where[SOME];
    uint32_t total;
    check(gphys_scene_cull(s->scene, seen, SOLID, c->visible, c->visible_capacity, &total), "cull");
    if (total > c->visible_capacity) {
        c->visible = grown(c->visible, total, &c->visible_capacity, sizeof *c->visible);
        check(gphys_scene_cull(s->scene, seen, SOLID, c->visible, c->visible_capacity, &total), "cull");
    }
    for (uint32_t i = 0; i < total; ++i) {
        if (i % SOME == 0) {
            const uint32_t count = total - i < SOME ? total - i : SOME;
            check(gphys_scene_get_world_transforms(s->scene, c->visible + i, count, where, sizeof where[0]),
                  "transforms");
        }
        const gphys_model_id id = c->visible[i];
        const look* shown = &s->looks[id & SLOT_MASK];
        const colour glow = {1.0f, 0.62f, 0.12f}, tint = {0.25f, 0.55f, 1.0f};
        const int ground = shown->type == GPHYS_SHAPE_PLANE;
        if (ground && !with_ground) continue; /* it casts no shadow that is seen */
        const colour paint = ground                   ? shown->colour
                             : id == marks->hovered   ? glow
                             : is_selected(marks, id) ? tint
                                                      : shown->colour;
        put_model(c, shown, &where[i % SOME], paint);
    }
    return total;
}

/* --- Bodies --------------------------------------------------------------------------------------- */

static void put_cloth(canvas* c, const gphys_vec3* points, uint32_t point_count, const uint32_t* indices,
                      uint32_t index_count, float radius, colour paint) {
    triangle_mesh mesh = {(gphys_vec3*)points, calloc(point_count, sizeof(gphys_vec3)), (uint32_t*)indices, point_count,
                          index_count};
    if (!mesh.normals) exit(1);
    compute_normals(&mesh);
    for (int face = 0; face < 2; ++face) { /* half of the particles' radius to both sides */
        const float away = face ? -radius / 2 : radius / 2;
        for (uint32_t i = 0; i < index_count; ++i) {
            const uint32_t k = indices[face ? i - i % 3 + (2 - i % 3) : i];
            put_corner(c, sum(points[k], scaled(mesh.normals[k], away)), scaled(mesh.normals[k], face ? -1.0f : 1.0f),
                       paint, 0);
        }
    }
    uint32_t count, *rim = cloth_rim(indices, index_count, point_count, &count);
    for (uint32_t i = 0; i < count; i += 2) {
        const uint32_t a = rim[i], b = rim[i + 1];
        const uint32_t corners[6] = {a, a, b, b, a, b};
        for (int k = 0; k < 6; ++k) { /* two triangles between the faces, lit like them */
            const float away = k == 0 || k == 2 || k == 3 ? -radius / 2 : radius / 2;
            const gphys_vec3 normal = mesh.normals[corners[k]];
            put_corner(c, sum(points[corners[k]], scaled(normal, away)), normal, paint, 0);
        }
    }
    free(rim);
    free(mesh.normals);
}

static void put_bodies(canvas* c, const stage* s) {
    for (uint32_t b = 0; b < s->body_count; ++b) {
        gphys_body_info info;
        check(gphys_solver_get_body_info(s->solver, s->bodies[b], &info), "body");
        gphys_vec3* points = malloc(info.particle_count * sizeof *points);
        if (!points) exit(1);
        check(gphys_solver_get_positions(s->solver, s->bodies[b], 0, info.particle_count, points, sizeof *points),
              "positions");
        const colour paint = s->body_colours[b];
        if (info.triangle_count > 0) {
            uint32_t total, *indices = malloc(3 * info.triangle_count * sizeof *indices);
            if (!indices) exit(1);
            check(gphys_solver_get_triangles(s->solver, s->bodies[b], indices, 3 * info.triangle_count, &total),
                  "triangles");
            put_cloth(c, points, info.particle_count, indices, 3 * info.triangle_count, s->body_radii[b], paint);
            free(indices);
        } else if (info.constraint_count > 0) {
            for (uint32_t i = 0; i < info.particle_count; ++i) {
                put_ball(c, points[i], s->body_radii[b], paint);
                if (i > 0) put_tube(c, points[i - 1], points[i], s->body_radii[b], paint);
            }
        } else {
            for (uint32_t i = 0; i < info.particle_count; ++i) put_ball(c, points[i], s->body_radii[b], paint);
        }
        free(points);
    }
}

/* --- Lines and points ------------------------------------------------------------------------------ */

static const gphys_vec3 no_normal = {0, 0, 0};

static void put_line(canvas* c, gphys_vec3 a, gphys_vec3 b, colour ink, float alpha) {
    put_corner(c, a, no_normal, ink, alpha);
    put_corner(c, b, no_normal, ink, alpha);
}

/* The edges between eight corners, of which bit 0, 1 and 2 of the number tell the side. */
static void put_edges(canvas* c, const gphys_vec3 corners[8], colour ink, float alpha) {
    for (uint32_t i = 0; i < 8; ++i) {
        for (uint32_t bit = 1; bit < 8; bit *= 2) {
            if (!(i & bit)) put_line(c, corners[i], corners[i | bit], ink, alpha);
        }
    }
}

static void put_octree(canvas* c, const stage* s) {
    uint32_t total = 0;
    check(gphys_scene_get_octree_boxes(s->scene, NULL, 0, &total), "octree");
    gphys_octree_box* boxes = calloc(total + 1, sizeof *boxes);
    if (!boxes) exit(1);
    check(gphys_scene_get_octree_boxes(s->scene, boxes, total, &total), "octree");
    for (uint32_t i = 0; i < total && i < 20000; ++i) {
        const gphys_vec3 a = boxes[i].bounds.min, b = boxes[i].bounds.max;
        gphys_vec3 corners[8];
        for (uint32_t k = 0; k < 8; ++k)
            corners[k] = (gphys_vec3){k & 1 ? b.x : a.x, k & 2 ? b.y : a.y, k & 4 ? b.z : a.z};
        const float deep = (float)boxes[i].depth / 6;
        put_edges(c, corners, (colour){1 - deep, 0.35f + 0.4f * deep, deep}, 0.55f);
    }
    free(boxes);
}

static void put_lines(canvas* c, const stage* s, const overlay* marks) {
    if (marks->octree) put_octree(c, s);
    if (marks->observed) {
        gphys_vec3 around[8], corners[8];
        static const int order[8] = {0, 1, 3, 2, 4, 5, 7, 6}; /* the library's go around near and far plane */
        check(gphys_camera_get_corners(marks->observed, around), "corners");
        for (int i = 0; i < 8; ++i) corners[i] = around[order[i]];
        put_edges(c, corners, (colour){1, 0.95f, 0.3f}, 1);
    }
}

static void put_points(canvas* c, const stage* s) {
    for (uint32_t i = 0; s->lidar && i < LIDAR_RINGS * LIDAR_COLUMNS; ++i) {
        const gphys_hit* hit = &s->lidar[i];
        if (hit->model == 0) continue;
        const float near = fmaxf(0, 1 - hit->t / 35);
        put_corner(c, hit->point, no_normal, (colour){near, 0.25f + 0.6f * (1 - near), 0.9f * (1 - near)}, 1);
    }
}

/* --- The frame --------------------------------------------------------------------------------------- */

static const gphys_vec3 to_sun = {0.48f, 0.78f, 0.40f}; /* unit */

/* What the sun sees around a point: a cube of half a side, three times as deep. */
static gphys_mat4 view_of_sun(gphys_vec3 at, float half) {
    const gphys_vec3 f = scaled(to_sun, -1), r = {0.64f, 0, -0.768f};
    const gphys_vec3 u = {f.y * r.z - f.z * r.y, f.z * r.x - f.x * r.z, f.x * r.y - f.y * r.x};
    const gphys_vec3 rows[3] = {scaled(r, 1 / half), scaled(u, 1 / half), scaled(f, 1 / (3 * half))};
    gphys_mat4 m = {{0}};
    for (int i = 0; i < 3; ++i) {
        m.m[i] = rows[i].x, m.m[4 + i] = rows[i].y, m.m[8 + i] = rows[i].z;
        m.m[12 + i] = -(rows[i].x * at.x + rows[i].y * at.y + rows[i].z * at.z);
    }
    m.m[15] = 1;
    return m;
}

uint32_t canvas_draw(canvas* c, const stage* s, const gphys_camera* camera, int width, int height, const overlay* marks,
                     double* cull_ms) {
    gphys_orbit orbit;
    gphys_mat4 view;
    gphys_vec3 eye;
    gphys_quat turn;
    gphys_frustum seen;
    check(gphys_camera_get_orbit(camera, &orbit), "orbit");
    check(gphys_camera_get_view_projection_matrix(camera, &view), "view");
    check(gphys_camera_get_transform(camera, &eye, &turn), "eye");

    /* The sun's pass. What casts shadows into the picture may lie outside of it. */
    const gphys_mat4 sun_view = view_of_sun(orbit.target, fminf(fmaxf(1.3f * orbit.distance, 5), 45));
    check(gphys_frustum_from_matrix(&sun_view, GPHYS_DEPTH_MINUS_ONE_TO_ONE, 0, &seen), "sun");
    glBindFramebuffer(GL_FRAMEBUFFER, c->shadow_target);
    glViewport(0, 0, SHADOW, SHADOW);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glUseProgram(c->program);
    set_matrix(c->program, "view", sun_view.m);
    put_models(c, s, &seen, marks, 0);
    put_bodies(c, s);
    draw_parts(c, c->program);
    draw_corners(c, GL_TRIANGLES);

    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glClearColor(0.78f, 0.85f, 0.92f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_matrix(c->program, "view", view.m);
    set_matrix(c->program, "sun_view", sun_view.m);
    glUniform3f(glGetUniformLocation(c->program, "eye"), eye.x, eye.y, eye.z);
    glUniform3f(glGetUniformLocation(c->program, "sun"), to_sun.x, to_sun.y, to_sun.z);
    glUniform1f(glGetUniformLocation(c->program, "haze"), 0.006f);
    check(gphys_camera_get_frustum(marks->observed ? marks->observed : camera, &seen), "frustum");
    const double start = seconds();
    uint32_t drawn;
    check(gphys_scene_cull(s->scene, &seen, SOLID, NULL, 0, &drawn), "cull");
    *cull_ms = 1e3 * (seconds() - start);
    drawn = put_models(c, s, &seen, marks, 1);
    put_bodies(c, s);
    if (marks->holds) put_ball(c, marks->held, 0.06f, (colour){1, 0.62f, 0.12f});
    draw_parts(c, c->program);
    draw_corners(c, GL_TRIANGLES);

    glUseProgram(c->flat);
    set_matrix(c->flat, "view", view.m);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    put_lines(c, s, marks);
    draw_corners(c, GL_LINES);
    put_points(c, s);
    draw_corners(c, GL_POINTS);
    return drawn;
}

/* --- Over the picture ----------------------------------------------------------------------------------- */

static void draw_over(canvas* c, int width, int height, GLenum kind) {
    const float over[16] = {2 / (float)width, 0, 0, 0, 0, -2 / (float)height, 0, 0, 0, 0, 1, 0, -1, 1, 0, 1};
    glDisable(GL_DEPTH_TEST);
    glUseProgram(c->flat);
    set_matrix(c->flat, "view", over);
    draw_corners(c, kind);
}

static void put_quad(canvas* c, const float xy[4][2], colour ink, float alpha) {
    static const int order[6] = {0, 1, 2, 0, 2, 3};
    for (int k = 0; k < 6; ++k) put_corner(c, (gphys_vec3){xy[order[k]][0], xy[order[k]][1], 0}, no_normal, ink, alpha);
}

void canvas_text(canvas* c, int width, int height, float x, float y, float scale, colour ink, const char* text) {
    static struct {
        float x, y, z;
        unsigned char paint[4];
    } quads[4 * 4096];
    char copy[2048];
    snprintf(copy, sizeof copy, "%s", text);
    const int count = stb_easy_font_print(0, 0, copy, NULL, quads, sizeof quads);
    for (int i = 0; i < count; ++i) {
        float xy[4][2];
        for (int k = 0; k < 4; ++k)
            xy[k][0] = x + scale * quads[4 * i + k].x, xy[k][1] = y + scale * quads[4 * i + k].y;
        put_quad(c, (const float(*)[2])xy, ink, 1);
    }
    draw_over(c, width, height, GL_TRIANGLES);
}

void canvas_size_of_text(const char* text, float scale, float* width, float* height) {
    char copy[2048];
    snprintf(copy, sizeof copy, "%s", text);
    *width = scale * (float)stb_easy_font_width(copy);
    *height = scale * (float)stb_easy_font_height(copy);
}

void canvas_shade(canvas* c, int width, int height, float x, float y, float w, float h, colour paint, float alpha) {
    const float xy[4][2] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    put_quad(c, xy, paint, alpha);
    draw_over(c, width, height, GL_TRIANGLES);
}

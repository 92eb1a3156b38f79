/* What the mouse does: it points at models, takes particles of cloth and ropes, and selects by a rectangle. */
#include <math.h>
#include <stdlib.h>

#include "window.h"

int hand_find(const stage* s, const gphys_camera* camera, float x, float y, gphys_body_id* body, uint32_t* particle,
              gphys_vec3* where) {
    const float reach = 14; /* pixels */
    float nearest = reach * reach;
    int found = 0;
    gphys_vec3 eye;
    gphys_quat turn;
    check(gphys_camera_get_transform(camera, &eye, &turn), "eye");
    for (uint32_t b = 0; b < s->body_count; ++b) {
        gphys_body_info info;
        check(gphys_solver_get_body_info(s->solver, s->bodies[b], &info), "body");
        gphys_vec3* points = malloc(2 * info.particle_count * sizeof *points);
        if (!points) exit(1);
        gphys_vec3* pixels = points + info.particle_count;
        check(gphys_solver_get_positions(s->solver, s->bodies[b], 0, info.particle_count, points, sizeof *points),
              "positions");
        check(gphys_camera_project_batch(camera, points, sizeof *points, info.particle_count, pixels, sizeof *pixels),
              "project");
        for (uint32_t i = 0; i < info.particle_count; ++i) {
            const float dx = pixels[i].x - x, dy = pixels[i].y - y, squared = dx * dx + dy * dy;
            if (!(squared < nearest)) continue;
            /* Seen, if the way to it is free but for its last part, where cloth lies on a model. */
            const gphys_vec3 p = points[i];
            const gphys_segment sight = {
                eye, {eye.x + 0.98f * (p.x - eye.x), eye.y + 0.98f * (p.y - eye.y), eye.z + 0.98f * (p.z - eye.z)}};
            gphys_hit hit;
            const gphys_status blocked = gphys_scene_segment_test(s->scene, &sight, SOLID, &hit);
            check(blocked, "sight");
            if (blocked == GPHYS_OK) continue;
            nearest = squared;
            found = 1;
            *body = s->bodies[b], *particle = i, *where = p;
        }
        free(points);
    }
    return found;
}

void hand_hover(hand* h, const stage* s, const gphys_camera* camera, float x, float y) {
    const gphys_status found = gphys_camera_pick(camera, s->scene, x, y, SOLID, &h->hover);
    check(found, "pick");
    if (found != GPHYS_OK) h->hover.model = 0;
}

int hand_grab(hand* h, stage* s, const gphys_camera* camera, float x, float y) {
    gphys_vec3 where, pixel;
    if (!hand_find(s, camera, x, y, &h->body, &h->particle, &where)) return 0;
    check(gphys_camera_project(camera, &where, &pixel), "project");
    h->depth = pixel.z;
    /* A model that nothing collides with leads the particle; the solver moves it as it moves the model, without a jump.
     */
    const gphys_sphere finger = {{0, 0, 0}, 0.01f};
    const gphys_transform at = {where, {0, 0, 0, 1}, 1};
    gphys_model_desc desc;
    check(gphys_model_desc_init(&desc, sizeof desc), "model desc");
    desc.layers = HAND;
    check(gphys_scene_add(s->scene, GPHYS_SHAPE_SPHERE, &finger, &at, &desc, &h->model), "hand");
    check(gphys_solver_attach(s->solver, s->scene, h->body, h->particle, h->model, NULL), "attach");
    return 1;
}

void hand_drag(hand* h, stage* s, const gphys_camera* camera, float x, float y) {
    const gphys_vec3 pixel = {x, y, h->depth};
    gphys_transform at = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    if (gphys_camera_unproject(camera, &pixel, &at.position) != GPHYS_OK) return;
    at.position.y = fmaxf(at.position.y, 0.03f); /* not into the ground */
    check(gphys_scene_set_transform(s->scene, h->model, &at), "drag");
}

void hand_release(hand* h, stage* s) {
    if (h->body == 0) return;
    check(gphys_solver_detach(s->solver, h->body, h->particle), "detach");
    check(gphys_scene_remove(s->scene, h->model), "hand");
    h->body = 0;
}

void hand_select(hand* h, const stage* s, const gphys_camera* camera, const float r[4]) {
    h->selected_count = 0;
    if (r[0] == r[2] || r[1] == r[3]) return;
    uint32_t total;
    check(
        gphys_camera_pick_rectangle(camera, s->scene, r[0], r[1], r[2], r[3], SOLID, h->selected, h->capacity, &total),
        "select");
    if (total > h->capacity) {
        h->capacity = total;
        h->selected = realloc(h->selected, total * sizeof *h->selected);
        if (!h->selected) exit(1);
        check(gphys_camera_pick_rectangle(camera, s->scene, r[0], r[1], r[2], r[3], SOLID, h->selected, h->capacity,
                                          &total),
              "select");
    }
    h->selected_count = total;
}

void hand_forget(hand* h) {
    h->body = 0;
    h->hover.model = 0;
    h->selected_count = 0;
}

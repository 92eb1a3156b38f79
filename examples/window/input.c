/* What the mouse does: it points at models, takes particles of cloth and ropes, and selects by a rectangle. */
#include <math.h>
#include <stdlib.h>

#include "window.h"

int hand_find(const stage* s, const gphys_camera* camera, float x, float y, gphys_body_id* body, uint32_t* particle,
              gphys_vec3* where) {
    /* The pixel itself, and rings around it: a rope is thin. What is behind a model is not met. */
    enum { RINGS = 2, AROUND = 8, COUNT = 1 + RINGS * AROUND };
    const float reach = 14; /* pixels */
    float pixels[COUNT][2] = {{x, y}};
    gphys_hit hits[COUNT];
    for (int i = 1; i < COUNT; ++i) {
        const float radius = reach * (float)(1 + (i - 1) / AROUND) / RINGS;
        const float angle = 6.2831853f * (float)(i - 1) / AROUND;
        pixels[i][0] = x + radius * cosf(angle);
        pixels[i][1] = y + radius * sinf(angle);
    }
    check(gphys_camera_pick_batch(camera, s->scene, pixels[0], sizeof pixels[0], COUNT, SOLID | BODY, hits,
                                  sizeof hits[0]),
          "pick bodies");
    for (int i = 0; i < COUNT; ++i) {
        gphys_model_info info;
        if (hits[i].model == 0) continue;
        check(gphys_scene_get_info(s->scene, hits[i].model, &info), "model");
        if (info.layers != BODY) continue;
        *body = s->bodies[hits[i].tag];
        check(gphys_solver_get_nearest_particle(s->solver, *body, hits[i].triangle, &hits[i].point, particle),
              "particle");
        check(gphys_solver_get_positions(s->solver, *body, *particle, 1, where, sizeof *where), "position");
        return 1;
    }
    return 0;
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

/* The viewer in a window: a world made of a preset, drawn by OpenGL, touched by the mouse. */
#ifndef WINDOW_H
#define WINDOW_H

#include "../viewer/viewer.h"

/* Layer bits. The hand drags particles; nothing collides with it and nobody sees it. Bodies are drawn by themselves. */
enum { SOLID = 1, HAND = 2, BODY = 4 };

enum { MAX_BODIES = 64, LIDAR_RINGS = 48, LIDAR_COLUMNS = 360 };
enum { SLOT_MASK = 0xffffff }; /* of an id: its slot; the rest tells models apart that had the slot in turn */

typedef struct colour {
    float r, g, b;
} colour;

/* How a model is drawn. The table of a stage has one for each slot of the scene's ids. */
typedef struct look {
    gphys_shape_type type;
    union {
        gphys_sphere sphere;
        gphys_capsule capsule;
        gphys_aabb box;
        gphys_plane plane;
    } shape;
    colour colour;
} look;

/* --- presets.c: what there is, and how it moves by itself ------------------------------------ */

typedef struct stage {
    gphys_scene* scene;
    gphys_solver* solver;
    gphys_mesh* mesh; /* of the file, or the built-in knot; height 1, on y = 0 */
    triangle_mesh source;
    look* looks;
    uint32_t look_count;
    gphys_body_id bodies[MAX_BODIES];
    colour body_colours[MAX_BODIES];
    float body_radii[MAX_BODIES]; /* of collision, and as drawn, m */
    uint32_t body_count;
    gphys_model_id walker; /* moves along a path; 0: none */
    gphys_hit* lidar;      /* of the last sweep; NULL: none */
    gphys_vec3 lidar_at;
    double time; /* simulated, s */
    gphys_orbit view;
    double origin[3];
    int shows_mesh; /* a model of the mesh is in it */
} stage;

enum { PRESET_COUNT = 8 };
extern const char* const preset_names[PRESET_COUNT];

/* Build a preset. path may be NULL: then the mesh is a knot. Returns -1, after a message, if the file is no mesh. */
int stage_create(stage* s, uint32_t preset, const char* path);
/* Move what moves by itself and advance the solver by so much time. */
void stage_step(stage* s, float time);
void stage_destroy(stage* s);

/* --- rim.c: the edges of one triangle only ---------------------------------------------------- */

/* Pairs of points, in the order in which their triangle has them, and their number, twice that of the edges. Freed by
 * the caller. */
uint32_t* cloth_rim(const uint32_t* indices, uint32_t index_count, uint32_t point_count, uint32_t* out_count);

/* --- canvas.c and draw.c ------------------------------------------------------------------------------------ */

typedef struct canvas canvas;

typedef struct overlay {
    gphys_model_id hovered;
    const gphys_model_id* selected;
    uint32_t selected_count;
    float marquee[4];             /* pixels; no area: none */
    int octree;                   /* draw its boxes */
    const gphys_camera* observed; /* draw only what this one sees, and its frustum; NULL: none */
    gphys_vec3 held;              /* a particle under the mouse */
    int holds;
} overlay;

canvas* canvas_create(void);
void canvas_destroy(canvas* c);
/* The mesh of the stage has changed. */
void canvas_take_mesh(canvas* c, const triangle_mesh* mesh);
/* Draw a frame; returns the number of models drawn, and the milliseconds of the cull. */
uint32_t canvas_draw(canvas* c, const stage* s, const gphys_camera* camera, int width, int height, const overlay* marks,
                     double* cull_ms);
/* Text at a pixel, over what was drawn; lines end with \n. A scale of 1 is 7 pixels high. */
void canvas_text(canvas* c, int width, int height, float x, float y, float scale, colour ink, const char* text);
void canvas_size_of_text(const char* text, float scale, float* width, float* height);
/* A filled rectangle of pixels. */
void canvas_shade(canvas* c, int width, int height, float x, float y, float w, float h, colour paint, float alpha);

/* --- input.c: what the mouse does -------------------------------------------------------------- */

typedef struct hand {
    gphys_body_id body; /* whose particle is dragged; 0: none */
    uint32_t particle;
    gphys_model_id model; /* that the particle is attached to */
    float depth;          /* of the particle, as gphys_camera_project gives it */
    gphys_hit hover;      /* model 0: nothing */
    gphys_model_id* selected;
    uint32_t selected_count, capacity;
} hand;

/* A particle of what bends under a pixel, or within 14 pixels of it, and is not behind a model; 0: none. */
int hand_find(const stage* s, const gphys_camera* camera, float x, float y, gphys_body_id* body, uint32_t* particle,
              gphys_vec3* where);
void hand_hover(hand* h, const stage* s, const gphys_camera* camera, float x, float y);
/* Take the particle under a pixel; 0 if there is none. */
int hand_grab(hand* h, stage* s, const gphys_camera* camera, float x, float y);
void hand_drag(hand* h, stage* s, const gphys_camera* camera, float x, float y);
void hand_release(hand* h, stage* s);
void hand_select(hand* h, const stage* s, const gphys_camera* camera, const float rectangle[4]);
/* The stage is another: nothing is held or selected. */
void hand_forget(hand* h);

#endif

/* The viewer's parts: load a mesh file, build a world of it, step it, and take pictures. */
#ifndef VIEWER_H
#define VIEWER_H

#include <gamephys_c.h>

/* --- load.c: a mesh file of any common format ------------------------------------------- */

typedef struct triangle_mesh {
    gphys_vec3* vertices;
    gphys_vec3* normals; /* one for each vertex, unit */
    uint32_t* indices;
    uint32_t vertex_count, index_count;
} triangle_mesh;

/* Read all meshes of a file, scaled to height 1, standing on y = 0 above the origin.
 * Returns 0, or -1 after saying on stderr what is wrong. */
int load_mesh(const char* path, triangle_mesh* out);
/* Smooth normals from the triangles, weighted by area. */
void compute_normals(triangle_mesh* mesh);
void free_mesh(triangle_mesh* mesh);

/* --- world.c: what is in the picture and how it moves ----------------------------------- */

/* The high byte of a tag is the kind of the model, the rest its number. */
enum { KIND_GROUND = 1, KIND_STATUE, KIND_COPY, KIND_STONE, KIND_POST, KIND_CLOTH, KIND_ROPE };
#define TAG(kind, number) ((uint32_t)(kind) << 24 | (uint32_t)(number))
#define TAG_KIND(tag) ((tag) >> 24)
#define TAG_NUMBER(tag) ((tag)&0xffffffu)

enum { ROPE_COUNT = 16, ROPE_LINKS = 48, CLOTH_SIDE = 72, CLOTH_TRIANGLES = 2 * (CLOTH_SIDE - 1) * (CLOTH_SIDE - 1) };

typedef struct world {
    triangle_mesh source;      /* the file's triangles, for smooth shading */
    triangle_mesh cloth;       /* the same of the cloth as it is drawn (world_thicken) */
    uint32_t* cloth_triangles; /* for each of its triangles the one of the body */
    gphys_mesh* mesh;
    gphys_scene* scene;
    gphys_solver* solver;
    gphys_body_id cloth_body;
    gphys_model_id cloth_model;
    gphys_body_id ropes[ROPE_COUNT];
    uint32_t model_count;
} world;

void world_create(world* w, const char* path, uint32_t copies);
void world_step(world* w, float frame_time);
/* Give the cloth, as it lies, a thickness for the pictures: two faces with smooth normals, and a rim. */
void world_thicken(world* w);
void world_destroy(world* w);

/* --- picture.c: one ray for each sample, in batches -------------------------------------- */

typedef struct highlight {
    gphys_model_id picked;          /* glows; 0 for none */
    const gphys_model_id* selected; /* tinted */
    uint32_t selected_count;
    float rectangle[4]; /* outline in pixels: x0 y0 x1 y1; all 0 for none */
} highlight;

/* Cast the rays of the camera's viewport (width * height pixels, 2 by 2 samples each) with a shadow
 * ray and a few ambient rays for each hit, and write a PNG. Returns the number of rays cast. */
uint64_t take_picture(const world* w, const gphys_camera* camera, uint32_t width, uint32_t height,
                      const highlight* marks, const char* path);

/* --- main.c ------------------------------------------------------------------------------ */

/* End the program with the library's message if a call failed. */
void check(gphys_status status, const char* what);
/* A bar on a terminal; nothing in a log. */
void progress(const char* what, uint32_t done, uint32_t total);
/* Threads for scenes and solvers: one for each processor of the machine, and no more than the library takes. */
enum { MAX_WORKERS = 1024 };
uint32_t worker_count(void);
double seconds(void);

#endif

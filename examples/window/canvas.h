/* What the graphics card holds of a window: two programs, the sun's shadows, four meshes that are drawn as instances,
 * and a list of corners for what is drawn once. canvas.c. */
#ifndef CANVAS_H
#define CANVAS_H

#define GL_GLEXT_PROTOTYPES
#include <SDL_opengl.h>

#include "window.h"

enum { BOX, BALL, TUBE, STATUE, PARTS, SHADOW = 2048 };

typedef struct instance {
    float rows[3][4]; /* of the matrix from the part to the world */
    float paint[4];   /* the last: 1 for the ground's pattern */
} instance;

typedef struct corner {
    gphys_vec3 at, normal;
    float paint[4];
} corner;

typedef struct part {
    GLuint shape, indices, instances, array;
    GLsizei index_count;
    instance* list;
    uint32_t count, capacity;
} part;

struct canvas {
    GLuint program, flat, shadow_map, shadow_target;
    GLuint soup, soup_array;
    part parts[PARTS];
    corner* corners;
    uint32_t corner_count, corner_capacity;
    gphys_model_id* visible;
    uint32_t visible_capacity;
};

/* A list of elements of `size` bytes with room for so many. */
void* grown(void* list, uint32_t needed, uint32_t* capacity, size_t size);

/* What the next draw_parts and draw_corners draw. */
instance* new_instance(part* p);
void put_corner(canvas* c, gphys_vec3 at, gphys_vec3 normal, colour ink, float alpha);

/* Draw the instances, or the corners as triangles, lines or points, and forget them. */
void draw_parts(canvas* c, GLuint program);
void draw_corners(canvas* c, GLenum kind);

void set_matrix(GLuint program, const char* name, const float m[16]);

#endif

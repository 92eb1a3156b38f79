/* The programs, meshes and buffers of OpenGL 3.3 that draw.c draws with. */
#include "canvas.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROUND = 24 }; /* corners around a ball or tube */

static const char* const vertex_source =
    "#version 330\n"
    "layout(location=0) in vec3 at; layout(location=1) in vec3 normal; layout(location=2) in vec4 own;\n"
    "layout(location=3) in vec4 row0; layout(location=4) in vec4 row1; layout(location=5) in vec4 row2;\n"
    "layout(location=6) in vec4 paint;\n"
    "uniform mat4 view; uniform mat4 sun_view; uniform bool instanced;\n"
    "out vec3 world, facing; out vec4 colour, in_sun;\n"
    "void main() {\n"
    "    world = at; facing = normal; colour = own;\n"
    "    if (instanced) {\n"
    "        world = vec3(dot(row0, vec4(at, 1)), dot(row1, vec4(at, 1)), dot(row2, vec4(at, 1)));\n"
    /* The cofactors turn normals: right for scale per axis too. */
    "        mat3 m = mat3(row0.xyz, row1.xyz, row2.xyz);\n"
    "        facing = vec3(dot(cross(row1.xyz, row2.xyz), normal), dot(cross(row2.xyz, row0.xyz), normal), "
    "dot(cross(row0.xyz, row1.xyz), normal));\n"
    "        colour = paint;\n"
    "    }\n"
    "    in_sun = sun_view * vec4(world, 1);\n"
    "    gl_Position = view * vec4(world, 1);\n"
    "}\n";
static const char* const fragment_source =
    "#version 330\n"
    "in vec3 world, facing; in vec4 colour, in_sun;\n"
    "uniform vec3 eye, sun; uniform sampler2DShadow shadow; uniform float haze;\n"
    "out vec4 drawn;\n"
    "void main() {\n"
    "    vec3 base = colour.rgb;\n"
    "    vec3 to_eye = normalize(eye - world);\n"
    "    vec3 n = normalize(dot(facing, to_eye) < 0.0 ? -facing : facing);\n"
    "    if (colour.a == 1.0) {\n"
    "        vec2 p = world.xz, w = fwidth(p);\n"
    "        vec2 cell = clamp((abs(fract(p * 0.5) - 0.5) - 0.25) / max(w, vec2(1e-4)) * 2.0, -1.0, 1.0);\n"
    "        base *= 1.0 + 0.06 * cell.x * cell.y * exp(-0.02 * length(eye - world));\n"
    "    }\n"
    "    vec3 s = in_sun.xyz * 0.5 + 0.5;\n"
    "    float lit = 0.0;\n"
    "    for (int i = 0; i < 9; ++i) lit += texture(shadow, vec3(s.xy + vec2(i % 3 - 1, i / 3 - 1) / 2048.0, s.z - "
    "0.0015));\n"
    "    lit = all(lessThan(abs(in_sun.xyz), vec3(1))) ? lit / 9.0 : 1.0;\n"
    "    float open = 0.5 + 0.5 * n.y;\n"
    "    vec3 light = mix(vec3(0.26, 0.25, 0.24), vec3(0.42, 0.48, 0.58), open) + lit * max(dot(n, sun), 0.0) * "
    "vec3(0.98, 0.92, 0.82);\n"
    "    float shine = lit * pow(max(dot(n, normalize(sun + to_eye)), 0.0), 40.0) * 0.18;\n"
    "    vec3 c = base * light + shine;\n"
    "    float mist = 1.0 - exp(-haze * length(eye - world));\n"
    "    drawn = vec4(mix(c, vec3(0.78, 0.85, 0.92), mist), 1);\n"
    "}\n";
static const char* const flat_vertex =
    "#version 330\n"
    "layout(location=0) in vec3 at; layout(location=2) in vec4 own; uniform mat4 view; out vec4 colour;\n"
    "void main() { colour = own; gl_Position = view * vec4(at, 1); gl_PointSize = 3.0; }\n";
static const char* const flat_fragment =
    "#version 330\nin vec4 colour; out vec4 drawn;\nvoid main() { drawn = colour; }\n";

static GLuint compiled(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    GLint good;
    char log[1024];
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        fprintf(stderr, "window: a shader is refused: %s\n", log);
        exit(1);
    }
    return shader;
}

static GLuint linked(const char* vertex, const char* fragment) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program);
    return program;
}

static void corner_layout(void) {
    for (GLuint i = 0; i < 3; ++i) {
        static const size_t places[3] = {offsetof(corner, at), offsetof(corner, normal), offsetof(corner, paint)};
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, i == 2 ? 4 : 3, GL_FLOAT, GL_FALSE, sizeof(corner), (void*)places[i]);
    }
}

static void make_part(part* p, const corner* corners, uint32_t corner_count, const uint32_t* indices,
                      uint32_t index_count) {
    if (!p->array) {
        glGenVertexArrays(1, &p->array);
        glGenBuffers(1, &p->shape);
        glGenBuffers(1, &p->indices);
        glGenBuffers(1, &p->instances);
    }
    glBindVertexArray(p->array);
    glBindBuffer(GL_ARRAY_BUFFER, p->shape);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(corner_count * sizeof *corners), corners, GL_STATIC_DRAW);
    corner_layout();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, p->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(index_count * sizeof *indices), indices, GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, p->instances);
    for (GLuint i = 0; i < 4; ++i) {
        glEnableVertexAttribArray(3 + i);
        glVertexAttribPointer(3 + i, 4, GL_FLOAT, GL_FALSE, sizeof(instance), (void*)(sizeof(float[4]) * i));
        glVertexAttribDivisor(3 + i, 1);
    }
    p->index_count = (GLsizei)index_count;
}

/* The unit box, ball and tube (radius 1, from y = 0 to 1, open). */
static void make_box(part* p) {
    corner corners[24] = {0};
    uint32_t indices[36], *out = indices;
    for (uint32_t face = 0; face < 6; ++face) {
        const uint32_t axis = face / 2;
        const float sign = face % 2 ? 1.0f : -1.0f;
        for (uint32_t k = 0; k < 4; ++k) {
            float at[3], normal[3] = {0, 0, 0};
            at[axis] = sign, normal[axis] = sign;
            at[(axis + 1) % 3] = k & 1 ? 1.0f : -1.0f, at[(axis + 2) % 3] = k & 2 ? 1.0f : -1.0f;
            corners[4 * face + k].at = (gphys_vec3){at[0], at[1], at[2]};
            corners[4 * face + k].normal = (gphys_vec3){normal[0], normal[1], normal[2]};
        }
        static const uint32_t turn[2][6] = {{0, 2, 1, 1, 2, 3}, {0, 1, 2, 2, 1, 3}};
        for (int k = 0; k < 6; ++k) *out++ = 4 * face + turn[face % 2][k];
    }
    make_part(p, corners, 24, indices, 36);
}

static void make_round(part* p, int tube) {
    enum { RINGS = ROUND / 2, COUNT = (RINGS + 1) * (ROUND + 1) };
    corner corners[COUNT] = {0};
    uint32_t indices[6 * RINGS * ROUND], *out = indices;
    const int rings = tube ? 1 : RINGS;
    for (int i = 0; i <= rings; ++i) {
        for (int j = 0; j <= ROUND; ++j) {
            const float around = 6.2831853f * (float)j / ROUND, down = 3.1415927f * (float)i / RINGS;
            const float r = tube ? 1 : sinf(down);
            const gphys_vec3 n = {r * cosf(around), tube ? 0 : cosf(down), r * sinf(around)};
            corner* c = &corners[i * (ROUND + 1) + j];
            c->normal = n;
            c->at = tube ? (gphys_vec3){n.x, (float)(1 - i), n.z} : n;
            if (i == rings || j == ROUND) continue;
            const uint32_t a = (uint32_t)(i * (ROUND + 1) + j), b = a + ROUND + 1;
            const uint32_t quad[6] = {a, a + 1, b, b, a + 1, b + 1};
            for (int k = 0; k < 6; ++k) *out++ = quad[k];
        }
    }
    make_part(p, corners, COUNT, indices, (uint32_t)(out - indices));
}

void canvas_take_mesh(canvas* c, const triangle_mesh* mesh) {
    corner* corners = calloc(mesh->vertex_count, sizeof *corners);
    if (!corners) exit(1);
    for (uint32_t i = 0; i < mesh->vertex_count; ++i)
        corners[i].at = mesh->vertices[i], corners[i].normal = mesh->normals[i];
    make_part(&c->parts[STATUE], corners, mesh->vertex_count, mesh->indices, mesh->index_count);
    free(corners);
}

canvas* canvas_create(void) {
    canvas* c = calloc(1, sizeof *c);
    if (!c) exit(1);
    c->program = linked(vertex_source, fragment_source);
    c->flat = linked(flat_vertex, flat_fragment);
    make_box(&c->parts[BOX]);
    make_round(&c->parts[BALL], 0);
    make_round(&c->parts[TUBE], 1);
    glGenVertexArrays(1, &c->soup_array);
    glGenBuffers(1, &c->soup);
    glBindVertexArray(c->soup_array);
    glBindBuffer(GL_ARRAY_BUFFER, c->soup);
    corner_layout();

    glGenTextures(1, &c->shadow_map);
    glBindTexture(GL_TEXTURE_2D, c->shadow_map);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, SHADOW, SHADOW, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glGenFramebuffers(1, &c->shadow_target);
    glBindFramebuffer(GL_FRAMEBUFFER, c->shadow_target);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, c->shadow_map, 0);
    glDrawBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glEnable(GL_PROGRAM_POINT_SIZE);
    return c;
}

void canvas_destroy(canvas* c) {
    for (int i = 0; i < PARTS; ++i) free(c->parts[i].list);
    free(c->corners);
    free(c->visible);
    free(c);
}

void* grown(void* list, uint32_t needed, uint32_t* capacity, size_t size) {
    if (needed <= *capacity) return list;
    *capacity = needed + needed / 2;
    list = realloc(list, *capacity * size);
    if (!list) exit(1);
    return list;
}

instance* new_instance(part* p) {
    p->list = grown(p->list, p->count + 1, &p->capacity, sizeof *p->list);
    return &p->list[p->count++];
}

void put_corner(canvas* c, gphys_vec3 at, gphys_vec3 normal, colour ink, float alpha) {
    c->corners = grown(c->corners, c->corner_count + 1, &c->corner_capacity, sizeof *c->corners);
    c->corners[c->corner_count++] = (corner){at, normal, {ink.r, ink.g, ink.b, alpha}};
}

void draw_parts(canvas* c, GLuint program) {
    glUniform1i(glGetUniformLocation(program, "instanced"), 1);
    for (int i = 0; i < PARTS; ++i) {
        part* p = &c->parts[i];
        if (p->count == 0) continue;
        glBindVertexArray(p->array);
        glBindBuffer(GL_ARRAY_BUFFER, p->instances);
        glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(p->count * sizeof *p->list), p->list, GL_STREAM_DRAW);
        glDrawElementsInstanced(GL_TRIANGLES, p->index_count, GL_UNSIGNED_INT, NULL, (GLsizei)p->count);
        p->count = 0;
    }
    glUniform1i(glGetUniformLocation(program, "instanced"), 0);
}

void draw_corners(canvas* c, GLenum kind) {
    if (c->corner_count == 0) return;
    glBindVertexArray(c->soup_array);
    glBindBuffer(GL_ARRAY_BUFFER, c->soup);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(c->corner_count * sizeof *c->corners), c->corners, GL_STREAM_DRAW);
    glDrawArrays(kind, 0, (GLsizei)c->corner_count);
    c->corner_count = 0;
}

void set_matrix(GLuint program, const char* name, const float m[16]) {
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, m);
}

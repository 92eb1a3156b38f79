/* A picture: for each sample the first hit, then one ray to the sun and a few into the half space
 * above the surface, all in batches of a few rows. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

#include "viewer.h"

typedef gphys_vec3 vec3;
typedef vec3 colour;

enum { AMBIENT = 4 };                             /* rays that ask how open a place is */
static const vec3 sun = {-0.62f, 0.70f, -0.354f}; /* unit */
static const colour sun_light = {2.5f, 2.3f, 2.0f}, sky_light = {0.55f, 0.68f, 0.9f};
static const float offset = 2e-3f; /* metres above a surface at which its secondary rays start */

static vec3 plus(vec3 a, vec3 b) { return (vec3){a.x + b.x, a.y + b.y, a.z + b.z}; }
static vec3 times(vec3 a, float s) { return (vec3){a.x * s, a.y * s, a.z * s}; }
static float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec3 cross(vec3 a, vec3 b) {
    return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static vec3 unit(vec3 a) { return times(a, 1 / sqrtf(dot(a, a))); }
static vec3 mix(vec3 a, vec3 b, float s) { return plus(times(a, 1 - s), times(b, s)); }
static vec3 rotated(gphys_quat q, vec3 v) {
    const vec3 u = {q.x, q.y, q.z};
    return plus(v, times(cross(u, plus(cross(u, v), times(v, q.w))), 2));
}

static float uniform(uint32_t* state) {
    *state ^= *state << 13, *state ^= *state >> 17, *state ^= *state << 5;
    return (float)(*state >> 8) / 16777216.0f;
}

/* A direction of the half space above n, denser towards n (cosine weighted). */
static vec3 above(vec3 n, uint32_t* random) {
    const float height = 2 * uniform(random) - 1, angle = 6.2831853f * uniform(random);
    const float r = sqrtf(1 - height * height);
    const vec3 d = plus(n, (vec3){r * cosf(angle), height, r * sinf(angle)});
    return dot(d, d) > 1e-6f ? unit(d) : n;
}

static colour sky(vec3 direction) {
    const colour horizon = {0.83f, 0.88f, 0.92f}, zenith = {0.35f, 0.55f, 0.85f};
    return mix(horizon, zenith, powf(fmaxf(direction.y, 0), 0.6f));
}

/* Even colours for numbers: steps of the golden angle around the hue circle. */
static colour hue(uint32_t number, float strength) {
    const float h = 2.39996323f * (float)number;
    const colour c = {0.5f + 0.5f * cosf(h), 0.5f + 0.5f * cosf(h - 2.0943951f), 0.5f + 0.5f * cosf(h + 2.0943951f)};
    return mix((colour){0.75f, 0.73f, 0.7f}, c, strength);
}

static colour cloth_pattern(uint32_t triangle) {
    const uint32_t cell = triangle / 2, column = cell % (CLOTH_SIDE - 1), row = cell / (CLOTH_SIDE - 1);
    const int warp = column / 6 % 2, weft = row / 6 % 2;
    if (warp && weft) return (colour){0.62f, 0.06f, 0.09f};
    if (warp || weft) return (colour){0.82f, 0.32f, 0.30f};
    return (colour){0.96f, 0.9f, 0.84f};
}

static colour ground_pattern(vec3 p) {
    const int checker = ((int)floorf(p.x) + (int)floorf(p.z)) & 1;
    return checker ? (colour){0.44f, 0.50f, 0.40f} : (colour){0.50f, 0.56f, 0.45f};
}

static colour surface(const world* w, const gphys_hit* hit, const highlight* marks) {
    const colour glow = {1.6f, 0.75f, 0.1f}, tint = {0.15f, 0.45f, 1.0f};
    if (hit->model == marks->picked) return glow;
    for (uint32_t i = 0; i < marks->selected_count; ++i) {
        if (marks->selected[i] == hit->model && TAG_KIND(hit->tag) == KIND_COPY) return tint;
    }
    switch (TAG_KIND(hit->tag)) {
        case KIND_GROUND:
            return ground_pattern(hit->point);
        case KIND_STATUE:
            return (colour){0.86f, 0.80f, 0.66f};
        case KIND_COPY:
            return hue(TAG_NUMBER(hit->tag), 0.45f);
        case KIND_STONE:
            return (colour){0.55f, 0.55f, 0.58f};
        case KIND_POST:
            return (colour){0.42f, 0.27f, 0.16f};
        case KIND_CLOTH:
            return cloth_pattern(w->cloth_triangles[hit->triangle]);
        default: /* a rope, of which triangles beyond the links are particles: weights */
            return hit->triangle < ROPE_LINKS ? (colour){0.85f, 0.72f, 0.42f} : (colour){0.20f, 0.21f, 0.24f};
    }
}

/* The interpolated normal of a mesh hit, the hit's own for everything else; towards the viewer. */
static vec3 smooth_normal(const world* w, const gphys_hit* hit, vec3 direction) {
    const uint32_t kind = TAG_KIND(hit->tag);
    if (kind != KIND_STATUE && kind != KIND_COPY && kind != KIND_CLOTH) return hit->normal;
    const triangle_mesh* mesh = kind == KIND_CLOTH ? &w->cloth : &w->source;
    if (kind == KIND_CLOTH && hit->triangle >= 2 * CLOTH_TRIANGLES) return hit->normal; /* the rim is flat */
    const uint32_t* corner = &mesh->indices[3 * hit->triangle];
    vec3 n = plus(times(mesh->normals[corner[0]], 1 - hit->u - hit->v),
                  plus(times(mesh->normals[corner[1]], hit->u), times(mesh->normals[corner[2]], hit->v)));
    if (dot(n, n) < 1e-6f) return hit->normal;
    gphys_transform placed;
    check(gphys_scene_get_world_transforms(w->scene, &hit->model, 1, &placed, sizeof placed), "world transform");
    n = rotated(placed.rotation, unit(n));
    return dot(n, direction) > 0 ? times(n, -1) : n;
}

/* Rays and answers of one band of rows. */
typedef struct band {
    gphys_ray *eye, *to_sun, *ambient;
    gphys_hit* hits;
    vec3* normals;
    int32_t *in_shadow, *closed_in;
} band;

static void shade_band(const world* w, const band* b, uint32_t samples, uint32_t* random) {
    const gphys_ray nowhere = {{0, -1e6f, 0}, {0, -1, 0}, 0};
    check(gphys_scene_raycast_batch(w->scene, b->eye, sizeof *b->eye, samples, GPHYS_ALL_LAYERS, b->hits,
                                    sizeof *b->hits),
          "raycast batch");
    for (uint32_t i = 0; i < samples; ++i) {
        const gphys_hit* hit = &b->hits[i];
        b->to_sun[i] = nowhere;
        for (int k = 0; k < AMBIENT; ++k) b->ambient[AMBIENT * i + k] = nowhere;
        if (!hit->model) continue;
        b->normals[i] = smooth_normal(w, hit, b->eye[i].direction);
        const vec3 start = plus(hit->point, times(hit->normal, offset));
        b->to_sun[i] = (gphys_ray){start, sun, 100};
        for (int k = 0; k < AMBIENT; ++k) {
            b->ambient[AMBIENT * i + k] = (gphys_ray){start, above(b->normals[i], random), 1.5f};
        }
    }
    check(gphys_scene_raycast_any_batch(w->scene, b->to_sun, sizeof *b->to_sun, samples, GPHYS_ALL_LAYERS, b->in_shadow,
                                        sizeof *b->in_shadow),
          "shadow batch");
    check(gphys_scene_raycast_any_batch(w->scene, b->ambient, sizeof *b->ambient, AMBIENT * samples, GPHYS_ALL_LAYERS,
                                        b->closed_in, sizeof *b->closed_in),
          "ambient batch");
}

static colour sample_colour(const world* w, const band* b, uint32_t i, const highlight* marks) {
    const gphys_hit* hit = &b->hits[i];
    const colour behind = sky(b->eye[i].direction);
    if (!hit->model) return behind;
    const colour base = surface(w, hit, marks);
    const float lit = b->in_shadow[i] ? 0 : fmaxf(dot(b->normals[i], sun), 0);
    float open = 1;
    for (int k = 0; k < AMBIENT; ++k) open -= 0.8f / AMBIENT * (float)b->closed_in[AMBIENT * i + k];
    const colour light =
        plus(times(sun_light, 0.4f * lit), times(sky_light, 0.55f * open * (0.7f + 0.3f * b->normals[i].y)));
    const colour seen = {base.x * light.x, base.y * light.y, base.z * light.z};
    return mix(seen, behind, 1 - expf(-fmaxf(hit->t - 20, 0) / 45)); /* haze */
}

static unsigned char to_byte(float linear) {
    const float s = powf(fminf(fmaxf(linear, 0), 1), 1 / 2.2f);
    return (unsigned char)(s * 255 + 0.5f);
}

static void outline(unsigned char* pixels, uint32_t width, uint32_t height, const float r[4]) {
    for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
            const float px = (float)x + 0.5f, py = (float)y + 0.5f;
            const int inside = px > r[0] && px < r[2] && py > r[1] && py < r[3];
            const int deep = px > r[0] + 2 && px < r[2] - 2 && py > r[1] + 2 && py < r[3] - 2;
            if (inside && !deep) memcpy(&pixels[3 * (y * width + x)], (unsigned char[]){30, 110, 255}, 3);
        }
    }
}

static void* allocate(size_t count, size_t size) {
    void* memory = malloc(count * size);
    check(memory ? GPHYS_OK : GPHYS_ERROR_OUT_OF_MEMORY, "picture");
    return memory;
}

uint64_t take_picture(const world* w, const gphys_camera* camera, uint32_t width, uint32_t height,
                      const highlight* marks, const char* path) {
    enum { ROWS = 8 }; /* pixel rows of a band */
    const uint32_t across = 2 * width, samples = across * 2 * ROWS;
    band b = {allocate(samples, sizeof *b.eye),
              allocate(samples, sizeof *b.to_sun),
              allocate(AMBIENT * samples, sizeof *b.ambient),
              allocate(samples, sizeof *b.hits),
              allocate(samples, sizeof *b.normals),
              allocate(samples, sizeof *b.in_shadow),
              allocate(AMBIENT * samples, sizeof *b.closed_in)};
    unsigned char* pixels = allocate((size_t)width * height, 3);
    uint32_t random = 2463534242u;
    uint64_t rays = 0;
    for (uint32_t y = 0; y < height; y += ROWS) {
        const uint32_t rows = height - y < ROWS ? height - y : ROWS;
        check(gphys_camera_pick_rays(camera, 0, 2 * y, across, 2 * rows, b.eye, sizeof *b.eye), "pick rays");
        shade_band(w, &b, across * 2 * rows, &random);
        rays += (2ull + AMBIENT) * across * 2 * rows;
        for (uint32_t row = 0; row < rows; ++row) {
            for (uint32_t x = 0; x < width; ++x) {
                const uint32_t first = 2 * row * across + 2 * x;
                const uint32_t quad[4] = {first, first + 1, first + across, first + across + 1};
                colour sum = {0, 0, 0};
                for (int k = 0; k < 4; ++k) sum = plus(sum, times(sample_colour(w, &b, quad[k], marks), 0.25f));
                unsigned char* out = &pixels[3 * ((size_t)(y + row) * width + x)];
                out[0] = to_byte(sum.x), out[1] = to_byte(sum.y), out[2] = to_byte(sum.z);
            }
        }
        progress(path, y + rows, height);
    }
    outline(pixels, width, height, marks->rectangle);
    if (!stbi_write_png(path, (int)width, (int)height, 3, pixels, (int)width * 3)) {
        fprintf(stderr, "cannot write %s\n", path);
        exit(1);
    }
    free(b.eye), free(b.to_sun), free(b.ambient), free(b.hits), free(b.normals), free(b.in_shadow), free(b.closed_in);
    free(pixels);
    return rays;
}

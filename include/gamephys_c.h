/* SPDX-FileCopyrightText: 2026 The gamephys authors
 * SPDX-License-Identifier: MIT */

/* gamephys: a 3D scene library behind a stable C interface.
 *
 * Shapes and meshes in a scene; rays, overlaps and other queries on it; a camera that culls and
 * picks; and particles, ropes and cloth that collide with it.
 *
 * CONVENTIONS, true of every function below unless its own comment says otherwise
 *
 * Units      Metres, seconds, kilograms, radians. Numbers are float32; answers are computed in
 *            double precision (exact arithmetic where the sign decides) and rounded once.
 * Range      Every coordinate, size and offset is finite and at most GPHYS_MAX_COORDINATE in
 *            magnitude. A quaternion's length is within 1e-3 of one; it stands for the exact
 *            rotation of its direction, so its length never scales anything.
 * Axes       The scene is neither left- nor right-handed and knows no "up"; gravity and a
 *            camera's handedness are settings.
 * Origin     Float coordinates count from the origin of their scene, camera or solver: a point of the
 *            world in double precision, (0, 0, 0) until gphys_scene_set_origin and the like move it.
 *            At k metres from it a float resolves 6e-8 k metres, wherever the origin is.
 * Matrices   16 floats; element (row, column) is m[4 * column + row] for column vectors. This is
 *            the memory order of OpenGL's column-major and DirectX's row-major, so both take it.
 * Pixels     (0, 0) is the top-left corner of the viewport; the centre of the first pixel is
 *            (0.5, 0.5). x goes right, y goes down.
 * Shapes     Sphere, capsule, AABB, OBB and frustum are solid; plane, triangle and mesh are
 *            surfaces; ray and segment are lines. All sets are closed: touching counts as true.
 *            There is no hidden tolerance: where one is useful it is a parameter.
 * Rays       The direction may have any non-zero length; t counts in multiples of it, and a hit
 *            has 0 <= t <= t_max. A ray that starts inside a solid hits at t = 0 with
 *            GPHYS_HIT_INSIDE set and the normal opposite to the direction.
 * Ties       Where the reported t or distance is equal, that is, equal floats in gphys_hit.t or
 *            gphys_nearest.distance, the lower id (as an unsigned number) wins, then the lower
 *            triangle index. Lists are in the order that their function states. The same
 *            inputs give the same bits.
 *
 * Status     A function that can fail returns gphys_status: GPHYS_OK is 0, an outcome that is not
 *            an error (no hit, list cut short) is positive, an error is negative. On an error
 *            outputs are untouched and the object is unchanged; gphys_last_error() explains it.
 *            The checks are the same in every build. The library never prints, aborts or throws.
 * Errors     Those below are not repeated at each function; its comment names all others.
 *            GPHYS_ERROR_INVALID_ARGUMENT for NULL where that is not allowed, NaN, a number outside
 *            its range, an unknown type or a wrong stride; GPHYS_ERROR_INVALID_ID for the id of
 *            something that does not exist; GPHYS_ERROR_STRUCT_SIZE for a desc that was not
 *            initialised or uses what a later release added; GPHYS_ERROR_OUT_OF_MEMORY from
 *            functions that allocate, which are those that create, add, or say so.
 * Cost       Time. n is the number of models of a scene, of triangles of a mesh or of an array's
 *            elements, k the number of results; O(1) depends on none of them.
 * Handles    gphys_mesh, gphys_scene, gphys_camera and gphys_solver belong to the caller:
 *            create / destroy; destroying NULL does nothing.
 * Ids        uint32_t, 0 is none. A removed id stays invalid for at least 260 000 additions: a
 *            slot is reused only while 1024 or more are free, in the order of removal and with
 *            another generation. Only an object with almost 2^24 - 1 ids in use reuses slots sooner.
 * Descs      Structs named *_desc start with struct_size. Fill one with its *_desc_init function,
 *            passing sizeof; then change any fields except those named reserved. They grow at the end
 *            in later releases; old clients keep working. All other structs never change.
 * Lists      (out, capacity, out_total): writes at most capacity elements to out, and the number of
 *            all results to *out_total. capacity 0 with out NULL only counts. GPHYS_INCOMPLETE when
 *            *out_total > capacity; which elements are kept is stated, never arbitrary. Elements of out behind
 *            the last result may be overwritten, up to capacity.
 * Batches    (array, stride, ..., count): stride is the distance between elements in bytes; 0
 *            means that one element is used throughout; it is not allowed for the positions of several particles. An
 *            input stride must be 0 or at least the element's size, an output stride at least the element's size, both
 *            multiples of 4. A count of 0 is no error: arrays may then be NULL, and strides are not looked at.
 *            All elements are checked before any output is written. Item i of a batch is bit for
 *            bit what the single call would give. No element of an output may share memory with an
 *            element of an input.
 * Memory     Queries of scenes, meshes and shapes allocate nothing. Nothing that the library returns
 *            has to be freed except handles. Arrays are copied in and copied out, never kept.
 * Threads    Different objects: any threads. One object: functions that take it as const may run
 *            at the same time; all others need external synchronisation. No thread is started unless a
 *            worker_count asks for it (gphys_scene_create and gphys_solver_create say which calls
 *            share the threads). Callbacks come on the thread that called the library, never on a worker. A call takes
 *            at most 36 KiB of stack, a batch of rays or nearest points 68, a step 48, besides what callbacks take.
 * Host       Each call computes in the standard floating-point modes, whatever the thread has set, and
 *            leaves the thread in its own: rounding to nearest, denormal numbers kept (on x86 neither
 *            FTZ nor DAZ). So does each task of a task_runner. Callbacks run in the standard modes.
 *            Floating-point exceptions stay raised.
 */
#ifndef GAMEPHYS_C_H
#define GAMEPHYS_C_H

#include <stddef.h>
#include <stdint.h>

#ifndef GPHYS_API
#if defined(_WIN32) && !defined(GAMEPHYS_STATIC)
#ifdef GAMEPHYS_BUILD
#define GPHYS_API __declspec(dllexport)
#else
#define GPHYS_API __declspec(dllimport)
#endif
#elif defined(__GNUC__) && defined(GAMEPHYS_BUILD)
#define GPHYS_API __attribute__((visibility("default")))
#else
#define GPHYS_API
#endif
#endif

#define GPHYS_VERSION_MAJOR 1
#define GPHYS_VERSION_MINOR 1
#define GPHYS_VERSION_PATCH 0

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------
 * Status and version
 * ------------------------------------------------------------------------------------------ */

typedef int32_t gphys_status;
enum {
    GPHYS_OK = 0,
    GPHYS_NO_HIT = 1,                  /* the query found nothing; outputs untouched */
    GPHYS_INCOMPLETE = 2,              /* more results than the caller's array holds */
    GPHYS_UNBOUNDED = 3,               /* the answer is infinite (bounds of a plane); outputs untouched */
    GPHYS_ERROR_INVALID_ARGUMENT = -1, /* null, NaN, infinite, out of range, wrong stride, ... */
    GPHYS_ERROR_INVALID_ID = -2,       /* no such model, body, constraint or joint, or no longer */
    GPHYS_ERROR_STRUCT_SIZE = -3,      /* a desc not initialised, or newer than this library */
    GPHYS_ERROR_OUT_OF_MEMORY = -4,
    GPHYS_ERROR_CAPACITY = -5,    /* more than a limit, 2^24 - 1 unless the function says another */
    GPHYS_ERROR_CYCLE = -6,       /* a model would become its own ancestor */
    GPHYS_ERROR_UNSUPPORTED = -7, /* the operation has no meaning for this kind of shape */
    GPHYS_ERROR_SINGULAR = -8,    /* a matrix without an inverse */
    GPHYS_ERROR_INTERNAL = -100   /* a defect of the library; please report it */
};

/** Version of the loaded library as major << 16 | minor << 8 | patch. It may differ from that of the header
 *  (GPHYS_VERSION_...): one of the same major version that is earlier lacks functions and desc fields.
 *  Threads: any. Cost: O(1). */
GPHYS_API uint32_t gphys_version(void);

/** Name of a status, such as "GPHYS_NO_HIT"; "unknown" for other values. Static string, never NULL.
 *  Threads: any. Cost: O(1). */
GPHYS_API const char* gphys_status_name(gphys_status status);

/** What the last failed call on this thread objected to: one English sentence, UTF-8, at most 255
 *  bytes, empty before the first error. The text is overwritten by the next error on this thread
 *  and kept by successful calls. Threads: each has its own. Cost: O(1). */
GPHYS_API const char* gphys_last_error(void);

/** Memory functions for one object and everything in it. Both are called on the thread that calls
 *  the library, from several threads if the objects that share it are used from several threads.
 *  Neither may be NULL. allocate returns NULL on failure (reported as GPHYS_ERROR_OUT_OF_MEMORY, nothing changed);
 *  release gets the same size and alignment again, a power of two. The struct is copied at creation; what user points
 *  to must outlive the object. C++ functions may throw: allocate then failed, and what release throws is ignored. */
typedef struct gphys_allocator {
    void* (*allocate)(void* user, size_t size, size_t alignment);
    void (*release)(void* user, void* memory, size_t size, size_t alignment);
    void* user;
} gphys_allocator;

/** One part of a call's work: the function to call, with the context and an index. Any thread may
 *  call it; it returns when that part is done, without calling back. */
typedef void (*gphys_task)(void* context, uint32_t index);

/** The caller's own threads (a job system). run calls task(context, 0) .. task(context, count - 1),
 *  each once, in any order, on any threads, several at a time or not, and returns when all have
 *  returned. It is called on the thread that called the library, and by several threads at the same time
 *  if several call the library. It must not call functions of the scene or solver whose work it runs.
 *  The struct is copied at creation. A function in C++ may throw, if no call of task begins after that; the
 *  thread that called the library waits for those under way and does what is left, and the results are the
 *  same. */
typedef struct gphys_task_runner {
    void (*run)(void* user, gphys_task task, void* context, uint32_t count);
    void* user;
} gphys_task_runner;

/* ------------------------------------------------------------------------------------------
 * Values. Frozen: their layout never changes. All fields are four bytes wide.
 * ------------------------------------------------------------------------------------------ */

typedef struct gphys_vec3 {
    float x, y, z;
} gphys_vec3;

typedef struct gphys_quat {
    float x, y, z, w; /* rotation of angle a about unit axis n: (n sin(a/2), cos(a/2)) */
} gphys_quat;

typedef struct gphys_mat4 {
    float m[16]; /* element (row, column) is m[4 * column + row] */
} gphys_mat4;

/** x -> position + rotation * (scale * x); scale > 0. */
typedef struct gphys_transform {
    gphys_vec3 position;
    gphys_quat rotation;
    float scale;
} gphys_transform;

typedef struct gphys_ray {
    gphys_vec3 origin;
    gphys_vec3 direction; /* any non-zero length */
    float t_max;          /* >= 0, in multiples of direction; INFINITY allowed */
} gphys_ray;

typedef struct gphys_segment {
    gphys_vec3 a, b; /* may coincide: a point */
} gphys_segment;

typedef struct gphys_sphere {
    gphys_vec3 center;
    float radius; /* >= 0 */
} gphys_sphere;

/** All points within radius of the segment a b. */
typedef struct gphys_capsule {
    gphys_vec3 a, b; /* may coincide: a sphere */
    float radius;    /* >= 0 */
} gphys_capsule;

typedef struct gphys_aabb {
    gphys_vec3 min, max; /* min <= max on each axis; equality gives a flat box */
} gphys_aabb;

typedef struct gphys_obb {
    gphys_vec3 center;
    gphys_vec3 half_extents; /* >= 0, along the axes of rotation */
    gphys_quat rotation;
} gphys_obb;

/** The points x with dot(normal, x) = distance. The normal points to the front; it need not be
 *  exactly unit: signed distances are divided by its length (for a unit normal, distance is the
 *  plane's distance from the origin). distance divided by that length is within the range of
 *  coordinates too. */
typedef struct gphys_plane {
    gphys_vec3 normal; /* not zero */
    float distance;
} gphys_plane;

/** May be degenerate: then it is the segment or point that its corners span. The normal is that
 *  of cross(b - a, c - a). */
typedef struct gphys_triangle {
    gphys_vec3 a, b, c;
} gphys_triangle;

/** The points x with dot(planes[i].normal, x - origin) >= planes[i].distance for all six planes,
 *  which look inward, in the order of GPHYS_FRUSTUM_NEAR, FAR and so on. Distances count from origin, so that a
 *  frustum far out loses nothing to rounding. An infinite far plane is normal 0, distance -1. */
typedef struct gphys_frustum {
    gphys_vec3 origin;
    gphys_plane planes[6];
} gphys_frustum;

enum {
    GPHYS_FRUSTUM_NEAR = 0,
    GPHYS_FRUSTUM_FAR = 1,
    GPHYS_FRUSTUM_LEFT = 2,
    GPHYS_FRUSTUM_RIGHT = 3,
    GPHYS_FRUSTUM_BOTTOM = 4,
    GPHYS_FRUSTUM_TOP = 5
};

#define GPHYS_MAX_COORDINATE 1e15f
#define GPHYS_NO_TRIANGLE 0xffffffffu
#define GPHYS_NO_PARTICLE 0xffffffffu
#define GPHYS_ALL_LAYERS 0xffffffffu

enum {
    GPHYS_HIT_INSIDE = 1, /* the ray or the swept sphere started inside or touching: t is 0 */
    GPHYS_HIT_BACK = 2    /* a surface was met from behind its normal */
};

/** Where a ray, segment or swept sphere first meets something. */
typedef struct gphys_hit {
    uint32_t model;    /* id of the model, 0 when the query was not of a scene */
    uint32_t tag;      /* the model's tag, 0 likewise */
    float t;           /* 0 .. t_max; along a segment or sweep 0 .. 1 */
    gphys_vec3 point;  /* where the surfaces meet */
    gphys_vec3 normal; /* unit, against the motion: dot(normal, direction) <= 0, for rays up to rounding */
    uint32_t triangle; /* index within a mesh, else GPHYS_NO_TRIANGLE */
    float u, v;        /* barycentric weights of b and c of a triangle, else 0 */
    uint32_t flags;    /* GPHYS_HIT_... */
} gphys_hit;

/** The closest point of something to a given point. */
typedef struct gphys_nearest {
    uint32_t model; /* as in gphys_hit */
    uint32_t tag;
    gphys_vec3 point;  /* equal to the query point when that is inside a solid */
    float distance;    /* 0 inside a solid */
    uint32_t triangle; /* index within a mesh, else GPHYS_NO_TRIANGLE */
} gphys_nearest;

/** How far a ray goes and what it hits: fields of a gphys_hit. Frozen.  Since 1.1. */
typedef struct gphys_distance {
    float t;        /* in multiples of the direction, so metres where its length is 1; INFINITY: nothing is hit */
    uint32_t model; /* as in gphys_hit */
    uint32_t triangle;
} gphys_distance;

/** How a solid gets out of something that it overlaps. */
typedef struct gphys_penetration {
    uint32_t model; /* as in gphys_hit */
    uint32_t tag;
    gphys_vec3 point;  /* on what is overlapped: where the two touch when the solid has gone depth along normal */
    gphys_vec3 normal; /* unit: the way out, from what is overlapped to the solid */
    float depth;       /* metres along normal; 0 for shapes that touch */
    uint32_t triangle; /* index within a mesh, else GPHYS_NO_TRIANGLE */
} gphys_penetration;

/** Says which struct a `const void* shape` points to. */
typedef int32_t gphys_shape_type;
enum {
    GPHYS_SHAPE_SPHERE = 1,   /* gphys_sphere */
    GPHYS_SHAPE_CAPSULE = 2,  /* gphys_capsule */
    GPHYS_SHAPE_AABB = 3,     /* gphys_aabb */
    GPHYS_SHAPE_OBB = 4,      /* gphys_obb */
    GPHYS_SHAPE_PLANE = 5,    /* gphys_plane */
    GPHYS_SHAPE_TRIANGLE = 6, /* gphys_triangle */
    GPHYS_SHAPE_FRUSTUM = 7,  /* gphys_frustum */
    GPHYS_SHAPE_MESH = 8,     /* gphys_mesh: the handle itself; a convex hull too */
    GPHYS_SHAPE_RAY = 16,     /* gphys_ray */
    GPHYS_SHAPE_SEGMENT = 17  /* gphys_segment */
};

typedef struct gphys_mesh gphys_mesh;
typedef struct gphys_scene gphys_scene;
typedef struct gphys_camera gphys_camera;
typedef struct gphys_solver gphys_solver;

/* ------------------------------------------------------------------------------------------
 * Shapes: questions about single primitives and meshes, without a scene.
 * A shape is passed as its type and a pointer to its struct. Meshes are taken in their own
 * coordinates. Cost: 5 to 500 ns for primitives, 0.5 to 20 us for overlaps of frusta, O(log n + k)
 * expected for meshes of n triangles. No allocation. Threads: any, everything is const.
 * ------------------------------------------------------------------------------------------ */

/** Whether the fields of the shape are in the ranges stated beside its struct.
 *  @return GPHYS_OK, or GPHYS_ERROR_INVALID_ARGUMENT and gphys_last_error() names the field.
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_shape_validate(gphys_shape_type type, const void* shape);

/** The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
 *  @return GPHYS_OK; GPHYS_UNBOUNDED for a plane, a ray without end (or with one beyond all floats)
 *          and a frustum that extends to infinity; GPHYS_NO_HIT for an empty mesh or frustum
 *  Cost: O(1), for a mesh too. */
GPHYS_API gphys_status gphys_shape_bounds(gphys_shape_type type, const void* shape, gphys_aabb* out_bounds);

/** Move a shape. Error: each float of the result within 1 ulp of its largest coordinate.
 *  @param transform  scale > 0
 *  @param out_shape  same struct as shape, except that an AABB becomes a gphys_obb; may be shape
 *                    itself where the types agree. A ray's t_max is kept (its direction scales).
 *  @return GPHYS_ERROR_UNSUPPORTED for a mesh; GPHYS_ERROR_INVALID_ARGUMENT if the result leaves
 *          the range of coordinates
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_shape_transform(gphys_shape_type type, const void* shape, const gphys_transform* transform,
                                             void* out_shape);

/** Whether the point is within tolerance metres of the shape (solid or surface).
 *  With tolerance 0 the answer is exact: on the plane, on the segment, inside the box (an OBB's
 *  axes are those of its rotation in double precision). Others are as gphys_shape_overlaps with a sphere.
 *  @param tolerance     metres, >= 0
 *  @param out_contains  0 or 1
 *  Cost: O(1); O(log n) expected for a mesh. */
GPHYS_API gphys_status gphys_shape_contains(gphys_shape_type type, const void* shape, const gphys_vec3* point,
                                            float tolerance, int32_t* out_contains);
/** Whether each of count points is within tolerance metres of one shape, as gphys_shape_contains.
 *  @param points        a stride of 0 asks for one point count times
 *  @param tolerance     metres, >= 0, for all points
 *  @param out_contains  count elements, each 0 or 1
 *  Cost: that of count single calls. */
GPHYS_API gphys_status gphys_shape_contains_batch(gphys_shape_type type, const void* shape, const gphys_vec3* points,
                                                  uint32_t point_stride, uint32_t count, float tolerance,
                                                  int32_t* out_contains, uint32_t out_stride);

/** The point of the shape that is closest to the given point: the point itself inside a solid.
 *  Error: 1 ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest
 *  coordinate difference. If several are equally close, one of them,
 *  always the same. For a ray, t is limited by t_max.
 *  @return GPHYS_NO_HIT only for an empty mesh or an empty frustum.
 *  Cost: O(1); O(log n) expected for a mesh. */
GPHYS_API gphys_status gphys_shape_closest_point(gphys_shape_type type, const void* shape, const gphys_vec3* point,
                                                 gphys_nearest* out_nearest);
/** The points of one shape that are closest to each of count points, as gphys_shape_closest_point. An
 *  element for which there is none gets distance INFINITY.
 *  @param points       a stride of 0 asks for one point count times
 *  @param out_nearest  count elements
 *  Cost: that of count single calls. */
GPHYS_API gphys_status gphys_shape_closest_point_batch(gphys_shape_type type, const void* shape,
                                                       const gphys_vec3* points, uint32_t point_stride, uint32_t count,
                                                       gphys_nearest* out_nearest, uint32_t out_stride);

/** The closest points of two segments and their distance. Parallel segments have many: the first
 *  along a, always the same.
 *  @param out_a         may be NULL; metres
 *  @param out_b         may be NULL; metres
 *  @param out_distance  may be NULL; metres
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_segment_closest_points(const gphys_segment* a, const gphys_segment* b, gphys_vec3* out_a,
                                                    gphys_vec3* out_b, float* out_distance);

/** Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane,
 *  triangle, frustum and mesh, in either order.
 *  A mesh is its surface: a sphere deep inside a closed mesh does not overlap it. A convex hull
 *  (gphys_mesh_create_hull) is solid.
 *  Exact between AABBs, planes, triangles, meshes and frusta; other pairs are decided in double
 *  precision and may err only where the gap is below 2^-40 of the largest coordinate difference.
 *  @return GPHYS_ERROR_UNSUPPORTED for a ray or segment (see gphys_shape_segment_test).
 *  Cost: 5 to 500 ns, 0.5 to 20 us with a frustum; O(log n + k) expected with a mesh. */
GPHYS_API gphys_status gphys_shape_overlaps(gphys_shape_type a_type, const void* a, gphys_shape_type b_type,
                                            const void* b, int32_t* out_overlaps);
/** Whether the shapes of each of count pairs overlap, as gphys_shape_overlaps: pair i is a[i] against b[i].
 *  @param a             shapes of one type; a stride of 0 tests one shape against many, and a mesh needs 0
 *  @param b             shapes of one type; a stride of 0 tests one shape against many, and a mesh needs 0
 *  @param out_overlaps  count elements, each 0 or 1
 *  @return GPHYS_ERROR_UNSUPPORTED for rays and segments
 *  Cost: that of count single calls. */
GPHYS_API gphys_status gphys_shape_overlaps_batch(gphys_shape_type a_type, const void* a, uint32_t a_stride,
                                                  gphys_shape_type b_type, const void* b, uint32_t b_stride,
                                                  uint32_t count, int32_t* out_overlaps, uint32_t out_stride);

/** On which side something is of a plane or a frustum. */
typedef int32_t gphys_side;
enum {
    GPHYS_SIDE_OUTSIDE = -1, /* wholly behind the plane, wholly outside the frustum */
    GPHYS_SIDE_CROSSING = 0, /* touches or crosses the boundary */
    GPHYS_SIDE_INSIDE = 1    /* wholly in front of the plane, wholly inside the frustum */
};

/** Classify a sphere, capsule, AABB, OBB or triangle against a plane.
 *  @param out_signed_distance  metres, of the shape's nearest point to the plane: > 0 in front, < 0
 *                              behind, 0 when crossing; may be NULL
 *  @return GPHYS_ERROR_UNSUPPORTED for other types of shapes
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_shape_classify_plane(gphys_shape_type type, const void* shape, const gphys_plane* plane,
                                                  gphys_side* out_side, float* out_signed_distance);

/** Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means
 *  that no point is shared, inside that the frustum holds the whole shape.
 *  @return GPHYS_ERROR_UNSUPPORTED for other types of shapes
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_shape_classify_frustum(gphys_shape_type type, const void* shape,
                                                    const gphys_frustum* frustum, gphys_side* out_side);

/** First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh.
 *  Triangles and meshes are hit from both sides, and meshes are watertight: a ray through a
 *  shared edge or vertex always meets one of the triangles there.
 *  Error: t within 1 ulp. No false miss and no false hit at all for spheres, triangles, meshes, AABBs
 *  and planes; for capsules only within 2^-48 of the distance. An OBB is hit as if it were larger or
 *  smaller by up to 2^-40 of the distance. docs/accuracy.md has the bounds of all functions.
 *  @return GPHYS_OK or GPHYS_NO_HIT; GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape
 *  Cost: O(1); O(log n) expected for a mesh. */
GPHYS_API gphys_status gphys_shape_raycast(gphys_shape_type type, const void* shape, const gphys_ray* ray,
                                           gphys_hit* out_hit);
/** First hits of count rays with one shape, as gphys_shape_raycast. A ray that hits nothing gets
 *  t = INFINITY, triangle = GPHYS_NO_TRIANGLE and zeros in its out_hits element.
 *  @param rays      a stride of 0 casts one ray count times
 *  @param out_hits  count elements
 *  @return GPHYS_OK, whether rays hit or not; GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape
 *  Cost: that of count single calls; less for rays at a mesh if neighbouring rays are similar. */
GPHYS_API gphys_status gphys_shape_raycast_batch(gphys_shape_type type, const void* shape, const gphys_ray* rays,
                                                 uint32_t ray_stride, uint32_t count, gphys_hit* out_hits,
                                                 uint32_t out_stride);

/** First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly.
 *  A segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid,
 *  for lack of a direction, the normal is zero.
 *  @return GPHYS_OK or GPHYS_NO_HIT; GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape
 *  Cost: as gphys_shape_raycast. */
GPHYS_API gphys_status gphys_shape_segment_test(gphys_shape_type type, const void* shape, const gphys_segment* segment,
                                                gphys_hit* out_hit);

/** First contact of a sphere that moves by displacement with a sphere, capsule, AABB, OBB, plane,
 *  triangle, frustum or mesh.
 *  @param displacement  metres; may be zero
 *  @param out_hit  t in 0..1 of the displacement; point: of contact, on the shape; normal: from
 *                  the point to the sphere's centre; in double precision its dot with the
 *                  displacement is never above 0. Already overlapping: t = 0, GPHYS_HIT_INSIDE,
 *                  and the normal may be along the displacement too; where the centre itself is in
 *                  a solid, it is opposite to the displacement (zero if that is zero). A sphere
 *                  of radius 0 gets the hit of the ray along its path.
 *  @return GPHYS_OK or GPHYS_NO_HIT; GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape
 *  Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
 *  Cost: O(1), about 10 us for a frustum, which is approached step by step; O(log n + k) expected for a mesh. */
GPHYS_API gphys_status gphys_shape_sweep_sphere(gphys_shape_type type, const void* shape, const gphys_sphere* sphere,
                                                const gphys_vec3* displacement, gphys_hit* out_hit);

/** First contact of a sphere, capsule, AABB or OBB that moves by displacement, without turning, with a
 *  sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. A frustum, unless a sphere moves, must be
 *  the hull of its corners (gphys_frustum_corners).
 *  @param moving_type   sphere, capsule, AABB or OBB
 *  @param displacement  metres; may be zero
 *  @param out_hit  t, point and normal as in gphys_shape_sweep_sphere, which gives the answer for a sphere.
 *                  The point is one of those where the two touch, always the same. Already overlapping,
 *                  except for a sphere: t = 0, GPHYS_HIT_INSIDE, and point and normal of
 *                  gphys_shape_penetration; for a mesh that is not a hull, those of its first triangle.
 *  @return GPHYS_OK or GPHYS_NO_HIT; GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape, for a
 *          frustum that is not the hull of its corners, unless a sphere moves, and for other types that move
 *  Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1 ulp of t. Point
 *  and normal are those of that contact.
 *  Cost: O(1), 0.1 to 2 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. */
GPHYS_API gphys_status gphys_shape_sweep(gphys_shape_type type, const void* shape, gphys_shape_type moving_type,
                                         const void* moving, const gphys_vec3* displacement, gphys_hit* out_hit);

/** First contacts of count moving shapes of one type with count shapes of another, as gphys_shape_sweep: moving[i] with
 *  shapes[i]. One that touches nothing gets t = INFINITY, triangle = GPHYS_NO_TRIANGLE and zeros.
 *  @param shapes         shapes of one type; a stride of 0 takes one throughout, and a mesh needs 0
 *  @param moving         shapes of one type; a stride of 0 takes one throughout, and a mesh needs 0
 *  @param moving_type    sphere, capsule, AABB or OBB
 *  @param displacements  metres; a stride of 0 moves all alike
 *  @param out_hits       count elements
 *  @return GPHYS_ERROR_UNSUPPORTED as gphys_shape_sweep
 *  Cost: that of count single calls.  Since 1.1. */
GPHYS_API gphys_status gphys_shape_sweep_batch(gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                                               gphys_shape_type moving_type, const void* moving, uint32_t moving_stride,
                                               const gphys_vec3* displacements, uint32_t displacement_stride,
                                               uint32_t count, gphys_hit* out_hits, uint32_t out_stride);

/** The shortest translation that takes a sphere, capsule, AABB or OBB out of a sphere, capsule, AABB,
 *  OBB, plane, triangle or frustum: to where the two just touch, on the side of a plane or triangle that is nearer.
 *  Of a mesh: out of the triangle that it is deepest in; others may remain, and have translations of their own. Of a
 *  hull: out of all of it, and triangle is GPHYS_NO_TRIANGLE. A frustum must be the hull of its corners
 *  (gphys_frustum_corners).
 *  @param moving_type      sphere, capsule, AABB or OBB
 *  @param out_penetration  depth and normal of the translation, which is their product; of several equally
 *                          short ones always the same one. The deepest point of the solid is
 *                          point - depth * normal.
 *  @return GPHYS_OK if gphys_shape_overlaps says that they overlap, else GPHYS_NO_HIT;
 *          GPHYS_ERROR_UNSUPPORTED for rays, segments, frusta that are not the hull of their corners, and for
 *          other types that move
 *  Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1 ulp of
 *  depth; by 2^-32 where the centre or axis of a round solid is closer than that to the other shape.
 *  Added to float positions, the translation may leave an overlap as large as the spacing of floats there.
 *  Cost: O(1), 0.1 to 1 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. Boxes by separating axes
 *  (Gottschalk 1996), round solids by the distance of their core (Gilbert, Johnson, Keerthi 1988). */
GPHYS_API gphys_status gphys_shape_penetration(gphys_shape_type type, const void* shape, gphys_shape_type moving_type,
                                               const void* moving, gphys_penetration* out_penetration);

/** The shortest translations that take count shapes of one type out of count shapes of another, as
 *  gphys_shape_penetration: moving[i] out of shapes[i]. One that overlaps nothing gets depth = -INFINITY,
 *  triangle = GPHYS_NO_TRIANGLE and zeros.
 *  @param shapes            shapes of one type; a stride of 0 takes one throughout, and a mesh needs 0
 *  @param moving            shapes of one type; a stride of 0 takes one throughout, and a mesh needs 0
 *  @param moving_type       sphere, capsule, AABB or OBB
 *  @param out_penetrations  count elements
 *  @return GPHYS_ERROR_UNSUPPORTED as gphys_shape_penetration
 *  Cost: that of count single calls.  Since 1.1. */
GPHYS_API gphys_status gphys_shape_penetration_batch(gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                                                     gphys_shape_type moving_type, const void* moving,
                                                     uint32_t moving_stride, uint32_t count,
                                                     gphys_penetration* out_penetrations, uint32_t out_stride);

/** The eight corners, each the intersection of three planes: near then far, each in the order
 *  left-bottom, right-bottom, right-top, left-top.
 *  A frustum is the convex hull of its corners (the intersections themselves, not rounded to floats) if each
 *  is within GPHYS_MAX_COORDINATE and in front of the three planes that do not meet there, by more than 2^-39
 *  of its distance from origin; that is, unless it is empty, flat, unbounded or ends in a tip. Solids are swept
 *  against such a frustum and pushed out of it; for the bounds of their errors, origin counts as a corner.
 *  @return GPHYS_UNBOUNDED if three planes do not meet in a point (infinite far plane), or meet
 *          beyond the largest float
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_frustum_corners(const gphys_frustum* frustum, gphys_vec3 out_corners[8]);

/** The point that three planes have in common, within an ulp of each coordinate.
 *  @return GPHYS_NO_HIT if the planes have no single point in common, which is decided exactly, or one beyond
 *          GPHYS_MAX_COORDINATE
 *  Cost: O(1).  Source: Cramer's rule.  Since 1.1. */
GPHYS_API gphys_status gphys_planes_intersection(const gphys_plane* a, const gphys_plane* b, const gphys_plane* c,
                                                 gphys_vec3* out_point);
/** The points of count triples of planes, as gphys_planes_intersection; one without gets x = y = z = INFINITY.
 *  @param a           count planes; a stride of 0 takes one for all
 *  @param b           count planes; a stride of 0 takes one for all
 *  @param c           count planes; a stride of 0 takes one for all
 *  @param out_points  count elements
 *  Cost: that of count single calls.  Since 1.1. */
GPHYS_API gphys_status gphys_planes_intersection_batch(const gphys_plane* a, uint32_t a_stride, const gphys_plane* b,
                                                       uint32_t b_stride, const gphys_plane* c, uint32_t c_stride,
                                                       uint32_t count, gphys_vec3* out_points, uint32_t out_stride);

/** How far the axes of a matrix (its first three columns without the last row) are from orthonormal: the largest
 *  |a_i . a_j - d_ij|, where d_ij is 1 for i = j, else 0. 0 for the identity, below 2^-22 for the matrices that a
 *  camera gives, about 2e for axes that are too long by a fraction e.
 *  @param matrix  elements within GPHYS_MAX_COORDINATE
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_mat4_orthonormality(const gphys_mat4* matrix, float* out_deviation);

/** Depth range of clip space. */
typedef int32_t gphys_depth_range;
enum {
    GPHYS_DEPTH_ZERO_TO_ONE = 0,     /* DirectX, Vulkan, Metal, WebGPU */
    GPHYS_DEPTH_MINUS_ONE_TO_ONE = 1 /* OpenGL, WebGL */
};

/** The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
 *  origin (0, 0, 0). For a camera, gphys_camera_get_frustum is more precise.
 *  @param reverse_z  0: near has the low depth; 1: near has the high depth
 *  @return GPHYS_ERROR_SINGULAR if the matrix has no inverse, or what it shows has no volume: its four near
 *          corners are not all finite points in front of the viewer
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_frustum_from_matrix(const gphys_mat4* view_projection, gphys_depth_range depth_range,
                                                 int32_t reverse_z, gphys_frustum* out_frustum);

/* ------------------------------------------------------------------------------------------
 * Mesh: a triangle surface with its own tree, or the solid convex hull of points. Immutable, so one
 * mesh can serve many models, scenes and threads; one that is deformable takes other vertices for
 * the same triangles. It is a shape: gphys_shape_* functions take it as GPHYS_SHAPE_MESH.
 * ------------------------------------------------------------------------------------------ */

/** What is in a triangle array. Frozen. */
typedef struct gphys_mesh_report {
    uint32_t triangle_count;
    uint32_t degenerate_count;   /* triangles of exactly zero area */
    uint32_t first_degenerate;   /* index of the first, or GPHYS_NO_TRIANGLE */
    uint32_t out_of_range_count; /* triangles with an index >= vertex_count */
    uint32_t first_out_of_range;
    uint32_t bad_vertex_count; /* vertices that are not finite or beyond GPHYS_MAX_COORDINATE */
    uint32_t first_bad_vertex; /* or 0xffffffff */
    uint32_t open_edge_count;  /* edges that do not join exactly two triangles; 0 for a closed mesh */
} gphys_mesh_report;

/** Examine arrays without building anything. Allocates while it runs.
 *  @param vertices       vertex_count elements of 3 floats, metres
 *  @param vertex_stride  bytes between vertices, at least 12
 *  @param indices        index_count numbers, three for each triangle
 *  @param out_report     what was found; indices out of range and bad vertices are counted, not refused
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for an index_count that is no multiple of 3
 *  Cost: O(n log n). */
GPHYS_API gphys_status gphys_mesh_check(const float* vertices, uint32_t vertex_stride, uint32_t vertex_count,
                                        const uint32_t* indices, uint32_t index_count, gphys_mesh_report* out_report);

typedef struct gphys_mesh_desc {
    uint32_t struct_size;
    const gphys_allocator* allocator; /* NULL: the C++ runtime's */
    int32_t deformable;               /* 1: gphys_mesh_set_vertices will be called; 12 bytes a vertex more. Since 1.1 */
    uint32_t reserved;                /* 0 */
} gphys_mesh_desc;

/** Fill a desc with the defaults of gphys_mesh_create.
 *  @param size  sizeof(gphys_mesh_desc) of the caller; no byte beyond is written
 *  @return GPHYS_ERROR_STRUCT_SIZE for a size below that of release 1.0, or beyond 65536
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_mesh_desc_init(gphys_mesh_desc* desc, uint32_t size);

/** Build a mesh from copies of the arrays. Triangles of zero area are kept: queries treat them
 *  as the segments or points that they are, and the report counts them. 0 triangles are allowed.
 *  @param desc  may be NULL
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for an index out of range, an index_count that is no
 *          multiple of 3 or a bad vertex; gphys_mesh_check tells which.
 *  Cost: O(n log n), about 1 us per triangle. */
GPHYS_API gphys_status gphys_mesh_create(const gphys_mesh_desc* desc, const float* vertices, uint32_t vertex_stride,
                                         uint32_t vertex_count, const uint32_t* indices, uint32_t index_count,
                                         gphys_mesh** out_mesh);

/** Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used wherever a mesh can:
 *  gphys_shape_* functions, models of scenes, snapshots, and solvers, whose particles stay outside and are pushed out.
 *  A ray that starts inside hits at t = 0 with GPHYS_HIT_INSIDE; one from outside hits the face through which it
 *  enters, `triangle` says where. Whether a ray hits and whether a point is inside is exact with respect to the points.
 *  Inside, the closest point is the point itself and triangle GPHYS_NO_TRIANGLE. gphys_mesh_overlap lists the triangles
 *  of the surface; gphys_mesh_raycast_all gives only the first hit. The vertices are the points that are corners of
 *  the hull, in their original order; of equal points the first. The triangles come face by face, all that lie in one
 *  plane being one face; seen from outside their corners go counterclockwise where axes are right-handed, and the
 *  normal cross(b - a, c - a) points out.
 *  @param desc          may be NULL; deformable must be 0
 *  @param points        point_count elements of 3 floats, metres; copied
 *  @param point_stride  bytes between points, at least 12
 *  @return GPHYS_ERROR_INVALID_ARGUMENT if a point is out of range or if all lie in a plane, which is decided exactly;
 *          GPHYS_ERROR_CAPACITY if the hull has more than 256 faces; GPHYS_ERROR_UNSUPPORTED if desc asks for a
 *          deformable mesh
 *  Cost: O(point_count * faces); allocates. Rays take O(log faces), other queries up to O(faces).
 *  Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates.  Since 1.1. */
GPHYS_API gphys_status gphys_mesh_create_hull(const gphys_mesh_desc* desc, const float* points, uint32_t point_stride,
                                              uint32_t point_count, gphys_mesh** out_mesh);
/** The planes of a hull's faces: normals are unit and point out, within float32 rounding. Kept when too many: the
 *  first.
 *  @return GPHYS_ERROR_UNSUPPORTED for a mesh that is no hull
 *  Cost: O(faces).  Since 1.1. */
GPHYS_API gphys_status gphys_mesh_get_hull_planes(const gphys_mesh* mesh, gphys_plane* out_planes, uint32_t capacity,
                                                  uint32_t* out_total);
/** For each triangle of a hull the index of its face in the list of gphys_mesh_get_hull_planes, ascending
 *  from 0. Kept when too many: the first.
 *  @return GPHYS_ERROR_UNSUPPORTED for a mesh that is no hull
 *  Cost: O(triangles).  Since 1.1. */
GPHYS_API gphys_status gphys_mesh_get_hull_faces(const gphys_mesh* mesh, uint32_t* out_faces, uint32_t capacity,
                                                 uint32_t* out_total);

/** Replace the vertices of a deformable mesh, such as a skinned character, or cloth as gphys_solver_get_positions
 *  writes it. All models of the mesh take the new form at once, in every scene, and all answers have the same bits as
 *  those of a mesh created from the new vertices. A call that fails leaves the mesh and the scenes as they
 *  were. A solver sees the new form at its next step, as a surface that stands still.
 *  @param vertices       vertex_count elements of 3 floats, metres; copied
 *  @param vertex_stride  bytes between vertices, at least 12
 *  @param vertex_count   as at creation
 *  @return GPHYS_ERROR_UNSUPPORTED if the mesh is not deformable; GPHYS_ERROR_INVALID_ARGUMENT for a vertex that is not
 *          finite or too large, or if a model of the mesh would reach beyond the range of coordinates
 *  Threads: an edit of the mesh and of every scene that has a model of it: not beside other calls on these.
 *  Cost: O(vertices + triangles + log n for each model), a few per cent of creating it: the tree is refitted, and parts
 *  that have degraded are rebuilt. If the triangles have moved apart so far that the boxes of their groups of eight
 *  have twice the area, once as much as creating it. Allocates.  Since 1.1. */
GPHYS_API gphys_status gphys_mesh_set_vertices(gphys_mesh* mesh, const float* vertices, uint32_t vertex_stride,
                                               uint32_t vertex_count);

/** Release a reference to a mesh; NULL does nothing. The handle is invalid once all have been released: one from the
 *  function that created the mesh, and one from each gphys_scene_get_mesh. Models that use the mesh
 *  keep it alive as long as they exist.
 *  Cost: O(1); O(n) to free a mesh that no model uses. */
GPHYS_API void gphys_mesh_destroy(gphys_mesh* mesh);

/** What a mesh consists of. */
typedef int32_t gphys_mesh_kind;
enum {
    GPHYS_MESH_SURFACE = 0,      /* triangles */
    GPHYS_MESH_BODY_SURFACE = 1, /* the triangles of a cloth: gphys_mesh_create_from_body */
    GPHYS_MESH_BODY_LINKS = 2,   /* the links and particles of a rope, or free particles: likewise */
    GPHYS_MESH_HULL = 3          /* a solid: gphys_mesh_create_hull */
};

/** What a mesh is. Frozen.  Since 1.1. */
typedef struct gphys_mesh_info {
    gphys_mesh_kind kind;
    uint32_t vertex_count;
    uint32_t triangle_count;
    int32_t deformable;   /* 1: as gphys_mesh_desc.deformable, or in the form of a body */
    int32_t follows_body; /* 1: its form comes from a body, not from gphys_mesh_set_vertices */
} gphys_mesh_info;

/** Kind and size of a mesh, and whether its vertices change. Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_mesh_get_info(const gphys_mesh* mesh, gphys_mesh_info* out_info);
/** What the mesh was built from: the report that gphys_mesh_check makes of its arrays.
 *  Cost: O(1); O(triangles) for a deformable mesh. */
GPHYS_API gphys_status gphys_mesh_get_report(const gphys_mesh* mesh, gphys_mesh_report* out_report);
/** Copy the vertices out, in metres and in their original order. Kept when too many: the first.
 *  Cost: O(vertices). */
GPHYS_API gphys_status gphys_mesh_get_vertices(const gphys_mesh* mesh, gphys_vec3* out_vertices, uint32_t capacity,
                                               uint32_t* out_total);
/** Copy the indices out, three for each triangle, in their original order. Kept when too many: the first.
 *  *out_total counts indices, not triangles.
 *  Cost: O(n). */
GPHYS_API gphys_status gphys_mesh_get_indices(const gphys_mesh* mesh, uint32_t* out_indices, uint32_t capacity,
                                              uint32_t* out_total);

/** Copy a mesh out with its tree, from which gphys_mesh_create_from_snapshot makes it without building the tree.
 *  @param out_words  the snapshot; written as a whole, or not at all when capacity is too small. Words are in the
 *                    machine's byte order. Every later release of the same major version reads it.
 *  @return GPHYS_INCOMPLETE when *out_total > capacity; GPHYS_ERROR_CAPACITY beyond 2^32 - 1 words
 *  Threads: any. Cost: O(n), some 24 bytes and 5 ns for each triangle; no allocation. */
GPHYS_API gphys_status gphys_mesh_get_snapshot(const gphys_mesh* mesh, uint32_t* out_words, uint32_t capacity,
                                               uint32_t* out_total);
/** Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the snapshot.
 *  Any words are safe, also from an untrusted source: vertices, indices and the tree are checked, and what follows
 *  from them is computed. Forged words are refused, or taken as a mesh like any other; only the counts of its report
 *  (triangles of zero area, open edges) are taken from the words as they are.
 *  @param desc  may be NULL; with `deformable` the mesh takes new vertices, even if the one in the snapshot did not
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for words that are no snapshot of a mesh, damaged, of a later format or of
 *          another byte order; GPHYS_ERROR_UNSUPPORTED for a deformable hull
 *  Cost: O(n), a small part of gphys_mesh_create's; allocates. */
GPHYS_API gphys_status gphys_mesh_create_from_snapshot(const gphys_mesh_desc* desc, const uint32_t* words,
                                                       uint32_t word_count, gphys_mesh** out_mesh);

/** All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
 *  Kept when the array is too small: the first ones.
 *  @return GPHYS_OK (also for 0 hits)
 *  Cost: O(log n + k) expected. */
GPHYS_API gphys_status gphys_mesh_raycast_all(const gphys_mesh* mesh, const gphys_ray* ray, gphys_hit* out_hits,
                                              uint32_t capacity, uint32_t* out_total);

/** Whether a ray hits anything; cheaper than the closest hit.
 *  @param out_hit  0 or 1
 *  Cost: O(log n) expected. */
GPHYS_API gphys_status gphys_mesh_raycast_any(const gphys_mesh* mesh, const gphys_ray* ray, int32_t* out_hit);
/** Whether each of count rays hits anything, as gphys_mesh_raycast_any.
 *  @param rays      a stride of 0 casts one ray count times
 *  @param out_hits  count elements, each 0 or 1
 *  Cost: that of count single calls; less if neighbouring rays are similar.  Since 1.1. */
GPHYS_API gphys_status gphys_mesh_raycast_any_batch(const gphys_mesh* mesh, const gphys_ray* rays, uint32_t ray_stride,
                                                    uint32_t count, int32_t* out_hits, uint32_t out_stride);
/** How far each of count rays goes, and which triangle it hits: t and triangle of gphys_shape_raycast_batch for the
 *  mesh, with the same bits, without the rest of a hit; model is 0.
 *  @param rays           a stride of 0 casts one ray count times
 *  @param out_distances  count elements; a ray that hits nothing gets t = INFINITY and
 *                        triangle = GPHYS_NO_TRIANGLE
 *  Cost: less than that of gphys_shape_raycast_batch.  Since 1.1. */
GPHYS_API gphys_status gphys_mesh_raycast_distance_batch(const gphys_mesh* mesh, const gphys_ray* rays,
                                                         uint32_t ray_stride, uint32_t count,
                                                         gphys_distance* out_distances, uint32_t out_stride);

/** Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
 *  ascending. Kept when the array is too small: the lowest.
 *  @return GPHYS_ERROR_UNSUPPORTED for other types of shapes
 *  Cost: O(log n + k) expected. */
GPHYS_API gphys_status gphys_mesh_overlap(const gphys_mesh* mesh, gphys_shape_type type, const void* shape,
                                          uint32_t* out_triangles, uint32_t capacity, uint32_t* out_total);

/** How an octree is made up: a tree of boxes around the models of a scene or the triangles of a mesh, with at most
 *  eight children a node (a bounding volume hierarchy). It has no cells, and no size or depth to choose. Frozen. */
typedef struct gphys_octree_stats {
    uint32_t item_count;      /* models or triangles in the tree */
    uint32_t unbounded_count; /* models of infinite extent, kept beside the tree */
    uint32_t node_count;
    uint32_t leaf_count;
    uint32_t depth;        /* levels; 0 when empty */
    uint32_t rebuilds;     /* times it was rebuilt as a whole by one call since creation */
    float cost;            /* expected node and item tests of a random ray that meets the root box */
    uint32_t memory_bytes; /* of the tree; saturates at 2^32 - 1 */
} gphys_octree_stats;

/** One box of an octree, for drawing. Frozen. */
typedef struct gphys_octree_box {
    gphys_aabb bounds;
    uint32_t depth;      /* 0 is the root */
    uint32_t item_count; /* 0 for an inner node */
} gphys_octree_box;

/** How the mesh's octree is made up. Cost: O(nodes). */
GPHYS_API gphys_status gphys_mesh_get_octree_stats(const gphys_mesh* mesh, gphys_octree_stats* out_stats);
/** Boxes of the mesh's octree, each parent before its children. Kept when too many: the first.
 *  Cost: O(nodes). */
GPHYS_API gphys_status gphys_mesh_get_octree_boxes(const gphys_mesh* mesh, gphys_octree_box* out_boxes,
                                                   uint32_t capacity, uint32_t* out_total);

/* ------------------------------------------------------------------------------------------
 * Scene: models (a shape or a shared mesh, placed by a transform) in an octree that keeps itself
 * up to date: each change is seen by the next query.
 *
 * A model's transform is relative to its parent, to the world without one. World transforms of
 * children are computed in double precision and rounded to float32; queries are exact with
 * respect to that rounded transform, which gphys_scene_get_world_transforms returns.
 *
 * In the world, a model's scale is from 1e-15 to 1e15 and its box within 2^52 of the origin. A
 * change that would leave this range, for the model or for a descendant, is refused with
 * GPHYS_ERROR_INVALID_ARGUMENT.
 * ------------------------------------------------------------------------------------------ */

typedef uint32_t gphys_model_id;

typedef struct gphys_scene_desc {
    uint32_t struct_size;
    const gphys_allocator* allocator;     /* NULL: the C++ runtime's */
    uint32_t reserve_models;              /* models to make room for at once; 0 */
    const gphys_task_runner* task_runner; /* provides the worker_count threads; NULL: the scene's own */
    uint32_t worker_count; /* threads for one call, including the caller's, at most 1024; 0 and 1: that alone */
    uint32_t reserved;     /* must be 0 */
} gphys_scene_desc;

/** Fill a desc with the defaults of gphys_scene_create, which are stated beside its fields.
 *  @param size  sizeof(gphys_scene_desc) of the caller; no byte beyond is written
 *  @return GPHYS_ERROR_STRUCT_SIZE for a size below that of release 1.0, or beyond 65536
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_scene_desc_init(gphys_scene_desc* desc, uint32_t size);
/** Create a scene without models.
 *  With a worker_count of n, all batch queries of the scene (gphys_camera_pick_batch too), and
 *  adding and moving many models, share their work among n threads; the results have the same bits
 *  for every n. Without a task_runner n - 1 threads are started here and joined when
 *  the scene is destroyed. They serve one call at a time: calls made meanwhile run on their
 *  own thread alone. They take no signals but faults, and have the standard floating-point settings.
 *  In a child of fork they are gone: calls there run on one thread, as they do on a
 *  platform without threads (WebAssembly, unless built for shared memory), whatever is asked for.
 *  @param desc  NULL: the defaults
 *  @return GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started; GPHYS_ERROR_CAPACITY if
 *          reserve_models is above 2^24 - 1
 *  Cost: O(reserve_models), and that of starting the threads. */
GPHYS_API gphys_status gphys_scene_create(const gphys_scene_desc* desc, gphys_scene** out_scene);
/** Destroy a scene and its models; NULL does nothing. Handles and ids are invalid from then on. Joins its
 *  worker threads. No other call on the scene may be under way.
 *  Cost: O(n). */
GPHYS_API void gphys_scene_destroy(gphys_scene* scene);

/** Change the number of threads that share the calls of a scene, for example when the user changes a setting. They are
 *  those of its task_runner if it was created with one. In a child of fork they are started again. Answers keep their
 *  bits.
 *  @param workers  as gphys_scene_desc.worker_count
 *  @return GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started; the former ones are kept
 *  Cost: that of joining the former threads and starting others; allocates.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_set_worker_count(gphys_scene* scene, uint32_t workers);
/** How many threads share the calls of a scene: 1 or more, 1 on a platform without threads.
 *  In a child of fork it is still the number that was set, though calls run on one thread.
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_scene_get_worker_count(const gphys_scene* scene, uint32_t* out_workers);

/** Move the point of the world that all coordinates of the scene are relative to, those passed to it
 *  and those that it returns. Models stay where they are in the world: the positions of those without
 *  a parent become what they are from there, kept in double precision and rounded to float32 once,
 *  however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
 *  and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
 *  @param origin  x, y, z in the world, within GPHYS_MAX_COORDINATE; before the first call 0 0 0
 *  @return GPHYS_ERROR_INVALID_ARGUMENT also if a model would leave the range of coordinates
 *  Cost: that of gphys_scene_set_transforms of all models, and 24 bytes a model from the first call
 *  on. Queries cost nothing more. Allocates. */
GPHYS_API gphys_status gphys_scene_set_origin(gphys_scene* scene, const double origin[3]);
/** Where in the world the scene's coordinates count from. Cost: O(1). */
GPHYS_API gphys_status gphys_scene_get_origin(const gphys_scene* scene, double out_origin[3]);

typedef struct gphys_model_desc {
    uint32_t struct_size;
    gphys_model_id parent; /* 0: none */
    uint32_t layers;       /* a query with mask m sees the model if layers & m; default 1 */
    uint32_t tag;          /* any number of the caller's, returned with each hit; 0 */
    gphys_vec3 scale;      /* as gphys_scene_set_scale sets it; 1 1 1, and 0 0 0 is the same. Since 1.1 */
} gphys_model_desc;

/** Fill a desc with the defaults of gphys_scene_add, which are stated beside its fields.
 *  @param size  sizeof(gphys_model_desc) of the caller; no byte beyond is written
 *  @return GPHYS_ERROR_STRUCT_SIZE for a size below that of release 1.0, or beyond 65536
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_model_desc_init(gphys_model_desc* desc, uint32_t size);

/** Add a model.
 *  @param type       sphere, capsule, AABB, OBB, plane, triangle or mesh (a hull too)
 *  @param shape      in the model's own coordinates
 *  @param transform  local; NULL is the identity
 *  @param desc       NULL: no parent, layer 1, tag 0
 *  @return GPHYS_ERROR_UNSUPPORTED for another type, or a scale that the shape cannot have
 *          (gphys_scene_set_scale), GPHYS_ERROR_INVALID_ID for a stale parent, GPHYS_ERROR_CAPACITY beyond
 *          2^24 - 1 models
 *  Cost: O(log n) amortised. */
GPHYS_API gphys_status gphys_scene_add(gphys_scene* scene, gphys_shape_type type, const void* shape,
                                       const gphys_transform* transform, const gphys_model_desc* desc,
                                       gphys_model_id* out_model);

/** Add count models of one type, all or none, as gphys_scene_add does one.
 *  @param shapes      in the models' own coordinates; a stride of 0 shares one shape, and a mesh needs 0
 *  @param transforms  local; a stride of 0 shares one; NULL is the identity
 *  @param desc        for all; NULL: no parent, layer 1, tag 0
 *  @param out_models  count elements
 *  @return as gphys_scene_add
 *  Cost: O(count log n), less with workers; a rebuild of the octree, O(n log n), where count is of the order of n. */
GPHYS_API gphys_status gphys_scene_add_batch(gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                             uint32_t shape_stride, const gphys_transform* transforms,
                                             uint32_t transform_stride, uint32_t count, const gphys_model_desc* desc,
                                             gphys_model_id* out_models);
/** Add count models of one type, all or none, each with a desc of its own.
 *  @param shapes      in the models' own coordinates; a stride of 0 shares one shape, and a mesh needs 0
 *  @param transforms  local; a stride of 0 shares one; NULL is the identity
 *  @param descs       one for each; a stride of 0 takes one for all; NULL: no parent, layer 1, tag 0. Parents are
 *                     models that the scene has before the call
 *  @param out_models  count elements
 *  @return as gphys_scene_add; GPHYS_ERROR_STRUCT_SIZE as for a single desc
 *  Cost: as gphys_scene_add_batch; with a stride of descs that is not 0, 28 bytes a model are allocated for the
 *  time of the call. */
GPHYS_API gphys_status gphys_scene_add_described_batch(gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                                       uint32_t shape_stride, const gphys_transform* transforms,
                                                       uint32_t transform_stride, const gphys_model_desc* descs,
                                                       uint32_t desc_stride, uint32_t count,
                                                       gphys_model_id* out_models);

/** Remove a model. Its children stay where they are in the world and lose their parent.
 *  Cost: O(log n) amortised, and O(1) a child. Renews the octree as far as there is memory. */
GPHYS_API gphys_status gphys_scene_remove(gphys_scene* scene, gphys_model_id model);
/** Remove models, all or none.
 *  @param models  count ids; an id that appears twice is GPHYS_ERROR_INVALID_ID
 *  Cost: that of count calls of gphys_scene_remove. Renews the octree as far as there is memory. */
GPHYS_API gphys_status gphys_scene_remove_batch(gphys_scene* scene, const gphys_model_id* models, uint32_t count);
/** Remove a model and all its descendants. Cost: O(log n) amortised for each.
 *  Renews the octree as far as there is memory. */
GPHYS_API gphys_status gphys_scene_remove_subtree(gphys_scene* scene, gphys_model_id model);
/** Remove all models. Ids given out before stay invalid. Cost: O(n). */
GPHYS_API gphys_status gphys_scene_clear(gphys_scene* scene);

/** Whether an id names a model of this scene.
 *  @return GPHYS_OK if it does, else GPHYS_ERROR_INVALID_ID
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_scene_has(const gphys_scene* scene, gphys_model_id model);
/** Ids of all models, ascending. Kept when too many: the lowest. Cost: O(n). */
GPHYS_API gphys_status gphys_scene_get_models(const gphys_scene* scene, gphys_model_id* out_models, uint32_t capacity,
                                              uint32_t* out_total);

/** What a model is. Frozen. */
typedef struct gphys_model_info {
    gphys_shape_type type;
    gphys_model_id parent; /* 0: none */
    uint32_t layers;
    uint32_t tag;
    uint32_t child_count; /* direct children */
} gphys_model_info;

/** Ids of all models without a parent, ascending. Kept when too many: the lowest. Cost: O(n). */
GPHYS_API gphys_status gphys_scene_get_roots(const gphys_scene* scene, gphys_model_id* out_models, uint32_t capacity,
                                             uint32_t* out_total);
/** Ids of the direct children of a model, ascending. Kept when too many: the lowest.
 *  Cost: O(k log k). */
GPHYS_API gphys_status gphys_scene_get_children(const gphys_scene* scene, gphys_model_id model,
                                                gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total);
/** Kind, parent, layers, tag and number of children of a model. Cost: O(1). */
GPHYS_API gphys_status gphys_scene_get_info(const gphys_scene* scene, gphys_model_id model, gphys_model_info* out_info);
/** Copy a model's shape as it was given, in its own coordinates and without its scale.
 *  @param out_shape  has room for the struct of the model's type (gphys_scene_get_info)
 *  @param out_size   that room, in bytes
 *  @return GPHYS_ERROR_UNSUPPORTED for a mesh (gphys_scene_get_mesh)
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_scene_get_shape(const gphys_scene* scene, gphys_model_id model, void* out_shape,
                                             uint32_t out_size);
/** A handle of a model's mesh: of the mesh itself, not of a copy, so that what gphys_mesh_set_vertices does to it is
 *  seen by all its models. It gives the meshes of a restored scene, which are not deformable if they were embedded in
 *  its snapshot.
 *  @param out_mesh  a reference of its own, which keeps the mesh alive, and is to be destroyed like any handle
 *  @return GPHYS_ERROR_UNSUPPORTED if the model's shape is no mesh
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_scene_get_mesh(const gphys_scene* scene, gphys_model_id model, gphys_mesh** out_mesh);
/** World box of a model, by which queries find it: contains the model, and is wider by at most 3 ulps and
 *  2^-19 of the sum of its sizes. That of an empty mesh is its position.
 *  @return GPHYS_UNBOUNDED for a plane
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_scene_get_bounds(const gphys_scene* scene, gphys_model_id model, gphys_aabb* out_bounds);
/** World box of all bounded models. Planes are left out.
 *  @return GPHYS_NO_HIT if there are none
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_scene_get_scene_bounds(const gphys_scene* scene, gphys_aabb* out_bounds);

/** Give a model another shape, or another mesh, of any type that gphys_scene_add takes: a character
 *  crouches, a level of detail changes, a wall breaks. Its id, parent, children, tag, layers, scale and
 *  transforms stay. Sleeping bodies near it wake, and particles that are inside then come out as they do
 *  of any solid.
 *  @param shape  as in gphys_scene_add: a struct, copied, or a mesh with GPHYS_SHAPE_MESH. The scene holds the new mesh
 *                and no longer the old one, which may be the same.
 *  @return GPHYS_ERROR_UNSUPPORTED for a frustum, ray or segment, and for a shape that cannot have the
 *          model's scale (gphys_scene_set_scale); GPHYS_ERROR_INVALID_ARGUMENT also if the model would leave
 *          the range of the world; GPHYS_ERROR_OUT_OF_MEMORY
 *  Cost: as gphys_scene_set_transform of a model without children, whatever the size of a mesh. */
GPHYS_API gphys_status gphys_scene_set_shape(gphys_scene* scene, gphys_model_id model, gphys_shape_type type,
                                             const void* shape);

/** Scale a model's own shape along the three axes of the model, before its transform: a tree grows, a unit box
 *  becomes a wall, a rock is stretched. Every query, and solvers, see the scaled shape; normals are those of
 *  its surface. Children and attached particles (gphys_solver_attach) are not affected: they follow the transform,
 *  whose scale is one number. A new scale replaces the old one. No scale mirrors: for that, negate a coordinate
 *  of a mesh's vertices and swap two corners of each triangle.
 *    There is no form for many models: three equal numbers belong in their transforms (gphys_scene_set_transforms),
 *  and gphys_scene_add_described_batch takes a scale for each model that it adds.
 *    A mesh or a hull is scaled exactly, without a copy: answers are those of a mesh of the scaled vertices.
 *  Of a box or a triangle each number is multiplied and rounded to float32. A sphere, capsule or plane, and an
 *  OBB whose own rotation is not the identity, take three equal numbers only.
 *  @param scale  x, y, z, each from 1e-15 to 1e15
 *  @return GPHYS_ERROR_UNSUPPORTED for numbers that are not equal where they have to be, and for the mesh of a
 *          rope or of particles (gphys_mesh_create_from_body) unless it is 1 1 1; GPHYS_ERROR_INVALID_ARGUMENT
 *          also if a coordinate of the scaled shape would exceed GPHYS_MAX_COORDINATE, if a number times that of
 *          a mesh's world transform is not from 1e-15 to 1e15, or if the model would leave the range of the world;
 *          GPHYS_ERROR_OUT_OF_MEMORY
 *  Cost: as gphys_scene_set_transform of a model without children. Models that have a scale take 16 bytes more if
 *  they are meshes, else 52, up to the highest id. Queries of a scaled mesh or hull take 1 to 11 % more; rays at a
 *  mesh that is flattened to a twentieth take 1.3 times those at a mesh of the scaled vertices, whose tree is made for
 *  that form. */
GPHYS_API gphys_status gphys_scene_set_scale(gphys_scene* scene, gphys_model_id model, const gphys_vec3* scale);
/** The scale of a model's own shape, 1 1 1 unless another was set. Cost: O(1). */
GPHYS_API gphys_status gphys_scene_get_scale(const gphys_scene* scene, gphys_model_id model, gphys_vec3* out_scale);

/** Change which queries see a model: those with a mask m of which layers & m is not 0. Children are not
 *  affected.
 *  @param layers  any mask; 0: no query sees it
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_scene_set_layers(gphys_scene* scene, gphys_model_id model, uint32_t layers);
/** Change the number that a model's hits report beside its id. Children are not affected.
 *  @param tag  any number of the caller's
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_scene_set_tag(gphys_scene* scene, gphys_model_id model, uint32_t tag);

/** Make a model the child of another one, or of none (0).
 *  @param keep_world  0: the local transform is kept, the model jumps; 1: the local transform is
 *                     changed so that the world transform stays (within float32 rounding)
 *  @return GPHYS_ERROR_CYCLE if parent is the model or one of its descendants
 *  Cost: O(depth of the tree of models), and as gphys_scene_set_transform for what moves.
 *  Renews the octree as far as there is memory. */
GPHYS_API gphys_status gphys_scene_set_parent(gphys_scene* scene, gphys_model_id model, gphys_model_id parent,
                                              int32_t keep_world);

/** Set a model's local transform. Descendants follow.
 *  @param transform  relative to the parent; scale > 0
 *  @return GPHYS_ERROR_INVALID_ARGUMENT also if it, or a descendant, would leave the range of the world
 *  Cost: O(log n) for each model that moves. Renews the octree as far as there is memory. */
GPHYS_API gphys_status gphys_scene_set_transform(gphys_scene* scene, gphys_model_id model,
                                                 const gphys_transform* transform);
/** Set the local transforms of many models, all or none; a model that appears twice gets the last.
 *  Descendants follow.
 *  @param models      count ids
 *  @param transforms  as in gphys_scene_set_transform; a stride of 0 gives all the same
 *  Cost: O(log n) for each model that moves when few move, O(n) when many do; less with workers.
 *  Renews the octree as far as there is memory. */
GPHYS_API gphys_status gphys_scene_set_transforms(gphys_scene* scene, const gphys_model_id* models,
                                                  const gphys_transform* transforms, uint32_t transform_stride,
                                                  uint32_t count);
/** Local transforms of count models, as they were set: relative to the parent.
 *  @param models          count ids; an id may appear twice
 *  @param out_transforms  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_scene_get_transforms(const gphys_scene* scene, const gphys_model_id* models,
                                                  uint32_t count, gphys_transform* out_transforms, uint32_t out_stride);
/** World transforms of count models: with those of all ancestors applied, rounded to float32. Answers of
 *  queries are exact with respect to these.
 *  @param models          count ids; an id may appear twice
 *  @param out_transforms  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_scene_get_world_transforms(const gphys_scene* scene, const gphys_model_id* models,
                                                        uint32_t count, gphys_transform* out_transforms,
                                                        uint32_t out_stride);

/* Queries. `layers` is a mask, GPHYS_ALL_LAYERS sees everything. All of them are const, allocate nothing and take
 * O(log n + k) expected; n and k count hidden models, too (but see gphys_scene_nearest). The batch forms answer item
 * i as the single call does; where that would return GPHYS_NO_HIT the element gets model = 0, t or distance =
 * INFINITY, triangle = GPHYS_NO_TRIANGLE and zeros, and the batch returns GPHYS_OK. Similar rays of a batch take a
 * fraction of the time if they are neighbours in the array, or are in rows as in an image.
 */

/** Closest model on a ray; the fields are exact as in gphys_shape_raycast.
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: O(log n) expected; no allocation. */
GPHYS_API gphys_status gphys_scene_raycast(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers,
                                           gphys_hit* out_hit);
/** Closest models on count rays, as gphys_scene_raycast; a ray that hits nothing gets model = 0 and
 *  t = INFINITY.
 *  @param rays      a stride of 0 casts one ray count times
 *  @param out_hits  count elements
 *  Cost: at most that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_raycast_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                                 uint32_t count, uint32_t layers, gphys_hit* out_hits,
                                                 uint32_t out_stride);
/** How far each of count rays goes, and what it hits: t, model and triangle of gphys_scene_raycast_batch, with the
 *  same bits, without the rest of a hit. For lidars and depth images.
 *  @param rays           a stride of 0 casts one ray count times
 *  @param out_distances  count elements; a ray that hits nothing gets t = INFINITY, model = 0 and
 *                        triangle = GPHYS_NO_TRIANGLE
 *  Cost: less than that of gphys_scene_raycast_batch; shared among workers.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_raycast_distance_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                          uint32_t ray_stride, uint32_t count, uint32_t layers,
                                                          gphys_distance* out_distances, uint32_t out_stride);

/** Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.
 *  @param out_hit  0 or 1
 *  Cost: O(log n) expected. */
GPHYS_API gphys_status gphys_scene_raycast_any(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers,
                                               int32_t* out_hit);
/** Whether each of count rays meets anything, as gphys_scene_raycast_any.
 *  @param rays      a stride of 0 casts one ray count times
 *  @param out_hits  count elements, each 0 or 1
 *  Cost: at most that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_raycast_any_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                     uint32_t ray_stride, uint32_t count, uint32_t layers,
                                                     int32_t* out_hits, uint32_t out_stride);

/** Every model that a ray meets, each once with its first hit, by t, then id. Kept when too many:
 *  the first. Cost: O(log n + k log k) expected. */
GPHYS_API gphys_status gphys_scene_raycast_all(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers,
                                               gphys_hit* out_hits, uint32_t capacity, uint32_t* out_total);
/** Every model that each of count rays meets, as gphys_scene_raycast_all: the hits of ray i are at
 *  out_hits[out_offsets[i]] up to out_offsets[i + 1].
 *  @param rays         a stride of 0 casts one ray count times
 *  @param out_offsets  count + 1 numbers, always complete, so that a second call can have enough
 *                      room. Where a ray's range crosses capacity, its first hits are written.
 *  The contents of out_hits behind the last hit are unspecified.
 *  @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_raycast_all_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                     uint32_t ray_stride, uint32_t count, uint32_t layers,
                                                     gphys_hit* out_hits, uint32_t capacity, uint32_t* out_offsets);

/** Closest model along a segment from a to b, both included; t in 0..1. Fields as in
 *  gphys_shape_segment_test.
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: O(log n) expected. */
GPHYS_API gphys_status gphys_scene_segment_test(const gphys_scene* scene, const gphys_segment* segment, uint32_t layers,
                                                gphys_hit* out_hit);
/** Closest models along count segments, as gphys_scene_segment_test; one that hits nothing gets
 *  model = 0 and t = INFINITY.
 *  @param segments  a stride of 0 tests one segment count times
 *  @param out_hits  count elements
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_segment_test_batch(const gphys_scene* scene, const gphys_segment* segments,
                                                      uint32_t segment_stride, uint32_t count, uint32_t layers,
                                                      gphys_hit* out_hits, uint32_t out_stride);

/** Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum, as
 *  gphys_shape_overlaps, ascending. Kept when the array is too small: the lowest.
 *  @return GPHYS_ERROR_UNSUPPORTED for other types of shapes
 *  Cost: O(log n + k) expected, and O(k log k) to order hundreds of ids. Room in out_models for n / 32 + 64 more saves
 *  most of that, unless many models have replaced removed ones; it is used as scratch memory. */
GPHYS_API gphys_status gphys_scene_overlap(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                           uint32_t layers, gphys_model_id* out_models, uint32_t capacity,
                                           uint32_t* out_total);
/** Ids of all models that each of count shapes of one type overlaps, as gphys_scene_overlap: those of shape
 *  i are at out_models[out_offsets[i]] up to out_offsets[i + 1], as in gphys_scene_raycast_all_batch.
 *  @param shapes       a stride of 0 asks for one shape count times
 *  @param out_offsets  count + 1 numbers, always complete
 *  @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity; GPHYS_ERROR_UNSUPPORTED as there
 *  Cost: at most that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_overlap_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                                 uint32_t shape_stride, uint32_t count, uint32_t layers,
                                                 gphys_model_id* out_models, uint32_t capacity, uint32_t* out_offsets);

/** Ids of all models whose world box is not wholly outside any of a frustum's six planes or its own
 *  box, ascending: for drawing. No visible model is missed. Some invisible ones near the frustum's
 *  edges are listed, too: a few per cent more where models are compact or not rotated; about a third
 *  more where they are long or flat and rotated, so that their world boxes are mostly empty, and as
 *  many again as are visible where they are as long as the view is wide. gphys_scene_overlap leaves
 *  these out by testing the shapes.
 *  Kept when too many: the lowest. In scenes of more than 130 000 models, room for n / 32 more ids than
 *  are listed is best: it is used to order them. Cost: O(log n + k) expected. */
GPHYS_API gphys_status gphys_scene_cull(const gphys_scene* scene, const gphys_frustum* frustum, uint32_t layers,
                                        gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total);

/** Ids of the models in each of count frusta, as gphys_scene_cull: for split screens, cascades of shadow maps, faces of
 *  a cube map, many sensors. Those of frustum i are at out_models[out_offsets[i]] up to out_offsets[i + 1], as in
 *  gphys_scene_raycast_all_batch.
 *  @param frusta       a stride of 0 asks for one frustum count times
 *  @param out_offsets  count + 1 numbers, always complete
 *  @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity
 *  Cost: that of count single calls; shared among workers.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_cull_batch(const gphys_scene* scene, const gphys_frustum* frusta,
                                              uint32_t frustum_stride, uint32_t count, uint32_t layers,
                                              gphys_model_id* out_models, uint32_t capacity, uint32_t* out_offsets);

/** The model nearest to a point, and its closest point.
 *  @param max_distance  metres, >= 0, INFINITY allowed; a model at exactly this distance counts
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: O(log n) expected if all models are in the layers. Otherwise those that are not, and are nearer than the
 *  answer, are visited in vain, until it is faster to test all models in the layers. That takes time for them, for
 *  n / 64 words, and for 64 words where one of 64 consecutive models is in the layers. So the nearest of 10 or of 1000
 *  among 100 000 models takes some 3 us, and of 100 some 15 us. */
GPHYS_API gphys_status gphys_scene_nearest(const gphys_scene* scene, const gphys_vec3* point, float max_distance,
                                           uint32_t layers, gphys_nearest* out_nearest);
/** The models nearest to count points, as gphys_scene_nearest; a point with none gets model = 0 and
 *  distance = INFINITY.
 *  @param points        a stride of 0 asks for one point count times
 *  @param max_distance  metres, >= 0, INFINITY allowed, for all points
 *  @param out_nearest   count elements
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_nearest_batch(const gphys_scene* scene, const gphys_vec3* points,
                                                 uint32_t point_stride, uint32_t count, float max_distance,
                                                 uint32_t layers, gphys_nearest* out_nearest, uint32_t out_stride);

/** First model that a sphere touches while it moves by displacement; t in 0..1.
 *  Fields as in gphys_shape_sweep_sphere.
 *  @param displacement  metres; may be zero
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: O(log n + k) expected, k the models that the swept box touches. */
GPHYS_API gphys_status gphys_scene_sweep_sphere(const gphys_scene* scene, const gphys_sphere* sphere,
                                                const gphys_vec3* displacement, uint32_t layers, gphys_hit* out_hit);
/** First models that count spheres touch while each moves by its displacement, as
 *  gphys_scene_sweep_sphere; one that touches nothing gets model = 0 and t = INFINITY.
 *  @param spheres        a stride of 0 takes one sphere throughout
 *  @param displacements  metres; a stride of 0 moves all alike
 *  @param out_hits       count elements
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_sweep_sphere_batch(const gphys_scene* scene, const gphys_sphere* spheres,
                                                      uint32_t sphere_stride, const gphys_vec3* displacements,
                                                      uint32_t displacement_stride, uint32_t count, uint32_t layers,
                                                      gphys_hit* out_hits, uint32_t out_stride);

/** First model that a sphere, capsule, AABB or OBB touches while it moves by displacement, without
 *  turning; t in 0..1. Fields as in gphys_shape_sweep.
 *  @param displacement  metres; may be zero
 *  @return GPHYS_OK or GPHYS_NO_HIT; GPHYS_ERROR_UNSUPPORTED for other types
 *  Cost: O(log n + k) expected, k the models that the swept box touches. */
GPHYS_API gphys_status gphys_scene_sweep(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                         const gphys_vec3* displacement, uint32_t layers, gphys_hit* out_hit);
/** First models that count shapes of one type touch while each moves by its displacement, as
 *  gphys_scene_sweep; one that touches nothing gets model = 0 and t = INFINITY.
 *  @param shapes         a stride of 0 takes one shape throughout
 *  @param displacements  metres; a stride of 0 moves all alike
 *  @param out_hits       count elements
 *  @return GPHYS_ERROR_UNSUPPORTED as gphys_scene_sweep
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_sweep_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                               uint32_t shape_stride, const gphys_vec3* displacements,
                                               uint32_t displacement_stride, uint32_t count, uint32_t layers,
                                               gphys_hit* out_hits, uint32_t out_stride);

/** What a sphere, capsule, AABB or OBB overlaps, and how it gets out: an element for each model, and of
 *  a mesh one for each triangle, as gphys_shape_penetration. Deepest first; equal depths by
 *  model, then triangle. Each is the way out of that one alone. The models are those of gphys_scene_overlap. Kept when
 *  the array is too small: the deepest.
 *  @return GPHYS_ERROR_UNSUPPORTED for other types
 *  Cost: O(log n + k log k) expected. */
GPHYS_API gphys_status gphys_scene_penetration(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                               uint32_t layers, gphys_penetration* out_penetrations, uint32_t capacity,
                                               uint32_t* out_total);

/** What each of count shapes of one type overlaps, and how it gets out, as gphys_scene_penetration: the ways out of
 *  shape i are at out_penetrations[out_offsets[i]] up to out_offsets[i + 1], as in gphys_scene_raycast_all_batch. So a
 *  crowd of characters is pushed out in one call.
 *  @param shapes       a stride of 0 asks for one shape count times
 *  @param out_offsets  count + 1 numbers, always complete
 *  @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity; GPHYS_ERROR_UNSUPPORTED as
 *          gphys_scene_penetration
 *  Cost: that of count single calls; shared among workers.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_penetration_batch(const gphys_scene* scene, gphys_shape_type type,
                                                     const void* shapes, uint32_t shape_stride, uint32_t count,
                                                     uint32_t layers, gphys_penetration* out_penetrations,
                                                     uint32_t capacity, uint32_t* out_offsets);

/* The same queries with a filter: a mask of layers, and models to leave out, such as the one that asks or
 * those that are selected. They answer as if the models that are left out were not in the scene, with the
 * bits and ties that the unfiltered forms would then have. A filter changes nothing in the scene, so any
 * number of threads may query at the same time with filters of their own.
 *
 * The batch forms take one filter for all elements with a stride of 0, else one for each. A stride other
 * than 0 is at least the struct_size of the filters, which must be the same for all. NULL for filters
 * leaves out nothing. */

/* Flags of gphys_query_filter_desc. */
enum {
    GPHYS_FILTER_SUBTREE = 1,       /* ignored_model stands for its descendants, too */
    GPHYS_FILTER_NO_BACK_FACES = 2, /* planes, triangles and meshes that are not solid are not hit from behind: by
                                       rays with GPHYS_HIT_BACK, or by sweeps along their normal; other queries
                                       have no direction and ignore this flag and the next */
    GPHYS_FILTER_NO_FRONT_FACES = 4 /* they are met from behind only: the inside of a closed mesh */
};

/** Which models a query sees. Ids that name no model leave out nothing and are not an error: the
 *  model that asked may have been removed since. */
typedef struct gphys_query_filter_desc {
    uint32_t struct_size;
    uint32_t layers;                      /* a model is seen if its own mask shares a bit; default GPHYS_ALL_LAYERS */
    gphys_model_id ignored_model;         /* left out; 0: none; default 0 */
    uint32_t flags;                       /* GPHYS_FILTER_...; default 0 */
    const gphys_model_id* ignored_models; /* left out as well, in any order; read during the call; default NULL */
    uint32_t ignored_count;               /* of ignored_models; default 0 */
    uint32_t reserved;                    /* must be 0 */
} gphys_query_filter_desc;

/** Fill a desc with the defaults of the filtered queries, which are stated beside its fields: all is seen.
 *  @param size  sizeof(gphys_query_filter_desc) of the caller; no byte beyond is written
 *  @return GPHYS_ERROR_STRUCT_SIZE for a size below that of release 1.1, or beyond 65536
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_query_filter_desc_init(gphys_query_filter_desc* desc, uint32_t size);

/** Closest model on a ray that the filter sees, as gphys_scene_raycast.
 *  @param filter  NULL: the defaults
 *  @return GPHYS_OK or GPHYS_NO_HIT; GPHYS_ERROR_INVALID_ARGUMENT for unknown flags, or ignored_models NULL
 *          with an ignored_count above 0
 *  Cost: that of gphys_scene_raycast for one ignored model. For each model that is met within the ray's
 *  reach, besides: O(its depth below its root) with GPHYS_FILTER_SUBTREE if ignored_model has children; of
 *  m ignored_models O(log m) if they are ascending, as all lists of the library are, else O(m). Whether
 *  they are takes O(m) a call. Where faces are left out, a batch tests a mesh one ray at a time. */
GPHYS_API gphys_status gphys_scene_raycast_filtered(const gphys_scene* scene, const gphys_ray* ray,
                                                    const gphys_query_filter_desc* filter, gphys_hit* out_hit);
/** Closest models on count rays that the filters see, as gphys_scene_raycast_batch.
 *  @param rays      a stride of 0 casts one ray count times
 *  @param filters   a stride of 0 takes one for all; NULL: the defaults
 *  @param out_hits  count elements
 *  Cost: at most that of count calls of gphys_scene_raycast_filtered; shared among workers. */
GPHYS_API gphys_status gphys_scene_raycast_filtered_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                          uint32_t ray_stride, uint32_t count,
                                                          const gphys_query_filter_desc* filters,
                                                          uint32_t filter_stride, gphys_hit* out_hits,
                                                          uint32_t out_stride);
/** How far each of count rays goes among the models that its filter sees, as gphys_scene_raycast_distance_batch: a
 *  lidar leaves out the robot that carries it.
 *  @param rays           a stride of 0 casts one ray count times
 *  @param filters        a stride of 0 takes one for all; NULL: the defaults
 *  @param out_distances  count elements
 *  Cost: less than that of gphys_scene_raycast_filtered_batch; shared among workers.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_raycast_distance_filtered_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                                   uint32_t ray_stride, uint32_t count,
                                                                   const gphys_query_filter_desc* filters,
                                                                   uint32_t filter_stride,
                                                                   gphys_distance* out_distances, uint32_t out_stride);

/** Whether a ray meets anything that the filter sees, as gphys_scene_raycast_any: line of sight between two
 *  models that both are left out.
 *  @param filter   NULL: the defaults
 *  @param out_hit  0 or 1
 *  Cost: as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_scene_raycast_any_filtered(const gphys_scene* scene, const gphys_ray* ray,
                                                        const gphys_query_filter_desc* filter, int32_t* out_hit);
/** Whether each of count rays meets anything that its filter sees, as gphys_scene_raycast_any_batch.
 *  @param rays      a stride of 0 casts one ray count times
 *  @param filters   a stride of 0 takes one for all; NULL: the defaults
 *  @param out_hits  count elements, each 0 or 1
 *  Cost: at most that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_raycast_any_filtered_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                              uint32_t ray_stride, uint32_t count,
                                                              const gphys_query_filter_desc* filters,
                                                              uint32_t filter_stride, int32_t* out_hits,
                                                              uint32_t out_stride);

/** Every model that a ray meets and the filter sees, as gphys_scene_raycast_all.
 *  @param filter  NULL: the defaults
 *  Cost: that of gphys_scene_raycast_all, and for each model as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_scene_raycast_all_filtered(const gphys_scene* scene, const gphys_ray* ray,
                                                        const gphys_query_filter_desc* filter, gphys_hit* out_hits,
                                                        uint32_t capacity, uint32_t* out_total);
/** Every model that each of count rays meets and its filter sees, as gphys_scene_raycast_all_batch.
 *  @param rays         a stride of 0 casts one ray count times
 *  @param filters      a stride of 0 takes one for all; NULL: the defaults
 *  @param out_offsets  count + 1 numbers, always complete
 *  @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_raycast_all_filtered_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                              uint32_t ray_stride, uint32_t count,
                                                              const gphys_query_filter_desc* filters,
                                                              uint32_t filter_stride, gphys_hit* out_hits,
                                                              uint32_t capacity, uint32_t* out_offsets);

/** Closest model along a segment that the filter sees, as gphys_scene_segment_test.
 *  @param filter  NULL: the defaults
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_scene_segment_test_filtered(const gphys_scene* scene, const gphys_segment* segment,
                                                         const gphys_query_filter_desc* filter, gphys_hit* out_hit);
/** Closest models along count segments that the filters see, as gphys_scene_segment_test_batch.
 *  @param segments  a stride of 0 tests one segment count times
 *  @param filters   a stride of 0 takes one for all; NULL: the defaults
 *  @param out_hits  count elements
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_segment_test_filtered_batch(const gphys_scene* scene, const gphys_segment* segments,
                                                               uint32_t segment_stride, uint32_t count,
                                                               const gphys_query_filter_desc* filters,
                                                               uint32_t filter_stride, gphys_hit* out_hits,
                                                               uint32_t out_stride);

/** Ids of all models that overlap a shape and that the filter sees, as gphys_scene_overlap.
 *  @param filter  NULL: the defaults
 *  @return GPHYS_ERROR_UNSUPPORTED for types of shapes that gphys_scene_overlap does not take
 *  Cost: that of gphys_scene_overlap, and for each model as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_scene_overlap_filtered(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                                    const gphys_query_filter_desc* filter, gphys_model_id* out_models,
                                                    uint32_t capacity, uint32_t* out_total);
/** Ids of all models that each of count shapes of one type overlaps and its filter sees, as
 *  gphys_scene_overlap_batch.
 *  @param shapes       a stride of 0 asks for one shape count times
 *  @param filters      a stride of 0 takes one for all; NULL: the defaults
 *  @param out_offsets  count + 1 numbers, always complete
 *  @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity; GPHYS_ERROR_UNSUPPORTED as there
 *  Cost: at most that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_overlap_filtered_batch(const gphys_scene* scene, gphys_shape_type type,
                                                          const void* shapes, uint32_t shape_stride, uint32_t count,
                                                          const gphys_query_filter_desc* filters,
                                                          uint32_t filter_stride, gphys_model_id* out_models,
                                                          uint32_t capacity, uint32_t* out_offsets);

/** Ids of all models in a frustum, by their world boxes, that the filter sees, as gphys_scene_cull: a
 *  player's own head, say, is not drawn.
 *  @param filter  NULL: the defaults
 *  Cost: that of gphys_scene_cull, and for each model as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_scene_cull_filtered(const gphys_scene* scene, const gphys_frustum* frustum,
                                                 const gphys_query_filter_desc* filter, gphys_model_id* out_models,
                                                 uint32_t capacity, uint32_t* out_total);

/** Ids of the models in each of count frusta that its filter sees, as gphys_scene_cull_batch: each player's view leaves
 *  out the player's own head.
 *  @param frusta       a stride of 0 asks for one frustum count times
 *  @param filters      a stride of 0 takes one for all; NULL: the defaults
 *  @param out_offsets  count + 1 numbers, always complete
 *  @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity
 *  Cost: that of count single calls; shared among workers.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_cull_filtered_batch(const gphys_scene* scene, const gphys_frustum* frusta,
                                                       uint32_t frustum_stride, uint32_t count,
                                                       const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                       gphys_model_id* out_models, uint32_t capacity,
                                                       uint32_t* out_offsets);

/** The model nearest to a point that the filter sees, as gphys_scene_nearest: the nearest other model, if the
 *  one at the point is left out.
 *  @param max_distance  metres, >= 0, INFINITY allowed; a model at exactly this distance counts
 *  @param filter        NULL: the defaults
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: that of gphys_scene_nearest, and for each model as gphys_scene_raycast_filtered; each ignored model that is
 *  nearer than the answer is visited. */
GPHYS_API gphys_status gphys_scene_nearest_filtered(const gphys_scene* scene, const gphys_vec3* point,
                                                    float max_distance, const gphys_query_filter_desc* filter,
                                                    gphys_nearest* out_nearest);
/** The models nearest to count points that the filters see, as gphys_scene_nearest_batch.
 *  @param points        a stride of 0 asks for one point count times
 *  @param max_distance  metres, >= 0, INFINITY allowed, for all points
 *  @param filters       a stride of 0 takes one for all; NULL: the defaults
 *  @param out_nearest   count elements
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_nearest_filtered_batch(const gphys_scene* scene, const gphys_vec3* points,
                                                          uint32_t point_stride, uint32_t count, float max_distance,
                                                          const gphys_query_filter_desc* filters,
                                                          uint32_t filter_stride, gphys_nearest* out_nearest,
                                                          uint32_t out_stride);

/** First model that a moving sphere touches and the filter sees, as gphys_scene_sweep_sphere: the sphere may
 *  be the bounding sphere of the ignored model.
 *  @param displacement  metres; may be zero
 *  @param filter        NULL: the defaults
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: that of gphys_scene_sweep_sphere, and for each model as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_scene_sweep_sphere_filtered(const gphys_scene* scene, const gphys_sphere* sphere,
                                                         const gphys_vec3* displacement,
                                                         const gphys_query_filter_desc* filter, gphys_hit* out_hit);
/** First models that count moving spheres touch and the filters see, as gphys_scene_sweep_sphere_batch.
 *  @param spheres        a stride of 0 takes one sphere throughout
 *  @param displacements  metres; a stride of 0 moves all alike
 *  @param filters        a stride of 0 takes one for all; NULL: the defaults
 *  @param out_hits       count elements
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_sweep_sphere_filtered_batch(const gphys_scene* scene, const gphys_sphere* spheres,
                                                               uint32_t sphere_stride, const gphys_vec3* displacements,
                                                               uint32_t displacement_stride, uint32_t count,
                                                               const gphys_query_filter_desc* filters,
                                                               uint32_t filter_stride, gphys_hit* out_hits,
                                                               uint32_t out_stride);

/** First model that a moving sphere, capsule, AABB or OBB touches and the filter sees, as
 *  gphys_scene_sweep: a character leaves out its own model.
 *  @param displacement  metres; may be zero
 *  @param filter        NULL: the defaults
 *  @return GPHYS_OK or GPHYS_NO_HIT; GPHYS_ERROR_UNSUPPORTED for other types
 *  Cost: that of gphys_scene_sweep, and for each model as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_scene_sweep_filtered(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                                  const gphys_vec3* displacement, const gphys_query_filter_desc* filter,
                                                  gphys_hit* out_hit);
/** First models that count moving shapes of one type touch and the filters see, as gphys_scene_sweep_batch.
 *  @param shapes         a stride of 0 takes one shape throughout
 *  @param displacements  metres; a stride of 0 moves all alike
 *  @param filters        a stride of 0 takes one for all; NULL: the defaults
 *  @param out_hits       count elements
 *  @return GPHYS_ERROR_UNSUPPORTED as gphys_scene_sweep
 *  Cost: that of count single calls; shared among workers. */
GPHYS_API gphys_status gphys_scene_sweep_filtered_batch(const gphys_scene* scene, gphys_shape_type type,
                                                        const void* shapes, uint32_t shape_stride,
                                                        const gphys_vec3* displacements, uint32_t displacement_stride,
                                                        uint32_t count, const gphys_query_filter_desc* filters,
                                                        uint32_t filter_stride, gphys_hit* out_hits,
                                                        uint32_t out_stride);

/** What a sphere, capsule, AABB or OBB overlaps and the filter sees, and how it gets out, as
 *  gphys_scene_penetration.
 *  @param filter  NULL: the defaults
 *  @return GPHYS_ERROR_UNSUPPORTED for other types
 *  Cost: that of gphys_scene_penetration, and for each model as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_scene_penetration_filtered(const gphys_scene* scene, gphys_shape_type type,
                                                        const void* shape, const gphys_query_filter_desc* filter,
                                                        gphys_penetration* out_penetrations, uint32_t capacity,
                                                        uint32_t* out_total);

/** What each of count shapes of one type overlaps and its filter sees, and how it gets out, as
 *  gphys_scene_penetration_batch: each character leaves out its own model.
 *  @param shapes       a stride of 0 asks for one shape count times
 *  @param filters      a stride of 0 takes one for all; NULL: the defaults
 *  @param out_offsets  count + 1 numbers, always complete
 *  @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity; GPHYS_ERROR_UNSUPPORTED as
 *          gphys_scene_penetration
 *  Cost: that of count single calls; shared among workers.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_penetration_filtered_batch(const gphys_scene* scene, gphys_shape_type type,
                                                              const void* shapes, uint32_t shape_stride, uint32_t count,
                                                              const gphys_query_filter_desc* filters,
                                                              uint32_t filter_stride,
                                                              gphys_penetration* out_penetrations, uint32_t capacity,
                                                              uint32_t* out_offsets);

/** Rebuild the scene's octree, as good as that of one gphys_scene_add_batch. Never required: ids, answers and their
 *  bits do not change. Where many models were added one by one, such as a level that was streamed in, rays then take
 *  0.6 to 0.95 of the time.
 *  @return GPHYS_ERROR_OUT_OF_MEMORY, with nothing changed
 *  Cost: O(n log n), 0.15 to 0.45 us a model, less with workers; allocates.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_rebuild_octree(gphys_scene* scene);
/** Rebuild the octree in parts, one in each call, until it is as good as after gphys_scene_rebuild_octree: for levels
 *  that are streamed in while frames go on. Each gphys_scene_add and gphys_scene_remove does a part by itself; these
 *  calls do the rest. Never needed: ids, answers and their bits stay as they are. Models may be added, moved and
 *  removed between the calls. A call that updates an eighth of them or more restarts it.
 *  @param budget    how much work to do, as a number of models, of 0.3 to 3 us each. The work is the same on every
 *                   machine and does not depend on time.
 *  @param out_done  1: nothing is left to do, since fewer than one in 64 models were added one by one; 0: call again
 *  @return GPHYS_ERROR_OUT_OF_MEMORY: the octree is as before, and the next call begins again
 *  Cost: O(budget); allocates, until it is done about 130 bytes a model.  Since 1.1. */
GPHYS_API gphys_status gphys_scene_maintain_octree(gphys_scene* scene, uint32_t budget, int32_t* out_done);
/** How the scene's octree is made up. Cost: O(nodes). */
GPHYS_API gphys_status gphys_scene_get_octree_stats(const gphys_scene* scene, gphys_octree_stats* out_stats);
/** Boxes of the scene's octree, each parent before its children. Kept when too many: the first.
 *  Cost: O(nodes). */
GPHYS_API gphys_status gphys_scene_get_octree_boxes(const gphys_scene* scene, gphys_octree_box* out_boxes,
                                                    uint32_t capacity, uint32_t* out_total);

/** Check the scene's own structure: every model once in the tree, every box around its content,
 *  parents and children in agreement, free slots free. For tests.
 *  @return GPHYS_OK, or GPHYS_ERROR_INTERNAL and gphys_last_error() says what is wrong
 *  Cost: O(n). */
GPHYS_API gphys_status gphys_scene_validate(const gphys_scene* scene);

/** Copy the whole state out: the origin, models with their ids, parents, tags, layers, transforms and shapes, the
 *  order of future ids, and the octree. Workers and allocator are not in it.
 *  @param embed_meshes  1: meshes are in the snapshot, each once, so it is complete in itself: for saved games and for
 *                       other machines. 0: they are identified by their content, and gphys_scene_restore looks for
 *                       them: for undo, and rollback each frame.
 *  @param out_words     the snapshot; written as a whole, or not at all when capacity is too small. Words are in the
 *                       machine's byte order. Every later release of the same major version reads it.
 *  @return GPHYS_INCOMPLETE when *out_total > capacity; GPHYS_ERROR_CAPACITY beyond 2^32 - 1 words
 *  Cost: O(n), some 80 bytes and 100 ns for each model, besides embedded meshes (gphys_mesh_get_snapshot). Allocates a
 *  few words for each different mesh. */
GPHYS_API gphys_status gphys_scene_get_snapshot(const gphys_scene* scene, int32_t embed_meshes, uint32_t* out_words,
                                                uint32_t capacity, uint32_t* out_total);
/** Replace the whole state by that of a snapshot, of this or of another scene. Ids are those of the time of the
 *  snapshot, and so are future ones. All answers have the bits that they had then; a solver that is restored with its
 *  scene continues with the same bits. On an error the scene is as before.
 *  Any words are safe, also from an untrusted source: all that is used as a number or an index is checked first. Forged
 *  words are refused, or taken as a scene like any other.
 *  @param library  meshes that are not embedded are looked for among those that models of this scene use, by their
 *                  content: vertices and indices. A mesh deformed since must get its old form back first. NULL:
 *                  among those that models of `scene` itself use, before it is restored.
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for words that are no snapshot of a scene, damaged, of a later format or of
 *          another byte order, and if a mesh is missing; GPHYS_ERROR_OUT_OF_MEMORY if there is no room for it
 *  Cost: O(n), 150 to 700 ns for each model, besides embedded meshes (gphys_mesh_create_from_snapshot). Allocates. */
GPHYS_API gphys_status gphys_scene_restore(gphys_scene* scene, const gphys_scene* library, const uint32_t* words,
                                           uint32_t count);
/** A hash of the whole state except the octree, the low half first; meshes count by their content. Equal states have
 *  equal hashes on every machine; different ones differ with near certainty (not against an adversary). Compare it
 *  between machines that run the same simulation, to detect when they diverge.
 *  Cost: O(n), some 50 ns for each model. */
GPHYS_API gphys_status gphys_scene_get_hash(const gphys_scene* scene, uint32_t out_hash[2]);

/* ------------------------------------------------------------------------------------------
 * Camera: projection, placement, orbit control, and what follows from them: matrices, frustum,
 * culling, picking. It keeps its own state in double precision; a camera far from the origin is
 * as exact as one at the origin.
 *
 * Defaults: left-handed, looking down +Z with +Y up and +X right, depth 0..1, perspective with a
 * vertical field of view of 60 degrees, near 0.1, far 1000, viewport 800 x 600.
 * ------------------------------------------------------------------------------------------ */

typedef int32_t gphys_projection;
enum { GPHYS_PROJECTION_PERSPECTIVE = 0, GPHYS_PROJECTION_ORTHOGRAPHIC = 1, GPHYS_PROJECTION_USER = 2 };

typedef int32_t gphys_handedness;
enum {
    GPHYS_LEFT_HANDED = 0, /* looks along its own +Z */
    GPHYS_RIGHT_HANDED = 1 /* looks along its own -Z */
};

/** Where the rays of a perspective camera begin. */
typedef int32_t gphys_pick_start;
enum {
    GPHYS_PICK_FROM_NEAR_PLANE = 0, /* what is drawn can be picked; nothing between camera and near plane */
    GPHYS_PICK_FROM_CENTRE = 1      /* at the camera's position: what is between it and the near plane, too */
};

typedef struct gphys_camera_desc {
    uint32_t struct_size;
    const gphys_allocator* allocator; /* NULL: the C++ runtime's */
    gphys_handedness handedness;
    gphys_depth_range depth_range;
    int32_t reverse_z;    /* 1: near has the high depth, for float depth buffers */
    float viewport_width; /* pixels, 1e-3 .. 1e6 */
    float viewport_height;
    uint32_t reserved; /* not read: a client of release 1.0 has padding here */
} gphys_camera_desc;

/** Fill a desc with the defaults of gphys_camera_create, which are stated beside its fields.
 *  @param size  sizeof(gphys_camera_desc) of the caller; no byte beyond is written
 *  @return GPHYS_ERROR_STRUCT_SIZE for a size below that of release 1.0, or beyond 65536
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_desc_init(gphys_camera_desc* desc, uint32_t size);
/** Create a camera at the origin, with the projection and the viewport of its desc.
 *  @param desc  NULL: the defaults
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_create(const gphys_camera_desc* desc, gphys_camera** out_camera);
/** Destroy a camera; NULL does nothing. The handle is invalid from then on. Cost: O(1). */
GPHYS_API void gphys_camera_destroy(gphys_camera* camera);

/** Move the point of the world that the camera's coordinates count from; see gphys_scene_set_origin.
 *  The camera and the target of its orbit stay where they are in the world. Picking and culling need a
 *  scene of the same origin, else they return GPHYS_ERROR_INVALID_ARGUMENT.
 *  @param origin  x, y, z in the world, metres, within GPHYS_MAX_COORDINATE
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_set_origin(gphys_camera* camera, const double origin[3]);
/** Where in the world the camera's coordinates count from, metres. Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_origin(const gphys_camera* camera, double out_origin[3]);

/** Use a perspective projection: distant objects appear smaller.
 *  @param fov_y  full vertical angle in radians, 1e-6 <= fov_y < pi
 *  @param near_distance  metres, > 0
 *  @param far_distance   metres, > near_distance; INFINITY allowed
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_set_perspective(gphys_camera* camera, float fov_y, float near_distance,
                                                    float far_distance);
/** Use an orthographic projection: the distance does not change apparent size.
 *  @param height         metres seen from top to bottom, >= 1e-6; the width follows from the viewport and is at most
 *                        twice GPHYS_MAX_COORDINATE
 *  @param near_distance  metres, may be negative
 *  @param far_distance   metres, at least 1e-6 above near_distance
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_set_orthographic(gphys_camera* camera, float height, float near_distance,
                                                     float far_distance);
/** Use any projection matrix of the camera's depth range and direction (off-centre, oblique,
 *  another library's). It is not changed by gphys_camera_set_viewport.
 *  @return GPHYS_ERROR_SINGULAR if it has no inverse, or is too close to such a matrix to tell;
 *          GPHYS_ERROR_INVALID_ARGUMENT if a plane other than far lies at infinity, as it does when
 *          the matrix is for another depth range, or one lies beyond GPHYS_MAX_COORDINATE
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_set_projection(gphys_camera* camera, const gphys_mat4* projection);
/** As gphys_camera_set_perspective, with a fixed aspect ratio: the image is stretched to the viewport, as with
 *  pixels that are not square, and the viewport does not change what is seen.
 *  @param fov_y   full vertical angle in radians, 1e-6 <= fov_y < pi
 *  @param aspect  width over height of what is seen, 1e-6 .. 1e6
 *  @param near_distance  metres, > 0
 *  @param far_distance   metres, > near_distance; INFINITY allowed
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_set_perspective_aspect(gphys_camera* camera, float fov_y, float aspect,
                                                           float near_distance, float far_distance);
/** As gphys_camera_set_orthographic, with a width of its own, which the viewport does not change.
 *  @param width          metres seen from left to right, >= 1e-6
 *  @param height         metres seen from top to bottom, >= 1e-6
 *  @param near_distance  metres, may be negative
 *  @param far_distance   metres, at least 1e-6 above near_distance
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_set_orthographic_size(gphys_camera* camera, float width, float height,
                                                          float near_distance, float far_distance);
/** Set the size of the viewport. A perspective keeps fov_y, an orthographic projection its height; the call is
 *  refused if that makes the width more than twice GPHYS_MAX_COORDINATE.
 *  @param width   pixels, 1e-3 .. 1e6
 *  @param height  pixels, 1e-3 .. 1e6
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_set_viewport(gphys_camera* camera, float width, float height);
/** Where the viewport is in its window, as one of several of a split screen: pixels of all functions count from
 *  the window's top left corner. (0, 0) at creation.
 *  @param x  pixels from the window's left edge to the viewport's
 *  @param y  pixels from the window's top edge to the viewport's
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_set_viewport_origin(gphys_camera* camera, float x, float y);
/** Where the rays of a perspective begin, for all functions that pick. From the near plane at creation; rays of
 *  other projections always begin there.
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_set_pick_start(gphys_camera* camera, gphys_pick_start start);

/** How the camera projects, as it was set.
 *  @param out_kind  what of the following was called last: gphys_camera_set_perspective, as at creation,
 *                   gphys_camera_set_orthographic (or those with a width of their own), or gphys_camera_set_projection
 *  @param out_size  the vertical field of view in radians of a perspective, the height in metres of an orthographic
 *                   projection, 0 of a matrix
 *  @param out_near  the distance of the near plane, metres; 0 of a matrix
 *  @param out_far   that of the far plane; INFINITY without one; 0 of a matrix
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_projection(const gphys_camera* camera, gphys_projection* out_kind,
                                                   float* out_size, float* out_near, float* out_far);
/** The size of the viewport, in pixels, as it was set. Its width over its height is the aspect of the image.
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_viewport(const gphys_camera* camera, float* out_width, float* out_height);
/** Where the viewport is in its window, in pixels, as it was set. Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_get_viewport_origin(const gphys_camera* camera, float* out_x, float* out_y);
/** Width over height of what is seen: as it was set, or else, and always with a matrix, that of the viewport.
 *  @param out_is_fixed  1 if gphys_camera_set_perspective_aspect or gphys_camera_set_orthographic_size was the last
 *                    to set the projection; 0 if it follows the viewport
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_get_aspect(const gphys_camera* camera, float* out_aspect, int32_t* out_is_fixed);
/** Width and height of what is seen, within an ulp: at a distance of one metre by a perspective (twice the tangents
 *  of half the angles; over the viewport's size, what a pixel spans there), at any distance by an orthographic
 *  projection, in metres as they were set; 0 by a matrix.
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_get_image_size(const gphys_camera* camera, float* out_width, float* out_height);
/** Where the rays of a perspective begin, as it was set. Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_get_pick_start(const gphys_camera* camera, gphys_pick_start* out_start);

/** What the camera was created with, as in gphys_camera_desc.
 *  @param out_reverse_z  0 or 1
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_get_conventions(const gphys_camera* camera, gphys_handedness* out_handedness,
                                                    gphys_depth_range* out_depth_range, int32_t* out_reverse_z);

/** Place the camera.
 *  @param position  metres, of its centre
 *  @param rotation  from its own axes to those of the world
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_set_transform(gphys_camera* camera, const gphys_vec3* position,
                                                  const gphys_quat* rotation);
/** Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
 *  kept, then up), so that a matrix which drifted is corrected.
 *  @return GPHYS_ERROR_SINGULAR if the axes do not span space, GPHYS_ERROR_INVALID_ARGUMENT if
 *          they mirror or the last row is not 0 0 0 1
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_set_world_matrix(gphys_camera* camera, const gphys_mat4* world);
/** Place it by a view matrix (world to camera): by the world matrix that is its inverse, as
 *  gphys_camera_set_world_matrix. That of gphys_camera_get_view_matrix puts a camera back within 2^-22 of its
 *  distance from the origin and 2^-22 rad.
 *  @return GPHYS_ERROR_SINGULAR if the axes do not span space, GPHYS_ERROR_INVALID_ARGUMENT if they
 *          mirror, the last row is not 0 0 0 1, or the camera would be beyond GPHYS_MAX_COORDINATE
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_set_view_matrix(gphys_camera* camera, const gphys_mat4* view);
/** Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
 *  chosen in its place, always the same for the same input.
 *  @return GPHYS_ERROR_INVALID_ARGUMENT if eye equals target or up is zero
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_look_at(gphys_camera* camera, const gphys_vec3* eye, const gphys_vec3* target,
                                            const gphys_vec3* up);

/** The camera's position, in metres, and its rotation, rounded to float32. Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_transform(const gphys_camera* camera, gphys_vec3* out_position,
                                                  gphys_quat* out_rotation);
/** The matrix from camera to world. Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_world_matrix(const gphys_camera* camera, gphys_mat4* out_world);
/** The matrix from world to camera: the transpose of the orthonormal world axes, and the position
 *  transformed by it. Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_view_matrix(const gphys_camera* camera, gphys_mat4* out_view);
/** The matrix from camera to clip space. Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_projection_matrix(const gphys_camera* camera, gphys_mat4* out_projection);
/** Projection * view, multiplied in double precision and rounded once. Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_view_projection_matrix(const gphys_camera* camera,
                                                               gphys_mat4* out_view_projection);

/** Orbit control: the camera circles a target. Inputs accumulate between updates in plain units;
 *  nothing depends on the frame time or on how often update is called. Frozen. */
typedef struct gphys_orbit {
    gphys_vec3 target;
    gphys_vec3 up;                    /* any non-zero length; pitch is measured against it */
    float distance;                   /* metres from target, > 0 */
    float yaw, pitch;                 /* radians; yaw 0 looks along the reference direction that is
                                         perpendicular to up (+Z for up = +Y), yaw > 0 to the right of
                                         it; pitch > 0 looks down */
    float radians_per_unit;           /* of gphys_camera_orbit_rotate */
    float metres_per_unit;            /* of gphys_camera_orbit_zoom and _pan */
    float min_distance, max_distance; /* 0 < min <= max; max INFINITY allowed */
    float min_pitch, max_pitch;       /* within -pi/2 .. pi/2 */
} gphys_orbit;

/** Fill in the defaults: target 0, up +Y, distance 10, yaw and pitch 0, one radian and one metre per
 *  unit, distance 0.01 .. INFINITY, pitch -89 .. 89 degrees. Cost: O(1). */
GPHYS_API gphys_status gphys_orbit_init(gphys_orbit* orbit);
/** Start orbiting with these settings; places the camera at once and drops pending input. An angle
 *  or a distance outside its limits is brought inside. Cost: O(1). */
GPHYS_API gphys_status gphys_camera_set_orbit(gphys_camera* camera, const gphys_orbit* orbit);
/** The present settings, angles and distance of the orbit.
 *  @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_orbit(const gphys_camera* camera, gphys_orbit* out_orbit);
/** What a unit of each input moves an orbit by; negative to invert one. Frozen.  Since 1.1. */
typedef struct gphys_orbit_speeds {
    float rotate_x, rotate_y; /* radians a unit, of yaw and pitch */
    float zoom;               /* metres a unit */
    float pan_x, pan_y;       /* metres a unit, to the right and up */
} gphys_orbit_speeds;

/** Set a speed for each input of the orbit, in place of the two of gphys_orbit, which gphys_camera_set_orbit
 *  starts from. Input since the last update uses the new speeds.
 *  @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_set_orbit_speeds(gphys_camera* camera, const gphys_orbit_speeds* speeds);
/** The present speeds of the orbit's inputs.
 *  @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_get_orbit_speeds(const gphys_camera* camera, gphys_orbit_speeds* out_speeds);
/** Add input to the orbit: yaw by units_x, pitch by units_y, times radians_per_unit or the speeds that were set.
 *  @param units_x  finite, any size
 *  @param units_y  finite, any size
 *  @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_orbit_rotate(gphys_camera* camera, float units_x, float units_y);
/** Add input to the orbit: move closer by units times metres_per_unit or the speed that was set, or away if negative.
 *  @param units  finite, any size
 *  @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_orbit_zoom(gphys_camera* camera, float units);
/** Add input to the orbit: move the target to the camera's right and up, as the last update left them,
 *  by units times metres_per_unit or the speeds that were set.
 *  @param units_right  finite, any size
 *  @param units_up     finite, any size
 *  @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_orbit_pan(gphys_camera* camera, float units_right, float units_up);
/** Apply the input since the last update, within the limits, and place the camera. Angles are
 *  wrapped to -pi .. pi in constant time.
 *  @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_orbit_update(gphys_camera* camera);

/** The view frustum, with origin at the camera's position and planes from its parameters: each
 *  number within 2 ulp. All functions of shapes accept it. A user projection gives its planes by
 *  Gribb-Hartmann in double precision.
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_frustum(const gphys_camera* camera, gphys_frustum* out_frustum);
/** World positions of the corners of the view frustum, in the order of gphys_frustum_corners.
 *  @return GPHYS_UNBOUNDED with an infinite far plane, or a corner beyond the largest float
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_get_corners(const gphys_camera* camera, gphys_vec3 out_corners[8]);
/** What is seen in a rectangle of pixels, as gphys_camera_get_frustum: of a tile, a marquee, a portal.
 *  @param x0  pixels, a corner of the rectangle; may lie outside the viewport
 *  @param y0  pixels, a corner of the rectangle; may lie outside the viewport
 *  @param x1  pixels, the opposite corner, in any order; may lie outside the viewport
 *  @param y1  pixels, the opposite corner, in any order; may lie outside the viewport
 *  @return GPHYS_ERROR_INVALID_ARGUMENT if the rectangle has no area, or a side of what a matrix shows in it lies
 *          at infinity or beyond GPHYS_MAX_COORDINATE
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_get_rectangle_frustum(const gphys_camera* camera, float x0, float y0, float x1,
                                                          float y1, gphys_frustum* out_frustum);
/** World positions of the corners of what is seen in a rectangle of pixels, as gphys_camera_get_corners.
 *  @param x0  as gphys_camera_get_rectangle_frustum
 *  @param y0  as gphys_camera_get_rectangle_frustum
 *  @param x1  as gphys_camera_get_rectangle_frustum
 *  @param y1  as gphys_camera_get_rectangle_frustum
 *  @return GPHYS_UNBOUNDED as gphys_camera_get_corners
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_camera_get_rectangle_corners(const gphys_camera* camera, float x0, float y0, float x1,
                                                          float y1, gphys_vec3 out_corners[8]);

/** World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the viewport;
 *  z is the depth in the camera's range.
 *  @return GPHYS_NO_HIT if the point is not in front of the camera's centre (no image), or its
 *          image lies beyond the range of coordinates
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_project(const gphys_camera* camera, const gphys_vec3* point, gphys_vec3* out_pixel);
/** Pixels of count world points, as gphys_camera_project; a point without an image gets
 *  x = y = z = INFINITY.
 *  @param points      metres; a stride of 0 projects one point count times
 *  @param out_pixels  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_camera_project_batch(const gphys_camera* camera, const gphys_vec3* points,
                                                  uint32_t point_stride, uint32_t count, gphys_vec3* out_pixels,
                                                  uint32_t out_stride);
/** Pixel and depth to world point: the inverse of gphys_camera_project.
 *  @return GPHYS_UNBOUNDED for the depth of an infinite far plane, and for points beyond that or
 *          beyond the range of coordinates
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_unproject(const gphys_camera* camera, const gphys_vec3* pixel,
                                              gphys_vec3* out_point);
/** World points of count pixels with depth, as gphys_camera_unproject; one at infinity gets
 *  x = y = z = INFINITY.
 *  @param pixels      x, y in pixels, z the depth; a stride of 0 takes one pixel count times
 *  @param out_points  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_camera_unproject_batch(const gphys_camera* camera, const gphys_vec3* pixels,
                                                    uint32_t pixel_stride, uint32_t count, gphys_vec3* out_points,
                                                    uint32_t out_stride);

/** The ray through a pixel, of unit direction, from the near plane on; t_max ends on the far plane (INFINITY
 *  without one). With GPHYS_PICK_FROM_CENTRE that of a perspective starts at the camera's position.
 *  Its image is within 1e-3 pixel of the given one or, for fields of view below about 3 degrees, within half
 *  an ulp of its direction. Its start is rounded to float32, too, which moves the ray by half an ulp of the
 *  coordinates (but not from the camera's position, which has float coordinates); gphys_camera_pick is not
 *  limited in this way.
 *  @param pixel_x  pixels; may lie outside the viewport
 *  @param pixel_y  pixels; may lie outside the viewport
 *  @return GPHYS_UNBOUNDED if the line of sight does not meet the near plane (user projections), or would
 *          begin beyond GPHYS_MAX_COORDINATE
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_camera_pick_ray(const gphys_camera* camera, float pixel_x, float pixel_y,
                                             gphys_ray* out_ray);
/** Rays for a rectangle of pixel centres, as gphys_camera_pick_ray, row by row.
 *  @param x         the left column of the rectangle
 *  @param y         its top row
 *  @param width     its columns
 *  @param height    its rows; width * height fewer than 2^32
 *  @param out_rays  width * height elements
 *  @return GPHYS_UNBOUNDED if one of them has none, as there
 *  Cost: O(width * height). */
GPHYS_API gphys_status gphys_camera_pick_rays(const gphys_camera* camera, uint32_t x, uint32_t y, uint32_t width,
                                              uint32_t height, gphys_ray* out_rays, uint32_t out_stride);

/** The model under a pixel: the first hit of gphys_camera_pick_ray, before that is rounded to
 *  float32; t is in metres from where it starts.
 *  @param pixel_x  pixels; may lie outside the viewport
 *  @param pixel_y  pixels; may lie outside the viewport
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: O(log n) expected. */
GPHYS_API gphys_status gphys_camera_pick(const gphys_camera* camera, const gphys_scene* scene, float pixel_x,
                                         float pixel_y, uint32_t layers, gphys_hit* out_hit);
/** The models under count pixels, as gphys_camera_pick; a pixel without one gets model = 0 and
 *  t = INFINITY.
 *  @param pixels    x, y pairs of floats; a stride of 0 takes one pixel count times
 *  @param out_hits  count elements
 *  Cost: at most that of count single calls; shared among the scene's workers. */
GPHYS_API gphys_status gphys_camera_pick_batch(const gphys_camera* camera, const gphys_scene* scene,
                                               const float* pixels, uint32_t pixel_stride, uint32_t count,
                                               uint32_t layers, gphys_hit* out_hits, uint32_t out_stride);
/** Marquee: ids of all models in the pixel rectangle, hidden ones included, between near and far plane;
 *  tested by their exact shapes, ascending. Kept when too many: the lowest.
 *  @param x0  pixels, a corner of the rectangle; may lie outside the viewport
 *  @param y0  pixels, a corner of the rectangle; may lie outside the viewport
 *  @param x1  pixels, the opposite corner, in any order; may lie outside the viewport
 *  @param y1  pixels, the opposite corner, in any order; may lie outside the viewport
 *  @return GPHYS_ERROR_INVALID_ARGUMENT if the rectangle has no area
 *  Cost: that of gphys_scene_overlap. */
GPHYS_API gphys_status gphys_camera_pick_rectangle(const gphys_camera* camera, const gphys_scene* scene, float x0,
                                                   float y0, float x1, float y1, uint32_t layers,
                                                   gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total);

/** Ids of the models to draw: gphys_scene_cull with the camera's frustum. Kept when too many: the lowest.
 *  Cost: O(log n + k) expected. */
GPHYS_API gphys_status gphys_camera_cull(const gphys_camera* camera, const gphys_scene* scene, uint32_t layers,
                                         gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total);

/** The model under a pixel that the filter sees, as gphys_camera_pick: what lies behind a selection.
 *  @param pixel_x  pixels; may lie outside the viewport
 *  @param pixel_y  pixels; may lie outside the viewport
 *  @param filter   NULL: the defaults
 *  @return GPHYS_OK or GPHYS_NO_HIT
 *  Cost: as gphys_scene_raycast_filtered. */
GPHYS_API gphys_status gphys_camera_pick_filtered(const gphys_camera* camera, const gphys_scene* scene, float pixel_x,
                                                  float pixel_y, const gphys_query_filter_desc* filter,
                                                  gphys_hit* out_hit);
/** The models under count pixels that the filters see, as gphys_camera_pick_batch.
 *  @param pixels    x, y pairs of floats; a stride of 0 takes one pixel count times
 *  @param filters   a stride of 0 takes one for all; NULL: the defaults
 *  @param out_hits  count elements
 *  Cost: at most that of count single calls; shared among the scene's workers. */
GPHYS_API gphys_status gphys_camera_pick_filtered_batch(const gphys_camera* camera, const gphys_scene* scene,
                                                        const float* pixels, uint32_t pixel_stride, uint32_t count,
                                                        const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                        gphys_hit* out_hits, uint32_t out_stride);
/** Marquee: ids of all models in the pixel rectangle that the filter sees, as gphys_camera_pick_rectangle.
 *  @param x0      pixels, a corner of the rectangle
 *  @param y0      pixels, a corner of the rectangle
 *  @param x1      pixels, the opposite corner, in any order
 *  @param y1      pixels, the opposite corner, in any order
 *  @param filter  NULL: the defaults
 *  Cost: as gphys_scene_overlap_filtered. */
GPHYS_API gphys_status gphys_camera_pick_rectangle_filtered(const gphys_camera* camera, const gphys_scene* scene,
                                                            float x0, float y0, float x1, float y1,
                                                            const gphys_query_filter_desc* filter,
                                                            gphys_model_id* out_models, uint32_t capacity,
                                                            uint32_t* out_total);
/** Ids of the models to draw that the filter sees: gphys_scene_cull_filtered with the camera's frustum.
 *  @param filter  NULL: the defaults
 *  Cost: as gphys_scene_cull_filtered. */
GPHYS_API gphys_status gphys_camera_cull_filtered(const gphys_camera* camera, const gphys_scene* scene,
                                                  const gphys_query_filter_desc* filter, gphys_model_id* out_models,
                                                  uint32_t capacity, uint32_t* out_total);

/* ------------------------------------------------------------------------------------------
 * Solver: bodies made of particles and distance constraints (free particles, ropes, cloth) that
 * move under gravity, forces and damping and collide with the models of a scene.
 *
 * Particles of a body are numbered from 0 in the order in which they were given. State is read
 * and written as arrays over a range (first, count) of one body. Positions are world space.
 * The same calls give the same bits.
 * ------------------------------------------------------------------------------------------ */

typedef uint32_t gphys_body_id;
typedef uint32_t gphys_constraint_id;

typedef struct gphys_solver_desc {
    uint32_t struct_size;
    const gphys_allocator* allocator;     /* NULL: the C++ runtime's */
    gphys_vec3 gravity;                   /* m/s^2; default (0, -9.81, 0) */
    uint32_t substeps;                    /* of one step, 1 .. 1000; default 8; with error targets: of the first step */
    float fixed_step;                     /* seconds simulated by each step of gphys_solver_advance; 1/60 */
    uint32_t max_steps;                   /* most steps of one advance; time beyond is dropped; 8 */
    const gphys_task_runner* task_runner; /* provides the worker_count threads; NULL: the solver's own */
    uint32_t worker_count; /* threads for one step, including the caller's, at most 1024; 0 and 1: that alone */
    float sleep_speed;     /* m/s, see gphys_solver_get_sleeping; 0: bodies never sleep; default 0 */
    float sleep_strain;    /* of rigid constraints, |length / rest length - 1|; those of rest length 0 are measured by
                              the mean rest length of the body's rigid constraints; default 0.01 */
    float sleep_time;      /* seconds; default 0.5 */
    float max_strain;      /* of rigid constraints, see gphys_solver_get_substeps; 0: none, for cloth 0.02; default 0 */
    float tolerance;       /* target of positions: metres of error that a second of motion adds; 0: none; default 0 */
    uint32_t max_substeps; /* the most that a target may ask for, 1 .. 1000; default 64 */
    uint32_t max_work;     /* see gphys_solver_settings; 0: no bound; default 0 */
} gphys_solver_desc;

/** Fill a desc with the defaults of gphys_solver_create, which are stated beside its fields.
 *  @param size  sizeof(gphys_solver_desc) of the caller; no byte beyond is written
 *  @return GPHYS_ERROR_STRUCT_SIZE for a size below that of release 1.0, or beyond 65536
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_solver_desc_init(gphys_solver_desc* desc, uint32_t size);
/** Create a solver without bodies.
 *  With a worker_count of n, n threads share the bodies of a step; the results have the same bits for
 *  every n. Threads are started, joined and lost as those of gphys_scene_create.
 *  @param desc  NULL: the defaults
 *  @return GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started
 *  Cost: O(1), and that of starting the threads. */
GPHYS_API gphys_status gphys_solver_create(const gphys_solver_desc* desc, gphys_solver** out_solver);
/** Destroy a solver with its bodies and joints; NULL does nothing. Handles and ids are invalid from then
 *  on. Joins its worker threads. No other call on the solver may be under way.
 *  Cost: O(particles + constraints). */
GPHYS_API void gphys_solver_destroy(gphys_solver* solver);

/** Change the number of threads that share the steps of a solver, as gphys_scene_set_worker_count. The bits of the
 *  motion stay the same.
 *  @param workers  as gphys_solver_desc.worker_count
 *  @return GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started; the former ones are kept
 *  Cost: as gphys_scene_set_worker_count; allocates.  Since 1.1. */
GPHYS_API gphys_status gphys_solver_set_worker_count(gphys_solver* solver, uint32_t workers);
/** How many threads share the steps of a solver, as gphys_scene_get_worker_count. Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_worker_count(const gphys_solver* solver, uint32_t* out_workers);

/** Move the point of the world that the coordinates of all particles count from; see
 *  gphys_scene_set_origin. Particles stay where they are in the world and keep moving as they do. A
 *  step and an attachment need a scene of the same origin, else they return
 *  GPHYS_ERROR_INVALID_ARGUMENT.
 *  @param origin  x, y, z in the world, metres, within GPHYS_MAX_COORDINATE
 *  @return GPHYS_ERROR_INVALID_ARGUMENT also if a particle or an animation target would leave the range of coordinates
 *  Cost: O(particles). */
GPHYS_API gphys_status gphys_solver_set_origin(gphys_solver* solver, const double origin[3]);
/** Where in the world the particles' coordinates count from, metres. Cost: O(1). */
GPHYS_API gphys_status gphys_solver_get_origin(const gphys_solver* solver, double out_origin[3]);

/** Change the acceleration of all particles, from the next step on. Wakes all bodies if it changes.
 *  @param gravity  m/s^2; may be zero
 *  Cost: O(bodies). */
GPHYS_API gphys_status gphys_solver_set_gravity(gphys_solver* solver, const gphys_vec3* gravity);
/** Change the number of substeps of a step. More substeps: smaller errors, proportionally more time. The
 *  error of motion goes with the square of their length. Ropes that move calmly - in a substep no link turns
 *  by half a radian, or would swing by one if its ends were pushed - make each in two stages (TR-BDF2; Bank et
 *  al. 1985): twice the time, a seventh of the error.
 *  @param substeps  1 .. 1000
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_solver_set_substeps(gphys_solver* solver, uint32_t substeps);

/** What a solver was created with and may change later. Fields as in gphys_solver_desc. Frozen. */
typedef struct gphys_solver_settings {
    gphys_vec3 gravity;    /* m/s^2 */
    uint32_t substeps;     /* 1 .. 1000 */
    float fixed_step;      /* seconds, 1e-6 .. 0.5 */
    uint32_t max_steps;    /* >= 1 */
    float sleep_speed;     /* m/s, >= 0 */
    float sleep_strain;    /* >= 0 */
    float sleep_time;      /* seconds, >= 0 */
    float max_strain;      /* >= 0 */
    float tolerance;       /* m/s, >= 0 */
    uint32_t max_substeps; /* 1 .. 1000 */
    uint32_t max_work;     /* most particles times substeps of a step; 0: no bound. If bodies need more, all take fewer
                              substeps in proportion, at least one, and cloth at least one for each 25 ms. It bounds
                              work, not time, so the bits are the same on every machine */
} gphys_solver_settings;

/** The settings of a solver as they are. Cost: O(1). */
GPHYS_API gphys_status gphys_solver_get_settings(const gphys_solver* solver, gphys_solver_settings* out_settings);
/** Change all settings, from the next step on. Read them, change some, and give them back. Bodies wake if
 *  gravity or the settings of sleep change. Time that gphys_solver_advance owes beyond the new fixed_step is
 *  dropped.
 *  Cost: O(bodies). */
GPHYS_API gphys_status gphys_solver_set_settings(gphys_solver* solver, const gphys_solver_settings* settings);

enum {
    GPHYS_CLOTH_SHEAR = 1, /* constraints along both diagonals of each grid cell: stiff like paper */
    GPHYS_CLOTH_BEND = 2   /* constraints that resist folding */
};

/** Settings shared by all kinds of bodies. */
typedef struct gphys_body_desc {
    uint32_t struct_size;
    float mass;              /* kg of the whole body, spread evenly; > 0; default 1 */
    float radius;            /* of each particle for collision, metres, >= 0; default 0.01 */
    float damping;           /* rate in 1/s: velocities decay as exp(-damping t); >= 0; default 0 */
    float friction;          /* Coulomb coefficient against models, >= 0; default 0.5 */
    float restitution;       /* speed kept in a bounce, 0 .. 1; default 0 */
    float compliance;        /* of stretch, metres per newton, >= 0; 0 is inextensible; default 0 */
    float bend_compliance;   /* of GPHYS_CLOTH_BEND constraints, m/N; default 0.001 */
    uint32_t cloth_flags;    /* GPHYS_CLOTH_...; default SHEAR | BEND */
    uint32_t layers;         /* mask of the models it collides with; 0: none; default all */
    float static_friction;   /* of particles at rest on a model, slower than after a fall of 4e-4 radii; at least
                                friction, or 0: as friction; default 0 */
    uint32_t self_collision; /* 1: its particles collide with one another, see below; default 0 */
    uint32_t body_layers;   /* two bodies collide with each other if their masks share a bit; 0: with none; default 0 */
    float shear_compliance; /* of GPHYS_CLOTH_SHEAR constraints of a grid, m/N, >= 0; 0: as compliance; default 0 */
    float breaking_force;   /* of each constraint, newtons, >= 0; 0: none breaks; default 0; see gphys_break */
    float bending_stiffness; /* of ropes, E I in N m^2, >= 0; 0: they bend freely; default 0; see below */
} gphys_body_desc;
/* Woven cloth drapes because it shears and bends easily, and by default sheets do neither: on round or sharp models
 * their rigid constraints cannot all hold, and a sheet moves by centimetres a second until it is brought to rest. It
 * drapes with shear_compliance and bend_compliance of about 1 / (m w^2), where m = mass / (columns * rows) and w = 30
 * rad/s, and a damping of 1 or 2 per second. It hangs with more strain beside its pins; curtains and capes do better
 * with damping alone. docs/solver.md has measured both. */
/* A bending stiffness makes a rope an elastic rod that is straight at rest: a cable, a fishing rod, a whip. That of a
 * round rod of radius r is E pi r^4 / 4, with Young's modulus E in pascals. The energy between two links of length l is
 * bending_stiffness / l (1 - cos of the angle between them). It is part of the equations of the links, so no value is
 * too stiff for the step. A pinned or attached particle is a hinge; two neighbours hold the direction as well. It acts
 * on all bodies that are solved directly (gphys_solve_method), not on cloth; where more than two links meet, and beside
 * a link of length 0, it does not. Links should stretch by little: it also evens out their lengths. Ropes do not resist
 * twisting. */
/* Particles that collide with particles are spheres that do not pass through each other whatever their speed;
 * friction and restitution of a pair are the geometric means of its particles' (sqrt(a b)). Within a body with
 * constraints, those collide that were placed further apart than their radii reach and are not linked
 * directly; without constraints, all. Links and triangles have no thickness of their own: cloth stops cloth
 * of the same spacing, and ropes whose particles are as close together, if the radius is at least 0.45 spacings
 * (0.36 closes a square cell). It should not be above 0.5, or neighbours touch. Bodies that may meet in a
 * step are moved by one thread, and fall asleep and wake together. Cost: some 2 microseconds for each
 * particle and substep, and 1 kB for each particle. */

/** Fill a desc with the defaults of the gphys_solver_add_... functions, which are stated beside its fields.
 *  @param size  sizeof(gphys_body_desc) of the caller; no byte beyond is written
 *  @return GPHYS_ERROR_STRUCT_SIZE for a size below that of release 1.0, or beyond 65536
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_body_desc_init(gphys_body_desc* desc, uint32_t size);

/** Add a body of particles without constraints.
 *  @param desc       NULL: the defaults
 *  @param positions  metres; count elements, count >= 1
 *  @return GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles or bodies
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_add_particles(gphys_solver* solver, const gphys_body_desc* desc,
                                                  const gphys_vec3* positions, uint32_t position_stride, uint32_t count,
                                                  gphys_body_id* out_body);
/** Add a rope through the given points, one particle at each.
 *  @param desc         NULL: the defaults
 *  @param positions    metres; count elements, count >= 2
 *  @param link_length  rest length of each link in metres; 0: as placed. A length below 1e-9 m counts as 0. Rigid
 *                      links get their lengths in the first step, and the particles no speed by it.
 *  @return GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles or bodies
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_add_rope(gphys_solver* solver, const gphys_body_desc* desc,
                                             const gphys_vec3* positions, uint32_t position_stride, uint32_t count,
                                             float link_length, gphys_body_id* out_body);
/** Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
 *  corner + column / (columns - 1) * edge_u + row / (rows - 1) * edge_v. Its constraints, in the order of their ids,
 *  are those from row to row, those from column to column, both diagonals (GPHYS_CLOTH_SHEAR), and those that resist
 *  folding (GPHYS_CLOTH_BEND); gphys_solver_set_constraint_settings makes them softer or stiffer later.
 *  @param desc     NULL: the defaults
 *  @param corner   metres
 *  @param edge_u   metres, from the corner along a row
 *  @param edge_v   metres, from the corner along a column
 *  @param columns  >= 2
 *  @param rows     >= 2
 *  @return GPHYS_ERROR_INVALID_ARGUMENT if the edges are parallel or zero;
 *          GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles, links or bodies
 *  Cost: O(columns * rows). */
GPHYS_API gphys_status gphys_solver_add_cloth(gphys_solver* solver, const gphys_body_desc* desc,
                                              const gphys_vec3* corner, const gphys_vec3* edge_u,
                                              const gphys_vec3* edge_v, uint32_t columns, uint32_t rows,
                                              gphys_body_id* out_body);
/** Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and
 *  with GPHYS_CLOTH_BEND one across each inner edge, whose ids come after those of the edges. Vertices at the same
 *  place stay separate: an edge shorter than 1e-9 m, as at the poles of many imported balls, has a rest length of 0.
 *  @param desc       NULL: the defaults
 *  @param transform  places the mesh; NULL is the identity
 *  @return GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles or bodies;
 *          GPHYS_ERROR_UNSUPPORTED for a mesh made from a rope or from particles, which has no triangles
 *  Cost: O(n log n). */
GPHYS_API gphys_status gphys_solver_add_cloth_mesh(gphys_solver* solver, const gphys_body_desc* desc,
                                                   const gphys_mesh* mesh, const gphys_transform* transform,
                                                   gphys_body_id* out_body);
/** Remove a body with its constraints and joints. Its id stays invalid. The impulses that it gave in the
 *  last step are no longer listed.
 *  Cost: O(particles + constraints of the body), O(joints of the solver), and O(bodies that gave impulses to the
 *  same models). */
GPHYS_API gphys_status gphys_solver_remove_body(gphys_solver* solver, gphys_body_id body);
/** Ids of all bodies, ascending. Kept when too many: the lowest. Cost: O(bodies). */
GPHYS_API gphys_status gphys_solver_get_bodies(const gphys_solver* solver, gphys_body_id* out_bodies, uint32_t capacity,
                                               uint32_t* out_total);

/** Ids of the bodies that are asleep, ascending. Kept when too many: the lowest.
 *  A body falls asleep at the end of a step when for sleep_time seconds no particle was faster than sleep_speed and no
 *  rigid constraint strained by more than sleep_strain; cloth, when its root mean square speed from step to step was no
 *  higher, no particle ten times as fast, and strain, without a max_strain, at most 3 %, that of diagonals of cells
 *  apart: these yield, on sharp and round models by a tenth and more. Its speed is then 0, it keeps its contacts, and
 *  a step costs it one query for models nearby. It wakes in the next step after a model within reach (as far as one
 *  could move in a step at 50 m/s) was added, removed or moved, or a model that it is attached to, or after the scene
 *  was replaced; and at once by any change of its state, of gravity or of the origin.
 *  Cloth is brought to rest, whatever sleep_speed is, once friction holds it on models that stand still and it moves
 *  by centimetres a second without sagging further: within a second it is slowed down to 0. It moves again when one of
 *  these models or the body changes. Not in wind, with joints, animation targets, clusters or a volume, or near other
 *  bodies.
 *  Cost: O(bodies). */
GPHYS_API gphys_status gphys_solver_get_sleeping(const gphys_solver* solver, gphys_body_id* out_bodies,
                                                 uint32_t capacity, uint32_t* out_total);
/** Wake a body; its time of rest begins again.
 *  @param body  0: all
 *  Cost: O(1) a body. */
GPHYS_API gphys_status gphys_solver_wake(gphys_solver* solver, gphys_body_id body);

/** What all particles of a body share and may change later. Fields as in gphys_body_desc. Frozen. */
typedef struct gphys_body_settings {
    float damping;           /* 1/s, >= 0 */
    float friction;          /* >= 0 */
    float static_friction;   /* at least friction, or 0: as friction */
    float restitution;       /* 0 .. 1 */
    uint32_t layers;         /* of models */
    uint32_t body_layers;    /* of bodies */
    uint32_t self_collision; /* 0 or 1; particles nearer than their radii reach when it is set do not collide */
} gphys_body_settings;

/** The present settings of a body; static_friction as it acts, at least friction.
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_solver_get_body_settings(const gphys_solver* solver, gphys_body_id body,
                                                      gphys_body_settings* out_settings);
/** Change all settings of a body, from the next step on: read them, change some, and give them back. Wakes
 *  the body.
 *  Cost: O(1); O(particles) when self_collision changes, and it allocates. */
GPHYS_API gphys_status gphys_solver_set_body_settings(gphys_solver* solver, gphys_body_id body,
                                                      const gphys_body_settings* settings);

typedef int32_t gphys_body_kind;
enum { GPHYS_BODY_PARTICLES = 1, GPHYS_BODY_ROPE = 2, GPHYS_BODY_CLOTH = 3 };

/** How a body is solved, chosen from its constraints. */
typedef int32_t gphys_solve_method;
enum {
    GPHYS_SOLVE_FREE = 0,   /* no constraints: exact flight */
    GPHYS_SOLVE_DIRECT = 1, /* chains and trees: Newton on the whole body at once */
    GPHYS_SOLVE_GRAPH = 2   /* cycles of constraints, volume, clusters, or a particle with more than 64 constraints:
                               coloured batches of chains, then the rest, then reach limits */
};

/** Frozen. */
typedef struct gphys_body_info {
    gphys_body_kind kind;
    gphys_solve_method method;
    uint32_t particle_count;
    uint32_t constraint_count;
    uint32_t triangle_count; /* of cloth, for drawing */
} gphys_body_info;

/** What a body is made of and how it is solved.  Cost: O(1); after a change of constraints O(particles), and
 *  it allocates. */
GPHYS_API gphys_status gphys_solver_get_body_info(const gphys_solver* solver, gphys_body_id body,
                                                  gphys_body_info* out_info);
/** Particle numbers of a cloth's triangles, three each, for drawing. Kept when too many: the first. Where cloth tears
 *  (gphys_break) they change, and their number does not.
 *  Other bodies have none. *out_total counts numbers, not triangles.
 *  Cost: O(triangles). */
GPHYS_API gphys_status gphys_solver_get_triangles(const gphys_solver* solver, gphys_body_id body, uint32_t* out_indices,
                                                  uint32_t capacity, uint32_t* out_total);

/** Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles can be hit by rays,
 *  picked, overlapped and culled as models of scenes (gphys_scene_add with GPHYS_SHAPE_MESH; without a transform the
 *  model is where the body is) or queried by gphys_shape_* and gphys_mesh_* functions.
 *  Vertex p is particle p. For cloth the mesh is the surface of its triangles, in the order of
 *  gphys_solver_get_triangles. A rope of n particles is solid. In a hit, `triangle` t below n - 1 is the link from
 *  particle t to t + 1, a capsule with the smaller of their radii, present while a constraint holds them together;
 *  n - 1 + p is particle p, a sphere, present where no link beside it is as thick. Free particles are spheres, and
 *  `triangle` is the particle. gphys_solver_get_nearest_particle finds the particle of a hit.
 *  The mesh has the new form when gphys_solver_step, gphys_solver_advance, gphys_solver_restore or an edit of the
 *  body returns. When cloth tears (gphys_break), its triangles keep their numbers, and the mesh gets
 *  vertices for the new particles. A model that would leave the range of the world, and a torn mesh or one of less than
 *  2^-32 m for which there is no memory, keep their form until they can follow.
 *  gphys_solver_set_origin moves the coordinates of the mesh, and the models back by as much: they stay where they are
 *  in the world, exactly if scenes have moved their origin before.
 *  Bodies neither collide with models of such meshes nor wake because of them: gphys_body_desc.body_layers sets which
 *  bodies collide. A restored body is followed if it has the same id and parts as before. Restore the solver before the
 *  scene. A mesh that is loaded from a snapshot, that of a scene included, is a copy that follows nothing;
 *  gphys_scene_set_shape gives its model one that does.
 *  Mesh and solver are destroyed in any order. When the body is gone the mesh keeps the form that it had last and is
 *  deformable by gphys_mesh_set_vertices, which returns GPHYS_ERROR_UNSUPPORTED before. A mesh that neither its handle
 *  nor a model holds follows no more.
 *  @param desc  may be NULL; the mesh is deformable whatever it says
 *  Threads: the functions above become edits of the mesh and of each scene that has a model of it.
 *  Cost: as gphys_mesh_create, and then that of gphys_mesh_set_vertices for a body that has moved; one that rests
 *  is compared, O(particles).  Since 1.1. */
GPHYS_API gphys_status gphys_mesh_create_from_body(const gphys_mesh_desc* desc, gphys_solver* solver,
                                                   gphys_body_id body, gphys_mesh** out_mesh);
/** The particle of a body nearest to a point, for example to grab it; of equally near ones the lowest.
 *  @param triangle  as in a hit, nearest or penetration of the body's mesh: its corners are compared, of a rope the
 *                   ends of the link, or the particle; GPHYS_NO_TRIANGLE: all particles
 *  @param point     metres, in the solver's coordinates: that of the hit
 *  @return GPHYS_ERROR_INVALID_ARGUMENT also if the mesh has no such triangle
 *  Cost: O(1); O(particles) for GPHYS_NO_TRIANGLE.  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_nearest_particle(const gphys_solver* solver, gphys_body_id body,
                                                         uint32_t triangle, const gphys_vec3* point,
                                                         uint32_t* out_particle);

/* State of the particles first .. first + count - 1 of a body. A range that does not lie within
 * the body is GPHYS_ERROR_INVALID_ARGUMENT. Setters check all elements before they change any. */

/** Where the particles are, metres.
 *  @param first          the first particle
 *  @param count          how many from there on; a range beyond the body is GPHYS_ERROR_INVALID_ARGUMENT
 *  @param out_positions  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_get_positions(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                  uint32_t count, gphys_vec3* out_positions, uint32_t out_stride);
/** Move particles at once and without collision on the way; velocities stay as they are. Wakes the body. Rigid
 *  links that are too long or too short then get their lengths in the next step, and the particles no speed by it.
 *  Pinned particles that are moved alone pull the others: during the next step they go evenly from where they
 *  were to their new places, as attached ones do. They are placed at once before the body's first step, or if a
 *  free particle of the body is placed as well.
 *  @param first      as in gphys_solver_get_positions
 *  @param count      as in gphys_solver_get_positions
 *  @param positions  metres, count elements; a stride of 0 is refused for more than one
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_set_positions(gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                  uint32_t count, const gphys_vec3* positions, uint32_t stride);
/** How fast the particles are, m/s.
 *  @param first           as in gphys_solver_get_positions
 *  @param count           as in gphys_solver_get_positions
 *  @param out_velocities  count elements; 0 of what is pinned and stands still
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_get_velocities(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                   uint32_t count, gphys_vec3* out_velocities, uint32_t out_stride);
/** Give particles a velocity, which the next step starts from. Wakes the body. Pinned particles keep 0.
 *  @param first       as in gphys_solver_get_positions
 *  @param count       as in gphys_solver_get_positions
 *  @param velocities  m/s; a stride of 0 gives all the same
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_set_velocities(gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                   uint32_t count, const gphys_vec3* velocities, uint32_t stride);
/** Masses of particles, kg. That of a pinned particle is what it has when it is released.
 *  @param first       as in gphys_solver_get_positions
 *  @param count       as in gphys_solver_get_positions
 *  @param out_masses  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_get_masses(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                               uint32_t count, float* out_masses, uint32_t out_stride);
/** Change the masses of particles. A pinned particle keeps its mass for the time when it is released.
 *  Wakes the body.
 *  @param first   as in gphys_solver_get_positions
 *  @param count   as in gphys_solver_get_positions
 *  @param masses  kg, > 0; a stride of 0 gives all the same
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_set_masses(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                               const float* masses, uint32_t stride);
/** Collision radii of particles, metres.
 *  @param first      as in gphys_solver_get_positions
 *  @param count      as in gphys_solver_get_positions
 *  @param out_radii  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_get_radii(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                              uint32_t count, float* out_radii, uint32_t out_stride);
/** Change the collision radii of particles. Wakes the body.
 *  @param first  as in gphys_solver_get_positions
 *  @param count  as in gphys_solver_get_positions
 *  @param radii  metres, >= 0; a stride of 0 gives all the same
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_set_radii(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                              const float* radii, uint32_t stride);
/** Friction factors of particles; 1 until they are set.
 *  @param first        as in gphys_solver_get_positions
 *  @param count        as in gphys_solver_get_positions
 *  @param out_factors  count elements
 *  Cost: O(count).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_friction_factors(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                         uint32_t count, float* out_factors, uint32_t out_stride);
/** Give particles more or less friction than their body has: ice, a sticky hem, a worn patch. In every contact, with
 *  models and with particles, the coefficients of a particle are the friction and the static_friction of its body times
 *  its factor. A body with a friction of 1 thus has the factors for coefficients; gphys_solver_set_body_settings scales
 *  them all and keeps the factors. Wakes the body.
 *  @param first    as in gphys_solver_get_positions
 *  @param count    as in gphys_solver_get_positions
 *  @param factors  >= 0; a stride of 0 gives all the same
 *  Cost: O(count); the first factor other than 1 O(particles), and it allocates.  Since 1.1. */
GPHYS_API gphys_status gphys_solver_set_friction_factors(gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                         uint32_t count, const float* factors, uint32_t stride);
/** The forces that were set for particles, newtons.
 *  @param first       as in gphys_solver_get_positions
 *  @param count       as in gphys_solver_get_positions
 *  @param out_forces  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_get_forces(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                               uint32_t count, gphys_vec3* out_forces, uint32_t out_stride);
/** Set the forces that act on particles beside gravity, from now on until set again. Wakes the body.
 *  @param first   as in gphys_solver_get_positions
 *  @param count   as in gphys_solver_get_positions
 *  @param forces  newtons; a stride of 0 gives all the same
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_set_forces(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                               const gphys_vec3* forces, uint32_t stride);
/** Which particles are pinned or attached.
 *  @param first       as in gphys_solver_get_positions
 *  @param count       as in gphys_solver_get_positions
 *  @param out_pinned  count elements, 1 or 0
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_get_pinned(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                               uint32_t count, int32_t* out_pinned, uint32_t out_stride);
/** Pin or release particles. A pinned particle stays where it is put and moves only by
 *  gphys_solver_set_positions, or with an animation target of max_distance 0; else its speed is 0. Both pinning and
 *  releasing end an attachment.
 *  @param first   as in gphys_solver_get_positions
 *  @param count   as in gphys_solver_get_positions
 *  @param pinned  1: pin; 0: release
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_set_pinned(gphys_solver* solver, gphys_body_id body, uint32_t first, uint32_t count,
                                               int32_t pinned);

/** The air around a body. Frozen. */
typedef struct gphys_wind {
    gphys_vec3 velocity; /* of the air, m/s */
    float density;       /* kg/m^3, >= 0; 1.2 is air at 20 degrees; 0: none */
    float drag;          /* coefficient C_D, >= 0: a plate across has 1.2, a cylinder 1.2, a sphere 0.5 */
    float lift;          /* coefficient C_L of cloth, >= 0; a plate has as much lift as drag */
} gphys_wind;

/** Put a body into moving air. Until this is called there is none. Wakes the body.
 *  With u the velocity relative to the air, the force is
 *    on a triangle of cloth   -rho/2 A |u| ((C_D cos a - C_L cos^2 a) u + C_L (u . n) n),   cos a = |u . n| / |u|,
 *                             the first term not below 0: drag as A cos a, which is what the wind sees of it, and
 *                             lift across the wind as sin a cos a (Keckeisen et al. 2004, "Modelling effects of wind
 *                             fields in cloth animations"); with C_L = C_D it is nearly the pressure on a plate,
 *                             along n;
 *    on a link of a rope      -rho/2 C_D 2 r l |u'| u', u' the part of u across it, r the radius (the cross-flow
 *                             principle: Hoerner 1965, "Fluid-dynamic drag");
 *    on a free particle       -rho/2 C_D pi r^2 |u| u.
 *  Strong wind carries bodies along but never overshoots: whatever the density, a substep does not reverse u.
 *  The drag of a free particle is of second order in the substep; that of a link is the one at the beginning of the
 *  step.
 *  @param body  0: all bodies there are
 *  @param wind  of density 0: no air
 *  Cost: O(1) a body; in each substep of cloth some 370 instructions a triangle, in each step of a rope as many
 *  for each link; some 100 for each free particle, as often as drag takes 1/32 of a speed. */
GPHYS_API gphys_status gphys_solver_set_wind(gphys_solver* solver, gphys_body_id body, const gphys_wind* wind);
/** The air around a body as it was set; zeros if it was not. Cost: O(1). */
GPHYS_API gphys_status gphys_solver_get_wind(const gphys_solver* solver, gphys_body_id body, gphys_wind* out_wind);
/** Give the air at particles a velocity beside that of gphys_wind, from now on until set again: gusts, eddies,
 *  a field of your own that is sampled at the particles' positions. Wakes the body.
 *  @param first       as in gphys_solver_get_positions
 *  @param count       as in gphys_solver_get_positions
 *  @param velocities  m/s; a stride of 0 gives all the same
 *  Cost: O(count); the first time O(particles), and it allocates. */
GPHYS_API gphys_status gphys_solver_set_air_velocities(gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                       uint32_t count, const gphys_vec3* velocities, uint32_t stride);
/** Velocities of the air at particles, m/s, beside that of gphys_wind.
 *  @param first           as in gphys_solver_get_positions
 *  @param count           as in gphys_solver_get_positions
 *  @param out_velocities  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_get_air_velocities(const gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                       uint32_t count, gphys_vec3* out_velocities, uint32_t out_stride);

/** Where an animation wants a particle, and how far from there the particle may be. Frozen. */
typedef struct gphys_animation_target {
    gphys_vec3 position; /* metres */
    gphys_vec3 normal;   /* of the animated surface, away from the character; any length but 0; not read without
                            a backstop */
    float max_distance;  /* metres from position, >= 0; INFINITY: any */
    float backstop;      /* metres that the particle may go behind the plane through position across normal, >= 0;
                            INFINITY: any */
} gphys_animation_target;

/** Give particles animation targets, before each step that is to follow an animation: a cape or skirt that is skinned
 *  to its character stays within max_distance of the skinned vertices and does not sink into the body behind them.
 *  In the next step position and normal go evenly from the old target to the new one, substep by substep; distances
 *  act at once. A target that is not set again stands still. A first target, and that of a particle which
 *  gphys_solver_set_positions has moved since the last step, takes effect at its new place at once: to teleport, make
 *  that call and this one. If the body is attached to a model that jumps (gphys_solver_step), this call alone is
 *  enough.
 *  max_distance 0 carries a particle: it is at its target, as if attached there, and moves links with infinite mass;
 *  this also moves a pinned particle, which stays pinned, at constant speed during a step. Otherwise particles that are
 *  pinned or attached are not moved. A particle that is out of its bounds at the end of a substep is put on the nearest
 *  place within both, without friction; its velocity across them is then that of the target. What lies within its
 *  bounds is not touched.
 *  Bounds act after constraints and before models: where a target is inside a model, or behind one, the particle stays
 *  outside. Links yield to bounds that contradict them. What hangs from a particle at its bounds is carried, in cloth
 *  and in ropes that are moved alone; ropes and free particles that are joined, or collide with bodies, are put back
 *  particle by particle, and links beside these may be strained by the motion of a substep.
 *  Wakes the body if a target changes.
 *  @param first    as in gphys_solver_get_positions
 *  @param count    as in gphys_solver_get_positions
 *  @param targets  max_distance and backstop INFINITY: no target any more; a stride of 0 gives all the same
 *  Cost: O(count); the first time O(particles), and it allocates. In each substep some 100 ns a particle; ropes with
 *  targets are solved one by one, as those that touch models.  Since 1.1. */
GPHYS_API gphys_status gphys_solver_set_animation_targets(gphys_solver* solver, gphys_body_id body, uint32_t first,
                                                          uint32_t count, const gphys_animation_target* targets,
                                                          uint32_t stride);
/** Animation targets of particles as they were set; 0 and INFINITY of what has none.
 *  @param first        as in gphys_solver_get_positions
 *  @param count        as in gphys_solver_get_positions
 *  @param out_targets  count elements
 *  Cost: O(count).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_animation_targets(const gphys_solver* solver, gphys_body_id body,
                                                          uint32_t first, uint32_t count,
                                                          gphys_animation_target* out_targets, uint32_t out_stride);

/** Fix a particle to a model: it follows the model's transform in each step, and is released when
 *  the model is gone. Steps must then be given this scene; in a step without one the particle stays where it is.
 *  If the model jumps (gphys_solver_step), the whole body goes with it as if it were rigid, and its velocities turn
 *  with it: a cape stays on a character that respawns. Bodies with other pinned particles, joints, or attachments to
 *  models that go elsewhere do not, nor do bodies without constraints.
 *  @param scene        of the same origin as the solver; not modified
 *  @param local_point  in the model's coordinates, to which its transform applies, with the transform's scale, and not
 *                      gphys_scene_set_scale; NULL: where the particle is now
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist
 *  Cost: O(1); allocates. */
GPHYS_API gphys_status gphys_solver_attach(gphys_solver* solver, const gphys_scene* scene, gphys_body_id body,
                                           uint32_t particle, gphys_model_id model, const gphys_vec3* local_point);
/** Release an attached particle.
 *  @return GPHYS_ERROR_INVALID_ARGUMENT if it is not attached, or does not exist
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_solver_detach(gphys_solver* solver, gphys_body_id body, uint32_t particle);

/** A particle that is attached to a model. Frozen.  Since 1.1. */
typedef struct gphys_attachment {
    uint32_t particle;
    gphys_model_id model;
    gphys_vec3 local_point; /* in the model's coordinates, as for gphys_solver_attach */
} gphys_attachment;

/** The attachments of a body, by particle. One to a model that is gone is listed until the next step. Kept when too
 *  many: the first.
 *  Cost: O(attachments).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_attachments(const gphys_solver* solver, gphys_body_id body,
                                                    gphys_attachment* out_attachments, uint32_t capacity,
                                                    uint32_t* out_total);

/** Hold two different particles of a body at a distance.
 *  @param rest_length  metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
 *  @param compliance   metres per newton, >= 0; 0 is rigid
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or twice the same one;
 *          GPHYS_ERROR_CAPACITY beyond 2^24 - 1 constraints of a body
 *  Cost: O(1); the next step plans the body again, O(constraints). */
GPHYS_API gphys_status gphys_solver_add_distance(gphys_solver* solver, gphys_body_id body, uint32_t particle_a,
                                                 uint32_t particle_b, float rest_length, float compliance,
                                                 gphys_constraint_id* out_constraint);
/** Keep two different particles of a body from being further apart than a length, like a string between
 *  them: it pulls and never pushes. While it is slack it does nothing; when it becomes taut, and is
 *  rigid, only the speed at which the particles separate is lost.
 *  @param max_length  metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
 *  @param compliance  metres per newton, >= 0, of what it yields beyond that; 0 is rigid
 *  @return as gphys_solver_add_distance
 *  It is a constraint like others: listed with max_length as its rest_length, removed as they are, and
 *  strained only when it is too long. Cost: as gphys_solver_add_distance. */
GPHYS_API gphys_status gphys_solver_add_max_distance(gphys_solver* solver, gphys_body_id body, uint32_t particle_a,
                                                     uint32_t particle_b, float max_length, float compliance,
                                                     gphys_constraint_id* out_constraint);
/** Damp a constraint that has compliance: when its ends separate at speed v, it pulls with damping * v in
 *  addition to its tension; one of gphys_solver_add_max_distance never pushes. The decay depends on time, not
 *  on steps. Rigid constraints have nothing to damp.
 *  @param damping  N s/m, >= 0; 0, which every constraint begins with: none
 *  @return GPHYS_ERROR_INVALID_ID for a body or constraint that does not exist
 *  Cost: as gphys_solver_add_distance. */
GPHYS_API gphys_status gphys_solver_set_constraint_damping(gphys_solver* solver, gphys_body_id body,
                                                           gphys_constraint_id constraint, float damping);
/** Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body; setting
 *  it again changes it, which inflates a body.
 *  @param rest_volume  m^3, > 0; negative: the present volume
 *  @param compliance   m^3 per pascal, >= 0: the volume that a pressure of one pascal takes; 0: as water,
 *                      which keeps its volume; INFINITY: none, which ends the constraint
 *  @return GPHYS_ERROR_UNSUPPORTED if the triangles do not close (each side is that of two triangles), are
 *          not oriented consistently, or face inward when the present volume is asked for
 *  Cost: O(triangles) in each substep, twice. Allocates. */
GPHYS_API gphys_status gphys_solver_set_volume(gphys_solver* solver, gphys_body_id body, float rest_volume,
                                               float compliance);
/** The volume held by gphys_solver_set_volume, m^3, as it is, and the pressure in pascals with which it was
 *  held at the end of the last step: above 0 it pushes outward.
 *  @param out_volume    may be NULL
 *  @param out_pressure  may be NULL
 *  @return GPHYS_ERROR_UNSUPPORTED if none is held
 *  Cost: O(triangles). */
GPHYS_API gphys_status gphys_solver_get_volume(const gphys_solver* solver, gphys_body_id body, float* out_volume,
                                               float* out_pressure);
/** What was given to gphys_solver_set_volume: m^3 (for a negative volume the one at that time), and m^3 per pascal.
 *  @param out_rest_volume  may be NULL
 *  @param out_compliance   may be NULL
 *  @return GPHYS_ERROR_UNSUPPORTED if none is held
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_volume_settings(const gphys_solver* solver, gphys_body_id body,
                                                        float* out_rest_volume, float* out_compliance);
/** Remove a constraint of a body, even one created with it. Its id stays invalid. Wakes the body. The triangles of
 *  cloth stay together: gphys_solver_break_constraint tears them apart.
 *  @return GPHYS_ERROR_INVALID_ID for a body or constraint that does not exist, or no longer
 *  Cost: as gphys_solver_add_distance; allocates. */
GPHYS_API gphys_status gphys_solver_remove_constraint(gphys_solver* solver, gphys_body_id body,
                                                      gphys_constraint_id constraint);

/** One constraint. Frozen. */
typedef struct gphys_constraint_info {
    gphys_constraint_id id;
    uint32_t particle_a, particle_b;
    float rest_length; /* metres */
    float compliance;  /* metres per newton */
} gphys_constraint_info;

/** All constraints of a body, including those created with the body, by id. Kept when too many: the lowest.
 *  Cost: O(constraints). */
GPHYS_API gphys_status gphys_solver_get_constraints(const gphys_solver* solver, gphys_body_id body,
                                                    gphys_constraint_info* out_constraints, uint32_t capacity,
                                                    uint32_t* out_total);

/** What a constraint holds. */
typedef int32_t gphys_constraint_kind;
enum {
    GPHYS_CONSTRAINT_DISTANCE = 0,    /* its length: gphys_solver_add_distance, and those created with a body */
    GPHYS_CONSTRAINT_MAX_DISTANCE = 1 /* at most its length; it may go slack: gphys_solver_add_max_distance */
};

/** Which constraints keep a length, and which a maximum.
 *  @param constraints  count ids; one may appear twice
 *  @param out_kinds    count elements
 *  Cost: O(count).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_constraint_kinds(const gphys_solver* solver, gphys_body_id body,
                                                         const gphys_constraint_id* constraints, uint32_t count,
                                                         gphys_constraint_kind* out_kinds, uint32_t out_stride);

/** The settings of a constraint. Frozen. */
typedef struct gphys_constraint_settings {
    float rest_length; /* metres, >= 0, below 1e-9 as 0; negative, when it is set: the present distance */
    float compliance;  /* metres per newton, >= 0; 0 is rigid */
    float damping;     /* N s/m, >= 0, of what has compliance; see gphys_solver_set_constraint_damping */
} gphys_constraint_settings;

/** The present settings of constraints.
 *  @param constraints   count ids; one may appear twice
 *  @param out_settings  count elements
 *  Cost: O(count). */
GPHYS_API gphys_status gphys_solver_get_constraint_settings(const gphys_solver* solver, gphys_body_id body,
                                                            const gphys_constraint_id* constraints, uint32_t count,
                                                            gphys_constraint_settings* out_settings,
                                                            uint32_t out_stride);
/** Change constraints while they act, all or none: winches, muscles. A rest length goes from the old to the
 *  new one at constant speed during the next step; a winch that reels in at v m/s is given a length that is v dt
 *  shorter before each step of dt. Wakes the body.
 *  @param constraints  count ids; one that appears twice gets the last
 *  @param settings     count elements; a stride of 0 gives all the same
 *  Cost: O(count); in the next step O(constraints) to pack them again, of rigid cloth with pins that gets longer
 *  links O(n log n). Chains are not planned again. Allocates. */
GPHYS_API gphys_status gphys_solver_set_constraint_settings(gphys_solver* solver, gphys_body_id body,
                                                            const gphys_constraint_id* constraints,
                                                            const gphys_constraint_settings* settings,
                                                            uint32_t setting_stride, uint32_t count);

typedef uint32_t gphys_cluster_id;

/** Make particles of a body a rigid cluster: they keep the shape in which they are now, and move and turn as one stiff
 *  part, such as a plank of a bridge, a crate or a plate of armour. Links between them are not needed. A particle may
 *  be in several clusters: planks with two particles in common are hinged there, with one they are jointed.
 *  The mass of a cluster is that of its particles; hollow shapes are light in the middle. Particles that are pinned or
 *  attached stay where they are held: with one the cluster swings about it, with two about the line through them, and
 *  with three that are not on a line it does not move. Models that particles are attached to get the impulses. Contacts
 *  with models move the cluster as a whole, with friction; only particles touch, not the faces between them, so they
 *  should be no further apart than the thickness of the thinnest thing that a cluster meets. It
 *  bounces as a whole, too; one that is held, joined, or shares particles shows only the share of its restitution that
 *  its particles in contact have of its mass.
 *  A shape is matched once in each substep, after the links: then what hangs from it by links may be strained a
 *  little, and clusters that share particles approach their shapes in eight passes. What is joined to it by
 *  gphys_solver_join is solved together with it, unless one of its particles is attached, or another cluster has it,
 *  too: hang heavy loads, or a light cluster under a heavy load, by joints. Bodies with clusters are solved as cloth
 *  (GPHYS_SOLVE_GRAPH), ropes and free particles too. The rest positions of cloth are not changed by a cluster.
 *  @param particles  count different particles, at least 2
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or appears twice; GPHYS_ERROR_CAPACITY
 *          beyond 2^24 - 1 clusters of a body, or that many particles in them
 *  Cost: O(particles); allocates. In each substep about 1 us a cluster, 50 ns a particle of it and 0.3 us one that
 *  touches a model, and up to eight times that if clusters of the body share particles; the first and the last
 *  cluster plan the body again, O(constraints).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_add_cluster(gphys_solver* solver, gphys_body_id body, const uint32_t* particles,
                                                uint32_t count, gphys_cluster_id* out_cluster);
/** End a cluster. Its particles stay where they are; its id stays invalid. Wakes the body.
 *  @return GPHYS_ERROR_INVALID_ID for a body or cluster that does not exist, or no longer
 *  Cost: O(particles in clusters of the body).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_remove_cluster(gphys_solver* solver, gphys_body_id body, gphys_cluster_id cluster);
/** All clusters of a body, by id. Kept when too many: the lowest.
 *  Cost: O(clusters).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_clusters(const gphys_solver* solver, gphys_body_id body,
                                                 gphys_cluster_id* out_clusters, uint32_t capacity,
                                                 uint32_t* out_total);
/** The particles of a cluster, in the order in which they were given. Kept when too many: the first.
 *  @return GPHYS_ERROR_INVALID_ID for a body or cluster that does not exist, or no longer
 *  Cost: O(particles of the cluster).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_cluster_particles(const gphys_solver* solver, gphys_body_id body,
                                                          gphys_cluster_id cluster, uint32_t* out_particles,
                                                          uint32_t capacity, uint32_t* out_total);

typedef uint32_t gphys_joint_id;

/** Hold a particle of one body and a particle of another at a distance. Both are moved, by forces that are
 *  equal and opposite; either may be pinned or attached. Joined ropes, free particles and rigid clusters are
 *  solved as one system, as stiff as one rope; a joined particle of cloth has the inertia of all that hangs on it. Free
 *  particles of a joined body are moved by the time scheme of ropes, no longer exactly. Joined bodies are moved by
 *  one thread and fall asleep and wake together. A joint is removed with either body. Particles of the two that
 *  are linked to a joint within touch of each other do not collide there.
 *  @param rest_length  metres; 0: at the same place, as below 1e-9; negative: the present distance. Particles
 *                      at another distance are moved to it in the next step; by a rigid joint without speed.
 *  @param compliance   metres per newton, >= 0; 0 is rigid
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or twice the same body (see
 *          gphys_solver_add_distance); GPHYS_ERROR_CAPACITY beyond 2^24 - 1 joints
 *  Cost: the next step plans all joined ropes again. A link of them takes 2.5 to 4 times as long as one
 *  of a rope that is not joined. Allocates. */
GPHYS_API gphys_status gphys_solver_join(gphys_solver* solver, gphys_body_id body_a, uint32_t particle_a,
                                         gphys_body_id body_b, uint32_t particle_b, float rest_length, float compliance,
                                         gphys_joint_id* out_joint);
/** End a joint. Wakes both bodies.
 *  @return GPHYS_ERROR_INVALID_ID for a joint that does not exist, or no longer
 *  Cost: as gphys_solver_join. */
GPHYS_API gphys_status gphys_solver_unjoin(gphys_solver* solver, gphys_joint_id joint);

/** One joint. Frozen. */
typedef struct gphys_joint_info {
    gphys_joint_id id;
    gphys_body_id body_a;
    uint32_t particle_a;
    gphys_body_id body_b;
    uint32_t particle_b;
    float rest_length; /* metres */
    float compliance;  /* metres per newton */
    float force;       /* newtons, in the last substep: > 0 pulls them together, < 0 keeps them apart; its
                          magnitude for a rest length of 0 */
} gphys_joint_info;

/** Joints of a body, by id. Kept when too many: the lowest.
 *  @param body  0: of all bodies
 *  Cost: O(joints of the solver). */
GPHYS_API gphys_status gphys_solver_get_joints(const gphys_solver* solver, gphys_body_id body,
                                               gphys_joint_info* out_joints, uint32_t capacity, uint32_t* out_total);

/** A constraint that broke, or that the caller has broken. Frozen.  Since 1.1. */
typedef struct gphys_break {
    gphys_body_id body;
    gphys_constraint_id constraint;
    uint32_t particle_a, particle_b; /* its particles before */
    uint32_t torn_particle;          /* where cloth parted; GPHYS_NO_PARTICLE: nowhere, the constraint was removed */
    uint32_t new_particle;           /* its copy, the last of the body; GPHYS_NO_PARTICLE: none */
    float load;                      /* newtons; 0 if the caller broke it */
} gphys_break;
/* A constraint with a breaking force breaks at the end of a step in which its load was larger. The load is its mean
 * tension in the step, which does not depend on the number of substeps; a blow counts by its momentum divided by dt.
 * Compression breaks nothing.
 *
 * Ropes lose the constraint. Cloth tears: its triangles around an end of the constraint part at the plane through that
 * particle across the constraint. Those on the side of the constraint get a copy of the particle, with their share of
 * its mass, the same velocity, and the constraints of that side; both sides have those along the cut. Triangles
 * keep their numbers. Of two ends a free one is preferred, and one at an edge of the cloth, so that tears continue
 * where they began. A constraint that is no edge of a triangle is removed where the cloth cannot part; one that is an
 * edge holds there. The copy is not pinned, attached, joined, or in a cluster; the gas escapes: a volume that
 * gphys_solver_set_volume holds ends.
 *
 * Each break changes the loads, so a step breaks at most one constraint for each 128 particles of a body or part of
 * 128, the most overloaded first, and no two adjacent ones. A body with breaking forces has no long range
 * attachments to its pins, which would carry loads past its constraints: where it is pinned it hangs with more strain.
 * docs/solver.md has measured all this. Sources: Mueller et al. 2007, "Position based dynamics"; Souza et al. 2014,
 * "Fast simulation of cloth tearing". */

/** Breaking forces of constraints. Wakes the body.
 *  @param constraints  count ids; one that appears twice gets the last
 *  @param forces       newtons, >= 0; 0: never breaks, as all that are added to a body later; a stride of 0 gives all
 *                      the same
 *  Cost: O(count + constraints); of cloth that gets its first or loses its last one also that of a pin. Allocates.
 *  Since 1.1. */
GPHYS_API gphys_status gphys_solver_set_breaking_forces(gphys_solver* solver, gphys_body_id body,
                                                        const gphys_constraint_id* constraints, const float* forces,
                                                        uint32_t force_stride, uint32_t count);
/** What gphys_solver_set_breaking_forces or gphys_body_desc.breaking_force has set; 0: never breaks.
 *  @param constraints  count ids; one may appear twice
 *  @param out_forces   newtons; count elements
 *  Cost: O(count).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_breaking_forces(const gphys_solver* solver, gphys_body_id body,
                                                        const gphys_constraint_id* constraints, uint32_t count,
                                                        float* out_forces, uint32_t out_stride);
/** Break a constraint as a load would, whatever its breaking force: scissors, claws. Wakes the body.
 *  @param out_result  what came of it; may be NULL
 *  @return GPHYS_ERROR_UNSUPPORTED, and nothing has changed, for an edge where the cloth cannot part: of a triangle
 *          that is connected to no other; GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles or constraints
 *  Cost: O(particles + constraints); allocates.  Since 1.1. */
GPHYS_API gphys_status gphys_solver_break_constraint(gphys_solver* solver, gphys_body_id body,
                                                     gphys_constraint_id constraint, gphys_break* out_result);
/** Constraints that broke in the last gphys_solver_step or gphys_solver_advance, in its order: for sounds, dust, and to
 *  know that a body has more particles. Not those that the caller broke. They are not part of snapshots: after
 *  gphys_solver_restore there are none. Kept when too many: the first.
 *  Cost: O(breaks); no allocation. The same bits for any number of workers.  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_breaks(const gphys_solver* solver, gphys_break* out_breaks, uint32_t capacity,
                                               uint32_t* out_total);

/** Simulate dt seconds in the set number of substeps, or as many as the error targets ask for; cloth
 *  takes more where they would be longer than 25 ms.
 *  @param scene  to collide with and to follow attachments; NULL: none. Not modified.
 *  @param dt     seconds, 1e-6 .. 0.5
 *  Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s through particles.
 *  A model moves evenly from its place at the last step to its present one, unless it jumps: it turns by a right angle
 *  or more, its velocity changes by more than 50 m/s to more than that, or its surface does by a change of scale. One
 *  that jumps is not swept and gives no speed. What is then within a solid is pushed out slowly; what is then behind a
 *  plane or a mesh stays there. Allocates when what it steps has changed.
 *  Cost: O(particles + constraints) a substep, and a scene query for particles near models; O(1) and a scene query for
 *  a body that the last step, of the same dt, left exactly as it was. */
GPHYS_API gphys_status gphys_solver_step(gphys_solver* solver, const gphys_scene* scene, float dt);
/** Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next
 *  frame, so the motion does not depend on the frame rate. Models, pins and animation targets are given
 *  the places of the end of the frame. They move there evenly in the time since the last step: attached particles,
 *  pins and what lies on models are at their places of the time that the solver has reached, out_leftover of a step
 *  before that of the frame. Impulses, contacts and breaks are those of the last step.
 *  @param frame_time    seconds, >= 0
 *  @param out_steps     steps made; may be NULL
 *  @param out_leftover  0 <= fraction of a step still owed < 1, to interpolate when drawing; may be NULL
 *  @return GPHYS_ERROR_OUT_OF_MEMORY if there is none for the first step: nothing has changed. If there
 *          is none for a later one, GPHYS_OK with the steps made; the others are left out, as those beyond
 *          max_steps are
 *  Cost: that of the steps made. */
GPHYS_API gphys_status gphys_solver_advance(gphys_solver* solver, const gphys_scene* scene, float frame_time,
                                            uint32_t* out_steps, float* out_leftover);

/** The fraction of a step that gphys_solver_advance still owes: what it gave last as out_leftover, unless the solver
 *  was restored or given another fixed_step since.
 *  @param out_leftover  from 0 to below 1
 *  Cost: O(1).  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_leftover(const gphys_solver* solver, float* out_leftover);

/** The substeps that a body took in the last step; 0 before its first.
 *  With gphys_solver_desc.max_strain or tolerance set, each body takes as many as its own motion needs:
 *  their length follows from what the last step measured, the largest strain of its rigid constraints
 *  and the local error of the time scheme, both proportional to the square of that length. It is at
 *  most quartered and grows by at most an eighth from one step to the next, so a sudden impact exceeds a
 *  target for a few steps; one of strain only where links of cloth cannot be relaxed below it. A target that
 *  cannot be met takes max_substeps, unless the strain of cloth stays above eight times the target. Where
 *  positions jump, by contacts, the error is that of the jump. What may meet others takes at least the set number.
 *  Cost: O(1). */
GPHYS_API gphys_status gphys_solver_get_substeps(const gphys_solver* solver, gphys_body_id body,
                                                 uint32_t* out_substeps);

/** Frozen. */
typedef struct gphys_solver_stats {
    uint32_t particle_count;
    uint32_t pinned_count; /* pinned or attached */
    uint32_t constraint_count;
    uint32_t contact_count; /* particle and model pairs that touched in the last step, 4 a particle at most */
    float strain_max;       /* largest |length / rest length - 1| of rigid constraints whose rest length is not 0 */
    float strain_rms;       /* root mean square of the same */
    float kinetic_energy;   /* joules */
    float potential_energy; /* joules: of gravity, 0 at the solver's origin, of stretch, bending and held volumes */
} gphys_solver_stats;

/** Counts, strain and energy of a body at present.
 *  @param body  0: all bodies together
 *  Cost: O(particles + constraints). */
GPHYS_API gphys_status gphys_solver_get_stats(const gphys_solver* solver, gphys_body_id body,
                                              gphys_solver_stats* out_stats);

/** A particle that touched a model in the last step. Frozen. */
typedef struct gphys_contact {
    gphys_body_id body;
    uint32_t particle;
    gphys_model_id model;
    uint32_t tag;      /* the model's */
    gphys_vec3 point;  /* on the model, world space */
    gphys_vec3 normal; /* unit, from the model to the particle */
} gphys_contact;

/** Contacts of the last step by body, particle, model. Kept when too many: the first.
 *  Cost: O(contacts). */
GPHYS_API gphys_status gphys_solver_get_contacts(const gphys_solver* solver, gphys_contact* out_contacts,
                                                 uint32_t capacity, uint32_t* out_total);

/** Two particles of different bodies that touched in the last step. Frozen.  Since 1.1. */
typedef struct gphys_body_contact {
    gphys_body_id body_a;
    uint32_t particle_a;
    gphys_body_id body_b; /* above body_a */
    uint32_t particle_b;
    gphys_vec3 normal; /* unit, from a to b, when they touched last */
    float distance;    /* metres between their surfaces as they are now; below 0: they overlap */
    float impulse;     /* N s along normal, of the whole step: b got it, and a its opposite. The reactions of links and
                          models are not in it */
} gphys_body_contact;

/** Contacts between bodies in the last step, of any substep, by body_a, particle_a, body_b, particle_b: for sounds,
 *  damage and sparks. Of sleeping bodies those of the step in which they fell asleep. Contacts with a body that was
 *  removed are no longer listed. They are not part of snapshots: after gphys_solver_restore there are none until the
 *  next step. Contacts within a body (gphys_body_desc.self_collision) are not listed. Kept when too many: the first;
 *  where particles have more than 12 contacts on average, not all are known.
 *  Cost: O(contacts); no allocation. The same bits for any number of workers.  Since 1.1. */
GPHYS_API gphys_status gphys_solver_get_body_contacts(const gphys_solver* solver, gphys_body_contact* out_contacts,
                                                      uint32_t capacity, uint32_t* out_total);

/** What bodies gave a model in the last step, by contacts and by attachments. Frozen. */
typedef struct gphys_impulse {
    gphys_model_id model;
    uint32_t tag;       /* the model's */
    gphys_vec3 linear;  /* N s: what to add to the momentum of the model if it is a body of yours */
    gphys_vec3 angular; /* N m s, about the model's position in the world: likewise for its angular momentum */
} gphys_impulse;

/** Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the step in
 *  which they fell asleep. Kept when too many: the lowest models.
 *  After gphys_solver_advance, times the steps that it made, they are those of the frame.
 *  Divided by dt they are mean forces: what lies on a model presses on it with its weight. A particle
 *  of cloth that touches several models at once gives its impulse to the one that it touches most. Models have no mass
 *  here: the step does as if they went where you put them, whatever the force. So a rope between a held end and a body
 *  of yours must be elastic, its stiffness times dt^2 well below the mass of the body, which needs some damping; a body
 *  of yours much lighter than what hangs from it should be moved in small steps.
 *  Cost: O(models touched); no allocation. The same bits for any number of workers. */
GPHYS_API gphys_status gphys_solver_get_impulses(const gphys_solver* solver, gphys_impulse* out_impulses,
                                                 uint32_t capacity, uint32_t* out_total);

/** Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and impulses, time
 *  that gphys_solver_advance still owes. The scene, workers and allocator are not in it.
 *  @param out_words  the snapshot; written as a whole, or not at all when capacity is too small. It is
 *                    for the same release of the library and machines of the same byte order; it may
 *                    be stored, but not changed.
 *  @return GPHYS_INCOMPLETE when *out_total > capacity; GPHYS_ERROR_CAPACITY beyond 2^32 - 1 words
 *  Cost: O(particles + constraints), some 50 words for each. */
GPHYS_API gphys_status gphys_solver_get_snapshot(const gphys_solver* solver, uint32_t* out_words, uint32_t capacity,
                                                 uint32_t* out_total);
/** Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
 *  time of the snapshot. Steps continue with the same bits as they did then, provided that the scene,
 *  too, is as it was. On an error the solver is as before.
 *  Any words are safe, also from an untrusted source: all that is used as a number or an index is
 *  checked first. Forged words are refused, or taken as a state whose numbers are in range.
 *  @return GPHYS_ERROR_INVALID_ARGUMENT for words that are no snapshot, damaged, of another version or
 *          byte order; GPHYS_ERROR_OUT_OF_MEMORY if there is no room for it
 *  Cost: as gphys_solver_get_snapshot; allocates. */
GPHYS_API gphys_status gphys_solver_restore(gphys_solver* solver, const uint32_t* words, uint32_t count);
/** A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
 *  different ones differ with near certainty (not against an adversary). Compare it between machines
 *  that run the same simulation, to detect when they diverge. Cost: O(particles + constraints). */
GPHYS_API gphys_status gphys_solver_get_hash(const gphys_solver* solver, uint32_t out_hash[2]);

#ifdef __cplusplus
}
#endif

#endif /* GAMEPHYS_C_H */

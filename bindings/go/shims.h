/* Generated from gamephys_api.json by bindings/generate.py. Not for editing.
 *
 * Results come back as values: what cgo is given a pointer to has to live on Go's heap. The
 * message comes along, because it belongs to the thread, and a goroutine may change that. Objects are
 * void*, because cgo allocates for each pointer to a struct that it does not know. */
#ifndef GAMEPHYS_GO_SHIMS_H
#define GAMEPHYS_GO_SHIMS_H

#include <gamephys_c.h>
#include <stdlib.h>
#include <string.h>

/* A copy of the error's message, to be freed. */
static inline char* go_message(gphys_status status) { return status < 0 ? strdup(gphys_last_error()) : NULL; }

typedef struct go_gphys_shape_validate_result {
    gphys_status status;
    char* message;
} go_gphys_shape_validate_result;
static inline go_gphys_shape_validate_result go_gphys_shape_validate(gphys_shape_type type, const void * shape) {
    go_gphys_shape_validate_result r = {0};
    r.status = gphys_shape_validate(type, shape);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_bounds_result {
    gphys_status status;
    char* message;
    gphys_aabb out_bounds;
} go_gphys_shape_bounds_result;
static inline go_gphys_shape_bounds_result go_gphys_shape_bounds(gphys_shape_type type, const void * shape) {
    go_gphys_shape_bounds_result r = {0};
    r.status = gphys_shape_bounds(type, shape, &r.out_bounds);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_transform_result {
    gphys_status status;
    char* message;
} go_gphys_shape_transform_result;
static inline go_gphys_shape_transform_result go_gphys_shape_transform(gphys_shape_type type, const void * shape, gphys_transform transform, void * out_shape) {
    go_gphys_shape_transform_result r = {0};
    r.status = gphys_shape_transform(type, shape, &transform, out_shape);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_contains_result {
    gphys_status status;
    char* message;
    int32_t out_contains;
} go_gphys_shape_contains_result;
static inline go_gphys_shape_contains_result go_gphys_shape_contains(gphys_shape_type type, const void * shape, gphys_vec3 point, float tolerance) {
    go_gphys_shape_contains_result r = {0};
    r.status = gphys_shape_contains(type, shape, &point, tolerance, &r.out_contains);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_contains_batch_result {
    gphys_status status;
    char* message;
} go_gphys_shape_contains_batch_result;
static inline go_gphys_shape_contains_batch_result go_gphys_shape_contains_batch(gphys_shape_type type, const void * shape, const gphys_vec3 * points, uint32_t point_stride, uint32_t count, float tolerance, int32_t * out_contains, uint32_t out_stride) {
    go_gphys_shape_contains_batch_result r = {0};
    r.status = gphys_shape_contains_batch(type, shape, points, point_stride, count, tolerance, out_contains, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_closest_point_result {
    gphys_status status;
    char* message;
    gphys_nearest out_nearest;
} go_gphys_shape_closest_point_result;
static inline go_gphys_shape_closest_point_result go_gphys_shape_closest_point(gphys_shape_type type, const void * shape, gphys_vec3 point) {
    go_gphys_shape_closest_point_result r = {0};
    r.status = gphys_shape_closest_point(type, shape, &point, &r.out_nearest);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_closest_point_batch_result {
    gphys_status status;
    char* message;
} go_gphys_shape_closest_point_batch_result;
static inline go_gphys_shape_closest_point_batch_result go_gphys_shape_closest_point_batch(gphys_shape_type type, const void * shape, const gphys_vec3 * points, uint32_t point_stride, uint32_t count, gphys_nearest * out_nearest, uint32_t out_stride) {
    go_gphys_shape_closest_point_batch_result r = {0};
    r.status = gphys_shape_closest_point_batch(type, shape, points, point_stride, count, out_nearest, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_segment_closest_points_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_a;
    gphys_vec3 out_b;
    float out_distance;
} go_gphys_segment_closest_points_result;
static inline go_gphys_segment_closest_points_result go_gphys_segment_closest_points(gphys_segment a, gphys_segment b) {
    go_gphys_segment_closest_points_result r = {0};
    r.status = gphys_segment_closest_points(&a, &b, &r.out_a, &r.out_b, &r.out_distance);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_overlaps_result {
    gphys_status status;
    char* message;
    int32_t out_overlaps;
} go_gphys_shape_overlaps_result;
static inline go_gphys_shape_overlaps_result go_gphys_shape_overlaps(gphys_shape_type a_type, const void * a, gphys_shape_type b_type, const void * b) {
    go_gphys_shape_overlaps_result r = {0};
    r.status = gphys_shape_overlaps(a_type, a, b_type, b, &r.out_overlaps);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_overlaps_batch_result {
    gphys_status status;
    char* message;
} go_gphys_shape_overlaps_batch_result;
static inline go_gphys_shape_overlaps_batch_result go_gphys_shape_overlaps_batch(gphys_shape_type a_type, const void * a, uint32_t a_stride, gphys_shape_type b_type, const void * b, uint32_t b_stride, uint32_t count, int32_t * out_overlaps, uint32_t out_stride) {
    go_gphys_shape_overlaps_batch_result r = {0};
    r.status = gphys_shape_overlaps_batch(a_type, a, a_stride, b_type, b, b_stride, count, out_overlaps, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_classify_plane_result {
    gphys_status status;
    char* message;
    gphys_side out_side;
    float out_signed_distance;
} go_gphys_shape_classify_plane_result;
static inline go_gphys_shape_classify_plane_result go_gphys_shape_classify_plane(gphys_shape_type type, const void * shape, gphys_plane plane) {
    go_gphys_shape_classify_plane_result r = {0};
    r.status = gphys_shape_classify_plane(type, shape, &plane, &r.out_side, &r.out_signed_distance);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_classify_frustum_result {
    gphys_status status;
    char* message;
    gphys_side out_side;
} go_gphys_shape_classify_frustum_result;
static inline go_gphys_shape_classify_frustum_result go_gphys_shape_classify_frustum(gphys_shape_type type, const void * shape, gphys_frustum frustum) {
    go_gphys_shape_classify_frustum_result r = {0};
    r.status = gphys_shape_classify_frustum(type, shape, &frustum, &r.out_side);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_raycast_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_shape_raycast_result;
static inline go_gphys_shape_raycast_result go_gphys_shape_raycast(gphys_shape_type type, const void * shape, gphys_ray ray) {
    go_gphys_shape_raycast_result r = {0};
    r.status = gphys_shape_raycast(type, shape, &ray, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_raycast_batch_result {
    gphys_status status;
    char* message;
} go_gphys_shape_raycast_batch_result;
static inline go_gphys_shape_raycast_batch_result go_gphys_shape_raycast_batch(gphys_shape_type type, const void * shape, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_shape_raycast_batch_result r = {0};
    r.status = gphys_shape_raycast_batch(type, shape, rays, ray_stride, count, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_segment_test_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_shape_segment_test_result;
static inline go_gphys_shape_segment_test_result go_gphys_shape_segment_test(gphys_shape_type type, const void * shape, gphys_segment segment) {
    go_gphys_shape_segment_test_result r = {0};
    r.status = gphys_shape_segment_test(type, shape, &segment, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_sweep_sphere_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_shape_sweep_sphere_result;
static inline go_gphys_shape_sweep_sphere_result go_gphys_shape_sweep_sphere(gphys_shape_type type, const void * shape, gphys_sphere sphere, gphys_vec3 displacement) {
    go_gphys_shape_sweep_sphere_result r = {0};
    r.status = gphys_shape_sweep_sphere(type, shape, &sphere, &displacement, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_sweep_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_shape_sweep_result;
static inline go_gphys_shape_sweep_result go_gphys_shape_sweep(gphys_shape_type type, const void * shape, gphys_shape_type moving_type, const void * moving, gphys_vec3 displacement) {
    go_gphys_shape_sweep_result r = {0};
    r.status = gphys_shape_sweep(type, shape, moving_type, moving, &displacement, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_sweep_batch_result {
    gphys_status status;
    char* message;
} go_gphys_shape_sweep_batch_result;
static inline go_gphys_shape_sweep_batch_result go_gphys_shape_sweep_batch(gphys_shape_type type, const void * shapes, uint32_t shape_stride, gphys_shape_type moving_type, const void * moving, uint32_t moving_stride, const gphys_vec3 * displacements, uint32_t displacement_stride, uint32_t count, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_shape_sweep_batch_result r = {0};
    r.status = gphys_shape_sweep_batch(type, shapes, shape_stride, moving_type, moving, moving_stride, displacements, displacement_stride, count, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_penetration_result {
    gphys_status status;
    char* message;
    gphys_penetration out_penetration;
} go_gphys_shape_penetration_result;
static inline go_gphys_shape_penetration_result go_gphys_shape_penetration(gphys_shape_type type, const void * shape, gphys_shape_type moving_type, const void * moving) {
    go_gphys_shape_penetration_result r = {0};
    r.status = gphys_shape_penetration(type, shape, moving_type, moving, &r.out_penetration);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_shape_penetration_batch_result {
    gphys_status status;
    char* message;
} go_gphys_shape_penetration_batch_result;
static inline go_gphys_shape_penetration_batch_result go_gphys_shape_penetration_batch(gphys_shape_type type, const void * shapes, uint32_t shape_stride, gphys_shape_type moving_type, const void * moving, uint32_t moving_stride, uint32_t count, gphys_penetration * out_penetrations, uint32_t out_stride) {
    go_gphys_shape_penetration_batch_result r = {0};
    r.status = gphys_shape_penetration_batch(type, shapes, shape_stride, moving_type, moving, moving_stride, count, out_penetrations, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_frustum_corners_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_corners[8];
} go_gphys_frustum_corners_result;
static inline go_gphys_frustum_corners_result go_gphys_frustum_corners(gphys_frustum frustum) {
    go_gphys_frustum_corners_result r = {0};
    r.status = gphys_frustum_corners(&frustum, r.out_corners);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_planes_intersection_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_point;
} go_gphys_planes_intersection_result;
static inline go_gphys_planes_intersection_result go_gphys_planes_intersection(gphys_plane a, gphys_plane b, gphys_plane c) {
    go_gphys_planes_intersection_result r = {0};
    r.status = gphys_planes_intersection(&a, &b, &c, &r.out_point);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_planes_intersection_batch_result {
    gphys_status status;
    char* message;
} go_gphys_planes_intersection_batch_result;
static inline go_gphys_planes_intersection_batch_result go_gphys_planes_intersection_batch(const gphys_plane * a, uint32_t a_stride, const gphys_plane * b, uint32_t b_stride, const gphys_plane * c, uint32_t c_stride, uint32_t count, gphys_vec3 * out_points, uint32_t out_stride) {
    go_gphys_planes_intersection_batch_result r = {0};
    r.status = gphys_planes_intersection_batch(a, a_stride, b, b_stride, c, c_stride, count, out_points, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mat4_orthonormality_result {
    gphys_status status;
    char* message;
    float out_deviation;
} go_gphys_mat4_orthonormality_result;
static inline go_gphys_mat4_orthonormality_result go_gphys_mat4_orthonormality(gphys_mat4 matrix) {
    go_gphys_mat4_orthonormality_result r = {0};
    r.status = gphys_mat4_orthonormality(&matrix, &r.out_deviation);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_frustum_from_matrix_result {
    gphys_status status;
    char* message;
    gphys_frustum out_frustum;
} go_gphys_frustum_from_matrix_result;
static inline go_gphys_frustum_from_matrix_result go_gphys_frustum_from_matrix(gphys_mat4 view_projection, gphys_depth_range depth_range, int32_t reverse_z) {
    go_gphys_frustum_from_matrix_result r = {0};
    r.status = gphys_frustum_from_matrix(&view_projection, depth_range, reverse_z, &r.out_frustum);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_check_result {
    gphys_status status;
    char* message;
    gphys_mesh_report out_report;
} go_gphys_mesh_check_result;
static inline go_gphys_mesh_check_result go_gphys_mesh_check(const float * vertices, uint32_t vertex_stride, uint32_t vertex_count, const uint32_t * indices, uint32_t index_count) {
    go_gphys_mesh_check_result r = {0};
    r.status = gphys_mesh_check(vertices, vertex_stride, vertex_count, indices, index_count, &r.out_report);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_desc_init_result {
    gphys_status status;
    char* message;
    gphys_mesh_desc desc;
} go_gphys_mesh_desc_init_result;
static inline go_gphys_mesh_desc_init_result go_gphys_mesh_desc_init(uint32_t size) {
    go_gphys_mesh_desc_init_result r = {0};
    r.status = gphys_mesh_desc_init(&r.desc, size);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_create_result {
    gphys_status status;
    char* message;
    void* out_mesh;
} go_gphys_mesh_create_result;
static inline go_gphys_mesh_create_result go_gphys_mesh_create(const gphys_mesh_desc * desc, const float * vertices, uint32_t vertex_stride, uint32_t vertex_count, const uint32_t * indices, uint32_t index_count) {
    go_gphys_mesh_create_result r = {0};
    r.status = gphys_mesh_create(desc, vertices, vertex_stride, vertex_count, indices, index_count, (gphys_mesh **)&r.out_mesh);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_create_hull_result {
    gphys_status status;
    char* message;
    void* out_mesh;
} go_gphys_mesh_create_hull_result;
static inline go_gphys_mesh_create_hull_result go_gphys_mesh_create_hull(const gphys_mesh_desc * desc, const float * points, uint32_t point_stride, uint32_t point_count) {
    go_gphys_mesh_create_hull_result r = {0};
    r.status = gphys_mesh_create_hull(desc, points, point_stride, point_count, (gphys_mesh **)&r.out_mesh);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_hull_planes_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_mesh_get_hull_planes_result;
static inline go_gphys_mesh_get_hull_planes_result go_gphys_mesh_get_hull_planes(void* mesh, gphys_plane * out_planes, uint32_t capacity) {
    go_gphys_mesh_get_hull_planes_result r = {0};
    r.status = gphys_mesh_get_hull_planes(mesh, out_planes, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_hull_faces_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_mesh_get_hull_faces_result;
static inline go_gphys_mesh_get_hull_faces_result go_gphys_mesh_get_hull_faces(void* mesh, uint32_t * out_faces, uint32_t capacity) {
    go_gphys_mesh_get_hull_faces_result r = {0};
    r.status = gphys_mesh_get_hull_faces(mesh, out_faces, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_set_vertices_result {
    gphys_status status;
    char* message;
} go_gphys_mesh_set_vertices_result;
static inline go_gphys_mesh_set_vertices_result go_gphys_mesh_set_vertices(void* mesh, const float * vertices, uint32_t vertex_stride, uint32_t vertex_count) {
    go_gphys_mesh_set_vertices_result r = {0};
    r.status = gphys_mesh_set_vertices(mesh, vertices, vertex_stride, vertex_count);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_info_result {
    gphys_status status;
    char* message;
    gphys_mesh_info out_info;
} go_gphys_mesh_get_info_result;
static inline go_gphys_mesh_get_info_result go_gphys_mesh_get_info(void* mesh) {
    go_gphys_mesh_get_info_result r = {0};
    r.status = gphys_mesh_get_info(mesh, &r.out_info);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_report_result {
    gphys_status status;
    char* message;
    gphys_mesh_report out_report;
} go_gphys_mesh_get_report_result;
static inline go_gphys_mesh_get_report_result go_gphys_mesh_get_report(void* mesh) {
    go_gphys_mesh_get_report_result r = {0};
    r.status = gphys_mesh_get_report(mesh, &r.out_report);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_vertices_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_mesh_get_vertices_result;
static inline go_gphys_mesh_get_vertices_result go_gphys_mesh_get_vertices(void* mesh, gphys_vec3 * out_vertices, uint32_t capacity) {
    go_gphys_mesh_get_vertices_result r = {0};
    r.status = gphys_mesh_get_vertices(mesh, out_vertices, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_indices_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_mesh_get_indices_result;
static inline go_gphys_mesh_get_indices_result go_gphys_mesh_get_indices(void* mesh, uint32_t * out_indices, uint32_t capacity) {
    go_gphys_mesh_get_indices_result r = {0};
    r.status = gphys_mesh_get_indices(mesh, out_indices, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_snapshot_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_mesh_get_snapshot_result;
static inline go_gphys_mesh_get_snapshot_result go_gphys_mesh_get_snapshot(void* mesh, uint32_t * out_words, uint32_t capacity) {
    go_gphys_mesh_get_snapshot_result r = {0};
    r.status = gphys_mesh_get_snapshot(mesh, out_words, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_create_from_snapshot_result {
    gphys_status status;
    char* message;
    void* out_mesh;
} go_gphys_mesh_create_from_snapshot_result;
static inline go_gphys_mesh_create_from_snapshot_result go_gphys_mesh_create_from_snapshot(const gphys_mesh_desc * desc, const uint32_t * words, uint32_t word_count) {
    go_gphys_mesh_create_from_snapshot_result r = {0};
    r.status = gphys_mesh_create_from_snapshot(desc, words, word_count, (gphys_mesh **)&r.out_mesh);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_raycast_all_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_mesh_raycast_all_result;
static inline go_gphys_mesh_raycast_all_result go_gphys_mesh_raycast_all(void* mesh, gphys_ray ray, gphys_hit * out_hits, uint32_t capacity) {
    go_gphys_mesh_raycast_all_result r = {0};
    r.status = gphys_mesh_raycast_all(mesh, &ray, out_hits, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_raycast_any_result {
    gphys_status status;
    char* message;
    int32_t out_hit;
} go_gphys_mesh_raycast_any_result;
static inline go_gphys_mesh_raycast_any_result go_gphys_mesh_raycast_any(void* mesh, gphys_ray ray) {
    go_gphys_mesh_raycast_any_result r = {0};
    r.status = gphys_mesh_raycast_any(mesh, &ray, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_raycast_any_batch_result {
    gphys_status status;
    char* message;
} go_gphys_mesh_raycast_any_batch_result;
static inline go_gphys_mesh_raycast_any_batch_result go_gphys_mesh_raycast_any_batch(void* mesh, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, int32_t * out_hits, uint32_t out_stride) {
    go_gphys_mesh_raycast_any_batch_result r = {0};
    r.status = gphys_mesh_raycast_any_batch(mesh, rays, ray_stride, count, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_raycast_distance_batch_result {
    gphys_status status;
    char* message;
} go_gphys_mesh_raycast_distance_batch_result;
static inline go_gphys_mesh_raycast_distance_batch_result go_gphys_mesh_raycast_distance_batch(void* mesh, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, gphys_distance * out_distances, uint32_t out_stride) {
    go_gphys_mesh_raycast_distance_batch_result r = {0};
    r.status = gphys_mesh_raycast_distance_batch(mesh, rays, ray_stride, count, out_distances, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_overlap_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_mesh_overlap_result;
static inline go_gphys_mesh_overlap_result go_gphys_mesh_overlap(void* mesh, gphys_shape_type type, const void * shape, uint32_t * out_triangles, uint32_t capacity) {
    go_gphys_mesh_overlap_result r = {0};
    r.status = gphys_mesh_overlap(mesh, type, shape, out_triangles, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_octree_stats_result {
    gphys_status status;
    char* message;
    gphys_octree_stats out_stats;
} go_gphys_mesh_get_octree_stats_result;
static inline go_gphys_mesh_get_octree_stats_result go_gphys_mesh_get_octree_stats(void* mesh) {
    go_gphys_mesh_get_octree_stats_result r = {0};
    r.status = gphys_mesh_get_octree_stats(mesh, &r.out_stats);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_get_octree_boxes_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_mesh_get_octree_boxes_result;
static inline go_gphys_mesh_get_octree_boxes_result go_gphys_mesh_get_octree_boxes(void* mesh, gphys_octree_box * out_boxes, uint32_t capacity) {
    go_gphys_mesh_get_octree_boxes_result r = {0};
    r.status = gphys_mesh_get_octree_boxes(mesh, out_boxes, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_desc_init_result {
    gphys_status status;
    char* message;
    gphys_scene_desc desc;
} go_gphys_scene_desc_init_result;
static inline go_gphys_scene_desc_init_result go_gphys_scene_desc_init(uint32_t size) {
    go_gphys_scene_desc_init_result r = {0};
    r.status = gphys_scene_desc_init(&r.desc, size);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_create_result {
    gphys_status status;
    char* message;
    void* out_scene;
} go_gphys_scene_create_result;
static inline go_gphys_scene_create_result go_gphys_scene_create(const gphys_scene_desc * desc) {
    go_gphys_scene_create_result r = {0};
    r.status = gphys_scene_create(desc, (gphys_scene **)&r.out_scene);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_worker_count_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_worker_count_result;
static inline go_gphys_scene_set_worker_count_result go_gphys_scene_set_worker_count(void* scene, uint32_t workers) {
    go_gphys_scene_set_worker_count_result r = {0};
    r.status = gphys_scene_set_worker_count(scene, workers);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_worker_count_result {
    gphys_status status;
    char* message;
    uint32_t out_workers;
} go_gphys_scene_get_worker_count_result;
static inline go_gphys_scene_get_worker_count_result go_gphys_scene_get_worker_count(void* scene) {
    go_gphys_scene_get_worker_count_result r = {0};
    r.status = gphys_scene_get_worker_count(scene, &r.out_workers);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_origin_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_origin_result;
static inline go_gphys_scene_set_origin_result go_gphys_scene_set_origin(void* scene, const double * origin) {
    go_gphys_scene_set_origin_result r = {0};
    r.status = gphys_scene_set_origin(scene, origin);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_origin_result {
    gphys_status status;
    char* message;
    double out_origin[3];
} go_gphys_scene_get_origin_result;
static inline go_gphys_scene_get_origin_result go_gphys_scene_get_origin(void* scene) {
    go_gphys_scene_get_origin_result r = {0};
    r.status = gphys_scene_get_origin(scene, r.out_origin);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_model_desc_init_result {
    gphys_status status;
    char* message;
    gphys_model_desc desc;
} go_gphys_model_desc_init_result;
static inline go_gphys_model_desc_init_result go_gphys_model_desc_init(uint32_t size) {
    go_gphys_model_desc_init_result r = {0};
    r.status = gphys_model_desc_init(&r.desc, size);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_add_result {
    gphys_status status;
    char* message;
    gphys_model_id out_model;
} go_gphys_scene_add_result;
static inline go_gphys_scene_add_result go_gphys_scene_add(void* scene, gphys_shape_type type, const void * shape, const gphys_transform * transform, const gphys_model_desc * desc) {
    go_gphys_scene_add_result r = {0};
    r.status = gphys_scene_add(scene, type, shape, transform, desc, &r.out_model);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_add_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_add_batch_result;
static inline go_gphys_scene_add_batch_result go_gphys_scene_add_batch(void* scene, gphys_shape_type type, const void * shapes, uint32_t shape_stride, const gphys_transform * transforms, uint32_t transform_stride, uint32_t count, const gphys_model_desc * desc, gphys_model_id * out_models) {
    go_gphys_scene_add_batch_result r = {0};
    r.status = gphys_scene_add_batch(scene, type, shapes, shape_stride, transforms, transform_stride, count, desc, out_models);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_add_described_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_add_described_batch_result;
static inline go_gphys_scene_add_described_batch_result go_gphys_scene_add_described_batch(void* scene, gphys_shape_type type, const void * shapes, uint32_t shape_stride, const gphys_transform * transforms, uint32_t transform_stride, const gphys_model_desc * descs, uint32_t desc_stride, uint32_t count, gphys_model_id * out_models) {
    go_gphys_scene_add_described_batch_result r = {0};
    r.status = gphys_scene_add_described_batch(scene, type, shapes, shape_stride, transforms, transform_stride, descs, desc_stride, count, out_models);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_remove_result {
    gphys_status status;
    char* message;
} go_gphys_scene_remove_result;
static inline go_gphys_scene_remove_result go_gphys_scene_remove(void* scene, gphys_model_id model) {
    go_gphys_scene_remove_result r = {0};
    r.status = gphys_scene_remove(scene, model);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_remove_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_remove_batch_result;
static inline go_gphys_scene_remove_batch_result go_gphys_scene_remove_batch(void* scene, const gphys_model_id * models, uint32_t count) {
    go_gphys_scene_remove_batch_result r = {0};
    r.status = gphys_scene_remove_batch(scene, models, count);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_remove_subtree_result {
    gphys_status status;
    char* message;
} go_gphys_scene_remove_subtree_result;
static inline go_gphys_scene_remove_subtree_result go_gphys_scene_remove_subtree(void* scene, gphys_model_id model) {
    go_gphys_scene_remove_subtree_result r = {0};
    r.status = gphys_scene_remove_subtree(scene, model);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_clear_result {
    gphys_status status;
    char* message;
} go_gphys_scene_clear_result;
static inline go_gphys_scene_clear_result go_gphys_scene_clear(void* scene) {
    go_gphys_scene_clear_result r = {0};
    r.status = gphys_scene_clear(scene);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_has_result {
    gphys_status status;
    char* message;
} go_gphys_scene_has_result;
static inline go_gphys_scene_has_result go_gphys_scene_has(void* scene, gphys_model_id model) {
    go_gphys_scene_has_result r = {0};
    r.status = gphys_scene_has(scene, model);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_models_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_get_models_result;
static inline go_gphys_scene_get_models_result go_gphys_scene_get_models(void* scene, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_scene_get_models_result r = {0};
    r.status = gphys_scene_get_models(scene, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_roots_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_get_roots_result;
static inline go_gphys_scene_get_roots_result go_gphys_scene_get_roots(void* scene, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_scene_get_roots_result r = {0};
    r.status = gphys_scene_get_roots(scene, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_children_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_get_children_result;
static inline go_gphys_scene_get_children_result go_gphys_scene_get_children(void* scene, gphys_model_id model, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_scene_get_children_result r = {0};
    r.status = gphys_scene_get_children(scene, model, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_info_result {
    gphys_status status;
    char* message;
    gphys_model_info out_info;
} go_gphys_scene_get_info_result;
static inline go_gphys_scene_get_info_result go_gphys_scene_get_info(void* scene, gphys_model_id model) {
    go_gphys_scene_get_info_result r = {0};
    r.status = gphys_scene_get_info(scene, model, &r.out_info);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_shape_result {
    gphys_status status;
    char* message;
} go_gphys_scene_get_shape_result;
static inline go_gphys_scene_get_shape_result go_gphys_scene_get_shape(void* scene, gphys_model_id model, void * out_shape, uint32_t out_size) {
    go_gphys_scene_get_shape_result r = {0};
    r.status = gphys_scene_get_shape(scene, model, out_shape, out_size);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_mesh_result {
    gphys_status status;
    char* message;
    void* out_mesh;
} go_gphys_scene_get_mesh_result;
static inline go_gphys_scene_get_mesh_result go_gphys_scene_get_mesh(void* scene, gphys_model_id model) {
    go_gphys_scene_get_mesh_result r = {0};
    r.status = gphys_scene_get_mesh(scene, model, (gphys_mesh **)&r.out_mesh);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_bounds_result {
    gphys_status status;
    char* message;
    gphys_aabb out_bounds;
} go_gphys_scene_get_bounds_result;
static inline go_gphys_scene_get_bounds_result go_gphys_scene_get_bounds(void* scene, gphys_model_id model) {
    go_gphys_scene_get_bounds_result r = {0};
    r.status = gphys_scene_get_bounds(scene, model, &r.out_bounds);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_scene_bounds_result {
    gphys_status status;
    char* message;
    gphys_aabb out_bounds;
} go_gphys_scene_get_scene_bounds_result;
static inline go_gphys_scene_get_scene_bounds_result go_gphys_scene_get_scene_bounds(void* scene) {
    go_gphys_scene_get_scene_bounds_result r = {0};
    r.status = gphys_scene_get_scene_bounds(scene, &r.out_bounds);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_shape_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_shape_result;
static inline go_gphys_scene_set_shape_result go_gphys_scene_set_shape(void* scene, gphys_model_id model, gphys_shape_type type, const void * shape) {
    go_gphys_scene_set_shape_result r = {0};
    r.status = gphys_scene_set_shape(scene, model, type, shape);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_scale_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_scale_result;
static inline go_gphys_scene_set_scale_result go_gphys_scene_set_scale(void* scene, gphys_model_id model, gphys_vec3 scale) {
    go_gphys_scene_set_scale_result r = {0};
    r.status = gphys_scene_set_scale(scene, model, &scale);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_scale_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_scale;
} go_gphys_scene_get_scale_result;
static inline go_gphys_scene_get_scale_result go_gphys_scene_get_scale(void* scene, gphys_model_id model) {
    go_gphys_scene_get_scale_result r = {0};
    r.status = gphys_scene_get_scale(scene, model, &r.out_scale);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_layers_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_layers_result;
static inline go_gphys_scene_set_layers_result go_gphys_scene_set_layers(void* scene, gphys_model_id model, uint32_t layers) {
    go_gphys_scene_set_layers_result r = {0};
    r.status = gphys_scene_set_layers(scene, model, layers);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_tag_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_tag_result;
static inline go_gphys_scene_set_tag_result go_gphys_scene_set_tag(void* scene, gphys_model_id model, uint32_t tag) {
    go_gphys_scene_set_tag_result r = {0};
    r.status = gphys_scene_set_tag(scene, model, tag);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_parent_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_parent_result;
static inline go_gphys_scene_set_parent_result go_gphys_scene_set_parent(void* scene, gphys_model_id model, gphys_model_id parent, int32_t keep_world) {
    go_gphys_scene_set_parent_result r = {0};
    r.status = gphys_scene_set_parent(scene, model, parent, keep_world);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_transform_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_transform_result;
static inline go_gphys_scene_set_transform_result go_gphys_scene_set_transform(void* scene, gphys_model_id model, gphys_transform transform) {
    go_gphys_scene_set_transform_result r = {0};
    r.status = gphys_scene_set_transform(scene, model, &transform);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_set_transforms_result {
    gphys_status status;
    char* message;
} go_gphys_scene_set_transforms_result;
static inline go_gphys_scene_set_transforms_result go_gphys_scene_set_transforms(void* scene, const gphys_model_id * models, const gphys_transform * transforms, uint32_t transform_stride, uint32_t count) {
    go_gphys_scene_set_transforms_result r = {0};
    r.status = gphys_scene_set_transforms(scene, models, transforms, transform_stride, count);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_transforms_result {
    gphys_status status;
    char* message;
} go_gphys_scene_get_transforms_result;
static inline go_gphys_scene_get_transforms_result go_gphys_scene_get_transforms(void* scene, const gphys_model_id * models, uint32_t count, gphys_transform * out_transforms, uint32_t out_stride) {
    go_gphys_scene_get_transforms_result r = {0};
    r.status = gphys_scene_get_transforms(scene, models, count, out_transforms, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_world_transforms_result {
    gphys_status status;
    char* message;
} go_gphys_scene_get_world_transforms_result;
static inline go_gphys_scene_get_world_transforms_result go_gphys_scene_get_world_transforms(void* scene, const gphys_model_id * models, uint32_t count, gphys_transform * out_transforms, uint32_t out_stride) {
    go_gphys_scene_get_world_transforms_result r = {0};
    r.status = gphys_scene_get_world_transforms(scene, models, count, out_transforms, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_scene_raycast_result;
static inline go_gphys_scene_raycast_result go_gphys_scene_raycast(void* scene, gphys_ray ray, uint32_t layers) {
    go_gphys_scene_raycast_result r = {0};
    r.status = gphys_scene_raycast(scene, &ray, layers, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_raycast_batch_result;
static inline go_gphys_scene_raycast_batch_result go_gphys_scene_raycast_batch(void* scene, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, uint32_t layers, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_scene_raycast_batch_result r = {0};
    r.status = gphys_scene_raycast_batch(scene, rays, ray_stride, count, layers, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_distance_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_raycast_distance_batch_result;
static inline go_gphys_scene_raycast_distance_batch_result go_gphys_scene_raycast_distance_batch(void* scene, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, uint32_t layers, gphys_distance * out_distances, uint32_t out_stride) {
    go_gphys_scene_raycast_distance_batch_result r = {0};
    r.status = gphys_scene_raycast_distance_batch(scene, rays, ray_stride, count, layers, out_distances, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_any_result {
    gphys_status status;
    char* message;
    int32_t out_hit;
} go_gphys_scene_raycast_any_result;
static inline go_gphys_scene_raycast_any_result go_gphys_scene_raycast_any(void* scene, gphys_ray ray, uint32_t layers) {
    go_gphys_scene_raycast_any_result r = {0};
    r.status = gphys_scene_raycast_any(scene, &ray, layers, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_any_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_raycast_any_batch_result;
static inline go_gphys_scene_raycast_any_batch_result go_gphys_scene_raycast_any_batch(void* scene, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, uint32_t layers, int32_t * out_hits, uint32_t out_stride) {
    go_gphys_scene_raycast_any_batch_result r = {0};
    r.status = gphys_scene_raycast_any_batch(scene, rays, ray_stride, count, layers, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_all_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_raycast_all_result;
static inline go_gphys_scene_raycast_all_result go_gphys_scene_raycast_all(void* scene, gphys_ray ray, uint32_t layers, gphys_hit * out_hits, uint32_t capacity) {
    go_gphys_scene_raycast_all_result r = {0};
    r.status = gphys_scene_raycast_all(scene, &ray, layers, out_hits, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_all_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_raycast_all_batch_result;
static inline go_gphys_scene_raycast_all_batch_result go_gphys_scene_raycast_all_batch(void* scene, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, uint32_t layers, gphys_hit * out_hits, uint32_t capacity, uint32_t * out_offsets) {
    go_gphys_scene_raycast_all_batch_result r = {0};
    r.status = gphys_scene_raycast_all_batch(scene, rays, ray_stride, count, layers, out_hits, capacity, out_offsets);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_segment_test_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_scene_segment_test_result;
static inline go_gphys_scene_segment_test_result go_gphys_scene_segment_test(void* scene, gphys_segment segment, uint32_t layers) {
    go_gphys_scene_segment_test_result r = {0};
    r.status = gphys_scene_segment_test(scene, &segment, layers, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_segment_test_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_segment_test_batch_result;
static inline go_gphys_scene_segment_test_batch_result go_gphys_scene_segment_test_batch(void* scene, const gphys_segment * segments, uint32_t segment_stride, uint32_t count, uint32_t layers, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_scene_segment_test_batch_result r = {0};
    r.status = gphys_scene_segment_test_batch(scene, segments, segment_stride, count, layers, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_overlap_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_overlap_result;
static inline go_gphys_scene_overlap_result go_gphys_scene_overlap(void* scene, gphys_shape_type type, const void * shape, uint32_t layers, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_scene_overlap_result r = {0};
    r.status = gphys_scene_overlap(scene, type, shape, layers, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_overlap_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_overlap_batch_result;
static inline go_gphys_scene_overlap_batch_result go_gphys_scene_overlap_batch(void* scene, gphys_shape_type type, const void * shapes, uint32_t shape_stride, uint32_t count, uint32_t layers, gphys_model_id * out_models, uint32_t capacity, uint32_t * out_offsets) {
    go_gphys_scene_overlap_batch_result r = {0};
    r.status = gphys_scene_overlap_batch(scene, type, shapes, shape_stride, count, layers, out_models, capacity, out_offsets);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_cull_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_cull_result;
static inline go_gphys_scene_cull_result go_gphys_scene_cull(void* scene, gphys_frustum frustum, uint32_t layers, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_scene_cull_result r = {0};
    r.status = gphys_scene_cull(scene, &frustum, layers, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_cull_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_cull_batch_result;
static inline go_gphys_scene_cull_batch_result go_gphys_scene_cull_batch(void* scene, const gphys_frustum * frusta, uint32_t frustum_stride, uint32_t count, uint32_t layers, gphys_model_id * out_models, uint32_t capacity, uint32_t * out_offsets) {
    go_gphys_scene_cull_batch_result r = {0};
    r.status = gphys_scene_cull_batch(scene, frusta, frustum_stride, count, layers, out_models, capacity, out_offsets);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_nearest_result {
    gphys_status status;
    char* message;
    gphys_nearest out_nearest;
} go_gphys_scene_nearest_result;
static inline go_gphys_scene_nearest_result go_gphys_scene_nearest(void* scene, gphys_vec3 point, float max_distance, uint32_t layers) {
    go_gphys_scene_nearest_result r = {0};
    r.status = gphys_scene_nearest(scene, &point, max_distance, layers, &r.out_nearest);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_nearest_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_nearest_batch_result;
static inline go_gphys_scene_nearest_batch_result go_gphys_scene_nearest_batch(void* scene, const gphys_vec3 * points, uint32_t point_stride, uint32_t count, float max_distance, uint32_t layers, gphys_nearest * out_nearest, uint32_t out_stride) {
    go_gphys_scene_nearest_batch_result r = {0};
    r.status = gphys_scene_nearest_batch(scene, points, point_stride, count, max_distance, layers, out_nearest, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_sweep_sphere_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_scene_sweep_sphere_result;
static inline go_gphys_scene_sweep_sphere_result go_gphys_scene_sweep_sphere(void* scene, gphys_sphere sphere, gphys_vec3 displacement, uint32_t layers) {
    go_gphys_scene_sweep_sphere_result r = {0};
    r.status = gphys_scene_sweep_sphere(scene, &sphere, &displacement, layers, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_sweep_sphere_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_sweep_sphere_batch_result;
static inline go_gphys_scene_sweep_sphere_batch_result go_gphys_scene_sweep_sphere_batch(void* scene, const gphys_sphere * spheres, uint32_t sphere_stride, const gphys_vec3 * displacements, uint32_t displacement_stride, uint32_t count, uint32_t layers, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_scene_sweep_sphere_batch_result r = {0};
    r.status = gphys_scene_sweep_sphere_batch(scene, spheres, sphere_stride, displacements, displacement_stride, count, layers, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_sweep_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_scene_sweep_result;
static inline go_gphys_scene_sweep_result go_gphys_scene_sweep(void* scene, gphys_shape_type type, const void * shape, gphys_vec3 displacement, uint32_t layers) {
    go_gphys_scene_sweep_result r = {0};
    r.status = gphys_scene_sweep(scene, type, shape, &displacement, layers, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_sweep_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_sweep_batch_result;
static inline go_gphys_scene_sweep_batch_result go_gphys_scene_sweep_batch(void* scene, gphys_shape_type type, const void * shapes, uint32_t shape_stride, const gphys_vec3 * displacements, uint32_t displacement_stride, uint32_t count, uint32_t layers, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_scene_sweep_batch_result r = {0};
    r.status = gphys_scene_sweep_batch(scene, type, shapes, shape_stride, displacements, displacement_stride, count, layers, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_penetration_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_penetration_result;
static inline go_gphys_scene_penetration_result go_gphys_scene_penetration(void* scene, gphys_shape_type type, const void * shape, uint32_t layers, gphys_penetration * out_penetrations, uint32_t capacity) {
    go_gphys_scene_penetration_result r = {0};
    r.status = gphys_scene_penetration(scene, type, shape, layers, out_penetrations, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_penetration_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_penetration_batch_result;
static inline go_gphys_scene_penetration_batch_result go_gphys_scene_penetration_batch(void* scene, gphys_shape_type type, const void * shapes, uint32_t shape_stride, uint32_t count, uint32_t layers, gphys_penetration * out_penetrations, uint32_t capacity, uint32_t * out_offsets) {
    go_gphys_scene_penetration_batch_result r = {0};
    r.status = gphys_scene_penetration_batch(scene, type, shapes, shape_stride, count, layers, out_penetrations, capacity, out_offsets);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_query_filter_desc_init_result {
    gphys_status status;
    char* message;
    gphys_query_filter_desc desc;
} go_gphys_query_filter_desc_init_result;
static inline go_gphys_query_filter_desc_init_result go_gphys_query_filter_desc_init(uint32_t size) {
    go_gphys_query_filter_desc_init_result r = {0};
    r.status = gphys_query_filter_desc_init(&r.desc, size);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_filtered_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_scene_raycast_filtered_result;
static inline go_gphys_scene_raycast_filtered_result go_gphys_scene_raycast_filtered(void* scene, gphys_ray ray, const gphys_query_filter_desc * filter) {
    go_gphys_scene_raycast_filtered_result r = {0};
    r.status = gphys_scene_raycast_filtered(scene, &ray, filter, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_raycast_filtered_batch_result;
static inline go_gphys_scene_raycast_filtered_batch_result go_gphys_scene_raycast_filtered_batch(void* scene, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_scene_raycast_filtered_batch_result r = {0};
    r.status = gphys_scene_raycast_filtered_batch(scene, rays, ray_stride, count, filters, filter_stride, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_distance_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_raycast_distance_filtered_batch_result;
static inline go_gphys_scene_raycast_distance_filtered_batch_result go_gphys_scene_raycast_distance_filtered_batch(void* scene, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_distance * out_distances, uint32_t out_stride) {
    go_gphys_scene_raycast_distance_filtered_batch_result r = {0};
    r.status = gphys_scene_raycast_distance_filtered_batch(scene, rays, ray_stride, count, filters, filter_stride, out_distances, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_any_filtered_result {
    gphys_status status;
    char* message;
    int32_t out_hit;
} go_gphys_scene_raycast_any_filtered_result;
static inline go_gphys_scene_raycast_any_filtered_result go_gphys_scene_raycast_any_filtered(void* scene, gphys_ray ray, const gphys_query_filter_desc * filter) {
    go_gphys_scene_raycast_any_filtered_result r = {0};
    r.status = gphys_scene_raycast_any_filtered(scene, &ray, filter, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_any_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_raycast_any_filtered_batch_result;
static inline go_gphys_scene_raycast_any_filtered_batch_result go_gphys_scene_raycast_any_filtered_batch(void* scene, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, int32_t * out_hits, uint32_t out_stride) {
    go_gphys_scene_raycast_any_filtered_batch_result r = {0};
    r.status = gphys_scene_raycast_any_filtered_batch(scene, rays, ray_stride, count, filters, filter_stride, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_all_filtered_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_raycast_all_filtered_result;
static inline go_gphys_scene_raycast_all_filtered_result go_gphys_scene_raycast_all_filtered(void* scene, gphys_ray ray, const gphys_query_filter_desc * filter, gphys_hit * out_hits, uint32_t capacity) {
    go_gphys_scene_raycast_all_filtered_result r = {0};
    r.status = gphys_scene_raycast_all_filtered(scene, &ray, filter, out_hits, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_raycast_all_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_raycast_all_filtered_batch_result;
static inline go_gphys_scene_raycast_all_filtered_batch_result go_gphys_scene_raycast_all_filtered_batch(void* scene, const gphys_ray * rays, uint32_t ray_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_hit * out_hits, uint32_t capacity, uint32_t * out_offsets) {
    go_gphys_scene_raycast_all_filtered_batch_result r = {0};
    r.status = gphys_scene_raycast_all_filtered_batch(scene, rays, ray_stride, count, filters, filter_stride, out_hits, capacity, out_offsets);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_segment_test_filtered_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_scene_segment_test_filtered_result;
static inline go_gphys_scene_segment_test_filtered_result go_gphys_scene_segment_test_filtered(void* scene, gphys_segment segment, const gphys_query_filter_desc * filter) {
    go_gphys_scene_segment_test_filtered_result r = {0};
    r.status = gphys_scene_segment_test_filtered(scene, &segment, filter, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_segment_test_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_segment_test_filtered_batch_result;
static inline go_gphys_scene_segment_test_filtered_batch_result go_gphys_scene_segment_test_filtered_batch(void* scene, const gphys_segment * segments, uint32_t segment_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_scene_segment_test_filtered_batch_result r = {0};
    r.status = gphys_scene_segment_test_filtered_batch(scene, segments, segment_stride, count, filters, filter_stride, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_overlap_filtered_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_overlap_filtered_result;
static inline go_gphys_scene_overlap_filtered_result go_gphys_scene_overlap_filtered(void* scene, gphys_shape_type type, const void * shape, const gphys_query_filter_desc * filter, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_scene_overlap_filtered_result r = {0};
    r.status = gphys_scene_overlap_filtered(scene, type, shape, filter, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_overlap_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_overlap_filtered_batch_result;
static inline go_gphys_scene_overlap_filtered_batch_result go_gphys_scene_overlap_filtered_batch(void* scene, gphys_shape_type type, const void * shapes, uint32_t shape_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_model_id * out_models, uint32_t capacity, uint32_t * out_offsets) {
    go_gphys_scene_overlap_filtered_batch_result r = {0};
    r.status = gphys_scene_overlap_filtered_batch(scene, type, shapes, shape_stride, count, filters, filter_stride, out_models, capacity, out_offsets);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_cull_filtered_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_cull_filtered_result;
static inline go_gphys_scene_cull_filtered_result go_gphys_scene_cull_filtered(void* scene, gphys_frustum frustum, const gphys_query_filter_desc * filter, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_scene_cull_filtered_result r = {0};
    r.status = gphys_scene_cull_filtered(scene, &frustum, filter, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_cull_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_cull_filtered_batch_result;
static inline go_gphys_scene_cull_filtered_batch_result go_gphys_scene_cull_filtered_batch(void* scene, const gphys_frustum * frusta, uint32_t frustum_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_model_id * out_models, uint32_t capacity, uint32_t * out_offsets) {
    go_gphys_scene_cull_filtered_batch_result r = {0};
    r.status = gphys_scene_cull_filtered_batch(scene, frusta, frustum_stride, count, filters, filter_stride, out_models, capacity, out_offsets);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_nearest_filtered_result {
    gphys_status status;
    char* message;
    gphys_nearest out_nearest;
} go_gphys_scene_nearest_filtered_result;
static inline go_gphys_scene_nearest_filtered_result go_gphys_scene_nearest_filtered(void* scene, gphys_vec3 point, float max_distance, const gphys_query_filter_desc * filter) {
    go_gphys_scene_nearest_filtered_result r = {0};
    r.status = gphys_scene_nearest_filtered(scene, &point, max_distance, filter, &r.out_nearest);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_nearest_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_nearest_filtered_batch_result;
static inline go_gphys_scene_nearest_filtered_batch_result go_gphys_scene_nearest_filtered_batch(void* scene, const gphys_vec3 * points, uint32_t point_stride, uint32_t count, float max_distance, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_nearest * out_nearest, uint32_t out_stride) {
    go_gphys_scene_nearest_filtered_batch_result r = {0};
    r.status = gphys_scene_nearest_filtered_batch(scene, points, point_stride, count, max_distance, filters, filter_stride, out_nearest, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_sweep_sphere_filtered_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_scene_sweep_sphere_filtered_result;
static inline go_gphys_scene_sweep_sphere_filtered_result go_gphys_scene_sweep_sphere_filtered(void* scene, gphys_sphere sphere, gphys_vec3 displacement, const gphys_query_filter_desc * filter) {
    go_gphys_scene_sweep_sphere_filtered_result r = {0};
    r.status = gphys_scene_sweep_sphere_filtered(scene, &sphere, &displacement, filter, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_sweep_sphere_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_sweep_sphere_filtered_batch_result;
static inline go_gphys_scene_sweep_sphere_filtered_batch_result go_gphys_scene_sweep_sphere_filtered_batch(void* scene, const gphys_sphere * spheres, uint32_t sphere_stride, const gphys_vec3 * displacements, uint32_t displacement_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_scene_sweep_sphere_filtered_batch_result r = {0};
    r.status = gphys_scene_sweep_sphere_filtered_batch(scene, spheres, sphere_stride, displacements, displacement_stride, count, filters, filter_stride, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_sweep_filtered_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_scene_sweep_filtered_result;
static inline go_gphys_scene_sweep_filtered_result go_gphys_scene_sweep_filtered(void* scene, gphys_shape_type type, const void * shape, gphys_vec3 displacement, const gphys_query_filter_desc * filter) {
    go_gphys_scene_sweep_filtered_result r = {0};
    r.status = gphys_scene_sweep_filtered(scene, type, shape, &displacement, filter, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_sweep_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_sweep_filtered_batch_result;
static inline go_gphys_scene_sweep_filtered_batch_result go_gphys_scene_sweep_filtered_batch(void* scene, gphys_shape_type type, const void * shapes, uint32_t shape_stride, const gphys_vec3 * displacements, uint32_t displacement_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_scene_sweep_filtered_batch_result r = {0};
    r.status = gphys_scene_sweep_filtered_batch(scene, type, shapes, shape_stride, displacements, displacement_stride, count, filters, filter_stride, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_penetration_filtered_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_penetration_filtered_result;
static inline go_gphys_scene_penetration_filtered_result go_gphys_scene_penetration_filtered(void* scene, gphys_shape_type type, const void * shape, const gphys_query_filter_desc * filter, gphys_penetration * out_penetrations, uint32_t capacity) {
    go_gphys_scene_penetration_filtered_result r = {0};
    r.status = gphys_scene_penetration_filtered(scene, type, shape, filter, out_penetrations, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_penetration_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_scene_penetration_filtered_batch_result;
static inline go_gphys_scene_penetration_filtered_batch_result go_gphys_scene_penetration_filtered_batch(void* scene, gphys_shape_type type, const void * shapes, uint32_t shape_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_penetration * out_penetrations, uint32_t capacity, uint32_t * out_offsets) {
    go_gphys_scene_penetration_filtered_batch_result r = {0};
    r.status = gphys_scene_penetration_filtered_batch(scene, type, shapes, shape_stride, count, filters, filter_stride, out_penetrations, capacity, out_offsets);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_rebuild_octree_result {
    gphys_status status;
    char* message;
} go_gphys_scene_rebuild_octree_result;
static inline go_gphys_scene_rebuild_octree_result go_gphys_scene_rebuild_octree(void* scene) {
    go_gphys_scene_rebuild_octree_result r = {0};
    r.status = gphys_scene_rebuild_octree(scene);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_maintain_octree_result {
    gphys_status status;
    char* message;
    int32_t out_done;
} go_gphys_scene_maintain_octree_result;
static inline go_gphys_scene_maintain_octree_result go_gphys_scene_maintain_octree(void* scene, uint32_t budget) {
    go_gphys_scene_maintain_octree_result r = {0};
    r.status = gphys_scene_maintain_octree(scene, budget, &r.out_done);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_octree_stats_result {
    gphys_status status;
    char* message;
    gphys_octree_stats out_stats;
} go_gphys_scene_get_octree_stats_result;
static inline go_gphys_scene_get_octree_stats_result go_gphys_scene_get_octree_stats(void* scene) {
    go_gphys_scene_get_octree_stats_result r = {0};
    r.status = gphys_scene_get_octree_stats(scene, &r.out_stats);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_octree_boxes_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_get_octree_boxes_result;
static inline go_gphys_scene_get_octree_boxes_result go_gphys_scene_get_octree_boxes(void* scene, gphys_octree_box * out_boxes, uint32_t capacity) {
    go_gphys_scene_get_octree_boxes_result r = {0};
    r.status = gphys_scene_get_octree_boxes(scene, out_boxes, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_validate_result {
    gphys_status status;
    char* message;
} go_gphys_scene_validate_result;
static inline go_gphys_scene_validate_result go_gphys_scene_validate(void* scene) {
    go_gphys_scene_validate_result r = {0};
    r.status = gphys_scene_validate(scene);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_snapshot_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_scene_get_snapshot_result;
static inline go_gphys_scene_get_snapshot_result go_gphys_scene_get_snapshot(void* scene, int32_t embed_meshes, uint32_t * out_words, uint32_t capacity) {
    go_gphys_scene_get_snapshot_result r = {0};
    r.status = gphys_scene_get_snapshot(scene, embed_meshes, out_words, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_restore_result {
    gphys_status status;
    char* message;
} go_gphys_scene_restore_result;
static inline go_gphys_scene_restore_result go_gphys_scene_restore(void* scene, void* library, const uint32_t * words, uint32_t count) {
    go_gphys_scene_restore_result r = {0};
    r.status = gphys_scene_restore(scene, library, words, count);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_scene_get_hash_result {
    gphys_status status;
    char* message;
    uint32_t out_hash[2];
} go_gphys_scene_get_hash_result;
static inline go_gphys_scene_get_hash_result go_gphys_scene_get_hash(void* scene) {
    go_gphys_scene_get_hash_result r = {0};
    r.status = gphys_scene_get_hash(scene, r.out_hash);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_desc_init_result {
    gphys_status status;
    char* message;
    gphys_camera_desc desc;
} go_gphys_camera_desc_init_result;
static inline go_gphys_camera_desc_init_result go_gphys_camera_desc_init(uint32_t size) {
    go_gphys_camera_desc_init_result r = {0};
    r.status = gphys_camera_desc_init(&r.desc, size);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_create_result {
    gphys_status status;
    char* message;
    void* out_camera;
} go_gphys_camera_create_result;
static inline go_gphys_camera_create_result go_gphys_camera_create(const gphys_camera_desc * desc) {
    go_gphys_camera_create_result r = {0};
    r.status = gphys_camera_create(desc, (gphys_camera **)&r.out_camera);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_origin_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_origin_result;
static inline go_gphys_camera_set_origin_result go_gphys_camera_set_origin(void* camera, const double * origin) {
    go_gphys_camera_set_origin_result r = {0};
    r.status = gphys_camera_set_origin(camera, origin);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_origin_result {
    gphys_status status;
    char* message;
    double out_origin[3];
} go_gphys_camera_get_origin_result;
static inline go_gphys_camera_get_origin_result go_gphys_camera_get_origin(void* camera) {
    go_gphys_camera_get_origin_result r = {0};
    r.status = gphys_camera_get_origin(camera, r.out_origin);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_perspective_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_perspective_result;
static inline go_gphys_camera_set_perspective_result go_gphys_camera_set_perspective(void* camera, float fov_y, float near_distance, float far_distance) {
    go_gphys_camera_set_perspective_result r = {0};
    r.status = gphys_camera_set_perspective(camera, fov_y, near_distance, far_distance);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_orthographic_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_orthographic_result;
static inline go_gphys_camera_set_orthographic_result go_gphys_camera_set_orthographic(void* camera, float height, float near_distance, float far_distance) {
    go_gphys_camera_set_orthographic_result r = {0};
    r.status = gphys_camera_set_orthographic(camera, height, near_distance, far_distance);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_projection_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_projection_result;
static inline go_gphys_camera_set_projection_result go_gphys_camera_set_projection(void* camera, gphys_mat4 projection) {
    go_gphys_camera_set_projection_result r = {0};
    r.status = gphys_camera_set_projection(camera, &projection);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_perspective_aspect_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_perspective_aspect_result;
static inline go_gphys_camera_set_perspective_aspect_result go_gphys_camera_set_perspective_aspect(void* camera, float fov_y, float aspect, float near_distance, float far_distance) {
    go_gphys_camera_set_perspective_aspect_result r = {0};
    r.status = gphys_camera_set_perspective_aspect(camera, fov_y, aspect, near_distance, far_distance);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_orthographic_size_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_orthographic_size_result;
static inline go_gphys_camera_set_orthographic_size_result go_gphys_camera_set_orthographic_size(void* camera, float width, float height, float near_distance, float far_distance) {
    go_gphys_camera_set_orthographic_size_result r = {0};
    r.status = gphys_camera_set_orthographic_size(camera, width, height, near_distance, far_distance);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_viewport_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_viewport_result;
static inline go_gphys_camera_set_viewport_result go_gphys_camera_set_viewport(void* camera, float width, float height) {
    go_gphys_camera_set_viewport_result r = {0};
    r.status = gphys_camera_set_viewport(camera, width, height);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_viewport_origin_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_viewport_origin_result;
static inline go_gphys_camera_set_viewport_origin_result go_gphys_camera_set_viewport_origin(void* camera, float x, float y) {
    go_gphys_camera_set_viewport_origin_result r = {0};
    r.status = gphys_camera_set_viewport_origin(camera, x, y);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_pick_start_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_pick_start_result;
static inline go_gphys_camera_set_pick_start_result go_gphys_camera_set_pick_start(void* camera, gphys_pick_start start) {
    go_gphys_camera_set_pick_start_result r = {0};
    r.status = gphys_camera_set_pick_start(camera, start);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_projection_result {
    gphys_status status;
    char* message;
    gphys_projection out_kind;
    float out_size;
    float out_near;
    float out_far;
} go_gphys_camera_get_projection_result;
static inline go_gphys_camera_get_projection_result go_gphys_camera_get_projection(void* camera) {
    go_gphys_camera_get_projection_result r = {0};
    r.status = gphys_camera_get_projection(camera, &r.out_kind, &r.out_size, &r.out_near, &r.out_far);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_viewport_result {
    gphys_status status;
    char* message;
    float out_width;
    float out_height;
} go_gphys_camera_get_viewport_result;
static inline go_gphys_camera_get_viewport_result go_gphys_camera_get_viewport(void* camera) {
    go_gphys_camera_get_viewport_result r = {0};
    r.status = gphys_camera_get_viewport(camera, &r.out_width, &r.out_height);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_viewport_origin_result {
    gphys_status status;
    char* message;
    float out_x;
    float out_y;
} go_gphys_camera_get_viewport_origin_result;
static inline go_gphys_camera_get_viewport_origin_result go_gphys_camera_get_viewport_origin(void* camera) {
    go_gphys_camera_get_viewport_origin_result r = {0};
    r.status = gphys_camera_get_viewport_origin(camera, &r.out_x, &r.out_y);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_aspect_result {
    gphys_status status;
    char* message;
    float out_aspect;
    int32_t out_is_fixed;
} go_gphys_camera_get_aspect_result;
static inline go_gphys_camera_get_aspect_result go_gphys_camera_get_aspect(void* camera) {
    go_gphys_camera_get_aspect_result r = {0};
    r.status = gphys_camera_get_aspect(camera, &r.out_aspect, &r.out_is_fixed);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_image_size_result {
    gphys_status status;
    char* message;
    float out_width;
    float out_height;
} go_gphys_camera_get_image_size_result;
static inline go_gphys_camera_get_image_size_result go_gphys_camera_get_image_size(void* camera) {
    go_gphys_camera_get_image_size_result r = {0};
    r.status = gphys_camera_get_image_size(camera, &r.out_width, &r.out_height);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_pick_start_result {
    gphys_status status;
    char* message;
    gphys_pick_start out_start;
} go_gphys_camera_get_pick_start_result;
static inline go_gphys_camera_get_pick_start_result go_gphys_camera_get_pick_start(void* camera) {
    go_gphys_camera_get_pick_start_result r = {0};
    r.status = gphys_camera_get_pick_start(camera, &r.out_start);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_conventions_result {
    gphys_status status;
    char* message;
    gphys_handedness out_handedness;
    gphys_depth_range out_depth_range;
    int32_t out_reverse_z;
} go_gphys_camera_get_conventions_result;
static inline go_gphys_camera_get_conventions_result go_gphys_camera_get_conventions(void* camera) {
    go_gphys_camera_get_conventions_result r = {0};
    r.status = gphys_camera_get_conventions(camera, &r.out_handedness, &r.out_depth_range, &r.out_reverse_z);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_transform_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_transform_result;
static inline go_gphys_camera_set_transform_result go_gphys_camera_set_transform(void* camera, gphys_vec3 position, gphys_quat rotation) {
    go_gphys_camera_set_transform_result r = {0};
    r.status = gphys_camera_set_transform(camera, &position, &rotation);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_world_matrix_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_world_matrix_result;
static inline go_gphys_camera_set_world_matrix_result go_gphys_camera_set_world_matrix(void* camera, gphys_mat4 world) {
    go_gphys_camera_set_world_matrix_result r = {0};
    r.status = gphys_camera_set_world_matrix(camera, &world);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_view_matrix_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_view_matrix_result;
static inline go_gphys_camera_set_view_matrix_result go_gphys_camera_set_view_matrix(void* camera, gphys_mat4 view) {
    go_gphys_camera_set_view_matrix_result r = {0};
    r.status = gphys_camera_set_view_matrix(camera, &view);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_look_at_result {
    gphys_status status;
    char* message;
} go_gphys_camera_look_at_result;
static inline go_gphys_camera_look_at_result go_gphys_camera_look_at(void* camera, gphys_vec3 eye, gphys_vec3 target, gphys_vec3 up) {
    go_gphys_camera_look_at_result r = {0};
    r.status = gphys_camera_look_at(camera, &eye, &target, &up);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_transform_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_position;
    gphys_quat out_rotation;
} go_gphys_camera_get_transform_result;
static inline go_gphys_camera_get_transform_result go_gphys_camera_get_transform(void* camera) {
    go_gphys_camera_get_transform_result r = {0};
    r.status = gphys_camera_get_transform(camera, &r.out_position, &r.out_rotation);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_world_matrix_result {
    gphys_status status;
    char* message;
    gphys_mat4 out_world;
} go_gphys_camera_get_world_matrix_result;
static inline go_gphys_camera_get_world_matrix_result go_gphys_camera_get_world_matrix(void* camera) {
    go_gphys_camera_get_world_matrix_result r = {0};
    r.status = gphys_camera_get_world_matrix(camera, &r.out_world);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_view_matrix_result {
    gphys_status status;
    char* message;
    gphys_mat4 out_view;
} go_gphys_camera_get_view_matrix_result;
static inline go_gphys_camera_get_view_matrix_result go_gphys_camera_get_view_matrix(void* camera) {
    go_gphys_camera_get_view_matrix_result r = {0};
    r.status = gphys_camera_get_view_matrix(camera, &r.out_view);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_projection_matrix_result {
    gphys_status status;
    char* message;
    gphys_mat4 out_projection;
} go_gphys_camera_get_projection_matrix_result;
static inline go_gphys_camera_get_projection_matrix_result go_gphys_camera_get_projection_matrix(void* camera) {
    go_gphys_camera_get_projection_matrix_result r = {0};
    r.status = gphys_camera_get_projection_matrix(camera, &r.out_projection);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_view_projection_matrix_result {
    gphys_status status;
    char* message;
    gphys_mat4 out_view_projection;
} go_gphys_camera_get_view_projection_matrix_result;
static inline go_gphys_camera_get_view_projection_matrix_result go_gphys_camera_get_view_projection_matrix(void* camera) {
    go_gphys_camera_get_view_projection_matrix_result r = {0};
    r.status = gphys_camera_get_view_projection_matrix(camera, &r.out_view_projection);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_orbit_init_result {
    gphys_status status;
    char* message;
    gphys_orbit orbit;
} go_gphys_orbit_init_result;
static inline go_gphys_orbit_init_result go_gphys_orbit_init() {
    go_gphys_orbit_init_result r = {0};
    r.status = gphys_orbit_init(&r.orbit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_orbit_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_orbit_result;
static inline go_gphys_camera_set_orbit_result go_gphys_camera_set_orbit(void* camera, gphys_orbit orbit) {
    go_gphys_camera_set_orbit_result r = {0};
    r.status = gphys_camera_set_orbit(camera, &orbit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_orbit_result {
    gphys_status status;
    char* message;
    gphys_orbit out_orbit;
} go_gphys_camera_get_orbit_result;
static inline go_gphys_camera_get_orbit_result go_gphys_camera_get_orbit(void* camera) {
    go_gphys_camera_get_orbit_result r = {0};
    r.status = gphys_camera_get_orbit(camera, &r.out_orbit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_set_orbit_speeds_result {
    gphys_status status;
    char* message;
} go_gphys_camera_set_orbit_speeds_result;
static inline go_gphys_camera_set_orbit_speeds_result go_gphys_camera_set_orbit_speeds(void* camera, gphys_orbit_speeds speeds) {
    go_gphys_camera_set_orbit_speeds_result r = {0};
    r.status = gphys_camera_set_orbit_speeds(camera, &speeds);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_orbit_speeds_result {
    gphys_status status;
    char* message;
    gphys_orbit_speeds out_speeds;
} go_gphys_camera_get_orbit_speeds_result;
static inline go_gphys_camera_get_orbit_speeds_result go_gphys_camera_get_orbit_speeds(void* camera) {
    go_gphys_camera_get_orbit_speeds_result r = {0};
    r.status = gphys_camera_get_orbit_speeds(camera, &r.out_speeds);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_orbit_rotate_result {
    gphys_status status;
    char* message;
} go_gphys_camera_orbit_rotate_result;
static inline go_gphys_camera_orbit_rotate_result go_gphys_camera_orbit_rotate(void* camera, float units_x, float units_y) {
    go_gphys_camera_orbit_rotate_result r = {0};
    r.status = gphys_camera_orbit_rotate(camera, units_x, units_y);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_orbit_zoom_result {
    gphys_status status;
    char* message;
} go_gphys_camera_orbit_zoom_result;
static inline go_gphys_camera_orbit_zoom_result go_gphys_camera_orbit_zoom(void* camera, float units) {
    go_gphys_camera_orbit_zoom_result r = {0};
    r.status = gphys_camera_orbit_zoom(camera, units);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_orbit_pan_result {
    gphys_status status;
    char* message;
} go_gphys_camera_orbit_pan_result;
static inline go_gphys_camera_orbit_pan_result go_gphys_camera_orbit_pan(void* camera, float units_right, float units_up) {
    go_gphys_camera_orbit_pan_result r = {0};
    r.status = gphys_camera_orbit_pan(camera, units_right, units_up);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_orbit_update_result {
    gphys_status status;
    char* message;
} go_gphys_camera_orbit_update_result;
static inline go_gphys_camera_orbit_update_result go_gphys_camera_orbit_update(void* camera) {
    go_gphys_camera_orbit_update_result r = {0};
    r.status = gphys_camera_orbit_update(camera);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_frustum_result {
    gphys_status status;
    char* message;
    gphys_frustum out_frustum;
} go_gphys_camera_get_frustum_result;
static inline go_gphys_camera_get_frustum_result go_gphys_camera_get_frustum(void* camera) {
    go_gphys_camera_get_frustum_result r = {0};
    r.status = gphys_camera_get_frustum(camera, &r.out_frustum);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_corners_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_corners[8];
} go_gphys_camera_get_corners_result;
static inline go_gphys_camera_get_corners_result go_gphys_camera_get_corners(void* camera) {
    go_gphys_camera_get_corners_result r = {0};
    r.status = gphys_camera_get_corners(camera, r.out_corners);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_rectangle_frustum_result {
    gphys_status status;
    char* message;
    gphys_frustum out_frustum;
} go_gphys_camera_get_rectangle_frustum_result;
static inline go_gphys_camera_get_rectangle_frustum_result go_gphys_camera_get_rectangle_frustum(void* camera, float x0, float y0, float x1, float y1) {
    go_gphys_camera_get_rectangle_frustum_result r = {0};
    r.status = gphys_camera_get_rectangle_frustum(camera, x0, y0, x1, y1, &r.out_frustum);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_get_rectangle_corners_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_corners[8];
} go_gphys_camera_get_rectangle_corners_result;
static inline go_gphys_camera_get_rectangle_corners_result go_gphys_camera_get_rectangle_corners(void* camera, float x0, float y0, float x1, float y1) {
    go_gphys_camera_get_rectangle_corners_result r = {0};
    r.status = gphys_camera_get_rectangle_corners(camera, x0, y0, x1, y1, r.out_corners);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_project_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_pixel;
} go_gphys_camera_project_result;
static inline go_gphys_camera_project_result go_gphys_camera_project(void* camera, gphys_vec3 point) {
    go_gphys_camera_project_result r = {0};
    r.status = gphys_camera_project(camera, &point, &r.out_pixel);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_project_batch_result {
    gphys_status status;
    char* message;
} go_gphys_camera_project_batch_result;
static inline go_gphys_camera_project_batch_result go_gphys_camera_project_batch(void* camera, const gphys_vec3 * points, uint32_t point_stride, uint32_t count, gphys_vec3 * out_pixels, uint32_t out_stride) {
    go_gphys_camera_project_batch_result r = {0};
    r.status = gphys_camera_project_batch(camera, points, point_stride, count, out_pixels, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_unproject_result {
    gphys_status status;
    char* message;
    gphys_vec3 out_point;
} go_gphys_camera_unproject_result;
static inline go_gphys_camera_unproject_result go_gphys_camera_unproject(void* camera, gphys_vec3 pixel) {
    go_gphys_camera_unproject_result r = {0};
    r.status = gphys_camera_unproject(camera, &pixel, &r.out_point);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_unproject_batch_result {
    gphys_status status;
    char* message;
} go_gphys_camera_unproject_batch_result;
static inline go_gphys_camera_unproject_batch_result go_gphys_camera_unproject_batch(void* camera, const gphys_vec3 * pixels, uint32_t pixel_stride, uint32_t count, gphys_vec3 * out_points, uint32_t out_stride) {
    go_gphys_camera_unproject_batch_result r = {0};
    r.status = gphys_camera_unproject_batch(camera, pixels, pixel_stride, count, out_points, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_pick_ray_result {
    gphys_status status;
    char* message;
    gphys_ray out_ray;
} go_gphys_camera_pick_ray_result;
static inline go_gphys_camera_pick_ray_result go_gphys_camera_pick_ray(void* camera, float pixel_x, float pixel_y) {
    go_gphys_camera_pick_ray_result r = {0};
    r.status = gphys_camera_pick_ray(camera, pixel_x, pixel_y, &r.out_ray);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_pick_rays_result {
    gphys_status status;
    char* message;
} go_gphys_camera_pick_rays_result;
static inline go_gphys_camera_pick_rays_result go_gphys_camera_pick_rays(void* camera, uint32_t x, uint32_t y, uint32_t width, uint32_t height, gphys_ray * out_rays, uint32_t out_stride) {
    go_gphys_camera_pick_rays_result r = {0};
    r.status = gphys_camera_pick_rays(camera, x, y, width, height, out_rays, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_pick_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_camera_pick_result;
static inline go_gphys_camera_pick_result go_gphys_camera_pick(void* camera, void* scene, float pixel_x, float pixel_y, uint32_t layers) {
    go_gphys_camera_pick_result r = {0};
    r.status = gphys_camera_pick(camera, scene, pixel_x, pixel_y, layers, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_pick_batch_result {
    gphys_status status;
    char* message;
} go_gphys_camera_pick_batch_result;
static inline go_gphys_camera_pick_batch_result go_gphys_camera_pick_batch(void* camera, void* scene, const float * pixels, uint32_t pixel_stride, uint32_t count, uint32_t layers, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_camera_pick_batch_result r = {0};
    r.status = gphys_camera_pick_batch(camera, scene, pixels, pixel_stride, count, layers, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_pick_rectangle_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_camera_pick_rectangle_result;
static inline go_gphys_camera_pick_rectangle_result go_gphys_camera_pick_rectangle(void* camera, void* scene, float x0, float y0, float x1, float y1, uint32_t layers, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_camera_pick_rectangle_result r = {0};
    r.status = gphys_camera_pick_rectangle(camera, scene, x0, y0, x1, y1, layers, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_cull_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_camera_cull_result;
static inline go_gphys_camera_cull_result go_gphys_camera_cull(void* camera, void* scene, uint32_t layers, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_camera_cull_result r = {0};
    r.status = gphys_camera_cull(camera, scene, layers, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_pick_filtered_result {
    gphys_status status;
    char* message;
    gphys_hit out_hit;
} go_gphys_camera_pick_filtered_result;
static inline go_gphys_camera_pick_filtered_result go_gphys_camera_pick_filtered(void* camera, void* scene, float pixel_x, float pixel_y, const gphys_query_filter_desc * filter) {
    go_gphys_camera_pick_filtered_result r = {0};
    r.status = gphys_camera_pick_filtered(camera, scene, pixel_x, pixel_y, filter, &r.out_hit);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_pick_filtered_batch_result {
    gphys_status status;
    char* message;
} go_gphys_camera_pick_filtered_batch_result;
static inline go_gphys_camera_pick_filtered_batch_result go_gphys_camera_pick_filtered_batch(void* camera, void* scene, const float * pixels, uint32_t pixel_stride, uint32_t count, const gphys_query_filter_desc * filters, uint32_t filter_stride, gphys_hit * out_hits, uint32_t out_stride) {
    go_gphys_camera_pick_filtered_batch_result r = {0};
    r.status = gphys_camera_pick_filtered_batch(camera, scene, pixels, pixel_stride, count, filters, filter_stride, out_hits, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_pick_rectangle_filtered_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_camera_pick_rectangle_filtered_result;
static inline go_gphys_camera_pick_rectangle_filtered_result go_gphys_camera_pick_rectangle_filtered(void* camera, void* scene, float x0, float y0, float x1, float y1, const gphys_query_filter_desc * filter, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_camera_pick_rectangle_filtered_result r = {0};
    r.status = gphys_camera_pick_rectangle_filtered(camera, scene, x0, y0, x1, y1, filter, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_camera_cull_filtered_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_camera_cull_filtered_result;
static inline go_gphys_camera_cull_filtered_result go_gphys_camera_cull_filtered(void* camera, void* scene, const gphys_query_filter_desc * filter, gphys_model_id * out_models, uint32_t capacity) {
    go_gphys_camera_cull_filtered_result r = {0};
    r.status = gphys_camera_cull_filtered(camera, scene, filter, out_models, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_desc_init_result {
    gphys_status status;
    char* message;
    gphys_solver_desc desc;
} go_gphys_solver_desc_init_result;
static inline go_gphys_solver_desc_init_result go_gphys_solver_desc_init(uint32_t size) {
    go_gphys_solver_desc_init_result r = {0};
    r.status = gphys_solver_desc_init(&r.desc, size);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_create_result {
    gphys_status status;
    char* message;
    void* out_solver;
} go_gphys_solver_create_result;
static inline go_gphys_solver_create_result go_gphys_solver_create(const gphys_solver_desc * desc) {
    go_gphys_solver_create_result r = {0};
    r.status = gphys_solver_create(desc, (gphys_solver **)&r.out_solver);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_worker_count_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_worker_count_result;
static inline go_gphys_solver_set_worker_count_result go_gphys_solver_set_worker_count(void* solver, uint32_t workers) {
    go_gphys_solver_set_worker_count_result r = {0};
    r.status = gphys_solver_set_worker_count(solver, workers);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_worker_count_result {
    gphys_status status;
    char* message;
    uint32_t out_workers;
} go_gphys_solver_get_worker_count_result;
static inline go_gphys_solver_get_worker_count_result go_gphys_solver_get_worker_count(void* solver) {
    go_gphys_solver_get_worker_count_result r = {0};
    r.status = gphys_solver_get_worker_count(solver, &r.out_workers);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_origin_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_origin_result;
static inline go_gphys_solver_set_origin_result go_gphys_solver_set_origin(void* solver, const double * origin) {
    go_gphys_solver_set_origin_result r = {0};
    r.status = gphys_solver_set_origin(solver, origin);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_origin_result {
    gphys_status status;
    char* message;
    double out_origin[3];
} go_gphys_solver_get_origin_result;
static inline go_gphys_solver_get_origin_result go_gphys_solver_get_origin(void* solver) {
    go_gphys_solver_get_origin_result r = {0};
    r.status = gphys_solver_get_origin(solver, r.out_origin);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_gravity_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_gravity_result;
static inline go_gphys_solver_set_gravity_result go_gphys_solver_set_gravity(void* solver, gphys_vec3 gravity) {
    go_gphys_solver_set_gravity_result r = {0};
    r.status = gphys_solver_set_gravity(solver, &gravity);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_substeps_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_substeps_result;
static inline go_gphys_solver_set_substeps_result go_gphys_solver_set_substeps(void* solver, uint32_t substeps) {
    go_gphys_solver_set_substeps_result r = {0};
    r.status = gphys_solver_set_substeps(solver, substeps);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_settings_result {
    gphys_status status;
    char* message;
    gphys_solver_settings out_settings;
} go_gphys_solver_get_settings_result;
static inline go_gphys_solver_get_settings_result go_gphys_solver_get_settings(void* solver) {
    go_gphys_solver_get_settings_result r = {0};
    r.status = gphys_solver_get_settings(solver, &r.out_settings);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_settings_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_settings_result;
static inline go_gphys_solver_set_settings_result go_gphys_solver_set_settings(void* solver, gphys_solver_settings settings) {
    go_gphys_solver_set_settings_result r = {0};
    r.status = gphys_solver_set_settings(solver, &settings);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_body_desc_init_result {
    gphys_status status;
    char* message;
    gphys_body_desc desc;
} go_gphys_body_desc_init_result;
static inline go_gphys_body_desc_init_result go_gphys_body_desc_init(uint32_t size) {
    go_gphys_body_desc_init_result r = {0};
    r.status = gphys_body_desc_init(&r.desc, size);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_add_particles_result {
    gphys_status status;
    char* message;
    gphys_body_id out_body;
} go_gphys_solver_add_particles_result;
static inline go_gphys_solver_add_particles_result go_gphys_solver_add_particles(void* solver, const gphys_body_desc * desc, const gphys_vec3 * positions, uint32_t position_stride, uint32_t count) {
    go_gphys_solver_add_particles_result r = {0};
    r.status = gphys_solver_add_particles(solver, desc, positions, position_stride, count, &r.out_body);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_add_rope_result {
    gphys_status status;
    char* message;
    gphys_body_id out_body;
} go_gphys_solver_add_rope_result;
static inline go_gphys_solver_add_rope_result go_gphys_solver_add_rope(void* solver, const gphys_body_desc * desc, const gphys_vec3 * positions, uint32_t position_stride, uint32_t count, float link_length) {
    go_gphys_solver_add_rope_result r = {0};
    r.status = gphys_solver_add_rope(solver, desc, positions, position_stride, count, link_length, &r.out_body);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_add_cloth_result {
    gphys_status status;
    char* message;
    gphys_body_id out_body;
} go_gphys_solver_add_cloth_result;
static inline go_gphys_solver_add_cloth_result go_gphys_solver_add_cloth(void* solver, const gphys_body_desc * desc, gphys_vec3 corner, gphys_vec3 edge_u, gphys_vec3 edge_v, uint32_t columns, uint32_t rows) {
    go_gphys_solver_add_cloth_result r = {0};
    r.status = gphys_solver_add_cloth(solver, desc, &corner, &edge_u, &edge_v, columns, rows, &r.out_body);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_add_cloth_mesh_result {
    gphys_status status;
    char* message;
    gphys_body_id out_body;
} go_gphys_solver_add_cloth_mesh_result;
static inline go_gphys_solver_add_cloth_mesh_result go_gphys_solver_add_cloth_mesh(void* solver, const gphys_body_desc * desc, void* mesh, const gphys_transform * transform) {
    go_gphys_solver_add_cloth_mesh_result r = {0};
    r.status = gphys_solver_add_cloth_mesh(solver, desc, mesh, transform, &r.out_body);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_remove_body_result {
    gphys_status status;
    char* message;
} go_gphys_solver_remove_body_result;
static inline go_gphys_solver_remove_body_result go_gphys_solver_remove_body(void* solver, gphys_body_id body) {
    go_gphys_solver_remove_body_result r = {0};
    r.status = gphys_solver_remove_body(solver, body);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_bodies_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_bodies_result;
static inline go_gphys_solver_get_bodies_result go_gphys_solver_get_bodies(void* solver, gphys_body_id * out_bodies, uint32_t capacity) {
    go_gphys_solver_get_bodies_result r = {0};
    r.status = gphys_solver_get_bodies(solver, out_bodies, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_sleeping_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_sleeping_result;
static inline go_gphys_solver_get_sleeping_result go_gphys_solver_get_sleeping(void* solver, gphys_body_id * out_bodies, uint32_t capacity) {
    go_gphys_solver_get_sleeping_result r = {0};
    r.status = gphys_solver_get_sleeping(solver, out_bodies, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_wake_result {
    gphys_status status;
    char* message;
} go_gphys_solver_wake_result;
static inline go_gphys_solver_wake_result go_gphys_solver_wake(void* solver, gphys_body_id body) {
    go_gphys_solver_wake_result r = {0};
    r.status = gphys_solver_wake(solver, body);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_body_settings_result {
    gphys_status status;
    char* message;
    gphys_body_settings out_settings;
} go_gphys_solver_get_body_settings_result;
static inline go_gphys_solver_get_body_settings_result go_gphys_solver_get_body_settings(void* solver, gphys_body_id body) {
    go_gphys_solver_get_body_settings_result r = {0};
    r.status = gphys_solver_get_body_settings(solver, body, &r.out_settings);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_body_settings_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_body_settings_result;
static inline go_gphys_solver_set_body_settings_result go_gphys_solver_set_body_settings(void* solver, gphys_body_id body, gphys_body_settings settings) {
    go_gphys_solver_set_body_settings_result r = {0};
    r.status = gphys_solver_set_body_settings(solver, body, &settings);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_body_info_result {
    gphys_status status;
    char* message;
    gphys_body_info out_info;
} go_gphys_solver_get_body_info_result;
static inline go_gphys_solver_get_body_info_result go_gphys_solver_get_body_info(void* solver, gphys_body_id body) {
    go_gphys_solver_get_body_info_result r = {0};
    r.status = gphys_solver_get_body_info(solver, body, &r.out_info);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_triangles_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_triangles_result;
static inline go_gphys_solver_get_triangles_result go_gphys_solver_get_triangles(void* solver, gphys_body_id body, uint32_t * out_indices, uint32_t capacity) {
    go_gphys_solver_get_triangles_result r = {0};
    r.status = gphys_solver_get_triangles(solver, body, out_indices, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_mesh_create_from_body_result {
    gphys_status status;
    char* message;
    void* out_mesh;
} go_gphys_mesh_create_from_body_result;
static inline go_gphys_mesh_create_from_body_result go_gphys_mesh_create_from_body(const gphys_mesh_desc * desc, void* solver, gphys_body_id body) {
    go_gphys_mesh_create_from_body_result r = {0};
    r.status = gphys_mesh_create_from_body(desc, solver, body, (gphys_mesh **)&r.out_mesh);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_nearest_particle_result {
    gphys_status status;
    char* message;
    uint32_t out_particle;
} go_gphys_solver_get_nearest_particle_result;
static inline go_gphys_solver_get_nearest_particle_result go_gphys_solver_get_nearest_particle(void* solver, gphys_body_id body, uint32_t triangle, gphys_vec3 point) {
    go_gphys_solver_get_nearest_particle_result r = {0};
    r.status = gphys_solver_get_nearest_particle(solver, body, triangle, &point, &r.out_particle);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_positions_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_positions_result;
static inline go_gphys_solver_get_positions_result go_gphys_solver_get_positions(void* solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_vec3 * out_positions, uint32_t out_stride) {
    go_gphys_solver_get_positions_result r = {0};
    r.status = gphys_solver_get_positions(solver, body, first, count, out_positions, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_positions_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_positions_result;
static inline go_gphys_solver_set_positions_result go_gphys_solver_set_positions(void* solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_vec3 * positions, uint32_t stride) {
    go_gphys_solver_set_positions_result r = {0};
    r.status = gphys_solver_set_positions(solver, body, first, count, positions, stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_velocities_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_velocities_result;
static inline go_gphys_solver_get_velocities_result go_gphys_solver_get_velocities(void* solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_vec3 * out_velocities, uint32_t out_stride) {
    go_gphys_solver_get_velocities_result r = {0};
    r.status = gphys_solver_get_velocities(solver, body, first, count, out_velocities, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_velocities_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_velocities_result;
static inline go_gphys_solver_set_velocities_result go_gphys_solver_set_velocities(void* solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_vec3 * velocities, uint32_t stride) {
    go_gphys_solver_set_velocities_result r = {0};
    r.status = gphys_solver_set_velocities(solver, body, first, count, velocities, stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_masses_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_masses_result;
static inline go_gphys_solver_get_masses_result go_gphys_solver_get_masses(void* solver, gphys_body_id body, uint32_t first, uint32_t count, float * out_masses, uint32_t out_stride) {
    go_gphys_solver_get_masses_result r = {0};
    r.status = gphys_solver_get_masses(solver, body, first, count, out_masses, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_masses_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_masses_result;
static inline go_gphys_solver_set_masses_result go_gphys_solver_set_masses(void* solver, gphys_body_id body, uint32_t first, uint32_t count, const float * masses, uint32_t stride) {
    go_gphys_solver_set_masses_result r = {0};
    r.status = gphys_solver_set_masses(solver, body, first, count, masses, stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_radii_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_radii_result;
static inline go_gphys_solver_get_radii_result go_gphys_solver_get_radii(void* solver, gphys_body_id body, uint32_t first, uint32_t count, float * out_radii, uint32_t out_stride) {
    go_gphys_solver_get_radii_result r = {0};
    r.status = gphys_solver_get_radii(solver, body, first, count, out_radii, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_radii_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_radii_result;
static inline go_gphys_solver_set_radii_result go_gphys_solver_set_radii(void* solver, gphys_body_id body, uint32_t first, uint32_t count, const float * radii, uint32_t stride) {
    go_gphys_solver_set_radii_result r = {0};
    r.status = gphys_solver_set_radii(solver, body, first, count, radii, stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_friction_factors_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_friction_factors_result;
static inline go_gphys_solver_get_friction_factors_result go_gphys_solver_get_friction_factors(void* solver, gphys_body_id body, uint32_t first, uint32_t count, float * out_factors, uint32_t out_stride) {
    go_gphys_solver_get_friction_factors_result r = {0};
    r.status = gphys_solver_get_friction_factors(solver, body, first, count, out_factors, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_friction_factors_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_friction_factors_result;
static inline go_gphys_solver_set_friction_factors_result go_gphys_solver_set_friction_factors(void* solver, gphys_body_id body, uint32_t first, uint32_t count, const float * factors, uint32_t stride) {
    go_gphys_solver_set_friction_factors_result r = {0};
    r.status = gphys_solver_set_friction_factors(solver, body, first, count, factors, stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_forces_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_forces_result;
static inline go_gphys_solver_get_forces_result go_gphys_solver_get_forces(void* solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_vec3 * out_forces, uint32_t out_stride) {
    go_gphys_solver_get_forces_result r = {0};
    r.status = gphys_solver_get_forces(solver, body, first, count, out_forces, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_forces_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_forces_result;
static inline go_gphys_solver_set_forces_result go_gphys_solver_set_forces(void* solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_vec3 * forces, uint32_t stride) {
    go_gphys_solver_set_forces_result r = {0};
    r.status = gphys_solver_set_forces(solver, body, first, count, forces, stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_pinned_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_pinned_result;
static inline go_gphys_solver_get_pinned_result go_gphys_solver_get_pinned(void* solver, gphys_body_id body, uint32_t first, uint32_t count, int32_t * out_pinned, uint32_t out_stride) {
    go_gphys_solver_get_pinned_result r = {0};
    r.status = gphys_solver_get_pinned(solver, body, first, count, out_pinned, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_pinned_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_pinned_result;
static inline go_gphys_solver_set_pinned_result go_gphys_solver_set_pinned(void* solver, gphys_body_id body, uint32_t first, uint32_t count, int32_t pinned) {
    go_gphys_solver_set_pinned_result r = {0};
    r.status = gphys_solver_set_pinned(solver, body, first, count, pinned);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_wind_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_wind_result;
static inline go_gphys_solver_set_wind_result go_gphys_solver_set_wind(void* solver, gphys_body_id body, gphys_wind wind) {
    go_gphys_solver_set_wind_result r = {0};
    r.status = gphys_solver_set_wind(solver, body, &wind);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_wind_result {
    gphys_status status;
    char* message;
    gphys_wind out_wind;
} go_gphys_solver_get_wind_result;
static inline go_gphys_solver_get_wind_result go_gphys_solver_get_wind(void* solver, gphys_body_id body) {
    go_gphys_solver_get_wind_result r = {0};
    r.status = gphys_solver_get_wind(solver, body, &r.out_wind);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_air_velocities_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_air_velocities_result;
static inline go_gphys_solver_set_air_velocities_result go_gphys_solver_set_air_velocities(void* solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_vec3 * velocities, uint32_t stride) {
    go_gphys_solver_set_air_velocities_result r = {0};
    r.status = gphys_solver_set_air_velocities(solver, body, first, count, velocities, stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_air_velocities_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_air_velocities_result;
static inline go_gphys_solver_get_air_velocities_result go_gphys_solver_get_air_velocities(void* solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_vec3 * out_velocities, uint32_t out_stride) {
    go_gphys_solver_get_air_velocities_result r = {0};
    r.status = gphys_solver_get_air_velocities(solver, body, first, count, out_velocities, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_animation_targets_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_animation_targets_result;
static inline go_gphys_solver_set_animation_targets_result go_gphys_solver_set_animation_targets(void* solver, gphys_body_id body, uint32_t first, uint32_t count, const gphys_animation_target * targets, uint32_t stride) {
    go_gphys_solver_set_animation_targets_result r = {0};
    r.status = gphys_solver_set_animation_targets(solver, body, first, count, targets, stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_animation_targets_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_animation_targets_result;
static inline go_gphys_solver_get_animation_targets_result go_gphys_solver_get_animation_targets(void* solver, gphys_body_id body, uint32_t first, uint32_t count, gphys_animation_target * out_targets, uint32_t out_stride) {
    go_gphys_solver_get_animation_targets_result r = {0};
    r.status = gphys_solver_get_animation_targets(solver, body, first, count, out_targets, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_attach_result {
    gphys_status status;
    char* message;
} go_gphys_solver_attach_result;
static inline go_gphys_solver_attach_result go_gphys_solver_attach(void* solver, void* scene, gphys_body_id body, uint32_t particle, gphys_model_id model, const gphys_vec3 * local_point) {
    go_gphys_solver_attach_result r = {0};
    r.status = gphys_solver_attach(solver, scene, body, particle, model, local_point);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_detach_result {
    gphys_status status;
    char* message;
} go_gphys_solver_detach_result;
static inline go_gphys_solver_detach_result go_gphys_solver_detach(void* solver, gphys_body_id body, uint32_t particle) {
    go_gphys_solver_detach_result r = {0};
    r.status = gphys_solver_detach(solver, body, particle);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_attachments_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_attachments_result;
static inline go_gphys_solver_get_attachments_result go_gphys_solver_get_attachments(void* solver, gphys_body_id body, gphys_attachment * out_attachments, uint32_t capacity) {
    go_gphys_solver_get_attachments_result r = {0};
    r.status = gphys_solver_get_attachments(solver, body, out_attachments, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_add_distance_result {
    gphys_status status;
    char* message;
    gphys_constraint_id out_constraint;
} go_gphys_solver_add_distance_result;
static inline go_gphys_solver_add_distance_result go_gphys_solver_add_distance(void* solver, gphys_body_id body, uint32_t particle_a, uint32_t particle_b, float rest_length, float compliance) {
    go_gphys_solver_add_distance_result r = {0};
    r.status = gphys_solver_add_distance(solver, body, particle_a, particle_b, rest_length, compliance, &r.out_constraint);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_add_max_distance_result {
    gphys_status status;
    char* message;
    gphys_constraint_id out_constraint;
} go_gphys_solver_add_max_distance_result;
static inline go_gphys_solver_add_max_distance_result go_gphys_solver_add_max_distance(void* solver, gphys_body_id body, uint32_t particle_a, uint32_t particle_b, float max_length, float compliance) {
    go_gphys_solver_add_max_distance_result r = {0};
    r.status = gphys_solver_add_max_distance(solver, body, particle_a, particle_b, max_length, compliance, &r.out_constraint);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_constraint_damping_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_constraint_damping_result;
static inline go_gphys_solver_set_constraint_damping_result go_gphys_solver_set_constraint_damping(void* solver, gphys_body_id body, gphys_constraint_id constraint, float damping) {
    go_gphys_solver_set_constraint_damping_result r = {0};
    r.status = gphys_solver_set_constraint_damping(solver, body, constraint, damping);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_volume_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_volume_result;
static inline go_gphys_solver_set_volume_result go_gphys_solver_set_volume(void* solver, gphys_body_id body, float rest_volume, float compliance) {
    go_gphys_solver_set_volume_result r = {0};
    r.status = gphys_solver_set_volume(solver, body, rest_volume, compliance);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_volume_result {
    gphys_status status;
    char* message;
    float out_volume;
    float out_pressure;
} go_gphys_solver_get_volume_result;
static inline go_gphys_solver_get_volume_result go_gphys_solver_get_volume(void* solver, gphys_body_id body) {
    go_gphys_solver_get_volume_result r = {0};
    r.status = gphys_solver_get_volume(solver, body, &r.out_volume, &r.out_pressure);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_volume_settings_result {
    gphys_status status;
    char* message;
    float out_rest_volume;
    float out_compliance;
} go_gphys_solver_get_volume_settings_result;
static inline go_gphys_solver_get_volume_settings_result go_gphys_solver_get_volume_settings(void* solver, gphys_body_id body) {
    go_gphys_solver_get_volume_settings_result r = {0};
    r.status = gphys_solver_get_volume_settings(solver, body, &r.out_rest_volume, &r.out_compliance);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_remove_constraint_result {
    gphys_status status;
    char* message;
} go_gphys_solver_remove_constraint_result;
static inline go_gphys_solver_remove_constraint_result go_gphys_solver_remove_constraint(void* solver, gphys_body_id body, gphys_constraint_id constraint) {
    go_gphys_solver_remove_constraint_result r = {0};
    r.status = gphys_solver_remove_constraint(solver, body, constraint);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_constraints_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_constraints_result;
static inline go_gphys_solver_get_constraints_result go_gphys_solver_get_constraints(void* solver, gphys_body_id body, gphys_constraint_info * out_constraints, uint32_t capacity) {
    go_gphys_solver_get_constraints_result r = {0};
    r.status = gphys_solver_get_constraints(solver, body, out_constraints, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_constraint_kinds_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_constraint_kinds_result;
static inline go_gphys_solver_get_constraint_kinds_result go_gphys_solver_get_constraint_kinds(void* solver, gphys_body_id body, const gphys_constraint_id * constraints, uint32_t count, gphys_constraint_kind * out_kinds, uint32_t out_stride) {
    go_gphys_solver_get_constraint_kinds_result r = {0};
    r.status = gphys_solver_get_constraint_kinds(solver, body, constraints, count, out_kinds, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_constraint_settings_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_constraint_settings_result;
static inline go_gphys_solver_get_constraint_settings_result go_gphys_solver_get_constraint_settings(void* solver, gphys_body_id body, const gphys_constraint_id * constraints, uint32_t count, gphys_constraint_settings * out_settings, uint32_t out_stride) {
    go_gphys_solver_get_constraint_settings_result r = {0};
    r.status = gphys_solver_get_constraint_settings(solver, body, constraints, count, out_settings, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_constraint_settings_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_constraint_settings_result;
static inline go_gphys_solver_set_constraint_settings_result go_gphys_solver_set_constraint_settings(void* solver, gphys_body_id body, const gphys_constraint_id * constraints, const gphys_constraint_settings * settings, uint32_t setting_stride, uint32_t count) {
    go_gphys_solver_set_constraint_settings_result r = {0};
    r.status = gphys_solver_set_constraint_settings(solver, body, constraints, settings, setting_stride, count);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_add_cluster_result {
    gphys_status status;
    char* message;
    gphys_cluster_id out_cluster;
} go_gphys_solver_add_cluster_result;
static inline go_gphys_solver_add_cluster_result go_gphys_solver_add_cluster(void* solver, gphys_body_id body, const uint32_t * particles, uint32_t count) {
    go_gphys_solver_add_cluster_result r = {0};
    r.status = gphys_solver_add_cluster(solver, body, particles, count, &r.out_cluster);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_remove_cluster_result {
    gphys_status status;
    char* message;
} go_gphys_solver_remove_cluster_result;
static inline go_gphys_solver_remove_cluster_result go_gphys_solver_remove_cluster(void* solver, gphys_body_id body, gphys_cluster_id cluster) {
    go_gphys_solver_remove_cluster_result r = {0};
    r.status = gphys_solver_remove_cluster(solver, body, cluster);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_clusters_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_clusters_result;
static inline go_gphys_solver_get_clusters_result go_gphys_solver_get_clusters(void* solver, gphys_body_id body, gphys_cluster_id * out_clusters, uint32_t capacity) {
    go_gphys_solver_get_clusters_result r = {0};
    r.status = gphys_solver_get_clusters(solver, body, out_clusters, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_cluster_particles_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_cluster_particles_result;
static inline go_gphys_solver_get_cluster_particles_result go_gphys_solver_get_cluster_particles(void* solver, gphys_body_id body, gphys_cluster_id cluster, uint32_t * out_particles, uint32_t capacity) {
    go_gphys_solver_get_cluster_particles_result r = {0};
    r.status = gphys_solver_get_cluster_particles(solver, body, cluster, out_particles, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_join_result {
    gphys_status status;
    char* message;
    gphys_joint_id out_joint;
} go_gphys_solver_join_result;
static inline go_gphys_solver_join_result go_gphys_solver_join(void* solver, gphys_body_id body_a, uint32_t particle_a, gphys_body_id body_b, uint32_t particle_b, float rest_length, float compliance) {
    go_gphys_solver_join_result r = {0};
    r.status = gphys_solver_join(solver, body_a, particle_a, body_b, particle_b, rest_length, compliance, &r.out_joint);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_unjoin_result {
    gphys_status status;
    char* message;
} go_gphys_solver_unjoin_result;
static inline go_gphys_solver_unjoin_result go_gphys_solver_unjoin(void* solver, gphys_joint_id joint) {
    go_gphys_solver_unjoin_result r = {0};
    r.status = gphys_solver_unjoin(solver, joint);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_joints_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_joints_result;
static inline go_gphys_solver_get_joints_result go_gphys_solver_get_joints(void* solver, gphys_body_id body, gphys_joint_info * out_joints, uint32_t capacity) {
    go_gphys_solver_get_joints_result r = {0};
    r.status = gphys_solver_get_joints(solver, body, out_joints, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_set_breaking_forces_result {
    gphys_status status;
    char* message;
} go_gphys_solver_set_breaking_forces_result;
static inline go_gphys_solver_set_breaking_forces_result go_gphys_solver_set_breaking_forces(void* solver, gphys_body_id body, const gphys_constraint_id * constraints, const float * forces, uint32_t force_stride, uint32_t count) {
    go_gphys_solver_set_breaking_forces_result r = {0};
    r.status = gphys_solver_set_breaking_forces(solver, body, constraints, forces, force_stride, count);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_breaking_forces_result {
    gphys_status status;
    char* message;
} go_gphys_solver_get_breaking_forces_result;
static inline go_gphys_solver_get_breaking_forces_result go_gphys_solver_get_breaking_forces(void* solver, gphys_body_id body, const gphys_constraint_id * constraints, uint32_t count, float * out_forces, uint32_t out_stride) {
    go_gphys_solver_get_breaking_forces_result r = {0};
    r.status = gphys_solver_get_breaking_forces(solver, body, constraints, count, out_forces, out_stride);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_break_constraint_result {
    gphys_status status;
    char* message;
    gphys_break out_result;
} go_gphys_solver_break_constraint_result;
static inline go_gphys_solver_break_constraint_result go_gphys_solver_break_constraint(void* solver, gphys_body_id body, gphys_constraint_id constraint) {
    go_gphys_solver_break_constraint_result r = {0};
    r.status = gphys_solver_break_constraint(solver, body, constraint, &r.out_result);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_breaks_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_breaks_result;
static inline go_gphys_solver_get_breaks_result go_gphys_solver_get_breaks(void* solver, gphys_break * out_breaks, uint32_t capacity) {
    go_gphys_solver_get_breaks_result r = {0};
    r.status = gphys_solver_get_breaks(solver, out_breaks, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_step_result {
    gphys_status status;
    char* message;
} go_gphys_solver_step_result;
static inline go_gphys_solver_step_result go_gphys_solver_step(void* solver, void* scene, float dt) {
    go_gphys_solver_step_result r = {0};
    r.status = gphys_solver_step(solver, scene, dt);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_advance_result {
    gphys_status status;
    char* message;
    uint32_t out_steps;
    float out_leftover;
} go_gphys_solver_advance_result;
static inline go_gphys_solver_advance_result go_gphys_solver_advance(void* solver, void* scene, float frame_time) {
    go_gphys_solver_advance_result r = {0};
    r.status = gphys_solver_advance(solver, scene, frame_time, &r.out_steps, &r.out_leftover);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_leftover_result {
    gphys_status status;
    char* message;
    float out_leftover;
} go_gphys_solver_get_leftover_result;
static inline go_gphys_solver_get_leftover_result go_gphys_solver_get_leftover(void* solver) {
    go_gphys_solver_get_leftover_result r = {0};
    r.status = gphys_solver_get_leftover(solver, &r.out_leftover);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_substeps_result {
    gphys_status status;
    char* message;
    uint32_t out_substeps;
} go_gphys_solver_get_substeps_result;
static inline go_gphys_solver_get_substeps_result go_gphys_solver_get_substeps(void* solver, gphys_body_id body) {
    go_gphys_solver_get_substeps_result r = {0};
    r.status = gphys_solver_get_substeps(solver, body, &r.out_substeps);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_stats_result {
    gphys_status status;
    char* message;
    gphys_solver_stats out_stats;
} go_gphys_solver_get_stats_result;
static inline go_gphys_solver_get_stats_result go_gphys_solver_get_stats(void* solver, gphys_body_id body) {
    go_gphys_solver_get_stats_result r = {0};
    r.status = gphys_solver_get_stats(solver, body, &r.out_stats);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_contacts_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_contacts_result;
static inline go_gphys_solver_get_contacts_result go_gphys_solver_get_contacts(void* solver, gphys_contact * out_contacts, uint32_t capacity) {
    go_gphys_solver_get_contacts_result r = {0};
    r.status = gphys_solver_get_contacts(solver, out_contacts, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_body_contacts_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_body_contacts_result;
static inline go_gphys_solver_get_body_contacts_result go_gphys_solver_get_body_contacts(void* solver, gphys_body_contact * out_contacts, uint32_t capacity) {
    go_gphys_solver_get_body_contacts_result r = {0};
    r.status = gphys_solver_get_body_contacts(solver, out_contacts, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_impulses_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_impulses_result;
static inline go_gphys_solver_get_impulses_result go_gphys_solver_get_impulses(void* solver, gphys_impulse * out_impulses, uint32_t capacity) {
    go_gphys_solver_get_impulses_result r = {0};
    r.status = gphys_solver_get_impulses(solver, out_impulses, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_snapshot_result {
    gphys_status status;
    char* message;
    uint32_t out_total;
} go_gphys_solver_get_snapshot_result;
static inline go_gphys_solver_get_snapshot_result go_gphys_solver_get_snapshot(void* solver, uint32_t * out_words, uint32_t capacity) {
    go_gphys_solver_get_snapshot_result r = {0};
    r.status = gphys_solver_get_snapshot(solver, out_words, capacity, &r.out_total);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_restore_result {
    gphys_status status;
    char* message;
} go_gphys_solver_restore_result;
static inline go_gphys_solver_restore_result go_gphys_solver_restore(void* solver, const uint32_t * words, uint32_t count) {
    go_gphys_solver_restore_result r = {0};
    r.status = gphys_solver_restore(solver, words, count);
    r.message = go_message(r.status);
    return r;
}

typedef struct go_gphys_solver_get_hash_result {
    gphys_status status;
    char* message;
    uint32_t out_hash[2];
} go_gphys_solver_get_hash_result;
static inline go_gphys_solver_get_hash_result go_gphys_solver_get_hash(void* solver) {
    go_gphys_solver_get_hash_result r = {0};
    r.status = gphys_solver_get_hash(solver, r.out_hash);
    r.message = go_message(r.status);
    return r;
}

#endif

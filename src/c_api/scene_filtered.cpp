// gphys_scene_*_filtered: queries with a gphys_query_filter_desc, single and in batches. Each reads the filter and
// calls the template in scene_query.h that the plain query calls too.
#include "c_api/scene_query.h"

using namespace gphys;

gphys_status gphys_scene_raycast_filtered(const gphys_scene* scene, const gphys_ray* ray,
                                          const gphys_query_filter_desc* filter, gphys_hit* out_hit) {
    return guarded(__func__, [&] { return scene_raycast(scene, "ray", ray, filter, out_hit); });
}

gphys_status gphys_scene_raycast_filtered_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                                uint32_t count, const gphys_query_filter_desc* filters,
                                                uint32_t filter_stride, gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_raycast_batch(scene, "rays", rays, "ray_stride", ray_stride, count,
                                   FilterArray{filters, filter_stride}, out_hits, out_stride);
    });
}

gphys_status gphys_scene_raycast_distance_filtered_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                         uint32_t ray_stride, uint32_t count,
                                                         const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                         gphys_distance* out_distances, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_raycast_batch(scene, "rays", rays, "ray_stride", ray_stride, count,
                                   FilterArray{filters, filter_stride}, out_distances, out_stride);
    });
}

gphys_status gphys_scene_raycast_any_filtered(const gphys_scene* scene, const gphys_ray* ray,
                                              const gphys_query_filter_desc* filter, int32_t* out_hit) {
    return guarded(__func__, [&] { return scene_raycast_any(scene, ray, filter, out_hit); });
}

gphys_status gphys_scene_raycast_any_filtered_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                    uint32_t ray_stride, uint32_t count,
                                                    const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                    int32_t* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_raycast_any_batch(scene, rays, ray_stride, count, FilterArray{filters, filter_stride}, out_hits,
                                       out_stride);
    });
}

gphys_status gphys_scene_raycast_all_filtered(const gphys_scene* scene, const gphys_ray* ray,
                                              const gphys_query_filter_desc* filter, gphys_hit* out_hits,
                                              uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&] { return scene_raycast_all(scene, ray, filter, out_hits, capacity, out_total); });
}

gphys_status gphys_scene_raycast_all_filtered_batch(const gphys_scene* scene, const gphys_ray* rays,
                                                    uint32_t ray_stride, uint32_t count,
                                                    const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                    gphys_hit* out_hits, uint32_t capacity, uint32_t* out_offsets) {
    return guarded(__func__, [&] {
        return scene_raycast_all_batch(scene, rays, ray_stride, count, FilterArray{filters, filter_stride}, out_hits,
                                       capacity, out_offsets);
    });
}

gphys_status gphys_scene_segment_test_filtered(const gphys_scene* scene, const gphys_segment* segment,
                                               const gphys_query_filter_desc* filter, gphys_hit* out_hit) {
    return guarded(__func__, [&] { return scene_raycast(scene, "segment", segment, filter, out_hit); });
}

gphys_status gphys_scene_segment_test_filtered_batch(const gphys_scene* scene, const gphys_segment* segments,
                                                     uint32_t segment_stride, uint32_t count,
                                                     const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                     gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_raycast_batch(scene, "segments", segments, "segment_stride", segment_stride, count,
                                   FilterArray{filters, filter_stride}, out_hits, out_stride);
    });
}

gphys_status gphys_scene_overlap_filtered(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                          const gphys_query_filter_desc* filter, gphys_model_id* out_models,
                                          uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__,
                   [&] { return scene_overlap(scene, type, shape, filter, out_models, capacity, out_total); });
}

gphys_status gphys_scene_overlap_filtered_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                                uint32_t shape_stride, uint32_t count,
                                                const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                gphys_model_id* out_models, uint32_t capacity, uint32_t* out_offsets) {
    return guarded(__func__, [&] {
        return scene_overlap_batch(scene, type, shapes, shape_stride, count, FilterArray{filters, filter_stride},
                                   out_models, capacity, out_offsets);
    });
}

gphys_status gphys_scene_cull_filtered(const gphys_scene* scene, const gphys_frustum* frustum,
                                       const gphys_query_filter_desc* filter, gphys_model_id* out_models,
                                       uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&] { return scene_cull(scene, frustum, filter, out_models, capacity, out_total); });
}

gphys_status gphys_scene_cull_filtered_batch(const gphys_scene* scene, const gphys_frustum* frusta,
                                             uint32_t frustum_stride, uint32_t count,
                                             const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                             gphys_model_id* out_models, uint32_t capacity, uint32_t* out_offsets) {
    return guarded(__func__, [&] {
        return scene_cull_batch(scene, frusta, frustum_stride, count, FilterArray{filters, filter_stride}, out_models,
                                capacity, out_offsets);
    });
}

gphys_status gphys_scene_nearest_filtered(const gphys_scene* scene, const gphys_vec3* point, float max_distance,
                                          const gphys_query_filter_desc* filter, gphys_nearest* out_nearest) {
    return guarded(__func__, [&] { return scene_nearest(scene, point, max_distance, filter, out_nearest); });
}

gphys_status gphys_scene_nearest_filtered_batch(const gphys_scene* scene, const gphys_vec3* points,
                                                uint32_t point_stride, uint32_t count, float max_distance,
                                                const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                gphys_nearest* out_nearest, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_nearest_batch(scene, points, point_stride, count, max_distance,
                                   FilterArray{filters, filter_stride}, out_nearest, out_stride);
    });
}

gphys_status gphys_scene_sweep_sphere_filtered(const gphys_scene* scene, const gphys_sphere* sphere,
                                               const gphys_vec3* displacement, const gphys_query_filter_desc* filter,
                                               gphys_hit* out_hit) {
    return guarded(__func__, [&] { return scene_sweep_sphere(scene, sphere, displacement, filter, out_hit); });
}

gphys_status gphys_scene_sweep_sphere_filtered_batch(const gphys_scene* scene, const gphys_sphere* spheres,
                                                     uint32_t sphere_stride, const gphys_vec3* displacements,
                                                     uint32_t displacement_stride, uint32_t count,
                                                     const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                     gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_sweep_sphere_batch(scene, spheres, sphere_stride, displacements, displacement_stride, count,
                                        FilterArray{filters, filter_stride}, out_hits, out_stride);
    });
}

// gphys_scene_*: queries by layers, single and in batches. Those with a filter are in scene_filtered.cpp.
#include "c_api/scene_query.h"

using namespace gphys;

gphys_status gphys_scene_raycast(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers, gphys_hit* out_hit) {
    return guarded(__func__, [&] { return scene_raycast(scene, "ray", ray, layers, out_hit); });
}

gphys_status gphys_scene_raycast_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                       uint32_t count, uint32_t layers, gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_raycast_batch(scene, "rays", rays, "ray_stride", ray_stride, count, layers, out_hits, out_stride);
    });
}

gphys_status gphys_scene_raycast_distance_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                                uint32_t count, uint32_t layers, gphys_distance* out_distances,
                                                uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_raycast_batch(scene, "rays", rays, "ray_stride", ray_stride, count, layers, out_distances,
                                   out_stride);
    });
}

gphys_status gphys_scene_raycast_any(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers,
                                     int32_t* out_hit) {
    return guarded(__func__, [&] { return scene_raycast_any(scene, ray, layers, out_hit); });
}

gphys_status gphys_scene_raycast_any_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                           uint32_t count, uint32_t layers, int32_t* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_raycast_any_batch(scene, rays, ray_stride, count, layers, out_hits, out_stride);
    });
}

gphys_status gphys_scene_raycast_all(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers,
                                     gphys_hit* out_hits, uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&] { return scene_raycast_all(scene, ray, layers, out_hits, capacity, out_total); });
}

gphys_status gphys_scene_raycast_all_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                           uint32_t count, uint32_t layers, gphys_hit* out_hits, uint32_t capacity,
                                           uint32_t* out_offsets) {
    return guarded(__func__, [&] {
        return scene_raycast_all_batch(scene, rays, ray_stride, count, layers, out_hits, capacity, out_offsets);
    });
}

gphys_status gphys_scene_segment_test(const gphys_scene* scene, const gphys_segment* segment, uint32_t layers,
                                      gphys_hit* out_hit) {
    return guarded(__func__, [&] { return scene_raycast(scene, "segment", segment, layers, out_hit); });
}

gphys_status gphys_scene_segment_test_batch(const gphys_scene* scene, const gphys_segment* segments,
                                            uint32_t segment_stride, uint32_t count, uint32_t layers,
                                            gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_raycast_batch(scene, "segments", segments, "segment_stride", segment_stride, count, layers,
                                   out_hits, out_stride);
    });
}

gphys_status gphys_scene_overlap(const gphys_scene* scene, gphys_shape_type type, const void* shape, uint32_t layers,
                                 gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__,
                   [&] { return scene_overlap(scene, type, shape, layers, out_models, capacity, out_total); });
}

gphys_status gphys_scene_overlap_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                       uint32_t shape_stride, uint32_t count, uint32_t layers,
                                       gphys_model_id* out_models, uint32_t capacity, uint32_t* out_offsets) {
    return guarded(__func__, [&] {
        return scene_overlap_batch(scene, type, shapes, shape_stride, count, layers, out_models, capacity, out_offsets);
    });
}

gphys_status gphys_scene_cull(const gphys_scene* scene, const gphys_frustum* frustum, uint32_t layers,
                              gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&] { return scene_cull(scene, frustum, layers, out_models, capacity, out_total); });
}

gphys_status gphys_scene_cull_batch(const gphys_scene* scene, const gphys_frustum* frusta, uint32_t frustum_stride,
                                    uint32_t count, uint32_t layers, gphys_model_id* out_models, uint32_t capacity,
                                    uint32_t* out_offsets) {
    return guarded(__func__, [&] {
        return scene_cull_batch(scene, frusta, frustum_stride, count, layers, out_models, capacity, out_offsets);
    });
}

gphys_status gphys_scene_nearest(const gphys_scene* scene, const gphys_vec3* point, float max_distance, uint32_t layers,
                                 gphys_nearest* out_nearest) {
    return guarded(__func__, [&] { return scene_nearest(scene, point, max_distance, layers, out_nearest); });
}

gphys_status gphys_scene_nearest_batch(const gphys_scene* scene, const gphys_vec3* points, uint32_t point_stride,
                                       uint32_t count, float max_distance, uint32_t layers, gphys_nearest* out_nearest,
                                       uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_nearest_batch(scene, points, point_stride, count, max_distance, layers, out_nearest, out_stride);
    });
}

gphys_status gphys_scene_sweep_sphere(const gphys_scene* scene, const gphys_sphere* sphere,
                                      const gphys_vec3* displacement, uint32_t layers, gphys_hit* out_hit) {
    return guarded(__func__, [&] { return scene_sweep_sphere(scene, sphere, displacement, layers, out_hit); });
}

gphys_status gphys_scene_sweep_sphere_batch(const gphys_scene* scene, const gphys_sphere* spheres,
                                            uint32_t sphere_stride, const gphys_vec3* displacements,
                                            uint32_t displacement_stride, uint32_t count, uint32_t layers,
                                            gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_sweep_sphere_batch(scene, spheres, sphere_stride, displacements, displacement_stride, count,
                                        layers, out_hits, out_stride);
    });
}

// gphys_scene_*: queries, one by one and in batches.
#include "scene/scene.h"

#include "c_api/api.h"
#include "c_api/batch.h"
#include "c_api/handles.h"
#include "c_api/lists.h"
#include "c_api/shape_input.h"
#include "foundation/compiler.h"

using namespace gphys;

namespace {

/// The input array of a batch: there, well spaced and, element by element, valid.
template <class T>
gphys_status check_inputs(const Workers& workers, const T* inputs, const char* name, uint32_t stride, uint32_t count) {
    GPHYS_REQUIRE(inputs || count == 0, "the input array is null");
    GPHYS_TRY(check_stride(name, stride, sizeof(T)));
    const Strided<T> input(inputs, stride);
    return check_each(workers, distinct(stride, count), [&](uint32_t i) -> gphys_status {
        GPHYS_REQUIRE_VALID(input[i]);
        return GPHYS_OK;
    });
}

template <class T>
gphys_status check_outputs(const T* outputs, uint32_t stride, uint32_t count) {
    GPHYS_REQUIRE(outputs || count == 0, "the output array is null");
    return check_out_stride("out_stride", stride, sizeof(T));
}

gphys_status check_concatenation(const void* out, uint32_t capacity, const uint32_t* out_offsets) {
    GPHYS_REQUIRE(capacity == 0 || out, "the output array is null");
    GPHYS_REQUIRE(out_offsets, "out_offsets is null");
    return GPHYS_OK;
}

/// The input array of a batch of shapes that move.
gphys_status check_moving(const Workers& workers, gphys_shape_type type, const void* shapes, uint32_t stride,
                          uint32_t count) {
    GPHYS_TRY(check_stride("shape_stride", stride, shape_struct_size(type)));
    const Strided<char> shape(static_cast<const char*>(shapes), stride);
    return check_each(workers, distinct(stride, count), [&](uint32_t i) {
        Shape moving;
        return read_moving(type, shapes ? &shape[i] : nullptr, moving);
    });
}

/// The overlaps of shapes first .. first + count - 1, at most OverlapItems::most_queries; by list_of(i, add_all) as in
/// concatenate.
template <class ListOf>
void list_overlaps(const Scene& scene, gphys_shape_type type, const Strided<char>& shapes, uint32_t first,
                   uint32_t count, uint32_t layers, const ListOf& list_of) {
    Shape queries[OverlapItems::most_queries];
    OverlapItems met[OverlapItems::most_queries];
    // They have been checked; if the caller has spoiled one since then, nothing is found, but all lists are there.
    bool valid = true;
    for (uint32_t k = 0; k < count; ++k) valid &= read_shape(type, &shapes[first + k], queries[k]) == GPHYS_OK;
    if (valid) scene.meet(queries, count, layers, met);
    for (uint32_t k = 0; k < count; ++k) {
        list_of(first + k, [&](auto& models) {
            if (valid) scene.overlap(queries[k], layers, models, met + k);
        });
    }
}

bool valid_max_distance(float distance) { return distance >= 0; }

}  // namespace

gphys_status gphys_scene_raycast(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers, gphys_hit* out_hit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        GPHYS_REQUIRE(ray, "ray is null");
        GPHYS_REQUIRE_VALID(*ray);
        GPHYS_REQUIRE(out_hit, "out_hit is null");
        return unwrap(scene)->raycast(widen(*ray), layers, *out_hit);
    });
}

gphys_status gphys_scene_raycast_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                       uint32_t count, uint32_t layers, gphys_hit* out_hits, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        const Workers& workers = unwrap(scene)->workers();
        GPHYS_TRY(check_inputs(workers, rays, "ray_stride", ray_stride, count));
        GPHYS_TRY(check_outputs(out_hits, out_stride, count));
        const Strided<gphys_ray> ray(rays, ray_stride);
        const StridedOut<gphys_hit> out(out_hits, out_stride);
        raycast_each(*unwrap(scene), ray, ray_coordinates, count, layers, out, [](const gphys_ray& given, Ray& r) {
            r = widen(given);
            return true;
        });
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_raycast_any(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers,
                                     int32_t* out_hit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        GPHYS_REQUIRE(ray, "ray is null");
        GPHYS_REQUIRE_VALID(*ray);
        GPHYS_REQUIRE(out_hit, "out_hit is null");
        *out_hit = unwrap(scene)->raycast_any(widen(*ray), layers);
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_raycast_any_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                           uint32_t count, uint32_t layers, int32_t* out_hits, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        const Workers& workers = unwrap(scene)->workers();
        GPHYS_TRY(check_inputs(workers, rays, "ray_stride", ray_stride, count));
        GPHYS_TRY(check_outputs(out_hits, out_stride, count));
        const Strided<gphys_ray> ray(rays, ray_stride);
        const StridedOut<int32_t> out(out_hits, out_stride);
        const auto ray_of = [&](uint32_t i, Ray& r) {
            r = widen(ray[i]);
            return true;
        };
        const ImageTiles tiles(ray.beginnings<float>(), ray_coordinates, count);
        cast_by_tiles(*unwrap(scene), tiles, ray_of, prefetch_elements(ray, out),
                      [&](Ray* tile, const uint32_t* items, uint32_t size) {
                          const uint64_t met = unwrap(scene)->raycast_any_many(tile, size, layers);
                          for (uint32_t k = 0; k < size; ++k) out[items[k]] = static_cast<int32_t>(met >> k & 1);
                      });
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_raycast_all(const gphys_scene* scene, const gphys_ray* ray, uint32_t layers,
                                     gphys_hit* out_hits, uint32_t capacity, uint32_t* out_total) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        GPHYS_REQUIRE(ray, "ray is null");
        GPHYS_REQUIRE_VALID(*ray);
        GPHYS_TRY(check_list(out_hits, capacity, out_total));
        Smallest<gphys_hit, FirstHit> hits(out_hits, capacity);
        unwrap(scene)->raycast_all(widen(*ray), layers, hits);
        return listed(hits.finish(), capacity, out_total);
    });
}

gphys_status gphys_scene_raycast_all_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                           uint32_t count, uint32_t layers, gphys_hit* out_hits, uint32_t capacity,
                                           uint32_t* out_offsets) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        const Workers& workers = unwrap(scene)->workers();
        GPHYS_TRY(check_inputs(workers, rays, "ray_stride", ray_stride, count));
        GPHYS_TRY(check_concatenation(out_hits, capacity, out_offsets));
        const Strided<gphys_ray> ray(rays, ray_stride);
        return concatenate<gphys_hit, FirstHit>(
            workers, out_hits, capacity, count, out_offsets, [&](uint32_t begin, uint32_t end, const auto& list_of) {
                for (uint32_t i = begin; i < end; ++i) {
                    list_of(i, [&](auto& hits) { unwrap(scene)->raycast_all(widen(ray[i]), layers, hits); });
                }
            });
    });
}

gphys_status gphys_scene_segment_test(const gphys_scene* scene, const gphys_segment* segment, uint32_t layers,
                                      gphys_hit* out_hit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        GPHYS_REQUIRE(segment, "segment is null");
        GPHYS_REQUIRE_VALID(*segment);
        GPHYS_REQUIRE(out_hit, "out_hit is null");
        return unwrap(scene)->raycast(ray_along(widen(*segment)), layers, *out_hit);
    });
}

gphys_status gphys_scene_segment_test_batch(const gphys_scene* scene, const gphys_segment* segments,
                                            uint32_t segment_stride, uint32_t count, uint32_t layers,
                                            gphys_hit* out_hits, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        const Workers& workers = unwrap(scene)->workers();
        GPHYS_TRY(check_inputs(workers, segments, "segment_stride", segment_stride, count));
        GPHYS_TRY(check_outputs(out_hits, out_stride, count));
        const Strided<gphys_segment> segment(segments, segment_stride);
        const StridedOut<gphys_hit> out(out_hits, out_stride);
        raycast_each(*unwrap(scene), segment, ray_coordinates, count, layers, out,
                     [](const gphys_segment& given, Ray& ray) {
                         ray = ray_along(widen(given));
                         return true;
                     });
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_overlap(const gphys_scene* scene, gphys_shape_type type, const void* shape, uint32_t layers,
                                 gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        Shape query;
        GPHYS_TRY(read_shape(type, shape, query));
        GPHYS_TRY(check_list(out_models, capacity, out_total));
        Smallest<gphys_model_id> models(out_models, capacity);
        unwrap(scene)->overlap(query, layers, models);
        return listed(models.finish(), capacity, out_total);
    });
}

gphys_status gphys_scene_overlap_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                       uint32_t shape_stride, uint32_t count, uint32_t layers,
                                       gphys_model_id* out_models, uint32_t capacity, uint32_t* out_offsets) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        const Workers& workers = unwrap(scene)->workers();
        GPHYS_TRY(check_stride("shape_stride", shape_stride, shape_struct_size(type)));
        const Strided<char> shape(static_cast<const char*>(shapes), shape_stride);
        GPHYS_TRY(check_each(workers, distinct(shape_stride, count), [&](uint32_t i) {
            Shape query;
            return read_shape(type, shapes ? &shape[i] : nullptr, query);
        }));
        GPHYS_TRY(check_concatenation(out_models, capacity, out_offsets));
        return concatenate<gphys_model_id, std::less<gphys_model_id>>(
            workers, out_models, capacity, count, out_offsets, [&](uint32_t begin, uint32_t end, const auto& list_of) {
                for (uint32_t first = begin; first < end; first += OverlapItems::most_queries) {
                    const uint32_t size = std::min(end - first, OverlapItems::most_queries);
                    list_overlaps(*unwrap(scene), type, shape, first, size, layers, list_of);
                }
            });
    });
}

gphys_status gphys_scene_cull(const gphys_scene* scene, const gphys_frustum* frustum, uint32_t layers,
                              gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        GPHYS_REQUIRE(frustum, "frustum is null");
        GPHYS_REQUIRE_VALID(*frustum);
        GPHYS_TRY(check_list(out_models, capacity, out_total));
        const uint32_t total = unwrap(scene)->cull(widen(*frustum), layers, out_models, capacity);
        return listed(total, capacity, out_total);
    });
}

gphys_status gphys_scene_nearest(const gphys_scene* scene, const gphys_vec3* point, float max_distance, uint32_t layers,
                                 gphys_nearest* out_nearest) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        GPHYS_REQUIRE(point, "point is null");
        GPHYS_REQUIRE_VALID(*point);
        GPHYS_REQUIRE(valid_max_distance(max_distance), "max_distance: must be 0 or more and not NaN");
        GPHYS_REQUIRE(out_nearest, "out_nearest is null");
        return unwrap(scene)->nearest(widen(*point), max_distance, layers, *out_nearest);
    });
}

gphys_status gphys_scene_nearest_batch(const gphys_scene* scene, const gphys_vec3* points, uint32_t point_stride,
                                       uint32_t count, float max_distance, uint32_t layers, gphys_nearest* out_nearest,
                                       uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        const Workers& workers = unwrap(scene)->workers();
        GPHYS_TRY(check_inputs(workers, points, "point_stride", point_stride, count));
        GPHYS_REQUIRE(valid_max_distance(max_distance), "max_distance: must be 0 or more and not NaN");
        GPHYS_TRY(check_outputs(out_nearest, out_stride, count));
        const Strided<gphys_vec3> point(points, point_stride);
        const StridedOut<gphys_nearest> out(out_nearest, out_stride);
        answer_each(workers, count, [&](uint32_t i) {
            gphys_nearest nearest = no_nearest;
            unwrap(scene)->nearest(widen(point[i]), max_distance, layers, nearest);
            out[i] = nearest;
        });
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_sweep_sphere(const gphys_scene* scene, const gphys_sphere* sphere,
                                      const gphys_vec3* displacement, uint32_t layers, gphys_hit* out_hit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        GPHYS_REQUIRE(sphere, "sphere is null");
        GPHYS_REQUIRE_VALID(*sphere);
        GPHYS_REQUIRE(displacement, "displacement is null");
        GPHYS_REQUIRE_VALID(*displacement);
        GPHYS_REQUIRE(out_hit, "out_hit is null");
        return unwrap(scene)->sweep(widen(*sphere), widen(*displacement), layers, *out_hit);
    });
}

gphys_status gphys_scene_sweep_sphere_batch(const gphys_scene* scene, const gphys_sphere* spheres,
                                            uint32_t sphere_stride, const gphys_vec3* displacements,
                                            uint32_t displacement_stride, uint32_t count, uint32_t layers,
                                            gphys_hit* out_hits, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        const Workers& workers = unwrap(scene)->workers();
        GPHYS_TRY(check_inputs(workers, spheres, "sphere_stride", sphere_stride, count));
        GPHYS_TRY(check_inputs(workers, displacements, "displacement_stride", displacement_stride, count));
        GPHYS_TRY(check_outputs(out_hits, out_stride, count));
        const Strided<gphys_sphere> sphere(spheres, sphere_stride);
        const Strided<gphys_vec3> displacement(displacements, displacement_stride);
        const StridedOut<gphys_hit> out(out_hits, out_stride);
        answer_each(workers, count, [&](uint32_t i) {
            gphys_hit hit = no_hit;
            unwrap(scene)->sweep(widen(sphere[i]), widen(displacement[i]), layers, hit);
            out[i] = hit;
        });
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_sweep(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                               const gphys_vec3* displacement, uint32_t layers, gphys_hit* out_hit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        Shape moving;
        GPHYS_TRY(read_moving(type, shape, moving));
        GPHYS_REQUIRE(displacement, "displacement is null");
        GPHYS_REQUIRE_VALID(*displacement);
        GPHYS_REQUIRE(out_hit, "out_hit is null");
        return unwrap(scene)->sweep(moving, widen(*displacement), layers, *out_hit);
    });
}

gphys_status gphys_scene_sweep_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                     uint32_t shape_stride, const gphys_vec3* displacements,
                                     uint32_t displacement_stride, uint32_t count, uint32_t layers, gphys_hit* out_hits,
                                     uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        const Workers& workers = unwrap(scene)->workers();
        GPHYS_TRY(check_moving(workers, type, shapes, shape_stride, count));
        GPHYS_TRY(check_inputs(workers, displacements, "displacement_stride", displacement_stride, count));
        GPHYS_TRY(check_outputs(out_hits, out_stride, count));
        const Strided<char> shape(static_cast<const char*>(shapes), shape_stride);
        const Strided<gphys_vec3> displacement(displacements, displacement_stride);
        const StridedOut<gphys_hit> out(out_hits, out_stride);
        answer_each(workers, count, [&](uint32_t i) {
            gphys_hit hit = no_hit;
            Shape moving;
            // It has been checked; if the caller has spoiled it since then, nothing is touched.
            if (read_moving(type, &shape[i], moving) == GPHYS_OK) {
                unwrap(scene)->sweep(moving, widen(displacement[i]), layers, hit);
            }
            out[i] = hit;
        });
        return GPHYS_OK;
    });
}

gphys_status gphys_scene_penetration(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                     uint32_t layers, gphys_penetration* out_penetrations, uint32_t capacity,
                                     uint32_t* out_total) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(scene, "scene is null");
        Shape moving;
        GPHYS_TRY(read_moving(type, shape, moving));
        GPHYS_TRY(check_list(out_penetrations, capacity, out_total));
        Smallest<gphys_penetration, DeepestFirst> deepest(out_penetrations, capacity);
        unwrap(scene)->penetration(moving, layers, deepest);
        return listed(deepest.finish(), capacity, out_total);
    });
}

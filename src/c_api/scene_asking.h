// What the plain queries of a scene and those with a filter share: checks, and the call. Who is what models are seen
// by: uint32_t, for layers, or QueryFilter; in batches uint32_t or Filters.
#pragma once

#include "c_api/api.h"
#include "c_api/batch.h"
#include "c_api/handles.h"
#include "c_api/lists.h"
#include "c_api/query_filters.h"
#include "c_api/shape_input.h"
#include "foundation/compiler.h"
#include "scene/scene.h"

namespace gphys {

inline uint32_t filter_of(uint32_t layers, uint32_t, QueryFilter&) { return layers; }
inline const QueryFilter& filter_of(const Filters& filters, uint32_t item, QueryFilter& room) {
    return filters.of(item, room);
}
inline uint32_t layers_of(uint32_t layers) { return layers; }
inline uint32_t layers_of(const QueryFilter& filter) { return filter.layers; }

inline gphys_status check_filters(const Workers&, uint32_t, uint32_t) { return GPHYS_OK; }
inline gphys_status check_filters(const Workers& workers, const Filters& filters, uint32_t count) {
    if (filters.is_one()) return GPHYS_OK;
    return check_each(workers, count, [&](uint32_t i) { return filters.check(i); });
}

/// ask(QueryFilter)
template <class Ask>
gphys_status by_filter(const gphys_scene* scene, const gphys_query_filter_desc* filter, const Ask& ask) {
    GPHYS_REQUIRE(scene, "scene is null");
    QueryFilter known;
    GPHYS_TRY(read_filter(*unwrap(scene), filter, known));
    return ask(known);
}
/// ask(Filters), which checks those of single items.
template <class Ask>
gphys_status by_filters(const gphys_scene* scene, const gphys_query_filter_desc* filters, uint32_t stride,
                        const Ask& ask) {
    GPHYS_REQUIRE(scene, "scene is null");
    Filters known;
    GPHYS_TRY(known.read(*unwrap(scene), filters, stride));
    return ask(known);
}

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

inline gphys_status check_concatenation(const void* out, uint32_t capacity, const uint32_t* out_offsets) {
    GPHYS_REQUIRE(capacity == 0 || out, "the output array is null");
    GPHYS_REQUIRE(out_offsets, "out_offsets is null");
    return GPHYS_OK;
}

/// The overlaps of shapes first .. first + count - 1, at most OverlapItems::most_queries; by list_of(i, add_all) as in
/// concatenate.
template <class Who, class ListOf>
void list_overlaps(const Scene& scene, gphys_shape_type type, const Strided<char>& shapes, uint32_t first,
                   uint32_t count, const Who& who, const ListOf& list_of) {
    Shape queries[OverlapItems::most_queries];
    OverlapItems met[OverlapItems::most_queries];
    // They have been checked; if the caller has spoiled one since then, nothing is found, but all lists are there.
    bool valid = true;
    for (uint32_t k = 0; k < count; ++k) valid &= read_shape(type, &shapes[first + k], queries[k]) == GPHYS_OK;
    QueryFilter room;
    // Where filters differ in their layers, those of the first say what is fetched ahead; no answer depends on it.
    if (valid) scene.meet(queries, count, layers_of(filter_of(who, first, room)), met);
    for (uint32_t k = 0; k < count; ++k) {
        list_of(first + k, [&](auto& models) {
            if (valid) scene.overlap(queries[k], filter_of(who, first + k, room), models, met + k);
        });
    }
}

inline bool valid_max_distance(float distance) { return distance >= 0; }

template <class Who>
gphys_status ask_raycast(const gphys_scene* scene, const gphys_ray* ray, const Who& who, gphys_hit* out_hit) {
    GPHYS_REQUIRE(scene, "scene is null");
    GPHYS_REQUIRE(ray, "ray is null");
    GPHYS_REQUIRE_VALID(*ray);
    GPHYS_REQUIRE(out_hit, "out_hit is null");
    return unwrap(scene)->raycast(widen(*ray), who, *out_hit);
}

template <class Who>
gphys_status ask_raycast_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride, uint32_t count,
                               const Who& who, gphys_hit* out_hits, uint32_t out_stride) {
    GPHYS_REQUIRE(scene, "scene is null");
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_filters(workers, who, count));
    GPHYS_TRY(check_inputs(workers, rays, "ray_stride", ray_stride, count));
    GPHYS_TRY(check_outputs(out_hits, out_stride, count));
    const Strided<gphys_ray> ray(rays, ray_stride);
    const StridedOut<gphys_hit> out(out_hits, out_stride);
    raycast_each(*unwrap(scene), ray, ray_coordinates, count, who, out, [](const gphys_ray& given, Ray& r) {
        r = widen(given);
        return true;
    });
    return GPHYS_OK;
}

template <class Who>
gphys_status ask_raycast_any(const gphys_scene* scene, const gphys_ray* ray, const Who& who, int32_t* out_hit) {
    GPHYS_REQUIRE(scene, "scene is null");
    GPHYS_REQUIRE(ray, "ray is null");
    GPHYS_REQUIRE_VALID(*ray);
    GPHYS_REQUIRE(out_hit, "out_hit is null");
    *out_hit = unwrap(scene)->raycast_any(widen(*ray), who);
    return GPHYS_OK;
}

template <class Who>
gphys_status ask_raycast_any_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride, uint32_t count,
                                   const Who& who, int32_t* out_hits, uint32_t out_stride) {
    GPHYS_REQUIRE(scene, "scene is null");
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_filters(workers, who, count));
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
                      cast_by(who, items, size, [&](uint32_t first, uint32_t some, const auto& by) {
                          const uint64_t met = unwrap(scene)->raycast_any_many(tile + first, some, by);
                          for (uint32_t k = 0; k < some; ++k) {
                              out[items[first + k]] = static_cast<int32_t>(met >> k & 1);
                          }
                      });
                  });
    return GPHYS_OK;
}

template <class Who>
gphys_status ask_raycast_all(const gphys_scene* scene, const gphys_ray* ray, const Who& who, gphys_hit* out_hits,
                             uint32_t capacity, uint32_t* out_total) {
    GPHYS_REQUIRE(scene, "scene is null");
    GPHYS_REQUIRE(ray, "ray is null");
    GPHYS_REQUIRE_VALID(*ray);
    GPHYS_TRY(check_list(out_hits, capacity, out_total));
    Smallest<gphys_hit, FirstHit> hits(out_hits, capacity);
    unwrap(scene)->raycast_all(widen(*ray), who, hits);
    return listed(hits.finish(), capacity, out_total);
}

template <class Who>
gphys_status ask_raycast_all_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride, uint32_t count,
                                   const Who& who, gphys_hit* out_hits, uint32_t capacity, uint32_t* out_offsets) {
    GPHYS_REQUIRE(scene, "scene is null");
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_filters(workers, who, count));
    GPHYS_TRY(check_inputs(workers, rays, "ray_stride", ray_stride, count));
    GPHYS_TRY(check_concatenation(out_hits, capacity, out_offsets));
    const Strided<gphys_ray> ray(rays, ray_stride);
    return concatenate<gphys_hit, FirstHit>(
        workers, out_hits, capacity, count, out_offsets, [&](uint32_t begin, uint32_t end, const auto& list_of) {
            QueryFilter room;
            for (uint32_t i = begin; i < end; ++i) {
                list_of(i,
                        [&](auto& hits) { unwrap(scene)->raycast_all(widen(ray[i]), filter_of(who, i, room), hits); });
            }
        });
}

template <class Who>
gphys_status ask_segment_test(const gphys_scene* scene, const gphys_segment* segment, const Who& who,
                              gphys_hit* out_hit) {
    GPHYS_REQUIRE(scene, "scene is null");
    GPHYS_REQUIRE(segment, "segment is null");
    GPHYS_REQUIRE_VALID(*segment);
    GPHYS_REQUIRE(out_hit, "out_hit is null");
    return unwrap(scene)->raycast(ray_along(widen(*segment)), who, *out_hit);
}

template <class Who>
gphys_status ask_segment_test_batch(const gphys_scene* scene, const gphys_segment* segments, uint32_t segment_stride,
                                    uint32_t count, const Who& who, gphys_hit* out_hits, uint32_t out_stride) {
    GPHYS_REQUIRE(scene, "scene is null");
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_filters(workers, who, count));
    GPHYS_TRY(check_inputs(workers, segments, "segment_stride", segment_stride, count));
    GPHYS_TRY(check_outputs(out_hits, out_stride, count));
    const Strided<gphys_segment> segment(segments, segment_stride);
    const StridedOut<gphys_hit> out(out_hits, out_stride);
    raycast_each(*unwrap(scene), segment, ray_coordinates, count, who, out, [](const gphys_segment& given, Ray& ray) {
        ray = ray_along(widen(given));
        return true;
    });
    return GPHYS_OK;
}

template <class Who>
gphys_status ask_overlap(const gphys_scene* scene, gphys_shape_type type, const void* shape, const Who& who,
                         gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    GPHYS_REQUIRE(scene, "scene is null");
    Shape query;
    GPHYS_TRY(read_shape(type, shape, query));
    GPHYS_TRY(check_list(out_models, capacity, out_total));
    Smallest<gphys_model_id> models(out_models, capacity);
    unwrap(scene)->overlap(query, who, models);
    return listed(models.finish(), capacity, out_total);
}

template <class Who>
gphys_status ask_overlap_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                               uint32_t shape_stride, uint32_t count, const Who& who, gphys_model_id* out_models,
                               uint32_t capacity, uint32_t* out_offsets) {
    GPHYS_REQUIRE(scene, "scene is null");
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_filters(workers, who, count));
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
                list_overlaps(*unwrap(scene), type, shape, first, size, who, list_of);
            }
        });
}

template <class Who>
gphys_status ask_cull(const gphys_scene* scene, const gphys_frustum* frustum, const Who& who,
                      gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    GPHYS_REQUIRE(scene, "scene is null");
    GPHYS_REQUIRE(frustum, "frustum is null");
    GPHYS_REQUIRE_VALID(*frustum);
    GPHYS_TRY(check_list(out_models, capacity, out_total));
    const uint32_t total = unwrap(scene)->cull(widen(*frustum), who, out_models, capacity);
    return listed(total, capacity, out_total);
}

template <class Who>
gphys_status ask_nearest(const gphys_scene* scene, const gphys_vec3* point, float max_distance, const Who& who,
                         gphys_nearest* out_nearest) {
    GPHYS_REQUIRE(scene, "scene is null");
    GPHYS_REQUIRE(point, "point is null");
    GPHYS_REQUIRE_VALID(*point);
    GPHYS_REQUIRE(valid_max_distance(max_distance), "max_distance: must be 0 or more and not NaN");
    GPHYS_REQUIRE(out_nearest, "out_nearest is null");
    return unwrap(scene)->nearest(widen(*point), max_distance, who, *out_nearest);
}

template <class Who>
gphys_status ask_nearest_batch(const gphys_scene* scene, const gphys_vec3* points, uint32_t point_stride,
                               uint32_t count, float max_distance, const Who& who, gphys_nearest* out_nearest,
                               uint32_t out_stride) {
    GPHYS_REQUIRE(scene, "scene is null");
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_filters(workers, who, count));
    GPHYS_TRY(check_inputs(workers, points, "point_stride", point_stride, count));
    GPHYS_REQUIRE(valid_max_distance(max_distance), "max_distance: must be 0 or more and not NaN");
    GPHYS_TRY(check_outputs(out_nearest, out_stride, count));
    const Strided<gphys_vec3> point(points, point_stride);
    const StridedOut<gphys_nearest> out(out_nearest, out_stride);
    answer_each(workers, count, [&](uint32_t i) {
        QueryFilter room;
        gphys_nearest nearest = no_nearest;
        unwrap(scene)->nearest(widen(point[i]), max_distance, filter_of(who, i, room), nearest);
        out[i] = nearest;
    });
    return GPHYS_OK;
}

template <class Who>
gphys_status ask_sweep_sphere(const gphys_scene* scene, const gphys_sphere* sphere, const gphys_vec3* displacement,
                              const Who& who, gphys_hit* out_hit) {
    GPHYS_REQUIRE(scene, "scene is null");
    GPHYS_REQUIRE(sphere, "sphere is null");
    GPHYS_REQUIRE_VALID(*sphere);
    GPHYS_REQUIRE(displacement, "displacement is null");
    GPHYS_REQUIRE_VALID(*displacement);
    GPHYS_REQUIRE(out_hit, "out_hit is null");
    return unwrap(scene)->sweep(widen(*sphere), widen(*displacement), who, *out_hit);
}

template <class Who>
gphys_status ask_sweep_sphere_batch(const gphys_scene* scene, const gphys_sphere* spheres, uint32_t sphere_stride,
                                    const gphys_vec3* displacements, uint32_t displacement_stride, uint32_t count,
                                    const Who& who, gphys_hit* out_hits, uint32_t out_stride) {
    GPHYS_REQUIRE(scene, "scene is null");
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_filters(workers, who, count));
    GPHYS_TRY(check_inputs(workers, spheres, "sphere_stride", sphere_stride, count));
    GPHYS_TRY(check_inputs(workers, displacements, "displacement_stride", displacement_stride, count));
    GPHYS_TRY(check_outputs(out_hits, out_stride, count));
    const Strided<gphys_sphere> sphere(spheres, sphere_stride);
    const Strided<gphys_vec3> displacement(displacements, displacement_stride);
    const StridedOut<gphys_hit> out(out_hits, out_stride);
    answer_each(workers, count, [&](uint32_t i) {
        QueryFilter room;
        gphys_hit hit = no_hit;
        unwrap(scene)->sweep(widen(sphere[i]), widen(displacement[i]), filter_of(who, i, room), hit);
        out[i] = hit;
    });
    return GPHYS_OK;
}

}  // namespace gphys

// The queries of a scene, shared by the plain ones and those with a filter: argument checks and the call. What is
// `given` as a filter is uint32_t, for layers, or a desc; in batches uint32_t or a FilterArray (query_filters.h).
#pragma once

#include <type_traits>

#include "c_api/batch.h"
#include "c_api/lists.h"
#include "c_api/query_filters.h"
#include "c_api/shape_input.h"
#include "foundation/compiler.h"
#include "scene/scene.h"

namespace gphys {

inline uint32_t filter_of(uint32_t layers, uint32_t, QueryFilter&) { return layers; }
inline const QueryFilter& filter_of(const Filters& filters, uint32_t item, QueryFilter& storage) {
    return filters.of(item, storage);
}
inline uint32_t layers_of(uint32_t layers) { return layers; }
inline uint32_t layers_of(const QueryFilter& filter) { return filter.layers; }

// The filters of a batch, and the check of those of single items.
inline gphys_status read_filters(const gphys_scene* scene, uint32_t layers, uint32_t, uint32_t& out) {
    return read_filter(scene, layers, out);
}
inline gphys_status read_filters(const gphys_scene* scene, const FilterArray& given, uint32_t count, Filters& out) {
    GPHYS_TRY(out.read(scene, given.descs, given.stride, count));
    if (out.is_one()) return GPHYS_OK;
    return check_each(unwrap(scene)->workers(), count, [&](uint32_t i) { return out.check(i); });
}

/// The input array of a batch: the pointer, the stride and each element.
template <class T>
gphys_status check_inputs(const Workers& workers, const char* name, const T* inputs, const char* stride_name,
                          uint32_t stride, uint32_t count) {
    if (count != 0) GPHYS_TRY(check_pointers(name, inputs));
    GPHYS_TRY(check_stride(stride_name, stride, sizeof(T), count));
    const Strided<T> input(inputs, stride);
    return check_each(workers, distinct(stride, count), [&](uint32_t i) { return check_element(name, i, input[i]); });
}

inline gphys_status check_concatenation(const char* name, const void* out, uint32_t capacity,
                                        const uint32_t* out_offsets) {
    if (capacity != 0) GPHYS_TRY(check_pointers(name, out));
    GPHYS_REQUIRE_POINTERS(out_offsets);
    return GPHYS_OK;
}

/// The overlaps of shapes first .. first + count - 1, at most OverlapItems::max_queries: one traversal finds the
/// candidates of all, then each shape tests its own. list_of(i, list) as in concatenate.
template <class Filter, class ListOf>
void list_overlaps(const Scene& scene, gphys_shape_type type, const Strided<char>& shapes, uint32_t first,
                   uint32_t count, const Filter& filter, const ListOf& list_of) {
    Shape queries[OverlapItems::max_queries];
    OverlapItems candidates[OverlapItems::max_queries];
    // Valid when they were checked. If another thread has made one invalid since, all lists are empty.
    bool valid = true;
    for (uint32_t k = 0; k < count; ++k) valid &= read_shape(type, &shapes[first + k], queries[k]) == GPHYS_OK;
    QueryFilter storage;
    // The layers only select what is prefetched, so those of the first filter suffice.
    if (valid) scene.find_candidates(queries, count, layers_of(filter_of(filter, first, storage)), candidates);
    for (uint32_t k = 0; k < count; ++k) {
        list_of(first + k, [&](gphys_model_id* out, uint32_t room) {
            if (!valid) return uint32_t{0};
            return scene.overlap(queries[k], filter_of(filter, first + k, storage), out, room, candidates + k);
        });
    }
}

inline gphys_status check_max_distance(float max_distance) {
    GPHYS_REQUIRE_IN_RANGE(max_distance >= 0, "max_distance", max_distance, "0 or more");
    return GPHYS_OK;
}

inline Ray ray_of(const gphys_ray& ray) { return widen(ray); }
inline Ray ray_of(const gphys_segment& segment) { return ray_along(widen(segment)); }

/// Line is gphys_ray or gphys_segment.
template <class Line, class Given>
gphys_status scene_raycast(const gphys_scene* scene, const char* name, const Line* line, const Given& given,
                           gphys_hit* out_hit) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_TRY(check_input(name, line));
    GPHYS_REQUIRE_POINTERS(out_hit);
    return unwrap(scene)->raycast(ray_of(*line), filter, *out_hit);
}

/// Answer is gphys_hit or gphys_distance.
template <class Line, class Given, class Answer>
gphys_status scene_raycast_batch(const gphys_scene* scene, const char* name, const Line* lines, const char* stride_name,
                                 uint32_t stride, uint32_t count, const Given& given, Answer* out_answers,
                                 uint32_t out_stride) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_inputs(workers, name, lines, stride_name, stride, count));
    GPHYS_TRY(check_outputs(std::is_same_v<Answer, gphys_hit> ? "out_hits" : "out_distances", out_answers, out_stride,
                            count));
    const Strided<Line> line(lines, stride);
    const StridedOut<Answer> out(out_answers, out_stride);
    raycast_each(*unwrap(scene), line, ray_coordinates, count, filter, out, [](const Line& from, Ray& ray) {
        ray = ray_of(from);
        return true;
    });
    return GPHYS_OK;
}

template <class Given>
gphys_status scene_raycast_any(const gphys_scene* scene, const gphys_ray* ray, const Given& given, int32_t* out_hit) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_REQUIRE_INPUT(ray);
    GPHYS_REQUIRE_POINTERS(out_hit);
    *out_hit = unwrap(scene)->raycast_any(widen(*ray), filter);
    return GPHYS_OK;
}

template <class Given>
gphys_status scene_raycast_any_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                     uint32_t count, const Given& given, int32_t* out_hits, uint32_t out_stride) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_inputs(workers, "rays", rays, "ray_stride", ray_stride, count));
    GPHYS_TRY(check_outputs("out_hits", out_hits, out_stride, count));
    const Strided<gphys_ray> ray(rays, ray_stride);
    const StridedOut<int32_t> out(out_hits, out_stride);
    const auto ray_of = [&](uint32_t i, Ray& r) {
        r = widen(ray[i]);
        return true;
    };
    const ImageTiles tiles(ray.beginnings<float>(), ray_coordinates, count);
    cast_by_tiles(*unwrap(scene), tiles, ray_of, prefetch_elements(ray, out),
                  [&](Ray* tile, const uint32_t* items, uint32_t size) {
                      query_by(filter, items, size, [&](uint32_t first, uint32_t some, const auto& by) {
                          const uint64_t hit_mask = unwrap(scene)->raycast_any_many(tile + first, some, by);
                          for (uint32_t k = 0; k < some; ++k) {
                              out[items[first + k]] = static_cast<int32_t>(hit_mask >> k & 1);
                          }
                      });
                  });
    return GPHYS_OK;
}

template <class Given>
gphys_status scene_raycast_all(const gphys_scene* scene, const gphys_ray* ray, const Given& given, gphys_hit* out_hits,
                               uint32_t capacity, uint32_t* out_total) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_REQUIRE_INPUT(ray);
    return list_smallest<FirstHit>("out_hits", out_hits, capacity, out_total,
                                   [&](auto& hits) { unwrap(scene)->raycast_all(widen(*ray), filter, hits); });
}

template <class Given>
gphys_status scene_raycast_all_batch(const gphys_scene* scene, const gphys_ray* rays, uint32_t ray_stride,
                                     uint32_t count, const Given& given, gphys_hit* out_hits, uint32_t capacity,
                                     uint32_t* out_offsets) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_inputs(workers, "rays", rays, "ray_stride", ray_stride, count));
    GPHYS_TRY(check_concatenation("out_hits", out_hits, capacity, out_offsets));
    const Strided<gphys_ray> ray(rays, ray_stride);
    return concatenate(workers, batch_chunk, out_hits, capacity, count, out_offsets,
                       [&](uint32_t begin, uint32_t end, const auto& list_of) {
                           QueryFilter storage;
                           for (uint32_t i = begin; i < end; ++i) {
                               const auto add_all = [&](auto& hits) {
                                   unwrap(scene)->raycast_all(widen(ray[i]), filter_of(filter, i, storage), hits);
                               };
                               list_of(i, smallest_of<gphys_hit, FirstHit>(add_all));
                           }
                       });
}

template <class Given>
gphys_status scene_overlap(const gphys_scene* scene, gphys_shape_type type, const void* shape, const Given& given,
                           gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    Shape query;
    GPHYS_TRY(read_shape(type, shape, query));
    GPHYS_TRY(check_list("out_models", out_models, capacity, out_total));
    return listed(unwrap(scene)->overlap(query, filter, out_models, capacity), capacity, out_total);
}

template <class Given>
gphys_status scene_overlap_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                 uint32_t shape_stride, uint32_t count, const Given& given, gphys_model_id* out_models,
                                 uint32_t capacity, uint32_t* out_offsets) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_stride("shape_stride", shape_stride, shape_struct_size(type), count));
    const Strided<char> shape(static_cast<const char*>(shapes), shape_stride);
    GPHYS_TRY(check_each(workers, distinct(shape_stride, count), [&](uint32_t i) {
        Shape query;
        return read_shape(type, shapes ? &shape[i] : nullptr, query);
    }));
    GPHYS_TRY(check_concatenation("out_models", out_models, capacity, out_offsets));
    return concatenate(workers, batch_chunk, out_models, capacity, count, out_offsets,
                       [&](uint32_t begin, uint32_t end, const auto& list_of) {
                           for (uint32_t first = begin; first < end; first += OverlapItems::max_queries) {
                               const uint32_t size = std::min(end - first, OverlapItems::max_queries);
                               list_overlaps(*unwrap(scene), type, shape, first, size, filter, list_of);
                           }
                       });
}

template <class Given>
gphys_status scene_cull(const gphys_scene* scene, const gphys_frustum* frustum, const Given& given,
                        gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_REQUIRE_INPUT(frustum);
    GPHYS_TRY(check_list("out_models", out_models, capacity, out_total));
    return listed(unwrap(scene)->cull(widen(*frustum), filter, out_models, capacity), capacity, out_total);
}

template <class Given>
gphys_status scene_cull_batch(const gphys_scene* scene, const gphys_frustum* frusta, uint32_t frustum_stride,
                              uint32_t count, const Given& given, gphys_model_id* out_models, uint32_t capacity,
                              uint32_t* out_offsets) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_inputs(workers, "frusta", frusta, "frustum_stride", frustum_stride, count));
    GPHYS_TRY(check_concatenation("out_models", out_models, capacity, out_offsets));
    const Strided<gphys_frustum> frustum(frusta, frustum_stride);
    // One view takes as long as hundreds of rays, and there are few.
    constexpr uint32_t chunk_size = 1;
    return concatenate(workers, chunk_size, out_models, capacity, count, out_offsets,
                       [&](uint32_t begin, uint32_t end, const auto& list_of) {
                           QueryFilter storage;
                           for (uint32_t i = begin; i < end; ++i) {
                               list_of(i, [&](gphys_model_id* out, uint32_t room) {
                                   return unwrap(scene)->cull(widen(frustum[i]), filter_of(filter, i, storage), out,
                                                              room);
                               });
                           }
                       });
}

template <class Given>
gphys_status scene_nearest(const gphys_scene* scene, const gphys_vec3* point, float max_distance, const Given& given,
                           gphys_nearest* out_nearest) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_REQUIRE_INPUT(point);
    GPHYS_TRY(check_max_distance(max_distance));
    GPHYS_REQUIRE_POINTERS(out_nearest);
    return unwrap(scene)->nearest(widen(*point), max_distance, filter, *out_nearest);
}

template <class Given>
gphys_status scene_nearest_batch(const gphys_scene* scene, const gphys_vec3* points, uint32_t point_stride,
                                 uint32_t count, float max_distance, const Given& given, gphys_nearest* out_nearest,
                                 uint32_t out_stride) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_inputs(workers, "points", points, "point_stride", point_stride, count));
    GPHYS_TRY(check_max_distance(max_distance));
    GPHYS_TRY(check_outputs("out_nearest", out_nearest, out_stride, count));
    const Strided<gphys_vec3> point(points, point_stride);
    const StridedOut<gphys_nearest> out(out_nearest, out_stride);
    constexpr uint32_t at_once = Scene::points_at_once;
    for_each_chunk(workers, count, batch_chunk, [&](uint32_t begin, uint32_t end) {
        for (uint32_t first = begin; first < end; first += at_once) {
            const uint32_t size = std::min(at_once, end - first);
            Vec3 from[at_once];
            uint32_t items[at_once];
            gphys_nearest found[at_once];
            for (uint32_t k = 0; k < size; ++k) {
                from[k] = widen(point[first + k]);
                items[k] = first + k;
                found[k] = no_nearest;
            }
            query_by(filter, items, size, [&](uint32_t part, uint32_t some, const auto& by) {
                unwrap(scene)->nearest_many(from + part, some, max_distance, by, found + part);
            });
            for (uint32_t k = 0; k < size; ++k) out[first + k] = found[k];
        }
    });
    return GPHYS_OK;
}

template <class Given>
gphys_status scene_sweep_sphere(const gphys_scene* scene, const gphys_sphere* sphere, const gphys_vec3* displacement,
                                const Given& given, gphys_hit* out_hit) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_REQUIRE_INPUT(sphere);
    GPHYS_REQUIRE_INPUT(displacement);
    GPHYS_REQUIRE_POINTERS(out_hit);
    return unwrap(scene)->sweep(widen(*sphere), widen(*displacement), filter, *out_hit);
}

template <class Given>
gphys_status scene_sweep_sphere_batch(const gphys_scene* scene, const gphys_sphere* spheres, uint32_t sphere_stride,
                                      const gphys_vec3* displacements, uint32_t displacement_stride, uint32_t count,
                                      const Given& given, gphys_hit* out_hits, uint32_t out_stride) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_inputs(workers, "spheres", spheres, "sphere_stride", sphere_stride, count));
    GPHYS_TRY(check_inputs(workers, "displacements", displacements, "displacement_stride", displacement_stride, count));
    GPHYS_TRY(check_outputs("out_hits", out_hits, out_stride, count));
    const Strided<gphys_sphere> sphere(spheres, sphere_stride);
    const Strided<gphys_vec3> displacement(displacements, displacement_stride);
    const StridedOut<gphys_hit> out(out_hits, out_stride);
    for_each_item(workers, count, [&](uint32_t i) {
        QueryFilter storage;
        gphys_hit hit = no_hit;
        unwrap(scene)->sweep(widen(sphere[i]), widen(displacement[i]), filter_of(filter, i, storage), hit);
        out[i] = hit;
    });
    return GPHYS_OK;
}

}  // namespace gphys

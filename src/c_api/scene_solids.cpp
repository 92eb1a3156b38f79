// gphys_scene_sweep, gphys_scene_penetration, their batches and filtered forms: solids that move in a scene.
#include "c_api/scene_query.h"

using namespace gphys;

namespace {

/// The input array of a batch of moving shapes.
gphys_status check_moving(const Workers& workers, gphys_shape_type type, const void* shapes, uint32_t stride,
                          uint32_t count) {
    GPHYS_TRY(check_stride("shape_stride", stride, shape_struct_size(type), count));
    const Strided<char> shape(static_cast<const char*>(shapes), stride);
    return check_each(workers, distinct(stride, count), [&](uint32_t i) {
        Shape moving;
        return read_moving(type, shapes ? &shape[i] : nullptr, moving);
    });
}

template <class Given>
gphys_status scene_sweep(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                         const gphys_vec3* displacement, const Given& given, gphys_hit* out_hit) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    Shape moving;
    GPHYS_TRY(read_moving(type, shape, moving));
    GPHYS_REQUIRE_INPUT(displacement);
    GPHYS_REQUIRE_POINTERS(out_hit);
    return unwrap(scene)->sweep(moving, widen(*displacement), filter, *out_hit);
}

template <class Given>
gphys_status scene_sweep_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                               uint32_t shape_stride, const gphys_vec3* displacements, uint32_t displacement_stride,
                               uint32_t count, const Given& given, gphys_hit* out_hits, uint32_t out_stride) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_moving(workers, type, shapes, shape_stride, count));
    GPHYS_TRY(check_inputs(workers, "displacements", displacements, "displacement_stride", displacement_stride, count));
    GPHYS_TRY(check_outputs("out_hits", out_hits, out_stride, count));
    const Strided<char> shape(static_cast<const char*>(shapes), shape_stride);
    const Strided<gphys_vec3> displacement(displacements, displacement_stride);
    const StridedOut<gphys_hit> out(out_hits, out_stride);
    for_each_item(workers, count, [&](uint32_t i) {
        QueryFilter storage;
        gphys_hit hit = no_hit;
        Shape moving;
        // Valid when it was checked. If another thread has made it invalid since, the result is a miss.
        if (read_moving(type, &shape[i], moving) == GPHYS_OK) {
            unwrap(scene)->sweep(moving, widen(displacement[i]), filter_of(filter, i, storage), hit);
        }
        out[i] = hit;
    });
    return GPHYS_OK;
}

template <class Given>
gphys_status scene_penetration(const gphys_scene* scene, gphys_shape_type type, const void* shape, const Given& given,
                               gphys_penetration* out_penetrations, uint32_t capacity, uint32_t* out_total) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    Shape moving;
    GPHYS_TRY(read_moving(type, shape, moving));
    GPHYS_TRY(check_list("out_penetrations", out_penetrations, capacity, out_total));
    DeepestPenetrations deepest(out_penetrations, capacity);
    unwrap(scene)->penetration(moving, filter, deepest);
    return listed(deepest.finish(), capacity, out_total);
}

template <class Given>
gphys_status scene_penetration_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                     uint32_t shape_stride, uint32_t count, const Given& given,
                                     gphys_penetration* out_penetrations, uint32_t capacity, uint32_t* out_offsets) {
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_moving(workers, type, shapes, shape_stride, count));
    GPHYS_TRY(check_concatenation("out_penetrations", out_penetrations, capacity, out_offsets));
    const Strided<char> shape(static_cast<const char*>(shapes), shape_stride);
    return concatenate(workers, batch_chunk, out_penetrations, capacity, count, out_offsets,
                       [&](uint32_t begin, uint32_t end, const auto& list_of) {
                           for (uint32_t i = begin; i < end; ++i) {
                               const auto add_all = [&](DeepestPenetrations& deepest) {
                                   QueryFilter storage;
                                   Shape moving;
                                   // Valid when it was checked. If another thread has made it invalid since, it
                                   // overlaps nothing.
                                   if (read_moving(type, &shape[i], moving) != GPHYS_OK) return;
                                   unwrap(scene)->penetration(moving, filter_of(filter, i, storage), deepest);
                               };
                               list_of(i, smallest_of<gphys_penetration, DeepestFirst>(add_all));
                           }
                       });
}

}  // namespace

gphys_status gphys_scene_sweep(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                               const gphys_vec3* displacement, uint32_t layers, gphys_hit* out_hit) {
    return guarded(__func__, [&] { return scene_sweep(scene, type, shape, displacement, layers, out_hit); });
}

gphys_status gphys_scene_sweep_filtered(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                        const gphys_vec3* displacement, const gphys_query_filter_desc* filter,
                                        gphys_hit* out_hit) {
    return guarded(__func__, [&] { return scene_sweep(scene, type, shape, displacement, filter, out_hit); });
}

gphys_status gphys_scene_sweep_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                     uint32_t shape_stride, const gphys_vec3* displacements,
                                     uint32_t displacement_stride, uint32_t count, uint32_t layers, gphys_hit* out_hits,
                                     uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_sweep_batch(scene, type, shapes, shape_stride, displacements, displacement_stride, count, layers,
                                 out_hits, out_stride);
    });
}

gphys_status gphys_scene_sweep_filtered_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                              uint32_t shape_stride, const gphys_vec3* displacements,
                                              uint32_t displacement_stride, uint32_t count,
                                              const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                              gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return scene_sweep_batch(scene, type, shapes, shape_stride, displacements, displacement_stride, count,
                                 FilterArray{filters, filter_stride}, out_hits, out_stride);
    });
}

gphys_status gphys_scene_penetration(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                     uint32_t layers, gphys_penetration* out_penetrations, uint32_t capacity,
                                     uint32_t* out_total) {
    return guarded(
        __func__, [&] { return scene_penetration(scene, type, shape, layers, out_penetrations, capacity, out_total); });
}

gphys_status gphys_scene_penetration_filtered(const gphys_scene* scene, gphys_shape_type type, const void* shape,
                                              const gphys_query_filter_desc* filter,
                                              gphys_penetration* out_penetrations, uint32_t capacity,
                                              uint32_t* out_total) {
    return guarded(
        __func__, [&] { return scene_penetration(scene, type, shape, filter, out_penetrations, capacity, out_total); });
}

gphys_status gphys_scene_penetration_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                           uint32_t shape_stride, uint32_t count, uint32_t layers,
                                           gphys_penetration* out_penetrations, uint32_t capacity,
                                           uint32_t* out_offsets) {
    return guarded(__func__, [&] {
        return scene_penetration_batch(scene, type, shapes, shape_stride, count, layers, out_penetrations, capacity,
                                       out_offsets);
    });
}

gphys_status gphys_scene_penetration_filtered_batch(const gphys_scene* scene, gphys_shape_type type, const void* shapes,
                                                    uint32_t shape_stride, uint32_t count,
                                                    const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                                    gphys_penetration* out_penetrations, uint32_t capacity,
                                                    uint32_t* out_offsets) {
    return guarded(__func__, [&] {
        return scene_penetration_batch(scene, type, shapes, shape_stride, count, FilterArray{filters, filter_stride},
                                       out_penetrations, capacity, out_offsets);
    });
}

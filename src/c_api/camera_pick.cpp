// gphys_camera_pick*, gphys_camera_cull*: queries of a scene with the rays and frusta of a camera.
#include "pick/pick.h"

#include "c_api/scene_query.h"

using namespace gphys;

namespace {

struct Pixel {
    float x, y;
};

/// Positions are relative to the origin of the object.
gphys_status check_origins(const gphys_camera* camera, const gphys_scene* scene) {
    GPHYS_REQUIRE(unwrap(camera)->origin() == unwrap(scene)->origin(), "camera, scene: their origins differ");
    return GPHYS_OK;
}

template <class Given>
gphys_status camera_pick(const gphys_camera* camera, const gphys_scene* scene, float pixel_x, float pixel_y,
                         const Given& given, gphys_hit* out_hit) {
    GPHYS_REQUIRE_POINTERS(camera, scene, out_hit);
    GPHYS_TRY(check_origins(camera, scene));
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_TRY(check_coordinate("pixel_x", pixel_x));
    GPHYS_TRY(check_coordinate("pixel_y", pixel_y));
    return pick(*unwrap(camera), *unwrap(scene), pixel_x, pixel_y, filter, *out_hit);
}

template <class Given>
gphys_status camera_pick_batch(const gphys_camera* camera, const gphys_scene* scene, const float* pixels,
                               uint32_t pixel_stride, uint32_t count, const Given& given, gphys_hit* out_hits,
                               uint32_t out_stride) {
    GPHYS_REQUIRE_POINTERS(camera, scene);
    GPHYS_TRY(check_origins(camera, scene));
    const Workers& workers = unwrap(scene)->workers();
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filters(scene, given, count, filter));
    if (count == 0) return GPHYS_OK;
    GPHYS_REQUIRE_POINTERS(pixels, out_hits);
    GPHYS_TRY(check_stride("pixel_stride", pixel_stride, sizeof(Pixel), count));
    GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof *out_hits, count));
    const Strided<Pixel> in(reinterpret_cast<const Pixel*>(pixels), pixel_stride);
    const StridedOut<gphys_hit> out(out_hits, out_stride);
    GPHYS_TRY(check_each(workers, distinct(pixel_stride, count), [&](uint32_t i) -> gphys_status {
        const Pixel pixel = in[i];
        if (is_coordinate(pixel.x) && is_coordinate(pixel.y)) return GPHYS_OK;
        return fail(GPHYS_ERROR_INVALID_ARGUMENT, "pixels", i,
                    is_coordinate(pixel.x) ? Defect{"", 'y', pixel.y, coordinate_range}
                                           : Defect{"", 'x', pixel.x, coordinate_range});
    }));
    raycast_each(*unwrap(scene), in, 2, count, filter, out,
                 [&](Pixel pixel, Ray& ray) { return unwrap(camera)->pick_ray(pixel.x, pixel.y, ray); });
    return GPHYS_OK;
}

template <class Given>
gphys_status camera_pick_rectangle(const gphys_camera* camera, const gphys_scene* scene, float x0, float y0, float x1,
                                   float y1, const Given& given, gphys_model_id* out_models, uint32_t capacity,
                                   uint32_t* out_total) {
    GPHYS_REQUIRE_POINTERS(camera, scene);
    GPHYS_TRY(check_origins(camera, scene));
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_TRY(check_rectangle(x0, y0, x1, y1));
    GPHYS_TRY(check_list("out_models", out_models, capacity, out_total));
    return listed(pick_rectangle(*unwrap(camera), *unwrap(scene), x0, y0, x1, y1, filter, out_models, capacity),
                  capacity, out_total);
}

template <class Given>
gphys_status camera_cull(const gphys_camera* camera, const gphys_scene* scene, const Given& given,
                         gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    GPHYS_REQUIRE_POINTERS(camera, scene);
    GPHYS_TRY(check_origins(camera, scene));
    FilterFrom<Given> filter;
    GPHYS_TRY(read_filter(scene, given, filter));
    GPHYS_TRY(check_list("out_models", out_models, capacity, out_total));
    return listed(cull(*unwrap(camera), *unwrap(scene), filter, out_models, capacity), capacity, out_total);
}

}  // namespace

gphys_status gphys_camera_pick(const gphys_camera* camera, const gphys_scene* scene, float pixel_x, float pixel_y,
                               uint32_t layers, gphys_hit* out_hit) {
    return guarded(__func__, [&] { return camera_pick(camera, scene, pixel_x, pixel_y, layers, out_hit); });
}

gphys_status gphys_camera_pick_batch(const gphys_camera* camera, const gphys_scene* scene, const float* pixels,
                                     uint32_t pixel_stride, uint32_t count, uint32_t layers, gphys_hit* out_hits,
                                     uint32_t out_stride) {
    return guarded(__func__, [&] {
        return camera_pick_batch(camera, scene, pixels, pixel_stride, count, layers, out_hits, out_stride);
    });
}

gphys_status gphys_camera_pick_rectangle(const gphys_camera* camera, const gphys_scene* scene, float x0, float y0,
                                         float x1, float y1, uint32_t layers, gphys_model_id* out_models,
                                         uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&] {
        return camera_pick_rectangle(camera, scene, x0, y0, x1, y1, layers, out_models, capacity, out_total);
    });
}

gphys_status gphys_camera_cull(const gphys_camera* camera, const gphys_scene* scene, uint32_t layers,
                               gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&] { return camera_cull(camera, scene, layers, out_models, capacity, out_total); });
}

gphys_status gphys_camera_pick_filtered(const gphys_camera* camera, const gphys_scene* scene, float pixel_x,
                                        float pixel_y, const gphys_query_filter_desc* filter, gphys_hit* out_hit) {
    return guarded(__func__, [&] { return camera_pick(camera, scene, pixel_x, pixel_y, filter, out_hit); });
}

gphys_status gphys_camera_pick_filtered_batch(const gphys_camera* camera, const gphys_scene* scene, const float* pixels,
                                              uint32_t pixel_stride, uint32_t count,
                                              const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                              gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return camera_pick_batch(camera, scene, pixels, pixel_stride, count, FilterArray{filters, filter_stride},
                                 out_hits, out_stride);
    });
}

gphys_status gphys_camera_pick_rectangle_filtered(const gphys_camera* camera, const gphys_scene* scene, float x0,
                                                  float y0, float x1, float y1, const gphys_query_filter_desc* filter,
                                                  gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&] {
        return camera_pick_rectangle(camera, scene, x0, y0, x1, y1, filter, out_models, capacity, out_total);
    });
}

gphys_status gphys_camera_cull_filtered(const gphys_camera* camera, const gphys_scene* scene,
                                        const gphys_query_filter_desc* filter, gphys_model_id* out_models,
                                        uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&] { return camera_cull(camera, scene, filter, out_models, capacity, out_total); });
}

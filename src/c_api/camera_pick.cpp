// Picking and culling: a camera asks a scene.
#include "pick/pick.h"

#include "c_api/scene_asking.h"

using namespace gphys;

namespace {

struct Pixel {
    float x, y;
};

bool is_pixel(float x, float y) { return std::fabs(x) <= GPHYS_MAX_COORDINATE && std::fabs(y) <= GPHYS_MAX_COORDINATE; }

/// A list of models, gathered by `find`.
template <class Find>
gphys_status list_models(gphys_model_id* out, uint32_t capacity, uint32_t* out_total, Find&& find) {
    GPHYS_TRY(check_list(out, capacity, out_total));
    return listed(find(), capacity, out_total);
}

template <class Who>
gphys_status ask_pick(const gphys_camera* camera, const gphys_scene* scene, float pixel_x, float pixel_y,
                      const Who& who, gphys_hit* out_hit) {
    GPHYS_REQUIRE(camera && scene && out_hit, "camera, scene or out_hit is null");
    GPHYS_REQUIRE(unwrap(camera)->origin() == unwrap(scene)->origin(), "camera and scene have different origins");
    GPHYS_REQUIRE(is_pixel(pixel_x, pixel_y), "pixel: not finite or out of range");
    return pick(*unwrap(camera), *unwrap(scene), pixel_x, pixel_y, who, *out_hit);
}

template <class Who>
gphys_status ask_pick_batch(const gphys_camera* camera, const gphys_scene* scene, const float* pixels,
                            uint32_t pixel_stride, uint32_t count, const Who& who, gphys_hit* out_hits,
                            uint32_t out_stride) {
    GPHYS_REQUIRE(camera && scene, "camera or scene is null");
    GPHYS_REQUIRE(unwrap(camera)->origin() == unwrap(scene)->origin(), "camera and scene have different origins");
    const Workers& workers = unwrap(scene)->workers();
    GPHYS_TRY(check_filters(workers, who, count));
    if (count == 0) return GPHYS_OK;
    GPHYS_REQUIRE(pixels && out_hits, "pixels or out_hits is null");
    GPHYS_TRY(check_stride("pixel_stride", pixel_stride, sizeof(Pixel)));
    GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof *out_hits));
    const Strided<Pixel> in(reinterpret_cast<const Pixel*>(pixels), pixel_stride);
    const StridedOut<gphys_hit> out(out_hits, out_stride);
    GPHYS_TRY(check_each(workers, distinct(pixel_stride, count), [&](uint32_t i) -> gphys_status {
        GPHYS_REQUIRE(is_pixel(in[i].x, in[i].y), "pixels: not finite or out of range");
        return GPHYS_OK;
    }));
    raycast_each(*unwrap(scene), in, 2, count, who, out,
                 [&](Pixel pixel, Ray& ray) { return unwrap(camera)->pick_ray(pixel.x, pixel.y, ray); });
    return GPHYS_OK;
}

template <class Who>
gphys_status ask_pick_rectangle(const gphys_camera* camera, const gphys_scene* scene, float x0, float y0, float x1,
                                float y1, const Who& who, gphys_model_id* out_models, uint32_t capacity,
                                uint32_t* out_total) {
    GPHYS_REQUIRE(camera && scene, "camera or scene is null");
    GPHYS_REQUIRE(unwrap(camera)->origin() == unwrap(scene)->origin(), "camera and scene have different origins");
    GPHYS_REQUIRE(is_pixel(x0, y0) && is_pixel(x1, y1), "rectangle: not finite or out of range");
    GPHYS_REQUIRE(x0 != x1 && y0 != y1, "rectangle: has no area");
    return list_models(out_models, capacity, out_total, [&] {
        Smallest<gphys_model_id> models(out_models, capacity);
        pick_rectangle(*unwrap(camera), *unwrap(scene), x0, y0, x1, y1, who, models);
        return models.finish();
    });
}

template <class Who>
gphys_status ask_cull(const gphys_camera* camera, const gphys_scene* scene, const Who& who, gphys_model_id* out_models,
                      uint32_t capacity, uint32_t* out_total) {
    GPHYS_REQUIRE(camera && scene, "camera or scene is null");
    GPHYS_REQUIRE(unwrap(camera)->origin() == unwrap(scene)->origin(), "camera and scene have different origins");
    return list_models(out_models, capacity, out_total,
                       [&] { return cull(*unwrap(camera), *unwrap(scene), who, out_models, capacity); });
}

}  // namespace

gphys_status gphys_camera_pick(const gphys_camera* camera, const gphys_scene* scene, float pixel_x, float pixel_y,
                               uint32_t layers, gphys_hit* out_hit) {
    return guarded([&] { return ask_pick(camera, scene, pixel_x, pixel_y, layers, out_hit); });
}

gphys_status gphys_camera_pick_batch(const gphys_camera* camera, const gphys_scene* scene, const float* pixels,
                                     uint32_t pixel_stride, uint32_t count, uint32_t layers, gphys_hit* out_hits,
                                     uint32_t out_stride) {
    return guarded(
        [&] { return ask_pick_batch(camera, scene, pixels, pixel_stride, count, layers, out_hits, out_stride); });
}

gphys_status gphys_camera_pick_rectangle(const gphys_camera* camera, const gphys_scene* scene, float x0, float y0,
                                         float x1, float y1, uint32_t layers, gphys_model_id* out_models,
                                         uint32_t capacity, uint32_t* out_total) {
    return guarded(
        [&] { return ask_pick_rectangle(camera, scene, x0, y0, x1, y1, layers, out_models, capacity, out_total); });
}

gphys_status gphys_camera_cull(const gphys_camera* camera, const gphys_scene* scene, uint32_t layers,
                               gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    return guarded([&] { return ask_cull(camera, scene, layers, out_models, capacity, out_total); });
}

gphys_status gphys_camera_pick_filtered(const gphys_camera* camera, const gphys_scene* scene, float pixel_x,
                                        float pixel_y, const gphys_query_filter_desc* filter, gphys_hit* out_hit) {
    return guarded([&] {
        return by_filter(scene, filter, [&](const QueryFilter& known) {
            return ask_pick(camera, scene, pixel_x, pixel_y, known, out_hit);
        });
    });
}

gphys_status gphys_camera_pick_filtered_batch(const gphys_camera* camera, const gphys_scene* scene, const float* pixels,
                                              uint32_t pixel_stride, uint32_t count,
                                              const gphys_query_filter_desc* filters, uint32_t filter_stride,
                                              gphys_hit* out_hits, uint32_t out_stride) {
    return guarded([&] {
        return by_filters(scene, filters, filter_stride, [&](const Filters& known) {
            return ask_pick_batch(camera, scene, pixels, pixel_stride, count, known, out_hits, out_stride);
        });
    });
}

gphys_status gphys_camera_pick_rectangle_filtered(const gphys_camera* camera, const gphys_scene* scene, float x0,
                                                  float y0, float x1, float y1, const gphys_query_filter_desc* filter,
                                                  gphys_model_id* out_models, uint32_t capacity, uint32_t* out_total) {
    return guarded([&] {
        return by_filter(scene, filter, [&](const QueryFilter& known) {
            return ask_pick_rectangle(camera, scene, x0, y0, x1, y1, known, out_models, capacity, out_total);
        });
    });
}

gphys_status gphys_camera_cull_filtered(const gphys_camera* camera, const gphys_scene* scene,
                                        const gphys_query_filter_desc* filter, gphys_model_id* out_models,
                                        uint32_t capacity, uint32_t* out_total) {
    return guarded([&] {
        return by_filter(scene, filter, [&](const QueryFilter& known) {
            return ask_cull(camera, scene, known, out_models, capacity, out_total);
        });
    });
}

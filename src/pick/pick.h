// Queries of a scene with a camera: the model under a pixel, models in a rectangle of pixels, models in view. A pixel
// becomes a ray and a rectangle a frustum, so there is no picking algorithm besides the scene's queries.
#pragma once

#include "camera/camera.h"
#include "scene/scene.h"

namespace gphys {

// Filter is uint32_t (layers) or QueryFilter.

/// The first model on the ray through a pixel. GPHYS_OK or GPHYS_NO_HIT.
template <class Filter>
gphys_status pick(const Camera& camera, const Scene& scene, double pixel_x, double pixel_y, const Filter& filter,
                  gphys_hit& out) {
    Ray ray;
    return camera.pick_ray(pixel_x, pixel_y, ray) ? scene.raycast(ray, filter, out) : GPHYS_NO_HIT;
}

/// The models whose shapes overlap the frustum of a rectangle of pixels.
template <class Filter>
uint32_t pick_rectangle(const Camera& camera, const Scene& scene, double x0, double y0, double x1, double y1,
                        const Filter& filter, gphys_model_id* out, uint32_t capacity) {
    return scene.overlap(camera.frustum_of_pixels(x0, y0, x1, y1), filter, out, capacity);
}

/// The models whose AABBs overlap the frustum of the camera.
template <class Filter>
uint32_t cull(const Camera& camera, const Scene& scene, const Filter& filter, gphys_model_id* out, uint32_t capacity) {
    return scene.cull(camera.frustum(), filter, out, capacity);
}

}  // namespace gphys

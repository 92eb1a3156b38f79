// Where camera and scene meet: what is under a pixel, in a rectangle of pixels, in view.
#pragma once

#include "camera/camera.h"
#include "scene/scene.h"

namespace gphys {

// Who is what models are seen by: uint32_t, for layers, or QueryFilter.

/// The first model on the line of sight through a pixel. GPHYS_OK or GPHYS_NO_HIT.
template <class Who>
gphys_status pick(const Camera& camera, const Scene& scene, double pixel_x, double pixel_y, const Who& who,
                  gphys_hit& out) {
    Ray ray;
    return camera.pick_ray(pixel_x, pixel_y, ray) ? scene.raycast(ray, who, out) : GPHYS_NO_HIT;
}

/// The models whose shapes lie, in part at least, in what is seen in a rectangle of pixels.
template <class Who>
void pick_rectangle(const Camera& camera, const Scene& scene, double x0, double y0, double x1, double y1,
                    const Who& who, Smallest<gphys_model_id>& out) {
    scene.overlap(camera.frustum_of_pixels(x0, y0, x1, y1), who, out);
}

/// The models whose boxes touch what the camera sees.
template <class Who>
uint32_t cull(const Camera& camera, const Scene& scene, const Who& who, gphys_model_id* out, uint32_t capacity) {
    return scene.cull(camera.frustum(), who, out, capacity);
}

}  // namespace gphys

// Where camera and scene meet: what is under a pixel, in a rectangle of pixels, in view.
#pragma once

#include "camera/camera.h"
#include "scene/scene.h"

namespace gphys {

/// The first model on the line of sight through a pixel. GPHYS_OK or GPHYS_NO_HIT.
gphys_status pick(const Camera& camera, const Scene& scene, double pixel_x, double pixel_y, uint32_t layers,
                  gphys_hit& out);

/// The models whose shapes lie, in part at least, in what is seen in a rectangle of pixels.
void pick_rectangle(const Camera& camera, const Scene& scene, double x0, double y0, double x1, double y1,
                    uint32_t layers, Smallest<gphys_model_id>& out);

/// The models whose boxes touch what the camera sees.
uint32_t cull(const Camera& camera, const Scene& scene, uint32_t layers, gphys_model_id* out, uint32_t capacity);

}  // namespace gphys

#include "pick/pick.h"

namespace gphys {

gphys_status pick(const Camera& camera, const Scene& scene, double pixel_x, double pixel_y, uint32_t layers,
                  gphys_hit& out) {
    Ray ray;
    return camera.pick_ray(pixel_x, pixel_y, ray) ? scene.raycast(ray, layers, out) : GPHYS_NO_HIT;
}

void pick_rectangle(const Camera& camera, const Scene& scene, double x0, double y0, double x1, double y1,
                    uint32_t layers, Smallest<gphys_model_id>& out) {
    scene.overlap(camera.frustum_of_pixels(x0, y0, x1, y1), layers, out);
}

uint32_t cull(const Camera& camera, const Scene& scene, uint32_t layers, gphys_model_id* out, uint32_t capacity) {
    return scene.cull(camera.frustum(), layers, out, capacity);
}

}  // namespace gphys

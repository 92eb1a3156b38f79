// What a camera sees: culling, picking, marquee, orbit.
#include <cmath>
#include <cstdio>
#include <gamephys.hpp>

#define EXPECT(condition) \
    if (!(condition)) return std::printf("line %d: %s\n", __LINE__, #condition), 1

int main() {
    namespace gp = gamephys;
    gp::Scene scene;
    const std::vector<gp::Sphere> shapes{{{-4, 0, 9}, 1.5f}, {{0, 0, 9}, 1.5f}, {{4, 0, 9}, 1.5f}, {{0, 0, -50}, 2}};
    std::vector<gphys_model_id> balls(shapes.size());
    scene.add_batch(shapes, {}, nullptr, balls);
    auto desc = gp::camera_desc();
    desc.viewport_width = 640;
    desc.viewport_height = 320;
    gp::Camera camera(&desc);
    camera.set_perspective(0.7f, 0.1f, 100);
    gp::Orbit orbit;
    gp::check(gphys_orbit_init(&orbit));
    orbit.target = {0, 0, 9};
    orbit.distance = 8;
    orbit.radians_per_unit = 0.01f;
    camera.set_orbit(orbit);
    EXPECT(camera.cull(scene).size() == 3);
    const auto pixel = camera.project({-4, 0, 9});
    EXPECT(pixel && camera.pick(scene, pixel->x, pixel->y)->model == balls[0]);
    EXPECT(camera.pick_rectangle(scene, 340, 0, 640, 320).size() == 2);
    camera.orbit_rotate(157.0796f, 0);
    camera.orbit_update();
    const auto behind = scene.raycast_all(*camera.pick_ray(320, 160));
    std::printf("after a quarter turn %zu balls stand behind one another\n", behind.size());
    EXPECT(behind.size() == 3 && behind[1].model == balls[1]);
    return 0;
}

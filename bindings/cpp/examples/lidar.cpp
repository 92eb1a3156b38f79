// A lidar that turns on a vehicle: a million rays a frame, shared by the scene's workers.
//
// lidar [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gamephys.hpp>

namespace gp = gamephys;

constexpr size_t beams = 64;
constexpr float range = 120;

// Ground, and houses and posts to both sides.
gp::Scene street() {
    auto desc = gp::scene_desc();
    desc.worker_count = 2;
    gp::Scene scene(&desc);
    scene.add(gp::Plane{{0, 1, 0}, 0});
    for (int i = 0; i < 40; ++i) {
        const float side = i % 2 ? -1.0f : 1.0f, z = 5.0f * float(i) - 100;
        scene.add(gp::Aabb{{14 * side - 5, 0, z}, {14 * side + 5, 6, z + 8}});
        scene.add(gp::Capsule{{7 * side, 0, z}, {7 * side, 6, z}, 0.15f});
    }
    return scene;
}

int main(int count, char** arguments) {
    const int frames = count > 1 ? std::atoi(arguments[1]) : 3;
    const size_t columns = count > 2 ? size_t(std::atoi(arguments[2])) : 15625;
    const gp::Scene scene = street();
    std::vector<gp::Ray> rays(columns * beams);
    for (size_t i = 0; i < rays.size(); ++i) {
        const double turn = double(i / beams) / double(columns) * 6.283185307179586;
        const double tilt = -0.43 + 0.46 * double(i % beams) / (beams - 1);
        const double across = std::cos(tilt);
        rays[i] = {{0, 1.8f, 0},
                   {float(std::cos(turn) * across), float(std::sin(tilt)), float(std::sin(turn) * across)},
                   range};
    }
    std::vector<gp::Hit> hits(rays.size());  // filled again by every frame
    for (int frame = 0; frame < frames; ++frame) {
        for (gp::Ray& ray : rays) ray.origin.z = 0.5f * float(frame);  // the vehicle drives on
        const auto start = std::chrono::steady_clock::now();
        scene.raycast_batch(rays, GPHYS_ALL_LAYERS, hits);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        size_t seen = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            if (hits[i].model == 0) continue;
            ++seen;
            const float end = rays[i].origin.y + rays[i].direction.y * hits[i].t;
            if (hits[i].t > range || std::fabs(end - hits[i].point.y) > 1e-4f) return 1;
        }
        std::printf("frame %d: %zu rays in %.0f ms, %zu points\n", frame, rays.size(), time.count(), seen);
        if (seen <= rays.size() / 2 || seen == rays.size()) return 1;
    }
    return 0;
}

// C++: overhead [milliseconds a case]
#include <gamephys.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

template <class Call>
void measure(const char* name, Call call, int items, double budget) {
    const double end = seconds() + budget, none = std::numeric_limits<double>::infinity();
    double best = none;
    long calls = 1;
    do {
        const double start = seconds();
        for (long i = 0; i < calls; ++i) call();
        const double elapsed = seconds() - start;
        if (elapsed < 1e-3) {
            calls *= 2;
        } else if (elapsed / static_cast<double>(calls) < best) {
            best = elapsed / static_cast<double>(calls);
        }
    } while (seconds() < end || best == none);
    std::printf("cpp,%s,%.2f\n", name, 1e9 * best / items);
}

}  // namespace

int main(int argc, char** argv) {
    const int ray_count = 1000;
    const double budget = 1e-3 * (argc > 1 ? std::atof(argv[1]) : 200);
    gamephys::Scene scene;
    gamephys::Camera camera;
    const auto model = scene.add(gamephys::Sphere{{0, 0, 5}, 1});
    const gamephys::Ray ray{{0, 0, 0}, {0, 0, 1}, 100};
    const std::vector<gamephys::Ray> rays(ray_count, ray);
    std::vector<gamephys::Hit> hits(ray_count);
    scene.raycast_batch(rays, GPHYS_ALL_LAYERS, hits);
    if (scene.raycast(ray)->t != 4 || hits.back().t != 4) return 1;
    measure(
        "scalar", [&] { scene.has(model); }, 1, budget);
    measure(
        "vec3", [&] { camera.get_origin(); }, 1, budget);
    measure(
        "raycast", [&] { scene.raycast(ray); }, 1, budget);
    measure(
        "raycast_batch", [&] { scene.raycast_batch(rays, GPHYS_ALL_LAYERS, hits); }, ray_count, budget);
    return 0;
}

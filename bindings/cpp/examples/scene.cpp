// A scene and questions to it, one by one and in a batch.
#include <cmath>
#include <cstdio>
#include <gamephys.hpp>

#define EXPECT(condition) \
    if (!(condition)) return std::printf("line %d: %s\n", __LINE__, #condition), 1

int main() {
    namespace gp = gamephys;
    gp::Scene scene;
    const auto ground = scene.add(gp::Plane{{0, 1, 0}, 0});

    // A row of 100 pyramids that share one mesh, which they keep alive.
    std::vector<gp::Transform> places(100, {{0, 0, 10}, {0, 0, 0, 1}, 1});
    for (size_t i = 0; i < places.size(); ++i) places[i].position.x = 5 * float(i);
    std::vector<gphys_model_id> pyramids(places.size());
    {
        const float vertices[] = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 2, 0};
        const std::vector<uint32_t> triangles{0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4};
        const gp::Mesh mesh({vertices, 5, 3 * sizeof(float)}, triangles);
        EXPECT(mesh.get_report().open_edge_count == 0);
        scene.add_batch(mesh, places, nullptr, pyramids);
    }
    const auto hit = scene.raycast({{25, 1, 0}, {0, 0, 1}, INFINITY});
    EXPECT(hit && hit->model == pyramids[5] && std::fabs(hit->t - 9.5f) < 1e-6f);
    EXPECT(!scene.raycast({{25, 1, 0}, {0, 1, 0}, INFINITY}));
    EXPECT(scene.overlap(gp::Aabb{{-1, 0.5f, 8}, {21, 1, 12}}, GPHYS_ALL_LAYERS).size() == 5);
    EXPECT(scene.nearest({0, 10, -50}, INFINITY, GPHYS_ALL_LAYERS)->model == ground);

    // One call for 1000 rays that look down.
    std::vector<gp::Ray> rays(1000, {{0, 5, 10}, {0, -1, 0}, 10});
    std::vector<gp::Hit> hits(rays.size());
    for (size_t i = 0; i < rays.size(); ++i) rays[i].origin.x = 0.5f * float(i);
    scene.raycast_batch(rays, GPHYS_ALL_LAYERS, hits);
    const auto above = std::count_if(hits.begin(), hits.end(), [](const gp::Hit& h) { return h.t < 5; });
    std::printf("%td of 1000 rays end on a pyramid\n", above);
    EXPECT(above == 299);

    // Errors are exceptions with the library's message; freed objects are refused.
    try {
        scene.add(gp::Sphere{{0, 0, 0}, -1});
        return 1;
    } catch (const gp::Error& error) {
        EXPECT(error.status == GPHYS_ERROR_INVALID_ARGUMENT &&
               std::string(error.what()).find("radius") != std::string::npos);
    }
    gp::Scene moved = std::move(scene);
    EXPECT(moved.get_models().size() == 101);
    moved.reset();
    try {
        moved.clear();
        return 1;
    } catch (const gp::Error&) {
    }
    return 0;
}

// Batches of rays in scenes of which a mesh is the most: the mesh answers many rays at once, with the bits of single
// calls.
#include "meshes.h"
#include "scene_fixture.h"

namespace {

/// A scene inside of a closed mesh, with more of its kind about.
struct Level {
    Level() {
        const test::Arrays mesh = test::sphere(4);
        const gphys_vec3* vertices = mesh.vertices.data();
        REQUIRE(gphys_mesh_create(nullptr, &vertices->x, sizeof *vertices, static_cast<uint32_t>(mesh.vertices.size()),
                                  mesh.indices.data(), static_cast<uint32_t>(mesh.indices.size()),
                                  &shared) == GPHYS_OK);
        add_mesh(placed({3, 2, 1}, 20), 1);
        add_mesh(placed({3, 2, 1}, 20), 2);  // the same place, another layer: ties in all rays that see both
        add_mesh({{40, 0, 0}, {0, 0, 0, 1}, 5}, 1);
        for (int i = 0; i < 6; ++i) add_mesh(placed(point(15), 1), 1);
        for (int i = 0; i < 50; ++i) scene.add_sphere(0.5f, test::at(point(15).x, point(15).y, point(15).z));
    }
    ~Level() { gphys_mesh_destroy(shared); }

    gphys_vec3 point(float reach) {
        return {random.uniform_float(-reach, reach), random.uniform_float(-reach, reach),
                random.uniform_float(-reach, reach)};
    }
    gphys_transform placed(gphys_vec3 position, float scale) { return {position, {0.5f, -0.5f, 0.1f, 0.7f}, scale}; }
    void add_mesh(const gphys_transform& transform, uint32_t layers) {
        const gphys_model_id model = scene.add(GPHYS_SHAPE_MESH, shared, transform);
        REQUIRE(gphys_scene_set_layers(scene.scene, model, layers) == GPHYS_OK);
        meshes.push_back(model);
    }

    /// How many rays hit; each gives what a single call gives, and so does any hit.
    uint32_t cast(const std::vector<gphys_ray>& rays, uint32_t layers) const {
        std::vector<int32_t> any(rays.size());
        REQUIRE(gphys_scene_raycast_any_batch(scene.scene, rays.data(), sizeof rays[0],
                                              static_cast<uint32_t>(rays.size()), layers, any.data(),
                                              sizeof any[0]) == GPHYS_OK);
        std::vector<gphys_hit> hits(rays.size());
        REQUIRE(gphys_scene_raycast_batch(scene.scene, rays.data(), sizeof rays[0], static_cast<uint32_t>(rays.size()),
                                          layers, hits.data(), sizeof hits[0]) == GPHYS_OK);
        std::vector<gphys_distance> distances(rays.size());
        REQUIRE(gphys_scene_raycast_distance_batch(scene.scene, rays.data(), sizeof rays[0],
                                                   static_cast<uint32_t>(rays.size()), layers, distances.data(),
                                                   sizeof distances[0]) == GPHYS_OK);
        uint32_t found = 0, of_large = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            gphys_hit single{};
            single.t = INFINITY;
            single.triangle = GPHYS_NO_TRIANGLE;
            const bool hit = gphys_scene_raycast(scene.scene, &rays[i], layers, &single) == GPHYS_OK;
            REQUIRE(any[i] == hit);
            found += hit;
            of_large += single.model == meshes[0] || single.model == meshes[1];
            REQUIRE(std::memcmp(&single, &hits[i], sizeof single) == 0);
            const gphys_distance distance{single.t, single.model, single.triangle};
            REQUIRE(std::memcmp(&distance, &distances[i], sizeof distance) == 0);
        }
        if (layers != 0) CHECK(of_large > rays.size() / 8);
        return found;
    }

    test::Random random{41};
    test::SceneFixture scene;
    gphys_mesh* shared = nullptr;
    std::vector<gphys_model_id> meshes;
};

}  // namespace

TEST_CASE("batches of rays in a scene inside a mesh have the bits of single calls") {
    Level level;
    constexpr uint32_t count = 1000;
    std::vector<gphys_ray> rays(count);
    SECTION("rays of a camera") {
        for (uint32_t i = 0; i < count; ++i) {
            const float x = static_cast<float>(i % 40) / 40 - 0.5f, y = static_cast<float>(i / 40) / 40 - 0.3f;
            rays[i] = {{1, 1, 1}, {x, y, 1}, INFINITY};
        }
        CHECK(level.cast(rays, 1) == count);
        CHECK(level.cast(rays, 2) == count);
        CHECK(level.cast(rays, 3) == count);
    }
    SECTION("rays that go apart, some of them short") {
        for (gphys_ray& ray : rays) {
            const gphys_vec3 from = level.point(12), to = level.point(12);
            ray = {from,
                   {to.x - from.x, to.y - from.y, to.z - from.z},
                   level.random.uniform_float(0, 1) < 0.2f ? 1.0f : 9.0f};
        }
        const uint32_t found = level.cast(rays, 3);
        CHECK(found > count / 2);
        CHECK(found < count);
    }
    SECTION("after the large meshes have moved, shrunk and gone") {
        for (gphys_ray& ray : rays) ray = {level.point(12), level.point(1), 100};
        level.cast(rays, 3);
        const gphys_transform moved = level.placed({-1, 0, 2}, 25), small = level.placed({0, 0, 0}, 0.5f);
        REQUIRE(gphys_scene_set_transform(level.scene.scene, level.meshes[0], &moved) == GPHYS_OK);
        REQUIRE(gphys_scene_set_transform(level.scene.scene, level.meshes[1], &small) == GPHYS_OK);
        level.cast(rays, 3);
        REQUIRE(gphys_scene_remove(level.scene.scene, level.meshes[1]) == GPHYS_OK);
        level.cast(rays, 3);
        REQUIRE(gphys_scene_remove(level.scene.scene, level.meshes[0]) == GPHYS_OK);
        // In the slot of the mesh there may be something else now.
        for (int i = 0; i < 1100; ++i) {
            REQUIRE(gphys_scene_remove(level.scene.scene, level.scene.add_sphere(1, test::at(0, 0, 0))) == GPHYS_OK);
        }
        level.meshes[0] = level.scene.add_sphere(30, test::at(0, 0, 0));
        level.cast(rays, 3);
    }
}

TEST_CASE("batches of rays have the bits of single calls where there is nothing but meshes") {
    // The smaller ones are magnified for rays, and their models are still small.
    for (const float size : {1.0f, 0x1p-34f}) {
        const float scale = std::fmin(2 / size, 0x1p19f), radius = scale * size;
        const test::Arrays mesh = test::sphere(3).placed({}, {size, size, size});
        test::SceneFixture scene;
        gphys_mesh* shared = nullptr;
        REQUIRE(gphys_mesh_create(nullptr, &mesh.vertices[0].x, sizeof mesh.vertices[0],
                                  static_cast<uint32_t>(mesh.vertices.size()), mesh.indices.data(),
                                  static_cast<uint32_t>(mesh.indices.size()), &shared) == GPHYS_OK);
        const gphys_vec3 places[] = {{0, 0, 0}, {radius / 2, radius / 4, 0}};
        for (const gphys_vec3& place : places) {
            scene.add(GPHYS_SHAPE_MESH, shared, {place, {0.5f, -0.5f, 0.1f, 0.7f}, scale});
        }
        test::Random random{43};
        std::vector<gphys_ray> rays(500);
        for (gphys_ray& ray : rays) {
            const auto number = [&] { return radius * random.uniform_float(-1, 1); };
            ray = {{3 * number(), 3 * number(), 3 * number()}, {number(), number(), number()}, 20};
            if (random.index(2) == 0) ray.direction = {-ray.origin.x, -ray.origin.y, number() - ray.origin.z};
        }
        std::vector<gphys_hit> hits(rays.size());
        std::vector<int32_t> any(rays.size());
        const auto count = static_cast<uint32_t>(rays.size());
        REQUIRE(gphys_scene_raycast_batch(scene.scene, rays.data(), sizeof rays[0], count, 1, hits.data(),
                                          sizeof hits[0]) == GPHYS_OK);
        REQUIRE(gphys_scene_raycast_any_batch(scene.scene, rays.data(), sizeof rays[0], count, 1, any.data(),
                                              sizeof any[0]) == GPHYS_OK);
        uint32_t found = 0;
        for (uint32_t i = 0; i < count; ++i) {
            gphys_hit single{};
            single.t = INFINITY;
            single.triangle = GPHYS_NO_TRIANGLE;
            const bool hit = gphys_scene_raycast(scene.scene, &rays[i], 1, &single) == GPHYS_OK;
            REQUIRE(std::memcmp(&single, &hits[i], sizeof single) == 0);
            REQUIRE(any[i] == hit);
            found += hit;
        }
        CHECK(found > count / 4);
        CHECK(found < count);
        gphys_mesh_destroy(shared);
    }
}

TEST_CASE("segments in a scene inside a mesh give the same in batches as alone") {
    Level level;
    std::vector<gphys_segment> segments(200);
    for (gphys_segment& segment : segments) segment = {level.point(30), level.point(30)};
    std::vector<gphys_hit> hits(segments.size());
    REQUIRE(gphys_scene_segment_test_batch(level.scene.scene, segments.data(), sizeof segments[0],
                                           static_cast<uint32_t>(segments.size()), 3, hits.data(),
                                           sizeof hits[0]) == GPHYS_OK);
    for (size_t i = 0; i < segments.size(); ++i) {
        gphys_hit single{};
        single.t = INFINITY;
        single.triangle = GPHYS_NO_TRIANGLE;
        gphys_scene_segment_test(level.scene.scene, &segments[i], 3, &single);
        REQUIRE(std::memcmp(&single, &hits[i], sizeof single) == 0);
    }
}

// The order of a batch: everything once, images and lidars by tiles, and the answers of single calls whatever the
// order.
#include "foundation/image_tiles.h"

#include <cstring>
#include <vector>

#include "meshes.h"

using namespace gphys;

namespace {

/// What rays begin with, of an image of so many columns.
std::vector<gphys_ray> camera(uint32_t columns, uint32_t count, float pixel = 0.01f) {
    std::vector<gphys_ray> rays(count);
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 across{(i % columns - 0.5 * columns) * pixel, 0.5 - i / columns * pixel, -1};
        rays[i] = {{1, 2, 30}, narrow(normalized(across)), INFINITY};
    }
    return rays;
}

ImageTiles tiles_of(const std::vector<gphys_ray>& rays) {
    const Strided<gphys_ray> all(rays.data(), sizeof rays[0]);
    return ImageTiles(all.beginnings<float>(), 6, static_cast<uint32_t>(rays.size()));
}

std::vector<uint32_t> first_tile(const std::vector<gphys_ray>& rays) {
    std::vector<uint32_t> items(ImageTiles::most);
    items.resize(tiles_of(rays).items(0, items.data()));
    return items;
}

/// In blocks of four times two, or in one row.
std::vector<uint32_t> rectangle(uint32_t width, uint32_t height, uint32_t columns) {
    const uint32_t rows = height == 1 ? 1 : 2, across = 8 / rows;
    std::vector<uint32_t> items;
    for (uint32_t block = 0; block < width * height / 8; ++block) {
        const uint32_t x = block % (width / across) * across, y = block / (width / across) * rows;
        for (uint32_t i = 0; i < 8; ++i) items.push_back((y + i / across) * columns + x + i % across);
    }
    return items;
}

bool is_no_hit(const gphys_hit& hit) { return hit.t == INFINITY && hit.model == 0; }

bool same_bits(const gphys_hit& a, const gphys_hit& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

TEST_CASE("tiles hold every item once, and what is fetched before each visit is what it visits") {
    for (const uint32_t columns : {8u, 9u, 13u, 64u, 100u, 1000u, 20000u}) {
        for (const uint32_t count : {0u, 1u, 63u, 64u, 127u, 128u, 129u, 1000u, 4097u, 44000u}) {
            const ImageTiles tiles = tiles_of(camera(columns, count, 0.001f));
            std::vector<uint32_t> times(count), fetched;
            const uint32_t halfway = tiles.count() / 2;
            for (const auto& [begin, end] : {std::pair(0u, halfway), std::pair(halfway, tiles.count())}) {
                fetched.clear();
                bool first = true;
                tiles.for_each(
                    begin, end, [&](uint32_t item) { fetched.push_back(item); },
                    [&](const uint32_t* items, uint32_t size) {
                        REQUIRE(size <= ImageTiles::most);
                        for (uint32_t k = 0; k < size; ++k) ++times.at(items[k]);
                        if (!first) REQUIRE(fetched.size() >= size);
                        if (!first) REQUIRE(std::equal(items, items + size, fetched.begin()));
                        if (!first) fetched.erase(fetched.begin(), fetched.begin() + size);
                        first = false;
                    });
            }
            REQUIRE(times == std::vector<uint32_t>(count, 1));
        }
    }
}

TEST_CASE("pixels row by row go by squares, also if they come in squares already") {
    for (const uint32_t columns : {8u, 50u, 100u, 640u, 1001u}) {
        CHECK(first_tile(camera(columns, columns * 30, 0.001f)) == rectangle(8, 8, columns));
    }
    // An orthographic camera, whose rays differ by where they begin.
    std::vector<gphys_ray> parallel = camera(100, 5000);
    for (gphys_ray& ray : parallel) std::swap(ray.origin, ray.direction);
    CHECK(first_tile(parallel) == rectangle(8, 8, 100));
}

TEST_CASE("beams of a lidar that turns go by tiles that are about as high as wide") {
    constexpr uint32_t rings = 64, steps = 2048;
    const auto beam = [](uint32_t ring, uint32_t step, double between_rings) {
        const double up = (ring - 0.5 * rings) * between_rings * pi / 180, around = step * 2 * pi / steps;
        return gphys_ray{{0, 0, 0},
                         narrow(Vec3{std::cos(up) * std::cos(around), std::sin(up), std::cos(up) * std::sin(around)}),
                         100};
    };
    std::vector<gphys_ray> ring_by_ring, dense, step_by_step;
    for (uint32_t i = 0; i < rings * steps; ++i) {
        ring_by_ring.push_back(beam(i / steps, i % steps, 0.4));
        dense.push_back(beam(i / steps, i % steps, 0.15));
        step_by_step.push_back(beam(i % rings, i / rings, 0.4));
    }
    CHECK(first_tile(ring_by_ring) == rectangle(16, 4, steps));
    CHECK(first_tile(step_by_step) == rectangle(4, 16, rings));
    // Where a turn ends cannot be told from another step of it.
    const std::vector<uint32_t> tile = first_tile(dense);
    CHECK((tile == rectangle(8, 8, steps) || tile == rectangle(8, 8, steps - 1)));
}

TEST_CASE("what comes in no rows is taken in its order") {
    test::Random random(5);
    std::vector<gphys_ray> rays(1000);
    for (gphys_ray& ray : rays) ray = {random.point(10), random.point(1), INFINITY};
    CHECK(first_tile(rays) == rectangle(64, 1, 0));
    // A line, the same again and again, columns in no order, and rows that soon end.
    CHECK(first_tile(camera(1000, 1000)) == rectangle(64, 1, 0));
    CHECK(first_tile(std::vector<gphys_ray>(1000)) == rectangle(64, 1, 0));
    std::vector<gphys_ray> shuffled = camera(100, 1000);
    for (uint32_t i = 0; i < 1000; ++i) shuffled[i] = camera(100, 1000)[i / 100 * 100 + i * i % 100];
    CHECK(first_tile(shuffled) == rectangle(64, 1, 0));
    std::vector<gphys_ray> torn = camera(50, 1000);
    for (uint32_t i = 500; i < 1000; ++i) torn[i] = {random.point(10), random.point(1), INFINITY};
    CHECK(first_tile(torn) == rectangle(64, 1, 0));
}

TEST_CASE("batches in the order of an image have the answers of single calls") {
    constexpr uint32_t columns = 83, count = columns * 61 + 17;
    const std::vector<gphys_ray> rays = camera(columns, count);
    REQUIRE(first_tile(rays) == rectangle(8, 8, columns));
    test::Random random(6);
    for (const uint32_t workers : {1u, 3u}) {
        gphys_scene_desc desc;
        gphys_scene_desc_init(&desc, sizeof desc);
        desc.worker_count = workers;
        gphys_scene* scene = nullptr;
        REQUIRE(gphys_scene_create(&desc, &scene) == GPHYS_OK);
        for (int i = 0; i < 300; ++i) {
            const gphys_sphere ball{random.point(12), random.uniform_float(0.2f, 1)};
            gphys_model_id id;
            REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, nullptr, nullptr, &id) == GPHYS_OK);
        }
        std::vector<gphys_hit> hits(count), of_segments(count);
        std::vector<int32_t> any(count);
        std::vector<gphys_segment> segments(count);
        for (uint32_t i = 0; i < count; ++i) {
            segments[i] = {rays[i].origin, narrow(widen(rays[i].origin) + 30 * widen(rays[i].direction))};
        }
        constexpr uint32_t all = GPHYS_ALL_LAYERS;
        REQUIRE(gphys_scene_raycast_batch(scene, rays.data(), sizeof rays[0], count, all, hits.data(),
                                          sizeof hits[0]) == GPHYS_OK);
        REQUIRE(gphys_scene_raycast_any_batch(scene, rays.data(), sizeof rays[0], count, all, any.data(), 4) ==
                GPHYS_OK);
        REQUIRE(gphys_scene_segment_test_batch(scene, segments.data(), sizeof segments[0], count, all,
                                               of_segments.data(), sizeof hits[0]) == GPHYS_OK);
        uint32_t met = 0;
        for (uint32_t i = 0; i < count; ++i) {
            gphys_hit hit{};
            const bool found = gphys_scene_raycast(scene, &rays[i], all, &hit) == GPHYS_OK;
            REQUIRE((found ? same_bits(hits[i], hit) : is_no_hit(hits[i])));
            REQUIRE(any[i] == (found ? 1 : 0));
            const bool reached = gphys_scene_segment_test(scene, &segments[i], all, &hit) == GPHYS_OK;
            REQUIRE((reached ? same_bits(of_segments[i], hit) : is_no_hit(of_segments[i])));
            met += found;
        }
        CHECK(met > count / 4);
        CHECK(met < count);
        gphys_scene_destroy(scene);
    }
    const test::Arrays ball = test::sphere(4).placed({0, 0, 0}, {10, 10, 10});
    gphys_mesh* mesh = nullptr;
    const MeshArrays arrays = ball.view();
    REQUIRE(gphys_mesh_create(nullptr, arrays.vertices, arrays.vertex_stride, arrays.vertex_count, arrays.indices,
                              arrays.index_count, &mesh) == GPHYS_OK);
    std::vector<gphys_hit> hits(count);
    REQUIRE(gphys_shape_raycast_batch(GPHYS_SHAPE_MESH, mesh, rays.data(), sizeof rays[0], count, hits.data(),
                                      sizeof hits[0]) == GPHYS_OK);
    for (uint32_t i = 0; i < count; ++i) {
        gphys_hit hit{};
        const bool found = gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh, &rays[i], &hit) == GPHYS_OK;
        REQUIRE((found ? same_bits(hits[i], hit) : is_no_hit(hits[i])));
    }
    gphys_mesh_destroy(mesh);
}

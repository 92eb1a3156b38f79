// Segments whose ends differ by no double: tiny numbers beside ordinary ones, as sines and cosines of right
// angles leave them. The segment is what its ends say, whatever the rounded difference would meet.
#include <vector>

#include "scene_fixture.h"

namespace {

using gphys::narrow;
using gphys::Vec3;
using gphys::widen;

const float e = static_cast<float>(std::cos(gphys::pi / 2));  // 6.1e-17
const float numbers[] = {0, 1, -1, .5f, .25f, 2, e, -e, 3 * e, 0x1p-60f, -0x3p-40f, 0x5p-149f};

gphys_vec3 mixed_point(test::Random& random) {
    const auto any = [&] { return numbers[random.index(std::size(numbers))]; };
    const float x = any(), y = any(), z = any();
    return {x, y, z};
}

bool meets(gphys_shape_type type, const void* shape, const gphys_segment& segment, gphys_hit& hit) {
    const gphys_status status = gphys_shape_segment_test(type, shape, &segment, &hit);
    REQUIRE((status == GPHYS_OK || status == GPHYS_NO_HIT));
    return status == GPHYS_OK;
}
bool meets(gphys_shape_type type, const void* shape, const gphys_segment& segment) {
    gphys_hit hit;
    return meets(type, shape, segment, hit);
}
gphys_segment reversed(const gphys_segment& segment) { return {segment.b, segment.a}; }

bool same_bits(const gphys_hit& a, const gphys_hit& b) {
    return a.t == b.t && widen(a.point) == widen(b.point) && widen(a.normal) == widen(b.normal) && a.u == b.u &&
           a.v == b.v && a.triangle == b.triangle && a.flags == b.flags;
}

/// A mesh of `count` triangles, given by their corners.
gphys_mesh* mesh_of(const gphys_triangle* triangles, uint32_t count) {
    std::vector<uint32_t> indices(3 * count);
    for (uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, &triangles->a.x, sizeof(gphys_vec3), 3 * count, indices.data(), 3 * count,
                              &mesh) == GPHYS_OK);
    return mesh;
}

/// What a segment meets as a shape, as the only model of a scene, and in a batch is the same.
void compare_with_scene(test::Random& random, gphys_shape_type type, const void* shape,
                        const std::vector<gphys_vec3>& corners, int& met) {
    test::SceneFixture world;
    world.add(type, shape, test::at(0, 0, 0));
    constexpr uint32_t count = 40;
    gphys_segment segments[count];
    gphys_hit batch[count];
    for (gphys_segment& segment : segments) {
        segment = {mixed_point(random), corners[random.index(static_cast<uint32_t>(corners.size()))]};
        if (random.index(3) == 0) segment.b = mixed_point(random);
        if (random.index(2)) std::swap(segment.a, segment.b);
    }
    REQUIRE(gphys_scene_segment_test_batch(world.scene, segments, sizeof(gphys_segment), count, GPHYS_ALL_LAYERS, batch,
                                           sizeof(gphys_hit)) == GPHYS_OK);
    for (uint32_t i = 0; i < count; ++i) {
        CAPTURE(type, i, segments[i].a.x, segments[i].a.y, segments[i].a.z, segments[i].b.x, segments[i].b.y,
                segments[i].b.z);
        gphys_hit of_shape, of_scene;
        const bool hits = meets(type, shape, segments[i], of_shape);
        met += hits;
        REQUIRE(meets(type, shape, reversed(segments[i])) == hits);
        const gphys_status status = gphys_scene_segment_test(world.scene, &segments[i], GPHYS_ALL_LAYERS, &of_scene);
        REQUIRE((status == GPHYS_OK) == hits);
        REQUIRE((batch[i].model != 0) == hits);
        if (!hits) continue;
        REQUIRE(same_bits(of_scene, of_shape));
        REQUIRE(same_bits(batch[i], of_shape));
    }
}

}  // namespace

TEST_CASE("a segment meets the corner or edge that it ends on, from either end") {
    const gphys_triangle triangle{{1, e, 0}, {1, 1, 0}, {1, 1, 1}};
    const gphys_segment to_corner{{e, 1, 0}, {1, e, 0}};
    CHECK(meets(GPHYS_SHAPE_TRIANGLE, &triangle, to_corner));
    CHECK(meets(GPHYS_SHAPE_TRIANGLE, &triangle, reversed(to_corner)));
    const gphys_aabb box{{1, -1, -1}, {2, e, 1}};
    const gphys_segment to_edge{{0, 1, 0}, {1, e, 0}};
    CHECK(meets(GPHYS_SHAPE_AABB, &box, to_edge));
    CHECK(meets(GPHYS_SHAPE_AABB, &box, reversed(to_edge)));
    const gphys_plane plane{{1, 1, 0}, 1};  // the end is beyond it by e
    const gphys_segment across{{e, .5f, 0}, {1, e, 0}}, short_of_it{{e, .5f, 0}, {1, -e, 0}};
    CHECK(meets(GPHYS_SHAPE_PLANE, &plane, across));
    CHECK(meets(GPHYS_SHAPE_PLANE, &plane, reversed(across)));
    CHECK_FALSE(meets(GPHYS_SHAPE_PLANE, &plane, short_of_it));
    const gphys_sphere sphere{{2, e, 0}, 1};
    CHECK(meets(GPHYS_SHAPE_SPHERE, &sphere, to_corner));
    CHECK(meets(GPHYS_SHAPE_SPHERE, &sphere, reversed(to_corner)));
}

TEST_CASE("a segment holds both of its ends") {
    test::Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const gphys_segment segment{mixed_point(random), mixed_point(random)};
        for (const gphys_vec3& end : {segment.a, segment.b}) {
            int32_t holds = 0;
            REQUIRE(gphys_shape_contains(GPHYS_SHAPE_SEGMENT, &segment, &end, 0, &holds) == GPHYS_OK);
            REQUIRE(holds == 1);
        }
    }
}

TEST_CASE("segments of mixed sizes meet models of a scene exactly as they meet the shapes") {
    test::Random random(2);
    int met[8] = {};
    for (int i = 0; i < 150; ++i) {
        const gphys_vec3 p = mixed_point(random), q = mixed_point(random), r = mixed_point(random);
        const float radius = std::fabs(numbers[random.index(std::size(numbers))]);

        const gphys_triangle triangle{p, q, r};
        const std::vector<gphys_vec3> corners{p, q, r};
        compare_with_scene(random, GPHYS_SHAPE_TRIANGLE, &triangle, corners, met[0]);
        gphys_mesh* mesh = mesh_of(&triangle, 1);
        compare_with_scene(random, GPHYS_SHAPE_MESH, mesh, corners, met[1]);
        gphys_mesh_destroy(mesh);

        const Vec3 low = min(widen(p), widen(q)), high = max(widen(p), widen(q));
        const gphys_aabb box{narrow(low), narrow(high)};
        std::vector<gphys_vec3> box_corners;
        for (int k = 0; k < 8; ++k) {
            box_corners.push_back(
                {k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z});
        }
        compare_with_scene(random, GPHYS_SHAPE_AABB, &box, box_corners, met[2]);

        const gphys_sphere sphere{p, radius};
        const std::vector<gphys_vec3> poles{{p.x + radius, p.y, p.z}, {p.x, p.y - radius, p.z}, p};
        compare_with_scene(random, GPHYS_SHAPE_SPHERE, &sphere, poles, met[3]);
        const gphys_capsule capsule{p, q, radius};
        compare_with_scene(random, GPHYS_SHAPE_CAPSULE, &capsule, poles, met[4]);
        gphys_plane plane{r, numbers[random.index(std::size(numbers))]};
        if (gphys_shape_validate(GPHYS_SHAPE_PLANE, &plane) != GPHYS_OK) plane = {{0, 1, 0}, e};
        compare_with_scene(random, GPHYS_SHAPE_PLANE, &plane, corners, met[5]);
    }
    for (int k = 0; k < 6; ++k) CHECK(met[k] > 600);
}

TEST_CASE("segments of mixed sizes meet a mesh of many triangles in a scene when they meet one of them") {
    test::Random random(3);
    std::vector<gphys_triangle> triangles;
    for (int i = 0; i < 200; ++i) {
        const Vec3 cell{double(random.index(5)) - 2, double(random.index(5)) - 2, double(random.index(5)) - 2};
        const auto corner = [&] { return narrow(cell + widen(mixed_point(random))); };
        const gphys_vec3 a = mixed_point(random), b = corner(), c = corner();
        triangles.push_back({a, b, c});
    }
    gphys_mesh* mesh = mesh_of(triangles.data(), static_cast<uint32_t>(triangles.size()));
    std::vector<gphys_vec3> corners;
    for (const gphys_triangle& t : triangles) corners.insert(corners.end(), {t.a, t.b, t.c});
    int met = 0;
    for (int i = 0; i < 60; ++i) compare_with_scene(random, GPHYS_SHAPE_MESH, mesh, corners, met);
    CHECK(met > 1000);
    for (int i = 0; i < 2000; ++i) {
        const gphys_segment segment{mixed_point(random), corners[random.index(static_cast<uint32_t>(corners.size()))]};
        bool meets_one = false;
        for (const gphys_triangle& t : triangles) {
            meets_one = meets_one || meets(GPHYS_SHAPE_TRIANGLE, &t, segment);
        }
        REQUIRE(meets_one);
        REQUIRE(meets(GPHYS_SHAPE_MESH, mesh, segment));
        REQUIRE(meets(GPHYS_SHAPE_MESH, mesh, reversed(segment)));
    }
    gphys_mesh_destroy(mesh);
}

TEST_CASE("a segment meets the corner of a mesh in a scene that a move has brought to its end") {
    const gphys_triangle triangle{{-4, -1, 0}, {-4, 1, 0}, {-4, 1, 1}};
    gphys_mesh* mesh = mesh_of(&triangle, 1);
    test::SceneFixture world;
    world.add(GPHYS_SHAPE_MESH, mesh, test::at(5, 1, 0));
    gphys_mesh_destroy(mesh);
    // x + 5 rounds these away.
    for (const float x : {e, 3 * e, -e, 0x1p-60f}) {
        for (const float y : {1.0f, e, -e}) {
            const gphys_segment segment{{x, y, e}, {1, 0, 0}};
            CAPTURE(x, y);
            gphys_hit hit;
            CHECK(gphys_scene_segment_test(world.scene, &segment, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK);
            const gphys_segment back = reversed(segment);
            CHECK(gphys_scene_segment_test(world.scene, &back, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK);
        }
    }
}

// Containment and closest points: the book's defects by name, exact signs beside integer and
// 128-bit float arithmetic, and closest points beside a slow minimiser.
#include "intersect.h"

#include "test.h"

using namespace gphys;

namespace {

Aabb box_at(Vec3 center, Vec3 half) { return {center - half, center + half}; }

const Triangle unit_triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

}  // namespace

TEST_CASE("the closest point of a box away from the origin is on that box") {
    REQUIRE(closest_point(box_at({5, 0, 0}, {1, 1, 1}), Vec3{5, 3, 0}) == Vec3{5, 1, 0});
    REQUIRE(closest_point(as_obb(box_at({5, 0, 0}, {1, 1, 1})), Vec3{5, 3, 0}) == Vec3{5, 1, 0});
}

TEST_CASE("the closest point of a triangle beyond an edge's end is the corner") {
    REQUIRE(closest_point(unit_triangle, Vec3{3, -1, 1}) == Vec3{1, 0, 0});
}

TEST_CASE("a point on the extension of an edge is not in the triangle") {
    REQUIRE_FALSE(contains(unit_triangle, {2, -1, 0}, 0));
    REQUIRE_FALSE(contains(unit_triangle, {2, 0, 0}, 0));
}

TEST_CASE("a point off the triangle's plane is not in the triangle, unless the tolerance says so") {
    REQUIRE_FALSE(contains(unit_triangle, {.3, .3, .05}, 0));
    REQUIRE_FALSE(contains(unit_triangle, {.3, .3, .05}, .0499));
    REQUIRE(contains(unit_triangle, {.3, .3, .05}, .05));
    REQUIRE(contains(unit_triangle, {.3, .3, 0}, 0));
}

TEST_CASE("a collinear triangle answers as the segment that it is") {
    const Triangle line{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
    REQUIRE(closest_point(line, Vec3{1.5, 1, 0}) == Vec3{1.5, 0, 0});
    REQUIRE(closest_point(line, Vec3{5, 1, 0}) == Vec3{2, 0, 0});
    REQUIRE(contains(line, {1.5, 0, 0}, 0));
    REQUIRE_FALSE(contains(line, {1.5, 1e-30, 0}, 0));
    const Triangle dot{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    REQUIRE(closest_point(dot, Vec3{4, 4, 4}) == Vec3{1, 2, 3});
    REQUIRE(contains(dot, {1, 2, 3}, 0));
    REQUIRE_FALSE(contains(dot, {1, 2, 3.5}, 0));
}

TEST_CASE("a sphere's own centre is its closest point to its centre") {
    REQUIRE(closest_point(Sphere{{1, 2, 3}, 1}, Vec3{1, 2, 3}) == Vec3{1, 2, 3});
    REQUIRE(closest_point(Sphere{{1, 2, 3}, 0}, Vec3{1, 2, 3}) == Vec3{1, 2, 3});
    REQUIRE(closest_point(Capsule{{0, 0, 0}, {2, 0, 0}, 1}, Vec3{1, 0, 0}) == Vec3{1, 0, 0});
}

TEST_CASE("a point beside a ray is not on it, however far along") {
    const Ray ray{{0, 0, 0}, {0, 0, 1}, infinity};
    REQUIRE_FALSE(contains(ray, {0, .4, 1000}, 0));
    REQUIRE(contains(ray, {0, 0, 1000}, 0));
    REQUIRE_FALSE(contains(ray, {0, 0, -1}, 0));
    REQUIRE(contains(ray, {0, 0, -1}, 1));
    REQUIRE(contains(Ray{{0, 0, 0}, {0, 0, 2}, 3}, {0, 0, 6}, 0));
    REQUIRE_FALSE(contains(Ray{{0, 0, 0}, {0, 0, 2}, 3}, {0, 0, 6.5}, 0));
}

TEST_CASE("a box contains its own corners") {
    test::Random random(1);
    for (int i = 0; i < 100000; ++i) {
        const Vec3 a = widen(random.point(1e6f)), b = widen(random.point(1));
        const Aabb box{min(a, b), max(a, b)};
        REQUIRE(contains(box, box.min, 0));
        REQUIRE(contains(box, box.max, 0));
        REQUIRE(contains(box, {box.min.x, box.max.y, box.min.z}, 0));
    }
}

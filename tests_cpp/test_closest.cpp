// Containment and closest points: the book's defects by name, exact signs beside integer and
// 128-bit float arithmetic, and closest points beside a slow minimiser.
#include "geometry/intersect.h"

#include "convex_hull.h"
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

TEST_CASE("the closest point of a triangle does not leave it by rounding") {
    // Beyond the far end of a sliver: at 1e15 m, rounding takes the edges' sides of a foot for the other.
    const Triangle sliver{{3, 0, 2}, {2, 0, 3}, {3, -0x1.a3386p+49, 3}};
    const double far = -0x1.c6bf52p+49;
    REQUIRE(closest_point(sliver, Vec3{far, far, far}) == sliver.c);
    // Beyond a corner, by less than a rounding of the other corners.
    const Triangle triangle{{1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
    REQUIRE(closest_point(triangle, Vec3{-0x1.c3cffap-58, 0, 1}) == triangle.b);
}

TEST_CASE("the closest point of a frustum is in it, though two of its planes are almost parallel") {
    // Planes 1 and 4 are at an angle of 1e-14, and 11048575.5 m from the point, one above it and one below.
    const Frustum frustum{{3.5, -0x1.57e94cp+2, -2e7},
                          {{{-0x1.ff973cp+48, 0x1.ffffbp+19, -0x1.b2f13p+2}, 0x1.fffff8p+19},
                           {{1.25, -0x1.f8a88p-3, -0x1.4df48p+48}, 0},
                           {{0x1.fffffep-3, 0, 0x1.000014p+20}, 0},
                           {{-2, 0, 0}, 0},
                           {{0x1.995d78p+1, -0x1.41b2f8p-2, 0x1.46d982p+48}, -2.5},
                           {{1, 0, 0}, -0x1.fffffep+23}}};
    const Vec3 point{-4, 4, -2e7 + 11048575.5};
    Vec3 nearest;
    REQUIRE(closest_point(frustum, point, nearest));
    REQUIRE(distance(nearest, point) >= 11048575.5 * (1 - 0x1p-40));
    REQUIRE(distance(nearest, point) < 11048580);
    REQUIRE_FALSE(contains(frustum, point, 11048575));
    REQUIRE(contains(frustum, point, 11048580));
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

namespace {

/// What is wrong with an answer, measured with the slow twin: its distance from the reference point.
void check_closest(const test::Hull& hull, Vec3 point, Vec3 answer, double scale) {
    const test::Gap gap = test::gap(test::Hull{{point}, {}, {}, 0}, hull);
    // The contract is 1 ulp of a float, 2^-23 of the largest coordinate; double leaves 2^-44 or
    // less wherever the closest point is not itself ill-defined.
    const double tolerance = 0x1p-24 * scale;
    if (gap.gap <= 0) {
        REQUIRE(length(answer - point) <= tolerance);
    } else {
        const Vec3 expected = point + gap.axis * gap.gap;
        REQUIRE(length(answer - expected) <= tolerance);
        // Distances are well-defined everywhere.
        const double distance = length(answer - point);
        REQUIRE(std::fabs(distance - gap.gap) <= 0x1p-40 * scale);
    }
}

Vec3 spread(test::Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

Vec3 in_float(Vec3 v) { return widen(narrow(v)); }

}  // namespace

TEST_CASE("closest points agree with support functions for every solid") {
    test::Random random(2);
    for (int i = 0; i < 20000; ++i) {
        // Near and at 1e6, where a float has a sixteenth of a metre.
        const double offset = i % 2 ? 1e6 : 0, scale = offset + 4;
        const Vec3 at = Vec3{offset, -offset / 2, offset / 4};
        const Vec3 point = in_float(at + spread(random, 3)), center = in_float(at + spread(random, 1));
        const Vec3 half{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
        const Mat3 axes = rotation_matrix(widen(random.rotation()));
        const Sphere sphere{center, random.uniform(0, 1)};
        const Capsule capsule{center, in_float(at + spread(random, 1)), random.uniform(0, 1)};
        const Aabb box = box_at(center, half);
        const Obb turned{center, half, axes};
        const Triangle triangle{center, in_float(at + spread(random, 1)), in_float(at + spread(random, 1))};
        check_closest(test::hull(sphere), point, closest_point(sphere, point), scale);
        check_closest(test::hull(capsule), point, closest_point(capsule, point), scale);
        check_closest(test::hull(box), point, closest_point(box, point), scale);
        check_closest(test::hull(turned), point, closest_point(turned, point), scale);
        check_closest(test::hull(triangle), point, closest_point(triangle, point), scale);
        const double near = random.uniform(.01, .5);
        const bool infinite = random.index(2);
        const test::View view = test::view(center, axes, random.uniform(.1, 2), random.uniform(.1, 2), near,
                                           infinite ? 100 : near + random.uniform(.01, 2), infinite);
        Vec3 answer;
        REQUIRE(closest_point(view.frustum, point, answer));
        check_closest(view.hull, point, answer, scale);
    }
}

TEST_CASE("the closest point of a sliver is right although its normal is all cancellation") {
    test::Random random(3);
    for (int i = 0; i < 50000; ++i) {
        const Vec3 a = in_float(spread(random, 1)), b = in_float(spread(random, 1));
        // On the line a b but for the rounding to float: a height of 1e-7 or less.
        const Vec3 c = in_float(a + (b - a) * random.uniform(-.5, 1.5));
        const Triangle sliver{a, b, c};
        const Vec3 point = in_float(spread(random, 2));
        const Vec3 answer = closest_point(sliver, point);
        // The sliver is, to 1e-7, its longest edge.
        double best = infinity;
        for (const Segment& edge : {Segment{a, b}, Segment{b, c}, Segment{c, a}}) {
            best = std::min(best, distance(closest_point(edge, point), point));
        }
        REQUIRE(distance(answer, point) <= best + 1e-15);
        REQUIRE(distance(answer, point) >= best - 2e-7);
        check_closest(test::hull(sliver), point, answer, 2);
    }
}

TEST_CASE("a point in a solid is its own closest point, bit for bit") {
    test::Random random(4);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 point = widen(random.point(1));
        const Obb box{widen(random.point(1)), {1, 1, 1}, rotation_matrix(widen(random.rotation()))};
        if (contains(box, point, 0)) REQUIRE(distance(closest_point(box, point), point) <= 1e-15);
        const Sphere sphere{widen(random.point(1)), 1};
        if (contains(sphere, point, 0)) REQUIRE(closest_point(sphere, point) == point);
        const Capsule capsule{widen(random.point(1)), widen(random.point(1)), .5};
        if (contains(capsule, point, 0)) REQUIRE(closest_point(capsule, point) == point);
    }
}

TEST_CASE("closest points of segments agree with support functions, nearly parallel or not") {
    test::Random random(5);
    for (int i = 0; i < 50000; ++i) {
        const double offset = i % 2 ? 1e6 : 0;
        const Vec3 at{offset, offset, -offset};
        const Segment a{in_float(at + spread(random, 1)), in_float(at + spread(random, 1))};
        Segment b{in_float(at + spread(random, 1)), in_float(at + spread(random, 1))};
        if (i % 3 == 0) b.b = in_float(b.a + (a.b - a.a) * random.uniform(-2, 2));
        if (i % 7 == 0) b.b = b.a;
        Vec3 on_a, on_b;
        closest_points(a, b, on_a, on_b);
        const test::Hull hull_a{{a.a, a.b}, {{0, 1}}, {}, 0};
        const test::Hull hull_b{{b.a, b.b}, {{0, 1}}, {}, 0};
        const double expected = std::max<double>(test::gap(hull_a, hull_b).gap, 0);
        // Points are rounded to 2^-53 of their coordinates, a few times. A gap along an axis never
        // exceeds the distance, but the twin's axis is itself rounded: by an angle of 2^-52 over that
        // of nearly parallel segments, or over the distance of an end. The ends give another limit.
        const double rounding = 0x1p-50 * (offset + 4);
        const double angle = length(cross(a.b - a.a, b.b - b.a)) / (1e-300 + distance(a.a, a.b) * distance(b.a, b.b));
        const double answer = distance(on_a, on_b);
        REQUIRE(answer >= expected - rounding);
        const double lever = std::min(angle, answer);
        REQUIRE((lever == 0 || answer <= expected + rounding + 0x1p-48 / lever));
        for (const Vec3& end : {a.a, a.b}) REQUIRE(answer <= distance(end, closest_point(b, end)) + rounding);
        for (const Vec3& end : {b.a, b.b}) REQUIRE(answer <= distance(end, closest_point(a, end)) + rounding);
        REQUIRE(distance(closest_point(a, on_a), on_a) <= rounding);
        REQUIRE(distance(closest_point(b, on_b), on_b) <= rounding);
    }
}

TEST_CASE("parallel segments answer with the first point along the first") {
    Vec3 on_a, on_b;
    closest_points({{0, 0, 0}, {4, 0, 0}}, {{3, 1, 0}, {1, 1, 0}}, on_a, on_b);
    REQUIRE(on_a == Vec3{1, 0, 0});
    REQUIRE(on_b == Vec3{1, 1, 0});
    closest_points({{0, 0, 0}, {4, 0, 0}}, {{-3, 1, 0}, {9, 1, 0}}, on_a, on_b);
    REQUIRE(on_a == Vec3{0, 0, 0});
    closest_points({{0, 0, 0}, {4, 0, 0}}, {{9, 1, 0}, {6, 1, 0}}, on_a, on_b);
    REQUIRE(on_a == Vec3{4, 0, 0});
    REQUIRE(on_b == Vec3{6, 1, 0});
}

TEST_CASE("planes and rays answer with the foot of the perpendicular") {
    test::Random random(6);
    for (int i = 0; i < 20000; ++i) {
        const Plane plane{widen(random.point(3)), random.uniform(-5, 5)};
        const Vec3 point = widen(random.point(10)), foot = closest_point(plane, point);
        REQUIRE(std::fabs(dot(plane.normal, foot) - plane.distance) <= 1e-13);
        REQUIRE(length(cross(point - foot, plane.normal)) <= 1e-13);
        const Ray ray{widen(random.point(3)), widen(random.point(3)), random.uniform(0, 3)};
        const Vec3 on_ray = closest_point(ray, point);
        const Segment same{ray.origin, ray.origin + ray.direction * ray.t_max};
        REQUIRE(distance(on_ray, closest_point(same, point)) <= 1e-13);
    }
}

TEST_CASE("lengths from 1e-30 to 1e15 neither overflow nor vanish") {
    for (double size : {1e-30, 1e-10, 1.0, 1e15}) {
        const Triangle triangle{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
        const Vec3 foot{size / 4, size / 4, 0};
        REQUIRE(distance(closest_point(triangle, foot + Vec3{0, 0, size}), foot) <= 0x1p-51 * size);
        REQUIRE(contains(triangle, {size / 4, size / 4, 0}, 0));
        REQUIRE_FALSE(contains(triangle, {size / 4, size / 4, 1e-45}, 0));
        REQUIRE(contains(Sphere{{0, 0, 0}, size}, {0, size, 0}, 0));
        REQUIRE_FALSE(contains(Sphere{{0, 0, 0}, size}, {1e-45, size, 0}, 0));
        REQUIRE(contains(Capsule{{0, 0, 0}, {1e15, 0, 0}, size}, {5e14, size, 0}, 0));
        REQUIRE_FALSE(contains(Capsule{{0, 0, 0}, {1e15, 0, 0}, size}, {5e14, size, 1e-40}, 0));
        REQUIRE(overlaps(triangle, Triangle{{size / 4, size / 4, 0}, {1e15, 1e15, 1e15}, {0, 0, 1e15}}));
        REQUIRE_FALSE(overlaps(triangle, Triangle{{size / 4, size / 4, 1e-45}, {1e15, 1e15, 1e15}, {0, 0, 1e15}}));
    }
}

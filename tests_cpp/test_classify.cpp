// Sides of planes and frusta: the book's defect, and every shape beside its corners.
#include "geometry/intersect.h"

#include "convex_hull.h"
#include "test.h"

using namespace gphys;

namespace {

Mat3 rotation_about_z(double angle) {
    return {{std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
}

struct Specimen {
    Shape shape;
    test::Hull hull;
};
template <class T>
Specimen specimen(const T& shape) {
    return {shape, test::hull(shape)};
}

Specimen make(test::Random& random, int kind) {
    const Vec3 center = widen(random.point(2));
    const auto size = [&] { return random.uniform(.01, 1); };
    switch (kind) {
        case 0:
            return specimen(Sphere{center, size()});
        case 1:
            return specimen(Capsule{center, widen(random.point(2)), size()});
        case 2: {
            const Vec3 half{size(), size(), size()};
            return specimen(Aabb{center - half, center + half});
        }
        case 3:
            return specimen(Obb{center, {size(), size(), size()}, rotation_matrix(widen(random.rotation()))});
        default:
            return specimen(Triangle{center, widen(random.point(2)), widen(random.point(2))});
    }
}

/// Lowest and highest dot(normal, x - origin) - distance, over |normal|.
std::pair<double, double> range(const test::Hull& hull, const Plane& plane, Vec3 origin) {
    double low = INFINITY, high = -INFINITY;
    const Vec3 normal = plane.normal;
    const double size = length(normal);
    for (const Vec3& corner : hull.corners) {
        const double height = (dot(normal, corner - origin) - plane.distance) / size;
        low = std::min(low, height - hull.radius);
        high = std::max(high, height + hull.radius);
    }
    return {low, high};
}

}  // namespace

TEST_CASE("a turned box is classified by its axes, not by their transpose") {
    // Long and thin, along (cos 30, sin 30): the transposed orientation would point it downward.
    const Obb box{{0, 0, 0}, {10, .1, .1}, rotation_about_z(pi / 6)};
    const Plane beside{{-std::sin(pi / 6), std::cos(pi / 6), 0}, .5};
    double distance = 0;
    REQUIRE(classify(box, beside, distance) == Side::outside);
    REQUIRE(std::fabs(distance + .4) < 1e-15);
    const Plane across{{-std::sin(-pi / 6), std::cos(-pi / 6), 0}, .5};
    REQUIRE(classify(box, across, distance) == Side::crossing);
    REQUIRE(distance == 0);
}

TEST_CASE("sides and distances to planes agree with those of the corners") {
    test::Random random(1);
    int sides[3] = {};
    for (int i = 0; i < 100000; ++i) {
        const Specimen s = make(random, i % 5);
        const Plane plane{widen(random.point(2)), random.uniform(-3, 3)};
        const auto [low, high] = range(s.hull, plane, {});
        double distance = 7;
        const Side side = classify(s.shape, plane, distance);
        ++sides[static_cast<int>(side) + 1];
        // A dozen roundings of 2^-53 of numbers up to 10.
        const double band = 1e-14;
        if (low > band || high < -band) {
            REQUIRE(side == (low > 0 ? Side::inside : Side::outside));
            REQUIRE(std::fabs(distance - (low > 0 ? low : high)) < band);
        } else if (low < -band && high > band) {
            REQUIRE(side == Side::crossing);
            REQUIRE(distance == 0);
        }
    }
    for (int count : sides) REQUIRE(count > 10000);
}

TEST_CASE("a shape that touches a plane crosses it, and one ulp away does not") {
    double distance = 0;
    const Plane floor{{0, 3, 0}, 3};
    const double up = 1 + 0x1p-23, down = 1 - 0x1p-24;
    REQUIRE(classify(Sphere{{5, 3, 5}, 2}, floor, distance) == Side::crossing);
    REQUIRE(classify(Sphere{{5, 2 + up, 5}, 2}, floor, distance) == Side::inside);
    REQUIRE(distance == 0x1p-23);
    REQUIRE(classify(Sphere{{5, down - 2, 5}, 2}, floor, distance) == Side::outside);
    REQUIRE(distance == -0x1p-24);
    REQUIRE(classify(Aabb{{0, 1, 0}, {1, 2, 1}}, floor, distance) == Side::crossing);
    REQUIRE(classify(Aabb{{0, up, 0}, {1, 2, 1}}, floor, distance) == Side::inside);
    REQUIRE(classify(Triangle{{0, 1, 0}, {1, 2, 0}, {0, 5, 1}}, floor, distance) == Side::crossing);
    REQUIRE(classify(Triangle{{0, down, 0}, {1, 0, 0}, {0, 0, 1}}, floor, distance) == Side::outside);
    REQUIRE(classify(Capsule{{0, 2, 0}, {9, 4, 0}, 1}, floor, distance) == Side::crossing);
    // A radius far below the ulp of the height: (h - r |n|) rounds to h, the answer must not.
    REQUIRE(classify(Sphere{{0, 1, 0}, 1e-30}, floor, distance) == Side::crossing);
}

TEST_CASE("a sphere at an irrational distance from a plane is on the side where its square is") {
    test::Random random(3);
    int inside = 0;
    for (int i = 0; i < 10000; ++i) {
        // The plane x + y = 0 touches a sphere at (x, 0, 0) if x^2 = 2 r^2: never, but the double
        // next to it differs by less than the rounding of either. Both squares fit 128-bit floats.
        const double radius = random.uniform(.1, 1);
        const double x = random.index(2) ? radius * std::sqrt(2.0) : std::nextafter(radius * std::sqrt(2.0), 0);
        const bool expected = __float128(x) * x > 2 * (__float128(radius) * radius);
        inside += expected;
        double distance = 0;
        REQUIRE((classify(Sphere{{x, 0, 0}, radius}, Plane{{1, 1, 0}, 0}, distance) == Side::inside) == expected);
        REQUIRE((distance > 0) == expected);
    }
    REQUIRE(inside > 1000);
    REQUIRE(inside < 9000);
}

TEST_CASE("a shape is inside a frustum if all of it is, outside if nothing is") {
    test::Random random(2);
    int sides[3] = {};
    for (int i = 0; i < 50000; ++i) {
        const Specimen s = make(random, i % 5);
        const double near = random.uniform(.01, 1);
        const bool infinite = random.index(3) == 0;
        const test::View view =
            test::view(widen(random.point(3)), rotation_matrix(widen(random.rotation())), random.uniform(.5, 2),
                       random.uniform(.5, 2), near, infinite ? 100 : near + random.uniform(.5, 6), infinite);
        double depth = INFINITY;  // how far inside all planes
        for (const Plane& plane : view.frustum.planes) {
            if (plane.normal == Vec3{}) continue;
            depth = std::min(depth, range(s.hull, plane, view.frustum.origin).first);
        }
        const double gap = test::gap(s.hull, view.hull).gap;
        if (std::fabs(depth) < 1e-12 || std::fabs(gap) < 1e-9) continue;
        const Side expected = depth > 0 ? Side::inside : gap > 0 ? Side::outside : Side::crossing;
        ++sides[static_cast<int>(expected) + 1];
        REQUIRE(classify(s.shape, view.frustum) == expected);
    }
    for (int count : sides) REQUIRE(count > 1000);
}

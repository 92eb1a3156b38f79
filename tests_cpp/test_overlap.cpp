// Overlaps: the book's defects by name, and every pair of convex shapes against support functions,
// at random and moved to within a hair of touching.
#include "geometry/intersect.h"

#include "convex_hull.h"
#include "shapes/halfspaces.h"
#include "test.h"

using namespace gphys;

namespace {

Aabb box_at(Vec3 center, Vec3 half) { return {center - half, center + half}; }

bool both_ways(const Shape& a, const Shape& b) {
    const bool result = overlaps(a, b);
    REQUIRE(overlaps(b, a) == result);
    return result;
}

Mat3 rotation_about(Vec3 axis, double angle) {
    const Vec3 v = axis * std::sin(angle / 2);
    return rotation_matrix(Quat{v.x, v.y, v.z, std::cos(angle / 2)});
}

}  // namespace

TEST_CASE("a sphere two units above a flat box does not overlap it") {
    REQUIRE_FALSE(both_ways(Sphere{{0, 3, 0}, .5}, box_at({}, {5, 1, 1})));
    REQUIRE(both_ways(Sphere{{0, 3, 0}, 2}, box_at({}, {5, 1, 1})));
}

TEST_CASE("touching counts for spheres as for boxes") {
    REQUIRE(both_ways(Sphere{{0, 0, 0}, 1}, Sphere{{3, 0, 0}, 2}));
    REQUIRE_FALSE(both_ways(Sphere{{0, 0, 0}, 1}, Sphere{{3.0000002384185791015625, 0, 0}, 2}));
    REQUIRE(both_ways(Aabb{{0, 0, 0}, {1, 1, 1}}, Aabb{{1, 1, 1}, {2, 2, 2}}));
    REQUIRE_FALSE(both_ways(Aabb{{0, 0, 0}, {1, 1, 1}}, Aabb{{1.00000011920928955078125, 1, 1}, {2, 2, 2}}));
}

TEST_CASE("oriented boxes far apart do not overlap") {
    const Mat3 tilted = rotation_about({0, 0, 1}, .3);
    REQUIRE_FALSE(both_ways(Obb{{0, 0, 0}, {1, 1, 1}, tilted}, Obb{{10, 0, 0}, {1, 1, 1}, {}}));
    REQUIRE(both_ways(Obb{{0, 0, 0}, {1, 1, 1}, tilted}, Obb{{2, 0, 0}, {1, 1, 1}, {}}));
}

TEST_CASE("a box turned by 15 degrees twice beside the corner of the unit box is a gap of .0566 away") {
    const double angle = pi / 12;
    const Mat3 about_x = rotation_about({1, 0, 0}, angle), about_y = rotation_about({0, 1, 0}, angle);
    for (const Mat3& axes : {Mat3{about_x * about_y.x, about_x * about_y.y, about_x * about_y.z},
                             Mat3{about_y * about_x.x, about_y * about_x.y, about_y * about_x.z}}) {
        const Obb turned{{2.04, 2.04, 0}, {1, 1, 1}, axes};
        const Aabb unit = box_at({}, {1, 1, 1});
        const bool apart = test::gap(test::hull(unit), test::hull(turned)).gap > 0;
        REQUIRE(both_ways(unit, turned) == !apart);
        REQUIRE(both_ways(as_obb(unit), turned) == !apart);
    }
}

TEST_CASE("coplanar triangles that lie apart do not overlap") {
    REQUIRE_FALSE(overlaps(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Triangle{{5, 5, 0}, {6, 5.5, 0}, {5.1, 7, 0}}));
    REQUIRE(overlaps(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Triangle{{.2, .2, 0}, {6, 5.5, 0}, {5.1, 7, 0}}));
    REQUIRE(overlaps(Triangle{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, Triangle{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}));
}

TEST_CASE("triangles of a centimetre that are .86 m apart do not overlap") {
    const Triangle a{{0, 0, 0}, {.01, 0, 0}, {0, .01, 0}};
    const Triangle b{{.5, .5, .5}, {.51, .5, .5}, {.5, .51, .501}};
    REQUIRE_FALSE(overlaps(a, b));
}

TEST_CASE("boxes parallel to the axes are exact whatever they are stored as") {
    // 0.1f + 0.2f is not a float; the faces touch exactly in real numbers only where they do.
    const Obb a{{0, 0, 0}, {.5, .5, .5}, {}};
    for (double step : {-0x1p-52, 0.0, 0x1p-52}) {
        const Obb b{{1 + step, 0, 0}, {.5, .5, .5}, {}};
        REQUIRE(both_ways(a, b) == (step <= 0));
        REQUIRE(both_ways(box_at({}, {.5, .5, .5}), b) == (step <= 0));
    }
    const Obb quarter{{0, 0, 0}, {3, 1, 1}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
    REQUIRE(both_ways(quarter, box_at({0, 3.5, 0}, {.5, .5, .5})));
    REQUIRE_FALSE(both_ways(quarter, box_at({1.5 + 0x1p-52, 0, 0}, {.5, .5, .5})));
}

TEST_CASE("parallel planes overlap only when they are the same") {
    REQUIRE(both_ways(Plane{{1, 2, 3}, 4}, Plane{{-2, -4, -6}, -8}));
    REQUIRE_FALSE(both_ways(Plane{{1, 2, 3}, 4}, Plane{{2, 4, 6}, 8.5}));
    REQUIRE(both_ways(Plane{{1, 2, 3}, 4}, Plane{{1, 2, 3.0000002384185791015625}, 4e9}));
}

TEST_CASE("no shape overlaps an empty frustum, however little it lacks to have a point") {
    const auto slab = [](double low, double high) {
        return Frustum{{},
                       {{{0, 0, 1}, low},
                        {{0, 0, -1}, -high},
                        {{1, 0, 0}, -1},
                        {{-1, 0, 0}, -1},
                        {{0, 1, 0}, -1},
                        {{0, -1, 0}, -1}}};
    };
    const Shape shapes[] = {Sphere{{0, 0, 2}, 2.5},
                            Capsule{{0, 0, 2}, {1, 0, 3}, 2.5},
                            Capsule{{3, 0, 0}, {3, 0, 1}, 4},
                            Capsule{{0, 3, -1}, {0, 3, 1}, 2.5},
                            box_at({}, {3, 3, 3}),
                            Obb{{0, 0, .5}, {1, 1, 1}, rotation_about({1, 0, 0}, .3)},
                            Plane{{0, 0, 1}, 0},
                            Triangle{{0, 0, -1}, {0, 0, 1}, {.5, .5, 0}}};
    for (const double lacks : {0x1p-60, 0x1p-50, 0x1p-45}) {
        for (const Shape& shape : shapes) {
            REQUIRE_FALSE(both_ways(shape, slab(lacks, 0)));
            REQUIRE(both_ways(shape, slab(-lacks, 0)));
        }
    }
}

namespace {

/// A random shape with its twin. Sizes from a thousandth to one, centres within one of the origin,
/// all multiples of 2^-20: then an offset of 2^20 is added without rounding.
struct Specimen {
    Shape shape;
    test::Hull hull;
};

template <class T>
Specimen specimen(const T& shape) {
    return {shape, test::hull(shape)};
}
double on_grid(double v, double step) { return std::rint(v / step) * step; }
Vec3 on_grid(Vec3 v, double step) { return {on_grid(v.x, step), on_grid(v.y, step), on_grid(v.z, step)}; }
Vec3 somewhere(test::Random& random) {
    return on_grid({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}, 0x1p-20);
}
double size(test::Random& random) { return on_grid(std::pow(10.0, random.uniform(-3, 0)), 0x1p-20); }

enum Kind { sphere, capsule, aabb, obb, triangle, frustum, kinds };

Specimen make(test::Random& random, int kind, bool may_be_infinite) {
    const Vec3 center = somewhere(random);
    const Mat3 axes = rotation_matrix(widen(random.rotation()));
    switch (kind) {
        case sphere:
            return specimen(Sphere{center, size(random)});
        case capsule:
            return specimen(Capsule{center, random.index(8) ? somewhere(random) : center, size(random)});
        case aabb:
            return specimen(box_at(center, {size(random), size(random), size(random)}));
        case obb:
            return specimen(Obb{center, {size(random), size(random), size(random)}, axes});
        case triangle:
            return specimen(Triangle{center, somewhere(random), somewhere(random)});
        default: {
            const double near = random.uniform(.01, .5);
            const bool infinite = random.index(3) == 0 && may_be_infinite;
            // Everything else is within 8 of the origin: for it, 100 is as good as infinity.
            const double far = infinite ? 100 : near + size(random);
            const test::View v =
                test::view(center, axes, random.uniform(.1, 2), random.uniform(.1, 2), near, far, infinite);
            return {v.frustum, v.hull};
        }
    }
}

test::Hull moved(test::Hull hull, Vec3 by) {
    for (Vec3& corner : hull.corners) corner = corner + by;
    return hull;
}

Shape shifted(const Shape& shape, Vec3 by) {
    return std::visit(
        [&](const auto& s) -> Shape {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, Aabb>) {
                return Aabb{s.min + by, s.max + by};
            } else {
                return transformed(s, Transform{by, {}, 1});
            }
        },
        shape);
}

}  // namespace

TEST_CASE("a capsule beside a corner of a frustum of 89.998 degrees overlaps it where it touches, and no earlier") {
    // Its sides meet the far plane at 2^-15. The corner (16, 16, 2^-11) is 1.25 from the axis of the capsule.
    const double slope = 0x1p15;
    const Frustum wide{{},
                       {{{0, 0, 1}, 0x1p-15},
                        {{0, 0, -1}, -0x1p-11},
                        {{1, 0, slope}, 0},
                        {{-1, 0, slope}, 0},
                        {{0, 1, slope}, 0},
                        {{0, -1, slope}, 0}}};
    const auto beside = [](double radius) { return Capsule{{16.75, 17, -1}, {16.75, 17, 1}, radius}; };
    REQUIRE(both_ways(wide, beside(1.25)));
    // Four times the documented band, 2^-40 of the largest coordinate difference.
    const double band = 0x1p-40 * 34;
    REQUIRE(both_ways(wide, beside(1.25 + band)));
    REQUIRE_FALSE(both_ways(wide, beside(1.25 - 4 * band)));
    REQUIRE_FALSE(both_ways(wide, beside(1.25 - 0x1p-22)));
}

TEST_CASE("a capsule overlaps a frustum that is only a point where it touches it, and no earlier") {
    // Three pairs of opposite planes through (1, 2, 3), none along an axis.
    const auto through = [](Vec3 normal) { return Plane{normal, dot(normal, Vec3{1, 2, 3})}; };
    const Vec3 u{1, 0.25, 0.125}, v{-0.25, 1, 0.375}, w{0.125, -0.375, 1};
    const Frustum point{{}, {through(w), through(-w), through(u), through(-u), through(v), through(-v)}};
    REQUIRE(both_ways(point, Capsule{{1.75, 3, -4}, {1.75, 3, 4}, 1.25}));
    REQUIRE_FALSE(both_ways(point, Capsule{{1.75, 3, -4}, {1.75, 3, 4}, 1.25 - 0x1p-36}));
}

TEST_CASE("all pairs of solids agree with support functions, at random and nearly touching") {
    test::Random random(1);
    for (int a = 0; a < kinds; ++a) {
        for (int b = a; b < kinds; ++b) {
            int overlapping = 0, decided = 0;
            for (int i = 0; i < test::tries(10000); ++i) {
                const Vec3 at = i % 4 ? Vec3{} : Vec3{65536, -4096, 1048576};
                const Specimen first = make(random, a, true);
                // Two infinite ones could meet beyond the end of their twins.
                const Specimen second = make(random, b, a != frustum);
                const test::Gap gap = test::gap(first.hull, second.hull);
                // Twice: as they are, and with the second moved along the axis of the gap until
                // only a hair is left, or that much too much.
                const double hair = std::pow(10.0, random.uniform(-9, -2)) * (random.index(2) ? 1 : -1);
                for (const double by : {0.0, hair - gap.gap}) {
                    const Vec3 move = on_grid(gap.axis * by, 0x1p-30);
                    const double left = by == 0 ? gap.gap : test::gap(first.hull, moved(second.hull, move)).gap;
                    // Both sides are decided to 2^-40 of the extent, 100 at most.
                    if (std::fabs(left) < 1e-9) continue;
                    ++decided;
                    const bool expected = left < 0;
                    overlapping += expected;
                    const Shape one = shifted(first.shape, at), other = shifted(second.shape, at + move);
                    const bool result = overlaps(one, other);
                    if (result != expected) FAIL("kinds " << a << " " << b << " case " << i << " gap " << left);
                    if (i % 64 == 0) REQUIRE(overlaps(other, one) == result);
                }
            }
            REQUIRE(decided > test::tries(10000));
            REQUIRE(overlapping > decided / 50);
        }
    }
}

#include "ray_cases.h"

using namespace gphys;
using namespace test;

namespace {

constexpr int cases = 100000;

/// What the references say: where the line is inside the solid.
struct Interval {
    Quad first = 0, last = 0;
    bool empty = true;
};

bool hits(const Interval& interval, const Ray& ray) {
    return !interval.empty && interval.last >= 0 && (ray.t_max == infinity || interval.first <= Quad(ray.t_max));
}

/// Slabs, with the axes of an Obb or the world's.
Interval box_interval(QVec3 origin, QVec3 direction, QVec3 low, QVec3 high) {
    Interval result{Quad(-1e300), Quad(1e300), false};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < low[axis] || origin[axis] > high[axis]) result.empty = true;
            continue;
        }
        Quad a = (low[axis] - origin[axis]) / direction[axis], b = (high[axis] - origin[axis]) / direction[axis];
        if (a > b) std::swap(a, b);
        if (a > result.first) result.first = a;
        if (b < result.last) result.last = b;
    }
    result.empty = result.empty || result.first > result.last;
    return result;
}

Interval sphere_interval(QVec3 center, Quad radius, const Ray& ray) {
    const QVec3 d(ray.direction), from = QVec3(ray.origin) - center;
    const Quad a = dot(d, d), b = dot(from, d), c = dot(from, from) - radius * radius;
    const Quad discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const Quad root = square_root(discriminant);
    return {(-b - root) / a, (-b + root) / a, false};
}

/// The union of two balls and the cylinder between the planes of its ends.
Interval capsule_interval(const Capsule& capsule, const Ray& ray) {
    Interval result;
    const auto include = [&](const Interval& part) {
        if (part.empty) return;
        if (result.empty || part.first < result.first) result.first = part.first;
        if (result.empty || part.last > result.last) result.last = part.last;
        result.empty = false;
    };
    include(sphere_interval(capsule.a, capsule.radius, ray));
    include(sphere_interval(capsule.b, capsule.radius, ray));
    const QVec3 axis = QVec3(capsule.b) - QVec3(capsule.a);
    const Quad aa = dot(axis, axis);
    if (aa == 0) return result;
    const QVec3 from = QVec3(ray.origin) - QVec3(capsule.a), d(ray.direction);
    // Without their parts along the axis.
    const QVec3 flat_from = from - axis * (dot(from, axis) / aa), flat_d = d - axis * (dot(d, axis) / aa);
    const Quad radius(capsule.radius), a = dot(flat_d, flat_d), b = dot(flat_from, flat_d);
    const Quad c = dot(flat_from, flat_from) - radius * radius;
    Interval side{Quad(-1e300), Quad(1e300), false};
    if (a > 0) {
        const Quad discriminant = b * b - a * c;
        if (discriminant < 0) return result;
        side = {(-b - square_root(discriminant)) / a, (-b + square_root(discriminant)) / a, false};
    } else if (c > 0) {
        return result;
    }
    const Quad slope = dot(d, axis), start = dot(from, axis);
    if (slope != 0) {
        Quad in = -start / slope, out = (aa - start) / slope;
        if (in > out) std::swap(in, out);
        if (in > side.first) side.first = in;
        if (out < side.last) side.last = out;
    } else if (start < 0 || start > aa) {
        return result;
    }
    if (side.first <= side.last) include(side);
    return result;
}

Interval frustum_interval(const Frustum& frustum, const Ray& ray) {
    Interval result{Quad(-1e300), Quad(1e300), false};
    for (const Plane& plane : frustum.planes) {
        const Quad climb = dot(QVec3(plane.normal), QVec3(ray.direction));
        const Quad depth = dot(QVec3(plane.normal), QVec3(ray.origin) - QVec3(frustum.origin)) - Quad(plane.distance);
        if (climb == 0) {
            if (depth < 0) result.empty = true;
        } else if (climb > 0) {
            if (-depth / climb > result.first) result.first = -depth / climb;
        } else if (-depth / climb < result.last) {
            result.last = -depth / climb;
        }
    }
    result.empty = result.empty || result.first > result.last;
    return result;
}

/// Counts the differences from a reference and keeps the largest error of t.
struct Comparison {
    int hit_count = 0, miss_count = 0, false_answers = 0, unsound = 0;
    double worst_ulps = 0;

    void add(bool hit_found, const Hit& hit, const Ray& ray, const Interval& truth) {
        const bool expected = hits(truth, ray);
        if (hit_found != expected) {
            ++false_answers;
            return;
        }
        ++(expected ? hit_count : miss_count);
        if (!expected) return;
        const bool inside = truth.first <= 0;
        unsound += !is_sound(hit, ray) || inside != ((hit.flags & GPHYS_HIT_INSIDE) != 0);
        worst_ulps = std::max(worst_ulps, float_ulps(hit.t, inside ? Quad(0) : truth.first));
    }
};

#define CHECK_COMPARISON(comparison, ulps)                                                                 \
    do {                                                                                                   \
        INFO("hits " << comparison.hit_count << ", misses " << comparison.miss_count << ", worst t error " \
                     << comparison.worst_ulps << " ulp");                                                  \
        CHECK(comparison.false_answers == 0);                                                              \
        CHECK(comparison.unsound == 0);                                                                    \
        CHECK(comparison.worst_ulps <= ulps);                                                              \
        CHECK(comparison.hit_count > cases / 50);                                                          \
        CHECK(comparison.miss_count > cases / 50);                                                         \
    } while (0)

/// A ray from around a place to a point near or on what is there; t_max often ends at it.
Ray ray_at(Random& random, Vec3 target, double distance) {
    const Vec3 origin = on_lattice(target + random.direction() * distance);
    return {origin, target - origin, random.index(4) == 0 ? random.uniform(0.5, 1.5) : infinity};
}

Ray grid_ray(Random& random) {
    const Vec3 origin = grid_point(random, 5);
    return {origin, grid_direction(random, 3), random.index(2) == 0 ? 0.5 * random.index(8) : infinity};
}

/// How far the ray's line is from being a tangent of a ball, as part of the distance.
bool is_tangent(QVec3 center, Quad radius, const Ray& ray) {
    const QVec3 d(ray.direction), from = QVec3(ray.origin) - center;
    const QVec3 perpendicular = from - d * (dot(from, d) / dot(d, d));
    return absolute(length(perpendicular) - radius) <= Quad(0x1p-48) * (length(from) + radius);
}

}  // namespace

TEST_CASE("raycast: a sphere behind the ray is not hit", "[raycast]") {
    Hit hit;
    CHECK_FALSE(raycast(Sphere{{0, 0, -5}, 1}, Ray{{0, 0, 0}, {0, 0, 1}}, hit));
}

TEST_CASE("raycast: a unit sphere is missed by half a unit from ten thousand away", "[raycast]") {
    Hit hit;
    CHECK_FALSE(raycast(Sphere{{0, 0, 0}, 1}, Ray{{1.5, 0, -1e4}, {0, 0, 1}}, hit));
}

TEST_CASE("raycast: a sphere is met at the right t from ten thousand away", "[raycast]") {
    Hit hit;
    const double x = 0.9f;
    REQUIRE(raycast(Sphere{{0, 0, 0}, 1}, Ray{{x, 0, -1e4}, {0, 0, 1}}, hit));
    CHECK(float_ulps(hit.t, Quad(1e4) - square_root(1 - Quad(x) * Quad(x))) < 0.02);
}

TEST_CASE("raycast: a direction component of zero stays zero", "[raycast]") {
    Hit hit;
    const Aabb thin{{-1, -.001, 999}, {1, .001, 1001}};
    REQUIRE(raycast(thin, Ray{{0, 0, 0}, {0, 0, 1}}, hit));
    CHECK(hit.t == 999);
    CHECK(raycast(thin, Ray{{0, .001, 0}, {0, 0, 1}}, hit));
    CHECK_FALSE(raycast(thin, Ray{{0, .0011, 0}, {0, 0, 1}}, hit));
}

TEST_CASE("raycast: a segment inside a box hits it", "[raycast]") {
    Hit hit;
    const Ray inside = ray_along(Segment{{-.5, 0, 0}, {.5, 0, 0}});
    for (const Shape& shape : {Shape(Aabb{{-1, -1, -1}, {1, 1, 1}}), Shape(Obb{{0, 0, 0}, {1, 1, 1}, Mat3{}}),
                               Shape(Sphere{{0, 0, 0}, 1}), Shape(Capsule{{0, 0, 0}, {0, 1, 0}, 1})}) {
        REQUIRE(raycast(shape, inside, hit));
        CHECK(hit.t == 0);
        CHECK(hit.flags == GPHYS_HIT_INSIDE);
        CHECK(hit.normal == Vec3{-1, 0, 0});
        CHECK(hit.point == inside.origin);
    }
}

TEST_CASE("raycast: a segment in a plane hits it", "[raycast]") {
    Hit hit;
    REQUIRE(raycast(Plane{{0, 2, 0}, 2}, ray_along(Segment{{0, 1, 0}, {3, 1, 0}}), hit));
    CHECK(hit.t == 0);
    CHECK(hit.normal == Vec3{0, 1, 0});
    CHECK_FALSE(raycast(Plane{{0, 2, 0}, 2}, ray_along(Segment{{0, 2, 0}, {3, 2, 0}}), hit));
}

TEST_CASE("raycast: the normal is that of the face entered, on a thin box hit from far", "[raycast]") {
    Hit hit;
    const Aabb thin{{-100, -100, -.0001}, {100, 100, .0001}};
    for (const double z : {1e4, 1e6, 1e7}) {
        REQUIRE(raycast(thin, Ray{{-z, 3, -z}, {1, 0, 1}}, hit));
        CHECK(hit.normal == Vec3{0, 0, -1});
        CHECK(hit.point.z == -.0001);
    }
    REQUIRE(raycast(Aabb{{-1, -1, -1}, {1, 1, 1}}, Ray{{-3, -3, -3}, {1, 1, 1}}, hit));
    CHECK(hit.normal == Vec3{-1, 0, 0});  // a tie: the lowest axis
}

TEST_CASE("raycast: touching counts at both ends of a segment", "[raycast]") {
    Hit hit;
    const Segment outside{{-3, 0, 0}, {-1, 0, 0}};
    const Segment reversed{outside.b, outside.a};
    for (const Shape& shape :
         {Shape(Aabb{{-1, -1, -1}, {1, 1, 1}}), Shape(Sphere{{0, 0, 0}, 1}), Shape(Obb{{0, 0, 0}, {1, 1, 1}, Mat3{}}),
          Shape(Plane{{1, 0, 0}, -1}), Shape(Capsule{{0, 0, 0}, {0, 1, 0}, 1}),
          Shape(Triangle{{-1, -1, -1}, {-1, 1, -1}, {-1, 0, 1}})}) {
        REQUIRE(raycast(shape, ray_along(outside), hit));
        CHECK(hit.t == 1);
        REQUIRE(raycast(shape, ray_along(reversed), hit));
        CHECK(hit.t == 0);
        CHECK((hit.flags & GPHYS_HIT_INSIDE) != 0);
        CHECK_FALSE(raycast(shape, ray_along(Segment{outside.a, {-1.0000001, 0, 0}}), hit));
    }
}

TEST_CASE("raycast: a ray of no length asks whether its origin is contained", "[raycast]") {
    const NoTraps watch;
    Hit hit;
    for (const Shape& shape :
         {Shape(Aabb{{-1, -1, -1}, {1, 1, 1}}), Shape(Sphere{{0, 0, 0}, 1}), Shape(Obb{{0, 0, 0}, {1, 1, 1}, Mat3{}}),
          Shape(Plane{{1, 0, 0}, -1}), Shape(Capsule{{0, 0, 0}, {0, 1, 0}, 1}),
          Shape(Triangle{{-1, -1, -1}, {-1, 1, -1}, {-1, 0, 1}})}) {
        REQUIRE(raycast(shape, Ray{{-1, 0, 0}, {0, 0, 0}, 1}, hit));
        CHECK(hit.t == 0);
        CHECK(hit.point == Vec3{-1, 0, 0});
        CHECK_FALSE(raycast(shape, Ray{{-2, 0, 0}, {0, 0, 0}, 1}, hit));
    }
}

// Boxes are exact: no false answer, and t = (face - origin) / direction has two roundings in
// double, 2^-52 of t, which is 2^-28 ulp of a float.
TEST_CASE("raycast: boxes agree with slabs in quadruple precision", "[raycast]") {
    const NoTraps watch;
    Random random(1);
    Comparison grid, general;
    for (int i = 0; i < cases; ++i) {
        const Vec3 p = grid_point(random, 2), q = grid_point(random, 2);
        const Aabb box{min(p, q), max(p, q)};
        const Ray ray = grid_ray(random);
        Hit hit;
        const bool found = raycast(box, ray, hit);
        grid.add(found, hit, ray, box_interval(ray.origin, ray.direction, box.min, box.max));
    }
    CHECK_COMPARISON(grid, 0x1p-27);
    for (int i = 0; i < cases; ++i) {
        const Vec3 corner = on_lattice(random_point(random, 1)), size = abs(on_lattice(random_point(random, 1)));
        const Aabb box{corner, corner + size};
        Vec3 target = corner + on_lattice(Vec3{size.x * random.uniform(-.5, 1.5), size.y * random.uniform(-.5, 1.5),
                                               size.z * random.uniform(-.5, 1.5)});
        // Often exactly at a face, an edge or a corner.
        for (int axis = 0; axis < 3; ++axis) {
            if (random.index(3) == 0) target[axis] = box.min[axis];
            if (random.index(3) == 0) target[axis] = box.max[axis];
        }
        const Ray ray = ray_at(random, target, std::pow(10, random.uniform(-2, 3)));
        Hit hit;
        const bool found = raycast(box, ray, hit);
        general.add(found, hit, ray, box_interval(ray.origin, ray.direction, box.min, box.max));
    }
    CHECK_COMPARISON(general, 0x1p-27);
}

TEST_CASE("raycast: the edge of a box is met or missed by less than a rounding", "[raycast]") {
    const NoTraps watch;
    Random random(8);
    int wrong = 0, rounded_alike = 0;
    for (int i = 0; i < cases / 10; ++i) {
        // n / d and m / e are neighbours among fractions: n e - m d = 1 (Euclid).
        const int64_t d = (1 << 29) + random.index(1 << 29), e = (1 << 29) + random.index(1 << 29);
        int64_t n = 0, next_n = 1, m = 1, next_m = 0, rest = d, divisor = e;
        while (divisor != 0) {
            const int64_t quotient = rest / divisor;
            rest -= quotient * divisor, n -= quotient * next_n, m -= quotient * next_m;
            std::swap(rest, divisor), std::swap(n, next_n), std::swap(m, next_m);
        }
        if (rest != 1) continue;
        m = -m;
        while (n <= 0 || m <= 0) n += d, m += e;
        const double x = static_cast<double>(n), y = static_cast<double>(m);
        const Vec3 direction{static_cast<double>(d), static_cast<double>(e), 0};
        // Enters at x, leaves at y, 1 / (d e) too late; and the other way round, just in time.
        Hit hit;
        wrong += raycast(Aabb{{x, -1, -1}, {4 * x, y, 1}}, Ray{{0, 0, 0}, direction}, hit);
        wrong += !raycast(Aabb{{-1, y, -1}, {x, 4 * y, 1}}, Ray{{0, 0, 0}, direction}, hit);
        rounded_alike += x / direction.x == y / direction.y;
    }
    CHECK(wrong == 0);
    CHECK(rounded_alike > cases / 20);
}

// The rotation into the box's axes costs a few roundings of the distance D, so answers within
// 2^-40 of it may differ, and t is off by some 2^-49 D / (t |direction| cos(angle to the face)).
TEST_CASE("raycast: turned boxes agree with slabs in quadruple precision", "[raycast]") {
    const NoTraps watch;
    Random random(2);
    Comparison comparison;
    for (int i = 0; i < cases; ++i) {
        const double distance = std::pow(10, random.uniform(0, 6));
        const Obb box{on_lattice(random_point(random, 100)), abs(random_point(random, 1)) + Vec3{.01, .01, .01},
                      rotation_matrix(widen(random.rotation()))};
        const Vec3 local{1.5 * box.half.x * random.uniform(-1, 1), 1.5 * box.half.y * random.uniform(-1, 1),
                         1.5 * box.half.z * random.uniform(-1, 1)};
        const Ray ray = ray_at(random, box.center + box.axes * local, distance);
        const QVec3 from = QVec3(ray.origin) - QVec3(box.center), d(ray.direction);
        const auto turned = [&](QVec3 v) {
            return QVec3{dot(v, QVec3(box.axes.x)), dot(v, QVec3(box.axes.y)), dot(v, QVec3(box.axes.z))};
        };
        const auto grown = [&](double by) {
            const Vec3 half = box.half + Vec3{by, by, by};
            return box_interval(turned(from), turned(d), -half, half);
        };
        const double band = 0x1p-40 * distance;
        if (hits(grown(-band), ray) != hits(grown(band), ray)) continue;
        Hit hit;
        const bool found = raycast(box, ray, hit);
        comparison.add(found, hit, ray, grown(0));
    }
    CHECK_COMPARISON(comparison, 0.02);
}

// A sphere's numbers have a relative error below 2^-29 wherever they enter t, 2^-6 ulp of a float;
// only the end of a ray is taken 2^-48 generously.
TEST_CASE("raycast: spheres agree with the quadratic formula in quadruple precision", "[raycast]") {
    const NoTraps watch;
    Random random(3);
    Comparison grid, general;
    for (int i = 0; i < cases; ++i) {
        const Sphere sphere{grid_point(random, 3), static_cast<double>(random.index(4))};
        const Ray ray = grid_ray(random);
        Hit hit;
        const bool found = raycast(sphere, ray, hit);
        grid.add(found, hit, ray, sphere_interval(sphere.center, sphere.radius, ray));
    }
    CHECK_COMPARISON(grid, 0x1p-5);
    for (int i = 0; i < cases; ++i) {
        const Sphere sphere{on_lattice(random_point(random, 100)), on_lattice(std::pow(10, random.uniform(-3, 2)))};
        // Half of the rays are aimed at the rim.
        const double aside = random.index(2) == 0 ? 1 + std::pow(10, random.uniform(-14, -1)) : random.uniform(0, 1.5);
        Ray ray = ray_at(random, sphere.center, std::pow(10, random.uniform(-2, 4)) + sphere.radius);
        ray.origin += on_lattice(perpendicular(normalized(ray.direction)) * (aside * sphere.radius));
        if (is_tangent(sphere.center, sphere.radius, ray)) continue;
        Hit hit;
        const bool found = raycast(sphere, ray, hit);
        general.add(found, hit, ray, sphere_interval(sphere.center, sphere.radius, ray));
    }
    CHECK_COMPARISON(general, 0x1p-5);
    // From just above the surface towards the rim c and the discriminant are small differences.
    int false_answers = 0;
    double worst_ulps = 0;
    for (int i = 0; i < cases; ++i) {
        const Sphere sphere{{0, -1, 0}, 1};
        const double height = std::pow(10, random.uniform(-14, 0));
        const double steepness = 1 + std::pow(10, random.uniform(-12, 2));
        const Ray ray{{0, height, 0}, {1, -std::sqrt(height * (2 + height)) * steepness, 0}};
        const Interval truth = sphere_interval(sphere.center, sphere.radius, ray);
        Hit hit;
        const bool found = raycast(sphere, ray, hit);
        false_answers += found != hits(truth, ray);
        if (found) worst_ulps = std::max(worst_ulps, float_ulps(hit.t, truth.first));
    }
    INFO("worst t error at the rim " << worst_ulps << " ulp");
    CHECK(false_answers == 0);
    CHECK(worst_ulps <= 0x1p-5);
}

TEST_CASE("raycast: the normal on a round shape is right although its radius is less than a rounding of the way there",
          "[raycast]") {
    Hit hit;
    const auto expect = [&](const Shape& shape, const Ray& ray, Vec3 normal) {
        REQUIRE(raycast(shape, ray, hit));
        // As far as 2^21 radii away the ray's point at t may be off by 2^-30 of the radius, beyond by less.
        CHECK(length(hit.normal - normal) <= 0x1p-30);
        CHECK(dot(hit.normal, ray.direction) <= 0);
    };
    // 3, 4, 5 in a plane across the axis.
    for (const double size : {1.0, 0x1p-60, 0x1p-140}) {
        for (const double far : {0x1p22, 0x1p48}) {
            for (const double speed : {1.0, 0x1p-20, 0x1p30 / 3}) {
                const Ray ray{{-far, 3 * size, 0}, {speed, 0, 0}, infinity};
                expect(Sphere{{}, 5 * size}, ray, {-.8, .6, 0});
                expect(Capsule{{0, 0, -far}, {0, 0, far}, 5 * size}, ray, {-.8, .6, 0});
                // Tangents.
                expect(Sphere{{}, 3 * size}, ray, {0, 1, 0});
                expect(Capsule{{0, 0, -far}, {0, 0, far}, 3 * size}, ray, {0, 1, 0});
            }
        }
    }
    // A segment whose b - a is not a double.
    const Ray segment = ray_along({{-0x1p48, 0x1p-60, 0}, {0x1p-60, 0x1p-60, 0}});
    expect(Sphere{{-1, 0, 0}, 0x1p-60}, segment, {0, 1, 0});
}

TEST_CASE("raycast: capsules agree with cylinder and balls in quadruple precision", "[raycast]") {
    const NoTraps watch;
    Random random(4);
    Comparison comparison;
    for (int i = 0; i < cases; ++i) {
        Capsule capsule{on_lattice(random_point(random, 10)), {}, on_lattice(std::pow(10, random.uniform(-3, 1)))};
        capsule.b = random.index(20) == 0 ? capsule.a : capsule.a + on_lattice(random_point(random, 5));
        const double distance = std::pow(10, random.uniform(-1, 6)) + capsule.radius;
        const Vec3 target = capsule.a + (capsule.b - capsule.a) * random.uniform(-.3, 1.3) +
                            random.direction() * (2 * capsule.radius * random.uniform(0, 1));
        const Ray ray = ray_at(random, target, distance);
        const double band = 0x1p-44 * distance;
        const auto grown = [&](double by) {
            return capsule_interval(Capsule{capsule.a, capsule.b, capsule.radius + by}, ray);
        };
        if (hits(grown(-band), ray) != hits(grown(band), ray)) continue;
        if ((grown(-band).first <= 0) != (grown(band).first <= 0)) continue;
        Hit hit;
        const bool found = raycast(capsule, ray, hit);
        comparison.add(found, hit, ray, grown(0));
    }
    CHECK_COMPARISON(comparison, 0.1);
}

TEST_CASE("raycast: capsules are met exactly where the grid says", "[raycast]") {
    Hit hit;
    const Capsule upright{{0, 0, 0}, {0, 4, 0}, 2};
    REQUIRE(raycast(upright, Ray{{-5, 2, 0}, {1, 0, 0}}, hit));  // side
    CHECK(hit.t == 3);
    CHECK(hit.normal == Vec3{-1, 0, 0});
    REQUIRE(raycast(upright, Ray{{0, 9, 0}, {0, -1, 0}}, hit));  // along the axis
    CHECK(hit.t == 3);
    REQUIRE(raycast(upright, Ray{{2, 9, 0}, {0, -1, 0}}, hit));  // along the side
    CHECK(hit.t == 5);
    REQUIRE(raycast(upright, Ray{{-5, 1, 2}, {1, 0, 0}}, hit));  // tangent to the side
    CHECK(hit.t == 5);
    CHECK_FALSE(raycast(upright, Ray{{-5, 1, 2.0000002}, {1, 0, 0}}, hit));
    REQUIRE(raycast(Capsule{{0, 0, 0}, {0, 4, 0}, 0}, Ray{{-5, 2, 0}, {1, 0, 0}}, hit));  // a segment
    CHECK(hit.t == 5);
    CHECK(hit.normal == Vec3{-1, 0, 0});
}

TEST_CASE("raycast: planes agree with quadruple precision", "[raycast]") {
    const NoTraps watch;
    Random random(5);
    double worst_ulps = 0;
    int false_answers = 0, unsound = 0;
    for (int i = 0; i < cases; ++i) {
        const bool grid = i % 2 == 0;
        const Plane plane{grid ? grid_direction(random, 3) : on_lattice(random.direction()),
                          grid ? static_cast<double>(random.index(7)) - 3 : on_lattice(random.uniform(-1e3, 1e3))};
        const Ray ray = grid ? grid_ray(random) : ray_at(random, on_lattice(random_point(random, 1e3)), 1e3);
        const Quad start = dot(QVec3(plane.normal), QVec3(ray.origin)) - Quad(plane.distance);
        const Quad climb = dot(QVec3(plane.normal), QVec3(ray.direction));
        const Quad t = start == 0 ? 0 : climb == 0 ? -1 : -start / climb;
        const bool expected = t >= 0 && (ray.t_max == infinity || t <= Quad(ray.t_max));
        Hit hit;
        const bool found = raycast(plane, ray, hit);
        false_answers += found != expected;
        if (!found || !expected) continue;
        unsound +=
            !is_sound(hit, ray) || ((hit.flags & GPHYS_HIT_BACK) != 0) != (start < 0 || (start == 0 && climb > 0));
        worst_ulps = std::max(worst_ulps, float_ulps(hit.t, t));
    }
    CHECK(false_answers == 0);
    CHECK(unsound == 0);
    // Two numbers with 2^-44 and a quotient: 2^-20 ulp of a float.
    CHECK(worst_ulps <= 0x1p-18);
}

TEST_CASE("raycast: frusta agree with clipping in quadruple precision", "[raycast]") {
    const NoTraps watch;
    Random random(6);
    Comparison comparison;
    for (int i = 0; i < cases; ++i) {
        const double slope_x = on_lattice(random.uniform(.1, 2)), slope_y = on_lattice(random.uniform(.1, 2));
        Frustum frustum{on_lattice(random_point(random, 100)),
                        {{{0, 0, 1}, 1},
                         {{0, 0, -1}, -20},
                         {{1, 0, slope_x}, 0},
                         {{-1, 0, slope_x}, 0},
                         {{0, 1, slope_y}, 0},
                         {{0, -1, slope_y}, 0}}};
        if (random.index(2) == 0) frustum.planes[1] = {{0, 0, 0}, -1};  // infinite
        Ray ray = ray_at(
            random,
            frustum.origin + on_lattice(Vec3{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-3, 23)}),
            std::pow(10, random.uniform(0, 3)));
        if (random.index(4) == 0) ray.direction = grid_direction(random, 1);
        const Interval truth = frustum_interval(frustum, ray);
        // Rays along an edge, within 2^-40 of the coordinates.
        if (absolute(truth.first - truth.last) * length(QVec3(ray.direction)) < Quad(0x1p-40) * 1000) continue;
        if (absolute(truth.first - Quad(std::min(ray.t_max, 1e30))) < Quad(0x1p-40)) continue;
        Hit hit;
        const bool found = raycast(frustum, ray, hit);
        comparison.add(found, hit, ray, truth);
    }
    CHECK_COMPARISON(comparison, 0x1p-16);
}

TEST_CASE("raycast: a far-off origin and the largest coordinates raise no exception", "[raycast]") {
    const NoTraps watch;
    Random random(7);
    for (int i = 0; i < 20000; ++i) {
        const auto number = [&] {
            const double magnitude = std::pow(10, random.uniform(-44, 15));
            return random.index(8) == 0
                       ? 0.0
                       : static_cast<double>(static_cast<float>(random.index(2) ? magnitude : -magnitude));
        };
        const auto vector = [&] {
            const double x = number(), y = number(), z = number();
            return Vec3{x, y, z};
        };
        const Ray ray{vector(), vector(), random.index(2) ? infinity : std::fabs(number())};
        const Vec3 p = vector(), q = vector();
        Vec3 normal = vector();
        if (normal == Vec3{}) normal.x = 1;
        Frustum frustum{vector(), {}};
        for (Plane& plane : frustum.planes) plane = {vector(), number()};
        for (const Shape& shape :
             {Shape(Sphere{p, std::fabs(number())}), Shape(Capsule{p, q, std::fabs(number())}),
              Shape(Aabb{min(p, q), max(p, q)}), Shape(Obb{p, abs(q), rotation_matrix(widen(random.rotation()))}),
              Shape(Plane{normal, number()}), Shape(Triangle{p, q, vector()}), Shape(frustum)}) {
            Hit hit;
            if (raycast(shape, ray, hit)) {
                CHECK((hit.t >= 0 && hit.t <= ray.t_max));
                const gphys_vec3 point = to_hit(hit).point;
                CHECK((std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)));
            }
        }
    }
}

// A sweep is proved, not recomputed. The distance from the centre to a convex set is a convex
// function of time, so t is the first contact if there the distance is the radius and shrinking;
// and there is none if the distance stays above the radius where its slope changes sign. The
// distances come from plain nearest points in long double: 2^-64, against 2^-53 of the library.
#include "ray_cases.h"

using namespace gphys;
using namespace test;

namespace {

constexpr int cases = 100000;
using Real = long double;

struct RVec3 {
    Real x = 0, y = 0, z = 0;
    RVec3() = default;
    RVec3(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
    RVec3(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
};
RVec3 operator+(RVec3 a, RVec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
RVec3 operator-(RVec3 a, RVec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RVec3 operator*(RVec3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
Real dot(RVec3 a, RVec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
RVec3 cross(RVec3 a, RVec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Real length(RVec3 a) { return std::sqrt(dot(a, a)); }

RVec3 nearest_on_segment(RVec3 a, RVec3 b, RVec3 p) {
    const Real square = dot(b - a, b - a);
    const Real s = square > 0 ? std::clamp<Real>(dot(p - a, b - a) / square, 0, 1) : 0;
    return a + (b - a) * s;
}
RVec3 nearest_in_ball(RVec3 center, Real radius, RVec3 p) {
    const Real distance = length(p - center);
    return distance <= radius ? p : center + (p - center) * (radius / distance);
}

RVec3 nearest(const Sphere& sphere, RVec3 p) { return nearest_in_ball(sphere.center, sphere.radius, p); }
RVec3 nearest(const Capsule& capsule, RVec3 p) {
    return nearest_in_ball(nearest_on_segment(capsule.a, capsule.b, p), capsule.radius, p);
}
RVec3 nearest(const Aabb& box, RVec3 p) {
    return {std::clamp<Real>(p.x, box.min.x, box.max.x), std::clamp<Real>(p.y, box.min.y, box.max.y),
            std::clamp<Real>(p.z, box.min.z, box.max.z)};
}
RVec3 nearest(const Obb& box, RVec3 p) {
    const RVec3 from = p - RVec3(box.center);
    RVec3 result(box.center);
    for (const auto& [axis, half] :
         {std::pair(box.axes.x, box.half.x), std::pair(box.axes.y, box.half.y), std::pair(box.axes.z, box.half.z)}) {
        result = result + RVec3(axis) * std::clamp<Real>(dot(from, axis), -half, half);
    }
    return result;
}
RVec3 nearest(const Plane& plane, RVec3 p) {
    const RVec3 n(plane.normal);
    return p - n * ((dot(n, p) - plane.distance) / dot(n, n));
}
RVec3 nearest(const Triangle& triangle, RVec3 p) {
    const RVec3 a(triangle.a), b(triangle.b), c(triangle.c), n = cross(b - a, c - a);
    const Real nn = dot(n, n);
    if (nn > 0) {
        const RVec3 foot = p - n * (dot(p - a, n) / nn);
        if (dot(cross(b - a, foot - a), n) >= 0 && dot(cross(c - b, foot - b), n) >= 0 &&
            dot(cross(a - c, foot - c), n) >= 0) {
            return foot;
        }
    }
    RVec3 best = nearest_on_segment(a, b, p);
    for (const RVec3 other : {nearest_on_segment(b, c, p), nearest_on_segment(c, a, p)}) {
        if (length(other - p) < length(best - p)) best = other;
    }
    return best;
}
/// Dykstra's alternating projections onto the half-spaces would converge; the faces, edges and
/// corners, being few, are simply all tried.
RVec3 nearest(const Frustum& frustum, RVec3 p) {
    const RVec3 from = p - RVec3(frustum.origin);
    const auto depth = [&](const Plane& plane, RVec3 at) { return dot(RVec3(plane.normal), at) - plane.distance; };
    RVec3 best;
    Real best_distance = std::numeric_limits<Real>::infinity();
    const auto consider = [&](RVec3 at) {
        const Real d = length(at - from);
        if (!(d < best_distance)) return;
        for (const Plane& plane : frustum.planes) {
            if (depth(plane, at) < -1e-14L * (1 + length(at))) return;
        }
        best = at, best_distance = d;
    };
    consider(from);
    for (int i = 0; i < 6; ++i) {
        const Plane& first = frustum.planes[i];
        const RVec3 n(first.normal);
        if (dot(n, n) == 0) continue;
        const RVec3 on_face = from - n * (depth(first, from) / dot(n, n));
        consider(on_face);
        for (int k = i + 1; k < 6; ++k) {
            const Plane& second = frustum.planes[k];
            const RVec3 edge = cross(n, second.normal), within = cross(edge, n);
            if (dot(edge, edge) == 0) continue;
            const RVec3 on_edge = on_face - within * (depth(second, on_face) / dot(RVec3(second.normal), within));
            consider(on_edge);
            for (int m = k + 1; m < 6; ++m) {
                const Plane& third = frustum.planes[m];
                const Real slope = dot(RVec3(third.normal), edge);
                if (slope != 0) consider(on_edge - edge * (depth(third, on_edge) / slope));
            }
        }
    }
    return RVec3(frustum.origin) + best;
}

struct Proof {
    int hit_count = 0, miss_count = 0, start_count = 0, false_answers = 0, wrong_contacts = 0;
    double worst_residual = 0, worst_ulps = 0;  // residual: of the distance, relative to the coordinates

    template <class S>
    void add(const S& shape, const Sphere& moving, Vec3 displacement, double size) {
        Hit hit;
        const bool found = sweep(shape, moving, displacement, hit);
        const RVec3 start(moving.center), d(displacement);
        const auto center = [&](Real t) { return start + d * t; };
        const auto offset = [&](Real t) { return center(t) - nearest(shape, center(t)); };
        const Real radius = moving.radius, scale = size + length(d);
        // Positions carry a handful of roundings of the coordinates, and the sums of their squares.
        const Real band = scale * 0x1p-46L;

        if (!found) {
            ++miss_count;
            Real low = 0, high = 1;
            for (int i = 0; i < 64; ++i) {
                const Real middle = (low + high) / 2;
                (dot(offset(middle), d) < 0 ? low : high) = middle;
            }
            false_answers += length(offset(high)) < radius - band;
            return;
        }
        const RVec3 out = offset(hit.t);
        const Real distance = length(out);
        if (hit.t == 0 && (hit.flags & GPHYS_HIT_INSIDE)) {
            ++start_count;
            false_answers += distance > radius + band;
        } else {
            ++hit_count;
            const Real residual = std::fabs(distance - radius), approach = -dot(out, d) / distance;
            false_answers += residual > band || approach < -band;
            wrong_contacts += length(offset(0)) < radius - band || hit.t < 0 || hit.t > 1;
            // From a moving radius of 2^-20 on, the normal is good for 2^-24.
            wrong_contacts += length(RVec3(hit.normal) - out * (1 / distance)) > 0x1p-24L + 2 * band / radius;
            worst_residual = std::max(worst_residual, static_cast<double>(residual / scale));
            if (approach > length(d) / 16 && hit.t * length(d) > scale / 1024) {
                worst_ulps = std::max(worst_ulps, static_cast<double>(residual / approach / hit.t * 0x1p23L));
            }
        }
        const RVec3 point(hit.point);
        wrong_contacts += length(point - nearest(shape, point)) > band;
        wrong_contacts += length(point - nearest(shape, center(hit.t))) > band + std::sqrt(band * radius);
        const bool has_normal = displacement != Vec3{} || out.x != 0 || out.y != 0 || out.z != 0;
        wrong_contacts += std::fabs(gphys::length(hit.normal) - has_normal) > 1e-12;
    }
};

#define CHECK_PROOF(proof)                                                                                             \
    do {                                                                                                               \
        INFO("contacts " << proof.hit_count << ", at start " << proof.start_count << ", misses " << proof.miss_count   \
                         << ", worst distance error " << proof.worst_residual << " of the coordinates, worst t error " \
                         << proof.worst_ulps << " ulp");                                                               \
        CHECK(proof.false_answers == 0);                                                                               \
        CHECK(proof.wrong_contacts == 0);                                                                              \
        CHECK(proof.worst_ulps <= 0x1p-6);                                                                             \
        CHECK(proof.hit_count > cases / 100);                                                                          \
        CHECK(proof.miss_count > cases / 100);                                                                         \
    } while (0)

/// Sweeps of all kinds past shapes within `reach` of the origin, moved out to `offset`: on the grid
/// and off it, mostly towards the shape, with radii from tiny to large.
template <class Make>
Proof prove(uint64_t seed, int count, const Make& make) {
    const NoTraps watch;
    Random random(seed);
    Proof proof;
    for (int i = 0; i < count; ++i) {
        const bool grid = random.index(3) == 0;
        const double far = random.index(4) == 0 ? std::pow(10, random.uniform(1, 6)) : 0;
        const Vec3 offset = grid ? Vec3{} : on_lattice(random_point(random, far));
        const Vec3 center = grid ? grid_point(random, 6) : on_lattice(random_point(random, 6));
        const Vec3 target = grid ? grid_point(random, 3) : on_lattice(random_point(random, 3));
        const Sphere moving{center + offset,
                            grid ? 1.0 + random.index(2) : on_lattice(std::pow(10, random.uniform(-3, 0)))};
        const Vec3 displacement = (target - center) * (random.index(2) + 1.0);
        proof.add(make(random, grid, offset), moving, displacement, 12 + 2 * gphys::length(offset));
    }
    return proof;
}

Vec3 some_point(Random& random, bool grid, int extent) {
    return grid ? grid_point(random, extent) : on_lattice(random_point(random, extent));
}

}  // namespace

TEST_CASE("sweep: first contact with spheres", "[sweep]") {
    const Proof proof = prove(21, cases, [](Random& random, bool grid, Vec3 offset) {
        return Sphere{some_point(random, grid, 3) + offset, grid ? random.index(3) : random.uniform(0, 2)};
    });
    CHECK_PROOF(proof);
}

TEST_CASE("sweep: first contact with capsules", "[sweep]") {
    const Proof proof = prove(22, cases, [](Random& random, bool grid, Vec3 offset) {
        return Capsule{some_point(random, grid, 3) + offset, some_point(random, grid, 3) + offset,
                       grid ? random.index(3) : random.uniform(0, 1)};
    });
    CHECK_PROOF(proof);
}

TEST_CASE("sweep: first contact with boxes", "[sweep]") {
    const Proof proof = prove(23, cases, [](Random& random, bool grid, Vec3 offset) {
        const Vec3 a = some_point(random, grid, 2) + offset, b = some_point(random, grid, 2) + offset;
        return Aabb{min(a, b), max(a, b)};
    });
    CHECK_PROOF(proof);
}

TEST_CASE("sweep: first contact with turned boxes", "[sweep]") {
    const Proof proof = prove(24, cases, [](Random& random, bool grid, Vec3 offset) {
        const Mat3 axes = grid ? Mat3{} : rotation_matrix(widen(random.rotation()));
        return Obb{some_point(random, grid, 2) + offset, abs(some_point(random, grid, 2)), axes};
    });
    CHECK_PROOF(proof);
}

TEST_CASE("sweep: first contact with planes", "[sweep]") {
    const Proof proof = prove(25, cases, [](Random& random, bool grid, Vec3 offset) {
        const Vec3 normal = grid ? grid_direction(random, 2) : on_lattice(random.direction());
        return Plane{normal, gphys::dot(normal, some_point(random, grid, 3) + offset)};
    });
    CHECK_PROOF(proof);
}

TEST_CASE("sweep: first contact with triangles, degenerate ones and slivers", "[sweep]") {
    const Proof proof = prove(26, cases, [](Random& random, bool grid, Vec3 offset) {
        const Vec3 a = some_point(random, grid, 3) + offset, b = some_point(random, grid, 3) + offset;
        if (random.index(8) == 0) {  // a sliver, or a segment
            return Triangle{a, b,
                            on_lattice(a + (b - a) * random.uniform(0, 1)) + Vec3{random.index(2) * 0x1p-16, 0, 0}};
        }
        return Triangle{a, b, some_point(random, grid, 3) + offset};
    });
    CHECK_PROOF(proof);
}

TEST_CASE("sweep: first contact with frusta, infinite ones too", "[sweep]") {
    const Proof proof = prove(27, cases / 5, [](Random& random, bool grid, Vec3 offset) {
        const double x = grid ? 1 : on_lattice(random.uniform(.2, 2)), y = grid ? 1 : on_lattice(random.uniform(.2, 2));
        Frustum frustum{
            some_point(random, grid, 3) + offset,
            {{{0, 0, 1}, .5}, {{0, 0, -1}, -3}, {{1, 0, x}, 0}, {{-1, 0, x}, 0}, {{0, 1, y}, 0}, {{0, -1, y}, 0}}};
        if (random.index(2) == 0) frustum.planes[1] = {{0, 0, 0}, -1};
        return frustum;
    });
    CHECK_PROOF(proof);
}

TEST_CASE("sweep: a sphere without radius goes where the ray goes", "[sweep]") {
    Random random(28);
    int differences = 0, hits = 0;
    for (int i = 0; i < cases / 10; ++i) {
        const Vec3 p = grid_point(random, 2), q = grid_point(random, 2);
        const Sphere moving{grid_point(random, 4), 0};
        const Vec3 displacement = grid_point(random, 6);
        for (const Shape& shape :
             {Shape(Sphere{p, 1}), Shape(Capsule{p, q, 1}), Shape(Aabb{min(p, q), max(p, q)}),
              Shape(Obb{p, abs(q), Mat3{}}), Shape(Plane{{1, 2, 2}, 1}), Shape(Triangle{p, q, {0, 1, 2}})}) {
            Hit swept, cast;
            const bool found = sweep(shape, moving, displacement, swept);
            differences += found != raycast(shape, {moving.center, displacement, 1}, cast) || swept.t != cast.t ||
                           swept.normal != cast.normal;
            hits += found;
        }
    }
    CHECK(differences == 0);
    CHECK(hits > 1000);
}

TEST_CASE("sweep: touching counts at the start and at the end", "[sweep]") {
    const NoTraps watch;
    const Sphere moving{{-3, 0, 0}, 1};
    for (const Shape& shape :
         {Shape(Sphere{{1, 0, 0}, 1}), Shape(Capsule{{1, 0, 0}, {1, 2, 0}, 1}), Shape(Aabb{{0, -1, -1}, {1, 1, 1}}),
          Shape(Obb{{1, 0, 0}, {1, 1, 1}, Mat3{}}), Shape(Plane{{2, 0, 0}, 0}),
          Shape(Triangle{{0, -1, -1}, {0, 1, -1}, {0, 0, 1}}), Shape(Triangle{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}})}) {
        Hit hit;
        REQUIRE(sweep(shape, moving, {2, 0, 0}, hit));
        CHECK(hit.t == 1);
        CHECK(hit.point == Vec3{0, 0, 0});
        CHECK(hit.normal == Vec3{-1, 0, 0});
        CHECK((hit.flags & GPHYS_HIT_INSIDE) == 0);
        CHECK_FALSE(sweep(shape, moving, {1.9999999, 0, 0}, hit));
        for (const Vec3 displacement : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}}) {
            REQUIRE(sweep(shape, {{-1, 0, 0}, 1}, displacement, hit));
            CHECK(hit.t == 0);
            CHECK(hit.normal == Vec3{-1, 0, 0});
            CHECK((hit.flags & GPHYS_HIT_INSIDE) != 0);
        }
        CHECK_FALSE(sweep(shape, {{-1.0000001, 0, 0}, 1}, {0, 0, 0}, hit));
    }
}

TEST_CASE("sweep: a centre inside gets a normal against the motion", "[sweep]") {
    const NoTraps watch;
    Hit hit;
    for (const Shape& solid : {Shape(Sphere{{0, 0, 0}, 2}), Shape(Aabb{{-1, -1, -1}, {1, 1, 1}})}) {
        REQUIRE(sweep(solid, {{0, 0, 0}, 1}, {0, 3, 0}, hit));
        CHECK(hit.normal == Vec3{0, -1, 0});
        CHECK(hit.point == Vec3{0, 0, 0});
        REQUIRE(sweep(solid, {{0, 0, 0}, 1}, {0, 0, 0}, hit));
        CHECK(hit.normal == Vec3{0, 0, 0});
    }
    // On a surface there is a normal all the same.
    REQUIRE(sweep(Plane{{0, 0, 1}, 0}, {{5, 5, 0}, 1}, {1, 0, 1}, hit));
    CHECK(hit.normal == Vec3{0, 0, -1});
    CHECK(hit.flags == (GPHYS_HIT_INSIDE | GPHYS_HIT_BACK));
    REQUIRE(sweep(Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{1, 1, 0}, 1}, {0, 0, -1}, hit));
    CHECK(hit.normal == Vec3{0, 0, 1});
    CHECK(hit.u == .25);
    CHECK(hit.v == .25);
}

TEST_CASE("sweep: a reported normal is not along the motion, however little is left to tell it from", "[sweep]") {
    const auto check = [](const Shape& shape, const Sphere& moving, Vec3 displacement) {
        Hit hit;
        REQUIRE(sweep(shape, moving, displacement, hit));
        REQUIRE((hit.flags & GPHYS_HIT_INSIDE) == 0);
        const Vec3 normal = widen(to_contact(hit, displacement).normal);
        CHECK(dot(normal, displacement) <= 0);
        CHECK(std::fabs(length(normal) - 1) < 0x1p-22);
    };
    // Radii far below a rounding of the coordinates.
    const Triangle line{
        {-0x1.666666p-1, -0x1.1a61fcp-54, 0x1.555556p-1}, {.1, 0x1.777a5cp-25, 0}, {.1, 0x1.777a5cp-25, 0}};
    check(line, {{-0x1.666666p-1, -0x1.eb852p-6, 0x1.555556p-1}, 0x1p-129}, {0, 1, 0});
    const Aabb box{{0x1.c3cffap-58, -0x1.ee8a72p-1, -0x1.111112p-5}, {0x1.eb852p-6, 0x1.99999ap-4, -0x1.039d66p-103}};
    check(box, {{0x1.99999ap-3, 0x1.2c61e4p-27, 0x1.777a5cp-25}, 0x1.4484cp-100},
          {-0x1.41b2f8p-2, -0x1.0907dcp-2, -0x1.47ae16p-7});
    // Past a frustum that is 4e14 m away by its coordinates.
    const Frustum frustum{{0x1.78967p+48, 0x1.92e1p+1, 0x1.41b2f8p-2},
                          {{{0, 0, 1}, 3},
                           {{0, 0, -1}, 1},
                           {{0, 1, -0x1.d4f54cp+48}, -1},
                           {{0, 1, -0x1.d4f54cp+48}, 0},
                           {{1, 1, -0x1.d4f54cp+48}, 0},
                           {{-1, 1, -0x1.d4f54cp+48}, 0}}};
    Hit hit;
    const Sphere moving{{0x1.fffffep+0, -0x1p-147, -0x1.c99f8cp+2}, 1};
    const Vec3 displacement{0x1.66d2f6p+49, 0x1.ffffbp+19, 0x1.ffffe8p+19};
    if (sweep(frustum, moving, displacement, hit)) check(frustum, moving, displacement);
    // Edges that are grazed: the normal is across the motion, up to its rounding to floats.
    Random random(31);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 way = as_floats({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
        const Vec3 across = normalized(cross(way, {random.uniform(-1, 1), random.uniform(-1, 1), 1}));
        const Sphere swept{as_floats(across * 2 - way * .5), 1};
        for (const Shape& shape :
             {Shape(Sphere{{}, .999999}), Shape(Capsule{{}, as_floats(cross(way, across)), .999999}),
              Shape(Aabb{as_floats(across * -1), as_floats(across * .9999)}), Shape(Plane{across, .999999})}) {
            Hit grazed;
            if (!sweep(shape, swept, way, grazed) || (grazed.flags & GPHYS_HIT_INSIDE)) continue;
            const Vec3 normal = widen(to_contact(grazed, way).normal);
            CHECK(dot(normal, way) <= 0);
            CHECK(length(normal - grazed.normal) < 0x1p-21);
        }
    }
}

TEST_CASE("sweep: a ball smaller than the rounding of its way gets the normal of the face it meets", "[sweep]") {
    Random random(8);
    const Aabb box{{-1, -1, -1}, {1, 1, 1}};
    for (int i = 0; i < cases; ++i) {
        const int axis = i % 3;
        const double side = i % 2 ? 1 : -1;
        Vec3 target = as_floats(random_point(random, 1)), start = as_floats(random_point(random, 1)) + target;
        target[axis] = side;
        start[axis] = side * (2 + std::fabs(start[axis]));
        const Sphere moving{start, std::ldexp(1.0, -40 - static_cast<int>(random.index(100)))};
        Hit hit;
        REQUIRE(sweep(box, moving, as_floats((target - start) * 2), hit));
        if (std::fabs(target[(axis + 1) % 3]) > 0.999 || std::fabs(target[(axis + 2) % 3]) > 0.999) continue;
        Vec3 normal;
        normal[axis] = side;
        CHECK(hit.normal == normal);
    }
}

TEST_CASE("sweep: the largest and smallest numbers raise no exception", "[sweep]") {
    const NoTraps watch;
    Random random(29);
    for (int i = 0; i < 20000; ++i) {
        const auto number = [&] {
            const double magnitude = std::pow(10, random.uniform(-44, 15));
            return random.index(8) == 0 ? 0.0 : as_floats({random.index(2) ? magnitude : -magnitude, 0, 0}).x;
        };
        const auto vector = [&] {
            const double x = number(), y = number(), z = number();
            return Vec3{x, y, z};
        };
        const Vec3 p = vector(), q = vector();
        Vec3 normal = vector();
        if (normal == Vec3{}) normal.x = 1;
        Frustum frustum{vector(), {}};
        for (Plane& plane : frustum.planes) plane = {vector(), number()};
        const Sphere moving{vector(), std::fabs(number())};
        const Vec3 displacement = vector();
        for (const Shape& shape :
             {Shape(Sphere{p, std::fabs(number())}), Shape(Capsule{p, q, std::fabs(number())}),
              Shape(Aabb{min(p, q), max(p, q)}), Shape(Obb{p, abs(q), rotation_matrix(widen(random.rotation()))}),
              Shape(Plane{normal, number()}), Shape(Triangle{p, q, vector()}), Shape(frustum)}) {
            Hit hit;
            if (sweep(shape, moving, displacement, hit)) {
                CHECK((hit.t >= 0 && hit.t <= 1));
                const Vec3 reported = widen(to_contact(hit, displacement).normal);
                CHECK(((hit.flags & GPHYS_HIT_INSIDE) || dot(reported, displacement) <= 0));
            }
        }
    }
}

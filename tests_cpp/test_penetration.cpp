// A way out is proved, not recomputed. It separates if the solid, gone a little further, overlaps no more; it is the
// shortest if along no other direction less is enough. How far two convex shapes reach along a direction is a maximum
// over their corners, in long double: 2^-64, against 2^-53 of the library.
#include "geometry/convex_pairs.h"
#include "solid_cases.h"

using namespace gphys;
using namespace test;

namespace {

constexpr int cases = 100000, many_cases = 1000000;
using Real = long double;

Real dot(Vec3 a, Vec3 b) { return Real{a.x} * b.x + Real{a.y} * b.y + Real{a.z} * b.z; }
Real reach(const Sphere& sphere, Vec3 n) { return dot(sphere.center, n) + sphere.radius * std::sqrt(dot(n, n)); }
Real reach(const Capsule& capsule, Vec3 n) {
    return std::max(dot(capsule.a, n), dot(capsule.b, n)) + capsule.radius * std::sqrt(dot(n, n));
}
Real reach(const Aabb& box, Vec3 n) {
    return dot({n.x > 0 ? box.max.x : box.min.x, n.y > 0 ? box.max.y : box.min.y, n.z > 0 ? box.max.z : box.min.z}, n);
}
Real reach(const Obb& box, Vec3 n) {
    return dot(box.center, n) + box.half.x * std::fabs(dot(box.axes.x, n)) +
           box.half.y * std::fabs(dot(box.axes.y, n)) + box.half.z * std::fabs(dot(box.axes.z, n));
}
Real reach(const Triangle& triangle, Vec3 n) {
    return std::max({dot(triangle.a, n), dot(triangle.b, n), dot(triangle.c, n)});
}
Real reach(const Plane&, Vec3) { return std::numeric_limits<Real>::infinity(); }
Real reach(const Frustum& frustum, Vec3 n) {
    Real reach = -std::numeric_limits<Real>::infinity();
    for (const Vec3& corner : test::hull(frustum).corners) reach = std::max(reach, dot(corner, n));
    return reach;
}
/// How far the solid has to go along a unit vector to get out.
Real way_along(const SolidPair& pair, Vec3 n) {
    const auto of = [](const Shape& shape, Vec3 along) {
        return std::visit([&](const auto& each) { return reach(each, along); }, shape);
    };
    return of(pair.other, n) + of(pair.moving, -n);
}

struct Proof {
    int overlapping = 0, still_overlap = 0, too_long = 0, bad_normals = 0, bad_points = 0, disagree = 0;
    Real worst = 0;  // by which another direction is shorter, in parts of the size

    void add(const SolidPair& pair, Random& random) {
        if (!overlaps(pair.other, pair.moving)) return;
        ++overlapping;
        const Penetration out = penetration(pair.other, pair.moving);
        // What the overlap, and the answer, are allowed to be off by.
        const double band = 0x1p-40 * pair.size;
        bad_normals += std::fabs(length(out.normal) - 1) > 1e-12;
        const auto gone = [&](double way) { return moved(pair.moving, out.normal * way); };
        const bool out_of_it = !overlaps(pair.other, gone(out.depth * (1 + 0x1p-40) + band));
        const bool not_before = out.depth <= band || overlaps(pair.other, gone(out.depth * (1 - 0x1p-40) - band));
        still_overlap += !out_of_it;
        too_long += !not_before;
        // The point is on the shape, and on the solid that has gone there.
        const Sphere ball{out.point, 2 * band};
        bad_points +=
            !overlaps(pair.other, ball) || !overlaps(gone(out.depth), Shape(Sphere{out.point, 0x1p-24 * pair.size}));
        if (std::holds_alternative<Plane>(pair.other)) return;
        for (int i = 0; i < 16; ++i) {
            const Vec3 near = out.normal + random.direction() * std::pow(10, random.uniform(-6, 0));
            const Vec3 n = i < 8 ? random.direction() : normalized(near);
            const Real shorter = out.depth - way_along(pair, n) / std::sqrt(dot(n, n));
            worst = std::max(worst, shorter / pair.size);
        }
    }
};

Proof prove(uint64_t seed, int count) {
    const NoTraps watch;
    SolidCases pairs(seed);
    Proof proof;
    for (int i = 0; i < count; ++i) proof.add(pairs.next(2), pairs.random);
    return proof;
}

#define CHECK_PROOF(proof, count)                                                                                  \
    do {                                                                                                           \
        INFO(proof.overlapping << " overlap; another way is shorter by up to " << static_cast<double>(proof.worst) \
                               << " of the size");                                                                 \
        CHECK(proof.overlapping > count / 4);                                                                      \
        CHECK(proof.still_overlap == 0);                                                                           \
        CHECK(proof.too_long == 0);                                                                                \
        CHECK(proof.bad_normals == 0);                                                                             \
        CHECK(proof.bad_points == 0);                                                                              \
        CHECK(proof.worst < 0x1p-40L);                                                                             \
    } while (0)

}  // namespace

TEST_CASE("penetration: the shortest way out, and no longer", "[penetration]") {
    const Proof proof = prove(31, cases);
    CHECK_PROOF(proof, cases);
}

TEST_CASE("penetration: the shortest way out, a million times", "[penetration][.long]") {
    const Proof proof = prove(32, many_cases);
    CHECK_PROOF(proof, many_cases);
}

TEST_CASE("penetration: known ways out", "[penetration]") {
    const auto check = [](const Shape& other, const Shape& moving, double depth, Vec3 normal, Vec3 point) {
        const Penetration out = penetration(other, moving);
        CHECK(out.depth == Approx(depth).epsilon(1e-15).margin(1e-15));
        CHECK(length(out.normal - normal) < 1e-15);
        CHECK(length(out.point - point) < 1e-15);
    };
    const Aabb box{{-1, -1, -1}, {1, 1, 1}};
    check(box, Sphere{{0, 0.5, 0}, 1}, 1.5, {0, 1, 0}, {0, 1, 0});
    check(box, Sphere{{1.5, 1.5, 0}, 1}, 1 - std::sqrt(0.5), Vec3{1, 1, 0} * std::sqrt(0.5), {1, 1, 0});
    check(box, Capsule{{1.5, 3, 0}, {1.5, -3, 0.25}, 0.75}, 0.25, {1, 0, 0},
          penetration(box, Capsule{{1.5, 3, 0}, {1.5, -3, 0.25}, 0.75}).point);
    // A corner that points down, over the middle of the top.
    const double third = std::sqrt(1.0 / 3), sixth = std::sqrt(1.0 / 6), half = std::sqrt(0.5);
    const Mat3 on_corner{{2 * sixth, third, 0}, {-sixth, third, half}, {-sixth, third, -half}};
    const Penetration corner = penetration(box, Obb{{0, 2.5, 0}, {1, 1, 1}, on_corner});
    CHECK(corner.depth == Approx(std::sqrt(3.0) - 1.5));
    CHECK(corner.normal.y == Approx(1));
    CHECK(length(corner.point - Vec3{0, 1, 0}) < 1e-14);
    check(Plane{{0, 2, 0}, 0}, Sphere{{3, 0.5, 0}, 2}, 1.5, {0, 1, 0}, {3, 0, 0});
    check(Plane{{0, 2, 0}, 0}, Sphere{{3, -0.5, 0}, 2}, 1.5, {0, -1, 0}, {3, 0, 0});
    check(Triangle{{-4, 0, -4}, {4, 0, -4}, {0, 0, 4}}, Capsule{{0, 0.25, 0}, {0, 2, 0}, 0.5}, 0.25, {0, 1, 0},
          {0, 0, 0});
    // Touching.
    check(box, Aabb{{1, 0, 0}, {2, 1, 1}}, 0, {1, 0, 0}, penetration(box, Aabb{{1, 0, 0}, {2, 1, 1}}).point);
    // Nothing says which way is the shortest.
    CHECK(penetration(Sphere{{1, 2, 3}, 2}, Sphere{{1, 2, 3}, 1}).depth == 3);
    CHECK(penetration(Capsule{{0, 0, 0}, {0, 4, 0}, 1}, Sphere{{0, 2, 0}, 1}).depth == 2);
}

TEST_CASE("penetration: a ball beside the long side of a triangle goes out past the side", "[penetration]") {
    // Its centre is 0.998 of its radius away from the side, which is 2^-32 of the coordinates.
    const Triangle needle{{0x1p-12, -0x1p-149, 0x1.1a6264p-54}, {0, -0x1.7ffffep+5, 0x1.1a6264p-53}, {-1, 0, 0x1p-149}};
    const Sphere ball{{0x1.0007fep-13, -0x1.7ffffcp+4, 0x1p-53}, 0x1p-26};
    const Penetration out = penetration(needle, Shape(ball));
    CHECK(out.depth < 0x1p-33);
    CHECK(out.normal.x > 0.999);
}

TEST_CASE("penetration: the distance by steps is that by features", "[penetration]") {
    const NoTraps watch;
    SolidCases pairs(33);
    int compared = 0, wrong = 0;
    for (int i = 0; i < cases / 10; ++i) {
        const SolidPair pair = pairs.next(5);
        with_pair(pair.other, pair.moving, [&](const auto& other, const auto& moving) {
            using Other = std::decay_t<decltype(other)>;
            if constexpr (!std::is_same_v<Other, Plane>) {
                const Vec3 from = reference_point(moving);
                const auto core = core_of(relative_to(from, other));
                const ConvexDifference set(core, core_of(relative_to(from, moving)));
                const double quick = length(set.nearest().offset), slow = length(set.nearest_by_features().offset);
                const bool apart = separation(set).distance > 0x1p-40 * pair.size;
                compared += apart;
                wrong += apart && std::fabs(quick - slow) > 0x1p-44 * pair.size;
            }
        });
    }
    CHECK(compared > cases / 40);
    CHECK(wrong == 0);
}

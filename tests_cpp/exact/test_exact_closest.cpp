// The closest point of a shape and its distance.
#include "oracle.h"
#include "score.h"

using namespace test;

namespace {

Point foot_on_segment(const Point& a, const Point& b, const Point& p) {
    const Vector along = b - a;
    const Number square = along.squared_length();
    if (square == 0) return a;
    const Number t = along * (p - a) / square;
    return t <= 0 ? a : t >= 1 ? b : a + along * t;
}

Point foot(const gphys_triangle& t, const Point& p) {
    const Point a = exact(t.a), b = exact(t.b), c = exact(t.c);
    const Vector normal = CGAL::cross_product(b - a, c - a);
    if (normal != CGAL::NULL_VECTOR && normal * CGAL::cross_product(b - a, p - a) >= 0 &&
        normal * CGAL::cross_product(c - b, p - b) >= 0 && normal * CGAL::cross_product(a - c, p - c) >= 0) {
        return p - normal * (normal * (p - a) / normal.squared_length());
    }
    Point best = foot_on_segment(a, b, p);
    for (const Point& other : {foot_on_segment(b, c, p), foot_on_segment(c, a, p)}) {
        if (CGAL::squared_distance(other, p) < CGAL::squared_distance(best, p)) best = other;
    }
    return best;
}
Point foot(const gphys_aabb& b, const Point& p) {
    const Point low = exact(b.min), high = exact(b.max);
    const auto clamp = [&](int k) { return std::min(Number(std::max(Number(p[k]), Number(low[k]))), Number(high[k])); };
    return {clamp(0), clamp(1), clamp(2)};
}
Point foot(const gphys_obb& b, const Point& p) {
    const Rotation rotation(b.rotation);
    const Vector local = rotation.into(p - exact(b.center));
    const Number half[3] = {b.half_extents.x, b.half_extents.y, b.half_extents.z};
    const auto clamp = [&](int k) { return std::min(Number(std::max(Number(local[k]), Number(-half[k]))), half[k]); };
    return exact(b.center) + rotation.out({clamp(0), clamp(1), clamp(2)});
}
Point foot(const gphys_plane& plane, const Point& p) {
    const Vector n = exact_vector(plane.normal);
    return p - n * ((n * (p - CGAL::ORIGIN) - plane.distance) / n.squared_length());
}

/// The closest point and its distance in 300 digits.
struct Nearest {
    BigVec point;
    Big distance;
};
template <class S>
Nearest truth(const S& shape, gphys_vec3 point) {
    const Point p = exact(point), on = foot(shape, p);
    const BigVec offset = big(CGAL::ORIGIN + (on - p));
    return {big(on), sqrt(dot(offset, offset))};
}
Nearest around(const Point& core, double radius, gphys_vec3 point) {
    const BigVec p(point), out = big(CGAL::ORIGIN + (exact(point) - core));
    const Big away = sqrt(dot(out, out));
    if (away <= radius) return {p, 0};
    return {big(core) + out * (Big(radius) / away), away - radius};
}
Nearest truth(const gphys_sphere& s, gphys_vec3 point) { return around(exact(s.center), s.radius, point); }
Nearest truth(const gphys_capsule& c, gphys_vec3 point) {
    return around(foot_on_segment(exact(c.a), exact(c.b), exact(point)), c.radius, point);
}

template <class S>
using Closest = gphys_nearest (*)(const S&, const gphys_vec3&);

template <class S>
gphys_nearest library(const S& shape, const gphys_vec3& point) {
    gphys_nearest nearest;
    REQUIRE(gphys_shape_closest_point(type_of(shape), &shape, &point, &nearest) == GPHYS_OK);
    return nearest;
}
template <class S>
gphys_nearest moved(const S& shape, const gphys_vec3& point) {
    gphys_nearest nearest = library(shape, point);
    nearest.point.y = after(after(nearest.point.y));
    return nearest;
}
template <class S>
gphys_nearest longer(const S& shape, const gphys_vec3& point) {
    gphys_nearest nearest = library(shape, point);
    nearest.distance = after(after(nearest.distance));
    return nearest;
}

/// Each coordinate within 1 ulp of the largest coordinate of the input, the distance within 1 ulp of
/// itself and 2^-40 of the size. Says yes where the point is not in the shape.
template <class S>
auto examine(const char* name, uint64_t seed) {
    return [=](Closest<S> closest, long count) {
        Cases c(seed);
        Score score(name, 1, "of the bound");
        for (long i = 0; i < count; ++i, c.next()) {
            S shape;
            c.make(shape);
            gphys_vec3 point = c.one_in(2) ? c.point() : target_on(c, shape);
            if (c.one_in(4)) c.nudge(point);
            const gphys_nearest given = closest(shape, point);
            const Nearest expected = truth(shape, point);
            const bool away = expected.distance > 0;
            score.answer(away, away, point);
            const double w = std::max(largest(widen(point)), largest(widen(target_on(c, shape))));
            const double unit = std::max(ulp_of(w), ulp_of(largest(widen(given.point))));
            const double distance = rounded(expected.distance);
            score.error(error_of(given.point.x, expected.point.x) / unit, shape, point);
            score.error(error_of(given.point.y, expected.point.y) / unit, shape, point);
            score.error(error_of(given.point.z, expected.point.z) / unit, shape, point);
            const double bound = ulp_of(distance) + 0x1p-40 * size_of(shape, point);
            score.error(error_of(given.distance, expected.distance) / bound, shape, point);
        }
        return score;
    };
}

}  // namespace

TEST_CASE("closest points are within an ulp, and distances", "[closest]") {
    const long count = cases(3000, 1000000);
    prove(count, examine<gphys_sphere>("closest point sphere", 31), library<gphys_sphere>, moved<gphys_sphere>,
          longer<gphys_sphere>);
    prove(count, examine<gphys_capsule>("closest point capsule", 32), library<gphys_capsule>, moved<gphys_capsule>,
          longer<gphys_capsule>);
    prove(count, examine<gphys_aabb>("closest point AABB", 33), library<gphys_aabb>, moved<gphys_aabb>,
          longer<gphys_aabb>);
    prove(count, examine<gphys_obb>("closest point OBB", 34), library<gphys_obb>, moved<gphys_obb>, longer<gphys_obb>);
    prove(count, examine<gphys_triangle>("closest point triangle", 35), library<gphys_triangle>, moved<gphys_triangle>,
          longer<gphys_triangle>);
    prove(count, examine<gphys_plane>("closest point plane", 36), library<gphys_plane>, moved<gphys_plane>,
          longer<gphys_plane>);
}

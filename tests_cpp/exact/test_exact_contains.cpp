// Points in and on shapes: exactly, and within a tolerance.
#include "oracle.h"
#include "score.h"

using namespace test;

namespace {

/// The squared distance of a point from a shape that a tolerance widens; solids have their own radius.
template <class S>
Number squared_gap(const S& shape, const Point& p);

template <>
Number squared_gap(const gphys_aabb& b, const Point& p) {
    const Point low = exact(b.min), high = exact(b.max);
    Number sum = 0;
    for (int k = 0; k < 3; ++k) {
        const Number out = std::max({Number(low[k] - p[k]), Number(p[k] - high[k]), Number(0)});
        sum += out * out;
    }
    return sum;
}
template <>
Number squared_gap(const gphys_obb& b, const Point& p) {
    const Vector local = Rotation(b.rotation).into(p - exact(b.center));
    const Number half[3] = {b.half_extents.x, b.half_extents.y, b.half_extents.z};
    Number sum = 0;
    for (int k = 0; k < 3; ++k) {
        const Number out = std::max(Number(CGAL::abs(local[k]) - half[k]), Number(0));
        sum += out * out;
    }
    return sum;
}
template <>
Number squared_gap(const gphys_plane& plane, const Point& p) {
    const Vector n = exact_vector(plane.normal);
    const Number height = n * (p - CGAL::ORIGIN) - plane.distance;
    return height * height / n.squared_length();
}
template <>
Number squared_gap(const gphys_triangle& t, const Point& p) {
    return with_simplex(t, [&](const auto& simplex) { return Number(CGAL::squared_distance(simplex, p)); });
}
template <>
Number squared_gap(const gphys_segment& s, const Point& p) {
    return squared_gap(gphys_triangle{s.a, s.b, s.b}, p);
}
template <>
Number squared_gap(const gphys_sphere& s, const Point& p) {
    return CGAL::squared_distance(exact(s.center), p);
}
template <>
Number squared_gap(const gphys_capsule& c, const Point& p) {
    return squared_gap(gphys_segment{c.a, c.b}, p);
}

template <class S>
double radius_of(const S&) {
    return 0;
}
double radius_of(const gphys_sphere& s) { return s.radius; }
double radius_of(const gphys_capsule& c) { return c.radius; }

template <class S>
gphys_vec3 target(Cases& c, const S& shape) {
    return target_on(c, shape);
}
gphys_vec3 target(Cases& c, const gphys_segment& s) { return c.point_by(s.a, s.b, s.a); }
gphys_segment grown(const gphys_segment& s) { return {s.a, {after(s.b.x), after(s.b.y), s.b.z}}; }
using test::grown;

template <class S>
using Contains = bool (*)(const S&, const gphys_vec3&, float tolerance);

template <class S>
bool library(const S& shape, const gphys_vec3& point, float tolerance) {
    int32_t contains = -1;
    REQUIRE(gphys_shape_contains(type_of(shape), &shape, &point, tolerance, &contains) == GPHYS_OK);
    return contains == 1;
}
template <class S>
bool of_a_grown_shape(const S& shape, const gphys_vec3& point, float tolerance) {
    return library(grown(shape), point, tolerance);
}
template <class S>
bool with_an_epsilon(const S& shape, const gphys_vec3& point, float tolerance) {
    return library(shape, point, tolerance + 1e-6f);
}

/// `band`: of the pair's size, within which the answer may be either. With a tolerance, half of all.
template <class S>
auto examine(const char* name, uint64_t seed, bool tolerant, double band) {
    return [=](Contains<S> contains, long count) {
        Cases c(seed);
        Score score(name);
        for (long i = 0; i < count; ++i, c.next()) {
            S shape;
            c.make(shape);
            gphys_vec3 point = target(c, shape);
            if (c.one_in(4)) c.nudge(point);
            float tolerance = 0;
            if (tolerant) {
                // A distance that the point then has, nearly.
                tolerance = c.size();
                const Vec3 out = c.one_in(2) ? widen(c.direction()) : c.random.direction();
                point = narrow(widen(point) + normalized(out) * tolerance);
            }
            const Number square = squared_gap(shape, exact(point)), radius = Number(radius_of(shape)) + tolerance;
            Number slack = 0;
            if (band > 0) slack = band * (size_of(shape, point) + tolerance);
            const Number more = radius + slack, less = radius - slack;
            score.answer(contains(shape, point, tolerance), square <= more * more,
                         less < 0 || (slack > 0 ? square >= less * less : square > less * less), shape, point);
        }
        return score;
    };
}

constexpr double of_curves = 0x1p-46, of_axes = 0x1p-40;

}  // namespace

TEST_CASE("points are in spheres, capsules, boxes, triangles, on planes and segments exactly when they are",
          "[contains]") {
    const long count = cases(10000, 10000000);
    prove(count, examine<gphys_sphere>("contains sphere", 11, false, 0), library<gphys_sphere>,
          of_a_grown_shape<gphys_sphere>, with_an_epsilon<gphys_sphere>);
    prove(count, examine<gphys_capsule>("contains capsule", 12, false, 0), library<gphys_capsule>,
          of_a_grown_shape<gphys_capsule>, with_an_epsilon<gphys_capsule>);
    prove(count, examine<gphys_aabb>("contains AABB", 13, false, 0), library<gphys_aabb>, of_a_grown_shape<gphys_aabb>,
          with_an_epsilon<gphys_aabb>);
    prove(count, examine<gphys_triangle>("contains triangle", 14, false, 0), library<gphys_triangle>,
          of_a_grown_shape<gphys_triangle>, with_an_epsilon<gphys_triangle>);
    prove(count, examine<gphys_plane>("contains plane", 15, false, 0), library<gphys_plane>,
          of_a_grown_shape<gphys_plane>, with_an_epsilon<gphys_plane>);
    prove(count, examine<gphys_segment>("contains segment", 16, false, 0), library<gphys_segment>,
          of_a_grown_shape<gphys_segment>, with_an_epsilon<gphys_segment>);
    prove(count, examine<gphys_obb>("contains OBB", 17, false, of_axes), library<gphys_obb>,
          of_a_grown_shape<gphys_obb>, with_an_epsilon<gphys_obb>);
}

TEST_CASE("points are within a tolerance of shapes when they are, but for roundings of the distance", "[contains]") {
    const long count = cases(5000, 10000000);
    prove(count, examine<gphys_sphere>("within of sphere", 21, true, of_curves), library<gphys_sphere>,
          of_a_grown_shape<gphys_sphere>);
    prove(count, examine<gphys_capsule>("within of capsule", 22, true, of_curves), library<gphys_capsule>,
          of_a_grown_shape<gphys_capsule>);
    prove(count, examine<gphys_aabb>("within of AABB", 23, true, of_curves), library<gphys_aabb>,
          of_a_grown_shape<gphys_aabb>);
    prove(count, examine<gphys_triangle>("within of triangle", 24, true, of_curves), library<gphys_triangle>,
          of_a_grown_shape<gphys_triangle>);
    prove(count, examine<gphys_plane>("within of plane", 25, true, of_curves), library<gphys_plane>,
          of_a_grown_shape<gphys_plane>);
    prove(count, examine<gphys_segment>("within of segment", 26, true, of_curves), library<gphys_segment>,
          of_a_grown_shape<gphys_segment>);
    prove(count, examine<gphys_obb>("within of OBB", 27, true, of_axes), library<gphys_obb>,
          of_a_grown_shape<gphys_obb>);
}

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

Point foot_on_triangle(const Point& a, const Point& b, const Point& c, const Point& p) {
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
Point foot(const gphys_triangle& t, const Point& p) { return foot_on_triangle(exact(t.a), exact(t.b), exact(t.c), p); }
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

template <class S>
double largest_coordinate(const S& shape) {
    const Rounded<double> rounded = rounded_of<double>(shape, {});
    double size = 0;
    for (const auto& corner : rounded.corners) size = std::max(size, largest(corner) + rounded.radius);
    return size;
}
/// A plane is as far out as its point nearest to the origin.
double largest_coordinate(const gphys_plane& plane) { return std::fabs(plane.distance) / length(widen(plane.normal)); }

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
            const double w = std::max(largest(widen(point)), largest_coordinate(shape));
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

namespace {

using Nearby = gphys_nearest (*)(const gphys_scene*, const gphys_vec3&);

gphys_nearest of_scene(const gphys_scene* scene, const gphys_vec3& point) {
    gphys_nearest nearest;
    REQUIRE(gphys_scene_nearest(scene, &point, INFINITY, GPHYS_ALL_LAYERS, &nearest) == GPHYS_OK);
    return nearest;
}
gphys_nearest of_scene_further(const gphys_scene* scene, const gphys_vec3& point) {
    gphys_nearest nearest = of_scene(scene, point);
    nearest.distance = after(after(nearest.distance));
    return nearest;
}
/// As if its coordinates had gone through floats.
gphys_nearest of_scene_in_floats(const gphys_scene* scene, const gphys_vec3& point) {
    gphys_nearest nearest = of_scene(scene, point);
    nearest.distance = static_cast<float>(distance(widen(nearest.point), widen(point)));
    return nearest;
}

/// Of a mesh of one triangle or the triangle itself as a model, placed by any transform.
auto examine_placed(const char* name, uint64_t seed, bool as_mesh) {
    return [=](Nearby nearest, long count) {
        Cases c(seed);
        Score score(name, 1, "of the bound");
        for (long i = 0; i < count; ++i, c.next()) {
            gphys_triangle t;
            c.make(t);
            if (c.is_subnormal()) continue;
            const double reach = 1e7 * std::pow(10.0, c.random.uniform(-7, 0));
            const gphys_transform placed{narrow(c.random.direction() * reach), c.rotation(),
                                         static_cast<float>(std::pow(10.0, c.random.uniform(-2, 2)))};
            gphys_scene* scene = nullptr;
            REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
            gphys_model_id model;
            if (as_mesh) {
                const uint32_t indices[3] = {0, 1, 2};
                gphys_mesh* mesh = nullptr;
                REQUIRE(gphys_mesh_create(nullptr, &t.a.x, sizeof(gphys_vec3), 3, indices, 3, &mesh) == GPHYS_OK);
                REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, &placed, nullptr, &model) == GPHYS_OK);
                gphys_mesh_destroy(mesh);
            } else {
                REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_TRIANGLE, &t, &placed, nullptr, &model) == GPHYS_OK);
            }
            const Rotation rotation(placed.rotation);
            const auto world = [&](const gphys_vec3& v) {
                return exact(placed.position) + rotation.out(exact_vector(v)) * Number(placed.scale);
            };
            const Point a = world(t.a), b = world(t.b), d = world(t.c);
            const Vec3 corner{rounded(a.x()), rounded(a.y()), rounded(a.z())};
            const gphys_vec3 point =
                narrow(corner + c.random.direction() * (placed.scale * c.scale() * c.random.uniform(0, 2)));
            const gphys_nearest given = nearest(scene, point);
            gphys_scene_destroy(scene);
            const Point p = exact(point), on = foot_on_triangle(a, b, d, p);
            const BigVec offset = big(CGAL::ORIGIN + (on - p));
            const Big away = sqrt(dot(offset, offset));
            score.answer(away > 0, away > 0, t, placed, point);
            const double w = largest(corner) + largest(widen(point)) + largest(widen(placed.position)) +
                             placed.scale * (largest(widen(t.a)) + largest(widen(t.b)) + largest(widen(t.c)));
            const double bound = ulp_of(rounded(away)) + 0x1p-52 * w;
            score.error(error_of(given.distance, away) / bound, t, placed, point);
            const BigVec there = big(on);
            for (const double error : {error_of(given.point.x, there.x), error_of(given.point.y, there.y),
                                       error_of(given.point.z, there.z)}) {
                score.error(error / ulp_of(w), t, placed, point);
            }
        }
        return score;
    };
}

}  // namespace

TEST_CASE("distances in a scene are within an ulp and 2^-52 of the largest coordinate", "[closest]") {
    const long count = cases(3000, 1000000);
    for (const bool as_mesh : {false, true}) {
        const auto examine = examine_placed(as_mesh ? "nearest of a placed mesh" : "nearest of a placed triangle",
                                            as_mesh ? 37 : 38, as_mesh);
        const Score score = examine(of_scene, count);
        score.print();
        CHECK(score.kept());
        CHECK_FALSE(examine(of_scene_further, spoiled_cases).kept());
        CHECK_FALSE(examine(of_scene_in_floats, spoiled_cases).kept());
    }
}

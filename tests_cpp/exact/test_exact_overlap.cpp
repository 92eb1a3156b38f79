// The exact promises beside CGAL's exact kernel: no wrong answer, on grids so small that nearly
// everything touches, is coplanar, collinear or coincides, and one ulp away from that.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include "intersect/intersect.h"

#include "test.h"

using namespace gphys;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_3 exact(Vec3 v) { return {v.x, v.y, v.z}; }

/// Corners on a grid of 5^3 points, and every few cases moved by an ulp.
Vec3 grid_point(test::Random& random) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = double(random.index(5)) - 2;
    if (random.index(6) == 0) {
        const int k = int(random.index(3));
        p[k] = std::nextafterf(static_cast<float>(p[k]), random.index(2) ? 9.0f : -9.0f);
    }
    return p;
}
/// Or anywhere, near the plane of three others.
Vec3 near_plane(test::Random& random, const Triangle& t) {
    const double u = random.uniform(-.5, 1.5), v = random.uniform(-.5, 1.5);
    return widen(narrow(t.a + (t.b - t.a) * u + (t.c - t.a) * v));
}

/// CGAL throws at degenerate triangles, so they are given to it as what they are.
template <class Answer>
bool with_simplex(const Triangle& t, const Answer& answer) {
    const auto a = exact(t.a), b = exact(t.b), c = exact(t.c);
    if (!CGAL::collinear(a, b, c)) return answer(Kernel::Triangle_3(a, b, c));
    const auto first = std::min({a, b, c}), last = std::max({a, b, c});
    if (first == last) return answer(first);
    return answer(Kernel::Segment_3(first, last));
}

bool do_intersect(const Kernel::Point_3& a, const Kernel::Point_3& b) { return a == b; }
bool do_intersect(const Kernel::Point_3& a, const Kernel::Segment_3& b) { return b.has_on(a); }
bool do_intersect(const Kernel::Segment_3& a, const Kernel::Point_3& b) { return a.has_on(b); }
bool do_intersect(const Kernel::Point_3& a, const Kernel::Triangle_3& b) { return b.has_on(a); }
bool do_intersect(const Kernel::Triangle_3& a, const Kernel::Point_3& b) { return a.has_on(b); }
bool do_intersect(const Kernel::Iso_cuboid_3& a, const Kernel::Point_3& b) { return !a.has_on_unbounded_side(b); }
template <class A, class B>
bool do_intersect(const A& a, const B& b) {
    return CGAL::do_intersect(a, b);
}

bool reference(const Triangle& a, const Triangle& b) {
    return with_simplex(
        a, [&](const auto& s) { return with_simplex(b, [&](const auto& t) { return do_intersect(s, t); }); });
}

Triangle grid_triangle(test::Random& random) { return {grid_point(random), grid_point(random), grid_point(random)}; }

Triangle any_triangle(test::Random& random) {
    const Triangle base{widen(random.point(2)), widen(random.point(2)), widen(random.point(2))};
    return base;
}

}  // namespace

TEST_CASE("triangles overlap exactly when CGAL says so") {
    test::Random random(1);
    int overlapping = 0;
    for (int i = 0; i < 200000; ++i) {
        Triangle a = grid_triangle(random), b = grid_triangle(random);
        if (i % 4 == 0) {
            a = any_triangle(random);
            b = {near_plane(random, a), near_plane(random, a), random.index(2) ? a.b : near_plane(random, a)};
        }
        const bool expected = reference(a, b);
        overlapping += expected;
        if (overlaps(a, b) != expected) FAIL("case " << i);
    }
    REQUIRE(overlapping > 20000);
    REQUIRE(overlapping < 180000);
}

TEST_CASE("boxes and triangles overlap exactly when CGAL says so") {
    test::Random random(2);
    int overlapping = 0;
    for (int i = 0; i < 100000; ++i) {
        const Triangle t = i % 3 ? grid_triangle(random) : any_triangle(random);
        // CGAL's box must not be flat.
        const Vec3 p = grid_point(random), q = grid_point(random) + Vec3{.5, .5, .5};
        const Aabb box{min(p, q), max(p, q)};
        const Kernel::Iso_cuboid_3 cuboid(exact(box.min), exact(box.max));
        const bool expected = with_simplex(t, [&](const auto& s) { return do_intersect(cuboid, s); });
        overlapping += expected;
        if (overlaps(box, t) != expected) FAIL("case " << i);
    }
    REQUIRE(overlapping > 10000);
    REQUIRE(overlapping < 90000);
}

TEST_CASE("containment with tolerance 0 is exactly CGAL's") {
    test::Random random(3);
    int inside[5] = {};
    for (int i = 0; i < 200000; ++i) {
        const Triangle t = i % 2 ? grid_triangle(random) : any_triangle(random);
        const Vec3 p = i % 2 ? grid_point(random) : near_plane(random, t);
        const auto point = exact(p), a = exact(t.a), b = exact(t.b);
        const bool in_triangle = with_simplex(t, [&](const auto& s) { return do_intersect(s, point); });
        REQUIRE(contains(t, p, 0) == in_triangle);
        const bool on_segment = a == b ? a == point : Kernel::Segment_3(a, b).has_on(point);
        REQUIRE(contains(Segment{t.a, t.b}, p, 0) == on_segment);
        bool on_ray = false, on_plane = false;
        if (a != b) {
            const Vec3 along = t.b - t.a;
            on_ray = Kernel::Ray_3(a, Kernel::Vector_3(along.x, along.y, along.z)).has_on(point);
            REQUIRE(contains(Ray{t.a, along, infinity}, p, 0) == on_ray);
            // The plane through a with the normal b, if b is not 0.
            const Kernel::FT distance =
                Kernel::FT(t.b.x) * t.a.x + Kernel::FT(t.b.y) * t.a.y + Kernel::FT(t.b.z) * t.a.z;
            const Kernel::FT height = Kernel::FT(t.b.x) * p.x + Kernel::FT(t.b.y) * p.y + Kernel::FT(t.b.z) * p.z;
            const float rounded = static_cast<float>(CGAL::to_double(distance));
            if (t.b != Vec3{}) {
                on_plane = height == Kernel::FT(rounded);
                REQUIRE(contains(Plane{t.b, rounded}, p, 0) == on_plane);
            }
        }
        // A sphere around a whose radius is the distance of b, rounded.
        const float radius = static_cast<float>(distance(t.a, t.b));
        const bool in_sphere = CGAL::squared_distance(a, point) <= Kernel::FT(radius) * Kernel::FT(radius);
        REQUIRE(contains(Sphere{t.a, radius}, p, 0) == in_sphere);
        inside[0] += in_triangle, inside[1] += on_segment, inside[2] += on_ray, inside[3] += on_plane;
        inside[4] += in_sphere;
    }
    for (int count : inside) REQUIRE(count > 1000);
}

namespace {

/// Whether a system of half-spaces has a solution, by CGAL's exact linear programming.
class Program {
public:
    void at_least(Vec3 normal, Vec3 origin, double distance) {
        for (int k = 0; k < 3; ++k) program_.set_a(k, rows_, CGAL::Gmpq(normal[k]));
        CGAL::Gmpq right(distance);
        for (int k = 0; k < 3; ++k) right += CGAL::Gmpq(normal[k]) * CGAL::Gmpq(origin[k]);
        program_.set_b(rows_++, right);
    }
    void add(const Frustum& f) {
        for (const Plane& p : f.planes) at_least(p.normal, f.origin, p.distance);
    }
    void add(const Aabb& b) {
        for (int k = 0; k < 3; ++k) {
            Vec3 axis;
            axis[k] = 1;
            at_least(axis, b.min, 0);
            at_least(-axis, b.max, 0);
        }
    }
    void add(const Plane& p) {
        at_least(p.normal, {}, p.distance);
        at_least(-p.normal, {}, -p.distance);
    }
    bool feasible() const { return !CGAL::solve_linear_program(program_, CGAL::Gmpq()).is_infeasible(); }

    // Free variables x, y, z.
    CGAL::Quadratic_program<CGAL::Gmpq> program_{CGAL::LARGER, false, CGAL::Gmpq(0), false, CGAL::Gmpq(0)};
    int rows_ = 0;
};

/// The triangle's points as weights of its corners: non-negative, of sum 1.
bool reference(const Triangle& t, const Frustum& f) {
    CGAL::Quadratic_program<CGAL::Gmpq> program(CGAL::LARGER, true, CGAL::Gmpq(0), false, CGAL::Gmpq(0));
    const Vec3 corner[3] = {t.a, t.b, t.c};
    for (int i = 0; i < 6; ++i) {
        for (int c = 0; c < 3; ++c) {
            CGAL::Gmpq height(0);
            for (int k = 0; k < 3; ++k) {
                height += CGAL::Gmpq(f.planes[i].normal[k]) * (CGAL::Gmpq(corner[c][k]) - CGAL::Gmpq(f.origin[k]));
            }
            program.set_a(c, i, height);
        }
        program.set_b(i, CGAL::Gmpq(f.planes[i].distance));
    }
    for (int c = 0; c < 3; ++c) program.set_a(c, 6, CGAL::Gmpq(1));
    program.set_b(6, CGAL::Gmpq(1));
    program.set_r(6, CGAL::EQUAL);
    return !CGAL::solve_linear_program(program, CGAL::Gmpq()).is_infeasible();
}

/// Six half-spaces of small integers: boxes, pyramids, wedges, slabs, infinite or empty sets, with
/// planes that repeat or contradict each other.
Frustum grid_frustum(test::Random& random) {
    Frustum f;
    f.origin = grid_point(random);
    const bool pyramid = random.index(2) == 0;
    const Plane usual[6] = {{{0, 0, 1}, double(random.index(3))},
                            {{0, 0, -1}, -double(random.index(5))},
                            {{1, 0, 1}, 0},
                            {{-1, 0, 1}, 0},
                            {{0, 1, 1}, 0},
                            {{0, -1, 1}, 0}};
    for (int i = 0; i < 6; ++i) {
        f.planes[i] = usual[i];
        if (pyramid && random.index(8) > 0) continue;
        Vec3 n;
        for (int k = 0; k < 3; ++k) n[k] = double(random.index(3)) - 1;
        if (n == Vec3{}) n.x = 1;
        f.planes[i] = {n, double(random.index(4)) - 2};
    }
    if (random.index(4) == 0) f.planes[GPHYS_FRUSTUM_FAR] = {{}, -1};
    return f;
}

}  // namespace

TEST_CASE("frusta of any form overlap exactly when a linear program has a solution") {
    test::Random random(4);
    int overlapping[4] = {};
    const int count = 4000;
    for (int i = 0; i < count; ++i) {
        const Frustum f = grid_frustum(random), g = grid_frustum(random);
        const Vec3 p = grid_point(random), q = grid_point(random);
        const Aabb box{min(p, q), max(p, q)};
        const Triangle triangle = grid_triangle(random);
        Plane plane = g.planes[0];
        plane.distance = double(random.index(5)) - 2;
        Program with_frustum, with_box, with_plane;
        with_frustum.add(f);
        with_frustum.add(g);
        with_box.add(f);
        with_box.add(box);
        with_plane.add(f);
        with_plane.add(plane);
        const bool expected[4] = {with_frustum.feasible(), with_box.feasible(), with_plane.feasible(),
                                  reference(triangle, f)};
        const Shape other[4] = {g, box, plane, triangle};
        for (int k = 0; k < 4; ++k) {
            overlapping[k] += expected[k];
            if (overlaps(f, other[k]) != expected[k]) FAIL("other " << k << " case " << i);
        }
        // A point is a box too.
        Program point;
        point.add(f);
        point.add(Aabb{p, p});
        REQUIRE(contains(f, p, 0) == point.feasible());
        Vec3 nearest;
        Program alone;
        alone.add(f);
        REQUIRE(closest_point(f, p, nearest) == alone.feasible());
    }
    for (int k : overlapping) {
        REQUIRE(k > count / 10);
        REQUIRE(k < count * 9 / 10);
    }
}

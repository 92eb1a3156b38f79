// The exact promises beside CGAL's exact kernel: no wrong answer, on grids so small that nearly
// everything touches, is coplanar, collinear or coincides, and one ulp away from that.
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include "certified_program.h"
#include "score.h"

using namespace gphys;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_3 exact(Vec3 v) { return {v.x, v.y, v.z}; }

/// Corners on a grid of 5^3 points, every few cases moved by an ulp, or with a number of another size among
/// their coordinates.
Vec3 grid_point(test::Random& random) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = double(random.index(5)) - 2;
    if (random.index(6) == 0) {
        const int k = int(random.index(3));
        p[k] = std::nextafterf(static_cast<float>(p[k]), random.index(2) ? 9.0f : -9.0f);
    }
    if (random.index(8) == 0) p[int(random.index(3))] = test::mixed_number(random);
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

using test::Binary;
using test::HalfSpaces;
using test::VectorOf;

// Half-spaces in numbers of any kind.

template <class T>
void add(HalfSpaces<T>& spaces, const gphys_vec3& normal, const gphys_vec3& origin, const T& distance) {
    const VectorOf<T> n(normal);
    spaces.push_back({n, dot(n, VectorOf<T>(origin)) + distance});
}
template <class T>
void add(HalfSpaces<T>& spaces, const gphys_frustum& f) {
    for (const gphys_plane& p : f.planes) add(spaces, p.normal, f.origin, T(p.distance));
}
template <class T>
void add(HalfSpaces<T>& spaces, const gphys_aabb& b) {
    const gphys_vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, against[3] = {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    for (const gphys_vec3& axis : axes) add(spaces, axis, b.min, T(0));
    for (const gphys_vec3& axis : against) add(spaces, axis, b.max, T(0));
}
template <class T>
void add(HalfSpaces<T>& spaces, const gphys_plane& p) {
    add(spaces, p.normal, {}, T(p.distance));
    add(spaces, {-p.normal.x, -p.normal.y, -p.normal.z}, {}, -T(p.distance));
}
template <class T, class Other>
HalfSpaces<T> common(const gphys_frustum& f, const Other& other) {
    HalfSpaces<T> spaces;
    add(spaces, f);
    add(spaces, other);
    return spaces;
}
/// Of the triangle's points a + x (b - a) + y (c - a); z is free.
template <class T>
HalfSpaces<T> common(const gphys_frustum& f, const gphys_triangle& t) {
    HalfSpaces<T> spaces;
    for (const gphys_plane& p : f.planes) {
        const auto height = [&](const gphys_vec3& corner) {
            return dot(VectorOf<T>(p.normal), VectorOf<T>(corner) - VectorOf<T>(f.origin)) - T(p.distance);
        };
        const T at_a = height(t.a);
        spaces.push_back({{height(t.b) - at_a, height(t.c) - at_a, T(0)}, -at_a});
    }
    spaces.push_back({{T(1), T(0), T(0)}, T(0)});
    spaces.push_back({{T(0), T(1), T(0)}, T(0)});
    spaces.push_back({{T(-1), T(-1), T(0)}, T(-1)});
    return spaces;
}
template <class T>
HalfSpaces<T> common(const gphys_frustum& f, const gphys_vec3&) {
    HalfSpaces<T> spaces;
    add(spaces, f);
    return spaces;
}

/// By CGAL's exact linear programming, in free variables x, y, z.
bool solve(const HalfSpaces<Binary>& spaces) {
    CGAL::Quadratic_program<Binary> program(CGAL::LARGER, false, Binary(0), false, Binary(0));
    int row = 0;
    for (const auto& space : spaces) {
        program.set_a(0, row, space.normal.x);
        program.set_a(1, row, space.normal.y);
        program.set_a(2, row, space.normal.z);
        program.set_b(row++, space.distance);
    }
    return !CGAL::solve_linear_program(program, Binary()).is_infeasible();
}

/// Whether a frustum and another shape have a common point, or the frustum alone has one.
template <class Other>
bool truth(const gphys_frustum& f, const Other& other) {
    const auto proven = test::is_feasible([&](auto number) { return common<decltype(number)>(f, other); });
    return proven ? *proven : solve(common<Binary>(f, other));
}

/// Six half-spaces of small integers: boxes, pyramids, wedges, slabs, infinite or empty sets, with
/// planes that repeat or contradict each other.
gphys_frustum grid_frustum(test::Random& random) {
    const auto small = [&](uint32_t count, int least) { return static_cast<float>(int(random.index(count)) + least); };
    gphys_frustum f{narrow(grid_point(random)),
                    {{{0, 0, 1}, small(3, 0)},
                     {{0, 0, -1}, -small(5, 0)},
                     {{1, 0, 1}, 0},
                     {{-1, 0, 1}, 0},
                     {{0, 1, 1}, 0},
                     {{0, -1, 1}, 0}}};
    const bool pyramid = random.index(2) == 0;
    for (gphys_plane& plane : f.planes) {
        if (pyramid && random.index(8) > 0) continue;
        do plane.normal = {small(3, -1), small(3, -1), small(3, -1)};
        while (widen(plane.normal) == Vec3{});
        plane.distance = small(4, -2);
        if (random.index(8) == 0) plane.normal.y = test::mixed_number(random);
        if (random.index(8) == 0) plane.distance = test::mixed_number(random);
        // Not so far out that it is refused.
        if (gphys_shape_validate(GPHYS_SHAPE_PLANE, &plane) != GPHYS_OK) plane = {{0, 1, 0}, small(4, -2)};
    }
    if (random.index(4) == 0) f.planes[GPHYS_FRUSTUM_FAR] = {{}, -1};
    return f;
}

/// That of a camera, as near to others as it is large.
gphys_frustum camera_frustum(test::Random& random) {
    const gphys::Mat3 axes = rotation_matrix(widen(random.rotation()));
    const double width = random.uniform(.1, 1.5), height = random.uniform(.1, 1.5), near = random.uniform(.01, .5);
    const auto plane = [](Vec3 normal, double distance) {
        return gphys_plane{narrow(normalized(normal)), static_cast<float>(distance)};
    };
    return {
        narrow(random.direction() * random.uniform(0, 3)),
        {plane(axes.z, near), plane(-axes.z, -near - random.uniform(.1, 4)), plane(axes.x + axes.z * width, 0),
         plane(-axes.x + axes.z * width, 0), plane(axes.y + axes.z * height, 0), plane(-axes.y + axes.z * height, 0)}};
}

gphys_frustum any_frustum(test::Random& random) {
    return random.index(3) ? grid_frustum(random) : camera_frustum(random);
}

void make(test::Random& random, gphys_frustum& f) { f = any_frustum(random); }
void make(test::Random& random, gphys_aabb& b) {
    const Vec3 p = grid_point(random), q = grid_point(random);
    b = {narrow(min(p, q)), narrow(max(p, q))};
}
void make(test::Random& random, gphys_plane& p) {
    do {
        p = grid_frustum(random).planes[0];
        p.distance = static_cast<float>(random.index(5)) - 2;
    } while (gphys_shape_validate(GPHYS_SHAPE_PLANE, &p) != GPHYS_OK);  // too far out
}
void make(test::Random& random, gphys_vec3& p) { p = narrow(grid_point(random)); }
void make(test::Random& random, gphys_triangle& t) {
    t = {narrow(grid_point(random)), narrow(grid_point(random)), narrow(grid_point(random))};
}

// A rotated box, of which the contract leaves open what 2^-40 of the pair's size decides.

/// Its sides lie further out by `more`. The columns of the rotation, times the square of the quaternion,
/// are polynomials.
template <class T>
HalfSpaces<T> common(const gphys_frustum& f, const gphys_obb& b, double more) {
    HalfSpaces<T> spaces;
    add(spaces, f);
    const T x(b.rotation.x), y(b.rotation.y), z(b.rotation.z), w(b.rotation.w), two(2);
    const T unit = x * x + y * y + z * z + w * w;
    const VectorOf<T> axes[3] = {{unit - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)},
                                 {two * (x * y - w * z), unit - two * (x * x + z * z), two * (y * z + w * x)},
                                 {two * (x * z + w * y), two * (y * z - w * x), unit - two * (x * x + y * y)}};
    const float half[3] = {b.half_extents.x, b.half_extents.y, b.half_extents.z};
    for (int k = 0; k < 3; ++k) {
        const T middle = dot(axes[k], VectorOf<T>(b.center)), reach = (T(half[k]) + T(more)) * unit;
        spaces.push_back({axes[k], middle - reach});
        spaces.push_back({-axes[k], -middle - reach});
    }
    return spaces;
}
bool truth(const gphys_frustum& f, const gphys_obb& b, double more) {
    const auto proven = test::is_feasible([&](auto number) { return common<decltype(number)>(f, b, more); });
    return proven ? *proven : solve(common<Binary>(f, b, more));
}

template <class Other>
using Overlaps = bool (*)(const gphys_frustum&, const Other&);

template <class Other>
bool library(const gphys_frustum& f, const Other& other) {
    int32_t overlaps = -1;
    REQUIRE(gphys_shape_overlaps(GPHYS_SHAPE_FRUSTUM, &f, test::type_of(other), &other, &overlaps) == GPHYS_OK);
    return overlaps == 1;
}
/// Larger by an ulp on every side.
template <class Other>
bool of_a_grown_frustum(const gphys_frustum& frustum, const Other& other) {
    gphys_frustum f = frustum;
    for (gphys_plane& plane : f.planes) {
        if (widen(plane.normal) != Vec3{}) plane.distance = std::nextafterf(plane.distance, -FLT_MAX);
    }
    return library(f, other);
}
/// As most engines do it: not wholly outside of one plane.
bool by_planes(const gphys_frustum& f, const gphys_aabb& box) {
    for (const gphys_plane& p : f.planes) {
        const Vec3 n = widen(p.normal), low = widen(box.min), high = widen(box.max);
        const Vec3 far{n.x > 0 ? high.x : low.x, n.y > 0 ? high.y : low.y, n.z > 0 ? high.z : low.z};
        if (dot(n, far - widen(f.origin)) < p.distance) return false;
    }
    return true;
}

bool contains_point(const gphys_frustum& f, const gphys_vec3& p) { return contains(widen(f), widen(p), 0); }
bool contains_point_nearly(const gphys_frustum& f, const gphys_vec3& p) { return contains(widen(f), widen(p), 1e-6); }
bool truth_of_point(const gphys_frustum& f, const gphys_vec3& p) {
    const auto spaces = common<Binary>(f, p);
    return std::all_of(spaces.begin(), spaces.end(),
                       [&](const auto& space) { return dot(space.normal, VectorOf<Binary>(p)) >= space.distance; });
}

/// A frustum that is not empty has a point nearest to any other.
bool has_a_nearest(const gphys_frustum& f, const gphys_vec3& p) {
    Vec3 nearest;
    return closest_point(widen(f), widen(p), nearest);
}
bool always(const gphys_frustum&, const gphys_vec3&) { return true; }

template <class Other>
auto examine(const char* name, uint64_t seed, Overlaps<Other> truth) {
    return [=](Overlaps<Other> overlaps, long count) {
        test::Random random(test::seed_of_part(seed));
        test::Score score(name);
        for (long i = 0; i < count; ++i) {
            const gphys_frustum f = any_frustum(random);
            Other other;
            make(random, other);
            score.answer(overlaps(f, other), truth(f, other), f, other);
        }
        return score;
    };
}

template <class Other, class... Spoiled>
void prove_overlap(const char* name, uint64_t seed, const Spoiled&... spoiled) {
    test::prove(test::cases(3000, 10000000), examine<Other>(name, seed, truth<Other>), library<Other>,
                of_a_grown_frustum<Other>, spoiled...);
}

}  // namespace

TEST_CASE("frusta of any form overlap exactly when a linear program has a solution", "[frustum]") {
    prove_overlap<gphys_frustum>("overlap frustum-frustum", 91);
    prove_overlap<gphys_aabb>("overlap frustum-AABB", 92, by_planes);
    prove_overlap<gphys_plane>("overlap frustum-plane", 93);
    prove_overlap<gphys_triangle>("overlap frustum-triangle", 94);
}

TEST_CASE("frusta and rotated boxes overlap when a linear program has a solution, but for 2^-40 of their size",
          "[frustum]") {
    const auto examine_boxes = [](Overlaps<gphys_obb> overlaps, long count) {
        test::Cases c(97);
        test::Random& random = c.random;
        test::Score score("overlap frustum-OBB");
        for (long i = 0; i < count; ++i) {
            const gphys_frustum f = any_frustum(random);
            const auto half = [&] { return static_cast<float>(random.index(3)); };
            gphys_obb box{narrow(grid_point(random)), {half(), half(), half()}, c.rotation()};
            if (c.one_in(2)) c.nudge(box.half_extents);
            box.half_extents = narrow(abs(widen(box.half_extents)));
            const double size =
                test::largest(widen(box.center) - widen(f.origin)) + test::largest(widen(box.half_extents));
            const double band = 0x1p-40 * size;
            score.answer(overlaps(f, box), truth(f, box, band), !truth(f, box, -band), f, box);
        }
        return score;
    };
    const auto of_a_larger_box = [](const gphys_frustum& f, const gphys_obb& box) {
        return library(f, test::grown(box));
    };
    test::prove(test::cases(3000, 10000000), examine_boxes, library<gphys_obb>, of_a_grown_frustum<gphys_obb>,
                of_a_larger_box);
}

TEST_CASE("a point is in a frustum, and has a nearest one there, exactly when a linear program has a solution",
          "[frustum]") {
    const long count = test::cases(3000, 10000000);
    test::prove(count, examine<gphys_vec3>("contains frustum", 95, truth_of_point), contains_point,
                contains_point_nearly);
    test::prove(count, examine<gphys_vec3>("frustum has a nearest point", 96, truth<gphys_vec3>), has_a_nearest,
                always);
}

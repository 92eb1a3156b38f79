// Bounds that are outward and tight, placement there and back, and corners of frusta.
#include "shapes/shapes.h"

#include "convex_hull.h"
#include "shapes/halfspaces.h"
#include "test.h"

using namespace gphys;

namespace {

/// Bounds hold low..high (in double) and not an ulp more than they must.
void check_bounds(const Box& box, const test::Hull& hull) {
    for (int k = 0; k < 3; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (const Vec3& c : hull.corners) {
            const double v = k == 0 ? c.x : k == 1 ? c.y : c.z;
            low = std::min(low, v - hull.radius);
            high = std::max(high, v + hull.radius);
        }
        // The reference itself rounds by 2^-64 of its terms.
        const double slack = 0x1p-50 * std::max(std::fabs(low), std::fabs(high));
        REQUIRE(box.min[k] <= low + slack);
        REQUIRE(box.max[k] >= high - slack);
        const float inf = std::numeric_limits<float>::infinity();
        REQUIRE(std::nextafterf(std::nextafterf(box.min[k], inf), inf) > low - slack);
        REQUIRE(std::nextafterf(std::nextafterf(box.max[k], -inf), -inf) < high + slack);
    }
}

Transform random_transform(test::Random& random) {
    return {widen(random.point(50)), rotation_matrix(widen(random.rotation())), random.uniform(.1, 10)};
}

}  // namespace

TEST_CASE("bounds hold the shape and are an ulp wider at most") {
    test::Random random(1);
    for (int i = 0; i < 50000; ++i) {
        const float extent = static_cast<float>(std::pow(10.0, random.uniform(-20, 14)));
        const Vec3 a = widen(random.point(extent)), b = widen(random.point(extent)), c = widen(random.point(extent));
        const double size = static_cast<float>(std::pow(10.0, random.uniform(-30, 14)));
        const Sphere sphere{a, size};
        check_bounds(bounds(sphere), test::hull(sphere));
        const Capsule capsule{a, b, size};
        check_bounds(bounds(capsule), test::hull(capsule));
        const Triangle triangle{a, b, c};
        check_bounds(bounds(triangle), test::hull(triangle));
        const Obb box{a, abs(b), rotation_matrix(widen(random.rotation()))};
        check_bounds(bounds(box), test::hull(box));
        const Box exact = bounds(Aabb{min(a, b), max(a, b)});
        REQUIRE((exact.min[0] == std::min(a.x, b.x) && exact.max[2] == std::max(a.z, b.z)));
    }
}

TEST_CASE("a radius below the ulp of the centre still widens the bounds") {
    const Box box = bounds(Sphere{{1, -1, 0}, 1e-30});
    const float inf = std::numeric_limits<float>::infinity();
    REQUIRE(box.min[0] == std::nextafterf(1, -inf));
    REQUIRE(box.max[0] == std::nextafterf(1, inf));
    REQUIRE(box.min[1] == std::nextafterf(-1, -inf));
    REQUIRE(box.max[2] == 1e-30f);
}

TEST_CASE("bounds of a box that is not turned are its faces") {
    const Box box = bounds(Obb{{1, 2, 3}, {.5, .25, 2}, {}});
    REQUIRE((box.min[0] == .5f && box.max[1] == 2.25f && box.max[2] == 5));
}

TEST_CASE("bounds of frusta equal those of their corners, and infinite ones have none") {
    test::Random random(2);
    for (int i = 0; i < 5000; ++i) {
        const double near = random.uniform(.01, 1), far = near + random.uniform(.1, 100);
        const Mat3 axes = rotation_matrix(widen(random.rotation()));
        const Vec3 origin = widen(random.point(100));
        const test::View view =
            test::view(origin, axes, random.uniform(.1, 2), random.uniform(.1, 2), near, far, false);
        Box box;
        REQUIRE(bounds(view.frustum, box));
        check_bounds(box, view.hull);
        REQUIRE(bounds_of_six_sided(view.frustum, box));
        check_bounds(box, view.hull);
        Vec3 corner[8];
        REQUIRE(corners(view.frustum, corner));
        for (int k = 0; k < 8; ++k) {
            // The axes are orthogonal to 2^-52, which the depth multiplies.
            REQUIRE(length(corner[k] - view.hull.corners[k]) < 1e-13 * (far + 100));
        }
        const test::View endless = test::view(origin, axes, 1, 1, near, far, true);
        REQUIRE_FALSE(bounds(endless.frustum, box));
        REQUIRE_FALSE(bounds_of_six_sided(endless.frustum, box));
        REQUIRE_FALSE(corners(endless.frustum, corner));
    }
}

TEST_CASE("of any six planes a box is found quickly only if they are the sides of a body with eight corners") {
    test::Random random(4);
    int found = 0;
    for (int i = 0; i < 20000; ++i) {
        Frustum frustum{widen(random.point(10)), {}};
        for (Plane& plane : frustum.planes) plane = {widen(random.point(1)), random.uniform(-2, .2)};
        for (int k = 1; k < 6; k += 2) {  // often nearly opposite
            if (random.uniform(0, 1) < .7) {
                frustum.planes[k].normal = widen(random.point(.4f)) - frustum.planes[k - 1].normal;
            }
        }
        Box quick, box;
        if (!bounds_of_six_sided(frustum, quick)) continue;
        ++found;
        REQUIRE(bounds(frustum, box));
        for (int k = 0; k < 3; ++k) {
            const float tolerance = 1e-5f * std::max(std::fabs(box.min[k]), std::fabs(box.max[k]));
            REQUIRE(std::fabs(quick.min[k] - box.min[k]) <= tolerance);
            REQUIRE(std::fabs(quick.max[k] - box.max[k]) <= tolerance);
        }
    }
    REQUIRE(found > 1000);
    REQUIRE(found < 19000);
}

TEST_CASE("six planes that leave nothing, a slab or a prism are told apart") {
    Frustum cube{
        {0, 0, 0},
        {{{0, 0, 1}, -1}, {{0, 0, -1}, -1}, {{1, 0, 0}, -1}, {{-1, 0, 0}, -1}, {{0, 1, 0}, -1}, {{0, -1, 0}, -1}}};
    Box box;
    REQUIRE_FALSE(is_empty(cube));
    REQUIRE(bounds(cube, box));
    REQUIRE(box.max[0] >= 1);
    REQUIRE(box.max[0] <= 1 + 0x1p-22f);

    Frustum point = cube;
    for (Plane& plane : point.planes) plane.distance = 0;
    REQUIRE_FALSE(is_empty(point));
    REQUIRE_FALSE(bounds_of_six_sided(point, box));
    Frustum empty = point;
    empty.planes[1].distance = 1e-45;
    REQUIRE(is_empty(empty));
    REQUIRE(bounds(empty, box));
    REQUIRE(box.min[0] > box.max[0]);

    Frustum slab = cube;  // all normals along z
    for (int i = 2; i < 6; ++i) slab.planes[i] = slab.planes[i % 2];
    REQUIRE_FALSE(is_empty(slab));
    REQUIRE_FALSE(bounds(slab, box));
    REQUIRE_FALSE(bounds_of_six_sided(slab, box));
    slab.planes[5].distance = 1.5;
    REQUIRE(is_empty(slab));

    Frustum prism = cube;  // no end along z
    prism.planes[0] = prism.planes[2];
    prism.planes[1] = prism.planes[3];
    REQUIRE_FALSE(is_empty(prism));
    REQUIRE_FALSE(bounds(prism, box));
    prism.planes[5].distance = 1.5;
    REQUIRE(is_empty(prism));

    Frustum wedge = cube;  // stopped along z on one side only
    wedge.planes[1] = {{0, 1, -1}, -20};
    wedge.planes[4] = {{0, 1, 1}, 0};
    REQUIRE_FALSE(is_empty(wedge));
}

TEST_CASE("what is moved and seen from inside is where it was") {
    test::Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const Transform t = random_transform(random);
        const Vec3 a = widen(random.point(10)), b = widen(random.point(10)), p = widen(random.point(10));
        const Sphere sphere{a, 2};
        const Sphere back = std::get<Sphere>(inverse_transformed(transformed(sphere, t), t));
        // A few roundings of coordinates up to 150, divided by a scale of 0.1 at least.
        REQUIRE(distance(back.center, a) < 1e-12);
        REQUIRE(std::fabs(back.radius - 2) < 1e-14);
        // A point has the same height over a plane before and after, times the scale.
        const Plane plane{b, random.uniform(-3, 3)};
        const Plane moved = transformed(plane, t);
        const double before = dot(plane.normal, p) - plane.distance;
        const double after = dot(moved.normal, t.apply(p)) - moved.distance;
        REQUIRE(std::fabs(after - before * t.scale) < 1e-10);
        const Plane plane_back = std::get<Plane>(inverse_transformed(moved, t));
        REQUIRE(distance(plane_back.normal, plane.normal) < 1e-13);
        REQUIRE(std::fabs(plane_back.distance - plane.distance) < 1e-10);
        // Corners of a box go where the points go.
        const Aabb box{min(a, b), max(a, b)};
        const test::Hull corners_after = test::hull(transformed(box, t)), corners_before = test::hull(box);
        for (int k = 0; k < 8; ++k) {
            const Vec3 c = corners_before.corners[k];
            const Vec3 corner{double(c.x), double(c.y), double(c.z)};
            REQUIRE(length(corners_after.corners[k] - t.apply(corner)) < 1e-11);
        }
    }
}

TEST_CASE("a frustum moves with its points, and stays infinite") {
    test::Random random(4);
    for (int i = 0; i < 5000; ++i) {
        const Transform t = random_transform(random);
        const bool infinite = random.index(2);
        const test::View view =
            test::view(widen(random.point(3)), rotation_matrix(widen(random.rotation())), 1, .5, .1, 9, infinite);
        const Frustum moved = transformed(view.frustum, t);
        REQUIRE((moved.planes[GPHYS_FRUSTUM_FAR].normal == Vec3{}) == infinite);
        const Vec3 p = widen(random.point(5)), q = t.apply(p);
        for (int k = 0; k < 6; ++k) {
            const Plane &a = view.frustum.planes[k], &b = moved.planes[k];
            if (a.normal == Vec3{}) continue;
            const double before = dot(a.normal, p - view.frustum.origin) - a.distance;
            REQUIRE(std::fabs(dot(b.normal, q - moved.origin) - b.distance - before * t.scale) < 1e-11);
        }
    }
}

TEST_CASE("of any seven numbers it is told whether they are a ray") {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float max = GPHYS_MAX_COORDINATE, least = std::numeric_limits<float>::denorm_min();
    const float numbers[] = {0,   -0.0f, 1,   -1,   least, -least, std::numeric_limits<float>::min(),
                             max, -max,  inf, -inf, nan,   -nan,   std::nextafterf(max, inf)};
    test::Random random(911);
    const auto in_range = [&](float v) { return v >= -max && v <= max; };
    int valid = 0;
    for (int i = 0; i < 200000; ++i) {
        float ray[7];
        for (float& number : ray) number = numbers[random.index(random.index(2) == 0 ? 9 : 14)];
        const bool is_ray = std::all_of(ray, ray + 6, in_range) &&
                            std::any_of(ray + 3, ray + 6, [](float v) { return v != 0; }) && ray[6] >= 0;
        REQUIRE(!defect(gphys_ray{{ray[0], ray[1], ray[2]}, {ray[3], ray[4], ray[5]}, ray[6]}) == is_ray);
        valid += is_ray;
    }
    CHECK(valid > 5000);
}

TEST_CASE("every defect names the field") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto message = [](const auto& value) {
        REQUIRE(fail(GPHYS_ERROR_INVALID_ARGUMENT, "value", defect(value)) == GPHYS_ERROR_INVALID_ARGUMENT);
        return std::string(last_error());
    };
    REQUIRE(!defect(gphys_vec3{0, 0, 1e15f}));
    REQUIRE(message(gphys_vec3{0, nan, 0}) == "value.y nan is not from -1e15 to 1e15");
    REQUIRE(!defect(gphys_quat{0, 0, 0, 1.0009f}));
    REQUIRE(message(gphys_quat{0, 0, 0, 1.0011f}) == "value: length 1.0011 is not from 0.999 to 1.001");
    REQUIRE(defect(gphys_quat{0, 0, nan, 1}));
    REQUIRE(message(gphys_transform{{0, 0, 0}, {0, 0, 0, 1}, 0}) == "value.scale 0 is not above 0 and at most 1e15");
    REQUIRE(message(gphys_transform{{0, 2e15f, 0}, {0, 0, 0, 1}, 1}) ==
            "value.position.y 1999999973982208 is not from -1e15 to 1e15");
    REQUIRE(!defect(gphys_aabb{{0, 0, 0}, {0, 0, 0}}));
    REQUIRE(message(gphys_aabb{{0, 0, 1}, {0, 0, 0}}) == "value.min.z 1 is not at most max.z");
}

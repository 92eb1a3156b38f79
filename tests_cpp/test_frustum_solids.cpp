// Frusta as solids that others are swept against and pushed out of: each is the convex hull of its eight corners, and
// so is answered for as a mesh that is that hull.
#include "c_api/handles.h"
#include "mesh/mesh.h"
#include "solid_cases.h"

using namespace gphys;
using namespace test;

namespace {

class HullOfCorners {
public:
    explicit HullOfCorners(const Frustum& frustum) {
        Vec3 corner[8];
        REQUIRE(corners(frustum, corner));
        gphys_vec3 points[8];
        for (int i = 0; i < 8; ++i) points[i] = narrow(corner[i]);
        status = gphys_mesh_create_hull(nullptr, &points[0].x, sizeof points[0], 8, &mesh_);
    }
    ~HullOfCorners() { gphys_mesh_destroy(mesh_); }
    HullOfCorners(const HullOfCorners&) = delete;
    const Mesh& operator*() const { return *unwrap(mesh_); }

    gphys_status status;

private:
    gphys_mesh* mesh_ = nullptr;
};

/// A frustum and a hull that is the same set but for a distance: a solid that is larger by it meets the hull no later
/// than the solid meets the frustum, a smaller one no sooner.
struct Comparison {
    int contacts = 0, misses = 0, ways = 0, wrong_times = 0, wrong_depths = 0;

    void add(const Frustum& frustum, const Mesh& hull, const Shape& moving, Vec3 way, double but_for) {
        Hit hit, other;
        const bool meets = sweep(Shape(frustum), moving, way, hit);
        ++(meets ? contacts : misses);
        if (meets) wrong_times += !hull.sweep(grown(moving, but_for), way, other) || other.t > hit.t + 0x1p-50;
        if (has_thickness(moving, but_for) && hull.sweep(grown(moving, -but_for), way, other))
            wrong_times += !meets || other.t < hit.t - 0x1p-50;
        const bool is_in = overlaps(Shape(frustum), moving);
        ways += is_in;
        const double depth = is_in ? penetration(Shape(frustum), moving).depth : 0;
        double of_hull = 0;
        hull.for_each_penetration(moving, [&](const Penetration& out, uint32_t) { of_hull = out.depth; });
        wrong_depths += std::fabs(depth - of_hull) > but_for;
    }
};

#define CHECK_COMPARISON(comparison, count)                                          \
    do {                                                                             \
        INFO(comparison.contacts << " contacts, " << comparison.ways << " overlap"); \
        CHECK(comparison.contacts > count / 4);                                      \
        CHECK(comparison.misses > count / 20);                                       \
        CHECK(comparison.ways > count / 10);                                         \
        CHECK(comparison.wrong_times == 0);                                          \
        CHECK(comparison.wrong_depths == 0);                                         \
    } while (0)

/// What a camera sees, in floats.
Frustum seen_from(Vec3 origin, const Mat3& axes, double width, double height, double near, double far) {
    const View exact = view(origin, axes, width, height, near, far, false);
    gphys_frustum seen{narrow(origin), {}};
    for (int i = 0; i < 6; ++i) {
        const auto& [normal, distance] = exact.frustum.planes[i];
        seen.planes[i] = {narrow(normalized(normal)), static_cast<float>(distance / length(normal))};
    }
    return widen(seen);
}

Shape solid_at(Random& random, Vec3 at, double size) {
    const auto some = [&] { return size * random.uniform(0.1, 1); };
    const Vec3 half{some(), some(), some()};
    switch (random.index(4)) {
        case 0:
            return Sphere{at, some()};
        case 1:
            return Capsule{at - random.direction() * some(), at, some()};
        case 2:
            return Aabb{at - half, at + half};
        default:
            return Obb{at, half, rotation_matrix(widen(random.rotation()))};
    }
}

/// Solids on their way to some point of the frustum and past it.
void compare(Comparison& comparison, const Frustum& frustum, Random& random) {
    Vec3 corner[8];
    REQUIRE(corners(frustum, corner));
    const HullOfCorners hull(frustum);
    if (hull.status != GPHYS_OK) return;  // rounded to floats, the corners are in a plane
    double largest = 0, size = 0;
    for (const Vec3& p : corner) {
        largest = std::max(largest, max_component(abs(p)));
        size = std::max(size, length(p - corner[0]));
    }
    const double rounding = 0x1p-22 * largest;
    for (int i = 0; i < 20; ++i) {
        const Vec3 target = corner[random.index(8)] * 0.25 + corner[random.index(8)] * 0.75;
        const double reach = size * std::pow(10, random.uniform(-3, 0)) + 4 * rounding;
        const Vec3 start = target + random.direction() * (reach * random.uniform(0, 4));
        const Vec3 way =
            (target - start) * random.uniform(0.5, 3) + random.direction() * (reach * random.uniform(0, 2));
        comparison.add(frustum, *hull, solid_at(random, start, reach), way, rounding);
    }
}

}  // namespace

TEST_CASE("a frustum whose corners are floats is met and left as their hull is", "[sweep][penetration]") {
    const NoTraps watch;
    SolidCases solids(51);
    Comparison comparison;
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    for (const auto& [axes, width] :
         {std::pair{Mat3{x, y, z}, 1.0}, std::pair{Mat3{z, x, y}, 0.5}, std::pair{Mat3{-x, z, -y}, 0.25}}) {
        const Frustum frustum = view({-1, 0.5, -2}, axes, width, 0.5, 1, 4, false).frustum;
        const HullOfCorners hull(frustum);
        REQUIRE(hull.status == GPHYS_OK);
        for (int i = 0; i < 20000; ++i) {
            const SolidPair pair = solids.next(5);
            if (pair.size < 60) comparison.add(frustum, *hull, pair.moving, pair.way, 0x1p-38 * pair.size);
        }
    }
    CHECK_COMPARISON(comparison, 40000);
}

TEST_CASE("what a camera sees is met and left as the hull of its corners is", "[sweep][penetration]") {
    const NoTraps watch;
    Random random(52);
    Comparison comparison;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 origin = random.index(3) == 0 ? random_point(random, 1e6) : random_point(random, 10);
        const double width = std::pow(10, random.uniform(-2, 1)), height = width * random.uniform(0.5, 2);
        const double near = std::pow(10, random.uniform(-2, 2));
        const double far = near * (random.index(2) == 0 ? 1e4 : random.uniform(1.1, 10));
        const Mat3 axes = rotation_matrix(widen(random.rotation()));
        compare(comparison, seen_from(as_floats(origin), axes, width, height, near, far), random);
    }
    CHECK_COMPARISON(comparison, 20000);
}

TEST_CASE("a frustum counts as the hull of eight corners only if it is that", "[frustum]") {
    const NoTraps watch;
    Random random(53);
    int solid = 0, wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        Frustum frustum{
            grid_point(random, 2),
            {{{0, 0, 1}, 1}, {{0, 0, -1}, -3}, {{1, 0, 1}, 0}, {{-1, 0, 1}, 0}, {{0, 1, 1}, 0}, {{0, -1, 1}, 0}}};
        for (Plane& plane : frustum.planes) {
            if (random.index(4) == 0) plane.normal = grid_direction(random, 2);
            if (random.index(4) == 0) plane.distance = static_cast<double>(random.index(7)) - 3;
        }
        if (!is_hexahedron(frustum)) continue;
        ++solid;
        const test::Hull corners = hull(frustum);
        for (int k = 0; k < 8; ++k) {
            const Vec3 point = frustum.origin + random_point(random, 4);
            const double gap = test::gap(corners, hull(Sphere{point, 0})).gap;
            wrong += contains(frustum, point, 0) ? gap > 1e-12 : gap < -1e-12;
        }
    }
    CHECK(solid > 2000);
    CHECK(wrong == 0);
    // A plate of a thickness that is rounding is none.
    const auto plate = [](double thickness) {
        Frustum box{{0, 0, 0}, {}};
        const Vec3 axis[3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
        for (int k = 0; k < 3; ++k) {
            box.planes[2 * k] = {axis[k], 1};
            box.planes[2 * k + 1] = {-axis[k], k == 0 ? -1 - thickness : -2};
        }
        return box;
    };
    CHECK(is_hexahedron(plate(0x1p-30)));
    CHECK_FALSE(is_hexahedron(plate(0x1p-42)));
    CHECK_FALSE(is_hexahedron(plate(-1)));
}

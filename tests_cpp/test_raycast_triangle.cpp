#include <array>
#include <map>
#include <vector>

#include "ray_cases.h"

using namespace gphys;
using namespace test;

namespace {

constexpr int cases = 100000;

/// The times, within 0..t_max, at which a ray is on a triangle. Exact within the range of quad.h,
/// up to the one division.
struct Meeting {
    bool any = false;
    Quad t = 0, u = 0, v = 0;  // u, v only for a ray through the plane
    bool through_plane = false;
};

Meeting first_of(Quad from, Quad to, const Ray& ray) {
    Meeting result;
    if (from < 0) from = 0;
    result.any = from <= to && (ray.t_max == infinity || from <= Quad(ray.t_max));
    result.t = from;
    return result;
}

Meeting meet_segment(QVec3 p, QVec3 q, const Ray& ray) {
    const QVec3 o(ray.origin), d(ray.direction), e = q - p;
    const Quad dd = dot(d, d);
    if (is_zero(cross(d, e))) {  // parallel, or a point
        if (!is_zero(cross(d, p - o))) return {};
        Quad from = dot(p - o, d) / dd, to = dot(q - o, d) / dd;
        if (from > to) std::swap(from, to);
        return to < 0 ? Meeting{} : first_of(from, to, ray);
    }
    const QVec3 m = cross(d, e);
    const Quad mm = dot(m, m), s = dot(cross(p - o, d), m), t = dot(cross(p - o, e), m);
    if (dot(p - o, m) != 0 || s < 0 || s > mm || t < 0) return {};
    return first_of(t / mm, t / mm, ray);
}

/// Moeller and Trumbore 1997, without their epsilon; rays in the plane are clipped by the edges.
Meeting meet(const Triangle& triangle, const Ray& ray) {
    const QVec3 a(triangle.a), b(triangle.b), c(triangle.c), o(ray.origin), d(ray.direction);
    const QVec3 normal = cross(b - a, c - a);
    if (is_zero(normal)) {
        const Quad ab = dot(b - a, b - a), bc = dot(c - b, c - b), ca = dot(a - c, a - c);
        return ab >= bc && ab >= ca ? meet_segment(a, b, ray)
               : bc >= ca           ? meet_segment(b, c, ray)
                                    : meet_segment(c, a, ray);
    }
    const QVec3 p = cross(d, c - a), s = o - a, q = cross(s, b - a);
    Quad determinant = dot(b - a, p), u = dot(s, p), v = dot(d, q), t = dot(c - a, q);
    if (determinant < 0) determinant = -determinant, u = -u, v = -v, t = -t;
    if (determinant > 0) {
        if (u < 0 || v < 0 || u + v > determinant || t < 0) return {};
        Meeting result = first_of(t / determinant, t / determinant, ray);
        result.u = u / determinant;
        result.v = v / determinant;
        result.through_plane = true;
        return result;
    }
    if (dot(s, normal) != 0) return {};
    Quad from = 0, to = 1e300;
    for (const auto& [start, end] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        const QVec3 inward = cross(normal, end - start);
        const Quad depth = dot(inward, o - start), climb = dot(inward, d);
        if (climb == 0 && depth < 0) return {};
        if (climb > 0 && -depth / climb > from) from = -depth / climb;
        if (climb < 0 && -depth / climb < to) to = -depth / climb;
    }
    return first_of(from, to, ray);
}

struct Comparison {
    int hit_count = 0, miss_count = 0, in_plane_count = 0, false_answers = 0, unsound = 0;
    double worst_ulps = 0, worst_weight = 0;

    void add(const Triangle& triangle, const Ray& ray) {
        const Meeting truth = meet(triangle, ray);
        Hit hit;
        if (raycast(triangle, ray, hit) != truth.any) {
            ++false_answers;
            return;
        }
        ++(truth.any ? hit_count : miss_count);
        if (!truth.any) return;
        unsound += !is_sound(hit, ray) || hit.u < 0 || hit.v < 0 || hit.u + hit.v > 1;
        worst_ulps = std::max(worst_ulps, float_ulps(hit.t, truth.t));
        in_plane_count += !truth.through_plane;
        if (!truth.through_plane) return;
        worst_weight = std::max(worst_weight, static_cast<double>(absolute(Quad(hit.u) - truth.u)));
        worst_weight = std::max(worst_weight, static_cast<double>(absolute(Quad(hit.v) - truth.v)));
    }
};

// t keeps 2^-30 of itself, which is 2^-6 ulp of a float; weights keep 2^-26.
#define CHECK_COMPARISON(comparison)                                                                  \
    do {                                                                                              \
        INFO("hits " << comparison.hit_count << ", misses " << comparison.miss_count << ", in plane " \
                     << comparison.in_plane_count << ", worst t error " << comparison.worst_ulps      \
                     << " ulp, worst weight error " << comparison.worst_weight);                      \
        CHECK(comparison.false_answers == 0);                                                         \
        CHECK(comparison.unsound == 0);                                                               \
        CHECK(comparison.worst_ulps <= 0x1p-6);                                                       \
        CHECK(comparison.worst_weight <= 0x1p-26);                                                    \
        CHECK(comparison.hit_count > cases / 50);                                                     \
    } while (0)

/// A place inside, on an edge, at a corner, just outside.
Vec3 place_on(const Triangle& triangle, Random& random) {
    const double choices[] = {0, .5, 1, random.uniform(-.2, 1.2), random.uniform(0, 1)};
    const double u = choices[random.index(5)];
    const double v = random.index(2) == 0 ? 1 - u : choices[random.index(5)];
    return triangle.a + u * (triangle.b - triangle.a) + v * (triangle.c - triangle.a);
}

}  // namespace

TEST_CASE("raycast: a segment against a triangle answers the same when reversed", "[raycast]") {
    Random random(11);
    int hits = 0;
    for (int i = 0; i < cases; ++i) {
        const Triangle triangle{grid_point(random, 2), grid_point(random, 2), grid_point(random, 2)};
        const Segment forth{grid_point(random, 3), grid_point(random, 3)}, back{forth.b, forth.a};
        Hit hit_forth, hit_back;
        const bool found = raycast(triangle, ray_along(forth), hit_forth);
        if (found != raycast(triangle, ray_along(back), hit_back)) FAIL("reversed segment " << i << " differs");
        hits += found;
    }
    CHECK(hits > cases / 50);
}

TEST_CASE("raycast: a triangle is hit from both sides and says from which", "[raycast]") {
    const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    Hit hit;
    REQUIRE(raycast(triangle, Ray{{.25, .5, 2}, {0, 0, -1}}, hit));
    CHECK(hit.t == 2);
    CHECK(hit.u == .25);
    CHECK(hit.v == .5);
    CHECK(hit.normal == Vec3{0, 0, 1});
    CHECK(hit.flags == 0);
    REQUIRE(raycast(triangle, Ray{{.25, .5, -2}, {0, 0, 1}}, hit));
    CHECK(hit.normal == Vec3{0, 0, -1});
    CHECK(hit.flags == GPHYS_HIT_BACK);
}

TEST_CASE("raycast: a degenerate triangle is met like the segment or point that it is", "[raycast]") {
    const NoTraps watch;
    Hit hit;
    const Triangle segment{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}}, point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    REQUIRE(raycast(segment, Ray{{1, 1, 0}, {0, 0, 1}}, hit));
    CHECK(hit.t == 1);
    CHECK(hit.normal == Vec3{0, 0, -1});
    CHECK_FALSE(raycast(segment, Ray{{1, 1.0000001, 0}, {0, 0, 1}}, hit));
    REQUIRE(raycast(segment, Ray{{-1, -1, -1}, {1, 1, 1}}, hit));
    CHECK(hit.t == 1);
    REQUIRE(raycast(point, Ray{{0, 0, 0}, {.5, 1, 1.5}}, hit));
    CHECK(hit.t == 2);
    CHECK_FALSE(raycast(point, Ray{{0, 0, 0}, {.5, 1, 1.5}, 1.9999999}, hit));
}

TEST_CASE("raycast: triangles agree with exact arithmetic where everything touches", "[raycast]") {
    const NoTraps watch;
    Random random(12);
    Comparison anywhere, in_plane;
    for (int i = 0; i < 4 * cases; ++i) {
        Triangle triangle{grid_point(random, 2), grid_point(random, 2), grid_point(random, 2)};
        Ray ray{grid_point(random, 3), grid_direction(random, 3),
                random.index(2) == 0 ? 0.5 * random.index(5) : infinity};
        anywhere.add(triangle, ray);
        // The same pressed into a slanted plane.
        for (Vec3* p : {&triangle.a, &triangle.b, &triangle.c, &ray.origin, &ray.direction}) p->z = p->x - 2 * p->y;
        if (ray.direction != Vec3{}) in_plane.add(triangle, ray);
    }
    CHECK_COMPARISON(anywhere);
    CHECK_COMPARISON(in_plane);
}

TEST_CASE("raycast: triangles agree with exact arithmetic", "[raycast]") {
    const NoTraps watch;
    Random random(13);
    Comparison near, far, slivers;
    for (int i = 0; i < cases; ++i) {
        const auto aim = [&](const Triangle& triangle, double distance) {
            const Vec3 origin = on_lattice(place_on(triangle, random) + random.direction() * distance);
            const Vec3 target = on_lattice(place_on(triangle, random));
            const Vec3 direction = random.index(2) == 0 ? target - origin : on_lattice((target - origin) * 0.37);
            return Ray{origin, direction == Vec3{} ? Vec3{1, 0, 0} : direction, random.index(4) == 0 ? 1.0 : infinity};
        };
        const auto corner = [&](double size) { return on_lattice(random_point(random, size)); };
        const Triangle small{corner(1), corner(1), corner(1)};
        near.add(small, aim(small, std::pow(10, random.uniform(-3, 3))));
        // A centimetre to a metre across, seen at and from 10 km.
        const Vec3 there = corner(1e4);
        const double size = std::pow(10, random.uniform(-2, 0));
        const Triangle away{there + corner(size), there + corner(size), there + corner(size)};
        far.add(away, aim(away, random.uniform(1, 5e3)));
        const Vec3 p = corner(1), along = corner(1), across = corner(1e-5);
        const Triangle sliver{p, p + along, p + on_lattice(along * random.uniform(0, 1)) + across};
        slivers.add(sliver, aim(sliver, std::pow(10, random.uniform(-3, 3))));
    }
    CHECK_COMPARISON(near);
    CHECK_COMPARISON(far);
    CHECK_COMPARISON(slivers);
}

namespace {

struct ClosedMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::vector<int>> around;  // triangles at each vertex

    Triangle triangle(int i) const {
        return {vertices[triangles[i][0]], vertices[triangles[i][1]], vertices[triangles[i][2]]};
    }
};

/// An octahedron, each triangle cut into four `levels` times, pushed out to the ellipsoid, in floats.
ClosedMesh ellipsoid(Vec3 center, Vec3 radii, int levels) {
    ClosedMesh mesh;
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
            if (is_new) mesh.vertices.push_back(normalized(mesh.vertices[a] + mesh.vertices[b]));
            return place->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = finer;
    }
    for (Vec3& v : mesh.vertices) v = as_floats(center + Vec3{v.x * radii.x, v.y * radii.y, v.z * radii.z});
    mesh.around.resize(mesh.vertices.size());
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
        for (const int corner : mesh.triangles[i]) mesh.around[corner].push_back(i);
    }
    return mesh;
}

/// Rays from inside at points of edges (place < 1) or at vertices that meet no triangle at all.
int leaks(const ClosedMesh& mesh, Vec3 center, double spread, bool at_vertices, int rays, Random& random) {
    int leaked = 0;
    for (int i = 0; i < rays; ++i) {
        const auto& corners = mesh.triangles[random.index(static_cast<uint32_t>(mesh.triangles.size()))];
        const Vec3 a = mesh.vertices[corners[0]], b = mesh.vertices[corners[1]];
        const Vec3 origin = as_floats(center + random.direction() * spread);
        const Vec3 target = at_vertices ? a : a + (b - a) * random.uniform(0, 1);
        const Vec3 direction = as_floats(target - origin);
        if (direction == Vec3{}) continue;
        const ShearedRay ray(Ray{origin, direction});
        TriangleCrossing crossing;
        bool found = false;
        for (const int end : {corners[0], corners[1]}) {
            for (const int near : mesh.around[end]) found = found || crosses(mesh.triangle(near), ray, crossing);
        }
        // Rounding the direction may have moved the ray beyond these.
        for (int k = 0; k < static_cast<int>(mesh.triangles.size()) && !found; ++k) {
            found = crosses(mesh.triangle(k), ray, crossing);
        }
        leaked += !found;
    }
    return leaked;
}

}  // namespace

TEST_CASE("raycast: a closed mesh leaks no ray at its edges and vertices", "[raycast]") {
    Random random(14);
    const struct {
        const char* name;
        Vec3 center, radii;
        double spread;
    } meshes[] = {{"round", {0, 0, 0}, {1, 1, 1}, .5},
                  {"far from the origin", {3e5, -2e5, 3e5}, {100, 100, 100}, 50},
                  {"slivers", {0, 0, 0}, {1, 1, 3e-6}, 1e-6}};
    for (const auto& each : meshes) {
        INFO(each.name);
        const ClosedMesh mesh = ellipsoid(each.center, each.radii, 4);
        CHECK(leaks(mesh, each.center, each.spread, false, 170000, random) == 0);
        CHECK(leaks(mesh, each.center, each.spread, true, 170000, random) == 0);
    }
}

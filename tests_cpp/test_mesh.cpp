#include "mesh/mesh.h"

#include <cfenv>
#include <cstring>
#include <ctime>
#include <memory>
#include <set>

#include "mesh/closest_search.h"
#include "meshes.h"
#include "test.h"

using namespace gphys;

namespace {

constexpr int trapped_exceptions = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;

using MeshHolder = std::unique_ptr<const Mesh, void (*)(const Mesh*)>;
MeshHolder hold(const test::Arrays& arrays, Isa isa = chosen_isa()) {
    return {arrays.make(nullptr, isa), Mesh::release};
}

/// The meshes on which answers are compared with those of a loop over all triangles.
struct NamedArrays {
    const char* name;
    test::Arrays arrays;
    double size;
};
std::vector<NamedArrays> hard_meshes() {
    const test::Arrays sphere = test::sphere(4), torus = test::torus(40, 16);
    return {{"sphere", sphere, 1},
            {"torus", torus, 1},
            {"far torus", torus.placed({1e5, -2e5, 3e5}, {3, 3, 3}), 3},
            {"slivers", sphere.placed({}, {1, 1, 6e5}), 6e5},
            {"pancake", sphere.placed({5, 5, 5}, {1, 1, 1e-6}), 1},
            {"grid", test::grid(24), 24},
            {"soup", test::soup(800, 3), 1},
            {"tiny", torus.placed({}, {1e-20, 1e-20, 1e-20}), 1e-20},
            {"huge", torus.placed({}, {7e14, 7e14, 7e14}), 7e14},
            {"one", test::soup(1, 5), 1},
            {"empty", {}, 1}};
}

Vec3 centre_of(const NamedArrays& named) {
    Vec3 sum;
    for (const gphys_vec3& v : named.arrays.vertices) sum += widen(v);
    return named.arrays.vertices.empty() ? Vec3{} : sum / static_cast<double>(named.arrays.vertices.size());
}

/// From anywhere near, at a vertex, at an edge, at a face, or anywhere.
Ray random_ray(test::Random& random, const Mesh& mesh, Vec3 centre, double size) {
    const auto near = [&] { return centre + random.direction() * random.uniform(0, 3 * size); };
    Ray ray{near(), random.direction() * size, infinity};
    if (mesh.triangle_count() > 0 && random.index(8) != 0) {
        const Triangle triangle = mesh.triangle(random.index(mesh.triangle_count()));
        const double u = random.index(2) ? random.uniform(0, 1) : random.index(2);
        const double v = random.index(2) ? random.uniform(0, 1 - u) : 0;
        const Vec3 target = triangle.a + (triangle.b - triangle.a) * u + (triangle.c - triangle.a) * v;
        ray.direction = widen(narrow(target - ray.origin));
        if (random.index(4) == 0) {
            const int axis = static_cast<int>(random.index(3));
            ray.origin = target;
            ray.origin[axis] += 2 * size;
            ray.direction = {};
            ray.direction[axis] = -size;
        }
        if (random.index(8) == 0) ray.origin = target;
        if (random.index(16) == 0) ray.direction = {};
    }
    if (random.index(3) == 0) ray.t_max = random.uniform(0, 2);
    return ray;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool same_bits(Vec3 a, Vec3 b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z); }
bool same_bits(const Hit& a, const Hit& b) {
    return same_bits(a.t, b.t) && same_bits(a.point, b.point) && same_bits(a.normal, b.normal) &&
           a.triangle == b.triangle && same_bits(a.u, b.u) && same_bits(a.v, b.v) && a.flags == b.flags;
}

/// Every hit by asking each triangle, in their order.
std::vector<Hit> hits_one_by_one(const Mesh& mesh, const Ray& ray) {
    std::vector<Hit> hits;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        Hit hit;
        if (!raycast(mesh.triangle(i), ray, hit)) continue;
        hit.triangle = i;
        hits.push_back(hit);
    }
    return hits;
}

Hit first_of(const std::vector<Hit>& hits) {
    Hit first;
    for (const Hit& hit : hits) {
        if (first.triangle == GPHYS_NO_TRIANGLE || reported(hit.t) < reported(first.t)) first = hit;
    }
    return first;
}

Shape random_shape(test::Random& random, Vec3 centre, double size) {
    const auto near = [&] { return centre + random.direction() * random.uniform(0, 1.5 * size); };
    const Vec3 a = near(), b = near(), c = near();
    const double r = random.uniform(0, 0.3 * size);
    switch (random.index(7)) {
        case 0:
            return Sphere{a, r};
        case 1:
            return Capsule{a, b, r};
        case 2:
            return Aabb{min(a, b), max(a, b)};
        case 3:
            return Obb{a, abs(b - a) * 0.3, rotation_matrix(widen(random.rotation()))};
        case 4:
            return Plane{random.direction(), dot(random.direction(), a)};
        case 5:
            return Triangle{a, b, c};
        default:
            break;
    }
    Frustum frustum{a, {}};
    for (Plane& plane : frustum.planes) plane = {random.direction(), random.uniform(-size, 0)};
    return frustum;
}

}  // namespace

TEST_CASE("a mesh ray gives, bit for bit, the nearest of all triangles") {
    test::Random random(1);
    for (const NamedArrays& named : hard_meshes()) {
        INFO(named.name);
        const MeshHolder mesh = hold(named.arrays);
        REQUIRE(mesh->bvh().defect() == nullptr);
        const Vec3 centre = centre_of(named);
        uint32_t hit_count = 0;
        for (int i = 0; i < test::tries(1500); ++i) {
            const Ray ray = random_ray(random, *mesh, centre, named.size);
            Hit hit;
            std::vector<Hit> all;
            std::feclearexcept(FE_ALL_EXCEPT);
            const bool found = mesh->raycast(ray, hit);
            mesh->raycast_all(ray, [&](const Hit& each) { all.push_back(each); });
            REQUIRE(mesh->raycast_any(ray) == found);
            REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
            hit_count += found;

            const std::vector<Hit> expected = hits_one_by_one(*mesh, ray);
            REQUIRE(found == !expected.empty());
            if (found) REQUIRE(same_bits(hit, first_of(expected)));
            std::sort(all.begin(), all.end(), [](const Hit& a, const Hit& b) { return a.triangle < b.triangle; });
            REQUIRE(all.size() == expected.size());
            for (size_t k = 0; k < all.size(); ++k) REQUIRE(same_bits(all[k], expected[k]));
        }
        REQUIRE((mesh->triangle_count() < 2 || hit_count > static_cast<uint32_t>(test::tries(500))));
    }
}

TEST_CASE("rays in groups of any size and direction get what each would get alone, on every processor") {
    test::Random random(9);
    for (const NamedArrays& named : hard_meshes()) {
        const MeshHolder expected = hold(named.arrays);
        const Vec3 centre = centre_of(named);
        for (const Isa isa : test::isas()) {
            INFO(named.name << ", " << name_of(isa));
            const MeshHolder mesh = hold(named.arrays, isa);
            for (int i = 0; i < test::tries(300); ++i) {
                // Unrelated rays; into one octant; from one eye past a few neighbouring points.
                const int kind = i % 3;
                const uint32_t count = 1 + random.index(Mesh::rays_at_once);
                Ray rays[Mesh::rays_at_once];
                for (Ray& ray : rays) {
                    ray = random_ray(random, *mesh, centre, named.size);
                    if (kind == 1) ray.direction = abs(ray.direction);
                    if (kind == 2 && &ray != rays) {
                        const Vec3 aside = random.direction() * (0.05 * max_component(abs(rays[0].direction)));
                        ray = {rays[0].origin, widen(narrow(rays[0].direction + aside)), rays[0].t_max};
                    }
                }
                gphys_ray given[Mesh::rays_at_once];
                const gphys_ray* each[Mesh::rays_at_once];
                for (uint32_t k = 0; k < count; ++k) {
                    each[k] = given + k;
                    given[k] = {narrow(rays[k].origin), narrow(rays[k].direction), static_cast<float>(rays[k].t_max)};
                    rays[k] = widen(given[k]);
                }
                gphys_hit hits[Mesh::rays_at_once], *out[Mesh::rays_at_once];
                for (uint32_t k = 0; k < count; ++k) out[k] = hits + k;
                std::feclearexcept(FE_ALL_EXCEPT);
                const uint64_t found = mesh->raycast_many(each, count, out);
                REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
                for (uint32_t k = 0; k < count; ++k) {
                    Hit hit, alone;
                    const bool hits_alone = expected->raycast(rays[k], hit);
                    REQUIRE((found >> k & 1) == uint32_t{hits_alone});
                    REQUIRE(mesh->raycast(rays[k], alone) == hits_alone);
                    if (!hits_alone) continue;
                    const gphys_hit rounded = to_hit(hit);
                    REQUIRE((std::memcmp(&hits[k], &rounded, sizeof rounded) == 0 && same_bits(alone, hit)));
                }
                if (count < 64) REQUIRE(found >> count == 0);
            }
        }
    }
}

TEST_CASE("normals of needles, of which rounding would leave little, are the same in a batch") {
    test::Random random(33);
    // Corners whose differences have more digits than a product of doubles holds.
    test::Arrays needles;
    for (uint32_t i = 0; i < 3000; ++i) {
        const Vec3 a = random.direction() * 1000, along = random.direction() * 1000;
        const Vec3 aside = random.direction() * std::exp2(random.uniform(-13, -8));
        for (const Vec3& corner : {a, a + along, a + along * 0.4375 + aside}) {
            needles.vertices.push_back(narrow(corner));
        }
        needles.add(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const MeshHolder expected = hold(needles);
    for (const Isa isa : test::isas()) {
        const MeshHolder mesh = hold(needles, isa);
        uint32_t met = 0;
        for (uint32_t first = 0; first < 3000; first += 60) {
            gphys_ray rays[60];
            const gphys_ray* each[60];
            gphys_hit hits[60], *out[60];
            for (uint32_t k = 0; k < 60; ++k) {
                const Triangle needle = mesh->triangle(first + k);
                const Vec3 target = needle.a + (needle.b - needle.a) * 0.3 + (needle.c - needle.a) * 0.3;
                const Vec3 away = random.direction();
                rays[k] = {narrow(target + away), narrow(-away), INFINITY};
                each[k] = rays + k;
                out[k] = hits + k;
            }
            const uint64_t found = mesh->raycast_many(each, 60, out);
            for (uint32_t k = 0; k < 60; ++k) {
                Hit hit;
                REQUIRE((found >> k & 1) == uint32_t{expected->raycast(widen(rays[k]), hit)});
                if ((found >> k & 1) == 0) continue;
                const gphys_hit rounded = to_hit(hit);
                REQUIRE(std::memcmp(&hits[k], &rounded, sizeof rounded) == 0);
                ++met;
            }
        }
        CHECK(met > 500);
    }
}

TEST_CASE("no ray leaves a closed mesh through its edges and vertices") {
    test::Random random(2);
    for (const NamedArrays& named : hard_meshes()) {
        const MeshHolder mesh = hold(named.arrays);
        if (mesh->triangle_count() == 0 || mesh->report().open_edge_count > 0) continue;
        INFO(named.name);
        // A torus is hollow at its centre: start within the tube.
        const bool is_torus = mesh->triangle_count() == 1280;
        const Vec3 origin = widen(narrow(centre_of(named) + (is_torus ? Vec3{named.size, 0, 0} : Vec3{})));
        for (int i = 0; i < test::tries(20000); ++i) {
            const Triangle triangle = mesh->triangle(random.index(mesh->triangle_count()));
            const double u = random.index(2) ? random.uniform(0, 1) : 0;
            const Vec3 target = triangle.a + (triangle.b - triangle.a) * u;
            const Vec3 direction = widen(narrow(target - origin));
            if (direction == Vec3{}) continue;
            Hit hit;
            REQUIRE(mesh->raycast({origin, direction, infinity}, hit));
        }
    }
}

TEST_CASE("the nearest triangle of a mesh is hit, not the first in the array") {
    test::Arrays arrays;
    arrays.vertices = {{-1, -1, 10}, {1, -1, 10}, {0, 1, 10}, {-1, -1, 5}, {1, -1, 5}, {0, 1, 5}};
    arrays.add(0, 1, 2);
    arrays.add(3, 4, 5);
    const MeshHolder mesh = hold(arrays);
    Hit hit;
    REQUIRE(mesh->raycast({{0, 0, 0}, {0, 0, 1}, infinity}, hit));
    REQUIRE(hit.triangle == 1);
    REQUIRE(hit.t == 5);
    REQUIRE(hit.point == Vec3{0, 0, 5});
}

TEST_CASE("triangles that lie in the bounds of a mesh's tree are found") {
    const MeshHolder mesh = hold(test::grid(16));
    for (uint32_t y = 0; y <= 16; ++y) {
        for (uint32_t x = 0; x <= 16; ++x) {
            Hit hit;
            REQUIRE(mesh->raycast({{double(x), double(y), 3}, {0, 0, -1}, infinity}, hit));
            REQUIRE(hit.t == 3);
            // Within the plane itself: each corner is on the way along its row.
            REQUIRE(mesh->raycast({{-1, double(y), 0}, {1, 0, 0}, infinity}, hit));
            REQUIRE(hit.t == 1);
        }
    }
}

TEST_CASE("the ball of a mesh holds all vertices, and hardly more than it must") {
    test::Random random(612);
    for (int i = 0; i < 200; ++i) {
        const Vec3 offset = widen(random.point(i % 2 == 0 ? 1 : 1e6f)), scale = abs(widen(random.point(3)));
        const test::Arrays arrays = test::sphere(1).placed(offset, scale);
        const MeshHolder mesh = hold(arrays);
        const Vec3 center = widen(mesh->ball().center);
        double furthest = 0;
        for (const gphys_vec3& vertex : arrays.vertices) furthest = std::max(furthest, distance(widen(vertex), center));
        REQUIRE(furthest <= mesh->ball().radius);
        REQUIRE(mesh->ball().radius <= furthest + 0x1p-22 * max_component(abs(center)) + 0x1p-20 * furthest);
    }
}

TEST_CASE("a closed mesh is hit from inside") {
    const MeshHolder mesh = hold(test::sphere(3));
    test::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction = random.direction();
        Hit hit;
        REQUIRE(mesh->raycast({{0.1, 0.2, -0.1}, direction, infinity}, hit));
        REQUIRE((hit.flags & GPHYS_HIT_BACK) != 0);
        REQUIRE(dot(hit.normal, direction) <= 0);
    }
}

TEST_CASE("an empty mesh answers with nothing") {
    const MeshHolder mesh = hold({});
    Hit hit;
    Vec3 out;
    uint32_t triangle;
    REQUIRE(mesh->triangle_count() == 0);
    REQUIRE(mesh->bounds().min[0] > mesh->bounds().max[0]);
    REQUIRE_FALSE(mesh->raycast({{0, 0, 0}, {1, 0, 0}, infinity}, hit));
    REQUIRE_FALSE(mesh->raycast_any({{0, 0, 0}, {1, 0, 0}, infinity}));
    REQUIRE_FALSE(mesh->closest_point({0, 0, 0}, infinity, out, triangle));
    REQUIRE_FALSE(mesh->sweep({{0, 0, 0}, 1}, {1, 0, 0}, hit));
    REQUIRE_FALSE(mesh->overlaps(Sphere{{0, 0, 0}, 1}));
    REQUIRE_FALSE(mesh->overlaps(*mesh));
}

TEST_CASE("a ray through a shared edge hits both triangles of the mesh, and the lower index wins") {
    test::Arrays arrays;
    arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    arrays.add(0, 2, 3);
    arrays.add(0, 1, 2);
    const MeshHolder mesh = hold(arrays);
    const Ray ray{{0.5, 0.5, 1}, {0, 0, -1}, infinity};
    int count = 0;
    mesh->raycast_all(ray, [&](const Hit& hit) {
        ++count;
        REQUIRE(hit.t == 1);
    });
    REQUIRE(count == 2);
    Hit hit;
    REQUIRE(mesh->raycast(ray, hit));
    REQUIRE(hit.triangle == 0);
}

TEST_CASE("the closest point of a mesh is, bit for bit, that of all triangles") {
    test::Random random(4);
    for (const NamedArrays& named : hard_meshes()) {
        INFO(named.name);
        const MeshHolder mesh = hold(named.arrays);
        const Vec3 centre = centre_of(named);
        for (int i = 0; i < test::tries(400); ++i) {
            Vec3 point = centre + random.direction() * random.uniform(0, 3 * named.size);
            if (mesh->triangle_count() > 0 && i % 4 == 0) {
                point = mesh->triangle(random.index(mesh->triangle_count())).a;
            }
            const double limit = i % 3 == 0 ? random.uniform(0, named.size) : infinity;
            Vec3 out, expected_point;
            uint32_t triangle = 0, expected = GPHYS_NO_TRIANGLE;
            std::feclearexcept(FE_ALL_EXCEPT);
            const bool found = mesh->closest_point(point, limit, out, triangle);
            REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
            float least = std::numeric_limits<float>::infinity();
            for (uint32_t k = 0; k < mesh->triangle_count(); ++k) {
                const Vec3 candidate = closest_point(mesh->triangle(k), point);
                const double squared = length_squared(candidate - point);
                if (reported(std::sqrt(squared)) < least && squared <= limit * limit) {
                    least = reported(std::sqrt(squared));
                    expected = k;
                    expected_point = candidate;
                }
            }
            REQUIRE(found == (expected != GPHYS_NO_TRIANGLE));
            if (found) {
                REQUIRE(triangle == expected);
                REQUIRE(same_bits(out, expected_point));
            }
        }
    }
}

TEST_CASE("the closest points of many are, bit for bit, those of each") {
    test::Random random(6);
    for (const NamedArrays& named : hard_meshes()) {
        INFO(named.name);
        const MeshHolder mesh = hold(named.arrays);
        for (uint32_t count = 1; count <= Mesh::points_at_once; count += 9) {
            std::vector<Vec3> points(count), closest(count), expected(count);
            std::vector<uint32_t> triangles(count, GPHYS_NO_TRIANGLE), expected_triangles(count, GPHYS_NO_TRIANGLE);
            for (Vec3& point : points) {
                point = centre_of(named) + random.direction() * random.uniform(0, 3 * named.size);
            }
            std::feclearexcept(FE_ALL_EXCEPT);
            mesh->closest_point_many(points.data(), count, [&](uint32_t i, Vec3 point, uint32_t triangle) {
                closest[i] = point;
                triangles[i] = triangle;
            });
            REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
            for (uint32_t i = 0; i < count; ++i) {
                mesh->closest_point(points[i], infinity, expected[i], expected_triangles[i]);
                REQUIRE(same_bits(closest[i], expected[i]));
            }
            REQUIRE(triangles == expected_triangles);
        }
    }
}

TEST_CASE("a sphere swept against a mesh meets, bit for bit, the first of all triangles") {
    test::Random random(5);
    for (const NamedArrays& named : hard_meshes()) {
        INFO(named.name);
        const MeshHolder mesh = hold(named.arrays);
        const Vec3 centre = centre_of(named);
        for (int i = 0; i < 150; ++i) {
            const Ray path = random_ray(random, *mesh, centre, named.size);
            const Sphere moving{path.origin, random.index(4) == 0 ? 0 : random.uniform(0, 0.2 * named.size)};
            const Vec3 displacement = path.direction * (random.index(2) ? 1.0 : 0.3);
            Hit hit, expected;
            std::feclearexcept(FE_ALL_EXCEPT);
            const bool found = mesh->sweep(moving, displacement, hit);
            REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
            for (uint32_t k = 0; k < mesh->triangle_count(); ++k) {
                Hit each;
                if (!sweep(mesh->triangle(k), moving, displacement, each)) continue;
                each.triangle = k;
                if (expected.t == infinity || reported(each.t) < reported(expected.t)) expected = each;
            }
            REQUIRE(found == (expected.triangle != GPHYS_NO_TRIANGLE));
            if (found) REQUIRE(same_bits(hit, expected));
        }
    }
}

TEST_CASE("a solid that falls on fine ground, or begins in it, meets the first of all triangles, bit for bit") {
    test::Random random(6);
    test::Arrays ground = test::grid(40);  // of squares of 1 m
    for (gphys_vec3& v : ground.vertices) v.z = random.index(3) == 0 ? 0 : random.uniform_float(0, 0.2f);
    const MeshHolder mesh = hold(ground);
    constexpr double size = 40;
    int at_start = 0, later = 0;
    for (int i = 0; i < test::tries(400); ++i) {
        // Many triangles below, of which several may be met at the same time.
        const double reach = size * random.uniform(0.02, 0.1), height = reach * (i % 4 == 0 ? 0.9 : 3);
        const Vec3 at{random.uniform(0, size), random.uniform(0, size), height};
        const Vec3 way = Vec3{random.uniform(-1, 1), random.uniform(-1, 1), i % 3 == 0 ? 0.0 : -4.0} * reach;
        const Mat3 axes = rotation_matrix(widen(random.rotation()));
        for (const Shape& moving :
             {Shape(Sphere{at, reach}), Shape(Capsule{at, at + random.direction() * reach, reach}),
              Shape(Capsule{at, at + Vec3{0, 0, reach}, reach}), Shape(Aabb{at - Vec3{reach, reach, reach}, at}),
              Shape(Obb{at, {reach, reach / 2, reach / 4}, axes})}) {
            Hit hit, expected;
            const bool found = mesh->sweep(moving, way, hit);
            for (uint32_t k = 0; k < mesh->triangle_count(); ++k) {
                Hit each;
                if (!sweep(mesh->triangle(k), moving, way, each)) continue;
                each.triangle = k;
                if (expected.t == infinity || reported(each.t) < reported(expected.t)) expected = each;
            }
            REQUIRE(found == (expected.triangle != GPHYS_NO_TRIANGLE));
            if (!found) continue;
            REQUIRE(same_bits(hit, expected));
            ++(hit.t == 0 ? at_start : later);
        }
    }
    CHECK(at_start > test::tries(200));
    CHECK(later > test::tries(200));
}

TEST_CASE("rays from where all of a mesh is divide nothing by zero") {
    test::Arrays point;
    point.vertices = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    point.indices = {0, 1, 2};
    const MeshHolder mesh = hold(point);
    gphys_ray given[Mesh::rays_at_once];
    const gphys_ray* each[Mesh::rays_at_once];
    gphys_hit hits[Mesh::rays_at_once], *out[Mesh::rays_at_once];
    for (uint32_t k = 0; k < Mesh::rays_at_once; ++k) {
        given[k] = {{1, 2, 3}, {1, static_cast<float>(k), 0}, INFINITY};
        each[k] = given + k;
        out[k] = hits + k;
    }
    std::feclearexcept(FE_ALL_EXCEPT);
    const uint64_t found = mesh->raycast_many(each, Mesh::rays_at_once, out);
    REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
    for (uint32_t k = 0; k < Mesh::rays_at_once; ++k) {
        REQUIRE((found >> k & 1) == 1);
        REQUIRE(hits[k].t == 0);
    }
}

TEST_CASE("a mesh of denormal size answers as a large one does, in at most three times its time") {
    // Coordinates of 23 - 12 bits, so that they are exact at either size.
    test::Arrays large = test::sphere(5);
    for (gphys_vec3& v : large.vertices) {
        for (float* c : {&v.x, &v.y, &v.z}) *c = std::round(*c * 0x1p11f) * 0x1p-11f;
    }
    static constexpr double by = 0x1p-135;
    const MeshHolder ordinary = hold(large), denormal = hold(large.placed({}, {by, by, by}));
    REQUIRE(denormal->bounds().max[0] < std::numeric_limits<float>::min());
    const auto larger = [](Vec3 v) { return v / by; };

    test::Random random(12);
    std::vector<Ray> rays;
    std::vector<Vec3> points;
    for (int i = 0; i < 2000; ++i) {
        const auto exact = [&](Vec3 v) {
            return Vec3{std::round(v.x * 512), std::round(v.y * 512), std::round(v.z * 512)} / 512;
        };
        const Vec3 from = exact(random.direction() * random.uniform(0, 3)), to = exact(random.direction());
        if (from == to) continue;
        rays.push_back({from, to - from, random.index(2) ? infinity : random.uniform(0, 2)});
        points.push_back(from);
    }
    for (size_t i = 0; i < rays.size(); ++i) {
        const Ray small{rays[i].origin * by, rays[i].direction * by, rays[i].t_max};
        Hit hit, expected;
        REQUIRE(denormal->raycast(small, hit) == ordinary->raycast(rays[i], expected));
        REQUIRE((hit.t == expected.t && larger(hit.point) == expected.point && hit.normal == expected.normal));
        REQUIRE((hit.triangle == expected.triangle && hit.u == expected.u && hit.v == expected.v));
        REQUIRE(denormal->raycast_any(small) == ordinary->raycast_any(rays[i]));
        int count = 0, expected_count = 0;
        denormal->raycast_all(small, [&](const Hit&) { ++count; });
        ordinary->raycast_all(rays[i], [&](const Hit&) { ++expected_count; });
        REQUIRE(count == expected_count);
        const Sphere moving{points[i], .125};
        REQUIRE(denormal->sweep({moving.center * by, moving.radius * by}, small.direction, hit, Ties::as_computed) ==
                ordinary->sweep(moving, rays[i].direction, expected, Ties::as_computed));
        REQUIRE((hit.t == expected.t && larger(hit.point) == expected.point && hit.triangle == expected.triangle));
        Vec3 near, expected_near;
        uint32_t triangle, expected_triangle;
        const auto squared = [](Vec3, double square) { return square; };
        const auto limit = [](double square) { return std::sqrt(square) * (1 + 0x1p-50); };
        REQUIRE(denormal->closest_point(points[i] * by, infinity, squared, limit, near, triangle));
        REQUIRE(ordinary->closest_point(points[i], infinity, squared, limit, expected_near, expected_triangle));
        REQUIRE((larger(near) == expected_near && triangle == expected_triangle));
    }

    // Without magnification a ray asks all triangles: a hundred times as long.
    const auto seconds = [&](const Mesh& mesh, double scale) {
        double least = infinity;
        for (int round = 0; round < 5; ++round) {
            const std::clock_t begin = std::clock();
            for (const Ray& ray : rays) {
                Hit hit;
                mesh.raycast({ray.origin * scale, ray.direction * scale, ray.t_max}, hit);
            }
            least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        return least;
    };
    const double of_ordinary = seconds(*ordinary, 1), of_denormal = seconds(*denormal, by);
    INFO(of_denormal << " s against " << of_ordinary << " s");
    CHECK(of_denormal <= 3 * of_ordinary);
}

TEST_CASE("a shape overlaps exactly the triangles of a mesh that it overlaps one by one") {
    test::Random random(6);
    for (const NamedArrays& named : hard_meshes()) {
        INFO(named.name);
        const MeshHolder mesh = hold(named.arrays);
        const Vec3 centre = centre_of(named);
        for (int i = 0; i < 60; ++i) {
            const Shape shape = random_shape(random, centre, named.size);
            INFO("shape " << shape.index());
            std::set<uint32_t> found, expected;
            std::feclearexcept(FE_ALL_EXCEPT);
            mesh->for_each_overlap(shape, [&](uint32_t triangle) { return found.insert(triangle).second; });
            REQUIRE(mesh->overlaps(shape) == !found.empty());
            REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
            for (uint32_t k = 0; k < mesh->triangle_count(); ++k) {
                if (overlaps(shape, mesh->triangle(k))) expected.insert(k);
            }
            REQUIRE((found == expected));
        }
    }
}

TEST_CASE("two meshes overlap if any of their triangles do") {
    test::Random random(7);
    int overlapping = 0;
    for (int i = 0; i < 120; ++i) {
        const Vec3 offset = random.direction() * random.uniform(0, 3);
        const MeshHolder a = hold(test::sphere(2));
        const MeshHolder b =
            hold(i % 2 ? test::torus(12, 6).placed(offset, {1, 1, 1}) : test::soup(60, i).placed(offset, {1, 1, 1}));
        bool expected = false;
        for (uint32_t k = 0; k < a->triangle_count() && !expected; ++k) {
            for (uint32_t l = 0; l < b->triangle_count() && !expected; ++l) {
                expected = overlaps(a->triangle(k), b->triangle(l));
            }
        }
        overlapping += expected;
        REQUIRE(a->overlaps(*b) == expected);
        REQUIRE(b->overlaps(*a) == expected);
    }
    REQUIRE((overlapping > 20 && overlapping < 100));
}

TEST_CASE("a sphere deep inside a closed mesh does not overlap its surface") {
    const MeshHolder mesh = hold(test::sphere(3));
    REQUIRE_FALSE(mesh->overlaps(Sphere{{0, 0, 0}, 0.5}));
    REQUIRE(mesh->overlaps(Sphere{{0, 0, 0}, 1}));
}

TEST_CASE("a mesh's triangles are found by the radius of a sphere and the shift of a plane") {
    // The book's model queries ignored the one and the other.
    const MeshHolder mesh = hold(test::grid(4));
    REQUIRE(mesh->overlaps(Sphere{{2, 2, 3}, 3}));
    REQUIRE_FALSE(mesh->overlaps(Sphere{{2, 2, 3}, 2.999}));
    REQUIRE(mesh->overlaps(Plane{{1, 0, 0}, 4}));
    REQUIRE_FALSE(mesh->overlaps(Plane{{1, 0, 0}, 4.001}));
}

TEST_CASE("shapes beyond the range of float find the triangles of a mesh") {
    // The world as seen from inside a model of almost no size.
    const MeshHolder mesh = hold(test::sphere(2));
    std::feclearexcept(FE_ALL_EXCEPT);
    for (double far : {1e20, 1e38, 1e45, 1e60}) {
        REQUIRE(mesh->overlaps(Sphere{{far, 0, 0}, 2 * far}));
        REQUIRE(mesh->overlaps(Aabb{{-far, -far, -far}, {far, far, far}}));
        REQUIRE(mesh->overlaps(Obb{{far, 0, 0}, {2 * far, far, far}, {}}));
        REQUIRE(mesh->overlaps(Capsule{{-far, 0, 0}, {far, 0, 0}, 1}));
        REQUIRE_FALSE(mesh->overlaps(Sphere{{far, 0, 0}, far / 2}));
        REQUIRE_FALSE(mesh->overlaps(Aabb{{far, far, far}, {2 * far, far, far}}));
    }
    REQUIRE(std::fetestexcept(trapped_exceptions) == 0);
}

TEST_CASE("a mesh lives until the last hold is given up, and returns all its memory") {
    struct Balance {
        long bytes = 0, allocations = 0, fail_at = -1;
    } balance;
    const gphys_allocator hooks{[](void* user, size_t size, size_t alignment) -> void* {
                                    Balance& b = *static_cast<Balance*>(user);
                                    if (b.fail_at >= 0 && b.allocations >= b.fail_at) return nullptr;
                                    ++b.allocations;
                                    b.bytes += static_cast<long>(size);
                                    return ::operator new(size, std::align_val_t(alignment));
                                },
                                [](void* user, void* memory, size_t size, size_t alignment) {
                                    static_cast<Balance*>(user)->bytes -= static_cast<long>(size);
                                    ::operator delete(memory, std::align_val_t(alignment));
                                },
                                &balance};
    const test::Arrays arrays = test::sphere(3);
    const Mesh* mesh = arrays.make(&hooks);
    const long needed = balance.allocations;
    mesh->retain();
    Mesh::release(mesh);
    REQUIRE(balance.bytes > 0);

    test::Random random(8);
    for (int i = 0; i < 100; ++i) {
        Hit hit;
        Vec3 out;
        uint32_t triangle;
        const Ray ray = random_ray(random, *mesh, {}, 1);
        mesh->raycast(ray, hit);
        mesh->sweep({ray.origin, 0.1}, ray.direction, hit);
        mesh->closest_point(ray.origin, infinity, out, triangle);
        mesh->overlaps(random_shape(random, {}, 1));
    }
    REQUIRE(balance.allocations == needed);
    Mesh::release(mesh);
    REQUIRE(balance.bytes == 0);

    for (long fail_at = 0; fail_at < needed; ++fail_at) {
        balance = {0, 0, fail_at};
        REQUIRE_THROWS_AS(arrays.make(&hooks), std::bad_alloc);
        REQUIRE(balance.bytes == 0);
    }
}

TEST_CASE("a mesh report counts what is wrong, and names the first") {
    test::Arrays arrays = test::sphere(1);
    const auto report = [&] { return examine(arrays.view(), std::pmr::get_default_resource()); };
    REQUIRE(report().triangle_count == 32);
    REQUIRE(report().degenerate_count == 0);
    REQUIRE(report().first_degenerate == GPHYS_NO_TRIANGLE);
    REQUIRE(report().first_out_of_range == GPHYS_NO_TRIANGLE);
    REQUIRE(report().first_bad_vertex == 0xffffffffu);
    REQUIRE(report().open_edge_count == 0);

    arrays.indices.resize(arrays.indices.size() - 3);
    REQUIRE(report().open_edge_count == 3);

    // Three on a line whose differences are no floats; no rounded cross product says 0 here.
    const uint32_t first = static_cast<uint32_t>(arrays.vertices.size());
    arrays.vertices.insert(arrays.vertices.end(), {{1e8f, 1, 3}, {1, 1, 3}, {-1e8f, 1, 3}});
    arrays.add(first, first + 1, first + 2);
    REQUIRE(report().degenerate_count == 1);
    REQUIRE(report().first_degenerate == 31);
    REQUIRE(report().open_edge_count == 6);
    arrays.add(5, 5, 2);
    REQUIRE(report().degenerate_count == 2);
    REQUIRE(report().open_edge_count == 6);

    arrays.add(0, 1, first + 3);
    arrays.add(0, 0xffffffffu, 1);
    REQUIRE(report().out_of_range_count == 2);
    REQUIRE(report().first_out_of_range == 33);
    REQUIRE(report().open_edge_count == 6);
    arrays.vertices[4].y = std::numeric_limits<float>::quiet_NaN();
    arrays.vertices[2].x = 2e15f;
    REQUIRE(report().bad_vertex_count == 2);
    REQUIRE(report().first_bad_vertex == 2);
}

TEST_CASE("an edge that joins three triangles is counted as open in a mesh report") {
    test::Arrays arrays;
    arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    arrays.add(0, 1, 2);
    arrays.add(1, 0, 3);
    REQUIRE(examine(arrays.view(), std::pmr::get_default_resource()).open_edge_count == 4);
    arrays.add(0, 1, 4);
    REQUIRE(examine(arrays.view(), std::pmr::get_default_resource()).open_edge_count == 7);
}

TEST_CASE("degenerate triangles of a mesh are met like the segments and points that they are") {
    test::Arrays arrays;
    arrays.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {5, 5, 5}};
    arrays.add(0, 1, 2);
    arrays.add(3, 3, 3);
    const MeshHolder mesh = hold(arrays);
    REQUIRE(mesh->report().degenerate_count == 2);
    Hit hit;
    REQUIRE(mesh->raycast({{1.5, 0, 1}, {0, 0, -1}, infinity}, hit));
    REQUIRE((hit.triangle == 0 && hit.t == 1));
    REQUIRE(mesh->raycast({{5, 5, 0}, {0, 0, 1}, infinity}, hit));
    REQUIRE((hit.triangle == 1 && hit.t == 5));
    Vec3 out;
    uint32_t triangle;
    REQUIRE(mesh->closest_point({1.5, 3, 0}, infinity, out, triangle));
    REQUIRE((out == Vec3{1.5, 0, 0} && triangle == 0));
    REQUIRE(mesh->overlaps(Sphere{{5, 5, 6}, 1}));
}

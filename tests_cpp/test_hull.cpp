// Hulls. A box as a hull answers as the box does; hulls of random points are held against all of their faces, and
// against what moves decides otherwise (overlaps before and after a contact).
#include "mesh/convex_hull.h"

#include <set>

#include "convex_hull.h"
#include "foundation/exact.h"
#include "geometry/convex_pairs.h"
#include "meshes.h"
#include "scene/scene.h"
#include "solid_cases.h"

using namespace gphys;
using namespace test;

namespace {

constexpr int cases = test::tries(100000);

MeshArrays points_of(const std::vector<gphys_vec3>& points) {
    return {points.empty() ? nullptr : &points[0].x, sizeof(gphys_vec3), static_cast<uint32_t>(points.size()), nullptr,
            0};
}

/// A hull that releases itself; null if there is none.
class HullMesh {
public:
    explicit HullMesh(const std::vector<gphys_vec3>& points) {
        Memory memory(nullptr);
        HullSurface surface(&memory);
        defect = make_hull(points_of(points), surface);
        if (defect != HullDefect::none) return;
        MeshArrays arrays = points_of({surface.vertices.begin(), surface.vertices.end()});
        arrays.vertices = &surface.vertices[0].x;
        arrays.indices = surface.indices.data();
        arrays.index_count = static_cast<uint32_t>(surface.indices.size());
        arrays.kind = MeshKind::hull;
        report = examine(arrays, &memory);
        mesh_ = create<Mesh>(nullptr, arrays, report);
    }
    ~HullMesh() {
        if (mesh_) Mesh::release(mesh_);
    }
    HullMesh(const HullMesh&) = delete;

    const Mesh* operator->() const { return mesh_; }
    const Mesh& operator*() const { return *mesh_; }

    HullDefect defect;
    gphys_mesh_report report{};

private:
    Mesh* mesh_ = nullptr;
};

std::vector<gphys_vec3> corners_of(const Aabb& box) {
    std::vector<gphys_vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back(
            narrow(Vec3{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z}));
    }
    return corners;
}

/// Some on a grid, so that many lie in a plane, on a line or in one place; some flat, some far away.
std::vector<gphys_vec3> random_points(Random& random, uint32_t most, bool far = true) {
    std::vector<gphys_vec3> points;
    const uint32_t count = 4 + random.index(most - 3), kind = random.index(4);
    const Vec3 offset = far && random.index(4) == 0 ? random_point(random, 1e6) : Vec3{};
    const double thin = random.index(4) == 0 ? 1e-4 : 1;
    for (uint32_t i = 0; i < count; ++i) {
        Vec3 point = kind == 0 ? grid_point(random, 2) : random_point(random, 2);
        if (kind == 1) point = random.direction() * 2;
        point.y *= thin;
        points.push_back(narrow(point + offset));
    }
    return points;
}

HullMesh random_hull(Random& random, uint32_t most) {
    for (;;) {
        std::vector<gphys_vec3> points = random_points(random, most, false);
        if (HullMesh(points).defect == HullDefect::none) return HullMesh(points);
    }
}

/// Slow twins: corners, edges and faces.
test::Hull twin_of(const Mesh& mesh) {
    test::Hull hull;
    for (const gphys_vec3& vertex : mesh.vertices()) hull.corners.push_back(widen(vertex));
    const auto& indices = mesh.indices();
    for (size_t i = 0; i < indices.size(); i += 3) {
        const int a = static_cast<int>(indices[i]), b = static_cast<int>(indices[i + 1]),
                  c = static_cast<int>(indices[i + 2]);
        hull.faces.push_back({a, b, c});
        hull.edges.push_back({a, b});
        hull.edges.push_back({b, c});
        hull.edges.push_back({c, a});
    }
    return hull;
}

}  // namespace

TEST_CASE("the hull of points is closed, convex, and of corners alone") {
    const NoTraps watch;
    Random random(7);
    int hulls = 0, flat = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::vector<gphys_vec3> points = random_points(random, i % 10 == 0 ? 120 : 30);
        const HullMesh hull(points);
        if (hull.defect == HullDefect::flat) {
            ++flat;
            for (const gphys_vec3& a : points) {
                for (const gphys_vec3& b : points) {
                    REQUIRE(orientation(widen(points[0]), widen(points[1]), widen(a), widen(b)) == 0);
                }
            }
            continue;
        }
        if (hull.defect != HullDefect::none) continue;
        ++hulls;
        REQUIRE(hull.report.open_edge_count == 0);
        REQUIRE(hull.report.degenerate_count == 0);
        REQUIRE(hull->triangle_count() == 2 * hull->vertices().size() - 4);
        for (uint32_t t = 0; t < hull->triangle_count(); ++t) {
            const Triangle triangle = hull->triangle(t);
            for (const gphys_vec3& p : points) {
                REQUIRE(orientation(triangle.a, triangle.b, triangle.c, widen(p)) <= 0);
            }
        }
        // A corner is on three faces at least; faces lie in different planes.
        for (uint32_t v = 0; v < hull->vertices().size(); ++v) {
            std::set<uint32_t> around;
            for (uint32_t k = 0; k < hull->indices().size(); ++k) {
                if (hull->indices()[k] == v) around.insert(hull->hull().face_of()[k / 3]);
            }
            REQUIRE(around.size() >= 3);
        }
        const auto& faces = hull->hull().faces();
        REQUIRE(faces.size() + hull->vertices().size() == hull->hull().edges().size() + 2);
        // The hull of its vertices is the same, triangle by triangle.
        const HullMesh again({hull->vertices().begin(), hull->vertices().end()});
        REQUIRE(again->hash() == hull->hash());
    }
    CHECK(hulls > 2000);
    CHECK(flat > 10);
}

TEST_CASE("what is flat, and what has more than 256 faces, is no hull") {
    CHECK(HullMesh({}).defect == HullDefect::flat);
    CHECK(HullMesh({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).defect == HullDefect::flat);
    CHECK(HullMesh({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}).defect == HullDefect::flat);
    CHECK(HullMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).defect == HullDefect::flat);
    CHECK(HullMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-40f}}).defect == HullDefect::none);
    // Prisms: two faces, and one for each side.
    for (const int sides : {254, 255}) {
        std::vector<gphys_vec3> points;
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * 3.14159265358979 * i / sides;
            for (const float z : {0.0f, 1.0f}) {
                points.push_back(
                    {static_cast<float>(100 * std::cos(angle)), static_cast<float>(100 * std::sin(angle)), z});
            }
        }
        CHECK(HullMesh(points).defect == (sides == 254 ? HullDefect::none : HullDefect::too_many_faces));
    }
    Random random(3);
    std::vector<gphys_vec3> many;
    for (int i = 0; i < 20000; ++i) many.push_back(narrow(random.direction()));
    CHECK(HullMesh(many).defect == HullDefect::too_many_faces);
}

TEST_CASE("rays of a batch at a hull have the bits of single rays") {
    const NoTraps watch;
    Random random(12);
    uint64_t met = 0, inside = 0, together = 0;
    for (int i = 0; i < cases / 50; ++i) {
        std::vector<gphys_vec3> points;
        for (int k = 0; k < 40; ++k) points.push_back(narrow(random.direction()));
        const HullMesh hull(points);
        const Transform world{random_point(random, 5), rotation_matrix(widen(random.rotation())),
                              random.uniform(0.5, 2)};
        // From one place, so that they go as a packet, or from anywhere, also from within.
        const bool coherent = i % 2 == 0;
        const Vec3 eye = random_point(random, 3);
        gphys_ray rays[64];
        for (gphys_ray& ray : rays) {
            const Vec3 from = coherent ? eye : random_point(random, 2);
            ray = {narrow(from), narrow(random_point(random, 0.7) - from), INFINITY};
        }
        const gphys_ray* of[64];
        gphys_hit hits[64], placed_hits[64], *out[64], *placed_out[64];
        Ray wide[64];
        for (int k = 0; k < 64; ++k) {
            of[k] = rays + k, out[k] = hits + k, placed_out[k] = placed_hits + k;
            wide[k] = widen(rays[k]);
            wide[k].origin = world.apply(wide[k].origin);
            wide[k].direction = world.apply_to_vector(wide[k].direction);
        }
        gphys_distance distances[64];
        const MeshPlace place{world, {}};
        const uint64_t all = hull->raycast_many(of, 64, out), placed = hull->raycast_many(wide, 64, place, placed_out);
        REQUIRE(hull->raycast_any_many(of, 64) == all);
        REQUIRE(hull->raycast_any_many(wide, 64, place) == placed);
        REQUIRE(hull->raycast_distance_many(of, 64, distances) == all);
        for (int k = 0; k < 64; ++k) {
            Hit hit;
            REQUIRE(hull->raycast(widen(rays[k]), hit) == (all >> k & 1));
            if ((all >> k & 1) != 0) {
                const gphys_hit single = to_hit(hit);
                REQUIRE(std::memcmp(&single, &hits[k], sizeof single) == 0);
                REQUIRE(distances[k].t == single.t);
                REQUIRE(distances[k].triangle == single.triangle);
                ++met;
                inside += (single.flags & GPHYS_HIT_INSIDE) != 0;
                together += coherent;
            }
            REQUIRE(raycast(MeshInstance{*hull, world}, wide[k], hit) == (placed >> k & 1));
            if ((placed >> k & 1) != 0) {
                const gphys_hit single = to_hit(hit);
                REQUIRE(std::memcmp(&single, &placed_hits[k], sizeof single) == 0);
            }
        }
    }
    CHECK(met > 1000);
    CHECK(inside > 100);
    CHECK(together > 500);
}

TEST_CASE("rays meet a box as a hull where they meet the box") {
    const NoTraps watch;
    Random random(11);
    int hits = 0, inside = 0;
    for (int i = 0; i < cases; ++i) {
        Vec3 low = grid_point(random, 2);
        const Vec3 size = abs(grid_point(random, 3)) + Vec3{1, 1, 1};
        const Aabb box{low, low + size};
        const HullMesh hull(corners_of(box));
        const bool on_grid = i % 2 == 0;
        Ray ray{on_grid ? grid_point(random, 5) : as_floats(random_point(random, 5)),
                on_grid ? grid_direction(random, 3) : as_floats(random_point(random, 2)), infinity};
        if (i % 3 == 0) ray.t_max = random.index(6);
        Hit expected, hit;
        const bool meets = raycast(box, ray, expected);
        REQUIRE(hull->raycast(ray, hit) == meets);
        REQUIRE(hull->raycast_any(ray) == meets);
        const gphys_ray rounded{narrow(ray.origin), narrow(ray.direction), static_cast<float>(ray.t_max)};
        const gphys_ray* rays[] = {&rounded};
        gphys_hit batch{};
        gphys_hit* out[] = {&batch};
        gphys_distance distance;
        REQUIRE(hull->raycast_many(rays, 1, out) == uint64_t{meets});
        REQUIRE(hull->raycast_distance(ray, distance) == meets);
        REQUIRE(hull->raycast_any_many(rays, 1) == uint64_t{meets});
        if (!meets) continue;
        ++hits;
        inside += expected.flags == GPHYS_HIT_INSIDE && hull->contains(ray.origin);
        const gphys_hit all = to_hit(hit);
        REQUIRE(std::memcmp(&all, &batch, sizeof all) == 0);
        REQUIRE(distance.t == reported(hit.t));
        REQUIRE(std::fabs(hit.t - expected.t) <= 1e-12 * (1 + expected.t));
        REQUIRE((hit.flags & GPHYS_HIT_BACK) == 0);
        REQUIRE((hit.flags & GPHYS_HIT_INSIDE) == (expected.flags & GPHYS_HIT_INSIDE));
        REQUIRE(is_sound(hit, ray));
        int listed = 0;
        hull->raycast_all(ray, [&](const Hit& each) { listed += each.t == hit.t; });
        REQUIRE(listed == 1);
    }
    CHECK(hits > cases / 20);
    CHECK(inside > cases / 100);
}

TEST_CASE("a ray meets a hull where all of its faces let it in") {
    Random random(12);
    for (int i = 0; i < 300; ++i) {
        const HullMesh hull = random_hull(random, 60);
        for (int k = 0; k < 300; ++k) {
            const Ray ray{as_floats(random_point(random, 4)), as_floats(random.direction()), infinity};
            double in = 0, out = infinity;
            for (const gphys::Hull::Face& face : hull->hull().faces()) {
                const double climb = dot(face.normal, ray.direction),
                             height = dot(face.normal, ray.origin - face.triangle.a);
                if (climb < 0) in = std::max(in, height / -climb);
                if (climb > 0) out = std::min(out, -height / climb);
                if (climb == 0 && height > 0) out = -1;
            }
            Hit hit;
            const bool meets = hull->raycast(ray, hit);
            if (std::fabs(in - out) > 1e-9) REQUIRE(meets == (in < out));
            if (meets) REQUIRE(std::fabs(hit.t - in) < 1e-9);
        }
    }
}

TEST_CASE("a hull contains what is behind all of its faces, and nearest points are on it") {
    const NoTraps watch;
    Random random(13);
    int inside = 0;
    for (int i = 0; i < 300; ++i) {
        const HullMesh hull = random_hull(random, 60);
        const test::Hull twin = twin_of(*hull);
        for (int k = 0; k < 50; ++k) {
            const Vec3 point = as_floats(k % 2 ? grid_point(random, 2) : random_point(random, 3));
            bool behind = true;
            for (uint32_t t = 0; t < hull->triangle_count(); ++t) {
                const Triangle face = hull->triangle(t);
                behind = behind && orientation(face.a, face.b, face.c, point) <= 0;
            }
            REQUIRE(hull->contains(point) == behind);
            inside += behind;
            Vec3 closest;
            uint32_t triangle = 1;
            REQUIRE(hull->closest_point(point, infinity, closest, triangle));
            const double gap = test::gap(test::hull(Sphere{point, 0}), twin).gap;
            // Of triangles that are equally near as reported, the first is taken.
            REQUIRE(std::fabs(distance(point, closest) - std::max(gap, 0.0)) <= 0x1p-23 * std::fabs(gap) + 1e-12);
            if (behind) REQUIRE((closest == point && triangle == GPHYS_NO_TRIANGLE));
            Vec3 normal;
            if (behind) REQUIRE(std::fabs(hull->hull().depth(point, normal, {}) + gap) < 1e-12);
        }
    }
    CHECK(inside > 500);
}

TEST_CASE("solids overlap hulls, and get out of them, as the widest gap of all axes says") {
    const NoTraps watch;
    Random random(14);
    SolidCases solids(15);
    int overlapping = 0, apart = 0, rounded = 0;
    for (int i = 0; i < 200; ++i) {
        const HullMesh hull = random_hull(random, 24);
        const test::Hull twin = twin_of(*hull);
        for (int k = 0; k < 60; ++k) {
            const SolidPair pair = solids.next(3);
            const Shape& solid = pair.moving;
            if (pair.size > 30) continue;
            const test::Gap gap = test::gap(twin, twin_of(solid));
            const double band = 0x1p-40 * pair.size;
            const bool overlap = hull->overlaps(solid);
            if (std::fabs(gap.gap) > band) REQUIRE(overlap == (gap.gap < 0));
            overlap ? ++overlapping : ++apart;
            int ways = 0;
            hull->for_each_penetration(solid, [&](const Penetration& way, uint32_t triangle) {
                ++ways;
                REQUIRE(triangle == GPHYS_NO_TRIANGLE);
                REQUIRE(std::fabs(way.depth + std::min(gap.gap, 0.0)) <= band);
                REQUIRE(std::fabs(length(way.normal) - 1) < 1e-12);
                const Shape out = moved(solid, way.normal * (way.depth + 4 * band));
                REQUIRE(!hull->overlaps(out));
                // On both, where they touch.
                REQUIRE(hull->overlaps(Sphere{way.point, 4 * band}));
                REQUIRE(overlaps(out, Shape(Sphere{way.point, 0x1p-24 * pair.size})));
                rounded += std::holds_alternative<Sphere>(solid);
            });
            REQUIRE(ways == int{overlap});
        }
    }
    CHECK(overlapping > 1000);
    CHECK(apart > 1000);
    CHECK(rounded > 100);
}

TEST_CASE("a solid that is swept stops where it begins to overlap a hull") {
    const NoTraps watch;
    Random random(16);
    SolidCases solids(17);
    int contacts = 0, starts = 0, misses = 0;
    for (int i = 0; i < 300; ++i) {
        const HullMesh hull = random_hull(random, 24);
        for (int k = 0; k < 60; ++k) {
            const SolidPair pair = solids.next(6);
            if (pair.size > 60) continue;
            const double band = 0x1p-40 * pair.size;
            const bool shrinks = has_thickness(pair.moving, band);
            const auto overlap_at = [&](double t, double grow) {
                return hull->overlaps(grown(moved(pair.moving, pair.way * t), grow));
            };
            Hit hit;
            if (!hull->sweep(pair.moving, pair.way, hit)) {
                ++misses;
                for (int s = 0; s <= 16 && shrinks; ++s) REQUIRE(!overlap_at(s / 16.0, -band));
                continue;
            }
            REQUIRE((hit.flags & GPHYS_HIT_BACK) == 0);
            if (hit.flags & GPHYS_HIT_INSIDE) {
                ++starts;
                REQUIRE(hit.t == 0);
                REQUIRE(overlap_at(0, band));
                continue;
            }
            ++contacts;
            REQUIRE(overlap_at(hit.t, band));
            for (int s = 0; s < 8 && shrinks; ++s) REQUIRE(!overlap_at(hit.t * s / 8, -band));
            REQUIRE(dot(hit.normal, pair.way) <= band);
            REQUIRE(hull->overlaps(Sphere{hit.point, 4 * band}));
        }
    }
    CHECK(contacts > 1000);
    CHECK(starts > 500);
    CHECK(misses > 500);
}

TEST_CASE("a thin hull is met with a plane between it and what moves") {
    const NoTraps watch;
    struct Encounter {
        std::vector<gphys_vec3> points;
        Shape moving;
        gphys_vec3 way;
    };
    // Balls that are little more than points at corners; boxes that are segments or points; a box that lies on a face.
    const Encounter encounters[] = {
        {{{-0x1p+0f, 0, 0x1.1a6264p-53f},
          {0x1.1a6264p-53f, 0x1.1a6264p-54f, -0x1p-149f},
          {-0x1.fffffcp-3f, -0x1.1a6262p-54f, 0x1p+0f},
          {0x1.1a6264p-54f, 0x1p-2f, 0},
          {-0x1p+0f, 0x1.1a6264p-54f, -0x1p+0f},
          {0x1.1a6262p-53f, 0x1p-2f, 0}},
         widen(gphys_sphere{{0x1p-53f, -0x1p+0f, -0x1.8p-28f}, 0x1.8p-28f}),
         {-0x1.38eacap+1f, 0x1.38eacap+1f, -0x1.38eacap+1f}},
        {{{-0x1.1a6268p-53f, 0, -0x1.1a6264p-52f},
          {-0x1p+0f, -0x1.1a6264p-54f, -0x1.1a6264p-54f},
          {0x1.1a6264p-54f, 0x1.000002p+0f, 0x1p-149f},
          {-0x1p+0f, 0x1p-149f, 0x1p-147f},
          {0, -0x1p-149f, -0x1.1a6264p-54f},
          {-0x1p-1f, -0x1.1a6264p-54f, 0x1p+0f},
          {-0x1p-149f, -0x1p+0f, 0x1p-2f}},
         widen(gphys_sphere{{0x1p-49f, -0x1p-1f, -0x1.000004p+0f}, 0x1.8p-30f}),
         {0, 0x1p+0f, 0x1.000004p+1f}},
        {{{0x1.a7939ap-53f, 0x1p-25f, 0},
          {-0x1p-2f, 0x1p-149f, -0x1.fffffep-3f},
          {-0x1p-2f, -0x1.1a6264p-54f, 0x1.000004p+0f},
          {-0x1p+0f, 0x1.000002p-2f, -0x1.1a6264p-54f},
          {-0x1p-148f, -0x1p-1f, -0x1p-2f}},
         widen(gphys_capsule{{0x1p-52f, -0x1p+0f, 0x1.fffffep-1f}, {0x1p+0f, -0x1.1a6264p-54f, 0x1.fffffep-1f}, 0}),
         {0, 0x1p+1f, -0x1.fffffep+0f}},
        {{{0x1p+12f, 0x1p-52f, 0},
          {0x1.1a626p-52f, 0x1p-3f, -0x1p-2f},
          {0x1.1a6264p-53f, -0x1p-149f, 0x1p-4f},
          {0, -0x1p+0f, -0x1p-148f},
          {-0x1p+0f, -0x1.a79396p-53f, -0x1p-9f},
          {-0x1.1a6264p-54f, 0x1.1a6264p-54f, -0x1p-148f}},
         widen(gphys_capsule{
             {0x1.a79396p-54f, 0x1.1a6264p-55f, 0x1.8p-1f}, {0x1.a79396p-54f, 0x1.1a6264p-55f, 0x1.8p-1f}, 0x1p-1f}),
         {0x1p+12f, 0x1p-52f, -0x1p-2f}},
        {{{0x1.1a6264p-52f, 0, -0x1.8p-148f},
          {0x1.000002p+0f, -0x1p-2f, -0x1p-24f},
          {0x1.1a626p-54f, -0x1p+0f, 0x1p-2f},
          {0x1p-31f, -0x1.1a6264p-52f, 0x1p-147f},
          {-0x1.1a6264p-54f, -0x1.1a6264p-54f, 0x1.1a6264p-54f},
          {0x1.000002p+0f, 0x1p-2f, 0x1p+0f},
          {0x1.1a6264p-54f, -0x1.1a6264p-54f, 0x1p+0f},
          {-0x1.1a6264p-54f, 0x1.800004p-15f, -0x1.1a6264p-54f},
          {-0x1p-147f, 0x1p-148f, -0x1p+0f},
          {-0x1p-28f, 0, -0x1p+0f},
          {0, 0x1.1a6264p-52f, 0x1p-57f}},
         widen(gphys_aabb{{-0x1.64d876p+4f, 0x1.14b7b6p+2f, 0x1.9ceb5p+2f},
                          {-0x1.60d876p+4f, 0x1.34b7b6p+2f, 0x1.9ceb5p+2f}}),
         {0x1.64d876p+5f, -0x1.14b7b6p+3f, -0x1.dceb5p+3f}},
        {{{-0x1.1a626p-54f, -0x1.000002p-54f, 0x1p-2f},
          {-0x1p+0f, -0x1p+0f, -0x1.8p-148f},
          {0, 0x1.1a6264p-52f, 0x1.000002p+0f},
          {0x1p-1f, 0x1p-148f, 0x1p-1f},
          {0, 0x1.1a6264p-54f, -0x1.1a6264p-52f},
          {0, 0x1.1a6264p-52f, 0x1.fffffep-1f},
          {-0x1.1a6264p-52f, -0x1p-31f, 0x1.8p-148f},
          {0x1.000002p+0f, -0x1p-1f, 0}},
         widen(gphys_aabb{{0x1.2f0d3cp+12f, 0x1.43e816p+8f, 0x1.ff8468p+7f},
                          {0x1.2f0d3cp+12f, 0x1.43e816p+8f, 0x1.ff8468p+7f}}),
         {-0x1.2f0d3cp+13f, -0x1.43e816p+9f, -0x1.fd8468p+8f}},
        {{{0x1p+0f, -0x1p-148f, 0x1p-148f},
          {0x1p+0f, 0x1p+0f, -0x1p+0f},
          {-0x1p-149f, -0x1p-147f, 0x1p-147f},
          {0, 0x1.1a6264p-54f, 0x1.000004p-35f},
          {0x1p+0f, 0x1p+0f, -0x1.1a626p-52f}},
         widen(gphys_obb{{0x1.05125cp+1f, 0x1.788df4p+1f, -0x1.0030a2p+0f},
                         {0x1p-147f, 0x1.1a6264p-54f, 0x1p-148f},
                         {0, 0, 0, 0x1p+0f}}),
         {-0x1.05125cp+2f, -0x1.788df4p+2f, 0x1.0030a2p+1f}},
        {{{-0x1p-1f, -0x1.1a6262p-52f, 0x1p-147f},
          {-0x1.1a6264p-54f, 0x1.1a6264p-54f, 0x1p-58f},
          {0x1.1a6264p-53f, -0x1.8p-27f, -0x1p-28f},
          {0x1p+0f, -0x1p+0f, -0x1p+0f},
          {-0x1p+0f, -0x1.1a6262p-54f, -0x1p-21f}},
         widen(gphys_obb{
             {0x1p+0f, -0x1.1a6264p-54f, 0x1p+0f}, {0x1p+0f, 0, 0x1p+0f}, {0, 0x1.6a09e6p-1f, 0, 0x1.6a09e6p-1f}}),
         {0x1.000004p+1f, 0x1p+1f, 0x1.1a6264p-52f}},
        {{{-0x1p+0f, 0x1p-14f, -0x1.8p-23f},
          {0x1.1a6266p-54f, 0x1.1a6264p-52f, 0x1p-1f},
          {-0x1p-2f, 0x1p-2f, 0x1.a79396p-53f},
          {-0x1p+0f, 0, -0x1.1a6262p-52f},
          {0, 0x1.fffffep-19f, 0x1.000004p-2f},
          {-0x1p+0f, -0x1.fffffep-1f, 0x1p+0f},
          {-0x1p-40f, -0x1.1a6264p-53f, -0x1.1a6268p-54f},
          {-0x1p-2f, -0x1.1a6264p-54f, 0x1.000002p-2f},
          {0x1p+0f, -0x1.1a6264p-54f, -0x1p-2f}},
         widen(gphys_obb{{-0x1p+0f, -0x1p-149f, -0x1p-43f}, {0, 0x1.8p-148f, 0x1p-149f}, {0, 0, 0, 0x1p+0f}}),
         {0x1p+0f, 0, 0x1.ffb968p-44f}},
    };
    for (const Encounter& each : encounters) {
        const HullMesh made(each.points);
        const Vec3 way = widen(each.way);
        Hit hit;
        REQUIRE(made->sweep(each.moving, way, hit));
        CHECK(dot(hit.normal, way) <= 1e-15 * length(way));
        const test::Hull hull = twin_of(*made), solid = twin_of(moved(each.moving, way * hit.t));
        double size = max_component(abs(way));
        for (const Vec3& corner : hull.corners) size = std::max(size, length(corner - solid.corners[0]));
        CHECK(beyond_plane(hull, solid, hit.point, hit.normal) < 0x1p-20 * size);
    }
}

TEST_CASE("a capsule whose axis touches the edge of a hull goes out the way that a face says") {
    const HullMesh made({{-0x1p-1f, 0x1p+0f, 0x1p-149f},
                         {0x1p+0f, 0x1.1a6264p-54f, 0x1p+0f},
                         {0x1p+0f, -0x1.a79396p-53f, 0x1p+0f},
                         {0x1.1a6264p-54f, 0x1.1a6264p-54f, 0x1.1a6264p-54f},
                         {-0x1.1a6264p-54f, 0x1p-148f, 0x1.1a6264p-54f},
                         {-0x1.a79398p-53f, -0x1.8p-3f, 0x1.1a6264p-52f},
                         {-0x1p+0f, 0x1.a79396p-53f, 0x1.800002p+14f}});
    const Shape capsule = widen(gphys_capsule{{0x1.00cb24p-1f, -0x1.00cb24p+0f, 0x1.4036dep-55f},
                                              {-0x1.fe69b8p-2f, 0x1.fe69b8p-1f, 0x1.6a701cp-53f},
                                              0x1p-2f});
    int ways = 0;
    made->for_each_penetration(capsule, [&](const Penetration& out, uint32_t) {
        ++ways;
        const test::Hull solid = twin_of(moved(capsule, out.normal * out.depth));
        CHECK(beyond_plane(twin_of(*made), solid, out.point, out.normal) < 0x1p-8);
    });
    CHECK(ways == 1);
}

TEST_CASE("a box as a hull is swept and left as the box is") {
    const NoTraps watch;
    SolidCases solids(18);
    int contacts = 0, ways = 0;
    const Aabb box{{-1, -0.5, -2}, {1, 1.5, 1}};
    const HullMesh hull(corners_of(box));
    for (int i = 0; i < 20000; ++i) {
        const SolidPair pair = solids.next(5);
        if (pair.size > 60) continue;
        const double band = 0x1p-40 * pair.size;
        Hit hit, expected;
        const bool meets = sweep(Shape(box), pair.moving, pair.way, expected);
        if (hull->sweep(pair.moving, pair.way, hit) && meets) {
            ++contacts;
            // Between those of a solid that is larger by the band and of one that is smaller.
            Hit early, late;
            REQUIRE(sweep(Shape(box), grown(pair.moving, 4 * band), pair.way, early));
            REQUIRE(early.t <= hit.t * (1 + 0x1p-23) + 1e-14);
            const bool shrinks = has_thickness(pair.moving, 4 * band);
            if (shrinks && sweep(Shape(box), grown(pair.moving, -4 * band), pair.way, late)) {
                REQUIRE(hit.t <= late.t * (1 + 0x1p-23) + 1e-14);
            }
        }
        if (!overlaps(Shape(box), pair.moving)) continue;
        const Penetration way = penetration(Shape(box), pair.moving);
        hull->for_each_penetration(pair.moving, [&](const Penetration& other, uint32_t) {
            ++ways;
            REQUIRE(std::fabs(other.depth - way.depth) <= band);
        });
    }
    CHECK(contacts > 3000);
    CHECK(ways > 1000);
}

TEST_CASE("what a hull holds wholly, or what holds it, overlaps it") {
    const HullMesh hull(corners_of({{-4, -4, -4}, {4, 4, 4}}));
    CHECK(hull->overlaps(Sphere{{1, 0, 0}, 0.5}));
    CHECK(hull->overlaps(Sphere{{1, 0, 0}, 50}));
    CHECK(hull->overlaps(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    CHECK(hull->overlaps(Plane{{0, 1, 0}, 4}));
    CHECK(!hull->overlaps(Plane{{0, 1, 0}, 4.1}));
    Frustum small;
    small.origin = {1, 1, 1};
    const Vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int k = 0; k < 3; ++k) {
        small.planes[2 * k] = {axis[k], -0.5};
        small.planes[2 * k + 1] = {-axis[k], -0.5};
    }
    CHECK(hull->overlaps(small));
    small.origin = {9, 1, 1};
    CHECK(!hull->overlaps(small));
    Mesh* const within = test::sphere(2).make();
    Mesh* const around = test::sphere(2).placed({0, 0, 0}, {30, 30, 30}).make();
    CHECK(hull->overlaps(*within));
    CHECK(within->overlaps(*hull));
    CHECK(!hull->overlaps(*around));
    CHECK(!around->overlaps(*hull));
    const HullMesh inner(corners_of({{-1, -1, -1}, {1, 1, 1}})), outer(corners_of({{-9, -9, -9}, {9, 9, 9}}));
    CHECK(hull->overlaps(*inner));
    CHECK(inner->overlaps(*hull));
    CHECK(hull->overlaps(*outer));
    Mesh::release(within);
    Mesh::release(around);
}

TEST_CASE("a tiny hull answers as a large one does") {
    Random random(19);
    for (int i = 0; i < 200; ++i) {
        const std::vector<gphys_vec3> points = random_points(random, 20, false);
        const HullMesh large(points);
        if (large.defect != HullDefect::none) continue;
        std::vector<gphys_vec3> shrunk;
        constexpr float by = 0x1p-60f;
        for (const gphys_vec3& p : points) shrunk.push_back({p.x * by, p.y * by, p.z * by});
        const HullMesh small(shrunk);
        for (int k = 0; k < 50; ++k) {
            const Ray ray{as_floats(random_point(random, 4)), as_floats(random.direction()), infinity};
            Hit hit, other;
            const bool meets = large->raycast(ray, hit);
            REQUIRE(small->raycast({ray.origin * double{by}, ray.direction * double{by}, infinity}, other) == meets);
            if (meets) REQUIRE(hit.t == other.t);
            REQUIRE(small->contains(ray.origin * double{by}) == large->contains(ray.origin));
        }
    }
}

TEST_CASE("a scene answers for hulls as a look at each of them does") {
    const NoTraps watch;
    Random random(20);
    Scene scene(nullptr);
    const HullMesh rock = random_hull(random, 40);
    std::vector<gphys_model_id> models;
    std::vector<gphys_transform> places;
    gphys_model_desc desc{sizeof desc, 0, 1, 0, {1, 1, 1}};
    for (int i = 0; i < 300; ++i) {
        places.push_back({random.point(20), random.rotation(), random.uniform_float(0.3f, 2)});
        models.push_back(0);
        REQUIRE(scene.add(GPHYS_SHAPE_MESH, &*rock, 0, &places.back(), 0, 1, desc, &models.back()) == GPHYS_OK);
    }
    REQUIRE(scene.defect() == nullptr);
    std::vector<Ray> rays;
    std::vector<gphys_hit> singles;
    for (int i = 0; i < test::tries(2000); ++i) {
        const Ray ray{widen(random.point(25)), as_floats(random.direction()), infinity};
        gphys_hit hit{};
        hit.t = std::numeric_limits<float>::infinity();
        const gphys_status status = scene.raycast(ray, GPHYS_ALL_LAYERS, hit);
        float first = std::numeric_limits<float>::infinity();
        for (const gphys_transform& place : places) {
            const Transform world = widen(place);
            Hit each;
            if (raycast(MeshInstance{*rock, world}, ray, each)) first = std::min(first, reported(each.t));
        }
        REQUIRE((status == GPHYS_OK) == (first < std::numeric_limits<float>::infinity()));
        REQUIRE(hit.t == first);
        REQUIRE(scene.raycast_any(ray, GPHYS_ALL_LAYERS) == (status == GPHYS_OK));
        rays.push_back(ray);
        singles.push_back(hit);
    }
    for (size_t first = 0; first + Scene::rays_at_once <= rays.size(); first += Scene::rays_at_once) {
        Ray some[Scene::rays_at_once];
        gphys_hit hits[Scene::rays_at_once] = {};
        gphys_hit* out[Scene::rays_at_once];
        for (uint32_t k = 0; k < Scene::rays_at_once; ++k) {
            some[k] = rays[first + k];
            hits[k].t = std::numeric_limits<float>::infinity();
            out[k] = hits + k;
        }
        scene.raycast_many(some, Scene::rays_at_once, GPHYS_ALL_LAYERS, out);
        REQUIRE(std::memcmp(hits, &singles[first], sizeof hits) == 0);
    }
    int inside = 0;
    for (int i = 0; i < test::tries(2000); ++i) {
        const Vec3 point = widen(random.point(20));
        const Sphere ball{point, random.uniform(0, 1)};
        std::vector<gphys_model_id> found(models.size()), expected;
        found.resize(scene.overlap(ball, GPHYS_ALL_LAYERS, found.data(), static_cast<uint32_t>(found.size())));
        float nearest = std::numeric_limits<float>::infinity();
        for (size_t m = 0; m < models.size(); ++m) {
            const Transform world = widen(places[m]);
            const MeshInstance instance{*rock, world};
            if (overlaps(instance, ball)) expected.push_back(models[m]);
            Vec3 closest, normal;
            uint32_t triangle;
            REQUIRE(closest_point(instance, point, infinity, closest, triangle));
            nearest = std::min(nearest, reported(distance(closest, point)));
            if (triangle == GPHYS_NO_TRIANGLE) REQUIRE(closest == point);
            double height;
            REQUIRE(scene.closest_point_model(models[m], point, closest, normal, height));
            const bool holds = rock->contains(world.inverse_apply(point));
            inside += holds;
            REQUIRE(holds == (triangle == GPHYS_NO_TRIANGLE));
            REQUIRE((height <= 0) == holds);
            REQUIRE(std::fabs(dot(normal, point - closest) - height) < 1e-9);
        }
        REQUIRE(found == expected);
        gphys_nearest near{};
        REQUIRE(scene.nearest(point, infinity, GPHYS_ALL_LAYERS, near) == GPHYS_OK);
        REQUIRE(near.distance == nearest);
    }
    CHECK(inside > test::tries(100));

    uint32_t total = 0;
    REQUIRE(scene.snapshot(true, nullptr, 0, total) == GPHYS_INCOMPLETE);
    std::vector<uint32_t> words(total);
    REQUIRE(scene.snapshot(true, words.data(), total, total) == GPHYS_OK);
    Scene other(nullptr);
    REQUIRE(other.restore(other, words.data(), total) == GPHYS_OK);
    uint32_t hash[2], other_hash[2];
    scene.hash(hash);
    other.hash(other_hash);
    REQUIRE(std::equal(hash, hash + 2, other_hash));
    REQUIRE(other.mesh(models[0])->is_hull());
    REQUIRE(other.mesh(models[0])->hull().faces().size() == rock->hull().faces().size());
}

TEST_CASE("words of a hull that is none are refused") {
    Random random(21);
    const HullMesh hull = random_hull(random, 30);
    uint32_t total = 0;
    hull->snapshot(nullptr, 0, total);
    std::vector<uint32_t> words(total);
    REQUIRE(hull->snapshot(words.data(), total, total) == GPHYS_OK);
    Memory memory(nullptr);
    MeshParts parts;
    REQUIRE(read_mesh_snapshot(words.data(), total, &memory, parts) == nullptr);
    REQUIRE(parts.hash == hull->hash());
    const auto refused = [&](std::vector<uint32_t> changed) {
        SnapshotHeader header;
        std::memcpy(&header, changed.data(), sizeof header);
        header.set_checksum(mesh_snapshot_checksum(changed.data(), total));
        std::memcpy(changed.data(), &header, sizeof header);
        return read_mesh_snapshot(changed.data(), total, &memory, parts) != nullptr;
    };
    const uint32_t first_index = mesh_snapshot_begin,
                   first_coordinate = first_index + static_cast<uint32_t>(hull->indices().size());
    REQUIRE(!refused(words));
    // A vertex in the middle of the others, triangles that are turned around or not closed, another kind.
    std::vector<uint32_t> changed = words;
    const Vec3 center = hull->center();
    const gphys_vec3 middle = narrow(center);
    std::memcpy(&changed[first_coordinate], &middle, sizeof middle);
    CHECK(refused(changed));
    changed = words;
    std::swap(changed[first_index], changed[first_index + 1]);
    CHECK(refused(changed));
    changed = words;
    changed[first_index] = changed[first_index + 1];
    CHECK(refused(changed));
    changed = words;
    changed.back() = 4;
    CHECK(refused(changed));
    changed.back() = static_cast<uint32_t>(MeshKind::body_surface);
    CHECK(!refused(changed));
}

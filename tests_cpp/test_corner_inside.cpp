#include "mesh/corner_inside.h"

#include <ctime>
#include <vector>

#include "stored_cases.h"

using namespace gphys;

namespace {

/// The half-spaces around a box, as a frustum whose planes have normals of any length.
Frustum frustum_of(const Aabb& box, double size, Vec3 origin) {
    const Vec3 low = (box.min - origin) * size, high = (origin - box.max) * size;
    return {origin,
            {{{size, 0, 0}, low.x},
             {{0, size, 0}, low.y},
             {{0, 0, size}, low.z},
             {{-size, 0, 0}, high.x},
             {{0, -size, 0}, high.y},
             {{0, 0, -size}, high.z}}};
}

}  // namespace

TEST_CASE("a triangle that is said to have a corner inside a solid overlaps it, also where it only touches") {
    Cases cases(91);
    int said[2][5] = {}, overlapped[2][5] = {};
    for (int i = 0; i < 60000; ++i) {
        cases.next();
        const auto corner = [&] { return widen(cases.point(4)); };
        Triangle triangle{corner(), corner(), corner()};
        const Sphere sphere = widen(cases.sphere());
        const Aabb box = widen(cases.aabb());
        const Obb turned = widen(cases.obb());
        const Capsule capsule{corner(), corner(), cases.size()};
        if (!cases.coarse() && i % 3 == 0) {
            // On a surface, or off by some roundings.
            const Vec3 out = normalized(corner() + Vec3{0, 0, 9});
            triangle.a = sphere.center + out * (sphere.radius * (1 + std::exp2(cases.number(8) - 48)));
        }
        const auto check = [&](int kind, const auto& solid) {
            const bool has = has_corner_inside(solid, triangle), truth = overlaps(Shape(solid), Shape(triangle));
            said[cases.coarse()][kind] += has;
            overlapped[cases.coarse()][kind] += truth;
            REQUIRE((truth || !has));
        };
        check(0, sphere);
        check(1, box);
        check(2, turned);
        check(3, capsule);
        check(4, frustum_of(box, cases.size() + 1e-3, corner()));
    }
    for (int kind = 0; kind < 5; ++kind) {
        CAPTURE(kind);
        CHECK(said[0][kind] > 500);
        CHECK(said[0][kind] * 20 > overlapped[0][kind]);
    }
}

TEST_CASE("the triangles in a box that contains most of a mesh are found faster than all are tested exactly") {
    test::Random random(92);
    std::vector<gphys_vec3> vertices;
    std::vector<uint32_t> indices;
    for (uint32_t i = 0; i < 20000; ++i) {
        const Vec3 at = random.direction() * random.uniform(0, 1);
        for (int k = 0; k < 3; ++k) {
            indices.push_back(static_cast<uint32_t>(vertices.size()));
            vertices.push_back(narrow(at + random.direction() * 0.02));
        }
    }
    gphys_mesh* mesh = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, &vertices[0].x, 12, static_cast<uint32_t>(vertices.size()), indices.data(),
                              static_cast<uint32_t>(indices.size()), &mesh) == GPHYS_OK);
    const gphys_aabb box{{-0.9f, -0.9f, -0.9f}, {0.9f, 0.9f, 0.9f}};
    const Shape exact = widen(box);
    std::vector<uint32_t> found(20000), wanted;
    double fast = infinity, slow = infinity;
    for (int round = 0; round < 5; ++round) {
        uint32_t total = 0;
        std::clock_t begin = std::clock();
        REQUIRE(gphys_mesh_overlap(mesh, GPHYS_SHAPE_AABB, &box, found.data(), 20000, &total) == GPHYS_OK);
        fast = std::min(fast, static_cast<double>(std::clock() - begin));
        begin = std::clock();
        wanted.clear();
        for (uint32_t i = 0; i < 20000; ++i) {
            const gphys_vec3* const v = &vertices[size_t{3} * i];
            if (overlaps(exact, Shape(Triangle{widen(v[0]), widen(v[1]), widen(v[2])}))) wanted.push_back(i);
        }
        slow = std::min(slow, static_cast<double>(std::clock() - begin));
        REQUIRE(total == wanted.size());
        REQUIRE(std::equal(wanted.begin(), wanted.end(), found.begin()));
    }
    gphys_mesh_destroy(mesh);
    CAPTURE(fast, slow);
    CHECK(fast < slow / 3);  // 1, if each triangle were tested exactly
}

#include "mesh/triangle_packet.h"

#include <cfenv>
#include <memory>

#include "meshes.h"
#include "test.h"

using namespace gphys;

namespace {

using MeshHolder = std::unique_ptr<const Mesh, void (*)(const Mesh*)>;

gphys_vec3 random_vertex(test::Random& random, Vec3 centre, double size) {
    return narrow(centre + random.direction() * random.uniform(0, size));
}

/// Up to eight triangles, one packet: any, slivers, with shared corners, degenerate.
test::Arrays few_triangles(test::Random& random, Vec3 centre, double size) {
    test::Arrays arrays;
    const uint32_t count = 1 + random.index(8);
    for (uint32_t i = 0; i < count + 2; ++i) arrays.vertices.push_back(random_vertex(random, centre, size));
    for (uint32_t i = 0; i < count; ++i) {
        if (random.index(4) == 0) {  // 6e5 times as long as wide
            const Vec3 along = random.direction() * (random.uniform(0, 1e-6) * size);
            arrays.vertices[i + 1] = narrow(widen(arrays.vertices[i]) + along);
        }
        random.index(8) == 0 ? arrays.add(i, i + 1, i) : arrays.add(i, i + 1, i + 2);
    }
    return arrays;
}

/// Past, at or from a corner, an edge or a face of one of them.
Ray ray_at(test::Random& random, const Mesh& mesh, Vec3 centre, double size) {
    const Triangle triangle = mesh.triangle(random.index(mesh.triangle_count()));
    const double u = random.index(2) ? random.uniform(-0.1, 1.1) : random.index(2);
    const double v = random.index(2) ? random.uniform(-0.1, 1.1 - u) : 0;
    const Vec3 target = widen(narrow(triangle.a + (triangle.b - triangle.a) * u + (triangle.c - triangle.a) * v));
    const double distance = size * (random.index(4) == 0 ? 1e4 : 2);
    Vec3 origin = widen(random_vertex(random, centre, distance));
    if (random.index(8) == 0) origin = target;
    Ray ray{origin, widen(narrow(target - origin)), infinity};
    if (random.index(8) == 0) ray.direction = widen(narrow(random.direction() * size));
    if (random.index(8) == 0) ray.direction[static_cast<int>(random.index(3))] = 0;
    if (random.index(4) == 0) ray.t_max = random.index(2) ? 1 : random.uniform(0, 2);
    return ray;
}

}  // namespace

TEST_CASE("a packet's float test keeps every triangle that a ray hits, at any size and place") {
    constexpr int trapped = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;
    test::Random random(1);
    for (const double size : {1e-42, 1e-36, 1e-20, 1e-6, 1.0, 1e6, 1e12, 7e14}) {
        for (const double offset : {0.0, 1.0, 3e5, 1e7}) {
            const Vec3 centre = Vec3{offset, -0.7 * offset, 0.3 * offset} * size;
            if (max_component(abs(centre)) + size > 9e14) continue;
            INFO("size " << size << ", offset " << offset);
            int hit_count = 0;
            for (int i = 0; i < 400; ++i) {
                const test::Arrays arrays = few_triangles(random, centre, size);
                for (const Isa isa : test::isas()) {
                    const MeshHolder mesh(arrays.make(nullptr, isa), Mesh::release);
                    REQUIRE(mesh->packets().size() == 1);
                    for (int k = 0; k < 4; ++k) {
                        const Ray ray = ray_at(random, *mesh, centre, size);
                        uint32_t found = 0, expected = 0;
                        std::feclearexcept(FE_ALL_EXCEPT);
                        mesh->raycast_all(ray, [&](const Hit& hit) { found |= 1u << hit.triangle; });
                        REQUIRE(std::fetestexcept(trapped) == 0);
                        for (uint32_t triangle = 0; triangle < mesh->triangle_count(); ++triangle) {
                            Hit hit;
                            if (raycast(mesh->triangle(triangle), ray, hit)) expected |= 1u << triangle;
                        }
                        REQUIRE(found == expected);
                        hit_count += expected != 0;
                    }
                }
            }
            REQUIRE(hit_count > 300);
        }
    }
}

TEST_CASE("rays of one origin keep every triangle that they hit, at any size and place, near and far") {
    constexpr int trapped = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;
    test::Random random(2);
    for (const double size : {1e-20, 1e-6, 1.0, 1e6, 1e12, 7e13}) {
        for (const double offset : {0.0, 1.0, 3e5}) {
            const Vec3 centre = Vec3{offset, -0.7 * offset, 0.3 * offset} * size;
            if (max_component(abs(centre)) + 10 * size > 9e14) continue;
            INFO("size " << size << ", offset " << offset);
            int hit_count = 0;
            for (int i = 0; i < 60; ++i) {
                const test::Arrays arrays = few_triangles(random, centre, size);
                const double distances[] = {0.5, 2, 6, 30};
                const gphys_vec3 eye = random_vertex(random, centre, size * distances[i % 4]);
                for (const Isa isa : test::isas()) {
                    const MeshHolder mesh(arrays.make(nullptr, isa), Mesh::release);
                    gphys_ray rays[Mesh::rays_at_once];
                    const gphys_ray* each[Mesh::rays_at_once];
                    gphys_hit hits[Mesh::rays_at_once], *out[Mesh::rays_at_once];
                    for (uint32_t k = 0; k < Mesh::rays_at_once; ++k) {
                        const Ray ray = ray_at(random, *mesh, centre, size);
                        const Vec3 target = ray.origin + ray.direction;
                        // The first ray decides the octant of all.
                        Vec3 direction = target - widen(eye);
                        for (int axis = 0; axis < 3 && k > 0; ++axis) {
                            direction[axis] = std::copysign(direction[axis], double{(&rays[0].direction.x)[axis]});
                        }
                        if (direction == Vec3{}) direction = {1, 1, 1};
                        rays[k] = {eye, narrow(direction), random.index(4) == 0 ? 1 : INFINITY};
                        each[k] = &rays[k];
                        out[k] = &hits[k];
                    }
                    std::feclearexcept(FE_ALL_EXCEPT);
                    const uint64_t found = mesh->raycast_many(each, Mesh::rays_at_once, out);
                    REQUIRE(std::fetestexcept(trapped) == 0);
                    for (uint32_t k = 0; k < Mesh::rays_at_once; ++k) {
                        float nearest = INFINITY;
                        for (uint32_t triangle = 0; triangle < mesh->triangle_count(); ++triangle) {
                            Hit hit;
                            if (!raycast(mesh->triangle(triangle), widen(rays[k]), hit)) continue;
                            nearest = std::min(nearest, to_hit(hit).t);
                        }
                        REQUIRE((found >> k & 1) == uint64_t{nearest < INFINITY});
                        if (nearest < INFINITY) REQUIRE(hits[k].t == nearest);
                        hit_count += nearest < INFINITY;
                    }
                }
            }
            REQUIRE(hit_count > 1000);
        }
    }
}

TEST_CASE("packets hold each triangle of a mesh once, seven of eight lanes on average") {
    for (const test::Arrays& arrays : {test::sphere(5), test::torus(60, 30), test::grid(60), test::soup(3000, 2)}) {
        Vector<TrianglePacket> packets;
        Vector<Box> boxes;
        pack_triangles(arrays.view(), packets, boxes);
        const auto triangle_count = static_cast<uint32_t>(arrays.indices.size() / 3);
        std::vector<int> seen(triangle_count);
        REQUIRE(boxes.size() == packets.size());
        for (size_t i = 0; i < packets.size(); ++i) {
            Box box;
            for (int lane = 0; lane < 8; ++lane) {
                const uint32_t index = packets[i].index[lane];
                const bool used = (packets[i].lanes() >> lane & 1) != 0;
                REQUIRE(used == (index != TrianglePacket::none));
                const uint32_t* corner = arrays.indices.data() + 3 * packets[i].index[used ? lane : 0];
                const Triangle triangle = packets[i].triangle(lane);
                REQUIRE(triangle.a == widen(arrays.vertices[corner[0]]));
                REQUIRE(triangle.b == widen(arrays.vertices[corner[1]]));
                REQUIRE(triangle.c == widen(arrays.vertices[corner[2]]));
                if (!used) continue;
                ++seen[index];
                box.include(bounds(triangle));
            }
            REQUIRE(box == boxes[i]);
        }
        for (const int times : seen) REQUIRE(times == 1);
        REQUIRE(packets.size() * 7 <= triangle_count);
    }
}

TEST_CASE("triangles in a geometric series of sizes, and all in one place, are packed") {
    test::Arrays series, heap;
    float size = 1e-30f;
    for (uint32_t i = 0; i < 900; ++i, size *= 1.07f) {
        series.vertices.insert(series.vertices.end(), {{size, 0, 0}, {size, size, 0}, {size, 0, size}});
        series.add(3 * i, 3 * i + 1, 3 * i + 2);
    }
    heap.vertices = {{1, 2, 3}, {2, 3, 4}, {3, 5, 4}};
    for (int i = 0; i < 900; ++i) heap.add(0, 1, 2);
    for (const test::Arrays& arrays : {series, heap}) {
        Vector<TrianglePacket> packets;
        Vector<Box> boxes;
        pack_triangles(arrays.view(), packets, boxes);
        REQUIRE(packets.size() <= 900 / 6);
    }
}

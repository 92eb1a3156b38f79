#include "scene/closest_features.h"

#include <algorithm>
#include <cfenv>
#include <memory>

#include "meshes.h"
#include "test.h"

using namespace gphys;

namespace {

using MeshHolder = std::unique_ptr<const Mesh, void (*)(const Mesh*)>;

constexpr int trapped = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;

/// A packet of eight triangles, and the kernels' view of it.
struct Packet {
    MeshHolder mesh;
    Box8 box{};

    explicit Packet(const test::Arrays& arrays) : mesh(arrays.make(), Mesh::release) {
        REQUIRE(mesh->packets().size() == 1);
        for (int i = 0; i < 8; ++i) box.set_lane(i, mesh->bvh().box(0));
    }
    const TrianglePacket& packet() const { return mesh->packets()[0]; }
};

test::Arrays few_triangles(test::Random& random, Vec3 centre, double size) {
    test::Arrays arrays;
    const uint32_t count = 1 + random.index(8);
    const auto vertex = [&] { return narrow(centre + random.direction() * random.uniform(0, size)); };
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t first = 3 * i;
        for (int k = 0; k < 3; ++k) arrays.vertices.push_back(vertex());
        if (random.index(4) == 0) {  // a sliver
            const Vec3 aside = random.direction() * (random.uniform(0, 1e-6) * size);
            arrays.vertices[first + 1] = narrow(widen(arrays.vertices[first]) + aside);
        }
        arrays.add(first, first + 1, random.index(8) == 0 ? first : first + 2);
    }
    return arrays;
}

/// The sum of the magnitudes of its corners' coordinates from a point, the largest.
double extent(const Mesh& mesh, Vec3 from) {
    double most = 0;
    for (const gphys_vec3& v : mesh.vertices()) {
        const Vec3 d = abs(widen(v) - from);
        most = std::max(most, d.x + d.y + d.z);
    }
    return most;
}

}  // namespace

TEST_CASE("distances of a packet's triangles are bounded from below, and closely, at any size and place") {
    test::Random random(1);
    for (const double size : {1e-36, 1e-20, 1e-6, 1.0, 1e6, 7e14}) {
        for (const double offset : {0.0, 1.0, 3e5}) {
            const Vec3 centre = Vec3{offset, -0.7 * offset, 0.3 * offset} * size;
            if (max_component(abs(centre)) + size > 9e14) continue;
            INFO("size " << size << ", offset " << offset);
            int near_count = 0, close_count = 0, lanes = 0, close_alone = 0;
            for (int i = 0; i < 1000; ++i) {
                const Packet of(few_triangles(random, centre, size));
                // From everywhere, above a face, and on it.
                const Triangle face = of.mesh->triangle(0);
                const Vec3 within = (face.a + face.b + face.c) / 3;
                const double away = size * (random.index(3) ? random.uniform(0, 1.5) : random.uniform(0, 1e-3));
                const Vec3 point = within + random.direction() * (random.index(8) ? away : 0);
                const double radius = size * random.uniform(0, 2);
                const NearProbe probe(point, radius);
                for (const Isa isa : test::isas()) {
                    const TrianglePacket* const packet = &of.packet();
                    NearPacket near;
                    std::feclearexcept(FE_ALL_EXCEPT);
                    const uint32_t found = near_kernels(isa).find(&of.box, &packet, 1, probe, &near);
                    const float of_box = near.distance[0];  // a packet's first triangle is always there
                    if (found == 1) near_kernels(isa).measure(near, probe);
                    REQUIRE(std::fetestexcept(trapped) == 0);
                    float distances[8];
                    const uint32_t within = near_kernels(isa).lanes_within(*packet, probe, distances);
                    REQUIRE(std::fetestexcept(trapped) == 0);
                    REQUIRE((within & ~packet->lanes()) == 0);
                    for (int lane = 0; lane < 8; ++lane) {
                        if (packet->index[lane] == TrianglePacket::none) {
                            REQUIRE((found == 0 || near.distance[lane] == infinity));
                            REQUIRE(distances[lane] == infinity);
                            continue;
                        }
                        const double distance = length(closest_point(packet->triangle(lane), point) - point);
                        REQUIRE(distances[lane] <= distance * (1 + 1e-12));
                        REQUIRE(((within >> lane & 1) != 0) == (distances[lane] <= probe.radius));
                        close_alone += distances[lane] >= distance - 4e-6 * extent(*of.mesh, point) - 1e-30;
                        ++lanes;
                        const bool kept = found == 1 && near.distance[lane] < infinity;
                        REQUIRE((kept || distance > radius));
                        if (!kept) continue;
                        ++near_count;
                        REQUIRE(near.distance[lane] <= distance * (1 + 1e-12));
                        REQUIRE(of_box <= near.distance[lane]);
                        // The tightest bound has an error of 2^-20 of the extent, twice.
                        close_count += near.distance[lane] >= distance - 4e-6 * extent(*of.mesh, point) - 1e-30;
                    }
                }
            }
            REQUIRE(near_count > 3000);
            REQUIRE(close_count > 0.95 * near_count);  // a thin one's normal is mostly rounding
            REQUIRE(close_alone > 0.95 * lanes);
        }
    }
}

TEST_CASE("the height of a half-space is between its two floats") {
    test::Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const double height = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-20, 15));
        const HalfSpaceProbe probe(random.direction(), height);
        REQUIRE(double{probe.lowest} <= height);
        REQUIRE(double{probe.highest} >= height);
    }
}

TEST_CASE("of a packet's triangles those behind a plane are left out, and no others") {
    test::Random random(2);
    for (const double size : {1e-20, 1.0, 7e14}) {
        int left_out = 0, open = 0, kept = 0;
        for (int i = 0; i < 2000; ++i) {
            const Packet of(few_triangles(random, {}, size));
            const Vec3 point = random.direction() * size, normal = random.direction();
            const NearProbe probe(point, 10 * size);
            // Through a corner or anywhere.
            const Triangle first = of.mesh->triangle(0);
            const double height = random.index(2) ? dot(normal, first.a - point) : random.uniform(-2, 2) * size;
            for (const Isa isa : test::isas()) {
                const NearKernels& kernels = near_kernels(isa);
                const TrianglePacket* const packet = &of.packet();
                NearPacket near;
                REQUIRE(kernels.find(&of.box, &packet, 1, probe, &near) == 1);
                uint32_t open_lanes = 0;
                std::feclearexcept(FE_ALL_EXCEPT);
                const uint32_t left = kernels.cull(&near, 1, probe, HalfSpaceProbe(normal, height), &open_lanes);
                REQUIRE(std::fetestexcept(trapped) == 0);
                const double margin = 4e-6 * extent(*of.mesh, point);
                for_each_lane(packet->lanes(), [&](int lane) {
                    const Triangle t = packet->triangle(lane);
                    const double top =
                        std::max({dot(normal, t.a - point), dot(normal, t.b - point), dot(normal, t.c - point)});
                    const bool is_open = (open_lanes >> lane & 1) != 0,
                               there = left == 1 && near.distance[lane] < infinity;
                    REQUIRE((there || top <= height));
                    REQUIRE((!is_open || there));
                    REQUIRE((!is_open || std::fabs(top - height) <= margin));
                    REQUIRE((is_open || there == (top > height)));
                    open += is_open;
                    left_out += !there;
                    kept += there && !is_open;
                    return true;
                });
            }
        }
        REQUIRE(left_out > 3000);
        REQUIRE(kept > 3000);
        REQUIRE(open > 300);
    }
}

namespace {

/// Two meshes and some primitives, turned and scaled, about the origin.
struct SomeModels {
    Scene scene{nullptr};
    std::vector<gphys_model_id> models;
    std::vector<MeshHolder> meshes;

    explicit SomeModels(test::Random& random) {
        for (const test::Arrays& arrays : {test::torus(40, 20), test::soup(500, 3), test::grid(6)}) {
            meshes.emplace_back(arrays.make(), Mesh::release);
            add(random, GPHYS_SHAPE_MESH, meshes.back().get());
        }
        const gphys_sphere sphere{{0.5f, 0, 0}, 0.3f};
        const gphys_aabb box{{-0.2f, -0.1f, 0.4f}, {0.5f, 0.3f, 0.9f}};
        add(random, GPHYS_SHAPE_SPHERE, &sphere);
        add(random, GPHYS_SHAPE_AABB, &box);
    }

private:
    void add(test::Random& random, gphys_shape_type type, const void* shape) {
        const gphys_transform world{random.point(0.5f), random.rotation(), random.uniform_float(0.5f, 2)};
        gphys_model_desc desc;
        gphys_model_desc_init(&desc, sizeof desc);
        gphys_model_id id;
        REQUIRE(scene.add(type, shape, 0, &world, 0, 1, desc, &id) == GPHYS_OK);
        models.push_back(id);
    }
};

struct BehindPlane {
    Vec3 normal;
    double height;
    uint32_t tag;

    bool has_behind(const ClosestFeature& part) const {
        const Triangle& t = part.triangle;
        return part.is_triangle && part.tag == tag && dot(normal, t.a) <= height && dot(normal, t.b) <= height &&
               dot(normal, t.c) <= height;
    }
};

bool same(const ClosestFeature& a, const ClosestFeature& b) {
    return a.model == b.model && a.tag == b.tag && a.closest == b.closest && a.normal == b.normal &&
           a.distance == b.distance && a.is_triangle == b.is_triangle && a.triangle.a == b.triangle.a &&
           a.triangle.b == b.triangle.b && a.triangle.c == b.triangle.c;
}

/// All parts that touch a ball, by asking each.
std::vector<ClosestFeature> parts_one_by_one(const SomeModels& some, const std::vector<uint32_t>& tags,
                                             const Sphere& ball) {
    std::vector<ClosestFeature> all;
    for (size_t i = 0; i < some.models.size(); ++i) {
        const gphys_model_id model = some.models[i];
        ClosestFeature part{model, tags[i], {}, {}, 0, false, {}};
        const Mesh* const mesh = some.scene.mesh(model);
        for (uint32_t t = 0; t < (mesh ? mesh->triangle_count() : 1); ++t) {
            if (mesh) {
                part.is_triangle = true;
                part.triangle = transformed(mesh->triangle(t), widen(some.scene.world(model)));
                closest_point_triangle(part.triangle, ball.center, part.closest, part.normal, part.distance);
            } else {
                some.scene.closest_point_model(model, ball.center, part.closest, part.normal, part.distance);
            }
            if (part.distance <= ball.radius) all.push_back(part);
        }
    }
    return all;
}

}  // namespace

TEST_CASE("parts around points of a scene come nearest first, without those behind planes, as one by one") {
    test::Random random(3);
    size_t part_count = 0, behind_count = 0;
    auto parts = std::make_unique<ClosestFeatures>();
    for (int round = 0; round < 500; ++round) {
        const SomeModels some(random);
        std::vector<uint32_t> tags;
        const Vec3 middle = random.direction() * random.uniform(0, 1.5);
        Sphere balls[ClosestFeatures::most_points];
        const uint32_t count = 1 + random.index(ClosestFeatures::most_points);
        for (Sphere& ball : balls) ball = {middle + random.direction() * 0.1, random.uniform(0, 0.3)};
        parts->clear(count);
        for (const gphys_model_id model : some.models) {
            tags.push_back(random.index(2));
            REQUIRE(parts->add(some.scene, model, tags.back(), balls));
        }
        for (uint32_t i = 0; i < count; ++i) {
            if (random.index(2)) balls[i].radius *= random.uniform(0, 1);
            std::vector<ClosestFeature> expected = parts_one_by_one(some, tags, balls[i]);
            part_count += expected.size();
            double last = -infinity;
            const auto takes = [&](const ClosestFeature& part) {
                const auto at = std::find_if(expected.begin(), expected.end(),
                                             [&](const ClosestFeature& other) { return same(other, part); });
                REQUIRE(at != expected.end());
                REQUIRE(part.distance >= last);
                last = part.distance;
                expected.erase(at);
            };
            REQUIRE(parts->select_point(i) >= expected.size());
            ClosestFeature part;
            for (uint32_t k = random.index(3); k > 0 && parts->pop_nearest(part); --k) {
                takes(part);
                // Across the way to it or anyhow.
                const Vec3 normal = random.index(4) ? part.normal : random.direction();
                const BehindPlane plane{normal, dot(normal, part.closest) + 1e-6, random.index(2)};
                parts->cull_behind(plane.normal, plane.height, plane.tag);
                const auto behind = std::remove_if(expected.begin(), expected.end(), [&](const ClosestFeature& other) {
                    return plane.has_behind(other);
                });
                behind_count += static_cast<size_t>(expected.end() - behind);
                expected.erase(behind, expected.end());
            }
            double bound = infinity;
            parts->for_each_remaining([&](uint32_t, double distance) { bound = std::min(bound, distance); });
            const size_t left = expected.size();
            while (parts->pop_nearest(part)) {
                if (expected.size() == left) REQUIRE(bound <= part.distance);
                takes(part);
            }
            REQUIRE(expected.empty());
        }
    }
    REQUIRE(part_count > 5000);
    REQUIRE(behind_count > 1000);
}

TEST_CASE("parts are told to be too many, and none is missing unless") {
    test::Random random(4);
    const MeshHolder mesh(test::sphere(6).make(), Mesh::release);  // 32 768 triangles
    Scene scene{nullptr};
    gphys_model_desc desc;
    gphys_model_desc_init(&desc, sizeof desc);
    gphys_model_id id;
    REQUIRE(scene.add(GPHYS_SHAPE_MESH, mesh.get(), 0, nullptr, 0, 1, desc, &id) == GPHYS_OK);
    auto parts = std::make_unique<ClosestFeatures>();
    int complete_count = 0, incomplete_count = 0;
    for (int i = 0; i < 200; ++i) {
        const Sphere ball{random.direction(), random.uniform(0, 0.5)};
        parts->clear(1);
        const bool complete = parts->add(scene, id, 0, &ball);
        ++(complete ? complete_count : incomplete_count);
        size_t expected = 0, found = 0;
        mesh->for_each_overlap(ball, [&](uint32_t) { return ++expected, true; });
        parts->select_point(0);
        for (ClosestFeature part; parts->pop_nearest(part);) ++found;
        REQUIRE(found <= expected);
        if (complete) REQUIRE(found == expected);
        if (expected > 8 * 128) REQUIRE(!complete);
    }
    REQUIRE(complete_count > 20);
    REQUIRE(incomplete_count > 20);
}

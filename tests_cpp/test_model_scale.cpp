// Scales per axis of models, through the public interface: answers are those of a scene whose shapes were given scaled.
// Vertices and scales have so few digits that their products are floats.
#include <array>
#include <memory>

#include "meshes.h"
#include "scene/model_scale.h"
#include "test.h"

using namespace gphys;

namespace {

struct MeshDeleter {
    void operator()(gphys_mesh* mesh) const { gphys_mesh_destroy(mesh); }
};
using MeshOwner = std::unique_ptr<gphys_mesh, MeshDeleter>;

enum class Kind { surface, hull };

MeshOwner make(Kind kind, const test::Arrays& arrays, bool deformable = false) {
    gphys_mesh* mesh = nullptr;
    const float* vertices = &arrays.vertices[0].x;
    const auto count = static_cast<uint32_t>(arrays.vertices.size());
    gphys_mesh_desc desc;
    REQUIRE(gphys_mesh_desc_init(&desc, sizeof desc) == GPHYS_OK);
    desc.deformable = deformable;
    if (kind == Kind::hull) {
        REQUIRE(gphys_mesh_create_hull(&desc, vertices, sizeof(gphys_vec3), count, &mesh) == GPHYS_OK);
    } else {
        REQUIRE(gphys_mesh_create(&desc, vertices, sizeof(gphys_vec3), count, arrays.indices.data(),
                                  static_cast<uint32_t>(arrays.indices.size()), &mesh) == GPHYS_OK);
    }
    return MeshOwner(mesh);
}

test::Arrays scaled_arrays(const test::Arrays& arrays, const gphys_vec3& scale) {
    test::Arrays result = arrays;
    for (gphys_vec3& v : result.vertices) v = {v.x * scale.x, v.y * scale.y, v.z * scale.z};
    return result;
}

/// Two scenes of the same models: scaled by the library, and given scaled.
class TwoScenes {
public:
    explicit TwoScenes(uint64_t seed) : random(seed) {
        REQUIRE(gphys_scene_create(nullptr, &by_scale) == GPHYS_OK);
        REQUIRE(gphys_scene_create(nullptr, &given) == GPHYS_OK);
    }
    ~TwoScenes() {
        gphys_scene_destroy(by_scale);
        gphys_scene_destroy(given);
    }
    TwoScenes(const TwoScenes&) = delete;
    TwoScenes& operator=(const TwoScenes&) = delete;

    gphys_vec3 few_digits(uint32_t most) {
        const auto one = [&] { return static_cast<float>(1 + random.index(most)) / 8; };
        return {one(), one(), one()};
    }
    gphys_transform transform() {
        gphys_transform t{random.point(12), random.rotation(), 1};
        if (random.index(2) == 0) t.scale = random.uniform_float(0.3f, 2);
        return t;
    }
    void add(Kind kind, const test::Arrays& arrays, const gphys_vec3& scale, const gphys_transform& place) {
        const MeshOwner mesh = make(kind, arrays), other = make(kind, scaled_arrays(arrays, scale));
        put(by_scale, GPHYS_SHAPE_MESH, mesh.get(), place, scale);
        put(given, GPHYS_SHAPE_MESH, other.get(), place, no_scale);
    }
    template <class Shape>
    void add(gphys_shape_type type, const Shape& shape, const gphys_vec3& scale, const gphys_transform& place) {
        const Shape other = scaled(shape, scale);
        put(by_scale, type, &shape, place, scale);
        put(given, type, &other, place, no_scale);
    }
    test::Arrays lump(Kind kind) {
        test::Arrays arrays = kind == Kind::hull ? test::Arrays() : test::sphere(2);
        if (kind == Kind::hull) arrays.vertices.resize(24);
        for (gphys_vec3& v : arrays.vertices) {
            const gphys_vec3 p = kind == Kind::hull ? narrow(random.direction()) : v;
            v = {std::round(p.x * 64) / 32, std::round(p.y * 64) / 32, std::round(p.z * 64) / 32};
        }
        return arrays;
    }
    void fill(uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            const Kind kind = i % 2 == 0 ? Kind::surface : Kind::hull;
            add(kind, lump(kind), few_digits(24), transform());
        }
        add(GPHYS_SHAPE_AABB, gphys_aabb{{-1, -1, -1}, {1, 2, 1}}, few_digits(24), transform());
        add(GPHYS_SHAPE_OBB, gphys_obb{{1, 0, 0}, {1, 2, 1}, {0, 0, 0, 1}}, few_digits(24), transform());
        add(GPHYS_SHAPE_TRIANGLE, gphys_triangle{{0, 0, 0}, {2, 0, 0}, {0, 2, 1}}, few_digits(24), transform());
        add(GPHYS_SHAPE_SPHERE, gphys_sphere{{1, 0, 0}, 1}, {1.5f, 1.5f, 1.5f}, transform());
        add(GPHYS_SHAPE_CAPSULE, gphys_capsule{{1, 0, 0}, {0, 1, 0}, 0.5f}, {2.5f, 2.5f, 2.5f}, transform());
        REQUIRE(gphys_scene_validate(by_scale) == GPHYS_OK);
    }
    void put(gphys_scene* scene, gphys_shape_type type, const void* shape, const gphys_transform& place,
             const gphys_vec3& scale) {
        gphys_model_desc desc;
        REQUIRE(gphys_model_desc_init(&desc, sizeof desc) == GPHYS_OK);
        desc.scale = scale;
        gphys_model_id model;
        REQUIRE(gphys_scene_add(scene, type, shape, &place, &desc, &model) == GPHYS_OK);
    }

    gphys_scene *by_scale = nullptr, *given = nullptr;
    test::Random random;
};

bool close(float a, float b, double size = 0) {
    return a == b || std::fabs(double{a} - double{b}) <= 0x1p-22 * (std::fabs(double{a}) + std::fabs(double{b}) + size);
}
bool close(const gphys_vec3& a, const gphys_vec3& b, double size) {
    return close(a.x, b.x, size) && close(a.y, b.y, size) && close(a.z, b.z, size);
}
void same(const gphys_hit& hit, const gphys_hit& expected, double size = 30) {
    CAPTURE(hit.model, hit.triangle, hit.t, expected.t);
    REQUIRE(hit.model == expected.model);
    REQUIRE(close(hit.t, expected.t, 0x1p-6));
    REQUIRE(close(hit.point, expected.point, size));
    REQUIRE(close(hit.normal, expected.normal, 1));
    REQUIRE(hit.flags == expected.flags);
}

gphys_ray ray_of(test::Random& random) {
    return {random.point(20), narrow(random.direction() * random.uniform(0.5, 2)),
            random.index(2) == 0 ? INFINITY : random.uniform_float(0, 40)};
}

}  // namespace

TEST_CASE("rays meet scaled models as those given scaled, one by one and in batches") {
    TwoScenes scenes(711);
    scenes.fill(24);
    uint32_t met = 0;
    for (int round = 0; round < 60; ++round) {
        constexpr uint32_t count = 130;
        std::vector<gphys_ray> rays(count);
        const gphys_vec3 eye = scenes.random.point(20);
        for (gphys_ray& ray : rays) {
            ray = ray_of(scenes.random);
            if (round % 3 == 0) {  // a packet
                ray.origin = eye;
                const Vec3 to = normalized(-widen(eye)) + scenes.random.direction() * 0.2;
                ray.direction = narrow(to);
            }
        }
        std::vector<gphys_hit> hits(count), expected(count);
        std::vector<gphys_distance> distances(count);
        std::vector<int32_t> any(count);
        REQUIRE(gphys_scene_raycast_batch(scenes.by_scale, rays.data(), sizeof rays[0], count, 1, hits.data(),
                                          sizeof hits[0]) == GPHYS_OK);
        REQUIRE(gphys_scene_raycast_batch(scenes.given, rays.data(), sizeof rays[0], count, 1, expected.data(),
                                          sizeof hits[0]) == GPHYS_OK);
        REQUIRE(gphys_scene_raycast_distance_batch(scenes.by_scale, rays.data(), sizeof rays[0], count, 1,
                                                   distances.data(), sizeof distances[0]) == GPHYS_OK);
        REQUIRE(gphys_scene_raycast_any_batch(scenes.by_scale, rays.data(), sizeof rays[0], count, 1, any.data(), 4) ==
                GPHYS_OK);
        for (uint32_t i = 0; i < count; ++i) {
            CAPTURE(i);
            const bool is_hit = expected[i].model != 0;
            met += is_hit;
            REQUIRE((hits[i].model != 0) == is_hit);
            REQUIRE((any[i] != 0) == is_hit);
            if (is_hit) same(hits[i], expected[i]);
            gphys_hit single{};
            REQUIRE((gphys_scene_raycast(scenes.by_scale, &rays[i], 1, &single) == GPHYS_OK) == is_hit);
            if (is_hit) {
                REQUIRE(std::memcmp(&single, &hits[i], sizeof single) == 0);
                REQUIRE(distances[i].t == hits[i].t);
                REQUIRE(distances[i].model == hits[i].model);
                REQUIRE(distances[i].triangle == hits[i].triangle);
            }
            int32_t alone = 0;
            REQUIRE(gphys_scene_raycast_any(scenes.by_scale, &rays[i], 1, &alone) == GPHYS_OK);
            REQUIRE(alone == any[i]);
            gphys_hit all[64], all_expected[64];
            uint32_t total = 0, total_expected = 0;
            REQUIRE(gphys_scene_raycast_all(scenes.by_scale, &rays[i], 1, all, 64, &total) == GPHYS_OK);
            REQUIRE(gphys_scene_raycast_all(scenes.given, &rays[i], 1, all_expected, 64, &total_expected) == GPHYS_OK);
            REQUIRE(total == total_expected);
            for (uint32_t k = 0; k < total; ++k) same(all[k], all_expected[k]);
        }
    }
    CHECK(met > 2000);
}

TEST_CASE("overlaps, nearest points, sweeps and penetrations of scaled models are those of models given scaled") {
    TwoScenes scenes(712);
    scenes.fill(24);
    test::Random& random = scenes.random;
    uint32_t overlapped = 0, found = 0, swept = 0, pushed = 0;
    for (int i = 0; i < 6000; ++i) {
        const gphys_sphere sphere{random.point(14), random.uniform_float(0, 2)};
        const gphys_capsule capsule{random.point(14), random.point(14), random.uniform_float(0, 1)};
        const gphys_aabb box{sphere.center, {sphere.center.x + 1, sphere.center.y + 2, sphere.center.z + 0.5f}};
        const gphys_obb obb{random.point(14), {1, 0.2f, 2}, random.rotation()};
        const gphys_triangle triangle{random.point(14), random.point(14), random.point(14)};
        const gphys_plane plane{narrow(random.direction()), random.uniform_float(-14, 14)};
        gphys_frustum frustum{random.point(20), {}};
        for (int p = 0; p < 6; ++p) {
            const Vec3 axis{p / 2 == 0 ? 1.0 : 0.1, p / 2 == 1 ? 1.0 : 0.2, p / 2 == 2 ? 1.0 : 0.1};
            const bool back = p % 2 != 0;
            frustum.planes[p] = {narrow(back ? -axis : axis), back ? -8.0f : 1.0f};
        }
        const struct {
            gphys_shape_type type;
            const void* shape;
        } queries[] = {{GPHYS_SHAPE_SPHERE, &sphere},  {GPHYS_SHAPE_CAPSULE, &capsule},   {GPHYS_SHAPE_AABB, &box},
                       {GPHYS_SHAPE_OBB, &obb},        {GPHYS_SHAPE_TRIANGLE, &triangle}, {GPHYS_SHAPE_PLANE, &plane},
                       {GPHYS_SHAPE_FRUSTUM, &frustum}};
        for (const auto& query : queries) {
            CAPTURE(i, query.type);
            gphys_model_id models[64], expected[64];
            uint32_t total = 0, expected_total = 0;
            REQUIRE(gphys_scene_overlap(scenes.by_scale, query.type, query.shape, 1, models, 64, &total) == GPHYS_OK);
            REQUIRE(gphys_scene_overlap(scenes.given, query.type, query.shape, 1, expected, 64, &expected_total) ==
                    GPHYS_OK);
            REQUIRE(total == expected_total);
            REQUIRE(std::equal(models, models + total, expected));
            overlapped += total;
        }
        const float reach = random.index(2) == 0 ? INFINITY : random.uniform_float(0, 5);
        gphys_nearest near{}, near_expected{};
        const gphys_status status = gphys_scene_nearest(scenes.by_scale, &sphere.center, reach, 1, &near);
        REQUIRE(status == gphys_scene_nearest(scenes.given, &sphere.center, reach, 1, &near_expected));
        if (status == GPHYS_OK) {
            ++found;
            REQUIRE(near.model == near_expected.model);
            REQUIRE(close(near.distance, near_expected.distance, 0x1p-6));
            REQUIRE(close(near.point, near_expected.point, 30));
        }
        const gphys_vec3 way = random.point(10);
        for (int k = 0; k < 4; ++k) {
            CAPTURE(i, k);
            gphys_hit hit{}, expected{};
            const gphys_status moved =
                gphys_scene_sweep(scenes.by_scale, queries[k].type, queries[k].shape, &way, 1, &hit);
            REQUIRE(moved == gphys_scene_sweep(scenes.given, queries[k].type, queries[k].shape, &way, 1, &expected));
            if (moved == GPHYS_OK) {
                ++swept;
                REQUIRE(hit.model == expected.model);
                REQUIRE(close(hit.t, expected.t, 0x1p-10));
                REQUIRE(hit.flags == expected.flags);
            }
            gphys_penetration ways[256], ways_expected[256];
            uint32_t total = 0, expected_total = 0;
            REQUIRE(gphys_scene_penetration(scenes.by_scale, queries[k].type, queries[k].shape, 1, ways, 256, &total) >=
                    0);
            REQUIRE(gphys_scene_penetration(scenes.given, queries[k].type, queries[k].shape, 1, ways_expected, 256,
                                            &expected_total) >= 0);
            REQUIRE(total == expected_total);
            for (uint32_t w = 0; w < std::min(total, 256u); ++w) {
                REQUIRE(close(ways[w].depth, ways_expected[w].depth, 0x1p-6));
            }
            pushed += total;
        }
    }
    CHECK(overlapped > 5000);
    CHECK(found > 3000);
    CHECK(swept > 3000);
    CHECK(pushed > 1000);
}

TEST_CASE("scales of a millionth beside a million leave the answers as they are") {
    TwoScenes scenes(713);
    constexpr float tiny = 0x1p-20f, huge = 0x1p20f;
    const gphys_vec3 scales[] = {{tiny, 1, 1}, {1, huge, 1}, {tiny, huge, 1}, {1, 1, tiny}, {huge, tiny, 1}};
    for (const gphys_vec3& scale : scales) {
        for (Kind kind : {Kind::surface, Kind::hull}) {
            TwoScenes pair(714);
            const gphys_transform place = pair.transform();
            pair.add(kind, pair.lump(kind), scale, place);
            const Transform wide = widen(place);
            uint32_t met = 0;
            for (int i = 0; i < 2000; ++i) {
                // From beside the model to a point within.
                const auto within = [&](double part) {
                    return wide.apply(by_component(pair.random.direction() * part, widen(scale)));
                };
                const Vec3 from = within(3), to = within(0.8);
                const gphys_ray ray{narrow(from), narrow(to - from), INFINITY};
                if (ray.direction.x == 0 && ray.direction.y == 0 && ray.direction.z == 0) continue;
                gphys_hit hit{}, expected{};
                const gphys_status status = gphys_scene_raycast(pair.by_scale, &ray, 1, &hit);
                REQUIRE(status == gphys_scene_raycast(pair.given, &ray, 1, &expected));
                if (status == GPHYS_OK) {
                    ++met;
                    REQUIRE(hit.model == expected.model);
                    REQUIRE(close(hit.t, expected.t));
                    REQUIRE(close(hit.normal, expected.normal, 1));
                }
                gphys_nearest near{}, near_expected{};
                REQUIRE(gphys_scene_nearest(pair.by_scale, &ray.origin, INFINITY, 1, &near) == GPHYS_OK);
                REQUIRE(gphys_scene_nearest(pair.given, &ray.origin, INFINITY, 1, &near_expected) == GPHYS_OK);
                REQUIRE(close(near.distance, near_expected.distance, length(from) * 0x1p-20));
                gphys_hit swept{}, swept_expected{};
                const gphys_sphere ball{ray.origin, 0.25f};
                const gphys_status moved = gphys_scene_sweep_sphere(pair.by_scale, &ball, &ray.direction, 1, &swept);
                REQUIRE(moved == gphys_scene_sweep_sphere(pair.given, &ball, &ray.direction, 1, &swept_expected));
                if (moved == GPHYS_OK) REQUIRE(close(swept.t, swept_expected.t, 0x1p-10));
            }
            CAPTURE(scale.x, scale.y, scale.z);
            CHECK(met > 100);
        }
    }
}

TEST_CASE("a deformable mesh with a scale takes new vertices, and refuses those beyond the range") {
    test::Arrays arrays = test::sphere(1);
    const MeshOwner mesh = make(Kind::surface, arrays, true);
    TwoScenes scenes(715);
    const gphys_vec3 scale{4, 0.5f, 2};
    const gphys_transform place = scenes.transform();
    scenes.put(scenes.by_scale, GPHYS_SHAPE_MESH, mesh.get(), place, scale);
    for (gphys_vec3& v : arrays.vertices) v = {v.x * 2, v.y + 1, v.z};
    const auto count = static_cast<uint32_t>(arrays.vertices.size());
    REQUIRE(gphys_mesh_set_vertices(mesh.get(), &arrays.vertices[0].x, sizeof(gphys_vec3), count) == GPHYS_OK);
    const MeshOwner other = make(Kind::surface, scaled_arrays(arrays, scale));
    scenes.put(scenes.given, GPHYS_SHAPE_MESH, other.get(), place, no_scale);
    std::array<gphys_ray, 64> rays;
    std::array<gphys_hit, 64> hits, expected;
    for (int round = 0; round < 20; ++round) {
        for (gphys_ray& ray : rays) {
            ray = ray_of(scenes.random);
            ray.direction = narrow(widen(place.position) + scenes.random.direction() * 6 - widen(ray.origin));
        }
        REQUIRE(gphys_scene_raycast_batch(scenes.by_scale, rays.data(), sizeof rays[0], 64, 1, hits.data(),
                                          sizeof hits[0]) == GPHYS_OK);
        REQUIRE(gphys_scene_raycast_batch(scenes.given, rays.data(), sizeof rays[0], 64, 1, expected.data(),
                                          sizeof hits[0]) == GPHYS_OK);
        for (int i = 0; i < 64; ++i) {
            if (expected[i].model != 0) same(hits[i], expected[i]);
            REQUIRE(hits[i].model == expected[i].model);
        }
    }
    arrays.vertices[0].x = 5e14f;
    REQUIRE(gphys_mesh_set_vertices(mesh.get(), &arrays.vertices[0].x, sizeof(gphys_vec3), count) ==
            GPHYS_ERROR_INVALID_ARGUMENT);
    REQUIRE(gphys_scene_validate(scenes.by_scale) == GPHYS_OK);
}

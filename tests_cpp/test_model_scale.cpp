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

/// One shape of each kind that a scene is asked with; the first four are solids.
struct QueryShapes {
    gphys_sphere sphere;
    gphys_capsule capsule;
    gphys_aabb box;
    gphys_obb obb;
    gphys_triangle triangle;
    gphys_plane plane;
    gphys_frustum frustum;

    explicit QueryShapes(test::Random& random)
        : sphere{random.point(14), random.index(4) == 0 ? 0 : random.uniform_float(0, 2)},
          capsule{sphere.center, random.point(14), random.index(4) == 0 ? 0 : random.uniform_float(0, 1)},
          box{sphere.center, {sphere.center.x + 1, sphere.center.y + 2, sphere.center.z + 0.5f}},
          obb{sphere.center, {1, 0.2f, 2}, random.rotation()},
          triangle{sphere.center, random.point(14), random.point(14)},
          plane{narrow(random.direction()), random.uniform_float(-14, 14)},
          frustum{random.point(20), {}} {
        for (int p = 0; p < 6; ++p) {
            const Vec3 axis{p / 2 == 0 ? 1.0 : 0.1, p / 2 == 1 ? 1.0 : 0.2, p / 2 == 2 ? 1.0 : 0.1};
            const bool back = p % 2 != 0;
            frustum.planes[p] = {narrow(back ? -axis : axis), back ? -8.0f : 1.0f};
        }
    }

    struct Query {
        gphys_shape_type type;
        const void* shape;
    };
    std::array<Query, 7> all() const {
        return {{{GPHYS_SHAPE_SPHERE, &sphere},
                 {GPHYS_SHAPE_CAPSULE, &capsule},
                 {GPHYS_SHAPE_AABB, &box},
                 {GPHYS_SHAPE_OBB, &obb},
                 {GPHYS_SHAPE_TRIANGLE, &triangle},
                 {GPHYS_SHAPE_PLANE, &plane},
                 {GPHYS_SHAPE_FRUSTUM, &frustum}}};
    }
};

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
        desc.parent = parent;
        desc.layers = 1u << layer;
        gphys_model_id model;
        REQUIRE(gphys_scene_add(scene, type, shape, &place, &desc, &model) == GPHYS_OK);
    }
    /// Models whose scales are powers of two, below turned parents, in two layers.
    void fill_by_powers(uint32_t count) {
        const gphys_sphere hub{{0, 0, 0}, 0.25f};
        for (uint32_t i = 0; i < count; ++i) {
            const auto power = [&] { return std::ldexp(1.0f, static_cast<int>(random.index(9)) - 6); };
            const gphys_vec3 scale{power(), power(), power()};
            parent = 0;
            layer = i % 2;
            add(GPHYS_SHAPE_SPHERE, hub, no_scale, transform());
            parent = last_model();
            // Within 6 of the hub, whatever the scale.
            const auto near_origin = [&] {
                const gphys_vec3 p = random.point(3);
                return gphys_vec3{p.x / scale.x, p.y / scale.y, p.z / scale.z};
            };
            const gphys_transform place{random.point(2), random.rotation(), random.uniform_float(0.5f, 1.5f)};
            if (i % 5 == 0) {
                gphys_aabb box{near_origin(), {}};
                const gphys_vec3 size{2 / scale.x, 1 / scale.y, 3 / scale.z};
                box.max = {box.min.x + size.x, box.min.y + size.y, box.min.z + size.z};
                add(GPHYS_SHAPE_AABB, box, scale, place);
            } else if (i % 5 == 1) {
                add(GPHYS_SHAPE_OBB, gphys_obb{near_origin(), {1 / scale.x, 2 / scale.y, 1 / scale.z}, {0, 0, 0, 1}},
                    scale, place);
            } else if (i % 5 == 2) {
                add(GPHYS_SHAPE_TRIANGLE, gphys_triangle{near_origin(), near_origin(), near_origin()}, scale, place);
            } else {
                const Kind kind = i % 5 == 3 ? Kind::surface : Kind::hull;
                test::Arrays arrays;
                arrays.vertices.resize(30);
                for (gphys_vec3& v : arrays.vertices) v = near_origin();
                for (uint32_t k = 0; kind == Kind::surface && k < 60; ++k) arrays.indices.push_back(random.index(30));
                add(kind, arrays, scale, place);
            }
        }
        parent = layer = 0;
        REQUIRE(gphys_scene_validate(by_scale) == GPHYS_OK);
    }
    /// Both scenes have given the same ids.
    gphys_model_id last_model() const {
        std::vector<gphys_model_id> ids(1000);
        uint32_t total = 0;
        REQUIRE(gphys_scene_get_models(given, ids.data(), 1000, &total) == GPHYS_OK);
        return ids[total - 1];
    }

    gphys_scene *by_scale = nullptr, *given = nullptr;
    gphys_model_id parent = 0;
    uint32_t layer = 0;
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
    for (int i = 0; i < test::tries(6000); ++i) {
        const QueryShapes shapes(random);
        const auto queries = shapes.all();
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
        const gphys_status status = gphys_scene_nearest(scenes.by_scale, &shapes.sphere.center, reach, 1, &near);
        REQUIRE(status == gphys_scene_nearest(scenes.given, &shapes.sphere.center, reach, 1, &near_expected));
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
    CHECK(overlapped > test::tries(5000));
    CHECK(found > test::tries(3000));
    CHECK(swept > test::tries(3000));
    CHECK(pushed > test::tries(1000));
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

namespace {

template <class Struct>
bool same_bits(const Struct& a, const Struct& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}
/// Within an ulp: both are of the exact time.
bool same_time(float a, float b) { return std::nextafterf(a, b) == b; }

/// A few models, or a layer, to be left out.
gphys_query_filter_desc filter_of(test::Random& random, const std::vector<gphys_model_id>& ids) {
    gphys_query_filter_desc filter;
    REQUIRE(gphys_query_filter_desc_init(&filter, sizeof filter) == GPHYS_OK);
    if (random.index(3) == 0) filter.layers = 1u << random.index(2);
    filter.ignored_models = ids.data() + random.index(static_cast<uint32_t>(ids.size() - 4));
    filter.ignored_count = random.index(5);
    return filter;
}

}  // namespace

TEST_CASE("models scaled by powers of two, filtered, answer with the bits of those given scaled; rays within an ulp") {
    TwoScenes scenes(716);
    scenes.fill_by_powers(40);
    test::Random& random = scenes.random;
    std::vector<gphys_model_id> ids(80);
    uint32_t total = 0, met = 0, listed = 0, swept = 0, pushed = 0, found = 0, in_view = 0;
    REQUIRE(gphys_scene_get_models(scenes.by_scale, ids.data(), 80, &total) == GPHYS_OK);
    REQUIRE(total == 80);
    // A restored copy stands in for the scaled scene half of the time.
    REQUIRE(gphys_scene_get_snapshot(scenes.by_scale, 1, nullptr, 0, &total) == GPHYS_INCOMPLETE);
    std::vector<uint32_t> words(total);
    REQUIRE(gphys_scene_get_snapshot(scenes.by_scale, 1, words.data(), total, &total) == GPHYS_OK);
    gphys_scene* restored = nullptr;
    REQUIRE(gphys_scene_create(nullptr, &restored) == GPHYS_OK);
    REQUIRE(gphys_scene_restore(restored, nullptr, words.data(), total) == GPHYS_OK);
    gphys_camera* camera = nullptr;
    REQUIRE(gphys_camera_create(nullptr, &camera) == GPHYS_OK);
    REQUIRE(gphys_camera_set_viewport(camera, 800, 600) == GPHYS_OK);
    for (int i = 0; i < 4000; ++i) {
        CAPTURE(i);
        const gphys_scene* const scaled = i % 2 == 0 ? scenes.by_scale : restored;
        const gphys_query_filter_desc filter = filter_of(random, ids);
        const QueryShapes shapes(random);
        const auto queries = shapes.all();
        const gphys_vec3 at = shapes.sphere.center, way = random.point(10);
        gphys_model_id models[80], expected[80];
        uint32_t count = 0, expected_count = 0;
        for (const auto& [type, shape] : queries) {
            CAPTURE(type);
            REQUIRE(gphys_scene_overlap_filtered(scaled, type, shape, &filter, models, 80, &count) == GPHYS_OK);
            REQUIRE(gphys_scene_overlap_filtered(scenes.given, type, shape, &filter, expected, 80, &expected_count) ==
                    GPHYS_OK);
            REQUIRE(count == expected_count);
            REQUIRE(std::equal(models, models + count, expected));
            listed += count;
        }
        // What is in view is culled by neither.
        REQUIRE(gphys_scene_cull_filtered(scaled, &shapes.frustum, &filter, models, 80, &count) == GPHYS_OK);
        REQUIRE(std::includes(models, models + count, expected, expected + expected_count));
        for (int k = 0; k < 4; ++k) {
            const auto& [type, shape] = queries[k];
            CAPTURE(type);
            gphys_hit hit{}, other{};
            const gphys_status moved = gphys_scene_sweep_filtered(scaled, type, shape, &way, &filter, &hit);
            REQUIRE(moved == gphys_scene_sweep_filtered(scenes.given, type, shape, &way, &filter, &other));
            REQUIRE(same_bits(hit, other));
            swept += moved == GPHYS_OK;
            gphys_penetration ways[400], other_ways[400];
            REQUIRE(gphys_scene_penetration_filtered(scaled, type, shape, &filter, ways, 400, &count) >= 0);
            REQUIRE(gphys_scene_penetration_filtered(scenes.given, type, shape, &filter, other_ways, 400,
                                                     &expected_count) >= 0);
            REQUIRE(count == expected_count);
            REQUIRE(count <= 400);
            REQUIRE(std::equal(ways, ways + count, other_ways, same_bits<gphys_penetration>));
            pushed += count;
        }
        gphys_nearest near{}, other_near{};
        const float reach = random.index(2) == 0 ? INFINITY : random.uniform_float(0, 3);
        const gphys_status is_near = gphys_scene_nearest_filtered(scaled, &at, reach, &filter, &near);
        REQUIRE(is_near == gphys_scene_nearest_filtered(scenes.given, &at, reach, &filter, &other_near));
        REQUIRE(same_bits(near, other_near));
        found += is_near == GPHYS_OK;
        gphys_ray ray = ray_of(random);
        ray.direction = narrow(widen(random.point(8)) - widen(ray.origin));
        gphys_hit all[300], other_all[300];
        REQUIRE(gphys_scene_raycast_all_filtered(scaled, &ray, &filter, all, 300, &count) == GPHYS_OK);
        REQUIRE(gphys_scene_raycast_all_filtered(scenes.given, &ray, &filter, other_all, 300, &expected_count) ==
                GPHYS_OK);
        REQUIRE(count == expected_count);
        for (uint32_t k = 0; k < count; ++k) {
            REQUIRE(all[k].model == other_all[k].model);
            REQUIRE(all[k].triangle == other_all[k].triangle);
            REQUIRE(same_time(all[k].t, other_all[k].t));
        }
        met += count;
        gphys_hit hit{}, other{};
        const gphys_segment segment{at, random.point(14)};
        const gphys_status crossed = gphys_scene_segment_test_filtered(scaled, &segment, &filter, &hit);
        REQUIRE(crossed == gphys_scene_segment_test_filtered(scenes.given, &segment, &filter, &other));
        REQUIRE(hit.model == other.model);
        REQUIRE(same_time(hit.t, other.t));
        hit = other = {};
        const gphys_quat turned = random.rotation();
        REQUIRE(gphys_camera_set_transform(camera, &at, &turned) == GPHYS_OK);
        const float x = random.uniform_float(0, 800), y = random.uniform_float(0, 600);
        const gphys_status picked = gphys_camera_pick_filtered(camera, scaled, x, y, &filter, &hit);
        REQUIRE(picked == gphys_camera_pick_filtered(camera, scenes.given, x, y, &filter, &other));
        REQUIRE(hit.model == other.model);
        REQUIRE(same_time(hit.t, other.t));
        in_view += picked == GPHYS_OK;
    }
    CAPTURE(in_view, met, listed, swept, pushed, found);
    CHECK(in_view > 200);
    CHECK(met > 2000);
    CHECK(listed > 20000);
    CHECK(swept > 4000);
    CHECK(pushed > 2000);
    CHECK(found > 2000);
    gphys_camera_destroy(camera);
    gphys_scene_destroy(restored);
}

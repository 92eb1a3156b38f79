// Queries with a filter against the plain ones: what is left out by a filter is, for the plain query, on no layer. The
// lists of plain queries without the ignored models are the second witness.
#include <algorithm>
#include <set>

#include "scene_reference.h"

using test::RandomScene;

namespace {

template <class T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same_bits(x, y); });
}

/// A filter with the array that it points to, and what it leaves out by the book.
struct RandomFilter {
    gphys_query_filter_desc desc;
    std::vector<gphys_model_id> list;
    std::set<gphys_model_id> ignored;

    explicit RandomFilter(RandomScene& world) {
        REQUIRE(gphys_query_filter_desc_init(&desc, sizeof desc) == GPHYS_OK);
        if (world.random.index(3) == 0) desc.layers = world.random.index(8);
        if (world.random.index(4) != 0) ignore_one(world);
        if (world.random.index(2) != 0) ignore_some(world);
    }
    RandomFilter(const RandomFilter&) = delete;
    RandomFilter& operator=(const RandomFilter&) = delete;

private:
    void ignore_one(RandomScene& world) {
        desc.ignored_model = world.any_model();
        desc.flags = world.random.index(2) ? GPHYS_FILTER_SUBTREE : 0;
        if (world.random.index(10) == 0) {
            desc.ignored_model += 1u << 24;  // another generation, so nothing
            return;
        }
        ignored.insert(desc.ignored_model);
        if (desc.flags == 0) return;
        for (const test::PlacedModel& model : world.models) {
            if (is_below(world.scene, model.id, desc.ignored_model)) ignored.insert(model.id);
        }
    }
    void ignore_some(RandomScene& world) {
        // Few are compared one by one, more are searched if they ascend.
        for (uint32_t i = world.random.index(2) ? world.random.index(4) : world.random.index(80); i > 0; --i) {
            list.push_back(world.any_model());
            ignored.insert(list.back());
        }
        if (world.random.index(3) == 0) list.push_back(0xffffffff);
        if (world.random.index(3) == 0) list.push_back(world.any_model() + (1u << 24));
        if (world.random.index(2) != 0) std::sort(list.begin(), list.end());
        desc.ignored_models = list.data();
        desc.ignored_count = static_cast<uint32_t>(list.size());
    }
    static bool is_below(const gphys_scene* scene, gphys_model_id model, gphys_model_id top) {
        gphys_model_info info;
        for (; model != 0 && model != top; model = info.parent) {
            REQUIRE(gphys_scene_get_info(scene, model, &info) == GPHYS_OK);
        }
        return model == top;
    }
};

/// While it lives, what a filter leaves out is on no layer.
class OnNoLayer {
public:
    OnNoLayer(RandomScene& world, const RandomFilter& filter) : world_(world), filter_(filter) { set(false); }
    ~OnNoLayer() { set(true); }
    OnNoLayer(const OnNoLayer&) = delete;
    OnNoLayer& operator=(const OnNoLayer&) = delete;

private:
    void set(bool back) {
        for (const test::PlacedModel& model : world_.models) {
            if (filter_.ignored.count(model.id) == 0) continue;
            REQUIRE(gphys_scene_set_layers(world_.scene, model.id, back ? model.layers : 0) == GPHYS_OK);
        }
    }
    RandomScene& world_;
    const RandomFilter& filter_;
};

gphys_ray random_ray(RandomScene& world) {
    const gphys_vec3 from = world.point(15), to = world.point(12);
    gphys_ray ray{from, {to.x - from.x, to.y - from.y, to.z - from.z}, world.random.index(2) ? INFINITY : 2.f};
    if (ray.direction.x == 0 && ray.direction.y == 0 && ray.direction.z == 0) ray.direction.y = 1;
    return ray;
}

/// All that there is to ask, with a filter or without.
struct Questions {
    std::vector<gphys_ray> rays;
    std::vector<gphys_segment> segments;
    std::vector<gphys_sphere> spheres;
    std::vector<gphys_vec3> points, displacements;
    gphys_aabb box;
    gphys_obb turned_box;
    gphys_frustum frustum;
    uint32_t capacity;

    explicit Questions(RandomScene& world) : frustum(world.frustum()) {
        for (uint32_t i = 0; i < count; ++i) {
            rays.push_back(random_ray(world));
            segments.push_back({world.point(15), world.point(15)});
            // Some of them large enough to hold models.
            spheres.push_back({world.point(12), (i % 4 == 0 ? 6 : 1) * world.size(2)});
            points.push_back(world.point(15));
            displacements.push_back(world.point(10));
        }
        const gphys_vec3 low = world.point(12);
        box = {low, {low.x + 12, low.y + 9, low.z + 15}};
        turned_box = {world.point(8), {4, 5, 6}, world.on_grid ? gphys_quat{0, 0, 0, 1} : world.random.rotation()};
        capacity = world.random.index(2) ? 1000 : world.random.index(4);
    }

    static constexpr uint32_t count = 20;
};

/// What is answered; a miss leaves what was there, as the single call does.
struct Answers {
    std::vector<gphys_status> statuses;
    std::vector<gphys_hit> hits;
    std::vector<gphys_nearest> nearest;
    std::vector<gphys_model_id> models;
    std::vector<int32_t> flags;
    std::vector<uint32_t> numbers;
};

bool operator==(const Answers& a, const Answers& b) {
    return a.statuses == b.statuses && same_bits(a.hits, b.hits) && same_bits(a.nearest, b.nearest) &&
           a.models == b.models && a.flags == b.flags && a.numbers == b.numbers;
}

/// plain(call, by) or filtered: `by` stands for the layers or the filter of call(.., by, ..).
template <class Raycast, class Any, class All, class Segment, class Overlap, class Cull, class Nearest, class Sweep,
          class By>
Answers ask(const RandomScene& world, const Questions& asked, const By& by, Raycast raycast, Any any, All all,
            Segment segment, Overlap overlap, Cull cull, Nearest nearest, Sweep sweep) {
    Answers answers;
    const auto say = [&](gphys_status status) { answers.statuses.push_back(status); };
    const auto list = [&](auto& into, const auto& call) {
        std::vector<std::decay_t<decltype(into[0])>> found(std::max(asked.capacity, 1000u));
        uint32_t total = 0;
        say(call(found.data(), &total));
        answers.numbers.push_back(total);
        into.insert(into.end(), found.begin(),
                    found.begin() + static_cast<std::ptrdiff_t>(std::min(total, asked.capacity)));
    };
    for (uint32_t i = 0; i < Questions::count; ++i) {
        gphys_hit hit{};
        say(raycast(world.scene, &asked.rays[i], by, &hit));
        answers.hits.push_back(hit);
        int32_t flag = -1;
        say(any(world.scene, &asked.rays[i], by, &flag));
        answers.flags.push_back(flag);
        list(answers.hits, [&](gphys_hit* out, uint32_t* total) {
            return all(world.scene, &asked.rays[i], by, out, asked.capacity, total);
        });
        say(segment(world.scene, &asked.segments[i], by, &hit));
        answers.hits.push_back(hit);
        gphys_nearest near{};
        say(nearest(world.scene, &asked.points[i], i % 2 ? INFINITY : 3.f, by, &near));
        answers.nearest.push_back(near);
        say(sweep(world.scene, &asked.spheres[i], &asked.displacements[i], by, &hit));
        answers.hits.push_back(hit);
        list(answers.models, [&](gphys_model_id* out, uint32_t* total) {
            return overlap(world.scene, GPHYS_SHAPE_SPHERE, &asked.spheres[i], by, out, asked.capacity, total);
        });
    }
    const auto overlaps = [&](gphys_shape_type type, const void* shape) {
        list(answers.models, [&](gphys_model_id* out, uint32_t* total) {
            return overlap(world.scene, type, shape, by, out, asked.capacity, total);
        });
    };
    overlaps(GPHYS_SHAPE_AABB, &asked.box);
    overlaps(GPHYS_SHAPE_OBB, &asked.turned_box);
    overlaps(GPHYS_SHAPE_FRUSTUM, &asked.frustum);
    overlaps(GPHYS_SHAPE_PLANE, &asked.frustum.planes[GPHYS_FRUSTUM_LEFT]);
    list(answers.models, [&](gphys_model_id* out, uint32_t* total) {
        return cull(world.scene, &asked.frustum, by, out, asked.capacity, total);
    });
    return answers;
}

Answers plain(const RandomScene& world, const Questions& asked, uint32_t layers) {
    return ask(world, asked, layers, gphys_scene_raycast, gphys_scene_raycast_any, gphys_scene_raycast_all,
               gphys_scene_segment_test, gphys_scene_overlap, gphys_scene_cull, gphys_scene_nearest,
               gphys_scene_sweep_sphere);
}
Answers filtered(const RandomScene& world, const Questions& asked, const gphys_query_filter_desc* filter) {
    return ask(world, asked, filter, gphys_scene_raycast_filtered, gphys_scene_raycast_any_filtered,
               gphys_scene_raycast_all_filtered, gphys_scene_segment_test_filtered, gphys_scene_overlap_filtered,
               gphys_scene_cull_filtered, gphys_scene_nearest_filtered, gphys_scene_sweep_sphere_filtered);
}

RandomScene& filled(RandomScene& world, uint32_t changes) {
    for (uint32_t i = 0; i < changes; ++i) world.change();
    world.look();
    return world;
}

/// A hit of a batch where the single call finds nothing.
const gphys_hit batch_miss{0, 0, INFINITY, {0, 0, 0}, {0, 0, 0}, GPHYS_NO_TRIANGLE, 0, 0, 0};

}  // namespace

TEST_CASE("a filter answers as if what it leaves out were not there", "[scene][filter]") {
    for (uint64_t seed = 1; seed <= 8; ++seed) {
        RandomScene world(seed);
        world.on_grid = seed % 2 == 0;
        if (seed % 4 == 0) world.common_layer = 0;
        for (uint32_t round = 0; round < 25; ++round) {
            filled(world, 40);
            const RandomFilter filter(world);
            const Questions asked(world);
            const Answers found = filtered(world, asked, &filter.desc);
            const OnNoLayer hidden(world, filter);
            INFO("seed " << seed << ", round " << round);
            REQUIRE(found == plain(world, asked, filter.desc.layers));
        }
    }
}

TEST_CASE("lists with a filter are those without less the ignored", "[scene][filter]") {
    for (uint64_t seed = 40; seed < 44; ++seed) {
        RandomScene world(seed);
        world.on_grid = seed % 2 == 0;
        filled(world, 500);
        for (uint32_t round = 0; round < 100; ++round) {
            const RandomFilter filter(world);
            const gphys_ray ray = random_ray(world);
            std::vector<gphys_hit> all(1000), found(1000);
            uint32_t all_count = 0, count = 0;
            REQUIRE(gphys_scene_raycast_all(world.scene, &ray, filter.desc.layers, all.data(), 1000, &all_count) ==
                    GPHYS_OK);
            REQUIRE(gphys_scene_raycast_all_filtered(world.scene, &ray, &filter.desc, found.data(), 1000, &count) ==
                    GPHYS_OK);
            all.resize(all_count);
            found.resize(count);
            const auto is_ignored = [&](const gphys_hit& hit) { return filter.ignored.count(hit.model) != 0; };
            all.erase(std::remove_if(all.begin(), all.end(), is_ignored), all.end());
            REQUIRE(same_bits(all, found));
            gphys_hit first{};
            const gphys_status status = gphys_scene_raycast_filtered(world.scene, &ray, &filter.desc, &first);
            REQUIRE(status == (all.empty() ? GPHYS_NO_HIT : GPHYS_OK));
            REQUIRE((all.empty() || same_bits(first, all[0])));
        }
    }
}

TEST_CASE("batches with filters are their single calls", "[scene][filter]") {
    constexpr uint32_t count = 300;
    for (uint64_t seed = 60; seed < 66; ++seed) {
        RandomScene world(seed);
        world.on_grid = seed % 2 == 0;
        filled(world, 600);
        // Rays of one eye, so that they go together.
        const bool together = seed % 3 == 0;
        std::vector<std::unique_ptr<RandomFilter>> filters;
        std::vector<gphys_query_filter_desc> descs;
        std::vector<gphys_ray> rays;
        std::vector<gphys_segment> segments;
        std::vector<gphys_sphere> spheres;
        std::vector<gphys_vec3> points, displacements;
        const gphys_vec3 eye = world.point(12);
        for (uint32_t i = 0; i < count; ++i) {
            filters.push_back(std::make_unique<RandomFilter>(world));
            descs.push_back(filters.back()->desc);
            rays.push_back(random_ray(world));
            if (together) {
                const auto column = static_cast<float>(i % 20), row = static_cast<float>(i / 20);
                rays.back() = {eye, {0.05f * column - 0.5f, 0.05f * row - 0.4f, 1}, INFINITY};
            }
            segments.push_back({world.point(15), world.point(15)});
            spheres.push_back({world.point(12), world.size(4)});
            points.push_back(world.point(15));
            displacements.push_back(world.point(10));
        }
        constexpr uint32_t hit_stride = sizeof(gphys_hit), desc_stride = sizeof(gphys_query_filter_desc);
        for (const uint32_t stride : {desc_stride, 0u}) {
            const auto filter_of = [&](uint32_t i) { return &descs[stride == 0 ? 0 : i]; };
            std::vector<gphys_hit> hits(count), segment_hits(count), sweeps(count);
            std::vector<int32_t> any(count);
            std::vector<gphys_nearest> nearest(count);
            std::vector<gphys_hit> all(100000);
            std::vector<gphys_model_id> overlaps(100000);
            std::vector<uint32_t> all_ends(count + 1), overlap_ends(count + 1);
            const gphys_scene* scene = world.scene;
            REQUIRE(gphys_scene_raycast_filtered_batch(scene, rays.data(), sizeof(gphys_ray), count, descs.data(),
                                                       stride, hits.data(), hit_stride) == GPHYS_OK);
            REQUIRE(gphys_scene_raycast_any_filtered_batch(scene, rays.data(), sizeof(gphys_ray), count, descs.data(),
                                                           stride, any.data(), sizeof(int32_t)) == GPHYS_OK);
            REQUIRE(gphys_scene_raycast_all_filtered_batch(scene, rays.data(), sizeof(gphys_ray), count, descs.data(),
                                                           stride, all.data(), 100000, all_ends.data()) == GPHYS_OK);
            REQUIRE(gphys_scene_segment_test_filtered_batch(scene, segments.data(), sizeof(gphys_segment), count,
                                                            descs.data(), stride, segment_hits.data(),
                                                            hit_stride) == GPHYS_OK);
            REQUIRE(gphys_scene_overlap_filtered_batch(scene, GPHYS_SHAPE_SPHERE, spheres.data(), sizeof(gphys_sphere),
                                                       count, descs.data(), stride, overlaps.data(), 100000,
                                                       overlap_ends.data()) == GPHYS_OK);
            REQUIRE(gphys_scene_nearest_filtered_batch(scene, points.data(), sizeof(gphys_vec3), count, 5, descs.data(),
                                                       stride, nearest.data(), sizeof(gphys_nearest)) == GPHYS_OK);
            REQUIRE(gphys_scene_sweep_sphere_filtered_batch(
                        scene, spheres.data(), sizeof(gphys_sphere), displacements.data(), sizeof(gphys_vec3), count,
                        descs.data(), stride, sweeps.data(), hit_stride) == GPHYS_OK);
            for (uint32_t i = 0; i < count; ++i) {
                INFO("seed " << seed << ", item " << i << ", stride " << stride);
                const gphys_query_filter_desc* filter = filter_of(i);
                gphys_hit hit = batch_miss;
                gphys_scene_raycast_filtered(scene, &rays[i], filter, &hit);
                REQUIRE(same_bits(hit, hits[i]));
                int32_t met = -1;
                gphys_scene_raycast_any_filtered(scene, &rays[i], filter, &met);
                REQUIRE(met == any[i]);
                std::vector<gphys_hit> some(1000);
                uint32_t total = 0;
                gphys_scene_raycast_all_filtered(scene, &rays[i], filter, some.data(), 1000, &total);
                REQUIRE(total == all_ends[i + 1] - all_ends[i]);
                REQUIRE(std::memcmp(some.data(), &all[all_ends[i]], total * sizeof some[0]) == 0);
                hit = batch_miss;
                gphys_scene_segment_test_filtered(scene, &segments[i], filter, &hit);
                REQUIRE(same_bits(hit, segment_hits[i]));
                std::vector<gphys_model_id> ids(1000);
                gphys_scene_overlap_filtered(scene, GPHYS_SHAPE_SPHERE, &spheres[i], filter, ids.data(), 1000, &total);
                REQUIRE(total == overlap_ends[i + 1] - overlap_ends[i]);
                REQUIRE(std::equal(ids.begin(), ids.begin() + total, overlaps.begin() + overlap_ends[i]));
                gphys_nearest near{0, 0, {0, 0, 0}, INFINITY, GPHYS_NO_TRIANGLE};
                gphys_scene_nearest_filtered(scene, &points[i], 5, filter, &near);
                REQUIRE(same_bits(near, nearest[i]));
                hit = batch_miss;
                gphys_scene_sweep_sphere_filtered(scene, &spheres[i], &displacements[i], filter, &hit);
                REQUIRE(same_bits(hit, sweeps[i]));
            }
        }
    }
}

// A level is asked by all rays of a batch before the walk through the scene, unless one of them does not see it.
TEST_CASE("a large mesh is left out of a batch by the rays that ignore it", "[scene][filter]") {
    const test::MeshSource source = test::cube_mesh();
    gphys_mesh* mesh = source.create();
    gphys_scene* scene = nullptr;
    REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
    const gphys_transform large{{0, 0, 0}, {0, 0, 0, 1}, 50};
    gphys_model_id level = 0, ball = 0;
    REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_MESH, mesh, &large, nullptr, &level) == GPHYS_OK);
    const gphys_sphere far_ball{{0, 0, 100}, 20};
    REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &far_ball, nullptr, nullptr, &ball) == GPHYS_OK);
    constexpr uint32_t count = 64;
    gphys_ray rays[count];
    gphys_query_filter_desc filters[count];
    for (uint32_t i = 0; i < count; ++i) {
        rays[i] = {{0, 0, 0}, {0.01f * static_cast<float>(i % 8), 0.01f * static_cast<float>(i / 8), 1}, INFINITY};
        REQUIRE(gphys_query_filter_desc_init(&filters[i], sizeof filters[i]) == GPHYS_OK);
        if (i % 3 == 0) filters[i].ignored_model = level;
    }
    gphys_hit hits[count];
    REQUIRE(gphys_scene_raycast_filtered_batch(scene, rays, sizeof rays[0], count, filters, sizeof filters[0], hits,
                                               sizeof hits[0]) == GPHYS_OK);
    for (uint32_t i = 0; i < count; ++i) CHECK(hits[i].model == (i % 3 == 0 ? ball : level));
    for (const uint32_t first : {0u, 1u}) {
        REQUIRE(gphys_scene_raycast_filtered_batch(scene, rays, sizeof rays[0], count, filters + first, 0, hits,
                                                   sizeof hits[0]) == GPHYS_OK);
        for (const gphys_hit& hit : hits) CHECK(hit.model == (first == 0 ? ball : level));
    }
    gphys_scene_destroy(scene);
    gphys_mesh_destroy(mesh);
}

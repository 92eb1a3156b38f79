// The nearest models of layers that few models are in, against a linear scan: bit for bit, while layers change, models
// come and go, and slots are used again; in restored scenes, batches and with many workers.
#include <ctime>

#include "scene/layer_blocks.h"
#include "scene_reference.h"

using namespace gphys;
using test::PlacedModel;

namespace {

template <class T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

constexpr uint32_t common = 1, rare = 2, few = 4, clustered = 8, absent = 1u << 31;
constexpr uint32_t masks[] = {common, rare, few, clustered, absent, rare | clustered, few | absent, GPHYS_ALL_LAYERS};
const gphys_nearest no_model{0, 0, {0, 0, 0}, INFINITY, GPHYS_NO_TRIANGLE};

/// Thousands of spheres and boxes at whole numbers, so that many are equally near.
class Crowd {
public:
    static constexpr uint32_t count = 5000;

    explicit Crowd(uint64_t seed, uint32_t workers = 1) : random(seed), scene(create(workers)) {
        for (uint32_t i = 0; i < count; ++i) add(i >= count - 500 ? clustered : common);
        for (uint32_t i = 0; i < 60; ++i) set_layers(i % 6 == 0 ? rare : few | common);
    }
    ~Crowd() { gphys_scene_destroy(scene); }
    Crowd(const Crowd&) = delete;
    Crowd& operator=(const Crowd&) = delete;

    test::Random random;
    gphys_scene* scene;
    std::vector<PlacedModel> models;

    static gphys_scene* create(uint32_t workers) {
        gphys_scene_desc desc;
        REQUIRE(gphys_scene_desc_init(&desc, sizeof desc) == GPHYS_OK);
        desc.worker_count = workers;
        gphys_scene* made = nullptr;
        REQUIRE(gphys_scene_create(&desc, &made) == GPHYS_OK);
        return made;
    }

    gphys_vec3 point(float extent) {
        const gphys_vec3 p = random.point(extent);
        return {std::round(p.x), std::round(p.y), std::round(p.z)};
    }

    void add(uint32_t layers) {
        gphys_model_desc desc;
        REQUIRE(gphys_model_desc_init(&desc, sizeof desc) == GPHYS_OK);
        desc.layers = layers;
        desc.tag = random.index(1000);
        gphys_transform place{point(20), {0, 0, 0, 1}, 1};
        if (layers == clustered) place.position.x += 200;
        PlacedModel model{0, layers, desc.tag, widen(place), {}};
        if (random.index(2) != 0) {
            const gphys_sphere ball{{0, 0, 0}, static_cast<float>(random.index(2))};
            model.shape = transformed(widen(ball), model.world);
            REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &place, &desc, &model.id) == GPHYS_OK);
        } else {
            const gphys_aabb box{{-1, 0, 0}, {0, static_cast<float>(random.index(3)), 1}};
            const Aabb wide = widen(box);
            model.shape = Aabb{model.world.position + wide.min, model.world.position + wide.max};
            REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_AABB, &box, &place, &desc, &model.id) == GPHYS_OK);
        }
        models.push_back(model);
    }
    void remove() {
        const uint32_t i = random.index(static_cast<uint32_t>(models.size()));
        REQUIRE(gphys_scene_remove(scene, models[i].id) == GPHYS_OK);
        models[i] = models.back();
        models.pop_back();
    }
    void set_layers(uint32_t layers) {
        PlacedModel& model = models[random.index(static_cast<uint32_t>(models.size()))];
        model.layers = layers;
        REQUIRE(gphys_scene_set_layers(scene, model.id, layers) == GPHYS_OK);
    }
    /// Models leave and others come, in new slots and old ones; some change their layers.
    void change() {
        for (uint32_t i = 0; i < 1500; ++i) remove();
        for (uint32_t i = 0; i < 1500; ++i) {
            const uint32_t kind = random.index(300);
            add(kind == 0 ? rare : kind < 5 ? few | common : kind < 30 ? clustered : common);
        }
        for (uint32_t i = 0; i < 20; ++i) set_layers(common);
        for (uint32_t i = 0; i < 3; ++i) set_layers(rare);
        for (const PlacedModel& model : models) {
            if (model.layers == rare && random.index(2) != 0) {
                REQUIRE(gphys_scene_set_layers(scene, model.id, common) == GPHYS_OK);
            }
        }
        read_layers();
    }

    gphys_nearest expected(gphys_vec3 from, float within, uint32_t layers, gphys_model_id ignored) const {
        gphys_nearest best = no_model;
        for (const PlacedModel& model : models) {
            Vec3 closest;
            uint32_t triangle;
            if ((model.layers & layers) == 0 || model.id == ignored) continue;
            const double distance = closest_point(model, widen(from), within, closest, triangle);
            if (distance == infinity) continue;
            const gphys_nearest found = to_nearest(closest, distance, triangle, model.id, model.tag);
            const bool is_first = best.model == 0 || found.distance < best.distance ||
                                  (found.distance == best.distance && found.model < best.model);
            if (is_first) best = found;
        }
        return best;
    }

private:
    void read_layers() {
        for (PlacedModel& model : models) {
            gphys_model_info info;
            REQUIRE(gphys_scene_get_info(scene, model.id, &info) == GPHYS_OK);
            model.layers = info.layers;
        }
    }
};

gphys_query_filter_desc filter_of(uint32_t layers, gphys_model_id ignored) {
    gphys_query_filter_desc filter;
    REQUIRE(gphys_query_filter_desc_init(&filter, sizeof filter) == GPHYS_OK);
    filter.layers = layers;
    filter.ignored_model = ignored;
    return filter;
}

/// All forms of the query on `scene`, which has the models of the crowd.
void compare(Crowd& crowd, const gphys_scene* scene, uint32_t count) {
    constexpr uint32_t point_size = sizeof(gphys_vec3), out_size = sizeof(gphys_nearest);
    std::vector<gphys_vec3> points(count);
    for (gphys_vec3& point : points) point = crowd.point(crowd.random.index(4) == 0 ? 150 : 25);
    std::vector<gphys_query_filter_desc> mixed(count);
    std::vector<gphys_nearest> expected_of_mixed(count), found(count);
    for (const uint32_t layers : masks) {
        const float within = crowd.random.index(4) == 0 ? 6.f : INFINITY;
        INFO("layers " << layers << ", within " << within);
        const gphys_nearest left_out = crowd.expected(points[0], within, layers, 0);
        const gphys_query_filter_desc filter = filter_of(layers, left_out.model);
        std::vector<gphys_nearest> expected(count), expected_of_others(count);
        for (uint32_t i = 0; i < count; ++i) {
            expected[i] = crowd.expected(points[i], within, layers, 0);
            expected_of_others[i] = crowd.expected(points[i], within, layers, left_out.model);
            gphys_nearest nearest = no_model;
            const gphys_status status = gphys_scene_nearest(scene, &points[i], within, layers, &nearest);
            REQUIRE(status == (expected[i].model == 0 ? GPHYS_NO_HIT : GPHYS_OK));
            REQUIRE(same_bits(nearest, expected[i]));
            nearest = no_model;
            gphys_scene_nearest_filtered(scene, &points[i], within, &filter, &nearest);
            REQUIRE(same_bits(nearest, expected_of_others[i]));
        }
        const auto all_same = [&](const std::vector<gphys_nearest>& as) {
            return std::equal(found.begin(), found.end(), as.begin(), same_bits<gphys_nearest>);
        };
        REQUIRE(gphys_scene_nearest_batch(scene, points.data(), point_size, count, within, layers, found.data(),
                                          out_size) == GPHYS_OK);
        REQUIRE(all_same(expected));
        REQUIRE(gphys_scene_nearest_filtered_batch(scene, points.data(), point_size, count, within, &filter, 0,
                                                   found.data(), out_size) == GPHYS_OK);
        REQUIRE(all_same(expected_of_others));
        // Each point with its own layers.
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t own = masks[crowd.random.index(std::size(masks))];
            mixed[i] = filter_of(own, left_out.model);
            expected_of_mixed[i] = crowd.expected(points[i], within, own, left_out.model);
        }
        REQUIRE(gphys_scene_nearest_filtered_batch(scene, points.data(), point_size, count, within, mixed.data(),
                                                   sizeof mixed[0], found.data(), out_size) == GPHYS_OK);
        REQUIRE(all_same(expected_of_mixed));
    }
}

}  // namespace

TEST_CASE("LayerCounts counts the models of each layer", "[scene][layers]") {
    test::Random random(1);
    LayerCounts counts;
    uint32_t expected[32] = {};
    std::vector<uint32_t> added;
    for (uint32_t step = 0; step < 20000; ++step) {
        // Up to as many as a block has.
        if (added.empty() || (added.size() < LayerBlocks::block_slots && random.index(100) < 55)) {
            const uint32_t layers = random.index(3) == 0 ? ~0u : random.index(1u << 16) << random.index(17);
            added.push_back(layers);
            counts.add(layers);
            for (uint32_t l = 0; l < 32; ++l) expected[l] += layers >> l & 1;
        } else {
            const uint32_t which = random.index(static_cast<uint32_t>(added.size()));
            const uint32_t layers = added[which];
            added.erase(added.begin() + which);
            counts.remove(layers);
            for (uint32_t l = 0; l < 32; ++l) expected[l] -= layers >> l & 1;
        }
        uint32_t all = 0;
        for (uint32_t l = 0; l < 32; ++l) {
            REQUIRE(counts.estimate(1u << l) == expected[l]);
            if (expected[l] != 0) all |= 1u << l;
        }
        REQUIRE(counts.layers() == all);
        const uint32_t l = random.index(32), other = random.index(32);
        REQUIRE(counts.estimate(1u << l | 1u << other) >= std::max(expected[l], expected[other]));
    }
}

TEST_CASE("the nearest of a rare layer is that of a linear scan", "[scene][layers]") {
    Crowd crowd(2);
    for (int round = 0; round < 4; ++round) {
        INFO("round " << round);
        REQUIRE(gphys_scene_validate(crowd.scene) == GPHYS_OK);
        compare(crowd, crowd.scene, 40);
        crowd.change();
    }
    REQUIRE(gphys_scene_clear(crowd.scene) == GPHYS_OK);
    crowd.models.clear();
    REQUIRE(gphys_scene_validate(crowd.scene) == GPHYS_OK);
    for (uint32_t i = 0; i < 2000; ++i) crowd.add(i == 1500 ? rare : common);
    REQUIRE(gphys_scene_validate(crowd.scene) == GPHYS_OK);
    compare(crowd, crowd.scene, 20);
}

TEST_CASE("the nearest of a rare layer is the same in a restored scene", "[scene][layers]") {
    Crowd crowd(3), other(4);
    crowd.change();
    uint32_t size = 0;
    REQUIRE(gphys_scene_get_snapshot(crowd.scene, 0, nullptr, 0, &size) == GPHYS_INCOMPLETE);
    std::vector<uint32_t> words(size);
    REQUIRE(gphys_scene_get_snapshot(crowd.scene, 0, words.data(), size, &size) == GPHYS_OK);
    REQUIRE(gphys_scene_restore(other.scene, nullptr, words.data(), size) == GPHYS_OK);
    REQUIRE(gphys_scene_validate(other.scene) == GPHYS_OK);
    compare(crowd, other.scene, 20);
    // A snapshot that is refused leaves the layers as they were.
    words[size / 2] ^= 1;
    REQUIRE(gphys_scene_restore(crowd.scene, nullptr, words.data(), size) == GPHYS_ERROR_INVALID_ARGUMENT);
    REQUIRE(gphys_scene_validate(crowd.scene) == GPHYS_OK);
    compare(crowd, crowd.scene, 20);
}

TEST_CASE("the nearest of a rare layer is the same with many workers", "[scene][layers]") {
    Crowd crowd(5, 4);
    compare(crowd, crowd.scene, 300);
}

TEST_CASE("the nearest of a rare layer does not wait for the other layers", "[scene][layers]") {
    constexpr uint32_t count = 20000, points = 64;
    test::Random random(6);
    gphys_scene* const scene = Crowd::create(1);
    std::vector<gphys_transform> places(count);
    for (gphys_transform& place : places) place = {random.point(100), {0, 0, 0, 1}, 1};
    std::vector<gphys_model_id> models(count);
    const gphys_aabb box{{-1, -1, -1}, {1, 1, 1}};
    REQUIRE(gphys_scene_add_batch(scene, GPHYS_SHAPE_AABB, &box, 0, places.data(), sizeof places[0], count, nullptr,
                                  models.data()) == GPHYS_OK);
    for (uint32_t i = 0; i < 3; ++i) {
        REQUIRE(gphys_scene_set_layers(scene, models[random.index(count)], rare) == GPHYS_OK);
    }
    std::vector<gphys_vec3> from(points);
    for (gphys_vec3& point : from) point = random.point(100);
    gphys_nearest nearest, batch[points];
    // The least of some rounds, in single calls and in a batch.
    const auto time = [&](uint32_t layers, uint32_t repeated) {
        std::clock_t least = std::numeric_limits<std::clock_t>::max();
        for (int round = 0; round < 5; ++round) {
            const std::clock_t begin = std::clock();
            for (uint32_t i = 0; i < repeated; ++i) {
                for (const gphys_vec3& point : from) gphys_scene_nearest(scene, &point, INFINITY, layers, &nearest);
                gphys_scene_nearest_batch(scene, from.data(), sizeof from[0], points, INFINITY, layers, batch,
                                          sizeof batch[0]);
            }
            least = std::min(least, std::clock() - begin);
        }
        return static_cast<double>(least) / repeated;
    };
    const double of_all = time(GPHYS_ALL_LAYERS, 20);
    // Twice to four times; with traversals alone hundreds of times.
    CHECK(time(rare, 4) < 30 * of_all);
    CHECK(time(absent, 4) < 30 * of_all);
    gphys_scene_destroy(scene);
}

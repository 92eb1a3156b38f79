// Long lists of ids, against a linear scan: with little room and much, after slots were used again, in batches and with
// many workers.
#include <ctime>

#include "scene_reference.h"

using namespace gphys;
using test::PlacedModel;

namespace {

constexpr uint32_t count = 6000, slots_at_most = count + 3000;

/// Spheres, a third of them in other slots than their ids' order tells.
class Heap {
public:
    explicit Heap(uint64_t seed, uint32_t workers = 1) : random_(seed) {
        gphys_scene_desc desc;
        REQUIRE(gphys_scene_desc_init(&desc, sizeof desc) == GPHYS_OK);
        desc.worker_count = workers;
        REQUIRE(gphys_scene_create(&desc, &scene) == GPHYS_OK);
        for (uint32_t i = 0; i < count; ++i) add(i);
        for (uint32_t i = 0; i < count; i += 2) REQUIRE(gphys_scene_remove(scene, models[i].id) == GPHYS_OK);
        for (uint32_t i = 0; i < count; i += 2) add(i);
        std::sort(models.begin(), models.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
        REQUIRE(gphys_scene_validate(scene) == GPHYS_OK);
    }
    ~Heap() { gphys_scene_destroy(scene); }
    Heap(const Heap&) = delete;
    Heap& operator=(const Heap&) = delete;

    gphys_scene* scene = nullptr;
    std::vector<PlacedModel> models;  // by id, after the constructor

    std::vector<gphys_model_id> overlapping(const Shape& query, uint32_t layers) const {
        std::vector<gphys_model_id> ids;
        for (const PlacedModel& model : models) {
            if ((model.layers & layers) != 0 && overlaps(model, query)) ids.push_back(model.id);
        }
        return ids;
    }

private:
    void add(uint32_t at) {
        models.resize(std::max<size_t>(models.size(), at + 1));
        const gphys_sphere ball{{0, 0, 0}, random_.uniform_float(0, 0.5f)};
        const gphys_transform place{random_.point(20), {0, 0, 0, 1}, 1};
        gphys_model_desc desc;
        REQUIRE(gphys_model_desc_init(&desc, sizeof desc) == GPHYS_OK);
        desc.layers = random_.index(3) == 0 ? 3 : 1;
        PlacedModel& model = models[at];
        model = {0, desc.layers, 0, widen(place), {}};
        model.shape = transformed(widen(ball), model.world);
        REQUIRE(gphys_scene_add(scene, GPHYS_SHAPE_SPHERE, &ball, &place, &desc, &model.id) == GPHYS_OK);
    }
    test::Random random_;
};

/// list(out, capacity, total) for room from none to more than enough.
template <class List>
void check_rooms(const std::vector<gphys_model_id>& expected, const List& list) {
    const auto all = static_cast<uint32_t>(expected.size());
    for (const uint32_t room : {0u, 1u, all / 2, all, all + 1, all + 31, all + 100, 3 * slots_at_most}) {
        constexpr gphys_model_id untouched = 12345;
        std::vector<gphys_model_id> found(room + 8, untouched);
        uint32_t total = 0;
        const gphys_status status = list(found.data(), room, &total);
        INFO("room for " << room << " of " << all);
        REQUIRE(status == (all > room ? GPHYS_INCOMPLETE : GPHYS_OK));
        REQUIRE(total == all);
        REQUIRE(std::equal(found.begin(), found.begin() + std::min(all, room), expected.begin()));
        REQUIRE(std::count(found.begin() + room, found.end(), untouched) == 8);
    }
}

template <class Public>
void check_overlap(const Heap& heap, gphys_shape_type type, const Public& shape) {
    const Shape query = widen(shape);
    for (const uint32_t layers : {GPHYS_ALL_LAYERS, 2u}) {
        const std::vector<gphys_model_id> expected = heap.overlapping(query, layers);
        INFO("type " << type << ", layers " << layers);
        check_rooms(expected, [&](gphys_model_id* out, uint32_t room, uint32_t* total) {
            return gphys_scene_overlap(heap.scene, type, &shape, layers, out, room, total);
        });
    }
    std::vector<gphys_model_id> expected = heap.overlapping(query, GPHYS_ALL_LAYERS);
    if (expected.empty()) return;
    gphys_query_filter_desc filter;
    REQUIRE(gphys_query_filter_desc_init(&filter, sizeof filter) == GPHYS_OK);
    filter.ignored_model = expected[expected.size() / 2];
    expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(expected.size() / 2));
    check_rooms(expected, [&](gphys_model_id* out, uint32_t room, uint32_t* total) {
        return gphys_scene_overlap_filtered(heap.scene, type, &shape, &filter, out, room, total);
    });
}

}  // namespace

TEST_CASE("overlaps with few and with many models equal the linear scan, whatever the room", "[scene][lists]") {
    const Heap heap(1);
    for (const float size : {0.5f, 3.f, 8.f, 10.f, 30.f}) {
        check_overlap(heap, GPHYS_SHAPE_SPHERE, gphys_sphere{{1, 2, 3}, size});
        check_overlap(heap, GPHYS_SHAPE_AABB, gphys_aabb{{-size, -size, -size}, {size, size, size}});
        check_overlap(heap, GPHYS_SHAPE_OBB, gphys_obb{{1, 0, 0}, {size, size, size}, {0, 0.6f, 0, 0.8f}});
        gphys_frustum view{};
        for (int k = 0; k < 3; ++k) {
            for (int side = 0; side < 2; ++side) {
                gphys_plane& plane = view.planes[2 * k + side];
                (&plane.normal.x)[k] = side == 0 ? 1.f : -1.f;
                plane.distance = -size;
            }
        }
        check_overlap(heap, GPHYS_SHAPE_FRUSTUM, view);
    }
    check_overlap(heap, GPHYS_SHAPE_PLANE, gphys_plane{{0, 1, 0}, 2});
}

TEST_CASE("overlaps of a batch with many models equal the linear scan", "[scene][lists]") {
    for (const uint32_t workers : {1u, 4u}) {
        const Heap heap(2, workers);
        constexpr uint32_t shapes = 600;
        std::vector<gphys_sphere> balls(shapes);
        std::vector<uint32_t> ends{0};
        std::vector<gphys_model_id> expected;
        for (uint32_t i = 0; i < shapes; ++i) {
            balls[i] = {{static_cast<float>(i % 7), 0, 0}, i % 20 == 0 ? 25.f : 1.f};
            for (const gphys_model_id id : heap.overlapping(widen(balls[i]), 1)) expected.push_back(id);
            ends.push_back(static_cast<uint32_t>(expected.size()));
        }
        const auto all = static_cast<uint32_t>(expected.size());
        for (const uint32_t room : {all / 3, all, all + 500, all + slots_at_most, 3 * all}) {
            std::vector<gphys_model_id> found(room);
            std::vector<uint32_t> offsets(shapes + 1);
            INFO("room for " << room << " of " << all << ", " << workers << " workers");
            REQUIRE(gphys_scene_overlap_batch(heap.scene, GPHYS_SHAPE_SPHERE, balls.data(), sizeof balls[0], shapes, 1,
                                              found.data(), room,
                                              offsets.data()) == (all > room ? GPHYS_INCOMPLETE : GPHYS_OK));
            REQUIRE(offsets == ends);
            // A list that does not fit keeps its lowest ids.
            REQUIRE(std::equal(found.begin(), found.begin() + std::min(all, room), expected.begin()));
        }
    }
}

TEST_CASE("a marquee around many models lists those in its frustum", "[scene][lists]") {
    const Heap heap(3);
    gphys_camera* camera = nullptr;
    REQUIRE(gphys_camera_create(nullptr, &camera) == GPHYS_OK);
    const gphys_vec3 position{0, 0, 30};
    const gphys_quat rotation{0, 0, 0, 1};
    REQUIRE(gphys_camera_set_transform(camera, &position, &rotation) == GPHYS_OK);
    for (const float size : {5.f, 100.f, 2000.f}) {
        gphys_frustum seen;
        REQUIRE(gphys_camera_get_rectangle_frustum(camera, -size, -size, size, size, &seen) == GPHYS_OK);
        const std::vector<gphys_model_id> expected = heap.overlapping(widen(seen), GPHYS_ALL_LAYERS);
        check_rooms(expected, [&](gphys_model_id* out, uint32_t room, uint32_t* total) {
            return gphys_camera_pick_rectangle(camera, heap.scene, -size, -size, size, size, GPHYS_ALL_LAYERS, out,
                                               room, total);
        });
    }
    gphys_camera_destroy(camera);
}

TEST_CASE("ids of many models are listed in little more time than they are counted", "[scene][lists]") {
    const Heap heap(4);
    const gphys_aabb box{{-50, -50, -50}, {50, 50, 50}};
    std::vector<gphys_model_id> found(2 * slots_at_most);
    uint32_t total = 0;
    const auto time = [&](gphys_model_id* out, uint32_t capacity) {
        std::clock_t least = std::numeric_limits<std::clock_t>::max();
        for (int round = 0; round < 7; ++round) {
            const std::clock_t begin = std::clock();
            for (int i = 0; i < 30; ++i) {
                gphys_scene_overlap(heap.scene, GPHYS_SHAPE_AABB, &box, GPHYS_ALL_LAYERS, out, capacity, &total);
            }
            least = std::min(least, std::clock() - begin);
        }
        REQUIRE(total == count);
        return static_cast<double>(least);
    };
    CHECK(time(found.data(), 2 * slots_at_most) < 6 * time(nullptr, 0));
}

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>

#include "c_api/handles.h"
#include "each_set.h"
#include "scene/scene.h"
#include "scene_fixture.h"
#include "scene_reference.h"

using namespace gphys;
using test::PlacedModel;
using test::RandomScene;

namespace {

template <class T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool seen(const PlacedModel& model, uint32_t layers) { return (model.layers & layers) != 0; }

uint32_t random_layers(RandomScene& world) { return world.random.index(3) ? GPHYS_ALL_LAYERS : world.random.index(8); }

gphys_ray random_ray(RandomScene& world) {
    gphys_ray ray;
    ray.origin = world.point(world.random.index(10) == 0 ? 1e5f : 15);
    const gphys_vec3 target = world.point(12);
    switch (world.random.index(4)) {
        case 0:
            ray.direction = {0, 0, 0};
            (&ray.direction.x)[world.random.index(3)] = world.random.index(2) ? 1.f : -2.f;
            break;
        default:
            ray.direction = {target.x - ray.origin.x, target.y - ray.origin.y, target.z - ray.origin.z};
            if (ray.direction.x == 0 && ray.direction.y == 0 && ray.direction.z == 0) ray.direction.y = 1;
    }
    ray.t_max = world.random.index(2) ? INFINITY : world.random.uniform_float(0, 2);
    return ray;
}

bool expected_first(const RandomScene& world, const Ray& ray, uint32_t layers, gphys_hit& out) {
    Hit first;
    const PlacedModel* winner = nullptr;
    for (const PlacedModel& model : world.models) {
        Hit hit;
        if (!seen(model, layers) || !raycast(model, ray, hit)) continue;
        if (winner && reported(hit.t) >= reported(first.t)) continue;
        first = hit;
        winner = &model;
    }
    if (winner) out = to_hit(first, winner->id, winner->tag);
    return winner != nullptr;
}

// One random query of each kind: each returns whether the scene agrees with the linear scan.

bool raycast_agrees(RandomScene& world) {
    const gphys_ray ray = random_ray(world);
    const uint32_t layers = random_layers(world);
    gphys_hit expected{}, found{};
    const bool hit = expected_first(world, widen(ray), layers, expected);
    const gphys_status status = gphys_scene_raycast(world.scene, &ray, layers, &found);
    return status == (hit ? GPHYS_OK : GPHYS_NO_HIT) && same_bits(expected, found);
}

bool segment_agrees(RandomScene& world) {
    const gphys_segment segment{world.point(15), world.point(15)};
    const uint32_t layers = random_layers(world);
    gphys_hit expected{}, found{};
    const bool hit = expected_first(world, ray_along(widen(segment)), layers, expected);
    const gphys_status status = gphys_scene_segment_test(world.scene, &segment, layers, &found);
    return status == (hit ? GPHYS_OK : GPHYS_NO_HIT) && same_bits(expected, found);
}

bool raycast_any_agrees(RandomScene& world) {
    const gphys_ray ray = random_ray(world);
    const uint32_t layers = random_layers(world);
    gphys_hit unused;
    int32_t found = -1;
    REQUIRE(gphys_scene_raycast_any(world.scene, &ray, layers, &found) == GPHYS_OK);
    return found == (expected_first(world, widen(ray), layers, unused) ? 1 : 0);
}

bool raycast_all_agrees(RandomScene& world) {
    const gphys_ray ray = random_ray(world);
    const uint32_t layers = random_layers(world);
    std::vector<gphys_hit> expected;
    for (const PlacedModel& model : world.models) {
        Hit hit;
        if (seen(model, layers) && raycast(model, widen(ray), hit))
            expected.push_back(to_hit(hit, model.id, model.tag));
    }
    std::stable_sort(expected.begin(), expected.end(),
                     [](const gphys_hit& a, const gphys_hit& b) { return a.t < b.t; });  // models are in order of id
    const uint32_t capacity = world.random.index(2) ? 1000 : world.random.index(4);
    std::vector<gphys_hit> found(capacity);
    uint32_t total = 0;
    const gphys_status status = gphys_scene_raycast_all(world.scene, &ray, layers, found.data(), capacity, &total);
    const size_t kept = std::min<size_t>(capacity, expected.size());
    return total == expected.size() && status == (total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK) &&
           std::equal(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(kept), found.begin(),
                      same_bits<gphys_hit>);
}

bool overlap_agrees(RandomScene& world) {
    RandomScene::AnyShape query;
    const gphys_vec3 low = world.point(12);
    switch (world.random.index(6)) {
        case 0:
            query.hold(GPHYS_SHAPE_FRUSTUM, world.frustum());
            break;
        case 1:  // large enough to hold models
            query.hold(GPHYS_SHAPE_SPHERE, gphys_sphere{low, 5 * world.size(2)});
            break;
        case 2:
            query.hold(GPHYS_SHAPE_AABB,
                       gphys_aabb{low, {low.x + 10 * world.size(2), low.y + 10 * world.size(2), low.z + 20}});
            break;
        default:
            query = world.primitive(12);
    }
    Shape widened;
    switch (query.type) {
        case GPHYS_SHAPE_SPHERE:
            widened = widen(*reinterpret_cast<const gphys_sphere*>(query.bytes));
            break;
        case GPHYS_SHAPE_CAPSULE:
            widened = widen(*reinterpret_cast<const gphys_capsule*>(query.bytes));
            break;
        case GPHYS_SHAPE_AABB:
            widened = widen(*reinterpret_cast<const gphys_aabb*>(query.bytes));
            break;
        case GPHYS_SHAPE_OBB:
            widened = widen(*reinterpret_cast<const gphys_obb*>(query.bytes));
            break;
        case GPHYS_SHAPE_PLANE:
            widened = widen(*reinterpret_cast<const gphys_plane*>(query.bytes));
            break;
        case GPHYS_SHAPE_TRIANGLE:
            widened = widen(*reinterpret_cast<const gphys_triangle*>(query.bytes));
            break;
        default:
            widened = widen(*reinterpret_cast<const gphys_frustum*>(query.bytes));
    }
    const uint32_t layers = random_layers(world);
    std::vector<gphys_model_id> expected;
    for (const PlacedModel& model : world.models) {
        if (seen(model, layers) && overlaps(model, widened)) expected.push_back(model.id);
    }
    std::vector<gphys_model_id> found(1000);
    uint32_t total = 0;
    REQUIRE(gphys_scene_overlap(world.scene, query.type, query.bytes, layers, found.data(), 1000, &total) == GPHYS_OK);
    found.resize(total);
    return found == expected;
}

bool nearest_agrees(RandomScene& world) {
    const gphys_vec3 point = world.point(15);
    const uint32_t layers = random_layers(world);
    const float within = world.random.index(2) ? INFINITY : world.size(4);
    gphys_nearest expected{}, found{};
    for (const PlacedModel& model : world.models) {
        Vec3 closest;
        uint32_t triangle;
        if (!seen(model, layers)) continue;
        const double distance = closest_point(model, widen(point), within, closest, triangle);
        if (distance == infinity || (expected.model != 0 && reported(distance) >= expected.distance)) continue;
        expected = to_nearest(closest, distance, triangle, model.id, model.tag);
    }
    const gphys_status status = gphys_scene_nearest(world.scene, &point, within, layers, &found);
    return status == (expected.model ? GPHYS_OK : GPHYS_NO_HIT) && same_bits(expected, found);
}

bool sweep_agrees(RandomScene& world) {
    const gphys_sphere sphere{world.point(15), world.size(1)};
    const gphys_vec3 displacement = world.random.index(20) ? world.point(20) : gphys_vec3{};
    const uint32_t layers = random_layers(world);
    gphys_hit expected{}, found{};
    for (const PlacedModel& model : world.models) {
        Hit hit;
        if (!seen(model, layers) || !sweep(model, widen(sphere), widen(displacement), hit)) continue;
        if (expected.model != 0 && reported(hit.t) >= expected.t) continue;
        expected = to_contact(hit, widen(displacement), model.id, model.tag);
    }
    const gphys_status status = gphys_scene_sweep_sphere(world.scene, &sphere, &displacement, layers, &found);
    return status == (expected.model ? GPHYS_OK : GPHYS_NO_HIT) && same_bits(expected, found);
}

/// A sphere, capsule or box, as the caller has it and as the library reads it.
struct Solid {
    explicit Solid(RandomScene& world) {
        const gphys_vec3 a = world.point(15), b = world.point(2);
        const gphys_vec3 half{std::fabs(b.x), std::fabs(b.y), std::fabs(b.z)};
        switch (world.random.index(3)) {
            case 0:
                capsule = {a, {a.x + b.x, a.y + b.y, a.z + b.z}, world.size(1)};
                type = GPHYS_SHAPE_CAPSULE, shape = &capsule, wide = widen(capsule);
                break;
            case 1:
                box = {a, {a.x + half.x, a.y + half.y, a.z + half.z}};
                type = GPHYS_SHAPE_AABB, shape = &box, wide = widen(box);
                break;
            default:
                turned = {a, half, world.random.rotation()};
                type = GPHYS_SHAPE_OBB, shape = &turned, wide = widen(turned);
        }
    }
    Solid(const Solid&) = delete;

    gphys_capsule capsule;
    gphys_aabb box;
    gphys_obb turned;
    gphys_shape_type type;
    const void* shape;
    Shape wide;
};

bool solid_sweep_agrees(RandomScene& world) {
    const Solid moving(world);
    const gphys_vec3 displacement = world.random.index(20) ? world.point(20) : gphys_vec3{};
    const uint32_t layers = random_layers(world);
    gphys_hit expected{}, found{}, batch{};
    for (const PlacedModel& model : world.models) {
        Hit hit;
        if (!seen(model, layers) || !sweep(model, moving.wide, widen(displacement), hit)) continue;
        if (expected.model != 0 && reported(hit.t) >= expected.t) continue;
        expected = to_contact(hit, widen(displacement), model.id, model.tag);
    }
    const gphys_status status =
        gphys_scene_sweep(world.scene, moving.type, moving.shape, &displacement, layers, &found);
    gphys_scene_sweep_batch(world.scene, moving.type, moving.shape, 0, &displacement, 0, 1, layers, &batch,
                            sizeof batch);
    return status == (expected.model ? GPHYS_OK : GPHYS_NO_HIT) && same_bits(expected, found) &&
           (status == GPHYS_NO_HIT || same_bits(expected, batch));
}

bool ways_out_agree(RandomScene& world) {
    const Solid moving(world);
    const uint32_t layers = random_layers(world);
    std::vector<gphys_penetration> expected, found(100);
    for (const PlacedModel& model : world.models) {
        if (seen(model, layers)) add_ways_out(model, moving.wide, expected);
    }
    std::sort(expected.begin(), expected.end(), DeepestFirst());
    uint32_t total = 0;
    gphys_scene_penetration(world.scene, moving.type, moving.shape, layers, found.data(),
                            static_cast<uint32_t>(found.size()), &total);
    found.resize(std::min<size_t>(total, found.size()));
    if (total != expected.size()) return false;
    return std::equal(found.begin(), found.end(), expected.begin(),
                      [](const auto& a, const auto& b) { return std::memcmp(&a, &b, sizeof a) == 0; });
}

/// How far the corner of the box that is furthest in is behind a plane, in units of the sum of magnitudes that float
/// arithmetic rounds: of the middle of the box, relative to the frustum, and of its extents.
double relative_depth_outside(const Aabb& box, const Frustum& frustum, const Plane& plane) {
    double sum = -plane.distance, magnitude = std::fabs(plane.distance);
    for (int k = 0; k < 3; ++k) {
        const double middle = (box.min[k] + box.max[k]) / 2 - frustum.origin[k], extent = (box.max[k] - box.min[k]) / 2;
        sum += plane.normal[k] * middle + std::fabs(plane.normal[k]) * extent;
        magnitude += std::fabs(plane.normal[k]) * (std::fabs(middle) + extent);
    }
    return -sum / magnitude;
}

/// Nothing that touches the frustum is missing, and nothing is kept that one plane clearly excludes.
bool cull_agrees(RandomScene& world) {
    const Frustum frustum = widen(world.frustum());
    const uint32_t layers = random_layers(world);
    std::vector<gphys_model_id> found(1000);
    found.resize(unwrap(world.scene)->cull(frustum, layers, found.data(), 1000));
    // With less room, the lowest; whether or not there is some for ordering.
    std::vector<size_t> rooms{found.size() / 2};
    for (size_t more = 0; more < 30; ++more) rooms.push_back(found.size() + more);
    for (const size_t room : rooms) {
        std::vector<gphys_model_id> lowest(room);
        const uint32_t total = unwrap(world.scene)->cull(frustum, layers, lowest.data(), static_cast<uint32_t>(room));
        if (total != found.size()) return false;
        if (!std::equal(found.begin(), found.begin() + std::min(room, found.size()), lowest.begin())) return false;
    }
    for (const PlacedModel& model : world.models) {
        const bool kept = std::binary_search(found.begin(), found.end(), model.id);
        gphys_aabb box;
        if (!seen(model, layers)) {
            if (kept) return false;
        } else if (gphys_scene_get_bounds(world.scene, model.id, &box) == GPHYS_UNBOUNDED) {
            if (kept != overlaps(std::get<Shape>(model.shape), Shape(frustum))) return false;
        } else if (!kept) {
            if (overlaps(Shape(widen(box)), Shape(frustum))) return false;
        } else {
            // The probe rounds by 8 * 2^-24 of the magnitudes; twice that is clear.
            for (const Plane& plane : frustum.planes) {
                if (relative_depth_outside(widen(box), frustum, plane) > 0x1p-20) return false;
            }
        }
    }
    return std::is_sorted(found.begin(), found.end());
}

bool candidates_agree(RandomScene& world) {
    const gphys_vec3 corner = world.point(15);
    const float width = world.size(6);
    const Box box{{corner.x, corner.y, corner.z}, {corner.x + width, corner.y + width, corner.z + width}};
    const uint32_t layers = random_layers(world);
    std::vector<gphys_model_id> expected, found;
    for (const PlacedModel& model : world.models) {
        gphys_aabb bounds;
        const bool unbounded = gphys_scene_get_bounds(world.scene, model.id, &bounds) == GPHYS_UNBOUNDED;
        if (!seen(model, layers)) continue;
        if (unbounded
                ? overlaps(model, Aabb{{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}})
                : bounds.min.x <= box.max[0] && bounds.max.x >= box.min[0] && bounds.min.y <= box.max[1] &&
                      bounds.max.y >= box.min[1] && bounds.min.z <= box.max[2] && bounds.max.z >= box.min[2]) {
            expected.push_back(model.id);
        }
    }
    unwrap(world.scene)->for_each_in_box(box, layers, [&](gphys_model_id id) { found.push_back(id); });
    std::sort(found.begin(), found.end());
    return found == expected;
}

struct Kind {
    const char* name;
    bool (*agrees)(RandomScene&);
};

constexpr Kind kinds[] = {{"raycast", raycast_agrees},
                          {"segment", segment_agrees},
                          {"raycast_any", raycast_any_agrees},
                          {"raycast_all", raycast_all_agrees},
                          {"overlap", overlap_agrees},
                          {"nearest", nearest_agrees},
                          {"sweep", sweep_agrees},
                          {"sweep of a solid", solid_sweep_agrees},
                          {"ways out", ways_out_agree},
                          {"cull", cull_agrees},
                          {"candidates", candidates_agree}};

void compare_with_linear_scan(int phases, int queries_per_phase, uint64_t seed) {
    RandomScene world(seed);
    for (int i = 0; i < 80; ++i) world.add();
    for (int phase = 0; phase < phases; ++phase) {
        world.on_grid = phase % 2 == 1;
        if (phase == phases * 3 / 4) world.common_layer = 0;
        for (int i = 0; i < 40; ++i) world.change();
        REQUIRE(gphys_scene_validate(world.scene) == GPHYS_OK);
        world.look();
        for (const Kind& kind : kinds) {
            int differences = 0;
            for (int i = 0; i < queries_per_phase; ++i) differences += kind.agrees(world) ? 0 : 1;
            INFO(kind.name << ", phase " << phase << " of seed " << seed);
            REQUIRE(differences == 0);
        }
    }
}

}  // namespace

TEST_CASE("each kind of query equals the linear scan, bit for bit, while models come, move and go") {
    compare_with_linear_scan(30, test::tries_on_each_set(300), 20);
}

TEST_CASE("a million queries of each kind equal the linear scan", "[.long]") {
    compare_with_linear_scan(1000, 1000, 21);
}

TEST_CASE("an empty mesh is never found, even wholly inside a query") {
    test::SceneFixture s;
    const gphys_model_id sphere = s.add_sphere(1, test::at(1, 0, 0));
    gphys_mesh* nothing = nullptr;
    REQUIRE(gphys_mesh_create(nullptr, nullptr, sizeof(gphys_vec3), 0, nullptr, 0, &nothing) == GPHYS_OK);
    s.add(GPHYS_SHAPE_MESH, nothing, test::at(0, 0, 0));
    gphys_mesh_destroy(nothing);
    const gphys_sphere ball{{0, 0, 0}, 5};
    const gphys_aabb box{{-5, -5, -5}, {5, 5, 5}};
    gphys_model_id found[2];
    uint32_t total = 0;
    REQUIRE(gphys_scene_overlap(s.scene, GPHYS_SHAPE_SPHERE, &ball, GPHYS_ALL_LAYERS, found, 2, &total) == GPHYS_OK);
    REQUIRE((total == 1 && found[0] == sphere));
    REQUIRE(gphys_scene_overlap(s.scene, GPHYS_SHAPE_AABB, &box, GPHYS_ALL_LAYERS, found, 2, &total) == GPHYS_OK);
    REQUIRE((total == 1 && found[0] == sphere));
    // Nor after the scene has been left with nothing else.
    REQUIRE(gphys_scene_remove(s.scene, sphere) == GPHYS_OK);
    s.add_sphere(1, test::at(100, 0, 0));
    REQUIRE(gphys_scene_overlap(s.scene, GPHYS_SHAPE_SPHERE, &ball, GPHYS_ALL_LAYERS, found, 2, &total) == GPHYS_OK);
    REQUIRE(total == 0);
}

TEST_CASE("queries allocate nothing") {
    test::SceneFixture s;
    test::Random random(22);
    for (int i = 0; i < 500; ++i) {
        s.add_box({random.point(20), random.rotation(), 1});
        s.add_sphere(1, {random.point(20), random.rotation(), 1});
    }
    const size_t before = s.memory.allocations;
    gphys_hit hits[100];
    gphys_nearest nearest;
    gphys_model_id models[100];
    uint32_t total = 0, offsets[2];
    int32_t any = 0;
    for (int i = 0; i < 200; ++i) {
        const gphys_ray ray{random.point(30), random.point(1), INFINITY};
        const gphys_segment segment{random.point(30), random.point(30)};
        const gphys_sphere sphere{random.point(20), 2};
        const gphys_vec3 step = random.point(20);
        gphys_scene_raycast(s.scene, &ray, 1, hits);
        gphys_scene_raycast_any(s.scene, &ray, 1, &any);
        gphys_scene_raycast_all(s.scene, &ray, 1, hits, 100, &total);
        gphys_scene_raycast_all_batch(s.scene, &ray, 0, 1, 1, hits, 100, offsets);
        gphys_scene_segment_test(s.scene, &segment, 1, hits);
        gphys_scene_overlap(s.scene, GPHYS_SHAPE_SPHERE, &sphere, 1, models, 100, &total);
        gphys_scene_nearest(s.scene, &sphere.center, INFINITY, 1, &nearest);
        gphys_scene_sweep_sphere(s.scene, &sphere, &step, 1, hits);
        gphys_scene_get_models(s.scene, models, 100, &total);
    }
    CHECK(s.memory.allocations == before);
}

TEST_CASE("a batch answers each item as the single call does") {
    RandomScene world(23);
    for (int i = 0; i < 100; ++i) world.add();
    constexpr uint32_t count = 500;
    std::vector<gphys_ray> rays(count);
    for (gphys_ray& ray : rays) ray = random_ray(world);
    std::vector<gphys_hit> hits(count), lists(20 * count);
    std::vector<int32_t> any(count);
    std::vector<uint32_t> offsets(count + 1);
    REQUIRE(gphys_scene_raycast_batch(world.scene, rays.data(), sizeof(gphys_ray), count, 3, hits.data(),
                                      sizeof(gphys_hit)) == GPHYS_OK);
    REQUIRE(gphys_scene_raycast_any_batch(world.scene, rays.data(), sizeof(gphys_ray), count, 3, any.data(), 4) ==
            GPHYS_OK);
    std::vector<gphys_distance> distances(count);
    REQUIRE(gphys_scene_raycast_distance_batch(world.scene, rays.data(), sizeof(gphys_ray), count, 3, distances.data(),
                                               sizeof(gphys_distance)) == GPHYS_OK);
    REQUIRE(gphys_scene_raycast_all_batch(world.scene, rays.data(), sizeof(gphys_ray), count, 3, nullptr, 0,
                                          offsets.data()) == GPHYS_INCOMPLETE);
    lists.resize(offsets[count]);
    const uint32_t cut = offsets[count] / 2;
    std::vector<gphys_hit> half(cut);
    REQUIRE(gphys_scene_raycast_all_batch(world.scene, rays.data(), sizeof(gphys_ray), count, 3, half.data(), cut,
                                          offsets.data()) == GPHYS_INCOMPLETE);
    REQUIRE(gphys_scene_raycast_all_batch(world.scene, rays.data(), sizeof(gphys_ray), count, 3, lists.data(),
                                          offsets[count], offsets.data()) == GPHYS_OK);
    CHECK(std::equal(half.begin(), half.end(), lists.begin(), same_bits<gphys_hit>));
    for (uint32_t i = 0; i < count; ++i) {
        gphys_hit hit{}, list[200];
        uint32_t total = 0;
        const bool found = gphys_scene_raycast(world.scene, &rays[i], 3, &hit) == GPHYS_OK;
        if (found) REQUIRE(same_bits(hit, hits[i]));
        if (!found) REQUIRE((hits[i].model == 0 && hits[i].t == INFINITY && hits[i].point.x == 0));
        REQUIRE(any[i] == (found ? 1 : 0));
        REQUIRE(same_bits(distances[i], gphys_distance{hits[i].t, hits[i].model, hits[i].triangle}));
        REQUIRE(gphys_scene_raycast_all(world.scene, &rays[i], 3, list, 200, &total) == GPHYS_OK);
        REQUIRE(total == offsets[i + 1] - offsets[i]);
        REQUIRE(std::equal(list, list + total, lists.begin() + offsets[i], same_bits<gphys_hit>));
    }
}

TEST_CASE("a model far away makes a batch of parallel rays neither wrong nor slow") {
    constexpr uint32_t count = 2000;
    test::Random random(37);
    const auto near_point = [&] {
        return gphys_vec3{random.uniform_float(-25, 25), random.uniform_float(-25, 25), random.uniform_float(-25, 25)};
    };
    std::vector<gphys_sphere> balls(count);
    std::vector<gphys_ray> rays(count);
    for (gphys_sphere& ball : balls) ball = {near_point(), random.uniform_float(0.2f, 1)};
    for (gphys_ray& ray : rays) ray = {near_point(), {0, -1, 0}, 10};
    gphys_scene* scenes[2];
    for (gphys_scene*& scene : scenes) {
        gphys_model_id models[count];
        REQUIRE(gphys_scene_create(nullptr, &scene) == GPHYS_OK);
        REQUIRE(gphys_scene_add_batch(scene, GPHYS_SHAPE_SPHERE, balls.data(), sizeof balls[0], nullptr, 0, count,
                                      nullptr, models) == GPHYS_OK);
    }
    const gphys_sphere backdrop = {{50000, 10000, 0}, 10};
    gphys_model_id model;
    REQUIRE(gphys_scene_add(scenes[1], GPHYS_SHAPE_SPHERE, &backdrop, nullptr, nullptr, &model) == GPHYS_OK);

    std::vector<gphys_hit> hits(count);
    std::vector<int32_t> any(count);
    std::clock_t least[2] = {std::numeric_limits<std::clock_t>::max(), std::numeric_limits<std::clock_t>::max()};
    for (int round = 0; round < 5; ++round) {
        for (int far = 0; far < 2; ++far) {
            const std::clock_t begin = std::clock();
            gphys_scene_raycast_batch(scenes[far], rays.data(), sizeof rays[0], count, GPHYS_ALL_LAYERS, hits.data(),
                                      sizeof hits[0]);
            gphys_scene_raycast_any_batch(scenes[far], rays.data(), sizeof rays[0], count, GPHYS_ALL_LAYERS, any.data(),
                                          sizeof any[0]);
            least[far] = std::min(least[far], std::clock() - begin);
        }
    }
    // Where rays that have nothing in common share a traversal all the way, it takes ten times as long.
    CHECK(least[1] < 3 * least[0]);
    uint32_t met = 0;
    for (uint32_t i = 0; i < count; ++i) {
        gphys_hit hit{};
        const bool found = gphys_scene_raycast(scenes[1], &rays[i], GPHYS_ALL_LAYERS, &hit) == GPHYS_OK;
        met += found;
        REQUIRE(any[i] == (found ? 1 : 0));
        if (found) REQUIRE(same_bits(hit, hits[i]));
        if (!found) REQUIRE(hits[i].model == 0);
    }
    CHECK(met > count / 10);
    for (gphys_scene* scene : scenes) gphys_scene_destroy(scene);
}

TEST_CASE("overlaps of a batch are those of single calls, for shapes of every type") {
    RandomScene world(31);
    for (int i = 0; i < 150; ++i) world.add();
    const auto compare = [&](gphys_shape_type type, uint32_t stride, const std::vector<RandomScene::AnyShape>& shapes) {
        std::vector<unsigned char> packed(stride * shapes.size());
        const auto count = static_cast<uint32_t>(shapes.size());
        for (uint32_t i = 0; i < count; ++i) std::memcpy(&packed[size_t{stride} * i], shapes[i].bytes, stride);
        for (const uint32_t layers : {1u, 8u, GPHYS_ALL_LAYERS}) {
            std::vector<gphys_model_id> lists(200 * size_t{count});
            std::vector<uint32_t> offsets(count + 1);
            REQUIRE(gphys_scene_overlap_batch(world.scene, type, packed.data(), stride, count, layers, lists.data(),
                                              200 * count, offsets.data()) == GPHYS_OK);
            for (uint32_t i = 0; i < count; ++i) {
                gphys_model_id alone[200];
                uint32_t total = 0;
                REQUIRE(gphys_scene_overlap(world.scene, type, shapes[i].bytes, layers, alone, 200, &total) ==
                        GPHYS_OK);
                REQUIRE(total == offsets[i + 1] - offsets[i]);
                REQUIRE(std::equal(alone, alone + total, lists.begin() + offsets[i]));
            }
        }
    };
    // Primitives as they come, of which those of each type are a batch.
    std::map<gphys_shape_type, std::vector<RandomScene::AnyShape>> of_type;
    for (int i = 0; i < 600; ++i) {
        const RandomScene::AnyShape shape = world.primitive(12);
        of_type[shape.type].push_back(shape);
    }
    for (int i = 0; i < 100; ++i) {
        RandomScene::AnyShape shape;
        const gphys_vec3 low = world.point(12);
        shape.hold(GPHYS_SHAPE_SPHERE, gphys_sphere{low, 40 * world.size(1) * world.size(1)});
        of_type[shape.type].push_back(shape);
        shape.hold(GPHYS_SHAPE_AABB, gphys_aabb{low, {low.x + world.size(40), low.y + world.size(40), low.z + 20}});
        of_type[shape.type].push_back(shape);
        shape.hold(GPHYS_SHAPE_FRUSTUM, world.frustum());
        of_type[shape.type].push_back(shape);
    }
    REQUIRE(of_type.size() == 7);
    const std::map<gphys_shape_type, uint32_t> sizes = {
        {GPHYS_SHAPE_SPHERE, sizeof(gphys_sphere)},  {GPHYS_SHAPE_CAPSULE, sizeof(gphys_capsule)},
        {GPHYS_SHAPE_AABB, sizeof(gphys_aabb)},      {GPHYS_SHAPE_OBB, sizeof(gphys_obb)},
        {GPHYS_SHAPE_PLANE, sizeof(gphys_plane)},    {GPHYS_SHAPE_TRIANGLE, sizeof(gphys_triangle)},
        {GPHYS_SHAPE_FRUSTUM, sizeof(gphys_frustum)}};
    for (const auto& [type, shapes] : of_type) compare(type, sizes.at(type), shapes);
}

TEST_CASE("queries that begin in many models give the lowest id, and a sweep takes no longer than finding them") {
    const test::SceneFixture at;
    constexpr uint32_t boxes = 300, points = 50;
    test::Random random(31);
    for (uint32_t i = 0; i < boxes; ++i) {
        const float half = 20 + 0.1f * static_cast<float>(i);
        const gphys_aabb box{{-half, -half, -half}, {half, half, half}};
        const gphys_transform place{random.point(3), random.rotation(), 1};
        gphys_model_id id;
        REQUIRE(gphys_scene_add(at.scene, GPHYS_SHAPE_AABB, &box, &place, nullptr, &id) == GPHYS_OK);
    }
    std::vector<gphys_capsule> bodies;
    for (uint32_t i = 0; i < points; ++i) {
        const gphys_vec3 foot = random.point(5);
        bodies.push_back({foot, {foot.x, foot.y + 1, foot.z}, 0.3f});
    }
    const gphys_vec3 way{1, 0, 0};
    gphys_model_id all[boxes];
    gphys_hit hit, ray_hit;
    gphys_nearest nearest;
    uint32_t total;
    // The least of some rounds.
    const auto time = [&](const auto& ask) {
        std::clock_t least = std::numeric_limits<std::clock_t>::max();
        for (int round = 0; round < 5; ++round) {
            const std::clock_t begin = std::clock();
            for (int repeated = 0; repeated < 3; ++repeated) {
                for (const gphys_capsule& body : bodies) REQUIRE(ask(body) == GPHYS_OK);
            }
            least = std::min(least, std::clock() - begin);
        }
        return least;
    };
    const auto list = [&](const gphys_capsule& body) {
        return gphys_scene_overlap(at.scene, GPHYS_SHAPE_CAPSULE, &body, GPHYS_ALL_LAYERS, all, boxes, &total);
    };
    const auto sweep_body = [&](const gphys_capsule& body) {
        return gphys_scene_sweep(at.scene, GPHYS_SHAPE_CAPSULE, &body, &way, GPHYS_ALL_LAYERS, &hit);
    };
    const auto cast_ray = [&](const gphys_capsule& body) {
        const gphys_ray ray{body.a, way, INFINITY};
        return gphys_scene_raycast(at.scene, &ray, GPHYS_ALL_LAYERS, &ray_hit);
    };
    const auto find_nearest = [&](const gphys_capsule& body) {
        return gphys_scene_nearest(at.scene, &body.a, INFINITY, GPHYS_ALL_LAYERS, &nearest);
    };
    for (const gphys_capsule& body : bodies) {
        REQUIRE(list(body) == GPHYS_OK);
        REQUIRE(total == boxes);
        REQUIRE(sweep_body(body) == GPHYS_OK);
        REQUIRE(cast_ray(body) == GPHYS_OK);
        REQUIRE(find_nearest(body) == GPHYS_OK);
        CHECK((hit.model == all[0] && ray_hit.model == all[0] && nearest.model == all[0]));
        CHECK((hit.t == 0 && ray_hit.t == 0 && nearest.distance == 0));
    }
    const std::clock_t lists = time(list);
    // A half; 17 times if each model gets the exact test.
    CHECK(time(sweep_body) < 5 * lists);
}

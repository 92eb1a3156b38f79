// Queries of a scene against all of its models, asked one by one. Of those that are met at the same reported t, or
// are at the same reported distance, the lowest id is the answer.
#include <algorithm>
#include <cmath>
#include <limits>

#include "world.h"

namespace fuzz {
namespace {

constexpr gphys_hit no_hit{0, 0, std::numeric_limits<float>::infinity(), {}, {}, GPHYS_NO_TRIANGLE, 0, 0, 0};
constexpr gphys_nearest no_nearest{0, 0, {}, std::numeric_limits<float>::infinity(), GPHYS_NO_TRIANGLE};

/// All hits, by t, then id. models: by id.
std::vector<gphys_hit> hits_of(const std::vector<PlacedModel>& models, const gphys::Ray& ray) {
    std::vector<gphys_hit> hits;
    for (const PlacedModel& model : models) {
        gphys_hit hit;
        if (raycast(model, ray, hit)) hits.push_back(hit);
    }
    std::stable_sort(hits.begin(), hits.end(), [](const gphys_hit& a, const gphys_hit& b) { return a.t < b.t; });
    return hits;
}

}  // namespace

uint32_t World::mask() { return p_.one_in(3) ? p_.below(8) : GPHYS_ALL_LAYERS; }

std::vector<PlacedModel> World::placed(uint32_t layers) const {
    std::vector<PlacedModel> seen;
    for (const Model& m : models_) {
        if (m.layers & layers) seen.push_back(fuzz::placed(m.id, m.tag, m.world, m.shape, m.source, m.scale));
    }
    return seen;
}

void World::raycast() {
    const gphys_ray ray = p_.ray();
    if (!is_valid(ray)) return;
    const uint32_t layers = mask();
    const std::vector<gphys_hit> expected = hits_of(placed(layers), gphys::widen(ray));
    Output<gphys_hit> hit;
    const gphys_status status = call(gphys_scene_raycast, scene_, &ray, layers, &hit.value);
    hit.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == !expected.empty(), "a ray meets a scene where it meets a model");
    FUZZ_CHECK(expected.empty() || hit.value.t == expected[0].t, "a ray meets a scene where it first meets a model");
    FUZZ_CHECK(expected.empty() || same_bits(hit.value, expected[0]), "raycast gives the first hit of the linear scan");
    int32_t any = -1;
    call(gphys_scene_raycast_any, scene_, &ray, layers, &any);
    FUZZ_CHECK(any == !expected.empty(), "raycast_any agrees with the linear scan");
    const uint32_t capacity = p_.one_in(2) ? 64 : p_.below(3);
    std::vector<gphys_hit> all(capacity + 1);
    uint32_t total = 0;
    const gphys_status listed =
        call(gphys_scene_raycast_all, scene_, &ray, layers, capacity ? all.data() : nullptr, capacity, &total);
    FUZZ_CHECK(listed == (total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK), "a list that is cut short says so");
    FUZZ_CHECK(total == expected.size(), "raycast_all counts the hits of the linear scan");
    for (uint32_t i = 0; i < std::min(total, capacity); ++i) {
        FUZZ_CHECK(same_bits(all[i], expected[i]), "raycast_all lists the hits of the linear scan");
    }
}

void World::segment_test() {
    const gphys_segment segment = p_.segment();
    const uint32_t layers = mask();
    const std::vector<gphys_hit> expected = hits_of(placed(layers), gphys::ray_along(gphys::widen(segment)));
    Output<gphys_hit> hit;
    const gphys_status status = call(gphys_scene_segment_test, scene_, &segment, layers, &hit.value);
    hit.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == !expected.empty(), "a segment meets a scene where it meets a model");
    FUZZ_CHECK(expected.empty() || same_bits(hit.value, expected[0]),
               "segment_test gives the first hit of the linear scan");
}

void World::overlap() {
    const AnyShape query = p_.shape(p_.shape_type(true));
    const uint32_t layers = mask();
    std::vector<gphys_model_id> found(models_.size() + 1);
    uint32_t total = 0;
    gphys_status status = call(gphys_scene_overlap, scene_, query.type, query.bytes, layers, found.data(),
                               static_cast<uint32_t>(models_.size()), &total);
    FUZZ_CHECK(status == GPHYS_OK && total <= models_.size(), "overlap lists each model once");
    found.resize(total);
    for (const gphys_model_id id : found) note(id);
    FUZZ_CHECK(std::is_sorted(found.begin(), found.end()), "overlap lists the models in order");
    for (const PlacedModel& model : placed(layers)) {
        const bool listed = std::binary_search(found.begin(), found.end(), model.id);
        const bool expected = overlaps(model, widened(query));
        total -= listed;
        FUZZ_CHECK(listed == expected || !is_clear(model, widened(query)),
                   "overlap lists the models of the linear scan");
    }
    FUZZ_CHECK(total == 0, "overlap lists models in the layers only");
    const uint32_t capacity = p_.one_in(2) ? 64 : p_.below(3);
    std::vector<gphys_model_id> lowest(capacity + 1);
    status = call(gphys_scene_overlap, scene_, query.type, query.bytes, layers, capacity ? lowest.data() : nullptr,
                  capacity, &total);
    FUZZ_CHECK(status == (total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK), "a list that is cut short says so");
    FUZZ_CHECK(
        total == found.size() && std::equal(found.begin(), found.begin() + std::min(total, capacity), lowest.begin()),
        "what is kept of a list is its beginning");
}

void World::nearest() {
    const gphys_vec3 point = p_.point();
    const uint32_t layers = mask();
    const float within = p_.one_in(2) ? p_.size() : no_nearest.distance;
    gphys_nearest expected = no_nearest;
    for (const PlacedModel& model : placed(layers)) {
        gphys_nearest near;
        if (fuzz::nearest(model, gphys::widen(point), within, near) && near.distance < expected.distance)
            expected = near;
    }
    Output<gphys_nearest> near;
    const gphys_status status = call(gphys_scene_nearest, scene_, &point, within, layers, &near.value);
    near.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == (expected.model != 0), "the nearest model is found where one is near enough");
    if (status != GPHYS_OK) return;
    FUZZ_CHECK(near.value.distance == expected.distance, "the nearest model is as near as that of the linear scan");
    FUZZ_CHECK(same_bits(near.value, expected), "nearest gives the nearest model of the linear scan");
}

void World::sweep() {
    const gphys_sphere sphere{p_.point(), p_.size()};
    const gphys_vec3 displacement = p_.one_in(10) ? gphys_vec3{0, 0, 0} : p_.direction();
    const uint32_t layers = mask();
    gphys_hit expected = no_hit;
    for (const PlacedModel& model : placed(layers)) {
        gphys_hit hit;
        const bool touches = fuzz::sweep(model, gphys::widen(sphere), gphys::widen(displacement), hit);
        if (touches && hit.t < expected.t) expected = hit;
    }
    Output<gphys_hit> hit;
    const gphys_status status = call(gphys_scene_sweep_sphere, scene_, &sphere, &displacement, layers, &hit.value);
    hit.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == (expected.model != 0), "a sweep touches a scene where it touches a model");
    FUZZ_CHECK(status != GPHYS_OK || hit.value.t == expected.t, "a sweep touches when it first touches a model");
    FUZZ_CHECK(status != GPHYS_OK || same_bits(hit.value, expected), "sweep gives the first of the linear scan");
}

AnyShape World::solid() {
    constexpr gphys_shape_type types[] = {GPHYS_SHAPE_SPHERE, GPHYS_SHAPE_CAPSULE, GPHYS_SHAPE_AABB, GPHYS_SHAPE_OBB};
    return p_.shape(types[p_.below(4)]);
}

void World::sweep_solid() {
    const AnyShape moving = solid();
    const gphys_vec3 displacement = p_.one_in(10) ? gphys_vec3{0, 0, 0} : p_.direction();
    const uint32_t layers = mask();
    Output<gphys_hit> hit;
    const gphys_status status =
        call(gphys_scene_sweep, scene_, moving.type, moving.bytes, &displacement, layers, &hit.value);
    hit.after(status);
    FUZZ_CHECK((status >= 0) == is_valid(moving), "a scene is swept by valid solids only");
    if (status < 0) return;
    gphys_hit expected = no_hit, batch[2];
    for (const PlacedModel& model : placed(layers)) {
        gphys_hit other;
        const bool touches = fuzz::sweep(model, widened(moving), gphys::widen(displacement), other);
        if (touches && other.t < expected.t) expected = other;
    }
    FUZZ_CHECK((status == GPHYS_OK) == (expected.model != 0), "a sweep touches a scene where it touches a model");
    FUZZ_CHECK(status != GPHYS_OK || same_bits(hit.value, expected), "sweep gives the first of the linear scan");
    call(gphys_scene_sweep_batch, scene_, moving.type, moving.bytes, 0u, &displacement, 0u, 2u, layers, batch,
         uint32_t{sizeof(gphys_hit)});
    FUZZ_CHECK(same_bits(batch[0], expected) && same_bits(batch[1], expected), "sweep_batch gives the bits of sweep");
}

void World::ways_out() {
    const AnyShape moving = solid();
    const uint32_t layers = mask(), room = p_.below(12);
    std::vector<gphys_penetration> expected, found(64), deepest(room + 1);
    uint32_t total = 0;
    const gphys_status status = call(gphys_scene_penetration, scene_, moving.type, moving.bytes, layers, found.data(),
                                     static_cast<uint32_t>(found.size()), &total);
    FUZZ_CHECK((status >= 0) == is_valid(moving), "a valid solid gets out");
    if (status < 0) return;
    for (const PlacedModel& model : placed(layers)) {
        if (!has_clear_parts(model, widened(moving))) return;
        add_ways_out(model, widened(moving), expected);
    }
    std::sort(expected.begin(), expected.end(), gphys::DeepestFirst());
    found.resize(std::min(total, uint32_t{64}));
    FUZZ_CHECK(total == expected.size(), "a scene lists what is overlapped");
    const auto agree = [&](const std::vector<gphys_penetration>& list, size_t count) {
        for (size_t i = 0; i < count; ++i) FUZZ_CHECK(same_bits(list[i], expected[i]), "the deepest come first");
    };
    agree(found, found.size());
    call(gphys_scene_penetration, scene_, moving.type, moving.bytes, layers, room ? deepest.data() : nullptr, room,
         &total);
    agree(deepest, std::min<size_t>(room, total));
    uint32_t offsets[3];
    std::vector<gphys_penetration> twice(2 * expected.size() + 1);
    call(gphys_scene_penetration_batch, scene_, moving.type, moving.bytes, 0u, 2u, layers, twice.data(), 2 * total,
         offsets);
    FUZZ_CHECK(offsets[0] == 0 && offsets[1] == total && offsets[2] == 2 * total, "each of a batch has its list");
    agree(twice, total);
    agree({twice.begin() + total, twice.end()}, total);
}

void World::cull() {
    const gphys_frustum frustum = p_.frustum();
    const AnyShape any = AnyShape::of(GPHYS_SHAPE_FRUSTUM, frustum);
    const uint32_t layers = mask();
    std::vector<gphys_model_id> found(64);
    uint32_t total = 0;
    const gphys_status status = call(gphys_scene_cull, scene_, &frustum, layers, found.data(), 64u, &total);
    FUZZ_CHECK((status >= 0) == is_valid(any), "cull takes valid frusta only");
    if (status < 0) return;
    found.resize(total);
    for (const gphys_model_id id : found) note(id);
    FUZZ_CHECK(std::is_sorted(found.begin(), found.end()), "cull lists the models in order");
    for (const PlacedModel& model : placed(layers)) {
        const bool kept = std::binary_search(found.begin(), found.end(), model.id);
        FUZZ_CHECK(kept || !overlaps(model, widened(any)) || !is_clear(model, widened(any)),
                   "cull misses nothing that is seen");
    }
    const uint32_t room = p_.below(12);
    std::vector<gphys_model_id> lowest(room + 1);
    call(gphys_scene_cull, scene_, &frustum, layers, room ? lowest.data() : nullptr, room, &total);
    FUZZ_CHECK(
        total == found.size() && std::equal(found.begin(), found.begin() + std::min(total, room), lowest.begin()),
        "what is kept of a list is its beginning");
    std::vector<gphys_model_id> twice(2 * total + 1), expected = found;
    expected.insert(expected.end(), found.begin(), found.end());
    uint32_t offsets[3];
    call(gphys_scene_cull_batch, scene_, &frustum, 0u, 2u, layers, twice.data(), 2 * total, offsets);
    twice.resize(2 * total);
    FUZZ_CHECK(offsets[0] == 0 && offsets[1] == total && offsets[2] == 2 * total && twice == expected,
               "cull_batch lists what cull does");
}

void World::ray_batches() {
    const uint32_t count = p_.below(80), layers = mask();
    std::vector<gphys_ray> rays(count + 1);
    std::vector<gphys_segment> segments(count + 1);
    const bool image = p_.one_in(2);  // rows of neighbours, which share walks
    const gphys_ray corner = p_.ray();
    for (uint32_t i = 0; i < count; ++i) {
        rays[i] = image ? corner : p_.ray();
        if (image) rays[i].direction.x += static_cast<float>(i % 8) / 16;
        if (image) rays[i].direction.y += static_cast<float>(i / 8) / 16;
        segments[i] = p_.segment();
        if (!is_valid(rays[i])) return;
    }
    std::vector<gphys_hit> hits(count + 1), segment_hits(count + 1), all(64 * size_t{count} + 1);
    std::vector<gphys_distance> distances(count + 1);
    std::vector<int32_t> any(count + 1);
    std::vector<uint32_t> offsets(count + 1);
    const uint32_t ray_size = sizeof(gphys_ray), hit_size = sizeof(gphys_hit);
    FUZZ_CHECK(call(gphys_scene_raycast_batch, scene_, rays.data(), ray_size, count, layers, hits.data(), hit_size) ==
                   GPHYS_OK,
               "a batch of valid rays is answered");
    call(gphys_scene_raycast_any_batch, scene_, rays.data(), ray_size, count, layers, any.data(), 4u);
    call(gphys_scene_raycast_distance_batch, scene_, rays.data(), ray_size, count, layers, distances.data(),
         uint32_t{sizeof(gphys_distance)});
    call(gphys_scene_raycast_all_batch, scene_, rays.data(), ray_size, count, layers, all.data(), 64 * count,
         offsets.data());
    call(gphys_scene_segment_test_batch, scene_, segments.data(), uint32_t{sizeof(gphys_segment)}, count, layers,
         segment_hits.data(), hit_size);
    for (uint32_t i = 0; i < count; ++i) {
        gphys_hit single = no_hit, of_segment = no_hit, first[64];
        uint32_t total = 0;
        call(gphys_scene_raycast, scene_, &rays[i], layers, &single);
        note(hits[i]);
        FUZZ_CHECK(same_bits(single, hits[i]), "raycast_batch gives the bits of raycast");
        FUZZ_CHECK(any[i] == (single.model != 0), "raycast_any_batch agrees with raycast");
        FUZZ_CHECK(same_bits(distances[i], gphys_distance{single.t, single.model, single.triangle}),
                   "raycast_distance_batch gives the bits of raycast");
        call(gphys_scene_segment_test, scene_, &segments[i], layers, &of_segment);
        FUZZ_CHECK(same_bits(of_segment, segment_hits[i]), "segment_test_batch gives the bits of segment_test");
        call(gphys_scene_raycast_all, scene_, &rays[i], layers, first, 64u, &total);
        FUZZ_CHECK(offsets[i + 1] - offsets[i] == total, "raycast_all_batch counts as raycast_all does");
        FUZZ_CHECK(std::equal(first, first + total, all.begin() + offsets[i], same_bits<gphys_hit>),
                   "raycast_all_batch gives the bits of raycast_all");
    }
}

void World::other_batches() {
    const uint32_t count = p_.below(20), layers = mask();
    std::vector<gphys_vec3> points(count + 1), displacements(count + 1);
    std::vector<gphys_sphere> spheres(count + 1);
    std::vector<AnyShape> shapes(count + 1);
    const gphys_shape_type type = p_.shape_type(true);
    for (uint32_t i = 0; i <= count; ++i) {
        points[i] = p_.point();
        displacements[i] = p_.direction();
        spheres[i] = {p_.point(), p_.size()};
        shapes[i] = p_.shape(type);
    }
    const uint32_t point_stride = p_.one_in(6) ? 0 : 12;
    const float within = p_.one_in(2) ? p_.size() : no_nearest.distance;
    std::vector<gphys_nearest> near(count + 1);
    std::vector<gphys_hit> hits(count + 1);
    std::vector<gphys_model_id> found(64 * size_t{count} + 1);
    std::vector<uint32_t> offsets(count + 1);
    call(gphys_scene_nearest_batch, scene_, points.data(), point_stride, count, within, layers, near.data(),
         uint32_t{sizeof(gphys_nearest)});
    call(gphys_scene_sweep_sphere_batch, scene_, spheres.data(), uint32_t{sizeof(gphys_sphere)}, displacements.data(),
         12u, count, layers, hits.data(), uint32_t{sizeof(gphys_hit)});
    call(gphys_scene_overlap_batch, scene_, type, shapes[0].bytes, uint32_t{sizeof(AnyShape)}, count, layers,
         found.data(), 64 * count, offsets.data());
    for (uint32_t i = 0; i < count; ++i) {
        gphys_nearest single = no_nearest;
        gphys_hit hit = no_hit;
        gphys_model_id models[64];
        uint32_t total = 0;
        call(gphys_scene_nearest, scene_, &points[point_stride ? i : 0], within, layers, &single);
        FUZZ_CHECK(same_bits(single, near[i]), "nearest_batch gives the bits of nearest");
        call(gphys_scene_sweep_sphere, scene_, &spheres[i], &displacements[i], layers, &hit);
        FUZZ_CHECK(same_bits(hit, hits[i]), "sweep_sphere_batch gives the bits of sweep_sphere");
        call(gphys_scene_overlap, scene_, type, shapes[i].bytes, layers, models, 64u, &total);
        FUZZ_CHECK(
            offsets[i + 1] - offsets[i] == total && std::equal(models, models + total, found.begin() + offsets[i]),
            "overlap_batch lists what overlap does");
    }
}

void World::query_misuse() {
    gphys_ray ray = p_.ray();
    p_.spoil(ray, 2);
    gphys_vec3 point = p_.point();
    p_.spoil(point, 2);
    AnyShape shape = p_.shape(p_.shape_type(true));
    p_.spoil(shape, 2);
    const float within = p_.hostile();
    Output<gphys_hit> hit;
    Output<gphys_nearest> near;
    uint32_t total = 0;
    gphys_model_id id = 0;
    const gphys_status cast = call(gphys_scene_raycast, scene_, &ray, 7u, &hit.value);
    hit.after(cast);
    FUZZ_CHECK((cast >= 0) == is_valid(ray), "a scene takes valid rays only");
    const gphys_status found = call(gphys_scene_nearest, scene_, &point, within, 7u, &near.value);
    near.after(found);
    FUZZ_CHECK((found >= 0) == (is_valid(point) && within >= 0), "nearest takes valid input only");
    const gphys_status met = call(gphys_scene_overlap, scene_, shape.type, shape.bytes, 7u, &id, 1u, &total);
    FUZZ_CHECK((met >= 0) == is_valid(shape), "a scene takes valid shapes only");
    const gphys_scene* none = nullptr;
    const gphys_sphere ball{{0, 0, 0}, 1};
    const gphys_vec3 zero{0, 0, 0};
    const gphys_ray good{{0, 0, 0}, {1, 0, 0}, 1};
    const gphys_segment segment{{0, 0, 0}, {1, 0, 0}};
    const uint32_t bad_stride = 1 + p_.below(3);
    gphys_hit out;
    gphys_distance distance;
    gphys_nearest nearest_out;
    int32_t any = 0;
    const gphys_status refused[] = {
        call(gphys_scene_raycast, none, &good, 7u, &out),
        call(gphys_scene_raycast, scene_, nullptr, 7u, &out),
        call(gphys_scene_raycast_any, scene_, &good, 7u, nullptr),
        call(gphys_scene_raycast_all, scene_, &good, 7u, &out, 1u, nullptr),
        call(gphys_scene_raycast_batch, scene_, &good, bad_stride, 1u, 7u, &out, 56u),
        call(gphys_scene_raycast_batch, scene_, &good, 28u, 1u, 7u, &out, bad_stride),
        call(gphys_scene_raycast_any_batch, scene_, nullptr, 28u, 1u, 7u, &any, 4u),
        call(gphys_scene_raycast_distance_batch, scene_, &good, 28u, 1u, 7u, &distance, bad_stride),
        call(gphys_scene_raycast_all_batch, scene_, &good, 28u, 1u, 7u, &out, 1u, nullptr),
        call(gphys_scene_segment_test, scene_, &segment, 7u, nullptr),
        call(gphys_scene_segment_test_batch, scene_, &segment, bad_stride, 1u, 7u, &out, 56u),
        call(gphys_scene_overlap, scene_, gphys_shape_type{99}, &ball, 7u, &id, 1u, &total),
        call(gphys_scene_overlap_batch, scene_, gphys_shape_type{GPHYS_SHAPE_SPHERE}, nullptr, 16u, 1u, 7u, &id, 1u,
             &total),
        call(gphys_scene_nearest_batch, none, &zero, 12u, 1u, 1.0f, 7u, &nearest_out, 28u),
        call(gphys_scene_sweep_sphere, scene_, &ball, nullptr, 7u, &out),
        call(gphys_scene_sweep_sphere_batch, scene_, &ball, 16u, &zero, bad_stride, 1u, 7u, &out, 56u),
        call(gphys_scene_sweep, scene_, gphys_shape_type{GPHYS_SHAPE_PLANE}, &ball, &zero, 7u, &out),
        call(gphys_scene_sweep_batch, scene_, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &ball, 16u, &zero, bad_stride, 1u,
             7u, &out, 56u),
        call(gphys_scene_penetration, none, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &ball, 7u, nullptr, 0u, &total),
        call(gphys_scene_penetration_batch, scene_, gphys_shape_type{GPHYS_SHAPE_SPHERE}, &ball, bad_stride, 1u, 7u,
             nullptr, 0u, &total),
        call(gphys_scene_cull, scene_, nullptr, 7u, &id, 1u, &total),
        call(gphys_scene_cull_batch, scene_, nullptr, 0u, 1u, 7u, &id, 1u, &total)};
    for (const gphys_status status : refused) FUZZ_CHECK(status < 0, "a call that makes no sense is refused");
}

}  // namespace fuzz

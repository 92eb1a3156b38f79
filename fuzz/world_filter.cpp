// Queries that leave out models against lists of all, of which those are taken away.
#include <algorithm>
#include <limits>

#include "world.h"

namespace fuzz {
namespace {

constexpr gphys_hit no_hit{0, 0, std::numeric_limits<float>::infinity(), {}, {}, GPHYS_NO_TRIANGLE, 0, 0, 0};
constexpr gphys_nearest no_nearest{0, 0, {}, std::numeric_limits<float>::infinity(), GPHYS_NO_TRIANGLE};

}  // namespace

/// A filter and the array that it points to; ids in it may be stale, or stand twice.
void World::make_filter(gphys_query_filter_desc& filter, std::vector<gphys_model_id>& list) {
    call(gphys_query_filter_desc_init, &filter, uint32_t{sizeof filter});
    filter.layers = mask();
    if (p_.one_in(2)) filter.ignored_model = any_id();
    if (p_.one_in(2)) filter.flags = GPHYS_FILTER_SUBTREE;
    list.clear();
    for (uint32_t i = p_.one_in(2) ? p_.below(40) : p_.below(3); i > 0; --i) list.push_back(any_id());
    if (p_.one_in(2)) std::sort(list.begin(), list.end());
    filter.ignored_models = list.empty() ? nullptr : list.data();
    filter.ignored_count = static_cast<uint32_t>(list.size());
}

bool World::is_left_out(gphys_model_id id, const gphys_query_filter_desc& filter) const {
    const gphys_model_id* end = filter.ignored_models + filter.ignored_count;
    if (id == filter.ignored_model || std::find(filter.ignored_models, end, id) != end) return true;
    return (filter.flags & GPHYS_FILTER_SUBTREE) && model(filter.ignored_model) && is_below(id, filter.ignored_model);
}

void World::filtered_queries() {
    gphys_query_filter_desc filter;
    std::vector<gphys_model_id> ignored;
    make_filter(filter, ignored);
    const auto is_out = [&](gphys_model_id id) { return is_left_out(id, filter); };
    const uint32_t room = static_cast<uint32_t>(models_.size()) + 1;
    const gphys_ray ray = p_.ray();
    if (!is_valid(ray)) return;
    std::vector<gphys_hit> all(room), rest(room);
    uint32_t all_count = 0, rest_count = 0;
    call(gphys_scene_raycast_all, scene_, &ray, filter.layers, all.data(), room, &all_count);
    call(gphys_scene_raycast_all_filtered, scene_, &ray, &filter, rest.data(), room, &rest_count);
    all.resize(all_count);
    all.erase(std::remove_if(all.begin(), all.end(), [&](const gphys_hit& hit) { return is_out(hit.model); }),
              all.end());
    FUZZ_CHECK(all.size() == rest_count && std::equal(all.begin(), all.end(), rest.begin(), same_bits<gphys_hit>),
               "raycast_all_filtered lists what raycast_all does without the ignored");
    Output<gphys_hit> hit;
    const gphys_status status = call(gphys_scene_raycast_filtered, scene_, &ray, &filter, &hit.value);
    hit.after(status);
    FUZZ_CHECK((status == GPHYS_OK) == !all.empty() && (all.empty() || same_bits(hit.value, all[0])),
               "raycast_filtered gives the first hit of the list");
    int32_t any = -1;
    call(gphys_scene_raycast_any_filtered, scene_, &ray, &filter, &any);
    FUZZ_CHECK(any == !all.empty(), "raycast_any_filtered agrees with the list");

    const AnyShape query = p_.shape(p_.shape_type(true));
    std::vector<gphys_model_id> found(room), kept(room);
    const auto same_list = [&](gphys_status plain, gphys_status other, const char* rule) {
        if (plain < 0 || other < 0) return;
        found.resize(all_count);
        kept.resize(rest_count);
        found.erase(std::remove_if(found.begin(), found.end(), is_out), found.end());
        FUZZ_CHECK(found == kept, rule);
        found.resize(room);
        kept.resize(room);
    };
    gphys_status plain =
        call(gphys_scene_overlap, scene_, query.type, query.bytes, filter.layers, found.data(), room, &all_count);
    gphys_status other =
        call(gphys_scene_overlap_filtered, scene_, query.type, query.bytes, &filter, kept.data(), room, &rest_count);
    same_list(plain, other, "overlap_filtered lists what overlap does without the ignored");
    const gphys_frustum frustum = p_.frustum();
    plain = call(gphys_scene_cull, scene_, &frustum, filter.layers, found.data(), room, &all_count);
    other = call(gphys_scene_cull_filtered, scene_, &frustum, &filter, kept.data(), room, &rest_count);
    same_list(plain, other, "cull_filtered lists what cull does without the ignored");
    if (other >= 0) {
        std::vector<gphys_model_id> batch(room);
        uint32_t ends[2] = {};
        call(gphys_scene_cull_filtered_batch, scene_, &frustum, 0u, 1u, &filter, 0u, batch.data(), room, ends);
        FUZZ_CHECK(ends[1] == rest_count && std::equal(kept.begin(), kept.begin() + rest_count, batch.begin()),
                   "cull_filtered_batch lists what cull_filtered does");
    }

    // The others have no list: what they name is seen.
    const gphys_segment segment = p_.segment();
    gphys_hit met = no_hit;
    call(gphys_scene_segment_test_filtered, scene_, &segment, &filter, &met);
    FUZZ_CHECK(met.model == 0 || !is_out(met.model), "segment_test_filtered names no model that is ignored");
    const gphys_sphere sphere{p_.point(), p_.size()};
    const gphys_vec3 displacement = p_.direction();
    call(gphys_scene_sweep_sphere_filtered, scene_, &sphere, &displacement, &filter, &met);
    FUZZ_CHECK(met.model == 0 || !is_out(met.model), "sweep_sphere_filtered names no model that is ignored");
    const gphys_obb box{p_.point(), {p_.size(), p_.size(), p_.size()}, {0, 0, 0, 1}};
    const gphys_status moved =
        call(gphys_scene_sweep_filtered, scene_, GPHYS_SHAPE_OBB, &box, &displacement, &filter, &met);
    FUZZ_CHECK(met.model == 0 || !is_out(met.model), "sweep_filtered names no model that is ignored");
    gphys_hit moved_in_batch = no_hit;
    const gphys_status all_moved =
        call(gphys_scene_sweep_filtered_batch, scene_, GPHYS_SHAPE_OBB, &box, 0u, &displacement, 0u, 1u, &filter, 0u,
             &moved_in_batch, uint32_t{sizeof(gphys_hit)});
    FUZZ_CHECK(moved != GPHYS_OK || all_moved != GPHYS_OK || same_bits(met, moved_in_batch),
               "sweep_filtered_batch gives the single call's bits");
    gphys_penetration ways[4]{};
    uint32_t way_count = 0;
    call(gphys_scene_penetration_filtered, scene_, GPHYS_SHAPE_OBB, &box, &filter, ways, 4u, &way_count);
    for (uint32_t i = 0; i < std::min(way_count, 4u); ++i)
        FUZZ_CHECK(!is_out(ways[i].model), "penetration_filtered names no model that is ignored");
    gphys_penetration ways_in_batch[4]{};
    uint32_t offsets[2] = {};
    call(gphys_scene_penetration_filtered_batch, scene_, GPHYS_SHAPE_OBB, &box, 0u, 1u, &filter, 0u, ways_in_batch, 4u,
         offsets);
    FUZZ_CHECK(offsets[1] == way_count && (way_count > 4 || same_bits(ways, ways_in_batch)),
               "penetration_filtered_batch gives the single call's bits");
    const gphys_vec3 point = p_.point();
    gphys_nearest near = no_nearest;
    call(gphys_scene_nearest_filtered, scene_, &point, near.distance, &filter, &near);
    const bool some = std::any_of(models_.begin(), models_.end(), [&](const Model& m) {
        return (m.layers & filter.layers) && m.shape.type != GPHYS_SHAPE_MESH && !is_out(m.id);
    });
    FUZZ_CHECK(near.model != 0 || !some, "nearest_filtered finds a model if it sees one");
    FUZZ_CHECK(near.model == 0 || !is_out(near.model), "nearest_filtered names no model that is ignored");
    if (!camera_) return create_camera();
    plain = call(gphys_camera_pick_rectangle, camera_, scene_, 1.0f, 2.0f, 300.0f, 400.0f, filter.layers, found.data(),
                 room, &all_count);
    other = call(gphys_camera_pick_rectangle_filtered, camera_, scene_, 1.0f, 2.0f, 300.0f, 400.0f, &filter,
                 kept.data(), room, &rest_count);
    same_list(plain, other, "pick_rectangle_filtered lists what pick_rectangle does without the ignored");
    plain = call(gphys_camera_cull, camera_, scene_, filter.layers, found.data(), room, &all_count);
    other = call(gphys_camera_cull_filtered, camera_, scene_, &filter, kept.data(), room, &rest_count);
    same_list(plain, other, "cull_filtered of a camera lists what cull does without the ignored");
    met = no_hit;
    call(gphys_camera_pick_filtered, camera_, scene_, 200.0f, 150.0f, &filter, &met);
    FUZZ_CHECK(met.model == 0 || !is_out(met.model), "pick_filtered names no model that is ignored");
}

void World::filtered_batches() {
    const uint32_t count = 1 + p_.below(40);
    const bool one_for_all = p_.one_in(2);
    std::vector<gphys_query_filter_desc> filters(count);
    std::vector<std::vector<gphys_model_id>> ignored(count);
    std::vector<gphys_ray> rays(count);
    std::vector<gphys_segment> segments(count);
    std::vector<gphys_sphere> spheres(count);
    std::vector<gphys_vec3> points(count), displacements(count);
    std::vector<float> pixels(2 * size_t{count});
    for (uint32_t i = 0; i < count; ++i) {
        if (i == 0 || !one_for_all) {
            make_filter(filters[i], ignored[i]);
            filters[i].flags |= 2 * p_.below(4);  // faces
        }
        rays[i] = p_.ray();
        if (!is_valid(rays[i])) return;
        segments[i] = p_.segment();
        spheres[i] = {p_.point(), p_.size()};
        points[i] = p_.point();
        displacements[i] = p_.direction();
        pixels[2 * i] = static_cast<float>(p_.below(800));
        pixels[2 * i + 1] = static_cast<float>(p_.below(600));
    }
    const uint32_t stride = one_for_all ? 0 : sizeof(gphys_query_filter_desc), hit_size = sizeof(gphys_hit);
    const gphys_query_filter_desc* given = filters.data();
    std::vector<gphys_hit> hits(count), segment_hits(count), sweeps(count), all(64 * size_t{count}), picks(count);
    std::vector<gphys_nearest> near(count);
    std::vector<gphys_model_id> met(64 * size_t{count});
    std::vector<gphys_distance> distances(count);
    std::vector<int32_t> any(count);
    std::vector<uint32_t> hit_ends(count + 1), met_ends(count + 1);
    const gphys_shape_type ball = GPHYS_SHAPE_SPHERE;
    call(gphys_scene_raycast_filtered_batch, scene_, rays.data(), uint32_t{sizeof(gphys_ray)}, count, given, stride,
         hits.data(), hit_size);
    call(gphys_scene_raycast_any_filtered_batch, scene_, rays.data(), uint32_t{sizeof(gphys_ray)}, count, given, stride,
         any.data(), 4u);
    call(gphys_scene_raycast_distance_filtered_batch, scene_, rays.data(), uint32_t{sizeof(gphys_ray)}, count, given,
         stride, distances.data(), uint32_t{sizeof(gphys_distance)});
    call(gphys_scene_raycast_all_filtered_batch, scene_, rays.data(), uint32_t{sizeof(gphys_ray)}, count, given, stride,
         all.data(), 64 * count, hit_ends.data());
    call(gphys_scene_segment_test_filtered_batch, scene_, segments.data(), uint32_t{sizeof(gphys_segment)}, count,
         given, stride, segment_hits.data(), hit_size);
    call(gphys_scene_overlap_filtered_batch, scene_, ball, spheres.data(), uint32_t{sizeof(gphys_sphere)}, count, given,
         stride, met.data(), 64 * count, met_ends.data());
    call(gphys_scene_nearest_filtered_batch, scene_, points.data(), 12u, count, 5.0f, given, stride, near.data(),
         uint32_t{sizeof(gphys_nearest)});
    call(gphys_scene_sweep_sphere_filtered_batch, scene_, spheres.data(), uint32_t{sizeof(gphys_sphere)},
         displacements.data(), 12u, count, given, stride, sweeps.data(), hit_size);
    const gphys_status picked = camera_ ? call(gphys_camera_pick_filtered_batch, camera_, scene_, pixels.data(), 8u,
                                               count, given, stride, picks.data(), hit_size)
                                        : GPHYS_NO_HIT;
    for (uint32_t i = 0; i < count; ++i) {
        const gphys_query_filter_desc* filter = &filters[one_for_all ? 0 : i];
        gphys_hit hit = no_hit, first[64];
        gphys_model_id models[64];
        uint32_t total = 0;
        call(gphys_scene_raycast_filtered, scene_, &rays[i], filter, &hit);
        FUZZ_CHECK(same_bits(hit, hits[i]), "raycast_filtered_batch gives the bits of raycast_filtered");
        FUZZ_CHECK(any[i] == (hit.model != 0), "raycast_any_filtered_batch agrees with raycast_filtered");
        FUZZ_CHECK(same_bits(distances[i], gphys_distance{hit.t, hit.model, hit.triangle}),
                   "raycast_distance_filtered_batch gives the bits of raycast_filtered");
        call(gphys_scene_raycast_all_filtered, scene_, &rays[i], filter, first, 64u, &total);
        FUZZ_CHECK(hit_ends[i + 1] - hit_ends[i] == total &&
                       std::equal(first, first + total, all.begin() + hit_ends[i], same_bits<gphys_hit>),
                   "raycast_all_filtered_batch gives the bits of raycast_all_filtered");
        hit = no_hit;
        call(gphys_scene_segment_test_filtered, scene_, &segments[i], filter, &hit);
        FUZZ_CHECK(same_bits(hit, segment_hits[i]), "segment_test_filtered_batch gives the bits of the single call");
        call(gphys_scene_overlap_filtered, scene_, ball, &spheres[i], filter, models, 64u, &total);
        FUZZ_CHECK(
            met_ends[i + 1] - met_ends[i] == total && std::equal(models, models + total, met.begin() + met_ends[i]),
            "overlap_filtered_batch lists what overlap_filtered does");
        gphys_nearest single = no_nearest;
        call(gphys_scene_nearest_filtered, scene_, &points[i], 5.0f, filter, &single);
        FUZZ_CHECK(same_bits(single, near[i]), "nearest_filtered_batch gives the bits of nearest_filtered");
        hit = no_hit;
        call(gphys_scene_sweep_sphere_filtered, scene_, &spheres[i], &displacements[i], filter, &hit);
        FUZZ_CHECK(same_bits(hit, sweeps[i]), "sweep_sphere_filtered_batch gives the bits of the single call");
        if (picked != GPHYS_OK) continue;
        hit = no_hit;
        call(gphys_camera_pick_filtered, camera_, scene_, pixels[2 * i], pixels[2 * i + 1], filter, &hit);
        FUZZ_CHECK(same_bits(hit, picks[i]), "pick_filtered_batch gives the bits of pick_filtered");
    }
}

}  // namespace fuzz

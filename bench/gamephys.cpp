// gamephys through its public interface, as a user links it.
#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "implementation.h"

namespace bench {

namespace {

void check(gphys_status status) {
    if (status < 0) throw std::runtime_error(gphys_last_error());
}

const gphys_transform identity{{0, 0, 0}, {0, 0, 0, 1}, 1};

/// What a batch gives for a ray that hits nothing.
const gphys_hit nothing = [] {
    gphys_hit hit{};
    hit.t = INFINITY;
    hit.triangle = GPHYS_NO_TRIANGLE;
    return hit;
}();

/// Counts, and otherwise does as the library does without hooks (src/foundation/memory.cpp): large blocks ask for huge
/// pages, as those of Embree do.
void* allocate(void* heap, size_t size, size_t alignment) {
    constexpr size_t huge_page = size_t{1} << 21;
    if (size >= huge_page) alignment = std::max(alignment, huge_page);
    void* const memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (!memory) return nullptr;
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (size >= huge_page) madvise(memory, size / huge_page * huge_page, MADV_HUGEPAGE);
#endif
    static_cast<Heap*>(heap)->add(static_cast<int64_t>(size));
    return memory;
}
void release(void* heap, void* memory, size_t size, size_t) {
    static_cast<Heap*>(heap)->add(-static_cast<int64_t>(size));
    std::free(memory);
}

class Gamephys final : public Implementation {
public:
    Gamephys(uint32_t worker_count, uint32_t callers, bool counted)
        : worker_count_(worker_count), callers_(callers), counted_(counted) {}
    ~Gamephys() override { clear(); }

    bool load(const std::vector<gphys_obb>& boxes) override {
        // A box in its own coordinates, placed by the model's transform: what moves is the model.
        std::vector<gphys_aabb> shapes(boxes.size());
        for (size_t i = 0; i < boxes.size(); ++i) {
            const gphys_vec3 h = boxes[i].half_extents;
            shapes[i] = {{-h.x, -h.y, -h.z}, h};
        }
        place(boxes);
        add(GPHYS_SHAPE_AABB, shapes.data(), sizeof shapes[0], transforms_);
        return true;
    }

    bool load(const std::vector<gphys_sphere>& spheres) override {
        add(GPHYS_SHAPE_SPHERE, spheres.data(), sizeof spheres[0],
            std::vector<gphys_transform>(spheres.size(), identity));
        return true;
    }

    bool load(const std::vector<gphys_vec3>& points) override {
        std::vector<gphys_sphere> spheres;
        for (const gphys_vec3& point : points) spheres.push_back({point, 0});
        return load(spheres);
    }

    uint64_t save() override {
        uint32_t total = 0;
        const auto copy = [&](uint32_t* words, uint32_t capacity) {
            return mesh_ ? gphys_mesh_get_snapshot(mesh_, words, capacity, &total)
                         : gphys_scene_get_snapshot(scene_, 1, words, capacity, &total);
        };
        if (copy(saved_.data(), static_cast<uint32_t>(saved_.size())) == GPHYS_INCOMPLETE) {
            saved_.resize(total);
            check(copy(saved_.data(), total));
        }
        saved_.resize(total);
        return uint64_t{4} * total;
    }
    bool load_saved() override {
        const auto count = static_cast<uint32_t>(saved_.size());
        if (!mesh_) {
            check(gphys_scene_restore(scene_, nullptr, saved_.data(), count));
            return true;
        }
        gphys_mesh_destroy(mesh_);
        mesh_ = nullptr;
        check(gphys_mesh_create_from_snapshot(nullptr, saved_.data(), count, &mesh_));
        return true;
    }
    bool load(const Triangles& mesh) override {
        clear();
        create_mesh(mesh);
        return true;
    }

    bool load(const Triangles& mesh, const std::vector<gphys_transform>& placements) override {
        clear();
        create_mesh(mesh);
        gphys_mesh* shared = mesh_;
        mesh_ = nullptr;
        add(GPHYS_SHAPE_MESH, shared, 0, placements);
        gphys_mesh_destroy(shared);
        return true;
    }

    bool load(const Triangles& mesh, const std::vector<Stretched>& stretched) override {
        std::vector<gphys_transform> places;
        for (const Stretched& s : stretched) places.push_back(s.place);
        load(mesh, places);
        for (size_t i = 0; i < stretched.size(); ++i) {
            check(gphys_scene_set_scale(scene_, models_[i], &stretched[i].scale));
        }
        return true;
    }

    bool load_hull(const Triangles& mesh, const std::vector<gphys_transform>& placements) override {
        clear();
        gphys_mesh* hull = nullptr;
        check(gphys_mesh_create_hull(nullptr, &mesh.vertices[0].x, sizeof mesh.vertices[0],
                                     static_cast<uint32_t>(mesh.vertices.size()), &hull));
        add(GPHYS_SHAPE_MESH, hull, 0, placements);
        gphys_mesh_destroy(hull);
        return true;
    }

    bool load_deformable(const Triangles& mesh) override {
        clear();
        create_mesh(mesh, 1);
        return true;
    }

    bool deform(const std::vector<gphys_vec3>& vertices) override {
        check(
            gphys_mesh_set_vertices(mesh_, &vertices[0].x, sizeof vertices[0], static_cast<uint32_t>(vertices.size())));
        return true;
    }

    bool load_body(gphys_solver* solver, gphys_body_id body) override {
        clear();
        gphys_mesh* mesh = nullptr;
        check(gphys_mesh_create_from_body(nullptr, solver, body, &mesh));
        add(GPHYS_SHAPE_MESH, mesh, 0, {identity});
        gphys_mesh_destroy(mesh);
        return true;
    }

    uint64_t memory() const override { return heap_.now(); }
    uint64_t peak_memory() const override { return heap_.peak(); }

    bool closest_singly(const std::vector<gphys_ray>& rays) override {
        if (callers_ != 1 || worker_count_ != 1) return false;
        start_hits(rays.size());
        for (size_t i = 0; i < rays.size(); ++i) {
            const gphys_status status = mesh_ ? gphys_shape_raycast(GPHYS_SHAPE_MESH, mesh_, &rays[i], &hits_[i])
                                              : gphys_scene_raycast(scene_, &rays[i], GPHYS_ALL_LAYERS, &hits_[i]);
            check(status);
            if (status == GPHYS_NO_HIT) hits_[i] = nothing;
        }
        return true;
    }

    bool any_singly(const std::vector<gphys_ray>& rays, std::vector<int32_t>& answers) override {
        if (callers_ != 1 || worker_count_ != 1) return false;
        answers.resize(rays.size());
        for (size_t i = 0; i < rays.size(); ++i) {
            check(mesh_ ? gphys_mesh_raycast_any(mesh_, &rays[i], &answers[i])
                        : gphys_scene_raycast_any(scene_, &rays[i], GPHYS_ALL_LAYERS, &answers[i]));
        }
        return true;
    }

    bool nearest(const std::vector<gphys_vec3>& points) override {
        nearest_.resize(points.size());
        hits_.clear();
        distances_.clear();
        by_callers(points, [&](uint32_t, const gphys_vec3* some, uint32_t n) {
            gphys_nearest* const out = nearest_.data() + (some - points.data());
            check(
                mesh_
                    ? gphys_shape_closest_point_batch(GPHYS_SHAPE_MESH, mesh_, some, sizeof *some, n, out, sizeof *out)
                    : gphys_scene_nearest_batch(scene_, some, sizeof *some, n, std::numeric_limits<float>::infinity(),
                                                GPHYS_ALL_LAYERS, out, sizeof *out));
        });
        return true;
    }
    bool nearest_singly(const std::vector<gphys_vec3>& points) override {
        if (callers_ != 1 || worker_count_ != 1) return false;
        nearest_.resize(points.size());
        hits_.clear();
        distances_.clear();
        for (size_t i = 0; i < points.size(); ++i) {
            check(mesh_ ? gphys_shape_closest_point(GPHYS_SHAPE_MESH, mesh_, &points[i], &nearest_[i])
                        : gphys_scene_nearest(scene_, &points[i], std::numeric_limits<float>::infinity(),
                                              GPHYS_ALL_LAYERS, &nearest_[i]));
        }
        return true;
    }

    bool segments(const std::vector<gphys_segment>& segments) override {
        start_hits(segments.size());
        by_callers(segments, [&](uint32_t, const gphys_segment* some, uint32_t n) {
            check(gphys_scene_segment_test_batch(scene_, some, sizeof *some, n, GPHYS_ALL_LAYERS,
                                                 hits_.data() + (some - segments.data()), sizeof hits_[0]));
        });
        return true;
    }

    bool sweeps(const std::vector<Sweep>& sweeps) override {
        start_hits(sweeps.size());
        by_callers(sweeps, [&](uint32_t, const Sweep* some, uint32_t n) {
            if (n == 0) return;
            check(gphys_scene_sweep_sphere_batch(scene_, &some->sphere, sizeof *some, &some->displacement, sizeof *some,
                                                 n, GPHYS_ALL_LAYERS, hits_.data() + (some - sweeps.data()),
                                                 sizeof hits_[0]));
        });
        return true;
    }

    bool sweeps(const std::vector<CapsuleSweep>& sweeps) override { return sweep_solids(GPHYS_SHAPE_CAPSULE, sweeps); }
    bool sweeps(const std::vector<BoxSweep>& sweeps) override { return sweep_solids(GPHYS_SHAPE_OBB, sweeps); }

    bool closest_without(const std::vector<gphys_ray>& rays, uint32_t object, bool singly) override {
        gphys_query_filter_desc filter;
        check(gphys_query_filter_desc_init(&filter, sizeof filter));
        filter.ignored_model = models_[object];
        start_hits(rays.size());
        if (!singly) {
            check(gphys_scene_raycast_filtered_batch(scene_, rays.data(), sizeof rays[0],
                                                     static_cast<uint32_t>(rays.size()), &filter, 0, hits_.data(),
                                                     sizeof hits_[0]));
            return true;
        }
        for (size_t i = 0; i < rays.size(); ++i) {
            const gphys_status status = gphys_scene_raycast_filtered(scene_, &rays[i], &filter, &hits_[i]);
            check(status);
            if (status == GPHYS_NO_HIT) hits_[i] = nothing;
        }
        return true;
    }

    bool closest(const std::vector<gphys_ray>& rays) override {
        start_hits(rays.size());
        by_callers(rays, [&](uint32_t, const gphys_ray* some, uint32_t n) {
            gphys_hit* const hits = hits_.data() + (some - rays.data());
            check(mesh_
                      ? gphys_shape_raycast_batch(GPHYS_SHAPE_MESH, mesh_, some, sizeof *some, n, hits, sizeof *hits)
                      : gphys_scene_raycast_batch(scene_, some, sizeof *some, n, GPHYS_ALL_LAYERS, hits, sizeof *hits));
        });
        return true;
    }
    bool distances(const std::vector<gphys_ray>& rays) override {
        start_hits(0);
        distances_.resize(rays.size());
        by_callers(rays, [&](uint32_t, const gphys_ray* some, uint32_t n) {
            gphys_distance* const out = distances_.data() + (some - rays.data());
            check(mesh_ ? gphys_mesh_raycast_distance_batch(mesh_, some, sizeof *some, n, out, sizeof *out)
                        : gphys_scene_raycast_distance_batch(scene_, some, sizeof *some, n, GPHYS_ALL_LAYERS, out,
                                                             sizeof *out));
        });
        return true;
    }

    std::vector<Answer> answers() const override {
        std::vector<Answer> found;
        found.reserve(hits_.size() + nearest_.size() + distances_.size());
        for (const gphys_distance& distance : distances_) {
            gphys_model_info info;
            const bool is_model = distance.model != 0;
            if (is_model) check(gphys_scene_get_info(scene_, distance.model, &info));
            found.push_back({distance.t, mesh_ ? distance.triangle : is_model ? info.tag : no_object});
        }
        for (const gphys_nearest& near : nearest_) {
            found.push_back({near.distance, mesh_ ? near.triangle : near.model ? near.tag : no_object});
        }
        for (const gphys_hit& hit : hits_) {
            found.push_back({hit.t, mesh_ ? hit.triangle : hit.model ? hit.tag : no_object});
        }
        return found;
    }

    bool any(const std::vector<gphys_ray>& rays, std::vector<int32_t>& answers) override {
        answers.resize(rays.size());
        by_callers(rays, [&](uint32_t, const gphys_ray* some, uint32_t n) {
            int32_t* const out = answers.data() + (some - rays.data());
            check(mesh_ ? gphys_mesh_raycast_any_batch(mesh_, some, sizeof *some, n, out, sizeof *out)
                        : gphys_scene_raycast_any_batch(scene_, some, sizeof *some, n, GPHYS_ALL_LAYERS, out,
                                                        sizeof *out));
        });
        return true;
    }

    bool overlap(const std::vector<gphys_sphere>& spheres, uint64_t& total) override {
        return overlap(GPHYS_SHAPE_SPHERE, spheres, total);
    }
    bool overlap(const std::vector<gphys_aabb>& boxes, uint64_t& total) override {
        return overlap(GPHYS_SHAPE_AABB, boxes, total);
    }

    bool cull(const gphys_frustum& frustum, uint64_t& total) override {
        models_seen_.resize(models_.size());
        uint32_t seen = 0;
        check(gphys_scene_cull(scene_, &frustum, GPHYS_ALL_LAYERS, models_seen_.data(),
                               static_cast<uint32_t>(models_seen_.size()), &seen));
        total = seen;
        return true;
    }

    bool move_all(const std::vector<gphys_obb>& boxes) override {
        return move_some(boxes, 0, static_cast<uint32_t>(boxes.size()));
    }

    bool move_some(const std::vector<gphys_obb>& boxes, uint32_t first, uint32_t count) override {
        for (uint32_t i = first; i < first + count; ++i) transforms_[i] = {boxes[i].center, boxes[i].rotation, 1};
        check(gphys_scene_set_transforms(scene_, models_.data() + first, transforms_.data() + first,
                                         sizeof transforms_[0], count));
        return true;
    }

    bool remove_and_insert(const std::vector<gphys_obb>& boxes, uint32_t first, uint32_t count) override {
        check(gphys_scene_remove_batch(scene_, models_.data() + first, count));
        std::vector<gphys_aabb> shapes(count);
        for (uint32_t i = 0; i < count; ++i) {
            const gphys_vec3 h = boxes[first + i].half_extents;
            shapes[i] = {{-h.x, -h.y, -h.z}, h};
        }
        check(gphys_scene_add_batch(scene_, GPHYS_SHAPE_AABB, shapes.data(), sizeof shapes[0],
                                    transforms_.data() + first, sizeof transforms_[0], count, nullptr,
                                    models_.data() + first));
        return true;
    }

    bool load_one_by_one(const std::vector<gphys_obb>& boxes, CallTimes& adds) override {
        place(boxes);
        create_scene();
        models_.resize(boxes.size());
        adds.start_run();
        for (uint32_t i = 0; i < boxes.size(); ++i) add_one(boxes[i], i, adds);
        return true;
    }

    bool replace_one_by_one(const std::vector<Jump>& jumps, CallTimes& removes, CallTimes& adds) override {
        removes.start_run();
        adds.start_run();
        for (const Jump& jump : jumps) {
            transforms_[jump.object] = {jump.to.center, jump.to.rotation, 1};
            removes.time([&] { check(gphys_scene_remove(scene_, models_[jump.object])); });
            add_one(jump.to, jump.object, adds);
        }
        return true;
    }

    bool run_frame(const Frame& frame, FrameTimes& times) override {
        models_seen_.resize(models_.size());
        uint32_t total = 0;
        for (const gphys_ray& ray : frame.rays) {
            gphys_hit hit;
            times.rays.time(
                [&] { times.hits += gphys_scene_raycast(scene_, &ray, GPHYS_ALL_LAYERS, &hit) == GPHYS_OK; });
        }
        for (const gphys_sphere& ball : frame.balls) {
            times.overlaps.time([&] {
                check(gphys_scene_overlap(scene_, GPHYS_SHAPE_SPHERE, &ball, GPHYS_ALL_LAYERS, models_seen_.data(),
                                          static_cast<uint32_t>(models_seen_.size()), &total));
            });
            times.overlapping += total;
        }
        for (const Jump& move : frame.moves) {
            const gphys_transform to{move.to.center, move.to.rotation, 1};
            times.moves.time(
                [&] { check(gphys_scene_set_transforms(scene_, &models_[move.object], &to, sizeof to, 1)); });
        }
        times.culls.time([&] {
            check(gphys_scene_cull(scene_, &frame.frustum, GPHYS_ALL_LAYERS, models_seen_.data(),
                                   static_cast<uint32_t>(models_seen_.size()), &total));
        });
        times.visible += total;
        return true;
    }

private:
    void clear() {
        gphys_mesh_destroy(mesh_);
        gphys_scene_destroy(scene_);
        mesh_ = nullptr;
        scene_ = nullptr;
        heap_.forget_peak();
    }

    template <class Sweep>
    bool sweep_solids(gphys_shape_type type, const std::vector<Sweep>& sweeps) {
        start_hits(sweeps.size());
        by_callers(sweeps, [&](uint32_t, const Sweep* some, uint32_t n) {
            if (n == 0) return;
            check(gphys_scene_sweep_batch(scene_, type, &some->solid, sizeof *some, &some->displacement, sizeof *some,
                                          n, GPHYS_ALL_LAYERS, hits_.data() + (some - sweeps.data()), sizeof hits_[0]));
        });
        return true;
    }

    void start_hits(size_t count) {
        hits_.resize(count);
        nearest_.clear();
        distances_.clear();
    }

    void place(const std::vector<gphys_obb>& boxes) {
        transforms_.resize(boxes.size());
        for (size_t i = 0; i < boxes.size(); ++i) transforms_[i] = {boxes[i].center, boxes[i].rotation, 1};
    }

    void create_mesh(const Triangles& mesh, int32_t deformable = 0) {
        gphys_mesh_desc desc;
        check(gphys_mesh_desc_init(&desc, sizeof desc));
        desc.allocator = &allocator_;
        desc.deformable = deformable;
        check(gphys_mesh_create(&desc, &mesh.vertices[0].x, sizeof mesh.vertices[0],
                                static_cast<uint32_t>(mesh.vertices.size()), mesh.indices.data(),
                                static_cast<uint32_t>(mesh.indices.size()), &mesh_));
    }

    void create_scene() {
        clear();
        gphys_scene_desc desc;
        check(gphys_scene_desc_init(&desc, sizeof desc));
        desc.worker_count = worker_count_;
        desc.allocator = counted_ ? &allocator_ : nullptr;
        check(gphys_scene_create(&desc, &scene_));
    }

    void add_one(const gphys_obb& box, uint32_t index, CallTimes& adds) {
        const gphys_vec3 h = box.half_extents;
        const gphys_aabb shape{{-h.x, -h.y, -h.z}, h};
        gphys_model_desc desc;
        check(gphys_model_desc_init(&desc, sizeof desc));
        desc.tag = index;
        adds.time([&] {
            check(gphys_scene_add(scene_, GPHYS_SHAPE_AABB, &shape, &transforms_[index], &desc, &models_[index]));
        });
    }

    void add(gphys_shape_type type, const void* shapes, uint32_t stride,
             const std::vector<gphys_transform>& transforms) {
        create_scene();
        models_.resize(transforms.size());
        check(gphys_scene_add_batch(scene_, type, shapes, stride, transforms.data(), sizeof transforms[0],
                                    static_cast<uint32_t>(transforms.size()), nullptr, models_.data()));
        for (uint32_t i = 0; i < models_.size(); ++i) check(gphys_scene_set_tag(scene_, models_[i], i));
    }

    /// call(caller, first, count) for each caller's part of the queries.
    template <class Query, class Call>
    void by_callers(const std::vector<Query>& queries, const Call& call) const {
        std::vector<std::thread> others;
        const size_t part = (queries.size() + callers_ - 1) / callers_;
        for (uint32_t caller = callers_; caller-- > 0;) {
            const size_t first = caller * part;
            const auto one = [=, &queries, &call] {
                call(caller, queries.data() + first, static_cast<uint32_t>(std::min(part, queries.size() - first)));
            };
            caller > 0 ? void(others.emplace_back(one)) : one();
        }
        for (std::thread& other : others) other.join();
    }

    template <class Query>
    bool overlap(gphys_shape_type type, const std::vector<Query>& queries, uint64_t& total) {
        if (mesh_) return false;
        constexpr uint32_t room = 64;
        offsets_.resize(queries.size() + callers_);
        models_seen_.resize(room * queries.size());
        std::vector<uint64_t> totals(callers_);
        by_callers(queries, [&](uint32_t caller, const Query* some, uint32_t n) {
            const auto first = static_cast<size_t>(some - queries.data());
            uint32_t* const offsets = offsets_.data() + first + caller;
            check(gphys_scene_overlap_batch(scene_, type, some, sizeof(Query), n, GPHYS_ALL_LAYERS,
                                            models_seen_.data() + room * first, room * n, offsets));
            totals[caller] = offsets[n];
        });
        total = std::accumulate(totals.begin(), totals.end(), uint64_t{0});
        return true;
    }

    uint32_t worker_count_, callers_;
    bool counted_;
    Heap heap_;
    const gphys_allocator allocator_{allocate, release, &heap_};
    gphys_scene* scene_ = nullptr;
    gphys_mesh* mesh_ = nullptr;
    std::vector<uint32_t> saved_;
    std::vector<gphys_model_id> models_;
    std::vector<gphys_transform> transforms_;
    // Of the last question, either of them.
    std::vector<gphys_hit> hits_;
    std::vector<gphys_nearest> nearest_;
    std::vector<gphys_distance> distances_;
    std::vector<uint32_t> models_seen_, offsets_;
};

}  // namespace

std::unique_ptr<Implementation> make_gamephys(uint32_t worker_count, uint32_t callers, bool counted) {
    return std::make_unique<Gamephys>(worker_count, callers, counted);
}

}  // namespace bench

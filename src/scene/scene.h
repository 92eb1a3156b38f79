// A scene: models and the BVH over their AABBs. A model is a shape or a shared mesh with a transform, and may have a
// parent. The C layer has checked all values; the scene checks ids.
//
//   scene_models.cpp      add, remove, change, set_parent
//   scene_transforms.cpp  set_transforms, set_origin; propagation to descendants
//   scene_rays.cpp        raycasts, single and batched
//   scene_queries.cpp     overlap, cull
//   scene_solids.cpp      sweeps; penetration
//   scene_contact.cpp     closest point and sweep of one model, for collision response
//   scene_snapshot.cpp    snapshot, restore, hash
//   scene_check.cpp       consistency check
//
// A model's world transform is stored as float32. The rest is derived from it: the shape in world space (in double,
// when a query needs it), and the model's AABB in the BVH (rounded outward). A query traverses the BVH, tests each
// candidate first conservatively and then exactly, and prunes by the best result so far.
#pragma once

#include <algorithm>
#include <cstring>

#include "bvh/bvh8.h"
#include "foundation/archive.h"
#include "foundation/ids.h"
#include "foundation/pool.h"
#include "foundation/results.h"
#include "foundation/status.h"
#include "foundation/strided.h"
#include "foundation/workers.h"
#include "geometry/intersect.h"
#include "scene/bounds_kernels.h"
#include "scene/box_kernels.h"
#include "scene/conservative_shape.h"
#include "scene/hit_kernels.h"
#include "scene/layer_blocks.h"
#include "scene/model_scale.h"
#include "scene/query_filter.h"
#include "scene/scene_kernels.h"
#include "scene/slot_set.h"

namespace gphys {

struct UsedMesh;
class HeldMeshes;

using DeepestPenetrations = Smallest<gphys_penetration, DeepestFirst>;

/// The order of lists of hits: by reported t, then by id.
struct FirstHit {
    bool operator()(const gphys_hit& a, const gphys_hit& b) const { return a.t != b.t ? a.t < b.t : a.model < b.model; }
};

class Scene {
public:
    /// World transforms have a scale from 1 / max_scale to max_scale, so that inverses are in range, too.
    static constexpr float max_scale = GPHYS_MAX_COORDINATE;

    explicit Scene(const gphys_allocator* hooks, uint32_t reserve_models = 0, uint32_t worker_count = 1,
                   const gphys_task_runner* task_runner = nullptr);
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene();

    mutable Memory memory;  // mutable for the const functions that are documented to allocate

    // Changes. A call that fails, by status or std::bad_alloc, leaves the scene unchanged.

    /// `shapes`: public structs of the type, with a stride, or one Mesh. `transforms` may be null.
    gphys_status add(gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                     const gphys_transform* transforms, uint32_t transform_stride, uint32_t count,
                     Strided<gphys_model_desc> descs, gphys_model_id* out_models);
    gphys_status add(gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                     const gphys_transform* transforms, uint32_t transform_stride, uint32_t count,
                     const gphys_model_desc& desc, gphys_model_id* out_models) {
        return add(type, shapes, shape_stride, transforms, transform_stride, count, Strided<gphys_model_desc>(&desc, 0),
                   out_models);
    }
    gphys_status remove(const gphys_model_id* models, uint32_t count);
    gphys_status remove_subtree(gphys_model_id model);
    void clear();
    void rebuild_octree() { bvh_.rebuild(); }
    bool maintain_octree(uint32_t budget) { return bvh_.maintain(budget); }
    /// A public struct of the type, or a Mesh.
    gphys_status set_shape(gphys_model_id model, gphys_shape_type type, const void* shape);
    /// `scale` is valid (defect_of_scale).
    gphys_status set_scale(gphys_model_id model, const gphys_vec3& scale);
    gphys_status set_parent(gphys_model_id model, gphys_model_id parent, bool keep_world);
    gphys_status set_transforms(const gphys_model_id* models, const gphys_transform* transforms,
                                uint32_t transform_stride, uint32_t count);
    gphys_status set_layers(gphys_model_id model, uint32_t layers);
    /// Changes the coordinates of all models; they stay where they are in the world.
    gphys_status set_origin(Vec3 origin);
    Vec3 origin() const { return origin_; }
    gphys_status set_tag(gphys_model_id model, uint32_t tag);

    bool has(gphys_model_id model) const { return ids_.has(model); }
    /// GPHYS_OK or GPHYS_ERROR_INVALID_ID.
    gphys_status check(gphys_model_id model) const;
    uint32_t size() const { return ids_.size(); }
    template <class Visit>
    void for_each_model(Visit&& visit) const;  // visit(id), by slot

    // Of one model; the id is valid.

    gphys_shape_type type(gphys_model_id model) const { return at(model).type(); }
    uint32_t layers(gphys_model_id model) const { return at(model).layers; }
    uint32_t tag(gphys_model_id model) const { return tags_[IdTable::slot_of(model)]; }
    gphys_model_id parent(gphys_model_id model) const;
    uint32_t child_count(gphys_model_id model) const;
    template <class Visit>
    void for_each_child(gphys_model_id model, Visit&& visit) const;  // visit(id), in no order
    const gphys_transform& local(gphys_model_id model) const { return local_of(IdTable::slot_of(model)); }
    const gphys_transform& world(gphys_model_id model) const { return at(model).world; }
    Transform world_transform(gphys_model_id model) const { return widen(at(model).world); }
    /// The public struct, scaled, as queries read it. Not for meshes.
    void copy_shape(gphys_model_id model, void* out) const;
    /// The public struct as given to add() or set_shape().
    void copy_unscaled_shape(gphys_model_id model, void* out) const;
    gphys_vec3 scale(gphys_model_id model) const { return scale_of(IdTable::slot_of(model)); }
    /// False if the model is unbounded.
    bool bounds(gphys_model_id model, Box& out) const;

    const Bvh8& bvh() const { return bvh_; }
    const Workers& workers() const { return workers_; }
    void set_worker_count(uint32_t count) { workers_.set_count(count); }
    uint32_t unbounded_count() const { return static_cast<uint32_t>(unbounded_.size()); }
    /// What is inconsistent in the scene, or nullptr.
    const char* defect() const;

    // As gphys_scene_get_snapshot, gphys_scene_restore and gphys_scene_get_hash. `library` may be this scene.

    gphys_status snapshot(bool embed_meshes, uint32_t* out, uint32_t capacity, uint32_t& total) const;
    gphys_status restore(const Scene& library, const uint32_t* words, uint32_t count);
    void hash(uint32_t (&out)[2]) const;

    /// A filter that ignores `ignored_model`, with `subtree` also its descendants, and the models in `ids`. 0 and ids
    /// of removed models are allowed. `ids` must outlive the filter.
    QueryFilter query_filter(uint32_t layers, gphys_model_id ignored_model, bool subtree,
                             const IgnoredIds& ids = {}) const;

    // Queries. Candidates are the models with (layers & model's layers) != 0 that the filter does not ignore. They
    // return GPHYS_OK or GPHYS_NO_HIT.

    gphys_status raycast(const Ray& ray, uint32_t layers, gphys_hit& out) const;
    gphys_status raycast(const Ray& ray, const QueryFilter& filter, gphys_hit& out) const;
    /// Closest hits of up to rays_at_once rays, which are scratch memory. Without a hit, *out[i] is unchanged.
    static constexpr uint32_t rays_at_once = Bvh8::rays_at_once;
    void raycast_many(Ray* rays, uint32_t count, uint32_t layers, gphys_hit* const* out) const;
    void raycast_many(Ray* rays, uint32_t count, const BatchFilters& filters, gphys_hit* const* out) const;
    /// The same without points and normals.
    void raycast_distance_many(Ray* rays, uint32_t count, uint32_t layers, gphys_distance* const* out) const;
    void raycast_distance_many(Ray* rays, uint32_t count, const BatchFilters& filters,
                               gphys_distance* const* out) const;
    bool raycast_any(const Ray& ray, uint32_t layers) const;
    bool raycast_any(const Ray& ray, const QueryFilter& filter) const;
    /// The same for many rays: bit i of the result is for ray i.
    uint64_t raycast_any_many(Ray* rays, uint32_t count, uint32_t layers) const;
    uint64_t raycast_any_many(Ray* rays, uint32_t count, const BatchFilters& filters) const;
    void raycast_all(const Ray& ray, const QueryFilter& filter, Smallest<gphys_hit, FirstHit>& out) const;
    /// Writes the lowest `capacity` ids, ascending; returns the number of all. The rest of `out` is scratch.
    /// `candidates`: the result of find_candidates for the shape, or null.
    uint32_t overlap(const Shape& shape, uint32_t layers, gphys_model_id* out, uint32_t capacity,
                     const OverlapItems* candidates = nullptr) const;
    uint32_t overlap(const Shape& shape, const QueryFilter& filter, gphys_model_id* out, uint32_t capacity,
                     const OverlapItems* candidates = nullptr) const;
    /// The first step of overlap(), interleaved for 1 to OverlapItems::max_queries shapes of one type.
    void find_candidates(const Shape* shapes, uint32_t count, uint32_t layers, OverlapItems* candidates) const;
    gphys_status nearest(Vec3 point, double max_distance, uint32_t layers, gphys_nearest& out) const;
    gphys_status nearest(Vec3 point, double max_distance, const QueryFilter& filter, gphys_nearest& out) const;
    /// The same for up to points_at_once points. Without a model in reach, out[i] is unchanged.
    static constexpr uint32_t points_at_once = Bvh8::points_at_once;
    void nearest_many(const Vec3* points, uint32_t count, double max_distance, uint32_t layers,
                      gphys_nearest* out) const;
    void nearest_many(const Vec3* points, uint32_t count, double max_distance, const BatchFilters& filters,
                      gphys_nearest* out) const;
    gphys_status sweep(const Sphere& moving, Vec3 displacement, const QueryFilter& filter, gphys_hit& out) const;
    /// For a moving sphere, capsule or box.
    gphys_status sweep(const Shape& moving, Vec3 displacement, const QueryFilter& filter, gphys_hit& out) const;
    /// The penetrations of a sphere, capsule or box into each model, or each triangle of a mesh, that it overlaps.
    void penetration(const Shape& moving, const QueryFilter& filter, DeepestPenetrations& out) const;
    /// The models whose world AABBs are outside none of the six planes and overlap the frustum's AABB, by conservative
    /// arithmetic. Writes the lowest `capacity` ids, ascending; returns the number of all. The rest of `out` is
    /// scratch.
    uint32_t cull(const Frustum& frustum, uint32_t layers, gphys_model_id* out, uint32_t capacity) const;
    uint32_t cull(const Frustum& frustum, const QueryFilter& filter, gphys_model_id* out, uint32_t capacity) const;
    /// Candidates for collisions: visit(id) for models whose world AABBs overlap the box, and planes that overlap it,
    /// except the models of bodies.
    template <class Visit>
    void for_each_in_box(const Box& box, uint32_t layers, Visit&& visit) const;

    // Queries of one model, in world space; the id is valid.

    /// Exact overlap of the shape and the box.
    bool overlaps_box(gphys_model_id model, const Box& box) const;
    bool sweep_model(gphys_model_id model, const Sphere& moving, Vec3 displacement, Hit& hit) const;
    /// out: the closest point of the shape's surface. normal: unit; outward of a solid; of a surface, towards the
    /// point. signed_distance: < 0 inside a solid. False only for a mesh without triangles.
    bool closest_point_model(gphys_model_id model, Vec3 point, Vec3& out, Vec3& normal, double& signed_distance) const;
    /// Null if it is a primitive.
    const Mesh* mesh(gphys_model_id model) const { return stored_mesh(IdTable::slot_of(model)); }

private:
    static constexpr uint32_t none = 0xffffffff;

    /// Hierarchy data, stored only while a model has a parent or children.
    struct Family {
        uint32_t parent = none, first_child = none, next = none, previous = none;  // slots; next, previous: siblings
        uint32_t child_count = 0;
        gphys_transform local;
        gphys_transform old_local;  // for the rollback of set_transforms
    };

    /// What a query reads of a candidate, in one cache line.
    struct alignas(64) Model {
        gphys_transform world;
        uint32_t layers;
        uint32_t family : 24;  // index in families_; no_family: local and world transform are the same
        uint32_t type_ : 6;
        uint32_t moving : 1, carried : 1;  // marks of set_transforms and remove; 0 between calls
        uint32_t shape[6];                 // the first words of the public struct, or of a ModelMesh

        gphys_shape_type type() const { return static_cast<gphys_shape_type>(type_); }
        bool has_family() const { return family != no_family; }
    };
    static constexpr uint32_t no_family = (1u << 24) - 1;
    /// The words of a capsule, Obb or triangle that do not fit into Model::shape; of a scaled mesh, its bounding
    /// sphere.
    struct ShapeTail {
        uint32_t words[4];
    };
    static constexpr size_t largest_shape_words = sizeof(gphys_obb) / sizeof(uint32_t);
    /// The original shape of a primitive whose scale is not one.
    struct Unscaled {
        gphys_vec3 scale = no_scale;
        uint32_t shape[largest_shape_words] = {};
    };
    /// A word of Model::shape that planes do not use: the plane's index in unbounded_.
    static constexpr size_t position_in_list = sizeof(gphys_plane) / sizeof(uint32_t);
    template <class Stored>
    static constexpr size_t head_size = std::min(sizeof(Stored), sizeof Model::shape);

    // The two steps of a filter (query_filter.h). for_each_passing_in_layers does both for models that are known to be
    // in the layers: visit(slot) for each that passes; returns their number.
    bool may_pass(uint32_t layers, uint32_t slot) const { return (models_[slot].layers & layers) != 0; }
    bool may_pass(const QueryFilter& filter, uint32_t slot) const {
        return (models_[slot].layers & filter.layers) != 0 && slot != filter.ignored_slot && !is_below(slot, filter);
    }
    static constexpr bool passes(uint32_t, uint32_t) { return true; }
    bool passes(const QueryFilter& filter, uint32_t slot) const {
        return filter.ignored.empty() || !filter.ignored.contains(ids_.id(slot));
    }
    template <class Visit>
    static uint32_t for_each_passing_in_layers(uint32_t layers, const uint32_t* slots, uint32_t count, Visit&& visit);
    template <class Visit>
    uint32_t for_each_passing_in_layers(const QueryFilter& filter, const uint32_t* slots, uint32_t count,
                                        Visit&& visit) const;
    /// Whether the model is a descendant of the ignored one. Most models have no family; the flag is in the cache line
    /// read.
    bool is_below(uint32_t slot, const QueryFilter& filter) const {
        return filter.ignores_below && models_[slot].has_family() && is_below(slot, filter.ignored_slot);
    }
    bool is_below(uint32_t slot, uint32_t top) const;
    static uint32_t layers_of(uint32_t layers) { return layers; }
    static uint32_t layers_of(const QueryFilter& filter) { return filter.layers; }
    /// visit(slot) for each model in one of the layers, by slot. Does not use the BVH.
    template <class Visit>
    void for_each_in_layers(uint32_t layers, Visit&& visit) const;

    // The queries. Filter is uint32_t (layers) or QueryFilter; Filters is uint32_t or BatchFilters.
    template <class T>
    class Storage;
    template <class Answer>
    class FirstHitOfRay;
    class LargeMeshes;
    class NearestOfPoint;
    class RejectedCandidates;
    /// Answer is gphys_hit or gphys_distance.
    template <class Filter, class Answer>
    gphys_status raycast_by(const Ray& ray, const Filter& filter, Answer& out) const;
    template <class Filters, class Answer>
    void raycast_many_by(Ray* rays, uint32_t count, const Filters& filters, Answer* const* out) const;
    template <class Filters, class Answer>
    void raycast_together_by(Ray* rays, uint32_t count, const Filters& filters, Answer* const* out) const;
    template <class Filters, class Answer>
    void raycast_bvh_by(Ray* rays, uint32_t count, const Filters& filters, const LargeMeshes& large,
                        Storage<FirstHitOfRay<Answer>>* first) const;
    template <class Filter>
    bool raycast_any_by(const Ray& ray, const Filter& filter) const;
    template <class Filters>
    uint64_t raycast_any_many_by(Ray* rays, uint32_t count, const Filters& filters) const;
    template <class Filters>
    uint64_t raycast_any_together_by(Ray* rays, uint32_t count, const Filters& filters) const;
    template <class Filter>
    uint32_t overlap_by(const Shape& shape, const Filter& filter, gphys_model_id* out, uint32_t capacity,
                        const OverlapItems* candidates) const;
    template <class Filter>
    gphys_status nearest_by(Vec3 point, double max_distance, const Filter& filter, gphys_nearest& out) const;
    template <class Filters>
    void nearest_many_by(const Vec3* points, uint32_t count, double max_distance, const Filters& filters,
                         gphys_nearest* out) const;
    template <class Filters>
    void nearest_together_by(const Vec3* points, uint32_t count, double max_distance, const Filters& filters,
                             gphys_nearest* out) const;
    template <class SweepOne, class Traverse>
    gphys_status first_contact(Vec3 displacement, const QueryFilter& filter, const SweepOne& sweep_one,
                               const Traverse& traverse, gphys_hit& out) const;
    template <class Filter>
    uint32_t cull_by(const Frustum& frustum, const Filter& filter, gphys_model_id* out, uint32_t capacity) const;
    template <class FindAll>
    bool list_by_set(const FindAll& find_all, gphys_model_id* out, uint32_t capacity, uint32_t& total) const;

    class EightPairs;
    class ConservativeRays;
    class SharedModel;

    ItemMemory model_memory() const { return {models_.data(), sizeof(Model)}; }
    ItemMemory id_memory() const { return {ids_.ids(), sizeof(uint32_t)}; }
    /// Whether a model wholly inside a query is a result without a test, because all models are in the layers. Then
    /// only its id is read.
    bool inside_is_result(uint32_t layers) const { return (common_layers_ & layers) != 0; }
    ItemMemory inside_memory(uint32_t layers) const { return inside_is_result(layers) ? id_memory() : model_memory(); }
    const Model& at(gphys_model_id model) const { return models_[IdTable::slot_of(model)]; }

    // Shapes. with_type: visit(a default public struct of the type, or ModelMesh). with_stored: visit(the model's
    // stored shape). with_shape: visit(the shape in world space).
    template <class Visit>
    static auto with_type(gphys_shape_type type, Visit&& visit);
    template <class Visit>
    auto with_stored(uint32_t slot, Visit&& visit) const;
    template <class Visit>
    auto with_shape(uint32_t slot, Visit&& visit) const;
    /// The same of an unbounded model: visit(Plane).
    template <class Visit>
    auto with_plane(uint32_t slot, Visit&& visit) const {
        return with_placed(stored<gphys_plane>(slot), models_[slot].world, visit);
    }
    template <class Stored>
    Stored stored(uint32_t slot) const;
    /// The words after the first six: of an Obb its rotation.
    const float* tail_of(uint32_t slot) const { return reinterpret_cast<const float*>(shape_tails_[slot].words); }
    /// Tests a model that has passed may_pass(): the conservative test of the stored shape, the filter, then, if
    /// undecided, the exact test of the shape in world space.
    template <class Filter, class Conservative, class Exact>
    bool decide(const Filter& filter, uint32_t slot, Conservative&& conservative, Exact&& exact) const;
    template <class Filter>
    bool hits_unbounded(const Ray& ray, const Filter& filter) const;
    /// Of a plane. False is certain.
    bool may_hit_plane(uint32_t slot, const Ray& ray) const;
    /// Whether box_kernels_ test the model, and the test.
    bool has_box_kernel(uint32_t slot) const {
        const gphys_shape_type type = models_[slot].type();
        return box_kernels_ && (type == GPHYS_SHAPE_AABB || type == GPHYS_SHAPE_OBB);
    }
    bool is_mesh(uint32_t slot) const { return models_[slot].type() == GPHYS_SHAPE_MESH; }
    /// Whether placed_mesh() answers the ray.
    bool has_mesh_kernel(uint32_t slot, const Ray& ray) const {
        const Mesh* const mesh = stored_mesh(slot);
        return mesh && mesh->crosses_placed(ray);
    }
    PlacedMesh placed_mesh(uint32_t slot) const {
        const auto stored = this->stored<ModelMesh>(slot);
        return {*stored.mesh, models_[slot].world, widen(stored.scale)};
    }
    bool meets_mesh(uint32_t slot, const Ray& ray) const;
    TriState raycast_box(uint32_t slot, const Ray& ray, Hits8::Rounded& hit) const;
    TriState meets_box(uint32_t slot, const Ray& ray) const;
    template <class Answers, class OnHit>
    uint32_t hits_by_kernels(const EightPairs& pairs, const Ray* rays, const OnHit& hit) const;
    void reserve_shapes(gphys_shape_type type, bool scaled, size_t size);
    void store_shape(uint32_t slot, const void* shape, const gphys_vec3& scale);
    void store_ball(uint32_t slot, const ModelMesh& stored);
    gphys_status change_shape(uint32_t slot, gphys_shape_type type, const void* shape, const gphys_vec3& scale);
    gphys_vec3 scale_of(uint32_t slot) const;
    /// Null if it is a primitive.
    const Mesh* stored_mesh(uint32_t slot) const { return is_mesh(slot) ? stored<ModelMesh>(slot).mesh : nullptr; }
    void release_shape(uint32_t slot);
    void release_mesh(const Mesh* mesh, uint32_t slot);
    void list_large_mesh(uint32_t slot);
    void unlist_large_mesh(uint32_t slot);
    double mesh_radius(uint32_t slot) const;
    /// Whether the model is the mesh of a solver's body. The solver handles collisions of bodies itself.
    bool is_body(uint32_t slot) const {
        const Mesh* const mesh = stored_mesh(slot);
        return mesh && mesh->is_body();
    }
    void list_unbounded(uint32_t slot);
    void unlist_unbounded(uint32_t position);

    // Families, by slot.
    Family& family(uint32_t slot) { return families_[models_[slot].family]; }
    const Family& family(uint32_t slot) const { return families_[models_[slot].family]; }
    Family& ensure_family(uint32_t slot);
    void drop_family_if_alone(uint32_t slot);
    uint32_t parent_of(uint32_t slot) const { return models_[slot].has_family() ? family(slot).parent : none; }
    void link(uint32_t slot, uint32_t parent);
    void unlink(uint32_t slot);
    /// The slot after `slot` in a preorder traversal of the hierarchy below `top`; none at the end. next_beside skips
    /// the descendants of `slot`.
    uint32_t next_below(uint32_t slot, uint32_t top) const;
    uint32_t next_beside(uint32_t slot, uint32_t top) const;
    void remove_slot(uint32_t slot);

    template <class Filter, class TestEight, class Test>
    void overlap_each(const TestEight& test_eight, const uint32_t* slots, uint32_t count, const Filter& filter,
                      const Test& test, Smallest<gphys_model_id>& out) const;

    // Placement.
    const gphys_transform& local_of(uint32_t slot) const;
    void set_local(uint32_t slot, const gphys_transform& local);
    void derive_world(uint32_t slot);
    void reset_place(uint32_t slot);
    Box world_box(uint32_t slot, const gphys_transform& world) const;
    /// What is wrong with the model at `world`, or nullptr. `box`: its AABB; not set for planes.
    const char* check_placement(uint32_t slot, const gphys_transform& world, Box& box) const;
    const char* check_placement(uint32_t slot, const gphys_transform& world) const;
    float farthest_point(uint32_t slot) const;
    template <class UpdateSome>
    void update_parallel(uint32_t count, bool on_any_thread, const UpdateSome& update_some) const;
    template <class Put>
    void update_eight(const gphys_model_id* models, uint32_t count, const Put& put) const;
    // Return what is wrong with one of the transforms, or nullptr; if there is an error, no model has moved.
    const char* move_alone(const gphys_model_id* models, const Strided<gphys_transform>& local, uint32_t count);
    const char* move_with_relatives(const gphys_model_id* models, const Strided<gphys_transform>& local,
                                    uint32_t count);
    const char* propagate(uint32_t top, uint32_t& moved);
    void restore_worlds(uint32_t top);
    template <class Put>
    void update_subtree(uint32_t top, const Put& put) const;
    void mark_carried(const gphys_model_id* models, uint32_t count);
    void unmark_carried(const gphys_model_id* models, uint32_t count);
    const char* propagate_relatives(const gphys_model_id* models, uint32_t count, uint32_t& moved);
    void roll_back_relatives(const gphys_model_id* models, uint32_t count);

    /// Notifications of deformable meshes about their new vertices, one for each model.
    class MeshFollower final : public MeshUser {
    public:
        explicit MeshFollower(Scene& scene) : scene_(scene) {}
        const char* check_mesh(uint32_t slot) const override;
        void mesh_changed(uint32_t slot) noexcept override;
        void mesh_shifted(uint32_t slot, Vec3 by) noexcept override;

    private:
        Scene& scene_;
    };

    // Snapshots.
    struct Contents;
    void swap_contents(Contents& other) noexcept;
    void release_meshes();
    template <class Visit>
    void for_each_mesh(Visit&& visit) const;
    template <class Sink, class PutMesh>
    void write_state(Sink& sink, const PutMesh& put_mesh) const;
    const char* find_meshes(const Vector<UsedMesh>& wanted, const uint32_t* embedded, uint32_t embedded_words,
                            const Scene& library, HeldMeshes& found);
    const char* read_models(Reader& reader, const HeldMeshes& meshes, uint32_t parts);
    bool any_scaled() const;
    const char* link_families(const Vector<uint32_t>& parents);
    const char* build_bvh(const BvhLayout& layout);

    const SceneKernels& kernels_ = scene_kernels(chosen_isa());
    const BoundsKernels& bounds_kernels_ = bounds_kernels(chosen_isa());
    const SlotSetKernels& slot_set_kernels_ = slot_set_kernels(chosen_isa());
    const HitKernels* hit_kernels_ = hit_kernels(chosen_isa());  // null for narrow sets
    Workers workers_;
    IdTable ids_{&memory};
    LargeArray<Model> models_{&memory};           // by slot
    LargeArray<uint32_t> tags_{&memory};          // by slot
    LargeArray<ShapeTail> shape_tails_{&memory};  // by slot, up to the last that has one
    Pool<Family> families_{&memory};
    LayerBlocks layer_blocks_{&memory};
    Bvh8 bvh_{&memory, chosen_isa(), &workers_};  // items are slots
    Vec3 origin_;                                 // of all coordinates, in the world
    LargeArray<WorldPlace> places_{&memory};      // by slot, for models without a parent; empty before set_origin
    LargeArray<Unscaled> unscaled_{&memory};      // by slot, up to the last that has one
    // Upper bounds over all models so far: of a mesh's scale factors and inverses, and of the distance of a shape's
    // points from the model's origin. With them, most checks of placements need no AABB.
    float widest_scale_ = 1;
    float farthest_point_ = 0;
    // Layers that all models are in; may lack some after set_layers. 0 if there is an empty mesh, which has no points.
    uint32_t common_layers_ = ~0u;
    Vector<uint32_t> unbounded_{&memory};  // slots of planes; they are few and not in the BVH
    // Slots of the largest meshes. In batches such a mesh is tested with all rays at once, which is faster. The results
    // do not depend on which meshes are listed.
    static constexpr uint32_t most_large_meshes = 4;
    uint32_t large_meshes_[most_large_meshes], large_mesh_count_ = 0;
    MeshFollower mesh_follower_{*this};
    const BoxKernels* box_kernels_ = box_kernels(chosen_isa());  // null for narrow sets
};

template <class Visit>
auto Scene::with_type(gphys_shape_type type, Visit&& visit) {
    switch (type) {
        case GPHYS_SHAPE_SPHERE:
            return visit(gphys_sphere());
        case GPHYS_SHAPE_CAPSULE:
            return visit(gphys_capsule());
        case GPHYS_SHAPE_AABB:
            return visit(gphys_aabb());
        case GPHYS_SHAPE_OBB:
            return visit(gphys_obb());
        case GPHYS_SHAPE_PLANE:
            return visit(gphys_plane());
        case GPHYS_SHAPE_TRIANGLE:
            return visit(gphys_triangle());
        default:
            return visit(ModelMesh());
    }
}

template <class Stored>
Stored Scene::stored(uint32_t slot) const {
    Stored result;
    constexpr size_t head = head_size<Stored>;
    std::memcpy(&result, models_[slot].shape, head);
    if constexpr (sizeof(Stored) > head) {
        static_assert(sizeof(Stored) - head <= sizeof(ShapeTail));
        std::memcpy(reinterpret_cast<char*>(&result) + head, &shape_tails_[slot], sizeof(Stored) - head);
    }
    return result;
}

template <class Visit>
auto Scene::with_stored(uint32_t slot, Visit&& visit) const {
    return with_type(models_[slot].type(), [&](auto type) { return visit(stored<decltype(type)>(slot)); });
}

template <class Visit>
auto Scene::with_shape(uint32_t slot, Visit&& visit) const {
    return with_stored(slot, [&](const auto& shape) { return with_placed(shape, models_[slot].world, visit); });
}

template <class Filter, class Conservative, class Exact>
bool Scene::decide(const Filter& filter, uint32_t slot, Conservative&& conservative, Exact&& exact) const {
    return with_stored(slot, [&](const auto& shape) {
        const gphys_transform& world = models_[slot].world;
        const TriState verdict = conservative_verdict(shape, world, conservative);
        if (verdict == TriState::no || !passes(filter, slot)) return false;
        return verdict == TriState::undecided ? with_placed(shape, world, exact) : verdict == TriState::yes;
    });
}

/// Updates the AABBs of `top` and its descendants.
template <class Put>
void Scene::update_subtree(uint32_t top, const Put& put) const {
    for (uint32_t slot = top; slot != none; slot = next_below(slot, top)) {
        if (models_[slot].type() != GPHYS_SHAPE_PLANE) put(slot, world_box(slot, models_[slot].world));
    }
}

template <class Visit>
uint32_t Scene::for_each_passing_in_layers(uint32_t, const uint32_t* slots, uint32_t count, Visit&& visit) {
    std::for_each(slots, slots + count, visit);
    return count;
}

template <class Visit>
uint32_t Scene::for_each_passing_in_layers(const QueryFilter& filter, const uint32_t* slots, uint32_t count,
                                           Visit&& visit) const {
    const auto visit_if = [&](const auto& is_passing) {
        uint32_t passing = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (!is_passing(slots[i])) continue;
            visit(slots[i]);
            ++passing;
        }
        return passing;
    };
    const auto is_other = [&](uint32_t slot) { return slot != filter.ignored_slot; };
    if (!filter.ignores_below && filter.ignored.empty()) return visit_if(is_other);
    return visit_if([&](uint32_t slot) { return is_other(slot) && !is_below(slot, filter) && passes(filter, slot); });
}

template <class Visit>
void Scene::for_each_model(Visit&& visit) const {
    for (const uint32_t slot : ids_) visit(ids_.id(slot));
}

template <class Visit>
void Scene::for_each_child(gphys_model_id model, Visit&& visit) const {
    if (!at(model).has_family()) return;
    for (uint32_t child = family(IdTable::slot_of(model)).first_child; child != none; child = family(child).next) {
        visit(ids_.id(child));
    }
}

template <class Visit>
void Scene::for_each_in_box(const Box& box, uint32_t layers, Visit&& visit) const {
    const auto visit_if_candidate = [&](uint32_t slot) {
        if ((models_[slot].layers & layers) != 0 && !is_body(slot)) visit(ids_.id(slot));
        return true;
    };
    for (const uint32_t slot : unbounded_) {
        if (overlaps_box(ids_.id(slot), box)) visit_if_candidate(slot);
    }
    bvh_.overlap_box(
        box, [&](uint32_t slot, bool) { return visit_if_candidate(slot); }, model_memory(), model_memory());
}

/// Scene::closest_point_model for a triangle in world space.
void closest_point_triangle(const Triangle& triangle, Vec3 point, Vec3& out, Vec3& normal, double& distance);

}  // namespace gphys

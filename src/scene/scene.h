// Models - a shape or a shared mesh, placed in the world, perhaps below a parent - and the BVH
// that finds them. The C layer has checked all values; ids are checked here.
//
//   scene_models.cpp      models come and go, and hang below one another
//   scene_transforms.cpp  they move, and their descendants with them
//   scene_rays.cpp        rays
//   scene_queries.cpp     overlaps, nearest, sweeps, culling
//   scene_solids.cpp      sweeps of capsules and boxes, and ways out
//   scene_contact.cpp     one model and one point, for collision response
//   scene_snapshot.cpp    copied out as words, and restored
//   scene_check.cpp       is everything in agreement?
//
// A model's world transform is stored as float32. Everything else is derived from it: the shape in world space (in
// double, when a query needs it) and the model's AABB in the BVH (rounded outward). A query traverses the BVH, tests
// the exact shape of each candidate, and prunes by the best result so far.
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
#include "scene/conservative_shape.h"
#include "scene/hit_kernels.h"
#include "scene/model_scale.h"
#include "scene/query_filter.h"
#include "scene/scene_kernels.h"
#include "scene/slot_set.h"

namespace gphys {

struct UsedMesh;
class HeldMeshes;

using DeepestPenetrations = Smallest<gphys_penetration, DeepestFirst>;

/// By t as the caller sees it, then id: the order of lists of hits.
struct FirstHit {
    bool operator()(const gphys_hit& a, const gphys_hit& b) const { return a.t != b.t ? a.t < b.t : a.model < b.model; }
};

class Scene {
public:
    /// World transforms have a scale from 1 / max_scale to max_scale, so that their inverses are as
    /// harmless as they are.
    static constexpr float max_scale = GPHYS_MAX_COORDINATE;

    explicit Scene(const gphys_allocator* hooks, uint32_t reserve_models = 0, uint32_t worker_count = 1,
                   const gphys_task_runner* task_runner = nullptr);
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene();

    mutable Memory memory;  // also for const functions that say that they allocate

    // Models. Whatever fails, by status or by std::bad_alloc, leaves the scene as it was.

    /// `shapes` are public structs of the type, strided, or one Mesh; `transforms` may be null.
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
    /// Throws std::bad_alloc, with nothing changed.
    void rebuild_octree() { bvh_.rebuild(); }
    /// A public struct of the type, or a Mesh.
    gphys_status set_shape(gphys_model_id model, gphys_shape_type type, const void* shape);
    /// A valid one.
    gphys_status set_scale(gphys_model_id model, const gphys_vec3& scale);
    gphys_status set_parent(gphys_model_id model, gphys_model_id parent, bool keep_world);
    gphys_status set_transforms(const gphys_model_id* models, const gphys_transform* transforms,
                                uint32_t transform_stride, uint32_t count);
    gphys_status set_layers(gphys_model_id model, uint32_t layers);
    /// All models stay where they are in the world.
    gphys_status set_origin(Vec3 origin);
    Vec3 origin() const { return origin_; }
    gphys_status set_tag(gphys_model_id model, uint32_t tag);

    bool has(gphys_model_id model) const { return ids_.has(model); }
    /// GPHYS_OK, or the failure that a stale id is.
    gphys_status check(gphys_model_id model) const;
    uint32_t size() const { return ids_.size(); }
    template <class Visit>
    void for_each_model(Visit&& visit) const;  // visit(id), by slot

    // About one model; the id is valid.

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
    /// The public struct that queries see: scaled. Not for meshes.
    void copy_shape(gphys_model_id model, void* out) const;
    /// The one that add was given.
    void copy_unscaled_shape(gphys_model_id model, void* out) const;
    gphys_vec3 scale(gphys_model_id model) const { return scale_of(IdTable::slot_of(model)); }
    /// False if the model is unbounded.
    bool bounds(gphys_model_id model, Box& out) const;

    const Bvh8& bvh() const { return bvh_; }
    const Workers& workers() const { return workers_; }
    uint32_t unbounded_count() const { return static_cast<uint32_t>(unbounded_.size()); }
    /// What is inconsistent in the scene, or nullptr.
    const char* defect() const;

    /// As gphys_scene_get_snapshot, gphys_scene_restore and gphys_scene_get_hash. A library may be the scene itself.
    gphys_status snapshot(bool embed_meshes, uint32_t* out, uint32_t capacity, uint32_t& total) const;
    gphys_status restore(const Scene& library, const uint32_t* words, uint32_t count);
    void hash(uint32_t (&out)[2]) const;

    /// `ignored_model` is left out, and with `subtree` all below it; 0 or a model that is gone is none. `ids` are
    /// left out, too, and must live as long as the filter.
    QueryFilter query_filter(uint32_t layers, gphys_model_id ignored_model, bool subtree,
                             const IgnoredIds& ids = {}) const;

    // Queries see the models of which layers & the model's layers is not 0 or, with a filter, those of them that it
    // does not leave out. GPHYS_OK or GPHYS_NO_HIT.

    gphys_status raycast(const Ray& ray, uint32_t layers, gphys_hit& out) const;
    gphys_status raycast(const Ray& ray, const QueryFilter& filter, gphys_hit& out) const;
    /// Up to rays_at_once rays, faster than one by one; they are cut short where they hit. Where nothing
    /// is hit, *out[i] is left alone.
    static constexpr uint32_t rays_at_once = Bvh8::rays_at_once;
    void raycast_many(Ray* rays, uint32_t count, uint32_t layers, gphys_hit* const* out) const;
    void raycast_many(Ray* rays, uint32_t count, const RayFilters& filters, gphys_hit* const* out) const;
    /// The same of distances only: out[i] keeps what is in it where nothing is hit.
    void raycast_distance_many(Ray* rays, uint32_t count, uint32_t layers, gphys_distance* const* out) const;
    void raycast_distance_many(Ray* rays, uint32_t count, const RayFilters& filters, gphys_distance* const* out) const;
    bool raycast_any(const Ray& ray, uint32_t layers) const;
    bool raycast_any(const Ray& ray, const QueryFilter& filter) const;
    /// The same for many rays: bit i of the result for ray i.
    uint64_t raycast_any_many(Ray* rays, uint32_t count, uint32_t layers) const;
    uint64_t raycast_any_many(Ray* rays, uint32_t count, const RayFilters& filters) const;
    void raycast_all(const Ray& ray, uint32_t layers, Smallest<gphys_hit, FirstHit>& out) const;
    void raycast_all(const Ray& ray, const QueryFilter& filter, Smallest<gphys_hit, FirstHit>& out) const;
    /// `candidates`: what find_candidates has found for the shape.
    void overlap(const Shape& shape, uint32_t layers, Smallest<gphys_model_id>& out,
                 const OverlapItems* candidates = nullptr) const;
    void overlap(const Shape& shape, const QueryFilter& filter, Smallest<gphys_model_id>& out,
                 const OverlapItems* candidates = nullptr) const;
    /// The first step of overlap for 1 to OverlapItems::most_queries shapes of one type, which takes less time side by
    /// side.
    void find_candidates(const Shape* shapes, uint32_t count, uint32_t layers, OverlapItems* candidates) const;
    gphys_status nearest(Vec3 point, double max_distance, uint32_t layers, gphys_nearest& out) const;
    gphys_status nearest(Vec3 point, double max_distance, const QueryFilter& filter, gphys_nearest& out) const;
    gphys_status sweep(const Sphere& moving, Vec3 displacement, uint32_t layers, gphys_hit& out) const;
    gphys_status sweep(const Sphere& moving, Vec3 displacement, const QueryFilter& filter, gphys_hit& out) const;
    /// For a moving sphere, capsule or box.
    gphys_status sweep(const Shape& moving, Vec3 displacement, uint32_t layers, gphys_hit& out) const;
    gphys_status sweep(const Shape& moving, Vec3 displacement, const QueryFilter& filter, gphys_hit& out) const;
    /// The way of a sphere, capsule or box out of each model, or each triangle of a mesh, that it overlaps.
    void penetration(const Shape& moving, uint32_t layers, DeepestPenetrations& out) const;
    void penetration(const Shape& moving, const QueryFilter& filter, DeepestPenetrations& out) const;
    /// World boxes that lie outside none of the six planes and of the frustum's own box, in
    /// arithmetic rounded outward: a superset of what the frustum sees.
    /// The lowest `capacity` ids, ascending; returns how many there are. Beyond them `out` is scratch.
    uint32_t cull(const Frustum& frustum, uint32_t layers, gphys_model_id* out, uint32_t capacity) const;
    uint32_t cull(const Frustum& frustum, const QueryFilter& filter, gphys_model_id* out, uint32_t capacity) const;
    /// Candidates for what collides: models whose world box touches the box, and planes that touch it, but for those
    /// in the form of a body. visit(id).
    template <class Visit>
    void for_each_in_box(const Box& box, uint32_t layers, Visit&& visit) const;

    // One model, in world space; the id is valid.

    /// Whether the shape itself has a point in the box; a mesh is tested through its tree.
    bool overlaps_box(gphys_model_id model, const Box& box) const;
    bool sweep_model(gphys_model_id model, const Sphere& moving, Vec3 displacement, Hit& hit) const;
    /// Where to push a point to. normal: unit, outward of a solid, towards the point's side of a
    /// surface. signed_distance: < 0 inside a solid, and `out` is the nearest point of its surface.
    /// False only for a mesh without triangles.
    bool closest_point_model(gphys_model_id model, Vec3 point, Vec3& out, Vec3& normal, double& signed_distance) const;
    /// Null if it is a primitive.
    const Mesh* mesh(gphys_model_id model) const { return stored_mesh(IdTable::slot_of(model)); }

private:
    static constexpr uint32_t none = 0xffffffff;

    /// What a model has only while it has a parent or children: most never do.
    struct Family {
        uint32_t parent = none, first_child = none, next = none, previous = none;  // slots
        uint32_t child_count = 0;
        gphys_transform local;
        gphys_transform old_local;  // of set_transforms, should it fail
    };

    /// All data that a query needs of a candidate, in one cache line.
    struct alignas(64) Model {
        gphys_transform world;
        uint32_t layers;
        uint32_t family : 24;  // in families_, or no_family: then local and world are the same
        uint32_t type_ : 6;
        uint32_t moving : 1, carried : 1;  // marks of set_transforms and remove, 0 between calls
        uint32_t shape[6];                 // the public struct, or as much of it as fits, or a ModelMesh

        gphys_shape_type type() const { return static_cast<gphys_shape_type>(type_); }
        bool has_family() const { return family != no_family; }
    };
    static constexpr uint32_t no_family = (1u << 24) - 1;
    /// The rest of a struct that is larger than Model::shape: of a capsule, box or triangle. Of a scaled mesh the ball
    /// around it.
    struct ShapeTail {
        uint32_t words[4];
    };
    static constexpr size_t largest_shape_words = sizeof(gphys_obb) / sizeof(uint32_t);
    /// What a model that is no mesh was given, if its scale is not one.
    struct Unscaled {
        gphys_vec3 scale = no_scale;
        uint32_t shape[largest_shape_words] = {};
    };
    /// The word of Model::shape, unused by planes, that holds where in unbounded_ a plane stands.
    static constexpr size_t position_in_list = sizeof(gphys_plane) / sizeof(uint32_t);
    template <class Stored>
    static constexpr size_t head_size = std::min(sizeof(Stored), sizeof Model::shape);

    // The two steps by which queries see a model (query_filter.h), and both for several that are known to be in the
    // layers: visit(slot) for each that is seen, and how many these are. `layers` is of a query without a filter.
    bool may_see(uint32_t layers, uint32_t slot) const { return (models_[slot].layers & layers) != 0; }
    bool may_see(const QueryFilter& filter, uint32_t slot) const {
        return (models_[slot].layers & filter.layers) != 0 && slot != filter.ignored_slot && !is_below(slot, filter);
    }
    static constexpr bool sees(uint32_t, uint32_t) { return true; }
    bool sees(const QueryFilter& filter, uint32_t slot) const {
        return filter.ignored.empty() || !filter.ignored.hold(ids_.id(slot));
    }
    template <class Visit>
    static uint32_t for_each_seen_of_layers(uint32_t layers, const uint32_t* slots, uint32_t count, Visit&& visit);
    template <class Visit>
    uint32_t for_each_seen_of_layers(const QueryFilter& filter, const uint32_t* slots, uint32_t count,
                                     Visit&& visit) const;
    /// Most models have no family, which is told by what has been read already.
    bool is_below(uint32_t slot, const QueryFilter& filter) const {
        return filter.ignores_below && models_[slot].has_family() && is_below(slot, filter.ignored_slot);
    }
    bool is_below(uint32_t slot, uint32_t top) const;
    static uint32_t layers_of(uint32_t layers) { return layers; }
    static uint32_t layers_of(const QueryFilter& filter) { return filter.layers; }

    // The queries; Filter is uint32_t, for layers, or QueryFilter, and Filters is uint32_t or RayFilters.
    template <class T>
    class Storage;
    template <class Answer>
    class FirstHitOfRay;
    class LargeMeshes;
    template <class Filter>
    gphys_status raycast_by(const Ray& ray, const Filter& filter, gphys_hit& out) const;
    /// Answer is gphys_hit or gphys_distance.
    template <class Filters, class Answer>
    void raycast_many_by(Ray* rays, uint32_t count, const Filters& filters, Answer* const* out) const;
    template <class Filters, class Answer>
    void raycast_bvh_by(Ray* rays, uint32_t count, const Filters& filters, const LargeMeshes& large,
                        Storage<FirstHitOfRay<Answer>>* first) const;
    template <class Filter>
    bool raycast_any_by(const Ray& ray, const Filter& filter) const;
    template <class Filters>
    uint64_t raycast_any_many_by(Ray* rays, uint32_t count, const Filters& filters) const;
    template <class Filter>
    void raycast_all_by(const Ray& ray, const Filter& filter, Smallest<gphys_hit, FirstHit>& out) const;
    template <class Filter>
    void overlap_by(const Shape& shape, const Filter& filter, Smallest<gphys_model_id>& out,
                    const OverlapItems* candidates) const;
    template <class Filter>
    gphys_status nearest_by(Vec3 point, double max_distance, const Filter& filter, gphys_nearest& out) const;
    template <class Filter>
    gphys_status sweep_by(const Sphere& moving, Vec3 displacement, const Filter& filter, gphys_hit& out) const;
    template <class Filter>
    gphys_status sweep_by(const Shape& moving, Vec3 displacement, const Filter& filter, gphys_hit& out) const;
    template <class Filter>
    void penetration_by(const Shape& moving, const Filter& filter, DeepestPenetrations& out) const;
    template <class Filter>
    uint32_t cull_by(const Frustum& frustum, const Filter& filter, gphys_model_id* out, uint32_t capacity) const;

    class EightPairs;
    class ConservativeRays;
    class SharedModel;

    ItemMemory model_memory() const { return {models_.data(), sizeof(Model)}; }
    ItemMemory id_memory() const { return {ids_.ids(), sizeof(uint32_t)}; }
    /// Whether of a model wholly inside a solid only its id is read: all models are in the layers.
    bool inside_is_enough(uint32_t layers) const { return (common_layers_ & layers) != 0; }
    ItemMemory memory_of_inside(uint32_t layers) const {
        return inside_is_enough(layers) ? id_memory() : model_memory();
    }
    const Model& at(gphys_model_id model) const { return models_[IdTable::slot_of(model)]; }

    // Shapes. visit gets some public struct, or ModelMesh, of the type; the model's; the same placed
    // in the world.
    template <class Visit>
    static auto with_type(gphys_shape_type type, Visit&& visit);
    template <class Visit>
    auto with_stored(uint32_t slot, Visit&& visit) const;
    template <class Visit>
    auto with_shape(uint32_t slot, Visit&& visit) const;
    template <class Stored>
    Stored stored(uint32_t slot) const;
    /// Test a model that has passed the layer mask: the conservative test of the stored shape, then, if undecided, the
    /// filter and the exact test of the shape in world space.
    template <class Filter, class Conservative, class Exact>
    bool decide(const Filter& filter, uint32_t slot, Conservative&& conservative, Exact&& exact) const;
    template <class Filter>
    bool hits_unbounded(const Ray& ray, const Filter& filter) const;
    template <class Answers, class OnHit>
    uint32_t hits_by_kernels(const EightPairs& pairs, const Ray* rays, const OnHit& hit) const;
    void make_room_for_shapes(gphys_shape_type type, bool scaled, size_t size);
    void store_shape(uint32_t slot, const void* shape, const gphys_vec3& scale);
    void store_ball(uint32_t slot, const ModelMesh& stored);
    gphys_status change_shape(uint32_t slot, gphys_shape_type type, const void* shape, const gphys_vec3& scale);
    gphys_vec3 scale_of(uint32_t slot) const;
    /// Null if it is a primitive.
    const Mesh* stored_mesh(uint32_t slot) const {
        return models_[slot].type() == GPHYS_SHAPE_MESH ? stored<ModelMesh>(slot).mesh : nullptr;
    }
    void discard_shape(uint32_t slot);
    void let_go(const Mesh* mesh, uint32_t slot);
    void list_large_mesh(uint32_t slot);
    void unlist_large_mesh(uint32_t slot);
    double mesh_radius(uint32_t slot) const;
    /// Whether it has the form of a body of a solver, which collides with other bodies by itself.
    bool is_body(uint32_t slot) const {
        const Mesh* const mesh = stored_mesh(slot);
        return mesh && mesh->is_body();
    }
    void list_unbounded(uint32_t slot);
    void unlist_unbounded(uint32_t position);

    // Families, by slot.
    Family& family(uint32_t slot) { return families_[models_[slot].family]; }
    const Family& family(uint32_t slot) const { return families_[models_[slot].family]; }
    Family& take_family(uint32_t slot);
    void drop_family_if_alone(uint32_t slot);
    uint32_t parent_of(uint32_t slot) const { return models_[slot].has_family() ? family(slot).parent : none; }
    void link(uint32_t slot, uint32_t parent);
    void unlink(uint32_t slot);
    /// The slot after `slot` in a walk through the tree of models below `top`, parents first.
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
    void forget_place(uint32_t slot);
    Box world_box(uint32_t slot, const gphys_transform& world) const;
    /// What is wrong with a model that stands there; its box, but not of a plane.
    const char* place(uint32_t slot, const gphys_transform& world, Box& box) const;
    const char* place(uint32_t slot, const gphys_transform& world) const;
    float farthest_point(uint32_t slot) const;
    template <class PutSome>
    void put_all(uint32_t count, bool on_any_thread, const PutSome& put_some) const;
    template <class Put>
    void put_eight(const gphys_model_id* models, uint32_t count, const Put& put) const;
    /// What is wrong with one of the transforms: then none has moved.
    const char* move_alone(const gphys_model_id* models, const Strided<gphys_transform>& local, uint32_t count);
    const char* move_with_relatives(const gphys_model_id* models, const Strided<gphys_transform>& local,
                                    uint32_t count);
    const char* carry(uint32_t top, uint32_t& moved);
    void carry_back(uint32_t top);
    template <class Put>
    void put_below(uint32_t top, const Put& put) const;
    void mark_carried(const gphys_model_id* models, uint32_t count);
    void unmark_carried(const gphys_model_id* models, uint32_t count);
    const char* carry_relatives(const gphys_model_id* models, uint32_t count, uint32_t& moved);
    void put_back_relatives(const gphys_model_id* models, uint32_t count);

    /// What a deformable mesh tells of its new form, model by model.
    class MeshFollower final : public MeshUser {
    public:
        explicit MeshFollower(Scene& scene) : scene_(scene) {}
        const char* refusal_of_mesh(uint32_t slot) const override;
        void mesh_changed(uint32_t slot) noexcept override;
        void mesh_shifted(uint32_t slot, Vec3 by) noexcept override;

    private:
        Scene& scene_;
    };
    // Snapshots.
    struct Contents;
    void exchange(Contents& other) noexcept;
    void release_meshes();
    template <class Visit>
    void for_each_mesh(Visit&& visit) const;
    template <class Sink, class PutMesh>
    void write_state(Sink& sink, const PutMesh& put_mesh) const;
    const char* find_meshes(const Vector<UsedMesh>& wanted, const uint32_t* embedded, uint32_t embedded_words,
                            const Scene& library, HeldMeshes& found);
    const char* read_models(Reader& reader, const HeldMeshes& meshes, uint32_t parts);
    bool any_scaled() const;
    const char* hang_up(const Vector<uint32_t>& parents);
    const char* lay_out(const BvhLayout& layout);

    const SceneKernels& kernels_ = scene_kernels(chosen_isa());
    const BoundsKernels& bounds_kernels_ = bounds_kernels(chosen_isa());
    const SlotSetKernels& slot_set_kernels_ = slot_set_kernels(chosen_isa());
    const HitKernels* hit_kernels_ = hit_kernels(chosen_isa());  // null without a wide set
    const Workers workers_;
    IdTable ids_{&memory};
    LargeArray<Model> models_{&memory};           // by slot
    LargeArray<uint32_t> tags_{&memory};          // by slot
    LargeArray<ShapeTail> shape_tails_{&memory};  // by slot, up to the last that needed one
    Pool<Family> families_{&memory};
    Bvh8 bvh_{&memory, chosen_isa(), &workers_};  // items are slots
    Vec3 origin_;                                 // in the world, of all coordinates
    LargeArray<WorldPlace> places_{&memory};          // by slot, of models without a parent; since set_origin
    LargeArray<Unscaled> unscaled_{&memory};          // by slot, up to the last that needed one
    float widest_scale_ = 1;                      // of all meshes that there were, their largest number or inverse
    float farthest_point_ = 0;                    // of all shapes that there were, from the origins of their models
    // That each model is in, a change of layers may leave some out; none if there is a model without
    // any point, an empty mesh.
    uint32_t common_layers_ = ~0u;
    Vector<uint32_t> unbounded_{&memory};  // slots of planes: no BVH holds them, and there are few
    // Slots of meshes that were the largest when they were added. Batches of rays are quicker if such a mesh answers
    // many rays at once; the answers do not depend on which are listed.
    static constexpr uint32_t most_large_meshes = 4;
    uint32_t large_meshes_[most_large_meshes], large_mesh_count_ = 0;
    MeshFollower mesh_follower_{*this};
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
        if (verdict == TriState::no || !sees(filter, slot)) return false;
        return verdict == TriState::open ? with_placed(shape, world, exact) : verdict == TriState::yes;
    });
}

/// Tell the BVH where the models from `top` down are.
template <class Put>
void Scene::put_below(uint32_t top, const Put& put) const {
    for (uint32_t slot = top; slot != none; slot = next_below(slot, top)) {
        if (models_[slot].type() != GPHYS_SHAPE_PLANE) put(slot, world_box(slot, models_[slot].world));
    }
}

template <class Visit>
uint32_t Scene::for_each_seen_of_layers(uint32_t, const uint32_t* slots, uint32_t count, Visit&& visit) {
    std::for_each(slots, slots + count, visit);
    return count;
}

template <class Visit>
uint32_t Scene::for_each_seen_of_layers(const QueryFilter& filter, const uint32_t* slots, uint32_t count,
                                        Visit&& visit) const {
    const auto visit_if = [&](const auto& is_seen) {
        uint32_t seen = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (!is_seen(slots[i])) continue;
            visit(slots[i]);
            ++seen;
        }
        return seen;
    };
    const auto is_other = [&](uint32_t slot) { return slot != filter.ignored_slot; };
    if (!filter.ignores_below && filter.ignored.empty()) return visit_if(is_other);
    return visit_if([&](uint32_t slot) { return is_other(slot) && !is_below(slot, filter) && sees(filter, slot); });
}

template <class Visit>
void Scene::for_each_model(Visit&& visit) const {
    for (uint32_t slot = 0; slot < ids_.slots(); ++slot) {
        if (ids_.live(slot)) visit(ids_.id(slot));
    }
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
    const auto offer = [&](uint32_t slot) {
        if ((models_[slot].layers & layers) != 0 && !is_body(slot)) visit(ids_.id(slot));
        return true;
    };
    for (const uint32_t slot : unbounded_) {
        if (overlaps_box(ids_.id(slot), box)) offer(slot);
    }
    bvh_.overlap_box(
        box, [&](uint32_t slot, bool) { return offer(slot); }, model_memory(), model_memory());
}

/// As Scene::closest_point_model, of a triangle in world space.
void closest_point_triangle(const Triangle& triangle, Vec3 point, Vec3& out, Vec3& normal, double& distance);

}  // namespace gphys

// Models - a shape or a shared mesh, placed in the world, perhaps below a parent - and the octree
// that finds them. The C layer has checked all values; ids are checked here.
//
//   scene_models.cpp      models come and go
//   scene_transforms.cpp  they move, and their descendants with them
//   scene_queries.cpp     rays, overlaps, nearest, sweeps, culling
//   scene_contact.cpp     one model and one point, for collision response
//   scene_validate.cpp    is everything in agreement?
//
// Worlds. A model's world transform is kept as float32. Everything else is derived from it: the
// shape in the world (in double precision, when a query asks), and the model's box in the octree
// (rounded outward). A query walks the octree, asks the exact shape of each candidate, and lets the
// octree know how near the best answer is.
#pragma once

#include "ids.h"
#include "intersect.h"
#include "octree.h"
#include "pool.h"
#include "results.h"
#include "status.h"

namespace gphys {

class Mesh;

/// By t as the caller sees it, then id: the order of lists of hits.
struct FirstHit {
    bool operator()(const gphys_hit& a, const gphys_hit& b) const { return a.t != b.t ? a.t < b.t : a.model < b.model; }
};

class Scene {
public:
    explicit Scene(const gphys_allocator* hooks, uint32_t reserve_models = 0);
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene();

    Memory memory;

    // Models. Whatever fails, by status or by std::bad_alloc, leaves the scene as it was.

    /// `shapes` are public structs of the type, strided, or one Mesh; `transforms` may be null.
    gphys_status add(gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                     const gphys_transform* transforms, uint32_t transform_stride, uint32_t count,
                     const gphys_model_desc& desc, gphys_model_id* out_models);
    gphys_status remove(const gphys_model_id* models, uint32_t count);
    gphys_status remove_subtree(gphys_model_id model);
    void clear();
    gphys_status set_parent(gphys_model_id model, gphys_model_id parent, bool keep_world);
    gphys_status set_transforms(const gphys_model_id* models, const gphys_transform* transforms,
                                uint32_t transform_stride, uint32_t count);
    gphys_status set_layers(gphys_model_id model, uint32_t layers);
    gphys_status set_tag(gphys_model_id model, uint32_t tag);

    bool has(gphys_model_id model) const { return ids_.has(model); }
    /// GPHYS_OK, or the failure that names a stale id.
    gphys_status check(gphys_model_id model) const;
    uint32_t size() const { return ids_.size(); }
    template <class Visit>
    void for_each_model(Visit&& visit) const;  // visit(id), by slot

    // About one model; the id is valid.
    gphys_shape_type type(gphys_model_id model) const { return at(model).type; }
    uint32_t layers(gphys_model_id model) const { return at(model).layers; }
    uint32_t tag(gphys_model_id model) const { return at(model).tag; }
    gphys_model_id parent(gphys_model_id model) const;
    uint32_t child_count(gphys_model_id model) const;
    const gphys_transform& local(gphys_model_id model) const;
    const gphys_transform& world(gphys_model_id model) const { return at(model).world; }
    Transform world_transform(gphys_model_id model) const { return widen(at(model).world); }
    /// The public struct that add was given; not for meshes.
    const void* shape(gphys_model_id model) const;
    /// The shape where it stands in the world; not for meshes.
    Shape world_shape(gphys_model_id model) const;
    const Mesh& mesh(gphys_model_id model) const;
    /// False if the model is unbounded.
    bool bounds(gphys_model_id model, Box& out) const;

    const Octree& octree() const { return octree_; }
    uint32_t unbounded_count() const { return static_cast<uint32_t>(planes_.size()); }
    /// What is wrong inside, or nullptr.
    const char* defect() const;

    // Queries see the models of which layers & the model's layers is not 0. GPHYS_OK or GPHYS_NO_HIT.

    gphys_status raycast(const Ray& ray, uint32_t layers, gphys_hit& out) const;
    bool raycast_any(const Ray& ray, uint32_t layers) const;
    void raycast_all(const Ray& ray, uint32_t layers, Smallest<gphys_hit, FirstHit>& out) const;
    void overlap(const Shape& shape, uint32_t layers, Smallest<gphys_model_id>& out) const;
    gphys_status nearest(Vec3 point, double max_distance, uint32_t layers, gphys_nearest& out) const;
    gphys_status sweep(const Sphere& moving, Vec3 displacement, uint32_t layers, gphys_hit& out) const;
    /// By world boxes, not shapes: a superset of what the frustum sees.
    void cull(const Frustum& frustum, uint32_t layers, Smallest<gphys_model_id>& out) const;
    /// Candidates: models whose world box touches the box, and all unbounded ones. visit(id).
    template <class Visit>
    void for_each_in_box(const Box& box, uint32_t layers, Visit&& visit) const;

    // One model, in world space; the id is valid.

    bool raycast_model(gphys_model_id model, const Ray& ray, Hit& hit) const;
    bool sweep_model(gphys_model_id model, const Sphere& moving, Vec3 displacement, Hit& hit) const;
    bool overlaps_model(gphys_model_id model, const Shape& shape) const;
    /// False only for a mesh without triangles within max_distance.
    bool closest_point_model(gphys_model_id model, Vec3 point, double max_distance, Vec3& out,
                             uint32_t& triangle) const;
    /// Where to push a point to. normal: unit, outward of a solid, towards the point's side of a
    /// surface. signed_distance: < 0 inside a solid, and `out` is the nearest point of its surface.
    /// False only for a mesh without triangles.
    bool closest_point_model(gphys_model_id model, Vec3 point, Vec3& out, Vec3& normal, double& signed_distance) const;

private:
    static constexpr uint32_t none = 0xffffffff;

    /// Where a plane lives: no octree can hold it, so queries go through all of them.
    struct PlaneModel {
        gphys_plane plane;
        uint32_t slot;
    };

    /// What a model has only if it has a parent or children: most do not.
    struct Family {
        uint32_t parent = none, first_child = none, next = none, previous = none;  // slots
        uint32_t child_count = 0;
        gphys_transform local;
    };

    struct Model {
        gphys_transform world;
        uint32_t layers;
        uint32_t tag;
        uint32_t shape;   // index into the pool of its type
        uint32_t family;  // index into families_, or none: then local and world are the same
        gphys_shape_type type : 8;
        uint32_t marked : 1;  // for the moment: seen by the walk that is under way
        uint32_t moving : 1;  // for the moment: in the list of what moves
    };

    /// A model that is being moved, and how to undo it.
    struct Move {
        uint32_t slot;
        gphys_transform world, local;
    };

    const Model& at(gphys_model_id model) const { return models_[IdTable::slot_of(model)]; }

    IdTable ids_{&memory};
    Vector<Model> models_{&memory};  // by slot
    Pool<gphys_sphere> spheres_{&memory};
    Pool<gphys_capsule> capsules_{&memory};
    Pool<gphys_aabb> aabbs_{&memory};
    Pool<gphys_obb> obbs_{&memory};
    Pool<gphys_triangle> triangles_{&memory};
    Pool<const Mesh*> meshes_{&memory};
    Pool<Family> families_{&memory};
    Vector<PlaneModel> planes_{&memory};
    Octree octree_{&memory};
};

template <class Visit>
void Scene::for_each_model(Visit&& visit) const {
    for (uint32_t slot = 0; slot < ids_.slots(); ++slot) {
        if (ids_.live(slot)) visit(ids_.id(slot));
    }
}

template <class Visit>
void Scene::for_each_in_box(const Box& box, uint32_t layers, Visit&& visit) const {
    octree_.overlap_box(box, [&](uint32_t slot) {
        if (models_[slot].layers & layers) visit(ids_.id(slot));
        return true;
    });
    for (const PlaneModel& plane : planes_) {
        if (models_[plane.slot].layers & layers) visit(ids_.id(plane.slot));
    }
}

}  // namespace gphys

// Adding, removing, changing and parenting models. Each change reserves memory, checks its arguments, and only then
// modifies the scene, which cannot fail (strong exception guarantee). The hierarchy is a tree of first child and
// siblings.
#include <algorithm>
#include <type_traits>

#include "foundation/strided.h"
#include "scene/scene.h"

namespace gphys {
namespace {

constexpr char id_of_model[] = "the id of a model of the scene";

/// Makes slots below `size` exist. If a later allocation fails, the additional slots do no harm.
template <class T>
void grow(LargeArray<T>& by_slot, size_t size) {
    if (size <= by_slot.size()) return;
    reserve_more(by_slot, size - by_slot.size());
    by_slot.resize(size);
}

}  // namespace

Scene::Scene(const gphys_allocator* hooks, uint32_t reserve_models, uint32_t worker_count,
             const gphys_task_runner* task_runner)
    : memory(hooks), workers_(worker_count, task_runner, &memory) {
    const uint32_t slots = reserve_models == 0 ? 0 : IdTable::slots_for(reserve_models);
    ids_.reserve(slots);
    models_.reserve(slots);
    tags_.reserve(slots);
    layer_blocks_.reserve(slots);
    bvh_.reserve(slots);
}

Scene::~Scene() { clear(); }

gphys_status Scene::check(gphys_model_id model) const {
    return has(model) ? GPHYS_OK : fail(GPHYS_ERROR_INVALID_ID, "model", model, id_of_model);
}

/// Reserves what store_shape writes for slots below `size`.
void Scene::reserve_shapes(gphys_shape_type type, bool scaled, size_t size) {
    const bool is_mesh = type == GPHYS_SHAPE_MESH;
    if (is_mesh ? scaled : with_type(type, [](auto stored) { return sizeof stored > sizeof Model::shape; })) {
        grow(shape_tails_, size);
    }
    if (scaled && !is_mesh) grow(unscaled_, size);
}

void Scene::store_shape(uint32_t slot, const void* shape, const gphys_vec3& scale) {
    const bool is_scaled = !is_one(scale), is_mesh = models_[slot].type() == GPHYS_SHAPE_MESH;
    if (slot < unscaled_.size()) unscaled_[slot] = Unscaled();
    if (is_scaled) widest_scale_ = std::max(widest_scale_, is_mesh ? largest_factor(scale) : 1);
    with_type(models_[slot].type(), [&](auto stored) {
        if constexpr (std::is_same_v<decltype(stored), ModelMesh>) {
            stored = ModelMesh(static_cast<const Mesh*>(shape), scale);
            stored.mesh->retain();
            if (is_scaled) store_ball(slot, stored);
        } else {
            std::memcpy(&stored, shape, sizeof stored);
            if (is_scaled) {
                unscaled_[slot].scale = scale;
                std::memcpy(unscaled_[slot].shape, shape, sizeof stored);
                stored = scaled(stored, scale);
            }
        }
        constexpr size_t head = head_size<decltype(stored)>;
        std::memcpy(models_[slot].shape, &stored, head);
        if constexpr (sizeof stored > head) {
            std::memcpy(&shape_tails_[slot], reinterpret_cast<const char*>(&stored) + head, sizeof stored - head);
        }
    });
}

void Scene::release_shape(uint32_t slot) {
    if (const Mesh* mesh = stored_mesh(slot)) release_mesh(mesh, slot);
}

/// Batches of rays read the bounding sphere of a scaled mesh from its ShapeTail.
void Scene::store_ball(uint32_t slot, const ModelMesh& stored) {
    const gphys_sphere ball = ball_around(*stored.mesh, stored.axes());
    static_assert(sizeof ball == sizeof(ShapeTail));
    std::memcpy(&shape_tails_[slot], &ball, sizeof ball);
}

gphys_vec3 Scene::scale_of(uint32_t slot) const {
    if (models_[slot].type() == GPHYS_SHAPE_MESH) return stored<ModelMesh>(slot).scale;
    return slot < unscaled_.size() ? unscaled_[slot].scale : no_scale;
}

void Scene::release_mesh(const Mesh* mesh, uint32_t slot) {
    mesh->leave(mesh_follower_, slot);
    Mesh::release(mesh);
}

const char* Scene::MeshFollower::check_mesh(uint32_t slot) const {
    const ModelMesh stored = scene_.stored<ModelMesh>(slot);
    if (const ScaleError error = check_scale(*stored.mesh, stored.scale)) return error.why;
    Box box;
    return scene_.check_placement(slot, scene_.models_[slot].world, box);
}

void Scene::MeshFollower::mesh_changed(uint32_t slot) noexcept {
    const ModelMesh stored = scene_.stored<ModelMesh>(slot);
    if (stored.is_scaled) scene_.store_ball(slot, stored);
    scene_.bvh_.update(slot, scene_.world_box(slot, scene_.models_[slot].world));
    scene_.farthest_point_ = std::max(scene_.farthest_point_, scene_.farthest_point(slot));
}

/// The model stays where it is if the new position is out of range.
void Scene::MeshFollower::mesh_shifted(uint32_t slot, Vec3 by) noexcept {
    gphys_transform local = scene_.local_of(slot);
    const Transform wide = widen(local);
    const AxisScale axes = scene_.stored<ModelMesh>(slot).axes();
    const Vec3 back = -(wide.rotation * (axes(by) * wide.scale));
    const bool placed = slot < scene_.places_.size() && scene_.parent_of(slot) == none;
    WorldPlace place = placed ? scene_.places_[slot] : WorldPlace();
    const Vec3 position = place.move(scene_.origin_, local.position, back);
    if (!(max_component(abs(position)) <= GPHYS_MAX_COORDINATE)) return;
    local.position = narrow(position);
    const gphys_model_id model = scene_.ids_.id(slot);
    try {
        if (scene_.set_transforms(&model, &local, 0, 1) == GPHYS_OK && placed) scene_.places_[slot] = place;
    } catch (const std::bad_alloc&) {  // the model stays
    }
}

gphys_status Scene::add(gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                        const gphys_transform* transforms, uint32_t transform_stride, uint32_t count,
                        Strided<gphys_model_desc> descs, gphys_model_id* out_models) {
    uint32_t with_parent = 0, common_layers = ~0u;
    bool is_scaled = false;
    const Strided<char> shape(static_cast<const char*>(shapes), shape_stride);
    for (uint32_t i = 0; i < count; ++i) {
        if (const ScaleError error = check_scale(type, &shape[i], descs[i].scale)) return fail(error.status, error.why);
        is_scaled = is_scaled || !is_one(descs[i].scale);
        if (descs[i].parent != 0 && !has(descs[i].parent)) {
            return fail(GPHYS_ERROR_INVALID_ID, "desc.parent", descs[i].parent, id_of_model);
        }
        with_parent += descs[i].parent != 0;
        common_layers &= descs[i].layers;
    }
    if (!ids_.reserve(count)) return fail(GPHYS_ERROR_CAPACITY, "the scene would have more than 2^24 - 1 models");
    if (count == 0) return GPHYS_OK;

    Vector<uint32_t> slots(count, &memory);
    Vector<Box> boxes(count, &memory);
    ids_.next_slots(count, slots.data());
    const size_t slots_needed = *std::max_element(slots.begin(), slots.end()) + size_t{1};
    grow(models_, slots_needed);
    grow(tags_, slots_needed);
    layer_blocks_.grow(slots_needed);
    reserve_shapes(type, is_scaled, slots_needed);
    const bool bounded = type != GPHYS_SHAPE_PLANE;
    if (!bounded) reserve_more(unbounded_, count);
    families_.reserve(2 * with_parent);  // a parent may need a Family, too

    // Slots without an id are not read: what is written there has no effect before ids_.add().
    constexpr gphys_transform identity{{0, 0, 0}, {0, 0, 0, 1}, 1};
    const Strided<gphys_transform> local(transforms ? transforms : &identity, transforms ? transform_stride : 0);
    uint32_t placed = 0;
    const Mesh* const mesh = type == GPHYS_SHAPE_MESH ? static_cast<const Mesh*>(shapes) : nullptr;
    if (mesh) mesh->join(mesh_follower_, slots.data(), count);
    const auto release_all = [&] {
        for (uint32_t i = 0; i < placed; ++i) release_shape(slots[i]);
        for (uint32_t i = placed; mesh && i < count; ++i) mesh->leave(mesh_follower_, slots[i]);
    };
    for (; placed < count;) {
        const uint32_t slot = slots[placed];
        const gphys_model_desc& desc = descs[placed];
        Model& model = models_[slot];
        model = {};
        model.world =
            desc.parent != 0 ? composed(models_[IdTable::slot_of(desc.parent)].world, local[placed]) : local[placed];
        model.layers = desc.layers;
        model.family = no_family;
        model.type_ = static_cast<uint32_t>(type);
        tags_[slot] = desc.tag;
        store_shape(slot, &shape[placed], desc.scale);
        ++placed;
        farthest_point_ = std::max(farthest_point_, farthest_point(slot));
        const char* wrong = check_placement(slot, model.world, boxes[placed - 1]);
        if (wrong) {
            release_all();
            return fail(GPHYS_ERROR_INVALID_ARGUMENT, wrong);
        }
    }
    if (bounded) {
        try {
            bvh_.insert_many(slots.data(), boxes.data(), count);
        } catch (...) {
            release_all();
            throw;
        }
    }

    const bool is_empty = mesh && mesh->triangle_count() == 0;
    common_layers_ = is_empty ? 0 : size() == 0 ? common_layers : common_layers_ & common_layers;
    for (uint32_t i = 0; i < count; ++i) {
        out_models[i] = ids_.add();
        layer_blocks_.add(slots[i], descs[i].layers);
        if (!bounded) list_unbounded(slots[i]);
        if (type == GPHYS_SHAPE_MESH) list_large_mesh(slots[i]);
        if (descs[i].parent != 0) {
            link(slots[i], IdTable::slot_of(descs[i].parent));
            family(slots[i]).local = local[i];
        }
    }
    return GPHYS_OK;
}

gphys_status Scene::set_shape(gphys_model_id id, gphys_shape_type type, const void* shape) {
    GPHYS_TRY(check(id));
    const uint32_t slot = IdTable::slot_of(id);
    return change_shape(slot, type, shape, scale_of(slot));
}

gphys_status Scene::set_scale(gphys_model_id id, const gphys_vec3& scale) {
    GPHYS_TRY(check(id));
    const uint32_t slot = IdTable::slot_of(id);
    if (const Mesh* mesh = stored_mesh(slot)) return change_shape(slot, type(id), mesh, scale);
    uint32_t shape[largest_shape_words];
    copy_unscaled_shape(id, shape);
    return change_shape(slot, type(id), shape, scale);
}

/// Stores the new shape in place of the old one, so that check_placement() reads it, and restores the old one on
/// errors.
gphys_status Scene::change_shape(uint32_t slot, gphys_shape_type type, const void* shape, const gphys_vec3& scale) {
    if (const ScaleError error = check_scale(type, shape, scale)) return fail(error.status, error.why);
    reserve_shapes(type, !is_one(scale), slot + size_t{1});
    const bool bounded = type != GPHYS_SHAPE_PLANE, was_bounded = models_[slot].type() != GPHYS_SHAPE_PLANE;
    if (was_bounded && !bounded) reserve_more(unbounded_, 1);
    if (type == GPHYS_SHAPE_MESH) static_cast<const Mesh*>(shape)->join(mesh_follower_, &slot, 1);

    Model& model = models_[slot];
    const Model old = model;
    const ShapeTail old_tail = slot < shape_tails_.size() ? shape_tails_[slot] : ShapeTail();
    const Unscaled old_unscaled = slot < unscaled_.size() ? unscaled_[slot] : Unscaled();
    model.type_ = static_cast<uint32_t>(type);
    store_shape(slot, shape, scale);  // retains the new mesh before the old one is released; they may be the same
    const auto restore = [&] {
        release_shape(slot);
        model = old;
        if (slot < shape_tails_.size()) shape_tails_[slot] = old_tail;
        if (slot < unscaled_.size()) unscaled_[slot] = old_unscaled;
    };
    Box box;
    if (const char* wrong = check_placement(slot, model.world, box)) {
        restore();
        return fail(GPHYS_ERROR_INVALID_ARGUMENT, wrong);
    }
    if (bounded && !was_bounded) {
        try {
            bvh_.insert(slot, box);
        } catch (...) {
            restore();
            throw;
        }
    }

    if (was_bounded && bounded) bvh_.update(slot, box);
    if (was_bounded && !bounded) bvh_.remove(slot);
    if (!was_bounded && bounded) unlist_unbounded(old.shape[position_in_list]);
    if (was_bounded && !bounded) list_unbounded(slot);
    unlist_large_mesh(slot);
    if (type == GPHYS_SHAPE_MESH) {
        list_large_mesh(slot);
        if (static_cast<const Mesh*>(shape)->triangle_count() == 0) common_layers_ = 0;
    }
    farthest_point_ = std::max(farthest_point_, farthest_point(slot));
    if (old.type() == GPHYS_SHAPE_MESH) {
        ModelMesh was;
        std::memcpy(&was, old.shape, sizeof was);
        release_mesh(was.mesh, slot);
    }
    return GPHYS_OK;
}

gphys_status Scene::remove(const gphys_model_id* models, uint32_t count) {
    gphys_status status = GPHYS_OK;
    uint32_t marked = 0;
    for (; marked < count && status == GPHYS_OK; ++marked) {
        status = check(models[marked]);
        if (status != GPHYS_OK) break;
        Model& model = models_[IdTable::slot_of(models[marked])];
        if (model.moving) {
            status = fail(GPHYS_ERROR_INVALID_ID, "models: an id is listed twice");
            break;
        }
        model.moving = 1;
    }
    for (uint32_t i = 0; i < marked; ++i) models_[IdTable::slot_of(models[i])].moving = 0;
    if (status != GPHYS_OK) return status;
    for (uint32_t i = 0; i < count; ++i) remove_slot(IdTable::slot_of(models[i]));
    return GPHYS_OK;
}

void Scene::remove_slot(uint32_t slot) {
    layer_blocks_.remove(slot, models_[slot].layers);
    while (models_[slot].has_family() && family(slot).first_child != none) {
        const uint32_t child = family(slot).first_child;
        family(child).local = models_[child].world;
        unlink(child);
    }
    if (models_[slot].has_family()) unlink(slot);
    if (models_[slot].type() == GPHYS_SHAPE_PLANE) {
        unlist_unbounded(models_[slot].shape[position_in_list]);
    } else {
        bvh_.remove(slot);
    }
    unlist_large_mesh(slot);
    release_shape(slot);
    reset_place(slot);
    ids_.remove(ids_.id(slot));
}

/// So that the state does not depend on an earlier model in the slot.
void Scene::reset_place(uint32_t slot) {
    if (slot < places_.size()) places_[slot] = WorldPlace();
}

double Scene::mesh_radius(uint32_t slot) const {
    const ModelMesh model = stored<ModelMesh>(slot);
    return model.mesh->radius(model.axes()) * double{models_[slot].world.scale};
}

void Scene::list_large_mesh(uint32_t slot) {
    if (large_mesh_count_ < most_large_meshes) {
        large_meshes_[large_mesh_count_++] = slot;
        return;
    }
    const auto smaller = [&](uint32_t a, uint32_t b) { return mesh_radius(a) < mesh_radius(b); };
    uint32_t* const smallest = std::min_element(large_meshes_, large_meshes_ + most_large_meshes, smaller);
    if (smaller(*smallest, slot)) *smallest = slot;
}

void Scene::unlist_large_mesh(uint32_t slot) {
    uint32_t* const end = std::remove(large_meshes_, large_meshes_ + large_mesh_count_, slot);
    large_mesh_count_ = static_cast<uint32_t>(end - large_meshes_);
}

/// Memory was reserved before.
void Scene::list_unbounded(uint32_t slot) {
    models_[slot].shape[position_in_list] = static_cast<uint32_t>(unbounded_.size());
    unbounded_.push_back(slot);
}

/// Swap and pop.
void Scene::unlist_unbounded(uint32_t position) {
    const uint32_t last = unbounded_.back();
    unbounded_.pop_back();
    if (position == unbounded_.size()) return;
    unbounded_[position] = last;
    models_[last].shape[position_in_list] = position;
}

gphys_status Scene::remove_subtree(gphys_model_id model) {
    GPHYS_TRY(check(model));
    // Postorder, so that no child becomes a root before its removal.
    const uint32_t top = IdTable::slot_of(model);
    for (uint32_t slot = top;;) {
        while (models_[slot].has_family() && family(slot).first_child != none) slot = family(slot).first_child;
        const uint32_t parent = parent_of(slot);
        remove_slot(slot);
        if (slot == top) return GPHYS_OK;
        slot = parent;
    }
}

void Scene::clear() {
    bvh_.clear();
    unbounded_.clear();
    large_mesh_count_ = 0;
    for_each_model([&](gphys_model_id model) {
        release_shape(IdTable::slot_of(model));
        ids_.remove(model);
    });
    layer_blocks_.clear();
    families_.clear();
    places_.clear();
    unscaled_.clear();
    farthest_point_ = 0;
    widest_scale_ = 1;
}

gphys_status Scene::set_layers(gphys_model_id model, uint32_t layers) {
    GPHYS_TRY(check(model));
    const uint32_t slot = IdTable::slot_of(model);
    layer_blocks_.remove(slot, models_[slot].layers);
    layer_blocks_.add(slot, layers);
    models_[slot].layers = layers;
    common_layers_ &= layers;
    return GPHYS_OK;
}

gphys_status Scene::set_tag(gphys_model_id model, uint32_t tag) {
    const gphys_status status = check(model);
    if (status == GPHYS_OK) tags_[IdTable::slot_of(model)] = tag;
    return status;
}

gphys_model_id Scene::parent(gphys_model_id model) const {
    const uint32_t slot = parent_of(IdTable::slot_of(model));
    return slot == none ? 0 : ids_.id(slot);
}

uint32_t Scene::child_count(gphys_model_id model) const {
    return at(model).has_family() ? families_[at(model).family].child_count : 0;
}

void Scene::copy_shape(gphys_model_id model, void* out) const {
    with_stored(IdTable::slot_of(model), [&](const auto& stored) { std::memcpy(out, &stored, sizeof stored); });
}

void Scene::copy_unscaled_shape(gphys_model_id model, void* out) const {
    const uint32_t slot = IdTable::slot_of(model);
    if (is_one(scale_of(slot))) return copy_shape(model, out);
    with_type(type(model), [&](auto shape) { std::memcpy(out, unscaled_[slot].shape, sizeof shape); });
}

bool Scene::bounds(gphys_model_id model, Box& out) const {
    if (type(model) == GPHYS_SHAPE_PLANE) return false;
    out = bvh_.box(IdTable::slot_of(model));
    return true;
}

// Families: parents, children and siblings.

/// The model's Family; makes one if there is none. Memory was reserved before.
Scene::Family& Scene::ensure_family(uint32_t slot) {
    Model& model = models_[slot];
    if (!model.has_family()) {
        Family alone;
        alone.local = model.world;
        model.family = families_.add(alone);
    }
    return families_[model.family];
}

void Scene::drop_family_if_alone(uint32_t slot) {
    Model& model = models_[slot];
    const Family& record = families_[model.family];
    if (record.parent != none || record.first_child != none) return;
    families_.remove(model.family);
    model.family = no_family;
}

void Scene::link(uint32_t slot, uint32_t parent) {
    ensure_family(parent);
    Family& child = ensure_family(slot);
    Family& above = family(parent);
    child.parent = parent;
    child.next = above.first_child;
    child.previous = none;
    if (child.next != none) family(child.next).previous = slot;
    above.first_child = slot;
    ++above.child_count;
}

/// Makes the model a root. Drops Families that are no longer needed.
void Scene::unlink(uint32_t slot) {
    Family& child = family(slot);
    const uint32_t parent = child.parent;
    if (parent != none) {
        Family& above = family(parent);
        if (child.previous != none) {
            family(child.previous).next = child.next;
        } else {
            above.first_child = child.next;
        }
        if (child.next != none) family(child.next).previous = child.previous;
        --above.child_count;
        child.parent = child.next = child.previous = none;
        drop_family_if_alone(parent);
    }
    drop_family_if_alone(slot);
}

uint32_t Scene::next_below(uint32_t slot, uint32_t top) const {
    if (models_[slot].has_family() && family(slot).first_child != none) return family(slot).first_child;
    return next_beside(slot, top);
}

uint32_t Scene::next_beside(uint32_t slot, uint32_t top) const {
    for (; slot != top; slot = family(slot).parent) {
        if (family(slot).next != none) return family(slot).next;
    }
    return none;
}

bool Scene::is_below(uint32_t slot, uint32_t top) const {
    for (slot = parent_of(slot); slot != none; slot = parent_of(slot)) {
        if (slot == top) return true;
    }
    return false;
}

QueryFilter Scene::query_filter(uint32_t layers, gphys_model_id ignored_model, bool subtree,
                                const IgnoredIds& ids) const {
    QueryFilter filter;
    filter.layers = layers;
    filter.ignored = ids;
    if (has(ignored_model)) {
        filter.ignored_slot = IdTable::slot_of(ignored_model);
        filter.ignores_below = subtree && child_count(ignored_model) != 0;
    }
    return filter;
}

gphys_status Scene::set_parent(gphys_model_id model, gphys_model_id parent, bool keep_world) {
    GPHYS_TRY(check(model));
    if (parent != 0 && !has(parent)) return fail(GPHYS_ERROR_INVALID_ID, "parent", parent, id_of_model);
    const uint32_t slot = IdTable::slot_of(model);
    const uint32_t new_parent = parent == 0 ? none : IdTable::slot_of(parent);
    for (uint32_t above = new_parent; above != none; above = parent_of(above)) {
        if (above == slot) return fail(GPHYS_ERROR_CYCLE, "parent: it is the model itself or one of its descendants");
    }
    families_.reserve(2);

    const gphys_transform old_local = local_of(slot), old_world = models_[slot].world;
    const uint32_t old_parent = parent_of(slot);
    gphys_transform local = old_local;
    if (keep_world) local = new_parent == none ? old_world : relative(models_[new_parent].world, old_world);
    const auto reparent = [&](uint32_t above, const gphys_transform& transform) {
        if (models_[slot].has_family()) unlink(slot);
        if (above != none) link(slot, above);
        set_local(slot, transform);
    };
    reparent(new_parent, local);
    uint32_t moved = 0;
    const char* wrong = gphys::defect(local) ? "parent: the local transform is out of range" : nullptr;
    if (!wrong) wrong = propagate(slot, moved);
    if (wrong) {
        reparent(old_parent, old_local);
        restore_worlds(slot);
        return fail(GPHYS_ERROR_INVALID_ARGUMENT, wrong);
    }
    if (new_parent != none) reset_place(slot);
    bvh_.update_many(moved, [&](const auto& put, bool) { update_subtree(slot, put); });
    return GPHYS_OK;
}

}  // namespace gphys

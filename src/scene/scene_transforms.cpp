// Models move, and their descendants with them. New transforms are written in place, where children
// find their parent's. Should a model end up where the scene cannot hold it, the old transforms are
// put back and all worlds are derived from them again, which gives the old bits.
#include "foundation/strided.h"
#include "scene/scene.h"

namespace gphys {

const gphys_transform& Scene::local_of(uint32_t slot) const {
    return models_[slot].has_family() ? family(slot).local : models_[slot].world;
}

/// Without a parent the world transform is the local one; with a parent, carry() derives it.
void Scene::set_local(uint32_t slot, const gphys_transform& local) {
    if (models_[slot].has_family()) family(slot).local = local;
    if (parent_of(slot) == none) models_[slot].world = local;
}

void Scene::derive_world(uint32_t slot) {
    const uint32_t parent = parent_of(slot);
    if (parent != none) models_[slot].world = composed(models_[parent].world, family(slot).local);
}

const char* Scene::place(uint32_t slot, Box& box) const {
    const Model& model = models_[slot];
    const char* wrong = gphys::defect(model.world);
    if (wrong) return wrong;
    if (model.world.scale < 1 / max_scale) return "transform.scale: below 1 / GPHYS_MAX_COORDINATE";
    if (model.type() == GPHYS_SHAPE_PLANE) return nullptr;
    box = with_shape(slot, [](const auto& shape) {
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Plane>) {
            return Box();
        } else {
            return gphys::bounds(shape);
        }
    });
    for (int k = 0; k < 3; ++k) {
        if (box.min[k] < -max_box_coordinate || box.max[k] > max_box_coordinate) {
            return "transform: the model would reach beyond the range of coordinates";
        }
    }
    return nullptr;
}

/// Each model that will move is one of `count` or has a parent, thus a record of its family.
void Scene::reserve_moves(uint32_t count) {
    undo_.clear();
    moved_slots_.clear();
    moved_boxes_.clear();
    reserve_more(undo_, count);
    reserve_more(moved_slots_, count + families_.size());
    reserve_more(moved_boxes_, count + families_.size());
}

/// Derive the worlds from `top` down and note their boxes for publish_moves. Stops at the first
/// model that cannot stand where it would.
const char* Scene::carry(uint32_t top) {
    for (uint32_t slot = top; slot != none; slot = next_below(slot, top)) {
        derive_world(slot);
        Box box;
        const char* wrong = place(slot, box);
        if (wrong) return wrong;
        if (models_[slot].type() == GPHYS_SHAPE_PLANE) continue;
        moved_slots_.push_back(slot);
        moved_boxes_.push_back(box);
    }
    return nullptr;
}

void Scene::carry_back(uint32_t top) {
    for (uint32_t slot = top; slot != none; slot = next_below(slot, top)) derive_world(slot);
}

void Scene::publish_moves() {
    octree_.update_many(moved_slots_.data(), moved_boxes_.data(), static_cast<uint32_t>(moved_slots_.size()));
}

gphys_status Scene::set_transforms(const gphys_model_id* models, const gphys_transform* transforms,
                                   uint32_t transform_stride, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        const gphys_status status = check(models[i]);
        if (status != GPHYS_OK) return status;
    }
    reserve_moves(count);

    // Backwards, so that of a model that stands twice the last transform is met first.
    const Strided<gphys_transform> local(transforms, transform_stride);
    for (uint32_t i = count; i-- > 0;) {
        const uint32_t slot = IdTable::slot_of(models[i]);
        if (models_[slot].moving) continue;
        models_[slot].moving = 1;
        undo_.push_back({slot, local_of(slot)});
        set_local(slot, local[i]);
    }

    // What hangs below a moving model is carried along with it and must not be moved twice. A model
    // that is marked already has all its descendants marked: each is visited once.
    for (const Undo& moved : undo_) {
        for (uint32_t slot = next_below(moved.slot, moved.slot); slot != none;) {
            const bool seen = models_[slot].carried;
            models_[slot].carried = 1;
            slot = seen ? next_beside(slot, moved.slot) : next_below(slot, moved.slot);
        }
    }

    const char* wrong = nullptr;
    for (const Undo& moved : undo_) {
        if (!wrong && !models_[moved.slot].carried) wrong = carry(moved.slot);
    }
    if (wrong) {
        for (const Undo& moved : undo_) set_local(moved.slot, moved.local);
        for (const Undo& moved : undo_) {
            if (!models_[moved.slot].carried) carry_back(moved.slot);
        }
    } else {
        publish_moves();
    }

    for (const Undo& moved : undo_) {
        models_[moved.slot].moving = 0;
        for (uint32_t slot = next_below(moved.slot, moved.slot); slot != none;) {
            const bool marked = models_[slot].carried;
            models_[slot].carried = 0;
            slot = marked ? next_below(slot, moved.slot) : next_beside(slot, moved.slot);
        }
    }
    return wrong ? fail(GPHYS_ERROR_INVALID_ARGUMENT, wrong) : GPHYS_OK;
}

}  // namespace gphys

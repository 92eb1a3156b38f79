// set_transforms, set_origin, and the propagation of transforms to descendants.
//
// New transforms are written in place, since children read their parent's. If a model would leave the range of
// coordinates, the old local transforms are restored and all world transforms derived again, which gives the same bits
// as before. To store all old world transforms would need memory for each descendant.
#include "scene/scene.h"

#include "foundation/compiler.h"

namespace gphys {
namespace {

/// Fifty microseconds of work: much more than waking a thread takes.
constexpr uint32_t models_per_task = 1024;

}  // namespace

const gphys_transform& Scene::local_of(uint32_t slot) const {
    return models_[slot].has_family() ? family(slot).local : models_[slot].world;
}

/// Without a parent the world transform is the local one; with a parent, propagate() derives it.
void Scene::set_local(uint32_t slot, const gphys_transform& local) {
    if (models_[slot].has_family()) family(slot).local = local;
    if (parent_of(slot) == none) models_[slot].world = local;
}

void Scene::derive_world(uint32_t slot) {
    const uint32_t parent = parent_of(slot);
    if (parent != none) models_[slot].world = composed(models_[parent].world, family(slot).local);
}

/// The model's AABB. Not for planes.
Box Scene::world_box(uint32_t slot, const gphys_transform& world) const {
    return with_stored(slot, [&](const auto& stored) {
        if constexpr (is_box<std::decay_t<decltype(stored)>>) {
            if (is_rotated(world.rotation)) return conservative_bounds(stored, world);
        }
        return with_placed(stored, world, [](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Plane>) {
                return Box();
            } else {
                return gphys::bounds(shape);
            }
        });
    });
}

GPHYS_NOINLINE const char* Scene::check_placement(uint32_t slot, const gphys_transform& world, Box& box) const {
    if (gphys::defect(world)) return "transform: the world transform is out of range";
    if (world.scale < 1 / max_scale) return "transform.scale: in the world it is not from 1e-15 to 1e15";
    if (models_[slot].type() == GPHYS_SHAPE_PLANE) return nullptr;
    if (models_[slot].type() == GPHYS_SHAPE_MESH) {
        const AxisScale axes = stored<ModelMesh>(slot).axes();
        if (axes.largest() * world.scale > max_scale || axes.least() * world.scale < 1 / max_scale) {
            return "scale: in the world it is not from 1e-15 to 1e15";
        }
    }
    box = world_box(slot, world);
    for (int k = 0; k < 3; ++k) {
        if (box.min[k] < -max_box_coordinate || box.max[k] > max_box_coordinate) {
            return "transform: the model would reach beyond the range of coordinates";
        }
    }
    return nullptr;
}

/// The same for a valid transform, without the box. Fast path: nearly all models are far within the range, which the
/// upper bounds of the scene show. Valid positions are within GPHYS_MAX_COORDINATE.
inline const char* Scene::check_placement(uint32_t slot, const gphys_transform& world) const {
    constexpr float max_reach = max_box_coordinate / 2 - GPHYS_MAX_COORDINATE;
    constexpr double few_roundings = 1 - 0x1p-20;
    const double widest = widest_scale_, scale = world.scale;
    const bool usual_scale = scale * widest <= max_scale * few_roundings && scale * few_roundings >= widest / max_scale;
    if (farthest_point_ * world.scale < max_reach && usual_scale) return nullptr;
    Box box;
    return check_placement(slot, world, box);
}

/// Upper bound of the distance of the shape's points from the model's origin: the sum of the coordinates of the AABB's
/// farthest corner. 0 for a plane.
float Scene::farthest_point(uint32_t slot) const {
    return with_stored(slot, [&](const auto& stored) -> float {
        using Shape = std::decay_t<decltype(stored)>;
        if constexpr (is_box<Shape>) {
            const FloatBox box = float_box(stored);
            return sum(abs(box.center) + box.half)[0];
        } else if constexpr (std::is_same_v<Shape, gphys_plane>) {
            return 0;
        } else {
            constexpr gphys_transform identity{{0, 0, 0}, {0, 0, 0, 1}, 1};
            const Box box = world_box(slot, identity);
            float farthest = 0;
            for (int k = 0; k < 3; ++k) farthest += std::max(std::fabs(box.min[k]), std::fabs(box.max[k]));
            return farthest;
        }
    });
}

/// Derives the world transforms from `top` down and counts them. Stops at the first error and returns it.
const char* Scene::propagate(uint32_t top, uint32_t& moved) {
    for (uint32_t slot = top; slot != none; slot = next_below(slot, top)) {
        derive_world(slot);
        Box box;
        if (const char* wrong = check_placement(slot, models_[slot].world, box)) return wrong;
        ++moved;
    }
    return nullptr;
}

void Scene::restore_worlds(uint32_t top) {
    for (uint32_t slot = top; slot != none; slot = next_below(slot, top)) derive_world(slot);
}

gphys_status Scene::set_transforms(const gphys_model_id* models, const gphys_transform* transforms,
                                   uint32_t transform_stride, uint32_t count) {
    bool ascending = true;
    for (uint32_t i = 0; i < count; ++i) {
        if (!has(models[i])) return check(models[i]);
        ascending = ascending && (i == 0 || IdTable::slot_of(models[i - 1]) < IdTable::slot_of(models[i]));
    }
    const Strided<gphys_transform> local(transforms, transform_stride);
    const bool alone = ascending && families_.size() == 0;
    const char* wrong = alone ? move_alone(models, local, count) : move_with_relatives(models, local, count);
    return wrong ? fail(GPHYS_ERROR_INVALID_ARGUMENT, wrong) : GPHYS_OK;
}

/// update_some(begin, end) over all models that move; on any thread only if they are distinct items of the BVH.
template <class UpdateSome>
void Scene::update_parallel(uint32_t count, bool on_any_thread, const UpdateSome& update_some) const {
    workers_.run(on_any_thread ? count / models_per_task + 1 : 1, [&](uint32_t task) {
        const uint32_t begin = on_any_thread ? task * models_per_task : 0;
        update_some(begin, on_any_thread ? std::min(begin + models_per_task, count) : count);
    });
}

/// Updates the AABBs of up to eight models.
template <class Put>
void Scene::update_eight(const gphys_model_id* models, uint32_t count, const Put& put) const {
    const auto model = [&](uint32_t k) -> const Model& { return models_[IdTable::slot_of(models[k])]; };
    constexpr uint32_t min_lanes = 3;  // eight at once take as long as two single ones
    uint32_t aabbs = 0;
    for (uint32_t k = 0; count >= min_lanes && k < count; ++k) {
        aabbs |= uint32_t{model(k).type() == GPHYS_SHAPE_AABB} << k;
    }
    Box8 boxes;
    if (aabbs != 0) {
        const auto first = static_cast<uint32_t>(lowest_bit(aabbs));
        const float* quads[8];
        for (uint32_t k = 0; k < 8; ++k) quads[k] = &model((aabbs >> k & 1) != 0 ? k : first).world.position.x;
        aabbs &= bounds_kernels_.rotated_aabbs(quads, boxes);
    }
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t slot = IdTable::slot_of(models[k]);
        if ((aabbs >> k & 1) != 0) {
            put(slot, boxes.lane(static_cast<int>(k)));
        } else if (models_[slot].type() != GPHYS_SHAPE_PLANE) {
            put(slot, world_box(slot, models_[slot].world));
        }
    }
}

/// For models without duplicates and relatives: after the checks nothing can fail, so nothing is rolled back.
const char* Scene::move_alone(const gphys_model_id* models, const Strided<gphys_transform>& local, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        if (const char* wrong = check_placement(IdTable::slot_of(models[i]), local[i])) return wrong;
    }
    bvh_.update_many(count, [&](const auto& put, bool on_any_thread) {
        update_parallel(count, on_any_thread, [&](uint32_t begin, uint32_t end) {
            for (uint32_t first = begin; first < end; first += 8) {
                const uint32_t some = std::min(end - first, 8u);
                for (uint32_t i = first; i < first + some; ++i) models_[IdTable::slot_of(models[i])].world = local[i];
                update_eight(models + first, some, put);
            }
        });
    });
    return nullptr;
}

/// The general case. A model without relatives is checked first, and written when nothing can fail. Models with
/// relatives are written first, since their children read them, and rolled back on an error.
const char* Scene::move_with_relatives(const gphys_model_id* models, const Strided<gphys_transform>& local,
                                       uint32_t count) {
    // In reverse order: of a model that is listed twice, the last transform counts.
    const char* wrong = nullptr;
    uint32_t moved = 0;
    bool with_relatives = false;
    for (uint32_t i = count; i-- > 0 && !wrong;) {
        const uint32_t slot = IdTable::slot_of(models[i]);
        if (models_[slot].moving) continue;
        models_[slot].moving = 1;
        if (models_[slot].has_family()) {
            with_relatives = true;
            family(slot).old_local = family(slot).local;
            set_local(slot, local[i]);
        } else {
            wrong = check_placement(slot, local[i]);
            ++moved;
        }
    }
    if (with_relatives) {
        mark_carried(models, count);
        if (!wrong) wrong = propagate_relatives(models, count, moved);
        if (wrong) roll_back_relatives(models, count);
    }
    for (uint32_t i = count; i-- > 0;) {
        Model& model = models_[IdTable::slot_of(models[i])];
        if (model.moving && !model.has_family() && !wrong) model.world = local[i];
        model.moving = 0;
    }
    if (!wrong) {
        bvh_.update_many(moved, [&](const auto& put, bool on_any_thread) {
            // In parallel only if no model is listed twice and no descendants move: then all items differ.
            update_parallel(count, on_any_thread && !with_relatives && moved == count,
                            [&](uint32_t begin, uint32_t end) {
                                for (uint32_t i = begin; i < end; ++i) {
                                    const uint32_t slot = IdTable::slot_of(models[i]);
                                    if (!models_[slot].carried) update_subtree(slot, put);
                                }
                            });
        });
    }
    if (with_relatives) unmark_carried(models, count);
    return wrong;
}

/// Moves all roots in the opposite direction; their descendants follow.
gphys_status Scene::set_origin(Vec3 origin) {
    Vector<gphys_model_id> models(&memory);
    Vector<gphys_transform> transforms(&memory);
    LargeArray<WorldPlace> places(places_);
    models.reserve(size());
    transforms.reserve(size());
    places.resize(std::max<size_t>(places.size(), ids_.slots()));
    bool in_range = true;
    for_each_model([&](gphys_model_id model) {
        const uint32_t slot = IdTable::slot_of(model);
        if (parent_of(slot) != none) return;
        gphys_transform moved = local_of(slot);
        const Vec3 position = places[slot].move_origin(origin_, origin, moved.position);
        in_range = in_range && max_component(abs(position)) <= GPHYS_MAX_COORDINATE;
        moved.position = narrow(position);
        models.push_back(model);
        transforms.push_back(moved);
    });
    if (!in_range) return fail(GPHYS_ERROR_INVALID_ARGUMENT, "origin: a model would be beyond GPHYS_MAX_COORDINATE");
    GPHYS_TRY(set_transforms(models.data(), transforms.data(), sizeof(gphys_transform),
                             static_cast<uint32_t>(models.size())));
    places_.swap(places);
    origin_ = origin;
    return GPHYS_OK;
}

/// Marks the descendants of moving models: they move with them and must not be moved twice. The descendants of a marked
/// model are marked already, so each is visited once.
void Scene::mark_carried(const gphys_model_id* models, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t top = IdTable::slot_of(models[i]);
        for (uint32_t slot = next_below(top, top); slot != none;) {
            const bool was_marked = models_[slot].carried;
            models_[slot].carried = 1;
            slot = was_marked ? next_beside(slot, top) : next_below(slot, top);
        }
    }
}

void Scene::unmark_carried(const gphys_model_id* models, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t top = IdTable::slot_of(models[i]);
        for (uint32_t slot = next_below(top, top); slot != none;) {
            const bool marked = models_[slot].carried;
            models_[slot].carried = 0;
            slot = marked ? next_below(slot, top) : next_beside(slot, top);
        }
    }
}

const char* Scene::propagate_relatives(const gphys_model_id* models, uint32_t count, uint32_t& moved) {
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t slot = IdTable::slot_of(models[i]);
        if (!models_[slot].has_family() || models_[slot].carried) continue;
        if (const char* wrong = propagate(slot, moved)) return wrong;
    }
    return nullptr;
}

void Scene::roll_back_relatives(const gphys_model_id* models, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t slot = IdTable::slot_of(models[i]);
        if (models_[slot].has_family() && models_[slot].moving) set_local(slot, family(slot).old_local);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t slot = IdTable::slot_of(models[i]);
        if (models_[slot].has_family() && !models_[slot].carried) restore_worlds(slot);
    }
}

}  // namespace gphys

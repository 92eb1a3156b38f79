// Where particles that are attached to models are in a substep.
#pragma once

#include "solver/constraints.h"
#include "solver/contact/collision.h"

namespace gphys {

/// Particles that are attached to a model with which the body collides go along the model's arc, as its surface does.
/// On the chord of the arc a pin would come out of the surface in the second half of each step, and tighten what
/// friction holds there each time.
class AttachedPlaces {
public:
    /// `layers`: of the models with which the body collides.
    AttachedPlaces(const CollisionContext& around, uint32_t layers)
        : around_(around), layers_(layers), way_(around.way(around.end)) {}

    /// At the end of the substep. Fastest for attachments to one model in a row.
    Vec3 at_end(const Attachment& attachment) {
        const Vec3 on_chord = attachment.begin + (attachment.end - attachment.begin) * way_;
        if (attachment.model != model_) find(attachment.model);
        if (!moved_) return on_chord;
        const auto at = [&](const Transform& place) { return place.apply(attachment.local); };
        return on_chord + (at(now_) - (at(begin_) + (at(end_) - at(begin_)) * way_));
    }

private:
    void find(gphys_model_id model) {
        model_ = model;
        moved_ = around_.scene && (around_.scene->layers(model) & layers_) ? find_moved(around_, model) : nullptr;
        if (!moved_) return;
        const gphys_transform& after = around_.scene->world(model);
        begin_ = widen(moved_->world);
        end_ = widen(after);
        now_ = interpolate(moved_->world, after, way_);
    }

    const CollisionContext& around_;
    const uint32_t layers_;
    const double way_;
    gphys_model_id model_ = 0;  // which none has that the caller moves
    const MovedModel* moved_ = nullptr;
    Transform begin_, now_, end_;
};

}  // namespace gphys

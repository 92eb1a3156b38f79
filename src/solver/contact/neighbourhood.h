// The models near a body, and a hash of them. While it stays the same, a body at rest keeps sleeping, and cloth keeps
// its contact cache.
#pragma once

#include "scene/scene.h"

namespace gphys {

/// Hash of what matters of a model to particles: id, shape and place. The same on every machine; for a mesh it includes
/// the hash of its contents, not its address.
uint64_t hash_of(const Scene& scene, gphys_model_id model);

/// Hash of the models in a box that are in some of the layers: a sum, which does not depend on their order.
/// visit(model).
template <class Visit>
uint64_t neighbourhood(const Scene& scene, const Box& box, uint32_t layers, Visit&& visit) {
    uint64_t sum = 0;
    scene.for_each_in_box(box, layers, [&](gphys_model_id model) {
        sum += hash_of(scene, model);
        visit(model);
    });
    return sum;
}

/// Calls visit(model) for the models in some of the layers that overlap a box: the bounding box of a terrain or of a
/// rotated slab contains boxes that are far from its surface.
template <class Visit>
void each_near_model(const Scene& scene, const Box& box, uint32_t layers, Visit&& visit) {
    scene.for_each_in_box(box, layers, [&](gphys_model_id model) {
        if (scene.overlaps_box(model, box)) visit(model);
    });
}

}  // namespace gphys

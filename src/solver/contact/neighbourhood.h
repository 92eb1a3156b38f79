// A hash of a body's surroundings. While it stays the same, a body at rest keeps sleeping, and cloth keeps its contact
// cache.
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

}  // namespace gphys

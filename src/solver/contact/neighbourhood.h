// What is around a body, as one number: a body at rest sleeps on, and cloth keeps what it has found around it, while
// that number stays.
#pragma once

#include "scene/scene.h"

namespace gphys {

/// Of what a particle may touch of a model: its id, shape and place. The same on every machine; of a mesh it is a hash
/// of its contents, not of its address.
uint64_t hash_of(const Scene& scene, gphys_model_id model);

/// Of the models in a box that are in some of the layers: a sum over them, which no order changes. visit(model).
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

// The hash of a model (neighbourhood.h).
#include "solver/contact/neighbourhood.h"

#include "foundation/word_hash.h"
#include "mesh/mesh.h"

namespace gphys {

uint64_t hash_of(const Scene& scene, gphys_model_id model) {
    WordHash hash;
    const gphys_shape_type type = scene.type(model);
    hash.put(&model, 1);
    hash.put(&type, 1);
    hash.put(&scene.world(model), sizeof(gphys_transform) / 4);
    if (const Mesh* const mesh = scene.mesh(model)) {
        const uint64_t contents = mesh->hash();
        hash.put(&contents, sizeof contents / 4);
        const gphys_vec3 scale = scene.scale(model);
        hash.put(&scale, sizeof scale / 4);
    } else {
        uint32_t shape[sizeof(gphys_obb) / 4] = {};  // the largest shape
        scene.copy_shape(model, shape);
        hash.put(shape, sizeof shape / 4);
    }
    return hash.value();
}

}  // namespace gphys

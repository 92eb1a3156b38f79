// World AABBs of eight rotated boxes at a time, for updates of the BVH: one model in each lane, with the formula of
// conservative_bounds (Arvo, "Transforming axis-aligned bounding boxes", Graphics Gems 1990).
#pragma once

#include "bvh/box8.h"
#include "foundation/isa.h"

namespace gphys {

struct BoundsKernels {
    /// conservative_bounds (conservative_shape.h) of eight Aabbs, with the same bits. models[k]: transform, two unused
    /// words, min, max. Returns the valid lanes: models with a rotation whose boxes are centred on their origins.
    uint32_t (*rotated_aabbs)(const float* const models[8], Box8& out);
};

GPHYS_DECLARE_KERNELS(BoundsKernels, bounds_kernels)

}  // namespace gphys

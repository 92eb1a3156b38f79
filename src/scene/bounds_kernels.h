// Kernels for the AABBs of eight models at a time, for the BVH.
#pragma once

#include "bvh/box8.h"
#include "foundation/isa.h"

namespace gphys {

struct BoundsKernels {
    /// conservative_bounds (conservative_shape.h) of eight Aabbs, with the same bits: models[k] is the transform, two
    /// words of no interest, min and max. Of no use are lanes without a rotation and of boxes that are not about their
    /// origins; the result tells the others.
    uint32_t (*turned_aabbs)(const float* const models[8], Box8& out);
};

GPHYS_DECLARE_KERNELS(BoundsKernels, bounds_kernels)

}  // namespace gphys

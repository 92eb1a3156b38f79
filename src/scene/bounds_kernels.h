// Where eight models are, for the octree, once for each instruction set.
#pragma once

#include "foundation/isa.h"
#include "octree/box8.h"

namespace gphys {

struct BoundsKernels {
    /// quick_bounds (quick_shape.h) of eight Aabbs, with the same bits: models[k] is the transform, two words
    /// of no interest, min and max. Of no use are lanes without a rotation and of boxes that are not about
    /// their origins; the result tells the others.
    uint32_t (*turned_aabbs)(const float* const models[8], Box8& out);
};

GPHYS_DECLARE_KERNELS(BoundsKernels, bounds_kernels)

}  // namespace gphys

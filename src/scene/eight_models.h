// The arguments and results of kernels that test eight rays against eight models.
#pragma once

#include "foundation/isa.h"
#include "gamephys_c.h"

namespace gphys {

/// Where the shape of a stored model begins, in floats.
constexpr uint32_t shape_at = 10;

/// Eight rays, and the model that each asks about.
template <class RayForm>
struct RaysAndModels {
    const RayForm* ray[8];
    const float* model[8];  // its transform, two words of no interest, and the first six of its shape
    const float* other[8];  // a sphere, or the ball around a mesh; the rotation of an Obb
};

/// Masks of eight tests: certainly no, and certainly yes. The others are undecided.
struct TriStates8 {
    uint32_t no, yes;
};

}  // namespace gphys

// Arguments and results of kernels that test eight pairs of a ray and a model, one pair in each lane (hit_kernels.h,
// scene_kernels.h).
#pragma once

#include "foundation/isa.h"
#include "gamephys_c.h"

namespace gphys {

/// Offset of the shape in a stored model, in floats.
constexpr uint32_t shape_at = 10;

/// Eight pairs of a ray and a model.
template <class RayForm>
struct RaysAndModels {
    const RayForm* ray[8];
    const float* model[8];  // transform, two unused words, the first six words of the shape
    const float* other[8];  // sphere; bounding sphere of a mesh; rotation of an Obb
};

/// Results of eight tests, as masks. In neither mask: undecided.
struct TriStates8 {
    uint32_t no, yes;
};

}  // namespace gphys

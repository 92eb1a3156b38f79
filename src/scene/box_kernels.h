// Kernels for one ray against one box, for each wide instruction set (isa.h), in double precision, with the formulas of
// the exact tests (intersect.h): so a hit has the same bits. With the three axes in one register that takes fewer
// instructions than a conservative test, so none comes before.
//
// Undecided: rays that start inside a box, or enter it within rounding of where they leave it or cross another face.
#pragma once

#include "foundation/tri_state.h"
#include "scene/hit_kernels.h"

namespace gphys {

struct BoxKernels {
    // `model` is one of RaysAndModels, `rotation` its `other`. The hit is written if the answer is yes.
    TriState (*raycast_aabb)(const Ray& ray, const float* model, Hits8::Rounded& hit);
    TriState (*raycast_obb)(const Ray& ray, const float* model, const float* rotation, Hits8::Rounded& hit);
    // Without the hit.
    TriState (*meets_aabb)(const Ray& ray, const float* model);
    TriState (*meets_obb)(const Ray& ray, const float* model, const float* rotation);
};

/// Null for narrow sets: there, conservative tests in float followed by exact tests are faster.
GPHYS_DECLARE_WIDE_KERNELS(BoxKernels, box_kernels)

}  // namespace gphys

// Where eight rays first meet spheres and boxes, side by side, once for each wide instruction set (isa.h).
//
// In double precision, by the formulas of the exact tests (intersect.h), so that a hit has the bits
// that it has alone. What these would ask exact arithmetic, or treat apart, is left open for them:
// close calls, origins within a solid, rays without direction or at right angles to an axis of a box.
#pragma once

#include "scene/eight_models.h"
#include "shapes/shapes.h"

namespace gphys {

/// Hits as gphys_hit has them; of a lane that is not met, any floats.
struct Hits8 {
    struct alignas(16) Rounded {
        float t;
        gphys_vec3 point, normal;
        float unused;
    };

    double t[8];
    Rounded rounded[8];
};

struct HitKernels {
    // The models of each are of one type.
    TriStates8 (*spheres)(const RaysAndModels<Ray>& pairs, Hits8& hits);
    TriStates8 (*aabbs)(const RaysAndModels<Ray>& pairs, Hits8& hits);
    TriStates8 (*obbs)(const RaysAndModels<Ray>& pairs, Hits8& hits);
    /// Rays that certainly miss the balls around meshes.
    uint32_t (*miss_balls)(const RaysAndModels<Ray>& pairs);
};

/// Without a wide set, quick tests in floats, and exact ones of what these leave, are faster.
GPHYS_DECLARE_WIDE_KERNELS(HitKernels, hit_kernels)

}  // namespace gphys

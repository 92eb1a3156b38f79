// Kernels for eight rays against spheres and boxes, for each wide instruction set (isa.h).
//
// In double precision, with the formulas of the exact tests (intersect.h), so that a hit has the same bits as from
// these. Undecided, and left to them, are cases for exact arithmetic and special cases: values within rounding, origins
// inside a solid, rays of zero length or perpendicular to an axis of a box.
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
    // The same without points and normals: t as it is reported.
    TriStates8 (*sphere_distances)(const RaysAndModels<Ray>& pairs, float (&t)[8]);
    TriStates8 (*aabb_distances)(const RaysAndModels<Ray>& pairs, float (&t)[8]);
    TriStates8 (*obb_distances)(const RaysAndModels<Ray>& pairs, float (&t)[8]);
    /// Rays that certainly miss the bounding spheres of meshes.
    uint32_t (*miss_balls)(const RaysAndModels<Ray>& pairs);
};

/// Null without a wide set: conservative tests in float, followed by exact ones, are faster there.
GPHYS_DECLARE_WIDE_KERNELS(HitKernels, hit_kernels)

}  // namespace gphys

// Kernels for eight rays against spheres and boxes, for each wide instruction set (isa.h). One pair of a ray and a
// model in each lane, in double precision, with the formulas of the exact tests (intersect.h): so a hit has the same
// bits.
//
// Special cases, and those that need exact arithmetic, are undecided and left to the exact tests: signs within
// rounding, origins inside a solid, rays of zero length or perpendicular to an axis of a box.
#pragma once

#include "scene/eight_models.h"
#include "shapes/shapes.h"

namespace gphys {

/// Hits as in gphys_hit. Lanes without a hit have any values.
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
    // All models of a call are of one type.
    TriStates8 (*spheres)(const RaysAndModels<Ray>& pairs, Hits8& hits);
    TriStates8 (*aabbs)(const RaysAndModels<Ray>& pairs, Hits8& hits);
    TriStates8 (*obbs)(const RaysAndModels<Ray>& pairs, Hits8& hits);
    // The same without points and normals: only the reported t.
    TriStates8 (*sphere_distances)(const RaysAndModels<Ray>& pairs, float (&t)[8]);
    TriStates8 (*aabb_distances)(const RaysAndModels<Ray>& pairs, float (&t)[8]);
    TriStates8 (*obb_distances)(const RaysAndModels<Ray>& pairs, float (&t)[8]);
    /// Lanes whose rays certainly miss the bounding spheres of their meshes.
    uint32_t (*miss_balls)(const RaysAndModels<Ray>& pairs);
};

/// Null for narrow sets: there, conservative tests in float followed by exact tests are faster.
GPHYS_DECLARE_WIDE_KERNELS(HitKernels, hit_kernels)

}  // namespace gphys

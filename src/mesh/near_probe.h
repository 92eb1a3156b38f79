// A ball and a half-space in the local space of a mesh, rounded conservatively to float for the kernels in
// near_kernels.cpp, which derives the error bounds.
#pragma once

#include "bvh/box8.h"

namespace gphys {

struct NearProbe {
    NearProbe() = default;
    NearProbe(Vec3 center, double ball_radius);
    void shrink(double ball_radius);

    float base[3], offset[3];  // the centre is their sum
    float radius;              // rounded up
};

/// The half-space of points at most `height` along a unit vector from the centre of a ball.
struct HalfSpaceProbe {
    HalfSpaceProbe(Vec3 unit, double height);

    float normal[3];
    float lowest, highest;  // the height is between them
};

}  // namespace gphys

// A ray rounded conservatively to float, for the kernels that test the triangles of a packet (triangle_test.h): a
// triangle that the ray hits is never rejected.
#pragma once

#include "bvh/box8.h"
#include "geometry/intersect.h"

namespace gphys {

/// In fours, so that those of eight rays are written at once (mesh_kernels.cpp).
struct alignas(16) TriangleProbe {
    TriangleProbe() = default;
    /// `along` is the same ray's probe of boxes in `root`, and meets some of them.
    TriangleProbe(const ShearedRay& ray, const RayProbe& along, const RaysRoot& root);

    int axis[4];      // kx, ky, kz of the sheared ray; the fourth is not used
    float origin[4];  // on these axes
    struct {
        float slope[2];  // of the direction across, per step along
        // A volume of coordinates up to rx and ry may be off by error_slope . (rx, ry) + error.
        float error_slope[2];
    } across;
    struct {
        float ahead, behind;  // 1 and 0 if the direction along is positive, else 0 and 1
        float margin;         // by which a coordinate along may be off
        float error;
    } rest;
};

}  // namespace gphys

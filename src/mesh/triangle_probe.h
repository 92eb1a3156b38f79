// A ray rounded conservatively to float, for the kernels that test the triangles of a packet (triangle_test.h). A
// triangle that the ray hits is never rejected.
#pragma once

#include "bvh/box8.h"
#include "geometry/intersect.h"

namespace gphys {

/// In groups of four floats, so that kernels can store eight of them by transposing (mesh_kernels.cpp).
struct alignas(16) TriangleProbe {
    TriangleProbe() = default;
    /// `along` is the same ray's probe of boxes in `root`, and overlaps some of them.
    TriangleProbe(const ShearedRay& ray, const RayProbe& along, const RootBounds& root);

    int axis[4];      // kx, ky, kz of the sheared ray; the fourth is unused
    float origin[4];  // on these axes
    struct {
        float slope[2];  // of the direction: across per step along
        // The error of a volume, for coordinates up to rx and ry, is at most error_slope . (rx, ry) + error.
        float error_slope[2];
    } across;
    struct {
        float ahead, behind;  // 1 and 0 if the direction along the axis is positive, else 0 and 1
        float margin;         // error bound of a coordinate along the axis
        float error;
    } rest;
};

}  // namespace gphys

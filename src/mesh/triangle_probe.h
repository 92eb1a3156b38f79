// A ray prepared in float arithmetic, so that kernels can test the triangles of a packet together
// (triangle_test.h). It may keep a triangle that the ray misses, never the reverse.
#pragma once

#include "intersect/intersect.h"
#include "octree/box8.h"

namespace gphys {

struct TriangleProbe {
    /// `along` is the same ray's probe of boxes in `root`, and meets some of them.
    TriangleProbe(const ShearedRay& ray, const RayProbe& along, const Box& root);

    int axis[3];        // kx, ky, kz of the sheared ray
    float origin[3];    // on these axes
    float slope[2];     // of the direction across, per step along
    bool forward;       // the direction along is positive
    float margin;       // by which a sheared coordinate may be off
    float error_slope;  // a volume of coordinates up to r may be off by error_slope * r + error
    float error;
};

}  // namespace gphys

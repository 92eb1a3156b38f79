// The triangles of a mesh against rays in plain float arithmetic, walked through the library's own tree
// by the library's own traversal: what the exact tests are measured against.
#pragma once

#include "bvh/bvh_kernels.h"
#include "mesh/triangle_packet.h"

namespace gphys {

struct FloatRay {
    FloatRay(const gphys_ray& ray)
        : origin{ray.origin.x, ray.origin.y, ray.origin.z},
          direction{ray.direction.x, ray.direction.y, ray.direction.z},
          t(ray.t_max) {}

    float origin[3], direction[3];
    // The nearest hit so far.
    float t, u = 0, v = 0;
    uint32_t item = TrianglePacket::none;
};

struct FloatKernels {
    /// As MeshKernels::rays; each ray ends up with its nearest hit.
    void (*rays)(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const RayProbe* along,
                 FloatRay* rays, const float* limits, uint32_t count, bool together);
};

GPHYS_DECLARE_KERNELS(FloatKernels, float_kernels)

}  // namespace gphys

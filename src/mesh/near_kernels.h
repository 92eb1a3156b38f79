// Kernels: which triangles of packets are near a point, and which are behind a plane. Eight at a time, in conservative
// float arithmetic.
#pragma once

#include "foundation/isa.h"
#include "mesh/near_probe.h"
#include "mesh/triangle_packet.h"

namespace gphys {

/// A packet with triangles near the point.
struct NearPacket {
    const TrianglePacket* packet;
    float extent;       // no corner's coordinates differ from the point's by a larger sum
    uint32_t measured;  // 1: triangle by triangle; else distances are those of the packet's box
    float distance[8];  // at least; infinity for triangles that are left out
};

struct NearKernels {
    /// Packets in `boxes`, eight in each, of which boxes touch the ball; returns how many there are in `out`.
    uint32_t (*find)(const Box8* boxes, const TrianglePacket* const* packets, uint32_t count, const NearProbe& probe,
                     NearPacket* out);
    /// Leaves out the triangles that do not touch the ball.
    void (*measure)(NearPacket& packet, const NearProbe& probe);
    /// Leaves out the triangles that are certainly behind the plane, and packets without others. Bit i of open[k] is
    /// set if triangle i of packet k may be behind it. Returns how many packets are left.
    uint32_t (*leave_out)(NearPacket* packets, uint32_t count, const NearProbe& probe, const HalfSpaceProbe& plane,
                          uint32_t* open);
    /// The least of all distances, and where it is: 8 * packet + triangle. Infinity if all are left out.
    float (*nearest)(const NearPacket* packets, uint32_t count, uint32_t& place);
};

GPHYS_DECLARE_KERNELS(NearKernels, near_kernels)

}  // namespace gphys

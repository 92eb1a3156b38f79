// Kernels of closest-feature queries: the triangles of packets near a point, and behind a plane. Eight at a time, in
// conservative float arithmetic.
#pragma once

#include "foundation/isa.h"
#include "mesh/near_probe.h"
#include "mesh/triangle_packet.h"

namespace gphys {

/// A packet with triangles near the point.
struct NearPacket {
    const TrianglePacket* packet;
    float extent;       // bound for the sum of the coordinate differences of corner and point
    uint32_t measured;  // 1: distances of triangles; 0: all are the distance of the packet's box
    float distance[8];  // lower bounds; infinity for triangles that are culled
};

struct NearKernels {
    /// The packets, whose boxes are in `boxes` in eights, that overlap the ball. Returns how many were written to
    /// `out`.
    uint32_t (*find)(const Box8* boxes, const TrianglePacket* const* packets, uint32_t count, const NearProbe& probe,
                     NearPacket* out);
    /// Culls the triangles that do not overlap the ball.
    void (*measure)(NearPacket& packet, const NearProbe& probe);
    /// Lower bounds of the distances to the triangles of a packet; infinity in unused lanes. Returns the lanes within
    /// the radius.
    uint32_t (*lanes_within)(const TrianglePacket& packet, const NearProbe& probe, float* distances);
    /// Culls the triangles that are certainly behind the plane, and packets that have no others. Bit i of open[k] is
    /// set if triangle i of packet k may be behind it. Returns how many packets are left.
    uint32_t (*cull)(NearPacket* packets, uint32_t count, const NearProbe& probe, const HalfSpaceProbe& plane,
                     uint32_t* open);
    /// The least distance and its place: 8 * packet + triangle. Infinity if all triangles are culled.
    float (*nearest)(const NearPacket* packets, uint32_t count, uint32_t& place);
};

/// The lane of the least distance among `lanes`, which is not empty.
inline int nearest_lane(const float (&distances)[8], uint32_t lanes) {
    int nearest = lowest_bit(lanes);
    for (lanes &= lanes - 1; lanes != 0; lanes &= lanes - 1) {
        const int lane = lowest_bit(lanes);
        if (distances[lane] < distances[nearest]) nearest = lane;
    }
    return nearest;
}

GPHYS_DECLARE_KERNELS(NearKernels, near_kernels)

}  // namespace gphys

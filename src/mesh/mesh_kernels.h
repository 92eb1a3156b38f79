// What a mesh asks of its packets, once for each instruction set.
#pragma once

#include "bvh/bvh_kernels.h"
#include "mesh/mesh_place.h"
#include "mesh/mesh_ray.h"

namespace gphys {

/// Who gets the packets that a ray meets, with the lanes it may hit.
struct PacketVisitor {
    /// Returns the new limit, which may have come nearer; a negative one ends the walk.
    float (*visit)(void* context, const TrianglePacket& packet, uint32_t lanes);
    void* context;
};

/// The exact test, for what kernels leave open (raycast_triangle.cpp).
using CrossesTriangle = bool (*)(const PreparedRay& ray, const TrianglePacket& packet, uint32_t lane,
                                 TriangleCrossing& crossing);

struct MeshKernels {
    /// Prepares many rays with the same bits as one by one. `count` is at least 1; what is written is rounded up to a
    /// multiple of eight.
    void (*prepare)(const gphys_ray* const* rays, uint32_t count, const RaysRoot& root, PreparedRay* to);
    /// The same of rays in double precision that are no segments, carried into a mesh that stands at `place`.
    void (*prepare_placed)(const Ray* rays, uint32_t count, const MeshPlace& place, const RaysRoot& root,
                           PreparedRay* to);
    /// Roughly nearest first, through an BVH whose items are the numbers of `packets`.
    void (*ray)(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay& ray,
                const PacketVisitor& to);
    /// Where many rays first cross the triangles, or with `only_front` those whose front they meet; up to
    /// RayPackets::most with the same signs of direction may go together.
    void (*rays)(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay* rays,
                 uint32_t count, bool together, bool only_front, CrossesTriangle exact, NearestCrossing* nearest);
    /// The same for whether they cross any: where is of no interest.
    void (*rays_any)(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay* rays,
                     uint32_t count, bool together, bool only_front, CrossesTriangle exact, NearestCrossing* nearest);
    /// The hits of rays that cross something. Bit i of the result is set if that of ray i is written.
    uint64_t (*hits)(const PreparedRay* rays, const NearestCrossing* nearest, uint32_t count, gphys_hit* const* out);
    // The lanes of one packet whose boxes meet a query.
    uint32_t (*lanes_in_box)(const TrianglePacket& packet, const Box& box);
    uint32_t (*lanes_along)(const TrianglePacket& packet, const RayProbe& probe, float limit);
    uint32_t (*lanes_near)(const TrianglePacket& packet, const PointProbe& probe, float limit);
    uint32_t (*lanes_near_weighted)(const TrianglePacket& packet, const WeightedPointProbe& probe, float limit);
    /// As hits, of a mesh that stands at `world`, with one scale.
    uint64_t (*placed_hits)(const PreparedRay* rays, const NearestCrossing* nearest, uint32_t count,
                            const Transform& world, gphys_hit* const* out);
};

GPHYS_DECLARE_KERNELS(MeshKernels, mesh_kernels)

}  // namespace gphys

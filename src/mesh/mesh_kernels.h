// The kernels that a mesh needs, compiled once for each instruction set.
#pragma once

#include "bvh/bvh_kernels.h"
#include "mesh/mesh_place.h"
#include "mesh/mesh_ray.h"

namespace gphys {

/// Callback for the packets that a ray may hit, with the lanes that it may hit.
struct PacketVisitor {
    /// Returns the new limit, which may be nearer than before. A negative limit ends the traversal.
    float (*visit)(void* context, const TrianglePacket& packet, uint32_t lanes);
    void* context;
};

/// The exact test, for pairs that the kernels leave undecided (raycast_triangle.cpp).
using CrossesTriangle = bool (*)(const PreparedRay& ray, const TrianglePacket& packet, uint32_t lane,
                                 TriangleCrossing& crossing);

/// The same for a ray that was not prepared.
using CrossesTriangleAlone = bool (*)(const Ray& ray, const TrianglePacket& packet, uint32_t lane,
                                      TriangleCrossing& crossing);

/// A mesh, as kernels for a single ray read it.
struct MeshTree {
    const BvhNode* nodes;
    uint32_t root;
    bool only_front;  // triangles have one side
    const TrianglePacket* packets;
    const RootBounds& box;
    const Vec3& center;  // of the ball around the mesh
    double radius;
    CrossesTriangleAlone exact;
};

struct MeshKernels {
    /// Prepares many rays, with the same bits as one by one. `count` is at least 1. Writes a multiple of eight rays.
    void (*prepare)(const gphys_ray* const* rays, uint32_t count, const RootBounds& root, PreparedRay* to);
    /// The same for rays in double precision that are no segments, transformed into a mesh at `place`.
    void (*prepare_placed)(const Ray* rays, uint32_t count, const MeshPlace& place, const RootBounds& root,
                           PreparedRay* to);
    /// Traverses a BVH whose items are the indices of `packets`, roughly front to back.
    void (*ray)(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay& ray,
                const PacketVisitor& to);
    /// closest: the nearest crossing of one ray with a triangle, on the sides that the ray allows (Ray::faces) and the
    /// mesh has. any: any such crossing. With `hit` also the hit; the result is whether it was written, which it need
    /// not be.
    bool (*closest)(const MeshTree& mesh, const Ray& ray, NearestCrossing& nearest, gphys_hit* hit);
    bool (*any)(const MeshTree& mesh, const Ray& ray, NearestCrossing& nearest, gphys_hit* hit);
    /// The same at the place of a model (simd_rotation.h), with a scale for each axis, of a ray in the world that is no
    /// segment.
    bool (*closest_placed)(const MeshTree& mesh, const Ray& ray, const float* model, const Vec3& axes,
                           NearestCrossing& nearest, gphys_hit* hit);
    bool (*any_placed)(const MeshTree& mesh, const Ray& ray, const float* model, const Vec3& axes,
                       NearestCrossing& nearest, gphys_hit* hit);
    /// The nearest crossings of many rays on any side, or with `only_front` on the front. together: the rays form a
    /// packet, at most RayPackets::max_rays with the same signs of direction.
    void (*rays)(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay* rays,
                 uint32_t count, bool together, bool only_front, CrossesTriangle exact, NearestCrossing* nearest);
    /// The same with any crossing; only its existence counts.
    void (*rays_any)(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay* rays,
                     uint32_t count, bool together, bool only_front, CrossesTriangle exact, NearestCrossing* nearest);
    /// The hits at the nearest crossings. Bit i of the result is set if the hit of ray i was written.
    uint64_t (*hits)(const PreparedRay* rays, const NearestCrossing* nearest, uint32_t count, gphys_hit* const* out);
    // The lanes of one packet whose boxes overlap the query.
    uint32_t (*lanes_in_box)(const TrianglePacket& packet, const Box& box);
    uint32_t (*lanes_along)(const TrianglePacket& packet, const RayProbe& probe, float limit);
    uint32_t (*lanes_near_weighted)(const TrianglePacket& packet, const WeightedPointProbe& probe, float limit);
    /// As hits, for a mesh at `world` with a uniform scale.
    uint64_t (*placed_hits)(const PreparedRay* rays, const NearestCrossing* nearest, uint32_t count,
                            const Transform& world, gphys_hit* const* out);
};

GPHYS_DECLARE_KERNELS(MeshKernels, mesh_kernels)

}  // namespace gphys

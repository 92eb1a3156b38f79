#include "mesh/mesh_kernels.h"

#include "mesh/ray_group.h"

namespace gphys::GPHYS_ISA {

namespace {

void walk_ray(const OctreeNode* nodes, uint32_t root, const TrianglePacket* packets, const RayProbe& along,
              const TriangleProbe& probe, float limit, const PacketVisitor& to) {
    RayWalk walk(along, probe, root, limit);
    while (walk.step({nodes, packets}, [&](const TrianglePacket& packet, uint32_t lanes) {
        return to.visit(to.context, packet, lanes);
    })) {
    }
}

void walk_rays(const OctreeNode* nodes, uint32_t root, const TrianglePacket* packets, const RayProbe* const along[8],
               const TriangleProbe* const probes[8], uint32_t count, float limits[8], const RayPacketVisitor& to) {
    const MeshTree tree{nodes, packets};
    if (count > 1 && in_one_octant(along, count)) {
        walk_together(tree, root, along, probes, count, limits, to);
    } else {
        walk_in_turns(tree, root, along, probes, count, limits, to);
    }
}

uint32_t lanes_in_box(const TrianglePacket& packet, const Box& box) {
    return BoxTest(box).hits(boxes_of(packet)) & used_lanes(packet);
}

uint32_t lanes_along(const TrianglePacket& packet, const RayProbe& probe, float limit) {
    Float8 entry;
    return RayTest(probe).hits(boxes_of(packet), limit, entry) & used_lanes(packet);
}

uint32_t lanes_near(const TrianglePacket& packet, const PointProbe& probe, float limit) {
    Float8 distance_squared;
    return PointTest(probe).hits(boxes_of(packet), limit, distance_squared) & used_lanes(packet);
}

}  // namespace

extern const MeshKernels mesh_kernels{walk_ray, walk_rays, lanes_in_box, lanes_along, lanes_near};

}  // namespace gphys::GPHYS_ISA

#include "mesh/mesh_kernels.h"

#include "mesh/triangle_test.h"
#include "octree/octree_traversal.h"

namespace gphys::GPHYS_ISA {

namespace {

/// Unused lanes are hit with lane 0.
uint32_t used_lanes(const TrianglePacket& packet, uint32_t hits) {
    if (hits == 0) return 0;
    uint32_t unused = 0;
    for (uint32_t lane = 8; packet.index[--lane] == TrianglePacket::none;) unused |= 1u << lane;
    return hits & ~unused;
}

void walk_ray(const OctreeNode* nodes, uint32_t root, const TrianglePacket* packets, const RayProbe& along,
              const TriangleProbe& probe, float limit, const PacketVisitor& to) {
    const TriangleTest test(probe);
    float current = limit;
    nearest_first(
        nodes, root, RayTest(along), limit,
        [&](uint32_t item) {
            const TrianglePacket& packet = packets[item];
            const uint32_t lanes = used_lanes(packet, test.hits(packet, current));
            if (lanes != 0) current = to.visit(to.context, packet, lanes);
            return current;
        },
        [&](uint32_t item) { fetch_ahead(packets + item, sizeof(TrianglePacket)); });
}

uint32_t lanes_in_box(const TrianglePacket& packet, const Box& box) {
    return used_lanes(packet, BoxTest(box).hits(boxes_of(packet)));
}

uint32_t lanes_along(const TrianglePacket& packet, const RayProbe& probe, float limit) {
    Float8 entry;
    return used_lanes(packet, RayTest(probe).hits(boxes_of(packet), limit, entry));
}

uint32_t lanes_near(const TrianglePacket& packet, const PointProbe& probe, float limit) {
    Float8 distance_squared;
    return used_lanes(packet, PointTest(probe).hits(boxes_of(packet), limit, distance_squared));
}

}  // namespace

extern const MeshKernels mesh_kernels{walk_ray, lanes_in_box, lanes_along, lanes_near};

}  // namespace gphys::GPHYS_ISA

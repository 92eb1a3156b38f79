#include "mesh/mesh_kernels.h"

#include "mesh/triangle_test.h"
#include "octree/octree_many.h"

namespace gphys::GPHYS_ISA {

namespace {

void fetch_packet(const TrianglePacket* packets, uint32_t number) {
    fetch_ahead(packets + number, sizeof(TrianglePacket));
}

void walk_ray(const OctreeNode* nodes, uint32_t root, const TrianglePacket* packets, const RayProbe& along,
              const TriangleProbe& probe, float limit, const PacketVisitor& to) {
    const TriangleTest test(probe);
    nearest_first(nodes, root, RayTest(along), limit, [&](uint32_t number) {
        const uint32_t lanes = test.hits(packets[number], limit);
        if (lanes != 0) limit = to.visit(to.context, packets[number], lanes);
        return limit;
    });
}

void walk_rays(const OctreeNode* nodes, uint32_t root, const TrianglePacket* packets, const RayProbe* const* along,
               const TriangleProbe* const* probes, float* limits, uint32_t count, bool together,
               const RayPacketVisitor& to) {
    rays_at_once(
        nodes, root, [&](uint32_t ray) -> const RayProbe& { return *along[ray]; }, limits, count, together,
        [&](uint32_t ray, uint32_t number) {
            const uint32_t lanes = TriangleTest(*probes[ray]).hits(packets[number], limits[ray]);
            if (lanes != 0) limits[ray] = to.visit(to.context, ray, packets[number], lanes);
            return limits[ray];
        },
        [&](uint32_t number) { fetch_packet(packets, number); });
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

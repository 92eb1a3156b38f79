#include "mesh/mesh_kernels.h"

#include "intersect/shear.h"
#include "mesh/triangle_setup.h"
#include "mesh/triangle_test.h"
#include "octree/octree_many.h"
#include "octree/ray_lanes.h"

namespace gphys::GPHYS_ISA {

namespace {

void fetch_packet(const TrianglePacket* packets, uint32_t number) {
    fetch_ahead(packets + number, sizeof(TrianglePacket));
}

void prepare(const Ray* rays, uint32_t count, const RaysRoot& root, PreparedRay* to) {
    for (uint32_t first = 0; first < count; first += 8) {
        const Rays8 eight(rays + first, count - first);
        const auto at = [&](int i) -> PreparedRay& { return to[first + static_cast<uint32_t>(i)]; };
        const RaySetup<Double8> along(eight.origin, eight.direction, root);
        const Float8 limits = put_probes(eight, along, [&](int i) -> RayProbe& { return at(i).along; });

        const Shear<Double8> shear(eight.direction);
        const TriangleSetup<Double8> setup(shear, eight.direction, along.begin, along.slack, along.span < beyond_trees,
                                           root);
        constexpr double number[3] = {0, 1, 2};
        const auto axis = [](Double8 k) { return integer_bits(narrowed(k)); };
        store_quads([&](int i) { return reinterpret_cast<float*>(at(i).triangles.axis); },
                    {axis(shear.x(number)), axis(shear.y(number)), axis(shear.z(number)), splat(0)});
        store_quads([&](int i) { return at(i).triangles.origin; },
                    {narrowed(setup.origin[0]), narrowed(setup.origin[1]), narrowed(setup.origin[2]), splat(0)});
        store_quads([&](int i) { return reinterpret_cast<float*>(&at(i).triangles.across); },
                    {narrowed(setup.slope_x), narrowed(setup.slope_y), narrowed(setup.error_slope_x),
                     narrowed(setup.error_slope_y)});
        const Float8 ahead = narrowed(setup.ahead);
        store_quads([&](int i) { return reinterpret_cast<float*>(&at(i).triangles.rest); },
                    {ahead, splat(1) - ahead, narrowed(setup.margin), narrowed(setup.error)});

        alignas(32) double sx[8], sy[8];
        alignas(32) float limit[8];
        store(sx, shear.sx);
        store(sy, shear.sy);
        store(limit, limits);
        for (uint32_t i = 0; i < 8; ++i) {
            PreparedRay& ray = to[first + i];
            const Ray& given = rays[first + i < count ? first + i : count - 1];
            std::memcpy(static_cast<void*>(&ray.sheared), &given, sizeof given);
            ray.sheared.kx = ray.triangles.axis[0];
            ray.sheared.ky = ray.triangles.axis[1];
            ray.sheared.kz = ray.triangles.axis[2];
            ray.sheared.sx = sx[i];
            ray.sheared.sy = sy[i];
            ray.limit = limit[i];
        }
    }
}

void walk_ray(const OctreeNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay& ray,
              const PacketVisitor& to) {
    const TriangleTest test(ray.triangles);
    float limit = ray.limit;
    nearest_first(nodes, root, RayTest(ray.along), limit, [&](uint32_t number) {
        const uint32_t lanes = test.hits(packets[number], limit);
        if (lanes != 0) limit = to.visit(to.context, packets[number], lanes);
        return limit;
    });
}

void walk_rays(const OctreeNode* nodes, uint32_t root, const TrianglePacket* packets, const PreparedRay* rays,
               uint32_t count, bool together, const RayPacketVisitor& to) {
    float limits[octree_most_rays];
    for (uint32_t i = 0; i < count; ++i) limits[i] = rays[i].limit;
    rays_at_once(
        nodes, root, [&](uint32_t ray) -> const RayProbe& { return rays[ray].along; }, limits, count, together,
        one_by_one([&](uint32_t ray, uint32_t number) {
            const uint32_t lanes = TriangleTest(rays[ray].triangles).hits(packets[number], limits[ray]);
            if (lanes != 0) limits[ray] = to.visit(to.context, ray, packets[number], lanes);
            return limits[ray];
        }),
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

extern const MeshKernels mesh_kernels{prepare, walk_ray, walk_rays, lanes_in_box, lanes_along, lanes_near};

}  // namespace gphys::GPHYS_ISA

// A packet of up to eight triangles in structure-of-arrays layout, which a query tests together: the items of a mesh's
// BVH.
#pragma once

#include "bvh/box8.h"
#include "foundation/compiler.h"
#include "foundation/memory.h"
#include "mesh/mesh_report.h"
#include "mesh/mesh_snapshot.h"

namespace gphys {

/// -0 becomes +0, so that a box does not depend on the order of its points.
inline Box without_negative_zeros(Box box) {
    for (int k = 0; k < 3; ++k) {
        box.min[k] += 0.0f;
        box.max[k] += 0.0f;
    }
    return box;
}

struct alignas(64) TrianglePacket {
    float corner[3][3][8];  // a, b, c; x, y, z
    uint32_t index[8];      // of each triangle in the mesh; none in unused lanes, which repeat lane 0

    static constexpr uint32_t none = 0xffffffffu;

    uint32_t count() const {
        uint32_t used = 8;
        while (index[used - 1] == none) --used;
        return used;
    }
    /// Bits of the used lanes.
    uint32_t lanes() const { return (1u << count()) - 1; }
    Triangle triangle(int lane) const { return {point(0, lane), point(1, lane), point(2, lane)}; }
    Box box() const {
        Box all;
        for (int k = 0; k < 3; ++k) {
            float low[8], high[8];
            for (int lane = 0; lane < 8; ++lane) {
                const float a = corner[0][k][lane], b = corner[1][k][lane], c = corner[2][k][lane];
                low[lane] = std::min(std::min(a, b), c);
                high[lane] = std::max(std::max(a, b), c);
            }
            all.min[k] = *std::min_element(low, low + 8);
            all.max[k] = *std::max_element(high, high + 8);
        }
        return without_negative_zeros(all);
    }

private:
    Vec3 point(int c, int lane) const { return {corner[c][0][lane], corner[c][1][lane], corner[c][2][lane]}; }
};

/// visit(lane) returns whether to go on. The result is false if a visit stopped the loop.
template <class Visit>
bool for_each_lane(uint32_t lanes, Visit&& visit) {
    for (; lanes != 0; lanes &= lanes - 1) {
        if (!visit(lowest_bit(lanes))) return false;
    }
    return true;
}

/// The triangles of valid arrays in packets, and the box of each packet. Throws std::bad_alloc.
void pack_triangles(const MeshArrays& arrays, Vector<TrianglePacket>& packets, Vector<Box>& boxes);
/// The same for a mesh whose packets are known.
void pack_triangles(const MeshParts& parts, Vector<TrianglePacket>& packets, Vector<Box>& boxes);

}  // namespace gphys

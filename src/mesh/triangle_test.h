// Conservative test of eight triangles against a ray: the watertight test of Woop, Benthin and Wald (2013) in float,
// with error bounds. These are derived in triangle_setup.h.
#pragma once

#include "foundation/simd.h"
#include "mesh/triangle_packet.h"
#include "mesh/triangle_probe.h"

namespace gphys::GPHYS_ISA {

/// Unused lanes come last. They repeat lane 0, and would be hit with it.
inline uint32_t used_lanes(const TrianglePacket& packet) {
    uint32_t used = 0xff;
    for (int lane = 8; packet.index[--lane] == TrianglePacket::none;) used >>= 1;
    return used;
}

class TriangleTest {
public:
    explicit TriangleTest(const TriangleProbe& probe)
        : ahead_(probe.rest.ahead),
          behind_(probe.rest.behind),
          margin_(probe.rest.margin),
          slope_x_(splat(probe.across.slope[0])),
          slope_y_(splat(probe.across.slope[1])),
          error_slope_x_(splat(probe.across.error_slope[0])),
          error_slope_y_(splat(probe.across.error_slope[1])),
          error_(splat(probe.rest.error)) {
        for (int k = 0; k < 3; ++k) {
            axis_[k] = probe.axis[k];
            origin_[k] = splat(probe.origin[k]);
        }
    }

    /// Lanes that the ray may hit no later than at `limit` (RayProbe::limit).
    GPHYS_INLINE uint32_t hits(const TrianglePacket& packet, float limit) const {
        Float8 x[3], y[3], z[3];
        for (int c = 0; c < 3; ++c) {
            z[c] = load_aligned(packet.corner[c][axis_[2]]) - origin_[2];
            x[c] = load_aligned(packet.corner[c][axis_[0]]) - origin_[0] - slope_x_ * z[c];
            y[c] = load_aligned(packet.corner[c][axis_[1]]) - origin_[1] - slope_y_ * z[c];
        }
        const Float8 volume_a = x[2] * y[1] - y[2] * x[1];
        const Float8 volume_b = x[0] * y[2] - y[0] * x[2];
        const Float8 volume_c = x[1] * y[0] - y[1] * x[0];
        const Float8 lowest = min3(volume_a, volume_b, volume_c);
        const Float8 highest = max3(volume_a, volume_b, volume_c);
        const Float8 error = error_slope_x_ * reach(x) + error_slope_y_ * reach(y) + error_;
        // The ray certainly misses if two volumes certainly differ in sign.
        const Mask8 around = (splat(0) - error <= lowest) | (highest <= error);
        const float low = -(limit * behind_) - margin_, high = limit * ahead_ + margin_;
        const uint32_t hits =
            bits(around & (splat(low) <= max3(z[0], z[1], z[2])) & (min3(z[0], z[1], z[2]) <= splat(high)));
        return hits == 0 ? 0 : hits & used_lanes(packet);
    }

private:
    static Float8 min3(Float8 a, Float8 b, Float8 c) { return min(min(a, b), c); }
    static Float8 max3(Float8 a, Float8 b, Float8 c) { return max(max(a, b), c); }
    static Float8 reach(const Float8 (&v)[3]) { return max(max3(v[0], v[1], v[2]), splat(0) - min3(v[0], v[1], v[2])); }

    int axis_[3];
    float ahead_, behind_, margin_;
    Float8 origin_[3];
    Float8 slope_x_, slope_y_, error_slope_x_, error_slope_y_, error_;
};

/// The bounding boxes of a packet's triangles, for the tests of box8_tests.h.
inline Box8 boxes_of(const TrianglePacket& packet) {
    Box8 boxes;
    for (int k = 0; k < 3; ++k) {
        const Float8 a = load_aligned(packet.corner[0][k]), b = load_aligned(packet.corner[1][k]),
                     c = load_aligned(packet.corner[2][k]);
        store(boxes.row[k], min(min(a, b), c));
        store(boxes.row[3 + k], max(max(a, b), c));
    }
    return boxes;
}

}  // namespace gphys::GPHYS_ISA

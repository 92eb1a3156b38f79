// A ray on its way through a mesh: what kernels and the exact test need of it, and the nearest
// crossing so far.
#pragma once

#include "intersect/intersect.h"
#include "mesh/triangle_packet.h"
#include "mesh/triangle_probe.h"

namespace gphys {

class MeshRay {
public:
    MeshRay(const Ray& ray, const Box& root)
        : sheared_(ray),
          along_(ray.origin, ray.direction, 0, root),
          probe_(sheared_, along_, root),
          limit_(along_.limit(ray.t_max)) {}

    const RayProbe& along() const { return along_; }
    const TriangleProbe& probe() const { return probe_; }
    /// Where the walk may end, for kernels.
    float limit() const { return limit_; }

    bool crosses(const Triangle& corners, TriangleCrossing& crossing) const {
        return gphys::crosses(corners, sheared_, crossing);
    }
    Hit hit_at(const Triangle& corners, const TriangleCrossing& crossing) const {
        return gphys::hit_at(corners, sheared_, crossing);
    }

    /// Look for a nearer crossing among some lanes of a packet. Asked for is always the ray as given:
    /// comparing crossings, not cutting the ray short, makes the answer independent of their order.
    void meet(const TrianglePacket& packet, uint32_t lanes) {
        const double before = nearest_.t;
        for_each_lane(lanes, [&](int lane) {
            const Triangle corners = packet.triangle(lane);
            TriangleCrossing crossing;
            if (crosses(corners, crossing) &&
                (crossing.t < nearest_.t || (crossing.t == nearest_.t && packet.index[lane] < triangle_))) {
                nearest_ = crossing;
                triangle_ = packet.index[lane];
                corners_ = corners;
            }
            return true;
        });
        if (nearest_.t != before) limit_ = along_.limit(nearest_.t);
    }

    /// The hit at the nearest crossing; false if there was none.
    bool result(Hit& hit) const {
        if (triangle_ == GPHYS_NO_TRIANGLE) return false;
        hit = hit_at(corners_, nearest_);
        hit.triangle = triangle_;
        return true;
    }

private:
    ShearedRay sheared_;
    RayProbe along_;
    TriangleProbe probe_;
    float limit_;
    TriangleCrossing nearest_{infinity, 0, 0, 0};
    uint32_t triangle_ = GPHYS_NO_TRIANGLE;
    Triangle corners_;
};

}  // namespace gphys

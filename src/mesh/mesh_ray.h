// A ray on its way through a mesh: what kernels and the exact test need of it, and the nearest
// crossing so far.
#pragma once

#include "intersect/intersect.h"
#include "mesh/triangle_packet.h"
#include "mesh/triangle_probe.h"

namespace gphys {

/// What kernels and the exact test need of a ray, made by one or by eight (mesh_kernels.h).
struct PreparedRay {
    PreparedRay() = default;
    PreparedRay(const Ray& ray, const RaysRoot& root)
        : sheared(ray),
          along(ray.origin, ray.direction, root),
          triangles(sheared, along, root),
          limit(along.limit(ray.t_max)) {}

    ShearedRay sheared;
    RayProbe along;
    TriangleProbe triangles;
    float limit;  // where the walk may end, for kernels
};

class MeshRay {
public:
    /// The prepared ray must live as long.
    explicit MeshRay(const PreparedRay& ray) : ray_(&ray), limit_(ray.limit) {}

    const PreparedRay& prepared() const { return *ray_; }
    /// Where the walk may end from now on.
    float limit() const { return limit_; }

    bool crosses(const Triangle& corners, TriangleCrossing& crossing) const {
        return gphys::crosses(corners, ray_->sheared, crossing);
    }
    Hit hit_at(const Triangle& corners, const TriangleCrossing& crossing) const {
        return gphys::hit_at(corners, ray_->sheared, crossing);
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
        if (nearest_.t != before) limit_ = ray_->along.limit(nearest_.t);
    }

    /// The hit at the nearest crossing; false if there was none.
    bool result(Hit& hit) const {
        if (triangle_ == GPHYS_NO_TRIANGLE) return false;
        hit = hit_at(corners_, nearest_);
        hit.triangle = triangle_;
        return true;
    }

private:
    const PreparedRay* ray_;
    float limit_;
    TriangleCrossing nearest_{infinity, 0, 0, 0};
    uint32_t triangle_ = GPHYS_NO_TRIANGLE;
    Triangle corners_;
};

}  // namespace gphys

// A ray on its way through a mesh: what kernels and the exact test need of it, and the nearest
// crossing so far.
#pragma once

#include "foundation/compiler.h"
#include "geometry/intersect.h"
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

/// Where a ray first crosses a mesh, as far as it is known. Asked for is always the ray as given: comparing
/// crossings, not cutting the ray short, makes the answer independent of their order.
struct NearestCrossing {
    /// Whether this one, reported at `other_t`, comes before; of equal ones that of the lower index.
    GPHYS_INLINE bool take(const TriangleCrossing& other, float other_t, const TrianglePacket& of, uint32_t at) {
        const uint32_t index = of.index[at];
        if (!(other_t < t || (other_t == t && index < triangle))) return false;
        crossing = other;
        t = other_t;
        triangle = index;
        packet = &of;
        lane = at;
        return true;
    }

    TriangleCrossing crossing{infinity, 0, 0, 0};
    float t = std::numeric_limits<float>::infinity();  // as it is reported
    uint32_t triangle = GPHYS_NO_TRIANGLE;
    uint32_t lane = 0;
    const TrianglePacket* packet = nullptr;
};

/// The whole answer; false if there is none.
inline bool hit_at(const NearestCrossing& nearest, const ShearedRay& ray, Hit& hit) {
    if (nearest.triangle == GPHYS_NO_TRIANGLE) return false;
    hit = hit_at(nearest.packet->triangle(static_cast<int>(nearest.lane)), ray, nearest.crossing);
    hit.triangle = nearest.triangle;
    return true;
}

}  // namespace gphys

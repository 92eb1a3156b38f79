// A ray prepared for the traversal of a mesh, and its nearest crossing so far.
#pragma once

#include "foundation/compiler.h"
#include "geometry/intersect.h"
#include "mesh/triangle_packet.h"
#include "mesh/triangle_probe.h"

namespace gphys {

/// The data that kernels and the exact test need, prepared for one ray or for eight at once (mesh_kernels.h).
struct PreparedRay {
    PreparedRay() = default;
    PreparedRay(const Ray& ray, const RootBounds& root)
        : sheared(ray),
          along(ray.origin, ray.direction, root),
          triangles(sheared, along, root),
          limit(along.limit(ray.t_max)) {}

    ShearedRay sheared;
    RayProbe along;
    TriangleProbe triangles;
    float limit;  // where kernels may end the traversal
};

/// The nearest crossing found so far. Every triangle is tested against the original ray: comparing crossings instead of
/// shortening the ray makes the result independent of their order.
struct NearestCrossing {
    /// Takes the crossing, reported at `other_t`, if it is nearer, or as near with a lower index.
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
    float t = std::numeric_limits<float>::infinity();  // as reported
    uint32_t triangle = GPHYS_NO_TRIANGLE;
    uint32_t lane = 0;
    const TrianglePacket* packet = nullptr;
};

/// The whole answer; false if there is none.
inline bool hit_at(const NearestCrossing& nearest, const Ray& ray, Hit& hit) {
    if (nearest.triangle == GPHYS_NO_TRIANGLE) return false;
    make_hit(nearest.packet->triangle(static_cast<int>(nearest.lane)), ray, nearest.crossing, hit);
    hit.triangle = nearest.triangle;
    return true;
}

}  // namespace gphys

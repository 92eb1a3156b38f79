// A single ray against the triangles of a mesh, for kernels: prepared in registers, then traversed to the nearest or to
// any crossing. Triangles that the float test does not reject get the exact test one by one (single_crossing.h): on
// average there is less than one, for which eight lanes of doubles take longer with AVX2 and as long with AVX-512.
#pragma once

#include "bvh/ordered_traversal.h"
#include "bvh/ray_setup.h"
#include "foundation/compiler.h"
#include "foundation/simd_axes.h"
#include "geometry/shear.h"
#include "mesh/mesh_kernels.h"
#include "mesh/single_crossing.h"
#include "mesh/triangle_setup.h"
#include "mesh/triangle_test.h"

namespace gphys::GPHYS_ISA {

GPHYS_INLINE TriangleProbe probe_of_triangles(const SingleShear<Axes>& ray, const RaySetup<Axes>& along,
                                              const RootBounds& box) {
    const TriangleSetup<Axes> setup(ray, along.begin, along.slack, along.span < unbounded_span, box);
    const auto narrow = [](double value) { return static_cast<float>(value); };
    TriangleProbe probe;
    probe.axis[0] = ray.kx, probe.axis[1] = ray.ky, probe.axis[2] = ray.kz;
    for (int k = 0; k < 3; ++k) probe.origin[k] = narrow(setup.origin[k]);
    probe.across = {{narrow(setup.slope_x), narrow(setup.slope_y)},
                    {narrow(setup.error_slope_x), narrow(setup.error_slope_y)}};
    const float ahead = narrow(setup.ahead);
    probe.rest = {ahead, 1 - ahead, narrow(setup.margin), narrow(setup.error)};
    return probe;
}

/// The nearest crossing so far, among those on allowed sides.
class CountedCrossings {
public:
    GPHYS_INLINE CountedCrossings(const Ray& ray, const SingleCrossing& quick, bool only_front,
                                  CrossesTriangleAlone exact, NearestCrossing& nearest)
        : ray_(ray),
          quick_(quick),
          front_(only_front || ray.faces.front),
          back_(!only_front && ray.faces.back),
          edge_(!only_front && ray.faces.front),
          exact_(exact),
          nearest_(nearest) {}

    /// Tests some lanes of a packet.
    GPHYS_INLINE void test(const TrianglePacket& packet, uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto i = static_cast<uint32_t>(lowest_bit(lanes));
            TriangleCrossing crossing;
            const TriState crosses = quick_(packet, i, crossing);
            if (crosses == TriState::no) continue;
            if (crosses == TriState::undecided && !exact_(ray_, packet, i, crossing)) continue;
            if (!(crossing.facing < 0 ? front_ : crossing.facing > 0 ? back_ : edge_)) continue;
            nearest_.take(crossing, reported(crossing.t), packet, i);
        }
    }

private:
    const Ray& ray_;
    const SingleCrossing& quick_;
    bool front_, back_, edge_;
    CrossesTriangleAlone exact_;
    NearestCrossing& nearest_;
};

/// Order is ClosestHit or AnyHit.
template <class Order>
void cast_ray(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const Ray& ray, const RootBounds& box,
              bool only_front, CrossesTriangleAlone exact, NearestCrossing& nearest) {
    const Axes origin = axes_of(ray.origin), direction = axes_of(ray.direction);
    const RaySetup<Axes> along(origin, direction, box);
    const auto limit_at = [&](double t) GPHYS_INLINE_LAMBDA {
        return static_cast<float>(ray_limit(t, along.slack, along.scale, along.start, along.span));
    };
    float limit = limit_at(ray.t_max);
    if (!(limit >= 0)) return;
    RayProbe probe;
    store_probe(along, probe);
    const SingleShear<Axes> shear(direction);
    const TriangleTest triangles(probe_of_triangles(shear, along, box));
    const SingleCrossing quick(shear, origin, ray.t_max);
    CountedCrossings crossings(ray, quick, only_front, exact, nearest);
    traverse_ordered(
        nodes, root, SingleRayTest(probe), limit,
        [&](uint32_t number) GPHYS_INLINE_LAMBDA {
            const TrianglePacket& packet = packets[number];
            const uint32_t lanes = triangles.hits(packet, limit);
            if (lanes == 0) return limit;
            const float before = nearest.t;
            crossings.test(packet, lanes);
            if (nearest.t < before) {
                limit = std::is_same_v<Order, AnyHit> ? -1 : limit_at(limit_of_ties<double>(nearest.t));
            }
            return limit;
        },
        [](const BvhNode&) {});
}

}  // namespace gphys::GPHYS_ISA

// The kernels of bvh_kernels.h: each combines a traversal with a test of boxes and a visitor.
#include "bvh/bvh_kernels.h"

#include <limits>

#include "bvh/interleaved_traversal.h"
#include "bvh/ordered_traversal.h"
#include "bvh/overlap_traversal.h"
#include "bvh/packet_traversal.h"
#include "bvh/pair_traversal.h"
#include "bvh/ray_lanes.h"
#include "foundation/simd_axes.h"

namespace gphys::GPHYS_ISA {
namespace {

/// Scalar form: make_probe for each ray.
void make_probes(const Ray* rays, uint32_t count, const RootBounds& root, RayProbe* probes, float* limits) {
    for (uint32_t first = 0; first < count; first += 8) {
        const Rays8 eight(rays + first, count - first);
        const RaySetup<Vec<Double8>> setup(eight.origin, eight.direction, root);
        RayProbe* const to = probes + first;
        store(limits + first, store_probes(eight.t_max, setup, [&](int i) -> RayProbe& { return to[i]; }));
    }
}

float make_probe(const Ray& ray, double t_max, const Box& box, RayProbe& to) {
    const Vec<double> low{box.min[0], box.min[1], box.min[2]}, high{box.max[0], box.max[1], box.max[2]};
    const Axes lows = axes_of(low), highs = axes_of(high);
    RootBounds root;
    store(root.low, lows);
    store(root.high, highs);
    root.extent = max_component(max(abs(lows), abs(highs)));
    root.radius = 0;
    const RaySetup<Axes> setup(axes_of(ray.origin), axes_of(ray.direction), root);
    store_probe(setup, to);
    return static_cast<float>(ray_limit(t_max, setup.slack, setup.scale, setup.start, setup.span));
}

template <class Test, class Probe>
void closest_hit(const BvhNode* nodes, uint32_t root, const Probe& probe, float limit, const BvhVisitor& to) {
    traverse_ordered(
        nodes, root, Test(probe), limit, [&](uint32_t item) { return to.visit(to.context, item); },
        [&](const BvhNode& leaf) GPHYS_INLINE_LAMBDA {
            // Before the test of the boxes: most items will be visited. Unused lanes are prefetched, too, without harm.
            const char* const first = static_cast<const char*>(to.items.first);
            for (const uint32_t item : leaf.child) prefetch(first + size_t{item} * to.items.size);
        });
}

template <class Order>
void interleaved_rays(const BvhNode* nodes, uint32_t root, const RayProbe* probes, const float* limits, uint32_t count,
                      const BvhPairsVisitor& to) {
    traverse_interleaved<Order, RayTest>(
        nodes, root, [&](uint32_t ray) -> const RayProbe& { return probes[ray]; }, limits, count,
        [&](const uint32_t* rays, const uint32_t* items, uint32_t some, float* new_limits) {
            return to.visit(to.context, rays, items, some, new_limits);
        },
        [&](uint32_t item) GPHYS_INLINE_LAMBDA { prefetch_item(to.items, item); });
}

/// Returns false if the packet diverges: its rays have to go on from the present limits.
bool packet_of_rays(const BvhNode* nodes, uint32_t root, const RayProbe* probes, float* limits, uint32_t count,
                    const BvhPairsVisitor& to) {
    const auto visit = [&](const uint32_t* rays, const uint32_t* items, uint32_t some) {
        float new_limits[8];
        for (uint32_t moved = to.visit(to.context, rays, items, some, new_limits); moved != 0; moved &= moved - 1) {
            const int i = lowest_bit(moved);
            limits[rays[i]] = new_limits[i];
        }
    };
    VisitQueue visits(visit);
    PacketTest packet([&](uint32_t ray) -> const RayProbe& { return probes[ray]; }, limits, count);
    return traverse_packet(
        nodes, root, packet, count,
        [&](uint32_t group, uint32_t mask, uint32_t item) { visits.add(group, mask, item); }, [&] { visits.flush(); },
        [&](uint32_t item) GPHYS_INLINE_LAMBDA { prefetch_item(to.items, item); });
}

template <class Order>
void many_rays(const BvhNode* nodes, uint32_t root, const RayProbe* probes, const float* limits, uint32_t count,
               bool is_packet, const BvhPairsVisitor& to) {
    if (!is_packet) return interleaved_rays<Order>(nodes, root, probes, limits, count, to);
    PacketLimits present(count, [&](uint32_t ray) { return limits[ray]; });
    if (packet_of_rays(nodes, root, probes, present.limits, count, to)) return;
    interleaved_rays<Order>(nodes, root, probes, present.limits, count, to);
}

void closest_of_points(const BvhNode* nodes, uint32_t root, const PointProbe* probes, const float* limits,
                       uint32_t count, const BvhPairsVisitor& to) {
    traverse_interleaved<ClosestHit, PointTest>(
        nodes, root, [&](uint32_t point) -> const PointProbe& { return probes[point]; }, limits, count,
        [&](const uint32_t* points, const uint32_t* items, uint32_t some, float* new_limits) {
            return to.visit(to.context, points, items, some, new_limits);
        },
        [&](uint32_t item) GPHYS_INLINE_LAMBDA { prefetch_item(to.items, item); });
}

void any_hit(const BvhNode* nodes, uint32_t root, const RayProbe& probe, float limit, const BvhVisitor& to) {
    if (!(limit >= 0)) return;
    const SingleRayTest test(probe);
    traverse_unordered(
        nodes, root,
        [&](const Box8& boxes) {
            Float8 entry;
            return test.hits(boxes, limit, entry);
        },
        [&](const BvhNode& leaf, uint32_t lanes) {
            for (uint32_t rest = lanes; rest != 0 && to.items.size != 0; rest &= rest - 1) {
                prefetch_item(to.items, leaf.child[lowest_bit(rest)]);
            }
            for (; lanes != 0; lanes &= lanes - 1) {
                if (to.visit(to.context, leaf.child[lowest_bit(lanes)]) < 0) return false;
            }
            return true;
        });
}

template <class Test, class Probe>
bool overlap(const BvhNode* nodes, uint32_t root, const Probe& probe, const BvhListVisitor& to) {
    return traverse_overlap(nodes, root, Test(probe), to);
}

template <class Test, class Probe>
void overlaps(const BvhNode* nodes, uint32_t root, const Probe* probes, uint32_t count, ItemMemory items,
              ItemMemory items_inside, OverlapItems* found) {
    traverse_overlaps(
        nodes, root, count,
        [&](uint32_t query, const Box8& boxes, uint32_t& inside) { return Test(probes[query]).hits(boxes, inside); },
        items, items_inside, found);
}

/// out[k] and out[4 + k]: the minima of rows[k] over the two halves of the lanes.
void minima_of_rows(const Float8 (&rows)[3], float (&out)[8]) {
    Float8 least;
    for (int i = 0; i < register_count; ++i) {
        FloatRegister lanes[4] = {rows[0].part[i], rows[1].part[i], rows[2].part[i], rows[2].part[i]};
        transpose(lanes);
        least.part[i] = minimum(minimum(lanes[0], lanes[1]), minimum(lanes[2], lanes[3]));
    }
    store(out, least);
}

/// Scalar form: Bvh8::union_of. Unused lanes count as the largest float.
void node_bounds(const BvhNode& node, Box& out) {
    static constexpr float numbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const Mask8 used = load(numbers) <= splat(static_cast<float>(node.count) - 1);
    const Float8 largest_float = splat(std::numeric_limits<float>::max()), zero = splat(0);
    Float8 low[3], high[3];  // high is negated, so that both are minima
    for (int k = 0; k < 3; ++k) {
        low[k] = choose(used, load(node.boxes.row[k]), largest_float);
        high[k] = choose(used, zero - load(node.boxes.row[3 + k]), largest_float);
    }
    float min[8], less_max[8];
    minima_of_rows(low, min);
    minima_of_rows(high, less_max);
    for (int k = 0; k < 3; ++k) {
        out.min[k] = min[k] < min[4 + k] ? min[k] : min[4 + k];
        out.max[k] = 0 - (less_max[k] < less_max[4 + k] ? less_max[k] : less_max[4 + k]);
    }
}

}  // namespace

extern const BvhKernels bvh_kernels{
    make_probes,
    make_probe,
    closest_hit<SingleRayTest, RayProbe>,
    many_rays<ClosestHit>,
    many_rays<AnyHit>,
    closest_hit<PointTest, PointProbe>,
    closest_of_points,
    closest_hit<WeightedPointTest, WeightedPointProbe>,
    any_hit,
    overlap<BoxTest, Box>,
    overlap<BallTest, BallProbe>,
    overlaps<BoxTest, Box>,
    overlaps<BallTest, BallProbe>,
    traverse_frustum,
    traverse_pairs,
    node_bounds,
};

}  // namespace gphys::GPHYS_ISA

// The table of traversals, one for each instruction set. A traversal reads nodes and probes, and calls a visitor for
// each item that it finds. The kinds:
//
// - ordered_traversal.h      one query, nearest first: closest hit of a ray, nearest item of a point
// - unordered_traversal.h    one query, depth first: any hit of a ray
// - interleaved_traversal.h  many rays or points, independently; one computes while others wait for memory
// - packet_traversal.h       many coherent rays, together
// - overlap_traversal.h      boxes, balls and frusta, one or several
// - pair_traversal.h         two trees
#pragma once

#include "bvh/bvh_node.h"
#include "foundation/compiler.h"
#include "foundation/isa.h"

namespace gphys {

/// The array of what a visitor reads of each item, for prefetches.
struct ItemMemory {
    const void* first = nullptr;
    uint32_t size = 0;  // of one, in bytes
};

/// Visitor of a traversal with a limit.
struct BvhVisitor {
    /// Returns the new limit, at most the old one; a negative one ends the traversal.
    float (*visit)(void* context, uint32_t item);
    void* context;
    ItemMemory items;
};

/// Visitor of a traversal by many queries: rays or points.
struct BvhPairsVisitor {
    /// Pairs queries[k], items[k] for k < count <= 8. Bit k of the result: queries[k] has the new limit limits[k].
    uint32_t (*visit)(void* context, const uint32_t* queries, const uint32_t* items, uint32_t count, float* limits);
    void* context;
    ItemMemory items;
};

/// Visitor of an unordered traversal. inside: all of these items lie wholly inside the query; else unknown. Returns
/// false to end the traversal.
struct BvhListVisitor {
    bool (*visit)(void* context, const uint32_t* items, uint32_t count, bool inside);
    void* context;
    ItemMemory items, items_inside;
    bool needs_inside;  // false: the visitor ignores `inside`
};

/// The result of one of several interleaved overlap queries.
struct OverlapItems {
    static constexpr uint32_t max_queries = 8, max_nodes = 64, capacity = 128;

    bool complete;      // false: more than fits; the query has to be repeated alone
    uint32_t count[2];  // [1]: items wholly inside the query; [0]: the others
    uint32_t items[2][capacity + 8];

    GPHYS_INLINE void clear() {
        complete = true;
        count[0] = count[1] = 0;
    }
};

/// Visitor of pairs of items. Returns false to end the traversal.
struct BvhPairVisitor {
    bool (*visit)(void* context, uint32_t item, uint32_t other_item);
    void* context;
};

struct BvhKernels {
    /// Probes and limits of `count` >= 1 rays, with the bits of `probe`. Writes up to the next multiple of eight.
    void (*probes)(const Ray* rays, uint32_t count, const RootBounds& root, RayProbe* probes, float* limits);
    /// The probe of one ray. `box` encloses all boxes that will be tested. Returns the limit for t_max.
    float (*probe)(const Ray& ray, double t_max, const Box& box, RayProbe& to);
    // Ordered traversals.
    void (*ray)(const BvhNode* nodes, uint32_t root, const RayProbe& probe, float limit, const BvhVisitor& to);
    /// Closest hits of many rays. is_packet: at most RayPackets::max_rays, with the same signs of direction.
    void (*rays)(const BvhNode* nodes, uint32_t root, const RayProbe* probes, const float* limits, uint32_t count,
                 bool is_packet, const BvhPairsVisitor& to);
    /// Any hits: the visitor ends a ray by a negative limit, or does not change its limit.
    void (*rays_any)(const BvhNode* nodes, uint32_t root, const RayProbe* probes, const float* limits, uint32_t count,
                     bool is_packet, const BvhPairsVisitor& to);
    void (*point)(const BvhNode* nodes, uint32_t root, const PointProbe& probe, float limit, const BvhVisitor& to);
    void (*points)(const BvhNode* nodes, uint32_t root, const PointProbe* probes, const float* limits, uint32_t count,
                   const BvhPairsVisitor& to);
    void (*weighted_point)(const BvhNode* nodes, uint32_t root, const WeightedPointProbe& probe, float limit,
                           const BvhVisitor& to);
    // Unordered traversals.
    void (*ray_any)(const BvhNode* nodes, uint32_t root, const RayProbe& probe, float limit, const BvhVisitor& to);
    // False if the visitor ended it.
    bool (*box)(const BvhNode* nodes, uint32_t root, const Box& box, const BvhListVisitor& to);
    bool (*ball)(const BvhNode* nodes, uint32_t root, const BallProbe& probe, const BvhListVisitor& to);
    // Up to OverlapItems::max_queries queries, interleaved; prefetches `items` and `items_inside` of what is found.
    // `found` was cleared.
    void (*boxes)(const BvhNode* nodes, uint32_t root, const Box* boxes, uint32_t count, ItemMemory items,
                  ItemMemory items_inside, OverlapItems* found);
    void (*balls)(const BvhNode* nodes, uint32_t root, const BallProbe* probes, uint32_t count, ItemMemory items,
                  ItemMemory items_inside, OverlapItems* found);
    bool (*frustum)(const BvhNode* nodes, uint32_t root, const FrustumProbe& probe, const BvhListVisitor& to);
    bool (*pairs)(const BvhNode* nodes, uint32_t root, const BvhNode* other_nodes, uint32_t other_root,
                  const BvhPairVisitor& to);
    /// The union of a node's boxes.
    void (*node_bounds)(const BvhNode& node, Box& out);
};

GPHYS_DECLARE_KERNELS(BvhKernels, bvh_kernels)

}  // namespace gphys

// The traversals of the tree, once for each instruction set. They read nodes and probes, and give each item that they
// find to a callback. They differ in kind:
//
// - ordered_traversal.h      one query, nearest first: closest hit of a ray, nearest item of a point
// - unordered_traversal.h    one query, depth first: any hit of a ray
// - interleaved_traversal.h  many rays, each by itself, while others wait for memory
// - packet_traversal.h       many rays, together
// - overlap_traversal.h      boxes, balls and frusta, one or several
// - pair_traversal.h         two trees
#pragma once

#include "bvh/bvh_node.h"
#include "foundation/compiler.h"
#include "foundation/isa.h"

namespace gphys {

/// What a visitor reads of each item, an array, so that it can be fetched ahead.
struct ItemMemory {
    const void* first = nullptr;
    uint32_t size = 0;  // of one, in bytes
};

/// Who gets the items that a traversal with a limit finds.
struct BvhVisitor {
    /// Returns the new limit, which may have come nearer; a negative one ends the traversal.
    float (*visit)(void* context, uint32_t item);
    void* context;
    ItemMemory items;
};

/// The same for many rays at once.
struct BvhRayVisitor {
    /// items[k] is for rays[k], k < count <= 8. Which of these rays have a new limit tells bit k; it is in
    /// limits[k] then.
    uint32_t (*visit)(void* context, const uint32_t* rays, const uint32_t* items, uint32_t count, float* limits);
    void* context;
    ItemMemory items;
};

/// Who gets the items that a traversal without order finds: several that all lie wholly inside the
/// query, or of which that is not known. Returns whether to go on.
struct BvhListVisitor {
    bool (*visit)(void* context, const uint32_t* items, uint32_t count, bool inside);
    void* context;
    ItemMemory items, items_inside;
    bool asks_inside;  // else no item need be told to lie inside
};

/// What one of several interleaved queries has found.
struct OverlapItems {
    static constexpr uint32_t most_queries = 8, most_nodes = 64, capacity = 128;

    bool complete;      // else there is too much for this, and the query has to be asked alone
    uint32_t count[2];  // of those of which it is not known, and of those that lie wholly inside the query
    uint32_t items[2][capacity + 8];

    GPHYS_INLINE void clear() {
        complete = true;
        count[0] = count[1] = 0;
    }
};

/// Gets pairs of items. Returns whether to go on.
struct BvhPairVisitor {
    bool (*visit)(void* context, uint32_t item, uint32_t other_item);
    void* context;
};

struct BvhKernels {
    /// The probes of many rays and their limits, with the same bits as one by one. `count` is at least
    /// 1; what is written is rounded up to a multiple of eight.
    void (*probes)(const Ray* rays, uint32_t count, const RaysRoot& root, RayProbe* probes, float* limits);
    /// That of one ray in `box`, which encloses all that will be tested; returns its limit if it ends at t_max.
    float (*probe)(const Ray& ray, double t_max, const Box& box, RayProbe& to);
    // Roughly nearest first.
    void (*ray)(const BvhNode* nodes, uint32_t root, const RayProbe& probe, float limit, const BvhVisitor& to);
    /// Many rays. Up to RayPackets::most with the same signs of direction may go as a packet.
    void (*rays)(const BvhNode* nodes, uint32_t root, const RayProbe* probes, const float* limits, uint32_t count,
                 bool is_packet, const BvhRayVisitor& to);
    /// The same for visits that end a ray, by a negative limit, or leave its limit as it is; not in order.
    void (*rays_any)(const BvhNode* nodes, uint32_t root, const RayProbe* probes, const float* limits, uint32_t count,
                     bool is_packet, const BvhRayVisitor& to);
    void (*point)(const BvhNode* nodes, uint32_t root, const PointProbe& probe, float limit, const BvhVisitor& to);
    void (*weighted_point)(const BvhNode* nodes, uint32_t root, const WeightedPointProbe& probe, float limit,
                           const BvhVisitor& to);
    // In no order.
    void (*ray_any)(const BvhNode* nodes, uint32_t root, const RayProbe& probe, float limit, const BvhVisitor& to);
    // False if a visitor ended it.
    bool (*box)(const BvhNode* nodes, uint32_t root, const Box& box, const BvhListVisitor& to);
    bool (*ball)(const BvhNode* nodes, uint32_t root, const BallProbe& probe, const BvhListVisitor& to);
    // Up to OverlapItems::most_queries, interleaved. What a visitor reads of the items is prefetched. `found` is
    // cleared.
    void (*boxes)(const BvhNode* nodes, uint32_t root, const Box* boxes, uint32_t count, ItemMemory items,
                  ItemMemory items_inside, OverlapItems* found);
    void (*balls)(const BvhNode* nodes, uint32_t root, const BallProbe* probes, uint32_t count, ItemMemory items,
                  ItemMemory items_inside, OverlapItems* found);
    bool (*frustum)(const BvhNode* nodes, uint32_t root, const FrustumProbe& probe, const BvhListVisitor& to);
    bool (*pairs)(const BvhNode* nodes, uint32_t root, const BvhNode* other_nodes, uint32_t other_root,
                  const BvhPairVisitor& to);
    /// The smallest box around all of a node's.
    void (*around)(const BvhNode& node, Box& out);
};

GPHYS_DECLARE_KERNELS(BvhKernels, bvh_kernels)

}  // namespace gphys

// A binary BVH, built top-down: a range of boxes is split (sah.h) until each part fits into a leaf. An eight-wide BVH
// is made from it by collapsing levels.
//
// A random ray visits a node in proportion to the node's surface area. So the collapse minimises the sum of the areas
// of all wide nodes, by dynamic programming from the leaves up (Ylitie, Karras, Laine, "Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs", 2017, section 3). To collapse every three levels into one would be
// simpler, but gives nodes with few children where leaves lie at different depths.
#pragma once

#include "bvh/sah.h"
#include "foundation/memory.h"

namespace gphys {

class Workers;

class BinaryBvh {
public:
    static constexpr uint32_t none = 0xffffffffu;

    /// An inner node. It is known by the index of the first item of its second child.
    struct Split {
        uint32_t children[2];  // none: a leaf
        uint32_t height;       // levels of inner nodes from here down, at least 1
        uint32_t left_shares;  // see left_share()

        /// The best way to hold these items in at most `nodes` wide nodes, 2 to 8: the number of nodes for the first
        /// child. 0: one node for both children is best; never for 8.
        uint32_t left_share(uint32_t nodes) const { return left_shares >> (4 * (nodes - 2)) & 15; }
    };

    /// Sorts the items into the order of the leaves. No leaf has more than `max_height` inner nodes above it;
    /// max_height must suffice for halving down to leaves. The result does not depend on the number of workers.
    BinaryBvh(Vector<BoxedItem>& items, uint32_t max_height, const Workers* workers);

    /// none: all items are in one leaf.
    uint32_t root() const { return root_; }
    const Split& operator[](uint32_t split_at) const { return slots_[split_at].split; }
    uint32_t height(uint32_t split_at) const { return split_at == none ? 0 : slots_[split_at].split.height; }

    class Gradual;

private:
    /// Not split yet.
    explicit BinaryBvh(Vector<BoxedItem>& items) : items_(items.data()), slots_(items.size(), items.get_allocator()) {}

    /// Scratch memory of the partition until the range is split, then the inner node.
    union Slot {
        Slot() {}
        BoxedItem item;
        Split split;
    };
    struct Range {
        uint32_t first = 0, last = 0, max_height = 0;
        uint32_t size() const { return last - first; }
    };

    struct Subtree {
        uint32_t split_at = none;
        Box box;
        /// cost[i]: the least sum of half areas of all wide nodes, with at most i + 1 of them at the top.
        double cost[7];
    };

    static bool may_split_by_cost(Range range);
    uint32_t split(Range range);
    static Subtree leaf(const Box& box);
    Subtree join(uint32_t split_at, const Subtree& low, const Subtree& high);
    Subtree build_range(Range range);
    Subtree build_parallel(Range whole, const Workers& workers);

    BoxedItem* items_;
    Vector<Slot> slots_;
    uint32_t root_ = none;
};

}  // namespace gphys

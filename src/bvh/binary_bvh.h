// Top-down construction of a binary BVH: a range of boxes is split until each part fits into a leaf. Eight-wide BVHs
// are made from it by collapsing levels, so that the sum of the areas of all nodes, which rays visit in proportion to
// it, is least. The collapse is found by dynamic programming from the leaves up (Ylitie, Karras, Laine, "Efficient
// Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017, section 3).
#pragma once

#include "bvh/sah.h"
#include "foundation/memory.h"

namespace gphys {

class Workers;

class BinaryBvh {
public:
    static constexpr uint32_t none = 0xffffffffu;

    /// Of the items that `cut` halves: where the halves are cut, unless they are leaves.
    struct Cut {
        uint32_t below[2];
        uint32_t height;  // levels of cuts, at least 1
        uint32_t shares;  // see share()

        /// Of at most `nodes` eight-wide nodes, from 2 to 8, that are to hold these items: how many the first half
        /// gets. 0: one node for both is best, which is not asked of 8.
        uint32_t share(uint32_t nodes) const { return shares >> (4 * (nodes - 2)) & 15; }
    };

    /// Puts the items in order. No leaf is below more than `max_height` cuts, which must be enough
    /// to halve that often. Workers share the work; the result is the same for any number of them.
    BinaryBvh(Vector<BoxedItem>& items, uint32_t max_height, const Workers* workers);

    /// Cuts are known by the index of the first item behind them. none: all is one leaf.
    uint32_t root() const { return root_; }
    const Cut& operator[](uint32_t cut) const { return slots_[cut].cut; }
    uint32_t height(uint32_t cut) const { return cut == none ? 0 : slots_[cut].cut.height; }

private:
    /// First a place for an item on its way, then for the cut before that item.
    union Slot {
        Slot() {}
        BoxedItem item;
        Cut cut;
    };
    struct Range {
        uint32_t first = 0, last = 0, max_height = 0;
        uint32_t size() const { return last - first; }
    };

    struct Part {
        uint32_t cut = none;
        Box box;
        /// The least sum of half areas of nodes, with all below them, if there are at most i + 1 on top.
        double cost[7];
    };

    uint32_t split(Range range);
    static Part leaf(const Box& box);
    Part join(uint32_t cut, const Part& low, const Part& high);
    Part cut_all(Range range);
    Part cut_shared(Range whole, const Workers& workers);

    BoxedItem* items_;
    Vector<Slot> slots_;
    uint32_t root_ = none;
};

}  // namespace gphys

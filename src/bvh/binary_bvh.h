// Top-down construction of a binary BVH: a range of boxes is split until each part fits into a leaf. Eight-wide BVHs
// are made from it by collapsing levels.
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
        double half_area;
        uint32_t below[2];
        uint32_t height;  // levels of cuts, at least 1
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
    };

    uint32_t split(Range range);
    Part join(uint32_t cut, const Part& low, const Part& high);
    Part cut_all(Range range);
    Part cut_shared(Range whole, const Workers& workers);

    BoxedItem* items_;
    Vector<Slot> slots_;
    uint32_t root_ = none;
};

}  // namespace gphys

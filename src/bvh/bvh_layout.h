// The topology of a BVH, as snapshots store it: a restore then needs no search for splits. The boxes are not stored,
// since they follow from those of the items.
//
// One word for each node in preorder: the number of children minus one, plus leaf_mark if they are items. Items are in
// the order of the leaves. One pass validates any words. Valid words always give a correct tree, because the boxes are
// computed again.
#pragma once

#include "bvh/bvh_node.h"

namespace gphys {

struct BvhLayout {
    static constexpr uint32_t leaf_mark = 8;

    const uint32_t* nodes;
    uint32_t node_count;
    const uint32_t* items;  // null: 0, 1, 2 and so on
    uint32_t item_count;

    uint32_t item(uint32_t i) const { return items ? items[i] : i; }
    /// What is wrong with the nodes, or nullptr. The caller checks that the items are distinct.
    const char* defect() const;
};

}  // namespace gphys

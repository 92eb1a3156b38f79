// An BVH without its boxes, which follow from those of its items: what snapshots keep of a tree, so that loading it
// takes no search for cuts.
//
// A word for each node, parents before their children and the first child first (preorder): the number of its
// children less one, and leaf_mark if these are items. Items stand in the order of the leaves. Any words can be
// checked in one pass, and what passes is a tree whose boxes are right, because they are made anew.
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
    /// What is wrong with the nodes, or nullptr. That items are different is for the caller to check.
    const char* defect() const;
};

}  // namespace gphys

// A node of the BVH: the boxes and references of up to eight children, then what updates need. A query reads the boxes,
// the references and `count`, which are adjacent.
#pragma once

#include "bvh/box8.h"

namespace gphys {

struct alignas(64) BvhNode {
    Box8 boxes;         // lanes from count on are unused, and finite
    uint32_t child[8];  // references to nodes; in a leaf, items
    uint32_t count;     // of children; 0: the node is free
    uint32_t parent;    // index; bvh_none: this is the root. In a free node: the next free node
    uint32_t lane;      // in the parent
    // Leaves only: half areas of the leaf's and the root's box when the leaf's items were chosen.
    float built_area, built_root_area;
    uint32_t levels;  // upper bound of the levels of nodes from here down; 1: a leaf
    // Inner nodes only.
    uint32_t items;  // in the subtree
    uint32_t added;  // of these items, inserted since the subtree was built
};

constexpr uint32_t bvh_none = 0xffffffffu;
/// A reference to a node is its index, with this bit set if the node is a leaf.
constexpr uint32_t bvh_leaf_bit = 0x80000000u;
/// The largest number of levels; it bounds the stacks of queries.
constexpr int bvh_max_levels = 32;
/// The largest stack of a depth-first traversal: seven siblings a level, and eight children of the last node.
constexpr int bvh_open(int levels) { return 7 * levels + 8; }
constexpr int bvh_max_open = bvh_open(bvh_max_levels);

/// Rays of one call of a kernel.
constexpr uint32_t bvh_max_rays = 64;

}  // namespace gphys

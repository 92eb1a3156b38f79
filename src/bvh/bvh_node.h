// How an BVH lies in memory.
#pragma once

#include "bvh/box8.h"

namespace gphys {

struct alignas(64) BvhNode {
    Box8 boxes;         // lanes from count on are unused, and finite
    uint32_t child[8];  // references of nodes; in a leaf, items
    uint32_t count;     // 0: the node is free
    uint32_t parent;    // its index, bvh_none at the root; in a free node, the next free one
    uint32_t lane;      // in the parent
    // Of a leaf, to compare with: half areas of its box and of the root's when its items were chosen.
    float made_area, made_root_area;
    uint32_t levels;  // of nodes from here down, at most; 1: a leaf
    // Of nodes that are no leaves.
    uint32_t items;  // below
    uint32_t added;  // of these, since the nodes below were built
};

constexpr uint32_t bvh_none = 0xffffffffu;
/// A reference to a node is its index, with this bit set if the node is a leaf.
constexpr uint32_t bvh_leaf_bit = 0x80000000u;
/// Levels that a tree can have, which bounds the stacks of its queries.
constexpr int bvh_max_levels = 32;
/// Nodes that wait in a depth-first traversal: at most seven siblings a level, besides the children of the last.
constexpr int bvh_max_open = 7 * bvh_max_levels + 8;

/// Rays that are cast at once.
constexpr uint32_t bvh_most_rays = 64;

}  // namespace gphys

// Pairs of items of two trees whose boxes overlap, for kernels: simultaneous traversal of both trees (Gottschalk, Lin,
// Manocha, "OBBTree", 1996). Each lane of one node is tested against the eight of the other. At an item of one tree,
// the traversal continues in the other alone.
#pragma once

#include "bvh/box8_tests.h"
#include "bvh/unordered_traversal.h"

namespace gphys::GPHYS_ISA {

/// Returns false if the visitor ended it.
inline bool traverse_pairs(const BvhNode* nodes, uint32_t root, const BvhNode* other_nodes, uint32_t other_root,
                           const BvhPairVisitor& to) {
    const auto below_other = [&](uint32_t item, const BoxTest& test, uint32_t ref) {
        return traverse_unordered(
            other_nodes, ref, [&](const Box8& boxes) { return test.hits(boxes); },
            [&](const BvhNode& leaf, uint32_t lanes) {
                for (; lanes != 0; lanes &= lanes - 1) {
                    if (!to.visit(to.context, item, leaf.child[lowest_bit(lanes)])) return false;
                }
                return true;
            });
    };
    // A node, and those children of a node of the other tree that are in some lanes; without lanes, that node itself.
    struct Pairs {
        uint32_t a, b, lanes;
    };
    // Each step descends a level in the first tree, and leaves at most eight entries.
    Pairs stack[8 * bvh_max_levels + 1];
    int size = 0;
    stack[size++] = {root, other_root, 0};
    while (size > 0) {
        Pairs& top = stack[size - 1];
        Pairs pair = top;
        if (pair.lanes != 0) pair.b = node_at(other_nodes, pair.b).child[lowest_bit(pair.lanes)];
        top.lanes &= top.lanes - 1;
        if ((pair.lanes & (pair.lanes - 1)) == 0) --size;
        const BvhNode& a = node_at(nodes, pair.a);
        const BvhNode& b = node_at(other_nodes, pair.b);
        for (uint32_t i = 0; i < a.count; ++i) {
            const BoxTest test(a.boxes, i);
            if (is_leaf(pair.a)) {
                if (!below_other(a.child[i], test, pair.b)) return false;
                continue;
            }
            const uint32_t lanes = test.hits(b.boxes) & lanes_of(b);
            if (lanes != 0) stack[size++] = {a.child[i], pair.b, is_leaf(pair.b) ? 0 : lanes};
        }
    }
    return true;
}

}  // namespace gphys::GPHYS_ISA

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
    struct Pair {
        uint32_t a, b;
    };
    // Each step descends at least one level in one tree and leaves at most 63 pairs on the stack.
    Pair stack[64 * bvh_max_levels];
    int size = 0;
    stack[size++] = {root, other_root};
    while (size > 0) {
        const Pair pair = stack[--size];
        const BvhNode& a = node_at(nodes, pair.a);
        const BvhNode& b = node_at(other_nodes, pair.b);
        for (uint32_t i = 0; i < a.count; ++i) {
            const BoxTest test(a.boxes, i);
            if (is_leaf(pair.a)) {
                if (!below_other(a.child[i], test, pair.b)) return false;
                continue;
            }
            uint32_t rest = test.hits(b.boxes) & lanes_of(b);
            if (is_leaf(pair.b)) {
                if (rest != 0) stack[size++] = {a.child[i], pair.b};
            } else {
                for (; rest != 0; rest &= rest - 1) stack[size++] = {a.child[i], b.child[lowest_bit(rest)]};
            }
        }
    }
    return true;
}

}  // namespace gphys::GPHYS_ISA

// Unordered depth-first traversal by one query, for kernels: any hit of a single ray, and the items that overlap one
// box.
//
// All children are prefetched when they are pushed. The order of AnyHit (ordered_traversal.h) suits interleaved rays: a
// single ray would wait for the node that it has just chosen. Among 20,000 models a single any-hit ray takes a third
// longer in that order, at 1.02 of the instructions.
#pragma once

#include "bvh/prefetch.h"
#include "bvh/traversal_stack.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

/// hits(boxes) gives the lanes. visit(leaf, lanes) returns false to end the traversal; then the result is false.
template <class Hits, class Visit>
bool traverse_unordered(const BvhNode* nodes, uint32_t root, const Hits& hits, const Visit& visit) {
    uint32_t stack[stack_size];
    int size = 0;
    stack[size++] = root;
    while (size > 0) {
        const uint32_t ref = stack[--size];
        const BvhNode& node = node_at(nodes, ref);
        uint32_t rest = hits(node.boxes) & lanes_of(node);
        if (is_leaf(ref)) {
            if (rest != 0 && !visit(node, rest)) return false;
            continue;
        }
        for (; rest != 0; rest &= rest - 1) {
            const uint32_t child = node.child[lowest_bit(rest)];
            prefetch_range(&node_at(nodes, child), sizeof(BvhNode));
            stack[size++] = child;
        }
    }
    return true;
}

}  // namespace gphys::GPHYS_ISA

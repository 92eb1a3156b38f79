// Ordered depth-first traversal of the tree by one query, for kernels: the children of a node are visited in the order
// of their keys, and what the limit rules out is pruned.
//
// Closest hit: front to back, by where the ray enters boxes or how far they are from the point. A hit moves the limit
// to itself (branch and bound; of rays Wald et al., "Ray tracing deformable scenes using dynamic bounding volume
// hierarchies", 2007, for eight children at a time Wald, Benthin, Boulos, "Getting rid of packets", 2008; of points
// Roussopoulos, Kelley, Vincent, "Nearest neighbor queries", 1995).
//
// Any hit: the first hit ends the traversal, so the child in which the ray is longest comes first, as it is the most
// likely to have one (the greatest expected benefit: Ize and Hansen, "RTSAH traversal order for occlusion rays",
// 2011), and the others in no order, which costs less than sorting them.
//
// Either is a state machine with one step for each node or item, so that several can be interleaved
// (interleaved_traversal.h).
#pragma once

#include "bvh/box8_tests.h"
#include "bvh/prefetch.h"
#include "bvh/traversal_stack.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

class ClosestHit {
public:
    using Stack = StackEntry[stack_size];

    /// `limit` is not negative.
    void begin(uint32_t root, float limit, Stack& stack) {
        stack_ = stack;
        limit_ = limit;
        at_ = root;
        stack_[0] = sentinel;
        size_ = 1;
    }

    bool at_item() const { return is_item(at_); }
    bool at_leaf() const { return is_leaf(child_of(at_)); }
    uint32_t item() const { return child_of(at_); }
    const BvhNode& node(const BvhNode* nodes) const { return node_at(nodes, child_of(at_)); }

    /// Tests the children of the node that the traversal is at.
    template <class Test>
    void test_node(const BvhNode& here, const Test& test, NodeHits& out) const {
        Float8 keys;
        out.lanes = test.hits(here.boxes, limit_, keys) & lanes_of(here);
        store(out.keys, keys);
    }
    // Each goes on to the next node or item, and returns false at the end.
    bool leave_node(const BvhNode& here, const NodeHits& hits) {
        size_ = push_sorted(stack_, size_, here.child, hits, is_leaf(child_of(at_)));
        return next();
    }
    bool leave_item() { return next(); }
    /// A lower limit. Pruned at once: to test each entry as it is popped would be an unpredictable branch each time.
    void set_limit(float limit) {
        limit_ = limit;
        size_ = 1 + prune(limit, stack_ + 1, size_ - 1);
    }

private:
    bool next() {
        at_ = stack_[--size_];
        return at_ != sentinel;
    }

    StackEntry at_;
    float limit_;
    int size_;
    StackEntry* stack_;
};

/// For rays whose limit stays until a hit ends them.
class AnyHit {
public:
    using Stack = uint32_t[stack_size + 8];  // compress_store writes eight

    void begin(uint32_t root, float limit, Stack& stack) {
        stack_ = stack;
        limit_ = limit;
        at_ = root;
        size_ = 0;
    }

    bool at_item() const { return (at_ & item_bit) != 0; }
    uint32_t item() const { return at_ & ~item_bit; }
    const BvhNode& node(const BvhNode* nodes) const { return node_at(nodes, at_); }

    template <class Test>
    void test_node(const BvhNode& here, const Test& test, NodeHits& out) const {
        Float8 entry, exit;
        out.lanes = test.hits(here.boxes, limit_, entry, exit) & lanes_of(here);
        store(out.keys, exit - entry);
    }
    bool leave_node(const BvhNode& here, const NodeHits& hits) {
        uint32_t* const top = stack_ + size_;
        const uint32_t* const child = here.child;
        const uint32_t mark = is_leaf(at_) ? item_bit : 0;
        const uint32_t longest = longest_of(hits);
        top[compress_store(top, child, hits.lanes & ~(1u << longest), mark)] = child[longest] | mark;
        size_ += popcount(hits.lanes);
        return leave_item();
    }
    bool leave_item() {
        if (size_ == 0) return false;
        at_ = stack_[--size_];
        return true;
    }
    void set_limit(float) { size_ = 0; }

private:
    /// Of all lanes: where one that is not hit is the longest, what is stored for it lies beyond the top.
    static uint32_t longest_of(const NodeHits& hits) {
        const Float8 lengths = load(hits.keys);
        return static_cast<uint32_t>(lowest_bit(bits(greatest_lane(lengths) <= lengths)));
    }
    static constexpr uint32_t item_bit = bvh_leaf_bit >> 1;  // neither nodes nor items are ever so many

    uint32_t at_;
    float limit_;
    int size_;
    uint32_t* stack_;
};

/// The closest hit of one query alone. visit(item) returns the limit that holds from then on; a negative one ends the
/// traversal.
///
/// The items of a leaf are visited at once, nearest first, and never lie on the stack. Of the children of an inner node
/// the nearest is found without waiting for the others to be sorted, which the processor then does while it waits for
/// the memory of that child; the one after it is prefetched. prefetch_items(leaf) comes before the boxes of a leaf
/// are tested.
template <class Test, class Visit, class PrefetchItems>
void traverse_ordered(const BvhNode* nodes, uint32_t root, const Test& test, float limit, const Visit& visit,
                      const PrefetchItems& prefetch_items) {
    if (!(limit >= 0)) return;
    StackEntry stack[stack_size];
    int size = 0;
    uint32_t at = root;
    for (;;) {
        const BvhNode& here = node_at(nodes, at);
        if (is_leaf(at)) prefetch_items(here);
        Float8 keys;
        NodeHits hits;
        hits.lanes = test.hits(here.boxes, limit, keys) & lanes_of(here);
        store(hits.keys, keys);
        if (is_leaf(at)) {
            while (hits.lanes != 0) {
                const bool one = (hits.lanes & (hits.lanes - 1)) == 0;
                const uint32_t lane = one ? static_cast<uint32_t>(lowest_bit(hits.lanes)) : nearest_lane(hits);
                const float before = limit;
                limit = visit(here.child[lane]);
                hits.lanes &= ~(1u << lane);
                if (!(limit < before)) continue;
                size = prune(limit, stack, size);
                hits.lanes &= bits(keys <= splat(limit));
            }
        } else if ((hits.lanes & (hits.lanes - 1)) != 0) {
            at = here.child[nearest_lane(hits)];
            size = push_sorted(stack, size, here.child, hits, false) - 1;
            prefetch_range(&node_at(nodes, child_of(stack[size - 1])), sizeof(BvhNode));
            continue;
        } else if (hits.lanes != 0) {
            at = here.child[lowest_bit(hits.lanes)];
            continue;
        }
        if (size == 0) return;
        at = child_of(stack[--size]);
    }
}

}  // namespace gphys::GPHYS_ISA

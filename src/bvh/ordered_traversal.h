// Ordered depth-first traversal of the tree by one query, for kernels: children are visited in the order of their keys,
// and pruned by the limit.
//
// Closest hit: front to back; the key is the entry of the ray into the box, or the distance of the box from the point.
// A hit lowers the limit (branch and bound). Rays: Wald et al., "Ray tracing deformable scenes using dynamic bounding
// volume hierarchies", 2007; eight children at a time: Wald, Benthin, Boulos, "Getting rid of packets", 2008. Points:
// Roussopoulos, Kelley, Vincent, "Nearest neighbor queries", 1995.
//
// Any hit: the first hit ends the traversal. The child that contains the longest part of the ray comes first, as it is
// the most likely to give a hit (Ize and Hansen, "RTSAH traversal order for occlusion rays", 2011). The others are not
// sorted, which would cost more.
//
// Each of these two classes is a state machine with one step for each node or item, so that many can be interleaved
// (interleaved_traversal.h). traverse_ordered is the closest hit of a single query, without interleaving.
#pragma once

#include "bvh/box8_tests.h"
#include "bvh/prefetch.h"
#include "bvh/traversal_stack.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

class ClosestHit {
public:
    using Entry = StackEntry;
    /// The memory for so many entries.
    static constexpr int room_for(int entries) { return 1 + entries + stack_slack; }

    /// `limit` is not negative.
    void begin(uint32_t root, float limit, Entry* stack) {
        stack_ = stack;
        limit_ = limit;
        at_ = root;
        stack_[0] = sentinel;
        size_ = 1;
    }

    bool at_item() const { return is_item(at_); }
    uint32_t item() const { return child_of(at_); }
    const BvhNode& node(const BvhNode* nodes) const { return node_at(nodes, child_of(at_)); }

    /// Tests the children of the node that the traversal is at.
    template <class Test>
    void test_node(const BvhNode& here, const Test& test, NodeHits& out) const {
        Float8 keys;
        out.lanes = test.hits(here.boxes, limit_, keys) & lanes_of(here);
        store(out.keys, keys);
    }
    // Each moves to the next node or item, and returns false at the end. leave_node does so, too, if there are more
    // than `most` entries: then the traversal is not complete, and cannot go on.
    bool leave_node(const BvhNode& here, const NodeHits& hits, int most) {
        size_ = push_sorted(stack_, size_, here.child, hits, is_leaf(child_of(at_)));
        const bool fits = size_ <= 1 + most;
        return next() & fits;
    }
    bool leave_item() { return next(); }
    /// After the end.
    bool is_complete() const { return size_ == 0; }
    float limit() const { return limit_; }
    /// Lowers the limit and prunes the stack at once: a test of each popped entry would be an unpredictable branch.
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

/// The limit stays the same until a hit ends the ray.
class AnyHit {
public:
    using Entry = uint32_t;
    static constexpr int room_for(int entries) { return entries + 8; }  // compress_store writes eight

    void begin(uint32_t root, float limit, Entry* stack) {
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
    bool leave_node(const BvhNode& here, const NodeHits& hits, int most) {
        uint32_t* const top = stack_ + size_;
        const uint32_t* const child = here.child;
        const uint32_t mark = is_leaf(at_) ? item_bit : 0;
        const uint32_t longest = longest_of(hits);
        top[compress_store(top, child, hits.lanes & ~(1u << longest), mark)] = child[longest] | mark;
        size_ += popcount(hits.lanes);
        const bool fits = size_ <= most;
        return leave_item() & fits;
    }
    bool is_complete() const { return size_ == 0; }
    float limit() const { return limit_; }
    bool leave_item() {
        if (size_ == 0) return false;
        at_ = stack_[--size_];
        return true;
    }
    void set_limit(float) { size_ = 0; }

private:
    /// The lane with the greatest key. It may be a lane that is not hit: what is stored for it lies above the stack.
    static uint32_t longest_of(const NodeHits& hits) {
        const Float8 lengths = load(hits.keys);
        return static_cast<uint32_t>(lowest_bit(bits(greatest_lane(lengths) <= lengths)));
    }
    static constexpr uint32_t item_bit = bvh_leaf_bit >> 1;  // numbers of nodes and items stay below it

    uint32_t at_;
    float limit_;
    int size_;
    uint32_t* stack_;
};

/// The closest hit of a single query. visit(item) returns the new limit; a negative one ends the traversal.
///
/// The items of a leaf are visited at once, nearest first; they are never on the stack. In an inner node, the nearest
/// child is found before the others are sorted: so the processor sorts while it waits for the memory of that child. The
/// second nearest child is prefetched. prefetch_items(leaf) precedes the test of a leaf's boxes.
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
                size = prune_one_by_one(limit, stack, size);
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

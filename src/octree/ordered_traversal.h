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

#include "foundation/compiler.h"
#include "octree/box8_tests.h"
#include "octree/prefetch.h"
#include "octree/traversal_stack.h"

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
    const OctreeNode& node(const OctreeNode* nodes) const { return node_at(nodes, child_of(at_)); }

    /// Tests the children of the node that the traversal is at.
    template <class Test>
    void test_node(const OctreeNode& here, const Test& test, NodeHits& out) const {
        Float8 keys;
        out.lanes = test.hits(here.boxes, limit_, keys) & lanes_of(here);
        store(out.keys, keys);
    }
    // Each goes on to the next node or item, and returns false at the end.
    bool leave_node(const OctreeNode& here, const NodeHits& hits) {
        size_ = push_sorted(stack_, size_, here.child, hits, is_leaf(child_of(at_)));
        return next();
    }
    /// The same for a traversal that is not interleaved, in less time: the next child is found without waiting for the
    /// others to be sorted, which the processor then does while it waits for the memory of that child.
    bool leave_node_at_once(const OctreeNode& here, const NodeHits& hits) {
        const bool leaf = is_leaf(child_of(at_));
        if ((hits.lanes & (hits.lanes - 1)) == 0) {
            if (hits.lanes == 0) return next();
            at_ = uint64_t{leaf ? item_mark : 0} << 32 | here.child[lowest_bit(hits.lanes)];
            return true;
        }
        const uint32_t nearest = here.child[nearest_lane(hits)];
        const StackEntry direct = uint64_t{leaf ? item_mark : 0} << 32 | nearest, top = stack_[size_ - 1];
        at_ = hits.lanes != 0 ? direct : top;
        size_ = push_sorted(stack_, size_, here.child, hits, leaf) - 1;
        return at_ != sentinel;
    }
    bool leave_item() { return next(); }
    /// What comes after the node or item that the traversal is at.
    uint32_t next_on_stack() const { return child_of(stack_[size_ - 1]); }
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
    const OctreeNode& node(const OctreeNode* nodes) const { return node_at(nodes, at_); }

    template <class Test>
    void test_node(const OctreeNode& here, const Test& test, NodeHits& out) const {
        Float8 entry, exit;
        out.lanes = test.hits(here.boxes, limit_, entry, exit) & lanes_of(here);
        store(out.keys, exit - entry);
    }
    bool leave_node(const OctreeNode& here, const NodeHits& hits) {
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
    static constexpr uint32_t item_bit = octree_leaf_bit >> 1;  // neither nodes nor items are ever so many

    uint32_t at_;
    float limit_;
    int size_;
    uint32_t* stack_;
};

/// The closest hit of one query alone. visit(item) returns the limit that holds from then on; a negative one ends the
/// traversal. What is needed soon is prefetched: of an inner node the child after the next, of a leaf what
/// prefetch_items(leaf) does, before its boxes are tested.
template <class Test, class Visit, class PrefetchItems>
void traverse_ordered(const OctreeNode* nodes, uint32_t root, const Test& test, float limit, const Visit& visit,
                      const PrefetchItems& prefetch_items) {
    if (!(limit >= 0)) return;
    ClosestHit::Stack stack;
    ClosestHit traversal;
    traversal.begin(root, limit, stack);
    NodeHits hits;
    bool goes_on;
    do {
        if (traversal.at_item()) {
            const float before = limit;
            limit = visit(traversal.item());
            if (limit < before) traversal.set_limit(limit);
            goes_on = traversal.leave_item();
        } else {
            const OctreeNode& here = traversal.node(nodes);
            const bool leaf = traversal.at_leaf();
            if (leaf) prefetch_items(here);
            traversal.test_node(here, test, hits);
            goes_on = traversal.leave_node_at_once(here, hits);
            if (goes_on && !leaf) prefetch_range(&node_at(nodes, traversal.next_on_stack()), sizeof(OctreeNode));
        }
    } while (goes_on);
}

}  // namespace gphys::GPHYS_ISA

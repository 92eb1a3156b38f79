// Overlap queries, for kernels: all items whose boxes overlap a box, a ball or a frustum, in no order. The subtree of a
// child that lies wholly inside the query is listed without tests (hierarchical culling, Clark 1976). Three traversals
// differ in how they store pending nodes:
//
// - traverse_overlap, for a box or a ball: a queue, which gives prefetches time to complete. With the stacks of
//   traverse_frustum, a query of some ten nodes takes 1.2 to 1.3 times as long.
// - traverse_frustum: stacks. Each node has the mask of the planes that it is not wholly inside of; its children are
//   tested against these planes only (Assarsson and Möller, "Optimized view frustum culling algorithms for bounding
//   boxes", 2000).
// - traverse_overlaps, for several boxes or balls: all queries level by level (breadth first).
#pragma once

#include "bvh/box8_tests.h"
#include "bvh/prefetch.h"
#include "bvh/traversal_stack.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

/// Stacks of pending nodes, each with a mark: one of inner nodes, one of leaves. Nodes of one kind are visited in a
/// row, since a branch on the kind of the next node is unpredictable. `read_from`: offset of what the traversal reads
/// of a node.
template <size_t read_from = 0>
class PendingNodes {
public:
    explicit PendingNodes(const BvhNode* nodes) : nodes_(nodes) {}

    struct Entry {
        const BvhNode& node;
        uint32_t mark;
    };
    bool empty() const { return inner_.size == 0 && leaves_.size == 0; }
    bool leaf_is_next() const { return inner_.size == 0 || leaves_.size > many_leaves; }
    bool has_leaf() const { return leaves_.size != 0; }
    Entry pop_inner() { return inner_.pop(nodes_); }
    Entry pop_leaf() { return leaves_.pop(nodes_); }

    void push_root(uint32_t root, uint32_t mark) {
        const uint32_t roots[8] = {root}, marks[8] = {mark};
        is_leaf(root) ? leaves_.push(nodes_, roots, 1, marks) : inner_.push(nodes_, roots, 1, marks);
    }
    /// Pushes some lanes of an inner node. marks[lane] for all lanes.
    void push(const BvhNode& node, uint32_t lanes, const uint32_t marks[8]) {
        const uint32_t leaf_lanes = bits(signs(load(reinterpret_cast<const float*>(node.child))));
        inner_.push(nodes_, node.child, lanes & ~leaf_lanes, marks);
        leaves_.push(nodes_, node.child, lanes & leaf_lanes, marks);
    }

private:
    template <uint32_t capacity>
    struct List {
        uint32_t size = 0;
        uint32_t refs[capacity + 8], marks[capacity + 8];

        Entry pop(const BvhNode* nodes) {
            --size;
            return {node_at(nodes, refs[size]), marks[size]};
        }
        void push(const BvhNode* nodes, const uint32_t children[8], uint32_t lanes, const uint32_t all_marks[8]) {
            if (lanes == 0) return;
            const uint32_t count = compress_store(refs + size, children, lanes);
            compress_store(marks + size, all_marks, lanes);
            prefetch_nodes<read_from>(nodes, refs + size, count);
            size += count;
        }
    };
    static constexpr uint32_t many_leaves = 32;

    const BvhNode* nodes_;
    List<stack_size> inner_;
    List<many_leaves + 8> leaves_;
};

/// Buffers items between their prefetch and the visitor, so that the prefetch of the first has completed.
class ItemBuffer {
public:
    explicit ItemBuffer(const BvhListVisitor& to) : open_(to, to.items, false), inside_(to, to.items_inside, true) {}

    // Each returns whether to go on.

    /// Some lanes of a leaf; `inside`: the lanes wholly inside the query.
    bool add(const uint32_t children[8], uint32_t lanes) { return open_.add(children, lanes); }
    bool add(const uint32_t children[8], uint32_t lanes, uint32_t inside) {
        return open_.add(children, lanes & ~inside) && inside_.add(children, inside);
    }
    /// All items below some lanes of an inner node; the lanes are wholly inside the query.
    bool add_subtrees(const BvhNode* nodes, const BvhNode& node, uint32_t lanes) {
        constexpr uint32_t unmarked[8] = {};
        PendingNodes<offsetof(BvhNode, child)> below(nodes);  // boxes are not read
        below.push(node, lanes, unmarked);
        while (!below.empty()) {
            while (!below.leaf_is_next()) {
                const BvhNode& inner = below.pop_inner().node;
                below.push(inner, lanes_of(inner), unmarked);
            }
            while (below.has_leaf()) {
                const BvhNode& leaf = below.pop_leaf().node;
                if (!inside_.add(leaf.child, lanes_of(leaf))) return false;
            }
        }
        return true;
    }
    bool flush() { return open_.flush() && inside_.flush(); }

private:
    class List {
    public:
        List(const BvhListVisitor& to, const ItemMemory& memory, bool inside)
            : to_(to), memory_(memory), inside_(inside) {}

        bool add(const uint32_t children[8], uint32_t lanes) {
            if (count_ > capacity - 8 && !flush()) return false;
            const uint32_t added = compress_store(items_ + count_, children, lanes);
            prefetch_few(memory_, items_ + count_, added);
            count_ += added;
            return true;
        }
        bool flush() {
            const uint32_t count = count_;
            count_ = 0;
            return count == 0 || to_.visit(to_.context, items_, count, inside_);
        }

    private:
        static constexpr uint32_t capacity = 64;

        const BvhListVisitor& to_;
        const ItemMemory memory_;
        const bool inside_;
        uint32_t count_ = 0;
        uint32_t items_[capacity];
    };

    List open_, inside_;
};

/// Pending nodes. While they are few: first in, first out, so that prefetches have time to complete. Else last in,
/// first out, which bounds their number.
class NodeQueue {
public:
    explicit NodeQueue(uint32_t root) : size_(1) { refs_[0] = root; }

    bool empty() const { return size_ == 0; }
    uint32_t pop() {
        const uint32_t at = size_ > few ? first_ + size_ - 1 : first_++;
        --size_;
        return refs_[at % capacity];
    }
    /// Pushes and prefetches some lanes of a node.
    void push(const BvhNode* nodes, const BvhNode& node, uint32_t lanes) {
        const uint32_t first = (first_ + size_) % capacity, count = compress_store(refs_ + first, node.child, lanes);
        prefetch_nodes(nodes, refs_ + first, count);
        for (uint32_t i = capacity; i < first + count; ++i) refs_[i - capacity] = refs_[i];  // wraps around
        size_ += count;
    }

private:
    static constexpr uint32_t few = 64, capacity = 512;
    static_assert(capacity >= few + stack_size);

    uint32_t first_ = 0, size_;
    uint32_t refs_[capacity + 8];
};

/// test.hits(boxes, inside) gives the lanes that overlap the query; `inside`: lanes wholly inside it. Returns false if
/// the visitor ended the query.
template <class Test>
bool traverse_overlap(const BvhNode* nodes, uint32_t root, const Test& test, const BvhListVisitor& to) {
    ItemBuffer items(to);
    NodeQueue pending(root);
    while (!pending.empty()) {
        const uint32_t ref = pending.pop();
        const BvhNode& node = node_at(nodes, ref);
        uint32_t inside;
        const uint32_t hits = test.hits(node.boxes, inside) & lanes_of(node);
        inside &= hits;
        if (is_leaf(ref)) {
            if (!items.add(node.child, hits, inside)) return false;
            continue;
        }
        pending.push(nodes, node, hits & ~inside);
        if (inside != 0 && !items.add_subtrees(nodes, node, inside)) return false;
    }
    return items.flush();
}

/// A node whose mask has no planes left is wholly inside.
inline bool traverse_frustum(const BvhNode* nodes, uint32_t root, const FrustumProbe& probe, const BvhListVisitor& to) {
    const FrustumTest test(probe);
    const BoxTest around(probe.around);
    ItemBuffer items(to);
    PendingNodes pending(nodes);
    pending.push_root(root, FrustumTest::all_planes);
    uint32_t inside, planes[8];  // of the last tested node: lanes wholly inside, and the planes of each lane
    const auto test_node = [&](const BvhNode& node, uint32_t planes_of_node) {
        Float8 crossed;
        const uint32_t hits = lanes_of(node) & around.hits(node.boxes) & test.hits(node.boxes, planes_of_node, crossed);
        inside = hits & bits(crossed <= splat(0));
        const Float8 sets = integer_bits(crossed);
        std::memcpy(planes, &sets, sizeof planes);
        return hits;
    };
    while (!pending.empty()) {
        while (!pending.leaf_is_next()) {
            const auto [node, planes_of_node] = pending.pop_inner();
            const uint32_t hits = test_node(node, planes_of_node);
            pending.push(node, hits & ~inside, planes);
            if (inside != 0 && !items.add_subtrees(nodes, node, inside)) return false;
        }
        while (pending.has_leaf()) {
            const auto [leaf, planes_of_leaf] = pending.pop_leaf();
            if (to.needs_inside) {
                const uint32_t hits = test_node(leaf, planes_of_leaf);
                if (!items.add(leaf.child, hits, inside)) return false;
            } else {
                const uint32_t hits = around.hits(leaf.boxes) & test.hits(leaf.boxes, planes_of_leaf);
                if (!items.add(leaf.child, hits & lanes_of(leaf))) return false;
            }
        }
    }
    return items.flush();
}

/// Several small queries, interleaved level by level: the next nodes of one query are prefetched while the others are
/// tested. hits_of(query, boxes, inside) is the test. `found` was cleared.
template <class Hits>
void traverse_overlaps(const BvhNode* nodes, uint32_t root, uint32_t count, const Hits& hits_of,
                       const ItemMemory& items, const ItemMemory& items_inside, OverlapItems* found) {
    constexpr uint32_t room = OverlapItems::max_queries * OverlapItems::max_nodes + 8;
    uint32_t refs[room], query_of[room], nodes_of[OverlapItems::max_queries] = {}, size = 0;
    for (uint32_t query = 0; query < count; ++query) {
        refs[size] = root;
        query_of[size++] = query;
    }
    const auto add = [](OverlapItems& here, const BvhNode& leaf, uint32_t lanes, bool inside) {
        here.count[inside] += compress_store(here.items[inside] + here.count[inside], leaf.child, lanes);
        here.complete = here.complete && here.count[inside] <= OverlapItems::capacity;
    };
    // Prefetches nodes in the order of visits: one for each visited node, one more for each that adds nodes. So no
    // branch depends on the number of nodes, and the prefetches stay well ahead.
    uint32_t prefetched = size;
    const auto prefetch_next = [&]() GPHYS_INLINE_LAMBDA {
        prefetch_range(&node_at(nodes, refs[std::min(prefetched, size - 1)]), sizeof(BvhNode));
        prefetched += prefetched < size;
    };
    for (uint32_t next = 0; next < size; ++next) {
        prefetch_next();
        const uint32_t ref = refs[next], query = query_of[next];
        OverlapItems& here = found[query];
        if (!here.complete) continue;
        const BvhNode& node = node_at(nodes, ref);
        uint32_t inside;
        const uint32_t hits = hits_of(query, node.boxes, inside) & lanes_of(node);
        inside &= hits;
        if (is_leaf(ref)) {
            add(here, node, hits & ~inside, false);
            add(here, node, inside, true);
        } else if (nodes_of[query] + 9 > OverlapItems::max_nodes) {
            here.complete = false;
        } else {
            const uint32_t added = compress_store(refs + size, node.child, hits);
            nodes_of[query] += added;
            std::fill_n(query_of + size, 8, query);
            size += added;
            prefetch_next();
        }
    }
    for (uint32_t query = 0; query < count; ++query) {
        prefetch_many(items, found[query].items[0], found[query].count[0]);
        prefetch_many(items_inside, found[query].items[1], found[query].count[1]);
    }
}

}  // namespace gphys::GPHYS_ISA

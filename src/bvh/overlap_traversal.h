// Overlap queries, for kernels: all items whose boxes touch a box, a ball or a frustum, in no order. A child that lies
// wholly inside the query needs no test below it: its subtree is listed (hierarchical culling, Clark 1976). There are
// three, which differ in what they keep of the nodes that are still to be visited:
//
// - traverse_overlap, for a box or a ball: a queue, so that what was prefetched has come. In the lists of
//   traverse_frustum, which are stacks, a query of some ten nodes takes 1.2 to 1.3 times as long.
// - traverse_frustum: with each node the planes that it is not wholly inside of, which are all that its children are
//   tested against (plane masks: Assarsson and Möller, "Optimized view frustum culling algorithms for bounding boxes",
//   2000).
// - traverse_overlaps, for several boxes or balls: all of them level by level (breadth first).
#pragma once

#include "bvh/box8_tests.h"
#include "bvh/prefetch.h"
#include "bvh/traversal_stack.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

/// Nodes that are to be visited, in no order, each with a mark. Inner nodes and leaves are apart, and each are visited
/// many in a row, as which of the two comes next is unpredictable. `read_from`: what is read of a node begins there.
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
    Entry take_inner() { return inner_.take(nodes_); }
    Entry take_leaf() { return leaves_.take(nodes_); }

    void push_root(uint32_t root, uint32_t mark) {
        const uint32_t roots[8] = {root}, marks[8] = {mark};
        is_leaf(root) ? leaves_.push(nodes_, roots, 1, marks) : inner_.push(nodes_, roots, 1, marks);
    }
    /// Some lanes of an inner node, with the marks of all.
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

        Entry take(const BvhNode* nodes) {
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

/// Items on their way to the visitor. They are kept back until what it reads of the first has come from memory.
class ItemBuffer {
public:
    explicit ItemBuffer(const BvhListVisitor& to) : open_(to, to.items, false), inside_(to, to.items_inside, true) {}

    // Each returns whether to go on.

    /// Some lanes of a leaf, of which some lie inside the query.
    bool add(const uint32_t children[8], uint32_t lanes) { return open_.add(children, lanes); }
    bool add(const uint32_t children[8], uint32_t lanes, uint32_t inside) {
        return open_.add(children, lanes & ~inside) && inside_.add(children, inside);
    }
    /// All items below some lanes of an inner node, which lie inside the query.
    bool add_subtrees(const BvhNode* nodes, const BvhNode& node, uint32_t lanes) {
        constexpr uint32_t unmarked[8] = {};
        PendingNodes<offsetof(BvhNode, child)> below(nodes);  // whose boxes need not be read
        below.push(node, lanes, unmarked);
        while (!below.empty()) {
            while (!below.leaf_is_next()) {
                const BvhNode& inner = below.take_inner().node;
                below.push(inner, lanes_of(inner), unmarked);
            }
            while (below.has_leaf()) {
                const BvhNode& leaf = below.take_leaf().node;
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

/// Nodes that are to be visited: the oldest first while they are few, so that what was prefetched has come; else the
/// youngest first, so that they do not become many.
class NodeQueue {
public:
    explicit NodeQueue(uint32_t root) : size_(1) { refs_[0] = root; }

    bool empty() const { return size_ == 0; }
    uint32_t take() {
        const uint32_t at = size_ > few ? first_ + size_ - 1 : first_++;
        --size_;
        return refs_[at % capacity];
    }
    /// Some lanes of a node, which are prefetched.
    void push(const BvhNode* nodes, const BvhNode& node, uint32_t lanes) {
        const uint32_t first = (first_ + size_) % capacity, count = compress_store(refs_ + first, node.child, lanes);
        prefetch_nodes(nodes, refs_ + first, count);
        for (uint32_t i = capacity; i < first + count; ++i) refs_[i - capacity] = refs_[i];  // around the end
        size_ += count;
    }

private:
    static constexpr uint32_t few = 64, capacity = 512;
    static_assert(capacity >= few + stack_size);

    uint32_t first_ = 0, size_;
    uint32_t refs_[capacity + 8];
};

/// test.hits(boxes, inside) gives the lanes that the query touches, and of these the ones that lie wholly inside it.
/// False if the visitor ended it.
template <class Test>
bool traverse_overlap(const BvhNode* nodes, uint32_t root, const Test& test, const BvhListVisitor& to) {
    ItemBuffer items(to);
    NodeQueue pending(root);
    while (!pending.empty()) {
        const uint32_t ref = pending.take();
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

/// When no plane is left that a node is not wholly inside of, its subtree is inside.
inline bool traverse_frustum(const BvhNode* nodes, uint32_t root, const FrustumProbe& probe, const BvhListVisitor& to) {
    const FrustumTest test(probe);
    const BoxTest around(probe.around);
    ItemBuffer items(to);
    PendingNodes pending(nodes);
    pending.push_root(root, FrustumTest::all_planes);
    uint32_t inside, planes[8];  // lanes that are inside, and the planes of the others
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
            const auto [node, planes_of_node] = pending.take_inner();
            const uint32_t hits = test_node(node, planes_of_node);
            pending.push(node, hits & ~inside, planes);
            if (inside != 0 && !items.add_subtrees(nodes, node, inside)) return false;
        }
        while (pending.has_leaf()) {
            const auto [leaf, planes_of_leaf] = pending.take_leaf();
            if (to.asks_inside) {
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

/// For several queries that touch few nodes and items, hits_of(query, boxes, inside), interleaved: level by level, so
/// that what one query needs next is prefetched while the others are at work. `found` is
/// cleared.
template <class Hits>
void traverse_overlaps(const BvhNode* nodes, uint32_t root, uint32_t count, const Hits& hits_of,
                       const ItemMemory& items, const ItemMemory& items_inside, OverlapItems* found) {
    constexpr uint32_t room = OverlapItems::most_queries * OverlapItems::most_nodes + 8;
    uint32_t refs[room], query_of[room], nodes_of[OverlapItems::most_queries] = {}, size = 0;
    for (uint32_t query = 0; query < count; ++query) {
        refs[size] = root;
        query_of[size++] = query;
    }
    const auto add = [](OverlapItems& here, const BvhNode& leaf, uint32_t lanes, bool inside) {
        here.count[inside] += compress_store(here.items[inside] + here.count[inside], leaf.child, lanes);
        here.complete = here.complete && here.count[inside] <= OverlapItems::capacity;
    };
    // Nodes are prefetched in the order of their visits, one for each that is visited and another for each that adds
    // some: no branch depends on how many those are, and it is well ahead.
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
        } else if (nodes_of[query] + 9 > OverlapItems::most_nodes) {
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

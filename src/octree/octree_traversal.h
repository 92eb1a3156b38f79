// Walks through an octree, for kernels. Stacks are fixed arrays; nothing allocates.
#pragma once

#include "octree/box8_tests.h"
#include "octree/keyed_child.h"
#include "octree/octree_kernels.h"

namespace gphys::GPHYS_ISA {

inline void fetch_ahead(const void* memory, uint32_t size) {
    for (uint32_t byte = 0; byte < size; byte += 64) __builtin_prefetch(static_cast<const char*>(memory) + byte);
}

inline void fetch_item(const ItemMemory& items, uint32_t item) {
    // Mostly of one line; what is fetched of no memory does no harm.
    const char* first = static_cast<const char*>(items.first) + size_t{item} * items.size;
    __builtin_prefetch(first);
    if (items.size > 64) fetch_ahead(first + 64, items.size - 64);
}

/// A walk that goes best first within each node and drops what lies behind the limit, which its
/// visits may move. It is at one node or item at a time, so that several walks can take turns.
class NearestFirst {
public:
    using Stack = KeyedChild[stack_size];

    /// `limit` is not negative.
    void begin(uint32_t root, float limit, Stack& stack) {
        stack_ = stack;
        limit_ = limit;
        at_ = root;
        stack_[0] = bottom;
        size_ = 1;
    }

    bool at_item() const { return is_item(at_); }
    uint32_t item() const { return child_of(at_); }
    const OctreeNode& node(const OctreeNode* nodes) const { return node_at(nodes, child_of(at_)); }

    /// What there is in the node that the walk is at.
    template <class Test>
    void look(const OctreeNode* nodes, const Test& test, Found& found) const {
        const OctreeNode& here = node(nodes);
        Float8 keys;
        found.hits = test.hits(here.boxes, limit_, keys) & lanes_of(here);
        store(found.keys, keys);
    }
    /// Go on from a node, or else the item that has been visited. False at the end.
    bool leave_node(const OctreeNode* nodes, const Found& found) {
        const uint32_t ref = child_of(at_);
        size_ = push_nearest_last(stack_, size_, node_at(nodes, ref).child, found, is_leaf(ref));
        return next();
    }
    void set_limit(float limit) { limit_ = limit; }
    bool leave_item() { return next(); }

private:
    bool next() {
        do {
            at_ = stack_[--size_];
        } while (!(key_of(at_) <= limit_));
        return at_ != bottom;
    }

    KeyedChild at_;
    float limit_;
    int size_;
    KeyedChild* stack_;
};

template <class Test, class Visit>
void nearest_first(const OctreeNode* nodes, uint32_t root, const Test& test, float limit, const Visit& visit) {
    if (!(limit >= 0)) return;
    NearestFirst::Stack stack;
    NearestFirst walk;
    walk.begin(root, limit, stack);
    Found found;
    bool goes_on;
    do {
        if (walk.at_item()) {
            walk.set_limit(visit(walk.item()));
            goes_on = walk.leave_item();
        } else {
            walk.look(nodes, test, found);
            goes_on = walk.leave_node(nodes, found);
        }
    } while (goes_on);
}

/// Depth first through the lanes that hits(boxes) finds. visit(leaf, lanes) returns whether to go on.
template <class Hits, class Visit>
bool everywhere(const OctreeNode* nodes, uint32_t root, const Hits& hits, const Visit& visit) {
    uint32_t stack[stack_size];
    int size = 0;
    stack[size++] = root;
    while (size > 0) {
        const uint32_t ref = stack[--size];
        const OctreeNode& node = node_at(nodes, ref);
        uint32_t rest = hits(node.boxes) & lanes_of(node);
        if (is_leaf(ref)) {
            if (rest != 0 && !visit(node, rest)) return false;
            continue;
        }
        for (; rest != 0; rest &= rest - 1) {
            const uint32_t child = node.child[__builtin_ctz(rest)];
            fetch_ahead(&node_at(nodes, child), sizeof(OctreeNode));
            stack[size++] = child;
        }
    }
    return true;
}

/// Items that a walk without order has found. They are kept back for a while, until what a visit
/// reads of the first has come from memory.
class FoundItems {
public:
    explicit FoundItems(const OctreeListVisitor& to) : open_(to, to.items, false), inside_(to, to.items_inside, true) {}

    // Each returns whether to go on.

    /// Some `lanes` of a leaf, of which some are inside the query.
    bool add(const uint32_t children[8], uint32_t lanes, uint32_t inside) {
        return open_.add(children, lanes & ~inside) && inside_.add(children, inside);
    }
    /// All items below some `lanes` of an inner node, which are inside the query.
    bool add_below(const OctreeNode* nodes, const OctreeNode& node, uint32_t lanes) {
        uint32_t stack[stack_size];
        int size = push_below(nodes, node, lanes, stack, 0);
        while (size > 0) {
            const uint32_t ref = stack[--size];
            const OctreeNode& below = node_at(nodes, ref);
            if (!is_leaf(ref)) {
                size = push_below(nodes, below, lanes_of(below), stack, size);
            } else if (!inside_.add(below.child, lanes_of(below))) {
                return false;
            }
        }
        return true;
    }
    bool finish() { return open_.pass_on() && inside_.pass_on(); }

private:
    class List {
    public:
        List(const OctreeListVisitor& to, const ItemMemory& memory, bool inside)
            : to_(to), memory_(memory), inside_(inside) {}

        bool add(const uint32_t children[8], uint32_t lanes) {
            if (count_ > capacity - 8 && !pass_on()) return false;
            const uint32_t first = count_;
            count_ += take_lanes(items_ + first, children, lanes);
            // Mostly there are at most two; a loop that ran as often as there are would surprise the processor.
            fetch_item(memory_, items_[first]);
            fetch_item(memory_, items_[first + 1]);
            for (uint32_t i = first + 2; i < count_; ++i) fetch_item(memory_, items_[i]);
            return true;
        }
        bool pass_on() {
            const uint32_t count = count_;
            count_ = 0;
            return count == 0 || to_.visit(to_.context, items_, count, inside_);
        }

    private:
        static constexpr uint32_t capacity = 64;

        const OctreeListVisitor& to_;
        const ItemMemory memory_;
        const bool inside_;
        uint32_t count_ = 0;
        uint32_t items_[capacity];
    };

    /// Of a node wholly inside only the children are read, not their boxes.
    static int push_below(const OctreeNode* nodes, const OctreeNode& node, uint32_t lanes, uint32_t* stack, int size) {
        for (; lanes != 0; lanes &= lanes - 1) {
            const uint32_t child = node.child[__builtin_ctz(lanes)];
            fetch_ahead(node_at(nodes, child).child, 1);
            stack[size++] = child;
        }
        return size;
    }

    List open_, inside_;
};

/// Nodes to be visited: the oldest first while they are few, so that what was fetched ahead has come;
/// else the youngest first, so that they do not become many.
class Frontier {
public:
    explicit Frontier(uint32_t root) : size_(1) { refs_[0] = root; }

    bool empty() const { return size_ == 0; }
    uint32_t take() {
        const uint32_t at = size_ > few ? first_ + size_ - 1 : first_++;
        --size_;
        return refs_[at % capacity];
    }
    /// Some lanes of a node, which are fetched.
    void push(const OctreeNode* nodes, const OctreeNode& node, uint32_t lanes) {
        const uint32_t first = (first_ + size_) % capacity, count = take_lanes(refs_ + first, node.child, lanes);
        for (uint32_t i = 0; i < often; ++i) {
            fetch_ahead(&node_at(nodes, refs_[first + (i < count ? i : 0)]), sizeof(OctreeNode));
        }
        for (uint32_t i = often; i < count; ++i) fetch_ahead(&node_at(nodes, refs_[first + i]), sizeof(OctreeNode));
        for (uint32_t i = capacity; i < first + count; ++i) refs_[i - capacity] = refs_[i];  // around the end
        size_ += count;
    }

private:
    /// Mostly no more are pushed at once. As above, the processor is to foresee how often loops run.
    static constexpr uint32_t often = 4;
    static constexpr uint32_t few = 64, capacity = 512;
    static_assert(capacity >= few + stack_size);

    uint32_t first_ = 0, size_;
    uint32_t refs_[capacity + 8];
};

/// All items that hits_of(boxes, inside) finds in leaves, of which some are wholly inside the query.
template <class Hits>
bool everything_met(const OctreeNode* nodes, uint32_t root, const Hits& hits_of, const OctreeListVisitor& to) {
    FoundItems found(to);
    Frontier frontier(root);
    while (!frontier.empty()) {
        const uint32_t ref = frontier.take();
        const OctreeNode& node = node_at(nodes, ref);
        uint32_t inside;
        const uint32_t hits = hits_of(node.boxes, inside) & lanes_of(node);
        inside &= hits;
        if (is_leaf(ref)) {
            if (!found.add(node.child, hits, inside)) return false;
            continue;
        }
        frontier.push(nodes, node, hits & ~inside);
        if (inside != 0 && !found.add_below(nodes, node, inside)) return false;
    }
    return found.finish();
}

}  // namespace gphys::GPHYS_ISA

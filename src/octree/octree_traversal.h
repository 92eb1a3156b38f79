// Walks through an octree, for kernels. Stacks are fixed arrays; nothing allocates.
#pragma once

#include "octree/box8_tests.h"
#include "octree/keyed_child.h"
#include "octree/octree_kernels.h"

namespace gphys::GPHYS_ISA {

// Inlined always: gcc takes a function that only fetches for one without effect, and leaves out its calls.
[[gnu::always_inline]] inline void fetch_ahead(const void* memory, uint32_t size) {
    for (uint32_t byte = 0; byte < size; byte += 64) __builtin_prefetch(static_cast<const char*>(memory) + byte);
}

[[gnu::always_inline]] inline void fetch_item(const ItemMemory& items, uint32_t item) {
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
    void look(const OctreeNode& here, const Test& test, Found& found) const {
        Float8 keys;
        found.hits = test.hits(here.boxes, limit_, keys) & lanes_of(here);
        store(found.keys, keys);
    }
    /// Go on from a node, or else the item that has been visited. False at the end.
    bool leave_node(const OctreeNode& here, const Found& found) {
        size_ = push_nearest_last(stack_, size_, here.child, found, is_leaf(child_of(at_)));
        return next();
    }
    /// A nearer one. What lies behind it is dropped at once: how much of that there is on top could not be
    /// foreseen each time that something is taken from there.
    void set_limit(float limit) {
        limit_ = limit;
        size_ = 1 + keep_up_to(limit, stack_ + 1, size_ - 1);
    }
    bool leave_item() { return next(); }

private:
    bool next() {
        at_ = stack_[--size_];
        return at_ != bottom;
    }

    KeyedChild at_;
    float limit_;
    int size_;
    KeyedChild* stack_;
};

/// The same for walks whose limit stays until it ends them: first where the ray is longest, as something is met there
/// most likely; the others in no order.
class LongestFirst {
public:
    using Stack = uint32_t[stack_size + 8];  // take_lanes writes eight

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
    void look(const OctreeNode& here, const Test& test, Found& found) const {
        Float8 entry, exit;
        found.hits = test.hits(here.boxes, limit_, entry, exit) & lanes_of(here);
        store(found.keys, exit - entry);
    }
    bool leave_node(const OctreeNode& here, const Found& found) {
        uint32_t* const top = stack_ + size_;
        const uint32_t* const child = here.child;
        const uint32_t mark = is_leaf(at_) ? item_bit : 0;
        const uint32_t longest = longest_of(found);
        top[take_lanes(top, child, found.hits & ~(1u << longest), mark)] = child[longest] | mark;
        size_ += __builtin_popcount(found.hits);
        return leave_item();
    }
    void set_limit(float) { size_ = 0; }
    bool leave_item() {
        if (size_ == 0) return false;
        at_ = stack_[--size_];
        return true;
    }

private:
    /// Mostly one that was hit: where a lane that is not in use seems longer, none of the others comes first.
    static uint32_t longest_of(const Found& found) {
        const Float8 lengths = load(found.keys);
        return static_cast<uint32_t>(__builtin_ctz(bits(greatest_lane(lengths) <= lengths)));
    }
    static constexpr uint32_t item_bit = octree_leaf_bit >> 1;  // neither nodes nor items are ever so many

    uint32_t at_;
    float limit_;
    int size_;
    uint32_t* stack_;
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
            const float before = limit;
            limit = visit(walk.item());
            if (limit < before) walk.set_limit(limit);
            goes_on = walk.leave_item();
        } else {
            const OctreeNode& here = walk.node(nodes);
            walk.look(here, test, found);
            goes_on = walk.leave_node(here, found);
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

/// Fetch nodes that are to be visited, of which is read what begins at `read_from`. Mostly there are few; a loop
/// that ran as often as there are would surprise the processor.
template <size_t read_from = 0>
[[gnu::always_inline]] inline void fetch_nodes(const OctreeNode* nodes, const uint32_t* refs, uint32_t count) {
    constexpr uint32_t often = 3, size = sizeof(OctreeNode) - read_from;
    const char* const first = reinterpret_cast<const char*>(nodes) + read_from;
    const auto at = [&](uint32_t i) { return first + sizeof(OctreeNode) * size_t{refs[i] & ~octree_leaf_bit}; };
    for (uint32_t i = 0; i < often; ++i) fetch_ahead(at(i < count ? i : 0), size);
    for (uint32_t i = often; i < count; ++i) fetch_ahead(at(i), size);
}

/// Nodes to be visited in no order, each with a mark. Leaves are apart from the others and are visited many in
/// a row: which of the two comes next is not to be guessed each time.
template <size_t read_from = 0>
class NodesToVisit {
public:
    explicit NodesToVisit(const OctreeNode* nodes) : nodes_(nodes) {}

    struct Entry {
        const OctreeNode& node;
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
    void push(const OctreeNode& node, uint32_t lanes, const uint32_t marks[8]) {
        const uint32_t leaf_lanes = bits(signs(load(reinterpret_cast<const float*>(node.child))));
        inner_.push(nodes_, node.child, lanes & ~leaf_lanes, marks);
        leaves_.push(nodes_, node.child, lanes & leaf_lanes, marks);
    }

private:
    template <uint32_t capacity>
    struct List {
        uint32_t size = 0;
        uint32_t refs[capacity + 8], marks[capacity + 8];

        Entry take(const OctreeNode* nodes) {
            --size;
            return {node_at(nodes, refs[size]), marks[size]};
        }
        void push(const OctreeNode* nodes, const uint32_t children[8], uint32_t lanes, const uint32_t all_marks[8]) {
            if (lanes == 0) return;
            const uint32_t count = take_lanes(refs + size, children, lanes);
            take_lanes(marks + size, all_marks, lanes);
            fetch_nodes<read_from>(nodes, refs + size, count);
            size += count;
        }
    };
    static constexpr uint32_t many_leaves = 32;

    const OctreeNode* nodes_;
    List<stack_size> inner_;
    List<many_leaves + 8> leaves_;
};

/// Fetch what is read of items. Mostly there are at most two; a loop that ran as often as there are would surprise
/// the processor. Of `items` there are two at least, of which those beyond `count` may be any.
[[gnu::always_inline]] inline void fetch_items(const ItemMemory& memory, const uint32_t* items, uint32_t count) {
    if (memory.size == 0) return;
    fetch_item(memory, items[0]);
    fetch_item(memory, items[1]);
    for (uint32_t i = 2; i < count; ++i) fetch_item(memory, items[i]);
}

/// The same for a list of any length, four at a time: how often a loop runs is not to be foreseen.
[[gnu::always_inline]] inline void fetch_many(const ItemMemory& memory, const uint32_t* items, uint32_t count) {
    if (memory.size == 0) return;
    for (uint32_t first = 0; first < count; first += 4) {
        for (uint32_t i = first; i < first + 4; ++i) fetch_item(memory, items[i < count ? i : first]);
    }
}

/// Items that a walk without order has found. They are kept back for a while, until what a visit
/// reads of the first has come from memory.
class FoundItems {
public:
    explicit FoundItems(const OctreeListVisitor& to) : open_(to, to.items, false), inside_(to, to.items_inside, true) {}

    // Each returns whether to go on.

    /// Some `lanes` of a leaf; those of which some are inside the query.
    bool add(const uint32_t children[8], uint32_t lanes) { return open_.add(children, lanes); }
    bool add(const uint32_t children[8], uint32_t lanes, uint32_t inside) {
        return open_.add(children, lanes & ~inside) && inside_.add(children, inside);
    }
    /// All items below some `lanes` of an inner node, which are inside the query.
    bool add_below(const OctreeNode* nodes, const OctreeNode& node, uint32_t lanes) {
        constexpr uint32_t unmarked[8] = {};
        NodesToVisit<offsetof(OctreeNode, child)> below(nodes);  // whose boxes need not be read
        below.push(node, lanes, unmarked);
        while (!below.empty()) {
            while (!below.leaf_is_next()) {
                const OctreeNode& inner = below.take_inner().node;
                below.push(inner, lanes_of(inner), unmarked);
            }
            while (below.has_leaf()) {
                const OctreeNode& leaf = below.take_leaf().node;
                if (!inside_.add(leaf.child, lanes_of(leaf))) return false;
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
            const uint32_t added = take_lanes(items_ + count_, children, lanes);
            fetch_items(memory_, items_ + count_, added);
            count_ += added;
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
        fetch_nodes(nodes, refs_ + first, count);
        for (uint32_t i = capacity; i < first + count; ++i) refs_[i - capacity] = refs_[i];  // around the end
        size_ += count;
    }

private:
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

/// The same for several queries, hits_of(query, boxes, inside), which find nodes and items that are few: level by
/// level, so that what one query needs next is fetched while the others are at work. `met` is cleared.
template <class Hits>
void everything_met_by_several(const OctreeNode* nodes, uint32_t root, uint32_t count, const Hits& hits_of,
                               const ItemMemory& items, const ItemMemory& items_inside, ItemsMet* met) {
    constexpr uint32_t room = ItemsMet::most_queries * ItemsMet::most_nodes + 8;
    uint32_t refs[room], query_of[room], nodes_of[ItemsMet::most_queries] = {}, size = 0;
    for (uint32_t query = 0; query < count; ++query) {
        refs[size] = root;
        query_of[size++] = query;
    }
    const auto add = [](ItemsMet& here, const OctreeNode& leaf, uint32_t lanes, bool inside) {
        here.count[inside] += take_lanes(here.items[inside] + here.count[inside], leaf.child, lanes);
        here.complete = here.complete && here.count[inside] <= ItemsMet::capacity;
    };
    // Nodes are fetched in the order in which they will be visited, one for each that is and another for each that
    // adds some: without a branch by how many those are, and a good deal ahead.
    uint32_t fetched = size;
    const auto fetch_next = [&]() __attribute__((always_inline)) {
        fetch_ahead(&node_at(nodes, refs[std::min(fetched, size - 1)]), sizeof(OctreeNode));
        fetched += fetched < size;
    };
    for (uint32_t next = 0; next < size; ++next) {
        fetch_next();
        const uint32_t ref = refs[next], query = query_of[next];
        ItemsMet& here = met[query];
        if (!here.complete) continue;
        const OctreeNode& node = node_at(nodes, ref);
        uint32_t inside;
        const uint32_t hits = hits_of(query, node.boxes, inside) & lanes_of(node);
        inside &= hits;
        if (is_leaf(ref)) {
            add(here, node, hits & ~inside, false);
            add(here, node, inside, true);
        } else if (nodes_of[query] + 9 > ItemsMet::most_nodes) {
            here.complete = false;
        } else {
            const uint32_t added = take_lanes(refs + size, node.child, hits);
            nodes_of[query] += added;
            std::fill_n(query_of + size, 8, query);
            size += added;
            fetch_next();
        }
    }
    for (uint32_t query = 0; query < count; ++query) {
        fetch_many(items, met[query].items[0], met[query].count[0]);
        fetch_many(items_inside, met[query].items[1], met[query].count[1]);
    }
}

}  // namespace gphys::GPHYS_ISA

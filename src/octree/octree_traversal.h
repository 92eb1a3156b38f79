// Walks through an octree, for kernels. Stacks are fixed arrays; nothing allocates.
#pragma once

#include <cstring>

#include "octree/box8_tests.h"
#include "octree/octree_node.h"

namespace gphys::GPHYS_ISA {

// Each level leaves at most seven siblings on a depth-first stack.
constexpr int stack_size = 7 * octree_max_levels + 8;

inline bool is_leaf(uint32_t ref) { return (ref & octree_leaf_bit) != 0; }
inline const OctreeNode& node_at(const OctreeNode* nodes, uint32_t ref) { return nodes[ref & ~octree_leaf_bit]; }
inline uint32_t lanes_of(const OctreeNode& node) { return (1u << node.count) - 1; }

inline void fetch_ahead(const void* memory, uint32_t size) {
    for (uint32_t byte = 0; byte < size; byte += 64) __builtin_prefetch(static_cast<const char*>(memory) + byte);
}

/// A child with its distance: the bits of a float >= 0 sort like the float itself. The reference
/// below makes all entries different, so the order is the same everywhere.
using KeyedChild = uint64_t;
inline KeyedChild keyed(float key, uint32_t child) {
    uint32_t key_bits;
    std::memcpy(&key_bits, &key, sizeof key_bits);
    return uint64_t{key_bits} << 32 | child;
}
inline float key_of(KeyedChild entry) {
    const uint32_t key_bits = static_cast<uint32_t>(entry >> 32);
    float key;
    std::memcpy(&key, &key_bits, sizeof key);
    return key;
}
inline uint32_t child_of(KeyedChild entry) { return static_cast<uint32_t>(entry); }

/// Push the children of the lanes of `hits`, which is not 0, furthest first. One or two are the rule.
inline int push_nearest_last(KeyedChild* stack, int size, const uint32_t children[8], uint32_t hits, Float8 key_lanes) {
    alignas(32) float keys[8];
    store(keys, key_lanes);
    const auto take = [&] {
        const int lane = __builtin_ctz(hits);
        hits &= hits - 1;
        return keyed(keys[lane], children[lane]);
    };
    const KeyedChild first = take();
    stack[size] = first;
    if (hits == 0) return size + 1;
    const KeyedChild second = take();
    stack[size] = first < second ? second : first;
    stack[size + 1] = first < second ? first : second;
    const int base = size;
    size += 2;
    while (hits != 0) {
        const KeyedChild added = take();
        int at = size++;
        for (; at > base && stack[at - 1] < added; --at) stack[at] = stack[at - 1];
        stack[at] = added;
    }
    return size;
}

/// A walk that goes best first within each node and drops what lies behind the limit, which its
/// visits may move. It is taken in steps that end where memory is asked for, so that several walks
/// can take turns while it comes.
class NearestFirst {
public:
    /// `limit` is not negative.
    void begin(const OctreeNode* nodes, uint32_t root, float limit) {
        limit_ = limit;
        ref_ = root;
        size_ = 0;
        items_from_ = -1;
        fetch_node(nodes);
    }

    /// Whether there is another step. visit(item) returns the new limit; fetch(item) prepares for it.
    template <class Test, class Visit, class Fetch>
    bool step(const OctreeNode* nodes, const Test& test, const Visit& visit, const Fetch& fetch) {
        if (items_from_ >= 0) {
            while (size_ > items_from_) {
                const KeyedChild nearest = stack_[--size_];
                if (!(key_of(nearest) <= limit_)) {
                    size_ = items_from_;
                    break;
                }
                limit_ = visit(child_of(nearest));
            }
            items_from_ = -1;
        } else {
            const OctreeNode& node = node_at(nodes, ref_);
            Float8 keys;
            const uint32_t hits = test.hits(node.boxes, limit_, keys) & lanes_of(node);
            if (hits != 0) {
                const int base = size_;
                size_ = push_nearest_last(stack_, size_, node.child, hits, keys);
                if (is_leaf(ref_)) {
                    items_from_ = base;
                    for (int i = size_; i-- > base;) fetch(child_of(stack_[i]));
                } else {
                    ref_ = child_of(stack_[--size_]);
                    fetch_node(nodes);
                }
                return true;
            }
        }
        do {
            if (size_ == 0) return false;
            --size_;
        } while (!(key_of(stack_[size_]) <= limit_));
        ref_ = child_of(stack_[size_]);
        fetch_node(nodes);
        return true;
    }

private:
    void fetch_node(const OctreeNode* nodes) const { fetch_ahead(&node_at(nodes, ref_), sizeof(OctreeNode)); }

    float limit_;
    uint32_t ref_;
    int size_;
    int items_from_;  // where on the stack the items of a leaf begin that are to be visited, or -1
    KeyedChild stack_[stack_size];
};

template <class Test, class Visit, class Fetch>
void nearest_first(const OctreeNode* nodes, uint32_t root, const Test& test, float limit, const Visit& visit,
                   const Fetch& fetch) {
    if (!(limit >= 0)) return;
    NearestFirst walk;
    walk.begin(nodes, root, limit);
    while (walk.step(nodes, test, visit, fetch)) {
    }
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

}  // namespace gphys::GPHYS_ISA

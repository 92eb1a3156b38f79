// Walks through an octree, for kernels. Stacks are fixed arrays; nothing allocates.
#pragma once

#include "octree/box8_tests.h"
#include "octree/keyed_child.h"

namespace gphys::GPHYS_ISA {

inline void fetch_ahead(const void* memory, uint32_t size) {
    for (uint32_t byte = 0; byte < size; byte += 64) __builtin_prefetch(static_cast<const char*>(memory) + byte);
}

/// A walk that goes best first within each node and drops what lies behind the limit, which its
/// visits may move. It is at one node or item at a time, so that several walks can take turns.
class NearestFirst {
public:
    /// `limit` is not negative.
    void begin(uint32_t root, float limit) {
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
    bool leave_item(float limit) {
        limit_ = limit;
        return next();
    }

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
    KeyedChild stack_[stack_size];
};

template <class Test, class Visit>
void nearest_first(const OctreeNode* nodes, uint32_t root, const Test& test, float limit, const Visit& visit) {
    if (!(limit >= 0)) return;
    NearestFirst walk;
    walk.begin(root, limit);
    Found found;
    bool goes_on;
    do {
        if (walk.at_item()) {
            goes_on = walk.leave_item(visit(walk.item()));
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

}  // namespace gphys::GPHYS_ISA

// The traversals of octree.h. Visitors are inlined; stacks are fixed arrays; nothing allocates.
#pragma once

#include "octree/octree.h"

namespace gphys {

/// A lane of a node in the order of its key: the bits of a float >= 0 sort like the float itself.
/// The reference below makes all entries different, so the order is the same on every machine.
struct KeyedLane {
    static uint64_t make(float key, uint32_t child) {
        uint32_t key_bits;
        std::memcpy(&key_bits, &key, sizeof key_bits);
        return uint64_t{key_bits} << 32 | child;
    }
    static float key(uint64_t entry) {
        const uint32_t key_bits = static_cast<uint32_t>(entry >> 32);
        float key;
        std::memcpy(&key, &key_bits, sizeof key);
        return key;
    }
    static uint32_t child(uint64_t entry) { return static_cast<uint32_t>(entry); }
};

/// Best-first within each node: children are pushed furthest first, and dropped when popped if the
/// bound has since moved in front of them.
template <class Probe, class Visit>
void Octree::nearest_first(const Probe& probe, double bound, Visit&& visit) const {
    if (root_ == none) return;
    float limit = probe.limit(bound);
    uint64_t stack[stack_size];
    int size = 0;
    stack[size++] = KeyedLane::make(0, root_);
    while (size > 0) {
        const uint64_t entry = stack[--size];
        if (!(KeyedLane::key(entry) <= limit)) continue;
        const NodeRef ref = KeyedLane::child(entry);
        const Node& node = nodes_[index_of(ref)];
        Float8 key_lanes;
        uint32_t hits = probe.hits(node.boxes, limit, key_lanes) & node.lanes();
        alignas(32) float keys[8];
        store(keys, key_lanes);
        // Insertion sort, descending, on top of the stack: seldom more than three lanes are hit.
        const int base = size;
        for (; hits != 0; hits &= hits - 1) {
            const int lane = __builtin_ctz(hits);
            const uint64_t added = KeyedLane::make(keys[lane], node.child[lane]);
            int at = size++;
            for (; at > base && stack[at - 1] < added; --at) stack[at] = stack[at - 1];
            stack[at] = added;
        }
        if (!is_leaf(ref)) {
            for (int i = base; i < size; ++i) __builtin_prefetch(&nodes_[index_of(KeyedLane::child(stack[i]))]);
            continue;
        }
        while (size > base) {
            const uint64_t nearest = stack[--size];
            if (!(KeyedLane::key(nearest) <= limit)) {
                size = base;
                break;
            }
            const double before = bound;
            visit(KeyedLane::child(nearest), bound);
            if (bound != before) limit = probe.limit(bound);
        }
    }
}

template <class Visit>
void Octree::raycast(const Ray& ray, Visit&& visit) const {
    if (root_ == none) return;
    nearest_first(RayProbe(ray.origin, ray.direction, 0, bounds_), ray.t_max, visit);
}

template <class Visit>
void Octree::sweep(Vec3 center, Vec3 displacement, double radius, Visit&& visit) const {
    if (root_ == none) return;
    nearest_first(RayProbe(center, displacement, radius, bounds_), 1, visit);
}

template <class Visit>
void Octree::nearest(Vec3 point, double max_distance, Visit&& visit) const {
    if (root_ == none) return;
    nearest_first(PointProbe(point, bounds_), max_distance, visit);
}

/// Depth first through the lanes that hits(boxes) finds.
template <class Hits, class Visit>
bool Octree::everywhere(Hits&& hits, Visit&& visit) const {
    if (root_ == none) return true;
    NodeRef stack[stack_size];
    int size = 0;
    stack[size++] = root_;
    while (size > 0) {
        const NodeRef ref = stack[--size];
        const Node& node = nodes_[index_of(ref)];
        for (uint32_t rest = hits(node.boxes, node.count) & node.lanes(); rest != 0; rest &= rest - 1) {
            const uint32_t child = node.child[__builtin_ctz(rest)];
            if (!is_leaf(ref)) {
                stack[size++] = child;
            } else if (!visit(child)) {
                return false;
            }
        }
    }
    return true;
}

template <class Visit>
bool Octree::overlap_box(const Box& box, Visit&& visit) const {
    const BoxProbe probe(box);
    return everywhere([&](const Box8& boxes, uint32_t) { return probe.hits(boxes); }, visit);
}

template <class Touches, class Visit>
bool Octree::overlap(Touches&& touches, Visit&& visit) const {
    const auto hits = [&](const Box8& boxes, uint32_t count) {
        uint32_t found = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (touches(boxes.lane(static_cast<int>(i)))) found |= 1u << i;
        }
        return found;
    };
    return everywhere(hits, visit);
}

/// Planes that a node is wholly inside need no test below it, and when none is left the whole
/// subtree is inside (Assarsson and Möller 2000).
template <class Visit>
bool Octree::frustum(const Frustum& frustum, Visit&& visit) const {
    if (root_ == none) return true;
    const FrustumProbe probe(frustum);
    struct Entry {
        NodeRef ref;
        uint32_t planes;
    };
    Entry stack[stack_size];
    int size = 0;
    stack[size++] = {root_, FrustumProbe::all_planes};
    while (size > 0) {
        const Entry entry = stack[--size];
        const Node& node = nodes_[index_of(entry.ref)];
        uint32_t inside[6] = {};
        const uint32_t hits = entry.planes == 0 ? 0xff : probe.hits(node.boxes, entry.planes, inside);
        for (uint32_t rest = hits & node.lanes(); rest != 0; rest &= rest - 1) {
            const int lane = __builtin_ctz(rest);
            uint32_t planes = entry.planes;
            for (int p = 0; p < 6; ++p) planes &= ~((inside[p] >> lane & 1) << p);
            if (!is_leaf(entry.ref)) {
                stack[size++] = {node.child[lane], planes};
            } else if (!visit(node.child[lane], planes == 0)) {
                return false;
            }
        }
    }
    return true;
}

/// Both trees at once: each lane of one node is tested against the eight of the other, and where
/// one side is a leaf the other goes down alone.
template <class Visit>
bool Octree::overlap_pairs(const Octree& other, Visit&& visit) const {
    if (root_ == none || other.root_ == none) return true;
    const auto below_other = [&](uint32_t item, const Box& box, NodeRef ref) {
        const BoxProbe probe(box);
        NodeRef stack[stack_size];
        int size = 0;
        stack[size++] = ref;
        while (size > 0) {
            const NodeRef top = stack[--size];
            const Node& node = other.nodes_[index_of(top)];
            for (uint32_t rest = probe.hits(node.boxes) & node.lanes(); rest != 0; rest &= rest - 1) {
                const uint32_t child = node.child[__builtin_ctz(rest)];
                if (!is_leaf(top)) {
                    stack[size++] = child;
                } else if (!visit(item, child)) {
                    return false;
                }
            }
        }
        return true;
    };
    struct Pair {
        NodeRef a, b;
    };
    // Each step goes down at least one level on one side and leaves at most 63 pairs behind.
    Pair stack[64 * max_levels];
    int size = 0;
    stack[size++] = {root_, other.root_};
    while (size > 0) {
        const Pair pair = stack[--size];
        const Node& a = nodes_[index_of(pair.a)];
        const Node& b = other.nodes_[index_of(pair.b)];
        for (uint32_t i = 0; i < a.count; ++i) {
            const Box box = a.boxes.lane(static_cast<int>(i));
            if (is_leaf(pair.a)) {
                if (!below_other(a.child[i], box, pair.b)) return false;
            } else if (is_leaf(pair.b)) {
                if (BoxProbe(box).hits(b.boxes) & b.lanes()) stack[size++] = {a.child[i], pair.b};
            } else {
                for (uint32_t rest = BoxProbe(box).hits(b.boxes) & b.lanes(); rest != 0; rest &= rest - 1) {
                    stack[size++] = {a.child[i], b.child[__builtin_ctz(rest)]};
                }
            }
        }
    }
    return true;
}

template <class Visit>
void Octree::for_each_box(Visit&& visit) const {
    if (root_ == none) return;
    struct Entry {
        NodeRef ref;
        uint32_t depth;
        Box box;
    };
    Entry stack[stack_size];
    int size = 0;
    stack[size++] = {root_, 0, bounds_};
    while (size > 0) {
        const Entry entry = stack[--size];
        const Node& node = nodes_[index_of(entry.ref)];
        const Box& box = entry.box;
        visit(gphys_octree_box{{{box.min[0], box.min[1], box.min[2]}, {box.max[0], box.max[1], box.max[2]}},
                               entry.depth,
                               is_leaf(entry.ref) ? node.count : 0});
        if (is_leaf(entry.ref)) continue;
        for (uint32_t lane = node.count; lane-- > 0;) {
            stack[size++] = {node.child[lane], entry.depth + 1, node.boxes.lane(static_cast<int>(lane))};
        }
    }
}

}  // namespace gphys

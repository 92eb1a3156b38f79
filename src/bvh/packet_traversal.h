// Packet traversal, for kernels: coherent rays visit each node once for all of them, front to back by the earliest
// entry. Inner nodes are tested by interval arithmetic for the whole packet. The items of a leaf are tested for groups
// of eight rays, then for each ray (Boulos, Wald, Benthin, "Geometric and arithmetic culling methods for entire ray
// packets", 2006; Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", 2005).
//
// A packet that diverges costs more than its rays cost separately. PacketCost detects that; then the rays continue
// interleaved (interleaved_traversal.h).
#pragma once

#include "bvh/packet_test.h"
#include "bvh/prefetch.h"
#include "bvh/traversal_stack.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

/// The limits of the rays of a packet, padded to groups of eight with -1: no ray.
struct PacketLimits {
    static_assert(RayPackets::max_rays <= bvh_max_rays);
    alignas(32) float limits[bvh_max_rays];

    template <class LimitOf>
    PacketLimits(uint32_t count, const LimitOf& limit_of) {
        for (uint32_t i = 0; i < count; ++i) limits[i] = limit_of(i);
        for (uint32_t i = count; i % 8 != 0; ++i) limits[i] = -1;
    }
};

/// 0, 1, 2, ...: what compress_store selects the numbers of rays or lanes from.
struct LaneNumbers {
    uint32_t values[RayPackets::max_rays];

    constexpr LaneNumbers() : values{} {
        for (uint32_t i = 0; i < RayPackets::max_rays; ++i) values[i] = i;
    }
};
inline constexpr LaneNumbers lane_numbers;

/// Collects pairs of a ray and an item. The visitor gets eight at a time, since eight take little longer than one.
template <class Visit>
class VisitQueue {
public:
    /// visit(rays, items, count)
    explicit VisitQueue(const Visit& visit) : visit_(visit) {}

    /// Adds the rays of a group (PacketTest) that `mask` selects.
    void add(uint32_t group, uint32_t mask, uint32_t item) {
        for (uint32_t i = 0; i < 8; ++i) items_[count_ + i] = item;
        count_ += compress_store(rays_ + count_, lane_numbers.values + 8 * group, mask);
        if (count_ < 8) return;
        visit_(rays_, items_, 8u);
        count_ -= 8;
        for (uint32_t i = 0; i < count_; ++i) {
            rays_[i] = rays_[8 + i];
            items_[i] = items_[8 + i];
        }
    }
    void flush() {
        if (count_ > 0) visit_(rays_, items_, count_);
        count_ = 0;
    }

private:
    const Visit& visit_;
    uint32_t rays_[16], items_[16], count_ = 0;
};

/// Compares the cost of a packet with the estimated cost of its rays traversed separately. The distance between the
/// rays predicts that badly, because leaves differ in size; so the estimate uses what the traversal has visited so far.
/// Separately, each ray visits some nodes, and about one more for each item that it may hit. The packet visits nodes,
/// and in leaves tests groups and rays; a test of one box costs about a third of a node. The weights are fitted to the
/// benchmark of batches (bench/batches.cpp), which fails where a batch takes longer than its single calls.
class PacketCost {
public:
    explicit PacketCost(uint32_t rays) : separate_(nodes_per_ray * rays) {}

    void add_node() { packet_ += node; }
    void add_groups(uint32_t count) { packet_ += group * count; }
    void add_box(uint32_t rays) {
        packet_ += box;
        separate_ += item * rays;
    }
    bool is_too_high() const { return packet_ > separate_; }

private:
    static constexpr uint32_t node = 3, group = 2, box = 1, nodes_per_ray = 12, item = 4;

    uint32_t packet_ = 0, separate_;
};

/// visit(group, mask, item) gets the rays of a group that may hit the item. It may defer new limits until flush(), at
/// the end of a leaf. Returns false if the packet costs too much: then each ray has to be traversed separately from the
/// root, with its present limit.
template <class Visit, class Flush, class PrefetchOf>
bool traverse_packet(const BvhNode* nodes, uint32_t root, PacketTest& test, uint32_t count, const Visit& visit,
                     const Flush& flush, const PrefetchOf& prefetch_of) {
    if (test.limit() < 0) return true;
    StackEntry stack[stack_size];
    int size = 0;
    uint32_t ref = root;
    PacketCost cost(count);
    for (;;) {
        const BvhNode& node = node_at(nodes, ref);
        Float8 keys;
        NodeHits hits;
        hits.lanes = test.hits(node.boxes, keys) & lanes_of(node);
        store(hits.keys, keys);
        cost.add_node();
        if (hits.lanes != 0 && !is_leaf(ref)) {
            const int base = size;
            size = push_sorted(stack, size, node.child, hits, false);
            for (int i = size; i-- > base;) prefetch_range(&node_at(nodes, child_of(stack[i])), sizeof(BvhNode));
            ref = child_of(stack[--size]);
            continue;
        }
        if (hits.lanes != 0) {
            const uint64_t groups = test.hits_of_groups(node.boxes);
            cost.add_groups((count + 7) / 8);
            constexpr uint64_t lane_of_groups = 0x0101010101010101;
            for (uint32_t rest = hits.lanes; rest != 0; rest &= rest - 1) prefetch_of(node.child[lowest_bit(rest)]);
            StackEntry ordered[8 + stack_slack];
            for (int left = push_sorted(ordered, 0, lane_numbers.values, hits, false); left-- > 0;) {
                const uint32_t lane = child_of(ordered[left]);
                for (uint64_t rest = groups >> lane & lane_of_groups; rest != 0; rest &= rest - 1) {
                    const auto group = static_cast<uint32_t>(lowest_bit(rest)) / 8;
                    const uint32_t mask = test.rays(group, node.boxes, lane);
                    cost.add_box(static_cast<uint32_t>(popcount(mask)));
                    if (mask != 0) visit(group, mask, node.child[lane]);
                }
            }
            flush();
            test.set_limits();
        }
        if (cost.is_too_high()) return false;
        do {
            if (size == 0) return true;
            --size;
        } while (!(key_of(stack[size]) <= test.limit()));
        ref = child_of(stack[size]);
    }
}

}  // namespace gphys::GPHYS_ISA

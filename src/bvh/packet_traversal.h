// Packet traversal, for kernels: rays that go much the same way visit each node once for all of them, front to back by
// the first of them to enter. Inner nodes are tested by interval arithmetic over the whole packet, the items of leaves
// first for groups of eight rays and then for each ray (Boulos, Wald, Benthin, "Geometric and arithmetic culling
// methods for entire ray packets", 2006; Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", 2005).
//
// A packet whose rays come apart costs more than its rays alone: it is given up, and they go on interleaved
// (interleaved_traversal.h).
#pragma once

#include "bvh/packet_test.h"
#include "bvh/prefetch.h"
#include "bvh/traversal_stack.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

/// The limits of the rays of a packet. Groups of eight are filled up with none.
struct PacketLimits {
    static_assert(RayPackets::most <= bvh_most_rays);
    alignas(32) float limits[bvh_most_rays];

    template <class LimitOf>
    PacketLimits(uint32_t count, const LimitOf& limit_of) {
        for (uint32_t i = 0; i < count; ++i) limits[i] = limit_of(i);
        for (uint32_t i = count; i % 8 != 0; ++i) limits[i] = -1;
    }
};

/// Numbers of rays, for compress_store.
struct Numbers {
    uint32_t up_to[RayPackets::most];

    constexpr Numbers() : up_to{} {
        for (uint32_t i = 0; i < RayPackets::most; ++i) up_to[i] = i;
    }
};
inline constexpr Numbers numbers;

/// Pairs of a ray and an item, kept back until there are eight: to visit eight takes little longer than one.
template <class Visit>
class VisitQueue {
public:
    /// visit(rays, items, count)
    explicit VisitQueue(const Visit& visit) : visit_(visit) {}

    /// The rays of a group (PacketTest) that a mask selects.
    void add(uint32_t group, uint32_t mask, uint32_t item) {
        for (uint32_t i = 0; i < 8; ++i) items_[count_ + i] = item;
        count_ += compress_store(rays_ + count_, numbers.up_to + 8 * group, mask);
        if (count_ < 8) return;
        visit_(rays_, items_, 8u);
        count_ -= 8;
        for (uint32_t i = 0; i < count_; ++i) {
            rays_[i] = rays_[8 + i];
            items_[i] = items_[8 + i];
        }
    }
    void finish() {
        if (count_ > 0) visit_(rays_, items_, count_);
        count_ = 0;
    }

private:
    const Visit& visit_;
    uint32_t rays_[16], items_[16], count_ = 0;
};

/// Whether the packet is still cheaper than its rays alone would be. How far apart they are tells little, as leaves
/// differ in size; what the traversal has met so far tells more. Alone, each ray would have visited some nodes, and
/// about one for each item that it may hit. The packet has visited nodes, and in leaves has tested groups and rays; a
/// test of one box costs about a third of that of a node. The weights are fitted to the benchmark of batches
/// (bench/batches.cpp), which fails where a batch takes longer than its single calls.
class PacketCost {
public:
    explicit PacketCost(uint32_t rays) : alone_(nodes_of_each * rays) {}

    void add_node() { packet_ += node; }
    void add_groups(uint32_t count) { packet_ += group * count; }
    void add_box(uint32_t rays) {
        packet_ += box;
        alone_ += item * rays;
    }
    bool is_too_high() const { return packet_ > alone_; }

private:
    static constexpr uint32_t node = 3, group = 2, box = 1, nodes_of_each = 12, item = 4;

    uint32_t packet_ = 0, alone_;
};

/// visit(group, mask, item) is for the rays of a group that may hit the item; it may put off to move limits until
/// settle() at the end of a leaf. False if the packet has come to cost too much: then each ray has to begin again by
/// itself, with the limit that it has.
template <class Visit, class Settle, class PrefetchOf>
bool traverse_packet(const BvhNode* nodes, uint32_t root, PacketTest& test, uint32_t count, const Visit& visit,
                     const Settle& settle, const PrefetchOf& prefetch_of) {
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
            for (int left = push_sorted(ordered, 0, numbers.up_to, hits, false); left-- > 0;) {
                const uint32_t lane = child_of(ordered[left]);
                for (uint64_t rest = groups >> lane & lane_of_groups; rest != 0; rest &= rest - 1) {
                    const auto group = static_cast<uint32_t>(lowest_bit(rest)) / 8;
                    const uint32_t mask = test.rays(group, node.boxes, lane);
                    cost.add_box(static_cast<uint32_t>(popcount(mask)));
                    if (mask != 0) visit(group, mask, node.child[lane]);
                }
            }
            settle();
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

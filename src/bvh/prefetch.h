// Prefetches of nodes and items, for kernels. A tree of a million items is larger than the caches, and a cache miss
// costs more than the test of a node.
#pragma once

#include "bvh/bvh_kernels.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

// Always inlined: gcc treats a function that only prefetches as one without effect, and removes its calls.
GPHYS_INLINE void prefetch_range(const void* memory, uint32_t size) {
    for (uint32_t byte = 0; byte < size; byte += 64) prefetch(static_cast<const char*>(memory) + byte);
}

/// Prefetches nodes from the offset `read_from` on. Mostly `count` is at most three: always three rounds, since a loop
/// of `count` rounds would end with an unpredictable branch.
template <size_t read_from = 0>
GPHYS_INLINE void prefetch_nodes(const BvhNode* nodes, const uint32_t* refs, uint32_t count) {
    constexpr uint32_t usual = 3, size = sizeof(BvhNode) - read_from;
    const char* const first = reinterpret_cast<const char*>(nodes) + read_from;
    const auto at = [&](uint32_t i) { return first + sizeof(BvhNode) * size_t{refs[i] & ~bvh_leaf_bit}; };
    for (uint32_t i = 0; i < usual; ++i) prefetch_range(at(i < count ? i : 0), size);
    for (uint32_t i = usual; i < count; ++i) prefetch_range(at(i), size);
}

GPHYS_INLINE void prefetch_item(const ItemMemory& items, uint32_t item) {
    // Mostly one cache line. A prefetch of an invalid address does no harm.
    const char* first = static_cast<const char*>(items.first) + size_t{item} * items.size;
    prefetch(first);
    if (items.size > 64) prefetch_range(first + 64, items.size - 64);
}

/// Always two rounds, without a branch: mostly `count` is at most two. `items` has at least two elements, the ones from
/// `count` on with any values.
GPHYS_INLINE void prefetch_few(const ItemMemory& memory, const uint32_t* items, uint32_t count) {
    if (memory.size == 0) return;
    prefetch_item(memory, items[0]);
    prefetch_item(memory, items[1]);
    for (uint32_t i = 2; i < count; ++i) prefetch_item(memory, items[i]);
}

/// Four in each round: fewer rounds make the loop's end more predictable.
GPHYS_INLINE void prefetch_many(const ItemMemory& memory, const uint32_t* items, uint32_t count) {
    if (memory.size == 0) return;
    for (uint32_t first = 0; first < count; first += 4) {
        for (uint32_t i = first; i < first + 4; ++i) prefetch_item(memory, items[i < count ? i : first]);
    }
}

}  // namespace gphys::GPHYS_ISA

// Prefetching of nodes and items, for kernels: a tree of a million items is larger than the caches, and a node that
// is asked for only when it is needed costs more than its test.
#pragma once

#include "bvh/bvh_kernels.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

// Always inlined: gcc takes a function that only prefetches for one without effect, and drops its calls.
GPHYS_INLINE void prefetch_range(const void* memory, uint32_t size) {
    for (uint32_t byte = 0; byte < size; byte += 64) prefetch(static_cast<const char*>(memory) + byte);
}

/// Nodes of which is read what begins at `read_from`. Mostly there are at most three; a loop of as many rounds as there
/// are would end with an unpredictable branch.
template <size_t read_from = 0>
GPHYS_INLINE void prefetch_nodes(const BvhNode* nodes, const uint32_t* refs, uint32_t count) {
    constexpr uint32_t often = 3, size = sizeof(BvhNode) - read_from;
    const char* const first = reinterpret_cast<const char*>(nodes) + read_from;
    const auto at = [&](uint32_t i) { return first + sizeof(BvhNode) * size_t{refs[i] & ~bvh_leaf_bit}; };
    for (uint32_t i = 0; i < often; ++i) prefetch_range(at(i < count ? i : 0), size);
    for (uint32_t i = often; i < count; ++i) prefetch_range(at(i), size);
}

GPHYS_INLINE void prefetch_item(const ItemMemory& items, uint32_t item) {
    // Mostly of one cache line. A prefetch of no memory does no harm.
    const char* first = static_cast<const char*>(items.first) + size_t{item} * items.size;
    prefetch(first);
    if (items.size > 64) prefetch_range(first + 64, items.size - 64);
}

/// Mostly there are at most two, and no branch depends on which. Of `items` there are at least two, of which those
/// beyond `count` may be any.
GPHYS_INLINE void prefetch_few(const ItemMemory& memory, const uint32_t* items, uint32_t count) {
    if (memory.size == 0) return;
    prefetch_item(memory, items[0]);
    prefetch_item(memory, items[1]);
    for (uint32_t i = 2; i < count; ++i) prefetch_item(memory, items[i]);
}

/// Any number, four in each round: the fewer rounds, the more predictable their number.
GPHYS_INLINE void prefetch_many(const ItemMemory& memory, const uint32_t* items, uint32_t count) {
    if (memory.size == 0) return;
    for (uint32_t first = 0; first < count; first += 4) {
        for (uint32_t i = first; i < first + 4; ++i) prefetch_item(memory, items[i < count ? i : first]);
    }
}

}  // namespace gphys::GPHYS_ISA

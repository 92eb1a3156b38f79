// The stack of ordered traversals (ordered_traversal.h, packet_traversal.h), for kernels: entries of a child and its
// key, the next to visit on top. Pushes sort the children of a node, by sorting networks (Batcher 1968) where the
// instruction set has permutations; prune() removes the entries beyond a lower limit. Both avoid unpredictable branches
// on the number of entries.
#pragma once

#include <cstring>

#include "bvh/bvh_node.h"
#include "bvh/compress_store.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

inline bool is_leaf(uint32_t ref) { return (ref & bvh_leaf_bit) != 0; }
inline const BvhNode& node_at(const BvhNode* nodes, uint32_t ref) { return nodes[ref & ~bvh_leaf_bit]; }
inline uint32_t lanes_of(const BvhNode& node) { return (1u << node.count) - 1; }

/// Result of a test of a node's eight boxes: the lanes that are hit, and a key for each.
struct NodeHits {
    uint32_t lanes;
    alignas(32) float keys[8];
};

/// Low half: the child. High half: the key, the bits of a float >= 0, which sort as the float does. The lowest three
/// bits of the key hold the lane during the sort, then the mark of items. They make a key at most a little smaller, so
/// nothing is pruned that must be visited.
using StackEntry = uint64_t;
constexpr uint32_t lane_field = 7, item_mark = 1;
constexpr uint32_t minus_infinity = 0xff800000u;
/// The bottom of a stack. It is never pruned: its key is below all limits.
constexpr StackEntry sentinel = uint64_t{minus_infinity} << 32;

inline uint32_t child_of(StackEntry entry) { return static_cast<uint32_t>(entry); }
inline bool is_item(StackEntry entry) { return (entry >> 32 & item_mark) != 0; }
inline float key_of(StackEntry entry) {
    const uint32_t key_bits = static_cast<uint32_t>(entry >> 32) & ~lane_field;
    float key;
    std::memcpy(&key, &key_bits, sizeof key);
    return key;
}

/// push_sorted and prune may write this many entries above the top.
constexpr int stack_slack = 8;
/// Of the deepest tree, with the sentinel and the slack.
constexpr int stack_size = 1 + bvh_open(bvh_max_levels) + stack_slack;

/// The sorted value: the bits of a key, with the lane in the lowest bits.
inline uint32_t lane_key(const float keys[8], int lane) {
    uint32_t key_bits;
    std::memcpy(&key_bits, keys + lane, sizeof key_bits);
    return (key_bits & ~lane_field) | static_cast<uint32_t>(lane);
}

/// Any number of hits, by insertion sort; also the scalar meaning of the networks below.
GPHYS_INLINE int push_by_insertion(StackEntry* stack, int size, const uint32_t children[8], const NodeHits& node,
                                   uint32_t mark) {
    uint32_t sorted[8];  // descending
    int count = 0;
    for (uint32_t rest = node.lanes; rest != 0; rest &= rest - 1) {
        const uint32_t added = lane_key(node.keys, lowest_bit(rest));
        int at = count++;
        for (; at > 0 && sorted[at - 1] < added; --at) sorted[at] = sorted[at - 1];
        sorted[at] = added;
    }
    for (int i = 0; i < count; ++i) {
        const uint64_t key = (sorted[i] & ~lane_field) | mark;
        stack[size + i] = key << 32 | children[sorted[i] & lane_field];
    }
    return size + count;
}

#if GPHYS_HAS_AVX2
/// Up to four hits, by a sorting network of three steps: no unpredictable branch.
GPHYS_INLINE int push_by_network_of_four(StackEntry* stack, int size, const uint32_t children[8], const NodeHits& node,
                                         uint32_t mark) {
    int32_t packed;
    std::memcpy(&packed, compress_table.of[node.lanes], sizeof packed);
    const __m128i lanes = _mm_cvtepi8_epi32(_mm_cvtsi32_si128(packed));
    const __m256 keys = _mm256_permutevar8x32_ps(_mm256_load_ps(node.keys), _mm256_castsi128_si256(lanes));
    const __m128i no_lane = _mm_set1_epi32(static_cast<int>(~lane_field));
    const __m128i bits = _mm_and_si128(_mm_castps_si128(_mm256_castps256_ps128(keys)), no_lane);
    // Lanes without a hit have all bits set: as signed integers, less than any key.
    __m128i sorted = _mm_or_si128(bits, lanes);
    const auto exchange = [&sorted](__m128i other, auto blend) {
        sorted = blend(_mm_max_epi32(sorted, other), _mm_min_epi32(sorted, other));
    };
    exchange(_mm_shuffle_epi32(sorted, 0xb1), [](__m128i a, __m128i b) { return _mm_blend_epi32(a, b, 0b1010); });
    exchange(_mm_shuffle_epi32(sorted, 0x4e), [](__m128i a, __m128i b) { return _mm_blend_epi32(a, b, 0b1100); });
    exchange(_mm_shuffle_epi32(sorted, 0xd8), [](__m128i a, __m128i b) { return _mm_blend_epi32(a, b, 0b0100); });
    const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(children));
    const __m128i child = _mm256_castsi256_si128(_mm256_permutevar8x32_epi32(eight, _mm256_castsi128_si256(sorted)));
    const __m128i key = _mm_or_si128(_mm_and_si128(sorted, no_lane), _mm_set1_epi32(static_cast<int>(mark)));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(stack + size), _mm_unpacklo_epi32(child, key));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(stack + size + 2), _mm_unpackhi_epi32(child, key));
    return size + popcount(node.lanes);
}

/// lane_key() of all lanes; lanes without a hit have all bits set.
GPHYS_INLINE __m256i sortable_keys(const NodeHits& node) {
    const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i no_lane = _mm256_set1_epi32(static_cast<int>(~lane_field));
    const __m256i bits = _mm256_and_si256(_mm256_load_si256(reinterpret_cast<const __m256i*>(node.keys)), no_lane);
    const __m256i keys = _mm256_or_si256(bits, lanes);
#if GPHYS_ISA_IS(avx512)
    return _mm256_mask_mov_epi32(_mm256_set1_epi32(-1), static_cast<__mmask8>(node.lanes), keys);
#else
    const __m256i lane_bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i hit = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(node.lanes)), lane_bit);
    return _mm256_or_si256(keys, _mm256_cmpeq_epi32(hit, _mm256_setzero_si256()));
#endif
}

/// Any number of hits, by the network of Batcher's odd-even merge sort.
GPHYS_INLINE int push_by_network_of_eight(StackEntry* stack, int size, const uint32_t children[8], const NodeHits& node,
                                          uint32_t mark) {
    const __m256i no_lane = _mm256_set1_epi32(static_cast<int>(~lane_field));
    __m256i sorted = sortable_keys(node);
    const auto exchange = [&sorted](int a, int b, int c, int d, int e, int f, int g, int h) {
        const int partner[8] = {a, b, c, d, e, f, g, h};
        const __m256i with = _mm256_setr_epi32(a, b, c, d, e, f, g, h);
        const __m256i other = _mm256_permutevar8x32_epi32(sorted, with);
        const auto later = [&](int i) { return partner[i] < i ? -1 : 0; };
        const __m256i take_less =
            _mm256_setr_epi32(later(0), later(1), later(2), later(3), later(4), later(5), later(6), later(7));
        sorted = _mm256_blendv_epi8(_mm256_max_epi32(sorted, other), _mm256_min_epi32(sorted, other), take_less);
    };
    exchange(1, 0, 3, 2, 5, 4, 7, 6);
    exchange(2, 3, 0, 1, 6, 7, 4, 5);
    exchange(0, 2, 1, 3, 4, 6, 5, 7);
    exchange(4, 5, 6, 7, 0, 1, 2, 3);
    exchange(0, 1, 4, 5, 2, 3, 6, 7);
    exchange(0, 2, 1, 4, 3, 6, 5, 7);
    const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(children));
    const __m256i child = _mm256_permutevar8x32_epi32(eight, sorted);
    const __m256i key = _mm256_or_si256(_mm256_and_si256(sorted, no_lane), _mm256_set1_epi32(static_cast<int>(mark)));
    const __m256i low = _mm256_unpacklo_epi32(child, key), high = _mm256_unpackhi_epi32(child, key);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(stack + size), _mm256_permute2x128_si256(low, high, 0x20));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(stack + size + 4), _mm256_permute2x128_si256(low, high, 0x31));
    return size + popcount(node.lanes);
}
#endif

/// The hit lane with the least key, of equal ones the first; any lane if there is no hit.
GPHYS_INLINE uint32_t nearest_lane(const NodeHits& node) {
#if GPHYS_HAS_AVX2
    const __m256i keys = sortable_keys(node);
    __m128i least = _mm_min_epu32(_mm256_castsi256_si128(keys), _mm256_extracti128_si256(keys, 1));
    least = _mm_min_epu32(least, _mm_shuffle_epi32(least, 0x4e));
    least = _mm_min_epu32(least, _mm_shuffle_epi32(least, 0xb1));
    return static_cast<uint32_t>(_mm_cvtsi128_si32(least)) & lane_field;
#else
    uint32_t least = ~0u;
    for (uint32_t rest = node.lanes; rest != 0; rest &= rest - 1) {
        const uint32_t key = lane_key(node.keys, lowest_bit(rest));
        least = key < least ? key : least;
    }
    return least & lane_field;
#endif
}

/// Pushes the hit children, farthest first.
GPHYS_INLINE int push_sorted(StackEntry* stack, int size, const uint32_t children[8], const NodeHits& node,
                             bool items) {
    const uint32_t mark = items ? item_mark : 0;
#if GPHYS_HAS_AVX2
    if (popcount(node.lanes) <= 4) return push_by_network_of_four(stack, size, children, node, mark);
    return push_by_network_of_eight(stack, size, children, node, mark);
#else
    return push_by_insertion(stack, size, children, node, mark);
#endif
}

#if GPHYS_HAS_AVX2
/// of[mask]: the selected ones of four entries, as pairs of 32-bit lanes, for compress-store.
struct HalvesOfEntries {
    alignas(32) int32_t of[16][8];

    constexpr HalvesOfEntries() : of{} {
        for (int set = 0; set < 16; ++set) {
            int32_t* to = of[set];
            for (int32_t entry = 0; entry < 4; ++entry) {
                if ((set >> entry & 1) == 0) continue;
                *to++ = 2 * entry;
                *to++ = 2 * entry + 1;
            }
        }
    }
};
inline constexpr HalvesOfEntries halves_of_entries;
#endif

/// Keeps the entries with keys up to a limit, in their order, and returns their number. For a single ray: wider loads
/// of entries that were just pushed would stall on store forwarding.
inline int prune_one_by_one(float limit, StackEntry* entries, int size) {
    int kept = 0;
    for (int i = 0; i < size; ++i) {
        const StackEntry entry = entries[i];
        entries[kept] = entry;
        kept += key_of(entry) <= limit;
    }
    return kept;
}

/// The same for interleaved rays, whose entries were pushed longer ago. Reads and writes up to stack_slack more.
inline int prune(float limit, StackEntry* entries, int size) {
#if GPHYS_HAS_AVX2
    int kept = 0;
    // Keys compare as signed integers; their lowest three bits are ignored.
    uint32_t limit_bits;
    std::memcpy(&limit_bits, &limit, sizeof limit_bits);
    const auto last = static_cast<int64_t>(uint64_t{limit_bits | lane_field} << 32 | 0xffffffffu);
#if GPHYS_ISA_IS(avx512)
    const __m512i lasts = _mm512_set1_epi64(last);
    for (int i = 0; i < size; i += 8) {
        const __m512i eight = _mm512_loadu_si512(entries + i);
        const auto there = static_cast<__mmask8>(size - i < 8 ? (1u << (size - i)) - 1 : 0xff);
        const __mmask8 keep = _mm512_mask_cmple_epi64_mask(there, eight, lasts);
        _mm512_storeu_si512(entries + kept, _mm512_maskz_compress_epi64(keep, eight));
        kept += popcount(keep);
    }
#else
    const __m256i lasts = _mm256_set1_epi64x(last);
    for (int i = 0; i < size; i += 4) {
        const __m256i four = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(entries + i));
        const __m256d beyond = _mm256_castsi256_pd(_mm256_cmpgt_epi64(four, lasts));
        const uint32_t there = size - i < 4 ? (1u << (size - i)) - 1 : 0xf;
        const uint32_t keep = there & ~static_cast<uint32_t>(_mm256_movemask_pd(beyond));
        const __m256i words = _mm256_load_si256(reinterpret_cast<const __m256i*>(halves_of_entries.of[keep]));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(entries + kept), _mm256_permutevar8x32_epi32(four, words));
        kept += popcount(keep);
    }
#endif
    return kept;
#else
    return prune_one_by_one(limit, entries, size);
#endif
}

}  // namespace gphys::GPHYS_ISA

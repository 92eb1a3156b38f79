// The stack of a walk through an octree that goes nearest first, for kernels.
#pragma once

#include <cstring>

#include "octree/lane_sets.h"
#include "octree/octree_node.h"

namespace gphys::GPHYS_ISA {

inline bool is_leaf(uint32_t ref) { return (ref & octree_leaf_bit) != 0; }
inline const OctreeNode& node_at(const OctreeNode* nodes, uint32_t ref) { return nodes[ref & ~octree_leaf_bit]; }
inline uint32_t lanes_of(const OctreeNode& node) { return (1u << node.count) - 1; }

/// What a test found in a node: lanes, and where in them.
struct Found {
    uint32_t hits;
    alignas(32) float keys[8];
};

/// A child below, its key above: the bits of a float >= 0, which sort like the float itself. The
/// lowest three make room for a lane while the children of a node are put in order, and then tell
/// items from nodes; without them a key is at most a little less.
using KeyedChild = uint64_t;
constexpr uint32_t lane_field = 7, item_mark = 1;
constexpr uint32_t minus_infinity = 0xff800000u;
/// Before all limits.
constexpr KeyedChild bottom = uint64_t{minus_infinity} << 32;

inline uint32_t child_of(KeyedChild entry) { return static_cast<uint32_t>(entry); }
inline bool is_item(KeyedChild entry) { return (entry >> 32 & item_mark) != 0; }
inline float key_of(KeyedChild entry) {
    const uint32_t key_bits = static_cast<uint32_t>(entry >> 32) & ~lane_field;
    float key;
    std::memcpy(&key, &key_bits, sizeof key);
    return key;
}

/// push_nearest_last and keep_up_to may write so many more entries than there are.
constexpr int pushed_beyond = 8;
// The bottom, and of each level at most seven siblings besides the children of the last.
constexpr int stack_size = 1 + 7 * octree_max_levels + 8 + pushed_beyond;

/// The keys of lanes as they sort, with the lanes in them.
inline uint32_t lane_key(const float keys[8], int lane) {
    uint32_t key_bits;
    std::memcpy(&key_bits, keys + lane, sizeof key_bits);
    return (key_bits & ~lane_field) | static_cast<uint32_t>(lane);
}

/// Any number of hits.
inline int push_by_insertion(KeyedChild* stack, int size, const uint32_t children[8], const Found& found,
                             uint32_t mark) {
    uint32_t sorted[8];  // descending
    int count = 0;
    for (uint32_t rest = found.hits; rest != 0; rest &= rest - 1) {
        const uint32_t added = lane_key(found.keys, __builtin_ctz(rest));
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
/// Up to four hits, without a branch that could not be foreseen.
inline int push_by_network(KeyedChild* stack, int size, const uint32_t children[8], const Found& found, uint32_t mark) {
    int32_t packed;
    std::memcpy(&packed, lane_lists.of[found.hits], sizeof packed);
    const __m128i lanes = _mm_cvtepi8_epi32(_mm_cvtsi32_si128(packed));
    const __m256 keys = _mm256_permutevar8x32_ps(_mm256_load_ps(found.keys), _mm256_castsi128_si256(lanes));
    const __m128i no_lane = _mm_set1_epi32(static_cast<int>(~lane_field));
    const __m128i bits = _mm_and_si128(_mm_castps_si128(_mm256_castps256_ps128(keys)), no_lane);
    // Where there is no hit all bits are set, which is less than any key.
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
    return size + __builtin_popcount(found.hits);
}

/// Any number of hits, in the same way (Batcher's odd-even merge sort, 1968).
inline int push_by_large_network(KeyedChild* stack, int size, const uint32_t children[8], const Found& found,
                                 uint32_t mark) {
    const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i lane_bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i no_lane = _mm256_set1_epi32(static_cast<int>(~lane_field));
    const __m256i hit = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(found.hits)), lane_bit);
    const __m256i missed = _mm256_cmpeq_epi32(hit, _mm256_setzero_si256());
    const __m256i bits = _mm256_and_si256(_mm256_load_si256(reinterpret_cast<const __m256i*>(found.keys)), no_lane);
    __m256i sorted = _mm256_or_si256(_mm256_or_si256(bits, lanes), missed);
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
    return size + __builtin_popcount(found.hits);
}
#endif

/// Push the children that were found, furthest first.
inline int push_nearest_last(KeyedChild* stack, int size, const uint32_t children[8], const Found& found, bool items) {
    const uint32_t mark = items ? item_mark : 0;
#if GPHYS_HAS_AVX2
    if (__builtin_popcount(found.hits) <= 4) return push_by_network(stack, size, children, found, mark);
    return push_by_large_network(stack, size, children, found, mark);
#else
    return push_by_insertion(stack, size, children, found, mark);
#endif
}

#if GPHYS_HAS_AVX2
/// For each set of four entries the numbers of their halves, in order.
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

/// Of some entries keep those up to a limit, in their order, without a branch for each; returns how many. May read and
/// write pushed_beyond more.
inline int keep_up_to(float limit, KeyedChild* entries, int size) {
    int kept = 0;
#if GPHYS_HAS_AVX2
    // Keys compare as signed numbers; their lowest bits do not count.
    uint32_t limit_bits;
    std::memcpy(&limit_bits, &limit, sizeof limit_bits);
    const auto last = static_cast<int64_t>(uint64_t{limit_bits | lane_field} << 32 | 0xffffffffu);
#endif
#if GPHYS_ISA_IS(avx512)
    const __m512i lasts = _mm512_set1_epi64(last);
    for (int i = 0; i < size; i += 8) {
        const __m512i eight = _mm512_loadu_si512(entries + i);
        const auto there = static_cast<__mmask8>(size - i < 8 ? (1u << (size - i)) - 1 : 0xff);
        const __mmask8 keep = _mm512_mask_cmple_epi64_mask(there, eight, lasts);
        _mm512_storeu_si512(entries + kept, _mm512_maskz_compress_epi64(keep, eight));
        kept += __builtin_popcount(keep);
    }
#elif GPHYS_HAS_AVX2
    const __m256i lasts = _mm256_set1_epi64x(last);
    for (int i = 0; i < size; i += 4) {
        const __m256i four = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(entries + i));
        const __m256d beyond = _mm256_castsi256_pd(_mm256_cmpgt_epi64(four, lasts));
        const uint32_t there = size - i < 4 ? (1u << (size - i)) - 1 : 0xf;
        const uint32_t keep = there & ~static_cast<uint32_t>(_mm256_movemask_pd(beyond));
        const __m256i words = _mm256_load_si256(reinterpret_cast<const __m256i*>(halves_of_entries.of[keep]));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(entries + kept), _mm256_permutevar8x32_epi32(four, words));
        kept += __builtin_popcount(keep);
    }
#else
    for (int i = 0; i < size; ++i) {
        const KeyedChild entry = entries[i];
        entries[kept] = entry;
        kept += key_of(entry) <= limit;
    }
#endif
    return kept;
}

}  // namespace gphys::GPHYS_ISA

// Sets of the eight lanes of a node as lists, for kernels: how many there are is the toss of a coin,
// so nothing here takes a branch by it.
#pragma once

#include "foundation/simd.h"

namespace gphys::GPHYS_ISA {

/// For each set of lanes those in it, and behind them -1.
struct LaneLists {
    int8_t of[256][8];

    constexpr LaneLists() : of{} {
        for (int set = 0; set < 256; ++set) {
            int count = 0;
            for (int8_t lane = 0; lane < 8; ++lane) {
                if ((set >> lane & 1) != 0) of[set][count++] = lane;
            }
            for (; count < 8; ++count) of[set][count] = -1;
        }
    }
};
inline constexpr LaneLists lane_lists;

/// Of eight numbers those in the lanes, with the bits of a mark set; returns how many there are. Writes eight.
inline uint32_t take_lanes(uint32_t* to, const uint32_t from[8], uint32_t lanes, uint32_t mark = 0) {
#if GPHYS_HAS_AVX2
    const __m128i packed = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(lane_lists.of[lanes]));
    const __m256i order = _mm256_cvtepi8_epi32(packed);
    const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    const __m256i taken =
        _mm256_or_si256(_mm256_permutevar8x32_epi32(all, order), _mm256_set1_epi32(static_cast<int>(mark)));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), taken);
#else
    for (int i = 0; i < 8; ++i) to[i] = from[lane_lists.of[lanes][i] & 7] | mark;
#endif
    return static_cast<uint32_t>(__builtin_popcount(lanes));
}

}  // namespace gphys::GPHYS_ISA

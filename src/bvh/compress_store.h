// Compress-store: stores the elements that a mask selects, without gaps, as vpcompressd of AVX-512 does. Here a table
// gives the permutation for each mask. A loop over the mask would end with an unpredictable branch; this has none.
#pragma once

#include "foundation/compiler.h"
#include "foundation/simd.h"

namespace gphys::GPHYS_ISA {

/// of[mask]: the lanes in the mask, ascending, then -1.
struct CompressTable {
    int8_t of[256][8];

    constexpr CompressTable() : of{} {
        for (int mask = 0; mask < 256; ++mask) {
            int count = 0;
            for (int8_t lane = 0; lane < 8; ++lane) {
                if ((mask >> lane & 1) != 0) of[mask][count++] = lane;
            }
            for (; count < 8; ++count) of[mask][count] = -1;
        }
    }
};
inline constexpr CompressTable compress_table;

/// Stores from[lane] | bits for each lane in the mask; returns their number. Writes eight elements.
inline uint32_t compress_store(uint32_t* to, const uint32_t from[8], uint32_t mask, uint32_t bits = 0) {
#if GPHYS_HAS_AVX2
    const __m128i packed = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(compress_table.of[mask]));
    const __m256i order = _mm256_cvtepi8_epi32(packed);
    const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    const __m256i selected =
        _mm256_or_si256(_mm256_permutevar8x32_epi32(all, order), _mm256_set1_epi32(static_cast<int>(bits)));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), selected);
#else
    for (int i = 0; i < 8; ++i) to[i] = from[compress_table.of[mask][i] & 7] | bits;
#endif
    return static_cast<uint32_t>(popcount(mask));
}

}  // namespace gphys::GPHYS_ISA

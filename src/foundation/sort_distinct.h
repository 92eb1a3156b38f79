// Sorting of ids and indices, without allocation.
#pragma once

#include <cstdint>

namespace gphys {

/// Sorts `count` values, no two of which are equal, in ascending order. `capacity`: the size of the array, whose rest
/// is written, too.
///
/// A bit for each value of their range is set, and the set bits are listed: 1 to 2 ns a value, without an unpredictable
/// branch, where std::sort takes 5 ns for hundreds and 50 ns for a hundred thousand. The bits of a large range are in
/// the rest of the array; if that is too small, they are on the stack, one half after the other. A range too large for
/// the cache is first divided by its highest digit, in place: P. M. McIlroy, K. Bostic and M. D. McIlroy, "Engineering
/// radix sort", Computing Systems 6, 1993 (the American flag sort).
void sort_distinct(uint32_t* values, uint32_t count, uint32_t capacity);

}  // namespace gphys

// Sorting of ids and indices, without allocation.
#pragma once

#include <cstdint>

namespace gphys {

/// Sorts `count` values, no two of which are equal, in ascending order. Takes 20 KiB of stack.
///
/// A bit for each value of their range is set, and the set bits are listed: 1 to 2 ns a value, without an unpredictable
/// branch, where std::sort takes 5 ns for hundreds and 50 ns for a hundred thousand. A range too large for that is
/// first divided by its highest digit, in place: P. M. McIlroy, K. Bostic and M. D. McIlroy, "Engineering radix sort",
/// Computing Systems 6, 1993 (the American flag sort).
void sort_distinct(uint32_t* values, uint32_t count);

}  // namespace gphys

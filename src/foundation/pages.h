// Pages of the system for arrays that grow. The system moves them by changing their mapping. That takes microseconds
// where copying takes milliseconds.
#pragma once

#include <cstddef>

namespace gphys::pages {

/// Smaller arrays are copied as fast as pages are remapped.
constexpr std::size_t least = std::size_t{1} << 18;

/// All functions return null, and change nothing, if the system has no such pages or none left. Sizes are at least
/// `least`. New memory is zero, and occupies no physical memory before it is written.
void* map(std::size_t size) noexcept;
void* grow(void* memory, std::size_t old_size, std::size_t new_size) noexcept;
void unmap(void* memory, std::size_t size) noexcept;

/// Trees and models are accessed at random: with pages of 4 KiB each step would also miss the TLB.
constexpr std::size_t huge_page = std::size_t{1} << 21;
/// Advice to use huge pages, for memory aligned to them; it may be ignored.
void advise_huge(void* memory, std::size_t size) noexcept;

}  // namespace gphys::pages

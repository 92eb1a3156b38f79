// Pages of the system for arrays that grow. The system moves them by changing their mapping. That takes microseconds
// where copying takes milliseconds.
#pragma once

#include <cstddef>

namespace gphys::pages {

/// Smaller arrays are copied as fast as pages are remapped.
constexpr std::size_t least = std::size_t{1} << 18;

/// Trees and models are accessed at random: with pages of 4 KiB each step would also miss the TLB.
constexpr std::size_t huge_page = std::size_t{1} << 21;
/// When new memory has huge pages. At once: the first access to each waits until the system has cleared it, 0.1 ms, or
/// 4 ms in a virtual machine whose host has to find memory first. Later: it begins with small pages, and the system
/// joins them in the background (khugepaged).
enum class HugePages { at_once, later };

#if defined(__linux__)
constexpr bool exist = true;
#else
constexpr bool exist = false;
#endif

/// Functions that return a pointer return null, and change nothing, if the system has no such pages or none left. Sizes
/// are at least `least`. New memory is zero, and occupies hardly any physical memory before it is written.
void* map(std::size_t size, HugePages huge) noexcept;
void* grow(void* memory, std::size_t old_size, std::size_t new_size, HugePages huge) noexcept;
void unmap(void* memory, std::size_t size) noexcept;
/// Unmaps the end of a mapping, about `part` bytes. Returns the size that is left: 0, or at least `least`.
std::size_t unmap_end(void* memory, std::size_t size, std::size_t part) noexcept;

/// Advice to use huge pages, for memory aligned to them; it may be ignored.
void advise_huge(void* memory, std::size_t size) noexcept;

}  // namespace gphys::pages

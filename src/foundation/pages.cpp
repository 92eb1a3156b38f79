// Pages of the system on Linux (mmap, mremap, transparent huge pages); elsewhere there are none.
#include "foundation/pages.h"

#include <cstdint>

#if defined(__linux__)
#ifndef _GNU_SOURCE
#define _GNU_SOURCE  // mremap
#endif
#include <sys/mman.h>
#endif

namespace gphys::pages {

#if defined(__linux__)

namespace {

/// A multiple of every page size of Linux except huge pages.
constexpr std::size_t granule = std::size_t{1} << 16;

std::size_t rounded_up(std::size_t size, std::size_t to) { return (size + to - 1) / to * to; }

/// Addresses for `size` bytes, a multiple of granule: aligned to huge pages if they are as large.
char* take_addresses(std::size_t size, int protection) noexcept {
    const std::size_t alignment = size >= huge_page ? huge_page : granule, taken = size + alignment;
    void* const all = mmap(nullptr, taken, protection, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (all == MAP_FAILED) return nullptr;
    char* const begin = static_cast<char*>(all);
    const std::size_t before = (alignment - reinterpret_cast<std::uintptr_t>(begin) % alignment) % alignment;
    if (before > 0) munmap(begin, before);
    if (before < alignment) munmap(begin + before + size, alignment - before);
    return begin + before;
}

}  // namespace

void advise_huge(void* memory, std::size_t size) noexcept {
#if defined(MADV_HUGEPAGE)
    // The whole mapping, because mremap fails on a range that spans two mappings with different flags.
    if (size >= huge_page) madvise(memory, size, MADV_HUGEPAGE);
#else
    (void)memory;
    (void)size;
#endif
}

namespace {

/// Advice for a mapping of which the first old_size bytes were in use.
void prepare(char* memory, std::size_t old_size, std::size_t size, HugePages huge) noexcept {
#if defined(MADV_NOHUGEPAGE)
    if (huge == HugePages::later && size >= huge_page) {
        // Where one small page is present, an access brings no huge one.
        madvise(memory, size, MADV_NOHUGEPAGE);
        for (std::size_t i = old_size / huge_page * huge_page; i < size; i += huge_page) {
            (void)*static_cast<volatile char*>(memory + i);
        }
    }
#else
    (void)old_size;
    (void)huge;
#endif
    advise_huge(memory, size);
}

}  // namespace

void* map(std::size_t size, HugePages huge) noexcept {
    size = rounded_up(size, granule);
    char* const memory = take_addresses(size, PROT_READ | PROT_WRITE);
    if (memory) prepare(memory, 0, size, huge);
    return memory;
}

void* grow(void* memory, std::size_t old_size, std::size_t new_size, HugePages huge) noexcept {
    old_size = rounded_up(old_size, granule);
    new_size = rounded_up(new_size, granule);
    if (new_size == old_size) return memory;
    char* const to = take_addresses(new_size, PROT_NONE);
    if (!to) return nullptr;
    if (mremap(memory, old_size, new_size, MREMAP_MAYMOVE | MREMAP_FIXED, to) == MAP_FAILED) {
        munmap(to, new_size);
        return nullptr;
    }
    prepare(to, old_size, new_size, huge);
    return to;
}

void unmap(void* memory, std::size_t size) noexcept { munmap(memory, rounded_up(size, granule)); }

std::size_t unmap_end(void* memory, std::size_t size, std::size_t part) noexcept {
    size = rounded_up(size, granule);
    part = rounded_up(part, granule);
    const std::size_t left = size < part + least ? 0 : size - part;
    munmap(static_cast<char*>(memory) + left, size - left);
    return left;
}

#else

void advise_huge(void*, std::size_t) noexcept {}
void* map(std::size_t, HugePages) noexcept { return nullptr; }
void* grow(void*, std::size_t, std::size_t, HugePages) noexcept { return nullptr; }
void unmap(void*, std::size_t) noexcept {}
std::size_t unmap_end(void*, std::size_t, std::size_t) noexcept { return 0; }

#endif

}  // namespace gphys::pages

#include "foundation/memory.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace gphys {

namespace {

/// Trees of this size are accessed at random: with pages of 4 KiB each step would also miss the TLB.
constexpr std::size_t huge_page = std::size_t{1} << 21;

std::size_t alignment_for(std::size_t size, std::size_t alignment) {
    return size >= huge_page ? std::max(alignment, huge_page) : alignment;
}

/// Only advice; it may be ignored.
void advise(void* memory, std::size_t size) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (size >= huge_page) madvise(memory, size / huge_page * huge_page, MADV_HUGEPAGE);
#else
    (void)memory;
    (void)size;
#endif
}

}  // namespace

void* Memory::do_allocate(std::size_t size, std::size_t alignment) {
    if (!hooks_.allocate) {
        void* memory = ::operator new(size, std::align_val_t(alignment_for(size, alignment)));
        advise(memory, size);
        return memory;
    }
    void* memory = nullptr;
    try {
        memory = hooks_.allocate(hooks_.user, size, alignment);
    } catch (...) {  // counts as out of memory
    }
    if (!memory) throw std::bad_alloc();
    return memory;
}

void Memory::do_deallocate(void* memory, std::size_t size, std::size_t alignment) {
    if (hooks_.release) {
        // Called by destructors: if it throws, the memory counts as released.
        try {
            hooks_.release(hooks_.user, memory, size, alignment);
        } catch (...) {
        }
    } else {
        ::operator delete(memory, std::align_val_t(alignment_for(size, alignment)));
    }
}

}  // namespace gphys

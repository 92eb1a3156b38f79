// The allocator resource (memory.h): calls the hooks of the caller, or aligned operator new, and catches exceptions.
#include "foundation/memory.h"

#include "foundation/pages.h"

namespace gphys {
namespace {

std::size_t alignment_for(std::size_t size, std::size_t alignment) {
    return size >= pages::huge_page ? std::max(alignment, pages::huge_page) : alignment;
}

}  // namespace

void* Memory::do_allocate(std::size_t size, std::size_t alignment) {
    if (!hooks_.allocate) {
        void* memory = ::operator new(size, std::align_val_t(alignment_for(size, alignment)));
        pages::advise_huge(memory, size);
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

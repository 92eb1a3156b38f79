#include "foundation/memory.h"

namespace gphys {

void* Memory::do_allocate(std::size_t size, std::size_t alignment) {
    if (!hooks_.allocate) return ::operator new(size, std::align_val_t(alignment));
    void* memory = hooks_.allocate(hooks_.user, size, alignment);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void Memory::do_deallocate(void* memory, std::size_t size, std::size_t alignment) {
    if (hooks_.release) {
        hooks_.release(hooks_.user, memory, size, alignment);
    } else {
        ::operator delete(memory, std::align_val_t(alignment));
    }
}

}  // namespace gphys

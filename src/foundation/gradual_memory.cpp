#include "foundation/gradual_memory.h"

namespace gphys {

namespace {

constexpr std::size_t part = std::size_t{1} << 19;

}  // namespace

void* GradualMemory::do_allocate(std::size_t size, std::size_t alignment) {
    if (!is_mapped(size)) return memory_->allocate(size, alignment);
    void* const memory = pages::map(size, pages::HugePages::later);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void GradualMemory::do_deallocate(void* memory, std::size_t size, std::size_t alignment) {
    if (is_mapped(size)) {
        discard(memory, size);
    } else {
        memory_->deallocate(memory, size, alignment);
    }
}

void GradualMemory::discard(void* mapped, std::size_t size) noexcept {
    if (unused_count_ == std::size(unused_)) {
        pages::unmap(mapped, size);
    } else {
        unused_[unused_count_++] = {mapped, size};
    }
}

bool GradualMemory::unmap_part() noexcept {
    if (unused_count_ == 0) return false;
    Mapping& last = unused_[unused_count_ - 1];
    last.size = pages::unmap_end(last.memory, last.size, part);
    if (last.size == 0) --unused_count_;
    return true;
}

}  // namespace gphys

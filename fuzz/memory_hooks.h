// An allocator that counts, and that can be told to fail.
#pragma once

#include <gamephys_c.h>

#include <new>

#include "check.h"

namespace fuzz {

class MemoryHooks {
public:
    gphys_allocator hooks() { return {allocate, release, this}; }

    size_t live_bytes() const { return live_bytes_; }
    /// The next allocation but so many fails; later ones succeed.
    void fail_after(uint32_t allocations) { failing_ = allocations_ + allocations; }
    void never_fail() { failing_ = SIZE_MAX; }
    /// Whether one has failed since fail_after.
    bool has_failed() const { return failing_ != SIZE_MAX && allocations_ > failing_; }

private:
    static void* allocate(void* user, size_t size, size_t alignment) {
        MemoryHooks& self = *static_cast<MemoryHooks*>(user);
        if (self.allocations_++ == self.failing_) return nullptr;
        self.live_bytes_ += size;
        return ::operator new(size, std::align_val_t(alignment));
    }
    static void release(void* user, void* memory, size_t size, size_t alignment) {
        static_cast<MemoryHooks*>(user)->live_bytes_ -= size;
        ::operator delete(memory, std::align_val_t(alignment));
    }

    size_t live_bytes_ = 0, allocations_ = 0, failing_ = SIZE_MAX;
};

}  // namespace fuzz

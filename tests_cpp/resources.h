// Memory resources that watch the library: one counts, and fails when told to.
#pragma once

#include <memory_resource>
#include <new>

namespace test {

class WatchedMemory final : public std::pmr::memory_resource {
public:
    long allocations = 0;    // made so far
    long fail_at = -1;       // number of the allocation that fails, and all after it; -1: none
    long bytes_in_use = 0;   // 0 again when nothing leaks
    double bytes_taken = 0;  // so far, given back or not

private:
    void* do_allocate(std::size_t size, std::size_t alignment) override {
        if (fail_at >= 0 && allocations >= fail_at) throw std::bad_alloc();
        ++allocations;
        bytes_in_use += static_cast<long>(size);
        bytes_taken += static_cast<double>(size);
        return ::operator new(size, std::align_val_t(alignment));
    }
    void do_deallocate(void* memory, std::size_t size, std::size_t alignment) override {
        bytes_in_use -= static_cast<long>(size);
        ::operator delete(memory, std::align_val_t(alignment));
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
};

}  // namespace test

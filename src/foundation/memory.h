// The caller's allocator as a std::pmr resource that all containers of an object share. Hooks written in C++ may
// throw; their exceptions are caught here, because destructors call them too.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory_resource>
#include <new>
#include <utility>
#include <vector>

#include "gamephys_c.h"

namespace gphys {

template <class T>
using Vector = std::pmr::vector<T>;

class Memory final : public std::pmr::memory_resource {
public:
    explicit Memory(const gphys_allocator* hooks) {
        if (hooks) hooks_ = *hooks;
    }
    const gphys_allocator* hooks() const { return hooks_.allocate ? &hooks_ : nullptr; }

private:
    void* do_allocate(std::size_t size, std::size_t alignment) override;
    void do_deallocate(void* memory, std::size_t size, std::size_t alignment) override;
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    gphys_allocator hooks_{};
};

/// Memory for the data of one thread, at least a page away from all other data. Hardware prefetchers read ahead up to
/// the end of a page. So two threads that work in one page keep taking cache lines that the other writes to (false
/// sharing). Without the margin, ropes on two threads took 1.2 times as long.
class ThreadArena final : public std::pmr::memory_resource {
public:
    static constexpr std::size_t margin = 4096;
    /// A cache line: an aligned vector does not cross two.
    static constexpr std::size_t line = 64;

    explicit ThreadArena(std::pmr::memory_resource* memory) : memory_(memory) {}

private:
    void* do_allocate(std::size_t size, std::size_t alignment) override {
        return static_cast<std::byte*>(memory_->allocate(size + 2 * margin, std::max(alignment, line))) + margin;
    }
    void do_deallocate(void* room, std::size_t size, std::size_t alignment) override {
        memory_->deallocate(static_cast<std::byte*>(room) - margin, size + 2 * margin, std::max(alignment, line));
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    std::pmr::memory_resource* memory_;
};

/// Reserves memory for `count` more elements, so that adding them does not throw. Grows by half at least:
/// vector::reserve may allocate exactly the requested size, and repeated calls would take quadratic time.
template <class T>
void reserve_more(Vector<T>& vector, std::size_t count) {
    const std::size_t needed = vector.size() + count;
    if (needed > vector.capacity()) vector.reserve(std::max(needed, vector.capacity() + vector.capacity() / 2));
}

/// Create an object whose constructor takes (const gphys_allocator*, args...) in memory from the
/// same hooks. Throws std::bad_alloc.
template <class T, class... Args>
T* create(const gphys_allocator* hooks, Args&&... args) {
    Memory memory(hooks);
    void* place = memory.allocate(sizeof(T), alignof(T));
    try {
        return new (place) T(hooks, std::forward<Args>(args)...);
    } catch (...) {
        memory.deallocate(place, sizeof(T), alignof(T));
        throw;
    }
}

/// Destroy an object made by create; T has a member `memory` of type Memory.
template <class T>
void destroy(T* object) noexcept {
    if (!object) return;
    gphys_allocator hooks{};
    const bool hooked = object->memory.hooks() != nullptr;
    if (hooked) hooks = *object->memory.hooks();
    object->~T();
    Memory(hooked ? &hooks : nullptr).deallocate(object, sizeof(T), alignof(T));
}

}  // namespace gphys

// An array of records that may grow one by one to millions. It allocates as a Vector does, with two differences. It
// grows by an eighth, so that a scene of many models has less unused memory. And if it is large, and the caller has set
// no allocation hooks, it uses pages of the system (foundation/pages.h) and grows by remapping them. So no single call
// waits until all records are copied.
#pragma once

#include <cstring>
#include <type_traits>

#include "foundation/gradual_memory.h"

namespace gphys {

template <class T>
class LargeArray {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    using value_type = T;

    explicit LargeArray(std::pmr::memory_resource* memory) : memory_(memory) {}
    explicit LargeArray(Memory* memory) : memory_(memory), may_map_(memory->hooks() == nullptr) {}
    /// With the same source of memory.
    LargeArray(const LargeArray& other) : memory_(other.memory_), may_map_(other.may_map_) { append(other); }
    LargeArray(LargeArray&& other) noexcept : memory_(other.memory_), may_map_(other.may_map_) { swap(other); }
    LargeArray& operator=(const LargeArray& other) {
        if (this == &other) return *this;
        LargeArray copy = alike();
        copy.append(other);
        swap(copy);
        return *this;
    }
    /// Both have the same source of memory.
    LargeArray& operator=(LargeArray&& other) noexcept {
        swap(other);
        return *this;
    }
    ~LargeArray() { release(); }

    /// An empty one with the same source of memory.
    LargeArray alike() const { return LargeArray(memory_, may_map_); }
    std::pmr::memory_resource* memory() const { return memory_; }
    /// Whether large ones use pages of the system.
    bool may_map() const { return may_map_; }

    T* data() { return data_; }
    const T* data() const { return data_; }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::size_t capacity() const { return capacity_; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }

    /// Exactly `count`. If it throws std::bad_alloc, nothing has changed.
    void reserve(std::size_t count, pages::HugePages huge = pages::HugePages::at_once) {
        if (count <= capacity_) return;
        if (count > max_count) throw std::bad_alloc();
        if (may_map_ && count * sizeof(T) >= pages::least && map(count, huge)) return;
        T* const data = static_cast<T*>(memory_->allocate(count * sizeof(T), alignof(T)));
        adopt(data, count, false);
    }
    void resize(std::size_t count, const T& value = T()) {
        reserve(count);
        if (count > size_) std::uninitialized_fill(data_ + size_, data_ + count, value);
        size_ = count;
    }
    void push_back(const T& value) {
        if (size_ == capacity_) {
            const T copy = value;
            reserve_more(*this, 1);
            new (data_ + size_++) T(copy);
        } else {
            new (data_ + size_++) T(value);
        }
    }
    void clear() { size_ = 0; }
    /// Empties the array and leaves its memory to be unmapped gradually.
    void discard_to(GradualMemory& memory) noexcept {
        if (is_mapped_) {
            memory.discard(data_, capacity_ * sizeof(T));
        } else {
            release();
        }
        data_ = nullptr;
        size_ = capacity_ = 0;
        is_mapped_ = false;
    }
    void swap(LargeArray& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        std::swap(is_mapped_, other.is_mapped_);
    }

private:
    static constexpr std::size_t max_count = static_cast<std::size_t>(-1) / 2 / sizeof(T);

    LargeArray(std::pmr::memory_resource* memory, bool may_map) : memory_(memory), may_map_(may_map) {}

    void append(const LargeArray& other) {
        reserve(size_ + other.size_);
        if (other.size_ > 0) std::memcpy(static_cast<void*>(data_ + size_), other.data_, other.size_ * sizeof(T));
        size_ += other.size_;
    }
    bool map(std::size_t count, pages::HugePages huge) {
        if (is_mapped_) {
            void* const moved = pages::grow(data_, capacity_ * sizeof(T), count * sizeof(T), huge);
            if (!moved) return false;
            data_ = static_cast<T*>(moved);
            capacity_ = count;
            return true;
        }
        void* const mapped = pages::map(count * sizeof(T), huge);
        if (mapped) adopt(static_cast<T*>(mapped), count, true);
        return mapped != nullptr;
    }
    void adopt(T* data, std::size_t capacity, bool is_mapped) {
        if (size_ > 0) std::memcpy(static_cast<void*>(data), data_, size_ * sizeof(T));
        release();
        data_ = data;
        capacity_ = capacity;
        is_mapped_ = is_mapped;
    }
    void release() {
        if (is_mapped_) {
            pages::unmap(data_, capacity_ * sizeof(T));
        } else if (data_) {
            memory_->deallocate(data_, capacity_ * sizeof(T), alignof(T));
        }
    }

    std::pmr::memory_resource* memory_;
    bool may_map_ = false, is_mapped_ = false;
    T* data_ = nullptr;
    std::size_t size_ = 0, capacity_ = 0;
};

/// As that of a Vector, but by an eighth above some size.
template <class T>
void reserve_more(LargeArray<T>& array, std::size_t count) {
    constexpr std::size_t small = 1024;
    const std::size_t needed = array.size() + count, capacity = array.capacity();
    if (needed <= capacity) return;
    const std::size_t larger = capacity + capacity / (capacity < small ? 2 : 8);
    // Many additions at once may wait for huge pages; one by one none of them may.
    if (needed > larger) {
        array.reserve(needed);
    } else {
        array.reserve(larger, pages::HugePages::later);
    }
}

}  // namespace gphys

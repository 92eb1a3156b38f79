// A pool: records of one type in an array, with stable indices and a free list.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "foundation/large_array.h"

namespace gphys {

template <class T>
class Pool {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) >= sizeof(uint32_t));

public:
    template <class Source>
    explicit Pool(Source* memory) : records_(memory) {}

    /// Reserves memory so that the next `count` calls of add do not throw.
    void reserve(uint32_t count) {
        if (count > free_count_) reserve_more(records_, count - free_count_);
    }
    uint32_t add(const T& record) {
        if (free_count_ == 0) {
            records_.push_back(record);
            return static_cast<uint32_t>(records_.size() - 1);
        }
        const uint32_t index = free_;
        std::memcpy(&free_, &records_[index], sizeof free_);
        --free_count_;
        records_[index] = record;
        return index;
    }
    /// The free list is linked through the freed records.
    void remove(uint32_t index) {
        std::memcpy(static_cast<void*>(&records_[index]), &free_, sizeof free_);
        free_ = index;
        ++free_count_;
    }

    void clear() {
        records_.clear();
        free_count_ = 0;
    }

    T& operator[](uint32_t index) { return records_[index]; }
    const T& operator[](uint32_t index) const { return records_[index]; }
    uint32_t size() const { return static_cast<uint32_t>(records_.size()) - free_count_; }

private:
    LargeArray<T> records_;
    uint32_t free_ = 0, free_count_ = 0;
};

}  // namespace gphys

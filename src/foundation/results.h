// Lists of query results in an array of the caller, without allocation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>

#include "foundation/sort_distinct.h"

namespace gphys {

/// Keeps the `capacity` smallest of all values added. The array is filled first. Then it is a max-heap, and each
/// smaller value replaces its top. finish() sorts it. So the result does not depend on the order of traversal.
template <class T, class Less = std::less<T>>
class Smallest {
public:
    /// `out` may be null when `capacity` is 0: then values are only counted.
    Smallest(T* out, uint32_t capacity, Less less = {}) : out_(out), capacity_(capacity), less_(less) {}

    void add(const T& value) {
        if (total_ < capacity_) {
            out_[total_] = value;
            if (total_ + 1 == capacity_) std::make_heap(out_, out_ + capacity_, less_);
        } else if (capacity_ > 0 && less_(value, out_[0])) {
            std::pop_heap(out_, out_ + capacity_, less_);
            out_[capacity_ - 1] = value;
            std::push_heap(out_, out_ + capacity_, less_);
        }
        if (total_ < std::numeric_limits<uint32_t>::max()) ++total_;
    }

    void add_all(const T* values, uint32_t count) {
        if (total_ < capacity_ && count < capacity_ - total_) {
            std::copy_n(values, count, out_ + total_);
            total_ += count;
        } else {
            std::for_each(values, values + count, [&](const T& value) { add(value); });
        }
    }

    /// add(value) if `is_one`, without a branch. Otherwise the next element is stored unchanged, because the caller may
    /// keep data behind the results. Uses masks, because memory checkers report two exclusive ors as uninitialised.
    void add_if(bool is_one, const T& value) {
        static_assert(std::is_unsigned_v<T>);
        if (total_ + 1 < capacity_) {
            T& next = out_[total_];
            const T taken = T{0} - T{is_one};
            next = (value & taken) | (next & ~taken);
            total_ += is_one;
        } else if (is_one) {
            add(value);
        }
    }

    bool full() const { return capacity_ > 0 && total_ >= capacity_; }
    /// The value that the next smaller one would replace. Only if full().
    const T& largest() const { return out_[0]; }
    uint32_t total() const { return total_; }

    /// Sorts the kept values; returns the number of added ones (saturating). Unsigned values must differ.
    uint32_t finish() {
        const uint32_t count = std::min(total_, capacity_);
        if constexpr (std::is_same_v<T, uint32_t> && std::is_same_v<Less, std::less<T>>) {
            sort_distinct(out_, count, capacity_);
        } else {
            std::sort(out_, out_ + count, less_);
        }
        return total_;
    }

private:
    T* out_;
    uint32_t capacity_;
    uint32_t total_ = 0;
    Less less_;
};

}  // namespace gphys

// Lists of query results in an array of the caller's, of any size and without allocation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>

namespace gphys {

/// Keeps the `capacity` smallest of all values added. The array is filled first, then kept as a
/// max-heap whose top gives way to each smaller value; finish() sorts it. What is kept therefore
/// does not depend on the order in which a tree happens to deliver.
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

    bool full() const { return capacity_ > 0 && total_ >= capacity_; }
    /// The value that the next smaller one replaces; only when full.
    const T& largest() const { return out_[0]; }
    uint32_t total() const { return total_; }

    /// Sort what was kept; returns how many were added (saturating).
    uint32_t finish() {
        std::sort(out_, out_ + std::min(total_, capacity_), less_);
        return total_;
    }

private:
    T* out_;
    uint32_t capacity_;
    uint32_t total_ = 0;
    Less less_;
};

}  // namespace gphys

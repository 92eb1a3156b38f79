// Lists of query results in an array of the caller, without allocation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>

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

    /// Sorts the kept values; returns the number of added ones (saturating).
    uint32_t finish() {
        const uint32_t count = std::min(total_, capacity_);
        if constexpr (std::is_unsigned_v<T> && std::is_same_v<Less, std::less<T>>) {
            if (count <= few) {
                sort_few(count);
                return total_;
            }
        }
        std::sort(out_, out_ + count, less_);
        return total_;
    }

private:
    static constexpr uint32_t few = 32;

    /// Rank sort: each value goes to the index that is the number of smaller ones. More comparisons than std::sort, but
    /// vectorized and without branches. Equal values go to the same index; the gaps behind are then filled with copies.
    void sort_few(uint32_t count) {
        constexpr uint32_t at_once = 8;
        using Signed = std::make_signed_t<T>;  // SIMD registers compare signed integers
        constexpr T sign = T{1} << std::numeric_limits<Signed>::digits;
        Signed values[few];
        std::fill_n(values, few, std::numeric_limits<Signed>::max());
        for (uint32_t i = 0; i < count; ++i) values[i] = static_cast<Signed>(out_[i] ^ sign);
        std::fill_n(out_, count, T{0});
        const uint32_t end = (count + at_once - 1) / at_once * at_once;
        for (uint32_t i = 0; i < count; ++i) {
            uint32_t place = 0;
            for (uint32_t j = 0; j < end; ++j) place += values[j] < values[i];
            out_[place] = static_cast<T>(values[i]) ^ sign;
        }
        for (uint32_t i = 1; i < count; ++i) out_[i] = std::max(out_[i], out_[i - 1]);
    }

    T* out_;
    uint32_t capacity_;
    uint32_t total_ = 0;
    Less less_;
};

}  // namespace gphys

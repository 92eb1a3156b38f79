// Arrays of the caller whose elements are `stride` bytes apart.
#pragma once

#include <cstddef>
#include <cstdint>

#include "foundation/compiler.h"

namespace gphys {

/// Elements of the caller's array; a stride of 0 repeats the first.
template <class T>
class Strided {
public:
    Strided(const T* first, uint32_t stride) : first_(reinterpret_cast<const char*>(first)), stride_(stride) {}
    const T& operator[](uint32_t i) const {
        return *reinterpret_cast<const T*>(first_ + static_cast<size_t>(i) * stride_);
    }

    /// The first member of each element.
    template <class Part>
    Strided<Part> beginnings() const {
        return {reinterpret_cast<const Part*>(first_), static_cast<uint32_t>(stride_)};
    }

private:
    const char* first_;
    size_t stride_;
};

template <class T>
class StridedOut {
public:
    StridedOut(T* first, uint32_t stride) : first_(reinterpret_cast<char*>(first)), stride_(stride) {}
    T& operator[](uint32_t i) const { return *reinterpret_cast<T*>(first_ + static_cast<size_t>(i) * stride_); }

private:
    char* first_;
    size_t stride_;
};

/// A function of an index that prefetches the element that is read and the one that is written.
template <class In, class Out>
auto prefetch_elements(const Strided<In>& in, const StridedOut<Out>& out) {
    return [in, out](uint32_t i) {
        prefetch(&in[i]);
        prefetch_to_write(&out[i]);
    };
}

}  // namespace gphys

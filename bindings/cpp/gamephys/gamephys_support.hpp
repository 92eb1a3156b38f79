// SPDX-FileCopyrightText: 2026 The gamephys authors
// SPDX-License-Identifier: MIT
// What gamephys.hpp stands on: errors, ownership, spans.
#ifndef GAMEPHYS_SUPPORT_HPP
#define GAMEPHYS_SUPPORT_HPP

#if __cplusplus < 201703L && (!defined(_MSVC_LANG) || _MSVC_LANG < 201703L)
#error "gamephys.hpp needs C++17; gamephys_c.h needs none of it"
#endif

#include <gamephys_c.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace gamephys {

// A call failed: what() is the library's message.
class Error : public std::runtime_error {
public:
    explicit Error(gphys_status failed) : std::runtime_error(gphys_last_error()), status(failed) {}
    const gphys_status status;
};

inline void check(gphys_status status) {
    if (status == GPHYS_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status < 0) throw Error(status);
}

inline bool found(gphys_status status) {
    check(status);
    return status == GPHYS_OK;
}

// Owns one object of the library. It can be moved, and freed early with reset().
template <class T, void (*Destroy)(T*)>
class Object {
public:
    // Using an object without a handle (moved from, reset) is an error of the library: null argument.
    T* handle() const { return pointer.get(); }
    void reset() { pointer.reset(); }

protected:
    void own(T* made) { pointer.reset(made); }

private:
    struct Destroyer {
        void operator()(T* object) const { Destroy(object); }
    };
    std::unique_ptr<T, Destroyer> pointer;
};

// Of an object that may be left out, which one without a handle is not.
template <class Owner>
auto optional_handle(const Owner* object) {
    if (object && !object->handle()) throw std::invalid_argument("an object that was moved from or reset");
    return object ? object->handle() : nullptr;
}

constexpr uint32_t ANY_SIZE = 0xffffffffu;  // of what stands for each element of a batch

// What a container with contiguous elements holds, and whether that is T.
template <class C>
using ElementOf = std::remove_const_t<std::remove_pointer_t<decltype(std::declval<C&>().data())>>;
template <class C, class T>
using ElementsOf = std::enable_if_t<std::is_same_v<ElementOf<C>, std::remove_const_t<T>>>;

// Elements with any step between them, or one to read that stands for all; not the owner.
template <class T>
struct Span {
    T* data = nullptr;
    uint32_t size = 0;
    uint32_t stride = sizeof(T);  // bytes
    Span() = default;
    Span(std::nullptr_t) {}
    Span(T* first, size_t count, uint32_t step = sizeof(T))
        : data(first), size(narrow(count)), stride(step), given(first || count == 0) {}
    template <class C, class = ElementsOf<std::remove_reference_t<C>, T>>
    Span(C&& container) : Span(container.data(), container.size()) {}
    template <size_t N>
    Span(T (&array)[N]) : Span(array, N) {}
    template <class One, class = std::enable_if_t<std::is_class_v<One> && std::is_same_v<const One, T>>>
    Span(const One& element) : Span(&element, 1, 0) {}
    uint32_t sizes() const { return given && stride ? size : ANY_SIZE; }
    // Where they are, for functions that take elements only side by side.
    T* contiguous(const char* name) const {
        if (size > 1 && stride != sizeof(T)) throw std::invalid_argument(std::string(name) + " must be contiguous");
        return data;
    }

private:
    bool given = false;  // containers without elements have no data either, but are not left out

    static uint32_t narrow(size_t count) {
        if (count >= ANY_SIZE) throw std::length_error("more elements than a call takes");
        return static_cast<uint32_t>(count);
    }
};

inline uint32_t common_size(std::initializer_list<uint32_t> sizes) {
    uint32_t common = ANY_SIZE;
    for (uint32_t size : sizes) {
        if (size == ANY_SIZE) continue;
        if (common != ANY_SIZE && common != size) {
            throw std::invalid_argument("arrays of different lengths: " + std::to_string(common) + " and " +
                                        std::to_string(size));
        }
        common = size;
    }
    if (common == ANY_SIZE) throw std::invalid_argument("no array says how many there are");
    return common;
}

inline void require_size(uint32_t size, uint32_t wanted) {
    if (size != wanted) throw std::invalid_argument("the array for results has another length");
}

// A list for each element of a batch: those of element i are values[offsets[i]] to values[offsets[i + 1]].
template <class T>
struct Ragged {
    std::vector<T> values;
    std::vector<uint32_t> offsets;
};

template <class T, class Call>
std::vector<T> list(Call call) {
    std::vector<T> values(64);  // most lists are shorter; the others take a second call
    uint32_t total = 0;
    for (;;) {
        const gphys_status status = call(values.data(), static_cast<uint32_t>(values.size()), &total);
        check(status);
        values.resize(total);
        if (status != GPHYS_INCOMPLETE) return values;
    }
}

template <class T, class Call>
Ragged<T> ragged(Call call, uint32_t count) {
    Ragged<T> lists{std::vector<T>(std::max(count, 64u)), std::vector<uint32_t>(size_t(count) + 1)};
    for (;;) {
        const gphys_status status =
            call(lists.values.data(), static_cast<uint32_t>(lists.values.size()), lists.offsets.data());
        check(status);
        lists.values.resize(lists.offsets.back());
        if (status != GPHYS_INCOMPLETE) return lists;
    }
}

}  // namespace gamephys

#endif

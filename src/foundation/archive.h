// Serialization of a state as 32-bit words, for snapshots and hashes. One function visits the members, such as
// visit(archive, state) of src/solver/snapshot/snapshot.cpp; the archive it is given writes, hashes or reads them:
//
//   archive.value(x)   one value, a multiple of four bytes
//   archive.flag(b)    a bool
//   archive.array(v)   the number of elements, then the elements
//   visit_all(archive, b, v, x)   these three, by their types
//
// Words have the byte order of the machine. Structs must have no padding.
#pragma once

#include <cstring>
#include <type_traits>

#include "foundation/memory.h"
#include "foundation/word_hash.h"

namespace gphys {

struct WordCount {
    uint64_t words = 0;

    void put(const void*, size_t more) { words += more; }
};

struct WordCopy {
    uint32_t* to;

    void put(const void* from, size_t words) {
        if (words == 0) return;  // and `from` may be null
        std::memcpy(to, from, 4 * words);
        to += words;
    }
};

/// The writing archive: passes all words to one of the sinks above.
template <class Sink>
class Writer {
public:
    explicit Writer(Sink& sink) : sink_(sink) {}

    template <class T>
    void value(const T& value) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 4 == 0);
        sink_.put(&value, sizeof(T) / 4);
    }
    void flag(bool flag) { value(uint32_t{flag}); }
    template <class Array>
    void array(const Array& elements) {
        using T = typename Array::value_type;
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 4 == 0);
        value(static_cast<uint32_t>(elements.size()));
        sink_.put(elements.data(), elements.size() * (sizeof(T) / 4));
    }

private:
    Sink& sink_;
};

/// The reading archive. After the end of the words, or invalid ones, every value reads as 0 and every array as empty.
class Reader {
public:
    Reader(const uint32_t* words, size_t count) : next_(words), left_(count) {}

    template <class T>
    void value(T& value) {
        take(&value, sizeof(T) / 4);
    }
    void flag(bool& flag) {
        uint32_t word = 0;
        value(word);
        if (word > 1) left_ = 0, good_ = false;
        flag = word == 1;
    }
    template <class Array>
    void array(Array& elements) {
        using T = typename Array::value_type;
        uint32_t size = 0;
        value(size);
        if (size > left_ / (sizeof(T) / 4)) size = 0, left_ = 0, good_ = false;
        elements.resize(size);
        take(elements.data(), size * (sizeof(T) / 4));
    }

    bool good() const { return good_; }
    /// Whether all words were read and nothing failed.
    bool finished() const { return good_ && left_ == 0; }

private:
    void take(void* to, size_t words) {
        if (words > left_) left_ = 0, good_ = false;
        if (!good_ || words == 0) return;
        std::memcpy(to, next_, 4 * words);
        next_ += words;
        left_ -= words;
    }

    const uint32_t* next_;
    size_t left_;
    bool good_ = true;
};

template <class T, class = void>
constexpr bool is_array = false;
template <class T>
constexpr bool is_array<T, std::void_t<typename T::value_type>> = true;

/// Members one after the other: a bool as a flag, a vector as an array, all else as a value.
template <class Archive, class... T>
void visit_all(Archive& archive, T&... members) {
    const auto visit = [&](auto& member) {
        using Member = std::decay_t<decltype(member)>;
        if constexpr (std::is_same_v<Member, bool>) {
            archive.flag(member);
        } else if constexpr (is_array<Member>) {
            archive.array(member);
        } else {
            archive.value(member);
        }
    };
    (visit(members), ...);
}

}  // namespace gphys

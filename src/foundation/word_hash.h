// A hash of rows of 32-bit words: of states, and of what they depend on.
#pragma once

#include <cstdint>
#include <cstring>

namespace gphys {

/// A 64-bit hash of words: each is mixed in by a multiplication that loses nothing (odd) and a shift
/// that brings the high bits down; no change of a single word keeps the hash.
class WordHash {
public:
    static constexpr uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio: no pattern in its bits

    void put(const void* from, size_t words) {
        const char* bytes = static_cast<const char*>(from);
        for (size_t i = 0; i < words; ++i) {
            uint32_t word;
            std::memcpy(&word, bytes + 4 * i, 4);
            hash_ = (hash_ ^ word) * golden;
            hash_ ^= hash_ >> 32;
        }
    }
    uint64_t value() const { return hash_; }

private:
    uint64_t hash_ = golden;
};

}  // namespace gphys

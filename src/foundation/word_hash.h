// A 64-bit hash of sequences of 32-bit words, for states and snapshots. Not cryptographic.
#pragma once

#include <cstdint>
#include <cstring>

namespace gphys {

/// Each word is mixed in by an odd multiplication and a shift right, both of which are invertible, so that changing a
/// single word changes the hash.
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

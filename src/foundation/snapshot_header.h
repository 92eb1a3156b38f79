// The header of a snapshot: magic number, format, length and checksum.
#pragma once

#include <cstdint>
#include <cstring>

namespace gphys {

struct SnapshotHeader {
    uint32_t magic, format, words;
    uint32_t checksum[2];  // over the words that each kind of snapshot defines

    void set_checksum(uint64_t sum) {
        checksum[0] = static_cast<uint32_t>(sum);
        checksum[1] = static_cast<uint32_t>(sum >> 32);
    }
    bool has_checksum(uint64_t sum) const { return (uint64_t{checksum[1]} << 32 | checksum[0]) == sum; }
};
constexpr uint32_t snapshot_header_words = sizeof(SnapshotHeader) / 4;

/// Reads the header of a snapshot of one kind, of this format or an earlier one. Returns what is wrong, or nullptr. The
/// caller compares the checksum.
inline const char* read_header(const uint32_t* words, uint32_t count, uint32_t magic, uint32_t format,
                               SnapshotHeader& header) {
    if (count < snapshot_header_words) return "words: too few for a snapshot";
    std::memcpy(&header, words, sizeof header);
    const uint32_t swapped = magic >> 24 | (magic >> 8 & 0xff00) | (magic << 8 & 0xff0000) | magic << 24;
    if (header.magic == swapped) return "words: a snapshot in another byte order";
    if (header.magic != magic) return "words: not a snapshot of this kind";
    if (header.format == 0 || header.format > format) return "words: a snapshot of a later version of the library";
    if (header.words != count) return "count: not what the snapshot had";
    return nullptr;
}

}  // namespace gphys

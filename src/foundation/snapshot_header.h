// The header of a snapshot: magic number, format, length and checksum.
#pragma once

#include <cstdint>
#include <cstring>

#include "foundation/status.h"

namespace gphys {

// The kinds of snapshots.
constexpr uint32_t mesh_snapshot_magic = 0x6770686d, solver_snapshot_magic = 0x6770686e,
                   scene_snapshot_magic = 0x67706873;

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

/// What words with the magic number of another kind, or with none, are.
inline const char* wrong_kind(uint32_t magic) {
    switch (magic) {
        case mesh_snapshot_magic:
            return "words: they are a snapshot of a mesh";
        case solver_snapshot_magic:
            return "words: they are a snapshot of a solver";
        case scene_snapshot_magic:
            return "words: they are a snapshot of a scene";
        default:
            return "words: they are no snapshot, by their first word";
    }
}

/// Reads the header of a snapshot of one kind, of a format from `oldest` to `newest`. Returns what is wrong, or
/// nullptr. The caller compares the checksum.
inline const char* read_header(const uint32_t* words, uint32_t count, uint32_t magic, uint32_t oldest, uint32_t newest,
                               SnapshotHeader& header) {
    if (count < snapshot_header_words) return "count is less than the length of the header of a snapshot";
    std::memcpy(&header, words, sizeof header);
    const uint32_t swapped = magic >> 24 | (magic >> 8 & 0xff00) | (magic << 8 & 0xff0000) | magic << 24;
    if (header.magic == swapped) return "words: the byte order is not that of this machine";
    if (header.magic != magic) return wrong_kind(header.magic);
    if (header.format < oldest || header.format > newest)
        return "words: the format is not one that this version of the library reads";
    if (header.words != count) return "count is not the number of words of the snapshot";
    return nullptr;
}

/// Sets the number of all words; GPHYS_INCOMPLETE if they do not fit.
inline gphys_status fit_snapshot(uint64_t words, uint32_t capacity, uint32_t& total) {
    if (words > UINT32_MAX) return fail(GPHYS_ERROR_CAPACITY, "the snapshot would have more than 2^32 - 1 words");
    total = static_cast<uint32_t>(words);
    return total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK;
}

inline void write_header(uint32_t* out, uint32_t magic, uint32_t format, uint32_t words, uint64_t checksum) {
    SnapshotHeader header{magic, format, words, {}};
    header.set_checksum(checksum);
    std::memcpy(out, &header, sizeof header);
}

}  // namespace gphys

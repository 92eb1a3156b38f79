// Snapshots as tests take them, and as somebody else might have made them up.
#pragma once

#include "foundation/word_hash.h"
#include "solver_world.h"

namespace test {

using Words = std::vector<uint32_t>;

inline Words snapshot(const gphys_solver* solver) {
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_snapshot(solver, nullptr, 0, &total) == GPHYS_INCOMPLETE);
    Words words(total);
    REQUIRE(gphys_solver_get_snapshot(solver, words.data(), total, &total) == GPHYS_OK);
    REQUIRE(total == words.size());
    return words;
}

inline uint64_t hash(const gphys_solver* solver) {
    uint32_t halves[2];
    REQUIRE(gphys_solver_get_hash(solver, halves) == GPHYS_OK);
    return uint64_t{halves[1]} << 32 | halves[0];
}

inline gphys_status restore(gphys_solver* solver, const Words& words) {
    return gphys_solver_restore(solver, words.data(), static_cast<uint32_t>(words.size()));
}

constexpr size_t header_words = 5;

/// Gives words that were changed a header that says that they were so.
inline void mend(Words& words) {
    gphys::WordHash hash;
    hash.put(words.data() + header_words, words.size() - header_words);
    words[3] = static_cast<uint32_t>(hash.value());
    words[4] = static_cast<uint32_t>(hash.value() >> 32);
}

/// The words of a snapshot changed in one place.
inline Words forged(const Words& snapshot, size_t at, uint32_t word) {
    Words forgery = snapshot;
    forgery[at] = word;
    mend(forgery);
    return forgery;
}

}  // namespace test

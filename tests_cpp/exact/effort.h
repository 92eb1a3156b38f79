// How much is asked: GAMEPHYS_TEST=long is everything, GAMEPHYS_TEST=3/8 the third of eight parts of
// it, each with random numbers of its own, so that processors can share a long run.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace test {

struct Effort {
    bool thorough = false;
    long part = 1, parts = 1;

    Effort() {
        const char* asked = std::getenv("GAMEPHYS_TEST");
        if (!asked) return;
        if (std::sscanf(asked, "%ld/%ld", &part, &parts) == 2) {
            thorough = true;
        } else {
            part = parts = 1;
            thorough = std::strcmp(asked, "long") == 0;
        }
    }
};

/// Cases of an examination: `brief` of them in the usual run.
inline long cases(long brief, long thorough) {
    const Effort effort;
    return effort.thorough ? thorough / effort.parts : brief;
}

/// A seed for the random numbers of this part, the same as without parts for the first.
inline uint64_t seed_of_part(uint64_t seed) { return seed + 1000 * static_cast<uint64_t>(Effort().part - 1); }

}  // namespace test

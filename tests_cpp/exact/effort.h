// The number of random cases. Without GAMEPHYS_TEST a run is brief. GAMEPHYS_TEST=long has all cases. GAMEPHYS_TEST=3/8
// has the third of eight parts of these; parts have different random numbers, so several processors can share a long
// run.
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
        const char* setting = std::getenv("GAMEPHYS_TEST");
        if (!setting) return;
        if (std::sscanf(setting, "%ld/%ld", &part, &parts) == 2) {
            thorough = true;
        } else {
            part = parts = 1;
            thorough = std::strcmp(setting, "long") == 0;
        }
    }
};

/// The number of cases of an examination: `brief` in a run without GAMEPHYS_TEST.
inline long cases(long brief, long thorough) {
    const Effort effort;
    return effort.thorough ? thorough / effort.parts : brief;
}

/// The seed of this part. The first part has the seed of a run without parts.
inline uint64_t seed_of_part(uint64_t seed) { return seed + 1000 * static_cast<uint64_t>(Effort().part - 1); }

}  // namespace test

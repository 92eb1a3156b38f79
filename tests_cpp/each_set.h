// Fewer random cases for tests that run on each instruction set.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "test.h"

namespace test {

/// How many cases are tried, as tries() says; a quarter where an instruction set is asked for (GAMEPHYS_ISA), as all
/// are tried on the widest. With GAMEPHYS_TEST in the environment (ctest -C Long), all.
inline int tries_on_each_set(int all) {
    const bool fewer = std::getenv("GAMEPHYS_ISA") && !std::getenv("GAMEPHYS_TEST");
    return fewer ? std::max(1, tries(all) / 4) : tries(all);
}

}  // namespace test

// A target for libFuzzer, which looks for inputs that reach new code. A check that does not hold ends the process,
// so that the input is kept.
#include <cstdio>
#include <cstdlib>

#include "check.h"
#include "program.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    std::atexit([] {
        std::fprintf(stderr, "%s: %llu operations\n", fuzz::target_name,
                     static_cast<unsigned long long>(fuzz::session().operations));
    });
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    fuzz::Program program(bytes, size);
    try {
        fuzz::run(program);
    } catch (const fuzz::Finding& finding) {
        if (finding.ignored) return 0;
        std::fprintf(stderr, "%s: does not hold: %s\n", fuzz::target_name, finding.check);
        std::abort();
    }
    return 0;
}

#include "check.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <algorithm>
#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace fuzz {
namespace {

std::vector<std::string> ignored_by_environment() {
    std::vector<std::string> checks;
    if (const char* names = std::getenv("GAMEPHYS_FUZZ_IGNORE")) {
        std::istringstream lines(names);
        for (std::string line; std::getline(lines, line);) checks.push_back(line);
    }
    return checks;
}

std::vector<std::string>& ignored() {
    static std::vector<std::string> checks = ignored_by_environment();
    return checks;
}

/// As many game engines have it. Only on x86.
void flush_denormals([[maybe_unused]] bool flush) {
#if defined(__SSE2__)
    constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040, both = flush_to_zero | denormals_are_zero;
    _mm_setcsr(flush ? _mm_getcsr() | both : _mm_getcsr() & ~both);
#endif
}

}  // namespace

Session& session() {
    static Session the_session;
    return the_session;
}

void ignore(const std::string& check) { ignored().push_back(check); }

void found(const char* check) {
    throw Finding{check, std::find(ignored().begin(), ignored().end(), check) != ignored().end()};
}

void note_bytes(const void* bytes, size_t size) {
    uint64_t digest = session().digest;
    const char* from = static_cast<const char*>(bytes);
    for (; size >= 4; size -= 4, from += 4) {
        uint32_t word;
        std::memcpy(&word, from, 4);
        digest = (digest ^ word) * 0x9e3779b97f4a7c15;  // odd, so that no word is lost
        digest ^= digest >> 32;
    }
    session().digest = digest;
}

void check_status(gphys_status status) {
    if (session().print) {
        std::printf("  %016llx %s%s%s\n", static_cast<unsigned long long>(session().digest), gphys_status_name(status),
                    status < 0 ? ": " : "", status < 0 ? gphys_last_error() : "");
    }
    FUZZ_CHECK(status != GPHYS_ERROR_INTERNAL, "no call finds a defect of the library");
    FUZZ_CHECK(status >= GPHYS_ERROR_SINGULAR && status <= GPHYS_UNBOUNDED, "a status is one of the header's");
    if (session().exceptions && status >= 0) {
        FUZZ_CHECK(!std::fetestexcept(FE_DIVBYZERO), "valid input divides nothing by zero");
        FUZZ_CHECK(!std::fetestexcept(FE_INVALID), "valid input causes no invalid operation");
        FUZZ_CHECK(!std::fetestexcept(FE_OVERFLOW), "valid input makes nothing overflow");
    }
    if (status < 0) {
        const char* why = gphys_last_error();
        FUZZ_CHECK(why[0] != '\0' && std::strlen(why) <= 255, "an error is explained");
    }
}

void HostEnvironment::enter() {
    std::feclearexcept(FE_ALL_EXCEPT);
    if (session().rounding) std::fesetround(session().rounding);
    if (session().flush) flush_denormals(true);
}

void HostEnvironment::leave() {
    std::fesetround(FE_TONEAREST);
    if (session().flush) flush_denormals(false);
}

}  // namespace fuzz

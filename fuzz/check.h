// What all fuzz targets share: calls that are counted, checks that have names, and a digest of all answers.
//
// A target is a function run(Program&) (program.h). It makes calls of the public interface by call(), states
// what must hold by FUZZ_CHECK, and gives every answer to note(). The digest of the same program is the same on
// every instruction set, which the test compares.
#pragma once

#include <gamephys_c.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace fuzz {

/// A check that did not hold: thrown, so that objects are destroyed on the way out.
struct Finding {
    const char* check;
    bool ignored;
};

struct Session {
    uint64_t operations = 0;  // calls of the public interface
    uint64_t digest = 0;      // of the present program's answers
    bool exceptions = false;  // valid calls must not raise floating-point exceptions that hosts may trap
    int rounding = 0;         // of the host, inside calls
    bool flush = false;       // the host flushes denormal numbers to zero
    bool print = false;       // statuses, and what programs draw
};
Session& session();

/// For the time while a defect is known: a program in which this check does not hold ends without being reported.
/// The environment variable GAMEPHYS_FUZZ_IGNORE names more of them, one a line.
void ignore(const std::string& check);
/// The check does not hold.
[[noreturn]] void found(const char* check);

#define FUZZ_CHECK(condition, name)          \
    do {                                     \
        if (!(condition)) fuzz::found(name); \
    } while (0)

template <class T>
bool same_bits(const T& a, const T& b) {
    static_assert(std::is_trivially_copyable_v<T>);
    return std::memcmp(&a, &b, sizeof a) == 0;
}

void note_bytes(const void* bytes, size_t size);
/// Add an answer to the digest. T has no padding.
template <class T>
void note(const T& answer) {
    static_assert(std::is_trivially_copyable_v<T>);
    note_bytes(&answer, sizeof answer);
}

/// The floating-point environment that a call is made in; the fuzzer's own arithmetic stays in the default one.
class HostEnvironment {
public:
    HostEnvironment() {
        if (session().exceptions || is_odd()) enter();
    }
    ~HostEnvironment() {
        if (is_odd()) leave();
    }
    HostEnvironment(const HostEnvironment&) = delete;
    HostEnvironment& operator=(const HostEnvironment&) = delete;

private:
    static bool is_odd() { return session().rounding != 0 || session().flush; }
    static void enter();
    static void leave();
};

/// For as long as it is there, floating-point exceptions are no finding.
class MayRaise {
public:
    MayRaise() : before_(session().exceptions) { session().exceptions = false; }
    ~MayRaise() { session().exceptions = before_; }
    MayRaise(const MayRaise&) = delete;
    MayRaise& operator=(const MayRaise&) = delete;

private:
    bool before_;
};

/// What is true of every status: it is one of the header's, and errors are explained.
void check_status(gphys_status status);

template <class... Parameters, class... Arguments>
gphys_status call(gphys_status (*function)(Parameters...), Arguments... arguments) {
    ++session().operations;
    gphys_status status;
    {
        const HostEnvironment environment;
        status = function(arguments...);
    }
    check_status(status);
    note(status);
    return status;
}
template <class Object>
void call(void (*destroy)(Object*), Object* object) {
    ++session().operations;
    destroy(object);
}

/// An output with a known pattern, to see whether a call that fails leaves it alone.
template <class T>
struct Output {
    T value;
    T before;
    Output() {
        std::memset(static_cast<void*>(&value), 0xa5, sizeof value);
        std::memcpy(static_cast<void*>(&before), &value, sizeof value);
    }
    bool untouched() const { return same_bits(value, before); }
    /// What every function promises: written on success, untouched on an error.
    const T& after(gphys_status status) const {
        FUZZ_CHECK(status >= 0 || untouched(), "an error leaves outputs untouched");
        if (status == GPHYS_OK || status == GPHYS_INCOMPLETE) note(value);
        return value;
    }
};

}  // namespace fuzz

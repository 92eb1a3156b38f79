// For programs that measure the solver through the C interface: an error ends them, and time is that of the thread.
#pragma once

#include <time.h>

#include <cmath>
#include <stdexcept>

#include "gamephys_c.h"

inline void check(gphys_status status) {
    if (status != GPHYS_OK) throw std::runtime_error(gphys_last_error());
}

/// Processor time of the thread in seconds.
inline double now() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

constexpr float frame = 1.0f / 60;  // s

/// The time of frame i of 60 a second. Frames differ by a rounding error, so that the solver computes each: it leaves
/// out a step of the same length as the last one that would change nothing (docs/solver/rest.md).
inline float frame_time(long i) { return i % 2 == 0 ? frame : std::nextafter(frame, 1.0f); }

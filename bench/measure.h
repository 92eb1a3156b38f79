// For programs that measure the solver through the C interface: an error ends them, and time is that of the thread.
#pragma once

#include <time.h>

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

#include "foundation/status.h"

#include <cstdio>

namespace gphys {

namespace {
// A plain array: a thread_local with a destructor would keep dlclose from unloading the library.
thread_local char message_of_thread[256];
}  // namespace

gphys_status fail(gphys_status status, const char* message) noexcept {
    std::snprintf(message_of_thread, sizeof message_of_thread, "%s", message);
    return status;
}

const char* last_error() noexcept { return message_of_thread; }

}  // namespace gphys

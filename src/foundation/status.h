// How the library says no: a status, and a sentence kept for the calling thread.
#pragma once

#include "gamephys_c.h"

namespace gphys {

/// Remember the message for gphys_last_error and return the status.
gphys_status fail(gphys_status status, const char* message) noexcept;
const char* last_error() noexcept;

}  // namespace gphys

// The status of a call and the sentence that gphys_last_error returns: one message for each thread.
// Every message names a parameter; where it is about a number, it has the form "NAME VALUE is not RANGE".
#pragma once

#include <cstdint>

#include "gamephys_c.h"

namespace gphys {

/// What makes a value invalid: a number in it that is outside its range. Converts to false if there is none.
struct Defect {
    const char* field = "";       // where the number is in the value, such as ".origin"
    char axis = 0;                // 'x', 'y' or 'z' if it is a component of a vector
    double value = 0;             // the number
    const char* range = nullptr;  // what it should be; null if the value is valid

    explicit operator bool() const { return range != nullptr; }
};

/// Store the message for gphys_last_error and return the status.
gphys_status fail(gphys_status status, const char* message) noexcept;
/// With the message "name value is not range".
gphys_status fail(gphys_status status, const char* name, double value, const char* range) noexcept;
/// With the message "name<field>.axis value is not range".
gphys_status fail(gphys_status status, const char* name, const Defect& defect) noexcept;
/// With the message "array[index]<field>.axis value is not range".
gphys_status fail(gphys_status status, const char* array, uint32_t index, const Defect& defect) noexcept;

/// Put "function: " before the message of this thread. Returns the status.
gphys_status add_function_name(const char* function, gphys_status status) noexcept;

const char* last_error() noexcept;

/// Return with any status but GPHYS_OK.
#define GPHYS_TRY(expression)                      \
    do {                                           \
        const gphys_status status_ = (expression); \
        if (status_ != GPHYS_OK) return status_;   \
    } while (0)

}  // namespace gphys

// Error messages: formatting, and the message of each thread (status.h).
#include "foundation/status.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "foundation/floating_point.h"

namespace gphys {
namespace {

constexpr size_t message_size = 256;  // gphys_last_error promises at most 255 bytes

// A plain array: a thread_local with a destructor would keep dlclose from unloading the library.
thread_local char message_of_thread[message_size];

/// A number as text: integers in full, others with six digits and a point, whatever the host's locale. No comparison
/// raises FE_INVALID for NaN.
class Number {
public:
    explicit Number(double value) {
        const bool is_integer = value == std::trunc(value) && std::isless(std::fabs(value), 0x1p53);
        std::snprintf(text_, sizeof text_, is_integer ? "%.0f" : "%g", value);
        if (std::isfinite(value)) write_point();
    }
    const char* text() const { return text_; }

private:
    /// Put a point where the locale has its separator, which may take several bytes.
    void write_point() {
        const auto is_of_number = [](char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == 'e'; };
        char* const end = text_ + std::strlen(text_);
        char* const separator = std::find_if_not(text_, end, is_of_number);
        if (separator == end) return;
        *separator = '.';
        const char* const rest = std::find_if(separator + 1, end, is_of_number);
        std::memmove(separator + 1, rest, static_cast<size_t>(end + 1 - rest));
    }

    char text_[32];
};

}  // namespace

gphys_status fail(gphys_status status, const char* message) noexcept {
    std::snprintf(message_of_thread, message_size, "%s", message);
    return status;
}

gphys_status fail(gphys_status status, const char* name, double value, const char* range) noexcept {
    std::snprintf(message_of_thread, message_size, "%s %s is not %s", name, Number(value).text(), range);
    return status;
}

gphys_status fail(gphys_status status, const char* name, const Defect& defect) noexcept {
    const char axis[] = {'.', defect.axis, 0};
    std::snprintf(message_of_thread, message_size, "%s%s%s %s is not %s", name, defect.field, defect.axis ? axis : "",
                  Number(defect.value).text(), defect.range);
    return status;
}

gphys_status fail(gphys_status status, const char* array, uint32_t index, const Defect& defect) noexcept {
    char element[64];
    std::snprintf(element, sizeof element, "%s[%lu]", array, static_cast<unsigned long>(index));
    return fail(status, element, defect);
}

gphys_status add_function_name(const char* function, gphys_status status) noexcept {
    char message[message_size];
    std::memcpy(message, message_of_thread, message_size);
    std::snprintf(message_of_thread, message_size, "%s: %.200s", function, message);
    return status;
}

const char* last_error() noexcept { return message_of_thread; }

}  // namespace gphys

// What every entry point shares: checks, sized descs, strided arrays, and the wall that no
// exception passes. No algorithm lives in this folder.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>

#include "foundation/host_modes.h"
#include "foundation/math.h"
#include "foundation/status.h"
#include "foundation/strided.h"
#include "shapes/shapes.h"

namespace gphys {

inline gphys_status invalid(const char* message) noexcept { return fail(GPHYS_ERROR_INVALID_ARGUMENT, message); }

/// The whole of an entry point (tests_package/entry_points.py sees to it): its body runs in the standard
/// floating-point modes, and whatever it throws becomes a status, or ends here if it returns none.
template <class Body>
auto guarded(Body&& body) noexcept -> decltype(body()) {
    const StandardModes modes;
    try {
        return body();
    } catch (const std::bad_alloc&) {
        return static_cast<decltype(body())>(fail(GPHYS_ERROR_OUT_OF_MEMORY, "out of memory"));
    } catch (...) {
        return static_cast<decltype(body())>(fail(GPHYS_ERROR_INTERNAL, "unexpected exception"));
    }
}

#define GPHYS_REQUIRE(condition, message)                 \
    do {                                                  \
        if (!(condition)) return gphys::invalid(message); \
    } while (0)

/// Return from the entry point if the value has a defect (shapes.h).
#define GPHYS_REQUIRE_VALID(value)                                                    \
    do {                                                                              \
        if (const char* wrong_ = gphys::defect(value)) return gphys::invalid(wrong_); \
    } while (0)

/// Return from the entry point with any status but GPHYS_OK.
#define GPHYS_TRY(expression)                      \
    do {                                           \
        const gphys_status status_ = (expression); \
        if (status_ != GPHYS_OK) return status_;   \
    } while (0)

inline bool is_origin(const double* origin) {
    return std::fabs(origin[0]) <= GPHYS_MAX_COORDINATE && std::fabs(origin[1]) <= GPHYS_MAX_COORDINATE &&
           std::fabs(origin[2]) <= GPHYS_MAX_COORDINATE;
}
inline void write_origin(Vec3 from, double* to) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

inline bool is_bool(int32_t value) { return value == 0 || value == 1; }

/// Bytes between elements that are written; `name` is the parameter's.
inline gphys_status check_out_stride(const char* name, uint32_t stride, size_t element) noexcept {
    if (stride % 4 == 0 && stride >= element) return GPHYS_OK;
    char message[128];
    std::snprintf(message, sizeof message, "%s: %u is not a multiple of 4 from %u up", name,
                  static_cast<unsigned>(stride), static_cast<unsigned>(element));
    return invalid(message);
}
/// Between elements that are read: 0 repeats one.
inline gphys_status check_stride(const char* name, uint32_t stride, size_t element) noexcept {
    if (stride == 0) return GPHYS_OK;
    return check_out_stride(name, stride, element);
}
/// Several particles at one place are a mistake, so 0 does not repeat a position.
inline gphys_status check_position_stride(const char* name, uint32_t stride, uint32_t count) noexcept {
    return count <= 1 ? check_stride(name, stride, sizeof(gphys_vec3))
                      : check_out_stride(name, stride, sizeof(gphys_vec3));
}
/// There is one mesh, whatever the count.
inline gphys_status check_mesh_stride(const char* name, uint32_t stride) noexcept {
    if (stride == 0) return GPHYS_OK;
    char message[128];
    std::snprintf(message, sizeof message, "%s: %u is not 0, as for a mesh", name, static_cast<unsigned>(stride));
    return invalid(message);
}

/// A desc that uses what a later release added.
inline gphys_status newer_desc() noexcept {
    return fail(GPHYS_ERROR_STRUCT_SIZE, "desc: a field that this library does not know is set");
}

/// Copy the caller's desc over the defaults of this release. `first_size` is sizeof the desc in
/// release 1.0. Larger descs of newer clients are taken if their unknown tail is zero.
template <class Desc>
gphys_status read_desc(const Desc* from, Desc& to, size_t first_size) noexcept {
    if (!from) return GPHYS_OK;
    uint32_t size = 0;
    std::memcpy(&size, from, sizeof size);
    if (size < first_size || size > (1u << 16)) {
        return fail(GPHYS_ERROR_STRUCT_SIZE, "desc.struct_size: call the desc's init function first");
    }
    const unsigned char* bytes = reinterpret_cast<const unsigned char*>(from);
    for (size_t i = sizeof(Desc); i < size; ++i) {
        if (bytes[i] != 0) return newer_desc();
    }
    std::memcpy(&to, from, size < sizeof(Desc) ? size : sizeof(Desc));
    to.struct_size = sizeof(Desc);
    return GPHYS_OK;
}

/// The desc at the beginning of an element of an array, `to` has the defaults. Elements may be larger than the desc is
/// here, and aligned as their stride is only. `too_small` says that the stride is below the size of a desc.
template <class Desc>
gphys_status read_desc_element(const char* element, size_t stride, Desc& to, size_t first_size,
                               const char* too_small) noexcept {
    uint32_t size = 0;
    std::memcpy(&size, element, sizeof size);
    if (size > stride) return invalid(too_small);
    for (size_t i = sizeof(Desc); i < size; ++i) {
        if (element[i] != 0) return newer_desc();
    }
    Desc aligned{};
    std::memcpy(&aligned, element, size < sizeof(Desc) ? size : sizeof(Desc));
    aligned.struct_size = size < sizeof(Desc) ? size : sizeof(Desc);
    return read_desc(&aligned, to, first_size);
}

/// Give the caller, whose desc has `size` bytes, the defaults. Never writes past `size`.
template <class Desc>
gphys_status write_desc(Desc* to, uint32_t size, Desc defaults, size_t first_size) noexcept {
    if (!to) return invalid("desc is null");
    if (size < first_size || size > (1u << 16)) return fail(GPHYS_ERROR_STRUCT_SIZE, "size: pass sizeof of the desc");
    std::memset(to, 0, size);
    defaults.struct_size = size;
    std::memcpy(to, &defaults, size < sizeof(Desc) ? size : sizeof(Desc));
    return GPHYS_OK;
}

/// The hooks must come as a pair.
inline const char* defect(const gphys_allocator* allocator) {
    return allocator && (!allocator->allocate || !allocator->release)
               ? "allocator: allocate and release must both be set"
               : nullptr;
}

}  // namespace gphys

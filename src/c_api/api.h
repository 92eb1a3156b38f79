// What all entry points share: the guard against exceptions, argument checks, and sized descs. This folder checks,
// converts, calls and converts back; it has no algorithms.
//
// Messages: a null pointer is "NAME is null", a number or id out of range is "NAME VALUE is not RANGE", a limit is "the
// OBJECT would have more than LIMIT", all else "NAME: SENTENCE". guarded() puts the name of the entry point before
// them.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <new>
#include <type_traits>

#include "foundation/compiler.h"
#include "foundation/host_modes.h"
#include "foundation/math.h"
#include "foundation/status.h"
#include "foundation/strided.h"
#include "foundation/workers.h"
#include "shapes/shapes.h"

namespace gphys {

inline gphys_status invalid(const char* message) noexcept { return fail(GPHYS_ERROR_INVALID_ARGUMENT, message); }

/// The whole of an entry point (tests_package/entry_points.py checks this). The body runs in the standard
/// floating-point modes. An exception becomes a status, or is dropped if the body returns void. Messages of errors
/// get the prefix "function: ".
template <class Body>
auto guarded(const char* function, Body&& body) noexcept -> decltype(body()) {
    const StandardModes modes;
    using Result = decltype(body());
    gphys_status status;
    try {
        if constexpr (std::is_void_v<Result>) {
            return body();
        } else {
            status = body();
        }
    } catch (const std::bad_alloc&) {
        status = fail(GPHYS_ERROR_OUT_OF_MEMORY, "out of memory");
    } catch (...) {
        status = fail(GPHYS_ERROR_INTERNAL, "unexpected exception");
    }
    if (status < 0) add_function_name(function, status);
    return static_cast<Result>(status);
}

#define GPHYS_REQUIRE(condition, message)                 \
    do {                                                  \
        if (!(condition)) return gphys::invalid(message); \
    } while (0)

/// Return from the entry point, with the message "name value is not range", unless the condition holds.
#define GPHYS_REQUIRE_IN_RANGE(condition, name, value, range)                                                        \
    do {                                                                                                             \
        if (!(condition)) return gphys::fail(GPHYS_ERROR_INVALID_ARGUMENT, name, static_cast<double>(value), range); \
    } while (0)

/// Return from the entry point if one of the parameters is null: GPHYS_REQUIRE_POINTERS(scene, ray).
#define GPHYS_REQUIRE_POINTERS(...) GPHYS_TRY(gphys::check_pointers(#__VA_ARGS__, __VA_ARGS__))

/// Return from the entry point if the parameter has a defect (shapes.h): GPHYS_REQUIRE_VALID(*ray).
#define GPHYS_REQUIRE_VALID(value) GPHYS_TRY(gphys::check_valid(#value[0] == '*' ? &#value[1] : #value, value))

/// Both, for a pointer to one value: GPHYS_REQUIRE_INPUT(ray).
#define GPHYS_REQUIRE_INPUT(pointer) GPHYS_TRY(gphys::check_input(#pointer, pointer))

/// `names` are those of the pointers, separated by ", ".
GPHYS_NOINLINE inline gphys_status name_null_pointer(const char* names,
                                                     std::initializer_list<const void*> pointers) noexcept {
    for (const void* pointer : pointers) {
        const char* end = std::strchr(names, ',');
        if (!pointer) {
            const int length = static_cast<int>(end ? end - names : std::strlen(names));
            char message[128];
            std::snprintf(message, sizeof message, "%.*s is null", length, names);
            return invalid(message);
        }
        if (end) names = end + 2;
    }
    return GPHYS_OK;
}
template <class... T>
gphys_status check_pointers(const char* names, const T*... pointers) noexcept {
    return ((pointers != nullptr) && ...) ? GPHYS_OK : name_null_pointer(names, {pointers...});
}

template <class T>
gphys_status check_valid(const char* name, const T& value) noexcept {
    const Defect wrong = defect(value);
    return wrong ? fail(GPHYS_ERROR_INVALID_ARGUMENT, name, wrong) : GPHYS_OK;
}
template <class T>
gphys_status check_input(const char* name, const T* value) noexcept {
    GPHYS_TRY(check_pointers(name, value));
    return check_valid(name, *value);
}
template <class T>
gphys_status check_element(const char* array, uint32_t index, const T& value) noexcept {
    const Defect wrong = defect(value);
    return wrong ? fail(GPHYS_ERROR_INVALID_ARGUMENT, array, index, wrong) : GPHYS_OK;
}

// The ranges that many parameters share.
constexpr char coordinate_range[] = "from -1e15 to 1e15";
constexpr char amount_range[] = "from 0 to 1e15";
constexpr char positive_range[] = "above 0 and at most 1e15";

inline bool is_coordinate(float value) { return std::fabs(value) <= GPHYS_MAX_COORDINATE; }
inline gphys_status check_coordinate(const char* name, float value) noexcept {
    GPHYS_REQUIRE_IN_RANGE(is_coordinate(value), name, value, coordinate_range);
    return GPHYS_OK;
}

inline gphys_status check_origin(const double* origin) noexcept {
    for (uint32_t k = 0; k < 3; ++k) {
        if (!(std::fabs(origin[k]) <= GPHYS_MAX_COORDINATE)) {
            return fail(GPHYS_ERROR_INVALID_ARGUMENT, "origin", k, Defect{"", 0, origin[k], coordinate_range});
        }
    }
    return GPHYS_OK;
}
/// `elements` is the name of the parameter with ".m".
inline gphys_status check_matrix(const char* elements, const gphys_mat4& matrix) noexcept {
    for (uint32_t i = 0; i < 16; ++i) {
        if (!std::islessequal(std::fabs(matrix.m[i]), GPHYS_MAX_COORDINATE)) {
            return fail(GPHYS_ERROR_INVALID_ARGUMENT, elements, i, Defect{"", 0, matrix.m[i], coordinate_range});
        }
    }
    return GPHYS_OK;
}
inline void write_origin(Vec3 from, double* to) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

inline gphys_status check_bool(const char* name, int32_t value) noexcept {
    GPHYS_REQUIRE_IN_RANGE(value == 0 || value == 1, name, value, "0 or 1");
    return GPHYS_OK;
}
inline gphys_status check_depth_range(const char* name, gphys_depth_range value) noexcept {
    GPHYS_REQUIRE_IN_RANGE(value == GPHYS_DEPTH_ZERO_TO_ONE || value == GPHYS_DEPTH_MINUS_ONE_TO_ONE, name, value,
                           "a gphys_depth_range");
    return GPHYS_OK;
}
/// The corners of a rectangle in an image.
inline gphys_status check_rectangle(float x0, float y0, float x1, float y1) noexcept {
    GPHYS_TRY(check_coordinate("x0", x0));
    GPHYS_TRY(check_coordinate("y0", y0));
    GPHYS_TRY(check_coordinate("x1", x1));
    GPHYS_TRY(check_coordinate("y1", y1));
    GPHYS_REQUIRE(x0 != x1 && y0 != y1, "x0, y0, x1, y1: the rectangle has no area");
    return GPHYS_OK;
}

/// The distance between elements; `name` is the parameter's.
inline gphys_status check_spacing(const char* name, uint32_t stride, size_t element) noexcept {
    GPHYS_REQUIRE_IN_RANGE(stride % 4 == 0, name, stride, "a multiple of 4");
    if (stride >= element) return GPHYS_OK;
    char range[64];
    std::snprintf(range, sizeof range, "at least %u, the size of an element", static_cast<unsigned>(element));
    return fail(GPHYS_ERROR_INVALID_ARGUMENT, name, stride, range);
}
// An array without elements needs no stride, as it needs no pointer.

/// The stride of an array that is written.
inline gphys_status check_out_stride(const char* name, uint32_t stride, size_t element, uint32_t count) noexcept {
    return count == 0 ? GPHYS_OK : check_spacing(name, stride, element);
}
/// The output array of a batch.
template <class T>
gphys_status check_outputs(const char* name, const T* outputs, uint32_t stride, uint32_t count) {
    if (count != 0) GPHYS_TRY(check_pointers(name, outputs));
    return check_out_stride("out_stride", stride, sizeof(T), count);
}
/// The stride of an array that is read: 0 repeats the first element.
inline gphys_status check_stride(const char* name, uint32_t stride, size_t element, uint32_t count) noexcept {
    return stride == 0 ? GPHYS_OK : check_out_stride(name, stride, element, count);
}
/// 0 does not repeat a position: several particles at one place are a mistake.
inline gphys_status check_position_stride(const char* name, uint32_t stride, uint32_t count) noexcept {
    return count <= 1 ? check_stride(name, stride, sizeof(gphys_vec3), count)
                      : check_spacing(name, stride, sizeof(gphys_vec3));
}
/// A batch has one mesh, whatever its count.
inline gphys_status check_mesh_stride(const char* name, uint32_t stride) noexcept {
    GPHYS_REQUIRE_IN_RANGE(stride == 0, name, stride, "0, which a mesh needs");
    return GPHYS_OK;
}

/// For a desc that uses fields of a later release.
inline gphys_status newer_desc() noexcept {
    return fail(GPHYS_ERROR_STRUCT_SIZE, "desc: a field of a later release of the library is not 0");
}

/// Copy the caller's desc over the defaults of this release. `first_size` is the size of the desc in
/// release 1.0. Larger descs of newer clients are accepted if their unknown tail is zero.
template <class Desc>
gphys_status read_desc(const Desc* from, Desc& to, size_t first_size) noexcept {
    if (!from) return GPHYS_OK;
    uint32_t size = 0;
    std::memcpy(&size, from, sizeof size);
    if (size < first_size || size > (1u << 16)) {
        return fail(GPHYS_ERROR_STRUCT_SIZE, "desc.struct_size", size, "the size that the desc's init function sets");
    }
    const unsigned char* bytes = reinterpret_cast<const unsigned char*>(from);
    for (size_t i = sizeof(Desc); i < size; ++i) {
        if (bytes[i] != 0) return newer_desc();
    }
    std::memcpy(&to, from, size < sizeof(Desc) ? size : sizeof(Desc));
    to.struct_size = sizeof(Desc);
    return GPHYS_OK;
}

/// Read the desc at the beginning of an element of an array over the defaults in `to`. Elements may be larger than the
/// desc of this release. They are aligned to 4 bytes only, hence the copy.
template <class Desc>
gphys_status read_desc_element(const char* element, const char* stride_name, size_t stride, Desc& to,
                               size_t first_size) noexcept {
    uint32_t size = 0;
    std::memcpy(&size, element, sizeof size);
    GPHYS_REQUIRE_IN_RANGE(size <= stride, stride_name, stride, "at least the struct_size of the desc");
    for (size_t i = sizeof(Desc); i < size; ++i) {
        if (element[i] != 0) return newer_desc();
    }
    Desc aligned{};
    std::memcpy(&aligned, element, size < sizeof(Desc) ? size : sizeof(Desc));
    aligned.struct_size = size < sizeof(Desc) ? size : sizeof(Desc);
    return read_desc(&aligned, to, first_size);
}

/// Write the defaults into the caller's desc of `size` bytes. Never writes past `size`.
template <class Desc>
gphys_status write_desc(Desc* desc, uint32_t size, Desc defaults, size_t first_size) noexcept {
    GPHYS_REQUIRE_POINTERS(desc);
    if (size < first_size || size > (1u << 16)) {
        return fail(GPHYS_ERROR_STRUCT_SIZE, "size", size, "the size of the desc");
    }
    std::memset(desc, 0, size);
    defaults.struct_size = size;
    std::memcpy(desc, &defaults, size < sizeof(Desc) ? size : sizeof(Desc));
    return GPHYS_OK;
}

/// The functions of an allocator come as a pair.
inline gphys_status check_allocator(const gphys_allocator* allocator) noexcept {
    GPHYS_REQUIRE(!allocator || allocator->allocate, "desc.allocator->allocate is null");
    GPHYS_REQUIRE(!allocator || allocator->release, "desc.allocator->release is null");
    return GPHYS_OK;
}
inline gphys_status check_task_runner(const gphys_task_runner* runner) noexcept {
    GPHYS_REQUIRE(!runner || runner->run, "desc.task_runner->run is null");
    return GPHYS_OK;
}
inline gphys_status check_worker_count(const char* name, uint32_t count) noexcept {
    GPHYS_REQUIRE_IN_RANGE(count <= Workers::max_count, name, count, "at most 1024");
    return GPHYS_OK;
}

}  // namespace gphys

// Reading a caller's shape by its type, and the results that batches hold for a miss.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "c_api/api.h"
#include "geometry/intersect.h"

namespace gphys {

class Mesh;

/// The parameters of an entry point that give a shape, for messages.
struct ShapeNames {
    const char* type = "type";
    const char* shape = "shape";
};

/// Calls visit(name, struct) for a caller's shape, or otherwise() for a mesh and unknown types, which have no struct.
template <class Visit, class Otherwise>
auto visit_struct(gphys_shape_type type, const void* shape, const Visit& visit, const Otherwise& otherwise) {
    switch (type) {
        case GPHYS_SHAPE_SPHERE:
            return visit("sphere", static_cast<const gphys_sphere*>(shape));
        case GPHYS_SHAPE_CAPSULE:
            return visit("capsule", static_cast<const gphys_capsule*>(shape));
        case GPHYS_SHAPE_AABB:
            return visit("aabb", static_cast<const gphys_aabb*>(shape));
        case GPHYS_SHAPE_OBB:
            return visit("obb", static_cast<const gphys_obb*>(shape));
        case GPHYS_SHAPE_PLANE:
            return visit("plane", static_cast<const gphys_plane*>(shape));
        case GPHYS_SHAPE_TRIANGLE:
            return visit("triangle", static_cast<const gphys_triangle*>(shape));
        case GPHYS_SHAPE_FRUSTUM:
            return visit("frustum", static_cast<const gphys_frustum*>(shape));
        case GPHYS_SHAPE_RAY:
            return visit("ray", static_cast<const gphys_ray*>(shape));
        case GPHYS_SHAPE_SEGMENT:
            return visit("segment", static_cast<const gphys_segment*>(shape));
        default:
            return otherwise();
    }
}

/// Check a caller's shape and widen it. type: any primitive of Shape.
/// @return GPHYS_ERROR_UNSUPPORTED for a ray, segment or mesh; GPHYS_ERROR_INVALID_ARGUMENT for
///         null, an unknown type and a defect
gphys_status read_shape(gphys_shape_type type, const void* shape, Shape& out, ShapeNames names = {}) noexcept;
/// A mesh if that is not null, else a primitive.
struct ShapeOrMesh {
    Shape shape;
    const Mesh* mesh = nullptr;
};
/// @return as read_shape, but a mesh is accepted too
gphys_status read_shape(gphys_shape_type type, const void* shape, ShapeOrMesh& out, ShapeNames names = {}) noexcept;
/// A shape that moves.
/// @return as read_shape; GPHYS_ERROR_UNSUPPORTED for all but a sphere, capsule, AABB or OBB
gphys_status read_moving(gphys_shape_type type, const void* shape, Shape& out, ShapeNames names = {}) noexcept;
/// Size of the public struct in bytes; 0 for a mesh and for unknown types.
size_t shape_struct_size(gphys_shape_type type) noexcept;

/// The shapes of one side of a batch of pairs: Read is Shape for those that move, else ShapeOrMesh. With a stride of 0
/// the only shape is read and checked once.
template <class Read>
class Shapes {
public:
    Shapes(ShapeNames names, gphys_shape_type type, const void* first, uint32_t stride)
        : names_(names), type_(type), first_(first), stride_(stride) {}

    gphys_status check(const char* stride_name, uint32_t count) {
        if (count == 0) return GPHYS_OK;
        GPHYS_TRY(type_ == GPHYS_SHAPE_MESH ? check_mesh_stride(stride_name, stride_)
                                            : check_stride(stride_name, stride_, shape_struct_size(type_), count));
        if (stride_ == 0) return read(0);
        for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(read(i));
        return GPHYS_OK;
    }
    /// Calls check(element) for each; only after check.
    template <class Check>
    gphys_status check_each(uint32_t count, const Check& check) {
        if (stride_ == 0) count = std::min(count, 1u);
        for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(check((*this)[i]));
        return GPHYS_OK;
    }
    /// Element i; only after check.
    const Read& operator[](uint32_t i) {
        if (stride_ != 0) read(i);
        return current_;
    }

private:
    gphys_status read(uint32_t i) {
        const char* const first = static_cast<const char*>(first_);
        const void* const at = first ? first + size_t{stride_} * i : nullptr;
        if constexpr (std::is_same_v<Read, Shape>) {
            return read_moving(type_, at, current_, names_);
        } else {
            return read_shape(type_, at, current_, names_);
        }
    }

    ShapeNames names_;
    gphys_shape_type type_;
    const void* first_;
    uint32_t stride_;
    Read current_;
};

/// The floats at the beginning of a ray or segment that say where it goes.
constexpr uint32_t ray_coordinates = 6;

/// What a batch holds for a miss: t = INFINITY, no triangle, the rest 0.
inline constexpr gphys_hit no_hit{0, 0, std::numeric_limits<float>::infinity(), {}, {}, GPHYS_NO_TRIANGLE, 0, 0, 0};
/// What a batch holds for shapes that do not overlap: depth = -INFINITY, no triangle, the rest 0.
inline constexpr gphys_penetration no_penetration{
    0, 0, {}, {}, -std::numeric_limits<float>::infinity(), GPHYS_NO_TRIANGLE};
/// What a batch holds if there is no nearest model: distance = INFINITY, no triangle, the rest 0.
inline constexpr gphys_nearest no_nearest{0, 0, {}, std::numeric_limits<float>::infinity(), GPHYS_NO_TRIANGLE};

}  // namespace gphys

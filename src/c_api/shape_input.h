// Reading a caller's shape, and the results that batches hold where nothing is found.
#pragma once

#include <limits>

#include "c_api/api.h"
#include "geometry/intersect.h"

namespace gphys {

class Mesh;

/// Check a caller's shape and widen it. type: any primitive of Shape.
/// @return GPHYS_ERROR_UNSUPPORTED for a ray, segment or mesh; GPHYS_ERROR_INVALID_ARGUMENT for
///         null, an unknown type and a defect
gphys_status read_shape(gphys_shape_type type, const void* shape, Shape& out) noexcept;
/// A primitive or, if not null, a mesh.
struct ShapeOrMesh {
    Shape shape;
    const Mesh* mesh = nullptr;
};
/// @return as read_shape, but a mesh is taken too
gphys_status read_shape(gphys_shape_type type, const void* shape, ShapeOrMesh& out) noexcept;
/// A shape that moves.
/// @return as read_shape; GPHYS_ERROR_UNSUPPORTED for what is no sphere, capsule, AABB or OBB
gphys_status read_moving(gphys_shape_type type, const void* shape, Shape& out) noexcept;
/// Bytes of the public struct; 0 for a mesh and for unknown types.
size_t shape_struct_size(gphys_shape_type type) noexcept;

/// Rays and segments begin with so many floats that tell where they go.
constexpr uint32_t ray_coordinates = 6;

/// What a batch holds for a miss: t = INFINITY, no triangle, the rest 0.
inline constexpr gphys_hit no_hit{0, 0, std::numeric_limits<float>::infinity(), {}, {}, GPHYS_NO_TRIANGLE, 0, 0, 0};
/// What a batch holds where nothing is near: distance = INFINITY, no triangle, the rest 0.
inline constexpr gphys_nearest no_nearest{0, 0, {}, std::numeric_limits<float>::infinity(), GPHYS_NO_TRIANGLE};

}  // namespace gphys

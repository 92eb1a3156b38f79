// The scale per axis of a model's shape, applied in the model's frame before its transform. Children do not inherit it:
// they inherit the transform, which has one scale, so that no shape is ever sheared.
//
// Boxes and triangles are stored scaled, with each number rounded to float32 once; queries read the scaled shape. Other
// primitives allow only three equal numbers, since an ellipsoid or a skewed capsule is no shape of the library. A mesh
// is stored unscaled beside its scale; queries scale what they read (mesh_place.h), so that models share it.
#pragma once

#include "mesh/mesh.h"

namespace gphys {

constexpr gphys_vec3 no_scale{1, 1, 1};
constexpr bool is_one(const gphys_vec3& scale) { return scale.x == 1 && scale.y == 1 && scale.z == 1; }

/// The stored shape of a model that is a mesh.
struct ModelMesh {
    ModelMesh() = default;
    ModelMesh(const Mesh* m, const gphys_vec3& s) : mesh(m), scale(s), is_scaled(!is_one(s)) {}

    const Mesh* mesh = nullptr;
    gphys_vec3 scale = no_scale;
    uint32_t is_scaled = 0;

    AxisScale axes() const { return is_scaled ? AxisScale(widen(scale)) : AxisScale(); }
};

/// The largest component or inverse of one.
inline float largest_factor(const gphys_vec3& scale) {
    const AxisScale axes(widen(scale));
    return round_up(std::max(axes.largest(), 1 / axes.least()));
}

/// Each number from 1 / GPHYS_MAX_COORDINATE to GPHYS_MAX_COORDINATE.
Defect defect_of_scale(const gphys_vec3& scale);

// Scaled shapes. The result is valid if check_scale returns no error.

gphys_sphere scaled(const gphys_sphere& sphere, const gphys_vec3& scale);
gphys_capsule scaled(const gphys_capsule& capsule, const gphys_vec3& scale);
gphys_aabb scaled(const gphys_aabb& box, const gphys_vec3& scale);
gphys_obb scaled(const gphys_obb& box, const gphys_vec3& scale);
gphys_plane scaled(const gphys_plane& plane, const gphys_vec3& scale);
gphys_triangle scaled(const gphys_triangle& triangle, const gphys_vec3& scale);

/// Why a shape cannot have a scale, with the status to return.
struct ScaleError {
    gphys_status status = GPHYS_OK;
    const char* why = nullptr;

    explicit operator bool() const { return why != nullptr; }
};
/// For a public struct of the type, or a Mesh.
ScaleError check_scale(gphys_shape_type type, const void* shape, const gphys_vec3& scale);
/// For the present vertices of a mesh.
ScaleError check_scale(const Mesh& mesh, const gphys_vec3& scale);

/// The bounding sphere of a scaled mesh, in floats, rounded outward.
gphys_sphere ball_around(const Mesh& mesh, const AxisScale& axes);

}  // namespace gphys

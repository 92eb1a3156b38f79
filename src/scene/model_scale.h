// The scale per axis of a model's own shape: applied in the model's frame, before its transform. It is not inherited:
// children see the transform only, which has one scale, so that no shape is ever sheared.
//
// A box, or a triangle, is stored as what the scale makes of it, each number rounded to float32 once: queries see
// another box. Other primitives are scaled in the same way by three equal numbers; else they would be no shape that
// there is. A mesh keeps its scale beside it and is scaled as it is asked (mesh_place.h).
#pragma once

#include "mesh/mesh.h"

namespace gphys {

constexpr gphys_vec3 no_scale{1, 1, 1};
constexpr bool is_one(const gphys_vec3& scale) { return scale.x == 1 && scale.y == 1 && scale.z == 1; }

/// What a model that is a mesh stores.
struct ModelMesh {
    ModelMesh() = default;
    ModelMesh(const Mesh* m, const gphys_vec3& s) : mesh(m), scale(s), is_scaled(!is_one(s)) {}

    const Mesh* mesh = nullptr;
    gphys_vec3 scale = no_scale;
    uint32_t is_scaled = 0;

    AxisScale axes() const { return is_scaled ? AxisScale(widen(scale)) : AxisScale(); }
};

/// The largest number or inverse.
inline float width_of(const gphys_vec3& scale) {
    const AxisScale axes(widen(scale));
    return round_up(std::max(axes.largest(), 1 / axes.least()));
}

/// Each number from 1 / GPHYS_MAX_COORDINATE to GPHYS_MAX_COORDINATE.
Defect defect_of_scale(const gphys_vec3& scale);

// Shapes of a model, scaled. The result is valid unless refusal_of_scale says otherwise.

gphys_sphere scaled(const gphys_sphere& sphere, const gphys_vec3& scale);
gphys_capsule scaled(const gphys_capsule& capsule, const gphys_vec3& scale);
gphys_aabb scaled(const gphys_aabb& box, const gphys_vec3& scale);
gphys_obb scaled(const gphys_obb& box, const gphys_vec3& scale);
gphys_plane scaled(const gphys_plane& plane, const gphys_vec3& scale);
gphys_triangle scaled(const gphys_triangle& triangle, const gphys_vec3& scale);

/// Why a shape cannot have a scale, and the status for that.
struct ScaleRefusal {
    gphys_status status = GPHYS_OK;
    const char* why = nullptr;

    explicit operator bool() const { return why != nullptr; }
};
/// Of a shape, or a mesh, of the type.
ScaleRefusal refusal_of_scale(gphys_shape_type type, const void* shape, const gphys_vec3& scale);
/// Of a mesh as it is now.
ScaleRefusal refusal_of_scale(const Mesh& mesh, const gphys_vec3& scale);

/// The ball around a scaled mesh, in floats, rounded outward.
gphys_sphere ball_around(const Mesh& mesh, const AxisScale& axes);

}  // namespace gphys

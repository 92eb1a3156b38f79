// gphys_shape_sweep, gphys_shape_penetration and their batches: solids that move against shapes or meshes.
#include "c_api/shape_input.h"
#include "foundation/results.h"
#include "mesh/mesh.h"

namespace gphys {
namespace {

constexpr ShapeNames moving_names{"moving_type", "moving"};

bool sweep(const ShapeOrMesh& other, const Shape& moving, Vec3 displacement, gphys_hit& out) {
    Hit hit;
    const bool found =
        other.mesh ? other.mesh->sweep(moving, displacement, hit) : sweep(other.shape, moving, displacement, hit);
    if (found) out = to_contact(hit, displacement);
    return found;
}

bool penetration(const ShapeOrMesh& other, const Shape& moving, gphys_penetration& out) {
    if (!other.mesh) {
        if (!overlaps(other.shape, moving)) return false;
        out = to_penetration(penetration(other.shape, moving));
        return true;
    }
    gphys_penetration found;
    Smallest<gphys_penetration, DeepestFirst> deepest(&found, 1);
    other.mesh->for_each_penetration(
        moving, [&](const Penetration& way, uint32_t triangle) { deepest.add(to_penetration(way, triangle)); });
    if (deepest.total() > 0) out = found;
    return deepest.total() > 0;
}

/// Of a frustum, which is met as the hull of its corners.
gphys_status check_corners(const ShapeOrMesh& other) {
    if (is_hexahedron(std::get<Frustum>(other.shape))) return GPHYS_OK;
    return fail(GPHYS_ERROR_UNSUPPORTED, "type: the frustum is not the convex hull of eight corners");
}

}  // namespace
}  // namespace gphys

using namespace gphys;

gphys_status gphys_shape_sweep(gphys_shape_type type, const void* shape, gphys_shape_type moving_type,
                               const void* moving, const gphys_vec3* displacement, gphys_hit* out_hit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(displacement, out_hit);
        ShapeOrMesh other;
        Shape solid;
        GPHYS_TRY(read_shape(type, shape, other));
        GPHYS_TRY(read_moving(moving_type, moving, solid, moving_names));
        if (type == GPHYS_SHAPE_FRUSTUM && moving_type != GPHYS_SHAPE_SPHERE) GPHYS_TRY(check_corners(other));
        GPHYS_REQUIRE_VALID(*displacement);
        return sweep(other, solid, widen(*displacement), *out_hit) ? GPHYS_OK : GPHYS_NO_HIT;
    });
}

gphys_status gphys_shape_sweep_batch(gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                                     gphys_shape_type moving_type, const void* moving, uint32_t moving_stride,
                                     const gphys_vec3* displacements, uint32_t displacement_stride, uint32_t count,
                                     gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        if (count != 0) GPHYS_REQUIRE_POINTERS(displacements, out_hits);
        GPHYS_TRY(check_stride("displacement_stride", displacement_stride, sizeof *displacements, count));
        GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof *out_hits, count));
        Shapes<ShapeOrMesh> other({"type", "shapes"}, type, shapes, shape_stride);
        Shapes<Shape> solid(moving_names, moving_type, moving, moving_stride);
        GPHYS_TRY(other.check("shape_stride", count));
        GPHYS_TRY(solid.check("moving_stride", count));
        if (type == GPHYS_SHAPE_FRUSTUM && moving_type != GPHYS_SHAPE_SPHERE)
            GPHYS_TRY(other.check_each(count, check_corners));
        const Strided<gphys_vec3> displacement(displacements, displacement_stride);
        for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(check_element("displacements", i, displacement[i]));
        const StridedOut<gphys_hit> out(out_hits, out_stride);
        for (uint32_t i = 0; i < count; ++i) {
            if (!sweep(other[i], solid[i], widen(displacement[i]), out[i])) out[i] = no_hit;
        }
        return GPHYS_OK;
    });
}

gphys_status gphys_shape_penetration(gphys_shape_type type, const void* shape, gphys_shape_type moving_type,
                                     const void* moving, gphys_penetration* out_penetration) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(out_penetration);
        ShapeOrMesh other;
        Shape solid;
        GPHYS_TRY(read_shape(type, shape, other));
        GPHYS_TRY(read_moving(moving_type, moving, solid, moving_names));
        if (type == GPHYS_SHAPE_FRUSTUM) GPHYS_TRY(check_corners(other));
        return penetration(other, solid, *out_penetration) ? GPHYS_OK : GPHYS_NO_HIT;
    });
}

gphys_status gphys_shape_penetration_batch(gphys_shape_type type, const void* shapes, uint32_t shape_stride,
                                           gphys_shape_type moving_type, const void* moving, uint32_t moving_stride,
                                           uint32_t count, gphys_penetration* out_penetrations, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_outputs("out_penetrations", out_penetrations, out_stride, count));
        Shapes<ShapeOrMesh> other({"type", "shapes"}, type, shapes, shape_stride);
        Shapes<Shape> solid(moving_names, moving_type, moving, moving_stride);
        GPHYS_TRY(other.check("shape_stride", count));
        GPHYS_TRY(solid.check("moving_stride", count));
        if (type == GPHYS_SHAPE_FRUSTUM) GPHYS_TRY(other.check_each(count, check_corners));
        const StridedOut<gphys_penetration> out(out_penetrations, out_stride);
        for (uint32_t i = 0; i < count; ++i) {
            if (!penetration(other[i], solid[i], out[i])) out[i] = no_penetration;
        }
        return GPHYS_OK;
    });
}

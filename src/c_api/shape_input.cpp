// Reads and checks shapes of the caller (shape_input.h).
#include "c_api/shape_input.h"

#include "c_api/handles.h"

namespace gphys {

namespace {

template <class Public>
gphys_status read(const char* name, const void* shape, Shape& out) {
    const Public& value = *static_cast<const Public*>(shape);
    GPHYS_TRY(check_valid(name, value));
    out = widen(value);
    return GPHYS_OK;
}

}  // namespace

gphys_status read_shape(gphys_shape_type type, const void* shape, Shape& out, ShapeNames names) noexcept {
    GPHYS_TRY(check_pointers(names.shape, shape));
    switch (type) {
        case GPHYS_SHAPE_SPHERE:
            return read<gphys_sphere>("sphere", shape, out);
        case GPHYS_SHAPE_CAPSULE:
            return read<gphys_capsule>("capsule", shape, out);
        case GPHYS_SHAPE_AABB:
            return read<gphys_aabb>("aabb", shape, out);
        case GPHYS_SHAPE_OBB:
            return read<gphys_obb>("obb", shape, out);
        case GPHYS_SHAPE_PLANE:
            return read<gphys_plane>("plane", shape, out);
        case GPHYS_SHAPE_TRIANGLE:
            return read<gphys_triangle>("triangle", shape, out);
        case GPHYS_SHAPE_FRUSTUM:
            return read<gphys_frustum>("frustum", shape, out);
        case GPHYS_SHAPE_MESH:
        case GPHYS_SHAPE_RAY:
        case GPHYS_SHAPE_SEGMENT:
            return fail(GPHYS_ERROR_UNSUPPORTED, names.type, type,
                        "a shape that this function takes (no mesh, ray or segment)");
        default:
            return fail(GPHYS_ERROR_INVALID_ARGUMENT, names.type, type, "a gphys_shape_type");
    }
}

gphys_status read_moving(gphys_shape_type type, const void* shape, Shape& out, ShapeNames names) noexcept {
    GPHYS_TRY(read_shape(type, shape, out, names));
    const bool moves = type == GPHYS_SHAPE_SPHERE || type == GPHYS_SHAPE_CAPSULE || type == GPHYS_SHAPE_AABB ||
                       type == GPHYS_SHAPE_OBB;
    return moves ? GPHYS_OK : fail(GPHYS_ERROR_UNSUPPORTED, names.type, type, "a sphere, capsule, AABB or OBB");
}

gphys_status read_shape(gphys_shape_type type, const void* shape, ShapeOrMesh& out, ShapeNames names) noexcept {
    if (type != GPHYS_SHAPE_MESH) return read_shape(type, shape, out.shape, names);
    GPHYS_TRY(check_pointers(names.shape, shape));
    out.mesh = unwrap(static_cast<const gphys_mesh*>(shape));
    return GPHYS_OK;
}

size_t shape_struct_size(gphys_shape_type type) noexcept {
    switch (type) {
        case GPHYS_SHAPE_SPHERE:
            return sizeof(gphys_sphere);
        case GPHYS_SHAPE_CAPSULE:
            return sizeof(gphys_capsule);
        case GPHYS_SHAPE_AABB:
            return sizeof(gphys_aabb);
        case GPHYS_SHAPE_OBB:
            return sizeof(gphys_obb);
        case GPHYS_SHAPE_PLANE:
            return sizeof(gphys_plane);
        case GPHYS_SHAPE_TRIANGLE:
            return sizeof(gphys_triangle);
        case GPHYS_SHAPE_FRUSTUM:
            return sizeof(gphys_frustum);
        case GPHYS_SHAPE_RAY:
            return sizeof(gphys_ray);
        case GPHYS_SHAPE_SEGMENT:
            return sizeof(gphys_segment);
        default:
            return 0;
    }
}

}  // namespace gphys

// Reads and checks shapes of the caller (shape_input.h).
#include "c_api/shape_input.h"

#include "c_api/handles.h"

namespace gphys {

gphys_status read_shape(gphys_shape_type type, const void* shape, Shape& out, ShapeNames names) noexcept {
    GPHYS_TRY(check_pointers(names.shape, shape));
    const auto reject = [&] {
        const bool known = type == GPHYS_SHAPE_MESH || type == GPHYS_SHAPE_RAY || type == GPHYS_SHAPE_SEGMENT;
        return known ? fail(GPHYS_ERROR_UNSUPPORTED, names.type, type,
                            "a shape that this function takes (no mesh, ray or segment)")
                     : fail(GPHYS_ERROR_INVALID_ARGUMENT, names.type, type, "a gphys_shape_type");
    };
    const auto read = [&](const char* name, const auto* from) -> gphys_status {
        if constexpr (std::is_assignable_v<Shape&, decltype(widen(*from))>) {
            GPHYS_TRY(check_valid(name, *from));
            out = widen(*from);
            return GPHYS_OK;
        } else {
            return reject();
        }
    };
    return visit_struct(type, shape, read, reject);
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
    return visit_struct(
        type, nullptr, [](const char*, const auto* from) { return sizeof *from; }, [] { return size_t{0}; });
}

}  // namespace gphys

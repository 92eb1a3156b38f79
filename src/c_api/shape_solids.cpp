// gphys_shape_sweep and gphys_shape_penetration: a solid that moves against one shape or mesh.
#include "c_api/shape_input.h"
#include "foundation/results.h"
#include "mesh/mesh.h"

namespace gphys {
namespace {

struct Pair {
    ShapeOrMesh other;
    Shape moving;
};

gphys_status read_pair(gphys_shape_type type, const void* shape, gphys_shape_type moving_type, const void* moving,
                       Pair& out) {
    GPHYS_TRY(read_shape(type, shape, out.other));
    return read_moving(moving_type, moving, out.moving, {"moving_type", "moving"});
}

bool sweep(const Pair& pair, Vec3 displacement, Hit& hit) {
    return pair.other.mesh ? pair.other.mesh->sweep(pair.moving, displacement, hit)
                           : sweep(pair.other.shape, pair.moving, displacement, hit);
}

bool penetration(const Pair& pair, gphys_penetration& out) {
    if (!pair.other.mesh) {
        if (!overlaps(pair.other.shape, pair.moving)) return false;
        out = to_penetration(penetration(pair.other.shape, pair.moving));
        return true;
    }
    Smallest<gphys_penetration, DeepestFirst> deepest(&out, 1);
    pair.other.mesh->for_each_penetration(
        pair.moving, [&](const Penetration& way, uint32_t triangle) { deepest.add(to_penetration(way, triangle)); });
    return deepest.total() > 0;
}

}  // namespace
}  // namespace gphys

using namespace gphys;

gphys_status gphys_shape_sweep(gphys_shape_type type, const void* shape, gphys_shape_type moving_type,
                               const void* moving, const gphys_vec3* displacement, gphys_hit* out_hit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(displacement, out_hit);
        Pair pair;
        GPHYS_TRY(read_pair(type, shape, moving_type, moving, pair));
        if (type == GPHYS_SHAPE_FRUSTUM && moving_type != GPHYS_SHAPE_SPHERE) {
            return fail(GPHYS_ERROR_UNSUPPORTED, "type: only a sphere can be swept against a frustum");
        }
        GPHYS_REQUIRE_VALID(*displacement);
        Hit hit;
        if (!sweep(pair, widen(*displacement), hit)) return GPHYS_NO_HIT;
        *out_hit = to_contact(hit, widen(*displacement));
        return GPHYS_OK;
    });
}

gphys_status gphys_shape_penetration(gphys_shape_type type, const void* shape, gphys_shape_type moving_type,
                                     const void* moving, gphys_penetration* out_penetration) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(out_penetration);
        Pair pair;
        GPHYS_TRY(read_pair(type, shape, moving_type, moving, pair));
        if (type == GPHYS_SHAPE_FRUSTUM)
            return fail(GPHYS_ERROR_UNSUPPORTED, "type: there is no penetration into a frustum");
        gphys_penetration found;
        if (!penetration(pair, found)) return GPHYS_NO_HIT;
        *out_penetration = found;
        return GPHYS_OK;
    });
}

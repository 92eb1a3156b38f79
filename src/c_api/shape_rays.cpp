// gphys_shape_*: rays, segments and swept spheres against one shape or mesh.
#include "c_api/mesh_tiles.h"
#include "c_api/shape_input.h"
#include "foundation/compiler.h"

namespace gphys {
namespace {

gphys_status cast(const ShapeOrMesh& target, const Ray& ray, gphys_hit& out) {
    if (target.mesh) return target.mesh->raycast(ray, out) ? GPHYS_OK : GPHYS_NO_HIT;
    Hit hit;
    if (!raycast(target.shape, ray, hit)) return GPHYS_NO_HIT;
    out = to_hit(hit);
    return GPHYS_OK;
}

void raycast_by_tiles(const Mesh& mesh, const Strided<gphys_ray>& ray, uint32_t count,
                      const StridedOut<gphys_hit>& out) {
    cast_at_mesh(ray, count, out, [&](const gphys_ray* const* rays, const uint32_t* items, uint32_t size) {
        gphys_hit* hits[ImageTiles::most];
        for (uint32_t k = 0; k < size; ++k) hits[k] = &out[items[k]];
        const uint64_t found = mesh.raycast_many(rays, size, hits);
        for (uint32_t k = 0; k < size; ++k) {
            if ((found >> k & 1) == 0) *hits[k] = no_hit;
        }
    });
}

bool sweep(const ShapeOrMesh& target, const Sphere& moving, Vec3 displacement, Hit& hit) {
    return target.mesh ? target.mesh->sweep(moving, displacement, hit) : sweep(target.shape, moving, displacement, hit);
}

}  // namespace
}  // namespace gphys

using namespace gphys;

gphys_status gphys_shape_raycast(gphys_shape_type type, const void* shape, const gphys_ray* ray, gphys_hit* out_hit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(ray, out_hit);
        ShapeOrMesh target;
        GPHYS_TRY(read_shape(type, shape, target));
        GPHYS_REQUIRE_VALID(*ray);
        return cast(target, widen(*ray), *out_hit);
    });
}

gphys_status gphys_shape_raycast_batch(gphys_shape_type type, const void* shape, const gphys_ray* rays,
                                       uint32_t ray_stride, uint32_t count, gphys_hit* out_hits, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        if (count != 0) GPHYS_REQUIRE_POINTERS(rays, out_hits);
        GPHYS_TRY(check_stride("ray_stride", ray_stride, sizeof(gphys_ray), count));
        GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof(gphys_hit), count));
        ShapeOrMesh target;
        GPHYS_TRY(read_shape(type, shape, target));
        const Strided<gphys_ray> each(rays, ray_stride);
        const StridedOut<gphys_hit> out(out_hits, out_stride);
        for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(check_element("rays", i, each[i]));
        if (target.mesh) {
            raycast_by_tiles(*target.mesh, each, count, out);
            return GPHYS_OK;
        }
        for (uint32_t i = 0; i < count; ++i) {
            Hit hit;
            out[i] = raycast(target.shape, widen(each[i]), hit) ? to_hit(hit) : no_hit;
        }
        return GPHYS_OK;
    });
}

gphys_status gphys_shape_segment_test(gphys_shape_type type, const void* shape, const gphys_segment* segment,
                                      gphys_hit* out_hit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(segment, out_hit);
        ShapeOrMesh target;
        GPHYS_TRY(read_shape(type, shape, target));
        GPHYS_REQUIRE_VALID(*segment);
        return cast(target, ray_along(widen(*segment)), *out_hit);
    });
}

gphys_status gphys_shape_sweep_sphere(gphys_shape_type type, const void* shape, const gphys_sphere* sphere,
                                      const gphys_vec3* displacement, gphys_hit* out_hit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(sphere, displacement, out_hit);
        ShapeOrMesh target;
        GPHYS_TRY(read_shape(type, shape, target));
        GPHYS_REQUIRE_VALID(*sphere);
        GPHYS_REQUIRE_VALID(*displacement);
        Hit hit;
        if (!sweep(target, widen(*sphere), widen(*displacement), hit)) return GPHYS_NO_HIT;
        *out_hit = to_contact(hit, widen(*displacement));
        return GPHYS_OK;
    });
}

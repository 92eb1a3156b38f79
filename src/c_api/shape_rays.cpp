// Rays, segments and sweeps against one shape or mesh.
#include "c_api/shape_input.h"
#include "mesh/mesh.h"

namespace gphys {
namespace {

bool raycast(const ShapeOrMesh& target, const Ray& ray, Hit& hit) {
    return target.mesh ? target.mesh->raycast(ray, hit) : raycast(target.shape, ray, hit);
}

bool sweep(const ShapeOrMesh& target, const Sphere& moving, Vec3 displacement, Hit& hit) {
    return target.mesh ? target.mesh->sweep(moving, displacement, hit) : sweep(target.shape, moving, displacement, hit);
}

}  // namespace
}  // namespace gphys

using namespace gphys;

gphys_status gphys_shape_raycast(gphys_shape_type type, const void* shape, const gphys_ray* ray, gphys_hit* out_hit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(ray && out_hit, "ray or out_hit is null");
        ShapeOrMesh target;
        GPHYS_TRY(read_shape(type, shape, target));
        GPHYS_REQUIRE_VALID(*ray);
        Hit hit;
        if (!raycast(target, widen(*ray), hit)) return GPHYS_NO_HIT;
        *out_hit = to_hit(hit);
        return GPHYS_OK;
    });
}

gphys_status gphys_shape_raycast_batch(gphys_shape_type type, const void* shape, const gphys_ray* rays,
                                       uint32_t ray_stride, uint32_t count, gphys_hit* out_hits, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE((rays && out_hits) || count == 0, "rays or out_hits is null");
        GPHYS_REQUIRE(valid_stride(ray_stride, sizeof(gphys_ray)), "ray_stride");
        GPHYS_REQUIRE(valid_out_stride(out_stride, sizeof(gphys_hit)), "out_stride");
        ShapeOrMesh target;
        GPHYS_TRY(read_shape(type, shape, target));
        const Strided<gphys_ray> each(rays, ray_stride);
        const StridedOut<gphys_hit> out(out_hits, out_stride);
        for (uint32_t i = 0; i < count; ++i) GPHYS_REQUIRE_VALID(each[i]);
        if (target.mesh) {
            gphys_hit* hits[Mesh::rays_at_once];
            for (uint32_t first = 0; first < count; first += Mesh::rays_at_once) {
                const uint32_t size = std::min(count - first, Mesh::rays_at_once);
                for (uint32_t i = 0; i < size; ++i) hits[i] = &out[first + i];
                const uint64_t found = target.mesh->raycast_many(&each[first], ray_stride, size, hits);
                for (uint32_t i = 0; i < size; ++i) {
                    if ((found >> i & 1) == 0) *hits[i] = no_hit;
                }
            }
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
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(segment && out_hit, "segment or out_hit is null");
        ShapeOrMesh target;
        GPHYS_TRY(read_shape(type, shape, target));
        GPHYS_REQUIRE_VALID(*segment);
        Hit hit;
        if (!raycast(target, ray_along(widen(*segment)), hit)) return GPHYS_NO_HIT;
        *out_hit = to_hit(hit);
        return GPHYS_OK;
    });
}

gphys_status gphys_shape_sweep_sphere(gphys_shape_type type, const void* shape, const gphys_sphere* sphere,
                                      const gphys_vec3* displacement, gphys_hit* out_hit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(sphere && displacement && out_hit, "sphere, displacement or out_hit is null");
        ShapeOrMesh target;
        GPHYS_TRY(read_shape(type, shape, target));
        GPHYS_REQUIRE_VALID(*sphere);
        GPHYS_REQUIRE_VALID(*displacement);
        Hit hit;
        if (!sweep(target, widen(*sphere), widen(*displacement), hit)) return GPHYS_NO_HIT;
        *out_hit = to_hit(hit);
        return GPHYS_OK;
    });
}

// gphys_shape_* and others about the data of single shapes: validity, bounds, transforms, corners, intersections of
// planes. Queries are in shape_queries.cpp, shape_rays.cpp and shape_solids.cpp.
#include "c_api/handles.h"
#include "c_api/shape_input.h"
#include "camera/projection.h"
#include "mesh/mesh.h"
#include "shapes/halfspaces.h"

namespace gphys {
namespace {

gphys_ray narrow(const Ray& r) { return {narrow(r.origin), narrow(r.direction), static_cast<float>(r.t_max)}; }
gphys_segment narrow(const Segment& s) { return {narrow(s.a), narrow(s.b)}; }
gphys_sphere narrow(const Sphere& s) { return {narrow(s.center), static_cast<float>(s.radius)}; }
gphys_capsule narrow(const Capsule& c) { return {narrow(c.a), narrow(c.b), static_cast<float>(c.radius)}; }
gphys_obb narrow(const Obb& b) { return {narrow(b.center), narrow(b.half), narrow(quaternion(b.axes))}; }
gphys_triangle narrow(const Triangle& t) { return {narrow(t.a), narrow(t.b), narrow(t.c)}; }

/// Call visit with the public struct of the type, if it is valid. A mesh has no struct.
template <class Visit>
gphys_status with_struct(gphys_shape_type type, const void* shape, Visit&& visit) {
    GPHYS_REQUIRE_POINTERS(shape);
    const auto checked = [&](const char* name, const auto* value) -> gphys_status {
        GPHYS_TRY(check_valid(name, *value));
        return visit(*value);
    };
    return visit_struct(type, shape, checked, [&] {
        return type == GPHYS_SHAPE_MESH
                   ? fail(GPHYS_ERROR_UNSUPPORTED, "type", type, "a shape that this function takes (no mesh)")
                   : fail(GPHYS_ERROR_INVALID_ARGUMENT, "type", type, "a gphys_shape_type");
    });
}

/// False if the shape is infinite.
template <class S>
bool bounds_of(const S& shape, Box& out) {
    out = bounds(shape);
    return true;
}
bool bounds_of(const Plane&, Box&) { return false; }
bool bounds_of(const Frustum& frustum, Box& out) { return bounds(frustum, out); }
bool bounds_of(const Ray& ray, Box& out) { return bounds(ray, out); }

gphys_status write_bounds(const Box& box, gphys_aabb* out) {
    if (box.min[0] > box.max[0]) return GPHYS_NO_HIT;
    *out = narrow(box);
    return GPHYS_OK;
}

}  // namespace
}  // namespace gphys

using namespace gphys;

gphys_status gphys_shape_validate(gphys_shape_type type, const void* shape) {
    return guarded(__func__, [&] {
        if (type == GPHYS_SHAPE_MESH && shape) return gphys_status{GPHYS_OK};
        return with_struct(type, shape, [](const auto&) { return gphys_status{GPHYS_OK}; });
    });
}

gphys_status gphys_shape_bounds(gphys_shape_type type, const void* shape, gphys_aabb* out_bounds) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(shape, out_bounds);
        if (type == GPHYS_SHAPE_MESH) {
            return write_bounds(unwrap(static_cast<const gphys_mesh*>(shape))->bounds(), out_bounds);
        }
        return with_struct(type, shape, [&](const auto& value) -> gphys_status {
            Box box;
            return bounds_of(widen(value), box) ? write_bounds(box, out_bounds) : gphys_status{GPHYS_UNBOUNDED};
        });
    });
}

gphys_status gphys_shape_transform(gphys_shape_type type, const void* shape, const gphys_transform* transform,
                                   void* out_shape) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(transform, out_shape);
        return with_struct(type, shape, [&](const auto& value) -> gphys_status {
            GPHYS_REQUIRE_VALID(*transform);
            const auto result = narrow(transformed(widen(value), widen(*transform)));
            GPHYS_TRY(check_valid("transformed shape", result));
            std::memcpy(out_shape, &result, sizeof result);
            return GPHYS_OK;
        });
    });
}

gphys_status gphys_frustum_corners(const gphys_frustum* frustum, gphys_vec3 out_corners[8]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(frustum, out_corners);
        GPHYS_REQUIRE_VALID(*frustum);
        Vec3 corner[8];
        if (!corners(widen(*frustum), corner)) return GPHYS_UNBOUNDED;
        for (int i = 0; i < 8; ++i) out_corners[i] = narrow(corner[i]);
        return GPHYS_OK;
    });
}

namespace {

bool intersection(const gphys_plane& a, const gphys_plane& b, const gphys_plane& c, gphys_vec3& out) {
    Vec3 point;
    if (!common_point(widen(a), widen(b), widen(c), point)) return false;
    if (max_component(abs(point)) > GPHYS_MAX_COORDINATE) return false;
    out = narrow(point);
    return true;
}

}  // namespace

gphys_status gphys_planes_intersection(const gphys_plane* a, const gphys_plane* b, const gphys_plane* c,
                                       gphys_vec3* out_point) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(a, b, c, out_point);
        GPHYS_REQUIRE_VALID(*a);
        GPHYS_REQUIRE_VALID(*b);
        GPHYS_REQUIRE_VALID(*c);
        return intersection(*a, *b, *c, *out_point) ? GPHYS_OK : GPHYS_NO_HIT;
    });
}

gphys_status gphys_planes_intersection_batch(const gphys_plane* a, uint32_t a_stride, const gphys_plane* b,
                                             uint32_t b_stride, const gphys_plane* c, uint32_t c_stride, uint32_t count,
                                             gphys_vec3* out_points, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        if (count == 0) return GPHYS_OK;
        GPHYS_REQUIRE_POINTERS(a, b, c, out_points);
        GPHYS_TRY(check_stride("a_stride", a_stride, sizeof *a, count));
        GPHYS_TRY(check_stride("b_stride", b_stride, sizeof *b, count));
        GPHYS_TRY(check_stride("c_stride", c_stride, sizeof *c, count));
        GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof *out_points, count));
        const Strided<gphys_plane> all_a(a, a_stride), all_b(b, b_stride), all_c(c, c_stride);
        for (uint32_t i = 0; i < count; ++i) {
            GPHYS_TRY(check_element("a", i, all_a[i]));
            GPHYS_TRY(check_element("b", i, all_b[i]));
            GPHYS_TRY(check_element("c", i, all_c[i]));
        }
        const StridedOut<gphys_vec3> out(out_points, out_stride);
        for (uint32_t i = 0; i < count; ++i) {
            gphys_vec3 point{INFINITY, INFINITY, INFINITY};
            intersection(all_a[i], all_b[i], all_c[i], point);
            out[i] = point;
        }
        return GPHYS_OK;
    });
}

gphys_status gphys_mat4_orthonormality(const gphys_mat4* matrix, float* out_deviation) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(matrix, out_deviation);
        GPHYS_TRY(check_matrix("matrix.m", *matrix));
        *out_deviation = static_cast<float>(orthonormality(widen(*matrix)));
        return GPHYS_OK;
    });
}

gphys_status gphys_frustum_from_matrix(const gphys_mat4* view_projection, gphys_depth_range depth_range,
                                       int32_t reverse_z, gphys_frustum* out_frustum) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(view_projection, out_frustum);
        GPHYS_TRY(check_depth_range("depth_range", depth_range));
        GPHYS_TRY(check_bool("reverse_z", reverse_z));
        GPHYS_TRY(check_matrix("view_projection.m", *view_projection));
        UserProjection projection{widen(*view_projection), {}};
        if (!inverse(projection.to_clip, projection.from_clip))
            return fail(GPHYS_ERROR_SINGULAR, "view_projection: the matrix has no inverse");
        Frustum frustum;
        const DepthRange depths(depth_range, reverse_z != 0);
        projection.planes(depths, Window(), frustum.planes);
        const gphys_frustum result = narrow(frustum);
        if (defect(result) || !projection.has_near_corners(depths))
            return fail(GPHYS_ERROR_SINGULAR, "view_projection: the frustum has no volume");
        *out_frustum = result;
        return GPHYS_OK;
    });
}

gphys_status gphys_segment_closest_points(const gphys_segment* a, const gphys_segment* b, gphys_vec3* out_a,
                                          gphys_vec3* out_b, float* out_distance) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(a, b);
        GPHYS_REQUIRE_VALID(*a);
        GPHYS_REQUIRE_VALID(*b);
        Vec3 on_a, on_b;
        closest_points(widen(*a), widen(*b), on_a, on_b);
        if (out_a) *out_a = narrow(on_a);
        if (out_b) *out_b = narrow(on_b);
        if (out_distance) *out_distance = static_cast<float>(distance(on_a, on_b));
        return GPHYS_OK;
    });
}

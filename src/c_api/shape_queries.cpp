// gphys_shape_*: queries with a point and a shape, and with two shapes.
#include "c_api/shape_input.h"
#include "mesh/closest_search.h"

namespace gphys {
namespace {

/// All shapes that a point can be tested against.
using Target = std::variant<Shape, Ray, Segment, const Mesh*>;

gphys_status read_target(gphys_shape_type type, const void* shape, Target& out) {
    const auto read_line = [&](const char* name, const auto* line) -> gphys_status {
        GPHYS_REQUIRE_POINTERS(shape);
        GPHYS_TRY(check_valid(name, *line));
        out = widen(*line);
        return GPHYS_OK;
    };
    if (type == GPHYS_SHAPE_RAY) return read_line("ray", static_cast<const gphys_ray*>(shape));
    if (type == GPHYS_SHAPE_SEGMENT) return read_line("segment", static_cast<const gphys_segment*>(shape));
    ShapeOrMesh read;
    GPHYS_TRY(read_shape(type, shape, read));
    out = read.mesh ? Target(read.mesh) : Target(read.shape);
    return GPHYS_OK;
}

bool contains(const Shape& shape, Vec3 point, double tolerance) {
    return std::visit([&](const auto& s) { return contains(s, point, tolerance); }, shape);
}
bool contains(const Mesh* mesh, Vec3 point, double tolerance) {
    if (mesh->is_hull() && tolerance == 0) return mesh->contains(point);
    return mesh->overlaps(Sphere{point, tolerance});
}
bool contains(const Target& target, Vec3 point, double tolerance) {
    return std::visit([&](const auto& t) { return contains(t, point, tolerance); }, target);
}

/// For shapes that are never empty. Computed relative to the point, so that a small distance far from the origin
/// loses no digits.
template <class S>
bool nearest(const S& shape, Vec3 point, gphys_nearest& out) {
    const Vec3 offset = closest_point(relative_to(point, shape), {});
    out = to_nearest(point + offset, length(offset));
    return true;
}
bool nearest(const Frustum& frustum, Vec3 point, gphys_nearest& out) {
    Vec3 offset;
    if (!closest_point(relative_to(point, frustum), {}, offset)) return false;
    out = to_nearest(point + offset, length(offset));
    return true;
}
bool nearest(const Mesh* mesh, Vec3 point, gphys_nearest& out) {
    Vec3 closest;
    uint32_t triangle = GPHYS_NO_TRIANGLE;
    if (!mesh->closest_point(point, infinity, closest, triangle)) return false;
    out = to_nearest(closest, distance(closest, point), triangle);
    return true;
}
bool nearest(const Shape& shape, Vec3 point, gphys_nearest& out) {
    return std::visit([&](const auto& s) { return nearest(s, point, out); }, shape);
}
bool nearest(const Target& target, Vec3 point, gphys_nearest& out) {
    return std::visit([&](const auto& t) { return nearest(t, point, out); }, target);
}

/// out[i] for points[i]; no_nearest if there is none.
void nearest_many(const Mesh& mesh, const Strided<gphys_vec3>& points, uint32_t count,
                  const StridedOut<gphys_nearest>& out) {
    constexpr uint32_t at_once = Mesh::points_at_once;
    for (uint32_t first = 0; first < count; first += at_once) {
        const uint32_t size = std::min(at_once, count - first);
        Vec3 from[at_once];
        for (uint32_t k = 0; k < size; ++k) {
            from[k] = widen(points[first + k]);
            out[first + k] = no_nearest;
        }
        mesh.closest_point_many(from, size, [&](uint32_t k, Vec3 closest, uint32_t triangle) {
            out[first + k] = to_nearest(closest, distance(closest, from[k]), triangle);
        });
    }
}
void nearest_many(const Target& target, const Strided<gphys_vec3>& points, uint32_t count,
                  const StridedOut<gphys_nearest>& out) {
    for (uint32_t i = 0; i < count; ++i) {
        if (!nearest(target, widen(points[i]), out[i])) out[i] = no_nearest;
    }
}

bool overlaps(const ShapeOrMesh& a, const ShapeOrMesh& b) {
    if (a.mesh) return b.mesh ? a.mesh->overlaps(*b.mesh) : a.mesh->overlaps(b.shape);
    return b.mesh ? b.mesh->overlaps(a.shape) : overlaps(a.shape, b.shape);
}

gphys_status check_points(const gphys_vec3* points, uint32_t stride, uint32_t count) {
    GPHYS_TRY(check_stride("point_stride", stride, sizeof(gphys_vec3), count));
    const Strided<gphys_vec3> each(points, stride);
    for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(check_element("points", i, each[i]));
    return GPHYS_OK;
}

/// A shape that can be classified against a plane or frustum: no plane, frustum or mesh.
gphys_status read_classifiable(gphys_shape_type type, const void* shape, Shape& out) {
    if (type == GPHYS_SHAPE_PLANE || type == GPHYS_SHAPE_FRUSTUM) {
        return fail(GPHYS_ERROR_UNSUPPORTED, "type", type, "a shape that can be classified (no plane or frustum)");
    }
    return read_shape(type, shape, out);
}

gphys_status contains_batch(gphys_shape_type type, const void* shape, const gphys_vec3* points, uint32_t point_stride,
                            uint32_t count, float tolerance, int32_t* out_contains, uint32_t out_stride) {
    if (count != 0) GPHYS_REQUIRE_POINTERS(points, out_contains);
    GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof(int32_t), count));
    GPHYS_REQUIRE_IN_RANGE(std::isgreaterequal(tolerance, 0.0f) && tolerance <= GPHYS_MAX_COORDINATE, "tolerance",
                           tolerance, amount_range);
    Target target;
    GPHYS_TRY(read_target(type, shape, target));
    GPHYS_TRY(check_points(points, point_stride, count));
    const Strided<gphys_vec3> each(points, point_stride);
    const StridedOut<int32_t> out(out_contains, out_stride);
    for (uint32_t i = 0; i < count; ++i) out[i] = contains(target, widen(each[i]), tolerance);
    return GPHYS_OK;
}

gphys_status overlaps_batch(gphys_shape_type a_type, const void* a, uint32_t a_stride, gphys_shape_type b_type,
                            const void* b, uint32_t b_stride, uint32_t count, int32_t* out_overlaps,
                            uint32_t out_stride) {
    GPHYS_TRY(check_outputs("out_overlaps", out_overlaps, out_stride, count));
    Shapes<ShapeOrMesh> first({"a_type", "a"}, a_type, a, a_stride), second({"b_type", "b"}, b_type, b, b_stride);
    GPHYS_TRY(first.check("a_stride", count));
    GPHYS_TRY(second.check("b_stride", count));
    const StridedOut<int32_t> out(out_overlaps, out_stride);
    for (uint32_t i = 0; i < count; ++i) out[i] = overlaps(first[i], second[i]);
    return GPHYS_OK;
}

}  // namespace
}  // namespace gphys

using namespace gphys;

gphys_status gphys_shape_contains(gphys_shape_type type, const void* shape, const gphys_vec3* point, float tolerance,
                                  int32_t* out_contains) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(point, out_contains);
        return contains_batch(type, shape, point, 0, 1, tolerance, out_contains, sizeof *out_contains);
    });
}

gphys_status gphys_shape_contains_batch(gphys_shape_type type, const void* shape, const gphys_vec3* points,
                                        uint32_t point_stride, uint32_t count, float tolerance, int32_t* out_contains,
                                        uint32_t out_stride) {
    return guarded(__func__, [&] {
        return contains_batch(type, shape, points, point_stride, count, tolerance, out_contains, out_stride);
    });
}

gphys_status gphys_shape_closest_point(gphys_shape_type type, const void* shape, const gphys_vec3* point,
                                       gphys_nearest* out_nearest) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(point, out_nearest);
        Target target;
        GPHYS_TRY(read_target(type, shape, target));
        GPHYS_REQUIRE_VALID(*point);
        return nearest(target, widen(*point), *out_nearest) ? GPHYS_OK : GPHYS_NO_HIT;
    });
}

gphys_status gphys_shape_closest_point_batch(gphys_shape_type type, const void* shape, const gphys_vec3* points,
                                             uint32_t point_stride, uint32_t count, gphys_nearest* out_nearest,
                                             uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        if (count != 0) GPHYS_REQUIRE_POINTERS(points, out_nearest);
        GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof(gphys_nearest), count));
        Target target;
        GPHYS_TRY(read_target(type, shape, target));
        GPHYS_TRY(check_points(points, point_stride, count));
        const Strided<gphys_vec3> each(points, point_stride);
        const StridedOut<gphys_nearest> out(out_nearest, out_stride);
        const Mesh* const* const mesh = std::get_if<const Mesh*>(&target);
        mesh ? nearest_many(**mesh, each, count, out) : nearest_many(target, each, count, out);
        return GPHYS_OK;
    });
}

gphys_status gphys_shape_overlaps(gphys_shape_type a_type, const void* a, gphys_shape_type b_type, const void* b,
                                  int32_t* out_overlaps) {
    return guarded(__func__,
                   [&] { return overlaps_batch(a_type, a, 0, b_type, b, 0, 1, out_overlaps, sizeof *out_overlaps); });
}

gphys_status gphys_shape_overlaps_batch(gphys_shape_type a_type, const void* a, uint32_t a_stride,
                                        gphys_shape_type b_type, const void* b, uint32_t b_stride, uint32_t count,
                                        int32_t* out_overlaps, uint32_t out_stride) {
    return guarded(__func__, [&] {
        return overlaps_batch(a_type, a, a_stride, b_type, b, b_stride, count, out_overlaps, out_stride);
    });
}

gphys_status gphys_shape_classify_plane(gphys_shape_type type, const void* shape, const gphys_plane* plane,
                                        gphys_side* out_side, float* out_signed_distance) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(plane, out_side);
        Shape read;
        GPHYS_TRY(read_classifiable(type, shape, read));
        GPHYS_REQUIRE_VALID(*plane);
        double signed_distance = 0;
        *out_side = static_cast<gphys_side>(classify(read, widen(*plane), signed_distance));
        if (out_signed_distance) *out_signed_distance = static_cast<float>(signed_distance);
        return GPHYS_OK;
    });
}

gphys_status gphys_shape_classify_frustum(gphys_shape_type type, const void* shape, const gphys_frustum* frustum,
                                          gphys_side* out_side) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(frustum, out_side);
        Shape read;
        GPHYS_TRY(read_classifiable(type, shape, read));
        GPHYS_REQUIRE_VALID(*frustum);
        *out_side = static_cast<gphys_side>(classify(read, widen(*frustum)));
        return GPHYS_OK;
    });
}

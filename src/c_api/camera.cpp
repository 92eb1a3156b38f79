// gphys_camera_*: settings, placement, matrices, frustum, pixels and points. The orbit is in camera_orbit.cpp, picking
// and culling are in camera_pick.cpp.
#include "camera/camera.h"

#include "c_api/api.h"
#include "c_api/handles.h"

using namespace gphys;

namespace {

// The size in release 1.0, without the padding at its end on 64-bit targets.
constexpr size_t first_desc_size = offsetof(gphys_camera_desc, reserved);

// Ranges of sizes that the projection divides by: wide enough for any picture, and narrow enough that all
// elements of the matrices are finite floats.
constexpr float smallest_fov = 1e-6f;
constexpr float smallest_extent = 1e-6f;  // metres
constexpr float smallest_aspect = 1e-6f, largest_aspect = 1e6f;
constexpr float smallest_viewport = 1e-3f, largest_viewport = 1e6f;

gphys_camera_desc default_desc() {
    gphys_camera_desc desc{};
    desc.handedness = GPHYS_LEFT_HANDED;
    desc.depth_range = GPHYS_DEPTH_ZERO_TO_ONE;
    desc.viewport_width = 800;
    desc.viewport_height = 600;
    return desc;
}

bool is_extent(float metres) { return metres >= smallest_extent && is_coordinate(metres); }
bool is_affine(const gphys_mat4& matrix) {
    return matrix.m[3] == 0 && matrix.m[7] == 0 && matrix.m[11] == 0 && matrix.m[15] == 1;
}
bool is_viewport(float pixels) { return pixels >= smallest_viewport && pixels <= largest_viewport; }

constexpr char extent_range[] = "from 1e-6 to 1e15";
constexpr char viewport_range[] = "from 0.001 to 1e6";

gphys_status check_perspective(float fov_y, float near_distance, float far_distance) {
    GPHYS_REQUIRE_IN_RANGE(fov_y >= smallest_fov && fov_y < pi, "fov_y", fov_y, "at least 1e-6 and below pi");
    GPHYS_REQUIRE_IN_RANGE(near_distance > 0 && is_coordinate(near_distance), "near_distance", near_distance,
                           positive_range);
    GPHYS_REQUIRE_IN_RANGE(far_distance > near_distance && (is_coordinate(far_distance) || std::isinf(far_distance)),
                           "far_distance", far_distance, "above near_distance, and at most 1e15 or INFINITY");
    return GPHYS_OK;
}

gphys_status check_orthographic(float height, float near_distance, float far_distance) {
    GPHYS_REQUIRE_IN_RANGE(is_extent(height), "height", height, extent_range);
    GPHYS_TRY(check_coordinate("near_distance", near_distance));
    GPHYS_TRY(check_coordinate("far_distance", far_distance));
    GPHYS_REQUIRE_IN_RANGE(static_cast<double>(far_distance) - near_distance >= smallest_extent, "far_distance",
                           far_distance, "at least near_distance + 1e-6");
    return GPHYS_OK;
}

gphys_status check_viewport(const char* width_name, float width, const char* height_name, float height) {
    GPHYS_REQUIRE_IN_RANGE(is_viewport(width), width_name, width, viewport_range);
    GPHYS_REQUIRE_IN_RANGE(is_viewport(height), height_name, height, viewport_range);
    return GPHYS_OK;
}

/// A t_max beyond the largest float becomes infinite.
gphys_ray narrow_ray(const Ray& ray) {
    const bool fits = ray.t_max <= static_cast<double>(std::numeric_limits<float>::max());
    return {narrow(ray.origin), narrow(ray.direction), fits ? static_cast<float>(ray.t_max) : INFINITY};
}

constexpr gphys_vec3 nowhere{INFINITY, INFINITY, INFINITY};

template <class Get>
gphys_status get_matrix(const gphys_camera* camera, const char* out_name, gphys_mat4* out, Get&& get) {
    GPHYS_REQUIRE_POINTERS(camera);
    GPHYS_TRY(check_pointers(out_name, out));
    *out = narrow(get(*unwrap(camera)));
    return GPHYS_OK;
}

/// Convert the points of a batch. convert(from, to) returns false where the result is not finite.
template <class Convert>
gphys_status convert_batch(const char* from_name, const gphys_vec3* from, const char* from_stride_name,
                           uint32_t from_stride, uint32_t count, const char* to_name, gphys_vec3* to,
                           uint32_t to_stride, Convert&& convert) {
    if (count == 0) return GPHYS_OK;
    GPHYS_TRY(check_pointers(from_name, from));
    GPHYS_TRY(check_pointers(to_name, to));
    GPHYS_TRY(check_stride(from_stride_name, from_stride, sizeof *from, count));
    GPHYS_TRY(check_out_stride("out_stride", to_stride, sizeof *to, count));
    const Strided<gphys_vec3> in(from, from_stride);
    const StridedOut<gphys_vec3> out(to, to_stride);
    for (uint32_t i = 0; i < count; ++i) GPHYS_TRY(check_element(from_name, i, in[i]));
    for (uint32_t i = 0; i < count; ++i) {
        Vec3 converted;
        out[i] = convert(widen(in[i]), converted) ? narrow(converted) : nowhere;
    }
    return GPHYS_OK;
}

}  // namespace

gphys_status gphys_camera_desc_init(gphys_camera_desc* desc, uint32_t size) {
    return guarded(__func__, [&] { return write_desc(desc, size, default_desc(), first_desc_size); });
}

gphys_status gphys_camera_create(const gphys_camera_desc* desc, gphys_camera** out_camera) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(out_camera);
        gphys_camera_desc settings = default_desc();
        GPHYS_TRY(read_desc(desc, settings, first_desc_size));
        GPHYS_TRY(check_allocator(settings.allocator));
        GPHYS_REQUIRE_IN_RANGE(settings.handedness == GPHYS_LEFT_HANDED || settings.handedness == GPHYS_RIGHT_HANDED,
                               "desc.handedness", settings.handedness, "a gphys_handedness");
        GPHYS_TRY(check_depth_range("desc.depth_range", settings.depth_range));
        GPHYS_TRY(check_bool("desc.reverse_z", settings.reverse_z));
        GPHYS_TRY(check_viewport("desc.viewport_width", settings.viewport_width, "desc.viewport_height",
                                 settings.viewport_height));
        *out_camera = wrap(create<Camera>(settings.allocator, settings));
        return GPHYS_OK;
    });
}

void gphys_camera_destroy(gphys_camera* camera) {
    guarded(__func__, [&] { destroy(unwrap(camera)); });
}

gphys_status gphys_camera_set_origin(gphys_camera* camera, const double origin[3]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, origin);
        GPHYS_TRY(check_origin(origin));
        GPHYS_REQUIRE(unwrap(camera)->set_origin({origin[0], origin[1], origin[2]}),
                      "origin: a coordinate of the camera would be beyond 1e15");
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_origin(const gphys_camera* camera, double out_origin[3]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_origin);
        write_origin(unwrap(camera)->origin(), out_origin);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_perspective(gphys_camera* camera, float fov_y, float near_distance, float far_distance) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        GPHYS_TRY(check_perspective(fov_y, near_distance, far_distance));
        unwrap(camera)->set_perspective(fov_y, near_distance, far_distance);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_orthographic(gphys_camera* camera, float height, float near_distance,
                                           float far_distance) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        GPHYS_TRY(check_orthographic(height, near_distance, far_distance));
        GPHYS_REQUIRE(unwrap(camera)->set_orthographic(height, near_distance, far_distance),
                      "height: with the aspect of the viewport, the width would be beyond 2e15");
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_perspective_aspect(gphys_camera* camera, float fov_y, float aspect, float near_distance,
                                                 float far_distance) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        GPHYS_TRY(check_perspective(fov_y, near_distance, far_distance));
        GPHYS_REQUIRE_IN_RANGE(aspect >= smallest_aspect && aspect <= largest_aspect, "aspect", aspect,
                               "from 1e-6 to 1e6");
        unwrap(camera)->set_perspective(fov_y, near_distance, far_distance, aspect);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_orthographic_size(gphys_camera* camera, float width, float height, float near_distance,
                                                float far_distance) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        GPHYS_TRY(check_orthographic(height, near_distance, far_distance));
        GPHYS_REQUIRE_IN_RANGE(is_extent(width), "width", width, extent_range);
        unwrap(camera)->set_orthographic(height, near_distance, far_distance, width);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_projection(gphys_camera* camera, const gphys_mat4* projection) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, projection);
        GPHYS_TRY(check_matrix("projection.m", *projection));
        return unwrap(camera)->set_projection(widen(*projection));
    });
}

gphys_status gphys_camera_set_viewport(gphys_camera* camera, float width, float height) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        GPHYS_TRY(check_viewport("width", width, "height", height));
        GPHYS_REQUIRE(unwrap(camera)->set_viewport(width, height),
                      "width: the image of the orthographic camera would be wider than 2e15");
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_viewport_origin(gphys_camera* camera, float x, float y) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        GPHYS_TRY(check_coordinate("x", x));
        GPHYS_TRY(check_coordinate("y", y));
        unwrap(camera)->set_viewport_origin(x, y);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_pick_start(gphys_camera* camera, gphys_pick_start start) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        GPHYS_REQUIRE_IN_RANGE(start == GPHYS_PICK_FROM_NEAR_PLANE || start == GPHYS_PICK_FROM_CENTRE, "start", start,
                               "a gphys_pick_start");
        unwrap(camera)->set_pick_start(start);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_projection(const gphys_camera* camera, gphys_projection* out_kind, float* out_size,
                                         float* out_near, float* out_far) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_kind, out_size, out_near, out_far);
        const Camera::ProjectionSettings settings = unwrap(camera)->projection_settings();
        *out_kind = settings.kind;
        // Exact: the setters took floats.
        *out_size = static_cast<float>(settings.size);
        *out_near = static_cast<float>(settings.near_distance);
        *out_far = static_cast<float>(settings.far_distance);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_viewport(const gphys_camera* camera, float* out_width, float* out_height) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_width, out_height);
        *out_width = static_cast<float>(unwrap(camera)->viewport_width());
        *out_height = static_cast<float>(unwrap(camera)->viewport_height());
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_viewport_origin(const gphys_camera* camera, float* out_x, float* out_y) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_x, out_y);
        *out_x = static_cast<float>(unwrap(camera)->viewport_left());
        *out_y = static_cast<float>(unwrap(camera)->viewport_top());
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_aspect(const gphys_camera* camera, float* out_aspect, int32_t* out_is_fixed) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_aspect, out_is_fixed);
        *out_aspect = static_cast<float>(unwrap(camera)->aspect());
        *out_is_fixed = unwrap(camera)->has_own_aspect();
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_image_size(const gphys_camera* camera, float* out_width, float* out_height) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_width, out_height);
        double width, height;
        unwrap(camera)->image_size(width, height);
        *out_width = static_cast<float>(width);
        *out_height = static_cast<float>(height);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_pick_start(const gphys_camera* camera, gphys_pick_start* out_start) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_start);
        *out_start = unwrap(camera)->pick_start();
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_transform(gphys_camera* camera, const gphys_vec3* position, const gphys_quat* rotation) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, position, rotation);
        GPHYS_REQUIRE_VALID(*position);
        GPHYS_REQUIRE_VALID(*rotation);
        unwrap(camera)->set_transform(widen(*position), rotation_matrix(widen(*rotation)));
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_world_matrix(gphys_camera* camera, const gphys_mat4* world) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, world);
        GPHYS_TRY(check_matrix("world.m", *world));
        GPHYS_REQUIRE(is_affine(*world), "world: the last row is not 0 0 0 1");
        return unwrap(camera)->set_world_matrix(widen(*world));
    });
}

gphys_status gphys_camera_set_view_matrix(gphys_camera* camera, const gphys_mat4* view) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, view);
        GPHYS_TRY(check_matrix("view.m", *view));
        GPHYS_REQUIRE(is_affine(*view), "view: the last row is not 0 0 0 1");
        return unwrap(camera)->set_view_matrix(widen(*view));
    });
}

gphys_status gphys_camera_look_at(gphys_camera* camera, const gphys_vec3* eye, const gphys_vec3* target,
                                  const gphys_vec3* up) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, eye, target, up);
        GPHYS_REQUIRE_VALID(*eye);
        GPHYS_REQUIRE_VALID(*target);
        GPHYS_REQUIRE_VALID(*up);
        GPHYS_REQUIRE(widen(*eye) != widen(*target), "target: it is the same point as eye");
        GPHYS_REQUIRE_IN_RANGE(widen(*up) != Vec3{}, "up: length", 0, "above 0");
        unwrap(camera)->look_at(widen(*eye), widen(*target), widen(*up));
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_conventions(const gphys_camera* camera, gphys_handedness* out_handedness,
                                          gphys_depth_range* out_depth_range, int32_t* out_reverse_z) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_handedness, out_depth_range, out_reverse_z);
        const DepthRange& depth = unwrap(camera)->depth_range();
        *out_handedness = unwrap(camera)->handedness();
        *out_depth_range = depth.range();
        *out_reverse_z = depth.is_reversed();
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_transform(const gphys_camera* camera, gphys_vec3* out_position,
                                        gphys_quat* out_rotation) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_position, out_rotation);
        *out_position = narrow(unwrap(camera)->position());
        *out_rotation = narrow(quaternion(unwrap(camera)->rotation()));
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_world_matrix(const gphys_camera* camera, gphys_mat4* out_world) {
    return guarded(__func__, [&]() -> gphys_status {
        return get_matrix(camera, "out_world", out_world, [](const Camera& c) { return c.world_matrix(); });
    });
}

gphys_status gphys_camera_get_view_matrix(const gphys_camera* camera, gphys_mat4* out_view) {
    return guarded(__func__, [&]() -> gphys_status {
        return get_matrix(camera, "out_view", out_view, [](const Camera& c) { return c.view_matrix(); });
    });
}

gphys_status gphys_camera_get_projection_matrix(const gphys_camera* camera, gphys_mat4* out_projection) {
    return guarded(__func__, [&]() -> gphys_status {
        return get_matrix(camera, "out_projection", out_projection,
                          [](const Camera& c) { return c.projection_matrix(); });
    });
}

gphys_status gphys_camera_get_view_projection_matrix(const gphys_camera* camera, gphys_mat4* out_view_projection) {
    return guarded(__func__, [&]() -> gphys_status {
        return get_matrix(camera, "out_view_projection", out_view_projection,
                          [](const Camera& c) { return c.view_projection_matrix(); });
    });
}

gphys_status gphys_camera_get_frustum(const gphys_camera* camera, gphys_frustum* out_frustum) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_frustum);
        *out_frustum = narrow(unwrap(camera)->frustum());
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_corners(const gphys_camera* camera, gphys_vec3 out_corners[8]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_corners);
        Vec3 corners[8];
        if (!unwrap(camera)->corners(corners)) return GPHYS_UNBOUNDED;
        std::transform(corners, corners + 8, out_corners, [](Vec3 corner) { return narrow(corner); });
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_rectangle_frustum(const gphys_camera* camera, float x0, float y0, float x1, float y1,
                                                gphys_frustum* out_frustum) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_frustum);
        GPHYS_TRY(check_rectangle(x0, y0, x1, y1));
        const gphys_frustum seen = narrow(unwrap(camera)->frustum_of_pixels(x0, y0, x1, y1));
        GPHYS_TRY(check_valid("frustum of the rectangle", seen));
        *out_frustum = seen;
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_rectangle_corners(const gphys_camera* camera, float x0, float y0, float x1, float y1,
                                                gphys_vec3 out_corners[8]) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_corners);
        GPHYS_TRY(check_rectangle(x0, y0, x1, y1));
        const Camera& seen = *unwrap(camera);
        Vec3 corners[8];
        if (!seen.corners(corners, seen.window_of_pixels(x0, y0, x1, y1))) return GPHYS_UNBOUNDED;
        std::transform(corners, corners + 8, out_corners, [](Vec3 corner) { return narrow(corner); });
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_project(const gphys_camera* camera, const gphys_vec3* point, gphys_vec3* out_pixel) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, point, out_pixel);
        GPHYS_REQUIRE_VALID(*point);
        Vec3 pixel;
        if (!unwrap(camera)->project(widen(*point), pixel)) return GPHYS_NO_HIT;
        *out_pixel = narrow(pixel);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_project_batch(const gphys_camera* camera, const gphys_vec3* points, uint32_t point_stride,
                                        uint32_t count, gphys_vec3* out_pixels, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        return convert_batch("points", points, "point_stride", point_stride, count, "out_pixels", out_pixels,
                             out_stride,
                             [&](Vec3 point, Vec3& pixel) { return unwrap(camera)->project(point, pixel); });
    });
}

gphys_status gphys_camera_unproject(const gphys_camera* camera, const gphys_vec3* pixel, gphys_vec3* out_point) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, pixel, out_point);
        GPHYS_REQUIRE_VALID(*pixel);
        Vec3 point;
        if (!unwrap(camera)->unproject(widen(*pixel), point)) return GPHYS_UNBOUNDED;
        *out_point = narrow(point);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_unproject_batch(const gphys_camera* camera, const gphys_vec3* pixels, uint32_t pixel_stride,
                                          uint32_t count, gphys_vec3* out_points, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        return convert_batch("pixels", pixels, "pixel_stride", pixel_stride, count, "out_points", out_points,
                             out_stride,
                             [&](Vec3 pixel, Vec3& point) { return unwrap(camera)->unproject(pixel, point); });
    });
}

gphys_status gphys_camera_pick_ray(const gphys_camera* camera, float pixel_x, float pixel_y, gphys_ray* out_ray) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_ray);
        GPHYS_TRY(check_coordinate("pixel_x", pixel_x));
        GPHYS_TRY(check_coordinate("pixel_y", pixel_y));
        Ray ray;
        if (!unwrap(camera)->pick_ray(pixel_x, pixel_y, ray)) return GPHYS_UNBOUNDED;
        *out_ray = narrow_ray(ray);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_pick_rays(const gphys_camera* camera, uint32_t x, uint32_t y, uint32_t width, uint32_t height,
                                    gphys_ray* out_rays, uint32_t out_stride) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera);
        if (width == 0 || height == 0) return GPHYS_OK;
        GPHYS_REQUIRE_POINTERS(out_rays);
        GPHYS_TRY(check_spacing("out_stride", out_stride, sizeof *out_rays));
        GPHYS_REQUIRE_IN_RANGE(width <= UINT32_MAX / height, "width * height", double{1} * width * height,
                               "below 2^32");
        GPHYS_REQUIRE_IN_RANGE(width - 1 <= UINT32_MAX - x, "x + width", double{1} * x + width, "at most 2^32");
        GPHYS_REQUIRE_IN_RANGE(height - 1 <= UINT32_MAX - y, "y + height", double{1} * y + height, "at most 2^32");
        const auto ray_of = [&](uint32_t column, uint32_t row, Ray& ray) {
            return unwrap(camera)->pick_ray(x + column + 0.5, y + row + 0.5, ray);
        };
        // Whether a pixel has a ray is monotone in x and in y, so testing the four corners suffices.
        Ray ray;
        for (uint32_t column : {0u, width - 1}) {
            for (uint32_t row : {0u, height - 1}) {
                if (!ray_of(column, row, ray)) return GPHYS_UNBOUNDED;
            }
        }
        const StridedOut<gphys_ray> out(out_rays, out_stride);
        for (uint32_t row = 0; row < height; ++row) {
            for (uint32_t column = 0; column < width; ++column) {
                ray_of(column, row, ray);
                out[row * width + column] = narrow_ray(ray);
            }
        }
        return GPHYS_OK;
    });
}

// The camera: settings, placement, orbit, matrices, frustum, pixels and points.
#include "camera/camera.h"

#include "c_api/api.h"
#include "c_api/handles.h"

using namespace gphys;

namespace {

// Of release 1.0, without the padding that it ended in on 64-bit targets.
constexpr size_t first_desc_size = offsetof(gphys_camera_desc, reserved);

// Ranges of sizes that appear in a divisor: wide enough for any picture, and narrow enough that no
// element of a matrix leaves the range of float.
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

bool is_coordinate(float value) { return std::fabs(value) <= GPHYS_MAX_COORDINATE; }
bool is_extent(float metres) { return metres >= smallest_extent && is_coordinate(metres); }
bool is_viewport(float pixels) { return pixels >= smallest_viewport && pixels <= largest_viewport; }
bool is_pitch(float angle) { return std::fabs(angle) <= static_cast<float>(pi / 2); }

const char* defect(const gphys_mat4& matrix) {
    for (float element : matrix.m) {
        if (!is_coordinate(element)) return "matrix: an element is NaN, infinite or beyond GPHYS_MAX_COORDINATE";
    }
    return nullptr;
}

const char* defect_of_perspective(float fov_y, float near_distance, float far_distance) {
    if (!(fov_y >= smallest_fov && fov_y < pi)) return "fov_y: must be at least 1e-6 and below pi";
    if (!(near_distance > 0) || !is_coordinate(near_distance)) return "near_distance: must be above 0 and in range";
    if (!(far_distance > near_distance) || !(is_coordinate(far_distance) || std::isinf(far_distance)))
        return "far_distance: must be above near_distance, and in range or INFINITY";
    return nullptr;
}

const char* defect_of_orthographic(float height, float near_distance, float far_distance) {
    if (!is_extent(height)) return "height: must be at least 1e-6 and in range";
    if (!is_coordinate(near_distance) || !is_coordinate(far_distance))
        return "near_distance or far_distance is not finite or out of range";
    if (!(static_cast<double>(far_distance) - near_distance >= smallest_extent))
        return "far_distance: must be at least 1e-6 above near_distance";
    return nullptr;
}

const char* defect_of_rectangle(float x0, float y0, float x1, float y1) {
    for (float pixel : {x0, y0, x1, y1}) {
        if (!is_coordinate(pixel)) return "rectangle: not finite or out of range";
    }
    return x0 == x1 || y0 == y1 ? "rectangle: has no area" : nullptr;
}

const char* defect(const gphys_orbit_speeds& speeds) {
    for (float speed : {speeds.rotate_x, speeds.rotate_y, speeds.zoom, speeds.pan_x, speeds.pan_y}) {
        if (!is_coordinate(speed)) return "speeds: one is not finite or out of range";
    }
    return nullptr;
}

const char* defect(const gphys_orbit& orbit) {
    if (const char* wrong = gphys::defect(orbit.target)) return wrong;
    if (const char* wrong = gphys::defect(orbit.up)) return wrong;
    if (widen(orbit.up) == Vec3{}) return "orbit.up: must not be zero";
    if (!(orbit.distance > 0) || !is_coordinate(orbit.distance)) return "orbit.distance: must be above 0 and in range";
    if (!is_coordinate(orbit.yaw) || !is_coordinate(orbit.pitch))
        return "orbit: an angle is not finite or out of range";
    if (!is_coordinate(orbit.radians_per_unit)) return "orbit.radians_per_unit: not finite or out of range";
    if (!is_coordinate(orbit.metres_per_unit)) return "orbit.metres_per_unit: not finite or out of range";
    if (!(orbit.min_distance > 0) || !is_coordinate(orbit.min_distance) ||
        !(orbit.max_distance >= orbit.min_distance)) {
        return "orbit: 0 < min_distance <= max_distance is required";
    }
    if (!is_pitch(orbit.min_pitch) || !is_pitch(orbit.max_pitch) || orbit.min_pitch > orbit.max_pitch) {
        return "orbit: -pi/2 <= min_pitch <= max_pitch <= pi/2 is required";
    }
    return nullptr;
}

/// A t_max beyond the range of float is beyond everything.
gphys_ray narrow_ray(const Ray& ray) {
    const bool fits = ray.t_max <= static_cast<double>(std::numeric_limits<float>::max());
    return {narrow(ray.origin), narrow(ray.direction), fits ? static_cast<float>(ray.t_max) : INFINITY};
}

gphys_frustum narrow_frustum(const Frustum& seen) {
    gphys_frustum out{narrow(seen.origin), {}};
    for (int i = 0; i < 6; ++i) {
        out.planes[i] = {narrow(seen.planes[i].normal), static_cast<float>(seen.planes[i].distance)};
    }
    return out;
}

constexpr gphys_vec3 nowhere{INFINITY, INFINITY, INFINITY};

/// One orbit input of up to two numbers.
template <class Apply>
gphys_status orbit_input(gphys_camera* camera, float a, float b, Apply&& apply) {
    GPHYS_REQUIRE(camera, "camera is null");
    GPHYS_REQUIRE(std::isfinite(a) && std::isfinite(b), "units: not finite");
    Orbit* orbit = unwrap(camera)->orbit();
    if (!orbit) return fail(GPHYS_ERROR_UNSUPPORTED, "camera was never set to orbit");
    apply(*orbit);
    return GPHYS_OK;
}

/// One matrix out.
template <class Get>
gphys_status get_matrix(const gphys_camera* camera, gphys_mat4* out, Get&& get) {
    GPHYS_REQUIRE(camera && out, "camera or output is null");
    *out = narrow(get(*unwrap(camera)));
    return GPHYS_OK;
}

/// Each point of a batch through `convert`, which is false where there is nothing finite.
template <class Convert>
gphys_status convert_batch(const gphys_vec3* from, const char* from_name, uint32_t from_stride, uint32_t count,
                           gphys_vec3* to, uint32_t to_stride, Convert&& convert) {
    if (count == 0) return GPHYS_OK;
    GPHYS_REQUIRE(from && to, "input or output is null");
    GPHYS_TRY(check_stride(from_name, from_stride, sizeof *from));
    GPHYS_TRY(check_out_stride("out_stride", to_stride, sizeof *to));
    const Strided<gphys_vec3> in(from, from_stride);
    const StridedOut<gphys_vec3> out(to, to_stride);
    for (uint32_t i = 0; i < count; ++i) GPHYS_REQUIRE_VALID(in[i]);
    for (uint32_t i = 0; i < count; ++i) {
        Vec3 converted;
        out[i] = convert(widen(in[i]), converted) ? narrow(converted) : nowhere;
    }
    return GPHYS_OK;
}

}  // namespace

gphys_status gphys_camera_desc_init(gphys_camera_desc* desc, uint32_t size) {
    return guarded([&] { return write_desc(desc, size, default_desc(), first_desc_size); });
}

gphys_status gphys_camera_create(const gphys_camera_desc* desc, gphys_camera** out_camera) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(out_camera, "out_camera is null");
        gphys_camera_desc wanted = default_desc();
        GPHYS_TRY(read_desc(desc, wanted, first_desc_size));
        if (const char* wrong = gphys::defect(wanted.allocator)) return invalid(wrong);
        GPHYS_REQUIRE(wanted.handedness == GPHYS_LEFT_HANDED || wanted.handedness == GPHYS_RIGHT_HANDED,
                      "desc.handedness: unknown");
        GPHYS_REQUIRE(
            wanted.depth_range == GPHYS_DEPTH_ZERO_TO_ONE || wanted.depth_range == GPHYS_DEPTH_MINUS_ONE_TO_ONE,
            "desc.depth_range: unknown");
        GPHYS_REQUIRE(is_bool(wanted.reverse_z), "desc.reverse_z: must be 0 or 1");
        GPHYS_REQUIRE(is_viewport(wanted.viewport_width) && is_viewport(wanted.viewport_height),
                      "desc: viewport sizes must be 1e-3 .. 1e6");
        *out_camera = wrap(create<Camera>(wanted.allocator, wanted));
        return GPHYS_OK;
    });
}

void gphys_camera_destroy(gphys_camera* camera) {
    guarded([&] { destroy(unwrap(camera)); });
}

gphys_status gphys_camera_set_origin(gphys_camera* camera, const double origin[3]) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && origin, "camera or origin is null");
        GPHYS_REQUIRE(is_origin(origin), "origin: a coordinate is NaN, infinite or beyond GPHYS_MAX_COORDINATE");
        GPHYS_REQUIRE(unwrap(camera)->set_origin({origin[0], origin[1], origin[2]}),
                      "origin: the camera would be beyond GPHYS_MAX_COORDINATE");
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_origin(const gphys_camera* camera, double out_origin[3]) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_origin, "camera or out_origin is null");
        write_origin(unwrap(camera)->origin(), out_origin);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_perspective(gphys_camera* camera, float fov_y, float near_distance, float far_distance) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        if (const char* wrong = defect_of_perspective(fov_y, near_distance, far_distance)) return invalid(wrong);
        unwrap(camera)->set_perspective(fov_y, near_distance, far_distance);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_orthographic(gphys_camera* camera, float height, float near_distance,
                                           float far_distance) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        if (const char* wrong = defect_of_orthographic(height, near_distance, far_distance)) return invalid(wrong);
        GPHYS_REQUIRE(unwrap(camera)->set_orthographic(height, near_distance, far_distance),
                      "height: with this viewport, the width is beyond twice GPHYS_MAX_COORDINATE");
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_perspective_aspect(gphys_camera* camera, float fov_y, float aspect, float near_distance,
                                                 float far_distance) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        if (const char* wrong = defect_of_perspective(fov_y, near_distance, far_distance)) return invalid(wrong);
        GPHYS_REQUIRE(aspect >= smallest_aspect && aspect <= largest_aspect, "aspect: must be 1e-6 .. 1e6");
        unwrap(camera)->set_perspective(fov_y, near_distance, far_distance, aspect);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_orthographic_size(gphys_camera* camera, float width, float height, float near_distance,
                                                float far_distance) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        if (const char* wrong = defect_of_orthographic(height, near_distance, far_distance)) return invalid(wrong);
        GPHYS_REQUIRE(is_extent(width), "width: must be at least 1e-6 and in range");
        unwrap(camera)->set_orthographic(height, near_distance, far_distance, width);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_projection(gphys_camera* camera, const gphys_mat4* projection) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && projection, "camera or projection is null");
        if (const char* wrong = defect(*projection)) return invalid(wrong);
        return unwrap(camera)->set_projection(widen(*projection));
    });
}

gphys_status gphys_camera_set_viewport(gphys_camera* camera, float width, float height) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        GPHYS_REQUIRE(is_viewport(width) && is_viewport(height), "viewport sizes must be 1e-3 .. 1e6");
        GPHYS_REQUIRE(unwrap(camera)->set_viewport(width, height),
                      "width: what the orthographic camera sees would be wider than twice GPHYS_MAX_COORDINATE");
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_viewport_origin(gphys_camera* camera, float x, float y) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        GPHYS_REQUIRE(is_coordinate(x) && is_coordinate(y), "viewport origin: not finite or out of range");
        unwrap(camera)->set_viewport_origin(x, y);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_pick_start(gphys_camera* camera, gphys_pick_start start) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        GPHYS_REQUIRE(start == GPHYS_PICK_FROM_NEAR_PLANE || start == GPHYS_PICK_FROM_CENTRE, "start: unknown");
        unwrap(camera)->set_pick_start(start);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_projection(const gphys_camera* camera, gphys_projection* out_kind, float* out_size,
                                         float* out_near, float* out_far) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        GPHYS_REQUIRE(out_kind && out_size && out_near && out_far, "an output is null");
        const Camera::ProjectionSettings settings = unwrap(camera)->projection_settings();
        *out_kind = settings.kind;
        // They came as floats.
        *out_size = static_cast<float>(settings.size);
        *out_near = static_cast<float>(settings.near_distance);
        *out_far = static_cast<float>(settings.far_distance);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_viewport(const gphys_camera* camera, float* out_width, float* out_height) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_width && out_height, "camera, out_width or out_height is null");
        *out_width = static_cast<float>(unwrap(camera)->viewport_width());
        *out_height = static_cast<float>(unwrap(camera)->viewport_height());
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_viewport_origin(const gphys_camera* camera, float* out_x, float* out_y) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_x && out_y, "camera, out_x or out_y is null");
        *out_x = static_cast<float>(unwrap(camera)->viewport_left());
        *out_y = static_cast<float>(unwrap(camera)->viewport_top());
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_aspect(const gphys_camera* camera, float* out_aspect, int32_t* out_is_fixed) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_aspect && out_is_fixed, "camera, out_aspect or out_is_fixed is null");
        *out_aspect = static_cast<float>(unwrap(camera)->aspect());
        *out_is_fixed = unwrap(camera)->has_own_aspect();
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_image_size(const gphys_camera* camera, float* out_width, float* out_height) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_width && out_height, "camera, out_width or out_height is null");
        double width, height;
        unwrap(camera)->image_size(width, height);
        *out_width = static_cast<float>(width);
        *out_height = static_cast<float>(height);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_pick_start(const gphys_camera* camera, gphys_pick_start* out_start) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_start, "camera or out_start is null");
        *out_start = unwrap(camera)->pick_start();
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_transform(gphys_camera* camera, const gphys_vec3* position, const gphys_quat* rotation) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && position && rotation, "camera, position or rotation is null");
        GPHYS_REQUIRE_VALID(*position);
        GPHYS_REQUIRE_VALID(*rotation);
        unwrap(camera)->set_transform(widen(*position), rotation_matrix(widen(*rotation)));
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_world_matrix(gphys_camera* camera, const gphys_mat4* world) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && world, "camera or world is null");
        if (const char* wrong = defect(*world)) return invalid(wrong);
        GPHYS_REQUIRE(world->m[3] == 0 && world->m[7] == 0 && world->m[11] == 0 && world->m[15] == 1,
                      "world: the last row must be 0 0 0 1");
        return unwrap(camera)->set_world_matrix(widen(*world));
    });
}

gphys_status gphys_camera_set_view_matrix(gphys_camera* camera, const gphys_mat4* view) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && view, "camera or view is null");
        if (const char* wrong = defect(*view)) return invalid(wrong);
        GPHYS_REQUIRE(view->m[3] == 0 && view->m[7] == 0 && view->m[11] == 0 && view->m[15] == 1,
                      "view: the last row must be 0 0 0 1");
        return unwrap(camera)->set_view_matrix(widen(*view));
    });
}

gphys_status gphys_camera_look_at(gphys_camera* camera, const gphys_vec3* eye, const gphys_vec3* target,
                                  const gphys_vec3* up) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && eye && target && up, "camera, eye, target or up is null");
        GPHYS_REQUIRE_VALID(*eye);
        GPHYS_REQUIRE_VALID(*target);
        GPHYS_REQUIRE_VALID(*up);
        GPHYS_REQUIRE(widen(*eye) != widen(*target), "target: must differ from eye");
        GPHYS_REQUIRE(widen(*up) != Vec3{}, "up: must not be zero");
        unwrap(camera)->look_at(widen(*eye), widen(*target), widen(*up));
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_transform(const gphys_camera* camera, gphys_vec3* out_position,
                                        gphys_quat* out_rotation) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_position && out_rotation, "camera or output is null");
        *out_position = narrow(unwrap(camera)->position());
        *out_rotation = narrow(quaternion(unwrap(camera)->rotation()));
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_world_matrix(const gphys_camera* camera, gphys_mat4* out_world) {
    return guarded([&]() -> gphys_status {
        return get_matrix(camera, out_world, [](const Camera& c) { return c.world_matrix(); });
    });
}

gphys_status gphys_camera_get_view_matrix(const gphys_camera* camera, gphys_mat4* out_view) {
    return guarded([&]() -> gphys_status {
        return get_matrix(camera, out_view, [](const Camera& c) { return c.view_matrix(); });
    });
}

gphys_status gphys_camera_get_projection_matrix(const gphys_camera* camera, gphys_mat4* out_projection) {
    return guarded([&]() -> gphys_status {
        return get_matrix(camera, out_projection, [](const Camera& c) { return c.projection_matrix(); });
    });
}

gphys_status gphys_camera_get_view_projection_matrix(const gphys_camera* camera, gphys_mat4* out_view_projection) {
    return guarded([&]() -> gphys_status {
        return get_matrix(camera, out_view_projection, [](const Camera& c) { return c.view_projection_matrix(); });
    });
}

gphys_status gphys_orbit_init(gphys_orbit* orbit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(orbit, "orbit is null");
        constexpr float degrees_89 = static_cast<float>(89 * pi / 180);
        gphys_orbit initial{};
        initial.up = {0, 1, 0};
        initial.distance = 10;
        initial.radians_per_unit = 1;
        initial.metres_per_unit = 1;
        initial.min_distance = 0.01f;
        initial.max_distance = INFINITY;
        initial.min_pitch = -degrees_89;
        initial.max_pitch = degrees_89;
        *orbit = initial;
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_orbit(gphys_camera* camera, const gphys_orbit* orbit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && orbit, "camera or orbit is null");
        if (const char* wrong = defect(*orbit)) return invalid(wrong);
        unwrap(camera)->set_orbit(*orbit);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_orbit(const gphys_camera* camera, gphys_orbit* out_orbit) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_orbit, "camera or out_orbit is null");
        const Orbit* orbit = unwrap(camera)->orbit();
        if (!orbit) return fail(GPHYS_ERROR_UNSUPPORTED, "camera was never set to orbit");
        *out_orbit = orbit->settings();
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_orbit_speeds(gphys_camera* camera, const gphys_orbit_speeds* speeds) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && speeds, "camera or speeds is null");
        if (const char* wrong = defect(*speeds)) return invalid(wrong);
        return orbit_input(camera, 0, 0, [&](Orbit& orbit) { orbit.set_speeds(*speeds); });
    });
}

gphys_status gphys_camera_get_orbit_speeds(const gphys_camera* camera, gphys_orbit_speeds* out_speeds) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_speeds, "camera or out_speeds is null");
        const Orbit* orbit = unwrap(camera)->orbit();
        if (!orbit) return fail(GPHYS_ERROR_UNSUPPORTED, "camera was never set to orbit");
        *out_speeds = orbit->speeds();
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_orbit_rotate(gphys_camera* camera, float units_x, float units_y) {
    return guarded([&]() -> gphys_status {
        return orbit_input(camera, units_x, units_y, [&](Orbit& orbit) { orbit.rotate(units_x, units_y); });
    });
}

gphys_status gphys_camera_orbit_zoom(gphys_camera* camera, float units) {
    return guarded(
        [&]() -> gphys_status { return orbit_input(camera, units, 0, [&](Orbit& orbit) { orbit.zoom(units); }); });
}

gphys_status gphys_camera_orbit_pan(gphys_camera* camera, float units_right, float units_up) {
    return guarded([&]() -> gphys_status {
        return orbit_input(camera, units_right, units_up, [&](Orbit& orbit) { orbit.pan(units_right, units_up); });
    });
}

gphys_status gphys_camera_orbit_update(gphys_camera* camera) {
    return guarded([&]() -> gphys_status {
        return orbit_input(camera, 0, 0, [&](Orbit& orbit) {
            orbit.update();
            unwrap(camera)->follow_orbit();
        });
    });
}

gphys_status gphys_camera_get_frustum(const gphys_camera* camera, gphys_frustum* out_frustum) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_frustum, "camera or out_frustum is null");
        *out_frustum = narrow_frustum(unwrap(camera)->frustum());
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_corners(const gphys_camera* camera, gphys_vec3 out_corners[8]) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_corners, "camera or out_corners is null");
        Vec3 corners[8];
        if (!unwrap(camera)->corners(corners)) return GPHYS_UNBOUNDED;
        std::transform(corners, corners + 8, out_corners, [](Vec3 corner) { return narrow(corner); });
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_rectangle_frustum(const gphys_camera* camera, float x0, float y0, float x1, float y1,
                                                gphys_frustum* out_frustum) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_frustum, "camera or out_frustum is null");
        if (const char* wrong = defect_of_rectangle(x0, y0, x1, y1)) return invalid(wrong);
        const gphys_frustum seen = narrow_frustum(unwrap(camera)->frustum_of_pixels(x0, y0, x1, y1));
        GPHYS_REQUIRE_VALID(seen);
        *out_frustum = seen;
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_rectangle_corners(const gphys_camera* camera, float x0, float y0, float x1, float y1,
                                                gphys_vec3 out_corners[8]) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_corners, "camera or out_corners is null");
        if (const char* wrong = defect_of_rectangle(x0, y0, x1, y1)) return invalid(wrong);
        const Camera& seen = *unwrap(camera);
        Vec3 corners[8];
        if (!seen.corners(corners, seen.window_of_pixels(x0, y0, x1, y1))) return GPHYS_UNBOUNDED;
        std::transform(corners, corners + 8, out_corners, [](Vec3 corner) { return narrow(corner); });
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_project(const gphys_camera* camera, const gphys_vec3* point, gphys_vec3* out_pixel) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && point && out_pixel, "camera, point or out_pixel is null");
        GPHYS_REQUIRE_VALID(*point);
        Vec3 pixel;
        if (!unwrap(camera)->project(widen(*point), pixel)) return GPHYS_NO_HIT;
        *out_pixel = narrow(pixel);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_project_batch(const gphys_camera* camera, const gphys_vec3* points, uint32_t point_stride,
                                        uint32_t count, gphys_vec3* out_pixels, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        return convert_batch(points, "point_stride", point_stride, count, out_pixels, out_stride,
                             [&](Vec3 point, Vec3& pixel) { return unwrap(camera)->project(point, pixel); });
    });
}

gphys_status gphys_camera_unproject(const gphys_camera* camera, const gphys_vec3* pixel, gphys_vec3* out_point) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && pixel && out_point, "camera, pixel or out_point is null");
        GPHYS_REQUIRE_VALID(*pixel);
        Vec3 point;
        if (!unwrap(camera)->unproject(widen(*pixel), point)) return GPHYS_UNBOUNDED;
        *out_point = narrow(point);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_unproject_batch(const gphys_camera* camera, const gphys_vec3* pixels, uint32_t pixel_stride,
                                          uint32_t count, gphys_vec3* out_points, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        return convert_batch(pixels, "pixel_stride", pixel_stride, count, out_points, out_stride,
                             [&](Vec3 pixel, Vec3& point) { return unwrap(camera)->unproject(pixel, point); });
    });
}

gphys_status gphys_camera_pick_ray(const gphys_camera* camera, float pixel_x, float pixel_y, gphys_ray* out_ray) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera && out_ray, "camera or out_ray is null");
        GPHYS_REQUIRE(is_coordinate(pixel_x) && is_coordinate(pixel_y), "pixel: not finite or out of range");
        Ray ray;
        if (!unwrap(camera)->pick_ray(pixel_x, pixel_y, ray)) return GPHYS_UNBOUNDED;
        *out_ray = narrow_ray(ray);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_pick_rays(const gphys_camera* camera, uint32_t x, uint32_t y, uint32_t width, uint32_t height,
                                    gphys_ray* out_rays, uint32_t out_stride) {
    return guarded([&]() -> gphys_status {
        GPHYS_REQUIRE(camera, "camera is null");
        if (width == 0 || height == 0) return GPHYS_OK;
        GPHYS_REQUIRE(out_rays, "out_rays is null");
        GPHYS_TRY(check_out_stride("out_stride", out_stride, sizeof *out_rays));
        GPHYS_REQUIRE(width <= UINT32_MAX / height, "width * height: must be below 2^32");
        GPHYS_REQUIRE(width - 1 <= UINT32_MAX - x && height - 1 <= UINT32_MAX - y, "pixels: must be below 2^32");
        const auto ray_of = [&](uint32_t column, uint32_t row, Ray& ray) {
            return unwrap(camera)->pick_ray(x + column + 0.5, y + row + 0.5, ray);
        };
        // Whether a ray starts is monotone in the pixel's x and in its y: the corners speak for all.
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

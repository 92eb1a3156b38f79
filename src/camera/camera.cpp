// The camera: placement (look-at by Gram-Schmidt), matrices, frusta and rays. The projections are in projection.cpp,
// clip space in clip_space.cpp.
#include "camera/camera.h"

#include "foundation/elementary.h"
#include "foundation/status.h"

namespace gphys {
namespace {

/// The smallest length of v - n dot(v, n), for unit vectors, that is not mere rounding: it has about six roundings of
/// 2^-53.
constexpr double smallest_perpendicular = 0x1p-50;

/// The component of v perpendicular to the unit vector n, normalized; false if they are parallel. Gram-Schmidt, twice:
/// the second pass removes the error of a cancellation in the first (Parlett 1980, after Kahan).
bool perpendicular_part(Vec3 v, Vec3 n, Vec3& out) {
    const Vec3 unit = normalized(v);
    const Vec3 first = unit - n * dot(unit, n);
    if (length(first) <= smallest_perpendicular) return false;
    const Vec3 second = normalized(first);
    out = normalized(second - n * dot(second, n));
    return true;
}

/// The right axis of a view: x = y cross z for a left-handed camera, whose z is forward. The z of a right-handed camera
/// is back.
Vec3 right_of(Vec3 up, Vec3 forward, double z_sign) { return cross(up, forward) * z_sign; }

}  // namespace

Camera::Camera(const gphys_allocator* hooks, const gphys_camera_desc& desc)
    : memory(hooks),
      handedness_(desc.handedness),
      depth_range_(desc.depth_range, desc.reverse_z != 0),
      width_(desc.viewport_width),
      height_(desc.viewport_height) {
    set_perspective(pi / 3, 0.1f, 1000);
    set_transform({}, {});
}

void Camera::set_perspective(double fov_y, double near_distance, double far_distance, double aspect) {
    const double half_height = tan(0.5 * fov_y);
    fov_y_ = fov_y;
    aspect_ = aspect;
    projection_ = Perspective{half_height * this->aspect(), half_height, near_distance, far_distance};
}

bool Camera::set_orthographic(double height, double near_distance, double far_distance, double width) {
    const double half_width = 0.5 * (width > 0 ? width : height * (width_ / height_));
    if (half_width > GPHYS_MAX_COORDINATE) return false;
    aspect_ = width / height;
    projection_ = Orthographic{half_width, 0.5 * height, near_distance, far_distance};
    return true;
}

gphys_status Camera::set_projection(const Mat4& projection) {
    UserProjection user{projection, {}};
    for (int row = 0; row < 4; ++row) user.to_clip(row, 2) *= z_sign();
    if (!inverse(user.to_clip, user.from_clip))
        return fail(GPHYS_ERROR_SINGULAR, "projection: the matrix has no inverse");
    Plane planes[6];
    user.planes(depth_range_, {}, planes);
    for (int i = 0; i < 6; ++i) {
        const bool at_infinity = planes[i].normal == Vec3{};
        if (at_infinity && (i != GPHYS_FRUSTUM_FAR || planes[i].distance > 0)) {
            return fail(GPHYS_ERROR_INVALID_ARGUMENT,
                        "projection: a plane other than far is at infinity (does it fit the camera's depth range?)");
        }
        if (!at_infinity && std::fabs(planes[i].distance) > GPHYS_MAX_COORDINATE) {
            return fail(GPHYS_ERROR_INVALID_ARGUMENT, "projection: a plane is beyond GPHYS_MAX_COORDINATE");
        }
    }
    aspect_ = 0;
    projection_ = user;
    return GPHYS_OK;
}

Camera::ProjectionSettings Camera::projection_settings() const {
    if (const auto* seen = std::get_if<Perspective>(&projection_)) {
        return {GPHYS_PROJECTION_PERSPECTIVE, fov_y_, seen->near_distance, seen->far_distance};
    }
    if (const auto* seen = std::get_if<Orthographic>(&projection_)) {
        return {GPHYS_PROJECTION_ORTHOGRAPHIC, 2 * seen->half_height, seen->near_distance, seen->far_distance};
    }
    return {GPHYS_PROJECTION_USER, 0, 0, 0};
}

bool Camera::set_viewport(double width, double height) {
    auto* const orthographic = std::get_if<Orthographic>(&projection_);
    if (orthographic && !has_own_aspect() && orthographic->half_height * (width / height) > GPHYS_MAX_COORDINATE) {
        return false;
    }
    width_ = width;
    height_ = height;
    if (has_own_aspect()) return true;
    if (orthographic) orthographic->half_width = orthographic->half_height * aspect();
    if (auto* perspective = std::get_if<Perspective>(&projection_)) {
        perspective->half_width = perspective->half_height * aspect();
    }
    return true;
}

void Camera::image_size(double& width, double& height) const {
    width = height = 0;
    std::visit(
        [&](const auto& kind) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(kind)>, UserProjection>) {
                width = 2 * kind.half_width;
                height = 2 * kind.half_height;
            }
        },
        projection_);
}

// The position is rounded to float here, once, so that matrices, frustum, rays and gphys_camera_get_transform agree. It
// is clamped, because an orbit around a target at the limit of the range could leave the range.
void Camera::place(Vec3 position, const Mat3& axes) {
    constexpr double furthest = GPHYS_MAX_COORDINATE;
    const Vec3 within = max(min(position, {furthest, furthest, furthest}), {-furthest, -furthest, -furthest});
    position_ = widen(narrow(within));
    axes_ = axes;
}

void Camera::set_transform(Vec3 position, const Mat3& rotation) {
    place(position, {rotation.x, rotation.y, rotation.z * z_sign()});
}

gphys_status Camera::set_world_matrix(const Mat4& world) {
    // The elements are floats, so a matrix this close to a singular one may be a singular one that was rounded.
    // Rounding moves each unit column by at most 2^-24, and therefore their volume by 3 * 2^-24.
    constexpr double smallest_volume = 0x1p-22;
    const Vec3 x{world(0, 0), world(1, 0), world(2, 0)};
    const Vec3 y{world(0, 1), world(1, 1), world(2, 1)};
    const Vec3 z{world(0, 2), world(1, 2), world(2, 2)};
    if (x == Vec3{} || y == Vec3{} || z == Vec3{})
        return fail(GPHYS_ERROR_SINGULAR, "world: the length of an axis is 0");
    const double volume = dot(normalized(x), cross(normalized(y), normalized(z)));
    if (std::fabs(volume) <= smallest_volume)
        return fail(GPHYS_ERROR_SINGULAR, "world: the axes are linearly dependent");
    if (volume < 0) return fail(GPHYS_ERROR_INVALID_ARGUMENT, "world: the axes include a reflection");
    const Vec3 forward = normalized(z) * z_sign();
    Vec3 up;
    perpendicular_part(y, forward, up);  // never parallel: the volume would be 0
    place({world(0, 3), world(1, 3), world(2, 3)}, {right_of(up, forward, z_sign()), up, forward});
    return GPHYS_OK;
}

// The world matrix is the inverse of the view matrix, not the transpose of its rotation. So a view whose axes have
// drifted from orthonormal ones is handled as its matrix says, and corrected as a world matrix is.
gphys_status Camera::set_view_matrix(const Mat4& view) {
    Mat4 world;
    if (!inverse(view, world)) return fail(GPHYS_ERROR_SINGULAR, "view: the matrix has no inverse");
    if (max_component(abs(Vec3{world(0, 3), world(1, 3), world(2, 3)})) > GPHYS_MAX_COORDINATE) {
        return fail(GPHYS_ERROR_INVALID_ARGUMENT, "view: the camera would be beyond GPHYS_MAX_COORDINATE");
    }
    return set_world_matrix(world);
}

void Camera::look_at(Vec3 eye, Vec3 target, Vec3 up) {
    const Vec3 forward = normalized(target - eye);
    Vec3 true_up;
    if (!perpendicular_part(up, forward, true_up)) true_up = perpendicular(forward);
    place(eye, {right_of(true_up, forward, z_sign()), true_up, forward});
}

void Camera::set_orbit(const gphys_orbit& settings) {
    orbit_.emplace(settings, z_sign());
    follow_orbit();
}

void Camera::follow_orbit() { place(orbit_->position(), orbit_->axes()); }

bool Camera::set_origin(Vec3 origin) {
    WorldPlace world = world_;
    const Vec3 position = world.move_origin(origin_, origin, narrow(position_));
    if (max_component(abs(position)) > GPHYS_MAX_COORDINATE) return false;
    if (orbit_) orbit_->shift(origin_ - origin);
    place(position, axes_);
    world_ = world;
    origin_ = origin;
    return true;
}

Mat3 Camera::rotation() const { return {axes_.x, axes_.y, axes_.z * z_sign()}; }

Mat4 Camera::world_matrix() const {
    const Mat3 own = rotation();
    Mat4 world;
    for (int row = 0; row < 3; ++row) {
        world(row, 0) = own.x[row];
        world(row, 1) = own.y[row];
        world(row, 2) = own.z[row];
        world(row, 3) = position_[row];
    }
    world(3, 3) = 1;
    return world;
}

Mat4 Camera::view_matrix() const {
    const Mat3 own = rotation();
    const Vec3 offset = transpose_times(own, position_);
    Mat4 view;
    for (int column = 0; column < 3; ++column) {
        view(0, column) = own.x[column];
        view(1, column) = own.y[column];
        view(2, column) = own.z[column];
    }
    for (int row = 0; row < 3; ++row) view(row, 3) = -offset[row];
    view(3, 3) = 1;
    return view;
}

Mat4 Camera::projection_matrix() const {
    Mat4 matrix = std::visit([this](const auto& kind) { return kind.matrix(depth_range_); }, projection_);
    for (int row = 0; row < 4; ++row) matrix(row, 2) *= z_sign();
    return matrix;
}

Mat4 Camera::view_projection_matrix() const { return projection_matrix() * view_matrix(); }

Frustum Camera::frustum(const Window& window) const {
    Frustum seen;
    seen.origin = position_;
    std::visit([&](const auto& kind) { kind.planes(depth_range_, window, seen.planes); }, projection_);
    for (Plane& plane : seen.planes) plane.normal = axes_ * plane.normal;
    return seen;
}

Window Camera::window_of_pixels(double x0, double y0, double x1, double y1) const {
    const Vec3 left_bottom = to_image({std::min(x0, x1), std::max(y0, y1), 0});
    const Vec3 right_top = to_image({std::max(x0, x1), std::min(y0, y1), 0});
    return {left_bottom.x, right_top.x, left_bottom.y, right_top.y};
}

Frustum Camera::frustum_of_pixels(double x0, double y0, double x1, double y1) const {
    return frustum(window_of_pixels(x0, y0, x1, y1));
}

bool Camera::corners(Vec3 out[8], const Window& window) const {
    const double x[4] = {window.left, window.right, window.right, window.left};
    const double y[4] = {window.bottom, window.bottom, window.top, window.top};
    Vec3 lens_corners[8];
    for (int i = 0; i < 8; ++i) {
        const Vec3 image{x[i % 4], y[i % 4], i < 4 ? depth_range_.near_depth : depth_range_.far_depth};
        const bool finite = std::visit(
            [&](const auto& kind) { return kind.unproject(depth_range_, image, lens_corners[i]); }, projection_);
        if (!finite) return false;
    }
    for (Vec3& corner : lens_corners) {
        corner = to_world(corner);
        if (!(max_component(abs(corner)) <= double{std::numeric_limits<float>::max()})) return false;
    }
    std::copy(lens_corners, lens_corners + 8, out);
    return true;
}

bool Camera::project(Vec3 point, Vec3& pixel) const {
    const Vec3 lens_point = transpose_times(axes_, point - position_);
    Vec3 image;
    const bool in_front =
        std::visit([&](const auto& kind) { return kind.project(depth_range_, lens_point, image); }, projection_);
    if (!in_front) return false;
    const Vec3 found{left_ + 0.5 * (1 + image.x) * width_, top_ + 0.5 * (1 - image.y) * height_, image.z};
    if (max_component(abs(found)) > GPHYS_MAX_COORDINATE) return false;
    pixel = found;
    return true;
}

bool Camera::unproject(Vec3 pixel, Vec3& point) const {
    Vec3 lens_point;
    const bool finite = std::visit(
        [&](const auto& kind) { return kind.unproject(depth_range_, to_image(pixel), lens_point); }, projection_);
    if (!finite) return false;
    const Vec3 found = to_world(lens_point);
    if (max_component(abs(found)) > GPHYS_MAX_COORDINATE) return false;
    point = found;
    return true;
}

bool Camera::pick_ray(double pixel_x, double pixel_y, Ray& ray) const {
    const Vec3 image = to_image({pixel_x, pixel_y, 0});
    const auto* const perspective = std::get_if<Perspective>(&projection_);
    Ray lens_ray;
    if (perspective && pick_start_ == GPHYS_PICK_FROM_CENTRE) {
        lens_ray = perspective->cast_from_centre(image.x, image.y);
    } else if (!std::visit([&](const auto& kind) { return kind.cast(depth_range_, image.x, image.y, lens_ray); },
                           projection_)) {
        return false;
    }
    ray = {to_world(lens_ray.origin), axes_ * lens_ray.direction, lens_ray.t_max};
    // A camera at the limit of the range may see points beyond it, which no query accepts.
    return max_component(abs(ray.origin)) <= GPHYS_MAX_COORDINATE && length_squared(ray.direction) > 0;
}

}  // namespace gphys

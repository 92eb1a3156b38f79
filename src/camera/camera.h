// The camera: a projection, a viewport and a pose, and the matrices, frusta and rays derived from them. Everything is
// computed in double from the camera's parameters and relative to its position. No view-projection matrix is inverted,
// because that loses precision (Upchurch, Desbrun 2012).
#pragma once

#include <optional>
#include <variant>

#include "camera/orbit.h"
#include "camera/projection.h"
#include "foundation/memory.h"

namespace gphys {

class Camera {
public:
    Camera(const gphys_allocator* hooks, const gphys_camera_desc& desc);

    Memory memory;

    /// An aspect or width of 0 means that of the viewport. Returns false if an orthographic camera would see farther
    /// than GPHYS_MAX_COORDINATE to the side.
    void set_perspective(double fov_y, double near_distance, double far_distance, double aspect = 0);
    bool set_orthographic(double height, double near_distance, double far_distance, double width = 0);
    /// From the camera's own axes to clip space.
    gphys_status set_projection(const Mat4& projection);
    /// Returns false as set_orthographic does.
    bool set_viewport(double width, double height);
    /// The viewport's top left corner, in pixels of the window.
    void set_viewport_origin(double x, double y) { left_ = x, top_ = y; }
    void set_pick_start(gphys_pick_start start) { pick_start_ = start; }

    /// As set: radians or metres. 0 for a matrix, which has no distances either.
    struct ProjectionSettings {
        gphys_projection kind;
        double size, near_distance, far_distance;
    };
    ProjectionSettings projection_settings() const;
    gphys_handedness handedness() const { return handedness_; }
    const DepthRange& depth_range() const { return depth_range_; }
    double viewport_width() const { return width_; }
    double viewport_height() const { return height_; }
    double viewport_left() const { return left_; }
    double viewport_top() const { return top_; }
    gphys_pick_start pick_start() const { return pick_start_; }
    /// Width over height of the image.
    double aspect() const { return aspect_ > 0 ? aspect_ : width_ / height_; }
    bool has_own_aspect() const { return aspect_ > 0; }
    /// The size of the image: at distance 1 for a perspective, in metres for an orthographic projection, 0 for a
    /// matrix.
    void image_size(double& width, double& height) const;

    /// The rotation takes the camera's own axes to the world's.
    void set_transform(Vec3 position, const Mat3& rotation);
    gphys_status set_world_matrix(const Mat4& world);
    gphys_status set_view_matrix(const Mat4& view);
    void look_at(Vec3 eye, Vec3 target, Vec3 up);

    void set_orbit(const gphys_orbit& settings);
    /// Null until set_orbit.
    Orbit* orbit() { return orbit_ ? &*orbit_ : nullptr; }
    const Orbit* orbit() const { return orbit_ ? &*orbit_ : nullptr; }
    /// Set the pose of the camera from its orbit.
    void follow_orbit();

    /// The camera stays where it is in the world. Returns false if that would be out of the range of coordinates.
    bool set_origin(Vec3 origin);
    Vec3 origin() const { return origin_; }

    Vec3 position() const { return position_; }
    /// The camera's own axes in the world: right, up, and forward (left-handed) or back.
    Mat3 rotation() const;
    Mat4 world_matrix() const;
    Mat4 view_matrix() const;
    Mat4 projection_matrix() const;
    Mat4 view_projection_matrix() const;

    /// The frustum of a window of the image.
    Frustum frustum(const Window& window = {}) const;
    /// The frustum of a rectangle of pixels, whose corners may be in any order.
    Frustum frustum_of_pixels(double x0, double y0, double x1, double y1) const;
    /// In the order of gphys_frustum_corners. False with an infinite far plane, or a corner beyond the largest float.
    bool corners(Vec3 out[8], const Window& window = {}) const;
    /// The window of a rectangle of pixels, whose corners may be in any order.
    Window window_of_pixels(double x0, double y0, double x1, double y1) const;

    /// Pixels are (x, y, depth). False if the point has no image, or no finite one.
    bool project(Vec3 point, Vec3& pixel) const;
    bool unproject(Vec3 pixel, Vec3& point) const;
    /// Returns false if the pixel's line of sight has no start because it does not hit the near plane.
    bool pick_ray(double pixel_x, double pixel_y, Ray& ray) const;

private:
    /// 1 if the camera's own z axis is its view direction, -1 if it is the opposite.
    double z_sign() const { return handedness_ == GPHYS_LEFT_HANDED ? 1 : -1; }
    Vec3 to_world(Vec3 lens_point) const { return position_ + axes_ * lens_point; }
    Vec3 to_image(Vec3 pixel) const {
        return {2 * (pixel.x - left_) / width_ - 1, 1 - 2 * (pixel.y - top_) / height_, pixel.z};
    }
    void place(Vec3 position, const Mat3& axes);

    gphys_handedness handedness_;
    DepthRange depth_range_;
    double width_, height_;      // pixels
    double left_ = 0, top_ = 0;  // pixels
    double aspect_ = 0;          // 0: the viewport's
    double fov_y_;               // of a perspective; the projection keeps only its tangent
    gphys_pick_start pick_start_ = GPHYS_PICK_FROM_NEAR_PLANE;
    std::variant<Perspective, Orthographic, UserProjection> projection_;
    Vec3 origin_;       // in the world, of the position
    WorldPlace world_;  // of the position
    Vec3 position_;
    Mat3 axes_;  // right, up, forward in the world; the mirror image of a rotation if right-handed
    std::optional<Orbit> orbit_;
};

}  // namespace gphys

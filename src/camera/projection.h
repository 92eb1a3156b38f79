// The projections of a camera, in lens coordinates: x to the right, y up, z forward from the camera's position,
// whatever its handedness. An image point is (x, y, depth) in normalised device coordinates: x and y from -1 to 1 over
// the viewport, y up. Each kind of projection has the same functions:
//   matrix     lens to clip space
//   project    where is the image of a point? False if the point is not in front of the camera.
//   unproject  which point has this image? False if it would be at infinity or beyond.
//   cast       the ray from the near plane to the far one that has its image in (x, y), of unit direction. False if
//              it has no start.
//   planes     the half spaces of the volume seen in a window, in the order of gphys_frustum
#pragma once

#include "camera/clip_space.h"

namespace gphys {

/// Two tangents and two distances determine the rest.
struct Perspective {
    double half_width, half_height;  // of the image at distance 1: tangents of the half angles
    double near_distance, far_distance;

    Mat4 matrix(const DepthRange& depth_range) const;
    bool project(const DepthRange& depth_range, Vec3 point, Vec3& image) const;
    bool unproject(const DepthRange& depth_range, Vec3 image, Vec3& point) const;
    bool cast(const DepthRange& depth_range, double x, double y, Ray& ray) const;
    /// The same ray from the camera's position on.
    Ray cast_from_centre(double x, double y) const;
    void planes(const DepthRange& depth_range, const Window& window, Plane out[6]) const;
};

struct Orthographic {
    double half_width, half_height;  // metres
    double near_distance, far_distance;

    Mat4 matrix(const DepthRange& depth_range) const;
    bool project(const DepthRange& depth_range, Vec3 point, Vec3& image) const;
    bool unproject(const DepthRange& depth_range, Vec3 image, Vec3& point) const;
    bool cast(const DepthRange& depth_range, double x, double y, Ray& ray) const;
    void planes(const DepthRange& depth_range, const Window& window, Plane out[6]) const;
};

/// Any invertible matrix.
struct UserProjection {
    Mat4 to_clip, from_clip;

    Mat4 matrix(const DepthRange&) const { return to_clip; }
    bool project(const DepthRange& depth_range, Vec3 point, Vec3& image) const;
    bool unproject(const DepthRange& depth_range, Vec3 image, Vec3& point) const;
    bool cast(const DepthRange& depth_range, double x, double y, Ray& ray) const;
    void planes(const DepthRange& depth_range, const Window& window, Plane out[6]) const;
    /// Whether the four corners of the image are in front of the camera on the near plane, within the range of floats,
    /// so that the visible volume has a start.
    bool has_near_corners(const DepthRange& depth_range) const;
};

}  // namespace gphys

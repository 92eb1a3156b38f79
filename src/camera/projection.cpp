// The three projections (projection.h): perspective, orthographic, and any matrix.
#include "camera/projection.h"

namespace gphys {
namespace {

/// Near and far plane, perpendicular to the view direction. An infinite far plane has normal 0 and distance -1.
void depth_planes(double near_distance, double far_distance, Plane out[6]) {
    out[GPHYS_FRUSTUM_NEAR] = {{0, 0, 1}, near_distance};
    out[GPHYS_FRUSTUM_FAR] = far_distance < infinity ? Plane{{0, 0, -1}, -far_distance} : Plane{{0, 0, 0}, -1};
}

}  // namespace

// Depth is linear in 1 / z. Written with the weights of the two planes,
//   near_weight = n (f - z) / ((f - n) z),  far_weight = f (z - n) / ((f - n) z),
// no digits cancel next to either plane; an infinite f is the limit.

Mat4 Perspective::matrix(const DepthRange& depth_range) const {
    const double n = near_distance, f = far_distance;
    const double at_near = depth_range.near_depth, at_far = depth_range.far_depth;
    Mat4 m;
    m(0, 0) = 1 / half_width;
    m(1, 1) = 1 / half_height;
    m(2, 2) = f < infinity ? (at_far * f - at_near * n) / (f - n) : at_far;
    m(2, 3) = f < infinity ? (at_near - at_far) * n * f / (f - n) : (at_near - at_far) * n;
    m(3, 2) = 1;
    return m;
}

bool Perspective::project(const DepthRange& depth_range, Vec3 point, Vec3& image) const {
    const double n = near_distance, f = far_distance, z = point.z;
    if (z <= 0) return false;
    const double near_weight = f < infinity ? n * (f - z) / ((f - n) * z) : n / z;
    const double far_weight = f < infinity ? f * (z - n) / ((f - n) * z) : (z - n) / z;
    image = {point.x / (half_width * z), point.y / (half_height * z), depth_range.depth(near_weight, far_weight)};
    return true;
}

bool Perspective::unproject(const DepthRange& depth_range, Vec3 image, Vec3& point) const {
    const double n = near_distance, f = far_distance;
    const double near_weight = depth_range.near_weight(image.z), far_weight = depth_range.far_weight(image.z);
    // 1 / z = near_weight / n + far_weight / f, over the common denominator n f.
    const double denominator = f < infinity ? f * near_weight + n * far_weight : near_weight;
    if (denominator <= 0) return false;
    const double z = f < infinity ? n * f / denominator : n / denominator;
    point = {image.x * half_width * z, image.y * half_height * z, z};
    return true;
}

Ray Perspective::cast_from_centre(double x, double y) const {
    const Vec3 at_distance_one{x * half_width, y * half_height, 1};
    const double stretch = length(at_distance_one);
    return {{}, at_distance_one / stretch, far_distance * stretch};
}

bool Perspective::cast(const DepthRange&, double x, double y, Ray& ray) const {
    const Vec3 at_distance_one{x * half_width, y * half_height, 1};
    const double stretch = length(at_distance_one);
    ray = {at_distance_one * near_distance, at_distance_one / stretch, (far_distance - near_distance) * stretch};
    return true;
}

void Perspective::planes(const DepthRange&, const Window& window, Plane out[6]) const {
    depth_planes(near_distance, far_distance, out);
    out[GPHYS_FRUSTUM_LEFT] = {normalized(Vec3{1, 0, -window.left * half_width}), 0};
    out[GPHYS_FRUSTUM_RIGHT] = {normalized(Vec3{-1, 0, window.right * half_width}), 0};
    out[GPHYS_FRUSTUM_BOTTOM] = {normalized(Vec3{0, 1, -window.bottom * half_height}), 0};
    out[GPHYS_FRUSTUM_TOP] = {normalized(Vec3{0, -1, window.top * half_height}), 0};
}

Mat4 Orthographic::matrix(const DepthRange& depth_range) const {
    const double n = near_distance, f = far_distance;
    const double at_near = depth_range.near_depth, at_far = depth_range.far_depth;
    Mat4 m;
    m(0, 0) = 1 / half_width;
    m(1, 1) = 1 / half_height;
    m(2, 2) = (at_far - at_near) / (f - n);
    m(2, 3) = (at_near * f - at_far * n) / (f - n);
    m(3, 3) = 1;
    return m;
}

bool Orthographic::project(const DepthRange& depth_range, Vec3 point, Vec3& image) const {
    const double n = near_distance, f = far_distance;
    image = {point.x / half_width, point.y / half_height,
             depth_range.depth((f - point.z) / (f - n), (point.z - n) / (f - n))};
    return true;
}

bool Orthographic::unproject(const DepthRange& depth_range, Vec3 image, Vec3& point) const {
    const double z = near_distance * depth_range.near_weight(image.z) + far_distance * depth_range.far_weight(image.z);
    point = {image.x * half_width, image.y * half_height, z};
    return true;
}

bool Orthographic::cast(const DepthRange&, double x, double y, Ray& ray) const {
    ray = {{x * half_width, y * half_height, near_distance}, {0, 0, 1}, far_distance - near_distance};
    return true;
}

void Orthographic::planes(const DepthRange&, const Window& window, Plane out[6]) const {
    depth_planes(near_distance, far_distance, out);
    out[GPHYS_FRUSTUM_LEFT] = {{1, 0, 0}, window.left * half_width};
    out[GPHYS_FRUSTUM_RIGHT] = {{-1, 0, 0}, -window.right * half_width};
    out[GPHYS_FRUSTUM_BOTTOM] = {{0, 1, 0}, window.bottom * half_height};
    out[GPHYS_FRUSTUM_TOP] = {{0, -1, 0}, -window.top * half_height};
}

namespace {

Vec3 direction_part(Vec4 h) { return {h.x, h.y, h.z}; }

/// Whether the homogeneous point from_clip * image is in front of the camera and not at infinity. Its w is a sum of
/// four rounded products with inverse elements, which carry a few roundings themselves. A w below 2^-48 of the
/// magnitude of the terms cannot be distinguished from 0.
bool is_finite(const Mat4& from_clip, Vec3 image, double w) {
    const double terms = std::fabs(from_clip(3, 0) * image.x) + std::fabs(from_clip(3, 1) * image.y) +
                         std::fabs(from_clip(3, 2) * image.z) + std::fabs(from_clip(3, 3));
    return w > 0x1p-48 * terms;
}

}  // namespace

bool UserProjection::project(const DepthRange&, Vec3 point, Vec3& image) const {
    const Vec4 clip = to_clip * Vec4{point.x, point.y, point.z, 1};
    if (clip.w <= 0) return false;
    image = direction_part(clip) / clip.w;
    return true;
}

bool UserProjection::unproject(const DepthRange&, Vec3 image, Vec3& point) const {
    const Vec4 h = from_clip * Vec4{image.x, image.y, image.z, 1};
    if (!is_finite(from_clip, image, h.w)) return false;
    point = direction_part(h) / h.w;
    return true;
}

// The points with this image are (1 - s) start + s end in homogeneous coordinates. At s = 0 they move along end.xyz
// start.w - start.xyz end.w, which is defined for an end at infinity, too.
bool UserProjection::cast(const DepthRange& depth_range, double x, double y, Ray& ray) const {
    const Vec3 end_image{x, y, depth_range.far_depth};
    const Vec4 start = from_clip * Vec4{x, y, depth_range.near_depth, 1};
    const Vec4 end = from_clip * Vec4{x, y, depth_range.far_depth, 1};
    const Vec3 along = direction_part(end) * start.w - direction_part(start) * end.w;
    // A pixel has no ray if double precision does not distinguish the two planes.
    if (start.w <= 0 || along == Vec3{}) return false;
    ray.origin = direction_part(start) / start.w;
    ray.direction = normalized(along);
    ray.t_max = is_finite(from_clip, end_image, end.w) ? distance(direction_part(end) / end.w, ray.origin) : infinity;
    return true;
}

bool UserProjection::has_near_corners(const DepthRange& depth_range) const {
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            Vec3 corner;
            if (!unproject(depth_range, {x, y, depth_range.near_depth}, corner)) return false;
            if (!(max_component(abs(corner)) <= double{std::numeric_limits<float>::max()})) return false;
        }
    }
    return true;
}

void UserProjection::planes(const DepthRange& depth_range, const Window& window, Plane out[6]) const {
    clip_planes(to_clip, depth_range, window, out);
}

}  // namespace gphys

// Cores and their Minkowski difference: support points and projections (convex.h).
#include "geometry/convex.h"

#include <algorithm>

namespace gphys {

Core core_of(const Sphere& sphere) {
    Core core;
    core.center = sphere.center;
    core.radius = sphere.radius;
    return core;
}

Core core_of(const Capsule& capsule) {
    Core core;
    core.axes[0] = (capsule.b - capsule.a) * 0.5;
    core.half[0] = 1;
    core.axis_count = core.axes[0] != Vec3{};
    core.center = capsule.a + core.axes[0];
    core.radius = capsule.radius;
    return core;
}

Core core_of(const Aabb& box) { return core_of(as_obb(box)); }

Core core_of(const Obb& box) {
    Core core;
    core.center = box.center;
    core.axis_count = 3;
    core.axes[0] = box.axes.x;
    core.axes[1] = box.axes.y;
    core.axes[2] = box.axes.z;
    for (int k = 0; k < 3; ++k) core.half[k] = box.half[k];
    return core;
}

Hexahedron core_of(const Frustum& frustum) {
    Vec3 corner[8];
    corners(frustum, corner);
    Hexahedron core;
    core.corner = corner[0];
    // Those of a frustum go around each face.
    for (int i = 0; i < 8; ++i) core.corners[i ^ (i >> 1 & 1)] = corner[i] - corner[0];
    for (int i = 0; i < 6; ++i) core.normals[i] = normalized(frustum.planes[i].normal);
    Vec3* edge = core.edges;
    for (int i = 0; i < 6; ++i) {
        for (int k = i / 2 * 2 + 2; k < 6; ++k) {
            // Not from the normals of length 1: their rounding turns the edge of almost parallel planes.
            *edge++ = unit_across({}, frustum.planes[i].normal, {}, frustum.planes[k].normal);
        }
    }
    return core;
}

ConvexDifference::ConvexDifference(const Core& other, const Core& moving)
    : center_(other.center - moving.center),
      other_center_(other.center),
      axis_count_(other.axis_count + moving.axis_count),
      other_axis_count_(other.axis_count),
      radius_(other.radius + moving.radius),
      other_radius_(other.radius) {
    for (int k = 0; k < axis_count_; ++k) {
        const bool is_other = k < other.axis_count;
        axes_[k] = is_other ? other.axes[k] : moving.axes[k - other.axis_count];
        half_[k] = is_other ? other.half[k] : moving.half[k - other.axis_count];
    }
}

ConvexDifference::ConvexDifference(const Triangle& other, const Core& moving)
    : ConvexDifference(core_of(Sphere{other.a, 0}), moving) {
    corner_count_ = 3;
    corners_[1] = other.b - other.a;
    corners_[2] = other.c - other.a;
}

ConvexDifference::ConvexDifference(const Hexahedron& other, const Core& moving)
    : ConvexDifference(core_of(Sphere{other.corner, 0}), moving) {
    corner_count_ = 8;
    hexahedron_ = &other;
}

double ConvexDifference::size() const {
    Vec3 furthest;
    for (int i = 1; i < corner_count_; ++i) furthest = max(furthest, abs(corners()[i]));
    Vec3 reach = abs(center_) + furthest;
    for (int k = 0; k < axis_count_; ++k) reach += abs(axes_[k]) * half_[k];
    return max_component(reach) + radius_;
}

Vec3 ConvexDifference::line() const {
    Vec3 line = length_squared(corners_[2]) > length_squared(corners_[1]) ? corners_[2] : corners_[1];
    if (axis_count_ > 0) line = axes_[0];
    return line == Vec3{} ? line : normalized(line);
}

Vec3 ConvexDifference::across() const {
    const Vec3 along = line();
    return along == Vec3{} ? Vec3{1, 0, 0} : perpendicular(along);
}

ConvexDifference ConvexDifference::after(Vec3 displacement) const {
    ConvexDifference result = *this;
    result.center_ -= displacement;
    return result;
}

void ConvexDifference::project(Vec3 vector, double& low, double& high) const {
    const double middle = dot(vector, center_);
    double reach = 0;
    for (int k = 0; k < axis_count_; ++k) reach += half_[k] * std::fabs(dot(vector, axes_[k]));
    low = middle - reach;
    high = middle + reach;
    if (corner_count_ == 1) return;
    double least = 0, most = 0;
    for (int i = 1; i < corner_count_; ++i) {
        const double height = dot(vector, corners()[i]);
        least = std::min(least, height);
        most = std::max(most, height);
    }
    low += least;
    high += most;
}

ConvexDifference::Corner ConvexDifference::furthest(Vec3 vector) const {
    Corner corner{center_, other_center_};
    for (int k = 0; k < axis_count_; ++k) {
        const Vec3 way = axes_[k] * (dot(vector, axes_[k]) < 0 ? -half_[k] : half_[k]);
        corner.difference += way;
        if (k < other_axis_count_) corner.on_other += way;
    }
    if (corner_count_ == 1) return corner;
    int highest = 0;
    double most = 0;
    for (int i = 1; i < corner_count_; ++i) {
        const double height = dot(vector, corners()[i]);
        if (height > most) most = height, highest = i;
    }
    const Vec3 way = corners()[highest];
    corner.difference += way;
    corner.on_other += way;
    return corner;
}

}  // namespace gphys

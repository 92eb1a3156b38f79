// The quick tests of a ray, of a point with a reach (a sphere, or the nearest so far) and of a box.
#pragma once

#include "scene/quick_shape.h"

namespace gphys {

/// By how much two amounts differ for certain; `error` covers both.
inline Verdict at_most(double a, double b, double error) {
    return a > b + error ? Verdict::no : a + error < b ? Verdict::yes : Verdict::open;
}

/// Whether a ray meets a shape by the time t_max.
class QuickRay {
public:
    explicit QuickRay(const Ray& ray)
        : origin_(ray.origin),
          direction_(ray.direction),
          direction_squared_(length_squared(ray.direction)),
          origin_magnitude_(sum(abs(ray.origin))),
          direction_slack_(slack * sum(abs(ray.direction))) {}

    template <class QuickShape>
    Verdict operator()(const QuickShape& shape, double t_max) const {
        return verdict<true>(shape, t_max);
    }
    /// The same where only a "no" is of use.
    template <class QuickShape>
    Verdict refuses(const QuickShape& shape, double t_max) const {
        return verdict<false>(shape, t_max);
    }

private:
    /// In Haines's terms (raycast.cpp), with the roots left undrawn: what happens at t_max is told by
    /// which side of the surface, and of the point closest to the centre, the ray is then.
    template <bool also_yes>
    Verdict verdict(const QuickSphere& sphere, double t_max) const {
        const Vec3 from = origin_ - sphere.center;
        const double dd = direction_squared_, magnitude = origin_magnitude_ + sphere.magnitude;
        const double b = -dot(from, direction_), b_error = direction_slack_ * magnitude;
        const double c = length_squared(from) - sphere.radius * sphere.radius, c_error = slack * magnitude * magnitude;
        if (also_yes && c < -c_error) return Verdict::yes;
        const double discriminant = b * b - dd * c, error = dd * c_error;
        const double to_go = b - dd * clipped(t_max);
        if (c > c_error) {
            if ((b < -b_error) | (discriminant < -error)) return Verdict::no;
            // Only before the closest point is t_max small enough for a product with it.
            if (to_go > b_error && c - clipped(t_max) * (b + to_go) > c_error) return Verdict::no;
        }
        return also_yes && b > b_error && discriminant > error && to_go < -b_error ? Verdict::yes : Verdict::open;
    }

    /// The slabs of a box, with times left as fractions: a distance over the speed along the axis.
    /// Margins make distances and speeds such that the ray certainly misses, or certainly meets.
    template <bool also_yes>
    Verdict verdict(const QuickBox& box, double t_max) const {
        const Vec3 from = box.local(origin_), along = transpose_times(box.axes, direction_);
        const double margin = slack * box.unit * (origin_magnitude_ + box.magnitude);
        const double speed_margin = direction_slack_ * box.unit, end = clipped(t_max);
        double near[3], far[3], slow[3], fast[3];
        for (int k = 0; k < 3; ++k) {
            const double to_center = along[k] < 0 ? from[k] : -from[k], half = box.half[k] * box.unit;
            near[k] = to_center - half - margin;
            far[k] = to_center + half + margin;
            slow[k] = std::max(std::fabs(along[k]) - speed_margin, 0.0);
            fast[k] = std::fabs(along[k]) + speed_margin;
        }
        // No branches between: which of them decides is not to be foreseen.
        bool missed = false;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            missed |= (far[k] < 0) | (near[k] > end * fast[k]) | (near[k] * slow[i] > far[i] * fast[k]) |
                      (near[k] * slow[j] > far[j] * fast[k]);
        }
        if (missed) return Verdict::no;
        if (!also_yes) return Verdict::open;
        bool met = true;
        for (int k = 0; k < 3; ++k) {
            near[k] = std::max(near[k] + 2 * margin, 0.0);
            far[k] -= 2 * margin;
        }
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            met &= (far[k] > 0) & (near[k] <= end * slow[k]) & (near[k] * fast[i] <= far[i] * slow[k]) &
                   (near[k] * fast[j] <= far[j] * slow[k]);
        }
        return met ? Verdict::yes : Verdict::open;
    }

    /// The box of the mesh is for mesh_instance.cpp, which has the ray in the mesh's space.
    template <bool also_yes>
    Verdict verdict(const QuickMesh& mesh, double t_max) const {
        return verdict<also_yes>(mesh.sphere(), t_max);
    }

    /// An infinite t_max would make NaN of 0. With coordinates and directions of floats nothing is
    /// met later than this.
    static double clipped(double t_max) { return std::min(t_max, 0x1p600); }

    Vec3 origin_, direction_;
    double direction_squared_, origin_magnitude_, direction_slack_;
};

/// Whether a shape comes within `reach` of a point.
class QuickPoint {
public:
    explicit QuickPoint(Vec3 point) : point_(point), magnitude_(sum(abs(point))) {}

    Verdict operator()(const QuickSphere& sphere, double reach) const {
        const double both = sphere.radius + reach, magnitude = magnitude_ + sphere.magnitude + reach;
        return at_most(length_squared(point_ - sphere.center), both * both, slack * magnitude * magnitude);
    }
    Verdict operator()(const QuickBox& box, double reach) const {
        const Vec3 outside = max(abs(box.local(point_)) - box.half * box.unit, {});
        const double scaled_reach = reach * box.unit, magnitude = box.unit * (magnitude_ + box.magnitude + reach);
        return at_most(length_squared(outside), scaled_reach * scaled_reach, slack * magnitude * magnitude);
    }

private:
    Vec3 point_;
    double magnitude_;
};

/// Whether a box overlaps a shape.
class QuickBlock {
public:
    explicit QuickBlock(const Obb& box)
        : box_(box),
          turned_(!(box.axes.x == Vec3{1, 0, 0} && box.axes.y == Vec3{0, 1, 0})),
          magnitude_(sum(abs(box.center)) + sum(box.half)) {}

    Verdict operator()(const QuickSphere& sphere) const {
        const Vec3 outside = max(abs(seen(sphere.center - box_.center)) - box_.half, {});
        const double magnitude = magnitude_ + sphere.magnitude;
        return at_most(length_squared(outside), sphere.radius * sphere.radius, slack * magnitude * magnitude);
    }

    /// The separating axes (overlap.cpp) in this box's own frame, where one factor of each product
    /// is an axis of coordinates. All distances are times `unit`.
    Verdict operator()(const QuickBox& other) const {
        const Vec3 offset = seen(other.center - box_.center);
        const Vec3 axes[3] = {seen(other.axes.x), seen(other.axes.y), seen(other.axes.z)};
        const Vec3 size[3] = {abs(axes[0]), abs(axes[1]), abs(axes[2])};
        const double margin = slack * other.unit * (magnitude_ + other.magnitude);

        const Vec3 reach = size[0] * other.half.x + size[1] * other.half.y + size[2] * other.half.z;
        const Vec3 from_center = abs(offset) * other.unit - box_.half * other.unit;
        if (max_component(from_center) < -margin) return Verdict::yes;
        double gap = max_component(from_center - reach);
        for (int j = 0; j < 3; ++j) {
            gap = std::max(gap, std::fabs(dot(axes[j], offset)) - other.half[j] * other.unit - dot(size[j], box_.half));
        }
        if (gap > margin) return Verdict::no;
        for (int i = 0; i < 3; ++i) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            for (int j = 0; j < 3; ++j) {
                const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
                const double distance = std::fabs(offset[i2] * axes[j][i1] - offset[i1] * axes[j][i2]);
                const double own = box_.half[i1] * size[j][i2] + box_.half[i2] * size[j][i1];
                const double others = other.half[j1] * size[j2][i] + other.half[j2] * size[j1][i];
                gap = std::max(gap, distance - own - others);
            }
        }
        return at_most(gap, 0, margin);
    }

private:
    Vec3 seen(Vec3 v) const { return turned_ ? transpose_times(box_.axes, v) : v; }

    Obb box_;
    bool turned_;
    double magnitude_;
};

// The quick test of an overlap with a query shape: a function of a quick shape.

inline auto quick_overlap(const Sphere& query) {
    return [point = QuickPoint(query.center), reach = query.radius](const auto& shape) { return point(shape, reach); };
}
inline auto quick_overlap(const Aabb& query) { return QuickBlock(as_obb(query)); }
inline auto quick_overlap(const Obb& query) { return QuickBlock(query); }
template <class Query>
auto quick_overlap(const Query&) {
    return [](const auto&) { return Verdict::open; };
}

}  // namespace gphys

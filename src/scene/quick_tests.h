// The quick tests of a ray, of a point with a reach (a sphere, or the nearest so far) and of a box.
#pragma once

#include "scene/quick_shape.h"

namespace gphys {

/// By how much two amounts differ for certain; `error` covers both.
inline Verdict at_most(double a, double b, double error) { return verdict_of(a > b + error, a + error < b); }

/// Whether a ray meets a shape by the time t_max.
class QuickRay {
public:
    explicit QuickRay(const Ray& ray)
        : origin_(ray.origin),
          direction_(ray.direction),
          direction_squared_(length_squared(ray.direction)),
          origin_magnitude_(sum(abs(ray.origin))),
          direction_slack_(slack * sum(abs(ray.direction))),
          direction_size_(std::max(max_component(abs(ray.direction)), least_speed)),
          unit_direction_(narrow4(ray.direction * (1 / direction_size_))),
          unit_direction_slack_(float_slack * sum(abs(unit_direction_))) {}

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
        const Vec3 from = origin_.exact - sphere.center;
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
    ///
    /// In float32, all axes at once.
    template <bool also_yes, class Stored>
    Verdict verdict(const QuickPlacedBox<Stored>& placed, double t_max) const {
        const BoxInSight<Stored> box(placed, origin_, origin_magnitude_);
        const Float4 along = box.turned_back(unit_direction_), speed_margin = unit_direction_slack_ * box.unit;
        const Float4 from = box.from, half = box.half, margin = box.margin;
        const Float4 to_center = along < Float4{} ? from : -from, speed = abs(along);
        const Float4 end = splat4(static_cast<float>(std::min(t_max * direction_size_, most_end)));
        const Float4 slow = positive(speed - speed_margin), fast = speed + speed_margin;
        Float4 near = to_center - half - margin, far = to_center + half + margin;
        // No branches between: which of them decides is not to be foreseen.
        if (any((far < Float4{}) | (near > end * fast) | (near * yzx(slow) > yzx(far) * fast) |
                (near * zxy(slow) > zxy(far) * fast))) {
            return Verdict::no;
        }
        if (!also_yes) return Verdict::open;
        near = positive(near + 2 * margin);
        far -= 2 * margin;
        const Mask4 unmet = (far <= Float4{}) | (near > end * slow) | (near * yzx(fast) > yzx(far) * slow) |
                            (near * zxy(fast) > zxy(far) * slow);
        return any(unmet & Mask4{-1, -1, -1, 0}) ? Verdict::open : Verdict::yes;
    }

    /// The box of the mesh is for mesh_instance.cpp, which has the ray in the mesh's space.
    template <bool also_yes>
    Verdict verdict(const QuickMesh& mesh, double t_max) const {
        return verdict<also_yes>(mesh.sphere(), t_max);
    }

    /// An infinite t_max would make NaN of 0. With coordinates and directions of floats nothing is
    /// met later than this.
    static double clipped(double t_max) { return std::min(t_max, 0x1p600); }

    SplitPoint origin_;
    Vec3 direction_;
    double direction_squared_, origin_magnitude_, direction_slack_;
    double direction_size_;  // its largest component
    Float4 unit_direction_;  // in parts of that
    Float4 unit_direction_slack_;
};

/// Whether a shape comes within `reach` of a point.
class QuickPoint {
public:
    explicit QuickPoint(Vec3 point) : point_(point), magnitude_(sum(abs(point))) {}

    Verdict operator()(const QuickSphere& sphere, double reach) const {
        const double both = sphere.radius + reach, magnitude = magnitude_ + sphere.magnitude + reach;
        return at_most(length_squared(point_.exact - sphere.center), both * both, slack * magnitude * magnitude);
    }
    Verdict operator()(const QuickBox& box, double reach) const {
        const Vec3 outside = max(abs(box.local(point_.exact)) - box.half * box.unit, {});
        const double scaled_reach = reach * box.unit, magnitude = box.unit * (magnitude_ + box.magnitude + reach);
        return at_most(length_squared(outside), scaled_reach * scaled_reach, slack * magnitude * magnitude);
    }
    /// In float32.
    template <class Stored>
    Verdict operator()(const QuickPlacedBox<Stored>& placed, double reach) const {
        const BoxInSight<Stored> box(placed, point_, magnitude_);
        const Float4 outside = abs(box.from) - box.half;
        const auto squared = [&](Float4 margin) {
            const Float4 gap = positive(outside + margin);
            return sum(gap * gap)[0];
        };
        const float far = static_cast<float>(std::min(reach, most_reach)) * box.unit[0], limit = far * far;
        return verdict_of(squared(-box.margin) > limit * (1 + square_slack) + smallest_square,
                          squared(box.margin) + smallest_square < limit * (1 - square_slack));
    }

private:
    SplitPoint point_;
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

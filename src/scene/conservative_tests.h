// The conservative tests of a ray, of a point with a radius (a sphere, or the nearest distance so far) and of a box,
// against the shapes of conservative_shape.h. They share the formulas of the exact tests (raycast_sphere.h,
// raycast_box.h, overlap_boxes.h), with margins for all roundings.
#pragma once

#include <optional>

#include "foundation/compiler.h"
#include "geometry/overlap_boxes.h"
#include "geometry/raycast_box.h"
#include "geometry/raycast_sphere.h"
#include "scene/conservative_shape.h"

namespace gphys {

/// Whether a <= b; `error` bounds the errors of both.
inline TriState at_most(double a, double b, double error) { return tri_state(a > b + error, a + error < b); }

/// Whether a ray hits a shape no later than at t_max.
class ConservativeRay {
public:
    /// meets_boxes: false saves what only boxes need, of which none may be tested then.
    explicit ConservativeRay(const Ray& ray, bool meets_boxes = true)
        : origin_(ray.origin),
          direction_(ray.direction),
          direction_squared_(ray.direction == Vec3{} ? 1 : length_squared(ray.direction)),
          origin_magnitude_(sum(abs(ray.origin))) {
        if (meets_boxes) for_boxes_.emplace(ray);
    }

    template <class ConservativeShape>
    TriState operator()(const ConservativeShape& shape, double t_max) const {
        return verdict<true>(shape, t_max);
    }
    /// The same, cheaper, for callers that use only "no".
    template <class ConservativeShape>
    TriState rejects(const ConservativeShape& shape, double t_max) const {
        return verdict<false>(shape, t_max);
    }

private:
    template <bool also_yes>
    TriState verdict(const ConservativeSphere& sphere, double t_max) const {
        const Vec3 closest = closest_on_ray(origin_ - sphere.center, direction_, direction_squared_, clipped(t_max));
        const double magnitude = origin_magnitude_ + sphere.magnitude;
        const TriState result =
            at_most(length_squared(closest), sphere.radius * sphere.radius, slack * magnitude * magnitude);
        return also_yes ? result : only_no(result);
    }

    /// In float32, with the three axes in one register.
    template <bool also_yes, class Stored>
    TriState verdict(const ConservativePlacedBox<Stored>& placed, double t_max) const {
        const RelativeBox<Stored> box(placed, for_boxes_->origin, origin_magnitude_);
        const Float4 end = splat4(static_cast<float>(std::min(t_max * for_boxes_->direction_size, most_end)));
        const RayAndBox<Float4> both(box.from, box.half, box.margin, box.to_box_axes(for_boxes_->unit_direction),
                                     for_boxes_->unit_direction_slack * box.unit, end);
        if (!both.may_hit()) return TriState::no;
        return also_yes && both.must_hit() ? TriState::yes : TriState::undecided;
    }

    /// Whether the side of the plane counts is left to the exact test.
    template <bool also_yes>
    TriState verdict(const ConservativePlane& plane, double t_max) const {
        return may_hit(plane, {origin_, direction_, t_max}) ? TriState::undecided : TriState::no;
    }

    /// mesh_instance.cpp tests the box of the mesh, with the ray in the mesh's space.
    template <bool also_yes>
    TriState verdict(const ConservativeMesh& mesh, double t_max) const {
        return verdict<also_yes>(mesh.sphere(), t_max);
    }

    /// An infinite t_max would give NaN with a zero component. With float coordinates and directions, no hit is later
    /// than this.
    static double clipped(double t_max) { return std::min(t_max, 0x1p600); }

    struct ForBoxes {
        explicit ForBoxes(const Ray& ray)
            : origin(ray.origin),
              direction_size(std::max(max_component(abs(ray.direction)), least_speed)),
              unit_direction(narrow4(ray.direction * (1 / direction_size))),
              unit_direction_slack(float_slack * sum(abs(unit_direction))) {}

        SplitPoint origin;
        double direction_size;  // its largest component
        Float4 unit_direction;  // divided by that
        Float4 unit_direction_slack;
    };

    Vec3 origin_, direction_;
    double direction_squared_;  // above 0
    double origin_magnitude_;
    std::optional<ForBoxes> for_boxes_;
};

/// Whether a shape is within `reach` of a point.
class ConservativePoint {
public:
    explicit ConservativePoint(Vec3 point) : point_(point), magnitude_(sum(abs(point))) {}

    TriState operator()(const ConservativeSphere& sphere, double reach) const {
        const double both = sphere.radius + reach, magnitude = magnitude_ + sphere.magnitude + reach;
        return at_most(length_squared(point_.exact - sphere.center), both * both, slack * magnitude * magnitude);
    }
    TriState operator()(const ConservativePlane& plane, double reach) const {
        return at_most(std::fabs(plane.height(point_.exact)), reach * length(plane.normal),
                       plane.height_error(magnitude_ + reach));
    }
    TriState operator()(const ConservativeBox& box, double reach) const {
        const Vec3 outside = max(abs(box.local(point_.exact)) - box.half * box.unit, {});
        const double scaled_reach = reach * box.unit, magnitude = box.unit * (magnitude_ + box.magnitude + reach);
        return at_most(length_squared(outside), scaled_reach * scaled_reach, slack * magnitude * magnitude);
    }
    /// In float32.
    template <class Stored>
    TriState operator()(const ConservativePlacedBox<Stored>& placed, double reach) const {
        const RelativeBox<Stored> box(placed, point_, magnitude_);
        const Float4 outside = abs(box.from) - box.half;
        const auto squared = [&](Float4 margin) {
            const Float4 gap = positive(outside + margin);
            return sum(gap * gap)[0];
        };
        const float far = static_cast<float>(std::min(reach, most_reach)) * box.unit[0], limit = far * far;
        return tri_state(squared(-box.margin) > limit * (1 + square_slack) + smallest_square,
                         squared(box.margin) + smallest_square < limit * (1 - square_slack));
    }

private:
    SplitPoint point_;
    double magnitude_;
};

/// Whether a box overlaps a shape.
class ConservativeBoxQuery {
public:
    explicit ConservativeBoxQuery(const Obb& box)
        : box_(box),
          is_rotated_(!(box.axes.x == Vec3{1, 0, 0} && box.axes.y == Vec3{0, 1, 0})),
          magnitude_(sum(abs(box.center)) + sum(box.half)) {}

    TriState operator()(const ConservativeSphere& sphere) const {
        const Vec3 outside = max(abs(to_local(sphere.center - box_.center)) - box_.half, {});
        const double magnitude = magnitude_ + sphere.magnitude;
        return at_most(length_squared(outside), sphere.radius * sphere.radius, slack * magnitude * magnitude);
    }

    TriState operator()(const ConservativePlane& plane) const {
        const double reach = dot(abs(to_local(plane.normal)), box_.half);
        return at_most(std::fabs(plane.height(box_.center)), reach, plane.height_error(magnitude_));
    }

    /// The separating axis test in this box's own frame.
    TriState operator()(const ConservativeBox& other) const {
        const Matrix<double> axes{to_local(other.axes.x), to_local(other.axes.y), to_local(other.axes.z)};
        const BoxAndRotatedBox<double> both{
            box_.half, to_local(other.center - box_.center), other.half, axes, abs(axes), other.unit};
        const double margin = slack * other.unit * (magnitude_ + other.magnitude);
        if (max_component(abs(both.other_center) * both.unit - both.half * both.unit) < -margin) return TriState::yes;
        const double gap = both.face_gap();
        if (gap > margin) return TriState::no;
        return at_most(std::max(gap, both.edge_gap()), 0, margin);
    }

private:
    GPHYS_INLINE Vec3 to_local(Vec3 v) const { return is_rotated_ ? transpose_times(box_.axes, v) : v; }

    Obb box_;
    bool is_rotated_;
    double magnitude_;
};

// The conservative test of an overlap with a query shape, as a function of a conservative shape.

inline auto conservative_overlap(const Sphere& query) {
    return [point = ConservativePoint(query.center), reach = query.radius](const auto& shape) {
        return point(shape, reach);
    };
}
inline auto conservative_overlap(const Aabb& query) { return ConservativeBoxQuery(as_obb(query)); }
inline auto conservative_overlap(const Obb& query) { return ConservativeBoxQuery(query); }
template <class Query>
auto conservative_overlap(const Query&) {
    return [](const auto&) { return TriState::undecided; };
}

}  // namespace gphys

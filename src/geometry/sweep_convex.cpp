// sweep of a capsule or box: the first time at which the Minkowski difference (convex.h), which moves opposite to the
// motion, contains the origin.
//
// The difference is a polytope rounded by a radius. Clipping the path by the slab between each pair of parallel faces
// leaves an interval. Without a radius, and with the faces of a box among the slabs, its start is the result. Else the
// contact is not before it and is approached from there (conservative advancement): the distance to a convex set is a
// convex function of time whose slope is the speed along the normal, so Newton's method never passes the first contact
// (compare van den Bergen 2004).
#include <algorithm>

#include "foundation/compiler.h"
#include "geometry/convex_pairs.h"
#include "geometry/intersect.h"
#include "geometry/slab_clip.h"

namespace gphys {
namespace {

/// The functions are compiled once for all pairs of shapes.
class ConvexSweep {
public:
    ConvexSweep(const ConvexDifference& set, Vec3 displacement)
        : set_(set),
          displacement_(displacement),
          resolution_(contact_tolerance * (set.size() + max_component(abs(displacement)))),
          is_round_(set.radius() * contact_tolerance > resolution_ * least_offset),
          clip_(resolution_) {}

    /// Clips the path by the slabs. False without contact.
    GPHYS_NOINLINE bool clip() {
        return set_.for_each_normal([&](Vec3 unit) { return cut(clip_, unit, 0); });
    }
    bool may_overlap_at_start() const { return clip_.may_overlap_at_start(); }
    /// A conservative test of a round solid: whether there is certainly no contact until t_max, because the distance
    /// along the normal that the shapes have at that time is too large, and was not smaller before. Without a radius,
    /// clipping takes no longer.
    GPHYS_NOINLINE bool is_apart_until(double t_max) const {
        if (t_max >= 1 || set_.radius() == 0) return false;
        const ConvexDifference then = set_.after(displacement_ * t_max);
        const Vec3 offset = then.nearest().offset;
        if (offset == Vec3{}) return false;
        const Vec3 normal = -normalized(offset);
        const double margin = resolution_ * (apart_margin / contact_tolerance);
        return dot(normal, displacement_) <= 0 && then.gap(normal) > set_.radius() + margin;
    }
    /// The contact in the rest of the path, unless the shapes overlap at its start. False without contact.
    GPHYS_NOINLINE bool find() {
        if (clip_.is_empty() || (clip_.is_open() && !overlaps_within_rounding())) return false;
        begin_ = clip_.begin();
        normal_ = clip_.normal();
        if (!set_.has_box() || set_.radius() > 0) {
            if (!approach()) return false;
            if (!is_round_ && is_beyond_plane()) normal_ = contact_normal(at_contact(), displacement_, normal_);
            return true;
        }
        if (normal_ != Vec3{}) return true;
        // In contact within rounding, without overlap.
        normal_ = separation(set_).normal;
        return dot(normal_, displacement_) < 0;
    }

    /// The result of find, or of shapes that overlap at the start; `from`: what the coordinates are relative to.
    GPHYS_NOINLINE Hit hit(bool is_at_start, Vec3 from) const {
        Hit hit;
        Vec3 point;
        if (is_at_start) {
            const Separation apart = separation(set_);
            hit.flags = GPHYS_HIT_INSIDE;
            hit.t = 0;
            hit.normal = apart.normal;
            point = contact_on_other(set_, apart);
        } else {
            hit.t = std::min(begin_, 1.0);
            hit.normal = normal_;
            point = contact_on_other(at_contact(), {0, normal_, on_other_, is_round_});
        }
        hit.point = from + point + hit.normal * set_.other_radius();
        return hit;
    }

private:
    ConvexDifference at_contact() const { return set_.after(displacement_ * begin_); }

    /// Clips the interval by the slab between two faces, moved outward by `grown_by`. Returns false if it is empty.
    bool cut(SlabClip& clip, Vec3 unit, double grown_by) const {
        double low, high;
        set_.project(unit, low, high);
        const double climb = dot(unit, displacement_), radius = set_.radius() + grown_by;
        return clip.cut(-high - radius, -climb, unit) && clip.cut(low - radius, climb, -unit);
    }
    GPHYS_NOINLINE bool overlaps_within_rounding() {
        SlabClip grown(resolution_);
        set_.for_each_normal([&](Vec3 unit) { return cut(grown, unit, resolution_); });
        return clip_.is_in(grown);
    }

    /// Whether the plane of the contact does not separate the shapes, up to the rounding of its normal to floats.
    bool is_beyond_plane() const {
        double low, high;
        set_.project(normal_, low, high);
        const double gap = begin_ * dot(normal_, displacement_) - high;
        return gap < set_.radius() - resolution_ * (normal_rounding / contact_tolerance);
    }

    /// Newton's method from the start of the interval. Returns false if there is no contact.
    bool approach() {
        // Quadratic convergence; linear, halving the error, where the shapes graze each other: 60 steps exhaust a
        // double.
        double clear = begin_, clear_gap = 0;
        bool may_have_passed = false;
        for (int step = 0; step < 60; ++step) {
            const Separation apart = separation_after(displacement_ * begin_);
            const double gap = apart.distance - set_.radius();
            const double approach = -dot(apart.normal, displacement_);
            on_other_ = apart.on_other;
            // Otherwise the normal of an earlier step, or of a slab, is more accurate than the one here.
            const bool is_clear = is_round_ || apart.distance * contact_tolerance > resolution_ * least_offset;
            if (is_clear || normal_ == Vec3{}) normal_ = apart.normal;
            if (gap < -4 * resolution_ && clear_gap > 0) {
                // A long step has multiplied the rounding of its normal and passed the contact: back by the secant
                // method.
                begin_ = clear + (begin_ - clear) * (clear_gap / (clear_gap - gap));
                continue;
            }
            if (gap <= resolution_) return begin_ > 0 || approach > 0;
            const double left = gap - std::max(approach, 0.0) * (1 - begin_);
            if (approach <= 0 || left > 0) {
                // An error of `resolution` in the offset rotates the normal by resolution / distance.
                const double blur = 8 * resolution_ * (1 + length(displacement_) / apart.distance);
                if (may_have_passed) begin_ = clear;
                // For thinner shapes the result is within the documented error either way.
                return (may_have_passed || left <= blur) && set_.radius() > 16 * resolution_ && approach_by_distance();
            }
            clear = begin_;
            clear_gap = gap;
            begin_ += gap / approach;
            // A step this long turns that rotation into an error of the gap as large as the documented one.
            may_have_passed = (begin_ - clear) * length(displacement_) > 64 * apart.distance;
        }
        return true;
    }

    /// For short offsets, whose direction does not say whether the shapes approach. Uses only their length, which is
    /// known within the resolution: ternary search for the least distance, which is a convex function of time, and then
    /// bisection for the first contact.
    bool approach_by_distance() {
        const auto gap_at = [&](double t) { return separation_after(displacement_ * t).distance - set_.radius(); };
        double low = begin_, high = 1;
        for (int step = 0; step < 100 && high - low > 0x1p-53; ++step) {
            const double third = (high - low) / 3;
            if (gap_at(low + third) < gap_at(high - third)) {
                high -= third;
            } else {
                low += third;
            }
        }
        double impact_time = low + (high - low) / 2;
        for (const double end : {low, high, 1.0}) {
            if (gap_at(end) < gap_at(impact_time)) impact_time = end;
        }
        if (gap_at(impact_time) > resolution_) return false;
        while (impact_time - begin_ > 0x1p-53 * impact_time) {
            const double middle = begin_ + (impact_time - begin_) / 2;
            if (middle <= begin_ || middle >= impact_time) break;
            (gap_at(middle) > resolution_ ? begin_ : impact_time) = middle;
        }
        begin_ = impact_time;
        const Separation contact = separation_after(displacement_ * begin_);
        on_other_ = contact.on_other;
        normal_ = contact.normal;
        const double along = dot(normal_, displacement_);
        // At the first contact the shapes do not move apart.
        if (along > 0) normal_ = normalized(normal_ - displacement_ * (along / length_squared(displacement_)));
        return begin_ > 0 || along < 0;
    }

    /// The separation of cores that are clearly apart, without testing the faces.
    Separation separation_after(Vec3 displacement) const {
        const ConvexDifference then = set_.after(displacement);
        const NearestDifference near = then.nearest();
        const double distance = length(near.offset);
        if (distance <= resolution_) return separation(then);
        return {distance, near.offset / -distance, near.on_other, true};
    }

    const ConvexDifference& set_;
    Vec3 displacement_, normal_, on_other_;
    double resolution_;
    bool is_round_;
    SlabClip clip_;
    double begin_ = 0;
};

/// A contact after t_max may be left out.
template <class Other, class Moving>
bool sweep_convex(const Other& other, const Moving& moving, Vec3 displacement, Hit& hit, double t_max = 1) {
    const Vec3 from = reference_point(moving);
    const auto core = core_of(relative_to(from, other));
    const ConvexDifference set(core, core_of(relative_to(from, moving)));
    ConvexSweep path(set, displacement);
    if (path.is_apart_until(t_max) || !path.clip()) return false;
    const bool is_at_start = path.may_overlap_at_start() && overlaps(Shape(other), Shape(moving));
    if (!is_at_start && !path.find()) return false;
    hit = path.hit(is_at_start, from);
    return true;
}

template <class Moving>
bool sweep_convex(const Plane& plane, const Moving& moving, Vec3 displacement, Hit& hit) {
    const Vec3 from = reference_point(moving);
    const OverPlane over(plane, moving, from);
    const double approach = -dot(over.normal, displacement);
    const bool is_at_start = overlaps(Shape(plane), Shape(moving));
    if (!is_at_start && (approach <= 0 || over.gap > approach)) return false;
    hit = Hit{is_at_start ? 0 : std::max(over.gap, 0.0) / approach, {}, over.normal};
    hit.flags = (over.behind ? GPHYS_HIT_BACK : 0) | (is_at_start ? GPHYS_HIT_INSIDE : 0);
    hit.point = closest_point(plane, from + over.foot + displacement * hit.t);
    return true;
}

template <class Moving>
bool sweep_triangle(const Triangle& triangle, const Moving& moving, Vec3 displacement, Hit& hit, double t_max) {
    if (!sweep_convex(triangle, moving, displacement, hit, t_max)) return false;
    barycentric(triangle, hit.point, hit.u, hit.v);
    const Vec3 front = accurate_cross(triangle.a, triangle.b, triangle.a, triangle.c);
    if (dot(hit.normal, front) < 0) hit.flags |= GPHYS_HIT_BACK;
    return true;
}

/// A moving sphere has its own formulas (sweep.cpp).
template <class Other, class Moving>
bool sweep_pair(const Other& other, const Moving& moving, Vec3 displacement, Hit& hit, double t_max = 1) {
    if constexpr (std::is_same_v<Moving, Sphere> && std::is_same_v<Other, Triangle>) {
        return sweep(other, moving, displacement, hit, t_max);
    } else if constexpr (std::is_same_v<Moving, Sphere>) {
        return sweep(other, moving, displacement, hit);
    } else if constexpr (std::is_same_v<Other, Triangle>) {
        return sweep_triangle(other, moving, displacement, hit, t_max);
    } else {
        return sweep_convex(other, moving, displacement, hit);
    }
}

}  // namespace

BoxInMotion::BoxInMotion(const Shape& moving)
    : box(with_solid(moving, [](const auto& solid) { return bounds(solid); })) {
    const Vec3 low{box.min[0], box.min[1], box.min[2]}, high{box.max[0], box.max[1], box.max[2]};
    middle = (low + high) * 0.5;
    half = (high - low) * 0.5;
}

Vec3 BoxInMotion::half_with_rounding(const Box& shapes, Vec3 displacement) const {
    // The terms of ConvexDifference::size: distances between corners of the two, twice for those of triangles.
    double size = max_component(abs(displacement));
    for (int axis = 0; axis < 3; ++axis) {
        const double apart = std::max(shapes.max[axis] - middle[axis], middle[axis] - shapes.min[axis]);
        size += 2 * (std::max(apart, 0.0) + half[axis]);
    }
    const double margin = contact_tolerance * size;
    return half + Vec3{margin, margin, margin};
}

bool sweep(const Shape& shape, const Shape& moving, Vec3 displacement, Hit& hit) {
    return with_pair(shape, moving,
                     [&](const auto& other, const auto& solid) { return sweep_pair(other, solid, displacement, hit); });
}
bool sweep(const Triangle& triangle, const Shape& moving, Vec3 displacement, Hit& hit, double t_max) {
    return with_solid(moving, [&](const auto& solid) { return sweep_pair(triangle, solid, displacement, hit, t_max); });
}

}  // namespace gphys

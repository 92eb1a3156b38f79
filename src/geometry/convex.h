// Two convex shapes as one: the set of all differences of a point of the other shape and a point of the moving one
// (the Minkowski difference). The shapes meet where that set holds the origin, are as far apart as it is from the
// origin, and to move the one is to move the set against it.
//
// Spheres, capsules and boxes are a core, which is a point, a segment or a box, grown by a radius; a triangle is a core
// by itself. The difference of two cores is a polytope: a point or a triangle, extended along up to six axes. The radii
// only add up. Everything counts from a point of the moving shape, so that an offset from the origin costs nothing.
#pragma once

#include "foundation/exact.h"
#include "shapes/shapes.h"

namespace gphys {

/// What can be swept and pushed out: the centre + the sum of the axes times -half .. half, grown by the radius.
struct Core {
    Vec3 center;
    double radius = 0;
    int axis_count = 0;  // 0, 1 or 3
    Vec3 axes[3] = {};   // of length 1 if they are three, which are perpendicular then
    double half[3] = {};
};
Core core_of(const Sphere& sphere);
Core core_of(const Capsule& capsule);
Core core_of(const Aabb& box);
Core core_of(const Obb& box);

/// A point of a shape to count from.
inline Vec3 reference_point(const Sphere& sphere) { return sphere.center; }
inline Vec3 reference_point(const Capsule& capsule) { return capsule.a; }
inline Vec3 reference_point(const Aabb& box) { return box.min; }
inline Vec3 reference_point(const Obb& box) { return box.center; }

/// The point of a polytope of differences that is nearest to the origin, and the point of the other core in it.
struct NearestDifference {
    Vec3 offset;  // 0 if the polytope holds the origin
    Vec3 on_other;
};

class ConvexDifference {
public:
    ConvexDifference(const Core& other, const Core& moving);
    ConvexDifference(const Triangle& other, const Core& moving);

    /// Of both shapes, and of the other.
    double radius() const { return radius_; }
    double other_radius() const { return other_radius_; }
    /// No coordinate of the set, grown by the radius, is larger.
    double size() const;
    /// Whether the normals of for_each_normal tell inside from outside even if the polytope is flat: those of a box are
    /// among them, and it is what a box of some thickness shrinks to.
    bool has_box() const { return other_axis_count_ == 3 || axis_count_ - other_axis_count_ == 3; }
    /// The set when the moving shape has gone some way.
    ConvexDifference after(Vec3 displacement) const;

    /// From where to where the polytope reaches along a vector.
    void project(Vec3 vector, double& low, double& high) const;
    /// How far the cores are apart along a unit vector that leads from the other to the moving one.
    double gap(Vec3 unit) const {
        double low, high;
        project(unit, low, high);
        return -high;
    }
    /// The unit normals of all faces of the polytope, one for the two that are parallel: visit(unit) returns whether to
    /// go on. False if it did not.
    template <class Visit>
    bool for_each_normal(Visit&& visit) const;

    /// A unit vector across a set without faces, which is a point or a line.
    Vec3 across() const;

    /// Of a polytope that holds the origin no deeper than rounding: else 0, or the nearest point of a face. By the
    /// algorithm of Gilbert, Johnson and Keerthi (1988), in the form that ends with a proof: the plane across the
    /// offset has all of the polytope behind it, but for 2^-45 of the size. Where rounding leaves that open, as it does
    /// for short offsets, by the features. The length is off by 2^-45 of the size.
    NearestDifference nearest() const;
    /// The same by asking all corners, edges and faces of both cores, which takes some thirty times as long.
    NearestDifference nearest_by_features() const;

private:
    struct Corner {
        Vec3 difference, on_other;
    };
    class Simplex;
    class BestProved;
    struct Features;

    /// The corner furthest along a vector.
    Corner furthest(Vec3 vector) const;
    Features features_of_other() const;
    Features features_of_moving() const;

    Vec3 center_, other_center_;
    Vec3 axes_[6];  // those of the other come first
    double half_[6];
    int axis_count_ = 0, other_axis_count_ = 0;
    Vec3 corners_[3] = {};  // of a triangle, from the centre
    int corner_count_ = 1;
    double radius_, other_radius_;
};

/// How far two cores are apart, or how far the moving one has to go to be.
struct Separation {
    double distance;  // below 0 where they overlap
    Vec3 normal;      // of length 1, the way that separates, from the other to the moving one
    Vec3 on_other;    // nearest to the moving core where the cores are apart, else unused
    bool apart;
};
/// The distance is off by at most 2^-43 of the size of the set. Where cores are apart by less than 2^-32 of it, the
/// normal may be one of a face beside.
Separation separation(const ConvexDifference& set);

/// Where the other core is touched, if the two are that far apart along the normal: a point that is nearest to the
/// moving core. They are taken for further apart, since it is rounding that tells where cores touch that overlap.
Vec3 contact_on_other(const ConvexDifference& set, const Separation& separation);

/// A vector, exact but for 2^-43 of itself, along cross(b - a, d - c) and of length 1, or 0.
inline Vec3 unit_across(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 p = b - a, q = d - c, quick = cross(p, q);
    // Each component is off by less than 4 * 2^-53 |p| |q|.
    const bool well = length_squared(quick) > 0x1p-14 * length_squared(p) * length_squared(q);
    const Vec3 across = well ? quick : accurate_cross(a, b, c, d);
    return across == Vec3{} ? across : normalized(across);
}

template <class Visit>
bool ConvexDifference::for_each_normal(Visit&& visit) const {
    const int first_moving = other_axis_count_;
    if (other_axis_count_ == 3 && !(visit(axes_[0]) && visit(axes_[1]) && visit(axes_[2]))) return false;
    if (axis_count_ - first_moving == 3) {
        for (int i = first_moving; i < axis_count_; ++i) {
            if (!visit(axes_[i])) return false;
        }
    }
    const auto visit_across = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        const Vec3 unit = unit_across(a, b, c, d);
        return unit == Vec3{} || visit(unit);
    };
    if (corner_count_ == 3 && !visit_across(corners_[0], corners_[1], corners_[0], corners_[2])) return false;
    for (int i = first_moving; i < axis_count_; ++i) {
        for (int k = 0; k < other_axis_count_; ++k) {
            if (!visit_across({}, axes_[k], {}, axes_[i])) return false;
        }
        for (int k = 0; k < 3 && corner_count_ == 3; ++k) {
            if (!visit_across({}, axes_[i], corners_[k], corners_[(k + 1) % 3])) return false;
        }
    }
    return true;
}

}  // namespace gphys

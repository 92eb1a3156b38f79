// The Minkowski difference of two convex shapes: all differences of a point of the other shape and a point of the
// moving one. The shapes overlap if it contains the origin. Their distance is its distance from the origin. If the
// moving shape moves, the difference moves the opposite way. See Gilbert, Johnson, Keerthi 1988.
//
// Spheres, capsules and boxes are a core (a point, a segment or a box) rounded by a radius; a triangle is a core, and
// so is a frustum with eight corners. The difference of two cores is a polytope: a point, a triangle or a hexahedron,
// extruded along up to six axes. The radii add up. All coordinates are relative to a point of the moving shape, so that
// no digits are lost far from the origin.
#pragma once

#include "foundation/exact.h"
#include "shapes/shapes.h"

namespace gphys {

/// A solid that can be swept and pushed out: the points center + the sum of axes times -half .. half, rounded by the
/// radius.
struct Core {
    Vec3 center;
    double radius = 0;
    int axis_count = 0;  // 0, 1 or 3
    Vec3 axes[3] = {};   // three are orthonormal
    double half[3] = {};
};
Core core_of(const Sphere& sphere);
Core core_of(const Capsule& capsule);
Core core_of(const Aabb& box);
Core core_of(const Obb& box);

/// A convex solid of six faces with four corners each.
struct Hexahedron {
    Vec3 corner;      // number 0
    Vec3 corners[8];  // relative to it; numbered as those of a box: bit k is the side of pair k of opposite faces
    Vec3 normals[6];  // of the faces, of length 1
    Vec3 edges[12];   // along them, of length 1, also where rounding makes corners coincide
};
/// The frustum must be the hull of its corners (is_hexahedron).
Hexahedron core_of(const Frustum& frustum);
inline Triangle core_of(const Triangle& triangle) { return triangle; }

/// A point of a shape, used as the origin of relative coordinates.
inline Vec3 reference_point(const Sphere& sphere) { return sphere.center; }
inline Vec3 reference_point(const Capsule& capsule) { return capsule.a; }
inline Vec3 reference_point(const Aabb& box) { return box.min; }
inline Vec3 reference_point(const Obb& box) { return box.center; }

/// Relative to the size of a difference and its displacement: shapes closer than this count as in contact.
constexpr double contact_tolerance = 0x1p-46;
/// Relative to the size of a difference: the shortest offset whose direction is used as a normal. That direction has an
/// error below 2^-16. So a ball that is pushed out along it keeps a penetration below the square of that, relative to
/// its radius. For a smaller radius, the cores are in contact within rounding if the shapes are.
constexpr double least_offset = 0x1p-32;
/// Relative to the size: how far a plane moves at that distance when its normal is rounded to floats. Up to this error,
/// the plane of a contact separates the two shapes.
constexpr double normal_rounding = 0x1p-24;

/// The point of the difference that is closest to the origin, and the point of the other core that it comes from.
struct NearestDifference {
    Vec3 offset;  // 0 if the polytope contains the origin
    Vec3 on_other;
};

class ConvexDifference {
public:
    ConvexDifference(const Core& other, const Core& moving);
    ConvexDifference(const Triangle& other, const Core& moving);
    /// Refers to the hexahedron, which must stay.
    ConvexDifference(const Hexahedron& other, const Core& moving);
    ConvexDifference(const Hexahedron&& other, const Core& moving) = delete;

    /// The sum of both radii; other_radius: that of the other shape.
    double radius() const { return radius_; }
    double other_radius() const { return other_radius_; }
    /// An upper bound of the coordinates of the difference, including the radius.
    double size() const;
    /// Whether the normals of for_each_normal bound the polytope even if it is flat. They do if they include those of a
    /// box.
    bool has_box() const { return other_axis_count_ == 3 || axis_count_ - other_axis_count_ == 3; }
    /// The difference after a displacement of the moving shape.
    ConvexDifference after(Vec3 displacement) const;

    /// The interval of the projection of the polytope on a vector.
    void project(Vec3 vector, double& low, double& high) const;
    /// The gap between the cores along a unit vector that points from the other to the moving one.
    double gap(Vec3 unit) const {
        double low, high;
        project(unit, low, high);
        return -high;
    }
    /// Calls visit(unit) for the unit normals of all faces, once for each pair of parallel faces. Stops when visit
    /// returns false, and returns false then.
    template <class Visit>
    bool for_each_normal(Visit&& visit) const;

    /// The unit vector along a difference without faces, that is, along a segment; 0 for a point.
    Vec3 line() const;
    /// A unit vector perpendicular to line().
    Vec3 across() const;

    /// The closest point to the origin, if the polytope does not contain the origin deeper than rounding; otherwise 0
    /// or the closest point of a face. Algorithm: GJK (Gilbert, Johnson, Keerthi 1988). It ends when the whole polytope
    /// is behind the plane perpendicular to the offset, within 2^-45 of the size. Where rounding leaves that open, as
    /// for short offsets, all features are tested. The error of the length is 2^-45 of the size.
    NearestDifference nearest() const;
    /// The same by testing all corners, edges and faces of both cores. Takes about thirty times as long.
    NearestDifference nearest_by_features() const;

private:
    struct Corner {
        Vec3 difference, on_other;
    };
    class Simplex;
    class BestProved;
    struct Features;

    /// The support point: the corner farthest along a vector.
    Corner furthest(Vec3 vector) const;
    Features features_of_other() const;
    Features features_of_moving() const;
    const Vec3* corners() const { return hexahedron_ ? hexahedron_->corners : corners_; }

    Vec3 center_, other_center_;
    Vec3 axes_[6];  // those of the other shape come first
    double half_[6];
    int axis_count_ = 0, other_axis_count_ = 0;
    const Hexahedron* hexahedron_ = nullptr;
    Vec3 corners_[3] = {};  // of a triangle, relative to the centre, which is the first
    int corner_count_ = 1;  // 3 of a triangle, 8 of a hexahedron
    double radius_, other_radius_;
};

/// The distance of two cores, or the penetration depth if they overlap.
struct Separation {
    double distance;  // below 0 if they overlap
    Vec3 normal;      // unit: the separating direction, from the other to the moving core
    Vec3 on_other;    // closest to the moving core, if the cores are apart; else unused
    bool apart;
};
/// The error of the distance is at most 2^-43 of the size of the difference. If the cores are closer than 2^-32 of it,
/// the normal may be that of an adjacent face.
Separation separation(const ConvexDifference& set);

/// The point of the other core that is closest to the moving one, given the separation along the normal. Computed with
/// the cores farther apart, because the contact point of overlapping cores depends on rounding.
Vec3 contact_on_other(const ConvexDifference& set, const Separation& separation);

/// The normal of a first contact: of the given normal and the face normals that oppose the motion, the one along which
/// the cores are farthest apart. `at_contact`: the difference at the time of impact. The given normal may be that of
/// another feature, because it comes from a step at a distance, or of an offset so short that its direction is
/// rounding.
Vec3 contact_normal(const ConvexDifference& at_contact, Vec3 displacement, Vec3 normal);

/// The unit vector along cross(b - a, d - c), with a relative error of 2^-43, or 0.
inline Vec3 unit_across(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 p = b - a, q = d - c, rounded = cross(p, q);
    // Each component has an error below 4 * 2^-53 |p| |q|.
    const bool well = length_squared(rounded) > 0x1p-14 * length_squared(p) * length_squared(q);
    const Vec3 across = well ? rounded : accurate_cross(a, b, c, d);
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
    for (int i = 0; i < 6 && hexahedron_; ++i) {
        if (!visit(hexahedron_->normals[i])) return false;
    }
    for (int i = first_moving; i < axis_count_; ++i) {
        for (int k = 0; k < other_axis_count_; ++k) {
            if (!visit_across({}, axes_[k], {}, axes_[i])) return false;
        }
        for (int k = 0; k < 3 && corner_count_ == 3; ++k) {
            if (!visit_across({}, axes_[i], corners_[k], corners_[(k + 1) % 3])) return false;
        }
        for (int k = 0; k < 12 && hexahedron_; ++k) {
            if (!visit_across({}, axes_[i], {}, hexahedron_->edges[k])) return false;
        }
    }
    return true;
}

}  // namespace gphys

// Distance or penetration depth of two cores: the separating axis test over the face normals of their Minkowski
// difference (Gottschalk, Lin, Manocha 1996), and GJK if that finds them apart (convex_nearest.cpp).

#include "geometry/convex.h"

namespace gphys {
namespace {

// Relative to the size of the difference. The error of a projection or an offset is about 2^-48.
constexpr double certain = 0x1p-44;
// The documented bound allows the normal of a face if the cores are closer than least_offset times the largest
// coordinate difference, and the size is up to four times that. The direction of a longer offset has an error below
// 2^-14: a ball that is pushed out along it keeps a penetration below 2^-29 of its radius.
constexpr double is_direction = least_offset / 4;

/// The distance is the maximum of the gap over all directions. If the origin is inside, a face normal attains it. So
/// the largest gap found is a lower bound.
class WidestGap {
public:
    void offer(double gap, Vec3 normal) {
        if (!(gap > widest_)) return;
        widest_ = gap;
        normal_ = normal;
    }
    double widest() const { return widest_; }
    Vec3 normal() const { return normal_; }

private:
    double widest_ = -infinity;
    Vec3 normal_;
};

}  // namespace

Separation separation(const ConvexDifference& set) {
    WidestGap gaps;
    set.for_each_normal([&](Vec3 unit) {
        double low, high;
        set.project(unit, low, high);
        gaps.offer(-high, unit);
        gaps.offer(low, -unit);
        return true;
    });
    // The face normals of a flat polytope do not bound it sideways.
    const bool has_faces = gaps.widest() > -infinity;
    if (has_faces && gaps.widest() < -certain * set.size()) return {gaps.widest(), gaps.normal(), {}, false};
    // Not inside by more than rounding: the features give the distance, but not the side.
    const NearestDifference near = set.nearest();
    const double distance = length(near.offset);
    if (!has_faces && distance <= is_direction * set.size()) {
        // A point or a segment, and the offset has no direction: perpendicular to it, unless the origin is beyond an
        // end.
        const Vec3 line = set.line(), offset = near.offset * -1.0, across = offset - line * dot(offset, line);
        const double width = length(across);
        gaps.offer(set.gap(set.across()), set.across());
        gaps.offer(set.gap(-set.across()), -set.across());
        if (width > 0) gaps.offer(set.gap(across / width), across / width);
        if (distance > 0) gaps.offer(set.gap(offset / distance), offset / distance);
        return {distance, gaps.normal(), near.on_other, true};
    }
    if (has_faces && gaps.widest() >= distance - certain * set.size()) {
        return {gaps.widest(), gaps.normal(), near.on_other, distance > 0};
    }
    const Vec3 unit = near.offset / -distance;
    // The direction of an offset that is little more than rounding is arbitrary.
    if (has_faces && distance < is_direction * set.size() && set.gap(unit) < gaps.widest()) {
        return {gaps.widest(), gaps.normal(), near.on_other, true};
    }
    return {distance, unit, near.on_other, true};
}

Vec3 contact_on_other(const ConvexDifference& set, const Separation& separation) {
    if (separation.apart) return separation.on_other;
    // Moved apart until they are in contact, and by half of the size further.
    return set.after(separation.normal * (set.size() * 0.5 - separation.distance)).nearest().on_other;
}

Vec3 contact_normal(const ConvexDifference& at_contact, Vec3 displacement, Vec3 normal) {
    WidestGap gaps;
    gaps.offer(at_contact.gap(normal), normal);
    const auto offer = [&](Vec3 unit) {
        if (dot(unit, displacement) <= 0x1p-48 * length(displacement)) gaps.offer(at_contact.gap(unit), unit);
    };
    const auto offer_both = [&](Vec3 unit) {
        offer(unit);
        offer(-unit);
        return true;
    };
    at_contact.for_each_normal(offer_both);
    // Of a segment or a point, which has no faces.
    offer_both(at_contact.across());
    const Vec3 line = at_contact.line(), against = line * dot(displacement, line) - displacement;
    if (against != Vec3{}) offer(normalized(against));
    const Vec3 offset = at_contact.nearest().offset;
    if (at_contact.radius() > 0 && offset != Vec3{}) offer(normalized(offset * -1.0));
    return gaps.normal();
}

}  // namespace gphys

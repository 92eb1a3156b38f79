#include <algorithm>

#include "geometry/convex.h"

namespace gphys {

namespace {

// Parts of the size of the set. What a projection, and an offset, may be off by is some 2^-48.
constexpr double certain = 0x1p-44;
// The direction of a longer offset is off by less than 2^-16: a ball that is pushed out along it, to where it touches,
// is left with less than the square of that part of its radius.
constexpr double has_direction = 0x1p-32;

/// The origin is at least as far outside as it is along any direction, and there is one along which it is as far: if
/// it is inside, the normal of a face. So the largest gap found is never more than the distance.
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
    // Of a flat set the faces have no volume between them, and tell nothing about what is beside it.
    const bool has_faces = gaps.widest() > -infinity;
    if (has_faces && gaps.widest() < -certain * set.size()) return {gaps.widest(), gaps.normal(), {}, false};
    // No further inside than rounding, so that the features tell the distance, if not from which side.
    const NearestDifference near = set.nearest();
    const double distance = length(near.offset);
    if (!has_faces && distance == 0) return {0, set.across(), near.on_other, true};
    if (has_faces && gaps.widest() >= distance - certain * set.size()) {
        return {gaps.widest(), gaps.normal(), near.on_other, distance > 0};
    }
    const Vec3 unit = near.offset / -distance;
    // Of an offset that is little more than rounding, the direction may be any.
    if (has_faces && distance < has_direction * set.size() && set.gap(unit) < gaps.widest()) {
        return {gaps.widest(), gaps.normal(), near.on_other, true};
    }
    return {distance, unit, near.on_other, true};
}

Vec3 contact_on_other(const ConvexDifference& set, const Separation& separation) {
    if (separation.apart) return separation.on_other;
    // Moved out until they touch, and half of the size further.
    return set.after(separation.normal * (set.size() * 0.5 - separation.distance)).nearest().on_other;
}

}  // namespace gphys

// The interval of time in which two convex shapes can overlap during a straight motion: slab clipping (as of a ray;
// Kay, Kajiya 1986) by the gaps between the shapes along normals. For any convex shapes with known normals.
#pragma once

#include <algorithm>

#include "foundation/math.h"

namespace gphys {

class SlabClip {
public:
    /// `resolution`: shapes closer than this count as in contact.
    explicit SlabClip(double resolution) : resolution_(resolution) {}

    /// gap: distance of the shapes along the unit vector; it decreases by `approach` from t = 0 to 1. Returns false if
    /// they are apart at all times.
    bool cut(double gap, double approach, Vec3 unit) {
        if (gap > widest_) widest_ = gap, widest_normal_ = unit;
        if (gap > 0) {
            if (gap > approach) {
                leaves_ = true;
                return gap <= resolution_;
            }
            const double entry = gap / approach;
            if (entry > begin_ || normal_ == Vec3{}) normal_ = unit;
            if (entry > begin_) begin_ = entry, begin_speed_ = approach;
        } else if (approach < 0 && gap > approach) {
            const double exit = gap / approach;
            if (exit < end_) end_ = exit, end_normal_ = unit;
        }
        return true;
    }
    /// The interval of a contact with an edge is a single time, computed by two rounded divisions; that with a flat
    /// shape one of two gaps along normals that are opposite within rounding, which is known within the resolution.
    bool is_empty() const {
        if (leaves_ || begin_ <= end_ + 0x1p-50) return leaves_;
        const bool is_flat = length_squared(normal_ + end_normal_) < 0x1p-60;
        return !is_flat || (begin_ - end_) * begin_speed_ > 2 * resolution_;
    }
    bool may_touch_at_start() const { return widest_ <= resolution_; }

    double begin() const { return begin_; }
    /// The normal of the first contact, or zero if the shapes are apart along no normal at the start.
    Vec3 normal() const { return normal_; }
    Vec3 widest_normal() const { return widest_normal_; }

private:
    double resolution_, begin_ = 0, end_ = 1, widest_ = -infinity;
    double begin_speed_ = 0;  // along the normal
    Vec3 normal_, end_normal_, widest_normal_;
    bool leaves_ = false;
};

}  // namespace gphys

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
            if (exit < end_) end_ = exit, end_speed_ = -approach;
        }
        return true;
    }
    bool is_empty() const {
        return leaves_ || (is_open() && begin_ - resolution_ / begin_speed_ > end_ + resolution_ / end_speed_);
    }
    /// Whether the interval is empty within rounding, as in a contact with an edge or of a flat shape. Then the
    /// interval of the shapes grown by the resolution decides whether they overlap, and contains the time of impact.
    bool is_open() const { return begin_ > end_; }
    bool is_in(const SlabClip& grown) {
        begin_ = std::min(begin_, grown.end_);
        return !grown.is_open();
    }
    bool may_overlap_at_start() const { return widest_ <= resolution_; }

    double begin() const { return begin_; }
    /// The normal of the first contact, or zero if the shapes are apart along no normal at the start.
    Vec3 normal() const { return normal_; }
    Vec3 widest_normal() const { return widest_normal_; }

private:
    double resolution_, begin_ = 0, end_ = 1, widest_ = -infinity;
    double begin_speed_ = 0, end_speed_ = 0;  // along the normal of each
    Vec3 normal_, widest_normal_;
    bool leaves_ = false;
};

}  // namespace gphys

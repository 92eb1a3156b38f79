// Overlap tests of boxes, over any type of number. Boxes are closed sets: contact counts as overlap.
#pragma once

#include "foundation/rotation.h"
#include "shapes/shapes.h"

namespace gphys {

/// AABBs, by their corners. Exact.
template <class N>
GPHYS_INLINE auto boxes_overlap(const Vec<N>& a_min, const Vec<N>& a_max, const Vec<N>& b_min, const Vec<N>& b_max) {
    return (a_min.x <= b_max.x) & (b_min.x <= a_max.x) & (a_min.y <= b_max.y) & (b_min.y <= a_max.y) &
           (a_min.z <= b_max.z) & (b_min.z <= a_max.z);
}

inline bool overlaps(const Box& a, const Box& b) {
    return boxes_overlap<float>({a.min[0], a.min[1], a.min[2]}, {a.max[0], a.max[1], a.max[2]},
                                {b.min[0], b.min[1], b.min[2]}, {b.max[0], b.max[1], b.max[2]});
}

/// The separating axis test of an AABB and an OBB (Gottschalk, Lin, Manocha 1996): six face normals and nine cross
/// products of edges. All gaps are scaled by `unit`.
///
/// Rounded, for conservative tests. overlap.cpp has the exact test.
template <class N>
struct BoxAndRotatedBox {
    Vec<N> half;          // of the first, about the origin
    Vec<N> other_center;  // of the second
    Vec<N> other_half;
    Matrix<N> axes, size;  // the axes of the second, `unit` long, and their absolute values
    N unit;

    /// The largest gap along the face normals; below 0 if all projections overlap.
    GPHYS_INLINE N face_gap() const {
        const Vec<N> here = abs(other_center) * unit - half * unit - size * other_half;
        const Vec<N> there = abs(transpose_times(axes, other_center)) - other_half * unit - transpose_times(size, half);
        return largest(max_component(here), max_component(there));
    }
    /// The largest gap along the cross products of edges. The cross product of parallel edges is zero and separates
    /// nothing; then the face normals suffice.
    GPHYS_INLINE N edge_gap() const {
        const Vec<N> x = across(axes.x, size.x, size.y * other_half.z + size.z * other_half.y);
        const Vec<N> y = across(axes.y, size.y, size.z * other_half.x + size.x * other_half.z);
        const Vec<N> z = across(axes.z, size.z, size.x * other_half.y + size.y * other_half.x);
        return largest(max_component(x), largest(max_component(y), max_component(z)));
    }

private:
    /// The gaps along the cross products of the first box's three edges with one edge of the second.
    GPHYS_INLINE Vec<N> across(const Vec<N>& axis, const Vec<N>& axis_size, const Vec<N>& others) const {
        const Vec<N> own = by_component(yzx(half), zxy(axis_size)) + by_component(zxy(half), yzx(axis_size));
        return abs(cross(other_center, axis)) - own - others;
    }
};

}  // namespace gphys

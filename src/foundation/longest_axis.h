// The axis of the largest component of a direction, for formulas over one vector or several lanes of them (vec.h).
#pragma once

#include "foundation/compiler.h"
#include "foundation/math.h"
#include "foundation/vec.h"

namespace gphys {

/// The axis of the largest component, the first of equal ones; of a single vector the index, by longest_axis().
template <class Vector>
class AxisByIndex {
public:
    GPHYS_INLINE explicit AxisByIndex(const Vector& direction) : axis_(longest_axis(direction)) {}

    /// The component along it.
    GPHYS_INLINE double of(const Vector& v) const { return v[axis_]; }
    GPHYS_INLINE double of(const double (&v)[4]) const { return v[axis_]; }
    // The index, and those of the next two axes in cyclic order.
    GPHYS_INLINE int index() const { return axis_; }
    GPHYS_INLINE int next() const { return axis_ == 2 ? 0 : axis_ + 1; }
    GPHYS_INLINE int after_next() const { return axis_ == 0 ? 2 : axis_ - 1; }

private:
    int axis_;
};

/// Of many, without a branch, which would be unpredictable: is_y and not x, is_z and neither.
template <class Number>
class AxisByMasks {
public:
    GPHYS_INLINE explicit AxisByMasks(const Vec<Number>& direction)
        : is_z_(largest(absolute(direction.x), absolute(direction.y)) < absolute(direction.z)),
          y_beats_x_(absolute(direction.x) < absolute(direction.y)) {}

    /// The component along it, and those along the next two axes in cyclic order.
    template <class Value>
    GPHYS_INLINE Number of(const Vec<Value>& v) const {
        return select(is_z_, Number(v.z), select(y_beats_x_, Number(v.y), Number(v.x)));
    }
    GPHYS_INLINE Number of(const double (&v)[4]) const { return of(Vec<double>{v[0], v[1], v[2]}); }
    template <class Value>
    GPHYS_INLINE Number next(const Vec<Value>& v) const {
        return select(is_z_, Number(v.x), select(y_beats_x_, Number(v.z), Number(v.y)));
    }
    template <class Value>
    GPHYS_INLINE Number after_next(const Vec<Value>& v) const {
        return select(is_z_, Number(v.y), select(y_beats_x_, Number(v.x), Number(v.z)));
    }

private:
    using Mask = decltype(Number() < Number());

    Mask is_z_, y_beats_x_;
};

template <class Vector>
struct LongestAxisOf {
    using Type = AxisByIndex<Vector>;
};
template <class Number>
struct LongestAxisOf<Vec<Number>> {
    using Type = AxisByMasks<Number>;
};
template <>
struct LongestAxisOf<Vec<double>> {
    using Type = AxisByIndex<Vec<double>>;
};
template <class Vector>
using LongestAxis = typename LongestAxisOf<Vector>::Type;

}  // namespace gphys

// The axis of the largest component of a direction, for formulas over one number or several lanes (numbers.h).
#pragma once

#include "foundation/compiler.h"
#include "foundation/math.h"
#include "foundation/numbers.h"

namespace gphys {

/// The axis of the largest component, the first of equal ones: is_y and not x, is_z and neither. Without a branch,
/// which would be unpredictable.
template <class Number>
struct LongestAxis {
    using Mask = decltype(Number() < Number());

    GPHYS_INLINE explicit LongestAxis(const Number (&direction)[3])
        : is_z_(largest(absolute(direction[0]), absolute(direction[1])) < absolute(direction[2])),
          y_beats_x_(absolute(direction[0]) < absolute(direction[1])) {}

    /// The component along it, and those along the next two axes in cyclic order.
    template <class Value>
    GPHYS_INLINE Number of(const Value (&v)[3]) const {
        return select(is_z_, v[2], select(y_beats_x_, v[1], v[0]));
    }
    template <class Value>
    GPHYS_INLINE Number next(const Value (&v)[3]) const {
        return select(is_z_, v[0], select(y_beats_x_, v[2], v[1]));
    }
    template <class Value>
    GPHYS_INLINE Number after_next(const Value (&v)[3]) const {
        return select(is_z_, v[1], select(y_beats_x_, v[0], v[2]));
    }

private:
    Mask is_z_, y_beats_x_;
};

/// For a single direction, the index of the axis.
template <>
struct LongestAxis<double> {
    explicit LongestAxis(const double (&direction)[3])
        : axis_(longest_axis({direction[0], direction[1], direction[2]})) {}

    double of(const double (&v)[3]) const { return v[axis_]; }
    double next(const double (&v)[3]) const { return v[axis_ == 2 ? 0 : axis_ + 1]; }
    double after_next(const double (&v)[3]) const { return v[axis_ == 0 ? 2 : axis_ - 1]; }

private:
    int axis_;
};

}  // namespace gphys

// The constants of ShearedRay (intersect.h), for one ray with Number = double, or for eight with the Double8 of a
// kernel.
#pragma once

#include "foundation/compiler.h"
#include "foundation/longest_axis.h"

namespace gphys {

template <class Number>
class Shear {
public:
    GPHYS_INLINE explicit Shear(const Number (&direction)[3])
        : longest_(direction), flips_(longest_.of(direction) < 0), moves(0 < absolute(longest_.of(direction))) {
        const Number along = select(moves, z(direction), 1);
        sx = select(moves, x(direction) / along, 0);
        sy = select(moves, y(direction) / along, 0);
    }

    // z is the axis of the largest component of the direction. x and y are swapped if that is negative, which keeps
    // the winding order.
    template <class Value>
    GPHYS_INLINE Number x(const Value (&v)[3]) const {
        return select(flips_, longest_.after_next(v), longest_.next(v));
    }
    template <class Value>
    GPHYS_INLINE Number y(const Value (&v)[3]) const {
        return select(flips_, longest_.next(v), longest_.after_next(v));
    }
    template <class Value>
    GPHYS_INLINE Number z(const Value (&v)[3]) const {
        return longest_.of(v);
    }

private:
    using Mask = decltype(Number() < Number());

    LongestAxis<Number> longest_;
    Mask flips_;

public:
    Mask moves;  // unless the direction is zero
    Number sx, sy;
};

}  // namespace gphys

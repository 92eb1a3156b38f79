// The constants of ShearedRay (intersect.h), for one ray and for eight.
//
// z is the axis of the largest component of the direction. x and y are swapped if that is negative, which keeps the
// winding order.
#pragma once

#include "foundation/compiler.h"
#include "foundation/longest_axis.h"

namespace gphys {

/// Of one ray, with Vector = Vec<double> or the Axes of a kernel: axes by their indices.
template <class Vector>
struct SingleShear {
    GPHYS_INLINE explicit SingleShear(const Vector& direction) {
        const LongestAxis<Vector> longest(direction);
        double all[4];
        store(all, direction);
        kz = longest.index();
        speed = all[kz];
        const bool flips = speed < 0;
        kx = flips ? longest.after_next() : longest.next();
        ky = flips ? longest.next() : longest.after_next();
        moves = speed != 0;
        const double along = moves ? speed : 1;
        sx = moves ? all[kx] / along : 0;
        sy = moves ? all[ky] / along : 0;
    }

    /// The components along x, y and z.
    GPHYS_INLINE void turn(const Vector& v, double (&to)[3]) const {
        double all[4];
        store(all, v);
        to[0] = all[kx];
        to[1] = all[ky];
        to[2] = all[kz];
    }

    int kx, ky, kz;
    bool moves;  // unless the direction is zero
    double speed, sx, sy;
};

/// Of several, in the lanes of a Number.
template <class Number>
class Shear {
public:
    GPHYS_INLINE explicit Shear(const Vec<Number>& direction)
        : longest_(direction), speed(longest_.of(direction)), flips_(speed < 0), moves(0 < absolute(speed)) {
        const Number along = select(moves, speed, 1);
        sx = select(moves, x(direction) / along, 0);
        sy = select(moves, y(direction) / along, 0);
    }

    template <class Value>
    GPHYS_INLINE Number x(const Vec<Value>& v) const {
        return select(flips_, longest_.after_next(v), longest_.next(v));
    }
    template <class Value>
    GPHYS_INLINE Number y(const Vec<Value>& v) const {
        return select(flips_, longest_.next(v), longest_.after_next(v));
    }
    template <class Value>
    GPHYS_INLINE Number z(const Vec<Value>& v) const {
        return longest_.of(v);
    }
    GPHYS_INLINE void turn(const Vec<Number>& v, Number (&to)[3]) const {
        to[0] = x(v);
        to[1] = y(v);
        to[2] = z(v);
    }

private:
    using Mask = decltype(Number() < Number());

    LongestAxis<Vec<Number>> longest_;

public:
    Number speed;

private:
    Mask flips_;

public:
    Mask moves;
    Number sx, sy;
};

}  // namespace gphys

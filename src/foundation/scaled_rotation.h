// |q|^2 times the rotation by a quaternion q = (u, w), applied to float vectors without a matrix and without a
// division: w^2 v + (u . v) u + 2 w (u x v) - u x (u x v).
#pragma once

#include "foundation/float4.h"

namespace gphys {

/// Vector: Float4 for one rotation, with x, y, z in a register, or a Vec of registers for one rotation per lane. Both
/// compute the same bits.
template <class Vector>
class ScaledRotation {
public:
    /// For Float4 all lanes are the same.
    using Number = decltype(dot(Vector(), Vector()));

    GPHYS_INLINE ScaledRotation(const Vector& u, Number w) : u_(u), w_(w) {
        const Number uu = dot(u, u), ww = w * w;
        norm_squared_ = ww + uu;
        rest_ = ww - uu;
    }

    GPHYS_INLINE Number norm_squared() const { return norm_squared_; }
    GPHYS_INLINE const Vector& axis() const { return u_; }  // times the sine of half the angle
    GPHYS_INLINE Number w() const { return w_; }

    GPHYS_INLINE Vector operator()(const Vector& v) const {
        return rest_ * v + twice(dot(u_, v) * u_ + w_ * cross(u_, v));
    }
    /// The inverse rotation, by the conjugate.
    GPHYS_INLINE Vector inverse(const Vector& v) const {
        return rest_ * v + twice(dot(u_, v) * u_ + w_ * cross(v, u_));
    }
    /// The half extents of the AABB of a rotated box (Arvo 1990): the absolute values of the matrix times `half`.
    GPHYS_INLINE Vector extents(const Vector& half) const {
        const Vector products = by_component(u_, yzx(u_)), turns = zxy(w_ * u_);
        const Vector same = abs(plus(by_component(twice(u_), u_), rest_));
        const Vector next = abs(products - turns), previous = abs(zxy(products + turns));
        return by_component(same, half) + twice(by_component(next, yzx(half)) + by_component(previous, zxy(half)));
    }

private:
    GPHYS_INLINE static Vector twice(const Vector& v) { return v + v; }

    Vector u_;
    Number w_, norm_squared_, rest_;
};

}  // namespace gphys

// Boxes along the axes of the world around boxes that are rotated, in floats, for trees: they may be larger than
// they have to be, never smaller. The smallest ones are bounds(Obb) in shapes.h.
#pragma once

#include "foundation/scaled_rotation.h"

namespace gphys {

/// How far a rotated box reaches from its centre. A component of a rotated half size takes 13 roundings of 2^-24 of
/// what it is summed from, the square of the quaternion's norm six; 2^-19 stands for 32.
template <class Vector>
GPHYS_INLINE Vector outer_extents(const ScaledRotation<Vector>& rotation, const Vector& half) {
    const auto norm_squared = rotation.norm_squared();
    return plus(rotation.extents(half) / norm_squared, splat_as(norm_squared, 0x1p-19f) * sum(half));
}

/// How far out to move a corner that was computed by two roundings, and what underflow may have taken.
template <class Vector>
GPHYS_INLINE Vector corner_margin(const Vector& corner) {
    const decltype(sum(corner)) number{};
    return plus(abs(corner) * splat_as(number, 0x1p-23f), splat_as(number, 0x1p-126f));
}

}  // namespace gphys

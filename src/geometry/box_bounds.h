// Conservative AABBs of rotated boxes in float, for trees: never too small, but not the smallest. bounds(Obb) in
// shapes.h computes the smallest. The extents are those of Arvo (Graphics Gems, 1990): absolute values of the rotation
// matrix times the half extents.
#pragma once

#include "foundation/scaled_rotation.h"

namespace gphys {

/// The half extents of the AABB of a rotated box. A component has 13 roundings of 2^-24 of its terms, the squared norm
/// of the quaternion has six. The margin of 2^-19 covers 32.
template <class Vector>
GPHYS_INLINE Vector outer_extents(const ScaledRotation<Vector>& rotation, const Vector& half) {
    const auto norm_squared = rotation.norm_squared();
    return plus(rotation.extents(half) / norm_squared, splat_as(norm_squared, 0x1p-19f) * sum(half));
}

/// The outward margin of a corner: two roundings, and the loss by underflow.
template <class Vector>
GPHYS_INLINE Vector corner_margin(const Vector& corner) {
    const decltype(sum(corner)) number{};
    return plus(abs(corner) * splat_as(number, 0x1p-23f), splat_as(number, 0x1p-126f));
}

}  // namespace gphys

// Directions from the axis of a capsule that is so long, in parts of its radius, that a point computed on
// the axis is off by a part of the radius that shows in a normal.
#pragma once

#include "foundation/exact.h"
#include "shapes/shapes.h"

namespace gphys {

/// Whether a point on the axis, computed as a + along (b - a), may be off by more than 2^-30 of a radius
/// that is not 0. It goes through some four roundings of 2^-53 of `size`: of the coordinates of a, of those
/// that the query counts from there, and of the axis.
constexpr bool is_coarse(double size, double radius) { return radius > 0 && size > radius * 0x1p21; }

/// The part of v, from `start` to `end`, that is perpendicular to the axis, which has a length:
/// (axis x v) x axis / |axis|^2. The inner product loses nothing to cancellation, and the outer one is of
/// perpendicular vectors.
inline Vec3 perpendicular_part(const Capsule& capsule, Vec3 start, Vec3 end) {
    const Vec3 axis = capsule.b - capsule.a;
    return cross(accurate_cross(capsule.a, capsule.b, start, end), axis) / length_squared(axis);
}
/// From the line of the axis to a point.
inline Vec3 away_from_line(const Capsule& capsule, Vec3 point) { return perpendicular_part(capsule, capsule.a, point); }
/// How a vector leads across it.
inline Vec3 across_line(const Capsule& capsule, Vec3 vector) { return perpendicular_part(capsule, {}, vector); }

}  // namespace gphys

// Accurate normals of capsules that are very long relative to their radius. There the rounding error of a point on the
// axis would be visible in a normal computed from it.
#pragma once

#include "foundation/exact.h"
#include "shapes/shapes.h"

namespace gphys {

/// Whether a point on the axis, computed as a + along (b - a), may have an error above 2^-30 of the radius. It has
/// about four roundings of 2^-53 of `size`: the largest of the coordinates of a, of the query relative to a, and of the
/// axis.
constexpr bool is_coarse(double size, double radius) { return radius > 0 && size > radius * 0x1p21; }

/// The component of v = end - start perpendicular to the axis: (axis x v) x axis / |axis|^2. The inner product is
/// accurate in spite of cancellation; the factors of the outer one are perpendicular. The axis must not be zero.
inline Vec3 perpendicular_part(const Capsule& capsule, Vec3 start, Vec3 end) {
    const Vec3 axis = capsule.b - capsule.a;
    return cross(accurate_cross(capsule.a, capsule.b, start, end), axis) / length_squared(axis);
}
/// The vector from the line of the axis to a point.
inline Vec3 away_from_line(const Capsule& capsule, Vec3 point) { return perpendicular_part(capsule, capsule.a, point); }
/// The component of a vector perpendicular to the axis.
inline Vec3 across_line(const Capsule& capsule, Vec3 vector) { return perpendicular_part(capsule, {}, vector); }

}  // namespace gphys

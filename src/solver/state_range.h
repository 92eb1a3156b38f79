// The range of numbers that a body keeps from step to step. Snapshots beyond it are rejected. A step that has left it,
// by forces, speeds or contacts that are too large for doubles, ends within it.
#pragma once

#include "solver/body.h"

namespace gphys {

// A position that was in range, relative to another origin that is also in range: three times the range, and some
// rounding.
constexpr double far_range = 4.0 * GPHYS_MAX_COORDINATE;

inline bool is_finite(double value) { return std::isfinite(value); }
inline bool is_finite(Vec3 value) { return is_finite(value.x) && is_finite(value.y) && is_finite(value.z); }
/// Intermediate results may be rounded beyond the range.
constexpr double farthest_place = GPHYS_MAX_COORDINATE * (1 + 0x1p-40);
inline bool is_place(Vec3 value) { return is_within(farthest_place, value); }
inline bool is_earlier_place(Vec3 value) { return is_within(far_range, value); }
inline bool is_speed(Vec3 value) { return is_within(fastest_particle, value); }

/// Call at the end of a step: particles that have left the range stop at its border, and the body continues as after a
/// change by the caller. Only the positions of its particles are kept.
void stay_in_range(Body& body);

}  // namespace gphys

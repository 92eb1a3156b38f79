// The range that a body keeps to from step to step. Words of a snapshot beyond it are refused; a step that has left it,
// by forces, speeds or contacts that are too large for the numbers, ends within it.
#pragma once

#include "solver/body.h"

namespace gphys {

// A place that was in range, as it is relative to another origin: both origins are in range as well. Three times the
// range, and some rounding.
constexpr double far_range = 4.0 * GPHYS_MAX_COORDINATE;

inline bool is_finite(double value) { return std::isfinite(value); }
inline bool is_finite(Vec3 value) { return is_finite(value.x) && is_finite(value.y) && is_finite(value.z); }
/// On its way to where it is, a place may be rounded beyond the range.
constexpr double farthest_place = GPHYS_MAX_COORDINATE * (1 + 0x1p-40);
inline bool is_place(Vec3 value) { return is_within(farthest_place, value); }
inline bool is_earlier_place(Vec3 value) { return is_within(far_range, value); }
inline bool is_speed(Vec3 value) { return is_within(fastest_particle, value); }

/// At the end of a step: what has left the range stops at its border, and the body goes on as after a change by the
/// caller. Of a body that leaves it no more is known than where its particles are.
void stay_in_range(Body& body);

}  // namespace gphys

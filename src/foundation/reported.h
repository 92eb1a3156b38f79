// Distances as they are reported, rounded to float. Of results that are equal as floats the lower id wins, then the
// lower triangle index, whatever the doubles are. So results are compared as floats, and traversals prune with a limit
// in double that keeps all ties.
#pragma once

#include <limits>

#include "foundation/compiler.h"
#include "foundation/numbers.h"

namespace gphys {

/// A t or distance >= 0, without -0. Clamped: the conversion of a larger double raises an exception.
GPHYS_INLINE float reported(double value) {
    constexpr double last = std::numeric_limits<float>::max();
    return static_cast<float>(value < last ? value : last) + 0.0f;
}

/// A limit such that every double above it is reported as farther than `value`.
///
/// A double rounds to a float from up to half of the distance to the next float. The limit is beyond that next float,
/// so that results with an error of up to 2^-25 are not lost either. The distance to the next float is at most 2^-23 of
/// a normal float, and 2^-149 for others. The largest float has no next one.
template <class Number>
GPHYS_INLINE Number limit_of_ties(Number value) {
    constexpr double last = std::numeric_limits<float>::max(), beyond = std::numeric_limits<double>::infinity();
    return select(last * (1 - 0x1p-24) < value, beyond, value * (1 + 0x1p-22) + 0x1p-148);
}

/// Which results tie: those that are equal as reported, or only those that are equal as doubles, for callers that
/// compute further with them.
enum class Ties { as_reported, as_computed };

}  // namespace gphys

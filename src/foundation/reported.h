// How far something is, as it is reported: a float. Of results that are reported as equally far the one
// with the lower id is the answer, then the one with the lower triangle index, whatever the doubles say
// that they were rounded from. So these are compared as floats, and what cannot come before the best so
// far is told by a limit with room for all that ties with it.
#pragma once

#include <limits>

#include "foundation/compiler.h"
#include "foundation/numbers.h"

namespace gphys {

/// A t or a distance, which is not negative, nor minus zero. The cast would trap beyond the largest float.
GPHYS_INLINE float reported(double value) {
    constexpr double last = std::numeric_limits<float>::max();
    return static_cast<float>(value < last ? value : last) + 0.0f;
}

/// What is further than this is reported as further than what is reported as `value` is.
///
/// The doubles that round to a float are up to half of its distance to the next one away from it; this is
/// beyond that next one, so that what has been computed with an error of up to 2^-25 of it is not lost
/// either. The distance to the next float is at most 2^-23 of a normal one and 2^-149 of others. From the
/// largest on there is no next one.
template <class Number>
GPHYS_INLINE Number limit_of_ties(Number value) {
    constexpr double last = std::numeric_limits<float>::max(), beyond = std::numeric_limits<double>::infinity();
    return select(last * (1 - 0x1p-24) < value, beyond, value * (1 + 0x1p-22) + 0x1p-148);
}

/// Which results tie: those that are reported as equally far, or only those at the same double, for what
/// goes on to compute with it.
enum class Ties { as_reported, as_computed };

}  // namespace gphys

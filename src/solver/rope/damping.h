// A damped link as an undamped one with other numbers. With its length l at the end of a substep, and
// the rate of that by the formula of the time scheme, its tension is
//
//     t = (l - rest) / compliance + damping (next l - past) / h,   past = now l0 - earlier l_(-1) + lean l0'
//
// which is linear in l, so that it is also (l - rest') / compliance' with
//
//     rest' = (rest + weight past / next) / (1 + weight),  compliance' = compliance / (1 + weight),
//     weight = compliance damping next / h
//
// Implicit, and therefore stable however strong; of second order; and none if the link turns only.
#pragma once

#include "solver/time_scheme.h"

namespace gphys {

struct DampedLink {
    double rest, compliance;
};

/// `length` and its rate at the beginning of the substep, `length_before` a substep earlier.
inline DampedLink damped(double rest, double compliance, double damping, const TimeScheme& scheme, double length,
                         double length_before, double rate) {
    const double weight = compliance * damping * scheme.next / scheme.h;
    const double past = scheme.from_history(length, length_before, rate);
    // Beyond all measure, it keeps the length it would have coasting.
    if (weight > 1e30) return {past / scheme.next, scheme.h / (damping * scheme.next)};
    return {(rest + weight * past / scheme.next) / (1 + weight), compliance / (1 + weight)};
}

}  // namespace gphys

// A damped link as an undamped one with other parameters. Let l be its length at the end of a substep. Its rate is that
// of the time scheme (TimeScheme), so its tension is
//
//     t = (l - rest) / compliance + damping (next l - past) / h,   past = now l0 - earlier l_(-1) + explicit_h l0'
//
// This is linear in l, so it is also (l - rest') / compliance' with
//
//     rest' = (rest + weight past / next) / (1 + weight),  compliance' = compliance / (1 + weight),
//     weight = compliance damping next / h
//
// The damping is implicit, and therefore stable for any parameter. It is of second order, and zero if the link only
// rotates.
#pragma once

#include "solver/time_scheme.h"

namespace gphys {

struct DampedLink {
    double rest, compliance;  // m, m/N
};

/// `damping`: N s/m. `length` and `rate`: m and m/s, at the beginning of the substep. `length_before`: one substep
/// earlier.
inline DampedLink damped(double rest, double compliance, double damping, const TimeScheme& scheme, double length,
                         double length_before, double rate) {
    const double weight = compliance * damping * scheme.next / scheme.h;
    const double past = scheme.from_history(length, length_before, rate);
    // The limit of large damping, before the products overflow: the link keeps the length that it would have without
    // forces.
    if (weight > 1e30) return {past / scheme.next, scheme.h / (damping * scheme.next)};
    return {(rest + weight * past / scheme.next) / (1 + weight), compliance / (1 + weight)};
}

}  // namespace gphys

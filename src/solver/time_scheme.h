// Time integration of constrained bodies: the trapezoid rule in the first part of a substep and the backward
// differentiation formula of second order in the rest (TR-BDF2; Bank et al. 1985, "Transient simulation of silicon
// devices and circuits"; Hosea & Shampine 1996, "Analysis and implementation of TR-BDF2"), or the backward formula
// alone, for unequal steps.
#pragma once

#include "foundation/math.h"

namespace gphys {

/// x1 = (now x0 - earlier x_(-1) + explicit_h v0 + h v1) / next, and the same for v1 with the acceleration. The
/// implicit part of the step is h, the explicit part explicit_h, which only the trapezoid rule has. For the backward
/// formula, where next = now - earlier, this is also x1 - x0 = (earlier (x0 - x_(-1)) + h v1) / next.
struct TimeScheme {
    double h;  // seconds
    double next = 1, now = 1, earlier = 0;
    double explicit_h = 0;  // seconds
    double advance;         // seconds from x0 to x1

    /// The backward formula.
    TimeScheme(double step, double step_before) : h(step), advance(step) {
        // Steps that grow faster than 1 + sqrt(2) make the formula unstable (Grigorieff 1983).
        const double ratio = step_before > 0 ? step / step_before : infinity;
        if (ratio > 2) return;
        next = (1 + 2 * ratio) / (1 + ratio);
        now = 1 + ratio;
        earlier = ratio * ratio / (1 + ratio);
    }
    static TimeScheme trapezoid(double step) {
        TimeScheme scheme(step / 2, 0);
        scheme.explicit_h = scheme.h;
        scheme.advance = step;
        return scheme;
    }

    /// `rate` is that of x0; the backward formula does not use it.
    template <class Value>
    Value from_history(Value x0, Value x_before, Value rate = {}) const {
        if (explicit_h > 0) return x0 + rate * explicit_h;
        return earlier == 0 ? x0 : x0 * now - x_before * earlier;
    }

    /// 1 / next with damping. Damping is part of the formula, so it is as accurate as the rest and never overshoots.
    double drag(double damping) const { return 1 / (next + damping * h); }
    /// A force acts on the position through both formulas, h / next for each: by f / m * step()^2.
    double step(double damping) const { return h / std::sqrt(next * (next + damping * h)); }
};

/// The part of a substep that uses the trapezoid rule: 2 - sqrt(2). Then both parts have the same system of equations,
/// and the error is least.
constexpr double first_stage = 0.58578643762690495;
constexpr double stages[] = {first_stage, 1 - first_stage};

/// The first step after an interruption is of first order, and would leave an error of the size of a substep for good.
/// So it is made in these parts, the first of them a quarter of it. The backward formula allows steps to double.
constexpr double starting_parts[] = {0.25, 0.25, 0.5};

}  // namespace gphys

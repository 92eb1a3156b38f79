// The backward differentiation formula of second order for unequal steps.
#pragma once

#include "foundation/math.h"

namespace gphys {

/// x1 = (now x0 - earlier x_(-1) + h v1) / next, and the same for v1 with h times the acceleration.
/// As next = now - earlier, it is also x1 - x0 = (earlier (x0 - x_(-1)) + h v1) / next.
struct TimeScheme {
    double h;
    double next = 1, now = 1, earlier = 0;

    TimeScheme(double step, double step_before) : h(step) {
        // Steps that grow faster than 1 + sqrt(2) make the formula unstable (Grigorieff 1983).
        const double ratio = step_before > 0 ? step / step_before : infinity;
        if (ratio > 2) return;
        next = (1 + 2 * ratio) / (1 + ratio);
        now = 1 + ratio;
        earlier = ratio * ratio / (1 + ratio);
    }

    Vec3 from_history(Vec3 x0, Vec3 x_before) const { return earlier == 0 ? x0 : x0 * now - x_before * earlier; }

    /// 1 / next with damping: it is part of the formula, so it is as accurate as the rest and never
    /// overshoots.
    double drag(double damping) const { return 1 / (next + damping * h); }
    /// A force acts on the position through both formulas, h / next for each: by f / m * step()^2.
    double step(double damping) const { return h / std::sqrt(next * (next + damping * h)); }
};

/// The first step after an interruption is of first order, and would leave an error of the size of a
/// substep for good; it is made in these parts of one, the first a quarter as long. The formula allows
/// steps to double.
constexpr double starting_parts[] = {0.25, 0.25, 0.5};

}  // namespace gphys

// What RayProbe (box8.h) consists of, before it is rounded to floats: one formula for one ray, with
// Number = double, and for eight side by side, with the Double8 of a set of instructions. Derived in
// box8.cpp.
#pragma once

#include "bvh/box8.h"
#include "foundation/compiler.h"
#include "foundation/longest_axis.h"

namespace gphys {

constexpr double smallest_normal = std::numeric_limits<float>::min();

/// What the double arithmetic of a query whose largest coordinate is w may be off by: a few dozen
/// roundings of 2^-53 each. The smallest normal float beside it keeps differences of coordinates
/// clear of the subnormals, which some hosts flush to zero.
template <class Number>
GPHYS_INLINE Number rounding_slack(Number w) {
    return 0x1p-48 * w + smallest_normal;
}

template <class Number>
struct RaySetup {
    Number near_origin[3], far_origin[3], back[3];
    Number along[3];  // has the signs of the direction
    Number begin[3];
    Number slack, scale, start, span;

    GPHYS_INLINE RaySetup(const Number (&from)[3], const Number (&direction)[3], const RaysRoot& root) {
        const Number furthest = largest(absolute(from[0]), largest(absolute(from[1]), absolute(from[2])));
        slack = rounding_slack(largest(largest(root.extent, furthest), root.radius));
        const Number margin = root.radius + slack;
        const Number length = largest(absolute(direction[0]), largest(absolute(direction[1]), absolute(direction[2])));
        const auto moves = 0 < length;
        scale = select(moves, length, 1);
        const Number to_unit = 1 / scale;
        for (int k = 0; k < 3; ++k) along[k] = direction[k] * to_unit;

        const LongestAxis<Number> main(direction);
        const Number low = main.of(root.low), high = main.of(root.high);
        const auto backward = main.of(direction) < 0;
        const Number sense = select(backward, -1, 1);
        start = largest(0, (select(backward, high, low) - main.of(from)) * sense - margin);
        start = select(moves, start, 0);
        for (int k = 0; k < 3; ++k) begin[k] = from[k] + along[k] * start;
        span = (select(backward, low, high) - main.of(begin)) * sense + margin;
        span = select(moves, span, 0);
        // From further away the ray cannot come back to the root within its span.
        const Number beyond = largest(absolute(begin[0]), largest(absolute(begin[1]), absolute(begin[2])));
        const auto never = (span < 0) | (root.extent + span + margin < beyond);
        span = select(never, -infinity, span);

        constexpr double rounding = 5 * 0x1p-24, flushed = 4 * smallest_normal;
        const Number wide = margin + rounding * root.extent + flushed;
        for (int k = 0; k < 3; ++k) {
            begin[k] = select(never, 0, begin[k]);
            const Number width = with_sign(wide + rounding * (absolute(begin[k]) + margin), along[k]);
            near_origin[k] = begin[k] + width;
            far_origin[k] = begin[k] - width;
            back[k] = -scale / with_sign(largest(absolute(direction[k]), 0x1p-68 * scale), direction[k]);
        }
        // Beyond this the margin alone is wider than any tree: no box can be excluded.
        const auto everything = 0x1p53 < margin;
        if (any(everything)) take_in(everything);
    }

private:
    GPHYS_INLINE void take_in(decltype(Number() < Number()) everything) {
        for (int k = 0; k < 3; ++k) {
            near_origin[k] = select(everything, 0x1p56, near_origin[k]);
            far_origin[k] = select(everything, -0x1p56, far_origin[k]);
            back[k] = select(everything, -0x1p68, back[k]);
            along[k] = select(everything, 0, along[k]);
            begin[k] = select(everything, 0, begin[k]);
        }
        slack = select(everything, 0, slack);  // limits are to be floats
        start = select(everything, 0, start);
        span = select(everything, beyond_trees, span);
    }
};

/// What box tests compare with, before it is rounded to a float; negative if the ray meets nothing.
///
/// There is room for that rounding, and for those of tests that add to the limit in floats (triangle_test.h).
template <class Number>
GPHYS_INLINE Number ray_limit(Number t_max, Number slack, Number scale, Number start, Number span) {
    const Number end = least(t_max * scale - start, span) + slack;
    return select((t_max < 0) | (end < 0), -1, end * (1 + 17 * 0x1p-24));
}

}  // namespace gphys

// What RayProbe (box8.h) consists of, before it is rounded to floats: one formula for one ray, with
// Vector = Vec<double> or the Axes of a set of instructions, and for eight side by side, with Vec<Double8>. Derived in
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

template <class N>
GPHYS_INLINE void load(const double (&from)[4], Vec<N>& to) {
    to = {from[0], from[1], from[2]};
}

template <class Vector>
struct RaySetup {
    using Number = decltype(max_component(Vector()));

    Vector near_origin, far_origin, back;
    Vector along;  // has the signs of the direction
    Vector begin;
    Number slack, scale, start, span;

    GPHYS_INLINE RaySetup(const Vector& from, const Vector& direction, const RaysRoot& root) {
        slack = rounding_slack(largest(largest(root.extent, max_component(abs(from))), root.radius));
        const Number margin = root.radius + slack;
        const Vector size = abs(direction);
        const Number length = max_component(size);
        const auto moves = 0 < length;
        scale = select(moves, length, 1);
        const Number to_unit = 1 / scale;
        along = direction * to_unit;

        const LongestAxis<Vector> main(direction);
        const Number low = main.of(root.low), high = main.of(root.high);
        const Number from_main = main.of(from), direction_main = main.of(direction);
        const auto backward = direction_main < 0;
        const Number sense = select(backward, -1, 1);
        start = largest(0, (select(backward, high, low) - from_main) * sense - margin);
        start = select(moves, start, 0);
        begin = from + along * start;
        span = (select(backward, low, high) - (from_main + direction_main * to_unit * start)) * sense + margin;
        span = select(moves, span, 0);
        // From further away the ray cannot come back to the root within its span.
        const auto never = (span < 0) | (root.extent + span + margin < max_component(abs(begin)));
        span = select(never, -infinity, span);

        constexpr double rounding = 5 * 0x1p-24, flushed = 4 * smallest_normal;
        const Number wide = margin + rounding * root.extent + flushed;
        begin = select(never, Vector{}, begin);
        const Vector width = with_signs(plus(plus(abs(begin), margin) * rounding, wide), along);
        near_origin = begin + width;
        far_origin = begin - width;
        back = quotients(-scale, with_signs(at_least(size, 0x1p-68 * scale), direction));
        // Beyond this the margin alone is wider than any tree: no box can be excluded.
        const auto everything = 0x1p53 < margin;
        if (any(everything)) take_in(everything);
    }

private:
    GPHYS_INLINE void take_in(decltype(Number() < Number()) everything) {
        const auto all = [](double value) {
            Vector of_axes;
            load({value, value, value, value}, of_axes);
            return of_axes;
        };
        near_origin = select(everything, all(0x1p56), near_origin);
        far_origin = select(everything, all(-0x1p56), far_origin);
        back = select(everything, all(-0x1p68), back);
        along = select(everything, all(0), along);
        begin = select(everything, all(0), begin);
        slack = select(everything, 0, slack);  // limits are to be floats
        start = select(everything, 0, start);
        span = select(everything, beyond_trees, span);
    }
};

template <class Vector>
GPHYS_INLINE void put_probe(const RaySetup<Vector>& setup, RayProbe& probe) {
    store_narrowed(probe.near_origin, setup.near_origin);
    store_narrowed(probe.far_origin, setup.far_origin);
    store_narrowed(probe.back, setup.back);
    const uint32_t minus = signs_of(setup.along);
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t backward = (minus >> k & 1) * 24;
        probe.near_face[k] = 8 * k + backward;
        probe.far_face[k] = 8 * k + 24 - backward;
    }
    store(probe.begin, setup.begin);
    probe.course = {setup.slack, setup.scale, setup.start, setup.span};
}

/// What box tests compare with, before it is rounded to a float; negative if the ray meets nothing.
///
/// There is room for that rounding, and for those of tests that add to the limit in floats (triangle_test.h).
template <class Number>
GPHYS_INLINE Number ray_limit(Number t_max, Number slack, Number scale, Number start, Number span) {
    const Number end = least(t_max * scale - start, span) + slack;
    return select((t_max < 0) | (end < 0), -1, end * (1 + 17 * 0x1p-24));
}

}  // namespace gphys

// The numbers of RayProbe (box8.h) before they are rounded to float. One formula: for one ray with Vector = Vec<double>
// or Axes (simd_axes.h), for eight rays with Vec<Double8>. box8.cpp has the derivation.
#pragma once

#include "bvh/box8.h"
#include "foundation/compiler.h"
#include "foundation/longest_axis.h"

namespace gphys {

constexpr double smallest_normal = std::numeric_limits<float>::min();

/// Bound of the rounding of a query's double arithmetic, if its largest coordinate is w: a few dozen roundings of
/// 2^-53. The smallest normal float keeps differences of coordinates away from the subnormals, which some hosts flush
/// to zero.
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

    Vector near_origin, far_origin, minus_inverse;
    Vector unit_direction;  // its largest component is 1 or -1
    Vector begin;           // the origin, moved forward to the root box
    Number slack, scale, start, span;

    GPHYS_INLINE RaySetup(const Vector& from, const Vector& direction, const RootBounds& root) {
        slack = rounding_slack(largest(largest(root.extent, max_component(abs(from))), root.radius));
        const Number margin = root.radius + slack;
        const Vector size = abs(direction);
        const Number length = max_component(size);
        const auto moves = 0 < length;
        scale = select(moves, length, 1);
        const Number to_unit = 1 / scale;
        unit_direction = direction * to_unit;

        const LongestAxis<Vector> main(direction);
        const Number low = main.of(root.low), high = main.of(root.high);
        const Number from_main = main.of(from), direction_main = main.of(direction);
        const auto backward = direction_main < 0;
        const Number sense = select(backward, -1, 1);
        start = largest(0, (select(backward, high, low) - from_main) * sense - margin);
        start = select(moves, start, 0);
        begin = from + unit_direction * start;
        span = (select(backward, low, high) - (from_main + direction_main * to_unit * start)) * sense + margin;
        span = select(moves, span, 0);
        // Farther away, the ray cannot reach the root within its span.
        const auto never = (span < 0) | (root.extent + span + margin < max_component(abs(begin)));
        span = select(never, -infinity, span);

        constexpr double rounding = 5 * 0x1p-24, flushed = 4 * smallest_normal;
        const Number wide = margin + rounding * root.extent + flushed;
        begin = select(never, Vector{}, begin);
        const Vector width = with_signs(plus(plus(abs(begin), margin) * rounding, wide), unit_direction);
        near_origin = begin + width;
        far_origin = begin - width;
        minus_inverse = quotients(-scale, with_signs(at_least(size, 0x1p-68 * scale), direction));
        // With a larger margin, no box can be rejected: the margin alone is wider than any tree.
        const auto everything = 0x1p53 < margin;
        if (any(everything)) accept_all(everything);
    }

private:
    GPHYS_INLINE void accept_all(decltype(Number() < Number()) everything) {
        const auto all = [](double value) {
            Vector of_axes;
            load({value, value, value, value}, of_axes);
            return of_axes;
        };
        near_origin = select(everything, all(0x1p56), near_origin);
        far_origin = select(everything, all(-0x1p56), far_origin);
        minus_inverse = select(everything, all(-0x1p68), minus_inverse);
        unit_direction = select(everything, all(0), unit_direction);
        begin = select(everything, all(0), begin);
        slack = select(everything, 0, slack);  // limits must fit into floats
        start = select(everything, 0, start);
        span = select(everything, unbounded_span, span);
    }
};

template <class Vector>
GPHYS_INLINE void store_probe(const RaySetup<Vector>& setup, RayProbe& probe) {
    store_narrowed(probe.near_origin, setup.near_origin);
    store_narrowed(probe.far_origin, setup.far_origin);
    store_narrowed(probe.minus_inverse, setup.minus_inverse);
    const uint32_t minus = signs_of(setup.unit_direction);
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t backward = (minus >> k & 1) * 24;
        probe.near_face[k] = 8 * k + backward;
        probe.far_face[k] = 8 * k + 24 - backward;
    }
    store(probe.begin, setup.begin);
    probe.path = {setup.slack, setup.scale, setup.start, setup.span};
}

/// The end of the ray in the unit of the box tests, before it is rounded to float; negative if the ray hits no box. The
/// factor covers that rounding, and those of tests that add to the limit in float (triangle_test.h).
template <class Number>
GPHYS_INLINE Number ray_limit(Number t_max, Number slack, Number scale, Number start, Number span) {
    const Number end = least(t_max * scale - start, span) + slack;
    return select((t_max < 0) | (end < 0), -1, end * (1 + 17 * 0x1p-24));
}

}  // namespace gphys

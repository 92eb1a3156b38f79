// The numbers of a TriangleProbe before they are rounded to float, for one ray with Vector = Vec<double> or the Axes of
// a kernel, or for eight with Vec<Double8>.
#pragma once

#include "bvh/ray_setup.h"
#include "foundation/compiler.h"
#include "foundation/numbers.h"

namespace gphys {

// The signs of three volumes decide whether a ray passes through a triangle (raycast_triangle.cpp). Here they are
// computed in float: x = X - sx Z and y = Y - sy Z, where X, Y, Z is a corner relative to the start of the ray, and
// then products like a.x b.y - a.y b.x.
//
// Let u = 2^-24, R the distance on an axis from the start of the ray to the farthest side of the root, and o the error
// of the float origin on that axis. Then the error of X is at most o + u R, likewise of Z; of the slope it is u of
// itself, of its product with Z another u, and of their difference u (R + |sx| Rz):
//     ex = ox + 2 u R + |sx| (oz + 4 u Rz)
// and a little for the terms in u^2. Along the ray the error is ez = oz + u Rz: the margin. Each axis has its own
// error, so that a mesh that is thin along one axis is not lost in the rounding errors of its length.
//
// The error of a volume of coordinates up to rx and ry (as computed) is then 2 (rx ey + ry ex) + 2 ex ey for the
// coordinates and 4 u rx ry for its own three roundings. As u rx is at most ex / 2 (1 + 2 u), that is another rx ey +
// ry ex: 3.1 (rx ey + ry ex) + 3 ex ey covers the rest and its own computation.
//
// The host may flush numbers below 2^-126 to zero: each coordinate may have the error of four such flushes and, times
// Z, that of the slope; each volume of three more.
//
// Nothing overflows: the root is within 2^53 of the beginning, coordinates stay below 2^55 and
// volumes below 2^111.
template <class Vector>
struct TriangleSetup {
    using Number = decltype(max_component(Vector()));
    using Mask = decltype(Number() < Number());

    Number origin[3], slope_x, slope_y, error_slope_x, error_slope_y, error, margin, ahead;

    /// `begin`, `slack` and may_reject() are those of the ray's RayProbe for the root box.
    template <class ShearOf>
    GPHYS_INLINE TriangleSetup(const ShearOf& shear, const Vector& begin, Number slack, Mask may_reject,
                               const RootBounds& root) {
        Vector low, high;
        load(root.low, low);
        load(root.high, high);
        const Vector origins = rounded_to_float(begin);
        Number off[3], reach[3];
        shear.turn(origins, origin);
        shear.turn(plus(abs(begin - origins), slack), off);
        shear.turn(max(high - begin, begin - low), reach);
        constexpr double u = 0x1p-24, flushed = 0x1p-124;
        const auto across = [&](int k, Number per_step) {
            return 1.01 * (off[k] + 2 * u * reach[k] + absolute(per_step) * (off[2] + 4 * u * reach[2])) +
                   flushed * (1 + reach[2]);
        };
        const Number error_x = across(0, shear.sx), error_y = across(1, shear.sy);
        slope_x = shear.sx;
        slope_y = shear.sy;
        error_slope_x = 3.1 * error_y;
        error_slope_y = 3.1 * error_x;
        error = 3 * error_x * error_y + flushed;
        margin = (1.01 * (off[2] + u * reach[2]) + flushed) * (1 + 2 * u);
        ahead = select(shear.speed < 0, 0, 1);
        const Mask useless = !(shear.moves & may_reject);  // nothing to shear along, or beyond floats
        if (any(useless)) let_pass(useless);
    }

private:
    GPHYS_INLINE void let_pass(Mask useless) {
        for (Number& component : origin) component = select(useless, 0, component);
        for (Number* slope : {&slope_x, &slope_y, &error_slope_x, &error_slope_y}) *slope = select(useless, 0, *slope);
        margin = select(useless, 0x1p120, margin);
        error = select(useless, 0x1p120, error);
    }
};

}  // namespace gphys

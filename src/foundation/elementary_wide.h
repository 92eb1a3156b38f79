// The second phase of the elementary functions: fixed-point values with 224 fractional bits and errors below 2^-200.
// The tests compare them and their constants with MPFR.
#pragma once

#include "foundation/fixed_point.h"

namespace gphys::wide {

// Rounded down: ln 2 / 32, 2^(-1/32), pi / 2, and sin and cos of 1/16.
constexpr Wide ln2_32{{0x6c5068ba, 0x3394c5b1, 0x7a079a19, 0xc01f97b5, 0x5e4f1d9c, 0xbe8e7bcd, 0x058b90bf, 0}};
constexpr Wide root_of_half{{0x4844b29b, 0xa95d14dc, 0x8006fe21, 0x315d7fcc, 0x7c25bb14, 0x722a033a, 0xfa83b2db, 0}};
constexpr Wide half_pi{{0x04177d4c, 0x14cf98e8, 0x52049c11, 0x01b839a2, 0x898cc517, 0x42d18469, 0x921fb544, 1}};
constexpr Wide sin_16th{{0xc2fd5380, 0xb9cbf2d7, 0xfb074dfb, 0x692d4aca, 0x5d259b2f, 0x76a76d5a, 0x0ffd5577, 0}};
constexpr Wide cos_16th{{0xfff062e6, 0x5a2928bd, 0xf80466e8, 0x4de215b8, 0x070f7328, 0x4fa69a65, 0xff800aaa, 0}};
constexpr Wide one{{0, 0, 0, 0, 0, 0, 0, 1}};

/// z in steps of ln 2 / 32, of which 1 to 32 are left to a table and the others are halvings of exp(-z).
struct Steps {
    int count, halvings, entry;

    /// From doubles. The rest is not negative, because the divisor is too large by 2^-40 of itself.
    explicit Steps(double z)
        : count(static_cast<int>(z * (46.166241308446829 * (1 - 0x1p-40)))),
          halvings(count == 0 ? 0 : (count - 1) / 32),
          entry(count - 32 * halvings) {}
};
/// exp(-z) 2^halvings
Wide kept(const Wide& z, const Steps& steps);

struct SinCos {
    Wide sin, cos;
};
/// sin and cos of the distance of x to the nearest multiple of a right angle. 0 <= x <= 4.
SinCos sin_cos(const Wide& x, int quarters);

}  // namespace gphys::wide

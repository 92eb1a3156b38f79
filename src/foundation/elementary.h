// Correctly rounded elementary functions: each result is the double nearest to the true value, on every machine and
// with every C library, compiler and rounding mode. The functions of the C library differ by version and by processor
// (glibc has other code for processors with FMA).
//
// Two phases (Ziv 1991). The first computes in 128-bit integers with a relative error of at most 2^-66, by tables and
// short series (Tang 1989; in integers: Le Maire, Brunie, de Dinechin, Muller 2016). If the midpoint of two doubles is
// within that error, less than once in a thousand calls, the second phase compares the true value with the midpoint in
// 256-bit integers (elementary_wide.h), with an error below 2^-200. The hardest known cases are 2^-120 or more from a
// midpoint (Lefevre and Muller 2001); none at 2^-200 is to be expected among 2^64 doubles. Floating-point arithmetic
// only selects table entries and starts quotients and roots, where the last bit does not matter.
//
// Square roots, remainders and rounding to integers come from the C library: IEEE 754 requires them to be exact or
// correctly rounded.
#pragma once

namespace gphys {

/// Exponential decay: `kept` is exp(-z), `lost` is 1 - exp(-z).
struct Decay {
    double kept, lost;
};
/// z >= 0, which may be infinite.
Decay decay(double z);

struct SinCos {
    double sin, cos;
};
/// For magnitudes of x up to 4; NaN for larger ones.
SinCos sin_cos(double x);
/// For magnitudes of x up to 4; NaN for larger ones.
double tan(double x);
double cbrt(double x);

}  // namespace gphys

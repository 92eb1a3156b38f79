// Elementary functions, correctly rounded: each result is the double nearest to the true value, the same
// on every machine, whatever its C library, its compiler and the rounding mode in force. What the C library
// has for them differs by version and by processor (glibc takes other code where there is FMA).
//
// Each is computed twice at most (Ziv 1991). A first phase in 128-bit integers has an error of at most 2^-66 of
// the value: tables and short series (Tang 1989; in integers: Le Maire, Brunie, de Dinechin, Muller 2016). If the
// middle between two doubles is not further than that, less than once in a thousand times, a second phase in
// 256-bit integers compares the true value with that middle (elementary_wide.h). Its error is below 2^-200. The
// hardest values known of such functions are 2^-120 of themselves or more from a middle (Lefevre and Muller 2001);
// one at 2^-200 is not to be expected among 2^64 doubles. Floating-point arithmetic only chooses the entry of a
// table or begins a quotient or a root, where a last bit more or less makes no difference.
//
// Square roots, remainders and rounding to integers are exact or correctly rounded in every C library
// (IEEE 754) and are taken from there.
#pragma once

namespace gphys {

/// What a time does to something that decays: exp(-z) is kept and 1 - exp(-z) is lost.
struct Decay {
    double kept, lost;
};
/// z >= 0, which may be infinite.
Decay decay(double z);

struct SinCos {
    double sin, cos;
};
/// |x| <= 4; NaN beyond.
SinCos sin_cos(double x);
/// |x| <= 4; NaN beyond.
double tan(double x);
double cbrt(double x);

}  // namespace gphys

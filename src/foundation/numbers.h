// Scalar doubles with the function names of simd_double.h, for formulas that are templates over the type of number.
// These templates are always inlined, so that kernels (isa.h) define nothing outside of their own namespace.
#pragma once

#include <cmath>

#include "foundation/compiler.h"

namespace gphys {

constexpr double select(bool mask, double a, double b) { return mask ? a : b; }
constexpr double least(double a, double b) { return a < b ? a : b; }
constexpr double largest(double a, double b) { return a < b ? b : a; }
inline double absolute(double a) { return std::fabs(a); }
inline double square_root(double a) { return std::sqrt(a); }
inline double rounded_to_float(double a) { return static_cast<double>(static_cast<float>(a)); }
constexpr double splat_as(double, double value) { return value; }
constexpr bool any(bool mask) { return mask; }
inline double with_sign(double a, double sign) { return std::copysign(a, sign); }

}  // namespace gphys

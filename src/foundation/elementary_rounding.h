// Shared by the elementary functions: doubles split into integers, and Ziv's rounding test.
#pragma once

#include <cmath>
#include <cstring>

#include "foundation/compiler.h"
#include "foundation/fixed_point.h"
#include "foundation/floating_point.h"

namespace gphys {

/// The number integer * 2^exponent.
struct Parts {
    uint64_t integer;
    int exponent;

    Wide wide(int scale = 0) const { return Wide::of(integer, exponent + scale); }
};

/// x is finite and > 0.
inline Parts parts_of(double x) {
    uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    const int field = static_cast<int>(bits >> 52);
    const uint64_t mantissa = bits & 0xfffffffffffff;
    return field == 0 ? Parts{mantissa, -1074} : Parts{mantissa | uint64_t{1} << 52, field - 1075};
}

/// The number fraction * 2^(exponent - 128). The high half of the fraction is not 0.
struct Approximation {
    U128 fraction;
    int exponent;
};

/// Of a normal double.
inline Approximation approximation(Parts x) { return {{x.integer << 11, 0}, x.exponent + 53}; }

/// Normalized: the highest bit of the fraction is set.
inline Approximation normalized(Approximation y) {
    const int zeros = leading_zeros(y.fraction.high);
    return {y.fraction << zeros, y.exponent - zeros};
}

/// The double nearest to a value that y approximates with a relative error of at most 2^-accuracy, accuracy >= 64.
/// exceeds(Parts middle) says whether the value is above the midpoint of two doubles; called if y does not decide it.
template <class Exceeds>
double rounded(Approximation y, int accuracy, const Exceeds& exceeds) {
    constexpr int lowest = -1021;  // of normal doubles; those below have fewer bits
    y = normalized(y);
    if (y.exponent < lowest) {
        if (y.exponent < lowest - 53) return 0;
        y.fraction = y.fraction >> (lowest - y.exponent);
        y.exponent = lowest;
    }
    // The 53 bits of the result, and the next 64.
    const uint64_t kept = y.fraction.high >> 11, rest = y.fraction.high << 53 | y.fraction.low >> 11;
    constexpr uint64_t middle = uint64_t{1} << 63;
    const uint64_t error = (uint64_t{1} << (117 - accuracy)) + 1;
    bool up = rest >= middle;
    if (rest - (middle - error) <= 2 * error) up = exceeds(Parts{2 * kept + 1, y.exponent - 54});
    // The hidden bit of a normal mantissa adds 1 to the exponent field, and so does a carry out of it.
    const uint64_t bits = (static_cast<uint64_t>(y.exponent - lowest) << 52) + kept + up;
    double result;
    std::memcpy(&result, &bits, sizeof result);
    return result;
}

/// y + change: y is finite, normal and > 0, |change| < 2^-20 y.
inline Approximation sum(double y, double change) {
    const Parts parts = parts_of(y);
    const double units = std::scalbn(std::fabs(change), 34 - parts.exponent);  // of 2^-34 of the last bit of y
    const auto whole = static_cast<uint64_t>(units);
    const auto rest = static_cast<uint64_t>((units - static_cast<double>(whole)) * 0x1p40);
    const U128 most = U128{0, parts.integer} << 74, offset = (U128{0, whole} << 40) + U128{0, rest};
    return {change < 0 ? most - offset : most + offset, parts.exponent + 54};
}

}  // namespace gphys

// sin and cos by a table in steps of 1/16 and a series for the remainder (Tang 1989); tan is their quotient.
#include <limits>

#include "foundation/elementary.h"
#include "foundation/elementary_rounding.h"
#include "foundation/elementary_wide.h"
#include "foundation/math.h"

namespace gphys {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double largest_angle = 4;
// For smaller angles, sin x and tan x round to x, and cos x rounds to 1: x^2 / 2 is below 2^-54.
constexpr double smallest_angle = 0x1p-27;

/// The sines and cosines of 0, 1/16, 2/16, ... up to more than pi / 4.
struct Table {
    static constexpr int size = 14;
    wide::SinCos all[size];
    U128 sines[size], cosines[size];
    U128 right_angles[4];  // in units of 2^-126, modulo 4

    constexpr Table() : all(), sines(), cosines(), right_angles() {
        all[0] = {Wide{}, wide::one};
        for (int i = 1; i < size; ++i) {
            const wide::SinCos& last = all[i - 1];
            all[i] = {last.sin * wide::cos_16th + last.cos * wide::sin_16th,
                      last.cos * wide::cos_16th - last.sin * wide::sin_16th};
            sines[i] = all[i].sin.fraction();
            cosines[i] = all[i].cos.fraction();
        }
        for (uint64_t i = 0; i < 4; ++i) right_angles[i] = scaled(wide::half_pi * Wide::of(i, 0), -2).fraction();
    }
};
constexpr Table table;

/// The multiple of a right angle that is nearest to x. 0 <= x <= 4.
int quarters_of(double x) { return static_cast<int>(x * 0.63661977236758134 + 0.5); }

/// Argument reduction of the first phase, in units of 2^-126: no double up to 4 but 0 is closer to a multiple of
/// pi / 2 than 2^-54.
struct Angle {
    Parts parts;
    int quarters;
    bool below = false;   // its right angles
    bool before = false;  // the entry of the table
    uint64_t entry = 0;
    Approximation difference;

    /// 2^-60 < x <= 4
    explicit Angle(double x) : parts(parts_of(x)), quarters(quarters_of(x)) {
        if (x < 0x1p-5) {
            difference = approximation(parts);
            return;
        }
        const U128 offset = (U128{0, parts.integer} << (parts.exponent + 126)) - table.right_angles[quarters];
        below = offset.high >> 63 != 0;
        const U128 rest = below ? U128{} - offset : offset;
        entry = (rest.high + (uint64_t{1} << 57)) >> 58;
        const U128 place{entry << 58, 0};
        before = rest < place;
        difference = {before ? place - rest : rest - place, 2};
    }
    wide::SinCos exact() const { return wide::sin_cos(parts.wide(), quarters); }

    // Which functions of the remainder, with which signs, are sin x and cos x.
    bool exchanged() const { return (quarters & 1) != 0; }
    bool sin_negative() const { return ((quarters & 2) != 0) != (below && !exchanged()); }
    bool cos_negative() const { return (((quarters + 1) & 2) != 0) != (below && exchanged()); }
};

/// Sums of q/n! - q^2/(n+2)! + ..., times 2^72, within 2^-71; q is given times 2^72 and at most 2^-10.
/// The coefficients are given times 2^64; the first term left out is below 2^-80.
uint64_t series(uint64_t q, const uint64_t (&inverse_factorial)[5]) {
    uint64_t sum = inverse_factorial[4];
    for (int n = 3; n >= 0; --n) sum = inverse_factorial[n] - (high_product(q, sum) >> 8);
    return high_product(q, sum);
}

struct ApproximateSinCos {
    Approximation sin, cos;
};

/// The first phase: sin and cos of the reduced angle, within 2^-69. With sin h = h (1 - s) and
/// cos h = 1 - v.
ApproximateSinCos approximate_sin_cos(const Angle& x) {
    constexpr uint64_t odd[5] = {0x2aaaaaaaaaaaaaaa, 0x0222222222222222, 0x000d00d00d00d00d, 0x00002e3bc74aad8e,
                                 0x0000006b99159fd5};
    constexpr uint64_t even[5] = {0x8000000000000000, 0x0aaaaaaaaaaaaaaa, 0x005b05b05b05b05b, 0x0001a01a01a01a01,
                                  0x0000049f93edde27};
    const U128 fraction = x.difference.fraction;
    const int exponent = x.difference.exponent;
    const uint64_t h68 = (exponent > 0 ? fraction << exponent >> 60 : fraction >> (60 - exponent)).low;
    const uint64_t q = high_product(h68, h68), s = series(q, odd), v = series(q, even);
    const U128 sin_of_h = fraction - (product(fraction.high, s) >> 8);
    if (x.entry == 0) return {{sin_of_h, exponent}, {(U128{0, 1} << 127) - (U128{0, v} << 55), 1}};
    const U128 sin = table.sines[x.entry], cos = table.cosines[x.entry], sin_h = sin_of_h << exponent;
    const U128 sin_cos_h = sin - (product(sin.high, v) >> 8), cos_cos_h = cos - (product(cos.high, v) >> 8);
    const U128 cos_sin_h = high_product(cos, sin_h), sin_sin_h = high_product(sin, sin_h);
    if (x.before) return {{sin_cos_h - cos_sin_h, 0}, {cos_cos_h + sin_sin_h, 0}};
    return {{sin_cos_h + cos_sin_h, 0}, {cos_cos_h - sin_sin_h, 0}};
}

double negated_if(double size, bool negative) { return negative ? -size : size; }

}  // namespace

// The reduced angle is a table entry plus a difference h of at most 1/32, or slightly more near the middle.
// The series end where h^30 / 30! < 2^-250.
wide::SinCos wide::sin_cos(const Wide& x, int quarters) {
    const Wide turned = half_pi * Wide::of(static_cast<uint64_t>(quarters), 0),
               rest = x < turned ? turned - x : x - turned;
    const uint32_t entry = (rest.limb[6] + (1U << 27)) >> 28;
    const Wide place = Wide::of(entry, -4);
    const bool before = rest < place;
    const Wide h = before ? place - rest : rest - place, square = h * h;
    Wide sin_sum = one, cos_sum = one;
    for (uint32_t n = 28; n >= 2; n -= 2) {
        sin_sum = one - square * sin_sum / (n * (n + 1));
        cos_sum = one - square * cos_sum / (n * (n - 1));
    }
    sin_sum = h * sin_sum;
    const auto& [sin, cos] = table.all[entry];
    if (before) return {sin * cos_sum - cos * sin_sum, cos * cos_sum + sin * sin_sum};
    return {sin * cos_sum + cos * sin_sum, cos * cos_sum - sin * sin_sum};
}

SinCos sin_cos(double x) {
    const double size = std::fabs(x);
    if (!(size <= largest_angle)) return {nan, nan};
    if (size < smallest_angle) return {x, 1};
    const Angle angle(size);
    const ApproximateSinCos first = approximate_sin_cos(angle);
    const double sin = rounded(first.sin, 68, [&](Parts middle) { return middle.wide() < angle.exact().sin; });
    const double cos = rounded(first.cos, 68, [&](Parts middle) { return middle.wide() < angle.exact().cos; });
    const bool exchange = angle.exchanged();
    return {negated_if(exchange ? cos : sin, angle.sin_negative() != (x < 0)),
            negated_if(exchange ? sin : cos, angle.cos_negative())};
}

double tan(double x) {
    const double size = std::fabs(x);
    if (!(size <= largest_angle)) return nan;
    if (size < smallest_angle) return x;
    const Angle angle(size);
    const ApproximateSinCos first = approximate_sin_cos(angle);
    const bool exchange = angle.exchanged();
    const Approximation above = normalized(exchange ? first.cos : first.sin);
    const Approximation below = normalized(exchange ? first.sin : first.cos);
    // A quotient in double, and its remainder.
    const double divisor = to_double(below.fraction), quotient = to_double(above.fraction) / divisor;
    const Parts q = parts_of(quotient);
    const U128 whole = product(below.fraction.high, q.integer) + U128{0, high_product(below.fraction.low, q.integer)};
    const U128 left = above.fraction - (whole << (64 + q.exponent)), negated = U128{} - left;
    const double change = (left < negated ? to_double(left) : -to_double(negated)) / divisor;
    Approximation result = sum(quotient, change);
    result.exponent += above.exponent - below.exponent;
    const double tangent = rounded(result, 67, [&](Parts middle) {
        const wide::SinCos second = angle.exact();
        const Wide& dividend = exchange ? second.cos : second.sin;
        const Wide product = (exchange ? second.sin : second.cos) * Wide::of(middle.integer, -54);
        const int exponent = middle.exponent + 54;  // so that the larger side stays below 2
        return exponent < 0 ? product < scaled(dividend, -exponent) : scaled(product, exponent) < dividend;
    });
    return negated_if(tangent, (angle.sin_negative() != angle.cos_negative()) != (x < 0));
}

}  // namespace gphys

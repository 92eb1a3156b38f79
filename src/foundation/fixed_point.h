// Unsigned fixed-point numbers of 128 and 256 bits. Integer arithmetic gives the same bits on every machine, in every
// rounding mode, and with every treatment of floating-point expressions by the compiler.
#pragma once

#include <cstdint>

#include "foundation/compiler.h"

namespace gphys {

/// An integer modulo 2^128; as a fraction its last bit is 2^-128.
struct U128 {
    uint64_t high = 0, low = 0;
};

constexpr U128 operator+(U128 a, U128 b) {
    const uint64_t low = a.low + b.low;
    return {a.high + b.high + (low < b.low), low};
}
constexpr U128 operator-(U128 a, U128 b) { return {a.high - b.high - (a.low < b.low), a.low - b.low}; }
constexpr bool operator<(U128 a, U128 b) { return a.high < b.high || (a.high == b.high && a.low < b.low); }
/// For 0 <= n < 128.
constexpr U128 operator<<(U128 a, int n) {
    if (n >= 64) return {a.low << (n - 64), 0};
    return {a.high << n | a.low >> 1 >> (63 - n), a.low << n};
}
constexpr U128 operator>>(U128 a, int n) {
    if (n >= 64) return {0, a.high >> (n - 64)};
    return {a.high >> n, a.low >> n | a.high << 1 << (63 - n)};
}
inline double to_double(U128 a) { return static_cast<double>(a.high) * 0x1p64 + static_cast<double>(a.low); }

/// a b, from products of 32 bits.
constexpr U128 product_by_halves(uint64_t a, uint64_t b) {
    const uint64_t a0 = a & 0xffffffff, a1 = a >> 32, b0 = b & 0xffffffff, b1 = b >> 32;
    const uint64_t inner = a1 * b0 + (a0 * b0 >> 32), middle = a0 * b1 + (inner & 0xffffffff);
    return {a1 * b1 + (inner >> 32) + (middle >> 32), a * b};
}
constexpr U128 product(uint64_t a, uint64_t b) {
#if GPHYS_HAS_INT128
    const UInt128 ab = static_cast<UInt128>(a) * b;
    return {static_cast<uint64_t>(ab >> 64), static_cast<uint64_t>(ab)};
#else
    return product_by_halves(a, b);
#endif
}
/// a b / 2^64, rounded down.
constexpr uint64_t high_product(uint64_t a, uint64_t b) { return product(a, b).high; }
/// a b / 2^128, too small by less than 3.
constexpr U128 high_product(U128 a, U128 b) {
    return product(a.high, b.high) + U128{0, high_product(a.high, b.low)} + U128{0, high_product(a.low, b.high)};
}

/// 32 integer and 224 fractional bits, least significant word first.
struct Wide {
    uint32_t limb[8] = {};

    /// integer 2^exponent. Bits that do not fit are dropped.
    static constexpr Wide of(uint64_t integer, int exponent) {
        Wide wide;
        const int place = exponent + 224, shift = place & 31, first = (place - shift) / 32;
        const uint64_t parts[3] = {integer << shift & 0xffffffff, (integer << shift) >> 32,
                                   shift == 0 ? 0 : integer >> (64 - shift)};
        for (int i = 0; i < 3; ++i) {
            if (first + i >= 0 && first + i < 8) wide.limb[first + i] = static_cast<uint32_t>(parts[i]);
        }
        return wide;
    }
    /// The fractional part, rounded down to 128 bits.
    constexpr U128 fraction() const { return {uint64_t{limb[6]} << 32 | limb[5], uint64_t{limb[4]} << 32 | limb[3]}; }
};

constexpr Wide operator+(const Wide& a, const Wide& b) {
    Wide sum;
    uint64_t carry = 0;
    for (int i = 0; i < 8; ++i) {
        carry += uint64_t{a.limb[i]} + b.limb[i];
        sum.limb[i] = static_cast<uint32_t>(carry);
        carry >>= 32;
    }
    return sum;
}
constexpr Wide operator-(const Wide& a, const Wide& b) {
    Wide difference;
    uint64_t borrow = 0;
    for (int i = 0; i < 8; ++i) {
        const uint64_t limb = uint64_t{a.limb[i]} - b.limb[i] - borrow;
        difference.limb[i] = static_cast<uint32_t>(limb);
        borrow = limb >> 63;
    }
    return difference;
}
constexpr bool operator<(const Wide& a, const Wide& b) {
    for (int i = 7; i > 0; --i) {
        if (a.limb[i] != b.limb[i]) return a.limb[i] < b.limb[i];
    }
    return a.limb[0] < b.limb[0];
}
/// Rounded down. The product is below 2^32.
constexpr Wide operator*(const Wide& a, const Wide& b) {
    uint32_t all[16] = {};
    for (int i = 0; i < 8; ++i) {
        uint64_t carry = 0;
        for (int j = 0; j < 8; ++j) {
            carry += uint64_t{a.limb[i]} * b.limb[j] + all[i + j];
            all[i + j] = static_cast<uint32_t>(carry);
            carry >>= 32;
        }
        all[i + 8] = static_cast<uint32_t>(carry);
    }
    Wide product;
    for (int i = 0; i < 8; ++i) product.limb[i] = all[i + 7];
    return product;
}
/// Rounded down.
constexpr Wide operator/(const Wide& a, uint32_t divisor) {
    Wide quotient;
    uint64_t rest = 0;
    for (int i = 7; i >= 0; --i) {
        rest = rest << 32 | a.limb[i];
        quotient.limb[i] = static_cast<uint32_t>(rest / divisor);
        rest %= divisor;
    }
    return quotient;
}
/// a 2^n. Bits that do not fit are dropped.
constexpr Wide scaled(const Wide& a, int n) {
    Wide result;
    const int shift = n & 31, limbs = (n - shift) / 32;
    for (int i = 0; i < 8; ++i) {
        const int from = i - limbs;
        const uint64_t here = from >= 0 && from < 8 ? a.limb[from] : 0,
                       below = from >= 1 && from < 9 ? a.limb[from - 1] : 0;
        result.limb[i] = static_cast<uint32_t>((here << 32 | below) << shift >> 32);
    }
    return result;
}

}  // namespace gphys

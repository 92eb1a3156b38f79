// Vectors of three numbers of any type: doubles, numbers of exact arithmetic (exact.h), or SIMD registers (simd.h,
// simd_double.h), which hold one vector per lane.
//
// Everything is inlined: kernels (isa.h) define nothing outside of their own namespace, and calls would pass registers
// through memory.
#pragma once

#include <cstdint>

#include "foundation/numbers.h"

namespace gphys {

/// The unevaluated sum of a rounded value and its rounding error (exact.h).
template <class N>
N two_terms(double value, double rest);

template <class N>
struct Vec {
    N x{}, y{}, z{};

    // From doubles, for predicates (exact.h): v, a - b and v + rest, exact if N is.
    static Vec of(const Vec<double>& v) { return {N(v.x), N(v.y), N(v.z)}; }
    static Vec difference(const Vec<double>& a, const Vec<double>& b) {
        return {N(a.x) - N(b.x), N(a.y) - N(b.y), N(a.z) - N(b.z)};
    }
    static Vec two_terms(const Vec<double>& v, const Vec<double>& rest) {
        return {gphys::two_terms<N>(v.x, rest.x), gphys::two_terms<N>(v.y, rest.y), gphys::two_terms<N>(v.z, rest.z)};
    }

    // Not (&x)[axis], which is undefined behaviour and was miscompiled. Reading from a copy needs no branch.
    GPHYS_INLINE constexpr N operator[](int axis) const {
        const N all[] = {x, y, z};
        return all[axis];
    }
    GPHYS_INLINE constexpr N& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// N in a non-deduced context, so that numbers are converted to the type of the vector beside them.
template <class N>
struct SameAs {
    using Number = N;
};
template <class N>
using Same = typename SameAs<N>::Number;

template <class N>
GPHYS_INLINE constexpr Vec<N> operator+(const Vec<N>& a, const Vec<N>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> operator-(const Vec<N>& a, const Vec<N>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> operator-(const Vec<N>& a) {
    return {-a.x, -a.y, -a.z};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> operator*(const Vec<N>& a, const Same<N>& s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> operator*(const Same<N>& s, const Vec<N>& a) {
    return a * s;
}
template <class N>
GPHYS_INLINE constexpr Vec<N> operator/(const Vec<N>& a, const Same<N>& s) {
    return {a.x / s, a.y / s, a.z / s};
}
template <class N>
GPHYS_INLINE constexpr Vec<N>& operator+=(Vec<N>& a, const Vec<N>& b) {
    return a = a + b;
}
template <class N>
GPHYS_INLINE constexpr Vec<N>& operator-=(Vec<N>& a, const Vec<N>& b) {
    return a = a - b;
}
template <class N>
GPHYS_INLINE constexpr Vec<N>& operator*=(Vec<N>& a, const Same<N>& s) {
    return a = a * s;
}
template <class N>
GPHYS_INLINE constexpr bool operator==(const Vec<N>& a, const Vec<N>& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}
template <class N>
GPHYS_INLINE constexpr bool operator!=(const Vec<N>& a, const Vec<N>& b) {
    return !(a == b);
}

template <class N>
GPHYS_INLINE constexpr N dot(const Vec<N>& a, const Vec<N>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
GPHYS_INLINE constexpr Vec<N> cross(const Vec<N>& a, const Vec<N>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
GPHYS_INLINE constexpr N length_squared(const Vec<N>& a) {
    return dot(a, a);
}
template <class N>
GPHYS_INLINE N length(const Vec<N>& a) {
    return square_root(dot(a, a));
}
template <class N>
GPHYS_INLINE N distance(const Vec<N>& a, const Vec<N>& b) {
    return length(a - b);
}

// Component by component. Of equal components, such as zeros of either sign, that of a.
template <class N>
GPHYS_INLINE Vec<N> abs(const Vec<N>& a) {
    return {absolute(a.x), absolute(a.y), absolute(a.z)};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> by_component(const Vec<N>& a, const Vec<N>& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> quotients(const Vec<N>& a, const Vec<N>& b) {
    return {a.x / b.x, a.y / b.y, a.z / b.z};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> quotients(const Same<N>& s, const Vec<N>& a) {
    return {s / a.x, s / a.y, s / a.z};
}
/// The magnitudes of a with the signs of another vector.
template <class N>
GPHYS_INLINE Vec<N> with_signs(const Vec<N>& a, const Vec<N>& sign) {
    return {with_sign(a.x, sign.x), with_sign(a.y, sign.y), with_sign(a.z, sign.z)};
}
template <class N>
GPHYS_INLINE Vec<N> rounded_to_float(const Vec<N>& a) {
    return {rounded_to_float(a.x), rounded_to_float(a.y), rounded_to_float(a.z)};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> plus(const Vec<N>& a, const Same<N>& b) {
    return {a.x + b, a.y + b, a.z + b};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> minus(const Vec<N>& a, const Same<N>& b) {
    return {a.x - b, a.y - b, a.z - b};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> at_least(const Vec<N>& a, const Same<N>& b) {
    return {largest(a.x, b), largest(a.y, b), largest(a.z, b)};
}
/// Where it is positive, else 0.
template <class N>
GPHYS_INLINE constexpr Vec<N> positive(const Vec<N>& a) {
    const N zero{};
    return {largest(a.x, zero), largest(a.y, zero), largest(a.z, zero)};
}
/// The vector with its sign flipped on the axes along which the direction is not negative.
template <class N>
GPHYS_INLINE constexpr Vec<N> against(const Vec<N>& a, const Vec<N>& direction) {
    const N zero{};
    return {select(zero <= direction.x, zero - a.x, a.x), select(zero <= direction.y, zero - a.y, a.y),
            select(zero <= direction.z, zero - a.z, a.z)};
}
/// Whether it holds on all axes.
template <class N>
GPHYS_INLINE constexpr auto at_most(const Vec<N>& a, const Vec<N>& b) {
    return (a.x <= b.x) & (a.y <= b.y) & (a.z <= b.z);
}
template <class Mask>
GPHYS_INLINE constexpr Mask all_axes(const Mask& mask) {
    return mask;
}
template <class N>
GPHYS_INLINE constexpr Vec<N> min(const Vec<N>& a, const Vec<N>& b) {
    return {least(b.x, a.x), least(b.y, a.y), least(b.z, a.z)};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> max(const Vec<N>& a, const Vec<N>& b) {
    return {largest(a.x, b.x), largest(a.y, b.y), largest(a.z, b.z)};
}
template <class Mask, class N>
GPHYS_INLINE constexpr Vec<N> select(const Mask& mask, const Vec<N>& a, const Vec<N>& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

/// y, z, x; and z, x, y.
template <class N>
GPHYS_INLINE constexpr Vec<N> yzx(const Vec<N>& a) {
    return {a.y, a.z, a.x};
}
template <class N>
GPHYS_INLINE constexpr Vec<N> zxy(const Vec<N>& a) {
    return {a.z, a.x, a.y};
}

template <class N>
GPHYS_INLINE constexpr N sum(const Vec<N>& a) {
    return a.x + a.y + a.z;
}
template <class N>
GPHYS_INLINE constexpr N max_component(const Vec<N>& a) {
    return largest(a.x, largest(a.y, a.z));
}

/// a / |a|; a must not be zero. Scaled first, so that lengths from 1e-300 to 1e300 survive.
template <class N>
GPHYS_INLINE Vec<N> normalized(const Vec<N>& a) {
    const Vec<N> scaled = a / max_component(abs(a));
    return scaled / length(scaled);
}

/// Of a vector of doubles: as floats, as it is, and bit k, whether component k has a minus sign.
GPHYS_INLINE void store_narrowed(float (&to)[4], const Vec<double>& a) {
    to[0] = static_cast<float>(a.x);
    to[1] = static_cast<float>(a.y);
    to[2] = static_cast<float>(a.z);
}
GPHYS_INLINE void store(double (&to)[4], const Vec<double>& a) {
    to[0] = a.x;
    to[1] = a.y;
    to[2] = a.z;
}
GPHYS_INLINE uint32_t signs_of(const Vec<double>& a) {
    return uint32_t{std::signbit(a.x)} | uint32_t{std::signbit(a.y)} << 1 | uint32_t{std::signbit(a.z)} << 2;
}

}  // namespace gphys

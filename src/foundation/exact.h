// Exact signs of polynomials: adaptive predicates (Shewchuk 1997). A predicate is written once, as a generic lambda
// over its number type. sign_of evaluates it in double with a running error bound. Only if the bound includes zero, it
// evaluates it again with expansions, which are exact.
//
// Domain: every float32 is a multiple of 2^-149, so a product of k of them is a multiple of 2^(-149 k). A double
// represents that without underflow for k <= 7; the largest is 1e15^7. All predicates of this library have degree 6 or
// less. For double inputs (shapes placed by a transform) the same holds as long as products stay above 2^-1022 / 2^-53
// = 1e-291.
#pragma once

#include "foundation/math.h"

namespace gphys {

/// A double and a bound on its distance from the exact value.
struct Bounded {
    double value = 0, error = 0;

    Bounded() = default;
    Bounded(double exact) : value(exact) {}
    Bounded(double v, double e) : value(v), error(e) {}

    bool certain() const { return std::fabs(value) > error || error == 0; }
    int sign() const { return value > 0 ? 1 : value < 0 ? -1 : 0; }
};

// A result has an error of half an ulp, 2^-53 of it. The bound adds twice that, which also covers its own rounding.
constexpr double rounding = 0x1p-52;

inline Bounded operator+(Bounded a, Bounded b) {
    const double v = a.value + b.value;
    return {v, a.error + b.error + rounding * std::fabs(v)};
}
inline Bounded operator-(Bounded a) { return {-a.value, a.error}; }
inline Bounded operator-(Bounded a, Bounded b) { return a + -b; }
inline Bounded operator*(Bounded a, Bounded b) {
    const double v = a.value * b.value;
    return {v,
            std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error + rounding * std::fabs(v)};
}
inline Bounded abs(Bounded a) { return {std::fabs(a.value), a.error}; }

/// An unevaluated sum of doubles, each at most half an ulp of the one before: an exact number.
class Exact {
public:
    Exact() = default;
    Exact(double value) {
        if (value != 0) term_[size_++] = value;
    }

    /// The first term exceeds the sum of all others, so it has the sign and, to 2^-52, the value.
    int sign() const { return size_ == 0 ? 0 : term_[0] > 0 ? 1 : -1; }
    double value() const { return size_ == 0 ? 0 : term_[0]; }

    friend Exact operator+(const Exact& a, const Exact& b);
    friend Exact operator-(const Exact& a);
    friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
    friend Exact operator*(const Exact& a, const Exact& b);
    friend Exact operator*(double a, const Exact& b);
    friend Exact abs(const Exact& a) { return a.sign() < 0 ? -a : a; }

private:
    friend class Accumulator;
    // Each term has an exponent at least 53 below that of the previous one, and the exponents of doubles span 2098. So
    // there are never more than 40 terms.
    static constexpr int capacity = 41;
    int size_ = 0;
    double term_[capacity];  // largest first
};

/// Sign of polynomial(Number()): a lambda of the form [&](auto number) { using N = ...; }.
template <class Polynomial>
int sign_of(const Polynomial& polynomial) {
    const Bounded quick = polynomial(Bounded());
    return quick.certain() ? quick.sign() : polynomial(Exact()).sign();
}

/// Its value with the exact sign and a relative error below 2^-44.
template <class Polynomial>
double value_of(const Polynomial& polynomial) {
    const Bounded quick = polynomial(Bounded());
    return quick.error <= 0x1p-45 * std::fabs(quick.value) ? quick.value : polynomial(Exact()).value();
}

// Parts of polynomials. An Exact takes 340 bytes, and a compiler keeps those of one formula side by side on the stack,
// so for Exact these are not inlined: long formulas made of them need few.

template <class N>
N difference_of(double a, double b) {
    return N(a) - N(b);
}
template <>
Exact difference_of(double a, double b);
/// a d - b c
template <class N>
N minor_of(double a, double b, double c, double d) {
    return N(a) * N(d) - N(b) * N(c);
}
template <>
Exact minor_of(double a, double b, double c, double d);
/// dot(a, cross(b, c))
template <class N>
N determinant_of(Vec3 a, Vec3 b, Vec3 c) {
    return a.x * minor_of<N>(b.y, b.z, c.y, c.z) + a.y * minor_of<N>(b.z, b.x, c.z, c.x) +
           a.z * minor_of<N>(b.x, b.y, c.x, c.y);
}
template <>
Exact determinant_of(Vec3 a, Vec3 b, Vec3 c);
template <class N>
N dot_of(Vec3 a, Vec3 b) {
    return a.x * N(b.x) + a.y * N(b.y) + a.z * N(b.z);
}
template <>
Exact dot_of(Vec3 a, Vec3 b);
/// dot(normal, point - origin)
template <class N>
N height_of(Vec3 normal, Vec3 point, Vec3 origin) {
    return normal.x * difference_of<N>(point.x, origin.x) + normal.y * difference_of<N>(point.y, origin.y) +
           normal.z * difference_of<N>(point.z, origin.z);
}
template <>
Exact height_of(Vec3 normal, Vec3 point, Vec3 origin);

/// a - b, rounded, and the rounding error: their sum is exact.
Vec3 difference(Vec3 a, Vec3 b, Vec3& rest);
/// Whether a - b is exact; out is a - b in any case.
bool difference_is_exact(Vec3 a, Vec3 b, Vec3& out);
/// The unevaluated sum of a rounded value and its rounding error.
template <class N>
N two_terms(double value, double rest);
template <>
inline double two_terms(double value, double) {
    return value;
}
template <>
inline Bounded two_terms(double value, double rest) {
    return {value, std::fabs(rest)};
}
template <>
inline Exact two_terms(double value, double rest) {
    return rest == 0 ? Exact(value) : Exact(value) + Exact(rest);
}

/// dot(a, cross(b, c)) with its exact sign and a relative error of 2^-52, in 128-bit integers: many times faster than
/// Exact. Returns false if the components of b and c along one axis, or those of a relative to them, span more than 41
/// bits, or if the compiler has no 128-bit integers.
bool integer_determinant(Vec3 a, Vec3 b, Vec3 c, double& out);

/// Sign of dot(cross(b - a, c - a), d - a): > 0 if d is on the side that the triangle's normal
/// points to, 0 if the four points lie in a plane.
int orientation(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
/// Sign of component `axis` of cross(b - a, c - a): the orientation of a, b, c in the projection along that axis.
int orientation(Vec3 a, Vec3 b, Vec3 c, int axis);
/// An axis along which the projection of the three points is not collinear; -1 if they are collinear.
int turning_axis(Vec3 a, Vec3 b, Vec3 c);
/// cross(b - a, d - c) with a relative error below 2^-44 in each component, in spite of cancellation.
Vec3 accurate_cross(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

}  // namespace gphys

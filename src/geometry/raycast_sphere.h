// Ray and sphere, over any type of number. `from` is the origin of the ray relative to the centre.
#pragma once

#include "foundation/vec.h"

namespace gphys {

/// The crossings of a line and a round surface solve a t^2 - 2 b t + c = 0, with c > 0 outside. The discriminant b^2 -
/// a c is `stretch` times a number computed from cross products (Lagrange's identity). It stays accurate far from the
/// origin, where b^2 and a c would cancel.
template <class N>
struct Quadratic {
    N a, b, c, discriminant, stretch;
};

/// Error bounds of a Quadratic of doubles. Let u = 2^-53, and let vectors p and q have e and f roundings. A component
/// of their cross product has an error of at most (2 + e + f) u |p| |q|, the vector sqrt(3) times that, and the dot
/// product (3 + e + f) u |p| |q|. The factors are rounded up to cover the terms in u^2. The direction of a ray has one
/// rounding if its rest is not zero.
template <class N>
struct QuadraticError {
    N b, c, discriminant;
};

template <class N>
GPHYS_INLINE Quadratic<N> sphere_quadratic(const Vec<N>& from, const Vec<N>& direction, const N& radius) {
    const Vec<N> moment = cross(from, direction);
    const N a = dot(direction, direction), radius_squared = radius * radius;
    return {a, -dot(from, direction), dot(from, from) - radius_squared, radius_squared * a - dot(moment, moment),
            N(1.0)};
}
template <class N>
GPHYS_INLINE QuadraticError<N> sphere_error(const Vec<N>& from, const Vec<N>& direction, const N& radius,
                                            const Quadratic<N>& q) {
    constexpr double unit = 0x1p-53;
    const N reach = sum(abs(from)), rr = radius * radius;  // at least the length, at most sqrt(3) times that
    // Error of the moment: 4 sqrt(3) u |from| |d| =: e; of its square: (2 |moment| + e) e, and that of its own sum.
    const N product = reach * sum(abs(direction)), e = 7 * unit * product;
    const N moment = square_root(largest(rr * q.a - q.discriminant, 0.0));
    return {6 * unit * product, unit * (6 * reach * reach + 3 * rr),
            (2 * moment + e) * e + 4 * unit * moment * moment + 9 * unit * rr * q.a};
}

/// The first root is c / way with way = b + sqrt(stretch) root, a sum of numbers of one sign (Haines, Guenther,
/// Akenine-Moeller 2019). Returns whether its relative error is at most 2^-28, 1/16 of that of rounding to float. The
/// error of the root is error / (2 root).
template <class N>
GPHYS_INLINE auto is_accurate(const Quadratic<N>& q, const QuadraticError<N>& error, const N& stretch_root,
                              const N& root, const N& way) {
    return (error.discriminant < q.discriminant) & (error.c <= 0x1p-30 * q.c) & (error.b <= 0x1p-30 * way) &
           (stretch_root * error.discriminant <= 0x1p-29 * root * way);
}

/// The point of a ray that ends at `end` which is closest to the centre, relative to the centre; for conservative
/// tests. `squared` is the squared length of the direction, or any number above 0 if that is 0.
///
/// Let u be the unit roundoff, s the sum of the coordinates of `from`, e their error. If the largest component of the
/// direction is 1, the error of the distance to the closest point is 10 u s + 3 e, and that of the point on each axis
/// is 15 u s + 4 e.
template <class N>
GPHYS_INLINE Vec<N> closest_on_ray(const Vec<N>& from, const Vec<N>& direction, const N& squared, const N& end) {
    const N zero{};
    return from + direction * least(end, largest((zero - dot(from, direction)) / squared, zero));
}

}  // namespace gphys

// Where a ray meets a sphere. `from` is the origin of the ray as seen from the centre.
#pragma once

#include "foundation/vec.h"

namespace gphys {

/// The times at which a line crosses a round surface solve a t^2 - 2 b t + c = 0; c > 0 outside. The
/// discriminant b^2 - a c is `stretch` times a number that comes from cross products, which lose
/// little however far the origin is, while b^2 and a c would cancel (Lagrange's identity).
template <class N>
struct Quadratic {
    N a, b, c, discriminant, stretch;
};

/// How far the numbers of a Quadratic of doubles are off at most. With u = 2^-53, a component of a cross
/// product of vectors p and q that carry e and f roundings is off by at most (2 + e + f) u |p| |q|, the
/// whole vector by sqrt(3) of that; a dot product by (3 + e + f) u |p| |q|. Terms in u^2 are paid for
/// by rounding the factors up. The direction of a ray carries one rounding if it has a rest.
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
    const N reach = sum(abs(from)), rr = radius * radius;  // at least the length, and no more than sqrt(3) times that
    // moment: off by 4 sqrt(3) u |from| |d| =: e; its square by (2 |moment| + e) e, and its own sum.
    const N product = reach * sum(abs(direction)), e = 7 * unit * product;
    const N moment = square_root(largest(rr * q.a - q.discriminant, 0.0));
    return {6 * unit * product, unit * (6 * reach * reach + 3 * rr),
            (2 * moment + e) * e + 4 * unit * moment * moment + 9 * unit * rr * q.a};
}

/// The first root is c / way with way = b + sqrt(stretch) root, which adds numbers of one sign (Haines, Guenther,
/// Akenine-Moeller 2019). Whether it is within 2^-28 of itself, 1/16 of what rounding it to a float costs: the error
/// of the root is error / (2 root).
template <class N>
GPHYS_INLINE auto is_accurate(const Quadratic<N>& q, const QuadraticError<N>& error, const N& stretch_root,
                              const N& root, const N& way) {
    return (error.discriminant < q.discriminant) & (error.c <= 0x1p-30 * q.c) & (error.b <= 0x1p-30 * way) &
           (stretch_root * error.discriminant <= 0x1p-29 * root * way);
}

/// The point of a ray that ends at `end` which is closest to the centre, seen from there; for conservative tests.
/// Little is lost far away. `squared` is that of the direction, or any number above 0 if this is 0.
///
/// Let u be the unit of rounding, and s the sum of the coordinates of `from`. With a direction of largest component
/// 1, the way to the closest point is off by 10 u s and three times what these coordinates are off by; the point
/// itself on each axis by that, by 5 u s, and once more by the coordinates.
template <class N>
GPHYS_INLINE Vec<N> closest_on_ray(const Vec<N>& from, const Vec<N>& direction, const N& squared, const N& end) {
    const N zero{};
    return from + direction * least(end, largest((zero - dot(from, direction)) / squared, zero));
}

}  // namespace gphys

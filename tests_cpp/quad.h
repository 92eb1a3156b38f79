// 113 bits of precision for references written plainly. Sums of products of three coordinates that
// are multiples of 2^-20 below 2^14 (34 bits each) are exact in it.
#pragma once

#include "shapes/shapes.h"

namespace test {

__extension__ typedef __float128 Quad;

inline Quad absolute(Quad v) { return v < 0 ? -v : v; }
/// Newton's method doubles the 53 bits of the start twice.
inline Quad square_root(Quad v) {
    if (v <= 0) return 0;
    Quad root = std::sqrt(static_cast<double>(v));
    if (root == 0) return 0;
    for (int i = 0; i < 2; ++i) root = (root + v / root) / 2;
    return root;
}

struct QVec3 {
    Quad x, y, z;
    QVec3(Quad x_, Quad y_, Quad z_) : x(x_), y(y_), z(z_) {}
    QVec3(gphys::Vec3 v) : x(v.x), y(v.y), z(v.z) {}
    Quad operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
inline QVec3 operator+(QVec3 a, QVec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline QVec3 operator-(QVec3 a, QVec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline QVec3 operator*(QVec3 a, Quad s) { return {a.x * s, a.y * s, a.z * s}; }
inline Quad dot(QVec3 a, QVec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline QVec3 cross(QVec3 a, QVec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Quad length(QVec3 a) { return square_root(dot(a, a)); }
inline bool is_zero(QVec3 a) { return a.x == 0 && a.y == 0 && a.z == 0; }

/// The error of a computed value in units in the last place of the float nearest to the truth.
inline double float_ulps(double computed, Quad truth) {
    const float nearest = std::fabs(static_cast<float>(truth));
    const float ulp = std::nextafterf(nearest, std::numeric_limits<float>::infinity()) - nearest;
    return static_cast<double>(absolute(Quad(computed) - truth) / Quad(ulp));
}

}  // namespace test

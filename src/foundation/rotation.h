// Rotations as quaternions and as matrices, templates over the type of number (vec.h).
#pragma once

#include "foundation/vec.h"

namespace gphys {

template <class N>
struct Quaternion {
    N x{}, y{}, z{}, w{1};
};

template <class N>
GPHYS_INLINE constexpr N norm_squared(const Quaternion<N>& q) {
    return q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
}

/// Columns are the images of the x, y and z axes.
template <class N>
struct Matrix {
    Vec<N> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

template <class N>
GPHYS_INLINE constexpr Vec<N> operator*(const Matrix<N>& m, const Vec<N>& v) {
    return m.x * v.x + m.y * v.y + m.z * v.z;
}
template <class N>
GPHYS_INLINE constexpr Matrix<N> operator*(const Matrix<N>& a, const Matrix<N>& b) {
    return {a * b.x, a * b.y, a * b.z};
}
/// Transpose of m times v: the inverse rotation.
template <class N>
GPHYS_INLINE constexpr Vec<N> transpose_times(const Matrix<N>& m, const Vec<N>& v) {
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
template <class N>
GPHYS_INLINE constexpr Matrix<N> transposed(const Matrix<N>& m) {
    return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
template <class N>
GPHYS_INLINE Matrix<N> abs(const Matrix<N>& m) {
    return {abs(m.x), abs(m.y), abs(m.z)};
}

/// The matrix with this diagonal and the off-diagonal elements of the rotation by q; p is a multiple of q.
template <class N>
GPHYS_INLINE constexpr Matrix<N> matrix_of(const Quaternion<N>& q, const Quaternion<N>& p, const Vec<N>& diagonal) {
    const N xy = p.x * q.y, xz = p.x * q.z, yz = p.y * q.z;
    const N wx = p.w * q.x, wy = p.w * q.y, wz = p.w * q.z;
    return {{diagonal.x, xy + wz, xz - wy}, {xy - wz, diagonal.y, yz + wx}, {xz + wy, yz - wx, diagonal.z}};
}
/// The rotation by q, which need not be of unit length.
template <class N>
GPHYS_INLINE constexpr Matrix<N> rotation_matrix(const Quaternion<N>& q) {
    const N s = 2.0 / norm_squared(q);
    const Quaternion<N> p{s * q.x, s * q.y, s * q.z, s * q.w};
    const N xx = p.x * q.x, yy = p.y * q.y, zz = p.z * q.z;
    return matrix_of(q, p, {1.0 - yy - zz, 1.0 - xx - zz, 1.0 - xx - yy});
}
/// |q|^2 times that, without a division.
template <class N>
GPHYS_INLINE constexpr Matrix<N> scaled_rotation_matrix(const Quaternion<N>& q) {
    const Quaternion<N> p{q.x + q.x, q.y + q.y, q.z + q.z, q.w + q.w};
    const N xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, ww = q.w * q.w;
    return matrix_of(q, p, {ww + xx - yy - zz, ww - xx + yy - zz, ww - xx - yy + zz});
}

}  // namespace gphys

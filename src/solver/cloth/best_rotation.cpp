// The best rotation as a quaternion: the eigenvector of the largest eigenvalue of a symmetric 4 x 4 matrix (Horn 1987,
// "Closed-form solution of absolute orientation using unit quaternions"). Jacobi's method finds all eigenvectors,
// whatever the multiplicity of the eigenvalues. So points in a plane or on a line, and mirrored ones, need no special
// case, and the result depends on the points alone: no state is carried from substep to substep.
#include "solver/cloth/best_rotation.h"

#include <array>

namespace gphys {
namespace {

using Mat4 = std::array<std::array<double, 4>, 4>;

/// Horn's matrix, for quaternions w, x, y, z.
Mat4 quaternion_matrix(const Mat3& m) {
    const Vec3 turned{m.y.z - m.z.y, m.z.x - m.x.z, m.x.y - m.y.x};
    const double xy = m.x.y + m.y.x, yz = m.y.z + m.z.y, zx = m.z.x + m.x.z;
    return {{{m.x.x + m.y.y + m.z.z, turned.x, turned.y, turned.z},
             {turned.x, m.x.x - m.y.y - m.z.z, xy, zx},
             {turned.y, xy, m.y.y - m.x.x - m.z.z, yz},
             {turned.z, zx, yz, m.z.z - m.x.x - m.y.y}}};
}

/// The rotation of the plane (i, j) that makes a[i][j] zero, applied to the matrix and to the eigenvectors in `v`.
void rotate(Mat4& a, Mat4& v, size_t i, size_t j) {
    const double theta = (a[j][j] - a[i][i]) / (2 * a[i][j]);
    const double t = std::copysign(1, theta) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
    const auto turn = [&](double& x, double& y) {
        const double before = x;
        x = c * before - s * y;
        y = s * before + c * y;
    };
    for (size_t k = 0; k < 4; ++k) turn(a[k][i], a[k][j]);
    for (size_t k = 0; k < 4; ++k) turn(a[i][k], a[j][k]);
    for (size_t k = 0; k < 4; ++k) turn(v[k][i], v[k][j]);
    a[i][j] = a[j][i] = 0;
}

}  // namespace

Mat3 best_rotation(const Mat3& covariance) {
    // Convergence is quadratic: five or six sweeps reach the rounding of doubles.
    constexpr int most_sweeps = 12;
    constexpr double rounding = 1e-16;  // relative to the largest element
    const double largest = std::max(
        {max_component(abs(covariance.x)), max_component(abs(covariance.y)), max_component(abs(covariance.z))});
    if (!(largest > 0 && largest < infinity)) return {};
    Mat4 a = quaternion_matrix({covariance.x / largest, covariance.y / largest, covariance.z / largest});
    Mat4 v = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double left = 0;
        for (size_t i = 0; i < 4; ++i) {
            for (size_t j = i + 1; j < 4; ++j) {
                left = std::max(left, std::fabs(a[i][j]));
                if (std::fabs(a[i][j]) > rounding) rotate(a, v, i, j);
            }
        }
        if (left <= rounding) break;
    }
    size_t best = 0;
    for (size_t k = 1; k < 4; ++k) {
        if (a[k][k] > a[best][best]) best = k;
    }
    return rotation_matrix(Quat{v[1][best], v[2][best], v[3][best], v[0][best]});
}

}  // namespace gphys

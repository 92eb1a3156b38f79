// Clip space (clip_space.h): the inverse of a 4x4 matrix, and its clip planes.
#include "camera/clip_space.h"

namespace gphys {

Vec4 operator*(const Mat4& m, Vec4 v) {
    double out[4];
    for (int row = 0; row < 4; ++row) out[row] = m(row, 0) * v.x + m(row, 1) * v.y + m(row, 2) * v.z + m(row, 3) * v.w;
    return {out[0], out[1], out[2], out[3]};
}

Mat4 operator*(const Mat4& a, const Mat4& b) {
    Mat4 product;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            for (int k = 0; k < 4; ++k) product(row, column) += a(row, k) * b(k, column);
        }
    }
    return product;
}

Mat4 widen(const gphys_mat4& matrix) {
    Mat4 out;
    std::copy(matrix.m, matrix.m + 16, out.m);
    return out;
}

gphys_mat4 narrow(const Mat4& matrix) {
    gphys_mat4 out;
    std::transform(matrix.m, matrix.m + 16, out.m, [](double element) { return static_cast<float>(element); });
    return out;
}

double orthonormality(const Mat4& matrix) {
    double error = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
            double product = i == j ? -1 : 0;
            for (int row = 0; row < 3; ++row) product += matrix(row, i) * matrix(row, j);
            error = std::max(error, std::fabs(product));
        }
    }
    return error;
}

namespace {

/// The power of two that brings the largest of four magnitudes into 1..2; 0 if all are zero.
double scale_to_one(double a, double b, double c, double d) {
    const double largest = std::max(std::max(std::fabs(a), std::fabs(b)), std::max(std::fabs(c), std::fabs(d)));
    return largest > 0 ? std::ldexp(1.0, -std::ilogb(largest)) : 0;
}

}  // namespace

// Gauss-Jordan elimination with complete pivoting of [scaled matrix | identity]. Rows and columns are scaled by powers
// of two first, which rounds nothing. The rows of a projection have different units, and near = 1e-6 must not count as
// singular, as it would if |det| were compared with a constant.
//
// Smallest pivot: scaled elements are below 2, and complete pivoting lets those of a 4x4 matrix grow to at most four
// times that (Cryer 1968). Each of the three eliminations rounds a quotient, a product and a difference: an error of at
// most 3 * 3 * 2^3 * 2^-53 < 2^-46 in all. The pivot is the largest element that remains. If it is no larger than that
// error, all remaining elements may be rounding errors.
bool inverse(const Mat4& matrix, Mat4& out) {
    constexpr double smallest_pivot = 0x1p-46;
    double row_scale[4], column_scale[4];
    double a[4][8] = {};
    for (int row = 0; row < 4; ++row) {
        row_scale[row] = scale_to_one(matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3));
        for (int column = 0; column < 4; ++column) a[row][column] = matrix(row, column) * row_scale[row];
        a[row][4 + row] = 1;
    }
    for (int column = 0; column < 4; ++column) {
        column_scale[column] = scale_to_one(a[0][column], a[1][column], a[2][column], a[3][column]);
        for (int row = 0; row < 4; ++row) a[row][column] *= column_scale[column];
    }

    bool eliminated[4] = {};
    int column_of_row[4];
    for (int step = 0; step < 4; ++step) {
        int pivot_row = step, pivot_column = 0;
        double pivot = 0;
        for (int row = step; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) {
                if (eliminated[column] || std::fabs(a[row][column]) <= std::fabs(pivot)) continue;
                pivot = a[row][column];
                pivot_row = row;
                pivot_column = column;
            }
        }
        if (std::fabs(pivot) <= smallest_pivot) return false;
        std::swap(a[step], a[pivot_row]);
        eliminated[pivot_column] = true;
        column_of_row[step] = pivot_column;
        for (double& element : a[step]) element /= pivot;
        for (int row = 0; row < 4; ++row) {
            const double factor = a[row][pivot_column];
            if (row == step || factor == 0) continue;
            for (int column = 0; column < 8; ++column) a[row][column] -= factor * a[step][column];
        }
    }
    for (int step = 0; step < 4; ++step) {
        const int row = column_of_row[step];
        for (int column = 0; column < 4; ++column) {
            out(row, column) = column_scale[row] * a[step][4 + column] * row_scale[column];
        }
    }
    return true;
}

namespace {

/// The half space s * row(a) + t * row(b) >= 0 over homogeneous points.
Plane half_space(const Mat4& m, double s, int a, double t, int b) {
    const Vec3 normal{s * m(a, 0) + t * m(b, 0), s * m(a, 1) + t * m(b, 1), s * m(a, 2) + t * m(b, 2)};
    const double offset = s * m(a, 3) + t * m(b, 3);
    const double size = length(normal);
    if (size == 0) return {{}, offset >= 0 ? -1.0 : 1.0};
    return {normal / size, -offset / size};
}

}  // namespace

void clip_planes(const Mat4& to_clip, const DepthRange& depth_range, const Window& window, Plane out[6]) {
    const double rising = depth_range.near_depth < depth_range.far_depth ? 1 : -1;
    out[GPHYS_FRUSTUM_NEAR] = half_space(to_clip, rising, 2, -rising * depth_range.near_depth, 3);
    out[GPHYS_FRUSTUM_FAR] = half_space(to_clip, -rising, 2, rising * depth_range.far_depth, 3);
    out[GPHYS_FRUSTUM_LEFT] = half_space(to_clip, 1, 0, -window.left, 3);
    out[GPHYS_FRUSTUM_RIGHT] = half_space(to_clip, -1, 0, window.right, 3);
    out[GPHYS_FRUSTUM_BOTTOM] = half_space(to_clip, 1, 1, -window.bottom, 3);
    out[GPHYS_FRUSTUM_TOP] = half_space(to_clip, -1, 1, window.top, 3);
}

}  // namespace gphys

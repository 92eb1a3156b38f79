// Clip space: 4x4 matrices, the two depth conventions, and the clip planes of a matrix.
#pragma once

#include "shapes/shapes.h"

namespace gphys {

struct Vec4 {
    double x = 0, y = 0, z = 0, w = 0;
};

/// Element (row, column) is m[4 * column + row], as in gphys_mat4.
struct Mat4 {
    double m[16] = {};

    double operator()(int row, int column) const { return m[4 * column + row]; }
    double& operator()(int row, int column) { return m[4 * column + row]; }
};

Vec4 operator*(const Mat4& m, Vec4 v);
Mat4 operator*(const Mat4& a, const Mat4& b);
Mat4 widen(const gphys_mat4& matrix);
gphys_mat4 narrow(const Mat4& matrix);

/// The largest deviation of the dot products of its axes from those of orthonormal axes.
double orthonormality(const Mat4& matrix);

/// Returns false if the matrix is singular, or so close to singular that double precision does not decide.
bool inverse(const Mat4& matrix, Mat4& out);

/// Depth of the near and of the far plane in clip space: 0 and 1, -1 and 1, or reversed.
struct DepthRange {
    double near_depth, far_depth;

    DepthRange(gphys_depth_range range, bool reverse_z)
        : near_depth(range == GPHYS_DEPTH_ZERO_TO_ONE ? 0 : -1), far_depth(1) {
        if (reverse_z) std::swap(near_depth, far_depth);
    }
    gphys_depth_range range() const {
        return std::min(near_depth, far_depth) < 0 ? GPHYS_DEPTH_MINUS_ONE_TO_ONE : GPHYS_DEPTH_ZERO_TO_ONE;
    }
    bool is_reversed() const { return near_depth > far_depth; }

    /// 1 on the near plane, 0 on the far plane; the sum of both weights is 1. There are two formulas, not 1 - weight,
    /// so that the small one of the two keeps its relative accuracy. Reverse-Z relies on that.
    double near_weight(double depth) const { return (depth - far_depth) / (near_depth - far_depth); }
    double far_weight(double depth) const { return (depth - near_depth) / (far_depth - near_depth); }
    double depth(double near_weight, double far_weight) const {
        return near_depth * near_weight + far_depth * far_weight;
    }
};

/// A rectangle of the image in normalised device coordinates; by default all of it.
struct Window {
    double left = -1, right = 1, bottom = -1, top = 1;
};

/// The half spaces whose points the matrix takes into the window and between near and far depth,
/// in the order of gphys_frustum, with unit normals (Gribb and Hartmann 2001). A plane at infinity
/// gets normal 0 and distance -1 (every point is on its inner side) or 1 (none is).
void clip_planes(const Mat4& to_clip, const DepthRange& depth_range, const Window& window, Plane out[6]);

}  // namespace gphys

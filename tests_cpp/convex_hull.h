// A slow twin of every solid: its corners, edges and faces, and a radius around them.
// The gap of two of them is the largest gap along any unit axis (support functions), and the axis
// that shows it belongs to a pair of features: corner, edge or face of one and of the other. So
// trying all of those is an independent reference for overlap and distance.
#pragma once

#include <array>
#include <vector>

#include "geometry/intersect.h"
#include "test.h"

namespace test {

using gphys::Vec3;

struct Hull {
    std::vector<Vec3> corners;
    std::vector<std::array<int, 2>> edges;
    std::vector<std::array<int, 3>> faces;  // three corners of each face's plane
    double radius = 0;

    /// Corners numbered as gphys_frustum_corners does: near then far, each around.
    static Hull hexahedron(const Vec3 (&corner)[8]) {
        Hull hull;
        hull.corners.assign(corner, corner + 8);
        for (int i = 0; i < 4; ++i) {
            const int next = (i + 1) % 4;
            hull.edges.push_back({i, next});
            hull.edges.push_back({4 + i, 4 + next});
            hull.edges.push_back({i, 4 + i});
            hull.faces.push_back({i, next, 4 + i});
        }
        hull.faces.push_back({0, 1, 2});
        hull.faces.push_back({4, 5, 6});
        return hull;
    }
};

inline Hull hull(const gphys::Sphere& s) { return {{s.center}, {}, {}, s.radius}; }
inline Hull hull(const gphys::Capsule& c) { return {{c.a, c.b}, {{0, 1}}, {}, c.radius}; }
inline Hull hull(const gphys::Triangle& t) { return {{t.a, t.b, t.c}, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}}, 0}; }
inline Hull hull(const gphys::Obb& b) {
    constexpr int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    Vec3 corner[8];
    for (int i = 0; i < 8; ++i) {
        corner[i] = b.center + b.axes.x * (sign[i][0] * b.half.x) + b.axes.y * (sign[i][1] * b.half.y) +
                    b.axes.z * (sign[i][2] * b.half.z);
    }
    return Hull::hexahedron(corner);
}
inline Hull hull(const gphys::Aabb& b) {
    Vec3 corner[8];
    constexpr int high[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (int i = 0; i < 8; ++i) {
        corner[i] = {high[i][0] ? b.max.x : b.min.x, high[i][1] ? b.max.y : b.min.y, high[i][2] ? b.max.z : b.min.z};
    }
    return Hull::hexahedron(corner);
}

/// Of a frustum with eight corners: each by Cramer's rule, in long double.
inline Hull hull(const gphys::Frustum& f) {
    using Real = long double;
    using gphys::Plane;
    const auto determinant = [](std::array<Real, 3> a, std::array<Real, 3> b, std::array<Real, 3> c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    Vec3 corner[8];
    for (int i = 0; i < 8; ++i) {
        const Plane& a = f.planes[i < 4 ? GPHYS_FRUSTUM_NEAR : GPHYS_FRUSTUM_FAR];
        const Plane& b = f.planes[i % 4 == 1 || i % 4 == 2 ? GPHYS_FRUSTUM_RIGHT : GPHYS_FRUSTUM_LEFT];
        const Plane& c = f.planes[i % 4 >= 2 ? GPHYS_FRUSTUM_TOP : GPHYS_FRUSTUM_BOTTOM];
        std::array<Real, 3> column[4];
        for (int k = 0; k < 3; ++k) column[k] = {a.normal[k], b.normal[k], c.normal[k]};
        column[3] = {a.distance, b.distance, c.distance};
        const Real volume = determinant(column[0], column[1], column[2]);
        for (int k = 0; k < 3; ++k) {
            const auto of = [&](int axis) { return column[axis == k ? 3 : axis]; };
            corner[i][k] = static_cast<double>(f.origin[k] + determinant(of(0), of(1), of(2)) / volume);
        }
    }
    return Hull::hexahedron(corner);
}

/// A camera's frustum beside its corners, made from the same parameters.
struct View {
    gphys::Frustum frustum;
    Hull hull;
};
/// Looking along axes.z from the origin. An infinite one has no far plane; its hull ends at `far`.
inline View view(Vec3 origin, const gphys::Mat3& axes, double width, double height, double near, double far,
                 bool infinite) {
    View v;
    v.frustum.origin = origin;
    gphys::Plane* p = v.frustum.planes;
    p[GPHYS_FRUSTUM_NEAR] = {axes.z, near};
    p[GPHYS_FRUSTUM_FAR] = infinite ? gphys::Plane{{}, -1} : gphys::Plane{-axes.z, -far};
    p[GPHYS_FRUSTUM_LEFT] = {axes.x + axes.z * width, 0};
    p[GPHYS_FRUSTUM_RIGHT] = {-axes.x + axes.z * width, 0};
    p[GPHYS_FRUSTUM_BOTTOM] = {axes.y + axes.z * height, 0};
    p[GPHYS_FRUSTUM_TOP] = {-axes.y + axes.z * height, 0};
    Vec3 corner[8];
    for (int i = 0; i < 8; ++i) {
        const double depth = i < 4 ? near : far;
        const double x = (i % 4 == 1 || i % 4 == 2 ? 1 : -1) * width * depth,
                     y = (i % 4 >= 2 ? 1 : -1) * height * depth;
        corner[i] = origin + axes.x * x + axes.y * y + axes.z * depth;
    }
    v.hull = Hull::hexahedron(corner);
    return v;
}

struct Gap {
    double gap = -INFINITY;  // > 0: the distance; < 0: overlapping
    Vec3 axis;               // unit, from a to b
};

class GapSearch {
public:
    GapSearch(const Hull& a, const Hull& b) : a_(a), b_(b) {}

    Gap run() {
        for (const auto& f : a_.faces) try_axis(normal(a_, f));
        for (const auto& f : b_.faces) try_axis(normal(b_, f));
        for (const auto& e : a_.edges) {
            for (const auto& f : b_.edges) try_axis(cross(direction(a_, e), direction(b_, f)));
        }
        // All on parallel lines, perhaps on one, which leaves no depth across.
        const bool parallel = best_.gap == -INFINITY;
        if (parallel) {
            for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
                try_axis(axis);
                for (const auto& e : a_.edges) try_axis(cross(direction(a_, e), axis));
                for (const auto& e : b_.edges) try_axis(cross(direction(b_, e), axis));
            }
        }
        // Round shapes touch corners and edges from any side. So do segments that are parallel.
        if (a_.radius > 0 || b_.radius > 0 || a_.faces.empty() || b_.faces.empty() || parallel) {
            for (Vec3 p : a_.corners) {
                for (Vec3 q : b_.corners) try_axis(q - p);
                for (const auto& e : b_.edges) try_axis(to_foot(b_, e, p));
            }
            for (Vec3 q : b_.corners) {
                for (const auto& e : a_.edges) try_axis(to_foot(a_, e, q));
            }
            try_axis({1, 0, 0});
        }
        best_.gap -= a_.radius + b_.radius;
        return best_;
    }

private:
    static Vec3 normal(const Hull& h, const std::array<int, 3>& f) {
        return cross(h.corners[f[1]] - h.corners[f[0]], h.corners[f[2]] - h.corners[f[0]]);
    }
    static Vec3 direction(const Hull& h, const std::array<int, 2>& e) { return h.corners[e[1]] - h.corners[e[0]]; }
    /// From p to its foot on the edge's line, without going through absolute coordinates.
    static Vec3 to_foot(const Hull& h, const std::array<int, 2>& e, Vec3 p) {
        const Vec3 along = direction(h, e), from_p = h.corners[e[0]] - p;
        const double square = length_squared(along);
        return square > 0 ? from_p - along * (dot(from_p, along) / square) : from_p;
    }
    void try_axis(Vec3 axis) {
        const double size = length(axis);
        if (size == 0) return;
        axis = axis * (1 / size);
        // Relative to a corner, so that an offset costs no digits.
        double a_low = 0, a_high = 0, b_low = INFINITY, b_high = -INFINITY;
        for (Vec3 p : a_.corners) {
            const double d = dot(p - a_.corners[0], axis);
            a_low = std::min(a_low, d), a_high = std::max(a_high, d);
        }
        for (Vec3 q : b_.corners) {
            const double d = dot(q - a_.corners[0], axis);
            b_low = std::min(b_low, d), b_high = std::max(b_high, d);
        }
        if (b_low - a_high > best_.gap) best_ = {b_low - a_high, axis};
        if (a_low - b_high > best_.gap) best_ = {a_low - b_high, axis * -1};
    }

    const Hull &a_, &b_;
    Gap best_;
};

inline Gap gap(const Hull& a, const Hull& b) { return GapSearch(a, b).run(); }

}  // namespace test

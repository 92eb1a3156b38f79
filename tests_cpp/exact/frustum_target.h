// Frusta as targets of sweeps and penetrations. Each is the convex hull of its eight corners, the exact intersections
// of its planes.
#pragma once

#include <array>

#include "certified_separation.h"

namespace test {

struct FrustumPart {
    gphys_frustum frustum;
    std::array<VectorOf<Number>, 8> corners;  // in the order of gphys_frustum_corners

    /// Returns false for a frustum that the header excludes: it is not the hull of its corners by the required margin.
    bool make(const gphys_frustum& made) {
        frustum = made;
        if (gphys_shape_validate(GPHYS_SHAPE_FRUSTUM, &frustum) != GPHYS_OK) return false;
        const VectorOf<Number> origin(frustum.origin);
        const auto normal = [&](int plane) { return VectorOf<Number>(frustum.planes[plane].normal); };
        const auto distance = [&](int plane) { return Number(frustum.planes[plane].distance); };
        for (size_t i = 0; i < 8; ++i) {
            const int a = i < 4 ? GPHYS_FRUSTUM_NEAR : GPHYS_FRUSTUM_FAR;
            const int b = i % 4 == 1 || i % 4 == 2 ? GPHYS_FRUSTUM_RIGHT : GPHYS_FRUSTUM_LEFT;
            const int c = i % 4 >= 2 ? GPHYS_FRUSTUM_TOP : GPHYS_FRUSTUM_BOTTOM;
            const VectorOf<Number> bc = cross(normal(b), normal(c)), ca = cross(normal(c), normal(a)),
                                   ab = cross(normal(a), normal(b));
            const Number volume = dot(normal(a), bc);
            if (volume == 0) return false;
            const VectorOf<Number> from_origin =
                (bc * distance(a) + ca * distance(b) + ab * distance(c)) * Number(1 / volume);
            corners[i] = origin + from_origin;
            for (const Number* coordinate : {&corners[i].x, &corners[i].y, &corners[i].z}) {
                if (CGAL::abs(*coordinate) > Number(GPHYS_MAX_COORDINATE)) return false;
                coordinate->exact();
            }
            for (const int opposite : {a ^ 1, b ^ 1, c ^ 1}) {
                const Number height = dot(normal(opposite), from_origin) - distance(opposite);
                const Number size = dot(normal(opposite), normal(opposite)) * dot(from_origin, from_origin);
                if (height <= 0 || height * height < Number(0x1p-78) * size) return false;
            }
        }
        return true;
    }
};

/// Conversions of exact numbers.
inline void convert(const Number& value, Number& out) { out = value; }
inline void convert(const Number& value, double& out) {
    value.exact();  // otherwise the result may have an error of 1e-5
    out = CGAL::to_double(value);
}
inline void convert(const Number& value, Range& out) {
    value.exact();
    out = Range(CGAL::to_interval(value));
}

template <class T>
Rounded<T> rounded_of(const FrustumPart& part, gphys_vec3 from) {
    Rounded<T> result({}, from, 0);
    for (const VectorOf<Number>& corner : part.corners) {
        const VectorOf<Number> exact = corner - VectorOf<Number>(from);
        VectorOf<T> converted;
        convert(exact.x, converted.x);
        convert(exact.y, converted.y);
        convert(exact.z, converted.z);
        result.corners.push_back(converted);
    }
    return result;
}
template <class T>
Convex<T> convex_of(const FrustumPart& part, gphys_vec3 from, double factor) {
    Convex<T> result{core_of<T>(part, from, factor), {}, {}};
    for (const gphys_plane& plane : part.frustum.planes) {
        const int exponent = std::ilogb(largest(widen(plane.normal)));
        result.normals.push_back(VectorOf<T>(plane.normal) * T(std::ldexp(1.0, -exponent)));
    }
    for (size_t i = 0; i < 6; ++i) {
        for (size_t k = i + 1; k < 6; ++k) {
            if (k != (i ^ 1)) result.edges.push_back(cross(result.normals[i], result.normals[k]));
        }
    }
    return result;
}
/// The origin of a frustum counts as a coordinate.
inline double size_beside_corners(const FrustumPart& part, gphys_vec3 from) {
    return largest(widen(part.frustum.origin) - widen(from));
}

/// A frustum of a camera, possibly off-centre, or a box, or a shape in between; some are long and thin, some wide. A
/// few have planes that are rotated or displaced individually, or distances relative to another origin.
inline gphys_frustum some_frustum(Cases& c) {
    const gphys::Mat3 axes = rotation_matrix(widen(c.rotation()));
    const Vec3 towards[6] = {axes.z, -axes.z, axes.x, -axes.x, axes.y, -axes.y};
    const double near = c.one_in(2) ? c.size() : 1e-4 * c.size(), depth = c.size();
    const double slope = c.one_in(3) ? 1 : std::pow(10, c.random.uniform(-4, 2));
    const bool is_camera = c.one_in(2);
    gphys_frustum frustum{c.point(), {}};
    const Vec3 shift = c.one_in(4) ? widen(c.one_in(2) ? gphys_vec3{} : c.point()) - widen(frustum.origin) : Vec3{};
    frustum.origin = narrow(widen(frustum.origin) + shift);
    for (int i = 0; i < 6; ++i) {
        gphys_plane& plane = frustum.planes[i];
        double tilt = slope;
        if (c.one_in(4)) tilt *= c.random.uniform(-1, 1);
        if (!is_camera && c.one_in(3)) tilt = 0;
        plane.normal = narrow(i < 2 ? towards[i] : towards[i] + axes.z * tilt);
        if (c.one_in(8)) c.nudge(plane.normal);
        if (c.one_in(16)) plane.normal.x = mixed_number(c.random);
        if (c.one_in(16)) plane.normal = narrow(widen(plane.normal) * std::ldexp(1.0, int(c.random.index(41)) - 20));
        double distance = i == 0 ? near : i == 1 ? -near - depth : is_camera ? 0 : -c.size();
        distance = (distance - dot(towards[i], shift)) * length(widen(plane.normal));
        plane.distance = static_cast<float>(distance);
    }
    return frustum;
}

class FrustumTarget {
public:
    std::vector<FrustumPart> parts = std::vector<FrustumPart>(1);

    bool make(Cases& c) { return parts[0].make(some_frustum(c)); }
    gphys_shape_type type() const { return GPHYS_SHAPE_FRUSTUM; }
    const void* data() const { return &parts[0].frustum; }
    const gphys_frustum& sample() const { return parts[0].frustum; }
    /// A target point: a corner, or on an edge, on a face or inside.
    gphys_vec3 aim(Cases& c) const {
        const uint32_t i = c.random.index(8), around = i / 4 * 4;
        const auto corner = [&](uint32_t k) {
            const auto& [x, y, z] = parts[0].corners[k];
            return narrow(Vec3{CGAL::to_double(x), CGAL::to_double(y), CGAL::to_double(z)});
        };
        return c.point_by(corner(i), corner(around + (i + 1) % 4), corner(c.one_in(4) ? 7 - i : (i + 4) % 8));
    }
    size_t part_of(uint32_t) const { return 0; }
};

}  // namespace test

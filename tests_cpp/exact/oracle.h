// References that share no code with the library. Shapes are exactly those of their floats, in the arithmetic of CGAL:
// rational numbers filtered by intervals (Number), with the predicates and distances of its exact kernel. Square roots
// have 300 digits of MPFR (Big).
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>

#include <boost/container/static_vector.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <vector>

#include "cases.h"

namespace test {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Big =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// Integers times powers of two: sums and products of floats are exact.
using Binary = CGAL::Gmpzf;
/// An interval that contains the number. Valid only while an Upward exists.
using Range = CGAL::Interval_nt<false>;
using Upward = CGAL::Protect_FPU_rounding<true>;

inline Point exact(gphys_vec3 v) { return {v.x, v.y, v.z}; }
inline Vector exact_vector(gphys_vec3 v) { return {v.x, v.y, v.z}; }
inline Point exact(Vec3 v) { return {v.x, v.y, v.z}; }

/// The absolute error of a computed number.
inline double error_of(double computed, const Number& truth) {
    return std::fabs(CGAL::to_double(Number(computed) - truth));
}
inline double error_of(double computed, const Big& truth) { return abs(Big(computed) - truth).convert_to<double>(); }
inline double rounded(const Number& value) { return CGAL::to_double(value); }
inline double rounded(const Big& value) { return value.convert_to<double>(); }

/// A vector of numbers of any type.
template <class Scalar>
struct VectorOf {
    Scalar x, y, z;
    VectorOf() = default;
    VectorOf(Scalar x_, Scalar y_, Scalar z_) : x(x_), y(y_), z(z_) {}
    explicit VectorOf(gphys_vec3 v) : x(v.x), y(v.y), z(v.z) {}
    explicit VectorOf(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
};
template <class T>
VectorOf<T> operator+(const VectorOf<T>& a, const VectorOf<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
VectorOf<T> operator-(const VectorOf<T>& a, const VectorOf<T>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
VectorOf<T> operator-(const VectorOf<T>& a) {
    return {-a.x, -a.y, -a.z};
}
template <class T>
VectorOf<T> operator*(const VectorOf<T>& a, const T& s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class T>
T dot(const VectorOf<T>& a, const VectorOf<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
VectorOf<T> cross(const VectorOf<T>& a, const VectorOf<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
using BigVec = VectorOf<Big>;
inline double largest(const VectorOf<double>& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

inline Big big(const Number& value) {
    Big result;
    result.backend() = value.exact().get_mpq_t();
    return result;
}
inline BigVec big(const Point& p) { return {big(p.x()), big(p.y()), big(p.z())}; }

/// The columns of the rotation matrix of a quaternion; they are rational.
template <class Scalar>
struct Axes {
    VectorOf<Scalar> axis[3];

    explicit Axes(gphys_quat q) {
        const Scalar x(q.x), y(q.y), z(q.z), w(q.w);
        const Scalar s = Scalar(2) / (x * x + y * y + z * z + w * w), one(1);
        axis[0] = {one - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)};
        axis[1] = {s * (x * y - w * z), one - s * (x * x + z * z), s * (y * z + w * x)};
        axis[2] = {s * (x * z + w * y), s * (y * z - w * x), one - s * (x * x + y * y)};
    }
};

/// The same with vectors of CGAL.
struct Rotation {
    Vector axis[3];

    explicit Rotation(gphys_quat q) {
        const Axes<Number> exact(q);
        for (int k = 0; k < 3; ++k) axis[k] = {exact.axis[k].x, exact.axis[k].y, exact.axis[k].z};
    }
    Vector into(const Vector& v) const { return {axis[0] * v, axis[1] * v, axis[2] * v}; }
    Vector out(const Vector& v) const { return axis[0] * v.x() + axis[1] * v.y() + axis[2] * v.z(); }
};

/// CGAL throws for degenerate triangles and segments, so these are passed as segments and points.
template <class Answer>
auto with_simplex(const gphys_triangle& t, const Answer& answer) {
    const Point a = exact(t.a), b = exact(t.b), c = exact(t.c);
    if (!CGAL::collinear(a, b, c)) return answer(Kernel::Triangle_3(a, b, c));
    const Point first = std::min({a, b, c}), last = std::max({a, b, c});
    if (first == last) return answer(first);
    return answer(Kernel::Segment_3(first, last));
}

// --- How far apart two convex shapes are ---------------------------------------------------------

/// A convex solid: the hull of the corners of its core, relative to a reference point, rounded by a radius.
template <class Scalar>
struct Rounded {
    boost::container::static_vector<VectorOf<Scalar>, 16> corners;
    Scalar radius = 0;

    Rounded(std::initializer_list<gphys_vec3> points, gphys_vec3 from, Scalar r) : radius(r) {
        for (gphys_vec3 p : points) corners.push_back(VectorOf<Scalar>(p) - VectorOf<Scalar>(from));
    }
};

template <class T>
Rounded<T> rounded_of(const gphys_sphere& s, gphys_vec3 from) {
    return {{s.center}, from, s.radius};
}
template <class T>
Rounded<T> rounded_of(const gphys_capsule& s, gphys_vec3 from) {
    return {{s.a, s.b}, from, s.radius};
}
template <class T>
Rounded<T> rounded_of(const gphys_segment& s, gphys_vec3 from) {
    return {{s.a, s.b}, from, 0};
}
template <class T>
Rounded<T> rounded_of(const gphys_triangle& t, gphys_vec3 from) {
    return {{t.a, t.b, t.c}, from, 0};
}
// Corners of boxes are numbered by bits of x, y, z.
template <class T>
Rounded<T> rounded_of(const gphys_aabb& b, gphys_vec3 from) {
    const auto corner = [&](int i) {
        return gphys_vec3{i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z};
    };
    return {{corner(0), corner(1), corner(2), corner(3), corner(4), corner(5), corner(6), corner(7)}, from, 0};
}
template <class T>
Rounded<T> rounded_of(const gphys_obb& b, gphys_vec3 from) {
    const Axes<T> rotation(b.rotation);
    const VectorOf<T> center = VectorOf<T>(b.center) - VectorOf<T>(from), x = rotation.axis[0] * T(b.half_extents.x),
                      y = rotation.axis[1] * T(b.half_extents.y), z = rotation.axis[2] * T(b.half_extents.z);
    Rounded<T> result({}, from, 0);
    for (int i = 0; i < 8; ++i) {
        const VectorOf<T> xy = (i & 1 ? center + x : center - x) + (i & 2 ? y : -y);
        result.corners.push_back(i & 4 ? xy + z : xy - z);
    }
    return result;
}

/// The size S of the documented error bounds: the largest coordinate difference of a shape and a point.
template <class S>
double size_of(const S& shape, gphys_vec3 point) {
    const Rounded<double> rounded = rounded_of<double>(shape, point);
    double size = rounded.radius;
    for (const auto& corner : rounded.corners) {
        size =
            std::max({size, largest(corner) + rounded.radius, largest(corner - rounded.corners[0]) + rounded.radius});
    }
    return size;
}
/// A plane is unbounded. Its distance is relative to the origin, so the size includes the coordinates of the point.
inline double size_of(const gphys_plane& plane, gphys_vec3 point) {
    return largest(widen(point)) + std::fabs(plane.distance) / length(widen(plane.normal));
}

/// The exact squared distance of the hulls of two sets of corners. Coordinates are passed to CGAL as Gmpzf: with
/// doubles it would compute products in double, and their rounding can change an answer.
inline CGAL::Quotient<Binary> squared_distance(const Rounded<double>& a, const Rounded<double>& b) {
    using Coordinates = CGAL::Simple_cartesian<Binary>;
    using Traits = CGAL::Polytope_distance_d_traits_3<Coordinates, Binary, Binary>;
    const auto points = [](const Rounded<double>& shape) {
        std::vector<Coordinates::Point_3> result;
        for (const VectorOf<double>& v : shape.corners) result.emplace_back(Binary(v.x), Binary(v.y), Binary(v.z));
        return result;
    };
    const std::vector<Coordinates::Point_3> p = points(a), q = points(b);
    const CGAL::Polytope_distance_d<Traits> distance(p.begin(), p.end(), q.begin(), q.end());
    return {distance.squared_distance_numerator(), distance.squared_distance_denominator()};
}

}  // namespace test

// The exact shapes that float bits denote, in the arithmetic of CGAL: rational numbers behind
// intervals (Number), predicates and distances of its exact kernel, and for square roots 300 digits
// of MPFR (Big). None of it is ours.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>

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

inline Point exact(gphys_vec3 v) { return {v.x, v.y, v.z}; }
inline Vector exact_vector(gphys_vec3 v) { return {v.x, v.y, v.z}; }
inline Point exact(Vec3 v) { return {v.x, v.y, v.z}; }

/// How far a computed number is from the truth, in units.
inline double error_of(double computed, const Number& truth) {
    return std::fabs(CGAL::to_double(Number(computed) - truth));
}
inline double error_of(double computed, const Big& truth) { return abs(Big(computed) - truth).convert_to<double>(); }
inline double rounded(const Number& value) { return CGAL::to_double(value); }
inline double rounded(const Big& value) { return value.convert_to<double>(); }

/// A vector of Big.
struct BigVec {
    Big x, y, z;
    BigVec() = default;
    BigVec(Big x_, Big y_, Big z_) : x(x_), y(y_), z(z_) {}
    explicit BigVec(gphys_vec3 v) : x(v.x), y(v.y), z(v.z) {}
    explicit BigVec(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
};
inline BigVec operator+(const BigVec& a, const BigVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline BigVec operator-(const BigVec& a, const BigVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline BigVec operator*(const BigVec& a, const Big& s) { return {a.x * s, a.y * s, a.z * s}; }
inline Big dot(const BigVec& a, const BigVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline BigVec cross(const BigVec& a, const BigVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Big big(const Number& value) {
    Big result;
    result.backend() = value.exact().get_mpq_t();
    return result;
}
inline BigVec big(const Point& p) { return {big(p.x()), big(p.y()), big(p.z())}; }

/// The exact rotation of a quaternion, which is rational: columns.
struct Rotation {
    Vector axis[3];

    explicit Rotation(gphys_quat q) {
        const Number x(q.x), y(q.y), z(q.z), w(q.w);
        const Number s = Number(2) / (x * x + y * y + z * z + w * w), one(1);
        axis[0] = {one - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)};
        axis[1] = {s * (x * y - w * z), one - s * (x * x + z * z), s * (y * z + w * x)};
        axis[2] = {s * (x * z + w * y), s * (y * z - w * x), one - s * (x * x + y * y)};
    }
    Vector into(const Vector& v) const { return {axis[0] * v, axis[1] * v, axis[2] * v}; }
    Vector out(const Vector& v) const { return axis[0] * v.x() + axis[1] * v.y() + axis[2] * v.z(); }
};

/// CGAL throws at degenerate triangles and segments, so they are given to it as what they are.
template <class Answer>
auto with_simplex(const gphys_triangle& t, const Answer& answer) {
    const Point a = exact(t.a), b = exact(t.b), c = exact(t.c);
    if (!CGAL::collinear(a, b, c)) return answer(Kernel::Triangle_3(a, b, c));
    const Point first = std::min({a, b, c}), last = std::max({a, b, c});
    if (first == last) return answer(first);
    return answer(Kernel::Segment_3(first, last));
}
/// The path of a ray: without end, up to t_max, or a point.
template <class Answer>
auto with_path(const gphys_ray& ray, const Answer& answer) {
    const Point from = exact(ray.origin);
    const Vector along = exact_vector(ray.direction);
    if (std::isinf(ray.t_max)) return answer(Kernel::Ray_3(from, along));
    if (ray.t_max == 0) return answer(from);
    return answer(Kernel::Segment_3(from, from + along * Number(ray.t_max)));
}

// --- How far apart two convex shapes are ---------------------------------------------------------

/// A convex solid as the corners of its core and the radius around them. Corners count from a
/// reference, so that rounding those of a rotated box costs 2^-53 of the pair's size.
struct Rounded {
    std::vector<Vec3> corners;
    double radius = 0;
};

inline Rounded rounded_of(const gphys_sphere& s, Vec3 from) { return {{widen(s.center) - from}, s.radius}; }
inline Rounded rounded_of(const gphys_capsule& s, Vec3 from) {
    return {{widen(s.a) - from, widen(s.b) - from}, s.radius};
}
inline Rounded rounded_of(const gphys_segment& s, Vec3 from) { return {{widen(s.a) - from, widen(s.b) - from}, 0}; }
inline Rounded rounded_of(const gphys_triangle& t, Vec3 from) {
    return {{widen(t.a) - from, widen(t.b) - from, widen(t.c) - from}, 0};
}
inline Rounded rounded_of(const gphys_aabb& b, Vec3 from) {
    Rounded result;
    for (int i = 0; i < 8; ++i) {
        const Vec3 corner{i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z};
        result.corners.push_back(corner - from);
    }
    return result;
}
inline Rounded rounded_of(const gphys_obb& b, Vec3 from) {
    Rounded result;
    const Rotation rotation(b.rotation);
    const Number x(b.half_extents.x), y(b.half_extents.y), z(b.half_extents.z);
    const Point center = exact(b.center) - (exact(from) - CGAL::ORIGIN);
    for (int i = 0; i < 8; ++i) {
        const Point corner = center + rotation.out({i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z});
        result.corners.push_back({rounded(corner.x()), rounded(corner.y()), rounded(corner.z())});
    }
    return result;
}

/// S of the contract: the largest coordinate difference of a shape and a point.
template <class S>
double size_of(const S& shape, gphys_vec3 point) {
    const Rounded rounded = rounded_of(shape, widen(point));
    double size = rounded.radius;
    for (Vec3 corner : rounded.corners) size = std::max(size, largest(corner) + rounded.radius);
    for (Vec3 corner : rounded.corners) size = std::max(size, largest(corner - rounded.corners[0]) + rounded.radius);
    return size;
}
/// A plane has no end, but its distance counts from the origin.
inline double size_of(const gphys_plane& plane, gphys_vec3 point) {
    return largest(widen(point)) + std::fabs(plane.distance) / length(widen(plane.normal));
}

/// The squared distance of the hulls of two sets of corners, exact in what the doubles are. Coordinates
/// go to CGAL as Gmpzf: with doubles it makes products in double, and what those round away can turn an answer.
inline CGAL::Quotient<CGAL::Gmpzf> squared_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    using Coordinates = CGAL::Simple_cartesian<CGAL::Gmpzf>;
    using Traits = CGAL::Polytope_distance_d_traits_3<Coordinates, CGAL::Gmpzf, CGAL::Gmpzf>;
    const auto points = [](const std::vector<Vec3>& corners) {
        std::vector<Coordinates::Point_3> result;
        for (Vec3 v : corners) result.emplace_back(CGAL::Gmpzf(v.x), CGAL::Gmpzf(v.y), CGAL::Gmpzf(v.z));
        return result;
    };
    const std::vector<Coordinates::Point_3> p = points(a), q = points(b);
    const CGAL::Polytope_distance_d<Traits> distance(p.begin(), p.end(), q.begin(), q.end());
    return {distance.squared_distance_numerator(), distance.squared_distance_denominator()};
}

}  // namespace test

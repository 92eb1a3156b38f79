// raycast against spheres and capsules, without false results: a quadratic with error bounds (raycast_sphere.h; Haines,
// Guenther, Akenine-Moeller 2019), and exact arithmetic (exact.h) where the bounds do not decide.
#include "foundation/exact.h"
#include "geometry/capsule_axis.h"
#include "geometry/intersect.h"
#include "geometry/raycast_sphere.h"

namespace gphys {
namespace {

constexpr double unit = 0x1p-53;
/// An upper bound of the length of a vector, at most sqrt(3) times it.
double reach(Vec3 v) { return sum(abs(v)); }

struct SphereCrossing {
    const Sphere& sphere;
    const Ray& ray;

    template <class N>
    Quadratic<N> operator()(N) const {
        return sphere_quadratic(Vec<N>::difference(ray.origin, sphere.center),
                                Vec<N>::two_terms(ray.direction, ray.rest), N(sphere.radius));
    }
    QuadraticError<double> error_of(const Quadratic<double>& q) const {
        return sphere_error(ray.origin - sphere.center, ray.direction, sphere.radius, q);
    }
};

/// The quadratic of the infinite cylinder around the axis of a capsule. The distance of the two lines is dot(from, n) /
/// |n|, where n is the common normal of ray and axis.
struct SideCrossing {
    const Capsule& capsule;
    const Ray& ray;

    template <class N>
    Quadratic<N> operator()(N) const {
        const auto axis = Vec<N>::difference(capsule.b, capsule.a);
        const auto from = Vec<N>::difference(ray.origin, capsule.a);
        const auto d = Vec<N>::two_terms(ray.direction, ray.rest);
        const auto n = cross(d, axis), moment = cross(from, axis);
        const N nn = dot(n, n), apart = dot(from, n), aa = dot(axis, axis);
        const N radius_squared = N(capsule.radius) * N(capsule.radius);
        return {nn, -dot(moment, n), dot(moment, moment) - radius_squared * aa, radius_squared * nn - apart * apart,
                aa};
    }
    QuadraticError<double> error_of(const Quadratic<double>& q) const {
        const double from = reach(ray.origin - capsule.a), rr = capsule.radius * capsule.radius;
        // The error of n is 4 sqrt(3) u |d| |axis| =: e, that of the moment 4 sqrt(3) u |from| |axis| =: g. That of
        // apart is |from| e and 4 u |from| |n|, together h. |n| <= |d| |axis|, |moment| <= |from| |axis|.
        const double axis = reach(capsule.b - capsule.a), d_axis = reach(ray.direction) * axis, from_axis = from * axis;
        const double e = 7 * unit * d_axis, g = 8 * unit * from_axis, h = 12 * unit * from * d_axis;
        const double apart = std::sqrt(std::max(rr * q.a - q.discriminant, 0.0));
        return {from_axis * e + d_axis * (g + 4 * unit * from_axis),
                (2 * from_axis + g) * g + 4 * unit * from_axis * from_axis + 9 * unit * rr * q.stretch,
                (2 * apart + h) * h + 2 * unit * apart * apart + rr * (2 * d_axis * e + 6 * unit * q.a)};
    }
};

/// Whether the crossing at t is before the end of the ray. If that is too close for double: the ray has entered if its
/// end is inside the surface, or past the midpoint of the two crossings.
template <class Crossing>
bool in_time(const Crossing& crossing, double t_max, double& t) {
    if (std::fabs(t - t_max) > 0x1p-27 * t) return t <= t_max;
    const int end = sign_of([&](auto number) {
        using N = decltype(number);
        const Quadratic<N> q = crossing(number);
        return N(t_max) * (N(t_max) * q.a - N(2.0) * q.b) + q.c;
    });
    t = std::min(t, t_max);
    return end <= 0 || sign_of([&](auto number) {
                           const auto q = crossing(number);
                           return decltype(number)(t_max) * q.a - q.b;
                       }) >= 0;
}

/// The entry of a ray that starts outside; false if it starts inside. t is the root whose formula adds numbers of one
/// sign (Haines, Guenther, Akenine-Moeller 2019).
template <class Crossing>
bool enters(const Crossing& crossing, double t_max, double& t) {
    const Quadratic<double> rounded = crossing(0.0);
    const QuadraticError<double> error = crossing.error_of(rounded);
    if (rounded.discriminant < -error.discriminant) return false;
    if (rounded.b < -error.b || rounded.c < -error.c) return false;  // not approaching, or inside
    double b = rounded.b, c = rounded.c, stretch = std::sqrt(rounded.stretch);
    double root = std::sqrt(std::max(rounded.discriminant, 0.0));
    const double way = b + stretch * root;
    if (is_accurate(rounded, error, stretch, root, way)) {
        t = c / way;
        return in_time(crossing, t_max, t);
    }
    const Quadratic<Exact> exact = crossing(Exact());
    if (exact.discriminant.sign() < 0 || exact.b.sign() <= 0 || exact.c.sign() <= 0) return false;
    b = exact.b.value();
    c = exact.c.value();
    stretch = std::sqrt(exact.stretch.value());
    root = std::sqrt(exact.discriminant.value());
    t = c / (b + stretch * root);
    return in_time(crossing, t_max, t);
}

bool enters(const Sphere& sphere, const Ray& ray, double& t) {
    return enters(SphereCrossing{sphere, ray}, ray.t_max, t);
}

/// value_of for each component of vector(number).
template <class Vector>
Vec3 values_of(const Vector& vector) {
    return {value_of([&](auto number) { return vector(number).x; }),
            value_of([&](auto number) { return vector(number).y; }),
            value_of([&](auto number) { return vector(number).z; })};
}

/// Half of the interval between the two crossings, times a.
template <class Crossing>
double root_of(const Crossing& crossing) {
    return std::sqrt(value_of([&](auto number) { return crossing(number).discriminant; })) *
           std::sqrt(crossing(0.0).stretch);
}

// The vector from the axis to the point of entry: the perpendicular from the axis to the line of the ray, plus the way
// back along the line to the surface. Neither cancels for any radius, and the second opposes the direction. Where the
// point at t is accurate enough, it is used instead, which is faster.

Vec3 out_of_ball(const Sphere& sphere, const Ray& ray) {
    const Vec3 moment = values_of([&](auto number) {
        using V = Vec<decltype(number)>;
        return cross(V::difference(ray.origin, sphere.center), V::two_terms(ray.direction, ray.rest));
    });
    const Vec3 back = ray.direction * root_of(SphereCrossing{sphere, ray});
    return (cross(ray.direction, moment) - back) / length_squared(ray.direction);
}

Vec3 out_of_side(const Capsule& capsule, const Ray& ray) {
    const auto normal_of = [&](auto number) {  // perpendicular to both the axis and the ray
        using V = Vec<decltype(number)>;
        return cross(V::two_terms(ray.direction, ray.rest), V::difference(capsule.b, capsule.a));
    };
    const Vec3 normal = values_of(normal_of);
    const double apart = value_of(
        [&](auto number) { return dot(Vec<decltype(number)>::difference(ray.origin, capsule.a), normal_of(number)); });
    const Vec3 back = across_line(capsule, ray.direction) * root_of(SideCrossing{capsule, ray});
    return (normal * apart - back) / length_squared(normal);
}

bool hit_with(Vec3 normal, Vec3 point, double t, Hit& hit) {
    hit = Hit{t, point, normal};
    return true;
}

bool ball_hit(const Sphere& sphere, const Ray& ray, double t, Hit& hit) {
    if (sphere.radius == 0) return hit_with(-normalized(ray.direction), sphere.center, t, hit);
    const Vec3 from = ray.origin - sphere.center, out = from + ray.direction * t;
    const bool is_accurate = !is_coarse(reach(from), sphere.radius) && dot(out, ray.direction) < 0;
    const Vec3 normal = normalized(is_accurate ? out : out_of_ball(sphere, ray));
    return hit_with(normal, sphere.center + normal * sphere.radius, t, hit);
}

/// The hit at t on the side of a capsule, next to the point a + along (b - a) of the axis. `size` is the largest
/// coordinate of the axis and of the ray's origin relative to a.
bool side_hit(const Capsule& capsule, double along, double size, const Ray& ray, double t, Hit& hit) {
    const Vec3 axis_point = capsule.a + (capsule.b - capsule.a) * along;
    if (capsule.radius == 0) return hit_with(-normalized(ray.direction), axis_point, t, hit);
    const Vec3 out = (ray.origin - axis_point) + ray.direction * t;
    if (is_coarse(reach(capsule.a) + size, capsule.radius) || dot(out, ray.direction) >= 0) {
        return hit_with(normalized(out_of_side(capsule, ray)), ray.origin + ray.direction * t, t, hit);
    }
    const Vec3 normal = normalized(out);
    return hit_with(normal, axis_point + normal * capsule.radius, t, hit);
}

/// Which part of the axis of a capsule is closest to a point.
enum class Place { beside, beyond, open };  // between its ends; an end; undecided

/// The same for the point of the ray at t, with accurate products: t may be far smaller than the rounding errors of
/// coordinates.
Place place_on_axis(const Capsule& capsule, const Ray& ray, double t) {
    const auto along_axis = [&](auto vector) {  // vector(number): the factor to multiply with the axis
        return value_of([&](auto number) {
            using V = Vec<decltype(number)>;
            return dot(V::difference(capsule.b, capsule.a), vector(number));
        });
    };
    const auto from = [&](Vec3 end) {
        return along_axis([&](auto number) { return Vec<decltype(number)>::difference(ray.origin, end); });
    };
    const double way =
        t * along_axis([&](auto number) { return Vec<decltype(number)>::two_terms(ray.direction, ray.rest); });
    const double from_a = from(capsule.a), from_b = from(capsule.b);
    const double error = 0x1p-27 * std::fabs(way);
    const double error_a = error + 0x1p-42 * std::fabs(from_a), error_b = error + 0x1p-42 * std::fabs(from_b);
    if (from_a + way < -error_a || from_b + way > error_b) return Place::beyond;
    return from_a + way > error_a && from_b + way < -error_b ? Place::beside : Place::open;
}

/// Whether the axis point closest to the line of the ray is between the ends, exactly. The two must not be parallel.
bool is_nearest_between_ends(const Capsule& capsule, const Ray& ray) {
    const auto beyond = [&](Vec3 end, Vec3 other) {
        return sign_of([&](auto number) {
                   using V = Vec<decltype(number)>;
                   const V d = V::two_terms(ray.direction, ray.rest);
                   return dot(cross(V::difference(ray.origin, end), d), cross(V::difference(other, end), d));
               }) < 0;
    };
    return !beyond(capsule.a, capsule.b) && !beyond(capsule.b, capsule.a);
}

}  // namespace

bool raycast(const Sphere& sphere, const Ray& ray, Hit& hit) {
    if (contains(sphere, ray.origin, 0)) return started_inside(ray, hit);
    double t;
    return ray.direction != Vec3{} && enters(sphere, ray, t) && ball_hit(sphere, ray, t, hit);
}

/// A ray enters a convex solid once, so a hit on the side is the first. At the circle where the side joins an end cap,
/// t is the same for both up to the square of a rounding. There the ray hits if it hits the sphere of the end or, on
/// the side, if its closest point of the axis is between the ends.
bool raycast(const Capsule& capsule, const Ray& ray, Hit& hit) {
    if (contains(capsule, ray.origin, 0)) return started_inside(ray, hit);
    if (ray.direction == Vec3{}) return false;
    const Vec3 axis = capsule.b - capsule.a;
    double t, along = 0, size = 0;
    bool at_joint = false;
    if (enters(SideCrossing{capsule, ray}, ray.t_max, t)) {
        const Vec3 from = ray.origin - capsule.a;
        const double start = dot(from, axis), way = t * dot(ray.direction, axis), axis_squared = length_squared(axis);
        // The error is 2^-28 of t, and for each product a few roundings of its terms.
        const double from_size = reach(from), axis_size = reach(axis);
        const double terms = (from_size + t * reach(ray.direction)) * axis_size;
        const double error = (0x1p-27 * std::fabs(way) + 0x1p-49 * terms) / axis_squared;
        size = from_size + axis_size;
        along = (start + way) / axis_squared;
        if (along > error && along < 1 - error) return side_hit(capsule, along, size, ray, t, hit);
        const Place place = along < -error || along > 1 + error ? Place::beyond : place_on_axis(capsule, ray, t);
        along = std::clamp(along, 0.0, 1.0);
        if (place == Place::beside) return side_hit(capsule, along, size, ray, t, hit);
        at_joint = place == Place::open;
    }
    const Sphere a{capsule.a, capsule.radius}, b{capsule.b, capsule.radius};
    double t_a = infinity, t_b = infinity;
    const bool enters_a = enters(a, ray, t_a), enters_b = enters(b, ray, t_b);
    if (enters_a && (!enters_b || t_a <= t_b)) return ball_hit(a, ray, t_a, hit);
    if (enters_b) return ball_hit(b, ray, t_b, hit);
    return at_joint && is_nearest_between_ends(capsule, ray) && side_hit(capsule, along, size, ray, t, hit);
}

}  // namespace gphys

// raycast against triangles, watertight and without false hits: no ray passes between triangles that share an edge or a
// corner, and no ray hits a triangle that it just misses.
//
// In the projection along the ray, the ray is the point 0. It passes through the triangle unless 0 is on different
// sides of two edges. The sides are the signs of three scalar triple products (volumes), one for each edge and the ray.
//
// Woop's shear (Woop, Benthin, Wald 2013) computes them in double. If they exceed their error bound, the signs are
// right; otherwise exact arithmetic finds them (exact.h). Exact signs are consistent: triangles that share an edge get
// opposite signs, and the triangles around a corner leave no gap.
//
// For a ray in the triangle's plane all volumes are 0. Then the ray is intersected with the edges within the plane. The
// same code handles degenerate triangles.
#include "foundation/exact.h"
#include "geometry/intersect.h"
#include "geometry/shear.h"

namespace gphys {
namespace {

int sign(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Whether t = numerator / denominator <= t_max; the relative error of t is below 2^-40. `excess` is numerator - t_max
/// * denominator as a polynomial, which is evaluated exactly if t is too close to t_max.
template <class Excess>
bool in_time(double t, double t_max, double denominator, const Excess& excess) {
    if (std::fabs(t - t_max) > 0x1p-40 * std::fabs(t)) return t <= t_max;
    return sign_of(excess) * sign(denominator) <= 0;
}

/// A ray of zero length.
bool crossed_by_point(const Triangle& triangle, const ShearedRay& ray, TriangleCrossing& crossing) {
    if (!contains(triangle, ray.origin, 0)) return false;
    crossing = {0, 0, 0, 0};
    barycentric(triangle, ray.origin, crossing.u, crossing.v);
    return true;
}

// --- Rays in the triangle's plane ---------------------------------------------------------------

struct Corner {
    Vec3 position;
    double u, v;
    double side;  // on which side of the ray's line, within the plane
};

/// A crossing of the ray's line and the outline of the triangle.
struct LineCrossing {
    double t, u, v;
    bool in_time;
};

/// One component of a cross product. That of the direction and (point - origin) is 0 for a point on the line. Its sign
/// is the side of the line, for all points of a plane.
template <class N>
N turn(const Vec<N>& a, const Vec<N>& b, int axis) {
    const auto n = cross(a, b);
    return axis == 0 ? n.x : axis == 1 ? n.y : n.z;
}

LineCrossing crossing_at(const Corner& corner, const ShearedRay& ray) {
    const double from = ray.origin[ray.kz], direction = ray.direction[ray.kz], to = corner.position[ray.kz];
    const double t = (to - from) / direction;
    const bool by_the_end = in_time(t, ray.t_max, direction, [&](auto number) {
        using N = decltype(number);
        return N(to) - N(from) - N(ray.t_max) * two_terms<N>(direction, ray.rest[ray.kz]);
    });
    return {t, corner.u, corner.v, by_the_end};
}

/// With p and q relative to the ray's origin: cross(p + s (q - p), q - p) = t cross(direction, q - p).
LineCrossing crossing_between(const Corner& from, const Corner& to, const ShearedRay& ray, int axis) {
    const auto numerator = [&](auto number) {
        using V = Vec<decltype(number)>;
        return turn(V::difference(from.position, ray.origin), V::difference(to.position, ray.origin), axis);
    };
    const double denominator = to.side - from.side;
    const double t = value_of(numerator) / denominator;
    const bool by_the_end = in_time(t, ray.t_max, denominator, [&](auto number) {
        using N = decltype(number);
        using V = Vec<N>;
        const N slope = turn(V::two_terms(ray.direction, ray.rest), V::difference(to.position, from.position), axis);
        return numerator(number) - N(ray.t_max) * slope;
    });
    const double weight = from.side / (from.side - to.side);
    return {t, from.u + weight * (to.u - from.u), from.v + weight * (to.v - from.v), by_the_end};
}

bool crosses_in_plane(const Triangle& triangle, const ShearedRay& ray, TriangleCrossing& crossing) {
    Corner corners[3] = {{triangle.a, 0, 0, 0}, {triangle.b, 1, 0, 0}, {triangle.c, 0, 1, 0}};
    // All cross products in the plane are parallel, so any axis with a non-zero component will do.
    int axis = 0;
    for (; axis < 3; ++axis) {
        bool turns = false;
        for (Corner& corner : corners) {
            corner.side = value_of([&](auto number) {
                using V = Vec<decltype(number)>;
                return turn(V::two_terms(ray.direction, ray.rest), V::difference(corner.position, ray.origin), axis);
            });
            turns = turns || corner.side != 0;
        }
        if (turns) break;
    }

    LineCrossing first{infinity, 0, 0, false}, last{-infinity, 0, 0, false};
    bool any_in_time = false;
    const auto include = [&](const LineCrossing& c) {
        if (c.t < first.t) first = c;
        if (c.t > last.t) last = c;
        any_in_time = any_in_time || c.in_time;
    };
    for (int i = 0; i < 3; ++i) {
        const Corner &here = corners[i], &next = corners[(i + 1) % 3];
        if (here.side == 0) include(crossing_at(here, ray));
        if (sign(here.side) * sign(next.side) < 0) include(crossing_between(here, next, ray, axis));
    }
    if (last.t < 0 || !any_in_time) return false;
    if (first.t > 0) {
        crossing = {std::min(first.t, ray.t_max), first.u, first.v, 0};
        return true;
    }
    // The origin of the ray is between the two crossings.
    const double weight = first.t < last.t ? first.t / (first.t - last.t) : 0;
    crossing = {0, first.u + weight * (last.u - first.u), first.v + weight * (last.v - first.v), 0};
    return true;
}

// --- Rays through the plane ---------------------------------------------------------------------

/// dot(direction, cross(p, q)), p and q relative to the ray's origin.
auto volume(const ShearedRay& ray, Vec3 p, Vec3 q) {
    return [&ray, p, q](auto number) {
        using V = Vec<decltype(number)>;
        return dot(V::two_terms(ray.direction, ray.rest),
                   cross(V::difference(p, ray.origin), V::difference(q, ray.origin)));
    };
}

/// The volume with its exact sign and a relative error below 2^-44. It is 0 for rays through a corner or an edge. There
/// the coordinates mostly have a range small enough for the integer path.
double accurate_volume(const ShearedRay& ray, Vec3 p, Vec3 q) {
    Vec3 to_p, to_q;
    double value;
    if (ray.rest == Vec3{} && difference_is_exact(p, ray.origin, to_p) && difference_is_exact(q, ray.origin, to_q) &&
        integer_determinant(ray.direction, to_p, to_q, value)) {
        return value;
    }
    return value_of(volume(ray, p, q));
}

/// t, u and v of a ray that is known to pass through the triangle, with relative errors of 2^-43.
void accurate_parameters(const Triangle& triangle, const ShearedRay& ray, double& t, double& u, double& v) {
    const auto along_normal = [&](auto vector) {  // vector(number): the factor to multiply with the normal
        return value_of([&](auto number) {
            using V = Vec<decltype(number)>;
            return dot(cross(V::difference(triangle.b, triangle.a), V::difference(triangle.c, triangle.a)),
                       vector(number));
        });
    };
    const double climb =
        along_normal([&](auto number) { return Vec<decltype(number)>::two_terms(ray.direction, ray.rest); });
    t = along_normal([&](auto number) { return Vec<decltype(number)>::difference(triangle.a, ray.origin); }) / climb;
    u = accurate_volume(ray, triangle.a, triangle.c) / -climb;
    v = accurate_volume(ray, triangle.b, triangle.a) / -climb;
}

}  // namespace

void barycentric(const Triangle& triangle, Vec3 point, double& u, double& v) {
    const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, offset = point - triangle.a;
    const Vec3 normal = cross(ab, ac);
    const double area_squared = length_squared(normal);
    u = area_squared > 0 ? std::clamp(dot(normal, cross(offset, ac)) / area_squared, 0.0, 1.0) : 0;
    v = area_squared > 0 ? std::clamp(dot(normal, cross(ab, offset)) / area_squared, 0.0, 1.0 - u) : 0;
}

ShearedRay::ShearedRay(const Ray& ray) : Ray(ray) {
    const SingleShear<Vec3> shear(ray.direction);
    kx = shear.kx;
    ky = shear.ky;
    kz = shear.kz;
    shear.turn(ray.origin, from);
    speed = shear.speed;
    sx = shear.sx;
    sy = shear.sy;
    end = ray.t_max;
}

bool crosses(const Triangle& triangle, const ShearedRay& ray, TriangleCrossing& crossing) {
    if (ray.speed == 0) return crossed_by_point(triangle, ray, crossing);
    const auto shear = [&](Vec3 corner) {
        const double z = corner[ray.kz] - ray.from[2];
        return Vec3{corner[ray.kx] - ray.from[0] - ray.sx * z, corner[ray.ky] - ray.from[1] - ray.sy * z, z};
    };
    const Vec3 a = shear(triangle.a), b = shear(triangle.b), c = shear(triangle.c);
    const double volume_a = c.x * b.y - c.y * b.x;
    const double volume_b = a.x * c.y - a.y * c.x;
    const double volume_c = b.x * a.y - b.y * a.x;

    // Let u = 2^-53. Offset and product have an error of u each, the slope 3 u if the direction has a rest. So the
    // error of a sheared coordinate is at most 2 u |offset| + 6 u |z| <= 4 u (|coordinate| + 2 |z|) =: e; 5 u covers
    // the terms in u^2. The error of a volume of coordinates up to r then is at most 4 r e + 2 e^2 + 6 u r^2 < 8 e (r +
    // e).
    const Vec3 reach = max(abs(a), max(abs(b), abs(c)));
    const double r = std::max(reach.x, reach.y);
    const double coordinate_error = 5 * 0x1p-53 * (r + 2 * reach.z);
    const double volume_error = 8 * coordinate_error * (r + coordinate_error);
    const double lowest = std::min(volume_a, std::min(volume_b, volume_c));
    const double highest = std::max(volume_a, std::max(volume_b, volume_c));
    if (lowest < -volume_error && highest > volume_error) return false;

    const auto exact_sign = [&](double computed, Vec3 p, Vec3 q) {
        return sign(std::fabs(computed) > volume_error ? computed : accurate_volume(ray, p, q));
    };
    const int sign_a = exact_sign(volume_a, triangle.c, triangle.b);
    const int sign_b = exact_sign(volume_b, triangle.a, triangle.c);
    const int sign_c = exact_sign(volume_c, triangle.b, triangle.a);
    const int least = std::min(sign_a, std::min(sign_b, sign_c)), most = std::max(sign_a, std::max(sign_b, sign_c));
    if (least < 0 && most > 0) return false;
    if (least == 0 && most == 0) return crosses_in_plane(triangle, ray, crossing);
    // The volumes add up to -dot(normal, direction).
    const int facing = least < 0 ? 1 : -1;

    // The error of each weight is at most (1 + 3) volume_error / total; that of z is both, times the spread of z.
    const double total = volume_a + volume_b + volume_c;
    const double weight_error = 4.5 * volume_error;  // times total
    double u, v, t;
    const double spread = std::max(std::fabs(b.z - a.z), std::fabs(c.z - a.z));
    bool accurate = weight_error <= 0x1p-26 * std::fabs(total);
    if (accurate) {
        u = volume_b / total;
        v = volume_c / total;
        const double z = a.z + u * (b.z - a.z) + v * (c.z - a.z);
        const double z_error = 2 * weight_error / std::fabs(total) * spread + 0x1p-50 * reach.z;
        t = z / ray.speed;
        accurate = z_error <= 0x1p-30 * std::fabs(z);
    }
    if (!accurate) accurate_parameters(triangle, ray, t, u, v);
    if (t < 0) return false;
    const bool by_the_end = in_time(t, ray.t_max, facing, [&](auto number) {
        using N = decltype(number);
        using V = Vec<N>;
        const auto normal = cross(V::difference(triangle.b, triangle.a), V::difference(triangle.c, triangle.a));
        return dot(normal, V::difference(triangle.a, ray.origin)) -
               N(ray.t_max) * dot(normal, V::two_terms(ray.direction, ray.rest));
    });
    // The test against t_max was exact, so only rounding can put t beyond it.
    crossing = {std::min(t, ray.t_max), u, v, facing};
    return by_the_end;
}

void make_hit(const Triangle& triangle, const Ray& ray, const TriangleCrossing& crossing, Hit& hit) {
    hit.t = crossing.t;
    const Vec3 normal = accurate_cross(triangle.a, triangle.b, triangle.a, triangle.c);
    if (normal != Vec3{}) {
        hit.normal = normalized(normal) * (crossing.facing > 0 ? -1.0 : 1.0);
    } else {
        hit.normal = ray.direction != Vec3{} ? -normalized(ray.direction) : Vec3{};
    }
    // Adding 0 turns -0 into 0, because the sign of a zero depends on the order of operations.
    hit.u = std::clamp(crossing.u, 0.0, 1.0) + 0.0;
    hit.v = std::clamp(crossing.v, 0.0, 1.0 - hit.u) + 0.0;
    hit.point = ray.direction != Vec3{}
                    ? triangle.a + hit.u * (triangle.b - triangle.a) + hit.v * (triangle.c - triangle.a)
                    : ray.origin;
    hit.flags = (crossing.t == 0 ? GPHYS_HIT_INSIDE : 0) | (crossing.facing > 0 ? GPHYS_HIT_BACK : 0);
}

bool raycast(const Triangle& triangle, const Ray& ray, Hit& hit) {
    const ShearedRay sheared(ray);
    TriangleCrossing crossing;
    if (!crosses(triangle, sheared, crossing)) return false;
    make_hit(triangle, sheared, crossing, hit);
    return true;
}

}  // namespace gphys

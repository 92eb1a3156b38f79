// Where a ray first meets a sphere, capsule, box, plane or frustum. Triangles: raycast_triangle.cpp.
//
// A solid met from inside is met at once: t = 0, GPHYS_HIT_INSIDE. Rounding is kept away from the
// yes or no: where it could decide, the question is asked again in exact arithmetic (exact.h).
#include "foundation/exact.h"
#include "intersect/intersect.h"

namespace gphys {
namespace {

bool has_direction(const Ray& ray) { return ray.direction != Vec3{}; }

bool started_inside(const Ray& ray, Hit& hit) {
    hit = Hit{};
    hit.t = 0;
    hit.point = ray.origin;
    hit.normal = has_direction(ray) ? -normalized(ray.direction) : Vec3{};
    hit.flags = GPHYS_HIT_INSIDE;
    return true;
}

/// dot(normal, point - origin) - distance, with the exact sign.
double height(const Plane& plane, Vec3 origin, Vec3 point) {
    return value_of([&](auto number) {
        using V = VecOf<decltype(number)>;
        return dot(V::of(plane.normal), V::difference(point, origin)) - decltype(number)(plane.distance);
    });
}

/// dot(a, b), with the exact sign.
double accurate_dot(Vec3 a, Vec3 b) {
    return value_of([&](auto number) {
        using V = VecOf<decltype(number)>;
        return dot(V::of(a), V::of(b));
    });
}

/// Whether the end of the ray is still on the side of the plane where it starts, exactly: t_max,
/// which must be finite, is too small.
bool is_beyond_end(const Plane& plane, const Ray& ray, double start) {
    const int end = sign_of([&](auto number) {
        using N = decltype(number);
        const auto normal = VecOf<N>::of(plane.normal);
        return dot(normal, VecOf<N>::of(ray.origin)) + N(ray.t_max) * dot(normal, VecOf<N>::of(ray.direction)) -
               N(plane.distance);
    });
    return start > 0 ? end > 0 : end < 0;
}

/// Whether a curved shape met at t is met before the ray ends. t is off by a few roundings, which
/// must not cost a ray that ends on the surface its hit.
bool reaches(double& t, double t_max) {
    if (t > t_max * (1 + 0x1p-48)) return false;
    t = std::min(t, t_max);
    return true;
}

// --- Sphere -------------------------------------------------------------------------------------

/// The quadratic dd t^2 - 2 b t + c = 0 for the times at which a ray crosses a sphere.
template <class N>
struct Quadratic {
    N dd, b, c;

    Quadratic(const Sphere& sphere, const Ray& ray) {
        const auto from = VecOf<N>::difference(ray.origin, sphere.center);
        const auto direction = VecOf<N>::of(ray.direction);
        dd = dot(direction, direction);
        b = -dot(from, direction);
        c = dot(from, from) - N(sphere.radius) * N(sphere.radius);
    }
};

/// When a ray from outside enters the sphere. The discriminant comes from the vector from the
/// centre perpendicular to the ray, which loses little however far the origin is, and t from the
/// root that adds numbers of one sign (Haines, Guenther, Akenine-Moeller 2019).
bool enters(const Sphere& sphere, const Ray& ray, double& t) {
    const Quadratic<Bounded> quadratic(sphere, ray);
    double b = quadratic.b.value, c = quadratic.c.value;
    const double dd = quadratic.dd.value;
    const Vec3 from = ray.origin - sphere.center;
    const Vec3 perpendicular = from + ray.direction * (b / dd);
    const double from_squared = length_squared(from), perpendicular_squared = length_squared(perpendicular);
    const double radius_squared = sphere.radius * sphere.radius;
    const double discriminant = radius_squared - perpendicular_squared;

    // Each component of `perpendicular` is off by at most 12 half ulps of |from|: 1 of the
    // difference, 4 + 4 of b and dd, 3 of quotient, product and sum. Its square is off by twice
    // that times sqrt(3) |perpendicular|, 42, plus the square of the first, plus 4 of its own.
    const double error =
        0x1p-53 * (48 * std::sqrt(from_squared * perpendicular_squared) + 8 * radius_squared) + 0x1p-96 * from_squared;
    if (discriminant < -error) return false;
    // Not approaching. Were b just positive, below its error, b^2 / dd would be far below that of c.
    if (b <= 0 && c > quadratic.c.error) return false;
    double root = std::sqrt(std::max(discriminant * dd, 0.0));
    // Both errors as parts of t: 2^-30 is 1/64 of what rounding t to a float costs.
    const bool root_is_good = discriminant > error && error * dd <= 0x1p-29 * root * (b + root);
    const bool c_is_good = quadratic.c.error <= 0x1p-30 * c;
    if (!root_is_good || !c_is_good) {
        const Quadratic<Exact> exact(sphere, ray);
        const Exact exact_discriminant = exact.b * exact.b - exact.dd * exact.c;
        if (exact_discriminant.sign() < 0 || exact.b.sign() <= 0) return false;
        b = exact.b.value();
        c = exact.c.value();
        root = std::sqrt(exact_discriminant.value());
    }
    t = c / (b + root);
    return reaches(t, ray.t_max);
}

/// The hit at t on the ball of the given radius around the point of a sphere or capsule's axis.
bool round_hit(Vec3 axis_point, double radius, const Ray& ray, double t, Hit& hit) {
    const Vec3 from_axis = (ray.origin - axis_point) + ray.direction * t;
    const bool has_normal = radius > 0 && from_axis != Vec3{};
    hit = Hit{};
    hit.t = t;
    hit.normal = has_normal ? normalized(from_axis) : -normalized(ray.direction);
    hit.point = has_normal ? axis_point + hit.normal * radius : axis_point;
    return true;
}

// --- Capsule ------------------------------------------------------------------------------------

/// When a ray from outside meets the curved side of a capsule, and where along the axis (0..1).
/// With m the origin relative to a, n = cross(direction, axis): the lines are |dot(m, n)| / |n|
/// apart, which gives the discriminant without the cancellation of b^2 - ac (Lagrange's identity).
bool enters_side(const Capsule& capsule, const Ray& ray, double& t, double& along) {
    const Vec3 axis = capsule.b - capsule.a;
    const Vec3 from = ray.origin - capsule.a;
    const Vec3 n = cross(ray.direction, axis);
    const double nn = length_squared(n), axis_squared = length_squared(axis);
    const double radius_squared = capsule.radius * capsule.radius;
    const double apart = dot(from, n);
    const double discriminant = radius_squared * nn - apart * apart;
    if (nn == 0 || discriminant < 0) return false;
    const Vec3 moment = cross(from, axis);
    const double b = -dot(moment, n);
    if (b <= 0) return false;  // not approaching the axis
    const double c = length_squared(moment) - radius_squared * axis_squared;
    // Inside the infinite cylinder c is negative: then the ray can only enter through an end,
    // which the axis position at t = 0 tells.
    t = std::max(c, 0.0) / (b + std::sqrt(axis_squared * discriminant));
    along = (dot(from, axis) + t * dot(ray.direction, axis)) / axis_squared;
    return along >= 0 && along <= 1 && reaches(t, ray.t_max);
}

// --- Box ----------------------------------------------------------------------------------------

/// The time (face - origin) / direction at which a ray crosses a face of a box.
struct Crossing {
    double face, origin, direction, t;

    Crossing(double face_, double origin_, double direction_)
        : face(face_), origin(origin_), direction(direction_), t((face_ - origin_) / direction_) {}
};

/// Whether a is at or before b, exactly; both are 0 or later. The quotients are within two
/// roundings each, so only those that differ by less than 2^-50 need the products.
bool at_or_before(const Crossing& a, const Crossing& b) {
    if (a.t <= b.t * (1 - 0x1p-50)) return true;
    if (a.t > b.t * (1 + 0x1p-50)) return false;
    const int order = sign_of([&](auto number) {
        using N = decltype(number);
        return (N(a.face) - N(a.origin)) * N(b.direction) - (N(b.face) - N(b.origin)) * N(a.direction);
    });
    const bool flipped = (a.direction < 0) != (b.direction < 0);
    return flipped ? order >= 0 : order <= 0;
}

}  // namespace

bool raycast(const Sphere& sphere, const Ray& ray, Hit& hit) {
    if (contains(sphere, ray.origin, 0)) return started_inside(ray, hit);
    double t;
    return has_direction(ray) && enters(sphere, ray, t) && round_hit(sphere.center, sphere.radius, ray, t, hit);
}

bool raycast(const Capsule& capsule, const Ray& ray, Hit& hit) {
    if (contains(capsule, ray.origin, 0)) return started_inside(ray, hit);
    if (!has_direction(ray)) return false;
    double t, along;
    // Outside of a convex solid a ray enters once: if that is on the side, no end comes earlier.
    if (enters_side(capsule, ray, t, along)) {
        return round_hit(capsule.a + (capsule.b - capsule.a) * along, capsule.radius, ray, t, hit);
    }
    double t_a = infinity, t_b = infinity;
    const bool enters_a = enters({capsule.a, capsule.radius}, ray, t_a);
    const bool enters_b = enters({capsule.b, capsule.radius}, ray, t_b);
    if (enters_a && (!enters_b || t_a <= t_b)) return round_hit(capsule.a, capsule.radius, ray, t_a, hit);
    return enters_b && round_hit(capsule.b, capsule.radius, ray, t_b, hit);
}

/// Slabs (Williams et al. 2005), dividing by the direction instead of multiplying by its
/// reciprocal, and with a direction of 0 apart, so that neither can turn a hit into a miss.
bool raycast(const Aabb& box, const Ray& ray, Hit& hit) {
    const Crossing end(ray.t_max, 0, 1);
    Crossing entry(0, 0, 1), exit = end;
    int entry_axis = -1;  // of the face through which the ray enters; none: it starts inside
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis], direction = ray.direction[axis];
        const double low = box.min[axis], high = box.max[axis];
        const bool below = origin<low, above = origin> high;
        if ((below && direction <= 0) || (above && direction >= 0)) return false;
        if (below || above) {
            const Crossing enters(below ? low : high, origin, direction);
            if (entry_axis < 0 || !at_or_before(enters, entry)) {
                entry = enters;
                entry_axis = axis;
            }
        }
        if (direction != 0) {
            const Crossing leaves(direction > 0 ? high : low, origin, direction);
            if (at_or_before(leaves, exit)) exit = leaves;
        }
    }
    if (entry_axis < 0) return started_inside(ray, hit);
    if (!at_or_before(entry, exit)) return false;
    hit = Hit{};
    hit.t = std::min(entry.t, ray.t_max);
    hit.point = max(box.min, min(box.max, ray.origin + ray.direction * entry.t));
    hit.point[entry_axis] = entry.face;
    hit.normal[entry_axis] = entry.direction > 0 ? -1 : 1;
    return true;
}

/// In the box's own axes around its own centre, in double, nothing of a far origin is lost
/// (Majercik et al. 2018).
bool raycast(const Obb& box, const Ray& ray, Hit& hit) {
    const Ray local{transpose_times(box.axes, ray.origin - box.center), transpose_times(box.axes, ray.direction),
                    ray.t_max};
    Hit local_hit;
    if (!raycast(Aabb{-box.half, box.half}, local, local_hit)) return false;
    if (local_hit.flags & GPHYS_HIT_INSIDE) return started_inside(ray, hit);
    hit = local_hit;
    hit.point = box.center + box.axes * local_hit.point;
    hit.normal = box.axes * local_hit.normal;
    return true;
}

/// A ray in the plane meets it at once.
bool raycast(const Plane& plane, const Ray& ray, Hit& hit) {
    const double start = height(plane, Vec3{}, ray.origin);
    const double climb = accurate_dot(plane.normal, ray.direction);
    if (start != 0 && (start > 0 ? climb >= 0 : climb <= 0)) return false;
    double t = start == 0 ? 0 : -start / climb;
    const bool at_the_end = std::fabs(t - ray.t_max) <= 0x1p-40 * t;
    if (at_the_end ? is_beyond_end(plane, ray, start) : t > ray.t_max) return false;
    t = std::min(t, ray.t_max);
    const bool from_behind = start < 0 || (start == 0 && climb > 0);
    hit = Hit{};
    hit.t = t;
    hit.point = ray.origin + ray.direction * t;
    hit.normal = from_behind ? -normalized(plane.normal) : normalized(plane.normal);
    hit.flags = (start == 0 ? GPHYS_HIT_INSIDE : 0) | (from_behind ? GPHYS_HIT_BACK : 0);
    return true;
}

/// Clips the ray against the half-spaces. A plane without a normal (infinite far plane) is never
/// crossed: its distance alone says on which side everything is.
bool raycast(const Frustum& frustum, const Ray& ray, Hit& hit) {
    double entry = 0, exit = ray.t_max;
    const Plane* entered = nullptr;
    for (const Plane& plane : frustum.planes) {
        const double depth = height(plane, frustum.origin, ray.origin);
        const double climb = accurate_dot(plane.normal, ray.direction);
        if (depth < 0) {
            if (climb <= 0) return false;
            const double t = -depth / climb;
            if (!entered || t > entry) entry = t, entered = &plane;
        } else if (climb < 0) {
            exit = std::min(exit, depth / -climb);
        }
    }
    if (!entered) return started_inside(ray, hit);
    if (entry > exit) return false;
    hit = Hit{};
    hit.t = entry;
    hit.point = ray.origin + ray.direction * entry;
    hit.normal = -normalized(entered->normal);
    return true;
}

bool raycast(const Shape& shape, const Ray& ray, Hit& hit) {
    return std::visit([&](const auto& each) { return raycast(each, ray, hit); }, shape);
}

}  // namespace gphys

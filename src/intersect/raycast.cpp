// Where a ray first meets a box, plane or frustum. Spheres and capsules: raycast_round.cpp, triangles:
// raycast_triangle.cpp.
//
// A solid met from inside is met at once: t = 0, GPHYS_HIT_INSIDE. Rounding is kept away from the
// yes or no: where it could decide, the question is asked again in exact arithmetic (exact.h).
#include "foundation/exact.h"
#include "intersect/intersect.h"

namespace gphys {
namespace {

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

bool started_inside(const Ray& ray, Hit& hit) {
    hit = Hit{};
    hit.t = 0;
    hit.point = ray.origin;
    hit.normal = ray.direction != Vec3{} ? -normalized(ray.direction) : Vec3{};
    hit.flags = GPHYS_HIT_INSIDE;
    return true;
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

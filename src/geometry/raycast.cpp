// raycast against boxes (slabs), planes and frusta (Cyrus-Beck clipping). Spheres and capsules are in
// raycast_round.cpp, triangles in raycast_triangle.cpp.
//
// An origin inside a solid is a hit at t = 0 with GPHYS_HIT_INSIDE. Rounding never decides between hit and miss: if
// the error bound does not settle it, the predicate is evaluated in exact arithmetic (exact.h).
#include "foundation/exact.h"
#include "geometry/intersect.h"
#include "geometry/raycast_box.h"

namespace gphys {
namespace {

/// dot(normal, point - origin) - distance, with the exact sign.
double height(const Plane& plane, Vec3 origin, Vec3 point) {
    return value_of([&](auto number) {
        using V = Vec<decltype(number)>;
        return dot(V::of(plane.normal), V::difference(point, origin)) - decltype(number)(plane.distance);
    });
}

/// dot(normal, direction), with the exact sign.
double climb_along(Vec3 normal, const Ray& ray) {
    if (!ray.is_segment) {
        return value_of([&](auto number) {
            using V = Vec<decltype(number)>;
            return dot(V::of(normal), V::of(ray.direction));
        });
    }
    return value_of([&](auto number) {
        using V = Vec<decltype(number)>;
        return dot(V::of(normal), V::two_terms(ray.direction, ray.rest));
    });
}

/// Whether the ray ends on the side of the plane on which it starts, exactly. t_max must be finite.
bool is_beyond_end(const Plane& plane, const Ray& ray, double start) {
    const int end = sign_of([&](auto number) {
        using N = decltype(number);
        const auto normal = Vec<N>::of(plane.normal);
        return dot(normal, Vec<N>::of(ray.origin)) +
               N(ray.t_max) * dot(normal, Vec<N>::two_terms(ray.direction, ray.rest)) - N(plane.distance);
    });
    return start > 0 ? end > 0 : end < 0;
}

// --- Box ----------------------------------------------------------------------------------------

/// The time (face - origin) / (direction + rest) at which a ray crosses a face of a box.
struct Crossing {
    double face, origin, direction, rest, t;

    Crossing(double face_, double origin_, double direction_, double rest_)
        : face(face_), origin(origin_), direction(direction_), rest(rest_), t((face_ - origin_) / direction_) {}
};

/// Whether a <= b, exactly; both are >= 0. The quotients have at most three roundings each, so only quotients that
/// differ by less than 2^-50 need exact products.
bool at_or_before(const Crossing& a, const Crossing& b) {
    if (a.t <= b.t * (1 - 0x1p-50)) return true;
    if (a.t > b.t * (1 + 0x1p-50)) return false;
    const int order = sign_of([&](auto number) {
        using N = decltype(number);
        return (N(a.face) - N(a.origin)) * two_terms<N>(b.direction, b.rest) -
               (N(b.face) - N(b.origin)) * two_terms<N>(a.direction, a.rest);
    });
    const bool flipped = (a.direction < 0) != (b.direction < 0);
    return flipped ? order >= 0 : order <= 0;
}

/// The exact slab method: quotients instead of products with the reciprocal, and a separate case for direction
/// components of 0. The axis of the face is -1 if the ray starts inside.
bool enters_exactly(const Aabb& box, const Ray& ray, EnteredFace<double>& face, int& entry_axis) {
    const Crossing end(ray.t_max, 0, 1, 0);
    Crossing entry(0, 0, 1, 0), exit = end;
    entry_axis = -1;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis], direction = ray.direction[axis], rest = ray.rest[axis];
        const double low = box.min[axis], high = box.max[axis];
        const bool below = origin<low, above = origin> high;
        if ((below && direction <= 0) || (above && direction >= 0)) return false;
        if (below || above) {
            const Crossing enters(below ? low : high, origin, direction, rest);
            if (entry_axis < 0 || !at_or_before(enters, entry)) {
                entry = enters;
                entry_axis = axis;
            }
        }
        if (direction != 0) {
            const Crossing leaves(direction > 0 ? high : low, origin, direction, rest);
            if (at_or_before(leaves, exit)) exit = leaves;
        }
    }
    face = {entry.t, entry.face, entry.direction, EnteredAxis<double>(std::max(entry_axis, 0))};
    return entry_axis < 0 || at_or_before(entry, exit);
}

// --- Frustum ------------------------------------------------------------------------------------

/// A plane of a frustum and a ray: the height of the origin above the plane, and the speed at which the ray climbs.
struct Approach {
    double depth = 0, climb = 0;  // with exact signs and relative errors below 2^-44

    double t() const { return -depth / climb; }
};

template <class N>
N exact_depth(const Frustum& frustum, int i, const Ray& ray) {
    const Plane& plane = frustum.planes[i];
    using V = Vec<N>;
    return dot(V::of(plane.normal), V::difference(ray.origin, frustum.origin)) - N(plane.distance);
}
template <class N>
N exact_climb(const Frustum& frustum, int i, const Ray& ray) {
    using V = Vec<N>;
    return dot(V::of(frustum.planes[i].normal), V::two_terms(ray.direction, ray.rest));
}

/// Whether the ray enters through plane `in` no later than it leaves through plane `out`, exactly.
bool enters_before(const Frustum& frustum, int in, int out, const Ray& ray) {
    return sign_of([&](auto number) {
               using N = decltype(number);
               return exact_depth<N>(frustum, in, ray) * exact_climb<N>(frustum, out, ray) -
                      exact_depth<N>(frustum, out, ray) * exact_climb<N>(frustum, in, ray);
           }) <= 0;
}
/// Whether the ray enters through a plane before it ends, exactly. t_max is finite.
bool enters_in_time(const Frustum& frustum, int in, const Ray& ray) {
    return sign_of([&](auto number) {
               using N = decltype(number);
               return exact_depth<N>(frustum, in, ray) + N(ray.t_max) * exact_climb<N>(frustum, in, ray);
           }) >= 0;
}

/// Whether the ray enters through all planes that it starts outside of before it leaves through another one or ends.
/// Needed if the last entry and the first exit are too close for double.
bool enters_exactly(const Frustum& frustum, const Approach (&approaches)[6], const Ray& ray, double entry) {
    const double early = entry * (1 - 0x1p-38), late = entry * (1 + 0x1p-38);
    for (int in = 0; in < 6; ++in) {
        if (approaches[in].depth >= 0 || approaches[in].t() < early) continue;
        if (ray.t_max < late && !enters_in_time(frustum, in, ray)) return false;
        for (int out = 0; out < 6; ++out) {
            const Approach& leaves = approaches[out];
            if (leaves.depth < 0 || leaves.climb >= 0 || leaves.t() > late) continue;
            if (!enters_before(frustum, in, out, ray)) return false;
        }
    }
    return true;
}

}  // namespace

Ray ray_along(const Segment& segment) {
    Vec3 rest;
    const Vec3 direction = difference(segment.b, segment.a, rest);
    return {segment.a, direction, 1, rest, true};
}

bool started_inside(const Ray& ray, Hit& hit) {
    hit = Hit{0, ray.origin, ray.direction != Vec3{} ? -normalized(ray.direction) : Vec3{}};
    hit.flags = GPHYS_HIT_INSIDE;
    return true;
}

bool raycast(const Aabb& box, const Ray& ray, Hit& hit) {
    const BoxEntry<double> entry(box.min, box.max, ray.origin, ray.direction, ray.t_max);
    EnteredFace<double> face;
    if (entry.open) {
        int axis;
        if (!enters_exactly(box, ray, face, axis)) return false;
        if (axis < 0) return started_inside(ray, hit);
    } else if (entry.no || entry.inside) {
        return !entry.no && started_inside(ray, hit);
    } else {
        face = entry.face(box.min, box.max, ray.origin, ray.direction);
    }
    hit = Hit{least(ray.t_max, face.t), face.point(box.min, box.max, ray.origin, ray.direction), face.normal()};
    return true;
}

/// In the frame of the box, relative to its centre (Majercik et al. 2018), so that no digits are lost far from the
/// origin.
bool raycast(const Obb& box, const Ray& ray, Hit& hit) {
    Ray local{transpose_times(box.axes, ray.origin - box.center), transpose_times(box.axes, ray.direction), ray.t_max};
    if (ray.is_segment) local.rest = transpose_times(box.axes, ray.rest);
    if (!raycast(Aabb{-box.half, box.half}, local, hit)) return false;
    if (hit.flags & GPHYS_HIT_INSIDE) return started_inside(ray, hit);
    hit.point = box.center + box.axes * hit.point;
    hit.normal = box.axes * hit.normal;
    return true;
}

/// A ray in the plane hits at t = 0.
bool raycast(const Plane& plane, const Ray& ray, Hit& hit) {
    const double start = height(plane, Vec3{}, ray.origin);
    const double climb = climb_along(plane.normal, ray);
    if (start != 0 && (start > 0 ? climb >= 0 : climb <= 0)) return false;
    double t = start == 0 ? 0 : -start / climb;
    const bool at_the_end = std::fabs(t - ray.t_max) <= 0x1p-40 * t;
    if (at_the_end ? is_beyond_end(plane, ray, start) : t > ray.t_max) return false;
    t = std::min(t, ray.t_max);
    const bool from_behind = start < 0 || (start == 0 && climb > 0);
    hit = Hit{t, ray.origin + ray.direction * t, from_behind ? -normalized(plane.normal) : normalized(plane.normal)};
    hit.flags = (start == 0 ? GPHYS_HIT_INSIDE : 0) | (from_behind ? GPHYS_HIT_BACK : 0);
    return true;
}

/// Clips the ray against the half-spaces (Cyrus, Beck 1978). A plane with normal 0, an infinite far plane, is never
/// crossed: the sign of its distance decides whether all points are inside or outside.
bool raycast(const Frustum& frustum, const Ray& ray, Hit& hit) {
    double entry = 0, exit = ray.t_max;
    const Plane* entered = nullptr;
    Approach approaches[6];
    for (int i = 0; i < 6; ++i) {
        const Plane& plane = frustum.planes[i];
        Approach& approach = approaches[i];
        approach = {height(plane, frustum.origin, ray.origin), climb_along(plane.normal, ray)};
        if (approach.depth < 0) {
            if (approach.climb <= 0) return false;
            const double t = approach.t();
            if (!entered || t > entry) entry = t, entered = &plane;
        } else if (approach.climb < 0) {
            exit = std::min(exit, approach.t());
        }
    }
    if (!entered) return started_inside(ray, hit);
    if (entry > exit * (1 + 0x1p-40)) return false;
    if (entry > exit * (1 - 0x1p-40) && !enters_exactly(frustum, approaches, ray, entry)) return false;
    entry = std::min(entry, ray.t_max);
    hit = Hit{entry, ray.origin + ray.direction * entry, -normalized(entered->normal)};
    return true;
}

bool raycast(const Shape& shape, const Ray& ray, Hit& hit) {
    return std::visit([&](const auto& each) { return raycast(each, ray, hit); }, shape);
}

}  // namespace gphys

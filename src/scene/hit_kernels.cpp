#include "scene/hit_kernels.h"

#include "intersect/hit_lanes.h"
#include "octree/ray_lanes.h"

namespace gphys::GPHYS_ISA {

namespace {

struct Matrix8 {
    Vector8 x, y, z;
};
GPHYS_INLINE Vector8 operator*(const Matrix8& m, const Vector8& v) { return m.x * v.x + m.y * v.y + m.z * v.z; }
GPHYS_INLINE Vector8 transpose_times(const Matrix8& m, const Vector8& v) {
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
GPHYS_INLINE Matrix8 rotation_matrix(const Vector8& q, Double8 w) {
    const Double8 s = 2.0 / (q.x * q.x + q.y * q.y + q.z * q.z + w * w);
    const Double8 xx = s * q.x * q.x, yy = s * q.y * q.y, zz = s * q.z * q.z;
    const Double8 xy = s * q.x * q.y, xz = s * q.x * q.z, yz = s * q.y * q.z;
    const Double8 wx = s * w * q.x, wy = s * w * q.y, wz = s * w * q.z;
    return {{1 - yy - zz, xy + wz, xz - wy}, {xy - wz, 1 - xx - zz, yz + wx}, {xz + wy, yz - wx, 1 - xx - yy}};
}

/// The placements of eight models.
struct Worlds8 {
    GPHYS_INLINE explicit Worlds8(const RaysAndModels<Ray>& pairs)
        : Worlds8(Four8([&](int i) { return pairs.model[i]; }), Four8([&](int i) { return pairs.model[i] + 4; })) {}

    Vector8 position, rotation;
    Double8 rotation_w, scale;

    GPHYS_INLINE Matrix8 matrix() const { return rotation_matrix(rotation, rotation_w); }

private:
    GPHYS_INLINE Worlds8(const Four8& a, const Four8& b)
        : position{a.x, a.y, a.z}, rotation{a.w, b.x, b.y}, rotation_w(b.z), scale(b.w) {}
};

struct RaysHere {
    GPHYS_INLINE explicit RaysHere(const RaysAndModels<Ray>& pairs)
        : RaysHere(Rays8([&](int i) -> const Ray& { return *pairs.ray[i]; })) {}

    Vector8 origin, direction;
    Double8 t_max;

private:
    GPHYS_INLINE explicit RaysHere(const Rays8& rays)
        : origin{rays.origin[0], rays.origin[1], rays.origin[2]},
          direction{rays.direction[0], rays.direction[1], rays.direction[2]},
          t_max(rays.t_max) {}
};

GPHYS_INLINE void put(Double8 t, const Vector8& point, const Vector8& normal, Hits8& hits) {
    store(hits.t, t);
    store_quads([&](int i) { return &hits.rounded[i].t; }, rounded_place(t, point));
    store_quads([&](int i) { return &hits.rounded[i].normal.x; }, rounded_normal(normal, splat(0)));
}

Verdicts8 verdicts(DoubleMask8 no, DoubleMask8 yes) { return {bits(no), bits(yes)}; }

// --- Spheres (raycast_round.cpp) -----------------------------------------------------------------

Verdicts8 spheres(const RaysAndModels<Ray>& pairs, Hits8& hits) {
    const Worlds8 world(pairs);
    const Four8 sphere([&](int i) { return pairs.other[i]; });
    const Vector8 center = world.position + world.matrix() * (Vector8{sphere.x, sphere.y, sphere.z} * world.scale);
    const Double8 radius = sphere.w * world.scale;

    const RaysHere ray(pairs);
    const Vector8 from = ray.origin - center;
    const Vector8 moment = cross(from, ray.direction);
    const Double8 rr = radius * radius, a = dot(ray.direction, ray.direction), b = -dot(from, ray.direction);
    const Double8 c = dot(from, from) - rr, discriminant = rr * a - dot(moment, moment);
    // SphereCrossing::rounding_of
    constexpr double unit = 0x1p-53;
    const Double8 reach = sum(absolute(from)), product = reach * sum(absolute(ray.direction)), e = 7 * unit * product;
    const Double8 length_of_moment = square_root(largest(rr * a - discriminant, 0.0));
    const Double8 b_error = 6 * unit * product, c_error = unit * (6 * reach * reach + 3 * rr);
    const Double8 discriminant_error =
        (2 * length_of_moment + e) * e + 4 * unit * length_of_moment * length_of_moment + 9 * unit * rr * a;

    const Double8 root = square_root(largest(discriminant, 0.0)), way = b + root;
    const DoubleMask8 outside = c_error < c;
    const DoubleMask8 good = outside & (discriminant_error < discriminant) & (c_error <= 0x1p-30 * c) &
                             (b_error <= 0x1p-30 * way) & (discriminant_error <= 0x1p-29 * root * way) & (0 < way);
    const Double8 t = select(good, c, 0.0) / select(good, way, 1.0);
    const DoubleMask8 clear = good & (0x1p-27 * t < absolute(t - ray.t_max));
    const DoubleMask8 in_time = t <= ray.t_max;
    const DoubleMask8 no = outside & ((discriminant < -discriminant_error) | (b < -b_error) | (clear & !in_time));

    // round_hit
    const Vector8 from_axis = from + ray.direction * t;
    const Double8 size = max_component(absolute(from_axis));
    const DoubleMask8 has_normal = (0 < radius) & (0 < size);
    const Vector8 normal = normalized(select(has_normal, from_axis, {1.0, 0.0, 0.0}));
    put(t, center + normal * radius, normal, hits);
    return verdicts(no, clear & in_time & !no & has_normal);
}

// --- Boxes (raycast.cpp) -------------------------------------------------------------------------

/// Rays and boxes along the axes of coordinates.
struct Slabs8 {
    Vector8 origin, direction, low, high;
};

/// Where each ray comes through the last of the three slabs that it has to enter.
struct Entry8 {
    Double8 t;
    Vector8 point, normal;
    DoubleMask8 no, yes;

    GPHYS_INLINE Entry8(const Slabs8& slabs, Double8 t_max) {
        constexpr double more = 1 + 0x1p-49;
        const Double8 origins[3] = {slabs.origin.x, slabs.origin.y, slabs.origin.z};
        const Double8 directions[3] = {slabs.direction.x, slabs.direction.y, slabs.direction.z};
        const Double8 lows[3] = {slabs.low.x, slabs.low.y, slabs.low.z};
        const Double8 highs[3] = {slabs.high.x, slabs.high.y, slabs.high.z};
        Double8 latest = -infinity, second = -infinity, exit = t_max, face, origin, direction;
        DoubleMask8 outside, behind, across, on_axis[3];
        for (int k = 0; k < 3; ++k) {
            const DoubleMask8 still = absolute(directions[k]) <= 0;
            const Double8 speed = select(still, 1.0, directions[k]), inverse = 1 / speed;
            const Double8 to_low = (lows[k] - origins[k]) * inverse, to_high = (highs[k] - origins[k]) * inverse;
            const Double8 near = least(to_high, to_low), far = largest(to_low, to_high);
            const DoubleMask8 below = origins[k] < lows[k], above = highs[k] < origins[k], backward = speed < 0;
            const DoubleMask8 out = below | above, away = (below & backward) | (above & !backward);
            const DoubleMask8 later = latest < near;
            outside = k == 0 ? out : outside | out;
            behind = k == 0 ? away : behind | away;
            across = k == 0 ? still : across | still;
            on_axis[k] = later;
            for (int earlier = 0; earlier < k; ++earlier) on_axis[earlier] = on_axis[earlier] & !later;
            face =
                k == 0 ? select(backward, highs[k], lows[k]) : select(later, select(backward, highs[k], lows[k]), face);
            origin = k == 0 ? origins[k] : select(later, origins[k], origin);
            direction = k == 0 ? speed : select(later, speed, direction);
            second = largest(second, least(latest, near));
            latest = largest(latest, near);
            exit = least(far, exit);
        }
        const DoubleMask8 known = !across, late = exit * more < latest;
        no = known & (behind | (outside & late));
        yes = known & outside & !no & (latest * more < exit) & (second * more < latest);
        const Double8 entry = (face - origin) / direction, sign = -with_sign(1.0, direction);
        const Vector8 at = slabs.origin + slabs.direction * entry;
        const auto coordinate = [&](int k, Double8 v) {
            return select(on_axis[k], face, largest(lows[k], least(v, highs[k])));
        };
        t = least(t_max, entry);
        point = {coordinate(0, at.x), coordinate(1, at.y), coordinate(2, at.z)};
        normal = {select(on_axis[0], sign, 0.0), select(on_axis[1], sign, 0.0), select(on_axis[2], sign, 0.0)};
    }
};

/// Boxes with axes of their own.
struct Turned8 {
    Vector8 center, half;
    Matrix8 axes;

    GPHYS_INLINE Slabs8 slabs(const RaysHere& ray) const {
        return {transpose_times(axes, ray.origin - center), transpose_times(axes, ray.direction), -half, half};
    }
    GPHYS_INLINE Vector8 point(const Vector8& local) const { return center + axes * local; }
    GPHYS_INLINE Vector8 normal(const Vector8& local) const { return axes * local; }
};

Verdicts8 aabbs(const RaysAndModels<Ray>& pairs, Hits8& hits) {
    const Worlds8 world(pairs);
    const Four8 a([&](int i) { return pairs.model[i] + shape_at; });
    const Four8 b([&](int i) { return pairs.model[i] + shape_at + 2; });
    const Vector8 low{a.x, a.y, a.z}, high{b.y, b.z, b.w};
    const RaysHere ray(pairs);
    // One that is not turned keeps its faces.
    const DoubleMask8 turned = 0 < sum(absolute(world.rotation));
    if (!any(turned)) {
        const Entry8 entry(
            {ray.origin, ray.direction, world.position + low * world.scale, world.position + high * world.scale},
            ray.t_max);
        put(entry.t, entry.point, entry.normal, hits);
        return verdicts(entry.no, entry.yes);
    }
    const Matrix8 matrix = world.matrix();
    const Turned8 box{world.position + matrix * ((low + high) * 0.5 * world.scale), (high - low) * 0.5 * world.scale,
                      matrix};
    const Slabs8 slabs = box.slabs(ray);
    const Entry8 entry({select(turned, slabs.origin, ray.origin), select(turned, slabs.direction, ray.direction),
                        select(turned, slabs.low, world.position + low * world.scale),
                        select(turned, slabs.high, world.position + high * world.scale)},
                       ray.t_max);
    put(entry.t, select(turned, box.point(entry.point), entry.point),
        select(turned, box.normal(entry.normal), entry.normal), hits);
    return verdicts(entry.no, entry.yes);
}

Verdicts8 obbs(const RaysAndModels<Ray>& pairs, Hits8& hits) {
    const Worlds8 world(pairs);
    const Four8 a([&](int i) { return pairs.model[i] + shape_at; });
    const Four8 b([&](int i) { return pairs.model[i] + shape_at + 2; });
    const Four8 q([&](int i) { return pairs.other[i]; });
    const Matrix8 outer = world.matrix(), inner = rotation_matrix({q.x, q.y, q.z}, q.w);
    const Turned8 box{world.position + outer * (Vector8{a.x, a.y, a.z} * world.scale),
                      Vector8{b.y, b.z, b.w} * world.scale,
                      {outer * inner.x, outer * inner.y, outer * inner.z}};
    const RaysHere ray(pairs);
    const Entry8 entry(box.slabs(ray), ray.t_max);
    put(entry.t, box.point(entry.point), box.normal(entry.normal), hits);
    return verdicts(entry.no, entry.yes);
}

// --- Meshes --------------------------------------------------------------------------------------

/// By the point of the ray that is closest to the centre (as Haines et al. 2019 find a sphere, so that
/// little is lost far away). The ball, the ray in the mesh's own space and this point are some dozens of
/// roundings of 2^-53 of their coordinates off; 2^-43 stands for a thousand.
uint32_t miss_balls(const RaysAndModels<Ray>& pairs) {
    const Worlds8 world(pairs);
    const Four8 ball([&](int i) { return pairs.other[i]; });
    const Vector8 center = Vector8{ball.x, ball.y, ball.z} * world.scale;
    const Double8 radius = ball.w * world.scale;
    const RaysHere ray(pairs);
    const Vector8 from = ray.origin - (world.position + world.matrix() * center);
    const Double8 magnitude =
        sum(absolute(ray.origin)) + sum(absolute(world.position)) + sum(absolute(center)) + radius;

    const Double8 squared = dot(ray.direction, ray.direction);
    const DoubleMask8 moves = 0 < squared;
    const Double8 way = select(moves, -dot(from, ray.direction), 0.0) / select(moves, squared, 1.0);
    const Vector8 closest = from + ray.direction * least(ray.t_max, largest(way, 0.0));
    const Double8 reach = radius + 0x1p-43 * magnitude;
    return bits(reach * reach * (1 + 0x1p-43) < dot(closest, closest));
}

}  // namespace

extern const HitKernels hit_kernels{double_register_lanes > 2, spheres, aabbs, obbs, miss_balls};

}  // namespace gphys::GPHYS_ISA

// The kernels of hit_kernels.h. Each repeats the steps of a scalar test, named above it, with one pair in each lane;
// branches become selections, and undecided lanes are in neither mask.
#include "scene/hit_kernels.h"

#include "bvh/ray_lanes.h"
#include "foundation/compiler.h"
#include "foundation/rotation.h"
#include "geometry/hit_lanes.h"
#include "geometry/raycast_box.h"
#include "geometry/raycast_sphere.h"

namespace gphys::GPHYS_ISA {
namespace {

/// The transforms of eight models.
struct Worlds8 {
    GPHYS_INLINE explicit Worlds8(const RaysAndModels<Ray>& pairs)
        : Worlds8(Four8([&](int i) { return pairs.model[i]; }), Four8([&](int i) { return pairs.model[i] + 4; })) {}

    Vec<Double8> position;
    Quaternion<Double8> rotation;
    Double8 scale;

private:
    GPHYS_INLINE Worlds8(const Four8& a, const Four8& b)
        : position{a.x, a.y, a.z}, rotation{a.w, b.x, b.y, b.z}, scale(b.w) {}
};

/// Eight rays in world space.
struct WorldRays8 {
    GPHYS_INLINE explicit WorldRays8(const RaysAndModels<Ray>& pairs)
        : WorldRays8(Rays8([&](int i) -> const Ray& { return *pairs.ray[i]; })) {}

    Vec<Double8> origin, direction;
    Double8 t_max;

private:
    GPHYS_INLINE explicit WorldRays8(const Rays8& rays)
        : origin(rays.origin), direction(rays.direction), t_max(rays.t_max) {}
};

GPHYS_INLINE void store_hits(Double8 t, const Vec<Double8>& point, const Vec<Double8>& normal, Hits8& hits) {
    store(hits.t, t);
    store_quads([&](int i) { return &hits.rounded[i].t; }, rounded_place(t, point));
    store_quads([&](int i) { return &hits.rounded[i].normal.x; }, rounded_normal(normal, splat(0)));
}

/// Only t, for kernels of distances.
GPHYS_INLINE void store_hits(Double8 t, const Vec<Double8>&, const Vec<Double8>&, float (&to)[8]) {
    store(to, rounded_distance(t));
}

TriStates8 tri_states(DoubleMask8 no, DoubleMask8 yes) { return {bits(no), bits(yes)}; }

// --- Spheres (raycast_round.cpp) -----------------------------------------------------------------

/// Scalar form: raycast(Sphere, Ray, Hit&).
template <class Answers>
TriStates8 spheres(const RaysAndModels<Ray>& pairs, Answers& hits) {
    const Worlds8 world(pairs);
    const Four8 sphere([&](int i) { return pairs.other[i]; });
    const Vec<Double8> center =
        world.position + rotation_matrix(world.rotation) * (Vec<Double8>{sphere.x, sphere.y, sphere.z} * world.scale);
    const Double8 radius = sphere.w * world.scale;

    const WorldRays8 ray(pairs);
    const Vec<Double8> from = ray.origin - center;
    const auto q = sphere_quadratic(from, ray.direction, radius);
    const auto error = sphere_error(from, ray.direction, radius, q);
    const Double8 root = square_root(largest(q.discriminant, 0.0)), denominator = q.b + root, c = q.c;
    const DoubleMask8 outside = error.c < c;
    const DoubleMask8 good = outside & is_accurate(q, error, Double8(1.0), root, denominator) & (0 < denominator);
    const Double8 t = select(good, c, 0.0) / select(good, denominator, 1.0);
    const DoubleMask8 clear = good & (0x1p-27 * t < absolute(t - ray.t_max));
    const DoubleMask8 in_time = t <= ray.t_max;
    const DoubleMask8 no = outside & ((q.discriminant < -error.discriminant) | (q.b < -error.b) | (clear & !in_time));

    // ball_hit, except where is_coarse (capsule_axis.h) or grazing: there the normal needs more arithmetic.
    const Vec<Double8> from_axis = from + ray.direction * t;
    const Double8 size = max_component(abs(from_axis));
    const DoubleMask8 has_normal =
        (0 < radius) & (0 < size) & (sum(abs(from)) <= radius * 0x1p21) & (dot(from_axis, ray.direction) < 0);
    const Vec<Double8> normal = normalized(select(has_normal, from_axis, {1.0, 0.0, 0.0}));
    store_hits(t, center + normal * radius, normal, hits);
    return tri_states(no, clear & in_time & !no & has_normal);
}

// --- Boxes (raycast.cpp) -------------------------------------------------------------------------

/// Rays and boxes in a space where the boxes are axis-aligned.
struct Slabs8 {
    Vec<Double8> origin, direction, low, high;
};

/// Entries of rays into boxes: raycast.cpp's test of a box.
struct Entry8 {
    Double8 t;
    Vec<Double8> point, normal;
    DoubleMask8 no, yes;

    GPHYS_INLINE Entry8(const Slabs8& slabs, Double8 t_max) {
        const BoxEntry<Double8> entry(slabs.low, slabs.high, slabs.origin, slabs.direction, t_max);
        no = entry.no & !entry.open;
        yes = !(entry.no | entry.open | entry.inside);
        const auto face = entry.face(slabs.low, slabs.high, slabs.origin, slabs.direction);
        t = least(t_max, face.t);
        point = face.point(slabs.low, slabs.high, slabs.origin, slabs.direction);
        normal = face.normal();
    }
};

/// Boxes with rotations.
struct RotatedBoxes8 {
    Vec<Double8> center, half;
    Matrix<Double8> axes;

    GPHYS_INLINE Slabs8 slabs(const WorldRays8& ray) const {
        return {transpose_times(axes, ray.origin - center), transpose_times(axes, ray.direction), -half, half};
    }
    GPHYS_INLINE Vec<Double8> point(const Vec<Double8>& local) const { return center + axes * local; }
    GPHYS_INLINE Vec<Double8> normal(const Vec<Double8>& local) const { return axes * local; }
};

/// Scalar form: raycast(Aabb, Ray, Hit&), or of an Obb for lanes with a rotation.
template <class Answers>
TriStates8 aabbs(const RaysAndModels<Ray>& pairs, Answers& hits) {
    const Worlds8 world(pairs);
    const Four8 a([&](int i) { return pairs.model[i] + shape_at; });
    const Four8 b([&](int i) { return pairs.model[i] + shape_at + 2; });
    const Vec<Double8> low{a.x, a.y, a.z}, high{b.y, b.z, b.w};
    const WorldRays8 ray(pairs);
    // A box without rotation keeps its exact faces, as in with_placed (placed.h).
    const DoubleMask8 rotated = 0 < sum(abs(Vec<Double8>{world.rotation.x, world.rotation.y, world.rotation.z}));
    if (!any(rotated)) {
        const Entry8 entry(
            {ray.origin, ray.direction, world.position + low * world.scale, world.position + high * world.scale},
            ray.t_max);
        store_hits(entry.t, entry.point, entry.normal, hits);
        return tri_states(entry.no, entry.yes);
    }
    const Matrix<Double8> matrix = rotation_matrix(world.rotation);
    const RotatedBoxes8 box{world.position + matrix * ((low + high) * 0.5 * world.scale),
                            (high - low) * 0.5 * world.scale, matrix};
    const Slabs8 slabs = box.slabs(ray);
    const Entry8 entry({select(rotated, slabs.origin, ray.origin), select(rotated, slabs.direction, ray.direction),
                        select(rotated, slabs.low, world.position + low * world.scale),
                        select(rotated, slabs.high, world.position + high * world.scale)},
                       ray.t_max);
    store_hits(entry.t, select(rotated, box.point(entry.point), entry.point),
               select(rotated, box.normal(entry.normal), entry.normal), hits);
    return tri_states(entry.no, entry.yes);
}

/// Scalar form: raycast(Obb, Ray, Hit&).
template <class Answers>
TriStates8 obbs(const RaysAndModels<Ray>& pairs, Answers& hits) {
    const Worlds8 world(pairs);
    const Four8 a([&](int i) { return pairs.model[i] + shape_at; });
    const Four8 b([&](int i) { return pairs.model[i] + shape_at + 2; });
    const Four8 q([&](int i) { return pairs.other[i]; });
    const Matrix<Double8> outer = rotation_matrix(world.rotation),
                          inner = rotation_matrix(Quaternion<Double8>{q.x, q.y, q.z, q.w});
    const RotatedBoxes8 box{world.position + outer * (Vec<Double8>{a.x, a.y, a.z} * world.scale),
                            Vec<Double8>{b.y, b.z, b.w} * world.scale, outer * inner};
    const WorldRays8 ray(pairs);
    const Entry8 entry(box.slabs(ray), ray.t_max);
    store_hits(entry.t, box.point(entry.point), box.normal(entry.normal), hits);
    return tri_states(entry.no, entry.yes);
}

// --- Meshes --------------------------------------------------------------------------------------

/// Whether the point of the ray that is closest to the centre is certainly outside the sphere. The errors of sphere,
/// ray and point are some dozens of roundings of 2^-53 of their coordinates; 2^-43 covers a thousand.
uint32_t miss_balls(const RaysAndModels<Ray>& pairs) {
    const Worlds8 world(pairs);
    const Four8 ball([&](int i) { return pairs.other[i]; });
    const Vec<Double8> center = Vec<Double8>{ball.x, ball.y, ball.z} * world.scale;
    const Double8 radius = ball.w * world.scale;
    const WorldRays8 ray(pairs);
    const Vec<Double8> from = ray.origin - (world.position + rotation_matrix(world.rotation) * center);
    const Double8 magnitude = sum(abs(ray.origin)) + sum(abs(world.position)) + sum(abs(center)) + radius;

    const Double8 squared = dot(ray.direction, ray.direction);
    const Vec<Double8> closest = closest_on_ray(from, ray.direction, select(0 < squared, squared, 1.0), ray.t_max);
    const Double8 reach = radius + 0x1p-43 * magnitude;
    return bits(reach * reach * (1 + 0x1p-43) < dot(closest, closest));
}

}  // namespace

extern const HitKernels hit_kernels{spheres<Hits8>,  aabbs<Hits8>,   obbs<Hits8>, spheres<float[8]>,
                                    aabbs<float[8]>, obbs<float[8]>, miss_balls};

}  // namespace gphys::GPHYS_ISA

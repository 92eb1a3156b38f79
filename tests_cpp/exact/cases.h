// Random shapes, rays and points, most of them hard cases. Each case has one of these kinds of coordinates:
//
// - whole numbers, for which nearly all shapes touch or are coplanar, collinear or equal; also times a power of two
// - millimetres to 1e7 metres
// - far from the origin
// - scaled by another power of two on each axis (slivers to 1e6 : 1)
// - numbers below the smallest normal float
// - numbers of very different size, whose differences are not doubles
//
// Then some coordinates are changed by an ulp or two.
#pragma once

#include <cfloat>

#include "effort.h"
#include "geometry/intersect.h"
#include "test.h"

namespace test {

using gphys::narrow;
using gphys::Vec3;
using gphys::widen;

constexpr gphys_shape_type type_of(const gphys_sphere&) { return GPHYS_SHAPE_SPHERE; }
constexpr gphys_shape_type type_of(const gphys_capsule&) { return GPHYS_SHAPE_CAPSULE; }
constexpr gphys_shape_type type_of(const gphys_aabb&) { return GPHYS_SHAPE_AABB; }
constexpr gphys_shape_type type_of(const gphys_obb&) { return GPHYS_SHAPE_OBB; }
constexpr gphys_shape_type type_of(const gphys_plane&) { return GPHYS_SHAPE_PLANE; }
constexpr gphys_shape_type type_of(const gphys_triangle&) { return GPHYS_SHAPE_TRIANGLE; }
constexpr gphys_shape_type type_of(const gphys_frustum&) { return GPHYS_SHAPE_FRUSTUM; }
constexpr gphys_shape_type type_of(const gphys_segment&) { return GPHYS_SHAPE_SEGMENT; }
constexpr gphys_shape_type type_of(const gphys_ray&) { return GPHYS_SHAPE_RAY; }

/// The largest magnitude of a component.
inline double largest(Vec3 v) { return max_component(abs(v)); }

/// The unit in the last place of a float of this size.
inline double ulp_of(double size) {
    const float nearest = std::fabs(static_cast<float>(size));
    return static_cast<double>(std::nextafterf(nearest, FLT_MAX)) - static_cast<double>(nearest);
}

/// Numbers of very different size, up to 2^20: the computed sines and cosines of right angles, which are not 0 (6.1e-17
/// and multiples), simple fractions, powers of two.
inline float mixed_number(Random& random) {
    constexpr float least_cosine = 0x1.1a6264p-54f;  // of the double nearest to pi / 2, in float
    const float sign = random.index(2) ? 1.0f : -1.0f;
    const float small = static_cast<float>(1 + random.index(4));
    switch (random.index(8)) {
        case 0:
            return 0;
        case 1:
        case 2:
            return sign;
        case 3:
            return sign * (random.index(2) ? .5f : .25f);
        case 4:
            return sign * least_cosine;
        case 5:
            return sign * least_cosine * small;
        case 6:
            return sign * small * std::ldexp(1.0f, static_cast<int>(random.index(81)) - 60);
        default:
            return sign * small * std::numeric_limits<float>::denorm_min();
    }
}

class Cases {
public:
    explicit Cases(uint64_t seed) : random(seed_of_part(seed)) { next(); }

    Random random;

    bool one_in(uint32_t n) { return random.index(n) == 0; }

    /// Begins another case, with another kind of coordinates.
    void next() {
        kind_ = static_cast<Kind>(random.index(8));
        offset_ = {};
        stretch_ = {1, 1, 1};
        scale_ = 1;
        switch (kind_) {
            case Kind::scaled_lattice:
                scale_ = std::ldexp(1.0, static_cast<int>(random.index(41)) - 20);
                break;
            case Kind::any_scale:
                scale_ = std::pow(10.0, random.uniform(-3, 7));
                break;
            case Kind::far:
                scale_ = std::pow(10.0, random.uniform(-2, 3));
                for (int k = 0; k < 3; ++k) offset_[k] = random.uniform(-1e7, 1e7);
                break;
            case Kind::stretched:
                for (int k = 0; k < 3; ++k) stretch_[k] = std::ldexp(1.0, static_cast<int>(random.index(21)) - 10);
                break;
            case Kind::subnormal:
                scale_ = 0x1p-149;
                break;
            case Kind::lattice:
            case Kind::usual:
            case Kind::mixed:
                break;
        }
        whole_ = kind_ == Kind::lattice || kind_ == Kind::scaled_lattice || kind_ == Kind::subnormal ||
                 (kind_ == Kind::stretched && one_in(2));
    }

    double scale() const { return scale_; }
    bool is_subnormal() const { return kind_ == Kind::subnormal; }

    gphys_vec3 point() {
        gphys_vec3 p = narrow(offset_ + offset());
        if (one_in(6)) nudge(p.x);
        if (one_in(6)) nudge(p.y);
        if (one_in(6)) nudge(p.z);
        return p;
    }
    /// One of the given points, or a point between them, or near them.
    gphys_vec3 point_by(const gphys_vec3& a, const gphys_vec3& b, const gphys_vec3& c) {
        gphys_vec3 p = a;
        switch (random.index(5)) {
            case 0:
                break;
            case 1:
                p = between(a, b, random.uniform(0, 1), 0, c);
                break;
            case 2:
                p = between(a, b, random.uniform(-.2, 1.2), random.uniform(-.2, 1.2), c);
                break;
            case 3:
                p = between(a, b, .5, 0, c);
                break;
            default:
                return point();
        }
        if (one_in(3)) nudge(p);
        return p;
    }
    /// A length of the size of the coordinates; sometimes 0.
    float size() {
        if (one_in(12)) return 0;
        if (kind_ == Kind::mixed) return std::fabs(mixed_number(random));
        const double full = whole_ ? 1 + random.index(3) : random.uniform(0, 1);
        float value = static_cast<float>(full * scale_);
        if (one_in(6)) nudge(value);
        return std::fabs(value);
    }
    void nudge(float& value) {
        const int steps = static_cast<int>(random.index(2)) + 1;
        const float towards = one_in(2) ? FLT_MAX : -FLT_MAX;
        for (int i = 0; i < steps; ++i) value = std::nextafterf(value, towards);
    }
    void nudge(gphys_vec3& p) {
        if (one_in(2)) nudge(p.x);
        if (one_in(2)) nudge(p.y);
        if (one_in(2)) nudge(p.z);
    }
    /// The identity, a rotation by 90 or 180 degrees, by a tiny angle, or by any angle.
    gphys_quat rotation() {
        const float half = static_cast<float>(std::sqrt(.5));
        switch (random.index(6)) {
            case 0:
                return {0, 0, 0, 1};
            case 1:
                return {0, half, 0, half};
            case 2:
                return {1, 0, 0, 0};
            case 3: {
                const Vec3 axis = random.direction() * std::pow(10.0, random.uniform(-8, -2));
                return narrow(normalized(gphys::Quat{axis.x, axis.y, axis.z, 1}));
            }
            case 4:
                return {.6f, 0, .8f, 0};
            default:
                return random.rotation();
        }
    }
    gphys_vec3 direction() {
        for (;;) {
            gphys_vec3 d = narrow(offset());
            if (one_in(5)) nudge(d);
            if (one_in(8)) d.x = 0;
            if (one_in(8)) d.y = 0;
            if (widen(d) != Vec3{}) return d;
        }
    }

    void make(gphys_sphere& s) { s = {point(), size()}; }
    void make(gphys_capsule& c) {
        c.a = point();
        c.b = one_in(12) ? c.a : point();
        c.radius = size() * (one_in(4) ? 1e-3f : .5f);
    }
    void make(gphys_aabb& b) {
        const Vec3 p = widen(point()), q = widen(point());
        b = {narrow(min(p, q)), narrow(max(p, q))};
    }
    void make(gphys_obb& b) { b = {point(), {size(), size(), size()}, rotation()}; }
    void make(gphys_plane& p) {
        p.normal = whole_ ? narrow(lattice_vector()) : narrow(random.direction());
        const Vec3 through = widen(point());
        p.distance = static_cast<float>(dot(widen(p.normal), through));
    }
    void make(gphys_triangle& t) {
        t = {point(), point(), point()};
        if (one_in(8)) t.c = between(t.a, t.b, random.uniform(-1, 2), 0, t.a);  // a needle
        if (one_in(20)) t.b = t.a;
    }
    void make(gphys_segment& s) {
        s.a = point();
        s.b = one_in(12) ? s.a : point();
    }

    /// A ray; most pass the target within rounding.
    gphys_ray ray_to(const gphys_vec3& target) {
        gphys_ray ray;
        ray.origin = point();
        if (one_in(3)) {
            // From a distance, at which the rounding error is large.
            const Vec3 back = random.direction() * (scale_ * std::pow(10.0, random.uniform(0, 5)));
            ray.origin = narrow(widen(ray.origin) + back);
        }
        const Vec3 towards = widen(target) - widen(ray.origin);
        ray.direction = narrow(towards);
        if (one_in(4)) ray.direction = narrow(towards * random.uniform(.1, 3));
        if (one_in(4)) nudge(ray.direction);
        if (one_in(6)) ray.direction.x = 0;
        if (one_in(6)) ray.direction = narrow(lattice_vector());
        if (one_in(12)) ray.origin = target;
        if (widen(ray.direction) == Vec3{}) ray.direction = direction();
        ray.t_max = one_in(2) ? INFINITY : one_in(2) ? 1.0f : random.uniform_float(0, 2);
        return ray;
    }

    gphys_vec3 between(gphys_vec3 a, gphys_vec3 b, double s, double t, gphys_vec3 c) {
        const Vec3 origin = widen(a);
        return narrow(origin + (widen(b) - origin) * s + (widen(c) - origin) * t);
    }
    Vec3 lattice_vector() {
        for (;;) {
            const Vec3 v{double(random.index(5)) - 2, double(random.index(5)) - 2, double(random.index(5)) - 2};
            if (v != Vec3{}) return v;
        }
    }

private:
    enum class Kind { lattice, scaled_lattice, usual, any_scale, far, stretched, subnormal, mixed };

    Vec3 offset() {
        Vec3 v;
        if (kind_ == Kind::mixed) {
            for (int k = 0; k < 3; ++k) v[k] = mixed_number(random);
            return v;
        }
        for (int k = 0; k < 3; ++k) {
            const double unit = whole_ ? double(random.index(9)) - 4 : random.uniform(-1, 1);
            v[k] = unit * scale_ * stretch_[k];
        }
        return v;
    }

    Kind kind_ = Kind::usual;
    bool whole_ = false;
    double scale_ = 1;
    Vec3 offset_, stretch_;
};

/// A point on or in a shape, as a target of rays and other shapes: a corner, or on an edge, on a face or inside.
inline gphys_vec3 target_on(Cases& c, const gphys_sphere& s) {
    if (c.one_in(4)) return s.center;
    const Vec3 out = c.one_in(3) ? widen(c.direction()) : c.random.direction();
    return narrow(widen(s.center) + normalized(out) * s.radius);
}
inline gphys_vec3 target_on(Cases& c, const gphys_capsule& s) {
    const gphys_vec3 core = c.one_in(3) ? s.a : c.between(s.a, s.b, c.random.uniform(0, 1), 0, s.a);
    return target_on(c, gphys_sphere{core, s.radius});
}
inline gphys_vec3 target_on(Cases& c, const gphys_aabb& b) {
    const auto pick = [&](float low, float high) {
        switch (c.random.index(3)) {
            case 0:
                return low;
            case 1:
                return high;
            default:
                return static_cast<float>(c.random.uniform(low, high));
        }
    };
    const float x = pick(b.min.x, b.max.x), y = pick(b.min.y, b.max.y), z = pick(b.min.z, b.max.z);
    return {x, y, z};
}
inline gphys_vec3 target_on(Cases& c, const gphys_obb& b) {
    const gphys_vec3 h = b.half_extents;
    const Vec3 local = widen(target_on(c, gphys_aabb{{-h.x, -h.y, -h.z}, h}));
    return narrow(widen(b.center) + rotation_matrix(widen(b.rotation)) * local);
}
inline gphys_vec3 target_on(Cases& c, const gphys_plane& p) {
    const Vec3 n = widen(p.normal), any = widen(c.point());
    return narrow(any + n * ((p.distance - dot(n, any)) / length_squared(n)));
}
inline gphys_vec3 target_on(Cases& c, const gphys_triangle& t) {
    switch (c.random.index(3)) {
        case 0:
            return c.point_by(t.a, t.b, t.c);
        case 1:
            return c.point_by(t.b, t.c, t.a);
        default:
            return c.point_by(t.c, t.a, t.b);
    }
}

/// The same shape with some numbers larger by one ulp. An examination must detect the difference.
inline float after(float value) { return std::nextafterf(value, FLT_MAX); }
inline gphys_sphere grown(gphys_sphere s) { return {s.center, after(s.radius)}; }
inline gphys_capsule grown(gphys_capsule s) { return {s.a, s.b, after(s.radius)}; }
inline gphys_aabb grown(gphys_aabb b) { return {b.min, {after(b.max.x), after(b.max.y), after(b.max.z)}}; }
inline gphys_obb grown(gphys_obb b) {
    return {b.center, {after(b.half_extents.x), after(b.half_extents.y), after(b.half_extents.z)}, b.rotation};
}
inline gphys_triangle grown(gphys_triangle t) { return {{after(t.a.x), t.a.y, after(t.a.z)}, t.b, t.c}; }
inline gphys_plane grown(gphys_plane p) { return {p.normal, after(p.distance)}; }

}  // namespace test

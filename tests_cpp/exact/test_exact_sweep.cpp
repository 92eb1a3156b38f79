// When a moving sphere first touches each primitive: when its centre enters the shape grown by its
// radius. The grown shape is taken apart into balls, cylinders and slabs, in 300 digits; CGAL has no
// such query.
#include <optional>

#include "oracle.h"
#include "score.h"

using namespace test;

namespace {

/// The first time in 0..1 at which the centre enters a convex set that it starts outside of.
class FirstTouch {
public:
    FirstTouch(const gphys_sphere& moving, const gphys_vec3& displacement) : from_(moving.center), way_(displacement) {}
    FirstTouch(const BigVec& from, const BigVec& way) : from_(from), way_(way) {}

    void ball(const BigVec& center, const Big& r) {
        const BigVec f = from_ - center;
        solve(dot(way_, way_), -dot(f, way_), dot(f, f) - r * r, [](const Big&) { return true; });
    }
    void capsule(const BigVec& a, const BigVec& b, const Big& r) {
        ball(a, r);
        ball(b, r);
        const BigVec axis = b - a, f = from_ - a, m = cross(f, axis), n = cross(way_, axis);
        const Big aa = dot(axis, axis);
        if (aa == 0) return;
        solve(dot(n, n), -dot(m, n), dot(m, m) - r * r * aa, [&](const Big& t) {
            const Big along = dot(f + way_ * t, axis) / aa;
            return along >= 0 && along <= 1;
        });
    }
    /// A box along the axes.
    void box(const BigVec& low, const BigVec& high) {
        Big entry = 0, exit = 1;
        for (int k = 0; k < 3; ++k) {
            const auto of = [k](const BigVec& v) { return k == 0 ? v.x : k == 1 ? v.y : v.z; };
            const Big f = of(from_), d = of(way_);
            if (d == 0) {
                if (f < of(low) || f > of(high)) return;
                continue;
            }
            const Big t0 = (of(low) - f) / d, t1 = (of(high) - f) / d;
            entry = std::max(entry, std::min(t0, t1));
            exit = std::min(exit, std::max(t0, t1));
        }
        if (entry <= exit) take(entry);
    }
    /// A triangle met through its inside.
    void face(const BigVec& a, const BigVec& b, const BigVec& c) {
        const BigVec n = cross(b - a, c - a);
        const Big climb = dot(n, way_);
        if (climb == 0) return;
        const Big t = dot(n, a - from_) / climb;
        if (is_above(a, b, c, from_ + way_ * t)) take(t);
    }
    /// What lies within r of the inside of a triangle: a prism.
    void prism(const BigVec& a, const BigVec& b, const BigVec& c, const Big& r) {
        const BigVec n = cross(b - a, c - a);
        const Big norm = sqrt(dot(n, n));
        if (norm == 0) return;
        if (abs(dot(n, from_ - a)) <= r * norm && is_above(a, b, c, from_)) take(0);
        for (const int side : {-1, 1}) {
            const BigVec up = n * (r * side / norm);
            face(a + up, b + up, c + up);
        }
    }
    const std::optional<Big>& time() const { return time_; }

private:
    static bool is_above(const BigVec& a, const BigVec& b, const BigVec& c, const BigVec& p) {
        const BigVec n = cross(b - a, c - a);
        return dot(n, cross(b - a, p - a)) >= 0 && dot(n, cross(c - b, p - b)) >= 0 && dot(n, cross(a - c, p - c)) >= 0;
    }
    template <class Valid>
    void solve(const Big& a, const Big& b, const Big& c, const Valid& valid) {
        if (c <= 0 && valid(Big(0))) return take(0);
        const Big discriminant = b * b - a * c;
        if (a == 0 || b <= 0 || discriminant < 0) return;
        const Big t = c / (b + sqrt(discriminant));
        if (valid(t)) take(t);
    }
    void take(const Big& t) {
        if (t >= 0 && t <= 1 && (!time_ || t < *time_)) time_ = t;
    }

    BigVec from_, way_;
    std::optional<Big> time_;
};

using Time = std::optional<Big>;

/// Of the shape grown by r; 0 where the sphere touches from the start.
Time truth(const gphys_sphere& s, const gphys_sphere& moving, const gphys_vec3& way, const Big& r) {
    FirstTouch first(moving, way);
    first.ball(BigVec(s.center), Big(s.radius) + r);
    return first.time();
}
Time truth(const gphys_capsule& c, const gphys_sphere& moving, const gphys_vec3& way, const Big& r) {
    FirstTouch first(moving, way);
    first.capsule(BigVec(c.a), BigVec(c.b), Big(c.radius) + r);
    return first.time();
}
Time grown_box(const BigVec& low, const BigVec& high, const BigVec& from, const BigVec& way, const Big& r) {
    FirstTouch first(from, way);
    const BigVec grow[3] = {{r, 0, 0}, {0, r, 0}, {0, 0, r}};
    for (const BigVec& g : grow) first.box(low - g, high + g);
    const auto corner = [&](int i) {
        return BigVec(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    for (int i = 0; i < 8; ++i) {
        for (int k = 1; k < 8; k *= 2) {
            if (!(i & k)) first.capsule(corner(i), corner(i | k), r);
        }
    }
    return first.time();
}
Time truth(const gphys_aabb& b, const gphys_sphere& moving, const gphys_vec3& way, const Big& r) {
    return grown_box(BigVec(b.min), BigVec(b.max), BigVec(moving.center), BigVec(way), r);
}
Time truth(const gphys_obb& b, const gphys_sphere& moving, const gphys_vec3& way, const Big& r) {
    const Rotation rotation(b.rotation);
    const BigVec half(b.half_extents), zero(0, 0, 0);
    const Vector from = rotation.into(exact(moving.center) - exact(b.center)), d = rotation.into(exact_vector(way));
    return grown_box(zero - half, half, big(CGAL::ORIGIN + from), big(CGAL::ORIGIN + d), r);
}
Time truth(const gphys_plane& plane, const gphys_sphere& moving, const gphys_vec3& way, const Big& r) {
    const BigVec n(plane.normal), c(moving.center), d(way);
    const Big norm = sqrt(dot(n, n)), height = (dot(n, c) - plane.distance) / norm, climb = dot(n, d) / norm;
    if (abs(height) <= r) return Big(0);
    if (height * climb >= 0) return {};
    const Big t = (abs(height) - r) / abs(climb);
    return t > 1 ? Time() : Time(std::max(t, Big(0)));
}
Time truth(const gphys_triangle& t, const gphys_sphere& moving, const gphys_vec3& way, const Big& r) {
    FirstTouch first(moving, way);
    const BigVec a(t.a), b(t.b), c(t.c);
    first.prism(a, b, c, r);
    first.capsule(a, b, r);
    first.capsule(b, c, r);
    first.capsule(c, a, r);
    return first.time();
}

template <class S>
using Sweep = bool (*)(const S&, const gphys_sphere&, const gphys_vec3&, gphys_hit&);

template <class S>
bool library(const S& shape, const gphys_sphere& moving, const gphys_vec3& way, gphys_hit& hit) {
    return gphys_shape_sweep_sphere(type_of(shape), &shape, &moving, &way, &hit) == GPHYS_OK;
}
template <class S>
bool of_a_grown_shape(const S& shape, const gphys_sphere& moving, const gphys_vec3& way, gphys_hit& hit) {
    return library(grown(shape), moving, way, hit);
}
template <class S>
bool late(const S& shape, const gphys_sphere& moving, const gphys_vec3& way, gphys_hit& hit) {
    if (!library(shape, moving, way, hit)) return false;
    hit.t = after(after(hit.t));
    return true;
}

/// The answer may be either where growing or shrinking the radius by 2^-40 of the size turns it; t lies
/// between those of the two, but for an ulp. Only spheres that start apart: the rest is containment.
template <class S>
auto examine(const char* name, uint64_t seed) {
    return [=](Sweep<S> sweep, long count) {
        Cases c(seed);
        Score score(name, 1, "ulp of t");
        for (long i = 0; i < count; ++i, c.next()) {
            S shape;
            c.make(shape);
            const gphys_ray ray = c.ray_to(target_on(c, shape));
            gphys_sphere moving{ray.origin, c.size() * (c.one_in(2) ? 1 : 1e-2f)};
            gphys_vec3 way = ray.direction;
            if (c.one_in(2)) way = {way.x * 2, way.y * 2, way.z * 2};
            if (gphys_shape_validate(GPHYS_SHAPE_RAY, &ray) != GPHYS_OK) continue;
            int32_t touches = 0;
            gphys_shape_contains(type_of(shape), &shape, &moving.center, moving.radius, &touches);
            if (touches) continue;
            gphys_hit hit;
            const bool given = sweep(shape, moving, way, hit);
            const double size = size_of(shape, moving.center) + moving.radius + largest(widen(way));
            const Big band = size * 0x1p-40, r = moving.radius;
            const Time earliest = truth(shape, moving, way, r + band);
            Time latest;
            if (r > band) latest = truth(shape, moving, way, r - band);
            score.answer(given, earliest.has_value(), !latest.has_value(), shape, moving, way);
            if (!given || !earliest || !latest) continue;
            const auto ulps = [&](const Big& t) { return error_of(hit.t, t) / ulp_of(rounded(t)); };
            if (hit.t < *earliest) score.error(ulps(*earliest), shape, moving, way);
            if (hit.t > *latest) score.error(ulps(*latest), shape, moving, way);
        }
        return score;
    };
}

template <class S>
void prove_sweep(const char* name, uint64_t seed) {
    prove(cases(1500, 1000000), examine<S>(name, seed), library<S>, of_a_grown_shape<S>, late<S>);
}

}  // namespace

TEST_CASE("a sphere swept against each shape touches it when it does", "[sweep]") {
    prove_sweep<gphys_sphere>("sweep sphere", 61);
    prove_sweep<gphys_capsule>("sweep capsule", 62);
    prove_sweep<gphys_aabb>("sweep AABB", 63);
    prove_sweep<gphys_obb>("sweep OBB", 64);
    prove_sweep<gphys_plane>("sweep plane", 65);
    prove_sweep<gphys_triangle>("sweep triangle", 66);
}

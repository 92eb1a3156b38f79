// Overlap of every pair of sphere, capsule, AABB, OBB and triangle. CGAL computes the distance of their
// cores exactly (its polytope distance, a quadratic program); where both have an inside, a depth that
// rounding could have lost is measured along the separating axes.
#include <tuple>

#include "certified_pairs.h"
#include "convex_hull.h"
#include "score.h"

using namespace test;

namespace {

template <class A, class B>
using Overlaps = bool (*)(const A&, const B&);

template <class A, class B>
bool library(const A& a, const B& b) {
    int32_t overlaps = -1;
    REQUIRE(gphys_shape_overlaps(type_of(a), &a, type_of(b), &b, &overlaps) == GPHYS_OK);
    return overlaps == 1;
}
template <class A, class B>
bool of_a_grown_shape(const A& a, const B& b) {
    return library(grown(a), b);
}
/// What the contract allows: nothing between boxes and triangles, roundings of curves, roundings of axes.
constexpr bool is_obb(gphys_shape_type t) { return t == GPHYS_SHAPE_OBB; }
constexpr bool is_round(gphys_shape_type t) { return t == GPHYS_SHAPE_SPHERE || t == GPHYS_SHAPE_CAPSULE; }
constexpr double band_of(gphys_shape_type a, gphys_shape_type b) {
    return is_obb(a) || is_obb(b) ? 0x1p-40 : is_round(a) || is_round(b) ? 0x1p-48 : 0;
}

/// Move b so that one of its points comes to lie where one of a's is, to within rounding.
template <class B>
void touch(Cases& c, gphys_vec3 target, B& b) {
    const gphys_vec3 own = target_on(c, b);
    const Vec3 way = widen(target) - widen(own);
    const auto move = [&](gphys_vec3& p) { p = narrow(widen(p) + way); };
    if constexpr (std::is_same_v<B, gphys_sphere> || std::is_same_v<B, gphys_obb>) {
        move(b.center);
    } else if constexpr (std::is_same_v<B, gphys_capsule>) {
        move(b.a), move(b.b);
    } else if constexpr (std::is_same_v<B, gphys_aabb>) {
        move(b.min), move(b.max);
    } else {
        move(b.a), move(b.b), move(b.c);
    }
}

template <class S>
double reach(const S& shape, gphys_vec3 from) {
    const Rounded<double> rounded = rounded_of<double>(shape, from);
    return largest_corner(rounded) + rounded.radius;
}

/// The corners as doubles: only those of rotated boxes are rounded, by 2^-53 of the pair's size if they
/// count from a point of it; those of others are exact as they stand.
template <class S>
Rounded<double> in_doubles(const S& shape, gphys_vec3 from) {
    const Rounded<Number> exact = rounded_of<Number>(shape, from);
    Rounded<double> result({}, {}, rounded(exact.radius));
    for (const auto& v : exact.corners) result.corners.emplace_back(rounded(v.x), rounded(v.y), rounded(v.z));
    return result;
}

/// Faces and edges of the core, for the depth of an overlap.
Hull hull_of(const Rounded<double>& r) {
    std::vector<Vec3> p;
    for (const auto& v : r.corners) p.push_back({v.x, v.y, v.z});
    switch (p.size()) {
        case 1:
            return {p, {}, {}, 0};
        case 2:
            return {p, {{0, 1}}, {}, 0};
        case 3:
            return {p, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}}, 0};
        default:
            // Numbered by bits of x, y, z.
            return Hull::hexahedron({p[0], p[1], p[3], p[2], p[4], p[5], p[7], p[6]});
    }
}

/// By CGAL's polytope distance.
template <class A, class B>
void measure(Score& score, bool given, const A& a, const B& b, gphys_vec3 near) {
    const gphys_vec3 from = is_obb(type_of(a)) || is_obb(type_of(b)) ? near : gphys_vec3{};
    const Rounded<double> p = in_doubles(a, from), q = in_doubles(b, from);
    const double size = reach(a, near) + reach(b, near), band = band_of(type_of(a), type_of(b)) * size;
    const CGAL::Quotient<Binary> square = squared_distance(p, q);
    const auto within = [&](double more) {
        const Binary sum = Binary(p.radius) + Binary(q.radius) + Binary(more);
        return CGAL::sign(sum) >= 0 && square.numerator() <= sum * sum * square.denominator();
    };
    const bool truth = within(0);
    // Without radii there is no distance to be less than: depth is that of the axes.
    const bool shallow =
        band > 0 && (p.radius + q.radius > 0 ? !within(-band) : std::fabs(gap(hull_of(p), hull_of(q)).gap) <= band);
    score.answer(given, within(band), !truth || shallow, a, b);
}

template <class A, class B>
auto examine(const std::string& name, uint64_t seed) {
    return [=](Overlaps<A, B> overlaps, long count) {
        Cases c(seed);
        Score score(name);
        for (long i = 0; i < count; ++i, c.next()) {
            A a;
            B b;
            c.make(a);
            c.make(b);
            if (!c.one_in(4)) touch(c, target_on(c, a), b);
            const bool given = overlaps(a, b);
            const double band = band_of(type_of(a), type_of(b));
            bool right = is_certain(given, a, b, band);
            if constexpr (!is_obb(type_of(A{})) && !is_obb(type_of(B{}))) right = right || is_exactly(given, a, b);
            if (right) {
                score.answer(given, given, a, b);
            } else {
                measure(score, given, a, b, target_on(c, a));
            }
        }
        return score;
    };
}

template <class A, class B>
void prove_pair(const char* a_name, const char* b_name, uint64_t seed) {
    prove(cases(1000, 10000000), examine<A, B>(std::string("overlap ") + a_name + "-" + b_name, seed), library<A, B>,
          of_a_grown_shape<A, B>);
}

}  // namespace

TEST_CASE("every pair of shapes overlaps when it does, but for the roundings that the contract names", "[overlap]") {
    prove_pair<gphys_sphere, gphys_sphere>("sphere", "sphere", 41);
    prove_pair<gphys_sphere, gphys_capsule>("sphere", "capsule", 42);
    prove_pair<gphys_sphere, gphys_aabb>("sphere", "AABB", 43);
    prove_pair<gphys_sphere, gphys_obb>("sphere", "OBB", 44);
    prove_pair<gphys_sphere, gphys_triangle>("sphere", "triangle", 45);
    prove_pair<gphys_capsule, gphys_capsule>("capsule", "capsule", 46);
    prove_pair<gphys_capsule, gphys_aabb>("capsule", "AABB", 47);
    prove_pair<gphys_capsule, gphys_obb>("capsule", "OBB", 48);
    prove_pair<gphys_capsule, gphys_triangle>("capsule", "triangle", 49);
    prove_pair<gphys_aabb, gphys_aabb>("AABB", "AABB", 50);
    prove_pair<gphys_aabb, gphys_obb>("AABB", "OBB", 51);
    prove_pair<gphys_aabb, gphys_triangle>("AABB", "triangle", 52);
    prove_pair<gphys_obb, gphys_obb>("OBB", "OBB", 53);
    prove_pair<gphys_obb, gphys_triangle>("OBB", "triangle", 54);
    prove_pair<gphys_triangle, gphys_triangle>("triangle", "triangle", 55);
}

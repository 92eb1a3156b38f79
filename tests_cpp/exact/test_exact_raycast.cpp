// Where a ray or a segment first meets each primitive, through the public interface.
#include "oracle.h"
#include "score.h"

using namespace test;

namespace {

/// What a ray or a segment is, exactly: from + t along for t in 0..t_max.
struct Line {
    Point from;
    Vector along;
    float t_max;
    Vec3 origin, direction;  // the same, nearly

    Line(const gphys_ray& ray)
        : from(exact(ray.origin)),
          along(exact_vector(ray.direction)),
          t_max(ray.t_max),
          origin(widen(ray.origin)),
          direction(widen(ray.direction)) {}
    Line(const gphys_segment& segment)
        : from(exact(segment.a)),
          along(exact(segment.b) - exact(segment.a)),
          t_max(1),
          origin(widen(segment.a)),
          direction(widen(segment.b) - widen(segment.a)) {}

    BigVec big_from() const { return big(from); }
    BigVec big_along() const { return big(CGAL::ORIGIN + along); }
};

/// Its points: without end, up to t_max, or one.
template <class Answer>
auto with_path(const Line& line, const Answer& answer) {
    if (std::isinf(line.t_max)) return answer(Kernel::Ray_3(line.from, line.along));
    if (line.t_max == 0 || line.along == CGAL::NULL_VECTOR) return answer(line.from);
    return answer(Kernel::Segment_3(line.from, line.from + line.along * Number(line.t_max)));
}

/// When a ray meets a shape, or that it does not.
struct Meeting {
    bool is = false;
    Number t;
};

/// Entry and exit of intervals along a ray, exactly.
struct Interval {
    Number entry = 0, exit = 0;
    bool bounded, empty = false;

    explicit Interval(float t_max) : bounded(!std::isinf(t_max)) {
        if (bounded) exit = t_max;
    }
    /// Keep what fulfils height + t * climb >= 0.
    void cut(const Number& height, const Number& climb) {
        if (climb == 0) {
            empty = empty || height < 0;
            return;
        }
        const Number t = -height / climb;
        if (climb > 0) {
            if (t > entry) entry = t;
        } else if (!bounded || t < exit) {
            exit = t;
            bounded = true;
        }
    }
    Meeting result() const { return {!empty && (!bounded || entry <= exit), entry}; }
};

Meeting in_slabs(const Vector& from, const Vector& along, const Number (&half)[3], float t_max) {
    Interval interval(t_max);
    for (int k = 0; k < 3; ++k) {
        interval.cut(half[k] + from[k], along[k]);
        interval.cut(half[k] - from[k], -along[k]);
    }
    return interval.result();
}

Meeting truth(const gphys_aabb& b, const Line& ray) {
    const Point low = exact(b.min), high = exact(b.max);
    Interval interval(ray.t_max);
    for (int k = 0; k < 3; ++k) {
        interval.cut(ray.from[k] - low[k], ray.along[k]);
        interval.cut(high[k] - ray.from[k], -ray.along[k]);
    }
    return interval.result();
}

Meeting truth(const gphys_frustum& f, const Line& ray) {
    Interval interval(ray.t_max);
    for (const gphys_plane& p : f.planes) {
        const Vector n = exact_vector(p.normal);
        interval.cut(n * (ray.from - exact(f.origin)) - p.distance, n * ray.along);
    }
    return interval.result();
}

/// Of a box whose half extents are longer by `more`.
Meeting truth(const gphys_obb& b, const Line& ray, const Number& more) {
    const Rotation rotation(b.rotation);
    const Number half[3] = {b.half_extents.x + more, b.half_extents.y + more, b.half_extents.z + more};
    for (const Number& h : half) {
        if (h < 0) return {};
    }
    return in_slabs(rotation.into(ray.from - exact(b.center)), rotation.into(ray.along), half, ray.t_max);
}

Meeting truth(const gphys_plane& p, const Line& ray) {
    const Vector n = exact_vector(p.normal);
    const Number start = n * (ray.from - CGAL::ORIGIN) - p.distance;
    const Number climb = n * ray.along;
    if (start == 0) return {true, 0};
    if (climb == 0) return {};
    const Number t = -start / climb;
    return {t > 0 && (std::isinf(ray.t_max) || t <= ray.t_max), t};
}

/// The parameter of a point on a ray.
Number parameter(const Line& ray, const Point& p) {
    const int k = longest_axis(ray.direction);
    return ray.along[k] == 0 ? Number(0) : Number((p[k] - ray.from[k]) / ray.along[k]);
}

/// CGAL's do_intersect decides: its intersection of a ray that leads away along an edge is not empty.
Meeting truth(const gphys_triangle& t, const Line& ray) {
    Meeting meeting;
    const auto take = [&](const Point& p) {
        const Number t_of_p = parameter(ray, p);
        if (!meeting.is || t_of_p < meeting.t) meeting = {true, t_of_p};
    };
    const auto take_first = [&](const auto& set) {
        if (!set) return;
        if (const Point* p = boost::get<Point>(&*set)) take(*p);
        if (const auto* s = boost::get<Kernel::Segment_3>(&*set)) take(s->source()), take(s->target());
    };
    with_simplex(t, [&](const auto& simplex) {
        return with_path(ray, [&](const auto& path) {
            using Simplex = std::decay_t<decltype(simplex)>;
            using Path = std::decay_t<decltype(path)>;
            if constexpr (std::is_same_v<Simplex, Point> && std::is_same_v<Path, Point>) {
                if (simplex == path) take(path);
            } else if constexpr (std::is_same_v<Simplex, Point>) {
                if (path.has_on(simplex)) take(simplex);
            } else if constexpr (std::is_same_v<Path, Point>) {
                if (simplex.has_on(path)) take(path);
            } else {
                if (CGAL::do_intersect(path, simplex)) take_first(CGAL::intersection(path, simplex));
            }
            return true;
        });
    });
    return meeting;
}

/// When a ray from outside enters a sphere that it is known to meet.
Big entry(const BigVec& center, const Big& radius, const Line& ray) {
    const BigVec from = ray.big_from() - center, d = ray.big_along();
    const Big dd = dot(d, d), b = -dot(from, d), c = dot(from, from) - radius * radius;
    Big discriminant = b * b - dd * c;
    if (discriminant < 0) discriminant = 0;
    return c / (b + sqrt(discriminant));
}

struct RoundMeeting {
    bool is = false;
    Big t = 0;
};

RoundMeeting truth(const gphys_sphere& s, const Line& ray) {
    const Number square = Number(s.radius) * s.radius;
    const Point center = exact(s.center);
    if (CGAL::squared_distance(center, ray.from) <= square) return {true, 0};
    const bool meets = with_path(ray, [&](const auto& path) { return CGAL::squared_distance(center, path) <= square; });
    if (!meets) return {};
    return {true, entry(BigVec(s.center), s.radius, ray)};
}

/// A part of the ray that holds all that comes near points within `reach` of its origin.
Line shortened(Line ray, double reach) {
    const double enough = 4 * reach / largest(ray.direction);
    if (std::isinf(ray.t_max) && enough < FLT_MAX) ray.t_max = after(static_cast<float>(enough));
    return ray;
}

/// Of a capsule whose radius is longer by `more`. CGAL decides whether (not for endless rays: its
/// distance of a ray from a parallel segment is wrong); the time is the first of those of the two
/// balls and of the side between them.
RoundMeeting truth(const gphys_capsule& c, const Line& whole, double more) {
    const Number radius = Number(c.radius) + more;
    if (radius < 0) return {};
    const Number square = radius * radius;
    const Vec3 to_a = widen(c.a) - whole.origin, to_b = widen(c.b) - whole.origin;
    const Line ray = shortened(whole, largest(to_a) + largest(to_b) + c.radius);
    const auto distance_of = [&](const auto& set) {
        if (widen(c.a) == widen(c.b)) return CGAL::squared_distance(exact(c.a), set);
        return CGAL::squared_distance(Kernel::Segment_3(exact(c.a), exact(c.b)), set);
    };
    if (distance_of(ray.from) <= square) return {true, 0};
    if (!with_path(ray, [&](const auto& path) { return distance_of(path) <= square; })) return {};

    const Big r = Big(c.radius) + more;
    RoundMeeting first;
    const auto take = [&](const Big& t) {
        if (t >= 0 && (!first.is || t < first.t)) first = {true, t};
    };
    const auto solve = [&](const Big& a, const Big& b, const Big& c0, const auto& valid) {
        Big discriminant = b * b - a * c0;
        if (a == 0 || b <= 0 || discriminant < -a * abs(c0) * Big(1e-200)) return;
        if (discriminant < 0) discriminant = 0;
        const Big t = c0 / (b + sqrt(discriminant));
        if (valid(t)) take(t);
    };
    const BigVec d = ray.big_along();
    for (const gphys_vec3& end : {c.a, c.b}) {
        const BigVec from = ray.big_from() - BigVec(end);
        solve(dot(d, d), -dot(from, d), dot(from, from) - r * r, [](const Big&) { return true; });
    }
    const BigVec axis = BigVec(c.b) - BigVec(c.a), from = ray.big_from() - BigVec(c.a);
    const BigVec m = cross(from, axis), n = cross(d, axis);
    const Big aa = dot(axis, axis);
    solve(dot(n, n), -dot(m, n), dot(m, m) - r * r * aa, [&](const Big& t) {
        const Big along = dot(from + d * t, axis) / aa;
        return along >= Big(-1e-100) && along <= 1 + Big(1e-100);
    });
    return first;
}

/// The error of t in ulps of the float nearest to the truth.
template <class T>
double ulps(float t, const T& true_t) {
    return error_of(t, true_t) / ulp_of(rounded(true_t));
}

template <class S>
bool library(const S& shape, const gphys_ray& ray, gphys_hit& hit) {
    return gphys_shape_raycast(type_of(shape), &shape, &ray, &hit) == GPHYS_OK;
}
template <class S>
bool of_a_grown_shape(const S& shape, const gphys_ray& ray, gphys_hit& hit) {
    return library(grown(shape), ray, hit);
}
template <class S>
bool late(const S& shape, const gphys_ray& ray, gphys_hit& hit) {
    if (!library(shape, ray, hit)) return false;
    hit.t = after(after(hit.t));
    return true;
}
/// Without what rounds to nothing: what a test for the lengths of cross products against an epsilon does.
template <class S>
bool with_an_epsilon(const S& shape, const gphys_ray& ray, gphys_hit& hit) {
    return library(shape, ray, hit) && (hit.t > 1e-6f || hit.flags & GPHYS_HIT_INSIDE) && hit.t < ray.t_max * .9999999f;
}

template <class S>
using Raycast = bool (*)(const S&, const gphys_ray&, gphys_hit&);

/// No false answer at all, t within 1 ulp.
template <class S>
auto examine(const char* name, uint64_t seed) {
    return [=](Raycast<S> raycast, long count) {
        Cases c(seed);
        Score score(name, 1, "ulp of t");
        for (long i = 0; i < count; ++i, c.next()) {
            S shape;
            c.make(shape);
            const gphys_ray ray = c.ray_to(target_on(c, shape));
            if (gphys_shape_validate(GPHYS_SHAPE_RAY, &ray) != GPHYS_OK) continue;
            gphys_hit hit;
            const bool given = raycast(shape, ray, hit);
            const auto expected = truth(shape, ray);
            score.answer(given, expected.is, shape, ray);
            if (given && expected.is) score.error(ulps(hit.t, expected.t), shape, ray);
        }
        return score;
    };
}

}  // namespace

TEST_CASE("rays meet spheres exactly when they do, at t", "[raycast]") {
    prove(cases(20000, 10000000), examine<gphys_sphere>("raycast sphere", 1), library<gphys_sphere>,
          of_a_grown_shape<gphys_sphere>, late<gphys_sphere>);
}
TEST_CASE("rays meet boxes exactly when they do, at t", "[raycast]") {
    prove(cases(20000, 10000000), examine<gphys_aabb>("raycast AABB", 3), library<gphys_aabb>,
          of_a_grown_shape<gphys_aabb>, late<gphys_aabb>, with_an_epsilon<gphys_aabb>);
}
TEST_CASE("rays meet planes exactly when they do, at t", "[raycast]") {
    prove(cases(20000, 10000000), examine<gphys_plane>("raycast plane", 4), library<gphys_plane>,
          of_a_grown_shape<gphys_plane>, late<gphys_plane>, with_an_epsilon<gphys_plane>);
}
TEST_CASE("rays meet triangles exactly when they do, at t", "[raycast]") {
    prove(cases(20000, 10000000), examine<gphys_triangle>("raycast triangle", 5), library<gphys_triangle>,
          of_a_grown_shape<gphys_triangle>, late<gphys_triangle>, with_an_epsilon<gphys_triangle>);
}

TEST_CASE("rays meet capsules when they do, but for 2^-48 of the distance, at t", "[raycast]") {
    const auto examine_capsules = [](Raycast<gphys_capsule> raycast, long count) {
        Cases c(2);
        Score score("raycast capsule", 1, "ulp of t");
        for (long i = 0; i < count; ++i, c.next()) {
            gphys_capsule capsule;
            c.make(capsule);
            const gphys_ray ray = c.ray_to(target_on(c, capsule));
            if (gphys_shape_validate(GPHYS_SHAPE_RAY, &ray) != GPHYS_OK) continue;
            gphys_hit hit;
            const bool given = raycast(capsule, ray, hit);
            const Vec3 origin = widen(ray.origin);
            const double band = 0x1p-48 * (largest(widen(capsule.a) - origin) + largest(widen(capsule.b) - origin));
            const RoundMeeting expected = truth(capsule, ray, 0);
            if (given == expected.is) {
                score.answer(given, expected.is, capsule, ray);
                if (given) score.error(ulps(hit.t, expected.t), capsule, ray);
            } else {
                score.answer(given, truth(capsule, ray, band).is, !truth(capsule, ray, -band).is, capsule, ray);
            }
        }
        return score;
    };
    prove(cases(10000, 10000000), examine_capsules, library<gphys_capsule>, of_a_grown_shape<gphys_capsule>,
          late<gphys_capsule>);
}

TEST_CASE("rays meet rotated boxes when they do, but for 2^-40 of the distance", "[raycast]") {
    const auto examine_boxes = [](Raycast<gphys_obb> raycast, long count) {
        Cases c(6);
        Score score("raycast OBB", 1, "ulp of t");
        for (long i = 0; i < count; ++i, c.next()) {
            gphys_obb box;
            c.make(box);
            const gphys_ray ray = c.ray_to(target_on(c, box));
            if (gphys_shape_validate(GPHYS_SHAPE_RAY, &ray) != GPHYS_OK) continue;
            gphys_hit hit;
            const bool given = raycast(box, ray, hit);
            const double reach = largest(widen(ray.origin) - widen(box.center)) + largest(widen(box.half_extents));
            const Number band = reach * 0x1p-40;
            const Meeting earliest = truth(box, ray, band), latest = truth(box, ray, -band);
            score.answer(given, earliest.is, !latest.is, box, ray);
            if (!given || !earliest.is || !latest.is) continue;
            // How far t is beyond what the band allows.
            if (hit.t < earliest.t) score.error(ulps(hit.t, earliest.t), box, ray);
            if (hit.t > latest.t) score.error(ulps(hit.t, latest.t), box, ray);
        }
        return score;
    };
    prove(cases(10000, 10000000), examine_boxes, library<gphys_obb>, of_a_grown_shape<gphys_obb>, late<gphys_obb>);
}

// --- Segments -----------------------------------------------------------------------------------

namespace {

template <class S>
bool segment_library(const S& shape, const gphys_segment& segment, gphys_hit& hit) {
    return gphys_shape_segment_test(type_of(shape), &shape, &segment, &hit) == GPHYS_OK;
}
template <class S>
bool segment_of_a_grown_shape(const S& shape, const gphys_segment& segment, gphys_hit& hit) {
    return segment_library(grown(shape), segment, hit);
}
template <class S>
bool late_segment(const S& shape, const gphys_segment& segment, gphys_hit& hit) {
    if (!segment_library(shape, segment, hit)) return false;
    hit.t = after(after(hit.t));
    return true;
}
/// As a ray whose direction is b - a rounded to doubles.
template <class S>
bool rounded_segment(const S& shape, const gphys_segment& segment, gphys_hit& hit) {
    const Vec3 a = widen(segment.a), b = widen(segment.b);
    gphys::Hit found;
    if (!gphys::raycast(widen(shape), gphys::Ray{a, b - a, 1.0}, found)) return false;
    hit = to_hit(found);
    return true;
}

/// A segment that mostly ends, begins or passes at a point of the target.
gphys_segment segment_to(Cases& c, const gphys_vec3& target) {
    gphys_segment segment{c.point(), target};
    switch (c.random.index(5)) {
        case 0: {
            // Through it, nearly.
            const Vec3 a = widen(segment.a);
            segment.b = narrow(a + (widen(target) - a) * c.random.uniform(0, 2));
            break;
        }
        case 1:
            c.nudge(segment.b);
            break;
        case 2:
            segment.b = c.point();
            break;
        default:
            break;
    }
    if (c.one_in(20)) segment.b = segment.a;
    if (c.one_in(2)) std::swap(segment.a, segment.b);
    return segment;
}

template <class S>
using SegmentTest = bool (*)(const S&, const gphys_segment&, gphys_hit&);

/// No false answer at all, the same from both ends, t within 1 ulp.
template <class S>
auto examine_segments(const char* name, uint64_t seed) {
    return [=](SegmentTest<S> test, long count) {
        Cases c(seed);
        Score score(name, 1, "ulp of t");
        for (long i = 0; i < count; ++i, c.next()) {
            S shape;
            c.make(shape);
            const gphys_segment segment = segment_to(c, target_on(c, shape)), back{segment.b, segment.a};
            gphys_hit hit, unused;
            const bool given = test(shape, segment, hit);
            const auto expected = truth(shape, Line(segment));
            score.answer(given && test(shape, back, unused), expected.is, shape, segment);
            if (given && expected.is) score.error(ulps(hit.t, expected.t), shape, segment);
        }
        return score;
    };
}

/// Mostly of small whole numbers, some with numbers of another size among them.
void make(Cases& c, gphys_frustum& f) {
    const auto number = [&] { return c.one_in(4) ? mixed_number(c.random) : float(int(c.random.index(5)) - 2); };
    f = {{number(), number(), number()},
         {{{0, 0, 1}, 0}, {{0, 0, -1}, -2}, {{1, 0, 1}, 0}, {{-1, 0, 1}, 0}, {{0, 1, 1}, 0}, {{0, -1, 1}, 0}}};
    for (gphys_plane& plane : f.planes) {
        if (c.one_in(3)) plane.normal.x = number();
        if (c.one_in(3)) plane.normal.y = number();
        if (c.one_in(3) || widen(plane.normal) == Vec3{}) plane.normal = {0, number(), 1};
        if (c.one_in(3)) plane.distance = number();
    }
}

}  // namespace

TEST_CASE("segments meet spheres exactly when they do, at t", "[segment]") {
    prove(cases(20000, 10000000), examine_segments<gphys_sphere>("segment sphere", 71), segment_library<gphys_sphere>,
          segment_of_a_grown_shape<gphys_sphere>, late_segment<gphys_sphere>);
}
TEST_CASE("segments meet boxes exactly when they do, at t", "[segment]") {
    prove(cases(20000, 10000000), examine_segments<gphys_aabb>("segment AABB", 72), segment_library<gphys_aabb>,
          segment_of_a_grown_shape<gphys_aabb>, late_segment<gphys_aabb>, rounded_segment<gphys_aabb>);
}
TEST_CASE("segments meet planes exactly when they do, at t", "[segment]") {
    prove(cases(20000, 10000000), examine_segments<gphys_plane>("segment plane", 73), segment_library<gphys_plane>,
          segment_of_a_grown_shape<gphys_plane>, late_segment<gphys_plane>, rounded_segment<gphys_plane>);
}
TEST_CASE("segments meet triangles exactly when they do, at t", "[segment]") {
    prove(cases(20000, 10000000), examine_segments<gphys_triangle>("segment triangle", 74),
          segment_library<gphys_triangle>, segment_of_a_grown_shape<gphys_triangle>, late_segment<gphys_triangle>,
          rounded_segment<gphys_triangle>);
}

TEST_CASE("segments meet capsules when they do, but for 2^-48 of the distance, at t", "[segment]") {
    const auto examine_capsules = [](SegmentTest<gphys_capsule> test, long count) {
        Cases c(75);
        Score score("segment capsule", 1, "ulp of t");
        for (long i = 0; i < count; ++i, c.next()) {
            gphys_capsule capsule;
            c.make(capsule);
            const gphys_segment segment = segment_to(c, target_on(c, capsule)), back{segment.b, segment.a};
            gphys_hit hit, unused;
            const bool given = test(capsule, segment, hit), given_back = test(capsule, back, unused);
            const Vec3 origin = widen(segment.a);
            const double band = 0x1p-48 * (largest(widen(capsule.a) - origin) + largest(widen(capsule.b) - origin));
            const RoundMeeting expected = truth(capsule, Line(segment), 0);
            if (given == expected.is && given_back == given) {
                score.answer(given, expected.is, capsule, segment);
                if (given) score.error(ulps(hit.t, expected.t), capsule, segment);
            } else {
                const bool may_hit = truth(capsule, Line(segment), band).is,
                           may_miss = !truth(capsule, Line(segment), -band).is;
                score.answer(given, may_hit, may_miss, capsule, segment);
                score.answer(given_back, may_hit, may_miss, capsule, segment);
            }
        }
        return score;
    };
    prove(cases(10000, 10000000), examine_capsules, segment_library<gphys_capsule>,
          segment_of_a_grown_shape<gphys_capsule>, late_segment<gphys_capsule>);
}

TEST_CASE("segments meet rotated boxes when they do, but for 2^-40 of the distance", "[segment]") {
    const auto examine_boxes = [](SegmentTest<gphys_obb> test, long count) {
        Cases c(76);
        Score score("segment OBB", 1, "ulp of t");
        for (long i = 0; i < count; ++i, c.next()) {
            gphys_obb box;
            c.make(box);
            const gphys_segment segment = segment_to(c, target_on(c, box));
            gphys_hit hit;
            const bool given = test(box, segment, hit);
            const double reach =
                std::max(largest(widen(segment.a) - widen(box.center)), largest(widen(segment.b) - widen(box.center))) +
                largest(widen(box.half_extents));
            const Number band = reach * 0x1p-40;
            const Line line(segment);
            const Meeting earliest = truth(box, line, band), latest = truth(box, line, -band);
            score.answer(given, earliest.is, !latest.is, box, segment);
            if (!given || !earliest.is || !latest.is) continue;
            if (hit.t < earliest.t) score.error(ulps(hit.t, earliest.t), box, segment);
            if (hit.t > latest.t) score.error(ulps(hit.t, latest.t), box, segment);
        }
        return score;
    };
    prove(cases(10000, 10000000), examine_boxes, segment_library<gphys_obb>, segment_of_a_grown_shape<gphys_obb>,
          late_segment<gphys_obb>);
}

TEST_CASE("segments meet frusta exactly when they do, at t", "[segment]") {
    const auto examine_frusta = [](SegmentTest<gphys_frustum> test, long count) {
        Cases c(77);
        Score score("segment frustum", 1, "ulp of t");
        for (long i = 0; i < count; ++i, c.next()) {
            gphys_frustum frustum;
            make(c, frustum);
            if (gphys_shape_validate(GPHYS_SHAPE_FRUSTUM, &frustum) != GPHYS_OK) continue;
            gphys_vec3 corners[8];
            const bool bounded = gphys_frustum_corners(&frustum, corners) == GPHYS_OK;
            const gphys_vec3 target =
                bounded ? c.point_by(corners[c.random.index(8)], corners[0], corners[6]) : c.point();
            const gphys_segment segment = segment_to(c, target), back{segment.b, segment.a};
            if (gphys_shape_validate(GPHYS_SHAPE_SEGMENT, &segment) != GPHYS_OK) continue;
            gphys_hit hit, unused;
            const bool given = test(frustum, segment, hit);
            const Meeting expected = truth(frustum, Line(segment));
            score.answer(given && test(frustum, back, unused), expected.is, frustum, segment);
            if (given && expected.is) score.error(ulps(hit.t, expected.t), frustum, segment);
        }
        return score;
    };
    const auto of_a_grown_frustum = [](const gphys_frustum& frustum, const gphys_segment& segment, gphys_hit& hit) {
        gphys_frustum f = frustum;
        for (gphys_plane& plane : f.planes) plane.distance = std::nextafterf(plane.distance, -FLT_MAX);
        return segment_library(f, segment, hit);
    };
    prove(cases(20000, 10000000), examine_frusta, segment_library<gphys_frustum>, of_a_grown_frustum,
          late_segment<gphys_frustum>);
}

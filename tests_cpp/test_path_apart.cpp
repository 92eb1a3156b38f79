#include "geometry/path_apart.h"

#include "test.h"

using namespace gphys;

TEST_CASE("a triangle that is told apart from the path of a ball is, by a margin, and most that are apart are told") {
    test::Random random(81);
    constexpr double margin = apart_margin;
    int touching = 0, beside = 0, told = 0, wrong = 0;
    for (int i = 0; i < 30000; ++i) {
        const auto point = [&] {
            const Vec3 v = widen(random.point(3));
            return i % 2 == 0 ? v : Vec3{std::round(v.x), std::round(v.y), std::round(v.z)};
        };
        const Vec3 a = point(), b = point();
        const Triangle around{a, b, i % 16 == 0 ? b : point()};
        const Vec3 way = i % 9 == 0 ? Vec3{} : point();
        const double size = max_component(max(abs(around.a), max(abs(around.b), abs(around.c))));
        // The least distance, by alternating projections from some starts: an upper bound.
        double apart = infinity;
        for (const double start : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            Vec3 on_path = way * start;
            for (int step = 0; step < 60; ++step) {
                on_path = closest_point(Segment{{}, way}, closest_point(around, on_path));
            }
            apart = std::min(apart, length(on_path - closest_point(around, on_path)));
        }
        const double radius = i % 4 == 0 ? apart : i % 4 == 1 ? apart * (1 - 1e-9) : random.uniform(0, 2);
        const PathAndTriangle pair(way, radius, around, size, margin);
        const bool is_told = pair.are_apart_by_face() || pair.are_apart_beside({}) || pair.are_apart_beside(way) ||
                             pair.are_apart_along_path();
        if (radius >= apart * (1 - 1e-8)) {
            ++touching;
            wrong += is_told && apart <= radius;
        } else {
            ++beside;
            told += is_told;
        }
    }
    CHECK(wrong == 0);
    CHECK(touching > 15000);
    CHECK(beside > 3000);
    CHECK(told > 0.8 * beside);
}

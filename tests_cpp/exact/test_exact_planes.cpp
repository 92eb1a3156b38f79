// The point of three planes, beside Cramer's rule in 300 digits.
#include "oracle.h"
#include "score.h"

using namespace test;

namespace {

using Meet = gphys_status (*)(const gphys_plane*, const gphys_plane*, const gphys_plane*, gphys_vec3*);

gphys_status beside(const gphys_plane* a, const gphys_plane* b, const gphys_plane* c, gphys_vec3* point) {
    const gphys_status status = gphys_planes_intersection(a, b, c, point);
    point->y = std::nextafter(std::nextafter(point->y, INFINITY), INFINITY);
    return status;
}

/// Planes in general, of whole numbers (of which many have a line in common, or none), or with normals that almost lie
/// in a plane.
gphys_plane plane(Cases& c, int kind, const gphys_plane* others) {
    const float distance = static_cast<float>(std::pow(10.0, c.random.uniform(-4, 6))) * (c.one_in(2) ? -1.0f : 1.0f);
    if (kind == 0) return {narrow(c.random.direction() * std::pow(10.0, c.random.uniform(-3, 3))), distance};
    if (kind == 1) {
        const auto number = [&] { return static_cast<float>(c.random.index(5)) - 2; };
        gphys_vec3 normal{number(), number(), number()};
        if (normal.x == 0 && normal.y == 0 && normal.z == 0) normal.x = 1;
        return {normal, number()};
    }
    const Vec3 mixed = widen(others[0].normal) * c.random.uniform(-1, 1) + widen(others[1].normal);
    return {narrow(mixed + c.random.direction() * std::pow(10.0, c.random.uniform(-9, -1))), distance};
}

}  // namespace

TEST_CASE("three planes meet within an ulp of where they do, and exactly those that do", "[planes]") {
    const auto examine = [](Meet meet, long count) {
        Cases c(91);
        Score score("planes", 1, "ulps of a coordinate");
        for (long i = 0; i < count; ++i) {
            const int kind = static_cast<int>(i % 3);
            gphys_plane planes[3];
            for (int k = 0; k < 3; ++k) planes[k] = plane(c, k < 2 && kind == 2 ? 0 : kind, planes);
            const BigVec n[3] = {BigVec(planes[0].normal), BigVec(planes[1].normal), BigVec(planes[2].normal)};
            const Big volume = dot(n[0], cross(n[1], n[2]));
            BigVec point(0, 0, 0);
            if (volume != 0) {
                point = (cross(n[1], n[2]) * Big(planes[0].distance) + cross(n[2], n[0]) * Big(planes[1].distance) +
                         cross(n[0], n[1]) * Big(planes[2].distance)) *
                        (1 / volume);
            }
            const Big largest = std::max({Big(abs(point.x)), Big(abs(point.y)), Big(abs(point.z))});
            const bool there = volume != 0 && largest <= Big(GPHYS_MAX_COORDINATE);
            gphys_vec3 found{};
            const bool given = meet(&planes[0], &planes[1], &planes[2], &found) == GPHYS_OK;
            score.answer(given, there, planes[0].normal, planes[1].normal, planes[2].normal);
            if (given && there) {
                score.error(error_of(found.x, point.x) / ulp_of(found.x), planes[0].normal);
                score.error(error_of(found.y, point.y) / ulp_of(found.y), planes[0].normal);
                score.error(error_of(found.z, point.z) / ulp_of(found.z), planes[0].normal);
            }
            c.next();
        }
        return score;
    };
    const Score score = examine(gphys_planes_intersection, cases(3000, 1000000));
    score.print();
    CHECK(score.kept());
    CHECK_FALSE(examine(beside, 3000).kept());
}

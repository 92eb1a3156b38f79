// A sweep of a solid is held against overlaps, which decide otherwise: shortly before the first contact the two do not
// overlap, shortly after it they do, and nowhere on a way without contact. Shortly is in metres along the normal: a
// solid that is larger or smaller by the band.
#include "solid_cases.h"

using namespace gphys;
using namespace test;

namespace {

constexpr int cases = 100000, many_cases = 1000000;

struct Proof {
    int contacts = 0, at_start = 0, misses = 0, too_late = 0, too_early = 0, missed = 0, wrong_starts = 0,
        wrong_normals = 0, wrong_points = 0, overlap_beside = 0, wrong_times = 0;

    void add(const SolidPair& pair, Random& random) {
        const Vec3 displacement = pair.way;
        const double band = 0x1p-40 * pair.size;
        // What is flat cannot be smaller by the band.
        const bool shrinks = has_thickness(pair.moving, band);
        const auto overlap_at = [&](double t, double grow) {
            return overlaps(pair.other, grown(moved(pair.moving, displacement * t), grow));
        };
        Hit hit;
        if (!sweep(pair.other, pair.moving, displacement, hit)) {
            ++misses;
            if (!shrinks) return;
            for (int i = 0; i < 32; ++i)
                missed += overlap_at(random.index(8) == 0 ? i & 1 : random.uniform(0, 1), -band);
            missed += passes_through(pair, displacement, band);
            return;
        }
        if (hit.flags & GPHYS_HIT_INSIDE) {
            ++at_start;
            wrong_starts += hit.t != 0 || !overlap_at(0, band);
        } else {
            ++contacts;
            too_early += !overlap_at(hit.t, band);
            // Nowhere before, and above all not just before.
            for (int i = 0; i < 16 && shrinks; ++i) {
                const double t = hit.t * (i < 8 ? random.uniform(0, 1) : 1 - std::pow(10, random.uniform(-8, 0)));
                too_late += overlap_at(t, -band);
            }
            wrong_normals += dot(hit.normal, displacement) > band;
            const Shape there = moved(pair.moving, displacement * hit.t);
            wrong_points += !overlaps(pair.other, Shape(Sphere{hit.point, 4 * band})) ||
                            !overlaps(there, Shape(Sphere{hit.point, 0x1p-24 * pair.size}));
            // On the other side of the plane of contact.
            overlap_beside += overlaps(pair.other, moved(there, hit.normal * (4 * band)));
        }
        // A sphere that does not move has none from within a solid.
        const bool has_normal = displacement != Vec3{} || !std::holds_alternative<Sphere>(pair.moving);
        wrong_normals += has_normal && std::fabs(length(hit.normal) - 1) > 1e-12;
        wrong_times += hit.t < 0 || hit.t > 1;
    }

    /// Whether the two overlap where a solid that is a little larger has its first contact, or some way on.
    bool passes_through(const SolidPair& pair, Vec3 displacement, double band) const {
        Hit hit;
        for (const double more : {0x1p-4, 0x1p-8, 0x1p-12}) {
            if (!sweep(pair.other, grown(pair.moving, more), displacement, hit)) continue;
            for (int i = 0; i < 16; ++i) {
                const Vec3 way = displacement * (hit.t + (1 - hit.t) * i * i / 256);
                if (overlaps(pair.other, grown(moved(pair.moving, way), -band))) return true;
            }
        }
        return false;
    }
};

Proof prove(uint64_t seed, int count) {
    const NoTraps watch;
    SolidCases pairs(seed);
    Proof proof;
    for (int i = 0; i < count; ++i) {
        proof.add(pairs.next(6), pairs.random);
    }
    return proof;
}

#define CHECK_PROOF(proof, count)                                                                                  \
    do {                                                                                                           \
        INFO(proof.contacts << " contacts, " << proof.at_start << " at the start, " << proof.misses << " misses"); \
        CHECK(proof.contacts > count / 20);                                                                        \
        CHECK(proof.at_start > count / 20);                                                                        \
        CHECK(proof.misses > count / 20);                                                                          \
        CHECK(proof.too_early == 0);                                                                               \
        CHECK(proof.too_late == 0);                                                                                \
        CHECK(proof.missed == 0);                                                                                  \
        CHECK(proof.wrong_starts == 0);                                                                            \
        CHECK(proof.wrong_normals == 0);                                                                           \
        CHECK(proof.wrong_points == 0);                                                                            \
        CHECK(proof.overlap_beside == 0);                                                                          \
        CHECK(proof.wrong_times == 0);                                                                             \
    } while (0)

}  // namespace

TEST_CASE("sweep of solids: first contact, by overlaps before and after", "[sweep]") {
    const Proof proof = prove(41, cases);
    CHECK_PROOF(proof, cases);
}

TEST_CASE("sweep of solids: first contact, a million times", "[sweep][.long]") {
    const Proof proof = prove(42, many_cases);
    CHECK_PROOF(proof, many_cases);
}

TEST_CASE("sweep of solids: touching counts at the start and at the end", "[sweep]") {
    const NoTraps watch;
    const Mat3 turned{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    const Frustum frustum = view({-1, 0, 0}, turned, 1, 1, 1, 3, false).frustum;
    for (const Shape& moving : {Shape(Capsule{{-3, 0, -1}, {-3, 0, 1}, 1}), Shape(Capsule{{-3, 0, 0}, {-4, 0, 0}, 1}),
                                Shape(Aabb{{-4, -1, -1}, {-2, 1, 1}}), Shape(Obb{{-3, 0, 0}, {1, 1, 1}, Mat3{}})}) {
        for (const Shape& shape :
             {Shape(Sphere{{1, 0, 0}, 1}), Shape(Capsule{{1, 0, 0}, {1, 2, 0}, 1}), Shape(Aabb{{0, -1, -1}, {1, 1, 1}}),
              Shape(Obb{{1, 0, 0}, {1, 1, 1}, Mat3{}}), Shape(Plane{{2, 0, 0}, 0}), Shape(frustum),
              Shape(Triangle{{0, -1, -1}, {0, 1, -1}, {0, 0, 1}}), Shape(Triangle{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}})}) {
            Hit hit;
            REQUIRE(sweep(shape, moving, {2, 0, 0}, hit));
            CHECK(hit.t == 1);
            CHECK(hit.point.x == Approx(0).margin(1e-15));
            CHECK(length(hit.normal - Vec3{-1, 0, 0}) < 1e-15);
            CHECK((hit.flags & GPHYS_HIT_INSIDE) == 0);
            CHECK_FALSE(sweep(shape, moving, {1.9999999, 0, 0}, hit));
            REQUIRE(sweep(shape, moved(moving, {2, 0, 0}), {-1, 0, 0}, hit));
            CHECK(hit.t == 0);
            CHECK((hit.flags & GPHYS_HIT_INSIDE) != 0);
            CHECK(length(hit.normal - Vec3{-1, 0, 0}) < 1e-15);
        }
    }
}

TEST_CASE("sweep of solids: a triangle tells where and from which side", "[sweep]") {
    const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}};  // its normal is down
    const Shape foot = Aabb{{1, 1, 1}, {1.5, 2, 1.5}};
    Hit hit;
    REQUIRE(sweep(triangle, foot, {0, -4, 0}, hit));
    CHECK(hit.t == 0.25);
    CHECK(hit.normal == Vec3{0, 1, 0});
    CHECK(hit.flags == GPHYS_HIT_BACK);
    CHECK(hit.u == Approx(hit.point.x / 4));
    CHECK(hit.v == Approx(hit.point.z / 4));
    REQUIRE(sweep(triangle, moved(foot, {0, -4, 0}), {0, 4, 0}, hit));
    CHECK(hit.t == 0.5);
    CHECK(hit.flags == 0);
}

TEST_CASE("sweep of solids: a thin capsule is met although its offset is too short for a direction", "[sweep]") {
    const NoTraps watch;
    struct Encounter {
        Shape other, moving;
        Vec3 way;
    };
    const Encounter encounters[] = {
        {Capsule{{0x1p+0, -0x1p+22, 0x1p+13}, {0x1.000002p-1, 0x1p-149, -0x1p+0}, 0x1.0624dep-10},
         Aabb{{0x1p-1, -0x1.cb0c28p-2, -0x1.8p-1}, {0x1.ff8p-1, 0x1.a79eb8p-5, -0x1p-2}},
         {0x1.9d76aep-1, -0x1.9cf3ecp+22, 0x1.9cf4d6p+13}},
        {Capsule{{0x1p-147, 0x1p-147, -0x1.1a6264p-52}, {-0x1.a79396p-53, 0x0p+0, -0x1p-147}, 0x1p-30},
         Capsule{{-0x1.3377dap-2, 0x1.32cc38p-30, 0x1.8p-148}, {-0x1.4cddf6p+0, -0x1.334cf2p-28, 0x1p-149}, 0x0p+0},
         {0x1.8e93fep-2, 0x1.2b898cp-35, 0x1.5de4f2p-31}},
        {Capsule{
             {-0x1p-148, 0x1.1a6264p-54, 0x1.fffffep-1}, {-0x1p-148, 0x1.1a6264p-54, 0x1.fffffep-1}, 0x1.1a6264p-55},
         Capsule{{-0x1.2f491ep-52, 0x1.b7eadap-23, -0x1.205488p-3},
                 {0x1.8d8ef8p-55, -0x1.205498p-25, -0x1.240a94p+0},
                 0x1p-35},
         {0x0p+0, -0x1.547874p-55, 0x1.000002p+1}},
        {Triangle{{-0x1.fffffep-1, -0x1p+0, 0x1p+0}, {0x1.8p-148, 0x1p+0, 0x1.1a6264p-54}, {-0x1p+1, 0x1p-30, -0x1p-1}},
         Capsule{{0x1.1f2094p-31, 0x1.80f2e4p-1, -0x1.ab569ep-37},
                 {-0x1.837dc4p-33, -0x1.fc3492p-3, -0x1.ab58d4p-37},
                 0x1p-36},
         {0x1.a79396p-53, 0x1p+0, 0x1.1a6266p-53}},
    };
    for (const auto& [other, moving, way] : encounters) {
        Hit hit;
        REQUIRE(sweep(other, moving, way, hit));
        CHECK(hit.t > 0);
        CHECK(overlaps(other, grown(moved(moving, way * hit.t), 0x1p-40 * length(way))));
        CHECK(dot(hit.normal, way) <= 1e-15 * length(way));
    }
}

TEST_CASE("sweep of solids: what is thin is met with a plane between the two", "[sweep]") {
    const NoTraps watch;
    struct Encounter {
        Shape other, moving;
        gphys_vec3 way;
    };
    // Segments that move along themselves and past what they meet; capsules and boxes that a long way takes past an
    // edge; flat boxes; balls that are little more than points at corners.
    const Encounter encounters[] = {
        {widen(gphys_sphere{{-0x1p-1f, 0x1.1a6264p-52f, 0x1.1a6268p-54f}, 0}),
         widen(gphys_capsule{{-0x1.556ddp-2f, 0x1.02d36ep-54f, 0x1.55d9dp-41f},
                             {0x1.554918p-1f, 0x1.0e9aecp-53f, -0x1.d543acp-38f},
                             0}),
         {-0x1p-1f, 0x1.a79398p-52f, -0x1.a79394p-52f}},
        {widen(gphys_sphere{{0x1.000002p-1f, 0x1.000004p+15f, 0}, 0}),
         widen(gphys_capsule{{-0x1p-55f, 0x1.d8b482p-1f, 0}, {-0x1p-55f, -0x1.3a5beap-4f, 0}, 0}),
         {0x1.000002p-1f, 0x1.000004p+15f, 0}},
        {widen(gphys_sphere{{-0x1p-148f, -0x1.1a6268p-54f, -0x1p-148f}, 0}),
         widen(gphys_capsule{{0x1.74bd4cp-22f, 0x1.45a15ap-1f, -0x1.8p-23f},
                             {-0x1.45a15ap-21f, 0x1.a2d0acp+0f, -0x1.8p-23f},
                             0x1.8p-37f}),
         {0x1.1a6264p-53f, -0x1p+1f, 0x1.8p-22f}},
        {widen(gphys_capsule{
             {-0x1.1a6266p-54f, 0x1p-148f, -0x1p-34f}, {-0x1p-148f, 0x1.8p-51f, -0x1.fffffep-1f}, 0x1.21295ep-63f}),
         widen(gphys_capsule{{0, -0x1p-40f, -0x1p+0f}, {0, -0x1p-40f, -0x1p+0f}, 0}),
         {0, 0x1.000d48p-39f, 0x1.725c72p+0f}},
        {widen(gphys_capsule{
             {0x1.1a6264p-54f, -0x1.fffffcp-57f, 0x1p+5f}, {-0x1p-147f, -0x1.1a6264p-52f, 0}, 0x1.1a6264p-55f}),
         widen(gphys_capsule{{0, -0x1p-31f, -0x1p+0f}, {0, -0x1p-31f, -0x1p+0f}, 0}),
         {-0x1.81f86p-55f, 0x1.fffffp-31f, 0x1.842f68p+3f}},
        {widen(gphys_capsule{{-0x1p+20f, -0x1p+0f, -0x1.fffffep-1f}, {0x1.1a6264p-54f, 0x1p-147f, -0x1.8p-148f}, 0}),
         widen(gphys_capsule{{0x1p+0f, -0x1.8p-41f, -0x1p-52f}, {0x1p+0f, -0x1.8p-41f, -0x1p-52f}, 0}),
         {-0x1.de0428p+19f, -0x1.de0408p-1f, -0x1.de0406p-1f}},
        {widen(gphys_capsule{{0x1p-147f, 0x1.8p+21f, -0x1.000002p+0f},
                             {0x1.1a6264p-54f, 0x1.1a6264p-54f, 0x1.1a6264p-53f},
                             0x1.8p-17f}),
         widen(gphys_obb{{0x1.2b367p+2f, -0x1.93d1e8p+2f, 0x1.7bc33ap+2f},
                         {0x1p-2f, 0x1p-2f, 0x1.1a6264p-54f},
                         {0, 0x1.6a09e6p-1f, 0, 0x1.6a09e6p-1f}}),
         {-0x1.2b3672p+3f, 0x1.f2e80cp+20f, -0x1.808cfep+3f}},
        {widen(gphys_capsule{{0x1p-147f, -0x1.a79394p-53f, 0x1.000002p+22f},
                             {-0x1p+0f, -0x1.1a6264p-54f, -0x1.1a6264p-54f},
                             0x1.0624dep-13f}),
         widen(gphys_obb{{-0x1p-49f, 0x1p-53f, 0},
                         {0x1.8p-148f, 0x1.1a6264p-54f, 0x1.1a6264p-54f},
                         {0, 0x1.6a09e6p-1f, 0, 0x1.6a09e6p-1f}}),
         {-0x1.dadddep-13f, 0x1.709d6p-16f, 0x1.000002p+23f}},
        {widen(gphys_capsule{{0x1p-147f, -0x1.a79394p-53f, 0x1.000002p+22f},
                             {-0x1p+0f, -0x1.1a6264p-54f, -0x1.1a6264p-54f},
                             0x1.0624dep-13f}),
         widen(gphys_obb{{0, 0x1p-2f, 0x1p+0f}, {0x1.1a6264p-54f, 0x1.1a6264p-54f, 0x1p+0f}, {0, 0, 0, 0x1p+0f}}),
         {0x1.6478dap-16f, -0x1.ffdd0cp-2f, 0x1.000002p+23f}},
        {widen(gphys_obb{{0x1.1a6264p-54f, -0x1p-147f, 0x1p+0f}, {0, 0, 0x1.8p-51f}, {0, 0, 0, 0x1p+0f}}),
         widen(gphys_capsule{{0, 0, 0x1p-2f}, {-0x1.4p+0f, -0x1.1a6264p-54f, 0x1.4p+0f}, 0}),
         {0x1.1a6264p-52f, -0x1p-146f, 0x1.8p+0f}},
        {widen(gphys_triangle{{0x1.fffffep-1f, -0x1.fffffcp-1f, 0x1.a79396p-53f},
                              {-0x1p-148f, -0x1p+0f, 0x1p+0f},
                              {-0x1p+0f, -0x1.1a6264p-54f, 0}}),
         widen(gphys_sphere{{0, 0, -0x1.a79396p-53f}, 0x1.8p-148f}),
         {0x1.fffffep-1f, -0x1.fffffcp-1f, 0x1.a79396p-52f}},
        {widen(gphys_triangle{
             {-0x1p-149f, 0x1.4p-147f, 0x1p+0f}, {0x1.8p-148f, 0x1p+0f, -0x1p-147f}, {0x1.000002p+3f, 0, -0x1p-148f}}),
         widen(gphys_sphere{{-0x1.90e3bap-29f, 0x1.33d142p-29f, 0}, 0x1p-28f}),
         {0x1.8p-147f, 0x1.7df728p+1f, -0x1.ep-145f}},
    };
    for (const auto& [other, moving, displacement] : encounters) {
        const Vec3 way = widen(displacement);
        Hit hit;
        REQUIRE(sweep(other, moving, way, hit));
        CHECK(hit.t > 0);
        const Shape there = moved(moving, way * hit.t);
        const test::Hull shape = twin_of(other), solid = twin_of(there);
        double size = max_component(abs(way));
        for (const Vec3& corner : shape.corners) size = std::max(size, length(corner - solid.corners[0]));
        CHECK(overlaps(other, grown(there, 0x1p-40 * size)));
        CHECK(dot(hit.normal, way) <= 1e-15 * length(way));
        CHECK(beyond_plane(shape, solid, hit.point, hit.normal) < 0x1p-20 * size);
    }
}

TEST_CASE("sweep of solids: rounding in the plane of a flat box makes no contact beside it", "[sweep]") {
    const Shape triangle = widen(gphys_triangle{{0x1p-148f, -0x1p-25f, 0x1.1a6266p-54f},
                                                {0x1.000002p+0f, -0x1.1a6264p-54f, -0x1.1a6264p-54f},
                                                {-0x1.1a6264p-53f, -0x1.fffffep-15f, -0x1p-149f}});
    const Shape plate = widen(
        gphys_obb{{0x1p+0f, 0x1p+0f, 0}, {0x1.8p-148f, 0, 0x1.1a6264p-54f}, {0, 0x1.6a09e6p-1f, 0, 0x1.6a09e6p-1f}});
    Hit hit;
    CHECK_FALSE(sweep(triangle, plate, widen(gphys_vec3{-0x1p+1f, -0x1p+1f, 0x1.1a6266p-53f}), hit));
}

TEST_CASE("sweep of solids: a contact with a triangle until t_max is that of the whole way", "[sweep]") {
    const NoTraps watch;
    SolidCases pairs(43);
    int found = 0, wrong = 0, later = 0, left_out = 0;
    for (int i = 0; i < cases; ++i) {
        const SolidPair pair = pairs.next(6);
        const auto* triangle = std::get_if<Triangle>(&pair.other);
        if (!triangle) continue;
        Hit whole;
        const bool met = sweep(*triangle, pair.moving, pair.way, whole);
        for (const double t_max : {whole.t, whole.t * (1 + 0x1p-40), whole.t / 2, pairs.random.uniform(0, 1)}) {
            Hit hit;
            const bool until = sweep(*triangle, pair.moving, pair.way, hit, std::min(t_max, 1.0));
            if (met && whole.t <= t_max) {
                ++found;
                wrong += !until || hit.t != whole.t || hit.normal != whole.normal || hit.point != whole.point;
            } else {
                wrong += until && (!met || hit.t != whole.t);
                later += met;
                left_out += met && !until;
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(found > 5000);
    // Those of boxes are not.
    CHECK(left_out > later / 4);
}

#include "scene/quick_tests.h"

#include <cfenv>

#include "meshes.h"
#include "test.h"

using namespace gphys;

namespace {

/// Coordinates on a coarse lattice make touches, edges in one line and zero components frequent.
class Cases {
public:
    explicit Cases(uint64_t seed) : random_(seed) {}

    bool coarse() const { return coarse_; }
    void next() { coarse_ = random_.index(2) == 0; }

    float number(float extent) {
        const float value = random_.uniform_float(-extent, extent);
        return coarse_ ? std::round(value) : value;
    }
    gphys_vec3 point(float extent) { return {number(extent), number(extent), number(extent)}; }
    float size() { return std::fabs(number(3)); }
    gphys_quat rotation() {
        if (coarse_) return random_.index(2) == 0 ? gphys_quat{0, 0, 0, 1} : gphys_quat{0, 0, 0.70710678f, 0.70710678f};
        // Any length that is let in.
        const Quat q = normalized(Quat{number(1), number(1), number(1), 1.01});
        const double length = random_.uniform_float(0.9995f, 1.0005f);
        return narrow(Quat{q.x * length, q.y * length, q.z * length, q.w * length});
    }
    gphys_transform transform() { return {point(5), rotation(), coarse_ ? 2.0f : random_.uniform_float(0.2f, 3)}; }
    gphys_sphere sphere() { return {point(2), size()}; }
    gphys_aabb aabb() {
        const gphys_vec3 center = random_.index(2) == 0 ? gphys_vec3{0, 0, 0} : point(2), half{size(), size(), size()};
        return {{center.x - half.x, center.y - half.y, center.z - half.z},
                {center.x + half.x, center.y + half.y, center.z + half.z}};
    }
    gphys_obb obb() { return {point(2), {size(), size(), size()}, rotation()}; }
    Ray ray() {
        const gphys_vec3 direction = point(3);
        return {widen(point(12)), widen(direction), random_.index(3) == 0 ? infinity : std::fabs(number(4))};
    }

private:
    test::Random random_;
    bool coarse_ = false;
};

/// How often each verdict was given.
struct Tally {
    int no = 0, yes = 0, open = 0;

    /// Whether the verdict agrees with the exact answer.
    bool add(Verdict verdict, bool truth) {
        ++(verdict == Verdict::no ? no : verdict == Verdict::yes ? yes : open);
        return verdict == Verdict::open || (verdict == Verdict::yes) == truth;
    }
};

/// Ask `quick` and `exact` about a random stored shape where a random transform puts it.
template <class Quick, class Exact>
bool agree(Cases& cases, Tally& tally, Quick&& quick, Exact&& exact) {
    const gphys_transform world = cases.transform();
    const auto compare = [&](const auto& stored) {
        return with_placed(stored, world, [&](const auto& placed) {
            return tally.add(quick_verdict(stored, world, quick), exact(placed));
        });
    };
    return compare(cases.sphere()) && compare(cases.aabb()) && compare(cases.obb());
}

}  // namespace

TEST_CASE("quick tests of rays never contradict the exact ones") {
    Cases cases(71);
    Tally fine, coarse;
    for (int i = 0; i < 40000; ++i) {
        cases.next();
        const Ray ray = cases.ray();
        const QuickRay quick(ray);
        REQUIRE(agree(
            cases, cases.coarse() ? coarse : fine, [&](const auto& shape) { return quick(shape, ray.t_max); },
            [&](const auto& shape) {
                Hit hit;
                return raycast(shape, ray, hit);
            }));
    }
    CHECK(fine.no > 10000);
    CHECK(fine.yes > 1000);
    // Rays that end within a sphere are left open.
    CHECK(fine.open < 100);
    CHECK(coarse.open > 100);
}

TEST_CASE("quick tests of points with a reach never contradict the exact ones") {
    Cases cases(72);
    Tally fine, coarse;
    for (int i = 0; i < 40000; ++i) {
        cases.next();
        const Vec3 point = widen(cases.point(8));
        const double reach = cases.size();
        const QuickPoint quick(point);
        REQUIRE(agree(
            cases, cases.coarse() ? coarse : fine, [&](const auto& shape) { return quick(shape, reach); },
            [&](const auto& shape) {
                return overlaps(Shape(Sphere{point, reach}), Shape(shape));
            }));
    }
    CHECK(fine.no > 10000);
    CHECK(fine.yes > 5000);
    CHECK(fine.open < 10);
    CHECK(coarse.open > 100);
}

TEST_CASE("quick tests of boxes never contradict the exact ones") {
    Cases cases(73);
    Tally fine, coarse;
    for (int i = 0; i < 40000; ++i) {
        cases.next();
        Tally& tally = cases.coarse() ? coarse : fine;
        const Aabb aabb = widen(cases.aabb());
        REQUIRE(agree(cases, tally, QuickBlock(as_obb(aabb)),
                      [&](const auto& shape) { return overlaps(Shape(aabb), Shape(shape)); }));
        const Obb obb = widen(cases.obb());
        REQUIRE(agree(cases, tally, QuickBlock(obb),
                      [&](const auto& shape) { return overlaps(Shape(obb), Shape(shape)); }));
    }
    CHECK(fine.no > 10000);
    CHECK(fine.yes > 10000);
    CHECK(fine.open < 10);
    CHECK(coarse.open > 100);
}

TEST_CASE("of eight rays at once none that meets a box is refused, and nearly all others are, on any instruction set") {
    Cases cases(74);
    int met = 0, missed = 0, refused = 0;
    for (int i = 0; i < 20000; ++i) {
        cases.next();
        // Numbers below the smallest normal float, too.
        const float scale = i % 8 == 0 ? 0x1p-147f : 1;
        const auto scaled = [&](gphys_vec3 v) { return narrow(widen(v) * scale); };
        RayLanes lanes{};
        Ray rays[8];
        const uint32_t first = static_cast<uint32_t>(i) % RayLanes::most;
        for (uint32_t k = 0; k < 8; ++k) {
            const Ray ray = cases.ray();
            rays[k] = {widen(scaled(narrow(ray.origin))), ray.direction, ray.t_max * scale};
            QuickRay(rays[k]).put(lanes, first + k, rays[k].t_max);
        }
        gphys_transform world = cases.transform();
        world.position = scaled(world.position);
        const auto ask = [&](const auto& stored) {
            const BoxLanes box(quick_shape(stored, world));
            uint32_t truth = 0;
            with_placed(stored, world, [&](const auto& placed) {
                for (uint32_t k = 0; k < 8; ++k) {
                    Hit hit;
                    truth |= uint32_t{raycast(placed, rays[k], hit)} << k;
                }
            });
            for (const Isa isa : test::isas()) {
                const uint32_t may_meet = scene_kernels(isa).may_meet(lanes, first, box);
                REQUIRE((truth & ~may_meet) == 0);
                REQUIRE(may_meet == scene_kernels(Isa::scalar).may_meet(lanes, first, box));
                refused += __builtin_popcount(~may_meet & 0xff);
                missed += 8 - __builtin_popcount(truth);
                met += __builtin_popcount(truth);
            }
        };
        const gphys_aabb aabb = cases.aabb();
        ask(gphys_aabb{scaled(aabb.min), scaled(aabb.max)});
        const gphys_obb obb = cases.obb();
        ask(gphys_obb{scaled(obb.center), scaled(obb.half_extents), obb.rotation});
    }
    CHECK(met > 30000);
    // The tiny eighth is not.
    CHECK(refused > missed * 0.87);
}

TEST_CASE("of eight boxes at once a ball is told the truth, or nothing, and the same on any instruction set") {
    // As scenes keep models that are Aabbs.
    struct Stored {
        gphys_transform world;
        float words[2];
        gphys_aabb box;
    };
    Cases cases(75);
    Tally fine, coarse, elsewhere;
    for (int i = 0; i < 20000; ++i) {
        cases.next();
        // Numbers below the smallest normal float, too.
        const bool tiny = i % 8 == 0, touching = i % 4 == 1;
        const float scale = tiny ? 0x1p-147f : 1;
        const auto scaled = [&](gphys_vec3 v) { return narrow(widen(v) * scale); };
        // In any order, and one of them twice.
        constexpr uint32_t order[8] = {6, 2, 0, 5, 3, 1, 4, 2};
        Stored stored[7];
        uint32_t first_quad[8];
        for (Stored& s : stored) {
            s = {cases.transform(), {NAN, INFINITY}, cases.aabb()};
            s.world.position = scaled(s.world.position);
            s.box = {scaled(s.box.min), scaled(s.box.max)};
        }
        for (int k = 0; k < 8; ++k) first_quad[k] = 4 * order[k];
        Vec3 center = widen(scaled(cases.point(8)));
        float radius = cases.size() * scale;
        if (touching) {
            // All but touches one of them, from nearby.
            with_placed(stored[0].box, stored[0].world, [&](const auto& placed) {
                const Vec3 outside = closest_point(placed, center), away = center - outside;
                center = widen(narrow(outside + away * std::exp2(cases.number(10) - 10)));
                radius = static_cast<float>(length(center - closest_point(placed, center)));
            });
        }
        const BallLanes ball(center, radius);
        const auto* quads = reinterpret_cast<const float*>(stored);
        const BoxVerdicts verdicts = scene_kernels(Isa::scalar).boxes_near(quads, first_quad, ball);
        for (const Isa isa : test::isas()) {
            const BoxVerdicts same = scene_kernels(isa).boxes_near(quads, first_quad, ball);
            REQUIRE((same.no == verdicts.no && same.yes == verdicts.yes));
        }
        REQUIRE((verdicts.no & verdicts.yes) == 0);
        for (int k = 0; k < 8; ++k) {
            const Stored& s = stored[order[k]];
            const bool truth = with_placed(s.box, s.world, [&](const auto& placed) {
                return overlaps(Shape(Sphere{center, radius}), Shape(placed));
            });
            const uint32_t no = verdicts.no >> k & 1, yes = verdicts.yes >> k & 1;
            const bool centered = widen(s.box.min) == -widen(s.box.max);
            Tally& tally = !centered ? elsewhere : tiny || touching || cases.coarse() ? coarse : fine;
            REQUIRE(tally.add(no ? Verdict::no : yes ? Verdict::yes : Verdict::open, truth));
        }
    }
    CHECK(fine.no > 10000);
    CHECK(fine.yes > 2000);
    CHECK(fine.open < 10);
    CHECK(coarse.open > 100);
    CHECK(elsewhere.no + elsewhere.yes == 0);
}

TEST_CASE("quick tests raise no floating-point exception, however far the ray and the point reach") {
    const gphys_transform world{{1e15f, -1e15f, 1}, {0, 0, 0.6f, 0.8f}, 1e15f};
    const gphys_aabb box{{-1e15f, -1, 0}, {1e15f, 1, 0}};
    std::feclearexcept(FE_ALL_EXCEPT);
    int denied = 0;
    for (const Vec3 direction : {Vec3{1, 0, 0}, Vec3{1e-45, 0, 0}, Vec3{1e15, 1e15, 1e15}, Vec3{}}) {
        const Ray ray{{-1e15, 0, 0}, direction};
        const QuickRay quick(ray);
        denied += quick(QuickPlacedBox<gphys_aabb>{box, world}, ray.t_max) == Verdict::no;
        denied += quick(quick_shape(gphys_sphere{{1e15f, 0, 0}, 1e15f}, world), ray.t_max) == Verdict::no;
        RayLanes lanes{};
        quick.put(lanes, 0, ray.t_max);
        for (const Isa isa : test::isas()) scene_kernels(isa).may_meet(lanes, 0, BoxLanes(quick_shape(box, world)));
    }
    denied += QuickPoint({})(quick_shape(box, world), infinity) == Verdict::no;
    // As large as scenes hold boxes.
    const gphys_transform unscaled{world.position, world.rotation, 1};
    const QuickPlacedBox<gphys_aabb> placed{box, unscaled};
    CHECK(QuickPoint({})(placed, infinity) != Verdict::no);
    CHECK(QuickPoint({-1e15, 1e15, 1e15})(placed, 0) == Verdict::no);
    struct {
        gphys_transform world;
        float words[2];
        gphys_aabb box;
    } const stored{unscaled, {NAN, INFINITY}, box};
    constexpr uint32_t same[8] = {};
    for (const Isa isa : test::isas()) {
        const auto* quads = reinterpret_cast<const float*>(&stored);
        scene_kernels(isa).boxes_near(quads, same, BallLanes({-1e15, 1e15, 1e15}, 1e15));
        scene_kernels(isa).boxes_near(quads, same, BallLanes({}, 0));
    }
    CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
    CHECK(denied < 9);
}

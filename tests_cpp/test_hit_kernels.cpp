#include "scene/hit_kernels.h"

#include <cfenv>
#include <cstring>

#include "eight_cases.h"
#include "meshes.h"

using namespace gphys;

namespace {

using HitEight = TriStates8 (*HitKernels::*)(const RaysAndModels<Ray>& pairs, Hits8& hits);

HitEight kernel_for(const EightCases<gphys_sphere>&) { return &HitKernels::spheres; }
HitEight kernel_for(const EightCases<gphys_aabb>&) { return &HitKernels::aabbs; }
HitEight kernel_for(const EightCases<gphys_obb>&) { return &HitKernels::obbs; }

/// Those of the wide sets that this processor has.
std::vector<const HitKernels*> all_kernels() {
    std::vector<const HitKernels*> all;
    for (const Isa isa : test::isas()) {
        if (const HitKernels* kernels = hit_kernels(isa)) all.push_back(kernels);
    }
    return all;
}

bool same_hit(const Hits8& hits, int k, const Hit& hit) {
    const gphys_hit expected = to_hit(hit);
    const Hits8::Rounded& rounded = hits.rounded[k];
    return std::memcmp(&hits.t[k], &hit.t, sizeof hit.t) == 0 && std::memcmp(&rounded.t, &expected.t, 7 * 4) == 0 &&
           hit.flags == 0;
}

}  // namespace

TEST_CASE("of eight rays each gets the hit that it gets alone, or is left open, the same on any wide instruction set") {
    const std::vector<const HitKernels*> all = all_kernels();
    if (all.empty()) return;
    HitTallies spheres, aabbs, obbs;
    compare_many_eights(74, spheres, aabbs, obbs, [&all](const auto& eight, HitTallies& tallies) {
        const auto pairs = eight.pairs(eight.rays);
        const HitEight meet = kernel_for(eight);
        Hits8 hits, same_hits;
        const TriStates8 verdicts = (all.front()->*meet)(pairs, hits);
        for (const HitKernels* kernels : all) {
            const TriStates8 same = (kernels->*meet)(pairs, same_hits);
            REQUIRE((same.no == verdicts.no && same.yes == verdicts.yes));
            for (int k = 0; k < 8; ++k) {
                if ((verdicts.yes >> k & 1) == 0) continue;
                REQUIRE(hits.t[k] == same_hits.t[k]);
                REQUIRE(std::memcmp(&hits.rounded[k], &same_hits.rounded[k], 7 * 4) == 0);
            }
        }
        REQUIRE((verdicts.no & verdicts.yes) == 0);
        for (int k = 0; k < 8; ++k) {
            const TriState verdict = verdict_of(verdicts, k);
            Hit hit;
            const bool truth = eight.meets(k, hit);
            if (verdict == TriState::yes) REQUIRE(same_hit(hits, k, hit));
            if (verdict == TriState::undecided && truth && hit.flags != 0) {
                ++tallies.inside;
            } else {
                REQUIRE(eight.tally_of(k, tallies).add(verdict, truth));
            }
        }
    });
    for (const HitTallies* tallies : {&spheres, &aabbs, &obbs}) check_tallies(*tallies);
}

TEST_CASE("of eight rays along an axis or a face of boxes without rotation, those from outside are decided") {
    test::Random random(76);
    int yes = 0, no = 0, wrong = 0, open = 0;
    for (int i = 0; i < 20000; ++i) {
        const gphys_vec3 middle = random.point(3), half = random.point(1), at = random.point(10);
        const Vec3 reach = abs(widen(half));
        const gphys_aabb box{narrow(widen(middle) - reach), narrow(widen(middle) + reach)};
        const StoredModel model({at, {0, 0, 0, 1}, random.uniform_float(0.5f, 2)}, box);
        Vec3 direction = random.direction();
        for (uint32_t axis = random.index(3), zeros = 1 + random.index(2); zeros > 0; --zeros) {
            direction[static_cast<int>((axis + zeros) % 3)] = random.index(2) == 0 ? 0.0 : -0.0;
        }
        const Vec3 target =
            widen(at) + (widen(middle) + widen(random.point(1.2f))) * static_cast<double>(model.world.scale);
        const Ray ray{widen(narrow(target - direction * 10)), direction, random.index(4) == 0 ? 10 : infinity};
        Hit expected;
        const bool meets =
            with_placed(box, model.world, [&](const auto& placed) { return raycast(placed, ray, expected); });
        if (meets && expected.flags != 0) continue;
        RaysAndModels<Ray> pairs;
        std::fill_n(pairs.ray, 8, &ray);
        std::fill_n(pairs.model, 8, &model.world.position.x);
        std::fill_n(pairs.other, 8, nullptr);
        for (const HitKernels* kernels : all_kernels()) {
            Hits8 hits;
            const TriStates8 verdicts = kernels->aabbs(pairs, hits);
            wrong += verdicts.yes != 0 ? !meets || !same_hit(hits, 3, expected) : verdicts.no != 0 && meets;
            open += (verdicts.yes | verdicts.no) != 0xff;
            yes += verdicts.yes != 0;
            no += verdicts.no != 0;
        }
    }
    CHECK(wrong == 0);
    CHECK(open == 0);
    CHECK((all_kernels().empty() || (yes > 2000 && no > 2000)));
}

TEST_CASE("of eight rays those that miss the ball around a mesh are told so, however far away, and no other") {
    const std::vector<const HitKernels*> all = all_kernels();
    test::Random random(75);
    int missed = 0;
    for (int i = 0; i < 20000; ++i) {
        const float far = std::exp2(random.uniform_float(0, 24));
        const gphys_sphere ball{random.point(1), random.uniform_float(0, 2)};
        const StoredModel model({random.point(far), random.rotation(), random.uniform_float(0.5f, 2)}, ball);
        const Sphere placed = transformed(widen(ball), widen(model.world));
        // Past the ball, at about its radius from the centre, from wherever.
        const Vec3 away = random.direction(), along = normalized(cross(away, random.direction()));
        const double distance = placed.radius * (1 + std::exp2(random.uniform(-40, 0)) * random.uniform(-1, 1));
        Ray ray{placed.center + away * distance - along * far, along * far, infinity};
        if (i % 4 == 0) ray = {placed.center + away * (distance + far), away * -far, random.uniform(0.5, 1.5)};
        RaysAndModels<Ray> pairs;
        std::fill_n(pairs.ray, 8, &ray);
        std::fill_n(pairs.model, 8, &model.world.position.x);
        std::fill_n(pairs.other, 8, &ball.center.x);
        Hit hit;
        const bool meets = raycast(placed, ray, hit);
        const Sphere larger{placed.center, placed.radius + 1e-11 * (far + placed.radius)};
        const bool meets_larger = raycast(larger, ray, hit);
        for (const HitKernels* kernels : all) {
            const uint32_t no = kernels->miss_balls(pairs);
            REQUIRE((no == 0 || no == 0xff));
            if (meets) REQUIRE(no == 0);
            if (!meets_larger) REQUIRE(no == 0xff);
        }
        missed += !meets_larger;
    }
    CHECK(missed > 5000);
}

TEST_CASE("hits of eight raise no floating-point exception, however far the rays reach") {
    // As large as scenes hold boxes.
    const gphys_transform world{{1e15f, -1e15f, 1}, {0, 0, 0.6f, 0.8f}, 1}, unturned{world.position, {0, 0, 0, 1}, 1};
    const gphys_sphere sphere{{1e15f, 0, 0}, 1e15f}, point{{}, 0};
    const gphys_aabb box{{-1e15f, -1, 0}, {1e15f, 1, 0}};
    const gphys_obb obb{{1e15f, 0, 0}, {1e15f, 1e15f, 1e15f}, {0, 0, 0.6f, 0.8f}};
    const std::vector<const HitKernels*> all = all_kernels();
    int met = 0;
    std::feclearexcept(FE_ALL_EXCEPT);
    for (const gphys_transform& at : {world, unturned}) {
        for (const Vec3 direction : {Vec3{1, 0, 0}, Vec3{1e-45, 0, 0}, Vec3{1e15, -1e15, 1e15}, Vec3{}}) {
            for (const double t_max : {infinity, 0.0, -1.0, 1e38}) {
                const Ray ray{{-1e15, -1e15, 1}, direction, t_max};
                const auto pairs_with = [&](const StoredModel& model, const float* other) {
                    RaysAndModels<Ray> pairs;
                    std::fill_n(pairs.ray, 8, &ray);
                    std::fill_n(pairs.model, 8, &model.world.position.x);
                    std::fill_n(pairs.other, 8, other);
                    return pairs;
                };
                for (const HitKernels* kernels : all) {
                    Hits8 hits;
                    met += kernels->spheres(pairs_with({at, sphere}, &sphere.center.x), hits).yes != 0;
                    met += kernels->spheres(pairs_with({at, point}, &point.center.x), hits).yes != 0;
                    met += kernels->aabbs(pairs_with({at, box}, nullptr), hits).yes != 0;
                    met += kernels->obbs(pairs_with({at, obb}, &obb.rotation.x), hits).yes != 0;
                    met += kernels->miss_balls(pairs_with({at, sphere}, &sphere.center.x)) == 0;
                }
            }
        }
    }
    CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
    CHECK((met > 0 || all.empty()));
}

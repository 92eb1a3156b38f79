#include "scene/box_kernels.h"

#include <cfenv>
#include <cstring>

#include "eight_cases.h"
#include "meshes.h"
#include "ray_cases.h"

using namespace gphys;

namespace {

/// Those of the wide sets that this processor has.
std::vector<const BoxKernels*> all_kernels() {
    std::vector<const BoxKernels*> all;
    for (const Isa isa : test::isas()) {
        if (const BoxKernels* kernels = box_kernels(isa)) all.push_back(kernels);
    }
    return all;
}

/// One of eight pairs, asked with and without the hit.
struct Asked {
    TriState verdict, without_hit;
    Hits8::Rounded hit;
};
Asked ask(const BoxKernels& kernels, const EightCases<gphys_aabb>&, const RaysAndModels<Ray>& pairs, int k) {
    Asked asked{};
    asked.verdict = kernels.raycast_aabb(*pairs.ray[k], pairs.model[k], asked.hit);
    asked.without_hit = kernels.meets_aabb(*pairs.ray[k], pairs.model[k]);
    return asked;
}
Asked ask(const BoxKernels& kernels, const EightCases<gphys_obb>&, const RaysAndModels<Ray>& pairs, int k) {
    Asked asked{};
    asked.verdict = kernels.raycast_obb(*pairs.ray[k], pairs.model[k], pairs.other[k], asked.hit);
    asked.without_hit = kernels.meets_obb(*pairs.ray[k], pairs.model[k], pairs.other[k]);
    return asked;
}

bool same_hit(const Hits8::Rounded& rounded, const Hit& hit) {
    const gphys_hit expected = to_hit(hit);
    return std::memcmp(&rounded.t, &expected.t, 7 * 4) == 0 && hit.flags == 0;
}

}  // namespace

TEST_CASE("a ray at a box gets the hit of the exact test, or is left open, the same on any wide instruction set") {
    const std::vector<const BoxKernels*> all = all_kernels();
    if (all.empty()) return;
    HitTallies spheres, aabbs, obbs;
    compare_many_eights(76, spheres, aabbs, obbs, [&all](const auto& eight, HitTallies& tallies) {
        if constexpr (!std::is_same_v<decltype(eight), const EightCases<gphys_sphere>&>) {
            const auto pairs = eight.pairs(eight.rays);
            for (int k = 0; k < 8; ++k) {
                Hit hit;
                const bool truth = eight.meets(k, hit);
                const Asked asked = ask(*all.front(), eight, pairs, k);
                for (const BoxKernels* kernels : all) {
                    const Asked same = ask(*kernels, eight, pairs, k);
                    REQUIRE((same.verdict == asked.verdict && same.without_hit == asked.verdict));
                    if (same.verdict == TriState::yes) REQUIRE(same_hit(same.hit, hit));
                }
                if (asked.verdict == TriState::undecided && truth && hit.flags != 0) {
                    ++tallies.inside;
                } else {
                    REQUIRE(eight.tally_of(k, tallies).add(asked.verdict, truth));
                }
            }
        }
    });
    check_tallies(aabbs);
    check_tallies(obbs);
}

TEST_CASE("rays along the axes of a box are not left open") {
    const std::vector<const BoxKernels*> all = all_kernels();
    test::Random random(77);
    int met = 0, missed = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 corner = test::grid_point(random, 3), size = abs(test::grid_point(random, 3)) + Vec3{1, 1, 1};
        const gphys_aabb box{narrow(corner), narrow(corner + size)};
        const gphys_transform world{narrow(test::grid_point(random, 3)), {0, 0, 0, 1}, i % 2 == 0 ? 1.0f : 2.0f};
        const StoredModel model(world, box);
        // Half a unit beside all faces and edges.
        Ray ray{test::grid_point(random, 8) + Vec3{0.5, 0.5, 0.5}, test::grid_direction(random, 2), infinity};
        ray.direction[i % 3] = i % 5 == 0 ? -0.0 : 0.0;
        if (i % 4 == 0) ray.t_max = 2.7;
        int moving_axes = 0;
        for (int axis = 0; axis < 3; ++axis) moving_axes += ray.direction[axis] != 0;
        Hit hit;
        const bool truth = with_placed(box, world, [&](const auto& placed) { return raycast(placed, ray, hit); });
        if (truth && hit.flags != 0) continue;
        for (const BoxKernels* kernels : all) {
            Hits8::Rounded found;
            const TriState verdict = kernels->raycast_aabb(ray, &model.world.position.x, found);
            if (verdict == TriState::undecided) {
                // Through an edge of two other axes it may be.
                REQUIRE(moving_axes == 2);
                continue;
            }
            REQUIRE((verdict == TriState::yes) == truth);
            if (truth) REQUIRE(same_hit(found, hit));
        }
        ++(truth ? met : missed);
    }
    CHECK(met > 300);
    CHECK(missed > 5000);
}

TEST_CASE("a ray in the plane of a face gets the point of the exact test, to the sign of its zeros") {
    const std::vector<const BoxKernels*> all = all_kernels();
    int met = 0;
    for (const bool negative_face : {false, true}) {
        for (const bool negative_origin : {false, true}) {
            for (const bool negative_direction : {false, true}) {
                for (const bool is_low : {false, true}) {
                    const float face = negative_face ? -0.0f : 0.0f;
                    const gphys_aabb box{{2, is_low ? face : -1, -1}, {3, is_low ? 1 : face, 1}};
                    const StoredModel model({{}, {0, 0, 0, 1}, 1}, box);
                    const Ray ray{
                        {0, negative_origin ? -0.0 : 0.0, 0.5}, {1, negative_direction ? -0.0 : 0.0, 0}, infinity};
                    Hit hit;
                    REQUIRE(
                        with_placed(box, model.world, [&](const auto& placed) { return raycast(placed, ray, hit); }));
                    for (const BoxKernels* kernels : all) {
                        Hits8::Rounded found;
                        const TriState verdict = kernels->raycast_aabb(ray, &model.world.position.x, found);
                        REQUIRE(verdict != TriState::no);
                        if (verdict == TriState::yes) REQUIRE(same_hit(found, hit));
                        met += verdict == TriState::yes;
                    }
                }
            }
        }
    }
    CHECK((met > 0 || all.empty()));
}

TEST_CASE("rays at boxes raise no floating-point exception, however far they reach") {
    // As large as scenes hold boxes.
    const gphys_transform world{{1e15f, -1e15f, 1}, {0, 0, 0.6f, 0.8f}, 1}, unturned{world.position, {0, 0, 0, 1}, 1};
    const gphys_aabb box{{-1e15f, -1, 0}, {1e15f, 1, 0}};
    const gphys_obb obb{{1e15f, 0, 0}, {1e15f, 1e15f, 1e15f}, {0, 0, 0.6f, 0.8f}};
    const std::vector<const BoxKernels*> all = all_kernels();
    int met = 0;
    const test::NoTraps no_traps;
    for (const gphys_transform& at : {world, unturned}) {
        const StoredModel aabb_model(at, box), obb_model(at, obb);
        for (const Vec3 direction : {Vec3{1, 0, 0}, Vec3{1e-45, 0, 0}, Vec3{1e15, -1e15, 1e15}, Vec3{}}) {
            for (const double t_max : {infinity, 0.0, -1.0, 1e38}) {
                const Ray ray{{-1e15, -1e15, 1}, direction, t_max};
                for (const BoxKernels* kernels : all) {
                    Hits8::Rounded hit;
                    met += kernels->raycast_aabb(ray, &aabb_model.world.position.x, hit) == TriState::yes;
                    met +=
                        kernels->raycast_obb(ray, &obb_model.world.position.x, &obb.rotation.x, hit) == TriState::yes;
                }
            }
        }
    }
    CHECK((met > 0 || all.empty()));
}

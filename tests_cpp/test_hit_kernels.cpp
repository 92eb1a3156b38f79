#include "scene/hit_kernels.h"

#include <cfenv>
#include <cstring>

#include "intersect/intersect.h"
#include "meshes.h"
#include "scene/placed.h"
#include "stored_cases.h"

using namespace gphys;

namespace {

using HitEight = Verdicts8 (*HitKernels::*)(const RaysAndModels<Ray>& pairs, Hits8& hits);

HitEight kernel_of(const gphys_sphere&) { return &HitKernels::spheres; }
HitEight kernel_of(const gphys_aabb&) { return &HitKernels::aabbs; }
HitEight kernel_of(const gphys_obb&) { return &HitKernels::obbs; }
const float* other_of(const gphys_sphere& sphere) { return &sphere.center.x; }
const float* other_of(const gphys_aabb&) { return nullptr; }
const float* other_of(const gphys_obb& box) { return &box.rotation.x; }

void shift(gphys_sphere& sphere, Vec3 by) { sphere.center = narrow(widen(sphere.center) + by); }
void shift(gphys_aabb& box, Vec3 by) { box = {narrow(widen(box.min) + by), narrow(widen(box.max) + by)}; }
void shift(gphys_obb& box, Vec3 by) { box.center = narrow(widen(box.center) + by); }

gphys_vec3 scaled(gphys_vec3 v, float scale) { return narrow(widen(v) * scale); }

struct Tallies {
    Tally fine, touching, tiny;
    int inside = 0;  // of those left open
};

bool same_hit(const Hits8& hits, int k, const Hit& hit) {
    const gphys_hit expected = to_hit(hit);
    const Hits8::Rounded& rounded = hits.rounded[k];
    return std::memcmp(&hits.t[k], &hit.t, sizeof hit.t) == 0 && std::memcmp(&rounded.t, &expected.t, 7 * 4) == 0 &&
           hit.flags == 0;
}

/// Eight rays and as many models, in any order, of which some are met by several rays and some by none.
template <class MakeShape>
void compare_eight(Cases& cases, int round, Tallies& tallies, const MakeShape& make_shape) {
    constexpr uint32_t model_of[8] = {6, 2, 0, 5, 3, 1, 4, 2}, ray_of[8] = {1, 0, 2, 7, 4, 3, 6, 4};
    // Numbers below the smallest normal float, too.
    const bool tiny = round % 8 == 0, touching = round % 4 == 1, shifted = round % 8 == 2;
    const float scale = tiny ? 0x1p-147f : 1;
    using Stored = decltype(make_shape(scale));
    std::vector<Stored> shapes;
    std::vector<StoredModel> models;
    for (int i = 0; i < 7; ++i) {
        gphys_transform world = cases.transform();
        world.position = scaled(world.position, scale);
        if (round % 3 == 0) world = {world.position, {0, i == 1 ? -0.0f : 0, 0, i == 2 ? -1.0f : 1}, 1};
        if (round % 3 == 1 && i % 2 == 0) world.rotation = {0, 0, 0, 1};
        shapes.push_back(make_shape(scale));
        if (shifted) {
            // Far from the origin of its model, which is as far away on the other side.
            const Vec3 by = widen(cases.point(10000));
            shift(shapes.back(), by);
            world.position = narrow(widen(world.position) - widen(world).apply_to_vector(by));
        }
        models.emplace_back(world, shapes.back());
    }
    Ray rays[8];
    for (Ray& ray : rays) {
        ray = cases.ray();
        ray = {widen(scaled(narrow(ray.origin), scale)), ray.direction, ray.t_max * scale};
    }
    // Some are aimed, as few others meet anything.
    for (const int k : {3, 4, 6, 7}) {
        const Vec3 at = widen(models[model_of[k]].world.position) + widen(cases.point(1)) * scale;
        rays[ray_of[k]] = {rays[ray_of[k]].origin, at - rays[ray_of[k]].origin, infinity};
    }
    if (touching) {
        // Past one of them, an edge mostly, by no more than roundings or a little more.
        with_placed(shapes[0], models[0].world, [&](const auto& placed) {
            const Vec3 surface = closest_point(placed, rays[2].origin), out = rays[2].origin - surface;
            const Vec3 across = cross(out, Vec3{1, 2, 3});
            rays[2] = {surface + out * std::exp2(cases.number(24) - 42) - across, across, infinity};
        });
        // Up to another, to the last bit.
        with_placed(shapes[2], models[2].world, [&](const auto& placed) {
            rays[0] = {rays[0].origin, closest_point(placed, rays[0].origin) - rays[0].origin, infinity};
            Hit hit;
            if (!raycast(placed, rays[0], hit)) return;
            const double before = std::nextafter(hit.t, 0), after = std::nextafter(hit.t, infinity);
            rays[0].t_max = round % 12 == 1 ? before : round % 12 == 5 ? hit.t : after;
        });
    }
    RaysAndModels<Ray> pairs;
    for (int k = 0; k < 8; ++k) {
        pairs.ray[k] = rays + ray_of[k];
        pairs.model[k] = &models[model_of[k]].world.position.x;
        pairs.other[k] = other_of(shapes[model_of[k]]);
    }
    const HitEight meet = kernel_of(shapes[0]);
    Hits8 hits, same_hits;
    const Verdicts8 verdicts = (hit_kernels(Isa::scalar).*meet)(pairs, hits);
    for (const Isa isa : test::isas()) {
        const Verdicts8 same = (hit_kernels(isa).*meet)(pairs, same_hits);
        REQUIRE((same.no == verdicts.no && same.yes == verdicts.yes));
        for (int k = 0; k < 8; ++k) {
            if ((verdicts.yes >> k & 1) == 0) continue;
            REQUIRE(hits.t[k] == same_hits.t[k]);
            REQUIRE(std::memcmp(&hits.rounded[k], &same_hits.rounded[k], 7 * 4) == 0);
        }
    }
    REQUIRE((verdicts.no & verdicts.yes) == 0);
    for (int k = 0; k < 8; ++k) {
        Hit hit;
        const bool truth = with_placed(shapes[model_of[k]], models[model_of[k]].world,
                                       [&](const auto& placed) { return raycast(placed, rays[ray_of[k]], hit); });
        const uint32_t no = verdicts.no >> k & 1, yes = verdicts.yes >> k & 1;
        if (yes) REQUIRE(same_hit(hits, k, hit));
        if (!no && !yes && truth && hit.flags != 0) {
            ++tallies.inside;
            continue;
        }
        const bool near = touching && (ray_of[k] == 0 || ray_of[k] == 2);
        Tally& tally = tiny ? tallies.tiny : near || shifted || cases.coarse() ? tallies.touching : tallies.fine;
        REQUIRE(tally.add(no ? Verdict::no : yes ? Verdict::yes : Verdict::open, truth));
    }
}

}  // namespace

TEST_CASE("of eight rays each gets the hit that it gets alone, or is left open, the same on any instruction set") {
    Cases cases(74);
    Tallies spheres, aabbs, obbs;
    for (int i = 0; i < 12000; ++i) {
        cases.next();
        compare_eight(cases, i, spheres, [&](float scale) {
            const gphys_sphere sphere = cases.sphere();
            return gphys_sphere{scaled(sphere.center, scale), sphere.radius * scale};
        });
        compare_eight(cases, i, aabbs, [&](float scale) {
            const gphys_aabb box = cases.aabb();
            return gphys_aabb{scaled(box.min, scale), scaled(box.max, scale)};
        });
        compare_eight(cases, i, obbs, [&](float scale) {
            const gphys_obb box = cases.obb();
            return gphys_obb{scaled(box.center, scale), scaled(box.half_extents, scale), box.rotation};
        });
    }
    for (const Tallies* tallies : {&spheres, &aabbs, &obbs}) {
        const Tally &fine = tallies->fine, &touching = tallies->touching, &tiny = tallies->tiny;
        INFO(fine.no << " " << fine.yes << " " << fine.open << ", " << touching.no << " " << touching.yes << " "
                     << touching.open << ", " << tiny.no << " " << tiny.yes << " " << tiny.open << ", "
                     << tallies->inside);
        CHECK(fine.no > 20000);
        CHECK(fine.yes > 500);
        CHECK(fine.open < 10);
        CHECK(touching.yes > 1000);
        CHECK(touching.open > 100);
        CHECK(tiny.yes > 100);
        CHECK(tallies->inside > 1000);
    }
}

TEST_CASE("of eight rays those that miss the ball around a mesh are told so, however far away, and no other") {
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
        for (const Isa isa : test::isas()) {
            const uint32_t no = hit_kernels(isa).miss_balls(pairs);
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
                for (const Isa isa : test::isas()) {
                    const HitKernels& kernels = hit_kernels(isa);
                    Hits8 hits;
                    met += kernels.spheres(pairs_with({at, sphere}, &sphere.center.x), hits).yes != 0;
                    met += kernels.spheres(pairs_with({at, point}, &point.center.x), hits).yes != 0;
                    met += kernels.aabbs(pairs_with({at, box}, nullptr), hits).yes != 0;
                    met += kernels.obbs(pairs_with({at, obb}, &obb.rotation.x), hits).yes != 0;
                    met += kernels.miss_balls(pairs_with({at, sphere}, &sphere.center.x)) == 0;
                }
            }
        }
    }
    CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
    CHECK(met > 0);
}

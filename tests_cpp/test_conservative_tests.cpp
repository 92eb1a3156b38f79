#include "scene/conservative_tests.h"

#include <cfenv>
#include <cstring>

#include "eight_cases.h"
#include "meshes.h"
#include "scene/scene_kernels.h"

using namespace gphys;

namespace {

/// Ask `quick` and `exact` about a random stored shape where a random transform puts it.
template <class Quick, class Exact>
bool agree(Cases& cases, Tally& tally, Quick&& quick, Exact&& exact) {
    const gphys_transform world = cases.transform();
    const auto compare = [&](const auto& stored) {
        return with_placed(stored, world, [&](const auto& placed) {
            return tally.add(conservative_verdict(stored, world, quick), exact(placed));
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
        const ConservativeRay quick(ray);
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
        const ConservativePoint quick(point);
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
        REQUIRE(agree(cases, tally, ConservativeBoxQuery(as_obb(aabb)),
                      [&](const auto& shape) { return overlaps(Shape(aabb), Shape(shape)); }));
        const Obb obb = widen(cases.obb());
        REQUIRE(agree(cases, tally, ConservativeBoxQuery(obb),
                      [&](const auto& shape) { return overlaps(Shape(obb), Shape(shape)); }));
    }
    CHECK(fine.no > 10000);
    CHECK(fine.yes > 10000);
    CHECK(fine.open < 10);
    CHECK(coarse.open > 100);
}

TEST_CASE("quick tests of planes never contradict the exact ones, also where they are touched") {
    Cases cases(78);
    Tally rays, points, boxes, touching;
    for (int i = 0; i < 40000; ++i) {
        cases.next();
        gphys_plane stored = cases.plane();
        const gphys_transform world = cases.transform();
        if (i % 16 == 0) stored = {scaled(stored.normal, 0x1p-100f), stored.distance * 0x1p-100f};
        const Plane plane = with_placed(stored, world, [](const Plane& p) { return p; });
        const ConservativePlane quick = conservative_shape(stored, world);
        // To the last bit, or nearly.
        const bool touches = i % 4 == 1 || cases.coarse();
        const double factor = i % 8 < 4 ? 1 : 1 + std::exp2(cases.number(12) - 40) * (i % 3 - 1);
        Ray ray = cases.ray();
        Hit hit;
        if (touches && raycast(plane, {ray.origin, ray.direction}, hit)) ray.t_max = hit.t * factor;
        REQUIRE((touches ? touching : rays)
                    .add(may_hit(quick, ray) ? TriState::undecided : TriState::no, raycast(plane, ray, hit)));
        const Vec3 point = widen(cases.point(8));
        const double reach = touches ? distance(closest_point(plane, point), point) * factor : cases.size();
        REQUIRE((touches ? touching : points)
                    .add(ConservativePoint(point)(quick, reach), overlaps(Shape(Sphere{point, reach}), Shape(plane))));
        const Obb box = widen(cases.obb());
        REQUIRE((cases.coarse() ? touching : boxes)
                    .add(ConservativeBoxQuery(box)(quick), overlaps(Shape(box), Shape(plane))));
    }
    INFO(rays << ", " << points << ", " << boxes << ", " << touching);
    CHECK(rays.no > 7000);
    CHECK(rays.open > 1000);
    for (const Tally* tally : {&points, &boxes}) {
        CHECK(tally->no > 5000);
        CHECK(tally->yes > 1000);
        CHECK(tally->open < 10);
    }
    CHECK(touching.no > 10000);
    CHECK(touching.open > 10000);
}

namespace {

using AskEight = TriStates8 (*SceneKernels::*)(const RaysAndModels<RayQuads>& pairs);

AskEight kernel_for(const EightCases<gphys_sphere>&) { return &SceneKernels::rays_and_spheres; }
AskEight kernel_for(const EightCases<gphys_aabb>&) { return &SceneKernels::rays_and_aabbs; }
AskEight kernel_for(const EightCases<gphys_obb>&) { return &SceneKernels::rays_and_obbs; }

}  // namespace

TEST_CASE("of eight rays at once each is told the truth about its model, or nothing, the same on any instruction set") {
    Tallies spheres, aabbs, obbs;
    compare_many_eights(74, spheres, aabbs, obbs, [](const auto& eight, Tallies& tallies) {
        RayQuads quads[8], same_quads[8];
        scene_kernels(base_isa).ray_quads(eight.rays, 8, quads);
        const auto pairs = eight.pairs(quads);
        const AskEight ask = kernel_for(eight);
        const TriStates8 verdicts = (scene_kernels(base_isa).*ask)(pairs);
        for (const Isa isa : test::isas()) {
            scene_kernels(isa).ray_quads(eight.rays, 8, same_quads);
            REQUIRE(std::memcmp(quads, same_quads, sizeof quads) == 0);
            const TriStates8 same = (scene_kernels(isa).*ask)(pairs);
            REQUIRE((same.no == verdicts.no && same.yes == verdicts.yes));
        }
        REQUIRE((verdicts.no & verdicts.yes) == 0);
        for (int k = 0; k < 8; ++k) {
            Hit hit;
            REQUIRE(eight.tally_of(k, tallies).add(verdict_of(verdicts, k), eight.meets(k, hit)));
        }
    });
    for (const Tallies* tallies : {&spheres, &aabbs, &obbs}) {
        const Tally &fine = tallies->fine, &touching = tallies->touching, &tiny = tallies->tiny;
        INFO(fine << ", " << touching << ", " << tiny);
        CHECK(fine.no > 20000);
        CHECK(fine.yes > 500);
        CHECK(fine.open < 100);
        CHECK(touching.open > 1000);
    }
}

TEST_CASE("spheres and planes in models that are not turned are placed with the bits that a matrix gives") {
    Cases cases(77);
    for (int i = 0; i < 4000; ++i) {
        cases.next();
        gphys_sphere sphere = cases.sphere();
        gphys_transform world = cases.transform();
        world.rotation = {0, -0.0f, 0, i % 2 == 0 ? 1.0f : -0.9995f};
        if (i % 4 == 3) world.position = {-0.0f, 0, world.position.z}, sphere.center = {-0.0f, sphere.center.y, -0.0f};
        const Sphere expected = transformed(widen(sphere), widen(world));
        const Sphere placed = with_placed(sphere, world, [](const Sphere& s) { return s; });
        REQUIRE(std::memcmp(&placed, &expected, sizeof placed) == 0);
        gphys_plane plane = cases.plane();
        if (i % 4 == 1) plane.normal = {-0.0f, plane.normal.y, plane.normal.z + 3};
        const Plane expected_plane = transformed(widen(plane), widen(world));
        const Plane placed_plane = with_placed(plane, world, [](const Plane& p) { return p; });
        REQUIRE(std::memcmp(&placed_plane, &expected_plane, sizeof placed_plane) == 0);
    }
}

TEST_CASE("of rays that are fewer than eight the quick numbers are those of eight") {
    Cases cases(76);
    Ray rays[8];
    for (Ray& ray : rays) ray = cases.ray();
    RayQuads eight[8], fewer[8];
    for (const Isa isa : test::isas()) {
        scene_kernels(isa).ray_quads(rays, 8, eight);
        for (uint32_t count = 1; count < 8; ++count) {
            scene_kernels(isa).ray_quads(rays, count, fewer);
            CHECK(std::memcmp(eight, fewer, count * sizeof(RayQuads)) == 0);
        }
        for (int i = 0; i < 8; ++i) {
            const SplitPoint origin(rays[i].origin);
            for (int k = 0; k < 3; ++k) {
                CHECK(eight[i].head[k] == origin.head[k]);
                CHECK(eight[i].rest[k] == origin.rest[k]);
            }
            CHECK(eight[i].end == ray_end(rays[i].t_max, rays[i].direction));
        }
    }
}

namespace {

/// What was said of boxes about the origins of their models, and of others.
struct Told {
    Tally fine, hard, elsewhere;
};

/// Seven boxes in any order, and one of them twice.
class EightBoxes {
public:
    EightBoxes(Cases& cases, int round)
        : tiny_(round % 8 == 0), touching_(round % 4 == 1), scale_(tiny_ ? 0x1p-147f : 1) {
        for (gphys_aabb& box : boxes_) {
            gphys_transform world = cases.transform();
            world.position = scaled(world.position, scale_);
            if (round % 3 == 0) world.rotation = {0, 0, 0, 1};
            box = scaled(cases.aabb(), scale_);
            stored_.emplace_back(world, box);
        }
        for (int k = 0; k < 8; ++k) first_quad_[k] = 4 * order[k];
    }

    /// Of the query; numbers below the smallest normal float, too.
    float scale() const { return scale_; }
    /// Whether the query is to touch the first box, all but.
    bool touching() const { return touching_; }
    /// Of the first box.
    Vec3 closest(Vec3 to) const {
        Vec3 point;
        with_placed(boxes_[0], stored_[0].world, [&](const auto& placed) { point = closest_point(placed, to); });
        return point;
    }

    /// Asks ask(kernels, quads, first_quad) whether `query` meets them.
    template <class Ask>
    void check(const Shape& query, bool coarse, const Ask& ask, Told& told) const {
        const float* quads = &stored_[0].world.position.x;
        const TriStates8 verdicts = ask(scene_kernels(base_isa), quads, first_quad_);
        for (const Isa isa : test::isas()) {
            const TriStates8 same = ask(scene_kernels(isa), quads, first_quad_);
            REQUIRE((same.no == verdicts.no && same.yes == verdicts.yes));
        }
        REQUIRE((verdicts.no & verdicts.yes) == 0);
        for (int k = 0; k < 8; ++k) {
            const gphys_aabb& box = boxes_[order[k]];
            const bool truth = with_placed(box, stored_[order[k]].world,
                                           [&](const auto& placed) { return overlaps(query, Shape(placed)); });
            const bool centered = widen(box.min) == -widen(box.max);
            Tally& tally = !centered ? told.elsewhere : tiny_ || touching_ || coarse ? told.hard : told.fine;
            REQUIRE(tally.add(verdict_of(verdicts, k), truth));
        }
    }

private:
    static constexpr uint32_t order[8] = {6, 2, 0, 5, 3, 1, 4, 2};

    bool tiny_, touching_;
    float scale_;
    gphys_aabb boxes_[7];
    std::vector<StoredModel> stored_;
    uint32_t first_quad_[8];
};

/// make_query(cases, eight, query) returns how kernels are asked about it.
template <class MakeQuery>
void check_eight_boxes(uint64_t seed, const MakeQuery& make_query) {
    Cases cases(seed);
    Told told;
    for (int i = 0; i < 20000; ++i) {
        cases.next();
        const EightBoxes eight(cases, i);
        Shape query;
        const auto ask = make_query(cases, eight, query);
        eight.check(query, cases.coarse(), ask, told);
    }
    CHECK(told.fine.no > 10000);
    CHECK(told.fine.yes > 2000);
    CHECK(told.fine.open < 10);
    CHECK(told.hard.open > 100);
    CHECK(told.elsewhere.no + told.elsewhere.yes == 0);
}

}  // namespace

TEST_CASE("of eight boxes at once a ball is told the truth, or nothing, and the same on any instruction set") {
    check_eight_boxes(75, [](Cases& cases, const EightBoxes& eight, Shape& query) {
        Vec3 center = widen(scaled(cases.point(8), eight.scale()));
        float radius = cases.size() * eight.scale();
        if (eight.touching()) {
            const Vec3 outside = eight.closest(center);
            center = widen(narrow(outside + (center - outside) * std::exp2(cases.number(10) - 10)));
            radius = static_cast<float>(length(center - eight.closest(center)));
        }
        query = Sphere{center, radius};
        return [ball = SphereQueryLanes(center, radius)](const SceneKernels& kernels, const float* quads,
                                                         const uint32_t* first_quad) {
            return kernels.boxes_and_sphere(quads, first_quad, ball);
        };
    });
}

TEST_CASE("of eight boxes at once a box is told the truth, or nothing, and the same on any instruction set") {
    check_eight_boxes(76, [](Cases& cases, const EightBoxes& eight, Shape& query) {
        Vec3 center = widen(scaled(cases.point(8), eight.scale()));
        Vec3 half = Vec3{cases.size(), cases.size(), cases.size()} * eight.scale();
        if (eight.touching()) {
            // With a corner, an edge or a face.
            const Vec3 outside = eight.closest(center);
            center = outside + (center - outside) * std::exp2(cases.number(10) - 10);
            half = max(abs(center - outside), cases.number(1) > 0 ? half * 0.25 : Vec3{});
        }
        const Aabb box = widen(gphys_aabb{narrow(center - half), narrow(center + half)});
        query = box;
        return
            [block = BoxQueryLanes(box)](const SceneKernels& kernels, const float* quads, const uint32_t* first_quad) {
                return kernels.boxes_and_box(quads, first_quad, block);
            };
    });
}

TEST_CASE("quick tests raise no floating-point exception, however far the ray and the point reach") {
    const gphys_transform world{{1e15f, -1e15f, 1}, {0, 0, 0.6f, 0.8f}, 1e15f};
    const gphys_aabb box{{-1e15f, -1, 0}, {1e15f, 1, 0}};
    std::feclearexcept(FE_ALL_EXCEPT);
    int denied = 0;
    for (const Vec3 direction : {Vec3{1, 0, 0}, Vec3{1e-45, 0, 0}, Vec3{1e15, 1e15, 1e15}, Vec3{}}) {
        const Ray ray{{-1e15, 0, 0}, direction};
        const ConservativeRay quick(ray);
        denied += quick(ConservativePlacedBox<gphys_aabb>{box, world}, ray.t_max) == TriState::no;
        denied += quick(conservative_shape(gphys_sphere{{1e15f, 0, 0}, 1e15f}, world), ray.t_max) == TriState::no;
    }
    denied += ConservativePoint({})(conservative_shape(box, world), infinity) == TriState::no;
    // As large as scenes hold boxes.
    const gphys_transform unscaled{world.position, world.rotation, 1};
    const ConservativePlacedBox<gphys_aabb> placed{box, unscaled};
    CHECK(ConservativePoint({})(placed, infinity) != TriState::no);
    CHECK(ConservativePoint({-1e15, 1e15, 1e15})(placed, 0) == TriState::no);
    const StoredModel stored(unscaled, box);
    const gphys_obb turned{{1e15f, 0, 0}, {1e15f, 1e15f, 1e15f}, {0, 0, 0.6f, 0.8f}};
    const StoredModel stored_turned(unscaled, turned);
    const gphys_sphere sphere{{1e15f, 0, 0}, 1e15f};
    constexpr uint32_t same[8] = {};
    const auto fill = [](auto& eight, const auto* one) { std::fill_n(eight, 8, one); };
    for (const Isa isa : test::isas()) {
        const SceneKernels& kernels = scene_kernels(isa);
        kernels.boxes_and_sphere(&stored.world.position.x, same, SphereQueryLanes({-1e15, 1e15, 1e15}, 1e15));
        kernels.boxes_and_sphere(&stored.world.position.x, same, SphereQueryLanes({}, 0));
        kernels.boxes_and_box(&stored.world.position.x, same,
                              BoxQueryLanes(Aabb{{-1e15, -1e15, -1e15}, {1e15, 1e15, 1e15}}));
        kernels.boxes_and_box(&stored.world.position.x, same, BoxQueryLanes(Aabb{}));
        for (const Vec3 direction : {Vec3{1, 0, 0}, Vec3{1e-45, 0, 0}, Vec3{1e15, 1e15, 1e15}, Vec3{}}) {
            for (const double t_max : {infinity, 0.0, -1.0, 1e38}) {
                const Ray ray{{-1e15, 0, 1e15}, direction, t_max};
                RayQuads quads[8];
                kernels.ray_quads(&ray, 1, quads);
                RaysAndModels<RayQuads> pairs;
                fill(pairs.ray, quads);
                fill(pairs.model, &stored.world.position.x);
                fill(pairs.other, &sphere.center.x);
                kernels.rays_and_aabbs(pairs);
                kernels.rays_and_spheres(pairs);
                fill(pairs.model, &stored_turned.world.position.x);
                fill(pairs.other, &turned.rotation.x);
                kernels.rays_and_obbs(pairs);
            }
        }
    }
    CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
    CHECK(denied == 0);
}

// Eight rays and the stored models that they ask about, for tests of kernels that answer all at once.
#pragma once

#include <vector>

#include "geometry/intersect.h"
#include "scene/placed.h"
#include "stored_cases.h"

namespace gphys {

inline gphys_vec3 scaled(gphys_vec3 v, float scale) { return narrow(widen(v) * scale); }
inline gphys_sphere scaled(const gphys_sphere& s, float scale) { return {scaled(s.center, scale), s.radius * scale}; }
inline gphys_aabb scaled(const gphys_aabb& b, float scale) { return {scaled(b.min, scale), scaled(b.max, scale)}; }
inline gphys_obb scaled(const gphys_obb& b, float scale) {
    return {scaled(b.center, scale), scaled(b.half_extents, scale), b.rotation};
}

inline void shift(gphys_sphere& sphere, Vec3 by) { sphere.center = narrow(widen(sphere.center) + by); }
inline void shift(gphys_aabb& box, Vec3 by) { box = {narrow(widen(box.min) + by), narrow(widen(box.max) + by)}; }
inline void shift(gphys_obb& box, Vec3 by) { box.center = narrow(widen(box.center) + by); }

// RaysAndModels::other
inline const float* other_words(const gphys_sphere& sphere) { return &sphere.center.x; }
inline const float* other_words(const gphys_aabb&) { return nullptr; }
inline const float* other_words(const gphys_obb& box) { return &box.rotation.x; }

/// What was said of questions of each kind.
struct Tallies {
    Tally fine, touching, tiny;
};

/// The same of kernels that give the hit.
struct HitTallies : Tallies {
    int inside = 0;  // of those left open
};

/// That enough questions of each kind were asked, and few of the others left open.
inline void check_tallies(const HitTallies& tallies) {
    const Tally &fine = tallies.fine, &touching = tallies.touching, &tiny = tallies.tiny;
    INFO(fine << ", " << touching << ", " << tiny << ", " << tallies.inside);
    CHECK(fine.no > 20000);
    CHECK(fine.yes > 500);
    CHECK(fine.open < 10);
    CHECK(touching.yes > 1000);
    CHECK(touching.open > 100);
    CHECK(tiny.yes > 100);
    CHECK(tallies.inside > 1000);
}

/// In any order: some models are asked about by several rays, and some by none.
template <class Stored>
class EightCases {
public:
    /// make_shape() is one of random shapes.
    template <class MakeShape>
    EightCases(Cases& cases, int round, const MakeShape& make_shape)
        : coarse_(cases.coarse()), tiny_(round % 8 == 0), touching_(round % 4 == 1), shifted_(round % 8 == 2) {
        // Numbers below the smallest normal float, too.
        const float scale = tiny_ ? 0x1p-147f : 1;
        for (int i = 0; i < 7; ++i) {
            gphys_transform world = cases.transform();
            world.position = scaled(world.position, scale);
            if (round % 3 == 0) world = {world.position, {0, i == 1 ? -0.0f : 0, 0, i == 2 ? -1.0f : 1}, 1};
            if (round % 3 == 1 && i % 2 == 0) world.rotation = {0, 0, 0, 1};
            shapes_.push_back(scaled(make_shape(), scale));
            if (shifted_) {
                // Far from the origin of its model, which is as far away on the other side.
                const Vec3 by = widen(cases.point(10000));
                shift(shapes_.back(), by);
                world.position = narrow(widen(world.position) - widen(world).apply_to_vector(by));
            }
            models_.emplace_back(world, shapes_.back());
        }
        for (Ray& ray : rays) {
            ray = cases.ray();
            ray = {widen(scaled(narrow(ray.origin), scale)), ray.direction, ray.t_max * scale};
        }
        // Some are aimed, as few others meet anything.
        for (const int k : {3, 4, 6, 7}) {
            Ray& ray = rays[ray_of[k]];
            const Vec3 at = widen(models_[model_of[k]].world.position) + widen(cases.point(1)) * scale;
            ray = {ray.origin, at - ray.origin, infinity};
        }
        if (touching_) touch(cases, round);
    }

    template <class RayForm>
    RaysAndModels<RayForm> pairs(const RayForm* forms) const {
        RaysAndModels<RayForm> pairs;
        for (int k = 0; k < 8; ++k) {
            pairs.ray[k] = forms + ray_of[k];
            pairs.model[k] = &models_[model_of[k]].world.position.x;
            pairs.other[k] = other_words(shapes_[model_of[k]]);
        }
        return pairs;
    }
    /// The exact answer to one of them.
    bool meets(int k, Hit& hit) const {
        return with_placed(shapes_[model_of[k]], models_[model_of[k]].world,
                           [&](const auto& placed) { return raycast(placed, rays[ray_of[k]], hit); });
    }
    Tally& tally_of(int k, Tallies& tallies) const {
        const bool touches = touching_ && (ray_of[k] == past || ray_of[k] == up_to);
        return tiny_ ? tallies.tiny : touches || shifted_ || coarse_ ? tallies.touching : tallies.fine;
    }

    Ray rays[8];

private:
    static constexpr uint32_t model_of[8] = {6, 2, 0, 5, 3, 1, 4, 2}, ray_of[8] = {1, 0, 2, 7, 4, 3, 6, 4};
    static constexpr uint32_t past = 2, up_to = 0;  // rays that touch the models 0 and 2

    void touch(Cases& cases, int round) {
        // Mostly an edge, by no more than roundings or a little more.
        with_placed(shapes_[0], models_[0].world, [&](const auto& placed) {
            Ray& ray = rays[past];
            const Vec3 surface = closest_point(placed, ray.origin), out = ray.origin - surface;
            const Vec3 across = cross(out, Vec3{1, 2, 3});
            ray = {surface + out * std::exp2(cases.number(24) - 42) - across, across, infinity};
        });
        // To the last bit, or nearly.
        with_placed(shapes_[2], models_[2].world, [&](const auto& placed) {
            Ray& ray = rays[up_to];
            ray = {ray.origin, closest_point(placed, ray.origin) - ray.origin, infinity};
            Hit hit;
            if (!raycast(placed, ray, hit)) return;
            const double nearly = hit.t * (1 + std::exp2(cases.number(12) - 40) * (round % 8 < 4 ? 1 : -1));
            const double ends[4] = {std::nextafter(hit.t, 0), hit.t, std::nextafter(hit.t, infinity), nearly};
            ray.t_max = ends[round / 4 % 4];
        });
    }

    bool coarse_, tiny_, touching_, shifted_;
    std::vector<Stored> shapes_;
    std::vector<StoredModel> models_;
};

/// compare(eight cases, tallies) in each round, for spheres, Aabbs and Obbs apart.
template <class OfType, class Compare>
void compare_many_eights(uint64_t seed, OfType& spheres, OfType& aabbs, OfType& obbs, const Compare& compare) {
    Cases cases(seed);
    for (int round = 0; round < 12000; ++round) {
        cases.next();
        compare(EightCases<gphys_sphere>(cases, round, [&] { return cases.sphere(); }), spheres);
        compare(EightCases<gphys_aabb>(cases, round, [&] { return cases.aabb(); }), aabbs);
        compare(EightCases<gphys_obb>(cases, round, [&] { return cases.obb(); }), obbs);
    }
}

}  // namespace gphys

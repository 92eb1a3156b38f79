// The nearest model to a point, or to each of many points: an ordered traversal of the BVH; for each candidate a
// conservative test, then the exact one if that is undecided (Roussopoulos, Kelley, Vincent, "Nearest neighbor
// queries", 1995). The traversals of many points are interleaved (bvh/interleaved_traversal.h): a single point waits
// for the memory of most nodes.
#include <algorithm>
#include <cmath>
#include <optional>

#include "foundation/compiler.h"
#include "scene/best_candidate.h"
#include "scene/conservative_tests.h"
#include "scene/scene.h"

namespace gphys {

namespace {

bool closest_point_of(const MeshInstance& instance, Vec3 point, double max_distance, Vec3& out, uint32_t& triangle) {
    return closest_point(instance, point, max_distance, out, triangle);
}
template <class Primitive>
bool closest_point_of(const Primitive& shape, Vec3 point, double, Vec3& out, uint32_t& triangle) {
    triangle = GPHYS_NO_TRIANGLE;
    out = closest_point(shape, point);
    return true;
}

}  // namespace

/// The nearest model to one point, from candidates in any order.
class Scene::NearestOfPoint {
public:
    NearestOfPoint(const Scene& scene, Vec3 point, double max_distance)
        : scene_(scene), point_(point), conservative_point_(point), max_distance_(max_distance) {}

    /// Tests the models outside the BVH. Models farther away than `reach` are not of interest; a nearer one lowers it.
    template <class Filter>
    void test_unbounded(const Filter& filter, double& reach) {
        for (const uint32_t slot : scene_.unbounded_) test(slot, filter, reach);
    }
    template <class Filter>
    void test(uint32_t slot, const Filter& filter, double& reach) {
        Vec3 candidate;
        uint32_t triangle = GPHYS_NO_TRIANGLE;
        const auto conservative = [&](const auto& shape) { return only_no(conservative_point_(shape, reach)); };
        const auto exact = [&](const auto& shape) {
            return closest_point_of(shape, point_, reach, candidate, triangle);
        };
        if (!scene_.may_pass(filter, slot) || !scene_.decide(filter, slot, conservative, exact)) return;
        const double square = length_squared(candidate - point_);
        if (square > reach * reach) return;
        const float distance = reported(std::sqrt(square));
        if (!best_.is_beaten_by(distance, slot, scene_.ids_)) return;
        best_ = {distance, slot};
        reach = std::min(max_distance_, limit_of_ties<double>(distance));
        closest_ = candidate;
        triangle_ = triangle;
    }

    gphys_status answer(gphys_nearest& out) const {
        if (!best_.exists()) return GPHYS_NO_HIT;
        out = to_nearest(closest_, best_.value, triangle_, scene_.ids_.id(best_.slot), scene_.tags_[best_.slot]);
        return GPHYS_OK;
    }

private:
    const Scene& scene_;
    Vec3 point_;
    ConservativePoint conservative_point_;
    double max_distance_;
    BestCandidate best_;
    Vec3 closest_;
    uint32_t triangle_ = GPHYS_NO_TRIANGLE;
};

template <class Filter>
gphys_status Scene::nearest_by(Vec3 point, double max_distance, const Filter& filter, gphys_nearest& out) const {
    NearestOfPoint nearest(*this, point, max_distance);
    double reach = max_distance;
    nearest.test_unbounded(filter, reach);
    const auto visit = [&](uint32_t slot, double& within) {
        nearest.test(slot, filter, reach);
        within = reach;
    };
    bvh_.nearest(point, reach, visit, model_memory());
    return nearest.answer(out);
}

template <class Filters>
void Scene::nearest_many_by(const Vec3* points, uint32_t count, double max_distance, const Filters& filters,
                            gphys_nearest* out) const {
    std::optional<NearestOfPoint> nearest[points_at_once];
    double reaches[points_at_once];
    for (uint32_t i = 0; i < count; ++i) {
        nearest[i].emplace(*this, points[i], max_distance);
        reaches[i] = max_distance;
        nearest[i]->test_unbounded(filter_of_item(filters, i), reaches[i]);
    }
    const auto visit = [&](uint32_t i, uint32_t slot) {
        nearest[i]->test(slot, filter_of_item(filters, i), reaches[i]);
    };
    bvh_.nearest_many(points, count, reaches, visit, model_memory());
    for (uint32_t i = 0; i < count; ++i) nearest[i]->answer(out[i]);
}

gphys_status Scene::nearest(Vec3 point, double max_distance, uint32_t layers, gphys_nearest& out) const {
    return nearest_by(point, max_distance, layers, out);
}
gphys_status Scene::nearest(Vec3 point, double max_distance, const QueryFilter& filter, gphys_nearest& out) const {
    return nearest_by(point, max_distance, filter, out);
}

void Scene::nearest_many(const Vec3* points, uint32_t count, double max_distance, uint32_t layers,
                         gphys_nearest* out) const {
    nearest_many_by(points, count, max_distance, layers, out);
}
void Scene::nearest_many(const Vec3* points, uint32_t count, double max_distance, const BatchFilters& filters,
                         gphys_nearest* out) const {
    nearest_many_by(points, count, max_distance, filters, out);
}

}  // namespace gphys

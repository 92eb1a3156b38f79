// The nearest model to a point, or to each of many points: an ordered traversal of the BVH; for each candidate a
// conservative test, then the exact one if that is undecided (Roussopoulos, Kelley, Vincent, "Nearest neighbor
// queries", 1995). The traversals of many points are interleaved (bvh/interleaved_traversal.h): a single point waits
// for the memory of most nodes.
//
// The BVH knows no layers, so a traversal visits, and rejects, all models of other layers that are nearer than the
// answer. If it rejects more than a scan of the models in the layers takes, it is ended, and the scan goes on.
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
        : scene_(scene), point_(point), conservative_point_(point), max_distance_(max_distance), reach_(max_distance) {}

    /// Models farther away are not of interest.
    double reach() const { return reach_; }

    /// Tests the models outside the BVH.
    template <class Filter>
    void test_unbounded(const Filter& filter) {
        for (const uint32_t slot : scene_.unbounded_) test(slot, filter);
    }
    /// Returns false if the model is rejected by the first step of the filter. A model may be tested again.
    template <class Filter>
    bool test(uint32_t slot, const Filter& filter) {
        if (!scene_.may_pass(filter, slot)) return false;
        // Nothing is nearer than a solid that contains the point; only those of lower ids are as near.
        if (!best_.is_beaten_by(0, slot, scene_.ids_)) return true;
        Vec3 candidate;
        uint32_t triangle = GPHYS_NO_TRIANGLE;
        const auto conservative = [&](const auto& shape) { return only_no(conservative_point_(shape, reach_)); };
        const auto exact = [&](const auto& shape) {
            return closest_point_of(shape, point_, reach_, candidate, triangle);
        };
        if (!scene_.decide(filter, slot, conservative, exact)) return true;
        const double square = length_squared(candidate - point_);
        if (square > reach_ * reach_) return true;
        const float distance = reported(std::sqrt(square));
        if (!best_.is_beaten_by(distance, slot, scene_.ids_)) return true;
        best_ = {distance, slot};
        reach_ = std::min(max_distance_, limit_of_ties<double>(distance));
        closest_ = candidate;
        triangle_ = triangle;
        return true;
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
    double max_distance_, reach_;
    BestCandidate best_;
    Vec3 closest_;
    uint32_t triangle_ = GPHYS_NO_TRIANGLE;
};

template <class Visit>
void Scene::for_each_in_layers(uint32_t layers, Visit&& visit) const {
    layer_blocks_.for_each(layers, [&](uint32_t block) {
        const uint32_t first = block * LayerBlocks::block_slots;
        const uint32_t end = std::min(first + LayerBlocks::block_slots, ids_.slots());
        for (uint32_t slot = first; slot < end; ++slot) {
            if ((models_[slot].layers & layers) != 0 && ids_.live(slot)) visit(slot);
        }
        return true;
    });
}

/// Counts the candidates that a filter rejects in the traversals of some points, to end those that a scan would have
/// taken less time for. So a query takes at most about twice the time of the better of the two.
///
/// Prices are in rejected candidates. The points share the price of reading the layers of all models in the scanned
/// blocks; each pays for the tests of the models in the layers.
class Scene::RejectedCandidates {
public:
    RejectedCandidates(const Scene& scene, uint32_t layers)
        : blocks_(scene.layer_blocks_), layers_(layers), shared_price_(price_of_search()) {}

    /// Call for each. `of_point` counts those of the same point. Whether to end its traversal.
    bool exceed_scan(uint32_t& of_point) {
        ++of_point;
        ++of_all_;
        return exceed_price(of_point) && (is_exact_ || find_price(of_point));
    }

private:
    // Measured. The layers of a block are in 64 adjacent cache lines.
    static constexpr uint32_t price_of_block = 4, words_at_the_price_of_one = 64, least_price = 16;

    uint32_t price_of_search() const { return least_price + blocks_.size() / words_at_the_price_of_one; }
    bool exceed_price(uint32_t of_point) const { return of_all_ >= shared_price_ && of_point >= price_of_tests_; }
    /// Ends early at twice what was counted, so that all searches together take a fraction of the time of the
    /// traversals.
    bool find_price(uint32_t of_point) {
        shared_price_ = price_of_search();
        price_of_tests_ = 0;
        is_exact_ = blocks_.for_each(layers_, [&](uint32_t block) {
            shared_price_ += price_of_block;
            price_of_tests_ += blocks_.counts(block).estimate(layers_);
            return shared_price_ <= 2 * of_all_ && price_of_tests_ <= 2 * of_point;
        });
        return is_exact_ && exceed_price(of_point);
    }

    const LayerBlocks& blocks_;
    uint32_t layers_;
    uint32_t of_all_ = 0, shared_price_, price_of_tests_ = 0;
    bool is_exact_ = false;  // otherwise the prices are lower bounds
};

template <class Filter>
gphys_status Scene::nearest_by(Vec3 point, double max_distance, const Filter& filter, gphys_nearest& out) const {
    NearestOfPoint nearest(*this, point, max_distance);
    nearest.test_unbounded(filter);
    RejectedCandidates rejected(*this, layers_of(filter));
    uint32_t rejected_count = 0;
    bool is_ended = false;
    const auto visit = [&](uint32_t slot, double& within) {
        is_ended = !nearest.test(slot, filter) && rejected.exceed_scan(rejected_count);
        within = is_ended ? -1 : nearest.reach();
    };
    bvh_.nearest(point, nearest.reach(), visit, model_memory());
    if (is_ended) for_each_in_layers(layers_of(filter), [&](uint32_t slot) { nearest.test(slot, filter); });
    return nearest.answer(out);
}

template <class Filters>
void Scene::nearest_many_by(const Vec3* points, uint32_t count, double max_distance, const Filters& filters,
                            gphys_nearest* out) const {
    // Measured: what a group of points sets up costs as much as it saves at 4 points.
    constexpr uint32_t fewest_points = 4;
    if (count < fewest_points) {
        for (uint32_t i = 0; i < count; ++i) nearest_by(points[i], max_distance, filter_of_item(filters, i), out[i]);
        return;
    }
    nearest_together_by(points, count, max_distance, filters, out);
}

/// Not inlined, so that its arrays are not on the stack of those that ask for few points.
template <class Filters>
GPHYS_NOINLINE void Scene::nearest_together_by(const Vec3* points, uint32_t count, double max_distance,
                                               const Filters& filters, gphys_nearest* out) const {
    std::optional<NearestOfPoint> nearest[points_at_once];
    std::optional<RejectedCandidates> rejected[points_at_once];  // by filter_number
    uint32_t rejected_counts[points_at_once];
    double reaches[points_at_once];
    for (uint32_t i = 0; i < count; ++i) {
        const auto& filter = filter_of_item(filters, i);
        nearest[i].emplace(*this, points[i], max_distance);
        nearest[i]->test_unbounded(filter);
        reaches[i] = nearest[i]->reach();
        rejected_counts[i] = 0;
        auto& of_filter = rejected[filter_number(filters, i)];
        if (!of_filter) of_filter.emplace(*this, layers_of(filter));
    }
    uint64_t ended = 0;
    static_assert(points_at_once <= 64);
    const auto visit = [&](uint32_t i, uint32_t slot) {
        const bool passed = nearest[i]->test(slot, filter_of_item(filters, i));
        reaches[i] = nearest[i]->reach();
        if (passed || !rejected[filter_number(filters, i)]->exceed_scan(rejected_counts[i])) return;
        reaches[i] = -1;
        ended |= uint64_t{1} << i;
    };
    bvh_.nearest_many(points, count, reaches, visit, model_memory());
    // One scan for all points with the same filter.
    while (ended != 0) {
        const auto first = static_cast<uint32_t>(lowest_bit(ended));
        const auto& filter = filter_of_item(filters, first);
        uint64_t same = 0;
        for (uint64_t rest = ended; rest != 0; rest &= rest - 1) {
            const auto i = static_cast<uint32_t>(lowest_bit(rest));
            if (filter_number(filters, i) == filter_number(filters, first)) same |= rest & ~(rest - 1);
        }
        for_each_in_layers(layers_of(filter), [&](uint32_t slot) {
            for (uint64_t rest = same; rest != 0; rest &= rest - 1) nearest[lowest_bit(rest)]->test(slot, filter);
        });
        ended &= ~same;
    }
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

// The point of a mesh that is closest to a given one: an ordered traversal of the BVH (bvh/ordered_traversal.h). Of the
// triangles in a packet, float arithmetic gives lower bounds of the distances (near_kernels.h). The exact test takes as
// long as the bounds of several packets, so it starts with the nearest triangle, and mostly no other is left.
//
// The searches of many points are interleaved (bvh/interleaved_traversal.h).
#pragma once

#include <optional>

#include "foundation/compiler.h"
#include "foundation/reported.h"
#include "mesh/mesh.h"

namespace gphys {

/// The search of one point. Its functions lower `bound`, the largest distance that is of interest.
template <class DistanceOf, class LimitOf>
class Mesh::ClosestSearch {
public:
    /// The functions and the scale must outlive this.
    ClosestSearch(const Mesh& mesh, Vec3 point, double max_distance, const DistanceOf& distance_of,
                  const LimitOf& limit_of, const AxisScale& axes)
        : mesh_(mesh),
          point_(point),
          distance_of_(distance_of),
          limit_of_(limit_of),
          axes_(axes),
          probe_(point, max_distance) {}

    /// All of some lanes.
    void test(const TrianglePacket& packet, uint32_t lanes, double& bound) {
        for (; lanes != 0; lanes &= lanes - 1) test_lane(packet, lowest_bit(lanes), bound);
    }
    /// The triangles of a packet, without a scale.
    void test(const TrianglePacket& packet, double& bound) {
        float distances[8];
        for (uint32_t lanes = mesh_.near_kernels_.lanes_within(packet, probe_, distances); lanes != 0;) {
            const int lane = nearest_lane(distances, lanes);
            if (!(distances[lane] <= probe_.radius)) return;
            const double before = bound;
            test_lane(packet, lane, bound);
            if (bound != before) probe_.shrink(bound);
            lanes &= ~(1u << lane);
        }
    }

    bool answer(Vec3& out, uint32_t& triangle) const {
        triangle = triangle_;
        if (triangle_ == GPHYS_NO_TRIANGLE) return false;
        out = closest_;
        return true;
    }

private:
    using Distance = std::invoke_result_t<const DistanceOf&, Vec3, double>;

    void test_lane(const TrianglePacket& packet, int lane, double& bound) {
        const Vec3 candidate =
            mesh_.with_item(packet, lane, axes_, [&](const auto& item) { return gphys::closest_point(item, point_); });
        const double squared = length_squared(candidate - point_);
        if (squared > bound * bound) return;
        const Distance distance = distance_of_(candidate, squared);
        const uint32_t triangle = packet.index[lane];
        if (!(distance < least_ || (distance == least_ && triangle < triangle_))) return;
        least_ = distance;
        triangle_ = triangle;
        closest_ = candidate;
        bound = std::min(bound, limit_of_(least_));
    }

    const Mesh& mesh_;
    Vec3 point_;
    const DistanceOf& distance_of_;
    const LimitOf& limit_of_;
    const AxisScale& axes_;
    NearProbe probe_;
    Distance least_ = std::numeric_limits<Distance>::infinity();
    uint32_t triangle_ = GPHYS_NO_TRIANGLE;
    Vec3 closest_;
};

template <class DistanceOf, class LimitOf>
bool Mesh::find_closest(Vec3 point, double max_distance, const DistanceOf& distance_of, const LimitOf& limit_of,
                        Vec3& out, uint32_t& triangle, const AxisScale& axes) const {
    if (packets_.empty()) return false;
    ClosestSearch<DistanceOf, LimitOf> search(*this, point, max_distance, distance_of, limit_of, axes);
    const auto with_packet = [&](const auto& visit) {
        return [&](uint32_t number, double& bound) { visit(packets_[number], bound); };
    };
    if (!axes.is_one()) {
        const WeightedPointProbe probe(axes.inverse(point), axes.by, bounds());
        const auto visit = [&](const TrianglePacket& packet, double& bound) {
            search.test(packet, kernels_.lanes_near_weighted(packet, probe, probe.limit(bound)), bound);
        };
        bvh_.nearest(probe, max_distance, with_packet(visit));
    } else if (is_links()) {
        const auto visit = [&](const TrianglePacket& packet, double& bound) {
            search.test(packet, links_of(packet), bound);
        };
        bvh_.nearest(point, max_distance, with_packet(visit));
    } else {
        const auto visit = [&](const TrianglePacket& packet, double& bound) { search.test(packet, bound); };
        bvh_.nearest(point, max_distance, with_packet(visit));
    }
    return search.answer(out, triangle);
}

template <class DistanceOf, class LimitOf>
bool Mesh::closest_point(Vec3 point, double max_distance, const DistanceOf& distance_of, const LimitOf& limit_of,
                         Vec3& out, uint32_t& triangle, const AxisScale& axes) const {
    if (contains(point, axes)) {
        out = point;
        triangle = GPHYS_NO_TRIANGLE;
        return true;
    }
    if (!magnified_) return find_closest(point, max_distance, distance_of, limit_of, out, triangle, axes);
    const double by = magnification_;
    const bool found = magnified_->find_closest(
        point * by, max_distance * by,
        [&](Vec3 candidate, double squared) { return distance_of(candidate / by, squared / (by * by)); },
        [&](auto distance) { return limit_of(distance) * by; }, out, triangle, axes);
    if (found) out = out / by;
    return found;
}

// Points are compared by the distance that is reported.
inline constexpr auto reported_distance = [](Vec3, double squared) { return reported(std::sqrt(squared)); };
inline constexpr auto limit_of_reported = [](double distance) { return limit_of_ties(distance); };

template <class Found>
void Mesh::closest_point_many(const Vec3* points, uint32_t count, Found&& found) const {
    Vec3 closest;
    uint32_t triangle = GPHYS_NO_TRIANGLE;
    if (kind_ != MeshKind::surface || magnified_ || packets_.empty()) {
        for (uint32_t i = 0; i < count; ++i) {
            if (closest_point(points[i], infinity, closest, triangle)) found(i, closest, triangle);
        }
        return;
    }
    const AxisScale no_scale;
    std::optional<ClosestSearch<decltype(reported_distance), decltype(limit_of_reported)>> searches[points_at_once];
    double reaches[points_at_once];
    for (uint32_t i = 0; i < count; ++i) {
        searches[i].emplace(*this, points[i], infinity, reported_distance, limit_of_reported, no_scale);
        reaches[i] = infinity;
    }
    bvh_.nearest_many(points, count, reaches,
                      [&](uint32_t i, uint32_t number) { searches[i]->test(packets_[number], reaches[i]); },
                      {packets_.data(), sizeof packets_[0]});
    for (uint32_t i = 0; i < count; ++i) {
        if (searches[i]->answer(closest, triangle)) found(i, closest, triangle);
    }
}

}  // namespace gphys

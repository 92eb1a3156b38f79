// The probes of box8.h: rounding to float, with the derivations of all margins.
#include "bvh/box8.h"

#include "bvh/ray_setup.h"
#include "foundation/elementary.h"

namespace gphys {
namespace {

constexpr double unit_roundoff = 0x1p-24;  // of float

double largest_coordinate(const Box& box) {
    float largest = 0;
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::max(std::fabs(box.min[k]), std::fabs(box.max[k])));
    return largest;
}

}  // namespace

// Slab test after Ize, "Robust BVH Ray Traversal" (2013), with the query in double.
//
// Let m be the largest component of the direction. The ray is origin + s d, with d = direction / m
// and s = m t, so that |d| <= 1 and |d| = 1 on one axis, the main one. The origin is moved forward
// to where the main axis enters the root box, which keeps all numbers as small as the tree.
//
// Let u = 2^-24, b the face of a box and E the largest coordinate of the root. For d > 0 the entry into
// a box is (b - o) / d. The test computes (b - o') i: i is a float within a factor of 1 + u of 1 / d, and o' is the
// origin moved by the margin. With the inverse there are three roundings of at most (|b| + |o'|) / d. So the error is
// less than 3.1 u (E + |o'|) / d, plus three times the smallest normal float, below which hosts may flush to zero. Let
// o' be ahead of the origin by this error, by u |o'| for its own rounding, and by the slack: then the computed entry is
// no later than the true one. With o' as far behind, the computed exit is no earlier. A ray that hits the box has
// entry <= exit in truth, and so in the computed numbers. For d < 0, ahead is downward; the rest is the same.
//
// An axis with |d| < 2^-68 has an inverse too large for float, since it is multiplied by sums of up to 2^57. It is
// treated as d = 2^-68 with the same sign; the inverse is the float 2^68. On this axis the ray moves by less than
// 2^-68 span within the root, which is `span` long on the main axis. That is far less than the slack of the origin,
// 2^-48 w, since span < 8 w. So for a ray that hits the box, the box is in front of the near origin (entry < 0) and at
// least slack / 2 behind the far one: the exit is beyond 2^-49 w * 2^68 > span, and this axis accepts the box.
// Components of exactly zero need no case of their own.
RayProbe::RayProbe(Vec3 origin, Vec3 direction, double radius, const Box& root)
    : RayProbe(origin, direction, RootBounds(root, radius)) {}

RayProbe::RayProbe(Vec3 origin, Vec3 direction, const RootBounds& root) {
    store_probe(RaySetup<Vec3>(origin, direction, root), *this);
}

// A ball with the radius of the box's longest axis. On the other axes, where the box is smaller, the origins are moved
// back by the difference, less 2^-20 of it and less 2^-22 of the origins, which are rounded once more.
RayProbe::RayProbe(Vec3 middle, Vec3 displacement, Vec3 half, const Box& root)
    : RayProbe(middle, displacement, max_component(half), root) {
    if (!may_reject()) return;
    for (int k = 0; k < 3; ++k) {
        const double rounded = 0x1p-22 * std::max(std::fabs(near_origin[k]), std::fabs(far_origin[k]));
        const double difference = std::max((max_component(half) - half[k]) * (1 - 0x1p-20) - rounded, 0.0);
        const double backward = near_face[k] < far_face[k] ? -difference : difference;
        near_origin[k] = static_cast<float>(near_origin[k] + backward);
        far_origin[k] = static_cast<float>(far_origin[k] - backward);
    }
}

float RayProbe::limit(double t_max) const {
    return static_cast<float>(ray_limit(t_max, path.slack, path.scale, path.start, path.span));
}

RootBounds::RootBounds(const Box& box, double r)
    : low{box.min[0], box.min[1], box.min[2], box.min[0]},
      high{box.max[0], box.max[1], box.max[2], box.max[0]},
      extent(largest_coordinate(box)),
      radius(r) {}

RayPackets::RayPackets(const Box& root, uint32_t items) {
    const Vec3 low{root.min[0], root.min[1], root.min[2]}, high{root.max[0], root.max[1], root.max[2]};
    centre_ = (low + high) * 0.5;
    radius_ = distance(high, centre_);
    leaf_size_ = 2 * radius_ / cbrt(1.0 + items);
}

RayPackets::CoherenceBounds RayPackets::coherence_bounds_of(const Ray& ray) const {
    const double reach = distance(ray.origin, centre_) + radius_, distance_squared = leaf_size_ * leaf_size_;
    // reach is 0 if the tree is a point at the origin of the ray.
    const double slope = reach > 0 ? distance_squared / (reach * reach) : 0;
    return {ray, distance_squared, slope * length_squared(ray.direction)};
}

// The gap on each axis lies between the box and the two floats around the point: one rounding. Its square takes another
// three, the sum two more. So the computed squared distance exceeds the true lower bound by a factor of at most 1 + 6u.
PointProbe::PointProbe(Vec3 point, const Box& root) {
    slack_ = rounding_slack(std::max(largest_coordinate(root), max_component(abs(point))));
    for (int k = 0; k < 3; ++k) {
        // Clamping moves the point nearer to the tree: still a lower bound, and its square fits a float.
        const double clamped = std::clamp(point[k], -0x1p61, 0x1p61);
        low[k] = round_down(clamped);
        high[k] = round_up(clamped);
    }
}

// The weight adds a rounding to each gap: a factor of 1 + 8u in all. It also multiplies the error of the point.
WeightedPointProbe::WeightedPointProbe(Vec3 point, Vec3 weights, const Box& root) : PointProbe(point, root) {
    slack_ = 0;
    for (int k = 0; k < 3; ++k) {
        const double weight_k = weights[k];
        const double furthest =
            std::max(std::fabs(point[k]), double{std::max(std::fabs(root.min[k]), std::fabs(root.max[k]))});
        slack_ = std::max(slack_, rounding_slack(weight_k * furthest));
        // Clamped in the weighted space.
        const double clamped = std::clamp(point[k], -0x1p61 / weight_k, 0x1p61 / weight_k);
        low[k] = round_down(clamped - 0x1p-52 * std::fabs(clamped));
        high[k] = round_up(clamped + 0x1p-52 * std::fabs(clamped));
        weight[k] = static_cast<float>(weight_k);
    }
}

float PointProbe::limit(double max_distance) const {
    if (max_distance < 0) return -1;
    const double reach = std::min(max_distance + slack_, 0x1p62) * (1 + 16 * unit_roundoff);
    return round_up(reach * reach);
}

// The distance of the farthest corner is computed from the two floats around the centre as well, with as many
// roundings: its square is at least 1 - 6u of the true one. Hosts may flush each of the three squares to zero if it is
// below the smallest normal float.
BallProbe::BallProbe(Vec3 center, double radius, const Box& root) {
    const PointProbe point(center, root);
    std::copy_n(point.low, 3, low);
    std::copy_n(point.high, 3, high);
    outside_above = point.limit(radius);
    const double reach = std::min(radius, 0x1p62);
    inside_below = round_down(reach * reach * (1 - 16 * unit_roundoff) - 4.0 * std::numeric_limits<float>::min());
}

// Coordinates are differences to the frustum's origin. Each term of the sum of three products has five roundings,
// including that of the plane's component. So the error is within 5u of the sum of magnitudes; 8u covers the rounding
// of that sum and of the comparison's right side, too. The magnitude on an axis is the larger of the two faces'.
FrustumProbe::FrustumProbe(const Frustum& frustum, const Box& box) : around(box) {
    const bool too_far = max_component(abs(frustum.origin)) > 0x1p57;
    for (int k = 0; k < 3; ++k) {
        const double origin = too_far ? 0 : frustum.origin[k];
        origin_low[k] = round_down(origin);
        origin_high[k] = round_up(origin);
    }
    for (int p = 0; p < 6; ++p) {
        FloatPlane& plane = planes[p];
        const Plane& exact = frustum.planes[p];
        const double scale = max_component(abs(exact.normal));
        if (too_far) {
            plane = {{}, {}, -1, 1};  // neither outside nor inside
        } else if (scale == 0) {
            const float side = exact.distance <= 0 ? -1.0f : 1.0f;  // all of space or nothing
            plane = {{}, {}, side, side};
        } else {
            // A component below 2^-100 has no float of full precision. Without it, the sum changes by no more than
            // 2^-100 times the largest difference, 2^58.
            double slack = 0;
            for (int k = 0; k < 3; ++k) {
                const double component = exact.normal[k] / scale;
                const bool negligible = std::fabs(component) < 0x1p-100;
                if (negligible && component != 0) slack += 0x1p-42;
                plane.normal[k] = negligible ? 0.0f : static_cast<float>(component);
                plane.error[k] = std::fabs(plane.normal[k]) * static_cast<float>(8 * unit_roundoff);
            }
            // Sums stay below 2^60: beyond that the size of the distance does not matter.
            const double distance = std::clamp(exact.distance / scale, -0x1p100, 0x1p100);
            slack += std::fabs(distance) * 0x1p-50;
            plane.outside_below = round_down(distance - slack);
            plane.inside_above = round_up(distance + slack);
        }
    }
}

}  // namespace gphys

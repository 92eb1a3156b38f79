// Tests of a probe (box8.h) against eight boxes, for kernels: one lane for each box, no branches. Ray: slab test (Kay
// and Kajiya 1986, in the conservative form of Ize 2013). Point and ball: distance to an AABB (Arvo 1990). Frustum: the
// corners nearest and farthest along a plane's normal (Haines and Wallace 1991). box8.cpp derives the margins.
#pragma once

#include "bvh/box8.h"
#include "foundation/compiler.h"
#include "foundation/simd.h"

namespace gphys::GPHYS_ISA {

/// The part of one ray inside eight boxes, or of eight rays inside one box: from the last entry into a slab to the
/// first exit or the ray's end. enters(axis) and leaves(axis) give the entries and exits of the slabs.
///     entry = max(enters(0), enters(1), enters(2), 0);  exit = min(leaves(0), leaves(1), leaves(2), end)
///     hit = entry <= exit
struct SlabInterval {
    Float8 entry, exit;

    template <class Enters, class Leaves>
    GPHYS_INLINE SlabInterval(const Enters& enters, const Leaves& leaves, Float8 end)
        : entry(max(max(enters(0), enters(1)), max(enters(2), splat(0)))),
          exit(min(min(leaves(0), leaves(1)), min(leaves(2), end))) {}

    uint32_t hits() const { return bits(entry <= exit); }
};

/// One of several rays. The probe stays in memory.
class RayTest {
public:
    RayTest() = default;
    /// The probe must live as long.
    explicit RayTest(const RayProbe& probe) : probe_(&probe) {}

    /// Lanes that the ray hits no later than at `limit`. `entry` and `exit` are in the unit of `limit`.
    ///     entry[k] = (origin - face[k]) * (-1 / direction): the boxes are the subtrahend, so their load is part of the
    ///     subtraction
    uint32_t hits(const Box8& boxes, float limit, Float8& entry, Float8& exit) const {
        const RayProbe& ray = *probe_;
        const Float8 minus_inverse[3] = {splat(ray.minus_inverse[0]), splat(ray.minus_inverse[1]),
                                         splat(ray.minus_inverse[2])};
        const auto enters = [&](int k) {
            return (splat(ray.near_origin[k]) - load_aligned(boxes.row_from(ray.near_face[k]))) * minus_inverse[k];
        };
        const auto leaves = [&](int k) {
            return (splat(ray.far_origin[k]) - load_aligned(boxes.row_from(ray.far_face[k]))) * minus_inverse[k];
        };
        const SlabInterval within(enters, leaves, splat(limit));
        entry = within.entry;
        exit = within.exit;
        return within.hits();
    }
    uint32_t hits(const Box8& boxes, float limit, Float8& entry) const {
        Float8 exit;
        return hits(boxes, limit, entry, exit);
    }

private:
    const RayProbe* probe_;
};

/// The same for a single ray, with its numbers in registers.
class SingleRayTest {
public:
    explicit SingleRayTest(const RayProbe& probe) {
        for (int k = 0; k < 3; ++k) {
            near_origin_[k] = splat(probe.near_origin[k]);
            far_origin_[k] = splat(probe.far_origin[k]);
            minus_inverse_[k] = splat(probe.minus_inverse[k]);
            near_face_[k] = probe.near_face[k];
            far_face_[k] = probe.far_face[k];
        }
    }

    uint32_t hits(const Box8& boxes, float limit, Float8& entry) const {
        const auto enters = [&](int k) {
            return (near_origin_[k] - load_aligned(boxes.row_from(near_face_[k]))) * minus_inverse_[k];
        };
        const auto leaves = [&](int k) {
            return (far_origin_[k] - load_aligned(boxes.row_from(far_face_[k]))) * minus_inverse_[k];
        };
        const SlabInterval within(enters, leaves, splat(limit));
        entry = within.entry;
        return within.hits();
    }

private:
    Float8 near_origin_[3], far_origin_[3], minus_inverse_[3];
    uint32_t near_face_[3], far_face_[3];
};

///     distance_squared = sum over axes of max(min[k] - point[k], point[k] - max[k], 0)^2
class PointTest {
public:
    PointTest() = default;
    explicit PointTest(const PointProbe& probe) {
        for (int k = 0; k < 3; ++k) {
            low_[k] = splat(probe.low[k]);
            high_[k] = splat(probe.high[k]);
        }
    }

    /// Lanes whose squared distance is at most `limit`.
    uint32_t hits(const Box8& boxes, float limit, Float8& distance_squared) const {
        return within(gap(boxes, 0), gap(boxes, 1), gap(boxes, 2), limit, distance_squared);
    }

protected:
    Float8 gap(const Box8& boxes, int k) const {
        return max(max(load_aligned(boxes.row[k]) - high_[k], low_[k] - load_aligned(boxes.row[3 + k])), splat(0));
    }
    static uint32_t within(Float8 x, Float8 y, Float8 z, float limit, Float8& distance_squared) {
        distance_squared = x * x + y * y + z * z;
        return bits(distance_squared <= splat(limit));
    }

private:
    Float8 low_[3], high_[3];
};

/// The same with a weight on each axis.
class WeightedPointTest : PointTest {
public:
    explicit WeightedPointTest(const WeightedPointProbe& probe)
        : PointTest(probe), weight_{splat(probe.weight[0]), splat(probe.weight[1]), splat(probe.weight[2])} {}

    uint32_t hits(const Box8& boxes, float limit, Float8& distance_squared) const {
        return within(gap(boxes, 0) * weight_[0], gap(boxes, 1) * weight_[1], gap(boxes, 2) * weight_[2], limit,
                      distance_squared);
    }

private:
    Float8 weight_[3];
};

/// Overlap of two boxes; exact. Touching counts.
class BoxTest {
public:
    explicit BoxTest(const Box& box)
        : min_{splat(box.min[0]), splat(box.min[1]), splat(box.min[2])},
          max_{splat(box.max[0]), splat(box.max[1]), splat(box.max[2])} {}
    BoxTest(const Box8& boxes, uint32_t lane) : BoxTest(boxes.lane(static_cast<int>(lane))) {}

    uint32_t hits(const Box8& boxes) const {
        return bits(boxes_overlap(corner(boxes.row), corner(boxes.row + 3), min_, max_));
    }
    /// `inside`: lanes wholly inside the box.
    uint32_t hits(const Box8& boxes, uint32_t& inside) const {
        const Vec<Float8> low = corner(boxes.row), high = corner(boxes.row + 3);
        inside = bits((min_.x <= low.x) & (high.x <= max_.x) & (min_.y <= low.y) & (high.y <= max_.y) &
                      (min_.z <= low.z) & (high.z <= max_.z));
        return hits(boxes);
    }

private:
    static Vec<Float8> corner(const float (*rows)[8]) {
        return {load_aligned(rows[0]), load_aligned(rows[1]), load_aligned(rows[2])};
    }

    Vec<Float8> min_, max_;
};

///     nearest = sum of gap^2 <= radius^2: overlaps;  farthest = sum of reach^2 <= radius^2: inside
class BallTest {
public:
    explicit BallTest(const BallProbe& probe)
        : outside_above_(splat(probe.outside_above)), inside_below_(splat(probe.inside_below)) {
        for (int k = 0; k < 3; ++k) {
            low_[k] = splat(probe.low[k]);
            high_[k] = splat(probe.high[k]);
        }
    }

    /// Lanes not wholly outside the ball. `inside`: lanes wholly inside.
    uint32_t hits(const Box8& boxes, uint32_t& inside) const {
        Float8 nearest = splat(0), farthest = splat(0);  // squared distances
        for (int k = 0; k < 3; ++k) {
            // a and b: distances from the centre to the two faces, positive outside. The larger is the gap, if
            // positive. The smaller, without its sign, is the distance to the farther face.
            const Float8 a = load_aligned(boxes.row[k]) - high_[k], b = low_[k] - load_aligned(boxes.row[3 + k]);
            const Float8 gap = max(max(a, b), splat(0)), reach = min(a, b);
            nearest = nearest + gap * gap;
            farthest = farthest + reach * reach;
        }
        inside = bits(farthest <= inside_below_);
        return bits(nearest <= outside_above_);
    }

private:
    Float8 low_[3], high_[3], outside_above_, inside_below_;
};

/// For each plane: outside if the corner farthest along the normal is outside, wholly inside if the nearest is inside.
///     upper = normal . farthest corner;  lower = normal . nearest corner
///     outside = upper < distance;  inside = lower >= distance
class FrustumTest {
public:
    static constexpr uint32_t all_planes = 0x3f;

    explicit FrustumTest(const FrustumProbe& probe) : probe_(probe) {
        for (int p = 0; p < 6; ++p) {
            for (uint32_t k = 0; k < 3; ++k) {
                const bool positive = probe.planes[p].normal[k] >= 0;
                inner_face_[p][k] = positive ? 3 + k : k;
                outer_face_[p][k] = positive ? k : 3 + k;
            }
        }
    }

    /// Lanes that are wholly outside none of `planes`. crossed: for each lane the planes that it is not wholly inside
    /// of, a bit set as an integer.
    uint32_t hits(const Box8& boxes, uint32_t planes, Float8& crossed) const {
        return test<true>(boxes, planes, crossed);
    }
    uint32_t hits(const Box8& boxes, uint32_t planes) const {
        Float8 crossed;
        return test<false>(boxes, planes, crossed);
    }

private:
    template <bool also_crossed>
    uint32_t test(const Box8& boxes, uint32_t planes, Float8& crossed) const {
        Float8 face[6], magnitude[3];  // relative to the frustum's origin
        for (int k = 0; k < 3; ++k) {
            face[k] = load_aligned(boxes.row[k]) - splat(probe_.origin_high[k]);
            face[3 + k] = load_aligned(boxes.row[3 + k]) - splat(probe_.origin_low[k]);
            magnitude[k] = max(face[3 + k], splat(0) - face[k]);  // the larger of both faces'
        }
        crossed = splat(0);
        uint32_t hit = 0xff;
        for (uint32_t rest = planes; rest != 0; rest &= rest - 1) {
            const int p = lowest_bit(rest);
            const FrustumProbe::FloatPlane& plane = probe_.planes[p];
            Float8 upper = splat(0), lower = splat(0), error = splat(0);
            for (int k = 0; k < 3; ++k) {
                const Float8 normal = splat(plane.normal[k]);
                upper = upper + face[inner_face_[p][k]] * normal;
                if (also_crossed) lower = lower + face[outer_face_[p][k]] * normal;
                error = error + magnitude[k] * splat(plane.error[k]);
            }
            hit &= bits(splat(plane.outside_below) <= upper + error);
            if (!also_crossed) continue;
            const Mask8 inside = splat(plane.inside_above) <= lower - error;
            crossed = crossed + choose(inside, splat(0), splat(static_cast<float>(1 << p)));
        }
        return hit;
    }

    const FrustumProbe& probe_;
    uint32_t inner_face_[6][3], outer_face_[6][3];
};

}  // namespace gphys::GPHYS_ISA

// Eight boxes side by side, and the probes that test all of them at once in float arithmetic.
// A probe may find a box that the exact query misses, never the reverse: each rounds away from the
// query. The derivations are in box8.cpp.
#pragma once

#include "shapes/shapes.h"
#include "foundation/simd.h"

namespace gphys {

/// Largest coordinate that a box may have: leaves room for a model of the largest size at the
/// largest position, while areas stay far below the largest float.
constexpr float max_box_coordinate = 0x1p52f;

struct alignas(32) Box8 {
    float row[6][8];  // min x, y, z, max x, y, z

    Box lane(int i) const { return {{row[0][i], row[1][i], row[2][i]}, {row[3][i], row[4][i], row[5][i]}}; }
    void set_lane(int i, const Box& box) {
        for (int k = 0; k < 3; ++k) {
            row[k][i] = box.min[k];
            row[3 + k][i] = box.max[k];
        }
    }
};

inline bool operator==(const Box& a, const Box& b) {
    return std::equal(a.min, a.min + 3, b.min) && std::equal(a.max, a.max + 3, b.max);
}
inline bool overlaps(const Box& a, const Box& b) {
    return a.min[0] <= b.max[0] && b.min[0] <= a.max[0] && a.min[1] <= b.max[1] && b.min[1] <= a.max[1] &&
           a.min[2] <= b.max[2] && b.min[2] <= a.max[2];
}

/// Boxes that share a point with a given one: exact.
class BoxProbe {
public:
    explicit BoxProbe(const Box& box) : box_(box) {}

    uint32_t hits(const Box8& boxes) const {
        return bits((load(boxes.row[0]) <= splat(box_.max[0])) & (splat(box_.min[0]) <= load(boxes.row[3])) &
                    (load(boxes.row[1]) <= splat(box_.max[1])) & (splat(box_.min[1]) <= load(boxes.row[4])) &
                    (load(boxes.row[2]) <= splat(box_.max[2])) & (splat(box_.min[2]) <= load(boxes.row[5])));
    }

private:
    Box box_;
};

/// Boxes that a ray, or a sphere moving along it, meets.
class RayProbe {
public:
    /// `root` encloses all boxes that will be tested.
    RayProbe(Vec3 origin, Vec3 direction, double radius, const Box& root);

    /// What hits() compares with, for a ray that ends at t_max; negative if it meets nothing.
    float limit(double t_max) const;

    /// Lanes that the ray meets no later than at `limit`; `entry` is where, in the same unit.
    uint32_t hits(const Box8& boxes, float limit, Float8& entry) const {
        const auto slab = [&](const int* row, const float* origin, int k) {
            return (load(boxes.row[row[k]]) - splat(origin[k])) * splat(inverse_[k]);
        };
        entry = max(max(slab(near_row_, near_origin_, 0), slab(near_row_, near_origin_, 1)),
                    max(slab(near_row_, near_origin_, 2), splat(0)));
        const Float8 exit =
            min(min(slab(far_row_, far_origin_, 0), slab(far_row_, far_origin_, 1)), slab(far_row_, far_origin_, 2));
        return bits(entry <= min(exit * splat(1 + 8 * 0x1p-24f), splat(limit)));
    }

private:
    int near_row_[3], far_row_[3];
    float near_origin_[3], far_origin_[3], inverse_[3];
    double scale_;  // of t
    double start_ = 0, span_ = 0;
    double slack_;
    bool everything_ = false;
};

/// Boxes near a point, by a lower bound of their squared distance.
class PointProbe {
public:
    PointProbe(Vec3 point, const Box& root);

    float limit(double max_distance) const;

    uint32_t hits(const Box8& boxes, float limit, Float8& distance_squared) const {
        const auto gap = [&](int k) {
            return max(max(load(boxes.row[k]) - splat(high_[k]), splat(low_[k]) - load(boxes.row[3 + k])), splat(0));
        };
        const Float8 x = gap(0), y = gap(1), z = gap(2);
        distance_squared = x * x + y * y + z * z;
        return bits(distance_squared <= splat(limit));
    }

private:
    float low_[3], high_[3];
    double slack_;
};

/// Boxes outside none of the six planes of a frustum.
class FrustumProbe {
public:
    static constexpr uint32_t all_planes = 0x3f;

    explicit FrustumProbe(const Frustum& frustum);

    /// Lanes that are not wholly outside one of `planes`; inside[p] are those wholly inside plane p.
    uint32_t hits(const Box8& boxes, uint32_t planes, uint32_t inside[6]) const;

private:
    struct FloatPlane {
        float normal[3];
        float outside_below, inside_above;
    };
    float origin_low_[3], origin_high_[3];
    FloatPlane planes_[6];
};

}  // namespace gphys

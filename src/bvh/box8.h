// Eight AABBs in structure-of-arrays layout, and probes: queries rounded conservatively to float, for kernels that test
// all eight at once (box8_tests.h). A probe never rejects a box that the exact query overlaps. The derivations are in
// box8.cpp.
#pragma once

#include "geometry/overlap_boxes.h"

namespace gphys {

/// Largest coordinate that a box may have: leaves room for a model of the largest size at the
/// largest position, while areas stay far below the largest float.
constexpr float max_box_coordinate = 0x1p52f;

/// Holds all boxes.
constexpr Box all_of_space{{-max_box_coordinate, -max_box_coordinate, -max_box_coordinate},
                           {max_box_coordinate, max_box_coordinate, max_box_coordinate}};

struct alignas(32) Box8 {
    float row[6][8];  // min x, y, z, max x, y, z

    /// Eight floats of which the first is that of row[i / 8][i % 8].
    const float* from(uint32_t i) const { return reinterpret_cast<const float*>(this) + i; }
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
/// What all rays have in common.
struct RaysRoot {
    RaysRoot() = default;
    explicit RaysRoot(const Box& box, double radius = 0);

    double low[4], high[4];  // x, y, z, x
    double extent;           // the largest coordinate
    double radius;           // of the rays
};

/// The span of a query that is so large that the tests let every box pass.
constexpr double beyond_trees = 0x1p100;

/// Boxes that a ray, or a sphere moving along it, meets. In fours, so that eight rays are written at
/// once (ray_lanes.h).
struct alignas(16) RayProbe {
    RayProbe() = default;
    /// `root` encloses all boxes that will be tested.
    RayProbe(Vec3 origin, Vec3 direction, double radius, const Box& root);
    RayProbe(Vec3 origin, Vec3 direction, const RaysRoot& root);
    /// For a box that moves: its middle, its way, and how far it reaches along each axis.
    RayProbe(Vec3 middle, Vec3 displacement, Vec3 half, const Box& root);

    /// False if every box passes.
    bool excludes() const { return course.span < beyond_trees; }

    /// What box tests compare with, for a ray that ends at t_max; negative if it meets nothing.
    float limit(double t_max) const;

    // For each axis: the origin as seen from the faces that the ray enters and leaves boxes by, which
    // has the margin for all rounding, minus one over the direction, and where the rows of these faces
    // begin in a Box8. The fourth is not used.
    float near_origin[4], far_origin[4], back[4];
    uint32_t near_face[4], far_face[4];
    double begin[4];  // the origin, moved forward to the root box
    struct {
        double slack;               // what the query's own arithmetic may be off by on each axis
        double scale, start, span;  // t * scale - start is how far t is from there; within the root up to span
    } course;
};

/// Which rays of many are coherent enough for a packet: those that stay together within about the size of a leaf.
class RayPackets {
public:
    static constexpr uint32_t most = 64;  // rays of a packet

    RayPackets(const Box& root, uint32_t items);

    /// Cuts rays 0 .. count - 1 into runs: run(first, last, is_packet). ray_of(i) is one, probe_of(i) its probe.
    template <class RayOf, class ProbeOf, class Run>
    void split(const RayOf& ray_of, const ProbeOf& probe_of, uint32_t count, const Run& run) const {
        constexpr uint32_t worth_it = 8;  // a packet costs as much as about six interleaved rays
        uint32_t alone = 0;               // first of those that have found no company
        for (uint32_t first = 0; first < count;) {
            const uint32_t end = std::min(first + most, count);
            uint32_t last = first + 1;
            // Rays that have nothing in common are mostly told by their signs.
            if (last < end && same_signs(probe_of(first), probe_of(last))) {
                const Corridor corridor = corridor_of(ray_of(first));
                while (last < end && corridor.holds(ray_of(last)) && same_signs(probe_of(first), probe_of(last))) {
                    ++last;
                }
            }
            if (last - first >= worth_it) {
                if (alone < first) run(alone, first, false);
                run(first, last, true);
                alone = last;
            }
            first = last;
        }
        if (alone < count) run(alone, count, false);
    }

private:
    /// Where rays keep company with the first of them: squares of how far apart origins may be, and
    /// of the sine between directions.
    struct Corridor {
        const Ray& ray;
        double apart, slope;

        bool holds(const Ray& other) const {
            return length_squared(cross(ray.direction, other.direction)) <= slope * length_squared(other.direction) &&
                   length_squared(other.origin - ray.origin) <= apart;
        }
    };
    Corridor corridor_of(const Ray& ray) const;
    static bool same_signs(const RayProbe& a, const RayProbe& b) {
        uint32_t differ = 0;  // of incoherent rays it is unpredictable which axis tells
        for (int k = 0; k < 3; ++k) differ |= a.near_face[k] ^ b.near_face[k];
        return differ == 0;
    }

    Vec3 centre_;
    double radius_;  // of the root
    double leaf_size_;
};

/// Boxes near a point, by a lower bound of their squared distance.
struct PointProbe {
    PointProbe(Vec3 point, const Box& root);

    float limit(double max_distance) const;

    float low[3], high[3];  // the point between two floats on each axis

protected:
    double slack_;
};

/// The same where distances along each axis count by a weight of its own. The point is that of the boxes as they are.
struct WeightedPointProbe : PointProbe {
    /// `weights` are floats.
    WeightedPointProbe(Vec3 point, Vec3 weights, const Box& root);

    float weight[3];
};

/// Boxes that a ball touches, or holds.
struct BallProbe {
    BallProbe() = default;
    BallProbe(Vec3 center, double radius, const Box& root);

    float low[3], high[3];              // the centre between two floats on each axis
    float outside_above, inside_below;  // of squared distances
};

/// Boxes outside none of the six planes of a frustum, nor of a box around it. Without that, a box
/// behind the viewer that crosses the planes of two sides would count.
struct FrustumProbe {
    FrustumProbe(const Frustum& frustum, const Box& around);

    struct FloatPlane {
        float normal[3], error[3];
        float outside_below, inside_above;
    };
    Box around;
    float origin_low[3], origin_high[3];
    FloatPlane planes[6];
};

}  // namespace gphys

// Eight AABBs in structure-of-arrays layout, and probes: queries rounded conservatively to float, for kernels that test
// all eight at once (box8_tests.h). A probe never rejects a box that the exact query overlaps. Float tests with a
// margin take half the registers and bandwidth of double ones; what they accept too much is tested exactly later.
// box8.cpp derives the margins.
#pragma once

#include "geometry/overlap_boxes.h"

namespace gphys {

/// The largest coordinate of a box. A model of the largest size at the largest position stays below it, and areas stay
/// far below the largest float.
constexpr float max_box_coordinate = 0x1p52f;

constexpr Box all_of_space{{-max_box_coordinate, -max_box_coordinate, -max_box_coordinate},
                           {max_box_coordinate, max_box_coordinate, max_box_coordinate}};

struct alignas(32) Box8 {
    float row[6][8];  // min x, y, z, max x, y, z

    /// Eight floats, beginning at row[i / 8][i % 8].
    const float* row_from(uint32_t i) const { return reinterpret_cast<const float*>(this) + i; }
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

/// The root's box in double, as the probes of all rays of a query read it.
struct RootBounds {
    RootBounds() = default;
    explicit RootBounds(const Box& box, double radius = 0);

    double low[4], high[4];  // x, y, z, x
    double extent;           // the largest absolute coordinate
    double radius;           // of the sphere that moves along the rays
};

/// RayProbe::path.span of a query so large that its margin accepts every box.
constexpr double unbounded_span = 0x1p100;

/// Finds the boxes that a ray, or a sphere moving along it, hits. Arrays of four, so that kernels write eight probes
/// by transpositions (ray_lanes.h).
struct alignas(16) RayProbe {
    RayProbe() = default;
    /// `root` encloses all boxes that will be tested.
    RayProbe(Vec3 origin, Vec3 direction, double radius, const Box& root);
    RayProbe(Vec3 origin, Vec3 direction, const RootBounds& root);
    /// For a moving box, by its centre and half extents.
    RayProbe(Vec3 middle, Vec3 displacement, Vec3 half, const Box& root);

    /// False if the probe accepts every box.
    bool may_reject() const { return path.span < unbounded_span; }

    /// The end of the ray at t_max in the unit of the box tests; negative if the ray hits no box.
    float limit(double t_max) const;

    // For each axis; the fourth is unused. The origin, moved by the margin: forward for entries, backward for exits.
    // -1 / direction. Offsets in a Box8 of the rows of the faces where the ray enters and leaves boxes.
    float near_origin[4], far_origin[4], minus_inverse[4];
    uint32_t near_face[4], far_face[4];
    double begin[4];  // the origin, moved forward to the root box
    struct {
        double slack;  // bound of the rounding of the query's own arithmetic, on each axis
        // t * scale - start: distance along the main axis from `begin`. The ray leaves the root box at `span`.
        double scale, start, span;
    } path;
};

/// Divides rays into packets and single rays. Consecutive rays form a packet if, within the tree, they stay together
/// within about the size of a leaf.
class RayPackets {
public:
    static constexpr uint32_t max_rays = 64;  // of a packet

    RayPackets(const Box& root, uint32_t items);

    /// Divides rays 0 .. count - 1 into runs: run(first, last, is_packet). ray_of(i) is a ray, probe_of(i) its probe.
    template <class RayOf, class ProbeOf, class Run>
    void split(const RayOf& ray_of, const ProbeOf& probe_of, uint32_t count, const Run& run) const {
        constexpr uint32_t min_packet_rays = 8;  // a packet costs as much as about six interleaved rays
        uint32_t first_single = 0;               // of the rays before `first` that are in no packet yet
        for (uint32_t first = 0; first < count;) {
            const uint32_t end = std::min(first + max_rays, count);
            uint32_t last = first + 1;
            // The cheap test first: incoherent rays mostly differ in a sign.
            if (last < end && same_signs(probe_of(first), probe_of(last))) {
                const CoherenceBounds bounds = coherence_bounds_of(ray_of(first));
                while (last < end && bounds.contains(ray_of(last)) && same_signs(probe_of(first), probe_of(last))) {
                    ++last;
                }
            }
            if (last - first >= min_packet_rays) {
                if (first_single < first) run(first_single, first, false);
                run(first, last, true);
                first_single = last;
            }
            first = last;
        }
        if (first_single < count) run(first_single, count, false);
    }

private:
    /// Bounds of the difference from the first ray of a packet, squared: the distance of the origins, and the sine
    /// between the directions, times the first's length.
    struct CoherenceBounds {
        const Ray& ray;
        double distance_squared, slope;

        bool contains(const Ray& other) const {
            return length_squared(cross(ray.direction, other.direction)) <= slope * length_squared(other.direction) &&
                   length_squared(other.origin - ray.origin) <= distance_squared;
        }
    };
    CoherenceBounds coherence_bounds_of(const Ray& ray) const;
    static bool same_signs(const RayProbe& a, const RayProbe& b) {
        uint32_t differ = 0;  // no early exit: it would be an unpredictable branch
        for (int k = 0; k < 3; ++k) differ |= a.near_face[k] ^ b.near_face[k];
        return differ == 0;
    }

    Vec3 centre_;
    double radius_;  // of the root
    double leaf_size_;
};

/// Finds the boxes near a point, by a lower bound of their squared distance.
struct PointProbe {
    PointProbe() = default;
    PointProbe(Vec3 point, const Box& root);

    float limit(double max_distance) const;

    float low[3], high[3];  // two floats around each coordinate of the point

protected:
    double slack_;
};

/// The same with distances multiplied by a weight on each axis. The point is in the unweighted space of the boxes.
struct WeightedPointProbe : PointProbe {
    /// `weights` are floats.
    WeightedPointProbe(Vec3 point, Vec3 weights, const Box& root);

    float weight[3];
};

/// Finds the boxes that a ball overlaps, and those inside it.
struct BallProbe {
    BallProbe() = default;
    BallProbe(Vec3 center, double radius, const Box& root);

    float low[3], high[3];  // two floats around each coordinate of the centre
    // Bounds of squared distances: a box is outside if its nearest point is beyond the first, inside if its farthest
    // point is within the second.
    float outside_above, inside_below;
};

/// Finds the boxes that are outside none of a frustum's six planes and overlap the frustum's AABB. The AABB rejects
/// boxes behind the viewer that cross the planes of two sides.
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

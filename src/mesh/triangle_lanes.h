// Eight pairs of a ray and a triangle in double, with the formulas of raycast_triangle.cpp (Woop, Benthin, Wald 2013)
// and the same bits. Pairs that need exact arithmetic, and special cases, are left to that file. With registers of two
// doubles, tests of single pairs are faster, so that narrow sets have none of this.
#pragma once

#include "bvh/ray_setup.h"
#include "foundation/compiler.h"
#include "geometry/hit_lanes.h"
#include "mesh/mesh_ray.h"

namespace gphys::GPHYS_ISA {

/// Pairs of a ray, by its index, and a triangle. Entries beyond the count are valid, but their results are ignored.
struct RaysAndTriangles {
    explicit RaysAndTriangles(const TrianglePacket& any) {
        for (const TrianglePacket*& one : packet) one = &any;
    }

    void add(uint32_t of, const TrianglePacket& in, uint32_t at) {
        ray[count] = of;
        packet[count] = &in;
        lane[count++] = at;
    }

    uint32_t count = 0;
    uint32_t ray[8] = {}, lane[8] = {};
    const TrianglePacket* packet[8];
};

#if GPHYS_HAS_AVX2

/// For fewer pairs, single tests are faster.
constexpr uint32_t worth_eight_lanes = double_register_lanes == 8 ? 3 : 6;

/// The corners of eight triangles. Neighbours mostly are in one packet. So each run of lanes with the same packet, and
/// the same order of axes, is read by permutations of the packet's rows, instead of gathered float by float.
class Corners8 {
public:
    /// packet_of(i), lane_of(i), i < 8: where triangle i is. axes_of(i): the axes to read as x, y, z, an int[4].
    template <class PacketOf, class LaneOf, class AxesOf>
    GPHYS_INLINE Corners8(const PacketOf& packet_of, const LaneOf& lane_of, const AxesOf& axes_of) {
        uint32_t starts = 1;  // of runs
        for (int i = 0; i < 8; ++i) lanes_[i] = lane_of(i);
        for (int i = 1; i < 8; ++i) {
            // Without a branch.
            const uint32_t other_packet = packet_of(i) != packet_of(i - 1),
                           other_x = axes_of(i)[0] != axes_of(i - 1)[0], other_y = axes_of(i)[1] != axes_of(i - 1)[1];
            starts |= (other_packet | other_x | other_y) << i;
        }
        constexpr float numbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
        for (; starts != 0; starts &= starts - 1) {
            const int first = lowest_bit(starts);
            const Mask8 from_here = splat(static_cast<float>(first)) <= load(numbers);
            const int* axes = axes_of(first);
            for (int k = 0; k < 3; ++k) {
                for (int c = 0; c < 3; ++c) {
                    const Float8 row = load_permuted(packet_of(first)->corner[c][axes[k]], lanes_);
                    corner_[c][k] = choose(from_here, row, first == 0 ? row : corner_[c][k]);
                }
            }
        }
    }

    GPHYS_INLINE Vec<Double8> operator[](int c) const {
        return {widened(corner_[c][0]), widened(corner_[c][1]), widened(corner_[c][2])};
    }

private:
    uint32_t lanes_[8];
    Float8 corner_[3][3];
};

struct Crossings8 {
    uint32_t no, yes;  // the others are undecided
    double t[8], u[8], v[8];
    float rounded_t[8];  // as it is reported
    float limit[8];      // the limit of the ray's traversal after the hit
    uint32_t back;       // from behind

    GPHYS_INLINE Crossings8(const RaysAndTriangles& pairs, const PreparedRay* rays) {
        const auto ray = [&](int i) -> const PreparedRay& { return rays[pairs.ray[i]]; };
        const Corners8 corners([&](int i) { return pairs.packet[i]; }, [&](int i) { return pairs.lane[i]; },
                               [&](int i) { return ray(i).triangles.axis; });
        Double8 from[4], rest[4], path[4];
        load_components([&](int i) { return ray(i).sheared.from; }, from);
        load_components([&](int i) { return &ray(i).sheared.sx; }, rest);
        load_components([&](int i) { return &ray(i).along.path.slack; }, path);
        const Double8 speed = from[3], t_max = rest[2];

        const auto sheared = [&](int of) {
            const Vec<Double8> corner = corners[of];
            const Double8 z_of = corner.z - from[2];
            return Vec<Double8>{corner.x - from[0] - rest[0] * z_of, corner.y - from[1] - rest[1] * z_of, z_of};
        };
        const Vec<Double8> a = sheared(0), b = sheared(1), c = sheared(2);
        const Double8 volume_a = c.x * b.y - c.y * b.x;
        const Double8 volume_b = a.x * c.y - a.y * c.x;
        const Double8 volume_c = b.x * a.y - b.y * a.x;
        const auto reach = [](Double8 p, Double8 q, Double8 s) {
            return largest(absolute(p), largest(absolute(q), absolute(s)));
        };
        const Double8 r = largest(reach(a.x, b.x, c.x), reach(a.y, b.y, c.y)), reach_z = reach(a.z, b.z, c.z);
        const Double8 coordinate_error = 5 * 0x1p-53 * (r + 2 * reach_z);
        const Double8 volume_error = 8 * coordinate_error * (r + coordinate_error);
        const Double8 lowest = least(volume_a, least(volume_b, volume_c));
        const Double8 highest = largest(volume_a, largest(volume_b, volume_c));
        const DoubleMask8 moves = 0 < absolute(speed), from_behind = highest < -volume_error;
        const DoubleMask8 beside = moves & (lowest < -volume_error) & (volume_error < highest);
        const DoubleMask8 through = moves & ((volume_error < lowest) | from_behind);

        const Double8 total = select(through, volume_a + volume_b + volume_c, 1.0);
        const Double8 weight_error = 4.5 * volume_error, size = absolute(total);
        const Double8 weight_b = volume_b / total, weight_c = volume_c / total;
        const Double8 spread = largest(absolute(b.z - a.z), absolute(c.z - a.z));
        const Double8 z = a.z + weight_b * (b.z - a.z) + weight_c * (c.z - a.z);
        const Double8 z_error = 2 * weight_error / size * spread + 0x1p-50 * reach_z;
        const DoubleMask8 accurate = through & (weight_error <= 0x1p-26 * size) & (z_error <= 0x1p-30 * absolute(z));
        const Double8 way = select(accurate, z, 0.0) / select(moves, speed, 1.0);
        const DoubleMask8 behind = accurate & (way < 0);
        const DoubleMask8 clear = accurate & (0x1p-40 * absolute(way) < absolute(way - t_max));
        const DoubleMask8 in_time = way <= t_max;

        no = bits(beside | behind | (clear & !in_time));
        yes = bits(clear & in_time & !behind);
        back = bits(from_behind);
        store(t, way);
        store(u, weight_b);
        store(v, weight_c);
        constexpr double last = std::numeric_limits<float>::max();
        gphys::GPHYS_ISA::store(rounded_t, narrowed(least(last, largest(way, 0.0) + 0.0)));
        const Double8 end = limit_of_ties(way);
        gphys::GPHYS_ISA::store(limit, narrowed(ray_limit(end, path[0], path[1], path[2], path[3])));
    }
    GPHYS_INLINE TriangleCrossing operator[](uint32_t i) const {
        return {t[i], u[i], v[i], (back >> i & 1) != 0 ? 1 : -1};
    }
};

/// Writes the hits of eight rays at their nearest crossings, as hit_at, transformed by place(point, normal). Returns
/// the lanes that are right; the others need the scalar function.
template <class Place>
GPHYS_INLINE uint32_t make_hits(const NearestCrossing* const (&nearest)[8], const PreparedRay* const (&rays)[8],
                                const Place& place, gphys_hit* const (&out)[8]) {
    constexpr int axes[4] = {0, 1, 2, 3};
    const Corners8 corners([&](int i) { return nearest[i]->packet; }, [&](int i) { return nearest[i]->lane; },
                           [&](int) { return axes; });
    Double8 crossing[3], speed[1];
    load_components([&](int i) { return &nearest[i]->crossing.t; }, crossing);
    load_components([&](int i) { return &rays[i]->sheared.speed; }, speed);

    const Vec<Double8> a = corners[0], ab = corners[1] - a, ac = corners[2] - a;
    // The scalar form is accurate_cross.
    DoubleMask8 clear = 0 < absolute(speed[0]);
    const auto difference = [&](Double8 p, Double8 q) {
        const Double8 value = p - q;
        clear = clear & (5 * 0x1p-53 * (absolute(p) + absolute(q)) <= 0x1p-45 * absolute(value));
        return value;
    };
    const Vec<Double8> turn{difference(ab.y * ac.z, ab.z * ac.y), difference(ab.z * ac.x, ab.x * ac.z),
                            difference(ab.x * ac.y, ab.y * ac.x)};
    clear = clear & (0 < max_component(abs(turn)));

    float side[8], triangle[8];
    for (int i = 0; i < 8; ++i) {
        side[i] = nearest[i]->crossing.facing > 0 ? -1.0f : 1.0f;
        std::memcpy(&triangle[i], &nearest[i]->triangle, sizeof triangle[i]);
    }
    Vec<Double8> normal = normalized(select(clear, turn, {1.0, 0.0, 0.0})) * widened(load(side));
    const auto clamped = [](Double8 weight, Double8 most) {
        return select(weight < 0, 0.0, select(most < weight, most, weight)) + 0.0;  // as in hit_at
    };
    const Double8 u = clamped(crossing[1], 1.0), v = clamped(crossing[2], 1.0 - u);

    Vec<Double8> point = a + ab * u + ac * v;
    place(point, normal);
    const Quads8 at = rounded_place(crossing[0] + 0.0, point), facing = rounded_normal(normal, load(triangle));
    const auto floats = [&](int i) { return reinterpret_cast<float*>(out[i]); };
    static_assert(offsetof(gphys_hit, t) == 8 && offsetof(gphys_hit, triangle) == 36 && offsetof(gphys_hit, v) == 44);
    store_quads(floats, {splat(0), splat(0), at.x, at.y});  // model and tag are 0
    store_quads([&](int i) { return floats(i) + 4; }, {at.z, at.w, facing.x, facing.y});
    store_quads([&](int i) { return floats(i) + 8; }, {facing.z, facing.w, narrowed(u), narrowed(v)});
    for (int i = 0; i < 8; ++i) {
        out[i]->flags = (nearest[i]->crossing.t == 0 ? GPHYS_HIT_INSIDE : 0) | (side[i] < 0 ? GPHYS_HIT_BACK : 0);
    }
    return bits(clear);
}

#endif

}  // namespace gphys::GPHYS_ISA

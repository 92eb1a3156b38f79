// Eight pairs of a ray and a triangle in double, with the formulas of raycast_triangle.cpp (Woop, Benthin, Wald 2013)
// and the same bits. Pairs that need exact arithmetic, and special cases, are left to that file.
#pragma once

#include "bvh/ray_setup.h"
#include "foundation/compiler.h"
#include "geometry/hit_lanes.h"
#include "mesh/mesh_ray.h"

namespace gphys::GPHYS_ISA {

/// For fewer pairs, single tests are faster; with registers of two doubles, always.
constexpr uint32_t worth_eight_lanes = double_register_lanes == 8 ? 3 : double_register_lanes == 4 ? 6 : 9;

/// Corner c of eight triangles: first_of(i, k) points to coordinate k of the first corner in its packet.
template <class FirstOf>
GPHYS_INLINE Vec<Double8> corners8(const FirstOf& first_of, int c) {
    constexpr int next = sizeof(TrianglePacket::corner[0]) / sizeof(float);
    const auto coordinate = [&](int k) {
        return widened(load_lanes([&](int i) { return first_of(i, k) + next * c; }));
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
}

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

struct Crossings8 {
    uint32_t no, yes;  // the others are undecided
    double t[8], u[8], v[8];
    float rounded_t[8];  // as it is reported
    float limit[8];      // the limit of the ray's traversal after the hit
    uint32_t back;       // from behind

    GPHYS_INLINE Crossings8(const RaysAndTriangles& pairs, const PreparedRay* rays) {
        const auto ray = [&](int i) -> const PreparedRay& { return rays[pairs.ray[i]]; };
        const auto first = [&](int i, int k) {
            return pairs.packet[i]->corner[0][ray(i).triangles.axis[k]] + pairs.lane[i];
        };
        Double8 from[4], rest[4], path[4];
        load_components([&](int i) { return ray(i).sheared.from; }, from);
        load_components([&](int i) { return &ray(i).sheared.sx; }, rest);
        load_components([&](int i) { return &ray(i).along.path.slack; }, path);
        const Double8 speed = from[3], t_max = rest[2];

        const auto sheared = [&](int of) {
            const Vec<Double8> corner = corners8(first, of);
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

/// The hits of eight rays at their nearest crossings, as hit_at, transformed by place(point, normal). Returns the lanes
/// that were made; the others need the scalar function.
template <class Place>
GPHYS_INLINE uint32_t make_hits(const NearestCrossing* const (&nearest)[8], const PreparedRay* const (&rays)[8],
                                const Place& place, gphys_hit (&out)[8]) {
    const auto first = [&](int i, int k) { return nearest[i]->packet->corner[0][k] + nearest[i]->lane; };
    Double8 crossing[3], speed[1];
    load_components([&](int i) { return &nearest[i]->crossing.t; }, crossing);
    load_components([&](int i) { return &rays[i]->sheared.speed; }, speed);

    const Vec<Double8> a = corners8(first, 0), ab = corners8(first, 1) - a, ac = corners8(first, 2) - a;
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
    store_quads([&](int i) { return &out[i].t; }, rounded_place(crossing[0] + 0.0, point));
    store_quads([&](int i) { return &out[i].normal.x; }, rounded_normal(normal, load(triangle)));
    float us[8], vs[8];
    gphys::GPHYS_ISA::store(us, narrowed(u));
    gphys::GPHYS_ISA::store(vs, narrowed(v));
    for (int i = 0; i < 8; ++i) {
        out[i].model = out[i].tag = 0;
        out[i].u = us[i];
        out[i].v = vs[i];
        out[i].flags = (nearest[i]->crossing.t == 0 ? GPHYS_HIT_INSIDE : 0) | (side[i] < 0 ? GPHYS_HIT_BACK : 0);
    }
    return bits(clear);
}

}  // namespace gphys::GPHYS_ISA

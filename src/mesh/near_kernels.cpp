// Conservative distances of a point to triangles, eight at a time in float, and culling by half-spaces.
//
// The closest point of a triangle is the closest point of one of its edges, or the projection onto its plane. From it
// follows a lower bound of the distance that holds whatever the rounding errors are (distance_at_least).
#include "mesh/near_kernels.h"

#include <limits>

#include "foundation/compiler.h"
#include "foundation/simd.h"
#include "foundation/vec.h"
#include "mesh/triangle_test.h"

namespace gphys::GPHYS_ISA {
namespace {

// Corners are taken relative to the point and divided by the packet's extent E, a bound for the sum of the magnitudes
// of their coordinates. That takes three roundings of 2^-24 of E. A dot product with a unit vector takes three more,
// and the unit vector itself one: 7 * 2^-24 in all. The extent includes its own roundings.
constexpr float height_error = 0x1p-20f;
// A vector normalised in float is longer than 1 by at most 5 * 2^-24.
constexpr float shortened = 1 - 0x1p-20f;
// A number that is smaller, relative to the extent, counts as 0: dividing by it or by its square does not overflow.
constexpr float tiny = 1e-30f;

struct Corners {
    Vec<Float8> a, b, c;

    /// Relative to the point, times `scale`.
    GPHYS_INLINE Corners(const TrianglePacket& packet, const NearProbe& probe, float scale)
        : a(corner(packet, probe, scale, 0)), b(corner(packet, probe, scale, 1)), c(corner(packet, probe, scale, 2)) {}

    /// The largest sum of the magnitudes of a corner's coordinates.
    Float8 extent() const { return max(max(sum(abs(a)), sum(abs(b))), sum(abs(c))); }
    void scale(Float8 by) { a = a * by, b = b * by, c = c * by; }

private:
    GPHYS_INLINE static Vec<Float8> corner(const TrianglePacket& packet, const NearProbe& probe, float scale, int k) {
        const auto relative = [&](int axis) {
            return (load(packet.corner[k][axis]) - splat(probe.base[axis]) - splat(probe.offset[axis])) * splat(scale);
        };
        return {relative(0), relative(1), relative(2)};
    }
};

/// The point of an edge closest to the origin, and its squared distance.
GPHYS_INLINE Vec<Float8> nearest_on_edge(const Vec<Float8>& from, const Vec<Float8>& along, Float8& squared) {
    const Float8 t = (splat(0) - dot(from, along)) / max(dot(along, along), splat(tiny));
    const Vec<Float8> nearest = from + along * min(max(t, splat(0)), splat(1));
    squared = dot(nearest, nearest);
    return nearest;
}

/// A lower bound of the distance from the origin. It holds for any vector q, however inaccurate and however thin the
/// triangle: the triangle is beyond the plane normal to q through the corner that is lowest along q. It is tight if q
/// is the closest point.
GPHYS_INLINE Float8 distance_at_least(const Corners& t) {
    const Vec<Float8> ab = t.b - t.a, ac = t.c - t.a;
    Float8 squared, other;
    Vec<Float8> nearest = nearest_on_edge(t.a, ab, squared);
    const auto take_nearer = [&](const Vec<Float8>& candidate) {
        nearest = select(other <= squared, candidate, nearest);
        squared = min(other, squared);
    };
    take_nearer(nearest_on_edge(t.a, ac, other));
    take_nearer(nearest_on_edge(t.b, t.c - t.b, other));
    // The projection onto the plane is in the triangle if, seen along the normal, the origin is on the same side of all
    // edges.
    const Vec<Float8> normal = cross(ab, ac);
    const Float8 square = dot(normal, normal);
    const Float8 inside =
        min(min(dot(normal, cross(t.a, t.b)), dot(normal, cross(t.b, t.c))), dot(normal, cross(t.c, t.a)));
    const Vec<Float8> foot = normal * (dot(normal, t.a) / max(square, splat(tiny)));
    nearest = select((splat(0) <= inside) & (splat(tiny) <= square), foot, nearest);
    const Float8 along = min(min(dot(nearest, t.a), dot(nearest, t.b)), dot(nearest, t.c));
    return along / sqrt(max(dot(nearest, nearest), splat(tiny))) * splat(shortened) - splat(height_error);
}

void drop_lanes(NearPacket& packet, uint32_t lanes) {
    for (; lanes != 0; lanes &= lanes - 1) packet.distance[lowest_bit(lanes)] = std::numeric_limits<float>::infinity();
}

uint32_t find(const Box8* boxes, const TrianglePacket* const* packets, uint32_t count, const NearProbe& probe,
              NearPacket* out) {
    // No box is larger than this, and its square is still a finite float. Squares of subnormal size have an error of
    // 2^-150 each; their root is off by less than `smallest`.
    const Float8 largest = splat(1e18f), smallest = splat(1e-22f);
    uint32_t found = 0;
    for (uint32_t first = 0; first < count; first += 8) {
        const Box8& eight = boxes[first / 8];
        Float8 extent = splat(0), squared = splat(0);
        for (int k = 0; k < 3; ++k) {
            const Float8 base = splat(probe.base[k]), offset = splat(probe.offset[k]);
            const Float8 low = load(eight.row[k]) - base, high = load(eight.row[3 + k]) - base;
            const Float8 gap = min(max(max(low - offset, offset - high), splat(0)), largest);
            squared = squared + gap * gap;
            extent = extent + max(abs(low), abs(high)) + abs(offset);
        }
        extent = max(extent * splat(1 + 0x1p-20f), splat(tiny));
        const Float8 error = extent * splat(height_error) + smallest;
        const Float8 distance = max(sqrt(squared) * splat(shortened) - error, splat(0));
        uint32_t hits = bits(distance <= splat(probe.radius));
        if (count - first < 8) hits &= (1u << (count - first)) - 1;
        if (hits == 0) continue;
        float distances[8], extents[8];
        store(distances, distance);
        store(extents, extent);
        for (; hits != 0; hits &= hits - 1) {
            const uint32_t i = static_cast<uint32_t>(lowest_bit(hits));
            NearPacket& near = out[found++];
            near.packet = packets[first + i];
            near.extent = extents[i];
            near.measured = 0;
            store(near.distance, splat(distances[i]));
            drop_lanes(near, ~used_lanes(*near.packet) & 0xff);
        }
    }
    return found;
}

void measure(NearPacket& near, const NearProbe& probe) {
    const Float8 part = max(distance_at_least(Corners(*near.packet, probe, 1 / near.extent)), splat(0));
    const Float8 distance = max(part * splat(near.extent * shortened), load(near.distance));
    store(near.distance, distance);
    drop_lanes(near, ~bits(distance <= splat(probe.radius)) & 0xff);
    near.measured = 1;
}

uint32_t lanes_within(const TrianglePacket& packet, const NearProbe& probe, float* distances) {
    Corners corners(packet, probe, 1);
    const Float8 extent = max(corners.extent() * splat(1 + 0x1p-20f), splat(tiny));
    corners.scale(splat(1) / extent);
    const uint32_t used = used_lanes(packet);
    const Float8 distance = max(distance_at_least(corners), splat(0)) * (extent * splat(shortened));
    store(distances, distance);
    for (uint32_t rest = ~used & 0xff; rest != 0; rest &= rest - 1) {
        distances[lowest_bit(rest)] = std::numeric_limits<float>::infinity();
    }
    return bits(distance <= splat(probe.radius)) & used;
}

uint32_t cull(NearPacket* packets, uint32_t count, const NearProbe& probe, const HalfSpaceProbe& plane,
              uint32_t* open) {
    const Vec<Float8> normal{splat(plane.normal[0]), splat(plane.normal[1]), splat(plane.normal[2])};
    uint32_t left = 0;
    for (uint32_t k = 0; k < count; ++k) {
        NearPacket& near = packets[k];
        const uint32_t there = bits(load(near.distance) <= splat(probe.radius));
        if (there == 0) continue;
        const Corners t(*near.packet, probe, 1);
        const Float8 height = max(max(dot(normal, t.a), dot(normal, t.b)), dot(normal, t.c));
        const float error = near.extent * height_error;
        const uint32_t behind = there & bits(height <= splat(plane.lowest - error));
        if (behind == there) continue;
        drop_lanes(near, behind);
        open[left] = there & ~behind & bits(height <= splat(plane.highest + error));
        packets[left++] = near;
    }
    return left;
}

float nearest(const NearPacket* packets, uint32_t count, uint32_t& place) {
    Float8 least = splat(std::numeric_limits<float>::infinity());
    for (uint32_t k = 0; k < count; ++k) least = min(least, load(packets[k].distance));
    float lanes[8];
    store(lanes, least);
    float best = lanes[0];
    for (const float lane : lanes) best = lane < best ? lane : best;
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t equal = bits(load(packets[k].distance) <= splat(best));
        if (equal == 0) continue;
        place = 8 * k + static_cast<uint32_t>(lowest_bit(equal));
        break;
    }
    return best;
}

}  // namespace

const NearKernels near_kernels = {find, measure, lanes_within, cull, nearest};

}  // namespace gphys::GPHYS_ISA

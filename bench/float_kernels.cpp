#include "float_kernels.h"

#include "bvh/interleaved_traversal.h"
#include "bvh/packet_traversal.h"

namespace gphys::GPHYS_ISA {

namespace {

/// Moeller and Trumbore 1997, for eight triangles. True if one of them is nearer than what the ray has.
bool meet(const TrianglePacket& packet, FloatRay& ray) {
    Float8 a[3], ab[3], ac[3], d[3];
    for (int k = 0; k < 3; ++k) {
        const Float8 corner = load_aligned(packet.corner[0][k]);
        ab[k] = load_aligned(packet.corner[1][k]) - corner;
        ac[k] = load_aligned(packet.corner[2][k]) - corner;
        a[k] = splat(ray.origin[k]) - corner;
        d[k] = splat(ray.direction[k]);
    }
    const auto dot = [](const Float8* p, const Float8* q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };
    const auto cross = [](const Float8* p, const Float8* q, Float8* out) {
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            out[k] = p[i] * q[j] - p[j] * q[i];
        }
    };
    Float8 p[3], q[3];
    cross(d, ac, p);
    cross(a, ab, q);
    const Float8 zero = splat(0), one = splat(1), inverse = one / dot(ab, p);
    const Float8 u = dot(a, p) * inverse, v = dot(d, q) * inverse, t = dot(ac, q) * inverse;
    // In unused lanes, which repeat lane 0, there is no index.
    uint32_t hits = bits((zero <= u) & (zero <= v) & (u + v <= one) & (zero <= t) & (t <= splat(ray.t)));
    if (hits == 0) return false;
    float times[8], us[8], vs[8];
    store(times, t);
    store(us, u);
    store(vs, v);
    bool nearer = false;
    for (; hits != 0; hits &= hits - 1) {
        const int lane = __builtin_ctz(hits);
        if (packet.index[lane] == TrianglePacket::none || !(times[lane] < ray.t)) continue;
        ray.t = times[lane];
        ray.u = us[lane];
        ray.v = vs[lane];
        ray.item = packet.index[lane];
        nearer = true;
    }
    return nearer;
}

void walk_rays(const BvhNode* nodes, uint32_t root, const TrianglePacket* packets, const RayProbe* along,
               FloatRay* rays, const float* limits, uint32_t count, bool together) {
    PacketLimits of_all(count, [&](uint32_t ray) { return limits[ray]; });
    const auto meet_one = [&](uint32_t ray, uint32_t number) {
        if (!meet(packets[number], rays[ray])) return;
        of_all.limits[ray] = along[ray].limit(static_cast<double>(rays[ray].t));
    };
    const auto probe_of = [&](uint32_t ray) -> const RayProbe& { return along[ray]; };
    const auto prefetch_of = [&](uint32_t number) __attribute__((always_inline)) {
        prefetch_range(packets + number, sizeof(TrianglePacket));
    };
    if (together) {
        PacketTest packet(probe_of, of_all.limits, count);
        const auto visit = [&](uint32_t group, uint32_t set, uint32_t number) {
            for (; set != 0; set &= set - 1) meet_one(8 * group + static_cast<uint32_t>(__builtin_ctz(set)), number);
        };
        if (traverse_packet(
                nodes, root, packet, count, visit, [] {}, prefetch_of))
            return;
        limits = of_all.limits;
    }
    const auto visit = [&](const uint32_t* numbers, const uint32_t* items, uint32_t size, float* new_limits) {
        for (uint32_t k = 0; k < size; ++k) {
            meet_one(numbers[k], items[k]);
            new_limits[k] = of_all.limits[numbers[k]];
        }
        return (1u << size) - 1;
    };
    traverse_interleaved<ClosestHit, RayTest>(nodes, root, probe_of, limits, count, visit, prefetch_of);
}

}  // namespace

extern const FloatKernels float_kernels{walk_rays};

}  // namespace gphys::GPHYS_ISA

#include "float_kernels.h"

#include "octree/octree_many.h"

namespace gphys::GPHYS_ISA {

namespace {

/// Moeller and Trumbore 1997, for eight triangles. True if one of them is nearer than what the ray has.
bool meet(const TrianglePacket& packet, FloatRay& ray) {
    Float8 a[3], ab[3], ac[3], d[3];
    for (int k = 0; k < 3; ++k) {
        const Float8 corner = load(packet.corner[0][k]);
        ab[k] = load(packet.corner[1][k]) - corner;
        ac[k] = load(packet.corner[2][k]) - corner;
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

void walk_rays(const OctreeNode* nodes, uint32_t root, const TrianglePacket* packets, const RayProbe* along,
               FloatRay* rays, float* limits, uint32_t count, bool together) {
    rays_at_once(
        nodes, root, [&](uint32_t ray) -> const RayProbe& { return along[ray]; }, limits, count, together,
        one_by_one([&](uint32_t ray, uint32_t number) {
            if (meet(packets[number], rays[ray])) limits[ray] = along[ray].limit(static_cast<double>(rays[ray].t));
            return limits[ray];
        }),
        [&](uint32_t number) { fetch_ahead(packets + number, sizeof(TrianglePacket)); });
}

}  // namespace

extern const FloatKernels float_kernels{walk_rays};

}  // namespace gphys::GPHYS_ISA

#include "scene/scene_kernels.h"

#include "foundation/simd.h"

namespace gphys::GPHYS_ISA {

namespace {

/// The "no" of QuickRay::verdict for a placed box, for eight rays: the same margins, and a matrix in
/// place of a quaternion, whose products take fewer roundings.
uint32_t may_meet(const RayLanes& rays, uint32_t first, const BoxLanes& box) {
    Float8 from[3], along[3];
    for (int k = 0; k < 3; ++k) {
        from[k] = narrowed_differences(rays.origin[k] + first, box.center[k]);
        along[k] = load(rays.direction[k] + first);
    }
    const Float8 reach = abs(from[0]) + abs(from[1]) + abs(from[2]) + splat(box.half_sum);
    const Float8 margin =
        (reach * splat(float_slack) + (load(rays.origin_slack + first) + splat(box.slack))) * splat(box.unit);
    const Float8 speed_margin = load(rays.direction_slack + first) * splat(box.unit), end = load(rays.end + first);
    const Float8 zero = splat(0);
    Float8 near[3], far[3], slow[3], fast[3];
    Mask8 meets = zero <= zero;
    for (int k = 0; k < 3; ++k) {
        const auto in_axes = [&](const Float8(&v)[3]) {
            return v[0] * splat(box.axes[k][0]) + v[1] * splat(box.axes[k][1]) + v[2] * splat(box.axes[k][2]);
        };
        const Float8 height = in_axes(from), climb = in_axes(along), speed = abs(climb);
        const Float8 to_center = choose(zero <= climb, zero - height, height);
        const Float8 half = splat(box.half[k]) + margin;
        slow[k] = max(speed - speed_margin, zero);
        fast[k] = speed + speed_margin;
        near[k] = to_center - half;
        far[k] = to_center + half;
        meets = meets & (zero <= far[k]) & (near[k] <= end * fast[k]);
    }
    for (int k = 0; k < 3; ++k) {
        for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
            meets = meets & (near[k] * slow[other] <= far[other] * fast[k]);
        }
    }
    return bits(meets);
}

struct Vector8 {
    Float8 x, y, z;
};
Vector8 operator+(const Vector8& a, const Vector8& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector8 operator-(const Vector8& a, const Vector8& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector8 operator*(Float8 s, const Vector8& a) { return {a.x * s, a.y * s, a.z * s}; }
Vector8 abs(const Vector8& a) { return {abs(a.x), abs(a.y), abs(a.z)}; }
Vector8 splat3(const float (&v)[3]) { return {splat(v[0]), splat(v[1]), splat(v[2])}; }
Float8 sum(const Vector8& a) { return a.x + a.y + a.z; }
Float8 dot(const Vector8& a, const Vector8& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector8 cross(const Vector8& a, const Vector8& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The squared length of what remains of the components above `less`.
Float8 square_beyond(const Vector8& a, Float8 less) {
    const Float8 zero = splat(0), x = max(a.x - less, zero), y = max(a.y - less, zero), z = max(a.z - less, zero);
    return x * x + y * y + z * z;
}

/// QuickPoint of the placed boxes: the same numbers and margins.
BoxVerdicts boxes_near(const float* quads, const uint32_t* first_quad, const BallLanes& ball) {
    const auto quad = [&](uint32_t number) {
        uint32_t index[8];
        for (int i = 0; i < 8; ++i) index[i] = first_quad[i] + number;
        return load_quads(quads, index);
    };
    const Quads8 a = quad(0), b = quad(1), c = quad(2), d = quad(3);
    const Vector8 position{a.x, a.y, a.z}, u{a.w, b.x, b.y}, low{c.z, c.w, d.x}, high{d.y, d.z, d.w};
    const Float8 w = b.z, scale = b.w;
    const Mask8 centered = equal_bits(splat(0) - low.x, high.x) & equal_bits(splat(0) - low.y, high.y) &
                           equal_bits(splat(0) - low.z, high.z);

    const Vector8 half = (splat(0.5f) * scale) * (high - low);
    const Vector8 from = splat3(ball.head) - position + splat3(ball.rest);
    const Float8 half_sum = sum(half), sums = sum(abs(position)) + half_sum;
    const Float8 margin = splat(float_slack) * (sum(abs(from)) + half_sum) + splat(static_cast<float>(slack)) * sums +
                          splat(ball.slack) + splat(static_cast<float>(smallest_slack)) * (splat(1) + scale);
    const Float8 uu = dot(u, u), ww = w * w, unit = ww + uu;
    const Vector8 turned = (ww - uu) * from + splat(2) * (dot(u, from) * u + w * cross(from, u));
    const Vector8 outside = abs(turned) - unit * half;
    const Float8 scaled_margin = margin * unit, far = splat(ball.reach) * unit, limit = far * far;
    const Float8 at_least = square_beyond(outside, scaled_margin),
                 at_most = square_beyond(outside, splat(0) - scaled_margin);
    const Float8 above = limit * splat(1 + square_slack) + splat(smallest_square);
    const uint32_t no = bits(at_least <= above) ^ 0xff;
    const uint32_t yes = bits(limit * splat(1 - square_slack) <= at_most + splat(smallest_square)) ^ 0xff;
    const uint32_t known = bits(centered);
    return {no & known, yes & known};
}

}  // namespace

extern const SceneKernels scene_kernels{may_meet, boxes_near};

}  // namespace gphys::GPHYS_ISA

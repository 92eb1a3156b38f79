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

}  // namespace

extern const SceneKernels scene_kernels{may_meet};

}  // namespace gphys::GPHYS_ISA

// What many rays ask of many models, and a ball of many boxes, once for each instruction set.
#pragma once

#include "scene/eight_models.h"
#include "scene/quick_shape.h"

namespace gphys {

/// One of many rays: what QuickRay (quick_tests.h) knows of it, in fours so that eight are read at once.
struct alignas(16) RayQuads {
    float head[3], end;                   // of the origin, as those of SplitPoint; t_max, see ray_end
    float rest[3], origin_slack;          // of each coordinate
    float direction[3], direction_slack;  // in parts of its largest component; of each
};

/// How far it is to t_max, in units of a direction's largest component.
inline float ray_end(double t_max, Vec3 direction) {
    return static_cast<float>(std::min(t_max * std::max(max_component(abs(direction)), least_speed), most_end));
}

/// A ball: what QuickPoint (quick_tests.h) knows of it.
struct BallLanes {
    float head[3], rest[3];  // of the centre, as those of SplitPoint
    float slack, reach;

    BallLanes(Vec3 center, double radius) : reach(static_cast<float>(std::min(radius, most_reach))) {
        const SplitPoint split(center);
        for (int k = 0; k < 3; ++k) {
            head[k] = split.head[k];
            rest[k] = split.rest[k];
        }
        slack = static_cast<float>(gphys::slack * sum(abs(center)));
    }
};

struct SceneKernels {
    /// What QuickRay knows of many rays. `count` is at least 1; what is written is rounded up to a multiple
    /// of eight.
    void (*ray_quads)(const Ray* rays, uint32_t count, RayQuads* to);
    // Whether each ray meets its model until its end, all of which are of one type.
    Verdicts8 (*rays_and_spheres)(const RaysAndModels<RayQuads>& pairs);
    Verdicts8 (*rays_and_aabbs)(const RaysAndModels<RayQuads>& pairs);
    Verdicts8 (*rays_and_obbs)(const RaysAndModels<RayQuads>& pairs);
    /// Of eight models that are Aabbs; those that are not about their origins stay open. Model k has four
    /// quads from first_quad[k] on: its transform, two words of no interest, min and max.
    Verdicts8 (*boxes_near)(const float* quads, const uint32_t* first_quad, const BallLanes& ball);
};

GPHYS_DECLARE_KERNELS(SceneKernels, scene_kernels)

}  // namespace gphys

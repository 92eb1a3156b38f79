// Conservative tests of many rays and models, and of a sphere and many boxes, for each instruction set.
#pragma once

#include "scene/conservative_shape.h"
#include "scene/eight_models.h"

namespace gphys {

/// The data of ConservativeRay (conservative_tests.h), in groups of four so that eight rays are loaded by
/// transpositions.
struct alignas(16) RayQuads {
    float head[3], end;                   // of the origin, as those of SplitPoint; t_max, see ray_end
    float rest[3], origin_slack;          // of each coordinate
    float direction[3], direction_slack;  // in parts of its largest component; of each
};

/// How far it is to t_max, in units of a direction's largest component.
inline float ray_end(double t_max, Vec3 direction) {
    return static_cast<float>(std::min(t_max * std::max(max_component(abs(direction)), least_speed), most_end));
}

/// A point that models are seen from, as SplitPoint (conservative_shape.h).
struct SeenFrom {
    float head[3], rest[3];
    float slack;

    /// `size` is that of what is around the point.
    SeenFrom(Vec3 point, double size) : slack(static_cast<float>(gphys::slack * (sum(abs(point)) + size))) {
        const SplitPoint split(point);
        for (int k = 0; k < 3; ++k) {
            head[k] = split.head[k];
            rest[k] = split.rest[k];
        }
    }
};

/// A ball: what ConservativePoint (conservative_tests.h) knows of it.
struct BallLanes {
    SeenFrom center;
    float reach;

    BallLanes(Vec3 c, double radius) : center(c, 0), reach(static_cast<float>(std::min(radius, most_reach))) {}
};

/// A box that is parallel to the axes of the world: what ConservativeBlock knows of it.
struct BlockLanes {
    SeenFrom center;
    float half[3];

    explicit BlockLanes(const Aabb& box) : center((box.min + box.max) * 0.5, sum(box.max - box.min)) {
        const Vec3 sizes = (box.max - box.min) * 0.5;
        for (int k = 0; k < 3; ++k) half[k] = static_cast<float>(sizes[k]);
    }
};

struct SceneKernels {
    /// What ConservativeRay knows of many rays. `count` is at least 1; what is written is rounded up to a multiple
    /// of eight.
    void (*ray_quads)(const Ray* rays, uint32_t count, RayQuads* to);
    // Whether each ray meets its model until its end, all of which are of one type.
    TriStates8 (*rays_and_spheres)(const RaysAndModels<RayQuads>& pairs);
    TriStates8 (*rays_and_aabbs)(const RaysAndModels<RayQuads>& pairs);
    TriStates8 (*rays_and_obbs)(const RaysAndModels<RayQuads>& pairs);
    // Whether eight models that are Aabbs meet a query; those that are not about their origins stay open. Model k has
    // four quads from first_quad[k] on: its transform, two words of no interest, min and max.
    TriStates8 (*boxes_near)(const float* quads, const uint32_t* first_quad, const BallLanes& ball);
    TriStates8 (*boxes_in_block)(const float* quads, const uint32_t* first_quad, const BlockLanes& block);
};

GPHYS_DECLARE_KERNELS(SceneKernels, scene_kernels)

}  // namespace gphys

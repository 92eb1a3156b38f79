// The conservative tests of conservative_tests.h for eight models at a time, for each instruction set: eight pairs of a
// ray and a model, or one sphere or box against eight boxes.
#pragma once

#include "scene/conservative_shape.h"
#include "scene/eight_models.h"

namespace gphys {

/// The data of ConservativeRay, in groups of four floats, so that kernels load eight rays by transpositions.
struct alignas(16) RayQuads {
    float head[3], end;                   // origin: SplitPoint::head; end: ray_end()
    float rest[3], origin_slack;          // origin: SplitPoint::rest; error bound of each coordinate
    float direction[3], direction_slack;  // divided by its largest component; error bound of each component
};

/// t_max times the direction's largest component.
inline float ray_end(double t_max, Vec3 direction) {
    return static_cast<float>(std::min(t_max * std::max(max_component(abs(direction)), least_speed), most_end));
}

/// The centre of a query shape, as SplitPoint (conservative_shape.h).
struct QueryPoint {
    float head[3], rest[3];
    float slack;

    /// `size`: extent of the query shape around the point.
    QueryPoint(Vec3 point, double size) : slack(static_cast<float>(gphys::slack * (sum(abs(point)) + size))) {
        const SplitPoint split(point);
        for (int k = 0; k < 3; ++k) {
            head[k] = split.head[k];
            rest[k] = split.rest[k];
        }
    }
};

/// The data of ConservativePoint for a sphere.
struct SphereQueryLanes {
    QueryPoint center;
    float reach;

    SphereQueryLanes(Vec3 c, double radius) : center(c, 0), reach(static_cast<float>(std::min(radius, most_reach))) {}
};

/// The data of ConservativeBoxQuery for an AABB.
struct BoxQueryLanes {
    QueryPoint center;
    float half[3];

    explicit BoxQueryLanes(const Aabb& box) : center((box.min + box.max) * 0.5, sum(box.max - box.min)) {
        const Vec3 sizes = (box.max - box.min) * 0.5;
        for (int k = 0; k < 3; ++k) half[k] = static_cast<float>(sizes[k]);
    }
};

struct SceneKernels {
    /// The RayQuads of `count` >= 1 rays. Writes up to the next multiple of eight.
    void (*ray_quads)(const Ray* rays, uint32_t count, RayQuads* to);
    // ConservativeRay for eight pairs. All models of a call are of one type.
    TriStates8 (*rays_and_spheres)(const RaysAndModels<RayQuads>& pairs);
    TriStates8 (*rays_and_aabbs)(const RaysAndModels<RayQuads>& pairs);
    TriStates8 (*rays_and_obbs)(const RaysAndModels<RayQuads>& pairs);
    // Overlap of a query with eight Aabbs; boxes not centred on their origins stay undecided. Model k is the four quads
    // from first_quad[k] on: transform, two unused words, min, max.
    TriStates8 (*boxes_and_sphere)(const float* quads, const uint32_t* first_quad, const SphereQueryLanes& ball);
    TriStates8 (*boxes_and_box)(const float* quads, const uint32_t* first_quad, const BoxQueryLanes& block);
};

GPHYS_DECLARE_KERNELS(SceneKernels, scene_kernels)

}  // namespace gphys

// What many rays that go much the same way ask of a box, and a ball of many boxes, once for each
// instruction set.
#pragma once

#include "foundation/isa.h"
#include "scene/quick_shape.h"

namespace gphys {

/// Rays side by side: what QuickRay (quick_tests.h) knows of each.
struct RayLanes {
    static constexpr uint32_t most = 64;
    // Eight rays may begin at any; behind the last there are zeros.
    static constexpr uint32_t size = most + 8;

    double origin[3][size];
    float direction[3][size];     // in parts of its largest component
    float direction_slack[size];  // of each component
    float origin_slack[size];     // of each coordinate
    float end[size];              // t_max times the largest component of the direction
};

/// A box with axes of the length `unit`, placed in the world.
struct BoxLanes {
    double center[3];
    float axes[3][3], half[3];
    float half_sum, unit, slack;

    explicit BoxLanes(const QuickBox& box)
        : center{box.center.x, box.center.y, box.center.z},
          unit(static_cast<float>(box.unit)),
          slack(static_cast<float>(gphys::slack * box.magnitude + smallest_slack)) {
        const Vec3 columns[3] = {box.axes.x, box.axes.y, box.axes.z};
        half_sum = static_cast<float>(sum(box.half));
        for (int i = 0; i < 3; ++i) {
            half[i] = static_cast<float>(box.half[i] * box.unit);
            for (int k = 0; k < 3; ++k) axes[i][k] = static_cast<float>(columns[i][k]);
        }
    }
};

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

/// Which of eight boxes certainly do not, or certainly do, meet a ball; the others are open.
struct BoxVerdicts {
    uint32_t no, yes;
};

struct SceneKernels {
    /// Bit k is set unless ray first + k, k < 8, certainly misses the box until its end.
    uint32_t (*may_meet)(const RayLanes& rays, uint32_t first, const BoxLanes& box);
    /// Of eight models that are Aabbs; those that are not about their origins stay open. Model k has four
    /// quads from first_quad[k] on: its transform, two words of no interest, min and max.
    BoxVerdicts (*boxes_near)(const float* quads, const uint32_t* first_quad, const BallLanes& ball);
};

GPHYS_DECLARE_KERNELS(SceneKernels, scene_kernels)

}  // namespace gphys

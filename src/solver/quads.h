// Positions and velocities in the layout of the cloth kernels: four floats for each particle.
#pragma once

#include "foundation/math.h"

namespace gphys {

inline Vec3 get(const float* quad) { return {quad[0], quad[1], quad[2]}; }
inline void put(float* quad, Vec3 v) {
    for (int k = 0; k < 3; ++k) quad[k] = static_cast<float>(v[k]);
}

/// Particles of cloth stop at the border of the world and at three times the speed of light (cloth_kernels.cpp).
constexpr double farthest_in_cloth = 2e15, fastest_in_cloth = 1e9;
inline void put(float* quad, Vec3 v, double limit) {
    for (int k = 0; k < 3; ++k) quad[k] = to_float(v[k], limit);
}

}  // namespace gphys

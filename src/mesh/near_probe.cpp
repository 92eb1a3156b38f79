// Rounds a ball and a half-space to float (near_probe.h).
#include "mesh/near_probe.h"

namespace gphys {
namespace {

// Clamp: larger coordinates are far from every mesh.
constexpr double farthest = 1e30;
// Radii are enlarged by this factor, which exceeds the rounding of positions in the mesh.
constexpr double widening = 1 + 0x1p-20;

}  // namespace

NearProbe::NearProbe(Vec3 center, double ball_radius) {
    shrink(ball_radius);
    for (int k = 0; k < 3; ++k) {
        base[k] = to_float(center[k], farthest);
        offset[k] = to_float(center[k] - base[k], farthest);
    }
}

void NearProbe::shrink(double ball_radius) { radius = to_float(ball_radius * widening, farthest); }

HalfSpaceProbe::HalfSpaceProbe(Vec3 unit, double height) {
    for (int k = 0; k < 3; ++k) normal[k] = to_float(unit[k], farthest);
    const double rounding = 0x1p-23 * std::fabs(height);
    lowest = to_float(height - rounding, farthest);
    highest = to_float(height + rounding, farthest);
}

}  // namespace gphys

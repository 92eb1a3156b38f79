// Rounds a ray to float, with the error bounds of triangle_setup.h (triangle_probe.h).
#include "mesh/triangle_probe.h"

#include "mesh/triangle_setup.h"

namespace gphys {
namespace {

/// The interface of Shear, for a ray that is sheared already.
struct KnownShear {
    explicit KnownShear(const ShearedRay& r) : ray(r), moves(r.speed != 0), speed(r.speed), sx(r.sx), sy(r.sy) {}

    void turn(const Vec3& v, double (&to)[3]) const {
        to[0] = v[ray.kx];
        to[1] = v[ray.ky];
        to[2] = v[ray.kz];
    }

    const ShearedRay& ray;
    bool moves;
    double speed, sx, sy;
};

}  // namespace

TriangleProbe::TriangleProbe(const ShearedRay& ray, const RayProbe& along, const RootBounds& root)
    : axis{ray.kx, ray.ky, ray.kz} {
    const Vec3 begin{along.begin[0], along.begin[1], along.begin[2]};
    const TriangleSetup<Vec3> setup(KnownShear(ray), begin, along.path.slack, along.may_reject(), root);
    for (int k = 0; k < 3; ++k) origin[k] = static_cast<float>(setup.origin[k]);
    across = {{static_cast<float>(setup.slope_x), static_cast<float>(setup.slope_y)},
              {static_cast<float>(setup.error_slope_x), static_cast<float>(setup.error_slope_y)}};
    const float ahead = static_cast<float>(setup.ahead);
    rest = {ahead, 1 - ahead, static_cast<float>(setup.margin), static_cast<float>(setup.error)};
}

}  // namespace gphys

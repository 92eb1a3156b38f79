// Rounds a ray to float, with the error bounds of triangle_setup.h (triangle_probe.h).
#include "mesh/triangle_probe.h"

#include "mesh/triangle_setup.h"

namespace gphys {

namespace {

/// The interface of Shear, for a ray that is sheared already.
struct KnownShear {
    explicit KnownShear(const ShearedRay& r) : ray(r), moves(r.direction[r.kz] != 0), sx(r.sx), sy(r.sy) {}

    double x(const double (&v)[3]) const { return v[ray.kx]; }
    double y(const double (&v)[3]) const { return v[ray.ky]; }
    double z(const double (&v)[3]) const { return v[ray.kz]; }

    const ShearedRay& ray;
    bool moves;
    double sx, sy;
};

}  // namespace

TriangleProbe::TriangleProbe(const ShearedRay& ray, const RayProbe& along, const RaysRoot& root)
    : axis{ray.kx, ray.ky, ray.kz} {
    const double direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    const TriangleSetup<double> setup(KnownShear(ray), direction, along.begin, along.course.slack, along.excludes(),
                                      root);
    for (int k = 0; k < 3; ++k) origin[k] = static_cast<float>(setup.origin[k]);
    across = {{static_cast<float>(setup.slope_x), static_cast<float>(setup.slope_y)},
              {static_cast<float>(setup.error_slope_x), static_cast<float>(setup.error_slope_y)}};
    const float ahead = static_cast<float>(setup.ahead);
    rest = {ahead, 1 - ahead, static_cast<float>(setup.margin), static_cast<float>(setup.error)};
}

}  // namespace gphys

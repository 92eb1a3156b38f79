#include "mesh/triangle_probe.h"

namespace gphys {

// The signs of three volumes tell whether a ray passes through a triangle (raycast_triangle.cpp).
// Here they are computed in float: x = X - sx Z and y = Y - sy Z, where X, Y, Z is a corner relative
// to where the ray begins, and then products like a.x b.y - a.y b.x.
//
// Let u = 2^-24, R the distance on an axis from the beginning to the furthest side of the root, and o
// how far the float origin is from the true one on that axis. Then X is off by at most o + u R, Z alike,
// the slope by u of itself, its product with Z by another u, and their difference by u (R + |sx| Rz):
//     ex = ox + 2 u R + |sx| (oz + 4 u Rz)
// and a little for the terms in u^2. Along the ray, ez = oz + u Rz: margin. Each axis has its own error,
// so that a mesh that is thin along one of them is not lost in the roundings of its length.
//
// A volume of coordinates up to rx and ry (as computed) is then off by 2 (rx ey + ry ex) + 2 ex ey for
// the coordinates and by 4 u rx ry for its own three roundings. As u rx is at most ex / 2 (1 + 2 u), that
// is another rx ey + ry ex: 3.1 (rx ey + ry ex) + 3 ex ey has room for what remains and for computing it.
//
// Numbers below 2^-126 may be flushed to zero by the host: each coordinate may be off by four such
// flushes and Z times the slope's, each volume by three more.
//
// Nothing overflows: the root is within 2^53 of the beginning, coordinates stay below 2^55 and
// volumes below 2^111.
TriangleProbe::TriangleProbe(const ShearedRay& ray, const RayProbe& along, const Box& root)
    : axis{ray.kx, ray.ky, ray.kz}, ahead(ray.direction[ray.kz] >= 0), behind(1 - ahead) {
    if (ray.direction[ray.kz] == 0 || !along.excludes()) {  // nothing to shear along, or beyond floats
        for (int k = 0; k < 3; ++k) origin[k] = 0;
        slope[0] = slope[1] = 0;
        margin = error = 0x1p120f;
        error_slope[0] = error_slope[1] = 0;
        return;
    }
    double off[3], reach[3];  // on the ray's axes
    for (int k = 0; k < 3; ++k) {
        const double begin = along.begin[axis[k]];
        origin[k] = static_cast<float>(begin);
        off[k] = std::fabs(begin - origin[k]) + along.slack();
        reach[k] = std::max(root.max[axis[k]] - begin, begin - root.min[axis[k]]);
    }
    slope[0] = static_cast<float>(ray.sx);
    slope[1] = static_cast<float>(ray.sy);
    constexpr double u = 0x1p-24, flushed = 0x1p-124;
    const auto across = [&](int k, double per_step) {
        return 1.01 * (off[k] + 2 * u * reach[k] + std::fabs(per_step) * (off[2] + 4 * u * reach[2])) +
               flushed * (1 + reach[2]);
    };
    const double error_x = across(0, ray.sx), error_y = across(1, ray.sy);
    margin = static_cast<float>((1.01 * (off[2] + u * reach[2]) + flushed) * (1 + 2 * u));
    error_slope[0] = static_cast<float>(3.1 * error_y);
    error_slope[1] = static_cast<float>(3.1 * error_x);
    error = static_cast<float>(3 * error_x * error_y + flushed);
}

}  // namespace gphys

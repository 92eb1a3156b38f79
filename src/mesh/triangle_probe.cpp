#include "mesh/triangle_probe.h"

namespace gphys {

// The signs of three volumes tell whether a ray passes through a triangle (raycast_triangle.cpp).
// Here they are computed in float: x = X - sx Z and y = Y - sy Z, where X, Y, Z is a corner relative
// to where the ray begins, and then products like a.x b.y - a.y b.x.
//
// Let u = 2^-24, R the distance on any axis from the beginning to the furthest side of the root, and
// o how far the float origin is from the true one. Then X and Z are off by at most o + u R each, the
// slope, at most 1, by u, its product with Z by another u R, and their difference by 2 u R:
//     e = 2 o + 6 u R
// and a little for the terms in u^2: margin. Along the ray e bounds the error of Z.
//
// A volume of coordinates up to r (as computed; in truth up to r + e) is then off by
// 4 r e + 2 e^2 for the coordinates and by 4 u r^2 for its own three roundings. As r < 2 R + e, that
// is at most 1.4 r e for most of them: 6 e (r + e) has room for what remains and for computing it.
//
// Numbers below 2^-126 may be flushed to zero by the host: each coordinate may be off by four such
// flushes, each volume by three more.
//
// Nothing overflows: the root is within 2^53 of the beginning, coordinates stay below 2^55 and
// volumes below 2^111.
TriangleProbe::TriangleProbe(const ShearedRay& ray, const RayProbe& along, const Box& root)
    : axis{ray.kx, ray.ky, ray.kz}, forward(ray.direction[ray.kz] >= 0) {
    if (ray.direction[ray.kz] == 0 || !along.excludes()) {  // nothing to shear along, or beyond floats
        for (int k = 0; k < 3; ++k) origin[k] = 0;
        slope[0] = slope[1] = 0;
        margin = error = 0x1p120f;
        error_slope = 0;
        return;
    }
    double off = 0, reach = 0;
    float rounded[3];
    for (int k = 0; k < 3; ++k) {
        const double begin = along.begin[k];
        rounded[k] = static_cast<float>(begin);
        off = std::max(off, std::fabs(begin - rounded[k]));
        reach = std::max(reach, std::max(root.max[k] - begin, begin - root.min[k]));
    }
    for (int k = 0; k < 3; ++k) origin[k] = rounded[axis[k]];
    slope[0] = static_cast<float>(ray.sx);
    slope[1] = static_cast<float>(ray.sy);
    constexpr double u = 0x1p-24, flushed = 0x1p-124;
    const double e = 2.01 * (off + along.slack()) + 6.1 * u * reach + flushed;
    margin = static_cast<float>(e * (1 + 2 * u));
    error_slope = static_cast<float>(6 * e);
    error = static_cast<float>(6 * e * e + flushed);
}

}  // namespace gphys

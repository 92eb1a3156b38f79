// Work on which float arithmetic guesses, with answers that are known: from whole numbers, or because
// a closed surface cannot be left.
#pragma once

#include "workload.h"

namespace bench {

/// Rays that must hit, or of which it is known whether they do.
struct HardRays {
    std::vector<gphys_ray> rays;
    std::vector<bool> hits;
};

/// From inside a closed mesh around the origin of `placed`, through its edges and vertices.
HardRays rays_out_of(const Triangles& mesh, gphys_vec3 inside, uint32_t count);
/// x -> offset + scale * x for each axis.
Triangles placed(Triangles mesh, gphys_vec3 offset, gphys_vec3 scale);

/// Along the diagonals of a grid of whole numbers, at a box of whole numbers: faces, edges and corners.
gphys_obb grid_box();
HardRays rays_at_grid_box(uint32_t count);
/// Along z from a million metres, past the edge of the unit sphere by an ulp or two.
gphys_sphere tangent_sphere();
HardRays rays_at_tangent_sphere(uint32_t count);

/// Spheres that touch a corner or an edge of the grid box, or miss it by an ulp, and how many touch.
std::vector<gphys_sphere> spheres_at_grid_box(uint32_t count, uint64_t& touching);

}  // namespace bench

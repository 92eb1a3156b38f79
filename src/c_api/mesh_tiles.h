// Batches of rays against one mesh, in tiles of coherent rays.
#pragma once

#include "c_api/shape_input.h"
#include "foundation/image_tiles.h"
#include "foundation/strided.h"
#include "mesh/mesh.h"

namespace gphys {

/// Calls cast(rays, items, size) for the rays of each tile and their indices. Prefetches the input and output of the
/// next tile.
template <class Out, class Cast>
void cast_at_mesh(const Strided<gphys_ray>& ray, uint32_t count, const StridedOut<Out>& out, const Cast& cast) {
    static_assert(ImageTiles::most <= Mesh::rays_at_once);
    const ImageTiles tiles(ray.beginnings<float>(), ray_coordinates, count);
    tiles.for_each(0, tiles.count(), prefetch_elements(ray, out), [&](const uint32_t* items, uint32_t size) {
        const gphys_ray* rays[ImageTiles::most];
        for (uint32_t k = 0; k < size; ++k) rays[k] = &ray[items[k]];
        cast(rays, items, size);
    });
}

}  // namespace gphys

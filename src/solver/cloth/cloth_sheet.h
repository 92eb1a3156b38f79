// The surface of cloth: its triangles, and its flat shape.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct ClothSheet {
    explicit ClothSheet(std::pmr::memory_resource* memory) : triangles(memory), rest_position(memory) {}

    Vector<uint32_t> triangles;  // for drawing, wind and volumes
    /// The rest positions of the particles of a flat sheet. No two particles can be farther apart than in these.
    /// Empty for other bodies and for torn sheets.
    Vector<Vec3> rest_position;
};

}  // namespace gphys

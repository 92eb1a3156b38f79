// The desc of meshes, for all ways of creating them.
#pragma once

#include <cstddef>

#include "c_api/api.h"

namespace gphys {

constexpr size_t mesh_desc_size = offsetof(gphys_mesh_desc, deformable);  // of release 1.0

inline gphys_status read_mesh_desc(const gphys_mesh_desc* from, gphys_mesh_desc& desc) {
    GPHYS_TRY(read_desc(from, desc, mesh_desc_size));
    GPHYS_TRY(check_allocator(desc.allocator));
    GPHYS_TRY(check_bool("desc.deformable", desc.deformable));
    GPHYS_REQUIRE_IN_RANGE(desc.reserved == 0, "desc.reserved", desc.reserved, "0");
    return GPHYS_OK;
}

}  // namespace gphys

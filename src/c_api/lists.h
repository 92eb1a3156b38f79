// The (out, capacity, out_total) lists of the public header.
#pragma once

#include "bvh/bvh8.h"
#include "c_api/api.h"

namespace gphys {

inline gphys_status check_list(const void* out, uint32_t capacity, const uint32_t* out_total) {
    GPHYS_REQUIRE(capacity == 0 || out, "the output array is null");
    GPHYS_REQUIRE(out_total, "out_total is null");
    return GPHYS_OK;
}

inline gphys_status listed(uint32_t total, uint32_t capacity, uint32_t* out_total) {
    *out_total = total;
    return total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK;
}

/// Boxes of an BVH or of a mesh's, parents first.
template <class Tree>
gphys_status copy_boxes(const Tree& tree, gphys_octree_box* out, uint32_t capacity, uint32_t* out_total) {
    GPHYS_TRY(check_list(out, capacity, out_total));
    uint32_t total = 0;
    tree.for_each_box([&](const gphys_octree_box& box) {
        if (total < capacity) out[total] = box;
        ++total;
    });
    return listed(total, capacity, out_total);
}

}  // namespace gphys

// The (out, capacity, out_total) lists of the public header: a null `out` with capacity 0 only counts.
#pragma once

#include "bvh/bvh8.h"
#include "c_api/api.h"

namespace gphys {

inline gphys_status check_list(const char* out_name, const void* out, uint32_t capacity, const uint32_t* out_total) {
    if (capacity != 0) GPHYS_TRY(check_pointers(out_name, out));
    GPHYS_REQUIRE_POINTERS(out_total);
    return GPHYS_OK;
}

inline gphys_status listed(uint32_t total, uint32_t capacity, uint32_t* out_total) {
    *out_total = total;
    return total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK;
}

/// The boxes of a BVH, parents first.
template <class Tree>
gphys_status copy_boxes(const Tree& tree, gphys_octree_box* out, uint32_t capacity, uint32_t* out_total) {
    GPHYS_TRY(check_list("out_boxes", out, capacity, out_total));
    uint32_t total = 0;
    tree.for_each_box([&](const gphys_octree_box& box) {
        if (total < capacity) out[total] = box;
        ++total;
    });
    return listed(total, capacity, out_total);
}

}  // namespace gphys

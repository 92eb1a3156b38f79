// The (out, capacity, out_total) lists of the public header: a null `out` with capacity 0 only counts.
#pragma once

#include "bvh/bvh8.h"
#include "c_api/api.h"
#include "foundation/memory.h"
#include "foundation/results.h"

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

/// The smallest of what add_all(Smallest) adds; by number without an order.
template <class Order = void, class T, class AddAll>
gphys_status list_smallest(const char* out_name, T* out, uint32_t capacity, uint32_t* out_total,
                           const AddAll& add_all) {
    GPHYS_TRY(check_list(out_name, out, capacity, out_total));
    using Less = std::conditional_t<std::is_void_v<Order>, std::less<T>, Order>;
    Smallest<T, Less> list(out, capacity);
    add_all(list);
    return listed(list.finish(), capacity, out_total);
}

/// The first elements of a vector.
template <class T>
gphys_status list_copy(const Vector<T>& values, const char* out_name, T* out, uint32_t capacity, uint32_t* out_total) {
    GPHYS_TRY(check_list(out_name, out, capacity, out_total));
    const uint32_t total = static_cast<uint32_t>(values.size());
    std::copy_n(values.begin(), std::min(total, capacity), out);
    return listed(total, capacity, out_total);
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

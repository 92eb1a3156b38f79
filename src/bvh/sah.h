// Splits of a range of boxes: by the surface area heuristic (SAH, Goldsmith and Salmon 1987; MacDonald and Booth 1990)
// or into halves. All trees are built with them.
#pragma once

#include "bvh/box8.h"

namespace gphys {

/// Two registers of four lanes, by which boxes are read and moved.
struct alignas(16) BoxedItem {
    Box box;
    uint32_t item;
};

/// The most items of a leaf: kernels test eight boxes at once.
constexpr uint32_t leaf_size = 8;

/// Half the surface area; 0 if the box is empty.
inline double half_area(const Box& box) {
    if (box.min[0] > box.max[0]) return 0;
    const double x = double{box.max[0]} - box.min[0], y = double{box.max[1]} - box.min[1],
                 z = double{box.max[2]} - box.min[2];
    return x * y + y * z + z * x;
}
Box union_of(const BoxedItem* first, const BoxedItem* last);

// Each reorders two or more items so that no part is empty, and returns the first item of the second part.

/// Split of least SAH cost: half area times the number of leaves that a part fills. `scratch` has space for all items
/// but one. Stable: the order within each part stays.
BoxedItem* split_by_cost(BoxedItem* first, BoxedItem* last, BoxedItem* scratch);
/// The same for up to split_few_size items, by comparing all allowed splits: bit i of `splits` allows i items in the
/// first part. `block` items cost as much as one.
constexpr int split_few_size = 64;
BoxedItem* split_few(BoxedItem* first, BoxedItem* last, uint64_t splits, int block);
/// Into halves of equal number, along the axis with the largest extent of the centres.
BoxedItem* split_by_count(BoxedItem* first, BoxedItem* last);

}  // namespace gphys

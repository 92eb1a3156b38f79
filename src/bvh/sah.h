// Boxes cut in two by the expected cost of the parts (surface area heuristic): what every tree here
// is built from.
#pragma once

#include "bvh/box8.h"

namespace gphys {

/// As wide as two registers of four lanes: boxes are read and moved by these.
struct alignas(16) BoxedItem {
    Box box;
    uint32_t item;
};

/// What a leaf of any tree holds at most: eight tests at the price of one.
constexpr uint32_t leaf_size = 8;

/// Half the surface; 0 if the box is empty.
inline double half_area(const Box& box) {
    if (box.min[0] > box.max[0]) return 0;
    const double x = double{box.max[0]} - box.min[0], y = double{box.max[1]} - box.min[1],
                 z = double{box.max[2]} - box.min[2];
    return x * y + y * z + z * x;
}
Box union_of(const BoxedItem* first, const BoxedItem* last);

// All put more than one item in order so that no part is empty, and return where the second begins.

/// Where the expected cost of both parts is least, a part being as many tests as it fills leaves.
/// `scratch` has room for all but one of the items; the order within each part stays.
BoxedItem* split_by_cost(BoxedItem* first, BoxedItem* last, BoxedItem* scratch);
/// The same for a few, comparing all cuts that `cuts` allows, bit i standing for that of i items
/// below, where `block` items cost as much as one.
constexpr int split_few_size = 64;
BoxedItem* split_few(BoxedItem* first, BoxedItem* last, uint64_t cuts, int block);
/// In equal number, along the axis on which the centres spread most.
BoxedItem* split_by_count(BoxedItem* first, BoxedItem* last);

}  // namespace gphys

// Partial rebuilds keep the quality of a changing BVH. Each call rebuilds a bounded part of the tree, so that its cost
// is in proportion to its changes. Only when the whole tree has degraded, it is rebuilt at once. The measure of quality
// is that of the SAH: the sum of the areas of all nodes. Tree rotations (Kopta et al., "Fast, effective BVH updates for
// animated scenes", 2012) improve a tree as well, but do not fill sparse leaves.
#include "bvh/bvh8.h"

namespace gphys {
namespace {

/// In large updates, one in so many moves pays for the rebuild of an item. With that, an update takes twice a refit on
/// average.
constexpr uint32_t moves_per_rebuilt_item = 8;
/// Growth of the area since the last build that starts partial rebuilds, and a complete one. Rays visit nodes in
/// proportion to the area. Items that move around stay near the first value. The second is reached when all items
/// change places at once; then a build costs less than the rays that it speeds up.
constexpr double partial_rebuild_growth = 1.05, full_rebuild_growth = 2;

Box intersection(const Box& a, const Box& b) {
    Box box;
    for (int k = 0; k < 3; ++k) {
        box.min[k] = std::max(a.min[k], b.min[k]);
        box.max[k] = std::min(a.max[k], b.max[k]);
        if (box.min[k] > box.max[k]) return {};
    }
    return box;
}

}  // namespace

/// Rebuilds the largest subtree around an item that has at most max_rebuilt_items, if enough was inserted into it.
/// Insertions leave leaves emptier than a build, and choose splits among fewer candidates.
void Bvh8::rebuild_around(uint32_t item) noexcept {
    uint32_t node = none;
    for (uint32_t above = nodes_[item_lane_[item] / 8].parent; above != none; above = nodes_[above].parent) {
        if (nodes_[above].items > max_rebuilt_items) break;
        node = above;
    }
    if (node == none || nodes_[node].added <= nodes_[node].items / items_per_addition) return;
    nodes_[node].added = 0;
    try {
        rebuild_children(node, (1u << nodes_[node].count) - 1);
    } catch (const std::bad_alloc&) {
        return;  // the tree is valid without the rebuild
    }
}

/// After a large update: rebuilds one child of the root together with the sibling that it overlaps most, so that items
/// that have crossed over change between them. Successive calls choose the children cyclically. If the child has more
/// items than half of the moves, the same is done one level down. So no call costs more than a few refits.
void Bvh8::rebuild_next_part(uint32_t changes) {
    const uint32_t limit = changes / 2;
    budget_ = std::min(budget_ + changes / moves_per_rebuilt_item, limit);
    NodeRef ref = root_;
    for (uint32_t path = cursor_; !is_leaf(ref); path /= 8) {
        const Node& node = nodes_[ref];
        const uint32_t first = path % node.count;
        const uint32_t count = items_below(nodes_[index_of(node.child[first])]);
        if (count > limit) {
            ref = node.child[first];
            continue;
        }
        uint32_t second = first, both = count;
        double most = 0;
        for (uint32_t i = 0; i < node.count; ++i) {
            if (i == first) continue;
            const double common =
                half_area(intersection(node.boxes.lane(static_cast<int>(first)), node.boxes.lane(static_cast<int>(i))));
            if (common <= most) continue;
            const uint32_t added = items_below(nodes_[index_of(node.child[i])]);
            if (count + added > limit) continue;
            most = common;
            second = i;
            both = count + added;
        }
        if (budget_ < both) return;
        rebuild_children(ref, 1u << first | 1u << second);
        budget_ -= both;
        ++cursor_;
        return;
    }
}

/// Whether the area has grown by `factor` since the last build: absolutely, or relative to the root's area. Both, since
/// a scene may contract or spread out, and a single item that flies off enlarges the root.
bool Bvh8::has_grown(double area, double factor) const {
    return area > factor * built_area_ || area * built_root_area_ > factor * built_area_ * half_area(bounds_);
}

/// Call after changes of the boxes of many items.
void Bvh8::refit_all(uint32_t changes) noexcept {
    cancel_renewal();
    if (root_ == none) return;
    const double area = refit();
    try {
        if (has_grown(area, full_rebuild_growth)) {
            rebuild();
        } else if (has_grown(area, partial_rebuild_growth)) {
            rebuild_next_part(changes);
        }
    } catch (const std::bad_alloc&) {
        return;  // the tree is valid without the rebuild
    }
}

}  // namespace gphys

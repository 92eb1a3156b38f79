// Keeping a changing BVH good: what has degraded is built again, a part at a time, so that each
// change pays a bounded price and none waits for a build of all that did not change.
#include "bvh/bvh8.h"

namespace gphys {

namespace {

/// A part of the tree is built again when one in so many of its items has been added since: each addition pays for two
/// items.
constexpr uint32_t renewed_when_added = 2;
/// Parts of more items are not, so that no change takes more than some ten microseconds: large enough for full leaves
/// and good cuts.
constexpr uint32_t most_renewed = 512;
/// While many move, one in so many pays for an item to be built again: twice a refit on average.
constexpr uint32_t moves_per_renewal = 8;
/// By how much the area has grown since the last build when parts are built again, and when all is.
/// Rays visit nodes in proportion to it. What only moves about stays below the first or not far above
/// it; the second is reached when all change places at once, and by then a build costs less than the
/// rays that it speeds up.
constexpr double renewed_growth = 1.05, rebuilt_growth = 2;

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

/// Around a change build the largest part again that is small enough, once enough has been added to it: insertions
/// leave leaves less full than a build does, and cut with less choice.
void Bvh8::renew_around(uint32_t item) noexcept {
    uint32_t node = none;
    for (uint32_t above = nodes_[place_of_[item] / 8].parent; above != none; above = nodes_[above].parent) {
        if (nodes_[above].items > most_renewed) break;
        node = above;
    }
    if (node == none || nodes_[node].added <= nodes_[node].items / renewed_when_added) return;
    nodes_[node].added = 0;
    try {
        rebuild_children(node, (1u << nodes_[node].count) - 1);
    } catch (const std::bad_alloc&) {
        return;  // an improvement less
    }
}

/// While many move: in turn, build a child of the root again together with the one that it overlaps
/// most, so that they exchange the items that have crossed over. If it has more items than half of
/// those that move, the same in it: no call costs more than a few refits.
void Bvh8::renew_in_turn(uint32_t changes) {
    const uint32_t limit = changes / 2;
    credit_ = std::min(credit_ + changes / moves_per_renewal, limit);
    NodeRef ref = root_;
    for (uint32_t turn = turn_; !is_leaf(ref); turn /= 8) {
        const Node& node = nodes_[ref];
        const uint32_t first = turn % node.count;
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
        if (credit_ < both) return;
        rebuild_children(ref, 1u << first | 1u << second);
        credit_ -= both;
        ++turn_;
        return;
    }
}

/// Whether the area is so much larger than after the last build, absolutely or against the root's: a
/// scene may draw together or spread out, and an item that flies off takes the root along.
bool Bvh8::grown(double area, double factor) const {
    return area > factor * built_area_ || area * built_root_area_ > factor * built_area_ * half_area(bounds_);
}

/// The boxes of many items have changed.
void Bvh8::refit_all(uint32_t changes) noexcept {
    if (root_ == none) return;
    const double area = refit();
    try {
        if (grown(area, rebuilt_growth)) {
            rebuild();
        } else if (grown(area, renewed_growth)) {
            renew_in_turn(changes);
        }
    } catch (const std::bad_alloc&) {
        return;  // an improvement less; the tree is as sound as before
    }
}

}  // namespace gphys

// Writes the nodes of a Bvh8 from a binary BVH, which has noted the cheapest way to collapse its levels (binary_bvh.h).
#pragma once

#include <algorithm>

#include "bvh/binary_bvh.h"
#include "bvh/bvh8.h"

namespace gphys {

/// Makes nodes from a BinaryBvh.
class Bvh8::Builder {
public:
    Builder(const Vector<BoxedItem>& items, const BinaryBvh& binary) : items_(items), binary_(binary) {}

    /// The items of a subtree, and where the binary BVH splits them.
    struct Range {
        uint32_t first, last, split_at;

        bool is_leaf() const { return split_at == BinaryBvh::none; }
        uint32_t size() const { return last - first; }
    };
    Range all() const { return {0, static_cast<uint32_t>(items_.size()), binary_.root()}; }

    /// Divides a range into at most `most` ranges at least cost. Exception: if the levels of nodes below could hardly
    /// hold the binary levels, three in one, it always splits the highest range, until there are `most` or all are
    /// leaves.
    uint32_t divide(const Range& all, uint32_t levels_below, Range* ranges, uint32_t most = 8) const {
        if ((binary_.height(all.split_at) + 1) / 3 + 1 <= levels_below) {
            return static_cast<uint32_t>(collect(all, most, ranges) - ranges);
        }
        uint32_t count = 1;
        ranges[0] = all;
        while (count < most) {
            Range* const highest = std::max_element(ranges, ranges + count, [this](const Range& a, const Range& b) {
                return binary_.height(a.split_at) < binary_.height(b.split_at);
            });
            if (highest->is_leaf()) break;
            ranges[count++] = child(*highest, 1);
            *highest = child(*highest, 0);
        }
        return count;
    }

    uint32_t count_nodes(const Range& range, uint32_t levels) const {
        if (range.is_leaf()) return 1;
        Range ranges[8];
        const uint32_t count = divide(range, levels - 1, ranges);
        uint32_t nodes = 1;
        for (uint32_t i = 0; i < count; ++i) nodes += count_nodes(ranges[i], levels - 1);
        return nodes;
    }

    /// A subtree of nodes.
    struct BuiltSubtree {
        NodeRef ref = none;
        Box box;
        double area = 0;  // half areas of all nodes below `ref`
        uint32_t levels = 1;
    };

    /// Writes the nodes of a range in at most `levels`. allocate() gives the index of a node; it does not move `nodes`.
    template <class Allocate>
    BuiltSubtree write(const Range& range, uint32_t levels, Node* nodes, uint32_t* item_lane, double root_area,
                       const Allocate& allocate) const {
        const uint32_t index = allocate();
        Node& node = nodes[index];
        BuiltSubtree built;
        built.ref = index;
        if (range.is_leaf()) {
            built.ref |= leaf_bit;
            node.count = range.last - range.first;
            for (uint32_t i = 0; i < node.count; ++i) {
                const BoxedItem& item = items_[range.first + i];
                node.boxes.set_lane(static_cast<int>(i), item.box);
                node.child[i] = item.item;
                item_lane[item.item] = 8 * index + i;
                built.box.include(item.box);
            }
            node.built_area = static_cast<float>(half_area(built.box));
            node.built_root_area = static_cast<float>(root_area);
            node.levels = 1;
            return built;
        }
        Range ranges[8];
        node.count = divide(range, levels - 1, ranges);
        for (uint32_t i = 0; i < node.count; ++i) {
            set_child(nodes, index, i, write(ranges[i], levels - 1, nodes, item_lane, root_area, allocate), built);
        }
        return built;
    }

    /// Makes `child` a child of node `index` and adds it to the sums in `built`.
    static void set_child(Node* nodes, uint32_t index, uint32_t lane, const BuiltSubtree& child, BuiltSubtree& built) {
        nodes[index].child[lane] = child.ref;
        nodes[index].boxes.set_lane(static_cast<int>(lane), child.box);
        nodes[index_of(child.ref)].parent = index;
        nodes[index_of(child.ref)].lane = lane;
        nodes[index].items += items_below(nodes[index_of(child.ref)]);
        nodes[index].levels = std::max(nodes[index].levels, 1 + child.levels);
        built.box.include(child.box);
        built.area += half_area(child.box) + child.area;
        built.levels = std::max(built.levels, 1 + child.levels);
    }

    BuiltSubtree write_all(LargeArray<Node>& nodes, uint32_t* item_lane, const Workers* workers) const;

private:
    Range child(const Range& range, int which) const {
        const uint32_t split_at = binary_[range.split_at].children[which];
        return which == 0 ? Range{range.first, range.split_at, split_at} : Range{range.split_at, range.last, split_at};
    }
    /// Follows the shares of the binary BVH down; returns the end of the ranges.
    Range* collect(const Range& all, uint32_t most, Range* ranges) const {
        const uint32_t first = all.is_leaf() || most < 2 ? 0 : binary_[all.split_at].left_share(most);
        if (first == 0) {
            *ranges = all;
            return ranges + 1;
        }
        return collect(child(all, 1), most - first, collect(child(all, 0), first, ranges));
    }

    const Vector<BoxedItem>& items_;
    const BinaryBvh& binary_;
};

}  // namespace gphys

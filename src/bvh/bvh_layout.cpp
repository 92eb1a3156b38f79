// Validation of a layout, and the build from one: a single pass in preorder, with a stack of the levels above.
#include "bvh/bvh_layout.h"

#include "bvh/bvh8.h"

namespace gphys {
namespace {

/// Position in the preorder: tracks the parent of the next node.
class PreorderCursor {
public:
    bool expects_node() const { return level_ > 0 || !started_; }
    uint32_t level() const { return level_; }
    /// Parent of the next node; bvh_none: it is the root.
    uint32_t parent() const { return level_ == 0 ? bvh_none : levels_[level_ - 1].node; }
    uint32_t lane() const { return level_ == 0 ? 0 : levels_[level_ - 1].lane; }

    /// The next node is `node`, with so many child nodes. level() is below bvh_max_levels.
    void advance(uint32_t node, uint32_t children) {
        started_ = true;
        if (level_ > 0) ++levels_[level_ - 1].lane;
        if (children > 0) levels_[level_++] = {node, 0, children};
        while (level_ > 0 && levels_[level_ - 1].lane == levels_[level_ - 1].children) --level_;
    }

private:
    struct Level {
        uint32_t node, lane, children;
    };
    Level levels_[bvh_max_levels];
    uint32_t level_ = 0;
    bool started_ = false;
};

uint32_t children_of(uint32_t word) { return (word & (BvhLayout::leaf_mark - 1)) + 1; }
bool is_leaf_word(uint32_t word) { return (word & BvhLayout::leaf_mark) != 0; }

}  // namespace

const char* BvhLayout::defect() const {
    PreorderCursor cursor;
    uint64_t placed = 0;
    for (uint32_t i = 0; i < node_count; ++i) {
        const uint32_t word = nodes[i];
        if (!cursor.expects_node()) return "a node hangs below none";
        if (word >= 2 * leaf_mark) return "a node is none";
        const bool leaf = is_leaf_word(word);
        if (cursor.level() + (leaf ? 1 : 2) > bvh_max_levels) return "the tree is too deep";
        if (leaf) placed += children_of(word);
        cursor.advance(i, leaf ? 0 : children_of(word));
    }
    if (node_count > 0 && cursor.expects_node()) return "nodes are missing";
    return placed == item_count ? nullptr : "the leaves hold more or fewer items than there are";
}

/// Built separately and swapped in, as in build_from.
void Bvh8::build(const BvhLayout& layout, const Box* boxes) {
    LargeArray<Node> nodes = nodes_.alike();
    nodes.reserve(layout.node_count + layout.node_count / 16);
    nodes.resize(layout.node_count);
    uint32_t limit = 0;
    for (uint32_t i = 0; i < layout.item_count; ++i) limit = std::max(limit, layout.item(i) + 1);
    LargeArray<uint32_t> item_lane = item_lane_.alike();
    item_lane.resize(limit, none);

    PreorderCursor cursor;
    uint32_t placed = 0;
    for (uint32_t index = 0; index < layout.node_count; ++index) {
        Node& node = nodes[index];
        const bool leaf = is_leaf_word(layout.nodes[index]);
        node.count = children_of(layout.nodes[index]);
        node.parent = cursor.parent();
        node.lane = cursor.lane();
        if (node.parent != none) nodes[node.parent].child[node.lane] = leaf ? index | leaf_bit : index;
        cursor.advance(index, leaf ? 0 : node.count);
        for (uint32_t lane = 0; leaf && lane < node.count; ++lane, ++placed) {
            node.child[lane] = layout.item(placed);
            node.boxes.set_lane(static_cast<int>(lane), boxes[placed]);
            item_lane[node.child[lane]] = 8 * index + lane;
        }
    }
    // Children follow their parents: in reverse order, each box is computed before it is read.
    double area = 0;
    Box bounds;
    for (uint32_t index = layout.node_count; index-- > 0;) {
        Node& node = nodes[index];
        kernels_.node_bounds(node, bounds);
        area += half_area(bounds);
        node.levels = std::max(node.levels, 1u);
        if (node.parent == none) continue;
        Node& parent = nodes[node.parent];
        parent.boxes.set_lane(static_cast<int>(node.lane), bounds);
        parent.items += items_below(node);
        parent.levels = std::max(parent.levels, 1 + node.levels);
    }
    const double root_area = half_area(bounds);
    for (uint32_t index = 0; index < layout.node_count; ++index) {
        if (!is_leaf_word(layout.nodes[index])) continue;
        Box box;
        kernels_.node_bounds(nodes[index], box);
        nodes[index].built_area = static_cast<float>(half_area(box));
        nodes[index].built_root_area = static_cast<float>(root_area);
    }

    cancel_renewal();
    added_ = 0;
    cancel_renewal();
    added_ = 0;
    if (size_ > 0) ++rebuilds_;
    nodes_.swap(nodes);
    item_lane_.swap(item_lane);
    root_ = layout.node_count == 0 ? none : is_leaf_word(layout.nodes[0]) ? leaf_bit : 0;
    size_ = layout.item_count;
    first_free_ = none;
    free_count_ = 0;
    bounds_ = bounds;
    built_root_area_ = root_area;
    built_area_ = area;
}

}  // namespace gphys

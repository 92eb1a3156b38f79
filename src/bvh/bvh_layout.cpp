#include "bvh/bvh_layout.h"

#include "bvh/bvh8.h"

namespace gphys {

namespace {

/// Goes through the nodes of a layout in their order and knows the parent of each.
class Descent {
public:
    /// Whether another node may follow.
    bool waits() const { return level_ > 0 || !started_; }
    uint32_t level() const { return level_; }
    /// Of the next node; bvh_none: it is the root.
    uint32_t parent() const { return level_ == 0 ? bvh_none : open_[level_ - 1].node; }
    uint32_t lane() const { return level_ == 0 ? 0 : open_[level_ - 1].lane; }

    /// Go on behind the next node, which is `node` and has so many nodes below it. There is a level left.
    void pass(uint32_t node, uint32_t children) {
        started_ = true;
        if (level_ > 0) ++open_[level_ - 1].lane;
        if (children > 0) open_[level_++] = {node, 0, children};
        while (level_ > 0 && open_[level_ - 1].lane == open_[level_ - 1].children) --level_;
    }

private:
    struct Open {
        uint32_t node, lane, children;
    };
    Open open_[bvh_max_levels];
    uint32_t level_ = 0;
    bool started_ = false;
};

uint32_t children_of(uint32_t word) { return (word & (BvhLayout::leaf_mark - 1)) + 1; }
bool is_leaf_word(uint32_t word) { return (word & BvhLayout::leaf_mark) != 0; }

}  // namespace

const char* BvhLayout::defect() const {
    Descent descent;
    uint64_t placed = 0;
    for (uint32_t i = 0; i < node_count; ++i) {
        const uint32_t word = nodes[i];
        if (!descent.waits()) return "a node hangs below none";
        if (word >= 2 * leaf_mark) return "a node is none";
        const bool leaf = is_leaf_word(word);
        if (descent.level() + (leaf ? 1 : 2) > bvh_max_levels) return "the tree is too deep";
        if (leaf) placed += children_of(word);
        descent.pass(i, leaf ? 0 : children_of(word));
    }
    if (node_count > 0 && descent.waits()) return "nodes are missing";
    return placed == item_count ? nullptr : "the leaves hold more or fewer items than there are";
}

/// Built aside and swapped in, as in build_from.
void Bvh8::build(const BvhLayout& layout, const Box* boxes) {
    LargeArray<Node> nodes = nodes_.alike();
    nodes.reserve(layout.node_count + layout.node_count / 16);
    nodes.resize(layout.node_count);
    uint32_t limit = 0;
    for (uint32_t i = 0; i < layout.item_count; ++i) limit = std::max(limit, layout.item(i) + 1);
    LargeArray<uint32_t> place_of = place_of_.alike();
    place_of.resize(limit, none);

    Descent descent;
    uint32_t placed = 0;
    for (uint32_t index = 0; index < layout.node_count; ++index) {
        Node& node = nodes[index];
        const bool leaf = is_leaf_word(layout.nodes[index]);
        node.count = children_of(layout.nodes[index]);
        node.parent = descent.parent();
        node.lane = descent.lane();
        if (node.parent != none) nodes[node.parent].child[node.lane] = leaf ? index | leaf_bit : index;
        descent.pass(index, leaf ? 0 : node.count);
        for (uint32_t lane = 0; leaf && lane < node.count; ++lane, ++placed) {
            node.child[lane] = layout.item(placed);
            node.boxes.set_lane(static_cast<int>(lane), boxes[placed]);
            place_of[node.child[lane]] = 8 * index + lane;
        }
    }
    // Children stand behind their parents: backwards each box is there before it is asked for.
    double area = 0;
    Box bounds;
    for (uint32_t index = layout.node_count; index-- > 0;) {
        Node& node = nodes[index];
        kernels_.around(node, bounds);
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
        kernels_.around(nodes[index], box);
        nodes[index].made_area = static_cast<float>(half_area(box));
        nodes[index].made_root_area = static_cast<float>(root_area);
    }

    if (size_ > 0) ++rebuilds_;
    nodes_.swap(nodes);
    place_of_.swap(place_of);
    root_ = layout.node_count == 0 ? none : is_leaf_word(layout.nodes[0]) ? leaf_bit : 0;
    size_ = layout.item_count;
    first_free_ = none;
    free_count_ = 0;
    bounds_ = bounds;
    built_root_area_ = root_area;
    built_area_ = area;
}

}  // namespace gphys

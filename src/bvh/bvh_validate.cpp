// Statistics of the BVH (SAH cost: MacDonald and Booth 1990), and a check of all its invariants.
#include "bvh/bvh8.h"

namespace gphys {

/// The sum of half areas below a node. Divided by the root's, it is the expected number of nodes that a random ray
/// through the root visits.
double Bvh8::area_below(NodeRef ref) const {
    if (is_leaf(ref)) return 0;
    const Node& node = nodes_[ref];
    double area = 0;
    for (uint32_t i = 0; i < node.count; ++i) {
        area += half_area(node.boxes.lane(static_cast<int>(i))) + area_below(node.child[i]);
    }
    return area;
}

gphys_octree_stats Bvh8::stats() const {
    gphys_octree_stats stats{};
    stats.item_count = size_;
    stats.rebuilds = rebuilds_;
    for_each_box([&](const gphys_octree_box& box) {
        ++stats.node_count;
        if (box.item_count > 0) ++stats.leaf_count;
        stats.depth = std::max(stats.depth, box.depth + 1);
    });
    const double root_area = half_area(bounds_);
    double item_area = 0;
    for (uint32_t item = 0; item < item_lane_.size(); ++item) {
        if (item_lane_[item] != none) item_area += half_area(box(item));
    }
    // In a tree without extent every ray visits all nodes.
    stats.cost = static_cast<float>(root_area > 0 ? 1 + (area_below(root_) + item_area) / root_area
                                                  : static_cast<double>(stats.node_count) + size_);
    const uint64_t bytes = nodes_.capacity() * sizeof(Node) + item_lane_.capacity() * sizeof(uint32_t);
    stats.memory_bytes = static_cast<uint32_t>(std::min<uint64_t>(bytes, std::numeric_limits<uint32_t>::max()));
    return stats;
}

const char* Bvh8::defect() const {
    uint32_t item_count = 0, node_count = 0;
    if (root_ != none) {
        if (nodes_[index_of(root_)].parent != none) return "the root has a parent";
        NodeRef stack[bvh_max_open];
        int size = 0;
        stack[size++] = root_;
        while (size > 0) {
            const NodeRef ref = stack[--size];
            const uint32_t index = index_of(ref);
            if (index >= nodes_.size()) return "a reference leads out of the tree";
            const Node& node = nodes_[index];
            ++node_count;
            if (node_count > nodes_.size()) return "the nodes do not form a tree";
            if (node.count == 0 || node.count > 8) return "a node has none or too many children";
            if (level_of(index) > levels() || levels() > max_levels) return "the tree is too deep";
            const Box box = union_of(node);
            for (int k = 0; k < 3; ++k) {
                if (!(box.min[k] >= -max_box_coordinate && box.max[k] <= max_box_coordinate)) {
                    return "a box is out of range";
                }
            }
            const Box above =
                node.parent == none ? bounds_ : nodes_[node.parent].boxes.lane(static_cast<int>(node.lane));
            if (!(box == above)) return "a node's box is not tight";
            if (is_leaf(ref) != (node.levels == 1)) return "a node does not know whether it is a leaf";
            uint32_t items_of_children = 0;
            for (uint32_t i = 0; i < node.count; ++i) {
                const uint32_t child = node.child[i];
                if (!is_leaf(ref)) {
                    if (index_of(child) >= nodes_.size()) return "a reference leads out of the tree";
                    const Node& below = nodes_[index_of(child)];
                    if (below.parent != index || below.lane != i) return "a child does not know its parent";
                    if (below.levels >= node.levels) return "a node has more levels than it knows of";
                    items_of_children += items_below(below);
                    stack[size++] = child;
                } else {
                    if (child >= item_lane_.size() || item_lane_[child] != 8 * index + i) {
                        return "an item does not know its leaf";
                    }
                    ++item_count;
                }
            }
            if (!is_leaf(ref) && items_of_children != node.items) return "the items below a node are miscounted";
        }
    }
    if (item_count != size_) return "items are missing";
    uint32_t placed = 0;
    for (const uint32_t place : item_lane_) placed += place != none;
    if (placed != size_) return "an item outside the tree has a place";
    uint32_t free_count = 0;
    for (uint32_t index = first_free_; index != none && free_count <= free_count_; index = nodes_[index].parent) {
        ++free_count;
    }
    if (free_count != free_count_) return "the free nodes are miscounted";
    if (node_count + free_count != nodes_.size()) return "nodes are lost";
    return nullptr;
}

}  // namespace gphys

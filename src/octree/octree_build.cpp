// Building the octree from scratch: boxes cut by expected cost, three times a level.
#include "octree/cut_tree.h"
#include "octree/octree.h"

namespace gphys {

Box Octree::union_of(const Node& node) {
    Box box;
    for (uint32_t i = 0; i < node.count; ++i) box.include(node.boxes.lane(static_cast<int>(i)));
    return box;
}

/// Makes nodes of a CutTree, preserving its order.
class Octree::Builder {
public:
    Builder(const Vector<BoxedItem>& items, const CutTree& cuts, Node* nodes, uint32_t* place_of)
        : items_(items), cuts_(cuts), nodes_(nodes), place_of_(place_of) {}

    /// Items between two cuts, and the cut between them.
    struct Part {
        uint32_t first, last, cut;

        bool is_leaf() const { return cut == CutTree::none; }
    };
    Part whole() const { return {0, static_cast<uint32_t>(items_.size()), cuts_.root()}; }

    /// The children of a node: always the largest part is cut, until there are eight or all are
    /// leaves. But three levels of cuts must fit into each level of nodes that is left below.
    int divide(const Part& node, int levels_below, Part parts[8]) const {
        const bool by_area = (cuts_.height(node.cut) - 1 + 2) / 3 + 1 <= static_cast<uint32_t>(levels_below);
        int count = 1;
        parts[0] = node;
        while (count < 8) {
            int chosen = -1;
            double largest = -1;
            for (int i = 0; i < count; ++i) {
                if (parts[i].is_leaf()) continue;
                const CutTree::Cut& cut = cuts_[parts[i].cut];
                const double measure = by_area ? cut.half_area : cut.height;
                if (measure > largest) {
                    largest = measure;
                    chosen = i;
                }
            }
            if (chosen < 0) break;
            const Part part = parts[chosen];
            const CutTree::Cut& cut = cuts_[part.cut];
            parts[chosen] = {part.first, part.cut, cut.below[0]};
            parts[count++] = {part.cut, part.last, cut.below[1]};
        }
        return count;
    }

    uint32_t count_nodes(const Part& part, int levels) const {
        if (part.is_leaf()) return 1;
        Part parts[8];
        const int count = divide(part, levels - 1, parts);
        uint32_t nodes = 1;
        for (int i = 0; i < count; ++i) nodes += count_nodes(parts[i], levels - 1);
        return nodes;
    }

    /// The nodes of a part: take() gives the index of each.
    template <class Take>
    NodeRef lay(const Part& part, int levels, uint32_t parent, uint32_t lane, const Take& take, Box& box) {
        const uint32_t index = take();
        Node& node = nodes_[index];
        node.parent = parent;
        node.lane = lane;
        box = Box();
        if (part.is_leaf()) {
            node.count = part.last - part.first;
            for (uint32_t i = 0; i < node.count; ++i) {
                const BoxedItem& item = items_[part.first + i];
                node.boxes.set_lane(static_cast<int>(i), item.box);
                node.child[i] = item.item;
                place_of_[item.item] = 8 * index + i;
                box.include(item.box);
            }
            return index | leaf_bit;
        }
        Part parts[8];
        node.count = static_cast<uint32_t>(divide(part, levels - 1, parts));
        for (uint32_t i = 0; i < node.count; ++i) {
            Box child_box;
            node.child[i] = lay(parts[i], levels - 1, index, i, take, child_box);
            node.boxes.set_lane(static_cast<int>(i), child_box);
            box.include(child_box);
            area += half_area(child_box);
        }
        return index;
    }

    double area = 0;  // of all nodes laid, without the root

private:
    const Vector<BoxedItem>& items_;
    const CutTree& cuts_;
    Node* nodes_;
    uint32_t* place_of_;
};

/// Replace the tree by one of these items. Built aside and swapped in, so that running out of
/// memory changes nothing.
void Octree::build_from(Vector<BoxedItem>& items, size_t item_limit) {
    Vector<Node> nodes(nodes_.get_allocator());
    Vector<uint32_t> place_of(item_limit, none, place_of_.get_allocator());
    NodeRef root = none;
    Box bounds;
    double area = 0;
    if (!items.empty()) {
        const CutTree cuts(items, 3 * (max_built_levels - 1), nullptr);
        nodes.resize(Builder(items, cuts, nullptr, nullptr)
                         .count_nodes({0, static_cast<uint32_t>(items.size()), cuts.root()}, max_built_levels));
        Builder builder(items, cuts, nodes.data(), place_of.data());
        uint32_t next = 0;
        root = builder.lay(
            builder.whole(), max_built_levels, none, 0, [&] { return next++; }, bounds);
        area = builder.area;
    }
    if (size_ > 0) ++rebuilds_;
    nodes_.swap(nodes);
    place_of_.swap(place_of);
    root_ = root;
    size_ = static_cast<uint32_t>(items.size());
    first_free_ = none;
    free_count_ = 0;
    bounds_ = bounds;
    built_root_area_ = half_area(bounds_);
    built_area_ = area + built_root_area_;
    built_size_ = size_;
    changes_ = 0;
}

void Octree::build(const Box* boxes, const uint32_t* items, uint32_t count) {
    Vector<BoxedItem> all(nodes_.get_allocator());
    all.reserve(count);
    size_t limit = 0;
    for (uint32_t i = 0; i < count; ++i) {
        all.push_back({boxes[i], items[i]});
        limit = std::max(limit, size_t{items[i]} + 1);
    }
    build_from(all, limit);
}

void Octree::rebuild() {
    Vector<BoxedItem> all(nodes_.get_allocator());
    all.reserve(size_);
    append_items(all);
    build_from(all, place_of_.size());
}

void Octree::append_items(Vector<BoxedItem>& to) const {
    for (uint32_t item = 0; item < place_of_.size(); ++item) {
        if (place_of_[item] != none) to.push_back({box(item), item});
    }
}

void Octree::split(NodeRef leaf, uint32_t item, const Box& box) {
    const uint32_t index = index_of(leaf);
    BoxedItem items[9], scratch[9];
    for (int i = 0; i < 8; ++i) items[i] = {nodes_[index].boxes.lane(i), nodes_[index].child[i]};
    items[8] = {box, item};
    const BoxedItem* middle = split_by_cost(items, items + 9, scratch);

    nodes_[index].count = 0;
    const NodeRef sibling = take_node(true);
    for (const BoxedItem* i = items; i != items + 9; ++i) {
        const NodeRef home = i < middle ? leaf : sibling;
        put(home, nodes_[index_of(home)].count++, i->item, i->box);
    }
    const Box first_box = union_of(nodes_[index]), second_box = union_of(nodes_[index_of(sibling)]);

    const uint32_t parent = nodes_[index].parent;
    if (parent != none && nodes_[parent].count < 8) {
        put(parent, nodes_[index].lane, leaf, first_box);
        put(parent, nodes_[parent].count++, sibling, second_box);
        refit_upward(parent);
        return;
    }
    // No room beside the leaf: a new node takes its place and holds both.
    const NodeRef above = take_node(false);
    nodes_[above].parent = parent;
    nodes_[above].lane = nodes_[index].lane;
    if (parent == none) {
        root_ = above;
    } else {
        nodes_[parent].child[nodes_[index].lane] = above;
    }
    nodes_[above].count = 2;
    put(above, 0, leaf, first_box);
    put(above, 1, sibling, second_box);
    refit_upward(above);
}

}  // namespace gphys

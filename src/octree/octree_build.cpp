// Building the octree from scratch: boxes cut by expected cost, three times a level.
#include "octree/octree.h"

namespace gphys {

namespace {

// The first levels are cut by cost. Strange inputs (sizes in a geometric series) make such cuts
// uneven; below that, halving three times a level brings any 2^32 items into leaves of eight within
// eleven more levels and the leaf itself.
constexpr int cost_levels = Octree::max_built_levels - 12;

}  // namespace

Box Octree::union_of(const Node& node) {
    Box box;
    for (uint32_t i = 0; i < node.count; ++i) box.include(node.boxes.lane(static_cast<int>(i)));
    return box;
}

class Octree::Builder {
public:
    Builder(Vector<Node>& nodes, Vector<uint32_t>& place_of) : nodes_(nodes), place_of_(place_of) {}

    /// A subtree of the items of [first, last), which is not empty and is put in order.
    NodeRef build(BoxedItem* first, BoxedItem* last, uint32_t parent, uint32_t lane, int level) {
        const uint32_t index = static_cast<uint32_t>(nodes_.size());
        nodes_.emplace_back();
        nodes_[index].parent = parent;
        nodes_[index].lane = lane;
        if (static_cast<size_t>(last - first) <= leaf_size) {
            for (BoxedItem* item = first; item != last; ++item) {
                const uint32_t i = nodes_[index].count++;
                nodes_[index].child[i] = item->item;
                nodes_[index].boxes.set_lane(static_cast<int>(i), item->box);
                place_of_[item->item] = 8 * index + i;
            }
            return index | leaf_bit;
        }

        Part parts[8];
        const int part_count = partition(first, last, level, parts);
        nodes_[index].count = static_cast<uint32_t>(part_count);
        for (int i = 0; i < part_count; ++i) {
            area += half_area(parts[i].box);
            nodes_[index].boxes.set_lane(i, parts[i].box);
            // Not in one statement: building below may move the nodes.
            const NodeRef child = build(parts[i].first, parts[i].last, index, static_cast<uint32_t>(i), level + 1);
            nodes_[index].child[i] = child;
        }
        return index;
    }

    double area = 0;  // of all nodes built, without the root

private:
    struct Part {
        BoxedItem *first, *last;
        Box box;

        size_t size() const { return static_cast<size_t>(last - first); }
    };

    /// Cut one part after the other until there are eight or all fit into leaves.
    static int partition(BoxedItem* first, BoxedItem* last, int level, Part parts[8]) {
        const bool by_cost = level < cost_levels;
        int count = 1;
        parts[0] = {first, last, gphys::union_of(first, last)};
        while (count < 8) {
            int chosen = -1;
            double largest = -1;
            for (int i = 0; i < count; ++i) {
                if (parts[i].size() <= leaf_size) continue;
                const double measure = by_cost ? half_area(parts[i].box) : static_cast<double>(parts[i].size());
                if (measure > largest) {
                    largest = measure;
                    chosen = i;
                }
            }
            if (chosen < 0) break;
            const Part whole = parts[chosen];
            BoxedItem* cut = by_cost ? split_by_cost(whole.first, whole.last) : split_by_count(whole.first, whole.last);
            parts[chosen] = {whole.first, cut, gphys::union_of(whole.first, cut)};
            parts[count++] = {cut, whole.last, gphys::union_of(cut, whole.last)};
        }
        return count;
    }

    Vector<Node>& nodes_;
    Vector<uint32_t>& place_of_;
};

/// Replace the tree by one of these items. Built aside and swapped in, so that running out of
/// memory changes nothing.
void Octree::build_from(Vector<BoxedItem>& items, size_t item_limit) {
    Vector<Node> nodes(nodes_.get_allocator());
    Vector<uint32_t> place_of(item_limit, none, place_of_.get_allocator());
    Builder builder(nodes, place_of);
    NodeRef root = none;
    if (!items.empty()) {
        nodes.reserve(items.size() / 4 + 1);
        root = builder.build(items.data(), items.data() + items.size(), none, 0, 0);
    }
    if (size_ > 0) ++rebuilds_;
    nodes_.swap(nodes);
    place_of_.swap(place_of);
    root_ = root;
    size_ = static_cast<uint32_t>(items.size());
    first_free_ = none;
    free_count_ = 0;
    bounds_ = root == none ? Box() : union_of(nodes_[index_of(root)]);
    built_root_area_ = half_area(bounds_);
    built_area_ = builder.area + built_root_area_;
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
    BoxedItem items[9];
    for (int i = 0; i < 8; ++i) items[i] = {nodes_[index].boxes.lane(i), nodes_[index].child[i]};
    items[8] = {box, item};
    const BoxedItem* middle = split_by_cost(items, items + 9);

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

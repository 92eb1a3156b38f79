// Building the octree from scratch: binned surface area heuristic (Wald, "On fast Construction of
// SAH-based Bounding Volume Hierarchies", 2007), three splits a level.
#include "octree/octree.h"

namespace gphys {

namespace {

constexpr int bin_count = 16;
constexpr uint32_t leaf_size = 8;
// The first levels are cut by cost. Strange inputs (sizes in a geometric series) make such cuts
// uneven; below that, halving three times a level brings any 2^32 items into leaves of eight within
// eleven more levels and the leaf itself.
constexpr int cost_levels = Octree::max_built_levels - 12;

/// Twice the centre: a sum needs no rounding of its own to be monotone.
float centre(const Box& box, int axis) { return box.min[axis] + box.max[axis]; }

/// Expected tests in a part: a leaf tests eight boxes at the price of one.
double blocks(size_t count) { return static_cast<double>((count + leaf_size - 1) / leaf_size); }

}  // namespace

double Octree::half_area(const Box& box) {
    if (box.min[0] > box.max[0]) return 0;
    const double x = double{box.max[0]} - box.min[0], y = double{box.max[1]} - box.min[1],
                 z = double{box.max[2]} - box.min[2];
    return x * y + y * z + z * x;
}

Box Octree::union_of(const Node& node) {
    Box box;
    for (uint32_t i = 0; i < node.count; ++i) box.include(node.boxes.lane(static_cast<int>(i)));
    return box;
}

class Octree::Builder {
public:
    Builder(Vector<Node>& nodes, Vector<uint32_t>& place_of) : nodes_(nodes), place_of_(place_of) {}

    /// A subtree of the items of [first, last), which is not empty and is put in order.
    NodeRef build(Item* first, Item* last, uint32_t parent, uint32_t lane, int level) {
        const uint32_t index = static_cast<uint32_t>(nodes_.size());
        nodes_.emplace_back();
        nodes_[index].parent = parent;
        nodes_[index].lane = lane;
        if (static_cast<size_t>(last - first) <= leaf_size) {
            for (Item* item = first; item != last; ++item) {
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

    /// Cut more than one item in two where the expected cost of both parts is least.
    static Item* split(Item* first, Item* last) {
        const Box centres = centres_of(first, last);
        Bins bins[3];
        for (int k = 0; k < 3; ++k) bins[k] = Bins(centres.min[k], centres.max[k], k);
        for (const Item* item = first; item != last; ++item) {
            for (Bins& b : bins) b.add(item->box);
        }
        double least = infinity;
        int axis = 0, cut = 0;
        for (int k = 0; k < 3; ++k) bins[k].best(least, axis, cut, k);
        if (cut == 0) return halve(first, last, centres);
        const Bins& chosen = bins[axis];
        return std::partition(first, last, [&](const Item& item) { return chosen.index(item.box) < cut; });
    }

    double area = 0;  // of all nodes built, without the root

private:
    struct Part {
        Item *first, *last;
        Box box;

        size_t size() const { return static_cast<size_t>(last - first); }
    };

    /// Items counted by the position of their centres along one axis.
    class Bins {
    public:
        Bins() = default;
        Bins(float low, float high, int axis) : axis_(axis), low_(low) {
            // Below this the scale would leave the range of float; the items are as good as equal.
            const float extent = high - low;
            if (extent > 1e-30f) scale_ = bin_count * (1 - 0x1p-20f) / extent;
        }

        int index(const Box& box) const { return static_cast<int>((centre(box, axis_) - low_) * scale_); }

        void add(const Box& box) {
            const int i = index(box);
            boxes_[i].include(box);
            ++counts_[i];
        }

        /// Lower `least` if a cut between two bins costs less.
        void best(double& least, int& axis, int& cut, int k) const {
            if (scale_ == 0) return;
            double cost_above[bin_count];  // of all bins from i on
            Box box;
            size_t count = 0;
            for (int i = bin_count - 1; i > 0; --i) {
                box.include(boxes_[i]);
                count += counts_[i];
                cost_above[i] = count == 0 ? -1 : half_area(box) * blocks(count);
            }
            box = Box();
            count = 0;
            for (int i = 1; i < bin_count; ++i) {
                box.include(boxes_[i - 1]);
                count += counts_[i - 1];
                if (count == 0 || cost_above[i] < 0) continue;
                const double cost = half_area(box) * blocks(count) + cost_above[i];
                if (cost < least) {
                    least = cost;
                    axis = k;
                    cut = i;
                }
            }
        }

    private:
        int axis_ = 0;
        float low_ = 0, scale_ = 0;
        Box boxes_[bin_count];
        size_t counts_[bin_count] = {};
    };

    static Box centres_of(const Item* first, const Item* last) {
        Box centres;
        for (const Item* item = first; item != last; ++item) {
            for (int k = 0; k < 3; ++k) {
                centres.min[k] = std::min(centres.min[k], centre(item->box, k));
                centres.max[k] = std::max(centres.max[k], centre(item->box, k));
            }
        }
        return centres;
    }

    /// Two parts of equal number along the axis on which the centres spread most.
    static Item* halve(Item* first, Item* last, const Box& centres) {
        int axis = 0;
        for (int k = 1; k < 3; ++k) {
            if (centres.max[k] - centres.min[k] > centres.max[axis] - centres.min[axis]) axis = k;
        }
        Item* middle = first + (last - first) / 2;
        std::nth_element(first, middle, last, [axis](const Item& a, const Item& b) {
            const float ca = centre(a.box, axis), cb = centre(b.box, axis);
            return ca < cb || (ca == cb && a.item < b.item);
        });
        return middle;
    }

    static Part make_part(Item* first, Item* last) {
        Part part{first, last, {}};
        for (const Item* item = first; item != last; ++item) part.box.include(item->box);
        return part;
    }

    /// Cut one part after the other until there are eight or all fit into leaves.
    static int partition(Item* first, Item* last, int level, Part parts[8]) {
        const bool by_cost = level < cost_levels;
        int count = 1;
        parts[0] = make_part(first, last);
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
            Item* cut = by_cost ? split(whole.first, whole.last)
                                : halve(whole.first, whole.last, centres_of(whole.first, whole.last));
            parts[chosen] = make_part(whole.first, cut);
            parts[count++] = make_part(cut, whole.last);
        }
        return count;
    }

    Vector<Node>& nodes_;
    Vector<uint32_t>& place_of_;
};

/// Replace the tree by one of these items. Built aside and swapped in, so that running out of
/// memory changes nothing.
void Octree::build_from(Vector<Item>& items, size_t item_limit) {
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
    Vector<Item> all(nodes_.get_allocator());
    all.reserve(count);
    size_t limit = 0;
    for (uint32_t i = 0; i < count; ++i) {
        all.push_back({boxes[i], items[i]});
        limit = std::max(limit, size_t{items[i]} + 1);
    }
    build_from(all, limit);
}

void Octree::rebuild() {
    Vector<Item> all(nodes_.get_allocator());
    all.reserve(size_);
    append_items(all);
    build_from(all, place_of_.size());
}

void Octree::append_items(Vector<Item>& to) const {
    for (uint32_t item = 0; item < place_of_.size(); ++item) {
        if (place_of_[item] != none) to.push_back({box(item), item});
    }
}

void Octree::split(NodeRef leaf, uint32_t item, const Box& box) {
    const uint32_t index = index_of(leaf);
    Item items[9];
    for (int i = 0; i < 8; ++i) items[i] = {nodes_[index].boxes.lane(i), nodes_[index].child[i]};
    items[8] = {box, item};
    const Item* middle = Builder::split(items, items + 9);

    nodes_[index].count = 0;
    const NodeRef sibling = take_node(true);
    for (const Item* i = items; i != items + 9; ++i) {
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

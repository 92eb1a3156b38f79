// Building the BVH, as a whole or some children of a node: boxes are cut in two by expected cost
// (binary_bvh.h), and three levels of cuts make one of nodes.
#include "bvh/binary_bvh.h"
#include "bvh/bvh8.h"
#include "foundation/compiler.h"
#include "foundation/workers.h"

namespace gphys {

Box Bvh8::union_of(const Node& node) {
    Box box;
    for (uint32_t i = 0; i < node.count; ++i) box.include(node.boxes.lane(static_cast<int>(i)));
    return box;
}

/// Makes nodes of a BinaryBvh.
class Bvh8::Builder {
public:
    Builder(const Vector<BoxedItem>& items, const BinaryBvh& cuts) : items_(items), cuts_(cuts) {}

    /// Items between two cuts, and the cut between them.
    struct Part {
        uint32_t first, last, cut;

        bool is_leaf() const { return cut == BinaryBvh::none; }
    };
    Part whole() const { return {0, static_cast<uint32_t>(items_.size()), cuts_.root()}; }

    /// Divide a part into at most `most`, as is cheapest. But three levels of cuts must fit into each level of nodes
    /// that is left below: if they hardly do, always the highest is cut, until there are that many or all are leaves.
    uint32_t divide(const Part& whole, uint32_t levels_below, Part* parts, uint32_t most = 8) const {
        if ((cuts_.height(whole.cut) + 1) / 3 + 1 <= levels_below) {
            return static_cast<uint32_t>(share(whole, most, parts) - parts);
        }
        uint32_t count = 1;
        parts[0] = whole;
        while (count < most) {
            Part* const highest = std::max_element(parts, parts + count, [this](const Part& a, const Part& b) {
                return cuts_.height(a.cut) < cuts_.height(b.cut);
            });
            if (highest->is_leaf()) break;
            parts[count++] = half(*highest, 1);
            *highest = half(*highest, 0);
        }
        return count;
    }

    uint32_t count_nodes(const Part& part, uint32_t levels) const {
        if (part.is_leaf()) return 1;
        Part parts[8];
        const uint32_t count = divide(part, levels - 1, parts);
        uint32_t nodes = 1;
        for (uint32_t i = 0; i < count; ++i) nodes += count_nodes(parts[i], levels - 1);
        return nodes;
    }

    /// What a part has become.
    struct Laid {
        NodeRef ref = none;
        Box box;
        double area = 0;  // of all nodes below
        uint32_t levels = 1;
    };

    /// Make the nodes of a part, in at most `levels`. take() gives the index of each, which lets go
    /// of nothing else.
    template <class Take>
    Laid lay(const Part& part, uint32_t levels, Node* nodes, uint32_t* place_of, double root_area,
             const Take& take) const {
        const uint32_t index = take();
        Node& node = nodes[index];
        Laid laid;
        laid.ref = index;
        if (part.is_leaf()) {
            laid.ref |= leaf_bit;
            node.count = part.last - part.first;
            for (uint32_t i = 0; i < node.count; ++i) {
                const BoxedItem& item = items_[part.first + i];
                node.boxes.set_lane(static_cast<int>(i), item.box);
                node.child[i] = item.item;
                place_of[item.item] = 8 * index + i;
                laid.box.include(item.box);
            }
            node.made_area = static_cast<float>(half_area(laid.box));
            node.made_root_area = static_cast<float>(root_area);
            node.levels = 1;
            return laid;
        }
        Part parts[8];
        node.count = divide(part, levels - 1, parts);
        for (uint32_t i = 0; i < node.count; ++i) {
            adopt(nodes, index, i, lay(parts[i], levels - 1, nodes, place_of, root_area, take), laid);
        }
        return laid;
    }

    /// Make `child` that of a node, of which `laid` tells.
    static void adopt(Node* nodes, uint32_t index, uint32_t lane, const Laid& child, Laid& laid) {
        nodes[index].child[lane] = child.ref;
        nodes[index].boxes.set_lane(static_cast<int>(lane), child.box);
        nodes[index_of(child.ref)].parent = index;
        nodes[index_of(child.ref)].lane = lane;
        nodes[index].items += items_below(nodes[index_of(child.ref)]);
        nodes[index].levels = std::max(nodes[index].levels, 1 + child.levels);
        laid.box.include(child.box);
        laid.area += half_area(child.box) + child.area;
        laid.levels = std::max(laid.levels, 1 + child.levels);
    }

    Laid lay_all(LargeArray<Node>& nodes, uint32_t* place_of, const Workers* workers) const;

private:
    Part half(const Part& part, int which) const {
        const uint32_t below = cuts_[part.cut].below[which];
        return which == 0 ? Part{part.first, part.cut, below} : Part{part.cut, part.last, below};
    }
    /// The end of the parts.
    Part* share(const Part& whole, uint32_t most, Part* parts) const {
        const uint32_t first = whole.is_leaf() || most < 2 ? 0 : cuts_[whole.cut].share(most);
        if (first == 0) {
            *parts = whole;
            return parts + 1;
        }
        return share(half(whole, 1), most - first, share(half(whole, 0), first, parts));
    }

    const Vector<BoxedItem>& items_;
    const BinaryBvh& cuts_;
};

/// Workers make the subtrees below two levels of nodes. The nodes of these two come first, then
/// those of one subtree after the other: where each begins is counted before.
Bvh8::Builder::Laid Bvh8::Builder::lay_all(LargeArray<Node>& nodes, uint32_t* place_of, const Workers* workers) const {
    struct Subtree {
        Part part;
        uint32_t levels, parent, lane;
        uint32_t first_node;
        Laid laid;
    };
    Subtree subtrees[64];
    uint32_t subtree_count = 1, top_parent[9], top_lane[9], top_size[9], top_count = 0;
    subtrees[0] = {whole(), max_built_levels, none, 0, 0, {}};
    for (int level = 0; level < 2; ++level) {
        const uint32_t before = subtree_count;
        for (uint32_t s = 0; s < before; ++s) {
            const Subtree divided = subtrees[s];
            if (divided.part.is_leaf()) continue;
            Part parts[8];
            const uint32_t top = top_count++, count = divide(divided.part, divided.levels - 1, parts);
            top_parent[top] = divided.parent;
            top_lane[top] = divided.lane;
            top_size[top] = count;
            for (uint32_t i = 0; i < count; ++i) {
                const uint32_t place = i == 0 ? s : subtree_count++;
                subtrees[place] = {parts[i], divided.levels - 1, top, i, 0, {}};
            }
        }
    }

    run(workers, subtree_count,
        [&](uint32_t s) { subtrees[s].first_node = count_nodes(subtrees[s].part, subtrees[s].levels); });
    uint32_t node_count = top_count;
    for (uint32_t s = 0; s < subtree_count; ++s) {
        const uint32_t count = subtrees[s].first_node;
        subtrees[s].first_node = node_count;
        node_count += count;
    }
    // A few more, so that first changes need no memory.
    nodes.reserve(node_count + node_count / 16);
    nodes.resize(node_count);

    const double root_area = half_area(gphys::union_of(items_.data(), items_.data() + items_.size()));
    run(workers, subtree_count, [&](uint32_t s) {
        uint32_t next = subtrees[s].first_node;
        subtrees[s].laid =
            lay(subtrees[s].part, subtrees[s].levels, nodes.data(), place_of, root_area, [&] { return next++; });
    });

    Laid tops[9];
    if (top_count == 0) return subtrees[0].laid;
    for (uint32_t top = 0; top < top_count; ++top) {
        tops[top].ref = top;
        nodes[top].count = top_size[top];
    }
    for (uint32_t s = 0; s < subtree_count; ++s) {
        adopt(nodes.data(), subtrees[s].parent, subtrees[s].lane, subtrees[s].laid, tops[subtrees[s].parent]);
    }
    for (uint32_t top = top_count; --top > 0;) {
        adopt(nodes.data(), top_parent[top], top_lane[top], tops[top], tops[top_parent[top]]);
    }
    return tops[0];
}

/// Replace the tree by one of these items. Built aside and swapped in, so that running out of
/// memory changes nothing.
void Bvh8::build_from(Vector<BoxedItem>& items, size_t item_limit) {
    LargeArray<Node> nodes = nodes_.alike();
    LargeArray<uint32_t> place_of = place_of_.alike();
    place_of.reserve(place_of_.capacity());
    place_of.resize(item_limit, none);
    Builder::Laid laid;
    if (!items.empty()) {
        const BinaryBvh cuts(items, 3 * (max_built_levels - 1), workers_);
        // Room that was reserved is kept.
        nodes.reserve(nodes_.capacity());
        laid = Builder(items, cuts).lay_all(nodes, place_of.data(), items.size() < shared_size ? nullptr : workers_);
        nodes[index_of(laid.ref)].parent = none;
    }
    if (size_ > 0) ++rebuilds_;
    nodes_.swap(nodes);
    place_of_.swap(place_of);
    root_ = laid.ref;
    size_ = static_cast<uint32_t>(items.size());
    first_free_ = none;
    free_count_ = 0;
    bounds_ = laid.box;
    built_root_area_ = half_area(bounds_);
    built_area_ = built_root_area_ + laid.area;
}

void Bvh8::build(const Box* boxes, const uint32_t* items, uint32_t count) {
    Vector<BoxedItem> all(nodes_.memory());
    all.reserve(count);
    size_t limit = 0;
    for (uint32_t i = 0; i < count; ++i) {
        all.push_back({boxes[i], items[i]});
        limit = std::max(limit, size_t{items[i]} + 1);
    }
    build_from(all, limit);
}

void Bvh8::rebuild() {
    if (size_ == 0) return;
    Vector<BoxedItem> all(nodes_.memory());
    all.reserve(size_);
    append_items(root_, all);
    build_from(all, place_of_.size());
}

/// Build some children of a node again, all together, so that they exchange items. They become no
/// more than they were: a parent without room would split at the next insertion.
void Bvh8::rebuild_children(uint32_t parent, uint32_t lanes) {
    Vector<BoxedItem> items(nodes_.memory());
    uint32_t most = 0, node_count_before = 0;
    for (uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
        const NodeRef child = nodes_[parent].child[lowest_bit(rest)];
        append_items(child, items);
        node_count_before += count_nodes(child);
        ++most;
    }
    const uint32_t most_levels = std::max(levels(), max_built_levels) - level_of(parent);
    const uint32_t levels = std::min(most_levels, levels_for(static_cast<uint32_t>(items.size())));
    uint32_t height = 3 * (levels - 1);
    for (uint32_t parts = 2; parts <= most; parts *= 2) ++height;
    // So far down that not even halves would fit, all stays as it is.
    if (height < 32 && items.size() > uint64_t{leaf_size} << height) return;
    const BinaryBvh cuts(items, height, workers_);
    const Builder builder(items, cuts);
    Builder::Part parts[8];
    const uint32_t count = builder.divide(builder.whole(), levels, parts, most);
    uint32_t node_count = 0;
    for (uint32_t i = 0; i < count; ++i) node_count += builder.count_nodes(parts[i], levels);
    if (node_count > node_count_before) reserve_nodes(node_count - node_count_before);

    for (uint32_t lane = nodes_[parent].count; lane-- > 0;) {
        if ((lanes >> lane & 1) == 0) continue;
        release_below(nodes_[parent].child[lane]);
        drop(parent, lane);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const Builder::Laid laid = builder.lay(parts[i], levels, nodes_.data(), place_of_.data(), half_area(bounds_),
                                               [this] { return index_of(take_node(false)); });
        put(parent, nodes_[parent].count++, laid.ref, laid.box);
    }
    note_levels(parent);
    refit_upward(parent);
}

void Bvh8::append_items(NodeRef ref, Vector<BoxedItem>& to) const {
    if (ref == none) return;
    const Node& node = nodes_[index_of(ref)];
    for (uint32_t i = 0; i < node.count; ++i) {
        if (is_leaf(ref)) {
            to.push_back({node.boxes.lane(static_cast<int>(i)), node.child[i]});
        } else {
            append_items(node.child[i], to);
        }
    }
}

uint32_t Bvh8::count_nodes(NodeRef ref) const {
    uint32_t count = 1;
    const Node& node = nodes_[index_of(ref)];
    for (uint32_t i = 0; !is_leaf(ref) && i < node.count; ++i) count += count_nodes(node.child[i]);
    return count;
}

void Bvh8::release_below(NodeRef ref) {
    const Node& node = nodes_[index_of(ref)];
    for (uint32_t i = 0; !is_leaf(ref) && i < node.count; ++i) release_below(node.child[i]);
    release_node(index_of(ref));
}

}  // namespace gphys

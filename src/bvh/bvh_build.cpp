// Builds of the BVH: of all items, or of those below some children of a node. A binary BVH (binary_bvh.h) is collapsed
// to eight children per node. With workers, subtrees are built in parallel; the nodes have the same order as without.
#include "bvh/bvh_builder.h"
#include "foundation/compiler.h"
#include "foundation/workers.h"

namespace gphys {

Box Bvh8::union_of(const Node& node) {
    Box box;
    for (uint32_t i = 0; i < node.count; ++i) box.include(node.boxes.lane(static_cast<int>(i)));
    return box;
}

/// Workers write the subtrees below the two top levels. The nodes of these levels come first, then the subtrees one
/// after another; a first pass counts the nodes of each subtree.
Bvh8::Builder::BuiltSubtree Bvh8::Builder::write_all(LargeArray<Node>& nodes, uint32_t* item_lane,
                                                     const Workers* workers) const {
    struct Subtree {
        Range range;
        uint32_t levels, parent, lane;
        uint32_t first_node;
        BuiltSubtree built;
    };
    Subtree subtrees[64];
    uint32_t subtree_count = 1, top_parent[9], top_lane[9], top_size[9], top_count = 0;
    subtrees[0] = {all(), max_built_levels, none, 0, 0, {}};
    for (int level = 0; level < 2; ++level) {
        const uint32_t before = subtree_count;
        for (uint32_t s = 0; s < before; ++s) {
            const Subtree divided = subtrees[s];
            if (divided.range.is_leaf()) continue;
            Range ranges[8];
            const uint32_t top = top_count++, count = divide(divided.range, divided.levels - 1, ranges);
            top_parent[top] = divided.parent;
            top_lane[top] = divided.lane;
            top_size[top] = count;
            for (uint32_t i = 0; i < count; ++i) {
                const uint32_t place = i == 0 ? s : subtree_count++;
                subtrees[place] = {ranges[i], divided.levels - 1, top, i, 0, {}};
            }
        }
    }

    run(workers, subtree_count,
        [&](uint32_t s) { subtrees[s].first_node = count_nodes(subtrees[s].range, subtrees[s].levels); });
    uint32_t node_count = top_count;
    for (uint32_t s = 0; s < subtree_count; ++s) {
        const uint32_t count = subtrees[s].first_node;
        subtrees[s].first_node = node_count;
        node_count += count;
    }
    // Some more, so that the first insertions need no memory.
    nodes.reserve(node_count + node_count / 16);
    nodes.resize(node_count);

    const double root_area = half_area(gphys::union_of(items_.data(), items_.data() + items_.size()));
    run(workers, subtree_count, [&](uint32_t s) {
        uint32_t next = subtrees[s].first_node;
        subtrees[s].built =
            write(subtrees[s].range, subtrees[s].levels, nodes.data(), item_lane, root_area, [&] { return next++; });
    });

    BuiltSubtree tops[9];
    if (top_count == 0) return subtrees[0].built;
    for (uint32_t top = 0; top < top_count; ++top) {
        tops[top].ref = top;
        nodes[top].count = top_size[top];
    }
    for (uint32_t s = 0; s < subtree_count; ++s) {
        set_child(nodes.data(), subtrees[s].parent, subtrees[s].lane, subtrees[s].built, tops[subtrees[s].parent]);
    }
    for (uint32_t top = top_count; --top > 0;) {
        set_child(nodes.data(), top_parent[top], top_lane[top], tops[top], tops[top_parent[top]]);
    }
    return tops[0];
}

/// Replaces the tree. The new one is built separately and swapped in, so that a failed allocation changes nothing.
void Bvh8::build_from(Vector<BoxedItem>& items, size_t item_limit) {
    LargeArray<Node> nodes = nodes_.alike();
    LargeArray<uint32_t> item_lane = item_lane_.alike();
    item_lane.reserve(item_lane_.capacity());
    item_lane.resize(item_limit, none);
    Builder::BuiltSubtree built;
    if (!items.empty()) {
        const BinaryBvh binary(items, 3 * (max_built_levels - 1), workers_);
        // Keeps reserved capacity.
        nodes.reserve(nodes_.capacity());
        built = Builder(items, binary)
                    .write_all(nodes, item_lane.data(), items.size() < parallel_size ? nullptr : workers_);
        nodes[index_of(built.ref)].parent = none;
    }
    cancel_renewal();
    added_ = 0;
    if (size_ > 0) ++rebuilds_;
    nodes_.swap(nodes);
    item_lane_.swap(item_lane);
    root_ = built.ref;
    size_ = static_cast<uint32_t>(items.size());
    first_free_ = none;
    free_count_ = 0;
    bounds_ = built.box;
    built_root_area_ = half_area(bounds_);
    built_area_ = built_root_area_ + built.area;
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
    build_from(all, item_lane_.size());
}

/// Rebuilds some children of a node together, so that items can change between them. Their number does not grow: a full
/// parent would split at the next insertion.
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
    for (uint32_t ranges = 2; ranges <= most; ranges *= 2) ++height;
    // Too few levels left even for halving.
    if (height < 32 && items.size() > uint64_t{leaf_size} << height) return;
    // A parent of few items has fewer children than eight. With eight it would soon split, and so would those above it:
    // a tree of items that come in order would get narrow upper levels. At 32 items a child little is gained; at 64
    // trees of clusters that come and go cost 2 % more than with eight children.
    constexpr uint32_t items_of_child = 56;
    most = std::min(most, 1 + (static_cast<uint32_t>(items.size()) + items_of_child - 1) / items_of_child);
    const BinaryBvh binary(items, height, workers_);
    const Builder builder(items, binary);
    Builder::Range ranges[8];
    const uint32_t count = builder.divide(builder.all(), levels, ranges, most);
    uint32_t node_count = 0;
    for (uint32_t i = 0; i < count; ++i) node_count += builder.count_nodes(ranges[i], levels);
    if (node_count > node_count_before) reserve_nodes(node_count - node_count_before);

    for (uint32_t lane = nodes_[parent].count; lane-- > 0;) {
        if ((lanes >> lane & 1) == 0) continue;
        free_subtree(nodes_[parent].child[lane]);
        drop(parent, lane);
    }
    for (uint32_t i = 0; i < count; ++i) {
        const Builder::BuiltSubtree built =
            builder.write(ranges[i], levels, nodes_.data(), item_lane_.data(), half_area(bounds_),
                          [this] { return index_of(allocate_node(false)); });
        put(parent, nodes_[parent].count++, built.ref, built.box);
    }
    update_levels(parent);
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

void Bvh8::free_subtree(NodeRef ref) {
    const Node& node = nodes_[index_of(ref)];
    for (uint32_t i = 0; !is_leaf(ref) && i < node.count; ++i) free_subtree(node.child[i]);
    free_node(index_of(ref));
}

}  // namespace gphys

// Insertions, removals, moves and refits of the BVH. An item is inserted into the leaf whose box grows least. Full
// nodes split, upward to the root, so no order of insertions makes the tree deep (Guttman, "R-Trees: a Dynamic Index
// Structure for Spatial Searching", 1984). An item that moves is reinserted if its leaf has degraded; else the boxes
// above it are refitted. So each change costs O(levels), and all bounds stay tight. Splits alone degrade the tree over
// time: where enough was inserted, a part is rebuilt (bvh_rebuild.cpp).
#include <numeric>

#include "bvh/bvh8.h"
#include "foundation/compiler.h"
#include "foundation/workers.h"

namespace gphys {
namespace {

/// Both parts of a split node have at least three of the nine children: fewer would make sparse trees, more would leave
/// fewer candidates for the split.
constexpr uint64_t balanced_splits = 0b1111000;  // 3 to 6 of 9
constexpr uint32_t small_leaf = 2;

/// A leaf is degraded when its area has grown by this factor, absolutely or relative to the root's area, since a scene
/// may spread out or contract. A higher factor gives worse trees; a lower one more reinsertions, which cost about five
/// times a refit.
constexpr float degraded_growth = 1.5f;

/// No child is lifted in a smaller subtree: it is soon rebuilt as a whole.
constexpr uint32_t min_lift_items = 1024;

float smaller(float a, float b) { return a < b ? a : b; }
float larger(float a, float b) { return a > b ? a : b; }

void prefetch_node(const BvhNode& node) {
    const char* first = reinterpret_cast<const char*>(&node);
    for (size_t byte = 0; byte < sizeof node; byte += 64) prefetch(first + byte);
}

}  // namespace

/// Insertions keep leaves more than half full. With the inner nodes, that is at most one node for four items.
void Bvh8::reserve(uint32_t count) {
    item_lane_.reserve(count);
    nodes_.reserve(count / 4);
}

void Bvh8::reserve_nodes(uint32_t count) {
    if (count > free_count_) reserve_more(nodes_, count - free_count_);
}

/// A new child may split a node on each level, and add a level.
uint32_t Bvh8::nodes_for_additions(uint32_t additions) const { return additions * (levels() + additions); }

/// For optional changes inside functions that must not fail.
bool Bvh8::try_reserve_nodes(uint32_t additions) noexcept {
    if (levels() + additions > max_levels) return false;
    try {
        reserve_nodes(nodes_for_additions(additions));
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

/// Memory was reserved before.
Bvh8::NodeRef Bvh8::allocate_node(bool leaf) {
    uint32_t index = first_free_;
    if (index != none) {
        first_free_ = nodes_[index].parent;
        --free_count_;
        nodes_[index] = Node();
    } else {
        index = static_cast<uint32_t>(nodes_.size());
        nodes_.push_back(Node());
    }
    nodes_[index].parent = none;
    nodes_[index].levels = leaf ? 1 : 2;
    return leaf ? index | leaf_bit : index;
}

void Bvh8::free_node(uint32_t index) {
    nodes_[index].count = 0;
    nodes_[index].parent = first_free_;
    first_free_ = index;
    ++free_count_;
}

/// Stores `child` in a lane: an item in a leaf, else a NodeRef.
void Bvh8::put(NodeRef node, uint32_t lane, uint32_t child, const Box& box) {
    const uint32_t index = index_of(node);
    nodes_[index].boxes.set_lane(static_cast<int>(lane), box);
    nodes_[index].child[lane] = child;
    if (is_leaf(node)) {
        item_lane_[child] = 8 * index + lane;
    } else {
        nodes_[index_of(child)].parent = index;
        nodes_[index_of(child)].lane = lane;
    }
}

/// Removes a lane; the last one moves into it.
void Bvh8::drop(NodeRef node, uint32_t lane) {
    Node& n = nodes_[index_of(node)];
    const uint32_t last = --n.count;
    if (lane != last) put(node, lane, n.child[last], n.boxes.lane(static_cast<int>(last)));
}

/// Replaces a node by its only child.
void Bvh8::replace(uint32_t index, NodeRef by) {
    const uint32_t parent = nodes_[index].parent;
    if (parent == none) {
        nodes_[index_of(by)].parent = none;
        root_ = by;
    } else {
        put(parent, nodes_[index].lane, by, nodes_[index].boxes.lane(0));
    }
    free_node(index);
}

/// The leaf for a new item: descends to the child whose area grows least, of equal ones to the smallest. Counts the
/// item in the inner nodes.
Bvh8::NodeRef Bvh8::leaf_to_join(const Box& box) {
    NodeRef ref = root_;
    while (!is_leaf(ref)) {
        Node& node = nodes_[ref];
        ++node.items;
        ++node.added;
        const auto& row = node.boxes.row;
        // In float, for all eight: areas are far from overflow, and the choice need not be exact.
        float area[8], growth[8];
        for (int i = 0; i < 8; ++i) {
            const float x = row[3][i] - row[0][i], y = row[4][i] - row[1][i], z = row[5][i] - row[2][i];
            const float grown_x = larger(row[3][i], box.max[0]) - smaller(row[0][i], box.min[0]);
            const float grown_y = larger(row[4][i], box.max[1]) - smaller(row[1][i], box.min[1]);
            const float grown_z = larger(row[5][i], box.max[2]) - smaller(row[2][i], box.min[2]);
            area[i] = x * y + y * z + z * x;
            growth[i] = grown_x * grown_y + grown_y * grown_z + grown_z * grown_x - area[i];
        }
        uint32_t best = 0;
        for (uint32_t i = 1; i < node.count; ++i) {
            if (growth[i] < growth[best] || (growth[i] == growth[best] && area[i] < area[best])) best = i;
        }
        ref = node.child[best];
    }
    return ref;
}

/// After changes of a node's lanes: updates the boxes above, up to the first that stays the same.
void Bvh8::refit_upward(uint32_t index) {
    for (;;) {
        const Box box = union_of(nodes_[index]);
        const uint32_t parent = nodes_[index].parent, lane = nodes_[index].lane;
        if (parent == none) {
            bounds_ = box;
            return;
        }
        if (box == nodes_[parent].boxes.lane(static_cast<int>(lane))) return;
        nodes_[parent].boxes.set_lane(static_cast<int>(lane), box);
        index = parent;
    }
}

/// Computes all boxes below a node from those of the items. Returns the sum of half areas of the nodes below.
double Bvh8::refit_below(NodeRef ref, Box& box) {
    Node& node = nodes_[index_of(ref)];
    double area = 0;
    if (!is_leaf(ref)) {
        for (uint32_t i = 0; i < node.count; ++i) prefetch_node(nodes_[index_of(node.child[i])]);
        for (uint32_t i = 0; i < node.count; ++i) {
            Box child_box;
            area += refit_below(node.child[i], child_box);
            area += half_area(child_box);
            node.boxes.set_lane(static_cast<int>(i), child_box);
        }
    }
    kernels_.node_bounds(node, box);
    return area;
}

/// The same for the whole tree. Workers share the subtrees below the two top levels.
double Bvh8::refit() {
    uint32_t top[9], top_count = 0;
    NodeRef subtrees[64];
    double areas[64];
    uint32_t subtree_count = 0;
    if (!is_leaf(root_)) top[top_count++] = root_;
    for (uint32_t t = 0; t < top_count; ++t) {
        const Node& node = nodes_[top[t]];
        for (uint32_t i = 0; i < node.count; ++i) {
            if (t == 0 && !is_leaf(node.child[i])) {
                top[top_count++] = node.child[i];
            } else {
                subtrees[subtree_count++] = node.child[i];
            }
        }
    }
    run(size_ < parallel_size ? nullptr : workers_, subtree_count, [&](uint32_t s) {
        Box box;
        areas[s] = refit_below(subtrees[s], box);
        const Node& node = nodes_[index_of(subtrees[s])];
        nodes_[node.parent].boxes.set_lane(static_cast<int>(node.lane), box);
    });
    double area = std::accumulate(areas, areas + subtree_count, 0.0);
    for (uint32_t t = top_count; t-- > 0;) {
        const Node& node = nodes_[top[t]];
        for (uint32_t i = 0; i < node.count; ++i) area += half_area(node.boxes.lane(static_cast<int>(i)));
        if (t > 0) nodes_[node.parent].boxes.set_lane(static_cast<int>(node.lane), union_of(node));
    }
    bounds_ = union_of(nodes_[index_of(root_)]);
    return half_area(bounds_) + area;
}

void Bvh8::record_leaf_area(uint32_t leaf) {
    nodes_[leaf].built_area = static_cast<float>(half_area(union_of(nodes_[leaf])));
    nodes_[leaf].built_root_area = static_cast<float>(half_area(bounds_));
}

bool Bvh8::degraded(uint32_t leaf) const {
    const Node& node = nodes_[leaf];
    const double area = half_area(union_of(node)), built_area = double{degraded_growth} * node.built_area;
    return area > built_area || area * node.built_root_area > built_area * half_area(bounds_);
}

/// Divides the children of a full node and one more between the node and a new sibling, at least cost (SAH).
Bvh8::NodeRef Bvh8::split(NodeRef node, uint32_t child, const Box& box) {
    const uint32_t index = index_of(node);
    BoxedItem children[9];
    for (int i = 0; i < 8; ++i) children[i] = {nodes_[index].boxes.lane(i), nodes_[index].child[i]};
    children[8] = {box, child};
    const BoxedItem* middle = split_few(children, children + 9, balanced_splits, 1);
    const double added = is_leaf(node) ? 0 : added_share(node);
    const NodeRef sibling = allocate_node(is_leaf(node));
    nodes_[index].count = 0;
    for (const BoxedItem* i = children; i != children + 9; ++i) {
        const NodeRef home = i < middle ? node : sibling;
        put(home, nodes_[index_of(home)].count++, i->item, i->box);
    }
    for (const NodeRef half : {node, sibling}) {
        if (is_leaf(half)) {
            record_leaf_area(index_of(half));
        } else {
            count_below(half);
            set_added_share(half, added);
        }
    }
    return sibling;
}

/// Alternative to a split of a full node, for sorted input: items that arrive in order are all inserted at the same end
/// of the tree, and repeated splits would make that end deeper and deeper. If one of the nine children has more items
/// than the other eight together, the node keeps the eight, and `child` becomes the heavy one, for the parent.
bool Bvh8::lift(uint32_t node, uint32_t& child, Box& box) {
    uint32_t heaviest = none, most = items_below(nodes_[index_of(child)]), all = most;
    for (uint32_t i = 0; i < 8; ++i) {
        const uint32_t items = items_below(nodes_[index_of(nodes_[node].child[i])]);
        all += items;
        if (items > most) {
            most = items;
            heaviest = i;
        }
    }
    if (all < min_lift_items || most <= all / 2) return false;
    const double added = added_share(node);
    if (heaviest != none) {
        const NodeRef lifted = nodes_[node].child[heaviest];
        const Box lifted_box = nodes_[node].boxes.lane(static_cast<int>(heaviest));
        put(node, heaviest, child, box);
        child = lifted;
        box = lifted_box;
    }
    count_below(node);
    set_added_share(node, added);
    return true;
}

/// Adds a child to a node. A full node splits, and its parent gets a child. Memory was reserved before.
void Bvh8::add_child(NodeRef node, uint32_t child, Box box) {
    while (nodes_[index_of(node)].count == 8) {
        if (is_leaf(node) || !lift(node, child, box)) {
            child = split(node, child, box);
            box = union_of(nodes_[index_of(child)]);
        }
        const Box node_box = union_of(nodes_[index_of(node)]);
        if (node == root_) {
            root_ = allocate_node(false);
            nodes_[root_].count = 2;
            put(root_, 0, node, node_box);
            put(root_, 1, child, box);
            count_below(root_);
            bounds_ = union_of(nodes_[root_]);
            return;
        }
        const uint32_t parent = nodes_[index_of(node)].parent;
        nodes_[parent].boxes.set_lane(static_cast<int>(nodes_[index_of(node)].lane), node_box);
        node = parent;
    }
    put(node, nodes_[index_of(node)].count++, child, box);
    refit_upward(index_of(node));
}

/// Inserts an item. Memory was reserved before.
void Bvh8::attach(uint32_t item, const Box& box) {
    if (root_ == none) {
        root_ = allocate_node(true);
    }
    add_child(leaf_to_join(box), item, box);
    record_leaf_area(item_lane_[item] / 8);
    ++size_;
}

/// Removes an item. Returns the leaf that it was in, or none if the leaf was removed, too.
uint32_t Bvh8::detach(uint32_t item) {
    const uint32_t leaf = item_lane_[item] / 8;
    drop(leaf | leaf_bit, item_lane_[item] % 8);
    item_lane_[item] = none;
    --size_;
    for (uint32_t above = nodes_[leaf].parent; above != none; above = nodes_[above].parent) --nodes_[above].items;
    uint32_t index = leaf;
    // Removes nodes that have become empty.
    while (nodes_[index].count == 0 && nodes_[index].parent != none) {
        const uint32_t parent = nodes_[index].parent;
        drop(parent, nodes_[index].lane);
        free_node(index);
        index = parent;
    }
    if (nodes_[index].count == 0) {
        free_node(index);
        root_ = none;
        bounds_ = Box();
        return none;
    }
    refit_upward(index);
    if (index == leaf) return leaf;
    if (nodes_[index].count == 1) replace(index, nodes_[index].child[0]);
    return none;
}

/// Moves the items of a leaf with very few of them to other leaves, if memory permits.
void Bvh8::reinsert_small_leaf(uint32_t leaf) {
    if (leaf == none || nodes_[leaf].count > small_leaf || nodes_[leaf].parent == none) return;
    if (!try_reserve_nodes(small_leaf)) return;
    BoxedItem items[small_leaf];
    const uint32_t count = nodes_[leaf].count;
    for (uint32_t i = 0; i < count; ++i)
        items[i] = {nodes_[leaf].boxes.lane(static_cast<int>(i)), nodes_[leaf].child[i]};
    for (uint32_t i = 0; i < count; ++i) detach(items[i].item);
    for (uint32_t i = 0; i < count; ++i) attach(items[i].item, items[i].box);
}

/// Moves an item to the leaf that suits it best. Memory was reserved before. Returns as detach does.
uint32_t Bvh8::reinsert(uint32_t item) {
    const Box moving = box(item);
    const uint32_t leaf = detach(item);
    attach(item, moving);
    return leaf;
}

/// Recounts the items and levels of a node from its children.
void Bvh8::count_below(uint32_t index) {
    Node& node = nodes_[index];
    node.items = 0;
    for (uint32_t i = 0; i < node.count; ++i) node.items += items_below(nodes_[index_of(node.child[i])]);
    update_levels(index);
}

/// After changes of a node's children: recounts its levels, and raises those of the nodes above where needed.
void Bvh8::update_levels(uint32_t index) {
    Node& node = nodes_[index];
    node.levels = 2;
    for (uint32_t i = 0; i < node.count; ++i)
        node.levels = std::max(node.levels, 1 + nodes_[index_of(node.child[i])].levels);
    for (uint32_t below = index; nodes_[below].parent != none; below = nodes_[below].parent) {
        uint32_t& levels = nodes_[nodes_[below].parent].levels;
        if (levels > nodes_[below].levels) return;
        levels = nodes_[below].levels + 1;
    }
}

uint32_t Bvh8::level_of(uint32_t index) const {
    uint32_t level = 1;
    while ((index = nodes_[index].parent) != none) ++level;
    return level;
}

void Bvh8::insert(uint32_t item, const Box& box) {
    // Whatever can fail comes first.
    if (item >= item_lane_.size()) {
        reserve_more(item_lane_, item + size_t{1} - item_lane_.size());
        item_lane_.resize(size_t{item} + 1, none);
    }
    if (levels() >= max_levels) rebuild();
    reserve_nodes(nodes_for_additions(1));
    attach(item, box);
    rebuild_around(item);
    note_change(item, Change::addition);
}

void Bvh8::insert_many(const uint32_t* items, const Box* boxes, uint32_t count) {
    if (count > size_ / 4) {
        Vector<BoxedItem> all(nodes_.memory());
        all.reserve(size_t{size_} + count);
        append_items(root_, all);
        size_t limit = item_lane_.size();
        for (uint32_t i = 0; i < count; ++i) {
            all.push_back({boxes[i], items[i]});
            limit = std::max(limit, size_t{items[i]} + 1);
        }
        build_from(all, limit);
        return;
    }
    uint32_t done = 0;
    try {
        for (; done < count; ++done) insert(items[done], boxes[done]);
    } catch (...) {
        while (done > 0) remove(items[--done]);
        throw;
    }
}

void Bvh8::remove(uint32_t item) noexcept {
    reinsert_small_leaf(detach(item));
    note_change(item, Change::removal);
}

/// Reinserts the item if its new box is apart from its leaf's, or if the leaf has degraded; else refits.
void Bvh8::update(uint32_t item, const Box& box) noexcept {
    const uint32_t leaf = item_lane_[item] / 8;
    const bool stays_near = overlaps(box_of(leaf), box);
    bool is_relocated = !overlaps(this->box(item), box);
    nodes_[leaf].boxes.set_lane(static_cast<int>(item_lane_[item] % 8), box);
    if ((!stays_near || degraded(leaf)) && try_reserve_nodes(1)) {
        reinsert_small_leaf(reinsert(item));
        is_relocated = true;
    } else {
        refit_upward(leaf);
        // The leaf may not be the best one for the new place: counts as an insertion.
        for (uint32_t above = nodes_[leaf].parent; is_relocated && above != none; above = nodes_[above].parent)
            ++nodes_[above].added;
    }
    rebuild_around(item);
    note_change(item, is_relocated ? Change::relocation : Change::move);
}

void Bvh8::clear() noexcept {
    cancel_renewal();
    added_ = 0;
    nodes_.clear();
    std::fill(item_lane_.begin(), item_lane_.end(), none);
    root_ = none;
    bounds_ = Box();
    size_ = 0;
    first_free_ = none;
    free_count_ = 0;
    built_area_ = built_root_area_ = 0;
    budget_ = 0;
}

}  // namespace gphys

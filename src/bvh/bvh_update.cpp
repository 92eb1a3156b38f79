// Changing the BVH. Items enter at the leaf whose box grows least; what is full splits, upward to
// the root, so that no order of insertions makes a tree deep (Guttman, "R-Trees: a Dynamic Index
// Structure for Spatial Searching", 1984). Leaves that moving items have stretched give them up one
// by one to better ones. So each change costs O(levels), and all bounds stay tight. Where enough has been added, a part
// of the tree is built again (bvh_rebuild.cpp).
#include <numeric>

#include "bvh/bvh8.h"
#include "foundation/compiler.h"
#include "foundation/workers.h"

namespace gphys {

namespace {

/// Both parts of a node that splits have at least three children: fewer would make sparse trees, and
/// leave less choice of where to cut.
constexpr uint64_t balanced_cuts = 0b1111000;  // 3 to 6 of 9
constexpr uint32_t small_leaf = 2;

/// A leaf is degraded when its area, absolutely or as a share of the root's (a scene may spread out or
/// draw together), has grown by this. Higher: worse trees; lower: more items are placed anew, which
/// costs about five times a refit.
constexpr float spoiling_growth = 1.5f;

/// In parts of fewer items no child is lifted: they are soon built again as a whole.
constexpr uint32_t lifted_from = 1024;

float smaller(float a, float b) { return a < b ? a : b; }
float larger(float a, float b) { return a > b ? a : b; }

void fetch_ahead(const BvhNode& node) {
    const char* first = reinterpret_cast<const char*>(&node);
    for (size_t byte = 0; byte < sizeof node; byte += 64) prefetch(first + byte);
}

}  // namespace

/// Insertions leave leaves that are more than half full: with the nodes above them one for four items.
void Bvh8::reserve(uint32_t count) {
    place_of_.reserve(count);
    nodes_.reserve(count / 4);
}

void Bvh8::reserve_nodes(uint32_t count) {
    if (count > free_count_) reserve_more(nodes_, count - free_count_);
}

/// A new child may split each level, and add one.
uint32_t Bvh8::nodes_for_additions(uint32_t additions) const { return additions * (levels() + additions); }

/// For changes that must not fail, and can be left undone.
bool Bvh8::have_room(uint32_t additions) noexcept {
    if (levels() + additions > max_levels) return false;
    try {
        reserve_nodes(nodes_for_additions(additions));
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

/// Room must have been reserved.
Bvh8::NodeRef Bvh8::take_node(bool leaf) {
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

void Bvh8::release_node(uint32_t index) {
    nodes_[index].count = 0;
    nodes_[index].parent = first_free_;
    first_free_ = index;
    ++free_count_;
}

/// Make `child`, an item in a leaf and a NodeRef otherwise, the occupant of a lane.
void Bvh8::put(NodeRef node, uint32_t lane, uint32_t child, const Box& box) {
    const uint32_t index = index_of(node);
    nodes_[index].boxes.set_lane(static_cast<int>(lane), box);
    nodes_[index].child[lane] = child;
    if (is_leaf(node)) {
        place_of_[child] = 8 * index + lane;
    } else {
        nodes_[index_of(child)].parent = index;
        nodes_[index_of(child)].lane = lane;
    }
}

/// Give up a lane; the last one moves into it.
void Bvh8::drop(NodeRef node, uint32_t lane) {
    Node& n = nodes_[index_of(node)];
    const uint32_t last = --n.count;
    if (lane != last) put(node, lane, n.child[last], n.boxes.lane(static_cast<int>(last)));
}

/// A child takes the place of its parent, whose only one it is.
void Bvh8::replace(uint32_t index, NodeRef by) {
    const uint32_t parent = nodes_[index].parent;
    if (parent == none) {
        nodes_[index_of(by)].parent = none;
        root_ = by;
    } else {
        put(parent, nodes_[index].lane, by, nodes_[index].boxes.lane(0));
    }
    release_node(index);
}

/// The leaf reached by always taking the child whose area grows least, and of those the smallest. It will get an item.
Bvh8::NodeRef Bvh8::leaf_to_join(const Box& box) {
    NodeRef ref = root_;
    while (!is_leaf(ref)) {
        Node& node = nodes_[ref];
        ++node.items;
        ++node.added;
        const auto& row = node.boxes.row;
        // In float for all eight: areas are far from overflow, and which child it is need not be exact.
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

/// The lanes of a node have changed: pass its new box on, as far up as it makes a difference.
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

/// Recompute all boxes below a node from those of the items; returns the area of all nodes there.
double Bvh8::refit_below(NodeRef ref, Box& box) {
    Node& node = nodes_[index_of(ref)];
    double area = 0;
    if (!is_leaf(ref)) {
        for (uint32_t i = 0; i < node.count; ++i) fetch_ahead(nodes_[index_of(node.child[i])]);
        for (uint32_t i = 0; i < node.count; ++i) {
            Box child_box;
            area += refit_below(node.child[i], child_box);
            area += half_area(child_box);
            node.boxes.set_lane(static_cast<int>(i), child_box);
        }
    }
    kernels_.around(node, box);
    return area;
}

/// The same for the whole tree, the subtrees below two levels of nodes being shared.
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
    run(size_ < shared_size ? nullptr : workers_, subtree_count, [&](uint32_t s) {
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

void Bvh8::note_made(uint32_t leaf) {
    nodes_[leaf].made_area = static_cast<float>(half_area(union_of(nodes_[leaf])));
    nodes_[leaf].made_root_area = static_cast<float>(half_area(bounds_));
}

bool Bvh8::degraded(uint32_t leaf) const {
    const Node& node = nodes_[leaf];
    const double area = half_area(union_of(node)), made_area = double{spoiling_growth} * node.made_area;
    return area > made_area || area * node.made_root_area > made_area * half_area(bounds_);
}

/// Part a full node and one child more into the node and a new sibling, where their areas are least.
Bvh8::NodeRef Bvh8::split(NodeRef node, uint32_t child, const Box& box) {
    const uint32_t index = index_of(node);
    BoxedItem children[9];
    for (int i = 0; i < 8; ++i) children[i] = {nodes_[index].boxes.lane(i), nodes_[index].child[i]};
    children[8] = {box, child};
    const BoxedItem* middle = split_few(children, children + 9, balanced_cuts, 1);
    const double added = is_leaf(node) ? 0 : added_share(node);
    const NodeRef sibling = take_node(is_leaf(node));
    nodes_[index].count = 0;
    for (const BoxedItem* i = children; i != children + 9; ++i) {
        const NodeRef home = i < middle ? node : sibling;
        put(home, nodes_[index_of(home)].count++, i->item, i->box);
    }
    for (const NodeRef half : {node, sibling}) {
        if (is_leaf(half)) {
            note_made(index_of(half));
        } else {
            count_below(half);
            note_added(half, added);
        }
    }
    return sibling;
}

/// If one of the children of a full node and `child` has more items than all others together, `child` becomes that one,
/// to go to the parent, and the others stay. Where items come in order, each is added to the same end of the tree: to
/// split there would leave that end one level deeper below a few others again and again.
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
    if (all < lifted_from || most <= all / 2) return false;
    const double added = added_share(node);
    if (heaviest != none) {
        const NodeRef lifted = nodes_[node].child[heaviest];
        const Box lifted_box = nodes_[node].boxes.lane(static_cast<int>(heaviest));
        put(node, heaviest, child, box);
        child = lifted;
        box = lifted_box;
    }
    count_below(node);
    note_added(node, added);
    return true;
}

/// Give a node one child more. What is full gives its parent one child more. There is room.
void Bvh8::add_child(NodeRef node, uint32_t child, Box box) {
    while (nodes_[index_of(node)].count == 8) {
        if (is_leaf(node) || !lift(node, child, box)) {
            child = split(node, child, box);
            box = union_of(nodes_[index_of(child)]);
        }
        const Box node_box = union_of(nodes_[index_of(node)]);
        if (node == root_) {
            root_ = take_node(false);
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

/// Put an item into the tree, for which there is room.
void Bvh8::attach(uint32_t item, const Box& box) {
    if (root_ == none) {
        root_ = take_node(true);
    }
    add_child(leaf_to_join(box), item, box);
    note_made(place_of_[item] / 8);
    ++size_;
}

/// Take an item out of the tree and return the leaf that it was in, or none if that has gone too.
uint32_t Bvh8::detach(uint32_t item) {
    const uint32_t leaf = place_of_[item] / 8;
    drop(leaf | leaf_bit, place_of_[item] % 8);
    place_of_[item] = none;
    --size_;
    for (uint32_t above = nodes_[leaf].parent; above != none; above = nodes_[above].parent) --nodes_[above].items;
    uint32_t index = leaf;
    // Nodes that have become empty go, up to one that has not.
    while (nodes_[index].count == 0 && nodes_[index].parent != none) {
        const uint32_t parent = nodes_[index].parent;
        drop(parent, nodes_[index].lane);
        release_node(index);
        index = parent;
    }
    if (nodes_[index].count == 0) {
        release_node(index);
        root_ = none;
        bounds_ = Box();
        return none;
    }
    refit_upward(index);
    if (index == leaf) return leaf;
    if (nodes_[index].count == 1) replace(index, nodes_[index].child[0]);
    return none;
}

/// A leaf of very few items is not worth its node: they go elsewhere, if that needs no memory.
void Bvh8::dissolve_if_small(uint32_t leaf) {
    if (leaf == none || nodes_[leaf].count > small_leaf || nodes_[leaf].parent == none) return;
    if (!have_room(small_leaf)) return;
    BoxedItem items[small_leaf];
    const uint32_t count = nodes_[leaf].count;
    for (uint32_t i = 0; i < count; ++i)
        items[i] = {nodes_[leaf].boxes.lane(static_cast<int>(i)), nodes_[leaf].child[i]};
    for (uint32_t i = 0; i < count; ++i) detach(items[i].item);
    for (uint32_t i = 0; i < count; ++i) attach(items[i].item, items[i].box);
}

/// Find a better leaf for an item, for which there is room; returns as detach does.
uint32_t Bvh8::reinsert(uint32_t item) {
    const Box moving = box(item);
    const uint32_t leaf = detach(item);
    attach(item, moving);
    return leaf;
}

/// What is below a node, from what its children know of themselves.
void Bvh8::count_below(uint32_t index) {
    Node& node = nodes_[index];
    node.items = 0;
    for (uint32_t i = 0; i < node.count; ++i) node.items += items_below(nodes_[index_of(node.child[i])]);
    note_levels(index);
}

/// The children of a node have changed: how many levels it has, and how many those above have at least.
void Bvh8::note_levels(uint32_t index) {
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
    // All that can fail comes first.
    if (item >= place_of_.size()) {
        reserve_more(place_of_, item + size_t{1} - place_of_.size());
        place_of_.resize(size_t{item} + 1, none);
    }
    if (levels() >= max_levels) rebuild();
    reserve_nodes(nodes_for_additions(1));
    attach(item, box);
    renew_around(item);
}

void Bvh8::insert_many(const uint32_t* items, const Box* boxes, uint32_t count) {
    if (count > size_ / 4) {
        Vector<BoxedItem> all(nodes_.memory());
        all.reserve(size_t{size_} + count);
        append_items(root_, all);
        size_t limit = place_of_.size();
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

void Bvh8::remove(uint32_t item) noexcept { dissolve_if_small(detach(item)); }

/// What has left its neighbours at once, or with them has stretched their leaf, goes to a better one.
void Bvh8::update(uint32_t item, const Box& box) noexcept {
    const uint32_t leaf = place_of_[item] / 8;
    const bool stays_near = overlaps(box_of(leaf), box), jumps = !overlaps(this->box(item), box);
    nodes_[leaf].boxes.set_lane(static_cast<int>(place_of_[item] % 8), box);
    if ((!stays_near || degraded(leaf)) && have_room(1)) {
        dissolve_if_small(reinsert(item));
    } else {
        refit_upward(leaf);
        // Another place in the same leaf, which may not be the best: as if it had been added there.
        for (uint32_t above = nodes_[leaf].parent; jumps && above != none; above = nodes_[above].parent)
            ++nodes_[above].added;
    }
    renew_around(item);
}

void Bvh8::clear() noexcept {
    nodes_.clear();
    std::fill(place_of_.begin(), place_of_.end(), none);
    root_ = none;
    bounds_ = Box();
    size_ = 0;
    first_free_ = none;
    free_count_ = 0;
    built_area_ = built_root_area_ = 0;
    credit_ = 0;
}

}  // namespace gphys

// Changing the octree: insertion by least growth of area, removal, and refits that keep all bounds
// tight. Each change leaves a sound tree; whether it is still a good one is measured by its area.
#include "octree/octree.h"

namespace gphys {

void Octree::reserve_nodes(uint32_t count) {
    if (free_count_ >= count) return;
    const size_t needed = nodes_.size() + (count - free_count_);
    if (needed > nodes_.capacity()) nodes_.reserve(std::max(needed, nodes_.capacity() * 2));
}

/// Room must have been reserved.
Octree::NodeRef Octree::take_node(bool leaf) {
    uint32_t index = first_free_;
    if (index != none) {
        first_free_ = nodes_[index].parent;
        --free_count_;
        nodes_[index] = Node();
    } else {
        index = static_cast<uint32_t>(nodes_.size());
        nodes_.emplace_back();
    }
    nodes_[index].parent = none;
    return leaf ? index | leaf_bit : index;
}

void Octree::release_node(uint32_t index) {
    nodes_[index].count = 0;
    nodes_[index].parent = first_free_;
    first_free_ = index;
    ++free_count_;
}

/// Make `child`, an item in a leaf and a NodeRef otherwise, the occupant of a lane.
void Octree::put(NodeRef node, uint32_t lane, uint32_t child, const Box& box) {
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
void Octree::drop(NodeRef node, uint32_t lane) {
    Node& n = nodes_[index_of(node)];
    const uint32_t last = --n.count;
    if (lane != last) put(node, lane, n.child[last], n.boxes.lane(static_cast<int>(last)));
}

/// The leaf reached by always taking the child whose area grows least.
Octree::NodeRef Octree::closest_leaf(const Box& box) const {
    NodeRef ref = root_;
    while (!is_leaf(ref)) {
        const Node& node = nodes_[ref];
        double least_growth = infinity, least_area = infinity;
        for (uint32_t i = 0; i < node.count; ++i) {
            Box grown = node.boxes.lane(static_cast<int>(i));
            const double area = half_area(grown);
            grown.include(box);
            const double growth = half_area(grown) - area;
            if (growth < least_growth || (growth == least_growth && area < least_area)) {
                least_growth = growth;
                least_area = area;
                ref = node.child[i];
            }
        }
    }
    return ref;
}

int Octree::level_of(uint32_t index) const {
    int level = 0;
    while ((index = nodes_[index].parent) != none) ++level;
    return level;
}

/// The lanes of a node have changed: pass its new box on, as far up as it makes a difference.
void Octree::refit_upward(uint32_t index) {
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

/// Recompute all boxes below a node from those of the items.
Box Octree::refit_below(NodeRef ref) {
    Node& node = nodes_[index_of(ref)];
    if (!is_leaf(ref)) {
        for (uint32_t i = 0; i < node.count; ++i) {
            node.boxes.set_lane(static_cast<int>(i), refit_below(node.child[i]));
        }
    }
    return union_of(node);
}

/// Put an item into a leaf that is not too deep for it. Needs room for two nodes.
void Octree::attach(NodeRef leaf, uint32_t item, const Box& box) {
    ++size_;
    Node& node = nodes_[index_of(leaf)];
    if (node.count < 8) {
        put(leaf, node.count++, item, box);
        refit_upward(index_of(leaf));
    } else {
        split(leaf, item, box);
    }
}

void Octree::detach(uint32_t item) {
    uint32_t index = place_of_[item] / 8;
    drop(index | leaf_bit, place_of_[item] % 8);
    place_of_[item] = none;
    --size_;
    // Nodes that have become empty go, up to one that has not.
    while (nodes_[index].count == 0 && nodes_[index].parent != none) {
        const uint32_t parent = nodes_[index].parent;
        drop(parent, nodes_[index].lane);
        release_node(index);
        index = parent;
    }
    if (nodes_[index].count > 0) {
        refit_upward(index);
    } else {
        release_node(index);
        root_ = none;
        bounds_ = Box();
    }
}

/// A full leaf may become two below a new node.
bool Octree::too_deep(NodeRef leaf) const {
    return nodes_[index_of(leaf)].count == 8 && level_of(index_of(leaf)) + 1 >= max_levels;
}

void Octree::insert(uint32_t item, const Box& box) {
    // All that can fail comes first.
    if (item >= place_of_.size()) {
        if (item >= place_of_.capacity()) place_of_.reserve(std::max(size_t{item} + 1, place_of_.capacity() * 2));
        place_of_.resize(size_t{item} + 1, none);
    }
    if (root_ != none && too_deep(closest_leaf(box))) rebuild();
    reserve_nodes(2);

    if (root_ == none) root_ = take_node(true);
    attach(closest_leaf(box), item, box);
    ++changes_;
    improve();
}

void Octree::insert_many(const uint32_t* items, const Box* boxes, uint32_t count) {
    if (count > size_ / 4) {
        Vector<BoxedItem> all(nodes_.get_allocator());
        all.reserve(size_t{size_} + count);
        append_items(all);
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

void Octree::remove(uint32_t item) noexcept {
    detach(item);
    ++changes_;
    improve();
}

void Octree::update(uint32_t item, const Box& box) noexcept {
    const uint32_t index = place_of_[item] / 8, lane = place_of_[item] % 8;
    // An item that has left its neighbours would stretch their leaf over the way: it moves to others
    // if that needs no memory.
    const bool room = free_count_ + nodes_.capacity() - nodes_.size() >= 2;
    const NodeRef leaf = room && !overlaps(union_of(nodes_[index]), box) ? closest_leaf(box) : index | leaf_bit;
    if (index_of(leaf) != index && !too_deep(leaf)) {
        detach(item);
        attach(leaf, item, box);
    } else {
        nodes_[index].boxes.set_lane(static_cast<int>(lane), box);
        refit_upward(index);
    }
    ++changes_;
    improve();
}

void Octree::refit_all(uint32_t changes) noexcept {
    if (root_ == none) return;
    bounds_ = refit_below(root_);
    changes_ += changes;
    improve();
}

void Octree::clear() noexcept {
    nodes_.clear();
    std::fill(place_of_.begin(), place_of_.end(), none);
    root_ = none;
    bounds_ = Box();
    size_ = 0;
    first_free_ = none;
    free_count_ = 0;
    built_area_ = built_root_area_ = 0;
    built_size_ = 0;
    changes_ = 0;
}

/// The number of nodes that a random ray through the root visits, times the root's area.
double Octree::area_below(NodeRef ref) const {
    if (is_leaf(ref)) return 0;
    const Node& node = nodes_[ref];
    double area = 0;
    for (uint32_t i = 0; i < node.count; ++i) {
        area += half_area(node.boxes.lane(static_cast<int>(i))) + area_below(node.child[i]);
    }
    return area;
}

/// Whether a build would pay: twice the area means about twice the nodes that a ray visits, counted
/// both absolutely and against the root (a scene may spread out or draw together).
bool Octree::degraded() const {
    const double root_area = half_area(bounds_);
    const double area = root_ == none ? 0 : root_area + area_below(root_);
    return area > 2 * built_area_ || area * built_root_area_ > 2 * built_area_ * root_area || size_ < built_size_ / 2;
}

/// Look at the tree's quality each time that a quarter of the items has changed, so that looking
/// and building add a bounded cost to each change.
void Octree::improve() noexcept {
    if (changes_ <= size_ / 4) return;
    changes_ = 0;
    if (!degraded()) return;
    try {
        rebuild();
    } catch (const std::bad_alloc&) {
        return;  // the tree is as sound as before; the next look tries again
    }
}

}  // namespace gphys

// An eight-wide BVH over AABBs and small integers, the items: slots of a scene, or packets of triangles.
//
// It is a bounding volume hierarchy (BVH), built by the surface area heuristic: three binary splits a level make eight
// children. It plays the part of the octree in the Game Physics Cookbook, and the public functions keep that name. An
// octree cuts space at the centre of each cell; here the items are cut by expected cost, with far less overlap. Each
// item is in exactly one leaf, so no query visits it twice, and the root grows with its items, so nothing is outside.
//
// A node keeps the boxes of its children side by side, and kernels test them together
// (bvh_kernels.h). Leaves are nodes whose children are items. All bounds are tight at all times.
#pragma once

#include "bvh/bvh_kernels.h"
#include "bvh/bvh_layout.h"
#include "bvh/sah.h"
#include "foundation/large_array.h"

namespace gphys {

class Workers;

class Bvh8 {
public:
    static constexpr uint32_t none = bvh_none;
    /// Building makes at most `max_built_levels`; an insertion that would go beyond `max_levels`
    /// rebuilds first.
    static constexpr uint32_t max_levels = bvh_max_levels;
    static constexpr uint32_t max_built_levels = 24;

    /// Workers share building, and moving many; null: the caller's thread does it all. The tree is
    /// the same for any number of them.
    template <class Source>  // as of LargeArray
    explicit Bvh8(Source* memory, Isa isa = chosen_isa(), const Workers* workers = nullptr)
        : kernels_(bvh_kernels(isa)), workers_(workers), nodes_(memory), place_of_(memory) {}

    // Changes. Boxes are within max_box_coordinate, items are small: memory is used for each number
    // up to the largest. What throws std::bad_alloc has changed nothing; what is noexcept cannot
    // fail, it leaves out an improvement of the tree if there is no memory for it.

    /// Memory for items below `count` that are inserted one by one.
    void reserve(uint32_t count);
    /// Rebuild with `count` distinct items.
    void build(const Box* boxes, const uint32_t* items, uint32_t count);
    /// The same in the form of a layout without a defect; boxes in the order of its items.
    void build(const BvhLayout& layout, const Box* boxes);
    /// With the same items.
    void rebuild();
    void insert(uint32_t item, const Box& box);
    /// Many at once: a build if they are many for this tree.
    void insert_many(const uint32_t* items, const Box* boxes, uint32_t count);
    void remove(uint32_t item) noexcept;
    void update(uint32_t item, const Box& box) noexcept;
    /// Many at once, with one refit of the whole tree if `count`, which may be rough, is large for
    /// it: moves(put, on_any_thread) calls put(item, box) for each, which tasks may do side by side
    /// for different items if on_any_thread is true.
    template <class Moves>
    void update_many(uint32_t count, Moves&& moves) noexcept;
    void clear() noexcept;

    bool contains(uint32_t item) const { return item < place_of_.size() && place_of_[item] != none; }
    Box box(uint32_t item) const { return node_of(item).boxes.lane(static_cast<int>(place_of_[item] % 8)); }
    Box bounds() const { return bounds_; }
    uint32_t size() const { return size_; }

    // Queries. Visitors get items whose boxes meet the query, and in rare cases more; never fewer.

    /// Roughly nearest first. visit(item, t_max) may lower t_max; a negative one ends the query.
    /// Boxes entered exactly at t_max are still visited. A direction of zero asks for the boxes
    /// around the origin.
    template <class Visit>
    void raycast(const Ray& ray, double t_max, Visit&& visit, ItemMemory items = {}) const;
    /// Up to rays_at_once rays. Neighbours that go much the same way are a packet; the others are
    /// interleaved, so that none waits for memory. visit(numbers, items, count) is for up to eight rays, each with
    /// an item, cuts short what it will of them, and tells which: bit k of the result is for rays[numbers[k]].
    /// A ray may visit an item twice: with its neighbours, and again by itself where they turn out to have too
    /// little in common.
    static constexpr uint32_t rays_at_once = bvh_most_rays;
    template <class Visit>
    void raycast_many(const Ray* rays, uint32_t count, Visit&& visit, ItemMemory items = {}) const;
    /// The same in no order, for visits that end a ray, by a t_max below zero, or leave it as it is.
    template <class Visit>
    void raycast_any_many(const Ray* rays, uint32_t count, Visit&& visit, ItemMemory items = {}) const;
    /// In no order, until visit(item) is true for one: then the result is.
    template <class Visit>
    bool raycast_any(const Ray& ray, Visit&& visit, ItemMemory items = {}) const;
    /// As raycast, for a sphere that moves from `center` to center + displacement, t = 0..1.
    template <class Visit>
    void sweep(Vec3 center, Vec3 displacement, double radius, Visit&& visit, ItemMemory items = {}) const;
    /// The same for a box that reaches so far on each axis.
    template <class Visit>
    void sweep(Vec3 middle, Vec3 displacement, Vec3 half, Visit&& visit, ItemMemory items = {}) const;
    /// Roughly nearest first. visit(item, max_distance) may lower max_distance; a negative one ends
    /// the query.
    template <class Visit>
    void nearest(Vec3 point, double max_distance, Visit&& visit, ItemMemory items = {}) const;
    /// The same with a probe of the bounds.
    template <class Visit>
    void nearest(const WeightedPointProbe& probe, double max_distance, Visit&& visit) const;
    /// visit(item, wholly_inside), or visit(items, count, wholly_inside) for several, or visit(items, count)
    /// if that is of no use, returns whether to go on; the result is false if one did not.
    /// `items_inside` is what it reads of those wholly inside.
    template <class Visit>
    bool overlap_box(const Box& box, Visit&& visit, ItemMemory items = {}, ItemMemory items_inside = {}) const;
    template <class Visit>
    bool overlap_ball(Vec3 center, double radius, Visit&& visit, ItemMemory items = {},
                      ItemMemory items_inside = {}) const;
    /// The same for up to OverlapItems::most_queries boxes or balls, interleaved. A query that is not complete is for
    /// overlap_box or overlap_ball.
    void overlap_boxes(const Box* boxes, uint32_t count, ItemMemory items, ItemMemory items_inside,
                       OverlapItems* found) const;
    void overlap_balls(const Sphere* balls, uint32_t count, ItemMemory items, ItemMemory items_inside,
                       OverlapItems* found) const;
    /// visit(item), for any test of boxes: touches(box) must be true for each box that holds what the
    /// query wants.
    template <class Touches, class Visit>
    bool overlap(Touches&& touches, Visit&& visit) const;
    /// `around` holds the frustum; the tighter, the better.
    template <class Visit>
    bool frustum(const Frustum& frustum, const Box& around, Visit&& visit, ItemMemory items = {},
                 ItemMemory items_inside = {}) const;
    /// All pairs of items of two trees whose boxes overlap: visit(item, other_item) returns whether
    /// to go on.
    template <class Visit>
    bool overlap_pairs(const Bvh8& other, Visit&& visit) const;

    uint32_t node_count() const { return root_ == none ? 0 : count_nodes(root_); }
    /// The tree's layout: visit_node(word) for each node and visit_item(item) for each item, in the layout's order.
    template <class VisitNode, class VisitItem>
    void visit_layout(VisitNode&& visit_node, VisitItem&& visit_item) const {
        if (root_ != none) visit_layout_below(root_, visit_node, visit_item);
    }

    // For kernels that bring tests of their own items; only while the tree is not empty.
    const BvhNode* nodes() const { return nodes_.data(); }
    uint32_t root() const { return root_; }

    gphys_octree_stats stats() const;
    /// Each node's box, parents first: visit(gphys_octree_box).
    template <class Visit>
    void for_each_box(Visit&& visit) const {
        for_each_box(visit, [](uint32_t, const gphys_octree_box&) {});
    }
    /// And each item's after that of its leaf: visit_item(item, gphys_octree_box).
    template <class Visit, class VisitItem>
    void for_each_box(Visit&& visit, VisitItem&& visit_item) const;
    /// What is wrong with the tree, or nullptr; for tests.
    const char* defect() const;

private:
    using Node = BvhNode;
    using NodeRef = uint32_t;
    static constexpr NodeRef leaf_bit = bvh_leaf_bit;
    static uint32_t index_of(NodeRef ref) { return ref & ~leaf_bit; }
    static bool is_leaf(NodeRef ref) { return (ref & leaf_bit) != 0; }

    /// More changes than this part of all items are one refit of the whole tree.
    static constexpr uint32_t many = 8;
    /// Trees of fewer items are refitted before a second thread has come.
    static constexpr uint32_t shared_size = 8192;

    class Builder;

    static uint32_t items_below(const Node& node) { return node.levels == 1 ? node.count : node.items; }
    uint32_t levels() const { return root_ == none ? 0 : nodes_[index_of(root_)].levels; }
    /// That a part of so many items may have when it is built again: two more than with nodes half full.
    static uint32_t levels_for(uint32_t items) {
        uint32_t levels = 3;
        for (uint32_t room = 4; room < items; room *= 4) ++levels;
        return levels;
    }
    const Node& node_of(uint32_t item) const { return nodes_[place_of_[item] / 8]; }
    static Box union_of(const Node& node);
    Box box_of(uint32_t index) const {
        const Node& node = nodes_[index];
        return node.parent == none ? bounds_ : nodes_[node.parent].boxes.lane(static_cast<int>(node.lane));
    }

    template <class VisitNode, class VisitItem>
    void visit_layout_below(NodeRef ref, VisitNode& visit_node, VisitItem& visit_item) const;

    void build_from(Vector<BoxedItem>& items, size_t item_limit);
    void rebuild_children(uint32_t parent, uint32_t lanes);
    void append_items(NodeRef ref, Vector<BoxedItem>& to) const;
    uint32_t count_nodes(NodeRef ref) const;
    void release_below(NodeRef ref);

    void reserve_nodes(uint32_t count);
    uint32_t nodes_for_additions(uint32_t additions) const;
    bool have_room(uint32_t additions) noexcept;
    NodeRef take_node(bool leaf);
    void release_node(uint32_t index);
    void put(NodeRef node, uint32_t lane, uint32_t child, const Box& box);
    void drop(NodeRef node, uint32_t lane);
    void replace(uint32_t index, NodeRef by);
    NodeRef leaf_to_join(const Box& box);
    NodeRef split(NodeRef node, uint32_t child, const Box& box);
    void add_child(NodeRef node, uint32_t child, Box box);
    void refit_upward(uint32_t index);
    void note_made(uint32_t leaf);
    void note_levels(uint32_t index);
    void count_below(uint32_t index);
    /// Of the items below a node the part that has been added since it was built.
    double added_share(uint32_t index) const { return static_cast<double>(nodes_[index].added) / nodes_[index].items; }
    void note_added(uint32_t index, double share) {
        nodes_[index].added = static_cast<uint32_t>(share * nodes_[index].items);
    }
    bool lift(uint32_t node, uint32_t& child, Box& box);
    bool degraded(uint32_t leaf) const;
    void attach(uint32_t item, const Box& box);
    uint32_t detach(uint32_t item);
    uint32_t reinsert(uint32_t item);
    void dissolve_if_small(uint32_t leaf);

    double refit();
    double refit_below(NodeRef ref, Box& box);

    void refit_all(uint32_t changes) noexcept;
    bool grown(double area, double factor) const;
    void renew_around(uint32_t item) noexcept;
    void renew_in_turn(uint32_t changes);

    uint32_t level_of(uint32_t index) const;
    double area_below(NodeRef ref) const;

    template <class Probe, class Visit>
    void traverse_to_bound(void (*kernel)(const BvhNode*, uint32_t, const Probe&, float, const BvhVisitor&),
                           const Probe& probe, double bound, float limit, Visit& visit, ItemMemory items) const;
    template <class Visit>
    void traverse_along(decltype(BvhKernels::ray) kernel, const Ray& ray, double t_max, Visit& visit,
                        ItemMemory items) const;
    template <class Visit>
    void traverse_many(decltype(BvhKernels::rays) kernel, const Ray* rays, uint32_t count, Visit& visit,
                       ItemMemory items) const;
    template <class Visit>
    static BvhListVisitor list_visitor(Visit& visit, ItemMemory items, ItemMemory items_inside);

    const BvhKernels& kernels_;
    const Workers* const workers_;
    LargeArray<Node> nodes_;
    LargeArray<uint32_t> place_of_;  // by item: 8 * leaf + lane, or none
    NodeRef root_ = none;
    Box bounds_;
    uint32_t size_ = 0;
    uint32_t first_free_ = none, free_count_ = 0;

    // Of the last build, to compare with: the areas of all nodes' boxes, and of the root's.
    double built_area_ = 0, built_root_area_ = 0;
    uint32_t turn_ = 0;    // of renew_in_turn
    uint32_t credit_ = 0;  // items that it may build, saved up
    uint32_t rebuilds_ = 0;
};

}  // namespace gphys

namespace gphys {

template <class Moves>
void Bvh8::update_many(uint32_t count, Moves&& moves) noexcept {
    if (count < size_ / many) {
        moves([this](uint32_t item, const Box& box) { update(item, box); }, false);
        return;
    }
    const auto put = [this](uint32_t item, const Box& box) {
        const uint32_t place = place_of_[item];
        nodes_[place / 8].boxes.set_lane(static_cast<int>(place % 8), box);
    };
    moves(put, true);
    refit_all(count);
}

template <class VisitNode, class VisitItem>
void Bvh8::visit_layout_below(NodeRef ref, VisitNode& visit_node, VisitItem& visit_item) const {
    const Node& node = nodes_[index_of(ref)];
    visit_node(node.count - 1 + (is_leaf(ref) ? BvhLayout::leaf_mark : 0));
    for (uint32_t i = 0; i < node.count; ++i) {
        if (is_leaf(ref)) {
            visit_item(node.child[i]);
        } else {
            visit_layout_below(node.child[i], visit_node, visit_item);
        }
    }
}

}  // namespace gphys

#include "bvh/bvh_queries.h"

// A bounding volume hierarchy (BVH) with eight children per node, over items: a small integer and an AABB each. Items
// are slots of a scene or packets of triangles (wide BVH: Wald, Benthin, Boulos, "Getting rid of packets", 2008).
//
// It plays the part of the octree in the Game Physics Cookbook, and the public functions keep that name. An octree
// divides space at the centre of each cell. Here the items are divided by the surface area heuristic, three binary
// splits a level, with far less overlap. Each item is in exactly one leaf, so no query visits it twice. The root grows
// with its items, so none is outside.
//
// A node holds the boxes of its children in structure-of-arrays layout, and kernels test all eight together
// (bvh_kernels.h). The children of a leaf are items. All bounds are tight at all times.
//
//   bvh_build.cpp     builds the tree, or parts of it
//   bvh_update.cpp    inserts, removes and moves items; refit
//   bvh_rebuild.cpp   rebuilds degraded parts
//   bvh_layout.cpp    restores the tree of a snapshot
//   bvh_queries.h     queries
//   bvh_validate.cpp  statistics and consistency check
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
    /// A build makes at most `max_built_levels`. An insertion that might exceed `max_levels` rebuilds first.
    static constexpr uint32_t max_levels = bvh_max_levels;
    static constexpr uint32_t max_built_levels = 24;

    /// Workers share builds and large updates; null: all runs on the caller's thread. The tree does not depend on their
    /// number.
    template <class Source>  // as of LargeArray
    explicit Bvh8(Source* memory, Isa isa = chosen_isa(), const Workers* workers = nullptr)
        : kernels_(bvh_kernels(isa)), workers_(workers), nodes_(memory), item_lane_(memory) {}
    Bvh8(const Bvh8&) = delete;
    Bvh8& operator=(const Bvh8&) = delete;
    ~Bvh8() { cancel_renewal(); }

    // Changes. Boxes are within max_box_coordinate. Memory is proportional to the largest item. Functions that throw
    // std::bad_alloc have changed nothing. noexcept functions cannot fail: without memory they skip an improvement of
    // the tree.

    /// Reserves memory to insert items below `count` one by one.
    void reserve(uint32_t count);
    /// Rebuilds with `count` distinct items.
    void build(const Box* boxes, const uint32_t* items, uint32_t count);
    /// Rebuilds with a valid layout; `boxes` are in the order of its items.
    void build(const BvhLayout& layout, const Box* boxes);
    /// Rebuilds with the same items.
    void rebuild();
    void insert(uint32_t item, const Box& box);
    /// Inserts one by one, or rebuilds if `count` is large compared with the tree.
    void insert_many(const uint32_t* items, const Box* boxes, uint32_t count);
    void remove(uint32_t item) noexcept;
    void update(uint32_t item, const Box& box) noexcept;
    /// Updates one by one, or with one refit of the whole tree if `count` is large compared with the tree. `count` may
    /// be an estimate. moves(put, on_any_thread) calls put(item, box) for each item; tasks may call it concurrently for
    /// different items if on_any_thread is true.
    template <class Moves>
    void update_many(uint32_t count, Moves&& moves) noexcept;
    void clear() noexcept;
    /// Goes on with the renewal of a tree to which items were added one by one (bvh_renewal.h), for the time that a
    /// build of so many items takes. True: nothing is left to do.
    bool maintain(uint32_t items);

    bool contains(uint32_t item) const { return item < item_lane_.size() && item_lane_[item] != none; }
    Box box(uint32_t item) const { return node_of(item).boxes.lane(static_cast<int>(item_lane_[item] % 8)); }
    Box bounds() const { return bounds_; }
    uint32_t size() const { return size_; }

    // Queries. Visitors get the items whose boxes overlap the query, and in rare cases more; never fewer.

    /// Closest hit: visits roughly front to back. visit(item, t_max) may lower t_max; a negative t_max ends the query.
    /// Boxes entered exactly at t_max are visited. With a direction of zero, the boxes that contain the origin are.
    template <class Visit>
    void raycast(const Ray& ray, double t_max, Visit&& visit, ItemMemory items = {}) const;
    /// The same by the visitor that make_visit() returns, called only if the ray meets the bounds of all items: other
    /// rays do not pay for what visits share. An only item need not be tested: its test is the visitor's.
    template <class MakeVisit>
    void raycast_by(const Ray& ray, double t_max, MakeVisit&& make_visit, ItemMemory items = {}) const;
    /// Closest hits of up to rays_at_once rays. Consecutive coherent rays form a packet; the others are interleaved.
    /// visit(numbers, items, count) gets up to eight pairs of a ray and an item. It may lower rays[numbers[k]].t_max;
    /// bit k of its result tells whether it has. A ray may visit an item twice: in its packet, and again if the packet
    /// is abandoned.
    static constexpr uint32_t rays_at_once = bvh_max_rays;
    template <class Visit>
    void raycast_many(const Ray* rays, uint32_t count, Visit&& visit, ItemMemory items = {}) const;
    /// Any hits: in no order. The visitor ends a ray by a negative t_max, or does not change it.
    template <class Visit>
    void raycast_any_many(const Ray* rays, uint32_t count, Visit&& visit, ItemMemory items = {}) const;
    /// Any hit: in no order, until visit(item) returns true; returns whether it has.
    template <class Visit>
    bool raycast_any(const Ray& ray, Visit&& visit, ItemMemory items = {}) const;
    /// The same by the visitor that make_visit() returns.
    template <class MakeVisit>
    bool raycast_any_by(const Ray& ray, MakeVisit&& make_visit, ItemMemory items = {}) const;
    /// As raycast, for a sphere that moves from `center` to center + displacement, t = 0 .. 1.
    template <class Visit>
    void sweep(Vec3 center, Vec3 displacement, double radius, Visit&& visit, ItemMemory items = {}) const;
    /// The same for a box with these half extents.
    template <class Visit>
    void sweep(Vec3 middle, Vec3 displacement, Vec3 half, Visit&& visit, ItemMemory items = {}) const;
    /// Visits roughly nearest first. visit(item, max_distance) may lower max_distance; a negative one ends the query.
    template <class Visit>
    void nearest(Vec3 point, double max_distance, Visit&& visit, ItemMemory items = {}) const;
    /// The same for up to `points_at_once` points, interleaved. visit(number, item) may lower reaches[number], the
    /// greatest distance from points[number]; a negative one ends the query of that point.
    static constexpr uint32_t points_at_once = bvh_max_rays;
    template <class Visit>
    void nearest_many(const Vec3* points, uint32_t count, double* reaches, Visit&& visit, ItemMemory items = {}) const;
    /// The same as nearest with weights; the probe was made for bounds().
    template <class Visit>
    void nearest(const WeightedPointProbe& probe, double max_distance, Visit&& visit) const;
    /// visit(item, wholly_inside), visit(items, count, wholly_inside) or visit(items, count) returns false to end the
    /// query; the query returns false if it was ended. `items_inside`: the memory that the visitor reads for items
    /// wholly inside.
    template <class Visit>
    bool overlap_box(const Box& box, Visit&& visit, ItemMemory items = {}, ItemMemory items_inside = {}) const;
    template <class Visit>
    bool overlap_ball(Vec3 center, double radius, Visit&& visit, ItemMemory items = {},
                      ItemMemory items_inside = {}) const;
    /// The same for up to OverlapItems::max_queries boxes or balls, interleaved. If a result is not complete, call
    /// overlap_box or overlap_ball for it.
    void overlap_boxes(const Box* boxes, uint32_t count, ItemMemory items, ItemMemory items_inside,
                       OverlapItems* found) const;
    void overlap_balls(const Sphere* balls, uint32_t count, ItemMemory items, ItemMemory items_inside,
                       OverlapItems* found) const;
    /// visit(item), for any conservative test may_overlap(box).
    template <class MayOverlap, class Visit>
    bool overlap(MayOverlap&& may_overlap, Visit&& visit) const;
    /// `around` contains the frustum; the tighter, the better.
    template <class Visit>
    bool frustum(const Frustum& frustum, const Box& around, Visit&& visit, ItemMemory items = {},
                 ItemMemory items_inside = {}) const;
    /// All pairs of items of two trees whose boxes overlap. visit(item, other_item) returns false to end the query.
    template <class Visit>
    bool overlap_pairs(const Bvh8& other, Visit&& visit) const;

    uint32_t node_count() const { return root_ == none ? 0 : count_nodes(root_); }
    /// Writes the tree as a BvhLayout: visit_node(word) and visit_item(item), in the layout's order.
    template <class VisitNode, class VisitItem>
    void visit_layout(VisitNode&& visit_node, VisitItem&& visit_item) const {
        if (root_ != none) visit_layout_below(root_, visit_node, visit_item);
    }

    // For kernels that test their own items (src/mesh/mesh_kernels.h). The tree is not empty.
    const BvhNode* nodes() const { return nodes_.data(); }
    uint32_t root() const { return root_; }

    gphys_octree_stats stats() const;
    /// visit(gphys_octree_box) for each node, parents first.
    template <class Visit>
    void for_each_box(Visit&& visit) const {
        for_each_box(visit, [](uint32_t, const gphys_octree_box&) {});
    }
    /// visit_item(item, gphys_octree_box) for each item, after its leaf.
    template <class Visit, class VisitItem>
    void for_each_box(Visit&& visit, VisitItem&& visit_item) const;
    /// What is inconsistent in the tree, or nullptr.
    const char* defect() const;

private:
    using Node = BvhNode;
    using NodeRef = uint32_t;
    static constexpr NodeRef leaf_bit = bvh_leaf_bit;
    static uint32_t index_of(NodeRef ref) { return ref & ~leaf_bit; }
    static bool is_leaf(NodeRef ref) { return (ref & leaf_bit) != 0; }

    /// From size / refit_divisor changes on, one refit of the whole tree is faster than single updates.
    static constexpr uint32_t refit_divisor = 8;
    /// A smaller tree is refitted in less time than waking a thread takes.
    static constexpr uint32_t parallel_size = 8192;

    /// A part of the tree is rebuilt when more than one in so many of its items has been inserted since its last build.
    /// So each insertion pays for the rebuild of two items.
    static constexpr uint32_t items_per_addition = 2;
    /// The largest part that one call rebuilds: small enough for some ten microseconds, large enough for full leaves
    /// and good splits.
    static constexpr uint32_t max_rebuilt_items = 512;

    class Builder;
    class Renewal;
    /// A relocation is a move to where the item's leaf may not be the best one, or to another leaf.
    enum class Change { addition, removal, move, relocation };

    /// An empty tree that is to replace another. It does not renew itself.
    struct Replacement {};
    Bvh8(const Bvh8& other, Replacement)
        : kernels_(other.kernels_),
          workers_(other.workers_),
          nodes_(other.nodes_.alike()),
          item_lane_(other.item_lane_.alike()),
          renews_itself_(false) {}

    static uint32_t items_below(const Node& node) { return node.levels == 1 ? node.count : node.items; }
    uint32_t levels() const { return root_ == none ? 0 : nodes_[index_of(root_)].levels; }
    /// The levels allowed in a rebuild of a subtree with so many items: two more than half-full nodes take.
    static uint32_t levels_for(uint32_t items) {
        uint32_t levels = 3;
        for (uint32_t room = 4; room < items; room *= 4) ++levels;
        return levels;
    }
    const Node& node_of(uint32_t item) const { return nodes_[item_lane_[item] / 8]; }
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
    void free_subtree(NodeRef ref);

    void reserve_nodes(uint32_t count);
    uint32_t nodes_for_additions(uint32_t additions) const;
    bool try_reserve_nodes(uint32_t additions) noexcept;
    NodeRef allocate_node(bool leaf);
    void free_node(uint32_t index);
    void put(NodeRef node, uint32_t lane, uint32_t child, const Box& box);
    void drop(NodeRef node, uint32_t lane);
    void replace(uint32_t index, NodeRef by);
    NodeRef leaf_to_join(const Box& box);
    NodeRef split(NodeRef node, uint32_t child, const Box& box);
    void add_child(NodeRef node, uint32_t child, Box box);
    void refit_upward(uint32_t index);
    void record_leaf_area(uint32_t leaf);
    void update_levels(uint32_t index);
    void count_below(uint32_t index);
    /// The fraction of a node's items that were inserted since its subtree was built.
    double added_share(uint32_t index) const { return static_cast<double>(nodes_[index].added) / nodes_[index].items; }
    void set_added_share(uint32_t index, double share) {
        nodes_[index].added = static_cast<uint32_t>(share * nodes_[index].items);
    }
    bool lift(uint32_t node, uint32_t& child, Box& box);
    bool degraded(uint32_t leaf) const;
    void attach(uint32_t item, const Box& box);
    uint32_t detach(uint32_t item);
    uint32_t reinsert(uint32_t item);
    void reinsert_small_leaf(uint32_t leaf);

    double refit();
    double refit_below(NodeRef ref, Box& box);

    void refit_all(uint32_t changes) noexcept;
    bool has_grown(double area, double factor) const;
    void rebuild_around(uint32_t item) noexcept;
    void rebuild_next_part(uint32_t changes);

    /// Whether more than one in so many items has been inserted since the last build of all, or one in twice as many
    /// relocated.
    bool is_worn(uint32_t one_in) const { return size_ > max_rebuilt_items && added_ > size_ / one_in; }
    void begin_renewal(pages::HugePages huge);
    void advance_renewal(uint32_t& work);
    void cancel_renewal() noexcept;
    void finish_renewal() noexcept;
    void renew_gradually(uint32_t item, Change change) noexcept;
    /// Call after each change of a single item.
    void note_change(uint32_t item, Change change) noexcept {
        // A relocation leaves a gap behind as well.
        added_ += change == Change::addition ? 1 : change == Change::relocation ? 2 : 0;
        const bool wears = change == Change::addition || change == Change::relocation;
        if (renews_itself_ && (renewal_ || wears)) renew_gradually(item, change);
    }

    uint32_t level_of(uint32_t index) const;
    double area_below(NodeRef ref) const;

    template <class Probe, class Visit>
    void traverse_to_bound(void (*kernel)(const BvhNode*, uint32_t, const Probe&, float, const BvhVisitor&),
                           const Probe& probe, double bound, float limit, Visit& visit, ItemMemory items) const;
    template <class MakeVisit>
    void traverse_ray(decltype(BvhKernels::ray) kernel, const Ray& ray, double t_max, const MakeVisit& make_visit,
                      ItemMemory items) const;
    template <class Visit>
    void traverse_rays(decltype(BvhKernels::rays) kernel, const Ray* rays, uint32_t count, Visit& visit,
                       ItemMemory items) const;
    template <class Visit>
    static BvhListVisitor list_visitor(Visit& visit, ItemMemory items, ItemMemory items_inside);

    const BvhKernels& kernels_;
    const Workers* const workers_;
    LargeArray<Node> nodes_;
    LargeArray<uint32_t> item_lane_;  // by item: 8 * leaf + lane, or none
    NodeRef root_ = none;
    Box bounds_;
    uint32_t size_ = 0;
    uint32_t first_free_ = none, free_count_ = 0;

    // At the last build: the sum of the half areas of all nodes, and that of the root.
    double built_area_ = 0, built_root_area_ = 0;
    // Of rebuild_next_part: which part is next, and how many items it may rebuild.
    uint32_t cursor_ = 0, budget_ = 0;
    uint32_t rebuilds_ = 0;

    uint32_t added_ = 0;  // items that were inserted or relocated one by one since the last build of all
    const bool renews_itself_ = true;
    Renewal* renewal_ = nullptr;  // null: none is in progress
    uint32_t paid_work_ = 0;      // of the renewal, not done yet
};

}  // namespace gphys

namespace gphys {

template <class Moves>
void Bvh8::update_many(uint32_t count, Moves&& moves) noexcept {
    if (count < size_ / refit_divisor) {
        moves([this](uint32_t item, const Box& box) { update(item, box); }, false);
        return;
    }
    const auto put = [this](uint32_t item, const Box& box) {
        const uint32_t place = item_lane_[item];
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

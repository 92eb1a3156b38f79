// Many rays at once, for kernels. Those that go much the same way share one walk: inner nodes are
// tested once for all of them, and in leaves each box is tested against eight rays at a time. Those
// that have nothing in common take turns, so that none waits for memory.
#pragma once

#include <type_traits>

#include "octree/bundle_test.h"
#include "octree/octree_traversal.h"

namespace gphys::GPHYS_ISA {

/// A walk is NearestFirst or LongestFirst. probe_of(ray) is a RayProbe; visit(rays, items, count, limits) is for up
/// to eight, as that of OctreeRayVisitor. Before that fetch(item) prepares for each.
template <class Walk, class ProbeOf, class Visit, class Fetch>
void rays_in_turns(const OctreeNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* limits, uint32_t count,
                   const Visit& visit, const Fetch& fetch) {
    constexpr uint32_t most = 16;
    // Turns are taken in groups: to look side by side lets their arithmetic overlap, and loops that run
    // as often each time do not surprise the processor. All of a group leave before any goes on: whether to a node
    // or an item is not to be foreseen, and a wrong guess costs less the sooner it is noticed.
    constexpr uint32_t group = 4, visits = 8;
    struct alignas(64) Turn {
        RayTest test;
        uint32_t ray;
        const OctreeNode* here;  // the node that it is at, or was last
        Found found;
        Walk walk;
    };
    Turn turns[most];
    typename Walk::Stack stacks[most];
    /// Turns by their numbers, first in, first out: four bits each, in a register.
    struct Queue {
        Turn* turns;
        uint64_t numbers = 0;
        uint32_t size = 0;

        void add(const Turn& turn) { numbers |= static_cast<uint64_t>(&turn - turns) << (4 * size++); }
        Turn& take() {
            Turn& turn = turns[numbers % most];
            numbers /= most;
            --size;
            return turn;
        }
    };
    static_assert(most == 1 << 4);
    Queue looking{turns}, visiting{turns};  // those that are at a node, and at an item
    uint32_t next = 0;
    const auto begin = [&](Turn& turn) {
        while (next < count && !(limits[next] >= 0)) ++next;
        if (next == count) return;
        turn.ray = next++;
        turn.test = RayTest(probe_of(turn.ray));
        turn.walk.begin(root, limits[turn.ray], stacks[&turn - turns]);
        turn.here = &node_at(nodes, root);
        looking.add(turn);
    };
    // Fetches what the walk is at, for when its turn comes.
    const auto go_on = [&](Turn& turn, bool goes_on) {
        if (!goes_on) {
            begin(turn);
        } else if (turn.walk.at_item()) {
            visiting.add(turn);
            fetch(turn.walk.item());
        } else {
            looking.add(turn);
            turn.here = &turn.walk.node(nodes);
            fetch_ahead(turn.here, sizeof(OctreeNode));
        }
    };
    const auto look = [&](auto some) {
        constexpr uint32_t size = some;
        Turn* now[size];
        bool goes_on[size];
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) {
            now[i] = &looking.take();
            now[i]->walk.look(*now[i]->here, now[i]->test, now[i]->found);
        }
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) goes_on[i] = now[i]->walk.leave_node(*now[i]->here, now[i]->found);
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) go_on(*now[i], goes_on[i]);
    };
    const auto visit_some = [&](uint32_t size) {
        Turn* now[visits];
        uint32_t rays[visits], items[visits];
        float new_limits[visits];
        for (uint32_t i = 0; i < size; ++i) {
            now[i] = &visiting.take();
            rays[i] = now[i]->ray;
            items[i] = now[i]->walk.item();
        }
        for (uint32_t moved = visit(rays, items, size, new_limits); moved != 0; moved &= moved - 1) {
            const int i = __builtin_ctz(moved);
            now[i]->walk.set_limit(new_limits[i]);
        }
        for (uint32_t i = 0; i < size; ++i) go_on(*now[i], now[i]->walk.leave_item());
    };
    for (Turn& turn : turns) begin(turn);
    for (;;) {
        if (visiting.size >= visits) {
            visit_some(visits);
        } else if (looking.size >= group) {
            look(std::integral_constant<uint32_t, group>());
        } else if (visiting.size > 0) {
            visit_some(visiting.size);
        } else if (looking.size > 0) {
            look(std::integral_constant<uint32_t, 1>());
        } else {
            return;
        }
    }
}

/// The limits of rays that go together, and of none behind them: groups of eight are whole.
struct RayLimits {
    static_assert(RayBundling::most <= octree_most_rays);
    alignas(32) float limits[octree_most_rays];

    template <class LimitOf>
    RayLimits(uint32_t count, const LimitOf& limit_of) {
        for (uint32_t i = 0; i < count; ++i) limits[i] = limit_of(i);
        for (uint32_t i = count; i % 8 != 0; ++i) limits[i] = -1;
    }
};

/// As take_lanes takes them.
struct Numbers {
    uint32_t up_to[RayBundling::most];

    constexpr Numbers() : up_to{} {
        for (uint32_t i = 0; i < RayBundling::most; ++i) up_to[i] = i;
    }
};
inline constexpr Numbers numbers;

/// Visits of several rays to items, by eight: those take little longer than one.
template <class Visit>
class VisitsByEight {
public:
    /// visit(rays, items, count)
    explicit VisitsByEight(const Visit& visit) : visit_(visit) {}

    /// A set of rays of a group, as BundleTest counts them.
    void add(uint32_t group, uint32_t set, uint32_t item) {
        for (uint32_t i = 0; i < 8; ++i) items_[count_ + i] = item;
        count_ += take_lanes(rays_ + count_, numbers.up_to + 8 * group, set);
        if (count_ < 8) return;
        visit_(rays_, items_, 8u);
        count_ -= 8;
        for (uint32_t i = 0; i < count_; ++i) {
            rays_[i] = rays_[8 + i];
            items_[i] = items_[8 + i];
        }
    }
    void finish() {
        if (count_ > 0) visit_(rays_, items_, count_);
        count_ = 0;
    }

private:
    const Visit& visit_;
    uint32_t rays_[16], items_[16], count_ = 0;
};

/// Whether a shared traversal is still cheaper than one for each ray. How far rays are apart tells little, as leaves
/// differ in size; what the traversal has met so far tells more. Each ray would have visited some nodes by itself,
/// and about one for each item that it may meet. The shared traversal has visited nodes, and in leaves has tested
/// groups and rays; a test of one box costs about a third of that of a node. The weights are fitted to the
/// benchmark of batches (bench/batches.cpp), which fails where a batch takes longer than its single calls.
class SharedCost {
public:
    explicit SharedCost(uint32_t rays) : alone_(nodes_of_each * rays) {}

    void add_node() { shared_ += node; }
    void add_groups(uint32_t count) { shared_ += group * count; }
    void add_box(uint32_t rays) {
        shared_ += box;
        alone_ += item * rays;
    }
    bool is_too_high() const { return shared_ > alone_; }

private:
    static constexpr uint32_t node = 3, group = 2, box = 1, nodes_of_each = 12, item = 4;

    uint32_t shared_ = 0, alone_;
};

/// Rays that have been made a BundleTest share one walk, nearest first by all of them. visit(group, set, item) is for
/// some rays of a group; it may put off to move their limits until settle() at the end of a leaf. False if the rays
/// turn out to have too little in common: then each is to begin again by itself, with the limit that it has.
template <class Visit, class Settle, class Fetch>
bool rays_together(const OctreeNode* nodes, uint32_t root, BundleTest& test, uint32_t count, const Visit& visit,
                   const Settle& settle, const Fetch& fetch) {
    if (test.limit() < 0) return true;
    KeyedChild stack[stack_size];
    int size = 0;
    uint32_t ref = root;
    SharedCost cost(count);
    for (;;) {
        const OctreeNode& node = node_at(nodes, ref);
        Float8 keys;
        Found found;
        found.hits = test.hits(node.boxes, keys) & lanes_of(node);
        store(found.keys, keys);
        cost.add_node();
        if (found.hits != 0 && !is_leaf(ref)) {
            const int base = size;
            size = push_nearest_last(stack, size, node.child, found, false);
            for (int i = size; i-- > base;) fetch_ahead(&node_at(nodes, child_of(stack[i])), sizeof(OctreeNode));
            ref = child_of(stack[--size]);
            continue;
        }
        if (found.hits != 0) {
            const uint64_t met = test.hits_of_groups(node.boxes);
            cost.add_groups((count + 7) / 8);
            constexpr uint64_t lane_of_groups = 0x0101010101010101;
            for (uint32_t rest = found.hits; rest != 0; rest &= rest - 1) fetch(node.child[__builtin_ctz(rest)]);
            KeyedChild ordered[8 + pushed_beyond];
            for (int left = push_nearest_last(ordered, 0, numbers.up_to, found, false); left-- > 0;) {
                const uint32_t lane = child_of(ordered[left]);
                for (uint64_t rest = met >> lane & lane_of_groups; rest != 0; rest &= rest - 1) {
                    const auto group = static_cast<uint32_t>(__builtin_ctzll(rest)) / 8;
                    const uint32_t set = test.rays(group, node.boxes, lane);
                    cost.add_box(static_cast<uint32_t>(__builtin_popcount(set)));
                    if (set != 0) visit(group, set, node.child[lane]);
                }
            }
            settle();
            test.set_limits();
        }
        if (cost.is_too_high()) return false;
        do {
            if (size == 0) return true;
            --size;
        } while (!(key_of(stack[size]) <= test.limit()));
        ref = child_of(stack[size]);
    }
}

}  // namespace gphys::GPHYS_ISA

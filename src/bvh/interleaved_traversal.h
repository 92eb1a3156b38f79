// Interleaved traversal, for kernels: many queries traverse the tree independently, and while one waits for memory,
// others continue. Each query is a ray or a point, and a state machine (ordered_traversal.h). Before it is suspended,
// its next node or item is prefetched (asynchronous memory access chaining: Kocberber, Falsafi, Grot 2015).
//
// Several queries take a step together: their arithmetic is independent, and loops with a fixed number of rounds have
// predictable branches. All queries of a group leave their nodes before any is suspended: whether the next step is a
// node or an item is an unpredictable branch, and one that is resolved early costs less.
#pragma once

#include <type_traits>

#include "bvh/ordered_traversal.h"
#include "bvh/prefetch.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

/// Order is ClosestHit or AnyHit. Test is made from probe_of(query). visit(queries, items, count, limits) gets up to
/// eight pairs, as BvhPairsVisitor does; prefetch_of(item) precedes it for each.
template <class Order, class Test, class ProbeOf, class Visit, class PrefetchOf>
void traverse_interleaved(const BvhNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* limits,
                          uint32_t count, const Visit& visit, const PrefetchOf& prefetch_of) {
    constexpr uint32_t task_count = 16;                 // most queries in flight
    constexpr uint32_t node_group = 4, item_group = 8;  // queries that take a step together
    struct alignas(64) Task {
        Test test;
        uint32_t query;
        const BvhNode* here;  // the present node, or the last one
        NodeHits hits;
        Order traversal;
    };
    Task tasks[task_count];
    // Sixteen stacks for trees of twelve levels, as of millions of items. Deeper trees have fewer queries in flight, so
    // that calls do not need the stack of the deepest possible tree sixteen times.
    constexpr int usual_levels = 12, entries = Order::entries(usual_levels) * int{task_count};
    static_assert(entries >= Order::entries(bvh_max_levels) * int{node_group});
    typename Order::Entry stacks[entries];
    const int entries_of_one = Order::entries(static_cast<int>(node_at(nodes, root).levels));
    const uint32_t fitting = static_cast<uint32_t>(entries / entries_of_one);
    const uint32_t in_flight = fitting < task_count ? fitting : task_count;
    /// First in, first out. Numbers of tasks, four bits each, in one register.
    struct Queue {
        Task* tasks;
        uint64_t numbers = 0;
        uint32_t size = 0;

        void add(const Task& task) { numbers |= static_cast<uint64_t>(&task - tasks) << (4 * size++); }
        Task& pop() {
            Task& task = tasks[numbers % task_count];
            numbers /= task_count;
            --size;
            return task;
        }
    };
    static_assert(task_count == 1 << 4);
    Queue at_node{tasks}, at_item{tasks};
    uint32_t next_query = 0;
    const auto begin = [&](Task& task) {
        while (next_query < count && !(limits[next_query] >= 0)) ++next_query;
        if (next_query == count) return;
        task.query = next_query++;
        task.test = Test(probe_of(task.query));
        task.traversal.begin(root, limits[task.query], stacks + (&task - tasks) * entries_of_one);
        task.here = &node_at(nodes, root);
        at_node.add(task);
    };
    const auto suspend = [&](Task& task, bool is_active) {
        if (!is_active) {
            begin(task);
        } else if (task.traversal.at_item()) {
            at_item.add(task);
            prefetch_of(task.traversal.item());
        } else {
            at_node.add(task);
            task.here = &task.traversal.node(nodes);
            prefetch_range(task.here, sizeof(BvhNode));
        }
    };
    const auto test_nodes = [&](auto some) {
        constexpr uint32_t size = some;
        Task* now[size];
        bool is_active[size];
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) {
            now[i] = &at_node.pop();
            now[i]->traversal.test_node(*now[i]->here, now[i]->test, now[i]->hits);
        }
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) is_active[i] = now[i]->traversal.leave_node(*now[i]->here, now[i]->hits);
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) suspend(*now[i], is_active[i]);
    };
    const auto visit_items = [&](uint32_t size) {
        Task* now[item_group];
        uint32_t queries[item_group], items[item_group];
        float new_limits[item_group];
        for (uint32_t i = 0; i < size; ++i) {
            now[i] = &at_item.pop();
            queries[i] = now[i]->query;
            items[i] = now[i]->traversal.item();
        }
        for (uint32_t moved = visit(queries, items, size, new_limits); moved != 0; moved &= moved - 1) {
            const int i = lowest_bit(moved);
            now[i]->traversal.set_limit(new_limits[i]);
        }
        for (uint32_t i = 0; i < size; ++i) suspend(*now[i], now[i]->traversal.leave_item());
    };
    for (uint32_t i = 0; i < in_flight; ++i) begin(tasks[i]);
    for (;;) {
        if (at_item.size >= item_group) {
            visit_items(item_group);
        } else if (at_node.size >= node_group) {
            test_nodes(std::integral_constant<uint32_t, node_group>());
        } else if (at_item.size > 0) {
            visit_items(at_item.size);
        } else if (at_node.size > 0) {
            test_nodes(std::integral_constant<uint32_t, 1>());
        } else {
            return;
        }
    }
}

}  // namespace gphys::GPHYS_ISA

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

/// One query, with a stack for the deepest tree.
template <class Order, class Test, class Visit>
GPHYS_NOINLINE void traverse_alone(const BvhNode* nodes, uint32_t root, const Test& test, uint32_t query, float limit,
                                   typename Order::Entry* stack, const Visit& visit) {
    Order traversal;
    traversal.begin(root, limit, stack);
    for (bool is_active = true; is_active;) {
        if (traversal.at_item()) {
            const uint32_t item = traversal.item();
            float new_limit;
            if (visit(&query, &item, 1u, &new_limit) != 0) traversal.set_limit(new_limit);
            is_active = traversal.leave_item();
        } else {
            const BvhNode& here = traversal.node(nodes);
            NodeHits hits;
            traversal.test_node(here, test, hits);
            is_active = traversal.leave_node(here, hits, bvh_max_open);
        }
    }
}

/// Order is ClosestHit or AnyHit. Test is made from probe_of(query). visit(queries, items, count, limits) gets up to
/// eight pairs, as BvhPairsVisitor does; prefetch_of(item) precedes it for each.
template <class Order, class Test, class ProbeOf, class Visit, class PrefetchOf>
void traverse_interleaved(const BvhNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* limits,
                          uint32_t count, const Visit& visit, const PrefetchOf& prefetch_of) {
    constexpr uint32_t task_count = 16;                 // most queries in flight
    constexpr uint32_t node_group = 4, item_group = 8;  // queries that take a step together
    constexpr int usual_entries = 48;
    struct alignas(64) Task {
        Test test;
        uint32_t query;
        const BvhNode* here;  // the present node, or the last one
        NodeHits hits;
        Order traversal;
    };
    Task tasks[task_count];
    // Most queries never have more entries than this, whatever the depth of the tree. Those that would have more are
    // traversed from the root afterwards, one at a time, with the memory of all: so calls need neither the stack of the
    // deepest possible tree sixteen times, nor that of a usual one.
    constexpr int entries_of_one = Order::room_for(usual_entries), entries = entries_of_one * int{task_count};
    static_assert(entries >= Order::room_for(bvh_max_open));
    typename Order::Entry stacks[entries];
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
    uint64_t deep = 0;  // queries that are left for later, and their limits
    float deep_limits[bvh_max_rays];
    static_assert(bvh_max_rays <= 64);
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
            if (!task.traversal.is_complete()) {
                deep |= uint64_t{1} << task.query;
                deep_limits[task.query] = task.traversal.limit();
            }
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
        for (uint32_t i = 0; i < size; ++i)
            is_active[i] = now[i]->traversal.leave_node(*now[i]->here, now[i]->hits, usual_entries);
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
    for (Task& task : tasks) begin(task);
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
            break;
        }
    }
    for (; deep != 0; deep &= deep - 1) {
        const auto query = static_cast<uint32_t>(lowest_bit(deep));
        traverse_alone<Order>(nodes, root, Test(probe_of(query)), query, deep_limits[query], stacks, visit);
    }
}

}  // namespace gphys::GPHYS_ISA

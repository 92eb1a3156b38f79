// Interleaved traversal of the tree by many rays, each by itself, for kernels: while one would wait for memory, others
// go on. Each ray is a state machine (ordered_traversal.h); before it is put aside, what it needs next is prefetched
// (asynchronous memory access chaining: Kocberber, Falsafi, Grot 2015).
//
// Steps are taken by several rays side by side, as their arithmetic is independent and loops of a fixed number of
// rounds have predictable branches. All of a group leave their nodes before any of them goes on: whether to a node or
// to an item is unpredictable, and a branch that is resolved early costs less.
#pragma once

#include <type_traits>

#include "bvh/ordered_traversal.h"
#include "bvh/prefetch.h"
#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

/// Order is ClosestHit or AnyHit. probe_of(ray) is a RayProbe; visit(rays, items, count, limits) is for up to eight, as
/// that of BvhRayVisitor, after prefetch_of(item) for each.
template <class Order, class ProbeOf, class Visit, class PrefetchOf>
void traverse_interleaved(const BvhNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* limits,
                          uint32_t count, const Visit& visit, const PrefetchOf& prefetch_of) {
    constexpr uint32_t task_count = 16;                 // rays under way
    constexpr uint32_t node_group = 4, item_group = 8;  // that take a step side by side
    struct alignas(64) Task {
        RayTest test;
        uint32_t ray;
        const BvhNode* here;  // the node that it is at, or was last
        NodeHits hits;
        Order traversal;
    };
    Task tasks[task_count];
    typename Order::Stack stacks[task_count];
    /// Tasks by their numbers, first in, first out: four bits each, in a register.
    struct Queue {
        Task* tasks;
        uint64_t numbers = 0;
        uint32_t size = 0;

        void add(const Task& task) { numbers |= static_cast<uint64_t>(&task - tasks) << (4 * size++); }
        Task& take() {
            Task& task = tasks[numbers % task_count];
            numbers /= task_count;
            --size;
            return task;
        }
    };
    static_assert(task_count == 1 << 4);
    Queue at_node{tasks}, at_item{tasks};
    uint32_t next_ray = 0;
    const auto begin = [&](Task& task) {
        while (next_ray < count && !(limits[next_ray] >= 0)) ++next_ray;
        if (next_ray == count) return;
        task.ray = next_ray++;
        task.test = RayTest(probe_of(task.ray));
        task.traversal.begin(root, limits[task.ray], stacks[&task - tasks]);
        task.here = &node_at(nodes, root);
        at_node.add(task);
    };
    const auto put_aside = [&](Task& task, bool goes_on) {
        if (!goes_on) {
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
        bool goes_on[size];
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) {
            now[i] = &at_node.take();
            now[i]->traversal.test_node(*now[i]->here, now[i]->test, now[i]->hits);
        }
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) goes_on[i] = now[i]->traversal.leave_node(*now[i]->here, now[i]->hits);
        GPHYS_UNROLLED
        for (uint32_t i = 0; i < size; ++i) put_aside(*now[i], goes_on[i]);
    };
    const auto visit_items = [&](uint32_t size) {
        Task* now[item_group];
        uint32_t rays[item_group], items[item_group];
        float new_limits[item_group];
        for (uint32_t i = 0; i < size; ++i) {
            now[i] = &at_item.take();
            rays[i] = now[i]->ray;
            items[i] = now[i]->traversal.item();
        }
        for (uint32_t moved = visit(rays, items, size, new_limits); moved != 0; moved &= moved - 1) {
            const int i = lowest_bit(moved);
            now[i]->traversal.set_limit(new_limits[i]);
        }
        for (uint32_t i = 0; i < size; ++i) put_aside(*now[i], now[i]->traversal.leave_item());
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
            return;
        }
    }
}

}  // namespace gphys::GPHYS_ISA

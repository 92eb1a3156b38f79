// Many rays at once, for kernels. Those that go much the same way share one walk: inner nodes are
// tested once for all of them, and in leaves each box is tested against eight rays at a time. Those
// that have nothing in common take turns, so that none waits for memory.
#pragma once

#include "octree/octree_traversal.h"

namespace gphys::GPHYS_ISA {

/// All nearest first. probe_of(ray) is a RayProbe; visit(ray, item) returns the new limit of that ray,
/// fetch(item) prepares for it.
template <class ProbeOf, class Visit, class Fetch>
void rays_in_turns(const OctreeNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* limits, uint32_t count,
                   const Visit& visit, const Fetch& fetch) {
    constexpr uint32_t most = 16;
    struct Turn {
        uint32_t ray;
        Found found;
        NearestFirst walk;
    };
    // Those that are at a node, and at an item: in this round, and in the next one.
    struct Round {
        Turn *looking[most], *visiting[most];
        uint32_t looks = 0, visits = 0;
    };
    Turn turns[most];
    Round rounds[2];
    Round *now = &rounds[0], *later = &rounds[1];
    uint32_t next = 0;
    const auto begin = [&](Turn& turn) {
        while (next < count && !(limits[next] >= 0)) ++next;
        if (next == count) return;
        turn.ray = next++;
        turn.walk.begin(root, limits[turn.ray]);
        later->looking[later->looks++] = &turn;
    };
    // Fetches what the walk is at, for the next round.
    const auto go_on = [&](Turn& turn, bool goes_on) {
        if (!goes_on) {
            begin(turn);
        } else if (turn.walk.at_item()) {
            later->visiting[later->visits++] = &turn;
            fetch(turn.walk.item());
        } else {
            later->looking[later->looks++] = &turn;
            fetch_ahead(&turn.walk.node(nodes), sizeof(OctreeNode));
        }
    };
    for (Turn& turn : turns) begin(turn);
    while (later->looks + later->visits > 0) {
        std::swap(now, later);
        later->looks = later->visits = 0;
        for (uint32_t i = 0; i < now->looks; ++i) {
            Turn& turn = *now->looking[i];
            turn.walk.look(nodes, RayTest(probe_of(turn.ray)), turn.found);
        }
        for (uint32_t i = 0; i < now->looks; ++i) {
            Turn& turn = *now->looking[i];
            go_on(turn, turn.walk.leave_node(nodes, turn.found));
        }
        for (uint32_t i = 0; i < now->visits; ++i) {
            Turn& turn = *now->visiting[i];
            go_on(turn, turn.walk.leave_item(visit(turn.ray, turn.walk.item())));
        }
    }
}

/// The same for up to RayBundling::most rays with the same signs of direction, nearest first by all
/// of them. visit_some(first, rays, item, limits) visits those of eight rays from `first` on whose bits
/// are set, and puts the new limits of these in the eight.
template <class ProbeOf, class VisitSome, class Fetch>
void rays_together(const OctreeNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* first_limits,
                   uint32_t count, const VisitSome& visit_some, const Fetch& fetch) {
    constexpr uint32_t lanes[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    float limits[RayBundling::most];
    for (uint32_t i = 0; i < RayBundling::most; ++i) limits[i] = i < count ? first_limits[i] : -1;
    BundleTest test(probe_of, limits, count);
    if (test.limit() < 0) return;
    KeyedChild stack[stack_size];
    int size = 0;
    uint32_t ref = root;
    for (;;) {
        const OctreeNode& node = node_at(nodes, ref);
        Float8 keys;
        Found found;
        found.hits = test.hits(node.boxes, keys) & lanes_of(node);
        store(found.keys, keys);
        if (found.hits != 0 && !is_leaf(ref)) {
            const int base = size;
            size = push_nearest_last(stack, size, node.child, found, false);
            for (int i = size; i-- > base;) fetch_ahead(&node_at(nodes, child_of(stack[i])), sizeof(OctreeNode));
            ref = child_of(stack[--size]);
            continue;
        }
        if (found.hits != 0) {
            for (uint32_t rest = found.hits; rest != 0; rest &= rest - 1) fetch(node.child[__builtin_ctz(rest)]);
            KeyedChild ordered[8 + pushed_beyond];
            for (int left = push_nearest_last(ordered, 0, lanes, found, false); left-- > 0;) {
                const uint32_t lane = child_of(ordered[left]);
                for (uint32_t group = 0; group < test.groups(); ++group) {
                    const uint32_t rays = test.rays(group, node.boxes, lane);
                    if (rays != 0) visit_some(8 * group, rays, node.child[lane], limits + 8 * group);
                }
            }
            test.set_limits(limits);
        }
        do {
            if (size == 0) return;
            --size;
        } while (!(key_of(stack[size]) <= test.limit()));
        ref = child_of(stack[size]);
    }
}

template <class ProbeOf, class Visit, class VisitSome, class Fetch>
void rays_at_once(const OctreeNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* limits, uint32_t count,
                  bool together, const Visit& visit, const VisitSome& visit_some, const Fetch& fetch) {
    if (together) {
        rays_together(nodes, root, probe_of, limits, count, visit_some, fetch);
    } else {
        rays_in_turns(nodes, root, probe_of, limits, count, visit, fetch);
    }
}
/// Those that go together are visited one by one, too.
template <class ProbeOf, class Visit, class Fetch>
void rays_at_once(const OctreeNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* limits, uint32_t count,
                  bool together, const Visit& visit, const Fetch& fetch) {
    const auto visit_some = [&](uint32_t first, uint32_t rays, uint32_t item, float* new_limits) {
        for (; rays != 0; rays &= rays - 1) {
            const auto lane = static_cast<uint32_t>(__builtin_ctz(rays));
            new_limits[lane] = visit(first + lane, item);
        }
    };
    rays_at_once(nodes, root, probe_of, limits, count, together, visit, visit_some, fetch);
}

}  // namespace gphys::GPHYS_ISA

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
        NearestFirst walk;
    };
    Turn turns[most];
    uint32_t order[most], active = 0, next = 0;
    const auto begin = [&](Turn& turn) {
        while (next < count && !(limits[next] >= 0)) ++next;
        if (next == count) return false;
        turn.ray = next++;
        turn.walk.begin(nodes, root, limits[turn.ray]);
        return true;
    };
    while (active < most && begin(turns[active])) {
        order[active] = active;
        ++active;
    }
    while (active > 0) {
        for (uint32_t i = 0; i < active; ++i) {
            Turn& turn = turns[order[i]];
            const bool goes_on = turn.walk.step(
                nodes, RayTest(probe_of(turn.ray)), [&](uint32_t item) { return visit(turn.ray, item); }, fetch);
            if (!goes_on && !begin(turn)) order[i] = order[--active];
        }
    }
}

/// The same for up to eight rays with the same signs of direction, nearest first by all of them.
template <class ProbeOf, class Visit, class Fetch>
void rays_together(const OctreeNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* first_limits,
                   uint32_t count, const Visit& visit, const Fetch& fetch) {
    constexpr uint32_t lanes[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    alignas(32) float limits[8];
    float limit = -1;  // the greatest
    for (uint32_t i = 0; i < 8; ++i) {
        limits[i] = i < count ? first_limits[i] : -1;
        limit = limits[i] > limit ? limits[i] : limit;
    }
    if (limit < 0) return;
    BundleTest test(probe_of, limits, count);
    KeyedChild stack[stack_size];
    int size = 0;
    uint32_t ref = root;
    for (;;) {
        const OctreeNode& node = node_at(nodes, ref);
        Float8 keys;
        const uint32_t hits = test.hits(node.boxes, keys) & lanes_of(node);
        if (hits != 0 && !is_leaf(ref)) {
            const int base = size;
            size = push_nearest_last(stack, size, node.child, hits, keys);
            for (int i = size; i-- > base;) fetch_ahead(&node_at(nodes, child_of(stack[i])), sizeof(OctreeNode));
            ref = child_of(stack[--size]);
            continue;
        }
        if (hits != 0) {
            for (uint32_t rest = hits; rest != 0; rest &= rest - 1) fetch(node.child[__builtin_ctz(rest)]);
            KeyedChild ordered[8];
            for (int left = push_nearest_last(ordered, 0, lanes, hits, keys); left-- > 0;) {
                const uint32_t lane = child_of(ordered[left]);
                uint32_t rays = test.rays(node.boxes, lane);
                if (rays == 0) continue;
                for (; rays != 0; rays &= rays - 1) {
                    const int ray = __builtin_ctz(rays);
                    limits[ray] = visit(static_cast<uint32_t>(ray), node.child[lane]);
                }
                test.set_limits(limits);
                limit = limits[0];
                for (const float l : limits) limit = l > limit ? l : limit;
            }
        }
        do {
            if (size == 0) return;
            --size;
        } while (!(key_of(stack[size]) <= limit));
        ref = child_of(stack[size]);
    }
}

template <class ProbeOf, class Visit, class Fetch>
void rays_at_once(const OctreeNode* nodes, uint32_t root, const ProbeOf& probe_of, const float* limits, uint32_t count,
                  bool together, const Visit& visit, const Fetch& fetch) {
    if (together) {
        rays_together(nodes, root, probe_of, limits, count, visit, fetch);
    } else {
        rays_in_turns(nodes, root, probe_of, limits, count, visit, fetch);
    }
}

}  // namespace gphys::GPHYS_ISA

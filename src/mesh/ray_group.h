// Up to eight rays at once, for kernels. Those whose directions point into one octant (a camera's, a
// lamp's) walk the tree together: each box is tested against all of them, and where only one is left
// it goes on alone. Others take turns.
#pragma once

#include <new>

#include "mesh/mesh_kernels.h"
#include "mesh/ray_walk.h"

namespace gphys::GPHYS_ISA {

/// One box against eight rays: RayTest with the roles exchanged, to the same bits.
class RayGroupTest {
public:
    RayGroupTest(const RayProbe* const rays[8], uint32_t count) {
        for (int k = 0; k < 3; ++k) {
            near_row_[k] = rays[0]->near_row[k];
            far_row_[k] = rays[0]->far_row[k];
            alignas(32) float near_origin[8], far_origin[8], inverse[8];
            for (uint32_t i = 0; i < 8; ++i) {
                const RayProbe& ray = *rays[i < count ? i : 0];
                near_origin[i] = ray.near_origin[k];
                far_origin[i] = ray.far_origin[k];
                inverse[i] = ray.inverse[k];
            }
            near_origin_[k] = load(near_origin);
            far_origin_[k] = load(far_origin);
            inverse_[k] = load(inverse);
        }
    }

    /// Rays that meet the box of a lane no later than at their limits; `entry` is where.
    uint32_t hits(const Box8& boxes, uint32_t lane, Float8 limits, Float8& entry) const {
        const auto enters = [&](int k) {
            return (splat(boxes.row[near_row_[k]][lane]) - near_origin_[k]) * inverse_[k];
        };
        const auto leaves = [&](int k) { return (splat(boxes.row[far_row_[k]][lane]) - far_origin_[k]) * inverse_[k]; };
        entry = max(max(enters(0), enters(1)), max(enters(2), splat(0)));
        const Float8 exit = min(min(leaves(0), leaves(1)), leaves(2));
        return bits(entry <= min(exit * splat(1 + 8 * float_roundoff), limits));
    }

private:
    int near_row_[3], far_row_[3];
    Float8 near_origin_[3], far_origin_[3], inverse_[3];
};

inline bool in_one_octant(const RayProbe* const rays[8], uint32_t count) {
    for (uint32_t i = 1; i < count; ++i) {
        for (int k = 0; k < 3; ++k) {
            if (rays[i]->near_row[k] != rays[0]->near_row[k]) return false;
        }
    }
    return true;
}

inline void walk_in_turns(const MeshTree& tree, uint32_t root, const RayProbe* const along[8],
                          const TriangleProbe* const probes[8], uint32_t count, const float limits[8],
                          const RayPacketVisitor& to) {
    alignas(RayWalk) unsigned char memory[8][sizeof(RayWalk)];
    RayWalk* walks[8];
    for (uint32_t i = 0; i < count; ++i) walks[i] = new (memory[i]) RayWalk(*along[i], *probes[i], root, limits[i]);
    for (uint32_t going = (1u << count) - 1; going != 0;) {
        for (uint32_t rest = going; rest != 0; rest &= rest - 1) {
            const int ray = __builtin_ctz(rest);
            const bool goes_on = walks[ray]->step(tree, [&](const TrianglePacket& packet, uint32_t lanes) {
                return to.visit(to.context, ray, packet, lanes);
            });
            if (!goes_on) going &= ~(1u << ray);
        }
    }
}

inline void walk_together(const MeshTree& tree, uint32_t root, const RayProbe* const along[8],
                          const TriangleProbe* const probes[8], uint32_t count, float limits[8],
                          const RayPacketVisitor& to) {
    const RayGroupTest test(along, count);
    struct Entry {
        Float8 entry;
        uint32_t ref, rays;
    };
    Entry stack[stack_size];
    int size = 0;
    stack[size++] = {splat(0), root, 0xff};
    while (size > 0) {
        const Entry& top = stack[--size];
        const uint32_t ref = top.ref, rays = top.rays & bits(top.entry <= load(limits));
        if (rays == 0) continue;
        if ((rays & (rays - 1)) == 0) {
            const int ray = __builtin_ctz(rays);
            RayWalk walk(*along[ray], *probes[ray], ref, limits[ray]);
            while (walk.step(tree, [&](const TrianglePacket& packet, uint32_t lanes) {
                return to.visit(to.context, ray, packet, lanes);
            })) {
            }
            limits[ray] = walk.limit();
            continue;
        }
        const OctreeNode& node = node_at(tree.nodes, ref);
        const Float8 current = load(limits);
        Entry found[8];
        KeyedChild order[8];  // by where the first ray enters, furthest first
        int count_found = 0;
        for (uint32_t lane = 0; lane < node.count; ++lane) {
            Entry& next = found[lane];
            next.rays = rays & test.hits(node.boxes, lane, current, next.entry);
            if (next.rays == 0) continue;
            next.ref = node.child[lane];
            is_leaf(ref) ? tree.fetch_packet(next.ref) : tree.fetch(next.ref);
            alignas(32) float keys[8];
            store(keys, next.entry);
            const KeyedChild added = keyed(keys[__builtin_ctz(next.rays)], lane);
            int at = count_found++;
            for (; at > 0 && order[at - 1] < added; --at) order[at] = order[at - 1];
            order[at] = added;
        }
        if (!is_leaf(ref)) {
            for (int i = 0; i < count_found; ++i) stack[size++] = found[child_of(order[i])];
            continue;
        }
        while (count_found > 0) {
            const Entry& next = found[child_of(order[--count_found])];
            const TrianglePacket& packet = tree.packets[next.ref];
            for (uint32_t rest = next.rays & bits(next.entry <= load(limits)); rest != 0; rest &= rest - 1) {
                const int ray = __builtin_ctz(rest);
                const uint32_t lanes = TriangleTest(*probes[ray]).hits(packet, limits[ray]);
                if (lanes != 0) limits[ray] = to.visit(to.context, ray, packet, lanes);
            }
        }
    }
}

}  // namespace gphys::GPHYS_ISA

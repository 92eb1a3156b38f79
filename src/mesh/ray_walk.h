// A ray's walk through the octree of a mesh, for kernels: one step at a time, so that several rays can
// take turns, and what one will need is fetched while the others go on.
#pragma once

#include "mesh/triangle_test.h"
#include "octree/octree_traversal.h"

namespace gphys::GPHYS_ISA {

/// What rays walk through: an octree whose items are the numbers of packets.
struct MeshTree {
    const OctreeNode* nodes;
    const TrianglePacket* packets;

    void fetch(uint32_t node_ref) const { fetch_ahead(&node_at(nodes, node_ref), sizeof(OctreeNode)); }
    void fetch_packet(uint32_t number) const { fetch_ahead(packets + number, sizeof(TrianglePacket)); }
};

class RayWalk {
public:
    RayWalk(const RayProbe& along, const TriangleProbe& probe, uint32_t ref, float limit)
        : boxes_(along), triangles_(probe), limit_(limit) {
        stack_[0] = keyed(0, ref);
    }

    float limit() const { return limit_; }

    /// Test the nearest node or packet that waits. visit(packet, lanes) gets those that the ray may
    /// hit and returns the new limit. False if nothing is left.
    template <class Visit>
    bool step(const MeshTree& tree, const Visit& visit) {
        KeyedChild nearest;
        do {
            if (size_ == 0) return false;
            nearest = stack_[--size_];
        } while (!(key_of(nearest) <= limit_));
        const uint32_t ref = child_of(nearest);
        if (ref & packet_bit) {
            const TrianglePacket& packet = tree.packets[ref & ~packet_bit];
            const uint32_t lanes = triangles_.hits(packet, limit_);
            if (lanes != 0) limit_ = visit(packet, lanes);
            return true;
        }
        const OctreeNode& node = node_at(tree.nodes, ref);
        Float8 keys;
        const uint32_t hits = boxes_.hits(node.boxes, limit_, keys) & lanes_of(node);
        if (hits == 0) return true;
        const int base = size_;
        size_ = push_nearest_last(stack_, size_, node, hits, keys);
        for (int i = size_; i-- > base;) {
            if (is_leaf(ref)) {
                tree.fetch_packet(child_of(stack_[i]));
                stack_[i] |= packet_bit;
            } else {
                tree.fetch(child_of(stack_[i]));
            }
        }
        return true;
    }

private:
    /// On the stack, tells packets from nodes; there are fewer than 2^30 of either.
    static constexpr uint32_t packet_bit = 0x40000000u;

    RayTest boxes_;
    TriangleTest triangles_;
    float limit_;
    int size_ = 1;
    KeyedChild stack_[stack_size];
};

}  // namespace gphys::GPHYS_ISA

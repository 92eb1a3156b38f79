// Islands: bodies that may influence each other in a step, moved by one worker. A body that collides with itself is an
// island, too.
#pragma once

#include "foundation/memory.h"

namespace gphys {

class JointSurroundings;
class Team;

/// Union-find with path halving; the root of a set is its lowest member.
class DisjointSets {
public:
    DisjointSets(Vector<uint32_t>& parent, uint32_t count) : parent_(parent) {
        parent_.resize(count);
        for (uint32_t i = 0; i < count; ++i) parent_[i] = i;
    }
    uint32_t root(uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(uint32_t a, uint32_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    Vector<uint32_t>& parent_;
};

/// The unit of work of one worker, as ranges of the solver's lists.
struct Island {
    uint32_t size = 0;  // particles
    uint32_t first_body = 0, body_count = 0;
    uint32_t first_joined = 0, joined_count = 0;
    uint32_t first_system = 0, system_count = 0;
    uint32_t first_particle = 0, colliding_count = 0;     // those that collide with others
    uint32_t first_cluster = 0, cluster_count = 0;        // of these, the free ones
    uint32_t first_rigid_pair = 0, rigid_pair_count = 0;  // room for the list of their contacts with particles
    uint32_t first_row = 0, row_count = 0;                // and for these and those with models
    uint32_t first_group = 0;                             // of their pairs
    bool unequal = false;                                 // whether a ball among them is much heavier than another
    bool on_trial = false;                                // whether all workers could move it at once
    bool shared = false;                                  // whether they do (SharingTrial)
    Team* team = nullptr;                                 // of these workers, during the step
    const JointSurroundings* beside_joints = nullptr;     // what does not collide

    /// The largest first, so that no worker begins a large one when the others are done.
    bool operator<(const Island& other) const {
        return size != other.size ? size > other.size : first_body < other.first_body;
    }
};

}  // namespace gphys

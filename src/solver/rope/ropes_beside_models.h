// Ropes that may touch static models, moved through a step with their equations solved side by side, one rope in each
// lane of the kernels. A lane whose rope has ended its step takes the next one, whatever the others do. The result for
// a rope does not depend on the others beside it.
#pragma once

#include <optional>

#include "solver/rope/rope_in_step.h"
#include "solver/rope/rope_lanes.h"

namespace gphys {

template <int lanes>
class RopesBesideModels {
public:
    /// `longest`: particles of the longest rope to come, for which the room has memory.
    RopesBesideModels(RopeRoom& room, uint32_t longest);

    bool empty() const { return count_ == 0; }
    bool full() const { return count_ == lanes; }
    /// Call only if not full. The contacts that the next rope must use.
    RopeContacts& next_contacts() { return room_.contacts[free_lane()]; }
    void add(const RopeInStep& rope);
    /// Call only if not empty. Moves the ropes until one is at the end of its step, and removes it.
    RopeInStep move_until_one_ends();

private:
    struct Lane {
        std::optional<RopeInStep> rope;
        bool solving = false;
        int iteration = 0;
    };

    uint32_t free_lane() const;
    void put_constants(uint32_t lane, Body& body);
    void put(uint32_t lane);
    void put_pushes(uint32_t lane);
    bool begin(uint32_t lane);
    void iterate();
    bool update(uint32_t lane);
    void take(uint32_t lane) const;
    bool is_found(uint32_t lane) const;

    RopeRoom& room_;
    const RopeKernelsOf<lanes>& kernels_;
    RopeNode<lanes>* const nodes_;
    RopePush<lanes>* const pushes_;
    const uint32_t longest_;
    RopeEquations<lanes> equations_{};
    Lane lanes_[lanes];
    uint32_t count_ = 0;
    bool filled_ = false;
};

}  // namespace gphys

// Ropes that may touch static models, moved through a step with their equations solved side by side, one rope in each
// lane of the kernels. Each iteration of Newton's method runs in all lanes; everything else is done rope by rope. When
// a rope is at the end of its step, its lane takes the next one, whatever the others do, so lanes are rarely idle. The
// result for a rope does not depend on the others.
#pragma once

#include <optional>

#include "solver/rope/rope_lanes.h"
#include "solver/rope/rope_stepper.h"

namespace gphys {

template <int lanes>
class RopeContactLanes {
public:
    /// `longest`: particles of the longest rope that will be added, for which `scratch` has memory.
    RopeContactLanes(RopeScratch& scratch, uint32_t longest);

    bool empty() const { return count_ == 0; }
    bool full() const { return count_ == lanes; }
    /// The contacts that the next rope must use. Call only if not full.
    RopeContacts& next_contacts() { return scratch_.contacts[free_lane()]; }
    void add(const RopeStepper& rope);
    /// Moves the ropes until one is at the end of its step, and removes that one. Call only if not empty.
    RopeStepper move_until_one_ends();

private:
    struct Lane {
        std::optional<RopeStepper> rope;
        bool solving = false;  // whether its equations are in the lane
        int iteration = 0;     // of these
    };

    uint32_t free_lane() const;
    void gather_constants(uint32_t lane, Body& body);
    void gather_prediction(uint32_t lane);
    void gather_contacts(uint32_t lane);
    bool begin_part(uint32_t lane);
    void iterate();
    bool update_contacts(uint32_t lane);
    void scatter(uint32_t lane) const;
    bool is_solved(uint32_t lane) const;

    RopeScratch& scratch_;
    const RopeKernelsOf<lanes>& kernels_;
    RopeNode<lanes>* const nodes_;
    RopeContactTerm<lanes>* const terms_;
    const uint32_t longest_;
    RopeEquations<lanes> equations_{};
    Lane lanes_[lanes];
    uint32_t count_ = 0;
    bool filled_ = false;  // whether all lanes have valid numbers
};

}  // namespace gphys

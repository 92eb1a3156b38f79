// The memory of the time scheme for a constrained body: the state at the beginning of the substep under way, and the
// state one substep earlier. For cloth it is in Cloth.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct History {
    explicit History(std::pmr::memory_resource* memory)
        : predicted(memory), start(memory), start_velocity(memory), earlier(memory), earlier_velocity(memory) {}

    Vector<Vec3> predicted;  // predicted positions without constraints
    Vector<Vec3> start, start_velocity, earlier, earlier_velocity;
    double earlier_step = 0;  // seconds between the two; 0 if the caller or a contact has interrupted the motion
    bool placed = true;       // whether the caller has placed free particles since the last step, or there was none
    bool in_stages = false;   // whether the substeps of the step under way have two stages (TR-BDF2)
};

}  // namespace gphys

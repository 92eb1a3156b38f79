// What the time scheme remembers of a constrained body: the state at the beginning of the substep under way, and the
// one a substep before it. Of cloth it is in Cloth.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct History {
    explicit History(std::pmr::memory_resource* memory)
        : predicted(memory), start(memory), start_velocity(memory), earlier(memory), earlier_velocity(memory) {}

    Vector<Vec3> predicted;  // where the particles would go without constraints
    Vector<Vec3> start, start_velocity, earlier, earlier_velocity;
    double earlier_step = 0;  // seconds between the two; 0 when motion was interrupted, by the caller or a contact
    bool in_stages = false;   // whether the substeps of the step under way are made by both formulas of TimeScheme
};

}  // namespace gphys

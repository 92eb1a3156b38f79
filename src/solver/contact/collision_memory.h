// Memory of a worker for what collision detection would otherwise have on the stack, which may be small: fibers and the
// threads of some systems have 16 KB. prepare() allocates it, for steps beside a scene.
#pragma once

#include "foundation/made_later.h"
#include "solver/cloth/contact_search.h"
#include "solver/contact/collision.h"
#include "solver/particles/flight_kernels.h"

namespace gphys {

/// About 60 KB. Each object is used by one function at a time, which makes it.
struct CollisionMemory {
    /// Boxes around nearby models. Groups of flying particles are not tested against more than this.
    static constexpr uint32_t most_obstacles = 48;

    MadeLater<Collider> collider;
    MadeLater<ContactSearch> search;
    FlightObstacle obstacles[most_obstacles];
};

}  // namespace gphys

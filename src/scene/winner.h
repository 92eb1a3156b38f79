// The nearest of what a query has met.
#pragma once

#include <limits>

#include "foundation/ids.h"
#include "octree/octree.h"

namespace gphys {

/// The best answer so far: the smallest value as it is reported, then the lowest id, in whatever order the octree
/// delivers.
struct Winner {
    float value = std::numeric_limits<float>::infinity();
    uint32_t slot = Octree::none;

    bool exists() const { return slot != Octree::none; }
    bool is_beaten_by(float other, uint32_t other_slot, const IdTable& ids) const {
        return !exists() || other < value || (other == value && ids.id(other_slot) < ids.id(slot));
    }
};

}  // namespace gphys

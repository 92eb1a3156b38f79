// The nearest result of a query so far.
#pragma once

#include <limits>

#include "bvh/bvh8.h"
#include "foundation/ids.h"

namespace gphys {

/// The best result so far: the smallest value as it is reported, then the lowest id, independent of the order of
/// traversal.
struct BestCandidate {
    float value = std::numeric_limits<float>::infinity();
    uint32_t slot = Bvh8::none;

    bool exists() const { return slot != Bvh8::none; }
    bool is_beaten_by(float other, uint32_t other_slot, const IdTable& ids) const {
        return !exists() || other < value || (other == value && ids.id(other_slot) < ids.id(slot));
    }
};

}  // namespace gphys

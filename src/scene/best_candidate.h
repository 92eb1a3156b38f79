// The nearest result of a query so far. Queries visit models in an order that depends on the BVH; the result does not.
#pragma once

#include <limits>

#include "bvh/bvh8.h"
#include "foundation/ids.h"

namespace gphys {

/// The smallest reported value (reported.h), of equal ones the lowest id.
struct BestCandidate {
    float value = std::numeric_limits<float>::infinity();
    uint32_t slot = Bvh8::none;

    bool exists() const { return slot != Bvh8::none; }
    bool is_beaten_by(float other, uint32_t other_slot, const IdTable& ids) const {
        return !exists() || other < value || (other == value && ids.id(other_slot) < ids.id(slot));
    }
};

}  // namespace gphys

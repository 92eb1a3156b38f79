// Listing of a bit set (slot_set.h) by compress-stores, for each instruction set.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

struct SlotSetKernels {
    /// Writes entries[slot] for each set bit, 32 slots a word, in ascending order, and moves `out` behind the last one.
    /// Stops at a word for which 32 elements have no room before `end`; returns the number of words listed. Elements
    /// from `out` to `end` are undefined then.
    uint32_t (*list)(const uint32_t* words, uint32_t word_count, const uint32_t* entries, uint32_t*& out,
                     const uint32_t* end);
};

GPHYS_DECLARE_KERNELS(SlotSetKernels, slot_set_kernels)

}  // namespace gphys

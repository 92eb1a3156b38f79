// Listing of a bit set (slot_set.h) by compress-stores, for each instruction set.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

struct SlotSetKernels {
    /// Writes entries[slot] for each set bit, 32 slots a word, in ascending order; returns the end. Writes up to eight
    /// elements after it.
    uint32_t* (*list)(const uint32_t* words, uint32_t word_count, const uint32_t* entries, uint32_t* out);
};

GPHYS_DECLARE_KERNELS(SlotSetKernels, slot_set_kernels)

}  // namespace gphys

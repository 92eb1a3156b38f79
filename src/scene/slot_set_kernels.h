// A set of slots as a list, once for each instruction set.
#pragma once

#include <cstdint>

#include "foundation/isa.h"

namespace gphys {

struct SlotSetKernels {
    /// Of each slot in a set, 32 to a word, its entry in `entries`, in ascending order of slots; returns the
    /// end. Up to eight entries more are written behind it.
    uint32_t* (*take)(const uint32_t* words, uint32_t word_count, const uint32_t* entries, uint32_t* out);
};

GPHYS_DECLARE_KERNELS(SlotSetKernels, slot_set_kernels)

}  // namespace gphys

// A bit set of slots in memory of the caller. Lists many slots in ascending order without sorting.
#pragma once

#include <algorithm>

#include "foundation/compiler.h"
#include "scene/slot_set_kernels.h"

namespace gphys {

class SlotSet {
public:
    static uint32_t words_for(uint32_t slots) { return slots / 32 + 1; }
    /// What list may write behind what it lists.
    static constexpr uint32_t spare = 8;

    SlotSet(uint32_t* words, uint32_t slots) : words_(words), slots_(slots) {
        std::fill(words_, words_ + words_for(slots), 0);
    }

    void add(uint32_t slot) { words_[slot / 32] |= 1u << slot % 32; }

    /// Of each slot in the set its entry in `entries`, by ascending slots; returns the end.
    uint32_t* list(const SlotSetKernels& kernels, const uint32_t* entries, uint32_t* out) const {
        const uint32_t whole = slots_ / 32;
        out = kernels.take(words_, whole, entries, out);
        for (uint32_t rest = words_[whole]; rest != 0; rest &= rest - 1) {
            *out++ = entries[32 * whole + static_cast<uint32_t>(lowest_bit(rest))];
        }
        return out;
    }

private:
    uint32_t* words_;
    uint32_t slots_;
};

}  // namespace gphys

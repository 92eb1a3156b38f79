// A bit set of slots in the caller's memory. It lists thousands of slots in ascending order faster than a sort, since
// the listing is linear and has no unpredictable branch.
#pragma once

#include <algorithm>

#include "foundation/compiler.h"
#include "scene/slot_set_kernels.h"

namespace gphys {

class SlotSet {
public:
    static uint32_t words_for(uint32_t slots) { return slots / 32 + 1; }
    /// Elements that list() may write after the last one.
    static constexpr uint32_t spare = 8;
    /// The elements that an array needs beyond the listed ones to hold the set, too.
    static uint32_t room_for(uint32_t slots) { return spare + words_for(slots); }

    SlotSet(uint32_t* words, uint32_t slots) : words_(words), slots_(slots) {
        std::fill(words_, words_ + words_for(slots), 0);
    }

    void add(uint32_t slot) { words_[slot / 32] |= 1u << slot % 32; }

    /// Writes entries[slot] for each slot in the set, in ascending order of slots; returns the end.
    uint32_t* list(const SlotSetKernels& kernels, const uint32_t* entries, uint32_t* out) const {
        const uint32_t whole = slots_ / 32;
        out = kernels.list(words_, whole, entries, out);
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

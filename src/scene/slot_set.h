// A bit set of slots in the caller's memory. It lists slots in ascending order faster than a sort, since the listing is
// linear and has no unpredictable branch.
#pragma once

#include <algorithm>

#include "foundation/compiler.h"
#include "scene/slot_set_kernels.h"

namespace gphys {

class SlotSet {
public:
    static uint32_t words_for(uint32_t slots) { return slots / 32 + 1; }

    SlotSet(uint32_t* words, uint32_t slots) : words_(words), slots_(slots) {
        std::fill(words_, words_ + words_for(slots), 0);
    }

    void add(uint32_t slot) { words_[slot / 32] |= 1u << slot % 32; }

    /// Writes entries[slot] for each slot in the set, in ascending order of slots; returns the end. Of the `room`
    /// elements of `out`, those behind the end are undefined.
    uint32_t* list(const SlotSetKernels& kernels, const uint32_t* entries, uint32_t* out, uint32_t room) const {
        // The last word of entries is not whole.
        uint32_t word = kernels.list(words_, slots_ / 32, entries, out, out + room);
        for (; word < words_for(slots_); ++word) {
            for (uint32_t rest = words_[word]; rest != 0; rest &= rest - 1) {
                *out++ = entries[32 * word + static_cast<uint32_t>(lowest_bit(rest))];
            }
        }
        return out;
    }
    /// The same where the words lie in `out` among the elements that are written. Returns false, with undefined
    /// contents, if a word would be overwritten before it is read.
    bool list_over_words(const uint32_t* entries, uint32_t* out) const {
        for (uint32_t word = 0; word < words_for(slots_); ++word) {
            uint32_t rest = words_[word];
            if (words_ + word + 1 < out + popcount(rest)) return false;
            for (; rest != 0; rest &= rest - 1) {
                *out++ = entries[32 * word + static_cast<uint32_t>(lowest_bit(rest))];
            }
        }
        return true;
    }

private:
    uint32_t* words_;
    uint32_t slots_;
};

}  // namespace gphys

// A set of slots, a bit each, in memory of the caller's: how many slots are put in ascending order
// without sorting.
#pragma once

#include <algorithm>
#include <cstdint>

namespace gphys {

class SlotSet {
public:
    static uint32_t words_for(uint32_t slots) { return slots / 32 + 1; }

    SlotSet(uint32_t* words, uint32_t slots) : words_(words), word_count_(words_for(slots)) {
        std::fill(words_, words_ + word_count_, 0);
    }

    /// Slots are added once each.
    void add(uint32_t slot) {
        words_[slot / 32] |= 1u << slot % 32;
        ++size_;
    }
    uint32_t size() const { return size_; }

    /// Ascending: visit(slot).
    template <class Visit>
    void for_each(Visit&& visit) const {
        for (uint32_t word = 0; word < word_count_; ++word) {
            for (uint32_t rest = words_[word]; rest != 0; rest &= rest - 1) {
                visit(32 * word + static_cast<uint32_t>(__builtin_ctz(rest)));
            }
        }
    }

private:
    uint32_t* words_;
    uint32_t word_count_, size_ = 0;
};

}  // namespace gphys

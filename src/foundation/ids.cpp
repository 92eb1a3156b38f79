// Validation of an id table that was read from a snapshot (ids.h).
#include "foundation/ids.h"

namespace gphys {

const char* IdTable::defect() const {
    if (slots() > capacity) return "there are more slots than ids can name";
    uint32_t live_slots = 0;
    for (uint32_t slot = 0; slot < slots(); ++slot) {
        if ((entries_[slot] & ~slot_mask) == 0) return "an id has generation 0";
        live_slots += live(slot) ? 1 : 0;
    }
    if (slots() > capacity || live_slots != live_ || live_ + free_ != slots())
        return "live and free slots are miscounted";
    uint32_t slot = oldest_;
    for (uint32_t i = 0; i < free_; ++i) {
        if (slot >= slots() || live(slot)) return "the queue of free slots holds one that is not free";
        // A cycle through the newest slot would reach it more than once.
        if ((i + 1 == free_) != (slot == newest_)) return "the queue of free slots does not end where it should";
        slot = slot_of(entries_[slot]);
    }
    // A cycle would never reach the end mark.
    if (free_ > 0 && slot != slot_mask) return "the queue of free slots has no end";
    return nullptr;
}

}  // namespace gphys

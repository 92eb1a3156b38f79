// A table of generational ids (handles): slot in the low 24 bits, generation in the high 8. Generations start at 1, so
// no id is 0. Freeing a slot advances its generation, so a stale id is not valid again until all 255 generations of
// its slot have been used.
//
// Free slots are in a FIFO queue. A slot is reused only while at least `least_free` slots are free; otherwise a new
// slot is added. So 1023 other slots are reused before the same one again, and a stale id becomes valid after 254 *
// 1024 = 260 096 additions at the earliest. The cost is up to 1023 slots more than were ever in use at a time. Only if
// no slot can be added, with almost 2^24 in use, the queue shrinks further.
#pragma once

#include <algorithm>

#include "foundation/large_array.h"

namespace gphys {

class IdTable {
public:
    static constexpr uint32_t capacity = (1u << 24) - 1;
    /// Slots are reused only while at least this many are free.
    static constexpr uint32_t least_free = 1024;
    static constexpr uint32_t slot_of(uint32_t id) { return id & slot_mask; }

    template <class Source>
    explicit IdTable(Source* memory) : entries_(memory) {}

    /// Upper bound of slots() while at most `live` slots are in use.
    static constexpr uint32_t slots_for(uint32_t live) {
        return live > capacity - (least_free - 1) ? capacity : live + (least_free - 1);
    }

    /// Reserves memory so that the next `count` calls of add do not throw. Returns false beyond `capacity`.
    bool reserve(uint32_t count) {
        if (count > capacity - live_) return false;
        const uint32_t added = std::min(count - std::min(count, ready()), capacity - slots());
        if (added > 0) reserve_more(entries_, added);
        return true;
    }

    uint32_t add() {
        ++live_;
        if (ready() == 0) {
            const uint32_t id = first_generation | slots();
            entries_.push_back(id);
            return id;
        }
        const uint32_t slot = oldest_;
        oldest_ = slot_of(entries_[slot]);
        --free_;
        return entries_[slot] = (entries_[slot] & ~slot_mask) | slot;
    }

    /// The slots that the next `count` calls of add will use, after reserve(count).
    void next_slots(uint32_t count, uint32_t* out) const {
        const uint32_t used_again = std::min(count, ready()), added = std::min(count - used_again, capacity - slots());
        uint32_t slot = oldest_;
        for (uint32_t i = 0; i < count; ++i) {
            if (i >= used_again && i < used_again + added) {
                out[i] = slots() + (i - used_again);
            } else {
                out[i] = slot;
                slot = slot_of(entries_[slot]);
            }
        }
    }

    void remove(uint32_t id) {
        const uint32_t slot = slot_of(id);
        const uint32_t generation = id & ~slot_mask;
        entries_[slot] = (generation == ~slot_mask ? first_generation : generation + first_generation) | slot_mask;
        if (free_ == 0) {
            oldest_ = slot;
        } else {
            entries_[newest_] = (entries_[newest_] & ~slot_mask) | slot;
        }
        newest_ = slot;
        ++free_;
        --live_;
    }

    bool has(uint32_t id) const { return slot_of(id) < slots() && entries_[slot_of(id)] == id; }
    bool live(uint32_t slot) const { return slot_of(entries_[slot]) == slot; }
    /// The id of a live slot.
    uint32_t id(uint32_t slot) const { return entries_[slot]; }
    /// The array that id() reads, indexed by slot.
    const uint32_t* ids() const { return entries_.data(); }
    /// The number of slots, live and free.
    uint32_t slots() const { return static_cast<uint32_t>(entries_.size()); }
    uint32_t size() const { return live_; }

    /// Over the live slots, ascending: for (const uint32_t slot : ids). Slots may become free meanwhile.
    class Iterator {
    public:
        Iterator(const IdTable& ids, uint32_t slot) : ids_(ids), slot_(slot) { skip_free(); }
        uint32_t operator*() const { return slot_; }
        Iterator& operator++() {
            ++slot_;
            skip_free();
            return *this;
        }
        bool operator!=(const Iterator& other) const { return slot_ != other.slot_; }

    private:
        void skip_free() {
            while (slot_ < ids_.slots() && !ids_.live(slot_)) ++slot_;
        }

        const IdTable& ids_;
        uint32_t slot_;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, slots()}; }

    /// Serialization (foundation/archive.h). Check defect() after reading.
    template <class Archive, class Table>
    static void visit(Archive& archive, Table& table) {
        archive.array(table.entries_);
        archive.value(table.live_);
        archive.value(table.free_);
        archive.value(table.oldest_);
        archive.value(table.newest_);
    }
    /// What is inconsistent in the table, or nullptr.
    const char* defect() const;

private:
    static constexpr uint32_t slot_mask = (1u << 24) - 1;  // as a link: no slot, because capacity is below it
    static constexpr uint32_t first_generation = 1u << 24;

    /// The number of free slots that can be reused before one is added.
    uint32_t ready() const {
        if (slots() == capacity) return free_;
        return free_ < least_free ? 0 : free_ - (least_free - 1);
    }

    // The entry of a live slot is its id. That of a free slot has its next generation and, as a linked list, the next
    // free slot, which is never the slot itself.
    LargeArray<uint32_t> entries_;
    uint32_t live_ = 0, free_ = 0;
    uint32_t oldest_ = slot_mask, newest_ = slot_mask;
};

}  // namespace gphys

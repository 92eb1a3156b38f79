// Ids of things that come and go: slot in the low 24 bits, generation in the high 8. A generation
// is never 0, so no id is 0; it advances when a slot is freed, so a stale id never finds the next
// tenant. Freed slots queue up and the longest free one is taken first, which keeps an old id
// invalid for as long as possible.
#pragma once

#include "foundation/memory.h"

namespace gphys {

class IdTable {
public:
    static constexpr uint32_t capacity = (1u << 24) - 1;
    static constexpr uint32_t slot_of(uint32_t id) { return id & slot_mask; }

    explicit IdTable(std::pmr::memory_resource* memory) : entries_(memory) {}

    /// Make room so that the next `count` calls of add cannot throw. False beyond `capacity`.
    bool reserve(uint32_t count) {
        if (count > capacity - live_) return false;
        if (count > free_) reserve_more(entries_, count - free_);
        return true;
    }

    uint32_t add() {
        ++live_;
        if (free_ == 0) {
            const uint32_t id = first_generation | slots();
            entries_.push_back(id);
            return id;
        }
        const uint32_t slot = oldest_;
        oldest_ = slot_of(entries_[slot]);
        --free_;
        return entries_[slot] = (entries_[slot] & ~slot_mask) | slot;
    }

    /// The slots that the next `count` calls of add will take.
    void next_slots(uint32_t count, uint32_t* out) const {
        uint32_t slot = oldest_;
        for (uint32_t i = 0; i < count; ++i) {
            out[i] = i < free_ ? slot : slots() + (i - free_);
            if (i < free_) slot = slot_of(entries_[slot]);
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
    /// Of a live slot.
    uint32_t id(uint32_t slot) const { return entries_[slot]; }
    /// What id() reads of slot 0, and behind it of the others.
    const uint32_t* ids() const { return entries_.data(); }
    /// Live and free ones; each slot is below this.
    uint32_t slots() const { return static_cast<uint32_t>(entries_.size()); }
    uint32_t size() const { return live_; }

    /// For archives (solver/snapshot/archive.h) to write a table or to read it; what was read is to be checked.
    template <class Archive, class Table>
    static void visit(Archive& archive, Table& table) {
        archive.array(table.entries_);
        archive.value(table.live_);
        archive.value(table.free_);
        archive.value(table.oldest_);
        archive.value(table.newest_);
    }
    /// What is wrong with the queue of free slots, or nullptr.
    const char* defect() const;

private:
    static constexpr uint32_t slot_mask = (1u << 24) - 1;  // as a slot: none, for capacity is below it
    static constexpr uint32_t first_generation = 1u << 24;

    // A live entry is the id itself; a free one has the generation of its next tenant and the next
    // free slot, which is never the slot itself.
    Vector<uint32_t> entries_;
    uint32_t live_ = 0, free_ = 0;
    uint32_t oldest_ = slot_mask, newest_ = slot_mask;
};

}  // namespace gphys

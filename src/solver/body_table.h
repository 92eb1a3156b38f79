// The bodies of a solver by slot. A body stays at its address until it is removed, so that adding one costs no more
// beside thousands of others: only the table of addresses grows. A free slot has no body, and costs eight bytes.
#pragma once

#include <memory>

#include "foundation/large_array.h"
#include "solver/body.h"

namespace gphys {

struct BodyDeleter {
    std::pmr::memory_resource* memory;

    void operator()(Body* body) const {
        body->~Body();
        memory->deallocate(body, sizeof(Body), alignof(Body));
    }
};
/// A body outside of the table.
using BodyOwner = std::unique_ptr<Body, BodyDeleter>;

/// Throws std::bad_alloc.
inline BodyOwner new_body(std::pmr::memory_resource* memory) {
    // Nothing throws after the allocation, because empty parts allocate nothing.
    return BodyOwner(new (memory->allocate(sizeof(Body), alignof(Body))) Body(memory), {memory});
}

class BodyTable {
public:
    /// Over the bodies, in the order of their slots.
    template <class Record, class Value>
    class Iterator {
    public:
        Iterator(Record at, Record end) : at_(at), end_(end) { skip_free(); }
        Value& operator*() const { return **at_; }
        Iterator& operator++() {
            ++at_;
            skip_free();
            return *this;
        }
        bool operator!=(const Iterator& other) const { return at_ != other.at_; }

    private:
        void skip_free() {
            while (at_ != end_ && !*at_) ++at_;
        }

        Record at_, end_;
    };

    explicit BodyTable(Memory* memory) : by_slot_(memory) {}
    BodyTable(BodyTable&&) noexcept = default;
    /// Both have the same source of memory. `other` gets the former bodies.
    BodyTable& operator=(BodyTable&& other) noexcept = default;
    ~BodyTable() {
        for (uint32_t slot = 0; slot < by_slot_.size(); ++slot) remove(slot);
    }

    std::pmr::memory_resource* memory() const { return by_slot_.memory(); }
    /// Makes room for one more slot. Throws std::bad_alloc.
    void reserve_slot() { reserve_more(by_slot_, 1); }
    /// Throws std::bad_alloc.
    void add_slots(uint32_t count) { by_slot_.resize(by_slot_.size() + count, nullptr); }
    /// The slot is free, or the next one, for which there is room.
    void put(uint32_t slot, BodyOwner body) noexcept {
        if (slot == by_slot_.size()) by_slot_.push_back(nullptr);
        by_slot_[slot] = body.release();
    }
    void remove(uint32_t slot) noexcept {
        if (by_slot_[slot]) BodyDeleter{memory()}(by_slot_[slot]);
        by_slot_[slot] = nullptr;
    }

    /// The slot must not be free.
    Body& operator[](uint32_t slot) { return *by_slot_[slot]; }
    const Body& operator[](uint32_t slot) const { return *by_slot_[slot]; }
    Iterator<Body* const*, Body> begin() { return {by_slot_.begin(), by_slot_.end()}; }
    Iterator<Body* const*, Body> end() { return {by_slot_.end(), by_slot_.end()}; }
    Iterator<Body* const*, const Body> begin() const { return {by_slot_.begin(), by_slot_.end()}; }
    Iterator<Body* const*, const Body> end() const { return {by_slot_.end(), by_slot_.end()}; }

private:
    LargeArray<Body*> by_slot_;
};

}  // namespace gphys

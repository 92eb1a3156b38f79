// The rigid links of cloth as adjacency lists (compressed sparse rows). The search for reach limits and the search for
// braces traverse them.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct Constraints;

struct RigidLinks {
    /// A link as one of its particles sees it.
    struct End {
        uint32_t to, slot;  // the other particle, and the slot of the constraint
        double rest;

        bool operator<(const End& other) const { return to != other.to ? to < other.to : slot < other.slot; }
    };

    /// A link that came or went.
    struct Edit {
        uint32_t a, b, slot;
        double rest;
        bool added;
    };

    explicit RigidLinks(std::pmr::memory_resource* memory) : begin(memory), at(memory), edits(memory), kinds(memory) {}

    Vector<uint32_t> begin;   // at[begin[p] .. begin[p + 1]]: the links of particle p,
    Vector<End> at;           // sorted by their other end and by slot. Both empty: out of date
    Vector<Edit> edits;       // since the last search for braces (braces.cpp)
    size_t listed_edits = 0;  // of them, those that the lists have
    Vector<uint8_t> kinds;    // by slot of a constraint: which of these it is. Empty: not known
    // A diagonal of a cell (braces.cpp); a link that two shorter ones span as well (yielding_chords.h).
    static constexpr uint8_t brace = 1, chord = 2;

    bool has(uint8_t kind, uint32_t slot) const { return slot < kinds.size() && (kinds[slot] & kind) != 0; }

    /// Lists the rigid constraints. O(constraints). Throws std::bad_alloc.
    void list(const Constraints& constraints, uint32_t particles);
    /// Brings the lists, which must not be empty, up to date with the edits. O(links). Throws std::bad_alloc, and then
    /// changes nothing.
    void list_edits(const Constraints& constraints, uint32_t particles);
    /// Call if any link may have changed.
    void forget();
};

/// Updates which links are braces and chords. Call after the links were listed. O(links) at first, then O(particles).
/// Throws std::bad_alloc.
void find_braces(RigidLinks& rigid, uint32_t constraint_slots);

}  // namespace gphys

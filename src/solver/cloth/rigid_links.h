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
    };

    explicit RigidLinks(std::pmr::memory_resource* memory)
        : begin(memory), at(memory), changed(memory), braces(memory) {}

    Vector<uint32_t> begin;  // at[begin[p] .. begin[p + 1]]: the links of particle p,
    Vector<End> at;          // sorted by their other end and by slot. Both empty: out of date
    // For the search for braces (braces.cpp):
    Vector<uint32_t> changed;  // the ends of links that were added or removed since the last search
    Vector<uint8_t> braces;    // by slot of a constraint: 1 if it is a brace. Empty: not known

    bool has_brace(uint32_t slot) const { return slot < braces.size() && braces[slot]; }

    /// Lists the rigid constraints. O(constraints). Throws std::bad_alloc.
    void list(const Constraints& constraints, uint32_t particles);
    /// Call after a link between two particles was added or removed. Uses capacity for two in `changed`.
    void change(uint32_t a, uint32_t b);
    /// Call if any link may have changed.
    void forget();
};

/// Updates which links are braces. Call after the links were listed. O(links) at first, then O(particles). Throws
/// std::bad_alloc.
void find_braces(RigidLinks& rigid, uint32_t constraint_slots);

}  // namespace gphys

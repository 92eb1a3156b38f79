// The rigid links of cloth as adjacency lists (compressed sparse rows). The search for reach limits and the search for
// braces traverse them.
#pragma once

#include "foundation/memory.h"

namespace gphys {

struct Plan;

struct RigidLinks {
    /// A link as one of its particles sees it.
    struct End {
        uint32_t to;
        double rest;
    };

    explicit RigidLinks(std::pmr::memory_resource* memory)
        : begin(memory), at(memory), changed(memory), braces(memory) {}

    Vector<uint32_t> begin;  // at[begin[p] .. begin[p + 1]]: the links of particle p,
    Vector<End> at;          // sorted by their other end. Both empty: out of date
    // For the search for braces (kept_links.cpp):
    Vector<uint32_t> changed;  // the ends of links that were added or removed since the last search
    Vector<uint8_t> braces;    // by slot of a constraint: whether it is a brace, or unknown; unknown beyond the end

    /// Lists the rigid links of the chains of a plan. O(links). Throws std::bad_alloc.
    void list(const Plan& plan, uint32_t particles);
    /// Call after a link between two particles was added or removed. Uses capacity for two in `changed`.
    void change(uint32_t a, uint32_t b);
    /// Call if any link may have changed.
    void forget();
};

}  // namespace gphys

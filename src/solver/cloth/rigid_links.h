// The rigid links of cloth by particle, as what holds particles within reach of pins and what finds braces walk along
// them.
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

    Vector<uint32_t> begin;  // at[begin[p] .. begin[p + 1]]: those of particle p,
    Vector<End> at;          // by the particle that they lead to. Both empty: to be listed
    // Of braces (kept_links.cpp):
    Vector<uint32_t> changed;  // the ends of links that came or went since they were found
    Vector<uint8_t> braces;    // by slot of a constraint: whether it is one, or unknown; beyond the end unknown, too

    /// Those of the chains of a plan. O(links). Throws std::bad_alloc.
    void list(const Plan& plan, uint32_t particles);
    /// They are to be listed again, as one between two particles was added or removed. `changed` needs room for two.
    void change(uint32_t a, uint32_t b);
    /// The same, as any may be another.
    void forget();
};

}  // namespace gphys

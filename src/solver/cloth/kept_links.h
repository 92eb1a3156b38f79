// Rigid links that relax_links keeps within a strain, and those at each particle (kept_links.cpp).
#pragma once

#include "foundation/memory.h"

namespace gphys {

struct ClothBatches;
struct Plan;
struct RigidLinks;

struct KeptLinks {
    static constexpr uint32_t none = 0xffffffff;

    struct Link {
        uint32_t a, b;
        double rest;
        bool limit;           // whether it only pulls
        bool brace;           // not kept without a strain target
        bool chord;           // whether it may give way (yielding_chords.h)
        bool yields = false;  // not kept in this substep
    };

    explicit KeptLinks(std::pmr::memory_resource* memory)
        : links(memory), by_place(memory), begin(memory), at(memory) {}

    Vector<Link> links;
    Vector<uint32_t> by_place;   // by place in ClothBatches::rest: the link there, or none
    Vector<uint32_t> begin, at;  // at[begin[p] .. begin[p + 1]]: the links at particle p
};

/// Call after pack_cloth_chains and find_braces. Marks in the batches which of them have such links. Throws
/// std::bad_alloc.
void list_kept_links(KeptLinks& kept, ClothBatches& batches, const RigidLinks& rigid, const Plan& plan,
                     uint32_t particles);

}  // namespace gphys

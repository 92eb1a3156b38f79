// The rigid links of cloth as adjacency lists (rigid_links.h): counting sort by particle.
#include "solver/cloth/rigid_links.h"

#include "solver/constraints.h"
#include "solver/plan.h"

namespace gphys {
namespace {

template <class Visit>
void each_rigid(const Constraints& constraints, Visit&& visit) {
    for (const uint32_t slot : constraints.ids) {
        if (constraints.by_slot[slot].compliance == 0) visit(slot, constraints.by_slot[slot]);
    }
}

}  // namespace

/// Two counting sorts, by each end, leave each list sorted by the other end (radix sort).
void RigidLinks::list(const Constraints& constraints, uint32_t particles) {
    std::pmr::memory_resource* const memory = at.get_allocator().resource();
    Vector<uint32_t> first(particles + size_t{1}, 0, memory);
    each_rigid(constraints, [&](uint32_t, const DistanceConstraint& c) { ++first[c.a + 1], ++first[c.b + 1]; });
    for (uint32_t p = 0; p < particles; ++p) first[p + 1] += first[p];
    Vector<End> unordered(first.back(), memory);
    Vector<uint32_t> next(first.begin(), first.end() - 1, memory);
    each_rigid(constraints, [&](uint32_t slot, const DistanceConstraint& c) {
        unordered[next[c.a]++] = {c.b, slot, c.rest};
        unordered[next[c.b]++] = {c.a, slot, c.rest};
    });
    at.reserve(first.back() + 2 * Plan::most_edits);
    at.resize(first.back());
    next.assign(first.begin(), first.end() - 1);
    for (uint32_t p = 0; p < particles; ++p) {
        for (uint32_t i = first[p]; i < first[p + 1]; ++i)
            at[next[unordered[i].to]++] = {p, unordered[i].slot, unordered[i].rest};
    }
    begin = std::move(first);
    listed_edits = edits.size();
}

/// Each edit moves the lists behind it, so many take longer than to list all again.
void RigidLinks::list_edits(const Constraints& constraints, uint32_t particles) {
    constexpr size_t few = 4;
    const size_t count = edits.size() - listed_edits;
    if (count > few) return list(constraints, particles);
    at.reserve(at.size() + 2 * count);
    begin.resize(particles + size_t{1}, begin.back());  // new particles have no links yet
    for (; listed_edits < edits.size(); ++listed_edits) {
        const Edit& edit = edits[listed_edits];
        for (const auto& [particle, to] : {std::pair(edit.a, edit.b), std::pair(edit.b, edit.a)}) {
            const auto first = at.begin() + begin[particle], last = at.begin() + begin[particle + 1];
            if (edit.added) {
                const End link{to, edit.slot, edit.rest};
                at.insert(std::upper_bound(first, last, link), link);
            } else {
                at.erase(std::find_if(first, last, [&](const End& link) { return link.slot == edit.slot; }));
            }
            for (uint32_t p = particle + 1; p <= particles; ++p) begin[p] += edit.added ? 1u : ~0u;
        }
    }
}

void RigidLinks::forget() {
    edits.clear();
    listed_edits = 0;
    kinds.clear();
    begin.clear();
    at.clear();
}

}  // namespace gphys

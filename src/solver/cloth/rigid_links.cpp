// The rigid links of cloth as adjacency lists (rigid_links.h): counting sort by particle.
#include "solver/cloth/rigid_links.h"

#include "solver/constraints.h"

namespace gphys {
namespace {

template <class Visit>
void each_rigid(const Constraints& constraints, Visit&& visit) {
    for (uint32_t slot = 0; slot < constraints.ids.slots(); ++slot) {
        if (constraints.ids.live(slot) && constraints.by_slot[slot].compliance == 0)
            visit(slot, constraints.by_slot[slot]);
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
    at.resize(first.back());
    next.assign(first.begin(), first.end() - 1);
    for (uint32_t p = 0; p < particles; ++p) {
        for (uint32_t i = first[p]; i < first[p + 1]; ++i)
            at[next[unordered[i].to]++] = {p, unordered[i].slot, unordered[i].rest};
    }
    begin = std::move(first);
}

void RigidLinks::change(uint32_t a, uint32_t b) {
    changed.insert(changed.end(), {a, b});
    begin.clear();
    at.clear();
}

void RigidLinks::forget() {
    changed.clear();
    braces.clear();
    begin.clear();
    at.clear();
}

}  // namespace gphys

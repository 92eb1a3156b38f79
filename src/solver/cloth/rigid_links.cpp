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
    listed_edits = edits.size();
}

/// Copies the lists, with those of the ends of edits changed.
void RigidLinks::list_edits(uint32_t particles) {
    struct Change {
        uint32_t particle;
        const Edit* edit;

        bool operator<(const Change& other) const {
            return particle != other.particle ? particle < other.particle : edit < other.edit;
        }
    };
    std::pmr::memory_resource* const memory = at.get_allocator().resource();
    Vector<Change> changes(memory);
    for (size_t i = listed_edits; i < edits.size(); ++i) {
        changes.push_back({edits[i].a, &edits[i]});
        changes.push_back({edits[i].b, &edits[i]});
    }
    std::sort(changes.begin(), changes.end());
    Vector<End> links(memory);
    links.reserve(at.size() + changes.size());
    Vector<uint32_t> first(particles + size_t{1}, memory);
    // Particles that are new have no links yet.
    const auto begin_of = [&](uint32_t p) { return begin[std::min<size_t>(p, begin.size() - 1)]; };
    uint32_t next = 0;
    const auto copy_until = [&](uint32_t end) {
        const auto moved = static_cast<uint32_t>(links.size()) - begin_of(next);  // modulo 2^32
        links.insert(links.end(), at.data() + begin_of(next), at.data() + begin_of(end));
        for (; next < end; ++next) first[next] = begin_of(next) + moved;
    };
    for (auto change = changes.begin(); change != changes.end();) {
        const uint32_t p = change->particle;
        copy_until(p);
        const auto own = static_cast<std::ptrdiff_t>(links.size());
        copy_until(p + 1);
        for (; change != changes.end() && change->particle == p; ++change) {
            const Edit& edit = *change->edit;
            if (edit.added) {
                links.push_back({edit.a == p ? edit.b : edit.a, edit.slot, edit.rest});
            } else {
                links.erase(std::find_if(links.begin() + own, links.end(),
                                         [&](const End& link) { return link.slot == edit.slot; }));
            }
        }
        std::sort(links.begin() + own, links.end(),
                  [](const End& a, const End& b) { return a.to != b.to ? a.to < b.to : a.slot < b.slot; });
    }
    copy_until(particles);
    first[particles] = static_cast<uint32_t>(links.size());
    begin.swap(first);
    at.swap(links);
    listed_edits = edits.size();
}

void RigidLinks::forget() {
    edits.clear();
    listed_edits = 0;
    braces.clear();
    begin.clear();
    at.clear();
}

}  // namespace gphys

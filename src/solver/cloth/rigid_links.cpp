// The rigid links of cloth as adjacency lists (rigid_links.h): counting sort by particle.
#include "solver/cloth/rigid_links.h"

#include "solver/plan.h"

namespace gphys {
namespace {

template <class Visit>
void each_rigid(const Plan& plan, Visit&& visit) {
    for (const Chain& chain : plan.chains) {
        const uint32_t* const particles = &plan.particles[chain.first_particle];
        for (uint32_t j = 0; j < chain.link_count; ++j) {
            const uint32_t link = chain.first_link + j;
            if (plan.compliance[link] == 0) visit(particles[j], particles[j + 1], plan.rest[link]);
        }
    }
}

}  // namespace

/// Two counting sorts, by each end, leave each list sorted by the other end (radix sort).
void RigidLinks::list(const Plan& plan, uint32_t particles) {
    std::pmr::memory_resource* const memory = at.get_allocator().resource();
    Vector<uint32_t> first(particles + size_t{1}, 0, memory);
    each_rigid(plan, [&](uint32_t a, uint32_t b, double) { ++first[a + 1], ++first[b + 1]; });
    for (uint32_t p = 0; p < particles; ++p) first[p + 1] += first[p];
    Vector<End> unordered(first.back(), memory);
    Vector<uint32_t> next(first.begin(), first.end() - 1, memory);
    each_rigid(plan, [&](uint32_t a, uint32_t b, double rest) {
        unordered[next[a]++] = {b, rest};
        unordered[next[b]++] = {a, rest};
    });
    at.resize(first.back());
    next.assign(first.begin(), first.end() - 1);
    for (uint32_t p = 0; p < particles; ++p) {
        for (uint32_t i = first[p]; i < first[p + 1]; ++i) at[next[unordered[i].to]++] = {p, unordered[i].rest};
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

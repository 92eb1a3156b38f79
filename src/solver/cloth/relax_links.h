// Relaxation of links of cloth that chains have left strained.
#pragma once

#include <optional>

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/kept_links.h"

namespace gphys {

struct Body;

struct Relaxation {
    explicit Relaxation(std::pmr::memory_resource* memory)
        : kept(memory), strained(memory), waiting(memory), listed(memory) {}

    double most_strain = 0;     // of rigid links; 0: the cloth is not relaxed
    bool braces_yield = false;  // braces are not relaxed
    // In this substep, of joined bodies that nothing holds: the particles at joints stay where they are, so the others
    // would change the angular momentum.
    bool left_out = false;
    double wanted_substep = 0;  // seconds: the longest that would have sufficed, in the worst substep of this step
    double infeasible = 0;      // the strain that was left when a substep of this step failed by far; else 0
    bool given_up = false;      // in this step: shorter substeps did not help
    KeptLinks kept;
    Vector<uint32_t> strained, waiting;  // capacity for all links
    Vector<uint8_t> listed;              // by kept link: whether it is waiting

    void begin_step() {
        wanted_substep = infinity;
        infeasible = 0;
        given_up = false;
    }
    /// For cloth that is relaxed. `places`: the length of ClothBatches::rest. Throws std::bad_alloc.
    void reserve(size_t places) {
        strained.resize(places);
        waiting.resize(kept.links.size());
        listed.assign(kept.links.size(), 0);
    }
};

/// Call after a substep of h seconds. Relaxes links that are strained beyond the target. Returns the energy that forces
/// have lost by it, per average mass, or nothing if no particle was moved.
std::optional<double> relax_links(Body& body, bool collides, double h);

}  // namespace gphys

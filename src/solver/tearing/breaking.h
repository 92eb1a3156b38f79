// Links that break: their breaking forces, and their loads in a step.
//
//   loads.cpp    the loads of a step, and which links they break
//   tear.cpp     the surface of cloth parts at a particle
//   breaks.cpp   breaks at the end of a step and by the caller
//
// The load of a link is its mean tension in the step: the sum of its impulses in all substeps, divided by the step. So
// it does not depend on the number of substeps, and a blow counts by its momentum.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/tearing/tear.h"

namespace gphys {

struct Body;
struct ChainBatch;
struct TimeScheme;

/// A link whose load has exceeded its breaking force.
struct Overload {
    double ratio;  // of its load to its breaking force, above 1
    double load;   // newtons
    uint32_t slot;

    /// The order of a heap with the largest ratio on top; of equal ones, the lowest slot.
    bool operator<(const Overload& other) const {
        return ratio != other.ratio ? ratio < other.ratio : slot > other.slot;
    }
};

struct Breaking {
    explicit Breaking(std::pmr::memory_resource* memory)
        : force(memory), impulse(memory), pull(memory), overloads(memory), space(memory) {}

    bool possible() const { return !force.empty(); }

    Vector<double> force;  // by slot of a constraint, newtons; infinity: never breaks. Empty: none ever breaks
    // Of the step under way:
    uint32_t allowed = 0;        // links that may break: after each break the loads are others, so a few at a time
    Vector<double> impulse;      // N s; by link of the plan, of cloth as in ClothBatches::rest; empty if none breaks
    Vector<float> pull;          // of cloth in the substep under way, by place, in the units of its kernels
    Vector<Overload> overloads;  // capacity for all links
    TearSpace space;
};

/// Newtons, or 0 for a constraint that never breaks.
double breaking_force(const Breaking& breaking, uint32_t slot);
/// The same convention. If it throws std::bad_alloc, nothing has changed; else it wakes the body.
void set_breaking_forces(Body& body, const gphys_constraint_id* ids, const float* forces, uint32_t stride,
                         uint32_t count);

/// Allocates what a step needs; the plan must be current. Throws std::bad_alloc.
void reserve_breaking(Body& body);
/// Call before the first substep.
void begin_loads(Body& body) noexcept;
/// Call at the end of a substep of chains that are solved directly.
void add_chain_loads(Body& body, const TimeScheme& scheme);
/// Call after a batch of cloth was solved. `rows`: the tensions of its links (ClothKernels::find_tensions).
void note_pulls(Breaking& breaking, const ChainBatch& batch, const float* rows, bool again);
/// Call at the end of the substep of cloth, when it is decided whether the time scheme restarts. A force acts on the
/// velocity by h / next in its substep, and by the rest of h through the history of the scheme. A restart drops that.
void add_cloth_loads(Body& body, const TimeScheme& scheme);
/// Lists in Breaking::overloads, as a heap, the links that break after a step of dt seconds.
void find_overloads(Body& body, double dt) noexcept;

}  // namespace gphys

// The plan of a body: in which order its constraints are solved. It follows from the constraints and the pins, and is
// updated after these have changed.
//
//   plan.cpp               updating it
//   rope/plan_chains.cpp   chains of ropes and trees, for direct solution
//   plan_colours.cpp       chains of cloth and their colours
//   hubs.cpp               particles with so many links that sweeps go there and back
//   cloth/plan_cloth.cpp   their layout in the kernels; plan_edits.cpp: edits without planning the body again
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct Body;
struct Constraints;
struct Links;
struct Particles;
struct Rope;

/// Constraints in a row: link i joins particle i and particle i + 1 of the chain.
struct Chain {
    uint32_t first_particle, first_link;  // in the plan's arrays
    uint32_t link_count;
};

struct Plan {
    explicit Plan(std::pmr::memory_resource* source) : memory(source) {}

    void clear_chains();
    void begin_chain(uint32_t particle) {
        chains.push_back({static_cast<uint32_t>(particles.size()), static_cast<uint32_t>(slots.size()), 0});
        particles.push_back(particle);
    }
    /// Adds a link from the last particle of the last chain to the given one.
    void add_link(uint32_t slot, uint32_t particle) {
        particles.push_back(particle);
        slots.push_back(slot);
        ++chains.back().link_count;
    }
    /// Copies the parameters of all links from their constraints.
    void copy_parameters(const Constraints& constraints);

    static constexpr uint32_t most_edits = 64;

    std::pmr::memory_resource* memory;
    gphys_solve_method method = GPHYS_SOLVE_FREE;
    // Whether the chains, and the reach limits of pins, are up to date. If not, they are not used.
    bool chains_current = false, reach_current = false;
    uint32_t edits = 0;      // of the chains since the last step; after most_edits they are planned again
    bool described = false;  // whether the parameters of the links are those of their constraints
    bool chains_packed = false, pins_packed = false;  // whether Cloth::batches and Cloth::reach are up to date

    /// By colour. The chains of a colour share no particle, so their order within it is free.
    Vector<Chain> chains{memory};
    Vector<uint32_t> colours{memory};  // the first chain of each, and the end
    Vector<uint32_t> particles{memory};
    Vector<uint32_t> slots{memory};                                    // by link: of its constraint
    Vector<double> rest{memory}, compliance{memory}, damping{memory};  // by link
    Vector<uint32_t> limit{memory};                                    // by link: 1 if it only pulls
    Vector<uint32_t> hubs{memory};         // of a graph: particles with many links (hubs.cpp)
    bool damped = false, limited = false;  // whether any link is
    bool branched = false;                 // direct, and chains have particles in common: joints/ solves them
    bool crowded = false;                  // whether some hub may move: sweeps go there and back
    bool joined = false;                   // branched, or to other bodies; set at the beginning of a step
};

/// Calls visit(link, a, b) for the links of all chains: its index in the plan, and its particles along the chain.
template <class Visit>
void each_link(const Plan& plan, Visit&& visit) {
    for (const Chain& chain : plan.chains) {
        const uint32_t* const particle = &plan.particles[chain.first_particle];
        for (uint32_t i = 0; i < chain.link_count; ++i) visit(chain.first_link + i, particle[i], particle[i + 1]);
    }
}

/// The method that suits the constraints. O(particles). Throws std::bad_alloc.
gphys_solve_method method_of(const Body& body);
/// The same for a body with this number of constraints.
gphys_solve_method method_of(const Body& body, uint32_t constraints);
/// The same without allocating, if `remaining` has capacity for the particles.
gphys_solve_method method_of(const Body& body, Vector<Links>& remaining);
/// Updates what is out of date. Throws std::bad_alloc, and then leaves it out of date.
void update_plan(Body& body);
/// Computes what a snapshot does not hold of a valid plan. Throws std::bad_alloc.
void complete_plan(Body& body);

// Parts of update_plan. These throw std::bad_alloc.
void plan_direct_chains(Plan& plan, Rope& rope, const Constraints& constraints);
/// Copies the parameters of links that are solved directly.
void copy_direct_parameters(Plan& plan, Rope& rope, const Constraints& constraints);
void plan_chain_colours(Plan& plan, const Constraints& constraints, const Particles& particles);
/// Lists the particles with many links of one kind. O(links log links).
void list_hubs(Vector<uint32_t>& hubs, const Constraints& constraints);

/// plan_edits.cpp: whether a constraint can be added to or removed from the plan of cloth without planning the body
/// again. Call before anything changes, because it reserves memory: the result of an edit must not depend on whether
/// there is any. Throws std::bad_alloc.
bool can_add_to_plan(Body& body);
/// Reserves memory for all edits up to most_edits.
void reserve_plan_edits(Body& body);
bool can_remove_from_plan(Body& body, uint32_t slot);
/// O(links). Call after the constraint was added, or removed.
void add_to_plan(Body& body, uint32_t slot);
void remove_from_plan(Body& body, uint32_t slot);

}  // namespace gphys

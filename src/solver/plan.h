// In which order the constraints of a body are solved. A plan is made from the constraints and the
// pins and is made again when they change.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"

namespace gphys {

struct Body;

/// Constraints in a row: link i joins particle i and particle i + 1 of the chain.
struct Chain {
    uint32_t first_particle, first_link;  // in the plan's arrays
    uint32_t link_count;
};

/// No further than this from a pinned particle.
struct ReachLimit {
    uint32_t particle, anchor;
    double distance;
};

/// What elimination along a chain leaves for substitution, per particle of a rope ...
struct DirectRow {
    double next[4][4];  // times the unknowns of the next particle and link
    double value[4];
};
/// ... and per link of a chain in a family.
struct LineRow {
    Vec3 direction;
    double inverse_pivot, value, coupling;
};

struct Plan {
    explicit Plan(std::pmr::memory_resource* memory)
        : chains(memory),
          particles(memory),
          rest(memory),
          compliance(memory),
          target(memory),
          tension(memory),
          reach_limits(memory),
          direct_rows(memory),
          line_rows(memory) {}

    gphys_solve_method method = GPHYS_SOLVE_FREE;
    bool chains_current = false, reach_current = false;

    /// By family. The chains of a family share no particle, so their order within it is free.
    Vector<Chain> chains;
    Vector<uint32_t> particles;
    Vector<double> rest, compliance;  // by link
    Vector<double> target;            // by link: the length it shall have; only for direct solving
    Vector<double> tension;           // by link: newtons, of the last substep; only for direct solving
    Vector<ReachLimit> reach_limits;

    Vector<DirectRow> direct_rows;  // room for the longest chain
    Vector<LineRow> line_rows;
};

/// Which method suits the constraints. O(particles); allocates nothing.
gphys_solve_method method_of(const Body& body);
/// Bring the plan up to date. Throws std::bad_alloc, and then leaves it out of date.
void update_plan(Body& body);

/// Parts of it: plan_chains.cpp and reach_limits.cpp.
void plan_direct_chains(Body& body);
void plan_chain_families(Body& body);
void plan_reach_limits(Body& body);

/// The solvers. Positions are moved so that the constraints hold; `step` is the effective time step
/// of the scheme: a force f moves a particle by f / m * step^2.
void solve_directly(Body& body, double step);        // rope_direct.cpp
void solve_chain_families(Body& body, double step);  // cloth_families.cpp
void apply_reach_limits(Body& body);                 // reach_limits.cpp

}  // namespace gphys

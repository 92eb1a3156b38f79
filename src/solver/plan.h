// In which order the constraints of a body are solved. A plan is made from the constraints and the
// pins and is made again when they change.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/cloth_kernels.h"

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

/// What elimination along a rope leaves for substitution, per particle.
struct DirectRow {
    double next[4][4];  // times the unknowns of the next particle and link
    double value[4];
};

/// A damped link and the particles at its ends.
struct DampedInCloth {
    uint32_t link;  // in the arrays of the batches
    uint32_t a, b;
    double rest, compliance, damping;
};
/// A rigid link that only pulls.
struct LimitInCloth {
    uint32_t a, b;
    float rest;
};
/// Rigid links that relax_links keeps within a strain, and those at each particle.
struct KeptLinks {
    static constexpr uint32_t none = 0xffffffff;

    struct Link {
        uint32_t a, b;
        double rest;
        bool limit;  // whether it only pulls
        bool brace;  // which yields without a target
    };

    explicit KeptLinks(std::pmr::memory_resource* memory)
        : links(memory), by_place(memory), begin(memory), at(memory) {}

    Vector<Link> links;
    Vector<uint32_t> by_place;   // by place in ClothBatches::rest: the link there, or none
    Vector<uint32_t> begin, at;  // at[begin[p] .. begin[p + 1]]: the links at particle p
};
/// Chains and limits of cloth, packed for cloth_kernels.h. Lanes that are left over hold two
/// particles beyond the last one, which do not move.
struct ClothBatches {
    explicit ClothBatches(std::pmr::memory_resource* memory)
        : chains(memory),
          colours(memory),
          particles(memory),
          rest(memory),
          compliance(memory),
          softness(memory),
          stiffness(memory),
          damped(memory),
          target(memory),
          limits(memory),
          limited(memory),
          anchors(memory),
          ranks(memory),
          distances(memory),
          rows(memory),
          kept(memory) {}

    Vector<ChainBatch> chains;  // colour after colour
    Vector<uint32_t> colours;   // the first batch of each, and the end: those of a colour share no particle
    uint32_t spare = 2;         // particles beyond the last one that a colour's lanes need
    Vector<uint32_t> particles;
    Vector<float> rest;
    Vector<double> compliance;  // by link and chain; infinity for those that are not there
    double scale = 0;           // average mass / step^2, for which this is:
    Vector<float> softness;     // compliance * scale
    Vector<float> stiffness;    // 1 / (compliance * average mass); 0 for rigid links and absent ones
    bool elastic = false;       // whether any is not
    Vector<DampedInCloth> damped;
    Vector<float> target;  // rest, in which those that are damped change; empty if none is
    Vector<LimitInCloth> limits;
    Vector<uint32_t> limited, anchors;
    Vector<uint32_t> ranks;  // in them: the first of each rank, and the end; a rank has no particle twice
    Vector<float> distances;
    uint32_t longest = 0;    // links
    double link_length = 0;  // metres, the average
    Vector<float> rows;      // room for the longest chain, of each who works on the body
    KeptLinks kept;
};

struct Plan {
    explicit Plan(std::pmr::memory_resource* memory)
        : chains(memory),
          colours(memory),
          particles(memory),
          slots(memory),
          rest(memory),
          compliance(memory),
          damping(memory),
          limit(memory),
          damped_rest(memory),
          damped_compliance(memory),
          target(memory),
          tension(memory),
          earlier_tension(memory),
          reach_limits(memory),
          direct_rows(memory),
          batches(memory) {}

    gphys_solve_method method = GPHYS_SOLVE_FREE;
    // What follows from constraints and from pins; when out of date, what is there of it counts for nothing.
    bool chains_current = false, reach_current = false;
    bool described = false;                           // whether the links of the chains are as their constraints are
    bool chains_packed = false, pins_packed = false;  // whether `batches` are of them

    /// By colour. The chains of a colour share no particle, so their order within it is free.
    Vector<Chain> chains;
    Vector<uint32_t> colours;  // the first chain of each, and the end
    Vector<uint32_t> particles;
    Vector<uint32_t> slots;                    // by link: of its constraint
    Vector<double> rest, compliance, damping;  // by link
    Vector<uint32_t> limit;                    // by link: 1 if it only pulls
    bool damped = false, limited = false;      // whether any link is
    bool branched = false;                     // direct, and chains have particles in common: joints/ solves them
    // Only for direct solving, by link:
    Vector<double> damped_rest, damped_compliance;  // in the substep under way, see damping.h
    Vector<double> target;                          // the length it shall have
    Vector<double> tension;                         // newtons, of the last substep
    Vector<double> earlier_tension;                 // of the one before
    Vector<ReachLimit> reach_limits;

    Vector<DirectRow> direct_rows;  // room for the longest chain
    ClothBatches batches;           // the same chains and limits as the kernels take them
};

/// Which method suits the constraints. O(particles). Throws std::bad_alloc.
gphys_solve_method method_of(const Body& body);
/// Bring the plan up to date. Throws std::bad_alloc, and then leaves it out of date.
void update_plan(Body& body);

/// Where the constraints whose lengths change in this step are in the plan, which is up to date; and the lengths of
/// these at a fraction of the step (constraint_settings.cpp). The first throws std::bad_alloc.
void find_changed_links(Body& body);
void change_lengths(Body& body, double fraction);

/// The rest of a plan that came out of a snapshot and has no defect. Throws std::bad_alloc.
void complete_plan(Body& body);

/// Parts of it: plan_chains.cpp, reach_limits.cpp, plan_cloth.cpp and kept_links.cpp.
void plan_direct_chains(Body& body);
void plan_chain_colours(Body& body);
void plan_reach_limits(Body& body);
void pack_cloth_chains(Body& body);
void pack_pins(Body& body);
void list_kept_links(Body& body);

/// Positions are moved so that the constraints hold; `step` is the effective time step of the scheme:
/// a force f moves a particle by f / m * step^2. Returns whether they do.
bool solve_directly(Body& body, double step);

}  // namespace gphys

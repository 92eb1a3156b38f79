// Chains and limits of cloth, as cloth_kernels.h takes them.
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/cloth_kernels.h"

namespace gphys {

struct Body;

/// A way of known length from a pinned particle, along rigid links.
struct ReachWay {
    double length;
    uint32_t particle, anchor;

    /// The shortest first; equal ones in an order that is always the same.
    bool operator<(const ReachWay& other) const {
        if (length != other.length) return length < other.length;
        return particle != other.particle ? particle < other.particle : anchor < other.anchor;
    }
};

/// No further than this from a pinned particle.
struct ReachLimit {
    uint32_t particle, anchor;
    double distance;
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

/// plan_cloth.cpp, reach_limits.cpp and kept_links.cpp: of a plan that is current. They throw std::bad_alloc.
void pack_cloth_chains(Body& body);
void pack_pins(Body& body);
void plan_reach_limits(Body& body);
void list_kept_links(Body& body);

}  // namespace gphys

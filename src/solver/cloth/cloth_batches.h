// Chains of cloth in the layout of cloth_kernels.h: eight side by side, colour after colour (plan_cloth.cpp).
#pragma once

#include "foundation/math.h"
#include "foundation/memory.h"
#include "solver/cloth/cloth_kernels.h"
#include "solver/plan.h"

namespace gphys {

struct Constraints;
struct Particles;

/// A damped link and the particles at its ends.
struct DampedInCloth {
    uint32_t link;  // in the arrays of the batches
    uint32_t a, b;
    double rest, compliance, damping;
};
/// A rigid link that only pulls.
struct LimitInCloth {
    uint32_t link;  // as above
    uint32_t a, b;
    float rest;
};
/// Unused lanes have links between two particles beyond the last one, which do not move.
struct ClothBatches {
    explicit ClothBatches(std::pmr::memory_resource* source) : memory(source) {}

    std::pmr::memory_resource* memory;
    Vector<ChainBatch> chains{memory};  // colour after colour
    Vector<uint32_t> colours{memory};   // the first batch of each, and the end: those of a colour share no particle
    uint32_t spare = 2;                 // particles beyond the last one that a colour's lanes need
    Vector<uint32_t> particles{memory};
    Vector<float> rest{memory};
    Vector<double> compliance{memory};  // by link and chain; infinity for missing links
    double scale = 0;                   // average mass / step^2, for which this is:
    Vector<float> softness{memory};     // compliance * scale
    Vector<float> stiffness{memory};    // 1 / (compliance * average mass); 0 for rigid links and absent ones
    bool elastic = false;               // whether any link stores energy
    Vector<DampedInCloth> damped{memory};
    Vector<float> target{memory};  // rest, with the lengths that damped links and taut rows aim at; empty without any
    Vector<float> continued{memory};  // the lengths that elastic links aim at on the way back; empty if there is none
    Vector<LimitInCloth> limits{memory};
    uint32_t longest = 0;        // links
    double link_length = 0;      // metres, the average
    Vector<float> rows{memory};  // for the longest chain, for each worker
};

/// The plan must be current. Throws std::bad_alloc.
void pack_cloth_chains(ClothBatches& batches, const Plan& plan, uint32_t particles);
/// Calls visit(link of the plan, its index in ClothBatches::rest).
template <class Visit>
void each_link_place(const Plan& plan, const ClothBatches& batches, Visit&& visit) {
    constexpr uint32_t lanes = 8;
    for (size_t colour = 0; colour + 1 < plan.colours.size(); ++colour) {
        for (uint32_t i = plan.colours[colour]; i < plan.colours[colour + 1]; ++i) {
            const uint32_t nth = i - plan.colours[colour];
            const ChainBatch& batch = batches.chains[batches.colours[colour] + nth / lanes];
            for (uint32_t j = 0; j < plan.chains[i].link_count; ++j) {
                visit(plan.chains[i].first_link + j, lanes * (batch.first_link + j) + nth % lanes);
            }
        }
    }
}
/// Marks the batches with pinned or attached particles, of a body that is attached to models.
void mark_attached(ClothBatches& batches, const Constraints& constraints, const Particles& particles);

}  // namespace gphys

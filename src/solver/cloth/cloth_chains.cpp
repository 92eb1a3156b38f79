// Sweeps over the chains of cloth (cloth_chains.h): block Gauss-Seidel with graph colouring, each chain solved directly
// by Thomas's algorithm in the kernels.
#include "solver/cloth/cloth_chains.h"

#include <algorithm>

#include "solver/cloth/reach_limits.h"
#include "solver/quads.h"
#include "solver/rope/damping.h"

namespace gphys {
namespace {

// The largest softness: 1e20 times the inverse mass of the lightest particle. Such a link does not act.
constexpr double softest = 1e26;
constexpr size_t lanes = 8;

ClothChains undamped(const ClothBatches& batches) {
    return {batches.particles.data(), batches.rest.data(), batches.softness.data(), batches.stiffness.data()};
}

}  // namespace

ClothChains chains_of(const ClothBatches& batches) {
    ClothChains chains = undamped(batches);
    if (!batches.target.empty()) chains.rest = batches.target.data();
    return chains;
}

void soften_links(ClothBatches& batches, double average_mass, double step) {
    const double scale = average_mass / (step * step);
    if (batches.scale == scale) return;
    batches.scale = scale;
    for (size_t i = 0; i < batches.compliance.size(); ++i) {
        const double compliance = batches.compliance[i];
        batches.softness[i] = to_float(compliance * scale, softest);
        // Stiffer links than 1e15, and their energy, count as rigid.
        const bool elastic = compliance * average_mass > 1e-15 && compliance < infinity;
        batches.stiffness[i] = elastic ? static_cast<float>(1 / (compliance * average_mass)) : 0;
    }
    batches.elastic = false;
    for (ChainBatch& batch : batches.chains) {
        const auto first = batches.stiffness.begin() + lanes * batch.first_link;
        batch.elastic = std::any_of(first, first + lanes * batch.link_count, [](float s) { return s > 0; });
        batches.elastic = batches.elastic || batch.elastic;
    }
}

void damp_links(ClothBatches& batches, const ClothState& state, const TimeScheme& scheme) {
    for (const DampedInCloth& link : batches.damped) {
        const size_t a = 4 * size_t{link.a}, b = 4 * size_t{link.b};
        const Vec3 now = get(&state.start[b]) - get(&state.start[a]);
        const Vec3 before = now - (get(&state.moved[b]) - get(&state.moved[a]));
        const DampedLink as = damped(link.rest, link.compliance, link.damping, scheme, length(now), length(before), 0);
        batches.target[link.link] = to_float(as.rest, farthest_in_cloth);
        batches.softness[link.link] = to_float(as.compliance * batches.scale, softest);
    }
}

void continue_links(ClothBatches& batches, const ChainBatch& batch, const ClothChains& chains, const float* rows) {
    for (uint32_t j = 0; j < batch.link_count; ++j) {
        const float* const tension = rows + cloth_row_floats * j;
        for (size_t lane = 0; lane < lanes; ++lane) {
            const size_t place = lanes * (batch.first_link + j) + lane;
            const float softness = batches.softness[place];
            batches.continued[place] = chains.rest[place] + (softness > 0 ? softness * tension[lane] : 0);
        }
    }
}

double add_stored_in_links(double sum, const ClothBatches& batches, const ClothState& state, ClothShares& shares) {
    if (!batches.elastic) return sum;
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    share(shares.team, static_cast<uint32_t>(batches.chains.size()), [&](uint32_t i, uint32_t) {
        const ChainBatch& batch = batches.chains[i];
        shares.batch_sums[i] = batch.elastic ? kernels.stored(state.at.data(), undamped(batches), batch) : 0;
    });
    for (const double of_batch : shares.batch_sums) sum += of_batch;
    return sum;
}

void project_links(ClothBatches& batches, const ReachLimits& reach, ClothState& state, Team* team) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    solve_colours(batches, team, [&](const ChainBatch& batch, const ClothChains& chains, float* rows) {
        kernels.solve(state.at.data(), chains, batch, rows);
    });
    apply_reach_limits(reach, state, team);
}

}  // namespace gphys

// Sweeps over the chains of cloth, and the parameters of their links that change from substep to substep.
#pragma once

#include "solver/cloth/cloth_batches.h"
#include "solver/cloth/cloth_state.h"
#include "solver/time_scheme.h"

namespace gphys {

struct ReachLimits;

/// The chains with the lengths that damped links aim at in this substep.
ClothChains chains_of(const ClothBatches& batches);

/// Call before the chains of a substep are solved: elastic and damped links.
void soften_links(ClothBatches& batches, double average_mass, double step);
void damp_links(ClothBatches& batches, const ClothState& state, const TimeScheme& scheme);

/// Adds the energy of elastic links, per average mass, batch by batch to `sum`.
double add_stored_in_links(double sum, const ClothBatches& batches, const ClothState& state, ClothShares& shares);

/// One sweep over the chains and limits, without contacts.
void project_links(ClothBatches& batches, const ReachLimits& reach, ClothState& state, Team* team);

/// For the way back of a sweep: the lengths at which elastic links have the tensions of the way there, which `rows`
/// holds (ClothKernels::find_tensions). So the way back adds what these lack, as iterations of one system do.
void continue_links(ClothBatches& batches, const ChainBatch& batch, const ClothChains& chains, const float* rows);

/// Calls solve(batch, chains, rows) for each batch: colours one after the other, or from the last to the first, the
/// batches of a colour in any order; and solved() after each colour.
template <class Solve, class Solved>
void solve_colours(ClothBatches& batches, Team* team, bool backward, Solve&& solve, Solved&& solved) {
    const ClothChains chains = chains_of(batches);
    const size_t colours = batches.colours.size() - 1;
    for (size_t nth = 0; nth < colours; ++nth) {
        const size_t colour = backward ? colours - 1 - nth : nth;
        const uint32_t first = batches.colours[colour], end = batches.colours[colour + 1];
        share(team, end - first, [&](uint32_t i, uint32_t member) {
            solve(batches.chains[first + i], chains,
                  &batches.rows[size_t{cloth_row_floats} * batches.longest * member]);
        });
        solved();
    }
}

template <class Solve>
void solve_colours(ClothBatches& batches, Team* team, Solve&& solve) {
    solve_colours(batches, team, false, solve, [] {});
}

}  // namespace gphys

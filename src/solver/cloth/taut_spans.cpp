// Lengths of the links of taut rows (taut_spans.h).
#include "solver/cloth/taut_spans.h"

#include "solver/body.h"
#include "solver/quads.h"

namespace gphys {
namespace {

constexpr uint32_t lanes = 8;
// The lengths that links aim at are shorter than the row by this part, so that the row pulls its pins together.
constexpr double tautness = 1e-4;

/// Of links that were in taut rows.
void restore_lengths(Cloth& cloth) {
    KeptLinks& kept = cloth.relaxation.kept;
    for (size_t place = 0; place < kept.by_place.size(); ++place) {
        if (kept.by_place[place] != KeptLinks::none) kept.links[kept.by_place[place]].rest = cloth.batches.rest[place];
    }
}

}  // namespace

void list_pinned_spans(Cloth& cloth, const Plan& plan, const Particles& particles) {
    Vector<PinnedSpan>& spans = cloth.taut.spans;
    spans.clear();
    if (cloth.taut.stretch != 1) restore_lengths(cloth);
    cloth.taut.stretch = 1;
    for (size_t colour = 0; colour + 1 < plan.colours.size(); ++colour) {
        for (uint32_t i = plan.colours[colour]; i < plan.colours[colour + 1]; ++i) {
            const Chain& chain = plan.chains[i];
            const uint32_t nth = i - plan.colours[colour];
            const ChainBatch& batch = cloth.batches.chains[cloth.batches.colours[colour] + nth / lanes];
            uint32_t pin = chain.link_count + 1;  // the last pin; none yet
            for (uint32_t j = 0; j <= chain.link_count; ++j) {
                if (j > 0 && (plan.compliance[chain.first_link + j - 1] > 0 || plan.limit[chain.first_link + j - 1]))
                    pin = chain.link_count + 1;
                if (!particles.pinned(plan.particles[chain.first_particle + j])) continue;
                if (pin + 1 < j) {
                    spans.push_back({plan.particles[chain.first_particle + pin],
                                     plan.particles[chain.first_particle + j],
                                     lanes * (batch.first_link + pin) + nth % lanes, j - pin});
                }
                pin = j;
            }
        }
    }
    if (!spans.empty() || !cloth.batches.damped.empty()) {
        cloth.batches.target = cloth.batches.rest;
    } else {
        cloth.batches.target.clear();
    }
    if (!spans.empty()) cloth.reach.stretched = cloth.reach.distances;
}

void stretch_taut_spans(Cloth& cloth) {
    ClothBatches& batches = cloth.batches;
    const double before = cloth.taut.stretch;
    double stretch = 1;
    for (const PinnedSpan& span : cloth.taut.spans) {
        double total = 0;
        for (uint32_t j = 0; j < span.count; ++j) total += batches.rest[span.first + lanes * j];
        const double apart =
            distance(get(&cloth.state.at[4 * size_t{span.a}]), get(&cloth.state.at[4 * size_t{span.b}]));
        const double part = total > 0 ? std::max(1.0, apart / total * (1 - tautness)) : 1;
        if (part == 1 && before == 1) continue;
        stretch = std::max(stretch, part);
        for (uint32_t j = 0; j < span.count; ++j) {
            const uint32_t place = span.first + lanes * j;
            batches.target[place] = static_cast<float>(batches.rest[place] * part);
            const uint32_t number = cloth.relaxation.kept.by_place[place];
            if (number != KeptLinks::none) cloth.relaxation.kept.links[number].rest = batches.target[place];
        }
    }
    cloth.taut.stretch = stretch;
    if (stretch == before) return;
    for (size_t i = 0; i < cloth.reach.distances.size(); ++i)
        cloth.reach.stretched[i] = static_cast<float>(cloth.reach.distances[i] * stretch);
}

}  // namespace gphys

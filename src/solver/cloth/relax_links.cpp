// Links of cloth that a substep has left strained beyond the error target.
//
// Chains are solved once, as if no link turned by it: one that turns by a third of a radian is then a twentieth too
// long, and so are those whose ends meet walls after the chains. What is left in this way is local. Passes over the
// few strained links, one after the other, bring it below the target for a small part of the work of shorter substeps.
// Sweeps over whole chains once more would not: where these are folded, they do not converge.
//
// Positions alone are moved. Velocities that followed them would make the links whip.
#include "solver/cloth/cloth_kernels.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// What is left after so many is not local: 500 were seen to take a strain of 10.6 % to 9.9 %.
constexpr uint32_t most_passes = 64;
// On a mesh so many take about as long as the rest of the substep, so that shorter ones would take longer.
constexpr double aimed_passes = 12;
// Links strained by more than this part of the target are relaxed, so that what they do to others stays below it.
constexpr double relaxed_part = 0.5;
// Of a length, in float32.
constexpr double rounding = 0x1p-23;

/// Returns the largest strain.
double find_strained(const ClothBatches& batches, ClothState& cloth, uint32_t& count) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    const ClothChains chains{batches.particles.data(), batches.rest.data(), batches.softness.data(), nullptr};
    const float part = static_cast<float>(relaxed_part * cloth.most_strain);
    count = 0;
    for (const ChainBatch& batch : batches.chains) {
        count += kernels.list_strained(cloth.at.data(), chains, batch, part, cloth.strained.data() + count);
    }
    double largest = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const StrainedLink& link = cloth.strained[i];
        if (link.rest == 0) continue;
        const Vec3 a = get(&cloth.at[4 * size_t{link.a}]), b = get(&cloth.at[4 * size_t{link.b}]);
        largest = std::max(largest, std::fabs(distance(a, b) / link.rest - 1));
    }
    return largest;
}

/// Returns what forces have lost by it.
double move(Body& body, uint32_t particle, Vec3 way, bool collides) {
    const size_t i = 4 * size_t{particle};
    const Vec3 before = get(&body.cloth.at[i]);
    shift(body, particle, way, collides);
    return body.cloth.acceleration[i + 3] * dot(get(&body.cloth.acceleration[i]), before - get(&body.cloth.at[i]));
}

double relax(Body& body, const StrainedLink& link, bool collides) {
    const float *a = &body.cloth.at[4 * size_t{link.a}], *b = &body.cloth.at[4 * size_t{link.b}];
    const double weight_a = a[3], weight_b = b[3], weight = weight_a + weight_b;
    const Vec3 along = get(b) - get(a);
    const double length = gphys::length(along), error = length - link.rest;
    if (length == 0 || weight == 0 || (link.limit && error < 0)) return 0;
    const Vec3 correction = along * (error / (length * weight));
    return move(body, link.a, correction * weight_a, collides) + move(body, link.b, correction * -weight_b, collides);
}

}  // namespace

double relax_links(Body& body, bool collides, double h) {
    ClothState& cloth = body.cloth;
    double lost = 0;
    uint32_t passes = 0, count = 0;
    for (; passes < most_passes; ++passes) {
        if (find_strained(body.plan.batches, cloth, count) <= cloth.most_strain - rounding) break;
        for (uint32_t i = 0; i < count; ++i) lost += relax(body, cloth.strained[i], collides);
    }
    // What is left grows with the square of the substep, and so do the passes.
    if (passes > 0) cloth.wanted_substep = std::min(cloth.wanted_substep, h * std::sqrt(aimed_passes / passes));
    return lost;
}

}  // namespace gphys

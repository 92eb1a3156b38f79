// Relaxation of links of cloth that a substep has left strained beyond the error target (local Gauss-Seidel).
//
// Chains are solved once, with the directions that links had before. So a link that turns by a third of a radian ends a
// twentieth too long. So do links whose ends hit contact planes after the chains. These errors are local. Passes over
// the few strained links, one after the other, bring them below the target for a fraction of the work of shorter
// substeps. More sweeps over whole chains would not: they do not converge where chains are folded.
//
// Only positions move. Velocities derived from these displacements would make the links whip. But if the ends separate
// faster than they are brought together again, that speed must go. Otherwise they would stand still at some metres per
// second between chains that push them apart and passes that bring them back, and their neighbours would get that speed
// sooner or later. It is lost as in an inelastic impact.
#include "solver/cloth/relax_links.h"
#include "solver/cloth/cloth_kernels.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Errors that remain after this many passes are not local: 500 were seen to take a strain of 10.6 % to 9.9 %.
constexpr uint32_t most_passes = 64;
// Without a target, this many links are relaxed in a substep, relative to all. Infeasible lengths, as between pins too
// far apart, must not take many times as long as the rest.
constexpr uint32_t most_work = 4;
// On a mesh this many take about as long as the rest of the substep, so shorter substeps would take longer.
constexpr double aimed_passes = 12;
// Links strained by more than this fraction of the target are relaxed, so that their effect on others stays below it.
constexpr double relaxed_part = 0.5;
// Fraction of the inverse mass of a particle that friction holds. With all of it, the passes would move cloth down a
// slope step by step. Links between two such particles still get their lengths back.
constexpr double held_part = 0.1;
// Relative rounding of a length in float32.
constexpr double rounding = 0x1p-23;

/// The excess length or, unless the link only pulls, the missing length (< 0), in metres; else 0.
double error_of(const Cloth& cloth, const KeptLinks::Link& link) {
    const double error = distance(get(&cloth.at[4 * size_t{link.a}]), get(&cloth.at[4 * size_t{link.b}])) - link.rest;
    return link.limit ? std::max(0.0, error) : error;
}

bool yields(const Cloth& cloth, const KeptLinks::Link& link) { return link.brace && cloth.braces_yield; }

/// Lists them in `strained`; returns the largest strain.
double find_strained(const ClothBatches& batches, Cloth& cloth, uint32_t& count) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    const ClothChains chains{batches.particles.data(), batches.rest.data(), batches.softness.data(), nullptr};
    const float part = static_cast<float>(relaxed_part * cloth.most_strain);
    const uint32_t kinds = cloth.braces_yield ? ChainBatch::threads : ChainBatch::threads | ChainBatch::braces;
    uint32_t listed = 0;
    for (const ChainBatch& batch : batches.chains) {
        if ((batch.kept & kinds) != 0)
            listed += kernels.list_strained(cloth.at.data(), chains, batch, part, &cloth.strained[listed]);
    }
    double largest = 0;
    count = 0;
    for (uint32_t i = 0; i < listed; ++i) {
        const uint32_t number = batches.kept.by_place[cloth.strained[i]];
        if (number == KeptLinks::none) continue;
        const KeptLinks::Link& link = batches.kept.links[number];
        if (yields(cloth, link)) continue;
        cloth.strained[count++] = number;
        largest = std::max(largest, std::fabs(error_of(cloth, link)) / link.rest);
    }
    return largest;
}

/// Returns the work that forces have lost by the displacement.
double move(Body& body, uint32_t particle, Vec3 way, bool collides) {
    const size_t i = 4 * size_t{particle};
    const Vec3 before = get(&body.cloth.at[i]);
    shift(body, particle, way, collides);
    return body.cloth.acceleration[i + 3] * dot(get(&body.cloth.acceleration[i]), before - get(&body.cloth.at[i]));
}

/// Removes the speed at which the ends increase the error, limited to the error per substep. Only for a body in
/// contact, because the second-order time scheme would otherwise continue the motion that has been stopped.
void stop_straining(Cloth& cloth, const KeptLinks::Link& link, Vec3 direction, double error, double h) {
    float *a = &cloth.velocity[4 * size_t{link.a}], *b = &cloth.velocity[4 * size_t{link.b}];
    const double weight_a = cloth.at[4 * size_t{link.a} + 3], weight_b = cloth.at[4 * size_t{link.b} + 3];
    const double rate = dot(get(b) - get(a), direction), most = std::fabs(error) / h;
    if (rate * error <= 0) return;
    const Vec3 impulse = direction * (std::clamp(rate, -most, most) / (weight_a + weight_b));
    put(a, get(a) + impulse * weight_a);
    put(b, get(b) - impulse * weight_b);
}

/// Moves both ends, unless the link is hardly strained. Adds the work that forces have lost. Returns whether it was
/// strained.
bool relax(Body& body, const KeptLinks::Link& link, bool collides, double h, double& lost) {
    const float *a = &body.cloth.at[4 * size_t{link.a}], *b = &body.cloth.at[4 * size_t{link.b}];
    const auto weight_of = [&](uint32_t p, const float* at) {
        return collides && is_held(body, p) ? held_part * at[3] : at[3];
    };
    const double weight_a = weight_of(link.a, a), weight_b = weight_of(link.b, b), weight = weight_a + weight_b;
    const Vec3 along = get(b) - get(a);
    const double length = gphys::length(along), error = length - link.rest;
    if (std::fabs(error) < relaxed_part * body.cloth.most_strain * link.rest) return false;
    if (length == 0 || weight == 0 || (link.limit && error < 0)) return false;
    const Vec3 correction = along * (error / (length * weight));
    if (body.contacts.has_contact) stop_straining(body.cloth, link, along / length, error, h);
    lost += move(body, link.a, correction * weight_a, collides);
    lost += move(body, link.b, correction * -weight_b, collides);
    return true;
}

/// One pass over `strained`, which afterwards lists the links of all moved particles.
void relax_listed(Body& body, uint32_t& count, bool collides, double h, double& lost) {
    const KeptLinks& kept = body.cloth.batches.kept;
    Cloth& cloth = body.cloth;
    uint32_t waiting = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const KeptLinks::Link& link = kept.links[cloth.strained[i]];
        if (!relax(body, link, collides, h, lost)) continue;
        for (const uint32_t p : {link.a, link.b}) {
            for (uint32_t k = kept.begin[p]; k < kept.begin[p + 1]; ++k) {
                const uint32_t next = kept.at[k];
                if (cloth.listed[next] || yields(cloth, kept.links[next])) continue;
                cloth.listed[next] = 1;
                cloth.waiting[waiting++] = next;
            }
        }
    }
    count = waiting;
    for (uint32_t i = 0; i < waiting; ++i) {
        cloth.strained[i] = cloth.waiting[i];
        cloth.listed[cloth.waiting[i]] = 0;
    }
}

}  // namespace

double relax_links(Body& body, bool collides, double h) {
    Cloth& cloth = body.cloth;
    double lost = 0;
    uint32_t passes = 0, count = 0;
    const size_t all = body.cloth.batches.kept.links.size();
    size_t work = cloth.braces_yield ? most_work * all : most_passes * all;
    while (passes < most_passes) {
        const double largest = find_strained(body.cloth.batches, cloth, count);
        if (count == 0 || largest <= cloth.most_strain - rounding) break;
        for (; passes < most_passes && count > 0; ++passes) {
            if (work < count) return lost;
            work -= count;
            relax_listed(body, count, collides, h, lost);
        }
    }
    // The remaining error grows with the square of the substep, and so does the number of passes.
    if (passes > 0) cloth.wanted_substep = std::min(cloth.wanted_substep, h * std::sqrt(aimed_passes / passes));
    return lost;
}

}  // namespace gphys

// Links of cloth that a substep has left strained beyond the error target.
//
// Chains are solved once, as if no link turned by it: one that turns by a third of a radian is then a twentieth too
// long, and so are those whose ends meet contact planes after the chains. What is left in this way is local. Passes
// over the few strained links, one after the other, bring it below the target for a small part of the work of shorter
// substeps. Sweeps over whole chains once more would not: where these are folded, they do not converge.
//
// Positions alone are moved. Velocities that followed them would make the links whip. But ends that part faster than
// they are brought together again do not go on doing so: between chains that push them apart and passes that bring
// them back they would stand still at some metres a second, which their neighbours get sooner or later. That speed is
// lost as in an impact of what is not elastic.
#include "solver/cloth/relax_links.h"
#include "solver/cloth/cloth_kernels.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// What is left after so many is not local: 500 were seen to take a strain of 10.6 % to 9.9 %.
constexpr uint32_t most_passes = 64;
// Without a target so many links are relaxed in a substep, in parts of all: what cannot be kept, as between pins that
// are too far apart, must not take many times as long as the rest.
constexpr uint32_t most_work = 4;
// On a mesh so many take about as long as the rest of the substep, so that shorter ones would take longer.
constexpr double aimed_passes = 12;
// Links strained by more than this part of the target are relaxed, so that what they do to others stays below it.
constexpr double relaxed_part = 0.5;
// Of the inverse mass, that a particle has which friction holds: else passes would take cloth down a slope, step by
// step. Links between two such get their lengths back all the same.
constexpr double held_part = 0.1;
// Of a length, in float32.
constexpr double rounding = 0x1p-23;

/// How much too long or, if it does not only pull, too short, in metres; else 0.
double error_of(const Cloth& cloth, const KeptLinks::Link& link) {
    const double error = distance(get(&cloth.at[4 * size_t{link.a}]), get(&cloth.at[4 * size_t{link.b}])) - link.rest;
    return link.limit ? std::max(0.0, error) : error;
}

bool yields(const Cloth& cloth, const KeptLinks::Link& link) { return link.brace && cloth.braces_yield; }

/// In `strained`; returns the largest strain.
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

/// Returns what forces have lost by it.
double move(Body& body, uint32_t particle, Vec3 way, bool collides) {
    const size_t i = 4 * size_t{particle};
    const Vec3 before = get(&body.cloth.at[i]);
    shift(body, particle, way, collides);
    return body.cloth.acceleration[i + 3] * dot(get(&body.cloth.acceleration[i]), before - get(&body.cloth.at[i]));
}

/// The speed at which the ends make the error larger, as far as it has made the error in a substep. Only of a body that
/// touches something, as the time scheme of second order would go on with what has been stopped.
void stop_straining(Cloth& cloth, const KeptLinks::Link& link, Vec3 direction, double error, double h) {
    float *a = &cloth.velocity[4 * size_t{link.a}], *b = &cloth.velocity[4 * size_t{link.b}];
    const double weight_a = cloth.at[4 * size_t{link.a} + 3], weight_b = cloth.at[4 * size_t{link.b} + 3];
    const double rate = dot(get(b) - get(a), direction), most = std::fabs(error) / h;
    if (rate * error <= 0) return;
    const Vec3 impulse = direction * (std::clamp(rate, -most, most) / (weight_a + weight_b));
    put(a, get(a) + impulse * weight_a);
    put(b, get(b) - impulse * weight_b);
}

/// Both ends, unless the link is hardly strained. Adds what forces have lost by it; whether it was strained.
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

/// A pass over `strained`, after which that holds the links at all particles that it has moved.
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
    // What is left grows with the square of the substep, and so do the passes.
    if (passes > 0) cloth.wanted_substep = std::min(cloth.wanted_substep, h * std::sqrt(aimed_passes / passes));
    return lost;
}

}  // namespace gphys

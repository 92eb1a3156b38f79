// Relaxation of links of cloth that a substep has left strained beyond the error target (local Gauss-Seidel).
//
// Chains are solved once, with the directions that links had before. So a link that rotates by a third of a radian ends
// a twentieth too long. Links whose ends are projected out of contact planes after the chains have similar errors.
// These errors are local. Passes over the few strained links, one after the other, bring them below the target for a
// fraction of the work of shorter substeps. More sweeps over whole chains do not converge where chains are folded.
//
// The passes change positions only: velocities derived from their displacements would add energy. But the speed at
// which the ends of a link increase its error is removed, as in an inelastic impact. Otherwise chains would separate
// the ends in each substep and passes bring them back, while the velocities stay at some metres per second and spread
// to the neighbours.
#include "solver/cloth/relax_links.h"
#include "solver/body.h"
#include "solver/cloth/cloth_chains.h"
#include "solver/cloth/leave_plane.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Errors that remain after this many passes are not local: 500 were seen to take a strain of 10.6 % to 9.9 %.
constexpr uint32_t most_passes = 64;
// Without a strain target, at most this many relaxations of links in a substep, relative to the number of links. So
// infeasible lengths, as between pins too far apart, do not take many times as long as the rest.
constexpr uint32_t most_work = 4;
// A strain of this many times the target after all passes is one that nothing will cure if the next substep does not
// reduce it by this factor either: animation targets or pins contradict models or each other. Failures of cloth that is
// only fast are smaller, or vanish with the length of substeps.
constexpr double hopeless = 8, cured = 0.75;
// On a mesh this many passes take about as long as the rest of the substep, so shorter substeps would be slower.
constexpr double aimed_passes = 12;
// Links strained by more than this fraction of the target are relaxed, so that their effect on others stays below it.
constexpr double relaxed_part = 0.5;
// Fraction of the inverse mass of a particle that friction holds. With all of it, the passes would move cloth down a
// slope step by step. Links between two such particles still get their lengths back.
constexpr double held_part = 0.1;
// The same of a particle under a heavy load, which passes do not move: it would be pulled into the load.
constexpr double loaded_part = 0.01;
// Relative rounding of a length in float32.
constexpr double rounding = 0x1p-23;

/// The excess length or, unless the link only pulls, the missing length (< 0), in metres; else 0.
double error_of(const ClothState& state, const KeptLinks::Link& link) {
    const double error = distance(get(&state.at[4 * size_t{link.a}]), get(&state.at[4 * size_t{link.b}])) - link.rest;
    return link.limit ? std::max(0.0, error) : error;
}

/// One relaxation: the parts of the body that it uses.
class Relaxer {
public:
    Relaxer(Body& body, bool collides, double h)
        : state_(body.cloth.state),
          contacts_(body.cloth.contacts),
          targets_(body.targets),
          batches_(body.cloth.batches),
          relaxation_(body.cloth.relaxation),
          loads_(body.cloth.loads),
          tethers_(body.plan.joined ? &body.cloth.tethers : nullptr),
          has_contact_(body.contacts.has_contact),
          collides_(collides),
          h_(h) {}

    /// Lists them in `strained`; returns the largest strain.
    double find_strained(uint32_t& count);
    /// The largest shortening of a listed link, relative to its length.
    double largest_shortening(uint32_t count) const;
    /// One pass over `strained`, which afterwards lists the links of all moved particles. Adds the work that forces
    /// have lost.
    void relax_listed(uint32_t& count, double& lost);

private:
    bool yields(const KeptLinks::Link& link) const { return link.yields || (link.brace && relaxation_.braces_yield); }
    double move(uint32_t particle, Vec3 displacement);
    void stop_straining(const KeptLinks::Link& link, Vec3 direction, double error);
    bool relax(const KeptLinks::Link& link, double& lost);

    ClothState& state_;
    ClothContacts& contacts_;
    const AnimationTargets& targets_;
    const ClothBatches& batches_;
    Relaxation& relaxation_;
    const ContactLoads& loads_;
    const TetherInertia* const tethers_;  // of joined cloth
    const bool has_contact_, collides_;
    const double h_;
};

double Relaxer::find_strained(uint32_t& count) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    const KeptLinks& kept = relaxation_.kept;
    const ClothChains chains{batches_.particles.data(), chains_of(batches_).rest, batches_.softness.data(), nullptr};
    const float part = static_cast<float>(relaxed_part * relaxation_.most_strain);
    const uint32_t kinds = relaxation_.braces_yield ? ChainBatch::threads : ChainBatch::threads | ChainBatch::braces;
    uint32_t listed = 0;
    for (const ChainBatch& batch : batches_.chains) {
        if ((batch.kept & kinds) != 0)
            listed += kernels.list_strained(state_.at.data(), chains, batch, part, &relaxation_.strained[listed]);
    }
    double largest = 0;
    count = 0;
    for (uint32_t i = 0; i < listed; ++i) {
        const uint32_t number = kept.by_place[relaxation_.strained[i]];
        if (number == KeptLinks::none) continue;
        const KeptLinks::Link& link = kept.links[number];
        if (yields(link)) continue;
        relaxation_.strained[count++] = number;
        largest = std::max(largest, std::fabs(error_of(state_, link)) / link.rest);
    }
    return largest;
}

double Relaxer::largest_shortening(uint32_t count) const {
    double largest = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const KeptLinks::Link& link = relaxation_.kept.links[relaxation_.strained[i]];
        largest = std::max(largest, -error_of(state_, link) / link.rest);
    }
    return largest;
}

/// Returns the work that forces have lost by the displacement.
double Relaxer::move(uint32_t particle, Vec3 displacement) {
    const size_t i = 4 * size_t{particle};
    const Vec3 before = get(&state_.at[i]);
    displace(state_, contacts_, targets_, particle, displacement, collides_);
    return state_.acceleration[i + 3] * dot(get(&state_.acceleration[i]), before - get(&state_.at[i]));
}

/// Removes the speed at which the ends increase the error, limited to the error per substep. Only for a body in
/// contact, because the second-order time scheme would otherwise continue the motion that has been stopped.
void Relaxer::stop_straining(const KeptLinks::Link& link, Vec3 direction, double error) {
    float *a = &state_.velocity[4 * size_t{link.a}], *b = &state_.velocity[4 * size_t{link.b}];
    const double weight_a = state_.at[4 * size_t{link.a} + 3], weight_b = state_.at[4 * size_t{link.b} + 3];
    const double rate = dot(get(b) - get(a), direction), most = std::fabs(error) / h_;
    if (rate * error <= 0) return;
    const Vec3 impulse = direction * (std::clamp(rate, -most, most) / (weight_a + weight_b));
    put(a, get(a) + impulse * weight_a);
    put(b, get(b) - impulse * weight_b);
}

/// Moves both ends, unless the link is hardly strained. Returns whether it was strained.
bool Relaxer::relax(const KeptLinks::Link& link, double& lost) {
    const float *a = &state_.at[4 * size_t{link.a}], *b = &state_.at[4 * size_t{link.b}];
    const Vec3 along = get(b) - get(a);
    const double length = gphys::length(along), error = length - link.rest;
    if (std::fabs(error) < relaxed_part * relaxation_.most_strain * link.rest) return false;
    const auto weight_of = [&](uint32_t p, const float* at) {
        if (tethers_ && !tethers_->is_unit(p)) return 0.0;  // a system of joints has placed it
        if (loads_.any() && loads_.is_loaded[p]) return loaded_part * at[3];
        return collides_ && is_held(contacts_, p) ? held_part * at[3] : double{at[3]};
    };
    const double weight_a = weight_of(link.a, a), weight_b = weight_of(link.b, b), weight = weight_a + weight_b;
    if (length == 0 || weight == 0 || (link.limit && error < 0)) return false;
    const Vec3 correction = along * (error / (length * weight));
    if (has_contact_) stop_straining(link, along / length, error);
    lost += move(link.a, correction * weight_a);
    lost += move(link.b, correction * -weight_b);
    return true;
}

void Relaxer::relax_listed(uint32_t& count, double& lost) {
    const KeptLinks& kept = relaxation_.kept;
    uint32_t waiting = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const KeptLinks::Link& link = kept.links[relaxation_.strained[i]];
        if (!relax(link, lost)) continue;
        for (const uint32_t p : {link.a, link.b}) {
            for (uint32_t k = kept.begin[p]; k < kept.begin[p + 1]; ++k) {
                const uint32_t next = kept.at[k];
                if (relaxation_.listed[next] || yields(kept.links[next])) continue;
                relaxation_.listed[next] = 1;
                relaxation_.waiting[waiting++] = next;
            }
        }
    }
    count = waiting;
    for (uint32_t i = 0; i < waiting; ++i) {
        relaxation_.strained[i] = relaxation_.waiting[i];
        relaxation_.listed[relaxation_.waiting[i]] = 0;
    }
}

}  // namespace

std::optional<double> relax_links(Body& body, bool collides, double h) {
    Relaxation& relaxation = body.cloth.relaxation;
    Relaxer relaxer(body, collides, h);
    double lost = 0;
    uint32_t passes = 0, count = 0;
    const size_t all = relaxation.kept.links.size();
    size_t work = relaxation.braces_yield || relaxation.given_up ? most_work * all : most_passes * all;
    while (passes < most_passes) {
        const double largest = relaxer.find_strained(count);
        if (count == 0 || largest <= relaxation.most_strain - rounding) break;
        if (passes == 0) lost += leave_plane(body, relaxer.largest_shortening(count), collides);
        for (; passes < most_passes && count > 0; ++passes) {
            if (work < count) return lost;
            work -= count;
            relaxer.relax_listed(count, lost);
        }
    }
    // The remaining error grows with the square of the substep, and so does the number of passes.
    if (passes == 0) return std::nullopt;
    if (passes == most_passes) {
        const double left = relaxer.find_strained(count);
        const bool fails = left > hopeless * relaxation.most_strain;
        relaxation.given_up = fails && relaxation.infeasible > 0 && left > cured * relaxation.infeasible;
        relaxation.infeasible = fails ? left : 0;
        if (relaxation.given_up) relaxation.wanted_substep = infinity;
    }
    if (relaxation.given_up) return lost;
    relaxation.wanted_substep = std::min(relaxation.wanted_substep, h * std::sqrt(aimed_passes / passes));
    return lost;
}

}  // namespace gphys
